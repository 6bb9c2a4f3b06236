"""Links from the documents to files of the repository that are no documents.

The documents are read on GitHub too, where a link to ``../../examples/README.md`` leads to that file. On the site the
page that shows the file takes its place. MyST makes downloads of all other files by itself.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from sphinx import addnodes

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx


def lead_to_pages(app: Sphinx, doctree: nodes.document) -> None:
    """Let links to files outside the documents lead to the pages that show them."""
    pages = {_bare(Path(app.srcdir, file)): page for file, page in app.config.pages_of_files.items()}
    for link in list(doctree.findall(addnodes.pending_xref)):
        # Files that could be documents, were they among them: MyST has taken their ending away.
        if link.get("refdomain") == "doc":
            link["reftarget"] = pages.get(os.path.normpath(link["reftarget"]), link["reftarget"])
    for link in list(doctree.findall(addnodes.download_reference)):
        folder = Path(app.srcdir, app.env.docname).parent
        page = pages.get(_bare(folder / link["reftarget"]))
        if page is not None:
            there = addnodes.pending_xref(
                "", *link.children, **(link.attributes | {"refdomain": "std", "reftype": "doc"})
            )
            there["reftarget"] = f"/{page}"
            link.replace_self(there)


def _bare(path: Path) -> str:
    return os.path.normpath(path.with_suffix(""))


def setup(app: Sphinx) -> dict[str, bool]:
    """Read the configuration's ``pages_of_files``: which page shows which file, both relative to the documents."""
    app.add_config_value("pages_of_files", {}, "env")
    app.connect("doctree-read", lead_to_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
