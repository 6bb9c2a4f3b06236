"""Where the Newton loop starts: independent springs, or the solution on another grid.

On springs (a Winkler foundation) every strip responds to its own load alone, q = d / (K Lambda), with one
logarithm Lambda for the whole contact. That is a convex, piecewise linear problem with a solution for any
of the four pairs of prescribed quantities, found by Newton's method for the approach and by false position for the
tilt.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

SECANTS = 30


@compiled
def started(
    y: Array,
    width: Array,
    curvature: Array,
    separation: Array,
    line_factor: float,
    prescribed: Flags,
    target: Array,
    near_y: Array,
    near_r: Array,
    near_m: Array,
    near_rigid: Array,
) -> tuple[Array, Array, Array]:
    """Return r, m and the rigid motion from a solution on other strips, or from springs if there is none."""
    if near_y.size > 0:
        r, m = prolong(near_y, near_r, near_m, y)
        m[~np.isfinite(separation)] = 0.0
        if np.any(m > 0.0):
            return r, m, np.where(prescribed, near_rigid, target)
    return springs(y, width, curvature, separation, line_factor, prescribed, target)


@compiled
def springs(
    y: Array,
    width: Array,
    curvature: Array,
    separation: Array,
    line_factor: float,
    prescribed: Flags,
    target: Array,
) -> tuple[Array, Array, Array]:
    """Return r, m and the rigid motion of independent springs; arguments as in `nonhertz.strip.newton`."""
    if not (prescribed[1] and target[1] < 0.0):
        return _springs(y, width, curvature, separation, line_factor, prescribed, target)
    # Mirrored, so that two cases that are mirror images of each other start identically to the last bit.
    r, m, rigid = _springs(
        -y[::-1].copy(), width[::-1].copy(), curvature[::-1].copy(), separation[::-1].copy(), line_factor, prescribed,
        target * np.array([1.0, -1.0]),
    )  # fmt: skip
    return r[::-1].copy(), m[::-1].copy(), rigid * np.array([1.0, -1.0])


@compiled
def _springs(
    y: Array,
    width: Array,
    curvature: Array,
    separation: Array,
    line_factor: float,
    prescribed: Flags,
    target: Array,
) -> tuple[Array, Array, Array]:
    half = 0.5 * float(np.sum(width))
    usable = np.flatnonzero(np.isfinite(separation))
    beds = y[usable], width[usable], separation[usable]
    r = curvature / line_factor
    m = np.zeros_like(y)
    rigid = np.zeros(2)
    if usable.size == 0:
        return r, m, rigid
    largest = 0.05 * half
    for _ in range(3):
        stiffness = 1.0 / (2.0 * (math.log(max(2.0 * half / largest, 1.5)) + 1.2))
        rigid = _balance(beds, stiffness, prescribed, target)
        m = np.maximum(rigid[0] + rigid[1] * y - separation, 0.0) * stiffness / r
        largest = max(math.sqrt(np.max(m)), 1e-6 * half)
    return r, m, rigid


@compiled
def _balance(beds: tuple[Array, Array, Array], stiffness: float, prescribed: Flags, target: Array) -> Array:
    """Return approach and tilt of spring ``beds`` (place, width, separation) of this stiffness per unit length."""
    tilt = other = float(target[1])
    if prescribed[1]:
        tilt, other = _tilts(beds, stiffness, prescribed, target)
    approach = _approach(beds, stiffness, tilt, prescribed, target)
    # With nothing in contact the moment is zero too. For a nonzero target take the end of the bracket in contact.
    if target[1] != 0.0 and not np.max(approach + tilt * beds[0] - beds[2]) > 0.0:
        tilt = other
        approach = _approach(beds, stiffness, tilt, prescribed, target)
    return np.array([approach, tilt])


@compiled
def _tilts(beds: tuple[Array, Array, Array], stiffness: float, prescribed: Flags, target: Array) -> tuple[float, float]:
    """Return the two ends of a short bracket around the tilt at which the moment is met."""
    low, excess = 0.0, _excess_moment(beds, stiffness, 0.0, prescribed, target)
    if excess == 0.0:
        return 0.0, 0.0
    reach = np.max(np.abs(beds[0]))
    step = abs(target[0]) + abs(target[1]) / reach
    if prescribed[0]:
        step /= stiffness * np.sum(beds[1])
    high = -math.copysign(step / reach, excess)
    over = _excess_moment(beds, stiffness, high, prescribed, target)
    for _ in range(200):
        if over * excess <= 0.0:
            break
        low, excess, high = high, over, 2.0 * high
        over = _excess_moment(beds, stiffness, high, prescribed, target)
    # False position (Illinois variant): halve the value at an end that stays put.
    for _ in range(SECANTS):
        if over == 0.0 or abs(high - low) <= 1e-10 * (abs(high) + abs(low)):
            break
        middle = high - over * (high - low) / (over - excess)
        found = _excess_moment(beds, stiffness, middle, prescribed, target)
        if found * over < 0.0:
            low, excess = high, over
        else:
            excess *= 0.5
        high, over = middle, found
    return high, low


@compiled
def _approach(
    beds: tuple[Array, Array, Array], stiffness: float, tilt: float, prescribed: Flags, target: Array
) -> float:
    """Return the approach at this tilt: the prescribed one, or the one at which the springs carry the load.

    With all springs acting, in tension where they are too short, the approach is too large. Dropping those in tension
    lowers it, and so on: the load is a convex, piecewise linear function of the approach, on which Newton's method
    descends to the exact answer.
    """
    if not prescribed[0]:
        return float(target[0])
    y, width, separation = beds
    approach = np.inf
    for _ in range(y.size + 1):
        carried, bearing = target[0], 0.0
        for k in range(y.size):
            height = separation[k] - tilt * y[k]
            if height < approach:
                bearing += stiffness * width[k]
                carried += stiffness * width[k] * height
        lower = carried / bearing
        if not lower < approach:
            break
        approach = lower
    return float(approach)


@compiled
def _excess_moment(
    beds: tuple[Array, Array, Array], stiffness: float, tilt: float, prescribed: Flags, target: Array
) -> float:
    y, width, separation = beds
    depth = np.maximum(_approach(beds, stiffness, tilt, prescribed, target) + tilt * y - separation, 0.0)
    return float(stiffness * np.sum(width * y * depth) - target[1])


@compiled
def prolong(y_from: Array, r_from: Array, m_from: Array, y: Array) -> tuple[Array, Array]:
    """Return r and m interpolated to other strips.

    m passes linearly through zero where the contact ends: the first idle strip is given the value that continues
    the line, so that strips of the other grid are in or out of contact according to where it really ends.
    """
    extended = m_from.copy()
    _continue_past_ends(y_from, m_from, extended)
    # The same from the other side.
    _continue_past_ends(y_from[::-1], m_from[::-1], extended[::-1])
    touching = np.flatnonzero(m_from > 0.0)
    m = np.maximum(np.interp(y, y_from, extended), 0.0)
    return np.interp(y, y_from[touching], r_from[touching]), m


@compiled
def _continue_past_ends(y: Array, m: Array, extended: Array) -> None:
    """Extrapolate m into the first idle strip after two in contact, if that gives less than the value there."""
    for at in range(2, m.size):
        if m[at] == 0.0 and m[at - 1] > 0.0 and m[at - 2] > 0.0:
            slope = (m[at - 1] - m[at - 2]) / (y[at - 1] - y[at - 2])
            extended[at] = min(extended[at], m[at - 1] + slope * (y[at] - y[at - 1]))
