"""How one contact of a roller answers approach and tilt: with a load, a moment and their derivatives.

A law is asked for many contacts at once, each in a *row* of its own, so that one which iterates may begin where it
ended the last time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


class Answer(NamedTuple):
    """What contacts answer.

    Attributes
    ----------
    load, moment : ndarray, shape (n,)
        [N], [N mm].
    stiffness : ndarray, shape (n, 2, 2)
        d(load, moment) / d(approach, tilt).
    """

    load: Array
    moment: Array
    stiffness: Array


class ContactLaw(Protocol):
    """How a contact answers."""

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Answer:
        """Return the answer of contacts.

        Parameters
        ----------
        rows : ndarray of int, shape (n,)
            Which of the bearing's contacts of this kind.
        approach, tilt : ndarray, shape (n,)
            [mm], [rad].
        """
        ...


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
    ISO/TS 16281:2008, as quoted by others: 35948 L^(8/9) / n delta^(10/9) for a roller between two raceways; each of
    two equal contacts takes half of the penetration.
    """

    y: Array
    relief: Array
    stiffness: float
    exponent: float = 10.0 / 9.0

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Answer:
        """Return the answer of contacts."""
        del rows
        depth = self._depth(approach, tilt)
        # The power of the derivative first: multiplications are cheap.
        slope = self.stiffness * depth ** (self.exponent - 1.0)
        load = slope * depth
        slope = np.where(depth > 0.0, self.exponent * slope, 0.0)
        moments = np.stack([np.ones_like(self.y), self.y, self.y**2], axis=1)
        loads, slopes = load @ moments[:, :2], slope @ moments
        return Answer(loads[:, 0], loads[:, 1], slopes[:, [0, 1, 1, 2]].reshape(-1, 2, 2))

    def loads(self, approach: Array, tilt: Array) -> Array:
        """Return the loads of the slices [N], shape (n, slices)."""
        found: Array = self.stiffness * self._depth(approach, tilt) ** self.exponent
        return found

    def _depth(self, approach: Array, tilt: Array) -> Array:
        depth: Array = np.maximum(approach[:, None] + tilt[:, None] * self.y - self.relief, 0.0)
        return depth


@dataclass(frozen=True, eq=False)
class Point:
    """Hertz's contact in a point: load = factor approach^1.5."""

    factor: float

    def pressed(self, rows: Indices, approach: Array, tilt: Array) -> Answer:
        """Return the answer of contacts; the tilt does nothing."""
        del rows, tilt
        depth = np.maximum(approach, 0.0)
        load, stiffness = self.factor * depth**1.5, np.zeros((depth.size, 2, 2))
        stiffness[:, 0, 0] = 1.5 * self.factor * np.sqrt(depth)
        return Answer(load, np.zeros_like(load), stiffness)
