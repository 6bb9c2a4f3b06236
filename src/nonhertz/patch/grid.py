"""The grid: equal rectangular cells over a rectangular region, identified by their centres."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Cells in each direction of the coarsest grid of a cascade, where springs are a good enough start.
COARSE = 16


@dataclass(frozen=True)
class Grid:
    """Equal cells over a region.

    Attributes
    ----------
    x_span, y_span : tuple of float
        Low and high end of the region [mm] across and along the contact.
    cells : tuple of int
        Number of cells (across, along).
    """

    x_span: tuple[float, float]
    y_span: tuple[float, float]
    cells: tuple[int, int]

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
    def y_edges(self) -> Array:
        """Edges along [mm], shape (ny + 1,)."""
        return np.linspace(*self.y_span, self.cells[1] + 1)

    def coarser(self) -> Iterator[Grid]:
        """Yield grids over the same region, each with half as many cells per direction, from fine to coarse."""
        nx, ny = self.cells
        while max(nx, ny) > COARSE:
            nx, ny = (max(-(-n // 2), min(n, COARSE)) for n in (nx, ny))
            yield Grid(self.x_span, self.y_span, (nx, ny))


def _centres(span: tuple[float, float], cells: int) -> Array:
    # Computed from the middle outwards, so that a symmetric region has symmetric centres to the last bit.
    offsets = np.arange(cells, dtype=np.float64) - 0.5 * (cells - 1)
    centres: Array = 0.5 * (span[0] + span[1]) + offsets * ((span[1] - span[0]) / cells)
    # They are passed to user functions, which might modify them in place.
    centres.flags.writeable = False
    return centres
