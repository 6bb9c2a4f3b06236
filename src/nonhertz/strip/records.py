"""Strips and states of many cases, a case in each row, as plain tuples of arrays.

Loads are multiplied by the compliance K, so that K q has the unit of a length and K Q that of its square.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

CONVERGED, ITERATION_LIMIT, STAGNATED = range(3)


class Grids(NamedTuple):
    """Strips of many cases, a grid in each row, or in one row for all; short rows are padded at the end.

    Attributes
    ----------
    counts : ndarray of int, shape (grids,)
        Numbers of strips.
    edges : ndarray, shape (grids, n + 1)
        Edges [mm]; padded with the last one, so that padding has no width.
    y, curvature, separation : ndarray, shape (grids, n)
        Centres, 1/rho and h.
    min_depth, sharper : ndarray, shape (grids, n)
        The smaller of both bodies' depths [mm]; the larger of their curvatures across, in magnitude [1/mm].
    at_depth : ndarray, shape (grids, n, n)
        Displacement, per unit of K q, of what displacement is measured against; shape (grids, 0, 0) if that is at rest.
    by_width : ndarray, shape (grids, 4, n)
        What the half-width a changes on the strip itself, per unit of K q: C0 + C1 a + (C2 ln a + C3) a^2.
    """

    counts: Indices
    edges: Array
    y: Array
    curvature: Array
    separation: Array
    min_depth: Array
    sharper: Array
    at_depth: Array
    by_width: Array

    @property
    def at_rest(self) -> Grids:
        """The same without the matrices of what displacement is measured against."""
        return self._replace(at_depth=np.zeros((len(self.y), 0, 0)), by_width=np.zeros_like(self.by_width))

    def only(self, cases: Indices) -> Grids:
        """Return the grids of some cases, whose numbers ascend."""
        if self.counts.size in {cases.size, 1}:
            return self
        rows: Any = (values[cases] for values in self)
        return Grids(*rows)


class States(NamedTuple):
    """The states that the loop left many cases in, a case in each row; or one case, without the first axis.

    Attributes
    ----------
    counts, edges : ndarray
        As in `Grids`; one row if all cases share their strips. Padding is out of contact.
    r, m, gap : ndarray, shape (cases, n)
        K q / a^2 and a^2, m = 0 marks a strip out of contact; the gap on the centre line.
    rigid, stiffness : ndarray, shape (cases, 2), (cases, 2, 2)
        Approach and tilt; K d(Q, T) / d(approach, tilt).
    status, steps : ndarray of int, shape (cases,)
        CONVERGED, ITERATION_LIMIT or STAGNATED; Newton steps.
    residual : ndarray, shape (cases,)
        Largest relative residual.
    """

    counts: Indices
    edges: Array
    r: Array
    m: Array
    rigid: Array
    gap: Array
    stiffness: Array
    status: Indices
    steps: Indices
    residual: Array

    @property
    def y(self) -> Array:
        """Strip centres [mm]."""
        return 0.5 * (self.edges[..., 1:] + self.edges[..., :-1])

    @property
    def width(self) -> Array:
        """Strip widths [mm]."""
        width: Array = self.edges[..., 1:] - self.edges[..., :-1]
        return width

    @property
    def converged(self) -> Flags:
        """Whether each case meets every contact condition."""
        converged: Flags = self.status == CONVERGED
        return converged

    @property
    def scaled_load(self) -> Array:
        """K Q [mm^2]."""
        load: Array = (self.r * self.m * self.width).sum(axis=-1)
        return load

    @property
    def scaled_moment(self) -> Array:
        """K T [mm^3]."""
        moment: Array = (self.r * self.m * self.width * self.y).sum(axis=-1)
        return moment

    @property
    def scaled_pressure(self) -> Array:
        """The ratio q / a on each strip, in units of 1 / K; proportional to the pressure."""
        return self.r * np.sqrt(self.m)

    @property
    def shared(self) -> bool:
        """Whether all cases have the same strips."""
        return len(self.edges) == 1

    def strips(self, row: int) -> Array:
        """Return the edges of one grid [mm], without padding."""
        edges: Array = self.edges[row, : self.counts[row] + 1]
        return edges

    def rows(self, cases: Flags) -> list[int]:
        """Return the numbers of the grids of some cases."""
        found: list[int] = [0] * bool(np.any(cases)) if self.shared else np.flatnonzero(cases).tolist()
        return found

    @classmethod
    def unsolved(cls, count: Indices, edges: Array, cases: int) -> States:
        """Return empty states of that many cases on these strips."""
        strips = edges.shape[1] - 1
        r, m, gap = (np.zeros((cases, strips)) for _ in range(3))
        status, steps = np.full(cases, STAGNATED), np.zeros(cases, dtype=np.int64)
        rigid, stiffness = np.zeros((cases, 2)), np.zeros((cases, 2, 2))
        return cls(count, edges, r, m, rigid, gap, stiffness, status, steps, np.full(cases, np.inf))

    @classmethod
    def none(cls) -> States:
        """Return the states of no case."""
        return cls.unsolved(np.zeros(1, dtype=np.int64), np.zeros((1, 1)), 0)

    def only(self, cases: Indices) -> States:
        """Return the states of some cases, whose numbers ascend."""
        if cases.size == self.status.size:
            return self
        counts, edges = (self.counts, self.edges) if self.shared else (self.counts[cases], self.edges[cases])
        return States(
            counts, edges, self.r[cases], self.m[cases], self.rigid[cases], self.gap[cases], self.stiffness[cases],
            self.status[cases], self.steps[cases], self.residual[cases],
        )  # fmt: skip

    def replaced(self, cases: Indices, other: States) -> States:
        """Return the states with those of some cases replaced by the rows of ``other``, on whatever strips."""
        if cases.size == self.status.size:
            return other
        total = self.status.size
        kept = np.setdiff1d(np.arange(total), cases)
        longest = max(self.edges.shape[1], other.edges.shape[1])
        count, edges = np.empty(total, dtype=np.int64), np.empty((total, longest))
        found = States.unsolved(count, edges, total)
        for source, rows, into in ((self, kept, kept), (other, np.arange(cases.size), cases)):
            strips = np.zeros_like(rows) if source.shared else rows
            n = source.edges.shape[1]
            count[into], edges[into, :n] = source.counts[strips], source.edges[strips]
            edges[into, n:] = source.edges[strips, -1:]
            for of_strips in ("r", "m", "gap"):
                getattr(found, of_strips)[into, : n - 1] = getattr(source, of_strips)[rows]
            for of_case in ("rigid", "stiffness", "status", "steps", "residual"):
                getattr(found, of_case)[into] = getattr(source, of_case)[rows]
        return found

    def one(self, case: int) -> States:
        """Return the state of one case, without padding."""
        row = 0 if self.shared else case
        n = int(self.counts[row])
        return States(
            self.counts[row], self.edges[row, : n + 1], self.r[case, :n], self.m[case, :n], self.rigid[case],
            self.gap[case, :n], self.stiffness[case], self.status[case], self.steps[case], self.residual[case],
        )  # fmt: skip

    def row(self) -> States:
        """Return one case as the only row of many."""
        rows: Any = (np.asarray(values)[None] for values in self)
        return States(*rows)
