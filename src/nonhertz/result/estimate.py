"""How much a solution may err by its strips: what coarser grids and unseen relief say, for one case or many."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nonhertz.result.end_pressure import SHARP_END_ERROR, sharp_end_error
from nonhertz.result.solution import EdgePressure, ErrorEstimate
from nonhertz.strip.batch import States
from nonhertz.strip.levels import SAFETY, Levels
from nonhertz.strip.newton import CONVERGED
from nonhertz.strip.resolution import departures, roughness, within
from nonhertz.strip.state import Problem, State

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

LARGE_ERROR, LARGE_PRESSURE_ERROR = 0.05, 0.2  # estimated; a result worse than that is no design figure
MISSED = 0.02  # of the deepest interference, overlapped where strips say that there is no contact


def error_estimate(problem: Problem, levels: Levels, edges: tuple[EdgePressure, ...], at_corner: bool) -> ErrorEstimate:
    """Return the estimated errors of the finest level; infinite of a loop that failed."""
    state = levels.finest
    if not state.converged:
        return ErrorEstimate(math.inf, math.inf, math.inf)
    by_load = bool(problem.prescribed[0])
    floor = sharp_end_error(edges, sum(high - low for low, high in state.contact))
    singular = at_corner or not all(edge.converges for edge in edges)
    places, separation = within(problem, state.edges)
    # What stands back farther than the bodies come together is out of contact, however far it does.
    near = np.minimum(separation, np.maximum(state.rigid[0] + state.rigid[1] * places, np.min(separation)))
    departure = departures(near)
    mean, ripple = roughness(departure, state.width, state.r * state.m * state.width, state.pressure)
    unseen = _relative(mean, state.rigid[0]), _relative(mean * state.stiffness[0, 0], state.load)
    return ErrorEstimate(
        approach=max(floor, levels.difference(_approach) + unseen[0]) if by_load else 0.0,
        load=0.0 if by_load else max(floor, levels.difference(_load) + unseen[1]),
        max_pressure=math.inf if singular else levels.difference(_pressure) + float(ripple),
    )


def _relative(part: Array, whole: float) -> float:
    return float(part) / abs(float(whole)) if whole != 0.0 else math.inf


def _approach(state: State) -> float:
    return float(state.rigid[0])


def _load(state: State) -> float:
    return state.load


def _pressure(state: State) -> float:
    return float(np.max(state.pressure))


def may_be_uncertain(problem: Problem, levels: Sequence[States]) -> Flags:
    """Return which cases may have a large estimated error: all that a coarser grid has no solution of, too."""
    finest = levels[0]
    unsure: Flags = np.full(finest.status.shape, len(levels) == 1)
    width = np.diff(finest.edges)
    loads, pressures = finest.r * finest.m * width, finest.r * np.sqrt(finest.m)
    mean, ripple = roughness(departures(within(problem, finest.edges)[1]), width, loads, pressures)
    for known, left in ((finest.rigid[:, 0], mean), (np.sum(loads, axis=1), finest.stiffness[:, 0, 0] * mean)):
        unsure |= left > 0.5 * LARGE_ERROR * np.abs(known)
    unsure |= ripple > 0.5 * LARGE_PRESSURE_ERROR
    ends = SHARP_END_ERROR * (width[0] * (loads[:, 0] > 0.0) + width[-1] * (loads[:, -1] > 0.0))
    unsure |= ends > 0.5 * LARGE_ERROR * ((finest.m > 0.0) @ width)
    for fine, coarse in itertools.pairwise(levels[:3]):
        unsure |= coarse.status != CONVERGED
        for value, large in ((_approaches, LARGE_ERROR), (_loads, LARGE_ERROR), (_pressures, LARGE_PRESSURE_ERROR)):
            with np.errstate(invalid="ignore"):
                unsure |= ~(SAFETY * np.abs(value(fine) - value(coarse)) <= 0.5 * large * np.abs(value(finest)))
    return unsure


def _approaches(states: States) -> Array:
    return states.rigid[:, 0]


def _loads(states: States) -> Array:
    loads: Array = (states.r * states.m) @ np.diff(states.edges)
    return loads


def _pressures(states: States) -> Array:
    pressures: Array = (states.r * np.sqrt(states.m)).max(axis=1)
    return pressures


def may_miss_contact(problem: Problem, finest: States) -> Flags:
    """Return which cases may touch beside the centres of strips that are out of contact."""
    places, separation = within(problem, finest.edges)
    y = 0.5 * (finest.edges[1:] + finest.edges[:-1])
    with np.errstate(invalid="ignore"):  # both infinite
        lower = np.nan_to_num(np.interp(places, y, problem.separation(y)) - separation, posinf=np.inf)
    deepest = np.max(finest.rigid[:, :1] + finest.rigid[:, 1:] * y - problem.separation(y), axis=1)
    missed: Flags = np.zeros(deepest.shape, dtype=bool)
    for strip in np.flatnonzero(np.max(lower, axis=1) > MISSED * np.min(deepest)):
        depth = finest.rigid[:, :1] + finest.rigid[:, 1:] * places[strip] - separation[strip]
        bump = (depth > 0.0) & (lower[strip] > MISSED * deepest[:, None])
        missed |= (finest.m[:, strip] == 0.0) & np.any(bump, axis=1)
    return missed
