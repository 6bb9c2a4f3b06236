"""The rows of a plan: their values, and the order in which they are solved."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.files.planfile import Plan
from nonhertz.files.sampling import Sampling
from nonhertz.files.spreads import Distribution

Array = NDArray[np.float64]
Numbers = NDArray[np.intp]

MOST_ROWS = 10_000_000


@dataclass(frozen=True)
class Points:
    """The points of a plan: a grid of listed values, times samples of distributions.

    Rows are numbered with the last axis changing fastest, samples being the last axis. They are solved in an order in
    which loads change fastest: rows of the same bodies follow one another, each similar to the one before.
    """

    paths: tuple[str, ...]  # varied paths: first those with lists of values, then those with distributions
    lists: tuple[tuple[Any, ...], ...]  # the values of each of the first
    distributions: tuple[Distribution, ...]  # those of the others
    sampling: Sampling  # how samples are drawn

    @classmethod
    def of(cls, plan: Plan) -> Points:
        """Return the points of a plan.

        Raises
        ------
        InputError
            If nothing is varied, or there are too many rows.
        """
        if not plan.spreads:
            remedy = "give values for a path of the case, such as load.load=5kN:40kN:8"
            raise InputError("over", {}, "vary something", remedy)
        listed = {path: spread for path, spread in plan.spreads.items() if not isinstance(spread, Distribution)}
        drawn = {path: spread for path, spread in plan.spreads.items() if isinstance(spread, Distribution)}
        points = cls((*listed, *drawn), tuple(listed.values()), tuple(drawn.values()), plan.samples)
        if len(points) > MOST_ROWS:
            raise InputError("over", f"{len(points)} rows", f"have {MOST_ROWS} rows at most", "give fewer values")
        return points

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values along each axis; samples are the last."""
        samples = (self.sampling.size(len(self.distributions)),) if self.distributions else ()
        return (*(len(values) for values in self.lists), *samples)

    def __len__(self) -> int:
        return math.prod(self.shape)

    @cached_property
    def _samples(self) -> Array:
        return self.sampling.draw(self.distributions)

    @cached_property
    def _order(self) -> tuple[int, ...]:
        """The axes in the order of solving, the one that changes slowest first."""
        axes = range(len(self.shape))
        return tuple(sorted(axes, key=lambda axis: axis < len(self.lists) and self.paths[axis].startswith("load.")))

    def solved_at(self, first: int, last: int) -> Numbers:
        """Return the numbers of the rows that are solved from the position ``first`` up to ``last``."""
        shape = tuple(self.shape[axis] for axis in self._order)
        index = dict(zip(self._order, np.unravel_index(np.arange(first, last), shape), strict=True))
        numbers = np.ravel_multi_index(tuple(index[axis] for axis in range(len(self.shape))), self.shape)
        return np.asarray(numbers)

    def values(self, numbers: Sequence[int] | Numbers) -> list[tuple[Any, ...]]:
        """Return the values of some rows, in the order of ``paths``."""
        index = np.unravel_index(np.asarray(numbers), self.shape)
        columns: list[list[Any]] = [
            [values[place] for place in places.tolist()]
            for values, places in zip(self.lists, index[: len(self.lists)], strict=True)
        ]
        if self.distributions:
            columns += self._samples[index[-1]].T.tolist()
        return list(zip(*columns, strict=True))
