"""From strip loads to displacement and curvature on the centre line.

A strip acts at a point through the difference of an element's functions between its two edges. Everything that
acts beside the strip itself is a *term*: a row (sign, offset, weight) that sends an edge at y to
``sign * y + offset`` and counts ``weight`` times. The direct effect is the term (1, 0, 1); a mirror image about
a face at f is (-1, 2 f, weight). The loops below add up terms and know nothing about what they stand for.

The displacement is measured against points that may move themselves: the load of a strip lifts a point at depth
d below the surface by a function of its edges over d. That part depends neither on the loads nor on the half-widths,
so it is worked out once for a grid, as a matrix that the loop subtracts.

All coefficients are per unit of compliance: with r = K q / a^2 and m = a^2 as unknowns, K appears nowhere.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.strip.compiled import compiled
from nonhertz.strip.element import evaluate, evaluate_displacement

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

#: The direct effect alone: two half-spaces.
HALF_SPACE = np.array([[1.0, 0.0, 1.0]])


@dataclass(frozen=True)
class Depth:
    """How loads on the surface of one body move the points that its displacement is measured against.

    Attributes
    ----------
    below : callable
        y [mm] -> depth d of the point below the surface [mm].
    poisson_factor : float
        1 / (2 (1 - nu)).
    terms : ndarray, shape (terms, 3)
        Rows as for the surface, of this body alone, its share of the compliance in the weights.
    far : callable or None
        y [mm] -> what images too far away to be told apart add to the surface's displacement, per unit of load.
    """

    below: Callable[[Array], Array]
    poisson_factor: float
    terms: Array
    far: Callable[[Array], Array] | None = None

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return the displacement at depth under ``y`` per unit of K q of each strip, shape (places, strips)."""
        result = np.diff(_at_depth(y, self.below(y), edges, self.poisson_factor, self.terms), axis=1)
        if self.far is not None:
            result -= self.far(y)[:, None] * np.diff(edges)
        return np.ascontiguousarray(result)


@dataclass(frozen=True)
class End:
    """A place where one body or both have a free side face, with image weights that have a solution.

    Attributes
    ----------
    y : float
        Where [mm].
    side : int
        -1 at the low, 1 at the high end of the bodies.
    weights : tuple of float
        Weights of the images of body a and b about this face, at most such that ``image_weight`` is 1.
    wanted : float
        kappa of the weights that were asked for on this side, near faces of the other body counted in.
    image_weight : float
        kappa of this face alone with the weights used.
    """

    y: float
    side: int
    weights: tuple[float, float]
    wanted: float
    image_weight: float


@dataclass(frozen=True)
class Influence:
    """How strips act on the centre line: on both surfaces, and on the points at depth of each body that has any.

    Attributes
    ----------
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight); see the module.
    depths : tuple of Depth
        Of the bodies that have one.
    ends : tuple of End
        The free side faces that the images in ``terms`` are about.
    """

    terms: Array
    depths: tuple[Depth, ...] = ()
    ends: tuple[End, ...] = ()

    def at_depth(self, y: Array, edges: Array) -> Array:
        """Return the displacement of the points at depth per unit of K q, shape (places, strips)."""
        if not self.depths:
            return np.zeros((y.size, edges.size - 1))
        return sum((depth.displacement(y, edges) for depth in self.depths[1:]), self.depths[0].displacement(y, edges))

    def shallowest(self, y: Array) -> Array:
        """Return the lesser depth of both bodies under the places ``y``, infinite where neither has one."""
        shallowest = np.full(y.shape, np.inf)
        for depth in self.depths:
            shallowest = np.minimum(shallowest, depth.below(y))
        return shallowest

    def displacements(self, y: Array, edges: Array, r: Array, m: Array, table: Array) -> Array:
        """Return the displacement per unit of compliance at several places ``y``."""
        at_depth: Array = self.at_depth(y, edges) @ (r * m)
        return displacements(y, edges[:-1], edges[1:], r, m, self.terms, table) - at_depth


