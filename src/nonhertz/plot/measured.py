"""A measured profile on one sheet: a panel for every step, and the resulting relief."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.measured import Fit, Measured, StepResult
from nonhertz.plot.axial import AXIAL_LABEL, number
from nonhertz.plot.sheets import LEFT, TITLE, WIDTH, blank, panel, write_title
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, HAIR, INK, LINE, SECOND, SMALL_SIZE, THIN, sheet_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

MILLIMETRES_FROM = 0.5  # mm: a greater range of heights is drawn in mm
# Inches.
TALL, SLIM, HEAD, LAST_HEAD, GAP, FOOT, MARGIN = 1.05, 0.5, 0.3, 0.45, 0.1, 0.27, 0.15
LABEL = -0.52  # inches from the axes to the middle of the vertical axis labels
GREY = "#BBBBBB"
LETTERS = 108  # in a line of a heading
COLUMNS = 900  # into which a line with more points is reduced: print resolves no more across a sheet
ROOM = 0.12
CUT = 4.0  # times the range of the remaining heights: cut-off material deeper than this is not drawn


def measured_figure(measured: Measured, title: str = "", fit: Fit | None = None) -> Figure:
    """Return a sheet of the steps of a measured profile, from the raw trace to the relief.

    Each step has a panel with its sentence: heights before in grey, after in black, and what was removed in colour
    (points as dots, the line of the tilt dashed, roughness in a separate panel). The last panel is the relief, with a
    fitted profile and its residual if there is one. If a line has too many points, the lowest and highest in each of
    900 columns are drawn.

    Parameters
    ----------
    measured : Measured
        The trace and its steps.
    title : str
        Heading; none if empty.
    fit : Fit or None
        A profile of the catalogue to draw beside the relief.

    Returns
    -------
    matplotlib.figure.Figure
        ``nonhertz.plot.save`` writes it.
    """
    shown = [pair for pair in zip(measured.states, measured.states[1:], strict=False) if pair[1].name != "thin"]
    with sheet_style():
        height = (TITLE if title else 0.0) + sum(_height(after) for _, after in shown) + _last_height(fit)
        figure = blank(height)
        top = height - (TITLE if title else 0.0)
        for count, (before, after) in enumerate(shown, start=1):
            _draw_step(figure, top, count, before, after)
            top -= _height(after)
        _draw_relief(figure, top, measured, fit)
        write_title(figure, title)
        return figure


@dataclass(frozen=True)
class _Ruler:
    """The unit for heights in a panel."""

    factor: float = 1e3
    unit: str = "µm"

    def line(self, y: Array, height: Array) -> tuple[Array, Array]:
        """Return a line, or the lowest and highest point in each of many columns if it has too many points."""
        if len(y) <= 2 * COLUMNS:
            return y, self.factor * height
        share = -(-len(y) // COLUMNS)
        count = len(y) // share * share
        columns = height[:count].reshape(-1, share)
        first = np.arange(0, count, share)
        ends = np.column_stack([first + columns.argmin(axis=1), first + columns.argmax(axis=1)])
        places = np.unique(np.concatenate([np.sort(ends, axis=1).ravel(), np.arange(count, len(y))]))
        return y[places], self.factor * height[places]


def _ruler(height: Array) -> _Ruler:
    return _Ruler(1.0, "mm") if np.ptp(height) > MILLIMETRES_FROM else _Ruler()


def _height(after: StepResult) -> float:
    return HEAD + TALL + FOOT + (SLIM + GAP if after.name == "smooth" else 0.0)


def _last_height(fit: Fit | None) -> float:
    return LAST_HEAD + 1.5 * TALL + FOOT + 0.2 + (SLIM + GAP if fit is not None else 0.0)


def _draw_step(figure: Figure, top: float, count: int, before: StepResult, after: StepResult) -> None:
    width = WIDTH - LEFT - MARGIN
    axes = panel(figure, LEFT, top - HEAD - TALL, width, TALL)
    _head(axes, f"{count}. {after.words}")
    ruler = _ruler(after.height)
    broad = LINE if after.name in {"align", "smooth"} else THIN
    axes.plot(*ruler.line(before.y, before.height), color=GREY, linewidth=broad)
    axes.plot(*ruler.line(after.y, after.height), color=INK, linewidth=THIN)
    _draw_taken(axes, after, ruler)
    _frame(axes, before, after, ruler)
    if after.name == "smooth" and after.removed_height is not None:
        axes.tick_params(labelbottom=False)
        slim = panel(figure, LEFT, top - HEAD - TALL - GAP - SLIM, width, SLIM)
        slim.plot(*_Ruler().line(after.y, after.removed_height), color=SECOND, linewidth=HAIR)
        _tidy(slim, "off [µm]")
        slim.set_xlim(axes.get_xlim())


def _draw_taken(axes: Axes, after: StepResult, ruler: _Ruler) -> None:
    """Draw what a step removed, or where it put y = 0."""
    if after.name == "level" and after.removed_height is not None:
        line = ruler.factor * (after.removed_height + float(np.max(after.height)))
        axes.plot(after.y[[0, -1]], line[[0, -1]], color=SECOND, linewidth=THIN, linestyle="--")
    if after.name == "align":
        axes.axvline(0.0, color=SECOND, linewidth=THIN, linestyle="--")
    if after.removed is not None:
        y, height = after.removed
        marks: dict[str, Any] = {"marker": "o", "markersize": 3.5, "markerfacecolor": "none", "markeredgewidth": THIN}
        if after.name == "trim":
            y, height = ruler.line(y, height)[0], ruler.line(y, height)[1] / ruler.factor
            marks = {"marker": ".", "markersize": 2.0}
        axes.plot(y, ruler.factor * height, color=SECOND, linestyle="none", **marks)


def _draw_relief(figure: Figure, top: float, measured: Measured, fit: Fit | None) -> None:
    width, tall = WIDTH - LEFT - MARGIN, 1.5 * TALL
    axes = panel(figure, LEFT, top - LAST_HEAD - tall, width, tall)
    y, relief = measured.points.y, measured.relief
    ruler = _ruler(relief)
    thin = next((state for state in measured.states if state.name == "thin"), None)
    words = "Relief, highest point less height" + (f", {len(y)} points." if thin is not None else ".")
    marks: dict[str, Any] = {"marker": ".", "markersize": 2.5} if len(y) <= COLUMNS else {}
    axes.plot(*ruler.line(y, relief), color=INK, linewidth=THIN, **marks)
    axes.invert_yaxis()
    if fit is not None:
        words += " " + _draw_fit(axes, y, fit, ruler)
    _tidy(axes, f"Relief [{ruler.unit}]")
    lowest = axes
    if fit is not None:
        axes.tick_params(labelbottom=False)
        lowest = panel(figure, LEFT, top - LAST_HEAD - tall - GAP - SLIM, width, SLIM)
        lowest.axhline(0.0, color=FAINT_INK, linewidth=HAIR)
        lowest.plot(*_Ruler().line(y, relief - fit.relief(y)), color=FIRST, linewidth=THIN)
        _tidy(lowest, "left [µm]")
        lowest.set_xlim(axes.get_xlim())
    _head(axes, words)
    lowest.set_xlabel(AXIAL_LABEL)


def _draw_fit(axes: Axes, y: Array, fit: Fit, ruler: _Ruler) -> str:
    axes.plot(y, ruler.factor * fit.relief(y), color=FIRST, linewidth=LINE, linestyle=(0, (4, 2)), zorder=1.5)
    named = ", ".join(f"{name} {value:.5g}" for name, value in fit.parameters.items())
    name = f"{fit.kind}, {named}" if named else fit.kind
    return f"Dashed: {name}. Residual to the rough points: {1e3 * fit.rms:.2g} µm root mean square."


def _head(axes: Axes, words: str) -> None:
    lines = textwrap.wrap(words.replace(" um", " µm"), LETTERS)
    text = "\n".join(lines[:2]) + (" ..." if len(lines) > 2 else "")
    style: dict[str, Any] = {"fontsize": SMALL_SIZE, "linespacing": 1.25, "parse_math": False}
    axes.text(0.0, 1.04, text, transform=axes.transAxes, va="bottom", **style)


def _frame(axes: Axes, before: StepResult, after: StepResult, ruler: _Ruler) -> None:
    """Set the range of heights: all, unless what was cut off is so deep that it would flatten the rest."""
    low, high = (ruler.factor * float(bound) for bound in (after.height.min(), after.height.max()))
    deepest = ruler.factor * float(before.height.min())
    room = max(high - low, 1e-3)
    if after.name != "trim" or high - deepest <= CUT * room:
        low = min(low, deepest)
        high = max(high, ruler.factor * float(before.height.max()))
    else:
        note = f"axis cut, heights go down to {number(deepest, 3)} {ruler.unit}"
        style: dict[str, Any] = {"fontsize": SMALL_SIZE, "color": FAINT_INK, "bbox": BACKING, "ha": "center"}
        axes.text(0.5, 0.06, note, transform=axes.transAxes, **style)
        low -= 0.5 * room
    # A perfectly flat line still needs a range.
    above = max(ROOM * (high - low), 1e-3, 1e-6 * abs(high))
    axes.set_ylim(low - above, high + above)
    _tidy(axes, f"Height [{ruler.unit}]")


def _tidy(axes: Axes, label: str) -> None:
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.margins(x=0.01)
    axes.locator_params(axis="y", nbins=4, steps=[1, 2, 5, 10])
    axes.set_ylabel(label)
    axes.yaxis.set_label_coords(LABEL / (WIDTH - LEFT - MARGIN), 0.5)
