"""A solution as the plain numbers that the page draws."""

from __future__ import annotations

import math
import warnings
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError, NonhertzError
from nonhertz.files.casefile import Case
from nonhertz.files.reading import read
from nonhertz.files.results import plain
from nonhertz.files.sections import surroundings
from nonhertz.model.body import Body
from nonhertz.plot.contact_area import outlines
from nonhertz.plot.surfaces import distances, drawn_range
from nonhertz.result.brief import where_largest
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import EdgeKind, Solution
from nonhertz.show.summary import summary_rows
from nonhertz.study.quantities import LIFE_MODEL, life_of
from nonhertz.verdict import of_contact
from nonhertz.web.view.replies import numbers, verdict_seen

Array = NDArray[np.float64]

RELIEF_POINTS: Final = 161
FAR: Final = 10.0
"""mm on either side of the middle, over which the profile of an unbounded body is drawn."""


def answer(case: Case, solution: Solution, complaint: str) -> dict[str, Any]:
    """Return what the page shows of a solution, except the stress below the surface.

    Parameters
    ----------
    case : Case
        What was solved.
    solution : Solution
        Its solution, or the state in which the solver stopped.
    complaint : str
        Why it stopped there; empty if it converged.
    """
    return {
        "ok": True,
        "title": case.title,
        "status": solution.status.label,
        "complaint": complaint,
        "key": _key_numbers(solution),
        "verdict": verdict_seen(None if complaint else of_contact(solution)),
        "summary": [list(row) for row in summary_rows(solution)],
        "warnings": list(solution.warnings),
        "line": _line(solution),
        "footprint": _footprint(solution),
        "gap": _gap(solution),
        "life": None if complaint or not solution.contact_y else _life(case, solution),
        "profiles": profiles({"a": case.contact.a, "b": case.contact.b}),
        "interval": plain(case.contact.interval),
        "contact": plain(solution.contact_y),
        "singular": [
            {"y": edge.y, "exponent": edge.exponent, "strength": plain(edge.strength), "corner": not edge.law}
            for edge in solution.edge_pressure
            if edge.kind in {EdgeKind.SINGULAR, EdgeKind.CORNER}
        ],
    }


def _key_numbers(solution: Solution) -> dict[str, Any]:
    """Return the numbers by which cases are compared, all their digits but those of rounding alone."""
    found = {name: plain(quantity.clean(solution)) for name, quantity in QUANTITIES.items()}
    return found | {"largest": where_largest(solution, 3)}


def _life(case: Case, solution: Solution) -> dict[str, Any] | None:
    """Return how long the contact lasts under its load by laminae, which take half a millisecond; None if unknown.

    Of the body that has a raceway, else of body a.
    """
    try:
        life = life_of(case, solution, LIFE_MODEL)
    except NonhertzError:
        return None
    found = {"relative": life.relative, "million_revolutions": life.million_revolutions}
    # What a life adds to the warnings of its solution is that the damage has no limit towards sharp ends.
    counted = set(life.warnings) <= set(solution.warnings)
    return {name: plain(value) for name, value in found.items()} | {"body": life.body, "ends_counted": counted}


def profiles(bodies: dict[str, Body]) -> dict[str, Any]:
    """Return the relief of bodies by name, over the length on which each can touch."""
    return {name: _relief(body) for name, body in bodies.items()}


def _relief(body: Body) -> dict[str, Any]:
    low, high = body.interval
    low = low if math.isfinite(low) else min(body.position, high) - FAR
    high = high if math.isfinite(high) else max(body.position, low) + FAR
    # Denser at the ends, where profiles are steep.
    spread = np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, RELIEF_POINTS))
    y = np.clip(0.5 * (low + high) + 0.5 * (high - low) * spread, low, high)
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        relief = 1e3 * body.relief(y)
    return {"y": numbers(y), "relief_um": numbers(relief)}


def _line(solution: Solution) -> dict[str, Any]:
    """Return the lines along the contact through the strip centres, with zeros at the outer edges of the strips."""
    y = np.concatenate([solution.edges[[0, 0]], solution.y, solution.edges[[-1, -1]]])
    names = {"pressure": "centre_pressure", "half_width": "half_width", "line_load": "line_load"}
    return {"y": numbers(y)} | {name: numbers(_ended(getattr(solution, of))) for name, of in names.items()}


def _ended(values: Array) -> Array:
    return np.concatenate([[0.0, values[0]], values, [values[-1], 0.0]])


def _footprint(solution: Solution) -> dict[str, Any]:
    """Return the outline of the contact's upper half; a null separates pieces."""
    pieces = outlines(solution)
    columns: dict[str, list[float | None]] = {"y": [], "half_width": [], "pressure": []}
    for piece in pieces:
        for name, column in columns.items():
            column += [*([None] if column else []), *numbers(getattr(piece, name))]
    return columns


def _gap(solution: Solution) -> dict[str, Any]:
    before, after = distances(solution)
    drawn = np.isfinite(before).any()
    limits = drawn_range(before, after) if drawn else None
    return {"y": numbers(solution.y), "before": numbers(before), "after": numbers(after), "range": plain(limits)}


def drawable(bodies: Any) -> dict[str, Any]:
    """Return the reliefs of those bodies in a document that are valid, for a case that cannot be solved."""
    made = {}
    for name in ("a", "b"):
        try:
            made[name] = _relief(read(Body, bodies.get(name), surroundings({"body": bodies}, None)))
        except (AttributeError, InputError, ValueError):
            continue
    return made
