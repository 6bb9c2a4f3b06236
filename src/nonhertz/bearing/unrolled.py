"""A bearing's rollers side by side: which of them bear load, and the pressure of all over angle and y."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.errors import InputError
from nonhertz.inputs.checks import numbers
from nonhertz.result.solution import ReadOnly, Solution

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


def unrolled(
    contacts: Sequence[Solution | None], *, ring: str, row: int, angle: Array, length: float, y: ArrayLike | None
) -> UnrolledPressure:
    """Return the pressures of a row's contacts with a ring on the same places along the rollers.

    Parameters
    ----------
    contacts : sequence of Solution or None
        Of each roller; None bears no load.
    ring, row, angle
        As in `UnrolledPressure`.
    length : float
        Of the rollers [mm].
    y : array_like or None
        Places along the rollers [mm]; evenly over their length if None.

    Raises
    ------
    InputError
        If the places are not a row of numbers.
    """
    remedy = "give places along the rollers in mm, or leave it out"
    places = 0.5 * length * np.linspace(-1.0, 1.0, POINTS) if y is None else np.array(numbers("y", y, remedy))
    if places.ndim != 1 or not places.size:
        raise InputError("y", y, "be a row of numbers", remedy)
    pressure = np.zeros((len(contacts), places.size))
    known: dict[int, Array] = {}  # rollers on both sides of a load share a solution
    for of_roller, contact in zip(pressure, contacts, strict=True):
        if contact is not None:
            if id(contact) not in known:
                known[id(contact)] = contact.pressure(0.0, places)
            of_roller[:] = known[id(contact)]
    return UnrolledPressure(ring, row, angle, places, pressure)
