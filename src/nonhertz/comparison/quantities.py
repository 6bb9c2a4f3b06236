"""Results of strips and plane grid side by side, and three stations at which to look across the contact."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.comparison.value import ComparedQuantity, Station
from nonhertz.findings import Finding, finding, said
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.ends import away_from_ends, ends_in_words
from nonhertz.result.maximum import counted, singular_y
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

LARGEST = "largest difference in MPa"
"""Why the second station was chosen."""
ROUNDING = 1e-5  # of the load times the farthest strip: a smaller moment counts as zero by symmetry
SAME = 1e-3  # of a pressure: equal up to this, since neither strips nor cells lie symmetrically
NEAREST = 4  # values that a cubic goes through
NEAR = 0.25  # of a half-width
ALIKE = 1e-3  # relative difference up to which two line loads count as equal


def quantities(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[ComparedQuantity, ...]:
    """Return approach, tilt, load, moment, the middle of the contact, the largest pressure and the ends.

    Parameters
    ----------
    semi, parabola : Solution
        On semi-elliptic and on parabolic strips.
    patch : PatchSolution
        On the plane grid.
    """
    at = centre(semi)
    p_semi, p_parabola = (_at(at, one.y, one.centre_pressure) for one in (semi, parabola))
    b_semi, b_parabola = (_at(at, one.y, one.half_width) for one in (semi, parabola))
    p, b = _at(at, patch.y, patch.centre_pressure), _at(at, patch.y, patch.half_width)
    cells = finding("cells", "cells {width:.2g} across", width=mm(patch.dx))
    return (
        ComparedQuantity("approach", "mm", patch.approach, semi.approach, parabola.approach),
        ComparedQuantity("tilt", "rad", patch.tilt, semi.tilt, parabola.tilt),
        ComparedQuantity("load", "N", patch.load, semi.load, parabola.load),
        _moment(semi, parabola, patch),
        ComparedQuantity("pressure", "MPa", p, p_semi, p_parabola, at=at),
        ComparedQuantity("half-width", "mm", b, b_semi, b_parabola, remark=cells, at=at),
        *_largest(semi, parabola, patch),
        *_ends(semi, parabola, patch),
    )


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
    near, found = y[first : first + NEAREST], values[first : first + NEAREST]
    if near.size < NEAREST or np.any(found <= 0.0):
        return float(np.interp(at, y, values))
    weights = [np.prod([(at - other) / (here - other) for other in near if other != here]) for here in near]
    return float(np.array(weights) @ found)


def _moment(semi: Solution, parabola: Solution, patch: PatchSolution) -> ComparedQuantity:
    rounding = ROUNDING * patch.load * float(np.max(np.abs(semi.edges)))
    of_patch, of_semi, of_parabola = (
        one.moment if abs(one.moment) > rounding else 0.0 for one in (patch, semi, parabola)
    )
    return ComparedQuantity("moment", "N mm", of_patch, of_semi, of_parabola)


def _largest(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[ComparedQuantity, ComparedQuantity]:
    """Return the largest pressure and its position, away from ends at which it has no limit."""
    p, y = _peak(semi, patch.y, patch.centre_pressure, semi.contact_y[-1][1])
    (p_semi, y_semi), (p_parabola, y_parabola) = (
        _peak(semi, one.y, one.centre_pressure, y) for one in (semi, parabola)
    )
    remark: Finding | None = None
    if semi.singular_ends:
        away = "a half-width and more from {ends}, where it has no limit"
        remark = finding("away-from-ends", away, ends=ends_in_words(semi.singular_ends))
    elif semi.peaks_at_corner:
        remark = said("at a corner of the profile, where it has no limit")
    return (
        ComparedQuantity("maximum pressure", "MPa", p, p_semi, p_parabola, remark=remark),
        ComparedQuantity("position of the maximum", "mm", y, y_semi, y_parabola, absolute=True),
    )


def _peak(semi: Solution, y: Array, pressure: Array, near: float) -> tuple[float, float]:
    """Return the largest pressure, and of all positions that have it the one nearest to ``near``; NaN without contact.

    For all methods, the half-width next to singular ends, as found by semi-elliptic strips, is left out.
    """
    half_width = np.where(pressure > 0.0, np.interp(y, semi.y, semi.half_width), 0.0)
    places, found = counted(y, pressure, half_width, singular_y(semi))
    if not np.any(found > 0.0):
        return math.nan, math.nan
    largest = np.flatnonzero(found >= (1.0 - SAME) * found.max())
    at = largest[np.abs(places[largest] - near).argmin()]
    return float(found.max()), float(places[at])


def _ends(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[ComparedQuantity, ComparedQuantity]:
    rows = patch.y[patch.footprint.any(axis=0)]
    remark = finding("cells", "cells {length:.2g} along", length=mm(patch.dy))
    low, high = float(rows[0]) - 0.5 * patch.dy, float(rows[-1]) + 0.5 * patch.dy
    return (
        ComparedQuantity("contact from", "mm", low, semi.contact_y[0][0], parabola.contact_y[0][0], True, remark),
        ComparedQuantity("contact to", "mm", high, semi.contact_y[-1][1], parabola.contact_y[-1][1], True, remark),
    )


def stations(semi: Solution, patch: PatchSolution) -> tuple[Station, Station, Station]:
    """Return the middle, where the pressures along the line differ most, and a station near the more loaded end.

    The middle is y = 0, or the middle of the contact if that is not in contact, or where the line load is largest if
    neither is. The more loaded end is the one with the larger line load a half-width inside it; the station is a
    quarter of the largest half-width from it, and at least two cells. The difference is that of the pressures in MPa of
    semi-elliptic strips, more than a half-width from ends at which the pressure has no limit, a strip and two cells
    from where the contact ends, and a half-width (or an eighth of a short contact) from the other two stations.
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
    return (
        Station(middle, "middle"),
        Station(between, LARGEST),
        Station(end, "near the more loaded end"),
    )


def _near_end(semi: Solution, patch: PatchSolution) -> float:
    widest = semi.max_half_width
    low, high = semi.contact_y[0][0], semi.contact_y[-1][1]
    inwards = min(widest, 0.25 * (high - low))
    at_low, at_high = np.interp([low + inwards, high - inwards], semi.y, semi.line_load)
    step = min(max(NEAR * widest, 2.0 * patch.dy), 0.125 * (high - low))
    # Where both are alike, as in a contact that tilt only shifts, it is the end that the tilt presses down.
    alike = abs(at_low - at_high) <= ALIKE * at_high
    return float(low + step if (semi.tilt < 0.0 if alike else at_low > at_high) else high - step)
