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
from nonhertz.compiled import compiled
from nonhertz.compiled.tiles import TILE, ZERO, eight, horner, product, put
from nonhertz.strip.element import ELEMENTS, LEADING_AT, POWERS, POWERS_AT, Element

Array = NDArray[np.float64]
Four = tuple[float, float, float, float]
Density = Callable[[Array, Array], Array]

FIRST_OCTAVE, LAST_OCTAVE = -14, 2
CLOSE, AWAY = 2.0**FIRST_OCTAVE, 2.0**LAST_OCTAVE
OCTAVES = LAST_OCTAVE - FIRST_OCTAVE
TINY = 1e-300
LOGARITHMIC = 16.0 * CLOSE  # up to which both distances count as close to the edge
SQUARE_DEGREE = 9
# Of the terms of the series, of which each counts 16 times less than the one before it.
DIRECTION_DEGREES = (20, 16, 12, 10, 8, 8)
_FINE = 14  # nodes on each octave, from which the table is made

# Offsets of the table's parts.
_SQUARE = 4 * (SQUARE_DEGREE + 1) ** 2
FAR_AT = OCTAVES * OCTAVES * _SQUARE
_POLYNOMIALS = sum(DIRECTION_DEGREES) + POWERS + 1
BEYOND_AT = FAR_AT + _POLYNOMIALS
WHOLE_AT = BEYOND_AT + _POLYNOMIALS
SLOPES_AT = WHOLE_AT + POWERS + 2
TABLE_SIZE = SLOPES_AT + 2


def free_end_table(element: Element, poisson: float) -> Array:
    """Return what the compiled core reads for the free side face of a body, in one flat array.

    Polynomials on squares, those of the series far away, and the slopes of h and c towards the edge.
    """
    if ELEMENTS.get(element.name) is element:
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


@compiled
def no_squares() -> Array:
    """Return room for what `free_end` keeps of one place for the next; it may be passed to any strip and face."""
    return np.full((2, 2 + 4 * (SQUARE_DEGREE + 1)), np.nan)


@compiled
def free_end(u: float, inner: float, outer: float, table: Array, first: int, element: Array, kept: Array) -> Four:
    """Return what is added to [A], [t A'], [B] and [t B'] of a strip.

    Parameters
    ----------
    u, inner, outer : float
        Distances of the place and of both edges of the strip from the side face, in half-widths, not negative.
    table : ndarray
        Tables from `free_end_table`, one after the other.
    first : int
        Where that of the body begins.
    element : ndarray
        The table of the element.
    kept : ndarray
        From `no_squares`, overwritten: places in turn along one strip find there what they share.
    """
    if u + inner >= AWAY:
        return _series(u, inner, outer, table, first, element)
    # Beyond the table the rest is far away.
    last = max(min(outer, AWAY), inner)
    a0, ta0, b0, tb0 = _up_to(u, inner, table, first, element, kept[0])
    a1, ta1, b1, tb1 = _up_to(u, last, table, first, element, kept[1])
    if outer > last:
        a2, ta2, b2, tb2 = _series(u, last, outer, table, first, element)
        return (a1 - a0 + a2, ta1 - ta0 + ta2, b1 - b0 + b2, tb1 - tb0 + tb2)
    return (a1 - a0, ta1 - ta0, b1 - b0, tb1 - tb0)


@compiled
def _up_to(u: float, v: float, table: Array, first: int, element: Array, kept: Array) -> Four:
    """Return H, (u d/du + v d/dv) H, C and (u d/du + v d/dv) C, for v within the table."""
    if v <= 0.0:
        return (0.0, 0.0, 0.0, 0.0)
    if u >= AWAY:
        return _series(u, 0.0, v, table, first, element)
    # Close to the edge h and c vary with the logarithm of the distance alone.
    scale = max(1.0, min(CLOSE / max(min(u, v), TINY), LOGARITHMIC / max(u, v)))
    place, edge = max(scale * u, CLOSE), scale * v
    share = min(edge / CLOSE, 1.0) / scale
    a, ta, b, tb = _square(place, max(edge, CLOSE), table, first, kept)
    grown = v * math.log(scale)
    of_h, of_c = table[first + SLOPES_AT] * grown, table[first + SLOPES_AT + 1] * grown
    return (share * a + of_h, share * ta + of_h, share * b + of_c, share * tb + of_c)


@compiled
def _square(u: float, v: float, table: Array, first: int, kept: Array) -> Four:
    """Return the four functions within the table.

    Their polynomials in u at this v are kept: the next place is often in the same square.
    """
    row, x = _octave(u)
    column, z = _octave(v)
    at = np.uint64(first) + (row * np.uint64(OCTAVES) + column) * np.uint64(_SQUARE)
    if kept[0] != at or kept[1] != z:
        kept[0], kept[1] = at, z
        for power in range(SQUARE_DEGREE + 1):
            a = ta = b = tb = 0.0
            for _ in range(SQUARE_DEGREE + 1):
                a = a * z + table[at]
                ta = ta * z + table[at + np.uint64(1)]
                b = b * z + table[at + np.uint64(2)]
                tb = tb * z + table[at + np.uint64(3)]
                at += np.uint64(4)
            begin = np.uint64(2 + 4 * power)
            kept[begin], kept[begin + np.uint64(1)] = a, ta
            kept[begin + np.uint64(2)], kept[begin + np.uint64(3)] = b, tb
    a = ta = b = tb = 0.0
    for power in range(SQUARE_DEGREE + 1):
        begin = np.uint64(2 + 4 * power)
        a = a * x + kept[begin]
        ta = ta * x + kept[begin + np.uint64(1)]
        b = b * x + kept[begin + np.uint64(2)]
        tb = tb * x + kept[begin + np.uint64(3)]
    return (a, ta, b, tb)


