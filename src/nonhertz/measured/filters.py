"""Two filters that separate the form of a profile from its roughness at a wavelength, the cutoff c.

Both transmit 50 % of a wave of that length. The Gaussian filter (ISO 16610-21) is a running mean with the weight

    s(x) = exp(-pi (x / (alpha c))^2) / (alpha c),    alpha = sqrt(ln 2 / pi),

and transmits exp(-pi (alpha c / l)^2) of a wave of length l. It is a sum over the original points, each weighted by the
length that it represents: interpolating first would attenuate the wave where points are few, by a hundredth at twenty
points per cutoff and by a sixth at five. Where a line ends or has a gap, the weight has no points on one side. There
the mean is replaced by the straight line that fits best under the same weight (moments of order zero and one are kept,
as ISO 16610-28 requires): inside, where the weight is symmetric, that is the same filter, and a line that ends on a
slope keeps it. A running mean alone would lift the end of a crown, and both lower a curved line everywhere, a parabola
of radius R by (alpha c)^2 / (4 pi R). So the parabola of least squares is taken off before a filter and added again.

The spline filter (ISO 16610-22) is the natural cubic smoothing spline. It minimises the squared distance plus
(c / 2 pi)^4 times the squared second derivative, transmits 1 / (1 + (c / l)^4), and also ends on a straight line.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.measured.land import weighted_median
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

ALPHA = math.sqrt(math.log(2.0) / math.pi)
# The weight is cut where it has fallen to exp(-pi / ALPHA^2), 7e-7 of its peak.
_REACH = 1.0
# With four points per cutoff the sum over points transmits 0.502 of it, with five 0.50002.
_FEWEST_PER_CUTOFF = 5
_ROUNDING = 1e-6  # tolerance for positions, so that five points count as five
_PER_CUTOFF_OF_GRID = 64
_BLOCK = 1000  # cutoffs filtered at a time, to limit memory
_PER_CUTOFF = 40  # points that the spline is fitted to


def gaussian(points: Points, cutoff: float) -> Array:
    """Return the heights [mm] after the Gaussian filter, at the same positions.

    Parameters
    ----------
    points : Points
        The measured line, evenly spaced or not.
    cutoff : float
        Wavelength [mm] at which the filter transmits 50 %.

    Raises
    ------
    InputError
        If the cutoff is shorter than five points on half of the line, or longer than the line.

    References
    ----------
    ISO 16610-21:2011, Geometrical product specifications - Filtration - Linear profile filters: Gaussian filters,
    for weight and transmission; ISO 16610-28:2016 for ends.
    """
    check_cutoff(points, cutoff)
    form = nominal_form(points, 2)
    y, height, weight = points.y, points.height - form, _positive(points.weights)
    smooth = np.empty(len(y))
    begin = 0
    while begin < len(y):
        end = int(np.searchsorted(y, y[begin] + _BLOCK * cutoff, side="right"))
        first, last = np.searchsorted(y, (y[begin] - _REACH * cutoff, y[end - 1] + _REACH * cutoff))
        near = slice(int(first), int(last))
        smooth[begin:end] = _regress(y[near], height[near], weight[near], y[begin:end], cutoff)
        begin = end
    return np.asarray(form + smooth)


def spline(points: Points, cutoff: float) -> Array:
    """Return the heights [mm] after the spline filter, at the same positions.

    Parameters
    ----------
    points : Points
        The measured line, evenly spaced or not; the spline bridges gaps.
    cutoff : float
        As in `gaussian`, which raises the same errors.

    References
    ----------
    ISO 16610-22:2015, Geometrical product specifications - Filtration - Linear profile filters: Spline filters.
    """
    from scipy.interpolate import make_smoothing_spline

    check_cutoff(points, cutoff)
    form = nominal_form(points, 2)
    y, height, weight = _average_bins(points.lifted(points.height - form), cutoff / _PER_CUTOFF)
    if len(y) < FEWEST_POINTS:
        condition = f"divide the points into at least {FEWEST_POINTS} groups, each a fortieth of it wide"
        raise InputError("cutoff", cutoff, condition, "give a shorter one, or use the gaussian filter")
    # In units of the cutoff: the equations of a spline in millimetres are a million times worse conditioned.
    curve = make_smoothing_spline(y / cutoff, height, weight / cutoff, lam=(0.5 / math.pi) ** 4)
    return np.asarray(form + curve(points.y / cutoff))


def nominal_form(points: Points, degree: int) -> Array:
    """Return the heights [mm] of the polynomial of least squares through a line, at its points."""
    fit = np.polynomial.Polynomial.fit(points.y, points.height, degree, w=np.sqrt(_positive(points.weights)))
    return np.asarray(fit(points.y))


def _positive(weights: Array) -> Array:
    """Return weights above zero: a point between two gaps represents no length, yet is the only one there."""
    return np.maximum(weights, np.min(weights[weights > 0.0]))


def check_cutoff(points: Points, cutoff: float) -> None:
    """Reject a cutoff that half of the line cannot resolve, or that is longer than the line."""
    shortest = shortest_cutoff(points)
    if not shortest <= cutoff * (1.0 + _ROUNDING) or cutoff > points.span:
        condition = f"lie between five points, {mm(shortest):.3g}, and the length of the line, {mm(points.span):.4g}"
        raise InputError("cutoff", cutoff, condition, "give a wavelength in mm between them, or leave smooth out")


def shortest_cutoff(points: Points) -> float:
    """Return the shortest wavelength [mm] that the points resolve on half of the line or more."""
    return _FEWEST_PER_CUTOFF * weighted_median(*_measured_steps(points))


def unresolved_length(points: Points, cutoff: float) -> float:
    """Return the length [mm], without gaps, on which there are fewer than five points per cutoff."""
    steps, length = _measured_steps(points)
    return float(np.sum(length[_FEWEST_PER_CUTOFF * steps > cutoff * (1.0 + _ROUNDING)]))


def _measured_steps(points: Points) -> tuple[Array, Array]:
    """Return the steps between points, and the measured length of each: zero in a gap."""
    steps = np.diff(points.y)
    return steps, np.where(points.in_gap, 0.0, steps)


def _regress(y: Array, height: Array, weight: Array, at: Array, cutoff: float) -> Array:
    """Return the height at given positions [mm] of the straight line that fits best around each, under the weight.

    Sums over points are evaluated at the nodes of a fine grid. Points are spread to their four nearest nodes, and
    results interpolated from them, by cubics: at a spacing of a 64th of the cutoff that is exact to 2e-6. Distances are
    measured to the points themselves and not to the nodes, so that straight lines are kept exactly.
    """
    step = cutoff / _PER_CUTOFF_OF_GRID
    origin = y[0] - 2.0 * step
    count = int((y[-1] - origin) / step) + 4
    sums = np.zeros((5, count))
    for node, share in _nodes(y, origin, step):
        distance = y - (origin + step * node)
        for k, term in enumerate((1.0, distance, distance**2, height, height * distance)):
            sums[k] += np.bincount(node, weight * share * term, count)
    w0, w1, w2, h0, h1 = sums
    reach = math.ceil(_REACH * cutoff / step)
    offset = step * np.arange(-reach, reach + 1)
    k0 = np.exp(-math.pi * (offset / (ALPHA * cutoff)) ** 2)
    k1, k2 = k0 * offset, k0 * offset**2
    m0, m1, m2 = _sums(w0, k0), _sums(w0, k1) + _sums(w1, k0), _sums(w0, k2) + 2.0 * _sums(w1, k1) + _sums(w2, k0)
    n0, n1 = _sums(h0, k0), _sums(h0, k1) + _sums(h1, k0)
    # Nodes out of reach of all points have no weight and are never used.
    m0 = np.where(m0 > 0.0, m0, 1.0)
    spread = m0 * m2 - m1**2
    # A single point under the weight has a mean but no line.
    alone = ~(spread > 1e-9 * (cutoff * m0) ** 2)
    line = np.where(alone, n0 / m0, (m2 * n0 - m1 * n1) / np.where(alone, 1.0, spread))
    return np.asarray(sum(share * line[node] for node, share in _nodes(at, origin, step)))


def _nodes(y: Array, origin: float, step: float) -> Iterator[tuple[NDArray[np.intp], Array]]:
    """Yield the four nodes around each position, and their weights in a Lagrange cubic through them."""
    place = (y - origin) / step
    node = np.floor(place).astype(np.intp)
    u = place - node
    yield node - 1, -u * (u - 1.0) * (u - 2.0) / 6.0
    yield node, (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0
    yield node + 1, -(u + 1.0) * u * (u - 2.0) / 2.0
    yield node + 2, (u + 1.0) * u * (u - 1.0) / 6.0


def _sums(values: Array, kernel: Array) -> Array:
    """Return the correlation of the values with the kernel, at every node."""
    if len(values) >= len(kernel):
        return np.correlate(values, kernel, mode="same")
    padded = np.pad(values, len(kernel) // 2)
    return np.correlate(padded, kernel, mode="valid")


def _average_bins(points: Points, width: float) -> tuple[Array, Array, Array]:
    """Return means of the points in bins of a width [mm], and the length that each represents.

    At wavelengths of very many points, a spline through the points gives no more than one through their means.
    """
    bins = np.floor((points.y - points.y[0]) / width).astype(np.int64)
    _, bins = np.unique(bins, return_inverse=True)
    weight = np.bincount(bins, points.weights)
    # All weights are positive except beside gaps, where a point may represent no length.
    own = np.maximum(points.weights, 1e-12)
    weight = np.maximum(weight, np.bincount(bins, own))
    y, height = (np.bincount(bins, own * of) / np.bincount(bins, own) for of in (points.y, points.height))
    return y, height, np.asarray(weight, dtype=float)
