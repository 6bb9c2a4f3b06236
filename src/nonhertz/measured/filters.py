"""Two filters that part the shape of a profile from its roughness at a wavelength, the cutoff.

Both let half of a wave of that length through. The Gaussian filter (ISO 16610-21) is a running mean with the weight

    s(x) = exp(-pi (x / (alpha c))^2) / (alpha c),    alpha = sqrt(ln 2 / pi),

and lets through exp(-pi (alpha c / l)^2) of a wave of length l. Where a line ends or has a gap the weight has no points
on one side. There the mean is replaced by the straight line that fits best under the same weight (moments of order zero
and one are kept, as ISO 16610-28 asks): inside, where the weight is symmetric, that is the same filter, and a line that
ends on a slope keeps it. A running mean alone would lift the end of a crown.

The spline filter (ISO 16610-22) is the natural cubic smoothing spline. It minimises the squared distance plus
(c / 2 pi)^4 times the squared second derivative, lets through 1 / (1 + (c / l)^4), and ends on a straight line too.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.errors import InputError
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

ALPHA = math.sqrt(math.log(2.0) / math.pi)
# The weight is cut where it has fallen to exp(-pi / ALPHA^2), 7e-7 of its peak.
_REACH = 1.0
_LARGEST_GRID = 2**22
_PER_CUTOFF = 40  # points that the spline is fitted to


def gaussian(points: Points, cutoff: float) -> Array:
    """Return the heights [mm] that the Gaussian filter leaves at the same positions.

    Parameters
    ----------
    points : Points
        The measured line, evenly spaced or not.
    cutoff : float
        Wavelength [mm] of which half gets through.

    Raises
    ------
    InputError
        If the cutoff is shorter than four points or longer than the line.

    References
    ----------
    ISO 16610-21:2011, Geometrical product specifications - Filtration - Linear profile filters: Gaussian filters,
    for weight and transmission; ISO 16610-28:2016 for ends.
    """
    check_cutoff(points, cutoff)
    grid, step = _grid(points, cutoff)
    present = _covered(points, grid)
    known = present > 0.0
    # About the mean, so that no digits are lost where a line lies far from zero.
    mean = float(np.average(points.height, weights=points.weights))
    deviation = np.where(known, np.interp(grid, points.y, points.height) - mean, 0.0)
    reach = min(math.ceil(_REACH * cutoff / step), len(grid) - 1)
    offset = step * np.arange(-reach, reach + 1)
    weight = np.exp(-math.pi * (offset / (ALPHA * cutoff)) ** 2)
    m0, m1, m2 = (_moment(present, weight * offset**order)[known] for order in range(3))
    n0, n1 = (_moment(deviation, weight * offset**order)[known] for order in range(2))
    spread = m0 * m2 - m1**2
    # A point that is alone under its weight has a mean but no line.
    alone = spread <= 1e-9 * (cutoff * m0) ** 2
    smooth = np.where(alone, n0 / m0, (m2 * n0 - m1 * n1) / np.where(alone, 1.0, spread))
    return np.asarray(mean + np.interp(points.y, grid[known], smooth))


def spline(points: Points, cutoff: float) -> Array:
    """Return the heights [mm] that the spline filter leaves at the same positions.

    Parameters
    ----------
    points : Points
        The measured line, evenly spaced or not; the spline bridges gaps.
    cutoff : float
        Wavelength [mm] of which half gets through.

    Raises
    ------
    InputError
        If the cutoff is shorter than four points or longer than the line.

    References
    ----------
    ISO 16610-22:2015, Geometrical product specifications - Filtration - Linear profile filters: Spline filters.
    """
    from scipy.interpolate import make_smoothing_spline  # noqa: PLC0415  (slow to import)

    check_cutoff(points, cutoff)
    y, height, weight = _gathered(points, cutoff / _PER_CUTOFF)
    if len(y) < FEWEST_POINTS:
        condition = f"part the points into {FEWEST_POINTS} groups at least, each a fortieth of it wide"
        raise InputError("cutoff", cutoff, condition, "give a shorter one, or use the gaussian filter")
    # In cutoffs: the equations of a spline in millimetres are a million times worse conditioned.
    curve = make_smoothing_spline(y / cutoff, height, weight / cutoff, lam=(0.5 / math.pi) ** 4)
    return np.asarray(curve(points.y / cutoff))


def check_cutoff(points: Points, cutoff: float) -> None:
    """Refuse a cutoff that the points cannot resolve, or that the line is too short for."""
    shortest = 4.0 * float(np.median(np.diff(points.y)))
    if not shortest <= cutoff <= points.span:
        condition = f"lie between four points, {shortest:.3g} mm, and the length of the line, {points.span:.4g} mm"
        raise InputError("cutoff", cutoff, condition, "give a wavelength in mm between them, or leave smooth out")


def _grid(points: Points, cutoff: float) -> tuple[Array, float]:
    """Return even positions from end to end, as dense as most points lie."""
    usual = min(float(np.median(np.diff(points.y))), cutoff / 20.0)
    count = int(min(round(points.span / usual) + 1, _LARGEST_GRID))
    grid = np.linspace(points.y[0], points.y[-1], count)
    return grid, float(grid[1] - grid[0])


def _moment(values: Array, kernel: Array) -> Array:
    """Return at each place the sum of the values around it times the kernel, that of their offsets from the place."""
    reach = len(kernel) // 2
    size = len(values) + 2 * reach
    # A convolution takes the kernel the other way round.
    spectrum = np.fft.rfft(values, size) * np.fft.rfft(kernel[::-1], size)
    return np.asarray(np.fft.irfft(spectrum, size)[reach : reach + len(values)])


def _covered(points: Points, grid: Array) -> Array:
    """Return 1 where something was measured and 0 in gaps."""
    present = np.ones(len(grid))
    for low, high in points.gaps:
        present[(grid > low) & (grid < high)] = 0.0
    return present


def _gathered(points: Points, width: float) -> tuple[Array, Array, Array]:
    """Return means of the points in bins of a width [mm], and the length that each stands for.

    A spline through eight thousand points says nothing about wavelengths of a thousand of them that their means do not.
    """
    bins = np.floor((points.y - points.y[0]) / width).astype(np.int64)
    _, bins = np.unique(bins, return_inverse=True)
    weight = np.bincount(bins, points.weights)
    # All weights are positive but beside gaps, where a point may stand for nothing.
    own = np.maximum(points.weights, 1e-12)
    weight = np.maximum(weight, np.bincount(bins, own))
    y, height = (np.bincount(bins, own * of) / np.bincount(bins, own) for of in (points.y, points.height))
    return y, height, np.asarray(weight, dtype=float)
