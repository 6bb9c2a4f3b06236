"""The tables of a bearing file, one class each, and what each key means.

Bodies are those of case files (`nonhertz.io.document`). Each value goes through the bearing's own check, key by key, in
a bearing in which nothing else can be wrong; then the bearing is made of all of them.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import Annotated, Any, ClassVar, Self

from pydantic import (
    Field,
    PlainValidator,
    ValidationInfo,
    ValidatorFunctionWrapHandler,
    WithJsonSchema,
    field_validator,
    model_validator,
)

from nonhertz.bearing.assessed import checked_setting
from nonhertz.bearing.bearings import (
    ARRANGEMENTS,
    MOST_ROLLERS,
    CylindricalRollerBearing,
    CylindricalThrustBearing,
    NeedleRollerBearing,
    Paired,
    RollerBearing,
    SphericalRollerBearing,
    TaperedRollerBearing,
    paired,
)
from nonhertz.bearing.clearance import REFERENCE, Housing, Shaft, operating_clearance
from nonhertz.bearing.frames import RINGS
from nonhertz.bearing.lubrication import CLEANLINESS, LEAST_RATIO, reference_viscosity
from nonhertz.bearing.ribs import DESIGNS, Rib
from nonhertz.bearing.spectrum import LoadCase
from nonhertz.bearing.standard import LAMINAE
from nonhertz.bearing.verb import METHODS, refuse_load
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, one_line, one_of, whole
from nonhertz.inputs.units import in_unit
from nonhertz.io.bounds import FORMAT
from nonhertz.io.document import (
    Angle,
    BodyTable,
    Force,
    Format,
    Kind,
    Length,
    MaterialTable,
    Number,
    ReportTable,
    Table,
    Word,
    combined_radius,
    of_both,
    pair_mistakes,
    quantity,
    read_beside,
    read_loads,
    read_material,
    sampled,
)
from nonhertz.io.fits import mounted
from nonhertz.io.mistakes import Mistake, TableError, missing, unknown
from nonhertz.io.profiles import quantity_schema
from nonhertz.io.shape_tables import ShapeInput, read_shape
from nonhertz.life.lamina import EDGE_STRESS, FEWEST, MOST
from nonhertz.life.spectrum import at_most_whole
from nonhertz.model.body import Body, Plate, Ring, Roller, TabulatedDiameter
from nonhertz.model.material import STEEL, Material

KINDS: dict[str, type[RollerBearing]] = {
    "cylindrical": CylindricalRollerBearing,
    "needle": NeedleRollerBearing,
    "tapered": TaperedRollerBearing,
    "spherical": SphericalRollerBearing,
    "thrust": CylindricalThrustBearing,
}
PARTS = ("roller", "inner", "outer")
_PAIRS = (("radial", "radial_displacement"), ("axial", "axial_displacement"), ("moment", "tilt"))
_HUGE = 1e6  # mm


def _fields(kind: type[RollerBearing]) -> set[str]:
    return {field.name for field in dataclasses.fields(kind)}


@functools.cache
def _stand_ins(kind: type[RollerBearing]) -> dict[str, Any]:
    """Return what makes a bearing so large that no value of a single key contradicts the others."""
    roller = Body(diameter=_HUGE, length=1.0)
    inner, outer = Body(diameter=1.0), Body(diameter=-(2.0 * _HUGE + 1.0))
    made: dict[str, Any] = {"rollers": 1, "pitch_diameter": 1e6 * _HUGE}
    if kind is TaperedRollerBearing:
        cone = TabulatedDiameter((-0.5, 0.5), (_HUGE + 1e-3, _HUGE - 1e-3))
        roller, made["contact_angle"] = Body(diameter=cone, length=1.0), 0.1
    if kind is SphericalRollerBearing:
        made |= {"contact_angle": 0.1, "profile_radius": 1.0, "inner_groove": 2.0, "outer_groove": 2.0}
    if kind is CylindricalThrustBearing:
        inner = outer = Body()
    return {"roller": roller, "inner": inner, "outer": outer} | made


@functools.cache
def _bears_all() -> Paired:
    """Return a bearing to which every load and every displacement can be given."""
    roller = Body(diameter=TabulatedDiameter((-6.0, 6.0), (11.0, 10.0)), length=12.0)
    inner, outer = Body(diameter=41.0), Body(diameter=-62.5)
    row = TaperedRollerBearing(roller=roller, inner=inner, outer=outer, rollers=14, contact_angle=0.2)
    return paired(row, "O", 20.0)


def _as_given(schema: dict[str, Any]) -> tuple[PlainValidator, WithJsonSchema]:
    """Return what leaves a value to checks of its own."""
    return PlainValidator(lambda value: value), WithJsonSchema(schema)


def _vector(unit: str) -> tuple[PlainValidator, WithJsonSchema]:
    """Return what reads a quantity, or a list of two."""

    def read(value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        if not isinstance(value, list):
            return in_unit(name, value, unit)
        if len(value) != 2:
            raise InputError(name, value, "be a number or a list of two", f"write [..., ...], in {unit}")
        return tuple(in_unit(name, each, unit) for each in value)

    one = quantity_schema(unit)
    both = {"type": "array", "items": one, "minItems": 2, "maxItems": 2}
    return PlainValidator(read), WithJsonSchema({"anyOf": [*one["anyOf"], both], "unit": unit})


def _scalar(unit: str) -> tuple[PlainValidator, WithJsonSchema]:
    return quantity(unit), WithJsonSchema(quantity_schema(unit))


Speed = Annotated[float, *_scalar("1/min")]
Viscosity = Annotated[float, *_scalar("mm^2/s")]
Density = Annotated[float, *_scalar("t/mm^3")]
Forces = Annotated[Any, *_vector("N")]
Moments = Annotated[Any, *_vector("N mm")]
Lengths = Annotated[Any, *_vector("mm")]
Angles = Annotated[Any, *_vector("rad")]
Rollers = Annotated[Any, *_as_given({"type": "integer", "minimum": 1, "maximum": MOST_ROLLERS})]
Laminae = Annotated[Any, *_as_given({"type": "integer", "minimum": FEWEST, "maximum": MOST})]


def _read_kind(value: Any) -> type[RollerBearing]:
    if not isinstance(value, str) or value not in KINDS:
        raise unknown("kind", value, "kind of bearing", value, KINDS)
    return KINDS[value]


def word_of(kind: type[RollerBearing]) -> str:
    """Return the word by which a file calls a kind of bearing."""
    return next(word for word, known in KINDS.items() if known is kind)


class RollerTable(BodyTable):
    """The rollers, all alike; y of their profile goes along the bearing's axis."""

    unnamed: ClassVar[type[Body]] = Roller

    kind: Kind = Field(default=None, description="'roller' if left out")

    def _likely_kind(self) -> type[Body]:
        return Roller


