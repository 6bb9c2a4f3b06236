"""Printing for people."""

from __future__ import annotations

import re
import sys

from rich.console import Console
from rich.measure import Measurement
from rich.table import Table
from rich.text import Text

from nonhertz.result.reading import chosen

# Between a number and its unit, and within a unit; as a letter, since rich breaks lines at any blank.
_TOGETHER, _GLUE = (
    re.compile(r"(?<=\d) (?=[^\W\d])|(?<=MPa|ksi|psi) (?=mm|in)|(?<=\bN) (?=m)|(?<=\bK) (?==)|(?<=K =) "),
    "\ue000",
)


def console(piped: int | None = 100) -> Console:
    """Return a console on standard output: as wide as the terminal, or ``piped`` columns where there is none.

    With None, COLUMNS sets the piped width, or else it is 80.
    """
    return Console(highlight=False, width=None if sys.stdout.isatty() else piped)


def words(text: str, style: str = "") -> Text:
    """Return text of the program in the chosen units; as text, since rich would take [MPa] for markup."""
    return Text(chosen()(text), style)


def print_table(printing: Console, table: Table) -> None:
    """Print a table, wider than the terminal if need be: a truncated number looks like a different one.

    No line breaks between a number and its unit, and none ends in blanks.
    """
    for column in table.columns:
        column.overflow = "fold"
        for cell in column.cells:
            if isinstance(cell, Text):
                cell.plain = _TOGETHER.sub(_GLUE, cell.plain)
    whole = Console(highlight=False, width=max(printing.width, _least_width(printing, table)))
    with whole.capture() as captured:
        whole.print(table)
    print(*(line.rstrip() for line in captured.get().replace(_GLUE, " ").splitlines()), sep="\n")


def _least_width(printing: Console, table: Table) -> int:
    """Return the width at which no cell is truncated and no word is broken."""
    options = printing.options.update(width=sys.maxsize)
    _, right, _, left = table.padding
    return sum(
        right
        + left
        + max(
            column.min_width or 0,
            *(_least(Measurement.get(printing, options, cell), column.no_wrap) for cell in cells),
        )
        for column in table.columns
        if (cells := [column.header, *column.cells])
    )


def _least(cell: Measurement, whole: bool) -> int:
    return cell.maximum if whole else cell.minimum
