"""A problem of strips in plain arrays, and the state that the Newton loop leaves it in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.influence import Influence
from nonhertz.compiled import compiled
from nonhertz.strip.element import Element
from nonhertz.strip.newton import CONVERGED, ITERATION_LIMIT, STAGNATED, TOLERANCE, newton
from nonhertz.strip.start import springs, started

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

LEAST_RISE = 1e-3  # of the load: a smaller increment is not attempted
# Depths in half-widths of independent springs, which may be half of the true ones where bodies are thin. Below the
# first no loop is started, below the second a failed start is not retried, below the third a failure is blamed on the
# thin body.
HOPELESS, BEYOND_HELP, SCARCELY = 0.7, 2.0, 4.0
_NOTHING = np.empty(0)


@dataclass(frozen=True)
class Problem:
    """What the strips have to satisfy, on any grid.

    Attributes
    ----------
    separation, curvature : callable
        y [mm] -> h [mm] and 1/rho [1/mm].
    element : Element
        The strip element.
    prescribed : ndarray of bool, shape (2,)
        Whether the load (else the approach) and the moment (else the tilt) are given.
    target : ndarray, shape (2,)
        K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad].
    influence : Influence
        How strips act.
    compliance : float
        K [1/MPa], by which loads are multiplied.
    crests : callable
        () -> where profiles may stand out between sampled places [mm]. A measured line has thousands of them, and
        many solves do not need them: hence a callable.
    """

    separation: Callable[[Array], Array]
    curvature: Callable[[Array], Array]
    element: Element
    prescribed: Flags
    target: Array
    influence: Influence
    compliance: float
    crests: Callable[[], tuple[float, ...]] = tuple
    _sampled: dict[tuple[float, float, int], tuple[Array, Array]] = field(default_factory=dict, repr=False)

    def sampled(self, low: float, high: float, intervals: int) -> tuple[Array, Array]:
        """Return evenly spaced places and the separation there, cached."""
        key = (low, high, intervals)
        if key not in self._sampled:
            y = np.linspace(low, high, intervals + 1)
            self._sampled[key] = y, self.separation(y)
        return self._sampled[key]

    def surveyed(self, low: float, high: float, intervals: int) -> tuple[Array, Array]:
        """Return the places of `sampled` and the crests between them, ascending, and the separation there."""
        key = (low, high, -intervals)  # distinct from the key of the samples alone
        if key not in self._sampled:
            y, h = self.sampled(low, high, intervals)
            crests = np.array(self.crests())
            crests = crests[(crests > low) & (crests < high)]
            if crests.size:
                y = np.unique(np.concatenate([y, crests]))
                h = self.separation(y)
            self._sampled[key] = y, h
        return self._sampled[key]

    def with_share(self, share: float) -> Problem:
        """Return the problem with its prescribed load and moment multiplied by ``share``."""
        target = np.where(self.prescribed, share * self.target, self.target)
        return replace(self, target=target)


@dataclass(frozen=True)
class State:
    """Strips with their unknowns: the start of a Newton loop, or its result."""

    edges: Array
    r: Array
    m: Array
    rigid: Array
    gap: Array
    stiffness: Array
    status: int
    steps: int
    residual: float

    @cached_property
    def y(self) -> Array:
        """Strip centres [mm]."""
        return 0.5 * (self.edges[1:] + self.edges[:-1])

    @cached_property
    def width(self) -> Array:
        """Strip widths [mm]."""
        return np.diff(self.edges)

    @cached_property
    def contact(self) -> tuple[tuple[float, float], ...]:
        """The intervals in contact [mm], their ends where m, continued linearly, vanishes."""
        return tuple(map(tuple, _intervals(self.edges, self.y, self.m).tolist()))

    @property
    def converged(self) -> bool:
        """Whether every contact condition is met."""
        return self.status == CONVERGED

    @property
    def load(self) -> float:
        """K Q [mm^2]."""
        return float(np.sum(self.r * self.m * self.width))

    @property
    def moment(self) -> float:
        """K T [mm^3]."""
        return float(np.sum(self.r * self.m * self.width * self.y))

    @cached_property
    def pressure(self) -> Array:
        """The ratio q / a on each strip, in units of 1 / K; proportional to the pressure."""
        return self.r * np.sqrt(self.m)


def runs(flags: Flags) -> list[tuple[int, int]]:
    """Return the first and last index of every run of true flags."""
    change = (np.flatnonzero(flags[1:] != flags[:-1]) + 1).tolist()
    if flags[0]:
        change.insert(0, 0)
    if flags[-1]:
        change.append(flags.size)
    return [(first, beyond - 1) for first, beyond in zip(change[::2], change[1::2], strict=True)]


@compiled
def _intervals(edges: Array, y: Array, m: Array) -> Array:
    """Return the two ends of every interval in contact, shape (intervals, 2)."""
    found = np.empty((m.size, 2))
    count, first = 0, -1
    for i in range(m.size):
        if m[i] > 0.0 and first < 0:
            first = i
        if m[i] > 0.0 and (i + 1 == m.size or m[i + 1] == 0.0):
            found[count, 0] = _end(edges, y, m, first, i, -1)
            found[count, 1] = _end(edges, y, m, i, first, 1)
            count, first = count + 1, -1
    return found[:count].copy()


@compiled
def _end(edges: Array, y: Array, m: Array, at: int, other: int, side: int) -> float:
    """Return where the contact around strip ``at`` ends on the given side, at most one strip away."""
    edge = edges[at + 1] if side > 0 else edges[at]
    next_in, next_out = at - side, at + side
    if at == other or m[next_in] <= m[at]:
        return float(edge)
    limit = y[next_out] if 0 <= next_out < m.size else edge
    run = m[at] * abs(y[at] - y[next_in]) / (m[next_in] - m[at])
    return float(side * min(side * (y[at] + side * run), side * limit))


def settle(
    problem: Problem, edges: Array, near: State | None = None, *, patient: bool = True, tolerance: float = TOLERANCE
) -> State:
    """Return the solved state on the strips between ``edges``, starting from a ``near`` one if there is one.

    Where the loop fails from one start, the next is tried: springs; then, if ``patient``, springs with r and m stepped
    together, springs with shortened steps, and finally the load raised in steps from a small one.
    """
    strips = Strips.of(problem, edges)
    state = None
    if near is not None and near.converged:
        state = strips.loop(problem, tolerance, near)
    if state is None or not state.converged:
        state = strips.loop(problem, tolerance)
    return _helped(problem, strips, state, tolerance) if patient and not state.converged else state


def _helped(problem: Problem, strips: Strips, state: State, tolerance: float) -> State:
    """Return the best result of further attempts at a state that did not converge."""
    state = _better(state, strips.loop(problem, tolerance, eager=False))
    if state.converged or strips.too_thin(problem, strips.springs(problem)[1], BEYOND_HELP):
        return state
    state = _better(state, strips.loop(problem, tolerance, relaxation=0.5))
    if not state.converged and problem.prescribed[0]:
        state = _better(state, strips.raised(problem))
    return state


def sprung(problem: Problem, edges: Array) -> State:
    """Return the response of independent springs between ``edges``, not a solution."""
    y = 0.5 * (edges[1:] + edges[:-1])
    r, m, rigid = _springs(problem, edges, y, problem.curvature(y), problem.separation(y))
    return State(edges, r, m, rigid, np.zeros_like(y), np.zeros((2, 2)), ITERATION_LIMIT, 0, np.inf)


def _springs(
    problem: Problem, edges: Array, y: Array, curvature: Array, separation: Array
) -> tuple[Array, Array, Array]:
    factor = problem.element.line_factor
    return springs(y, np.diff(edges), curvature, separation, factor, problem.prescribed, problem.target)


def _better(one: State, other: State) -> State:
    if other.converged != one.converged:
        return other if other.converged else one
    return other if other.residual < one.residual else one


@dataclass(frozen=True)
class Strips:
    """Strips with everything that is known about them before their loads are."""

    edges: Array
    y: Array
    width: Array
    curvature: Array
    separation: Array
    at_depth: Array
    shallowest: Array

    @classmethod
    def of(cls, problem: Problem, edges: Array) -> Strips:
        """Return the strips between ``edges``."""
        return cls.on(problem, [edges])[0]

    @classmethod
    def on(cls, problem: Problem, grids: Sequence[Array]) -> list[Strips]:
        """Return the strips of several grids, with one call to the bodies for all of them."""
        centres = [0.5 * (edges[1:] + edges[:-1]) for edges in grids]
        y = np.concatenate(centres)
        cuts = np.cumsum([places.size for places in centres[:-1]])
        asked = (problem.curvature(y), problem.separation(y), problem.influence.shallowest(y))
        curvature, separation, shallowest = (np.split(values, cuts) for values in asked)
        return [
            cls(
                edges,
                places,
                np.diff(edges),
                curvature[k],
                separation[k],
                problem.influence.at_depth(places, edges),
                shallowest[k],
            )
            for k, (edges, places) in enumerate(zip(grids, centres, strict=True))
        ]

    def springs(self, problem: Problem) -> tuple[Array, Array, Array]:
        """Return r, m and the rigid motion of independent springs."""
        return _springs(problem, self.edges, self.y, self.curvature, self.separation)

    def too_thin(self, problem: Problem, m: Array, least: float) -> bool:
        """Return whether a body is less than ``least`` half-widths deep.

        Points at a depth comparable to the contact width move more than the surface, and the equations then have
        either no solution or meaningless ones.
        """
        if not problem.influence.references:
            return False
        return bool(np.any(self.shallowest < least * problem.element.hertz_ratio * np.sqrt(m)))

    def raised(self, problem: Problem) -> State:
        """Return the state reached by raising the load from a small one, in steps as large as the loop allows.

        A state that converged only at a fraction of the load is not a solution and is not marked as one.
        """
        near, reached, share = None, 0.0, 0.01
        for _ in range(40):
            state = self.loop(problem.with_share(share), TOLERANCE, near)
            if state.converged and share == 1.0:
                return state
            if share - reached < LEAST_RISE:
                break
            if state.converged:
                near, reached, share = state, share, min(1.0, 2.0 * share)
            else:
                share = 0.5 * (reached + share)
        return replace(state, status=STAGNATED, residual=np.inf)

    def loop(
        self,
        problem: Problem,
        tolerance: float,
        near: State | None = None,
        relaxation: float = 1.0,
        eager: bool = True,
    ) -> State:
        """Return the result of a Newton loop started from a ``near`` state, or else from springs."""
        element, influence = problem.element, problem.influence
        start = (near.y, near.r, near.m, near.rigid) if near is not None else (_NOTHING, _NOTHING, _NOTHING, _NOTHING)
        r, m, rigid = started(
            self.y, self.width, self.curvature, self.separation, element.line_factor, problem.prescribed,
            problem.target, *start,
        )  # fmt: skip
        gap, stiffness = np.zeros_like(self.y), np.zeros((2, 2))
        if self.too_thin(problem, m, HOPELESS):
            return State(self.edges, r, m, rigid, gap, stiffness, STAGNATED, 0, np.inf)
        status, steps, residual = newton(
            self.y, self.edges[:-1], self.edges[1:], self.curvature, self.separation, problem.prescribed,
            problem.target, influence.terms, self.at_depth, element.table, r, m, rigid, gap, stiffness, tolerance,
            relaxation, eager,
        )  # fmt: skip
        return State(self.edges, r, m, rigid, gap, stiffness, status, steps, residual)
