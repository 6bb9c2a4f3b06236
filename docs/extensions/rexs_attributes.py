"""The attributes of REXS that are read and written, from the table of the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from case_file_keys import list_table
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from nonhertz.files.rexs.attributes import lines

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

HEAD = ("component", "attribute", "unit", "what it is here")
_USES = {
    "Both ways": ("exchange", "class", "load", "reaction", "speed", "profile", "word"),
    "Out alone": ("result", "contact"),
    "Neither way": ("left",),
}


class RexsAttributes(SphinxDirective):
    """``.. rexs-attributes::``: a section each for what goes both ways, out alone, and neither way."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        found: list[str] = []
        for title, uses in _USES.items():
            rows = [_row(each) for each in lines() if each["use"] in uses]
            found += [title, "-" * len(title), "", *list_table(HEAD, rows), ""]
        source = StringList(found, source=self.get_source_info()[0])
        return self.parse_text_to_nodes(source, allow_section_headings=True)


def _row(each: dict[str, str]) -> tuple[str, ...]:
    words = each["attribute"].split("|")
    names = ", ".join(f"``{word}``" if "_" in word or each["use"] != "left" else word for word in words)
    path = each["key"] or each["value"]
    here = each["kinds"] if each["use"] == "left" else f"``{path}``" if path else ""
    sign = ", with the other sign" if each["sign"] == "-1" else ""
    return each["component"], names, "" if each["unit"] == "none" else each["unit"], here + sign


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("rexs-attributes", RexsAttributes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
