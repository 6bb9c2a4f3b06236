"""The width of a footprint across the contact, from the pressures of its cells."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def half_widths(pressure: Array, dx: float) -> Array:
    """Return the half-width [mm] of each row of cells; see `PatchSolution.half_width`."""
    width = np.zeros(pressure.shape[1])
    for j in np.flatnonzero((pressure > 0.0).any(axis=0)):
        column = pressure[:, j]
        width[j] = 0.5 * dx * (_reach(column) + _reach(column[::-1]) - column.size)
    return width


def _reach(column: Array) -> float:
    """Return the (fractional) number of cells from the low end of a column to the upper edge of the pressure."""
    last = int(np.flatnonzero(column)[-1])
    inner, middle, outer = column[last - 2 : last + 1] ** 2 if last >= 2 else (0.0, 0.0, 0.0)
    if not inner > middle > outer:
        return last + 1.0
    near, far = outer / (middle - outer), middle / (inner - middle) - 1.0
    return last + 0.5 + float(np.clip(0.5 * (near + far), -0.5, 1.5))
