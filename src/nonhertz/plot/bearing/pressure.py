"""The pressure between all rollers of a row and a ring, unrolled over angle and y."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from nonhertz.amounts import mpa
from nonhertz.bearing import BearingSolution
from nonhertz.plot.axes import OWN, Array, Axes, drawing, measure
from nonhertz.plot.axial import number, place, written
from nonhertz.plot.contact_area import colour_bar_to
from nonhertz.plot.style import COLOUR_MAP, HAIR, INK, SMALL_SIZE

RINGS = ("inner", "outer")
UNLOADED = "#D9D9D9"  # no colour of the map
QUARTER, STEP = 90.0, 45.0  # degrees


@drawing
def bearing_pressure(
    solution: BearingSolution, ax: Axes = OWN, *, ring: str = "inner", row: int = 0, colour_bar: bool = True
) -> Axes:
    """Draw the centre-line pressure between the rollers of a row and a ring over angle and y.

    Every roller is a cell of its angular pitch; nothing is interpolated between rollers. Grey is out of contact. The
    loaded side is in the middle. Colours are the same for all rows and rings of a bearing, up to its maximum pressure;
    the largest pressure of this row and ring is marked.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing, solved by strips.
    ring : {"inner", "outer"}
        Which ring.
    row : int
        Which row of rollers, from 0.
    colour_bar : bool
        Whether to draw a colour bar, which takes room from ``ax``.

    Raises
    ------
    InputError
        If there is no such ring or row, or the bearing was solved by slices.
    """
    found = solution.unrolled_pressure(ring, row=row)
    middle = _middle(solution)
    pitch = 360.0 / found.angle.size
    place_of = _unrolled(np.degrees(found.angle), middle)
    order = np.argsort(place_of)
    # The roller that half a turn from the middle cuts is at both ends; all rows have the same axis.
    order = np.concatenate([order[-1:], order, order[:1]])
    first = place_of[order[0]] - 360.0
    edges = first + pitch * (np.arange(order.size + 1) - 0.5)
    length, stress, y = measure("mm"), measure("MPa"), found.y
    between = np.concatenate([y[:1], 0.5 * (y[1:] + y[:-1]), y[-1:]])
    shown = np.ma.masked_less_equal(stress(found.pressure[order]), 0.0)
    ax.set_facecolor(UNLOADED)
    ax.pcolormesh(
        edges, length(between), shown.T, cmap=COLOUR_MAP, vmin=0.0,
        vmax=stress.factor * colour_limit(solution), rasterized=True, zorder=1.0,
    )  # fmt: skip
    for edge in edges[1:-1]:
        ax.axvline(edge, color="white", linewidth=HAIR, zorder=2.0)
    ax.set_xlim(middle - 180.0, middle + 180.0)
    ax.set_ylim(*length(y[[0, -1]]))
    ticks = middle + np.linspace(-180.0, 180.0, round(360.0 / STEP) + 1)
    ax.set_xticks(ticks, [f"{number(each % 360.0)}°" for each in ticks])
    ax.locator_params(axis="y", nbins=5, steps=[1, 2, 5, 10])
    ax.set_xlabel("Angle of the roller, from +y towards +z")
    ax.set_ylabel(length.label("$y$"))
    several = f"Row {row + 1}, " if len(solution.bearing.rows) > 1 else ""
    name = f"{several}{ring} ring"
    ax.set_title(name[0].upper() + name[1:], loc="left", fontsize=SMALL_SIZE, pad=3.0)
    _mark_largest(solution, ax, ring, row, middle)
    if colour_bar:
        draw_colour_bar(solution, ax, ax=ax)
    return ax


def colour_limit(solution: BearingSolution) -> float:
    """Return the pressure [MPa] of the last colour: the largest of the bearing."""
    return float(solution.max_pressure.max()) or 1.0


def draw_colour_bar(solution: BearingSolution, area: Axes, **where: Any) -> None:
    """Draw the colour bar in the figure of an ``area``, ending in an arrow if pressures exceed the last colour."""
    highest = colour_limit(solution)
    rows = range(len(solution.bearing.rows))
    largest = max(float(solution.unrolled_pressure(ring, row=row).pressure.max()) for row in rows for ring in RINGS)
    # Interpolation on another grid than that of the strips is no reason for an arrow; a sharp end is.
    colour_bar_to(highest, "Centre-line pressure $p_0$", area, beyond=largest > 1.01 * highest, **where)


def _middle(solution: BearingSolution) -> float:
    """Return the multiple of a quarter turn [degree] that is nearest to the direction of the loads."""
    inner = solution.load[:, 0]
    y, z = float(inner @ np.cos(solution.angle)), float(inner @ np.sin(solution.angle))
    if math.hypot(y, z) <= 1e-6 * float(inner.sum()):
        return 0.0
    return QUARTER * round(math.degrees(math.atan2(z, y)) / QUARTER)


def _unrolled(degrees: Array, middle: float) -> Array:
    """Return angles within half a turn of the middle."""
    # A roller exactly opposite is on the right; where it is written in binary must not decide.
    found: Array = middle + 180.0 - np.mod(np.round(180.0 - (degrees - middle), 9), 360.0)
    return found


def _mark_largest(solution: BearingSolution, ax: Axes, ring: str, row: int, middle: float) -> None:
    these, column = solution.rollers_of(row), RINGS.index(ring)
    pressure = solution.max_pressure[these, column]
    most = int(pressure.argmax())
    if not pressure[most] > 0.0:
        ax.set_title("no roller loaded", loc="right", fontsize=SMALL_SIZE, pad=3.0)
        return
    at = float(_unrolled(np.degrees(solution.angle[these][most : most + 1]), middle)[0])
    y = float(solution.max_pressure_y[these, column][most])
    drawn = measure("mm")(y)
    ax.plot([at], [drawn], "o", markersize=4.0, markeredgecolor=INK, markerfacecolor="white", zorder=4.0, clip_on=False)
    low, high = ax.get_ylim()
    span = low / measure("mm").factor, high / measure("mm").factor
    angle = number(float(np.degrees(solution.angle[these][most])))
    words = f"largest {written(mpa(pressure[most]))} at {angle}°, $y$ = {place(span, y)}"
    ax.set_title(words, loc="right", fontsize=SMALL_SIZE, pad=3.0)
