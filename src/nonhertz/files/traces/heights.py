"""Text of heights alone, one per line, whose step is given, or stated above them or by the first number."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from nonhertz.files.traces.dialects import read_dialect
from nonhertz.files.traces.heads import count_lines, counts_drop, find_step, quote, unit_of_heights
from nonhertz.files.traces.line import Line, Request, length_factor
from nonhertz.files.traces.text import COMMENT, LONGEST_HEAD, MARK, SAMPLED, value_in, without_comment
from nonhertz.measured.trace import FEWEST_POINTS, Array

_STATED_COUNT = re.compile(
    r"(?:num(?:ber)?[\W_]*(?:of[\W_]*)?points|points/scanline|punkte/zeile)\W+(\d{1,9})\b", re.IGNORECASE
)
_NUMBERS = re.compile(r"(?<![^\s;,|])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d+)?(?![^\s;,|])")
_PROFILES = re.compile(r"num(?:ber)?[\W_]*(?:of[\W_]*)?profiles\W+(\d+)\b", re.IGNORECASE)
_GIVE_STEP = "give step, such as '0.5 um', or write two columns of numbers, position and height"
_UM = "The first number is the distance of the points; it and the heights are in um, as in the files of NPL and NIST."
# The first number is not a height if it is this many times as far from the next as its neighbours are from each other,
# or has other digits behind the point than all of those.
_OFF, _NEIGHBOURS = 10.0, 20


@dataclass(frozen=True)
class Heights:
    """Lines of one number each, from the first to the last.

    Attributes
    ----------
    head : list of str
        The lines above them.
    cells : list of (int, str, float or None)
        Number, text and number of each line; None for what is no number.
    footer : str or None
        The first line below them.
    """

    head: list[str]
    cells: list[tuple[int, str, float | None]]
    footer: str | None


def find_heights(lines: Sequence[str], request: Request) -> Heights | None:
    """Return the lines of heights, None if the lines have columns.

    Commas are decimal commas if a step is given or stated above the numbers, and otherwise separate columns.
    """
    sample = [line.strip() for line in lines[:: len(lines) // SAMPLED + 1] if any(map(str.isdigit, line))]
    single = sum(_number(line) is not None for line in sample)
    if single <= sum(_number(line) is None and len(_NUMBERS.findall(line)) > 1 for line in sample):
        return None
    written = [(k, line.strip()) for k, line in enumerate(lines, start=1)]
    cells = [(k, line, _number(line)) for k, line in written if line]
    measured = [k for k, (_, _, value) in enumerate(cells) if value is not None and math.isfinite(value)]
    if not measured:
        return None
    head = [COMMENT.sub("", line, count=1) for _, line, _ in cells[: measured[0]]]
    body = cells[measured[0] : measured[-1] + 1]
    decimal_commas = sum("," in line.rstrip(",") for _, line, _ in body) > 0.5 * len(body)
    if len(head) > LONGEST_HEAD or (decimal_commas and request.step is None and not _step(head, request)[0]):
        return None
    footer = cells[measured[-1] + 1 :]
    return Heights(head, [cell for cell in body if not COMMENT.match(cell[1])], footer[0][1] if footer else None)


def read_heights(heights: Heights, request: Request) -> Line:
    """Return the measured line in a text of heights.

    Raises
    ------
    InputError
        If their step is neither given nor stated, their number is not that in the header, or a line is no height.
    """
    for column in ("position_column", "height_column"):
        if getattr(request, column) not in (None, 1, "1"):
            raise request.error("hold two columns of numbers (there is only one number per line)", _GIVE_STEP)
    step, known, request, notes = _step(heights.head, request)
    values, words = _values(heights.cells, request)
    values, step, about_first = _without_settings(heights, values, step, request)
    notes += about_first
    _check_counts(heights.head, len(values), request)
    unit, name = unit_of_heights(heights.head, request)
    unit = unit or ("um" if _UM in about_first else None)
    notes.append(f"Heights alone, {1e3 * step:.6g} um apart: positions count from the first.")
    if (unit or "mm") != "mm":
        notes.append(f"Heights were converted from {unit} to mm.")
    if words:
        notes.append(f"{count_lines(len(words))} words in place of a number, such as {quote(words[0])}.")
    if heights.footer is not None:
        notes.append(f"The text below the points was ignored ({quote(heights.footer)}).")
    drop = request.sense == "drop" or counts_drop(name, request)
    height = values * length_factor("unit", unit or "mm")
    return Line(step * np.arange(len(values), dtype=float), height, tuple(notes), (known, unit is not None), drop)


def _without_settings(heights: Heights, values: Array, step: float, request: Request) -> tuple[Array, float, list[str]]:
    """Return the heights below the number of points and the step, the step [mm], and notes on what was left out.

    Raises
    ------
    InputError
        If the step is not known.
    """
    notes = []
    if len(values) > FEWEST_POINTS and values[0] in (
        len(values) - 1,
        len(values) - 2,
    ):  # of heights, or of heights below their step
        notes.append(f"The first number, {values[0]:g}, is the number of points.")
        values = values[1:]
    first, apart = float(values[0]), _is_apart(heights, values)
    if not step and apart and not heights.head and first > 0.0:
        return values[1:], first * length_factor("unit", request.position_unit or "um"), [*notes, _UM]
    if not step:
        condition = "state the spacing of its points (there is one number per line and no position"
        raise request.error(condition + (f"; the first, {first:g}, may be it)" if apart else ")"), _GIVE_STEP)
    if apart and any(math.isclose(step, first * unit, rel_tol=1e-6) for unit in (1.0, 1e-3, 1e-6, 1e3)):
        notes.append(f"The first number, {first:g}, is the distance of the points.")
        values = values[1:]
    return values, step, notes


def _number(line: str) -> float | None:
    """Return the number that a line is, with a decimal point or comma, a mark or a separator behind it or neither."""
    try:
        return float(line) if line.isascii() and line[-1:].isdigit() and "_" not in line else _number_beside_mark(line)
    except ValueError:
        return _number_beside_mark(line)


def _number_beside_mark(line: str) -> float | None:
    cell = MARK.sub("", without_comment(line)).strip(' \t;|,"')
    return value_in(cell.replace(",", ".", 1) if "." not in cell else cell)


def _step(head: Sequence[str], request: Request) -> tuple[float, bool, Request, list[str]]:
    """Return the step [mm], 0 if it is not known, whether its unit is, and the request with what the head defines."""
    defaults, note = read_dialect(head)
    notes = [note] if note else []
    unset = {key: value for key, value in defaults.items() if key != "step" and getattr(request, key) is None}
    request = replace(request, **unset)
    if request.step is not None:
        return request.step, True, request, notes
    if "step" in defaults:
        return length_factor("step", str(defaults["step"])), True, request, notes
    stated = find_step(head, request)
    if stated is None:
        return 0.0, True, request, notes
    value, unit = stated
    return value * length_factor("unit", unit or "mm"), unit is not None, request, notes


def _values(cells: Sequence[tuple[int, str, float | None]], request: Request) -> tuple[Array, list[str]]:
    """Return the heights, NaN for words without digits, and these words."""
    words = [line for _, line, value in cells if value is None]
    for number, line, value in cells:
        if value is None and any(map(str.isdigit, line)):
            condition = f"hold one number in line {number} as elsewhere (there is {quote(line)})"
            raise request.error(condition, "correct or delete that line; write nan where nothing was measured")
    return np.array([math.nan if value is None else value for _, _, value in cells]), words


def _is_apart(heights: Heights, values: Array) -> bool:
    """Return whether the first number is not a height: far from those that follow, or written differently."""
    if len(values) < 3:
        return False
    steps = np.abs(np.diff(values[1 : _NEIGHBOURS + 2]))
    off = abs(values[0] - values[1]) > _OFF * max(float(np.nanmax(steps)) if np.any(np.isfinite(steps)) else 0.0, 1e-9)
    first, *others = (len(line.partition(".")[2]) for _, line, _ in heights.cells[-len(values) :][: _NEIGHBOURS + 2])
    return bool(off or (len(set(others)) == 1 and first not in others))


def _check_counts(head: Sequence[str], count: int, request: Request) -> None:
    text = "\n".join(head)
    if (profiles := _PROFILES.search(text)) and int(profiles[1]) > 1:
        raise request.error(f"hold one profile (it states {profiles[1][:20]})", "extract one line")
    if (stated := _STATED_COUNT.search(text)) and int(stated[1]) != count:
        condition = f"hold the {stated[1]} heights stated in its header (there are {count})"
        raise request.error(condition, "export it again; this file is truncated")
