"""The most loaded roller of a bearing: its pressure and its relief at both rings."""

from __future__ import annotations

from dataclasses import replace

from nonhertz.bearing import BearingSolution
from nonhertz.errors import InputError
from nonhertz.figures.roller import roller_lines
from nonhertz.figures.value import Figure
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_on


def _panel(solution: BearingSolution, name: str) -> Figure:
    """Return the figure of the most loaded roller with one of its panels."""
    if not solution.max_pressure.any():
        raise InputError("solution", "without load", "have a loaded roller", "load the bearing")
    figure = roller_lines(solution)
    panels = [panel for panel in figure.panels if panel.name == name]
    return replace(figure, panels=panels, conditions=figure.conditions.partition("; ")[0])


@drawing
def most_loaded_roller(solution: BearingSolution, ax: Axes = OWN) -> Axes:
    """Draw the centre-line pressure of the most loaded roller at both rings against y.

    Lines run through the centres of the strips to the ends of the contact; the maximum pressures are marked. Where the
    pressure is unbounded at a sharp end, the axis is cut.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.

    Raises
    ------
    InputError
        If no roller is loaded, or the bearing was solved by slices.
    """
    return draw_on(_panel(solution, "pressure"), ax)


@drawing
def roller_relief(solution: BearingSolution, ax: Axes = OWN) -> Axes:
    """Draw the relief of the most loaded roller and each ring together against y, and where they are in contact.

    That is the separation of the undeformed, untilted bodies: profiles and corners of both. The axis is cut where the
    relief is far larger than the elastic deformation. Bars at the bottom are the contacts.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.

    Raises
    ------
    InputError
        If no roller is loaded, or the bearing was solved by slices.
    """
    return draw_on(_panel(solution, "relief"), ax)
