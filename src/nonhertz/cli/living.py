"""What ``nonhertz life`` prints for people."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.errors import InputError
from nonhertz.io.lives import Assessment
from nonhertz.life import MODELS
from nonhertz.tables.lives import RATIO, REVOLUTIONS, life_rows, ratio_rows, sentences, spectrum_rows, without_ratio

WIDTH = 120  # of what is piped


def check_models(names: Iterable[str]) -> None:
    """Refuse names that no model has.

    Raises
    ------
    InputError
    """
    for name in names:
        if name not in MODELS:
            raise InputError("--model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")


def print_lives(found: Assessment, other: Assessment | None) -> None:
    """Print the lives by all models, what they are relative to, those of another case, and warnings."""
    console = Console(highlight=False, width=None if sys.stdout.isatty() else WIDTH)
    console.print(Text(found.title, style="bold"))
    console.print(_table(("", "life in a", "in b", REVOLUTIONS, "damage"), life_rows(found), left=(0, 4)))
    for sentence in sentences(found):
        console.print(Text(sentence), soft_wrap=True)
    _print_spectrum(console, found)
    _print_warnings(console, found)
    if other is None:
        return
    console.print()
    console.print(Text(f"Compared with: {other.title}", style="bold"))
    head = ("", "life in a", "in b", REVOLUTIONS, "first / this, a", "first / this, b")
    console.print(_table(head, ratio_rows(found, other), left=(0,)))
    for sentence in [RATIO, *without_ratio(found, other), *sentences(other)[1:]]:
        console.print(Text(sentence), soft_wrap=True)
    _print_spectrum(console, other)
    _print_warnings(console, other)


def _print_spectrum(console: Console, found: Assessment) -> None:
    if len(found.spectrum) > 1:
        head = ("share", "load [N]", "tilt [mrad]", "largest p0 [MPa]")
        console.print(_table(head, spectrum_rows(found), left=()))


def _print_warnings(console: Console, found: Assessment) -> None:
    for warning in found.warnings:
        console.print(Text(f"warning: {warning}", style="yellow"), soft_wrap=True)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], *, left: Sequence[int]) -> Table:
    rows = list(rows)
    # Not a column where all is blank, as revolutions are without a raceway.
    columns = [position for position in range(len(head)) if any(row[position] for row in rows)]
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for position in columns:
        # As text: rich would take [MPa] for markup.
        table.add_column(Text(head[position]), justify="left" if position in left else "right", no_wrap=position < 4)
    for row in rows:
        table.add_row(*(Text(row[position]) for position in columns))
    return table
