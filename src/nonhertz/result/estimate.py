"""The discretisation error of a solution, estimated from coarser grids and unresolved relief, for one case or many."""

from __future__ import annotations

import math
from functools import partial

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths import AxisOfRoller
from nonhertz.compiled import compiled
from nonhertz.result.checks import WIDER_THAN_LONG
from nonhertz.result.end_pressure import left_at_sharp_ends, sharp_end_error
from nonhertz.result.maximum import distance_beyond, largest_pressure
from nonhertz.result.solution import EdgeKind, EdgePressure, ErrorEstimate
from nonhertz.strip.grid import contact_of, intervals
from nonhertz.strip.levels import ACCURACY, SAFETY, Levels, cusps
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import States
from nonhertz.strip.resolution import departures, roughness, within

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

LARGE_ERROR, LARGE_PRESSURE_ERROR = 0.05, 0.2  # estimated errors; a result worse than this is unfit for design
FEW_AT_END = 4  # fewer strips within a half-width of an end do not resolve how the contact ends
FALLS_AWAY = 0.1  # of the interference: by this much at least it is less at an end than a half-width inside
PRESSURE_LEFT = 2.0  # of the accuracy aimed for: a change of the largest pressure may be small by chance
COARSE = 2.0  # times the usual estimate of the largest pressure, where grids are coarser than usual
# Times the exponent: by this much at most a sharp end raises the pressure a half-width from it above that of strips too
# wide to show it. Measured on straight rollers: 0.19 on half-spaces, 0.10 between mirrored, 0.02 between free ends.
RAISED = 0.38
HIDDEN = 4.0  # times the last strip's excess over the maximum: its mean is lower than the peak within it
# What the modes and polynomials of a whole roller leave of approach and largest pressure, by twice as many on random
# rollers. A load at one end alone leaves 8e-5 of the approach, one at a sharp end 5e-4 of the pressure beside it.
LEFT_BY_MODES, PRESSURE_LEFT_BY_MODES = 2e-5, 1e-4
MISSED = 0.02  # of the deepest interference: an overlap this large where no strip is in contact is a missed contact


def error_estimate(
    problem: Problem,
    levels: Levels,
    edges: tuple[EdgePressure, ...],
    singular: Array,
    highest: float,
    *,
    at_corner: bool,
) -> ErrorEstimate:
    """Return the estimated errors of the finest level; infinite if the loop failed.

    Parameters
    ----------
    problem, levels
        What was solved.
    edges : tuple of EdgePressure
        How the contact ends.
    singular : ndarray, shape (k,)
        The ends at which the pressure has no limit [mm].
    highest : float
        The largest pressure of the finest level more than a half-width from these, as `States.scaled_pressure`.
    at_corner : bool
        Whether that is at a corner of the profile within the contact.
    """
    state = levels.finest
    if not state.converged:
        return ErrorEstimate(*[math.inf] * 5)
    by_load, by_moment = problem.prescribed.tolist()
    floor = sharp_end_error(edges, sum(high - low for low, high in contact_of(state)))
    whole = has_whole_roller(problem)
    left = left_at_sharp_ends(problem, state, edges) + LEFT_BY_MODES * whole
    unlimited = at_corner or any(edge.kind is EdgeKind.CUT_OFF for edge in edges)
    places, separation = within(problem, state.edges)
    # Relief deeper than the bodies approach is out of contact, however deep it is.
    near = np.minimum(separation, np.maximum(state.rigid[0] + state.rigid[1] * places, np.min(separation)))
    departure = departures(near)
    mean, ripples = roughness(departure, state.width, state.r * state.m * state.width)
    # Relative to the penetration: what is approached before the bodies touch has no error, and may be most of it.
    penetration = float(np.max(state.rigid[0] + state.rigid[1] * places - separation))
    before_touch = float(state.rigid[0]) - penetration
    # Towards a corner errors fall in proportion to the strips only, and anyhow in contacts that are wider than long.
    corners = at_corner or any(edge.kind is EdgeKind.CORNER for edge in edges)
    wide = bool(wide_among(state.row(), problem.model.element.hertz_ratio)[0])
    error = levels.difference if corners or wide else levels.remaining
    aimed = levels.accuracy or 0.0
    unseen = _relative(mean, penetration), _relative(mean * state.stiffness[0, 0], float(state.scaled_load))
    reach = 0.5 * float(np.ptp(state.edges))

    def largest(of: States) -> float:
        return highest if of is state else _largest(problem.model.element.hertz_ratio, singular, of)

    return ErrorEstimate(
        approach=max(floor, error(partial(_beyond, before_touch)) + unseen[0]) + left if by_load else 0.0,
        load=0.0 if by_load else max(floor, error(_load) + unseen[1]) + left,
        max_pressure=math.inf
        if unlimited
        else max(
            floor,
            (COARSE if aimed > ACCURACY else 1.0) * max(PRESSURE_LEFT * aimed, levels.difference(largest)),
            _raised_at_ends(problem, state, edges, highest),
        )
        + _beside_strips(problem, levels, singular, ripples, highest)
        + PRESSURE_LEFT_BY_MODES * whole,
        moment=0.0 if by_moment else max(floor, error(_moment, float(state.scaled_load) * reach) + unseen[1]) + left,
        tilt=max(floor, error(_tilt, penetration / reach) + unseen[0]) + left if by_moment else 0.0,
    )


