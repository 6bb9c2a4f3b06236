"""Figures of a loaded bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm, mpa
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution, UnrolledPressure
from nonhertz.figures.angles import around, loaded_middle, turn_axis
from nonhertz.figures.displacement import displacement_against_load
from nonhertz.figures.film import film_figures
from nonhertz.figures.forces import conditions, directions
from nonhertz.figures.loads import roller_loads
from nonhertz.figures.perspective import pressure_ridges
from nonhertz.figures.roller import roller_lines
from nonhertz.figures.unrolled import ring_heading, unrolled_pressures
from nonhertz.figures.value import Across, Axis, Cells, Figure, Panel, Points, Span

if TYPE_CHECKING:
    from nonhertz.bearing import BearingMaps
    from nonhertz.bearing.film import Films

Array = NDArray[np.float64]

ON_A_GRID = 1.01
"""Ratio to the maximum pressure up to which interpolation from strips to the map does not count as beyond it."""


def figures_of(
    solution: BearingSolution, maps: BearingMaps | None = None, films: Films | None = None
) -> dict[str, Figure]:
    """Return all figures of a loaded bearing by the names of their files; see `nonhertz.plot.bearing_figures`."""
    drawn = {"loads": roller_loads(solution)}
    if solution.method == "strips" and solution.load.any():
        drawn |= {
            "pressure": pressure_maps(solution),
            "perspective": pressure_ridges(solution),
            "roller": roller_lines(solution),
        }
    if directions(solution):
        drawn["displacement"] = displacement_against_load(solution, maps)
    return drawn | ({} if films is None else film_figures(films))


def pressure_maps(solution: BearingSolution, points: int = 401) -> Figure:
    """Return the pressure of all rollers, a panel for each row and ring; see `nonhertz.plot.bearing_pressure`.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.
    points : int
        Places along the rollers.

    Raises
    ------
    InputError
        If the bearing was solved by slices.
    """
    middle = loaded_middle(solution)
    limit = float(solution.max_pressure.max()) or 1.0
    rows = unrolled_pressures(solution, points)
    largest = max(float(unrolled.pressure.max()) for both in rows for unrolled in both)
    colours = Axis("Centre-line pressure p₀", "p₀", "MPa", range=(0.0, limit), cut=largest > ON_A_GRID * limit)
    panels = [_panel(solution, unrolled, middle, colours) for both in rows for unrolled in both]
    caption = "Pressure of all rollers on the centre lines of their contacts, over the angle and along the roller."
    return Figure(turn_axis(middle), panels, conditions(solution), caption)


def _panel(solution: BearingSolution, unrolled: UnrolledPressure, middle: float, colours: Axis) -> Panel:
    ring, places = unrolled.ring, unrolled.y
    pitch = 360.0 / unrolled.angle.size
    turned = around(np.degrees(unrolled.angle), middle)
    order = np.argsort(turned)
    # The roller that half a turn from the middle cuts is at both ends; all rows have the same axis.
    order = np.concatenate([order[-1:], order, order[:1]])
    edges = turned[order[0]] - 360.0 + pitch * (np.arange(order.size + 1) - 0.5)
    between = np.concatenate([places[:1], 0.5 * (places[1:] + places[:-1]), places[-1:]])
    pressure = unrolled.pressure[order]
    heading = ring_heading(solution, ring, unrolled.row)
    words, marks = "no roller loaded", []
    these = solution.rollers_of(unrolled.row)
    of_ring = RINGS.index(ring)
    largest = solution.max_pressure[these, of_ring]
    most = int(largest.argmax())
    if largest[most] > 0.0:
        y, angle = float(solution.max_pressure_y[these, of_ring][most]), np.degrees(unrolled.angle[most : most + 1])
        marks = [Points(around(angle, middle), np.array([y]), colour="ink")]
        words = f"largest {mpa(float(largest[most])):.4g} at {angle[0]:.4g}°, y = {mm(y):.3g}"
    return Panel(
        f"map-{ring}",
        heading,
        Axis("y", "y", "mm", range=(float(places[0]), float(places[-1]))),
        [
            Span(middle - 180.0, middle + 180.0, colour="faint"),
            Cells(edges, between, np.where(pressure > 0.0, pressure, np.nan)),
            *(Across(edge, colour="paper") for edge in edges[1:-1].tolist()),
            *marks,
        ],
        f"{heading}, of all rollers over angle and y: {words}.",
        words,
        118,
        colours=colours,
    )
