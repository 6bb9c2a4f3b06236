"""What makes a flat body with free ends a whole roller: the difference, which is smooth at the scale of the radius.

A roller, solid or bored, is pressed on two opposite sides by the same load along its length. The pressure around it is
a sum of cos(n theta), n even, and each of these modes moves the surface in its own way. Near the contact, modes of high
n move it as waves of the wave number n / R do on a flat body with the same free ends, which is what strips and their
images are made of. So a whole roller is the flat body, plus the sum over n of that difference, plus what a sum over n
differs from the integral over all wave numbers. All of this hardly depends on how wide the contact is. For low n it is
found by finite elements; for high n the difference is local, (n - beta) / (n^2 - 1) in place of 1 / n in plane strain,
with beta = (1 - 2 nu) / (2 (1 - nu)). Sums over n of the flat body's functions have closed forms (Gradshteyn & Ryzhik
8.526).

A bore is felt by waves that reach through the wall, which are among the low n. Where the diameter varies, n / R is
taken with the geometric mean of R at both ends of a distance.

The difference is kept as a matrix between Legendre polynomials along the axis. Displacement is measured against the
roller's axis, and the load on the opposite side is in. The roller is free to grow longer.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.harmonic_elements import HarmonicElements
from nonhertz.bodies.outline import Outline
from nonhertz.bodies.quarter_space import FreeFace, free_face
from nonhertz.bodies.stored import stored
from nonhertz.compiled import compiled, entry

Array = NDArray[np.float64]

SHORTEST, LONGEST = 0.1, 10.0  # length over diameter
_MODES, _WALLS = 24, 6.0  # waves around, at least and times the wall, that need finite elements
_FEWEST_TERMS, _TERMS_PER_RADIUS = 9, 5  # polynomials along the axis
_STEP, _DIGITS = 0.004, 9  # between half-lengths of which others are interpolated [radii]; their digits
_interpolating: ContextVar[bool] = ContextVar("interpolating", default=False)
_PANELS, _NODES = 18, 8  # halvings towards logarithms, and nodes on each panel
# Half-width over radius for which the local part of high modes is exact. Up to twice that it leaves 0.2 % of the
# compression for any Poisson's ratio.
_USUAL_WIDTH = 0.03
_LAST_MODE = 4000
_SPACING = 2.0  # of the wave numbers of even modes, times the radius
_BY_SERIES, _REFLECTIONS = 2.5, 9  # beyond that by this many terms, of 1e-9 and less
_ZETA = (1.2020569031595942, 1.0369277551433699, 1.0083492773819228, 1.0020083928260822, 1.0004941886041195,
         1.0001227133475785, 1.0000305882363070, 1.0000076371976379)  # of 3, 5, 7 ...  # fmt: skip


@dataclass(frozen=True)
class WholeRoller:
    """The smooth part of the displacement of a whole roller.

    Attributes
    ----------
    half_length : float
        Half the length [radii].
    matrix : ndarray, shape (m, m)
        Between normalised Legendre polynomials: displacement over K times the load per length, of a radius of 1.
    """

    half_length: float
    matrix: Array

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return the smooth part at ``y`` under a unit load between neighbouring edges.

        Parameters
        ----------
        y : ndarray, shape (..., places)
            Distances from the middle [radii].
        edges : ndarray, shape (..., strips + 1)
            The same of edges.

        Returns
        -------
        ndarray, shape (..., places, strips)
        """
        shape = (*y.shape, edges.shape[-1] - 1)
        places, ends = (np.ascontiguousarray(each).reshape(-1, each.shape[-1]) for each in (y, edges))
        found = np.empty((len(places), *shape[-2:]))
        _displaced(places, ends, self.half_length, self.matrix, found)
        return found.reshape(shape)


