"""Drawing a round panel of a figure on polar axes: +y, the place 0, at the bottom, angles counter-clockwise."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.figures.value import Arrow, Bars, Figure, Mark, Panel, Points, Words
from nonhertz.plot.axes import Artist
from nonhertz.plot.axes import Figure as Sheet
from nonhertz.plot.sheets import WIDTH, sheet
from nonhertz.plot.sheets import panel as axes_at
from nonhertz.plot.style import BACKING, COLOURS, FAINT_INK, HAIR, INK, LINE, SMALL_SIZE, THIN

if TYPE_CHECKING:
    from matplotlib.projections.polar import PolarAxes

# Inches: a picture alone and several side by side, what is written around it, and the legend below.
ALONE, BESIDE, AROUND, HEAD, KEY = 3.9, 2.5, 0.3, 0.4, 0.3
PER_LINE = 2
HOLE = 0.75  # radius of the circle from which bars rise, over the largest that is drawn
LARGEST_MARK, MARK_SHARE = 6.0, 0.7  # of points: the largest [point], and their share of the pitch
ARROW_SHARE = 0.72  # of the circle's radius
WORDS: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": SMALL_SIZE}


def round_sheet(figure: Figure, title: str, conditions: Sequence[str]) -> Sheet:
    """Return a sheet with the round panels of a figure side by side, and one legend below them."""
    count = len(figure.panels)
    size, across = (ALONE, 1) if count == 1 else (BESIDE, PER_LINE)
    block, lines = HEAD + size + 2.0 * AROUND, math.ceil(count / across)
    bottom = lines * block + KEY
    drawn, entries = sheet(bottom, title, conditions), dict[str, Artist]()
    for number, panel in enumerate(figure.panels):
        line, column = divmod(number, across)
        edge = WIDTH * (column + 0.5) / across - 0.5 * size
        ax: Any = axes_at(drawn, edge, bottom - line * block - HEAD - AROUND - size, size, size, "polar")
        draw_round(panel, figure, ax)
        entries |= dict(zip(*reversed(ax.get_legend_handles_labels()), strict=True))
    below: dict[str, Any] = {"loc": "lower center", "ncols": len(entries), "frameon": False, "fontsize": SMALL_SIZE}
    drawn.legend([*entries.values()], [*entries], **below)
    return drawn


def draw_round(panel: Panel, figure: Figure, ax: PolarAxes) -> PolarAxes:
    """Draw a round panel of a figure on polar axes."""
    assert panel.upright.range is not None
    factor = panel.upright.scale[0]
    top = factor * panel.upright.range[1]
    ax.set_theta_zero_location("S")
    ax.set_theta_direction(1)
    ax.set_ylim(0.0, top)
    ax.set_rorigin(-HOLE * top)
    sides = [(place, words.replace(" ", "\n") if math.sin(place) else words) for place, words in figure.along.ticks]
    ax.set_xticks(*zip(*sides, strict=True))
    ax.set_yticks([factor * place for place, _ in panel.upright.ticks], [""] * len(panel.upright.ticks))
    ax.tick_params(axis="x", pad=5.0, labelsize=SMALL_SIZE)
    ax.grid(True, color=FAINT_INK, linewidth=HAIR, alpha=0.5)
    ax.set_axisbelow(True)
    ax.spines["polar"].set(linewidth=HAIR, edgecolor=FAINT_INK)
    ax.spines["inner"].set(linewidth=THIN, edgecolor=INK)
    around = math.pi * min(ax.bbox.width, ax.bbox.height) / ax.figure.dpi * 72.0 * HOLE / (1.0 + HOLE)
    size = min(LARGEST_MARK, MARK_SHARE * around / sum(mark.x.size for mark in panel.marks if isinstance(mark, Points)))
    for mark in panel.marks:
        _draw_mark(mark, factor, top, size, ax)
    row = panel.heading.partition(", row ")[2]
    words = panel.remark.replace("; ", "\n")
    ax.set_title(f"Row {row}: {words}" if row else words, fontsize=SMALL_SIZE, pad=12.0)
    return ax


def _draw_mark(mark: Mark, factor: float, top: float, size: float, ax: PolarAxes) -> None:
    match mark:
        case Bars():
            _draw_bars(mark, factor, ax)
        case Points():
            look: dict[str, Any] = {"color": INK, "markersize": size, "markeredgewidth": THIN, "clip_on": False}
            look |= {"markerfacecolor": INK if mark.symbol == "dot" else "white", "label": mark.name or None}
            ax.plot(mark.x, mark.y, "o", zorder=4.0, **look)
        case Words():
            # Not as labels of the ticks, which bars would cover.
            ax.text(mark.x, factor * mark.y, mark.words, bbox=BACKING, zorder=5.0, **WORDS)
        case Arrow():
            _draw_arrow(mark, top, ax)


def _draw_bars(mark: Bars, factor: float, ax: PolarAxes) -> None:
    drawn, colour, hatched = mark.y > 0.0, COLOURS[mark.colour], mark.dash != "solid"
    if drawn.any():
        look: dict[str, Any] = {"color": "white", "hatch": "////"} if hatched else {"color": colour}
        look |= {"edgecolor": colour, "linewidth": HAIR, "label": mark.name or None}
        ax.bar(mark.x[drawn] + mark.aside, factor * mark.y[drawn], width=mark.width, zorder=3.0, **look)


def _draw_arrow(mark: Arrow, top: float, ax: PolarAxes) -> None:
    """Draw an arrow into the circle, with words at its tail; only these where it has no direction."""
    if math.isnan(mark.x):
        ax.text(0.0, -HOLE * top, mark.words, color=COLOURS[mark.colour], clip_on=False, **WORDS)
        return
    tail, tip = -HOLE * top * (1.0 - 0.25 * ARROW_SHARE), -HOLE * top * (1.0 - ARROW_SHARE)
    arrow = {"arrowstyle": "-|>,head_length=0.6,head_width=0.25", "color": COLOURS[mark.colour], "linewidth": LINE}
    arrow |= {"shrinkA": 0.0, "shrinkB": 0.0}
    behind = mark.x + np.pi
    ax.annotate("", (mark.x, tip), xytext=(behind, tail), arrowprops=arrow, annotation_clip=False)
    ax.text(behind, -HOLE * top * (1.0 - 0.55), mark.words, bbox=BACKING, clip_on=False, **WORDS)
