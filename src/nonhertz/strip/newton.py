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

Everything below is written in loops: the compiler makes the same of them as of array expressions, in a tenth of the
time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from nonhertz.compiled import compiled, inlined
from nonhertz.strip.influence import Remote, coefficients, keep_up, lift, self_displacement
from nonhertz.strip.linear import blank, padded, solve_in_place, subtract_product
from nonhertz.strip.records import (
    CONVERGED,
    ITERATION_LIMIT,
    STAGNATED,
    Array,
    BoundaryConditions,
    Flags,
    Indices,
    Kernel,
    NewtonOptions,
    Strips,
    Unknowns,
)

# For a solution, and for one that only serves as the start on the next grid.
TOLERANCE, ROUGH_TOLERANCE = 1e-11, 1e-6
# Once residual and step are this small, the remaining error is the square of the step, and the stiffness is accurate to
# SMALL_STEP.
NEARLY, SMALL_STEP = 1e-8, 1e-5
# The same on the way to a finer grid, where the stiffness is not needed.
ROUGHLY_NEARLY, ROUGHLY_SMALL = 1e-3, 0.1
# Steps from nothing, and where a contact follows another approach and tilt.
STEP_LIMIT, FOLLOWING = 60, 12
LEAST_CHANGE = 0.3  # smallest factor by which r may change in one step; its inverse is the largest
WIDEST = 1e4  # half-width over half the total length of the strips, beyond which the iteration has diverged
# A strip enters only if its overlap exceeds this fraction of the residual; otherwise the active set oscillates.
LET_SETTLE = 0.1
# Of a step, while a strip that has left and entered again is far from settled: whole steps would drive it out again.
AFTER_RETURN = 0.5


class _Equations(NamedTuple):
    """The equations of the strips in contact, linearised at a state; arrays have one entry per such strip.

    Attributes
    ----------
    active : ndarray of int
        Their indices among all strips.
    blocks : ndarray, shape (4, n, k)
        Influence coefficients at all strips.
    follows : ndarray
        How r follows m; see `_curved`.
    missing : ndarray
        r that the curvature rows ask for, less the r held.
    r, m, weights, lever, unclosed : ndarray
        r and m; K q times the width; y over half the length; residual of the gap rows.
    off : ndarray, shape (2,)
        Target minus current approach or load, and tilt or moment.
    """

    active: Indices
    blocks: Array
    follows: Array
    missing: Array
    r: Array
    m: Array
    weights: Array
    lever: Array
    unclosed: Array
    off: Array


