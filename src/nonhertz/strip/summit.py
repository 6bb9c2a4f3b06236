"""Summits of the pressure: how accurate strips resolve them, and how high those are that they do not resolve."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonhertz.compiled import compiled
from nonhertz.strip.records import Array, States

SAFETY, SAME = 2.0, 1e-9
# A summit towards which the pressure rises ever faster is narrower than its strips, as on a rounded corner. It may
# stand out by this many of the sagittas that they show, if these are large at all.
CUSP, LEAST_SAGITTA = 8.0, 0.01
# Of the change of a summit's pressure from half the strips, what is left: in a smooth stretch, and where strips are
# narrower than this share of a half-width, which only a corner of the profile makes them; and of the sagitta within the
# strip. Measured on 800 random rollers, of which they leave 3 uncovered.
SMOOTH_LEFT, CORNER_LEFT, CORNER_STRIP, SAGITTA_LEFT = 0.5, 1.6, 0.2, 0.6


class Pressures(NamedTuple):
    """The strips of a case: their edges, centres and half-widths [mm]; K q / a, and K times the load of each."""

    edges: Array
    y: Array
    half_width: Array
    pressure: Array
    load: Array


@compiled
def pressures_of(states: States, hertz_ratio: float, case: int) -> Pressures:
    """Return the strips of one of many cases, which may share one row of edges."""
    row = 0 if states.edges.shape[0] == 1 else case
    n = states.counts[row]
    edges, r, m = states.edges[row, : n + 1], states.r[case, :n], states.m[case, :n]
    y, width = 0.5 * (edges[1:] + edges[:-1]), edges[1:] - edges[:-1]
    return Pressures(edges, y, hertz_ratio * np.sqrt(m), r * np.sqrt(m), r * m * width)


@compiled
def largest_summit_errors(finest: States, half: States, hertz_ratio: float) -> Array:
    """Return the relative errors of the largest pressures, zero where strips resolve no summit there.

    Parameters
    ----------
    finest, half : States
        The states of all cases on a graded grid and on half of its strips.
    hertz_ratio : float
        As in `nonhertz.strip.records.Kernel`.
    """
    found = np.zeros(finest.status.size)
    for case in range(found.size):
        strips = pressures_of(finest, hertz_ratio, case)
        at = 0
        for i in range(1, strips.y.size):
            at = i if strips.pressure[i] > strips.pressure[at] else at
        at = resolved_summit(strips, strips.y[at])
        if at > 0:
            before = pressures_of(half, hertz_ratio, case)
            found[case] = error_at_summit(strips, at, before, before, True)
    return found


@compiled
def resolved_summit(strips: Pressures, y: float) -> int:
    """Return the strip centred on ``y`` if it resolves a summit of the pressure within the contact, else zero."""
    p = strips.pressure
    for i in range(1, p.size - 1):
        if strips.y[i] == y:
            is_inside = min(p[i - 1], p[i + 1]) > 0.0
            return i if is_inside and is_summit(p, i) and 0.0 < sagitta(p, i) < LEAST_SAGITTA else 0
    return 0


@compiled
def error_at_summit(strips: Pressures, at: int, before: Pressures, before_that: Pressures, regular: bool) -> float:
    """Return the relative error of the pressure of a summit, estimated where it is.

    What coarser grids have there says how accurate its pressure is, wherever they have their own maximum. The summit of
    the parabola through the strip and its neighbours may lie beside its centre, and within the strip the pressure
    departs from what the strip assumes.

    Parameters
    ----------
    strips : Pressures
        The finest.
    at : int
        From `resolved_summit`.
    before, before_that : Pressures
        Those of the two coarser grids.
    regular : bool
        Whether the strips follow the ends of the contact.
    """
    p, y = strips.pressure, strips.y[at]
    bend = sagitta(p, at)
    beside = ((p[at + 1] - p[at - 1]) / p[at]) ** 2 / (64.0 * bend)
    coarse = _pressure_at(before, y)
    last, earlier = abs(p[at] - coarse) / p[at], abs(coarse - _pressure_at(before_that, y)) / p[at]
    of_grids = SAFETY * max(last, 0.5 * earlier)
    if regular:
        of_grids = (CORNER_LEFT if is_on_corner(strips, at) else SMOOTH_LEFT) * last
    return float(of_grids + beside + SAGITTA_LEFT * bend)


@compiled
def is_on_corner(strips: Pressures, at: int) -> bool:
    """Return whether a strip is so narrow that it lies on a corner of the profile."""
    return bool(strips.edges[at + 1] - strips.edges[at] < CORNER_STRIP * strips.half_width[at])


@compiled
def _pressure_at(strips: Pressures, y: float) -> float:
    """Return the pressure at ``y`` on the parabola through the nearest three strips; of fewer strips, the largest."""
    places, p = strips.y, strips.pressure
    if p.size < 3:
        return float(max(p[0], p[-1]))
    i = 1
    while i + 2 < p.size and places[i] + places[i + 1] < 2.0 * y:
        i += 1
    low, middle, high = places[i - 1], places[i], places[i + 1]
    first, second = (p[i] - p[i - 1]) / (middle - low), (p[i + 1] - p[i]) / (high - middle)
    return float(p[i] + (y - middle) * (first + (y - low) * (second - first) / (high - low)))


@compiled
def cusp(pressure: Array, at: int) -> float:
    """Return how high the pressure of a strip may reach that is narrower than its summit, zero if there is none."""
    narrow = is_cusp(pressure, at) and is_summit(pressure, at)
    return pressure[at] * (1.0 + CUSP * sagitta(pressure, at)) if narrow else 0.0


@compiled
def is_cusp(pressure: Array, at: int) -> bool:
    """Return whether the pressure rises ever faster to within two strips of a strip, at least on one side."""
    rising = False
    for i in range(max(at - 2, 1), min(at + 3, pressure.size - 1)):
        rising |= sagitta(pressure, i) < 0.0
    return rising and sagitta(pressure, at) > LEAST_SAGITTA


@compiled
def is_summit(pressure: Array, at: int) -> bool:
    """Return whether the pressure falls on both sides of a strip, and reaches further on one of them at least."""
    before, peak, after = pressure[at - 1], pressure[at], pressure[at + 1]
    # Two strips beside the middle may differ by rounding. A contact may run out beside its largest pressure, as on the
    # corner of a roller.
    return bool(max(before, after) > 0.0 and peak >= (1.0 - SAME) * max(before, after))


@compiled
def sagitta(pressure: Array, at: int) -> float:
    """Return by what share of itself the pressure bends within a strip; 0 without pressure."""
    peak = pressure[at]
    return (2.0 * peak - pressure[at - 1] - pressure[at + 1]) / (8.0 * peak) if peak > 0.0 else 0.0