class RacewayTable(BodyTable):
    """The inner and the outer ring; the diameters are those of the raceways, that of the outer one negative.

    The washers of a thrust bearing are flat, and have none.
    """

    kind: Kind = Field(default=None, description="'ring' if left out, or 'plate' if there is no diameter")

    def _likely_kind(self) -> type[Body]:
        return Plate if self.diameter is None else Ring


class RibTable(Table):
    """Where ribs touch the rollers' ends; a usual place if left out."""

    end_radius: Length = Field(description="the radius of the spherical ends of the rollers [mm]")
    height: Length = Field(description="the distance of the contact from the roller's axis [mm]")
    crown_radius: Length | None = Field(
        default=None, description="the radius of a crowned flank [mm]; a straight one has none"
    )
    edge: Length | None = Field(
        default=None,
        description="the distance of the flank's free edge from the roller's axis [mm], where contacts lose room",
    )

    @field_validator("end_radius", "height", "crown_radius", "edge")
    @classmethod
    def _check(cls, value: float, info: ValidationInfo) -> float:
        name = str(info.field_name)
        Rib(**{"end_radius": _HUGE, "height": 0.5 * _HUGE if name == "edge" else 0.0, **info.data, name: value})
        return value

    def rib(self) -> Rib:
        """Return the rib."""
        return Rib(self.end_radius, self.height, self.crown_radius, self.edge)


