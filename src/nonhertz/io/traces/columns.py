"""Text in columns: any separator, decimal points or commas, comments, a head with names and units.

Nothing is guessed that could be two things. Commas that may be decimal signs or separators, more columns than two
without a choice, a line that is no line of numbers: each is refused with the line.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from nonhertz.errors import InputError
from nonhertz.io.traces.line import MOST_POINTS, Line, Request, in_mm
from nonhertz.measured.trace import Array

_MISSING = frozenset({"", "nan", "na", "n/a", "#n/a", "null", "none", "bad", "-", "--", "---", "inf", "-inf", "+inf"})
_STARS = re.compile(r"\*+")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?")
_WITH_COMMA = re.compile(r"[-+]?\d*,\d+(?:[eEdD][-+]?\d+)?")
_WHOLE = re.compile(r"[-+]?\d+")
_PADDED = re.compile(r"[-+]?0\d+")  # 001166: the digits behind a decimal comma
_COMMENT = re.compile(r"\s*(?:#|%|//|'|!)")
# "y [mm]", "z (um)", "height / nm", "y_mm", "z in um"
_UNIT = re.compile(r"\[\s*([^\W\d_]+)\s*\]|\(\s*([^\W\d_]+)\s*\)|(?:/|_|\bin)\s*([^\W\d_]+)\s*$")
_BARE_UNIT = re.compile(r"\[?\s*(mm|um|µm|μm|nm|cm|m|in|inch)\s*\]?")
_DROP = re.compile(r"relief|drop", re.IGNORECASE)
_SHOWN = 40
_LONGEST_HEAD = 1000  # lines
_AS_TEXT = "write two columns of numbers, position and height"


@dataclass(frozen=True)
class _Layout:
    """How a line is taken apart."""

    split: Callable[[str], list[str]]
    comma: bool  # whether the decimal sign is a comma


def read_columns(lines: Sequence[str], request: Request) -> Line:
    """Return the measured line in a text of columns.

    Raises
    ------
    InputError
        One sentence with the number of the line.
    """
    if len(lines) > MOST_POINTS + _LONGEST_HEAD:
        raise request.refuse(f"hold no more than {MOST_POINTS:,} points", "export fewer; a few thousand are enough")
    numbered = [(k, line.strip()) for k, line in enumerate(lines, start=1)]
    numbered = [(k, line) for k, line in numbered if line and not _COMMENT.match(line)]
    layout = _layout(numbered, request)
    first = next((k for k, (_, line) in enumerate(numbered) if _is_data(line, layout)), None)
    if first is None:
        alone = any(_NUMBER.fullmatch(line) for _, line in numbered)
        found = "there is one number in a line" if alone else "no line has them"
        raise request.refuse(f"hold two columns of numbers ({found})", _AS_TEXT)
    head, body = numbered[:first], numbered[first:]
    table = _table(body, layout, request)
    names = _names(head, table.shape[1], layout)
    position, height = _chosen(table, names, request)
    return _converted(table, (position, height), names, head, layout, request)


def _layout(numbered: list[tuple[int, str]], request: Request) -> _Layout:
    """Return how most lines can be taken apart into two numbers or more."""
    sample = [(k, line) for k, line in numbered if any(c.isdigit() for c in line)][:400]
    for separator in (";", "\t", "|"):
        if sum(separator in line.strip(separator + " ") for _, line in sample) > 0.5 * len(sample):
            comma = any("," in line for _, line in sample) and not _mostly(sample, lambda line: "." in line, 0.01)
            return _Layout(_splitter(separator), comma)
    if _mostly(sample, lambda line: "," in line):
        return _comma_layout(sample, request)
    return _Layout(str.split, False)


def _comma_layout(sample: list[tuple[int, str]], request: Request) -> _Layout:
    if _mostly(sample, lambda line: len(line.split()) > 1 and all(_decimal_comma(c) for c in line.split()), 0.9):
        return _Layout(str.split, True)
    for number, line in sample:
        cells = [cell.strip() for cell in line.split(",")]
        whole = all(_WHOLE.fullmatch(cell) for cell in cells)
        chosen = request.position_column is not None and request.height_column is not None
        padded = any(_PADDED.fullmatch(cell) for cell in cells)
        if whole and (padded or (len(cells) > 2 and not chosen)):
            condition = f"tell decimal commas from commas between columns (line {number} is {_short(line)})"
            raise request.refuse(condition, "separate the columns by semicolons or tabs, or write decimal points")
    return _Layout(_splitter(","), False)


def _splitter(separator: str) -> Callable[[str], list[str]]:
    return lambda line: [cell.strip() for cell in line.split(separator)]


def _decimal_comma(cell: str) -> bool:
    return bool(_WITH_COMMA.fullmatch(cell) or _WHOLE.fullmatch(cell))


def _mostly(sample: list[tuple[int, str]], holds: Callable[[str], bool], share: float = 0.5) -> bool:
    return bool(sample) and sum(holds(line) for _, line in sample) > share * len(sample)


def _is_data(line: str, layout: _Layout) -> bool:
    cells = _cells(line, layout)
    values = [_value(cell, layout) for cell in cells]
    return len(cells) > 1 and None not in values and not all(value is None or math.isnan(value) for value in values)


def _cells(line: str, layout: _Layout) -> list[str]:
    return layout.split(line.split("#", 1)[0].strip() if "#" in line and "#n/a" not in line.lower() else line)


def _value(cell: str, layout: _Layout) -> float | None:
    """Return the number in a cell, NaN for one that says nothing was measured, None for any other text."""
    if layout.comma:
        cell = cell.replace(",", ".")
    if _NUMBER.fullmatch(cell):
        return float(cell.replace("d", "e").replace("D", "e"))
    return float("nan") if cell.lower() in _MISSING or _STARS.fullmatch(cell) else None


def _table(body: list[tuple[int, str]], layout: _Layout, request: Request) -> Array:
    """Return all numbers, a row for each line; empty columns at the end, behind a last separator, are dropped."""
    rows: list[list[float]] = []
    width = len(_cells(body[0][1], layout))
    for number, line in body:
        cells = _cells(line, layout)
        if len(cells) != width:
            condition = f"hold {width} columns in line {number} as above (there are {len(cells)}: {_short(line)})"
            raise request.refuse(condition, "correct or delete that line")
        row = []
        for column, cell in enumerate(cells, start=1):
            value = _value(cell, layout)
            if value is None:
                condition = f"hold a number in line {number}, column {column} (there is {_short(cell)})"
                raise request.refuse(condition, "correct or delete that line; write nan where nothing was measured")
            row.append(value)
        rows.append(row)
    table = np.array(rows)
    while table.shape[1] > 2 and np.all(np.isnan(table[:, -1])):
        table = table[:, :-1]
    return table


def _names(head: list[tuple[int, str]], width: int, layout: _Layout) -> list[str]:
    """Return the names of the columns: the last line of the head that has as many cells; units below them are added."""
    rows = [cells for _, line in head if len(cells := _head_cells(line, width, layout)) == width]
    if not rows:
        return [""] * width
    if len(rows) > 1 and all(_BARE_UNIT.fullmatch(cell) for cell in rows[-1]):
        return [f"{name} [{unit.strip('[] ')}]" for name, unit in zip(rows[-2], rows[-1], strict=True)]
    return rows[-1]


def _head_cells(line: str, width: int, layout: _Layout) -> list[str]:
    """Return the cells of a line of names, which may be set apart otherwise than the numbers are."""
    for parts in (layout.split(line), re.split(r"\s*[;\t|,]\s*", line), re.split(r"\s{2,}", line)):
        cells = [cell.strip(" \"'") for cell in parts]
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if len(cells) == width:
            return cells
    # "y [mm] z [um]", one blank between all words
    joined = re.findall(r"[^\s\[(]+\s*(?:\[[^\]]*\]|\([^)]*\))?", line)
    return [cell.strip() for cell in joined]


def _chosen(table: Array, names: list[str], request: Request) -> tuple[int, int]:
    wanted = {"position_column": request.position_column, "height_column": request.height_column}
    columns = table.shape[1]
    found = {field: _column(field, value, names, columns) for field, value in wanted.items() if value is not None}
    if len(found) == 2:
        return found["position_column"], found["height_column"]
    if columns > 2:
        listed = ", ".join(name or f"column {k}" for k, name in enumerate(names, start=1))
        condition = f"hold two columns, or have two of its {columns} chosen ({listed})"
        raise request.refuse(condition, "give position_column and height_column, by number from 1 or by name")
    if found:
        ((field, column),) = found.items()
        return (column, 1 - column) if field == "position_column" else (1 - column, column)
    return 0, 1


def _column(field: str, wanted: int | str, names: list[str], columns: int) -> int:
    number = int(wanted) if isinstance(wanted, int) or wanted.isdigit() else None
    if number is not None:
        if not 1 <= number <= columns:
            raise InputError(field, wanted, f"be a column from 1 to {columns}", "give its number, from 1, or its name")
        return number - 1
    plain = [re.split(r"\s*[\[(/]", name)[0].strip().lower() for name in names]
    lowered = [name.lower() for name in names]
    for candidates in (lowered, plain):
        if candidates.count(str(wanted).lower()) == 1:
            return candidates.index(str(wanted).lower())
    known = ", ".join(repr(name) for name in names if name) or "none: the file has no line of names"
    raise InputError(field, wanted, f"be the name of a column ({known})", "give its number, from 1")


def _converted(
    table: Array, chosen: tuple[int, int], names: list[str], head: list[tuple[int, str]], layout: _Layout,
    request: Request,
) -> Line:  # fmt: skip
    notes, values = [], []
    known = True
    for field, column, what in zip(("position_unit", "height_unit"), chosen, ("Positions", "Heights"), strict=True):
        stated = _unit(names[column], request)
        unit = getattr(request, field) or stated or "mm"
        known = known if field == "position_unit" else bool(getattr(request, field) or stated)
        values.append(table[:, column] * in_mm(field, unit))
        if unit != "mm":
            notes.append(f"{what} were converted from {unit} to mm.")
    if layout.comma:
        notes.append("Commas were read as decimal signs.")
    drop = bool(_DROP.search(names[chosen[1]]))
    return Line(values[0], values[1], tuple(notes), known, drop)


def _unit(name: str, request: Request) -> str | None:
    """Return the unit that a column's name states, None if it states none."""
    found = _UNIT.search(name)
    if found is None:
        return None
    unit = next(group for group in found.groups() if group)
    try:
        in_mm("unit", unit)
    except InputError:
        if found.group(3):  # "y_axis": a word behind an underscore is no unit
            return None
        condition = f"state a unit of length for each column (there is {_short(name)})"
        raise request.refuse(condition, "write mm, um, nm, m or in in the line of names") from None
    return unit


def _short(text: str) -> str:
    return repr(text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "...")
