"""The final check of a solution: whether it meets what was prescribed, computed from its own arrays alone.

The Newton loop judges itself by the residual of the equations it has just linearised, on the strips it holds active,
and a globalisation may solve a different problem on the way. This check shares nothing with the loop but the element's
table and the images: from edges, loads, half-widths, approach and tilt it recomputes displacement and curvature at
every strip and compares them with the bodies and with the prescription. A state that fails it is not a solution, even
if the loop reported convergence.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from nonhertz.amounts import mm, per_mm, um
from nonhertz.compiled import compiled, inlined, plain_array
from nonhertz.compiled.tiles import TILE
from nonhertz.strip.element import POWERS, POWERS_AT, evaluate
from nonhertz.strip.free_end import AWAY, far_terms, far_whole, no_squares
from nonhertz.strip.influence import added_by_face, by_own_width
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import Array, BoundaryConditions, Flags, Grids, Indices, Kernel, States, Strips
from nonhertz.strip.solving import strips_of

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
    problem: Problem, grids: Grids, line_load: Array, half_width: Array, gap: Array, motion: Array
) -> str | None:
    """Return one sentence on what a solution fails to meet, or None if it meets everything.

    Parameters
    ----------
    problem : Problem
        What was prescribed.
    grids : Grids
        One grid: the strips.
    line_load, half_width, gap : ndarray, shape (n,)
        Load per length q [N/mm], half-width a of the element [mm] and gap [mm] of each strip.
    motion : ndarray, shape (2,)
        Approach [mm] and tilt [rad].
    """
    y, compliance = grids.y[0], problem.contact.compliance
    conditions = BoundaryConditions(problem.prescribed, problem.target)
    answer = Answer(compliance * line_load, half_width, gap, motion)
    condition, found, at = first_unmet(strips_of(grids, 0), conditions, problem.model.kernel, answer)
    if condition == MET:
        return None
    if condition in {FIRST, SECOND}:
        which = condition - FIRST
        by_force = bool(problem.prescribed[which])
        name, unit = (("approach", "mm"), ("tilt", "rad"), ("load", "N"), ("moment", "N mm"))[2 * by_force + which]
        per = compliance if by_force else 1.0
        return f"The {name} of the state reached is {found / per:.6g} {unit}, not {problem.target[which] / per:.6g}."
    place = f"at y = {mm(y[at]):.6g}"
    return {
        NOT_FINITE: f"The state reached is not finite {place}.",
        TENSION: f"The state reached has tension {place}, {per_mm(found / compliance):.3g}.",
        UNCLOSED: f"The state reached leaves a gap of {um(found):.3g} {place}, where it bears load.",
        OVERLAP: f"In the state reached, the bodies overlap by {um(found):.3g} {place}.",
        BENT: f"In the state reached, the curvatures across the contact do not match {place}: the relative error is "
        f"{found:.2g}.",
        HIDDEN: f"In the state reached, the bodies interfere by only {um(found):.3g}, which is lost in the "
        "rounding of tilt and relief.",
    }[condition]


def met_by(problem: Problem, grids: Grids, states: States, targets: Array) -> Flags:
    """Return which of many states meet everything; ``targets`` as `Problem.target`, shape (cases, 2)."""
    conditions = BoundaryConditions(problem.prescribed, plain_array(targets))
    return _met_by(grids, conditions, problem.model.kernel, states)


class Answer(NamedTuple):
    """What is claimed to be a solution: K times the load per length, half-width a and gap of every strip, motion."""

    q: Array
    half_width: Array
    gap: Array
    motion: Array


@compiled
def _met_by(grids: Grids, conditions: BoundaryConditions, kernel: Kernel, states: States) -> Flags:
    met = np.empty(states.status.size, np.bool_)
    for case in range(met.size):
        strips = strips_of(grids, 0 if grids.counts.size == 1 else case)
        n = strips.y.size
        q, half_width = np.empty(n), np.empty(n)
        for i in range(n):
            q[i], half_width[i] = states.r[case, i] * states.m[case, i], math.sqrt(states.m[case, i])
        answer = Answer(q, half_width, states.gap[case, :n], states.rigid[case])
        condition, _, _ = first_unmet(
            strips, BoundaryConditions(conditions.by_force, conditions.target[case]), kernel, answer
        )
        reach = max(abs(strips.low[0]), abs(strips.high[-1]))
        met[case] = condition == MET and steady(states.stiffness[case], reach)
    return met


@compiled
def first_unmet(  # noqa: PLR0911  (one return per condition)
    strips: Strips, conditions: BoundaryConditions, kernel: Kernel, answer: Answer
) -> tuple[int, float, int]:
    """Return the first condition that is not met, the value found, and the strip where it was found."""
    condition, at = _unusable(strips, answer)
    if condition != MET:
        return condition, answer.q[at], at
    condition, found = _unbalanced(strips, conditions, answer)
    if condition != MET:
        return condition, found, 0
    deepest, longest = _lengths(strips, answer)
    if ROUNDING * longest > MOST_HIDDEN * deepest:
        return HIDDEN, deepest, 0
    q, gap, motion = answer.q, answer.gap, answer.motion
    allowed = TOLERANCE * deepest + ROUNDING * longest
    lift, bend = _lift_and_bend(strips, kernel, answer)
    for i in range(q.size):
        if not math.isfinite(strips.separation[i]) and q[i] == 0.0:
            continue
        opening = lift[i] - (motion[0] + motion[1] * strips.y[i] - strips.separation[i])
        if not abs(opening - gap[i]) <= allowed + TOLERANCE * abs(opening) or (q[i] > 0.0 and abs(opening) > allowed):
            return UNCLOSED, opening, i
        if opening < -allowed:
            return OVERLAP, -opening, i
        if q[i] > 0.0 and not abs(bend[i] - strips.curvature[i]) <= CURVATURE_TOLERANCE * strips.curvature[i]:
            return BENT, bend[i] / strips.curvature[i] - 1.0, i
    return MET, 0.0, 0


@compiled
def steadily(states: States) -> Flags:
    """Return in which of many cases the bodies resist being pressed together and being tilted."""
    found = np.empty(states.status.size, np.bool_)
    for case in range(found.size):
        edges = states.edges[0 if states.edges.shape[0] == 1 else case]
        found[case] = steady(states.stiffness[case], max(abs(edges[0]), abs(edges[-1])))
    return found


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
    for i in range(4):
        if not math.isfinite(stiffness[i // 2, i % 2]):
            return False
    return bool(stiffness[0, 0] > 0.0 and stiffness[1, 1] >= UNSTEADY * stiffness[0, 0] * reach * reach)


@compiled
def _unusable(strips: Strips, answer: Answer) -> tuple[int, int]:
    """Return why the arrays cannot describe a contact, and at which strip; MET if they can."""
    q, half_width, gap, motion = answer.q, answer.half_width, answer.gap, answer.motion
    for i in range(q.size):
        unknown = math.isnan(gap[i]) or math.isnan(strips.separation[i]) or not math.isfinite(motion[0] + motion[1])
        if unknown or not (math.isfinite(q[i]) and math.isfinite(half_width[i])):
            return NOT_FINITE, i
        if q[i] > 0.0 and not (half_width[i] > 0.0 and math.isfinite(q[i] / half_width[i])):
            return NOT_FINITE, i  # an infinite pressure
        if q[i] < 0.0:
            return TENSION, i
    return MET, 0


@compiled
def _unbalanced(strips: Strips, conditions: BoundaryConditions, answer: Answer) -> tuple[int, float]:
    """Return which of the two prescribed quantities is missed, and the value found instead."""
    load = moment = 0.0
    for i in range(answer.q.size):
        carried = answer.q[i] * (strips.high[i] - strips.low[i])
        load += carried
        moment += carried * strips.y[i]
    target = conditions.target
    first = load if conditions.by_force[0] else answer.motion[0]
    if not abs(first - target[0]) <= TOLERANCE * abs(target[0]):
        return FIRST, first
    second = moment if conditions.by_force[1] else answer.motion[1]
    # A moment is as accurate as the load at the longest lever arm.
    scale = load * max(abs(strips.y[0]), abs(strips.y[-1])) if conditions.by_force[1] else abs(target[1])
    if not abs(second - target[1]) <= TOLERANCE * scale:
        return SECOND, second
    return MET, 0.0


@compiled
def _lengths(strips: Strips, answer: Answer) -> tuple[float, float]:
    """Return the deepest interference in contact, and the largest of the lengths whose differences are the gaps."""
    motion = answer.motion
    deepest, longest = 0.0, abs(motion[0]) + abs(motion[1]) * max(abs(strips.y[0]), abs(strips.y[-1]))
    for i in range(answer.q.size):
        if answer.q[i] > 0.0:
            deepest = max(deepest, motion[0] + motion[1] * strips.y[i] - strips.separation[i])
            longest = max(longest, abs(strips.separation[i]))
    return (deepest if deepest > 0.0 else longest), longest


@inlined
def _lift_and_bend(strips: Strips, kernel: Kernel, answer: Answer) -> tuple[Array, Array]:
    """Return displacement [mm] and curvature [1/mm] of both surfaces together at every strip, on the centre line."""
    y, terms, q, n = strips.y, kernel.terms, answer.q, strips.y.size
    lift, bend, places = np.zeros(n), np.zeros(n), _looked_at(strips, answer)
    for j in range(n):
        if q[j] > 0.0:
            inverse = 1.0 / answer.half_width[j]
            by_bend = q[j] * inverse * inverse
            for k in range(terms.shape[0]):
                sign, offset = terms[k, 0], terms[k, 1]
                weight, high, low = sign * terms[k, 2], sign * strips.high[j] + offset, sign * strips.low[j] + offset
                for i in places:
                    upper = evaluate((high - y[i]) * inverse, kernel.table)
                    lower = evaluate((low - y[i]) * inverse, kernel.table)
                    lift[i] += q[j] * weight * (upper[0] - lower[0])
                    bend[i] += by_bend * weight * (upper[2] - lower[2])
            lift[j] += q[j] * by_own_width(strips.by_width, j, answer.half_width[j])[0]
            if strips.at_depth.size:
                for i in places:
                    lift[i] -= q[j] * strips.at_depth[i, j]
    for k in range(kernel.faces.shape[0]):
        _add_face(strips, kernel, answer, k, lift, bend)
    return lift, bend


@compiled
def _looked_at(strips: Strips, answer: Answer) -> Indices:
    """Return the strips where the bodies bear load or have a separation."""
    n, count = strips.y.size, 0
    found = np.empty(n, np.int64)
    for i in range(n):
        if answer.q[i] > 0.0 or math.isfinite(strips.separation[i]):
            found[count] = i
            count += 1
    return found[:count]


@inlined
def _add_face(strips: Strips, kernel: Kernel, answer: Answer, k: int, lift: Array, bend: Array) -> None:
    """Add what a free side face adds: by its table where place and source are close to it, else by its series."""
    y, q, half_width, table, n = strips.y, answer.q, answer.half_width, kernel.table, strips.y.size
    place, side, share, first = kernel.faces[k, 0], kernel.faces[k, 1], kernel.faces[k, 2], int(kernel.faces[k, 3])
    unit, kept = 0.0, no_squares()
    for j in range(n):
        unit = max(unit, half_width[j] if q[j] > 0.0 else 0.0)
    u, of_edges, work = np.empty(n), np.empty((2, 1 + POWERS, n + TILE)), np.empty((2, n + TILE))
    for i in range(n):
        u[i] = max(side * (place - y[i]), 0.0) / unit
    # Strips adjoin, so that the upper edge of one is the lower edge of the next.
    at_low = max(side * (place - strips.low[0]), 0.0) / unit
    far_terms(u, at_low, kernel.face_tables, first, of_edges[0], work)
    for j in range(n):
        at_high = max(side * (place - strips.high[j]), 0.0) / unit
        of_low, of_high = of_edges[j % 2], of_edges[1 - j % 2]
        far_terms(u, at_high, kernel.face_tables, first, of_high, work)
        inner, outer = min(at_low, at_high), max(at_low, at_high)
        at_low = at_high
        if not q[j] > 0.0:
            continue
        inverse, ratio = 1.0 / half_width[j], (half_width[j] / unit) ** 2
        by_bend = share * q[j] * inverse * inverse
        for i in range(n):
            if (u[i] + inner) * unit * inverse < AWAY:
                near = added_by_face(y[i], strips.low[j], strips.high[j], inverse, kernel, k, kept)
                lift[i] += share * q[j] * near[0]
                bend[i] += by_bend * near[2]
                continue
            within, power, risen, curved = inner <= u[i] < outer, 1.0, 0.0, 0.0
            for p in range(1 + POWERS):
                part = side * (of_low[p, i] - of_high[p, i])
                if within:
                    part += far_whole(u[i], p, kernel.face_tables, first)
                if p == 0:
                    risen = part
                else:
                    power *= ratio
                    risen += power * part * table[POWERS_AT + 2 * p - 2]
                    curved += power * part * table[POWERS_AT + 2 * p - 1]
            lift[i] += share * q[j] * risen
            bend[i] += by_bend * curved
