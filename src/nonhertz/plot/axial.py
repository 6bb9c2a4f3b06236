"""What all drawings along the axis share: the bodies' ends, marks, the heading and number formatting."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from nonhertz.amounts import Amount, format_input, mm
from nonhertz.plot.axes import Alignment, Axes, measure, note
from nonhertz.plot.style import BACKING, END_DASHES, FAINT_INK, INK, SMALL_SIZE, THIN
from nonhertz.result.along import axial_range, ends_in_sight, unlimited_ends
from nonhertz.result.solution import Solution

LETTER = 0.55 * SMALL_SIZE / 72.0
"""Mean width of a small letter [inch]."""


def draw_body_ends(solution: Solution, ax: Axes, *, named: bool = True) -> None:
    """Draw a dash-dot line where a body ends, its name beside it on the side away from the contact."""
    middle, length = 0.5 * sum(axial_range(solution)), measure("mm")
    for end, name in ends_in_sight(solution).items():
        at = float(length(end))
        ax.axvline(at, color=FAINT_INK, linewidth=THIN, linestyle=END_DASHES, zorder=1.5)
        if named and name:
            side = _side(end > middle)
            note(ax, name, (at, 0.5), side, 3.0, across=True, rotation=90.0, va="center", color=FAINT_INK)


def mark_unlimited(solution: Solution, ax: Axes) -> None:
    """Write "no limit" at every end where the pressure has none, on the side of the contact."""
    for edge in unlimited_ends(solution):
        at, side = (float(measure("mm")(edge.y)), 0.98), _side(edge is solution.edge_pressure[0])
        note(ax, "no limit", at, side, 6.0, across=True, va="top", color=INK, bbox=BACKING)


def _side(to_the_right: bool) -> Alignment:
    return "left" if to_the_right else "right"


def number(value: float, digits: int = 4) -> str:
    """Return ``value`` to a number of significant digits, with a true minus sign.

    Examples
    --------
    >>> number(-8.31249), number(2431.7), number(0.0)
    ('−8.312', '2432', '0')
    """
    return format_input(value, digits).replace("-", "−").replace("inf", "∞")


def written(found: Amount, digits: int = 4) -> str:
    """Return numbers to so many significant digits with their unit, as `number` writes them.

    Examples
    --------
    >>> from nonhertz.amounts import mpa
    >>> written(mpa(2431.7)), written(mm(-1.5, 0.25, between=" and "))
    ('2432 MPa', '−1.5 and 0.25 mm')
    """
    return f"{found:.{digits}g}".replace("-", "−")


def place(span: tuple[float, float], *y: float, between: str = " and ") -> str:
    """Return positions [mm] with as many decimals as the drawn ``span`` can show, and their unit."""
    factor, unit = mm().scale
    decimals = max(0, 2 - int(np.floor(np.log10(factor * (span[1] - span[0])))) + 1)
    texts = (f"{factor * each:.{decimals}f}" for each in y)
    shown = ((text[1:] if float(text) == 0.0 and text.startswith("-") else text).replace("-", "−") for text in texts)
    return f"{between.join(shown)} {unit}"


def alignment(ax: Axes, y: float, span: tuple[float, float], words: str) -> Alignment:
    """Return how to align small ``words`` at ``y`` so that they stay inside the axes."""
    # Measuring a text needs a renderer, which axes lack before they are drawn; an average letter width will do.
    width = ax.bbox.width / ax.figure.dpi
    half = 0.5 * len(words) * LETTER / width
    share = (y - span[0]) / (span[1] - span[0])
    if share < half:
        return "left"
    return "right" if share > 1.0 - half else "center"


def write_above(marks: Iterable[tuple[float, str]], ax: Axes, height: float) -> int:
    """Write words above the axes at places along, on lines [point] where they would overlap; return how many lines."""
    ends: list[float] = []  # of the words on each line, in shares of the axes
    letter = LETTER * ax.figure.dpi / ax.bbox.width
    for place, words in sorted(marks):
        at = float(ax.transAxes.inverted().transform(ax.transData.transform((place, ax.get_ylim()[1])))[0])
        half = 0.5 * letter * (len(words) + 1)
        line = next((number for number, end in enumerate(ends) if end <= at - half), len(ends))
        ends[line : line + 1] = [at + half]
        note(ax, words, (place, 1.0), "center", above=2.0 + height * line, across=True)
    return len(ends)
