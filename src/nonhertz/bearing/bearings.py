"""Bearings as values: rollers between an inner and an outer ring, made of the package's own bodies."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.bearing.ribs import DESIGNS, End, Rib, RibContact
from nonhertz.bearing.section import raceway_motion, ring_motion
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, flag, listed, not_negative, numbers, one_of, positive, whole
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.contact import Contact
from nonhertz.model.materials import density_of
from nonhertz.model.profile import crown

Array = NDArray[np.float64]
#: How far a raceway lies from a circle: at angles [rad], how much less room it leaves [mm].
Shape = Callable[[Array], ArrayLike]

MOST_ROLLERS = 1000
# Of the roller's diameter: by how much raceways may leave more or less room for it than the clearance says.
FITS = 0.02
ARRANGEMENTS = ("X", "O", "tandem")
_MOST_ANGLE = math.radians(45.0)
_DENSITY = "give it in t/mm^3, 7.85e-9 for steel"
# Where ribs touch cylindrical rollers, over their radius, and by how much their flanks are open [rad]: both guessed.
_RIB_HEIGHT, _RIB_ANGLE = 0.7, math.radians(0.5)


class Inertia(NamedTuple):
    """Mass of a roller and how it is spread.

    Attributes
    ----------
    mass : float
        [t].
    middle : float
        Where along the roller its centre of mass lies [mm].
    polar, transverse : float
        Moments of inertia about the roller's axis, and square to it about its centre of mass [t mm^2].
    """

    mass: float
    middle: float
    polar: float
    transverse: float


@dataclass(frozen=True, kw_only=True)
class RollerBearing:
    """Rollers in a row between an inner and an outer ring; use one of the classes made from it.

    Parameters
    ----------
    roller : Body
        The rollers, with diameter and length; y of its profile goes along the bearing's axis, x.
    inner, outer : Body
        The raceways where they touch the rollers: diameters [mm], negative for the outer one.
    rollers : int
        How many there are.
    pitch_diameter : float or None
        Diameter of the circle of the rollers' middles [mm]; the mean of both raceways if left out.
    inner_shape, outer_shape : callable or None
        Angles [rad] -> how much less room the raceway leaves there than a circle does, along the radius [mm]; of the
        washers of a thrust bearing, how far they rise there along the axis.
    density : float or None
        Of the rollers [t/mm^3], for what speed does; if left out, that of their material: steel, or one of the library.

    Raises
    ------
    InputError
        If the parts do not make a bearing.
    """

    roller: Body
    inner: Body
    outer: Body
    rollers: int
    pitch_diameter: float | None = None
    inner_shape: Shape | None = None
    outer_shape: Shape | None = None
    density: float | None = None

    def __post_init__(self) -> None:
        for name in ("roller", "inner", "outer"):
            if not isinstance(getattr(self, name), Body):
                raise InputError(name, getattr(self, name), "be a Body", "make one with Roller, Ring or Body")
        if self.roller.length is None:
            raise InputError("roller.length", None, "be given", "give the length of the rollers in mm")
        if not self.roller_diameter > 0.0:
            raise InputError("roller.diameter", self.roller.diameter, "be positive", "give the diameter in mm")
        self._check_raceways()
        most = whole("rollers", self.rollers, 1, MOST_ROLLERS, "give the number of rollers of the row")
        object.__setattr__(self, "rollers", most)
        if self.pitch_diameter is not None:
            positive("pitch_diameter", self.pitch_diameter, "give that of the rollers' middles in mm")
        if self.density is not None:
            positive("density", self.density, _DENSITY)
        for name in ("inner_shape", "outer_shape"):
            shape = getattr(self, name)
            if shape is not None:
                if not callable(shape):
                    raise InputError(name, shape, "be a function of the angle", "give one, or leave it out")
                self._deviation(name, shape)
        self._check_room()

    def _check_raceways(self) -> None:
        for name, sign, words in (("inner", 1.0, "positive: it is convex"), ("outer", -1.0, "negative: it is concave")):
            diameter = getattr(self, name).diameter
            if callable(diameter) or diameter is None or not sign * diameter > 0.0:
                raise InputError(f"{name}.diameter", diameter, f"be {words}", "give that of the raceway in mm")

    def _check_room(self) -> None:
        """Refuse rollers that do not fit side by side or between the raceways."""
        self._check_circle()
        diameter = self.roller_diameter
        room = 0.5 * self.play + diameter
        if abs(0.5 * self.play) > FITS * diameter:
            condition = (
                f"fill the {room:.6g} mm between raceways of {self.inner.diameter:g} and "
                f"{abs(self.outer.diameter):g} mm to within {100.0 * FITS:g} %"  # type: ignore[arg-type]
            )
            raise InputError("roller.diameter", diameter, condition, "give the diameters of raceways and rollers in mm")
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        # The middle between cones that meet in one point lies a little outside of the rollers' axis.
        within = (math.cos(2.0 * mean) + math.cos(2.0 * half)) / (2.0 * math.cos(mean) ** 2)
        middle = 0.5 * (float(self.inner.diameter) + abs(float(self.outer.diameter))) * within  # type: ignore[arg-type]
        if self.pitch_diameter is not None and abs(self.pitch_diameter - middle) > FITS * diameter:
            condition = (
                f"lie within {100.0 * FITS:g} % of the rollers' diameter of the {middle:.6g} mm between the raceways"
            )
            raise InputError("pitch_diameter", self.pitch_diameter, condition, "leave it out, or check the raceways")

    @property
    def play(self) -> float:
        """What the diameters of raceways and rollers leave between them [mm]: no clearance, which is given as such."""
        # Cones that meet in one point: their radial distance is measured along a line that is square to neither.
        inner, outer = self.contact_angles
        mean, half = 0.5 * (inner + outer), 0.5 * (outer - inner)
        square = math.cos(inner) * math.cos(outer) / (math.cos(mean) * math.cos(half) ** 2)
        return (abs(float(self.outer.diameter)) - float(self.inner.diameter)) * square - 2.0 * self.roller_diameter  # type: ignore[arg-type]

    def _check_circle(self) -> None:
        diameter, pitch = self.roller_diameter, self.pitch
        # Thin rollers on a huge circle must not overflow.
        most = int(math.pi / math.asin(min(1.0, max(1e-9, diameter / pitch))) + 1e-9)
        if pitch <= diameter or self.rollers > most:
            fit = "none fits" if pitch <= diameter else f"{most} fit side by side"
            condition = f"fit on a pitch circle of {pitch:.6g} mm with a diameter of {diameter:.6g} mm: {fit}"
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
    def gap(self) -> float:
        """What each of a roller's two contacts is short of touching when the ring is centred [mm]."""
        return float(0.25 * getattr(self, "clearance", 0.0) * math.cos(self.nominal_angle))

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
        shapes = ("inner_shape", self.inner_shape), ("outer_shape", self.outer_shape)
        inner, outer = (
            # Raceways deviate along the radius, washers along the axis; contacts close along their normals.
            0.0 if shape is None else self._deviation(name, shape) * (math.cos(angle) if self.bears_radially else 1.0)
            for (name, shape), angle in zip(shapes, self.contact_angles, strict=True)
        )
        gap = np.full(self.rollers, self.gap)
        return gap - inner, gap - outer

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
        return {name: roller + getattr(self, name).material.compliance for name in ("inner", "outer")}

    def _deviation(self, name: str, shape: Shape) -> Array:
        remedy = "let it return lengths in mm, one for each angle"
        found = numbers(name, shape(self.angles), remedy)
        if found.shape != (self.rollers,):
            raise InputError(name, found.shape, f"return {self.rollers} lengths for {self.rollers} angles", remedy)
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

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return what the speed of a turning ring [rad/s] loads every roller with: along x and r and as moment.

        The roller's axis e is led around the bearing's by the cage while the roller spins about e the other way. What
        loads it is -d/dt of its momentum, and of its angular momentum about its centre of mass.
        """
        finite("speed", speed, "give it in rad/s")
        one_of("turning", turning, ("inner", "outer"), "name the ring that turns")
        if speed == 0.0:
            return np.zeros(3)
        roller, inclined = self.inertia, 0.5 * sum(self.contact_angles)
        ratio = self.roller_diameter * math.cos(self.nominal_angle) / self.pitch
        sense = -1.0 if turning == "inner" else 1.0
        cage = 0.5 * speed * (1.0 + sense * ratio)
        spin = sense * 0.5 * speed * self.pitch / self.roller_diameter * (1.0 - ratio**2)
        centrifugal = roller.mass * cage**2 * (0.5 * self.pitch - roller.middle * math.sin(inclined))
        # Of the angular momentum, what is square to the bearing's axis turns with the cage.
        along = roller.polar * (spin + cage * math.cos(inclined))
        across = roller.transverse * cage * math.cos(inclined)
        gyroscopic = cage * math.sin(inclined) * (along - across)
        return np.array([0.0, centrifugal, gyroscopic + centrifugal * roller.middle * math.cos(inclined)])


@dataclass(frozen=True, kw_only=True)
class CylindricalRollerBearing(RollerBearing):
    """A row of cylindrical rollers, whose ribs hold the inner ring along the axis or not.

    Parameters
    ----------
    clearance : float
        Radial internal clearance: from one side to the other the inner ring moves by so much [mm]. Negative: preload.
    design : {"NU", "N", "NJ", "NF", "NUP"}
        Which ring has ribs. ``"NU"``: both of the outer ring, and ``"N"``: both of the inner one, so that the rings are
        free to move along the axis. ``"NJ"``: both of the outer and one of the inner ring, and ``"NF"``: both of the
        inner and one of the outer one, which bear axial loads on the inner ring along +x. ``"NUP"``: all four.
    rib : Rib or None
        Where the ribs touch the rollers' ends. If left out, at 0.7 of the rollers' radius on flanks that are open by
        half a degree: a guess.
    axial_clearance : float
        How far the inner ring of a NUP moves along the axis from ribs to ribs; half of it from the middle to either
        side, in other designs too [mm].

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.018).pitch
    46.5
    """

    clearance: float = 0.0
    design: str = "NU"
    rib: Rib | None = None
    axial_clearance: float = 0.0

    def __post_init__(self) -> None:
        super().__post_init__()
        finite("clearance", self.clearance, "give the radial internal clearance in mm")
        if abs(self.clearance) > FITS * self.roller_diameter:
            condition = f"be less than {100.0 * FITS:g} % of the roller's diameter of {self.roller_diameter:g} mm"
            raise InputError("clearance", self.clearance, condition, "give it in mm: 20 um are 0.02")
        one_of("design", self.design, tuple(DESIGNS), "name which ring has ribs")
        not_negative("axial_clearance", self.axial_clearance, "give the axial internal clearance in mm")
        if self.rib is not None:
            _check_rib(self.rib)
            if not any(self.bears_axially):
                remedy = "use NJ, NF or NUP, or leave out the rib"
                raise InputError("design", self.design, "have ribs that bear loads, since a rib is given", remedy)
        _ = self.rib_contacts

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


@dataclass(frozen=True, kw_only=True)
class NeedleRollerBearing(CylindricalRollerBearing):
    """A row of needle rollers: cylindrical ones that are long and thin."""


@dataclass(frozen=True, kw_only=True)
class TaperedRollerBearing(RollerBearing):
    """A row of tapered rollers, which bears axial loads on the inner ring along +x.

    Diameters of the raceways are those of the cones on a radial line through the rollers' middles; along the rollers
    they change as the contact angles say. The rollers' large ends are at low x, and so at negative y of their profiles.

    Parameters
    ----------
    contact_angle : float
        Angle between the normal of the outer raceway and the radial plane [rad].
    clearance : float
        Axial internal clearance: by so much the inner ring moves along the axis from contact on this row to where
        another, of the same kind, would hold it [mm]. Negative: preload.
    rib : Rib or None
        The rib of the inner ring. If left out, the rollers' ends have a radius of 0.95 times the distance to the
        point at which all cones meet, and touch at 0.9 of the radius of their large ends: a guess.
    """

    contact_angle: float
    clearance: float = 0.0
    rib: Rib | None = None

    def __post_init__(self) -> None:
        _check_angle(self.contact_angle)
        finite("clearance", self.clearance, "give the axial internal clearance in mm")
        if self.rib is not None:
            _check_rib(self.rib)
        if isinstance(self.roller, Body) and self.roller.length is not None:
            self._check_cone()
        super().__post_init__()

    def _check_cone(self) -> None:
        if not self.half_cone_angle > 0.0:
            condition = "be a TabulatedDiameter that is larger at negative y"
            remedy = "give TabulatedDiameter((-5, 5), (11, 10)), say: the large ends are at low x"
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
    def gap(self) -> float:
        """What each of a roller's two contacts is short of touching when the ring is centred [mm]."""
        return 0.5 * self.clearance * math.sin(self.contact_angle)

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


