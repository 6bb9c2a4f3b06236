"""Correction of a load and its mirror image for a free side face: the elastic quarter-space.

A body that ends at a side face is a quarter-space near there. Hetenyi's solution superposes two half-spaces, one under
the top and one under the side face. A load on either causes normal stress on the plane of the other; a load there
removes it and causes stress on the first plane, and so on; mirroring all loads removes shear. The sum of this series
is the solution of one integral equation, for loads that vary as cos(k x) along the edge. The correction to the
displacement of a load and its image is singular only at the edge itself.

With distances from the edge u (of the point) and v (of the load) multiplied by k, a load of 1 per unit of length on one
face causes on the plane of the other

    a(z, v) = (2/pi) [2 z K1(R) / R - z^3 K2(R) / R^2 + z K0(R) - (1 - 2 nu) S],     R^2 = z^2 + v^2,

with Bessel functions K0, K1, K2 and S the integral of K0 over z from there to infinity. As an operator, f -> A f, it is
the same for both faces. The additional loads are T = A (1 - A A)^-1 A, and

    e(u, v) = 2 integral of [K0(|u - t|) + K0(u + t)] T(t, v) dt

is the displacement over the half-space compliance K per unit of load (theory: docs/explain/side-faces.md).

References
----------
M. Hetenyi, A general solution for the elastic quarter space, Journal of Applied Mechanics 37 (1970), 70-76: the two
overlapping half-spaces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.native import core

Array = NDArray[np.float64]

#: ``-d e / d ln(u + v)`` towards the edge, where the quarter-space is a wedge: by Flamant's solution, for any nu.
EDGE_SLOPE = 16.0 / (math.pi**2 - 4.0)

_SMALLEST, _LARGEST = 2.0**-26, 24.0  # e varies as a logarithm below the first, and is below 1e-9 beyond the second
NODES = 10  # on each panel of the integral equation
_LOGARITHMIC = 24  # halvings of a panel towards the singularity of K0

# The form in which e is stored; its error is 1e-7.
_DISTANCES = np.geomspace(0.8, 8.0, 8)
_DIRECTIONS = 20
_FIRST_SAMPLE, _LAST_SAMPLE, _SAMPLES = -14.0, 3.5, 140  # powers of two
_DAMPING = 1e-8
_RATIO_NODES, _RATIO_DEGREE = 20, 8
_ANY_POISSON = 0.3


@dataclass(frozen=True)
class FreeFace:
    """Correction for a free side face, as images at several distances with weights that depend on the direction.

    In the direction r = (u - v)^2 / (u + v)^2, in which e is smooth, and at the distance t = u + v of the image,

        e = sum over j of w_j(r) 2 K0(d_j t) + v_j(r) exp(-d_j t).

    Transformed back from cos(k x), the first are images at the distances d_j t, the second pressures on a half-plane.

    Attributes
    ----------
    poisson : float
        Poisson's ratio.
    distances : ndarray, shape (m,)
        d_j.
    weights : ndarray, shape (directions, 2, m)
        Coefficients of w_j and v_j in Chebyshev polynomials of 2 r - 1.
    """

    poisson: float
    distances: Array
    weights: Array

    def towards(self, u: Array, v: Array) -> Array:
        """Return w_j and v_j, shape (..., 2, m), for points ``u`` and loads ``v`` of shape (...)."""
        direction = np.asarray(((u - v) / (u + v)) ** 2)
        degree = len(self.weights) - 1
        basis = chebyshev.chebvander(2.0 * direction - 1.0, degree).reshape(*direction.shape, degree + 1)
        factors: Array = np.tensordot(basis, self.weights, 1)
        return factors

    def moments(self, ratio: Array, powers: int) -> Array:
        """Return the integrals of e s^2k ds / pi, k = 0 to ``powers``, for u = s and v = s times ``ratio``.

        They are the coefficients of the series of a concentrated load's displacement in the distance across.

        Returns
        -------
        ndarray, shape (..., powers + 1)
        """
        distance = np.multiply.outer(1.0 + ratio, self.distances)
        weights = self.towards(np.ones_like(ratio), ratio)
        integrals = np.empty((*ratio.shape, powers + 1))
        for k in range(powers + 1):
            of_images, of_planes = 4.0**k * math.gamma(k + 0.5) ** 2, math.gamma(2 * k + 1)
            terms = (of_images * weights[..., 0, :] + of_planes * weights[..., 1, :]) / distance ** (2 * k + 1)
            integrals[..., k] = np.sum(terms, axis=-1) / math.pi
        return integrals

    @cached_property
    def over_image(self) -> Array:
        """Far-field correction over the effect of the image: powers of 2 r - 1 in the direction r, highest first.

        It is accurate to 2e-4.
        """
        nodes = chebyshev.chebpts1(_RATIO_NODES)
        aside = np.sqrt(0.5 * (1.0 + nodes))
        ratio = (1.0 - aside) / (1.0 + aside)
        values = (1.0 + ratio) * self.moments(ratio, 0)[:, 0]
        powers = chebyshev.cheb2poly(chebyshev.chebfit(nodes, values, _RATIO_DEGREE))
        return np.ascontiguousarray(powers[::-1], dtype=float)


def edge_kernel(u: Array, v: Array) -> Array:
    """Return the limit of e towards the edge, up to a constant; it does not depend on Poisson's ratio.

    ``u`` and ``v`` are distances in any unit, not both zero.
    """
    face = free_face(_ANY_POISSON)
    weights = face.towards(u, v)
    of_direction = np.sum(weights[..., 1, :] - 2.0 * weights[..., 0, :] * np.log(face.distances), axis=-1)
    kernel: Array = of_direction - EDGE_SLOPE * np.log(u + v)
    return kernel


@lru_cache(MOST)
def free_face(poisson: float) -> FreeFace:
    """Return the correction for a free side face of a material."""
    return FreeFace(poisson, _DISTANCES, _weights(poisson))


@cache_on_disk(__name__, core.__name__)
def _weights(poisson: float) -> Array:
    """Return the weights of `FreeFace`."""
    solved = EdgeSolution.of(poisson)
    nodes = chebyshev.chebpts1(_DIRECTIONS)
    size = 2.0 ** np.linspace(_FIRST_SAMPLE, _LAST_SAMPLE, _SAMPLES)
    aside = np.sqrt(0.5 * (1.0 + nodes))  # deviation of the distances from their mean, over the mean
    fitted = np.array(
        [_fit_weights(size, solved.at(size * (1.0 + fraction), size * (1.0 - fraction))) for fraction in aside]
    )
    to_chebyshev = np.linalg.inv(chebyshev.chebvander(nodes, _DIRECTIONS - 1))
    return np.tensordot(to_chebyshev, fitted, 1)


def _fit_weights(size: Array, wanted: Array) -> Array:
    """Return w_j and v_j, shape (2, m), fitted to e in one direction at these means of both distances."""
    from scipy import special

    distance = np.multiply.outer(2.0 * size, _DISTANCES)
    basis = np.hstack([2.0 * special.k0(distance), np.exp(-distance)])
    damped = np.vstack([basis, _DAMPING * np.eye(basis.shape[1])])
    weights: Array = np.linalg.lstsq(damped, np.concatenate([wanted, np.zeros(basis.shape[1])]), rcond=None)[0]
    return weights.reshape(2, -1)


@dataclass(frozen=True)
class EdgeSolution:
    """The function e at the nodes of the integral equation, and between them by the polynomials of each panel."""

    panels: Array
    values: Array

    @classmethod
    def of(cls, poisson: float) -> EdgeSolution:
        """Solve the integral equation."""
        panels, y, _, brought, operator = corner_operator(poisson)
        # In the core, where the last digits do not depend on the number of threads: the result is stored on disk.
        beyond = core.product(operator, core.solve_dense(np.eye(y.size) - core.product(operator, operator), brought))
        values = 2.0 * core.product(_displacement_matrix(), beyond)
        # Symmetrised by reciprocity; the difference is error.
        return cls(panels, 0.5 * (values + values.T))

    def at(self, u: Array, v: Array) -> Array:
        """Return e at points within the panels."""
        panels, nodes = self.panels.size - 1, NODES
        blocks = self.values.reshape(panels, nodes, panels, nodes)
        (row, of_u), (column, right) = (interpolation(self.panels, distance) for distance in (u, v))
        values: Array = np.einsum("ki,kij,kj->k", of_u, blocks[row, :, column, :], right)
        return values


def corner_operator(poisson: float) -> tuple[Array, Array, Array, Array, Array]:
    """Return edges of panels, Gauss nodes and weights on them, a between the nodes, and the operator A on loads there.

    Distances are multiplied by k.
    """
    panels = _panels()
    y, weight = nodes_on(panels)
    brought = _kernel_matrix(poisson)
    operator = brought * weight
    _mend_corner(operator, panels, y, weight)
    return panels, y, weight, brought, operator


def _panels() -> Array:
    """Return panels that double in size away from the edge, up to a few wavelengths."""
    borders = [0.0, _SMALLEST]
    while borders[-1] < _LARGEST:
        borders.append(borders[-1] + (borders[-1] if borders[-1] < 1.0 else min(2.0, max(1.0, 0.5 * borders[-1]))))
    return np.array(borders)


def nodes_on(panels: Array) -> tuple[Array, Array]:
    """Return Gauss nodes and weights on all panels."""
    node, weight = legendre.leggauss(NODES)
    centre, half = 0.5 * (panels[1:] + panels[:-1]), 0.5 * np.diff(panels)
    return (centre[:, None] + half[:, None] * node).ravel(), (half[:, None] * weight).ravel()


def interpolation(panels: Array, places: Array) -> tuple[NDArray[np.int64], Array]:
    """Return the panel of each point, and the weights of the panel's nodes there."""
    panel = np.clip(np.searchsorted(panels, places) - 1, 0, panels.size - 2)
    low, high = panels[panel], panels[panel + 1]
    return panel, legendre.legvander((2.0 * places - low - high) / (high - low), NODES - 1) @ to_legendre()


