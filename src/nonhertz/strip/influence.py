"""From strip loads to displacement and curvature on the centre line.

A strip acts at a point through the difference of an element's functions between its two edges, and its images do
the same from their own positions. The loops below add up *terms* (`nonhertz.bodies.influence`) without knowing what
they stand for. The displacement at depth is linear in the loads and independent of the half-widths, so it is worked out
once per grid, as a matrix that the loop subtracts.

All coefficients are per unit of compliance: with r = K q / a^2 and m = a^2 as unknowns, K appears nowhere.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.bodies.influence import Influence
from nonhertz.compiled import compiled, entry
from nonhertz.strip.element import evaluate, evaluate_displacement
from nonhertz.strip.records import Array, Indices, Law, Strips

EQUAL = 1e-12  # fraction of their width by which strips may differ and still count as equal


@compiled
def coefficients(strips: Strips, m: Array, active: Indices, law: Law, out: Array) -> None:
    """Fill ``out[:, i, j]`` with [A], [t A'], [B], [t B'] of strip j at the centre of strip i.

    Parameters
    ----------
    strips : Strips
        All strips.
    m : ndarray, shape (n,)
        Squared half-widths [mm^2].
    active : ndarray of int, shape (k,)
        The strips that take part.
    law : Law
        How they act.
    out : ndarray, shape (4, k, k)
        Result.
    """
    low, high = strips.low, strips.high
    equal = active[-1] - active[0] == active.size - 1
    for i in range(low.size):
        equal = equal and abs((high[i] - low[i]) - (high[0] - low[0])) < EQUAL * (high[0] - low[0])
    for j in range(active.size):
        source = active[j]
        inverse = 1.0 / math.sqrt(m[source])
        if equal:
            _seen_from_equal_strips(strips.y, low[source], high[source], inverse, active, law, j, out)
        else:
            _seen_from_any_strips(strips.y, low[source], high[source], inverse, active, law, j, out)
        if strips.at_depth.size:
            for i in range(active.size):
                out[0, i, j] -= strips.at_depth[active[i], source]


@compiled
def _seen_from_any_strips(
    y: Array, low: float, high: float, inverse: float, active: Indices, law: Law, j: int, out: Array
) -> None:
    """Fill column j of every block, from any strip."""
    terms, table = law.terms, law.table
    for i in range(active.size):
        a = ta = b = tb = 0.0
        for k in range(terms.shape[0]):
            sign, offset = terms[k, 0], terms[k, 1] - y[active[i]]
            weight = sign * terms[k, 2]
            a1, ta1, b1, tb1 = evaluate((sign * high + offset) * inverse, table)
            a0, ta0, b0, tb0 = evaluate((sign * low + offset) * inverse, table)
            a += weight * (a1 - a0)
            ta += weight * (ta1 - ta0)
            b += weight * (b1 - b0)
            tb += weight * (tb1 - tb0)
        out[0, i, j], out[1, i, j], out[2, i, j], out[3, i, j] = a, ta, b, tb


@compiled
def _seen_from_equal_strips(
    y: Array, low: float, high: float, inverse: float, active: Indices, law: Law, j: int, out: Array
) -> None:
    """Fill column j of every block, from equal strips: neighbours share an edge, so each edge is evaluated once."""
    terms, table = law.terms, law.table
    for i in range(active.size):
        out[0, i, j] = out[1, i, j] = out[2, i, j] = out[3, i, j] = 0.0
    for k in range(terms.shape[0]):
        sign, weight = terms[k, 0], terms[k, 2]
        # The edge shared with the next strip, and the other one.
        near, far = (low, high) if sign > 0.0 else (high, low)
        a0, ta0, b0, tb0 = evaluate((sign * far + terms[k, 1] - y[active[0]]) * inverse, table)
        for i in range(active.size):
            a1, ta1, b1, tb1 = a0, ta0, b0, tb0
            a0, ta0, b0, tb0 = evaluate((sign * near + terms[k, 1] - y[active[i]]) * inverse, table)
            out[0, i, j] += weight * (a1 - a0)
            out[1, i, j] += weight * (ta1 - ta0)
            out[2, i, j] += weight * (b1 - b0)
            out[3, i, j] += weight * (tb1 - tb0)


@compiled
def displacement(
    y: float, low: Array, high: Array, inverse: Array, q: Array, active: Indices, terms: Array, table: Array
) -> float:
    """Return the surface's displacement at ``y`` under ``active`` strips with 1/a = ``inverse`` and loads K ``q``."""
    total = 0.0
    for source in active:
        total += q[source] * seen(y, low[source], high[source], inverse[source], terms, table)
    return total


@compiled
def seen(y: float, low: float, high: float, inverse: float, terms: Array, table: Array) -> float:
    """Return [A] at ``y`` of one strip with 1/a = ``inverse``, its images included."""
    total = 0.0
    for k in range(terms.shape[0]):
        sign, offset = terms[k, 0], terms[k, 1] - y
        upper = evaluate_displacement((sign * high + offset) * inverse, table)
        lower = evaluate_displacement((sign * low + offset) * inverse, table)
        total += sign * terms[k, 2] * (upper - lower)
    return total


def displacements(influence: Influence, y: Array, edges: Array, r: Array, m: Array, table: Array) -> Array:
    """Return the displacement per unit of compliance at several places ``y``, relative to the points at depth."""
    at_depth: Array = influence.at_depth(y, edges) @ (r * m)
    lift = np.empty(y.size)
    _on_the_surface(y, edges[:-1], edges[1:], r, m, influence.terms, table, lift)
    return lift - at_depth


@entry
def _on_the_surface(
    places: Array, low: Array, high: Array, r: Array, m: Array, terms: Array, table: Array, result: Array
) -> None:
    for i in range(places.size):
        result[i] = 0.0
    for j in range(m.size):
        if m[j] > 0.0:
            inverse, q = 1.0 / math.sqrt(m[j]), r[j] * m[j]
            for i in range(places.size):
                result[i] += q * seen(places[i], low[j], high[j], inverse, terms, table)


@compiled
def self_displacement(width: float, m: float, table: Array) -> tuple[float, float]:
    """Return [A] of a strip at its own centre and d(m [A])/dm."""
    a, ta, _, _ = evaluate(0.5 * width / math.sqrt(m), table)
    return 2.0 * a, 2.0 * a - ta
