"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from the fields of inputs, values from `Document.write`: all of them in base units, including
those that a profile takes from its body. A case and a bearing are lists of the same tables.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from nonhertz.amounts import amount, format_input, mpa
from nonhertz.errors import join_words
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
_MATERIALS = {f"{place}.material" for place in (*(f"body.{name}" for name in BODIES), *PARTS)}
#: Tables without defaults: only keys in the file, and implied ones, are shown.
_AS_GIVEN = ("load", "fit", "lubrication", "life")
_WITHIN = ("shaft", "housing", "pair")  # tables whose keys are entries of their own
# Words for keys that have no value if they are left out; "none" for others.
_ABSENT = {"diameter": "flat", "length": "unbounded", "effective_length": "the whole length"}
# Properties of a material besides its elastic constants: words before the value.
_BORNE = {
    "yield_strength": "yield strength", "core_yield_strength": "core", "hardness": "hardness",
    "pressure_limit": "pressure limit",
}  # fmt: skip
_AT_THE_END = "the end of the land"
#: Defaults of the steps of a measured profile.
_STEPS = {name: step.default for name, step in inspect.signature(prepare).parameters.items()}


@dataclass(frozen=True)
class Entry:
    """One input.

    Attributes
    ----------
    place : str
        The key in the case file, such as ``"body.a.length"``.
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
        """The last part of the place in words; for fits with the part that is fitted."""
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
    """The inputs under one heading of the case file, in rows, with headings and remarks on profiles between them."""

    title: str
    rows: tuple[Entry | tuple[str | Cell], ...]

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All inputs, including those of profiles."""
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


def share_material(groups: Sequence[InputGroup]) -> list[InputGroup]:
    """Return the inputs with the material of all bodies as a group of its own, if it is the same."""
    made = [(group, row) for group in groups for row in group.entries if row.place in _MATERIALS]
    if len(made) < 2 or len({row.value for _, row in made}) > 1:
        return list(groups)
    shared = next((row for _, row in made if not row.default), made[0][1])
    first, *more = (group.title for group, _ in made)
    own = InputGroup(join_words([first, *(title[0].lower() + title[1:] for title in more)]), (shared,))
    others = [
        replace(group, rows=tuple(row for row in group.rows if getattr(row, "place", "") not in _MATERIALS))
        for group in groups
    ]
    at = next(number for number, group in enumerate(groups) if group is made[0][0])
    return [*others[:at], own, *others[at:]]


def _implied_by_body(body: Body) -> dict[str, Any]:
    depth = {"depth": body.behind.shown} if body.depth is None else {}
    return {"material": body.material, **depth}


def _implied_by_contact(case: Case, made: Mapping[str, Any]) -> tuple[dict[str, Body], dict[str, dict[str, Any]]]:
    """Return the bodies by their places, and by place the values shown for keys that the file leaves out."""
    bodies: dict[str, Body] = {f"body.{name}": body for name, body in case.contact.bodies.items()}
    return bodies, {"load": {} if {"tilt", "moment"} & set(made["load"]) else {"tilt": 0.0}}


def _implied_by_bearing(case: BearingCase) -> tuple[dict[str, Body], dict[str, dict[str, Any]]]:
    """Return the same as `_implied_by_contact`, for a bearing."""
    row = case.bearing.rows[0].bearing
    guessed = getattr(row, "rib", "") is None and bool(row.rib_contacts)
    bearing = {"pitch_diameter": row.pitch} | ({"rib": "a guess"} if guessed else {})
    return {name: getattr(row, name) for name in PARTS}, {"bearing": bearing}


def readable_place(place: str) -> str:
    """Return the path of a key in words, without the punctuation of a file.

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
    """Yield the entries of a table, ``implied`` values first. Each item of a list of tables is an entry."""
    for name, key in table.of_kind(made.get("kind")).keys.items():
        value = implied.get(name, made.get(name, own.get(name, key.usual)))
        if _is_left_out(place, name, value, {*own, *implied}):
            continue
        if name in _WITHIN:
            # One word may replace the table, such as a class for a seat.
            nested = own[name] if isinstance(own[name], Mapping) else made[name]
            yield from _table_entries(f"{place}.{name}", key.tables[0], nested, made[name], {})
        elif isinstance(value, list) and key.several:
            for number, item in enumerate(value, start=1):
                yield Entry(f"{place}.{name}[{number}]", format_value(item, key), "", _meaning_of(key), name not in own)
        else:
            yield _make_entry(f"{place}.{name}", value, key, own)


def _is_left_out(place: str, name: str, value: Any, present: set[str]) -> bool:
    """Return whether a key has no entry: it has entries of its own elsewhere, or no value at all."""
    as_given = name in _WITHIN or place.startswith(_AS_GIVEN)
    return name == "profile" or (as_given and name not in present) or (value is None and place == "solver")


def _make_entry(place: str, value: Any, key: Key, own: Mapping[str, Any], more: str = "") -> Entry:
    name = place.rpartition(".")[2]
    if value is None:
        value = _ABSENT.get(name, "none")
    # As written in the file, if that is text with a unit, recognised by its digits.
    written = str(own.get(name)) if isinstance(own.get(name), str) and re.search(r"\d", own[name]) else ""
    text, unit = _with_unit(value, key, small=name in MICROMETRES or "um" in written)
    # The text of the file, unless it equals the text shown.
    unlike = "" if f"{text} {unit}".startswith(written.replace("um", "µm")) else written
    return Entry(place, text, unit, _meaning_of(key) + more, name not in own and not more, unlike)


def _profile_entries(
    place: str, own: Mapping[str, Any], made: list[dict[str, Any]]
) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield the profiles of a body; ``own`` is as given, ``made`` has all parameters, but no straight profiles."""
    curved, tables = iter(made), profile_tables(own)
    if not tables:
        yield from _describe_profile(f"{place}.profile", {"kind": "straight"}, {}, default=True)
    for number, table in enumerate(tables, start=1):
        parameters = {} if table["kind"] == "straight" else next(curved)
        yield from _describe_profile(f"{place}.profile[{number}]", table, parameters)


def _describe_profile(
    place: str, own: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> Iterator[Entry | tuple[str | Cell]]:
    """Yield the kind of a profile, its parameters, and its formula with its source."""
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
    """Return a text with a unit as a number in the base unit; anything else unchanged."""
    unit = unit_of(key.description)
    return to_unit(name, value, unit) if unit and isinstance(value, str) and begins_with_digits(value) else value


def _meaning_of(key: Key) -> str:
    """Return the meaning of a key, without alternatives to it."""
    return key.description.meaning.partition(";")[0]


def _with_unit(value: Any, key: Key | None = None, *, small: bool = False) -> tuple[str, str]:
    """Return a value as text, and its unit; text from a file and tables contain their own units.

    ``small`` lengths are shown in micrometres.
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
    """Return a value as readable text; tables of a ``key`` contain their units."""
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
