"""Where the land of a body ends and its chamfers begin, and how a trace is tilted in the machine.

A chamfer is steep, a profile is not: the steepest roller profiles drop by a few hundredths of a millimetre per
millimetre, a chamfer by tenths. So the land is the longest stretch whose slope stays within a limit of the slope of the
whole trace. Slopes are those of short chords, after a running median of five points has removed single spikes. A
scratch does not end the land, because the surface continues beyond it at the same height. Nor does a step of some
micrometres beyond which it continues at the same slope: no chamfer is so narrow and low. `steps_in` returns all steps,
including those too high to be part of one land.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from nonhertz.errors import InputError
from nonhertz.measured.outlying import runs
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

#: Slope exceeded by every chamfer and by no profile, 3 degrees.
CHAMFER_SLOPE = 0.05
# Half-length of a chord over the length of the trace. At most this much of the land is lost at an edge.
_CHORD = 0.0025
_SPIKE = 5  # points
# A step: its greatest width (half of which is due to the chords) and the least length of surface on either side, both
# over the length of the trace. Up to the first height [mm] the land continues beyond it; above the second it is a rib
# or another body, which is never part of the land.
_STEP_WIDTH, _BESIDE_STEP = 0.01, 0.02
_LOW_STEP, _HIGH_STEP = 0.02, 0.2


@dataclass(frozen=True)
class SurfaceStep:
    """A step from one height of a surface to another at the same slope."""

    y: float  # where it is [mm]
    height: float  # by how much the surface rises towards positive y [mm]
    within: bool  # whether both sides of it belong to the land


def land(points: Points, slope: float = CHAMFER_SLOPE) -> tuple[float, float]:
    """Return the ends [mm] of the land.

    Parameters
    ----------
    points : Points
        The measured line, which may be tilted.
    slope : float
        How much steeper than the whole line the land may be.

    Returns
    -------
    tuple of float
        Both ends; the outermost points if nothing is steeper.

    Raises
    ------
    InputError
        If hardly anything is less steep.
    """
    level, runs = _gentle(points, slope)
    first, last = _extended(points, runs, level, slope) if runs else (0, 0)
    if last - first + 1 < FEWEST_POINTS:
        condition = f"leave {FEWEST_POINTS} neighbouring points that are less steep"
        raise InputError("slope", slope, condition, "give a larger one, or leave out level, align and trim")
    return float(points.y[first]), float(points.y[last])


def corner_ends(points: Points, slope: float = CHAMFER_SLOPE) -> tuple[float, float]:
    """Return how far the corners go on beyond the ends of the land [mm]; an end of the land where there is no corner.

    A corner falls away from the land. It ends at its lowest point, at the latest where another gentle stretch begins,
    such as the next diameter of a stepped body or what the body lies on. Whatever rises from the land is no corner.

    Arguments and errors are those of `land`.
    """
    low, high = land(points, slope)
    level, runs = _gentle(points, slope)
    others = [run for run in runs if _is_long(points, run)]
    bounds = (
        max((points.y[last] for _, last in others if points.y[last] < low), default=points.y[0]),
        min((points.y[first] for first, _ in others if points.y[first] > high), default=points.y[-1]),
    )
    found = []
    for end, bound in zip((low, high), bounds, strict=True):
        among = np.flatnonzero((points.y >= min(end, bound)) & (points.y <= max(end, bound)))
        levelled = points.height[among] - level * points.y[among]
        found.append(float(points.y[among[int(np.argmin(levelled))]]))
    return found[0], found[1]


def steps_in(points: Points, slope: float = CHAMFER_SLOPE) -> tuple[SurfaceStep, ...]:
    """Return the steps of up to 0.2 mm in a line, both those within the land and those that end it.

    Arguments and errors are those of `land`.
    """
    low, high = land(points, slope)
    level, runs = _gentle(points, slope)
    found = []
    for before, behind in pairwise(run for run in runs if _is_long(points, run)):
        step = _step(points, before, behind, level)
        if step is None or abs(step) > _HIGH_STEP or _goes_on(points, before[1], behind[0], level, slope):
            continue
        within = bool(low <= points.y[before[1]] and points.y[behind[0]] <= high)
        found.append(SurfaceStep(float(0.5 * (points.y[before[1]] + points.y[behind[0]])), step, within))
    return tuple(found)


def chord_slopes(points: Points) -> Array:
    """Return the slope of a short chord around every point, one-sided at the outermost ones."""
    from scipy.ndimage import median_filter

    height = median_filter(points.height, _SPIKE, mode="nearest")
    half = max(_CHORD * points.span, 2.0 * float(np.median(np.diff(points.y))))
    low = np.maximum(points.y - half, points.y[0])
    high = np.minimum(points.y + half, points.y[-1])
    rise = np.interp(high, points.y, height) - np.interp(low, points.y, height)
    return np.asarray(rise / (high - low))


def tilt(points: Points, slope: float = CHAMFER_SLOPE) -> float:
    """Return the tilt of a line in the machine, irrespective of the shape of the land.

    About the middle of the land the heights are split into an even and an odd part. A symmetric shape, crown or
    straight, is entirely even; tilt is a straight line in the odd part. The line is that of least absolute, not
    squared, deviations, a median of odd part over distance weighted by distance: material lost at one end only does not
    rotate it, as long as that is less than half.

    A tilted circular arc is the same arc moved sideways. Tilt and a crown off the middle of the land are therefore
    indistinguishable; both count as tilt. Steps within the land are not part of it: both sides of a step have the same
    tilt.
    """
    low, high = land(points, slope)
    middle = 0.5 * (low + high)
    height = points.height - sum(step.height * (points.y > step.y) for step in steps_in(points, slope) if step.within)
    inside = (points.y > middle) & (points.y <= high)
    distance = points.y[inside] - middle
    mirrored = np.interp(middle - distance, points.y, height)
    odd = 0.5 * (height[inside] - mirrored)
    return weighted_median(odd / distance, distance * points.weights[inside])


def symmetry(points: Points, slope: float = CHAMFER_SLOPE) -> float | None:
    """Return the position [mm] about which the land is its own mirror image except for a tilt, or None.

    Positions up to a tenth of the land's length from its middle are tried on a grid. None is returned for a land that
    is no less symmetric at the ends of the search, such as a single circular arc.
    """
    low, high = land(points, slope)
    middle, reach = 0.5 * (low + high), 0.1 * (high - low)
    distance = np.linspace(0.0, 0.5 * (high - low) - reach, 400)[1:]
    places = middle + np.linspace(-reach, reach, 201)
    unlike = np.array([_oddness(points, place, distance) for place in places])
    best = int(np.argmin(unlike))
    if not 0 < best < len(places) - 1 or unlike[best] > 0.25 * min(unlike[0], unlike[-1]):
        return None
    before, at, after = unlike[best - 1 : best + 2]
    bend = before - 2.0 * at + after
    step = places[1] - places[0]
    return float(places[best] + (0.5 * step * (before - after) / bend if bend > 0.0 else 0.0))


def weighted_median(values: Array, weights: Array) -> float:
    """Return the value with half the weight on either side."""
    order = np.argsort(values, kind="stable")
    heaped = np.cumsum(weights[order])
    return float(values[order][int(np.searchsorted(heaped, 0.5 * heaped[-1]))])


def _oddness(points: Points, place: float, distance: Array) -> float:
    """Return the mean square of the odd part about a position, less its best straight line."""
    left, right = (np.interp(place + side * distance, points.y, points.height) for side in (-1.0, 1.0))
    odd = 0.5 * (right - left)
    slope = float(odd @ distance / (distance @ distance))
    return float(np.mean((odd - slope * distance) ** 2))


def _gentle(points: Points, slope: float) -> tuple[float, list[tuple[int, int]]]:
    """Return the slope of the whole line, and first and last index of every stretch within the limit of it."""
    steepness = chord_slopes(points)
    level = weighted_median(steepness, points.weights)
    return level, list(runs((np.abs(steepness - level) <= slope).astype(np.int8)))


def _extended(points: Points, runs: list[tuple[int, int]], level: float, slope: float) -> tuple[int, int]:
    """Return the longest stretch extended by neighbouring ones at which the surface is back at its height."""
    longest = max(runs, key=lambda run: points.y[run[1]] - points.y[run[0]])
    first, last = longest
    for run in runs[runs.index(longest) + 1 :]:
        if _goes_on(points, last, run[0], level, slope) or _is_low(_step(points, (first, last), run, level)):
            last = run[1]
    for run in reversed(runs[: runs.index(longest)]):
        if _goes_on(points, run[1], first, level, slope) or _is_low(_step(points, run, (first, last), level)):
            first = run[0]
    return first, last


def _step(points: Points, before: tuple[int, int], behind: tuple[int, int], level: float) -> float | None:
    """Return the height of the step between two stretches; None if there is no step between them."""
    way = float(points.y[behind[0]] - points.y[before[1]])
    if way > _STEP_WIDTH * points.span or not (_is_long(points, before) and _is_long(points, behind)):
        return None
    return float(points.height[behind[0]] - points.height[before[1]]) - level * way


def _is_low(step: float | None) -> bool:
    return step is not None and abs(step) <= _LOW_STEP


def _is_long(points: Points, run: tuple[int, int]) -> bool:
    return bool(points.y[run[1]] - points.y[run[0]] >= _BESIDE_STEP * points.span)


def _goes_on(points: Points, before: int, after: int, level: float, slope: float) -> bool:
    way = points.y[after] - points.y[before]
    return bool(abs(points.height[after] - points.height[before] - level * way) <= slope * way)
