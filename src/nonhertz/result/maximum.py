"""The largest pressure and the largest half-width that are independent of refinement.

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

if TYPE_CHECKING:
    from nonhertz.result.protocol import Solved

Array = NDArray[np.float64]

SAME = 1e-6  # relative difference up to which two pressures count as equally large


def distance_beyond(y: Array, half_width: Array, ends: Array) -> Array:
    """Return how much farther than a half-width places are from the nearest end, infinite where there is none.

    Parameters
    ----------
    y : ndarray, shape (n,) or (..., n)
        Places [mm].
    half_width : ndarray, shape (..., n)
        Half-widths there [mm].
    ends : ndarray, shape (..., k)
        Where the pressure has no limit [mm]; nan for no end.

    Returns
    -------
    ndarray, shape (..., n)
        Distances [mm], negative within a half-width of an end.
    """
    return _nearest(y, ends) - half_width


def largest_pressure(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    """Return the largest pressures more than a half-width from the ends, for many contacts, and where they are.

    If a contact is too short for that, it is the pressure where the nearest end is farthest away, in half-widths.

    Parameters
    ----------
    y : ndarray, shape (n,) or (..., n)
        Centres of strips or rows of cells [mm], ascending.
    pressure, half_width : ndarray, shape (..., n)
        Of each [MPa, mm], zero out of contact.
    ends : ndarray, shape (..., k)
        Where the pressure has no limit [mm]; nan for no end.

    Returns
    -------
    tuple of ndarray, shape (...)
        Pressures, and places [mm].
    """
    places, found = counted(y, pressure, half_width, ends)
    at = found.argmax(axis=-1)[..., None]
    return np.take_along_axis(found, at, -1)[..., 0], np.take_along_axis(places, at, -1)[..., 0]


def largest_half_width(y: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    """Return the largest half-widths more than a half-width from the ends, for many contacts, and where they are.

    Parameters and results are those of `largest_pressure`.
    """
    return largest_pressure(y, half_width, half_width, ends)


def counted(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    """Return all places that `largest_pressure` considers, and the pressures there, zero where they do not count."""
    nearest = _nearest(y, ends)
    beyond = nearest - half_width
    values = np.where(beyond > 0.0, pressure, 0.0)
    places = np.broadcast_to(y, values.shape)
    crossing = (beyond[..., 1:] > 0.0) != (beyond[..., :-1] > 0.0)
    crossing &= (pressure[..., 1:] > 0.0) & (pressure[..., :-1] > 0.0)
    if np.any(crossing):
        borders, at = np.zeros(crossing.shape), np.zeros(crossing.shape)
        at[crossing], borders[crossing] = _at_borders(np.nonzero(crossing), y, pressure, half_width, ends)
        values, places = np.concatenate([values, borders], axis=-1), np.concatenate([places, at], axis=-1)
    short = (values.max(axis=-1) == 0.0) & (pressure.max(axis=-1) > 0.0)
    if np.any(short):
        of_width = np.where(pressure > 0.0, nearest / np.where(half_width > 0.0, half_width, 1.0), -1.0)
        farthest = np.arange(y.shape[-1]) == of_width.argmax(axis=-1)[..., None]
        values[..., : y.shape[-1]] = np.where(short[..., None] & farthest, pressure, values[..., : y.shape[-1]])
    return places, values


def _at_borders(
    crossing: tuple[NDArray[np.intp], ...], y: Array, pressure: Array, half_width: Array, ends: Array
) -> tuple[Array, Array]:
    """Return the places a half-width from an end, each between two neighbouring strips, and the pressures there.

    Interpolated by the power of the distance from the end that passes through both strips, or linearly where the end
    lies between them.
    """
    *case, left = crossing
    right = (*case, left + 1)
    at = np.broadcast_to(y, pressure.shape)
    first, second = ((at[index], half_width[index], pressure[index]) for index in (crossing, right))
    of_case = ends[tuple(case)] if case else np.broadcast_to(ends, (left.size, ends.size))
    distances = np.abs(np.stack([first[0], second[0]])[..., None] - of_case)
    distances = np.where(np.isnan(distances), np.inf, distances)
    # The end that the strip next to it is within a half-width of, and the distance from it towards the other strip.
    first_is_near = distances[0].min(axis=-1) <= first[1]
    end = of_case[
        np.arange(left.size), np.where(first_is_near, distances[0].argmin(axis=-1), distances[1].argmin(axis=-1))
    ]
    away = np.where(first_is_near, 1.0, -1.0)
    from_end = [away * (each[0] - end) for each in (first, second)]
    beyond = [distance - each[1] for distance, each in zip(from_end, (first, second), strict=True)]
    share = beyond[0] / (beyond[0] - beyond[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = from_end[0] + share * (from_end[1] - from_end[0])
        power = np.log(distance / from_end[0]) / np.log(from_end[1] / from_end[0])
    power = np.where(np.isfinite(power), power, share)
    place, pressures = first[0] + share * (second[0] - first[0]), first[2] ** (1.0 - power) * second[2] ** power
    # A border of one end may lie close to another end.
    others = np.abs(place[:, None] - of_case)
    nearest = np.where(np.isnan(others), np.inf, others).min(axis=-1)
    half_width_there = first[1] + share * (second[1] - first[1])
    return place, np.where(nearest >= (1.0 - SAME) * half_width_there, pressures, 0.0)


def places_of_largest(solution: Solved) -> tuple[float, ...]:
    """Return where the largest pressure that counts is [mm], ascending: both places if they mirror each other."""
    if not solution.contact_y:
        return ()
    places, values = counted(solution.y, solution.largest_across, solution.half_width, singular_y(solution))
    places, values = places[values > 0.0], values[values > 0.0]
    order = np.argsort(places)
    equal = np.flatnonzero(values[order] >= (1.0 - SAME) * values.max())
    # Two neighbours are one flat crest, and more than two are not a distinct place at all.
    if equal.size == 2 and equal[1] - equal[0] > 1:
        return tuple(places[order][equal].tolist())
    return (solution.max_pressure_y,)


def singular_y(solution: Solved) -> Array:
    """Return the positions of the ends at which the pressure has no limit [mm]."""
    return np.array([end.y for end in solution.singular_ends])


def _nearest(y: Array, ends: Array) -> Array:
    """Return how far places are from the nearest end, infinite where there is none."""
    if ends.shape[-1] == 0:
        return np.full((*ends.shape[:-1], y.shape[-1]), np.inf)
    distance = np.abs(y[..., None] - ends[..., None, :])
    nearest: Array = np.where(np.isnan(distance), np.inf, distance).min(axis=-1)
    return nearest