@compiled
def newton(
    strips: Strips,
    conditions: BoundaryConditions,
    kernel: Kernel,
    unknowns: Unknowns,
    options: NewtonOptions,
    remote: Remote,
    resultant: Array,
) -> tuple[int, int, float]:
    """Solve the contact of strips, starting from the r, m and rigid motion in ``unknowns`` and overwriting it.

    Parameters
    ----------
    strips : Strips
        At least one.
    conditions, kernel, unknowns, options
        See `nonhertz.strip.records`.
    remote : Remote
        What strips do far away, kept up.
    resultant : ndarray, shape (2,)
        Result of a contact that follows: K Q and K T, with what the last step would still add, so that their errors are
        the square of that step.

    Returns
    -------
    status, steps, residual
        One of CONVERGED, ITERATION_LIMIT, STAGNATED; Newton steps taken; largest relative residual.
    """
    half = 0.5 * (strips.high[-1] - strips.low[0])
    rough = options.tolerance > TOLERANCE
    nearly, small_step = (ROUGHLY_NEARLY, ROUGHLY_SMALL) if rough else (NEARLY, SMALL_STEP)
    step, residual, returned, has_left = 0, np.inf, False, np.zeros(unknowns.m.size, np.bool_)
    for step in range(FOLLOWING if options.follows else STEP_LIMIT):
        pair_lone_strip(strips, conditions, unknowns)
        active = touching(unknowns.m)
        if active.size == 0:
            break
        keep_up(strips, kernel, unknowns.m, remote)
        equations, scale, noise, unsettled = _weighed(
            strips, conditions, kernel, remote, unknowns, active, half, options.eager
        )
        residual = worse(unsettled, -(_least(unknowns.gap) + noise) / scale)
        # A strip whose m is NaN is not active and appears in no residual.
        if not math.isfinite(residual) or not math.isfinite(_sum(unknowns.m)):
            break

        d_r, d_q = _directions(equations)
        response = _border(equations, d_q)
        _store_stiffness(response, half, unknowns.stiffness)
        if residual < options.tolerance and not options.follows:
            for k in range(active.size):
                unknowns.gap[active[k]] = equations.unclosed[k]
            return CONVERGED, step, residual

        first, second = _rigid_step(response, conditions, equations, d_q)
        largest = _combine(d_r, d_q, first, second)
        if _widest(unknowns.m) > (WIDEST * half) ** 2 or not math.isfinite(largest):
            break
        if options.follows and residual < nearly and largest < small_step:
            for k in range(2):
                resultant[k] = response[k, 0]
            for k in range(active.size):
                resultant[0] += equations.weights[k]
                resultant[1] += equations.weights[k] * equations.lever[k]
            resultant[1] *= half
            return CONVERGED, step, residual
        relaxation = AFTER_RETURN if returned and residual > ROUGHLY_NEARLY else options.relaxation
        unknowns.rigid[0] += relaxation * first
        unknowns.rigid[1] += relaxation * second / half
        changed = _update(strips, kernel, equations, d_r, d_q, relaxation, unknowns)
        entered = _enter(strips, kernel, active, noise + LET_SETTLE * unsettled * scale, unknowns)
        returned |= _returned(active, unknowns.m, has_left)
        if not options.follows and residual < nearly and largest < small_step and not changed and not entered:
            keep_up(strips, kernel, unknowns.m, remote)
            left = violation(strips, conditions, kernel, remote, unknowns)
            if left < options.tolerance:
                return CONVERGED, step + 1, left
    else:
        return ITERATION_LIMIT, STEP_LIMIT, residual
    return STAGNATED, step, residual


@inlined
def _weighed(
    strips: Strips,
    conditions: BoundaryConditions,
    kernel: Kernel,
    remote: Remote,
    unknowns: Unknowns,
    active: Indices,
    half: float,
    eager: bool,
) -> tuple[_Equations, float, float, float]:
    """Return the equations at a state, the scale and the noise of gaps, and the largest relative residual.

    The gap of idle strips is filled in, and not yet part of it.
    """
    equations, unbent = _linearised(strips, conditions, kernel, remote, unknowns, active, half, eager)
    scale, noise = _scales(strips, unknowns.rigid, active, half)
    _idle_gaps(strips, equations, unknowns)
    unsettled = worse((_largest(equations.unclosed) - noise) / scale, unbent)
    return equations, scale, noise, worse(unsettled, _imbalance(conditions, equations.off, _sum(equations.weights)))


@compiled
def worse(one: float, other: float) -> float:
    """Return the larger of two numbers, or NaN if either is NaN, which the max of Numba or Python may drop."""
    return one if math.isnan(one) or other <= one else other


@compiled
def touching(m: Array) -> Indices:
    """Return the indices of the strips in contact."""
    count = 0
    for i in range(m.size):
        if m[i] > 0.0:
            count += 1
    active = np.empty(count, np.int64)
    count = 0
    for i in range(m.size):
        if m[i] > 0.0:
            active[count] = i
            count += 1
    return active


@compiled
def _largest(values: Array) -> float:
    """Return the largest magnitude, NaN if any is."""
    largest = 0.0
    for i in range(values.size):
        largest = worse(largest, abs(values[i]))
    return largest


@compiled
def _least(values: Array) -> float:
    least = values[0]
    for i in range(values.size):
        least = -worse(-least, -values[i])
    return float(least)


@compiled
def _widest(m: Array) -> float:
    widest = 0.0
    for i in range(m.size):
        widest = worse(widest, m[i])
    return widest


@compiled
def _sum(values: Array) -> float:
    total = 0.0
    for i in range(values.size):
        total += values[i]
    return total


@compiled
def _interference(strips: Strips, rigid: Array, i: int) -> float:
    return float(rigid[0] + rigid[1] * strips.y[i] - strips.separation[i])


