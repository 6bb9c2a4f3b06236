"""Any figure that is a value, drawn with matplotlib: on axes that there are, or on a sheet of its own."""

from __future__ import annotations

import functools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.figures.value import (
    Across,
    Band,
    Dimension,
    Figure,
    Level,
    Line,
    Mark,
    Panel,
    Points,
    Range,
    Side,
    Span,
    Steps,
    Words,
)
from nonhertz.plot import style
from nonhertz.plot.axes import ROUND, Array, Axes, key_above, note
from nonhertz.plot.axes import Figure as Sheet
from nonhertz.plot.axial import alignment
from nonhertz.plot.sheets import stacked

COLOURS: Final = {"first": style.FIRST, "second": style.SECOND, "ink": style.INK, "faint": style.FAINT_INK}
DASHES: Final[dict[str, Any]] = {
    "solid": "-", "dashed": "--", "dotted": style.HINT_DASHES, "ends": style.END_DASHES,
}  # fmt: skip
DOTS: Final = 100.0  # of a screen, in an inch
HEAD: Final = 0.36  # inch, above each panel, for its legend
APART: Final = 1.7  # by which a second panel on the same axes is drawn lower
ARROW: Final[dict[str, Any]] = {"arrowstyle": "<->,head_length=0.25,head_width=0.12", "shrinkA": 0.0, "shrinkB": 0.0}
OVER_LINES: Final[dict[str, Any]] = {"va": "bottom", "color": style.INK, "bbox": style.BACKING}
"""Of words above a point, on a background that hides thin lines."""


def sheet_of(figure: Figure, title: str = "", conditions: Sequence[str] = ()) -> Sheet:
    """Return a sheet with the panels of a figure one below the other."""
    heights = [panel.height / DOTS for panel in figure.panels]
    words = "; ".join([figure.conditions, *(panel.remark for panel in figure.panels if panel.remark)])
    sheet, axes = stacked([HEAD] * len(heights), heights, title, conditions or [typeset(words)])
    for ax, panel in zip(axes, figure.panels, strict=True):
        _draw_panel(panel, figure, ax, last=ax is axes[-1])
        _draw_key(ax)
    return sheet


def draw_on(figure: Figure, ax: Axes) -> Axes:
    """Draw the first panel of a figure on axes, and a second one on a twin of these with its axis to the right."""
    first, *more = figure.panels
    _draw_panel(first, figure, ax)
    several = [ax]
    for panel in more:
        twin = ax.twinx()
        _draw_panel(panel, figure, twin)
        # In a line contact both curves have the same shape.
        twin.set_ylim(0.0, APART * twin.get_ylim()[1])
        twin.spines[["right"]].set_visible(True)
        for axes, of in ((ax, first), (twin, panel)):
            axes.yaxis.label.set_color(COLOURS[next(mark.colour for mark in of.marks if isinstance(mark, Line))])
        several.append(twin)
    _draw_key(*several)
    words = typeset(figure.conditions)
    ax.set_title(f"{words}; {first.remark}" if first.remark else words, loc="left", pad=18.0)
    return ax


def typeset(words: str) -> str:
    """Return words with a true minus sign, and powers as matplotlib sets them.

    Examples
    --------
    >>> typeset("from -8.3 to 2 mm, non-convex, s^0.226")
    'from −8.3 to 2 mm, non-convex, s$^{0.226}$'
    """
    return re.sub(r"\^([\d.]+)", r"$^{\1}$", re.sub(r"(?<![\w^])-(?=[\d.])", "−", words.replace("$", r"\$")))


@dataclass(frozen=True)
class _Pen:
    """Axes, and what turns numbers of a figure into those that are drawn."""

    ax: Axes
    across: float
    up: float
    span: Range | None

    def along(self, values: ArrayLike) -> Array:
        return self.across * np.asarray(values, dtype=float)

    def upright(self, values: ArrayLike) -> Array:
        return self.up * np.asarray(values, dtype=float)

    def point(self, x: float, y: float) -> tuple[float, float]:
        return self.across * x, self.up * y