@cache
def to_legendre() -> Array:
    """Return the matrix from values at Gauss nodes to Legendre coefficients."""
    node, _ = legendre.leggauss(NODES)
    return np.asarray(np.linalg.inv(legendre.legvander(node, NODES - 1)), dtype=float)


def _kernel_matrix(poisson: float) -> Array:
    """Return the kernel a between all nodes: points in rows, loads in columns."""
    of_all, of_compressible = _bessel_functions()
    matrix: Array = 2.0 / math.pi * (of_all - (1.0 - 2.0 * poisson) * of_compressible)
    return matrix


@cache_on_disk(__name__)
def _bessel_functions() -> Array:
    """Return the parts of the kernel a that do not depend on Poisson's ratio, shape (2, nodes, nodes)."""
    from scipy import special

    panels = _panels()
    y, _ = nodes_on(panels)
    z = y[:, None]
    distance = np.hypot(z, y)
    of_order_0, of_order_1 = special.k0(distance), special.k1(distance)
    of_order_2 = of_order_0 + 2.0 * of_order_1 / distance
    near = 2.0 * z * of_order_1 / distance - z**3 * of_order_2 / distance**2
    return np.array([near + z * of_order_0, _integral_beyond(panels, of_order_0)])


def _integral_beyond(panels: Array, values: Array) -> Array:
    """Return the integrals of columns of nodal values from each node to the end."""
    node, weight = legendre.leggauss(NODES)
    to_end = np.empty((NODES, NODES))
    for degree, unit in enumerate(np.eye(NODES)):
        antiderivative = legendre.legint(unit)
        to_end[:, degree] = legendre.legval(1.0, antiderivative) - legendre.legval(node, antiderivative)
    blocks = values.reshape(panels.size - 1, NODES, -1)
    half = 0.5 * np.diff(panels)
    within = half[:, None, None] * (to_end @ to_legendre() @ blocks)
    whole = half[:, None] * (weight @ blocks)
    after = np.cumsum(whole[::-1], axis=0)[::-1] - whole
    return (within + after[:, None, :]).reshape(values.shape)


