"""Documents in requests and answers: out of JSON, into a script element, into the name of a file."""

from __future__ import annotations

import json
from typing import Any

from nonhertz.web.server.intake import RefusedError


def document_in(asked: dict[str, Any]) -> dict[str, Any]:
    """Return the document of a request.

    Raises
    ------
    RefusedError
        If it has none.
    """
    document = asked.get("document")
    if not isinstance(document, dict):
        raise RefusedError(400, "The request must have a document, structured like a case file.")
    return document


def in_script(value: Any) -> str:
    """Return JSON that is safe inside a script element: nothing in it can end the element."""
    text = json.dumps(value, allow_nan=False)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text


def as_attachment(name: str, document: dict[str, Any], suffix: str = "") -> dict[str, str]:
    """Return the header that makes a browser save a file, named after the ASCII letters and digits of the title."""
    title = str(document.get("title", ""))[:200].lower()
    words = "".join(c if c.isascii() and c.isalnum() else " " for c in title).split()
    stem, _, ending = name.partition(".")
    stem = "-".join(words)[:60].strip("-") or stem
    return {"Content-Disposition": f'attachment; filename="{stem}{suffix}.{ending}"'}
