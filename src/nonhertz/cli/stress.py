"""``nonhertz stress``: the largest stresses below the surface."""

from __future__ import annotations

import functools
import math
from pathlib import Path

from nonhertz import InputError, read_case
from nonhertz.amounts import mm
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, refuse_unwritable_out, write_outputs
from nonhertz.cli.printing import Progress
from nonhertz.files.results import key_by_key
from nonhertz.files.stresses import all_findings, as_object, files
from nonhertz.model.body import BODIES
from nonhertz.model.profile.base import at_ends
from nonhertz.plot import stress_figures, stress_planes
from nonhertz.show.analysis import largest_stresses
from nonhertz.show.sections import assumed_section
from nonhertz.show.solving import solve_case
from nonhertz.show.stresses import sections
from nonhertz.strength import assess
from nonhertz.verdict import judge_contact

_SEARCHES = 2  # for the largest stresses: in the whole body and in a cross-section
_STATION_REMEDY = "choose a position in the body, or leave it out for the cross-section of the largest von Mises stress"


def stress(
    case: Path,
    /,
    *,
    changes: Changes = NONE,
    station: float | None = None,
    body: str = "a",
    out: Path | None = None,
) -> Answer:
    """Find the largest stresses of a case below the surface.

    Prints size and position of the largest von Mises, maximum shear and orthogonal shear stress, in the whole body and
    in one cross-section.

    Parameters
    ----------
    case : Path
        The case file.
    station : float
        Position of the cross-section along the contact [mm]; by default where the von Mises stress is largest.
    body : str
        The body to examine, a or b. Both are under the same pressure.
    out : Path
        Directory for stress.json, tables and figures of two planes; created if it does not exist.
    """
    if body not in BODIES:
        raise InputError("--body", body, "be one of the two bodies", "write a or b")
    if station is not None and not math.isfinite(station):
        raise InputError("--station", station, "be finite", "give a position along the contact in mm")
    name = BODIES[BODIES.index(body)]
    read = read_case(case, changes)
    refuse_unwritable_out(out)
    solution = solve_case(read)
    low, high = getattr(solution.contact, name).faces
    if station is not None and not low <= float(at_ends(station, (low, high))) <= high:
        condition = f"lie between the side faces of body {name}, {mm(low, high, between=' and '):.6g}"
        raise InputError("--station", station, condition, _STATION_REMEDY)
    with Progress(_SEARCHES + (out is not None)) as progress:
        extremes = largest_stresses(solution, station, name, progress.announce)
        strength = assess(solution, body=name, largest=extremes[0])
        text = key_by_key(as_object(solution, *extremes, strength, read.title))
        made: tuple[Path, ...] = ()
        if out is not None:
            progress.announce("planes and figures")
            planes = stress_planes(solution, extremes[1])
            figures = functools.partial(stress_figures, solution, *extremes, read.title, planes)
            made = write_outputs(out, lambda: files(text, planes), figures)
    shown, verdict = sections(solution, *extremes, (strength,)), judge_contact(solution, (strength,))
    shown = [*shown, assumed_section(read.assumed)]
    return Answer(read.title, shown, lambda: text, verdict, all_findings(solution, *extremes), made)
