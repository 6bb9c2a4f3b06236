"""Figures of several cases over each other: along contacts, or of the rollers around the axes of bearings."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from nonhertz.amounts import amount, mpa
from nonhertz.bearing.solution import BearingSolution
from nonhertz.figures.contact import land_ends, no_limits
from nonhertz.figures.value import SERIES, Axis, Figure, Level, Line, Mark, Panel, Points
from nonhertz.result.along import axial_range, contact_lines
from nonhertz.result.solution import Solution

ROOM, BEYOND = 1.08, 1.6
"""Ratio of the upper end of an axis to the largest value: usually, and with an unbounded pressure."""
NO_LIMIT = 0.9
"""Fraction of the height of the axes for words on an unbounded pressure."""
HIGH, LOW = 230, 150


def compared_contacts(solutions: Mapping[str, Solution]) -> Figure:
    """Return pressures and half-widths of solutions by name, and the separations of their bodies before loading."""
    several = [*zip(solutions.values(), _looks(solutions), strict=True)]
    half_widths = [
        Line(lines.y, lines.half_width, **look)
        for lines, look in ((contact_lines(solution), look) for solution, look in several)
    ]
    widest = max(float(solution.half_width.max()) for solution in solutions.values())
    width = Axis("Half-width b", "b", "mm", range=(0.0, ROOM * widest or 1.0))
    panels = [
        _pressures(solutions),
        Panel("half-width", "Half-width", width, half_widths, "Half-widths along y.", height=LOW),
        _separations(several),
    ]
    ends = [axial_range(solution) for solution in solutions.values()]
    span = min(low for low, _ in ends), max(high for _, high in ends)
    caption = "Centre-line pressure and half-width along the contacts, and the separation before loading."
    return Figure(Axis("Axial position y", "y", "mm", range=span), panels, caption=caption)


def _pressures(solutions: Mapping[str, Solution]) -> Panel:
    looks, marks = _looks(solutions), list[Mark]()
    cut = any(solution.singular_ends for solution in solutions.values())
    top = (BEYOND if cut else ROOM) * max(solution.max_pressure for solution in solutions.values()) or 1.0
    for solution, look in zip(solutions.values(), looks, strict=True):
        lines = contact_lines(solution)
        marks += [Line(lines.y, lines.pressure, **look), *land_ends(solution, look["colour"])]
    marks += no_limits([*solutions.values()], NO_LIMIT * top, [look["colour"] for look in looks])
    largest = " and ".join(f"{name} {mpa(solution.max_pressure):.4g}" for name, solution in solutions.items())
    words = f"Pressures on the centre line: at most {largest}."
    return Panel("pressure", "Pressure", Axis("Pressure p₀", "p₀", "MPa", range=(0.0, top), cut=cut), marks, words,
                 height=HIGH)  # fmt: skip


def _separations(several: Sequence[tuple[Solution, dict[str, Any]]]) -> Panel:
    lines, deepest = list[Line](), 0.0
    for solution, look in several:
        separation = solution.contact.separation(solution.y)
        separation = np.where(np.isfinite(separation), separation, np.nan)
        deepest = max(deepest, float(np.nanmax(separation[solution.line_load > 0.0], initial=0.0)))
        lines.append(Line(solution.y, separation, **look))
    least = min(float(np.nanmin(line.y)) for line in lines)
    # Beyond the contact a relief may rise to tenths of a millimetre.
    distances = (min(0.0, least) - 0.15 * deepest, BEYOND * deepest or 1.0)
    gap = Axis("Separation", "separation", "mm", "um", distances, cut=True)
    words = "Separations of the bodies before loading."
    return Panel("separation", "Separation", gap, [Level(0.0, colour="faint"), *lines], words, height=LOW)


def all_pressed(solutions: Mapping[str, BearingSolution]) -> bool:
    """Return whether all bearings have pressures, which slices do not have."""
    return all(solution.method == "strips" for solution in solutions.values())


def compared_bearings(solutions: Mapping[str, BearingSolution]) -> Figure:
    """Return the loads of all rollers of bearings by name, and their maximum pressures if all have any."""
    panels = [_around(solutions, "load", Axis("Load at the inner ring", "load", "N"))]
    if all_pressed(solutions):
        panels.append(_around(solutions, "max_pressure", Axis("Maximum pressure", "p", "MPa")))
    ticks = tuple((float(angle), f"{angle:g}".replace("-", "−")) for angle in np.arange(-180.0, 181.0, 45.0))
    along = Axis("Angle of the roller [degrees]", "angle", "°", range=(-180.0, 180.0), ticks=ticks)
    what = "Load and maximum pressure" if all_pressed(solutions) else "Load"
    return Figure(along, panels, caption=f"{what} of the rollers at the inner ring over their angle.")


def _around(solutions: Mapping[str, BearingSolution], name: str, axis: Axis) -> Panel:
    """Return numbers of rollers over their angle, a line for each row."""
    marks: list[Mark] = []
    largest = {title: float(getattr(solution, name)[:, 0].max()) for title, solution in solutions.items()}
    for solution, look in zip(solutions.values(), _looks(solutions), strict=True):
        angles, values = [], []
        for row in range(len(solution.bearing.rows)):
            these = solution.rollers_of(row)
            angle = (np.degrees(solution.angle[these]) + 180.0) % 360.0 - 180.0
            order = np.argsort(angle)
            angles += [*angle[order], np.nan]
            values += [*getattr(solution, name)[these, 0][order], np.nan]
        along, upright = np.array(angles), np.array(values)
        marks.append(Line(along, upright, **look))
        marks.append(Points(along, upright, symbol="dot", colour=look["colour"]))
    top = ROOM * max(largest.values()) or 1.0
    upright_axis = Axis(axis.label, axis.symbol, axis.unit, range=(0.0, top))
    words = " and ".join(f"{amount([value], axis.unit):.4g} of {title}" for title, value in largest.items())
    description = f"{axis.label} over the angle of the roller: at most {words}."
    return Panel(name, axis.label, upright_axis, marks, description, height=HIGH)


def _looks(solutions: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return name, colour and dashes of each; with a number, as the first underscore would hide a file's name."""
    looks = itertools.cycle(SERIES)
    return [
        {"name": f"{number}  {name}", "colour": colour, "dash": dash}
        for number, (name, (colour, dash)) in enumerate(zip(solutions, looks, strict=False), start=1)
    ]
