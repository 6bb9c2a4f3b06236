"""Any figure that is a value, drawn with matplotlib: on axes that there are, or on a sheet of its own."""

from __future__ import annotations

import functools
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.figures.value import (
    Across,
    Area,
    Axis,
    Band,
    Bar,
    Cells,
    Contours,
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
from nonhertz.plot.axial import LETTER, alignment, number
from nonhertz.plot.contours import draw_contours, label_contours
from nonhertz.plot.round import round_sheet
from nonhertz.plot.sheets import BAR_ROOM, HIGHEST_PANEL, LEFT, MARGIN, NUMBERS, WIDTH, bar_beside, stacked, stretch_of
from nonhertz.plot.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.contour import ContourSet

DASHES: Final[dict[str, Any]] = {
    "solid": "-", "dashed": "--", "chain": (0, (6, 1.5, 1.2, 1.5)), "dotted": style.HINT_DASHES, "long": (0, (8, 2)),
    "mixed": (0, (3, 1, 1, 1, 1, 1)), "ends": style.END_DASHES,
}  # fmt: skip
LOWEST: Final = 0.5  # inch, of a panel in true proportions
HEADS: Final = 0.24, 0.6  # inch, above such a panel and the stretched one below it
SYMBOLS: Final = {"circle": ("o", 4.0), "diamond": ("D", 5.0), "triangle": ("^", 4.0), "dot": (".", 4.0)}
TITLE_ABOVE, ROW_OF_KEY, SAMPLE = 7.0, 11.5, 7  # points above a legend, and of a row of it; letters that a sample takes
DOTS: Final = 100.0  # of a screen, in an inch
ACROSS: Final = 65  # points across an area: equally spaced in the angle whose sine is the share of the way to its edge
HEAD: Final = 0.36  # inch, above each panel, for its legend
LETTERS: Final = 96  # of the conditions, that fit in a line
APART: Final = 1.7  # by which a second panel on the same axes is drawn lower
ARROW: Final[dict[str, Any]] = {"arrowstyle": "<->,head_length=0.25,head_width=0.12", "shrinkA": 0.0, "shrinkB": 0.0}
OVER_LINES: Final[dict[str, Any]] = {"va": "bottom", "color": style.INK, "bbox": style.BACKING}
"""Of words above a point, on a background that hides thin lines."""


def sheet_of(figure: Figure, title: str = "") -> Sheet:
    """Return a sheet with the panels of a figure, round ones side by side, all others one below the other."""
    sheet = _laid_out(figure, title)
    if figure.has_lines:
        NUMBERS[sheet] = figure.to_csv()
    return sheet


def _laid_out(figure: Figure, title: str) -> Sheet:
    first = figure.panels[0]
    if first.round:
        return round_sheet(figure, title, _lines(figure.conditions))
    if first.proportional:
        return _proportional_sheet(figure, title)
    words = "; ".join([figure.conditions, *(panel.remark for panel in figure.panels if panel.remark)])
    heights = [panel.height / DOTS for panel in figure.panels]
    if first.colours:
        sheet, axes = stacked([HEAD] * len(heights), heights, title, _lines(figure.conditions), right=BAR_ROOM)
        draw_colour_bar(first, axes[-1], cax=bar_beside(*axes, most=2.0 * heights[0] + HEAD))
    else:
        rows = [max(map(len, _columns_of_key([panel], WIDTH - LEFT - MARGIN)), default=1) for panel in figure.panels]
        sheet, axes = stacked([HEAD + ROW_OF_KEY / 72.0 * (row - 1) for row in rows], heights, title, _lines(words))
    for ax, panel in zip(axes, figure.panels, strict=True):
        draw_panel(panel, figure, ax, last=ax is axes[-1])
        if panel.colours:
            entitle(panel, ax)
        draw_key([panel], ax)
    return sheet


def entitle(panel: Panel, ax: Axes) -> None:
    """Write the heading of a panel to the left and its remark to the right above it."""
    ax.set_title(panel.heading, loc="left", fontsize=style.SMALL_SIZE, pad=3.0)
    ax.set_title(typeset(panel.remark), loc="right", fontsize=style.SMALL_SIZE, pad=3.0)


def _lines(words: str) -> list[str]:
    """Return parts of words in lines that are not too long, none of which begins within a part."""
    parts = [part for part in typeset(words).split("; ") if part]
    lines = parts[:1]
    for part in parts[1:]:
        joined = f"{lines[-1]}; {part}"
        lines[-1:] = [joined] if len(joined) <= LETTERS else [lines[-1], part]
    return lines


def _proportional_sheet(figure: Figure, title: str) -> Sheet:
    """Return a sheet with a panel in true proportions, or stretched where that would be a thin band.

    A roller's contact may be 50 times as long as wide; a thin area is drawn both ways. The panels' shapes are computed
    here, so that the axes' limits need not be widened to fit them.
    """
    (panel,) = figure.panels
    assert panel.upright.range is not None
    assert figure.along.range is not None
    tall, wide = (abs(high - low) for low, high in (panel.upright.range, figure.along.range))
    width = WIDTH - LEFT - BAR_ROOM
    # Narrower rather than squeezed, down to half of the width.
    width *= min(max(HIGHEST_PANEL * wide / (width * tall), 0.5), 1.0)
    natural = width * tall / wide
    stretch = stretch_of(natural)
    heights = {stretch: stretch * natural}
    area = any(isinstance(mark, Area) for mark in panel.marks)
    if area and stretch >= 2.0:
        heights = {1.0: max(natural, LOWEST)} | heights
    rows = max(map(len, _columns_of_key([panel], width)), default=0)
    heads = HEADS[: len(heights)] if area else [(TITLE_ABOVE + ROW_OF_KEY * (rows + 1.5)) / 72.0]
    right = WIDTH - LEFT - width
    sheet, several = stacked(heads, [*heights.values()], title, _lines(figure.conditions), right=right)
    for ax, times in zip(several, heights, strict=True):
        draw_panel(panel, figure, ax, last=ax is several[-1], stretch=times)
        draw_key([panel], ax)
        words = proportions(panel, times, "" if area else panel.heading)
        ax.set_title(words, loc="left", fontsize=style.SMALL_SIZE, pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    draw_colour_bar(panel, several[-1], cax=bar_beside(several[-1]))
    return sheet


def draw_on(figure: Figure, ax: Axes) -> Axes:
    """Draw the first panel of a figure on axes, and a second one on a twin of these with its axis to the right."""
    first, *more = figure.panels
    draw_panel(first, figure, ax)
    several = [ax]
    for panel in more:
        twin = ax.twinx()
        draw_panel(panel, figure, twin)
        # In a line contact both curves have the same shape.
        twin.set_ylim(0.0, APART * twin.get_ylim()[1])
        twin.spines[["right"]].set_visible(True)
        for axes, of in ((ax, first), (twin, panel)):
            axes.yaxis.label.set_color(COLOURS[next(mark.colour for mark in of.marks if isinstance(mark, Line))])
        several.append(twin)
    rows = draw_key(figure.panels, *several)
    words = typeset(figure.conditions)
    ax.set_title(f"{words}; {first.remark}" if first.remark else words, loc="left", pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    return ax


def draw_proportional(figure: Figure, ax: Axes, *, stretch: float = 1.0, bar: Axes | None = None) -> Axes:
    """Draw the only panel of a figure on axes, which are made smaller to fit its shape, with its colour bar."""
    (panel,) = figure.panels
    draw_panel(panel, figure, ax, stretch=stretch)
    rows = draw_key([panel], ax)
    words = f"{typeset(figure.conditions)}; {proportions(panel, stretch, panel.heading[0].lower() + panel.heading[1:])}"
    ax.set_title(words, loc="left", pad=TITLE_ABOVE + ROW_OF_KEY * rows)
    draw_colour_bar(panel, ax, **({"ax": ax} if bar is None else {"cax": bar}))
    return ax


def draw_panel(panel: Panel, figure: Figure, ax: Axes, *, last: bool = True, stretch: float = 1.0) -> None:
    """Draw a panel of a figure on axes; of a proportional one the upright axis is stretched."""
    (across, _), (up, _) = figure.along.scale, panel.upright.scale
    pen = _Pen(ax, across, up, figure.along.range, panel.colours)
    for mark in panel.marks:
        _draw(mark, pen)
    ax.locator_params(axis="both" if panel.colours else "x", steps=ROUND)
    for axis, set_scale in ((figure.along, ax.set_xscale), (panel.upright, ax.set_yscale)):
        if axis.logarithmic:
            set_scale("log")
    for axis, factor, limit in ((figure.along, across, ax.set_xlim), (panel.upright, up, ax.set_ylim)):
        if axis.range is not None:
            # Automatic limits stay on where matplotlib is to widen them, or it would warn that it does.
            limit(*(factor * end for end in axis.range), auto=panel.proportional or None)
    if panel.proportional:
        ax.set_aspect(stretch, adjustable="box" if pen.contours else "datalim")
    for mark, lines in pen.contours:
        assert panel.colours is not None
        label_contours(lines, mark, pen.along(mark.x), pen.upright(mark.y), panel.colours.scale[0], panel, ax)
    if figure.along.ticks:
        ax.set_xticks(*zip(*((across * place, words) for place, words in figure.along.ticks), strict=True))
    ax.set_ylabel(panel.upright.title())
    ax.set_xlabel(figure.along.title() if last else "")
    ax.tick_params(labelbottom=last or panel.proportional)
    ax.spines[["top", "right"]].set_visible(panel.colours is not None)


def proportions(panel: Panel, stretch: float, heading: str = "") -> str:
    """Return a heading with how a proportional panel is stretched, and what else is to be known of it."""
    symbol, times = (panel.upright.symbol, stretch) if stretch > 1.0 else ("y", 1.0 / stretch)
    true = "true proportions" if heading else "True proportions"
    words = [heading, true if stretch == 1.0 else f"{symbol} stretched {number(times)} times", panel.remark]
    return typeset("; ".join(part for part in words if part))


def draw_colour_bar(panel: Panel, ax: Axes, /, **where: Any) -> None:
    """Draw what the colours of a panel on axes stand for, with an arrow if there are values beyond."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.contour import ContourSet

    colours = panel.colours
    assert colours is not None
    bands = next((drawn for drawn in ax.collections if isinstance(drawn, ContourSet) and drawn.filled), None)
    if bands is not None:
        ax.figure.colorbar(bands, label=colours.title(), **where)
        return
    bar = ScalarMappable(_normalised(colours), style.COLOUR_MAP)
    ax.figure.colorbar(bar, label=colours.title(), extend="max" if colours.cut else "neither", **where)


def typeset(words: str) -> str:
    """Return words with a true minus sign, and powers and directions of stresses as matplotlib sets them.

    Examples
    --------
    >>> typeset("from -8.3 to 2 mm, non-convex, s^0.226")
    'from −8.3 to 2 mm, non-convex, s$^{0.226}$'
    """
    true_minus = re.sub(r"(?<![\w^])-(?=[\d.])", "−", words.replace("$", r"\$"))
    return re.sub(r"(\^|(?<=τ)_)([\d.]+|xz)", r"$\1{\2}$", true_minus)


@dataclass(frozen=True)
class _Pen:
    """Axes, and what turns numbers of a figure into those that are drawn."""

    ax: Axes
    across: float
    up: float
    span: Range | None
    colours: Axis | None
    contours: list[tuple[Contours, ContourSet]] = field(default_factory=list)

    def along(self, values: ArrayLike) -> Array:
        return self.across * np.asarray(values, dtype=float)

    def upright(self, values: ArrayLike) -> Array:
        return self.up * np.asarray(values, dtype=float)

    def point(self, x: float, y: float) -> tuple[float, float]:
        return self.across * x, self.up * y


def draw_key(panels: Sequence[Panel], *several: Axes) -> int:
    """Write the legend of panels, drawn on these axes, above the first of them; return its rows."""
    from matplotlib.lines import Line2D

    ax, drawn = several[0], dict[str, Any]()
    for axes in several:
        drawn |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    columns = _columns_of_key(panels, ax.bbox.width / ax.figure.dpi)
    rows = max(map(len, columns), default=0)
    if not rows:
        return 0
    # A legend is filled column by column: blanks make all equally long.
    words = [entry for column in columns for entry in (*column, *[""] * (rows - len(column)))]
    samples = [drawn.get(entry) or Line2D([], [], linestyle="none") for entry in words]
    narrow = {"borderaxespad": 0.4, "handlelength": 1.8, "handletextpad": 0.5, "columnspacing": 1.4}
    key_above(ax, samples, words, columns=len(columns), **({"handlelength": 2.2} if rows == 1 else narrow))
    return rows


def _columns_of_key(panels: Sequence[Panel], width: float) -> list[list[str]]:
    """Return the entries of a legend in as many columns as fit into a width [inch], or points beside all else."""
    named = [mark for panel in panels for mark in panel.marks if mark.name]
    points = {typeset(mark.name): isinstance(mark, Points) for mark in named}
    if _wide(alone := [[words] for words in points]) <= width:
        return alone
    if len({*points.values()}) == 2:
        return [[words for words, point in points.items() if point is first] for first in (True, False)]
    entries, count = [*points], len(points)
    splits = ([entries[at : at + rows] for at in range(0, count, rows)] for rows in range(2, count + 1))
    return next((split for split in splits if _wide(split) <= width), [entries])


def _wide(columns: Sequence[Sequence[str]]) -> float:
    """Return the width [inch] of a legend of columns."""
    return LETTER * sum(max(len(words) + SAMPLE for words in column) for column in columns)


def _normalised(colours: Axis) -> Any:
    from matplotlib.colors import Normalize

    low, high = colours.range or (0.0, 1.0)
    return Normalize(colours.scale[0] * low, colours.scale[0] * high)


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
    pen.ax.fill_between(*edges, facecolor=COLOURS[mark.colour], alpha=0.16, linewidth=0.0, label=_look(mark)["label"])


@_draw.register
def _(mark: Area, pen: _Pen) -> None:
    assert pen.colours is not None
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, ACROSS)[:, None]
    # At the sine of an angle the root of 1 - s^2 is its cosine; a semi-ellipse falls vertically at its edge.
    values = pen.colours.scale[0] * np.cos(angle) ** (2.0 * mark.power) * mark.values
    x, y = np.broadcast_to(pen.along(mark.x), values.shape), pen.upright(np.sin(angle) * mark.half_height)
    # Thousands of small polygons in an SVG file would show seams, so that the values are rasterised.
    look: dict[str, Any] = {"cmap": style.COLOUR_MAP, "norm": _normalised(pen.colours), "rasterized": True}
    pen.ax.pcolormesh(x, y, values, shading="gouraud", zorder=1.0, **look)
    closed = [np.concatenate([row, back[::-1], row[:1]]) for row, back in ((x[0], x[0]), (y[-1], y[0]))]
    pen.ax.plot(*closed, color=style.INK, linewidth=style.THIN, solid_joinstyle="round")


@_draw.register
def _(mark: Cells, pen: _Pen) -> None:
    assert pen.colours is not None
    look: dict[str, Any] = {"cmap": style.COLOUR_MAP, "norm": _normalised(pen.colours), "rasterized": True}
    values = np.ma.masked_invalid(pen.colours.scale[0] * mark.values.T)
    pen.ax.pcolormesh(pen.along(mark.x), pen.upright(mark.y), values, zorder=1.0, **look)


@_draw.register
def _(mark: Contours, pen: _Pen) -> None:
    assert pen.colours is not None
    lines = draw_contours(mark, pen.along(mark.x), pen.upright(mark.y), pen.colours, pen.ax)
    pen.contours.append((mark, lines))


@_draw.register
def _(mark: Bar, pen: _Pen) -> None:
    look = _look(mark) | {"linewidth": 2.4, "solid_capstyle": "butt", "zorder": 2.5, "clip_on": False}
    pen.ax.plot(pen.along([mark.low, mark.high]), pen.upright([mark.y, mark.y]), **look)


@_draw.register
def _(mark: Points, pen: _Pen) -> None:
    (marker, size), colour = SYMBOLS[mark.symbol], COLOURS[mark.colour]
    look: dict[str, Any] = {"color": colour, "markerfacecolor": colour if mark.symbol == "dot" else "white"}
    if pen.colours:
        # A small symbol may lie on a larger one.
        look |= {"markeredgewidth": style.THIN, "clip_on": False, "zorder": 4.0 - 0.1 * size}
    look |= {"linestyle": "none", "markersize": size, "label": typeset(mark.name) or None}
    pen.ax.plot(pen.along(mark.x), pen.upright(mark.y), marker, **look)


@_draw.register
def _(mark: Span, pen: _Pen) -> None:
    ends = pen.along([mark.low, mark.high])
    pen.ax.axvspan(*ends, facecolor=style.PALE, edgecolor="none", zorder=0.5, label=_look(mark)["label"])


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
    _write(mark.words, mark.x, mark.y, mark.side, pen, color=COLOURS[mark.colour])


def _write(words: str, x: float, y: float, side: Side, pen: _Pen, **look: Any) -> None:
    """Write words above a point, inside the axes if they are to be in its middle."""
    if not words:
        return
    if side == "center" and pen.span:
        side = alignment(pen.ax, x, pen.span, words)
    note(pen.ax, typeset(words), pen.point(x, y), side, 3.0, 4.0, **OVER_LINES | look)
