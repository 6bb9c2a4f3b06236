"""Smooth part of the difference between a whole roller and a flat body with free ends, in polynomials along the axis.

For low numbers of waves around it is the work from finite elements minus the flat and the curved part of the same
modes; to this is added the sum over all modes of the flat body's functions, in closed form (Gradshteyn & Ryzhik
8.526), minus their integral. See `nonhertz.bodies.whole_roller` for the other parts.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, lru_cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.ends import IN_SPACE, corner_weights
from nonhertz.bodies.harmonic_elements import HarmonicElements
from nonhertz.bodies.quarter_space import free_face
from nonhertz.model.outline import Outline
from nonhertz.native import core

Array = NDArray[np.float64]

# Finite elements are faded out around the first number of waves, or the second over the wall, whichever is larger.
MODES, WALLS = 20.0, 6.0
_AT_ONCE = 0.1  # in ln: the width of the transition from one to the other
_SAMPLED = np.array([0, 2, 4, 6, 8, 12, 16, 20, 24, 32, 40, 52, 64, 80, 100, 128])  # modes to interpolate between
_POINTS = 4  # from which each mode is interpolated
# Polynomials along the axis, for a short roller and for each half-length; the last ones are faded out.
TERMS, _TERMS_PER_LENGTH, _FADING = 12.0, 6.0, 4.0
PER_TERM = 5.0  # half-lengths over the number of polynomials: the longest element
_PANELS, _NODES = 18, 12  # halvings towards logarithms, and nodes on each panel
_OUTER_NODES = 24  # and as many again for every eight polynomials: with half of them the sixth digit changes
_LAST_MODE = 4000
_SPACING = 2.0  # of the wave numbers of even modes, times the radius
_BY_SERIES, _REFLECTIONS = 2.5, 9  # series below the first; beyond it this many terms, of 1e-9 and less
_ZETA = (1.2020569031595942, 1.0369277551433699, 1.0083492773819228, 1.0020083928260822, 1.0004941886041195,
         1.0001227133475785, 1.0000305882363070, 1.0000076371976379)  # of 3, 5, 7 ...  # fmt: skip
_NEAREST, _FAR, _DISTANCES = 1e-12, 700.0, 3001  # of the flat body's functions, tabulated in the logarithm

_gauss = cache(legendre.leggauss)


def _step(x: Array) -> Array:
    """Return a function that rises from 0 to 1 between 0 and 1, with two continuous derivatives."""
    x = np.clip(x, 0.0, 1.0)
    step: Array = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)
    return step


def terms_along(outline: Outline) -> float:
    """Return the number of polynomials along the axis, a real number."""
    wall = outline.wall if outline.bored else 1.0
    return TERMS + _TERMS_PER_LENGTH * outline.half_length / math.sqrt(wall)


def modes_around(outline: Outline) -> float:
    """Return the number of waves around up to which finite elements are needed, a real number."""
    x = 0.5 * math.log(WALLS / outline.wall / MODES)
    return MODES * math.exp(x + math.hypot(x, 0.5 * _AT_ONCE))


def _sample_modes(most: float) -> dict[int, float]:
    """Return sampled modes and the weights with which they represent all modes.

    The remainder of a mode falls as n^-3: n^3 times it is interpolated in 1 / n, and constant beyond ``most``.
    """
    n: Array = np.arange(2.0, _LAST_MODE, 2.0)
    counts = _step((1.25 * most - n) / (0.5 * most))
    weights = np.zeros(_SAMPLED.size)
    for k, share in zip(n[counts > 0.0], counts[counts > 0.0], strict=True):
        first = max(1, int(np.searchsorted(_SAMPLED, k)) - _POINTS + 1)
        points = _SAMPLED[first : first + _POINTS]
        for at, one in enumerate(points, start=first):
            weight = math.prod((1.0 / k - 1.0 / other) / (1.0 / one - 1.0 / other) for other in points if other != one)
            weights[at] += share * weight * (one / k) ** 3
    changing = np.interp(_SAMPLED, n, counts * (1.0 - counts))
    weights += changing / changing.sum() * float(np.sum((1.0 - counts) / n**3)) * _SAMPLED**3.0
    weights[0] = 0.5
    return {int(k): 2.0 / math.pi * weight for k, weight in zip(_SAMPLED, weights, strict=True) if weight != 0.0}


def curved_factors(poisson: float) -> tuple[float, float, float]:
    """Return 1 - 2 nu and the factors A, B of the curved part of mode n, exp(-n s) (A / n - B s)."""
    along, beta = 1.0 - 2.0 * poisson, (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson))
    return along, along - beta, along + beta


def fade_weights(outline: Outline) -> Array:
    """Return the weights of polynomials along the axis, which fall for the last ones."""
    terms = terms_along(outline)
    return _step((terms - np.arange(float(math.ceil(terms)))) / _FADING)


def response_matrix(outline: Outline, poisson: float, count: int, longest: float) -> Array:
    """Return the smooth part between normalised Legendre polynomials, a radius being 1; see `WholeRoller`.

    Parameters
    ----------
    outline : Outline
        A section through the axis.
    poisson : float
        Poisson's ratio.
    count : int
        Number of polynomials, all with full weight.
    longest : float
        The longest element along the axis [radii].

    Returns
    -------
    ndarray, shape (count, count)
        Displacement over K times the load per length.
    """
    half_length, most = outline.half_length, modes_around(outline)
    modes = _sample_modes(most)
    order: Array = np.arange(float(count))
    norms: Array = np.sqrt((order + 0.5) / half_length)

    def polynomials(z: Array) -> Array:
        values: Array = legendre.legvander(z / half_length, count - 1) * norms
        return values

    elements = HarmonicElements(outline, poisson, most, longest)
    forces = elements.forces(polynomials)
    straight = outline.steepest == 0.0
    readings = None if straight else elements.forces(lambda z: polynomials(z) * outline.cosines(z)[:, None])
    work = elements.work(list(modes), forces, readings)
    by_elements = np.sum(np.array(list(modes.values()))[:, None, None] * work, axis=0)
    node, weight = _gauss(_OUTER_NODES * (1 + math.ceil(count / 8)))
    if outline.symmetric:  # the other half is its mirror image
        by_elements *= 2.0
        weight = np.where(node > 0.0, 2.0, node == 0.0)[node >= 0.0] * weight[node >= 0.0]
        node = node[node >= 0.0]
    y = half_length * node
    points, weights = np.array([_points(place, half_length) for place in y]).transpose(1, 0, 2)
    # Waves around scale with the local radius of the surface.
    radius = np.sqrt(outline.girths(y)[:, None] * outline.girths(points))
    effect = _subtract_modes(modes, poisson, outline, y, points, radius) * (weights / radius)
    loads = polynomials(points.ravel()).reshape(*points.shape, -1)
    flat = (polynomials(y) * (half_length * weight)[:, None]).T @ np.einsum("ix,ixm->im", effect, loads)
    matrix: Array = by_elements + 0.5 * (flat + flat.T)
    if outline.symmetric:
        matrix[np.add.outer(order, order) % 2.0 == 1.0] = 0.0
    return matrix


def _subtract_modes(
    modes: dict[int, float], poisson: float, outline: Outline, y: Array, points: Array, radius: Array
) -> Array:
    """Return all modes of a flat body minus their integral, minus the flat and curved part of some modes.

    Parameters
    ----------
    modes : dict
        Those modes and their weights.
    poisson : float
        Poisson's ratio.
    outline : Outline
        A section through the axis.
    y : ndarray, shape (places,)
        Places [radii].
    points : ndarray, shape (places, points)
        Points over which the effect on each place is integrated [radii].
    radius : ndarray, shape (places, points)
        Radius of the surface between place and point.

    Returns
    -------
    ndarray, shape (places, points)
    """
    free, weights = free_face(poisson), 1.0 + IN_SPACE * np.array([corner_weights(a) for a in outline.corner_angles])
    of_image, of_face = np.ascontiguousarray(weights[::-1].T)
    added = free.weights.reshape(len(free.weights), -1)
    tables = _tables(tuple((n, weight) for n, weight in modes.items() if n), poisson)
    return core.flat_modes(
        *tables, added, free.distances, of_image, of_face, outline.half_length, y, np.ascontiguousarray(points), radius
    )


@lru_cache(16)
def _tables(
    waves: tuple[tuple[int, float], ...], poisson: float
) -> tuple[core.LogarithmicTable, core.LogarithmicTable, core.LogarithmicTable]:
    """Return the sums over all modes minus some, for loads and for pressures on a half-plane, and their curved part."""
    # Imported here, because most contacts need none of this.
    from scipy import special

    along, decay, slope = curved_factors(poisson)
    return (
        _tabulate(lambda s: sum_over_images(s) - sum(2.0 * w * special.k0(n * s) for n, w in waves)),
        _tabulate(lambda s: sum_over_planes(s) - sum(w * np.exp(-n * s) for n, w in waves)),
        _tabulate(
            lambda s: (
                along * np.exp(-s) + 0.5 * math.pi * sum(w * np.exp(-n * s) * (decay / n - slope * s) for n, w in waves)
            )
        ),
    )


def _tabulate(function: Callable[[Array], Array]) -> core.LogarithmicTable:
    """Return a function of a distance as cubic polynomials in its logarithm, linear in it below the first."""
    from scipy.interpolate import CubicSpline

    first, last = math.log(_NEAREST), math.log(_FAR)
    at, step = np.linspace(first, last, _DISTANCES, retstep=True)
    return core.LogarithmicTable(first, float(step), np.ascontiguousarray(CubicSpline(at, function(np.exp(at))).c.T))


def _points(place: float, half_length: float) -> tuple[Array, Array]:
    """Return points along a roller, denser towards a place and both ends, and their weights."""
    node, weight = _gauss(_NODES)
    halved = np.concatenate([[0.0], 2.0 ** np.arange(1.0 - _PANELS, 1.0)])
    part = 0.5 * (halved[1:] + halved[:-1])[:, None] + 0.5 * np.diff(halved)[:, None] * node
    share = 0.5 * np.diff(halved)[:, None] * weight
    points, weights = [], []
    for end in (-half_length, half_length):
        half = 0.5 * (place - end)  # from the end to the place, in two parts
        points += [end + half * part, place - half * part]
        weights += [abs(half) * share] * 2
    return np.concatenate(points).ravel(), np.concatenate(weights).ravel()


def sum_over_images(distance: Array) -> Array:
    """Return the sum of 2 K0(n s) over even modes except the first, minus the integral over n; times 2 / pi."""
    from scipy import special

    x = _SPACING * distance
    total, near = np.empty_like(x), x <= _BY_SERIES
    small, large = x[near], x[~near]
    series, factor = np.zeros_like(small), 1.0
    for k, zeta in enumerate(_ZETA, start=1):
        factor *= -(2 * k - 1) / (2 * k)
        series += factor * zeta * small ** (2 * k) / (2.0 * math.pi) ** (2 * k + 1)
    total[near] = np.euler_gamma + np.log(small / (4.0 * math.pi)) + 2.0 * math.pi * series
    total[~near] = sum((2.0 * special.k0(j * large) for j in range(1, _REFLECTIONS)), -math.pi / large)
    return _SPACING / math.pi * total


def sum_over_planes(distance: Array) -> Array:
    """Return the same for exp(-n s)."""
    x = _SPACING * distance
    at_least = np.clip(x, 1e-3, 700.0)
    total: Array = np.where(x < 1e-2, -0.5 + x / 12.0 - x**3 / 720.0, 1.0 / np.expm1(at_least) - 1.0 / at_least)
    return _SPACING / math.pi * total
