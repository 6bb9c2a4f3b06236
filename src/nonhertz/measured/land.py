"""Where the land of a body ends and its chamfers begin, and how a trace is tilted in the machine.

A chamfer is steep, a profile is not: the steepest roller profiles drop by a few hundredths of a millimetre per
millimetre, a chamfer by tenths. So the land is the longest stretch whose slope stays within a limit of the slope of the
whole trace. Slopes are those of short chords, after a running median of five points has removed single spikes. A
scratch does not end the land, because the surface continues beyond it at the same height. Nor does a low step
(`nonhertz.measured.jumps`), since no chamfer is so narrow and low; a higher one does, unless the surface comes back as
beyond a groove. `steps_in` returns both, and what else separates the land from a neighbouring stretch.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nonhertz.errors import InputError
from nonhertz.measured.jumps import BESIDE_STEP, ROUNDING, SurfaceStep, half_chord, jumps, remove_spikes
from nonhertz.measured.outlying import runs
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

#: Slope exceeded by every chamfer and by no profile, 3 degrees.
CHAMFER_SLOPE = 0.05
# The width of a step without the chord over it, over the length of the trace and in points.
_STEP_WIDTH, _POINTS_ACROSS = 0.005, 2
# Heights of steps [mm]: up to the first the land continues; above the second it is a rib or another body that is never
# part of the land.
_LOW_STEP, _HIGH_STEP = 0.02 * (1.0 + ROUNDING), 0.2 * (1.0 + ROUNDING)
# What a land may differ more from its mirror image without its steps than with them: a fraction, and mm.
_WORSE, _WORSE_BY = 1.1, 1e-4


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
    steps, level, runs = _gentle(points, slope)
    first, last = _extend(points, steps, runs, level, slope) if runs else (0, 0)
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
    steps, level, runs = _gentle(points, slope)
    walls = [step.y for step in steps if _LOW_STEP < abs(step.height) <= _HIGH_STEP]
    others = [run for run in runs if _is_long(points, run)]
    bounds = (
        max((points.y[last] for _, last in others if points.y[last] < low), default=points.y[0]),
        min((points.y[first] for first, _ in others if points.y[first] > high), default=points.y[-1]),
    )
    ends = []
    for end, bound in zip((low, high), bounds, strict=True):
        if any(min(end, bound) <= wall <= max(end, bound) for wall in walls):
            ends.append(end)  # a step is no corner
            continue
        among = np.flatnonzero((points.y >= min(end, bound)) & (points.y <= max(end, bound)))
        levelled = points.height[among] - level * points.y[among]
        ends.append(float(points.y[among[int(np.argmin(levelled))]]))
    return ends[0], ends[1]


def steps_in(points: Points, slope: float = CHAMFER_SLOPE) -> tuple[SurfaceStep, ...]:
    """Return the steps of up to 0.2 mm in a line: those within the land, and those between it and another stretch.

    Arguments and errors are those of `land`.
    """
    low, high = land(points, slope)
    steps, level, runs = _gentle(points, slope)
    within = [step for step in steps if low < step.y < high and abs(step.height) <= _HIGH_STEP]
    # If removing the steps makes the two halves less alike, they were a wave, not steps.
    worse = _unlike(points, (low, high), within)[0] > _WORSE * _unlike(points, (low, high), [])[0] + _WORSE_BY
    distinct = [] if worse else [step for step in within if abs(step.height) <= _LOW_STEP]
    long = [run for run in runs if _is_long(points, run)]
    at_low = [(points.y[run[1]], low) for run in long if points.y[run[1]] < low][-1:]
    at_high = [(high, points.y[run[0]]) for run in long if points.y[run[0]] > high][:1]
    for side, end, parted in ((-1.0, low, at_low), (1.0, high, at_high)):
        walls = [replace(step, within=False) for step in steps if side * step.y >= side * end]
        walls += [] if walls else [_step_between(points, before, behind, level) for before, behind in parted]
        nearest = min(walls, key=lambda step: abs(step.y - 0.5 * (low + high)), default=None)
        distinct += [nearest] if nearest is not None and abs(nearest.height) <= _HIGH_STEP else []
    return tuple(sorted(distinct, key=lambda step: step.y))


def _step_between(points: Points, before: float, behind: float, level: float) -> SurfaceStep:
    """Return the step between two stretches that end and begin at two positions, of a line with a slope."""
    z0, z1 = np.interp((before, behind), points.y, points.height)
    return SurfaceStep(0.5 * (before + behind), float(z1 - z0 - level * (behind - before)), within=False)


def chord_slopes(points: Points) -> Array:
    """Return the slope of a short chord around every point, one-sided at the outermost ones."""
    height, half = remove_spikes(points.height), half_chord(points)
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
    steps = [step for step in jumps(points) if low < step.y < high and abs(step.height) <= _HIGH_STEP]
    return min(_unlike(points, (low, high), steps), _unlike(points, (low, high), []))[1]


def _unlike(points: Points, ends: tuple[float, float], steps: list[SurfaceStep]) -> tuple[float, float]:
    """Return the difference of a land without some steps from its mirror image [mm], without the tilt, and the tilt."""
    low, high = ends
    middle = 0.5 * (low + high)
    height = points.height - sum((step.height * (points.y > step.y) for step in steps), np.zeros(len(points)))
    # Both halves, each with its points: then the mirror image of a line has the opposite tilt, however it is spaced.
    inside = (points.y >= low) & (points.y <= high) & (points.y != middle)
    offset, weights = points.y[inside] - middle, points.weights[inside]
    odd = 0.5 * np.sign(offset) * (height[inside] - np.interp(middle - offset, points.y, height))
    distance = np.abs(offset)
    lean = weighted_median(odd / distance, distance * weights)
    return float(np.average(np.abs(odd - lean * distance), weights=weights)), lean


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
    """Return the value with half the weight on either side, the mean of two where half of it lies between them."""
    order = np.argsort(values, kind="stable")
    heaped = np.cumsum(weights[order])
    halves = 0.5 * heaped[-1] * np.array([1.0 - ROUNDING, 1.0 + ROUNDING])
    return float(np.mean(values[order][np.searchsorted(heaped, halves)]))


def _oddness(points: Points, place: float, distance: Array) -> float:
    """Return the mean square of the odd part about a position, less its best straight line."""
    below, above = (np.interp(place + side * distance, points.y, points.height) for side in (-1.0, 1.0))
    odd = 0.5 * (above - below)
    slope = float(odd @ distance / (distance @ distance))
    return float(np.mean((odd - slope * distance) ** 2))


def _gentle(points: Points, slope: float) -> tuple[list[SurfaceStep], float, list[tuple[int, int]]]:
    """Return the steps in a line, its slope, and first and last index of every stretch within the limit of that.

    A high step ends a stretch however gentle the chords over the step are.
    """
    steps, half = jumps(points), half_chord(points)
    steepness = chord_slopes(points)
    level = weighted_median(steepness, points.weights)
    gentle = np.abs(steepness - level) <= slope * (1.0 + ROUNDING)
    for step in steps:
        if abs(step.height) > _LOW_STEP:
            gentle &= np.abs(points.y - step.y) >= half * (1.0 - ROUNDING)
    return steps, level, list(runs(gentle.astype(np.int8)))


def _extend(
    points: Points, steps: list[SurfaceStep], runs: list[tuple[int, int]], level: float, slope: float
) -> tuple[int, int]:
    """Return the longest stretch extended by neighbouring ones at which the surface is back at its height.

    If two are equally long the higher one counts: it is what another body touches.
    """
    half, usual = half_chord(points), float(np.median(np.diff(points.y)))
    widest = (2.0 * half + max(_STEP_WIDTH * points.span, _POINTS_ACROSS * usual)) * (1.0 + ROUNDING)

    def goes_on(before: tuple[int, int], behind: tuple[int, int]) -> bool:
        y0, y1 = points.y[before[1]], points.y[behind[0]]
        rise = float(points.height[behind[0]] - points.height[before[1]] - level * (y1 - y0))
        height = sum(step.height for step in steps if y0 < step.y < y1)
        if abs(rise - height) <= 0.5 * abs(height):  # the step explains the rise; the walls of a groove do not
            if abs(height) > _LOW_STEP:
                return False
            rise = height
        low = abs(rise) <= _LOW_STEP and y1 - y0 <= widest and _is_long(points, before) and _is_long(points, behind)
        return low or bool(abs(rise) <= slope * (y1 - y0))

    lengths = [points.y[last] - points.y[first] for first, last in runs]
    alike = [run for run, length in zip(runs, lengths, strict=True) if length >= max(lengths) - 2.0 * half]
    levelled = points.height - level * points.y
    longest = max(alike, key=lambda run: float(np.mean(levelled[run[0] : run[1] + 1])))
    first, last = longest
    for run in runs[runs.index(longest) + 1 :]:
        if goes_on((first, last), run):
            last = run[1]
    for run in reversed(runs[: runs.index(longest)]):
        if goes_on(run, (first, last)):
            first = run[0]
    return first, last


def _is_long(points: Points, run: tuple[int, int]) -> bool:
    return bool(points.y[run[1]] - points.y[run[0]] >= BESIDE_STEP * points.span)
