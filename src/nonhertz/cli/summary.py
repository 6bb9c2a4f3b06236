"""The summary that ``nonhertz solve`` prints."""

from __future__ import annotations

from rich.table import Table
from rich.text import Text

from nonhertz.cli.printing import console, print_table
from nonhertz.result.solution import Solution
from nonhertz.show.summary import summary_rows


def print_summary(solution: Solution, title: str) -> None:
    """Print the result of a solve, with its error estimates."""
    printing = console(None)
    printing.print(Text(title, style="bold"))
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    for row in summary_rows(solution):
        table.add_row(*(Text(cell) for cell in row))
    print_table(printing, table)
    for warning in solution.warnings:
        printing.print(Text(f"warning: {warning}", style="yellow"), soft_wrap=True)
