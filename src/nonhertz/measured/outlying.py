"""Which points of a measured line do not belong to the surface.

Dust, a scratch or lost stylus contact displaces a few neighbouring points, and beyond them the surface continues as
before. So a point is suspect if it lies off three lines, on the same side of all: the line through the surface on its
left, extrapolated to it, the same on its right, and the chord between the two. Medians of neighbouring points represent
the surface, at several distances. Beside a scratch, at the wall of a dent and at an edge, one of the two sides is still
the surface that the point belongs to; on a curve the chord errs to one side and the two lines to the other.

Suspect neighbours are then examined together. Their base is the line between the surface on both sides, ignoring
suspect points. All neighbours off that base are added, and the result is a grain or a scratch if it is narrow. If it is
wider, it is form, and none of its points is removed.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

#: Robust standard deviations beyond which a point does not belong to the surface. Of ten thousand points of pure
#: Gaussian roughness none exceeds it.
THRESHOLD = 5.0

# Reach of chords to either side, over the number of points, and the least window and number of chords.
_MEDIAN_SHARE, _FEWEST_IN_MEDIAN, _CHORDS = 0.01, 9, 9
# The median of absolute deviations, and what nine in ten of them do not exceed, in standard deviations of a normal
# distribution: 1 / (sqrt(2) erfinv(1/2)) and 1 / (sqrt(2) erfinv(9/10)).
_MAD_TO_SIGMA, _NINE_TENTHS_TO_SIGMA = 1.482602218505602, 0.6079568319117692
# Machines resolve nanometres: smaller deviations are not outliers, however smooth the rest is.
_RESOLUTION = 1e-6  # mm
#: Fraction of the line, and length [mm], beyond which a dent or a bump counts as form.
WIDEST_SHARE, WIDEST = 0.01, 0.2
# Number of distances at which the surface is sampled, from the nearest neighbours to what finds the widest grain.
_DISTANCES = 7
# Least and greatest number of points on either side that define a base.
_FEWEST_BESIDE, _MOST_BESIDE = 5, 50
_ROUNDS = 8
# Fraction of the limit at which a grain ends: two of the five standard deviations that make an outlier.
_FOOT = 0.4
# Where the adjacent surface is rougher than the rest of the line, the limit is five of its standard deviations,
# expressed by the median of the distances.
_SCATTERS = 7.4


def outliers(points: Points, threshold: float) -> tuple[NDArray[np.bool_], float]:
    """Return which points do not belong to the surface, and how far off it they may lie [mm].

    Parameters
    ----------
    points : Points
        The measured line.
    threshold : float
        How far, in robust standard deviations of the land; for corners, of the roughest of the three.
    """
    sigma = max(_scatter(points.on_land), _RESOLUTION / threshold)
    corners = points.beyond_land
    beyond = np.logical_or(*corners)
    out = np.zeros(len(points), dtype=bool)
    out[~beyond] = _find_outlying(points.on_land, threshold * sigma)
    if np.any(beyond):
        parts = [points.kept(corner) for corner in corners if np.sum(corner) >= FEWEST_POINTS]
        out |= beyond & _find_outlying(points, threshold * max([sigma, *map(_scatter, parts)]))
    return out, threshold * sigma


def _find_outlying(points: Points, limit: float) -> NDArray[np.bool_]:
    """Return which points lie off the surface by more than a limit [mm]."""
    side = _find_suspects(points, limit)
    clean = np.flatnonzero(side == 0)
    out = np.zeros(len(points), dtype=bool)
    for first, last in runs(side):
        strays = _off_base(points, clean, first, last, float(side[first]) * limit)
        if strays is not None:
            out[strays] = True
    return out


def _widest(points: Points) -> float:
    """Return the width [mm] up to which a dent or a bump is a scratch or a grain."""
    # Rounding of positions must not decide on a width that is the limit itself, as of points at equal distances.
    return (1.0 + 1e-9) * min(WIDEST_SHARE * points.span, WIDEST)


def _farthest(points: Points) -> int:
    """Return the largest radius, in points, of the medians that represent the surface."""
    usual = float(np.median(np.diff(points.y)))
    return max(min(int(_widest(points) / usual / 3.0) + 1, (len(points) - 4) // 6), 0)


def _find_suspects(points: Points, limit: float) -> NDArray[np.int8]:
    """Return 1 for points above the surface on both sides, -1 for those below, 0 for all others."""
    from scipy.ndimage import median_filter

    count, farthest = len(points), _farthest(points)
    more = 6 * farthest + 3
    y, height = _reflect_ends(points, more)
    side = np.zeros(count, dtype=np.int8)
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
    """Return the offsets of the middles of four stretches of 2 radius + 1 points, two on either side, none adjacent."""
    near, far = 3 * radius + 2, 5 * radius + 3
    return -far, -near, near, far


def _distances(points: Points, y: list[Array], surface: list[Array]) -> Array:
    """Return how far the points lie from the lines on their left, on their right and across, shape (3, n)."""
    lines = ((0, 1), (3, 2), (1, 2))
    return np.array([
        points.height - surface[b] - (surface[b] - surface[a]) / (y[b] - y[a]) * (points.y - y[b]) for a, b in lines
    ])  # fmt: skip


def runs(side: NDArray[np.int8]) -> Iterator[tuple[int, int]]:
    """Yield first and last index of every stretch of the same number but 0."""
    turns = np.flatnonzero(np.diff(side, prepend=0, append=0))
    for first, after in pairwise(turns):
        if side[first]:
            yield int(first), int(after) - 1


def _off_base(points: Points, clean: NDArray[np.intp], first: int, last: int, limit: float) -> NDArray[np.intp] | None:
    """Return the points around a run that lie off their base, above it if the limit is positive; None if it is form.

    Its width is measured at its foot, where it merges into the roughness: of a shallow dent only the bottom is beyond
    the limit.
    """
    for _ in range(_ROUNDS):
        near = np.arange(
            *np.searchsorted(points.y, (points.y[first] - _widest(points), points.y[last] + _widest(points)))
        )
        above, scatter = _from_base(points, clean, first, last, near)
        off = above / np.copysign(max(abs(limit), _SCATTERS * scatter), limit)
        grown = _stretch(off > _FOOT, first - near[0], last - near[0]) + near[0]
        if _width(points, *grown) > _widest(points) and grown[1] > grown[0]:
            return None
        if (grown[0], grown[1]) == (first, last):
            strays = near[(near >= first) & (near <= last) & (off > 1.0)]
            most = float(np.max(np.abs(above)[off > 1.0], initial=0.0))
            return strays if _begins_at_once(points, first, last, most) else None
        first, last = int(min(first, grown[0])), int(max(last, grown[1]))
    return None


def _begins_at_once(points: Points, first: int, last: int, most: float) -> bool:
    """Return whether a run lies inside the line or, at an end, whether half its deviation occurs in one step.

    A rounded edge falls off gradually, and there is nothing beyond it to show that the surface continues.
    """
    if first > 0 and last < len(points) - 1:
        return True
    inner, outer = (last + 1, last) if first == 0 else (first - 1, first)
    return bool(abs(points.height[outer] - points.height[inner]) > 0.5 * most)


def _from_base(
    points: Points, clean: NDArray[np.intp], first: int, last: int, at: NDArray[np.intp]
) -> tuple[Array, float]:
    """Return how far points lie above the base line of a run, and the scatter of the surface beside the run."""
    beside = min(max(last - first + 1, _FEWEST_BESIDE), _MOST_BESIDE)
    before = clean[: np.searchsorted(clean, first)]
    after = clean[np.searchsorted(clean, last, side="right") :]
    if len(before) >= _FEWEST_BESIDE and len(after) >= _FEWEST_BESIDE:
        sides = before[-beside:], after[:beside]
    else:
        one = before if len(before) > len(after) else after[::-1]
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
    """Return first and last index of a run together with its neighbours that lie off."""
    on = np.flatnonzero(~off)
    before, behind = on[on < first], on[on > last]
    return np.array([before[-1] + 1 if len(before) else 0, behind[0] - 1 if len(behind) else len(off) - 1])


def _width(points: Points, first: int, last: int) -> float:
    """Return the length [mm] that a run of points represents, half-way to the points beside it."""
    y = points.y
    low, high = y[max(first - 1, 0)], y[min(last + 1, len(y) - 1)]
    return float(0.5 * (y[last] + high - y[first] - low))


def _scatter(points: Points) -> float:
    """Return the standard deviation of the distances from chords [mm], whatever a few points do."""
    distance = np.abs(_from_chords(points))
    median, most = np.quantile(distance, (0.5, 0.9))
    return max(_MAD_TO_SIGMA * float(median), _NINE_TENTHS_TO_SIGMA * float(most))


def _from_chords(points: Points) -> Array:
    """Return how far each point lies from chords around it, less the curvature of the surface there."""
    from scipy.ndimage import median_filter

    half = min(max(int(_MEDIAN_SHARE * len(points)), _FEWEST_IN_MEDIAN // 2), (len(points) - 1) // 2)
    y, height = _reflect_ends(points, half)
    chords = []
    for reach in np.unique(np.linspace(1, half, _CHORDS).round().astype(int)):
        before = slice(half - reach, len(y) - half - reach)
        after = slice(half + reach, len(y) - half + reach)
        share = (points.y - y[before]) / (y[after] - y[before])
        chords.append(height[before] + share * (height[after] - height[before]))
    distance = points.height - np.median(chords, axis=0)
    return np.asarray(distance - median_filter(distance, 2 * half + 1, mode="mirror"))


def _reflect_ends(points: Points, count: int) -> tuple[Array, Array]:
    """Return the line extended beyond its ends by its point reflection, which keeps its slope."""
    y, height = (np.pad(of, count, mode="reflect", reflect_type="odd") for of in (points.y, points.height))
    height[:count] += 2.0 * _dust_at_end(points.y[::-1], points.height[::-1])
    height[len(height) - count :] += 2.0 * _dust_at_end(points.y, points.height)
    return y, height


def _dust_at_end(y: Array, height: Array) -> float:
    """Return how much the last point must be raised to lie on the line of those before it; 0 if it may belong to them.

    A grain on the last point would be the centre of the reflection, and cause the good points beside it to be removed.
    """
    count = _FEWEST_IN_MEDIAN
    if len(y) < 2 * count:
        return 0.0
    last, before = slice(-count, None), slice(-2 * count, -count)
    slope = np.median((height[last] - height[before]) / (y[last] - y[before]))
    expected = height[last] + slope * (y[-1] - y[last])
    lack = float(np.median(expected) - height[-1])
    scatter = _MAD_TO_SIGMA * float(np.median(np.abs(expected - np.median(expected))))
    return lack if abs(lack) > THRESHOLD * scatter else 0.0