@dataclass(frozen=True, kw_only=True)
class SphericalRollerBearing(RollerBearing):
    """A row of barrels between grooves, of which the outer one is part of a sphere; usually one of two, in `Paired`.

    Profiles of the bodies are what departs from arcs. Diameters of the raceways are those of the grooves on a radial
    line through the rollers' middles.

    Parameters
    ----------
    contact_angle : float
        Angle between the normals of the raceways and the radial plane [rad].
    profile_radius : float
        Radius of the barrels along their axis [mm].
    inner_groove, outer_groove : float
        Radii of the grooves along the rollers [mm], larger than that of the barrels.
    clearance : float
        Radial internal clearance [mm].
    """

    contact_angle: float
    profile_radius: float
    inner_groove: float
    outer_groove: float
    clearance: float = 0.0

    def __post_init__(self) -> None:
        _check_angle(self.contact_angle)
        finite("clearance", self.clearance, "give the radial internal clearance in mm")
        positive("profile_radius", self.profile_radius, "give that of the barrels along their axis in mm")
        for name in ("inner_groove", "outer_groove"):
            radius = getattr(self, name)
            positive(name, radius, "give that of the groove along the rollers in mm")
            if radius <= self.profile_radius:
                condition = f"exceed the radius of the barrels, {self.profile_radius:g} mm"
                raise InputError(name, radius, condition, "give that of the groove along the rollers in mm")
        super().__post_init__()

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


