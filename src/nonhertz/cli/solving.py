"""Solving a case for a command: whoever waits is told why, and what comes of it is written."""

from __future__ import annotations

import contextlib
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from nonhertz.errors import ConvergenceError

if TYPE_CHECKING:
    from nonhertz.casework import Spectrum
    from nonhertz.io.casefile import Case
    from nonhertz.solution import Solution

_SILENCE = 2.0  # s, before whoever waits is told why


@contextlib.contextmanager
def patience() -> Iterator[None]:
    """Tell whoever waits at a terminal why: the first solve on a machine compiles the solver."""
    text = "The first solve on a machine compiles the solver, which takes about half a minute."
    notice = threading.Timer(_SILENCE, print, [text], {"file": sys.stderr, "flush": True})
    notice.daemon = True
    if sys.stderr.isatty():
        notice.start()
    try:
        yield
    finally:
        notice.cancel()


def solved_or_not(case: Case) -> tuple[Solution, str]:
    """Return the solution and, if it has not converged, what to say about that."""
    from nonhertz.casework import attempted  # noqa: PLC0415

    with patience():
        return attempted(case)


def spectrum_or_not(case: Case) -> tuple[Spectrum, str]:
    """Return the solutions of all loads with their shares, or what to say about why there are none."""
    from nonhertz.casework import spectrum_solved  # noqa: PLC0415

    with patience():
        try:
            return spectrum_solved(case), ""
        except ConvergenceError as error:
            return (), str(error)


def results_written(directory: Path, solution: Solution, title: str) -> tuple[Path, ...]:
    """Write a solution with its figures, and return the files."""
    from nonhertz.io.results import write_results  # noqa: PLC0415
    from nonhertz.plot import figures, save  # noqa: PLC0415

    def draw(folder: Path) -> None:
        for name, figure in figures(solution, title).items():
            save(figure, folder / name)

    return write_results(directory, solution, title, draw)
