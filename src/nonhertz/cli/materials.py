"""What ``nonhertz materials`` prints."""

from __future__ import annotations

import json
from itertools import groupby

from nonhertz.amounts import given, mpa
from nonhertz.cli.printing import Printed
from nonhertz.files.materials import as_object
from nonhertz.model.materials import LIBRARY, Listed, listed_as
from nonhertz.show.sections import Table


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
    printing, (factor, unit) = Printed(), mpa().scale
    rows: list[tuple[str, ...]] = []
    for group, members in groupby(entries, key=lambda each: each.group):
        rows += [(group,), *(_row(each, factor) for each in members)]
    yielding, core, limit = (f"{what} [{unit}]" for what in ("yield", "core", "pressure limit"))
    printing.table(Table(rows, ("", f"E [{unit}]", "nu", yielding, core, "hardness", limit), (0,)))
    if name is None:
        printing.say("Where a number comes from, and what limits its use: nonhertz materials NAME")
    else:
        printing.say(
            *(f"{what}: {words}" for what, words in (("source", entries[0].source), ("note", entries[0].note)) if words)
        )


def _row(each: Listed, factor: float) -> tuple[str, ...]:
    """Return its cells; ``factor`` turns MPa into what people read."""
    material = each.material

    def stress(value: float | None) -> str:
        return "" if value is None else given(factor * value)

    return (
        f"  {', '.join((each.name, *each.others))}",
        stress(material.modulus),
        given(material.poisson),
        stress(material.yield_strength),
        stress(material.core_yield_strength),
        material.hardness or "",
        stress(material.pressure_limit),
    )
