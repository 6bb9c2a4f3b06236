"""The public functions: stress at points, on planes and in volumes below a solved contact.

Points are processed in chunks of fixed size, in parallel on all cores, so that little memory is needed besides the
result, and the result does not depend on the number of threads.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import broadcast, check_callback, finite, flag, numbers, thread_count, whole
from nonhertz.model.body import BodyName
from nonhertz.result.solved import Solved
from nonhertz.subsurface.field import Field
from nonhertz.subsurface.inside import LEAST, NARROWING, Inside, check_body, check_solution

Array = NDArray[np.float64]
Callback = Callable[[int, int], object]

PORTION = 2048  # points per chunk
DOUBLE = 8
FARTHEST = 1e6  # mm
DEEPEST, WIDEST = 3.0, 2.0  # default extents of planes, in half-widths
STATIONS, LEVELS, ACROSS = 201, 61, 81


class Running(TypedDict, total=False):
    """Options for running all functions; see `stress`."""

    threads: int | None
    callback: Callback | None


class Within(Running, total=False):
    """The same, and the body."""

    body: BodyName


class Options(Within, total=False):
    """All options of `stress`."""

    displacement: bool


def refuse_options(verb: str, options: Mapping[str, Any], known: type) -> None:
    """Reject unknown options of a function, and invalid values, before anything is computed.

    Raises
    ------
    TypeError
        If an option is not a key of ``known``, a `TypedDict`; the message is Python's own.
    InputError
        If a value cannot be used.
    """
    for name in options:
        if name not in known.__optional_keys__:  # type: ignore[attr-defined]
            raise TypeError(f"{verb}() got an unexpected keyword argument {name!r}")
    check_body(options.get("body", "a"))
    thread_count(options.get("threads"))
    check_callback(options.get("callback"))


POINTS_REMEDY = "give finite numbers in mm, as arrays that broadcast against each other"


def stress(
    solution: Solved,
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    *,
    body: BodyName = "a",
    displacement: bool = False,
    threads: int | None = None,
    callback: Callback | None = None,
) -> Field:
    """Return the stress at points below a solved contact.

    Parameters
    ----------
    solution : Solution or PatchSolution
        Strips of either element, or a plane grid.
    x, y, z : array_like
        Points [mm] across, along and below the surface, z >= 0; broadcast against each other.
    body : {"a", "b"}
        The body that contains the points. Both bodies are under the same pressure; Poisson's ratio and mirror images
        are each body's own.
    displacement : bool
        Whether to return displacements as well; not available for a hollow roller, whose bending they do not include.
    threads : int, optional
        Number of threads; all cores if left out. The result does not depend on it.
    callback : callable, optional
        Called now and then with the number of points done and the total.

    Returns
    -------
    Field

    Raises
    ------
    InputError
        If a point is not finite, lies above the surface or beyond the side faces, no point lies in the body's material,
        or ``body`` is neither.

    Notes
    -----
    The body is a half-space under the pressure of the solution, with the images of its side faces and, where a face is
    free, the correction for an elastic quarter-space, which leaves no stress on the face. This includes faces with
    calibrated or weighted images, all of which have weight 1 here. A mirrored face is free of shear only, like a plane
    of symmetry, and behind an untreated face the half-space continues. Near free faces the error of the stress is below
    1 % of the maximum pressure.

    Displacement uses the weights of the solution: on the surface in contact, u_z of both bodies adds up to the
    interference that was solved, within 1e-3 of the largest on the automatic grid; 1.5e-3 in the last half-widths
    before a run-out, 1.5 % within a twentieth of a half-width of a sharp end, and 1.5 % under parabolic strips.

    The pressure of strips is interpolated smoothly between their centres so that each keeps its load; that of a plane
    grid is uniform in each cell, which shows near the surface. Parabolic strips are evaluated as the semi-ellipses of
    equal load, whose pressure the solution reports: a parabola has a tenth less orthogonal shear than the contact it
    represents.

    The interpolated pressure of strips has the solution's load, and its moment within 1e-3 of load times half the
    length of the contact. Compared with point loads summed by other code below 300 random contacts, on automatic and on
    few and uneven strips, from 0.13 to 2 half-widths deep, components are within 3e-6 of the maximum pressure for half
    of the points, 5e-5 for 90 %, 4e-4 for 99 % and 1.3e-3 for all; pressures at centres are within 6e-4
    (tests/campaign/test_stress_campaign.py). Nearer to the surface than 0.04 half-widths the field is accurate to the
    steps between pieces, half a per cent. Errors of the solution's pressure also affect the field: on the automatic
    grid up to a per cent of the largest stress within a half-width of a run-out, and far more on few strips. About
    10 MB are needed besides the result; see `memory`.

    References
    ----------
    A. E. H. Love, The stress produced in a semi-infinite solid by pressure on part of the boundary, Philosophical
    Transactions of the Royal Society A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009. K. L. Johnson, Contact
    Mechanics, Cambridge University Press, 1985, sections 3.2 to 3.6 and 4.2, doi:10.1017/CBO9781139171731.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000))
    >>> solution = nh.solve(nh.Contact(roller, nh.Plate()), load=6e3)
    >>> below = stress(solution, 0.0, 0.0, np.array([0.0, 0.2]))
    >>> (below.sigma_z / solution.max_pressure).round(2) + 0.0
    array([-1. , -0.8])
    """
    flag("displacement", displacement, "write True for displacements too")
    check_callback(callback)
    inside = Inside.of(solution, body)
    if displacement and inside.body.bore is not None:
        raise InputError("displacement", True, "only be requested in bodies without a bore", "leave it out")
    places = broadcast(
        POINTS_REMEDY, *(finite_numbers(name, value) for name, value in zip("xyz", (x, y, z), strict=True))
    )
    inside.refuse_outside(*places)
    return field_at(inside, places, displacement, threads, callback)


def field_at(
    inside: Inside,
    places: tuple[Array, ...],
    displacement: bool = False,
    threads: int | None = None,
    callback: Callback | None = None,
) -> Field:
    """Return the stress at points that have been checked, NaN where there is no material."""
    count = places[0].size
    inside_extent = inside.extent.holds(*places).ravel()
    stresses = np.full((count, 6), np.nan)
    displacements = np.full((count, 3), np.nan) if displacement else None

    def fill(start: int) -> int:
        part = slice(start, start + PORTION)
        rows = start + np.flatnonzero(inside_extent[part])
        points = np.column_stack([place.flat[rows] for place in places])
        stresses[rows] = inside.stress(points)
        if displacements is not None:
            displacements[rows] = inside.displacement(points)
        return int(inside_extent[part].size)

    with ThreadPoolExecutor(thread_count(threads)) as pool:
        done = 0
        for finished in pool.map(fill, range(0, count, PORTION)):
            done += finished
            if callback is not None:
                callback(done, count)
    shape = places[0].shape
    moved = displacements.reshape(*shape, 3) if displacements is not None else None
    findings = (*inside.extent.findings(inside_extent), *inside.findings)
    across, along, below = places
    return Field(inside.name, across, along, below, stresses.reshape(*shape, 6), moved, findings)


def axial_plane(
    solution: Solved,
    y: ArrayLike | None = None,
    z: ArrayLike | None = None,
    *,
    x: float = 0.0,
    **options: Unpack[Options],
) -> Field:
    """Return the stress in a plane along the contact, by default under the centre line.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    y : array_like, shape (m,), optional
        Stations [mm]; by default 201 over the contact and two half-widths beyond, within the body.
    z : array_like, shape (n,), optional
        Depths [mm]; by default 61 down to three half-widths.
    x : float
        Position of the plane across the contact [mm].
    **options
        As in `stress`.

    Returns
    -------
    Field
        Shape (m, n).
    """
    refuse_options("axial_plane", options, Options)
    finite("x", x, "give one place across the contact in mm")
    y = axial_range(solution, options.get("body", "a")) if y is None else _row("y", y)
    deepest = DEEPEST * check_solution(solution).max_half_width
    z = deepest * np.linspace(0.0, 1.0, LEVELS) if z is None else _row("z", z)
    return stress(solution, x, y[:, None], z, **options)


def cross_section(
    solution: Solved,
    station: float,
    x: ArrayLike | None = None,
    z: ArrayLike | None = None,
    **options: Unpack[Options],
) -> Field:
    """Return the stress in the plane across the contact at a station.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    station : float
        Position of the plane, y [mm].
    x : array_like, shape (m,), optional
        Positions across [mm]; by default 81 over two half-widths to either side.
    z : array_like, shape (n,), optional
        Depths [mm]; 61 down to three half-widths if left out.
    **options
        As in `stress`.

    Returns
    -------
    Field
        Shape (m, n).
    """
    refuse_options("cross_section", options, Options)
    middle, half_width = across_at(solution, np.asarray(one_station(station)))
    x = middle + WIDEST * half_width * np.linspace(-1.0, 1.0, ACROSS) if x is None else _row("x", x)
    z = DEEPEST * half_width * np.linspace(0.0, 1.0, LEVELS) if z is None else _row("z", z)
    return stress(solution, x[:, None], station, z, **options)


def volume(solution: Solved, x: ArrayLike, y: ArrayLike, z: ArrayLike, **options: Unpack[Options]) -> Field:
    """Return the stress on a grid of points with the given coordinates along each axis.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    x, y, z : array_like, shape (l,), (m,) and (n,)
        Coordinates [mm].
    **options
        As in `stress`.

    Returns
    -------
    Field
        Shape (l, m, n). If it does not fit into memory, compute it slice by slice: points are independent.
    """
    refuse_options("volume", options, Options)
    across, along, below = _row("x", x), _row("y", y), _row("z", z)
    return stress(solution, across[:, None, None], along[:, None], below, **options)


def memory(points: int, *, displacement: bool = False) -> int:
    """Return the bytes that `stress` needs for a number of points, not counting derived quantities.

    Examples
    --------
    >>> round(memory(1_000_000) / 2**20)  # MiB
    56
    """
    whole("points", points, 0, math.inf, "give the number of points")
    flag("displacement", displacement, "write True for displacements too")
    beside = (os.cpu_count() or 1) * PORTION * DOUBLE * 40
    return DOUBLE * points * (9 if displacement else 6) + max(beside, 10 * 2**20)


def across_at(solution: Solved, y: Array) -> tuple[Array, Array]:
    """Return the middle of the contact across and the effective half-width [mm] at stations.

    Where a contact runs out or has ended, the half-width is that of neighbouring strips minus half the distance to
    them, since their field has that extent there.

    Raises
    ------
    InputError
        If nothing is in contact.
    """
    touching = check_solution(solution).line_load > 0.0
    along = solution.y[touching]
    middle, half_width = (values[touching] for values in solution.extent_across)
    half_length = 0.5 * np.diff(solution.edges)[touching]
    stations = np.asarray(y, dtype=float).ravel()
    counted = np.interp(stations, along, half_width, left=0.0, right=0.0)
    for start in range(0, stations.size, PORTION):
        part = slice(start, start + PORTION)
        apart = np.abs(stations[part, None] - along)
        # Beyond the outermost centres a strip has its full half-width up to its edge.
        beyond = (stations[part] < along[0]) | (stations[part] > along[-1])
        apart[beyond] = np.maximum(apart[beyond] - half_length, 0.0)
        counted[part] = np.maximum(counted[part], (half_width - NARROWING * apart).max(axis=1))
    least = LEAST * float(half_width.max())
    return np.interp(y, along, middle), np.maximum(counted, least).reshape(np.shape(y))


def one_station(station: float) -> float:
    """Return a station as a number, or reject anything but a single number."""
    finite("station", station, "give one place along the contact in mm")
    return float(station)


def axial_range(solution: Solved, body: BodyName) -> Array:
    """Return stations [mm] over the contact and the stressed region beyond its ends."""
    check_solution(solution)
    beyond = WIDEST * float(across_at(solution, solution.y)[1].max())
    touching = solution.y[solution.line_load > 0.0]
    low, high = Inside.of(solution, body).body.faces
    return np.linspace(max(touching[0] - beyond, low), min(touching[-1] + beyond, high), STATIONS)


def finite_numbers(name: str, value: ArrayLike) -> Array:
    """Return numbers as an array, or reject anything that is not finite."""
    # A depth of -0 would be on the wrong side of a branch.
    return numbers(name, value, POINTS_REMEDY, FARTHEST, "mm") + 0.0


def _row(name: str, value: ArrayLike) -> Array:
    row = finite_numbers(name, value)
    if row.ndim != 1 or row.size == 0:
        raise InputError(name, value, "be a row of numbers", "give a list of coordinates in mm")
    return row
