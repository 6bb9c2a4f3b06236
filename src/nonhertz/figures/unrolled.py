"""The common part of the maps of the pressures of all rollers and of their view in perspective."""

from __future__ import annotations

import numpy as np

from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution, UnrolledPressure


def unrolled_pressures(solution: BearingSolution, points: int) -> list[list[UnrolledPressure]]:
    """Return the pressures at both rings of each row, at so many places over the length of the rollers."""
    rows = []
    for number, row in enumerate(solution.bearing.rows):
        y = 0.5 * row.bearing.roller_length * np.linspace(-1.0, 1.0, points)
        rows.append([solution.unrolled_pressure(ring, row=number, y=y) for ring in RINGS])
    return rows


def ring_heading(solution: BearingSolution, ring: str, row: int) -> str:
    """Return the heading of a panel: the ring, and the row where there are several."""
    among = f", row {row + 1}" if len(solution.bearing.rows) > 1 else ""
    return f"Pressure at the {ring} ring{among}"
