"""What ``nonhertz report`` reads, makes and writes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from nonhertz.cli.verification import Progress
from nonhertz.errors import CaseError, InputError
from nonhertz.io.casefile import named
from nonhertz.io.folder import write_files
from nonhertz.report import MARK, Finding, Subject, examined, read_subject, rendered, settled, steps

_REMEDY = "give the name of a file such as report.html"
_NEAR = 2000  # characters at the beginning of a report, among which its mark stands


def read_subjects(paths: Sequence[Path]) -> list[Subject]:
    """Return the subjects in case files.

    Raises
    ------
    CaseError
        With every mistake in all of them; of several files each has its path in front.
    """
    if len(paths) == 1:
        return [read_subject(paths[0])]
    subjects: list[Subject] = []
    mistakes: list[str] = []
    for path in paths:
        try:
            with named(path):
                subjects.append(read_subject(path))
        except CaseError as error:
            mistakes += error.mistakes
    if mistakes:
        raise CaseError(mistakes)
    return subjects


def target(out: Path | None, cases: Sequence[Path]) -> Path:
    """Return the file to write to: beside nothing but an older report, which is replaced.

    Raises
    ------
    InputError
        If there is something else in its place.
    """
    path = Path(f"{cases[0].stem}-report.html") if out is None else out
    if path.is_dir():
        raise InputError("--out", str(path), "be a file, not a directory", _REMEDY)
    if path.exists() and not _is_report(path):
        raise InputError("--out", str(path), "be a new file or a report of nonhertz to replace", "choose another name")
    return path


def made(subjects: Sequence[Subject], life: bool | None, stress: bool) -> tuple[str, tuple[Finding, ...]]:
    """Return the report on subjects as text and what it tells of."""
    found = settled(subjects)
    progress = Progress(steps(found, life=life, stress=stress) + 1)
    try:
        found = examined(found, life=life, stress=stress, announce=progress.announce)
        progress.announce("figures")
        return rendered(found), found
    finally:
        progress.wipe()


def write(path: Path, text: str) -> None:
    """Write a report, all of it or nothing.

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
