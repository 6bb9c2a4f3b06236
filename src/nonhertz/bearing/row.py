"""A row of rollers at its position on the bearing's axis."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.section import ring_motion

if TYPE_CHECKING:
    from nonhertz.bearing.roller_bearing import RollerBearing

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Row:
    """A row of rollers at its position.

    Attributes
    ----------
    bearing : RollerBearing
        The row by itself.
    x : float
        Axial coordinate of the rollers' centres [mm].
    turned : bool
        Whether it is turned round, so that it supports axial loads along -x, and y of its profiles points along -x.
    clearance : float
        Axial clearance in addition to its own, of the ring relative to this row [mm].
    first : int
        Number of rollers in the preceding rows.
    """

    bearing: RollerBearing
    x: float = 0.0
    turned: bool = False
    clearance: float = 0.0
    first: int = 0

    @property
    def rollers(self) -> slice:
        """Its rollers among those of all rows, as a slice."""
        return slice(self.first, self.first + self.bearing.rollers)

    @property
    def ring_motion(self) -> Array:
        """Motion at each roller per motion of the inner ring, in the row's own x and r, shape (rollers, 3, 5)."""
        # The rollers' centres are on the pitch circle, turned round or not.
        motion = ring_motion(self.bearing.angles, (self.x, 0.5 * self.bearing.pitch))
        return motion * np.array([[-1.0], [1.0], [-1.0]]) if self.turned else motion

    @property
    def aligns_about(self) -> float:
        """Position on the axis of the centre of a spherical raceway, about which the ring turns freely [mm]; or NaN."""
        reach = self.bearing.aligning_reach
        return self.x + (reach if self.turned else -reach)

    @property
    def bears_axially(self) -> tuple[bool, bool]:
        """Whether the inner ring can support an axial load along +x, and along -x."""
        up, down = self.bearing.bears_axially
        return (down, up) if self.turned else (up, down)

    @property
    def gaps(self) -> tuple[Array, Array]:
        """Gaps of the contacts of every roller [mm], at both rings."""
        more = 0.5 * self.clearance * math.sin(self.bearing.nominal_angle)
        inner, outer = self.bearing.gaps
        return inner + more, outer + more

    @property
    def rib_gaps(self) -> tuple[Array, ...]:
        """Gaps between the rollers' ends and each rib [mm]; raceways with a contact angle locate the rollers."""
        more = 0.0 if self.bearing.nominal_angle else 0.5 * self.clearance
        ribs = self.bearing.rib_contacts
        return tuple(np.full(self.bearing.rollers, rib.gap + more * abs(rib.motion[0, 0])) for rib in ribs)
