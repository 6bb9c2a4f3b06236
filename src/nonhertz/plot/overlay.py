"""Several cases in one figure: what is along the contacts, or the rollers around the axes of bearings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from nonhertz.bearing import BearingSolution
from nonhertz.plot.axes import Axes, Figure, Measure, along, key_above, measure, open_frame
from nonhertz.plot.axial import mark_land_ends, mark_unlimited
from nonhertz.plot.sheets import stacked
from nonhertz.plot.style import FAINT_INK, HAIR, LINE, PALETTE, sheet_style
from nonhertz.result.along import axial_range
from nonhertz.result.solution import Solution

HIGH, LOW, BETWEEN, ROW = 2.3, 1.5, 0.25, 0.17  # inches; the last is a line of the legend
ROOM, BEYOND = 1.08, 1.6  # axis limit over the largest value: usually, and where a pressure has no limit


def compared_contacts(found: Mapping[str, Solution]) -> Figure:
    """Return a sheet with the pressure of solutions by name and, below, half-widths and separations before loading."""
    with sheet_style():
        figure, (upper, middle, lower) = _sheet([HIGH, LOW, LOW], len(found))
        tops = []
        length, stress, distance = measure("mm"), measure("MPa"), measure("mm", "um")
        for solution, (colour, dashes) in zip(found.values(), lines_of(len(found)), strict=True):
            drawn: dict[str, Any] = {"color": colour, "linestyle": dashes, "linewidth": LINE}
            separation = distance(solution.contact.separation(solution.y))
            separation = np.where(np.isfinite(separation), separation, np.nan)
            touching = separation[solution.line_load > 0.0]
            tops.append(float(np.nanmax(touching)) if touching.size else 0.0)
            pressure, half_width = stress(solution.centre_pressure), length(solution.half_width)
            for axes, values in ((upper, pressure), (middle, half_width), (lower, separation)):
                axes.plot(length(solution.y), values, **drawn)
            mark_land_ends(solution, upper, colour)
        sharp = any(each.singular_ends for each in found.values())
        highest = stress.factor * max(each.max_pressure for each in found.values())
        widest = length.factor * max(float(each.half_width.max()) for each in found.values())
        upper.set_ylim(0.0, highest * (BEYOND if sharp else ROOM) or 1.0)
        middle.set_ylim(0.0, widest * ROOM or 1.0)
        # Beyond the contact a relief may rise to tenths of a millimetre.
        lower.set_ylim(min(0.0, *lower.get_ylim()), BEYOND * max(tops) or 1.0)
        lower.axhline(0.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
        mark_unlimited([*found.values()], upper, [colour for colour, _ in lines_of(len(found))])
        upper.set_ylabel(stress.label("Centre-line pressure $p_0$"))
        middle.set_ylabel(length.label("Half-width $b$"))
        lower.set_ylabel(distance.label("Separation"))
        spans = [*map(axial_range, found.values())]
        for axes in (upper, middle, lower):
            span = min(low for low, _ in spans), max(high for _, high in spans)
            along(axes, span, labelled=axes is lower)
        _legend(upper, upper.lines[: len(found)], [*found])
        return figure


def all_pressed(found: Mapping[str, BearingSolution]) -> bool:
    """Return whether all bearings have pressures, which slices have not."""
    return all(each.method == "strips" for each in found.values())


def compared_bearings(found: Mapping[str, BearingSolution]) -> Figure:
    """Return a sheet with the loads of all rollers of solved bearings and, below, their pressures if all have any."""
    curves = {"load": ("Load at the inner ring", "N")}
    if all_pressed(found):
        curves["max_pressure"] = ("Maximum pressure", "MPa")
    with sheet_style():
        figure, every = _sheet([HIGH] * len(curves), len(found))
        for axes, (name, (label, unit)) in zip(every, curves.items(), strict=True):
            largest = [float(getattr(each, name)[:, 0].max()) for each in found.values()]
            drawn = measure(unit, values=largest)
            handles = _around(axes, found, name, drawn)
            axes.set_ylabel(drawn.label(label))
            if axes is every[0]:
                _legend(axes, handles, [*found])
        every[-1].set_xlabel("Angle of the roller [degrees]")
        return figure


def _around(axes: Axes, found: Mapping[str, BearingSolution], name: str, drawn: Measure) -> list[object]:
    """Draw a line for each row of each bearing, and return one of each bearing for the key."""
    handles: list[object] = []
    for solution, (colour, dashes) in zip(found.values(), lines_of(len(found)), strict=True):
        look: dict[str, Any] = {"color": colour, "linestyle": dashes, "linewidth": LINE, "marker": "o"}
        for row in range(len(solution.bearing.rows)):
            these = solution.rollers_of(row)
            angle = (np.degrees(solution.angle[these]) + 180.0) % 360.0 - 180.0
            order = np.argsort(angle)
            values = drawn(getattr(solution, name)[these, 0])
            (line,) = axes.plot(angle[order], values[order], markersize=3.0, **look)
            if row == 0:
                handles.append(line)
    axes.set_ylim(0.0, ROOM * max(float(np.max(line.get_ydata())) for line in axes.lines) or 1.0)
    axes.set_xlim(-180.0, 180.0)
    axes.set_xticks(np.arange(-180.0, 181.0, 45.0))
    return handles


def _sheet(heights: Sequence[float], count: int) -> tuple[Figure, list[Axes]]:
    """Return a sheet of panels one below the other, with room above for a legend of so many lines."""
    figure, panels = stacked([0.12 + ROW * count, *[BETWEEN] * (len(heights) - 1)], heights)
    open_frame(*panels)
    for axes in panels:
        axes.tick_params(labelbottom=axes is panels[-1])
    return figure, panels


def lines_of(count: int) -> list[tuple[str, Any]]:
    """Return the colour and the dashes of each of so many cases."""
    return [PALETTE[number % len(PALETTE)] for number in range(count)]


def _legend(axes: Axes, handles: Sequence[Any], labels: Sequence[str]) -> None:
    """Put the legend above the axes, one line per case: it must not cover a curve, and names may be long."""
    numbers = [str(number) for number in range(1, len(labels) + 1)]
    drawn = key_above(axes, handles, numbers, columns=1, labelspacing=0.25, handlelength=3.2)
    for text, number, label in zip(drawn.get_texts(), numbers, labels, strict=True):
        # A file's name: a dollar sign must not start mathtext, nor a leading underscore hide the entry.
        text.set_parse_math(False)
        text.set_text(f"{number}  {label}")
