"""What ``nonhertz report`` reads, composes and writes."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path

from nonhertz.cli.verify import Progress
from nonhertz.errors import AccuracyWarning, CaseError, InputError
from nonhertz.io.casefile import Case, named, read_case
from nonhertz.io.folder import write_files
from nonhertz.report import MARK, CaseResults, examined, rendered, settled, steps

_REMEDY = "give the name of a file such as report.html"
_NEAR = 2000  # characters at the beginning of a report, which include its mark


def read_cases(paths: Sequence[Path]) -> list[Case]:
    """Return the cases in files.

    Raises
    ------
    CaseError
        With every mistake in all of them; with several files each is prefixed by its path.
    """
    if len(paths) == 1:
        return [_silently(paths[0])]
    cases: list[Case] = []
    mistakes: list[str] = []
    for path in paths:
        try:
            with named(path):
                cases.append(_silently(path))
        except CaseError as error:
            mistakes += error.mistakes
    if mistakes:
        raise CaseError(mistakes)
    return cases


def _silently(path: Path) -> Case:
    """Return a case without issuing warnings; the report shows them."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AccuracyWarning)
        return read_case(path)


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


def made(cases: Sequence[Case], life: bool | None, stress: bool) -> tuple[str, tuple[CaseResults, ...]]:
    """Return the report on cases as text, and the results in it."""
    found = settled(cases)
    progress = Progress(steps(found, life=life, stress=stress) + 1)
    try:
        found = examined(found, life=life, stress=stress, announce=progress.announce)
        progress.announce("figures")
        return rendered(found), found
    finally:
        progress.wipe()


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
