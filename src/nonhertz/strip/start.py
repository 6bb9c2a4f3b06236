"""Where the Newton loop starts: independent springs, or the solution on a coarser grid.

On springs (a Winkler foundation) every strip answers to its own load alone, q = d / (K Lambda), with one
logarithm Lambda for the whole contact. That is a convex, piecewise linear problem which has a solution for any
of the four pairs of prescribed quantities, found by sorting for the approach and by bisection for the tilt.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.strip.compiled import compiled

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

BISECTIONS = 60


@compiled
def springs(
    y: Array,
    width: Array,
    curvature: Array,
    separation: Array,
    line_factor: float,
    prescribed: Flags,
    target: Array,
    r: Array,
    m: Array,
    rigid: Array,
) -> None:
    """Fill ``r``, ``m`` and ``rigid`` with the answer of independent springs; arguments as in `newton`."""
    half = 0.5 * float(np.sum(width))
    usable = np.flatnonzero(np.isfinite(separation))
    y_used, width_used, separation_used = y[usable], width[usable], separation[usable]
    r[:] = curvature / line_factor
    largest = 0.05 * half
    for _ in range(3):
        stiffness = 1.0 / (2.0 * (math.log(max(2.0 * half / largest, 1.5)) + 1.2))
        _balance(y_used, width_used * stiffness, separation_used, prescribed, target, rigid)
        m[:] = np.maximum(rigid[0] + rigid[1] * y - separation, 0.0) * stiffness / r
        largest = max(math.sqrt(np.max(m)), 1e-6 * half)


@compiled
def _balance(
    y: Array, stiffness: Array, separation: Array, prescribed: Flags, target: Array, rigid: Array
) -> None:
    """Find the approach and tilt of springs under the prescribed pair."""
    if not prescribed[1]:
        rigid[1] = target[1]
        rigid[0] = _approach(y, stiffness, separation, prescribed, target, rigid[1])
        return
    side = _excess_moment(y, stiffness, separation, prescribed, target, 0.0)
    low, high = 0.0, 0.0
    if side != 0.0:
        reach = np.max(np.abs(y))
        step = abs(target[0]) + abs(target[1]) / reach
        if prescribed[0]:
            step /= np.sum(stiffness)
        high = -math.copysign(step / reach, side)
        for _ in range(200):
            if _excess_moment(y, stiffness, separation, prescribed, target, high) * side <= 0.0:
                break
            low, high = high, 2.0 * high
        for _ in range(BISECTIONS):
            middle = 0.5 * (low + high)
            if _excess_moment(y, stiffness, separation, prescribed, target, middle) * side > 0.0:
                low = middle
            else:
                high = middle
    # A moment may vanish because nothing touches; any other asks for the end of the bracket where something does.
    rigid[1] = high
    rigid[0] = _approach(y, stiffness, separation, prescribed, target, high)
    if target[1] != 0.0 and np.max(rigid[0] + rigid[1] * y - separation) <= 0.0:
        rigid[1] = low
        rigid[0] = _approach(y, stiffness, separation, prescribed, target, low)


@compiled
def _approach(
    y: Array, stiffness: Array, separation: Array, prescribed: Flags, target: Array, tilt: float
) -> float:
    """Return the approach at this tilt: the prescribed one, or the one at which springs carry the load."""
    if not prescribed[0]:
        return float(target[0])
    height = separation - tilt * y
    order = np.argsort(height)
    total = weighted = 0.0
    approach = 0.0
    for k in range(order.size):
        total += stiffness[order[k]]
        weighted += stiffness[order[k]] * height[order[k]]
        approach = (target[0] + weighted) / total
        if k + 1 == order.size or approach <= height[order[k + 1]]:
            break
    return approach


@compiled
def _excess_moment(
    y: Array, stiffness: Array, separation: Array, prescribed: Flags, target: Array, tilt: float
) -> float:
    approach = _approach(y, stiffness, separation, prescribed, target, tilt)
    loads = stiffness * np.maximum(approach + tilt * y - separation, 0.0)
    return float(np.sum(loads * y) - target[1])


@compiled
def prolong(y_from: Array, r_from: Array, m_from: Array, y: Array, r: Array, m: Array) -> None:
    """Interpolate ``r`` and ``m`` to other strips.

    m runs linearly through zero where the contact ends: the first idle strip is given the value that continues
    the line, so that strips of the other grid are counted in or out by where the contact really ends.
    """
    touching = np.flatnonzero(m_from > 0.0)
    extended = m_from.copy()
    n = m_from.size
    for i in range(n):
        if m_from[i] == 0.0:
            if i + 2 < n and m_from[i + 1] > 0.0 and m_from[i + 2] > 0.0:
                slope = (m_from[i + 2] - m_from[i + 1]) / (y_from[i + 2] - y_from[i + 1])
                extended[i] = min(extended[i], m_from[i + 1] - slope * (y_from[i + 1] - y_from[i]))
            if i >= 2 and m_from[i - 1] > 0.0 and m_from[i - 2] > 0.0:
                slope = (m_from[i - 1] - m_from[i - 2]) / (y_from[i - 1] - y_from[i - 2])
                extended[i] = min(extended[i], m_from[i - 1] + slope * (y_from[i] - y_from[i - 1]))
    m[:] = np.maximum(np.interp(y, y_from, extended), 0.0)
    r[:] = np.interp(y, y_from[touching], r_from[touching])
