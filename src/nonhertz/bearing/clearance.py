"""Operating clearance: what fits, temperatures and speed leave of the clearance that a bearing has unmounted.

Shaft, inner ring, outer ring and housing are plain rings of the diameters d_0 to d, d to F, E to D and D to D_H, with F
and E of the raceways (`nonhertz.bearing.thick_rings`). A fit is pressed together if the parts, each by itself at its
temperature and speed, would overlap: with the growths u of free parts and their compliances c = u / p,

    p = max(0, (I / 2 + u_inside - u_outside) / (c_inside + c_outside))        I: interference on the diameter

where they meet, and a fit whose pressure falls to zero is lost: from there on both parts grow as free ones. Rings stay
round and stress-free along the axis, whatever the width of seat and ring; ribs, chamfers and the load of the rollers on
the rings are neglected, and so is how far they slip. The clearance is

    C = E - F - 2 D_w / cos(alpha)        each of them as it has grown.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal

from nonhertz.amounts import digits, given, mm, mpa, um
from nonhertz.bearing.bearings import RollerBearing, TaperedRollerBearing
from nonhertz.bearing.fits import HOUSINGS, SHAFTS, Range, ring_limits, seat_limits
from nonhertz.bearing.kinematics import PER_MINUTE
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.thick_rings import ThickRing
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import finite, not_negative, number_that, one_of, positive
from nonhertz.inputs.fields import Input, Part, Quantity, Word, described, together
from nonhertz.model.material import STEEL, Material
from nonhertz.model.materials import STEEL_EXPANSION, NamedMaterial, density_of, expansion_of
from nonhertz.result.brief import plain_text

REFERENCE = 20.0  # degC, at which dimensions are given
COLDEST, HOTTEST = -273.15, 1000.0  # degC
MOST_EXPANSION = 1e-3  # 1/K
MOST_STEP = 30.0  # K, between a ring and the part it is pressed on, above which one of both was probably left out
MOST_INTERFERENCE = 0.01  # of the diameter: ten times what elastic steel bears
_IN_TONNES = "give it in t/mm^3, 7.85e-9 for steel"
_IN_MM = "give it on the diameter in mm: 20 um are 0.02"


_IN_OPERATION = "the clearance in operation"
_COLD = Assumed(f"ring at {REFERENCE:g} °C", _IN_OPERATION)

_expansion = number_that(lambda value: abs(value) <= MOST_EXPANSION, f"not exceed {MOST_EXPANSION:g} per kelvin")
_temperature = number_that(lambda value: COLDEST <= value <= HOTTEST, f"lie between {COLDEST:g} and {HOTTEST:g} degC")


def _outside(name: str, value: float, remedy: str) -> None:
    if value != math.inf:
        positive(name, value, remedy)


_BORE = "give that of a hollow shaft in mm, 0 for a solid one"
_OUTSIDE = "give that of the housing in mm, or leave it out for an endless one"


def _of_temperature(part: str, usual: str = "") -> Quantity:
    meaning = f"temperature of the {part} in degrees Celsius, a plain number{usual and f'; {usual} if left out'}"
    return Quantity("", meaning, _temperature, "give it in degC")


def _of_expansion(part: str) -> Quantity:
    meaning = f"thermal expansion of the {part} per kelvin, a plain number; that of its material if left out"
    return Quantity("", meaning, _expansion, "give it in 1/K, 12.5e-6 for bearing steel")


def _of_density(part: str) -> Quantity:
    return Quantity("t/mm^3", f"density of the {part}; that of its material if left out", positive, _IN_TONNES)


def _of_class(part: str, classes: tuple[str, ...], example: str) -> Word:
    return Word(
        f"tolerance class of the {part} by ISO 286, such as '{example}', which with that of the bearing leaves the "
        "interference between limits",
        f"give a class such as '{example}', or the interference in mm",
        classes,
        noun="tolerance class",
    )


@described(kw_only=True)
class _Seat(Input):
    """What shaft and housing have in common."""

    diameter: Annotated[
        float | None,
        Quantity(
            "mm",
            "the diameter of the seat; the bearing's bore d, or its outside diameter D, if left out",
            positive,
            "give that of the seat in mm",
        ),
    ] = None
    fit: Annotated[str | None, _of_class("seat", (*SHAFTS, *HOUSINGS), "k5")] = None
    interference: Annotated[
        float | None,
        Quantity(
            "mm",
            "by how much the part that is inside is larger than the one around it, on the diameter, both at 20 degrees "
            "Celsius and unmounted, in place of what the class leaves open; negative for a loose fit",
            finite,
            _IN_MM,
        ),
        Assumed("no interference", _IN_OPERATION, lambda seat: seat.fit is None),
    ] = None
    smoothing: Annotated[
        float,
        Quantity(
            "mm",
            "what pressing flattens of the roughness of both surfaces, and an interference so loses, on the diameter",
            not_negative,
            _IN_MM,
        ),
    ] = 0.0
    material: Annotated[
        NamedMaterial,
        Assumed("steel of no grade", _IN_OPERATION, lambda seat: seat.may_press),
    ] = STEEL
    expansion: Annotated[float | None, _of_expansion("part")] = None
    temperature: Annotated[float | None, _of_temperature("part", "that of its ring")] = None

    ring: ClassVar[str]

    @together("diameter", "interference")
    def _check_interference(self) -> None:
        diameter, interference = self.diameter or math.inf, self.interference or 0.0
        if abs(interference) > MOST_INTERFERENCE * diameter:
            condition = f"not exceed {100.0 * MOST_INTERFERENCE:g} % of the diameter of {mm(diameter):g}"
            raise InputError("interference", interference, condition, _IN_MM)

    @property
    def may_press(self) -> bool:
        """Whether the parts may press on each other; not by a loose fit that is measured."""
        return self.effective_interference > 0.0 or (self.interference is None and self.fit is not None)

    @property
    def effective_interference(self) -> float:
        """What is left of the interference when the roughness is flattened; a loose fit flattens nothing."""
        interference = self.interference or 0.0
        return max(interference - self.smoothing, min(interference, 0.0))

    def _given(self, name: str) -> str:
        """Return the field from which the interference comes, of a seat of a name."""
        return f"{name}.{'interference' if self.fit is None or self.interference is not None else 'fit'}"

    def _diameter_on(self, bearing: RollerBearing) -> float:
        """Return the diameter [mm]: that of the bearing, if it has none of its own."""
        name = "bore" if self.ring == "inner" else "outside_diameter"
        diameter: float | None = getattr(bearing, name) if self.diameter is None else self.diameter
        if diameter is None:
            raise InputError(
                "diameter", None, f"be given where the bearing has no {name}", "give that of the seat in mm"
            )
        return diameter

    def _interferences(self, bearing: RollerBearing) -> Range:
        """Return the interference that the class leaves, or the one that is measured [mm].

        Raises
        ------
        InputError
            If there is no such class for this size, or neither seat nor bearing has a diameter.
        """
        diameter = self._diameter_on(bearing)
        if self.interference is not None or self.fit is None:
            return Range.exactly(self.interference or 0.0)
        tapered = isinstance(bearing, TaperedRollerBearing)
        try:
            seat = seat_limits(self.fit, diameter)
            ring = ring_limits(self.ring, diameter, bearing.tolerance_class, tapered=tapered)
        except InputError as error:
            raise error.about("diameter", error.value) from None
        return seat - ring if self.ring == "inner" else ring - seat


@described(kw_only=True)
class Shaft(_Seat):
    """The seat of an inner ring.

    Raises
    ------
    InputError
        If the shaft cannot be.

    Notes
    -----
    For smoothing DIN 7190 takes 0.8 (Rz_1 + Rz_2), and NSK leaves d / (d + 2) of the interference of a ground shaft, d
    in mm; both are recalled.
    """

    ring: ClassVar[str] = "inner"

    fit: Annotated[str | None, _of_class("shaft", SHAFTS, "k5")] = None
    bore: Annotated[
        float, Quantity("mm", "the diameter of the bore of a hollow shaft; 0: solid", not_negative, _BORE)
    ] = 0.0
    density: Annotated[float | None, _of_density("shaft")] = None

    @together("diameter", "bore")
    def _check_bore(self) -> None:
        if self.diameter is not None and self.bore >= self.diameter:
            condition = f"be less than the diameter of the shaft of {mm(self.diameter):g}"
            raise InputError("bore", self.bore, condition, _BORE)


@described(kw_only=True)
class Housing(_Seat):
    """The seat of an outer ring.

    Raises
    ------
    InputError
        If the housing cannot be.
    """

    ring: ClassVar[str] = "outer"

    fit: Annotated[str | None, _of_class("housing", HOUSINGS, "H7")] = None
    outside_diameter: Annotated[
        float,
        Quantity("mm", "the diameter of the housing as a ring; endless if left out", _outside, _OUTSIDE),
        Assumed("endless housing", _IN_OPERATION, lambda seat: seat.may_press),
    ] = math.inf

    @together("diameter", "outside_diameter")
    def _check_outside(self) -> None:
        if self.diameter is not None and self.outside_diameter <= self.diameter:
            condition = f"exceed that of the seat of {mm(self.diameter):g}"
            raise InputError("outside_diameter", self.outside_diameter, condition, _OUTSIDE)


def _of_seat(ring: str, of: type[_Seat], classes: Iterable[str], example: str) -> Part:
    remedy = f"give a class such as '{example}', or make one with nonhertz.bearing.{of.__name__}"
    meaning = f"the seat of the {ring} ring: its class alone, or a table"
    return Part(meaning, of, remedy, {name: of(fit=name) for name in classes})


@described(kw_only=True)
class Mounting(Input):
    """Fits and temperatures, which leave the clearance that a bearing is solved with.

    Raises
    ------
    InputError
        If one of them is out of range.

    Notes
    -----
    With one steel for all parts, fits alone give the formulas of bearing makers (recalled from NSK's technical report).
    Of the interference, the inner raceway grows by k (1 - k_0^2) / (1 - k^2 k_0^2) with k = d / F and k_0 = d_0 / d;
    the outer one shrinks by h (1 - h_0^2) / (1 - h^2 h_0^2) with h = E / D and h_0 = D / D_H.

    References
    ----------
    S. Timoshenko, J. N. Goodier, *Theory of Elasticity*, McGraw-Hill: thick cylinders and rotating discs (recalled).

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0325)
    >>> mounting = Mounting(shaft=Shaft(diameter=30, interference=0.012), housing=Housing(diameter=62))
    >>> found = mounting.operating(row)
    >>> round(found.lost_to_inner_fit, 5), round(found.clearance, 5), round(found.inner.pressure, 1)
    (0.0096, 0.0229, 14.9)
    >>> mounting.mounted(row).clearance == found.clearance
    True
    """

    shaft: Annotated[Shaft, _of_seat("inner", Shaft, SHAFTS, "k5")]
    housing: Annotated[Housing, _of_seat("outer", Housing, HOUSINGS, "H7")]
    inner_temperature: Annotated[float, _of_temperature("inner ring"), _COLD] = REFERENCE
    roller_temperature: Annotated[float | None, _of_temperature("rollers", "the mean of both rings")] = None
    outer_temperature: Annotated[float, _of_temperature("outer ring"), _COLD] = REFERENCE
    ring_expansion: Annotated[float | None, _of_expansion("rings")] = None
    roller_expansion: Annotated[float | None, _of_expansion("rollers")] = None
    ring_density: Annotated[float | None, _of_density("inner ring")] = None

    @property
    def temperatures(self) -> dict[str, float]:
        """Temperatures of all parts [degC], by name: those left out too."""
        inner, outer, rollers = self.inner_temperature, self.outer_temperature, self.roller_temperature
        return {
            "shaft.temperature": inner if self.shaft.temperature is None else self.shaft.temperature,
            "inner_temperature": inner,
            "roller_temperature": 0.5 * (inner + outer) if rollers is None else rollers,
            "outer_temperature": outer,
            "housing.temperature": outer if self.housing.temperature is None else self.housing.temperature,
        }

    def at(self, bearing: RollerBearing, clearance: str = "likely") -> tuple[Mounting, RollerBearing]:
        """Return fits and bearing with numbers in place of classes.

        Parameters
        ----------
        bearing : RollerBearing
            The bearing.
        clearance : {"likely", "least", "greatest"}
            At the mean of all limits, or at those limits of all that leave the least or the greatest clearance.

        Raises
        ------
        InputError
            If a class is none for its size, or a diameter is missing.
        """
        if not isinstance(bearing, RollerBearing) or bearing.radial_clearance is None:
            remedy = "give a cylindrical, needle, tapered or spherical one of one row"
            raise InputError("bearing", bearing, "be a radial roller bearing", remedy)
        interferences = self._interferences(bearing)
        shaft, housing = (0.0 - (-each).at(clearance) for each in interferences)  # not -0.0
        return self._with(bearing, shaft, housing), bearing.at(clearance)

    def _with(self, row: RollerBearing, shaft: float, housing: float) -> Mounting:
        """Return fits with diameters and interferences [mm]."""
        return replace(
            self,
            shaft=replace(self.shaft, diameter=self.shaft._diameter_on(row), interference=shaft, fit=None),
            housing=replace(self.housing, diameter=self.housing._diameter_on(row), interference=housing, fit=None),
        )

    def _interferences(self, row: RollerBearing) -> tuple[Range, Range]:
        """Return the interferences of both seats."""
        name = "shaft"
        try:
            on_shaft = self.shaft._interferences(row)
            name = "housing"
            return on_shaft, self.housing._interferences(row)
        except InputError as error:
            raise error.within(name) from None

    def operating(self, bearing: RollerBearing, speed: float = 0.0, clearance: str = "likely") -> OperatingClearance:
        """Return what is left of the clearance of a bearing in operation, and what took how much of it.

        Parameters
        ----------
        bearing : RollerBearing
            The bearing, with the clearance that it has unmounted; of a tapered one its axial clearance counts as a
            radial one of 2 tan(alpha) times as much.
        speed : float
            Of inner ring and shaft [1/min]; outer ring and housing are at rest.
        clearance : {"likely", "least", "greatest"}
            Which of what classes allow, as in `at`.

        Raises
        ------
        InputError
            If the speed is out of range, a seat does not fit the rings, a class is none for its size, or a warm part's
            expansion or a turning part's density is neither given nor known.
        """
        mounting, row = self.at(bearing, clearance)
        return mounting._operating(row, speed)

    def ranges(self, bearing: RollerBearing, speed: float = 0.0) -> ClearanceRanges:
        """Return between which limits classes leave interferences and clearance of a row.

        Parameters
        ----------
        bearing, speed
            As in `operating`.

        Raises
        ------
        InputError
            As `operating`.
        """
        least, likely, greatest = (self.operating(bearing, speed, each) for each in Range.AT)
        shaft, housing = self._interferences(bearing)
        unmounted = bearing.clearance_range.scaled(_radial(bearing))
        spreads = [(unmounted.spread, unmounted.spread)]
        for ends in (
            [(each, housing.likely) for each in shaft.probable],
            [(shaft.likely, each) for each in housing.probable],
        ):
            low, high = (self._with(bearing, *each).operating(bearing, speed) for each in ends)
            spreads.append((0.5 * (high.mounted - low.mounted), 0.5 * (high.clearance - low.clearance)))
        mounted, operating = (math.hypot(*each) for each in zip(*spreads, strict=True))
        return ClearanceRanges(
            shaft=shaft,
            housing=housing,
            unmounted=unmounted,
            mounted=Range(least.mounted, likely.mounted, greatest.mounted, mounted),
            operating=Range(least.clearance, likely.clearance, greatest.clearance, operating),
        )

    def _operating(self, bearing: RollerBearing, speed: float) -> OperatingClearance:
        """Return what is left of a clearance that is a number by fits that are."""
        unmounted = bearing.clearance_range.likely * _radial(bearing)
        not_negative("speed", speed, "give that of the inner ring in 1/min")
        of_shaft = _density("shaft.density", self.shaft.density, self.shaft.material, speed)
        of_ring = _density("ring_density", self.ring_density, bearing.inner.material, speed)
        cold = _fits(bearing, self.shaft, self.housing, (of_shaft, of_ring))
        warmth = self.temperatures
        on_shaft, inner, outer, in_housing, of_rollers = (
            _strain(name, expansion, part.material, warmth[of])
            for name, expansion, part, of in (
                ("shaft.expansion", self.shaft.expansion, self.shaft, "shaft.temperature"),
                ("ring_expansion", self.ring_expansion, bearing.inner, "inner_temperature"),
                ("ring_expansion", self.ring_expansion, bearing.outer, "outer_temperature"),
                ("housing.expansion", self.housing.expansion, self.housing, "housing.temperature"),
                ("roller_expansion", self.roller_expansion, bearing.roller, "roller_temperature"),
            )
        )
        strains = (on_shaft, inner), (outer, in_housing)
        warm = [replace(fit, strains=each) for fit, each in zip(cold, strains, strict=True)]
        turning = replace(warm[0], speed=speed * PER_MINUTE)
        rollers = 2.0 * bearing.roller_diameter / math.cos(bearing.nominal_angle) * of_rollers
        mounted, warmed = ([fit.raceway for fit in fits] for fits in (cold, warm))
        return OperatingClearance(
            unmounted=unmounted,
            lost_to_inner_fit=mounted[0],
            lost_to_outer_fit=0.0 - mounted[1],  # not -0.0
            lost_to_temperatures=(warmed[0] - mounted[0]) - (warmed[1] - mounted[1]) + rollers,
            lost_to_speed=turning.raceway - warmed[0],
            inner=turning.described(cold[0].pressure, warmth["shaft.temperature"] - warmth["inner_temperature"]),
            outer=warm[1].described(cold[1].pressure, warmth["outer_temperature"] - warmth["housing.temperature"]),
        )

    def expansion(self, bearing: RollerBearing | Paired) -> float:
        """Return by how much temperatures widen the axial clearance between rows of rollers.

        Parameters
        ----------
        bearing : RollerBearing or Paired
            The rows. What lies between their inner rings has the temperature and the expansion of these, and what lies
            between the outer ones theirs.

        Returns
        -------
        float
            What is to be added to the `clearance` of the pair [mm]: in O expansion times difference of temperatures
            times distance, in X minus that, and nothing in tandem, where one row gains what the other loses, nor of a
            single row.
        """
        if isinstance(bearing, RollerBearing):
            return 0.0
        if not isinstance(bearing, Paired):
            raise InputError("bearing", bearing, "be a bearing", "make one with nonhertz.bearing")
        # Where the inner ring moves towards the side to which a row holds it, away from its rollers.
        apart = sum((row.bears_axially[1] - row.bears_axially[0]) * row.x for row in bearing.rows)
        row = bearing.bearings[0]
        inner = _strain("ring_expansion", self.ring_expansion, row.inner.material, self.inner_temperature)
        return (
            inner - _strain("ring_expansion", self.ring_expansion, row.outer.material, self.outer_temperature)
        ) * apart

    def mounted(
        self,
        bearing: RollerBearing | Paired,
        speed: float = 0.0,
        clearance: str = "likely",
        *,
        method: Literal["strips", "slices"] = "strips",
    ) -> RollerBearing | Paired:
        """Return a bearing with what is left of its clearance; rows of a pair have the same seats, and move apart warm.

        Parameters
        ----------
        bearing : RollerBearing or Paired
            The bearing, unmounted.
        speed, clearance
            As in `operating`.
        method : {"strips", "slices"}
            By which the clearance for a preload is found, with rows mounted, at 20 degC and at rest.

        Raises
        ------
        InputError
            As `operating`, or if what is left is not a clearance that a bearing can have.
        """
        one_of("method", method, ("strips", "slices"), "name one of both")
        if isinstance(bearing, Paired):
            if bearing.preload is not None:
                from nonhertz.bearing.verb import adjusted

                cold = tuple(self._cold(row, clearance) for row in bearing.bearings)
                between = adjusted(replace(bearing, bearings=cold), method).clearance  # type: ignore[union-attr]
                bearing = replace(bearing, clearance=between, preload=None)
            rows = tuple(self._row(row, speed, clearance) for row in bearing.bearings)
            return replace(bearing, bearings=rows, clearance=bearing.clearance + self.expansion(bearing))
        return self._row(bearing, speed, clearance)

    def _cold(self, row: RollerBearing, clearance: str) -> RollerBearing:
        """Return a row that is mounted, at 20 degC and at rest."""
        return replace(row, clearance=self.operating(row, 0.0, clearance).mounted / _radial(row))  # type: ignore[call-arg]

    def _row(self, row: RollerBearing, speed: float, clearance: str) -> RollerBearing:
        found = self.operating(row, speed, clearance)
        left = found.axial(row.nominal_angle) if isinstance(row, TaperedRollerBearing) else found.clearance
        try:
            return replace(row, clearance=left)  # type: ignore[call-arg]
        except InputError as error:
            name, value, remedy = self._taker(found, speed)
            raise InputError(name, value, f"leave a clearance: {um(left):.4g} must {error.condition}", remedy) from None

    def _taker(self, found: OperatingClearance, speed: float) -> tuple[str, Any, str]:
        """Return the input that takes most of the clearance, its value, and what to do about it."""
        warmth = self.temperatures
        furthest = max(warmth, key=lambda each: abs(warmth[each] - REFERENCE))
        takers = {
            self.shaft._given("shaft"): (found.lost_to_inner_fit, self.shaft.interference or self.shaft.fit, _IN_MM),
            self.housing._given("housing"): (
                found.lost_to_outer_fit,
                self.housing.interference or self.housing.fit,
                _IN_MM,
            ),
            furthest: (found.lost_to_temperatures, warmth[furthest], "check temperatures and thermal expansions"),
            "speed": (found.lost_to_speed, speed, "give that of the inner ring in 1/min"),
        }
        name = max(takers, key=lambda each: abs(takers[each][0]))
        return name, *takers[name][1:]


def _strain(name: str, expansion: float | None, material: Material, temperature: float) -> float:
    """Return the thermal strain of a part."""
    if expansion is None:
        expansion = STEEL_EXPANSION if temperature == REFERENCE else expansion_of(material)
    if expansion is None:
        of = f"a part of {mpa(material.modulus):g} at {given(temperature)} degC"
        condition = f"be given for {of}, of which the library has none"
        raise InputError(name, None, condition, "give it in 1/K, 23e-6 for aluminium")
    return expansion * (temperature - REFERENCE)


def _density(name: str, density: float | None, material: Material, speed: float) -> float:
    """Return the density of a turning part [t/mm^3]; 0 where it does not matter."""
    if density is not None:
        return density
    found = density_of(material)
    if found is None and speed > 0.0:
        condition = f"be given for a turning part of {mpa(material.modulus):g}, which is not steel"
        raise InputError(name, None, condition, _IN_TONNES)
    return found or 0.0


def clearance_ranges(fit: Mounting | None, bearing: RollerBearing, speed: float = 0.0) -> ClearanceRanges:
    """Return what `Mounting.ranges` does, or without fits the clearance of a bearing that keeps it."""
    if fit is not None:
        return fit.ranges(bearing, speed)
    found = bearing.clearance_range.scaled(_radial(bearing))
    return ClearanceRanges(shaft=None, housing=None, unmounted=found, mounted=found, operating=found)


def _radial(bearing: RollerBearing) -> float:
    """Return how much larger the radial clearance of a row is than the one in its own way."""
    return 2.0 * math.tan(bearing.nominal_angle) if isinstance(bearing, TaperedRollerBearing) else 1.0


@dataclass(frozen=True, kw_only=True)
class ClearanceRanges:
    """Between which limits classes leave interferences and radial clearance of a row [mm].

    Attributes
    ----------
    shaft, housing : Range or None
        Interference on shaft and in housing; None without seats.
    unmounted, mounted, operating : Range
        Radial clearance unmounted, mounted at 20 degC and at rest, and in operation. Its least is where interferences
        are greatest.
    """

    shaft: Range | None
    housing: Range | None
    unmounted: Range
    mounted: Range
    operating: Range

    @property
    def known(self) -> bool:
        """Whether nothing is left open."""
        return all(each is None or each.known for each in (self.shaft, self.housing, self.unmounted))


@dataclass(frozen=True, kw_only=True)
class InterferenceFit:
    """The interference fit of a ring on its seat.

    Attributes
    ----------
    mounted_pressure : float
        Where they meet, at 20 degC and at rest [MPa].
    pressure : float
        The same in operation [MPa]; 0: the parts do not press on each other.
    seat_stress, raceway_stress : float
        Hoop stress of the bearing's ring in operation, at its seat and at its raceway [MPa].
    loosening_speed : float
        Speed at which the pressure falls to zero at the temperatures of operation [1/min]; infinite if none does, and 0
        where the parts part without any. Of an outer ring, which is at rest, infinite or 0.
    temperature_step : float
        By how much the part that is inside is warmer than the one around it [K].
    """

    mounted_pressure: float
    pressure: float
    seat_stress: float
    raceway_stress: float
    loosening_speed: float
    temperature_step: float

    @property
    def loosened(self) -> bool:
        """Whether the parts are pressed together when they are mounted, and not in operation."""
        return self.mounted_pressure > 0.0 and self.pressure == 0.0


@dataclass(frozen=True, kw_only=True, repr=False)
class OperatingClearance(HasFindings):
    """What is left of a bearing's radial clearance, and what took it.

    The losses are taken in turn, and so add up: first the bearing is mounted, then it gets warm, then it turns. What a
    fit gains or loses by temperatures or speed is theirs.

    Attributes
    ----------
    unmounted : float
        Radial clearance at first [mm].
    lost_to_inner_fit, lost_to_outer_fit : float
        Clearance lost to the fits when the bearing is mounted [mm].
    lost_to_temperatures : float
        Clearance lost to temperatures [mm]; negative where they widen it.
    lost_to_speed : float
        Clearance lost to speed [mm].
    inner, outer : InterferenceFit
        Pressures and stresses of both fits.

    See Also
    --------
    Mounting.operating : finds one
    """

    unmounted: float
    lost_to_inner_fit: float
    lost_to_outer_fit: float
    lost_to_temperatures: float
    lost_to_speed: float
    inner: InterferenceFit
    outer: InterferenceFit

    @property
    def findings(self) -> tuple[Finding, ...]:  # type: ignore[override]
        """Doubtful steps of temperature across interference fits: metals pressed together level them out."""
        words = (
            "The {ring} is {step:.3g} K {way} than the {seat} it is pressed together with: check the temperatures of "
            "both."
        )
        parts = ("inner ring", "shaft", -self.inner.temperature_step), (
            "outer ring", "housing", self.outer.temperature_step
        )  # fmt: skip
        return tuple(
            finding(
                "temperature-step",
                words,
                ring=ring,
                seat=seat,
                step=abs(step),
                way="warmer" if step > 0.0 else "colder",
            )
            for (ring, seat, step), fit in zip(parts, (self.inner, self.outer), strict=True)
            if fit.mounted_pressure > 0.0 and abs(step) > MOST_STEP
        )

    @property
    def mounted(self) -> float:
        """Radial clearance mounted, at 20 degC and at rest [mm]."""
        return self.unmounted - (self.lost_to_inner_fit + self.lost_to_outer_fit)

    @property
    def clearance(self) -> float:
        """Radial clearance in operation [mm]; negative: preload."""
        return self.mounted - self.lost_to_temperatures - self.lost_to_speed

    def axial(self, contact_angle: float) -> float:
        """Return the axial clearance of one tapered row that has this radial clearance [mm].

        Parameters
        ----------
        contact_angle : float
            Of the row [rad].

        Returns
        -------
        float
            C / (2 tan alpha): that of a `TaperedRollerBearing`, up to contact on this row alone.
        """
        positive("contact_angle", contact_angle, "give that of the row in rad: 12 degrees are 0.21")
        if contact_angle >= 0.5 * math.pi:
            raise InputError("contact_angle", contact_angle, "be less than a right angle", "give it in rad")
        return 0.5 * self.clearance / math.tan(contact_angle)

    def __repr__(self) -> str:
        said = [
            f"radial clearance {um(self.clearance):4} of {um(self.unmounted):4} unmounted",
            f"taken by the inner fit {um(self.lost_to_inner_fit):4}, by the outer fit {um(self.lost_to_outer_fit):4}",
            f"taken by temperatures {um(self.lost_to_temperatures):4}, by speed {um(self.lost_to_speed):4}",
            *(line for name, fit in (("inner", self.inner), ("outer", self.outer)) for line in _said(name, fit)),
        ]
        return plain_text("OperatingClearance", [*said, *self.warnings])


def _said(name: str, fit: InterferenceFit) -> list[str]:
    state = ", loosened" if fit.loosened else ""
    if 0.0 < fit.loosening_speed < math.inf and not fit.loosened:
        state = f", comes loose at {digits(fit.loosening_speed, 3)}/min"
    return [
        f"{name} fit: pressure {mpa(fit.mounted_pressure):4} mounted, {mpa(fit.pressure):4} in operation{state}",
        f"{name} ring: hoop stress {mpa(fit.seat_stress):4} at the seat, {mpa(fit.raceway_stress):4} at the raceway",
    ]


@dataclass(frozen=True)
class _Joint:
    """Two rings, one in the other, of which one is the bearing's."""

    inside: ThickRing
    outside: ThickRing
    interference: float
    on_shaft: bool
    strains: tuple[float, float] = (0.0, 0.0)  # thermal, of what lies inside and outside
    speed: float = 0.0  # of both [rad/s]

    @property
    def radius(self) -> float:
        """Where they meet [mm]."""
        return self.inside.outer

    def parting(self, *, pressure: float = 0.0, speed: float = 0.0) -> float:
        """Return how far the faces of both parts move apart on the radius under a pressure [MPa] or a speed [rad/s]."""
        outside = self.outside.growth(self.radius, inside=pressure, speed=speed)
        return outside - self.inside.growth(self.radius, outside=pressure, speed=speed)

    @property
    def overlap_at_rest(self) -> float:
        """By how much the parts would overlap on the radius, each by itself and at rest [mm]."""
        return 0.5 * self.interference + self.radius * (self.strains[0] - self.strains[1])

    @property
    def pressure(self) -> float:
        """The pressure between the parts [MPa]."""
        overlap = self.overlap_at_rest - self.speed**2 * self.parting(speed=1.0)
        return max(0.0, overlap / self.parting(pressure=1.0))

    @property
    def ring(self) -> ThickRing:
        """The bearing's ring."""
        return self.outside if self.on_shaft else self.inside

    @property
    def loads(self) -> dict[str, float]:
        """What loads the bearing's ring."""
        return {"inside" if self.on_shaft else "outside": self.pressure, "speed": self.speed}

    @property
    def raceway_radius(self) -> float:
        """Radius of the bearing's raceway [mm]."""
        return self.ring.outer if self.on_shaft else self.ring.inner

    @property
    def raceway(self) -> float:
        """By how much the diameter of the bearing's raceway has grown [mm]."""
        radius, strain = self.raceway_radius, self.strains[1 if self.on_shaft else 0]
        return 2.0 * (self.ring.growth(radius, **self.loads) + strain * radius)

    def described(self, mounted_pressure: float, temperature_step: float) -> InterferenceFit:
        """Return pressures and stresses, beside the pressure when mounted [MPa] and the step of temperature [K]."""
        parting, at_rest = self.parting(speed=1.0), self.overlap_at_rest
        loosening = 0.0 if at_rest <= 0.0 else math.inf
        if at_rest > 0.0 and self.on_shaft and parting > 0.0:
            loosening = math.sqrt(at_rest / parting) / PER_MINUTE
        return InterferenceFit(
            mounted_pressure=mounted_pressure,
            pressure=self.pressure,
            seat_stress=self.ring.hoop_stress(self.radius, **self.loads),
            raceway_stress=self.ring.hoop_stress(self.raceway_radius, **self.loads),
            loosening_speed=loosening,
            temperature_step=temperature_step,
        )


