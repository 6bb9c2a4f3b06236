"""The tables of a case file, one class each, and what each key means.

These classes validate what comes in: pydantic finds unknown, missing and misplaced keys, and each value goes
through the model's own check straight away, key by key, so that one mistake does not hide the next. Keys that
depend on others come after them. The meaning of a key is written here once, for the JSON schema, the messages
and the reference.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, ClassVar, Self, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    ValidationError,
    ValidationInfo,
    ValidatorFunctionWrapHandler,
    WithJsonSchema,
    field_validator,
    model_validator,
)

from nonhertz.bodies.depths import DEPTHS
from nonhertz.bodies.depths.depth import Depth
from nonhertz.bodies.depths.thickness import Thickness
from nonhertz.bodies.images import FEWEST_IMAGES, MOST_IMAGES, SERIES
from nonhertz.bodies.sides import SIDE_FACES
from nonhertz.bodies.sides.side_face import SideFace
from nonhertz.bodies.sides.weighted import Weighted
from nonhertz.errors import InputError
from nonhertz.inputs.checks import MOST, above_zero, finite, one_line, one_of, positive, whole
from nonhertz.inputs.units import begins_with_digits, in_unit
from nonhertz.io.bounds import FORMAT, LOADS, MISTAKES
from nonhertz.io.dimensions import BROKEN, dimensions
from nonhertz.io.mistakes import Mistake, TableError, missing, mistake_in, mistakes_in, nearest, unknown
from nonhertz.io.profiles import profile_schema, quantity_schema, read_profile
from nonhertz.io.title_block import TitleBlock
from nonhertz.model.body import BODIES, Body, Plate, Ring, Roller, TabulatedDiameter, convex
from nonhertz.model.contact import Contact
from nonhertz.model.corner import Chamfer
from nonhertz.model.material import STEEL, Material
from nonhertz.model.materials import MATERIALS
from nonhertz.model.profile import Profile, straight

_FAR_AWAY = 1e3  # mm; how far out an unbounded contact is checked before it is solved

_KINDS: dict[str, type[Body]] = {"roller": Roller, "ring": Ring, "plate": Plate, "body": Body}
# Harmless values in place of rejected keys, so that keys which depend on them are not rejected too.
_STAND_INS: dict[str, Any] = {"diameter": 1.0, "length": MOST, "side_faces": "none", "depth": 1.0}

_FACE_SCHEMA: list[dict[str, Any]] = [
    {"enum": list(SIDE_FACES)},
    {"type": "number", "minimum": 0},
]
_FACES_SCHEMA = {
    "anyOf": [*_FACE_SCHEMA, {"type": "array", "items": {"anyOf": _FACE_SCHEMA}, "minItems": 2, "maxItems": 2}]
}
_IMAGES_SCHEMA = {"anyOf": [{"type": "integer", "minimum": FEWEST_IMAGES, "maximum": MOST_IMAGES}, {"const": SERIES}]}
_DEPTH_SCHEMA = {
    "anyOf": [
        {"enum": list(DEPTHS)},
        {"type": "number", "exclusiveMinimum": 0},
        {"type": "string", "pattern": "[0-9]"},
    ],
    "unit": "mm",
}


def _choices(named: Iterable[SideFace | Depth], number: type[SideFace | Depth]) -> str:
    """Return what each word means, and what a number in its place means."""
    return ", ".join([*(f"{each.word!r} ({each.meaning})" for each in named), f"or {number.meaning}"])


class Table(BaseModel):
    """A table of a case file; unknown keys are mistakes."""

    model_config = ConfigDict(extra="forbid", arbitrary_types_allowed=True)


AnyTable = TypeVar("AnyTable", bound=Table)


def read_table(table: type[AnyTable], value: Any) -> AnyTable:
    """Return the table in a value, or raise `TableError` with all of its mistakes."""
    try:
        return table.model_validate(value)
    except ValidationError as error:
        raise TableError(mistakes_in(error, table)) from None


def quantity(unit: str) -> PlainValidator:
    """Return what reads a number in ``unit`` or text with a unit."""

    def read(value: Any, info: ValidationInfo) -> Any:
        return in_unit(str(info.field_name), value, unit)

    return PlainValidator(read)


def quantities(unit: str) -> PlainValidator:
    """Return what reads a list of these."""

    def read(value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        if not isinstance(value, list):
            raise InputError(name, value, "be a list of numbers", f"write [..., ...], in {unit}")
        values = [in_unit(name, entry, unit) for entry in value]
        for entry in values:
            finite(name, entry, f"give numbers in {unit}")
        return tuple(values)

    return PlainValidator(read)


def _list_schema(unit: str) -> WithJsonSchema:
    return WithJsonSchema({"type": "array", "items": quantity_schema(unit), "minItems": 2})


Number = Annotated[float, quantity(""), WithJsonSchema(quantity_schema(""))]
Length = Annotated[float, quantity("mm"), WithJsonSchema(quantity_schema("mm"))]
Lengths = Annotated[tuple[float, ...], quantities("mm"), _list_schema("mm")]
Stress = Annotated[float, quantity("MPa"), WithJsonSchema(quantity_schema("MPa"))]
Force = Annotated[float, quantity("N"), WithJsonSchema(quantity_schema("N"))]
Angle = Annotated[float, quantity("rad"), WithJsonSchema(quantity_schema("rad"))]
Moment = Annotated[float, quantity("N mm"), WithJsonSchema(quantity_schema("N mm"))]
# Left to the body's own checks.
Word = Annotated[str, PlainValidator(lambda value: value), WithJsonSchema({"type": "string"})]


class MaterialTable(Table):
    """A linear elastic material, and what it bears."""

    modulus: Stress = Field(description="Young's modulus [MPa]")
    poisson: Number = Field(description="Poisson's ratio, in (-1, 0.5]")
    yield_strength: Stress | None = Field(
        default=None, description="yield strength or 0.2 % proof strength, of a hardened case that of the case [MPa]"
    )
    core_yield_strength: Stress | None = Field(
        default=None, description="yield strength of the core below a hardened case [MPa]"
    )
    hardness: Word | None = Field(
        default=None, description="hardness at the surface with its scale, HV, HRC or HBW; shown, not computed with"
    )
    pressure_limit: Stress | None = Field(
        default=None, description="largest pressure of a contact at rest [MPa]; 4000 MPa in roller bearings by ISO 76"
    )

    @field_validator("*")
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        dataclasses.replace(STEEL, **{str(info.field_name): value})
        return value

    def material(self) -> Material:
        """Return the material."""
        return Material(**{name: getattr(self, name) for name in type(self).model_fields})


def read_material(value: Any) -> Material:
    """Return the material that a name or a table stands for."""
    if isinstance(value, dict):
        return read_table(MaterialTable, value).material()
    if not isinstance(value, str):
        remedy = "give a name such as 'steel' or a table { modulus = 207000, poisson = 0.3 }"
        raise InputError("material", value, "be a name or a table", remedy)
    if value not in MATERIALS:
        raise unknown("material", value, "material", value, MATERIALS, "'nonhertz materials' lists them all")
    return MATERIALS[value]


class DiameterTable(Table):
    """A diameter that changes along the axis, linear between points."""

    y: Lengths = Field(description="axial positions from the middle of the body [mm], ascending")
    diameter: Lengths = Field(
        description="diameters there [mm], all of one sign; 0 only in a bore, where there is none"
    )


def _read_diameter(value: Any, info: ValidationInfo) -> Any:
    return _diameter(str(info.field_name), value)


def _diameter(name: str, value: Any) -> Any:
    if not isinstance(value, dict):
        return in_unit(name, value, "mm")
    table = read_table(DiameterTable, value)
    try:
        return TabulatedDiameter(y=table.y, diameter=table.diameter)
    except InputError as error:
        raise TableError([mistake_in(error.field, error, None)]) from None


def _read_profile(value: Any, info: ValidationInfo) -> Profile:
    context = info.context or {}
    # None where no file may be read.
    folder: Path | None = context.get("folder", Path())
    return read_profile(value, dimensions(info.data, context.get("radius")), folder)


def _read_kind(value: Any) -> type[Body]:
    if not isinstance(value, str) or value not in _KINDS:
        raise unknown("kind", value, "kind of body", value, _KINDS)
    return _KINDS[value]


def _word_or_quantity(field: str, value: Any, unit: str) -> Any:
    """Return a word unchanged, for the model to check, and anything else as a number."""
    is_word = isinstance(value, str) and not begins_with_digits(value)
    return value if is_word else in_unit(field, value, unit)


def _read_side_faces(value: Any) -> Any:
    if not isinstance(value, list):
        return _word_or_quantity("side_faces", value, "")
    if len(value) != 2:
        return value
    mistakes, rules = [], []
    for position, entry in enumerate(value, start=1):
        try:
            rules.append(_word_or_quantity("side_faces", entry, ""))
            Body(side_faces=(rules[-1], "none"), length=1.0)
        except InputError as error:
            mistakes.append(Mistake((position,), error))
    if mistakes:
        raise TableError(mistakes)
    return tuple(rules)


def _read_images(value: Any) -> Any:
    number = _word_or_quantity("images", value, "")
    return int(number) if isinstance(number, float) and number.is_integer() else number


def _read_depth(value: Any) -> Any:
    return _word_or_quantity("depth", value, "mm")


class ChamferTable(Table):
    """Chamfers at both ends of a body, each with an arc that blends it into the surface."""

    length: Length = Field(description="length along the axis, the arc included [mm]")
    angle: Angle = Field(description="angle from the axis [rad], below pi / 2")
    blend_radius: Length = Field(
        default=Chamfer.blend_radius,
        description="radius of the arc between surface and chamfer [mm]; 0 for an edge, where pressure has no limit",
    )

    @field_validator("length", "angle", "blend_radius")
    @classmethod
    def _check(cls, value: float, info: ValidationInfo) -> float:
        Chamfer(**{"length": MOST, "angle": 1e-3, **info.data, str(info.field_name): value})
        return value

    def chamfer(self) -> Chamfer:
        """Return the chamfer."""
        return Chamfer(self.length, self.angle, self.blend_radius)


Kind = Annotated[type[Body] | None, PlainValidator(_read_kind), WithJsonSchema({"enum": list(_KINDS)})]


class BodyTable(Table):
    """One of the two bodies."""

    #: Whose checks the keys of a body without a kind must satisfy.
    unnamed: ClassVar[type[Body]] = Body

    # A key comes after those that its own check depends on. The defaults are for the schema only: whatever a file
    # leaves out gets the default of the body's class.
    kind: Kind = Field(
        default=None,
        description="'roller', 'ring' or 'plate': what the diameter must be, and the default of the depth; 'body' for "
        "any; left out, a body with a positive diameter and a length is a roller",
    )
    diameter: Annotated[Any, PlainValidator(_read_diameter, json_schema_input_type=Length | DiameterTable)] = Field(
        default=None,
        validate_default=True,
        description="diameter across the contact [mm], negative where concave, or a table of y and diameter; "
        "a flat body has none",
    )
    side_faces: Annotated[Any, PlainValidator(_read_side_faces), WithJsonSchema(_FACES_SCHEMA)] = Field(
        default=Body.side_faces,
        description=f"how the side faces are made free: {_choices(SIDE_FACES.values(), Weighted)}; or two of these, "
        "for low and high y",
    )
    length: Length | None = Field(
        default=None,
        validate_default=True,
        description="distance between the side faces [mm]; an unbounded body has none",
    )
    effective_length: Length | None = Field(
        default=None,
        description="length in the middle that can touch [mm]; chamfers or undercuts take the rest away",
    )
    corner_radius: Length | None = Field(
        default=None,
        description="radius of the corners between surface and side faces [mm], which the length includes; the profile "
        "ends where they begin",
    )
    chamfer: ChamferTable | None = Field(default=None, description="chamfers in place of a corner radius")
    position: Length = Field(default=Body.position, description="axial position of the middle of the body [mm]")
    material: Annotated[Material, PlainValidator(read_material, json_schema_input_type=Word | MaterialTable)] = Field(
        default=STEEL, description="name of a material, or a table of modulus, poisson and what it bears"
    )
    profile: Annotated[Profile, PlainValidator(_read_profile), WithJsonSchema(profile_schema())] = Field(
        default_factory=straight, description="relief along the axis: a list of profiles, which add"
    )
    depth: Annotated[Any, PlainValidator(_read_depth), WithJsonSchema(_DEPTH_SCHEMA)] = Field(
        default=None,
        description=f"the point that the displacement is measured against: {_choices(DEPTHS.values(), Thickness)}; "
        "left out, a roller with free side faces is 'finite', any other 'plane-strain', and the rest is 'none'",
    )
    bore: Annotated[Any, PlainValidator(_read_diameter, json_schema_input_type=Length | DiameterTable)] = Field(
        default=None,
        description="diameter of the bore of a hollow roller [mm], or a table of y and diameter; a solid one has none",
    )
    images: Annotated[Any, PlainValidator(_read_images), WithJsonSchema(_IMAGES_SCHEMA)] = Field(
        default=Body.images,
        description="mirror images per side face: a number, or 'series' for all of them, which needs a depth",
    )
    case_depth: Length | None = Field(
        default=None,
        description="depth to which the body is case-hardened or surface-hardened [mm]; below it the core's strength "
        "counts",
    )

    @field_validator(
        *(
            "diameter",
            "side_faces",
            "length",
            "effective_length",
            "corner_radius",
            "position",
            "depth",
            "bore",
            "images",
            "case_depth",
        )
    )
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        if name == "bore" and "depth" not in info.data:
            return value  # whose depth is a mistake already
        # Without a valid kind there is no telling what the other keys must satisfy.
        read = info.data if "kind" in info.data else {}
        kind = read.get("kind") or cls.unnamed
        body = {other: read.get(other, stand_in) for other, stand_in in _STAND_INS.items()} | {name: value}
        try:
            kind(**{key: entry for key, entry in body.items() if entry is not None})
        except InputError as error:
            if error.field == name:
                raise
        return value

    @model_validator(mode="after")
    def _check_corner(self) -> Self:
        chamfer = None if self.chamfer is None else self.chamfer.chamfer()
        given = {name: getattr(self, name) for name in ("length", "effective_length", "corner_radius", "profile")}
        try:
            Body(chamfer=chamfer, **given)
        except InputError as error:
            raise TableError([Mistake((error.field,), error)]) from None
        return self

    def body(self) -> Body:
        """Return the body."""
        given = {name: getattr(self, name) for name in self.model_fields_set - {"kind"}}
        if self.chamfer is not None:
            given["chamfer"] = self.chamfer.chamfer()
        return (self.kind or self._likely_kind())(**given)

    def _likely_kind(self) -> type[Body]:
        """Return the class of a body without a kind: a roller if it is convex and has a length, else `Body`."""
        return Roller if self.length is not None and convex(self.diameter) else Body


def reading(document: Any, folder: Path | None) -> dict[str, Any]:
    """Return what the tables of a document need to know while they are read, pydantic's context for them.

    Parameters
    ----------
    document : object
        The whole document, valid or not.
    folder : Path or None
        Directory that the names of files are relative to; None where no file may be read.
    """
    bodies = document.get("body") if isinstance(document, dict) else None
    given = bodies if isinstance(bodies, dict) else {}
    return {"folder": folder, "radius": combined_radius(given.get("a"), given.get("b"))}


def combined_radius(*bodies: Any) -> Any:
    """Return the combined radius across the contact [mm] at the middles of two bodies, None if they have none.

    It is found before the bodies are read one after the other, since the profile of one may depend on both.
    """
    curvature = 0.0
    for body in bodies:
        if not isinstance(body, dict):
            return BROKEN
        try:
            curvature += float(Body(diameter=_diameter("diameter", body.get("diameter"))).curvature(0.0))
        except (InputError, TableError):
            return BROKEN
    return 1.0 / curvature if curvature > 0.0 else None


class BodiesTable(Table):
    """The two bodies."""

    a: BodyTable = Field(description="one body")
    b: BodyTable = Field(description="the other body")

    @model_validator(mode="after")
    def _check(self) -> Self:
        try:
            self.contact.curvature(sampled(self.contact.interval))
        except InputError as error:
            raise TableError([of_both(error)]) from None
        return self

    @cached_property
    def contact(self) -> Contact:
        """The contact of both bodies."""
        return Contact(self.a.body(), self.b.body())


def of_both(error: InputError) -> Mistake:
    """Return an error about both bodies as a mistake in the key of the body that has to change."""
    if error.field != "diameter" or not isinstance(error.value, tuple):
        return Mistake(("a" if error.field == "length" else "b", error.field), error, absent=error.value is None)
    diameters = dict(zip("ab", error.value, strict=True))
    concave = [name for name, diameter in diameters.items() if diameter is not None and not convex(diameter)]
    if not concave:
        return missing(("a", "diameter"), "the bodies are both flat, so give the diameter of one of them in mm")
    name, other = concave[0], "b" if concave[0] == "a" else "a"
    against = f"body.{other}, which is flat" if diameters[other] is None else f"body.{other}.diameter"
    if isinstance(diameters[other], float):
        against += f" = {diameters[other]}"
    condition = f"{error.condition} with {against}"
    return Mistake((name, "diameter"), InputError("diameter", diameters[name], condition, error.remedy))


def sampled(interval: tuple[float, float]) -> NDArray[np.float64]:
    """Return positions at which to check a contact; the solver checks again at its own strips."""
    low, high = (min(max(end, -_FAR_AWAY), _FAR_AWAY) for end in interval)
    return np.linspace(low, high, 1001)


# Worded as in `nonhertz.solve`, which rejects the same values.
_LOAD_CHECKS: dict[str, tuple[Callable[[str, float, str], None], str]] = {
    "load": (above_zero, "give the force in N that presses the bodies together"),
    "approach": (finite, "give the approach in mm"),
    "tilt": (finite, "give the tilt in rad"),
    "moment": (finite, "give the moment in N mm"),
}


class LoadTable(Table):
    """What presses the bodies together: load or approach, and tilt or moment."""

    load: Force | None = Field(default=None, description="load that presses the bodies together [N]")
    approach: Length | None = Field(default=None, description="approach of the bodies [mm], in place of load")
    tilt: Angle | None = Field(
        default=None, description="tilt [rad], positive loads the side of positive y; 0 if left out"
    )
    moment: Moment | None = Field(
        default=None, description="moment of the pressure about y = 0 [N mm], in place of tilt"
    )

    @field_validator("load", "approach", "tilt", "moment")
    @classmethod
    def _check(cls, value: float, info: ValidationInfo) -> float:
        name = str(info.field_name)
        check, remedy = _LOAD_CHECKS[name]
        check(name, value, remedy)
        return value

    @model_validator(mode="wrap")
    @classmethod
    def _check_pairs(cls, value: Any, read: ValidatorFunctionWrapHandler) -> LoadTable:
        return read_beside(cls, value, read, _load_mistakes)

    def prescribed(self) -> dict[str, float]:
        """Return the prescribed quantities."""
        return {name: value for name, value in self if value is not None}


def read_beside(
    table: type[AnyTable],
    value: Any,
    read: ValidatorFunctionWrapHandler,
    find: Callable[[dict[str, Any]], list[Mistake]],
) -> AnyTable:
    """Return the table in a value, or raise `TableError` with its mistakes and others that a function finds."""
    if not isinstance(value, dict):
        refused: AnyTable = read(value)
        return refused
    mistakes = find(value)
    try:
        found: AnyTable = read(value)
    except ValidationError as error:
        mistakes = mistakes_in(error, table) + mistakes
    if mistakes:
        raise TableError(mistakes)
    return found


def pair_mistakes(given: dict[str, Any], *pairs: tuple[str, str]) -> list[Mistake]:
    """Return mistakes of keys that are given although another is."""
    return [
        Mistake((second,), InputError(second, given[second], f"not be given together with {first}", "leave one out"))
        for first, second in pairs
        if first in given and second in given
    ]


def _load_mistakes(given: dict[str, Any]) -> list[Mistake]:
    mistakes = pair_mistakes(given, ("load", "approach"), ("tilt", "moment"))
    # An unknown key that looks like one of them has already been reported.
    meant = {nearest(key, LoadTable.model_fields) for key in given}
    if not meant & {"load", "approach"}:
        mistakes.append(missing(("load",), "give the load in N, or an approach in mm"))
    return mistakes


def _read_element(value: Any) -> str:
    # Imported here: the elements pull in the compiler, which takes a third of a second.
    from nonhertz.strip.element import ELEMENTS

    if not isinstance(value, str) or value not in ELEMENTS:
        raise unknown("element", value, "element", value, ELEMENTS)
    return value


def _read_strips(value: Any) -> int | str:
    if value == "auto":
        return "auto"
    if isinstance(value, int) and not isinstance(value, bool) and 1 <= value <= 2000:
        return value
    raise InputError(
        "strips", value, "be 'auto' or a whole number from 1 to 2000", "leave it out for an automatic grid"
    )


class SolverTable(Table):
    """How it is solved."""

    element: Annotated[str, PlainValidator(_read_element), WithJsonSchema({"enum": ["semi-elliptic", "parabolic"]})] = (
        Field(default="semi-elliptic", description="strip element: 'semi-elliptic' or 'parabolic'")
    )
    strips: Annotated[
        int | str,
        PlainValidator(_read_strips),
        WithJsonSchema({"anyOf": [{"const": "auto"}, {"type": "integer", "minimum": 1, "maximum": 2000}]}),
    ] = Field(default="auto", description="'auto', or a number: that many, equally wide")
    accuracy: Number | None = Field(
        default=None, description="relative error wanted of approach or load on the automatic grid; 1e-4 if left out"
    )

    @field_validator("accuracy")
    @classmethod
    def _check_accuracy(cls, value: float | None, info: ValidationInfo) -> float | None:
        from nonhertz.solver.one import refuse_accuracy

        refuse_accuracy(info.data.get("strips", "auto"), value)
        return value


_SPECTRUM_REMEDY = "write each load under a heading [[life.spectrum]]"


class LoadCaseTable(Table):
    """A load carried for a share of the revolutions."""

    load: Force = Field(description="the load that presses the bodies together [N]")
    share: Number = Field(description="its share of the revolutions, above 0 and at most 1")
    tilt: Angle = Field(default=0.0, description="tilt [rad], positive loads the side of positive y")

    @field_validator("load", "share", "tilt")
    @classmethod
    def _check(cls, value: float, info: ValidationInfo) -> float:
        from nonhertz.life import LoadCase

        LoadCase(**{"load": 1.0, "share": 1.0} | {str(info.field_name): value})
        return value


def read_loads(value: Any, table: type[AnyTable]) -> tuple[AnyTable, ...]:
    """Return the loads of a spectrum, a table each."""
    if not isinstance(value, list) or not value:
        raise InputError("spectrum", value, "be a list of tables", _SPECTRUM_REMEDY)
    if len(value) > LOADS:
        raise InputError("spectrum", value, f"have at most {LOADS} loads", "join loads that hardly differ")
    cases, mistakes = [], []
    for position, entry in enumerate(value, start=1):
        if not isinstance(entry, dict):
            mistakes.append(Mistake((position,), InputError("spectrum", entry, "be a table", _SPECTRUM_REMEDY)))
            continue
        try:
            cases.append(read_table(table, entry))
        except TableError as error:
            mistakes += [mistake.within((position,)) for mistake in error.mistakes]
    if mistakes:
        raise TableError(mistakes)
    return tuple(cases)


def _read_spectrum(value: Any) -> tuple[LoadCaseTable, ...]:
    from nonhertz.life.spectrum import WHOLE

    cases = read_loads(value, LoadCaseTable)
    total = math.fsum(case.share for case in cases)
    if abs(total - 1.0) > WHOLE:
        raise InputError("share", round(total, 6), "add up to 1", "give all loads with their shares of the revolutions")
    return cases


def _read_models(value: Any) -> tuple[str, ...]:
    from nonhertz.life import MODELS

    if not isinstance(value, list) or not value:
        raise InputError("models", value, "be a list of names", f"choose from {', '.join(MODELS)}")
    if len(value) > MISTAKES:
        raise InputError("models", value, f"have at most {MISTAKES} names", f"choose from {', '.join(MODELS)}")
    mistakes = [
        Mistake((position,), unknown("models", name, "fatigue model", name, MODELS))
        for position, name in enumerate(value, start=1)
        if not isinstance(name, str) or name not in MODELS
    ]
    if mistakes:
        raise TableError(mistakes)
    return tuple(dict.fromkeys(value))


def _read_rollers(value: Any) -> int:
    # Worded as in `nonhertz.life.assess`, which rejects the same values.
    remedy = "give the number of rollers in the bearing"
    positive("rollers", value, remedy)
    if value != int(value):
        raise InputError("rollers", value, "be a whole number", remedy)
    return int(value)


Laminae = Annotated[
    Any, PlainValidator(lambda value: value), WithJsonSchema({"type": "integer", "minimum": 30, "maximum": 2000})
]
# The model that checks each key.
_MODEL_WITH = {
    "slope": "lundberg-palmgren",
    "fatigue_limit": "ioannides-harris",
    **dict.fromkeys(("laminae", "edge_stress", "line_loads"), "iso-16281"),
}


class DentTable(Table):
    """A dent in the raceway that is rolled over."""

    depth: Length = Field(description="depth of the bowl [mm]")
    diameter: Length = Field(description="diameter of the bowl [mm]")
    shoulder: Length = Field(default=0.0, description="height of the material pushed up around it [mm]")
    shoulder_diameter: Length | None = Field(
        default=None, description="outer diameter of the shoulder [mm], 1.6 times that of the bowl if left out"
    )
    y: Length = Field(default=0.0, description="where it lies along the contact [mm]")
    body: Annotated[str, PlainValidator(lambda value: value), WithJsonSchema({"enum": list(BODIES)})] = Field(
        default="b", description="the body that has it, 'a' or 'b'"
    )
    dents: Number = Field(default=1, description="how many lie around the raceway at that y")
    per_area: Number | None = Field(default=None, description="in their place, how many lie on a square millimetre")
    raceway_diameter: Length | None = Field(
        default=None, description="diameter of the raceway [mm], that of the body if left out"
    )

    @field_validator("depth", "diameter", "shoulder", "shoulder_diameter", "y")
    @classmethod
    def _check(cls, value: float, info: ValidationInfo) -> float:
        from nonhertz.patch import Dent

        Dent(**{"depth": 1.0, "diameter": 1e-9, **info.data, str(info.field_name): value})
        return value

    @field_validator("body", "dents", "per_area", "raceway_diameter")
    @classmethod
    def _check_raceway(cls, value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        if name == "body":
            one_of(name, value, BODIES, "name the body whose raceway has the dent")
        elif name == "dents":
            return whole(name, value if value % 1.0 else int(value), 1, math.inf, "give the number of dents")
        else:
            positive(name, value, "give a positive number, or leave it out")
        return value


class LifeTable(Table):
    """How long the bodies last."""

    rollers: Annotated[int, PlainValidator(_read_rollers), WithJsonSchema({"type": "integer", "minimum": 1})] | None = (
        Field(default=None, description="number of rollers in the bearing, for absolute lives")
    )
    contact_angle: Angle | None = Field(
        default=None, description="contact angle of the bearing [rad], for absolute lives of tapered rollers"
    )
    models: Annotated[
        tuple[str, ...],
        PlainValidator(_read_models),
        WithJsonSchema({"type": "array", "items": {"type": "string"}, "minItems": 1}),
    ] = Field(default=(), description="names of the fatigue models; all of them if left out")
    slope: Number | None = Field(default=None, description="Weibull's slope e of the volume models, 9/8 if left out")
    fatigue_limit: Stress | None = Field(
        default=None, description="fatigue limit of ioannides-harris [MPa], 360 if left out"
    )
    laminae: Laminae | None = Field(default=None, description="number of laminae of iso-16281, 60 if left out")
    edge_stress: Word | None = Field(
        default=None, description="edges of iso-16281: 'pressure' as solved, 'standard' or 'none'"
    )
    line_loads: Word | None = Field(
        default=None, description="line loads of iso-16281: those of the 'solution' or of the 'standard'"
    )
    spectrum: Annotated[
        tuple[LoadCaseTable, ...],
        PlainValidator(_read_spectrum),
        WithJsonSchema({"type": "array", "items": LoadCaseTable.model_json_schema(), "minItems": 1}),
    ] = Field(default=(), description="loads with their shares of the revolutions, in place of [load]")
    dent: DentTable | None = Field(default=None, description="a dent that is rolled over")

    @field_validator("dent")
    @classmethod
    def _check_dent(cls, value: DentTable | None, info: ValidationInfo) -> DentTable | None:
        if value is not None and info.data.get("spectrum"):
            raise InputError("dent", "with a spectrum", "be under one load", "leave out the spectrum, or the dent")
        return value

    @field_validator("contact_angle")
    @classmethod
    def _check_angle(cls, value: float | None) -> float | None:
        from nonhertz.life import Raceway

        if value is not None:
            Raceway(1.0, 1.0, 9.0, True, contact_angle=value)
        return value

    @field_validator(*_MODEL_WITH)
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        from nonhertz.life import model

        name = str(info.field_name)
        model(_MODEL_WITH[name], **{name: value})
        return value

    def parameters(self) -> dict[str, Any]:
        """Return the model parameters that the file gives."""
        return {name: getattr(self, name) for name in _MODEL_WITH if getattr(self, name) is not None}


def _read_line(value: Any, info: ValidationInfo) -> str:
    TitleBlock(**{str(info.field_name): value})
    return str(value)


Line = Annotated[str, PlainValidator(_read_line), WithJsonSchema({"type": "string"})]


class ReportTable(Table):
    """What the head of a report says beside the title; what is left out is not shown."""

    project: Line = Field(default="", description="project that the report belongs to")
    author: Line = Field(default="", description="who made it")
    date: Line = Field(default="", description="date of the report, in quotation marks; no other date is shown")

    def title_block(self) -> TitleBlock:
        """Return the title block."""
        return TitleBlock(**dict(self))


def _read_format(value: Any) -> int:
    if value != FORMAT or isinstance(value, bool):
        remedy = "use the release of nonhertz that wrote it, or a later one"
        raise InputError("format", value, f"be {FORMAT}, the newest format this release reads", remedy)
    return FORMAT


Format = Annotated[int, PlainValidator(_read_format), WithJsonSchema({"const": FORMAT})]


class CaseTable(Table):
    """A case file."""

    format: Format = Field(default=FORMAT, description="format of the file; older files that leave it out are read")
    title: str = Field(default="", description="what the case is called in tables and figures")
    body: BodiesTable = Field(description="the two bodies")
    load: LoadTable = Field(description="what presses them together")
    solver: SolverTable = Field(default_factory=SolverTable, description="how it is solved")
    life: LifeTable = Field(default_factory=LifeTable, description="how long the bodies last")
    report: ReportTable = Field(default_factory=ReportTable, description="what the head of a report says")

    @field_validator("title")
    @classmethod
    def _check(cls, value: str) -> str:
        one_line("title", value, "write a short name")
        return value
