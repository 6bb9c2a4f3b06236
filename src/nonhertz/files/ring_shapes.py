"""Shapes of rings: from a file of two columns, angles and deviations, and from the tables of bearing files.

A table has waves, deviations at angles, or such a file; a list of tables is their sum.
"""

from __future__ import annotations

import os
import re
from functools import reduce
from operator import add
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from nonhertz.bearing.shapes import Curve, Deviations, RingShape, Waves, tabulated_shape
from nonhertz.errors import InputError
from nonhertz.files.mistakes import Place
from nonhertz.files.reading import ReadContext, read_input
from nonhertz.files.traces import LARGEST_FILE
from nonhertz.files.traces.columns import read_columns
from nonhertz.files.traces.line import Line, Request, check_length_unit
from nonhertz.files.traces.text import decode
from nonhertz.files.writing import document_of
from nonhertz.inputs.checks import text
from nonhertz.inputs.descriptions import Word, collect_errors
from nonhertz.inputs.fields import Input, input_class
from nonhertz.inputs.files import read_input_file

_HEAD = 100  # lines that may state units
_TO_RAD = {"rad": 1.0, "deg": np.pi / 180.0}
_STATED = re.compile(r"(?<![A-Za-z])(?:(rad)(?:ians?)?|(deg)(?:rees?)?)(?![A-Za-z])|(°)", re.IGNORECASE)
_UNIT_OF_ANGLES = "write it above the column, as in 'angle [deg]', or give angle_unit"
_UNIT_OF_DEVIATIONS = "write it above the column, as in 'deviation [um]', or give deviation_unit"


MOST_SHAPES = 100
_SHAPES = "write { terms = [{ waves = 2, amplitude = '5 um' }] }, { angle = [..], deviation = [..] } or { file = '..' }"


@input_class()
class ShapeFile(Input):
    """A ring's shape from a file of two columns, angle and deviation."""

    file: Annotated[str, Word("the file, relative to the bearing file", "put it in quotes", condition=text)]
    angle_unit: Annotated[
        str | None, Word("'deg' or 'rad', if the file does not say", "write 'deg' or 'rad'", tuple(_TO_RAD))
    ] = None
    deviation_unit: Annotated[
        str | None,
        Word("unit of the deviations, if the file does not say", "write 'um' or 'mm'", condition=check_length_unit),
    ] = None
    curve: Annotated[Curve, Deviations.descriptions["curve"]] = "cubic"


def read_ring_shape(
    path: str | os.PathLike[str],
    *,
    angle_unit: str | None = None,
    deviation_unit: str | None = None,
    curve: Curve = "cubic",
) -> RingShape:
    r"""Return the shape of a ring in a text file of two columns.

    Parameters
    ----------
    path : str or os.PathLike
        The file: angle and deviation per line, in columns separated by blanks, tabs, commas or semicolons, with decimal
        points or commas, below a line with their names and units.
    angle_unit : {"deg", "rad"} or None
        Unit of the angles; None takes what the file states above its numbers.
    deviation_unit : str or None
        Unit of the deviations, ``"um"`` say; None takes what the file states.
    curve : {"cubic", "linear"}
        As in `nonhertz.bearing.tabulated_shape`.

    Returns
    -------
    RingShape
        The shape; positive deviations reduce the clearance. Radii, as written by instruments for roundness, have this
        sign on an inner raceway; for an outer one use ``.scaled(-1)``.

    Raises
    ------
    InputError
        If the file cannot be read, is larger than 20 MB, states no units, or does not go around a ring once.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = pathlib.Path(folder) / "ring.csv"
    ...     _ = path.write_text("angle [deg]; deviation [um]\n0; 5\n90; -5\n180; 5\n270; -5\n")
    ...     shape = read_ring_shape(path)
    >>> shape([0.0]).round(6).tolist()
    [0.005]
    """
    ShapeFile(str(path), angle_unit, deviation_unit, curve)
    lines, name = _lines(path)
    # The reader of traces takes angles for positions, and leaves them unchanged as mm.
    request = Request(name, position_unit="mm", height_unit=deviation_unit, sense="height")
    line = _columns([_STATED.sub("mm", line) for line in lines[:_HEAD]] + lines[_HEAD:], request)
    if not line.units_known[1]:
        raise request.error("state the unit of its deviations", _UNIT_OF_DEVIATIONS)
    known = np.isfinite(line.y) & np.isfinite(line.height)
    angle = line.y[known] * _TO_RAD[angle_unit or _find_angle_unit(lines, request)]
    try:
        return tabulated_shape(angle, line.height[known], curve)
    except InputError as error:
        condition = f"hold one turn of a ring ({error.field} = {error.value} must {error.condition})"
        raise request.error(condition, error.remedy) from None


def read_shape(value: Any, file: ReadContext, place: Place) -> RingShape:
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
    return reduce(add, collect_errors("", value, lambda number, entry: _read_one(entry, file, (*place, number))))


def shape_tables(name: str, shape: Any) -> Any:
    """Return the table that `read_shape` reads as this shape, or a list of tables.

    Raises
    ------
    InputError
        If it is a function of another kind.
    """
    tables = [document_of(part) for part in shape.parts] if isinstance(shape, RingShape) else []
    if not tables:
        condition = "be made by fourier_shape or tabulated_shape to be written to a bearing file"
        raise InputError(name, shape, condition, "solve such a bearing in Python")
    return tables[0] if len(tables) == 1 else tables


def _read_one(value: Any, file: ReadContext, place: Place) -> RingShape:
    if not isinstance(value, dict):
        raise InputError("", value, "be a table", _SHAPES)
    if "file" in value:
        return _read_file(read_input(ShapeFile, value, file, place), file.folder)
    if {"angle", "deviation"} & set(value):
        return RingShape((read_input(Deviations, value, file, place),))
    if value and "terms" not in value:
        raise InputError("", value, "have terms, or angle and deviation, or a file", _SHAPES)
    return RingShape((read_input(Waves, value, file, place),))


def _read_file(table: ShapeFile, folder: Path | None) -> RingShape:
    if folder is None:
        raise InputError("file", table.file, "not be read here", "write the angles and deviations into the file")
    options = {name: value for name, value in vars(table).items() if name != "file"}
    try:
        return read_ring_shape(folder / table.file, **options)
    except InputError as error:
        if error.field in {"path", "file"}:
            raise error.about("file", table.file) from None
        inside = "" if error.field in table.descriptions else "file, "
        raise error.about(f"{inside}{error.field}", error.value) from None


def _lines(path: str | os.PathLike[str]) -> tuple[list[str], str]:
    data, name = read_input_file("path", path, LARGEST_FILE)
    if not data.strip():
        raise InputError("file", name, "not be empty", "write angle and deviation per line")
    return decode(data, name)[0], name


def _columns(lines: list[str], request: Request) -> Line:
    try:
        return read_columns(lines, request)
    except InputError as error:
        if "_column" not in error.remedy:
            raise
        # Columns are not chosen here.
        raise request.error("hold two columns, angle and deviation", "delete the others, or swap both") from None


def _find_angle_unit(lines: list[str], request: Request) -> str:
    """Return the unit of the angles that a file states above its numbers."""
    for line in lines[:_HEAD]:
        match = _STATED.search(line)
        if match is not None:
            return "rad" if match[1] else "deg"
    raise request.error("state the unit of its angles", _UNIT_OF_ANGLES)
