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
from nonhertz.findings import Finding, finding
from nonhertz.native import core
from nonhertz.result.edges import EdgeKind, EdgePressure
from nonhertz.result.end_fit import FIT_REACH, fit_strength
from nonhertz.strip.problem import Problem

Array = NDArray[np.float64]

LEAST_EXPONENT = 0.1
AT_ONE_PLACE = 0.01  # of the last strip
KINDS = tuple(EdgeKind)
_WORDS = {
    EdgeKind.RUN_OUT: Finding.from_text("the contact ends before both bodies do"),
    EdgeKind.CORNER: Finding.from_text("the profile turns away from the other body"),
    EdgeKind.CUT_OFF: Finding.from_text("the strips end before the contact does"),
}


def edge_pressures(problem: Problem, judged: core.Judgement) -> tuple[EdgePressure, EdgePressure]:
    """Return the pressures at both ends, without strengths; see `with_strengths`."""
    pressures = []
    for end, side in zip(judged.ends, (-1, 1), strict=True):
        kind = KINDS[end.kind]
        words = _WORDS.get(kind) or _convention(problem, end.y, side, AT_ONE_PLACE * end.width)
        pressures.append(
            EdgePressure(
                end.y, kind, end.pressure, end.width, end.image_weight, end.exponent, None, None,
                end.correction_exponent, words,
            )
        )  # fmt: skip
    return pressures[0], pressures[1]


def _sum_free_faces(problem: Problem, place: float, side: int, reach: float) -> tuple[float, float]:
    """Return kappa summed over the free faces within ``reach`` of an end of the strips, at most 1, and its free part.

    The second is what `nonhertz.bodies.ends.End` calls free.
    """
    near = [end for end in problem.model.influence.ends if end.side == side and abs(end.y - place) <= reach]
    return min(sum(end.image_weight for end in near), 1.0), min(sum(end.free for end in near), 1.0)


def add_strengths(
    problem: Problem, edges: Array, r: Array, m: Array, ends: tuple[EdgePressure, EdgePressure]
) -> tuple[EdgePressure, EdgePressure]:
    """Return the pressures at both ends, with strengths of sharp ends that have one.

    ``edges``, ``r`` and ``m`` are those of the strips, as in `nonhertz.native.core.State`.
    """
    if all(end.kind is not EdgeKind.SINGULAR for end in ends):
        return ends
    ratio = problem.model.element.hertz_ratio
    pressure = 2.0 * (r * np.sqrt(m)) / (np.pi * ratio * problem.contact.compliance)
    low, high = (
        _add_strength(problem, end, side, np.abs(edges - end.y)[::-side], pressure[::-side], ratio * math.sqrt(last))
        for end, side, last in zip(ends, (-1, 1), (m[0], m[-1]), strict=True)
    )
    return low, high


def _add_strength(
    problem: Problem, edge: EdgePressure, side: int, distance: Array, pressure: Array, half_width: float
) -> EdgePressure:
    """Return an end with its strength; edges are at these distances from it, outermost first, like pressures."""
    if edge.kind is not EdgeKind.SINGULAR:
        return edge
    freed = _sum_free_faces(problem, edge.y, side, AT_ONE_PLACE * edge.strip_width)
    # The face of the other body a little further out distorts the pressure where K would be fitted.
    if freed != _sum_free_faces(problem, edge.y, side, FIT_REACH * half_width) or edge.exponent < LEAST_EXPONENT:
        return edge
    strength, correction = fit_strength(distance, pressure, freed, half_width, problem.model.element)
    return replace(edge, strength=strength, correction=correction)


def _convention(problem: Problem, place: float, side: int, reach: float) -> Finding:
    """Describe for each body whether it ends at ``place``, and the treatment of its side face."""
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
