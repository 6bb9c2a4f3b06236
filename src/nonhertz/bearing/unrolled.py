"""A bearing's rollers side by side: which of them bear load, and the pressure of all over angle and y."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.result.solution import ReadOnly

Array = NDArray[np.float64]

POINTS = 401  # along a roller


@dataclass(frozen=True, eq=False, repr=False)
class UnrolledPressure(ReadOnly):
    """The centre-line pressure between the rollers of a row and one of its rings.

    Attributes
    ----------
    ring : {"inner", "outer"}
        Which ring.
    row : int
        Which row of rollers, from 0.
    angle : ndarray, shape (rollers,)
        Where the rollers are [rad].
    y : ndarray, shape (n,)
        Places along the rollers' profiles [mm].
    pressure : ndarray, shape (rollers, n)
        Pressure on the line x = 0 [MPa], as `Solution.pressure` interpolates it: zero out of contact, and in a strip at
        a singular end not a converged value.
    """

    ring: str
    row: int
    angle: Array
    y: Array
    pressure: Array


def row_slices(bearing: RollerBearing | Paired) -> list[slice]:
    """Return which rollers of all belong to each row."""
    ends = np.cumsum([0, *(row.bearing.rollers for row in bearing.rows)]).tolist()
    return [slice(low, high) for low, high in pairwise(ends)]


def loaded_shares(bearing: RollerBearing | Paired, load: Array) -> Array:
    """Return the share of each row's rollers that the inner ring loads.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    load : ndarray, shape (..., rollers, 2)
        Loads at the inner and the outer ring [N].

    Returns
    -------
    ndarray, shape (..., rows)
    """
    # At speed every roller presses on the outer ring; between the rings only these bear load.
    loaded = load[..., 0] > 0.0
    return np.stack([loaded[..., these].mean(axis=-1) for these in row_slices(bearing)], axis=-1)
