"""The contact conditions on one grid: which cells touch, and the pressure on them.

Where the surfaces touch the gap is zero; elsewhere the pressure is zero. For a given set of cells in contact this is a
linear system, K_AA p_A = d_A - g_A with d = approach + tilt y; a prescribed load or moment adds an equation B^T p, with
approach or tilt as its multiplier. Conjugate gradients solve it in the subspace of pressures that have the right
load and moment: each preconditioned residual is projected onto that subspace by the multipliers (the constraint
preconditioner [M^-1 B; B^T 0] of Gould, Hribar and Nocedal). The four pairs of prescribed quantities differ only in the
columns of B.

The set is found by a primal-dual active set method, which is Newton's method on the contact conditions: cells in
tension leave, cells that would overlap enter. An accurate solution for a wrong set is wasted: each solve continues only
until its residual is small compared with the disturbance by the next change of the set. A change and a step cost one
convolution each.

References
----------
M. Hintermueller, K. Ito and K. Kunisch, The primal-dual active set strategy as a semismooth Newton method, SIAM Journal
on Optimization 13 (2002) 865-888, doi:10.1137/S1052623401383558. N. I. M. Gould, M. E. Hribar and J. Nocedal, On the
solution of equality constrained quadratic programming problems arising in optimization, SIAM Journal on Scientific
Computing 23 (2001) 1376-1395, doi:10.1137/S1064827598345667. I. A. Polonsky and L. M. Keer, A numerical method for
solving rough contact problems based on the multi-level multi-summation and conjugate gradient techniques, Wear 231
(1999) 206-219, doi:10.1016/S0043-1648(99)00113-1.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.convolution import Convolution
from nonhertz.patch.inverse import Inverse
from nonhertz.result.status import Status

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MOST_CHANGES = 60  # of the set
MOST_MOTIONS = 100
MOST_STEPS = 40  # for one set
SHARE = 0.5  # of the disturbance by the next change of the set: how far to reduce the residual for this one
ROUNDING, BALANCED = 1e-13, 1e-10  # of the load and moment
TINY = 1e-300


@dataclass(frozen=True, eq=False)
class Task:
    """A problem on one grid.

    Attributes
    ----------
    undeformed : ndarray, shape (nx, ny)
        Gap g [mm] of the undeformed bodies; infinite in cells without a body, which never touch.
    displacement : Convolution
        Pressure to displacement.
    inverse : Inverse
        Its approximate inverse.
    y : ndarray, shape (ny,)
        Lever arms [mm].
    by_force : tuple of bool
        Whether the load is given rather than the approach, and the moment rather than the tilt.
    target : tuple of float
        The given values: approach [mm] or K Q / (dx dy) [-], and tilt [rad] or K T / (dx dy) [mm].
    """

    undeformed: Array
    displacement: Convolution
    inverse: Inverse
    y: Array
    by_force: tuple[bool, bool]
    target: tuple[float, float]

    @cached_property
    def bearing(self) -> Mask:
        """The cells with a body, which can carry a pressure, shape (nx, ny)."""
        return np.isfinite(self.undeformed)

    def start(self) -> Array:
        """Return a pressure to start from: springs, acting in the half of the cells that would touch first."""
        nearness = (0.0 if self.by_force[1] else self.target[1]) * self.y - self.undeformed
        return np.maximum(nearness - float(np.median(nearness[self.bearing])), 0.0)


@dataclass(frozen=True, eq=False)
class CellState:
    """State of the iterations, or their result; pressures are times K, and the gap is infinite without a body."""

    pressure: Array
    gap: Array
    rigid: tuple[float, float]
    residual: float
    status: Status


def settle(task: Task, pressure: Array, rigid: tuple[float, float], tolerance: float) -> CellState:
    """Return the solution of a task.

    Parameters
    ----------
    task : Task
        What to solve.
    pressure : ndarray, shape (nx, ny)
        Initial pressure times K [-]: the cells with pressure are those initially in contact.
    rigid : tuple of float
        Approach [mm] and tilt [rad] to start from, where they are not given.
    tolerance : float
        Largest residual: the largest gap in contact or overlap elsewhere, over the largest displacement.

    Returns
    -------
    State
    """
    state = _ActiveSet(task, pressure, rigid).run(tolerance)
    if state.status is Status.CONVERGED or not any(task.by_force):
        return state
    return settle_by_motion(task, state, tolerance)


class _ActiveSet:
    """The iteration, with the few fields that it updates in place."""

    def __init__(self, task: Task, pressure: Array, rigid: tuple[float, float]) -> None:
        self.task = task
        prescribed = [c for c in (0, 1) if task.by_force[c]]
        self.prescribed = prescribed
        self.levers = np.stack([np.ones_like(task.y), task.y])[prescribed]
        self.target = np.array(task.target)[prescribed]
        self.rigid = np.where(task.by_force, rigid, task.target)
        # The start was interpolated from coarser cells, some of which had a body where these have none.
        self.pressure = np.where(task.bearing, np.maximum(pressure, 0.0), 0.0)
        self.touching: Mask = self.pressure > 0.0
        self.own = float(task.displacement.own)
        self.scale = 1.0

    def run(self, tolerance: float) -> CellState:
        """Update the set and solve until the set no longer changes."""
        status = Status.ITERATION_LIMIT
        residual = np.inf
        for _ in range(MOST_CHANGES):
            if self._balance() > BALANCED:
                if not self._widen():
                    break
                continue
            residual = self._solve(tolerance)
            if residual <= tolerance and self.pressure.min() >= 0.0:
                residual *= self._rescale()
                if residual <= tolerance:
                    status = Status.CONVERGED
                    break
            self.touching = np.where(self.touching, self.pressure >= 0.0, self.gap < 0.0)
            np.maximum(self.pressure, 0.0, out=self.pressure)
        rigid = float(self.rigid[0]), float(self.rigid[1])
        return CellState(self.pressure, self.gap, rigid, residual, status)

    def _balance(self) -> float:
        """Bring load and moment to the given values by adding the pressure responses to approach and tilt.

        Returns
        -------
        float
            The relative imbalance that remains if the cells in contact cannot carry the rest: cells in one row cannot
            carry a moment about it, and no cells cannot carry anything.
        """
        self._respond()
        missing = self.missing()
        if missing > ROUNDING:
            for amount, response in zip(self._multipliers(self.lack), self.responses, strict=True):
                self.pressure += amount * response
            missing = self.missing()
        displacement = self.task.displacement(self.pressure)
        self.gap = displacement + self.task.undeformed
        self.gap -= self.rigid[0] + self.rigid[1] * self.task.y
        self.scale = max(float(np.max(np.abs(displacement))), -float(self.gap.min())) or 1.0
        return missing

    def _rescale(self) -> float:
        """Update the scale from the current displacement, and return old scale / new scale."""
        displacement = self.rigid[0] + self.rigid[1] * self.task.y - self.task.undeformed
        np.add(displacement, self.gap, out=displacement, where=self.task.bearing)
        before, self.scale = self.scale, float(np.max(np.abs(displacement[self.task.bearing]))) or 1.0
        return before / self.scale

    @property
    def lack(self) -> Array:
        """Target minus current load and moment, where they are given."""
        lack: Array = self.target - self._forces(self.pressure)
        return lack

    def missing(self) -> float:
        """Return the lack relative to what all cells carry, with absolute lever arms."""
        borne = np.abs(self.levers) @ np.abs(self.pressure.sum(axis=0))
        whole = np.maximum(np.maximum(borne, np.abs(self.target)), TINY)
        return float(np.max(np.abs(self.lack) / whole, initial=0.0))

    def answer(self) -> Array:
        """Return the increments of approach and tilt that approximately make up for the lack."""
        self._widen()
        self._respond()
        return self._multipliers(self.lack)

    def _respond(self) -> None:
        """Find the pressure responses to approach and tilt in the contact, and their loads and moments."""
        inverse, touching = self.task.inverse, self.touching
        self.responses = [inverse(touching * lever) * touching for lever in self.levers]
        forces = [self._forces(response) for response in self.responses]
        self.stiffness = np.array(forces).reshape(len(self.prescribed), len(self.prescribed))

    def _widen(self) -> bool:
        """Add the rows on either side of those in contact, or all cells with a body if that adds none.

        Returns
        -------
        bool
            Whether any cell was added.
        """
        before, near = np.count_nonzero(self.touching), self.touching.copy()
        near[:, 1:] |= self.touching[:, :-1]
        near[:, :-1] |= self.touching[:, 1:]
        near &= self.task.bearing
        self.touching = near if np.count_nonzero(near) > before else self.task.bearing.copy()
        return bool(np.count_nonzero(self.touching) > before)

    def _solve(self, tolerance: float) -> float:
        """Take steps for the current set until it is time to change it, and return the residual."""
        residual, squared, direction = np.inf, 0.0, np.zeros_like(self.gap)
        for step in range(MOST_STEPS):
            correction, overlap = self._precondition()
            in_contact = float(np.max(np.abs(overlap)))
            outside = -float(np.min(self.gap, where=~self.touching, initial=0.0))
            residual = max(in_contact, outside) / self.scale
            upset = max(outside, -self.own * float(self.pressure.min()))
            if in_contact <= tolerance * self.scale or (step > 0 and in_contact <= SHARE * upset):
                break
            before, squared = squared, float(np.vdot(overlap, correction))
            direction *= squared / before if step > 0 else 0.0
            direction += correction
            moved = self.task.displacement(direction)
            bent = float(np.vdot(direction * self.touching, moved))
            if not bent > 0.0:  # at the limit of floating-point accuracy: no further progress
                break
            length = squared / bent
            self.pressure += length * direction
            self.gap += length * moved
        return residual

    def _precondition(self) -> tuple[Array, Array]:
        """Return a pressure correction that roughly closes the gap in contact, and the overlap after a rigid motion.

        Approach and tilt move so that the correction has neither load nor moment where these are given.
        """
        correction = self.task.inverse(self._overlap())
        correction *= self.touching
        for c, amount, response in zip(
            self.prescribed, self._multipliers(self._forces(correction)), self.responses, strict=True
        ):
            correction -= amount * response
            self.rigid[c] -= amount
            self.gap += amount * (self.task.y if c else 1.0)
        return correction, self._overlap()

    def _overlap(self) -> Array:
        """Return -gap [mm] of cells in contact, and zero elsewhere, including where the gap is infinite."""
        overlap: Array = np.negative(self.gap, where=self.touching, out=np.zeros_like(self.gap))
        return overlap

    def _multipliers(self, forces: Array) -> Array:
        # Least squares, because cells of a single row cannot carry a moment: the matrix is then singular.
        return np.asarray(np.linalg.lstsq(self.stiffness.T, forces, rcond=1e-12)[0], dtype=np.float64)

    def _forces(self, pressure: Array) -> Array:
        forces: Array = self.levers @ pressure.sum(axis=0)
        return forces


def settle_by_motion(task: Task, state: CellState, tolerance: float) -> CellState:
    """Find the approach and tilt at which load and moment are as given, from contacts with prescribed motion.

    This is the fallback where sets cycle, as they may while one or two rows of cells carry a moment. With prescribed
    motion they do not, and target minus current load and moment is the gradient of a concave function of approach and
    tilt: ascent steps that do not overshoot lead to the maximum.
    """
    forced = np.flatnonzero(task.by_force)
    motion, step, slope, share = np.array(state.rigid), np.zeros(forced.size), 0.0, 1.0
    for _ in range(MOST_MOTIONS):
        moved = replace(task, by_force=(False, False), target=(float(motion[0]), float(motion[1])))
        state = _ActiveSet(moved, state.pressure, moved.target).run(max(0.01 * tolerance, ROUNDING))
        if state.status is not Status.CONVERGED:
            break
        forces = _ActiveSet(task, state.pressure, state.rigid)
        if forces.missing() <= tolerance:
            return state
        if forces.lack @ step < -0.5 * slope:
            motion[forced] -= 0.75 * share * step
            share *= 0.25
            continue
        step = forces.answer()
        slope, share = float(forces.lack @ step), 2.0 * share
        motion[forced] += share * step
    return replace(state, status=Status.ITERATION_LIMIT)
