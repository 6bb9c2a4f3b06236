"""Bearings as values: rollers between an inner and an outer ring, made of the package's own bodies."""

from __future__ import annotations

import math
from dataclasses import field, replace
from functools import cached_property
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bearing.fits import Range
from nonhertz.bearing.parts import ANGLE, CLEARANCE, NO_CLEARANCE, PITCH, RIB
from nonhertz.bearing.ribs import DESIGNS, Rib, RibContact
from nonhertz.bearing.roller_bearing import RollerBearing as RollerBearing  # noqa: PLC0414  (here all kinds are known)
from nonhertz.bearing.section import raceway_motion
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import not_negative, positive
from nonhertz.inputs.descriptions import Quantity, Word
from nonhertz.inputs.fields import cross_check, input_class
from nonhertz.model.contact import Contact
from nonhertz.model.diameter import TabulatedDiameter
from nonhertz.model.profile import crown

Array = NDArray[np.float64]
_GROOVE = "give that of the groove along the rollers in mm"
# Contact of ribs with cylindrical rollers, over their radius, and flank opening angle [rad]: both are estimates.
_RIB_HEIGHT, _RIB_ANGLE = 0.7, math.radians(0.5)


@input_class(kw_only=True)
class CylindricalRollerBearing(RollerBearing):
    """A row of cylindrical rollers; depending on the design, ribs locate the inner ring axially.

    If the rib is left out, it touches at 0.7 of the rollers' radius, with a flank opening angle of half a degree: an
    estimate.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184).pitch
    46.5
    """

    clearance: Annotated[float | str, CLEARANCE, NO_CLEARANCE] = 0.0
    design: Annotated[
        str,
        Word(
            "which ring of a cylindrical bearing has ribs: 'NU', both of the outer one, or 'N', both of the inner one, "
            "which leave the rings free along the axis; 'NJ', both of the outer and one of the inner one, and 'NF', "
            "both of the inner and one of the outer one, which support axial loads on the inner ring along +x; 'NUP', "
            "all four, in both directions",
            "name the design of the ribs",
            tuple(DESIGNS),
        ),
    ] = "NU"
    rib: Annotated[Rib | None, RIB] = None
    axial_clearance: Annotated[
        float,
        Quantity(
            "mm",
            "axial internal clearance of a 'NUP', between its ribs; half of it on either side, also in other designs",
            not_negative,
            "give the axial internal clearance in mm",
        ),
        Assumed("no axial clearance", "the axial displacement", lambda row: any(row.bears_axially)),
    ] = 0.0

    @cross_check("design", "rib")
    def _check_design(self) -> None:
        if self.rib is not None and not any(self.bears_axially):
            remedy = "use NJ, NF or NUP, or leave out the rib"
            raise InputError("design", self.design, "have ribs that support loads, since a rib is given", remedy)

    @property
    def bears_axially(self) -> tuple[bool, bool]:
        """Whether the inner ring can support an axial load along +x, and along -x."""
        ribs = DESIGNS[self.design]
        # A rib of the inner ring pushes rollers against a rib of the outer ring at their other ends.
        low, high = (("inner", side) in ribs and ("outer", -side) in ribs for side in (-1, 1))
        return low, high

    @cached_property
    def rib_contacts(self) -> tuple[RibContact, ...]:
        """The contacts of the rollers' ends with ribs that support loads."""
        if not any(self.bears_axially):
            return ()
        rib = self.rib
        if rib is None:
            height = _RIB_HEIGHT * 0.5 * self.roller_diameter
            rib = Rib(height / math.sin(_RIB_ANGLE), height)
        end, compliances = self._end(0.5 * self.roller_diameter), self._end_compliances
        gap = 0.25 * self.axial_clearance * math.cos(rib.flank_angle)
        return tuple(end.contact(rib, place, gap, compliances[place[0]]) for place in DESIGNS[self.design])


@input_class(kw_only=True)
class NeedleRollerBearing(CylindricalRollerBearing):
    """A row of needle rollers: long, thin cylindrical rollers."""


