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

Array = NDArray[np.float64]
Gap = Callable[[Array, Array], Array]

# On coarser grids no residual below this is worth a convolution: the error estimate needs no more digits.
ROUGHLY = 1e-6
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
    """

    gap: Gap
    influence: Influence
    by_force: tuple[bool, bool]
    given: tuple[float, float]

    def undeformed(self, grid: Grid) -> Array:
        """Return the undeformed gap [mm] on the cells of a grid.

        Raises
        ------
        InputError
            If the gap has another shape, is not a number somewhere or infinite everywhere.
        """
        remedy = "let it return a gap in mm for every x and y"
        try:
            gap = np.array(np.broadcast_to(self.gap(grid.x[:, None], grid.y[None, :]), grid.cells), dtype=float)
        except ValueError:
            raise InputError("gap", self.gap, "keep the shape that x and y have together", remedy) from None
        finite = np.isfinite(gap)
        if np.any(np.isnan(gap)) or np.any(gap == -np.inf) or not np.any(finite):
            raise InputError("gap", self.gap, "be a number, or plus infinity where nothing can touch", remedy)
        if not np.all(finite):
            highest, lowest = float(np.max(gap[finite])), float(np.min(gap[finite]))
            gap[~finite] = highest + NEVER * (highest - lowest) + 1.0
        return gap

    def task(self, grid: Grid, pool: Executor | None) -> Task:
        """Return the problem on a grid."""
        first, second = self.given
        if all(self.by_force):
            # A coarse grid may have no cell as far out as the moment's lever arm.
            reach = 0.5 * (grid.cells[1] - 1.5) * grid.dy
            middle = 0.5 * sum(grid.y_span)
            second = first * float(np.clip(second / first, middle - reach, middle + reach))
        area = grid.dx * grid.dy
        target = (first / area if self.by_force[0] else first, second / area if self.by_force[1] else second)
        convolution, inverse = Convolution(grid, self.influence, pool), Inverse(grid, pool)
        return Task(self.undeformed(grid), convolution, inverse, grid.y, self.by_force, target)


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


def solve_on(problem: Problem, grid: Grid, tolerance: float, pool: Executor | None = None) -> Outcome:
    """Solve on coarser grids first, on the given one last."""
    pressure, rigid, levels = None, (0.0, 0.0), []
    for each in (*reversed(list(grid.coarser())), grid):
        task = problem.task(each, pool)
        pressure = _first(task) if pressure is None else refined(pressure, each.cells)
        finest = each is grid
        state = settle(task, pressure, rigid, tolerance if finest else max(tolerance, ROUGHLY))
        pressure, rigid = state.pressure, state.rigid
        load = float(pressure.sum()) * each.dx * each.dy
        levels.append(Level(each.cells, rigid[0], load, float(pressure.max())))
    return Outcome(grid, state, task.displacement.count, tuple(levels))


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
