"""Figures of several cases over each other: what is along contacts, or the rollers around the axes of bearings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nonhertz.amounts import mpa
from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.contact import land_ends, no_limits
from nonhertz.figures.value import SERIES, Axis, Figure, Level, Line, Mark, Panel, Points
from nonhertz.result.along import axial_range, contact_lines
from nonhertz.result.solution import Solution

ROOM, BEYOND = 1.08, 1.6
"""Upper end of an axis over the largest value: usually, and where a pressure has no limit."""
NO_LIMIT = 0.9
"""Of the height of the axes, where it is said of an end that the pressure has none."""
HIGH, LOW = 230, 150


def compared_contacts(solutions: Mapping[str, Solution]) -> Figure:
    """Return pressures and half-widths of solutions by name, and the separations of their bodies before loading."""
    pressures, widths, separations = list[Mark](), list[Mark](), list[Mark]([Level(0.0, colour="faint")])
    deepest = []
    sharp = any(solution.singular_ends for solution in solutions.values())
    top = (BEYOND if sharp else ROOM) * max(solution.max_pressure for solution in solutions.values()) or 1.0
    for (name, solution), look in zip(_numbered(solutions), _looks(solutions), strict=True):
        lines = contact_lines(solution)
        separation = solution.contact.separation(solution.y)
        separation = np.where(np.isfinite(separation), separation, np.nan)
        deepest.append(float(np.nanmax(separation[solution.line_load > 0.0], initial=0.0)))
        pressures.append(Line(lines.y, lines.pressure, name=name, **look))
        widths.append(Line(lines.y, lines.half_width, **look))
        separations.append(Line(solution.y, separation, **look))
        pressures += land_ends(solution, look["colour"])
    pressures += no_limits([*solutions.values()], NO_LIMIT * top, [look["colour"] for look in _looks(solutions)])
    widest = max(float(solution.half_width.max()) for solution in solutions.values())
    least = min(float(np.nanmin(mark.y)) for mark in separations if isinstance(mark, Line))
    # Beyond the contact a relief may rise to tenths of a millimetre.
    distances = (min(0.0, least) - 0.15 * max(deepest), BEYOND * max(deepest) or 1.0)
    largest = " and ".join(f"{name} {mpa(solution.max_pressure):.4g}" for name, solution in solutions.items())
    words = f"Pressures on the centre line: at most {largest}."
    gap = Axis("Separation", "separation", "mm", "um", distances, cut=True)
    panels = [
        Panel("pressure", "Pressure", Axis("Pressure p₀", "p₀", "MPa", range=(0.0, top), cut=sharp), pressures, words,
              height=HIGH),
        Panel("half-width", "Half-width", Axis("Half-width b", "b", "mm", range=(0.0, ROOM * widest or 1.0)), widths,
              "Half-widths along y.", height=LOW),
        Panel("separation", "Separation", gap, separations, "Separations of the bodies before loading.", height=LOW),
    ]  # fmt: skip
    ends = [axial_range(solution) for solution in solutions.values()]
    span = min(low for low, _ in ends), max(high for _, high in ends)
    caption = "Centre-line pressure and half-width along the contacts, and the separation before loading."
    return Figure(Axis("Axial position y", "y", "mm", range=span), panels, caption=caption)


def all_pressed(solutions: Mapping[str, BearingSolution]) -> bool:
    """Return whether all bearings have pressures, which slices have not."""
    return all(solution.method == "strips" for solution in solutions.values())


def compared_bearings(solutions: Mapping[str, BearingSolution]) -> Figure:
    """Return the loads of all rollers of bearings by name, and their largest pressures if all have any."""
    panels = [_around(solutions, "load", Axis("Load at the inner ring", "load", "N"))]
    if all_pressed(solutions):
        panels.append(_around(solutions, "max_pressure", Axis("Largest pressure", "p", "MPa")))
    ticks = tuple((float(angle), f"{angle:g}".replace("-", "−")) for angle in np.arange(-180.0, 181.0, 45.0))
    along = Axis("Angle of the roller [degrees]", "angle", "°", range=(-180.0, 180.0), ticks=ticks)
    what = "Load and maximum pressure" if all_pressed(solutions) else "Load"
    return Figure(along, panels, caption=f"{what} of the rollers at the inner ring over their angle.")


def _around(solutions: Mapping[str, BearingSolution], name: str, axis: Axis) -> Panel:
    """Return numbers of rollers over their angle, a line for each row."""
    marks: list[Mark] = []
    largest = {title: float(getattr(solution, name)[:, 0].max()) for title, solution in solutions.items()}
    for (words, solution), look in zip(_numbered(solutions), _looks(solutions), strict=True):
        angles, values = [], []
        for row in range(len(solution.bearing.rows)):
            these = solution.rollers_of(row)
            angle = (np.degrees(solution.angle[these]) + 180.0) % 360.0 - 180.0
            order = np.argsort(angle)
            angles += [*angle[order], np.nan]
            values += [*getattr(solution, name)[these, 0][order], np.nan]
        along, upright = np.array(angles), np.array(values)
        marks.append(Line(along, upright, name=words if name == "load" else "", **look))
        marks.append(Points(along, upright, symbol="dot", colour=look["colour"]))
    top = ROOM * max(largest.values()) or 1.0
    upright_axis = Axis(axis.label, axis.symbol, axis.unit, range=(0.0, top))
    words = " and ".join(f"{upright_axis.symbol} {value:.4g} {axis.unit} of {name}" for name, value in largest.items())
    return Panel(name, axis.label, upright_axis, marks, f"{axis.label} over the angle of the roller: at most {words}.",
                 height=HIGH)  # fmt: skip


def _numbered(solutions: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Return names with a number: of a file's name the first underscore would hide it."""
    return [(f"{number}  {name}", solution) for number, (name, solution) in enumerate(solutions.items(), start=1)]


def _looks(solutions: Mapping[str, Any]) -> list[dict[str, Any]]:
    return [
        dict(zip(("colour", "dash"), SERIES[number % len(SERIES)], strict=True)) for number in range(len(solutions))
    ]
