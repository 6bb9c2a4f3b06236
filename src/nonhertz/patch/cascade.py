"""From coarse to fine: each grid starts from the pressure on one with half as many cells in each direction.

A contact set known to within a cell on the coarser grid takes a few changes on the finer one, whatever the number of
cells, so the number of convolutions hardly grows and the cost is O(n log n); all coarser grids together cost a third of
the finest. The change from grid to grid estimates the discretisation error.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.influence import Influence
from nonhertz.errors import InputError
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.footprint import half_widths
from nonhertz.patch.grid import Grid
from nonhertz.patch.inverse import Inverse
from nonhertz.patch.settle import CellState, Task, settle
from nonhertz.result.solution import Status

Array = NDArray[np.float64]
Gap = Callable[[Array, Array], Array]

# On coarser grids a residual below this is not worth another convolution: the error estimate needs no more digits.
ROUGHLY = 1e-6
FEWEST = 4  # cells in either direction
WITHIN = 0.25  # of a cell: how far inside the outermost rows a rough grid keeps the lever arm of a moment


@dataclass(frozen=True, eq=False)
class PatchProblem:
    """The problem to solve, independent of a grid.

    Attributes
    ----------
    gap : callable
        x, y [mm], of shapes (nx, 1) and (1, ny) -> undeformed gap [mm].
    influence : Influence
        Side faces and depths.
    by_force : tuple of bool
        Whether load and moment are given, rather than approach and tilt.
    given : tuple of float
        Approach [mm] or K Q [mm^2], and tilt [rad] or K T [mm^3].
    compliance : float
        K [1/MPa], only for error messages.
    """

    gap: Gap
    influence: Influence
    by_force: tuple[bool, bool]
    given: tuple[float, float]
    compliance: float

    def undeformed(self, grid: Grid) -> Array:
        """Return the undeformed gap [mm] on the cells of a grid, infinite in cells without a body."""
        return self.gap(grid.x[:, None], grid.y[None, :])

    def task(self, grid: Grid, undeformed: Array, pool: Executor | None, rough: bool = False) -> Task:
        """Return the problem on a grid; if ``rough``, the moment is brought within reach of the cells.

        Raises
        ------
        InputError
            If the grid is not rough and its cells cannot carry the moment.
        """
        first, second = self.given
        if self.by_force[1]:
            rows = grid.y[np.isfinite(undeformed).any(axis=0)]
            second = self._moment(rows, WITHIN * grid.dy) if rough else second
            if not rough:
                self._refuse_out_of_reach(float(rows[0]), float(rows[-1]))
        area = grid.dx * grid.dy
        target = (first / area if self.by_force[0] else first, second / area if self.by_force[1] else second)
        convolution, inverse = Convolution(grid, self.influence, pool), Inverse(grid, pool)
        return Task(undeformed, convolution, inverse, grid.y, self.by_force, target)

    def _moment(self, rows: Array, within: float) -> float:
        """Return the moment, times K, closest to the given one that rows of cells at ``rows`` can carry."""
        first, second = self.given
        low, high = float(rows[0]), float(rows[-1])
        if self.by_force[0]:
            # A coarse grid may have no cell that far out.
            middle, reach = 0.5 * (low + high), max(0.5 * (high - low) - within, 0.0)
            return first * float(np.clip(second / first, middle - reach, middle + reach))
        return 0.0 if (second > 0.0 >= high) or (second < 0.0 <= low) else second

    def _refuse_out_of_reach(self, low: float, high: float) -> None:
        """Refuse a moment that cells between two lever arms [mm] cannot carry.

        Raises
        ------
        InputError
        """
        first, second = self.given
        given = float(f"{second / self.compliance:.12g}")  # without the rounding of K
        outermost = "the centres of the outermost cells that can bear a pressure"
        if self.by_force[0] and not low <= second / first <= high:
            condition = (
                f"keep moment / load = {mm(second / first):.6g} between {mm(low, high, between=' and '):.6g}, "
                f"{outermost}"
            )
            raise InputError("moment", given, condition, "reduce it, or give more cells along or a larger region")
        if not self.by_force[0] and ((second > 0.0 >= high) or (second < 0.0 <= low)):
            condition = (
                f"have the sign of the lever arms, which lie between {mm(low, high, between=' and '):.6g}, {outermost}"
            )
            raise InputError("moment", given, condition, "reverse its sign, or give a larger region")


@dataclass(frozen=True)
class GridLevel:
    """What is kept from a grid: enough to compute how much a finer one changes."""

    cells: tuple[int, int]
    approach: float
    tilt: float
    load: float
    moment: float
    along: tuple[Array, Array, Array]  # y, the largest pressure across, times K, and the half-width there


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
    """Solve on coarser grids first and on the given one last, which may itself be ``rough``."""
    pressure, rigid, levels = None, (0.0, 0.0), []
    for each in (*reversed(list(grid.coarser())), grid):
        finest = each is grid
        undeformed = problem.undeformed(each)
        if not np.isfinite(undeformed).any():
            # The bodies lie between the cell centres; a finer grid may have centres on them.
            if not finest:
                continue
            return _empty(grid, undeformed, rough)
        task = problem.task(each, undeformed, pool, rough or not finest)
        pressure = _first(task) if pressure is None else refined(pressure, each.cells)
        state = settle(task, pressure, rigid, tolerance if finest else max(tolerance, ROUGHLY))
        pressure, rigid = state.pressure, state.rigid
        levels.append(_level(each, state))
    return Outcome(grid, state, task.displacement.count, tuple(levels))


def _empty(grid: Grid, undeformed: Array, rough: bool) -> Outcome:
    """Return the outcome on a rough grid of which no cell has a body: nothing touches.

    Raises
    ------
    InputError
        If the grid is not rough.
    """
    if not rough:
        remedy = "give more cells, or a region around the place where it is"
        raise InputError("gap", np.inf, "be finite at the centre of at least one cell", remedy)
    state = CellState(np.zeros(grid.cells), undeformed, (0.0, 0.0), 0.0, Status.CONVERGED)
    return Outcome(grid, state, 0, (_level(grid, state),))


def halved(
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
            grid = Grid(outcome.grid.x_span, outcome.grid.y_span, cells)
            found = solve_on(problem, grid, max(tolerance, ROUGHLY), pool, rough=True)
            if found.state.status is not Status.CONVERGED or not found.state.pressure.any():
                break
            known = [found.levels[-1]]
        levels.append(known[0])
    return tuple(reversed(levels))


def _level(grid: Grid, state: CellState) -> GridLevel:
    loads = state.pressure.sum(axis=0) * grid.dx * grid.dy
    along = grid.y, state.pressure.max(axis=0), half_widths(state.pressure, grid.dx)
    return GridLevel(grid.cells, *state.rigid, float(loads.sum()), float(loads @ grid.y), along)


def refined(pressure: Array, cells: tuple[int, int]) -> Array:
    """Return a pressure on a finer grid over the same region, linear between cell centres.

    The footprint comes out somewhat too large, which is the safe side: cells leave it more readily than they enter.
    """
    for axis in (0, 1):
        old, new = pressure.shape[axis], cells[axis]
        place = (np.arange(new) + 0.5) * (old / new) - 0.5
        below = np.clip(place.astype(int), 0, max(old - 2, 0))
        share = (place - below).reshape((-1, 1) if axis == 0 else (1, -1))
        above = np.minimum(below + 1, old - 1)
        pressure = (1.0 - share) * pressure.take(below, axis) + share * pressure.take(above, axis)
    return np.maximum(pressure, 0.0)


def _first(task: Task) -> Array:
    """Return a pressure to start from: springs, acting in the half of the cells that would touch first."""
    tilt = 0.0 if task.by_force[1] else task.target[1]
    nearness = tilt * task.y - task.undeformed
    return np.maximum(nearness - float(np.median(nearness[task.bearing])), 0.0)
