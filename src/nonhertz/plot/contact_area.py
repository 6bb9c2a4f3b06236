"""The contact area, seen along the common normal."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonhertz.plot.axes import OWN, ROUND, Axes, drawing, measure
from nonhertz.plot.axial import draw_body_ends, number
from nonhertz.plot.style import COLOUR_MAP, HINT_DASHES, INK, SMALL_SIZE, THIN
from nonhertz.result.along import axial_range
from nonhertz.result.area import outlines
from nonhertz.result.solution import Solution
from nonhertz.strip.element import PARABOLIC

# Points across the contact at which the pressure is coloured, equally spaced in the angle whose sine is x/a:
# the semi-ellipse falls vertically at its edge.
ACROSS = 65
ROUNDING = 1e-9  # by which a pressure may exceed the last colour without an arrow


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
    pieces = outlines(solution)
    length, stress = measure("mm"), measure("MPa")
    reach = length.factor * 1.15 * float(solution.element_half_width.max()) or 1.0
    draw_body_ends(solution, ax, named=False)
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, ACROSS)[:, None]
    for piece in pieces:
        # With x = a sin(angle), the root of 1 - x^2/a^2 is the cosine.
        pressure = np.cos(angle) ** (2 if _parabolic(solution) else 1) * piece.pressure
        x = np.sin(angle) * piece.half_width
        # Thousands of small polygons in an SVG file would show seams, so the pressure is rasterised.
        ax.pcolormesh(
            length(np.broadcast_to(piece.y, x.shape)), length(x), stress(pressure), shading="gouraud", cmap=COLOUR_MAP,
            vmin=0.0, vmax=stress.factor * colour_limit(solution), rasterized=True, zorder=1.0,
        )  # fmt: skip
        ax.plot(*(length(each) for each in piece.closed()), color=INK, linewidth=THIN, solid_joinstyle="round")
        if _parabolic(solution):
            for sign in (-1.0, 1.0):
                hertz = sign * PARABOLIC.hertz_ratio * piece.half_width
                ax.plot(length(piece.y), length(hertz), color="white", linewidth=THIN, linestyle=HINT_DASHES)
    ax.locator_params(steps=ROUND)
    # Automatic limits stay on, or matplotlib would warn when it widens these to fit the shape of the axes.
    ax.set_xlim(*length(axial_range(solution)), auto=True)
    ax.set_ylim(-reach, reach, auto=True)
    ax.set_aspect(stretch, adjustable="datalim")
    ax.set_xlabel(length.label("Axial position $y$"))
    ax.set_ylabel(length.label("$x$"))
    words = "True proportions" if stretch == 1.0 else f"$x$ stretched {number(stretch)} times"
    if _parabolic(solution):
        words += "; the parabolic strips' own width, dotted: Hertz half-width $b$"
    ax.set_title(words, loc="left", fontsize=SMALL_SIZE)
    if colour_bar and pieces:
        draw_colour_bar(solution, ax, ax=ax, orientation="horizontal", aspect=40)
    return ax


def colour_limit(solution: Solution) -> float:
    """Return the pressure [MPa] of the last colour: the largest, in the middle of the element's own shape."""
    of_equivalent = 0.5 * np.pi * solution.element.hertz_ratio * solution.element.centre_factor
    return of_equivalent * solution.max_pressure or 1.0


def draw_colour_bar(solution: Solution, area: Axes, **where: Any) -> None:
    """Draw the colour bar of an ``area`` in its figure, ending in an arrow if pressures exceed the last colour."""
    highest = colour_limit(solution)
    beyond = any(piece.pressure.max() > (1.0 + ROUNDING) * highest for piece in outlines(solution))
    colour_bar_to(highest, "Pressure $p$", area, beyond=beyond, **where)


def colour_bar_to(highest: float, words: str, area: Axes, *, beyond: bool, **where: Any) -> None:
    """Draw a colour bar of pressures up to the last colour [MPa], ending in an arrow if there are some beyond."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    stress = measure("MPa")
    colours = ScalarMappable(Normalize(0.0, stress.factor * highest), COLOUR_MAP)
    area.figure.colorbar(colours, label=stress.label(words), extend="max" if beyond else "neither", **where)


def _parabolic(solution: Solution) -> bool:
    # By name: a solution from another process has a copy of the element.
    return solution.element.name == PARABOLIC.name
