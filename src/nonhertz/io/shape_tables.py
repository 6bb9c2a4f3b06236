"""Shapes of rings in bearing files: waves, deviations at angles, or a file that holds these; and sums of them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, PlainValidator, ValidationInfo, WithJsonSchema, field_validator

from nonhertz.bearing.shapes import MOST_ORDER, RingShape, fourier_shape, tabulated_shape
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, one_of, whole
from nonhertz.io.document import Angle, AnyTable, Length, Lengths, Table, Word, quantities, read_table
from nonhertz.io.mistakes import InFile, Mistake, TableError
from nonhertz.io.profiles import quantity_schema
from nonhertz.io.ring_shapes import read_ring_shape

MOST_SHAPES = 100
_REMEDY = "write { terms = [{ waves = 2, amplitude = '5 um' }] }, { angle = [..], deviation = [..] } or { file = '..' }"
_CURVE = {"enum": ["cubic", "linear"]}


def _as_given(schema: dict[str, Any]) -> tuple[PlainValidator, WithJsonSchema]:
    return PlainValidator(lambda value: value), WithJsonSchema(schema)


Places = Annotated[
    tuple[float, ...],
    quantities("rad"),
    WithJsonSchema({"type": "array", "items": quantity_schema("rad"), "minItems": 2}),
]


def _read_curve(value: Any) -> Any:
    one_of("curve", value, ("cubic", "linear"), "write 'cubic' or 'linear'")
    return value


CurveWord = Annotated[Any, PlainValidator(_read_curve), WithJsonSchema(_CURVE)]


class WaveTable(Table):
    """One wave around a ring."""

    waves: Annotated[Any, *_as_given({"type": "integer", "minimum": 0, "maximum": MOST_ORDER})] = Field(
        description="number of waves around the ring: 0 is a ring that is too small or too large, 1 one off its "
        "centre, 2 an oval"
    )
    amplitude: Length = Field(description="its amplitude [mm], half of what it is from crest to trough")
    phase: Angle = Field(default=0.0, description="angle of a crest [rad], from y towards z; a crest leaves least room")

    @field_validator("waves", "amplitude", "phase")
    @classmethod
    def _check(cls, value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        if name == "waves":
            return whole(name, value, 0, MOST_ORDER, "give the number of waves around the ring")
        finite(name, value, "write a number, or text with a unit")
        return value


def _read_terms(value: Any) -> dict[int, tuple[float, float]]:
    if not isinstance(value, list) or not value:
        remedy = "write [{ waves = 2, amplitude = '5 um' }]"
        raise InputError("terms", value, "be a list of waves", remedy)
    mistakes: list[Mistake] = []
    found: dict[int, tuple[float, float]] = {}
    for position, each in enumerate(value, start=1):
        try:
            wave = _table_in(WaveTable, each)
        except TableError as error:
            mistakes += (mistake.within((position,)) for mistake in error.mistakes)
            continue
        if wave.waves in found:
            remedy = "give each number of waves one amplitude and phase"
            mistakes.append(Mistake((position, "waves"), InputError("waves", wave.waves, "occur once", remedy)))
        found[wave.waves] = (wave.amplitude, wave.phase)
    if mistakes:
        raise TableError(mistakes)
    return found


def _table_in(table: type[AnyTable], value: Any) -> AnyTable:
    if not isinstance(value, dict):
        raise TableError([Mistake((), InputError("", value, "be a table", _REMEDY))])
    return read_table(table, value)


class WavesTable(Table):
    """A ring's shape as a sum of waves."""

    terms: Annotated[Any, PlainValidator(_read_terms, json_schema_input_type=list[WaveTable])] = Field(
        description="the waves, which add"
    )


class DeviationsTable(Table):
    """A ring's shape from deviations at angles."""

    angle: Places = Field(description="angles from y towards z [rad], within one turn")
    deviation: Lengths = Field(description="how much less room there is at these angles than in a circle [mm]")
    curve: CurveWord = Field(default="cubic", description="what goes through them: 'cubic' or 'linear'")


class ShapeFileTable(Table):
    """A ring's shape from a file of two columns, angle and deviation."""

    file: Word = Field(description="the file, relative to the bearing file")
    angle_unit: Word | None = Field(default=None, description="'deg' or 'rad', if the file does not say")
    deviation_unit: Word | None = Field(default=None, description="unit of the deviations, if the file does not say")
    curve: CurveWord = Field(default="cubic", description="what goes through them: 'cubic' or 'linear'")


def read_shape(value: Any, info: ValidationInfo) -> RingShape:
    """Return the shape in a table, or the sum of those in a list of tables.

    Raises
    ------
    TableError
        All mistakes, with places relative to ``value``.
    """
    folder: Path | None = (info.context or {}).get("folder", Path())
    if not isinstance(value, list):
        return _read_one(value, folder)
    if not 0 < len(value) <= MOST_SHAPES:
        name = str(info.field_name)
        raise InputError(name, value, f"hold 1 to {MOST_SHAPES} shapes", "add up their waves or deviations")
    shapes: list[RingShape] = []
    mistakes: list[Mistake] = []
    for position, each in enumerate(value, start=1):
        try:
            shapes.append(_read_one(each, folder))
        except TableError as error:
            mistakes += (mistake.within((position,)) for mistake in error.mistakes)
    if mistakes:
        raise TableError(mistakes)
    total = shapes[0]
    for shape in shapes[1:]:
        total = total + shape
    return total


def _read_one(value: Any, folder: Path | None) -> RingShape:
    keys = set(value) if isinstance(value, dict) else set()
    if "file" in keys:
        return _from_file(_table_in(ShapeFileTable, value), folder)
    if keys & {"angle", "deviation"}:
        table = _table_in(DeviationsTable, value)
        try:
            return tabulated_shape(table.angle, table.deviation, table.curve)
        except InputError as error:
            raise TableError([Mistake((error.field,), error)]) from None
    if keys and not keys & {"terms"}:
        raise TableError([Mistake((), InputError("", value, "have terms, or angle and deviation, or a file", _REMEDY))])
    return fourier_shape(_table_in(WavesTable, value).terms)


def _from_file(table: ShapeFileTable, folder: Path | None) -> RingShape:
    name = table.file
    if not isinstance(name, str):
        error = InputError("file", name, "be the name of a file", "put it in quotes")
        raise TableError([Mistake(("file",), error)])
    if folder is None:
        error = InputError("file", name, "not be read here", "write the angles and deviations into the file")
        raise TableError([Mistake(("file",), error)])
    given = {key: value for key in ("angle_unit", "deviation_unit") if (value := getattr(table, key)) is not None}
    try:
        return read_ring_shape(folder / name, **given, curve=table.curve)
    except InputError as error:
        if error.field in {"angle_unit", "deviation_unit", "curve"}:
            raise TableError([Mistake((error.field,), error)]) from None
        if error.field in {"path", "file"}:
            here = InputError("file", name, error.condition, error.remedy)
            raise TableError([Mistake(("file",), here)]) from None
        raise TableError([Mistake(("file", InFile(error.field)), error)]) from None


#: The schema of what `read_shape` accepts.
ShapeInput = WavesTable | DeviationsTable | ShapeFileTable | list[WavesTable | DeviationsTable | ShapeFileTable]
