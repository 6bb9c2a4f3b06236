"""Shapes of rings in bearing files: waves, deviations at angles, or a file that holds these; and sums of them."""

from __future__ import annotations

from functools import reduce
from operator import add
from pathlib import Path
from typing import Annotated, Any

from nonhertz.bearing.shapes import Curve, Deviations, RingShape, Waves
from nonhertz.errors import InputError
from nonhertz.files.mistakes import Place
from nonhertz.files.reading import Surroundings, read
from nonhertz.files.ring_shapes import read_ring_shape
from nonhertz.files.writing import document_of
from nonhertz.inputs.checks import text
from nonhertz.inputs.fields import Input, Word, described, one_by_one

MOST_SHAPES = 100
_REMEDY = "write { terms = [{ waves = 2, amplitude = '5 um' }] }, { angle = [..], deviation = [..] } or { file = '..' }"


@described()
class ShapeFile(Input):
    """A ring's shape from a file of two columns, angle and deviation."""

    file: Annotated[str, Word("the file, relative to the bearing file", "put it in quotes", condition=text)]
    angle_unit: Annotated[
        str | None, Word("'deg' or 'rad', if the file does not say", "write 'deg' or 'rad'", condition=text)
    ] = None
    deviation_unit: Annotated[
        str | None, Word("unit of the deviations, if the file does not say", "write 'um' or 'mm'", condition=text)
    ] = None
    curve: Annotated[Curve, Deviations.descriptions["curve"]] = "cubic"

    def shape(self, folder: Path | None) -> RingShape:
        """Return the shape in the file, whose name is relative to a folder; None where no file may be read."""
        if folder is None:
            raise InputError("file", self.file, "not be read here", "write the angles and deviations into the file")
        given = {name: value for name, value in vars(self).items() if name != "file"}
        return read_ring_shape(folder / self.file, **given)


def read_shape(value: Any, file: Surroundings, place: Place) -> RingShape:
    """Return the shape in a table, or the sum of those in a list of tables.

    Raises
    ------
    InputError
        All mistakes, with fields relative to ``value``.
    """
    if not isinstance(value, list):
        return _read_one(value, file, place)
    if not 0 < len(value) <= MOST_SHAPES:
        raise InputError("", value, f"hold 1 to {MOST_SHAPES} shapes", "add up their waves or deviations")
    return reduce(add, one_by_one("", value, lambda number, each: _read_one(each, file, (*place, number))))


def shape_tables(name: str, shape: Any) -> Any:
    """Return the table that `read_shape` reads as this shape, or a list of tables.

    Raises
    ------
    InputError
        If it is a function of another kind.
    """
    tables = [document_of(each) for each in shape.parts] if isinstance(shape, RingShape) else []
    if not tables:
        condition = "be made by fourier_shape or tabulated_shape to go into a bearing file"
        raise InputError(name, shape, condition, "solve such a bearing in Python")
    return tables[0] if len(tables) == 1 else tables


def _read_one(value: Any, file: Surroundings, place: Place) -> RingShape:
    if not isinstance(value, dict):
        raise InputError("", value, "be a table", _REMEDY)
    if "file" in value:
        return _from_file(read(ShapeFile, value, file, place), file.folder)
    if {"angle", "deviation"} & set(value):
        return RingShape.of(read(Deviations, value, file, place))
    if value and "terms" not in value:
        raise InputError("", value, "have terms, or angle and deviation, or a file", _REMEDY)
    return RingShape.of(read(Waves, value, file, place))


def _from_file(table: ShapeFile, folder: Path | None) -> RingShape:
    try:
        return table.shape(folder)
    except InputError as error:
        if error.field in {"path", "file"}:
            raise InputError("file", table.file, error.condition, error.remedy) from None
        inside = "" if error.field in table.descriptions else "file, "
        raise InputError(f"{inside}{error.field}", error.value, error.condition, error.remedy) from None
