"""A solid cylinder of infinite length under the same line load on two opposite sides.

Its displacement is that of a flat body, K P / s at a distance s along the axis from a load P, plus K P g(s / R) / R.
g is the transform of D(k), the difference between the modes cos(n theta) cos(k y) of a cylinder, n = 0, 2, 4 ..., and
those of a half-space. Its modes follow from the potentials of Papkovich and Neuber, with modified Bessel functions
I_n(k r). Displacement is measured against the axis, and the cylinder is free to extend.

The stored function is H(s), the integral of g(s) + 1 / sqrt(1 + s^2) from 0 to s, s in radii. Far away 1 / s + g
vanishes.
"""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.native import core

Array = NDArray[np.float64]

FARTHEST = 12.0  # radii; where 1 / s + g is below 1e-9
_MODES = 240  # for wave numbers up to the last of
_BANDS = (0.0, 0.25, 1.0, 4.0, 16.0, 48.0)
_DEGREE = 24
_PANELS, _NODES = 100, 12  # of the transform
_PLACES = 400


@lru_cache(MOST)
def smooth_part(poisson: float) -> core.Cubics:
    """Return H as a function of s, 0 <= s <= `FARTHEST`, by a cubic spline."""
    # Imported here, because most contacts need none of this.
    from scipy.interpolate import CubicSpline

    spline = CubicSpline(_places(), _table(poisson))
    return core.Cubics(spline.x, np.ascontiguousarray(spline.c.T))


def _places() -> Array:
    # Denser towards 0, where H behaves as s ln s.
    return FARTHEST * np.linspace(0.0, 1.0, _PLACES) ** 3


@cache_on_disk(__name__)
def _table(poisson: float) -> Array:
    """Return H at the places of the spline."""
    # Imported here, because most contacts need none of this.
    from scipy import special

    node, weight = legendre.leggauss(_NODES)
    borders = np.linspace(0.0, _BANDS[-1], _PANELS + 1)
    half = 0.5 * np.diff(borders)[:, None]
    k, share = (borders[:-1, None] + half * (1.0 + node)).ravel(), (half * weight).ravel()
    s, last = _places()[:, None], _BANDS[-1]
    table = 2.0 * (np.sin(k * s) / k) @ (share * _transform(k, poisson))
    # Beyond the last wave number the transform falls as 1 / k.
    with np.errstate(divide="ignore", invalid="ignore"):
        tail = np.sin(last * s) / last - s * special.sici(last * s)[1]
    tail[0] = 0.0
    table += 2.0 * last * difference_spectrum(np.array([last]), poisson) * tail[:, 0]
    return np.asarray(table)


def _transform(k: Array, poisson: float) -> Array:
    """Return D(k) + K0(k) / pi, whose transform is g(s) + 1 / sqrt(1 + s^2); smooth: polynomials in bands of k."""
    transform = np.empty_like(k)
    # Imported here, because most contacts need none of this.
    from scipy import special

    points = chebyshev.chebpts1(_DEGREE + 1)
    for low, high in itertools.pairwise(_BANDS):
        at = 0.5 * (low + high) + 0.5 * (high - low) * points
        values = difference_spectrum(at, poisson) + special.k0(at) / math.pi
        fit = chebyshev.chebfit(points, values, _DEGREE)
        these = (k >= low) & (k <= high)
        transform[these] = chebyshev.chebval((2.0 * k[these] - low - high) / (high - low), fit)
    return transform


