"""The angles of rollers as an axis of figures: a turn about where the load points to."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.value import Axis

Array = NDArray[np.float64]

QUARTER, STEP = 90.0, 45.0
"""Degrees, to which the middle of an unrolled row is rounded, and between its ticks."""


def turn_axis(middle: float) -> Axis:
    """Return the axis of the rollers' angles, a turn about a middle [degree]."""
    ticks = middle + np.linspace(-180.0, 180.0, round(360.0 / STEP) + 1)
    return Axis(
        "Angle of the roller, from +y towards +z",
        "angle",
        "°",
        range=(middle - 180.0, middle + 180.0),
        ticks=tuple((tick, f"{tick % 360.0:g}°") for tick in ticks.tolist()),
    )


def loaded_middle(solution: BearingSolution) -> float:
    """Return the multiple of a quarter turn [degree] that is nearest to the direction of the loads."""
    inner = solution.load[:, 0]
    y, z = float(inner @ np.cos(solution.angle)), float(inner @ np.sin(solution.angle))
    if math.hypot(y, z) <= 1e-6 * float(inner.sum()):
        return 0.0
    return QUARTER * round(math.degrees(math.atan2(z, y)) / QUARTER)


def around(degrees: Array, middle: float) -> Array:
    """Return angles within half a turn of the middle."""
    # A roller exactly opposite is on the right, regardless of rounding.
    turned: Array = middle + 180.0 - np.mod(np.round(180.0 - (degrees - middle), 9), 360.0)
    return turned
