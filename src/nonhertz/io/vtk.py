"""Contacts as VTK files, ``.vtu``, for ParaView and PyVista: the surface, and the stress below it.

Coordinates are those of the contact in mm: x across, y along, and z into the body, so that the surface is z = 0. Names
of the numbers carry their units.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.io.folder import write_files
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Field

__all__ = ["write_field", "write_surface"]

Array = NDArray[np.float64]

_INSIDE = 33  # points across the contact at every strip
_OUTSIDE = 4  # beyond it on either side
_WIDEST = 1.5  # of the largest half-width, where the surface ends
_LEAST = 0.02  # of the largest half-width: points do not coincide where nothing touches
_COMPONENTS = ("sigma_x", "sigma_y", "sigma_z", "tau_yz", "tau_xz", "tau_xy", "von_mises", "max_shear")
_CELLS = {1: "quad", 2: "hexahedron"}  # by the number of directions less one
_REMEDY = "give what the functions of nonhertz.subsurface for planes or volumes return"


def write_surface(path: str | Path, solution: Solution) -> Path:
    """Write the surface of a contact: the pressure at every point, half-width and gap of every strip.

    Parameters
    ----------
    path : str or Path
        The file, ``.vtu``; one of the same name is overwritten.
    solution : Solution
        A solved contact.

    Returns
    -------
    Path
        The file. Its mesh has a row of points at the middle of every strip, with two of them on the edges of the
        footprint, and goes on to 1.5 times the largest half-width. The gap is that on the centre line.

    Raises
    ------
    InputError
        If the path does not end in .vtu or cannot be written to, the solution is not one of strips, or has fewer than
        two strips, or nothing touches.
    ModuleNotFoundError
        If meshio is not installed.
    """
    if not isinstance(solution, Solution):
        raise InputError("solution", solution, "be a Solution", "give what nonhertz.solve returns")
    if solution.strips < 2 or not solution.max_half_width > 0.0:
        condition = "have two strips and a contact for a surface between them"
        raise InputError("solution", solution, condition, "solve it with more strips, or under a higher load")
    widest = float(np.max(solution.half_width))
    half_width = np.maximum(solution.half_width, _LEAST * widest)
    # Dense where the semi-ellipse is steep.
    inside = half_width[:, None] * np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, _INSIDE))
    beyond = half_width[:, None] + (_WIDEST * widest - half_width)[:, None] * np.linspace(0.0, 1.0, _OUTSIDE + 1)[1:]
    x = np.hstack([-beyond[:, ::-1], inside, beyond])
    y = np.broadcast_to(solution.y[:, None], x.shape)
    numbers = {
        "pressure [MPa]": solution.pressure(x, y),
        "half_width [mm]": np.broadcast_to(solution.half_width[:, None], x.shape),
        "gap_on_centre_line [mm]": np.broadcast_to(solution.gap[:, None], x.shape),
    }
    return _written(path, (x, y, np.zeros(x.shape)), numbers)


def write_field(path: str | Path, field: Field) -> Path:
    """Write the stress on a plane or in a volume.

    Parameters
    ----------
    path : str or Path
        The file, ``.vtu``; one of the same name is overwritten.
    field : Field
        What `nonhertz.subsurface.axial_plane`, ``cross_section`` or ``volume`` returns: points in two or three
        directions.

    Returns
    -------
    Path
        The file: all components of the stress, von Mises and maximum shear stress, and the displacement if the field
        has it.

    Raises
    ------
    InputError
        If the path does not end in .vtu or cannot be written to, or the field has no such points.
    ModuleNotFoundError
        If meshio is not installed.
    """
    if not isinstance(field, Field):
        raise InputError("field", field, "be a Field", _REMEDY)
    # A plane that `volume` returns has one point across it.
    shape = tuple(size for size in field.shape if size > 1)
    if len(shape) - 1 not in _CELLS:
        raise InputError("shape of the field", field.shape, "have points in two or three directions", _REMEDY)
    numbers = {f"{name} [MPa]": getattr(field, name).reshape(shape) for name in _COMPONENTS}
    if field.displacement is not None:
        numbers["displacement [mm]"] = field.displacement.reshape(*shape, 3)
    return _written(path, tuple(each.reshape(shape) for each in (field.x, field.y, field.z)), numbers)


def _written(path: str | Path, places: tuple[Array, ...], numbers: Mapping[str, Array]) -> Path:
    import meshio

    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a file", "give a string or a Path")
    path = Path(path)
    if path.suffix.lower() != ".vtu":
        raise InputError("path", str(path), "end in .vtu", "rename it")
    shape = places[0].shape
    data = {name: values.reshape(places[0].size, *values.shape[len(shape) :]) for name, values in numbers.items()}
    points = np.column_stack([np.ravel(each) for each in places])
    mesh = meshio.Mesh(points, [(_CELLS[len(shape) - 1], _cells(shape))], point_data=data)
    try:
        (written,) = write_files(path.parent, {}, lambda folder: mesh.write(folder / path.name, file_format="vtu"))
    except InputError as error:
        raise InputError("path", str(path), error.condition, error.remedy) from None
    return written


def _cells(shape: tuple[int, ...]) -> NDArray[np.intp]:
    """Return the corners of the cells between points in rows, in the order of VTK: round a face, then the opposite."""
    number = np.arange(int(np.prod(shape))).reshape(shape)
    low, high = slice(None, -1), slice(1, None)
    face = [(low, low), (high, low), (high, high), (low, high)]
    corners = face if len(shape) == 2 else [(*each, third) for third in (low, high) for each in face]
    return np.stack([number[corner].ravel() for corner in corners], axis=1)
