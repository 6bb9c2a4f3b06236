"""Tables of forces against displacement as CSV, for other programs.

Units are those of the package: mm, rad, N, N mm. Forces are those that hold the inner ring in its position; the bearing
acts on the shaft with the opposite forces.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.section import FORCES, MOTIONS
from nonhertz.bearing.tables import ForceTable
from nonhertz.errors import InputError
from nonhertz.files.folder import write_file
from nonhertz.lazy import dir_of
from nonhertz.result.tables import as_csv

__all__ = ["as_csv_text", "write"]
__dir__ = dir_of(__name__)

Array = NDArray[np.float64]


def write(path: str | Path, table: ForceTable) -> Path:
    """Write a table into a file, whole or not at all.

    Parameters
    ----------
    path : str or Path
        The file, ``.csv``; one of the same name is overwritten.
    table : ForceTable
        From `nonhertz.bearing.table`.

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
    ...     write(folder + "/nu206.csv", found).name
    'nu206.csv'
    """
    text, remedy = as_csv_text(table), "name a .csv file"
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a file to write", remedy)
    file = Path(path)
    if file.suffix.lower() != ".csv" or file.is_dir():
        raise InputError("path", str(path), "be a file ending in .csv", remedy)
    return write_file(file, text)


def as_csv_text(table: ForceTable) -> str:
    """Return a table as CSV in long format: a line for each state, the last displacement changing fastest.

    The first line names the columns with their units: the five displacements, fixed ones included, forces and moments,
    their 25 derivatives, such as ``force_y_by_x [N/mm]``, and ``converged``, 1 or 0; forces of a state that has not
    converged are ``nan``.

    Parameters
    ----------
    table : ForceTable
        From `nonhertz.bearing.table`.

    Raises
    ------
    InputError
        If it is not a ForceTable.
    """
    if not isinstance(table, ForceTable):
        raise InputError("table", table, "be a ForceTable", "make one with nonhertz.bearing.table")
    columns: dict[str, Array] = {}
    for k, (name, unit) in enumerate(MOTIONS.items()):
        columns[f"{name} [{unit}]"] = table.displacement[..., k]
    for k, (name, unit) in enumerate(FORCES.items()):
        columns[f"{name} [{unit}]"] = table.force[..., k]
    for j, (force, unit) in enumerate(FORCES.items()):
        for k, (motion, by) in enumerate(MOTIONS.items()):
            columns[f"{force}_by_{motion} [{unit}/{by}]"] = table.stiffness[..., j, k]
    return as_csv(columns | {"converged": table.converged.astype(float)})
