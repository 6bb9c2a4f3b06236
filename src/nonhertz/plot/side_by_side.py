"""Strips and plane grid on one sheet: along the centre line, and across at three stations."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonhertz.comparison import Comparison, Station
from nonhertz.comparison.value import NOTABLE
from nonhertz.figures.contact import conditions
from nonhertz.plot.axes import Alignment, Array, Axes, Figure, along, key_above, measure, note, open_frame
from nonhertz.plot.axial import draw_body_ends, mark_unlimited, number, place
from nonhertz.plot.sheets import LEFT, MARGIN, WIDTH, panel, stacked
from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, INK, LINE, PALE, SECOND, SIZE, SMALL_SIZE, THIN, sheet_style
from nonhertz.result.along import axial_range
from nonhertz.result.solution import Solution
from nonhertz.strip.element import PARABOLIC

# Inches, from the top.
HEAD, TALL, GAP, SLIM, BETWEEN, LOW, BOTTOM, APART = 0.28, 2.0, 0.22, 0.95, 0.92, 1.55, 0.5, 0.42
BEYOND = 1.6  # upper end of the axis over the largest pressure away from singular ends
ROOM = 1.12
FAINTEST, LARGEST = 0.1, 100.0  # per cent, between which the axis of differences is logarithmic
CROWDED = 0.025  # of the drawn range: stations closer together have their letters on opposite sides
# How strips are drawn by their element: one by one, and the shape that they assume across.
OPEN: dict[str, Any] = {"markeredgewidth": THIN, "markerfacecolor": "none"}
MARKS: dict[str, dict[str, Any]] = {
    "semi-elliptic": {"marker": "o", "color": FIRST, **OPEN}, "parabolic": {"marker": "x", "color": SECOND, **OPEN},
}  # fmt: skip
SHAPES: dict[str, dict[str, Any]] = {
    "semi-elliptic": {"color": FIRST, "linestyle": "-"}, "parabolic": {"color": SECOND, "linestyle": (0, (3, 1.2))},
}  # fmt: skip
ACROSS = 201  # points of a strip's own shape


def comparison(found: Comparison, title: str = "") -> Figure:
    """Return a sheet of strips and plane grid: pressure along the contact, its differences, and three cuts across.

    The plane grid is a line, and each strip of either element a marker; differences are relative to the plane grid, on
    an axis that is linear up to 0.1 % and logarithmic beyond. Across, each cell is a dot and the strips are drawn with
    the shape they assume. Where a sharp end makes the pressure singular, the pressure axis is cut.

    Parameters
    ----------
    found : Comparison
        What `nonhertz.compare` returned.
    title : str
        Heading; none if empty.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    with sheet_style():
        room = BOTTOM + LOW + BETWEEN
        words = f"{conditions(found.semi_elliptic)}; plane grid of {' × '.join(map(str, found.patch.cells))} cells"
        figure, (upper, slim) = stacked([HEAD, GAP], [TALL, SLIM], title, [words], bottom=room)
        _draw_along(found, upper)
        draw_differences(found, slim)
        _mark_stations(found, slim, named=False)
        each = (WIDTH - LEFT - MARGIN - 2.0 * APART) / 3.0
        lows = [panel(figure, LEFT + k * (each + APART), BOTTOM, each, LOW) for k in range(3)]
        for axes, station in zip(lows, found.stations, strict=True):
            draw_across(found, axes, station)
        lows[0].set_ylabel(measure("MPa").label("Pressure $p$"))
    return figure


def _draw_along(found: Comparison, axes: Axes) -> None:
    patch, semi = found.patch, found.semi_elliptic
    length, stress = measure("mm"), measure("MPa")
    touching = patch.centre_pressure > 0.0
    # One cell more at either end, where the pressure is zero unless the bodies end.
    shown = np.convolve(touching, [1, 1, 1], mode="same") > 0
    axes.plot(length(patch.y[shown]), stress(patch.centre_pressure[shown]), color=INK, linewidth=THIN, zorder=2.0)
    for solution in found.strips:
        pressed = solution.line_load > 0.0
        strips = length(solution.y[pressed]), stress(solution.centre_pressure[pressed])
        axes.plot(*strips, linestyle="none", markersize=3.2, zorder=3.0, **MARKS[solution.element.name])
    # Above all pressures except singular ones.
    top = ROOM * max(semi.max_pressure, float(patch.centre_pressure.max()))
    axes.set_ylim(0.0, stress.factor * (BEYOND * semi.max_pressure if semi.singular_ends else top))
    if semi.singular_ends:
        mark_unlimited(semi, axes)
    _mark_stations(found, axes, named=True)
    axes.set_ylabel(stress.label("Pressure at $x$ = 0"))
    axes.tick_params(labelbottom=False)
    _draw_key(found, axes)
    _tidy(axes, semi, labelled=False)


