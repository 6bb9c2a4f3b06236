"""The summary that ``nonhertz solve`` prints."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from nonhertz.cli.printing import Printed, print_result
from nonhertz.result.solution import Solution
from nonhertz.show.summary import overview_table, sections
from nonhertz.verdict import of_contact

if TYPE_CHECKING:
    from nonhertz.files.several import Attempt

WIDTH = 120  # of piped output
_TITLE = 30  # columns at least for a title, which may be broken


def print_overview(attempts: Sequence[Attempt]) -> None:
    """Print a row for each case, and the warnings of all."""
    printing = Printed(piped=WIDTH)
    printing.table(overview_table(attempts), room=_TITLE)
    for each in attempts:
        if each.solution is not None:
            printing.warn(*(f"{each.name}: {warning}" for warning in each.solution.warnings))


def print_summary(solution: Solution, title: str, written: Iterable[Path] = ()) -> None:
    """Print the result of a solve, with its error estimates."""
    print_result(
        title, sections(solution), verdict=of_contact(solution), warnings=solution.warnings, written=written, piped=None
    )
