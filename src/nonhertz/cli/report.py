"""What ``nonhertz report`` reads, composes and writes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonhertz.cli.verify import Progress
from nonhertz.errors import CaseError, InputError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.folder import write_files
from nonhertz.files.held import named
from nonhertz.files.planfile import read_any
from nonhertz.files.title_block import TitleBlock
from nonhertz.report import (
    MARK,
    BearingResults,
    CaseResults,
    examined,
    rendered,
    settled,
    settled_bearings,
    steps,
)

_REMEDY = "give the name of a file such as report.html"
_NEAR = 2000  # characters at the beginning of a report, which include its mark


def read_cases(paths: Sequence[Path], changes: Mapping[str, Any]) -> list[Case] | list[BearingCase]:
    """Return the cases in files, or the bearings in bearing files, with other values by path.

    Raises
    ------
    CaseError
        With every mistake in all of them; with several files each is prefixed by its path.
    InputError
        If some are case files and some bearing files.
    """
    cases = _read_all(paths, changes)
    contacts = [case for case in cases if isinstance(case, Case)]
    bearings = [case for case in cases if isinstance(case, BearingCase)]
    if contacts and bearings:
        both = f"{contacts[0].path} and {bearings[0].path}"
        remedy = "make a report of each kind, with 'nonhertz report' twice"
        raise InputError("CASE", both, "be all case files or all bearing files", remedy)
    return bearings or contacts


def _read_all(paths: Sequence[Path], changes: Mapping[str, Any]) -> list[Case | BearingCase]:
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
    cases: list[Case] | list[BearingCase], life: bool | None, stress: bool, compare: bool, block: TitleBlock
) -> tuple[str, list[str]]:
    """Return the report on cases or bearings as text, and a line for each that was not solved.

    Raises
    ------
    InputError
        If strips and slices are to be compared where there is no bearing.
    """
    bearings = [case for case in cases if isinstance(case, BearingCase)]
    contacts = [case for case in cases if isinstance(case, Case)]
    if contacts and compare:
        remedy = f"use 'nonhertz compare {contacts[0].path}' for strips beside the plane grid"
        raise InputError("--compare", str(contacts[0].path), "be used with bearing files", remedy)
    of_contacts = settled(contacts)
    progress = Progress((steps(of_contacts, life=life, stress=stress) if contacts else len(bearings)) + 1)
    found: Sequence[CaseResults] | Sequence[BearingResults]
    try:
        if bearings:
            found = settled_bearings(bearings, life=life, compare=compare, announce=progress.announce)
        else:
            found = examined(of_contacts, life=life, stress=stress, announce=progress.announce)
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