@input_class(kw_only=True)
class TaperedRollerBearing(RollerBearing):
    """A row of tapered rollers, which supports axial loads on the inner ring along +x.

    Diameters of the raceways are those of the cones on a radial line through the rollers' centres; along the rollers
    they change according to the contact angles. The rollers' large ends are at low x, and thus at negative y of their
    profiles. If the rib is left out, the rollers' ends have a radius of 0.95 times the distance to the common apex of
    the cones, and touch the inner ring's rib at 0.9 of the radius of their large ends: an estimate.
    """

    is_tapered: ClassVar[bool] = True

    contact_angle: Annotated[float, ANGLE]
    clearance: Annotated[float | str, CLEARANCE, NO_CLEARANCE] = 0.0
    rib: Annotated[Rib | None, RIB] = None

    @cross_check("roller", "contact_angle")
    def _check_cone(self) -> None:
        if self.roller.length is None:
            return  # reported as an error of the rollers
        if not self.half_cone_angle > 0.0:
            condition = "be a table of y and diameter that is larger at negative y"
            remedy = (
                "give such as TabulatedDiameter((-5, 5), (11, 10)), or { y = [-5, 5], diameter = [11, 10] } in a file: "
                "the large ends are at low x"
            )
            raise InputError("roller.diameter", self.roller.diameter, condition, remedy)
        if self.contact_angles[0] <= 0.0:
            condition = f"exceed the rollers' cone angle of {2.0 * self.half_cone_angle:.4g} rad"
            raise InputError("contact_angle", self.contact_angle, condition, "give that of the outer raceway")

    @property
    def half_cone_angle(self) -> float:
        """Half of the cone angle of a roller [rad]; negative if the large end is at positive y."""
        diameter = self.roller.diameter
        if not isinstance(diameter, TabulatedDiameter):
            return 0.0
        half = 0.5 * self.roller_length
        low, high = diameter(np.array([-half, half]))
        return math.atan(0.5 * (low - high) / self.roller_length)

    @property
    def contact_angles(self) -> tuple[float, float]:
        """Contact angles at the inner and the outer ring [rad]."""
        return self.contact_angle - 2.0 * self.half_cone_angle, self.contact_angle

    @property
    def clearance_range(self) -> Range:
        """The axial clearance [mm]."""
        if isinstance(self.clearance, str):
            condition, remedy = "be axial for a tapered bearing", "give it in mm, or the preload of a pair"
            raise InputError("clearance", self.clearance, condition, remedy)
        return super().clearance_range

    @property
    def radial_clearance(self) -> float:
        """Radial internal clearance of this row alone [mm]."""
        return 2.0 * math.tan(self.contact_angle) * self.clearance_range.likely

    @cached_property
    def contacts(self) -> tuple[Contact, Contact]:
        """A roller on the inner and on the outer ring, each in the plane of their common generator."""
        half = 0.5 * self.roller_length
        cone = self.half_cone_angle
        y = np.array([-half, half])
        square = 1.0 / math.cos(cone)
        narrows = _along(y, square * self.roller_diameter, -2.0 * square * math.tan(cone))
        roller = replace(self.roller, diameter=narrows)
        rings: list[Any] = []
        for ring, angle in zip((self.inner, self.outer), self.contact_angles, strict=True):
            across = self._at_contact(ring, angle)
            falls = -2.0 * math.tan(angle) * math.copysign(1.0, across)
            rings.append(replace(ring, diameter=_along(y, across, falls)))
        return Contact(roller, rings[0]), Contact(roller, rings[1])

    @cached_property
    def rib_contacts(self) -> tuple[RibContact, ...]:
        """The contact of the rollers' large ends with the rib of the inner ring."""
        inclined, half, rib = 0.5 * sum(self.contact_angles), 0.5 * self.roller_length, self.rib
        large = 0.5 * self.roller_diameter + half * math.tan(self.half_cone_angle)
        if rib is None:
            apex = 0.5 * self.pitch / math.sin(inclined)
            rib = Rib(0.95 * (apex + half), 0.9 * large)
        end = self._end(large, inclined)
        return (end.contact(rib, ("inner", -1), 0.0, self._end_compliances["inner"]),)


def _of_groove(ring: str) -> Quantity:
    return Quantity(
        "mm",
        f"the groove radius of the {ring} ring of a spherical bearing, larger than the profile radius of the rollers",
        positive,
        _GROOVE,
    )


