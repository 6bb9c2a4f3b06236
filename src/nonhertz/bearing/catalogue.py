"""Estimate of a bearing's internal geometry from catalogue data: boundary dimensions and load ratings.

The unknowns are the number Z of rollers, their diameter D_w and effective length L, and the pitch diameter. ISO 76 and
ISO 281 give

    C_0 = 44 (1 - gamma) Z L D_w cos(alpha)        gamma = D_w cos(alpha) / D_pw
    C   = b_m f_c(gamma) (L cos(alpha))^(7/9) Z^(3/4) D_w^(29/27)

C_0 depends only on geometry and is met exactly: it gives L for every Z and D_w. C then hardly depends on Z, because L Z
is fixed and its powers are nearly equal, and manufacturers rate their steel up to 20 % above the standard. Two ratings
thus do not determine two unknowns. The rest follows from usual proportions (`_USUAL`): the most probable Z and D_w have
the least sum of squares

    ((ln(C / C_ISO) - 0.07) / 0.08)^2 + sum ((x - usual) / scatter)^2

over the fill of the pitch circle Z D_w / (pi D_pw), the fraction of the radial section (D - d) / 2 that rollers fill,
and L over the bearing's width. Usual values and scatters come from a few known bearings (docs/how-to/catalogue.md).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from nonhertz.amounts import format_digits, mm, newton, um
from nonhertz.bearing.bearings import CylindricalRollerBearing, NeedleRollerBearing, RollerBearing, TaperedRollerBearing
from nonhertz.bearing.fits import clearance_limits
from nonhertz.bearing.parts import MOST_ROLLERS
from nonhertz.bearing.ratings import Rating, rating
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, positive
from nonhertz.inputs.descriptions import Count, Quantity, Word
from nonhertz.inputs.fields import validate_call
from nonhertz.life.capacity import Raceway
from nonhertz.model import profile
from nonhertz.model.body import Body, Ring, Roller
from nonhertz.model.diameter import TabulatedDiameter
from nonhertz.result.brief import plain_text


@dataclass(frozen=True)
class _Share:
    usual: float
    scatter: float

    def misses(self, share: float) -> float:
        return ((share - self.usual) / self.scatter) ** 2


@dataclass(frozen=True)
class _Design:
    """Usual proportions of a kind of bearing."""

    pitch: float  # over the mean of bore and outside diameter
    fill: _Share  # of the pitch circle by rollers
    section: _Share  # of the radial section by a roller
    length: _Share  # of the width by the effective length


_USUAL = {
    "cylindrical": _Design(1.01, _Share(0.80, 0.05), _Share(0.55, 0.03), _Share(0.56, 0.05)),
    "needle": _Design(1.0, _Share(0.75, 0.06), _Share(0.42, 0.05), _Share(0.67, 0.06)),
    "tapered": _Design(1.01, _Share(0.91, 0.04), _Share(0.50, 0.03), _Share(0.58, 0.05)),
}
_STEEL = _Share(0.07, 0.08)  # logarithm of a manufacturer's C over that of ISO 281
_STATIC = 44.0  # N/mm^2
LEAST_SECTION, MOST_SECTION = 0.2, 0.8
LEAST_LENGTH, MOST_LENGTH = 0.2, 0.95
FEWEST_ROLLERS, FULLEST = 5, 0.995
MOST_ANGLE = math.radians(45.0)
MOST_FACTOR = 1.5  # largest ratio of C to that of ISO 281, or of that to C
# The diameter is searched in so many steps, in each round over two of the last steps.
_STEPS, _ROUNDS = 40, 4
_LARGEST_BORE = 1000.0  # mm: end of the table of the normal group of ISO 5753-1
_IN_N = "check C and C0 of the catalogue: 44 kN are 44e3 N"
_COUNT = "give the number of rollers, or leave it out"
_ANGLES = "give contact_angle in rad, or e as limiting_ratio, or Y as axial_factor"


@dataclass(frozen=True, repr=False)
class CatalogueGuess:
    """A bearing with rollers estimated from its dimensions and ratings.

    Attributes
    ----------
    bearing : RollerBearing
        The most probable bearing.
    sentences : tuple of str
        The estimates and their basis.
    dynamic, static : float
        C and C_0 of the catalogue [N], for `assess` and `rating`.
    rated : Rating
        Ratings of the estimated bearing by the standards' formulas.
    rollers : tuple of int
        Fewest and most rollers that are about as probable: their sum of squares exceeds the least one by at most 1.
    """

    bearing: RollerBearing
    sentences: tuple[str, ...]
    dynamic: float
    static: float
    rated: Rating
    rollers: tuple[int, int]

    def __repr__(self) -> str:
        return plain_text("CatalogueGuess", list(self.sentences))


def _size(symbol: str, meaning: str) -> Quantity:
    return Quantity("mm", meaning, positive, f"give {symbol} of the catalogue in mm")


def _raceway(symbol: str, ring: str) -> Quantity:
    meaning = f"the {ring} raceway {symbol} of a cylindrical or needle bearing, given in catalogues for rings without"
    remedy = f"give {symbol} of the catalogue in mm, or leave it out"
    return Quantity("mm", f"{meaning} ribs; with both, rollers' diameter and pitch are not estimated", positive, remedy)


@validate_call
def from_catalogue(
    bore: Annotated[float, _size("d", "the bore, d")],
    outside_diameter: Annotated[float, _size("D", "the outside diameter, D")],
    width: Annotated[float, _size("B", "the width B; T for a tapered bearing")],
    dynamic: Annotated[float, Quantity("N", "the basic dynamic load rating C", positive, _IN_N)],
    static: Annotated[float, Quantity("N", "the basic static load rating C_0", positive, _IN_N)],
    *,
    kind: Annotated[
        str,
        Word(
            "kind of bearing: 'cylindrical', 'needle' or 'tapered'",
            "write 'cylindrical', 'needle' or 'tapered'",
            tuple(_USUAL),
        ),
    ] = "cylindrical",
    inner_raceway: Annotated[float | None, _raceway("F", "inner")] = None,
    outer_raceway: Annotated[float | None, _raceway("E", "outer")] = None,
    contact_angle: Annotated[
        float | None, Quantity("rad", "contact angle of tapered bearings", positive, _ANGLES)
    ] = None,
    limiting_ratio: Annotated[
        float | None, Quantity("", "the ratio e = 1.5 tan(alpha), in place of the contact angle", positive, _ANGLES)
    ] = None,
    axial_factor: Annotated[
        float | None, Quantity("", "the factor Y = 0.4 / tan(alpha), in place of the contact angle", positive, _ANGLES)
    ] = None,
    rollers: Annotated[int | None, Count("number of rollers, if known", FEWEST_ROLLERS, MOST_ROLLERS, _COUNT)] = None,
    roller_length: Annotated[
        float | None,
        Quantity("mm", "the rollers' effective length, if known", positive, "give L in mm"),
    ] = None,
    clearance: Annotated[
        float | None,
        Quantity(
            "mm",
            "internal clearance, radial, or axial for a tapered bearing; if left out, the middle of the normal group "
            "of ISO 5753-1 for cylindrical roller bearings, up to a bore of 1000 mm, and 0 for tapered ones, set when "
            "mounted",
            finite,
            "give it in mm: 30 um are 0.03",
        ),
    ] = None,
) -> CatalogueGuess:
    """Estimate the internal geometry of a single-row roller bearing from its dimensions and load ratings.

    Returns
    -------
    CatalogueGuess
        The bearing, with the estimates in words.

    Raises
    ------
    InputError
        If an argument is out of range, or no rollers that fit between the rings give such ratings.

    Notes
    -----
    Rollers have the reference profile of ISO 16281 over their effective length; rings are straight, with their wall
    thickness as depth; all parts are of steel. Rollers and raceways of a tapered bearing have a common apex.

    Examples
    --------
    >>> guess = from_catalogue(30, 62, 16, 44e3, 36.5e3, inner_raceway=37.5, outer_raceway=55.5)
    >>> guess
    CatalogueGuess
      estimated internal geometry of a cylindrical roller bearing 30 x 62 x 16 mm
      13 rollers of 9.000 x 8.792 mm on a pitch circle of 46.50 mm: 37.5 and 55.5 mm at the raceways, which were given
      rollers take 80 % of the pitch circle, 56 % of the section and 55 % of the width
      other numbers are less probable
      C0 of 36.50 kN is met; C of 44.00 kN is 1.15 times that of ISO 281
      clearance 32.5 µm, the middle of the normal group; reference profile of ISO 16281
    >>> guess.bearing.rollers, guess.bearing.pitch
    (13, 46.5)
    """
    if outside_diameter <= bore:
        condition = f"exceed the bore of {mm(bore):g}"
        raise InputError("outside_diameter", outside_diameter, condition, "give D of the catalogue in mm")
    raceways = {"inner_raceway": inner_raceway, "outer_raceway": outer_raceway}
    angles = {"contact_angle": contact_angle, "limiting_ratio": limiting_ratio, "axial_factor": axial_factor}
    angle = _angle(angles) if kind == "tapered" else 0.0
    for name, foreign in (raceways if kind == "tapered" else angles).items():
        if foreign is not None:
            raise InputError(name, foreign, f"be left out for a {kind} bearing", "it has none")
    low = bore
    for name, raceway in raceways.items():
        if raceway is not None:
            if not low < raceway < outside_diameter:
                condition = f"lie between {mm(low, outside_diameter, between=' and '):g}"
                raise InputError(name, raceway, condition, "give F and E of the catalogue in mm, or leave them out")
            low = raceway  # the outer raceway lies outside of the inner one
    sizes = _Sizes(
        float(bore), float(outside_diameter), float(width), float(dynamic), float(static), kind, inner_raceway,
        outer_raceway, angle, rollers, roller_length,
    )  # fmt: skip
    best, numbers = _find_most_probable(sizes)
    slack = _clearance(sizes, clearance)
    bearing = _build_bearing(sizes, best, slack)
    return CatalogueGuess(
        bearing, _sentences(sizes, best, numbers, slack, clearance is None), sizes.dynamic, sizes.static,
        rating(bearing), numbers,
    )  # fmt: skip


@dataclass(frozen=True)
class _Sizes:
    bore: float
    outside: float
    width: float
    dynamic: float
    static: float
    kind: str
    inner_raceway: float | None
    outer_raceway: float | None
    angle: float
    rollers: int | None
    length: float | None

    @property
    def usual(self) -> _Design:
        return _USUAL[self.kind]

    @property
    def section(self) -> float:
        return 0.5 * (self.outside - self.bore)

    def pitch(self, diameter: float) -> float:
        """Return the pitch diameter of rollers of a diameter [mm]."""
        if self.inner_raceway is not None:
            return self.inner_raceway + diameter
        if self.outer_raceway is not None:
            return self.outer_raceway - diameter
        return self.usual.pitch * 0.5 * (self.bore + self.outside)

    @property
    def diameters(self) -> tuple[float, float]:
        """Least and most diameter of a roller [mm]."""
        if self.inner_raceway is not None and self.outer_raceway is not None:
            both = 0.5 * (self.outer_raceway - self.inner_raceway)
            return both, both
        return LEAST_SECTION * self.section, MOST_SECTION * self.section


@dataclass(frozen=True)
class _Inside:
    """Rollers in a bearing, with the length stated or required by C_0."""

    sizes: _Sizes
    rollers: int
    diameter: float

    @property
    def pitch(self) -> float:
        return self.sizes.pitch(self.diameter)

    @property
    def across(self) -> float:
        return self.diameter * math.cos(self.sizes.angle)

    @property
    def length(self) -> float:
        return self.sizes.length or self.sizes.static / self.static_per_length

    @property
    def static_per_length(self) -> float:
        """C_0 of ISO 76 over the rollers' length [N/mm]."""
        return _STATIC * (1.0 - self.across / self.pitch) * self.rollers * self.across

    @property
    def fill(self) -> float:
        return self.rollers * self.diameter / (math.pi * self.pitch)

    @property
    def half(self) -> float:
        """Half of the rollers' cone angle [rad]."""
        return half_cone(self.diameter / self.pitch, self.sizes.angle)

    @property
    def raceways(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Diameter in the middle [mm] and sine of the angle to the axis of the inner and the outer raceway."""
        angle, half = self.sizes.angle, self.half
        if not angle:  # the apex is at infinity
            return (self.pitch - self.diameter, 0.0), (self.pitch + self.diameter, 0.0)
        axis = math.tan(angle - half)
        inner, outer = ((self.pitch * math.tan(of) / axis, math.sin(of)) for of in (angle - 2.0 * half, angle))
        return inner, outer

    @property
    def fits(self) -> bool:
        """Whether rollers fit side by side and between faces and rings."""
        beside = (
            self.pitch > self.diameter and self.rollers * math.asin(self.diameter / self.pitch) <= FULLEST * math.pi
        )
        along = LEAST_LENGTH * self.sizes.width <= self.length <= MOST_LENGTH * self.sizes.width
        return beside and along and self._inside_rings

    @property
    def _inside_rings(self) -> bool:
        """Whether raceways lie between bore and outside diameter over their whole length."""
        (inner, slope), (outer, outer_slope) = self.raceways
        return inner - self.length * slope > self.sizes.bore and outer + self.length * outer_slope < self.sizes.outside

    @property
    def factor(self) -> float:
        """C of the catalogue over that of ISO 281."""
        ring = Raceway(self.diameter, self.length, self.pitch, True, contact_angle=self.sizes.angle)
        return self.sizes.dynamic / ring.load_rating(self.rollers)

    @property
    def misses(self) -> float:
        """The sum of squared deviations from the usual proportions."""
        usual, sizes = self.sizes.usual, self.sizes
        return (
            # Capped beyond the limit of refusal, so that a mistaken C does not change the bearing.
            _STEEL.misses(min(max(math.log(self.factor), -math.log(MOST_FACTOR)), math.log(MOST_FACTOR)))
            + usual.fill.misses(self.fill)
            + usual.section.misses(self.diameter / sizes.section)
            + usual.length.misses(self.length / sizes.width)
        )


def _find_most_probable(sizes: _Sizes) -> tuple[_Inside, tuple[int, int]]:
    """Return the most probable rollers, and the range of numbers of rollers that are about as probable."""
    low, high = sizes.diameters
    least = min(sizes.pitch(low) - low, sizes.pitch(high) - high)
    most = min(MOST_ROLLERS, int(math.pi * (least + high) / low) + 1)
    numbers = range(FEWEST_ROLLERS, most + 1) if sizes.rollers is None else (sizes.rollers,)
    candidates = [_fit_rollers(sizes, number) for number in numbers]
    fitting = [inside for inside in candidates if inside is not None]
    if not fitting:
        rings = f"{mm(sizes.bore, sizes.outside, between=' and '):g}, {mm(sizes.width):g} wide"
        condition = f"be that of rollers which fit between rings of {rings}"
        raise InputError("static", sizes.static, condition, _IN_N)
    best = min(fitting, key=lambda inside: inside.misses)
    if abs(math.log(best.factor)) > math.log(MOST_FACTOR):
        condition = (
            f"be near {newton(sizes.dynamic / best.factor):3}, which ISO 281 gives a bearing with such a static rating"
        )
        raise InputError("dynamic", sizes.dynamic, condition, _IN_N)
    near = [inside.rollers for inside in fitting if inside.misses <= best.misses + 1.0]
    return best, (min(near), max(near))


def _fit_rollers(sizes: _Sizes, rollers: int) -> _Inside | None:
    """Return the most probable geometry for a number of rollers, None if they do not fit."""
    low, high = sizes.diameters
    best: _Inside | None = None
    for _ in range(_ROUNDS):
        tried = [_Inside(sizes, rollers, diameter) for diameter in np.linspace(low, high, _STEPS + 1).tolist()]
        best = min((inside for inside in tried if inside.fits), key=lambda inside: inside.misses, default=best)
        if best is None or low == high:
            return best
        step = (high - low) / _STEPS
        low, high = max(low, best.diameter - step), min(high, best.diameter + step)
    return best


def _build_bearing(sizes: _Sizes, inside: _Inside, clearance: float) -> RollerBearing:
    """Return the bearing; tapered rollers have a common apex with the raceways."""
    diameter, length, pitch = inside.diameter, inside.length, inside.pitch
    known: dict[str, Any] = {"bore": sizes.bore, "outside_diameter": sizes.outside, "width": sizes.width}
    known |= {"rollers": inside.rollers, "clearance": clearance}
    inner, outer = _rings(sizes, *(middle for middle, _ in inside.raceways))
    if sizes.kind != "tapered":
        roller = Roller(diameter=diameter, length=length, profile=profile.iso_logarithmic(diameter, length))
        make = NeedleRollerBearing if sizes.kind == "needle" else CylindricalRollerBearing
        return make(roller=roller, inner=inner, outer=outer, **known)
    ends = diameter + length * math.tan(inside.half) * np.array([1.0, -1.0])
    narrowing = TabulatedDiameter((-0.5 * length, 0.5 * length), tuple(ends.tolist()))
    roller = Roller(diameter=narrowing, length=length, profile=profile.iso_tapered(diameter, length))
    return TaperedRollerBearing(
        roller=roller, inner=inner, outer=outer, pitch_diameter=pitch, contact_angle=sizes.angle, **known
    )


def half_cone(share: float, angle: float) -> float:
    """Return half of the rollers' cone angle [rad], with the tangent D_w / D_pw sin(alpha - half)."""
    half = 0.0
    for _ in range(60):  # each iteration keeps less than D_w / D_pw of the error
        half = math.atan(share * math.sin(angle - half))
    return half


def _rings(sizes: _Sizes, inner: float, outer: float) -> tuple[Body, Body]:
    of_inner = Ring(diameter=inner, depth=0.5 * (inner - sizes.bore))
    return of_inner, Ring(diameter=-outer, depth=0.5 * (sizes.outside - outer))


def _clearance(sizes: _Sizes, clearance: float | None) -> float:
    if clearance is not None:
        return float(clearance)
    if sizes.kind == "tapered":
        return 0.0
    if sizes.bore > _LARGEST_BORE:
        raise InputError("clearance", None, f"be given for a bore of more than {mm(_LARGEST_BORE):g}", "give it in mm")
    return clearance_limits("CN", sizes.bore).likely


def _angle(angles: Mapping[str, float | None]) -> float:
    """Return the contact angle of a tapered bearing [rad] from one of three numbers."""
    stated = {name: value for name, value in angles.items() if value is not None}
    if len(stated) != 1:
        condition = "be given for a tapered bearing" if not stated else f"not be given together with {list(stated)[1]}"
        name = next(iter(stated), "contact_angle")
        raise InputError(name, stated.get(name), condition, _ANGLES)
    ((name, value),) = stated.items()
    by_name = {"limiting_ratio": math.atan(value / 1.5), "axial_factor": math.atan(0.4 / value)}
    angle = by_name.get(name, float(value))
    if angle > MOST_ANGLE:
        raise InputError(name, value, f"mean no more than {MOST_ANGLE:.4g} rad, 45 degrees", _ANGLES)
    return angle


def _sentences(
    sizes: _Sizes, inside: _Inside, rollers: tuple[int, int], clearance: float, usual_clearance: bool
) -> tuple[str, ...]:
    """Return the estimates in words."""
    raceways = [diameter for diameter in (sizes.inner_raceway, sizes.outer_raceway) if diameter is not None]
    of_pitch = (
        " and ".join(f"{diameter:g}" for diameter in raceways) + " mm at the raceways, which were given"
        if raceways
        else f"{sizes.usual.pitch:g} times the mean of bore and outside diameter"
    )
    shares = (inside.fill, inside.diameter / sizes.section, inside.length / sizes.width)
    fill, section, length = (format_digits(100.0 * share, 2) for share in shares)
    share = sizes.static / (inside.static_per_length * inside.length)
    of_static = "met" if sizes.length is None else f"{format_digits(share, 3)} times that of ISO 76"
    why = ", until it is mounted" if sizes.kind == "tapered" else ", the middle of the normal group"
    size = f"{mm(sizes.bore, sizes.outside, sizes.width, between=' x '):g}"
    roller, pitch = f"{mm(inside.diameter, inside.length, between=' x '):4}", f"{mm(inside.pitch):4}"
    sentences = [
        f"estimated internal geometry of a {sizes.kind} roller bearing {size}",
        f"{inside.rollers} rollers of {roller} on a pitch circle of {pitch}: {of_pitch}",
        f"rollers take {fill} % of the pitch circle, {section} % of the section and {length} % of the width",
        _of_number(sizes, rollers),
        f"C0 of {newton(sizes.static):4} is {of_static}; C of {newton(sizes.dynamic):4} is "
        f"{format_digits(inside.factor, 3)} times that of ISO 281",
        f"clearance {um(clearance):3}{why if usual_clearance else ''}; reference profile of ISO 16281",
    ]  # fmt: skip
    return tuple(sentences)


def _of_number(sizes: _Sizes, rollers: tuple[int, int]) -> str:
    low, high = rollers
    if sizes.rollers is not None:
        return "the number of rollers was given"
    return f"{low} to {high} rollers are about as probable" if low < high else "other numbers are less probable"
