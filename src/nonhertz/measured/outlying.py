"""Which points of a measured line do not belong to the surface.

Dust, a scratch or a lost stylus moves few neighbouring points, and the surface goes on behind them as it came. So a
point is suspected if it lies off three lines, to the same side of all: that through the surface on its left, carried on
to it, that through the surface on its right, and the chord between the two. Medians of neighbouring points stand for
the surface, at several distances. Beside a scratch, at the wall of a dent and at an edge one of the two sides still is
the surface that the point belongs to; on a curve the chord errs to one side and the two lines to the other.

Suspected neighbours are then looked at together. The line between the surface on their two sides, suspected points left
out, is their base. All neighbours that lie off it are taken with them, and what comes out so is a grain or a scratch if
it is narrow. If it is wider than that it is shape, and none of its points is touched.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nonhertz.measured.trace import Array, Points

#: Share of the line, and length [mm], beyond which a dent or a bump is shape.
WIDEST_SHARE, WIDEST = 0.01, 0.2
# Distances at which the surface is looked for, from the nearest neighbours to what finds the widest grain.
_DISTANCES = 7
# Points on either side that a base is drawn between, at least and at most.
_FEWEST_BESIDE, _MOST_BESIDE = 5, 50
_ROUNDS = 8
# Share of the limit at which a grain ends: two standard deviations of the five that make an outlier.
_FOOT = 0.4
# Where the surface beside is rougher than the rest of the line, five standard deviations of it, from the median of the
# distances, are the limit.
_SCATTERS = 7.4


def outlying(points: Points, height: Array, limit: float) -> NDArray[np.bool_]:
    """Return which points lie off the surface by more than a limit.

    Parameters
    ----------
    points : Points
        The measured line.
    height : array, shape (n + 2 m,)
        Its heights [mm], carried on by any m points beyond either end.
    limit : float
        How far a point may lie off [mm].
    """
    side = _suspected(points, height, limit)
    clean = np.flatnonzero(side == 0)
    out = np.zeros(len(points), dtype=bool)
    for first, last in _runs(side):
        found = _off_base(points, clean, first, last, float(side[first]) * limit)
        if found is not None:
            out[found] = True
    return out


def widest(points: Points) -> float:
    """Return the width [mm] up to which a dent or a bump is a scratch or a grain."""
    return min(WIDEST_SHARE * points.span, WIDEST)


def carried_on(points: Points) -> int:
    """Return by how many points the heights should be carried on for `outlying` to see all up to the ends."""
    return 6 * _farthest(points) + 3


def _farthest(points: Points) -> int:
    """Return the largest radius, in points, of the medians that stand for the surface."""
    usual = float(np.median(np.diff(points.y)))
    return max(min(int(widest(points) / usual / 3.0) + 1, (len(points) - 4) // 6), 0)


def _suspected(points: Points, height: Array, limit: float) -> NDArray[np.int8]:
    """Return 1 for points that lie above what is on both of their sides, -1 for those below, 0 for all others."""
    from scipy.ndimage import median_filter

    count, more = len(points), (len(height) - len(points)) // 2
    y = np.pad(points.y, more, mode="reflect", reflect_type="odd")
    side = np.zeros(count, dtype=np.int8)
    farthest = _farthest(points)
    for radius in np.unique(np.geomspace(1, max(farthest, 1), _DISTANCES).round().astype(int))[
        : None if farthest else 0
    ]:
        surface = median_filter(height, 2 * radius + 1, mode="nearest")
        places = [slice(more + k, more + k + count) for k in _offsets(radius)]
        off = _distances(points, [y[place] for place in places], [surface[place] for place in places])
        side[np.min(off, axis=0) > limit] = 1
        side[np.max(off, axis=0) < -limit] = -1
    return side


def _offsets(radius: int) -> tuple[int, int, int, int]:
    """Return where the middles of four stretches of 2 radius + 1 points lie, two on either side, none of them near."""
    near, far = 3 * radius + 2, 5 * radius + 3
    return -far, -near, near, far


def _distances(points: Points, y: list[Array], surface: list[Array]) -> Array:
    """Return how far the points lie from the lines on their left, on their right and across, shape (3, n)."""
    lines = ((0, 1), (3, 2), (1, 2))
    return np.array([
        points.height - surface[b] - (surface[b] - surface[a]) / (y[b] - y[a]) * (points.y - y[b]) for a, b in lines
    ])  # fmt: skip


def _runs(side: NDArray[np.int8]) -> Iterator[tuple[int, int]]:
    """Yield first and last index of neighbours that are suspected to lie on the same side."""
    turns = np.flatnonzero(np.diff(side, prepend=0, append=0))
    for first, after in pairwise(turns):
        if side[first]:
            yield int(first), int(after) - 1


def _off_base(points: Points, clean: NDArray[np.intp], first: int, last: int, limit: float) -> NDArray[np.intp] | None:
    """Return the points about a run that lie off their base, above it if the limit is positive; None if it is shape.

    How wide it is counts at its foot, where it is lost in the roughness: of a shallow dent only the bottom is beyond
    the limit.
    """
    for _ in range(_ROUNDS):
        near = np.arange(
            *np.searchsorted(points.y, (points.y[first] - widest(points), points.y[last] + widest(points)))
        )
        above, scatter = _from_base(points, clean, first, last, near)
        off = above / np.copysign(max(abs(limit), _SCATTERS * scatter), limit)
        grown = _stretch(off > _FOOT, first - near[0], last - near[0]) + near[0]
        if _width(points, *grown) > widest(points) and grown[1] > grown[0]:
            return None
        if (grown[0], grown[1]) == (first, last):
            found = near[(near >= first) & (near <= last) & (off > 1.0)]
            most = float(np.max(np.abs(above)[off > 1.0], initial=0.0))
            return found if _begins_at_once(points, first, last, most) else None
        first, last = int(min(first, grown[0])), int(max(last, grown[1]))
    return None


def _begins_at_once(points: Points, first: int, last: int, most: float) -> bool:
    """Return whether a run lies inside the line or, at an end of it, half of what it is off begins with one step.

    An edge that is rounded falls off gradually, and nothing behind it says that the surface goes on.
    """
    if first > 0 and last < len(points) - 1:
        return True
    inner, outer = (last + 1, last) if first == 0 else (first - 1, first)
    return bool(abs(points.height[outer] - points.height[inner]) > 0.5 * most)


def _from_base(
    points: Points, clean: NDArray[np.intp], first: int, last: int, at: NDArray[np.intp]
) -> tuple[Array, float]:
    """Return how far points lie above the line between the surface on the two sides of a run, and its scatter there."""
    beside = min(max(last - first + 1, _FEWEST_BESIDE), _MOST_BESIDE)
    left = clean[: np.searchsorted(clean, first)]
    right = clean[np.searchsorted(clean, last, side="right") :]
    if len(left) >= _FEWEST_BESIDE and len(right) >= _FEWEST_BESIDE:
        sides = left[-beside:], right[:beside]
    else:
        one = left if len(left) > len(right) else right[::-1]
        beside = min(beside, len(one) // 2)
        sides = one[len(one) - 2 * beside : len(one) - beside], one[len(one) - beside :]
    if min(map(len, sides)) == 0:
        return np.zeros(len(at)), 0.0
    (y0, y1), (z0, z1) = ([float(np.median(of[side])) for side in sides] for of in (points.y, points.height))
    slope = (z1 - z0) / (y1 - y0)
    both = np.concatenate(sides)
    scatter = np.median(np.abs(points.height[both] - z0 - slope * (points.y[both] - y0)))
    return points.height[at] - z0 - slope * (points.y[at] - y0), float(scatter)


def _stretch(off: NDArray[np.bool_], first: int, last: int) -> NDArray[np.intp]:
    """Return first and last index of the neighbours of a run that lie off, with the run itself."""
    on = np.flatnonzero(~off)
    before, behind = on[on < first], on[on > last]
    return np.array([before[-1] + 1 if len(before) else 0, behind[0] - 1 if len(behind) else len(off) - 1])


def _width(points: Points, first: int, last: int) -> float:
    """Return the length [mm] that neighbours stand for, half of the way to the points beside them."""
    y = points.y
    low, high = y[max(first - 1, 0)], y[min(last + 1, len(y) - 1)]
    return float(0.5 * (y[last] + high - y[first] - low))
