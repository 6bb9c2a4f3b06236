"""The figures of bearings with their captions: one bearing, and the loads of several in one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.plot import bearing_figures
from nonhertz.plot.sheets import BOTTOM, LEFT, WIDTH, blank, panel
from nonhertz.plot.style import LINE, sheet_style
from nonhertz.report.bearing.overview import bearing_keys
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.figures import Gallery, ReportFigure
from nonhertz.report.overlay import BETWEEN, HIGH, MARGIN, ROOM, key_height, legend, lines_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_CAPTIONS = {
    "loads": "Loads of all rollers around the bearing's axis.",
    "pressure": "Pressure of all rollers on the centre lines of their contacts, over the angle and along the roller.",
    "roller": "The most loaded roller: pressure on both rings, and the relief that it starts from.",
    "displacement": "Displacement of the inner ring along the force under up to 1.5 times the load.",
}
_QUARTER = 90.0


def bearing_pictures(found: BearingResults, gallery: Gallery) -> dict[str, ReportFigure]:
    """Return loads, pressure, most loaded roller and displacement, as far as there are any, by these names."""
    if found.solution is None:
        return {}
    summary = f"{found.case.title}: {gallery.in_words(bearing_keys(found))}"
    return {
        name: gallery.picture(drawn, _CAPTIONS[name], summary)
        for name, drawn in bearing_figures(found.solution).items()
    }


def compared_picture(found: Sequence[BearingResults], gallery: Gallery) -> ReportFigure | None:
    """Return the loads of the rollers of all bearings over their angle, and pressures if all have any."""
    solved = [each for each in found if each.solution is not None]
    if not solved:
        return None
    names = ", ".join(each.label for each in found)
    pressed = _all_pressed(solved)
    what = "Load and maximum pressure" if pressed else "Load"
    caption = f"{what} of all rollers at the inner ring, over the angle from the first one; each row has a line."
    return gallery.picture(_loads(solved), caption, names)


def _all_pressed(found: Sequence[BearingResults]) -> bool:
    return all(each.solution is not None and each.solution.method == "strips" for each in found)


def _loads(found: Sequence[BearingResults]) -> Figure:
    pressed = _all_pressed(found)
    with sheet_style():
        more = BETWEEN + HIGH if pressed else 0.0
        figure = blank(key_height(found) + HIGH + more + BOTTOM)
        upper = panel(figure, LEFT, BOTTOM + more, WIDTH - LEFT - MARGIN, HIGH)
        handles = _curves(upper, found, "load", "Load at the inner ring [N]")
        legend(upper, handles, found)
        lowest = upper
        if pressed:
            lowest = panel(figure, LEFT, BOTTOM, WIDTH - LEFT - MARGIN, HIGH)
            _curves(lowest, found, "max_pressure", "Maximum pressure [MPa]")
            upper.tick_params(labelbottom=False)
        lowest.set_xlabel("Angle of the roller [degrees]")
        return figure


def _curves(axes: Axes, found: Sequence[BearingResults], name: str, label: str) -> list[object]:
    """Draw a line for each row of each bearing, and return one of each bearing for the key."""
    handles: list[object] = []
    top = 0.0
    for each, (colour, dashes) in zip(found, lines_of(found), strict=True):
        solution = each.solution
        assert solution is not None
        for row in range(len(solution.bearing.rows)):
            these = solution.rollers_of(row)
            angle = (np.degrees(solution.angle[these]) + 180.0) % 360.0 - 180.0
            values = getattr(solution, name)[these, 0]
            order = np.argsort(angle)
            (line,) = axes.plot(
                angle[order], values[order], color=colour, linestyle=dashes, linewidth=LINE, marker="o", markersize=3.0
            )
            top = max(top, float(values.max()))
            if row == 0:
                handles.append(line)
    axes.set_ylim(0.0, ROOM * top or 1.0)
    axes.set_xlim(-180.0, 180.0)
    axes.set_xticks(np.arange(-180.0, 181.0, 0.5 * _QUARTER))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.set_ylabel(label)
    return handles
