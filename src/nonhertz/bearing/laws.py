"""How one contact of a roller answers approach and tilt: with load, moment, their derivatives and the overlap.

A law whose answer is a formula or a table is written down as numbers, so that whole bearings are balanced in machine
code; strips, which are laid and solved, are asked from outside.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.life.lamina import STIFFENING
from nonhertz.maps.evaluation import Tables, loaded, pressed

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

#: What the first number of a law's table says.
SLICES, POINT, MAP = 0.0, 1.0, 2.0
#: Numbers of an answer: load [N], moment [N mm], their four derivatives by approach and tilt, and by how much the
#: undeformed bodies overlap where they do most, negative where they are apart [mm].
ANSWER = 7
OVERLAP = 6


class TabulatedLaw(Protocol):
    """A law that is written down as numbers."""

    @property
    def table(self) -> Array:
        """Which law it is, and its numbers, as `answered` reads them."""
        ...


class SolvedLaw(Protocol):
    """A law that is asked for many contacts at once, each in a *row* of its own.

    One that iterates may so begin where it ended the last time.
    """

    def expect(self, rows: Indices, approach: Array, tilt: Array) -> None:
        """Take note of contacts that are about to be asked, when all laws know of theirs."""
        ...

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Array:
        """Return the answers of contacts, shape (n, ANSWER).

        Parameters
        ----------
        rows : ndarray of int, shape (n,)
            Which of the bearing's contacts of this kind.
        approach, tilt : ndarray, shape (n,)
            [mm], [rad].
        """
        ...


ContactLaw = TabulatedLaw | SolvedLaw


@dataclass(frozen=True, eq=False)
class Slices:
    """Independent slices whose load is a power of their penetration.

    Parameters
    ----------
    y, relief : ndarray, shape (slices,)
        Where the slices are, and how far the bodies are apart there [mm].
    stiffness : float
        Load of a slice of a penetration of 1 mm [N].
    exponent : float
        The power.

    References
    ----------
    ISO/TS 16281:2008, as quoted by others; see `nonhertz.life.lamina`.
    """

    y: Array
    relief: Array
    stiffness: float
    exponent: float = STIFFENING

    @cached_property
    def table(self) -> Array:
        """Kind, number of slices, stiffness, exponent; places; reliefs."""
        return np.concatenate([[SLICES, self.y.size, self.stiffness, self.exponent], self.y, self.relief])

    def loads(self, approach: Array, tilt: Array) -> Array:
        """Return the loads of the slices [N], shape (n, slices)."""
        depth = np.maximum(approach[:, None] + tilt[:, None] * self.y - self.relief, 0.0)
        found: Array = self.stiffness * depth**self.exponent
        return found


@dataclass(frozen=True, eq=False)
class Point:
    """Hertz's contact in a point: load = factor approach^1.5, whatever the tilt."""

    factor: float

    @cached_property
    def table(self) -> Array:
        """Kind and factor."""
        return np.array([POINT, self.factor])


@compiled
def answered(book: Array, at: int, approach: float, tilt: float, answer: Array) -> None:
    """Fill in what a contact answers whose table begins at a place in a book of tables; shape (ANSWER,)."""
    if book[at] == MAP:
        length = int(book[at + 1])
        tables = Tables(book[at + 2 : at + 2 + length], book[:0])
        state = pressed(tables, approach, tilt)
        answer[0], answer[1], answer[2] = state.load, state.moment, state.load_by_approach
        answer[3] = answer[4] = state.load_by_tilt
        answer[5] = state.moment_by_tilt
        answer[OVERLAP] = approach - loaded(tables, 0.0, tilt).approach
        return
    answer[:] = 0.0
    if book[at] == POINT:
        answer[OVERLAP] = approach
        if approach > 0.0:
            answer[2] = 1.5 * book[at + 1] * np.sqrt(approach)
            answer[0] = answer[2] * approach / 1.5
        return
    count, exponent = int(book[at + 1]), book[at + 3]
    y, relief = at + 4, at + 4 + count
    answer[OVERLAP] = -np.inf
    for k in range(count):
        depth = approach + tilt * book[y + k] - book[relief + k]
        answer[OVERLAP] = max(answer[OVERLAP], depth)
        if depth > 0.0:
            # The power of the derivative first: multiplications are cheap.
            slope = book[at + 2] * depth ** (exponent - 1.0)
            answer[0] += slope * depth
            answer[1] += slope * depth * book[y + k]
            answer[2] += exponent * slope
            answer[3] += exponent * slope * book[y + k]
            answer[5] += exponent * slope * book[y + k] ** 2
    answer[4] = answer[3]
