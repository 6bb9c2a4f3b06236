"""Operating clearance: internal clearance reduced by fits, temperatures and speed.

Shaft, inner ring, outer ring and housing are plain rings of the diameters d_0 to d, d to F, E to D and D to D_H, where
F and E are the raceways (`nonhertz.bearing.thick_rings`). A fit has a pressure if the separate parts at their
temperatures and speed would overlap: with the growths u of free parts and their compliances c = u / p,

    p = max(0, (I / 2 + u_inside - u_outside) / (c_inside + c_outside))        I: interference on the diameter

at the interface; a fit whose pressure falls to zero is lost, and both parts then grow freely. Rings stay round and
stress-free along the axis, whatever the width of seat and ring; ribs, chamfers, the load of the rollers on the rings
and slip are neglected. The clearance is

    C = E - F - 2 D_w / cos(alpha)        with all dimensions in operation,

and with cos(alpha_i) cos(alpha_e) / [cos(beta_m) cos^2(beta)] in place of cos(alpha) for tapered rollers of the half
cone angle beta, whose axes are inclined by beta_m.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Annotated, Any, Literal

from nonhertz.amounts import format_input, mpa, um
from nonhertz.bearing.bearings import RollerBearing, TaperedRollerBearing
from nonhertz.bearing.fits import HOUSINGS, SHAFTS, Range
from nonhertz.bearing.joints import fits_of
from nonhertz.bearing.kinematics import PER_MINUTE
from nonhertz.bearing.operating import ClearanceRanges, OperatingClearance
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.seats import (
    IN_MM,
    IN_OPERATION,
    IN_TONNES,
    REFERENCE,
    Housing,
    Seat,
    Shaft,
    interference_field,
    of_density,
    of_expansion,
    of_temperature,
    seat_diameter,
    seat_interference,
)
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import not_negative, one_of
from nonhertz.inputs.descriptions import Part
from nonhertz.inputs.fields import Input, input_class
from nonhertz.model.material import Material
from nonhertz.model.materials import STEEL_EXPANSION, density_of, expansion_of


def _of_seat(ring: str, of: type[Seat], classes: Iterable[str], example: str) -> Part:
    remedy = f"give a class such as '{example}', or make one with nonhertz.bearing.{of.__name__}"
    meaning = f"the seat of the {ring} ring: a class, or a table"
    noun = f"tolerance class of a {of.__name__.lower()}"
    return Part(meaning, of, remedy, {name: of(fit=name) for name in classes}, noun=noun)


_COLD = Assumed(f"ring at {REFERENCE:g} °C", IN_OPERATION)


@input_class(kw_only=True)
class Mounting(Input):
    """Fits and temperatures, which determine the operating clearance of a bearing.

    Raises
    ------
    InputError
        If one of them is out of range.

    Notes
    -----
    With one steel for all parts, fits alone give the formulas of bearing manufacturers (recalled from NSK's technical
    report). The inner raceway grows by k (1 - k_0^2) / (1 - k^2 k_0^2) times the interference, with k = d / F and
    k_0 = d_0 / d; the outer raceway shrinks by h (1 - h_0^2) / (1 - h^2 h_0^2) times it, with h = E / D and
    h_0 = D / D_H.

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
    inner_temperature: Annotated[float, of_temperature("inner ring"), _COLD] = REFERENCE
    roller_temperature: Annotated[float | None, of_temperature("rollers", "the mean of both rings")] = None
    outer_temperature: Annotated[float, of_temperature("outer ring"), _COLD] = REFERENCE
    ring_expansion: Annotated[float | None, of_expansion("rings")] = None
    roller_expansion: Annotated[float | None, of_expansion("rollers")] = None
    ring_density: Annotated[float | None, of_density("inner ring")] = None

    @property
    def temperatures(self) -> dict[str, float]:
        """Temperatures of all parts [degC], by name, including those left out."""
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
            The mean of all limits, or the limits that give the least or the greatest clearance.

        Raises
        ------
        InputError
            If a class does not exist for a size, or a diameter is missing.
        """
        if not isinstance(bearing, RollerBearing) or bearing.radial_clearance is None:
            remedy = "give a cylindrical, needle, tapered or spherical one of one row"
            raise InputError("bearing", bearing, "be a radial roller bearing", remedy)
        interferences = self._interferences(bearing)
        shaft, housing = (0.0 - (-interference).at(clearance) for interference in interferences)  # not -0.0
        return self._with(bearing, shaft, housing), bearing.at(clearance)

    def _with(self, row: RollerBearing, shaft: float, housing: float) -> Mounting:
        """Return fits with diameters and interferences [mm]."""
        return replace(
            self,
            shaft=replace(self.shaft, diameter=seat_diameter(self.shaft, row), interference=shaft, fit=None),
            housing=replace(self.housing, diameter=seat_diameter(self.housing, row), interference=housing, fit=None),
        )

    def _interferences(self, row: RollerBearing) -> tuple[Range, Range]:
        """Return the interferences of both seats."""
        name = "shaft"
        try:
            on_shaft = seat_interference(self.shaft, row)
            name = "housing"
            return on_shaft, seat_interference(self.housing, row)
        except InputError as error:
            raise error.within(name) from None

    def operating(self, bearing: RollerBearing, speed: float = 0.0, clearance: str = "likely") -> OperatingClearance:
        """Return the operating clearance of a bearing, and its reduction by fits, temperatures and speed.

        Parameters
        ----------
        bearing : RollerBearing
            The bearing, with its unmounted clearance; the axial clearance of a tapered bearing counts as a radial
            clearance of 2 tan(alpha) times its value.
        speed : float
            Speed of inner ring and shaft [1/min]; outer ring and housing are at rest.
        clearance : {"likely", "least", "greatest"}
            Value within the limits of classes, as in `at`.

        Raises
        ------
        InputError
            If the speed is out of range, a seat does not fit the rings, a class does not exist for a size, or the
            expansion of a warm part or the density of a turning part is neither given nor known.
        """
        mounting, row = self.at(bearing, clearance)
        return mounting._solve_operating(row, speed)

    def ranges(self, bearing: RollerBearing, speed: float = 0.0) -> ClearanceRanges:
        """Return the limits of interferences and clearance of a row by their classes.

        Parameters
        ----------
        bearing, speed
            As in `operating`.

        Raises
        ------
        InputError
            As for `operating`.
        """
        least, likely, greatest = (self.operating(bearing, speed, limit) for limit in Range.AT)
        shaft, housing = self._interferences(bearing)
        unmounted = bearing.clearance_range.scaled(_radial(bearing))
        spreads = [(unmounted.spread, unmounted.spread)]
        for ends in (
            [(interference, housing.likely) for interference in shaft.probable],
            [(shaft.likely, interference) for interference in housing.probable],
        ):
            low, high = (self._with(bearing, *end).operating(bearing, speed) for end in ends)
            spreads.append((0.5 * (high.mounted - low.mounted), 0.5 * (high.clearance - low.clearance)))
        mounted, operating = (math.hypot(*halves) for halves in zip(*spreads, strict=True))
        return ClearanceRanges(
            shaft=shaft,
            housing=housing,
            unmounted=unmounted,
            mounted=Range(least.mounted, likely.mounted, greatest.mounted, mounted),
            operating=Range(least.clearance, likely.clearance, greatest.clearance, operating),
        )

    def _solve_operating(self, bearing: RollerBearing, speed: float) -> OperatingClearance:
        """Return the operating clearance from clearance and fits that are numbers."""
        unmounted = bearing.clearance_range.likely * _radial(bearing)
        not_negative("speed", speed, "give that of the inner ring in 1/min")
        of_shaft = _density("shaft.density", self.shaft.density, self.shaft.material, speed)
        of_ring = _density("ring_density", self.ring_density, bearing.inner.material, speed)
        cold = fits_of(bearing, self.shaft, self.housing, (of_shaft, of_ring))
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
        warm = [replace(fit, strains=pair) for fit, pair in zip(cold, strains, strict=True)]
        turning = replace(warm[0], speed=speed * PER_MINUTE)
        rollers = 2.0 * bearing.roller_diameter / bearing.squareness * of_rollers
        mounted, warmed = ([fit.raceway for fit in fits] for fits in (cold, warm))
        return OperatingClearance(
            unmounted=unmounted,
            lost_to_inner_fit=mounted[0],
            lost_to_outer_fit=0.0 - mounted[1],  # not -0.0
            lost_to_temperatures=(warmed[0] - mounted[0]) - (warmed[1] - mounted[1]) + rollers,
            lost_to_speed=turning.raceway - warmed[0],
            inner=turning.describe(cold[0].pressure, warmth["shaft.temperature"] - warmth["inner_temperature"]),
            outer=warm[1].describe(cold[1].pressure, warmth["outer_temperature"] - warmth["housing.temperature"]),
        )

    def expansion(self, bearing: RollerBearing | Paired) -> float:
        """Return the increase of the axial clearance between rows of rollers by temperatures.

        Parameters
        ----------
        bearing : RollerBearing or Paired
            The rows. Spacers between their inner rings have the temperature and the expansion of these; likewise
            between the outer rings.

        Returns
        -------
        float
            Amount to be added to the `clearance` of the pair [mm]: for O expansion times difference of temperatures
            times distance, for X minus that; zero in tandem, where no row locates the other, and for a single row.
        """
        if isinstance(bearing, RollerBearing):
            return 0.0
        if not isinstance(bearing, Paired):
            raise InputError("bearing", bearing, "be a bearing", "make one with nonhertz.bearing")
        up, down = ([row.x for row in bearing.rows if row.bears_axially[way]] for way in (0, 1))
        if not up or not down:
            return 0.0
        apart = math.fsum(down) / len(down) - math.fsum(up) / len(up)
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
        """Return a bearing with its operating clearance; rows of a pair have the same seats, and expand apart if warm.

        Parameters
        ----------
        bearing : RollerBearing or Paired
            The bearing, unmounted.
        speed, clearance
            As in `operating`.
        method : {"strips", "slices"}
            Method by which the clearance for a preload is found, with rows mounted, at 20 degC and at rest.

        Raises
        ------
        InputError
            As for `operating`, or if the operating clearance is out of range.
        """
        one_of("method", method, ("strips", "slices"), "name one of both")
        if isinstance(bearing, Paired):
            if bearing.preload is not None:
                from nonhertz.bearing.verb import adjust_preload

                cold = tuple(self._cold(row, clearance) for row in bearing.bearings)
                between = adjust_preload(replace(bearing, bearings=cold), method).clearance  # type: ignore[union-attr]
                bearing = replace(bearing, clearance=between, preload=None)
            rows = tuple(self._row(row, speed, clearance) for row in bearing.bearings)
            return replace(bearing, bearings=rows, clearance=bearing.clearance + self.expansion(bearing))
        return self._row(bearing, speed, clearance)

    def _cold(self, row: RollerBearing, clearance: str) -> RollerBearing:
        """Return a row mounted, at 20 degC and at rest."""
        return replace(row, clearance=self.operating(row, 0.0, clearance).mounted / _radial(row))  # type: ignore[call-arg]

    def _row(self, row: RollerBearing, speed: float, clearance: str) -> RollerBearing:
        operating = self.operating(row, speed, clearance)
        play = operating.axial(row.nominal_angle) if isinstance(row, TaperedRollerBearing) else operating.clearance
        try:
            return replace(row, clearance=play)  # type: ignore[call-arg]
        except InputError as error:
            name, value, remedy = self._taker(operating, speed)
            raise InputError(name, value, f"leave a clearance: {um(play):.4g} must {error.condition}", remedy) from None

    def _taker(self, loss: OperatingClearance, speed: float) -> tuple[str, Any, str]:
        """Return the input that reduces the clearance most, its value, and the remedy."""
        warmth = self.temperatures
        furthest = max(warmth, key=lambda part: abs(warmth[part] - REFERENCE))
        takers = {
            interference_field(self.shaft): (loss.lost_to_inner_fit, self.shaft.interference or self.shaft.fit, IN_MM),
            interference_field(self.housing): (
                loss.lost_to_outer_fit,
                self.housing.interference or self.housing.fit,
                IN_MM,
            ),
            furthest: (loss.lost_to_temperatures, warmth[furthest], "check temperatures and thermal expansions"),
            "speed": (loss.lost_to_speed, speed, "give that of the inner ring in 1/min"),
        }
        name = max(takers, key=lambda source: abs(takers[source][0]))
        return name, *takers[name][1:]


def _strain(name: str, expansion: float | None, material: Material, temperature: float) -> float:
    """Return the thermal strain of a part."""
    if expansion is None:
        expansion = STEEL_EXPANSION if temperature == REFERENCE else expansion_of(material)
    if expansion is None:
        of = f"a part of {mpa(material.modulus):g} at {format_input(temperature)} degC"
        condition = f"be given for {of}, of which the library has none"
        raise InputError(name, None, condition, "give it in 1/K, 23e-6 for aluminium")
    return expansion * (temperature - REFERENCE)


def _density(name: str, density: float | None, material: Material, speed: float) -> float:
    """Return the density of a turning part [t/mm^3]; 0 where it does not matter."""
    if density is not None:
        return density
    known = density_of(material)
    if known is None and speed > 0.0:
        condition = f"be given for a turning part of {mpa(material.modulus):g}, which is not steel"
        raise InputError(name, None, condition, IN_TONNES)
    return known or 0.0


def clearance_ranges(fit: Mounting | None, bearing: RollerBearing, speed: float = 0.0) -> ClearanceRanges:
    """Return the same as `Mounting.ranges`; without fits, the clearance of the bearing itself."""
    if fit is not None:
        return fit.ranges(bearing, speed)
    unmounted = bearing.clearance_range.scaled(_radial(bearing))
    return ClearanceRanges(shaft=None, housing=None, unmounted=unmounted, mounted=unmounted, operating=unmounted)


def _radial(bearing: RollerBearing) -> float:
    """Return the ratio of a row's radial clearance to the clearance by which it is given."""
    return 2.0 * math.tan(bearing.nominal_angle) if isinstance(bearing, TaperedRollerBearing) else 1.0
