"""What one value of a case does to its results: the points of a curve, a few at a time."""

from __future__ import annotations

import math
import time
from typing import Any, Final

from nonhertz.amounts import read_in
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case
from nonhertz.files.paths import Parameter, parameter, parameters
from nonhertz.result.quantities import Quantity
from nonhertz.show.analysis import attempted
from nonhertz.study.quantities import SolvedContact, chosen, number_of
from nonhertz.web.limits import CURVE_SECONDS
from nonhertz.web.view.jobs import sound
from nonhertz.web.view.replies import job

_NAMES: Final = ("max_pressure", "approach", "load", "moment", "tilt", "max_half_width", "contact_length")
_LIFE: Final = "life"


@job
def curve(document: dict[str, Any], path: str, values: list[float]) -> dict[str, Any]:
    """Answer with points of a curve: as many as there is time for, at least one; others are to be asked for again.

    Parameters
    ----------
    document : dict
        The case.
    path : str
        Which of its values is varied, such as ``"body.a.profile[1].drop"``.
    values : list of float
        The values, in their base unit.
    """
    begun = time.perf_counter()
    sound(document, Case)
    varied = parameter(path, parameters(document, Case.contents))
    quantities = _quantities(document)
    points: list[dict[str, Any]] = []
    for value in values:
        points.append(_point(document, varied, value, quantities))
        if time.perf_counter() - begun > CURVE_SECONDS:
            break
    named = [{"name": each.name, "label": each.label} | _as_read(each) for each in quantities]
    return {"ok": True, "quantities": named, "points": points}


@read_in("si")
def _as_read(quantity: Quantity) -> dict[str, Any]:
    factor, unit = quantity.amount().scale
    return {"unit": unit, "factor": factor}


def _quantities(document: dict[str, Any]) -> tuple[Quantity, ...]:
    life = document.get("life")
    # Under a spectrum every point would be a dozen solutions.
    with_life = isinstance(life, dict) and "spectrum" not in life
    return chosen((*_NAMES, _LIFE) if with_life else _NAMES, bearing=False)


def _point(
    document: dict[str, Any], varied: Parameter, value: float, quantities: tuple[Quantity, ...]
) -> dict[str, Any]:
    """Return the numbers at one value, in their shown units, or a sentence why there are none."""
    try:
        case = sound(varied.put(document, value), Case)
        solution, complaint = attempted(case)
    except CaseError as error:
        return {"value": value, "sentence": error.mistakes[0]}
    if complaint:
        return {"value": value, "sentence": complaint}
    solved = SolvedContact(case, solution)
    numbers = [_as_read(quantity)["factor"] * number_of(quantity, solved) for quantity in quantities]
    return {"value": value, "numbers": [each if math.isfinite(each) else None for each in numbers]}
