"""How contacts of rollers answer approach and tilt: with load, moment, their derivatives and the overlap.

Slices and maps are asked for one contact at a time; any other law, such as strips, which are laid and solved, for the
contacts of many rollers at once.
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

#: Numbers of an answer: load [N], moment [N mm], their four derivatives by approach and tilt, and by how much the
#: undeformed bodies overlap where they do most, negative where they are apart [mm].
ANSWER = 7
OVERLAP = 6


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
    """How a contact answers by its map, which goes on in straight lines beyond its range."""

    map_: ContactMap

    def covers(self, approach: Array, tilt: Array) -> Flags:
        """Return which approaches and tilts the map holds."""
        states = core.map_states(self.map_.table, False, approach, tilt)
        inside: Flags = states[:, 7] != 0.0
        return inside


#: Those of `core.GroupLaw` are asked for the contacts of many rollers at once.
ContactLaw = Slices | MapLaw | core.GroupLaw


def for_core(law: ContactLaw) -> core.Slices | core.MapLaw | core.GroupLaw:
    """Return a law as the core asks it."""
    if isinstance(law, Slices):
        return core.Slices(law.y, law.relief, float(law.stiffness), float(law.exponent))
    return core.MapLaw(law.map_.table) if isinstance(law, MapLaw) else law
