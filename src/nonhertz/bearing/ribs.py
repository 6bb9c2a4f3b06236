"""Ribs that locate rollers along their axes, and the contacts of the rollers' ends with them.

The end of a roller is part of a sphere with its centre on the roller's axis, and the flank of a rib is part of a cone
about the bearing's axis. They touch where the flank is square to a radius of the sphere, so that the normal passes
through the sphere's centre: at a distance from the roller's axis of the sphere's radius times the sine of the flank
angle. The flank has the curvature n_r / r around the bearing, n_r being the component of the normal along the radius r,
and none along its straight generator, or that of its crown. The contact is Hertz's elliptical contact.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bearing.laws import Slices
from nonhertz.bearing.section import point_motion
from nonhertz.errors import InputError
from nonhertz.hertz import PointContact, point_contact
from nonhertz.inputs.checks import not_negative, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import Input, cross_check, input_class

Array = NDArray[np.float64]

#: Positions of ribs: the ring, and the end of the rollers, -1 at low x.
Place = tuple[str, int]
#: Ribs of cylindrical roller bearings by design. NJ and NF support axial loads on the inner ring along +x.
DESIGNS: dict[str, tuple[Place, ...]] = {
    "NU": (("outer", -1), ("outer", 1)),
    "N": (("inner", -1), ("inner", 1)),
    "NJ": (("inner", -1), ("outer", -1), ("outer", 1)),
    "NF": (("inner", -1), ("inner", 1), ("outer", 1)),
    "NUP": (("inner", -1), ("inner", 1), ("outer", -1), ("outer", 1)),
}
_END_RADIUS = "give the radius of the rollers' ends in mm"
_HEIGHT = "give the distance of the contact from the roller's axis in mm"


@input_class()
class Rib(Input):
    """Contacts of ribs of a bearing's rings with the rollers' ends.

    Raises
    ------
    InputError
        If one of them is out of range.

    Examples
    --------
    >>> round(Rib.of_flank(end_radius=200.0, angle=0.01).height, 6)
    1.999967
    """

    end_radius: Annotated[
        float, Quantity("mm", "the radius of the spherical ends of the rollers", positive, _END_RADIUS)
    ]
    height: Annotated[
        float, Quantity("mm", "the distance of the contact from the roller's axis", not_negative, _HEIGHT)
    ]
    crown_radius: Annotated[
        float | None,
        Quantity(
            "mm",
            "the crown radius of the flank; a straight flank has none",
            positive,
            "give the radius of the flank in mm, or leave it out",
        ),
    ] = None
    edge: Annotated[
        float | None,
        Quantity(
            "mm",
            "the distance of the flank's free edge from the roller's axis, beyond which contacts are cut off; not "
            "checked if left out",
            not_negative,
            "give the distance of the flank's edge from the roller's axis in mm",
        ),
    ] = None

    @cross_check("end_radius", "height")
    def _check_height(self) -> None:
        if self.height >= self.end_radius:
            condition = f"be less than the radius of the end, {mm(self.end_radius):g}"
            raise InputError("height", self.height, condition, _HEIGHT)

    @cross_check("height", "edge")
    def _check_edge(self) -> None:
        if self.edge is not None and self.edge >= self.height:
            condition = f"be less than the height of the contact, {mm(self.height):g}"
            raise InputError("edge", self.edge, condition, "give how far from the roller's axis the flank ends")

    @classmethod
    def of_flank(
        cls, *, end_radius: float, angle: float, crown_radius: float | None = None, edge: float | None = None
    ) -> Rib:
        """Return the rib with a flank inclined by an angle [rad] to the plane square to the roller's axis."""
        positive("end_radius", end_radius, _END_RADIUS)
        not_negative("angle", angle, "give it in rad: half a degree is 0.0087")
        if angle >= 0.5 * math.pi:
            raise InputError("angle", angle, "be less than a right angle", "give it in rad: half a degree is 0.0087")
        return cls(end_radius, end_radius * math.sin(angle), crown_radius, edge)

    @property
    def flank_angle(self) -> float:
        """Angle of the flank to the plane square to the roller's axis, at the contact [rad]."""
        return math.asin(self.height / self.end_radius)


@dataclass(frozen=True, eq=False)
class RibContact:
    """The contact of the rollers' ends with one rib of a row."""

    ring: str  # "inner" or "outer": whose rib it is
    motion: Array  # approach per motion of ring against roller, shape (2, 3); there is no tilt
    gap: float  # gap between a centred roller and the rib [mm]
    radius_around: float  # combined radii of curvature around the bearing's axis
    radius_along: float  # and along the flank [mm]
    compliance: float  # of both bodies [1/MPa]
    height: float  # distance from the roller's axis [mm]
    radius: float  # and from the bearing's [mm]
    room: float  # distance along the flank to the edge of the roller's end or of the flank [mm]

    def under(self, load: float) -> PointContact:
        """Return the contact under a load [N]."""
        return point_contact(
            load=load, radius_x=self.radius_around, radius_y=self.radius_along, compliance=self.compliance
        )

    @cached_property
    def law(self) -> Slices:
        """Contact law: by Hertz, with the power 1.5 of the approach, independent of the tilt."""
        unit, middle = self.under(1.0), np.zeros(1)
        return Slices(middle, middle, unit.load / unit.approach**1.5, 1.5)

    def reaches_an_edge(self, load: float) -> bool:
        """Return whether the ellipse under a load [N] extends beyond the flank or the roller's end."""
        return load > 0.0 and self.under(load).half_length > self.room


@dataclass(frozen=True)
class End:
    """The end of a roller, which touches ribs."""

    half: float  # half of the roller's length [mm]
    radius: float  # from the roller's axis to the edge of its end [mm]
    inclined: float  # angle of the roller's axis to the bearing's, falling towards high x [rad]
    pitch: float  # pitch diameter [mm]

    def contact(self, rib: Rib, place: Place, gap: float, compliance: float) -> RibContact:
        """Return the contact with a rib.

        Raises
        ------
        InputError
            If the rib touches beyond the roller's end, or its flank is more concave than the end is convex.
        """
        if rib.height >= self.radius:
            condition = f"be less than the radius of the rollers' ends, {mm(self.radius):.6g}"
            raise InputError("rib.height", rib.height, condition, _HEIGHT)
        ring, side = place
        # Unit vectors: square to the roller's axis, towards the ring; along the axis, from this end into the roller.
        towards = np.array([-math.sin(self.inclined), -math.cos(self.inclined)]) * (1.0 if ring == "inner" else -1.0)
        along = np.array([math.cos(self.inclined), -math.sin(self.inclined)]) * -side
        normal = along * math.cos(rib.flank_angle) - towards * math.sin(rib.flank_angle)
        # The sphere's centre lies on the roller's axis, and the normal passes through it.
        at = along * (rib.end_radius - self.half) - rib.end_radius * normal
        radius = 0.5 * self.pitch + float(at[1])
        around = 1.0 / rib.end_radius + float(normal[1]) / radius
        if not around > 0.0:
            condition = "be small enough for a sphere inside the conical flank"
            raise InputError("rib.end_radius", rib.end_radius, condition, "give a smaller one, or a larger height")
        flank = 0.0 if rib.crown_radius is None else 1.0 / rib.crown_radius
        room = self.radius - rib.height
        if rib.edge is not None:
            room = min(room, rib.height - rib.edge)
        radii = 1.0 / around, 1.0 / (1.0 / rib.end_radius + flank)
        motion = point_motion(normal.tolist(), at.tolist())
        return RibContact(ring, motion, gap, *radii, compliance, rib.height, radius, room)
