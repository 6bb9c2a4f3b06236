"""The pressure at the ends of a contact: a number where there is one, exponent and strength where there is none.

Where a contact runs out inside the bodies its pressure falls to zero. Where it reaches the end of a body the surface
stops short, and at distances s small against the half-width the equations of the strips become those of a plane
wedge, with p ~ K / s^alpha and cos(pi alpha) = kappa (`nonhertz.finite`). Only for kappa = 1, as where both
bodies end together with mirrored faces, is that a finite pressure. For less every refinement raises the pressure of
the last strip, so it says nothing; K and alpha do.

K is read off the strips within half a half-width of the end. There the pressure is K s^-alpha (1 + c s^(2 alpha)
+ ...): s^alpha also solves the equations of the wedge. The last two strips are left out, because collocation
between them and the end is off by more than a tenth however narrow they are.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.model.contact import Contact
from nonhertz.result.solution import EdgeKind, EdgePressure
from nonhertz.strip.grid import reaches
from nonhertz.strip.state import Problem, State

Array = NDArray[np.float64]

SHARP_END_ERROR = 0.12
# kappa; alpha is below 0.015 there, less than 10 % of pressure in three decades of distance.
FINITE_FROM = 0.999
FIT_REACH, BIASED_STRIPS, FEWEST_POINTS = 0.5, 2, 4  # the first in half-widths
LEAST_EXPONENT = 0.1
AT_ONE_PLACE = 0.01  # of the last strip


def edge_pressures(contact: Contact, problem: Problem, state: State) -> tuple[EdgePressure, EdgePressure]:
    """Return the pressure at the low and at the high end of a solved contact."""
    return _edge_pressure(contact, problem, state, -1), _edge_pressure(contact, problem, state, 1)


def sharp_end_error(edges: tuple[EdgePressure, ...], length: float) -> float:
    """Return the relative error that strips leave at the ends of a contact, in proportion to the last one's width.

    Measured on straight rollers: a tenth of both widths over the length, on equal and graded grids alike; 0.4 of
    that at kappa = 1/4, 0.2 at 1/2, 0.06 at 3/4 and none at 1.
    """
    left = (edge.strip_width * math.pow(1.0 - edge.image_weight, 1.5) for edge in edges if not edge.converges)
    return SHARP_END_ERROR * sum(left) / length


def _image_weight_within(problem: Problem, state: State, side: int, reach: float) -> float:
    """Return kappa of all free faces within a distance of the end."""
    place = float(state.edges[-1 if side > 0 else 0])
    found = (end.image_weight for end in problem.influence.ends if end.side == side and abs(end.y - place) <= reach)
    return min(sum(found), 1.0)


def _edge_pressure(contact: Contact, problem: Problem, state: State, side: int) -> EdgePressure:
    at = -1 if side > 0 else 0
    place, width = float(state.edges[at]), float(state.width[at])
    if not reaches(state, side):
        y = state.contact[at][(side + 1) // 2] if state.contact else place
        told = "the contact ends before both bodies do"
        return EdgePressure(y, EdgeKind.RUN_OUT, 0.0, 0.0, 0.0, 0.0, None, None, told)
    pressure = 2.0 * state.pressure[::-side] / (np.pi * problem.element.hertz_ratio * contact.compliance)
    if place not in contact.interval:
        told = "the strips end before the contact does"
        return EdgePressure(place, EdgeKind.CUT_OFF, float(pressure[0]), width, 0.0, 0.0, None, None, told)
    convention = _convention(contact, problem, place, side, AT_ONE_PLACE * width)
    kappa = _image_weight_within(problem, state, side, AT_ONE_PLACE * width)
    if kappa >= FINITE_FROM:
        return EdgePressure(place, EdgeKind.FINITE, float(pressure[0]), width, kappa, 0.0, None, None, convention)
    exponent = math.acos(kappa) / math.pi
    half_width = problem.element.hertz_ratio * math.sqrt(float(state.m[at]))
    strength = correction = None
    # The face of another body a little further out bends the pressure where K would be read off.
    alone = kappa == _image_weight_within(problem, state, side, FIT_REACH * half_width)
    if alone and exponent >= LEAST_EXPONENT:
        distance = np.abs(state.y - place)[::-side]
        strength, correction = _strength(distance, state.width[::-side], pressure, exponent, half_width)
    return EdgePressure(
        place, EdgeKind.SINGULAR, float(pressure[0]), width, kappa, exponent, strength, correction, convention
    )


def _convention(contact: Contact, problem: Problem, place: float, side: int, reach: float) -> str:
    """Say of either body whether it ends at ``place``, and how its side face counts there."""
    index, told = (side + 1) // 2, []
    for which, (name, body) in enumerate((("a", contact.a), ("b", contact.b))):
        face = body.faces[index]
        weight = max((end.weights[which] for end in problem.influence.ends if end.side == side), default=0.0)
        if abs(body.interval[index] - place) > reach:
            told.append(f"{name} goes on")
        elif math.isfinite(face) and abs(face - place) > reach:
            told.append(f"{name} can touch no further, {abs(face - place):.3g} mm short of its side face")
        elif weight > 0.0:
            told.append(f"{name} ends with its side face freed by images of weight {weight:.3g}")
        else:
            told.append(f"{name} ends as a half-space")
    return ", ".join(told)


def _strength(
    distance: Array, width: Array, pressure: Array, exponent: float, half_width: float
) -> tuple[float | None, float | None]:
    """Return K [MPa mm^alpha] and c [mm^(-2 alpha)], or None where too few strips lie near the end to tell.

    Distances of the strip centres from the end, widths and pressures begin with the last strip.
    """
    idle = np.flatnonzero(pressure == 0.0)
    run = idle[0] if idle.size else pressure.size
    near = np.flatnonzero(distance[:run] < FIT_REACH * half_width)[BIASED_STRIPS:]
    if near.size < FEWEST_POINTS:
        return None, None
    s = distance[near]
    # What a strip carries is the mean over its width.
    low, high = s - 0.5 * width[near], s + 0.5 * width[near]
    mean = (high ** (1.0 - exponent) - low ** (1.0 - exponent)) / ((1.0 - exponent) * width[near])
    shape = np.column_stack([mean, mean * (s / half_width) ** (2.0 * exponent)])
    if not np.all(np.isfinite(shape / pressure[near, None])):  # of a loop that failed
        return None, None
    fit = np.linalg.lstsq(shape / pressure[near, None], np.ones(near.size), rcond=None)[0]
    if fit[0] <= 0.0:
        return None, None
    return float(fit[0]), float(fit[1] / fit[0] * half_width ** (-2.0 * exponent))
