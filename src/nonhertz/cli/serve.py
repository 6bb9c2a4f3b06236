"""What the page of ``nonhertz serve`` starts with."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from nonhertz.files.casefile import Case, starting_case
from nonhertz.files.held import meant_as, opened, parsed


class Start(NamedTuple):
    """What the page starts with.

    Attributes
    ----------
    document : dict
        A case, or a bearing.
    notes : tuple of str
        On the files that it named.
    text : str
        The text of its file, with the comments.
    """

    document: dict[str, Any]
    notes: tuple[str, ...] = ()
    text: str = ""


def starting_document(path: Path | None) -> Start:
    """Return what the page starts with.

    Parameters
    ----------
    path : Path or None
        A case file or a bearing file; None for the case that 'nonhertz new' writes.

    Raises
    ------
    CaseError
        If there are mistakes in the file, or it exceeds the limits of the page.
    """
    if path is None:
        text = starting_case()
        return Start(parsed(text, "case.toml"), (), text)
    from nonhertz.files.bearingfile import BearingCase
    from nonhertz.web.form.inlining import inlined, inlined_bearing
    from nonhertz.web.limits import slow, slow_bearing

    document, _, text = opened(path, "case", "bearing")
    bearing = meant_as(document) == "bearing"
    title = (BearingCase if bearing else Case).of(document, path).title
    changed, notes = (inlined_bearing if bearing else inlined)(document, path.parent)
    _refuse(changed, (slow_bearing if bearing else slow)(changed))
    return Start({"title": title} | changed, notes, text)


def _refuse(document: dict[str, Any], slow: list[Any]) -> None:
    from nonhertz.files.mistakes import case_error
    from nonhertz.web.limits import unfit

    too_much = unfit(document) + slow
    if too_much:
        raise case_error(too_much)
