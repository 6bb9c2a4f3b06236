"""The objective of a design: numbers under all its loads and their derivatives, at a point of its variables.

Variables run from 0 to 1 between their bounds: linearly or, if the bounds are far apart, logarithmically. Derivatives
come from one adjoint solve for each number (`nonhertz.Solution.gradient`); for a profile, from the change of the relief
under every strip with a step of the variable.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import NonhertzError, without_accuracy_warnings
from nonhertz.files.casefile import Case
from nonhertz.files.free_forms import FreeForm, half_length
from nonhertz.files.paths import drop_before_parameters
from nonhertz.files.planfile import Template
from nonhertz.life import ContactLoadCase, Model
from nonhertz.model.contact import Contact
from nonhertz.result.gradient import Gradient
from nonhertz.result.maximum import singular_y, values_that_count
from nonhertz.result.measures import PressureAt
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.solver.many import solve_without_warnings
from nonhertz.solver.one import is_automatic
from nonhertz.study.limits import Limit
from nonhertz.study.lives import damage

Array = NDArray[np.float64]

WIDE = 10.0  # ratio of bounds from which a variable is taken in its logarithm
STEP = 1e-4  # of a variable, for differences of the bodies' shapes
FEWEST_ZONES, ZONES_PER_VARIABLE = 3, 2  # of the contact, each with its maximum pressure
# Accuracy of a first search: mostly within 0.2 % of the pressure, in two thirds of the time. Occasionally strips miss a
# narrow peak, so that a second search with the accuracy of the case continues from there.
SEARCHING = 3e-4
PRESSURE, LIFE = "pressure", "life"
GOALS = (PRESSURE, LIFE)
_WITH_GRADIENT = ("approach", "load", "moment", "max_pressure", "max_half_width")


@dataclass(frozen=True)
class Variable:
    """A variable of a design: a number between bounds, or an increment of a free profile."""

    path: str  # of the number, or that of the profile
    low: float  # bounds, in the base unit
    high: float
    form: FreeForm | None = None  # the free profile

    @property
    def logarithmic(self) -> bool:
        """Whether the variable is taken in its logarithm."""
        return self.form is None and self.low > 0.0 and self.high > WIDE * self.low

    def value(self, share: float) -> float:
        """Return the number at a fraction of the range between the bounds."""
        if self.logarithmic:
            return float(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share

    def share(self, value: float) -> float:
        """Return the position of a number between the bounds, from 0 to 1."""
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


@dataclass(frozen=True)
class Task:
    """The task of a design, in a form that can be sent to other processes."""

    template: Template  # the case
    variables: tuple[Variable, ...]  # to be chosen
    loads: tuple[ContactLoadCase, ...]  # with their shares of the revolutions
    goal: str  # "pressure", the lowest peak, or "life", the longest
    model: Model  # of fatigue
    limits: tuple[Limit, ...] = ()  # to be met
    # Maximum pressure allowed under each load [MPa]; None if its pressure is the goal; empty if that holds for all
    # loads.
    caps: tuple[float | None, ...] = ()

    @property
    def zones(self) -> int:
        """The number of zones of a contact: more than variables, so that no peak is missed between them."""
        return max(FEWEST_ZONES, ZONES_PER_VARIABLE * len(self.variables) + 1)

    def cap(self, number: int) -> float | None:
        """Return the maximum pressure allowed under a load [MPa]; None if its pressure is the goal."""
        return self.caps[number] if self.caps else None

    @property
    def is_automatic(self) -> bool:
        """Whether the case leaves its accuracy open."""
        solver = self.template.document.get("solver", {})
        return is_automatic(solver.get("strips", "auto")) and "accuracy" not in solver

    def values(self, x: Array) -> dict[str, Any]:
        """Return the value of each path; for a free profile its increments."""
        by_path: dict[str, Any] = {}
        for variable, share in zip(self.variables, x.tolist(), strict=True):
            if variable.form is None:
                by_path[variable.path] = variable.value(share)
            else:
                by_path.setdefault(variable.path, []).append(variable.value(share))
        return by_path

    def of_forms(self, x: Array) -> list[tuple[NDArray[np.bool_], Array, Array]]:
        """Return for every free profile which variables it has, the margins of its bounds, and their slopes."""
        parts = []
        for path, form in {
            variable.path: variable.form for variable in self.variables if variable.form is not None
        }.items():
            mine = np.array([variable.path == path for variable in self.variables])
            half = half_length(self.template.document, self.template.known[path].keys)
            parts.append((mine, *form.margins(x[mine], half)))
        return parts

    def document(self, x: Array) -> dict[str, Any]:
        """Return the document of the case at a point."""
        document, forms = self.template.document, {variable.path: variable.form for variable in self.variables}
        for path, value in drop_before_parameters(self.values(x)):
            parameter, form = self.template.known[path], forms[path]
            tables = value if form is None else form.tables(document, parameter.keys, value)
            document = parameter.put(document, tables)
        return document

    def case(self, x: Array) -> Case:
        """Return the case at a point.

        Raises
        ------
        CaseError
            If the case is not valid.
        """
        read = self.template.of_document(self.document(x))
        assert isinstance(read, Case)
        return read

    def at(self, x: Array, accuracy: float | None = None) -> DesignPoint:
        """Return the case under all loads at a point; ``accuracy`` applies if the case leaves it open.

        Raises
        ------
        NonhertzError
            If the case is not valid, or a load has no solution.
        """
        case = self.case(x)
        with without_accuracy_warnings():
            solver = case.solver.keywords | ({"accuracy": accuracy} if self.is_automatic else {})
            pressed = {name: [getattr(load, name) for load in self.loads] for name in ("load", "tilt")}
            solutions = tuple(solve_without_warnings(case.contact, pressed, **solver))
        return DesignPoint(self, x.copy(), case, solutions)


@dataclass(frozen=True, eq=False)
class DesignPoint:
    """A point of a design under all its loads."""

    task: Task
    x: Array
    case: Case
    solutions: tuple[Solution, ...]

    @property
    def value(self) -> float:
        """The number to be minimised: the maximum pressure [MPa], or the damage, which shortens lives."""
        return self.largest[0] if self.task.goal == PRESSURE else self.damage

    @property
    def largest(self) -> tuple[float, int]:
        """The maximum pressure under all loads [MPa], and the number of its load."""
        pressures = [
            solution.max_pressure if self.task.cap(number) is None else 0.0
            for number, solution in enumerate(self.solutions)
        ]
        return max(pressures), int(np.argmax(pressures))

    @property
    def damages(self) -> Array:
        """The damage of a revolution under each load, in any unit, shape (loads,)."""
        measure = damage(self.task.model)
        return np.array([measure.partials(solution).value for solution in self.solutions]) ** (
            1.0 / self.task.model.slope
        )

    @property
    def damage(self) -> float:
        """The mean damage of a revolution, in any unit."""
        return float(np.dot([load.share for load in self.task.loads], self.damages))

    def peaks(self) -> list[tuple[int, float, float]]:
        """Return number of the load, position and logarithm of the maximum pressure of every zone.

        As for `Solution.max_pressure`, places within a half-width of singular ends do not count.
        """
        tops = []
        for number, solution in enumerate(self.solutions):
            arrays = solution.y, solution.centre_pressure, solution.half_width
            places, pressure, _ = values_that_count(*arrays, singular_y(solution))
            touching = np.flatnonzero(pressure > 0.0)
            along = touching[np.argsort(places[touching], kind="stable")]
            for zone in np.array_split(along, self.task.zones):
                if zone.size:
                    at = int(zone[np.argmax(pressure[zone])])
                    tops.append((number, float(places[at]), math.log(pressure[at])))
        return tops

    def slopes_of_peaks(self, peaks: Sequence[tuple[int, float, float]]) -> Array:
        """Return the derivatives of the logarithms of peaks by the variables, shape (peaks, variables)."""
        return np.array([self.slopes(number, PressureAt(y)) / math.exp(value) for number, y, value in peaks])

    def slope_of_damage(self) -> Array:
        """Return the derivatives of the logarithm of the damage by the variables, shape (variables,)."""
        measure, exponent = damage(self.task.model), 1.0 / self.task.model.slope
        total = np.zeros(len(self.task.variables))
        for number, (load, part) in enumerate(zip(self.task.loads, self.damages.tolist(), strict=True)):
            value = measure.partials(self.solutions[number]).value
            total += load.share * part * exponent / value * self.slopes(number, measure)
        return total / self.damage

    def slopes(self, number: int, quantity: Any) -> Array:
        """Return the derivatives of a number of one load by the variables, shape (variables,)."""
        gradient = self.solutions[number].gradient(quantity, holding=("load", "tilt"))
        return np.array([self._by(gradient, number, k) for k in range(len(self.task.variables))])

    def _by(self, gradient: Gradient, number: int, k: int) -> float:
        if (number, k) in self._reliefs:
            return float(gradient.relief @ self._reliefs[number, k])
        return gradient.along(lambda share: self._move_variable(k, share), float(self.x[k]), STEP)

    def _move_variable(self, k: int, share: float) -> Contact:
        """Return the contact with one variable elsewhere."""
        x = self.x.copy()
        x[k] = share
        return self.task.case(x).contact

    @cached_property
    def _reliefs(self) -> dict[tuple[int, int], Array]:
        """The change of the separation at the strips of each load with each variable of a profile."""
        reliefs = {}
        for k, variable in enumerate(self.task.variables):
            if ".profile" not in variable.path:
                continue
            low, high = max(self.x[k] - STEP, 0.0), min(self.x[k] + STEP, 1.0)
            below, above = self._move_variable(k, low), self._move_variable(k, high)
            for number, solution in enumerate(self.solutions):
                with np.errstate(invalid="ignore"):
                    change = (above.separation_at(solution.y) - below.separation_at(solution.y)) / (high - low)
                reliefs[number, k] = np.where(np.isfinite(change), change, 0.0)
        return reliefs

    def margins(self) -> Array:
        """Return the margin of every limit under every load, relative to the limit; negative if it is not met."""
        return np.array(
            [
                sign * (float(QUANTITIES[limit.name].get(solution)) - bound) / abs(bound)
                for limit in self.task.limits
                for solution in self.solutions
                for sign, bound in limit.sides
            ]
        )

    @property
    def spare(self) -> float:
        """The smallest relative margin of all limits, caps and bounds of free profiles; infinite without any."""
        caps = [(cap - solution.max_pressure) / cap for solution, cap in self._capped()]
        forms = [margin for _, margins, _ in self.task.of_forms(self.x) for margin in margins.tolist()]
        return float(min((*self.margins(), *caps, *forms), default=math.inf))

    def _capped(self) -> list[tuple[Solution, float]]:
        pairs = ((solution, self.task.cap(number)) for number, solution in enumerate(self.solutions))
        return [(solution, cap) for solution, cap in pairs if cap is not None]

    def slopes_of_margins(self) -> Array | None:
        """Return the derivatives of the margins, shape (margins, variables); None if a quantity has no gradient."""
        if any(limit.name not in _WITH_GRADIENT for limit in self.task.limits):
            return None
        rows = [
            sign / abs(bound) * slopes
            for limit in self.task.limits
            for slopes in (self.slopes(number, limit.name) for number in range(len(self.solutions)))
            for sign, bound in limit.sides
        ]
        return np.array(rows).reshape(-1, len(self.task.variables))


def try_point(task: Task, x: Array, accuracy: float | None = None) -> DesignPoint | None:
    """Return the evaluation of a point; None if the case is not valid or has no solution."""
    try:
        return task.at(x, accuracy)
    except NonhertzError:
        return None
