"""Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.

The core finds the balance; its method is explained in ``src/core/bearing/balance.hpp`` and docs/explain/equilibrium.md.
Here rollers and their contacts are put together for it, and the states that it returns are arrays.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.laws import OVERLAP, ContactLaw, for_core
from nonhertz.bearing.strips import no_solution_error
from nonhertz.life.lamina import roller_stiffness
from nonhertz.native import core
from nonhertz.solver.refusals import refusal_in_words

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

# What may be left of the balance of the ring, over the loads: strips are exact to 1e-11.
TOLERANCE = 1e-9
STEPS = 80
NO_TILT = 1e-12  # rad: a tilt below this is rounding
NO_LOAD = 1e-8  # of the largest: what is left of the balance of a roller that has lifted off
EDGE = 1e-5  # mm, a motion far below what rollers and raceways depart from their shapes


class States(NamedTuple):
    """States of a bearing, a row each."""

    ring: Array  # motion of the inner ring, (states, 5)
    force: Array  # forces and moments on it that hold it there, (states, 5)
    stiffness: Array  # d(force) / d(ring), (states, 5, 5)
    residual: Array  # what is left of the balance of ring and rollers, over the loads, (states,)
    steps: Indices  # Newton steps of the ring, (states,)
    motion: Array  # of the rollers along x and r [mm] and about the tangent [rad], (states, rollers, 3)
    pose: Array  # approach and tilt of their contacts [mm, rad], (states, rollers, columns, 2)
    answer: Array  # what contacts answer, (states, rollers, columns, ANSWER)

    def portion(self, which: slice | Indices) -> States:
        """Return some of the states, which may be filled in if they are a slice."""
        parts: list[Any] = [values[which] for values in self]
        return States(*parts)

    @property
    def load(self) -> Array:
        """Loads of contacts [N], shape (states, rollers, columns)."""
        return self.answer[..., 0]

    def converged(self, tolerance: float) -> Flags:
        """Return which states are balanced, their loads and motions finite."""
        numbers = np.column_stack([self.ring, self.force, self.load.reshape(len(self.ring), -1)])
        settled: Flags = (self.residual <= tolerance) & np.all(np.isfinite(numbers), axis=1)
        return settled


@dataclass(frozen=True, eq=False)
class Joint:
    """One contact of every roller of a row; those of a roller with the same `core.GroupLaw` are asked together."""

    inner: bool  # whether the other body is the inner ring, which moves; the outer one is at rest
    motion: Array  # approach and tilt per motion of ring against roller, shape (2, 3)
    gap: Array  # what the approach of a centred ring and roller is short of contact [mm], (rollers of the row,)
    law: ContactLaw
    column: int  # which of a roller's contacts it is, from 0
    first: int = 0  # the number of the row's first roller

    @property
    def rollers(self) -> slice:
        """The row's rollers among all."""
        return slice(self.first, self.first + self.gap.size)


@dataclass(frozen=True, eq=False)
class System:
    """Rollers and their contacts."""

    ring: Array  # motion at each roller per motion of the inner ring, shape (rollers, 3, 5)
    joints: tuple[Joint, ...]
    load: Array  # on every roller along x, along r, and its moment [N, N, N mm], (rollers, 3)
    lever: float  # length by which rotations of rollers are made comparable with displacements [mm]

    @property
    def rollers(self) -> int:
        """Their number."""
        return int(self.ring.shape[0])

    @property
    def columns(self) -> int:
        """The most contacts that a roller has."""
        return 1 + max(joint.column for joint in self.joints)

    @cached_property
    def assembly(self) -> core.Assembly:
        """The same for the core."""
        laws = {joint.law: for_core(joint.law) for joint in self.joints}
        joints = [
            core.Joint(joint.inner, joint.motion, joint.gap, laws[joint.law], joint.column, joint.first)
            for joint in self.joints
        ]
        ring, load = self.ring.reshape(-1, 15), np.asarray(self.load, dtype=float)
        return core.Assembly(ring, joints, load, self.lever, roller_stiffness(2.0 * self.lever))


