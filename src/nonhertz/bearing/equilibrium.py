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
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.balance import (
    ABSENT,
    NO_LOAD,
    OUTSIDE,
    Found,
    Given,
    Parts,
    Work,
    ask_tables,
    balance_all,
    begin,
    go_on,
    keep,
)
from nonhertz.bearing.laws import OVERLAP, ContactLaw, SolvedLaw
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
    """One contact of every roller of a row.

    Attributes
    ----------
    inner : bool
        Whether the other body is the inner ring, which moves; the outer one is at rest.
    motion : ndarray, shape (2, 3)
        Approach and tilt per motion of ring against roller.
    gap : ndarray, shape (rollers of the row,)
        What the approach of a centred ring and roller is short of contact [mm].
    law : TabulatedLaw or SolvedLaw
        How it answers.
    column : int
        Which of a roller's contacts it is, from 0.
    first : int
        The number of the row's first roller.
    """

    inner: bool
    motion: Array
    gap: Array
    law: ContactLaw
    column: int
    first: int = 0

    @property
    def rollers(self) -> slice:
        """The row's rollers among all."""
        return slice(self.first, self.first + self.gap.size)


@dataclass(frozen=True, eq=False)
class System:
    """Rollers and their contacts.

    Attributes
    ----------
    ring : ndarray, shape (rollers, 3, 5)
        Motion at each roller per motion of the inner ring.
    joints : tuple of Joint
        The contacts.
    load : ndarray, shape (rollers, 3)
        Load on every roller along x, along r, and its moment [N, N, N mm].
    lever : float
        Length by which rotations of rollers are made comparable with displacements [mm].
    """

    ring: Array
    joints: tuple[Joint, ...]
    load: Array
    lever: float

    @property
    def rollers(self) -> int:
        """Their number."""
        return int(self.ring.shape[0])

    @property
    def columns(self) -> int:
        """The most contacts that a roller has."""
        return 1 + max(joint.column for joint in self.joints)

    @property
    def solved(self) -> tuple[tuple[Joint, SolvedLaw], ...]:
        """The contacts whose laws are no tables."""
        return tuple((each, each.law) for each in self.joints if not hasattr(each.law, "table"))

    @cached_property
    def parts(self) -> Parts:
        """The same as arrays."""
        shape = self.rollers, self.columns
        motion, gap = np.zeros((*shape, 2, 3)), np.zeros(shape)
        inner, law = np.zeros(shape, dtype=np.bool_), np.full(shape, ABSENT)
        tables: list[Array] = [np.zeros(0)]
        for joint in self.joints:
            at = joint.rollers, joint.column
            motion[at], gap[at], inner[at], law[at] = joint.motion, joint.gap, joint.inner, OUTSIDE
            table = getattr(joint.law, "table", None)
            if table is not None:
                law[at] = sum(each.size for each in tables)
                tables.append(table)
        # Lever arms that make forces of the ring's moments, and displacements of its rotations.
        reach = np.max(np.abs(self.ring), axis=(0, 1))
        # A single roller does not feel what moves across it.
        reach[1:3], reach[3:] = reach[1:3].max(), reach[3:].max()
        scale = np.array([1.0, 1.0, self.lever])
        ring, load = np.ascontiguousarray(self.ring), np.ascontiguousarray(self.load, dtype=float)
        book, stiffness = np.concatenate(tables), roller_stiffness(2.0 * self.lever)
        return Parts(ring, motion, gap, inner, law, book, load, scale, reach, stiffness)


class Rollers(NamedTuple):
    """Rollers in balance.

    Attributes
    ----------
    motion : ndarray, shape (states, rollers, 3)
        Along x and r [mm] and about the tangent [rad].
    approach, tilt, load, moment, overlap : ndarray, shape (states, rollers, columns)
        Of their contacts [mm], [rad], [N], [N mm], [mm].
    """

    motion: Array
    approach: Array
    tilt: Array
    load: Array
    moment: Array
    overlap: Array