@entry
def _displaced(y: Array, edges: Array, half_length: float, matrix: Array, out: Array) -> None:
    """Fill in the displacement of each place by a unit load between neighbouring edges, from Legendre polynomials."""
    count = matrix.shape[0]
    of_edges = np.empty((edges.shape[1], count))
    values = np.empty(count + 1)
    at, moved = np.empty(count), np.empty(count)
    for row in range(y.shape[0]):
        for e in range(edges.shape[1]):
            _polynomials(edges[row, e] / half_length, values)
            # The integral of P_j is (P_(j+1) - P_(j-1)) / (2 j + 1).
            of_edges[e, 0] = values[1]
            for j in range(1, count):
                of_edges[e, j] = (values[j + 1] - values[j - 1]) / (2.0 * j + 1.0)
            for j in range(count):
                of_edges[e, j] *= math.sqrt((j + 0.5) * half_length)
        for i in range(y.shape[1]):
            _polynomials(y[row, i] / half_length, values)
            for j in range(count):
                at[j] = values[j] * math.sqrt((j + 0.5) / half_length)
                moved[j] = 0.0
            for j in range(count):
                for k in range(count):
                    moved[k] += at[j] * matrix[j, k]
            before = 0.0
            for e in range(edges.shape[1]):
                total = 0.0
                for k in range(count):
                    total += moved[k] * of_edges[e, k]
                if e > 0:
                    out[row, i, e - 1] = total - before
                before = total


@compiled
def _polynomials(x: float, out: Array) -> None:
    """Fill in the Legendre polynomials at x, brought to between -1 and 1."""
    x = min(max(x, -1.0), 1.0)
    out[0] = 1.0
    out[1] = x
    for j in range(1, out.size - 1):
        out[j + 1] = ((2.0 * j + 1.0) * x * out[j] - j * out[j - 1]) / (j + 1.0)


def _norms(count: int, half_length: float) -> Array:
    norms: Array = np.sqrt((2.0 * np.arange(count) + 1.0) / (2.0 * half_length))
    return norms


def whole_roller(outline: Outline, poisson: float) -> WholeRoller:
    """Return the smooth part for an outline, in a radius of the surface, and a material."""
    half_length = outline.half_length
    if _interpolating.get() and outline == Outline.cylinder(half_length):
        return WholeRoller(half_length, _between_shapes(half_length, poisson))
    return WholeRoller(half_length, _matrix(outline, poisson))


@contextlib.contextmanager
def interpolated_shapes() -> Iterator[None]:
    """Interpolate between solid cylinders of fixed lengths, in a ``with`` block: for thousands of different ones.

    A new shape takes a third of a second. What is interpolated between three of the fixed ones is within 1e-6 of what
    it is for the shape itself; for a length of a tenth of the diameter, within 2e-5.
    """
    token = _interpolating.set(True)
    try:
        yield
    finally:
        _interpolating.reset(token)


def _between_shapes(half_length: float, poisson: float) -> Array:
    """Return the matrix of a solid cylinder, by a parabola through those of three lengths close to its own."""
    terms = _terms(half_length, 1.0)
    nearest = round(half_length / _STEP)
    # The three have as many polynomials as the cylinder itself.
    around = (round(step * _STEP, _DIGITS) for step in range(nearest - 3, nearest + 4))
    alike = [length for length in around if _terms(length, 1.0) == terms]
    lengths = sorted(alike, key=lambda length: abs(length - half_length))[:3]
    total = np.zeros((terms, terms))
    for one in lengths:
        weight = math.prod((half_length - other) / (one - other) for other in lengths if other != one)
        total += weight * _matrix(Outline.cylinder(one), poisson)
    return total


def _terms(half_length: float, wall: float) -> int:
    """Return the number of polynomials along the axis."""
    return math.ceil(_FEWEST_TERMS + _TERMS_PER_RADIUS * half_length / math.sqrt(min(1.0, wall)))


