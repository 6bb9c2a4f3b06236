"""How each mark of a figure is drawn with matplotlib."""

from __future__ import annotations

import functools
import re
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
    Bars,
    Cells,
    Contours,
    Dimension,
    Level,
    Line,
    Mark,
    Panel,
    Points,
    Range,
    Side,
    Span,
    Steps,
    Whiskers,
    Words,
)
from nonhertz.plot import style
from nonhertz.plot.axes import Array, Axes, note
from nonhertz.plot.axial import alignment, width_of
from nonhertz.plot.contours import draw_contours
from nonhertz.plot.style import COLOURS

if TYPE_CHECKING:
    from matplotlib.contour import ContourSet

DASHES: Final[dict[str, Any]] = {
    "solid": "-", "dashed": "--", "chain": (0, (6, 1.5, 1.2, 1.5)), "dotted": style.HINT_DASHES, "long": (0, (8, 2)),
    "mixed": (0, (3, 1, 1, 1, 1, 1)), "ends": style.END_DASHES, "none": "none",
}  # fmt: skip
SYMBOLS: Final = {
    "circle": ("o", 4.0),
    "diamond": ("D", 5.0),
    "triangle": ("^", 4.0),
    "cross": ("x", 4.0),
    "dot": (".", 4.0),
}
FEW, MANY = 20, 0.75  # points, of which more are smaller, and by how much
ACROSS: Final = 65  # points across an area: equally spaced in the angle whose sine is the share of the way to its edge
ARROW: Final[dict[str, Any]] = {"arrowstyle": "<->,head_length=0.25,head_width=0.12", "shrinkA": 0.0, "shrinkB": 0.0}
WIDER: Final = 1.2  # than small letters are capitals and digits, and a gap beside them
HIGHEST: Final = 0.9  # of the axes, at which words above lines still fit
OVER_LINES: Final[dict[str, Any]] = {"va": "bottom", "color": style.INK, "bbox": style.BACKING}
"""Of words above a point, on a background that hides thin lines."""


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
class Pen:
    """Axes, what turns numbers of a figure into those that are drawn, and the panel."""

    ax: Axes
    across: float
    up: float
    span: Range | None
    panel: Panel
    contours: list[tuple[Contours, ContourSet]] = field(default_factory=list)

    def along(self, values: ArrayLike) -> Array:
        """Return places along as they are drawn."""
        return self.across * np.asarray(values, dtype=float)

    def upright(self, values: ArrayLike) -> Array:
        """Return upright places and values as they are drawn."""
        return self.up * np.asarray(values, dtype=float)

    def point(self, x: float, y: float) -> tuple[float, float]:
        """Return a point as it is drawn."""
        return self.across * x, self.up * y


def colour_scale(colours: Axis) -> Any:
    """Return what turns values as they are drawn into shares of the colour map."""
    from matplotlib.colors import Normalize

    low, high = colours.range or (0.0, 1.0)
    return Normalize(colours.scale[0] * low, colours.scale[0] * high)


def _look(mark: Mark) -> dict[str, Any]:
    return {"color": COLOURS[mark.colour], "linestyle": DASHES[mark.dash], "label": typeset(mark.name) or None}


@functools.singledispatch
def draw_mark(mark: Mark, pen: Pen) -> None:
    """Draw a mark of a panel."""
    raise TypeError(f"cannot draw {type(mark).__name__}")


@draw_mark.register
def _(mark: Line, pen: Pen) -> None:
    points: dict[str, Any] = {"marker": "o", "markersize": 2.5} if mark.marked else {}
    width = style.HAIR if mark.colour == "paper" else style.THIN if mark.thin else style.LINE
    pen.ax.plot(pen.along(mark.x), pen.upright(mark.y), linewidth=width, **points, **_look(mark))


@draw_mark.register
def _(mark: Steps, pen: Pen) -> None:
    steps, colour = (pen.upright(mark.y), pen.along(mark.edges)), COLOURS[mark.colour]
    pen.ax.stairs(*steps, fill=True, color=colour, alpha=0.10, linewidth=0.0)
    pen.ax.stairs(*steps, color=colour, alpha=0.45, linewidth=style.HAIR)


@draw_mark.register
def _(mark: Band, pen: Pen) -> None:
    edges = pen.along(mark.x), pen.upright(mark.low), pen.upright(mark.high)
    pen.ax.fill_between(*edges, facecolor=COLOURS[mark.colour], alpha=0.16, linewidth=0.0, label=_look(mark)["label"])


@draw_mark.register
def _(mark: Area, pen: Pen) -> None:
    assert pen.panel.colours is not None
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, ACROSS)[:, None]
    # At the sine of an angle the root of 1 - s^2 is its cosine; a semi-ellipse falls vertically at its edge.
    values = pen.panel.colours.scale[0] * np.cos(angle) ** (2.0 * mark.power) * mark.values
    x, y = np.broadcast_to(pen.along(mark.x), values.shape), pen.upright(np.sin(angle) * mark.half_height)
    # Thousands of small polygons in an SVG file would show seams, so that the values are rasterised.
    look: dict[str, Any] = {"cmap": style.COLOUR_MAP, "norm": colour_scale(pen.panel.colours), "rasterized": True}
    pen.ax.pcolormesh(x, y, values, shading="gouraud", zorder=1.0, **look)
    closed = [np.concatenate([row, back[::-1], row[:1]]) for row, back in ((x[0], x[0]), (y[-1], y[0]))]
    pen.ax.plot(*closed, color=style.INK, linewidth=style.THIN, solid_joinstyle="round")


