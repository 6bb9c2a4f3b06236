"""Correction for a free side face to the displacement and curvature of strips and their images.

With the edges of a strip at the distances v and v' from the face, and a point at the distance u, all in half-widths, it
is

    displacement   K q [H(u, v') - H(u, v)],     H = integral of h dv from the face,
    curvature      K q [C(u, v') - C(u, v)] / a^2,

where h is the correction for a load of unit length with the strip's pressure across
(`nonhertz.bodies.quarter_space`), and c its negative second derivative in x. Their derivatives by a follow from
(u d/du + v d/dv) H and C. All four are read from one table of polynomials on squares that double in size away from the
face. Far away they are series in 1 / a^2 with coefficients that depend only on the direction; they differ between
elements by the same factors as the direct effect.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space import EDGE_SLOPE, FreeFace, free_face
from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.native import core
from nonhertz.strip.element import ELEMENTS, Element

Array = NDArray[np.float64]

POWERS = core.POWERS

FIRST_OCTAVE, LAST_OCTAVE = -14, 2
CLOSE = 2.0**FIRST_OCTAVE
OCTAVES = LAST_OCTAVE - FIRST_OCTAVE
SQUARE_DEGREE = 9
# Terms of the series; each is 16 times smaller than the one before it.
DIRECTION_DEGREES = (20, 16, 12, 10, 8, 8)
_FINE = 14  # nodes on each octave, from which the table is made


@lru_cache(MOST)
def face_table(element: Element, poisson: float) -> core.FaceTable:
    """Return the core's table for the free side face of a body."""
    return core.FaceTable(_table(element.name, poisson))


@cache_on_disk(__name__, core.__name__, "nonhertz.bodies.quarter_space")
def _table(name: str, poisson: float) -> Array:
    """Return the polynomials on squares, those of the far series, and the slopes of h and c towards the edge."""
    element, face = ELEMENTS[name], free_face(poisson)
    slopes = 0.5 * EDGE_SLOPE * np.array(element.core.leading[::2])
    return np.concatenate([_squares(element, face), _directions(face), slopes])


def _squares(element: Element, face: FreeFace) -> Array:
    """Return coefficients, (octaves of u, of v, powers of u, of v, 4) flattened, highest powers first."""
    # Neighbouring octaves share these nodes, so that the table is continuous where they meet.
    nodes, fine = chebyshev.chebpts2(SQUARE_DEGREE + 1), chebyshev.chebpts1(_FINE)
    to_nodes, slopes = _interpolation(fine, nodes)
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    edges = _places(nodes)
    integral = _integral(element, face, _places(fine).ravel(), nodes)
    integral = integral.reshape(2, OCTAVES, _FINE, OCTAVES, nodes.size)
    along_u = _contract("nf,kofpm->konpm", slopes, integral) * (2.0 / octave)[:, None, None, None]
    along_v = densities(element, face, edges[:, :, None, None], edges)
    values = np.empty((OCTAVES, nodes.size, OCTAVES, nodes.size, 2, 2))
    values[..., 0] = np.moveaxis(_contract("nf,kofpm->konpm", to_nodes, integral), 0, -1)
    values[..., 1] = np.moveaxis(edges[:, :, None, None] * along_u + edges * along_v, 0, -1)
    to_powers = np.asarray(np.linalg.inv(np.vander(nodes)), dtype=float)
    of_v = _contract("qm,onrmkf->onrqkf", to_powers, values)
    return np.ascontiguousarray(_contract("pn,onrqkf->orpqkf", to_powers, of_v)).ravel()


def _contract(indices: str, matrix: Array, values: Array) -> Array:
    """Return a sum over one index, as a product of matrices."""
    total: Array = np.einsum(indices, matrix, values, optimize=True)
    return total