def solve_balance(
    system: System,
    by_force: Flags,
    target: Array,
    start: Array,
    depth: float,
    tolerance: float = TOLERANCE,
    motion: Array | None = None,
    threads: int = 1,
) -> States:
    """Return the states in which ring and rollers are in balance.

    Parameters
    ----------
    system : System
        The rollers.
    by_force : ndarray of bool, shape (5,)
        For which motions of the ring the force or moment is given; for the others, the displacement or rotation.
    target : ndarray, shape (states, 5)
        What is given.
    start : ndarray, shape (states, 5)
        Motions of the ring to begin with.
    depth : float
        A penetration of the size to be expected [mm].
    tolerance : float
        What may be left of the balance of the ring, over the loads; less is asked of rollers.
    motion : ndarray, shape (states, rollers, 3), optional
        Motions of the rollers to begin with; if left out or NaN, those that equal springs would give them.
    threads : int
        How many may work on many states at once, where no law is asked for many contacts.

    Raises
    ------
    InputError
        If a profile is NaN where a contact by strips reaches.
    ConvergenceError
        If a contact has no solution by strips.
    """
    ring = np.where(by_force, start, target)
    begin = np.full((len(ring), system.rollers, 3), np.nan if motion is None else motion).reshape(-1, 3)
    conditions = by_force.tolist(), float(depth), float(tolerance), STEPS
    try:
        states = core.balance(system.assembly, *conditions, target, ring, begin, threads)
    except core.Unsolved as error:
        raise no_solution_error(error) from None
    except core.Refused as refused:  # of contacts on strips
        raise refusal_in_words(refused, math.nan, (math.nan, math.nan)) from None
    assert states is not None  # nobody stops it but by a signal, whose exception passes
    return States(*states)


def find_edge_rollers(system: System, state: States) -> tuple[Indices, Array]:
    """Return the rollers that stand at the edge of the load zone, and what a small motion of the ring finds.

    A roller that just touches both rings without load has no part in the derivatives of the forces, and bears as soon
    as the ring moves towards it.

    Parameters
    ----------
    system : System
        The rollers.
    state : States
        One of them.

    Returns
    -------
    ndarray of int
        Those that bear no load, but do where the ring moves by `EDGE` along x, y or z.
    ndarray, shape (3,)
        The change of force over such a motion, to the side on which it is larger [N/mm]; NaN if there are none.
    """
    load, overlap = state.load[0, :, 0], state.answer[0, :, :2, OVERLAP].sum(axis=1)
    floor, depth = NO_LOAD * float(load.max()), max(EDGE, float(overlap.max()))
    near = np.flatnonzero((load <= floor) & (overlap > -2.0 * EDGE))
    by_force, moved = np.zeros(5, dtype=np.bool_), state.ring + EDGE * np.concatenate([np.eye(3, 5), -np.eye(3, 5)])
    neighbours = [
        solve_balance(system, by_force, at, at, depth, motion=state.motion) for at in moved[:, None] if near.size
    ]
    ready = near[np.any([shifted.load[0, near, 0] > floor for shifted in neighbours], axis=0)] if neighbours else near
    if not ready.size:
        return ready, np.full(3, np.nan)
    change = np.array([shifted.force[0, :3] - state.force[0, :3] for shifted in neighbours]).reshape(2, 3, 3)
    return ready, np.abs(change.diagonal(axis1=1, axis2=2)).max(axis=0) / EDGE


def drop_rounding(values: Array, weights: Array, beside: float = 0.0) -> list[float]:
    """Return numbers, zero for what is rounding beside the others, or beside what they are a difference of.

    Weights make those of several units comparable.
    """
    rounded: list[float] = without_rounding(values, weights, beside).tolist()
    return rounded


def without_rounding(values: Array, weights: Array, beside: float = 0.0) -> Array:
    """Return the same of many states, shape (..., numbers)."""
    sizes = np.abs(values * weights)
    return np.where(sizes > NO_LOAD * np.maximum(sizes.max(axis=-1, keepdims=True), beside), values, 0.0)


def drop_tilt_rounding(tilt: Array) -> Array:
    """Return tilts [rad], zero for those that are rounding."""
    return np.where(np.abs(tilt) > NO_TILT, tilt, 0.0)