def _draw_panel(panel: Panel, figure: Figure, ax: Axes, *, last: bool = True) -> None:
    (across, _), (up, _) = figure.along.scale, panel.upright.scale
    pen = _Pen(ax, across, up, figure.along.range)
    for mark in panel.marks:
        _draw(mark, pen)
    ax.locator_params(axis="x", steps=ROUND)
    for axis, factor, limit in ((figure.along, across, ax.set_xlim), (panel.upright, up, ax.set_ylim)):
        if axis.range is not None:
            limit(*(factor * end for end in axis.range))
    ax.set_ylabel(panel.upright.title())
    ax.set_xlabel(figure.along.title() if last else "")
    ax.tick_params(labelbottom=last)
    ax.spines[["top", "right"]].set_visible(False)


def _draw_key(ax: Axes, *others: Axes) -> None:
    """Write the legend of all marks with a name, on these axes and on others, above the first."""
    entries: dict[str, Any] = {}
    for axes in (ax, *others):
        entries |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    if entries:
        key_above(ax, [*entries.values()], [*entries], columns=len(entries), handlelength=2.2)


def _look(mark: Mark) -> dict[str, Any]:
    return {"color": COLOURS[mark.colour], "linestyle": DASHES[mark.dash], "label": typeset(mark.name) or None}


@functools.singledispatch
def _draw(mark: Mark, pen: _Pen) -> None:
    raise TypeError(f"cannot draw {type(mark).__name__}")


@_draw.register
def _(mark: Line, pen: _Pen) -> None:
    pen.ax.plot(pen.along(mark.x), pen.upright(mark.y), linewidth=style.LINE, **_look(mark))


@_draw.register
def _(mark: Steps, pen: _Pen) -> None:
    steps, colour = (pen.upright(mark.y), pen.along(mark.edges)), COLOURS[mark.colour]
    pen.ax.stairs(*steps, fill=True, color=colour, alpha=0.10, linewidth=0.0)
    pen.ax.stairs(*steps, color=colour, alpha=0.45, linewidth=style.HAIR)


@_draw.register
def _(mark: Band, pen: _Pen) -> None:
    edges = pen.along(mark.x), pen.upright(mark.low), pen.upright(mark.high)
    pen.ax.fill_between(*edges, facecolor=COLOURS[mark.colour], alpha=0.16, linewidth=0.0, label=mark.name or None)


@_draw.register
def _(mark: Points, pen: _Pen) -> None:
    look: dict[str, Any] = {"color": COLOURS[mark.colour], "markerfacecolor": "white", "label": mark.name or None}
    pen.ax.plot(pen.along(mark.x), pen.upright(mark.y), "o", markersize=4.0, **look)


@_draw.register
def _(mark: Span, pen: _Pen) -> None:
    ends = pen.along([mark.low, mark.high])
    pen.ax.axvspan(*ends, facecolor=style.PALE, edgecolor="none", zorder=0.5, label=mark.name or None)


@_draw.register
def _(mark: Across, pen: _Pen) -> None:
    place = pen.across * mark.x
    pen.ax.axvline(place, linewidth=style.THIN, zorder=1.5, **_look(mark))
    if mark.words and pen.span:
        # On the side away from what is drawn.
        side: Side = "left" if mark.x > 0.5 * sum(pen.span) else "right"
        note(
            pen.ax, mark.words, (place, 0.5), side, 3.0, across=True, rotation=90.0, va="center", color=style.FAINT_INK
        )


@_draw.register
def _(mark: Level, pen: _Pen) -> None:
    pen.ax.axhline(pen.up * mark.y, linewidth=style.HAIR, zorder=1.0, **_look(mark))


@_draw.register
def _(mark: Dimension, pen: _Pen) -> None:
    low, high = pen.point(mark.low, mark.y), pen.point(mark.high, mark.y)
    arrow = ARROW | {"color": COLOURS[mark.colour], "linewidth": style.THIN}
    pen.ax.annotate("", low, xytext=high, arrowprops=arrow)
    _write(mark.words, 0.5 * (mark.low + mark.high), mark.y, "center", pen)


@_draw.register
def _(mark: Words, pen: _Pen) -> None:
    _write(mark.words, mark.x, mark.y, mark.side, pen)


def _write(words: str, x: float, y: float, side: Side, pen: _Pen) -> None:
    """Write words above a point, inside the axes if they are to be in its middle."""
    if not words:
        return
    if side == "center" and pen.span:
        side = alignment(pen.ax, x, pen.span, words)
    note(pen.ax, typeset(words), pen.point(x, y), side, 3.0, 4.0, **OVER_LINES)
