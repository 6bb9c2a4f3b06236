"""Bearings as values: rollers between an inner and an outer ring, made of the package's own bodies."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from typing import Annotated, Any, ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.bearing.fits import CLEARANCE_GROUPS, TOLERANCE_CLASSES, Range, check_class, clearance_limits
from nonhertz.bearing.kinematics import Kinematics, cage_speed, roller_speed, rolling
from nonhertz.bearing.ribs import DESIGNS, End, Rib, RibContact
from nonhertz.bearing.section import RINGS, raceway_motion, ring_motion
from nonhertz.bearing.series import REMEDY, check_series, series_table
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import finite, flag, listed, not_negative, number_that, numbers, one_of, positive
from nonhertz.inputs.fields import Count, Custom, Input, Part, Quantities, Quantity, Several, Word, described, together
from nonhertz.model.body import Body, Plate, Ring, Roller, TabulatedDiameter
from nonhertz.model.contact import Contact
from nonhertz.model.materials import density_of
from nonhertz.model.profile import crown

Array = NDArray[np.float64]
#: How far a raceway lies from a circle: at angles [rad], how much less room it leaves [mm].
Shape = Callable[[Array], ArrayLike]

MOST_ROLLERS = 1000
# Of the roller's diameter: by how much raceways may leave more or less room for it than the clearance says.
FITS = 0.02
# Of the pitch diameter: the largest radial clearance C. Motions of the ring are taken as small, and where it is off its
# centre by C / 2 the gap is off by C^2 / (4 pitch), at 0.01 by 0.5 % of C / 2.
MOST_CLEARANCE = 0.01
ARRANGEMENTS = ("X", "O", "tandem")
_MOST_ANGLE = math.radians(45.0)
_RACEWAY = "make it with Ring, or with Plate for washers"
_GROOVE = "give that of the groove along the rollers in mm"
_DENSITY = "give it in t/mm^3, 7.85e-9 for steel"
# Where ribs touch cylindrical rollers, over their radius, and by how much their flanks are open [rad]: both guessed.
_RIB_HEIGHT, _RIB_ANGLE = 0.7, math.radians(0.5)


class Inertia(NamedTuple):
    """Mass of a roller and how it is spread."""

    mass: float  # [t]
    middle: float  # where along the roller its centre of mass lies [mm]
    polar: float  # moment of inertia about the roller's axis [t mm^2]
    transverse: float  # and square to it about its centre of mass


def _function_of_angle(name: str, value: Any, remedy: str) -> None:
    if not callable(value):
        raise InputError(name, value, "be a function of the angle", remedy)


def likely_raceway(values: Mapping[str, Any]) -> type[Body]:
    """Return the class of a raceway without a kind: a washer has no diameter."""
    return Plate if values.get("diameter") is None else Ring


#: The bodies of a bearing.
Rollers = Annotated[
    Body,
    Part(
        "the rollers, all identical, with diameter and length; y of their profile goes along the bearing's axis, x",
        Body,
        "make them with Roller or Body",
        likely=lambda values: Roller,
    ),
]
InnerRing = Annotated[
    Body,
    Part(
        "the inner ring, its diameter that of the raceway, or the shaft's washer, which is flat and has none",
        Body,
        _RACEWAY,
        likely=likely_raceway,
    ),
]
OuterRing = Annotated[
    Body,
    Part(
        "the outer ring, its diameter that of the raceway and negative, or the housing's washer, which is flat and has "
        "none",
        Body,
        _RACEWAY,
        likely=likely_raceway,
    ),
]
_PITCH = Quantity(
    "mm",
    "the diameter of the circle of the rollers' middles; the mean of both raceways if left out",
    positive,
    "give that of the rollers' middles in mm",
)
_CLEARANCE = Quantity(
    "mm",
    "internal clearance of a row: from one side to the other the inner ring moves by so much, along the axis for "
    "tapered bearings, up to where a second row like this would hold it, and across it for others; negative: preload",
    finite,
    "give the internal clearance in mm, or its group",
    dict.fromkeys(CLEARANCE_GROUPS, "group of ISO 5753-1"),
)
_NO_CLEARANCE = Assumed("no clearance", "loads of rollers, displacements, pressures and L10r")
_BORE = "give the nominal bore in mm"
_OUTSIDE = "give the nominal outside diameter in mm"
_ANGLE = Quantity(
    "rad",
    "the angle between the normal of the outer raceway and the radial plane, of tapered and spherical bearings",
    number_that(lambda value: value <= _MOST_ANGLE, f"not exceed {_MOST_ANGLE:.4g} rad, 45 degrees", positive),
    "give it in rad: 12 degrees are 0.21",
)
_RIB = Part(
    "where the inner ring's rib touches the rollers of a tapered bearing, or all ribs those of a cylindrical one; a "
    "usual place if left out",
    Rib,
    "make one with nonhertz.bearing.Rib, or leave it out",
)


@described(kw_only=True)
class RollerBearing(Input):
    """Rollers in a row between an inner and an outer ring; use one of the classes made from it.

    Shapes are functions of angles [rad] that return lengths [mm].

    Raises
    ------
    InputError
        If the parts do not make a bearing.
    """

    clearance_table: ClassVar[str] = "cylindrical"
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
    pitch_diameter: Annotated[float | None, _PITCH] = None
    bore: Annotated[float | None, Quantity("mm", "nominal bore, for classes and seats", positive, _BORE)] = None
    outside_diameter: Annotated[
        float | None,
        Quantity("mm", "nominal outside diameter, for classes and seats", positive, _OUTSIDE),
    ] = None
    width: Annotated[
        float | None,
        Quantity("mm", "width B, of tapered bearings T: for heat and axial loads", positive, "give the width in mm"),
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
            "tolerance class of bore and outside diameter by ISO 492: 'Normal', '6' (of tapered bearings '6X') or '5'",
            "give the class of ISO 492",
            TOLERANCE_CLASSES,
        ),
    ] = "Normal"
    inner_shape: Annotated[
        Shape | None,
        Quantity(
            "mm",
            "how much less room the inner raceway leaves than a circle, over the angle, along the radius; of the "
            "washers of a thrust bearing, how far they rise along the axis",
            _function_of_angle,
            "give one, or leave it out",
        ),
    ] = None
    outer_shape: Annotated[
        Shape | None,
        Quantity("mm", "the same of the outer raceway", _function_of_angle, "give one, or leave it out"),
    ] = None
    density: Annotated[
        float | None,
        Quantity(
            "t/mm^3",
            "density of the rollers, for what speed does; that of their material if left out: steel, or one of the "
            "library",
            positive,
            _DENSITY,
        ),
    ] = None

    @together("roller")
    def _check_roller(self) -> None:
        if self.roller.length is None:
            raise InputError("roller.length", None, "be given", "give the length of the rollers in mm")
        if not self.roller_diameter > 0.0:
            raise InputError("roller.diameter", self.roller.diameter, "be positive", "give the diameter in mm")

    @together("inner")
    def _check_inner(self) -> None:
        self._refuse_raceway("inner.diameter", self.inner.diameter, "positive: it is convex")

    @together("outer")
    def _check_outer(self) -> None:
        self._refuse_raceway("outer.diameter", self.outer.diameter, "negative: it is concave")

    def _refuse_raceway(self, name: str, diameter: Any, sign: str) -> None:
        """Refuse a raceway that has no diameter of its sign."""
        if diameter is None:
            signed = ", negative, since it is concave" if sign.startswith("negative") else ""
            raise InputError(name, None, "be given", f"give that of the raceway in mm{signed}")
        if callable(diameter) or not (diameter < 0.0 if sign.startswith("negative") else diameter > 0.0):
            one = "one number, " if callable(diameter) else ""
            raise InputError(name, diameter, f"be {one}{sign}", "give that of the raceway in mm")

    @together("bore", "inner")
    def _check_bore(self) -> None:
        raceway = float(self.inner.diameter or math.inf)  # type: ignore[arg-type]
        if self.bore is not None and self.bore >= raceway:
            raise InputError("bore", self.bore, f"be less than the raceway's {mm(raceway):g}", _BORE)

    @together("outside_diameter", "outer")
    def _check_outside(self) -> None:
        raceway = -float(self.outer.diameter or 0.0)  # type: ignore[arg-type]
        if self.outside_diameter is not None and self.outside_diameter <= raceway:
            condition = f"exceed the raceway's {mm(raceway):g}"
            raise InputError("outside_diameter", self.outside_diameter, condition, _OUTSIDE)

    @together("series")
    def _check_series(self) -> None:
        check_series(self._word, self.series)

    @together("tolerance_class")
    def _check_class(self) -> None:
        check_class(self.tolerance_class, tapered=isinstance(self, TaperedRollerBearing))

    @together("clearance", "bore")
    def _check_group(self) -> None:
        _ = self.clearance_range

    @together("inner_shape", "rollers", "roller", "inner", "outer", "pitch_diameter")
    def _check_inner_shape(self) -> None:
        _ = self._deviation("inner_shape")

    @together("outer_shape", "rollers", "roller", "inner", "outer", "pitch_diameter")
    def _check_outer_shape(self) -> None:
        _ = self._deviation("outer_shape")

    @together("roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "clearance", "bore")
    def _check_room(self) -> None:
        self._refuse_no_room()

    @together("roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "clearance", "bore")
    def _check_clearance(self) -> None:
        radial = abs(self.radial_clearance or 0.0)
        if radial > MOST_CLEARANCE * self.pitch:
            clearance = self.clearance_range.likely  # in the way in which it is given
            most = abs(clearance) / radial * MOST_CLEARANCE * self.pitch
            condition = f"lie between {-most:.3g} and {mm(most):.3g}, for displacements that are small in this bearing"
            raise InputError("clearance", clearance, condition, "give it in mm: 20 um are 0.02")

    @together(
        "roller", "inner", "outer", "rollers", "pitch_diameter", "contact_angle", "design", "rib", "axial_clearance"
    )
    def _check_ribs(self) -> None:
        # Those of cones are refused when they are solved.
        if not self.nominal_angle:
            _ = self.rib_contacts

    def _refuse_no_room(self) -> None:
        """Refuse rollers that do not fit side by side or between the raceways."""
        self._refuse_crowd()
        diameter = self.roller_diameter
        room = 0.5 * self.play + diameter
        # The diameters may be those with the clearance, or those without it.
        if 0.5 * min(abs(self.play), abs(self.play - (self.radial_clearance or 0.0))) > FITS * diameter:
            condition = (
                f"fill the {mm(room):.6g} between raceways of {self.inner.diameter:g} and "
                f"{mm(abs(self.outer.diameter)):g} to within {100.0 * FITS:g} %"  # type: ignore[arg-type]
            )
            raise InputError("roller.diameter", diameter, condition, "give the diameters of raceways and rollers in mm")
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        # The middle between cones that meet in one point lies a little outside of the rollers' axis.
        within = (math.cos(2.0 * mean) + math.cos(2.0 * half)) / (2.0 * math.cos(mean) ** 2)
        middle = 0.5 * (float(self.inner.diameter) + abs(float(self.outer.diameter))) * within  # type: ignore[arg-type]
        if self.pitch_diameter is not None and abs(self.pitch_diameter - middle) > FITS * diameter:
            condition = (
                f"lie within {100.0 * FITS:g} % of the rollers' diameter of the {mm(middle):.6g} between the raceways"
            )
            raise InputError("pitch_diameter", self.pitch_diameter, condition, "leave it out, or check the raceways")

    @property
    def _word(self) -> str:
        """The kind as files name it; empty for others than they know."""
        return next((word for word, kind in self.kinds.items() if kind is type(self)), "")

    @property
    def of_series(self) -> dict[str, Any] | None:
        """The published factors of its series; None if it is not known."""
        return None if self.series is None else series_table()[self._word][self.series]

    @property
    def play(self) -> float:
        """What the diameters of raceways and rollers leave between them [mm]: no clearance, which is given as such."""
        # Cones that meet in one point: their radial distance is measured along a line that is square to neither.
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        square = math.cos(inner) * math.cos(outer) / (math.cos(mean) * math.cos(half) ** 2)
        return (abs(float(self.outer.diameter)) - float(self.inner.diameter)) * square - 2.0 * self.roller_diameter  # type: ignore[arg-type]

    def _refuse_crowd(self) -> None:
        diameter, pitch = self.roller_diameter, self.pitch
        # Thin rollers on a huge circle must not overflow.
        most = int(math.pi / math.asin(min(1.0, max(1e-9, diameter / pitch))) + 1e-9)
        if pitch <= diameter or self.rollers > most:
            fit = "none fits" if pitch <= diameter else f"{most} fit side by side"
            condition = f"fit on a pitch circle of {mm(pitch):.6g} with a diameter of {mm(diameter):.6g}: {fit}"
            raise InputError("rollers", self.rollers, condition, "give fewer or thinner ones")

    @property
    def kind(self) -> str:
        """What it is in words: a CylindricalRollerBearing is a cylindrical roller bearing."""
        return "".join(f" {each.lower()}" if each.isupper() else each for each in type(self).__name__).strip()

    @property
    def roller_diameter(self) -> float:
        """Diameter of a roller in its middle [mm]."""
        diameter = self.roller.diameter
        if diameter is None:
            return 0.0
        found = np.asarray(diameter(np.zeros(1)))[0] if callable(diameter) else diameter
        return float(found)

    @property
    def roller_length(self) -> float:
        """Length of a roller [mm]."""
        assert self.roller.length is not None
        return self.roller.length

    @property
    def pitch(self) -> float:
        """Diameter of the circle of the rollers' middles [mm]."""
        if self.pitch_diameter is not None:
            return self.pitch_diameter
        return 0.5 * (float(self.inner.diameter) + abs(float(self.outer.diameter)))  # type: ignore[arg-type]

    @property
    def angles(self) -> Array:
        """Where the rollers are, from y towards z [rad], shape (rollers,)."""
        found: Array = 2.0 * np.pi * np.arange(self.rollers) / self.rollers
        return found

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
        """Whether the inner ring can bear an axial load along +x, and along -x."""
        return self.nominal_angle > 0.0, False

    @cached_property
    def rib_contacts(self) -> tuple[RibContact, ...]:
        """The contacts of the rollers' ends with ribs that bear loads."""
        return ()

    @property
    def bears_radially(self) -> bool:
        """Whether the inner ring can bear a radial load."""
        return self.nominal_angle <= _MOST_ANGLE

    @property
    def clearance_range(self) -> Range:
        """The clearance [mm]: of a group between its limits, axial of tapered bearings; zero of thrust bearings.

        Raises
        ------
        InputError
            If there is no such group for this bearing.
        """
        clearance = getattr(self, "clearance", 0.0)
        if not isinstance(clearance, str):
            return Range.exactly(clearance)
        if self.bore is None:
            raise InputError("bore", None, f"be given with the clearance group {clearance}", _BORE)
        return clearance_limits(clearance, self.bore, self.clearance_table)

    def at(self, clearance: str = "likely") -> Self:
        """Return the bearing with the least, likely or greatest clearance of its group in place of that."""
        found = self.clearance_range.at(clearance)
        return replace(self, clearance=found) if hasattr(self, "clearance") else self  # type: ignore[call-arg]

    @property
    def radial_clearance(self) -> float | None:
        """From one side to the other the inner ring moves by so much across the axis [mm]; None of thrust bearings.

        Of a group the mean of its limits.
        """
        return self.clearance_range.likely if hasattr(self, "clearance") else None

    @property
    def gap(self) -> float:
        """What each of a roller's two contacts is short of touching when the ring is centred [mm]."""
        return 0.25 * (self.radial_clearance or 0.0) * math.cos(self.nominal_angle)

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows of rollers; one."""
        return (Row(self),)

    @cached_property
    def contacts(self) -> tuple[Contact, Contact]:
        """A roller on the inner and on the outer ring."""
        return Contact(self.roller, self.inner), Contact(self.roller, self.outer)

    @property
    def effective_interval(self) -> tuple[float, float]:
        """Where along their profiles rollers touch both rings, without corners and chamfers [mm].

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
        """What the contacts of every roller are short of touching [mm], at both rings."""
        # Raceways deviate along the radius, washers along the axis; contacts close along their normals.
        along = [math.cos(angle) if self.bears_radially else 1.0 for angle in self.contact_angles]
        inner, outer = (self.gap - self._deviation(f"{ring}_shape") * by for ring, by in zip(RINGS, along, strict=True))
        return inner, outer

    def _at_contact(self, ring: Body, angle: float) -> float:
        """Return the diameter of a raceway square to its generator, where a roller's middle touches it [mm].

        The contact lies off the radial line through the roller's middle, on which the raceway's diameter is given.
        """
        on_line = float(ring.diameter)  # type: ignore[arg-type]
        return on_line / math.cos(angle) + self.roller_diameter * math.tan(angle) ** 2

    def _end(self, radius: float, inclined: float = 0.0) -> End:
        """Return the end of a roller of a radius [mm] there."""
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
        """Return how much less room there is for each roller than a circle leaves [mm]."""
        shape, remedy = getattr(self, name), "let it return lengths in mm, one for each angle"
        if shape is None:
            return np.zeros(self.rollers)
        found = numbers(name, shape(self.angles), remedy)
        if found.shape != (self.rollers,):
            raise InputError(name, found.shape, f"return {self.rollers} lengths for {self.rollers} angles", remedy)
        largest, most = float(np.max(np.abs(found))), MOST_CLEARANCE * self.pitch
        if largest > most:
            radius = 0.5 * abs(float(getattr(self, name.removesuffix("_shape")).diameter or 0.0))
            condition = f"deviate from a circle by at most {mm(most):.3g}"
            remedy = "give deviations in mm, positive where there is less room"
            if np.all(np.abs(found - radius) < 0.1 * radius):
                condition += ": these are radii of the raceway"
                difference = {"inner_shape": "each less their mean", "outer_shape": "their mean less each"}[name]
                remedy = f"give {difference}, positive where there is less room"
            raise InputError(name, largest, condition, remedy)
        return found

    @property
    def roller_density(self) -> float | None:
        """Density of the rollers, as given or that of their material [t/mm^3]; None of a material without a name."""
        return density_of(self.roller.material) if self.density is None else self.density

    @cached_property
    def inertia(self) -> Inertia:
        """What the rollers' mass is and how it is spread; barrels are taken as cylinders."""
        at = np.linspace(-0.5, 0.5, 201) * self.roller_length
        squares = np.zeros((2, at.size))
        for row, across in zip(squares, (self.roller.diameter, self.roller.bore), strict=True):
            row[:] = np.asarray(across(at) if callable(across) else np.full(at.size, across or 0.0)) ** 2
        density = self.roller_density
        if density is None:
            condition = "be given for rollers that are neither of steel nor of a material of the library"
            raise InputError("density", None, condition, _DENSITY)
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
            Speeds of the rings [1/min]; of washers, of the shaft's and of the housing's.

        Raises
        ------
        InputError
            If a speed is not finite, or both are equal.

        Notes
        -----
        The contact angle is the mean of those of both rings, which is that of the rollers' axes.
        """
        size = self.roller_diameter / self.pitch
        ratio = size * math.cos(0.5 * sum(self.contact_angles))
        return rolling(self.rollers, size, ratio, inner_speed, outer_speed)

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return what the speed of a turning ring [rad/s] loads every roller with: along x and r and as moment.

        The roller's axis e is led around the bearing's by the cage while the roller spins about e the other way. What
        loads it is -d/dt of its momentum, and of its angular momentum about its centre of mass.
        """
        finite("speed", speed, "give it in rad/s")
        one_of("turning", turning, RINGS, "name the ring that turns")
        if speed == 0.0:
            return np.zeros(3)
        roller, inclined = self.inertia, 0.5 * sum(self.contact_angles)
        size = self.roller_diameter / self.pitch
        ratio = size * math.cos(self.nominal_angle)
        speeds = (speed, 0.0) if turning == "inner" else (0.0, speed)
        cage, spin = cage_speed(*speeds, ratio), roller_speed(*speeds, ratio, size)
        centrifugal = roller.mass * cage**2 * (0.5 * self.pitch - roller.middle * math.sin(inclined))
        # Of the angular momentum, what is square to the bearing's axis turns with the cage.
        along = roller.polar * (spin + cage * math.cos(inclined))
        across = roller.transverse * cage * math.cos(inclined)
        gyroscopic = cage * math.sin(inclined) * (along - across)
        return np.array([0.0, centrifugal, gyroscopic + centrifugal * roller.middle * math.cos(inclined)])


