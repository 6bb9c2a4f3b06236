"""What the page of ``nonhertz serve`` starts with."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nonhertz.io.casefile import case_in, case_text, parsed, starting_case


def starting_document(path: Path | None) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return the document that the page starts with, and notes on the files that it named.

    Parameters
    ----------
    path : Path or None
        A case file; None for the one that 'nonhertz new' writes.

    Raises
    ------
    CaseError
        If there are mistakes in the file, or it exceeds the limits of the page.
    """
    if path is None:
        return parsed(starting_case(), "case.toml"), ()
    from nonhertz.io.mistakes import case_error
    from nonhertz.web.form.inlining import inlined
    from nonhertz.web.limits import slow, unfit

    document = parsed(case_text(path), str(path))
    title = case_in(document, path).title
    document, notes = inlined(document, path.parent)
    too_much = unfit(document) + slow(document)
    if too_much:
        raise case_error(too_much)
    return {"title": title} | document, notes
