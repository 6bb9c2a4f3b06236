"""``nonhertz design``: the best profile or dimensions."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz import Case, InputError
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import DESIGN_NAMES, NONE, Changes, Workers, default_output_path, rename_fields, write_outputs
from nonhertz.cli.printing import progress_bar
from nonhertz.files.folder import refuse_unwritable
from nonhertz.files.planfile import read_design
from nonhertz.files.studies import DESIGN, FRONT, as_text
from nonhertz.files.toml import to_toml
from nonhertz.plot.drawer import sheets_of
from nonhertz.result.tables import csv_text
from nonhertz.show.sections import assumed_section
from nonhertz.show.studies import design_sections, front_columns, front_sections
from nonhertz.study.design import Design, Front, optimize, pareto
from nonhertz.study.figures import design_figures, front_figures

#: The two groups of loads of a front.
GROUPS = ("without tilt", "with tilt")


def design(
    plan: Path,
    /,
    *,
    changes: Changes = NONE,
    starts: int | None = None,
    front: int | None = None,
    out: Path | None = None,
    workers: Workers = None,
) -> Answer:
    """Find the dimensions or the profile with the lowest peak pressure, or the longest life.

    Parameters
    ----------
    plan : Path
        The plan file, with tables vary and design.
    starts : int
        Number of searches, each from a different starting point; by default that of the plan, or 5.
    front : int
        Number of points on a Pareto front, found instead of one optimum: the maximum pressure under the loads with tilt
        against that under the loads without.
    out : Path
        Directory for case.toml (the optimised case), profile.csv, design.json and the figures, or with --front for
        front.csv, front.json, a case file for each point and the figure; by default the file's name with '-design', in
        the current directory.
    """
    directory = default_output_path(plan, "-design", out)
    refuse_unwritable(directory)
    case, options = read_design(plan, changes)
    options |= {} if starts is None else {"n_starts": starts}
    if front is not None:
        return _find_front(case, options, front, workers, directory)
    with progress_bar("searches") as update, rename_fields(**DESIGN_NAMES):
        best_design = optimize(case, **options, workers=workers, callback=update)
    title = best_design.was.title
    made = write_outputs(
        directory, lambda: _output_texts(best_design, directory), lambda: sheets_of(design_figures(best_design), title)
    )
    text = partial(as_text, DESIGN, made, design=best_design)
    shown = [*design_sections(best_design), assumed_section(case.assumed)]
    return Answer(title, shown, text, best_design.verdict, best_design.warnings, made)


def _output_texts(design: Design, out: Path) -> dict[str, str]:
    """Return the optimised case, the summed relief of both bodies after and before, and all numbers, by file name."""
    rows = np.column_stack(design.relief).tolist()
    cells = ([f"{y:.9g}", *("" if math.isnan(value) else f"{value:.9f}" for value in rest)] for y, *rest in rows)
    return {
        "case.toml": to_toml(design.case.document_in(out) | {"title": f"{design.was.title}, designed"}),
        "profile.csv": csv_text(["y [mm]", "relief [mm]", "relief before [mm]"], cells),
        "design.json": as_text(DESIGN, design=design) + "\n",
    }


# A front


def _find_front(case: Case, options: dict[str, Any], points: int, workers: int | None, out: Path) -> Answer:
    """Find the Pareto front between a plan's loads without tilt and those with tilt, and write it.

    Raises
    ------
    InputError
        If one of the groups is empty, the plan is for lives, or an option is refused.
    """
    loads = options.get("loads") or ()
    aligned = [load for load in loads if load.tilt == 0.0]
    tilted = [load for load in loads if load.tilt != 0.0]
    if not aligned or not tilted:
        condition, remedy = "include loads without tilt and loads with tilt for a front", "give the design both"
        raise InputError("loads", f"{len(aligned)} without tilt and {len(tilted)} with", condition, remedy)
    if options.get("goal", "pressure") != "pressure":
        raise InputError("goal", options["goal"], "be 'pressure' for a front", "leave it out")
    with rename_fields(**DESIGN_NAMES):
        front = pareto(
            case, first=aligned, second=tilted, bounds=options.get("bounds"), constraints=options.get("constraints"),
            points=points, n_starts=options.get("n_starts"), workers=workers,
        )  # fmt: skip
    as_json = partial(as_text, FRONT, front=front)
    texts = {"front.csv": _front_table(front), "front.json": as_json() + "\n"}
    for number, point_case in enumerate(front.cases, start=1):
        title = {"title": f"{point_case.title}, point {number} of a front"}
        texts[f"case-{number}.toml"] = to_toml(point_case.document_in(out) | title)
    groups = f"loads {GROUPS[0]}", f"loads {GROUPS[1]}"
    made = write_outputs(out, lambda: texts, lambda: sheets_of(front_figures(front, groups)))
    return Answer("", front_sections(front, GROUPS), partial(as_json, made), front.verdict, front.warnings, made)


def _front_table(front: Front) -> str:
    columns = front_columns(front, GROUPS)
    rows = enumerate(zip(*(values for values, _ in columns.values()), strict=True), start=1)
    head = ("point", *(f"{name} [{unit}]" if unit else name for name, (_, unit) in columns.items()))
    return csv_text(head, ([number, *(f"{value:.9g}" for value in row)] for number, row in rows))
