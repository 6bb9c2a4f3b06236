"""One search of a design, by sequential quadratic programming with exact gradients.

The lowest peak pressure is found in the form: least t such that the maximum pressure of every third of every contact
is at most t, which is smooth where the largest one changes its place.

References
----------
D. Kraft, A software package for sequential quadratic programming, DFVLR-FB 88-28, 1988.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import NonhertzError
from nonhertz.study.objective import PRESSURE, SEARCHING, DesignPoint, Task, try_point

Array = NDArray[np.float64]

# Steps of a search, the change of the goal at which it ends, and the number of restarts.
STEPS, CLOSE, AGAIN = 20, 1e-4, 2
_BAD = 10.0  # logarithm of the goal at an invalid point


@dataclass(frozen=True)
class Search:
    """The end of a search."""

    begun: Array
    ended: Array
    value: float
    history: tuple[float, ...]
    least_margin: float
    failure: str = ""


def search_from(job: tuple[int, Task, Array]) -> Search:
    """Search from one start; called in other processes."""
    _, task, x = job
    return _Searcher(task).run(x)


class _Searcher:
    """A search, with the last point evaluated and the best one."""

    def __init__(self, task: Task) -> None:
        self._task = task
        self._at: tuple[bytes, DesignPoint | None] = (b"", None)
        self._best: tuple[float, Array, float] | None = None
        self._history: list[float] = []
        self._accuracy: float | None = None

    def run(self, begun: Array) -> Search:
        """Return the end of the search."""
        x = begun
        for accuracy in (SEARCHING, None) if self._task.is_automatic else (None,):
            self._accuracy, self._best, self._at = accuracy, None, (b"", None)
            if self._evaluate(x) is None:
                why = "It could not be solved."
                try:
                    self._task.at(x)
                except NonhertzError as error:
                    why = str(error)
                return Search(begun, x, math.nan, tuple(self._history), -math.inf, why)
            x = self._improve(x)
        assert self._best is not None
        value, x, margin = self._best
        return Search(begun, x, value, tuple(self._history), margin)

    def _improve(self, x: Array) -> Array:
        """Return the best point that a search from ``x`` finds."""
        search = self._for_pressure if self._task.goal == PRESSURE else self._for_life
        for _ in range(1 + AGAIN):
            first = self._evaluate(x)
            assert first is not None
            done = search(x, first)
            assert self._best is not None
            x = self._best[1]
            if done:
                break
            # A search that fails is restarted from the best point, without its approximation of the curvature.
        return x

    def _evaluate(self, x: Array) -> DesignPoint | None:
        key = x.tobytes()
        if self._at[0] != key:
            judged = try_point(self._task, np.clip(x, 0.0, 1.0), self._accuracy)
            self._at = key, judged
            if judged is not None:
                self._note(judged)
        return self._at[1]

    def _note(self, judged: DesignPoint) -> None:
        margin, value = judged.spare, judged.value
        # A point that meets all limits is better than any that does not; 1e-6 is tolerated as noise.
        rank = (min(margin + 1e-6, 0.0), -value)
        if self._best is None or rank > (min(self._best[2] + 1e-6, 0.0), -self._best[0]):
            self._best = value, judged.x.copy(), margin
        self._history.append(self._best[0])

    def _for_life(self, begun: Array, first: DesignPoint) -> bool:
        def value(x: Array) -> float:
            judged = self._evaluate(x)
            return _BAD if judged is None else math.log(judged.damage / first.damage)

        def slope(x: Array) -> Array:
            judged = self._evaluate(x)
            return np.zeros(x.size) if judged is None else judged.slope_of_damage()

        return _minimize(value, slope, begun, 0, self._limits(begun.size, 0))

    def _for_pressure(self, begun: Array, first: DesignPoint) -> bool:
        scale, count, task = math.log(first.largest[0]), begun.size, self._task
        height = task.zones * len(task.loads)

        def spare(judged: DesignPoint, t: float) -> Array:
            """Return the logarithm of its cap, or of the largest peak, less that of each peak."""
            caps = [t + scale if (cap := task.cap(n)) is None else math.log(cap) for n in range(len(task.loads))]
            return np.array([caps[number] - peak for number, _, peak in judged.peaks()])

        def rows(z: Array) -> Array:
            judged = self._evaluate(z[:count])
            if judged is None:
                return np.full(height, z[-1] - _BAD)
            margins = spare(judged, z[-1])
            return np.pad(margins, (0, height - margins.size), constant_values=margins.max())

        def slopes(z: Array) -> Array:
            judged, jacobian = self._evaluate(z[:count]), np.zeros((height, count + 1))
            if judged is not None:
                peaks = judged.peaks()
                jacobian[: len(peaks), :count] = -judged.slopes_of_peaks(peaks)
                jacobian[: len(peaks), -1] = [task.cap(number) is None for number, _, _ in peaks]
                # A zone without contact has no peak: its row repeats one that is met.
                jacobian[len(peaks) :] = jacobian[int(np.argmax(spare(judged, z[-1])))]
            return jacobian

        only_last = np.append(np.zeros(count), 1.0)
        constraints = [{"type": "ineq", "fun": rows, "jac": slopes}, *self._limits(count, 1)]
        return _minimize(lambda z: float(z[-1]), lambda z: only_last, np.append(begun, 0.0), 1, constraints)

    def _limits(self, count: int, more: int) -> list[dict[str, Any]]:
        """Return the constraints on variables and on ``more`` further unknowns."""
        task, constraints = self._task, []

        def of_forms(z: Array) -> Array:
            return np.concatenate([margins for _, margins, _ in task.of_forms(z[:count])])

        def slopes_of_forms(z: Array) -> Array:
            parts = []
            for mine, _, own in task.of_forms(z[:count]):
                parts.append(np.zeros((len(own), count + more)))
                parts[-1][:, np.flatnonzero(mine)] = own
            return np.concatenate(parts)

        rows = len(task.loads) * sum(len(limit.sides) for limit in task.limits)

        def margins(z: Array) -> Array:
            judged = self._evaluate(z[:count])
            return np.full(rows, -1.0) if judged is None else judged.margins()

        def slopes(z: Array) -> Array:
            judged = self._evaluate(z[:count])
            exact = None if judged is None else judged.slopes_of_margins()
            by_x = self._differences(z[:count], rows) if exact is None else exact
            return np.hstack([by_x, np.zeros((rows, more))])

        if any(variable.form is not None for variable in task.variables):
            constraints.append({"type": "ineq", "fun": of_forms, "jac": slopes_of_forms})
        if rows:
            constraints.append({"type": "ineq", "fun": margins, "jac": slopes})
        return constraints

    def _differences(self, x: Array, rows: int) -> Array:
        """Return derivatives of margins that have no gradient, by differences."""
        slopes = np.zeros((rows, x.size))
        here = self._evaluate(x)
        for k in range(x.size if here is not None else 0):
            moved = x.copy()
            moved[k] += 0.01 if x[k] < 0.5 else -0.01
            beside = try_point(self._task, moved, self._accuracy)
            if beside is not None and here is not None:
                slopes[:, k] = (beside.margins() - here.margins()) / (moved[k] - x[k])
        return slopes


def _minimize(
    goal: Callable[[Array], float],
    slope: Callable[[Array], Array],
    begun: Array,
    free: int,
    constraints: Sequence[Mapping[str, Any]],
) -> bool:
    """Minimise a goal, whose last ``free`` unknowns have no bounds; return whether the search converged."""
    from scipy.optimize import minimize

    bounds = [(0.0, 1.0)] * (begun.size - free) + [(None, None)] * free
    options = {"maxiter": STEPS, "ftol": CLOSE}
    solution = minimize(goal, begun, jac=slope, method="SLSQP", bounds=bounds, constraints=constraints, options=options)
    return bool(solution.success)
