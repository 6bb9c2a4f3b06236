"""Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.

Every roller has a motion of its own, in which its contacts balance each other and the loads that speed gives it. It is
found for a given motion of the ring, and with it the force on the ring and its exact derivative (static condensation):

    f = sum_in A^T q            k = K_in - K_in (K_in + K_out)^-1 K_in        K = sum A^T S A

with A from `nonhertz.bearing.section` and S the stiffness of a contact; K_in is of the contacts with the inner ring.
The ring's motion is then found by Newton's method on the sum over all rollers. Contacts only push, and push harder the
deeper they are pressed: both are the search for the lowest point of a convex function, so that a step which is
shortened until the slope along it has fallen always leads on. Where nothing resists, as with a roller that touches
nothing, there is nothing to balance, and it stays where it is.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.balance import (
    NO_LOAD,
    NOT_IN_BOOK,
    Conditions,
    Parts,
    Search,
    States,
    ask_book,
    balance_all,
    begin,
    go_on,
    keep,
)
from nonhertz.bearing.laws import OVERLAP, Book, ContactLaw, MapLaw, OutsideLaw, Slices
from nonhertz.compiled import plain_array
from nonhertz.life.lamina import roller_stiffness

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

# What may be left of the balance of the ring, over the loads: strips are exact to 1e-11.
TOLERANCE = 1e-9
STEPS = 80
MOST_ASKED = 100  # times that contacts of one roller are solved; random bearings take 50 at most
EDGE = 1e-5  # mm, a motion far below what rollers and raceways depart from their shapes
_PORTION = 64  # states, below which a thread of its own does not pay


@dataclass(frozen=True, eq=False)
class Joint:
    """One contact of every roller of a row; those of a roller with the same `OutsideLaw` are asked together."""

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
    def outside(self) -> tuple[tuple[OutsideLaw, slice, list[int]], ...]:
        """The laws that answer from outside, with their rollers and columns."""
        found: dict[OutsideLaw, tuple[OutsideLaw, slice, list[int]]] = {}
        for joint in self.joints:
            if not isinstance(joint.law, Slices | MapLaw):
                found.setdefault(joint.law, (joint.law, joint.rollers, []))[2].append(joint.column)
        return tuple(found.values())

    @cached_property
    def parts(self) -> Parts:
        """The same as arrays."""
        shape = self.rollers, self.columns
        motion, gap = np.zeros((*shape, 2, 3)), np.zeros(shape)
        inner, law = np.zeros(shape, dtype=np.bool_), np.full(shape, NOT_IN_BOOK)
        laws: list[Slices | MapLaw] = []
        for joint in self.joints:
            at = joint.rollers, joint.column
            motion[at], gap[at], inner[at] = joint.motion, joint.gap, joint.inner
            if isinstance(joint.law, Slices | MapLaw):
                law[at] = len(laws)
                laws.append(joint.law)
        # Lever arms that make forces of the ring's moments, and displacements of its rotations.
        reach = np.max(np.abs(self.ring), axis=(0, 1))
        # A single roller does not feel what moves across it.
        reach[1:3], reach[3:] = reach[1:3].max(), reach[3:].max()
        scale = np.array([1.0, 1.0, self.lever])
        ring, load = np.ascontiguousarray(self.ring), np.ascontiguousarray(self.load, dtype=float)
        return Parts(
            ring, motion, gap, inner, law, Book.of(laws), load, scale, reach, roller_stiffness(2.0 * self.lever)
        )


def balanced(
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
        Of which motions of the ring the force or moment is given; of the others the displacement or rotation.
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
        How many may work on many states at once, where all laws are tables.
    """
    ring = np.where(by_force, start, target)
    begins = plain_array(target), ring, np.full((len(ring), system.rollers, 3), np.nan if motion is None else motion)
    conditions = Conditions(by_force, float(depth), float(tolerance), STEPS)
    found = States.blank(len(ring), system.rollers, system.columns)
    if not system.outside:
        borders = np.linspace(0, len(ring), min(threads, 1 + len(ring) // _PORTION) + 1).astype(int).tolist()

        def in_machine_code(first: int, last: int) -> None:
            search = Search.blank(system.rollers, system.columns)
            target, at, motion = (each[first:last] for each in begins)
            balance_all(system.parts, search, conditions, target, at, motion, found.portion(slice(first, last)))

        with ThreadPoolExecutor(len(borders) - 1) as pool:
            list(pool.map(in_machine_code, borders[:-1], borders[1:]))
        return found
    search = Search.blank(system.rollers, system.columns)
    rollers = search.rollers
    for k, (target_of_one, *begin_with) in enumerate(zip(*begins, strict=True)):
        begin(system.parts, search, *begin_with)
        times = np.zeros(system.rollers, dtype=np.int64)
        while times.max() < MOST_ASKED:
            times += rollers.asked
            ask_book(system.parts, rollers)
            for law, these, columns in system.outside:
                asked = these.start + np.flatnonzero(rollers.asked[these])
                at = np.ix_(asked, columns)
                rollers.answer[at] = law.answer(k * system.rollers + asked, rollers.pose[at])
            if not go_on(system.parts, search, conditions, target_of_one):
                break
        keep(search, found, k)
    return found


def at_edge(system: System, state: States) -> tuple[Indices, Array]:
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
    held, moved = np.zeros(5, dtype=np.bool_), state.ring + EDGE * np.concatenate([np.eye(3, 5), -np.eye(3, 5)])
    found = [balanced(system, held, at, at, depth, motion=state.motion) for at in moved[:, None] if near.size]
    ready = near[np.any([each.load[0, near, 0] > floor for each in found], axis=0)] if found else near
    if not ready.size:
        return ready, np.full(3, np.nan)
    change = np.array([each.force[0, :3] - state.force[0, :3] for each in found]).reshape(2, 3, 3)
    return ready, np.abs(change.diagonal(axis1=1, axis2=2)).max(axis=0) / EDGE
