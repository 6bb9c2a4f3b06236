"""From coarse to fine: each grid starts from the pressure on one with half as many cells in each direction.

A contact set known to within a cell on the coarser grid takes a few changes on the finer one, whatever the number of
cells, so the number of convolutions hardly grows and the cost is O(n log n); all coarser grids together cost a third of
the finest. The change from grid to grid estimates the discretisation error.
"""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.bodies.shape import HERTZ
from nonhertz.errors import InputError
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.grid import Grid, Span, half_widths, interpolation
from nonhertz.patch.inverse import Inverse
from nonhertz.patch.settle import CellState, Task, settle
from nonhertz.patch.surface import Surface
from nonhertz.result.status import Status

Array = NDArray[np.float64]

# On coarser grids a residual below this is not worth another convolution: the error estimate needs no more digits.
ROUGHLY = 1e-6
FEWEST = 4  # cells in either direction
WITHIN = 0.25  # of a cell: how far inside the outermost rows a rough grid keeps the lever arm of a moment


@dataclass(frozen=True, eq=False)
class PatchProblem:
    """The problem to solve, independent of a grid.

    Attributes
    ----------
    gap : Surface
        The bodies and their undeformed gap.
    prescribed : Prescription
        The prescribed load or approach, and tilt or moment.
    """

    gap: Surface
    prescribed: Prescription

    @property
    def contact(self) -> Contact:
        """The two bodies."""
        return self.gap.contact

    @cached_property
    def influence(self) -> Influence:
        """Side faces and depths."""
        return influence_of(self.contact, HERTZ)

    def task(self, grid: Grid, undeformed: Array, pool: Executor | None, rough: bool = False) -> Task:
        """Return the problem on a grid; if ``rough``, the moment is brought within reach of the cells.

        Raises
        ------
        InputError
            If the grid is not rough and its cells cannot carry the moment.
        """
        first, second = self.prescribed.target(self.contact.compliance)
        by_force, area = self.prescribed.by_force, grid.dx * grid.dy
        if by_force[1]:
            rows = grid.y[np.isfinite(undeformed).any(axis=0)]
            low, high = float(rows[0]), float(rows[-1])
            if not rough:
                where = "the centres of the outermost cells that can carry a pressure"
                refuse_beyond(self.prescribed, (low, high), where, "give more cells along or a larger region")
            elif by_force[0]:
                # A coarse grid may have no cell that far out.
                middle, reach = 0.5 * (low + high), max(0.5 * (high - low) - WITHIN * grid.dy, 0.0)
                second = first * float(np.clip(second / first, middle - reach, middle + reach))
            elif (second > 0.0 >= high) or (second < 0.0 <= low):
                second = 0.0
        target = (first / area if by_force[0] else first, second / area if by_force[1] else second)
        convolution, inverse = Convolution(grid, self.influence, pool), Inverse(grid, pool)
        return Task(undeformed, convolution, inverse, grid.y, by_force, target)


def refuse_beyond(prescription: Prescription, arms: Span, where: str, remedy: str, bearing: Span | None = None) -> None:
    """Refuse a moment that no pressure between two lever arms [mm] can produce.

    ``where`` describes the lever arms in words. If ``bearing`` holds other arms, only their sign must match the moment.

    Raises
    ------
    InputError
    """
    moment, arm = prescription.moment, prescription.arm
    between = f"between {mm(*arms, between=' and '):.6g}, {where}"
    if arm is not None and not arms[0] <= arm <= arms[1]:
        raise InputError("moment", moment, f"keep moment / load = {mm(arm):.6g} {between}", f"reduce it, or {remedy}")
    low, high = bearing or arms
    if moment is not None and ((moment > 0.0 >= high) or (moment < 0.0 <= low)):
        condition = f"have the sign of the lever arms, which lie {between}"
        raise InputError("moment", moment, condition, f"reverse its sign, or {remedy}")


@dataclass(frozen=True)
class GridLevel:
    """Results kept from a grid: enough to compute the change on a finer one."""

    cells: tuple[int, int]
    approach: float
    tilt: float
    load: float
    moment: float
    along: tuple[Array, Array, Array]  # y, the maximum pressure across, times K, and the half-width there