@described(kw_only=True)
class CylindricalRollerBearing(RollerBearing):
    """A row of cylindrical rollers, whose ribs hold the inner ring along the axis or not.

    If the rib is left out, it touches at 0.7 of the rollers' radius, on flanks that are open by half a degree: a guess.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184).pitch
    46.5
    """

    clearance: Annotated[float | str, _CLEARANCE, _NO_CLEARANCE] = 0.0
    design: Annotated[
        str,
        Word(
            "which ring of a cylindrical bearing has ribs: 'NU', both of the outer one, or 'N', both of the inner one, "
            "which leave the rings free along the axis; 'NJ', both of the outer and one of the inner one, and 'NF', "
            "both of the inner and one of the outer one, which bear axial loads on the inner ring along +x; 'NUP', all "
            "four, both ways",
            "name which ring has ribs",
            tuple(DESIGNS),
        ),
    ] = "NU"
    rib: Annotated[Rib | None, _RIB] = None
    axial_clearance: Annotated[
        float,
        Quantity(
            "mm",
            "how far the inner ring of a 'NUP' moves along the axis from ribs to ribs; half of it to either side, in "
            "other designs too",
            not_negative,
            "give the axial internal clearance in mm",
        ),
        Assumed("no axial clearance", "the axial displacement", lambda row: any(row.bears_axially)),
    ] = 0.0

    @together("design", "rib")
    def _check_design(self) -> None:
        if self.rib is not None and not any(self.bears_axially):
            remedy = "use NJ, NF or NUP, or leave out the rib"
            raise InputError("design", self.design, "have ribs that bear loads, since a rib is given", remedy)

    @property
    def bears_axially(self) -> tuple[bool, bool]:
        """Whether the inner ring can bear an axial load along +x, and along -x."""
        ribs = DESIGNS[self.design]
        # A rib of the inner ring pushes rollers against one of the outer ring at their other ends.
        low, high = (("inner", side) in ribs and ("outer", -side) in ribs for side in (-1, 1))
        return low, high

    @cached_property
    def rib_contacts(self) -> tuple[RibContact, ...]:
        """The contacts of the rollers' ends with ribs that bear loads."""
        if not any(self.bears_axially):
            return ()
        rib = self.rib
        if rib is None:
            height = _RIB_HEIGHT * 0.5 * self.roller_diameter
            rib = Rib(height / math.sin(_RIB_ANGLE), height)
        end, compliances = self._end(0.5 * self.roller_diameter), self._end_compliances
        gap = 0.25 * self.axial_clearance * math.cos(rib.flank_angle)
        return tuple(end.contact(rib, place, gap, compliances[place[0]]) for place in DESIGNS[self.design])


