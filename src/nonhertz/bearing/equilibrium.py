"""Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.

Every roller has a motion of its own, in which its contacts balance each other and the loads that speed gives it. It is
found for a given motion of the ring, and with it the force on the ring and its exact derivative (static condensation):

    f = sum_in A^T q            k = K_in - K_in (K_in + K_out)^-1 K_in        K = sum A^T S A

with A from `nonhertz.bearing.section` and S the stiffness of a contact; K_in is of the contacts with the inner ring.
The ring's motion is then found by Newton's method on the sum over all rollers. Contacts only push, and push harder the
deeper they are pressed: both are the search for the lowest point of a convex function, so that a step which is
shortened until the slope along it has fallen always leads on. Where nothing resists, as with a roller that touches
nothing, there is nothing to balance, and it stays where it is.

All states of a bearing are solved together, a row each.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.laws import ContactLaw

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

# What may be left of the balance of the ring, over the loads, and of that of a roller, over this: strips are exact to
# 1e-11.
TOLERANCE, OF_ROLLER = 1e-9, 0.1
STEPS, SHORTENINGS = 80, 30
RIDGE = 1e-13  # of the stiffness, where nothing resists
OVERSHOT = 0.5  # of the slope along a step, by which it may point backwards at its end
HELD_BACK = 1e-3  # of loads over the penetration to be expected
CAUTION = 8.0  # penetrations that a step of the ring may add


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
    law : ContactLaw
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

    @cached_property
    def reach(self) -> Array:
        """Lever arms that make forces of the ring's moments, and displacements of its rotations [mm], shape (5,)."""
        reach: Array = np.max(np.abs(self.ring), axis=(0, 1))
        return reach

    @property
    def columns(self) -> int:
        """The most contacts that a roller has."""
        return 1 + max(joint.column for joint in self.joints)


class Rollers(NamedTuple):
    """Rollers in balance, a row each.

    Attributes
    ----------
    motion : ndarray, shape (n, 3)
        Along x and r [mm] and about the tangent [rad].
    approach, tilt, load, moment : ndarray, shape (n, columns)
        Of their contacts [mm], [rad], [N], [N mm].
    off : ndarray, shape (n, 3)
        What is left of their balance.
    on_ring : ndarray, shape (n, 3)
        Force and moment of the inner ring on them.
    stiffness, of_ring : ndarray, shape (n, 3, 3)
        K of all contacts, and of those with the inner ring.
    """

    motion: Array
    approach: Array
    tilt: Array
    load: Array
    moment: Array
    off: Array
    on_ring: Array
    stiffness: Array
    of_ring: Array


class States(NamedTuple):
    """States of a bearing.

    Attributes
    ----------
    ring : ndarray, shape (states, 5)
        Motion of the inner ring.
    rollers : Rollers
        Its rollers, of shapes (states, rollers, ...).
    force : ndarray, shape (states, 5)
        Forces and moments on the inner ring that hold it there.
    stiffness : ndarray, shape (states, 5, 5)
        d(force) / d(ring).
    residual : ndarray, shape (states,)
        What is left of the balance of the ring, over the loads.
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
        Motions of the rollers to begin with; if left out, those that equal springs would give them.
    """
    count, free = len(target), np.flatnonzero(by_force)
    ring = np.where(by_force, start, target)
    at_first = _following(system, _at_rollers(system, ring)) if motion is None else motion
    states = _held(system, ring, at_first, np.arange(count), tolerance, depth)
    for _ in range(STEPS):
        off, loads = _unbalanced(system, states, by_force, target)
        states.residual[:] = np.max(np.abs(off) / system.reach, axis=1) / loads
        left = np.flatnonzero(states.residual > tolerance)
        if not left.size:
            break
        step = np.zeros((left.size, 5))
        held = states.stiffness[left] + _held_back(system, states.residual[left], loads[left], depth)
        step[:, free] = _solved(held[:, free[:, None], free], off[left][:, free, None])[..., 0]
        moved = np.max(np.abs(_at_rollers(system, step)[..., :2]), axis=(1, 2))
        step *= _cautious(moved, np.max(states.rollers.approach[left], axis=(1, 2)), depth)[:, None]
        _step(system, states, left, step, (off[left], target[left], by_force), tolerance, depth)
        states.steps[left] += 1
    return states


def _at_rollers(system: System, ring: Array) -> Array:
    """Return the motion of the inner ring at the rollers, (states, rollers, 3)."""
    found: Array = np.einsum("jab,sb->sja", system.ring, ring)
    return found