@compiled
def _scales(strips: Strips, rigid: Array, active: Indices, half: float) -> tuple[float, float]:
    """Return the deepest interference in contact, and the rounding error of a gap, a difference of large lengths."""
    deepest, longest = -np.inf, 0.0
    for i in active:
        deepest = worse(deepest, _interference(strips, rigid, i))
        longest = worse(longest, abs(strips.separation[i]))
    moved = abs(rigid[0]) + abs(rigid[1]) * half
    return (deepest if deepest > 0.0 else moved), 1e-15 * (moved + longest)


@compiled
def pair_lone_strip(strips: Strips, conditions: BoundaryConditions, unknowns: Unknowns) -> None:
    """Put a neighbour in contact beside a lone strip that must carry load and moment: one strip cannot."""
    if not (conditions.by_force[0] and conditions.by_force[1]):
        return
    r, m = unknowns.r, unknowns.m
    alone, count = 0, 0
    for i in range(m.size):
        if m[i] > 0.0:
            alone, count = i, count + 1
    if count != 1:
        return
    arm = conditions.target[1] / conditions.target[0] - strips.y[alone]
    other = alone + (1 if arm > 0.0 else -1)
    if abs(arm) > 1e-12 * (strips.high[alone] - strips.low[alone]) and 0 <= other < m.size:
        m[other] = 1e-3 * m[alone]
        r[other] = r[alone]


@inlined
def _linearised(
    strips: Strips,
    conditions: BoundaryConditions,
    kernel: Kernel,
    remote: Remote,
    unknowns: Unknowns,
    active: Indices,
    half: float,
    eager: bool,
) -> tuple[_Equations, float]:
    """Return the equations at a state, whose r is brought to the curvature rows, and these rows' largest residual."""
    k = active.size
    blocks = np.empty((4, unknowns.m.size, k))
    coefficients(strips, unknowns.m, active, kernel, remote, blocks)
    follows = _curved(blocks, strips.curvature, active)
    at = padded(k)
    r, m, missing = np.empty(k), np.empty(k), np.empty(k)
    weights, lever, unclosed = np.empty(k), np.empty(k), np.empty(k)
    for i in range(k):
        source = active[i]
        m[i] = unknowns.m[source]
        required, before = follows[i, at + k], unknowns.r[source]
        # Far from the solution it may not even be positive.
        r[i] = min(max(required, LEAST_CHANGE * before), before / LEAST_CHANGE) if eager else before
        if math.isnan(before):
            r[i] = before
        missing[i] = required - r[i]
        unknowns.r[source] = r[i]
        weights[i] = r[i] * m[i] * (strips.high[source] - strips.low[source])
        lever[i] = strips.y[source] / half
    load = moment = unbent = 0.0
    for i in range(k):
        source, lift, bend = active[i], 0.0, 0.0
        for j in range(k):
            lift += blocks[0, source, j] * (r[j] * m[j])
            bend += blocks[2, source, j] * r[j]
        unclosed[i] = lift - _interference(strips, unknowns.rigid, source)
        unbent = worse(unbent, abs(bend / strips.curvature[source] - 1.0))
        load += weights[i]
        moment += weights[i] * lever[i]
    off = _balance(conditions, unknowns.rigid, load, moment, half)
    return _Equations(active, blocks, follows, missing, r, m, weights, lever, unclosed, off), unbent


@compiled
def _balance(conditions: BoundaryConditions, rigid: Array, load: float, moment: float, half: float) -> Array:
    """Return target minus current approach or load, and tilt or moment; a tilt as the approach it gives at the end."""
    off, target = np.empty(2), conditions.target
    off[0] = target[0] - load if conditions.by_force[0] else target[0] - rigid[0]
    off[1] = target[1] / half - moment if conditions.by_force[1] else (target[1] - rigid[1]) * half
    return off


@compiled
def _imbalance(conditions: BoundaryConditions, off: Array, load: float) -> float:
    """Return the largest relative imbalance; a prescribed motion is met exactly after one step."""
    largest = 0.0
    reference = conditions.target[0] if conditions.by_force[0] else load
    for k in range(2):
        if conditions.by_force[k]:
            largest = worse(largest, abs(off[k]) / reference)
    return largest


