"""The common parts of drawings along the axis: the bodies' ends, marks, the heading and number formatting."""

from __future__ import annotations

from collections.abc import Iterable

from nonhertz.amounts import Amount, format_input
from nonhertz.plot.axes import Alignment, Axes, note
from nonhertz.plot.style import SMALL_SIZE

LETTER = 0.55 * SMALL_SIZE / 72.0
"""Mean width of a small letter [inch]."""


def number(value: float, digits: int = 4) -> str:
    """Return ``value`` to a number of significant digits, with a true minus sign.

    Examples
    --------
    >>> number(-8.31249), number(2431.7), number(0.0)
    ('−8.312', '2432', '0')
    """
    return format_input(value, digits).replace("-", "−").replace("inf", "∞")


def written(value: Amount, digits: int = 4) -> str:
    """Return numbers to ``digits`` significant digits with their unit, as `number` writes them.

    Examples
    --------
    >>> from nonhertz.amounts import mm, mpa
    >>> written(mpa(2431.7)), written(mm(-1.5, 0.25, between=" and "))
    ('2432 MPa', '−1.5 and 0.25 mm')
    """
    return f"{value:.{digits}g}".replace("-", "−")


def width_of(ax: Axes, words: str) -> float:
    """Return the width of small words as a share of that of the axes.

    Measuring a text needs a renderer, which axes lack before they are drawn; an average letter width will do.
    """
    return len(words) * LETTER * ax.figure.dpi / ax.bbox.width


def alignment(ax: Axes, y: float, span: tuple[float, float], words: str) -> Alignment:
    """Return how to align small ``words`` at ``y`` so that they stay inside the axes."""
    half = 0.5 * width_of(ax, words)
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
