"""Where the strips lie.

A grid is made from a *size function*, the target strip width at each y: small where the contact ends, at sharp
ends, at kinks and where the profile bends sharply, growing in proportion to the distance from there, and nowhere
narrower than a fraction of the half-width, below which the strip model breaks down. The edges then follow from
walking along y in steps of that width. A strip is centred on y = 0 where that is in contact, so that the centre
pressure is a strip's own value, and edges lie on the ends of the bodies and on kinks.

The sizes come from a solution on a coarser grid, beginning with equal strips on the part of the bodies that
touches.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.strip.resolution import SAMPLES, overlapping
from nonhertz.strip.state import Problem, State, runs

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

# Tuned on Hertz contacts and on sharp ends over two decades of load; docs/explain/grid.md has the figures.
STRIPS_PER_CONTACT = 72.0  # sets the widest strip in contact
NARROWEST = 1.0 / 40.0  # of the half-width, at sharp ends and kinks
END_SHARE = 0.068  # of the distance over which m falls from half its peak to zero
GROWTH = 0.15  # of the distance from a feature
GROWTH_OUTSIDE = 0.8
SAG = 1e-3  # of the interference: the largest sagitta of the profile over one strip
KINK_SHARE = 0.05
LOOSEST = 64.0
LEAST_STRIP = 0.4  # of the target width, for a strip between two corners
# No target width is below this fraction of the region, or below this many times the spacing of floating-point numbers
# there: edges ascend, by steps large enough for rounding not to matter.
NARROWEST_EVER, ROUNDINGS = 1e-9, 1e4
MOST_BENDS = 12
STRIPS_PER_OVERLAP = 5.0
EXTENSION = 0.3  # of the contact's length, added where the strips end before the contact does
LEAST_KINK = 1e-7  # rad
NEAREST = 3  # strips whose largest half-width is taken as the local one


@dataclass(frozen=True)
class Sizes:
    """A size function between two ends: features, a sampled bound, and the intervals in contact."""

    low: float
    high: float
    places: Array
    widths: Array
    corners: Array
    sample_y: Array
    sample_width: Array
    contact: Array
    largest: float
    largest_outside: float
    growth: float

    def loosened(self, by: float) -> Sizes:
        """Return the function with wider strips away from the features, the features themselves kept."""
        return replace(
            self,
            sample_width=self.sample_width * np.sqrt(by),
            largest=self.largest * by,
            largest_outside=self.largest_outside * by,
            growth=min(self.growth * np.sqrt(by), 1.0),
        )


def uniform(low: float, high: float, count: int) -> Array:
    """Return the edges of ``count`` equal strips."""
    return np.linspace(low, high, count + 1)


def reaches(state: State, side: int) -> bool:
    """Return whether the contact extends to the outer edge of the strips on that side."""
    return bool(reaching(state.edges, state.m, side))


def reaching(edges: Array, m: Array, side: int) -> Flags:
    """Return the same for many contacts on the same strips, with their m in rows."""
    at = -1 if side > 0 else 0
    touching: Flags = m[..., at] > 0.0
    if edges.size < 3:
        return touching
    next_in = -2 if side > 0 else 1
    y, width = 0.5 * (edges[1:] + edges[:-1]), abs(edges[at] - edges[next_in])
    fall = (m[..., next_in] - m[..., at]) / abs(y[next_in] - y[at])
    open_there: Flags = touching & (m[..., at] - 0.5 * fall * width > 0.0)
    return open_there


def cut_off(state: State, interval: tuple[float, float]) -> tuple[bool, bool]:
    """Return whether the strips end at low and at high y while both contact and bodies continue."""
    low, high = float(state.edges[0]), float(state.edges[-1])
    return reaches(state, -1) and low > interval[0], reaches(state, 1) and high < interval[1]


def sizes(problem: Problem, state: State, bends: tuple[float, ...], interval: tuple[float, float]) -> Sizes:
    """Return the size function that a coarse solution calls for.

    Parameters
    ----------
    problem : Problem
        The problem to solve.
    state : State
        A solution on coarser strips, which may cover less than the bodies.
    bends : tuple of float
        Where the profiles bend [mm].
    interval : tuple of float
        Where the bodies may touch [mm], finite.
    """
    contact = np.array(state.contact)
    length = float(contact[-1, 1] - contact[0, 0])
    low, high = float(state.edges[0]), float(state.edges[-1])
    cut = cut_off(state, interval)
    places, widths = [], []
    for touched in state.contact:
        for end, last, side, cut_here in zip(touched, (low, high), (-1, 1), cut, strict=True):
            floor = NARROWEST * _near(state.y, state.m, end)
            sharp = end == last and reaches(state, side) and not cut_here
            places.append(end)
            widths.append(floor if sharp else max(floor, END_SHARE * _fall(state.y, state.m, *touched, side)))
    depth = float(np.max(state.rigid[0] + state.rigid[1] * state.y - problem.separation(state.y)))
    corners = kinks(problem.separation, bends, state)
    for place, turn in corners:
        places.append(place)
        widths.append(max(KINK_SHARE * depth / turn, NARROWEST * _near(state.y, state.m, place)))
    if cut[0]:
        low = max(low - EXTENSION * length, interval[0])
    if cut[1]:
        high = min(high + EXTENSION * length, interval[1])
    for place, width in overlaps(problem, state, interval):
        places.append(place)
        widths.append(width)
        low, high = min(low, max(place - 5.0 * width, interval[0])), max(high, min(place + 5.0 * width, interval[1]))
    sample_y, sample_width = _bending(problem, state)
    return Sizes(
        float(low),
        float(high),
        np.array(places),
        np.maximum(np.minimum(widths, length / 8.0), _resolved(low, high)),
        np.array([place for place, _ in corners]),
        sample_y,
        sample_width,
        contact,
        length / STRIPS_PER_CONTACT,
        float(high - low) / 24.0,
        GROWTH,
    )


def _resolved(low: float, high: float) -> float:
    """Return the narrowest strip width that floating-point numbers between ``low`` and ``high`` resolve."""
    spacing = float(np.spacing(max(abs(low), abs(high))))
    return max(NARROWEST_EVER * (high - low), ROUNDINGS * spacing)


@compiled
def _near(y: Array, m: Array, place: float) -> float:
    """Return the largest half-width of the few strips in contact nearest to ``place``."""
    widest, beyond = 0.0, -1.0
    for _ in range(NEAREST):
        at, closest = -1, np.inf
        for i in range(m.size):
            if m[i] > 0.0 and beyond < abs(y[i] - place) < closest:
                at, closest = i, abs(y[i] - place)
        if at < 0:
            break
        widest, beyond = max(widest, m[at]), closest
    return math.sqrt(widest)


@compiled
def _fall(y: Array, m: Array, low: float, high: float, side: int) -> float:
    """Return the distance from one end of a contact at which m is half its value at the nearest peak."""
    inside = np.flatnonzero((y >= low) & (y <= high) & (m > 0.0))
    end = high if side > 0 else low
    if side > 0:
        inside = inside[::-1].copy()
    summit = 0
    while summit + 1 < inside.size and m[inside[summit + 1]] >= m[inside[summit]]:
        summit += 1
    half = 0.5 * m[inside[summit]]
    at = 0
    while m[inside[at]] < half:
        at += 1
    distance = abs(y[inside[at]] - end)
    if at == 0:
        return float(distance)
    before = abs(y[inside[at - 1]] - end)
    share = (half - m[inside[at - 1]]) / (m[inside[at]] - m[inside[at - 1]])
    return float(before + share * (distance - before))


def overlaps(problem: Problem, state: State, interval: tuple[float, float]) -> list[tuple[float, float]]:
    """Return the midpoints of intervals where the surfaces overlap between strips out of contact, and widths for them.

    A wide strip out of contact sees the gap only at its centre; there may be another contact off centre.
    """
    y, overlap = overlapping(problem, state, interval)
    if not np.any(overlap > 0.0):
        return []
    step = (interval[1] - interval[0]) / SAMPLES
    found = []
    for i, j in runs(overlap > 0.0):
        # No wider than the neighbouring places without overlap allow: crests may be much closer together than the
        # samples, and much narrower.
        low, high = _reach(y, overlap, i, -1), _reach(y, overlap, j, 1)
        extent = max(float(y[j] - y[i]), min(step, low + float(y[j] - y[i]) + high))
        found.append((float(0.5 * (y[i] + y[j])), extent / STRIPS_PER_OVERLAP))
    return found


def _reach(y: Array, overlap: Array, at: int, side: int) -> float:
    """Return how far an overlap may extend beyond its last place: twice as far as a straight line to the next."""
    beside = at + side
    if not 0 <= beside < y.size:
        return 0.0
    distance = abs(float(y[beside] - y[at]))
    falls = -math.inf < overlap[beside] < 0.0
    share = overlap[at] / (overlap[at] - overlap[beside]) if falls else 1.0
    return distance * min(2.0 * float(share), 0.5)


def kinks(separation: Callable[[Array], Array], bends: tuple[float, ...], state: State) -> list[tuple[float, float]]:
    """Return places in contact, or next to it, where the slope of the separation jumps, and the jump [rad].

    Where only the curvature jumps, the slope change shrinks in proportion to the step; at a kink it does not.
    """
    low, high = state.edges[0], state.edges[-1]
    inside = [bend for bend in bends if low < bend < high and _nearly_touching(state, bend)]
    if not inside or len(inside) > MOST_BENDS:
        return []
    step = 1e-5 * (high - low)
    wide, narrow = (_turn(separation, np.array(inside), by) for by in (step, 0.1 * step))
    return [
        (float(place), float(turn))
        for place, turn, before in zip(inside, narrow, wide, strict=True)
        if turn > 0.5 * before and turn > LEAST_KINK
    ]


def _nearly_touching(state: State, place: float) -> bool:
    """Return whether the strip around ``place`` or one of its neighbours is in contact."""
    at = int(np.searchsorted(state.edges, place)) - 1
    return bool(np.any(state.m[max(at - 1, 0) : at + 2] > 0.0))


def _turn(separation: Callable[[Array], Array], places: Array, step: float) -> Array:
    h = separation(np.concatenate([places - step, places, places + step])).reshape(3, -1)
    with np.errstate(invalid="ignore"):
        turn: Array = np.abs(h[2] - 2.0 * h[1] + h[0]) / step
    return turn


def _bending(problem: Problem, state: State) -> tuple[Array, Array]:
    """Return samples along y and the width at which the profile sags by no more than SAG of the interference."""
    y, h = problem.sampled(float(state.edges[0]), float(state.edges[-1]), SAMPLES)
    narrowest = max(NARROWEST * math.sqrt(float(np.max(state.m))), _resolved(float(y[0]), float(y[-1])))
    return y[1:-1], _sagging(y, h, state.rigid, narrowest)


@compiled
def _sagging(y: Array, h: Array, rigid: Array, narrowest: float) -> Array:
    step = y[1] - y[0]
    deepest = np.max(rigid[0] + rigid[1] * y - h)
    width = np.empty(y.size - 2)
    for i in range(width.size):
        bend = abs(h[i + 2] - 2.0 * h[i + 1] + h[i]) / step**2
        requested = y[-1] - y[0]
        if math.isfinite(bend) and bend > 0.0 and rigid[0] + rigid[1] * y[i + 1] >= h[i + 1]:
            requested = min(requested, math.sqrt(8.0 * SAG * deepest / bend))
        width[i] = max(requested, narrowest)
    # Away from every sample it may grow no faster than from a feature.
    for i in range(1, width.size):
        width[i] = min(width[i], width[i - 1] + GROWTH * step)
    for i in range(width.size - 2, -1, -1):
        width[i] = min(width[i], width[i + 1] + GROWTH * step)
    return width


def graded(requested: Sizes, limit: int) -> Grading:
    """Return the graded grids of a size function, of at most ``limit`` strips.

    Where the sizes call for more, they are loosened away from the features until they do not.
    """
    by = 1.0
    grading = Grading(requested, limit)
    while grading.count > limit and by < LOOSEST:
        by *= max(1.03, (grading.count / limit) ** 1.5)
        grading = Grading(requested.loosened(by), limit)
    return grading


def _centre(requested: Sizes) -> float:
    """Return y = 0 where it is in contact, else the middle of the longest interval in contact."""
    contact = requested.contact
    if np.any((contact[:, 0] < 0.0) & (contact[:, 1] > 0.0)) and requested.low < 0.0 < requested.high:
        return 0.0
    longest = contact[np.argmax(contact[:, 1] - contact[:, 0])]
    return float(0.5 * (longest[0] + longest[1]))


class Grading:
    """A walk along y in steps of the target width, and the grids of any number of strips that it yields."""

    def __init__(self, requested: Sizes, limit: int) -> None:
        self.limit = limit
        self.centre, self.corners = _centre(requested), requested.corners
        arguments = (
            requested.places, requested.widths, requested.sample_y, requested.sample_width, requested.contact,
            requested.largest, requested.largest_outside, requested.growth,
        )  # fmt: skip
        self.right = _walk(self.centre, requested.high, *arguments)
        self.left = _walk(self.centre, requested.low, *arguments)
        self.count = float(self.right[1][-1] + self.left[1][-1])

    def edges(self, share: float) -> Array:
        """Return the edges of a grid with ``share`` times as many strips as requested, or as the limit allows."""
        share *= min(1.0, self.limit / self.count)
        half = 0.5 / share
        # Too close to an end for half a strip and another one beside it.
        if min(self.right[1][-1], self.left[1][-1]) < half + LEAST_STRIP / share:
            return self._edges_from_end(share)
        reach = min(
            float(np.interp(half, self.right[1], self.right[0])) - self.centre,
            self.centre - float(np.interp(half, self.left[1], self.left[0])),
        )
        right = _cut(*self.right, self.centre + reach, self.corners, share)
        left = _cut(*self.left, self.centre - reach, self.corners, share)
        return np.concatenate([left[::-1], right])

    def _edges_from_end(self, share: float) -> Array:
        """Return the edges of a grid without a centred strip, cut from the end nearest to the centre."""
        near, far = (self.left, self.right) if self.left[1][-1] <= self.right[1][-1] else (self.right, self.left)
        y = np.concatenate([near[0][:0:-1], far[0]])
        count = np.concatenate([near[1][-1] - near[1][:0:-1], near[1][-1] + far[1]])
        edges: Array = np.sort(_cut(y, count, float(y[0]), self.corners, share))
        return edges


@compiled
def _cut(y: Array, count: Array, start: float, corners: Array, share: float) -> Array:
    """Return edges from ``start`` outward, a whole number of strips to every corner and to the end."""
    outward = 1.0 if y[-1] > y[0] else -1.0
    along = outward * y
    begin = np.interp(outward * start, along, count)
    marks = np.append(outward * (corners if outward > 0.0 else corners[::-1]), along[-1])
    edges = np.empty(int(share * count[-1]) + marks.size + 3)
    edges[0] = start
    used = 1
    for k in range(marks.size):
        last = k == marks.size - 1
        reached = np.interp(marks[k], along, count)
        # A corner close to another edge would cut off a sliver.
        if not last and min(share * (reached - begin), share * (count[-1] - reached)) < LEAST_STRIP:
            continue
        strips = max(1, round(share * (reached - begin)))
        for strip in range(1, strips):
            edges[used] = np.interp(begin + (reached - begin) / strips * strip, count, y)
            used += 1
        edges[used] = outward * marks[k]
        used += 1
        begin = reached
    return edges[:used].copy()


@compiled
def _walk(
    start: float,
    stop: float,
    places: Array,
    widths: Array,
    sample_y: Array,
    sample_width: Array,
    contact: Array,
    largest: float,
    largest_outside: float,
    growth: float,
) -> tuple[Array, Array]:
    """Return positions from ``start`` to ``stop`` and how many strips lie between ``start`` and each."""
    outward = 1.0 if stop > start else -1.0
    steps_per_strip = 3.0
    room = 6000
    y, count = np.empty(room), np.empty(room)
    y[0], count[0] = start, 0.0
    used = 1
    while used < room:
        here = y[used - 1]
        step = _size(here, places, widths, sample_y, sample_width, contact, largest, largest_outside, growth)
        if used > room // 2:  # more strips than any grid has: cover the rest in even steps
            step = max(step, steps_per_strip * abs(stop - here) / (room - used))
        there = here + outward * step / steps_per_strip
        last = outward * (there - stop) >= 0.0 or used == room - 1
        if last:
            there = stop
        middle = _size(
            0.5 * (here + there), places, widths, sample_y, sample_width, contact, largest, largest_outside, growth
        )
        y[used] = there
        count[used] = count[used - 1] + abs(there - here) / middle
        used += 1
        if last:
            break
    return y[:used].copy(), count[:used].copy()


@compiled
def _size(
    y: float,
    places: Array,
    widths: Array,
    sample_y: Array,
    sample_width: Array,
    contact: Array,
    largest: float,
    largest_outside: float,
    growth: float,
) -> float:
    """Return the target strip width at ``y``."""
    inside = False
    for k in range(contact.shape[0]):
        inside = inside or (contact[k, 0] <= y <= contact[k, 1])
    rate = growth if inside else GROWTH_OUTSIDE
    width = largest if inside else largest_outside
    for k in range(places.size):
        width = min(width, widths[k] + rate * abs(y - places[k]))
    if inside:
        # The narrower of the two samples around y, so that a symmetric profile has a symmetric grid. But a kink shows
        # at one sample only, however far away the next is, so its width grows with the distance.
        place = (y - sample_y[0]) / (sample_y[1] - sample_y[0])
        for beside in (math.floor(place), math.ceil(place)):
            sample = min(max(beside, 0), sample_y.size - 1)
            width = min(width, max(sample_width[sample], GROWTH * abs(y - sample_y[sample])))
    return width
