"""How contacts of rollers answer approach and tilt: with load, moment, their derivatives and the overlap.

A law that is a formula or a map is written into a `Book` of arrays, from which whole bearings are balanced in machine
code; any other, such as strips, which are laid and solved, answers from outside.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.life.lamina import STIFFENING
from nonhertz.maps.in_numba import Tables, loaded, pressed
from nonhertz.maps.value import ContactMap
from nonhertz.native import core

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

#: Numbers of an answer: load [N], moment [N mm], their four derivatives by approach and tilt, and by how much the
#: undeformed bodies overlap where they do most, negative where they are apart [mm].
ANSWER = 7
OVERLAP = 6


class OutsideLaw(Protocol):
    """A law that is asked for the contacts of many rollers at once."""

    def answer(self, rows: Indices, pose: Array) -> Array:
        """Return the answers of contacts, shape (n, contacts, ANSWER).

        Parameters
        ----------
        rows : ndarray of int, shape (n,)
            Which rollers, of all states: a law that iterates may begin where it ended the last time.
        pose : ndarray, shape (n, contacts, 2)
            Approach [mm] and tilt [rad] of their contacts that have this law.
        """
        ...


@dataclass(frozen=True, eq=False)
class Slices:
    """Independent slices whose load is a power of their penetration.

    A contact in a point, whose load does not depend on the tilt, is a single slice at y = 0.

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

    def loads(self, approach: Array, tilt: Array) -> Array:
        """Return the loads of the slices [N], shape (n, slices)."""
        depth = np.maximum(approach[:, None] + tilt[:, None] * self.y - self.relief, 0.0)
        found: Array = self.stiffness * depth**self.exponent
        return found


@dataclass(frozen=True, eq=False)
class MapLaw:
    """How a contact answers by its map, which goes on in straight lines beyond its range."""

    map_: ContactMap

    def covers(self, approach: Array, tilt: Array) -> Flags:
        """Return which approaches and tilts the map holds."""
        found = core.map_states(self.map_.table, False, approach, tilt)
        inside: Flags = found[:, 7] != 0.0
        return inside


ContactLaw = Slices | MapLaw | OutsideLaw


class Book(NamedTuple):
    """Laws as numbers, a row each; shorter rows are padded."""

    slices: Indices  # their number; 0 of a map
    stiffness: Array  # of `Slices`,
    exponent: Array
    y: Array
    relief: Array
    maps: Array  # tables of mean approaches, see `nonhertz.maps.evaluation`

    @classmethod
    def of(cls, laws: Iterable[Slices | MapLaw]) -> Book:
        """Return laws written down."""
        none, every = np.zeros(0), list(laws)
        sliced = [law if isinstance(law, Slices) else Slices(none, none, 0.0) for law in every]
        tables = [law.map_.table if isinstance(law, MapLaw) else none for law in every]
        stiffness, exponent = (np.array([getattr(law, name) for law in sliced]) for name in ("stiffness", "exponent"))
        y, relief = (_padded([getattr(law, name) for law in sliced]) for name in ("y", "relief"))
        return cls(np.array([law.y.size for law in sliced], dtype=int), stiffness, exponent, y, relief, _padded(tables))


def _padded(rows: list[Array]) -> Array:
    found = np.zeros((len(rows), max((row.size for row in rows), default=0)))
    for into, row in zip(found, rows, strict=True):
        into[: row.size] = row
    return found


@compiled
def answered(book: Book, law: int, approach: float, tilt: float, answer: Array) -> None:
    """Fill in what a contact answers by a law of a book, shape (ANSWER,)."""
    if book.slices[law] == 0:
        tables = Tables(book.maps[law], book.stiffness[:0])
        state = pressed(tables, approach, tilt)
        answer[0], answer[1], answer[2] = state.load, state.moment, state.load_by_approach
        answer[3] = answer[4] = state.load_by_tilt
        answer[5] = state.moment_by_tilt
        answer[OVERLAP] = approach - loaded(tables, 0.0, tilt).approach
        return
    answer[:] = 0.0
    answer[OVERLAP] = -np.inf
    y, relief, exponent = book.y[law], book.relief[law], book.exponent[law]
    for k in range(book.slices[law]):
        depth = approach + tilt * y[k] - relief[k]
        answer[OVERLAP] = max(answer[OVERLAP], depth)
        if depth > 0.0:
            # The power of the derivative first: multiplications are cheap.
            slope = book.stiffness[law] * depth ** (exponent - 1.0)
            answer[0] += slope * depth
            answer[1] += slope * depth * y[k]
            answer[2] += exponent * slope
            answer[3] += exponent * slope * y[k]
            answer[5] += exponent * slope * y[k] ** 2
    answer[4] = answer[3]
