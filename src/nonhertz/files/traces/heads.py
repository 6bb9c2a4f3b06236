"""The header above the numbers of a text: names of the columns, their units, and the sense of the heights."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Sequence

from nonhertz.errors import InputError
from nonhertz.files.traces.lengths import millimetres
from nonhertz.files.traces.line import Request

_BRACKETS = re.compile(r"\[([^][]*)\]|\(([^()]*)\)|\{([^{}]*)\}|<([^<>]*)>")
_BETWEEN_WORDS = re.compile(r"[\s_/|:;,=\"'*#]+|\.+(?=\s|$)|(?<=[^\W\d])[.-]+(?=[^\W\d])")
_NUMBER = re.compile(r"[-+]?\d[\d.,]*(?:e[-+]?\d+)?", re.IGNORECASE)
# "Z ?m": the Greek letter was lost on the way to ASCII.
_LOST = re.compile(r"[?\ufffd]m")
_SAYS_UNIT = re.compile(r"units?(?![a-z])|einheit", re.IGNORECASE)
_OF_POSITIONS, _OF_HEIGHTS = re.compile(r"\bx|lateral|pos|length", re.I), re.compile(r"\bz|height|vertical|depth", re.I)
_DROP = re.compile(r"relief|drop", re.IGNORECASE)
# A depth may be positive downwards from the surface, or be the height to which a stylus descended.
_EITHER = re.compile(r"\b(?:depth|wear)", re.IGNORECASE)
_SHOWN, _LISTED, _WORDS_BEHIND_UNIT = 40, 8, 2


def names_of_columns(head: Sequence[str], remarks: Sequence[str], width: int, separator: str | None) -> list[str]:
    """Return the names of the columns, "" for each if there are none.

    They are the last line of the header with as many cells as there are columns, one with units before one without;
    a line of nothing but units is added to the line above it. If the header has no such line, comments above the
    numbers are searched: `numpy.savetxt` writes names that way.
    """
    rows = [cells for line in head if (cells := _cells(line, width, separator)) and not _SAYS_UNIT.search(cells[0])]
    stated = [cells for line in remarks if (cells := _cells(line, width, separator)) and _are_names(cells, line)]
    for k in range(len(rows) - 1, -1, -1):
        if all(millimetres(cell) for cell in rows[k]):
            above = rows[k - 1] if k else [""] * width
            return [f"{name} [{unit.strip('[](){}<> ')}]" for name, unit in zip(above, rows[k], strict=True)]
        if any(map(_stated, rows[k])):
            return rows[k]
    return (stated[-1:] or rows[-1:] or [[""] * width])[0]


def units_of_columns(names: Sequence[str], lines: Iterable[str], request: Request) -> list[str | None]:
    """Return the units of positions and heights, as options or file state them; None where neither does.

    Parameters
    ----------
    names : (str, str)
        Names of the two columns.
    lines : iterable of str
        The other lines above the numbers.

    Raises
    ------
    InputError
        If the file states a unit that is none of length, or one that cannot be assigned to a column.
    """
    found = [request.position_unit or _unit_in(names[0], request), None]
    found[1] = request.height_unit or _unit_in(names[1], request)
    others = [line for line in lines if not all(name and name in line for name in names)]
    declared = _declared([line for line in others if _SAYS_UNIT.search(line)])
    found = [unit or other for unit, other in zip(found, declared, strict=True)]
    stray = next((line for line in others if _stated(line, at_end=True)), None)
    if None in found and not any(declared) and stray is not None:
        what = "positions" if found[0] is None else "heights"
        condition = f"state the unit of its {what} beside the name of their column (there is {shown(stray)})"
        raise request.refuse(condition, "give position_unit and height_unit, such as 'mm' and 'um'")
    return found


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


def cells_of(line: str, separator: str | None) -> list[str]:
    """Return the cells of a line, without quotation marks; None separates by blanks."""
    if line.count('"') % 2:
        line = line.replace('"', " ")  # MiniProf: a mark, which closes nowhere
    elif line.count('"') == 2 and line[0] == line[-1] == '"':
        line = line[1:-1]
    if separator is None:
        return line.replace('"', " ").split()
    if '"' not in line:
        return [cell.strip() for cell in line.split(separator)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]


def _cells(line: str, width: int, separator: str | None) -> list[str]:
    """Return the cells of a line of names, which may be separated differently from the numbers; [] if it is none."""
    splits = [cells_of(line, each) for each in (separator, ";", "\t", ",", "|")]
    for cells in (*splits, re.split(r"\s{2,}", line), _closed_by_units(line)):
        plain = [cell.strip(" \"'") for cell in cells]
        while len(plain) > width and not plain[-1]:
            plain.pop()
        if len(plain) == width:
            return plain
    return []


def _closed_by_units(line: str) -> list[str]:
    """Return the names in "y [mm] z [um]" or "y mm z um", with one blank between all words."""
    names: list[str] = [""]
    for word in re.findall(r"[^\s\[(]+|\[[^][]*\]|\([^()]*\)", line):
        names[-1] = f"{names[-1]} {word}".strip()
        if _stated(names[-1]) not in (None, "in"):  # "all values in um" is no column of inches
            names.append("")
    return names[:-1] if len(names) > 1 and not names[-1] else line.split()


def _are_names(cells: list[str], line: str) -> bool:
    """Return whether a comment is a line of names: words separated by more than blanks, or with units of length."""
    units = [_stated(cell) for cell in cells]
    if any(units) or any(_BRACKETS.search(cell) for cell in cells):
        return all(units)
    return bool(re.search(r"[;\t|,]", line)) and all(re.fullmatch(r"\w+", cell) for cell in cells)


def _stated(name: str, *, at_end: bool = False) -> str | None:
    """Return the unit of length in a name, in brackets or as a word that follows no number; None if there is none."""
    for found in reversed(list(_BRACKETS.finditer(name))):
        unit = next(group for group in found.groups() if group is not None)
        if millimetres(unit) and not (at_end and name[found.end() :].strip(" .,:;")):
            return unit.strip()
    words = [word for word in _BETWEEN_WORDS.split(_BRACKETS.sub(" ", name)) if word]
    for last in range(len(words), 0, -1):
        for count in (2, 1):  # "mu m", "um"
            unit, before = " ".join(words[max(last - count, 0) : last]), words[: max(last - count, 0)]
            if millimetres(unit) and not (before and _NUMBER.fullmatch(before[-1])):
                return unit
        if at_end or last == len(words) - _WORDS_BEHIND_UNIT:
            break
    return None


def _unit_in(name: str, request: Request) -> str | None:
    """Return the unit that a column's name states, None if it states none; refuse one that is not of length."""
    unit = _stated(name)
    if unit is None and (_BRACKETS.search(name) or _LOST.search(name)):
        condition = f"state a unit of length for each column (there is {shown(name)})"
        raise request.refuse(condition, "write mm, um, nm, m or in there, or give position_unit and height_unit")
    return unit


def _declared(lines: Sequence[str]) -> list[str | None]:
    """Return the units of positions and heights in lines such as "Units: mm, um" or "Z unit = um"."""
    found: list[str | None] = [None, None]
    for line in lines:
        axis, tail = _SAYS_UNIT.split(line, maxsplit=1)
        units = [word for word in re.split(r"[\s;,:=|()\[\]{}\"']+", tail) if millimetres(word)][:2]
        if units and not (len(units) == 1 and _OF_HEIGHTS.search(axis)):
            found[0] = found[0] or units[0]
        if units and not (len(units) == 1 and _OF_POSITIONS.search(axis)):
            found[1] = found[1] or units[-1]
    return found
