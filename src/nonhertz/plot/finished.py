"""Drawings of a contact, a whole bearing or a comparison: by name, and as finished figures of page width."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Final

from nonhertz.bearing.solution import BearingSolution
from nonhertz.comparison import Comparison
from nonhertz.errors import InputError
from nonhertz.figures import bearing, contact
from nonhertz.figures.comparison import compared_methods
from nonhertz.inputs.checks import one_of
from nonhertz.plot.axes import Axes, Figure
from nonhertz.plot.bearing.displacement import displacement_against_load
from nonhertz.plot.bearing.loads import bearing_loads
from nonhertz.plot.bearing.pressure import bearing_pressure
from nonhertz.plot.bearing.roller import most_loaded_roller, roller_relief
from nonhertz.plot.centre_line import pressure, profile
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.drawer import sheet_of, sheets_of
from nonhertz.plot.style import sheet_style
from nonhertz.result.solution import Solution

if TYPE_CHECKING:
    from nonhertz.bearing import BearingMaps
    from nonhertz.bearing.film import Films

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


def figures(result: Solution | BearingSolution, title: str = "", *, films: Films | None = None) -> dict[str, Figure]:
    """Return the finished figures of a result, by name; `save` writes them.

    Parameters
    ----------
    result : Solution or BearingSolution
        A solved contact, or a loaded bearing (see `bearing_figures`).
    title : str
        Heading of every figure; none if empty.
    films : Films, optional
        For a bearing, its oil films.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        For a contact ``"pressure"``, ``"footprint"`` and ``"profile"``.
    """
    if isinstance(result, BearingSolution):
        return bearing_figures(result, title, films=films)
    return sheets_of(contact.figures_of(result), title)


def bearing_figures(
    solution: BearingSolution, title: str = "", *, maps: BearingMaps | None = None, films: Films | None = None
) -> dict[str, Figure]:
    """Return one finished figure each of loads, pressure, most loaded roller and displacement.

    Parameters
    ----------
    solution : BearingSolution
        A loaded bearing. If it was solved by slices there are no pressures, and so neither ``"pressure"`` nor
        ``"roller"``.
    title : str
        Heading of every figure; none if empty.
    maps : BearingMaps, optional
        For the displacement, in place of slices; see `displacement_against_load`.
    films : Films, optional
        Its oil films, from `nonhertz.bearing.films`.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Keys ``"loads"``, ``"pressure"``, ``"perspective"`` and ``"roller"`` (by strips, if any roller is loaded), and
        ``"displacement"`` (if a force acts on the inner ring), with films ``"film"`` and ``"film-along"``; `save`
        writes them.
    """
    return sheets_of(bearing.figures_of(solution, maps, films), title)


def comparison(methods: Comparison, title: str = "") -> Figure:
    """Return a sheet of strips and plane grid: pressure along the contact, its differences, and three cuts across.

    The plane grid is a line, and each strip of either element a marker; differences are relative to the plane grid, on
    an axis that is linear up to 1 % and logarithmic beyond. Across, each cell is a dot and the strips are drawn with
    the shape they assume. Where a sharp end makes the pressure singular, the pressure axis is cut.

    Parameters
    ----------
    methods : Comparison
        The result of `nonhertz.compare`.
    title : str
        Heading; none if empty.

    Returns
    -------
    matplotlib.figure.Figure
        `save` writes it.
    """
    with sheet_style():
        return sheet_of(compared_methods(methods), title)