@described(kw_only=True)
class NeedleRollerBearing(CylindricalRollerBearing):
    """A row of needle rollers: cylindrical ones that are long and thin."""


@described(kw_only=True)
class TaperedRollerBearing(RollerBearing):
    """A row of tapered rollers, which bears axial loads on the inner ring along +x.

    Diameters of the raceways are those of the cones on a radial line through the rollers' middles; along the rollers
    they change as the contact angles say. The rollers' large ends are at low x, and so at negative y of their profiles.
    If the rib is left out, the rollers' ends have a radius of 0.95 times the distance to the point at which all cones
    meet, and touch the inner ring's rib at 0.9 of the radius of their large ends: a guess.
    """

    contact_angle: Annotated[float, _ANGLE]
    clearance: Annotated[float | str, _CLEARANCE, _NO_CLEARANCE] = 0.0
    rib: Annotated[Rib | None, _RIB] = None

    @together("roller", "contact_angle")
    def _check_cone(self) -> None:
        if self.roller.length is None:
            return  # which is the rollers' mistake
        if not self.half_cone_angle > 0.0:
            condition = "be a table of y and diameter that is larger at negative y"
            remedy = (
                "give TabulatedDiameter((-5, 5), (11, 10)), or { y = [-5, 5], diameter = [11, 10] } in a file, say: "
                "the large ends are at low x"
            )
            raise InputError("roller.diameter", self.roller.diameter, condition, remedy)
        if self.contact_angles[0] <= 0.0:
            condition = f"exceed the rollers' cone angle of {2.0 * self.half_cone_angle:.4g} rad"
            raise InputError("contact_angle", self.contact_angle, condition, "give that of the outer raceway")

    @property
    def half_cone_angle(self) -> float:
        """Half of the angle at the tip of a roller's cone [rad]; negative if the large end is at positive y."""
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
        """From one side to the other the inner ring moves by so much across the axis [mm], up to this row alone."""
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
        f"the radius of the {ring} ring's groove along the barrels of a spherical bearing, larger than theirs",
        positive,
        _GROOVE,
    )