class PairTable(Table):
    """A second row like the first, on the same inner ring or on rings that are clamped together."""

    arrangement: Annotated[Any, *_as_given({"enum": list(ARRANGEMENTS)})] = Field(
        description="'X', face to face; 'O', back to back; or 'tandem', both rows bearing axial loads along +x"
    )
    distance: Length = Field(description="the distance of the middles of both rows' rollers along the axis [mm]")
    clearance: Length = Field(
        default=0.0,
        description="axial clearance of the pair, beside what the rows have themselves [mm]; negative: preload",
    )

    @field_validator("arrangement", "distance", "clearance")
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        given: dict[str, Any] = {"arrangement": "O", "distance": 1.0, str(info.field_name): value}
        paired(_bears_all().bearings[0], **given)
        return value


def _needed(kind: type[RollerBearing]) -> list[str]:
    """Return the keys that a kind of bearing cannot do without, but for those of all kinds."""
    if kind is CylindricalThrustBearing:
        return ["pitch_diameter"]
    without = [field.name for field in dataclasses.fields(kind) if field.default is dataclasses.MISSING]
    return [name for name in without if name not in {*PARTS, "rollers"}]


class BearingTable(Table):
    """The bearing but for its rollers and rings."""

    # A key comes after those that its own check depends on.
    kind: Annotated[Any, PlainValidator(_read_kind), WithJsonSchema({"enum": list(KINDS)})] = Field(
        description="'cylindrical' (NU and N), 'needle', 'tapered', 'spherical' (a row of barrels) or 'thrust' "
        "(cylindrical rollers between flat washers)"
    )
    rollers: Rollers = Field(description="the number of rollers in a row")
    pitch_diameter: Length | None = Field(
        default=None,
        validate_default=True,
        description="the diameter of the circle of the rollers' middles [mm]; the mean of both raceways if left out",
    )
    contact_angle: Angle | None = Field(
        default=None,
        validate_default=True,
        description="the angle between the normal of the outer raceway and the radial plane [rad], of tapered and "
        "spherical bearings",
    )
    profile_radius: Length | None = Field(
        default=None,
        validate_default=True,
        description="the radius of the barrels of a spherical bearing along their axis [mm]",
    )
    inner_groove: Length | None = Field(
        default=None,
        validate_default=True,
        description="the radius of the inner ring's groove along the barrels [mm], larger than theirs",
    )
    outer_groove: Length | None = Field(
        default=None,
        validate_default=True,
        description="the radius of the outer ring's groove along the barrels [mm], larger than theirs",
    )
    clearance: Length | None = Field(
        default=None,
        description="internal clearance of a row [mm], axial for tapered bearings and radial for others; negative: "
        "preload; 0 if left out",
    )
    design: Annotated[Any, *_as_given({"enum": list(DESIGNS)})] = Field(
        default="NU",
        description="which ring of a cylindrical bearing has ribs: 'NU', both of the outer one, or 'N', both of the "
        "inner one, which leave the rings free along the axis; 'NJ' and 'NF', which bear axial loads along +x; 'NUP', "
        "both ways",
    )
    axial_clearance: Length = Field(
        default=0.0,
        description="how far the inner ring of a 'NUP' moves along the axis from ribs to ribs [mm]; half of it to "
        "either side, in other designs too",
    )
    rib: RibTable | None = Field(
        default=None,
        description="where the inner ring's rib touches the rollers of a tapered bearing, or all ribs those of a "
        "cylindrical one",
    )
    inner_shape: Annotated[Any, PlainValidator(read_shape, json_schema_input_type=ShapeInput)] = Field(
        default=None,
        description="how much less room the inner raceway leaves than a circle, over the angle: waves, deviations at "
        "angles, a file, or a list of these, which add",
    )
    outer_shape: Annotated[Any, PlainValidator(read_shape, json_schema_input_type=ShapeInput)] = Field(
        default=None, description="the same of the outer raceway"
    )
    density: Density | None = Field(
        default=None,
        description="density of the rollers [t/mm^3], for what speed does; that of their material if left out",
    )
    pair: PairTable | None = Field(default=None, description="a second row like the first, and how it lies")

    @field_validator(
        "pitch_diameter", "contact_angle", "profile_radius", "inner_groove", "outer_groove", "clearance", "design",
        "axial_clearance", "rib", mode="before",
    )  # fmt: skip
    @classmethod
    def _refuse_foreign(cls, value: Any, info: ValidationInfo) -> Any:
        name, kind = str(info.field_name), info.data.get("kind")
        if value is not None and kind is not None and name not in _fields(kind):
            *others, last = [word for word, other in KINDS.items() if name in _fields(other)]
            words = f"{', '.join(others)} and {last}" if others else last
            condition = f"not be given for a {word_of(kind)} bearing"
            raise InputError(name, value, condition, f"leave it out, it belongs to {words} bearings")
        return value

    @field_validator(
        "rollers", "pitch_diameter", "contact_angle", "profile_radius", "inner_groove", "outer_groove", "clearance",
        "design", "axial_clearance", "density",
    )  # fmt: skip
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        name, kind = str(info.field_name), info.data.get("kind") or CylindricalRollerBearing
        if name not in _fields(kind):
            return value  # of a kind that is not known
        if value is None:
            if name in _needed(kind):
                remedy = f"give {cls.model_fields[name].description}".partition(";")[0]
                raise InputError(name, None, "be given", remedy)
            return value
        given = _stand_ins(kind)
        if name in {"inner_groove", "outer_groove"} and "profile_radius" in info.data:
            given = given | {"profile_radius": info.data["profile_radius"]}
        try:
            kind(**given | {name: value})
        except InputError as error:
            if error.field == name:
                raise
        return value

    def bearing(self, parts: dict[str, Body]) -> RollerBearing | Paired:
        """Return the bearing that is made of rollers and rings."""
        names = self.model_fields_set - {"kind", "pair", "rib"}
        given: dict[str, Any] = {name: getattr(self, name) for name in names}
        if self.rib is not None:
            given["rib"] = self.rib.rib()
        row: RollerBearing = self.kind(**parts, **given)
        if self.pair is None:
            return row
        return paired(row, self.pair.arrangement, self.pair.distance, clearance=self.pair.clearance)


