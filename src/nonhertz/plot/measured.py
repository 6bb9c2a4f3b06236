"""A measured profile on one sheet: a panel for every step, and the resulting relief."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import amount, mm, um
from nonhertz.measured import Measured, Points, ProfileFit, StepResult
from nonhertz.plot.axes import Array, Axes, Figure, Measure, measure, open_frame
from nonhertz.plot.axial import written
from nonhertz.plot.sheets import LEFT, MARGIN, WIDTH, panel, stacked
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, HAIR, INK, LINE, SECOND, SMALL_SIZE, THIN, sheet_style

MILLIMETRES_FROM = 0.5  # mm: a greater range of heights is drawn in mm
# Inches.
TALL, SLIM, HEAD, LAST_HEAD, GAP, FOOT = 1.05, 0.5, 0.3, 0.45, 0.1, 0.27
LABEL = -0.62  # inches from the axes to the middle of the vertical axis labels
GREY = "#BBBBBB"
LETTERS = 104  # in a line of a heading
COLUMNS = 900  # into which a line with more points is reduced: print resolves no more across a sheet
ROOM = 0.12
CUT = 4.0  # times the range of the remaining heights: cut-off material deeper than this is not drawn


def measured_figure(measured: Measured, title: str = "", fit: ProfileFit | None = None) -> Figure:
    """Return a sheet of the steps of a measured profile, from the raw trace to the relief.

    Each step has a panel with its sentence: heights before in grey, after in black, and what was removed in colour
    (points as dots, the line of the tilt dashed, roughness in a separate panel). Then comes the relief, with a fitted
    profile and its residual if there is one, and below it each corner that was kept, with its points before smoothing.
    Axes are those of the land, dashed lines its ends. If a line has too many points, the lowest and highest in each of
    900 columns are drawn.

    Parameters
    ----------
    measured : Measured
        The trace and its steps.
    title : str
        Heading; none if empty.
    fit : ProfileFit or None
        A profile of the catalogue to draw beside the relief.

    Returns
    -------
    matplotlib.figure.Figure
        ``nonhertz.plot.save`` writes it.
    """
    shown = [pair for pair in zip(measured.states, measured.states[1:], strict=False) if pair[1].name != "thin"]
    corners = [corner for corner in measured.points.beyond_land if np.any(corner)]
    sizes: list[tuple[float, float]] = []  # of head and panel
    for _, after in shown:
        sizes += [(HEAD + (FOOT if sizes else 0.0), TALL), *([(GAP, SLIM)] if after.name == "smooth" else [])]
    sizes += [(LAST_HEAD + FOOT, 1.5 * TALL), *([] if fit is None else [(GAP, SLIM)])]
    room = FOOT + 0.2 + (HEAD + 1.5 * TALL + FOOT + 0.2 if measured.points.land is not None else 0.0)
    with sheet_style():
        heads, heights = zip(*sizes, strict=True)
        figure, panels = stacked(heads, heights, title, bottom=room)
        every = iter(panels)
        for count, (before, after) in enumerate(shown, start=1):
            _draw_step(every, count, before, after)
        _draw_relief(every, measured, fit)
        _draw_corners(figure, corners, measured)
        return figure


def _line(y: Array, height: Array, ruler: Measure) -> tuple[Array, Array]:
    """Return a line as it is drawn, or the lowest and highest point in each of many columns if it has too many."""
    length = measure("mm")
    if len(y) <= 2 * COLUMNS:
        return length(y), ruler(height)
    share = -(-len(y) // COLUMNS)
    count = len(y) // share * share
    columns = height[:count].reshape(-1, share)
    first = np.arange(0, count, share)
    ends = np.column_stack([first + columns.argmin(axis=1), first + columns.argmax(axis=1)])
    places = np.unique(np.concatenate([np.sort(ends, axis=1).ravel(), np.arange(count, len(y))]))
    return length(y[places]), ruler(height[places])


def _ruler(height: Array) -> Measure:
    """Return how heights are drawn in a panel."""
    return measure("mm", "" if np.ptp(height) > MILLIMETRES_FROM else "um")


def _draw_step(every: Iterator[Axes], count: int, before: StepResult, after: StepResult) -> None:
    """Draw a step on the next of the panels, and what smoothing took off on the one below."""
    axes = next(every)
    _head(axes, f"{count}. {after.words}")
    ruler = _ruler(after.points.height_between_corners)
    broad = LINE if after.name in {"align", "smooth"} else THIN
    axes.plot(*_line(before.y, before.height, ruler), color=GREY, linewidth=broad)
    axes.plot(*_line(after.y, after.height, ruler), color=INK, linewidth=THIN)
    _draw_taken(axes, after, ruler)
    _frame(axes, before, after, ruler)
    if after.name == "smooth" and after.removed_height is not None:
        axes.tick_params(labelbottom=False)
        slim = next(every)
        small = measure("mm", "um")
        slim.plot(*_line(after.y, after.removed_height, small), color=SECOND, linewidth=HAIR)
        _tidy(slim, small.label("off"))
        slim.set_xlim(axes.get_xlim())


def _draw_taken(axes: Axes, after: StepResult, ruler: Measure) -> None:
    """Draw what a step removed, or where it put y = 0."""
    if after.name == "level" and after.removed_height is not None:
        line = ruler(after.removed_height + float(np.max(after.height)))
        axes.plot(measure("mm")(after.y[[0, -1]]), line[[0, -1]], color=SECOND, linewidth=THIN, linestyle="--")
    if after.name == "align":
        axes.axvline(0.0, color=SECOND, linewidth=THIN, linestyle="--")
    if after.name == "trim":
        _mark_land(axes, after.points)
    if after.removed is not None:
        y, height = after.removed
        marks: dict[str, Any] = {"marker": "o", "markersize": 3.5, "markerfacecolor": "none", "markeredgewidth": THIN}
        if after.name == "trim":
            marks = {"marker": ".", "markersize": 2.0}
        drawn = _line(y, height, ruler) if after.name == "trim" else (measure("mm")(y), ruler(height))
        axes.plot(*drawn, color=SECOND, linestyle="none", **marks)


def _mark_land(axes: Axes, points: Points) -> None:
    for end in points.land or ():
        if points.y[0] < end < points.y[-1]:
            axes.axvline(measure("mm").factor * end, color=FAINT_INK, linewidth=THIN, linestyle="--")


def _draw_corners(figure: Figure, corners: Sequence[NDArray[np.bool_]], measured: Measured) -> None:
    """Draw the corners side by side at the bottom, with their points before smoothing."""
    before = next((b for b, a in pairwise(measured.states) if a.name in {"smooth", "thin"}), measured.states[-1])
    highest = float(measured.points.height.max())
    room = 0.5 if len(corners) > 1 else 0.0
    width = (WIDTH - LEFT - MARGIN - room) / max(len(corners), 1)
    length, depth = measure("mm"), measure("mm", "um")
    for k, corner in enumerate(corners):
        axes = panel(figure, LEFT + k * (width + room), FOOT + 0.2, width, 1.5 * TALL)
        ends = np.sort(measured.points.y[corner])[[0, -1]]
        ends += 0.2 * np.ptp(ends) * np.array([-1.0, 1.0]) * (np.abs(ends) < np.max(np.abs(ends)))
        shown = (before.y >= ends[0]) & (before.y <= ends[1])
        axes.plot(length(before.y[shown]), depth(highest - before.height[shown]), ".", color=GREY, markersize=2.5)
        near = (measured.points.y >= ends[0]) & (measured.points.y <= ends[1])
        axes.plot(length(measured.points.y[near]), depth(measured.relief[near]), color=INK, linewidth=THIN)
        _mark_land(axes, measured.points)
        axes.set_xlim(*length(ends))
        axes.invert_yaxis()
        _tidy(axes, depth.label("Relief") if k == 0 else "")
        axes.locator_params(axis="x", nbins=5)
        axes.yaxis.set_label_coords(LABEL / width, 0.5)
        side = "low" if corner[0] else "high"
        _head(axes, f"The corner at the {side} end; dots: before smoothing.", LETTERS // len(corners))
        axes.set_xlabel(length.label("Axial position $y$"))


def _draw_relief(every: Iterator[Axes], measured: Measured, fit: ProfileFit | None) -> None:
    axes = next(every)
    y, land = measured.points.y, measured.points.on_land
    ruler, thin = _ruler(land.height), any(state.name == "thin" for state in measured.states)
    words = "Relief, highest point less height" + (f", {len(y)} points." if thin else ".")
    marks: dict[str, Any] = {"marker": ".", "markersize": 2.5} if len(y) <= COLUMNS else {}
    axes.plot(*_line(y, measured.relief, ruler), color=INK, linewidth=THIN, **marks)
    if measured.points.land is not None:
        _mark_land(axes, measured.points)
        most = ruler.factor * float(measured.points.height.max() - land.height.min())
        axes.set_ylim(-ROOM * most, max((1.0 + 3.0 * ROOM) * most, 1e-6 * ruler.factor))
    axes.invert_yaxis()
    if fit is not None:
        style: dict[str, Any] = {"color": FIRST, "linewidth": LINE, "linestyle": (0, (4, 2)), "zorder": 1.5}
        axes.plot(measure("mm")(land.y), ruler(fit.relief(land.y)), **style)
        named = ", ".join(f"{name} {amount(value, fit.unit_of(name)):.5g}" for name, value in fit.parameters.items())
        name = f"{fit.kind}, {named}" if named else fit.kind
        words += f" Dashed: {name}. Residual to the rough points: {um(fit.rms):.2g} root mean square."
    _tidy(axes, ruler.label("Relief"))
    lowest = axes
    if fit is not None:
        axes.tick_params(labelbottom=False)
        lowest = next(every)
        lowest.axhline(0.0, color=FAINT_INK, linewidth=HAIR)
        left = measured.points.height.max() - land.height - fit.relief(land.y)
        small = measure("mm", "um")
        lowest.plot(*_line(land.y, left, small), color=FIRST, linewidth=THIN)
        _tidy(lowest, small.label("left"))
        lowest.set_xlim(axes.get_xlim())
    _head(axes, words)
    lowest.set_xlabel(measure("mm").label("Axial position $y$"))


def _head(axes: Axes, words: str, letters: int = LETTERS) -> None:
    lines = textwrap.wrap(words, letters)
    text = "\n".join(lines[:2]) + (" ..." if len(lines) > 2 else "")
    style: dict[str, Any] = {"fontsize": SMALL_SIZE, "linespacing": 1.25, "parse_math": False}
    axes.text(0.0, 1.04, text, transform=axes.transAxes, va="bottom", **style)


def _frame(axes: Axes, before: StepResult, after: StepResult, ruler: Measure) -> None:
    """Set the range of heights: all, unless corners are so deep that they would flatten the rest."""
    inner = [state.points.height_between_corners for state in (before, after)]
    low, high = (ruler.factor * float(bound(heights)) for bound, heights in ((np.min, inner[1]), (np.max, inner[1])))
    deepest = ruler.factor * float(before.height.min())
    room = max(high - low, 1e-6 * ruler.factor)
    if high - deepest <= CUT * room:
        low = min(low, deepest)
        high = max(high, ruler.factor * float(before.height.max()))
    else:
        read = (um if ruler.factor == measure("mm", "um").factor else mm)(deepest / ruler.factor)
        note = f"axis cut, heights go down to {written(read, 3)}"
        style: dict[str, Any] = {"fontsize": SMALL_SIZE, "color": FAINT_INK, "bbox": BACKING, "ha": "center"}
        axes.text(0.5, 0.06, note, transform=axes.transAxes, **style)
        low = min(low, ruler.factor * float(inner[0].min())) - 0.5 * room
        high = max(high, ruler.factor * float(inner[0].max()))
    if after.name == "level" and after.removed_height is not None:
        high = max(high, ruler.factor * float(np.max(after.removed_height) + np.max(after.height)))
    # A perfectly flat line still needs a range.
    above = max(ROOM * (high - low), 1e-6 * ruler.factor, 1e-6 * abs(high))
    axes.set_ylim(low - above, high + above)
    _tidy(axes, ruler.label("Height"))


def _tidy(axes: Axes, label: str) -> None:
    open_frame(axes)
    axes.margins(x=0.01)
    axes.locator_params(axis="y", nbins=4, steps=[1, 2, 5, 10])
    axes.set_ylabel(label)
    axes.yaxis.set_label_coords(LABEL / (WIDTH - LEFT - MARGIN), 0.5)
