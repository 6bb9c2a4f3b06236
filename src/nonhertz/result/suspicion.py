"""Which of many cases may have findings, in one compiled pass over their strips: most have none."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled, plain_array
from nonhertz.result.checks import (
    HEAVIEST,
    LEAST_DEPTH,
    MOST_OF_MODULUS,
    MOST_OF_RADIUS,
    MOST_UNEVEN,
    unevenness,
)
from nonhertz.result.end_pressure import SHARP_END_ERROR
from nonhertz.result.estimate import COARSE, FEW_AT_END, LARGE_ERROR, LARGE_PRESSURE_ERROR, wide_among
from nonhertz.result.maximum import largest_of
from nonhertz.result.validity import AT_CORNER, searched
from nonhertz.strip.grid import reaches
from nonhertz.strip.levels import ACCURACY, LEFT_OF_CHANGE, SAFETY, cusp
from nonhertz.strip.newton import worse
from nonhertz.strip.overlaps import suspects
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import CONVERGED, Grids, States
from nonhertz.strip.resolution import RIPPLE, departures, within

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

MARGIN, MORE = 0.9, 1.5  # of limits; and by how much roughness may be more within strips than is seen here
WIDE_BESIDE = 2.0  # times the last strip in contact: the one beside it may hide that the contact goes on


def suspected(problem: Problem, grids: Grids, levels: Sequence[States], singular: Array) -> Flags:
    """Return which of many cases may have findings; `nonhertz.result.validity.strains` decides whether they do.

    Those about singular ends are left to the caller.

    Parameters
    ----------
    problem : Problem
        What the cases share.
    grids : Grids
        The finest strips.
    levels : sequence of States
        The states of all cases on every grid, finest first.
    singular : ndarray, shape (cases, k)
        Their ends at which the pressure has no limit [mm], nan for no such end.
    """
    finest, contact, model = levels[0], problem.contact, problem.model
    half_width = model.element.hertz_ratio * np.sqrt(finest.m)
    loads = finest.r * finest.m * finest.width
    seen = _Seen(
        grids.separation,
        grids.min_depth,
        grids.sharper,
        departures(within(problem, finest.edges)[1]),
        unevenness(contact, np.broadcast_to(grids.y, half_width.shape), half_width, loads, finest.rigid),
        plain_array(singular),
        np.array(contact.bends),
    )
    accuracy = problem.accuracy or 0.0
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    region = searched(contact, float(finest.edges[:, 0].min()), float(finest.edges[:, -1].max()))
    limits = _Limits(
        model.element.hertz_ratio, 0.5 * MOST_OF_MODULUS * softer * contact.compliance, accuracy,
        min(LARGE_ERROR, accuracy) if problem.accuracy_given and accuracy else LARGE_ERROR, problem.accuracy_given,
        *contact.interval,
    )  # fmt: skip
    coarse, coarser = (levels[min(k, len(levels) - 1)] for k in (1, 2))
    found = _suspected(finest, coarse, coarser, len(levels), seen, limits)
    heavy = any(end.requested > HEAVIEST for end in model.influence.ends)
    return found | suspects(problem, finest, region) | heavy


class _Seen(NamedTuple):
    """What is known of all strips, of all cases, and of the bodies."""

    separation: Array
    min_depth: Array
    sharper: Array
    departure: Array
    uneven: Array
    singular: Array
    bends: Array


class _Limits(NamedTuple):
    """What findings depend on."""

    hertz_ratio: float
    pressure: float
    accuracy: float
    large: float
    accuracy_given: bool
    first: float
    last: float


@compiled
def _suspected(finest: States, coarse: States, coarser: States, count: int, seen: _Seen, limits: _Limits) -> Flags:
    found = np.empty(finest.status.size, np.bool_)
    wide, steps = wide_among(finest, limits.hertz_ratio), min(count, 3) - 1
    highest, at = largest_of(finest, limits.hertz_ratio, seen.singular)
    second, _ = largest_of(coarse, limits.hertz_ratio, seen.singular)
    third, _ = largest_of(coarser, limits.hertz_ratio, seen.singular)
    for case in range(found.size):
        row = 0 if finest.edges.shape[0] == 1 else case
        n = finest.counts[row]
        strained, depth, load, mean, ripple, half, length = _strained(finest, case, row, seen, limits)
        unsure = count == 1 or strained
        edges, whole, stiff = finest.edges[row, : n + 1], finest.m[case, :n], finest.stiffness[case, 0, 0]
        # How the contact ends.
        last = ends = 0.0
        for side in (-1, 1):
            width = edges[1] - edges[0] if side < 0 else edges[n] - edges[n - 1]
            place, last = edges[0] if side < 0 else edges[n], max(last, width)
            if reaches(edges, whole, side):
                ends += width
                unsure |= abs(place - limits.first) > 0.0 and abs(place - limits.last) > 0.0
        few, sharp = FEW_AT_END * last > half, False
        for k in range(seen.singular.shape[1]):
            sharp |= math.isfinite(seen.singular[case, k])
        unsure |= sharp and (few or limits.accuracy_given)
        unsure |= SHARP_END_ERROR * ends > 0.5 * limits.large * length
        # What halving the strips changes, once and twice; see `Levels`.
        unsure |= coarse.status[case] != CONVERGED or (steps > 1 and coarser.status[case] != CONVERGED)
        moved = borne = raised = 0.0
        for step in range(steps):
            fine, half_as_fine = (finest, coarse) if step == 0 else (coarse, coarser)
            by = fine.rigid[case, 0] - half_as_fine.rigid[case, 0], _load(fine, case) - _load(half_as_fine, case)
            more = highest[case] - second[case] if step == 0 else second[case] - third[case]
            raised = worse(raised, SAFETY / (1 + step) * abs(more))
            regular = limits.accuracy > 0.0 and not wide[case] and not sharp
            if step == 0 or not regular:
                share = LEFT_OF_CHANGE if regular else SAFETY / (1 + step)
                moved, borne = worse(moved, share * abs(by[0])), worse(borne, share * abs(by[1]))
        # Sharp ends and roughness add to that.
        room = (0.5 if sharp else MARGIN) * limits.large
        unsure |= not moved + MORE * mean <= room * abs(depth) or not borne + MORE * stiff * mean <= room * abs(load)
        coarseness = COARSE if limits.accuracy > ACCURACY else 1.0
        room = (0.5 if sharp else MARGIN) * LARGE_PRESSURE_ERROR * highest[case]
        unsure |= not coarseness * raised + _beside(finest, case, highest[case], ripple) <= room
        found[case] = unsure or _near_a_bend(edges, at[case], seen.bends)
    return found


@compiled
def _strained(
    states: States, case: int, row: int, seen: _Seen, limits: _Limits
) -> tuple[bool, float, float, float, float, float, float]:
    """Return whether the model may be strained, and what the strips add up to.

    Depth of the bodies, K Q, mean roughness, and the largest ripple; the largest half-width, and the length in contact.
    """
    edges, rigid = states.edges[row], states.rigid[case]
    widest = length = area = load = rough = ripple = 0.0
    strained, depth = False, -np.inf
    for i in range(states.counts[row]):
        width, m = edges[i + 1] - edges[i], states.m[case, i]
        half, borne = limits.hertz_ratio * math.sqrt(m), states.r[case, i] * m * width
        widest, area, load = max(widest, half), area + 2.0 * half * width, load + borne
        rough += borne * seen.departure[row, i]
        if m > 0.0:
            length += width
            ripple = max(ripple, RIPPLE * seen.departure[row, i] / width)
        depth = max(depth, rigid[0] + 0.5 * rigid[1] * (edges[i] + edges[i + 1]) - seen.separation[row, i])
        strained |= half * seen.sharper[row, i] > MOST_OF_RADIUS or seen.min_depth[row, i] < LEAST_DEPTH * half
        if i > 0 and (m > 0.0) != (states.m[case, i - 1] > 0.0):
            # The contact may go on in a wide strip beside it whose centre is out of contact.
            before = edges[i] - edges[i - 1]
            strained |= (before if m > 0.0 else width) > WIDE_BESIDE * (width if m > 0.0 else before)
    # The summed strip width overestimates the length of a split contact, but split contacts are rarely wide.
    strained |= 2.0 * widest > 0.25 * length or load > limits.pressure * area
    strained |= seen.uneven[case] > 0.9 * MOST_UNEVEN * depth
    return strained, depth, load, rough / load, ripple, widest, length


@compiled
def _beside(states: States, case: int, highest: float, ripple: float) -> float:
    """Return by how much what strips do not resolve may raise the largest pressure: ripples, and a narrow summit."""
    n, summit = states.counts[0 if states.edges.shape[0] == 1 else case], highest
    pressure = np.empty(n)
    for i in range(n):
        pressure[i] = states.r[case, i] * math.sqrt(states.m[case, i])
    for i in range(1, n - 1):
        summit = max(summit, cusp(pressure, i))
    return ripple + summit - highest


@compiled
def _load(states: States, case: int) -> float:
    row, total = 0 if states.edges.shape[0] == 1 else case, 0.0
    for i in range(states.counts[row]):
        total += states.r[case, i] * states.m[case, i] * (states.edges[row, i + 1] - states.edges[row, i])
    return total


@compiled
def _near_a_bend(edges: Array, y: float, bends: Array) -> bool:
    """Return whether a place is within some strips of a bend of the profile."""
    beside = 0
    for i in range(edges.size - 1):
        nearer = abs(edges[i] + edges[i + 1] - 2.0 * y) < abs(edges[beside] + edges[beside + 1] - 2.0 * y)
        beside = i if nearer else beside
    near = False
    for bend in bends:
        near |= abs(y - bend) <= AT_CORNER * (edges[beside + 1] - edges[beside])
    return near
