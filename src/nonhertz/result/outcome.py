"""From the final state of the strips to a solution: derived numbers, and the warnings about them."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError
from nonhertz.findings import Finding
from nonhertz.result.end_pressure import Ends, edge_pressures, ends_of, with_strength
from nonhertz.result.ends import singular_ends
from nonhertz.result.estimate import LEVELS, estimates
from nonhertz.result.maximum import largest_of
from nonhertz.result.solution import EdgePressure, ErrorEstimate, SingularEnd, Solution, Status, not_finite
from nonhertz.result.suspicion import suspicions
from nonhertz.result.validity import (
    AT_CORNER,
    missed_contact,
    refuse_wide,
    refuse_wide_series,
    singularities,
    strains,
    too_wide,
)
from nonhertz.strip.acceptance import shortfall, steady
from nonhertz.strip.grid import MOST_BENDS, contact_of, nearly_touching
from nonhertz.strip.levels import Levels, Solved, levels_from
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import CONVERGED, ITERATION_LIMIT, STAGNATED, Grids, States
from nonhertz.strip.solving import PATIENT_STRIPS

Array = NDArray[np.float64]

_WAY_OUT = "Try another number of strips, or a smaller load first."
_FEWER = f"Give fewer strips: on more than {PATIENT_STRIPS}, where a step takes seconds, few other starts are tried."
_STATUS = {CONVERGED: Status.CONVERGED, ITERATION_LIMIT: Status.ITERATION_LIMIT, STAGNATED: Status.STAGNATED}


def outcome(problem: Problem, solved: Solved) -> Solution:
    """Return the solution of the only case in ``solved``, or refuse it.

    Raises
    ------
    InputError
        If a body is thinner than its contact is wide, or a half-width exceeds a body's radius.
    ConvergenceError
        If the Newton loop failed, or if its solution does not meet what was prescribed.
    """
    grids, finest = solved.grids, solved.states[0]
    solution = solution_of(problem, levels_from(problem, [level.one(0) for level in solved.states]), grids.at_rest)
    if not finest.converged[0] or np.any(too_wide(problem, grids, finest)):
        refuse_wide(solution, problem)
    refuse_wide_series(solution)
    if solution.status is not Status.CONVERGED:
        way_out = _FEWER if solution.strips > PATIENT_STRIPS else _WAY_OUT
        raise ConvergenceError(f"{solution.status.value} {way_out}", solution)
    unmet = _shortfall(solution, problem, grids)
    if unmet is not None:
        raise ConvergenceError(f"{unmet} {_WAY_OUT}", replace(solution, status=Status.REFUTED))
    return solution


def _shortfall(solution: Solution, problem: Problem, grids: Grids) -> str | None:
    """Return what a converged solution fails to meet, from its arrays alone."""
    if not getattr(steady, "py_func", steady)(solution.stiffness, float(np.max(np.abs(solution.edges)))):
        return "The stiffness of the state reached is negative or not finite: the equilibrium is unstable."
    motion = np.array([solution.approach, solution.tilt])
    unmet = shortfall(problem, grids, solution.line_load, solution.element_half_width, solution.gap, motion)
    return unmet or next((f"The {name} of the state reached is not finite." for name in not_finite(solution)), None)


def solution_of(problem: Problem, levels: Levels, grids: Grids | None = None) -> Solution:
    """Return the solution that the levels hold, unchecked; ``grids`` are the finest strips, if they are at hand."""
    state, compliance = levels.finest, problem.contact.compliance
    # A loop that failed may leave any values.
    with contextlib.nullcontext() if state.converged else np.errstate(all="ignore"):
        line_load, stiffness = state.r * state.m / compliance, state.stiffness / compliance
    return Solution(
        contact=problem.contact,
        element=problem.model.element,
        status=_STATUS[int(state.status)],
        approach=float(state.rigid[0]),
        tilt=float(state.rigid[1]),
        load=float(state.scaled_load) / compliance,
        moment=float(state.scaled_moment) / compliance,
        stiffness=stiffness,
        edges=state.edges.copy(),
        line_load=line_load,
        element_half_width=np.sqrt(state.m),
        gap=state.gap.copy(),
        iterations=int(state.steps),
        judgement=Judgement(problem, levels, grids),
    )


class Judgement:
    """What follows from the strips of a solution, each part worked out when it is first read; see `Solution`.

    Parameters
    ----------
    problem : Problem
        What was solved.
    levels : Levels
        The states of the strips.
    grids : Grids, optional
        The finest strips, if they are at hand.
    """

    def __init__(self, problem: Problem, levels: Levels, grids: Grids | None = None) -> None:
        self.problem, self.levels, self._grids = problem, levels, grids

    @classmethod
    def of(cls, **known: Any) -> Judgement:
        """Return a judgement all of which is known: each attribute, and ``findings``."""
        made = object.__new__(cls)
        vars(made).update(known)
        return made

    def __getstate__(self) -> dict[str, object]:
        return (
            {"problem": self.problem, "levels": self.levels, "_grids": None} if "levels" in vars(self) else vars(self)
        )

    @cached_property
    def contact_y(self) -> tuple[tuple[float, float], ...]:
        """The intervals in contact."""
        return contact_of(self.levels.finest)

    @cached_property
    def _rows(self) -> list[States]:
        return [level.row() for level in self.levels.states[:LEVELS]]

    @cached_property
    def _ends(self) -> Ends:
        with contextlib.nullcontext() if self.levels.finest.converged else np.errstate(all="ignore"):
            return ends_of(self.problem, self._rows[0])

    @cached_property
    def ends(self) -> tuple[EdgePressure, EdgePressure]:
        """How the contact ends: the pressure at both ends, without strengths."""
        with contextlib.nullcontext() if self.levels.finest.converged else np.errstate(all="ignore"):
            return edge_pressures(self.problem, self.levels.finest, self._ends)

    @cached_property
    def edge_pressure(self) -> tuple[EdgePressure, EdgePressure]:
        """The pressure at both ends."""
        state, (low, high) = self.levels.finest, self.ends
        with contextlib.nullcontext() if state.converged else np.errstate(all="ignore"):
            return with_strength(self.problem, state, low, -1), with_strength(self.problem, state, high, 1)

    @cached_property
    def singular_ends(self) -> tuple[SingularEnd, ...]:
        """The ends without a limit of the pressure."""
        places = self._ends.singular[0]
        sharp, corners = places[:2], places[2:]
        return singular_ends(
            sharp[np.isfinite(sharp)].tolist(), corners[np.isfinite(corners)].tolist(),
            float(np.ptp(self.levels.finest.edges)),
        )  # fmt: skip

    @cached_property
    def _largest(self) -> tuple[Array, Array]:
        """The largest pressure, scaled, and where it is."""
        return largest_of(self._rows[0], self.problem.model.element.hertz_ratio, self._ends.singular)

    @cached_property
    def peaks_at_corner(self) -> bool:
        """Whether the largest pressure is at a corner."""
        state, (_, (at,)) = self.levels.finest, self._largest
        return bool(state.converged) and _is_at_kink(self.problem, state, at, self._ends.singular)

    @cached_property
    def _errors(self) -> Array:
        at_corner = np.array([self.peaks_at_corner])
        return estimates(self.problem, self._rows, self.levels.accuracy, self._ends, at_corner)

    @cached_property
    def error_estimate(self) -> ErrorEstimate:
        """The estimated errors."""
        return ErrorEstimate(*self._errors[0].tolist())

    def found(self, solution: Solution) -> tuple[Finding, ...]:
        """Return what strains the model: nothing, without a closer look, in most cases."""
        if "findings" in vars(self) or solution.status is not Status.CONVERGED:
            return tuple(vars(self).get("findings", ()))
        rows = self._rows
        grids = self._grids or self.problem.model.grids(rows[0].counts, rows[0].edges)
        (certain,), (missed,), (strained,) = suspicions(
            self.problem, grids, rows, self._ends, self._errors, self._largest[1]
        )
        found: Iterable[Finding] = ()
        if certain or strained:
            found = strains(solution, self.problem, self.levels.finest)
        elif missed:
            found = missed_contact(self.problem, self.levels.finest)
        return (*found, *(singularities(solution) if np.isfinite(self._ends.singular).any() else ()))


def _is_at_kink(problem: Problem, state: States, y: float, ends: Array) -> bool:
    """Return whether the largest pressure, at y [mm], is at a corner of the profile: it has no limit there either."""
    low, high = float(state.edges[0]), float(state.edges[-1])
    bends = (bend for bend in problem.contact.bends if low < bend < high)
    inside = tuple(bend for bend in bends if nearly_touching(state.edges, state.m, bend))
    if not inside or len(inside) > MOST_BENDS:  # of so many none stands out
        return False
    width = float(state.width[np.abs(state.y - y).argmin()])
    return any(
        abs(place - y) <= AT_CORNER * width and place not in ends
        for place in problem.model.kinks(inside, high - low)[0].tolist()
    )
