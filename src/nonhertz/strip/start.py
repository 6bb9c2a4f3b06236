"""Where the Newton loop starts: independent springs, or the solution on another grid.

On springs (a Winkler foundation) every strip responds to its own load alone, q = d / (K Lambda), with one
logarithm Lambda for the whole contact. That is a convex, piecewise linear problem with a solution for any
of the four pairs of prescribed quantities, found by Newton's method for the approach and by false position for the
tilt.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from nonhertz.compiled import compiled, inlined
from nonhertz.strip.newton import touching
from nonhertz.strip.records import Array, BoundaryConditions, Kernel, Strips, Unknowns

SECANTS = 30


class Bed(NamedTuple):
    """Springs side by side: where they are, how wide, and how far the other body is above them, shape (n,) each."""

    y: Array
    width: Array
    height: Array


@compiled
def winkler_start(strips: Strips, conditions: BoundaryConditions, kernel: Kernel, unknowns: Unknowns) -> None:
    """Fill ``unknowns`` with r, m and the rigid motion of independent springs."""
    # Mirrored where the moment is negative, so that two cases that are mirror images of each other start identically
    # to the last bit.
    side = -1.0 if conditions.by_force[1] and conditions.target[1] < 0.0 else 1.0
    n = strips.y.size
    half, count = 0.0, 0
    for i in range(n):
        half += 0.5 * (strips.high[i] - strips.low[i])
        count += 1 if math.isfinite(strips.separation[i]) else 0
        unknowns.r[i] = strips.curvature[i] / kernel.line_factor
        unknowns.m[i] = 0.0
    unknowns.rigid[0] = unknowns.rigid[1] = 0.0
    if count == 0:
        return
    bed = Bed(np.empty(count), np.empty(count), np.empty(count))
    count = 0
    for k in range(n):
        i = k if side > 0.0 else n - 1 - k
        if math.isfinite(strips.separation[i]):
            bed.y[count] = side * strips.y[i]
            bed.width[count] = strips.high[i] - strips.low[i]
            bed.height[count] = strips.separation[i]
            count += 1
    target = np.empty(2)
    target[0], target[1] = conditions.target[0], side * conditions.target[1]
    turned = BoundaryConditions(conditions.by_force, target)
    largest = 0.05 * half
    for _ in range(3):
        stiffness = 1.0 / (2.0 * (math.log(max(2.0 * half / largest, 1.5)) + 1.2))
        approach, tilt = _balance(bed, stiffness, turned)
        unknowns.rigid[0], unknowns.rigid[1] = approach, side * tilt
        widest = 0.0
        for i in range(n):
            depth = approach + side * tilt * strips.y[i] - strips.separation[i]
            unknowns.m[i] = depth * stiffness / unknowns.r[i] if depth > 0.0 else 0.0
            widest = max(widest, unknowns.m[i])
        largest = max(math.sqrt(widest), 1e-6 * half)


@compiled
def _balance(bed: Bed, stiffness: float, conditions: BoundaryConditions) -> tuple[float, float]:
    """Return approach and tilt of springs of this stiffness per unit length."""
    tilt = other = float(conditions.target[1])
    if conditions.by_force[1]:
        tilt, other = _tilts(bed, stiffness, conditions)
    approach = _approach(bed, stiffness, tilt, conditions)
    # With nothing in contact the moment is zero too. For a nonzero target take the end of the bracket in contact.
    deepest = -np.inf
    for i in range(bed.y.size):
        deepest = max(deepest, approach + tilt * bed.y[i] - bed.height[i])
    if conditions.target[1] != 0.0 and not deepest > 0.0:
        tilt = other
        approach = _approach(bed, stiffness, tilt, conditions)
    return approach, tilt


@compiled
def _tilts(bed: Bed, stiffness: float, conditions: BoundaryConditions) -> tuple[float, float]:
    """Return the two ends of a short bracket around the tilt at which the moment is met."""
    low, excess = 0.0, _excess_moment(bed, stiffness, 0.0, conditions)
    if excess == 0.0:
        return 0.0, 0.0
    reach = length = 0.0
    for i in range(bed.y.size):
        reach = max(reach, abs(bed.y[i]))
        length += bed.width[i]
    step = abs(conditions.target[0]) + abs(conditions.target[1]) / reach
    if conditions.by_force[0]:
        step /= stiffness * length
    high = -math.copysign(step / reach, excess)
    over = _excess_moment(bed, stiffness, high, conditions)
    for _ in range(200):
        if over * excess <= 0.0:
            break
        low, excess, high = high, over, 2.0 * high
        over = _excess_moment(bed, stiffness, high, conditions)
    # False position (Illinois variant): halve the value at an end that stays put.
    for _ in range(SECANTS):
        if over == 0.0 or abs(high - low) <= 1e-10 * (abs(high) + abs(low)):
            break
        middle = high - over * (high - low) / (over - excess)
        found = _excess_moment(bed, stiffness, middle, conditions)
        if found * over < 0.0:
            low, excess = high, over
        else:
            excess *= 0.5
        high, over = middle, found
    return high, low


@compiled
def _approach(bed: Bed, stiffness: float, tilt: float, conditions: BoundaryConditions) -> float:
    """Return the approach at this tilt: the prescribed one, or the one at which the springs carry the load.

    With all springs acting, in tension where they are too short, the approach is too large. Dropping those in tension
    lowers it, and so on: the load is a convex, piecewise linear function of the approach, on which Newton's method
    descends to the exact answer.
    """
    if not conditions.by_force[0]:
        return float(conditions.target[0])
    approach = np.inf
    for _ in range(bed.y.size + 1):
        carried, bearing = conditions.target[0], 0.0
        for k in range(bed.y.size):
            height = bed.height[k] - tilt * bed.y[k]
            if height < approach:
                bearing += stiffness * bed.width[k]
                carried += stiffness * bed.width[k] * height
        lower = carried / bearing
        if not lower < approach:
            break
        approach = lower
    return float(approach)


@compiled
def _excess_moment(bed: Bed, stiffness: float, tilt: float, conditions: BoundaryConditions) -> float:
    approach, moment = _approach(bed, stiffness, tilt, conditions), 0.0
    for i in range(bed.y.size):
        moment += bed.width[i] * bed.y[i] * max(approach + tilt * bed.y[i] - bed.height[i], 0.0)
    return float(stiffness * moment - conditions.target[1])


@inlined
def prolong(near_y: Array, near: Unknowns, strips: Strips, conditions: BoundaryConditions, unknowns: Unknowns) -> bool:
    """Fill ``unknowns`` from a solution on other strips, at ``near_y``; return whether any strip is in contact.

    m passes linearly through zero where the contact ends: the first idle strip is given the value that continues
    the line, so that strips of the other grid are in or out of contact according to where it really ends.
    """
    extended = near.m.copy()
    for side in (1, -1):
        _continue_past_ends(near_y, near.m, side, extended)
    bearing = touching(near.m)
    any_touches = False
    left, left_bearing = 0, 0
    for i in range(strips.y.size):
        y = strips.y[i]
        while left + 2 < near_y.size and near_y[left + 1] <= y:
            left += 1
        while left_bearing + 2 < bearing.size and near_y[bearing[left_bearing + 1]] <= y:
            left_bearing += 1
        m = _between(near_y, extended, left, min(left + 1, near_y.size - 1), y)
        if not (m > 0.0 and math.isfinite(strips.separation[i])):
            m = 0.0
        beside = bearing[min(left_bearing + 1, bearing.size - 1)]
        unknowns.r[i] = _between(near_y, near.r, bearing[left_bearing], beside, y)
        unknowns.m[i] = m
        any_touches = any_touches or m > 0.0
    for k in range(2):
        unknowns.rigid[k] = near.rigid[k] if conditions.by_force[k] else conditions.target[k]
    return any_touches


@compiled
def _between(y_of: Array, values: Array, left: int, right: int, y: float) -> float:
    """Return the value at ``y`` on the straight line between two neighbours, constant beyond both."""
    if y <= y_of[left] or left == right:
        return float(values[left])
    if y >= y_of[right]:
        return float(values[right])
    share = (y - y_of[left]) / (y_of[right] - y_of[left])
    return float(values[left] + share * (values[right] - values[left]))


@compiled
def _continue_past_ends(y: Array, m: Array, step: int, extended: Array) -> None:
    """Extrapolate m into the first idle strip after two in contact, if that gives less than the value there."""
    for k in range(2, m.size):
        at = k if step > 0 else m.size - 1 - k
        before, second = at - step, at - 2 * step
        if m[at] == 0.0 and m[before] > 0.0 and m[second] > 0.0:
            slope = (m[before] - m[second]) / (y[before] - y[second])
            extended[at] = min(extended[at], m[before] + slope * (y[at] - y[before]))
