"""A row of rollers in its place on the bearing's axis."""

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
    """A row of rollers in its place.

    Attributes
    ----------
    bearing : RollerBearing
        The row by itself.
    x : float
        Axial coordinate of the rollers' middles [mm].
    turned : bool
        Whether it is turned round, so that it bears axial loads along -x, and y of its profiles goes along -x.
    clearance : float
        Axial clearance beside its own, of the ring against this row [mm].
    first : int
        How many rollers of the bearing are in the rows before.
    """

    bearing: RollerBearing
    x: float = 0.0
    turned: bool = False
    clearance: float = 0.0
    first: int = 0

    @property
    def rollers(self) -> slice:
        """Its rollers among those of all rows, which follow one another."""
        return slice(self.first, self.first + self.bearing.rollers)

    @property
    def ring_motion(self) -> Array:
        """Motion at each roller per motion of the inner ring, in the row's own x and r, shape (rollers, 3, 5)."""
        # The rollers' middles are on their pitch circle whichever way they look.
        motion = ring_motion(self.bearing.angles, (self.x, 0.5 * self.bearing.pitch))
        return motion * np.array([[-1.0], [1.0], [-1.0]]) if self.turned else motion

    @property
    def aligns_about(self) -> float:
        """Where on the axis the middle of a spherical raceway is, about which the ring is free to turn [mm]; or NaN."""
        reach = self.bearing.aligning_reach
        return self.x + (reach if self.turned else -reach)

    @property
    def bears_axially(self) -> tuple[bool, bool]:
        """Whether the inner ring can bear an axial load along +x, and along -x."""
        up, down = self.bearing.bears_axially
        return (down, up) if self.turned else (up, down)

    @property
    def gaps(self) -> tuple[Array, Array]:
        """What the contacts of every roller are short of touching [mm], at both rings."""
        more = 0.5 * self.clearance * math.sin(self.bearing.nominal_angle)
        inner, outer = self.bearing.gaps
        return inner + more, outer + more

    @property
    def rib_gaps(self) -> tuple[Array, ...]:
        """What the rollers' ends are short of touching each rib [mm]; those of raceways with an angle hold the axis."""
        more = 0.0 if self.bearing.nominal_angle else 0.5 * self.clearance
        ribs = self.bearing.rib_contacts
        return tuple(np.full(self.bearing.rollers, rib.gap + more * abs(rib.motion[0, 0])) for rib in ribs)
