"""Files embedded in the page, as links that save them."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import NamedTuple

from nonhertz.files.bearing_results import comparison_files
from nonhertz.files.lives import as_object as lives_as_object
from nonhertz.files.resultfile import Result
from nonhertz.files.results import key_by_key
from nonhertz.files.stresses import as_object as stresses_as_object
from nonhertz.report.results import BearingResults, Results

_KINDS = {".toml": "application/toml", ".json": "application/json", ".csv": "text/csv"}

#: The contents of files, by their names; other files are not embedded.
_WORDS = {
    "result.json": "all numbers of the result",
    "table.csv": "the strips",
    "rollers.csv": "all rollers",
    "stress.json": "the largest stresses",
    "life.json": "the lives",
    **dict.fromkeys(("comparison.json", "comparison.csv"), "strips compared with slices"),
}


class Download(NamedTuple):
    """A file embedded in the page: the name it is saved under, its contents in words, and the file itself."""

    name: str
    what: str
    content: bytes

    @property
    def address(self) -> str:
        """The file as a ``data:`` URL."""
        kind = _KINDS.get(PurePosixPath(self.name).suffix.lower(), "application/octet-stream")
        return f"data:{kind};base64,{base64.b64encode(self.content).decode('ascii')}"


def collect_downloads(result: Results) -> list[Download]:
    """Return the case file or bearing file, the files that it names, and all results."""
    case = result.case
    what = f"{case.kind} file"
    files = [(case.file_name, f"the {what} as solved", case.text.encode())]
    for name, content in case.attachments.items():
        files.append((name, f"named in the {what}; save it at {name}, relative to it", content))
    stem = PurePosixPath(case.file_name).stem
    files += [(f"{stem}-{name}", _WORDS[name], text.encode()) for name, text in _result_texts(result) if name in _WORDS]
    return [Download(PurePosixPath(name.replace("\\", "/")).name, words, content) for name, words, content in files]


def _result_texts(result: Results) -> Iterator[tuple[str, str]]:
    """Yield names and texts of the files that commands write."""
    if result.solution is None:
        return
    if isinstance(result, BearingResults):
        yield from Result(result.case, result.solution, (result.life, result.reason)).texts().items()
        if result.slices is not None:
            yield from comparison_files(result.solution, result.slices, result.case.title).items()
        return
    yield from Result(result.case, result.solution).texts().items()
    if result.stress:
        written = stresses_as_object(result.solution, *result.stress, result.strengths[0], result.case.title)
        yield "stress.json", key_by_key(written) + "\n"
    if result.lives:
        yield "life.json", key_by_key(lives_as_object(result.lives)) + "\n"
