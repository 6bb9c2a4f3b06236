"""The region of the contact, found by solving coarsely and adjusting the region to the result.

A region that the contact fills to its border is extended by its own length on that side, one that is mostly empty is
cut down to the cells in contact; a solve on a thousand cells or so costs next to nothing. For a prescribed approach the
start is the undeformed overlap (`nonhertz.patch.nearness`): where no cell touches, the contact is smaller than a cell,
and the region shrinks about its lowest place. A region never extends past the ends of the bodies, so that a contact up
to an end has it on a cell edge.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.cascade import Outcome, PatchProblem, solve_on
from nonhertz.patch.grid import Grid
from nonhertz.result.solution import Status

Span = tuple[float, float]
Mask = NDArray[np.bool_]

CELLS = (24, 48)
ROUGHLY = 1e-3
FILLED = 0.75  # of each side of the region
MOST_MOVES, MOST_FAILURES = 60, 3
CLOSER = 0.25  # of a region in which no cell touches
UNBOUNDED: Span = (-math.inf, math.inf)


def find(
    problem: PatchProblem,
    interval: Span,
    start: tuple[Span, Span],
    towards: tuple[float, float],
    refuse: Callable[[Outcome], None],
) -> tuple[Span, Span]:
    """Return the region of the contact, with a small margin where it does not end with the bodies.

    Parameters
    ----------
    problem : PatchProblem
        The problem to solve.
    interval : tuple of float
        Extent of both bodies along y [mm]; may be infinite.
    start : tuple of tuple of float
        Region to begin with [mm].
    towards : tuple of float
        Place x, y [mm] to zoom in on if no cell touches.
    refuse : callable
        Raises if the contact of an outcome is too large for the bodies.

    Returns
    -------
    tuple of float, tuple of float
        Ends across and along [mm].
    """
    x_span, y_span = start
    failures = 0
    for _ in range(MOST_MOVES):
        outcome = solve_on(problem, Grid(x_span, y_span, CELLS), ROUGHLY, rough=True)
        touching = outcome.state.pressure > 0.0
        failures = 0 if outcome.state.status is Status.CONVERGED else failures + 1
        if failures == MOST_FAILURES:
            break
        across, along = np.any(touching, axis=1), np.any(touching, axis=0)
        if not np.any(across):
            x_span, y_span = closer(x_span, towards[0]), closer(y_span, towards[1], interval)
            continue
        beyond = borders(x_span, across), borders(y_span, along, interval)
        if any((*beyond[0], *beyond[1])):
            refuse(outcome)
            # Not cut down at the same time: the contact will change once the region no longer cuts it.
            x_span, y_span = widened(x_span, beyond[0], 1.0), widened(y_span, beyond[1], 1.0, interval)
            continue
        done = filled(across) and filled(along)
        x_span, y_span = around(x_span, across), around(y_span, along, interval)
        if done:
            break
    return x_span, y_span


def closer(span: Span, place: float, limits: Span = UNBOUNDED) -> Span:
    """Return a shorter span about a place."""
    half = 0.5 * CLOSER * (span[1] - span[0])
    return max(place - half, limits[0]), min(place + half, limits[1])


def joined(span: Span, other: Span, limits: Span = UNBOUNDED) -> Span:
    """Return a span that holds both, within limits."""
    return max(min(span[0], other[0]), limits[0]), min(max(span[1], other[1]), limits[1])


def borders(span: Span, touching: Mask, limits: Span = UNBOUNDED) -> tuple[bool, bool]:
    """Return whether the contact reaches the low and the high end of a span although the bodies continue."""
    return bool(touching[0]) and span[0] > limits[0], bool(touching[-1]) and span[1] < limits[1]


def filled(touching: Mask) -> bool:
    """Return whether the contact fills a span well enough."""
    return int(np.ptp(np.flatnonzero(touching))) + 1 >= FILLED * touching.size


def around(span: Span, touching: Mask, limits: Span = UNBOUNDED) -> Span:
    """Return a span one cell wider than the contact on each side, within limits."""
    places = np.flatnonzero(touching)
    side = (span[1] - span[0]) / touching.size
    low, high = span[0] + float(places[0] - 1) * side, span[0] + float(places[-1] + 2) * side
    return max(low, limits[0]), min(high, limits[1])


def widened(span: Span, ends: tuple[bool, bool], share: float, limits: Span = UNBOUNDED) -> Span:
    """Return a span extended by a share of its length at each end flagged in ``ends``, within limits."""
    more = share * (span[1] - span[0])
    low, high = span[0] - more * ends[0], span[1] + more * ends[1]
    return max(low, limits[0]), min(high, limits[1])
