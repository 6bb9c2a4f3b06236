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
_BETWEEN_UNITS = re.compile(r"[\s;,:=|()\[\]{}\"']+")
# The letter of an axis: "Y_Unit", "Delta_X", "X0", "z-axis" and "xUnit", but none of "xyz" or "mix".
_AXIS = re.compile(r"(?<![^\W_])[xyz](?![^\W\d_])|\b[xyz](?=unit|axis|scale)", re.IGNORECASE)
_OF_POSITIONS = re.compile(r"lateral|horizontal|\bpos|length|distance|abscissa", re.IGNORECASE)
_OF_HEIGHTS = re.compile(r"height|vertical|depth|profile|deviation|h(?:ö|oe)he|ordinate", re.IGNORECASE)
# Words of the setting that is the distance between neighbouring points, and words that make it another one.
_STEP = re.compile(
    r"spacing|step(?!s)|increment|interval|pitch|pixel|(?<![a-z])d\W?x(?![a-z])|delta\W?x|x\W?scale|(?:x|lateral)\W?resolution"
    r"|distance (?:between|of)|abstand|schritt",
    re.IGNORECASE,
)
_NO_STEP = re.compile(
    r"(?<![a-z])[yz](?![a-z])|\b[yz](?=scale|step|spacing|res)|time|zeit|height|h(?:ö|oe)he|vertical|depth|tip|force"
    r"|profile|line|mean|peak",
    re.IGNORECASE,
)
_SETTING = re.compile(
    r"([^\W\d][^=:;\t\d]*)[=:;\t ]*([-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[-+]?\d+)?)\s*([^\W\d]+(?![\w/]))?",
    re.IGNORECASE,
)
_DROP = re.compile(r"relief|drop", re.IGNORECASE)
# A depth may be positive downwards from the surface, or be the height to which a stylus descended.
_EITHER = re.compile(r"\b(?:depth|wear)", re.IGNORECASE)
_SHOWN, _LISTED, _WORDS_BEHIND_UNIT, _WORDS_OF_AXIS = 40, 8, 2, 6


def names_of_columns(
    head: Sequence[str], remarks: Sequence[str], needed: Sequence[int], width: int, separator: str | None
) -> list[str]:
    """Return the names of the columns, "" for each if there are none.

    They are the line of the header that states most units of length for the columns of numbers, names most axes and
    stands lowest, in this order; a line of nothing but units is added to the line above it. It may hold more cells than
    the lines of numbers, whose last columns may be empty or text. If the header has no such line, comments above the
    numbers are searched: `numpy.savetxt` writes names that way.

    Parameters
    ----------
    head, remarks : sequence of str
        Lines above the numbers, and comments there.
    needed : sequence of int
        The columns of numbers.
    width : int
        Number of columns, with those of text.
    separator : str or None
        What separates the numbers.
    """
    rows = [(k, cells) for k, line in enumerate(head) if (cells := _names_in(line, needed, width, separator))]

    def rank(row: tuple[int, list[str]]) -> tuple[int, int, int]:
        return _units(row[1], needed), sum(map(_names_axis, row[1])), row[0]

    place, names = max(rows, key=rank, default=(0, [""] * width))
    if not _units(names, needed):
        stated = [
            cells for line in remarks if (cells := _cells(line, needed, width, separator)) and _are_names(cells, line)
        ]
        return stated[-1] if stated else names
    if not all(millimetres(names[k]) for k in needed):
        return names
    above = dict(rows).get(place - 1, [""] * width)
    return [f"{name} [{unit.strip('[](){}<> ')}]" for name, unit in zip(above, names, strict=True)]


def units_of_columns(names: Sequence[str], lines: Iterable[str], request: Request) -> list[str | None]:
    """Return the units of positions and heights, as options or file state them; None where neither does.

    A line of its own states the unit of the axis that it names, or of both with two units.

    Parameters
    ----------
    names : (str, str)
        Names of the two columns; the first is "" where the file holds heights alone.
    lines : iterable of str
        The other lines above the numbers.

    Raises
    ------
    InputError
        If the file states a unit that is none of length, or one that cannot be assigned to a column.
    """
    units = [request.position_unit or _unit_in(names[0], request), None]
    units[1] = request.height_unit or _unit_in(names[1], request)
    lines = list(lines)
    others = [line for line in lines if not all(name and name in line for name in names)]
    declared = _find_declared_units(others, _order_of_axes(names, lines))
    units = [unit or other for unit, other in zip(units, declared, strict=True)]
    stray = next((line for line in others if _find_unit(line, at_end=True)), None)
    if None in units and not any(declared) and stray is not None:
        what = "positions" if units[0] is None else "heights"
        condition = f"state the unit of its {what} beside the name of their column (there is {quote(stray)})"
        raise request.error(condition, "give position_unit and height_unit, such as 'mm' and 'um'")
    return units


