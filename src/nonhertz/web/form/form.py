"""The form of a document: fields and groups, made from what the fields of a file's inputs say.

No key of a file is repeated here. What describes a key decides which field it gets, so a field added to an input, or a
kind of profile, appears in the form at once. An invalid value that its field cannot hold is shown as JSON, and so is an
unknown key: the form shows the whole document, which can be rebuilt from it.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, replace
from functools import cache
from typing import Any, Final, Literal

from nonhertz.errors import InputError
from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.bearingfile import BEARING_TEMPLATES, starting_bearing
from nonhertz.files.bounds import FORMAT
from nonhertz.files.documents import parsed
from nonhertz.files.keys import Key, Table, table_of
from nonhertz.files.mistakes import Place, path_of
from nonhertz.files.profiles import profile_tables
from nonhertz.files.reading import read
from nonhertz.files.sections import CaseDocument
from nonhertz.inputs.fields import Count, Flag, OneOrTwo, Part, Quantities, Word, text_of
from nonhertz.model.body import Body
from nonhertz.web.form.fields import Edits, FormField, FormGroup, Option, text_in
from nonhertz.web.form.inputs import ABSENT, input_for, label_of, stray
from nonhertz.web.form.ranges import ENDS, ONE, Range, of_body, ranges_of, size_of

#: Keys that all kinds of profile have, kept when the kind is changed.
COMMON: Final = ("shift", "scale", "flip")
#: Keys that most files leave at their defaults, folded away.
FOLDED: Final = (
    *("effective_length", "corner_radius", "chamfer", "position", "side_faces", "images", "depth", "bore"),
    *("case_depth", "yield_strength", "core_yield_strength", "hardness", "pressure_limit"),
    *("drop", "at", *COMMON),
    *("pitch_diameter", "inner_shape", "outer_shape", "density", "rib", "axial_clearance", "pair", "fit"),
    *("solver", "life", "report"),
)
#: Keys that are a number in the form, unless a file has a table in their place.
MOSTLY_NUMBERS: Final = ("bore",)
#: Parts of a bearing whose diameter is that of a raceway, one number.
RINGS: Final = ("inner", "outer")
#: Files are dropped or pasted: the page reads none by name.
UNREAD: Final = "file"
#: The most frequently changed keys come first; the rest in the order of their class.
FIRST: Final = ("title", "kind", "load", "body", "bearing", "diameter", "length", "profile", "material")
#: Keys that a table has only beside another, or only without it.
_ONLY_BESIDE: Final = {"at": "drop", "chamfer": "length"}
_ONLY_WITHOUT: Final = {"dent": "spectrum"}
#: Of a bearing file, what another kind of bearing leaves as it is.
_OF_ALL_BEARINGS: Final = ("format", "solver", "report")
_NOTICEABLE: Final = 0.1  # of the length of a body, by which a slider moves a profile
#: What a kind of body needs; a diameter if it is not listed.
_NEEDED: Final = {"roller": ("diameter", "length"), "plate": ()}


def form(document: dict[str, Any], file: Literal["case", "bearing"] = "case") -> FormGroup:
    """Return the form of a document, valid or not, of a case file or a bearing file; without one for its format."""
    whole = table_of(CaseDocument if file == "case" else BearingFile)
    asked = {name: key for name, key in whole.keys.items() if name != "format"}
    given = {name: value for name, value in document.items() if name != "format" or value != FORMAT}
    return _Maker(ranges_of(document, file), document.get("bearing")).group(
        replace(whole, keys=asked), given, (), "Case"
    )


class _Maker:
    """Makes the parts of a form, whose sliders have these ranges."""

    def __init__(self, ranges: Mapping[str, Range | None], bearing: Any = None) -> None:
        self.ranges = ranges
        #: Whether the rings are washers, flat and without seats that would press on a raceway.
        self.washers = isinstance(bearing, dict) and bearing.get("kind") == "thrust"
        #: What the profile of the body says of its size, in place of the usual start.
        self.sizes: Mapping[str, float] = {}

    def group(
        self,
        table: Table,
        given: dict[str, Any],
        place: Place,
        legend: str,
        *,
        there: bool = True,
        others: tuple[Table, ...] = (),
    ) -> FormGroup:
        """Return the form of a table, with unknown keys as JSON.

        Parameters
        ----------
        table, given, place, legend
            What it may hold and what it holds, where it is and what it is called.
        there : bool
            Whether the document has the table.
        others : tuple of Table
            Those of other kinds that may stand in its place.
        """
        named = table.of_kind(given.get("kind"))
        keys, ranges = named.keys, self.ranges
        if "profile" in keys:
            self.sizes = _sizes(given, named)
            self.ranges = {**ranges, **of_body(given), **({} if _can_be_moved(given, named) else {"shift": None})}
        if {"load", "radius"} <= set(keys):
            # The radius of a profile for a design load is the one across the contact.
            self.ranges = {**ranges, "radius": ranges["across.radius"]}
        members: list[FormField | FormGroup] = [*self._kinds(table, given, place, others)]
        known = {*keys, *("kind" for _ in members)}
        members += self._switches(named, given, place)
        folded: list[FormField | FormGroup] = []
        shown = set(keys) - _unchosen(named, given)
        if self.washers and (not place or place[0] in RINGS):
            shown -= {"fit", "diameter"} - set(given)
        for name in sorted(shown, key=[*FIRST, *keys].index):
            entry = self._member(keys[name], given.get(name, ABSENT), (*place, name), given, named)
            unfolded = keys[name].usual is MISSING or any(name in pair for pair in named.pairs)
            (members if unfolded or name not in FOLDED else folded).append(entry)
        members += [stray(entry, (*place, name)) for name, entry in given.items() if name not in known]
        self.ranges = ranges
        base = "{}" if there and place else ""
        return FormGroup(path_of(place), legend, tuple(members), named.meaning, tuple(folded), base)

    def _member(
        self, key: Key, value: Any, place: Place, given: dict[str, Any], within: Table
    ) -> FormField | FormGroup:
        """Return the form of one key of a table."""
        each, name = key.each, str(place[-1])
        if isinstance(each, OneOrTwo):
            alone = name == "side_faces" and "length" not in given
            return self._one_or_two(key, each, value, place, alone=alone)
        if key.several:
            return self._list(key, value, place)
        plain = isinstance(each, Part) and not each.named
        if key.tables and (plain or (name in MOSTLY_NUMBERS and isinstance(value, dict))):
            return self._table(key, value, place)
        alone = name in MOSTLY_NUMBERS or (name == "diameter" and place[0] in RINGS and not isinstance(value, dict))
        if key.tables and not alone:
            return self._value_or_table(key, value, place)
        made = input_for(key, value, place, self._range(place))
        return replace(made, default=_usual_depth(given, within)) if name == "depth" else made

    def _table(self, key: Key, value: Any, place: Place) -> FormGroup | FormField:
        """Return the form of a table; one that needs some of its keys is given as a whole, or left out by a choice."""
        path, legend, table = path_of(place), label_of(place), replace(key.tables[0], meaning=text_of(key.each))
        there, optional = value is not ABSENT, key.usual is not MISSING
        held = value if there else {}
        if not isinstance(held, dict):
            return replace(stray(value, place), help=table.meaning)
        made = replace(self.group(table, held, place, legend, there=there), optional=optional)
        if not optional or not table.required:
            return made
        choices: dict[str, Edits] = {"none": [(path, None)], "given": [(path, self._new(table, legend))]}
        shape = _switch(path, legend, "given" if there else "none", choices)
        return replace(made, members=(shape, *made.members)) if there else shape

    def _kinds(
        self, table: Table, given: dict[str, Any], place: Place, others: tuple[Table, ...]
    ) -> Iterator[FormField]:
        """Yield the choice of the kind of a table, on which its other keys depend; nothing if it has none."""
        if not table.meaning_of_kind:
            return
        if table.kinds:
            now, kinds = table.of_kind(given.get("kind")), table.kinds
            options = tuple(Option(word, word, self._changed(now, kind, given, place)) for word, kind in kinds.items())
        else:
            options = tuple(
                Option(each.word, each.word, [(path_of(place), self._new(each, before=given))])
                for each in _of_numbers(others)
            )
        value = given.get("kind", ABSENT)
        text = "" if value is ABSENT else text_in("choice", value)
        path = path_of((*place, "kind"))
        if text is None:
            yield FormField(path, "kind", "json", json.dumps(value), table.meaning_of_kind)
            return
        if text and text not in [option.value for option in options]:
            options = (*options, Option(text, text))
        yield FormField(path, "kind", "choice", text, table.meaning_of_kind, options=options, structural=True)

    def _changed(self, now: Table, kind: Table, given: dict[str, Any], place: Place) -> Edits:
        """Return the edits that make a table one of another kind: what that needs is added, what it lacks removed.

        Of a bearing whose parts are others, little could stay: these make an example of one.
        """
        if place == ("bearing",) and kind.keys.keys() != now.keys.keys():
            return _examples()[kind.word]
        needed = _NEEDED.get(kind.word, ("diameter",)) if "diameter" in kind.keys else kind.required
        foreign = [name for name in given if name not in kind.keys and name != "kind"]
        foreign += ["diameter"] if kind.word == "plate" else []
        edits: Edits = [(path_of((*place, "kind")), kind.word)]
        edits += [(path_of((*place, name)), None) for name in foreign]
        return edits + [
            (path_of((*place, name)), self._start(name, kind.keys[name])) for name in needed if name not in given
        ]

    def _new(self, table: Table, within: str = "", before: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """Return a table with all that must be given, and with what all profiles may have of the previous one."""
        within = "across" if "load" in table.keys else within
        # Lists have to be given, unless a file replaces them.
        found = {
            name: self._start(name, key, within)
            for name, key in table.keys.items()
            if key.usual is MISSING or (table.meaning_of_kind and isinstance(key.each, Quantities))
        }
        kept = {name: value for name, value in (before or {}).items() if name in COMMON and table.meaning_of_kind}
        return ({"kind": table.word} if table.meaning_of_kind else {}) | found | kept

    def _start(self, name: str, key: Key, within: str = "") -> Any:
        """Return the value of a key when it is added to a table."""
        each = key.each
        if key.tables and (key.several or isinstance(each, Part)):
            return [self._new(key.tables[0])] if key.several else self._new(key.tables[0], name)
        if isinstance(each, Quantities):
            return list(ENDS.get(name, ENDS["y"]))
        if isinstance(each, Word):
            return each.words[0] if each.words else ""
        if isinstance(each, Flag):
            return False
        if isinstance(each, Count):
            return max(each.least, 1)
        return (self._range((within, name)) or ONE).start

    def _list(self, key: Key, value: Any, place: Place) -> FormGroup | FormField:
        """Return the form of a list of tables, or of a single table in place of a list of one."""
        if isinstance(value, dict):
            return self._entry(key.tables, value, place)
        if value is not ABSENT and not isinstance(value, list):
            return replace(stray(value, place), help=text_of(key.each))
        entries = value if isinstance(value, list) else []
        members = tuple(self._entry(key.tables, entry, (*place, number)) for number, entry in enumerate(entries, 1))
        base = "" if value is ABSENT else "[]"
        words = "row" if len(key.tables) == 1 else ""
        added = tuple(
            Option(words or each.word, words or each.word, [("", self._new(each))]) for each in _of_numbers(key.tables)
        )
        return FormGroup(path_of(place), label_of(place), members, text_of(key.each), (), base, additions=added)

    def _entry(self, tables: tuple[Table, ...], entry: Any, place: Place) -> FormGroup | FormField:
        if not isinstance(entry, dict):
            return stray(entry, place)
        table, legend = tables[0], label_of(place)
        if table.meaning_of_kind:
            kind = entry.get("kind")
            # Of an unknown kind the keys are unknown, too.
            unknown = replace(table, word="", meaning="", keys={}, pairs=())
            table = next((each for each in tables if each.word == kind), unknown)
            legend += f": {kind}" if isinstance(kind, str) else ""
        else:
            table = max(tables, key=lambda each: len(set(each.keys) & set(entry)))
        made = self.group(table, entry, place, legend, others=tables)
        return replace(made, removable=isinstance(place[-1], int))

    def _value_or_table(self, key: Key, value: Any, place: Place) -> FormGroup:
        """Return the form of a key that may hold one value or a table of several."""
        name, path, table = str(place[-1]), path_of(place), key.tables[0]
        tabular = isinstance(value, dict)
        simple = next(iter(key.each.named)) if isinstance(key.each, Part) else self._start(name, key)
        several = {each: self._start(each, table.keys[each]) for each in table.required}
        if isinstance(value, dict) and isinstance(value.get(name), list) and value[name]:
            simple = value[name][len(value[name]) // 2]
        elif name in several and value is not ABSENT:
            several[name] = [value] * len(several[name])
        words = "name" if isinstance(simple, str) else "one number", " and ".join(several)
        choices: dict[str, Edits] = {words[0]: [(path, simple)], words[1]: [(path, several)]}
        shape = _switch(path, f"{label_of(place)} by", words[tabular], choices)
        if tabular:
            inner = self.group(replace(table, meaning=text_of(key.each)), value, place, label_of(place))
            return replace(inner, members=(shape, *inner.members))
        return FormGroup(path, label_of(place), (shape, input_for(key, value, place, self._range(place))))

    def _one_or_two(self, key: Key, each: OneOrTwo, value: Any, place: Place, *, alone: bool) -> FormGroup | FormField:
        """Return the form of a key with one value, or one for each of two; ``alone`` if two make no sense."""
        path, found = path_of(place), self._range(place)
        single = replace(key, each=each.each)
        is_pair = isinstance(value, list) and len(value) == 2
        made = replace(input_for(single, ABSENT if is_pair else value, place, found), help=text_of(each))
        if not is_pair and alone:
            return made
        first = value[each.single or 0] if is_pair else (key.usual or 0.0) if value is ABSENT else value
        both = [first if each.single in (None, number) else 0.0 for number in range(2)]
        words = (
            ("one for both ends", "one for each end")
            if each.single is None
            else (each.names[each.single], " and ".join(each.names))
        )
        choices: dict[str, Edits] = {words[0]: [(path, first)], words[1]: [(path, value if is_pair else both)]}
        shape = _switch(path, "given", words[is_pair], choices)
        if not is_pair:
            return FormGroup(path, label_of(place), (shape, made))
        found = found and replace(found, low=-found.high)
        members = tuple(
            replace(input_for(single, entry, (*place, number), found), label=label, help=text_of(each))
            for number, (label, entry) in enumerate(zip(each.names, value, strict=True), start=1)
        )
        return FormGroup(path, label_of(place), (shape, *members), base="[]")

    def _range(self, place: Place) -> Range | None:
        """Return the range of the slider at a place, if there is one."""
        last = str(place[-1])
        return self.ranges.get(".".join(map(str, place[-2:])), self.ranges.get(last))

    def _switches(self, table: Table, given: dict[str, Any], place: Place) -> Iterator[FormField]:
        """Yield a choice for each pair of alternative keys."""
        for pair in table.pairs:
            paths = {name: path_of((*place, name)) for name in pair}
            sizes = self.sizes if "drop" in pair else {}
            starts = {name: sizes.get(name, self._start(name, table.keys[name])) for name in pair}
            choices: dict[str, Edits] = {
                name.replace("_", " "): [
                    (paths[name], starts[name]),
                    *((paths[each], None) for each in pair if each != name),
                ]
                for name in pair
            }
            chosen = next((name for name in pair if name in given), pair[0]).replace("_", " ")
            yield _switch(path_of(place), " or ".join(choices), chosen, choices)


@cache
def _examples() -> dict[str, Edits]:
    """Return by kind of bearing the edits that make an example of any other bearing."""
    documents = [parsed(starting_bearing(name), name) for name in BEARING_TEMPLATES]
    names = [name for name in BearingFile.descriptions if name not in _OF_ALL_BEARINGS]
    return {each["bearing"]["kind"]: [(name, each.get(name)) for name in names] for each in documents}


def _of_numbers(tables: tuple[Table, ...]) -> list[Table]:
    """Return the tables that need no file, since the page reads no files by name."""
    return [table for table in tables if UNREAD not in table.required]


def _read(given: dict[str, Any], table: Table) -> Body | None:
    """Return the body of a table; None where it has mistakes."""
    try:
        return read(Body, given, likely=table.likely)
    except InputError:
        return None


def _usual_depth(given: dict[str, Any], table: Table) -> str:
    """Return the depth of a body that gives none; nothing where it has mistakes."""
    body = _read({name: value for name, value in given.items() if name not in ("depth", "profile", "chamfer")}, table)
    return body.behind.word if body else ""


def _sizes(given: dict[str, Any], table: Table) -> dict[str, float]:
    """Return drop and parameters of a body's profile, where it has a single one that is neither moved nor stretched."""
    tables = profile_tables(given) if isinstance(given.get("profile"), list | dict) else []
    if len(tables) != 1 or not isinstance(tables[0], dict) or {"at", *COMMON} & set(tables[0]):
        return {}
    body = _read(given, table)
    end = body.land[1] - body.position if body else math.inf
    if body is None or body.profile.catalogue_entry is None or not math.isfinite(end):
        return {}
    drop = float(body.profile.relief(end) - body.profile.relief(0.0))
    parameters = body.profile.catalogue_entry[1]
    values = {name: value for name, value in parameters.items() if isinstance(value, float)} | {"drop": drop}
    return {name: float(f"{value:.4g}") for name, value in values.items() if math.isfinite(value) and value}


