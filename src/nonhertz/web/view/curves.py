"""Results of a case against one of its values: the points of a curve, a few at a time."""

from __future__ import annotations

import time
from typing import Any, Final

from nonhertz.amounts import display_units
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case
from nonhertz.files.paths import find_parameter, list_parameters
from nonhertz.files.results import plain
from nonhertz.show.solving import try_solve
from nonhertz.study.quantities import SolvedContact, choose_quantities, number_of
from nonhertz.web.limits import CURVE_SECONDS
from nonhertz.web.view.jobs import sound
from nonhertz.web.view.replies import job

_NAMES: Final = ("max_pressure", "approach", "load", "moment", "tilt", "max_half_width", "contact_length")


@job
def curve(document: dict[str, Any], path: str, values: list[float]) -> dict[str, Any]:
    """Answer with points of a curve: as many as there is time for, at least one; the page asks again for others.

    Parameters
    ----------
    document : dict
        The case.
    path : str
        Path of the value that is varied, such as ``"body.a.profile[1].drop"``.
    values : list of float
        The values, in their base unit.
    """
    begun = time.perf_counter()
    sound(document, Case)
    varied = find_parameter(path, list_parameters(document, Case.contents))
    life = document.get("life")
    # A spectrum would multiply the solutions of every point.
    with_life = isinstance(life, dict) and "spectrum" not in life
    quantities = choose_quantities((*_NAMES, "life") if with_life else _NAMES, bearing=False)
    with display_units("si"):
        scales = [quantity.amount().scale for quantity in quantities]
    points: list[dict[str, Any]] = []
    for value in values:
        try:
            case = sound(varied.put(document, value), Case)
            solution, complaint = try_solve(case)
        except CaseError as error:
            complaint = error.mistakes[0]
        if complaint:
            points.append({"value": value, "sentence": complaint})
        else:
            solved = SolvedContact(case, solution)
            numbers = [factor * number_of(one, solved) for one, (factor, _) in zip(quantities, scales, strict=True)]
            points.append({"value": value, "numbers": plain(numbers)})
        if time.perf_counter() - begun > CURVE_SECONDS:
            break
    named = [
        {"name": quantity.name, "label": quantity.label, "unit": unit, "factor": factor}
        for quantity, (factor, unit) in zip(quantities, scales, strict=True)
    ]
    return {"ok": True, "quantities": named, "points": points}
