"""What the page of ``nonhertz serve`` starts with."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from nonhertz.io.casefile import case_in, case_text, holds_bearing, parsed, starting_case


class Start(NamedTuple):
    """What the page starts with.

    Attributes
    ----------
    document : dict
        A case, or a bearing.
    notes : tuple of str
        On the files that it named.
    text : str
        The text of a bearing file; empty for a single contact.
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
        return Start(parsed(starting_case(), "case.toml"))
    from nonhertz.web.form.inlining import inlined
    from nonhertz.web.limits import slow

    text = case_text(path)
    document = parsed(text, str(path))
    if holds_bearing(document):
        return _starting_bearing(document, path, text)
    title = case_in(document, path).title
    document, notes = inlined(document, path.parent)
    _refuse(document, slow(document))
    return Start({"title": title} | document, notes)


def _starting_bearing(document: dict[str, Any], path: Path, text: str) -> Start:
    from nonhertz.io.bearingfile import bearing_in
    from nonhertz.io.casefile import as_toml
    from nonhertz.web.form.inlining import inlined_bearing
    from nonhertz.web.limits import slow_bearing

    title = bearing_in(document, path).title
    changed, notes = inlined_bearing(document, path.parent)
    _refuse(changed, slow_bearing(changed))
    if "title" in document and changed == document:
        return Start(document, (), text)
    changed = {"title": title} | changed
    return Start(changed, notes, as_toml(changed))


def _refuse(document: dict[str, Any], slow: list[Any]) -> None:
    from nonhertz.io.mistakes import case_error
    from nonhertz.web.limits import unfit

    too_much = unfit(document) + slow
    if too_much:
        raise case_error(too_much)
