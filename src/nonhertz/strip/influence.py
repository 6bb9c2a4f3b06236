"""From strip loads to displacement and curvature on the centre line.

A strip acts at a point through the difference of an element's functions between its two edges. Everything that
acts beside the strip itself is a *term*: a row (sign, offset, weight) that sends an edge at y to
``sign * y + offset`` and counts ``weight`` times. The direct effect is the term (1, 0, 1); a mirror image about
a face at f is (-1, 2 f, weight). The loops below add up terms and know nothing about what they stand for.

All coefficients are per unit of compliance: with r = K q / a^2 and m = a^2 as unknowns, K appears nowhere.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.strip.compiled import compiled
from nonhertz.strip.element import evaluate, evaluate_displacement

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

#: The direct effect alone: two half-spaces.
HALF_SPACE = np.array([[1.0, 0.0, 1.0]])


@compiled
def coefficients(
    y: Array, low: Array, high: Array, m: Array, active: Indices, terms: Array, table: Array, out: Array
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
            out[0, i, j], out[1, i, j], out[2, i, j], out[3, i, j] = a, ta, b, tb


@compiled
def displacement(
    y: float, low: Array, high: Array, r: Array, m: Array, active: Indices, terms: Array, table: Array
) -> float:
    """Return the displacement per unit of compliance at ``y`` of all ``active`` strips."""
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
    """Return the displacement per unit of compliance at several ``places``."""
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
