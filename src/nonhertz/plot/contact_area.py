"""The contact area, seen along the common normal."""

from __future__ import annotations

from nonhertz.figures import contact
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_colour_bar, draw_panel, proportions
from nonhertz.plot.style import SMALL_SIZE
from nonhertz.result.solution import Solution


@drawing
def footprint(solution: Solution, ax: Axes = OWN, *, stretch: float = 1.0, colour_bar: bool = True) -> Axes:
    """Draw the contact area in true proportions, y to the right and x upwards, coloured by its pressure.

    The outline is the half-width at the strips' centres. In x the pressure is the strip element's own,
    ``p0 sqrt(1 - x^2/b^2)`` for the semi-elliptic one. The parabolic one, ``p(0) (1 - x^2/c^2)``, is wider
    than the Hertz contact of equal load: the area drawn is its own and the dotted line is the half-width b.
    Where a sharp end makes the pressure singular, the strips there have the last colour and the colour bar ends
    in an arrow.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    ax : matplotlib.axes.Axes, optional
        Where to draw; the limits are widened to fit its shape; if left out, in a figure of its own, ``ax.figure``.
    stretch : float
        Factor by which x is drawn larger than y; the axes say so unless it is 1.
    colour_bar : bool
        Whether to draw a colour bar below, which takes room from ``ax``.
    """
    figure = contact.footprint(solution)
    (panel,) = figure.panels
    draw_panel(panel, figure, ax, stretch=stretch)
    ax.set_title(proportions(panel, stretch), loc="left", fontsize=SMALL_SIZE)
    if colour_bar and solution.contact_y:
        draw_colour_bar(panel, ax, ax=ax, orientation="horizontal", aspect=40)
    return ax