@draw_mark.register
def _(mark: Cells, pen: Pen) -> None:
    assert pen.panel.colours is not None
    look: dict[str, Any] = {"cmap": style.COLOUR_MAP, "norm": colour_scale(pen.panel.colours), "rasterized": True}
    values = np.ma.masked_invalid(pen.panel.colours.scale[0] * mark.values.T)
    pen.ax.pcolormesh(pen.along(mark.x), pen.upright(mark.y), values, zorder=1.0, **look)


@draw_mark.register
def _(mark: Contours, pen: Pen) -> None:
    assert pen.panel.colours is not None
    lines = draw_contours(mark, pen.along(mark.x), pen.upright(mark.y), pen.panel.colours, pen.ax)
    pen.contours.append((mark, lines))


@draw_mark.register
def _(mark: Bar, pen: Pen) -> None:
    look = _look(mark) | {"linewidth": 2.4, "solid_capstyle": "butt", "zorder": 2.5, "clip_on": False}
    pen.ax.plot(pen.along([mark.low, mark.high]), pen.upright([mark.y, mark.y]), **look)


@draw_mark.register
def _(mark: Points, pen: Pen) -> None:
    (marker, size), colour = SYMBOLS[mark.symbol], COLOURS[mark.colour]
    look: dict[str, Any] = {"color": colour, "markerfacecolor": colour if mark.symbol == "dot" else "white"}
    if mark.x.size > FEW:
        size *= MANY
        look |= {"markeredgewidth": style.THIN}
    if pen.panel.colours:
        # A small symbol may lie on a larger one.
        look |= {"markeredgewidth": style.THIN, "clip_on": False, "zorder": 4.0 - 0.1 * size}
    look |= {"linestyle": "none", "markersize": size, "label": typeset(mark.name) or None}
    pen.ax.plot(pen.along(mark.x), pen.upright(mark.y), marker, **look)


@draw_mark.register
def _(mark: Span, pen: Pen) -> None:
    faint = mark.colour == "faint"
    colour: dict[str, Any] = {
        "facecolor": style.PALE if faint else COLOURS[mark.colour],
        "alpha": 1.0 if faint else 0.25,
    }
    ends = pen.along([mark.low, mark.high])
    pen.ax.axvspan(*ends, edgecolor="none", zorder=0.5 if faint else 1.2, label=_look(mark)["label"], **colour)


@draw_mark.register
def _(mark: Bars, pen: Pen) -> None:
    colour, draw = COLOURS[mark.colour], pen.ax.barh if pen.panel.sideways else pen.ax.bar
    look: dict[str, Any] = {"color": colour if mark.dash == "solid" else style.PALE, "edgecolor": colour}
    label, places = _look(mark)["label"], pen.along(mark.x + mark.aside)
    draw(places, pen.upright(mark.y), pen.along(mark.width), linewidth=style.HAIR, label=label, **look)


@draw_mark.register
def _(mark: Whiskers, pen: Pen) -> None:
    low, high, places = pen.upright(mark.low), pen.upright(mark.high), pen.along(mark.x + mark.aside)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    look: dict[str, Any] = {"fmt": "none", "capsize": 2.0, "linewidth": style.THIN, "ecolor": COLOURS[mark.colour]}
    look["label"] = _look(mark)["label"]
    if pen.panel.sideways:
        pen.ax.errorbar(middle, places, xerr=half, **look)
    else:
        pen.ax.errorbar(places, middle, yerr=half, **look)


@draw_mark.register
def _(mark: Across, pen: Pen) -> None:
    place = pen.across * mark.x
    pen.ax.axvline(place, linewidth=style.THIN, zorder=1.5, **_look(mark))
    if mark.words and pen.span and not mark.above:
        # On the side away from what is drawn.
        side: Side = "left" if mark.x > 0.5 * sum(pen.span) else "right"
        note(
            pen.ax, mark.words, (place, 0.5), side, 3.0, across=True, rotation=90.0, va="center", color=style.FAINT_INK
        )


@draw_mark.register
def _(mark: Level, pen: Pen) -> None:
    pen.ax.axhline(pen.up * mark.y, linewidth=style.HAIR, zorder=1.0, **_look(mark))


@draw_mark.register
def _(mark: Dimension, pen: Pen) -> None:
    low, high = pen.point(mark.low, mark.y), pen.point(mark.high, mark.y)
    arrow = ARROW | {"color": COLOURS[mark.colour], "linewidth": style.THIN}
    pen.ax.annotate("", low, xytext=high, arrowprops=arrow)
    _write(mark.words, 0.5 * (mark.low + mark.high), mark.y, "center", pen)


@draw_mark.register
def _(mark: Words, pen: Pen) -> None:
    _write(mark.words, mark.x, _above(mark, pen) if mark.clear else mark.y, mark.side, pen, color=COLOURS[mark.colour])


def _above(mark: Words, pen: Pen) -> float:
    """Return where words are above all lines that they would cross."""
    assert pen.span is not None
    assert pen.panel.upright.range is not None
    width = WIDER * width_of(pen.ax, mark.words) * (pen.span[1] - pen.span[0])
    low, high = (mark.x - width, mark.x) if mark.side == "right" else (mark.x, mark.x + width)
    lines = (other for other in pen.panel.marks if isinstance(other, Line))
    crossed = [line.y[(line.x >= low) & (line.x <= high)] for line in lines]
    return float(min(np.nanmax(np.concatenate([[mark.y], *crossed])), HIGHEST * pen.panel.upright.range[1]))


def _write(words: str, x: float, y: float, side: Side, pen: Pen, **look: Any) -> None:
    """Write words above a point, inside the axes if they are to be in its middle."""
    if not words:
        return
    if side == "center" and pen.span:
        side = alignment(pen.ax, x, pen.span, words)
    note(pen.ax, typeset(words), pen.point(x, y), side, 3.0, 4.0, **OVER_LINES | look)
