"""The grid: equal rectangular cells over a rectangular region, which is adapted to the contact found on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy import sparse

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Span = tuple[float, float]
Ends = tuple[tuple[bool, bool], tuple[bool, bool]]

# Cells in each direction of the coarsest grid of a cascade, where springs are a good enough start.
COARSE = 16


@dataclass(frozen=True)
class Grid:
    """Equal cells over a region, identified by their centres.

    It never extends past the ends of the bodies, so that a contact that reaches an end has the end on a cell edge.

    Attributes
    ----------
    x_span, y_span : tuple of float
        Low and high end of the region [mm] across and along the contact.
    cells : tuple of int
        Number of cells (across, along).
    interval : tuple of float
        Extent of both bodies along y [mm]; may be infinite.
    """

    x_span: Span
    y_span: Span
    cells: tuple[int, int]
    interval: Span = (-math.inf, math.inf)

    @property
    def dx(self) -> float:
        """Width of a cell [mm]."""
        return (self.x_span[1] - self.x_span[0]) / self.cells[0]

    @property
    def dy(self) -> float:
        """Length of a cell [mm]."""
        return (self.y_span[1] - self.y_span[0]) / self.cells[1]

    @cached_property
    def x(self) -> Array:
        """Centres across [mm], shape (nx,)."""
        return _centres(self.x_span, self.cells[0])

    @cached_property
    def y(self) -> Array:
        """Centres along [mm], shape (ny,)."""
        return _centres(self.y_span, self.cells[1])

    @property
    def centres(self) -> tuple[Array, Array]:
        """Centres [mm] as arguments of a gap, of shapes (nx, 1) and (1, ny)."""
        return self.x[:, None], self.y[None, :]

    @property
    def y_edges(self) -> Array:
        """Edges along [mm], shape (ny + 1,)."""
        return np.linspace(*self.y_span, self.cells[1] + 1)

    def coarser(self) -> Iterator[Grid]:
        """Yield grids over the same region, each with half as many cells per direction, from fine to coarse."""
        nx, ny = self.cells
        while max(nx, ny) > COARSE:
            nx, ny = (max(-(-n // 2), min(n, COARSE)) for n in (nx, ny))
            yield replace(self, cells=(nx, ny))

    def cut(self, touching: Mask) -> Ends:
        """Return whether the contact reaches the ends across and along although the bodies continue."""
        across, along = np.any(touching, axis=1), np.any(touching, axis=0)
        (low, high), (first, last) = self.y_span, self.interval
        return (bool(across[0]), bool(across[-1])), (bool(along[0]) and low > first, bool(along[-1]) and high < last)

    def filled(self, touching: Mask) -> float:
        """Return the fraction of the region that the contact fills, in the direction in which it is smaller."""
        return float(min((np.ptp(at) + 1) / n for at, n in zip(np.nonzero(touching), touching.shape, strict=True)))

    def around(self, touching: Mask) -> Grid:
        """Return a grid over a region that is a cell wider than the contact on each side."""
        spans = []
        for (low, _), at, side in zip(
            (self.x_span, self.y_span), np.nonzero(touching), (self.dx, self.dy), strict=True
        ):
            spans.append((low + float(at.min() - 1) * side, low + float(at.max() + 2) * side))
        return self.over(spans)

    def widened(self, ends: Ends, share: float) -> Grid:
        """Return a grid over a region extended by a fraction of its length at each end flagged in ``ends``."""
        spans = []
        for (low, high), (at_low, at_high) in zip((self.x_span, self.y_span), ends, strict=True):
            more = share * (high - low)
            spans.append((low - more * at_low, high + more * at_high))
        return self.over(spans)

    def joined(self, *others: Span) -> Grid:
        """Return a grid whose region also includes spans across and along."""
        pairs = zip((self.x_span, self.y_span), others, strict=True)
        return self.over([(min(a[0], b[0]), max(a[1], b[1])) for a, b in pairs])

    def over(self, spans: Sequence[Span]) -> Grid:
        """Return a grid over another region, cut off where a body ends."""
        x_span, (low, high) = spans
        return replace(self, x_span=x_span, y_span=(max(low, self.interval[0]), min(high, self.interval[1])))


def _centres(span: Span, cells: int) -> Array:
    # Computed from the middle outwards, so that a symmetric region has symmetric centres to the last bit.
    offsets = np.arange(cells, dtype=np.float64) - 0.5 * (cells - 1)
    centres: Array = 0.5 * (span[0] + span[1]) + offsets * ((span[1] - span[0]) / cells)
    # They are passed to user functions, which might modify them in place.
    centres.flags.writeable = False
    return centres


def interpolation(places: Array, cells: int, nodes: int) -> sparse.csr_array:
    """Return the interpolation from cell centres, at 0, 1, 2 ..., to places, by polynomials through the nearest.

    Beyond the last centre it extrapolates.
    """
    from scipy import sparse

    first = np.clip(np.floor(places).astype(int) - nodes // 2 + 1, 0, cells - nodes)
    at = first[:, None] + np.arange(nodes)
    rows = np.repeat(np.arange(places.size), nodes)
    return sparse.csr_array((lagrange(places, at).ravel(), (rows, at.ravel())), shape=(places.size, cells))


def lagrange(places: Array, nodes: NDArray[np.float64 | np.int64]) -> Array:
    """Return the values at places of the polynomials that are 1 at one of the nodes, shape (places, nodes)."""
    nodes = np.broadcast_to(nodes, (places.size, nodes.shape[-1]))
    values = np.ones(nodes.shape)
    for k in range(nodes.shape[1]):
        for other in range(nodes.shape[1]):
            if other != k:
                values[:, k] *= (places - nodes[:, other]) / (nodes[:, k] - nodes[:, other])
    return values


def half_widths(pressure: Array, dx: float) -> Array:
    """Return the half-width [mm] of each row of cells; see `PatchSolution.half_width`."""
    width = np.zeros(pressure.shape[1])
    for j in np.flatnonzero((pressure > 0.0).any(axis=0)):
        column = pressure[:, j]
        width[j] = 0.5 * dx * (_reach(column) + _reach(column[::-1]) - column.size)
    return width


def _reach(column: Array) -> float:
    """Return the (fractional) number of cells from the low end of a column to the upper edge of the pressure."""
    last = int(np.flatnonzero(column)[-1])
    inner, middle, outer = column[last - 2 : last + 1] ** 2 if last >= 2 else (0.0, 0.0, 0.0)
    if not inner > middle > outer:
        return last + 1.0
    near, far = outer / (middle - outer), middle / (inner - middle) - 1.0
    return last + 0.5 + float(np.clip(0.5 * (near + far), -0.5, 1.5))


def widest_run(footprint: Mask) -> Array:
    """Return the number of cells in the widest piece of the contact at every station, shape (ny,)."""
    run: Array = np.zeros(footprint.shape[1])
    widest = run.copy()
    for row in footprint:
        run = (run + 1.0) * row
        np.maximum(widest, run, out=widest)
    return widest