@compiled
def _at_depth(y: Array, depth: Array, edges: Array, poisson_factor: float, terms: Array) -> Array:
    """Return what a load from the far left up to each edge does at depth under each place, up to a constant."""
    out = np.zeros((y.size, edges.size))
    for i in range(y.size):
        inverse = 1.0 / depth[i]
        for k in range(terms.shape[0]):
            sign, offset, weight = terms[k, 0], terms[k, 1] - y[i], terms[k, 0] * terms[k, 2]
            for e in range(edges.size):
                u = (sign * edges[e] + offset) * inverse
                root = math.sqrt(1.0 + u * u)
                value = math.log(abs(u) + root)
                out[i, e] += weight * (math.copysign(value, u) + poisson_factor * u / root)
    return out


@compiled
def coefficients(
    y: Array,
    low: Array,
    high: Array,
    m: Array,
    active: Indices,
    terms: Array,
    at_depth: Array,
    table: Array,
    out: Array,
) -> None:
    """Fill ``out[:, i, j]`` with [A], [t A'], [B], [t B'] of strip j at the centre of strip i.

    Parameters
    ----------
    y, low, high : ndarray, shape (n,)
        Strip centres and edges [mm].
    m : ndarray, shape (n,)
        Squared half-widths [mm^2].
    active : ndarray of int, shape (k,)
        The strips that take part.
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight); see the module.
    at_depth : ndarray, shape (n, n)
        Displacement of the points at depth; see the module.
    table : ndarray
        The element's table.
    out : ndarray, shape (4, k, k)
        Result.
    """
    for j in range(active.size):
        source = active[j]
        inverse = 1.0 / math.sqrt(m[source])
        for i in range(active.size):
            a = ta = b = tb = 0.0
            for k in range(terms.shape[0]):
                sign, offset = terms[k, 0], terms[k, 1] - y[active[i]]
                weight = sign * terms[k, 2]
                a1, ta1, b1, tb1 = evaluate((sign * high[source] + offset) * inverse, table)
                a0, ta0, b0, tb0 = evaluate((sign * low[source] + offset) * inverse, table)
                a += weight * (a1 - a0)
                ta += weight * (ta1 - ta0)
                b += weight * (b1 - b0)
                tb += weight * (tb1 - tb0)
            a -= at_depth[active[i], source]
            out[0, i, j], out[1, i, j], out[2, i, j], out[3, i, j] = a, ta, b, tb


@compiled
def displacement(
    y: float, low: Array, high: Array, r: Array, m: Array, active: Indices, terms: Array, table: Array
) -> float:
    """Return the surface's displacement per unit of compliance at ``y`` under all ``active`` strips."""
    total = 0.0
    for source in active:
        inverse = 1.0 / math.sqrt(m[source])
        q = r[source] * m[source]
        for k in range(terms.shape[0]):
            sign, offset = terms[k, 0], terms[k, 1] - y
            upper = evaluate_displacement((sign * high[source] + offset) * inverse, table)
            lower = evaluate_displacement((sign * low[source] + offset) * inverse, table)
            total += q * sign * terms[k, 2] * (upper - lower)
    return total


@compiled
def displacements(places: Array, low: Array, high: Array, r: Array, m: Array, terms: Array, table: Array) -> Array:
    """Return the surface's displacement per unit of compliance at several ``places``."""
    active = np.flatnonzero(m > 0.0)
    result = np.empty(places.size)
    for i in range(places.size):
        result[i] = displacement(places[i], low, high, r, m, active, terms, table)
    return result


@compiled
def self_displacement(width: float, m: float, table: Array) -> tuple[float, float]:
    """Return [A] of a strip at its own centre and d(m [A])/dm."""
    a, ta, _, _ = evaluate(0.5 * width / math.sqrt(m), table)
    return 2.0 * a, 2.0 * a - ta
