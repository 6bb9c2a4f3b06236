"""The keys of the tables in files, from which forms, reports and the reference of files are made.

All of it comes from the fields of inputs, except where a bearing file is divided differently from the classes of a
bearing.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, field, replace
from functools import cache
from typing import Any, Final

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.pairs import Pair
from nonhertz.bearing.shapes import Deviations, Waves
from nonhertz.files.bearing_document import PAIR, PARTS, SHAPES
from nonhertz.files.profiles import KINDS, keys_of, meaning_of, needed_keys
from nonhertz.files.ring_shapes import ShapeFile
from nonhertz.inputs.descriptions import Description, Part, Several
from nonhertz.inputs.fields import Input, default_of
from nonhertz.model.profile import Profile

#: The usual order in a bearing file: the bearing before its parts, and a second row after all keys of the first.
_ORDER: Final = {"format": -3, "title": -2, "bearing": -1, "pair": 1}


#: Lengths that are shown in micrometres.
MICROMETRES: Final = frozenset(
    {
        *(
            "amplitude",
            "approach",
            "drop",
            "zm",
            "clearance",
            "axial_clearance",
            "interference",
            "smoothing",
            "roughness",
        ),
        *("radial_displacement", "axial_displacement"),
    }
)


@dataclass(frozen=True)
class Key:
    """A key of a table.

    Attributes
    ----------
    description : Description
        What it holds.
    usual : object
        Its default, `dataclasses.MISSING` if it must be given.
    tables : tuple of Table
        Tables that it may hold.
    several : bool
        Whether it may hold a list of them.
    """

    description: Description
    usual: Any = MISSING
    tables: tuple[Table, ...] = ()
    several: bool = False


@dataclass(frozen=True)
class Table:
    """A table of a file.

    Attributes
    ----------
    word : str
        Its kind if it has alternatives in the same place, else its meaning in a word.
    meaning : str
        What it holds.
    keys : mapping of str to Key
        By name; those of all kinds if it has kinds.
    kinds : mapping of str to Table
        By the word of its key ``kind``.
    meaning_of_kind : str
        What that word decides.
    pairs : tuple of pairs of str
        Pairs of keys of which one replaces the other, the usual one first.
    apart : tuple of tuples of str
        Groups of keys of which at most one is given.
    likely : callable or None
        The class of its object if it gives no kind.
    name : str
        The name of the class of its object, if it has one.
    """

    word: str
    meaning: str
    keys: Mapping[str, Key]
    kinds: Mapping[str, Table] = field(default_factory=dict)
    meaning_of_kind: str = ""
    pairs: tuple[tuple[str, str], ...] = ()
    apart: tuple[tuple[str, ...], ...] = ()
    likely: Callable[[Mapping[str, Any]], type[Input]] | None = None
    name: str = ""

    def of_kind(self, word: Any) -> Table:
        """Return the table of a kind; itself for an unknown kind."""
        return self.kinds.get(word, self) if isinstance(word, str) else self

    @property
    def required(self) -> list[str]:
        """Names of the keys that must be given."""
        return [name for name, key in self.keys.items() if key.usual is MISSING]


@cache
def table_of(cls: Any) -> Table:
    """Return the table of an input, by its class."""
    own = _table_of_kind(cls)
    kinds = {word: replace(_table_of_kind(kind), word=word) for word, kind in cls.kinds.items()}
    every = {name: key for table in (*kinds.values(), own) for name, key in table.keys.items()}
    # A key that one kind needs may be missing in others.
    every = {
        name: key if name in own.keys or key.usual is not MISSING else replace(key, usual=None)
        for name, key in sorted(every.items(), key=lambda item: _ORDER.get(item[0], 0))
    }
    return replace(own, keys=every, kinds=kinds, meaning_of_kind=cls.meaning_of_kind)


def _table_of_kind(cls: type[Input]) -> Table:
    """Return the table of an input of one kind."""
    usual = _list_defaults(cls)
    keys = {
        name: _describe_key(name, description, usual.get(name, MISSING), cls.inputs.get(name))
        for name, description in cls.descriptions.items()
    }
    if issubclass(cls, RollerBearing):
        # Its bodies are sections beside it in a file, and a second row is a table in it.
        keys = {name: key for name, key in keys.items() if name not in PARTS}
        keys["pair"] = Key(Part(PAIR, Pair, ""), None, (table_of(Pair),))
    order = [*keys].index
    pairs = tuple((min(pair, key=order), max(pair, key=order)) for pair in cls.instead.items())
    meaning = (cls.__doc__ or "").partition("\n")[0]
    return Table(cls.__name__, meaning, keys, pairs=pairs, apart=cls.apart, name=cls.__name__)


def _list_defaults(cls: type[Input]) -> dict[str, Any]:
    """Return the defaults of an input's fields."""
    usual = {field.name: default_of(field) for field in dataclasses.fields(cls)}  # type: ignore[arg-type]
    return {name: value for name, value in usual.items() if value is not MISSING}


def _describe_key(name: str, description: Description, usual: Any, inner: Any) -> Key:
    if getattr(description, "of", None) is Profile:
        return Key(description, None, profile_kinds(), several=True)
    if name in SHAPES:
        shapes = {"waves": Waves, "deviations": Deviations, "file": ShapeFile}
        tables = tuple(replace(table_of(cls), word=word) for word, cls in shapes.items())
        return Key(description, None, tables, several=True)
    if isinstance(description, Several) and description.of is not None:
        return Key(description, usual, (table_of(description.of),), several=True)
    likely = getattr(description, "likely", None)
    return Key(description, usual, () if inner is None else (replace(table_of(inner), likely=likely),))


def unit_of(description: Description) -> str:
    """Return the unit of the number or numbers of a field; empty if they have none, or if it has no numbers."""
    return str(getattr(getattr(description, "item", description), "unit", ""))


@cache
def profile_kinds() -> tuple[Table, ...]:
    """Return the tables of all kinds of profile."""
    return tuple(_profile_table(kind) for kind in KINDS)


def _profile_table(kind: str) -> Table:
    needed, usual = needed_keys(kind), _list_defaults(KINDS[kind])
    # The body provides what is not given.
    defaults = usual | dict.fromkeys(needed, MISSING)
    keys = {name: Key(description, defaults.get(name)) for name, description in keys_of(kind).items()}
    pairs = tuple((name, "drop") for name in needed if name in KINDS[kind].by_drop)
    apart = KINDS[kind].apart
    return Table(kind, meaning_of(kind), keys, meaning_of_kind="kind of profile", pairs=pairs[:1], apart=apart)
