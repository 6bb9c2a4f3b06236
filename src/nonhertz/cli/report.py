"""``nonhertz report``: one self-contained HTML file."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from nonhertz.cli.exit_codes import FINE, NOT_CONVERGED
from nonhertz.cli.options import NONE, Changes, UnitsRead, rename_fields
from nonhertz.cli.printing import Progress, print_written
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.files.casefile import Case
from nonhertz.files.folder import refuse_unwritable_file, write_files
from nonhertz.files.planfile import read_any
from nonhertz.files.title_block import TitleBlock
from nonhertz.inputs.files import is_special_file
from nonhertz.report import MARK, count_steps, post_process, solve_all, to_html
from nonhertz.report.results import make_all, require_one_kind

_REMEDY = "give the name of a file such as report.html"
_NEAR = 2000  # characters at the beginning of a report, including its mark


def report(
    case: Path,
    /,
    *more: Path,
    changes: Changes = NONE,
    out: Path | None = None,
    life: bool | None = None,
    stress: bool = True,
    compare: Annotated[bool, Parameter(negative="")] = False,
    project: Annotated[str, Parameter(show_default=False)] = "",
    author: Annotated[str, Parameter(show_default=False)] = "",
    date: Annotated[str, Parameter(show_default=False)] = "",
    no_date: Annotated[bool, Parameter(negative="")] = False,
    units: UnitsRead = "si",
) -> int:
    """Write an HTML report of cases or bearings that opens in any browser.

    It contains inputs, assumptions and whether they hold, results, figures, references and the files themselves, and
    loads nothing from elsewhere. Several cases, or several bearings, are compared with the first.

    Parameters
    ----------
    case : Path
        The case file, or the bearing file.
    more : tuple of Path
        More of them, to compare with it.
    out : Path
        The file to write; an older report is overwritten, any other file is not. By default the first case file's name
        with '-report.html', in the current directory.
    life : bool
        Whether to assess lives, which takes a few seconds per load; by default only for cases with a table life.
        Bearings are always rated unless --no-life.
    stress : bool
        For case files, search for the largest stresses below the surface.
    compare : bool
        For bearing files, compare strips with the slices of ISO/TS 16281.
    project : str
        Project in the head of the report; like the options below, it takes precedence over the first file's table
        report.
    author : str
        Author in the head of the report.
    date : str
        Date in the head of the report; by default that of the file, or else today's.
    no_date : bool
        Leave out today's date: the same files then give the same report to the last byte.
    """
    with rename_fields(project="--project", author="--author", date="--date"):
        block = TitleBlock(project=project, author=author, date=date)
    cases = (case, *more)
    path = _target(out, cases)
    with without_accuracy_warnings():  # the report shows them
        read = make_all(cases, lambda path: path, lambda path: read_any(path, changes))
    with rename_fields(cases="CASE"):
        first = require_one_kind(read)[0]
    if not no_date:
        block = block.over(first.title_block).dated()
    if compare and isinstance(first, Case):
        remedy = f"use 'nonhertz compare {first.path}' for strips beside the plane grid"
        raise InputError("--compare", str(first.path), "be used with bearing files", remedy)
    refuse_unwritable_file(path)
    with Progress(len(read)) as progress:
        studies = solve_all(read, progress.announce)
    with Progress(count_steps(studies, life=life, stress=stress) + 1) as progress:
        studies = post_process(studies, life=life, stress=stress, compare=compare, announce=progress.announce)
        progress.announce("figures")
        text = to_html(studies, block)
    print_written(write_files(path.parent, {path.name: text}))
    sys.stdout.flush()
    failed = [study for study in studies if study.complaint]
    for study in failed:
        print(f"{study.label}: {study.complaint}", file=sys.stderr)
    return NOT_CONVERGED if failed else FINE


def _target(out: Path | None, cases: Sequence[Path]) -> Path:
    """Return the file to write to, which must be new or an older report."""
    path = Path(f"{cases[0].stem}-report.html") if out is None else out
    if path.is_dir():
        raise InputError("--out", str(path), "be a file, not a directory", _REMEDY)
    if path.exists() and not _is_report(path):
        raise InputError("--out", str(path), "be a new file or an older nonhertz report", "choose another name")
    if out is not None and path.suffix.lower() not in {".html", ".htm"} and not is_special_file(path):
        raise InputError("--out", str(path), "end in .html", _REMEDY)
    return path


def _is_report(path: Path) -> bool:
    try:
        with path.open(encoding="utf-8") as file:
            return MARK in file.read(_NEAR)
    except (OSError, UnicodeDecodeError):
        return False
