"""Contour lines of a panel: bands of colour, the lines between them, and labels where they cover nothing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.figures.value import Across, Axis, Bar, Contours, Mark, Panel, Points
from nonhertz.plot.axes import Array, Axes
from nonhertz.plot.style import COLOUR_MAP, HAIR, INK, SMALL_SIZE

if TYPE_CHECKING:
    from matplotlib.contour import ContourSet
    from matplotlib.transforms import Bbox

BANDS = 10  # of colour, at most
APART = 0.17  # inches: least distance of a label from the next, and from points
SHARES = (0.5, 0.35, 0.65, 0.22, 0.78)  # of the bars: where the column of labels may be
PADDING = 4.0  # pixels around a label
NEAR = 2.0  # columns of values, within which a point may lie under a label


def draw_contours(mark: Contours, x: Array, y: Array, colours: Axis, ax: Axes) -> ContourSet:
    """Fill bands between levels, draw the lines between them and return these; places are as they are drawn."""
    from matplotlib.ticker import MaxNLocator

    factor, (low, high) = colours.scale[0], colours.range or (0.0, 1.0)
    levels = MaxNLocator(BANDS, steps=[1, 2, 2.5, 5, 10]).tick_values(factor * low, factor * high)
    values = np.ma.masked_invalid(factor * mark.values.T)
    beyond = colours.cut and float(values.max()) > levels[-1]
    shown, extend = (values, "max") if beyond else (np.minimum(values, levels[-1]), "neither")
    ax.contourf(x, y, shown, levels, cmap=COLOUR_MAP, extend=extend, zorder=0.5)
    # The colour map goes from dark to bright.
    ink = ["white" if level < 0.5 * (levels[0] + levels[-1]) else INK for level in levels[1:]]
    return ax.contour(x, y, values, levels[1:], colors=ink, linewidths=HAIR, zorder=0.8)


def label_contours(lines: ContourSet, mark: Contours, x: Array, y: Array, panel: Panel, ax: Axes) -> None:
    """Label contour lines; in true proportions where they cross a column below the largest values, far enough apart."""
    if not panel.proportional:
        _label_anywhere(lines, ax)
        return
    assert panel.colours is not None
    factor = panel.colours.scale[0]
    ax.apply_aspect()
    column = _calm_column(mark, panel.marks)
    depths, values = mark.y, factor * mark.values[column]
    apart = APART * float(np.ptp(depths)) * ax.figure.dpi / ax.bbox.height
    near = NEAR * float(np.ptp(mark.x)) / mark.x.size
    points = [
        (along, at)
        for drawn in panel.marks
        if isinstance(drawn, Points)
        for along, at in zip(drawn.x, drawn.y, strict=True)
    ]
    taken = [at for along, at in points if abs(along - mark.x[column]) < near] + [depths[0], depths[-1]]
    places = []
    for level in np.asarray(lines.levels)[::-1].tolist():
        depth = _find_crossing(values, depths, level, apart)
        if depth is not None and all(abs(depth - other) > apart for other in taken):
            taken.append(depth)
            places.append((float(x[column]), float(np.interp(depth, depths, y))))
    if places:
        ax.clabel(lines, manual=places, fmt="%.4g", fontsize=SMALL_SIZE, inline_spacing=2.0)


def _label_anywhere(lines: ContourSet, ax: Axes) -> None:
    """Label contour lines where matplotlib would, but for labels that would cover others."""
    look: dict[str, Any] = {"fmt": "%.4g", "fontsize": SMALL_SIZE - 1.0}
    boxes: list[Bbox] = []
    tried, places = ax.clabel(lines, inline=False, **look), list[tuple[float, float]]()
    for label in tried:
        box = label.get_window_extent().padded(PADDING)
        if not box.count_overlaps(boxes):
            boxes.append(box)
            places.append(label.get_position())
    for label in tried:
        label.remove()
    if places:
        ax.clabel(lines, manual=places, inline_spacing=2.0, **look)


def _find_crossing(values: Array, depths: Array, level: float, apart: float) -> float | None:
    """Return the greatest depth at which values fall below a level; None if nowhere, or just below their rise."""
    above = np.flatnonzero(values >= level)
    # At the tip of a contour the label would lie across it.
    if above.size == 0 or above[-1] == values.size - 1 or depths[above[-1]] - depths[above[0]] < apart:
        return None
    k = above[-1]
    return float(np.interp(level, [values[k + 1], values[k]], [depths[k + 1], depths[k]]))


def _calm_column(mark: Contours, marks: Sequence[Mark]) -> int:
    """Return the column where labels are farthest from points and from lines across."""
    bars = [end for drawn in marks if isinstance(drawn, Bar) for end in (drawn.low, drawn.high)]
    low, high = (min(bars), max(bars)) if bars else (float(mark.x[0]), float(mark.x[-1]))
    taken = [float(x) for drawn in marks if isinstance(drawn, Points) for x in drawn.x]
    taken += [drawn.x for drawn in marks if isinstance(drawn, Across)]
    places = [low + share * (high - low) for share in SHARES]

    def clearance(place: float) -> float:
        return min((round(min(abs(place - other) for other in taken), 9) if taken else high), 0.2 * (high - low))

    # Among equally good places the first, which is nearest to the middle.
    return int(np.abs(mark.x - max(places, key=clearance)).argmin())
