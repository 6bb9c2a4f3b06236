"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from what the fields of inputs say, values from what `Document.write` writes: all of them, in
base units, those that a profile takes from its body too. A case and a bearing are lists of the same tables.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from nonhertz.amounts import amount, format_input, mpa
from nonhertz.files.bearing_document import PARTS
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.keys import MICROMETRES, Key, Table, profile_kinds, table_of, unit_of
from nonhertz.files.measured import KIND as MEASURED
from nonhertz.files.profiles import profile_tables
from nonhertz.inputs.units import begins_with_digits, to_unit
from nonhertz.measured import prepare
from nonhertz.model.body import BODIES, Body
from nonhertz.model.material import Material
from nonhertz.model.materials import name_of
from nonhertz.model.profile import CATALOGUE
from nonhertz.model.profile.drop import parameter_from_drop
from nonhertz.report.method import formula, source
from nonhertz.show.sections import Cell

LONGEST_LIST = 8  # entries; a longer list is summarised
#: Headings by the places of tables.
_TITLES = {
    **{f"body.{name}": f"Body {name}" for name in BODIES},
    **{"bearing": "Bearing", "roller": "Rollers", "inner": "Inner ring", "outer": "Outer ring", "load": "Load"},
    **{"fit": "Fits and temperatures", "solver": "Solver", "lubrication": "Oil", "life": "Life"},
}
#: Of these only what a file gives is shown, and what is said here.
_AS_GIVEN = ("load", "fit", "lubrication", "life")
_WITHIN = ("shaft", "housing", "pair")  # tables whose keys are entries of their own
# What the body has where a key is left out that has no value then; nothing, if not here.
_ABSENT = {"diameter": "flat", "length": "unbounded", "effective_length": "the whole length"}
# What is known of a material beside its elastic constants: words before the value.
_BORNE = {
    "yield_strength": "yield strength", "core_yield_strength": "core", "hardness": "hardness",
    "pressure_limit": "limit of pressure",
}  # fmt: skip
_AT_THE_END = "the end of the land"
#: What steps of a measured profile are if its table does not say.
_STEPS = {name: each.default for name, each in inspect.signature(prepare).parameters.items()}


@dataclass(frozen=True)
class Entry:
    """One input.

    Attributes
    ----------
    place : str
        The key as the case file has it, such as ``"body.a.length"``.
    value, unit : str
        Number or word, and the unit of the number.
    meaning : str
        What it is.
    default : bool
        Whether the case file leaves it out.
    written : str
        The value as written in the case file, if that is in another unit.
    """

    place: str
    value: str
    unit: str
    meaning: str
    default: bool
    written: str = ""

    @property
    def name(self) -> str:
        """The last part of the place in words, of fits with what is fitted."""
        key = self.place.removeprefix("fit.") if self.place.startswith("fit.") else self.place.rpartition(".")[2]
        return in_words(key)

    @property
    def full_name(self) -> str:
        """The whole place in words, such as "body a, profile 1, drop"."""
        return in_words(self.place.removeprefix("load.").removeprefix("solver."))

    @property
    def shown(self) -> str:
        """The value with its unit."""
        return f"{self.value} {self.unit}".strip()


@dataclass(frozen=True)
class InputGroup:
    """The inputs under one heading in the case file: in rows, between which are headings and remarks on profiles."""

    title: str
    rows: tuple[Entry | tuple[str | Cell], ...]

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All inputs, of profiles too."""
        return tuple(each for each in self.rows if isinstance(each, Entry))


def inputs(case: Case | BearingCase) -> list[InputGroup]:
    """Return all inputs of a case, or of a bearing, grouped by the headings of its file."""
    written, made = dict(_flat(case.document)), dict(_flat(case.own_document))
    # What is shown where a file says nothing, and of bodies in its place.
    said: dict[str, dict[str, Any]] = {}
    if isinstance(case, Case):
        bodies: dict[str, Body] = {f"body.{name}": getattr(case.contact, name) for name in BODIES}
        said["load"] = {} if {"tilt", "moment"} & set(made["load"]) else {"tilt": 0.0}
    else:
        row = case.bearing.rows[0].bearing
        bodies = {name: getattr(row, name) for name in PARTS}
        guessed = getattr(row, "rib", "") is None and bool(row.rib_contacts)
        said["bearing"] = {"pitch_diameter": row.pitch} | ({"rib": "a guess"} if guessed else {})
    for place, body in bodies.items():
        said[place] = {"material": body.material} | ({} if body.depth is not None else {"depth": body.behind.shown})
    groups = []
    for place, title in _TITLES.items():
        if place in made:
            own, table = written.get(place, {}), table_of(case.contents)
            for name in place.split("."):
                table = table.keys[name].tables[0]
            rows = [*_entries(place, table, own, made[place], said.get(place, {}))]
            if table.kinds:
                word = own.get("kind", made[place]["kind"] if made[place].get("kind") != "body" else "any body")
                rows.insert(0, Entry(f"{place}.kind", word, "", "type", "kind" not in own))
            profiles = _profiles(place, own, made[place].get("profile", [])) if place in bodies else ()
            groups.append(InputGroup(title, (*rows, *profiles)))
    return [group for group in groups if group.entries]


def in_words(place: str) -> str:
    """Return the path of a key as people say it, without the marks of a file.

    Examples
    --------
    >>> in_words("body.a.profile[1].end_radius"), in_words("shaft.outside_diameter")
    ('body a, profile 1, end radius', 'shaft, outside diameter')
    """
    place = re.sub(r"\[(\d+)\]", r" \1", place.replace("body.", "body "))
    return place.replace(".", ", ").replace("_", " ")


def _flat(document: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the tables of a document by their places."""
    for name, table in document.items():
        yield from ((f"{name}.{part}", each) for part, each in table.items()) if name == "body" else [(name, table)]


