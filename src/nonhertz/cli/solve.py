"""``nonhertz solve``: one case, or several."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from itertools import chain
from operator import attrgetter
from pathlib import Path
from typing import Any

from nonhertz import CaseError, Result, read_case
from nonhertz.cli.answer import Answer
from nonhertz.cli.exit_codes import BAD_INPUT, FINE, NOT_CONVERGED
from nonhertz.cli.options import NONE, Changes, refuse_unwritable_out, save_result
from nonhertz.cli.remedies import name_commands
from nonhertz.files.folder import write_files
from nonhertz.files.several import HEAD, Attempt, name_folders, objects, rows
from nonhertz.files.workbooks import INPUTS, inputs_table, refuse_missing_writer, write_workbook
from nonhertz.result.tables import csv_text
from nonhertz.show.sections import Section
from nonhertz.show.solving import try_solve
from nonhertz.show.summary import overview_table, sections
from nonhertz.verdict import judge_contact, worst_verdict

TABLE = "cases.csv"
TABLES = (".csv", ".xlsx")


def solve(
    case: Path,
    /,
    *more: Path,
    changes: Changes = NONE,
    out: Path | None = None,
) -> Answer:
    """Solve one case and print a summary, or several and print a table.

    Parameters
    ----------
    case : Path
        The case file; see 'nonhertz new'.
    more : tuple of Path
        More case files. One that fails does not stop the others.
    out : Path
        Directory for result.json, table.csv and the figures; created if it does not exist. With several cases it has a
        folder for each, and the table of all, cases.csv. A name ending in .xlsx or .csv writes the table alone.
    """
    if more or _is_table(out):
        return _solve_several((case, *more), changes, out)
    read = read_case(case, changes)
    solution, complaint = try_solve(read)
    result = Result(read, solution)
    shown = sections(solution, read)
    return Answer(
        read.title, shown, result.to_json, judge_contact(solution), solution.warnings,
        save_result(result, out), [complaint] if complaint else [], NOT_CONVERGED if complaint else FINE, wide=None,
    )  # fmt: skip


def _solve_several(paths: Sequence[Path], changes: Mapping[str, Any], out: Path | None) -> Answer:
    """Solve cases one by one and write all results; the exit code is the worst of all."""
    is_table = _is_table(out)
    workbook = is_table and str(out).lower().endswith(".xlsx")
    refuse_unwritable_out(out, file=is_table)
    if workbook:
        refuse_missing_writer()
    attempts = [_attempt_case(path, changes) for path in paths]
    complaints = list(chain.from_iterable(attempt.sentences for attempt in attempts))
    return Answer(
        "", [Section("", [overview_table(attempts)])], lambda: json.dumps(objects(attempts), allow_nan=False),
        worst_verdict({f"in {attempt.name}": attempt.verdict for attempt in attempts}),
        list(chain.from_iterable(attempt.warnings for attempt in attempts)),
        () if out is None else _write_several(out, attempts, workbook),
        complaints,
        BAD_INPUT if None in map(attrgetter("solution"), attempts) else NOT_CONVERGED if complaints else FINE,
    )  # fmt: skip


def _is_table(out: Path | None) -> bool:
    """Return whether ``--out`` is a file for the table of cases, rather than a directory."""
    return out is not None and out.suffix.lower() in TABLES and not out.is_dir()


def _attempt_case(path: Path, changes: Mapping[str, Any]) -> Attempt:
    """Return a case that was solved, or why it was not."""
    case = None
    try:
        case = read_case(path, changes)
        solution, complaint = try_solve(case)
    except CaseError as error:
        return Attempt(path, case, complaints=tuple(map(name_commands, error.mistakes)))
    return Attempt(path, case, solution, (complaint,) if complaint else ())


def _write_several(out: Path, attempts: Sequence[Attempt], workbook: bool) -> tuple[Path, ...]:
    """Write each result into a folder of its own, and the table of all, or the table alone; return the files."""
    if workbook:
        inputs = ((attempt.name, attempt.case.document) for attempt in attempts if attempt.case is not None)
        sheets = {"cases": (HEAD, rows(attempts)), INPUTS: inputs_table(inputs)}
        return write_files(out.parent, {}, lambda folder: write_workbook(folder / out.name, sheets))
    table = csv_text(HEAD, rows(attempts))
    if _is_table(out):
        return write_files(out.parent, {out.name: table})
    made: list[Path] = []
    for attempt, name in zip(attempts, name_folders(attempts), strict=True):
        if attempt.solution is not None and attempt.case is not None:
            made += save_result(Result(attempt.case, attempt.solution), out / name)
    return (*made, *write_files(out, {TABLE: table}))
