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

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.ends import FINITE_FROM, edge_powers
from nonhertz.findings import Finding, finding, said
from nonhertz.result.end_fit import FIT_REACH, fitted_strength
from nonhertz.result.ends import corner_ends
from nonhertz.result.solution import EdgeKind, EdgePressure
from nonhertz.strip.grid import contact_of, reaches, reaching
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import States

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

SHARP_END_ERROR = 0.12
LEFT_AT_END = 0.016
LEAST_EXPONENT = 0.1
AT_ONE_PLACE = 0.01  # of the last strip


def edge_pressures(problem: Problem, state: States) -> tuple[EdgePressure, EdgePressure]:
    """Return the pressures at the low and the high end of a solved contact, without strengths; see `with_strength`."""
    return _edge_pressure(problem, state, -1), _edge_pressure(problem, state, 1)


def corners(problem: Problem, state: States) -> tuple[float, ...]:
    """Return the corners of the profile at which a contact ends under pressure [mm], ascending."""
    if not problem.contact.bends:
        return ()
    half_width = problem.model.element.hertz_ratio * np.sqrt(state.m)
    return corner_ends(problem.contact, state.edges, centre_pressure(problem, state), half_width)


def centre_pressure(problem: Problem, state: States) -> Array:
    """Return the pressure on the centre line of every strip [MPa]."""
    pressure: Array = (
        2.0 * state.scaled_pressure / (np.pi * problem.model.element.hertz_ratio * problem.contact.compliance)
    )
    return pressure


def singular_places(problem: Problem, states: States) -> Array:
    """Return the ends of contacts on the same strips at which the pressure has no limit [mm].

    Returns
    -------
    ndarray, shape (cases, k)
        Padded with nan where a case has fewer such ends than others, or none.
    """
    columns: list[Array] = []
    for side in (-1, 1):
        place = states.edges[:, -1 if side > 0 else 0]
        ends_there = reaching(states, side) & pressed(problem, states.edges, states.rigid, side)
        sharp = {row: _is_sharp(problem, states.strips(row), side) for row in states.rows(ends_there)}
        here = np.broadcast_to([sharp.get(row, False) for row in range(place.size)], ends_there.shape)
        columns.append(np.where(here & ends_there, place, np.nan))
    if problem.contact.bends:
        of_cases = [corners(problem, states.one(case)) for case in range(states.status.size)]
        most = max(map(len, of_cases))
        columns += np.array([(*each, *[np.nan] * (most - len(each))) for each in of_cases]).T.tolist()
    return np.array(columns).T


def pressed(problem: Problem, edges: Array, rigid: Array, side: int) -> Flags:
    """Return whether the undeformed bodies overlap at the end of the strips, without which they cannot touch there.

    The last strip alone does not tell: it may be wider than the remainder of a contact that runs out close to the end.

    Parameters
    ----------
    problem : Problem
        The problem solved.
    edges : ndarray, shape (n + 1,) or (cases, n + 1) or (1, n + 1)
        Edges of the strips [mm].
    rigid : ndarray, shape (2,) or (cases, 2)
        Approach and tilt [mm, rad].
    side : int
        -1 at the low, 1 at the high end.
    """
    place = np.atleast_1d(edges[..., -1 if side > 0 else 0])
    overlap: Flags = rigid[..., 0] + rigid[..., 1] * place > problem.model.separation(place)
    return overlap if rigid.ndim > 1 else overlap[0]


def _is_sharp(problem: Problem, edges: Array, side: int) -> bool:
    """Return whether a contact that extends to the end of the strips ends at a sharp end of a body."""
    at, next_in = (-1, -2) if side > 0 else (0, 1)
    place, width = float(edges[at]), abs(float(edges[at] - edges[next_in]))
    return place in problem.contact.interval and _freed(problem, place, side, AT_ONE_PLACE * width)[0] < FINITE_FROM


def sharp_end_error(edges: tuple[EdgePressure, ...], length: float) -> float:
    """Return the relative error that strips cause at the ends of a contact, proportional to the last one's width.

    Measured on straight rollers: a tenth of both end strips' widths over the length, on equal and graded grids alike;
    0.4 of that at kappa = 1/4, 0.2 at 1/2, 0.06 at 3/4 and zero at 1. Ends that are free of normal stress count as
    those of images with the same exponent.
    """
    left = (edge.strip_width * _sharpness(edge) for edge in edges if not edge.converges)
    return SHARP_END_ERROR * sum(left) / length


def left_at_sharp_ends(problem: Problem, state: States, edges: tuple[EdgePressure, ...]) -> float:
    """Return the relative error of approach or load that no number of strips removes, at sharp ends in contact.

    Within a half-width of such an end the pressure across is no semi-ellipse. What that changes is in proportion to the
    load that a length of one half-width bears there: for kappa = 0, 0.0150 of its share of the load on a straight
    roller and 0.0103 on a crowned one, against three-dimensional solutions; `LEFT_AT_END` is above both.
    """
    half_width = problem.model.element.hertz_ratio * np.sqrt(state.m)
    left = 0.0
    for edge in edges:
        if edge.kind is EdgeKind.SINGULAR:
            distance = np.abs(state.y - edge.y)
            beside = half_width[int(np.argmin(np.abs(distance - half_width)))]
            at = int(np.argmin(np.abs(distance - beside)))
            borne = float(state.r[at] * state.m[at] * half_width[at])
            left += borne * _sharpness(edge)
    return LEFT_AT_END * left / float(state.scaled_load)


def _sharpness(edge: EdgePressure) -> float:
    """Return the error that an end causes, over that of an end of half-spaces."""
    return math.pow(1.0 - math.cos(math.pi * edge.exponent), 1.5)


def _freed(problem: Problem, place: float, side: int, reach: float) -> tuple[float, float]:
    """Return kappa summed over the free faces within ``reach`` of an end of the strips, at most 1, and its free part.

    The second is what `nonhertz.bodies.ends.End` calls free.
    """
    found = [end for end in problem.model.influence.ends if end.side == side and abs(end.y - place) <= reach]
    return min(sum(end.image_weight for end in found), 1.0), min(sum(end.free for end in found), 1.0)


def _edge_pressure(problem: Problem, state: States, side: int) -> EdgePressure:
    at = -1 if side > 0 else 0
    place, width = float(state.edges[at]), float(state.width[at])
    if not reaches(state.edges, state.m, side) or not pressed(problem, state.edges, state.rigid, side):
        touched = contact_of(state)
        y = touched[at][(side + 1) // 2] if touched else place
        words = said("the contact ends before both bodies do")
        return EdgePressure(y, EdgeKind.RUN_OUT, 0.0, 0.0, 0.0, 0.0, None, None, 0.0, words)
    pressure = centre_pressure(problem, state)[::-side]
    if place not in problem.contact.interval:
        words = said("the strips end before the contact does")
        return EdgePressure(place, EdgeKind.CUT_OFF, float(pressure[0]), width, 0.0, 0.0, None, None, 0.0, words)
    convention = _convention(problem, place, side, AT_ONE_PLACE * width)
    kappa, free = _freed(problem, place, side, AT_ONE_PLACE * width)
    if not _is_sharp(problem, state.edges, side):
        return EdgePressure(place, EdgeKind.FINITE, float(pressure[0]), width, kappa, 0.0, None, None, 0.0, convention)
    first, second, _ = edge_powers(kappa, free)
    of_last = float(pressure[0])
    return EdgePressure(
        place, EdgeKind.SINGULAR, of_last, width, kappa, -first, None, None, second - first, convention
    )  # fmt: skip


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
            words.append(f"{name} goes on")
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
