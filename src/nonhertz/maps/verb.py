"""The entry point: a contact and its ranges in, a map out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.findings import warn
from nonhertz.inputs.checks import check_callback, finite, number_that, numbers, thread_count, whole
from nonhertz.maps.build import FIRST_CELLS, Building, build_surfaces
from nonhertz.maps.fitting import Shape
from nonhertz.maps.touch import Relief
from nonhertz.maps.value import ContactMap
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import MOST_TILT, refuse_load
from nonhertz.model.profile.base import at_ends
from nonhertz.result import brief
from nonhertz.solver.one import element_of
from nonhertz.strip.element import SEMI_ELLIPTIC, Element

Array = NDArray[np.float64]
Range = tuple[float, float]

STATIONS, MOST_STATIONS = 21, 200
CHECKS, FEWEST_CHECKS, MOST_CHECKS = 300, 20, 100_000
_SINGLE = 5e-5  # rad on both sides of a single tilt, for the derivatives
_END_TILTS = 9
_BEYOND = 1.02  # the largest load between those tilts, over the largest at them
# Where a straight length tips over: the scale of tilts under no load over that under the largest load.
_LIGHTEST = 2e-3
_relative_error = number_that(lambda error: 1e-6 <= error <= 0.1, "lie between 1e-06 and 0.1")


def contact_map(
    contact: Contact,
    *,
    load: Range | None = None,
    approach: Range | None = None,
    tilt: Range | float = 0.0,
    accuracy: float = 1e-4,
    element: Element | str = SEMI_ELLIPTIC,
    stations: int | ArrayLike = STATIONS,
    threads: int | None = None,
    checks: int = CHECKS,
    callback: Callable[[str], None] | None = None,
) -> ContactMap:
    """Return a fast surrogate of a contact over approach and tilt, or load and tilt.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    load : tuple of float, optional
        Lowest and highest load [N]. Give this or ``approach``. A map always begins at no load; its tables begin at the
        lowest load.
    approach : tuple of float, optional
        Lowest and highest approach [mm]; the map reaches up to the largest load in this range, at any tilt.
    tilt : tuple of float or float
        Lowest and highest tilt [rad], or a single one: the map then reaches 0.05 mrad to both sides.
    accuracy : float
        Largest error of load and moment, relative as in `SampledErrors`, from 1e-6; the errors reached are in
        ``ContactMap.sampled_error``. The solutions scatter by some 1e-5 from grid to grid, which limits any map.
        Stiffness, pressures, half-widths and loads on strips are less accurate, usually within 1 %.
    element : Element or str
        As in `nonhertz.solve`.
    stations : int or array_like
        Number of equal strips along the contact whose loads the map contains, or their edges [mm].
    threads : int, optional
        As in `nonhertz.solve_many`; the map does not depend on it.
    checks : int
        Number of points, not used to build the map, at which errors are sampled.
    callback : callable, optional
        Called with a few words on the progress before each round of solving.

    Returns
    -------
    ContactMap

    Raises
    ------
    InputError
        If the input is invalid, the bodies do not touch in the range, or too few cases in it have a solution.

    Warns
    -----
    AccuracyWarning
        If the sampled error of load or moment exceeds the accuracy, or that of another quantity 2 % and the accuracy,
        such as loads on strips where the bodies touch in separate intervals.

    Notes
    -----
    The surrogate is a spline for the mean approach, fitted to solved cases; see `nonhertz.maps.evaluation`. Load and
    moment have continuous second derivatives inside the range, and are zero out of contact.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> contact = Contact(Roller(diameter=20, length=20, profile=crown(radius=4000)), Plate())
    >>> stiffness = contact_map(contact, load=(0, 10e3), accuracy=1e-2)
    >>> round(stiffness.at(approach=0.01, tilt=0.0).load, -2)
    4000.0
    """
    check_callback(callback)
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    thread_count(threads)
    _relative_error("accuracy", accuracy, "1e-4 suits most uses")
    checks = whole("checks", checks, FEWEST_CHECKS, MOST_CHECKS, "300 suit most uses")
    building = Building(contact, element_of(element), threads, np.empty(0), checks)
    by_load, pressed = _range_of_load(contact, load, approach)
    max_load, relief, rise = _extent(building, by_load, pressed, tilts := _tilts(tilt))
    ends = float(relief.y[0]), float(relief.y[-1])
    building = replace(building, stations=_stations(stations, ends))
    shape = _shape(relief, max_load, rise, tilts)
    surfaces = build_surfaces(building, shape, relief, accuracy, callback or (lambda _: None))
    bodies = f"{brief.body_line(contact.a)} against {brief.body_line(contact.b)}"
    made = ContactMap(
        description=f"{bodies}, {building.element.name} strips",
        given="load" if by_load else "approach",
        pressed=pressed,
        stations=building.stations,
        accuracy=float(accuracy),
        **surfaces,
    )
    warn(made.findings)
    return made


def _range_of_load(contact: Contact, load: Range | None, approach: Range | None) -> tuple[bool, Range]:
    """Return whether loads are given, and the range of loads or approaches."""
    if (load is None) == (approach is None):
        raise InputError("load", load, "be given where approach is not, and only there", "give load or approach")
    if load is None:
        return False, _range("approach", approach, "mm")
    low, high = _range("load", load, "N")
    if low < 0.0:
        raise InputError("load", load, "not begin below zero", "begin at 0")
    refuse_load(contact, high)
    return True, (low, high)


def _range(name: str, value: object, unit: str) -> Range:
    remedy = f"give its lowest and its highest value in {unit}, such as (lo, hi)"
    ends = numbers(name, value, remedy)  # type: ignore[arg-type]
    if ends.shape != (2,) or not ends[0] < ends[1]:
        raise InputError(name, value, "be two ascending numbers", remedy)
    return float(ends[0]), float(ends[1])


def _single(value: object) -> bool:
    """Return whether a value is not a sequence; one of unequal rows is."""
    try:
        return np.ndim(value) == 0  # type: ignore[arg-type]
    except ValueError:
        return False


def _tilts(tilt: Range | float) -> Range:
    if _single(tilt):
        finite("tilt", tilt, "give the tilt in rad, or its range")  # type: ignore[arg-type]
        low, high = float(tilt) - _SINGLE, float(tilt) + _SINGLE  # type: ignore[arg-type]
    else:
        low, high = _range("tilt", tilt, "rad")
    if max(abs(low), abs(high)) > MOST_TILT:
        raise InputError("tilt", tilt, f"hold small angles, of at most {MOST_TILT:g} rad", "give it in rad")
    return low, high


def _stations(stations: int | ArrayLike, ends: Range) -> Array:
    remedy = "give a number of strips, or their ascending edges in mm"
    if _single(stations):
        count = whole("stations", stations, 1, MOST_STATIONS, remedy)  # type: ignore[arg-type]
        return np.linspace(*ends, count + 1)
    edges = at_ends(numbers("stations", stations, remedy), ends)
    if edges.ndim != 1 or not 2 <= edges.size <= MOST_STATIONS + 1 or np.any(np.diff(edges) <= 0.0):
        raise InputError("stations", stations, f"be ascending edges of 1 to {MOST_STATIONS} strips", remedy)
    if edges[0] > ends[0] or edges[-1] < ends[1]:
        condition = f"reach from {mm(ends[0], ends[1], between=' to '):.6g}, where the bodies can touch"
        raise InputError("stations", stations, condition, remedy)
    return edges


def _extent(building: Building, by_load: bool, pressed: Range, tilts: Range) -> tuple[float, Relief, float]:
    """Return the largest load, the relief where the bodies can touch, and the increase of the approach up to that load.

    They result from solving under the largest load or approach at a few tilts.
    """
    tilt = np.linspace(*tilts, _END_TILTS)
    solutions = building.solve("load" if by_load else "approach", np.full(_END_TILTS, pressed[1]), tilt)
    good = np.flatnonzero(solutions.converged)
    if good.size == 0:
        error = solutions.failures[0]
        if isinstance(error, InputError):
            raise error
        raise InputError("contact", "", "have a solution at the end of the range", f"narrow the range ({error})")
    max_load = pressed[1] if by_load else _BEYOND * float(solutions.load[good].max())
    low, high = building.contact.interval
    edges = [solutions.line_load(int(number))[0] for number in good]
    outermost = min(float(positions[0]) for positions in edges), max(float(positions[-1]) for positions in edges)
    ends = low if np.isfinite(low) else outermost[0], high if np.isfinite(high) else outermost[1]
    relief = Relief.between(building.contact, *ends)
    return max_load, relief, float(np.median(solutions.approach[good] - relief.touched(tilt[good])))


def _shape(relief: Relief, max_load: float, rise: float, tilts: Range) -> Shape:
    centre, length, width = relief.tipping(*tilts)
    narrow, widening = tilts[1] - tilts[0], 0.0
    if length > 0.0:
        widening = rise / length
        narrow = max(width, _LIGHTEST * widening)
    # A single tilt has a range only for the derivatives: one cell averages their scatter.
    cells = FIRST_CELLS if tilts[1] - tilts[0] > 2.0 * _SINGLE else (FIRST_CELLS[0], 1)
    numbers_of_shape = np.array([max_load, *tilts, centre, narrow, widening, rise, relief.y[0], relief.y[-1]])
    breaks = np.linspace(0.0, 1.0, cells[0] + 1), np.linspace(0.0, 1.0, cells[1] + 1)
    return Shape(numbers_of_shape, breaks, 0.5 * float(relief.y[-1] - relief.y[0]))