def difference_spectrum(k: Array, poisson: float) -> Array:
    """Return D(k): the sum over modes of a cylinder minus that of a half-space."""
    c = modes(k, _MODES, poisson)
    n = np.arange(2, _MODES + 1, 2)[:, None]
    terms = 2.0 * c[1:] - (np.arcsinh((n + 1) / k) - np.arcsinh((n - 1) / k))
    sums = c[0] - np.arcsinh(1.0 / k) + np.cumsum(terms, axis=0)
    # The remainder after n is a series in 1 / (n + 1): extrapolated from three sums.
    at = np.array([_MODES // 4, _MODES // 2, _MODES]) // 2 - 1
    inverse = 1.0 / (2.0 * at + 3.0)
    weights = np.linalg.solve(np.vander(inverse, increasing=True).T, [1.0, 0.0, 0.0])
    return np.asarray(weights @ sums[at]) / math.pi


def modes(k: Array, most: int, poisson: float) -> Array:
    """Return c_n(k), n = 0, 2 ... ``most``: radial displacement by a pressure cos(n theta) cos(k y), over 2 pi K.

    Parameters
    ----------
    k : ndarray, shape (m,)
        Wave numbers along the axis, over the radius; positive.
    most : int
        The last n.
    poisson : float
        Poisson's ratio.

    Returns
    -------
    ndarray, shape (most / 2 + 1, m)
        For large n or k, 1 / sqrt(n^2 + k^2).
    """
    ratios = _ratios(k, most)
    return np.array([_mode(n, k, ratios[n], poisson) for n in range(0, most + 1, 2)])


def _ratios(k: Array, most: int) -> dict[int, Array]:
    """Return I_(n+1)(k) / I_n(k) for even n, downwards from where it no longer matters."""
    ratios, ratio = {}, np.zeros_like(k)
    for n in range(most + 60 + int(2.0 * k.max()), -1, -1):
        ratio = 1.0 / (2.0 * (n + 1) / k + ratio)
        ratios[n] = ratio
    return ratios


def _mode(n: int, k: Array, ratio: Array, poisson: float) -> Array:
    """Return c_n from potentials B and beta on the surface: three unknowns and three stresses, over I_n(k)."""
    one, none = np.ones_like(k), np.zeros_like(k)
    above, below = ratio, ratio + 2.0 * n / k  # I_(n+1) and I_(n-1)
    # Values, first and second derivatives by r.
    of_n = (one, k * ratio + n, k * k + n * n - (k * ratio + n))
    d_above = k - (n + 1) * above
    of_above = (above, d_above, (k * k + (n + 1) ** 2) * above - d_above)
    d_below = k + (n - 1) * below
    of_below = (below, d_below, (k * k + (n - 1) ** 2) * below - d_below)
    zero = (none, none, none)
    # Each as coefficients of (B_r, B_theta, beta).
    potentials = [(of_above, of_above, zero), (zero, zero, of_n)]
    if n:
        potentials.insert(1, (of_below, (-of_below[0], -of_below[1], none), zero))
    stresses, motions = zip(*(_on_surface(n, k, potential, poisson) for potential in potentials), strict=True)
    components = (0, 1, 2) if n else (0, 2)  # no shear around the axis for n = 0
    matrix = np.array([[stress[i] for stress in stresses] for i in components]).transpose(2, 0, 1)
    load = np.zeros((k.size, len(components), 1))
    load[:, 0] = -1.0
    amplitudes = np.linalg.solve(matrix, load)[..., 0]
    moved: Array = np.sum(amplitudes * np.array(motions).T, axis=1)
    return -moved / (2.0 * (1.0 - poisson))


def _on_surface(n: int, k: Array, potential: Any, poisson: float) -> tuple[tuple[Array, Array, Array], Array]:
    """Return the stresses rr, r theta and ry, and 2 mu u_r, at r = 1."""
    (b_r, d_b_r, d2_b_r), (b_t, d_b_t, _), (beta, d_beta, d2_beta) = potential
    if n == 0:
        b_t, d_b_t = np.zeros_like(k), np.zeros_like(k)
    psi, d_psi, d2_psi = b_r + beta, b_r + d_b_r + d_beta, 2.0 * d_b_r + d2_b_r + d2_beta
    factor = 4.0 * (1.0 - poisson)
    radial, d_radial = factor * b_r - d_psi, factor * d_b_r - d2_psi
    around, d_around = factor * b_t + n * psi, factor * d_b_t + n * (d_psi - psi)
    stress = d_radial + 2.0 * poisson * (d_b_r + b_r + n * b_t)
    return (stress, 0.5 * (d_around - around - n * radial), 0.5 * k * (d_psi - radial)), radial
