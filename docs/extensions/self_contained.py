"""The site can be read without a network: no page, style sheet or script loads anything from elsewhere."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from sphinx.util import logging

if TYPE_CHECKING:
    from sphinx.application import Sphinx

# What a browser fetches by itself. Links, which a reader may follow, are none of it, nor are names of XML dialects.
ELSEWHERE = r"""["']?\s*((?:https?:)?//[^"'\s>)]*)"""
FETCHED = {
    ".html": (
        re.compile(r"<(?:script|img|iframe|source|video|audio|embed|object)\b[^>]*\b(?:src|srcset|data)=" + ELSEWHERE),
        re.compile(r"<link\b(?=[^>]*rel=.?(?:stylesheet|icon|preload|modulepreload))[^>]*\bhref=" + ELSEWHERE),
    ),
    ".css": (re.compile(r"(?:url\(|@import)\s*" + ELSEWHERE),),
}


def fetched_from_elsewhere(folder: Path) -> list[tuple[str, str]]:
    """Return files of a built site, and what they would load from elsewhere."""
    return [
        (path.relative_to(folder).as_posix(), address)
        for path in sorted(folder.rglob("*"))
        for pattern in FETCHED.get(path.suffix, ())
        for address in pattern.findall(path.read_text(encoding="utf-8"))
    ]


def check(app: Sphinx, error: Exception | None) -> None:
    """Warn of every file that would load something; with warnings as errors the build fails."""
    if error is None and app.builder.format == "html":
        for file, address in fetched_from_elsewhere(Path(app.outdir)):
            logging.getLogger(__name__).warning("%s loads %s", file, address)


def setup(app: Sphinx) -> dict[str, bool]:
    """Look at the site when it is built."""
    app.connect("build-finished", check)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
