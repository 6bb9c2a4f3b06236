"""What strips have to satisfy, and the state that the Newton loop leaves them in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.compiled import plain_array
from nonhertz.model.contact import Contact, derived
from nonhertz.strip.element import Element
from nonhertz.strip.influence import kernel_of
from nonhertz.strip.newton import TOLERANCE
from nonhertz.strip.records import ITERATION_LIMIT, Array, BoundaryConditions, Flags, Grids, Indices, Kernel, States
from nonhertz.strip.solving import solve_on_strips, strips_of, unknowns_of
from nonhertz.strip.start import winkler_start

KEPT_GRIDS = 8  # of up to KEPT_STRIPS each: some levels of the strips that a contact is solved on again and again
KEPT_STRIPS = 160  # those of thousands of strips take megabytes


@dataclass(frozen=True, eq=False)
class StripModel:
    """A contact as strips of one element see it, whatever is prescribed and wherever they lie.

    Attributes
    ----------
    contact : Contact
        The bodies.
    element : Element
        The strip element.
    """

    contact: Contact
    element: Element

    @classmethod
    def of(cls, contact: Contact, element: Element) -> StripModel:
        """Return the model of a contact, which is kept with it."""
        # Of a twin: a contact that is kept by what it keeps would stay until Python looks for cycles.
        return derived(contact, (cls, id(element)), lambda: cls(replace(contact), element))

    @cached_property
    def influence(self) -> Influence:
        """How strips act."""
        return influence_of(self.contact, self.element)

    @cached_property
    def kernel(self) -> Kernel:
        """How strips act, for the compiled core."""
        return kernel_of(self.influence, self.element)

    @cached_property
    def _sampled(self) -> dict[tuple[float, float, int], tuple[Array, Array]]:
        return {}

    @cached_property
    def _grids(self) -> dict[bytes, Grids]:
        return {}

    def separation(self, y: Array) -> Array:
        """Return h [mm] at places [mm]."""
        return self.contact.separation_at(y)

    def sampled(self, low: float, high: float, intervals: int) -> tuple[Array, Array]:
        """Return evenly spaced places and the separation there, kept."""
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
            crests = np.array(self.contact.crests)
            crests = crests[(crests > low) & (crests < high)]
            if crests.size:
                y = np.unique(np.concatenate([y, crests]))
                h = self.separation(y)
            self._sampled[key] = y, h
        return self._sampled[key]

    def grids(self, count: Indices, edges: Array) -> Grids:
        """Return grids with everything that is known about them before their loads are, depth excepted.

        Parameters
        ----------
        count : ndarray of int, shape (grids,)
            Numbers of strips.
        edges : ndarray, shape (grids, n + 1)
            Their edges [mm], padded with the last one.
        """
        y = 0.5 * (edges[:, 1:] + edges[:, :-1])
        flat = y.ravel()
        curvature, separation, min_depth = (
            at(flat).reshape(y.shape) for at in (self.contact.curvature_at, self.separation, self.influence.min_depth)
        )
        return Grids(count, edges, y, curvature, separation, min_depth, np.zeros((len(y), 0, 0)))

    def deep(self, grids: Grids) -> Grids:
        """Return grids with what displacement is measured against, a matrix of all by all strips for each."""
        if grids.at_depth.size or not self.influence.references:
            return grids
        return grids._replace(at_depth=self.influence.at_depth(grids.y, grids.edges))

    def kept_grid(self, edges: Array) -> Grids:
        """Return one grid, which is kept unless it is large."""
        key, found = edges.tobytes(), None
        if edges.size <= KEPT_STRIPS:
            found = self._grids.get(key)
        if found is None:
            found = self.deep(self.grids(*row_of(edges)))
            if edges.size <= KEPT_STRIPS:
                if len(self._grids) >= KEPT_GRIDS:
                    self._grids.clear()
                self._grids[key] = found
        return found


@dataclass(frozen=True)
class Problem:
    """What the strips have to satisfy, on any grid.

    Attributes
    ----------
    contact : Contact
        The bodies, as the user gave them.
    model : StripModel
        The same as strips see them.
    prescribed : ndarray of bool, shape (2,)
        Whether the load (else the approach) and the moment (else the tilt) are given.
    target : ndarray, shape (2,)
        K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad], where K is the compliance of the contact.
    accuracy : float or None
        Relative error of approach or load that the automatic grid aims for; None where strips are given.
    accuracy_given : bool
        Whether the user gave that.
    """

    contact: Contact
    model: StripModel
    prescribed: Flags
    target: Array
    accuracy: float | None = None
    accuracy_given: bool = False

    def of(self, target: Array) -> Problem:
        """Return the problem with another target."""
        return replace(self, target=target)


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
    grids: Grids,
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
    grids : Grids
        The strips of every case, or one grid for all, with depth.
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
    found = States.unsolved(grids.counts, grids.edges, len(targets))
    conditions = BoundaryConditions(problem.prescribed, plain_array(targets))
    solve_on_strips(grids, conditions, problem.model.kernel, near or States.none(), found, tolerance, patient)
    return found


def winkler_state(problem: Problem, edges: Array) -> States:
    """Return the response of independent springs between ``edges``, not a solution."""
    # Springs do not move one another: thousands of them stand here without a matrix of all by all.
    grids = problem.model.grids(*row_of(edges))
    found = States.unsolved(grids.counts, grids.edges, 1)
    strips, unknowns = strips_of(grids, 0), unknowns_of(found, 0, edges.size - 1)
    winkler_start(strips, BoundaryConditions(problem.prescribed, problem.target), problem.model.kernel, unknowns)
    found.status[0] = ITERATION_LIMIT
    return found.one(0)
