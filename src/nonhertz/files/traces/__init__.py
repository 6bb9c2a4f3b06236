"""From files of measuring machines to a `nonhertz.measured.Trace`.

The format is recognised from the content, not from the file's extension: text in columns, that of MiniProf and Simpack
included, or of heights alone, one per line, a workbook, a text export of Mahr's MarWin, a profile in the records of ISO
5436-2 (.smd, and the .prf of Taylor Hobson's instruments), or an X3P container.
"""

from __future__ import annotations

import os

from nonhertz.errors import InputError
from nonhertz.files.traces.columns import read_columns
from nonhertz.files.traces.heights import find_heights, read_heights
from nonhertz.files.traces.line import Line, Request, build_trace
from nonhertz.files.traces.mahr import is_marwin, read_marwin
from nonhertz.files.traces.records import is_records, read_records
from nonhertz.files.traces.sheets import is_workbook, lines_of_workbook
from nonhertz.files.traces.text import decode
from nonhertz.files.traces.x3p import is_container, read_container
from nonhertz.inputs.files import read_input_file
from nonhertz.inputs.units import to_unit
from nonhertz.lazy import dir_of
from nonhertz.measured.trace import Trace

__all__ = ["LARGEST_FILE", "read_trace"]
__dir__ = dir_of(__name__)

#: Bytes of the largest file that is read.
LARGEST_FILE = 20_000_000


def read_trace(
    source: str | os.PathLike[str] | bytes,
    name: str | None = None,
    *,
    position_unit: str | None = None,
    height_unit: str | None = None,
    position_column: int | str | None = None,
    height_column: int | str | None = None,
    sense: str | None = None,
    step: float | str | None = None,
) -> Trace:
    r"""Return the trace in a file.

    Parameters
    ----------
    source : str, os.PathLike or bytes
        The file, or its content.
    name : str or None
        Its name in messages; the file's name if None.
    position_unit, height_unit : str or None
        Units of the columns, such as ``"mm"`` or ``"um"``; None takes those that the file states, or mm. They apply to
        columns of text only: the other formats state their own.
    position_column, height_column : int, str or None
        Which columns of a text, by number from 1 or by name; None if there are only two.
    sense : str or None
        ``"height"``, positive where there is material; ``"drop"``, positive where material is removed. None means
        heights, unless the column is called relief or drop; one called depth or wear is ambiguous and is refused.
    step : float, str or None
        Distance between neighbouring points [mm], or text with its unit, if the file has only heights, one per line, or
        numbers of points in place of positions; None takes the distance that the file states.

    Returns
    -------
    Trace
        The measured line in mm, in ascending order; its notes say how it was processed.

    Raises
    ------
    InputError
        If the file cannot be read, is larger than 20 MB, or holds more than 500,000 points (100,000 where X3P writes
        them as text) or a line of more than 5,000 characters; or if it holds anything other than one measured line.
        The message names file, line and reason. Positions without a unit are refused if, taken as mm, they would be
        longer than a metre, heights if they would vary by a tenth of the length of the line or more, or be steeper than
        1 : 2 from point to point.

    Examples
    --------
    >>> text = "y [mm]; z [um]\n0; -3,1\n1; -0,9\n2; 0\n3; -1,1\n4; -2,9\n"
    >>> trace = read_trace(text.encode(), "roller.csv")
    >>> round(trace.height[0].item(), 6), trace.name
    (-0.0031, 'roller.csv')
    """
    data, name = _content(source, name)
    length = to_unit("step", step, "mm")
    request = Request(name, position_unit, height_unit, position_column, height_column, sense, length)
    return build_trace(_line(data, request), request)


def _content(source: str | os.PathLike[str] | bytes, name: str | None) -> tuple[bytes, str]:
    if isinstance(source, bytes):
        return _check_bounds(source, name or "the measured profile"), name or "the measured profile"
    data, own = read_input_file("file", source, LARGEST_FILE)
    return _check_bounds(data, name or own), name or own


def _check_bounds(data: bytes, name: str) -> bytes:
    if len(data) > LARGEST_FILE:
        condition = f"be no larger than {LARGEST_FILE // 1_000_000} MB"
        raise InputError("file", name, condition, "export fewer points; a few thousand are enough")
    if not data.strip():
        raise InputError("file", name, "not be empty", "export the profile again")
    return data


def _line(data: bytes, request: Request) -> Line:
    if is_workbook(data):
        lines, notes = lines_of_workbook(data, request)
        return _read_text(lines, request).noted(*notes)
    if is_container(data):
        return read_container(data, request)
    if is_records(data):
        return read_records(data, request)
    lines, notes = decode(data, request.name)
    if is_marwin(lines):
        return read_marwin(lines, request).noted(*notes)
    return _read_text(lines, request).noted(*notes)


def _read_text(lines: list[str], request: Request) -> Line:
    heights = find_heights(lines, request)
    return read_columns(lines, request) if heights is None else read_heights(heights, request)
