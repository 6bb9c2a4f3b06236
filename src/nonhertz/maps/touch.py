"""First touch of two bodies: its position and approach at a tilt."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.model.contact import Contact
from nonhertz.result.penetration import deepest

Array = NDArray[np.float64]

_SAMPLES = 4001
# Over the whole travel of the touch: more within a small tilt means that a straight length tips over between its ends.
_TIPPING = 0.2
_FINE_TILTS = 2001


@dataclass(frozen=True)
class Relief:
    """The separation of two bodies over a length, sampled once.

    Attributes
    ----------
    contact : Contact
    y, separation : ndarray
        Positions [mm] and the undeformed separation there [mm], where it is finite.
    """

    contact: Contact
    y: Array
    separation: Array

    @classmethod
    def between(cls, contact: Contact, low: float, high: float) -> Relief:
        """Return the separation between two places [mm]."""
        crests = [crest for crest in contact.crests if low <= crest <= high]
        y = np.unique(np.concatenate([np.linspace(low, high, _SAMPLES), crests]))
        separation = contact.separation(y)
        known = np.isfinite(separation)
        return cls(contact, y[known], separation[known])

    def touched(self, tilt: Array) -> Array:
        """Return the approach of first touch [mm] at each tilt [rad]."""
        return -deepest(self.contact.separation, self.y, np.column_stack([np.zeros(tilt.size), tilt]))

    def tipping(self, low: float, high: float) -> tuple[float, float, float]:
        """Return the tilt at which the touch moves fastest, its travel there, and the width in tilt.

        Parameters
        ----------
        low, high : float
            Range of tilts [rad].

        Returns
        -------
        tuple of float
            The tilt [rad]; the travel [mm], zero where the touch moves uniformly; and the width [rad].
        """
        tilts = np.linspace(low, high, _FINE_TILTS)
        places = np.array([self._nearest(tilt) for tilt in tilts.tolist()])
        moved = np.diff(places)
        whole = float(places[-1] - places[0])
        fastest = int(moved.argmax())
        if not whole > 0.0 or moved[fastest] < _TIPPING * whole:
            return 0.5 * (low + high), 0.0, high - low
        step = tilts[1] - tilts[0]
        # Within a step of the tilts: by bisection.
        lower, upper = tilts[fastest], tilts[fastest + 1]
        for _ in range(30):
            middle = 0.5 * (lower + upper)
            if self._nearest(middle) - places[fastest] > 0.5 * moved[fastest]:
                upper = middle
            else:
                lower = middle
        return float(0.5 * (lower + upper)), float(moved[fastest]), float(step)

    def _nearest(self, tilt: float) -> float:
        """Return the sampled position [mm] that touches first at a tilt [rad]."""
        return float(self.y[int((self.separation - tilt * self.y).argmin())])
