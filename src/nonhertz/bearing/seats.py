"""The seats of both rings, on the shaft and in the housing."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

from nonhertz.amounts import mm
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.fits import HOUSINGS, SHAFTS, Range, ring_limits, seat_limits
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import finite, is_number, not_negative, number_that, positive
from nonhertz.inputs.descriptions import Quantity, Word
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.material import STEEL
from nonhertz.model.materials import NamedMaterial

REFERENCE = 20.0  # degC, at which dimensions are given
COLDEST, HOTTEST = -273.15, 1000.0  # degC
MOST_EXPANSION = 1e-3  # 1/K
MOST_INTERFERENCE = 0.01  # of the diameter: ten times the elastic strain limit of steel
IN_TONNES = "give it in t/mm^3, 7.85e-9 for steel"
IN_MM = "give it on the diameter in mm: 20 um are 0.02"


IN_OPERATION = "the clearance in operation"

_expansion = number_that(lambda value: abs(value) <= MOST_EXPANSION, f"not exceed {MOST_EXPANSION:g} per kelvin")
_temperature = number_that(lambda value: COLDEST <= value <= HOTTEST, f"lie between {COLDEST:g} and {HOTTEST:g} degC")


def _outside(name: str, value: float, remedy: str) -> None:
    if not is_number(value) or value != math.inf:
        positive(name, value, remedy)


_BORE = "give the bore of a hollow shaft in mm, 0 for a solid one"
_OUTSIDE = "give the outside diameter of the housing in mm, or leave it out for an infinite one"


def of_temperature(part: str, usual: str = "") -> Quantity:
    """Return the description of the temperature of a part."""
    meaning = f"temperature of the {part} in degrees Celsius, a plain number{usual and f'; {usual} if left out'}"
    return Quantity("", meaning, _temperature, "give it in degC")


def of_expansion(part: str) -> Quantity:
    """Return the description of the thermal expansion of a part."""
    meaning = f"thermal expansion of the {part} per kelvin, a plain number; that of its material if left out"
    return Quantity("", meaning, _expansion, "give it in 1/K, 12.5e-6 for bearing steel")


def of_density(part: str) -> Quantity:
    """Return the description of the density of a part."""
    return Quantity("t/mm^3", f"density of the {part}; that of its material if left out", positive, IN_TONNES)


def _of_class(part: str, classes: tuple[str, ...], example: str) -> Word:
    return Word(
        f"tolerance class of the {part} by ISO 286, such as '{example}', which with the class of the bearing gives "
        "limits of the interference",
        f"give a class such as '{example}', or the interference in mm",
        classes,
        noun="tolerance class",
    )


@input_class(kw_only=True)
class Seat(Input):
    """Common fields of shaft and housing."""

    diameter: Annotated[
        float | None,
        Quantity(
            "mm",
            "the diameter of the seat; the bearing's bore d, or its outside diameter D, if left out",
            positive,
            "give the diameter of the seat in mm",
        ),
    ] = None
    fit: Annotated[str | None, _of_class("seat", (*SHAFTS, *HOUSINGS), "k5")] = None
    interference: Annotated[
        float | None,
        Quantity(
            "mm",
            "interference on the diameter: inside part minus outside part, both unmounted at 20 degrees Celsius, in "
            "place of a class; negative for a loose fit",
            finite,
            IN_MM,
        ),
        Assumed("no interference", IN_OPERATION, lambda seat: seat.fit is None),
    ] = None
    smoothing: Annotated[
        float,
        Quantity(
            "mm",
            "loss of interference by asperity flattening of both surfaces, on the diameter",
            not_negative,
            IN_MM,
        ),
    ] = 0.0
    material: Annotated[
        NamedMaterial,
        Assumed("steel of no grade", IN_OPERATION, lambda seat: seat.may_press),
    ] = STEEL
    expansion: Annotated[float | None, of_expansion("part")] = None
    temperature: Annotated[float | None, of_temperature("part", "that of its ring")] = None

    ring: ClassVar[str]

    @cross_check("diameter", "interference")
    def _check_interference(self) -> None:
        diameter, interference = self.diameter or math.inf, self.interference or 0.0
        if abs(interference) > MOST_INTERFERENCE * diameter:
            condition = f"not exceed {100.0 * MOST_INTERFERENCE:g} % of the diameter of {mm(diameter):g}"
            raise InputError("interference", interference, condition, IN_MM)

    @property
    def may_press(self) -> bool:
        """Whether the fit may have a pressure; a measured loose fit has none."""
        return self.effective_interference > 0.0 or (self.interference is None and self.fit is not None)

    @property
    def effective_interference(self) -> float:
        """Interference after asperity flattening, which does not affect a loose fit."""
        interference = self.interference or 0.0
        return max(interference - self.smoothing, min(interference, 0.0))


@input_class(kw_only=True)
class Shaft(Seat):
    """The seat of an inner ring.

    Raises
    ------
    InputError
        If the shaft is impossible.

    Notes
    -----
    For smoothing DIN 7190 has 0.8 (Rz_1 + Rz_2); NSK retains d / (d + 2) of the interference of a ground shaft, d in
    mm; both are recalled.
    """

    ring: ClassVar[str] = "inner"

    fit: Annotated[str | None, _of_class("shaft", SHAFTS, "k5")] = None
    bore: Annotated[
        float, Quantity("mm", "the diameter of the bore of a hollow shaft; 0: solid", not_negative, _BORE)
    ] = 0.0
    density: Annotated[float | None, of_density("shaft")] = None

    @cross_check("diameter", "bore")
    def _check_bore(self) -> None:
        if self.diameter is not None and self.bore >= self.diameter:
            condition = f"be less than the diameter of the shaft of {mm(self.diameter):g}"
            raise InputError("bore", self.bore, condition, _BORE)


@input_class(kw_only=True)
class Housing(Seat):
    """The seat of an outer ring.

    Raises
    ------
    InputError
        If the housing is impossible.
    """

    ring: ClassVar[str] = "outer"

    fit: Annotated[str | None, _of_class("housing", HOUSINGS, "H7")] = None
    outside_diameter: Annotated[
        float,
        Quantity("mm", "the outside diameter of the housing as a ring; infinite if left out", _outside, _OUTSIDE),
        Assumed("endless housing", IN_OPERATION, lambda seat: seat.may_press),
    ] = math.inf

    @cross_check("diameter", "outside_diameter")
    def _check_outside(self) -> None:
        if self.diameter is not None and self.outside_diameter <= self.diameter:
            condition = f"exceed the diameter of the seat, {mm(self.diameter):g}"
            raise InputError("outside_diameter", self.outside_diameter, condition, _OUTSIDE)


def seat_diameter(seat: Shaft | Housing, bearing: RollerBearing) -> float:
    """Return the diameter of a seat [mm]; that of the bearing if none is given."""
    name = "bore" if seat.ring == "inner" else "outside_diameter"
    diameter: float | None = getattr(bearing, name) if seat.diameter is None else seat.diameter
    if diameter is None:
        raise InputError("diameter", None, f"be given where the bearing has no {name}", "give that of the seat in mm")
    return diameter


def interference_field(seat: Shaft | Housing) -> str:
    """Return the field that determines the interference of a seat, such as ``shaft.fit``."""
    name = "shaft" if seat.ring == "inner" else "housing"
    return f"{name}.{'interference' if seat.fit is None or seat.interference is not None else 'fit'}"


def seat_interference(seat: Shaft | Housing, bearing: RollerBearing) -> Range:
    """Return the interference by the class, or the measured one [mm].

    Raises
    ------
    InputError
        If there is no such class for this size, or neither seat nor bearing has a diameter.
    """
    diameter = seat_diameter(seat, bearing)
    if seat.interference is not None or seat.fit is None:
        return Range.exactly(seat.interference or 0.0)
    tapered = bearing.is_tapered
    try:
        limits = seat_limits(seat.fit, diameter)
        ring = ring_limits(seat.ring, diameter, bearing.tolerance_class, tapered=tapered)
    except InputError as error:
        raise error.about("diameter", error.value) from None
    return limits - ring if seat.ring == "inner" else ring - limits