class States(NamedTuple):
    """States of a bearing.

    Attributes
    ----------
    ring : ndarray, shape (states, 5)
        Motion of the inner ring.
    rollers : Rollers
        Its rollers.
    force : ndarray, shape (states, 5)
        Forces and moments on the inner ring that hold it there.
    stiffness : ndarray, shape (states, 5, 5)
        d(force) / d(ring).
    residual : ndarray, shape (states,)
        What is left of the balance of ring and rollers, over the loads.
    steps : ndarray of int, shape (states,)
        Newton steps of the ring.
    """

    ring: Array
    rollers: Rollers
    force: Array
    stiffness: Array
    residual: Array
    steps: Indices


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
    at_first = np.zeros((0, system.rollers, 3)) if motion is None else motion
    given = Given(by_force, float(depth), float(tolerance), STEPS)
    found = Found.blank(len(ring), system.rollers, system.columns)
    target, at_first = plain_array(target), plain_array(at_first)
    if system.solved:
        _asked_in_turn(system, given, target, ring, at_first, found)
    else:
        _in_machine_code(system.parts, given, (target, ring, at_first), found, threads)
    pose, borne = found.pose, found.borne
    rollers = Rollers(found.motion, pose[..., 0], pose[..., 1], borne[..., 0], borne[..., 1], borne[..., OVERLAP])
    return States(found.ring, rollers, found.force, found.stiffness, found.left, found.steps)


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
    load, overlap = state.rollers.load[0, :, 0], state.rollers.overlap[0, :, :2].sum(axis=1)
    floor, depth = NO_LOAD * float(load.max()), max(EDGE, float(overlap.max()))
    near = np.flatnonzero((load <= floor) & (overlap > -2.0 * EDGE))
    held, moved = np.zeros(5, dtype=np.bool_), state.ring + EDGE * np.concatenate([np.eye(3, 5), -np.eye(3, 5)])
    found = [balanced(system, held, at, at, depth, motion=state.rollers.motion) for at in moved[:, None] if near.size]
    ready = near[np.any([each.rollers.load[0, near, 0] > floor for each in found], axis=0)] if found else near
    if not ready.size:
        return ready, np.full(3, np.nan)
    change = np.array([each.force[0, :3] - state.force[0, :3] for each in found]).reshape(2, 3, 3)
    return ready, np.abs(change.diagonal(axis1=1, axis2=2)).max(axis=0) / EDGE


def _in_machine_code(
    parts: Parts, given: Given, begins: tuple[Array, Array, Array], found: Found, threads: int
) -> None:
    """Find all states, in portions on threads of their own."""
    count = len(begins[0])
    borders = np.linspace(0, count, min(threads, 1 + count // _PORTION) + 1).astype(int).tolist()

    def one(first: int, last: int) -> None:
        target, start, motion = (each[first:last] if len(each) else each for each in begins)
        work = Work.blank(*parts.gap.shape)
        balance_all(parts, work, given, target, start, motion, found.portion(first, last))

    if len(borders) == 2:
        one(0, count)
        return
    with ThreadPoolExecutor(len(borders) - 1) as pool:
        list(pool.map(one, borders[:-1], borders[1:]))


def _asked_in_turn(system: System, given: Given, target: Array, start: Array, motion: Array, found: Found) -> None:
    """Find states one after the other, asking the laws that are no tables whenever contacts are asked."""
    parts, solved = system.parts, system.solved
    work = Work.blank(system.rollers, system.columns)
    for k in range(len(target)):
        begin(parts, work, start[k], motion[k] if len(motion) else motion.reshape(0, 3))
        times = np.zeros(system.rollers, dtype=np.int64)
        while times.max() < MOST_ASKED:
            times += work.asked
            ask_tables(parts, work)
            questions = []
            for joint, law in solved:
                asked = joint.first + np.flatnonzero(work.asked[joint.rollers])
                pose = work.pose[asked, joint.column]
                questions.append((asked, (k * system.rollers + asked, pose[:, 0], pose[:, 1])))
                law.expect(*questions[-1][1])
            for (joint, law), (asked, question) in zip(solved, questions, strict=True):
                work.answer[asked, joint.column] = law.pressed(*question)
            if not go_on(parts, work, given, target[k]):
                break
        keep(work, found, k)
