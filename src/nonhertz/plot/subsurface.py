"""Stress below the surface: von Mises stress along and across the contact, with the largest stresses marked."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from nonhertz.figures.stress import across_contact, along_contact, extremes_by_name
from nonhertz.figures.value import Figure as Values
from nonhertz.plot.axes import OWN, Axes, Figure, drawing
from nonhertz.plot.drawer import draw_proportional, sheets_of
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Extremes, Field, axial_plane, cross_section
from nonhertz.subsurface.evaluation import DEEPEST, WIDEST, across_at, axial_range

# Points of the planes: denser near the surface and near both ends, where lines would have kinks.
ALONG, ACROSS, LEVELS, CROWDING = 201, 121, 81, 1.5


@drawing
def axial_stress(
    solution: Solution,
    field: Field,
    overall: Extremes,
    ax: Axes = OWN,
    *,
    station: float | None = None,
    stretch: float = 1.0,
    bar: Axes | None = None,
) -> Axes:
    """Draw the von Mises stress in a plane along the contact, y to the right and z downwards.

    The positions of the largest stresses are marked; one that lies off the plane is projected onto it, as the legend
    says. The thick line on the surface is the contact. Where a sharp end makes the stress singular it has the last
    colour, which is that of the largest stress away from there, and the colour bar ends in an arrow.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    field : Field, shape (m, n)
        The result of `nonhertz.subsurface.axial_plane`.
    overall : Extremes
        The largest stresses in that body.
    ax : matplotlib.axes.Axes, optional
        Where to draw; made smaller to fit the shape of the plane; if left out, in a figure of its own, ``ax.figure``.
    station : float, optional
        Where a cross-section lies along y [mm], drawn as a thin line.
    stretch : float
        Factor by which depth is drawn larger than y; the heading says so unless it is 1.
    bar : matplotlib.axes.Axes, optional
        Where to draw the colour bar; if left out, beside ``ax``, which shrinks to make room.
    """
    figure = along_contact(solution, field, extremes_by_name(overall), station)
    return draw_proportional(figure, ax, stretch=stretch, bar=bar)


@drawing
def section_stress(
    solution: Solution,
    field: Field,
    section: Extremes,
    ax: Axes = OWN,
    *,
    bar: Axes | None = None,
) -> Axes:
    """Draw the von Mises stress in a cross-section in true proportions, x to the right and z downwards.

    The positions of the largest stresses in it are marked, on either side of the middle. The thick line on the surface
    is the contact.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    field : Field, shape (m, n)
        The result of `nonhertz.subsurface.cross_section`.
    section : Extremes
        The largest stresses in that cross-section.
    ax : matplotlib.axes.Axes, optional
        Where to draw; made smaller to fit the shape of the plane; if left out, in a figure of its own, ``ax.figure``.
    bar : matplotlib.axes.Axes, optional
        Where to draw the colour bar; if left out, beside ``ax``, which shrinks to make room.
    """
    return draw_proportional(across_contact(solution, field, extremes_by_name(section)), ax, bar=bar)


def stress_planes(solution: Solution, section: Extremes) -> dict[str, Field]:
    """Return the stress in both planes that `stress_figures` draws, at points dense enough for smooth lines.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    section : Extremes
        The largest stresses in a cross-section of a body.

    Returns
    -------
    dict of str to Field
        Keys ``"axial-plane"``, of shape (201, 81), and ``"cross-section"``, of shape (121, 81).
    """
    body, y = section.body, section.von_mises.y
    low, high = axial_range(solution, body)[[0, -1]]
    stations = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(np.linspace(0.0, np.pi, ALONG))
    depths = DEEPEST * np.linspace(0.0, 1.0, LEVELS) ** CROWDING
    middle, half_width = across_at(solution, np.asarray(y))
    x = middle + WIDEST * half_width * np.linspace(-1.0, 1.0, ACROSS)
    return {
        "axial-plane": axial_plane(solution, stations, solution.max_half_width * depths, body=body),
        "cross-section": cross_section(solution, y, x, half_width * depths, body=body),
    }


def stress_figures(
    solution: Solution,
    overall: Extremes,
    section: Extremes,
    title: str = "",
    planes: Mapping[str, Field] | None = None,
) -> dict[str, Figure]:
    """Return one finished figure each of the plane under the centre line and of a cross-section.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    overall, section : Extremes
        The largest stresses in a body and in a cross-section of it, as `nonhertz.subsurface.extremes` returned them.
    title : str
        Heading of every figure; none if empty.
    planes : mapping of str to Field, optional
        The result of `stress_planes`; evaluated if left out.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Keys ``"axial-plane"`` and ``"cross-section"``; `save` writes them.
    """
    return sheets_of(stress_planes_drawn(solution, overall, section, planes), title)


def stress_planes_drawn(
    solution: Solution, overall: Extremes, section: Extremes, planes: Mapping[str, Field] | None = None
) -> dict[str, Values]:
    """Return the figures of `stress_figures` as values."""
    planes = stress_planes(solution, section) if planes is None else planes
    along, across = planes["axial-plane"], planes["cross-section"]
    return {
        "axial-plane": along_contact(solution, along, extremes_by_name(overall), section.von_mises.y),
        "cross-section": across_contact(solution, across, extremes_by_name(section)),
    }