@stored(__name__, "nonhertz.bodies.harmonic_elements", "nonhertz.bodies.outline", "nonhertz.bodies.quarter_space")
def _matrix(outline: Outline, poisson: float) -> Array:
    """Return the matrix of `WholeRoller`."""
    half_length = outline.half_length
    count = _terms(half_length, outline.wall)
    node, weight = legendre.leggauss(count + 6)
    if outline.symmetric:  # the other half does the same
        weight = np.where(node > 0.0, 2.0, node == 0.0)[node >= 0.0] * weight[node >= 0.0]
        node = node[node >= 0.0]
    grid = _Grid.of(half_length * node, outline, count, free_face(poisson))
    most = _most_waves(outline)
    total = _modes(grid, outline, poisson, most)
    total += grid.moved(_sum_over_images, _sum_over_planes) + grid.moved(*_flat(1.0)) / math.pi
    total += _local(poisson, most) * grid.at_places
    matrix = (grid.at_places * (half_length * weight)[:, None]).T @ total
    matrix = 0.5 * (matrix + matrix.T)
    if outline.symmetric:
        matrix[np.add.outer(np.arange(count), np.arange(count)) % 2 == 1] = 0.0
    return matrix


def _most_waves(outline: Outline) -> int:
    """Return the waves around up to which finite elements are needed: shorter ones do not reach through the wall."""
    return max(_MODES, 2 * math.ceil(0.5 * _WALLS / outline.wall))


@dataclass(frozen=True)
class _Grid:
    """Places, and points from which what acts on them is integrated, closer to each other towards logarithms.

    Attributes
    ----------
    y : ndarray, shape (places,)
        Places [radii].
    at_places : ndarray, shape (places, m)
        The polynomials there.
    loads : ndarray, shape (places, points, m)
        The polynomials at the points, times the points' weights, over the surface's radius.
    direct : ndarray, shape (places, points)
        Distances, over the surface's radius.
    image : ndarray, shape (2, places, points)
        Those of the images about both faces.
    face : ndarray, shape (2, places, points, 2, k)
        Weights of what both free faces add.
    distances : ndarray, shape (k,)
        Its distances, over that of the image.
    """

    y: Array
    at_places: Array
    loads: Array
    direct: Array
    image: Array
    face: Array
    distances: Array

    @classmethod
    def of(cls, y: Array, outline: Outline, count: int, free: FreeFace) -> _Grid:
        """Return those for some places."""
        half_length = outline.half_length
        points, weights = np.array([_points(place, half_length) for place in y]).transpose(1, 0, 2)
        norm = _norms(count, half_length)
        # Waves around are as long as the surface is wide.
        (at_y, _), (at_points, _) = outline.radii(y), outline.radii(points)
        radius = np.sqrt(at_y[:, None] * at_points)
        loads = legendre.legvander(points / half_length, count - 1) * norm * (weights / radius)[..., None]
        of_places = half_length - y[:, None] * np.array([1.0, -1.0])[:, None, None]
        of_points = half_length - points * np.array([1.0, -1.0])[:, None, None]
        u, v = np.broadcast_to(of_places, of_points.shape), np.maximum(of_points, np.finfo(float).tiny)
        direct = np.maximum(np.abs(points - y[:, None]), np.finfo(float).tiny)
        at_places = legendre.legvander(y / half_length, count - 1) * norm
        return cls(y, at_places, loads, direct / radius, (u + v) / radius, free.towards(u, v), free.distances)

    def moved(self, of_images: Callable[[Array], Array], of_planes: Callable[[Array], Array]) -> Array:
        """Return what the polynomials as loads do by direct effect, images and free faces, shape (places, m).

        ``of_images`` is the effect of a load at a distance, ``of_planes`` that of a pressure of a half-plane.
        """
        effect = of_images(self.direct) + of_images(self.image).sum(axis=0)
        for k, distance in enumerate(self.distances):
            at = distance * self.image
            effect += np.sum(self.face[..., 0, k] * of_images(at) + self.face[..., 1, k] * of_planes(at), axis=0)
        found: Array = np.einsum("ix,ixm->im", effect, self.loads)
        return found


