"""Contacts on given strips, solved one after the other in one compiled loop: one case is a batch of one.

Where the Newton loop fails from one start, the next is tried: the case before, if it is similar and on the same strips;
the solution on another grid; springs; then, if ``patient``, springs with r and m stepped together, springs with
shortened steps, and finally the load raised in steps from a small one.
"""

from __future__ import annotations

import math

import numpy as np

from nonhertz.compiled import compiled, inlined
from nonhertz.strip.influence import Remote, remote_of
from nonhertz.strip.newton import TOLERANCE, newton
from nonhertz.strip.records import (
    CONVERGED,
    STAGNATED,
    Array,
    BoundaryConditions,
    Grids,
    Kernel,
    NewtonOptions,
    States,
    Strips,
    Unknowns,
)
from nonhertz.strip.start import prolong, winkler_start

NEARBY = 0.1  # relative change up to which the previous case serves as the start
LEAST_RISE = 1e-3  # of the load: a smaller increment is not attempted
# Depths in half-widths of independent springs, which may be half of the true ones where bodies are thin. Below the
# first no loop is started, below the second a failed start is not retried, below the third a failure is blamed on the
# thin body.
HOPELESS, BEYOND_HELP, SCARCELY = 0.7, 2.0, 4.0
RISES = 40
# Up to so many strips all starts are tried. On more, a step costs the cube of the strips, and on 2,000 some seconds: no
# other start is tried once those that failed have cost so many steps on the first, nor is the load raised.
PATIENT_STRIPS, RETRIED = 400, 360
# Starts, in the order in which they are tried.
BEFORE, NEAR, SPRINGS, TOGETHER, SHORTENED, RAISED, STARTS = range(7)


@compiled
def solve_on_strips(
    grids: Grids,
    prescribed: BoundaryConditions,
    kernel: Kernel,
    near: States,
    found: States,
    tolerance: float,
    patient: bool,
) -> None:
    """Solve every case on its strips, overwriting ``found``.

    Parameters
    ----------
    grids : Grids
        The strips of every case, or one grid for all.
    prescribed : BoundaryConditions
        What is prescribed; ``target`` has a row per case.
    kernel : Kernel
        How strips act.
    near : States
        Solutions on other strips, where they have converged; no rows if there are none.
    found : States
        Result, a row per case.
    tolerance : float
        Largest relative residual of a solution.
    patient : bool
        Whether to try hard.
    """
    for case in range(prescribed.target.shape[0]):
        row = 0 if grids.counts.size == 1 else case
        strips, min_depth = strips_of(grids, row), grids.min_depth[row]
        conditions, n = BoundaryConditions(prescribed.by_force, prescribed.target[case]), strips.y.size
        if not within_reach(strips, conditions):
            continue
        unknowns, trial = unknowns_of(found, case, n), blank_unknowns(n)
        status, steps, residual, spent = STAGNATED, 0, np.inf, 0.0
        for start in range(STARTS if patient else TOGETHER):
            if n > PATIENT_STRIPS and (spent > RETRIED or start == RAISED):
                break
            if start == BEFORE:
                # On the way to a grid of its own a case depends on no other.
                possible = grids.counts.size == 1 and tolerance == TOLERANCE and case > 0
                possible = possible and _from_before(strips, prescribed, found, case, trial)
            elif start == NEAR:
                possible = near.status.size > 0 and near.status[case] == CONVERGED
                possible = possible and _from_near(strips, conditions, near, case, trial)
            else:
                winkler_start(strips, conditions, kernel, trial)
                possible = start < SHORTENED or not too_thin(min_depth, kernel, trial.m, BEYOND_HELP)
                possible = possible and (start < RAISED or conditions.by_force[0])
            if not possible:
                continue
            options = NewtonOptions(
                tolerance if start < RAISED else TOLERANCE, 0.5 if start == SHORTENED else 1.0, start != TOGETHER, False
            )
            # In this one place alone: wherever else the loop was called, it would be compiled again.
            again, more, left = loop(strips, conditions, kernel, trial, min_depth, options, start == RAISED)
            spent += more * (n / PATIENT_STRIPS) ** 3
            if start <= SPRINGS or again == CONVERGED or left < residual:
                take(trial, unknowns)
                status, steps, residual = again, more, left
            if status == CONVERGED:
                break
        found.status[case], found.steps[case], found.residual[case] = status, steps, residual


