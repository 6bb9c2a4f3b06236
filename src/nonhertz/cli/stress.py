"""What ``nonhertz stress`` evaluates, writes and prints."""

from __future__ import annotations

import math
from pathlib import Path

from nonhertz.amounts import mm
from nonhertz.cli.printing import print_result
from nonhertz.cli.verify import Progress
from nonhertz.errors import InputError
from nonhertz.files.stresses import all_findings
from nonhertz.model.body import BODIES, BodyName
from nonhertz.result.solution import Solution
from nonhertz.show.analysis import largest_stresses
from nonhertz.show.stresses import sections
from nonhertz.strength import assess
from nonhertz.subsurface import Extremes
from nonhertz.verdict import of_contact

_SEARCHES = 2  # for the largest stresses: in the whole body and in a cross-section
_STATION_REMEDY = "choose a position in the body, or leave it out for the cross-section of the largest von Mises stress"


def checked_body(station: float | None, body: str) -> BodyName:
    """Return the body; reject arguments that can be checked before solving.

    Raises
    ------
    InputError
    """
    if body not in BODIES:
        raise InputError("--body", body, "be one of the two bodies", "write a or b")
    if station is not None and not math.isfinite(station):
        raise InputError("--station", station, "be finite", "give a position along the contact in mm")
    return BODIES[BODIES.index(body)]


def searched(
    solution: Solution, station: float | None, body: BodyName, progress: Progress
) -> tuple[Extremes, Extremes]:
    """Return the largest stresses in a body and in a cross-section of it.

    Raises
    ------
    InputError
        If the cross-section does not lie in the body.
    """
    if station is not None:
        _check_station(solution, station, body)
    return largest_stresses(solution, station, body, progress.announce)


def report_stresses(
    solution: Solution, title: str, station: float | None, body: BodyName, out: Path | None, as_json: bool
) -> None:
    """Find the largest stresses, write them if requested, and print them."""
    from nonhertz.files.stresses import as_json as json_text

    progress = Progress(_SEARCHES if out is None else _SEARCHES + 1)
    try:
        overall, section = searched(solution, station, body, progress)
        strength = assess(solution, body=body, largest=overall)
        text = json_text(solution, overall, section, strength, title)
        written: tuple[Path, ...] = ()
        if out is not None:
            progress.announce("planes and figures")
            written = _stresses_written(out, solution, (overall, section), text, title)
    finally:
        progress.wipe()
    if as_json:
        print(text)
        return
    print_result(
        title,
        sections(solution, overall, section, (strength,)),
        verdict=of_contact(solution, (strength,)),
        warnings=all_findings(solution, overall, section),
        written=written,
    )


def _stresses_written(
    directory: Path, solution: Solution, found: tuple[Extremes, Extremes], text: str, title: str
) -> tuple[Path, ...]:
    from nonhertz.files.folder import write_files
    from nonhertz.files.stresses import files
    from nonhertz.plot import save, stress_figures, stress_planes

    planes = stress_planes(solution, found[1])

    def draw(folder: Path) -> None:
        for name, figure in stress_figures(solution, *found, title, planes).items():
            save(figure, folder / name)

    return write_files(directory, files(text, planes), draw)


def _check_station(solution: Solution, station: float, body: BodyName) -> None:
    low, high = (solution.contact.a if body == "a" else solution.contact.b).faces
    if not low <= station <= high:
        condition = f"lie between the side faces of body {body}, {mm(low, high, between=' and '):.6g}"
        raise InputError("--station", station, condition, _STATION_REMEDY)
