"""Both surfaces on the centre line, before and after loading."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import um
from nonhertz.plot.axes import OWN, along, drawing, measure, open_frame
from nonhertz.plot.axial import axial_range, draw_body_ends, head, written
from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, LINE, PALE, SECOND
from nonhertz.result.solution import Solution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

LARGEST_CLEARANCE, CUT_CLEARANCE = 2.0, 1.0
"""Clearance, as a multiple of the deepest interference: up to the first all of it is drawn; if there is more, the axis
is cut at the second, so that the interference fills half of the axes."""


@drawing
def profile(solution: Solution, ax: Axes = OWN) -> Axes:
    """Draw the surfaces' distance on the centre line, undeformed and deformed, in micrometres against y.

    The undeformed distance is ``h - (delta + gamma y)``, negative where the bodies would overlap if they did
    not deform; the deformed one is the gap, zero in contact (shaded). The area between them is the elastic
    displacement of both surfaces. Where the relief is far larger than the interference the axis is cut, and
    the heading gives the largest distance.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    """
    span = axial_range(solution)
    length, distance = measure("mm"), measure("mm", "um")
    y, (before, after) = length(solution.y), (distance(1e-3 * each) for each in distances(solution))

    for count, (low, high) in enumerate(length(pair) for pair in solution.contact_y):
        label = "in contact" if count == 0 else None
        ax.axvspan(low, high, facecolor=PALE, edgecolor="none", zorder=0.5, label=label)
    ax.axhline(0.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    draw_body_ends(solution, ax)
    label = r"undeformed, $h - (\delta + \gamma y)$"
    ax.plot(y, before, color=SECOND, linewidth=LINE, linestyle="--", label=label)
    ax.plot(y, after, color=FIRST, linewidth=LINE, label="deformed gap")
    label = "elastic displacement"
    ax.fill_between(y, before, after, facecolor=FIRST, alpha=0.16, linewidth=0.0, label=label)

    bottom, top = drawn_range(before, after)
    along(ax, span)
    ax.set_ylim(bottom, top)
    ax.set_ylabel(distance.label("Distance of the surfaces"))
    open_frame(ax)
    inside = (solution.y >= span[0]) & (solution.y <= span[1])
    largest = float(-solution.interference[inside].min())
    handles, labels = ax.get_legend_handles_labels()
    order = [1, 2, 3, 0] if solution.contact_y else [0, 1, 2]
    remark = _cut(largest) if distance(largest) > top else ""
    head(solution, ax, [handles[k] for k in order], [labels[k] for k in order], remark=remark)
    return ax


def _cut(largest: float) -> str:
    if np.isinf(largest):
        return "axis cut, the relief is infinite at an end"
    return f"axis cut, the undeformed distance reaches {written(um(largest), 3)}"


def distances(solution: Solution) -> tuple[Array, Array]:
    """Return the surfaces' distance on the centre line [micrometre], undeformed and deformed, at each strip.

    The undeformed one is negative where the bodies would overlap. An infinite relief cannot be drawn: both are NaN
    there, and the line is interrupted.
    """
    before = -1e3 * solution.interference
    after = 1e3 * solution.gap
    drawn = np.isfinite(before) & np.isfinite(after)
    return np.where(drawn, before, np.nan), np.where(drawn, after, np.nan)


def drawn_range(before: Array, after: Array) -> tuple[float, float]:
    """Return the range of distances, in one unit, to draw, chosen so that the contact fills it."""
    depth = max(-float(np.nanmin(before)), 0.0)
    clearance = float(np.nanmax(np.maximum(before, after)))
    if depth == 0.0:
        return (-0.1 * clearance, 1.1 * clearance)
    if clearance > LARGEST_CLEARANCE * depth:
        return (-1.12 * depth, CUT_CLEARANCE * depth)
    # A little above zero even if there is no clearance, so that the line of the gap is not the axes' edge.
    return (-1.12 * depth, 1.08 * max(clearance, 0.15 * depth))
