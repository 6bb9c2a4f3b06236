"""The pressure between all rollers of a row and a ring, unrolled over angle and y."""

from __future__ import annotations

from nonhertz.bearing import BearingSolution
from nonhertz.bearing.section import RINGS
from nonhertz.figures.bearing import pressure_maps
from nonhertz.inputs.checks import one_of
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_colour_bar, draw_panel, entitle


@drawing
def bearing_pressure(
    solution: BearingSolution, ax: Axes = OWN, *, ring: str = "inner", row: int = 0, colour_bar: bool = True
) -> Axes:
    """Draw the centre-line pressure between the rollers of a row and a ring over angle and y.

    Every roller is a cell of its angular pitch; nothing is interpolated between rollers. Grey is out of contact. The
    loaded side is in the middle. Colours are the same for all rows and rings of a bearing, up to its maximum pressure;
    the maximum pressure of this row and ring is marked.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.
    ring : {"inner", "outer"}
        The ring.
    row : int
        Which row of rollers, from 0.
    colour_bar : bool
        Whether to draw a colour bar, which takes room from ``ax``.

    Raises
    ------
    InputError
        If there is no such ring or row, or the bearing was solved by slices.
    """
    one_of("ring", ring, RINGS, "name one of both")
    solution.rollers_of(row)  # refuses a row that is not there
    figure = pressure_maps(solution)
    panel = figure.panels[len(RINGS) * row + RINGS.index(ring)]
    draw_panel(panel, figure, ax)
    entitle(panel, ax)
    if colour_bar:
        draw_colour_bar(panel, ax, ax=ax)
    return ax
