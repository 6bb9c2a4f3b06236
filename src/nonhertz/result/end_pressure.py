"""The pressure at the ends of a contact: a value where it is finite, exponent and strength where it is singular.

Where a contact runs out inside the bodies, its pressure falls to zero. Where it reaches the end of a body, the surface
stops abruptly, and at distances s small compared with the half-width the equations of the strips become those of a
plane wedge, with p ~ K / s^alpha and, where faces are mirrored, cos(pi alpha) = kappa (`nonhertz.bodies.ends`). Only
for kappa = 1, as where both bodies end together with mirrored or free faces, is that a finite pressure. For a smaller
kappa every refinement raises the pressure of the last strip, so that value is meaningless; K and alpha are not.

`nonhertz.result.end_fit` fits K to the strips within half a half-width of the end.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.ends import FINITE_FROM, edge_powers
from nonhertz.findings import Finding, finding, said
from nonhertz.result.end_fit import FIT_REACH, fitted_strength
from nonhertz.result.ends import corner_ends
from nonhertz.result.solution import EdgeKind, EdgePressure
from nonhertz.strip.grid import contact_ends, reaching
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import States

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

LEAST_EXPONENT = 0.1
AT_ONE_PLACE = 0.01  # of the last strip
KINDS = tuple(EdgeKind)
RUN_OUT, FINITE, SINGULAR, CORNER, CUT_OFF = range(len(KINDS))
_WORDS = {
    EdgeKind.RUN_OUT: said("the contact ends before both bodies do"),
    EdgeKind.CORNER: said("the profile turns away from the other body"),
    EdgeKind.CUT_OFF: said("the strips end before the contact does"),
}


class Ends(NamedTuple):
    """How contacts end, in columns for the low and the high end.

    Attributes
    ----------
    kinds : ndarray of int, shape (cases, 2)
        Indices into `KINDS`.
    y, width, image_weight, exponent, correction_exponent : ndarray, shape (cases, 2)
        As in `nonhertz.result.solution.EdgePressure`, ``width`` that of the last strip.
    singular : ndarray, shape (cases, k)
        All places at which the pressure has no limit [mm], nan for none: sharp ends in two columns, then corners.
    """

    kinds: NDArray[np.int64]
    y: Array
    width: Array
    image_weight: Array
    exponent: Array
    correction_exponent: Array
    singular: Array


def ends_of(problem: Problem, states: States) -> Ends:
    """Return how contacts end, for many on the same strips or each on its own."""
    cases = states.status.size
    kinds, y = np.full((cases, 2), RUN_OUT), contact_ends(states)
    width, weight, exponent, correction = (np.zeros((cases, 2)) for _ in range(4))
    # Where undeformed bodies do not overlap at the end of the strips, they cannot touch there: the last strip may be
    # wider than the remainder of a contact that runs out close to the end.
    last = states.edges[:, [0, -1]]
    separation = problem.model.separation(last.ravel()).reshape(last.shape)
    touching = reaching(states) & (states.rigid[:, :1] + states.rigid[:, 1:] * last > separation)
    for column, side in enumerate((-1, 1)):
        there = touching[:, column]
        for row in states.rows(there):
            here = np.flatnonzero(there).tolist() if states.shared else [row]
            end = _body_end(problem, states.strips(row), side)
            kinds[here, column], y[here, column], width[here, column] = end[:3]
            weight[here, column], exponent[here, column], correction[here, column] = end[3:]
    singular = [np.where(kinds == SINGULAR, y, np.nan)]
    if problem.contact.bends:
        of_cases = [
            _at_corners(problem, states.one(case), kinds[case], y[case], width[case]) if states.converged[case] else ()
            for case in range(cases)
        ]
        corners = np.full((cases, max(map(len, of_cases))), np.nan)
        for at, places in enumerate(of_cases):
            corners[at, : len(places)] = places
        singular.append(corners)
    return Ends(kinds, y, width, weight, exponent, correction, np.hstack(singular))


def _body_end(problem: Problem, edges: Array, side: int) -> tuple[int, float, float, float, float, float]:
    """Return how a contact ends that extends to the end of its strips; see `Ends`."""
    at, next_in = (-1, -2) if side > 0 else (0, 1)
    place, width = float(edges[at]), abs(float(edges[at] - edges[next_in]))
    if place not in problem.contact.interval:
        return CUT_OFF, place, width, 0.0, 0.0, 0.0
    kappa, free = _freed(problem, place, side, AT_ONE_PLACE * width)
    if kappa >= FINITE_FROM:
        return FINITE, place, width, kappa, 0.0, 0.0
    first, second, _ = edge_powers(kappa, free)
    return SINGULAR, place, width, kappa, -first, second - first


def _at_corners(problem: Problem, state: States, kinds: NDArray[np.int64], y: Array, width: Array) -> tuple[float, ...]:
    """Return the corners at which a contact ends, and mark run-outs that in fact press against one as corners."""
    half_width = problem.model.element.hertz_ratio * np.sqrt(state.m)
    corners = corner_ends(problem.contact, state.edges, centre_pressure(problem, state), half_width)
    bearing = np.flatnonzero(state.m > 0.0)
    for corner in corners:
        for column, side, at in ((0, -1, bearing[0]), (1, 1, bearing[-1])):
            if kinds[column] == RUN_OUT and side * corner > side * state.y[at] - state.width[at]:
                kinds[column], y[column], width[column] = CORNER, corner, state.width[at]
    return corners


def end_in_words(problem: Problem, kind: EdgeKind, place: float, width: float, side: int) -> Finding:
    """Return what ends a contact at a place; ``width`` is that of its last strip [mm]."""
    return _WORDS.get(kind) or _convention(problem, place, side, AT_ONE_PLACE * width)


def centre_pressure(problem: Problem, state: States) -> Array:
    """Return the pressure on the centre line of every strip [MPa]."""
    pressure: Array = (
        2.0 * state.scaled_pressure / (np.pi * problem.model.element.hertz_ratio * problem.contact.compliance)
    )
    return pressure


def _freed(problem: Problem, place: float, side: int, reach: float) -> tuple[float, float]:
    """Return kappa summed over the free faces within ``reach`` of an end of the strips, at most 1, and its free part.

    The second is what `nonhertz.bodies.ends.End` calls free.
    """
    found = [end for end in problem.model.influence.ends if end.side == side and abs(end.y - place) <= reach]
    return min(sum(end.image_weight for end in found), 1.0), min(sum(end.free for end in found), 1.0)


def with_strength(problem: Problem, state: States, edge: EdgePressure, side: int) -> EdgePressure:
    """Return the pressure at a sharp end with its strength, as far as it has one; any other as it is."""
    if edge.kind is not EdgeKind.SINGULAR:
        return edge
    half_width = problem.model.element.hertz_ratio * math.sqrt(float(state.m[-1 if side > 0 else 0]))
    freed = _freed(problem, edge.y, side, AT_ONE_PLACE * edge.strip_width)
    # The face of the other body a little further out distorts the pressure where K would be fitted.
    if freed != _freed(problem, edge.y, side, FIT_REACH * half_width) or edge.exponent < LEAST_EXPONENT:
        return edge
    distance, pressure = np.abs(state.edges - edge.y)[::-side], centre_pressure(problem, state)[::-side]
    strength, correction = fitted_strength(distance, pressure, freed, half_width, problem.model.element)
    return replace(edge, strength=strength, correction=correction)


def _convention(problem: Problem, place: float, side: int, reach: float) -> Finding:
    """Describe for each body whether it ends at ``place``, and how its side face is treated there."""
    index, words, short = (side + 1) // 2, [], {}
    for which, (name, body) in enumerate((("a", problem.contact.a), ("b", problem.contact.b))):
        face = body.faces[index]
        weight = max((end.weights[which] for end in problem.model.influence.ends if end.side == side), default=0.0)
        if abs(body.interval[index] - place) > reach:
            words.append(f"{name} continues")
        elif math.isfinite(face) and abs(face - place) > reach:
            words.append(f"{name} can touch only up to here, {{{name}:.3g}} short of its side face")
            short[name] = mm(abs(face - place))
        elif body.free_faces[index]:
            words.append(f"{name} ends with its side face free")
        elif weight > 0.0:
            words.append(f"{name} ends with its side face freed by images of weight {weight:.3g}")
        else:
            words.append(f"{name} ends as a half-space")
    return finding("how-an-end-is-treated", ", ".join(words), **short)
