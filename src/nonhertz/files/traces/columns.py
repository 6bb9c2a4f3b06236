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
from nonhertz.files.traces.dialects import read_dialect
from nonhertz.files.traces.heads import (
    cells_of,
    count_lines,
    counts_drop,
    find_column,
    list_names,
    names_of_columns,
    quote,
    units_of_columns,
)
from nonhertz.files.traces.line import MOST_POINTS, Line, Request, length_factor
from nonhertz.files.traces.text import COMMENT, LONGEST_HEAD, MARK, NOT_MEASURED, SAMPLED, value_in, without_comment
from nonhertz.measured.trace import Array

# Without any of these characters, `float` reads a cell as `value_in` does, but three times as fast.
_ODD = re.compile(r"[^0-9eE+.\- \t;|,]")
_WHOLE = re.compile(r"[-+]?\d+")
_PADDED = re.compile(r"[-+]?0\d+")  # 001166: the digits after a decimal comma
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}(?:,\d{3})+")
_BELOW_THOUSAND = re.compile(r"[-+]?[1-9]\d{0,2}")
_BEGUN = re.compile(r"[-+]?[.,]?\d")
_MOST_CELLS = 4 * MOST_POINTS
_MOST_COUNTED = 5000  # lines by which the columns of numbers are found
_NAMES_WITHIN = 100  # lines above the numbers
# Least fraction of the rows in which a column of numbers has one; a column of remarks may hold a few.
_FILLED = 0.1
_AS_TEXT = "write two columns of numbers, position and height"

#: The cells of a line: a number, NaN for one that says "not measured", None for any other text.
Row = list[float | None]


@dataclass(frozen=True)
class Layout:
    """How a line is split into cells, and how numbers are written."""

    separator: str | None  # None: whitespace
    comma: bool  # whether decimals are written with a comma

    def cells(self, line: str) -> list[str]:
        """Return the cells of a line, without a comment behind them."""
        return cells_of(NOT_MEASURED.sub("nan", without_comment(line)), self.separator)

    def value(self, cell: str) -> float | None:
        """Return the number in a cell, as `value_in`."""
        return value_in(cell.replace(",", ".") if self.comma else cell)

    def row(self, line: str) -> Row:
        """Return the numbers of a line."""
        if not _ODD.search(line) and not (self.comma and "." in line):
            try:
                return list(map(float, (line.replace(",", ".") if self.comma else line).split(self.separator)))
            except ValueError:
                pass
        return list(map(self.value, self.cells(line)))


@dataclass(frozen=True)
class _Table:
    """Which cells of a line are needed, from the most common lines of numbers.

    Attributes
    ----------
    needed : tuple of int
        Columns of numbers. Columns of text, and empty ones, are not needed.
    width : int
        Number of columns, those of text included.
    """

    layout: Layout
    needed: tuple[int, ...]
    width: int

    def holds(self, row: Row) -> bool:
        """Return whether a line has all the numbers that are needed, and no more."""
        if len(row) == self.width and None not in row:
            return True
        if len(row) <= self.needed[-1] or any(row[k] is None for k in self.needed):
            return False
        return all(cell is None or math.isnan(cell) for cell in row[self.width :])

    def plain(self, line: str, row: Row) -> Row:
        """Return the numbers of a line without a mark beside them, if it has all that are needed only then."""
        return row if self.holds(row) or not MARK.search(line) else self.layout.row(MARK.sub("", line))

    def ends(self, line: str, row: Row) -> bool:
        """Return whether a line can be the first or the last point: words beside its numbers have a column."""
        if not self.holds(row):
            return False
        return None not in row[self.width :] or not any(
            map(str.isalpha, "".join(self.layout.cells(line)[self.width :]))
        )

    def beside(self, row: Row) -> bool:
        """Return whether a line has text beside its numbers."""
        return None in row and any(cell is None for k, cell in enumerate(row) if k not in self.needed)

    def numbers(self, row: Row) -> list[float]:
        """Return the needed numbers of a line in their columns, NaN in all others."""
        if len(row) == self.width == len(self.needed):
            return row  # type: ignore[return-value]
        return [row[k] if k in self.needed else math.nan for k in range(self.width)]  # type: ignore[misc]


