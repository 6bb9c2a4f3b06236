"""Pressure on the centre line and half-width, along the contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nonhertz.plot.axial import (
    AXIAL_LABEL,
    Alignment,
    alignment,
    axial_range,
    body_ends,
    draw_body_ends,
    head,
    number,
    place,
    regular,
    strip_edges,
)
from nonhertz.plot.style import (
    BACKING,
    FAINT_INK,
    FIRST,
    HAIR,
    HINT_DASHES,
    INK,
    LINE,
    SECOND,
    SMALL_SIZE,
    THIN,
)
from nonhertz.solution import Solution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.transforms import Transform

# The largest pressure and half-width stand at these shares of the axes' height: far enough apart to be told
# from each other (in a line contact both curves have one shape), with room above for the words.
PRESSURE_SHARE, HALF_WIDTH_SHARE = 0.76, 0.52
CONTACT_SHARE = 0.9

# Where a singular end goes beyond the axis, the rest takes this share, and the words on the end stand above.
CUT_PRESSURE_SHARE, CUT_HALF_WIDTH_SHARE, BEYOND_SHARE = 0.66, 0.44, 0.8


def pressure(solution: Solution, ax: Axes) -> Axes:
    """Draw the centre-line pressure p0 (left axis) and the half-width b (right axis) against y.

    Both lines run through the centres of the strips; the pale steps are the strips themselves. The largest
    pressure, the ends of the contact and the ends of the bodies are marked. Where a sharp end makes the
    pressure singular the left axis is cut: the largest value, which is that of one strip, is written with an
    arrow, and a crest away from the ends is marked as well. The right axis belongs to a twin of ``ax`` in the
    same figure.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    ax : matplotlib.axes.Axes
        Where to draw.

    Returns
    -------
    matplotlib.axes.Axes
        ``ax``.

    References
    ----------
    The pair of curves is that of Fig. 7 in J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal
    uniform/parabolic surface pressure half-space element for the analysis of non-Hertzian contact,
    Computational Mechanics, CIMNE, Barcelona 1998.
    """
    span = axial_range(solution)
    edges = strip_edges(solution)
    right = ax.twinx()
    draw_body_ends(solution, ax)

    ax.stairs(solution.peak_pressure, edges, fill=True, color=FIRST, alpha=0.10, linewidth=0.0)
    ax.stairs(solution.peak_pressure, edges, color=FIRST, alpha=0.45, linewidth=HAIR)
    (of_pressure,) = ax.plot(solution.y, solution.peak_pressure, color=FIRST, linewidth=LINE)
    (of_width,) = right.plot(solution.y, solution.half_width, color=SECOND, linewidth=LINE, linestyle="--")

    ax.locator_params(axis="x", steps=[1, 2, 5, 10])
    ax.set_xlim(span)
    counted = solution.peak_pressure[regular(solution)]
    top = _top(float(counted.max(initial=0.0)), CUT_PRESSURE_SHARE)
    beyond = solution.max_pressure > top
    ax.set_ylim(0.0, top if beyond else _top(solution.max_pressure, PRESSURE_SHARE))
    share = CUT_HALF_WIDTH_SHARE if beyond else HALF_WIDTH_SHARE
    right.set_ylim(0.0, _top(float(solution.half_width.max()), share))
    ax.set_xlabel(AXIAL_LABEL)
    ax.set_ylabel("Centre-line pressure $p_0$ [MPa]", color=FIRST)
    right.set_ylabel("Half-width $b$ [mm]", color=SECOND)
    for axes in (ax, right):
        axes.spines["top"].set_visible(False)
    labels = ["pressure $p_0$ (left axis; steps: strips)", "half-width $b$ (right axis)"]
    head(solution, ax, [of_pressure, of_width], labels)
    _mark_maximum(solution, ax, span)
    _mark_contact(solution, ax, span)
    return ax


def _top(largest: float, share: float) -> float:
    return largest / share if largest > 0.0 else 1.0


def _mark_maximum(solution: Solution, ax: Axes, span: tuple[float, float]) -> None:
    if solution.max_pressure <= 0.0:
        return
    y, largest = solution.max_pressure_y, solution.max_pressure
    words = _value_words(largest, y, span)
    if np.isinf(solution.error_estimate.max_pressure):
        words += " (sharp end: rises with refinement)"
    if largest <= ax.get_ylim()[1]:
        _mark(ax, y, largest, words, span)
        return
    across = ax.get_xaxis_transform()
    ax.plot([y], [0.975], transform=across, marker="^", markersize=4.5, color=FIRST)
    # The words keep clear of the curve, which climbs to the arrow from where it is as high as they are.
    below = solution.y[solution.peak_pressure < BEYOND_SHARE * ax.get_ylim()[1]]
    foot = float(below[np.abs(below - y).argmin()])
    _write(ax, words, (foot, BEYOND_SHARE), alignment(ax, y, span, words), 4.0, 0.0, across)
    crest = _crest(solution)
    if crest is not None:
        y, largest = float(solution.y[crest]), float(solution.peak_pressure[crest])
        _mark(ax, y, largest, _value_words(largest, y, span), span)


def _crest(solution: Solution) -> int | None:
    """Return the strip of the highest crest away from singular ends, None where the pressure has none."""
    pressure = np.where(regular(solution), solution.peak_pressure, np.inf)
    inside = pressure[1:-1]
    crests = 1 + np.flatnonzero(np.isfinite(inside) & (inside >= pressure[:-2]) & (inside >= pressure[2:]))
    return int(crests[pressure[crests].argmax()]) if crests.size else None


def _value_words(pressure: float, y: float, span: tuple[float, float]) -> str:
    return f"{number(pressure)} MPa at $y$ = {place(y, span)} mm"


def _mark(ax: Axes, y: float, pressure: float, words: str, span: tuple[float, float]) -> None:
    ax.plot([y], [pressure], marker="o", markersize=4.0, color=FIRST, markerfacecolor="white")
    _write(ax, words, (y, pressure), alignment(ax, y, span, words), 3.0, 6.0, ax.transData)


def _write(
    ax: Axes,
    words: str,
    at: tuple[float, float],
    side: Alignment,
    aside: float,
    above: float,
    coordinates: Transform,
) -> None:
    """Write small words ``aside`` and ``above`` [points] of a place, on a ground that hides thin lines."""
    ax.annotate(
        words,
        at,
        xycoords=coordinates,
        xytext=({"left": aside, "center": 0.0, "right": -aside}[side], above),
        textcoords="offset points",
        ha=side,
        va="bottom",
        fontsize=SMALL_SIZE,
        color=INK,
        bbox=BACKING,
    )


def _mark_contact(solution: Solution, ax: Axes, span: tuple[float, float]) -> None:
    """Draw a dimension line over every interval in contact and write all of them once."""
    if not solution.contact_y:
        return
    across = ax.get_xaxis_transform()
    for interval in solution.contact_y:
        ax.annotate(
            "",
            (interval[0], CONTACT_SHARE),
            xytext=(interval[1], CONTACT_SHARE),
            xycoords=across,
            textcoords=across,
            arrowprops={
                "arrowstyle": "<->,head_length=0.25,head_width=0.12",
                "color": FAINT_INK,
                "linewidth": THIN,
                "shrinkA": 0.0,
                "shrinkB": 0.0,
            },
        )
        for end in interval:
            if any(np.isclose(end, body_end) for body_end, _ in body_ends(solution)):
                continue
            ax.plot(
                [end, end],
                [0.0, CONTACT_SHARE],
                transform=across,
                color=FAINT_INK,
                linewidth=THIN,
                linestyle=HINT_DASHES,
            )
    first, last = solution.contact_y[0][0], solution.contact_y[-1][1]
    words = _contact_words(solution, span)
    side = alignment(ax, 0.5 * (first + last), span, words)
    at = {"left": first, "center": 0.5 * (first + last), "right": last}[side]
    _write(ax, words, (at, CONTACT_SHARE), side, 0.0, 3.0, across)


def _contact_words(solution: Solution, span: tuple[float, float]) -> str:
    intervals = [f"{place(low, span)} to {place(high, span)} mm" for low, high in solution.contact_y]
    if len(intervals) <= 2:
        return "contact " + " and ".join(intervals)
    low, high = solution.contact_y[0][0], solution.contact_y[-1][1]
    return f"contact on {len(intervals)} intervals between {place(low, span)} and {place(high, span)} mm"
