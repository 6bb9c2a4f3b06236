"""What is drawn of a result: of a contact, or of a whole bearing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Final

from nonhertz.bearing import BearingSolution
from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_of
from nonhertz.plot.bearing.displacement import displacement_against_load
from nonhertz.plot.bearing.loads import bearing_loads
from nonhertz.plot.bearing.pressure import bearing_pressure
from nonhertz.plot.bearing.roller import most_loaded_roller, roller_relief
from nonhertz.plot.bearing.sheets import bearing_figures
from nonhertz.plot.centre_line import pressure
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.sheets import contact_figures
from nonhertz.plot.surfaces import profile
from nonhertz.result.solution import Solution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Drawings = Mapping[str, Callable[..., Any]]

OF_CONTACTS: Final[Drawings] = {"pressure": pressure, "footprint": footprint, "profile": profile}
OF_BEARINGS: Final[Drawings] = {
    "loads": bearing_loads,
    "pressure": bearing_pressure,
    "roller": most_loaded_roller,
    "relief": roller_relief,
    "displacement": displacement_against_load,
}


def draw(result: Solution | BearingSolution, what: str, ax: Axes | None = None) -> Axes:
    """Draw one thing of a result, as its method ``plot`` does."""
    from matplotlib import axes

    drawings = OF_BEARINGS if isinstance(result, BearingSolution) else OF_CONTACTS
    one_of("what", what, tuple(drawings), "choose one of them")
    if ax is not None and not isinstance(ax, axes.Axes):
        raise InputError("ax", ax, "be axes of matplotlib", "leave it out for a figure of its own")
    drawn: Axes = drawings[what](result, ax)
    return drawn


def figures(result: Solution | BearingSolution, title: str = "") -> dict[str, Figure]:
    """Return the finished figures of a result, by name; `save` writes them.

    Parameters
    ----------
    result : Solution or BearingSolution
        A solved contact, or a loaded bearing (see `bearing_figures`).
    title : str
        Heading of every figure; none if empty.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Of a contact ``"pressure"``, ``"footprint"`` and ``"profile"``.
    """
    return bearing_figures(result, title) if isinstance(result, BearingSolution) else contact_figures(result, title)
