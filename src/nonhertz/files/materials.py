"""The library of materials as plain numbers and text."""

from __future__ import annotations

from typing import Any, Final

from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, MapOf, input_keys
from nonhertz.model.material import Material
from nonhertz.model.materials import LIBRARY, Entry

#: Keys of the library as JSON; unknown values are null.
MATERIALS: Final = (
    Key(
        "materials", "the materials, by name", get="entries",
        holds=MapOf((
            Key("group", "what kind of material it is", holds="string"),
            Key("other_names", "other names of the same", get="others", holds=ListOf("string")),
            *input_keys(Material, "material."),
            Key("density", "density", "t/mm^3"),
            Key("expansion", "linear thermal expansion", "1/K"),
            Key("source", "source of each number", holds="string"),
            Key("note", "limits of use; empty if there are none", holds="string"),
        )),
    ),
    results.UNITS,
)  # fmt: skip


def as_object(entries: tuple[Entry, ...] = LIBRARY) -> dict[str, Any]:
    """Return entries of the library by name."""
    return results.document(MATERIALS, entries={entry.name: entry for entry in entries})
