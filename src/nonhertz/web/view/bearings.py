"""A loaded bearing as the plain numbers that its page draws."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.bearing import pressure_maps
from nonhertz.figures.film import film_figures
from nonhertz.figures.loads import roller_loads
from nonhertz.figures.perspective import pressure_ridges
from nonhertz.figures.profile import body_relief
from nonhertz.figures.roller import roller_lines
from nonhertz.files.bearing_document import PARTS
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.results import plain
from nonhertz.findings import sentences
from nonhertz.show.bearing import most_loaded, sections
from nonhertz.show.clearances import TOLERANCES
from nonhertz.show.key_numbers import bearing_numbers
from nonhertz.show.sections import Table, rows_of_summaries
from nonhertz.verdict import collect_findings
from nonhertz.web.view.replies import number_seen, verdict_seen

Array = NDArray[np.float64]

MAP_POINTS = 41
"""Number of places along a roller in the maps of the page."""


def bearing_answer(case: BearingCase, solution: BearingSolution, roller: int | None = None) -> dict[str, Any]:
    """Return the contents of the page for a loaded bearing.

    Parameters
    ----------
    case : BearingCase
        The solved bearing.
    solution : BearingSolution
        Its solution by slices or by strips; only strips have pressures.
    roller : int, optional
        The roller whose lines are drawn; the most loaded one if there is no such roller.

    Raises
    ------
    CaseError
        If an input of the life in the case is refused.
    """
    life, reason = case.rated(solution)
    *shown, (_, (rollers,)) = sections(case, solution, life, reason)
    assert isinstance(rollers, Table)
    tolerances = next((table for title, (table, *_) in shown if title == TOLERANCES), None)
    assert tolerances is None or isinstance(tolerances, Table)
    films = case.films(solution)
    bearing = solution.bearing.rows[0].bearing
    return {
        "ok": True,
        "title": case.title,
        "method": solution.method,
        "numbers": [*map(number_seen, bearing_numbers(case, solution, life))],
        "rows": _rows(solution),
        "profiles": {part: body_relief(getattr(bearing, part), part).to_json() for part in PARTS},
        "angle": plain(solution.angle),
        "load": plain(solution.load),
        "force": plain(solution.force),
        "most": most_loaded(solution),
        "loads": roller_loads(solution).to_json(),
        **_maps(solution),
        "films": {} if films is None else {name: figure.to_json() for name, figure in film_figures(films).items()},
        "verdict": verdict_seen(case.verdict(solution, life)),
        "summary": rows_of_summaries(shown),
        "tolerances": tolerances and {"columns": tolerances.heads, "rows": tolerances.rows},
        "columns": rollers.heads,
        "rollers": rollers.rows,
        "warnings": [*case.notes, *sentences(collect_findings(solution, life, case.operating_clearance))],
    } | roller_answer(case, solution, roller)


def roller_answer(case: BearingCase, solution: BearingSolution, roller: int | None) -> dict[str, Any]:
    """Return the lines of a roller; of the most loaded one if there is no such roller."""
    shown = roller if roller is not None and 0 <= roller < solution.angle.size else most_loaded(solution)
    return {"shown": shown, "lines": roller_lines(solution, shown, case.solver.laminae).to_json()}


def _rows(solution: BearingSolution) -> list[dict[str, Any]]:
    """Return first roller and number of rollers of every row."""
    rows = [row.rollers for row in solution.bearing.rows]
    return [{"first": these.start, "count": these.stop - these.start} for these in rows]


def _maps(solution: BearingSolution) -> dict[str, Any]:
    """Return the pressures of all rollers, as maps and in perspective; none by slices, or without load."""
    if solution.method == "slices" or not solution.load.any():
        return {"maps": None}
    return {"maps": pressure_maps(solution, MAP_POINTS).to_json(), "ridges": pressure_ridges(solution).to_json()}


def why_not_drawn(name: str, solution: BearingSolution) -> str:
    """Return why a bearing has no figure of this name."""
    if not math.isfinite(float(solution.load.max())) or not solution.load.any():
        return "This picture needs a loaded roller: load the bearing."
    if name == "displacement":
        return "This picture needs a force on the inner ring: give load.radial or load.axial."
    if name.startswith("film"):
        return "This picture needs an oil and a speed: give lubrication.oil with its temperature, and load.speed."
    return "This picture needs pressures, which slices do not have: solve by strips."
