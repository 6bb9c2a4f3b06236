"""Text in columns: any separator, decimal points or commas, comments, a header with names and units.

Ambiguity is refused, never guessed away: commas that may be decimal commas or separators, more than two columns
without a choice, a line that is not all numbers. The message quotes the line.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from nonhertz.errors import InputError
from nonhertz.io.traces.heads import column_called, counts_drop, listed, names_of_columns, shown, unit_in
from nonhertz.io.traces.line import MOST_POINTS, Line, Request, in_mm
from nonhertz.io.traces.text import LONGEST_HEAD, value_in
from nonhertz.measured.trace import Array

# Without any of these characters, `float` reads a cell as `value_in` does, but three times as fast.
_ODD = re.compile(r"[^0-9eE+.\- \t;|,]")
_WHOLE = re.compile(r"[-+]?\d+")
_PADDED = re.compile(r"[-+]?0\d+")  # 001166: the digits after a decimal comma
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}(?:,\d{3})+")
_BELOW_THOUSAND = re.compile(r"[-+]?[1-9]\d{0,2}")
_COMMENT = re.compile(r"\s*(?:#|%|//|'|!)+\s*")
_MOST_CELLS = 4 * MOST_POINTS
_NAMES_WITHIN = 100  # lines above the numbers
_AS_TEXT = "write two columns of numbers, position and height"


@dataclass(frozen=True)
class _Layout:
    """How a line is split into cells."""

    separator: str | None  # None: whitespace
    comma: bool  # whether decimals are written with a comma

    def split(self, line: str) -> list[str]:
        """Return the cells of a line."""
        if self.separator is None:
            return line.split()
        return [_unquoted(cell.strip()) for cell in line.split(self.separator)]


def read_columns(lines: Sequence[str], request: Request) -> Line:
    """Return the measured line in a text of columns.

    Raises
    ------
    InputError
        With the number of the offending line.
    """
    written = [(k, line.strip()) for k, line in enumerate(lines, start=1)]
    numbered = [(k, line) for k, line in written if line and not _COMMENT.match(line)]
    layout = _layout(numbered, request)
    beginning = islice(numbered, LONGEST_HEAD + 1)
    first = next((k for k, (_, line) in enumerate(beginning) if _is_data(line, layout)), None)
    if first is None:
        raise request.refuse(f"hold two columns of numbers ({_instead(numbered)})", _AS_TEXT)
    head, body = numbered[:first], numbered[first:]
    table = _table(body, layout, request)
    above = [line for _, line in written[max(body[0][0] - 1 - _NAMES_WITHIN, 0) : body[0][0] - 1]]
    remarks = [_COMMENT.sub("", line, count=1) for line in above if _COMMENT.match(line)]
    names = names_of_columns([line for _, line in head[-_NAMES_WITHIN:]], remarks, table.shape[1], layout.split)
    return _converted(table, _chosen(table, names, request), names, layout, request)


def _instead(numbered: list[tuple[int, str]]) -> str:
    """Return what a text without two columns of numbers holds instead."""
    if any(math.isfinite(value_in(line) or math.nan) for _, line in numbered[:LONGEST_HEAD]):
        return "there is only one number per line"
    with_digits = (f"line {k} is {shown(line)}" for k, line in numbered if any(c.isdigit() for c in line))
    return next(with_digits, "no line has any")


def _layout(numbered: list[tuple[int, str]], request: Request) -> _Layout:
    """Return the layout by which most lines split into two or more numbers."""
    sample = list(islice(((k, line) for k, line in numbered if any(c.isdigit() for c in line)), 400))
    for separator in (";", "\t", "|"):
        if sum(separator in line.strip(separator + " ") for _, line in sample) > 0.5 * len(sample):
            return _Layout(separator, _with_decimal_commas(sample, separator, request))
    if _mostly(sample, lambda line: "," in line):
        return _comma_layout(sample, request)
    return _Layout(None, comma=False)


def _comma_layout(sample: list[tuple[int, str]], request: Request) -> _Layout:
    blanks, commas = _Layout(None, comma=True), _Layout(",", comma=False)
    read = [(number, line) for number, line in sample if _is_data(line, blanks) and "." not in line]
    if len(read) > sum(_is_data(line, commas) for _, line in sample):
        _refuse_thousands(read, blanks, request)
        return blanks
    for number, line in sample:
        cells = [cell.strip() for cell in line.split(",")]
        whole = all(_WHOLE.fullmatch(cell) for cell in cells)
        chosen = request.position_column is not None and request.height_column is not None
        padded = any(_PADDED.fullmatch(cell) for cell in cells)
        if whole and (padded or (len(cells) > 2 and not chosen)):
            condition = f"distinguish decimal commas from commas between columns (line {number} is {shown(line)})"
            raise request.refuse(condition, "separate the columns by semicolons or tabs, or write decimal points")
    return commas


def _with_decimal_commas(sample: list[tuple[int, str]], separator: str, request: Request) -> bool:
    """Return whether the lines of numbers have decimal commas, whatever the header above them contains."""
    layout = _Layout(separator, comma=True)
    read = [(number, line) for number, line in sample if _is_data(line, layout)]
    if not any("," in line for _, line in read) or any("." in line for _, line in read):
        return False
    _refuse_thousands(read, layout, request)
    return True


def _refuse_thousands(lines: list[tuple[int, str]], layout: _Layout, request: Request) -> None:
    """Refuse a column such as 500, 1,000, 1,500, which decimal commas would turn into 500, 1, 1.5."""
    columns: dict[int, list[tuple[int, str]]] = {}
    for number, line in lines:
        for place, cell in enumerate(layout.split(line)):
            columns.setdefault(place, []).append((number, cell))
    for column in columns.values():
        parted = [(number, cell) for number, cell in column if "," in cell]
        whole = [cell for _, cell in column if _WHOLE.fullmatch(cell) and cell.strip("+-0")]
        alike = all(_THOUSANDS.fullmatch(cell) for _, cell in parted) and all(map(_BELOW_THOUSAND.fullmatch, whole))
        if parted and whole and alike:
            number, cell = parted[0]
            condition = f"distinguish decimal commas from thousands separators (line {number} has {shown(cell)})"
            raise request.refuse(condition, "write decimal points and no thousands separators")


def _unquoted(cell: str) -> str:
    return cell[1:-1].strip() if len(cell) > 1 and cell[0] == cell[-1] == '"' else cell


def _mostly(sample: list[tuple[int, str]], holds: Callable[[str], bool]) -> bool:
    return sum(holds(line) for _, line in sample) > 0.5 * len(sample)


def _is_data(line: str, layout: _Layout) -> bool:
    cells = _cells(line, layout)
    measured = False
    for cell in cells:
        value = _value(cell, layout)
        if value is None:
            return False
        measured = measured or not math.isnan(value)
    return measured and len(cells) > 1


def _cells(line: str, layout: _Layout) -> list[str]:
    return layout.split(line.split("#", 1)[0].strip() if "#" in line and "#n/a" not in line.lower() else line)


def _value(cell: str, layout: _Layout) -> float | None:
    return value_in(cell.replace(",", ".") if layout.comma else cell)


def _table(body: list[tuple[int, str]], layout: _Layout, request: Request) -> Array:
    """Return all numbers, one row per line; empty columns after a trailing separator are dropped."""
    width = len(_cells(body[0][1], layout))
    if width * len(body) > _MOST_CELLS:
        condition = f"hold no more than {_MOST_CELLS:,} numbers (there are {len(body):,} lines of {width:,})"
        raise request.refuse(condition, "export fewer points, or the columns of positions and heights alone")
    table = np.array(
        [_plain_row(line, width, layout) or _row(number, line, width, layout, request) for number, line in body]
    )
    while table.shape[1] > 2 and np.all(np.isnan(table[:, -1])):
        table = table[:, :-1]
    return table


def _plain_row(line: str, width: int, layout: _Layout) -> list[float] | None:
    """Return the numbers of a line that holds nothing else; None for any other line."""
    if _ODD.search(line) or (layout.comma and "." in line):
        return None
    try:
        row = list(map(float, (line.replace(",", ".") if layout.comma else line).split(layout.separator)))
    except ValueError:
        return None
    return row if len(row) == width else None


def _row(number: int, line: str, width: int, layout: _Layout, request: Request) -> list[float]:
    cells = _cells(line, layout)
    if len(cells) != width:
        condition = f"hold {width} columns in line {number} as above (there are {len(cells)}: {shown(line)})"
        raise request.refuse(condition, "correct or delete that line")
    row = []
    for column, cell in enumerate(cells, start=1):
        value = _value(cell, layout)
        if value is None:
            condition = f"hold a number in line {number}, column {column} (there is {shown(cell)})"
            raise request.refuse(condition, "correct or delete that line; write nan where nothing was measured")
        row.append(value)
    return row


def _chosen(table: Array, names: list[str], request: Request) -> tuple[int, int]:
    requested = {"position_column": request.position_column, "height_column": request.height_column}
    columns = table.shape[1]
    found = {field: column_called(field, value, names) for field, value in requested.items() if value is not None}
    if len(found) == 2:
        if found["position_column"] == found["height_column"]:
            condition = "differ from position_column"
            raise InputError("height_column", request.height_column, condition, "choose two columns")
        return found["position_column"], found["height_column"]
    if columns > 2:
        names = [name or f"column {k}" for k, name in enumerate(names, start=1)] if any(names) else []
        condition = f"hold two columns, or have two of its {columns} chosen"
        condition += f" ({listed(names)})" if names else ""
        raise request.refuse(condition, "give position_column and height_column, by number from 1 or by name")
    if found:
        ((field, column),) = found.items()
        return (column, 1 - column) if field == "position_column" else (1 - column, column)
    _refuse_swapped(table, request)
    return 0, 1


def _refuse_swapped(table: Array, request: Request) -> None:
    """Refuse columns that look swapped: the second is monotonic, as positions are, and the first is not."""
    first, second = (np.diff(column) for column in table[np.all(np.isfinite(table), axis=1)].T)
    back = min(int(np.sum(first < 0.0)), int(np.sum(first > 0.0)))
    if back and (np.all(second > 0.0) or np.all(second < 0.0)):
        condition = f"have its positions in the first column (it reverses in {back} places and the second in none)"
        raise request.refuse(condition, "give position_column = 2, or 1 if it really is the first")


def _converted(table: Array, chosen: tuple[int, int], names: list[str], layout: _Layout, request: Request) -> Line:
    notes, values = [], []
    known = True
    for field, column, what in zip(("position_unit", "height_unit"), chosen, ("Positions", "Heights"), strict=True):
        stated = unit_in(names[column], request)
        unit = getattr(request, field) or stated or "mm"
        known = known if field == "position_unit" else bool(getattr(request, field) or stated)
        values.append(table[:, column] * in_mm(field, unit))
        if unit != "mm":
            notes.append(f"{what} were converted from {unit} to mm.")
    if layout.comma:
        notes.append("Commas were read as decimal commas.")
    return Line(values[0], values[1], tuple(notes), known, counts_drop(names[chosen[1]], request))
