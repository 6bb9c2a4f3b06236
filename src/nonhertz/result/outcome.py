"""From a result of the core to a solution: refusals, ends of contacts, and strains of the model."""

from __future__ import annotations

import contextlib
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError
from nonhertz.findings import Finding
from nonhertz.model.side_faces import SERIES
from nonhertz.native import core
from nonhertz.result.edges import EdgeKind, EdgePressure, SingularEnd
from nonhertz.result.end_pressure import add_strengths, edge_pressures
from nonhertz.result.shortfall import shortfall
from nonhertz.result.solution import Solution
from nonhertz.result.solved import not_finite
from nonhertz.result.status import ErrorEstimate, Status
from nonhertz.result.validity import is_strained, refuse_wide, refuse_wide_series, singularities, strains
from nonhertz.strip.problem import Problem, StripModel

Array = NDArray[np.float64]

PATIENT_STRIPS = core.PATIENT_STRIPS
_WAY_OUT = "Try another number of strips, or a smaller load first."
_FEWER = f"Give fewer strips: on more than {PATIENT_STRIPS}, where a step takes seconds, few other starts are tried."
_STATUS = {
    core.Status.CONVERGED: Status.CONVERGED,
    core.Status.ITERATION_LIMIT: Status.ITERATION_LIMIT,
    core.Status.STAGNATED: Status.STAGNATED,
}
_NONE: Any = contextlib.nullcontext()


def outcome(problem: Problem, result: core.Result) -> Solution:
    """Return the solution of a case, or refuse it.

    Raises
    ------
    InputError
        If a body is too thin for the width of its contact, or a half-width exceeds a body's radius.
    ConvergenceError
        If the Newton loop failed, or if its solution does not meet the prescribed values.
    """
    solution, checks = solution_of(problem, result), result.judgement.checks
    converged = solution.status is Status.CONVERGED
    if not (converged and checks.radius_ratio <= 1.0 and checks.depth_ratio >= 1.0):
        refuse_wide(solution, problem)
    if has_series(problem):
        refuse_wide_series(solution)
    if not converged:
        way_out = _FEWER if solution.strips > PATIENT_STRIPS else _WAY_OUT
        raise ConvergenceError(f"{solution.status.value} {way_out}", solution)
    if not result.holds:
        infinite = (f"The {name} of the state reached is not finite." for name in not_finite(solution))
        unmet = shortfall(problem, result) or next(infinite, None)
        if unmet is not None:
            raise ConvergenceError(f"{unmet} {_WAY_OUT}", replace(solution, status=Status.REFUTED))
    return solution


def has_series(problem: Problem) -> bool:
    """Return whether a body has a series of images, for which wide contacts are refused."""
    return any(body.images == SERIES for body in problem.contact.bodies.values())


def solution_of(problem: Problem, result: core.Result) -> Solution:
    """Return the solution of the core, unchecked."""
    compliance, (approach, tilt), (load, moment) = problem.contact.compliance, result.rigid, result.resultant
    return Solution(
        contact=problem.contact,
        element=problem.model.element,
        status=_STATUS[result.status],
        approach=approach,
        tilt=tilt,
        load=load / compliance,
        moment=moment / compliance,
        stiffness=np.array(result.stiffness) / compliance,
        edges=result.edges,
        line_load=result.line_load(compliance),
        element_half_width=result.half_width(),
        gap=result.gap,
        iterations=result.steps,
        judgement=Judgement(problem, result),
    )


