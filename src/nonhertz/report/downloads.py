"""Files embedded in the page, as links that save them."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePosixPath

from nonhertz.files.bearing_results import as_object as bearing_as_object
from nonhertz.files.bearing_results import comparison_files, rollers_table
from nonhertz.files.lives import as_object as lives_as_object
from nonhertz.files.results import as_object, as_table, key_by_key
from nonhertz.files.stresses import as_object as stresses_as_object
from nonhertz.report.results import BearingResults, CaseResults, Results

_KINDS = {".toml": "application/toml", ".json": "application/json", ".csv": "text/csv"}


@dataclass(frozen=True)
class Download:
    """A file embedded in the page.

    Attributes
    ----------
    name : str
        The name it is saved under.
    what : str
        What it holds, in words.
    content : bytes
        The file itself.
    """

    name: str
    what: str
    content: bytes

    @property
    def address(self) -> str:
        """The file as a ``data:`` URL."""
        kind = _KINDS.get(PurePosixPath(self.name).suffix.lower(), "application/octet-stream")
        return f"data:{kind};base64,{base64.b64encode(self.content).decode('ascii')}"


def downloads(found: Results) -> list[Download]:
    """Return the file of a case or a bearing, the files that it names, and all results."""
    case = found.case
    what = "bearing file" if isinstance(found, BearingResults) else "case file"
    named = (
        (name, f"named by the {what}; put it where {name} is from there", content)
        for name, content in case.attachments.items()
    )
    files = [(case.file_name, f"the {what}, as it was solved", case.text.encode()), *named]
    stem = PurePosixPath(case.file_name).stem
    texts = _of_bearing(found) if isinstance(found, BearingResults) else _of_contact(found)
    files += [(f"{stem}-{name}", words, text.encode()) for name, words, text in texts]
    return [Download(PurePosixPath(name.replace("\\", "/")).name, words, content) for name, words, content in files]


def _of_contact(found: CaseResults) -> Iterator[tuple[str, str, str]]:
    solution, case = found.solution, found.case
    yield "table.csv", "the strips", as_table(solution)
    yield "result.json", "all numbers of the solution", key_by_key(as_object(solution, case)) + "\n"
    if found.stress:
        text = key_by_key(stresses_as_object(solution, *found.stress, found.strengths[0], case.title))
        yield "stress.json", "the largest stresses", text + "\n"
    if found.lives:
        yield "life.json", "the lives", key_by_key(lives_as_object(found.lives)) + "\n"


def _of_bearing(found: BearingResults) -> Iterator[tuple[str, str, str]]:
    solution, case = found.solution, found.case
    if solution is None:
        return
    text = key_by_key(bearing_as_object(solution, case, found.life, found.reason, found.strained)) + "\n"
    yield "rollers.csv", "all rollers", rollers_table(solution)
    yield "result.json", "all numbers of the bearing", text
    if found.slices is not None:
        for name, text in comparison_files(solution, found.slices, case.title).items():
            yield name, "strips beside slices", text