@described(kw_only=True)
class SphericalRollerBearing(RollerBearing):
    """A row of barrels between grooves, of which the outer one is part of a sphere; usually one of two, in `Paired`.

    Profiles of the bodies are what departs from arcs. Diameters of the raceways are those of the grooves on a radial
    line through the rollers' middles. The contact angle is that of both raceways.
    """

    clearance_table: ClassVar[str] = "spherical"

    contact_angle: Annotated[float, _ANGLE]
    profile_radius: Annotated[
        float,
        Quantity(
            "mm",
            "the radius of the barrels of a spherical bearing along their axis",
            positive,
            "give that of the barrels along their axis in mm",
        ),
    ]
    inner_groove: Annotated[float, _of_groove("inner")]
    outer_groove: Annotated[float, _of_groove("outer")]
    clearance: Annotated[float | str, _CLEARANCE, _NO_CLEARANCE] = 0.0

    @together("inner_groove", "profile_radius")
    def _check_inner_groove(self) -> None:
        self._refuse_groove("inner_groove", self.inner_groove)

    @together("outer_groove", "profile_radius")
    def _check_outer_groove(self) -> None:
        self._refuse_groove("outer_groove", self.outer_groove)

    def _refuse_groove(self, name: str, radius: float) -> None:
        if radius <= self.profile_radius:
            raise InputError(name, radius, f"exceed the radius of the barrels, {mm(self.profile_radius):g}", _GROOVE)

    @property
    def raceway_motions(self) -> tuple[Array, Array]:
        """Approach and tilt at both raceways per motion of ring against roller."""
        barrel = {"roller_radius": 0.5 * self.roller_diameter, "profile_radius": self.profile_radius}
        inner, outer = self.contact_angles
        return raceway_motion(inner, inner=True, **barrel), raceway_motion(outer, inner=False, **barrel)

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return what the speed of a turning ring [rad/s] loads every roller with: along x and r and as moment.

        Only what presses barrels on the outer ring is left: on its sphere they would slide along their axes and turn
        under their gyroscopic moment until they jam, which the guide ring or the cage prevents.
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


