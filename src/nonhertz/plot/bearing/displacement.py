"""The displacement of the inner ring under more and less than a bearing's load."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nonhertz.figures import displacement
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_key, draw_panel

if TYPE_CHECKING:
    from nonhertz.bearing import BearingMaps, BearingSolution


@drawing
def displacement_against_load(solution: BearingSolution, ax: Axes = OWN, *, maps: BearingMaps | None = None) -> Axes:
    """Draw the displacement of the inner ring under up to 1.5 times its forces.

    All forces grow in proportion; the ring's rotation and speed do not change. Radial displacement is that in the
    direction of the radial force. The curve goes through the state itself and six others, marked by dots, with the
    slopes that their exact stiffness gives; they are solved as the state was, or by maps. States that have no solution
    are left out. The state itself is marked as it was solved, with its tangent.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing.
    maps : BearingMaps, optional
        Maps of this bearing, from `nonhertz.bearing.maps`, up to 1.5 times the loads. With them the six states take
        milliseconds; by strips they take about a second.

    Raises
    ------
    InputError
        If no force acts on the ring, or the maps are not for these states.
    """
    figure = displacement.displacement_against_load(solution, maps)
    draw_panel(figure.panels[0], figure, ax)
    draw_key(figure.panels, ax)
    return ax