class BearingLoadTable(Table):
    """What loads the inner ring, or moves it; the outer ring is at rest."""

    radial: Forces | None = Field(
        default=None, description="radial force [N] along y, towards the first roller, or a list of two: along y and z"
    )
    radial_displacement: Lengths | None = Field(
        default=None, description="radial displacement [mm] along y, or along y and z, in place of the force"
    )
    axial: Force | None = Field(default=None, description="axial force [N], along x")
    axial_displacement: Length | None = Field(
        default=None, description="axial displacement [mm], in place of the force"
    )
    tilt: Angles | None = Field(
        default=None,
        description="rotation of the inner ring [rad] about z, in the plane of x and y, or a list of two: about y and "
        "z; positive about z moves the ring at high x along +y; without tilt and moment the ring does not tilt",
    )
    moment: Moments | None = Field(
        default=None, description="moment on the inner ring [N mm] about z, or about y and z, in place of the tilt"
    )
    speed: Speed | None = Field(
        default=None, description="speed of the ring that turns [1/min], for centrifugal loads and the life"
    )

    @model_validator(mode="wrap")
    @classmethod
    def _check_pairs(cls, value: Any, read: ValidatorFunctionWrapHandler) -> BearingLoadTable:
        return read_beside(cls, value, read, lambda given: pair_mistakes(given, *_PAIRS))

    @field_validator(*(name for pair in _PAIRS for name in pair), "speed")
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        for each in value if isinstance(value, tuple) else (value,):
            finite(name, each, "write a number, or text with a unit")
        refuse_load(_bears_all(), **{name: value})
        return value

    def prescribed(self) -> dict[str, Any]:
        """Return the keywords for `nonhertz.bearing.solve`."""
        return {name: value for name, value in self if value is not None}


