"""From strip loads to displacement and curvature on the centre line.

A strip acts at a point through the difference of an element's functions between its two edges, and its images do
the same from their own positions. The loops below add up *terms* (`nonhertz.bodies.influence`) without knowing what
they stand for; those far away are added up once for a grid (`Remote`). The displacement at depth is linear in the loads
and independent of the half-widths, so it is worked out once per grid, as a matrix that the loop subtracts.

All coefficients are per unit of compliance: with r = K q / a^2 and m = a^2 as unknowns, K appears nowhere.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from nonhertz.bodies.influence import Influence
from nonhertz.compiled import compiled, inlined, plain_array
from nonhertz.compiled.tiles import TILE
from nonhertz.strip.element import POWERS, POWERS_AT, REMOTE, Element, evaluate
from nonhertz.strip.free_end import AWAY, TABLE_SIZE, Four, far_terms, far_whole, free_end, free_end_table, no_squares
from nonhertz.strip.records import Array, Flags, Indices, Kernel, Strips

# Widths over distances below which nine terms of the series of a logarithm are exact to rounding.
SHORT = 0.25
ROOM = 1.2  # for m to grow before what a strip does far away has to be worked out again


class Remote(NamedTuple):
    """What strips and their images do far away: there the series of an element in 1 / t^2 needs a few terms only.

    With t = y' / a its terms are powers of m, each with a factor that depends on the strips alone. So all terms of the
    influence, hundreds of images among them, are added up once for a source, and every evaluation costs a short series
    in m in their place. What is far away depends on its half-width: see `keep_up`.

    Attributes
    ----------
    first, beyond : ndarray of int, shape (terms + faces, n)
        The places that are not far from a term of a source: from ``first`` to before ``beyond``. After the terms of the
        kernel, those for which a free side face is near.
    powers : ndarray, shape (n, 1 + POWERS, n)
        Of each source, at each place: the logarithm of the far edge over the near one, and the differences of
        ``1 / y'^2k`` between the edges [mm^-2k], weighted and added up over all terms that are far.
    limits : ndarray, shape (n,)
        The largest m [mm^2] of each source for which this holds; 0 where it has not been worked out.
    """

    first: Indices
    beyond: Indices
    powers: Array
    limits: Array


@compiled
def blank_remote(n: int, kernel: Kernel) -> Remote:
    """Return room for what ``n`` strips do far away."""
    sums = kernel.terms.shape[0] + kernel.faces.shape[0]
    first, beyond = np.zeros((sums, n), np.int64), np.zeros((sums, n), np.int64)
    return Remote(first, beyond, np.empty((n, 1 + POWERS, n)), np.zeros(n))


@compiled
def remote_of(strips: Strips, kernel: Kernel, m: Array) -> Remote:
    """Return what strips with these m [mm^2] do far away."""
    remote = blank_remote(strips.y.size, kernel)
    keep_up(strips, kernel, m, remote)
    return remote


@compiled
def keep_up(strips: Strips, kernel: Kernel, m: Array, remote: Remote) -> None:
    """Work out what those strips do far away that are wider than it holds for, as all in contact are at first."""
    n = strips.y.size
    wider, some = np.empty(n, np.bool_), False
    for j in range(n):
        wider[j] = m[j] > remote.limits[j]
        some = some or wider[j]
    if not some:
        return
    for j in range(n):
        if wider[j]:
            remote.limits[j], remote.powers[j] = ROOM * m[j], 0.0
    for k in range(kernel.terms.shape[0]):
        _add_far_term(strips, kernel.terms[k], wider, remote, k)
    for k in range(kernel.faces.shape[0]):
        _add_beyond_face(strips, kernel.faces[k], kernel.face_tables, wider, remote, kernel.terms.shape[0] + k)


@inlined
def _add_far_term(strips: Strips, term: Array, wider: Flags, remote: Remote, at: int) -> None:
    """Add a term where it is far from its source, and fill in where it is not."""
    y, n = strips.y, strips.y.size
    sign, offset, weight = term[0], term[1], term[2]
    distance, work = np.empty(n), np.empty((4, n))
    for j in range(n):
        if not wider[j]:
            continue
        low, high = sign * strips.low[j] + offset, sign * strips.high[j] + offset
        left, right, width = min(low, high), max(low, high), strips.high[j] - strips.low[j]
        reach = REMOTE * math.sqrt(remote.limits[j])
        before = 0
        while before < n and y[before] <= left - reach:
            before += 1
        after = before
        while after < n and y[after] < right + reach:
            after += 1
        remote.first[at, j], remote.beyond[at, j] = before, after
        for i in range(before):
            distance[i] = left - y[i]
        for i in range(after, n):
            distance[i] = y[i] - right
        for begin, end in ((0, before), (after, n)):
            _add_far(remote.powers[j], begin, end, distance, width, weight, work)


@inlined
def _add_beyond_face(strips: Strips, face: Array, tables: Array, wider: Flags, remote: Remote, at: int) -> None:
    """Add what a free side face adds where it is far from place and source together, and fill in where it is not."""
    n, place, side, weight, table = strips.y.size, face[0], face[1], face[2], int(face[3])
    u, terms, work = np.empty(n), np.empty((2, 1 + POWERS, n + TILE)), np.empty((2, n + TILE))
    for i in range(n):
        u[i] = max(side * (place - strips.y[i]), 0.0)
    for j in range(n):
        if not wider[j]:
            continue
        of_low, of_high = max(side * (place - strips.low[j]), 0.0), max(side * (place - strips.high[j]), 0.0)
        low, high = terms[j % 2], terms[1 - j % 2]
        # From one strip to the next the edge between them is the same.
        if j == 0 or not wider[j - 1]:
            far_terms(u, of_low, tables, table, low, work)
        far_terms(u, of_high, tables, table, high, work)
        inner, outer = min(of_low, of_high), max(of_low, of_high)
        begin, end, away = 0, 0, AWAY * math.sqrt(remote.limits[j])
        for i in range(n):
            if u[i] + inner < away:
                begin, end = (i if end == 0 else begin), i + 1
        remote.first[at, j], remote.beyond[at, j] = begin, end
        powers = remote.powers[j]
        for k in range(1 + POWERS):
            _add_difference(powers[k][:begin], side * weight, low[k][:begin], high[k][:begin])
            _add_difference(powers[k][end:], side * weight, low[k][end:n], high[k][end:n])
        for i in range(n):
            if inner <= u[i] < outer and not begin <= i < end:
                for k in range(1 + POWERS):
                    powers[k, i] += weight * far_whole(u[i], k, tables, table)


@compiled
def _add_difference(power: Array, weight: float, of_low: Array, of_high: Array) -> None:
    for i in range(power.size):
        power[i] += weight * (of_low[i] - of_high[i])


@compiled
def _add_far(
    powers: Array, first: int, beyond: int, distances: Array, width: float, weight: float, work: Array
) -> None:
    """Add what a source does at some places, at these distances from its nearer edge, in loops that vectorise."""
    distance, logarithm = distances[first:beyond], powers[0][first:beyond]
    inner, outer = work[0][first:beyond], work[1][first:beyond]
    inner_power, outer_power = work[2][first:beyond], work[3][first:beyond]
    n, nearest = distance.size, np.inf
    for i in range(n):
        nearest = min(nearest, distance[i])
    if width < SHORT * nearest:
        for i in range(n):
            # ln(far / near) = 2 artanh(width / (far + near)), by its series
            z = width / (2.0 * distance[i] + width)
            x = z * z
            later = 1.0 / 9.0 + x * (1.0 / 11.0 + x * (1.0 / 13.0 + x * (1.0 / 15.0 + x / 17.0)))
            series = 1.0 + x * (1.0 / 3.0 + x * (0.2 + x * (1.0 / 7.0 + x * later)))
            logarithm[i] += 2.0 * weight * z * series
    else:
        for i in range(n):
            logarithm[i] += weight * math.log1p(width / distance[i])
    for i in range(n):
        nearer, farther = distance[i], distance[i] + width
        inverse = 1.0 / (nearer * farther)
        of_inner, of_outer = farther * inverse, nearer * inverse
        inner[i], outer[i] = of_inner * of_inner, of_outer * of_outer
        inner_power[i] = outer_power[i] = weight
    for k in range(1, 1 + POWERS):
        power = powers[k][first:beyond]
        for i in range(n):
            inner_power[i] *= inner[i]
            outer_power[i] *= outer[i]
            power[i] += outer_power[i] - inner_power[i]


@inlined
def coefficients(strips: Strips, m: Array, active: Indices, kernel: Kernel, remote: Remote, out: Array) -> None:
    """Fill ``out[:, i, j]`` with [A], [t A'], [B], [t B'] of the j-th active strip at the centre of strip i.

    Parameters
    ----------
    strips : Strips
        All strips.
    m : ndarray, shape (n,)
        Squared half-widths [mm^2].
    active : ndarray of int, shape (k,)
        The strips that take part.
    kernel : Kernel
        How they act.
    remote : Remote
        How they act far away.
    out : ndarray, shape (4, n, k)
        Result.
    """
    n = strips.y.size
    seen, kept = np.empty((4, n)), no_squares()
    for j in range(active.size):
        source = active[j]
        _seen_from(strips, source, m[source], kernel, remote, seen, kept)
        for kind in range(4):
            for i in range(n):
                out[kind, i, j] = seen[kind, i]
        if strips.at_depth.size:
            for i in range(n):
                out[0, i, j] -= strips.at_depth[i, source]


@compiled
def _seen_from(strips: Strips, source: int, m: float, kernel: Kernel, remote: Remote, seen: Array, kept: Array) -> None:
    """Fill [A], [t A'], [B], [t B'] of one source at the centres of all strips, points at depth left out."""
    y, table, inverse = strips.y, kernel.table, 1.0 / math.sqrt(m)
    _from_afar(remote.powers[source], m, table, seen)
    for k in range(kernel.terms.shape[0]):
        sign, offset = kernel.terms[k, 0], kernel.terms[k, 1]
        weight = sign * kernel.terms[k, 2]
        high, low = sign * strips.high[source] + offset, sign * strips.low[source] + offset
        for i in range(remote.first[k, source], remote.beyond[k, source]):
            a1, ta1, b1, tb1 = evaluate((high - y[i]) * inverse, table)
            a0, ta0, b0, tb0 = evaluate((low - y[i]) * inverse, table)
            seen[0, i] += weight * (a1 - a0)
            seen[1, i] += weight * (ta1 - ta0)
            seen[2, i] += weight * (b1 - b0)
            seen[3, i] += weight * (tb1 - tb0)
    for k in range(kernel.faces.shape[0]):
        weight, at = kernel.faces[k, 2], kernel.terms.shape[0] + k
        for i in range(remote.first[at, source], remote.beyond[at, source]):
            a, ta, b, tb = added_by_face(y[i], strips.low[source], strips.high[source], inverse, kernel, k, kept)
            seen[0, i] += weight * a
            seen[1, i] += weight * ta
            seen[2, i] += weight * b
            seen[3, i] += weight * tb
    own, slope = by_own_width(strips.by_width, source, 1.0 / inverse)
    seen[0, source] += own
    seen[1, source] -= slope


@compiled
def by_own_width(by_width: Array, strip: int, a: float) -> tuple[float, float]:
    """Return what its half-width changes in [A] of a strip on itself, and a times the derivative of that."""
    logarithmic = by_width[2, strip]
    if logarithmic == 0.0:  # a flat surface
        return 0.0, 0.0
    linear, square = by_width[1, strip], logarithmic * math.log(a) + by_width[3, strip]
    return by_width[0, strip] + a * (linear + a * square), a * (linear + a * (2.0 * square + logarithmic))


@compiled
def _from_afar(powers: Array, m: float, table: Array, seen: Array) -> None:
    """Fill [A], [t A'], [B], [t B'] of what one source does far away."""
    for i in range(powers.shape[1]):
        seen[0, i] = powers[0, i]
        seen[1, i] = seen[2, i] = seen[3, i] = 0.0
    power = 1.0
    for k in range(1, 1 + POWERS):
        power *= m
        a, b = power * table[POWERS_AT + 2 * k - 2], power * table[POWERS_AT + 2 * k - 1]
        ta, tb = -2.0 * k * a, -2.0 * k * b
        for i in range(powers.shape[1]):
            seen[0, i] += a * powers[k, i]
            seen[1, i] += ta * powers[k, i]
            seen[2, i] += b * powers[k, i]
            seen[3, i] += tb * powers[k, i]


@inlined
def lift(strips: Strips, m: Array, q: Array, kernel: Kernel, remote: Remote, out: Array) -> None:
    """Fill in the displacement per unit of compliance at strip centres, relative to the points at depth.

    Parameters
    ----------
    strips, m, kernel, remote
        As for `coefficients`.
    q : ndarray, shape (n,)
        Loads K q [mm].
    out : ndarray, shape (n,)
        Result.
    """
    n = strips.y.size
    seen, kept = np.empty((4, n)), no_squares()
    for i in range(n):
        out[i] = 0.0
    for j in range(n):
        if m[j] > 0.0:
            _seen_from(strips, j, m[j], kernel, remote, seen, kept)
            for i in range(n):
                out[i] += q[j] * seen[0, i]
    if strips.at_depth.size:
        for i in range(n):
            for j in range(n):
                out[i] -= strips.at_depth[i, j] * q[j]


@compiled
def added_by_face(y: float, low: float, high: float, inverse: float, kernel: Kernel, k: int, kept: Array) -> Four:
    """Return what a free side face adds to [A], [t A'], [B] and [t B'] at ``y`` of one strip with 1/a = ``inverse``.

    ``kept`` as for `nonhertz.strip.free_end.free_end`.
    """
    place, side, first = kernel.faces[k, 0], kernel.faces[k, 1], int(kernel.faces[k, 3])
    u = max(side * (place - y), 0.0) * inverse
    one, other = side * (place - low) * inverse, side * (place - high) * inverse
    inner, outer = max(min(one, other), 0.0), max(one, other, 0.0)
    return free_end(u, inner, outer, kernel.face_tables, first, kernel.table, kept)


def kernel_of(influence: Influence, element: Element) -> Kernel:
    """Return how strips act, for the compiled core."""
    materials = sorted({face.poisson for face in influence.faces})
    tables = [free_end_table(element, poisson) for poisson in materials]
    faces = [(face.y, face.side, face.share, TABLE_SIZE * materials.index(face.poisson)) for face in influence.faces]
    # One table is long enough to be copied for nothing. It is stored and read-only: none or several are, too, since all
    # that reads them would be compiled again for arrays that can be written to.
    table = tables[0].view() if len(tables) == 1 else np.concatenate([np.zeros(0), *tables])
    table.flags.writeable = False
    rows = np.array(faces, dtype=float).reshape(-1, 4)
    return Kernel(influence.terms, element.table, element.line_factor, element.hertz_ratio, rows, table)


def displacements(influence: Influence, y: Array, edges: Array, r: Array, m: Array, element: Element) -> Array:
    """Return the displacement per unit of compliance at several places ``y``, relative to the points at depth."""
    at_depth: Array = influence.at_depth(y, edges) @ (r * m)
    places, ends, load, square = map(plain_array, (y, edges, r, m))
    by_width = influence.by_width(0.5 * (edges[1:] + edges[:-1]), element.hertz_ratio)
    return _on_the_surface(places, ends, load, square, kernel_of(influence, element), by_width) - at_depth


@compiled
def _on_the_surface(places: Array, edges: Array, r: Array, m: Array, kernel: Kernel, by_width: Array) -> Array:
    result, kept = np.zeros(places.size), no_squares()
    for j in range(m.size):
        if m[j] > 0.0:
            inverse, q, low, high = 1.0 / math.sqrt(m[j]), r[j] * m[j], edges[j], edges[j + 1]
            for i in range(places.size):
                within = low <= places[i] < high or (j == m.size - 1 and places[i] == high)
                seen = by_own_width(by_width, j, math.sqrt(m[j]))[0] if within else 0.0
                for k in range(kernel.terms.shape[0]):
                    sign, offset = kernel.terms[k, 0], kernel.terms[k, 1] - places[i]
                    upper = evaluate((sign * high + offset) * inverse, kernel.table)[0]
                    lower = evaluate((sign * low + offset) * inverse, kernel.table)[0]
                    seen += sign * kernel.terms[k, 2] * (upper - lower)
                for k in range(kernel.faces.shape[0]):
                    seen += kernel.faces[k, 2] * added_by_face(places[i], low, high, inverse, kernel, k, kept)[0]
                result[i] += q * seen
    return result


@compiled
def self_displacement(width: float, m: float, table: Array) -> tuple[float, float]:
    """Return [A] of a strip at its own centre and d(m [A])/dm."""
    a, ta, _, _ = evaluate(0.5 * width / math.sqrt(m), table)
    return 2.0 * a, 2.0 * a - ta
