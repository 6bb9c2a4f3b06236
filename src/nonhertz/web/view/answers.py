"""A solution as the plain numbers that the page draws."""

from __future__ import annotations

import math
from typing import Any

from nonhertz.errors import InputError
from nonhertz.figures import contact
from nonhertz.figures.profile import body_relief
from nonhertz.files.casefile import Case
from nonhertz.files.reading import read_input
from nonhertz.files.results import plain
from nonhertz.files.sections import read_context
from nonhertz.model.body import BODIES, Body
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.show.key_numbers import contact_numbers
from nonhertz.show.summary import summary_rows
from nonhertz.verdict import judge_contact
from nonhertz.web.view.replies import number_seen, verdict_seen


def answer(case: Case, solution: Solution, complaint: str) -> dict[str, Any]:
    """Return the contents of the page for a solution, except the stress below the surface.

    Parameters
    ----------
    case : Case
        The solved case.
    solution : Solution
        Its solution, or the state in which the solver stopped.
    complaint : str
        Why the solver stopped; empty if it converged.
    """
    return {
        "ok": True,
        "title": case.title,
        "status": solution.status.label,
        "complaint": complaint,
        "numbers": [*map(number_seen, contact_numbers(case, solution, complaint))],
        # All digits except those of rounding.
        "key": {name: plain(quantity.clean(solution)) for name, quantity in QUANTITIES.items()},
        # If the pressure leaves the verdict open, the search when the slider rests decides it: that takes seconds.
        "verdict": verdict_seen(None if complaint else judge_contact(solution, search=False)),
        "summary": summary_rows(solution, case),
        "warnings": [*dict.fromkeys((*case.notes, *solution.warnings))],
        "figures": {
            "pressure": contact.pressure(solution).to_json(),
            "footprint": contact.footprint(solution).to_json(),
            "distance": contact.distance(solution).to_json(),
        },
        "profiles": {name: body_relief(body, name).to_json() for name, body in case.contact.bodies.items()},
        "bodies": {"a": _seen(case.contact.a), "b": _seen(case.contact.b)},
    }


def _seen(body: Body) -> dict[str, Any]:
    """Return the data of a body for a sketch at scale: its curvature in the middle, and its ends."""
    low, high = body.interval
    middle = 0.5 * (low + high) if math.isfinite(high - low) else body.position
    return {"curvature": float(body.curvature(middle)), "interval": plain(body.interval)}


def drawable(bodies: Any) -> dict[str, Any]:
    """Return the profiles of the valid bodies in a document, for a case that cannot be solved."""
    profiles: dict[str, Any] = {}
    for name in BODIES:
        try:
            body = read_input(Body, bodies.get(name), read_context({"body": bodies}, None))
            profiles[name] = body_relief(body, name).to_json()
        except (AttributeError, InputError, ValueError):
            continue
    return profiles
