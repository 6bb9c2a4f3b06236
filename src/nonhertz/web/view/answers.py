"""A solution as the plain numbers that the page draws."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.figures import contact
from nonhertz.figures.roller import relief_between
from nonhertz.files.casefile import Case
from nonhertz.files.reading import read_input
from nonhertz.files.results import plain
from nonhertz.files.sections import read_context
from nonhertz.model.body import Body
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.show.key_numbers import contact_numbers
from nonhertz.show.summary import summary_rows
from nonhertz.verdict import judge_contact
from nonhertz.web.view.replies import number_seen, verdict_seen

Array = NDArray[np.float64]

INNER: Final = 0.96
STEEP: Final = 6.0
ROOM: Final = 0.12
"""Of the relief of a land: the part that is drawn whole, how many times as much ends may have, and room beside."""
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
        "numbers": [*map(number_seen, contact_numbers(case, solution, complaint))],
        # All digits but those of rounding alone.
        "key": {name: plain(quantity.clean(solution)) for name, quantity in QUANTITIES.items()},
        # Where the pressure does not decide, the search when the slider rests does: it takes seconds.
        "verdict": verdict_seen(None if complaint else judge_contact(solution, search=False)),
        "summary": summary_rows(solution, case),
        "warnings": solution.warnings,
        "figures": {
            "pressure": contact.pressure(solution).to_json(),
            "footprint": contact.footprint(solution).to_json(),
            "distance": contact.distance(solution).to_json(),
        },
        "profiles": {"a": relief_of(case.contact.a), "b": relief_of(case.contact.b)},
        "bodies": {"a": _seen(case.contact.a), "b": _seen(case.contact.b)},
    }


def relief_of(body: Body) -> dict[str, Any]:
    """Return the relief of a body over the length on which it can touch, and the range of it that is drawn."""
    low, high = body.interval
    low = low if math.isfinite(low) else min(body.position, high) - FAR
    high = high if math.isfinite(high) else max(body.position, low) + FAR
    y, relief = relief_between(low, high, body.relief)
    on_land = (body.land[0] <= y) & (y <= body.land[1])
    return {"y": plain(y), "relief_um": plain(1e3 * relief), "range_um": _range_of(1e3 * relief[on_land])}


def _range_of(relief: Array) -> list[float]:
    """Return the range in which the relief of a land is drawn: corners would flatten it, and a logarithm has no end."""
    values = relief[np.isfinite(relief)]
    if not values.size:
        return [0.0, 1.0]
    low, inner, high = np.quantile(values, (0.0, INNER, 1.0)).tolist()
    top = 2.0 * inner if high > STEEP * inner > 0.0 else high
    room = ROOM * (top - low) or 1.0
    return [low - room, top + room]


def _seen(body: Body) -> dict[str, Any]:
    """Return what a sketch at scale shows of a body: its curvature in the middle, and where it ends."""
    low, high = body.interval
    middle = 0.5 * (low + high) if math.isfinite(high - low) else body.position
    return {"curvature": float(body.curvature(middle)), "interval": plain(body.interval)}


def drawable(bodies: Any) -> dict[str, Any]:
    """Return the reliefs of those bodies in a document that are valid, for a case that cannot be solved."""
    made = {}
    for name in ("a", "b"):
        try:
            made[name] = relief_of(read_input(Body, bodies.get(name), read_context({"body": bodies}, None)))
        except (AttributeError, InputError, ValueError):
            continue
    return made
