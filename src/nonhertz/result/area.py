"""The contact area of strips: its outline, piece by piece, and the pressure in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.result.solution import Solution

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Outline:
    """One connected piece of the contact area.

    Attributes
    ----------
    y : ndarray, shape (points,)
        Axial positions [mm]: one end, the centres of the strips, the other end.
    half_width : ndarray, shape (points,)
        Half-width a [mm] of the element's own pressure shape.
    pressure : ndarray, shape (points,)
        The element's own pressure [MPa] at x = 0.
    """

    y: Array
    half_width: Array
    pressure: Array

    def closed(self) -> tuple[Array, Array]:
        """Return the closed line around the piece."""
        along = np.concatenate([self.y, self.y[::-1], self.y[:1]])
        across = np.concatenate([self.half_width, -self.half_width[::-1], self.half_width[:1]])
        return along, across


def outlines(solution: Solution) -> list[Outline]:
    """Return the pieces of the contact area, ascending in y.

    Between the centres of its first and last strips a piece follows the strips. Beyond, it tapers to a point at
    the strip's outer edge if the surfaces separate there, and is cut off square if the strips, and so a body,
    end.
    """
    touching = np.flatnonzero(solution.line_load > 0.0)
    if touching.size == 0:
        return []
    pieces = []
    for strips in np.split(touching, np.flatnonzero(np.diff(touching) > 1) + 1):
        first, last = strips[0], strips[-1]
        y = solution.y[strips]
        half_width = solution.element_half_width[strips]
        pressure = solution.element.centre_factor * solution.line_load[strips] / half_width
        cut = (float(first == 0), float(last == solution.strips - 1))
        low, high = y[0] - 0.5 * solution.strip_width[first], y[-1] + 0.5 * solution.strip_width[last]
        across = (np.concatenate([[cut[0] * of[0]], of, [cut[1] * of[-1]]]) for of in (half_width, pressure))
        pieces.append(Outline(np.concatenate([[low], y, [high]]), *across))
    return pieces


def element_peak(solution: Solution) -> float:
    """Return the maximum pressure [MPa] in the middle of the element's own shape, away from singular ends.

    That is the maximum pressure times the centre pressure of the shape over that of the Hertz ellipse of equal load;
    1 MPa without a pressure.
    """
    of_equivalent = 0.5 * np.pi * solution.element.hertz_ratio * solution.element.centre_factor
    return float(of_equivalent * solution.max_pressure) or 1.0