@inlined
def _idle_gaps(strips: Strips, found: _Equations, unknowns: Unknowns) -> None:
    """Fill the gap of the strips out of contact, zero for those in contact."""
    for i in range(unknowns.m.size):
        # Where the bodies never meet the gap is infinite, whatever the displacement.
        gap = 0.0 if unknowns.m[i] > 0.0 else -_interference(strips, unknowns.rigid, i)
        if not unknowns.m[i] > 0.0 and math.isfinite(gap):
            for j in range(found.r.size):
                gap += found.blocks[0, i, j] * (found.r[j] * found.m[j])
        unknowns.gap[i] = gap


@compiled
def _curved(blocks: Array, curvature: Array, active: Indices) -> Array:
    """Return a system whose solution holds F = d r / d (r mu), mu being the relative changes of m, and r itself.

    r is what satisfies the curvature rows. F begins at column ``padded(k)``, r stands in the column after it.
    """
    k = active.size
    equations = blank(k, k + 1)
    at = padded(k)
    for i in range(k):
        for j in range(k):
            equations[i, j] = blocks[2, active[i], j]
            equations[i, at + j] = 0.5 * blocks[3, active[i], j]
        equations[i, at + k] = curvature[active[i]]
    solve_in_place(equations)
    return equations


@inlined
def _directions(found: _Equations) -> tuple[Array, Array]:
    """Return relative changes of r and of q for the residual and both rigid motions, shape (k, 3) each.

    With v = r mu the gap rows are [A] m (missing + F v) + ([A] - [t A'] / 2) m v = sides, F being how r ``follows``.
    """
    blocks, r, m, missing, follows = found.blocks, found.r, found.m, found.missing, found.follows
    k, at = r.size, padded(r.size)
    equations, loaded = blank(k, 3), np.zeros((at, at))
    for i in range(k):
        for j in range(k):
            own, change = blocks[0, found.active[i], j], blocks[1, found.active[i], j]
            loaded[i, j] = -own * m[j]
            equations[i, j] = (own - 0.5 * change) * m[j]
    subtract_product(equations, loaded, follows, at)
    # Clear what the product left in the padding, so that it stays decoupled.
    for i in range(at):
        for j in range(k, at):
            equations[i, j] = 1.0 if i == j else 0.0
    for i in range(k):
        total = 0.0
        for j in range(k):
            total += loaded[i, j] * missing[j]
        equations[i, at] = total - found.unclosed[i]
        equations[i, at + 1] = 1.0
        equations[i, at + 2] = found.lever[i]
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
def _border(found: _Equations, d_q: Array) -> Array:
    """Return the changes of load and of moment / half, in rows, for the residual and both rigid motions."""
    response = np.zeros((2, 3))
    for i in range(found.weights.size):
        for k in range(3):
            change = found.weights[i] * d_q[i, k]
            response[0, k] += change
            response[1, k] += change * found.lever[i]
    return response


@compiled
def _store_stiffness(response: Array, half: float, stiffness: Array) -> None:
    stiffness[0, 0] = response[0, 1]
    stiffness[0, 1] = response[0, 2] * half
    stiffness[1, 0] = response[1, 1] * half
    stiffness[1, 1] = response[1, 2] * half * half


@compiled
def _rigid_step(response: Array, conditions: BoundaryConditions, found: _Equations, d_q: Array) -> tuple[float, float]:
    """Return the changes of approach and of tilt times half length that meet the prescribed pair."""
    a, b, c, d = 1.0, 0.0, 0.0, 1.0
    first, second = found.off[0], found.off[1]
    # A single strip has no stiffness against tilt, like a ball: a tiny addition to the diagonal leaves its tilt alone.
    ridge = 1e-14 * abs(response[0, 1])
    if conditions.by_force[0]:
        a, b = response[0, 1] + ridge, response[0, 2]
        first -= response[0, 0]
    if conditions.by_force[1]:
        c, d = response[1, 1], response[1, 2] + ridge
        second -= response[1, 0]
    determinant = a * d - b * c
    return (first * d - second * b) / determinant, (second * a - first * c) / determinant


