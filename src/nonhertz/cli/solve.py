"""Solving a case for a command, and writing the results."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from nonhertz.errors import ConvergenceError

if TYPE_CHECKING:
    from nonhertz.io.casefile import Case
    from nonhertz.result.solution import Solution
    from nonhertz.show.analysis import Spectrum


def solved_or_not(case: Case) -> tuple[Solution, str]:
    """Return the solution and, if it has not converged, a message about that."""
    from nonhertz.show.analysis import attempted

    return attempted(case)


def spectrum_or_not(case: Case) -> tuple[Spectrum, str]:
    """Return the solutions for all loads with their shares, or a message why there are none."""
    from nonhertz.show.analysis import spectrum_solved

    try:
        return spectrum_solved(case), ""
    except ConvergenceError as error:
        return (), str(error)


def results_written(directory: Path, solution: Solution, case: Case) -> tuple[Path, ...]:
    """Write a solution with its figures, and return the files."""
    from nonhertz.io.folder import write_files
    from nonhertz.io.results import files
    from nonhertz.plot import figures, save

    def draw(folder: Path) -> None:
        for name, figure in figures(solution, case.title).items():
            save(figure, folder / name)

    return write_files(directory, files(solution, case), draw)
