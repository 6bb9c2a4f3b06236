"""The one loop: a semi-smooth Newton method for loads and half-widths of all strips at once.

The unknowns are, for each strip, m = a^2 and r = K q / a^2, and for the whole contact the approach and the tilt. In an
elliptical Hertz contact r is constant and m a parabola; both stay bounded where the contact ends, where the
peak pressure of the paper's formulation goes to infinity. For every strip in contact the gap and its
second derivative across vanish on the centre line; a strip out of contact has no load and drops out. Which
strips touch is determined within the loop, as in a primal-dual active set method: a strip whose m would turn
negative leaves, a strip whose gap is negative enters. Because a strip's own effect, m [A](m), is a concave
function through zero, a leaving or entering strip takes the m that satisfies its own equation, which
stops nearly idle strips from oscillating in and out.

The curvature rows are linear in r. Every step first solves them for r at the current m, which removes most of the
nonlinearity from the rest, and keeps from that elimination the derivative of r with respect to m: so the step itself is
a system in m alone. The approach and the tilt border it: it is solved for three right-hand sides, the residual and the
two rigid motions, and a 2 x 2 system then serves any of the four pairs of prescribed quantities. The two extra
solutions give the stiffness matrix.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.strip.influence import coefficients, displacement, self_displacement
from nonhertz.strip.linear import blank, padded, solve_in_place, subtract_product

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

CONVERGED, ITERATION_LIMIT, STAGNATED = range(3)

# For a solution, and for one that only serves as the start on the next grid.
TOLERANCE, ROUGH_TOLERANCE = 1e-11, 1e-6
# Once residual and step are this small, the remaining error is the square of the step, and the stiffness is accurate to
# SMALL_STEP.
NEARLY, SMALL_STEP = 1e-8, 1e-5
# The same on the way to a finer grid, where the stiffness is not needed.
ROUGHLY_NEARLY, ROUGHLY_SMALL = 1e-3, 0.1
STEP_LIMIT = 60
LEAST_CHANGE = 0.3  # smallest factor by which r may change in one step; its inverse is the largest
WIDEST = 1e4  # half-width over half the total length of the strips, beyond which the iteration has diverged
# A strip enters only if its overlap exceeds this fraction of the residual; otherwise the active set oscillates.
LET_SETTLE = 0.1


@compiled
def newton(
    y: Array,
    low: Array,
    high: Array,
    curvature: Array,
    separation: Array,
    prescribed: Flags,
    target: Array,
    terms: Array,
    at_depth: Array,
    table: Array,
    r: Array,
    m: Array,
    rigid: Array,
    gap: Array,
    stiffness: Array,
    tolerance: float,
    relaxation: float,
    eager: bool,
) -> tuple[int, int, float]:
    """Solve the contact of strips, starting from ``r``, ``m`` and ``rigid`` and overwriting them.

    Lengths may be in any one unit; loads are multiplied by the compliance K, so that K q has the unit of a
    length and K Q that of its square.

    Parameters
    ----------
    y, low, high, curvature, separation : ndarray, shape (n,)
        Strip centres, edges, 1/rho and h.
    prescribed : ndarray of bool, shape (2,)
        Whether the load (else the approach) and the moment (else the tilt) are prescribed.
    target : ndarray, shape (2,)
        K Q or delta, K T or gamma.
    terms, at_depth, table
        See `nonhertz.strip.influence`.
    r, m : ndarray, shape (n,)
        K q / a^2 and a^2; m = 0 marks a strip out of contact.
    rigid : ndarray, shape (2,)
        Approach and tilt.
    gap : ndarray, shape (n,)
        Result: gap on the centre line.
    stiffness : ndarray, shape (2, 2)
        Result: K d(Q, T) / d(approach, tilt).
    tolerance : float
        Largest relative residual of a solution.
    relaxation : float
        Fraction of each Newton step to take; 1 except as a fallback.
    eager : bool
        Whether the curvature rows are solved for r before every step; true except as a fallback.

    Returns
    -------
    status, steps, residual
        One of CONVERGED, ITERATION_LIMIT, STAGNATED; Newton steps taken; largest relative residual.
    """
    half = 0.5 * (high[-1] - low[0])
    widths = high - low
    nearly, small_step = (ROUGHLY_NEARLY, ROUGHLY_SMALL) if tolerance > TOLERANCE else (NEARLY, SMALL_STEP)
    residual = np.inf
    for step in range(STEP_LIMIT):
        _keep_two(y, widths, prescribed, target, r, m)
        active = np.flatnonzero(m > 0.0)
        if active.size == 0:
            return STAGNATED, step, residual
        k = active.size
        blocks = np.empty((4, k, k))
        coefficients(y, low, high, m, active, terms, at_depth, table, blocks)
        width, ca = widths[active], curvature[active]
        required, follows = _curved(blocks, ca)
        ra, ma = _held(required, r[active]) if eager else r[active], m[active]
        qa = ra * ma
        r[active] = ra
        lever = y[active] / half
        depth = _interference(y, separation, rigid, active)
        scale = np.max(depth)
        if not scale > 0.0:
            scale = abs(rigid[0]) + abs(rigid[1]) * half
        noise = _rounding(separation, rigid, active, half)
        gap_residual = _product(blocks[0], qa) - depth
        weights = qa * width
        load = np.sum(weights)
        moment = np.sum(weights * lever)
        off = _balance_residual(prescribed, target, rigid, load, moment, half)
        _idle_gaps(y, low, high, separation, rigid, r, m, active, terms, at_depth, table, gap)
        reference = target[0] if prescribed[0] else load
        unsettled = worse(
            worse((np.max(np.abs(gap_residual)) - noise) / scale, np.max(np.abs(_product(blocks[2], ra) / ca - 1.0))),
            _relative(off, prescribed, reference),
        )
        residual = worse(unsettled, -(np.min(gap) + noise) / scale)
        # A strip whose m is NaN is not active and appears in no residual.
        if not math.isfinite(residual) or not math.isfinite(np.sum(m)):
            return STAGNATED, step, residual

        d_r, d_q = _directions(blocks, follows, required - ra, ra, ma, gap_residual, lever)
        response = _border(weights, lever, d_q)
        _store_stiffness(response, half, stiffness)
        if residual < tolerance:
            _finish_gaps(gap_residual, active, gap)
            return CONVERGED, step, residual

        motion = _rigid_step(response, off, prescribed, weights, lever, d_q)
        rho = d_r[:, 0] + motion[0] * d_r[:, 1] + motion[1] * d_r[:, 2]
        sigma = d_q[:, 0] + motion[0] * d_q[:, 1] + motion[1] * d_q[:, 2]
        lost = np.max(m) > (WIDEST * half) ** 2
        if lost or not (np.all(np.isfinite(rho)) and np.all(np.isfinite(sigma))):
            return STAGNATED, step, residual
        rigid[0] += relaxation * motion[0]
        rigid[1] += relaxation * motion[1] / half
        changed = _update(blocks, active, width, rho, sigma, relaxation, table, r, m)
        entered = _enter(widths, curvature, gap, noise + LET_SETTLE * unsettled * scale, active, table, r, m)
        small = max(np.max(np.abs(rho)), np.max(np.abs(sigma - rho))) < small_step
        if residual < nearly and small and not changed and not entered:
            left = _check(y, low, high, separation, prescribed, target, rigid, r, m, terms, at_depth, table, gap)
            if left < tolerance:
                return CONVERGED, step + 1, left
    return ITERATION_LIMIT, STEP_LIMIT, residual


@compiled
def worse(one: float, other: float) -> float:
    """Return the larger of two numbers, or NaN if either is NaN, which the max of Numba or Python may drop."""
    return one if math.isnan(one) or other <= one else other


@compiled
def _interference(y: Array, separation: Array, rigid: Array, active: Indices) -> Array:
    depth: Array = rigid[0] + rigid[1] * y[active] - separation[active]
    return depth


@compiled
def _rounding(separation: Array, rigid: Array, active: Indices, half: float) -> float:
    """Return the rounding error of a gap, the small difference of separation and motion."""
    return 1e-15 * float(abs(rigid[0]) + abs(rigid[1]) * half + np.max(np.abs(separation[active])))


@compiled
def _keep_two(y: Array, width: Array, prescribed: Flags, target: Array, r: Array, m: Array) -> None:
    """Put a neighbour in contact beside a lone strip that must carry load and moment: one strip cannot."""
    if not (prescribed[0] and prescribed[1]):
        return
    active = np.flatnonzero(m > 0.0)
    if active.size != 1:
        return
    alone = active[0]
    arm = target[1] / target[0] - y[alone]
    other = alone + (1 if arm > 0.0 else -1)
    if abs(arm) > 1e-12 * width[alone] and 0 <= other < y.size:
        m[other] = 1e-3 * m[alone]
        r[other] = r[alone]


@compiled
def _balance_residual(prescribed: Flags, target: Array, rigid: Array, load: float, moment: float, half: float) -> Array:
    """Return target minus current approach or load, and tilt or moment; a tilt as the approach it gives at the end."""
    off = np.empty(2)
    off[0] = target[0] - load if prescribed[0] else target[0] - rigid[0]
    off[1] = target[1] / half - moment if prescribed[1] else (target[1] - rigid[1]) * half
    return off


@compiled
def _relative(off: Array, prescribed: Flags, load: float) -> float:
    """Return the largest relative imbalance; a prescribed motion is met exactly after one step."""
    largest = 0.0
    for k in range(2):
        if prescribed[k]:
            largest = worse(largest, abs(off[k]) / load)
    return largest


@compiled
def _settling(
    i: int,
    y: Array,
    low: Array,
    high: Array,
    inverse: Array,
    q: Array,
    active: Indices,
    terms: Array,
    at_depth: Array,
    table: Array,
) -> float:
    """Return the displacement per unit of compliance at the centre of strip ``i``, relative to the points at depth."""
    total = displacement(y[i], low, high, inverse, q, active, terms, table)
    for j in active:
        total -= at_depth[i, j] * q[j]
    return total


@compiled
def _idle_gaps(
    y: Array,
    low: Array,
    high: Array,
    separation: Array,
    rigid: Array,
    r: Array,
    m: Array,
    active: Indices,
    terms: Array,
    at_depth: Array,
    table: Array,
    gap: Array,
) -> None:
    """Fill ``gap`` for the strips out of contact, zero for those in contact."""
    inverse, q = 1.0 / np.sqrt(m), r * m
    for i in range(y.size):
        gap[i] = 0.0
        if not m[i] > 0.0:
            gap[i] = separation[i] - rigid[0] - rigid[1] * y[i]
            if np.isfinite(gap[i]):
                gap[i] += _settling(i, y, low, high, inverse, q, active, terms, at_depth, table)


@compiled
def _curved(blocks: Array, curvature: Array) -> tuple[Array, Array]:
    """Return the r that satisfy the curvature rows, and F = d r / d (r mu), mu being the relative changes of m.

    F is left where it was solved for: in a larger array, from column ``padded(k)`` onwards.
    """
    k = curvature.size
    equations = blank(k, k + 1)
    at = padded(k)
    for i in range(k):
        for j in range(k):
            equations[i, j] = blocks[2, i, j]
            equations[i, at + j] = 0.5 * blocks[3, i, j]
        equations[i, at + k] = curvature[i]
    solve_in_place(equations)
    return equations[:k, at + k].copy(), equations


@compiled
def _held(required: Array, r: Array) -> Array:
    """Return ``required``, limited to a factor of ``r``: far from the solution it may not even be positive."""
    held: Array = np.minimum(np.maximum(required, LEAST_CHANGE * r), r / LEAST_CHANGE)
    return held


@compiled
def _product(matrix: Array, vector: Array) -> Array:
    result = np.empty(matrix.shape[0])
    for i in range(result.size):
        total = 0.0
        for j in range(vector.size):
            total += matrix[i, j] * vector[j]
        result[i] = total
    return result


@compiled
def _directions(
    blocks: Array, follows: Array, missing: Array, r: Array, m: Array, gap_residual: Array, lever: Array
) -> tuple[Array, Array]:
    """Return relative changes of r and of q for the residual and both rigid motions, shape (k, 3) each.

    With v = r mu the gap rows are [A] m (missing + F v) + ([A] - [t A'] / 2) m v = sides, F being how r ``follows``.
    """
    k, at = r.size, padded(r.size)
    equations, loaded = blank(k, 3), np.zeros((at, at))
    for i in range(k):
        for j in range(k):
            loaded[i, j] = -blocks[0, i, j] * m[j]
            equations[i, j] = (blocks[0, i, j] - 0.5 * blocks[1, i, j]) * m[j]
    subtract_product(equations, loaded, follows, at)
    # Clear what the product left in the padding, so that it stays decoupled.
    equations[:, k:at] = 0.0
    for i in range(k, at):
        equations[i, i] = 1.0
    equations[:k, at] = _product(loaded[:k], missing) - gap_residual
    equations[:k, at + 1] = 1.0
    equations[:k, at + 2] = lever
    solve_in_place(equations)
    d_r, d_q = np.empty((k, 3)), np.empty((k, 3))
    for i in range(k):
        one, two, three = missing[i], 0.0, 0.0
        for j in range(k):
            one += follows[i, at + j] * equations[j, at]
            two += follows[i, at + j] * equations[j, at + 1]
            three += follows[i, at + j] * equations[j, at + 2]
        d_r[i, 0], d_r[i, 1], d_r[i, 2] = one / r[i], two / r[i], three / r[i]
        for side in range(3):
            d_q[i, side] = d_r[i, side] + equations[i, at + side] / r[i]
    return d_r, d_q


@compiled
def _border(weights: Array, lever: Array, d_q: Array) -> Array:
    """Return d(load, moment / half) / d(approach, tilt half)."""
    response = np.empty((2, 2))
    for k in range(2):
        response[0, k] = np.sum(weights * d_q[:, k + 1])
        response[1, k] = np.sum(weights * lever * d_q[:, k + 1])
    return response


@compiled
def _store_stiffness(response: Array, half: float, stiffness: Array) -> None:
    stiffness[0, 0] = response[0, 0]
    stiffness[0, 1] = response[0, 1] * half
    stiffness[1, 0] = response[1, 0] * half
    stiffness[1, 1] = response[1, 1] * half * half


@compiled
def _rigid_step(response: Array, off: Array, prescribed: Flags, weights: Array, lever: Array, d_q: Array) -> Array:
    """Return the changes of approach and of tilt times half length that meet the prescribed pair."""
    matrix = np.array([[1.0, 0.0], [0.0, 1.0]])
    side = off.copy()
    # A single strip has no stiffness against tilt, like a ball: a tiny addition to the diagonal leaves its tilt alone.
    ridge = 1e-14 * abs(response[0, 0])
    if prescribed[0]:
        matrix[0] = response[0]
        matrix[0, 0] += ridge
        side[0] -= np.sum(weights * d_q[:, 0])
    if prescribed[1]:
        matrix[1] = response[1]
        matrix[1, 1] += ridge
        side[1] -= np.sum(weights * lever * d_q[:, 0])
    determinant = matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0]
    motion = np.empty(2)
    motion[0] = (side[0] * matrix[1, 1] - side[1] * matrix[0, 1]) / determinant
    motion[1] = (side[1] * matrix[0, 0] - side[0] * matrix[1, 0]) / determinant
    return motion


@compiled
def _update(
    blocks: Array,
    active: Indices,
    width: Array,
    rho: Array,
    sigma: Array,
    relaxation: float,
    table: Array,
    r: Array,
    m: Array,
) -> bool:
    """Apply relative steps ``rho`` of r and ``sigma`` of q; return whether a strip left or was held back."""
    changed = False
    for k in range(active.size):
        i = active[k]
        mu = relaxation * (sigma[k] - rho[k])
        old_r, old_m = r[i], m[i]
        r[i] = old_r * min(max(1.0 + relaxation * rho[k], LEAST_CHANGE), 1.0 / LEAST_CHANGE)
        if mu > 15.0:
            changed = True
            m[i] = 16.0 * old_m
        elif mu < -0.9:
            changed = True
            required = blocks[0, k, k] * (1.0 + relaxation * sigma[k]) - 0.5 * blocks[1, k, k] * mu
            m[i] = _own_width(old_m * required * old_r / r[i], width[k], table) if required > 0.0 else 0.0
        else:
            m[i] = old_m * (1.0 + mu)
    return changed


@compiled
def _enter(
    width: Array, curvature: Array, gap: Array, overlap: float, active: Indices, table: Array, r: Array, m: Array
) -> bool:
    """Put strips with more than this ``overlap`` in contact, with r from the nearest strip in contact."""
    entered = False
    for i in range(gap.size):
        if gap[i] < -overlap:
            entered = True
            nearest = active[np.argmin(np.abs(active - i))]
            r[i] = r[nearest] * curvature[i] / curvature[nearest]
            m[i] = _own_width(-gap[i] / r[i], width[i], table)
    return entered


@compiled
def _own_width(required: float, width: float, table: Array) -> float:
    """Return m with m [A](m) = ``required``, by Newton's method on a concave increasing function."""
    m = 0.25 * required
    for _ in range(40):
        value, slope = self_displacement(width, m, table)
        better = max(m - (m * value - required) / slope, 0.05 * m)
        if abs(better - m) < 1e-6 * m:
            return better
        m = better
    return m


@compiled
def _finish_gaps(gap_residual: Array, active: Indices, gap: Array) -> None:
    for k in range(active.size):
        gap[active[k]] = gap_residual[k]


@compiled
def _check(
    y: Array,
    low: Array,
    high: Array,
    separation: Array,
    prescribed: Flags,
    target: Array,
    rigid: Array,
    r: Array,
    m: Array,
    terms: Array,
    at_depth: Array,
    table: Array,
    gap: Array,
) -> float:
    """Fill ``gap`` everywhere and return the largest relative violation of contact and balance."""
    half = 0.5 * (high[-1] - low[0])
    active = np.flatnonzero(m > 0.0)
    depth = _interference(y, separation, rigid, active)
    _idle_gaps(y, low, high, separation, rigid, r, m, active, terms, at_depth, table, gap)
    worst = worse(-np.min(gap), 0.0)
    inverse, q = 1.0 / np.sqrt(m), r * m
    for k in range(active.size):
        i = active[k]
        gap[i] = _settling(i, y, low, high, inverse, q, active, terms, at_depth, table) - depth[k]
        worst = worse(worst, abs(gap[i]))
    loads = r[active] * m[active] * (high - low)[active]
    load = np.sum(loads)
    off = _balance_residual(prescribed, target, rigid, load, np.sum(loads * y[active]) / half, half)
    worst -= _rounding(separation, rigid, active, half)
    return worse(worst / np.max(depth), _relative(off, prescribed, target[0] if prescribed[0] else load))
