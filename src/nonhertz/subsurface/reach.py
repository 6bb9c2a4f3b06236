"""Where a contact reaches along y, and which ends of it leave the stress no limit, for strips and plane grids alike."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.finite import HERTZ, influence_of
from nonhertz.patch.limits import FINITE
from nonhertz.patch.solution import PatchSolution
from nonhertz.singular import PAST_CORNER, corner_ends, singular_ends
from nonhertz.solution import Solution

Array = NDArray[np.float64]
AnySolution = Solution | PatchSolution

SAME_PLACE = 1e-9  # of the length


def checked_solution(solution: object) -> AnySolution:
    """Return a solution that has a contact, or refuse what has none or is none.

    Raises
    ------
    InputError
    """
    if not isinstance(solution, Solution | PatchSolution):
        raise InputError("solution", solution, "be a solved contact", "give what solve or patch.solve returns")
    if not np.any(solution.line_load > 0.0):
        raise InputError("solution", solution.status.label, "have a contact", "press the bodies together")
    return solution


def edges_along(solution: AnySolution) -> Array:
    """Return the edges [mm] of the strips, or of the rows of cells."""
    if isinstance(solution, Solution):
        return solution.edges
    return np.append(solution.y - 0.5 * solution.dy, solution.y[-1] + 0.5 * solution.dy)


def contact_ends(solution: AnySolution) -> tuple[float, float]:
    """Return the outermost ends [mm] of a contact."""
    if isinstance(solution, Solution):
        return solution.contact_y[0][0], solution.contact_y[-1][1]
    touching = np.flatnonzero(solution.line_load > 0.0)
    edges = edges_along(solution)
    return float(edges[touching[0]]), float(edges[touching[-1] + 1])


@dataclass(frozen=True, order=True)
class LimitlessEnd:
    """An end of a contact towards which pressure and stress have no limit.

    Attributes
    ----------
    y : float
        Where [mm].
    at_corner : bool
        Whether it is a corner of the profile, else a sharp end of a body.
    """

    y: float
    at_corner: bool


def limitless_ends(solution: AnySolution) -> tuple[LimitlessEnd, ...]:
    """Return the ends at which the pressure has no limit, ascending: sharp ends of bodies, corners of profiles."""
    sharp = _sharp_ends(solution)
    if isinstance(solution, Solution):
        pressure = np.where(solution.line_load > 0.0, solution.centre_pressure, 0.0)
    else:
        pressure = np.where(solution.line_load > 0.0, solution.pressure.max(axis=0), 0.0)
    corners = corner_ends(solution.contact, edges_along(solution), pressure, solution.half_width)
    room = SAME_PLACE * float(np.ptp(edges_along(solution)))
    apart = [corner for corner in corners if all(abs(corner - end) > room for end in sharp)]
    return tuple(sorted([LimitlessEnd(y, False) for y in sharp] + [LimitlessEnd(y, True) for y in apart]))


def ends_in_words(ends: Iterable[LimitlessEnd]) -> str:
    """Return where the stress has no limit.

    Examples
    --------
    >>> ends_in_words([LimitlessEnd(-10.0, False), LimitlessEnd(9.0, True)])
    'the sharp end at y = -10 mm and the corner of the profile at y = 9 mm'
    """
    parts = []
    for one, many, at_corner in (
        ("sharp end", "sharp ends", False),
        ("corner of the profile", "corners of the profile", True),
    ):
        places = sorted({end.y for end in ends if end.at_corner == at_corner})
        if places:
            name = one if len(places) == 1 else many
            parts.append(f"the {name} at y = {' and '.join(f'{y:.5g}' for y in places)} mm")
    return " and ".join(parts)


def largest_half_width(solution: AnySolution, ends: Iterable[float]) -> float:
    """Return the largest half-width [mm] that is not right at one of ``ends``.

    At a corner the contact grows wider with every refinement, and a length that others are measured by must not.
    """
    largest = float(solution.half_width.max())
    away = solution.line_load > 0.0
    for end in ends:
        away &= np.abs(solution.y - end) > PAST_CORNER * largest
    return float(solution.half_width[away].max()) if np.any(away) else largest


def step_at(solution: AnySolution, end: LimitlessEnd) -> float:
    """Return the width of the strip, or of the row of cells, at an end [mm]."""
    edges = edges_along(solution)
    touching = np.flatnonzero(solution.line_load > 0.0)
    distance = np.abs(0.5 * (edges[1:] + edges[:-1]) - end.y)[touching]
    return float(np.diff(edges)[touching[distance.argmin()]])


def _sharp_ends(solution: AnySolution) -> tuple[float, ...]:
    """Return where a contact reaches an end of a body at which the pressure has no limit [mm], ascending."""
    if isinstance(solution, Solution):
        return tuple(end.y for end in singular_ends(solution))
    faces = influence_of(solution.contact, HERTZ).ends
    interval = solution.contact.interval
    room = SAME_PLACE * float(np.ptp(solution.y))
    return tuple(
        limit
        for at, limit in zip(contact_ends(solution), interval, strict=True)
        if abs(at - limit) <= room
        and sum(end.image_weight for end in faces if abs(end.y - limit) < 0.5 * solution.dy) < FINITE
    )
