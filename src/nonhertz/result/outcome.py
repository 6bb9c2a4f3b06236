"""From the final state of the strips to a solution: derived numbers, and the warnings about them."""

from __future__ import annotations

import contextlib
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError
from nonhertz.findings import said
from nonhertz.result.end_pressure import centre_pressure, corners, edge_pressures
from nonhertz.result.ends import singular_ends
from nonhertz.result.estimate import error_estimate
from nonhertz.result.maximum import largest_pressure
from nonhertz.result.solution import EdgeKind, EdgePressure, Solution, Status
from nonhertz.result.validity import (
    AT_CORNER,
    refuse_wide,
    refuse_wide_series,
    singularities,
    strains,
)
from nonhertz.strip.acceptance import shortfall, steady
from nonhertz.strip.grid import MOST_BENDS, contact_of, nearly_touching
from nonhertz.strip.levels import Levels, Solved, levels_from
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import CONVERGED, ITERATION_LIMIT, STAGNATED, Grids, States

Array = NDArray[np.float64]

_WAY_OUT = "Try another number of strips, or a smaller load first."
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
    levels = levels_from(problem, [level.one(0) for level in solved.states])
    solution = _solution(problem, levels)
    refuse_wide(solution, problem)
    refuse_wide_series(solution)
    if solution.status is not Status.CONVERGED:
        raise ConvergenceError(f"{solution.status.value} {_WAY_OUT}", solution)
    unmet = _shortfall(solution, problem, solved.grids)
    if unmet is not None:
        raise ConvergenceError(f"{unmet} {_WAY_OUT}", replace(solution, status=Status.REFUTED))
    return _with_findings(solution, problem, levels)


def _shortfall(solution: Solution, problem: Problem, grids: Grids) -> str | None:
    """Return what a converged solution fails to meet, from its arrays alone."""
    if not getattr(steady, "py_func", steady)(solution.stiffness, float(np.max(np.abs(solution.edges)))):
        return "The stiffness of the state reached is negative or not finite: the equilibrium is unstable."
    motion = np.array([solution.approach, solution.tilt])
    return shortfall(problem, grids, solution.line_load, solution.element_half_width, solution.gap, motion)


def solution_of(problem: Problem, levels: Levels) -> Solution:
    """Return a solution that is known to meet what was prescribed."""
    return _with_findings(_solution(problem, levels), problem, levels)


def _with_findings(solution: Solution, problem: Problem, levels: Levels) -> Solution:
    return replace(solution, findings=(*strains(solution, problem, levels.finest), *singularities(solution)))


def _solution(problem: Problem, levels: Levels) -> Solution:
    state, contact = levels.finest, problem.contact
    compliance = contact.compliance
    # A loop that failed may leave any values.
    with contextlib.nullcontext() if state.converged else np.errstate(all="ignore"):
        edges = edge_pressures(problem, state)
        line_load, stiffness = state.r * state.m / compliance, state.stiffness / compliance
    at_corners = corners(problem, state) if state.converged else ()
    edges = _with_corners(problem, state, edges, at_corners)
    sharp = (edge.y for edge in edges if edge.kind is EdgeKind.SINGULAR)
    singular = singular_ends(sharp, at_corners, float(np.ptp(state.edges)))
    places = np.array([end.y for end in singular])
    half_width = problem.model.element.hertz_ratio * np.sqrt(state.m)
    highest, at = map(float, largest_pressure(state.y, state.scaled_pressure, half_width, places))
    within = bool(state.converged) and _is_at_kink(problem, state, at, places)
    return Solution(
        contact=contact,
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
        contact_y=contact_of(state),
        edge_pressure=edges,
        singular_ends=singular,
        peaks_at_corner=within,
        iterations=int(state.steps),
        error_estimate=error_estimate(problem, levels, edges, places, highest, at_corner=within),
        findings=(),
    )


def _with_corners(
    problem: Problem,
    state: States,
    ends: tuple[EdgePressure, EdgePressure],
    at_corners: tuple[float, ...],
) -> tuple[EdgePressure, EdgePressure]:
    """Return the pressures at both ends, with run-outs that in fact press against a corner marked as corners."""
    pressure = centre_pressure(problem, state)
    low, high = ends
    bearing = np.flatnonzero(state.m > 0.0)
    for corner in at_corners:
        first, last = bearing[0], bearing[-1]
        if low.kind is EdgeKind.RUN_OUT and corner < state.y[first] + state.width[first]:
            low = _at_corner(low, corner, float(pressure[first]), float(state.width[first]))
        if high.kind is EdgeKind.RUN_OUT and corner > state.y[last] - state.width[last]:
            high = _at_corner(high, corner, float(pressure[last]), float(state.width[last]))
    return low, high


def _at_corner(end: EdgePressure, corner: float, pressure: float, width: float) -> EdgePressure:
    why = said("the profile turns away from the other body")
    return replace(end, y=corner, kind=EdgeKind.CORNER, pressure=pressure, strip_width=width, convention=why)


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
