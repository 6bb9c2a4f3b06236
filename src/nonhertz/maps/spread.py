"""How a solution spreads its load along the contact: the share of the load borne up to a place, and back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.maps.evaluation import QUANTILES
from nonhertz.model.contact import Contact

Array = NDArray[np.float64]

ANGLES = np.linspace(0.0, np.pi, QUANTILES)
# Of the width of a strip [1], and of an end of the bodies [mm].
_SAME = 1e-9


@dataclass(frozen=True)
class Spread:
    """The share of the load, as an angle: sin^2(angle / 2) of it is borne up to a place.

    A line load that falls to zero linearly makes the angle linear there, so that the place is a smooth function of it.
    On strips of a graded grid linear interpolation between their edges is exact to a few hundredths of a per cent.

    Attributes
    ----------
    y, angle : ndarray, shape (n,)
        Places [mm] and angles, 0 to pi, both ascending.
    load : float
        The whole load [N].
    """

    y: Array
    angle: Array
    load: float

    @classmethod
    def of(cls, contact: Contact, edges: Array, line_load: Array) -> Spread:
        """Return the spread of line loads [N/mm] on strips between ``edges`` [mm]."""
        summed = np.concatenate([[0.0], np.cumsum(line_load * np.diff(edges))])
        loaded = np.flatnonzero(line_load > 0.0)
        places = slice(int(loaded[0]), int(loaded[-1]) + 2)
        y, share = edges[places].copy(), summed[places] / summed[-1]
        angle = 2.0 * np.arcsin(np.sqrt(np.clip(share, 0.0, 1.0)))
        # A contact that runs out ends somewhere in its last strip.
        low, high = contact.interval
        if y.size > 3 and y[0] > low + _SAME:
            y[0] = min(max(y[0], y[1] - (y[2] - y[1]) / (angle[2] - angle[1]) * angle[1]), y[1] - _SAME * (y[1] - y[0]))
        if y.size > 3 and y[-1] < high - _SAME:
            rest = (np.pi - angle[-2]) / (angle[-2] - angle[-3])
            y[-1] = max(min(y[-1], y[-2] + (y[-2] - y[-3]) * rest), y[-2] + _SAME * (y[-1] - y[-2]))
        rising = np.concatenate([[True], np.diff(angle) > 0.0])
        return cls(y[rising], angle[rising], float(summed[-1]))

    @property
    def places(self) -> Array:
        """Up to where the contact bears sin^2(k pi / 48) of the load [mm], k = 0 ... 24."""
        found: Array = np.interp(ANGLES, self.angle, self.y)
        return found

    def loads_between(self, stations: Array) -> Array:
        """Return the load on each strip between ``stations`` [mm]: shape (stations - 1,), [N]."""
        angle = np.interp(stations, self.y, self.angle)
        shares: Array = self.load * np.diff(np.sin(0.5 * angle) ** 2)
        return shares