@dataclass(frozen=True, kw_only=True)
class CylindricalThrustBearing(RollerBearing):
    """Cylindrical rollers between two washers, which bears axial loads along +x and moments alone.

    ``inner`` is the shaft's washer, which moves, and ``outer`` that of the housing; both are flat, without a diameter.
    The rollers' axes are radial, with y of their profiles towards the bearing's axis.
    """

    pitch_diameter: float

    def _check_raceways(self) -> None:
        positive("pitch_diameter", self.pitch_diameter, "give that of the rollers' middles in mm")
        for name in ("inner", "outer"):
            diameter = getattr(self, name).diameter
            if diameter is not None:
                raise InputError(f"{name}.diameter", diameter, "be left out: washers are flat", "use a Plate")

    def _check_room(self) -> None:
        self._check_circle()
        if self.roller_length >= self.pitch:
            condition = f"be less than the pitch diameter of {self.pitch:g} mm"
            raise InputError("roller.length", self.roller_length, condition, "give that of the rollers' middles in mm")

    @property
    def nominal_angle(self) -> float:
        """Contact angle of the bearing [rad]."""
        return 0.5 * math.pi

    def load_by_speed(self, speed: float, turning: str = "inner") -> Array:
        """Return the moment alone: the cage holds the rollers along their axes, in which direction they are flung."""
        return np.array([0.0, 0.0, super().load_by_speed(speed, turning)[2]])


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
    """

    bearing: RollerBearing
    x: float = 0.0
    turned: bool = False
    clearance: float = 0.0

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


@dataclass(frozen=True, kw_only=True)
class Paired:
    """Rows of rollers on one inner ring, or on rings that are clamped together.

    Parameters
    ----------
    bearings : sequence of RollerBearing
        The rows.
    x : sequence of float
        Axial coordinates of their rollers' middles [mm], about which the inner ring turns at x = 0.
    turned : sequence of bool
        Which of them are turned round, and bear axial loads along -x.
    clearance : float
        By how much the inner ring moves along the axis between rows that bear axial loads in both directions, beside
        what the rows themselves have [mm]. Negative: preload.

    See Also
    --------
    paired : two equal rows in X, O or tandem
    """

    bearings: tuple[RollerBearing, ...]
    x: tuple[float, ...]
    turned: tuple[bool, ...]
    clearance: float = 0.0

    def __post_init__(self) -> None:
        remedy = "give two rows, or more"
        members = listed("bearings", self.bearings, "be rows of rollers", remedy)
        for each in members:
            if not isinstance(each, RollerBearing):
                raise InputError("bearings", each, "be rows of rollers", remedy)
        places = numbers("x", self.x, "give the axial coordinates of the rows in mm")
        ways = listed("turned", self.turned, "be True or False for each row", "give one for each row")
        if not members:
            raise InputError("bearings", self.bearings, "be rows of rollers", remedy)
        if places.shape != (len(members),) or len(ways) != len(members):
            raise InputError("x", self.x, f"hold {len(members)} places, as many as turned", "give one for each row")
        for way in ways:
            flag("turned", way, "write True or False for each row")
        finite("clearance", self.clearance, "give the axial clearance in mm")
        if self.clearance and not any(any(each.bears_axially) for each in members):
            condition = "be zero for rows that do not hold the inner ring along the axis"
            raise InputError("pair.clearance", self.clearance, condition, "leave it out, or use rows with ribs")
        object.__setattr__(self, "bearings", tuple(members))
        object.__setattr__(self, "x", tuple(places.tolist()))
        object.__setattr__(self, "turned", tuple(ways))

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows in their places."""
        both = zip(self.bearings, self.x, self.turned, strict=True)
        return tuple(Row(each, x, way, 0.5 * self.clearance) for each, x, way in both)