@compiled
def _from_before(strips: Strips, prescribed: BoundaryConditions, found: States, case: int, unknowns: Unknowns) -> bool:
    """Begin where the case before ended; return whether it is similar enough."""
    target, before, by_force = prescribed.target[case], prescribed.target[case - 1], prescribed.by_force
    previous = unknowns_of(found, case - 1, strips.y.size)
    half, scale = 0.5 * (strips.high[-1] - strips.low[0]), abs(target[1])
    if not by_force[1]:
        scale = abs(previous.rigid[0]) / half
    elif by_force[0]:
        scale = target[0] * half
    near_first = abs(target[0] - before[0]) <= NEARBY * abs(target[0])
    near_second = abs(target[1] - before[1]) <= NEARBY * scale
    if found.status[case - 1] != CONVERGED or not (near_first and near_second):
        return False
    take(previous, unknowns)
    for k in range(2):
        unknowns.rigid[k] = previous.rigid[k] if by_force[k] else target[k]
    return True


@inlined
def _from_near(strips: Strips, conditions: BoundaryConditions, near: States, case: int, unknowns: Unknowns) -> bool:
    """Begin with the solution on other strips; return whether any strip is in contact."""
    row = 0 if near.edges.shape[0] == 1 else case
    count = near.counts[row]
    y = np.empty(count)
    for i in range(count):
        y[i] = 0.5 * (near.edges[row, i + 1] + near.edges[row, i])
    return prolong(y, unknowns_of(near, case, count), strips, conditions, unknowns)


