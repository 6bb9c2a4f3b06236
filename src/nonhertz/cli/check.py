"""``nonhertz check``: all mistakes in a file."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz import BearingCase, Case, CaseError, ConvergenceError, InputError, Plan
from nonhertz.amounts import format_input, mm, mpa
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import slice_loads
from nonhertz.cli.exit_codes import BAD_INPUT, FINE
from nonhertz.cli.options import DESIGN_NAMES, NONE, Changes, rename_fields
from nonhertz.cli.remedies import name_commands
from nonhertz.errors import join_words
from nonhertz.files.keys import unit_of
from nonhertz.files.planfile import DESIGN, parse_case_or_bearing, parse_design
from nonhertz.files.toml import is_plan, load_document
from nonhertz.files.writing import document_of
from nonhertz.hertz import line_contact
from nonhertz.inputs.fields import Input
from nonhertz.model.body import Body
from nonhertz.show.solving import try_solve
from nonhertz.study.design_task import check_design
from nonhertz.study.points import Points
from nonhertz.study.quantities import choose_quantities
from nonhertz.study.tolerances import check_limits

METAL = 40e3  # MPa, the modulus above which bodies are metals
BEYOND_METALS = 5000.0  # MPa
DEEP = 0.01  # of the diameter
# mm/min, the speed times the pitch diameter. Test rigs have turned bearings of 120 mm bore at 25,000 1/min (NASA TN
# D-7870, 1975), which is 3e6 by the bore.
FAST = 3e6


def check(file: Path, /, *more: Path, changes: Changes = NONE) -> int:
    """List all mistakes in case files, bearing files or plans.

    Parameters
    ----------
    file : Path
        The file.
    more : tuple of Path
        More files.
    """
    mistaken = [path for path in (file, *more) if not _is_fine(path, changes, named=bool(more))]
    return BAD_INPUT if mistaken else FINE


def _is_fine(path: Path, changes: Mapping[str, Any], *, named: bool) -> bool:
    """Print the mistakes in a file, below its name if ``named``, or its content; return whether there are none."""
    try:
        content = _describe_content(path, changes)
    except CaseError as error:
        if named:
            print(f"{path}:")
        for number, mistake in enumerate(error.mistakes, start=1):
            print(f"{number}. {name_commands(mistake)}")
        return False
    print(f"{path} is fine: {content}.")
    return True


def _describe_content(path: Path, changes: Mapping[str, Any]) -> str:
    """Read a case file, a bearing file or a plan, check that it can be solved, and return a description of it."""
    document, _, text = load_document(path, "case", "bearing", "plan")
    if is_plan(document):
        return _describe_plan(document, path, changes)
    case = parse_case_or_bearing(document, path, text, changes)
    return _describe_bearing(case) if isinstance(case, BearingCase) else _describe_contact(case)


def _describe_contact(case: Case) -> str:
    # Finds mistakes that only the solver can see, such as an unbounded contact. It takes milliseconds.
    solution, _ = try_solve(case)
    ends, pressed = mm(*case.contact.interval, between=" to "), _list_inputs(case.prescribed)
    content = f"{case.title!r}, bodies face each other from y = {ends:g}, {pressed}"
    bodies = {f"body {name}": body for name, body in case.contact.bodies.items()}
    return ".\ndoubtful: ".join((content, *_find_doubts(bodies, 0.0 if solution is None else solution.max_pressure)))


def _find_doubts(bodies: Mapping[str, Body], pressure: float) -> Iterator[str]:
    """Yield what is allowed but looks like a slip of units, in bodies and in their maximum pressure."""
    for name, body in bodies.items():
        half = 0.5 * np.asarray(body.interval)
        relief = float(np.max(body.relief(half))) if np.isfinite(half).all() else 0.0
        if isinstance(body.diameter, float) and DEEP * abs(body.diameter) < relief < math.inf:
            yield f"{name} drops by {relief:.3g} mm half-way to its end, over 1 % of its diameter"
    metals = all(body.material.modulus > METAL for body in bodies.values())
    if metals and pressure > BEYOND_METALS:
        yield f"no metal withstands the maximum pressure, {mpa(pressure)}; check load, tilt and units"


def _describe_bearing(case: BearingCase) -> str:
    # By slices, which takes milliseconds. Whether there is an equilibrium, only solving by strips shows.
    row, pressure = case.bearing.rows[0].bearing, 0.0
    with contextlib.suppress(ConvergenceError):
        pressure = _largest_of_slices(case.solve("slices"), case.solver.laminae)
    kind, count = case.document["bearing"]["kind"], sum(row.bearing.rollers for row in case.bearing.rows)
    content = f"{case.title!r}, a {kind} bearing of {count} rollers, {_list_inputs(case.prescribed) or 'no load'}"
    bodies = {"roller": row.roller, "inner ring": row.inner, "outer ring": row.outer}
    doubts, speed = [*_find_doubts(bodies, pressure)], case.prescribed.speed
    if speed * row.pitch > FAST:
        doubts.append(
            f"speed = {format_input(speed)} is in 1/min; no test rig has turned a bearing of this size so fast"
        )
    return ".\ndoubtful: ".join((content, *doubts))


def _largest_of_slices(solution: BearingSolution, laminae: int) -> float:
    """Return the Hertz pressure [MPa] under the most loaded of ``laminae`` slices; zero without load."""
    largest = 0.0
    for row, (slices, loads) in zip(solution.bearing.rows, slice_loads(solution, laminae), strict=True):
        for contact, most in zip(row.bearing.contacts, loads.max(axis=(0, 2)) / np.diff(slices.y[:2]), strict=True):
            if most > 0.0:
                radius = 1.0 / float(contact.curvature(0.0))
                hertz = line_contact(line_load=float(most), radius=radius, compliance=contact.compliance)
                largest = max(largest, hertz.max_pressure)
    return largest


def _describe_plan(document: dict[str, Any], path: Path, changes: Mapping[str, Any]) -> str:
    """Return a description of a plan; its case is read and its values are checked, nothing is solved."""
    studies = []
    for table, what in (("over", "a sweep"), ("tolerance", "a tolerance study")):
        plan = Plan.of(document, path, changes=changes, table=table)
        try:
            choose_quantities(plan.quantities, bearing=plan.template.is_bearing)
            check_limits(plan)
            if table in document:
                rows = f" of {len(Points.of(plan))} rows" if table == "over" else ""
                studies.append(f"{what}{rows} over {', '.join(plan.over)}")
        except InputError as error:
            raise CaseError([str(error)], [error.field]) from None
    if DESIGN in document:
        case, options = parse_design(document, path, changes=changes)
        try:
            with rename_fields(**DESIGN_NAMES):
                check_design(case, **options)
        except InputError as error:
            raise CaseError([str(error)], [error.field]) from None
        studies.append(f"a design over {', '.join(options['bounds'])}")
    return f"{plan.title!r}, {join_words(studies) if studies else 'nothing is varied'}"


def _list_inputs(prescribed: Input) -> str:
    """Return loads, displacements and speed as in files, with the units named in their descriptions."""
    entries = []
    for name, value in document_of(prescribed, defaults=False).items():
        numbers = value if isinstance(value, list) else [value]
        unit = unit_of(prescribed.descriptions[name])
        entries.append(f"{name} = {', '.join(f'{number:g}' for number in numbers)} {unit}")
    return ", ".join(entries)
