"""The materials that have a name, in tables, from the library of the program."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING

from case_file_keys import list_table
from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

from nonhertz.amounts import format_input
from nonhertz.model.materials import LIBRARY, Entry

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

HEAD = (
    "name",
    "E [MPa]",
    "nu",
    "yield [MPa]",
    "core [MPa]",
    "hardness",
    "pressure limit [MPa]",
    "density [t/mm^3]",
    "expansion [1/K]",
    "source",
    "note",
)


class MaterialLibrary(SphinxDirective):
    """``.. material-library::``: a section for every group, with a row for every material."""

    def run(self) -> list[nodes.Node]:
        """Return the sections."""
        lines: list[str] = []
        for group, members in groupby(LIBRARY, key=lambda each: each.group):
            lines += [group.capitalize(), "-" * len(group), "", *list_table(HEAD, [_row(each) for each in members]), ""]
        source = StringList(lines, source=self.get_source_info()[0])
        return self.parse_text_to_nodes(source, allow_section_headings=True)


def _row(each: Entry) -> tuple[str, ...]:
    material = each.material
    numbers = (material.modulus, material.poisson, material.yield_strength, material.core_yield_strength)
    return (
        ", ".join(f"``{name}``" for name in (each.name, *each.others)),
        *("" if value is None else format_input(value) for value in numbers),
        material.hardness or "",
        "" if material.pressure_limit is None else format_input(material.pressure_limit),
        f"{each.density:.3g}",
        "" if each.expansion is None else f"{each.expansion:.3g}",
        each.source,
        each.note,
    )


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("material-library", MaterialLibrary)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
