"""``nonhertz serve``: the page."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.starting import starting_case
from nonhertz.files.toml import file_kind, load_document, parse
from nonhertz.web.form.inlining import inline_files
from nonhertz.web.limits import refuse, too_slow, unfit
from nonhertz.web.server.serving import serve as serve_page


def serve(
    case: Path | None = None,
    /,
    *,
    port: int = 8765,
    browser: bool = True,
) -> None:
    """Open the page, on which a case or a bearing is solved as you change it.

    The page is served to this machine only, and no data leave it. Ctrl-C stops it.

    Parameters
    ----------
    case : Path
        The case file or bearing file to start with; by default the case that 'nonhertz new' writes. The page itself
        reads no files: a profile from a file is shown as its points.
    port : int
        Port on which the page is served; 0 for any free port.
    browser : bool
        Whether to open the page in a browser.
    """
    start = starting_document(case)
    for note in start.notes:
        print(note)

    def announce(address: str) -> None:
        print(f"The page is at {address} until you press Ctrl-C here.", flush=True)

    serve_page(start.document, port, browser=browser, announce=announce, text=start.text)


class Start(NamedTuple):
    """What the page starts with: a case or a bearing, notes on the files that it names, and the text of its file."""

    document: dict[str, Any]
    notes: tuple[str, ...] = ()
    text: str = ""


def starting_document(path: Path | None) -> Start:
    """Return what the page starts with: a case file or a bearing file; None for the case that 'nonhertz new' writes.

    Raises
    ------
    CaseError
        If there are mistakes in the file, or it exceeds the limits of the page.
    """
    if path is None:
        text = starting_case()
        return Start(parse(text, "case.toml"), (), text)
    document, _, text = load_document(path, "case", "bearing")
    case = (BearingCase if file_kind(document) == "bearing" else Case).of(document, path)
    changed, notes = inline_files(case)
    refuse(unfit(changed) + too_slow(changed))
    return Start({"title": case.title} | changed, notes, text)
