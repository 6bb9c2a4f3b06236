"""The loads of all rollers of a row around the bearing's axis."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

from nonhertz.bearing import BearingSolution
from nonhertz.errors import InputError
from nonhertz.figures.loads import roller_loads
from nonhertz.plot.axes import OWN, drawing
from nonhertz.plot.round import draw_round

if TYPE_CHECKING:
    from matplotlib.projections.polar import PolarAxes


@functools.partial(drawing, projection="polar")
def bearing_loads(solution: BearingSolution, ax: PolarAxes = OWN, *, row: int = 0) -> PolarAxes:
    """Draw the loads of a row's rollers as bars around the bearing's axis.

    Two bars rise from each roller: its load at the inner and at the outer ring, to the same scale for all rows. Rollers
    that the inner ring does not load are open circles. As is usual in the literature (Harris), +y, along which a single
    radial force acts, points down, so that the load zone is at the bottom; +z points right, and the view is against x.
    The arrow is the direction of the radial force on the inner ring, on all rows together.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing.
    ax : matplotlib.projections.polar.PolarAxes, optional
        Axes to draw on, made with ``projection="polar"``; by default those of a figure of its own, ``ax.figure``.
    row : int
        Which row of rollers, from 0.

    Raises
    ------
    InputError
        If the axes are not polar, or there is no such row.

    References
    ----------
    T. A. Harris, Rolling Bearing Analysis, Wiley; the figures of load distributions (recalled).
    """
    if getattr(ax, "name", None) != "polar":
        raise InputError("ax", ax, "be polar axes", 'make them with projection="polar"')
    solution.rollers_of(row)  # refuses a row that is not there
    figure = roller_loads(solution)
    return draw_round(figure.panels[row], figure, ax)
