"""Common part of all single-row roller bearings: their fields, conditions and geometry."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import Annotated, Any, ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bearing.fits import TOLERANCE_CLASSES, Range, check_class, clearance_limits
from nonhertz.bearing.kinematics import Kinematics, make_kinematics
from nonhertz.bearing.parts import (
    BORE,
    DENSITY,
    FITS,
    MOST_ANGLE,
    MOST_CLEARANCE,
    MOST_ROLLERS,
    OUTSIDE,
    PITCH,
    InnerRing,
    OuterRing,
    Rollers,
    Shape,
    function_of_angle,
    refuse_large_clearance,
)
from nonhertz.bearing.ribs import End, RibContact
from nonhertz.bearing.row import Row
from nonhertz.bearing.section import RINGS, raceway_motion
from nonhertz.bearing.series import REMEDY, check_series, series_table
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, numbers, one_of, positive
from nonhertz.inputs.descriptions import Count, Quantity, Word
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.materials import density_of

Array = NDArray[np.float64]


class Inertia(NamedTuple):
    """Mass and moments of inertia of a roller."""

    mass: float  # [t]
    middle: float  # position of the centre of mass along the roller [mm]
    polar: float  # moment of inertia about the roller's axis [t mm^2]
    transverse: float  # about a transverse axis through its centre of mass


@input_class(kw_only=True)
class RollerBearing(Input):
    """A row of rollers between an inner and an outer ring; base of the classes for each kind.

    Shapes are functions of angles [rad] that return lengths [mm].

    Raises
    ------
    InputError
        If the parts do not form a bearing.
    """

    clearance_table: ClassVar[str] = "cylindrical"
    is_tapered: ClassVar[bool] = False
    meaning_of_kind: ClassVar[str] = (
        "'cylindrical' (NU and N), 'needle', 'tapered', 'spherical' (a row of barrels) or 'thrust' (cylindrical "
        "rollers between flat washers)"
    )

    roller: Rollers
    inner: InnerRing
    outer: OuterRing
    rollers: Annotated[
        int, Count("the number of rollers in a row", 1, MOST_ROLLERS, "give the number of rollers of the row")
    ]
    pitch_diameter: Annotated[float | None, PITCH] = None
    bore: Annotated[float | None, Quantity("mm", "nominal bore, for classes and seats", positive, BORE)] = None
    outside_diameter: Annotated[
        float | None,
        Quantity("mm", "nominal outside diameter, for classes and seats", positive, OUTSIDE),
    ] = None
    width: Annotated[
        float | None,
        Quantity("mm", "width B, or T of tapered bearings, for heat and axial loads", positive, "give the width in mm"),
    ] = None
    series: Annotated[
        str | None,
        Word(
            "dimension series, for friction and axial loads: '2' of NU 206, '302' of 30206",
            REMEDY,
            tuple(dict.fromkeys(name for of_kind in series_table().values() for name in of_kind)),
        ),
    ] = None
    tolerance_class: Annotated[
        str,
        Word(
            "tolerance class of bore and outside diameter by ISO 492: 'Normal', '6' ('6X' for tapered bearings) or '5'",
            "give the class of ISO 492",
            TOLERANCE_CLASSES,
        ),
    ] = "Normal"
    inner_shape: Annotated[
        Shape | None,
        Quantity(
            "mm",
            "out-of-roundness of the inner raceway: radial deviation against angle, positive for less room; for the "
            "washer of a thrust bearing, axial deviation",
            function_of_angle,
            "give one, or leave it out",
        ),
    ] = None
    outer_shape: Annotated[
        Shape | None,
        Quantity(
            "mm", "out-of-roundness of the outer raceway, likewise", function_of_angle, "give one, or leave it out"
        ),
    ] = None
    density: Annotated[
        float | None,
        Quantity(
            "t/mm^3",
            "density of the rollers, for centrifugal loads; that of their material if left out: steel, or one of the "
            "library",
            positive,
            DENSITY,
        ),
    ] = None

    @cross_check("roller")
    def _check_roller(self) -> None:
        if self.roller.length is None:
            raise InputError("roller.length", None, "be given", "give the length of the rollers in mm")
        if not self.roller_diameter > 0.0:
            raise InputError("roller.diameter", self.roller.diameter, "be positive", "give the diameter in mm")

    @cross_check("inner")
    def _check_inner(self) -> None:
        self._refuse_raceway("inner.diameter", self.inner.diameter, "positive: it is convex")

    @cross_check("outer")
    def _check_outer(self) -> None:
        self._refuse_raceway("outer.diameter", self.outer.diameter, "negative: it is concave")

    def _refuse_raceway(self, name: str, diameter: Any, sign: str) -> None:
        """Refuse a raceway without a diameter of the right sign."""
        if diameter is None:
            signed = ", negative, since it is concave" if sign.startswith("negative") else ""
            raise InputError(name, None, "be given", f"give the raceway's diameter in mm{signed}")
        if callable(diameter) or not (diameter < 0.0 if sign.startswith("negative") else diameter > 0.0):
            one = "one number, " if callable(diameter) else ""
            raise InputError(name, diameter, f"be {one}{sign}", "give the raceway's diameter in mm")

    @cross_check("bore", "inner")
    def _check_bore(self) -> None:
        raceway = float(self.inner.diameter or math.inf)  # type: ignore[arg-type]
        if self.bore is not None and self.bore >= raceway:
            raise InputError("bore", self.bore, f"be less than the raceway's {mm(raceway):g}", BORE)

    @cross_check("outside_diameter", "outer")
    def _check_outside(self) -> None:
        raceway = -float(self.outer.diameter or 0.0)  # type: ignore[arg-type]
        if self.outside_diameter is not None and self.outside_diameter <= raceway:
            condition = f"exceed the raceway's {mm(raceway):g}"
            raise InputError("outside_diameter", self.outside_diameter, condition, OUTSIDE)

    @cross_check("series")
    def _check_series(self) -> None:
        check_series(self._word, self.series)

    @cross_check("tolerance_class")
    def _check_class(self) -> None:
        check_class(self.tolerance_class, tapered=self.is_tapered)

    @cross_check("clearance", "bore")
    def _check_group(self) -> None:
        _ = self.clearance_range

    @cross_check("inner_shape", "rollers", "roller", "inner", "outer", "pitch_diameter")
    def _check_inner_shape(self) -> None:
        _ = self._deviation("inner_shape")

    @cross_check("outer_shape", "rollers", "roller", "inner", "outer", "pitch_diameter")
    def _check_outer_shape(self) -> None:
        _ = self._deviation("outer_shape")

    @cross_check("roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "clearance", "bore")
    def _check_room(self) -> None:
        self._refuse_no_room()

    @cross_check("roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "clearance", "bore")
    def _check_clearance(self) -> None:
        if self.radial_clearance is not None:
            refuse_large_clearance("clearance", self.clearance_range.likely, self.radial_clearance, self.pitch)

    @cross_check(
        "roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "design", "rib", "axial_clearance"
    )
    def _check_ribs(self) -> None:
        # Ribs of tapered bearings are checked when the bearing is solved.
        if not self.nominal_angle:
            _ = self.rib_contacts

    def _refuse_no_room(self) -> None:
        """Refuse rollers that do not fit side by side or between the raceways."""
        self._refuse_crowd()
        diameter = self.roller_diameter
        room = 0.5 * self.play + diameter
        # The diameters may or may not include the clearance.
        if 0.5 * min(abs(self.play), abs(self.play - (self.radial_clearance or 0.0))) > FITS * diameter:
            condition = (
                f"fill the {mm(room):.6g} between raceways of {self.inner.diameter:g} and "
                f"{mm(abs(self.outer.diameter)):g} to within {100.0 * FITS:g} %"  # type: ignore[arg-type]
            )
            raise InputError("roller.diameter", diameter, condition, "give the diameters of raceways and rollers in mm")
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        # The middle between cones with a common apex lies slightly outside the rollers' axis.
        within = (math.cos(2.0 * mean) + math.cos(2.0 * half)) / (2.0 * math.cos(mean) ** 2)
        middle = 0.5 * (float(self.inner.diameter) + abs(float(self.outer.diameter))) * within  # type: ignore[arg-type]
        if self.pitch_diameter is not None and abs(self.pitch_diameter - middle) > FITS * diameter:
            condition = (
                f"lie within {100.0 * FITS:g} % of the rollers' diameter of the {mm(middle):.6g} between the raceways"
            )
            raise InputError("pitch_diameter", self.pitch_diameter, condition, "leave it out, or check the raceways")

    @property
    def _word(self) -> str:
        """The kind as named in files; empty for other classes."""
        return next((word for word, kind in self.kinds.items() if kind is type(self)), "")

    @property
    def of_series(self) -> dict[str, Any]:
        """The published factors of its series; empty if it is not known."""
        return {} if self.series is None else series_table()[self._word][self.series]

    @property
    def play(self) -> float:
        """Room between raceways and rollers by their diameters [mm]; not the clearance, which is given separately."""
        between = abs(float(self.outer.diameter)) - float(self.inner.diameter)  # type: ignore[arg-type]
        return between * self.squareness - 2.0 * self.roller_diameter

    @property
    def squareness(self) -> float:
        """Two roller diameters over the difference of the raceways' diameters without clearance [-]."""
        # Cones with a common apex: their radial distance is measured along a line square to neither.
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        return math.cos(inner) * math.cos(outer) / (math.cos(mean) * math.cos(half) ** 2)

    def _refuse_crowd(self) -> None:
        diameter, pitch = self.roller_diameter, self.pitch
        # Thin rollers on a huge circle must not overflow an integer.
        most = int(math.pi / math.asin(min(1.0, max(1e-9, diameter / pitch))) + 1e-9)
        if pitch <= diameter or self.rollers > most:
            fit = "none fits" if pitch <= diameter else f"{most} fit side by side"
            condition = f"fit on a pitch circle of {mm(pitch):.6g} with a diameter of {mm(diameter):.6g}: {fit}"
            raise InputError("rollers", self.rollers, condition, "give fewer or thinner ones")

    @property
    def kind(self) -> str:
        """The kind in words: "cylindrical roller bearing" for a CylindricalRollerBearing."""
        return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in type(self).__name__).strip()

    @property
    def roller_diameter(self) -> float:
        """Diameter of a roller in its middle [mm]."""
        diameter = self.roller.diameter
        if diameter is None:
            return 0.0
        value = np.asarray(diameter(np.zeros(1)))[0] if callable(diameter) else diameter
        return float(value)

    @property
    def roller_length(self) -> float:
        """Length of a roller [mm]."""
        assert self.roller.length is not None
        return self.roller.length

    @property
    def pitch(self) -> float:
        """Pitch diameter: of the circle of the rollers' centres [mm]."""
        if self.pitch_diameter is not None:
            return self.pitch_diameter
        return 0.5 * (float(self.inner.diameter) + abs(float(self.outer.diameter)))  # type: ignore[arg-type]

    @property
    def angles(self) -> Array:
        """Angular positions of the rollers, from y towards z [rad], shape (rollers,)."""
        positions: Array = 2.0 * np.pi * np.arange(self.rollers) / self.rollers
        return positions

    @property
    def nominal_angle(self) -> float:
        """Contact angle of the bearing [rad]."""
        return float(getattr(self, "contact_angle", 0.0))

    @property
    def contact_angles(self) -> tuple[float, float]:
        """Contact angles at the inner and the outer ring [rad]."""
        return self.nominal_angle, self.nominal_angle

    @property
    def bears_axially(self) -> tuple[bool, bool]:
        """Whether the inner ring can support an axial load along +x, and along -x."""
        return self.nominal_angle > 0.0, False

    @property
    def aligning_reach(self) -> float:
        """Distance along -x from the rollers' centres to the point of free alignment [mm]; NaN if not self-aligning."""
        return math.nan

    @cached_property
    def rib_contacts(self) -> tuple[RibContact, ...]:
        """The contacts of the rollers' ends with ribs that support loads."""
        return ()

    @property
    def bears_radially(self) -> bool:
        """Whether the inner ring can support a radial load."""
        return self.nominal_angle <= MOST_ANGLE

    @property
    def clearance_range(self) -> Range:
        """The clearance [mm]: between the limits of a group; axial for tapered bearings, zero for thrust bearings.

        Raises
        ------
        InputError
            If there is no such group for this bearing.
        """
        clearance = getattr(self, "clearance", 0.0)
        if not isinstance(clearance, str):
            return Range.exactly(clearance)
        if self.bore is None:
            raise InputError("bore", None, f"be given with the clearance group {clearance}", BORE)
        return clearance_limits(clearance, self.bore, self.clearance_table)

    def at(self, clearance: str = "likely") -> Self:
        """Return the bearing with the least, likely or greatest clearance of its group."""
        value = self.clearance_range.at(clearance)
        return replace(self, clearance=value) if hasattr(self, "clearance") else self  # type: ignore[call-arg]

    @property
    def radial_clearance(self) -> float | None:
        """Radial internal clearance [mm]; None for thrust bearings.

        For a group, the mean of its limits.
        """
        return self.clearance_range.likely if hasattr(self, "clearance") else None

    @property
    def gap(self) -> float:
        """Gap at each of a roller's two contacts when the ring is centred [mm]."""
        return 0.25 * (self.radial_clearance or 0.0) * math.cos(self.nominal_angle)

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows of rollers: one."""
        return (Row(self),)

    @cached_property
    def contacts(self) -> tuple[Contact, Contact]:
        """A roller on the inner and on the outer ring."""
        return Contact(self.roller, self.inner), Contact(self.roller, self.outer)

    @property
    def effective_interval(self) -> tuple[float, float]:
        """Interval along their profiles on which rollers can touch both rings, without corners and chamfers [mm].

        Its length is the effective roller length of ISO 281: that of the shortest contact.
        """
        (low, high), (other_low, other_high) = (contact.land for contact in self.contacts)
        return max(low, other_low), min(high, other_high)

    @property
    def raceway_motions(self) -> tuple[Array, Array]:
        """Approach and tilt at both raceways per motion of ring against roller."""
        inner, outer = self.contact_angles
        return raceway_motion(inner, inner=True), raceway_motion(outer, inner=False)

    @property
    def gaps(self) -> tuple[Array, Array]:
        """Gaps of the contacts of every roller [mm], at both rings."""
        # Raceways deviate along the radius, washers along the axis; contacts close along their normals.
        along = [math.cos(angle) if self.bears_radially else 1.0 for angle in self.contact_angles]
        inner, outer = (self.gap - self._deviation(f"{ring}_shape") * by for ring, by in zip(RINGS, along, strict=True))
        return inner, outer

    def _at_contact(self, ring: Body, angle: float) -> float:
        """Return the diameter of a raceway square to its generator, at the contact with a roller's middle [mm].

        The contact lies off the radial line through the roller's centre, on which the raceway's diameter is given.
        """
        on_line = float(ring.diameter)  # type: ignore[arg-type]
        return on_line / math.cos(angle) + self.roller_diameter * math.tan(angle) ** 2

    def _end(self, radius: float, inclined: float = 0.0) -> End:
        """Return the end of a roller, of radius ``radius`` [mm]."""
        corner = self.roller.corner_radius or 0.0
        if self.roller.chamfer is not None:
            corner = self.roller.chamfer.length * math.tan(self.roller.chamfer.angle)
        return End(0.5 * self.roller_length, radius - corner, inclined, self.pitch)

    @property
    def _end_compliances(self) -> dict[str, float]:
        """Compliance of roller and ring [1/MPa], by ring."""
        roller = self.roller.material.compliance
        return {name: roller + getattr(self, name).material.compliance for name in RINGS}

    def _deviation(self, name: str) -> Array:
        """Return the deviation from a circle at each roller [mm], positive for less room."""
        shape, remedy = getattr(self, name), "let it return lengths in mm, one for each angle"
        if shape is None:
            return np.zeros(self.rollers)
        lengths = numbers(name, shape(self.angles), remedy)
        if lengths.shape != (self.rollers,):
            raise InputError(name, lengths.shape, f"return {self.rollers} lengths for {self.rollers} angles", remedy)
        largest, most = float(np.max(np.abs(lengths))), MOST_CLEARANCE * self.pitch
        if largest > most:
            radius = 0.5 * abs(float(getattr(self, name.removesuffix("_shape")).diameter or 0.0))
            condition = f"deviate from a circle by at most {mm(most):.3g}"
            remedy = "give deviations in mm, positive where there is less room"
            if np.all(np.abs(lengths - radius) < 0.1 * radius):
                condition += ": these are radii of the raceway"
                difference = {"inner_shape": "each less their mean", "outer_shape": "their mean less each"}[name]
                remedy = f"give {difference}, positive where there is less room"
            raise InputError(name, largest, condition, remedy)
        return lengths

    @property
    def roller_density(self) -> float | None:
        """Density of the rollers, as given or of their material [t/mm^3]; None for an unnamed material."""
        return density_of(self.roller.material) if self.density is None else self.density

    @cached_property
    def inertia(self) -> Inertia:
        """Mass and moments of inertia of the rollers; barrels are treated as cylinders."""
        at = np.linspace(-0.5, 0.5, 201) * self.roller_length
        squares = np.zeros((2, at.size))
        for row, across in zip(squares, (self.roller.diameter, self.roller.bore), strict=True):
            row[:] = np.asarray(across(at) if callable(across) else np.full(at.size, across or 0.0)) ** 2
        density = self.roller_density
        if density is None:
            condition = "be given for rollers that are neither of steel nor of a material of the library"
            raise InputError("density", None, condition, DENSITY)
        line = 0.25 * math.pi * density * (squares[0] - squares[1])
        polar = math.pi / 32.0 * density * (squares[0] ** 2 - squares[1] ** 2)
        mass = np.trapezoid(line, at)
        middle = np.trapezoid(line * at, at) / mass
        transverse = np.trapezoid(0.5 * polar + line * (at - middle) ** 2, at)
        return Inertia(float(mass), float(middle), float(np.trapezoid(polar, at)), float(transverse))

    def kinematics(self, *, inner_speed: float = 0.0, outer_speed: float = 0.0) -> Kinematics:
        """Return the speeds of cage and rollers, and the frequencies of over-rolling.

        Parameters
        ----------
        inner_speed, outer_speed : float
            Speeds of the rings, or of the shaft and housing washers [1/min].

        Raises
        ------
        InputError
            If a speed is not finite, or both are equal.

        Notes
        -----
        The contact angle is the mean of those at both rings, the angle of the rollers' axes.
        """
        size = self.roller_diameter / self.pitch
        ratio = size * math.cos(0.5 * sum(self.contact_angles))
        return make_kinematics(self.rollers, size, ratio, inner_speed, outer_speed)

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return the load on every roller due to the speed of a turning ring [rad/s]: along x and r, and the moment.

        The cage moves the roller's axis e around the bearing's while the roller spins about e in the opposite
        direction. The load is -d/dt of its momentum, and of its angular momentum about its centre of mass.
        """
        finite("speed", speed, "give it in rad/s")
        one_of("turning", turning, RINGS, "name the ring that turns")
        if speed == 0.0:
            return np.zeros(3)
        roller, inclined = self.inertia, 0.5 * sum(self.contact_angles)
        motion = self.kinematics(**{f"{turning}_speed": speed})  # proportional to the speed, in whatever unit
        cage, spin = motion.cage_speed, motion.roller_speed
        centrifugal = roller.mass * cage**2 * (0.5 * self.pitch - roller.middle * math.sin(inclined))
        # The component of the angular momentum square to the bearing's axis turns with the cage.
        along = roller.polar * (spin + cage * math.cos(inclined))
        across = roller.transverse * cage * math.cos(inclined)
        gyroscopic = cage * math.sin(inclined) * (along - across)
        return np.array([0.0, centrifugal, gyroscopic + centrifugal * roller.middle * math.cos(inclined)])
