"""``nonhertz materials``: the library."""

from __future__ import annotations

import json
from itertools import groupby

from nonhertz.amounts import amount, format_input, mpa
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import rename_fields
from nonhertz.files.materials import as_object
from nonhertz.model.materials import LIBRARY, Entry, find_entry
from nonhertz.show.sections import Notes, Section, Table


def materials(name: str | None = None, /) -> Answer:
    """List the materials that a file may name, and their strength.

    Parameters
    ----------
    name : str
        One material, with the sources of its numbers and the limits of their use; by default all are listed.
    """
    with rename_fields(name="NAME"):
        entries = LIBRARY if name is None else (find_entry(name),)
    factor, unit = mpa().scale
    rows: list[tuple[str, ...]] = []
    for group, members in groupby(entries, key=lambda entry: entry.group):
        rows += [(group,), *(_row(entry, factor) for entry in members)]
    yielding, core, limit = (f"{what} [{unit}]" for what in ("yield", "core", "pressure limit"))
    words = ["Sources of the numbers and limits of their use: nonhertz materials NAME"]
    if name is not None:
        density, expansion = entries[0].density, entries[0].expansion
        details = (
            ("density", f"{amount(density, 't/mm^3'):g}"),
            ("thermal expansion", "" if expansion is None else f"{expansion:.3g} 1/K"),
            ("source", entries[0].source),
            ("note", entries[0].note),
        )
        words = [f"{what}: {words}" for what, words in details if words]
    heads = ("", f"E [{unit}]", "nu", yielding, core, "hardness", limit)
    shown = [Section("", [Table(rows, heads, (0,)), Notes(words)])]
    return Answer("", shown, lambda: json.dumps(as_object(entries), indent=2, ensure_ascii=False))


def _row(entry: Entry, factor: float) -> tuple[str, ...]:
    """Return its cells; ``factor`` turns MPa into what people read."""
    material = entry.material

    def stress(value: float | None) -> str:
        return "" if value is None else format_input(factor * value)

    strengths = stress(material.yield_strength), stress(material.core_yield_strength), material.hardness or ""
    name = f"  {', '.join((entry.name, *entry.others))}"
    return name, stress(material.modulus), format_input(material.poisson), *strengths, stress(material.pressure_limit)
