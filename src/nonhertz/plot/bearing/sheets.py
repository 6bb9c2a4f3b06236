"""Finished figures of a bearing, laid out for the width of a page."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from nonhertz.amounts import mrad, newton
from nonhertz.plot.axial import written
from nonhertz.plot.bearing.displacement import directions, displacement_against_load
from nonhertz.plot.bearing.loads import bearing_loads
from nonhertz.plot.bearing.pressure import RINGS, bearing_pressure, draw_colour_bar
from nonhertz.plot.bearing.roller import most_loaded_roller, roller_relief
from nonhertz.plot.sheets import BAR_ROOM, LEFT, MARGIN, WIDTH, bar_beside, sheet, stacked
from nonhertz.plot.style import SMALL_SIZE, sheet_style

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.projections.polar import PolarAxes

    from nonhertz.bearing import BearingMaps, BearingSolution

CONDITION_LETTERS = 104  # that fit in a line
# The polar picture of one row and of several side by side, what is written around it, the key below.
ALONE, BESIDE, AROUND, HEAD_OF_POLAR, KEY = 3.9, 2.5, 0.3, 0.4, 0.3
PER_LINE = 2
PANEL, PANEL_HEAD = 1.25, 0.3
ROLLER_PANEL, RELIEF_PANEL, ROLLER_HEAD, BETWEEN = 2.2, 1.4, 0.5, 0.45
CURVE, CURVE_HEAD = 2.6, 0.45
LEFT_OF_TWO = 0.85  # beside a label of two lines


def bearing_figures(
    solution: BearingSolution, title: str = "", *, maps: BearingMaps | None = None
) -> dict[str, Figure]:
    """Return one finished figure each of loads, pressure, most loaded roller and displacement.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing. If it was solved by slices there are no pressures, and so neither ``"pressure"`` nor
        ``"roller"``.
    title : str
        Heading of every figure; none if empty.
    maps : BearingMaps, optional
        For the displacement, in place of slices; see `displacement_against_load`.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Keys ``"loads"``, ``"pressure"`` and ``"roller"`` (by strips, if any roller is loaded), and ``"displacement"``
        (if a force acts on the inner ring); `save` writes them.
    """
    with sheet_style():
        found = {"loads": _loads(solution, title)}
        if solution.method == "strips" and solution.load.any():
            found["pressure"] = _pressure(solution, title)
            found["roller"] = _roller(solution, title)
        if directions(solution):
            found["displacement"] = _displacement(solution, title, maps)
        return found


def _loads(solution: BearingSolution, title: str) -> Figure:
    rows = len(solution.bearing.rows)
    size, across = (ALONE, 1) if rows == 1 else (BESIDE, PER_LINE)
    lines = math.ceil(rows / across)
    block = HEAD_OF_POLAR + size + 2.0 * AROUND
    bottom = lines * block + KEY
    figure = sheet(bottom, title, _lines(conditions(solution)), MARGIN)
    entries: dict[str, Artist] = {}
    for row in range(rows):
        line, column = divmod(row, across)
        left = WIDTH * (column + 0.5) / across - 0.5 * size
        place = bottom - line * block - HEAD_OF_POLAR - AROUND - size
        whole = figure.get_figheight()
        rectangle = (left / WIDTH, place / whole, size / WIDTH, size / whole)
        axes = cast("PolarAxes", figure.add_axes(rectangle, projection="polar"))
        bearing_loads(solution, axes, row=row)
        entries |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    handles, labels = list(entries.values()), list(entries)
    figure.legend(handles, labels, loc="lower center", ncols=len(labels), frameon=False, fontsize=SMALL_SIZE)
    return figure


def _pressure(solution: BearingSolution, title: str) -> Figure:
    panels = [(row, ring) for row in range(len(solution.bearing.rows)) for ring in RINGS]
    figure, every = _stacked(solution, title, [PANEL_HEAD] * len(panels), [PANEL] * len(panels), LEFT, BAR_ROOM)
    for (row, ring), axes in zip(panels, every, strict=True):
        bearing_pressure(solution, axes, ring=ring, row=row, colour_bar=False)
        if axes is not every[-1]:
            axes.set_xlabel("")
            axes.tick_params(axis="x", labelbottom=False)
    # Of the height of two panels, however many there are.
    draw_colour_bar(solution, every[-1], cax=bar_beside(*every, most=2.0 * PANEL + PANEL_HEAD))
    return figure


def _roller(solution: BearingSolution, title: str) -> Figure:
    figure, (upper, lower) = _stacked(solution, title, [ROLLER_HEAD, BETWEEN], [ROLLER_PANEL, RELIEF_PANEL])
    most_loaded_roller(solution, upper).tick_params(labelbottom=False)
    roller_relief(solution, lower)
    return figure


def _displacement(solution: BearingSolution, title: str, maps: BearingMaps | None) -> Figure:
    figure, (axes,) = _stacked(solution, title, [CURVE_HEAD], [CURVE])
    displacement_against_load(solution, axes, maps=maps)
    return figure


def _stacked(
    solution: BearingSolution,
    title: str,
    heads: list[float],
    heights: list[float],
    left: float = LEFT_OF_TWO,
    right: float = MARGIN,
) -> tuple[Figure, list[Axes]]:
    """Return a sheet of a bearing with its conditions, and panels below them."""
    return stacked(heads, heights, title, _lines(conditions(solution)), left=left, right=right, words=MARGIN)


def _lines(parts: Sequence[str]) -> list[str]:
    """Return parts in lines that are not too long, none of which begins within a part."""
    lines = [parts[0]]
    for part in parts[1:]:
        joined = f"{lines[-1]}; {part}"
        lines[-1:] = [joined] if len(joined) <= CONDITION_LETTERS else [lines[-1], part]
    return lines


def conditions(solution: BearingSolution) -> list[str]:
    """Return what was solved, in parts: the bearing, and what acts on its inner ring with the method."""
    rows = [row.bearing for row in solution.bearing.rows]
    same = len({(type(each), each.rollers) for each in rows}) == 1
    kinds = [f"{each.kind.capitalize()}, {each.rollers} rollers" for each in (rows[:1] if same else rows)]
    acting = [
        f"{name} {written(newton(float(solution.force[:3] @ (abs(way) if name == 'axial' else way))))}"
        for name, way in directions(solution).items()
    ]
    tilt = math.hypot(*solution.displacement[3:])
    acting.append(f"tilt {written(mrad(tilt if tilt > 1e-9 else 0.0), 3)}")
    acting.append(f"by {solution.method}")
    return [*([f"{len(rows)} rows: {kinds[0]} each"] if same and len(rows) > 1 else kinds), ", ".join(acting)]
