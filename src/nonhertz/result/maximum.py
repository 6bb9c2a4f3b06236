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

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled, plain_array

if TYPE_CHECKING:
    from nonhertz.result.solution import Solved
    from nonhertz.strip.records import States

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
    return _distances(y, ends) - half_width


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


@compiled
def largest_of(states: States, hertz_ratio: float, ends: Array) -> tuple[Array, Array]:
    """Return the largest pressures of many contacts, as `States.scaled_pressure`, and where they are [mm].

    ``ends``, shape (cases, k), are those that have no limit, as for `largest_pressure`.
    """
    cases, n = states.m.shape
    y, pressure, half_width = np.empty((states.edges.shape[0], n)), np.empty((cases, n)), np.empty((cases, n))
    for row in range(y.shape[0]):
        for i in range(n):
            y[row, i] = 0.5 * (states.edges[row, i + 1] + states.edges[row, i])
    for case in range(cases):
        for i in range(n):
            root = math.sqrt(states.m[case, i])
            pressure[case, i], half_width[case, i] = states.r[case, i] * root, hertz_ratio * root
    places, values = _counted(y, pressure, half_width, ends)
    highest, at = np.empty(cases), np.empty(cases)
    for case in range(cases):
        most = 0
        for k in range(values.shape[1]):
            most = k if values[case, k] > values[case, most] else most
        highest[case], at[case] = values[case, most], places[case, most]
    return highest, at


def largest_half_width(y: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    """Return the largest half-widths more than a half-width from the ends, for many contacts, and where they are.

    Parameters and results are those of `largest_pressure`.
    """
    return largest_pressure(y, half_width, half_width, ends)


def counted(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    """Return all places that `largest_pressure` considers, and the pressures there, zero where they do not count.

    First those of the strips, then those between each and the next.
    """
    n = pressure.shape[-1]
    rows = [plain_array(values).reshape(-1, n) for values in (y, pressure, half_width)]
    cases = rows[1].shape[0]
    of_cases = plain_array(np.broadcast_to(np.atleast_2d(ends), (cases, ends.shape[-1])))
    places, values = _counted(rows[0], rows[1], rows[2], of_cases)
    shape = (*pressure.shape[:-1], 2 * n - 1)
    return places.reshape(shape), values.reshape(shape)


@compiled
def _counted(y: Array, pressure: Array, half_width: Array, ends: Array) -> tuple[Array, Array]:
    n = pressure.shape[1]
    places, values = np.zeros((len(pressure), 2 * n - 1)), np.zeros((len(pressure), 2 * n - 1))
    for case in range(pressure.shape[0]):
        row = case if y.shape[0] > 1 else 0
        any_counts, farthest, most = False, -1, -1.0
        for i in range(n):
            places[case, i], values[case, i] = y[row, i], 0.0
            if pressure[case, i] > 0.0:
                nearest = _nearest(y[row, i], ends, case)
                if nearest > half_width[case, i]:
                    values[case, i], any_counts = pressure[case, i], True
                of_width = nearest / half_width[case, i] if half_width[case, i] > 0.0 else nearest
                if of_width > most:
                    farthest, most = i, of_width
        for i in range(n - 1):
            place, value = _at_border(y[row], pressure[case], half_width[case], ends, case, i)
            places[case, n + i], values[case, n + i] = place, value
            any_counts = any_counts or value > 0.0
        # A contact too short for any place to count: the one farthest from the ends does.
        if not any_counts and farthest >= 0:
            values[case, farthest] = pressure[case, farthest]
    return places, values


@compiled
def _nearest(y: float, ends: Array, case: int) -> float:
    """Return how far a place is from the nearest end, infinite where there is none."""
    nearest = np.inf
    for k in range(ends.shape[1]):
        distance = abs(y - ends[case, k])
        nearest = distance if distance < nearest else nearest
    return nearest


@compiled
def _at_border(y: Array, pressure: Array, half_width: Array, ends: Array, case: int, i: int) -> tuple[float, float]:
    """Return the place a half-width from an end between two neighbouring strips, if there is one, and its pressure.

    Interpolated by the power of the distance from the end that passes through both strips, or linearly where the end
    lies between them.
    """
    j = i + 1
    if not (pressure[i] > 0.0 and pressure[j] > 0.0):
        return 0.0, 0.0
    first, second = _nearest(y[i], ends, case), _nearest(y[j], ends, case)
    if (first > half_width[i]) == (second > half_width[j]):
        return 0.0, 0.0
    # The end that one strip is within a half-width of, and the distances of both from it towards the other strip. Seen
    # from there both may be on its far side, if the contact is much narrower at the other strip.
    first_is_near = first <= half_width[i]
    near, far = (i, j) if first_is_near else (j, i)
    end = ends[case, 0]
    for k in range(ends.shape[1]):
        if abs(y[near] - ends[case, k]) == (first if first_is_near else second):
            end = ends[case, k]
    away = 1.0 if y[far] > end else -1.0
    one, other = away * (y[i] - end), away * (y[j] - end)
    share = (one - half_width[i]) / ((one - half_width[i]) - (other - half_width[j]))
    power = share
    if one > 0.0 and other > 0.0 and one != other:
        power = math.log((one + share * (other - one)) / one) / math.log(other / one)
    place = y[i] + share * (y[j] - y[i])
    # A border of one end may lie close to another end.
    width_there = half_width[i] + share * (half_width[j] - half_width[i])
    if not _nearest(place, ends, case) >= (1.0 - SAME) * width_there:
        return place, 0.0
    return place, pressure[i] ** (1.0 - power) * pressure[j] ** power


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


def _distances(y: Array, ends: Array) -> Array:
    """Return how far places are from the nearest end, infinite where there is none."""
    if ends.shape[-1] == 0:
        return np.full((*ends.shape[:-1], y.shape[-1]), np.inf)
    distance = np.abs(y[..., None] - ends[..., None, :])
    nearest: Array = np.where(np.isnan(distance), np.inf, distance).min(axis=-1)
    return nearest