def has_whole_roller(problem: Problem) -> bool:
    """Return whether a body is a whole roller, of which modes and polynomials leave `LEFT_BY_MODES`."""
    return any(isinstance(each, AxisOfRoller) for each in problem.model.influence.references)


def _raised_at_ends(problem: Problem, state: States, edges: tuple[EdgePressure, ...], highest: float) -> float:
    """Return the relative error of the largest pressure if it is that a half-width from a sharp end, in wide strips."""
    half_width, raised = problem.model.element.hertz_ratio * np.sqrt(state.m), 0.0
    for edge in edges:
        distance = np.where(state.m > 0.0, np.abs(state.y - edge.y) - half_width, np.inf)
        if np.count_nonzero(distance <= 0.0) < FEW_AT_END and np.isfinite(distance).any():
            beyond = float(state.scaled_pressure[np.argmin(np.where(distance > 0.0, distance, np.inf))])
            raised = max(raised, (1.0 + RAISED * edge.exponent) * beyond / highest - 1.0)
    return raised


def _beside_strips(problem: Problem, levels: Levels, singular: Array, ripples: Array, highest: float) -> float:
    """Return the relative error of the largest pressure caused by what strips do not resolve.

    Flattening the departure from a parabola within each strip takes ripples of pressure. A summit may be narrower than
    its strips, and higher than another that they resolve. And on strips as wide as the contact, one that runs out
    shortly before the end of the bodies looks like one that reaches it: where the profile falls away there, the last
    strip may well have the largest pressure.
    """
    state = levels.finest
    half_width = problem.model.element.hertz_ratio * np.sqrt(state.m)
    bearing = state.m > 0.0
    hidden, sure = 0.0, []
    for end in singular:
        near = bearing & (np.abs(state.y - end) <= half_width)
        if 0 < np.count_nonzero(near) < FEW_AT_END and _falls_away(problem, state, end, float(half_width[near].max())):
            hidden = max(hidden, HIDDEN * (float(np.max(state.scaled_pressure[near])) / highest - 1.0))
        else:
            sure.append(end)
    counted = bearing & (distance_beyond(state.y, half_width, np.array(sure)) > 0.0)
    summit = float(np.max(np.where(counted, _reach(levels), 0.0)))
    return max(hidden, summit / highest - 1.0) + float(np.max(np.where(counted, ripples, 0.0))) / highest


def _reach(levels: Levels) -> Array:
    """Return how high summits may reach that are narrower than their strips, zero for all other strips.

    A summit stands out no further than by twice what halving the strips has just raised it by.
    """
    state = levels.finest
    reach: Array = cusps(state.scaled_pressure)
    if len(levels.states) > 1:
        coarse = levels.states[1]
        at = np.clip(np.searchsorted(coarse.edges, state.y) - 1, 0, coarse.scaled_pressure.size - 1)
        beside = np.pad(coarse.scaled_pressure, 1)
        before = np.max([beside[at + k] for k in range(3)], axis=0)
        reach = np.minimum(reach, state.scaled_pressure + SAFETY * np.abs(state.scaled_pressure - before))
    return reach


def _falls_away(problem: Problem, state: States, end: float, half_width: float) -> bool:
    """Return whether the bodies overlap less at an end than a half-width inside."""
    inside = end + math.copysign(half_width, float(np.mean(state.edges)) - end)
    places = np.array([end, inside])
    at_end, before = state.rigid[0] + state.rigid[1] * places - problem.model.separation(places)
    return bool(at_end < (1.0 - FALLS_AWAY) * before)


def _relative(part: Array, whole: float) -> float:
    return float(part) / abs(whole) if whole != 0.0 else math.inf


def _beyond(before_touch: float, state: States) -> float:
    return float(state.rigid[0]) - before_touch


def _load(state: States) -> float:
    return float(state.scaled_load)


def _moment(state: States) -> float:
    return float(state.scaled_moment)


def _tilt(state: States) -> float:
    return float(state.rigid[1])


def _largest(hertz_ratio: float, singular: Array, state: States) -> float:
    return float(largest_pressure(state.y, state.scaled_pressure, hertz_ratio * np.sqrt(state.m), singular)[0])


@compiled
def wide_among(states: States, hertz_ratio: float) -> Flags:
    """Return which contacts are wider than their longest piece is long."""
    found = np.empty(states.status.size, np.bool_)
    for case in range(found.size):
        row, widest, longest = 0 if states.edges.shape[0] == 1 else case, 0.0, 0.0
        n = states.counts[row]
        for m in states.m[case, :n]:
            widest = max(widest, 2.0 * hertz_ratio * math.sqrt(m))
        contact = intervals(states.edges[row, : n + 1], states.m[case, :n])
        for k in range(contact.shape[0]):
            longest = max(longest, contact[k, 1] - contact[k, 0])
        found[case] = widest > WIDER_THAN_LONG * longest
    return found
