"""What ``nonhertz design --front`` reads, shows and writes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.amounts import digits, mpa
from nonhertz.cli.options import named_as, written
from nonhertz.errors import InputError
from nonhertz.files.held import as_toml
from nonhertz.files.planfile import read_design
from nonhertz.result.tables import csv_text
from nonhertz.show.sections import Section, Table
from nonhertz.study.design import Front, front
from nonhertz.study.pictures import front_figure

GROUPS = ("without tilt", "with tilt")


def searched_front(
    plan: Path, changes: Mapping[str, Any], points: int, starts: int | None, workers: int | None
) -> Front:
    """Return the Pareto front of the loads of a plan without tilt and of those with tilt.

    ``changes`` are values in place of those in the file of its case, by path.

    Raises
    ------
    CaseError
        If the plan has mistakes.
    InputError
        If one of the groups is empty, the plan is for lives, or an option is refused.
    """
    case, given = read_design(plan, changes)
    loads = given.get("loads") or ()
    aligned = [each for each in loads if each.tilt == 0.0]
    tilted = [each for each in loads if each.tilt != 0.0]
    if not aligned or not tilted:
        condition, remedy = "hold loads without tilt and loads with tilt for a front", "give the design both"
        raise InputError("loads", f"{len(aligned)} without tilt and {len(tilted)} with", condition, remedy)
    if given.get("goal", "pressure") != "pressure":
        raise InputError("goal", given["goal"], "be 'pressure' for a front", "leave it out")
    with named_as(threads="--workers", starts="--starts", points="--front"):
        return front(
            case, first=aligned, second=tilted, vary=given.get("vary"), where=given.get("where"), points=points,
            starts=given.get("starts") if starts is None else starts, workers=workers,
        )  # fmt: skip


def written_front(found: Front, out: Path) -> tuple[Path, ...]:
    """Write the points as a table, as numbers and as case files, and the figure; return the files."""
    texts = {"front.csv": _table(found), "front.json": as_json(found, ()) + "\n"}
    for number, case in enumerate(found.cases, start=1):
        title = {"title": f"{case.title}, point {number} of a front"}
        texts[f"case-{number}.toml"] = as_toml(case.document_in(out) | title)
    groups = f"loads {GROUPS[0]}", f"loads {GROUPS[1]}"
    return written(out, lambda: texts, lambda: {"front": front_figure(found, groups)})


def as_json(found: Front, files: Sequence[Path]) -> str:
    """Return the points as JSON text."""
    points = [
        {"values": values, "max_pressure_without_tilt": first, "max_pressure_with_tilt": second}
        for values, first, second in zip(found.values, found.first, found.second, strict=True)
    ]
    content: dict[str, Any] = {"points": points, "units": found.units, "files": [str(path) for path in files]}
    return json.dumps(content, indent=2, allow_nan=False)


def front_sections(found: Front) -> list[Section]:
    """Return the points as people are shown them."""
    numbers = _numbers(found)
    pressures = [mpa(*group) for group in (found.first, found.second)]
    unit = pressures[0].scale[1]
    columns = [each.apart()[0] for each in pressures]
    columns += [[f"{digits(each)} {found.units.get(path, '')}".rstrip() for each in of] for path, of in numbers.items()]
    rows = [(str(number), *cells) for number, cells in enumerate(zip(*columns, strict=True), start=1)]
    heads = ("point", *(f"{unit} {group}" for group in GROUPS), *numbers)
    return [Section("", [Table(rows, heads)])]


def _numbers(found: Front) -> dict[str, list[float]]:
    """Return the values of each path that is a number; free profiles are in the case files."""
    paths = [path for path, value in found.values[0].items() if isinstance(value, float)]
    return {path: [values[path] for values in found.values] for path in paths}


def _table(found: Front) -> str:
    numbers = _numbers(found)
    named = [f"{path} [{found.units[path]}]" if found.units.get(path) else path for path in numbers]
    columns = zip(found.first, found.second, *numbers.values(), strict=True)
    rows = ([number, *(f"{value:.9g}" for value in row)] for number, row in enumerate(columns, start=1))
    return csv_text(["point", *(f"largest pressure {group} [MPa]" for group in GROUPS), *named], rows)
