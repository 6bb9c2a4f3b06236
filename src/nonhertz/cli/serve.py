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
    from nonhertz.web.form.inlining import inlined
    from nonhertz.web.limits import refuse, too_slow, unfit

    document, _, text = opened(path, "case", "bearing")
    title = (BearingCase if meant_as(document) == "bearing" else Case).of(document, path).title
    changed, notes = inlined(document, path.parent)
    refuse(unfit(changed) + too_slow(changed))
    return Start({"title": title} | changed, notes, text)
