"""Tables of forces against displacement for other programs: CSV, MATLAB, and lookup tables of Simulink.

All are in the units of the package: mm, rad, N, N mm. Forces are those that hold the inner ring where it is; the
bearing pushes the shaft with their opposite.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import scipy.io
from numpy.typing import NDArray

from nonhertz.bearing.section import MOTIONS
from nonhertz.bearing.tables import FORCES, UNITS_OF_FORCES, UNITS_OF_MOTIONS, ForceTable
from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_of
from nonhertz.io.folder import write_files
from nonhertz.result.numerals import as_csv

__all__ = ["as_csv_text", "as_lookup", "as_mat", "write"]

Array = NDArray[np.float64]

LAYOUTS = ("table", "simulink")
_SUFFIXES = (".csv", ".mat")


def write(path: str | Path, table: ForceTable, layout: str = "table") -> Path:
    """Write a table into a file, whole or not at all.

    Parameters
    ----------
    path : str or Path
        The file, ``.csv`` or ``.mat``; one of the same name is overwritten.
    table : ForceTable
        From `nonhertz.bearing.table`.
    layout : {"table", "simulink"}
        ``"table"``: `as_csv_text` or `as_mat`. ``"simulink"``: `as_lookup`, in a ``.mat`` file.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InputError
        If the arguments are invalid, or the directory cannot be written to.

    Examples
    --------
    >>> import tempfile
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> found = nh.bearing.table(row, y=[0, 0.01, 0.02], z=[-0.01, 0, 0.01], method="slices")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write(folder + "/nu206.mat", found, "simulink").name
    'nu206.mat'
    """
    _refuse_others(table)
    one_of("layout", layout, LAYOUTS, "use 'table', or 'simulink' for lookup tables")
    file = _checked(path, layout)
    texts = {file.name: as_csv_text(table)} if file.suffix.lower() == ".csv" else {}
    content = {} if texts else as_mat(table) if layout == "table" else as_lookup(table)

    def draft(folder: Path) -> None:
        if content:
            scipy.io.savemat(folder / file.name, content, oned_as="column")

    try:
        return write_files(file.parent, texts, draft)[0]
    except InputError as error:
        raise InputError("path", str(path), error.condition, error.remedy) from None


def _checked(path: str | Path, layout: str) -> Path:
    """Return a file of a name that fits what is to be written."""
    remedy = "name a .csv or .mat file"
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a file to write", remedy)
    file = Path(path)
    if file.suffix.lower() not in _SUFFIXES or file.is_dir():
        raise InputError("path", str(path), f"be a file ending in {', '.join(_SUFFIXES)}", remedy)
    if layout == "simulink" and file.suffix.lower() != ".mat":
        raise InputError("path", str(path), "end in .mat for Simulink", "name a .mat file, or leave out layout")
    return file


def as_csv_text(table: ForceTable) -> str:
    """Return a table as CSV in the long format: a line for each state, the last motion changing first.

    Columns are named with their units in the first line: the five motions, the fixed ones included, forces and
    moments, their 25 derivatives as ``force_y_by_x [N/mm]``, and ``converged``, 1 or 0; where a state has not
    converged, forces are ``nan``.

    Parameters
    ----------
    table : ForceTable
        From `nonhertz.bearing.table`.

    Raises
    ------
    InputError
        If it is no table.
    """
    _refuse_others(table)
    columns: dict[str, Array] = {}
    for k, (name, unit) in enumerate(zip(MOTIONS, UNITS_OF_MOTIONS, strict=True)):
        columns[f"{name} [{unit}]"] = table.displacement[..., k]
    for k, (name, unit) in enumerate(zip(FORCES, UNITS_OF_FORCES, strict=True)):
        columns[f"{name} [{unit}]"] = table.force[..., k]
    for j, (force, unit) in enumerate(zip(FORCES, UNITS_OF_FORCES, strict=True)):
        for k, (motion, by) in enumerate(zip(MOTIONS, UNITS_OF_MOTIONS, strict=True)):
            columns[f"{force}_by_{motion} [{unit}/{by}]"] = table.stiffness[..., j, k]
    return as_csv(columns | {"converged": table.converged.astype(float)})


def as_mat(table: ForceTable) -> dict[str, Any]:
    """Return the variables of a MATLAB file of a table.

    ``motions`` is a cell array of the names of the motions that vary, each also the name of a variable with its
    values; in their order are the first dimensions of ``displacement`` and ``force``, which have five columns in the
    last, of ``stiffness``, five by five in the last two, and of ``converged``. ``bound`` is what linear interpolation
    is off by in each force, ``units`` and ``description`` are text.

    Parameters
    ----------
    table : ForceTable
        From `nonhertz.bearing.table`.

    Raises
    ------
    InputError
        If it is no table.
    """
    _refuse_others(table)
    content: dict[str, Any] = dict(zip(table.names, table.axes, strict=True))
    content |= {name: getattr(table, name) for name in ("displacement", "force", "stiffness", "converged")}
    return content | _said(table)


def as_lookup(table: ForceTable) -> dict[str, Any]:
    """Return the variables of a MATLAB file with what the block "n-D Lookup Table" of Simulink takes.

    ``breakpoints1``, ``breakpoints2`` and so on are the values of the motions, in the order of the cell array
    ``motions``, which is that of the block's inputs. ``force_x``, ``force_y``, ``force_z``, ``moment_y`` and
    ``moment_z`` are tables with as many dimensions, for a block each.

    Parameters
    ----------
    table : ForceTable
        From `nonhertz.bearing.table`.

    Raises
    ------
    InputError
        If it is no table, or not all of its states have converged.
    """
    _refuse_others(table)
    if not np.all(table.converged):
        failed = int(np.count_nonzero(~table.converged))
        condition = f"have converged everywhere, not failed at {failed} points: a lookup table has no gaps"
        raise InputError("table", f"{table.converged.size} states", condition, "make one of a narrower range")
    content: dict[str, Any] = {f"breakpoints{k}": axis for k, axis in enumerate(table.axes, 1)}
    return content | {name: table.force[..., k] for k, name in enumerate(FORCES)} | _said(table)


def _said(table: ForceTable) -> dict[str, Any]:
    """Return names, units, bounds and a description."""
    names = (*MOTIONS, *FORCES)
    units = zip(names, (*UNITS_OF_MOTIONS, *UNITS_OF_FORCES), strict=True)
    return {
        "motions": np.array(table.names, dtype=object),
        "bound": table.bound(),
        "units": ", ".join(f"{name} [{unit}]" for name, unit in units),
        "description": "; ".join(line.strip() for line in repr(table).splitlines()[1:]),
    }


def _refuse_others(table: object) -> None:
    if not isinstance(table, ForceTable):
        raise InputError("table", table, "be a ForceTable", "make one with nonhertz.bearing.table")