def _fits(
    bearing: RollerBearing, shaft: Shaft, housing: Housing, densities: tuple[float, float]
) -> tuple[_Joint, _Joint]:
    inner, outer = (abs(float(ring.diameter)) for ring in (bearing.inner, bearing.outer))  # type: ignore[arg-type]
    assert shaft.diameter is not None
    assert housing.diameter is not None
    if shaft.diameter >= inner:
        condition = f"be less than that of the inner raceway of {mm(inner):g}"
        raise InputError("shaft.diameter", shaft.diameter, condition, "give the bore of the inner ring in mm")
    if housing.diameter <= outer:
        condition = f"exceed that of the outer raceway of {mm(outer):g}"
        raise InputError("housing.diameter", housing.diameter, condition, "give that around the outer ring in mm")
    seat, bore = 0.5 * shaft.diameter, 0.5 * housing.diameter
    on_shaft = (
        ThickRing(0.5 * shaft.bore, seat, shaft.material, densities[0]),
        ThickRing(seat, 0.5 * inner, bearing.inner.material, densities[1]),
    )
    in_housing = (
        ThickRing(0.5 * outer, bore, bearing.outer.material, 0.0),
        ThickRing(bore, 0.5 * housing.outside_diameter, housing.material, 0.0),
    )
    return (
        _Joint(*on_shaft, shaft.effective_interference, True),
        _Joint(*in_housing, housing.effective_interference, False),
    )
