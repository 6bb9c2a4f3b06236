r"""Profiles in the text records of ISO 5436-2: .smd files, and the .prf of Taylor Hobson's instruments.

Both have a header with a line for each axis, a record of remarks, and a record with one height per line. In .smd
records end with the control character ETX and words with NUL; in .prf records end with the line EOR. The axes are

    CX I 4000 mm 1.0e0 D 1.25e-3    .smd: kind, number of points, unit, factor, data type, step
    CZ A 4000 um 1.0e0 D
    CX M 4.0e+003 MM 1.0e+000 D     .prf: the step follows in the remarks, SPACING CX 1.25e-003
    CZ M 4.0e+003 MM 1.0e-009 L

A height is the number in the line times factor and unit of CZ; positions are steps times factor and unit of CX, from 0.
Sources are two independent programs that write .smd after ISO 5436-2:2012, one of which writes .prf after the example
of the National Physical Laboratory's softgauges, and one that reads .prf of Taylor Hobson. Positions given one by one
(axis kind A or R for CX) are refused, because no source shows how they are written. The checksum at the end of .smd is
not verified: the two programs compute it in different ways.
"""

from __future__ import annotations

import re

import numpy as np

from nonhertz.errors import InputError
from nonhertz.files.traces.line import MOST_POINTS, Line, Request, length_factor
from nonhertz.files.traces.text import lines_of, value_in
from nonhertz.measured.trace import Array

_AXIS = re.compile(r"^(CX|CZ)\s+([A-Z])\s+(\S+)\s+(\S+)\s+(\S+)\s+([A-Z])(?:\s+(\S+))?\s*$", re.MULTILINE)
_SPACING = re.compile(r"^SPACING\s+CX\s+(\S+)", re.MULTILINE)
_END = re.compile(r"^(?:EOR|EOF|\x1a)?\s*$")
_LOOKED_AT = 2000
_AGAIN = "export the profile again"


def is_records(data: bytes) -> bool:
    """Return whether the header of a file has the lines of both axes."""
    head = _plain(data[:_LOOKED_AT])
    return {match[1] for match in _AXIS.finditer(head)} == {"CX", "CZ"}


def read_records(data: bytes, request: Request) -> Line:
    """Return the measured line in a file of records.

    Raises
    ------
    InputError
        If an axis is given in an unknown way, or the number of heights is not that in the header.
    """
    request.refuse_choices("a file after ISO 5436-2")
    text = _plain(data)
    axes = {match[1]: match for match in _AXIS.finditer(text[:_LOOKED_AT])}
    if axes["CX"][2] not in {"I", "M"}:
        condition = f"have evenly spaced points (its axis CX is of kind {axes['CX'][2]})"
        raise request.error(condition, "export the profile as text in two columns")
    step = _step(text, axes["CX"], request) * _factor(axes["CX"], request)
    count = int(_number(axes["CZ"][3], "the number of points", request))
    if not 0 < count <= MOST_POINTS:
        raise request.error(f"hold between 1 and {MOST_POINTS:,} points (its header says {count})", "export fewer")
    heights = _heights(text, count, request) * _factor(axes["CZ"], request)
    y = np.linspace(0.0, step * (count - 1), count)
    return Line(y, heights, ("A profile after ISO 5436-2: positions count from its first point.",))


def _plain(data: bytes) -> str:
    """Return the text with NUL as a blank, ETX as the line EOR and uniform line endings."""
    text = data.decode("latin-1").replace("\x00", " ").replace("\r\n", "\n").replace("\r", "\n")
    return re.sub("\x03\n?", "EOR\n", text)


def _step(text: str, axis: re.Match[str], request: Request) -> float:
    spacing = _SPACING.search(text[: 5 * _LOOKED_AT])
    written = axis[7] or (spacing[1] if spacing else None)
    if written is None:
        raise request.error("state the step of its points (SPACING CX is missing)", _AGAIN)
    step = _number(written, "the step", request)
    if step <= 0.0:
        raise request.error(f"state a positive step (it is {written})", _AGAIN)
    return step


def _factor(axis: re.Match[str], request: Request) -> float:
    """Return the size in mm of one unit of an axis's numbers."""
    try:
        unit = length_factor("unit", axis[4].lower())
    except InputError:
        condition = f"state a unit of length for its axis {axis[1]} (it is {axis[4]!r})"
        raise request.error(condition, "export the profile in mm or um") from None
    factor = _number(axis[5], f"the factor of {axis[1]}", request)
    if factor <= 0.0:
        raise request.error(f"state a positive factor for its axis {axis[1]} (it is {axis[5][:40]})", _AGAIN)
    return unit * factor


def _heights(text: str, count: int, request: Request) -> Array:
    """Return the heights in the third record."""
    lines = lines_of(text, request.name)
    ends = [k for k, line in enumerate(lines) if line.strip() == "EOR"]
    if len(ends) < 2:
        raise request.error("hold three records (header, remarks, heights)", _AGAIN)
    last = ends[2] if len(ends) > 2 else len(lines)
    heights = []
    for number, line in enumerate(lines[ends[1] + 1 : last], start=ends[1] + 2):
        if not _END.match(line):
            heights.append(_height(line.strip(), number, request))
    if len(heights) != count:
        condition = f"hold the {count} heights stated in its header (there are {len(heights)})"
        raise request.error(condition, "export it again; this file is truncated")
    return np.array(heights, dtype=float)


def _height(cell: str, number: int, request: Request) -> float:
    value = value_in(cell)
    if value is None:
        condition = f"hold a height in line {number} (there is {cell[:40]!r})"
        raise request.error(condition, _AGAIN)
    return value


def _number(text: str, what: str, request: Request) -> float:
    value = value_in(text)
    if value is None or not np.isfinite(value):
        raise request.error(f"state {what} as a number (it is {text[:40]!r})", _AGAIN)
    return value
