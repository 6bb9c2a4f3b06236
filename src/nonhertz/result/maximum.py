"""The maximum pressure and the largest half-width that are independent of refinement.

Towards a sharp end, a corner of the profile at which a contact ends, or the end of strips that cut a contact off,
the pressure of strips and cells grows with every refinement. So only places more than a half-width from such an end
count; closer to it the true pressure is not a semi-ellipse across either. Usually the largest of these pressures is at
the border itself, which need not be in the middle of a strip: it is interpolated there, by the power law of the
distance through the two neighbours.

The same places count for the half-width. Towards a sharp end the true contact flares, that of strips less: on
half-spaces, the half-width of the last strip is 14 % too small, that at the border 0.1 % (docs/explain/end-table.md).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.native import core

if TYPE_CHECKING:
    from nonhertz.result.solved import Solved

Array = NDArray[np.float64]

SAME = 1e-6  # relative difference up to which two pressures count as equally large


def distance_beyond(y: Array, half_width: Array, ends: Array) -> Array:
    """Return the distance of places from the nearest end less a half-width; infinite if there is no end.

    Parameters
    ----------
    y : ndarray, shape (n,) or (..., n)
        Places [mm].
    half_width : ndarray, shape (..., n)
        Half-widths there [mm].
    ends : ndarray, shape (..., k)
        Positions of singular ends [mm]; NaN for no end.

    Returns
    -------
    ndarray, shape (..., n)
        Distances [mm], negative within a half-width of an end.
    """
    return _distances(y, ends) - half_width


def largest_pressure(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[float, float]:
    """Return the maximum pressure more than a half-width from the ends, and its position.

    If the contact is too short for that, it is the pressure where the nearest end is farthest away, in half-widths.

    Parameters
    ----------
    y : ndarray, shape (n,)
        Centres of strips or rows of cells [mm], ascending.
    pressure, half_width : ndarray, shape (n,)
        Values of each [MPa, mm], zero out of contact.
    ends : ndarray, shape (k,)
        Positions of singular ends [mm].

    Returns
    -------
    tuple of float
        Pressure, and place [mm].
    """
    places, pressures, at = values_that_count(y, pressure, half_width, ends)
    return float(pressures.max()), float(places[at])


def largest_half_width(y: Array, half_width: Array, ends: Array) -> tuple[float, float]:
    """Return the largest half-width more than a half-width from the ends, and its position.

    Parameters and results are those of `largest_pressure`.
    """
    return largest_pressure(y, half_width, half_width, ends)


def values_that_count(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[Array, Array, int]:
    """Return the places that `largest_pressure` considers, the pressures there, and the number of the largest.

    First those of the strips, then those between neighbours; zero where they do not count. If pressures are equal up to
    rounding, such as maxima that mirror each other, the one with the smallest y is taken.
    """
    return core.values_that_count(y, pressure, half_width, ends)


def places_of_largest(solution: Solved) -> tuple[float, ...]:
    """Return the positions of the maximum pressure [mm], ascending: both if they mirror each other."""
    if not solution.contact_y:
        return ()
    places, values, _ = values_that_count(
        solution.y, solution.largest_across, solution.half_width, singular_y(solution)
    )
    places, values = places[values > 0.0], values[values > 0.0]
    order = np.argsort(places)
    equal = np.flatnonzero(values[order] >= (1.0 - SAME) * values.max())
    # Two neighbours are one flat crest, and more than two are not a distinct place at all.
    if equal.size == 2 and equal[1] - equal[0] > 1:
        return tuple(places[order][equal].tolist())
    return (solution.max_pressure_y,)


def singular_y(solution: Solved) -> Array:
    """Return the positions of the singular ends [mm]."""
    return np.array([end.y for end in solution.singular_ends])


def _distances(y: Array, ends: Array) -> Array:
    """Return the distances of places from the nearest end; infinite if there is none."""
    if ends.shape[-1] == 0:
        return np.full((*ends.shape[:-1], y.shape[-1]), np.inf)
    distance = np.abs(y[..., None] - ends[..., None, :])
    nearest: Array = np.where(np.isnan(distance), np.inf, distance).min(axis=-1)
    return nearest
