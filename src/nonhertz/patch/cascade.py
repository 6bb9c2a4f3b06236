"""From coarse to fine: each grid starts from the pressure on one with half as many cells either way.

A set that is known to a cell on the coarser grid takes a few changes on the finer one, whatever their size, so the
number of convolutions hardly grows and the cost is that of n log n; all coarser grids together cost a third of the
finest. What changes from grid to grid tells the error of discretisation.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.finite import Influence
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.grid import Grid
from nonhertz.patch.inverse import Inverse
from nonhertz.patch.settle import State, Task, settle
from nonhertz.solution import Status

Array = NDArray[np.float64]
Gap = Callable[[Array, Array], Array]

# On coarser grids no residual below this is worth a convolution: the error estimate needs no more digits.
ROUGHLY = 1e-6
FEWEST = 4  # cells in either direction
# Stands for an infinite gap, in spans of the finite ones.
NEVER = 10.0


@dataclass(frozen=True, eq=False)
class Problem:
    """What is solved, without a grid.

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
        K [1/MPa], for complaints alone.
    """

    gap: Gap
    influence: Influence
    by_force: tuple[bool, bool]
    given: tuple[float, float]
    compliance: float

    def undeformed(self, grid: Grid) -> Array:
        """Return the undeformed gap [mm] on the cells of a grid.

        Raises
        ------
        InputError
            If the gap is infinite everywhere.
        """
        gap = self.gap(grid.x[:, None], grid.y[None, :])
        finite = np.isfinite(gap)
        if not np.any(finite):
            remedy = "let it return a gap in mm for some x and y of the region"
            raise InputError("gap", np.inf, "be finite somewhere", remedy)
        if not np.all(finite):
            highest, lowest = float(np.max(gap[finite])), float(np.min(gap[finite]))
            gap[~finite] = highest + NEVER * (highest - lowest) + 1.0
        return gap

    def task(self, grid: Grid, pool: Executor | None, rough: bool = False) -> Task:
        """Return the problem on a grid; a rough one brings the moment within reach of the cells.

        Raises
        ------
        InputError
            If no cells of a grid that is not rough can bear the moment.
        """
        undeformed = self.undeformed(grid)
        first, second = self.given
        if all(self.by_force):
            second = first * self._arm(grid, second / first, rough)
        area = grid.dx * grid.dy
        target = (first / area if self.by_force[0] else first, second / area if self.by_force[1] else second)
        convolution, inverse = Convolution(grid, self.influence, pool), Inverse(grid, pool)
        return Task(undeformed, convolution, inverse, grid.y, self.by_force, target)

    def _arm(self, grid: Grid, arm: float, rough: bool) -> float:
        """Return the lever arm of the moment [mm], within reach of a coarse grid, refused out of that of the finest."""
        if rough:
            # A coarse grid may have no cell as far out.
            reach = 0.5 * (grid.cells[1] - 1.5) * grid.dy
            middle = 0.5 * sum(grid.y_span)
            return float(np.clip(arm, middle - reach, middle + reach))
        low, high = float(grid.y[0]), float(grid.y[-1])
        if not low <= arm <= high:
            condition = (
                f"keep moment / load = {arm:.6g} mm between {low:.6g} and {high:.6g} mm, the centres of the outermost "
                "cells"
            )
            remedy = "give more cells along or a larger region, or reduce it"
            given = float(f"{self.given[1] / self.compliance:.12g}")  # without the rounding of K
            raise InputError("moment", given, condition, remedy)
        return arm


@dataclass(frozen=True)
class Level:
    """What is kept of a grid: enough to tell how much a finer one changes."""

    cells: tuple[int, int]
    approach: float
    load: float
    max_pressure: float


@dataclass(frozen=True, eq=False)
class Outcome:
    """The finest grid's solution, pressures times K, and what the coarser ones had come to."""

    grid: Grid
    state: State
    convolutions: int
    levels: tuple[Level, ...]


def solve_on(
    problem: Problem, grid: Grid, tolerance: float, pool: Executor | None = None, rough: bool = False
) -> Outcome:
    """Solve on coarser grids first, on the given one last, which may be a rough one too."""
    pressure, rigid, levels = None, (0.0, 0.0), []
    for each in (*reversed(list(grid.coarser())), grid):
        finest = each is grid
        task = problem.task(each, pool, rough or not finest)
        pressure = _first(task) if pressure is None else refined(pressure, each.cells)
        state = settle(task, pressure, rigid, tolerance if finest else max(tolerance, ROUGHLY))
        pressure, rigid = state.pressure, state.rigid
        levels.append(_level(each, state))
    return Outcome(grid, state, task.displacement.count, tuple(levels))


def halved(problem: Problem, outcome: Outcome, tolerance: float, pool: Executor | None = None) -> tuple[Level, ...]:
    """Return up to two grids with half as many cells each in both directions, and the finest; from coarse to fine.

    The cascade stops halving a direction at 16 cells, and so says nothing of what few cells leave out; what it lacks
    of these grids is solved for the estimate of the error alone, and small.
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
            if found.state.status is not Status.CONVERGED:
                break
            known = [found.levels[-1]]
        levels.append(known[0])
    return tuple(reversed(levels))


def _level(grid: Grid, state: State) -> Level:
    load = float(state.pressure.sum()) * grid.dx * grid.dy
    return Level(grid.cells, state.rigid[0], load, float(state.pressure.max()))


def refined(pressure: Array, cells: tuple[int, int]) -> Array:
    """Return a pressure on a finer grid over the same region, linear between the centres of cells.

    The footprint comes out somewhat too large, which is the side to err on: cells leave it more readily than others
    enter.
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
    """Return a pressure to start from: springs, under the half of the cells that would touch first."""
    tilt = 0.0 if task.by_force[1] else task.target[1]
    nearness = tilt * task.y - task.undeformed
    return np.maximum(nearness - float(np.median(nearness)), 0.0)
