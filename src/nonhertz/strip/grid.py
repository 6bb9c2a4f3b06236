"""Where the strips lie.

A grid is made from a *size function*, the target strip width at each y: small where the contact ends, at sharp
ends, at kinks and where the profile bends sharply, growing in proportion to the distance from there, and nowhere
narrower than a fraction of the half-width, below which the strip model breaks down. The edges then follow from
walking along y in steps of that width. A strip is centred on y = 0 where that is in contact, so that the centre
pressure is a strip's own value, and edges lie on the ends of the contact and of the bodies and on kinks.

The sizes come from a solution on a coarser grid, beginning with equal strips on the part of the bodies that
touches. All widths but the narrowest are in proportion to a `coarseness`, from which the accuracy follows.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from nonhertz.compiled import compiled, inlined
from nonhertz.strip.records import Array, Flags, Indices, States

# At a coarseness of 1, tuned on random contacts of all profiles; docs/explain/grid.md has the figures.
STRIPS_PER_CONTACT = 8.0  # sets the widest strip in contact
NARROWEST = 1.0 / 40.0  # of the half-width, at sharp ends and kinks
END_SHARE = 0.2  # of the distance over which m falls from half its peak to zero
GROWTH = 0.6  # of the distance from a feature
# Up to the second from sharp ends, in half-widths: there the strength of the singularity is fitted, and the largest
# pressure is taken a half-width away.
GROWTH_AT_SHARP_ENDS, NEAR_SHARP_ENDS = 0.2, 1.5
GROWTH_OUTSIDE = 1.2
SAG = 0.016  # of the interference: the largest sagitta of the profile over one strip
KINK_SHARE = 0.15
LOOSEST = 64.0
LEAST_STRIP = 0.4  # of the target width, for a strip between two corners
# No target width is below this fraction of the region, or below this many times the spacing of floating-point numbers
# there: edges ascend, by steps large enough for rounding not to matter.
NARROWEST_EVER, ROUNDINGS = 1e-9, 1e4
MOST_BENDS = 12
EXTENSION = 0.3  # of the contact's length, added where the strips end before the contact does
LEAST_KINK = 1e-7  # rad
NEAREST = 3  # strips whose largest half-width is taken as the local one
STEPS_PER_STRIP, MOST_STEPS = 3.0, 6000


class Surface(NamedTuple):
    """What is known of the bodies along y.

    Attributes
    ----------
    low, high : float
        Between these, finite, bodies may touch [mm].
    kinks, turns : ndarray, shape (k,)
        Where the slope of the separation jumps [mm], ascending, and by how much [rad].
    sampled_low, sampled_high : ndarray, shape (cases,)
        Between these the separation is sampled evenly, for each case [mm].
    row : ndarray of int, shape (cases,)
        Row of its samples.
    samples : ndarray, shape (rows, n)
        The separation there [mm].
    """

    low: float
    high: float
    kinks: Array
    turns: Array
    sampled_low: Array
    sampled_high: Array
    row: Indices
    samples: Array

    def only(self, cases: Indices) -> Surface:
        """Return what is known for some cases."""
        return self._replace(
            sampled_low=self.sampled_low[cases], sampled_high=self.sampled_high[cases], row=self.row[cases]
        )


class Fineness(NamedTuple):
    """How fine a grid is to be.

    Attributes
    ----------
    coarseness : ndarray, shape (cases,)
        Widths over those above.
    share : float
        Strips over those that the size function asks for.
    limit : int
        The most strips on one interval of contact, at a coarseness of 1.
    """

    coarseness: Array
    share: float
    limit: int


class _Sizes(NamedTuple):
    """A size function between two ends: features, a sampled bound, and the intervals in contact."""

    low: float
    high: float
    features: Array  # a row each, its columns below
    sample_low: float
    sample_step: float
    sample_width: Array
    contact: Array
    largest: float
    largest_outside: float
    growth: float


# Where a feature is, the strip width there, up to which distance widths grow slowly, and whether an edge lies there.
PLACE, WIDTH, SLOW, MARKED = range(4)


def uniform(low: float, high: float, count: int) -> Array:
    """Return the edges of ``count`` equal strips."""
    return np.linspace(low, high, count + 1)


@compiled
def reaching(states: States) -> Flags:
    """Return which of many contacts extend to the low and the high edge of their strips, shape (cases, 2)."""
    found = np.empty((states.status.size, 2), np.bool_)
    for case in range(found.shape[0]):
        row = 0 if states.edges.shape[0] == 1 else case
        n = states.counts[row]
        for column in range(2):
            found[case, column] = reaches(states.edges[row, : n + 1], states.m[case, :n], 2 * column - 1)
    return found


def turns_at(separation: Callable[[Array], Array], bends: tuple[float, ...], length: float) -> tuple[Array, Array]:
    """Return places where the slope of the separation jumps, among ``bends``, and the jumps [rad].

    Where only the curvature jumps, the slope change shrinks in proportion to the step; at a kink it does not.
    """
    places = np.array(bends)
    if not places.size:
        return np.zeros(0), np.zeros(0)
    step = 1e-5 * length
    wide, narrow = (_turn(separation, places, by) for by in (step, 0.1 * step))
    sharp = (narrow > 0.5 * wide) & (narrow > LEAST_KINK)
    return places[sharp], narrow[sharp]


def _turn(separation: Callable[[Array], Array], places: Array, step: float) -> Array:
    h = separation(np.concatenate([places - step, places, places + step])).reshape(3, -1)
    with np.errstate(invalid="ignore"):
        turn: Array = np.abs(h[2] - 2.0 * h[1] + h[0]) / step
    return turn


def contact_of(state: States) -> tuple[tuple[float, float], ...]:
    """Return the intervals in contact of one case [mm]."""
    return tuple(map(tuple, intervals(state.edges, state.m).tolist()))


@compiled
def contact_ends(states: States) -> Array:
    """Return the outermost ends [mm] of many contacts, those of the strips where nothing is in contact."""
    found = np.empty((states.status.size, 2))
    for case in range(found.shape[0]):
        row = 0 if states.edges.shape[0] == 1 else case
        n = states.counts[row]
        edges = states.edges[row, : n + 1]
        contact = intervals(edges, states.m[case, :n])
        found[case, 0] = contact[0, 0] if contact.shape[0] else edges[0]
        found[case, 1] = contact[-1, 1] if contact.shape[0] else edges[-1]
    return found


@compiled
def intervals(edges: Array, m: Array) -> Array:
    """Return the two ends of every interval in contact [mm], where m, continued linearly, vanishes; shape (k, 2)."""
    n = m.size
    found = np.empty((n, 2))
    count, first = 0, -1
    for i in range(n):
        if m[i] > 0.0 and first < 0:
            first = i
        if m[i] > 0.0 and (i + 1 == n or not m[i + 1] > 0.0):
            found[count, 0] = _end(edges, m, first, i, -1)
            found[count, 1] = _end(edges, m, i, first, 1)
            count, first = count + 1, -1
    return found[:count]


@compiled
def _end(edges: Array, m: Array, at: int, other: int, side: int) -> float:
    """Return where the contact around strip ``at`` ends on the given side, at most one strip away."""
    edge = edges[at + 1] if side > 0 else edges[at]
    next_in, next_out = at - side, at + side
    if at == other or m[next_in] <= m[at]:
        return float(edge)
    y = 0.5 * (edges[at] + edges[at + 1])
    y_in = 0.5 * (edges[next_in] + edges[next_in + 1])
    limit = 0.5 * (edges[next_out] + edges[next_out + 1]) if 0 <= next_out < m.size else edge
    run = m[at] * abs(y - y_in) / (m[next_in] - m[at])
    return float(side * min(side * (y + side * run), side * limit))


@compiled
def lay_all(states: States, surface: Surface, extras: Array, fineness: Fineness) -> tuple[Indices, Array]:
    """Return the strips that coarser solutions call for.

    Parameters
    ----------
    states : States
        A solution of every case, which may cover less than the bodies.
    surface : Surface
        The bodies.
    extras : ndarray, shape (cases, 2, k)
        Further places that need strips and the widths wanted there [mm], nan for none.
    fineness : Fineness
        How fine the grids are to be.

    Returns
    -------
    count : ndarray of int, shape (cases,)
        Numbers of strips.
    edges : ndarray, shape (cases, n)
        Edges [mm], padded with the last one.
    """
    room = 4 * states.m.shape[1] + 64
    for each in fineness.coarseness:
        room = max(room, 4 * states.m.shape[1] + 64 + int(2 * fineness.limit / min(each, 1.0)))
    count, edges = np.empty(states.status.size, np.int64), np.empty((states.status.size, room))
    for case in range(count.size):
        row = 0 if states.edges.shape[0] == 1 else case
        n = states.counts[row]
        found = _laid(
            states.edges[row, : n + 1], states.m[case, :n], states.rigid[case], surface, case, extras[case], fineness
        )
        used = min(found.size, room)
        count[case] = used - 1
        for i in range(room):
            edges[case, i] = found[min(i, used - 1)]
    return count, edges


@inlined
def _laid(
    edges: Array, m: Array, rigid: Array, surface: Surface, case: int, extras: Array, fineness: Fineness
) -> Array:
    """Return the edges of a grid; where the sizes call for too many strips, those away from features are widened."""
    contact = intervals(edges, m)
    sizes = _sizes(edges, m, rigid, contact, surface, case, extras, fineness.coarseness[case])
    limit = fineness.limit / min(fineness.coarseness[case], 1.0) * min(contact.shape[0], 2)
    by, marks = 1.0, _marks(sizes.features)
    centre = _centre(sizes)
    right = _walk(centre, sizes.high, sizes, 1.0)
    left = _walk(centre, sizes.low, sizes, 1.0)
    wanted = right[1, -1] + left[1, -1]
    while wanted > limit and by < LOOSEST:
        by *= max(1.03, (wanted / limit) ** 1.5)
        right = _walk(centre, sizes.high, sizes, by)
        left = _walk(centre, sizes.low, sizes, by)
        wanted = right[1, -1] + left[1, -1]
    share = fineness.share * min(1.0, limit / wanted)
    half = 0.5 / share
    # Too close to an end for half a strip and another one beside it.
    if min(right[1, -1], left[1, -1]) < half + LEAST_STRIP / share:
        return _from_end(left, right, marks, share)
    reach = min(_read(right[1], right[0], half) - centre, centre - _read(left[1], left[0], half))
    after, before = _cut(right, centre + reach, marks, share), _cut(left, centre - reach, marks, share)
    joined = np.empty(after.size + before.size)
    for i in range(before.size):
        joined[i] = before[before.size - 1 - i]
    for i in range(after.size):
        joined[before.size + i] = after[i]
    return joined


@inlined
def _sizes(
    edges: Array, m: Array, rigid: Array, contact: Array, surface: Surface, case: int, extras: Array, coarseness: float
) -> _Sizes:
    """Return the size function that a coarse solution calls for."""
    n, touched = m.size, contact.shape[0]
    length = contact[touched - 1, 1] - contact[0, 0]
    low, high = edges[0], edges[n]
    features, used = np.zeros((2 * touched + surface.kinks.size + extras.shape[1], 4)), 0
    for k in range(touched):
        for end in range(2):
            place, side = contact[k, end], 2 * end - 1
            local = width_near(edges, m, place)
            reached = place == (low if end == 0 else high) and reaches(edges, m, side)
            cut = reached and (low > surface.low if end == 0 else high < surface.high)
            width, slow = NARROWEST * local, NEAR_SHARP_ENDS * local
            if not reached or cut:
                falls = fall(edges, m, contact[k, 0], contact[k, 1], side)
                width, slow = max(width, END_SHARE * coarseness * falls), 0.0
            used = _add(features, used, place, width, slow, not reached)
            if cut and end == 0:
                low = max(low - EXTENSION * length, surface.low)
            elif cut:
                high = min(high + EXTENSION * length, surface.high)
    sample_low = surface.sampled_low[case]
    samples = surface.samples[surface.row[case]]
    step = (surface.sampled_high[case] - sample_low) / (samples.size - 1)
    deepest = _deepest(sample_low, step, samples, rigid)
    used = _add_kinks(edges, m, surface, coarseness * deepest, features, used)
    for k in range(extras.shape[1]):
        if math.isfinite(extras[0, k]):
            low = min(low, max(extras[0, k] - 5.0 * extras[1, k], surface.low))
            high = max(high, min(extras[0, k] + 5.0 * extras[1, k], surface.high))
            used = _add(features, used, extras[0, k], extras[1, k], 0.0, False)
    finest = _resolved(low, high)
    for k in range(used):
        features[k, WIDTH] = max(min(features[k, WIDTH], length / 8.0), finest)
    widest = 0.0
    for i in range(n):
        widest = max(widest, m[i])
    narrowest = max(NARROWEST * math.sqrt(widest), _resolved(sample_low, sample_low + step * samples.size))
    bound = _sagging(step, sample_low, samples, rigid, deepest, coarseness, narrowest)
    return _Sizes(
        low, high, features[:used], sample_low + step, step, bound, contact, coarseness * length / STRIPS_PER_CONTACT,
        (high - low) / 8.0, min(GROWTH * coarseness, 1.0),
    )  # fmt: skip


@compiled
def _add(features: Array, used: int, place: float, width: float, slow: float, marked: bool) -> int:
    """Write a feature, and return how many there are."""
    features[used, PLACE], features[used, WIDTH] = place, width
    features[used, SLOW], features[used, MARKED] = slow, 1.0 if marked else 0.0
    return used + 1


@compiled
def _add_kinks(edges: Array, m: Array, surface: Surface, depth: float, features: Array, used: int) -> int:
    """Add kinks in or beside contact, unless they are too many for any to stand out; return how many features are."""
    beside = 0
    for k in range(surface.kinks.size):
        beside += 1 if nearly_touching(edges, m, surface.kinks[k]) else 0
    if beside > MOST_BENDS:
        return used
    for k in range(surface.kinks.size):
        place = surface.kinks[k]
        if edges[0] < place < edges[m.size] and nearly_touching(edges, m, place):
            width = max(KINK_SHARE * depth / surface.turns[k], NARROWEST * width_near(edges, m, place))
            used = _add(features, used, place, width, 0.0, True)
    return used


@compiled
def _marks(features: Array) -> Array:
    """Return the places of features at which edges lie, ascending."""
    marks, used = np.empty(features.shape[0]), 0
    for feature in features:
        if feature[MARKED] > 0.0:
            k = used
            while k > 0 and marks[k - 1] > feature[PLACE]:
                marks[k] = marks[k - 1]
                k -= 1
            marks[k] = feature[PLACE]
            used += 1
    return marks[:used]


@compiled
def reaches(edges: Array, m: Array, side: int) -> bool:
    """Return whether a contact extends to the outer edge of its strips on that side."""
    n = m.size
    at, next_in = (n - 1, n - 2) if side > 0 else (0, 1)
    if not m[at] > 0.0:
        return False
    if n < 2:
        return True
    distance = 0.5 * abs(edges[at] + edges[at + 1] - edges[next_in] - edges[next_in + 1])
    return bool(m[at] - 0.5 * (m[next_in] - m[at]) / distance * (edges[at + 1] - edges[at]) > 0.0)


@compiled
def _resolved(low: float, high: float) -> float:
    """Return the narrowest strip width that floating-point numbers between ``low`` and ``high`` resolve."""
    largest = max(abs(low), abs(high))
    return max(NARROWEST_EVER * (high - low), ROUNDINGS * 2.3e-16 * largest)


@compiled
def width_near(edges: Array, m: Array, place: float) -> float:
    """Return the largest half-width of the few strips in contact nearest to ``place``."""
    widest, beyond = 0.0, -1.0
    for _ in range(NEAREST):
        at, closest = -1, np.inf
        for i in range(m.size):
            distance = abs(0.5 * (edges[i] + edges[i + 1]) - place)
            if m[i] > 0.0 and beyond < distance < closest:
                at, closest = i, distance
        if at < 0:
            break
        widest, beyond = max(widest, m[at]), closest
    return math.sqrt(widest)


@compiled
def fall(edges: Array, m: Array, low: float, high: float, side: int) -> float:
    """Return the distance from one end of a contact at which m is half its value at the nearest peak."""
    n, end = m.size, high if side > 0 else low
    summit, at_summit, first = 0.0, -1, -1
    for k in range(n):
        i = n - 1 - k if side > 0 else k
        y = 0.5 * (edges[i] + edges[i + 1])
        if m[i] > 0.0 and low <= y <= high:
            first = i if first < 0 else first
            if m[i] < summit:
                break
            summit, at_summit = m[i], i
    if at_summit < 0:
        return high - low
    i = first
    while m[i] < 0.5 * summit:
        i -= side
    distance = abs(0.5 * (edges[i] + edges[i + 1]) - end)
    if i == first:
        return float(distance)
    out = i + side
    before = abs(0.5 * (edges[out] + edges[out + 1]) - end)
    share = (0.5 * summit - m[out]) / (m[i] - m[out])
    return float(before + share * (distance - before))


@compiled
def nearly_touching(edges: Array, m: Array, place: float) -> bool:
    """Return whether the strip around ``place`` or one of its neighbours is in contact."""
    found = False
    for i in range(m.size):
        found = found or (m[i] > 0.0 and edges[max(i - 1, 0)] <= place <= edges[min(i + 2, m.size)])
    return found


@compiled
def _deepest(low: float, step: float, samples: Array, rigid: Array) -> float:
    """Return the largest interference at the samples."""
    deepest = -np.inf
    for i in range(samples.size):
        deepest = max(deepest, rigid[0] + rigid[1] * (low + i * step) - samples[i])
    return deepest


@compiled
def _sagging(
    step: float, low: float, samples: Array, rigid: Array, deepest: float, coarseness: float, narrowest: float
) -> Array:
    """Return the width, at every sample but the outermost, at which the profile sags by no more than its share."""
    n = samples.size - 2
    width = np.empty(n)
    sag = 8.0 * SAG * coarseness * coarseness * max(deepest, 0.0)
    for i in range(n):
        bend = abs(samples[i + 2] - 2.0 * samples[i + 1] + samples[i]) / (step * step)
        wanted = step * (n + 1)
        overlaps = rigid[0] + rigid[1] * (low + (i + 1) * step) >= samples[i + 1]
        if math.isfinite(bend) and bend > 0.0 and overlaps:
            wanted = min(wanted, math.sqrt(sag / bend))
        width[i] = max(wanted, narrowest)
    # Away from every sample it may grow no faster than from a feature.
    growth = GROWTH * coarseness * step
    for i in range(1, n):
        width[i] = min(width[i], width[i - 1] + growth)
    for i in range(n - 2, -1, -1):
        width[i] = min(width[i], width[i + 1] + growth)
    return width


@compiled
def _centre(sizes: _Sizes) -> float:
    """Return y = 0 where it is in contact, else the middle of the longest interval in contact."""
    contact = sizes.contact
    longest, middle = -1.0, 0.0
    for k in range(contact.shape[0]):
        if contact[k, 0] < 0.0 < contact[k, 1] and sizes.low < 0.0 < sizes.high:
            return 0.0
        if contact[k, 1] - contact[k, 0] > longest:
            longest, middle = contact[k, 1] - contact[k, 0], 0.5 * (contact[k, 0] + contact[k, 1])
    return middle


@compiled
def _walk(start: float, stop: float, sizes: _Sizes, by: float) -> Array:
    """Return positions from ``start`` to ``stop`` and how many strips lie between ``start`` and each, shape (2, n).

    Strips are ``by`` times as wide as the size function says, away from the features; the features themselves are kept.
    """
    outward = 1.0 if stop > start else -1.0
    walked = np.empty((2, MOST_STEPS))
    walked[0, 0], walked[1, 0] = start, 0.0
    used = 1
    while used < MOST_STEPS:
        here = walked[0, used - 1]
        step = _size(here, sizes, by)
        if used > MOST_STEPS // 2:  # more strips than any grid has: cover the rest in even steps
            step = max(step, STEPS_PER_STRIP * abs(stop - here) / (MOST_STEPS - used))
        there = here + outward * step / STEPS_PER_STRIP
        last = outward * (there - stop) >= 0.0 or used == MOST_STEPS - 1
        if last:
            there = stop
        walked[0, used] = there
        walked[1, used] = walked[1, used - 1] + abs(there - here) / _size(0.5 * (here + there), sizes, by)
        used += 1
        if last:
            break
    path = np.empty((2, used))
    for i in range(used):
        path[0, i], path[1, i] = walked[0, i], walked[1, i]
    return path


@compiled
def _size(y: float, sizes: _Sizes, by: float) -> float:
    """Return the target strip width at ``y``."""
    inside = False
    contact = sizes.contact
    for k in range(contact.shape[0]):
        inside = inside or (contact[k, 0] <= y <= contact[k, 1])
    growth = min(sizes.growth * math.sqrt(by), 1.0)
    rate = growth if inside else GROWTH_OUTSIDE
    width = by * (sizes.largest if inside else sizes.largest_outside)
    for feature in sizes.features:
        away = abs(y - feature[PLACE])
        near = min(away, feature[SLOW])
        width = min(width, feature[WIDTH] + min(GROWTH_AT_SHARP_ENDS, rate) * near + rate * (away - near))
    if inside:
        # The narrower of the two samples around y, so that a symmetric profile has a symmetric grid. But a kink shows
        # at one sample only, however far away the next is, so its width grows with the distance.
        place = (y - sizes.sample_low) / sizes.sample_step
        for beside in range(2):
            # At a sample itself only that one, whichever way its place is rounded.
            nearest = math.floor(place + 1e-9) if beside == 0 else math.ceil(place - 1e-9)
            sample = min(max(int(nearest), 0), sizes.sample_width.size - 1)
            away = abs(y - sizes.sample_low - sample * sizes.sample_step)
            width = min(width, max(math.sqrt(by) * sizes.sample_width[sample], sizes.growth * away))
    return width


@compiled
def _read(x: Array, values: Array, at: float) -> float:
    """Return the value at ``at`` on the line through points with ascending ``x``."""
    low, high = 0, x.size - 1
    if at <= x[low]:
        return float(values[low])
    if at >= x[high]:
        return float(values[high])
    while high - low > 1:
        middle = (low + high) // 2
        if x[middle] <= at:
            low = middle
        else:
            high = middle
    return float(values[low] + (at - x[low]) / (x[high] - x[low]) * (values[high] - values[low]))


@compiled
def _from_end(left: Array, right: Array, marks: Array, share: float) -> Array:
    """Return the edges of a grid without a centred strip, cut from the end nearest to the centre."""
    near, far = (left, right) if left[1, -1] <= right[1, -1] else (right, left)
    n = near.shape[1] - 1
    path = np.empty((2, n + far.shape[1]))
    for i in range(n):
        path[0, i], path[1, i] = near[0, n - i], near[1, n] - near[1, n - i]
    for i in range(far.shape[1]):
        path[0, n + i], path[1, n + i] = far[0, i], near[1, n] + far[1, i]
    edges = _cut(path, path[0, 0], marks, share)
    return edges if edges[0] < edges[edges.size - 1] else edges[::-1].copy()


@compiled
def _cut(path: Array, start: float, marks: Array, share: float) -> Array:
    """Return edges from ``start`` outward, a whole number of strips to every mark and to the end."""
    n = path.shape[1]
    outward = 1.0 if path[0, n - 1] > path[0, 0] else -1.0
    along = np.empty(n)
    for i in range(n):
        along[i] = outward * path[0, i]
    counted = path[1]
    begin = _read(along, counted, outward * start)
    edges = np.empty(int(share * counted[n - 1]) + marks.size + 4)
    edges[0] = start
    used = 1
    for k in range(marks.size + 1):
        last = k == marks.size
        mark = along[n - 1] if last else outward * marks[k if outward > 0.0 else marks.size - 1 - k]
        if not last and mark <= outward * start:
            continue
        reached = _read(along, counted, mark)
        # A mark close to another edge would cut off a sliver.
        if not last and min(share * (reached - begin), share * (counted[n - 1] - reached)) < LEAST_STRIP:
            continue
        strips = max(1, round(share * (reached - begin)))
        for strip in range(1, strips):
            edges[used] = _read(counted, path[0], begin + (reached - begin) / strips * strip)
            used += 1
        edges[used] = outward * mark
        used += 1
        begin = reached
    return edges[:used]