@compiled
def _combine(d_r: Array, d_q: Array, first: float, second: float) -> float:
    """Put the step of r and of q for this motion in the first columns, and return the largest change of r or of m."""
    largest = 0.0
    for i in range(d_r.shape[0]):
        d_r[i, 0] += first * d_r[i, 1] + second * d_r[i, 2]
        d_q[i, 0] += first * d_q[i, 1] + second * d_q[i, 2]
        largest = worse(largest, worse(abs(d_r[i, 0]), abs(d_q[i, 0] - d_r[i, 0])))
    return largest


@compiled
def _update(
    strips: Strips, kernel: Kernel, found: _Equations, d_r: Array, d_q: Array, relaxation: float, unknowns: Unknowns
) -> bool:
    """Apply the relative steps of r and q in the first columns; return whether a strip left or was held back."""
    changed = False
    r, m = unknowns.r, unknowns.m
    for k in range(found.active.size):
        i = found.active[k]
        rho, sigma = d_r[k, 0], d_q[k, 0]
        mu = relaxation * (sigma - rho)
        old_r, old_m = r[i], m[i]
        r[i] = old_r * min(max(1.0 + relaxation * rho, LEAST_CHANGE), 1.0 / LEAST_CHANGE)
        if mu > 15.0:
            changed = True
            m[i] = 16.0 * old_m
        elif mu < -0.9:
            changed = True
            required = found.blocks[0, i, k] * (1.0 + relaxation * sigma) - 0.5 * found.blocks[1, i, k] * mu
            width = strips.high[i] - strips.low[i]
            m[i] = _own_width(old_m * required * old_r / r[i], width, kernel.table) if required > 0.0 else 0.0
        else:
            m[i] = old_m * (1.0 + mu)
    return changed


@compiled
def _enter(strips: Strips, kernel: Kernel, active: Indices, overlap: float, unknowns: Unknowns) -> bool:
    """Put strips with more than this ``overlap`` in contact, with r from the nearest strip in contact."""
    entered = False
    for i in range(unknowns.gap.size):
        if unknowns.gap[i] < -overlap:
            entered = True
            nearest = active[0]
            for j in active:
                if abs(j - i) < abs(nearest - i):
                    nearest = j
            unknowns.r[i] = unknowns.r[nearest] * strips.curvature[i] / strips.curvature[nearest]
            unknowns.m[i] = _own_width(-unknowns.gap[i] / unknowns.r[i], strips.high[i] - strips.low[i], kernel.table)
    return entered


@compiled
def _returned(active: Indices, m: Array, has_left: Flags) -> bool:
    """Mark the ``active`` strips that have left in ``has_left``; return whether one that had left before is back."""
    returned = False
    for i in range(m.size):
        returned |= has_left[i] and m[i] > 0.0
    for i in active:
        has_left[i] |= not m[i] > 0.0
    return returned


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


@inlined
def violation(
    strips: Strips, conditions: BoundaryConditions, kernel: Kernel, remote: Remote, unknowns: Unknowns
) -> float:
    """Fill the gap everywhere and return the largest relative violation of contact and balance."""
    half, n = 0.5 * (strips.high[-1] - strips.low[0]), unknowns.m.size
    q, raised = unknowns.r * unknowns.m, np.empty(n)
    lift(strips, unknowns.m, q, kernel, remote, raised)
    worst, deepest, load, moment = 0.0, -np.inf, 0.0, 0.0
    for i in range(n):
        depth = _interference(strips, unknowns.rigid, i)
        unknowns.gap[i] = raised[i] - depth if math.isfinite(depth) else -depth
        if unknowns.m[i] > 0.0:
            worst = worse(worst, abs(unknowns.gap[i]))
            deepest = worse(deepest, depth)
            carried = q[i] * (strips.high[i] - strips.low[i])
            load += carried
            moment += carried * strips.y[i]
        else:
            worst = worse(worst, -unknowns.gap[i])
    off = _balance(conditions, unknowns.rigid, load, moment / half, half)
    _, noise = _scales(strips, unknowns.rigid, touching(unknowns.m), half)
    return worse((worst - noise) / deepest, _imbalance(conditions, off, load))