def read_columns(lines: Sequence[str], request: Request) -> Line:
    """Return the measured line in a text of columns.

    Raises
    ------
    InputError
        With the number of the offending line.
    """
    written = [(k, line.strip()) for k, line in enumerate(lines, start=1)]
    numbered = [(k, line) for k, line in written if line and not COMMENT.match(line)]
    layout = _find_layout(numbered, request)
    rows = _rows(numbered, layout, request)
    table = _find_table(rows, layout)
    if table is None:
        raise request.error(f"hold two columns of numbers ({_describe_content(numbered)})", _AS_TEXT)
    plain = [table.plain(line, row) for (_, line), row in zip(numbered, rows, strict=True)]
    first, last = _find_ends(numbered, plain, table, request)
    body, notes = _read_rows(numbered, plain, (first, last), table, request)
    pairs = islice(zip(plain, rows, strict=True), first, last + 1)
    if marked := sum(new is not old or table.beside(new) for new, old in pairs):
        notes.insert(0, f"{count_lines(marked)} a mark or text beside their numbers, which was left out.")
    values = np.array(body)
    begin, end = numbered[first][0] - 1, numbered[last][0]
    head = [line for (_, line), row in zip(numbered[:first], rows[:first], strict=True) if None in row]
    defaults, note = read_dialect(head)
    request = replace(request, **{key: value for key, value in defaults.items() if getattr(request, key) is None})
    above = [line for _, line in written[max(begin - _NAMES_WITHIN, 0) : begin]]
    apart = [COMMENT.sub("", line, count=1) for _, line in written[:end] if COMMENT.match(line)]
    hidden = sum(_is_measured(row) and table.holds(row) for row in map(layout.row, apart))
    if hidden:
        notes.append(f"{hidden} lines of numbers above or between the points are comments and were left out.")
    remarks = [COMMENT.sub("", line, count=1) for line in above if COMMENT.match(line)]
    head = head[-_NAMES_WITHIN:]
    names = names_of_columns(head, remarks, table.needed, table.width, layout.separator)
    chosen = _choose_columns(values, names, request)
    text = next((k for k in chosen if k not in table.needed), None)
    if text is not None:
        raise _no_number(*numbered[first], text, table, request)
    units = units_of_columns([names[k] for k in chosen], [*head, *remarks], request)
    y, height = (values[:, k] * length_factor("unit", unit or "mm") for k, unit in zip(chosen, units, strict=True))
    if request.step is not None:
        y, units[0] = _positions_of_counts(values[:, chosen[0]], request.step), "mm"
    if layout.comma:
        notes.insert(0, "Commas were read as decimal commas.")
    converted = [
        f"{what} were converted from {unit} to mm."
        for what, unit in zip(("Positions", "Heights"), units, strict=True)
        if (unit or "mm") != "mm"
    ]
    drop = request.sense == "drop" or counts_drop(names[chosen[1]], request)
    known = units[0] is not None, units[1] is not None
    return Line(y, height, (*([note] if note else []), *converted, *notes), known, drop)


def _rows(numbered: list[tuple[int, str]], layout: Layout, request: Request) -> list[Row]:
    """Return the numbers of every line; refuse more than fit into memory before they fill it."""
    rows, count = [], 0
    for _, line in numbered:
        row = layout.row(line)
        rows.append(row)
        count += len(row)
        if count > _MOST_CELLS:
            condition = f"hold no more than {_MOST_CELLS:,} numbers (there are {len(numbered):,} lines of {len(row):,})"
            raise request.error(condition, "export fewer points, or the columns of positions and heights alone")
    return rows


def _is_measured(row: Row) -> bool:
    """Return whether a line has two numbers or more, one of which is measured."""
    numbers = [cell for cell in row if cell is not None]
    return len(numbers) > 1 and not all(map(math.isnan, numbers))