def _can_be_moved(given: dict[str, Any], table: Table) -> bool:
    """Return whether the profiles of a body leave room to be moved: beside corners, a bounded one leaves none."""
    if not {"corner_radius", "chamfer"} & set(given) or not isinstance(given.get("profile"), list | dict):
        return True
    shift = _NOTICEABLE * size_of("length", given.get("length"))
    moved = [each | {"shift": shift} if isinstance(each, dict) else each for each in profile_tables(given)]
    return _read(given | {"profile": moved}, table) is not None


def _unchosen(table: Table, given: dict[str, Any]) -> set[str]:
    """Return the keys to hide: alternatives not chosen, what others rule out that are or are not given, and files."""
    aside = {UNREAD} - set(given)
    for pair in table.pairs:
        shown = [name for name in pair if name in given] or [pair[0]]
        aside |= {name for name in pair if name not in shown}
    aside |= {name for group in table.apart if set(group) & set(given) for name in set(group) - set(given)}
    aside |= {name for name, other in _ONLY_WITHOUT.items() if name not in given and other in given}
    aside |= {name for name, other in _ONLY_BESIDE.items() if not {name, other} & set(given)}
    if given.get("kind") == "plate" and "diameter" not in given:
        aside.add("diameter")
    # Only whole rollers are hollow; of a body with mistakes it is not known what it is.
    if "profile" in table.keys and (given.get("depth") or _usual_depth(given, table) or "finite") != "finite":
        aside |= {"bore"} - set(given)
    return aside


def _switch(path: str, label: str, chosen: str, choices: Mapping[str, Edits]) -> FormField:
    """Return a choice that is not a key of the document: words, and what changes where they are chosen."""
    options = tuple(Option(words, words, edits) for words, edits in choices.items())
    return FormField(path, label, "switch", chosen, options=options, structural=True)
