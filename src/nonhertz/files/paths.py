"""Single values of a case file or a bearing file, named by dotted paths such as ``body.a.profile.drop``.

The paths follow from the fields of inputs and from the document: the kind of a profile decides which keys it can have.
In a list of several tables, such as a sum of profiles, the position is part of the path, ``body.a.profile[2].radius``;
it may be left out if only one of them can have the key.
"""

from __future__ import annotations

import difflib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, product
from typing import Any

from nonhertz.errors import InputError, UnknownKeyError, nearest
from nonhertz.files.keys import Key, Table, table_of
from nonhertz.files.mistakes import path_of
from nonhertz.inputs.descriptions import Description, Part, Several
from nonhertz.model.profile import PARAMETERS

Keys = tuple[str | int, ...]

#: Keys that define a table; unless they are a choice of words, they cannot be varied on their own.
_NAMES = ("kind", "format")


@dataclass(frozen=True)
class Parameter:
    """One value that a document has or could have.

    Attributes
    ----------
    path : str
        Its dotted path.
    keys : tuple of str and int
        The same in parts; positions in lists count from 1.
    unit : str or None
        Base unit of a number, ``""`` if it has none; None for a word, a switch or a whole profile.
    whole : bool
        Whether it must be a whole number.
    others : tuple of str
        Keys of the same table that it excludes.
    """

    path: str
    keys: Keys
    unit: str | None
    whole: bool = False
    others: tuple[str, ...] = ()

    def value_in(self, document: Mapping[str, Any]) -> Any:
        """Return the value in a document; None if it has none."""
        value: Any = document
        for key in self.keys:
            value = _entry(value, key)
        return value

    def put(self, document: Mapping[str, Any], value: Any) -> dict[str, Any]:
        """Return a document with another value; tables that are missing are made.

        The drop of a profile replaces the parameter that it determines; None removes the value.
        """
        if value is None:
            return self.removed(document)
        if self.keys[-1] == "drop":
            siblings = self._by_drop(document)
            if siblings and all(sibling.value_in(document) is not None for sibling in siblings):
                document = siblings[0].removed(document)
        changed: dict[str, Any] = _with(document, self.keys, value)
        return changed

    def drop_beside(self, document: Mapping[str, Any]) -> str:
        """Return the path of the drop that replaces this value in a document; empty if there is none."""
        others = [other for other in self._by_drop(document) if other.keys != self.keys]
        drop = self._beside("drop")
        determined = len(others) < len(self._by_drop(document)) and drop.value_in(document) is not None
        return drop.path if determined and all(other.value_in(document) is not None for other in others) else ""

    def replaced_in(self, document: Mapping[str, Any]) -> list[str]:
        """Return the paths of the values that replace this one in a document."""
        others = [other.path for other in map(self._beside, self.others) if other.value_in(document) is not None]
        return [*others, *filter(None, [self.drop_beside(document)])]

    def _beside(self, name: str) -> Parameter:
        return Parameter(f"{self.path.rpartition('.')[0]}.{name}", (*self.keys[:-1], name), None)

    def _by_drop(self, document: Mapping[str, Any]) -> list[Parameter]:
        """Return the parameters of a profile; its drop determines the first one that is not given."""
        kind = self._beside("kind").value_in(document)
        return [self._beside(name) for name in (PARAMETERS[kind].by_drop if kind in PARAMETERS else ())]

    def removed(self, document: Mapping[str, Any]) -> dict[str, Any]:
        """Return a document without the value; unchanged if it has none."""
        *place, last = self.keys
        table: Any = document
        for key in place:
            table = _entry(table, key)
        if not isinstance(table, Mapping) or last not in table:
            return dict(document)
        rest: dict[str, Any] = _with(document, tuple(place), {key: table[key] for key in table if key != last})
        return rest


def list_parameters(document: Mapping[str, Any], kind: Any) -> dict[str, Parameter]:
    """Return all parameters of a document, by path.

    Parameters
    ----------
    document : mapping
        Contents of a case file or a bearing file.
    kind : type
        The class of its contents, `CaseDocument` or `BearingFile`.
    """
    entries = [*_in_tables(document, (table_of(kind),), ())]
    ways = [(keys, entry) for entry in entries for keys in _without_positions(entry.keys)]
    count = Counter(keys for keys, _ in ways)
    known = {path_of(keys): entry for keys, entry in ways if keys == entry.keys or count[keys] == 1}
    known |= {
        f"{place}.profile": Parameter("", (*place.split("."), "profile"), None) for place, _ in body_tables(document)
    }
    return {path: replace(entry, path=path) for path, entry in known.items()}


