"""Many cases on the same strips, in compiled loops that never return to the interpreter.

The levels are those of a single solve, each taken for all cases before the next. A case starts as it would alone, or
from the solution of the previous case on the same strips where that is closer: along a sweep this saves most
iterations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.strip.acceptance import MET, first_unmet, steady
from nonhertz.strip.newton import CONVERGED, ROUGH_TOLERANCE, STAGNATED, TOLERANCE, newton
from nonhertz.strip.start import started
from nonhertz.strip.state import HOPELESS, Problem, State, Strips

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

NEARBY = 0.1  # relative change up to which the previous case serves as the start


@dataclass(frozen=True)
class States:
    """The states of many cases on one grid: the arrays of `State`, one row per case."""

    edges: Array
    r: Array
    m: Array
    rigid: Array
    gap: Array
    stiffness: Array
    status: Indices
    steps: Indices
    residual: Array

    @classmethod
    def unsolved(cls, edges: Array, cases: int) -> States:
        """Return empty states for that many cases."""
        strips = edges.size - 1
        of_strips = (np.zeros((cases, strips)) for _ in range(3))
        r, m, gap = of_strips
        status, steps = np.full(cases, STAGNATED), np.zeros(cases, dtype=np.int64)
        rigid, stiffness = np.zeros((cases, 2)), np.zeros((cases, 2, 2))
        return cls(edges, r, m, rigid, gap, stiffness, status, steps, np.full(cases, np.inf))

    @classmethod
    def of(cls, state: State) -> States:
        """Return a single state as one row."""
        return cls(state.edges, *(np.asarray(getattr(state, row.name))[None] for row in fields(cls)[1:]))

    def only(self, cases: Indices) -> States:
        """Return the states of some cases."""
        return States(self.edges, *(getattr(self, row.name)[cases] for row in fields(self)[1:]))

    def one(self, case: int) -> State:
        """Return the state of one case."""
        return State(
            self.edges, self.r[case], self.m[case], self.rigid[case], self.gap[case], self.stiffness[case],
            int(self.status[case]), int(self.steps[case]), float(self.residual[case]),
        )  # fmt: skip

    @property
    def converged(self) -> Flags:
        """Whether each case meets every contact condition."""
        converged: Flags = self.status == CONVERGED
        return converged


def settle_all(problem: Problem, grids: Sequence[Array], targets: Array) -> list[States]:
    """Return the states of all cases on every grid.

    Parameters
    ----------
    problem : Problem
        What the cases share; its own target is ignored.
    grids : sequence of ndarray
        Strip edges, finest grid first.
    targets : ndarray, shape (cases, 2)
        As `Problem.target`.

    Returns
    -------
    list of States
        Finest first. Cases that have not converged are left to `settle`, which tries harder or says why they cannot.
    """
    found: list[States] = []
    for strips in reversed(Strips.on(problem, grids)):
        edges = strips.edges
        near = found[0] if found else States.unsolved(np.zeros(1), len(targets))
        near_y = 0.5 * (near.edges[1:] + near.edges[:-1])
        states = States.unsolved(edges, len(targets))
        found.insert(0, states)
        if np.any(np.isnan(strips.separation)) or not np.any(np.isfinite(strips.separation)):
            continue
        _settle_all(
            strips.y, edges[:-1], edges[1:], strips.curvature, strips.separation, strips.at_depth, strips.shallowest,
            problem.influence.terms, problem.element.table, problem.element.line_factor, problem.element.hertz_ratio,
            problem.prescribed, targets, TOLERANCE if edges is grids[0] else ROUGH_TOLERANCE,
            near_y, near.r, near.m, near.rigid, near.status,
            states.r, states.m, states.rigid, states.gap, states.stiffness, states.status, states.steps,
            states.residual,
        )  # fmt: skip
    for states in found:
        for row in fields(states):
            getattr(states, row.name).flags.writeable = row.name == "edges"
    return found


@compiled
def _settle_all(
    y: Array,
    low: Array,
    high: Array,
    curvature: Array,
    separation: Array,
    at_depth: Array,
    shallowest: Array,
    terms: Array,
    table: Array,
    line_factor: float,
    hertz_ratio: float,
    prescribed: Flags,
    targets: Array,
    tolerance: float,
    near_y: Array,
    near_r: Array,
    near_m: Array,
    near_rigid: Array,
    near_status: Indices,
    r: Array,
    m: Array,
    rigid: Array,
    gap: Array,
    stiffness: Array,
    status: Indices,
    steps: Indices,
    residual: Array,
) -> None:
    width = high - low
    half = 0.5 * (high[-1] - low[0])
    nothing = np.empty(0)
    final = tolerance == TOLERANCE
    for case in range(targets.shape[0]):
        target = targets[case]
        if not _within_reach(y, separation, prescribed, target):
            continue
        # Starts in turn, as far as available, until one converges: the previous case, the coarser grid, springs.
        for attempt in range(3):
            if attempt == 0:
                before = case - 1
                if case == 0 or status[before] != CONVERGED:
                    continue
                if not _nearby(prescribed, target, targets[before], rigid[before, 0], half):
                    continue
                r[case], m[case] = r[before], m[before]
                rigid[case] = np.where(prescribed, rigid[before], target)
            else:
                near = near_y if attempt == 1 else nothing
                if attempt == 1 and (near_y.size == 0 or near_status[case] != CONVERGED):
                    continue
                r[case], m[case], rigid[case] = started(
                    y, width, curvature, separation, line_factor, prescribed, target, near, near_r[case],
                    near_m[case], near_rigid[case],
                )  # fmt: skip
            if np.any(shallowest < HOPELESS * hertz_ratio * np.sqrt(m[case])):
                continue
            status[case], steps[case], residual[case] = newton(
                y, low, high, curvature, separation, prescribed, target, terms, at_depth, table, r[case], m[case],
                rigid[case], gap[case], stiffness[case], tolerance, 1.0, True,
            )  # fmt: skip
            if status[case] == CONVERGED and final and not _accepted(
                y, low, high, curvature, separation, prescribed, target, terms, at_depth, table, r[case], m[case],
                gap[case], rigid[case], stiffness[case],
            ):  # fmt: skip
                status[case] = STAGNATED
            if status[case] == CONVERGED:
                break


@compiled
def _accepted(
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
    gap: Array,
    rigid: Array,
    stiffness: Array,
) -> bool:
    """Return whether a converged state passes the final check."""
    condition, _, _ = first_unmet(
        y, low, high, curvature, separation, prescribed, target, terms, at_depth, table, r * m, np.sqrt(m), gap, rigid
    )
    return condition == MET and steady(stiffness, max(abs(low[0]), abs(high[-1])))


@compiled
def _within_reach(y: Array, separation: Array, prescribed: Flags, target: Array) -> bool:
    """Return whether the resultant of load and moment lies between the centres of strips that can touch."""
    if not (prescribed[0] and prescribed[1]):
        return True
    usable = np.flatnonzero(np.isfinite(separation))
    arm = target[1] / target[0]
    return bool(y[usable[0]] <= arm <= y[usable[-1]])


@compiled
def _nearby(prescribed: Flags, target: Array, before: Array, approach: float, half: float) -> bool:
    """Return whether the case ``before``, with its ``approach``, is close enough to this one to be a good start."""
    change = np.abs(target - before)
    scale = abs(target[1])
    if not prescribed[1]:
        scale = abs(approach) / half
    elif prescribed[0]:
        scale = target[0] * half
    return bool(change[0] <= NEARBY * abs(target[0]) and change[1] <= NEARBY * scale)
