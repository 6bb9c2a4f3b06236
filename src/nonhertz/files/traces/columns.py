"""Text in columns: any separator, decimal points or commas, comments, a header with names and units, a footer.

Ambiguity is refused, never guessed away: commas that may be decimal commas or separators, more than two columns
without a choice, a line between the points that is not all numbers. The message quotes the line.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from nonhertz.errors import InputError
from nonhertz.files.traces.dialects import stated_by
from nonhertz.files.traces.heads import (
    cells_of,
    column_called,
    counts_drop,
    listed,
    names_of_columns,
    shown,
    units_of_columns,
)
from nonhertz.files.traces.line import MOST_POINTS, Line, Request, in_mm
from nonhertz.files.traces.text import COMMENT, LONGEST_HEAD, value_in, without_comment
from nonhertz.measured.trace import Array

# Without any of these characters, `float` reads a cell as `value_in` does, but three times as fast.
_ODD = re.compile(r"[^0-9eE+.\- \t;|,]")
_WHOLE = re.compile(r"[-+]?\d+")
_PADDED = re.compile(r"[-+]?0\d+")  # 001166: the digits after a decimal comma
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}(?:,\d{3})+")
_BELOW_THOUSAND = re.compile(r"[-+]?[1-9]\d{0,2}")
_MARK = re.compile(r"^[*!>~&+]\s+|\s*[;,|\t]?\s*[*!<~&\u2020]$")
_BEGUN = re.compile(r"[-+]?[.,]?\d")
_MOST_CELLS = 4 * MOST_POINTS
_NAMES_WITHIN = 100  # lines above the numbers
_AS_TEXT = "write two columns of numbers, position and height"


@dataclass(frozen=True)
class _Layout:
    """How a line is split into cells, and how numbers are written."""

    separator: str | None  # None: whitespace
    comma: bool  # whether decimals are written with a comma

    def cells(self, line: str) -> list[str]:
        """Return the cells of a line, without a comment behind them."""
        return cells_of(without_comment(line), self.separator)

    def value(self, cell: str) -> float | None:
        """Return the number in a cell, as `value_in`."""
        return value_in(cell.replace(",", ".") if self.comma else cell)

    def row(self, line: str) -> list[float] | None:
        """Return the numbers of a line, None if it holds anything else."""
        if not _ODD.search(line) and not (self.comma and "." in line):
            try:
                return list(map(float, (line.replace(",", ".") if self.comma else line).split(self.separator)))
            except ValueError:
                pass
        values = []
        for cell in self.cells(line):
            value = self.value(cell)
            if value is None:
                return None
            values.append(value)
        return values


def read_columns(lines: Sequence[str], request: Request) -> Line:
    """Return the measured line in a text of columns.

    Raises
    ------
    InputError
        With the number of the offending line.
    """
    written = [(k, line.strip()) for k, line in enumerate(lines, start=1)]
    numbered = [(k, line) for k, line in written if line and not COMMENT.match(line)]
    layout = _layout(numbered, request)
    rows = _rows(numbered, layout, request)
    widths = Counter(len(row) for row in rows if row and _measured(row))
    width = widths.most_common(1)[0][0] if widths else 0
    wide = [k for k, row in enumerate(rows) if row and len(row) == width]
    # A line of dashes below a head reads as missing values.
    first = next((k for k in wide if any(map(str.isalnum, numbered[k][1]))), None)
    if first is None or first > LONGEST_HEAD:
        raise request.refuse(f"hold two columns of numbers ({_instead(numbered)})", _AS_TEXT)
    last = wide[-1]
    body, notes = _between(numbered, rows, (first, last), layout, request)
    table = np.array(body)
    while table.shape[1] > 2 and np.all(np.isnan(table[:, -1])):
        table = table[:, :-1]
    head = [line for (_, line), row in zip(numbered[:first], rows[:first], strict=True) if row is None]
    defaults, note = stated_by(head)
    request = replace(request, **{key: value for key, value in defaults.items() if getattr(request, key) is None})
    begin = numbered[first][0] - 1
    above = [line for _, line in written[max(begin - _NAMES_WITHIN, 0) : begin]]
    inside = [line for _, line in written[begin : numbered[last][0]] if COMMENT.match(line)]
    hidden = sum(len(layout.row(COMMENT.sub("", line, count=1)) or []) == width for line in inside)
    notes += [f"{hidden} lines of numbers between the points are comments and were left out."] if hidden else []
    remarks = [COMMENT.sub("", line, count=1) for line in above if COMMENT.match(line)]
    head = head[-_NAMES_WITHIN:]
    names = names_of_columns(head, remarks, table.shape[1], layout.separator)
    chosen = _chosen(table, names, request)
    units = units_of_columns([names[k] for k in chosen], [*head, *remarks], request)
    values = [table[:, column] * in_mm("unit", unit or "mm") for column, unit in zip(chosen, units, strict=True)]
    told = [note] if note else []
    for what, unit in zip(("Positions", "Heights"), units, strict=True):
        told += [f"{what} were converted from {unit} to mm."] if (unit or "mm") != "mm" else []
    told += ["Commas were read as decimal commas."] if layout.comma else []
    drop = request.sense == "drop" or counts_drop(names[chosen[1]], request)
    known = units[0] is not None, units[1] is not None
    return Line(values[0], values[1], (*told, *notes), known, drop)


def _rows(numbered: list[tuple[int, str]], layout: _Layout, request: Request) -> list[list[float] | None]:
    """Return the numbers of every line; refuse more than fit into memory before they fill it."""
    rows, count = [], 0
    for _, line in numbered:
        row = layout.row(line)
        rows.append(row)
        count += len(row or ())
        if count > _MOST_CELLS:
            condition = (
                f"hold no more than {_MOST_CELLS:,} numbers (there are {len(numbered):,} lines of {len(row or ()):,})"
            )
            raise request.refuse(condition, "export fewer points, or the columns of positions and heights alone")
    return rows


def _measured(row: list[float]) -> bool:
    return len(row) > 1 and not all(map(math.isnan, row))


def _between(
    numbered: list[tuple[int, str]],
    rows: list[list[float] | None],
    ends: tuple[int, int],
    layout: _Layout,
    request: Request,
) -> tuple[list[list[float]], list[str]]:
    """Return the rows from the first to the last, and notes on what was left out; refuse lines that may be points."""
    (first, last), width = ends, len(rows[ends[0]] or ())
    body, marked = [], 0
    for (number, line), row in zip(numbered[first : last + 1], rows[first : last + 1], strict=True):
        whole = row is not None and len(row) == width
        found = row if whole else layout.row(_MARK.sub("", line))
        if found is None or len(found) != width:
            raise _no_row(number, line, width, layout, request)
        marked += not whole
        body.append(found)
    notes = [f"{marked} lines have a mark beside their numbers, which was left out."] if marked else []
    if first and _measured(rows[first - 1] or []):
        raise _no_row(*numbered[first - 1], width, layout, request)
    footer = numbered[last + 1 :]
    if footer:
        number, line = footer[0]
        if number == numbered[last][0] + 1 and _BEGUN.match(line):
            raise _no_row(number, line, width, layout, request)
        notes.append(f"The text below the points was ignored, from line {number} on ({shown(line)}).")
    return body, notes


def _no_row(number: int, line: str, width: int, layout: _Layout, request: Request) -> InputError:
    cells = layout.cells(line)
    if len(cells) != width:
        condition = f"hold {width} columns in line {number} as elsewhere (there are {len(cells)}: {shown(line)})"
        return request.refuse(condition, "correct or delete that line")
    column, cell = next((k, cell) for k, cell in enumerate(cells, start=1) if layout.value(cell) is None)
    condition = f"hold a number in line {number}, column {column} (there is {shown(cell)})"
    return request.refuse(condition, "correct or delete that line; write nan where nothing was measured")


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
    if sum("," in line for _, line in sample) > 0.5 * len(sample):
        return _comma_layout(sample, request)
    return _Layout(None, comma=False)


def _comma_layout(sample: list[tuple[int, str]], request: Request) -> _Layout:
    blanks, commas = _Layout(None, comma=True), _Layout(",", comma=False)
    read = [(number, line) for number, line in sample if _measured(blanks.row(line) or []) and "." not in line]
    if len(read) > sum(_measured(commas.row(line) or []) for _, line in sample):
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
    read = [(number, line) for number, line in sample if _measured(layout.row(line) or [])]
    if not any("," in line for _, line in read) or any("." in line for _, line in read):
        return False
    _refuse_thousands(read, layout, request)
    return True


def _refuse_thousands(lines: list[tuple[int, str]], layout: _Layout, request: Request) -> None:
    """Refuse a column such as 500, 1,000, 1,500, which decimal commas would turn into 500, 1, 1.5."""
    columns: dict[int, list[tuple[int, str]]] = {}
    for number, line in lines:
        for place, cell in enumerate(layout.cells(line)):
            columns.setdefault(place, []).append((number, cell))
    for column in columns.values():
        parted = [(number, cell) for number, cell in column if "," in cell]
        whole = [cell for _, cell in column if _WHOLE.fullmatch(cell) and cell.strip("+-0")]
        alike = all(_THOUSANDS.fullmatch(cell) for _, cell in parted) and all(map(_BELOW_THOUSAND.fullmatch, whole))
        if parted and whole and alike:
            number, cell = parted[0]
            condition = f"distinguish decimal commas from thousands separators (line {number} has {shown(cell)})"
            raise request.refuse(condition, "write decimal points and no thousands separators")


def _chosen(table: Array, names: list[str], request: Request) -> tuple[int, int]:
    requested = {"position_column": request.position_column, "height_column": request.height_column}
    filled = [k for k in range(table.shape[1]) if not np.all(np.isnan(table[:, k]))]
    found = {field: column_called(field, value, names) for field, value in requested.items() if value is not None}
    if len(found) == 2:
        if found["position_column"] == found["height_column"]:
            condition = "differ from position_column"
            raise InputError("height_column", request.height_column, condition, "choose two columns")
        return found["position_column"], found["height_column"]
    if not found and table.shape[1] > 2 and len(filled) == 2:
        return filled[0], filled[1]
    if table.shape[1] > 2:
        names = [name or f"column {k}" for k, name in enumerate(names, start=1)] if any(names) else []
        condition = f"hold two columns, or have two of its {table.shape[1]} chosen"
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