def unit_of_heights(lines: Sequence[str], request: Request) -> tuple[str | None, str]:
    """Return the unit of heights alone, None if it is not stated, and the line above them that states it."""
    stated = [line for line in lines if _find_unit(line, at_end=True) and not _STEP.search(line)]
    axes = _order_of_axes(("", ""), lines)
    stated = [line for line in stated if not any(map(_NUMBER.fullmatch, _BETWEEN_WORDS.split(line)))]
    line = next((line for line in reversed(stated) if _column_of(line, axes) != 0), "")
    return request.height_unit or _find_unit(line, at_end=True), line


def find_step(lines: Iterable[str], request: Request) -> tuple[float, str | None] | None:
    """Return the distance between points that lines above the numbers state, and its unit, or None."""
    stated = []
    for key, number, behind in (match.groups() for line in lines for match in _SETTING.finditer(line)):
        value = float(number.replace(",", "."))
        if value <= 0.0 or not _STEP.search(key) or _NO_STEP.search(key):
            continue
        unit = behind if behind and millimetres(behind) else _find_unit(key.strip(" \"',"))
        if unit or not (behind or _BRACKETS.search(key) or "resolution" in key.lower()):
            stated.append((value, request.position_unit or unit))
    return max(stated, key=lambda step: step[1] is not None, default=None)


def counts_drop(name: str, request: Request) -> bool:
    """Return whether the name of a column of heights says that it is positive where material is removed.

    Raises
    ------
    InputError
        If the name is ambiguous and no sense is given.
    """
    if request.sense is None and _EITHER.search(name) and not _DROP.search(name):
        condition = f"say which way its column {quote(name)} is positive"
        raise request.error(condition, "give sense = 'drop' where it is positive below the surface, or 'height'")
    return bool(_DROP.search(name))


def find_column(field: str, requested: object, names: list[str]) -> int:
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
    known = list_names([name for name in names if name]) or "none: the file has no line of names"
    raise InputError(field, requested, f"be the name of a column ({known})", "give its number, from 1")


def list_names(names: Sequence[str]) -> str:
    """Return the first few of some names as text."""
    return ", ".join(map(quote, names[:_LISTED])) + (", ..." if len(names) > _LISTED else "")


def count_lines(count: int) -> str:
    """Return "1 line has" or "2 lines have"."""
    return "1 line has" if count == 1 else f"{count} lines have"


def quote(text: str) -> str:
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


def _cells(line: str, needed: Sequence[int], width: int, separator: str | None) -> list[str]:
    """Return the cells of a line of names, which may be separated differently from the numbers; [] if it is none."""
    splits = [(cells_of(line, candidate), candidate is not None) for candidate in (separator, ";", "\t", ",", "|")]
    for cells, apart in (*splits, (re.split(r"\s{2,}", line), True), (_split_at_units(line), True)):
        plain = [cell.strip(" \"'") for cell in cells]
        while len(plain) > needed[-1] + 1 and not plain[-1]:
            plain.pop()
        beyond = plain[width:]
        # A name too many belongs to a column that is empty, if those of the columns of numbers have their units.
        if (
            len(plain) == width
            or (apart and needed[-1] < len(plain) <= width)
            or (beyond and apart and all(_find_unit(plain[k]) for k in needed) and not any(map(_find_unit, beyond)))
        ):
            return [*plain, *[""] * width][:width]
    return []


def _names_in(line: str, needed: Sequence[int], width: int, separator: str | None) -> list[str]:
    """Return the cells of a line of the header that may be names, or units of all columns of numbers; [] if not."""
    cells = _cells(line, needed, width, separator)
    if not cells or _SAYS_UNIT.search(cells[0]) or any(_is_value(cells[k]) for k in needed):
        return []
    # "X mm" is the unit of one axis, not the names of two columns.
    units = [millimetres(cells[k]) is not None for k in needed]
    return cells if all(units) or not any(units) else []


