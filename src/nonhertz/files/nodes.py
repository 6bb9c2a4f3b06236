"""Nodes of a finite element mesh: from a file of their coordinates, and back with pressures and forces."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from operator import attrgetter
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError, nearest
from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, within
from nonhertz.files.traces.heads import cells_of
from nonhertz.files.traces.text import decode, value_in
from nonhertz.inputs.files import read_input_file
from nonhertz.inputs.units import to_unit
from nonhertz.result.nodes import NodalLoads
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text

Array = NDArray[np.float64]

LARGEST = 200_000_000  # bytes
_HEADED = re.compile(r"(?P<name>[^\[(]*?)\s*(?:[\[(]\s*(?P<unit>[^\])]*?)\s*[\])])?")
_EXAMPLE = "write a first line such as 'node; x [mm]; y [mm]'"
_NEEDED = ("x", "y")
_RESULTS = ("pressure [MPa]", "force [N]")


@dataclass(frozen=True, eq=False)
class Nodes:
    """The nodes in a file.

    Attributes
    ----------
    head : tuple of str
        Names of its columns, as written.
    cells : list of list of str
        Its cells, as written.
    x, y : ndarray
        Coordinates of the nodes [mm].
    """

    head: tuple[str, ...]
    cells: list[list[str]]
    x: Array
    y: Array


def read_nodes(path: Path) -> Nodes:
    """Return the nodes in a file of text in columns, separated by semicolons, tabs, commas or blanks.

    The first line names the columns; x and y are needed, with a unit of length in brackets, or in mm.

    Raises
    ------
    InputError
        If the file cannot be read, or columns or numbers are missing.
    """
    lines, _ = decode(*read_input_file("path", path, LARGEST))
    written = [(number, line) for number, line in enumerate(lines, start=1) if line.strip()]
    if not written:
        raise InputError("path", str(path), "hold nodes", _EXAMPLE)
    separator = next((candidate for candidate in (";", "\t", ",") if candidate in written[0][1]), None)
    # In a header separated by blanks, units may be separated from names by blanks.
    head = cells_of(re.sub(r"\s+([\[(])", r"\1", written[0][1]) if separator is None else written[0][1], separator)
    columns = {name: _column(name, head, path) for name in _NEEDED}
    cells = []
    numbers = np.empty((len(written) - 1, len(_NEEDED)))
    for row, (number, line) in enumerate(written[1:]):
        row_cells = cells_of(line, separator)
        if len(row_cells) != len(head):
            condition = f"have as many columns in line {number} as in its head, {len(head)}, not {len(row_cells)}"
            raise InputError("path", str(path), condition, "complete the line, or delete it")
        cells.append(row_cells)
        for place, (name, (column, factor)) in enumerate(columns.items()):
            numbers[row, place] = factor * _number(row_cells[column], separator, f"{name} in line {number}", path)
    if not cells:
        raise InputError("path", str(path), "hold nodes below its head", "write a line for each node")
    return Nodes(tuple(head), cells, numbers[:, 0], numbers[:, 1])


def as_table(nodes: Nodes, loads: NodalLoads) -> str:
    """Return the file of the nodes as CSV, with pressure and force at each."""
    rows = (
        [*cells, pressure, "" if math.isnan(force) else force]
        for cells, pressure, force in zip(nodes.cells, loads.pressure.tolist(), loads.force.tolist(), strict=True)
    )
    return csv_text((*nodes.head, *_RESULTS), rows)


#: Keys of a contact on nodes.
NODES: Final = (
    Key("title", "title of the case", holds="string"),
    *within(
        "solution",
        Key("status", "how the solve ended", get="status.label", holds="string"),
        Key("load", "load of the contact", "N"),
    ),
    *within(
        "nodes",
        Key("force_sum", "sum of the forces", "N", lambda nodes: np.sum(nodes.force)),
        Key("outside", "load outside the mesh", "N"),
        Key("interpolated_load", "integral of the pressures, interpolated linearly between nodes", "N"),
    ),
    Key("max_pressure", "maximum pressure of the contact", "MPa", "solution.max_pressure"),
    *results.warning_keys(attrgetter("solution.findings")),
    results.UNITS,
    *within(
        "nodes",
        Key("x", "position of every node across the contact", "mm", holds=ListOf()),
        Key("y", "its position along the contact", "mm", holds=ListOf()),
        Key("pressure", "pressure there", "MPa", holds=ListOf()),
        Key("force", "force on it", "N", holds=ListOf()),
        Key("area", "area that it represents", "mm^2", holds=ListOf()),
    ),
)


def as_object(solution: Solution, loads: NodalLoads, title: str) -> dict[str, Any]:
    """Return pressures and forces at nodes, and their sums, as plain numbers, text and lists."""
    return results.document(NODES, title=title, solution=solution, nodes=loads)


def _column(name: str, head: Sequence[str], path: Path) -> tuple[int, float]:
    """Return the position of a column, and the factor of its unit to mm."""
    heads = [match.group("name", "unit") if match else ("", None) for match in map(_HEADED.fullmatch, head)]
    names = [name_.lower() for name_, _ in heads]
    if names.count(name) != 1:
        alike = nearest(name, [name_ for name_ in names if name_])
        shown = ", ".join(repr(name_) for name_ in names[:6])
        condition = f"have one column {name} in its head, which has {shown}"
        raise InputError("path", str(path), condition, f"rename '{alike}'" if alike and alike != name else _EXAMPLE)
    position = names.index(name)
    unit = heads[position][1]
    return position, float(to_unit(f"unit of {name}", f"1 {unit}", "mm")) if unit else 1.0


def _number(cell: str, separator: str | None, what: str, path: Path) -> float:
    # Commas that do not separate columns are decimal commas.
    value = value_in(cell if separator == "," else cell.replace(",", "."))
    if value is None or not math.isfinite(value):
        raise InputError("path", str(path), f"have a number as {what}, not {cell!r}", "correct it, or delete the line")
    return value