class BearingLoadCaseTable(BearingLoadTable):
    """A load of a spectrum, as in [load]."""

    share: Number = Field(description="share of the revolutions, above 0 and at most 1")

    @field_validator("share")
    @classmethod
    def _check_share(cls, value: float) -> float:
        LoadCase(share=value)
        return value

    def case(self, speed: float | None) -> LoadCase:
        """Return the load, with a speed where it has none."""
        given = {name: value for name, value in self if value is not None}
        return LoadCase(**{"speed": speed or 0.0} | given)


def _read_spectrum(value: Any) -> tuple[BearingLoadCaseTable, ...]:
    cases = read_loads(value, BearingLoadCaseTable)
    remedy = "give shares of the revolutions; for what is left, nothing is loaded"
    at_most_whole("share", [case.share for case in cases], remedy)
    return cases


class SeatTable(Table):
    """What shaft and housing have in common."""

    diameter: Length = Field(description="of the seat [mm]: the bearing's bore d, or its outside diameter D")
    interference: Length = Field(
        default=0.0,
        description="by how much the part that is inside is larger than the one around it, on the diameter, both at 20 "
        "degrees Celsius and unmounted [mm]; negative for a loose fit",
    )
    smoothing: Length = Field(
        default=0.0, description="what pressing flattens of the roughness of both surfaces, on the diameter [mm]"
    )
    material: Annotated[Material, PlainValidator(read_material, json_schema_input_type=Word | MaterialTable)] = Field(
        default=STEEL, description="name of a material, or a table of modulus, poisson and what it bears"
    )
    expansion: Number | None = Field(
        default=None, description="thermal expansion [1/K], a plain number; of steel if left out"
    )
    temperature: Number = Field(default=REFERENCE, description="temperature [degrees Celsius], a plain number")

    made_as: ClassVar[type[Shaft | Housing]]

    @field_validator(
        "diameter", "interference", "smoothing", "expansion", "temperature", "bore", "density", "outside_diameter",
        check_fields=False,
    )  # fmt: skip
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        given = {"diameter": _HUGE} | {name: each for name, each in info.data.items() if name == "diameter"}
        cls.made_as(**given | {str(info.field_name): value})
        return value

    def seat(self) -> Any:
        """Return the seat."""
        return self.made_as(**{name: getattr(self, name) for name in self.model_fields_set})


class ShaftTable(SeatTable):
    """The seat of the inner ring."""

    made_as = Shaft

    bore: Length = Field(default=0.0, description="of a hollow shaft [mm]; 0: solid")
    density: Density | None = Field(
        default=None, description="density of the shaft [t/mm^3]; of its material if left out"
    )


class HousingTable(SeatTable):
    """The seat of the outer ring."""

    made_as = Housing

    outside_diameter: Length | None = Field(
        default=None, description="of the housing as a ring [mm]; endless if left out"
    )


class FitTable(Table):
    """Fits, temperatures and speed, which leave the clearance that the bearing is solved with; speed is the load's."""

    shaft: ShaftTable = Field(description="the seat of the inner ring")
    housing: HousingTable = Field(description="the seat of the outer ring")
    inner_temperature: Number = Field(
        default=REFERENCE, description="temperature of the inner ring [degrees Celsius], a plain number"
    )
    roller_temperature: Number = Field(default=REFERENCE, description="the same of the rollers")
    outer_temperature: Number = Field(default=REFERENCE, description="the same of the outer ring")
    ring_expansion: Number | None = Field(
        default=None, description="thermal expansion of the rings [1/K], a plain number; of steel if left out"
    )
    roller_expansion: Number | None = Field(default=None, description="the same of the rollers")
    ring_density: Density | None = Field(
        default=None, description="density of the inner ring [t/mm^3]; of its material if left out"
    )

    @field_validator(
        "inner_temperature", "roller_temperature", "outer_temperature", "ring_expansion", "roller_expansion",
        "ring_density",
    )  # fmt: skip
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        shaft, housing = Shaft(diameter=20.0), Housing(diameter=100.0)
        row = _bears_all().bearings[0]
        operating_clearance(row, shaft=shaft, housing=housing, **{str(info.field_name): value})
        return value

    def keywords(self) -> dict[str, Any]:
        """Return the keywords for `nonhertz.bearing.operating_clearance`, without the speed."""
        given = {name: getattr(self, name) for name in self.model_fields_set - {"shaft", "housing"}}
        return {"shaft": self.shaft.seat(), "housing": self.housing.seat()} | given


