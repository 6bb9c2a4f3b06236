"""The final check of a solution: whether it meets what was prescribed, computed from its own arrays alone.

The Newton loop judges itself by the residual of the equations it has just linearised, on the strips it holds active,
and a globalisation may solve a different problem on the way. This check shares nothing with the loop but the element's
table and the images: from edges, loads, half-widths, approach and tilt it recomputes displacement and curvature at
every strip and compares them with the bodies and with the prescription. A state that fails it is not a solution, even
if the loop reported convergence.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.strip.element import evaluate
from nonhertz.strip.state import Problem

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

MET, NOT_FINITE, FIRST, SECOND, TENSION, UNCLOSED, OVERLAP, BENT, HIDDEN = range(9)

# A thousand times the loop's own tolerance: sums taken in another order differ by rounding, wrong answers by far more.
# Curvature rows are met only to the square of the last step.
TOLERANCE, CURVATURE_TOLERANCE = 1e-8, 1e-6
ROUNDING = 1e-14  # relative to the largest of the lengths whose difference is a gap
# Largest rounding as a fraction of the interference. ROUNDING is generous: at this limit some four digits of the
# interference remain.
MOST_HIDDEN = 1e-2
UNSTEADY = -1e-6  # of stiffness against approach times reach^2: a tilt stiffness no more negative than this is rounding


def shortfall(
    problem: Problem, edges: Array, line_load: Array, half_width: Array, gap: Array, motion: Array
) -> str | None:
    """Return one sentence on what a solution fails to meet, or None if it meets everything.

    Parameters
    ----------
    problem : Problem
        What was prescribed.
    edges : ndarray, shape (n + 1,)
        Edges of the strips [mm].
    line_load, half_width, gap : ndarray, shape (n,)
        Load per length q [N/mm], half-width a of the element [mm] and gap [mm] of each strip.
    motion : ndarray, shape (2,)
        Approach [mm] and tilt [rad].
    """
    y = 0.5 * (edges[1:] + edges[:-1])
    influence, compliance = problem.influence, problem.compliance
    condition, found, at = first_unmet(
        y, edges[:-1], edges[1:], problem.curvature(y), problem.separation(y), problem.prescribed, problem.target,
        influence.terms, influence.at_depth(y, edges), problem.element.table, compliance * line_load, half_width, gap,
        motion,
    )  # fmt: skip
    if condition == MET:
        return None
    if condition in {FIRST, SECOND}:
        which = condition - FIRST
        by_force = bool(problem.prescribed[which])
        name, unit = (("approach", "mm"), ("tilt", "rad"), ("load", "N"), ("moment", "N mm"))[2 * by_force + which]
        per = compliance if by_force else 1.0
        return f"The {name} of the state reached is {found / per:.6g} {unit}, not {problem.target[which] / per:.6g}."
    place = f"at y = {y[at]:.6g} mm"
    return {
        NOT_FINITE: f"The state reached is not finite {place}.",
        TENSION: f"The state reached has tension {place}, {found / compliance:.3g} N/mm.",
        UNCLOSED: f"The state reached leaves a gap of {1e3 * found:.3g} um {place}, where it bears load.",
        OVERLAP: f"In the state reached, the bodies overlap by {1e3 * found:.3g} um {place}.",
        BENT: f"In the state reached, the curvatures across the contact do not match {place}: the relative error is "
        f"{found:.2g}.",
        HIDDEN: f"In the state reached, the bodies interfere by only {1e3 * found:.3g} um, which is lost in the "
        "rounding of tilt and relief.",
    }[condition]


@compiled
def first_unmet(  # noqa: PLR0911  (one return per condition)
    y: Array,
    low: Array,
    high: Array,
    curvature: Array,
    separation: Array,
    prescribed: Flags,
    target: Array,
    terms: Array,
    at_depth: Array,
    table: Array,
    q: Array,
    half_width: Array,
    gap: Array,
    motion: Array,
) -> tuple[int, float, int]:
    """Return the first condition that is not met, the value found, and the strip where it was found.

    Parameters as in `nonhertz.strip.newton.newton`, except ``q``, K times the load per length [mm], and
    ``half_width``, a [mm], which belong to the solution.
    """
    condition, at = _unusable(q, half_width, gap, separation, motion)
    if condition != MET:
        return condition, q[at], at
    condition, found = _unbalanced(y, high - low, prescribed, target, q, motion)
    if condition != MET:
        return condition, found, 0
    deepest, longest = _lengths(y, separation, q, motion)
    if ROUNDING * longest > MOST_HIDDEN * deepest:
        return HIDDEN, deepest, 0
    allowed = TOLERANCE * deepest + ROUNDING * longest
    for i in range(y.size):
        if not math.isfinite(separation[i]) and q[i] == 0.0:
            continue
        lift, bend = _lift_and_bend(i, y, low, high, terms, at_depth, table, q, half_width)
        opening = lift - (motion[0] + motion[1] * y[i] - separation[i])
        if not abs(opening - gap[i]) <= allowed + TOLERANCE * abs(opening) or (q[i] > 0.0 and abs(opening) > allowed):
            return UNCLOSED, opening, i
        if opening < -allowed:
            return OVERLAP, -opening, i
        if q[i] > 0.0 and not abs(bend - curvature[i]) <= CURVATURE_TOLERANCE * curvature[i]:
            return BENT, bend / curvature[i] - 1.0, i
    return MET, 0.0, 0


@compiled
def steady(stiffness: Array, reach: float) -> bool:
    """Return whether the bodies resist being pressed together and being tilted.

    Far outside the model's validity (bodies as thin as their contact is wide, contacts several times as wide as long)
    the equations have additional, spurious solutions whose load or moment falls as the bodies approach.

    Parameters
    ----------
    stiffness : ndarray, shape (2, 2)
        As in the solution.
    reach : float
        Largest distance from y = 0 [mm].
    """
    if not np.all(np.isfinite(stiffness)):
        return False
    return bool(stiffness[0, 0] > 0.0 and stiffness[1, 1] >= UNSTEADY * stiffness[0, 0] * reach * reach)


@compiled
def _unusable(q: Array, half_width: Array, gap: Array, separation: Array, motion: Array) -> tuple[int, int]:
    """Return why the arrays cannot describe a contact, and at which strip; MET if they can."""
    for i in range(q.size):
        unknown = math.isnan(gap[i]) or math.isnan(separation[i]) or not math.isfinite(motion[0] + motion[1])
        if unknown or not (math.isfinite(q[i]) and math.isfinite(half_width[i])):
            return NOT_FINITE, i
        if q[i] > 0.0 and not half_width[i] > 0.0:
            return NOT_FINITE, i  # an infinite pressure
        if q[i] < 0.0:
            return TENSION, i
    return MET, 0


@compiled
def _unbalanced(y: Array, width: Array, prescribed: Flags, target: Array, q: Array, motion: Array) -> tuple[int, float]:
    """Return which of the two prescribed quantities is missed, and the value found instead."""
    load, moment = np.sum(q * width), np.sum(q * width * y)
    first = load if prescribed[0] else motion[0]
    if not abs(first - target[0]) <= TOLERANCE * abs(target[0]):
        return FIRST, first
    second = moment if prescribed[1] else motion[1]
    # A moment is as accurate as the load at the longest lever arm.
    scale = load * max(abs(y[0]), abs(y[-1])) if prescribed[1] else abs(target[1])
    if not abs(second - target[1]) <= TOLERANCE * scale:
        return SECOND, second
    return MET, 0.0


@compiled
def _lengths(y: Array, separation: Array, q: Array, motion: Array) -> tuple[float, float]:
    """Return the deepest interference in contact, and the largest of the lengths whose differences are the gaps."""
    deepest, longest = 0.0, abs(motion[0]) + abs(motion[1]) * max(abs(y[0]), abs(y[-1]))
    for i in range(y.size):
        if q[i] > 0.0:
            deepest = max(deepest, motion[0] + motion[1] * y[i] - separation[i])
            longest = max(longest, abs(separation[i]))
    return (deepest if deepest > 0.0 else longest), longest


@compiled
def _lift_and_bend(
    i: int, y: Array, low: Array, high: Array, terms: Array, at_depth: Array, table: Array, q: Array, half_width: Array
) -> tuple[float, float]:
    """Return displacement [mm] and curvature [1/mm] of both surfaces together at strip ``i``, on the centre line."""
    lift = bend = 0.0
    for j in range(y.size):
        if q[j] > 0.0:
            inverse = 1.0 / half_width[j]
            risen = curved = 0.0
            for k in range(terms.shape[0]):
                sign, offset = terms[k, 0], terms[k, 1] - y[i]
                upper = evaluate((sign * high[j] + offset) * inverse, table)
                lower = evaluate((sign * low[j] + offset) * inverse, table)
                risen += sign * terms[k, 2] * (upper[0] - lower[0])
                curved += sign * terms[k, 2] * (upper[2] - lower[2])
            lift += q[j] * (risen - at_depth[i, j])
            bend += q[j] * curved * inverse * inverse
    return lift, bend