@inlined
def loop(
    strips: Strips,
    prescribed: BoundaryConditions,
    kernel: Kernel,
    unknowns: Unknowns,
    min_depth: Array,
    options: NewtonOptions,
    raised: bool,
) -> tuple[int, int, float]:
    """Run the Newton loop from where ``unknowns`` stands, unless a body is thinner there than its contact is wide.

    If the load is to be ``raised``, it runs from springs under a small one, and on in steps as large as it allows. A
    state that converged only at a share of the load is not a solution and is not marked as one.
    """
    reached, share, steps = 0.0, 0.01 if raised else 1.0, 0
    last, conditions = blank_unknowns(unknowns.m.size), BoundaryConditions(prescribed.by_force, np.empty(2))
    for _ in range(RISES if raised else 1):
        for k in range(2):
            conditions.target[k] = share * prescribed.target[k] if prescribed.by_force[k] else prescribed.target[k]
        if reached > 0.0:
            take(last, unknowns)
        elif raised:
            winkler_start(strips, conditions, kernel, unknowns)
        for i in range(unknowns.m.size):
            unknowns.gap[i] = 0.0
        for i in range(4):
            unknowns.stiffness[i // 2, i % 2] = 0.0
        status, steps, residual = STAGNATED, 0, np.inf
        if not too_thin(min_depth, kernel, unknowns.m, HOPELESS):
            remote, resultant = remote_of(strips, kernel, unknowns.m), np.empty(2)
            status, steps, residual = newton(strips, conditions, kernel, unknowns, options, remote, resultant)
        if not raised or (status == CONVERGED and share == 1.0):
            return status, steps, residual
        if share - reached < LEAST_RISE:
            break
        if status == CONVERGED:
            take(unknowns, last)
            reached, share = share, min(1.0, 2.0 * share)
        else:
            share = 0.5 * (reached + share)
    return STAGNATED, steps, np.inf


@compiled
def follow(
    grids: Grids,
    prescribed: BoundaryConditions,
    kernel: Kernel,
    remote: Remote,
    found: States,
    answer: Array,
) -> bool:
    """Let a solved case follow another approach and tilt on its strips; return whether it did, else it is unchanged.

    Parameters
    ----------
    grids, kernel
        As for `solve_on_strips`; one row.
    prescribed : BoundaryConditions
        An approach and a tilt, shape (1, 2).
    remote : Remote
        What these strips do far away, from `blank_remote` at first, and kept up.
    found : States
        The solved case, overwritten.
    answer : ndarray, shape (6,)
        Result: K Q, K T and their derivatives by approach and tilt.
    """
    strips, conditions = strips_of(grids, 0), BoundaryConditions(prescribed.by_force, prescribed.target[0])
    n = strips.y.size
    kept, unknowns = unknowns_of(found, 0, n), blank_unknowns(n)
    take(kept, unknowns)
    _foresee(strips, conditions, unknowns)
    if too_thin(grids.min_depth[0], kernel, unknowns.m, HOPELESS):
        return False
    for k in range(2):
        unknowns.rigid[k] = conditions.target[k]
    options = NewtonOptions(TOLERANCE, 1.0, True, True)
    done = newton(strips, conditions, kernel, unknowns, options, remote, answer[:2])[0] == CONVERGED
    if done:
        take(unknowns, kept)
        for k in range(4):
            answer[2 + k] = unknowns.stiffness[k // 2, k % 2]
    return done


@compiled
def _foresee(strips: Strips, prescribed: BoundaryConditions, unknowns: Unknowns) -> None:
    """Change m as springs would, so that strips leave at once where the bodies no longer overlap."""
    touches = False
    for i in range(strips.y.size):
        before = unknowns.rigid[0] + unknowns.rigid[1] * strips.y[i] - strips.separation[i]
        now = prescribed.target[0] + prescribed.target[1] * strips.y[i] - strips.separation[i]
        if unknowns.m[i] > 0.0 and before > 0.0:
            touches = touches or now > 0.0
    if not touches:
        return
    for i in range(strips.y.size):
        before = unknowns.rigid[0] + unknowns.rigid[1] * strips.y[i] - strips.separation[i]
        now = prescribed.target[0] + prescribed.target[1] * strips.y[i] - strips.separation[i]
        if unknowns.m[i] > 0.0 and before > 0.0:
            unknowns.m[i] *= min(max(now / before, 0.0), 4.0)


@compiled
def too_thin(min_depth: Array, kernel: Kernel, m: Array, least: float) -> bool:
    """Return whether a body is less than ``least`` half-widths deep.

    Points at a depth comparable to the contact width move more than the surface, and the equations then have
    either no solution or meaningless ones.
    """
    thin = False
    for i in range(m.size):
        thin = thin or min_depth[i] < least * kernel.hertz_ratio * math.sqrt(m[i])
    return thin


@compiled
def blank_unknowns(n: int) -> Unknowns:
    """Return unknowns of ``n`` strips, all zero."""
    return Unknowns(np.zeros(n), np.zeros(n), np.zeros(2), np.zeros(n), np.zeros((2, 2)))


@compiled
def take(other: Unknowns, unknowns: Unknowns) -> None:
    """Overwrite ``unknowns`` with another on the same strips."""
    for i in range(unknowns.m.size):
        unknowns.r[i], unknowns.m[i], unknowns.gap[i] = other.r[i], other.m[i], other.gap[i]
    for k in range(2):
        unknowns.rigid[k] = other.rigid[k]
        for j in range(2):
            unknowns.stiffness[k, j] = other.stiffness[k, j]


@compiled
def strips_of(grids: Grids, row: int) -> Strips:
    """Return the strips of one grid."""
    n = grids.counts[row]
    edges = grids.edges[row]
    return Strips(
        grids.y[row, :n], edges[:n], edges[1 : n + 1], grids.curvature[row, :n], grids.separation[row, :n],
        grids.at_depth[row], grids.by_width[row, :, :n],
    )  # fmt: skip


@compiled
def unknowns_of(states: States, case: int, n: int) -> Unknowns:
    """Return the unknowns of one case on ``n`` strips, as views."""
    return Unknowns(
        states.r[case, :n], states.m[case, :n], states.rigid[case], states.gap[case, :n], states.stiffness[case]
    )


@compiled
def within_reach(strips: Strips, prescribed: BoundaryConditions) -> bool:
    """Return whether the resultant of load and moment lies between the centres of strips that can touch."""
    first, last = -1, -1
    for i in range(strips.y.size):
        if math.isfinite(strips.separation[i]):
            last = i
            first = i if first < 0 else first
    if first < 0:
        return False
    if not (prescribed.by_force[0] and prescribed.by_force[1]):
        return True
    arm = prescribed.target[1] / prescribed.target[0]
    return bool(strips.y[first] <= arm <= strips.y[last])