class BearingSolverTable(Table):
    """How it is solved."""

    method: Annotated[Any, *_as_given({"enum": list(METHODS)})] = Field(
        default="strips",
        description="'strips', on the automatic grid, or 'slices', the independent ones of ISO/TS 16281",
    )
    laminae: Laminae = Field(default=LAMINAE, description="number of slices, for the method 'slices'")

    @field_validator("method", "laminae")
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        if info.field_name == "method":
            one_of("method", value, METHODS, "use 'strips', or 'slices' for comparison")
            return value
        return whole("laminae", value, FEWEST, MOST, "give the number of slices, 41 say")


class BearingLifeTable(Table):
    """How long the bearing lasts; its speed is that of the load."""

    viscosity: Viscosity | None = Field(
        default=None, description="viscosity of the oil at its temperature in the bearing [mm^2/s], for a_ISO"
    )
    contamination: Number | None = Field(
        default=None, description="e_C, above 0 and at most 1; if left out, that of the cleanliness"
    )
    cleanliness: Annotated[Any, *_as_given({"enum": list(CLEANLINESS)})] = Field(
        default="high", description="class of cleanliness: 'high', or an ISO 4406 code with circulating oil"
    )
    reliability: Number = Field(default=0.9, description="share of bearings that last longer, from 0.9 to 0.9995")
    edge_stress: Annotated[Any, *_as_given({"enum": list(EDGE_STRESS)})] | None = Field(
        default=None,
        description="edges of the laminae: 'pressure' as solved by strips (if left out), 'standard' or 'none'",
    )
    laminae: Laminae = Field(default=LAMINAE, description="number of laminae")
    turning: Annotated[Any, *_as_given({"enum": list(RINGS)})] = Field(
        default="inner", description="which ring turns: 'inner' or 'outer'; the other is at rest, as the loads are"
    )
    dynamic: Force | None = Field(
        default=None, description="basic dynamic load rating C of a catalogue [N]; that of ISO 281 if left out"
    )
    static: Force | None = Field(
        default=None, description="basic static load rating C0 of a catalogue [N]; that of ISO 76 if left out"
    )

    spectrum: Annotated[
        tuple[BearingLoadCaseTable, ...],
        PlainValidator(_read_spectrum),
        WithJsonSchema({"type": "array", "items": BearingLoadCaseTable.model_json_schema(), "minItems": 1}),
    ] = Field(
        default=(),
        description="loads with their shares of the revolutions, in place of [load], whose speed they have if they "
        "give none; what their shares leave of the revolutions is without load",
    )

    @field_validator(
        "viscosity", "contamination", "cleanliness", "reliability", "edge_stress", "laminae", "turning", "dynamic",
        "static",
    )  # fmt: skip
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        return checked_setting(str(info.field_name), value)

    @model_validator(mode="after")
    def _check_oil(self) -> Self:
        if self.contamination is not None and self.viscosity is None:
            condition, remedy = "be given with a viscosity", "give the viscosity too, or leave it out"
            raise TableError([Mistake(("contamination",), InputError("", self.contamination, condition, remedy))])
        return self

    def keywords(self, speed: float | None) -> dict[str, Any]:
        """Return the keywords for `nonhertz.bearing.assess`."""
        found = {name: value for name, value in self if value is not None and name != "spectrum"}
        return found | ({} if self.viscosity is None else {"speed": speed})