def _find_table(rows: list[Row], layout: Layout) -> _Table | None:
    """Return which cells are needed: those that are numbers in half of the lines of numbers, two at least."""
    measured = [row for row in rows[:: len(rows) // _MOST_COUNTED + 1] if _is_measured(row)]
    # By the width of most, so that text above the points that holds numbers too does not count.
    width = Counter(sum(cell is not None for cell in row) for row in measured).most_common(1)
    alike = [row for row in measured if sum(cell is not None for cell in row) >= width[0][0]]
    if not alike:
        return None
    widest = Counter(map(len, alike)).most_common(1)[0][0]
    written, filled = Counter[int](), Counter[int]()
    for row in alike:
        written.update(k for k, cell in enumerate(row) if cell is not None)
        filled.update(k for k, cell in enumerate(row) if cell is not None and not math.isnan(cell))
    columns = [k for k in sorted(written) if 2 * written[k] > len(alike)]
    needed = [k for k in columns if filled[k] >= _FILLED * len(alike)]
    if len(needed) < 2:
        needed = columns
    return _Table(layout, tuple(needed), max(needed[-1] + 1, widest)) if len(needed) > 1 else None


def _find_ends(numbered: list[tuple[int, str]], rows: list[Row], table: _Table, request: Request) -> tuple[int, int]:
    """Return the first and the last line of numbers."""
    whole = [k for k, row in enumerate(rows) if table.ends(numbered[k][1], row)]
    # A line of dashes below a head reads as missing values.
    first = next((k for k in whole if any(map(str.isalnum, numbered[k][1]))), len(rows))
    if first > LONGEST_HEAD or not whole:
        raise request.error(f"hold two columns of numbers ({_describe_content(numbered)})", _AS_TEXT)
    last = whole[-1]
    if table.layout.separator is not None:
        # Words in a cell that no other line has.
        while first and _is_measured(rows[first - 1]) and table.holds(rows[first - 1]):
            first -= 1
        while last + 1 < len(rows) and _is_measured(rows[last + 1]) and table.holds(rows[last + 1]):
            last += 1
    return first, last


def _read_rows(
    numbered: list[tuple[int, str]], rows: list[Row], ends: tuple[int, int], table: _Table, request: Request
) -> tuple[list[list[float]], list[str]]:
    """Return the numbers from the first row to the last, and notes on words and footer; refuse points in the footer."""
    first, last = ends
    body: list[list[float]] = []
    words: list[str] = []
    for (number, line), row in zip(numbered[first : last + 1], rows[first : last + 1], strict=True):
        whole = row if table.holds(row) else _fill_gaps(row, table, line, words)
        if not table.holds(whole):
            raise _no_row(number, line, table, request)
        body.append(table.numbers(whole))
    notes = [f"{count_lines(len(words))} words in place of a number, such as {quote(words[0])}."] if words else []
    if first and _begins_as_row(rows[first - 1], table):
        raise _no_row(*numbered[first - 1], table, request)
    footer = numbered[last + 1 :]
    if footer:
        number, line = footer[0]
        if number == numbered[last][0] + 1 and _BEGUN.match(line):
            raise _no_row(number, line, table, request)
        notes.append(f"The text below the points was ignored, from line {number} on ({quote(line)}).")
    return body, notes


def _fill_gaps(row: Row, table: _Table, line: str, words: list[str]) -> Row:
    """Return a row with NaN for words without digits in place of its numbers, but for the first, and add the words."""
    cells = table.layout.cells(line)
    if len(cells) != len(row):
        cells = table.layout.cells(MARK.sub("", line))
    lacking = [k for k in table.needed if k < len(row) and row[k] is None]
    if not lacking or row[table.needed[0]] is None or any(map(str.isdigit, "".join(cells[k] for k in lacking))):
        return row
    words.append(" ".join(cells[k] for k in range(lacking[0], len(cells)) if row[k] is None))
    return [math.nan if k in lacking else cell for k, cell in enumerate(row)]


def _begins_as_row(row: Row, table: _Table) -> bool:
    """Return whether a line above the points holds numbers where they do: two at least, and one more or less."""
    return _is_measured(row) and all(cell is not None for cell in row[: min(table.needed[-1] + 1, len(row))])


def _no_row(number: int, line: str, table: _Table, request: Request) -> InputError:
    cells, width = table.layout.cells(line), table.width
    lacking = [k for k in table.needed if k < len(cells) and table.layout.value(cells[k]) is None]
    if len(cells) != width or not lacking:
        condition = f"hold {width} columns in line {number} as elsewhere (there are {len(cells)}: {quote(line)})"
        return request.error(condition, "correct or delete that line")
    return _no_number(number, line, lacking[0], table, request)


def _no_number(number: int, line: str, column: int, table: _Table, request: Request) -> InputError:
    cell = dict(enumerate(table.layout.cells(line))).get(column, "")
    condition = f"hold a number in line {number}, column {column + 1} (there is {quote(cell)})"
    return request.error(condition, "correct or delete that line; write nan where nothing was measured")


def _positions_of_counts(counts: Array, step: float) -> Array:
    """Return positions [mm] from the numbers of points and their step; refuse a step beside positions."""
    if not np.all(np.diff(counts) == 1.0):
        raise InputError("step", step, "not be given for a file that has positions", "leave it out")
    return np.asarray(counts * step)


def _describe_content(numbered: list[tuple[int, str]]) -> str:
    """Return what a text without two columns of numbers holds instead."""
    if any(math.isfinite(value_in(line) or math.nan) for _, line in numbered[:LONGEST_HEAD]):
        return "there is only one number per line"
    with_digits = (f"line {k} is {quote(line)}" for k, line in numbered if any(c.isdigit() for c in line))
    return next(with_digits, "no line has any")


def _find_layout(numbered: list[tuple[int, str]], request: Request) -> Layout:
    """Return the layout by which most lines split into two or more numbers."""
    spread = numbered[:: len(numbered) // SAMPLED + 1]
    sample = [(k, line) for k, line in spread if any(map(str.isdigit, line))]
    for separator in (";", "\t", "|"):
        if sum(separator in line.strip(separator + " ") for _, line in sample) > 0.5 * len(sample):
            return Layout(separator, _with_decimal_commas(sample, separator, request))
    if sum("," in line for _, line in sample) > 0.5 * len(sample):
        return _comma_layout(sample, request)
    return Layout(None, comma=False)


def _comma_layout(sample: list[tuple[int, str]], request: Request) -> Layout:
    blanks, commas = Layout(None, comma=True), Layout(",", comma=False)
    read = [(number, line) for number, line in sample if _is_measured(blanks.row(line)) and "." not in line]
    if sum(_numeric_fraction(blanks, line) for _, line in read) > sum(
        _numeric_fraction(commas, line) for _, line in sample
    ):
        _refuse_thousands(read, blanks, request)
        return blanks
    for number, line in sample:
        cells = [cell.strip() for cell in line.split(",")]
        whole = all(_WHOLE.fullmatch(cell) for cell in cells)
        chosen = request.position_column is not None and request.height_column is not None
        padded = any(_PADDED.fullmatch(cell) for cell in cells)
        if whole and (padded or (len(cells) > 2 and not chosen)):
            condition = f"distinguish decimal commas from commas between columns (line {number} is {quote(line)})"
            raise request.error(condition, "separate the columns by semicolons or tabs, or write decimal points")
    return commas


def _numeric_fraction(layout: Layout, line: str) -> float:
    """Return the fraction of a line's cells that are numbers, zero for fewer than two."""
    row = layout.row(line)
    return sum(cell is not None for cell in row) / len(row) if _is_measured(row) else 0.0


def _with_decimal_commas(sample: list[tuple[int, str]], separator: str, request: Request) -> bool:
    """Return whether the lines of numbers have decimal commas, whatever the header above them contains."""
    layout = Layout(separator, comma=True)
    read = [(number, line) for number, line in sample if _is_measured(layout.row(line))]
    written = "".join(cell for _, line in read for cell in layout.cells(line) if layout.value(cell) is not None)
    if "," not in written or "." in written:
        return False
    _refuse_thousands(read, layout, request)
    return True


def _refuse_thousands(lines: list[tuple[int, str]], layout: Layout, request: Request) -> None:
    """Refuse a column such as 500, 1,000, 1,500, which decimal commas would turn into 500, 1, 1.5."""
    columns: dict[int, list[tuple[int, str]]] = {}
    for number, line in lines:
        for place, cell in enumerate(layout.cells(line)):
            if layout.value(cell) is not None:
                columns.setdefault(place, []).append((number, cell))
    for column in columns.values():
        parted = [(number, cell) for number, cell in column if "," in cell]
        whole = [cell for _, cell in column if _WHOLE.fullmatch(cell) and cell.strip("+-0")]
        alike = all(_THOUSANDS.fullmatch(cell) for _, cell in parted) and all(map(_BELOW_THOUSAND.fullmatch, whole))
        if parted and whole and alike:
            number, cell = parted[0]
            condition = f"distinguish decimal commas from thousands separators (line {number} has {quote(cell)})"
            raise request.error(condition, "write decimal points and no thousands separators")


def _choose_columns(table: Array, names: list[str], request: Request) -> tuple[int, int]:
    requested = {"position_column": request.position_column, "height_column": request.height_column}
    filled = [k for k in range(table.shape[1]) if not np.all(np.isnan(table[:, k]))]
    columns = {field: find_column(field, value, names) for field, value in requested.items() if value is not None}
    if len(columns) == 2:
        if columns["position_column"] == columns["height_column"]:
            condition = "differ from position_column"
            raise InputError("height_column", request.height_column, condition, "choose two columns")
        return columns["position_column"], columns["height_column"]
    if not columns and table.shape[1] > 2 and len(filled) == 2:
        return filled[0], filled[1]
    if table.shape[1] > 2:
        names = [name or f"column {k}" for k, name in enumerate(names, start=1)] if any(names) else []
        condition = f"hold two columns, or have two of its {table.shape[1]} chosen"
        condition += f" ({list_names(names)})" if names else ""
        raise request.error(condition, "give position_column and height_column, by number from 1 or by name")
    if columns:
        ((field, column),) = columns.items()
        return (column, 1 - column) if field == "position_column" else (1 - column, column)
    _refuse_swapped(table, request)
    return 0, 1


def _refuse_swapped(table: Array, request: Request) -> None:
    """Refuse columns that look swapped: the second is monotonic, as positions are, and the first is not."""
    first, second = (np.diff(column) for column in table[np.all(np.isfinite(table), axis=1)].T)
    back = min(int(np.sum(first < 0.0)), int(np.sum(first > 0.0)))
    if back and (np.all(second > 0.0) or np.all(second < 0.0)):
        condition = f"have its positions in the first column (it reverses in {back} places and the second in none)"
        raise request.error(condition, "give position_column = 2, or 1 if it really is the first")
