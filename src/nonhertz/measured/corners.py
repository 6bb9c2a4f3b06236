"""The corners that a trace holds beyond the land: where they begin, and how they are smoothed.

A corner is a hundred times steeper and more sharply curved than the land. Filtered together at a cutoff of 0.8 mm, it
would bend the land down and come out many times larger than it is. Here both are filtered apart and joined at a point,
the joint.

**Joint.** The search for the land finds its ends to within a chord, and a corner is tangent to the land where it
begins. So the joint is where one curve, a parabola of the land and beyond the joint a second one added to it, comes
closest to the points in the least-square sense. A joint that is too far out adds a small crest, which would be loaded
in a contact, while one too far in only leaves some points of the land less smooth. Therefore the innermost joint is
taken that is as likely as the best one within two standard errors.

**Smoothing.** The corner has roughness too, and a stylus some noise; unfiltered, the maximum pressure would be that of
the highest grain. A Gaussian regression filter of second order (ISO 16610-31 without its weights for outliers) with a
cutoff of 0.08 mm, the shortest of the usual series, keeps slope and curvature up to the ends of the corner, where
one of zeroth order would round it. The smoothed end of the land is one of its points, with the weight of a whole land:
so both join without a step. Over corners of 0.2 to 1.5 mm radius with a noise of 0.05 um, points 1 to 10 um apart, the
maximum pressure of a contact that ends in the corner is within 3 % of that of the corner without noise, mostly within
1 %, at the same place within 0.02 mm. A rounding shorter than half the cutoff comes out larger: where 30 um of arc lead
to a chamfer of 17 degrees, the maximum pressure is up to 7 % low.

**Run-out of the land.** Ground lands often round off towards their corners. The filter of the land carries on straight
at its end, which would leave a crest there. So the last 0.4 mm keep what a cutoff of 0.25 mm keeps of them.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.measured.filters import shortest_cutoff
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

#: Wavelength [mm] that separates roughness from form in a corner.
CORNER_CUTOFF = 0.08
#: Least number of points in a corner: with fewer there is no shape to keep.
FEWEST_IN_CORNER = 3
#: Length [mm] to either side of the joint within which a change of slope as great as the second value is an edge: a
#: radius below 0.1 mm, which the filter does not leave as it is.
EDGE, SHARPEST = 0.01, 0.1
# The second-order filter transmits half of a wave of the cutoff with this constant in its weight (ISO 16610-31).
_SECOND_ORDER = 0.7309
_REACH = 2.2  # cutoffs; there the weight has fallen to 4e-13 of its peak
# Lengths [mm] of the land and of the corner that decide where the joint is, and how far it may lie inside and outside
# of the end of the land: a radius of R is as steep as the end of the land at a distance of R / 20.
_LAND, _CORNER = 0.4, 0.05
_INSIDE, _OUTSIDE = 0.2, 0.03
_FEWEST_ON_LAND, _MOST_TRIED = 8, 120
_ROUNDING = 1e-6  # mm, so that points at these distances count wherever the machine has its zero
_RESOLUTION = 1e-6  # mm: machines resolve nanometres, and of lines without noise rounding should decide nothing
_LIKELY = 4.0  # two standard errors, squared
_PINNED = 1e3  # weight of the joint over that of all points within a cutoff
_ALONE = 1e-9  # of the weight: a point too lonely for a parabola keeps its height
_PER_CUTOFF = 8
_RUN_OUT_CUTOFF = 0.25  # mm, the next in the series, for the land beside a corner
_NODES = 40  # per cutoff at which the filter is evaluated: straight lines between them miss 1 nm on a radius of 0.5 mm
_COARSER = 0.05  # of the distance from the land: no contact reaches far into a corner


def joint(points: Points, end: float, side: int) -> float:
    """Return where a corner begins [mm], at one of the points.

    Parameters
    ----------
    points : Points
        The measured line.
    end : float
        End of the land [mm] as `nonhertz.measured.land.land` finds it.
    side : {-1, 1}
        At which end of the land.
    """
    outwards = slice(None, None, side)
    distance, height = side * (points.y[outwards] - end), points.height[outwards]
    near = (distance >= -_LAND - _ROUNDING) & (distance <= _CORNER + _ROUNDING)
    distance, height = distance[near], _without_spikes(height[near])
    tried = distance[_FEWEST_ON_LAND : len(distance) - FEWEST_IN_CORNER]
    tried = tried[(tried >= -_INSIDE - _ROUNDING) & (tried <= _OUTSIDE + _ROUNDING)]
    if len(tried) == 0:
        return end
    tried = tried[:: -(-len(tried) // _MOST_TRIED)]
    misses = np.array([_miss(distance / _LAND, height, place / _LAND) for place in tried])
    least = float(np.min(misses)) + len(distance) * _RESOLUTION**2
    likely = misses <= least * (1.0 + _LIKELY / max(len(distance) - 6, 1))
    place = end + side * tried[int(np.argmax(likely))]
    return float(points.y[np.abs(points.y - place).argmin()])


def smooth_corners(points: Points, land: Array, cutoff: float = CORNER_CUTOFF) -> Array:
    """Return heights [mm] with the corners smoothed.

    Parameters
    ----------
    points : Points
        The measured line, whose `land` is known.
    land : array, shape (m,)
        Smoothed heights of its land [mm].
    cutoff : float
        Wavelength [mm] at which the filter transmits 50 %.

    Returns
    -------
    array, shape (n,)
        Smoothed heights of all points. A corner with fewer than five points per cutoff keeps its heights.
    """
    height = points.height.copy()
    low, high = points.beyond_land
    land = _run_out(points, land)
    height[~(low | high)] = land
    # A point between two gaps represents no length.
    weight = np.maximum(points.weights, 1e-6 * float(np.max(points.weights)))
    for corner, at_end in ((low, 0), (high, -1)):
        if not np.any(corner) or not is_resolved(points, corner, cutoff):
            continue
        distance = (points.y[corner] - points.on_land.y[at_end]) / cutoff
        drop = points.height[corner] - land[at_end]
        height[corner] = land[at_end] + _regress(distance, drop, weight[corner] / cutoff, _PINNED)
    return height


def _run_out(points: Points, land: Array) -> Array:
    """Return the smoothed land with what a shorter cutoff keeps of its last stretch before a corner."""
    on_land = points.on_land
    land = land.copy()
    for corner, at_end, side in zip(points.beyond_land, (0, -1), (-1.0, 1.0), strict=True):
        inwards = side * (on_land.y[at_end] - on_land.y)
        near = inwards <= _LAND + _ROUNDING
        if not np.any(corner) or not is_resolved(on_land, near, _RUN_OUT_CUTOFF):
            continue
        residual = on_land.height[near] - land[near]
        residual = _regress(
            -side * inwards[near] / _RUN_OUT_CUTOFF, residual, on_land.weights[near] / _RUN_OUT_CUTOFF, 0.0
        )
        land[near] += residual * np.cos(0.5 * math.pi * inwards[near] / _LAND) ** 2
    return land


def is_resolved(points: Points, corner: NDArray[np.bool_], cutoff: float = CORNER_CUTOFF) -> bool:
    """Return whether a corner has as many points per cutoff as a filter needs: five."""
    if np.sum(corner) < FEWEST_POINTS:
        return False
    return shortest_cutoff(Points(points.y[corner], points.height[corner])) <= cutoff * (1.0 + 1e-6)


def turns(points: Points) -> tuple[float, float]:
    """Return by how much the slope changes where the corners at low and high y begin, zero where there is none."""
    angles = []
    for side, corner, at_end in zip((-1.0, 1.0), points.beyond_land, (0, -1), strict=True):
        end = float(points.on_land.y[at_end])
        inner, at, outer = np.interp(end + side * EDGE * np.array([-1.0, 0.0, 1.0]), points.y, points.height)
        angles.append(float(2.0 * at - inner - outer) / EDGE if is_resolved(points, corner) else 0.0)
    return angles[0], angles[1]


def positions(points: Points) -> Array:
    """Return enough positions [mm] for the corners of a line, and for the land where it meets them.

    There are eight per cutoff, fewer far from the land, and never more than there are points. The land is as finely
    divided for a cutoff's length, so that a spline does not swing where a corner bends away.
    """
    low, high = points.beyond_land
    places = []
    for side, corner, at_end in ((-1.0, low, 0), (1.0, high, -1)):
        if not np.any(corner):
            continue
        end = points.on_land.y[at_end]
        extent = abs(float(points.y[at_end] - end))
        if not is_resolved(points, corner):
            places.append(points.y[corner])
            continue
        distances = [0.0]
        while distances[-1] < extent - _ROUNDING:
            distances.append(distances[-1] + max(CORNER_CUTOFF / _PER_CUTOFF, _COARSER * distances[-1]))
        outwards = np.array(distances) * extent / distances[-1]
        inwards = -CORNER_CUTOFF / _PER_CUTOFF * np.arange(1, _PER_CUTOFF + 1)
        places.append(end + side * np.concatenate([outwards, inwards]))
    return np.concatenate(places) if places else np.empty(0)


def _without_spikes(height: Array) -> Array:
    """Return heights with single points that stand out replaced by the median of their neighbours."""
    from scipy.ndimage import median_filter

    usual = median_filter(height, 5, mode="nearest")
    off = np.abs(height - usual)
    return np.where(off > 7.4 * np.median(off), usual, height)


def _miss(distance: Array, height: Array, place: float) -> float:
    """Return the sum of squares that is left of a parabola with another one added beyond a place."""
    beyond = np.maximum(distance - place, 0.0)
    terms = np.stack([np.ones_like(distance), distance, distance**2, beyond, beyond**2], axis=1)
    coefficients = np.linalg.lstsq(terms, height, rcond=None)[0]
    return float(np.sum((terms @ coefficients - height) ** 2))


def _regress(distance: Array, height: Array, weight: Array, pinned: float) -> Array:
    """Return heights after a second-order regression filter: of the parabola that fits best around each point.

    Distances from the joint, ascending, and weights are in cutoffs. Heights are relative to the joint, which all
    parabolas near it pass if it is pinned with a great weight.
    """
    extent = float(distance[-1]) if distance[-1] > 0.0 else float(distance[0])
    nodes = np.linspace(0.0, extent, math.ceil(_NODES * abs(extent) - _ROUNDING) + 1)[:: 1 if extent > 0.0 else -1]
    smooth = np.empty_like(nodes)
    for k, place in enumerate(nodes):
        near = slice(*np.searchsorted(distance, (place - _REACH, place + _REACH)))
        away = np.append(distance[near] - place, -place)
        share = np.append(weight[near], pinned) * np.exp(-math.pi * (away / _SECOND_ORDER) ** 2)
        terms = np.stack([np.ones_like(away), away, away**2])
        matrix = (share * terms) @ terms.T
        matrix[[1, 2], [1, 2]] += _ALONE * matrix[0, 0]
        smooth[k] = np.linalg.solve(matrix, (share * terms) @ np.append(height[near], 0.0))[0]
    return np.interp(distance, nodes, smooth)
