"""What is drawn of a contact and of a whole bearing: by name, and as finished figures for the width of a page."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

from nonhertz.amounts import mrad, newton
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import InputError
from nonhertz.figures.bearing import pressure_maps
from nonhertz.figures.contact import figures_of
from nonhertz.figures.displacement import directions
from nonhertz.inputs.checks import one_of
from nonhertz.plot.axes import Artist, Axes, Figure
from nonhertz.plot.axial import written
from nonhertz.plot.bearing.displacement import displacement_against_load
from nonhertz.plot.bearing.loads import bearing_loads
from nonhertz.plot.bearing.pressure import bearing_pressure, draw_titled
from nonhertz.plot.bearing.roller import loaded_roller, most_loaded_roller, roller_relief
from nonhertz.plot.centre_line import pressure, profile
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.drawer import draw_colour_bar, sheet_of
from nonhertz.plot.sheets import (
    BAR_ROOM,
    MARGIN,
    WIDTH,
    bar_beside,
    panel,
    sheet,
    stacked,
)
from nonhertz.plot.style import SMALL_SIZE, sheet_style
from nonhertz.result.solution import Solution

if TYPE_CHECKING:
    from nonhertz.bearing import BearingMaps

Drawings = Mapping[str, Callable[..., Any]]

OF_CONTACTS: Final[Drawings] = {"pressure": pressure, "footprint": footprint, "profile": profile}
OF_BEARINGS: Final[Drawings] = {
    "loads": bearing_loads,
    "pressure": bearing_pressure,
    "roller": most_loaded_roller,
    "relief": roller_relief,
    "displacement": displacement_against_load,
}

# Inches: the polar picture of one row and of several side by side, what is written around it, the key below.
ALONE, BESIDE, AROUND, HEAD_OF_POLAR, KEY = 3.9, 2.5, 0.3, 0.4, 0.3
PER_LINE = 2
PANEL, PANEL_HEAD = 1.25, 0.3
CURVE, CURVE_HEAD, SECOND_WAY = 2.6, 0.4, 0.22
CONDITION_LETTERS = 104  # that fit in a line


def draw(result: Solution | BearingSolution, what: str, ax: Axes | None = None) -> Axes:
    """Draw one thing of a result, as its method ``plot`` does."""
    from matplotlib import axes

    drawings = OF_BEARINGS if isinstance(result, BearingSolution) else OF_CONTACTS
    one_of("what", what, tuple(drawings), "choose one of them")
    if ax is not None and not isinstance(ax, axes.Axes):
        raise InputError("ax", ax, "be axes of matplotlib", "leave it out for a figure of its own")
    drawn: Axes = drawings[what](result, ax)
    return drawn


def figures(result: Solution | BearingSolution, title: str = "") -> dict[str, Figure]:
    """Return the finished figures of a result, by name; `save` writes them.

    Parameters
    ----------
    result : Solution or BearingSolution
        A solved contact, or a loaded bearing (see `bearing_figures`).
    title : str
        Heading of every figure; none if empty.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Of a contact ``"pressure"``, ``"footprint"`` and ``"profile"``.
    """
    if isinstance(result, BearingSolution):
        return bearing_figures(result, title)
    with sheet_style():
        return {name: sheet_of(figure, title) for name, figure in figures_of(result).items()}


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
    head = title, _lines(bearing_conditions(solution))
    with sheet_style():
        found = {"loads": _loads(solution, *head)}
        if solution.method == "strips" and solution.load.any():
            found["pressure"] = _pressure(solution, *head)
            found["roller"] = sheet_of(loaded_roller(solution), *head)
        if ways := directions(solution):
            above = CURVE_HEAD + (len(ways) - 1) * SECOND_WAY
            found["displacement"], (axes,) = stacked([above], [CURVE], *head, words=MARGIN)
            displacement_against_load(solution, axes, maps=maps)
        return found


def _loads(solution: BearingSolution, title: str, words: Sequence[str]) -> Figure:
    rows = len(solution.bearing.rows)
    size, across = (ALONE, 1) if rows == 1 else (BESIDE, PER_LINE)
    block, lines = HEAD_OF_POLAR + size + 2.0 * AROUND, math.ceil(rows / across)
    bottom = lines * block + KEY
    figure = sheet(bottom, title, words, MARGIN)
    entries: dict[str, Artist] = {}
    for row in range(rows):
        line, column = divmod(row, across)
        left = WIDTH * (column + 0.5) / across - 0.5 * size
        axes: Any = panel(figure, left, bottom - line * block - HEAD_OF_POLAR - AROUND - size, size, size, "polar")
        bearing_loads(solution, axes, row=row)
        entries |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    handles, labels = list(entries.values()), list(entries)
    figure.legend(handles, labels, loc="lower center", ncols=len(labels), frameon=False, fontsize=SMALL_SIZE)
    return figure


def _pressure(solution: BearingSolution, title: str, words: Sequence[str]) -> Figure:
    panels = [(figure, ring) for figure in pressure_maps(solution) for ring in figure.panels]
    heads, heights = [PANEL_HEAD] * len(panels), [PANEL] * len(panels)
    sheet, every = stacked(heads, heights, title, words, right=BAR_ROOM, words=MARGIN)
    for (figure, ring), axes in zip(panels, every, strict=True):
        draw_titled(ring, figure, axes, last=axes is every[-1])
    # Of the height of two panels, however many there are.
    draw_colour_bar(panels[-1][1], every[-1], cax=bar_beside(*every, most=2.0 * PANEL + PANEL_HEAD))
    return sheet


def _lines(parts: Sequence[str]) -> list[str]:
    """Return parts in lines that are not too long, none of which begins within a part."""
    lines = [parts[0]]
    for part in parts[1:]:
        joined = f"{lines[-1]}; {part}"
        lines[-1:] = [joined] if len(joined) <= CONDITION_LETTERS else [lines[-1], part]
    return lines


def bearing_conditions(solution: BearingSolution) -> list[str]:
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
