"""The forces on the inner ring of a loaded bearing, as directions and in words."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mrad, newton
from nonhertz.bearing.solution import BearingSolution

Array = NDArray[np.float64]

NO_FORCE = 1e-9  # of the sum of the rollers' loads


def directions(solution: BearingSolution) -> dict[str, Array]:
    """Return the unit vectors of the radial and the axial force on the ring, if they act."""
    force = solution.force[:3]
    least = NO_FORCE * float(solution.load.sum())
    units = {}
    radial = math.hypot(force[1], force[2])
    if radial > least:
        units["radial"] = np.array([0.0, force[1] / radial, force[2] / radial])
    if abs(force[0]) > least:
        units["axial"] = np.array([math.copysign(1.0, force[0]), 0.0, 0.0])
    return units


def conditions(solution: BearingSolution) -> str:
    """Return what was solved: the bearing, the forces on its inner ring, and the method."""
    rows = [row.bearing for row in solution.bearing.rows]
    same = len({(type(bearing), bearing.rollers) for bearing in rows}) == 1
    kinds = [f"{bearing.kind.capitalize()}, {bearing.rollers} rollers" for bearing in (rows[:1] if same else rows)]
    acting = [
        f"{name} {newton(float(solution.force[:3] @ (abs(way) if name == 'axial' else way))):.4g}"
        for name, way in directions(solution).items()
    ]
    tilt = math.hypot(*solution.displacement[3:])
    acting.append(f"tilt {mrad(tilt if tilt > 1e-9 else 0.0):.3g}")
    acting.append(f"by {solution.method}")
    kinds = [f"{len(rows)} rows: {kinds[0]} each"] if same and len(rows) > 1 else kinds
    return "; ".join([*kinds, ", ".join(acting)])