def _integral(element: Element, face: FreeFace, u: Array, nodes: Array) -> Array:
    """Return the integrals of h and c over v from the face, shape (2, u, octaves of v, nodes)."""
    gauss, share = legendre.leggauss(_FINE)
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    on_octaves = densities(element, face, u[:, None, None], _places(gauss))
    before = 0.5 * CLOSE * densities(element, face, u[:, None], 0.5 * CLOSE * (1.0 + gauss)) @ share
    whole = 0.5 * octave * (on_octaves @ share)
    start = before[..., None] + np.cumsum(whole, axis=-1) - whole
    up_to = np.array([legendre.legval(nodes, legendre.legint(unit, lbnd=-1.0)) for unit in np.eye(_FINE)])
    to_integral = np.linalg.inv(legendre.legvander(gauss, _FINE - 1)).T @ up_to
    integral: Array = start[..., None] + 0.5 * octave[:, None] * (on_octaves @ to_integral)
    return integral


def densities(element: Element, face: FreeFace, u: Array, v: Array) -> Array:
    """Return h and c for points at ``u`` and loads at ``v``, shape (2, ...)."""
    u, v = np.broadcast_arrays(u, v)
    weights = face.weights.reshape(len(face.weights), -1)
    places, loads = (np.ascontiguousarray(column, dtype=float).ravel() for column in (u, v))
    return core.face_densities(element.core, face.distances, weights, places, loads).reshape(2, *u.shape)


def _places(nodes: Array) -> Array:
    """Return the places of nodes from -1 to 1 on all octaves, shape (octaves, nodes)."""
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    places: Array = octave[:, None] * (1.5 + 0.5 * nodes)
    return places


def _interpolation(nodes: Array, wanted: Array) -> tuple[Array, Array]:
    """Return the matrices from values at the nodes to values and slopes at other positions."""
    to_chebyshev = np.linalg.inv(chebyshev.chebvander(nodes, nodes.size - 1))
    units = np.eye(nodes.size)
    values = np.array([chebyshev.chebval(wanted, unit) for unit in units]).T
    slopes = np.array([chebyshev.chebval(wanted, chebyshev.chebder(unit)) for unit in units]).T
    return values @ to_chebyshev, slopes @ to_chebyshev


def _directions(face: FreeFace) -> Array:
    """Return the polynomials in the direction r of the series far away, and their sums.

    The k-th term of h is G_k(r) / max(u, v)^(2 k + 1), so its integral over v is u^-2k times that of G_k for v below u;
    beyond, it is taken from infinity, as v^-2k times a function of r, which is small, so that the difference of two
    edges does not cancel. The terms are scaled so that the factors of the element's own series apply.
    """
    fine = chebyshev.chebpts1(4 * DIRECTION_DEGREES[0])
    r = 0.5 * (1.0 + fine)
    moments = face.moments(r, POWERS)
    inner, outer, whole = [], [], []
    for k in range(POWERS + 1):
        series = chebyshev.Chebyshev.fit(r, moments[:, k], 2 * DIRECTION_DEGREES[0], domain=[0.0, 1.0])
        degree = DIRECTION_DEGREES[k]
        # Scales the k-th term to a difference of 1 / t^2k in the element's series.
        binomial = math.prod(-(0.5 + i) / (i + 1) for i in range(k))
        scale = (-1.0) ** (k + 1) * 2 * k / (math.factorial(2 * k) * binomial) if k else 1.0
        up_to = series.integ(lbnd=0.0)
        # r^-2k times the integral of G_k r^(2k-1), by Gauss's rule in r'/r; the logarithm of k = 0 is left out.
        node, weight = legendre.leggauss(24)
        part, share = 0.5 * (1.0 + node), 0.5 * weight
        at = series(np.multiply.outer(r, part))
        remainder = (at - series(0.0)) / part if k == 0 else at * part ** (2 * k - 1)
        beyond = remainder @ share
        inner.append(scale * _monomials(fine, up_to(r), degree))
        outer.append(scale * _monomials(fine, beyond, degree))
        whole.append(np.polyval(inner[-1], 1.0) + np.polyval(outer[-1], 1.0))
    return np.concatenate([*inner, *outer, whole, face.moments(np.zeros(1), 0)[0]])


def _monomials(nodes: Array, values: Array, degree: int) -> Array:
    """Return the powers of 2 r - 1, highest first."""
    fitted = chebyshev.chebfit(nodes, values, degree)
    return np.asarray(chebyshev.cheb2poly(fitted)[::-1], dtype=float)
