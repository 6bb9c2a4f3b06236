"""What strips have to satisfy, and the state that the Newton loop leaves them in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from nonhertz.bodies.influence import Influence
from nonhertz.compiled import plain_array
from nonhertz.strip.element import Element
from nonhertz.strip.influence import kernel_of
from nonhertz.strip.newton import TOLERANCE
from nonhertz.strip.records import ITERATION_LIMIT, Array, BoundaryConditions, Flags, Grids, Indices, Kernel, States
from nonhertz.strip.solving import solve_on_strips, strips_of, unknowns_of
from nonhertz.strip.start import winkler_start

KEPT_GRIDS = 2  # those of thousands of strips take megabytes


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
    accuracy : float or None
        Relative error of approach or load that the automatic grid aims for; None where strips are given.
    accuracy_given : bool
        Whether the user gave that.
    """

    separation: Callable[[Array], Array]
    curvature: Callable[[Array], Array]
    element: Element
    prescribed: Flags
    target: Array
    influence: Influence
    compliance: float
    crests: Callable[[], tuple[float, ...]] = tuple
    accuracy: float | None = None
    accuracy_given: bool = False
    # Not given to `replace`, so that a problem of other bodies knows nothing of these.
    _sampled: dict[tuple[float, float, int], tuple[Array, Array]] = field(init=False, default_factory=dict, repr=False)
    _laid: dict[bytes, Grids] = field(init=False, default_factory=dict, repr=False)

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

    def of(self, target: Array) -> Problem:
        """Return the problem with another target, and all that is known of the bodies."""
        other = replace(self, target=target)
        for known in ("_sampled", "_laid"):
            object.__setattr__(other, known, getattr(self, known))
        return other

    @cached_property
    def kernel(self) -> Kernel:
        """How strips act, for the compiled core."""
        return kernel_of(self.influence, self.element)

    def grids(self, count: Indices, edges: Array, *, at_rest: bool = False) -> Grids:
        """Return grids with everything that is known about them before their loads are.

        Parameters
        ----------
        count : ndarray of int, shape (grids,)
            Numbers of strips.
        edges : ndarray, shape (grids, n + 1)
            Their edges [mm], padded with the last one.
        at_rest : bool
            Whether to take what displacement is measured against as at rest: a matrix less to fill.
        """
        # The strips of one case are asked for when they are checked, solved and judged.
        key = edges.tobytes() if len(edges) == 1 else b""
        found = self._laid.get(key)
        if found is None:
            y = 0.5 * (edges[:, 1:] + edges[:, :-1])
            flat = y.ravel()
            curvature, separation, min_depth = (
                at(flat).reshape(y.shape) for at in (self.curvature, self.separation, self.influence.min_depth)
            )
            found = Grids(count, edges, y, curvature, separation, min_depth, np.zeros((len(y), 0, 0)))
        if not (at_rest or found.at_depth.size) and self.influence.references:
            found = found._replace(at_depth=self.influence.at_depth(found.y, edges))
        if key:
            if len(self._laid) >= KEPT_GRIDS:
                self._laid.clear()
            self._laid[key] = found
        return found


def row_of(edges: Array) -> tuple[Indices, Array]:
    """Return one grid as count and edges of a single row."""
    return np.array([edges.size - 1]), plain_array(edges)[None]


def padded_rows(grids: Sequence[Array]) -> tuple[Indices, Array]:
    """Return several grids as counts and rows of edges, padded with the last edge of each."""
    count = np.array([edges.size - 1 for edges in grids])
    rows = np.empty((len(grids), int(count.max()) + 1))
    for row, edges in zip(rows, grids, strict=True):
        row[: edges.size] = edges
        row[edges.size :] = edges[-1]
    return count, rows


def solved_on(
    problem: Problem,
    count: Indices,
    edges: Array,
    targets: Array | None = None,
    near: States | None = None,
    *,
    tolerance: float = TOLERANCE,
    patient: bool = True,
) -> States:
    """Return the states of all cases on their strips.

    Parameters
    ----------
    problem : Problem
        What the cases share.
    count : ndarray of int, shape (grids,)
        Numbers of strips, of every case or of one grid for all.
    edges : ndarray, shape (grids, n + 1)
        Their edges [mm], padded with the last one.
    targets : ndarray, shape (cases, 2), optional
        As `Problem.target`; that of the problem if left out.
    near : States, optional
        Solutions of the cases on other strips.
    tolerance : float
        Largest relative residual of a solution.
    patient : bool
        Whether to try hard where the loop fails; see `nonhertz.strip.solving`.
    """
    targets = problem.target[None] if targets is None else targets
    found = States.unsolved(count, edges, len(targets))
    grids = problem.grids(count, edges)
    conditions = BoundaryConditions(problem.prescribed, plain_array(targets))
    solve_on_strips(grids, conditions, problem.kernel, near or States.none(), found, tolerance, patient)
    return found


def winkler_state(problem: Problem, edges: Array) -> States:
    """Return the response of independent springs between ``edges``, not a solution."""
    count, rows = row_of(edges)
    found = States.unsolved(count, rows, 1)
    # Springs do not move one another: thousands of them stand here without a matrix of all by all.
    strips, unknowns = strips_of(problem.grids(count, rows, at_rest=True), 0), unknowns_of(found, 0, edges.size - 1)
    winkler_start(strips, BoundaryConditions(problem.prescribed, problem.target), problem.kernel, unknowns)
    found.status[0] = ITERATION_LIMIT
    return found.one(0)
