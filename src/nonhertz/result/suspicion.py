"""Which of many cases have findings, or may have some, in one compiled pass over their strips: most have none."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.result.checks import HEAVIEST, LEAST_DEPTH, MOST_OF_MODULUS, MOST_OF_RADIUS, MOST_UNEVEN, unevenness
from nonhertz.result.end_pressure import Ends
from nonhertz.result.estimate import (
    APPROACH,
    LARGE_ERROR,
    LARGE_PRESSURE_ERROR,
    LEFT_BY_MODES,
    LEVELS,
    LOAD,
    MAX_PRESSURE,
    PRESSURE_LEFT_BY_MODES,
    has_whole_roller,
)
from nonhertz.result.validity import AT_CORNER, searched
from nonhertz.strip.overlaps import suspects
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import Grids, States

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

WIDE_BESIDE = 2.0  # times the last strip in contact: the one beside it may hide that the contact goes on


class Suspicions(NamedTuple):
    """Which of many cases have findings.

    Attributes
    ----------
    certain : ndarray of bool, shape (cases,)
        An error is large.
    missed : ndarray of bool, shape (cases,)
        There may be a contact that the strips have missed.
    strained : ndarray of bool, shape (cases,)
        There may be any finding: `nonhertz.result.validity.strains` decides.
    """

    certain: Flags
    missed: Flags
    strained: Flags


def suspicions(
    problem: Problem, grids: Grids, levels: Sequence[States], ends: Ends, errors: Array, at: Array
) -> Suspicions:
    """Return which of many cases have findings, but for those about ends without a limit.

    Parameters
    ----------
    problem : Problem
        What the cases share.
    grids : Grids
        The finest strips.
    levels : sequence of States
        The states of all cases on every grid, finest first.
    ends : Ends
        How the contacts end.
    errors : ndarray, shape (cases, 5)
        From `nonhertz.result.estimate.estimates`.
    at : ndarray, shape (cases,)
        Where the largest pressures are [mm].
    """
    finest, contact, ratio = levels[0], problem.contact, problem.model.element.hertz_ratio
    half_width = ratio * np.sqrt(finest.m)
    loads = finest.r * finest.m * finest.width
    uneven = unevenness(contact, np.broadcast_to(grids.y, half_width.shape), half_width, loads, finest.rigid)
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    hardest = 0.5 * MOST_OF_MODULUS * softer * contact.compliance
    strained, goes_on = _looked_over(finest, grids, uneven, np.array(contact.bends), at, ratio, hardest)
    strained |= ~np.logical_and.reduce([level.converged for level in levels[:LEVELS]])
    strained |= any(end.requested > HEAVIEST for end in problem.model.influence.ends)
    large = LARGE_ERROR
    if problem.accuracy_given and problem.accuracy is not None:
        large = min(LARGE_ERROR, problem.accuracy + LEFT_BY_MODES * has_whole_roller(problem))
    uncertain = np.maximum(errors[:, APPROACH], errors[:, LOAD]) > large
    large = LARGE_PRESSURE_ERROR
    if problem.pressure_accuracy is not None:
        large = problem.pressure_accuracy + PRESSURE_LEFT_BY_MODES * has_whole_roller(problem)
    uncertain |= errors[:, MAX_PRESSURE] > large
    region = searched(contact, float(finest.edges[:, 0].min()), float(finest.edges[:, -1].max()))
    missed = goes_on | suspects(problem, finest, region)
    return Suspicions(uncertain & ~strained, missed & ~strained & ~uncertain, strained)


@compiled
def _looked_over(
    states: States, grids: Grids, uneven: Array, bends: Array, at: Array, hertz_ratio: float, hardest: float
) -> tuple[Flags, Flags]:
    """Return where the model may be strained or the largest pressure be at a corner, and where a contact may go on.

    It may in a wide strip beside it whose centre is out of contact.
    """
    found, beside = np.empty(states.status.size, np.bool_), np.zeros(states.status.size, np.bool_)
    for case in range(found.size):
        row = 0 if states.edges.shape[0] == 1 else case
        edges, rigid, n = states.edges[row], states.rigid[case], states.counts[row]
        widest = length = area = load = 0.0
        strained, depth = _near_a_bend(edges[: n + 1], at[case], bends), -np.inf
        for i in range(n):
            width, m = edges[i + 1] - edges[i], states.m[case, i]
            half = hertz_ratio * math.sqrt(m)
            widest, area, load = max(widest, half), area + 2.0 * half * width, load + states.r[case, i] * m * width
            if m > 0.0:
                length += width
            depth = max(depth, rigid[0] + 0.5 * rigid[1] * (edges[i] + edges[i + 1]) - grids.separation[row, i])
            strained |= half * grids.sharper[row, i] > MOST_OF_RADIUS or grids.min_depth[row, i] < LEAST_DEPTH * half
            if i > 0 and (m > 0.0) != (states.m[case, i - 1] > 0.0):
                before = edges[i] - edges[i - 1]
                beside[case] |= (before if m > 0.0 else width) > WIDE_BESIDE * (width if m > 0.0 else before)
        # The summed strip width overestimates the length of a split contact, but split contacts are rarely wide.
        strained |= 2.0 * widest > 0.25 * length or load > hardest * area
        found[case] = strained or uneven[case] > 0.9 * MOST_UNEVEN * depth
    return found, beside


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