def _draw_key(found: Comparison, axes: Axes) -> None:
    """Put the legend above the axes; it also applies to the cuts, where the markers become lines."""
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=INK, linewidth=THIN, marker=".", markersize=2.4)]
    labels = [f"plane grid, {_time(found.seconds.patch)}"]
    for solution, seconds in zip(found.strips, (found.seconds.semi_elliptic, found.seconds.parabolic), strict=True):
        look = MARKS[solution.element.name] | SHAPES[solution.element.name]
        handles.append(Line2D([], [], markersize=3.2, linewidth=LINE, **look))
        labels.append(f"{solution.strips} {solution.element.name} strips, {_time(seconds)}")
    key_above(axes, handles, labels, columns=3)


def draw_differences(found: Comparison, axes: Axes) -> None:
    """Draw the difference of each strip from the plane grid [%], and shade the band below 1 %."""
    axes.set_yscale("symlog", linthresh=FAINTEST, linscale=0.6)
    axes.axhspan(-100.0 * NOTABLE, 100.0 * NOTABLE, facecolor=PALE, edgecolor="none", zorder=0.5)
    axes.axhline(0.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    for solution in found.strips:
        strips = measure("mm")(solution.y), np.clip(100.0 * found.along(solution), -LARGEST, LARGEST)
        axes.plot(*strips, linestyle="none", markersize=2.8, zorder=3.0, **MARKS[solution.element.name])
    axes.set_ylim(-1.4 * LARGEST, 1.4 * LARGEST)
    axes.set_yticks([-100.0, -10.0, -1.0, 0.0, 1.0, 10.0, 100.0], ["−100", "−10", "−1", "0", "1", "10", "100"])
    axes.tick_params(axis="y", labelsize=SMALL_SIZE)
    axes.minorticks_off()
    axes.set_ylabel("Difference [%]")
    _tidy(axes, found.semi_elliptic, labelled=True)


def _mark_stations(found: Comparison, axes: Axes, *, named: bool) -> None:
    """Draw a line at every station and, below the axes, the letter that the cuts across repeat."""
    low, high = axial_range(found.semi_elliptic)
    length = measure("mm")
    for letter, station in zip("ABC", found.stations, strict=True):
        axes.axvline(length.factor * station.y, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
        if not named:
            continue
        near = [other.y for other in found.stations if 0.0 < abs(other.y - station.y) < CROWDED * (high - low)]
        side: Alignment = "center" if not near else "left" if station.y > near[0] else "right"
        at = length.factor * station.y, 0.0
        note(axes, letter, at, side, 0.0, -4.0, across=True, va="top", color=FAINT_INK, weight="bold")


def _tidy(axes: Axes, semi: Solution, *, labelled: bool) -> None:
    along(axes, axial_range(semi), labelled=labelled, labelpad=1.0)
    draw_body_ends(semi, axes, named=False)
    open_frame(axes)


def draw_across(found: Comparison, axes: Axes, station: Station) -> None:
    """Draw the pressure across at a station: of each cell, and as the strips assume it."""
    length, stress = measure("mm"), measure("MPa")
    x, pressure = found.patch.across(station.y)
    touching = np.convolve(pressure > 0.0, [1, 1, 1], mode="same") > 0
    axes.plot(length(x[touching]), stress(pressure[touching]), ".", markersize=2.4, color=INK, zorder=2.0)
    widest = float(np.max(np.abs(x[pressure > 0.0]), initial=0.0))
    highest = float(pressure.max())
    for solution in found.strips:
        across, shape = _own_shape(solution, station.y)
        axes.plot(length(across), stress(shape), linewidth=LINE, zorder=1.5, **SHAPES[solution.element.name])
        widest, highest = max(widest, float(across[-1])), max(highest, float(shape.max()))
    reach = length.factor * ROOM * (widest or 1.0)
    axes.set_xlim(-reach, reach)
    axes.set_ylim(0.0, stress.factor * ROOM * (highest or 1.0))
    letter = "ABC"[found.stations.index(station)]
    words = f"{station.reason},\n$y$ = {place(axial_range(found.semi_elliptic), station.y)}"
    axes.set_title(words, loc="left", fontsize=SMALL_SIZE, pad=4.0)
    axes.text(0.03, 0.97, letter, transform=axes.transAxes, va="top", weight="bold", fontsize=SIZE, color=FAINT_INK)
    axes.set_xlabel(length.label("Across $x$"), labelpad=1.0)
    axes.locator_params(axis="both", nbins=4)
    axes.tick_params(labelsize=SMALL_SIZE)
    open_frame(axes)


def _own_shape(solution: Solution, y: float) -> tuple[Array, Array]:
    """Return x [mm] and the pressure [MPa] that the strips assume across, linear between their centres."""
    width = float(np.interp(y, solution.y, solution.element_half_width))
    load = float(np.interp(y, solution.y, solution.line_load))
    share = np.linspace(-1.0, 1.0, ACROSS)
    if width == 0.0:
        return 0.0 * share, 0.0 * share
    # By name: a solution from another process has a copy of the element.
    if solution.element.name == PARABOLIC.name:
        return width * share, 0.75 * load / width * (1.0 - share**2)
    return width * share, 2.0 * load / (np.pi * width) * np.sqrt(1.0 - share**2)


def _time(seconds: float) -> str:
    return f"{number(1e3 * seconds, 2)} ms" if seconds < 1.0 else f"{number(seconds, 2)} s"
