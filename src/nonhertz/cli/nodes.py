"""What ``nonhertz nodes`` writes and prints."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from nonhertz.amounts import mpa, newton
from nonhertz.cli.printing import Printed, print_written
from nonhertz.errors import InputError
from nonhertz.files.folder import write_files
from nonhertz.files.nodes import Nodes, as_object, as_table
from nonhertz.files.results import key_by_key
from nonhertz.inputs.files import legible
from nonhertz.result.nodes import NodalLoads
from nonhertz.result.solution import Solution

_NOTICED = 1e-6  # of the load


def target(out: Path | None, nodes: Path) -> Path:
    """Return the file to write to.

    Raises
    ------
    InputError
        If it is a directory, or the file of the nodes itself.
    """
    path = Path(f"{legible(nodes.stem)}-pressure.csv") if out is None else out
    if path.suffix.lower() != ".csv" or path.is_dir() or path.resolve() == nodes.resolve():
        raise InputError("--out", str(path), "be a .csv file, and not that of the nodes", "choose another name")
    return path


def report_nodes(solution: Solution, title: str, nodes: Nodes, path: Path, as_json: bool) -> None:
    """Find pressures and forces at nodes, write and print them."""
    found = solution.at_nodes(nodes.x, nodes.y)
    written = write_files(path.parent, {path.name: as_table(nodes, found)})
    if as_json:
        print(key_by_key(as_object(solution, found, title)))
        return
    printing = Printed(title)
    printing.say(*sentences(solution, found))
    printing.warn(*solution.warnings)
    print_written(written)


def sentences(solution: Solution, found: NodalLoads) -> list[str]:
    """Return how many nodes are in contact, and how the sums of their pressures and forces relate to the load."""
    touching = int(np.count_nonzero(found.pressure))
    highest = mpa(float(np.max(found.pressure)))
    said = [
        f"{found.pressure.size} nodes, {touching} of them in contact. The largest pressure at a node is {highest}, "
        f"that of the contact {mpa(solution.max_pressure)}."
    ]
    load = solution.load
    if np.any(np.isnan(found.force)):
        return [*said, "The nodes span no area: there are no forces, and the pressures have no sum in N."]
    said.append(f"The forces add up to {newton(float(np.sum(found.force)))} of the load of {newton(load)}.")
    if found.outside > _NOTICED * load:
        said.append(f"{newton(found.outside)} lie outside the nodes, {_percent(found.outside, load)} of the load.")
    carried = found.interpolated_load
    factor = f"; times {load / carried:.6g} they carry it whole" if carried > 0.0 else ""
    said.append(
        f"The pressures, interpolated linearly between the nodes, carry {newton(carried)}, {_percent(carried, load)} "
        f"of the load{factor}."
    )
    return said


def _percent(part: float, whole: float) -> str:
    return f"{100.0 * part / whole:.4g} %" if whole > 0.0 else "0 %"
