"""``nonhertz nodes``: pressures and forces at the nodes of a mesh."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from nonhertz import InputError, Solution, read_case
from nonhertz.amounts import mpa, newton
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, default_output_path, rename_fields
from nonhertz.files.folder import refuse_unwritable_file, write_files
from nonhertz.files.nodes import as_object, as_table, read_nodes
from nonhertz.files.results import key_by_key
from nonhertz.result.nodes import NodalLoads
from nonhertz.show.sections import Notes, Section
from nonhertz.show.solving import solve_case
from nonhertz.verdict import judge_contact

_NOTICED = 1e-6  # of the load


def nodes(
    case: Path,
    nodes: Path,
    /,
    *,
    changes: Changes = NONE,
    out: Path | None = None,
) -> Answer:
    """Find pressures and forces of a case at the nodes of a finite element mesh.

    Pressures are those of the contact at each node. The forces add up to the load on any mesh.

    Parameters
    ----------
    case : Path
        The case file.
    nodes : Path
        Text in columns, whose first line names x and y with units: 'node; x [mm]; y [mm]'. Other columns are kept.
    out : Path
        The CSV file to write; by default the name of the file of nodes with '-pressure.csv', in the current directory.
    """
    path = default_output_path(nodes, "-pressure.csv", out)
    if path.suffix.lower() != ".csv" or path.is_dir() or path.resolve() == nodes.resolve():
        raise InputError("--out", str(path), "be a .csv file other than that of the nodes", "choose another name")
    read = read_case(case, changes)
    with rename_fields(path="NODES"):
        mesh = read_nodes(nodes)
    refuse_unwritable_file(path)
    solution = solve_case(read)
    loads = solution.at_nodes(mesh.x, mesh.y)
    made = write_files(path.parent, {path.name: as_table(mesh, loads)})
    shown, text = _describe_loads(solution, loads), lambda: key_by_key(as_object(solution, loads, read.title))
    return Answer(read.title, [Section("", [Notes(shown)])], text, judge_contact(solution), solution.warnings, made)


def _describe_loads(solution: Solution, loads: NodalLoads) -> list[str]:
    """Return how many nodes are in contact, and how the sums of their pressures and forces relate to the load."""
    touching = int(np.count_nonzero(loads.pressure))
    highest = mpa(float(np.max(loads.pressure)))
    sentences = [
        f"{loads.pressure.size} nodes, {touching} of them in contact. The maximum pressure at a node is {highest}, "
        f"that of the contact {mpa(solution.max_pressure)}."
    ]
    load = solution.load
    if np.any(np.isnan(loads.force)):
        return [*sentences, "The nodes span no area, so there are no forces, and the pressures cannot be integrated."]
    sentences.append(f"The forces add up to {newton(float(np.sum(loads.force)))} of the load of {newton(load)}.")
    if loads.outside > _NOTICED * load:
        sentences.append(f"{newton(loads.outside)} lie outside the mesh, {_percent(loads.outside, load)} of the load.")
    interpolated = loads.interpolated_load
    factor = f"; multiply them by {load / interpolated:.6g} to match it" if interpolated > 0.0 else ""
    sentences.append(
        f"The pressures, interpolated linearly between the nodes, integrate to {newton(interpolated)}, "
        f"{_percent(interpolated, load)} of the load{factor}."
    )
    return sentences


def _percent(part: float, whole: float) -> str:
    return f"{100.0 * part / whole:.4g} %" if whole > 0.0 else "0 %"