def _split_at_units(line: str) -> list[str]:
    """Return the names in "y [mm] z [um] note" or "y mm z um", with one blank between all words."""
    names: list[str] = [""]
    for word in re.findall(r"[^\s\[(]+|\[[^][]*\]|\([^()]*\)", line):
        names[-1] = f"{names[-1]} {word}".strip()
        if _find_unit(names[-1]) not in (None, "in"):  # "all values in um" is no column of inches
            names.append("")
    return [name for name in names if name] if len(names) > 1 else line.split()


def _units(cells: Sequence[str], needed: Sequence[int]) -> int:
    """Return how many columns of numbers have a name with a unit of length, or are a unit."""
    return sum(_find_unit(cells[k]) is not None for k in needed)


def _is_value(cell: str) -> bool:
    """Return whether a cell is a number, with a unit behind it or without, and so no name."""
    return bool(_NUMBER.match(cell)) and not millimetres(cell)


def _names_axis(name: str) -> bool:
    return bool(_AXIS.search(name) or _OF_POSITIONS.search(name) or _OF_HEIGHTS.search(name))


def _are_names(cells: list[str], line: str) -> bool:
    """Return whether a comment is a line of names: words separated by more than blanks, or with units of length."""
    units = [_find_unit(cell) for cell in cells]
    if any(units) or any(_BRACKETS.search(cell) for cell in cells):
        return all(units)
    return bool(re.search(r"[;\t|,]", line)) and all(re.fullmatch(r"\w+", cell) for cell in cells)


def _find_unit(name: str, *, at_end: bool = False) -> str | None:
    """Return the unit of length in a name, in brackets or as a word that follows no number; None if there is none."""
    for brackets in reversed(list(_BRACKETS.finditer(name))):
        unit = next(group for group in brackets.groups() if group is not None)
        if millimetres(unit) and not (at_end and name[brackets.end() :].strip(" .,:;\"'")):
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
    unit = _find_unit(name)
    if unit is None and (_BRACKETS.search(name) or _LOST.search(name)):
        condition = f"state a unit of length for each column (there is {quote(name)})"
        raise request.error(condition, "write mm, um, nm, m or in there, or give position_unit and height_unit")
    return unit


def _order_of_axes(names: Sequence[str], lines: Iterable[str]) -> str:
    """Return the letters of the axes of positions and of heights, " " for one that is not known.

    They are those of the names of the columns, or the first and the last of those that occur above the numbers: x and
    y, x and z, or y and z. A y alone may be either.
    """
    letters = [str(match[0]).lower() if (match := _AXIS.search(name)) else " " for name in names]
    if " " not in letters and letters[0] != letters[1]:
        return "".join(letters)
    known = sorted({str(letter).lower() for line in lines for letter in _AXIS.findall(line)})
    if len(known) > 1:
        return known[0] + known[-1]
    return "".join(letter if letter in known else " " for letter in "xz")


def _find_declared_units(lines: Iterable[str], axes: str) -> list[str | None]:
    """Return the units of positions and heights in lines such as "Units: mm, um", "Z unit = um" or "X (mm)"."""
    units_: list[str | None] = [None, None]
    for line in lines:
        _, *behind = _SAYS_UNIT.split(line, maxsplit=1)
        units = [word for word in _BETWEEN_UNITS.split(behind[0]) if millimetres(word)] if behind else []
        parts = [part for part in re.split(r"[;,\t|]", line) if _find_unit(part, at_end=True)]
        if len(units) == 2 and len(_SAYS_UNIT.findall(line)) == 1:
            units_ = [mine or unit for mine, unit in zip(units_, units, strict=True)]
            continue
        for part in parts if len(parts) > 1 else [line]:
            column = _column_of(part, axes)
            if column is not None and (behind or len(part.split()) <= _WORDS_OF_AXIS):
                units_[column] = units_[column] or _find_unit(part, at_end=True)
    return units_


def _column_of(line: str, axes: str) -> int | None:
    """Return which column a line without numbers is about: 0 for positions, 1 for heights, None if it does not say."""
    if any(_NUMBER.fullmatch(word) for word in _BETWEEN_WORDS.split(line)):
        return None
    letters = {letter.lower() for letter in _AXIS.findall(line)}
    about = [
        axes[column] in letters or bool(not letters and words.search(line))
        for column, words in enumerate((_OF_POSITIONS, _OF_HEIGHTS))
    ]
    return about.index(True) if sum(about) == 1 else None
