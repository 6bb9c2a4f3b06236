"""Pressure on the centre line and half-width, along the contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nonhertz.plot.axial import (
    AXIAL_LABEL,
    alignment,
    axial_range,
    body_ends,
    draw_body_ends,
    head,
    number,
    place,
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

# The largest pressure and half-width stand at these shares of the axes' height: far enough apart to be told
# from each other (in a line contact both curves have one shape), with room above for the words.
PRESSURE_SHARE, HALF_WIDTH_SHARE = 0.76, 0.52
CONTACT_SHARE = 0.9


def pressure(solution: Solution, ax: Axes) -> Axes:
    """Draw the centre-line pressure p0 (left axis) and the half-width b (right axis) against y.

    Both lines run through the centres of the strips; the pale steps are the strips themselves. The largest
    pressure, the ends of the contact and the ends of the bodies are marked. The right axis belongs to a twin
    of ``ax`` in the same figure.

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
    ax.set_ylim(0.0, _top(solution.max_pressure, PRESSURE_SHARE))
    right.set_ylim(0.0, _top(float(solution.half_width.max()), HALF_WIDTH_SHARE))
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
    y = solution.max_pressure_y
    words = f"{number(solution.max_pressure)} MPa at $y$ = {place(y, span)} mm"
    if np.isinf(solution.error_estimate.max_pressure):
        words += " (sharp end: rises with refinement)"
    ax.plot([y], [solution.max_pressure], marker="o", markersize=4.0, color=FIRST, markerfacecolor="white")
    side = alignment(ax, y, span, words)
    ax.annotate(
        words,
        (y, solution.max_pressure),
        xytext=({"left": 3.0, "center": 0.0, "right": -3.0}[side], 6.0),
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
    ax.annotate(
        words,
        ({"left": first, "center": 0.5 * (first + last), "right": last}[side], CONTACT_SHARE),
        xycoords=across,
        xytext=(0.0, 3.0),
        textcoords="offset points",
        ha=side,
        va="bottom",
        fontsize=SMALL_SIZE,
        color=INK,
    )


def _contact_words(solution: Solution, span: tuple[float, float]) -> str:
    intervals = [f"{place(low, span)} to {place(high, span)} mm" for low, high in solution.contact_y]
    if len(intervals) <= 2:
        return "contact " + " and ".join(intervals)
    low, high = solution.contact_y[0][0], solution.contact_y[-1][1]
    return f"contact on {len(intervals)} intervals between {place(low, span)} and {place(high, span)} mm"
