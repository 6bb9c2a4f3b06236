"""Contact laws of rollers: load, moment, their derivatives and the overlap as functions of approach and tilt.

Slices and maps are evaluated for one contact at a time; any other law, such as strips, for the contacts of many rollers
at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.life.lamina import STIFFENING
from nonhertz.maps.value import ContactMap
from nonhertz.native import core

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]

#: Number of results of a law: load [N], moment [N mm], their four derivatives by approach and tilt, and the largest
#: overlap of the undeformed bodies [mm], negative where they are apart.
ANSWER = 7
OVERLAP = 6


@dataclass(frozen=True, eq=False)
class Slices:
    """Independent slices whose load is a power of their penetration.

    A point contact, whose load does not depend on the tilt, is a single slice at y = 0.

    Parameters
    ----------
    y, relief : ndarray, shape (slices,)
        Positions of the slices, and separation of the bodies there [mm].
    stiffness : float
        Load on a slice at a penetration of 1 mm [N].
    exponent : float
        The power.

    References
    ----------
    ISO/TS 16281:2008; see `nonhertz.life.lamina`.
    """

    y: Array
    relief: Array
    stiffness: float
    exponent: float = STIFFENING

    def loads(self, approach: Array, tilt: Array) -> Array:
        """Return the loads of the slices [N], shape (n, slices)."""
        depth = np.maximum(approach[:, None] + tilt[:, None] * self.y - self.relief, 0.0)
        at_slices: Array = self.stiffness * depth**self.exponent
        return at_slices


@dataclass(frozen=True, eq=False)
class MapLaw:
    """A contact law by a map, which is continued linearly beyond its range."""

    map_: ContactMap

    def covers(self, approach: Array, tilt: Array) -> Flags:
        """Return which approaches and tilts lie in the range of the map."""
        states = core.map_states(self.map_.table, False, approach, tilt)
        inside: Flags = states[:, 7] != 0.0
        return inside


#: A `core.GroupLaw` is evaluated for the contacts of many rollers at once.
ContactLaw = Slices | MapLaw | core.GroupLaw


def for_core(law: ContactLaw) -> core.Slices | core.MapLaw | core.GroupLaw:
    """Return a law in the form used by the core."""
    if isinstance(law, Slices):
        return core.Slices(law.y, law.relief, float(law.stiffness), float(law.exponent))
    return core.MapLaw(law.map_.table) if isinstance(law, MapLaw) else law
