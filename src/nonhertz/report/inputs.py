"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from what the fields of inputs say, values from what `Document.write` writes: all of them, in
base units, those that a profile takes from its body too. A case and a bearing are lists of the same tables.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence
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
#: Tables of which only what a file gives is shown, and what is implied.
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
_STEPS = {name: step.default for name, step in inspect.signature(prepare).parameters.items()}


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
        return readable_place(key)

    @property
    def full_name(self) -> str:
        """The whole place in words, such as "body a, profile 1, drop"."""
        return readable_place(self.place.removeprefix("load.").removeprefix("solver."))

    @property
    def value_with_unit(self) -> str:
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
        return tuple(row for row in self.rows if isinstance(row, Entry))


def collect_inputs(case: Case | BearingCase) -> list[InputGroup]:
    """Return all inputs of a case, or of a bearing, grouped by the headings of its file."""
    written, made = dict(_flatten(case.document)), dict(_flatten(case.own_document))
    bodies, implied = _implied_by_contact(case, made) if isinstance(case, Case) else _implied_by_bearing(case)
    for place, body in bodies.items():
        implied[place] = _implied_by_body(body)
    groups = []
    for place, title in _TITLES.items():
        if place in made:
            own, table = written.get(place, {}), table_of(case.contents)
            for name in place.split("."):
                table = table.keys[name].tables[0]
            rows = [*_table_entries(place, table, own, made[place], implied.get(place, {}))]
            if table.kinds:
                word = own.get("kind", made[place]["kind"] if made[place].get("kind") != "body" else "any body")
                rows.insert(0, Entry(f"{place}.kind", word, "", "type", "kind" not in own))
            profiles = _profile_entries(place, own, made[place].get("profile", [])) if place in bodies else ()
            groups.append(InputGroup(title, (*rows, *profiles)))
    return [group for group in groups if group.entries]


def _implied_by_body(body: Body) -> dict[str, Any]:
    depth = {"depth": body.behind.shown} if body.depth is None else {}
    return {"material": body.material, **depth}


def _implied_by_contact(case: Case, made: Mapping[str, Any]) -> tuple[dict[str, Body], dict[str, dict[str, Any]]]:
    """Return the bodies by their places, and by place what is shown where the file says nothing."""
    bodies: dict[str, Body] = {f"body.{name}": body for name, body in case.contact.bodies.items()}
    return bodies, {"load": {} if {"tilt", "moment"} & set(made["load"]) else {"tilt": 0.0}}


def _implied_by_bearing(case: BearingCase) -> tuple[dict[str, Body], dict[str, dict[str, Any]]]:
    """Return what `_implied_by_contact` does."""
    row = case.bearing.rows[0].bearing
    guessed = getattr(row, "rib", "") is None and bool(row.rib_contacts)
    bearing = {"pitch_diameter": row.pitch} | ({"rib": "a guess"} if guessed else {})
    return {name: getattr(row, name) for name in PARTS}, {"bearing": bearing}


def readable_place(place: str) -> str:
    """Return the path of a key as people say it, without the marks of a file.

    Examples
    --------
    >>> readable_place("body.a.profile[1].end_radius"), readable_place("shaft.outside_diameter")
    ('body a, profile 1, end radius', 'shaft, outside diameter')
    """
    place = re.sub(r"\[(\d+)\]", r" \1", place.replace("body.", "body "))
    return place.replace(".", ", ").replace("_", " ")