def _entries(
    place: str, table: Table, own: Mapping[str, Any], made: Mapping[str, Any], said: Mapping[str, Any]
) -> Iterator[Entry]:
    """Yield what a table holds, given and made; ``said`` comes first. Of a list of tables each is an entry."""
    for name, key in table.of_kind(made.get("kind")).keys.items():
        value = said.get(name, made.get(name, own.get(name, key.usual)))
        if name in _WITHIN and name in own:
            # One word may stand for the table, as a class for a seat.
            table_given = own[name] if isinstance(own[name], Mapping) else made[name]
            yield from _entries(f"{place}.{name}", key.tables[0], table_given, made[name], {})
        elif name == "profile" or name in _WITHIN or (place.startswith(_AS_GIVEN) and not {name} & {*own, *said}):
            continue
        elif isinstance(value, list) and key.several:
            for number, each in enumerate(value, start=1):
                yield Entry(f"{place}.{name}[{number}]", shown(each, key), "", _meaning_of(key), name not in own)
        elif value is not None or place != "solver":
            yield _entry(f"{place}.{name}", _ABSENT.get(name, "none") if value is None else value, key, own)


def _entry(place: str, value: Any, key: Key, own: Mapping[str, Any], more: str = "") -> Entry:
    name = place.rpartition(".")[2]
    # As the file has it, if that is text with a unit, recognised by its digits.
    written = str(own.get(name)) if isinstance(own.get(name), str) and re.search(r"\d", own[name]) else ""
    text, unit = _with_unit(value, key, small=name in MICROMETRES or "um" in written)
    # What a file says, unless that is what is shown.
    unlike = "" if f"{text} {unit}".startswith(written.replace("um", "µm")) else written
    return Entry(place, text, unit, _meaning_of(key) + more, name not in own and not more, unlike)


def _profiles(place: str, own: Mapping[str, Any], made: list[dict[str, Any]]) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield the profiles of a body, as given and as made; a straight one is left out of what is made."""
    drawn, tables = iter(made), profile_tables(own)
    if not tables:
        yield from _profile(f"{place}.profile", {"kind": "straight"}, {}, default=True)
    for number, table in enumerate(tables, start=1):
        yield from _profile(f"{place}.profile[{number}]", table, {} if table["kind"] == "straight" else next(drawn))


def _profile(
    place: str, own: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield what a profile is, its parameters, and its formula with its source."""
    kind = own["kind"]
    table = next((each for each in profile_kinds() if each.word == kind), Table(kind, kind, {}))
    measured = kind == MEASURED
    what, function = table.meaning.rstrip("."), prepare if measured else CATALOGUE.get(kind)
    if what:
        yield (what[:1].upper() + what[1:],)
    yield Entry(f"{place}.kind", kind, "", "relief along the axis", default)
    usual = {**(_STEPS if measured else made), **({"at": _AT_THE_END} if "drop" in own else {})}
    for name, key in table.keys.items():
        value = own.get(name, None if "file" in own and name in ("y", "relief") else usual.get(name))
        if isinstance(value, str) and begins_with_digits(value) and unit_of(key.description):
            value = to_unit(name, value, unit_of(key.description))
        if value is not None:
            dropped = "; from the drop" if "drop" in own and name == parameter_from_drop(kind, own) else ""
            yield _entry(f"{place}.{name}", value, key, own, dropped)
    words = " Source: ".join(filter(None, (formula(function), source(function))))
    if words:
        yield (Cell("", words),)


def _meaning_of(key: Key) -> str:
    """Return what a key is, without what it could be instead."""
    return key.description.meaning.partition(";")[0]


def _with_unit(value: Any, key: Key | None = None, *, small: bool = False) -> tuple[str, str]:
    """Return a value as text and its unit; text of a file has its own unit, and tables say theirs within them.

    People read ``small`` lengths in micrometres.
    """
    of_list = isinstance(value, list | tuple) and key is not None and not key.tables
    has_unit = of_list or (isinstance(value, float | int) and not isinstance(value, bool))
    unit = unit_of(key.description) if key and has_unit else ""
    factor, word = amount((), unit, "um" if small and unit == "mm" else "").scale
    return shown(_times(value, factor), key), word


def _times(value: Any, factor: float) -> Any:
    """Return a value with all its numbers times a factor."""
    if isinstance(value, list | tuple):
        return [_times(each, factor) for each in value]
    return value if isinstance(value, bool) or not isinstance(value, float | int) or factor == 1.0 else factor * value


def shown(value: Any, key: Key | None = None) -> str:
    """Return a value as readable text; that of a key whose tables say the units within them."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float | int):
        return format_input(float(value))
    if isinstance(value, Material):
        return _material(value)
    if isinstance(value, dict):
        keys = {name: each for table in (key.tables if key else ()) for name, each in table.keys.items()}
        cells = ((name, " ".join(_with_unit(entry, keys.get(name))).rstrip()) for name, entry in value.items())
        return ", ".join(f"{name} = {cell}" for name, cell in cells)
    if not isinstance(value, list | tuple):
        return str(value)
    long = len(value) > LONGEST_LIST
    words = [shown(each, key) for each in ((value[0], value[-1]) if long else value)]
    return f"{len(value)} values, {' to '.join(words)}" if long else ", ".join(words)


def _material(material: Material) -> str:
    name = name_of(material)
    constants = [f"E = {mpa(material.modulus):g}", f"ν = {shown(material.poisson)}"]
    constants += [
        f"{words} {value if isinstance(value, str) else f'{mpa(value):g}'}"
        for field, words in _BORNE.items()
        if (value := getattr(material, field)) is not None
    ]
    return f"{name} ({', '.join(constants)})" if name else ", ".join(constants)
