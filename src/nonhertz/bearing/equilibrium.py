"""Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.

The core solves the balance; its method is explained in ``src/core/bearing/balance.hpp`` and
docs/explain/equilibrium.md. This module assembles rollers and contacts for it, and returns the states as arrays.
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

# Permitted residual of the balance of the ring, over the loads: strips are exact to 1e-11.
TOLERANCE = 1e-9
STEPS = 80
NO_TILT = 1e-12  # rad: a tilt below this is rounding
NO_LOAD = 1e-8  # of the largest load: residual of the balance of a roller that has lifted off
EDGE = 1e-5  # mm: a motion far below the form errors of rollers and raceways


class States(NamedTuple):
    """States of a bearing, a row each."""

    ring: Array  # motion of the inner ring, (states, 5)
    force: Array  # forces and moments on it in equilibrium, (states, 5)
    stiffness: Array  # d(force) / d(ring), (states, 5, 5)
    residual: Array  # residual of the balance of ring and rollers, over the loads, (states,)
    steps: Indices  # Newton steps of the ring, (states,)
    motion: Array  # of the rollers along x and r [mm] and about the tangent [rad], (states, rollers, 3)
    pose: Array  # approach and tilt of their contacts [mm, rad], (states, rollers, columns, 2)
    answer: Array  # results of the contact laws, (states, rollers, columns, ANSWER)

    def portion(self, which: slice | Indices) -> States:
        """Return some of the states; a slice is a view that can be filled."""
        parts: list[Any] = [values[which] for values in self]
        return States(*parts)

    @property
    def load(self) -> Array:
        """Loads of contacts [N], shape (states, rollers, columns)."""
        return self.answer[..., 0]

    def converged(self, tolerance: float) -> Flags:
        """Return which states are in balance with finite loads and motions."""
        numbers = np.column_stack([self.ring, self.force, self.load.reshape(len(self.ring), -1)])
        settled: Flags = (self.residual <= tolerance) & np.all(np.isfinite(numbers), axis=1)
        return settled


@dataclass(frozen=True, eq=False)
class Joint:
    """One contact of every roller of a row; contacts with the same `core.GroupLaw` are evaluated together."""

    inner: bool  # whether the other body is the inner ring, which moves; the outer ring is at rest
    motion: Array  # approach and tilt per motion of ring against roller, shape (2, 3)
    gap: Array  # gap between a centred ring and roller [mm], (rollers of the row,)
    law: ContactLaw
    column: int  # index of the contact among a roller's, from 0
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
    """Return the states of equilibrium of ring and rollers.

    Parameters
    ----------
    system : System
        The rollers.
    by_force : ndarray of bool, shape (5,)
        Whether the force or moment is given for each motion of the ring, rather than the displacement or rotation.
    target : ndarray, shape (states, 5)
        The given values.
    start : ndarray, shape (states, 5)
        Initial motions of the ring.
    depth : float
        Expected size of penetrations [mm].
    tolerance : float
        Permitted residual of the balance of the ring, over the loads; it is larger for rollers.
    motion : ndarray, shape (states, rollers, 3), optional
        Initial motions of the rollers; if left out or NaN, those by equal springs.
    threads : int
        Number of threads for many states, used where no law evaluates many contacts at once.

    Raises
    ------
    InputError
        If a profile is NaN within a contact by strips.
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
    assert states is not None  # only a signal stops it, whose exception propagates
    return States(*states)


def find_edge_rollers(system: System, state: States) -> tuple[Indices, Array]:
    """Return the rollers at the edge of the load zone, and the stiffness by a small motion of the ring.

    A roller that just touches both rings without load does not contribute to the derivatives of the forces, but carries
    load as soon as the ring moves towards it.

    Parameters
    ----------
    system : System
        The rollers.
    state : States
        One state.

    Returns
    -------
    ndarray of int
        Rollers without load that are loaded if the ring moves by `EDGE` along x, y or z.
    ndarray, shape (3,)
        The change of force over such a motion, in the direction in which it is larger [N/mm]; NaN if there are none.
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
    """Return numbers, with zero for rounding errors relative to the others, or to the terms of their difference.

    Weights make numbers of different units comparable.
    """
    rounded: list[float] = without_rounding(values, weights, beside).tolist()
    return rounded


def without_rounding(values: Array, weights: Array, beside: float = 0.0) -> Array:
    """Return the same of many states, shape (..., numbers)."""
    sizes = np.abs(values * weights)
    return np.where(sizes > NO_LOAD * np.maximum(sizes.max(axis=-1, keepdims=True), beside), values, 0.0)


def drop_tilt_rounding(tilt: Array) -> Array:
    """Return tilts [rad], with zero for rounding errors."""
    return np.where(np.abs(tilt) > NO_TILT, tilt, 0.0)
