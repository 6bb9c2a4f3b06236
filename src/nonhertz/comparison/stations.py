"""Three stations at which to look across the contact."""

from __future__ import annotations

import numpy as np

from nonhertz.comparison.quantities import centre
from nonhertz.comparison.value import Station
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.ends import away_from_ends
from nonhertz.result.solution import Solution

NEAR = 0.25  # of a half-width
ALIKE = 1e-3  # relative difference up to which two line loads count as equal


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
        Station(between, "largest difference"),
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
