"""Files embedded in the page, as links that save them."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from pathlib import PurePosixPath

from nonhertz.files.bearing_results import as_json as bearing_as_json
from nonhertz.files.bearing_results import as_object as bearing_as_object
from nonhertz.files.bearing_results import comparison_files, rollers_table
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.lives import as_json as lives_as_json
from nonhertz.files.results import as_json, as_table
from nonhertz.files.stresses import as_json as stresses_as_json
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.results import CaseResults

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
    size : int
        Its length [bytes].
    address : str
        The file itself, as a ``data:`` URL.
    """

    name: str
    what: str
    size: int
    address: str


def downloads(found: CaseResults) -> list[Download]:
    """Return the case file, the files that it names, and all results."""
    case, title = found.case, found.case.title
    files = given_files(case, "case file")
    stem = PurePosixPath(case.file_name).stem
    files.append(text_download(f"{stem}-table.csv", "the strips", as_table(found.solution)))
    files.append(
        text_download(f"{stem}-result.json", "all numbers of the solution", as_json(found.solution, case) + "\n")
    )
    if found.stress:
        text = stresses_as_json(found.solution, *found.stress, found.strengths[0], title)
        files.append(text_download(f"{stem}-stress.json", "the largest stresses", text + "\n"))
    if found.lives:
        files.append(text_download(f"{stem}-life.json", "the lives", lives_as_json(found.lives) + "\n"))
    return files


def bearing_downloads(found: BearingResults) -> list[Download]:
    """Return the bearing file, the files that it names, and all results."""
    case, solution = found.case, found.solution
    files = given_files(case, "bearing file")
    if solution is None:
        return files
    stem = PurePosixPath(case.file_name).stem
    text = bearing_as_json(bearing_as_object(solution, case, found.life, found.reason, found.strained)) + "\n"
    files.append(text_download(f"{stem}-rollers.csv", "all rollers", rollers_table(solution)))
    files.append(text_download(f"{stem}-result.json", "all numbers of the bearing", text))
    if found.slices is not None:
        for name, text in comparison_files(solution, found.slices, case.title).items():
            files.append(text_download(f"{stem}-{name}", "strips beside slices", text))
    return files


def given_files(case: Case | BearingCase, what: str) -> list[Download]:
    """Return the file of a case and the files that it names."""
    return [
        _download(case.file_name, f"the {what}, as it was solved", case.text.encode()),
        *(
            _download(name, f"named by the {what}; put it where {name} is from there", content)
            for name, content in case.attachments.items()
        ),
    ]


def left_out(case: Case | BearingCase) -> list[str]:
    """Return the files that a case names but the page does not include."""
    return [] if case.origin is None else [name for name in case.origin.files if name not in case.attachments]


def text_download(name: str, what: str, text: str) -> Download:
    """Return a text as a file."""
    return _download(name, what, text.encode())


def _download(name: str, what: str, content: bytes) -> Download:
    saved_as = PurePosixPath(name.replace("\\", "/")).name
    kind = _KINDS.get(PurePosixPath(saved_as).suffix.lower(), "application/octet-stream")
    address = f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"
    return Download(saved_as, what, len(content), address)
