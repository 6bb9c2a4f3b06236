"""Which pressures of the strips have a meaning of their own, and which only grow with refinement."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.solution import EdgeKind, EdgePressure, Solution

Bools = NDArray[np.bool_]

SAME = 1e-6


def singular_ends(solution: Solution) -> list[EdgePressure]:
    """Return the ends at which the pressure has no limit, ascending."""
    return [edge for edge in solution.edge_pressure if edge.kind is EdgeKind.SINGULAR]


def away_from_ends(solution: Solution) -> Bools:
    """Return which strips in contact lie more than a half-width from singular ends, shape (strips,).

    Nearer to such an end the pressure grows with every refinement: as a maximum it says nothing.
    """
    away = solution.line_load > 0.0
    for edge, half_width in zip(solution.edge_pressure, solution.half_width[[0, -1]], strict=True):
        if edge.kind is EdgeKind.SINGULAR:
            away &= np.abs(solution.y - edge.y) > half_width
    return away


def largest_away(solution: Solution) -> tuple[int, ...]:
    """Return the strip of the largest pressure `away_from_ends`: both of a mirrored pair, none if none is away."""
    pressure = np.where(away_from_ends(solution), solution.peak_pressure, 0.0)
    largest = float(pressure.max())
    if largest <= 0.0:
        return ()
    equal = np.flatnonzero(pressure >= (1.0 - SAME) * largest).tolist()
    # Two neighbours are one flat crest, and many are no marked place at all.
    is_pair = len(equal) == 2 and equal[1] - equal[0] > 1
    return tuple(equal) if is_pair else (int(pressure.argmax()),)


def at_corner(solution: Solution, strip: int) -> bool:
    """Return whether a strip is the largest pressure and at a corner of the profile, where it has no limit either."""
    return solution.peaks_at_corner and bool(solution.peak_pressure[strip] >= (1.0 - SAME) * solution.max_pressure)
