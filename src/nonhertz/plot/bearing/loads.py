"""The loads of all rollers of a row around the bearing's axis."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.amounts import newton
from nonhertz.bearing import BearingSolution
from nonhertz.errors import InputError
from nonhertz.plot.axes import OWN, Array, Measure, drawing, measure
from nonhertz.plot.axial import number, written
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, HAIR, INK, LINE, SECOND, SMALL_SIZE, THIN

if TYPE_CHECKING:
    from matplotlib.projections.polar import PolarAxes

# The circle of the rollers, from which the bars rise, over the largest load; room beyond the largest bar.
HOLE, ROOM = 0.75, 1.08
# Width of the two bars of a roller over its pitch, and what few rollers are limited to.
BAR_SHARE, WIDEST_BAR = 0.36, math.radians(7.0)
# Of rollers' marks [points]: the largest, and their share of the pitch.
LARGEST_MARK, MARK_SHARE = 6.0, 0.7
ARROW_SHARE = 0.72  # of the circle's radius
NO_FORCE = 1e-9  # of the sum of all loads
STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
MOST_RINGS = 4
SPOKES = 8
CENTRED: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": SMALL_SIZE}


@functools.partial(drawing, projection="polar")
def bearing_loads(solution: BearingSolution, ax: PolarAxes = OWN, *, row: int = 0) -> PolarAxes:
    """Draw the loads of a row's rollers as bars around the bearing's axis.

    Two bars rise from each roller: its load at the inner and at the outer ring, to the same scale for all rows. Rollers
    that the inner ring does not load are open circles. As is usual in the literature (Harris), +y, along which a single
    radial force acts, points down, so that the load zone is at the bottom; +z points right, and one looks against x.
    The arrow is the direction of the radial force on the inner ring, on all rows together.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing.
    ax : matplotlib.projections.polar.PolarAxes, optional
        Where to draw, made with ``projection="polar"``; if left out, in a figure of its own, ``ax.figure``.
    row : int
        Which row of rollers, from 0.

    Raises
    ------
    InputError
        If the axes are not polar, or there is no such row.

    References
    ----------
    T. A. Harris, Rolling Bearing Analysis, Wiley; the figures of load distributions (recalled).
    """
    if getattr(ax, "name", None) != "polar":
        raise InputError("ax", ax, "be polar axes", 'make them with projection="polar"')
    these = solution.rollers_of(row)
    angle, load = solution.angle[these], solution.load[these]
    top = ROOM * (float(solution.load.max()) or 1.0)
    force = measure("N", values=[top])
    _lay(ax, _emptiest(angle, load), top, force)
    _draw_bars(ax, angle, force(load))
    _draw_rollers(ax, angle, load)
    _draw_force(ax, solution, force.factor * top)
    zone = number(math.degrees(solution.load_zone[row]), 3)
    words = f"{np.count_nonzero(load[:, 0])} of {angle.size} rollers loaded, load zone {zone}°"
    if load.any():
        most = int(load.max(axis=1).argmax())
        words += f"\nlargest {written(newton(load[most].max()))} at {number(math.degrees(angle[most]), 4)}°"
    several = f"Row {row + 1}: " if len(solution.bearing.rows) > 1 else ""
    ax.set_title(several + words, fontsize=SMALL_SIZE, pad=12.0)
    return ax


def _lay(ax: PolarAxes, numbers_at: float, load: float, force: Measure) -> None:
    """Set up directions, rings of equal load and their numbers."""
    from matplotlib.ticker import MaxNLocator

    ax.set_theta_zero_location("S")
    ax.set_theta_direction(1)
    top = force.factor * load
    ax.set_ylim(0.0, top)
    ax.set_rorigin(-HOLE * top)
    spokes = 2.0 * math.pi * np.arange(SPOKES) / SPOKES
    axes = {0: " (+y)", SPOKES // 4: "\n(+z)"}
    ax.set_xticks(spokes, [f"{360 * k // SPOKES}°{axes.get(k, '')}" for k in range(SPOKES)])
    ticks = [each for each in MaxNLocator(MOST_RINGS, steps=STEPS).tick_values(0.0, top) if 0 < each < top]
    ax.set_yticks(ticks, [])
    for each in ticks:
        # Not as labels of the ticks, which bars would cover.
        ax.text(numbers_at, each, f"{number(each)} {force.unit}", bbox=BACKING, zorder=5.0, **CENTRED)
    ax.tick_params(axis="x", pad=3.0, labelsize=SMALL_SIZE)
    ax.grid(True, color=FAINT_INK, linewidth=HAIR, alpha=0.5)
    ax.set_axisbelow(True)
    ax.spines["polar"].set(linewidth=HAIR, edgecolor=FAINT_INK)
    ax.spines["inner"].set(linewidth=THIN, edgecolor=INK)


def _emptiest(angle: Array, load: Array) -> float:
    """Return the angle between the two neighbours that bear least, the most upright of such places."""
    pair = load.sum(axis=1) + np.roll(load.sum(axis=1), -1)
    between = angle + math.pi / angle.size
    least = between[pair <= pair.min() + NO_FORCE * pair.max()]
    # The upper one of two: numbers side by side would touch each other.
    upright = np.abs(np.cos(least)) - 1e-6 * np.cos(least)
    return float(least[upright.argmax()])


def _draw_bars(ax: PolarAxes, angle: Array, load: Array) -> None:
    """Draw the loads at both rings side by side."""
    bar = min(BAR_SHARE * 2.0 * math.pi / angle.size, WIDEST_BAR)
    for column, (ring, colour, hatch) in enumerate((("inner", FIRST, None), ("outer", SECOND, "////"))):
        loaded = load[:, column] > 0.0
        if loaded.any():
            at = angle[loaded] + (column - 0.5) * bar
            ax.bar(
                at, load[loaded, column], width=bar, color="white" if hatch else colour, edgecolor=colour, hatch=hatch,
                linewidth=HAIR, zorder=3.0, label=f"load at the {ring} ring",
            )  # fmt: skip


def _draw_rollers(ax: PolarAxes, angle: Array, load: Array) -> None:
    loaded = load[:, 0] > 0.0
    # At speed all rollers press on the outer ring.
    without = "roller not loaded by the inner ring" if load[~loaded].any() else "roller without load"
    width = min(ax.bbox.width, ax.bbox.height) / ax.figure.dpi * 72.0
    around = math.pi * width * HOLE / (1.0 + HOLE)
    size = min(LARGEST_MARK, MARK_SHARE * around / angle.size)
    common: dict[str, Any] = {"marker": "o", "markersize": size, "markeredgewidth": THIN, "clip_on": False}
    for which, face, label in ((loaded, INK, "_"), (~loaded, "white", without)):
        if np.any(which):
            look = {"markerfacecolor": face, "markeredgecolor": INK, "linestyle": "none", **common}
            ax.plot(angle[which], np.zeros(np.count_nonzero(which)), label=label, zorder=4.0, **look)


def _draw_force(ax: PolarAxes, solution: BearingSolution, top: float) -> None:
    """Draw the direction of the radial force into the circle of the rollers."""
    along_y, along_z = solution.force[1:3]
    radial = math.hypot(along_y, along_z)
    if radial <= NO_FORCE * float(solution.load.sum()):
        ax.text(0.0, -HOLE * top, "no radial\nforce", color=FAINT_INK, clip_on=False, **CENTRED)
        return
    way = math.atan2(along_z, along_y)
    tail, tip = -HOLE * top * (1.0 - 0.25 * ARROW_SHARE), -HOLE * top * (1.0 - ARROW_SHARE)
    arrow = {"arrowstyle": "-|>,head_length=0.6,head_width=0.25", "color": INK, "linewidth": LINE}
    arrow |= {"shrinkA": 0.0, "shrinkB": 0.0}
    ax.annotate("", (way, tip), xytext=(way + math.pi, tail), arrowprops=arrow, annotation_clip=False)
    words = written(newton(radial))
    ax.text(way + math.pi, -HOLE * top * (1.0 - 0.55), words, bbox=BACKING, clip_on=False, **CENTRED)
