"""What ``nonhertz report`` reads, composes and writes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.cli.options import named_as
from nonhertz.cli.verify import Progress
from nonhertz.errors import CaseError, InputError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.folder import write_files
from nonhertz.files.held import named
from nonhertz.files.planfile import read_any
from nonhertz.files.title_block import TitleBlock
from nonhertz.report import MARK, examined, rendered, settled, steps
from nonhertz.report.results import of_one_kind

_REMEDY = "give the name of a file such as report.html"
_NEAR = 2000  # characters at the beginning of a report, which include its mark


def read_cases(paths: Sequence[Path], changes: Mapping[str, Any]) -> list[Case | BearingCase]:
    """Return the cases in files, or the bearings in bearing files, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in all of them; with several files each is prefixed by its path.
    """
    if len(paths) == 1:
        return [_silently(paths[0], changes)]
    cases: list[Case | BearingCase] = []
    mistakes: list[str] = []
    for path in paths:
        try:
            with named(path):
                cases.append(_silently(path, changes))
        except CaseError as error:
            mistakes += error.mistakes
    if mistakes:
        raise CaseError(mistakes)
    return cases


def _silently(path: Path, changes: Mapping[str, Any]) -> Case | BearingCase:
    """Return a case or a bearing without issuing warnings; the report shows them."""
    with without_accuracy_warnings():
        return read_any(path, changes)


def target(out: Path | None, cases: Sequence[Path]) -> Path:
    """Return the file to write to, which must be new or an older report.

    Raises
    ------
    InputError
        If something else already exists there.
    """
    path = Path(f"{cases[0].stem}-report.html") if out is None else out
    if path.is_dir():
        raise InputError("--out", str(path), "be a file, not a directory", _REMEDY)
    if path.exists() and not _is_report(path):
        raise InputError("--out", str(path), "be a new file or an older nonhertz report", "choose another name")
    return path


def title_block(**lines: str) -> TitleBlock:
    """Return what the options say of the head of a report.

    Raises
    ------
    InputError
        If a text is too long.
    """
    try:
        return TitleBlock(**lines)
    except InputError as error:
        raise InputError(f"--{error.field}", error.value, error.condition, error.remedy) from None


def composed(
    cases: Sequence[Case | BearingCase], life: bool | None, stress: bool, compare: bool, block: TitleBlock
) -> tuple[str, list[str]]:
    """Return the report on cases or bearings as text, and a line for each that was not solved.

    Raises
    ------
    InputError
        If there are cases of both kinds, or strips and slices are to be compared where there is no bearing.
    """
    with named_as(cases="CASE"):
        first = of_one_kind(cases)[0]
    if compare and isinstance(first, Case):
        remedy = f"use 'nonhertz compare {first.path}' for strips beside the plane grid"
        raise InputError("--compare", str(first.path), "be used with bearing files", remedy)
    found = settled(cases)
    progress = Progress(steps(found, life=life, stress=stress) + 1)
    try:
        found = examined(found, life=life, stress=stress, compare=compare, announce=progress.announce)
        progress.announce("figures")
        text = rendered(found, block)
    finally:
        progress.wipe()
    return text, [f"{each.label}: {each.complaint}" for each in found if each.complaint]


def write(path: Path, text: str) -> None:
    """Write a report atomically.

    Raises
    ------
    InputError
        If its directory cannot be written to.
    """
    write_files(path.parent, {path.name: text})


def _is_report(path: Path) -> bool:
    try:
        with path.open(encoding="utf-8") as file:
            return MARK in file.read(_NEAR)
    except (OSError, UnicodeDecodeError):
        return False