@compiled
def _octave(size: float) -> tuple[np.uint64, float]:
    """Return the number of the octave, and the place in it from -1 to 1; see `nonhertz.strip.element`."""
    bits = np.float64(size).view(np.uint64)
    octave = (bits >> np.uint64(52)) - np.uint64(1023 + FIRST_OCTAVE)
    if octave >= np.uint64(OCTAVES):
        return np.uint64(OCTAVES - 1), 1.0
    return octave, np.float64(bits & np.uint64((1 << 52) - 1)) * (2.0 / (1 << 52)) - 1.0


@compiled
def _series(u: float, inner: float, outer: float, table: Array, first: int, element: Array) -> Four:
    """Return what is added far away."""
    a = ta = b = tb = 0.0
    at = 0
    for k in range(POWERS + 1):
        part = _far_term(u, outer, k, at, table, first) - _far_term(u, inner, k, at, table, first)
        if inner <= u < outer:
            part += far_whole(u, k, table, first)
        if k == 0:
            a = part
        else:
            of_a, of_b = part * element[POWERS_AT + 2 * k - 2], part * element[POWERS_AT + 2 * k - 1]
            a += of_a
            ta -= 2.0 * k * of_a
            b += of_b
            tb -= 2.0 * k * of_b
        at += DIRECTION_DEGREES[k] + 1
    return (a, ta, b, tb)


@compiled
def _far_term(u: float, v: float, k: int, at: int, table: Array, first: int) -> float:
    """Return one of the integrals of `far_terms`, whose polynomials begin ``at``."""
    counts_on = u < v
    at += first + (BEYOND_AT if counts_on else FAR_AT)
    larger = max(u, v, TINY)
    x, w, total = 2.0 * min(u, v) / larger - 1.0, 1.0 / (larger * larger), 0.0
    for c in range(DIRECTION_DEGREES[k] + 1):
        total = total * x + table[at + c]
    for _ in range(k):
        total *= w
    if counts_on:
        total = -total
        if k == 0:
            total += table[first + WHOLE_AT + POWERS + 1] * math.log(v)
    return total


@compiled
def far_whole(u: float, k: int, table: Array, first: int) -> float:
    """Return by how much the two ways of counting in `far_terms` differ: to be added where v = u is within a strip."""
    if k == 0:
        return float(table[first + WHOLE_AT] - table[first + WHOLE_AT + POWERS + 1] * math.log(u))
    return float(table[first + WHOLE_AT + k] * u ** (-2.0 * k))


@compiled
def far_terms(u: Array, v: float, table: Array, first: int, terms: Array, work: Array) -> None:
    """Fill in the integrals of the series over the loads up to ``v``, or for u < v over those beyond, negative.

    All in any unit of length L; the k-th term has the unit L^-2k.

    Parameters
    ----------
    u : ndarray, shape (n,)
        Distances of places, ascending or descending.
    v : float
        Distance of an edge.
    table, first
        As for `free_end`.
    terms : ndarray, shape (POWERS + 1, n + TILE)
        Result, and room beyond it.
    work : ndarray, shape (2, n + TILE)
        Overwritten.
    """
    n, begin, end = u.size, 0, 0
    x, w = work[0], work[1]
    for i in range(n):
        larger = max(u[i], v, TINY)
        x[i], w[i] = 2.0 * min(u[i], v) / larger - 1.0, 1.0 / (larger * larger)
    x[n:], w[n:] = 0.0, 0.0
    # The places from begin to before end count from infinity.
    while end < n and u[end] < v:
        end += 1
    if end == 0:
        begin = end = n
        while begin > 0 and u[begin - 1] < v:
            begin -= 1
    for low, high, sign, at in ((0, begin, 1.0, FAR_AT), (begin, end, -1.0, BEYOND_AT), (end, n, 1.0, FAR_AT)):
        _far_polynomials(x, w, low, high, sign, first + at, table, terms)
    if begin < end:
        grown = table[first + WHOLE_AT + POWERS + 1] * math.log(v)
        for i in range(begin, end):
            terms[0, i] += grown


@compiled
def _far_polynomials(
    x: Array, w: Array, begin: int, end: int, sign: float, at: int, table: Array, terms: Array
) -> None:
    """Fill in the polynomials of some places, the k-th multiplied by w^k, and whatever beyond, to the end of a tile."""
    for first in range(begin, end, TILE):
        place, beside, weight, weight_beside = (
            eight(x, first), eight(x, first + 8), eight(w, first), eight(w, first + 8)
        )  # fmt: skip
        c = np.uint64(at)
        for k in range(POWERS + 1):
            total = total_beside = ZERO
            for _ in range(DIRECTION_DEGREES[k] + 1):
                coefficient = sign * table[c]
                total = horner(total, place, coefficient)
                total_beside = horner(total_beside, beside, coefficient)
                c += np.uint64(1)
            for _ in range(k):
                total, total_beside = product(total, weight), product(total_beside, weight_beside)
            put(terms[k], first, total)
            put(terms[k], first + 8, total_beside)