def _mend_corner(operator: Array, panels: Array, y: Array, weight: Array) -> None:
    """Correct the operator so that a constant load on the first panel gives its exact stress there.

    The operator leaves a constant load near the edge unchanged, so that even a small error of this panel would change
    the loads everywhere.
    """
    z, v = y[:NODES, None], y[:NODES]
    rough = (4.0 / math.pi * z * v**2 / (z**2 + v**2) ** 2) @ weight[:NODES]
    t = panels[1] / v
    exact = 2.0 / math.pi * (np.arctan(t) - t / (1.0 + t**2))
    first = np.arange(NODES)
    operator[first, first] += exact - rough


@cache_on_disk(__name__)
def _displacement_matrix() -> Array:
    """Return the matrix from loads at nodes to displacement there over 2 K, mirrored loads included."""
    from scipy import special

    panels = _panels()
    y, weight = nodes_on(panels)
    direct = special.k0(np.abs(y[:, None] - y) + np.eye(y.size)) * weight
    node, share = legendre.leggauss(NODES)
    halved = np.concatenate([[0.0], 2.0 ** np.arange(-_LOGARITHMIC, 1.0)])
    toward = (0.5 * (halved[1:] + halved[:-1])[:, None] + 0.5 * np.diff(halved)[:, None] * node).ravel()
    shares = (0.5 * np.diff(halved)[:, None] * share).ravel()
    for i, place in enumerate(y):
        own = i // NODES
        # On the point's own panel and the next ones K0 is integrated with the polynomials, on panels halved towards it.
        for panel in range(max(0, own - 1), min(panels.size - 1, own + 2)):
            low, high = panels[panel : panel + 2]
            middle = min(max(place, low), high)
            points = np.concatenate([middle - (middle - low) * toward, middle + (high - middle) * toward])
            parts = np.concatenate([(middle - low) * shares, (high - middle) * shares])
            inside = parts > 0.0
            local = (2.0 * points[inside] - low - high) / (high - low)
            distance = np.maximum(np.abs(points[inside] - place), np.finfo(float).tiny)
            rule = (parts[inside] * special.k0(distance)) @ legendre.legvander(local, NODES - 1) @ to_legendre()
            direct[i, panel * NODES : (panel + 1) * NODES] = rule
    raised: Array = direct + special.k0(y[:, None] + y) * weight
    return raised