class PartsTable(Table):
    """What a bearing is made of."""

    bearing: BearingTable = Field(description="the bearing but for its rollers and rings")
    roller: RollerTable = Field(description="the rollers")
    inner: RacewayTable = Field(description="the inner ring, or the shaft's washer")
    outer: RacewayTable = Field(description="the outer ring, or the housing's washer")

    @model_validator(mode="after")
    def _check_parts(self) -> Self:
        mistakes = self._missing_diameters()
        if not mistakes:
            try:
                mistakes = _contact_mistakes(self.made())
            except InputError as error:
                mistakes = [part_mistake(error)]
        if mistakes:
            raise TableError(mistakes)
        return self

    def _missing_diameters(self) -> list[Mistake]:
        if self.bearing.kind is CylindricalThrustBearing:
            return []
        return [
            missing((name, "diameter"), f"give that of the raceway in mm{signed}")
            for name, signed in (("inner", ""), ("outer", ", negative, since it is concave"))
            if getattr(self, name).diameter is None
        ]

    def made(self) -> RollerBearing | Paired:
        """Return the bearing."""
        return self.bearing.bearing({name: getattr(self, name).body() for name in PARTS})


def part_mistake(error: InputError) -> Mistake:
    """Return an error about a bearing as a mistake at its key in the file, worded for files."""
    first, *rest = error.field.split(".")
    place = (first, *rest) if first in PARTS else ("bearing", first, *rest)
    value, condition, remedy = error.value, error.condition, error.remedy
    if isinstance(value, TabulatedDiameter):
        value = {"y": list(value.y), "diameter": list(value.diameter)}
    if "TabulatedDiameter" in condition:
        condition = "be a table that is larger at negative y"
        remedy = "write { y = [-5, 5], diameter = [11, 10] }, say: the large ends are at low x"
    elif "Plate" in remedy:
        remedy = "leave out the key"
    return Mistake(place, InputError("", value, condition, remedy), absent=value is None)


def fit_mistake(error: InputError) -> Mistake:
    """Return an error about a fit as a mistake within ``[fit]``."""
    if error.field == "bearing":
        condition = "be left out: fits are those of cylindrical, needle, tapered and spherical bearings"
        return Mistake((), InputError("", None, condition, "remove the table"), absent=True)
    if error.field == "clearance":
        left = f"{1e3 * error.value:.4g} um" if isinstance(error.value, float) else error.value
        condition = f"leave a clearance that can be, but {left} must {error.condition}"
        return Mistake((), InputError("", None, condition, "check interferences and temperatures"), absent=True)
    return Mistake(tuple(error.field.split(".")), error, absent=error.value is None)


def _contact_mistakes(bearing: RollerBearing | Paired) -> list[Mistake]:
    """Return what is wrong with the contacts of the rollers with both rings."""
    ring = "inner"
    try:
        for ring, contact in zip(("inner", "outer"), bearing.rows[0].bearing.contacts, strict=True):  # noqa: B007
            contact.curvature(sampled(contact.interval))
    except InputError as error:
        found = of_both(error)
        return [Mistake(("roller" if found.place[0] == "a" else ring, *found.place[1:]), found.error, found.absent)]
    return []