def paired(bearing: RollerBearing, arrangement: str, distance: float, *, clearance: float = 0.0) -> Paired:
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
    clearance : float
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
    one_of("arrangement", arrangement, ARRANGEMENTS, "write 'X', 'O' or 'tandem'")
    positive("distance", distance, "give the distance of the rows in mm")
    turned = {"X": (True, False), "O": (False, True), "tandem": (False, False)}[arrangement]
    half = 0.5 * float(distance)
    return Paired(bearings=(bearing, bearing), x=(-half, half), turned=turned, clearance=clearance)


def _check_rib(rib: Rib) -> None:
    if not isinstance(rib, Rib):
        raise InputError("rib", rib, "be a Rib", "make one with nonhertz.bearing.Rib, or leave it out")


def _check_angle(angle: float) -> None:
    positive("contact_angle", angle, "give it in rad: 12 degrees are 0.21")
    if angle > _MOST_ANGLE:
        condition = f"not exceed {_MOST_ANGLE:.4g} rad, 45 degrees"
        raise InputError("contact_angle", angle, condition, "give it in rad: 12 degrees are 0.21")


def _along(y: Array, middle: float, slope: float) -> TabulatedDiameter:
    """Return a diameter that changes evenly along a generator."""
    return TabulatedDiameter(tuple(y.tolist()), tuple((middle + slope * y).tolist()))