def _following(system: System, at_ring: Array) -> Array:
    """Return motions of rollers, shape (states, rollers, 3), if all contacts were alike: half-way between rings.

    Barrels turn with the inner ring, which costs nothing.
    """
    alike = np.diag([1.0, system.lever**2 / 3.0])
    whole, of_ring = np.zeros((2, system.rollers, 3, 3))
    for joint in system.joints:
        these = slice(joint.first, joint.first + joint.gap.size)
        stiffness = joint.motion.T @ alike @ joint.motion
        whole[these] += stiffness
        of_ring[these] += stiffness if joint.inner else 0.0
    pushed = np.einsum("jab,sjb->sja", of_ring, at_ring)
    return _solved(np.broadcast_to(whole, (*pushed.shape, 3)), pushed[..., None], system.lever)[..., 0]


def _unbalanced(system: System, states: States, by_force: Flags, target: Array) -> tuple[Array, Array]:
    """Return given less found forces, zero where a displacement is given, and the size of the loads [N]."""
    off = np.where(by_force, target - states.force, 0.0)
    borne = np.sum(np.abs(states.rollers.on_ring[..., :2]), axis=(1, 2))
    given = np.max(np.abs(np.where(by_force, target, 0.0)) / system.reach, axis=1)
    return off, np.maximum(np.maximum(borne, given), np.finfo(float).tiny)


def _held_back(system: System, residual: Array, loads: Array, depth: float) -> Array:
    """Return a small stiffness against all motions, so that a ring that touches nothing goes where it is pushed."""
    size = HELD_BACK * np.minimum(residual, 1.0) * loads / depth
    found: Array = size[:, None, None] * np.diag(system.reach**2)
    return found


def _cautious(moved: Array, deepest: Array, depth: float) -> Array:
    """Return shares of steps, by how far they move, that press nothing much deeper than it is or is expected to be."""
    share: Array = np.minimum(1.0, CAUTION * np.maximum(deepest, depth) / np.maximum(moved, np.finfo(float).tiny))
    return share


def _step(
    system: System,
    states: States,
    left: Indices,
    step: Array,
    given: tuple[Array, Array, Flags],
    tolerance: float,
    depth: float,
) -> None:
    """Move the ring in some states by a step, or by as much of it as the forces along it allow.

    What is left to balance, the target, and where it is a force, are ``given``.
    """
    off, target, by_force = given
    before, rollers = states.ring[left], states.rollers
    at_rollers = _at_rollers(system, step)
    # Where the rollers would move to if the contacts kept their stiffness.
    pushed = np.einsum("sjab,sjb->sja", rollers.of_ring[left], at_rollers)
    follows = _solved(rollers.stiffness[left], pushed[..., None], system.lever)[..., 0]
    motion = rollers.motion[left]

    def attempt(these: Indices, share: Array) -> Array:
        moved = motion[these] + share[:, None, None] * follows[these]
        tried = _held(system, before[these] + share[:, None] * step[these], moved, left[these], tolerance, depth)
        for whole, part in ((states, tried), (states.rollers, tried.rollers)):
            for name in part._fields:
                if name not in ("rollers", "steps"):
                    getattr(whole, name)[left[these]] = getattr(part, name)
        still = np.where(by_force, target[these] - tried.force, 0.0)
        found: Array = np.sum(still * step[these], axis=1)
        return found

    _shortened(np.sum(off * step, axis=1), attempt)


def _shortened(slope: Array, attempt: Callable[[Indices, Array], Array]) -> None:
    """Attempt whole steps, and shorter ones where the slope along them then points backwards.

    Parameters
    ----------
    slope : ndarray, shape (n,)
        The slope along each step at its beginning; not negative.
    attempt : callable
        Numbers of steps and shares of them -> the slope there. What it leaves at the last call for a step stays.
    """
    share, low, of_low = np.ones(slope.size), np.zeros(slope.size), slope.copy()
    trying = np.arange(slope.size)
    for _ in range(SHORTENINGS):
        now = attempt(trying, share[trying])
        # One that falls short is good enough: the next goes on from there. A slope below zero is rounding.
        back = (now < -OVERSHOT * slope[trying]) & (slope[trying] > 0.0)
        if not np.any(back):
            return
        trying, now = trying[back], now[back]
        width = share[trying] - low[trying]
        cut = np.clip(of_low[trying] / (of_low[trying] - now), 0.1, 0.9)
        share[trying] = low[trying] + cut * width


