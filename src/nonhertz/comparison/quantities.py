"""Results of strips and plane grid side by side, and three stations for the comparison across the contact."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from nonhertz.amounts import mm
from nonhertz.comparison.value import Array, ComparedQuantity, Station
from nonhertz.findings import Finding, finding
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.ends import away_from_ends, ends_in_words
from nonhertz.result.maximum import singular_y, values_that_count
from nonhertz.result.solution import Solution

LARGEST = "largest difference in MPa"
"""Why the second station was chosen."""
ROUNDING = 1e-5  # of the load times the farthest strip: a smaller moment counts as zero by symmetry
SAME = 1e-3  # of a pressure: equal up to this, since strips and cells are not symmetric
NEAREST = 4  # number of values through which a cubic goes
NEAR = 0.25  # of a half-width
ALIKE = 1e-3  # relative difference up to which two line loads count as equal


def quantities(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[ComparedQuantity, ...]:
    """Return approach, tilt, load, moment, the values in the middle, the maximum pressure and the ends.

    Parameters
    ----------
    semi, parabola : Solution
        Solutions on semi-elliptic and on parabolic strips.
    patch : PatchSolution
        Solution on the plane grid.
    """
    at, (low, high) = centre(semi), (semi.contact_y[0][0], semi.contact_y[-1][1])
    across = finding("cells", "cells {width:.2g} across", width=mm(patch.dx))
    along = finding("cells", "cells {length:.2g} along", length=mm(patch.dy))
    rounding = ROUNDING * patch.load * float(np.max(np.abs(semi.edges)))
    rows = patch.y[patch.footprint.any(axis=0)]
    first, last = float(rows[0]) - 0.5 * patch.dy, float(rows[-1]) + 0.5 * patch.dy
    p, y = _peak(semi, patch, high)
    (p_semi, y_semi), (p_parabola, y_parabola) = (_peak(semi, one, y) for one in (semi, parabola))

    def compared(
        what: str, unit: str, of: Callable[[Solution | PatchSolution], float], **more: Any
    ) -> ComparedQuantity:
        return ComparedQuantity(what, unit, of(patch), of(semi), of(parabola), **more)

    return (
        compared("approach", "mm", lambda one: one.approach),
        compared("tilt", "rad", lambda one: one.tilt),
        compared("load", "N", lambda one: one.load),
        compared("moment", "N mm", lambda one: one.moment if abs(one.moment) > rounding else 0.0),
        compared("pressure", "MPa", lambda one: _at(at, one.y, one.centre_pressure), at=at),
        compared("half-width", "mm", lambda one: _at(at, one.y, one.half_width), remark=across, at=at),
        ComparedQuantity("maximum pressure", "MPa", p, p_semi, p_parabola, remark=_without_limit(semi)),
        ComparedQuantity("position of the maximum", "mm", y, y_semi, y_parabola, absolute=True),
        ComparedQuantity("contact from", "mm", first, low, parabola.contact_y[0][0], True, along),
        ComparedQuantity("contact to", "mm", last, high, parabola.contact_y[-1][1], True, along),
    )


def _without_limit(semi: Solution) -> Finding | None:
    """Return where the maximum pressure is not searched, or is unbounded."""
    if semi.singular_ends:
        away = "more than a half-width from {ends}, where it is unbounded"
        return finding("away-from-ends", away, ends=ends_in_words(semi.singular_ends))
    return Finding.from_text("at a corner of the profile, where it is unbounded") if semi.peaks_at_corner else None


def centre(semi: Solution) -> float:
    """Return y = 0 if in contact, else the middle of the contact if that is, else where the line load peaks [mm]."""
    low, high = semi.contact_y[0][0], semi.contact_y[-1][1]
    for y in (0.0, 0.5 * (low + high)):
        if any(start < y < end for start, end in semi.contact_y):
            return y
    return float(semi.y[semi.line_load.argmax()])


def _at(at: float, y: Array, values: Array) -> float:
    """Return a value between strips or cells: a cubic through the four nearest if all are in contact, else linear."""
    first = int(np.clip(np.searchsorted(y, at) - NEAREST // 2, 0, max(y.size - NEAREST, 0)))
    near, near_values = y[first : first + NEAREST], values[first : first + NEAREST]
    if near.size < NEAREST or np.any(near_values <= 0.0):
        return float(np.interp(at, y, values))
    weights = [np.prod([(at - other) / (here - other) for other in near if other != here]) for here in near]
    return float(np.array(weights) @ near_values)


def _peak(semi: Solution, one: Solution | PatchSolution, near: float) -> tuple[float, float]:
    """Return the maximum pressure, and the position nearest to ``near`` at which it occurs; NaN without contact.

    For all methods, the half-width next to singular ends by semi-elliptic strips is left out.
    """
    half_width = np.where(one.centre_pressure > 0.0, np.interp(one.y, semi.y, semi.half_width), 0.0)
    places, pressures, _ = values_that_count(one.y, one.centre_pressure, half_width, singular_y(semi))
    if not np.any(pressures > 0.0):
        return math.nan, math.nan
    largest = np.flatnonzero(pressures >= (1.0 - SAME) * pressures.max())
    at = largest[np.abs(places[largest] - near).argmin()]
    return float(pressures.max()), float(places[at])


def stations(semi: Solution, patch: PatchSolution) -> tuple[Station, Station, Station]:
    """Return the middle, where the pressures along the line differ most, and a station near the more loaded end.

    The middle is y = 0, or the middle of the contact if that is not in contact, or where the line load is largest if
    neither is. The more loaded end is the one with the larger line load a half-width inside it; the station is a
    quarter of the largest half-width from it, and at least two cells. The difference is that of the pressures in MPa of
    semi-elliptic strips, more than a half-width from singular ends, a strip and two cells from where the contact ends,
    and a half-width (or an eighth of a short contact) from the other two stations.
    """
    middle, end = centre(semi), _near_end(semi, patch)
    low, high = semi.contact_y[0][0], semi.contact_y[-1][1]
    apart = min(semi.max_half_width, 0.125 * (high - low))
    expected = np.interp(semi.y, patch.y, patch.centre_pressure)
    free = (semi.line_load > 0.0) & away_from_ends(semi, semi.y)
    free &= (np.abs(semi.y - middle) > apart) & (np.abs(semi.y - end) > apart)
    for edge in np.ravel(semi.contact_y):
        # Neither strips nor cells resolve the end of the contact.
        free &= np.abs(semi.y - edge) > np.maximum(semi.strip_width, 2.0 * patch.dy)
    between = 0.5 * (middle + end)
    if np.any(free):
        between = float(semi.y[np.where(free, np.abs(semi.centre_pressure - expected), -1.0).argmax()])
    return Station(middle, "middle"), Station(between, LARGEST), Station(end, "near the more loaded end")


def _near_end(semi: Solution, patch: PatchSolution) -> float:
    widest = semi.max_half_width
    low, high = semi.contact_y[0][0], semi.contact_y[-1][1]
    inwards = min(widest, 0.25 * (high - low))
    at_low, at_high = np.interp([low + inwards, high - inwards], semi.y, semi.line_load)
    step = min(max(NEAR * widest, 2.0 * patch.dy), 0.125 * (high - low))
    # If both are equal, as in a contact that tilt only shifts, it is the end that the tilt loads.
    alike = abs(at_low - at_high) <= ALIKE * at_high
    return float(low + step if (semi.tilt < 0.0 if alike else at_low > at_high) else high - step)
