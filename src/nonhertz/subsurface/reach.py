"""Where a contact reaches along y, and where its end is sharp, for strips and plane grids alike."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.finite import HERTZ, influence_of
from nonhertz.patch.limits import FINITE
from nonhertz.patch.solution import PatchSolution
from nonhertz.singular import singular_ends
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


def sharp_ends(solution: AnySolution) -> tuple[float, ...]:
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
