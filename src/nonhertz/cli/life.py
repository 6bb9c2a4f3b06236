"""What ``nonhertz life`` assesses, writes and prints."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.cli import FINE, NOT_CONVERGED
from nonhertz.cli.printing import console, print_table, words
from nonhertz.cli.solve import spectrum_or_not
from nonhertz.cli.verify import Progress
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case
from nonhertz.files.held import named
from nonhertz.files.lives import Assessment
from nonhertz.files.lives import as_json as as_json_text
from nonhertz.life import MODELS
from nonhertz.result.reading import chosen
from nonhertz.show.analysis import assessed, models_for
from nonhertz.show.lives import (
    LIFE_COLUMNS,
    RATIO,
    REVOLUTIONS,
    SPECTRUM_COLUMNS,
    life_rows,
    ratio_rows,
    sentences,
    spectrum_rows,
    without_ratio,
)

WIDTH = 120  # of piped output


def check_models(names: Iterable[str]) -> None:
    """Reject unknown model names.

    Raises
    ------
    InputError
    """
    for name in names:
        if name not in MODELS:
            raise InputError("--model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")


def report_lives(cases: list[Case], names: Sequence[str], out: Path | None, as_json: bool) -> int:
    """Solve one or two cases, assess their lives, write them if requested, print them; return the exit code."""
    models, notes = models_for(cases[0], names, cases[1:])
    progress = Progress(sum(case.life.steps for case in cases))
    found: list[Assessment] = []
    try:
        for case in cases:
            with named(case.path) if found else contextlib.nullcontext():
                spectrum, complaint = spectrum_or_not(case)
                if complaint:
                    progress.wipe()
                    said = chosen()(complaint)
                    print(f"{case.path}: {said}" if found else said, file=sys.stderr)
                    return NOT_CONVERGED
                found.append(assessed(case, spectrum, models, notes, progress.announce))
    finally:
        progress.wipe()
    assessment, other = found[0], found[1] if len(found) > 1 else None
    written = _lives_written(out, assessment, other) if out is not None else ()
    if as_json:
        print(as_json_text(assessment, other))
        return FINE
    print_lives(assessment, other)
    for path in written:
        print(f"wrote {path}")
    return FINE


def _lives_written(directory: Path, found: Assessment, other: Assessment | None) -> tuple[Path, ...]:
    from nonhertz.files.folder import write_files
    from nonhertz.files.lives import files
    from nonhertz.plot import dent_figure, life_figure, save

    def draw(folder: Path) -> None:
        compared = None if other is None else other.lives
        save(life_figure(found.spectrum, found.lives, found.title, compared), folder / "life-density")
        if found.dent is not None:
            save(dent_figure(found.dent, found.judging_dents, found.title), folder / "life-dent")

    return write_files(directory, files(found, other), draw)


def print_lives(found: Assessment, other: Assessment | None) -> None:
    """Print the lives by all models, what they are relative to, those of another case, and warnings."""
    printing = console(WIDTH)
    printing.print(Text(found.title, style="bold"))
    print_table(printing, _table(LIFE_COLUMNS, life_rows(found), left=(0, 4)))
    for sentence in sentences(found):
        printing.print(words(sentence), soft_wrap=True)
    _print_spectrum(printing, found)
    _print_warnings(printing, found)
    if other is None:
        return
    printing.print()
    printing.print(Text(f"Compared with: {other.title}", style="bold"))
    head = ("", "life in a", "in b", REVOLUTIONS, "first / this, a", "first / this, b")
    print_table(printing, _table(head, ratio_rows(found, other), left=(0,)))
    for sentence in [RATIO, *without_ratio(found, other), *sentences(other)[1:]]:
        printing.print(words(sentence), soft_wrap=True)
    _print_spectrum(printing, other)
    _print_warnings(printing, other)


def _print_spectrum(printing: Console, found: Assessment) -> None:
    if len(found.spectrum) > 1:
        print_table(printing, _table(SPECTRUM_COLUMNS, spectrum_rows(found), left=()))


def _print_warnings(printing: Console, found: Assessment) -> None:
    for warning in found.warnings:
        printing.print(words(f"warning: {warning}", "yellow"), soft_wrap=True)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], *, left: Sequence[int]) -> Table:
    head, rows = chosen().columns(head, list(rows))
    # Drop columns that are blank throughout, as revolutions are without a raceway.
    columns = [position for position in range(len(head)) if any(row[position] for row in rows)]
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for position in columns:
        # As text: rich would take [MPa] for markup.
        table.add_column(Text(head[position]), justify="left" if position in left else "right", no_wrap=position < 4)
    for row in rows:
        table.add_row(*(Text(row[position]) for position in columns))
    return table
