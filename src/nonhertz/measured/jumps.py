"""Steps in a measured line: from one height of the surface to another at the same slope.

A step is where the surface rises over one chord by more than over the chords on both sides, and goes on at the same
slope on either side, which medians of both sides tell. It is found by that alone, whatever the limit of the slope of a
chamfer and the distance of the points. In an edge, a curve or a wave the rise lies between those beside it, or is less
than what the sides suggest; two steps close together that add up to nothing are a groove or a bump.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.measured.outlying import runs
from nonhertz.measured.trace import Array, Points

#: Tolerance of comparisons, so that a mirror image has the same steps.
ROUNDING = 1e-9
#: The least length of surface on either side of a step, over the length of the trace.
BESIDE_STEP = 0.02
_POINTS_BESIDE = 6
# Half-length of a chord over the length of the trace. At most this much of the land is lost at an edge.
_CHORD = 0.0025
_SPIKE = 5  # points
# Width, over the length of the trace, up to which two steps are a groove or a bump.
_GROOVE = 0.1
# Height of the least step [mm], and how many standard deviations of the rise over a chord it is high at least. The
# deviation is taken from these fractions of the rises: chatter on a part of the line is surface.
_LEAST_STEP, _CLEAR, _HALF, _MOST = 1e-3, 5.0, 0.5, 0.9
# Fraction of a step up to which the slopes beside it may contribute, measures of it may differ, and two steps add up to
# nothing.
_SLIGHT = 0.25


@dataclass(frozen=True)
class SurfaceStep:
    """A step from one height of a surface to another at the same slope."""

    y: float  # where it is [mm]
    height: float  # by how much the surface rises towards positive y [mm]
    within: bool  # whether both sides of it belong to the land


def jumps(points: Points) -> list[SurfaceStep]:
    """Return the steps of any height from one stretch of surface to the next at the same slope."""
    from scipy.special import erfinv

    y, half = points.y, half_chord(points)
    # Without its slope, so that a tilted line has the same steps.
    line = (points.height[-1] - points.height[0]) / points.span * (y - y[0])
    height = remove_spikes(points.height - line)
    at = [np.interp(y + k * half, y, height) for k in (-3, -1, 1, 3)]
    before, rise, after = np.diff(at, axis=0)
    reach = 3.0 * half - ROUNDING * points.span
    excess = np.where((y >= y[0] + reach) & (y <= y[-1] - reach), rise - 0.5 * (before + after), 0.0)
    # One step is felt over six half-chords, which are many of a few points.
    fractions = np.array([_HALF, max(_MOST - 12.0 * half / points.span, _HALF)])
    sigma = np.max(np.quantile(np.abs(excess), fractions) / (math.sqrt(2.0) * erfinv(fractions)))
    least = max(_LEAST_STEP, _CLEAR * float(sigma))
    # In an edge or a curve the rise lies between those beside it.
    steep = (np.abs(excess) > least) & (np.abs(excess) > np.abs(after - before))
    steps: list[SurfaceStep] = []
    for first, last in runs(np.where(steep, np.sign(excess), 0.0).astype(np.int8)):
        middle = float(0.5 * (y[first] + y[last]))
        step = _rise_at(points, middle, half)
        over_chord = float(excess[first + int(np.argmax(np.abs(excess[first : last + 1])))])
        # All of a step lies within one chord, unlike what is only steep there.
        if abs(step) > least and abs(step - over_chord) <= _SLIGHT * abs(step):
            steps.append(SurfaceStep(middle, step, within=True))
    apart: list[SurfaceStep] = []
    for one in sorted(steps, key=lambda jump: -abs(jump.height)):  # noise may find one twice
        if all(abs(one.y - other.y) > 2.0 * half for other in apart):
            apart.append(one)
    return [one for one in apart if not any(_are_groove(one, other, points.span) for other in apart)]


def _are_groove(step: SurfaceStep, other: SurfaceStep, span: float) -> bool:
    """Return whether two steps are the walls of a groove or of a bump."""
    least = _SLIGHT * max(abs(step.height), abs(other.height))
    return abs(step.y - other.y) <= _GROOVE * span and abs(step.height + other.height) <= least


def _rise_at(points: Points, middle: float, half: float) -> float:
    """Return the height of the surface on the right above that on the left [mm]; zero if it does not continue there.

    Each side is a line through the medians of its two halves, so that a scratch beside the step does not count. Both
    have the same slope, and on one side at least the surface goes on at that slope, unlike a wave.
    """
    length = max(BESIDE_STEP * points.span, _POINTS_BESIDE * float(np.median(np.diff(points.y))))
    reach = half + 0.25 * length
    heights, slopes, turns = [], [], []
    for side in (-1.0, 1.0):
        near, far, third, fourth = _medians_beside(points, middle, side * half, side * 0.5 * length)
        if near is None or far is None:
            return 0.0
        slopes.append(_slope(near, far))
        heights.append(near[1] + slopes[-1] * (middle - near[0]))
        if third is not None and fourth is not None:
            turns.append(abs(_slope(third, fourth) - slopes[-1]))
    rise = heights[1] - heights[0]
    alike = abs(slopes[1] - slopes[0]) * length < abs(rise)
    return rise if alike and min(turns, default=0.0) * reach <= _SLIGHT * abs(rise) else 0.0


def _medians_beside(points: Points, middle: float, gap: float, width: float) -> list[tuple[float, float] | None]:
    """Return medians of position and height in four neighbouring stretches, None for one that was not measured."""
    medians: list[tuple[float, float] | None] = []
    slack = ROUNDING * points.span
    for part in range(4):
        low, high = sorted((middle + gap + part * width, middle + gap + (part + 1) * width))
        inside = slice(*np.searchsorted(points.y, (low - slack, high + slack)))
        if points.y[0] - slack <= low and high <= points.y[-1] + slack and inside.start < inside.stop:
            medians.append((float(np.median(points.y[inside])), float(np.median(points.height[inside]))))
        else:
            medians.append(None)
    return medians


def _slope(one: tuple[float, float], other: tuple[float, float]) -> float:
    return (other[1] - one[1]) / (other[0] - one[0]) if other[0] != one[0] else 0.0


def half_chord(points: Points) -> float:
    """Return half the length of the chords that slopes are taken over [mm], two points at least."""
    return max(_CHORD * points.span, 2.0 * float(np.median(np.diff(points.y))))


def remove_spikes(height: Array) -> Array:
    """Return heights after a running median that removes single spikes."""
    from scipy.ndimage import median_filter

    return np.asarray(median_filter(height, _SPIKE, mode="nearest"))
