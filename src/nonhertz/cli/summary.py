"""The summary that ``nonhertz solve`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from nonhertz.cli.printing import console, print_table, words
from nonhertz.result.reading import chosen
from nonhertz.result.solution import Solution
from nonhertz.show.summary import OVERVIEW_COLUMNS, overview_rows, summary_rows

if TYPE_CHECKING:
    from nonhertz.files.several import Attempt

_TEXT = (0, 1, len(OVERVIEW_COLUMNS) - 1)
_TITLE = 30  # columns at least for a title, which may be broken
WIDTH = 120  # of piped output


def print_overview(attempts: Sequence[Attempt]) -> None:
    """Print a row for each case, and the warnings of all."""
    printing = console(WIDTH)
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    heads, rows = chosen().columns(OVERVIEW_COLUMNS, overview_rows(attempts))
    for column, name in enumerate(heads):
        # As text: rich would take [MPa] for markup.
        table.add_column(
            Text(name),
            justify="left" if column in _TEXT else "right",
            no_wrap=column != 1,
            min_width=_TITLE if column == 1 else None,
        )
    for each, row in zip(attempts, rows, strict=True):
        # Name and title are the user's own words.
        table.add_row(*map(Text, (each.name, each.title, *row[2:])))
    print_table(printing, table)
    for each in attempts:
        for warning in () if each.solution is None else each.solution.warnings:
            printing.print(Text(f"warning: {each.name}: {chosen()(warning)}", style="yellow"), soft_wrap=True)


def print_summary(solution: Solution, title: str) -> None:
    """Print the result of a solve, with its error estimates."""
    printing = console(None)
    printing.print(Text(title, style="bold"))
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    for row in summary_rows(solution):
        table.add_row(*map(words, row))
    print_table(printing, table)
    for warning in solution.warnings:
        printing.print(words(f"warning: {warning}", "yellow"), soft_wrap=True)
