"""Solving cases for a command, and printing and writing the results."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonhertz.cli import BAD_INPUT, FINE, NOT_CONVERGED
from nonhertz.errors import CaseError, ConvergenceError

if TYPE_CHECKING:
    from nonhertz.files.casefile import Case
    from nonhertz.files.several import Attempt
    from nonhertz.result.solution import Solution
    from nonhertz.show.analysis import Spectrum

TABLE = "cases.csv"
TABLES = (".csv", ".xlsx")


def solved_or_not(case: Case) -> tuple[Solution, str]:
    """Return the solution and, if it has not converged, a message about that."""
    from nonhertz.show.analysis import attempted

    return attempted(case)


def spectrum_or_not(case: Case) -> tuple[Spectrum, str]:
    """Return the solutions for all loads with their shares, or a message why there are none."""
    from nonhertz.show.analysis import spectrum_solved

    try:
        return spectrum_solved(case), ""
    except ConvergenceError as error:
        return (), str(error)


def results_written(directory: Path, solution: Solution, case: Case) -> tuple[Path, ...]:
    """Write a solution with its figures, and return the files."""
    from nonhertz.files.folder import write_files
    from nonhertz.files.results import files
    from nonhertz.plot import figures, save

    def draw(folder: Path) -> None:
        for name, figure in figures(solution, case.title).items():
            save(figure, folder / name)

    return write_files(directory, files(solution, case), draw)


def report_one(path: Path, changes: Mapping[str, Any], out: Path | None, as_json: bool) -> int:
    """Solve a case, write and print the result; return the exit code."""
    from nonhertz.files.casefile import read_case
    from nonhertz.files.results import as_json as json_text

    case = read_case(path, changes)
    solution, complaint = solved_or_not(case)
    written = results_written(out, solution, case) if out is not None else ()
    if as_json:
        print(json_text(solution, case))
    else:
        from nonhertz.cli.summary import print_summary

        print_summary(solution, case.title, written)
    if complaint:
        sys.stdout.flush()
        print(complaint, file=sys.stderr)
    return NOT_CONVERGED if complaint else FINE


def report_several(paths: Sequence[Path], changes: Mapping[str, Any], out: Path | None, as_json: bool) -> int:
    """Solve cases one by one, write and print all results; return the exit code, the worst of all."""
    from nonhertz.files.folder import refuse_unwritable
    from nonhertz.files.several import objects
    from nonhertz.files.workbooks import refuse_missing_writer

    if out is not None:
        refuse_unwritable(out.parent if is_table(out) else out)
        if is_workbook(out):
            refuse_missing_writer()
    found = [attempt(path, changes) for path in paths]
    written = _several_written(out, found) if out is not None else ()
    if as_json:
        print(json.dumps(objects(found), allow_nan=False))
    else:
        from nonhertz.cli.printing import print_written
        from nonhertz.cli.summary import print_overview

        print_overview(found)
        print_written(written)
    sys.stdout.flush()
    for each in found:
        for sentence in each.complaints:
            print(sentence if sentence.startswith(each.name) else f"{each.name}: {sentence}", file=sys.stderr)
    if any(each.solution is None for each in found):
        return BAD_INPUT
    return NOT_CONVERGED if any(each.complaints for each in found) else FINE


def is_table(out: Path) -> bool:
    """Return whether ``--out`` is a file for the table of cases, rather than a directory."""
    return out.suffix.lower() in TABLES and not out.is_dir()


def is_workbook(out: Path) -> bool:
    """Return whether ``--out`` is a workbook."""
    return is_table(out) and out.suffix.lower() == ".xlsx"


def attempt(path: Path, changes: Mapping[str, Any]) -> Attempt:
    """Return a case that was solved, or why it was not."""
    from nonhertz.files.casefile import read_case
    from nonhertz.files.several import Attempt

    case = None
    try:
        case = read_case(path, changes)
        solution, complaint = solved_or_not(case)
    except CaseError as error:
        return Attempt(path, case, complaints=tuple(error.mistakes))
    return Attempt(path, case, solution, (complaint,) if complaint else ())


def _several_written(directory: Path, found: Sequence[Attempt]) -> tuple[Path, ...]:
    """Write each result into a folder of its own, and the table of all, or the table alone; return the files."""
    from nonhertz.files.folder import write_files
    from nonhertz.files.several import HEAD, folders, rows
    from nonhertz.files.workbooks import INPUTS, inputs_table, write_workbook
    from nonhertz.result.tables import csv_text

    if is_workbook(directory):
        inputs = ((each.name, each.case.document) for each in found if each.case is not None)
        sheets = {"cases": (HEAD, rows(found)), INPUTS: inputs_table(inputs)}
        return write_files(directory.parent, {}, lambda folder: write_workbook(folder / directory.name, sheets))
    if is_table(directory):
        return write_files(directory.parent, {directory.name: csv_text(HEAD, rows(found))})
    written: list[Path] = []
    for each, name in zip(found, folders(found), strict=True):
        if each.solution is not None and each.case is not None:
            written += results_written(directory / name, each.solution, each.case)
    return (*written, *write_files(directory, {TABLE: csv_text(HEAD, rows(found))}))