def _without_positions(keys: Keys) -> Iterator[Keys]:
    """Yield keys without some of the positions in them, those with all of them last."""
    choices: list[tuple[Keys, ...]] = [((), (key,)) if isinstance(key, int) else ((key,),) for key in keys]
    for chosen in product(*choices):
        yield tuple(chain.from_iterable(chosen))


def body_tables(document: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield place and table of every body in the document of a case, of a contact or a bearing."""
    bodies = document.get("body", {})
    for name, table in bodies.items() if isinstance(bodies, Mapping) else ():
        yield f"body.{name}", table
    for name in ("roller", "inner", "outer"):
        if name in document:
            yield name, document[name]


def drop_before_parameters(values: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Return values by path, drops first: in this order none replaces another."""
    return sorted(values.items(), key=lambda item: not str(item[0]).endswith(".drop"))


def find_parameter(path: str, known: Mapping[str, Parameter]) -> Parameter:
    """Return the parameter of a path.

    Raises
    ------
    InputError
        If there is no such parameter; the nearest is named.
    """
    if not isinstance(path, str):
        raise InputError("path", path, "be a dotted path", "write it as in the file, such as 'load.load'")
    if path in known:
        return known[path]
    table, _, last = path.rpartition(".")
    whole = not any(known_path.startswith(f"{table}.") for known_path in known)
    if whole and table in known and known[table].unit is None:  # such as the name of a material
        remedy = f"'{table}' is one word in this file; set that to another, or to a table with '{last}' in it"
        raise InputError(path, path, "be an input of the file", remedy)
    owner = table.partition("[")[0]
    if last == "kind" and owner in known:
        raise InputError(path, path, "come with the keys of the kind", f"set '{owner}' to a table with all of them")
    # The right key in the wrong table is more likely than a misspelled table.
    key = nearest(last, {known_path.rpartition(".")[2]: known_path for known_path in known})
    alike = [known_path for known_path in known if known_path.rpartition(".")[2] == key]
    meant = difflib.get_close_matches(path, alike, n=1, cutoff=0.0)
    raise UnknownKeyError(path, path, "".join(meant), "write it as in the file, such as 'load.load'")


def _in_tables(value: Any, tables: Sequence[Table], keys: Keys) -> Iterator[Parameter]:
    """Yield all parameters of a value, which is one of these tables."""
    if any(table.kinds for table in tables):
        yield Parameter("", (*keys, "kind"), None)
    for name, key in dict(chain.from_iterable(table.keys.items() for table in tables)).items():
        leaf = None if key.several or name in _NAMES else _leaf(key.description)
        if leaf is not None:
            # Which parameter a drop determines depends on the kind of profile.
            pairs = [{*pair} for table in tables for pair in table.pairs if {name} < {*pair} - {"drop"}]
            others = tuple(set().union(*pairs) - {name})
            yield Parameter("", (*keys, name), *leaf, others)
        yield from _within(_entry(value, name), key, (*keys, name))


def _within(value: Any, key: Key, keys: Keys) -> Iterator[Parameter]:
    """Yield all parameters of the tables at a key."""
    if isinstance(value, list) and key.several:
        for position, entry in enumerate(value, start=1):
            if isinstance(entry, dict):
                yield from _in_tables(entry, _tables_of_kind(entry, key.tables), (*keys, position))
    elif (isinstance(value, dict) or value is None) and not isinstance(key.description, Several):
        yield from _in_tables(value, _tables_of_kind(value, key.tables), keys)


def _tables_of_kind(value: Any, tables: Sequence[Table]) -> Sequence[Table]:
    """Return those of several tables that a value may be, profiles by their kind."""
    kind = _entry(value, "kind")
    return [table for table in tables if not table.meaning_of_kind or table.kinds or table.word == kind]


def _leaf(description: Description) -> tuple[str | None, bool] | None:
    """Return unit and wholeness of a single value; None for a table or a list."""
    schema: dict[str, Any] = {} if isinstance(description, Part) and not description.named else description.schema()
    if "unit" in schema:
        return schema["unit"], False
    alternatives = schema.get("anyOf", [schema])
    kinds = {one.get("type") for one in alternatives}
    if "number" in kinds or "integer" in kinds:
        return "", "number" not in kinds
    is_word = kinds & {"string", "boolean"} or any("enum" in one for one in alternatives)
    return (None, False) if is_word else None


def _entry(value: Any, key: str | int) -> Any:
    if isinstance(key, int):
        return value[key - 1] if isinstance(value, list) and key <= len(value) else None
    return value.get(key) if isinstance(value, Mapping) else None


def _with(value: Any, keys: Keys, entry: Any) -> Any:
    if not keys:
        return entry
    key, *rest = keys
    inner = _with(_entry(value, key), tuple(rest), entry)
    if isinstance(key, int):
        return [*value[: key - 1], inner, *value[key:]]
    return {**(value or {}), key: inner}
