"""The contents of figures along a contact: range, ends of the bodies and lands, distance of the surfaces.

They are independent of drawing: figures on paper, the page and tables show the same positions and ranges.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.result.edges import EdgeKind, EdgePressure
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

RISE = 1.05
"""Least ratio of the pressure at the end of a land to the minimum before it for a peak."""

MARGIN = 0.06
"""Fraction of the axial range left free at each side, for the names of the bodies' ends."""

CLOSE = 0.03
"""Fraction of the axial range: closer ends of two bodies share one label."""

LARGEST_CLEARANCE, CUT_CLEARANCE = 2.0, 1.0
"""Clearance, as a multiple of the deepest interference: up to the first all of it is shown; if there is more, the range
ends at the second, so that the interference fills half of it."""


def axial_range(solution: Solution) -> tuple[float, float]:
    """Return the range of y [mm] to show.

    It is that of the strips, including the bodies' ends if these are near. If the contact is a small part of the strips
    it is the neighbourhood of the contact, so that this is legible.
    """
    low, high = float(solution.edges[0]), float(solution.edges[-1])
    if solution.contact_y:
        first, last = solution.contact_y[0][0], solution.contact_y[-1][1]
        if last - first < 0.25 * (high - low):
            reach = last - first
            low, high = max(low, first - reach), min(high, last + reach)
    near = 0.25 * (high - low)
    ends = [end for end, _ in body_ends(solution) if low - near < end < high + near]
    low, high = min([low, *ends]), max([high, *ends])
    margin = MARGIN * (high - low)
    return (low - margin, high + margin)


def body_ends(solution: Solution) -> list[tuple[float, str]]:
    """Return position [mm] and name of every end of a body along y, ascending."""
    bodies = solution.contact.bodies
    kinds = [type(body).__name__.lower() for body in bodies.values()]
    distinct = kinds[0] != kinds[1] and "body" not in kinds
    ends = []
    for (letter, body), kind in zip(bodies.items(), kinds, strict=True):
        name = kind if distinct else f"body {letter}"
        faces = () if body.length is None else (body.position - 0.5 * body.length, body.position + 0.5 * body.length)
        for end in filter(np.isfinite, body.interval):
            # An effective length, or the end of a profile's definition, ends the contact before the face.
            is_face = np.isclose(end, faces).any()
            ends.append((float(end), f"end of {name}" if is_face else f"usable end of {name}"))
    return sorted(ends)


def ends_in_sight(solution: Solution) -> dict[float, str]:
    """Return the ends of bodies within the range to show [mm], ascending, and their labels.

    If two ends on one side are so close that their labels would overlap, the outer one has both labels.
    """
    low, high = axial_range(solution)
    middle = 0.5 * (low + high)
    ends = [(end, name) for end, name in body_ends(solution) if low < end < high]
    names = dict(ends)
    for side in ([end for end in ends if end[0] < middle], [end for end in ends[::-1] if end[0] >= middle]):
        if len(side) == 2 and abs(side[0][0] - side[1][0]) < CLOSE * (high - low):
            (outer, _), (inner, _) = side
            names[inner] = ""
            names[outer] = ", ".join(name for _, name in sorted(side))
    return names


def land_end_peaks(solution: Solution) -> list[tuple[float, float]]:
    """Return position [mm] and pressure [MPa] of peaks at the ends of lands, where it rises again by 5 % or more.

    They are the first peaks from an end, within half a half-width of the end of the land. There is none at singular
    ends.
    """
    pressed = solution.line_load > 0.0
    if not pressed.any():
        return []
    y, pressure, reach = solution.y[pressed], solution.centre_pressure[pressed], 0.5 * solution.half_width[pressed]
    lands = np.array([body.land for body in solution.contact.bodies.values()])
    unlimited = np.array([edge.y for edge in unlimited_ends(solution)])
    peaks = []
    for inwards in (slice(None), slice(None, None, -1)):
        rises = np.diff(pressure[inwards]) > 0.0
        peak = int(np.argmin(np.append(rises, False)))
        valley = peak + int(np.argmax(np.append(rises[peak:], True)))
        place, top, near = (float(values[inwards][peak]) for values in (y, pressure, reach))
        is_one = valley < rises.size and top > RISE * float(pressure[inwards][valley])
        at_land_end = np.any(np.abs(place - lands) < near)
        if is_one and at_land_end and np.all(np.abs(place - unlimited) > 2.0 * near):
            peaks.append((place, top))
    return peaks


def unlimited_ends(solution: Solution) -> tuple[EdgePressure, ...]:
    """Return the ends of the contact where the pressure is unbounded: sharp ends, and corners of the profile."""
    return tuple(edge for edge in solution.edge_pressure if edge.kind in {EdgeKind.SINGULAR, EdgeKind.CORNER})


def distances(solution: Solution) -> tuple[Array, Array]:
    """Return the surfaces' distance on the centre line [mm], undeformed and deformed, shape (strips,) each.

    The undeformed one is negative where the bodies would overlap. Both are NaN where the relief is infinite and cannot
    be drawn, so that lines are interrupted.
    """
    before, after = -solution.interference, solution.gap
    finite = np.isfinite(before) & np.isfinite(after)
    return np.where(finite, before, np.nan), np.where(finite, after, np.nan)


def distance_range(before: Array, after: Array) -> tuple[float, float]:
    """Return the range of distances to show, in their unit: the contact fills it."""
    depth = max(-float(np.nanmin(before)), 0.0)
    clearance = float(np.nanmax(np.maximum(before, after)))
    if depth == 0.0:
        return (-0.1 * clearance, 1.1 * clearance)
    if clearance > LARGEST_CLEARANCE * depth:
        return (-1.12 * depth, CUT_CLEARANCE * depth)
    # A little above zero even if there is no clearance, so that the line of the gap is not the range's end.
    return (-1.12 * depth, 1.08 * max(clearance, 0.15 * depth))


@dataclass(frozen=True, eq=False)
class ContactLines:
    """Quantities along a contact as lines, shape (points,) each; NaN separates pieces.

    Attributes
    ----------
    y : ndarray
        Positions [mm]: for every piece one end, the centres of its strips, and the other end.
    line_load, pressure, half_width : ndarray
        Values there [N/mm, MPa, mm]; zero at the ends.
    """

    y: Array
    line_load: Array
    pressure: Array
    half_width: Array


def contact_lines(solution: Solution) -> ContactLines:
    """Return the lines along the contact through the centres of its strips.

    They are zero where the surfaces separate: a strip beyond has its zero at its centre, up to half a strip away.
    """
    values = (solution.line_load, solution.centre_pressure, solution.half_width)
    pieces: list[Array] = []
    for low, high in solution.contact_y:
        inside = (solution.y >= low) & (solution.y <= high) & (solution.line_load > 0.0)
        inner = np.array([solution.y[inside], *(value[inside] for value in values)])
        gap = [np.full((4, 1), np.nan)] if pieces else []
        pieces += [*gap, np.array([[low], [0.0], [0.0], [0.0]]), inner, np.array([[high], [0.0], [0.0], [0.0]])]
    return ContactLines(*(np.concatenate(pieces, axis=1) if pieces else np.empty((4, 0))))
