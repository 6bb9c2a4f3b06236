"""Stress in a hollow roller in excess of that of two flat bodies: the bending of its wall, by low modes.

Around a roller under the same load on two opposite sides, stress is a sum over even n of cos(n theta) and sin(n
theta). Two half-spaces with their images, one under each of the two loads, give the stress near the contacts; mode n of
their sum on circles about the axis is wrong for low n, for which the wall bends. For n up to N, the mode of the
half-spaces is therefore replaced by that of the whole roller from finite elements. No contribution is counted twice,
whatever the half-spaces are. For a solid disc in two dimensions the added stress reduces to q / (pi R) in n = 0. Waves
above N reach no deeper than a sixth of the wall, where they agree with those of the half-space.

Modes are stored for Legendre polynomials of the load along the axis, at Chebyshev points through the wall and along the
axis. Both are for line loads; the width of a contact is a factor on each mode's load. The modes of a point load on a
half-space depend only on the distance along the axis, so one table for each circle serves all loads. The outermost
circle lies just below the surface; the polynomials are extrapolated to the surface.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.harmonic_elements import HarmonicElements
from nonhertz.bodies.stored import cache_on_disk
from nonhertz.model.body import Body
from nonhertz.model.outline import Outline
from nonhertz.native import core

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]

_MODES, _WALLS = 24, 6.0  # waves around: at least, and for each radius over the wall
_TERMS, _TERMS_PER_LENGTH = 12.0, 6.0  # polynomials of the load: for a short roller, and for each half-length
_FINE = 66  # waves around for which elements at the edges are small enough
_THROUGH, _THROUGH_PER_WALL = 6, 5.0  # points through the wall: for a thin one, and for each radius
_ALONG = 13  # points along the axis, at least
TOP = 0.97  # the outermost circle, as a fraction of the wall
_ANGLES, _DISTANCES = 64, 121  # of tables of point loads: on a quarter of a circle without waves, and along
_LOADS, _WAVES_PER_PANEL = 12, 5  # points of a panel of loads along the axis, which has as many half-waves
# Components: rr, tt, yy and r theta, r y, theta y; all except r theta and theta y vary as cos(n theta).
_EVEN = np.array([True, True, True, False, True, False])
_ODD = np.array([1.0, 1.0, 1.0, 1.0, -1.0, -1.0])  # their signs at the mirrored position along the axis
_gauss = cache(legendre.leggauss)


@dataclass(frozen=True)
class WallModes:
    """The modes of one outline, in radii of its surface, and one material.

    Attributes
    ----------
    outline : Outline
        A section through its axis.
    factors : ndarray, shape (waves, through, along, 6, terms)
        Chebyshev coefficients, through the wall and along the axis, of the stress of each mode under each polynomial.
    """

    outline: Outline
    factors: Array

    @property
    def waves(self) -> Array:
        """Numbers of waves around."""
        counts: Array = np.arange(0.0, 2.0 * len(self.factors), 2.0)
        return counts

    def stress(self, loads: Array) -> Array:
        """Return Chebyshev coefficients of the stress of each mode, shape (waves, 6, through, along).

        Parameters
        ----------
        loads : ndarray, shape (waves, terms)
            Integrals of the load of each mode times the polynomials.
        """
        coefficients: Array = np.einsum("nrysm,nm->nsry", self.factors, loads)
        return coefficients

    def of_field(self, field: Callable[[Array], Array]) -> Array:
        """Return the same coefficients for a field plus the same field from the opposite side.

        Parameters
        ----------
        field : callable
            Points (n, 3), across, along from the middle, and below the surface [radii] -> six stresses, shape (n, 6).
        """
        waves, through, along = np.rint(self.waves).astype(int), *self.factors.shape[1:3]
        shares, places = _circles(through, along, self.outline.half_length)
        outer, inner = self.outline.radii(places)
        samples = np.empty((waves.size, through, along, 6))
        for i, share in enumerate(shares):
            for j, y in enumerate(places):
                radius = inner[j] + share * (outer[j] - inner[j])
                theta, around = _quarter(outer[j] - radius, waves)
                x, z = radius * np.sin(theta), outer[j] - radius * np.cos(theta)
                near = np.column_stack([x, np.full(x.size, y), z])
                far = np.column_stack([-x, near[:, 1], 2.0 * outer[j] - z])
                samples[:, i, j] = np.einsum("snt,ts->ns", around, _polar(field(near) + OPPOSITE * field(far), theta))
        radial, axial = _to_chebyshev(through), _to_chebyshev(along)
        coefficients: Array = np.einsum("ir,jy,nrys->nsij", radial, axial, samples, optimize=True)
        return coefficients

    def polynomials(self, z: Array) -> Array:
        """Return the polynomials of the load at places from the middle [radii], shape (..., terms)."""
        return _polynomials(self.outline.half_length, self.factors.shape[-1], z)


def bending_of(body: Body) -> tuple[WallModes, float] | None:
    """Return the modes of the stress in a hollow roller, and the radius that is their unit [mm].

    None if it is not hollow, or if its bore has steps, for which modes are not computed.
    """
    if body.bore is None:
        return None
    outline, radius = body.outline
    if outline.kinks or min(outline.inner) <= 0.0:
        return None
    return WallModes(outline, _factors(outline, body.material.poisson)), radius


def _polynomials(half_length: float, count: int, z: Array) -> Array:
    norms = np.sqrt((2.0 * np.arange(count) + 1.0) / (2.0 * half_length))
    values: Array = legendre.legvander(z / half_length, count - 1) * norms
    return values


def _chebyshev_points(count: int) -> Array:
    """Return the extrema of a Chebyshev polynomial and both ends, from -1 to 1."""
    points: Array = -np.cos(np.pi * np.arange(count) / (count - 1))
    return points


def _to_chebyshev(count: int) -> Array:
    """Return the matrix from values at as many points to Chebyshev coefficients."""
    return np.asarray(np.linalg.inv(chebyshev.chebvander(_chebyshev_points(count), count - 1)), dtype=np.float64)


def _circles(through: int, along: int, half_length: float) -> tuple[Array, Array]:
    """Return the fractions of the wall and an odd number of axial places [radii] of the circles for modes."""
    places = half_length * _chebyshev_points(along)
    places[along // 2] = 0.0
    return 0.5 * TOP * (1.0 + _chebyshev_points(through)), places


@cache_on_disk(__name__, "nonhertz.bodies.harmonic_elements", "nonhertz.model.outline", core.__name__)
def _factors(outline: Outline, poisson: float) -> Array:
    """Return the factors of `WallModes`."""
    half_length = outline.half_length
    most = max(_MODES, 2 * math.ceil(0.5 * _WALLS / outline.wall))
    count = math.ceil(_TERMS + _TERMS_PER_LENGTH * half_length / math.sqrt(outline.wall))
    waves = np.arange(0, most + 1, 2)
    through, along = _THROUGH + math.ceil(_THROUGH_PER_WALL * outline.wall), max(_ALONG, count // 2 | 1)
    shares, places = _circles(through, along, half_length)
    lower = places.size // 2 if outline.symmetric else 0  # mirror images of the others
    elements = HarmonicElements(outline, poisson, max(most, _FINE))
    forces = elements.forces(lambda z: _polynomials(half_length, count, z))
    stresses = np.stack(
        [elements.stress(n, elements.displaced(n, forces), shares, places[lower:]) for n in waves.tolist()]
    )
    stresses *= np.where(waves > 0, 2.0, 1.0)[:, None, None, None, None] / np.pi
    stresses -= _of_half_spaces(outline, poisson, waves, shares, places[lower:], count)
    turned = np.where(np.arange(count) % 2 == 1, -1.0, 1.0) * _ODD[:, None]
    stresses = np.concatenate([stresses[:, :, : -lower - 1 : -1] * turned, stresses], axis=2)
    radial, axial = _to_chebyshev(through), _to_chebyshev(along)
    factors: Array = np.einsum("ir,jy,nrysm->nijsm", radial, axial, stresses, optimize=True)
    return factors


def _of_half_spaces(
    outline: Outline, poisson: float, waves: NDArray[np.int64], shares: Array, places: Array, count: int
) -> Array:
    """Return the modes of both half-spaces and their images on circles, shape (waves, shares, places, 6, terms)."""
    half_length = outline.half_length
    outer, inner = outline.radii(places)
    stresses = np.empty((waves.size, shares.size, places.size, 6, count))
    for i, share in enumerate(shares):
        last = None
        for j, y in enumerate(places):
            if last != (last := (outer[j], inner[j] + share * (outer[j] - inner[j]))):
                scale = last[0] - last[1]
                table = _point_loads(*last, poisson, waves, 4.0 * half_length)
            sources, weight = _around(y, scale, half_length, count)
            mirrored = 2.0 * np.clip(sources, -half_length, half_length) - sources
            load = _polynomials(half_length, count, mirrored) * weight[:, None]
            distance = y - sources
            seen = table(np.arcsinh(np.abs(distance) / scale)) * np.where(distance[:, None, None] < 0.0, _ODD, 1.0)
            stresses[:, i, j] = np.tensordot(seen, load, (0, 0))
    return stresses


def _around(y: float, scale: float, half_length: float, count: int) -> tuple[Array, Array]:
    """Return nodes and weights for polynomials on the roller and its two images, about a point at a distance `scale`.

    Panels double with the distance from y and are no longer than a few waves of the last polynomial, which shorten
    towards the ends like those of a cosine.
    """
    waves = -half_length * np.cos(np.linspace(0.0, np.pi, 1 + math.ceil(count / _WAVES_PER_PANEL)))
    steps = scale * 2.0 ** np.arange(1 + math.ceil(math.log2(4.0 * half_length / scale)))
    borders = np.concatenate([waves - 2.0 * half_length, waves, waves + 2.0 * half_length, y - steps, [y], y + steps])
    borders = np.unique(borders[np.abs(borders) <= 3.0 * half_length])
    node, weight = _gauss(_LOADS)
    half = 0.5 * np.diff(borders)[:, None]
    return (borders[:-1, None] + half * (1.0 + node)).ravel(), (half * weight).ravel()


def _point_loads(
    surface: float, radius: float, poisson: float, waves: NDArray[np.int64], farthest: float
) -> CubicSpline:
    """Return the modes on a circle of two opposite point loads over arsinh of the distance along in depths."""
    from scipy.interpolate import CubicSpline

    depth = surface - radius
    theta, around = _quarter(depth, waves)
    x, z = radius * np.sin(theta)[:, None], surface - radius * np.cos(theta)[:, None]
    at = np.linspace(0.0, np.arcsinh(farthest / depth), _DISTANCES)
    y = depth * np.sinh(at)
    near = _point_load(x, y, z, poisson)
    far = _point_load(-x, y, 2.0 * surface - z, poisson) * OPPOSITE
    return CubicSpline(at, np.einsum("snt,tds->dns", around, _polar(near + far, theta[:, None]), optimize=True))


def _quarter(depth: float, waves: NDArray[np.int64]) -> tuple[Array, Array]:
    """Return angles on a quarter of a circle, denser towards the load, and the matrices from polar stresses to modes.

    Parameters
    ----------
    depth : float
        Depth of the circle below the surface [radii].
    waves : ndarray, shape (waves,)
        Even numbers of waves around; the other quarters follow by symmetry.

    Returns
    -------
    tuple of ndarray, shape (angles,) and (6, waves, angles)
    """
    node, weight = _gauss(_ANGLES + 2 * int(waves[-1]))
    end = 0.5 * np.arcsinh(0.5 * np.pi / depth)
    theta, share = depth * np.sinh(end * (1.0 + node)), depth * np.cosh(end * (1.0 + node)) * end * weight
    turns = waves[:, None] * theta
    factor = np.where(waves > 0, 4.0, 2.0)[:, None] / np.pi * share
    return theta, factor * np.where(_EVEN[:, None, None], np.cos(turns), np.sin(turns))


#: Signs of sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy of the same stress seen from the opposite side.
OPPOSITE = np.array([1.0, 1.0, 1.0, -1.0, 1.0, -1.0])


def _point_load(x: Array, y: Array, z: Array, poisson: float) -> Array:
    """Return the six stresses of Boussinesq's point load on a half-space, shape (..., 6)."""
    lateral, R = 1.0 - 2.0 * poisson, np.sqrt(x * x + y * y + z * z)
    # (1 - z / R) / r^2 and (2 g - z / R^3) / r^2, r^2 = x^2 + y^2, in a form that also holds directly below the load.
    g, w = 1.0 / (R * (R + z)), (2.0 * R + z) / (R**3 * (R + z) ** 2)
    fifth = 3.0 * z / R**5
    stress: Array = np.stack([
        lateral * (g - w * y * y) - fifth * x * x, lateral * (g - w * x * x) - fifth * y * y, -fifth * z * z,
        -fifth * y * z, -fifth * x * z, (lateral * w - fifth) * x * y,
    ], axis=-1) / (2.0 * np.pi)  # fmt: skip
    return stress


def _polar(stress: Array, theta: Array) -> Array:
    """Return rr, tt, yy, rt, ry, ty at an angle from the load, from stresses in the contact's axes, shape (..., 6)."""
    sine, cosine = np.sin(theta), np.cos(theta)
    xx, yy, zz, yz, xz, xy = np.moveaxis(stress, -1, 0)
    both = 2.0 * xz * sine * cosine
    polar: Array = np.stack([
        xx * sine**2 - both + zz * cosine**2, xx * cosine**2 + both + zz * sine**2, yy,
        (xx - zz) * sine * cosine + xz * (sine**2 - cosine**2), xy * sine - yz * cosine, xy * cosine + yz * sine,
    ], axis=-1)  # fmt: skip
    return polar