@described(kw_only=True)
class CylindricalThrustBearing(RollerBearing):
    """Cylindrical rollers between two washers, which bears axial loads along +x and moments alone.

    ``inner`` is the shaft's washer, which moves, and ``outer`` that of the housing; both are flat, without a diameter.
    The rollers' axes are radial, with y of their profiles towards the bearing's axis.
    """

    pitch_diameter: Annotated[float, replace(_PITCH, meaning="the diameter of the circle of the rollers' middles")] = (
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
            raise InputError("roller.length", self.roller_length, condition, "give that of the rollers' middles in mm")

    @property
    def nominal_angle(self) -> float:
        """Contact angle of the bearing [rad]."""
        return 0.5 * math.pi

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return the moment alone: the cage holds the rollers along their axes, in which direction they are flung."""
        return np.array([0.0, 0.0, super().load_by_speed(speed, turning)[2]])


#: By their words in files.
RollerBearing.kinds = {
    "cylindrical": CylindricalRollerBearing,
    "needle": NeedleRollerBearing,
    "tapered": TaperedRollerBearing,
    "spherical": SphericalRollerBearing,
    "thrust": CylindricalThrustBearing,
}


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
        if not isinstance(self.bearing, SphericalRollerBearing):
            return math.nan
        reach = 0.5 * self.bearing.pitch * math.tan(self.bearing.nominal_angle)
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


_PRELOAD = Quantity(
    "N",
    "axial force between two equal tapered rows in X or O, mounted, cold and without load, in place of the clearance "
    "between them",
    positive,
    "give the axial force in N, or the clearance in its place",
)


def _ways(name: str, value: Any, remedy: str) -> tuple[bool, ...]:
    found = listed(name, value, "be True or False for each row", remedy)
    for way in found:
        flag(name, way, remedy)
    return tuple(found)


@described(kw_only=True)
class Paired(Input):
    """Rows of rollers on one inner ring, or on rings that are clamped together.

    See Also
    --------
    paired : two equal rows in X, O or tandem
    """

    bearings: Annotated[
        tuple[RollerBearing, ...], Several(Part("the rows", RollerBearing, "give two rows, or more"), MOST_ROLLERS)
    ]
    x: Annotated[
        tuple[float, ...],
        Quantities("mm", "axial coordinates of their rollers' middles; the inner ring turns about x = 0"),
    ]
    turned: Annotated[
        tuple[bool, ...],
        Custom("which are turned round, and bear axial loads along -x", _ways, {}, "write True or False for each row"),
    ]
    clearance: Annotated[
        float,
        Quantity(
            "mm",
            "by how much the inner ring moves along the axis between rows that bear axial loads in both directions, "
            "beside what the rows themselves have; negative: preload",
            finite,
            "give the axial clearance in mm",
        ),
        replace(
            _NO_CLEARANCE,
            where=lambda pair: pair.preload is None and not any(row.radial_clearance for row in pair.bearings),
        ),
    ] = 0.0
    preload: Annotated[float | None, _PRELOAD] = None

    @together("bearings", "x", "turned")
    def _check_rows(self) -> None:
        count = len(self.bearings)
        if not count:
            raise InputError("bearings", self.bearings, "be rows of rollers", "give two rows, or more")
        if len(self.x) != count or len(self.turned) != count:
            raise InputError("x", self.x, f"hold {count} places, as many as turned", "give one for each row")

    @together("bearings", "clearance")
    def _check_held(self) -> None:
        if self.clearance and not any(any(each.bears_axially) for each in self.bearings):
            condition = "be zero for rows that do not hold the inner ring along the axis"
            raise InputError("pair.clearance", self.clearance, condition, "leave it out, or use rows with ribs")

    @together("bearings", "x", "turned", "clearance", "preload")
    def _check_preload(self) -> None:
        if self.preload is None:
            return
        if self.clearance:
            raise InputError("pair.preload", self.preload, "not be given together with clearance", "leave one out")
        equal = all(isinstance(row, TaperedRollerBearing) and row == self.bearings[0] for row in self.bearings)
        if not equal or sorted(self.turned) != [False, True]:
            condition = "be left out but for two equal tapered rows in X or O"
            raise InputError("pair.preload", self.preload, condition, "give the clearance of the rows")

    def at(self, clearance: str = "likely") -> Paired:
        """Return the rows with the least, likely or greatest clearance of their groups in place of these."""
        return replace(self, bearings=tuple(row.at(clearance) for row in self.bearings))

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows in their places."""
        firsts = accumulate((each.rollers for each in self.bearings[:-1]), initial=0)
        rows = zip(self.bearings, self.x, self.turned, firsts, strict=True)
        return tuple(Row(each, x, way, 0.5 * self.clearance, first) for each, x, way, first in rows)


@described()
class Pair(Input):
    """How a second row like the first lies, on the same inner ring or on rings that are clamped together."""

    arrangement: Annotated[
        str,
        Word(
            "'X', face to face: the lines of pressure meet between the rows; 'O', back to back: they meet outside; or "
            "'tandem', both rows bearing axial loads along +x",
            "write 'X', 'O' or 'tandem'",
            ARRANGEMENTS,
        ),
    ]
    distance: Annotated[
        float,
        Quantity(
            "mm",
            "the distance of the middles of both rows' rollers along the axis",
            positive,
            "give the distance of the rows in mm",
        ),
    ]
    clearance: Annotated[
        float,
        Quantity(
            "mm",
            "axial clearance of the pair, beside what the rows have themselves; negative: preload",
            finite,
            "give the axial clearance in mm",
        ),
    ] = 0.0
    preload: Annotated[float | None, _PRELOAD] = None

    @classmethod
    def of(cls, rows: Paired) -> Pair:
        """Return how two equal rows lie.

        Raises
        ------
        InputError
            If they are others.
        """
        first, distance = rows.bearings[0], rows.x[-1] - rows.x[0]
        for arrangement in ARRANGEMENTS if distance > 0.0 else ():
            if rows == _paired(first, pair := cls(arrangement, distance, rows.clearance, rows.preload)):
                return pair
        condition = "be two equal rows in X, O or tandem to go into a file"
        raise InputError("bearings", len(rows.bearings), condition, "solve such a bearing in Python")


def paired(
    bearing: RollerBearing,
    arrangement: str,
    distance: float,
    *,
    clearance: float = 0.0,
    preload: float | None = None,
) -> Paired:
    """Return two equal rows.

    Parameters
    ----------
    bearing : RollerBearing
        A row.
    arrangement : {"X", "O", "tandem"}
        ``"X"``, face to face: the lines of pressure meet between the rows. ``"O"``, back to back: they meet outside.
        ``"tandem"``: both rows bear axial loads along +x.
    distance : float
        Between the middles of their rollers along the axis [mm].
    clearance, preload : float
        As in `Paired`.

    Examples
    --------
    >>> import nonhertz as nh
    >>> cone = nh.Roller(diameter=nh.TabulatedDiameter((-6, 6), (11, 10)), length=12)
    >>> rings = {"inner": nh.Ring(diameter=41), "outer": nh.Ring(diameter=-62.5)}
    >>> row = nh.bearing.TaperedRollerBearing(roller=cone, **rings, rollers=14, contact_angle=0.2)
    >>> paired(row, "O", 20.0).turned
    (False, True)
    """
    return _paired(bearing, Pair(arrangement, distance, clearance, preload))


def _paired(bearing: RollerBearing, pair: Pair) -> Paired:
    turned = {"X": (True, False), "O": (False, True), "tandem": (False, False)}[pair.arrangement]
    half = 0.5 * pair.distance
    return Paired(
        bearings=(bearing, bearing), x=(-half, half), turned=turned, clearance=pair.clearance, preload=pair.preload
    )


def parts_of(bearing: RollerBearing | Paired) -> dict[str, Input]:
    """Return the inputs of which a bearing is made, by their places in a file.

    The clearance of rows that hold each other along the axis is that of the pair.
    """
    row = bearing.rows[0].bearing
    paired_by_angle = isinstance(bearing, Paired) and row.nominal_angle > 0.0
    parts = {"roller": row.roller, "inner": row.inner, "outer": row.outer}
    return {**parts, **({"bearing.pair": bearing} if paired_by_angle else {"bearing": row})}


def _along(y: Array, middle: float, slope: float) -> TabulatedDiameter:
    """Return a diameter that changes evenly along a generator."""
    return TabulatedDiameter(tuple(y.tolist()), tuple((middle + slope * y).tolist()))
