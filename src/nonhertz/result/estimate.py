"""The discretisation errors of solutions, estimated from coarser grids and unresolved relief, for one case or many."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths import AxisOfRoller
from nonhertz.compiled import compiled
from nonhertz.result.checks import WIDER_THAN_LONG
from nonhertz.result.end_pressure import CORNER, CUT_OFF, SINGULAR, Ends
from nonhertz.result.maximum import largest_of
from nonhertz.strip.grid import intervals
from nonhertz.strip.levels import ACCURACY, LEFT_OF_CHANGE
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import CONVERGED, States
from nonhertz.strip.resolution import RIPPLE, departure, within
from nonhertz.strip.summit import SAFETY, Pressures, cusp, error_at_summit, is_on_corner, pressures_of, resolved_summit

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

LARGE_ERROR, LARGE_PRESSURE_ERROR = 0.05, 0.2  # estimated errors; a result worse than this is unfit for design
FEW_AT_END = 4  # fewer strips within a half-width of an end do not resolve how the contact ends
FALLS_AWAY = 0.1  # of the interference: by this much at least it is less at an end than a half-width inside
# Of the accuracy aimed for: a change of the largest pressure may be small by chance. And on a rounded corner, on any
# grid: where strips lie on the step of its curvature changes the peak by that much.
PRESSURE_LEFT, LEFT_ON_CORNER = 1.0, 6e-4
COARSE = 2.0  # times the usual estimate of the largest pressure, where grids are coarser than usual
# Times the exponent: by this much at most a sharp end raises the pressure a half-width from it above that of strips too
# wide to show it. Measured on straight rollers: 0.19 on half-spaces, 0.10 between mirrored, 0.02 between free ends.
RAISED = 0.38
HIDDEN = 4.0  # times the last strip's excess over the maximum: its mean is lower than the peak within it
# What the modes and polynomials of a whole roller leave of approach and largest pressure, by twice as many on random
# rollers. A load at one end alone leaves 8e-5 of the approach, one at a sharp end 5e-4 of the pressure beside it.
LEFT_BY_MODES, PRESSURE_LEFT_BY_MODES = 2e-5, 1e-4
MISSED = 0.02  # of the deepest interference: an overlap this large where no strip is in contact is a missed contact
APPROACH, LOAD, MAX_PRESSURE, MOMENT, TILT = range(5)  # columns of the estimates
LEVELS = 3  # of grids, from whose changes errors are estimated
SHARP_END_ERROR, LEFT_AT_END = 0.12, 0.016  # see `_at_ends`
USUALLY_LEFT = 0.9  # of the accuracy aimed for: 6 of 750 errors are larger where the change is small, up to 1.8


def estimates(
    problem: Problem, levels: Sequence[States], accuracy: float | None, ends: Ends, at_corner: Flags
) -> Array:
    """Return the estimated errors of the finest levels, infinite where a loop failed.

    Parameters
    ----------
    problem : Problem
        What the cases share.
    levels : sequence of States
        The states of all cases on every grid, finest first. Where a case has not converged on the second or third, its
        errors mean nothing.
    accuracy : float or None
        As `nonhertz.strip.levels.Levels.accuracy`.
    ends : Ends
        How the contacts end.
    at_corner : ndarray of bool, shape (cases,)
        Whether the largest pressures of the finest level are at a corner of the profile within the contact.

    Returns
    -------
    ndarray, shape (cases, 5)
        As the fields of `nonhertz.result.solution.ErrorEstimate`.
    """
    finest, ratio = levels[0], problem.model.element.hertz_ratio
    whole = has_whole_roller(problem)
    known = _Known(
        problem.prescribed, at_corner, _falls_away(problem, finest, ends.singular),
        *within(problem, finest.edges), accuracy or 0.0, ratio, LEFT_BY_MODES * whole, PRESSURE_LEFT_BY_MODES * whole,
    )  # fmt: skip
    coarse, coarser = (levels[min(k, len(levels) - 1)] for k in (1, 2))
    errors: Array = _estimates(finest, coarse, coarser, min(len(levels), LEVELS), ends, known)
    return errors


def has_whole_roller(problem: Problem) -> bool:
    """Return whether a body is a whole roller, of which modes and polynomials leave `LEFT_BY_MODES`."""
    return any(isinstance(each, AxisOfRoller) for each in problem.model.influence.references)


def _falls_away(problem: Problem, states: States, singular: Array) -> Flags:
    """Return beside which ends that few strips resolve the bodies overlap less than a half-width inside."""
    inside = _inside_few(states, problem.model.element.hertz_ratio, singular)
    found = np.zeros(singular.shape, dtype=bool)
    few = np.nonzero(np.isfinite(inside))
    case = few[0]
    if case.size:
        places = np.array([singular[few], inside[few]])
        separation = problem.model.separation(places.ravel()).reshape(places.shape)
        at_end, before = states.rigid[case, 0] + states.rigid[case, 1] * places - separation
        found[few] = at_end < (1.0 - FALLS_AWAY) * before
    return found


@compiled
def _inside_few(states: States, hertz_ratio: float, singular: Array) -> Array:
    """Return the place a half-width inside each end that few strips resolve [mm], nan for any other."""
    found: Array = np.full(singular.shape, np.nan)
    for case in range(found.shape[0]):
        row = 0 if states.edges.shape[0] == 1 else case
        n = states.counts[row]
        edges, middle = states.edges[row, : n + 1], 0.0
        for edge in edges:
            middle += edge / edges.size
        for k in range(found.shape[1]):
            count, widest = 0, 0.0
            for i in range(n):
                half_width = hertz_ratio * math.sqrt(states.m[case, i])
                if half_width > 0.0 and abs(0.5 * (edges[i] + edges[i + 1]) - singular[case, k]) <= half_width:
                    count, widest = count + 1, max(widest, half_width)
            if 0 < count < FEW_AT_END:
                found[case, k] = singular[case, k] + math.copysign(widest, middle - singular[case, k])
    return found


class _Known(NamedTuple):
    """What the estimates depend on beside states and ends."""

    prescribed: Flags
    at_corner: Flags
    falls_away: Flags
    places: Array
    separation: Array
    accuracy: float
    hertz_ratio: float
    left_by_modes: float
    pressure_left_by_modes: float


# Without reductions of whole arrays, whose code Numba has not loaded yet: that takes longer than a contact.


@compiled
def _estimates(finest: States, coarse: States, coarser: States, count: int, ends: Ends, known: _Known) -> Array:
    errors = np.full((finest.status.size, 5), np.inf)
    wide = wide_among(finest, known.hertz_ratio)
    largest, at = largest_of(finest, known.hertz_ratio, ends.singular)
    second, _ = largest_of(coarse, known.hertz_ratio, ends.singular)
    third, _ = largest_of(coarser, known.hertz_ratio, ends.singular)
    values = np.empty((LEVELS, 5))
    for case in range(errors.shape[0]):
        if finest.status[case] != CONVERGED:
            continue
        highest, at_corner = largest[case], known.at_corner[case]
        cut_off = corners = False
        for kind in ends.kinds[case]:
            cut_off, corners = cut_off or kind == CUT_OFF, corners or kind == CORNER
        # Towards a corner errors fall in proportion to the strips only, and anyhow in contacts wider than long.
        accuracy = 0.0 if at_corner or corners or wide[case] else known.accuracy
        strips = pressures_of(finest, known.hertz_ratio, case)
        penetration, mean, ripples = _unresolved(finest, known, strips, case)
        # Relative to the penetration: what is approached before the bodies touch has no error, and may be most of it.
        before_touch = finest.rigid[case, 0] - penetration
        for k, (states, pressure) in enumerate(((finest, highest), (coarse, second[case]), (coarser, third[case]))):
            load, moment = _resultant(states, case)
            values[k] = states.rigid[case, 0] - before_touch, load, pressure, moment, states.rigid[case, 1]
        floor, left, raised = _at_ends(strips, ends, highest, values[0, LOAD], case)
        left, usual = left + known.left_by_modes, max(floor, USUALLY_LEFT * accuracy)
        load, reach = values[0, LOAD], 0.5 * (strips.edges[-1] - strips.edges[0])
        unseen, unborne = _relative(mean, penetration), _relative(mean * finest.stiffness[case, 0, 0], load)
        of_grids = np.empty(5)
        for k, whole in enumerate((abs(values[0, APPROACH]), abs(load), highest, load * reach, penetration / reach)):
            of_grids[k] = left_of_change(values[:count, k], whole, k != MAX_PRESSURE and accuracy > 0.0)
        summit = resolved_summit(strips, at[case])
        if summit > 0 and count > 1:
            before = pressures_of(coarse, known.hertz_ratio, case)
            before_that = pressures_of(coarser, known.hertz_ratio, case)
            of_grids[MAX_PRESSURE] = error_at_summit(strips, summit, before, before_that, accuracy > 0.0)
        for by_force, motion, force in ((known.prescribed[0], APPROACH, LOAD), (known.prescribed[1], TILT, MOMENT)):
            errors[case, motion] = max(usual, of_grids[motion] + unseen) + left if by_force else 0.0
            errors[case, force] = 0.0 if by_force else max(usual, of_grids[force] + unborne) + left
        if not (at_corner or cut_off):
            coarseness = COARSE if known.accuracy > ACCURACY else 1.0
            least = PRESSURE_LEFT * known.accuracy
            if summit > 0 and is_on_corner(strips, summit):
                least = max(least, LEFT_ON_CORNER)
            by_strips = max(floor, coarseness * max(least, of_grids[MAX_PRESSURE]), raised)
            reach_of = _reaches(strips, coarse, case, count)
            beside = _beside_strips(
                strips, ends.singular[case], known.falls_away[case], reach_of, ripples, highest, at[case]
            )
            errors[case, MAX_PRESSURE] = by_strips + beside + known.pressure_left_by_modes
    return errors


@compiled
def _unresolved(states: States, known: _Known, strips: Pressures, case: int) -> tuple[float, float, Array]:
    """Return the penetration, and what of the relief strips do not resolve.

    The mean departure from parabolas within the strips [mm], by their loads, and the ripple of pressure, as K q / a,
    that flattens each strip. A wave of amplitude A and length l takes pi E* A / l = A / (K l), and within a strip l is
    at most the strip's width.
    """
    row = 0 if states.edges.shape[0] == 1 else case
    rigid, n = states.rigid[case], strips.y.size
    places, separation = known.places[row, :n], known.separation[row, :n]
    least, penetration, load = np.inf, -np.inf, 0.0
    for i in range(n):
        load += strips.load[i]
        for k in range(places.shape[1]):
            least = min(least, separation[i, k])
    mean, ripples, within_strip = 0.0, np.empty(n), np.empty(places.shape[1])
    for i in range(n):
        for k in range(within_strip.size):
            depth = rigid[0] + rigid[1] * places[i, k]
            penetration = max(penetration, depth - separation[i, k])
            # Relief deeper than the bodies approach is out of contact, however deep it is.
            within_strip[k] = min(separation[i, k], max(depth, least))
        off = departure(within_strip)
        mean, ripples[i] = mean + strips.load[i] * off, RIPPLE * off / (strips.edges[i + 1] - strips.edges[i])
    return penetration, mean / load, ripples


@compiled
def _at_ends(strips: Pressures, ends: Ends, highest: float, load: float, case: int) -> tuple[float, float, float]:
    """Return what ends of the contact leave of approach or load on these strips, and on any; and of the pressure.

    The first is in proportion to the width of the last strip: measured on straight rollers, a tenth of both end strips'
    widths over the length, on equal and graded grids alike; 0.4 of that at kappa = 1/4, 0.2 at 1/2, 0.06 at 3/4 and
    zero at 1. Ends that are free of normal stress count as those of images with the same exponent.

    The second no number of strips removes. Within a half-width of a sharp end the pressure across is no semi-ellipse;
    what that changes is in proportion to the load that a length of one half-width bears there: for kappa = 0, 0.0150 of
    its share of the load on a straight roller and 0.0103 on a crowned one, against three-dimensional solutions;
    `LEFT_AT_END` is above both.

    The third is that of the largest pressure if it is that a half-width from a sharp end, in wide strips.
    """
    floor = left = raised = length = 0.0
    contact = intervals(strips.edges, strips.half_width**2)
    for k in range(contact.shape[0]):
        length += contact[k, 1] - contact[k, 0]
    for side in range(2):
        y, exponent = ends.y[case, side], ends.exponent[case, side]
        sharpness = (1.0 - math.cos(math.pi * exponent)) ** 1.5
        floor += SHARP_END_ERROR * ends.width[case, side] * sharpness / length
        distance = np.abs(strips.y - y)
        if ends.kinds[case, side] == SINGULAR:
            at = _least(distance - strips.half_width[_least(distance - strips.half_width)])
            borne = strips.load[at] / (strips.edges[at + 1] - strips.edges[at]) * strips.half_width[at]
            left += LEFT_AT_END * borne * sharpness / load
        near, nearest, beyond = 0, np.inf, highest
        for i in range(distance.size):
            if strips.half_width[i] > 0.0:
                past = distance[i] - strips.half_width[i]
                near += past <= 0.0
                if 0.0 < past < nearest:
                    nearest, beyond = past, strips.pressure[i]
        if near < FEW_AT_END:
            raised = max(raised, (1.0 + RAISED * exponent) * beyond / highest - 1.0)
    return floor, left, raised


@compiled
def _least(values: Array) -> int:
    """Return which of some numbers is the least in magnitude."""
    at = 0
    for i in range(values.size):
        at = i if abs(values[i]) < abs(values[at]) else at
    return at


@compiled
def _reaches(strips: Pressures, coarse: States, case: int, count: int) -> Array:
    """Return how high summits may reach that are narrower than their strips, zero for all other strips.

    A summit stands out no further than by twice what halving the strips has just raised it by.
    """
    found = np.zeros(strips.y.size)
    before, at = pressures_of(coarse, 1.0, case), 0
    for i in range(1, found.size - 1):
        found[i] = cusp(strips.pressure, i)
        if count > 1:
            while at + 1 < before.y.size and before.edges[at + 1] < strips.y[i]:
                at += 1
            height = 0.0
            for pressure in before.pressure[max(at - 1, 0) : at + 2]:
                height = max(height, pressure)
            found[i] = min(found[i], strips.pressure[i] + SAFETY * abs(strips.pressure[i] - height))
    return found


@compiled
def _beside_strips(
    strips: Pressures, singular: Array, falls_away: Flags, reaches: Array, ripples: Array, highest: float, at: float
) -> float:
    """Return the relative error of the largest pressure caused by what strips do not resolve.

    Flattening the departure from a parabola within a strip takes a ripple of pressure: by that the largest may be
    higher, and one elsewhere if that makes it higher than the largest. A summit may be narrower than its strips, and
    higher than another that they resolve. And on strips as wide as the contact, one that runs out shortly before the
    end of the bodies looks like one that reaches it: where the profile falls away there, the last strip may well have
    the largest pressure.
    """
    hidden = reached = own = 0.0
    for i in range(strips.y.size):
        counted = strips.half_width[i] > 0.0
        for k in range(singular.size):
            if abs(strips.y[i] - singular[k]) <= strips.half_width[i]:
                if falls_away[k]:
                    hidden = max(hidden, HIDDEN * (strips.pressure[i] / highest - 1.0))
                else:
                    counted = False
        is_there = strips.edges[i] <= at <= strips.edges[i + 1]
        if is_there:
            own = max(own, ripples[i])
        if counted:
            reached = max(reached, max(reaches[i], strips.pressure[i]) + (0.0 if is_there else ripples[i]))
    return max(hidden, reached / highest - 1.0) + own / highest


@compiled
def _resultant(states: States, case: int) -> tuple[float, float]:
    """Return K Q and K T."""
    row, load, moment = 0 if states.edges.shape[0] == 1 else case, 0.0, 0.0
    for i in range(states.counts[row]):
        low, high = states.edges[row, i], states.edges[row, i + 1]
        borne = states.r[case, i] * states.m[case, i] * (high - low)
        load, moment = load + borne, moment + 0.5 * (low + high) * borne
    return load, moment


@compiled
def left_of_change(values: Array, whole: float, regular: bool = False) -> float:
    """Return an estimate of the error of a quantity from its values on successively coarser grids.

    An error that halves when the strips are halved is as large as the last change. At sharp ends it falls a little
    less, and a contact whose end happens to suit the strips can hide it in one change, but hardly in two: so it is
    twice the larger of the last change and half the change before it. Where strips follow the ends of the contact,
    errors fall to a quarter or less, and `LEFT_OF_CHANGE` of the last change is left at most; but a change may be small
    by chance: `USUALLY_LEFT` says what such grids leave at least.

    Parameters
    ----------
    values : ndarray, shape (levels,)
        Up to three, finest first.
    whole : float
        What the error is relative to.
    regular : bool
        Whether the strips follow the ends of the contact.

    Returns
    -------
    float
        Infinite if there is only one value, or nothing to relate it to.
    """
    if values.size < 2 or not whole > 0.0:
        return math.inf
    last, before = float(abs(values[0] - values[1])) / whole, float(abs(values[-2] - values[-1])) / whole
    if regular:
        return LEFT_OF_CHANGE * last
    return SAFETY * max(last, 0.5 * before) if math.isfinite(last + before) else math.inf


@compiled
def _relative(part: float, whole: float) -> float:
    return part / abs(whole) if whole != 0.0 else math.inf


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
