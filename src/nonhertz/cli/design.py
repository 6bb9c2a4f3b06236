"""``nonhertz design``: the best profile or dimensions."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz.cli.front import as_json as front_json
from nonhertz.cli.front import front_sections, searched_front, written_front
from nonhertz.cli.options import AsJson, Changes, UnitsRead, Workers, named_as, written
from nonhertz.cli.printing import bar, print_result
from nonhertz.files.changes import changes_in
from nonhertz.files.folder import refuse_unwritable
from nonhertz.files.held import as_toml
from nonhertz.files.planfile import read_design
from nonhertz.files.results import plain
from nonhertz.inputs.files import legible
from nonhertz.result.tables import csv_text
from nonhertz.show.studies import design_sections
from nonhertz.study.design import Design, best
from nonhertz.study.pictures import design_figures


def design(
    plan: Path,
    /,
    *,
    changes: Changes = (),
    starts: int | None = None,
    front: int | None = None,
    out: Path | None = None,
    workers: Workers = None,
    units: UnitsRead = "si",
    as_json: AsJson = False,
) -> None:
    """Find the profile or the dimensions with the least largest pressure, or the longest life.

    Parameters
    ----------
    plan : Path
        The plan file, with tables vary and design.
    starts : int
        Number of searches, each from another place; by default that of the plan, or 5.
    front : int
        In place of a goal, so many points of the Pareto front of the largest pressures under the loads without tilt and
        under those with tilt.
    out : Path
        Directory for case.toml (the case as it is best), profile.csv, design.json and the figures, or of a front for
        front.csv, front.json, a case file for each point and the figure; by default the file's name with '-design', in
        the current directory.
    """
    directory = Path(f"{legible(plan.stem)}-design") if out is None else out
    refuse_unwritable(directory)
    if front is not None:
        points = searched_front(plan, changes_in(changes), front, starts, workers)
        made = written_front(points, directory)
        text, title, shown = front_json(points, made), "", front_sections(points)
    else:
        case, given = read_design(plan, changes_in(changes))
        given |= {} if starts is None else {"starts": starts}
        with bar("searches") as update, named_as(threads="--workers", starts="--starts"):
            found = best(case, **given, workers=workers, announce=update)
        made = written(directory, lambda: _texts(found, directory), lambda: design_figures(found))
        text, title, shown = _as_json(found, made), found.was.title, design_sections(found)
    if as_json:
        print(text)
    else:
        print_result(title, shown, written=made)


def _texts(found: Design, out: Path) -> dict[str, str]:
    """Return the case as it is best, its profile and all numbers, by file name."""
    return {
        "case.toml": as_toml(found.case.document_in(out) | {"title": f"{found.was.title}, designed"}),
        "profile.csv": _profile(found),
        "design.json": _as_json(found, ()) + "\n",
    }


def _as_json(found: Design, files: Sequence[Path]) -> str:
    """Return a design as JSON text."""
    content: dict[str, Any] = {
        "title": found.was.title,
        "goal": found.goal,
        "values": found.values,
        "value": plain(found.value),
        "before": plain(found.before),
        "worst": found.worst,
        "agreeing_starts": found.agreeing,
        "starts": [
            vars(start) | {"value": plain(start.value), "history": plain(start.history)} for start in found.starts
        ],
        "bands": [vars(band) for band in found.bands],
        "loads": [vars(load) for load in found.loads],
        "files": [str(path) for path in files],
        "units": found.units | {"value": "MPa" if found.goal == "pressure" else ""},
    }
    return json.dumps(content, indent=2, allow_nan=False)


def _profile(found: Design) -> str:
    """Return the relief of both bodies together as CSV, as it is best and as it was."""
    rows = np.column_stack(found.relief).tolist()
    cells = ([f"{y:.9g}", *("" if math.isnan(each) else f"{each:.9f}" for each in rest)] for y, *rest in rows)
    return csv_text(["y [mm]", "relief [mm]", "relief before [mm]"], cells)