@dataclass(frozen=True, eq=False)
class Outcome:
    """The finest grid's solution, pressures times K, and the levels of the coarser grids."""

    grid: Grid
    state: CellState
    convolutions: int
    levels: tuple[GridLevel, ...]

    def largest_displacement(self, undeformed: Array) -> float:
        """Return the largest displacement [mm] in cells that have a body, zero if none has."""
        bearing, rigid = np.isfinite(undeformed), self.state.rigid
        displacement = np.full(undeformed.shape, -np.inf)
        np.subtract(self.state.gap, undeformed, out=displacement, where=bearing)
        displacement += rigid[0] + rigid[1] * self.grid.y
        return float(np.max(displacement, initial=0.0))


def solve_on(
    problem: PatchProblem, grid: Grid, tolerance: float, pool: Executor | None = None, rough: bool = False
) -> Outcome:
    """Solve on coarser grids first and on the given grid, which may itself be ``rough``, last.

    Raises
    ------
    InputError
        If the grid is not rough and no cell has a body; on a rough grid the result is then without contact.
    """
    pressure, rigid, levels, count = None, (0.0, 0.0), [], 0
    for level in (*reversed(list(grid.coarser())), grid):
        finest, undeformed = level is grid, problem.gap(*level.centres)
        if np.isfinite(undeformed).any():
            task = problem.task(level, undeformed, pool, rough or not finest)
            pressure = task.start() if pressure is None else refine_pressure(pressure, level.cells)
            state = settle(task, pressure, rigid, tolerance if finest else max(tolerance, ROUGHLY))
            pressure, rigid, count = state.pressure, state.rigid, task.displacement.count
        elif not finest:
            continue  # The bodies lie between the cell centres; a finer grid may have centres on them.
        elif rough:
            state = CellState(np.zeros(grid.cells), undeformed, (0.0, 0.0), 0.0, Status.CONVERGED)
        else:
            remedy = "give more cells, or a region around the place where it is"
            raise InputError("gap", np.inf, "be finite at the centre of at least one cell", remedy)
        loads = state.pressure.sum(axis=0) * level.dx * level.dy
        along = level.y, state.pressure.max(axis=0), half_widths(state.pressure, level.dx)
        levels.append(GridLevel(level.cells, *state.rigid, float(loads.sum()), float(loads @ level.y), along))
    return Outcome(grid, state, count, tuple(levels))


def solve_on_half(
    problem: PatchProblem, outcome: Outcome, tolerance: float, pool: Executor | None = None
) -> tuple[GridLevel, ...]:
    """Return up to two grids, each with half as many cells in both directions, and the finest; from coarse to fine.

    The cascade stops halving a direction at 16 cells, which hides the error of having few cells; grids that it lacks
    are solved here just for the error estimate, and are small.
    """
    levels, cells = [outcome.levels[-1]], outcome.grid.cells
    for _ in range(2):
        if min(cells) < 2 * FEWEST:
            break
        cells = -(-cells[0] // 2), -(-cells[1] // 2)
        known = [level for level in outcome.levels if level.cells == cells]
        if not known:
            coarser = solve_on(problem, replace(outcome.grid, cells=cells), max(tolerance, ROUGHLY), pool, rough=True)
            if coarser.state.status is not Status.CONVERGED or not coarser.state.pressure.any():
                break
            known = [coarser.levels[-1]]
        levels.append(known[0])
    return tuple(reversed(levels))


def refine_pressure(pressure: Array, cells: tuple[int, int]) -> Array:
    """Return a pressure on a finer grid over the same region, linear between cell centres.

    The footprint becomes slightly too large, which is the safe side: cells leave it more readily than they enter.
    """
    places = [(np.arange(new) + 0.5) * (old / new) - 0.5 for old, new in zip(pressure.shape, cells, strict=True)]
    across, along = (interpolation(positions, old, 2) for positions, old in zip(places, pressure.shape, strict=True))
    finer: Array = np.maximum(across @ pressure @ along.T, 0.0)
    return finer
