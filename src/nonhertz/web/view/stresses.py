"""Stress below the surface on grids just fine enough to draw while a slider moves."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.figures.stress import across_contact, along_contact
from nonhertz.model.body import BodyName
from nonhertz.result.solution import Solution
from nonhertz.show.key_numbers import stress_number
from nonhertz.strength import assess
from nonhertz.subsurface import Extreme, Field, axial_plane, cross_section
from nonhertz.subsurface.evaluation import DEEPEST, WIDEST, across_at, axial_range
from nonhertz.subsurface.inside import Inside
from nonhertz.verdict import judge_contact
from nonhertz.web.view.replies import number_seen, verdict_seen

Array = NDArray[np.float64]

# Levels are denser near the surface, where the stress changes most.
ALONG: Final = 41
ACROSS: Final = 15
LEVELS: Final = 15
CLOSE: Final = 5
CROWDING: Final = 1.5

MOST_WORK: Final = 5000
"""Limit on strips times pressure terms (the pressure and its images); each takes 0.1 ms on the grids above."""

_NO_NUMBERS = "The stress below the surface cannot be shown: the load is too large or too small for its numbers."
_TOO_MUCH = (
    "With so many strips and images, the stress below the surface takes longer than the page waits: use fewer, or run "
    "'nonhertz stress'."
)


def stress_answer(solution: Solution, body: BodyName) -> dict[str, Any]:
    """Return the von Mises stress along the contact, and across it at the maximum pressure, or why there is none.

    Parameters
    ----------
    solution : Solution
        A solved contact with something in contact.
    body : {"a", "b"}
        The body.
    """
    work = solution.strips * Inside.of(solution, body).terms.shape[0]
    if work > MOST_WORK:
        return {"stress_note": _TOO_MUCH}
    try:
        with ThreadPoolExecutor(1) as beside:
            axial = beside.submit(_axial, solution, body)
            section, largest = _section(solution, solution.max_pressure_y, body)
            shown = number_seen(stress_number(body, largest, searched=False))
            return {"planes": _planes(solution, axial.result(), section, largest), "stress": shown}
    except (InputError, ArithmeticError):
        return {"stress_note": _NO_NUMBERS}


def strength_answer(solution: Solution, body: BodyName) -> dict[str, Any]:
    """Return whether a body withstands its stress, in the sentences of `nonhertz.strength`, and its largest stress.

    The answer includes the verdict on the contact, which this search may decide where the pressure leaves it open, and
    the plane across the contact through the largest von Mises stress, if that can be computed. Unlike the planes above,
    this searches the whole body, which takes seconds.

    Parameters
    ----------
    solution : Solution
        A solved contact with something in contact.
    body : {"a", "b"}
        The body.
    """
    try:
        strength = assess(solution, body=body)
        worst = strength.largest.von_mises
        planes = _planes(solution, _axial(solution, body), _section(solution, worst.y, body)[0], worst)
    except (InputError, ArithmeticError):
        return {"checks": []}
    if not np.isfinite(worst.max):
        return {"checks": []}
    checks = [{"verdict": check.verdict, "sentence": check.sentence} for check in strength.checks]
    shown = number_seen(stress_number(body, worst, searched=True))
    verdict = verdict_seen(judge_contact(solution, (strength,)))
    return {"checks": checks, "stress": shown, "planes": planes, "verdict": verdict}


def _planes(solution: Solution, axial: Field, section: Field, largest: Extreme) -> dict[str, Any]:
    """Return the figures of both planes, with the largest von Mises stress marked."""
    marked = {"von_mises": largest}
    figures = {"axial": along_contact(solution, axial, marked), "section": across_contact(solution, section, marked)}
    return {name: figure.to_json() for name, figure in figures.items()}


def _axial(solution: Solution, body: BodyName) -> Field:
    along = axial_range(solution, body)
    y = np.linspace(along[0], along[-1], ALONG)
    return _with_numbers(axial_plane(solution, y, _levels(solution.max_half_width), body=body, threads=1))


def _section(solution: Solution, station: float, body: BodyName) -> tuple[Field, Extreme]:
    """Return the plane across the contact, and the largest von Mises stress in it."""
    half_width = float(across_at(solution, np.array([station]))[1][0])
    x = WIDEST * half_width * np.linspace(0.0, 1.0, ACROSS)
    field = _with_numbers(cross_section(solution, station, x, _levels(half_width), body=body, threads=1))
    return _mirror(field), _largest(solution, field, body)


def _mirror(field: Field) -> Field:
    """Return a cross-section from its half: the stress field of the strips is symmetric about x = 0."""
    signs = np.array([1.0, 1.0, 1.0, 1.0, -1.0, -1.0])  # of tau_xz and tau_xy
    x, y, z, stress = (
        np.concatenate([other[:0:-1], half])
        for other, half in ((-field.x, field.x), (field.y,) * 2, (field.z,) * 2, (signs * field.stress, field.stress))
    )
    return replace(field, x=x, y=y, z=z, stress=stress)


def _with_numbers(field: Field) -> Field:
    """Return a field whose stresses are finite wherever there is material, or raise ArithmeticError."""
    if not (field.warnings or np.isfinite(field.von_mises).all()):
        raise ArithmeticError("stresses overflow")
    return field


def _levels(half_width: float) -> Array:
    return DEEPEST * half_width * np.linspace(0.0, 1.0, LEVELS) ** CROWDING


def _largest(solution: Solution, field: Field, body: BodyName) -> Extreme:
    """Return the largest von Mises stress of a cross-section: that on its grid, refined locally."""
    x, z, station = field.x[:, 0], field.z[0], float(field.y[0, 0])
    coarse = field.von_mises
    row, column = np.unravel_index(int(np.nanargmax(coarse)), coarse.shape)
    near_x, near_z = _close_to(x, int(row)), _close_to(z, int(column))
    close = _with_numbers(cross_section(solution, station, near_x, near_z, body=body, threads=1))
    fine = close.von_mises
    at = np.unravel_index(int(np.nanargmax(fine)), fine.shape)
    return Extreme(float(fine[at]), float(close.x[at]), station, float(close.z[at]))


def _close_to(places: Array, at: int) -> Array:
    """Return positions between the two neighbours of a grid position."""
    low, high = places[max(at - 1, 0)], places[min(at + 1, places.size - 1)]
    return np.linspace(low, high, CLOSE)
