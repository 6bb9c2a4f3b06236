"""A rectangle for cells to cover, and how it is changed to suit the contact found in it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.patch.grid import Grid

Span = tuple[float, float]
Ends = tuple[tuple[bool, bool], tuple[bool, bool]]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Region:
    """A rectangle that never extends past the ends of the bodies, so that a contact up to one has it on a cell edge.

    Attributes
    ----------
    x_span, y_span : tuple of float
        Low and high end across and along the contact [mm].
    interval : tuple of float
        Extent of both bodies along y [mm]; may be infinite.
    """

    x_span: Span
    y_span: Span
    interval: Span = (-math.inf, math.inf)

    def _changed(self, spans: Sequence[Span]) -> Region:
        x_span, (low, high) = spans
        return Region(x_span, (max(low, self.interval[0]), min(high, self.interval[1])), self.interval)

    def grid(self, cells: tuple[int, int]) -> Grid:
        """Return so many cells over it."""
        return Grid(self.x_span, self.y_span, cells)

    def cut(self, touching: Mask) -> Ends:
        """Return whether the contact reaches the ends across and along although the bodies continue."""
        across, along = np.any(touching, axis=1), np.any(touching, axis=0)
        (low, high), (first, last) = self.y_span, self.interval
        return (bool(across[0]), bool(across[-1])), (bool(along[0]) and low > first, bool(along[-1]) and high < last)

    def filled(self, touching: Mask) -> float:
        """Return how much of it the contact fills, in the direction in which that is less."""
        shares: list[float] = [
            (int(np.ptp(at)) + 1) / n for at, n in zip(np.nonzero(touching), touching.shape, strict=True)
        ]
        return min(shares)

    def around(self, touching: Mask) -> Region:
        """Return one that is a cell wider than the contact on each side."""
        spans = []
        for (low, high), at, count in zip(
            (self.x_span, self.y_span), np.nonzero(touching), touching.shape, strict=True
        ):
            side = (high - low) / count
            spans.append((low + float(at.min() - 1) * side, low + float(at.max() + 2) * side))
        return self._changed(spans)

    def widened(self, ends: Ends, share: float) -> Region:
        """Return one extended by a share of its length at each end flagged in ``ends``."""
        spans = []
        for (low, high), (at_low, at_high) in zip((self.x_span, self.y_span), ends, strict=True):
            more = share * (high - low)
            spans.append((low - more * at_low, high + more * at_high))
        return self._changed(spans)

    def closer(self, place: tuple[float, float], share: float) -> Region:
        """Return one of a share of its size about a place."""
        halves = [0.5 * share * (high - low) for low, high in (self.x_span, self.y_span)]
        return self._changed([(at - half, at + half) for at, half in zip(place, halves, strict=True)])

    def joined(self, *others: Span) -> Region:
        """Return one that holds spans across and along, too."""
        pairs = zip((self.x_span, self.y_span), others, strict=True)
        return self._changed([(min(a[0], b[0]), max(a[1], b[1])) for a, b in pairs])