def _points(place: float, half_length: float) -> tuple[Array, Array]:
    """Return points on the length of a roller, denser towards a place and both ends, and their weights."""
    node, weight = legendre.leggauss(_NODES)
    halved = np.concatenate([[0.0], 2.0 ** np.arange(1.0 - _PANELS, 1.0)])
    part = 0.5 * (halved[1:] + halved[:-1])[:, None] + 0.5 * np.diff(halved)[:, None] * node
    share = 0.5 * np.diff(halved)[:, None] * weight
    points, weights = [], []
    for end in (-half_length, half_length):
        half = 0.5 * (place - end)  # from the end to the place, in two parts
        points += [end + half * part, place - half * part]
        weights += [abs(half) * share] * 2
    return np.concatenate(points).ravel(), np.concatenate(weights).ravel()


def _flat(wave_number: float) -> tuple[Callable[[Array], Array], Callable[[Array], Array]]:
    """Return the effects of loads that vary as cos(k x) on a flat body."""
    # Imported here, because most contacts need none of this.
    from scipy import special

    return (lambda s: 2.0 * special.k0(wave_number * s)), (lambda s: np.exp(-wave_number * s))


def _modes(grid: _Grid, outline: Outline, poisson: float, most: int) -> Array:
    """Return what low modes move the surface by, less the flat body's, shape (places, m)."""
    half_length, count = outline.half_length, grid.loads.shape[2]
    elements, norm = HarmonicElements(outline, poisson, most), _norms(count, half_length)

    def loads(z: Array) -> Array:
        found: Array = legendre.legvander(z / half_length, count - 1) * norm
        return found

    total = np.zeros((grid.y.size, count))
    for n in range(0, most + 1, 2):
        weight = (2.0 if n else 1.0) / math.pi
        total += weight * elements.compressed(n, loads, grid.y)
        total -= weight * grid.moved(*_flat(float(n or 1)))
    return total


def _sum_over_images(distance: Array) -> Array:
    """Return the sum over even modes, but for the first, of 2 K0(n s) less their integral over n; times 2 / pi."""
    from scipy import special

    x = _SPACING * distance
    found, near = np.empty_like(x), x <= _BY_SERIES
    small, large = x[near], x[~near]
    series, factor = np.zeros_like(small), 1.0
    for k, zeta in enumerate(_ZETA, start=1):
        factor *= -(2 * k - 1) / (2 * k)
        series += factor * zeta * small ** (2 * k) / (2.0 * math.pi) ** (2 * k + 1)
    found[near] = np.euler_gamma + np.log(small / (4.0 * math.pi)) + 2.0 * math.pi * series
    found[~near] = sum((2.0 * special.k0(j * large) for j in range(1, _REFLECTIONS)), -math.pi / large)
    return _SPACING / math.pi * found


def _sum_over_planes(distance: Array) -> Array:
    """Return the same of exp(-n s)."""
    x = _SPACING * distance
    at_least = np.clip(x, 1e-3, 700.0)
    found: Array = np.where(x < 1e-2, -0.5 + x / 12.0 - x**3 / 720.0, 1.0 / np.expm1(at_least) - 1.0 / at_least)
    return _SPACING / math.pi * found


def _local(poisson: float, most: int) -> float:
    """Return what high modes add at the place of the load, and what low ones do because the contact has a width."""
    from scipy import special

    n = np.arange(2.0, _LAST_MODE, 2.0)
    beta = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson))
    difference = (n - beta) / (n**2 - 1.0) - 1.0 / n
    shape = 2.0 * special.j1(n * _USUAL_WIDTH) / (n * _USUAL_WIDTH)
    return 4.0 * float(np.sum(difference * np.where(n > most, shape, shape - 1.0)))
