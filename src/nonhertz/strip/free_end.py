"""What a free side face adds to the displacement and curvature of strips and their images.

A strip with its edges at the distances v and v' from the face, and a place at the distance u, all in half-widths, add

    displacement   K q [H(u, v') - H(u, v)],     H = integral of h dv from the face,
    curvature      K q [C(u, v') - C(u, v)] / a^2,

with h what a load of unit length adds, of the strip's pressure across (`nonhertz.bodies.quarter_space`), and c its
negative second derivative in x. Their derivatives by a follow from (u d/du + v d/dv) H and C. All four are read from
one table of polynomials on squares that double in size away from the face. Far away they are series in 1 / a^2 with
coefficients that depend on the direction only, which do not differ from one element to another but by the factors that
the direct effect of the element has, too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache, partial

import numpy as np
from numpy.polynomial import chebyshev, legendre
from numpy.typing import NDArray

from nonhertz.bodies.quarter_space import EDGE_SLOPE, FreeFace, free_face
from nonhertz.bodies.stored import MOST, stored
from nonhertz.native import core
from nonhertz.strip.element import ELEMENTS, LEADING_AT, POWERS, Element

Array = NDArray[np.float64]
Density = Callable[[Array, Array], Array]

FIRST_OCTAVE, LAST_OCTAVE = -14, 2
CLOSE, AWAY = 2.0**FIRST_OCTAVE, 2.0**LAST_OCTAVE
OCTAVES = LAST_OCTAVE - FIRST_OCTAVE
SQUARE_DEGREE = 9
# Of the terms of the series, of which each counts 16 times less than the one before it.
DIRECTION_DEGREES = (20, 16, 12, 10, 8, 8)
_FINE = 14  # nodes on each octave, from which the table is made


@lru_cache(MOST)
def face_table(element: Element, poisson: float) -> core.FaceTable:
    """Return what the core reads for the free side face of a body."""
    return core.FaceTable(free_end_table(element, poisson))


def free_end_table(element: Element, poisson: float) -> Array:
    """Return the numbers of `face_table`, in one flat array.

    Polynomials on squares, those of the series far away, and the slopes of h and c towards the edge.
    """
    if ELEMENTS.get(element.name) == element:
        return _table(element.name, poisson)
    return _made(element, poisson)


@stored(__name__, "nonhertz.strip.element", "nonhertz.bodies.quarter_space")
def _table(name: str, poisson: float) -> Array:
    return _made(ELEMENTS[name], poisson)


@lru_cache(MOST)
def _made(element: Element, poisson: float) -> Array:
    face = free_face(poisson)
    slopes = EDGE_SLOPE * element.table[LEADING_AT : LEADING_AT + 3 : 2] / 2.0
    return np.concatenate([_squares(element, face), _directions(face), slopes])


def _squares(element: Element, face: FreeFace) -> Array:
    """Return coefficients, (octaves of u, of v, powers of u, of v, 4) flattened, highest powers first."""
    # Neighbouring octaves share these nodes, so that nothing jumps where they meet.
    nodes, fine = chebyshev.chebpts2(SQUARE_DEGREE + 1), chebyshev.chebpts1(_FINE)
    to_nodes, slopes = _interpolation(fine, nodes)
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    edges = _places(nodes)
    values = np.empty((OCTAVES, nodes.size, OCTAVES, nodes.size, 4))
    for kind, density in enumerate(densities(element, face)):
        integral = _integral(density, _places(fine).ravel(), nodes).reshape(OCTAVES, _FINE, OCTAVES, nodes.size)
        along_u = np.einsum("nf,ofpm->onpm", slopes, integral) * (2.0 / octave)[:, None, None, None]
        along_v = density(edges[:, :, None, None], edges)
        values[..., 2 * kind] = np.einsum("nf,ofpm->onpm", to_nodes, integral)
        values[..., 2 * kind + 1] = edges[:, :, None, None] * along_u + edges * along_v
    to_powers = np.linalg.inv(np.vander(nodes))
    return np.ascontiguousarray(np.einsum("pn,qm,onrmf->orpqf", to_powers, to_powers, values)).ravel()


def _integral(density: Density, u: Array, nodes: Array) -> Array:
    """Return the integral of a density over v from the face, shape (u, octaves of v, nodes)."""
    gauss, share = legendre.leggauss(_FINE)
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    on_octaves = density(u[:, None, None], _places(gauss))
    before = 0.5 * CLOSE * density(u[:, None], 0.5 * CLOSE * (1.0 + gauss)) @ share
    whole = 0.5 * octave * (on_octaves @ share)
    start = before[:, None] + np.cumsum(whole, axis=1) - whole
    up_to = np.array([legendre.legval(nodes, legendre.legint(unit, lbnd=-1.0)) for unit in np.eye(_FINE)])
    to_integral = np.linalg.inv(legendre.legvander(gauss, _FINE - 1)).T @ up_to
    found: Array = start[:, :, None] + 0.5 * octave[:, None] * (on_octaves @ to_integral)
    return found


def densities(element: Element, face: FreeFace) -> tuple[Density, Density]:
    """Return h and c as functions of u and v."""

    def density(kind: int, u: Array, v: Array) -> Array:
        weights = face.towards(u, v)
        t = np.multiply.outer(u + v, face.distances)
        of_image = element.functions(t)[1 + 2 * kind] / t
        added: Array = np.sum(weights[..., 0, :] * of_image + weights[..., 1, :] * element.smoothed(t)[kind], axis=-1)
        return added

    return partial(density, 0), partial(density, 1)


def _places(nodes: Array) -> Array:
    """Return the places of nodes from -1 to 1 on all octaves, shape (octaves, nodes)."""
    octave = 2.0 ** np.arange(FIRST_OCTAVE, LAST_OCTAVE)
    places: Array = octave[:, None] * (1.5 + 0.5 * nodes)
    return places


def _interpolation(given: Array, wanted: Array) -> tuple[Array, Array]:
    """Return the matrices from values at given nodes to values and slopes at wanted ones."""
    to_chebyshev = np.linalg.inv(chebyshev.chebvander(given, given.size - 1))
    units = np.eye(given.size)
    values = np.array([chebyshev.chebval(wanted, unit) for unit in units]).T
    slopes = np.array([chebyshev.chebval(wanted, chebyshev.chebder(unit)) for unit in units]).T
    return values @ to_chebyshev, slopes @ to_chebyshev


def _directions(face: FreeFace) -> Array:
    """Return the polynomials in the direction r of the series far away, and their sums.

    The k-th term of h is G_k(r) / max(u, v)^(2 k + 1), so that its integral over v is u^-2k times that of G_k where v
    is less than u; beyond, it is counted from infinity, as v^-2k times a function of r: there it is small, and in the
    difference of two edges nothing cancels. They are scaled so that the factors of the element's own series hold.
    """
    fine = chebyshev.chebpts1(4 * DIRECTION_DEGREES[0])
    r = 0.5 * (1.0 + fine)
    moments = face.moments(r, POWERS)
    inner, outer, whole = [], [], []
    for k in range(POWERS + 1):
        series = chebyshev.Chebyshev.fit(r, moments[:, k], 2 * DIRECTION_DEGREES[0], domain=[0.0, 1.0])
        degree = DIRECTION_DEGREES[k]
        # By which the k-th term is that of a difference of 1 / t^2k in the element's series.
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
