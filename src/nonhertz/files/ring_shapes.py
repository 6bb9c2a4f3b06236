"""From a file of two columns, angles and deviations, to the shape of a ring."""

from __future__ import annotations

import os
import re
from pathlib import Path

import numpy as np

from nonhertz.bearing.shapes import Curve, RingShape, tabulated_shape
from nonhertz.errors import InputError
from nonhertz.files.traces import LARGEST_FILE
from nonhertz.files.traces.columns import read_columns
from nonhertz.files.traces.line import Line, Request, in_mm
from nonhertz.files.traces.text import decoded
from nonhertz.inputs.checks import one_of, text
from nonhertz.inputs.files import content, legible

_HEAD = 100  # lines that may state units
_TO_RAD = {"rad": 1.0, "deg": np.pi / 180.0}
_STATED = re.compile(r"(?<![A-Za-z])(?:(rad)(?:ians?)?|(deg)(?:rees?)?)(?![A-Za-z])|(°)", re.IGNORECASE)
_UNIT_OF_ANGLES = "write it above the column, as in 'angle [deg]', or give angle_unit"
_UNIT_OF_DEVIATIONS = "write it above the column, as in 'deviation [um]', or give deviation_unit"


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
        The shape: deviations are positive where there is less room. Instruments that measure roundness write radii, and
        so do for an inner raceway; for an outer one take ``.scaled(-1)``.

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
    if angle_unit is not None:
        one_of("angle_unit", angle_unit, tuple(_TO_RAD), "write 'deg' or 'rad', or leave it out")
    if deviation_unit is not None:
        text("deviation_unit", deviation_unit, "write 'um' or 'mm', or leave it out")
        in_mm("deviation_unit", deviation_unit)
    lines, name = _lines(path)
    # To the reader of traces angles are positions, and pass through it unchanged as mm.
    request = Request(name, position_unit="mm", height_unit=deviation_unit, sense="height")
    line = _columns([_STATED.sub("mm", line) for line in lines[:_HEAD]] + lines[_HEAD:], request)
    if not line.units_known[1]:
        raise request.refuse("state the unit of its deviations", _UNIT_OF_DEVIATIONS)
    known = np.isfinite(line.y) & np.isfinite(line.height)
    angle = line.y[known] * _TO_RAD[angle_unit or _stated(lines, request)]
    try:
        return tabulated_shape(angle, line.height[known], curve)
    except InputError as error:
        if error.field == "curve":
            raise
        found = f"hold one turn of a ring ({error.field} = {error.value} must {error.condition})"
        raise request.refuse(found, error.remedy) from None


def _lines(path: str | os.PathLike[str]) -> tuple[list[str], str]:
    try:
        name = legible(Path(path).name or str(path))
        data = content(path, LARGEST_FILE)
    except (OSError, ValueError, TypeError) as error:  # ValueError: not a valid file name; TypeError: not a name
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        condition = f"be a file that can be read ({reason})"
        raise InputError("path", str(path), condition, "check path and permissions") from None
    if not data.strip():
        raise InputError("file", name, "not be empty", "write angle and deviation per line")
    return decoded(data, name)[0], name


def _columns(lines: list[str], request: Request) -> Line:
    try:
        return read_columns(lines, request)
    except InputError as error:
        if "_column" not in error.remedy:
            raise
        # Columns are not chosen here.
        raise request.refuse("hold two columns, angle and deviation", "delete the others, or swap both") from None


def _stated(lines: list[str], request: Request) -> str:
    """Return the unit of the angles that a file states above its numbers."""
    for line in lines[:_HEAD]:
        found = _STATED.search(line)
        if found is not None:
            return "rad" if found[1] else "deg"
    raise request.refuse("state the unit of its angles", _UNIT_OF_ANGLES)
