"""What strips have to satisfy, and the state that the Newton loop leaves them in."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from threading import Lock
from typing import Any, TypeVar

import numpy as np

from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.model.contact import Contact, derived, sharper_curvature
from nonhertz.native import core
from nonhertz.strip.element import Element
from nonhertz.strip.grid import turns_at
from nonhertz.strip.influence import grid_of, kernel_of
from nonhertz.strip.model import model_of
from nonhertz.strip.records import ITERATION_LIMIT, Array, Flags, Grids, Indices, States
from nonhertz.strip.solving import TOLERANCE, flags, solve_on_strips

KEPT = 24  # of samples, kinks, and grids of so many strips at most, of which thousands would take megabytes
KEPT_STRIPS = 160

Known = TypeVar("Known")

_lock = Lock()


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

    def __reduce__(self) -> tuple[Any, ...]:
        return StripModel, (self.contact, self.element)

    @cached_property
    def influence(self) -> Influence:
        """How strips act."""
        return influence_of(self.contact, self.element)

    @cached_property
    def in_core(self) -> core.Model:
        """The same for the core."""
        return model_of(self.contact, self.element)

    @cached_property
    def kernel(self) -> core.Kernel:
        """How strips act, for the core."""
        return kernel_of(self.influence, self.element)

    @cached_property
    def _kept(self) -> dict[Hashable, Any]:
        return {}

    def kept(self, what: Hashable, make: Callable[[], Known]) -> Known:
        """Return what follows from the model alone, as long as it is one of the last `KEPT` that were made."""
        found: Known | None = self._kept.get(what)
        if found is None:
            found = make()
            with _lock:
                if len(self._kept) >= KEPT:
                    del self._kept[next(iter(self._kept))]
                self._kept[what] = found
        return found

    def separation(self, y: Array) -> Array:
        """Return h [mm] at places [mm]."""
        return self.contact.separation_at(y)

    def sampled(self, low: float, high: float, intervals: int) -> tuple[Array, Array]:
        """Return evenly spaced places and the separation there, kept."""
        return self.kept(("sampled", low, high, intervals), lambda: self._at(np.linspace(low, high, intervals + 1)))

    def surveyed(self, low: float, high: float, intervals: int) -> tuple[Array, Array]:
        """Return the places of `sampled` and the crests between them, ascending, and the separation there."""
        crests = [crest for crest in self.contact.crests if low < crest < high]
        if not crests:
            return self.sampled(low, high, intervals)
        even = np.linspace(low, high, intervals + 1)
        return self.kept(("surveyed", low, high, intervals), lambda: self._at(np.union1d(even, crests)))

    def kinks(self, bends: tuple[float, ...], length: float) -> tuple[Array, Array]:
        """Return where the slope of the separation jumps along strips of this length, as `turns_at`, kept."""
        return self.kept(("kinks", bends, length), lambda: turns_at(self.separation, bends, length))

    def _at(self, y: Array) -> tuple[Array, Array]:
        return y, self.separation(y)

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
        curvature, separation, min_depth, sharper = (
            values.reshape(y.shape)
            for values in (
                self.contact.curvature_at(flat), self.separation(flat), self.influence.min_depth(flat),
                sharper_curvature(self.contact, flat),
            )
        )  # fmt: skip
        at_rest, by_width = np.zeros((len(y), 0, 0)), np.zeros((len(y), 4, y.shape[1]))
        return Grids(count, edges, y, curvature, separation, min_depth, sharper, at_rest, by_width)

    def deep(self, grids: Grids) -> Grids:
        """Return grids with what displacement is measured against, a matrix of all by all strips for each."""
        if grids.at_depth.size or not self.influence.references:
            return grids
        by_width = np.moveaxis(self.influence.by_width(grids.y, self.element.hertz_ratio), 0, 1)
        return grids._replace(
            at_depth=self.influence.at_depth(grids.y, grids.edges), by_width=np.ascontiguousarray(by_width)
        )

    def kept_grid(self, edges: Array) -> Grids:
        """Return one grid, which is kept unless it is large."""

        def made() -> Grids:
            return self.deep(self.grids(*row_of(edges)))

        return made() if edges.size > KEPT_STRIPS else self.kept(edges.tobytes(), made)


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
    pressure_accuracy : float or None
        Relative error of the largest pressure that it aims for too, if any.
    """

    contact: Contact
    model: StripModel
    prescribed: Flags
    target: Array
    accuracy: float | None = None
    accuracy_given: bool = False
    pressure_accuracy: float | None = None

    @property
    def conditions(self) -> tuple[tuple[bool, bool], tuple[float, float]]:
        """What is prescribed, as the core takes it."""
        (by_load, by_moment), (first, second) = self.prescribed, self.target
        return (bool(by_load), bool(by_moment)), (float(first), float(second))

    def of(self, target: Array) -> Problem:
        """Return the problem with another target."""
        return replace(self, target=target)


def row_of(edges: Array) -> tuple[Indices, Array]:
    """Return one grid as count and edges of a single row."""
    return np.array([edges.size - 1]), np.asarray(edges, dtype=float)[None]


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
    near = near or States.none()
    solve_on_strips(grids, problem.prescribed, targets, problem.model.kernel, near, found, tolerance, patient)
    return found


def winkler_state(problem: Problem, edges: Array) -> States:
    """Return the response of independent springs between ``edges``, not a solution."""
    # Springs do not move one another: thousands of them stand here without a matrix of all by all.
    grids = problem.model.grids(*row_of(edges))
    by_force, target = flags(problem.prescribed), problem.target.tolist()
    state = core.start_from_springs(grid_of(grids), by_force, target, problem.model.kernel)
    return States(
        grids.counts[0], grids.edges[0], state.r, state.m, np.array(state.rigid), state.gap, np.array(state.stiffness),
        np.array(ITERATION_LIMIT), np.array(0), np.array(np.inf),
    )  # fmt: skip
