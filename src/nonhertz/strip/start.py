"""Where the Newton loop starts: independent springs, or the solution on a coarser grid.

On springs (a Winkler foundation) every strip answers to its own load alone, q = d / (K Lambda), with one
logarithm Lambda for the whole contact. That is a convex, piecewise linear problem which has a solution for any
of the four pairs of prescribed quantities, found by sorting for the approach and by false position for the tilt.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

SECANTS = 30


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
    half = 0.5 * float(np.sum(width))
    usable = np.isfinite(separation)
    foundation = _Foundation(y[usable], width[usable], separation[usable], prescribed, target)
    r = curvature / line_factor
    m = np.zeros_like(y)
    largest = 0.05 * half
    for _ in range(3):
        stiffness = 1.0 / (2.0 * (math.log(max(2.0 * half / largest, 1.5)) + 1.2))
        rigid = foundation.balance(stiffness)
        m = np.maximum(rigid[0] + rigid[1] * y - separation, 0.0) * stiffness / r
        largest = max(math.sqrt(float(np.max(m))), 1e-6 * half)
    return r, m, rigid


@dataclass(frozen=True)
class _Foundation:
    """Springs under the prescribed pair of quantities."""

    y: Array
    width: Array
    separation: Array
    prescribed: Flags
    target: Array

    def balance(self, stiffness: float) -> Array:
        """Return approach and tilt on springs of this stiffness per unit of length."""
        tilts = self._tilts(stiffness) if self.prescribed[1] else (float(self.target[1]),)
        # A moment may vanish because nothing touches; any other asks for the end of the bracket where something does.
        for tilt in tilts:
            rigid = np.array([self._approach(stiffness, tilt), tilt])
            if self.target[1] == 0.0 or np.max(rigid[0] + tilt * self.y - self.separation) > 0.0:
                break
        return rigid

    def _tilts(self, stiffness: float) -> tuple[float, ...]:
        """Return the two ends of a short bracket around the tilt at which the moment is met."""
        low, excess = 0.0, self._excess_moment(stiffness, 0.0)
        if excess == 0.0:
            return (0.0,)
        reach = float(np.max(np.abs(self.y)))
        step = abs(self.target[0]) + abs(self.target[1]) / reach
        if self.prescribed[0]:
            step /= stiffness * float(np.sum(self.width))
        high = -math.copysign(step / reach, excess)
        over = self._excess_moment(stiffness, high)
        for _ in range(200):
            if over * excess <= 0.0:
                break
            low, excess, high = high, over, 2.0 * high
            over = self._excess_moment(stiffness, high)
        return self._narrowed(stiffness, low, excess, high, over)

    def _narrowed(self, stiffness: float, low: float, excess: float, high: float, over: float) -> tuple[float, float]:
        """Return the ends of the bracket after false position, which halves an end's weight when that stays."""
        for _ in range(SECANTS):
            if over == 0.0 or abs(high - low) <= 1e-10 * (abs(high) + abs(low)):
                break
            middle = high - over * (high - low) / (over - excess)
            found = self._excess_moment(stiffness, middle)
            if found * over < 0.0:
                low, excess = high, over
            else:
                excess *= 0.5
            high, over = middle, found
        return (high, low)

    def _approach(self, stiffness: float, tilt: float) -> float:
        """Return the approach at this tilt: the prescribed one, or the one at which the springs carry the load.

        With the springs in the order in which they come to bear, the approach at which the first k carry the load
        follows from sums; the right k is the first whose approach leaves the next spring untouched.
        """
        if not self.prescribed[0]:
            return float(self.target[0])
        height = self.separation - tilt * self.y
        order = np.argsort(height)
        height, width = height[order], stiffness * self.width[order]
        approach = (self.target[0] + np.cumsum(width * height)) / np.cumsum(width)
        untouched = approach[:-1] <= height[1:]
        return float(approach[np.argmax(untouched)] if np.any(untouched) else approach[-1])

    def _excess_moment(self, stiffness: float, tilt: float) -> float:
        depth = np.maximum(self._approach(stiffness, tilt) + tilt * self.y - self.separation, 0.0)
        return float(stiffness * np.sum(self.width * self.y * depth) - self.target[1])


def prolong(y_from: Array, r_from: Array, m_from: Array, y: Array) -> tuple[Array, Array]:
    """Return r and m interpolated to other strips.

    m runs linearly through zero where the contact ends: the first idle strip is given the value that continues
    the line, so that strips of the other grid are counted in or out by where the contact really ends.
    """
    touching = m_from > 0.0
    extended = m_from.copy()
    for side in (1, -1):
        # A view with the contact coming first: idle strips whose two neighbours on this side touch.
        m, place, beyond = m_from[::side], y_from[::side], extended[::side]
        at = np.flatnonzero((m[2:] == 0.0) & (m[1:-1] > 0.0) & (m[:-2] > 0.0)) + 2
        slope = (m[at - 1] - m[at - 2]) / (place[at - 1] - place[at - 2])
        beyond[at] = np.minimum(beyond[at], m[at - 1] + slope * (place[at] - place[at - 1]))
    m = np.maximum(np.interp(y, y_from, extended), 0.0)
    return np.interp(y, y_from[touching], r_from[touching]), m