class BearingFileTable(PartsTable):
    """A bearing file."""

    format: Format = Field(default=FORMAT, description="format of the file; older files that leave it out are read")
    title: str = Field(default="", description="what the bearing is called in tables and figures")
    load: BearingLoadTable = Field(description="what loads the inner ring, or moves it")
    fit: FitTable | None = Field(
        default=None,
        description="fits and temperatures: `clearance` is then that of the bearing before it is mounted, and it is "
        "solved with what is left",
    )
    solver: BearingSolverTable = Field(default_factory=BearingSolverTable, description="how it is solved")
    life: BearingLifeTable = Field(default_factory=BearingLifeTable, description="how long the bearing lasts")
    report: ReportTable = Field(default_factory=ReportTable, description="what the head of a report says")

    @field_validator("title")
    @classmethod
    def _check_title(cls, value: str) -> str:
        one_line("title", value, "write a short name")
        return value

    @field_validator("load")
    @classmethod
    def _check_load(cls, value: BearingLoadTable, info: ValidationInfo) -> BearingLoadTable:
        bearing = _made_of(info.data)
        if bearing is not None:
            try:
                refuse_load(bearing, **value.prescribed())
            except InputError as error:
                raise TableError([Mistake((error.field,), error)]) from None
        return value

    @field_validator("fit")
    @classmethod
    def _check_fit(cls, value: FitTable | None, info: ValidationInfo) -> FitTable | None:
        bearing, load = _made_of(info.data), info.data.get("load")
        if value is not None and bearing is not None and load is not None:
            try:
                mounted(bearing, value.keywords(), load.speed)
            except InputError as error:
                raise TableError([fit_mistake(error)]) from None
        return value

    @field_validator("life")
    @classmethod
    def _check_life(cls, value: BearingLifeTable, info: ValidationInfo) -> BearingLifeTable:
        mistakes = []
        solver, load, bearing = info.data.get("solver"), info.data.get("load"), _made_of(info.data)
        if value.edge_stress == "pressure" and solver is not None and solver.method != "strips":
            error = InputError("", "pressure", "be 'standard' or 'none' for slices", "solve by strips for pressures")
            mistakes.append(Mistake(("edge_stress",), error))
        if bearing is not None:
            mistakes += _spectrum_mistakes(value, bearing)
        if value.viscosity is not None and load is not None:
            speeds = {case.speed or load.speed for case in value.spectrum} or {load.speed}
            oils = (_oil_error(value.viscosity, speed, bearing) for speed in sorted(speeds, key=lambda each: each or 0))
            mistakes += [Mistake(("viscosity",), oil) for oil in oils if oil is not None][:1]
        if mistakes:
            raise TableError(mistakes)
        return value


def _spectrum_mistakes(life: BearingLifeTable, bearing: RollerBearing | Paired) -> list[Mistake]:
    """Return what a bearing refuses of the loads of a spectrum."""
    mistakes = []
    for position, case in enumerate(life.spectrum, start=1):
        try:
            refuse_load(bearing, **{name: each for name, each in case.prescribed().items() if name != "share"})
        except InputError as error:
            mistakes.append(Mistake(("spectrum", position, error.field), error))
    return mistakes


def _oil_error(viscosity: float, speed: float | None, bearing: RollerBearing | Paired | None) -> InputError | None:
    if not speed:
        return InputError("", viscosity, "be given with a speed above zero", "give load.speed too, in 1/min")
    if bearing is None:
        return None
    least = LEAST_RATIO * reference_viscosity(speed, bearing.rows[0].bearing.pitch)
    if viscosity >= least:
        return None
    condition = f"be at least {least:.3g} mm^2/s at this speed, below which ISO 281 has no factor"
    return InputError("", viscosity, condition, "use a thicker oil, or leave it out")


def _made_of(read: dict[str, Any]) -> RollerBearing | Paired | None:
    """Return the bearing of tables that have been read; None if there is none."""
    if not {"bearing", *PARTS} <= set(read):
        return None
    try:
        made: RollerBearing | Paired = read["bearing"].bearing({name: read[name].body() for name in PARTS})
    except InputError:
        return None
    return made


def radius_across(document: dict[str, Any]) -> Any:
    """Return the combined radius of roller and inner raceway [mm], which profiles for a design load may take.

    None where both are cones or barrels: their radii across the contact are not those of the diameters in the file.
    """
    bearing = document.get("bearing")
    kind = bearing.get("kind") if isinstance(bearing, dict) else None
    if kind == "tapered" or kind == "spherical":  # noqa: PLR1714  (a list is in no set)
        return None
    return combined_radius(document.get("roller"), document.get("inner"))
