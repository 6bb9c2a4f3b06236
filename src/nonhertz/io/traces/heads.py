"""The header above the numbers of a text: names of the columns, their units, and the sense of the heights."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from nonhertz.errors import InputError
from nonhertz.io.traces.line import Request, in_mm

# "y [mm]", "z (um)", "height / nm", "y_mm", "z in um"
_UNIT = re.compile(r"\[\s*([^\W\d_]+)\s*\]|\(\s*([^\W\d_]+)\s*\)|(?:/|_|\bin)\s*([^\W\d_]+)\s*$")
_BARE_UNIT = re.compile(r"\[?\s*(mm|um|µm|μm|nm|cm|m|in|inch)\s*\]?")
_DROP = re.compile(r"relief|drop", re.IGNORECASE)
# A depth may be positive downwards from the surface, or be the height to which a stylus descended.
_EITHER = re.compile(r"\b(?:depth|wear)", re.IGNORECASE)
_SHOWN, _LISTED = 40, 8


def names_of_columns(
    head: Sequence[str], remarks: Sequence[str], width: int, split: Callable[[str], list[str]]
) -> list[str]:
    """Return the names of the columns, "" for each if there are none.

    They are the last line of the header with as many cells as there are columns; units below them are added. If the
    header has no such line, comments above the numbers are searched: `numpy.savetxt` writes names that way.
    """
    rows = [cells for line in head if len(cells := _cells(line, width, split)) == width]
    if not rows:
        stated = [cells for line in remarks if _are_names(cells := _cells(line, width, split), line, width)]
        return stated[-1] if stated else [""] * width
    if len(rows) > 1 and all(_BARE_UNIT.fullmatch(cell) for cell in rows[-1]):
        return [f"{name} [{unit.strip('[] ')}]" for name, unit in zip(rows[-2], rows[-1], strict=True)]
    return rows[-1]


def unit_in(name: str, request: Request) -> str | None:
    """Return the unit that a column's name states, None if it states none.

    Raises
    ------
    InputError
        If it states a unit of something other than length.
    """
    found = _UNIT.search(name)
    if found is None:
        return None
    unit = next(group for group in found.groups() if group)
    if _is_length(unit):
        return unit
    if found.group(3):  # "y_axis": a word after an underscore is not a unit
        return None
    condition = f"state a unit of length for each column (there is {shown(name)})"
    raise request.refuse(condition, "write mm, um, nm, m or in in the line of names")


def counts_drop(name: str, request: Request) -> bool:
    """Return whether the name of a column of heights says that it is positive where material is removed.

    Raises
    ------
    InputError
        If the name is ambiguous and no sense is given.
    """
    if request.sense is None and _EITHER.search(name) and not _DROP.search(name):
        condition = f"say which way its column {shown(name)} is positive"
        raise request.refuse(condition, "give sense = 'drop' where it is positive below the surface, or 'height'")
    return bool(_DROP.search(name))


def column_called(field: str, requested: object, names: list[str]) -> int:
    """Return the index of a column requested by number, from 1, or by name.

    Raises
    ------
    InputError
        If there is no such column.
    """
    text = str(requested).strip()
    if isinstance(requested, int) or re.fullmatch(r"[0-9]+", text):
        # Checked as text: Python refuses to convert a number of five thousand digits.
        digits = text.lstrip("0")
        if not digits.isdecimal() or len(digits) > 6 or int(digits) > len(names):
            condition = f"be a column from 1 to {len(names)}"
            raise InputError(field, requested, condition, "give its number, from 1, or its name")
        return int(digits) - 1
    plain = [re.split(r"\s*[\[(/]", name)[0].strip().lower() for name in names]
    lowered = [name.lower() for name in names]
    for candidates in (lowered, plain):
        if candidates.count(text.lower()) == 1:
            return candidates.index(text.lower())
    known = listed([name for name in names if name]) or "none: the file has no line of names"
    raise InputError(field, requested, f"be the name of a column ({known})", "give its number, from 1")


def listed(names: Sequence[str]) -> str:
    """Return the first few of some names as text."""
    return ", ".join(map(shown, names[:_LISTED])) + (", ..." if len(names) > _LISTED else "")


def shown(text: str) -> str:
    """Return text from a file in quotes, shortened if it is long."""
    return repr(text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "...")


def _cells(line: str, width: int, split: Callable[[str], list[str]]) -> list[str]:
    """Return the cells of a line of names, which may be separated differently from the numbers."""
    for parts in (split(line), re.split(r"\s*[;\t|,]\s*", line), re.split(r"\s{2,}", line)):
        cells = [cell.strip(" \"'") for cell in parts]
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if len(cells) == width:
            return cells
    # "y [mm] z [um]", one blank between all words
    joined = re.findall(r"[^\s\[(]+\s*(?:\[[^][]*\]|\([^()]*\))?", line)
    return [cell.strip() for cell in joined]


def _are_names(cells: list[str], line: str, width: int) -> bool:
    """Return whether a comment is a line of names: words separated by more than blanks, or with units of length."""
    if len(cells) != width:
        return False
    units = [next(group for group in found.groups() if group) for cell in cells if (found := _UNIT.search(cell))]
    if units:
        return all(map(_is_length, units))
    return bool(re.search(r"[;\t|,]", line)) and all(re.fullmatch(r"\w+", cell) for cell in cells)


def _is_length(unit: str) -> bool:
    try:
        in_mm("unit", unit)
    except InputError:
        return False
    return True
