"""Along the centre line of a contact: pressure and half-width, and both surfaces before and after loading."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonhertz.amounts import EndStrength, mpa, um
from nonhertz.plot.axes import OWN, Alignment, Axes, along, drawing, measure, note, open_frame
from nonhertz.plot.axial import (
    alignment,
    draw_body_ends,
    head,
    mark_land_ends,
    number,
    place,
    written,
)
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, HAIR, HINT_DASHES, INK, LINE, PALE, SECOND, THIN
from nonhertz.result.along import axial_range, body_ends, distance_range, distances, land_end_peaks, unlimited_ends
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.solution import EdgePressure, Solution

# The largest pressure and half-width are drawn at these fractions of the axes' height: far enough apart to be
# distinguished (in a line contact both curves have the same shape), with room above for the text.
PRESSURE_SHARE, HALF_WIDTH_SHARE = 0.76, 0.52
CONTACT_SHARE = 0.9

# Where the pressure is singular, the frame ends at BEYOND times the largest pressure away from there, and the spike
# leaves it. The half-width is drawn lower, and the text on the ends is above the largest pressure.
BEYOND, CUT_HALF_WIDTH_SHARE, SINGULAR_SHARE = 1.6, 0.44, 0.77

# Further than this fraction of the range from its middle, the text at a largest pressure is on the side of the middle.
SIDE = 0.2

# Of words above a point, on a background that hides thin lines.
OVER_LINES: dict[str, Any] = {"va": "bottom", "color": INK, "bbox": BACKING}


@drawing
def pressure(solution: Solution, ax: Axes = OWN) -> Axes:
    """Draw the centre-line pressure p0 (left axis) and the half-width b (right axis) against y.

    Both lines run through the centres of the strips; the pale steps are the strips themselves. The largest
    pressure, the ends of the contact and the ends of the bodies are marked. Where a sharp end makes the
    pressure singular there is no largest value: the left axis is cut, exponent and strength are given at that
    end, and the largest pressure more than a half-width away from such ends is marked. The right axis belongs to
    a twin of ``ax`` in the same figure.

    Parameters
    ----------
    solution : Solution
        A solved contact.

    References
    ----------
    The pair of curves is that of Fig. 7 in J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal
    uniform/parabolic surface pressure half-space element for the analysis of non-Hertzian contact,
    Computational Mechanics, CIMNE, Barcelona 1998.
    """
    span = axial_range(solution)
    length, stress = measure("mm"), measure("MPa")
    y, edges, drawn = length(solution.y), length(solution.edges), stress(solution.centre_pressure)
    right = ax.twinx()
    draw_body_ends(solution, ax)

    ax.stairs(drawn, edges, fill=True, color=FIRST, alpha=0.10, linewidth=0.0)
    ax.stairs(drawn, edges, color=FIRST, alpha=0.45, linewidth=HAIR)
    (of_pressure,) = ax.plot(y, drawn, color=FIRST, linewidth=LINE)
    (of_width,) = right.plot(y, length(solution.half_width), color=SECOND, linewidth=LINE, linestyle="--")

    along(ax, span)
    singular = bool(solution.singular_ends)
    ax.set_ylim(0.0, stress.factor * solution.max_pressure / (1.0 / BEYOND if singular else PRESSURE_SHARE) or 1.0)
    share = CUT_HALF_WIDTH_SHARE if singular else HALF_WIDTH_SHARE
    right.set_ylim(0.0, length.factor * float(solution.half_width.max()) / share or 1.0)
    ax.set_ylabel(stress.label("Centre-line pressure $p_0$"), color=FIRST)
    right.set_ylabel(length.label("Half-width $b$"), color=SECOND)
    ax.spines["top"].set_visible(False)
    right.spines["top"].set_visible(False)
    labels = ["pressure $p_0$ (left axis; steps: strips)", "half-width $b$ (right axis)"]
    head(solution, ax, [of_pressure, of_width], labels)
    _mark_maximum(solution, ax, span)
    for edge in unlimited_ends(solution):
        _mark_singular(solution, ax, edge)
    _mark_contact(solution, ax, span)
    return ax


def _mark_maximum(solution: Solution, ax: Axes, span: tuple[float, float]) -> None:
    """Mark the largest pressure; within a half-width of a singular end there is none."""
    marked, largest = places_of_largest(solution), solution.max_pressure
    if not marked:
        return
    words = f"{written(mpa(largest))} at $y$ = {place(span, *marked)}"
    corners = land_end_peaks(solution)
    at_land_end = any(abs(y - place) < solution.max_half_width for y, _ in corners for place in marked)
    if solution.peaks_at_corner:
        words += " (corner: rises with refinement)"
    elif at_land_end:
        words += " (land end)"
    length, top = measure("mm"), float(measure("MPa")(largest))
    ax.plot(length(marked), [top] * len(marked), "o", markersize=4.0, color=FIRST, markerfacecolor="white")
    y = sum(marked) / len(marked)
    side = alignment(ax, y, span, words)
    if solution.singular_ends and abs(y - 0.5 * sum(span)) > SIDE * (span[1] - span[0]):
        # Further out the climbing curve would run through the text.
        side = "left" if y < 0.5 * sum(span) else "right"
    note(ax, words, (float(length(y)), top), side, 3.0, 6.0, **OVER_LINES)
    if not at_land_end:
        mark_land_ends(solution, ax)


def _mark_singular(solution: Solution, ax: Axes, edge: EdgePressure) -> None:
    """Draw an arrow where the pressure has no limit, and write how it grows."""
    across, length = ax.get_xaxis_transform(), measure("mm")
    ax.plot(length([edge.y]), [0.975], transform=across, marker="^", markersize=4.5, color=FIRST)
    words = "no limit at a corner"
    if edge.law:
        power = number(edge.exponent, 3)
        words = f"singular: $p$ ∼ $K$ / $s^{{{power}}}$"
        if edge.strength is not None:
            strength, pressure, distance = EndStrength(edge.strength, edge.exponent).apart
            words += f"\n$K$ = {number(strength)} {pressure} {distance}$^{{{power}}}$"
    # The text keeps clear of the curve, which climbs to the arrow: start where the curve reaches the text's height.
    below = solution.y[measure("MPa")(solution.centre_pressure) < SINGULAR_SHARE * ax.get_ylim()[1]]
    foot = float(below[np.abs(below - edge.y).argmin()]) if below.size else edge.y
    side: Alignment = "left" if edge is solution.edge_pressure[0] else "right"
    note(ax, words, (float(length(foot)), SINGULAR_SHARE), side, 4.0, across=True, **OVER_LINES)


def _mark_contact(solution: Solution, ax: Axes, span: tuple[float, float]) -> None:
    """Draw a dimension line over every interval in contact, and label them all in one text."""
    if not solution.contact_y:
        return
    across, length = ax.get_xaxis_transform(), measure("mm")
    arrow: dict[str, Any] = {"arrowstyle": "<->,head_length=0.25,head_width=0.12", "shrinkA": 0.0, "shrinkB": 0.0}
    arrow |= {"color": FAINT_INK, "linewidth": THIN}
    for interval in solution.contact_y:
        low, high = ((float(each), CONTACT_SHARE) for each in length(interval))
        ax.annotate("", low, xytext=high, xycoords=across, textcoords=across, arrowprops=arrow)
        for end in interval:
            if not any(np.isclose(end, body_end) for body_end, _ in body_ends(solution)):
                style: dict[str, Any] = {"color": FAINT_INK, "linewidth": THIN, "linestyle": HINT_DASHES}
                ax.plot(length([end, end]), [0.0, CONTACT_SHARE], transform=across, **style)
    first, last = solution.contact_y[0][0], solution.contact_y[-1][1]
    intervals = [place(span, *ends, between=" to ") for ends in solution.contact_y]
    words = "contact " + " and ".join(intervals)
    if len(intervals) > 2:
        words = f"contact on {len(intervals)} intervals between {place(span, first, last)}"
    side = alignment(ax, 0.5 * (first + last), span, words)
    at = {"left": first, "center": 0.5 * (first + last), "right": last}[side]
    note(ax, words, (float(length(at)), CONTACT_SHARE), side, 0.0, 3.0, across=True, **OVER_LINES)


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
    y, (before, after) = length(solution.y), (distance(values) for values in distances(solution))

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

    bottom, top = distance_range(before, after)
    along(ax, span)
    ax.set_ylim(bottom, top)
    ax.set_ylabel(distance.label("Distance of the surfaces"))
    open_frame(ax)
    inside = (solution.y >= span[0]) & (solution.y <= span[1])
    largest, remark = float(-solution.interference[inside].min()), ""
    if np.isinf(largest):
        remark = "axis cut, the relief is infinite at an end"
    elif distance(largest) > top:
        remark = f"axis cut, the undeformed distance reaches {written(um(largest), 3)}"
    handles, labels = ax.get_legend_handles_labels()
    order = [1, 2, 3, 0] if solution.contact_y else [0, 1, 2]
    head(solution, ax, [handles[k] for k in order], [labels[k] for k in order], remark=remark)
    return ax
