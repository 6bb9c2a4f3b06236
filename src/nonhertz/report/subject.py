"""What a report is about: a case, the text that it was read from, and the files that the text names."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from nonhertz.errors import AccuracyWarning
from nonhertz.inputs.files import legible
from nonhertz.io.casefile import Case, case_in, case_text, parsed
from nonhertz.io.profiles import profile_tables

MOST_ATTACHED = 10_000_000  # bytes of a file that a report carries


@dataclass(frozen=True, eq=False)
class Subject:
    """A case with what its reader needs to solve it again.

    Attributes
    ----------
    case : Case
        The case.
    text : str
        The text of its file.
    name : str
        What the file is called; it tells cases of one title apart.
    attachments : mapping of str to bytes
        Files that the case names, by the name that it uses.
    notes : tuple of str
        What was warned of when it was read, such as gaps in a measured profile.
    """

    case: Case
    text: str
    name: str = "case.toml"
    attachments: Mapping[str, bytes] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    @property
    def document(self) -> dict[str, Any]:
        """What the text holds."""
        return parsed(self.text, self.name)

    @property
    def files(self) -> tuple[str, ...]:
        """The names of files that the text names, each once."""
        return tuple(dict.fromkeys(_files_in(self.document)))


def read_subject(path: str | Path) -> Subject:
    """Return the subject in a case file, with the files that it names as far as they are not too large.

    Raises
    ------
    CaseError
        With every mistake in the file.
    """
    path = Path(path)
    text = case_text(path)
    with warnings.catch_warnings(record=True, action="always", category=AccuracyWarning) as caught:
        case = case_in(parsed(text, str(path)), path)
    notes = dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, AccuracyWarning))
    name = legible(path.name)
    named = Subject(case, text, name).files
    attachments = {
        name: file.read_bytes() for name in named if (file := path.parent / name).stat().st_size <= MOST_ATTACHED
    }
    return Subject(case, text, name, attachments, tuple(notes))


def labels(subjects: Sequence[Subject]) -> list[str]:
    """Return what to call each subject in tables and keys: its file's name, longer or numbered where two have one."""
    told = [Path(each.name).stem for each in subjects]
    if len(set(told)) < len(told):
        told = [legible(str(each.case.path.with_suffix(""))) for each in subjects]
    if len(set(told)) < len(told):
        told = [f"{name} ({number})" for number, name in enumerate(told, start=1)]
    return told


def _files_in(document: Mapping[str, Any]) -> Iterator[str]:
    for body in document.get("body", {}).values():
        for table in profile_tables(body):
            if isinstance(table.get("file"), str):
                yield table["file"]
