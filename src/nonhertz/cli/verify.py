"""What ``nonhertz verify`` prints."""

from __future__ import annotations

import sys

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.cli.printing import print_table
from nonhertz.verify.claim import Section
from nonhertz.verify.page import COLUMNS, row

_WIDTHS = {"claim": 3, "source": 2}  # shares of the width that the numbers leave
_COLOURS = {"pass": "green", "FAIL": "bold red", "shown": "cyan"}


def print_section(section: Section) -> None:
    """Print a section's checks as a table."""
    printing = Console(highlight=False, width=None if sys.stdout.isatty() else 100)
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="dim", expand=True)
    for column in COLUMNS:
        if column in _WIDTHS:
            table.add_column(column, ratio=_WIDTHS[column], overflow="fold")
        else:
            table.add_column(column, justify="left" if column == "verdict" else "right", no_wrap=True)
    for check in section.checks:
        *cells, verdict = row(check)
        table.add_row(*map(Text, cells), Text(verdict, style=_COLOURS[verdict]))
    printing.print(Text.assemble((section.title, "bold"), (f"  ({section.name})", "dim")))
    print_table(printing, table)
    printing.print()


class Progress:
    """A progress line on a terminal, wiped before anything else is printed.

    Parameters
    ----------
    steps : int or None
        Total number of steps; None if that is not known.
    """

    def __init__(self, steps: int | None) -> None:
        self._steps = steps
        self._done = 0
        self._line = ""

    def announce(self, name: str) -> None:
        """Say which step is next."""
        self._done += 1
        self._write(f"{self._done if self._steps is None else f'{self._done}/{self._steps}'} {name} ...")

    def wipe(self) -> None:
        """Leave an empty line."""
        self._write("")

    def _write(self, line: str) -> None:
        if sys.stderr.isatty():
            print(f"\r{' ' * len(self._line)}\r{line}", end="", file=sys.stderr, flush=True)
        self._line = line
