"""Where the contact lies, found by solving it coarsely and moving the region after it.

No guess of the footprint's size is trusted: a region that the contact fills to its border is doubled on that side, one
that it leaves mostly empty is cut down to what touches, and a solve on a few hundred cells costs next to nothing.
Ends of the bodies stay where they are, so that a contact up to them has them on edges of cells.
"""

from __future__ import annotations

import math
from concurrent.futures import Executor

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.cascade import Problem, solve_on
from nonhertz.patch.grid import Grid

Span = tuple[float, float]
Mask = NDArray[np.bool_]

CELLS = (24, 48)
ROUGHLY = 1e-3
FILLED = 0.75  # of either side of the region
MOST_MOVES, MOST_SEARCHES = 60, 8
UNBOUNDED: Span = (-math.inf, math.inf)


def find(problem: Problem, interval: Span, width: float, pool: Executor | None = None) -> tuple[Span, Span]:
    """Return the region of the contact, with a small margin where it does not end with the bodies.

    Parameters
    ----------
    problem : Problem
        What is solved.
    interval : tuple of float
        Where both bodies are, along y [mm]; may be infinite.
    width : float
        First guess of the half-width [mm], positive.
    pool : Executor or None
        Threads.

    Returns
    -------
    tuple of float, tuple of float
        Ends across and along [mm].
    """
    x_span, y_span = (-2.0 * width, 2.0 * width), _first_length(problem, interval, width)
    searches = 0
    for _ in range(MOST_MOVES):
        grid = Grid(x_span, y_span, CELLS)
        touching = solve_on(problem, grid, ROUGHLY, pool).state.pressure > 0.0
        across, along = np.any(touching, axis=1), np.any(touching, axis=0)
        if not np.any(across):
            if searches == MOST_SEARCHES:
                break
            searches += 1
            x_span, y_span = widened(x_span, (True, True), 1.0), widened(y_span, (True, True), 1.0, interval)
            continue
        beyond = borders(x_span, across), borders(y_span, along, interval)
        if any((*beyond[0], *beyond[1])):
            # Not cut down meanwhile: what touches at a border is not what will touch.
            x_span, y_span = widened(x_span, beyond[0], 1.0), widened(y_span, beyond[1], 1.0, interval)
            continue
        done = filled(across) and filled(along)
        x_span, y_span = around(x_span, across), around(y_span, along, interval)
        if done:
            break
    return x_span, y_span


def borders(span: Span, touching: Mask, limits: Span = UNBOUNDED) -> tuple[bool, bool]:
    """Return whether the contact reaches the low and the high end of a span where the bodies go on."""
    return bool(touching[0]) and span[0] > limits[0], bool(touching[-1]) and span[1] < limits[1]


def filled(touching: Mask) -> bool:
    """Return whether the contact fills a span well enough."""
    return int(np.ptp(np.flatnonzero(touching))) + 1 >= FILLED * touching.size


def around(span: Span, touching: Mask, limits: Span = UNBOUNDED) -> Span:
    """Return a span one cell wider than the contact either way, within limits."""
    places = np.flatnonzero(touching)
    side = (span[1] - span[0]) / touching.size
    low, high = span[0] + float(places[0] - 1) * side, span[0] + float(places[-1] + 2) * side
    return max(low, limits[0]), min(high, limits[1])


def widened(span: Span, ends: tuple[bool, bool], share: float, limits: Span = UNBOUNDED) -> Span:
    """Return a span longer by a share of itself at either end that is to move, within limits."""
    more = share * (span[1] - span[0])
    low, high = span[0] - more * ends[0], span[1] + more * ends[1]
    return max(low, limits[0]), min(high, limits[1])


def _first_length(problem: Problem, interval: Span, width: float) -> Span:
    """Return the bodies' own length, or some multiple of the width about where the load acts."""
    if np.all(np.isfinite(interval)):
        return interval
    arm = problem.given[1] / problem.given[0] if all(problem.by_force) else 0.0
    middle = float(np.clip(arm, interval[0] + width, interval[1] - width))
    return max(interval[0], middle - 10.0 * width), min(interval[1], middle + 10.0 * width)
