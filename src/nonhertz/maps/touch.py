"""First touch of two bodies: where, and at which approach, they meet at a tilt."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.model.contact import Contact

Array = NDArray[np.float64]

_SAMPLES = 4001
_ROUNDS, _FINER = 4, 41  # each round searches two steps to both sides on 41 points
# Of the whole way that the touch moves: more within a small tilt means a straight length tips over between its ends.
_TIPPING = 0.2
_FINE_TILTS = 2001


@dataclass(frozen=True)
class Relief:
    """The separation of two bodies on a length, sampled once.

    Attributes
    ----------
    contact : Contact
    y, separation : ndarray
        Places [mm] and the undeformed separation there [mm], where it is finite.
    """

    contact: Contact
    y: Array
    separation: Array

    @classmethod
    def between(cls, contact: Contact, low: float, high: float) -> Relief:
        """Return the separation between two places [mm]."""
        crests = [each for each in contact.crests if low <= each <= high]
        y = np.unique(np.concatenate([np.linspace(low, high, _SAMPLES), crests]))
        separation = contact.separation(y)
        known = np.isfinite(separation)
        return cls(contact, y[known], separation[known])

    def touched(self, tilt: Array) -> tuple[Array, Array]:
        """Return the approach of first touch [mm] and where it is [mm] at each tilt [rad]."""
        found = np.array([self._touched(each) for each in tilt.tolist()])
        return found[:, 0], found[:, 1]

    def _touched(self, tilt: float) -> tuple[float, float]:
        gap = self.separation - tilt * self.y
        at = int(gap.argmin())
        best, place = float(gap[at]), float(self.y[at])
        low, high = self.y[max(at - 1, 0)], self.y[min(at + 1, self.y.size - 1)]
        for _ in range(_ROUNDS):
            y = np.linspace(low, high, _FINER)
            gap = self.contact.separation(y) - tilt * y
            at = int(gap.argmin())
            if gap[at] < best:
                best, place = float(gap[at]), float(y[at])
            low, high = y[max(at - 1, 0)], y[min(at + 1, y.size - 1)]
        return best, place

    def tipping(self, low: float, high: float) -> tuple[float, float, float]:
        """Return the tilt at which the touch moves fastest, how far it moves there, and within which tilt.

        Parameters
        ----------
        low, high : float
            Range of tilts [rad].

        Returns
        -------
        tuple of float
            The tilt [rad], the length [mm], zero where the touch moves evenly, and the width [rad].
        """
        tilts = np.linspace(low, high, _FINE_TILTS)
        at = [int((self.separation - tilt * self.y).argmin()) for tilt in tilts.tolist()]
        places = self.y[at]
        moved = np.diff(places)
        whole = float(places[-1] - places[0])
        fastest = int(moved.argmax())
        if not whole > 0.0 or moved[fastest] < _TIPPING * whole:
            return 0.5 * (low + high), 0.0, high - low
        step = tilts[1] - tilts[0]
        # Within a step of the tilts: by bisection.
        left, right = tilts[fastest], tilts[fastest + 1]
        for _ in range(30):
            middle = 0.5 * (left + right)
            place = self.y[int((self.separation - middle * self.y).argmin())]
            if place - places[fastest] > 0.5 * moved[fastest]:
                right = middle
            else:
                left = middle
        return float(0.5 * (left + right)), float(moved[fastest]), float(step)
