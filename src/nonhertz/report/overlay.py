"""Several cases in one figure: pressure and half-width along the contact, and separation before loading."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from nonhertz.plot.axial import AXIAL_LABEL, axial_range, mark_unlimited
from nonhertz.plot.sheets import BOTTOM, LEFT, WIDTH, blank, panel
from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, INK, LINE, SECOND, SMALL_SIZE, sheet_style
from nonhertz.report.results import CaseResults

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Colours distinguishable with any colour vision (Okabe and Ito), each with its own dashes for printing in grey.
LINES = (
    (FIRST, "-"), (SECOND, (0, (5, 1.5))), ("#009E73", (0, (6, 1.5, 1.2, 1.5))), ("#CC79A7", (0, (1.2, 1.2))),
    (INK, (0, (8, 2))), ("#B08A00", (0, (3, 1, 1, 1, 1, 1))),
)  # fmt: skip
HIGH, LOW, BETWEEN, MARGIN, ROW = 2.3, 1.5, 0.25, 0.15, 0.17  # inches; the last is a line of the legend
ROOM, BEYOND = 1.08, 1.6  # axis limit over the largest value: usually, and where a pressure has no limit
MICROMETRES = 1e3


class Labelled(Protocol):
    """Results with a short name."""

    @property
    def label(self) -> str:
        """What they are called in legends."""


def pressures(found: Sequence[CaseResults]) -> Figure:
    """Return a sheet with the pressure of all cases and, below, their half-widths."""
    with sheet_style():
        key = key_height(found)
        figure = blank(key + HIGH + BETWEEN + LOW + BOTTOM)
        upper = panel(figure, LEFT, BOTTOM + LOW + BETWEEN, WIDTH - LEFT - MARGIN, HIGH)
        lower = panel(figure, LEFT, BOTTOM, WIDTH - LEFT - MARGIN, LOW)
        for each, (colour, dashes) in zip(found, lines_of(found), strict=True):
            solution = each.solution
            drawn: dict[str, Any] = {"color": colour, "linestyle": dashes, "linewidth": LINE}
            upper.plot(solution.y, solution.centre_pressure, **drawn)
            lower.plot(solution.y, solution.half_width, **drawn)
        sharp = any(each.solution.singular_ends for each in found)
        upper.set_ylim(0.0, max(each.solution.max_pressure for each in found) * (BEYOND if sharp else ROOM) or 1.0)
        lower.set_ylim(0.0, max(float(each.solution.half_width.max()) for each in found) * ROOM or 1.0)
        mark_unlimited([each.solution for each in found], upper, [colour for colour, _ in lines_of(found)])
        upper.set_ylabel("Centre-line pressure $p_0$ [MPa]")
        lower.set_ylabel("Half-width $b$ [mm]")
        _along(upper, found)
        _along(lower, found)
        upper.set_xlabel("")
        upper.tick_params(labelbottom=False)
        legend(upper, upper.lines[: len(found)], found)
        return figure


def reliefs(found: Sequence[CaseResults]) -> Figure:
    """Return a sheet with the separation before loading (the sum of both reliefs) of all cases."""
    with sheet_style():
        key = key_height(found)
        figure = blank(key + HIGH + BOTTOM)
        axes = panel(figure, LEFT, BOTTOM, WIDTH - LEFT - MARGIN, HIGH)
        tops = []
        for each, (colour, dashes) in zip(found, lines_of(found), strict=True):
            solution = each.solution
            separation = MICROMETRES * solution.contact.separation(solution.y)
            separation = np.where(np.isfinite(separation), separation, np.nan)
            axes.plot(solution.y, separation, color=colour, linestyle=dashes, linewidth=LINE)
            touching = separation[solution.line_load > 0.0]
            tops.append(float(np.nanmax(touching)) if touching.size else 0.0)
        low = min(0.0, *axes.get_ylim())
        # Beyond the contact a relief may rise to tenths of a millimetre.
        axes.set_ylim(low, BEYOND * max(tops) or 1.0)
        axes.set_ylabel("Separation before loading [µm]")
        axes.axhline(0.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
        _along(axes, found)
        legend(axes, axes.lines[: len(found)], found)
        return figure


def lines_of(found: Sequence[Labelled]) -> list[tuple[str, Any]]:
    """Return the colour and the dashes of each case."""
    return [LINES[number % len(LINES)] for number in range(len(found))]


def _along(axes: Axes, found: Sequence[CaseResults]) -> None:
    spans = [axial_range(each.solution) for each in found]
    axes.set_xlim(min(low for low, _ in spans), max(high for _, high in spans))
    axes.locator_params(axis="x", steps=[1, 2, 5, 10])
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.set_xlabel(AXIAL_LABEL)


def key_height(found: Sequence[Labelled]) -> float:
    """Return the height of the legend above a panel [inch]."""
    return 0.12 + ROW * len(found)


def legend(axes: Axes, handles: Sequence[Any], found: Sequence[Labelled]) -> None:
    """Put the legend above the axes, one line per case: it must not cover a curve, and names may be long."""
    numbers = [str(number) for number in range(1, len(found) + 1)]
    drawn = axes.legend(
        handles, numbers, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=1, borderaxespad=0.2,
        borderpad=0.2, labelspacing=0.25, handlelength=3.2, frameon=False, fontsize=SMALL_SIZE,
    )  # fmt: skip
    for text, number, each in zip(drawn.get_texts(), numbers, found, strict=True):
        # A file's name: a dollar sign must not start mathtext, nor a leading underscore hide the entry.
        text.set_parse_math(False)
        text.set_text(f"{number}  {each.label}")