@input_class(kw_only=True)
class SphericalRollerBearing(RollerBearing):
    """A row of barrel rollers in grooves; the outer raceway is part of a sphere. Usually one of two rows, in `Paired`.

    Profiles of the bodies are deviations from arcs. Diameters of the raceways are those of the grooves on a radial line
    through the rollers' centres. Both raceways have the same contact angle.
    """

    clearance_table: ClassVar[str] = "spherical"

    contact_angle: Annotated[float, ANGLE]
    profile_radius: Annotated[
        float,
        Quantity(
            "mm",
            "the profile radius of the barrel rollers of a spherical bearing, along their axis",
            positive,
            "give the profile radius of the barrels in mm",
        ),
    ]
    inner_groove: Annotated[float, _of_groove("inner")]
    outer_groove: Annotated[float, _of_groove("outer")]
    clearance: Annotated[float | str, CLEARANCE, NO_CLEARANCE] = 0.0

    @cross_check("inner_groove", "profile_radius")
    def _check_inner_groove(self) -> None:
        self._refuse_groove("inner_groove", self.inner_groove)

    @cross_check("outer_groove", "profile_radius")
    def _check_outer_groove(self) -> None:
        self._refuse_groove("outer_groove", self.outer_groove)

    def _refuse_groove(self, name: str, radius: float) -> None:
        if radius <= self.profile_radius:
            raise InputError(name, radius, f"exceed the radius of the barrels, {mm(self.profile_radius):g}", _GROOVE)

    @property
    def aligning_reach(self) -> float:
        """Distance along -x from the rollers' centres to the centre of the outer sphere [mm]."""
        return 0.5 * self.pitch * math.tan(self.nominal_angle)

    @property
    def raceway_motions(self) -> tuple[Array, Array]:
        """Approach and tilt at both raceways per motion of ring against roller."""
        barrel = {"roller_radius": 0.5 * self.roller_diameter, "profile_radius": self.profile_radius}
        inner, outer = self.contact_angles
        return raceway_motion(inner, inner=True, **barrel), raceway_motion(outer, inner=False, **barrel)

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return the load on every roller due to the speed of a turning ring [rad/s]: along x and r, and the moment.

        Only the force that presses barrels on the outer ring is included: guide ring or cage take up the others, under
        which barrels would slide along their axes and skew until they jam.
        """
        square = np.array([math.sin(self.contact_angle), math.cos(self.contact_angle)])
        return np.array([*(super().load_by_speed(speed, turning)[:2] @ square * square), 0.0])

    @cached_property
    def contacts(self) -> tuple[Contact, Contact]:
        """A roller on the inner and on the outer ring, in the plane of both axes."""
        roller = replace(self.roller, profile=self.roller.profile + crown(self.profile_radius))
        rings = []
        for ring, groove in ((self.inner, self.inner_groove), (self.outer, self.outer_groove)):
            across = self._at_contact(ring, self.contact_angle)
            rings.append(replace(ring, diameter=across, profile=ring.profile + crown(-groove)))
        return Contact(roller, rings[0]), Contact(roller, rings[1])


@input_class(kw_only=True)
class CylindricalThrustBearing(RollerBearing):
    """Cylindrical rollers between two washers, which support only axial loads along +x and moments.

    ``inner`` is the shaft's washer, which moves, and ``outer`` that of the housing; both are flat, without a diameter.
    The rollers' axes are radial, with y of their profiles towards the bearing's axis.
    """

    pitch_diameter: Annotated[float, replace(PITCH, meaning="the pitch diameter, through the rollers' centres")] = (
        field()
    )

    def _refuse_raceway(self, name: str, diameter: Any, sign: str) -> None:
        if diameter is not None:
            remedy = "make the washer as a Plate, or leave out the key"
            raise InputError(name, diameter, "be left out: washers are flat", remedy)

    def _refuse_no_room(self) -> None:
        self._refuse_crowd()
        if self.roller_length >= self.pitch:
            condition = f"be less than the pitch diameter of {mm(self.pitch):g}"
            raise InputError("roller.length", self.roller_length, condition, "give the pitch diameter in mm")

    @property
    def nominal_angle(self) -> float:
        """Contact angle of the bearing [rad]."""
        return 0.5 * math.pi

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return only the moment: the cage takes up the centrifugal force, which acts along the rollers' axes."""
        return np.array([0.0, 0.0, super().load_by_speed(speed, turning)[2]])


#: By their words in files.
RollerBearing.kinds = {
    "cylindrical": CylindricalRollerBearing,
    "needle": NeedleRollerBearing,
    "tapered": TaperedRollerBearing,
    "spherical": SphericalRollerBearing,
    "thrust": CylindricalThrustBearing,
}


def _along(y: Array, middle: float, slope: float) -> TabulatedDiameter:
    """Return a diameter that changes linearly along a generator."""
    return TabulatedDiameter(tuple(y.tolist()), tuple((middle + slope * y).tolist()))
