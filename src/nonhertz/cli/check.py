"""What ``nonhertz check`` reads and tries."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nonhertz.amounts import mm
from nonhertz.errors import CaseError, ConvergenceError, InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.held import holds_plan, opened
from nonhertz.files.planfile import DESIGN, Plan, case_or_bearing_in, design_in

_UNITS = {
    **dict.fromkeys(("load", "radial", "axial"), "N"),
    **dict.fromkeys(("approach", "radial_displacement", "axial_displacement"), "mm"),
    "tilt": "rad",
    "moment": "N mm",
    "speed": "1/min",
}


def checked(path: Path, changes: Mapping[str, Any]) -> str:
    """Read a case file, a bearing file or a plan, try whether it can be solved, and return what it holds in one line.

    Raises
    ------
    CaseError
        With every mistake in the file.
    """
    document, _, text = opened(path, "case", "bearing", "plan")
    if holds_plan(document):
        return f"{path} is fine: {_plan(document, path, changes)}."
    case = case_or_bearing_in(document, path, text, changes)
    return f"{path} is fine: {_bearing(case) if isinstance(case, BearingCase) else _contact(case)}."


def _contact(case: Case) -> str:
    from nonhertz.cli.solve import solved_or_not

    # Finds what only the solver can see, such as an unbounded contact. It takes milliseconds.
    solved_or_not(case)
    low, high = case.contact.interval
    return (
        f"{case.title!r}, bodies face each other from y = {mm(low, high, between=' to '):g}, {_listed(case.prescribed)}"
    )


def _bearing(case: BearingCase) -> str:
    # By slices, which takes milliseconds. Whether a balance is found is for solving it to say.
    with contextlib.suppress(ConvergenceError):
        case.solve("slices")
    kind, count = case.document["bearing"]["kind"], sum(row.bearing.rollers for row in case.bearing.rows)
    return f"{case.title!r}, a {kind} bearing of {count} rollers, {_listed(case.prescribed) or 'no load'}"


def _plan(document: dict[str, Any], path: Path, changes: Mapping[str, Any]) -> str:
    """Return what a plan holds; its case is read and its values are tried, nothing is solved."""
    from nonhertz.study.points import Points
    from nonhertz.study.quantities import chosen

    said = []
    for table, what in (("over", "a sweep"), ("tolerance", "a tolerance study")):
        plan = Plan.of(document, path, changes=changes, table=table)
        try:
            chosen(plan.quantities, bearing=plan.template.is_bearing)
            if table in document:
                rows = f" of {len(Points.of(plan))} rows" if table == "over" else ""
                said.append(f"{what}{rows} over {', '.join(plan.over)}")
        except InputError as error:
            raise CaseError([str(error)], [error.field]) from None
    if DESIGN in document:
        from nonhertz.study.design import checked as checked_design

        case, given = design_in(document, path, changes=changes)
        try:
            checked_design(case, **given)
        except InputError as error:
            raise CaseError([str(error)], [error.field]) from None
        said.append(f"a design over {', '.join(given['vary'])}")
    return f"{plan.title!r}, {' and '.join(said) or 'which varies nothing'}"


def _listed(prescribed: dict[str, Any]) -> str:
    found = []
    for name, value in prescribed.items():
        numbers = value if isinstance(value, tuple) else (value,)
        found.append(f"{name} = {', '.join(f'{each:g}' for each in numbers)} {_UNITS[name]}")
    return ", ".join(found)