def _held(system: System, ring: Array, motion: Array, which: Indices, tolerance: float, depth: float) -> States:
    """Return states with given motions of the ring, in which the rollers are in balance.

    Parameters
    ----------
    system : System
        The rollers.
    ring : ndarray, shape (states, 5)
        Motions of the ring.
    motion : ndarray, shape (states, rollers, 3)
        Motions of rollers to begin with.
    which : ndarray of int, shape (states,)
        Numbers of the states.
    tolerance, depth : float
        As for `balanced`.
    """
    count, number = motion.shape[:2]
    at_ring = _at_rollers(system, ring).reshape(-1, 3)
    place = np.tile(np.arange(number), count)
    rows = (which[:, None] * number + np.arange(number)).ravel()
    rollers = _pressed(system, at_ring, motion.reshape(-1, 3), place, rows)
    weights = np.array([1.0, 1.0, 1.0 / system.lever])
    for _ in range(STEPS):
        borne = np.repeat(np.max(np.sum(rollers.load, axis=1).reshape(count, number), axis=1), number)
        size = np.maximum(borne, np.max(np.abs(system.load * weights)))
        off = np.max(np.abs(rollers.off * weights), axis=1)
        left = np.flatnonzero(off > OF_ROLLER * tolerance * size)
        if not left.size:
            break
        # As for the ring: where nothing resists, a roller goes where it is pushed, and not far at once.
        held = HELD_BACK * np.minimum(off, size)[left] / depth
        held_back = rollers.stiffness[left] + held[:, None, None] * np.diag(weights**-2)
        step = _solved(held_back, rollers.off[left][..., None], system.lever)[..., 0]
        moved = np.max(np.abs(step / weights), axis=1)
        step *= _cautious(moved, np.max(rollers.approach[left], axis=1), depth)[:, None]
        before = rollers.motion[left]

        def attempt(
            these: Indices, share: Array, left: Indices = left, step: Array = step, before: Array = before
        ) -> Array:
            at = left[these]
            tried = _pressed(system, at_ring[at], before[these] + share[:, None] * step[these], place[at], rows[at])
            for whole, part in zip(rollers, tried, strict=True):
                whole[at] = part
            found: Array = np.sum(tried.off * step[these], axis=1)
            return found

        _shortened(np.sum(rollers.off[left] * step, axis=1), attempt)
    found = Rollers(*(each.reshape(count, number, *each.shape[1:]) for each in rollers))
    condensed = found.of_ring - found.of_ring @ _solved(found.stiffness, found.of_ring, system.lever)
    force = np.einsum("jab,sja->sb", system.ring, found.on_ring)
    stiffness = np.sum(system.ring.transpose(0, 2, 1) @ condensed @ system.ring, axis=1)
    return States(ring, found, force, stiffness, np.full(count, np.inf), np.zeros(count, dtype=np.int64))


def _pressed(system: System, ring: Array, motion: Array, place: Indices, rows: Indices) -> Rollers:
    """Return what the contacts of rollers do, a row each."""
    count, columns = len(motion), system.columns
    approach, tilt, load, moment = (np.zeros((count, columns)) for _ in range(4))
    off, on_ring = system.load[place], np.zeros((count, 3))
    stiffness, of_ring = np.zeros((count, 3, 3)), np.zeros((count, 3, 3))
    for joint in system.joints:
        at, k = place - joint.first, joint.column
        these = np.flatnonzero((at >= 0) & (at < joint.gap.size))
        against = ring[these] - motion[these] if joint.inner else -motion[these]
        pose = against @ joint.motion.T
        approach[these, k], tilt[these, k] = pose[:, 0] - joint.gap[at[these]], pose[:, 1]
        answer = joint.law.pressed(rows[these], approach[these, k], tilt[these, k])
        load[these, k], moment[these, k] = answer.load, answer.moment
        force = np.stack([answer.load, answer.moment], axis=1) @ joint.motion
        stiff = joint.motion.T @ answer.stiffness @ joint.motion
        off[these] += force
        stiffness[these] += stiff
        if joint.inner:
            on_ring[these] += force
            of_ring[these] += stiff
    return Rollers(motion.copy(), approach, tilt, load, moment, off, on_ring, stiffness, of_ring)


def _solved(matrix: Array, right: Array, lever: float = 1.0) -> Array:
    """Return solutions of linear equations, in which a motion that nothing resists is left alone."""
    scale = np.ones(matrix.shape[-1])
    if scale.size == 3:
        scale[2] = lever
    size = np.max(np.abs(np.diagonal(matrix, axis1=-2, axis2=-1)) / scale**2, axis=-1)
    ridge = np.where(size > 0.0, RIDGE * size, 1.0)
    found: Array = np.linalg.solve(matrix + ridge[..., None, None] * np.diag(scale**2), right)
    return found