def _flatten(document: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the tables of a document by their places."""
    for name, table in document.items():
        yield from ((f"{name}.{part}", body) for part, body in table.items()) if name == "body" else [(name, table)]


def _table_entries(
    place: str, table: Table, own: Mapping[str, Any], made: Mapping[str, Any], implied: Mapping[str, Any]
) -> Iterator[Entry]:
    """Yield what a table holds, given and made; ``implied`` comes first. Each item of a list of tables is an entry."""
    for name, key in table.of_kind(made.get("kind")).keys.items():
        value = implied.get(name, made.get(name, own.get(name, key.usual)))
        if _is_left_out(place, name, value, {*own, *implied}):
            continue
        if name in _WITHIN:
            # One word may stand for the table, as a class for a seat.
            nested = own[name] if isinstance(own[name], Mapping) else made[name]
            yield from _table_entries(f"{place}.{name}", key.tables[0], nested, made[name], {})
        elif isinstance(value, list) and key.several:
            for number, item in enumerate(value, start=1):
                yield Entry(f"{place}.{name}[{number}]", format_value(item, key), "", _meaning_of(key), name not in own)
        else:
            yield _make_entry(f"{place}.{name}", value, key, own)


def _is_left_out(place: str, name: str, value: Any, present: set[str]) -> bool:
    """Return whether a key is no entry: it has entries of its own elsewhere, or nothing says anything of it."""
    as_given = name in _WITHIN or place.startswith(_AS_GIVEN)
    return name == "profile" or (as_given and name not in present) or (value is None and place == "solver")


def _make_entry(place: str, value: Any, key: Key, own: Mapping[str, Any], more: str = "") -> Entry:
    name = place.rpartition(".")[2]
    if value is None:
        value = _ABSENT.get(name, "none")
    # As the file has it, if that is text with a unit, recognised by its digits.
    written = str(own.get(name)) if isinstance(own.get(name), str) and re.search(r"\d", own[name]) else ""
    text, unit = _with_unit(value, key, small=name in MICROMETRES or "um" in written)
    # What a file says, unless that is what is shown.
    unlike = "" if f"{text} {unit}".startswith(written.replace("um", "µm")) else written
    return Entry(place, text, unit, _meaning_of(key) + more, name not in own and not more, unlike)


def _profile_entries(
    place: str, own: Mapping[str, Any], made: list[dict[str, Any]]
) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield the profiles of a body, as given and as made; a straight one is left out of what is made."""
    curved, tables = iter(made), profile_tables(own)
    if not tables:
        yield from _describe_profile(f"{place}.profile", {"kind": "straight"}, {}, default=True)
    for number, table in enumerate(tables, start=1):
        parameters = {} if table["kind"] == "straight" else next(curved)
        yield from _describe_profile(f"{place}.profile[{number}]", table, parameters)


def _describe_profile(
    place: str, own: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield what a profile is, its parameters, and its formula with its source."""
    kind = own["kind"]
    table = next((table for table in profile_kinds() if table.word == kind), Table(kind, kind, {}))
    what, function = table.meaning.rstrip("."), prepare if kind == MEASURED else CATALOGUE.get(kind)
    if what:
        yield (what[:1].upper() + what[1:],)
    yield Entry(f"{place}.kind", kind, "", "relief along the axis", default)
    usual: dict[str, Any] = dict(_STEPS if kind == MEASURED else made)
    dropped = None
    if "drop" in own:
        usual["at"], dropped = _AT_THE_END, parameter_from_drop(kind, own)
    if "file" in own:
        usual |= {"y": None, "relief": None}
    for name, key in table.keys.items():
        value = _in_base_unit(name, own.get(name, usual.get(name)), key)
        if value is not None:
            yield _make_entry(f"{place}.{name}", value, key, own, "; from the drop" * (name == dropped))
    words = " Source: ".join(filter(None, (formula(function), source(function))))
    if words:
        yield (Cell("", words),)


def _in_base_unit(name: str, value: Any, key: Key) -> Any:
    """Return the number of a text with a unit; anything else as it is."""
    unit = unit_of(key.description)
    return to_unit(name, value, unit) if unit and isinstance(value, str) and begins_with_digits(value) else value


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
    return format_value(_scale(value, factor), key), word


def _scale(value: Any, factor: float) -> Any:
    """Return a value with all its numbers times a factor."""
    if isinstance(value, list | tuple):
        return [_scale(item, factor) for item in value]
    return value if isinstance(value, bool) or not isinstance(value, float | int) or factor == 1.0 else factor * value


def format_value(value: Any, key: Key | None = None) -> str:
    """Return a value as readable text; that of a key whose tables say the units within them."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float | int):
        return format_input(float(value))
    if isinstance(value, Material):
        return _format_material(value)
    if isinstance(value, dict):
        return _format_table(value, key)
    return _format_list(value, key) if isinstance(value, list | tuple) else str(value)


def _format_table(table: Mapping[str, Any], key: Key | None) -> str:
    keys = {name: inner for kind in (key.tables if key else ()) for name, inner in kind.keys.items()}
    cells = ((name, " ".join(_with_unit(entry, keys.get(name))).rstrip()) for name, entry in table.items())
    return ", ".join(f"{name} = {cell}" for name, cell in cells)


def _format_list(values: Sequence[Any], key: Key | None) -> str:
    if len(values) > LONGEST_LIST:
        return f"{len(values)} values, {format_value(values[0], key)} to {format_value(values[-1], key)}"
    return ", ".join(format_value(value, key) for value in values)


def _format_material(material: Material) -> str:
    name = name_of(material)
    constants = [f"E = {mpa(material.modulus):g}", f"ν = {format_value(material.poisson)}"]
    constants += [
        f"{words} {value if isinstance(value, str) else f'{mpa(value):g}'}"
        for field, words in _BORNE.items()
        if (value := getattr(material, field)) is not None
    ]
    return f"{name} ({', '.join(constants)})" if name else ", ".join(constants)
