"""Figure of strips and plane grid on one case: pressure along the contact, its differences, and three cuts across."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import format_input, mm, mpa
from nonhertz.comparison import Comparison, Station
from nonhertz.comparison.value import NOTABLE
from nonhertz.figures.contact import conditions, ends_of_bodies, unlimited_pressure
from nonhertz.figures.value import Across, Axis, Band, Figure, Level, Line, Mark, Panel, Points, Words
from nonhertz.result.along import axial_range, unlimited_ends
from nonhertz.result.solution import Solution
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC

Array = NDArray[np.float64]

BEYOND, ROOM = 1.6, 1.12
"""Ratio of the upper end of an axis to the maximum pressure: with an unbounded pressure at an end, and without."""
LARGEST, REACH = 1.0, 1.4
"""Differences beyond which they stand at the end of their axis, and its ends over these."""
CROWDED = 0.025
"""Of the range along: stations closer together have their letters on opposite sides."""
ACROSS = 201
"""Points of the shape that strips assume across."""
# By name: a solution from another process has a copy of the element.
STRIPS: dict[str, dict[str, Any]] = {
    SEMI_ELLIPTIC.name: {"colour": "first"}, PARABOLIC.name: {"colour": "second", "symbol": "cross"},
}  # fmt: skip
SHAPES: dict[str, dict[str, Any]] = {
    SEMI_ELLIPTIC.name: {"colour": "first"}, PARABOLIC.name: {"colour": "second", "dash": "dashed"},
}  # fmt: skip


def compared_methods(comparison: Comparison) -> Figure:
    """Return the figure of `nonhertz.plot.comparison`.

    Differences are relative to the plane grid; those over 100 %, and infinite ones, stand at 100 %.
    """
    cells = " × ".join(map(str, comparison.patch.cells))
    panels = _along(comparison), _differences(comparison), *_across(comparison)
    along = Axis("Axial position y", "y", "mm", range=axial_range(comparison.semi_elliptic))
    caption = (
        "Pressure on the centre line by strips and by a plane grid, the difference of each strip, and the pressure "
        "across the contact at three stations."
    )
    return Figure(along, panels, f"{conditions(comparison.semi_elliptic)}; plane grid of {cells} cells", caption)


def _names(comparison: Comparison) -> list[str]:
    """Return plane grid and strips with their times, as the legend has them."""
    times, strips = comparison.seconds, [f"{one.strips} {one.element.name} strips" for one in comparison.strips]
    seconds = times.patch, times.semi_elliptic, times.parabolic
    return [f"{name}, {_time(time)}" for name, time in zip(("plane grid", *strips), seconds, strict=True)]


def _along(comparison: Comparison) -> Panel:
    patch, semi, (of_grid, *of_strips) = comparison.patch, comparison.semi_elliptic, _names(comparison)
    shown = _with_neighbours(patch.centre_pressure > 0.0)
    marks: list[Mark] = [*ends_of_bodies(semi, named=False), *_stations(comparison)]
    marks.append(Line(patch.y[shown], patch.centre_pressure[shown], name=of_grid, colour="ink"))
    for solution, name in zip(comparison.strips, of_strips, strict=True):
        pressed = solution.line_load > 0.0
        places = solution.y[pressed], solution.centre_pressure[pressed]
        marks.append(Points(*places, name=name, **STRIPS[solution.element.name]))
    cut = bool(semi.singular_ends)
    top = BEYOND * semi.max_pressure if cut else ROOM * max(semi.max_pressure, float(patch.centre_pressure.max()))
    largest = comparison.quantity("maximum pressure")
    words = f"{mpa(largest.patch):.4g} by the plane grid, {mpa(largest.semi_elliptic):.4g} by semi-elliptic strips and"
    description = f"Pressure on the centre line: at most {words} {mpa(largest.parabolic):.4g} by parabolic ones."
    upright = Axis("Pressure at x = 0", "p₀", "MPa", range=(0.0, top), cut=cut)
    marks += (unlimited_pressure(semi, edge, top) for edge in unlimited_ends(semi))
    return Panel("pressure", "", upright, marks, description, height=200)


def _differences(comparison: Comparison) -> Panel:
    span = np.array(axial_range(comparison.semi_elliptic))
    notable = np.full(2, NOTABLE)
    marks: list[Mark] = [Band(span, -notable, notable, colour="faint"), Level(0.0, colour="faint")]
    marks += [*ends_of_bodies(comparison.semi_elliptic, named=False)]
    for solution, name in zip(comparison.strips, _names(comparison)[1:], strict=True):
        values = np.clip(comparison.along(solution), -LARGEST, LARGEST)
        marks.append(Points(solution.y, values, name=name, **STRIPS[solution.element.name]))
    upright = Axis("Difference", "difference", read="%", range=(-REACH * LARGEST, REACH * LARGEST), linear=NOTABLE)
    count = len(comparison.stretches)
    description = f"Differences from the plane grid: over 1 % on {count or 'no'} stretch{'' if count == 1 else 'es'}."
    return Panel("difference", "", upright, marks, description, height=110)


def _stations(comparison: Comparison) -> Iterator[Mark]:
    """Yield a line at every station and, under the pressure, the letter that the cuts across repeat."""
    low, high = axial_range(comparison.semi_elliptic)
    for letter, station in zip("ABC", comparison.stations, strict=True):
        yield Across(station.y, colour="faint", dash="dotted")
        apart = [station.y - other.y for other in comparison.stations]
        inwards = comparison.stations[0].y - station.y
        near = next((by for by in apart if 0.0 < abs(by) < CROWDED * (high - low)), inwards)
        yield Words(station.y, 0.0, letter, "left" if near > 0.0 else "right", colour="faint")


def _across(comparison: Comparison) -> Iterator[Panel]:
    """Yield the pressure across at every station: of each cell, and as the strips assume it."""
    of_grid, *of_strips = _names(comparison)
    for letter, station in zip("ABC", comparison.stations, strict=True):
        x, pressure = comparison.patch.across(station.y)
        touching = _with_neighbours(pressure > 0.0)
        marks: list[Mark] = []
        for solution, name in zip(comparison.strips, of_strips, strict=True):
            marks.append(Line(*_own_shape(solution, station.y), name=name, **SHAPES[solution.element.name]))
        marks.append(Points(x[touching], pressure[touching], "dot", name=of_grid, colour="ink"))
        reach = ROOM * max(float(np.max(np.abs(mark.x[mark.y > 0.0]), initial=0.0)) for mark in marks)  # type: ignore[attr-defined]
        top = ROOM * max(float(mark.y.max(initial=0.0)) for mark in marks)  # type: ignore[attr-defined]
        yield Panel(
            f"across {letter}",
            f"{letter}: y = {mm(station.y):.3g},\n{station.reason}",
            Axis("Pressure p", "p", "MPa", range=(0.0, top or 1.0)),
            marks,
            _sentence(station, pressure),
            height=155,
            along=Axis("Across x", "x", "mm", range=(-reach or -1.0, reach or 1.0)),
            beside=letter != "A",
        )


def _sentence(station: Station, pressure: Array) -> str:
    largest = mpa(float(pressure.max()))
    return f"Pressure across at y = {mm(station.y):.4g}, {station.reason}: at most {largest:.4g} by the plane grid."


def _with_neighbours(touching: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Add a cell at either end, where the pressure is zero unless the bodies end."""
    return np.convolve(touching, [1, 1, 1], mode="same") > 0


def _own_shape(solution: Solution, y: float) -> tuple[Array, Array]:
    """Return x [mm] and the pressure [MPa] that the strips assume across, linear between their centres."""
    width = float(np.interp(y, solution.y, solution.element_half_width))
    load = float(np.interp(y, solution.y, solution.line_load))
    share = np.linspace(-1.0, 1.0, ACROSS)
    if width == 0.0:
        return 0.0 * share, 0.0 * share
    if solution.element.name == PARABOLIC.name:
        return width * share, 0.75 * load / width * (1.0 - share**2)
    return width * share, 2.0 * load / (math.pi * width) * np.sqrt(1.0 - share**2)


def _time(seconds: float) -> str:
    return f"{format_input(1e3 * seconds, 2)} ms" if seconds < 1.0 else f"{format_input(seconds, 2)} s"
