"""Ribs that hold rollers along their axes, and the contacts of the rollers' ends on them.

The end of a roller is part of a sphere with its centre on the roller's axis, and the flank of a rib part of a cone
about the bearing's axis. They touch where the flank is square to a radius of the sphere, so that the normal goes
through the sphere's centre: at a distance from the roller's axis of the sphere's radius times the sine of the flank's
angle. Along the circle of the bearing the flank has the curvature n_r / r, n_r being the part of the normal along the
radius r, and along its straight generator none, or that of its crown. The contact is that of Hertz over an ellipse.
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

#: Places of ribs: the ring, and the end of the rollers which it holds, -1 at low x.
Place = tuple[str, int]
#: Ribs of cylindrical roller bearings by their designs. NJ and NF bear axial loads on the inner ring along +x.
DESIGNS: dict[str, tuple[Place, ...]] = {
    "NU": (("outer", -1), ("outer", 1)),
    "N": (("inner", -1), ("inner", 1)),
    "NJ": (("inner", -1), ("outer", -1), ("outer", 1)),
    "NF": (("inner", -1), ("inner", 1), ("outer", 1)),
    "NUP": (("inner", -1), ("inner", 1), ("outer", -1), ("outer", 1)),
}
_END_RADIUS = "give the radius of the rollers' ends in mm"
_HEIGHT = "give how far from the roller's axis the rib touches, in mm"


@input_class()
class Rib(Input):
    """Where ribs of a bearing's rings touch the rollers' ends.

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
            "the radius of a crowned flank; a straight one has none",
            positive,
            "give that of the flank in mm, or leave it out",
        ),
    ] = None
    edge: Annotated[
        float | None,
        Quantity(
            "mm",
            "the distance of the flank's free edge from the roller's axis, where contacts lose room; not looked for if "
            "left out",
            not_negative,
            "give how far from the roller's axis the flank ends, in mm",
        ),
    ] = None

    @cross_check("end_radius", "height")
    def _check_height(self) -> None:
        if self.height >= self.end_radius:
            condition = f"be less than the radius of the end, {mm(self.end_radius):g}"
            raise InputError("height", self.height, condition, "give how far from the roller's axis the rib touches")

    @cross_check("height", "edge")
    def _check_edge(self) -> None:
        if self.edge is not None and self.edge >= self.height:
            condition = f"be less than the height of the contact, {mm(self.height):g}"
            raise InputError("edge", self.edge, condition, "give how far from the roller's axis the flank ends")

    @classmethod
    def of_flank(
        cls, *, end_radius: float, angle: float, crown_radius: float | None = None, edge: float | None = None
    ) -> Rib:
        """Return the rib whose flank is inclined by an angle [rad] against the plane square to the roller's axis."""
        positive("end_radius", end_radius, _END_RADIUS)
        not_negative("angle", angle, "give it in rad: half a degree is 0.0087")
        if angle >= 0.5 * math.pi:
            raise InputError("angle", angle, "be less than a right angle", "give it in rad: half a degree is 0.0087")
        return cls(end_radius, end_radius * math.sin(angle), crown_radius, edge)

    @property
    def flank_angle(self) -> float:
        """Angle of the flank against the plane square to the roller's axis, where it is touched [rad]."""
        return math.asin(self.height / self.end_radius)


@dataclass(frozen=True, eq=False)
class RibContact:
    """The contact of the rollers' ends with one rib of a row."""

    ring: str  # "inner" or "outer": whose rib it is
    motion: Array  # approach per motion of ring against roller, shape (2, 3); there is no tilt
    gap: float  # what a centred roller is short of touching it [mm]
    radius_around: float  # combined radii of curvature around the bearing's axis
    radius_along: float  # and along the flank [mm]
    compliance: float  # of both bodies [1/MPa]
    height: float  # distance from the roller's axis [mm]
    radius: float  # and from the bearing's [mm]
    room: float  # how far the contact may reach along the flank, to the edge of the roller's end or of the flank [mm]

    def under(self, load: float) -> PointContact:
        """Return the contact under a load [N]."""
        return point_contact(
            load=load, radius_x=self.radius_around, radius_y=self.radius_along, compliance=self.compliance
        )

    @cached_property
    def law(self) -> Slices:
        """How it answers: by Hertz, with the power 1.5 of the approach, whatever the tilt."""
        unit, middle = self.under(1.0), np.zeros(1)
        return Slices(middle, middle, unit.load / unit.approach**1.5, 1.5)

    def reaches_an_edge(self, load: float) -> bool:
        """Return whether the ellipse under a load [N] reaches beyond the flank or the roller's end."""
        return load > 0.0 and self.under(load).half_length > self.room


@dataclass(frozen=True)
class End:
    """The end of a roller, on which ribs press."""

    half: float  # half of the roller's length [mm]
    radius: float  # from the roller's axis to the edge of its end [mm]
    inclined: float  # of the roller's axis against the bearing's, falling towards high x [rad]
    pitch: float  # diameter of the circle of the rollers' middles [mm]

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
        # Square to the roller's axis, towards the ring; and along the axis, from this end into the roller.
        towards = np.array([-math.sin(self.inclined), -math.cos(self.inclined)]) * (1.0 if ring == "inner" else -1.0)
        along = np.array([math.cos(self.inclined), -math.sin(self.inclined)]) * -side
        normal = along * math.cos(rib.flank_angle) - towards * math.sin(rib.flank_angle)
        # The sphere's centre lies on the roller's axis, and the normal goes through it.
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
