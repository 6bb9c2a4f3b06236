"""What ``nonhertz materials`` prints."""

from __future__ import annotations

import json
from itertools import groupby

from rich.table import Table
from rich.text import Text

from nonhertz.cli.printing import console, print_table, words
from nonhertz.files.materials import as_object
from nonhertz.model.materials import LIBRARY, Listed, listed_as
from nonhertz.result.numerals import given
from nonhertz.result.reading import chosen

_COLUMNS = ("", "E [MPa]", "nu", "yield [MPa]", "core [MPa]", "hardness", "pressure limit [MPa]")
_SOURCES = "Where a number comes from, and what limits its use: nonhertz materials NAME"


def report_materials(name: str | None, as_json: bool) -> None:
    """Print the library, or one of its materials with source and note.

    Raises
    ------
    InputError
        If there is none of this name.
    """
    entries = LIBRARY if name is None else (listed_as(name),)
    if as_json:
        print(json.dumps(as_object(entries), indent=2, ensure_ascii=False))
        return
    printing = console()
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    heads, rows = chosen().columns(_COLUMNS, [_row(each) for each in entries])
    cells = dict(zip(entries, rows, strict=True))
    for position, column in enumerate(heads):
        table.add_column(Text(column), justify="right" if position else "left", no_wrap=True)
    for group, members in groupby(entries, key=lambda each: each.group):
        table.add_row(Text(group, style="bold"))
        for each in members:
            table.add_row(*map(Text, cells[each]))
    print_table(printing, table)
    lines = [_SOURCES] if name is None else [f"source: {entries[0].source}", f"note: {entries[0].note}"]
    for line in lines:
        if line != "note: ":
            printing.print(words(line), soft_wrap=True)


def _row(each: Listed) -> tuple[str, ...]:
    material = each.material
    strengths = (material.yield_strength, material.core_yield_strength)
    return (
        f"  {', '.join((each.name, *each.others))}",
        given(material.modulus),
        given(material.poisson),
        *("" if value is None else given(value) for value in strengths),
        material.hardness or "",
        "" if material.pressure_limit is None else given(material.pressure_limit),
    )
