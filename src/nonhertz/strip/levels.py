"""Grids solved from coarse to fine, each solution providing the start and the grading of the next.

On strips that are wide compared with the half-width the Newton loop converges from springs; on narrow ones it needs a
start that has the shape of the contact, which a coarser level provides. An automatic grid is made in the same way:
equal strips find the contact, a rough graded grid locates its ends and bends, and the final grid is solved
with half its strips and with all. The levels also give an error estimate: see `Levels.difference`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.strip.acceptance import steady
from nonhertz.strip.feasible import (
    FINE_STRIPS,
    feasible,
    refuse_arm_outside,
    refuse_endless_relief,
    refuse_infeasible,
    refuse_no_contact,
)
from nonhertz.strip.grid import Grading, cut_off, graded, overlaps, sizes, uniform
from nonhertz.strip.newton import ROUGH_TOLERANCE, TOLERANCE
from nonhertz.strip.state import Problem, State, settle, sprung

Array = NDArray[np.float64]
Interval = tuple[float, float]

STRIP_LIMIT = 87  # of an automatic grid on one interval of contact
COARSE_STRIPS = 24
COARSEST_LEVEL = 5
PATIENT_STRIPS = 400
MORE_STRIPS = (1, 5, 25)  # times as many to begin with, in case fewer miss the contact
FEWER_STRIPS = (1.0, 0.94, 0.88, 0.82, 0.76)  # tried in turn where a grid has no solution
# Fractions of the strips: a rough grid that grades the final one, then half of the final one and all of it; and these
# again, if the solution shows that another contact was missed.
LESSONS = ((0.35,), (0.5, 1.0))
REPEATS = (LESSONS[-1], LESSONS[-1])
WELL_FILLED = 0.4  # fraction of the region that the contact must fill before a grid is graded from it
SAFETY = 2.0


@dataclass(frozen=True)
class Levels:
    """The solution and those on coarser grids, finest first; coarser ones that did not converge are left out."""

    states: tuple[State, ...]

    @property
    def finest(self) -> State:
        """The state on the grid of the result."""
        return self.states[0]

    def difference(self, quantity: Callable[[State], float]) -> float:
        """Return an estimate of the relative error of a quantity.

        An error that halves when the strips are halved is as large as the last change. At sharp ends it falls a little
        less, and a contact whose end happens to suit the strips can hide it in one change, but hardly in two: so twice
        the larger of the last change and half the change before it.
        """
        values = [quantity(state) for state in self.states if state.converged]
        if len(values) < 2 or values[0] == 0.0:
            return math.inf
        changes = np.abs(np.diff(values[:3])) / abs(values[0])
        error = float(SAFETY * np.max([changes[0], 0.5 * changes[-1]]))
        return error if math.isfinite(error) else math.inf


def equal_grids(problem: Problem, interval: Interval, count: int) -> list[Array]:
    """Return the edges of ``count`` equal strips where the bodies can touch, and of half as many down to a few."""
    low, high = bounded(problem, interval)
    counts = [count]
    while counts[-1] // 2 >= COARSEST_LEVEL or (len(counts) == 1 and count > 1):
        counts.append(counts[-1] // 2)
    return [uniform(low, high, level) for level in counts]


def given_grids(edges: Array) -> list[Array]:
    """Return given edges, and coarser grids that leave out every other one."""
    grids = [edges]
    while grids[-1].size // 2 > COARSEST_LEVEL or (len(grids) == 1 and edges.size > 2):
        grids.append(np.unique(np.concatenate([grids[-1][:-1:2], edges[-1:]])))
    return grids


def on_equal_strips(problem: Problem, interval: Interval, count: int) -> Levels:
    """Return the solution on ``count`` equal strips over the interval on which the bodies can touch."""
    return _raised(problem, equal_grids(problem, interval, count))


def on_given_strips(problem: Problem, edges: Array) -> Levels:
    """Return the solution on the strips between ``edges``."""
    return _raised(problem, given_grids(edges))


def on_automatic_strips(problem: Problem, interval: Interval, bends: tuple[float, ...]) -> Levels:
    """Return the solution on a graded grid; ``bends`` are where the profiles bend."""
    finite = bounded(problem, interval)
    states = [_located(problem, interval, finite)]
    for lesson, shares in enumerate(LESSONS + REPEATS):
        complete = lesson >= len(LESSONS)
        if not states[0].converged:
            break
        if complete and not any(cut_off(states[0], interval)) and not overlaps(problem, states[0], finite):
            break
        requested = sizes(problem, states[0], bends, finite)
        grading = graded(requested, STRIP_LIMIT if len(requested.contact) == 1 else 2 * STRIP_LIMIT)
        for share in shares:
            states.insert(0, _settled(problem, grading, states[0], share))
    # The equal strips that found the contact are too few to say anything about the error.
    return Levels(tuple(states[:-1]) or tuple(states))


def _raised(problem: Problem, grids: list[Array]) -> Levels:
    """Solve on every grid, the last and coarsest first."""
    refuse_infeasible(problem, grids[0])
    states: list[State] = []
    for edges in reversed(grids[1:]):
        if feasible(problem, edges):
            state = settle(problem, edges, states[0] if states else None, patient=False, tolerance=ROUGH_TOLERANCE)
            if state.converged:
                states.insert(0, state)
    # Where no coarser grid has a solution, hours of retries on very many strips would not find one either.
    patient = bool(states) or grids[0].size <= PATIENT_STRIPS
    return Levels((settle(problem, grids[0], states[0] if states else None, patient=patient), *states))


def _settled(problem: Problem, grading: Grading, near: State, share: float) -> State:
    """Return the solution on a graded grid, or on a slightly coarser one if there is none.

    Where a blunt contact ends just at the edge of a strip, that strip can be unable to carry load (its neighbours
    alone curve the surface more than the bodies do) and yet overlap without it. The next grid has its edges
    elsewhere. It is also tried when the solution found is unstable, as spurious ones are in contacts several times as
    wide as long.
    """
    state = near
    tolerance = TOLERANCE if share == 1.0 else ROUGH_TOLERANCE
    for fewer in FEWER_STRIPS:
        last = fewer == FEWER_STRIPS[-1]
        state = settle(problem, grading.edges(fewer * share), near, patient=last, tolerance=tolerance)
        if state.converged and steady(state.stiffness, float(np.max(np.abs(state.edges)))):
            break
    return state


def _located(problem: Problem, interval: Interval, finite: Interval) -> State:
    """Return a solution on equal strips of a region that the contact fills well, searching from ``finite`` inwards."""
    edges = _first_strips(problem, finite)
    state = settle(problem, edges, tolerance=ROUGH_TOLERANCE)
    for _ in range(40):
        if not state.converged:
            break
        ends = state.contact
        first, last = ends[0][0], ends[-1][1]
        span = last - first
        low, high = float(state.edges[0]), float(state.edges[-1])
        cut = (state.m[0] > 0.0 and low > interval[0]) or (state.m[-1] > 0.0 and high < interval[1])
        if not cut and span > WELL_FILLED * (high - low):
            break
        margin = max(0.3 * span, 2.0 * float(np.min(state.width))) * (4.0 if cut else 1.0)
        edges = uniform(max(first - margin, interval[0]), min(last + margin, interval[1]), COARSE_STRIPS)
        state = settle(problem, edges, tolerance=ROUGH_TOLERANCE)
    return state


def _first_strips(problem: Problem, finite: Interval) -> Array:
    """Return equal strips that can meet what is prescribed: all along the bodies, or near where they touch."""
    edges = uniform(*finite, COARSE_STRIPS)
    y = 0.5 * (edges[1:] + edges[:-1])
    refuse_endless_relief(y, problem.separation(y))
    # A prescribed approach may bring only a tiny spot into contact, a moment only the very end.
    if problem.prescribed[0] and feasible(problem, edges):
        return edges
    refuse_arm_outside(problem, finite)
    regions = [_neighbourhood(problem, *finite)]
    if np.all(problem.prescribed):
        regions.append(_region_at_end(problem, finite))
    for region, more in product(regions, MORE_STRIPS):
        edges = uniform(*region, more * COARSE_STRIPS)
        if feasible(problem, edges):
            break
    refuse_infeasible(problem, edges, chosen=False)
    return edges


def _region_at_end(problem: Problem, finite: Interval) -> Interval:
    """Return a region at one end of the bodies, centred on the resultant of load and moment."""
    low, high = finite
    arm = float(problem.target[1] / problem.target[0])
    return (max(low, 2.0 * arm - high), high) if high - arm < arm - low else (low, min(high, 2.0 * arm - low))


def _neighbourhood(problem: Problem, low: float, high: float) -> tuple[float, float]:
    """Return the interval in which springs find contact, with a margin."""
    for _ in range(3):
        fine = sprung(problem, uniform(low, high, FINE_STRIPS))
        touching = np.flatnonzero(fine.m > 0.0)
        margin = float(high - low) / FINE_STRIPS
        if touching.size:
            first, last = float(fine.edges[touching[0]]), float(fine.edges[touching[-1] + 1])
            margin += 0.3 * (last - first)
            return max(low, first - margin), min(high, last + margin)
        nearest = float(fine.y[np.argmax(fine.rigid[0] + fine.rigid[1] * fine.y - problem.separation(fine.y))])
        low, high = max(low, nearest - 2.0 * margin), min(high, nearest + 2.0 * margin)
    return low, high


def bounded(problem: Problem, interval: Interval) -> Interval:
    """Return the interval in which to look for the contact; finite even where the bodies are unbounded."""
    low, high = interval
    if math.isfinite(low) and math.isfinite(high):
        return low, high
    scale = 1.0 / float(np.max(problem.curvature(np.zeros(1))))
    edge = np.concatenate([[0.0], scale * np.geomspace(1e-9, 1e4, 130)])
    edges = np.unique(np.clip(np.concatenate([-edge[::-1], edge]), low, high))
    if np.all(problem.prescribed) and not np.all(np.isfinite(problem.separation(edges))):
        low, high = _finite_part(problem, edges)
        edges = np.unique(np.clip(edges, low, high))
        refuse_arm_outside(problem, (low, high))
    touching = np.flatnonzero(sprung(problem, edges).m > 0.0)
    if touching.size == 0 and not problem.prescribed[0]:
        refuse_no_contact(problem, edges, chosen=False)
    if touching.size == 0:
        return _finite_part(problem, edges)
    first, last = touching[0], touching[-1] + 1
    if (first == 0 and not math.isfinite(low)) or (last == edges.size - 1 and not math.isfinite(high)):
        remedy = "give one of the bodies a length, or a profile that falls away"
        raise InputError("length", None, "be given where nothing else ends the contact", remedy)
    reach = 0.5 * float(edges[last] - edges[first])
    return max(low, float(edges[first]) - reach), min(high, float(edges[last]) + reach)


def _finite_part(problem: Problem, edges: Array) -> Interval:
    """Return the interval around y = 0 on which the separation is finite, as if the bodies ended there."""
    ends = []
    for beyond in (edges[edges <= 0.0][::-1], edges[edges >= 0.0]):
        finite = np.isfinite(problem.separation(beyond))
        first = int(np.argmin(finite)) if not np.all(finite) else 0
        inside, outside = (float(beyond[max(first - 1, 0)]), float(beyond[first]))
        for _ in range(100):
            middle = 0.5 * (inside + outside)
            if np.isfinite(problem.separation(np.array([middle]))[0]):
                inside = middle
            else:
                outside = middle
        ends.append(outside)
    return ends[0], ends[1]