class Judgement:
    """Quantities and findings that follow from the strips of a solution; see `Solution`.

    Parameters
    ----------
    problem : Problem
        The problem that was solved.
    result : core.Result
        The result of the core.
    """

    def __init__(self, problem: Problem, result: core.Result) -> None:
        self.problem, self.result = problem, result

    @classmethod
    def of(cls, **known: Any) -> Judgement:
        """Return a judgement with known attributes, and ``findings``."""
        made = object.__new__(cls)
        vars(made).update(known)
        return made

    def __getstate__(self) -> dict[str, object]:
        if "result" not in vars(self):
            return vars(self)
        return {"problem": self.problem, "kept": (states_of_levels(self.result), self.result.accuracy)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)

    def __getattr__(self, name: str) -> Any:
        # A solution that was sent or saved has the numbers, which are judged again on demand.
        if name != "result" or "kept" not in vars(self):
            raise AttributeError(name)
        problem, (levels, accuracy) = self.problem, vars(self).pop("kept")
        self.result = restore(problem, levels, accuracy)
        return self.result

    @property
    def _core(self) -> core.Judgement:
        return self.result.judgement

    def judged(self, solution: Solution) -> core.Judgement:
        """Return the judgement of the core; for a solution read from a file, by its strips only."""
        if "problem" in vars(self):
            return self._core
        compliance, squares = solution.contact.compliance, solution.element_half_width**2
        ratios = np.divide(compliance * solution.line_load, squares, out=np.zeros_like(squares), where=squares > 0.0)
        rigid, stiffness = (solution.approach, solution.tilt), (compliance * solution.stiffness).tolist()
        status = core.Status.CONVERGED if solution.status is Status.CONVERGED else core.Status.STAGNATED
        state = core.State(ratios, squares, solution.gap, rigid, stiffness, status, solution.iterations, 0.0)
        model = StripModel.of(solution.contact, solution.element).in_core
        return core.judge(model, (False, False), rigid, [core.Level(model, solution.edges, state)], 0.0)

    @cached_property
    def contact_y(self) -> tuple[tuple[float, float], ...]:
        """The intervals in contact."""
        return tuple((low, high) for low, high in self._core.contact)

    @cached_property
    def ends(self) -> tuple[EdgePressure, EdgePressure]:
        """The pressure at both ends, without strengths."""
        return edge_pressures(self.problem, self._core)

    @cached_property
    def edge_pressure(self) -> tuple[EdgePressure, EdgePressure]:
        """The pressure at both ends."""
        edges, state = self.result.levels[0]
        with _NONE if self.result.status is core.Status.CONVERGED else np.errstate(all="ignore"):
            return add_strengths(self.problem, edges, state.r, state.m, self.ends)

    @cached_property
    def singular_ends(self) -> tuple[SingularEnd, ...]:
        """The ends at which the pressure is unbounded."""
        return tuple(
            SingularEnd(end.y, EdgeKind.CORNER if end.is_corner else EdgeKind.SINGULAR) for end in self._core.singular
        )

    @cached_property
    def peaks_at_corner(self) -> bool:
        """Whether the maximum pressure is at a corner."""
        return self._core.peaks_at_corner

    @cached_property
    def error_estimate(self) -> ErrorEstimate:
        """The estimated errors."""
        errors = self._core.errors
        return ErrorEstimate(errors.approach, errors.load, errors.max_pressure, errors.moment, errors.tilt)

    def found(self, solution: Solution) -> tuple[Finding, ...]:
        """Return strains of the model, and ends at which the pressure is unbounded."""
        if "findings" in vars(self) or solution.status is not Status.CONVERGED:
            return tuple(vars(self).get("findings", ()))
        return (*self.strains(solution), *self.singularities(solution))

    def strains(self, solution: Solution) -> tuple[Finding, ...]:
        """Return strains of the model: none in most cases."""
        if not is_strained(self.problem, self._core):
            return ()
        return tuple(strains(solution, self.problem, self._core))

    def singularities(self, solution: Solution) -> tuple[Finding, ...]:
        """Return the ends at which the pressure is unbounded."""
        return singularities(solution, self._core) if self._core.singular else ()


class LevelState(NamedTuple):
    """A state of strips as arrays, which can be saved and sent."""

    edges: Array
    r: Array
    m: Array
    gap: Array
    rigid: Any
    stiffness: Any
    status: int
    steps: int
    residual: float


def states_of_levels(result: core.Result) -> list[LevelState]:
    """Return the states of all levels, finest first."""
    return [
        LevelState(edges, of.r, of.m, of.gap, of.rigid, of.stiffness, int(of.status), of.steps, of.residual)
        for edges, of in result.levels
    ]


def restore(problem: Problem, levels: list[LevelState], accuracy: float, *, accepted: bool = True) -> core.Result:
    """Return the result of the core again; ``accepted`` if it is known to meet the prescribed values."""
    states = [
        (
            edges,
            core.State(
                r, m, gap, tuple(rigid), [tuple(row) for row in stiffness], core.Status(status), steps, residual
            ),
        )
        for edges, r, m, gap, rigid, stiffness, status, steps, residual in levels
    ]
    return core.restored(problem.model.in_core, problem.by_force, problem.target, states, accuracy, accepted)
