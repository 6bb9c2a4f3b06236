"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from what the fields of inputs say, values from the bodies made of the file.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

from nonhertz.amounts import amount, given, mpa
from nonhertz.files.casefile import Case
from nonhertz.files.keys import Key, Table, profile_kinds, table_of, unit_of
from nonhertz.files.measured import KIND as MEASURED
from nonhertz.files.profiles import profile_tables
from nonhertz.files.sections import Life, Solver
from nonhertz.files.writing import profile_tables as written_profiles
from nonhertz.inputs.units import in_unit
from nonhertz.measured import prepare
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.corner import Chamfer
from nonhertz.model.material import Material
from nonhertz.model.materials import MATERIALS
from nonhertz.model.prescription import Prescription
from nonhertz.model.profile import CATALOGUE
from nonhertz.model.profile.drop import determined
from nonhertz.report.method import formula, source

LONGEST_LIST = 8  # entries; a longer list is summarised
# What the body has where a key is left out that has no value then; nothing, if not here.
_ABSENT = {"diameter": "flat", "length": "unbounded", "effective_length": "the whole length"}
# What is known of a material beside its elastic constants: words before the value.
_BORNE = {
    "yield_strength": "yield strength", "core_yield_strength": "core", "hardness": "hardness",
    "pressure_limit": "limit of pressure",
}  # fmt: skip
_OF_THE_BODY, _OF_BOTH, _AT_THE_END = "from the body", "from both bodies", "the end of the land"


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
    def key(self) -> str:
        """The last part of the place."""
        return self.place.rpartition(".")[2]


@dataclass(frozen=True)
class ProfileInput:
    """One profile of a body: what it is, its formula with its source, and its parameters."""

    title: str
    formula: str
    source: str
    entries: tuple[Entry, ...]


@dataclass(frozen=True)
class InputGroup:
    """The inputs under one heading in the case file."""

    title: str
    entries: tuple[Entry, ...]
    profiles: tuple[ProfileInput, ...] = ()

    @property
    def usual(self) -> list[Entry]:
        """Those that the file leaves at their defaults, of profiles too."""
        every = (self.entries, *(profile.entries for profile in self.profiles))
        return [entry for entries in every for entry in entries if entry.default]


def inputs(case: Case) -> list[InputGroup]:
    """Return all inputs of a case, grouped by the headings of its file."""
    document, contact = case.document, case.contact
    groups = [
        body_group(f"Body {name}", f"body.{name}", document["body"][name], body)
        for name, body in (("a", contact.a), ("b", contact.b))
    ]
    groups.append(InputGroup("Prescription", tuple(_load_entries(case, document.get("load", {})))))
    groups.append(InputGroup("Solver", tuple(_solver_entries(case, document.get("solver", {})))))
    if document.get("life"):
        groups.append(InputGroup("Life", tuple(_life_entries(document["life"]))))
    return groups


def body_group(title: str, place: str, table: Mapping[str, Any], body: Body) -> InputGroup:
    """Return the inputs of a body, from its table and from what was made of that."""
    entries = [Entry(f"{place}.kind", *_kind(table, body), "kind" not in table)]
    for name, key in table_of(Body).keys.items():
        if name != "profile":
            value = getattr(body, name)
            if name == "depth" and value is None:
                value = body.behind.shown
            text, unit = (_ABSENT.get(name, "none"), "") if value is None else with_unit(value, key)
            meaning, written = meaning_of(key), as_written(table, name)
            entries.append(Entry(f"{place}.{name}", text, unit, meaning, name not in table, written))
    tables = profile_tables(table)
    made = iter(written_profiles(body.profile))
    profiles = tuple(
        # A straight profile is left out of what was made.
        _profile_input(f"{place}.profile[{number}]", profile, {} if profile["kind"] == "straight" else next(made))
        for number, profile in enumerate(tables, start=1)
    )
    if not tables:
        profiles = (_profile_input(f"{place}.profile", {"kind": "straight"}, {}, default=True),)
    return InputGroup(title, tuple(entries), profiles)


def _kind(table: Mapping[str, Any], body: Body) -> tuple[str, str, str]:
    made = type(body).__name__.lower()
    return (table.get("kind") or ("any body" if made == "body" else made)), "", "what the body is"


def _load_entries(case: Case, table: Mapping[str, Any]) -> Iterator[Entry]:
    prescribed, keys = case.prescribed, table_of(Prescription).keys
    for name, key in keys.items():
        if name in prescribed:
            text, unit = with_unit(prescribed[name], key)
            yield Entry(f"load.{name}", text, unit, meaning_of(key), False, as_written(table, name))
    if not {"tilt", "moment"} & set(prescribed):
        yield Entry("load.tilt", "0", "rad", meaning_of(keys["tilt"]), True)


def _solver_entries(case: Case, table: Mapping[str, Any]) -> Iterator[Entry]:
    solver = case.solver
    accuracy = "" if solver["accuracy"] is None else f"{solver['accuracy']:g}"
    values = {"element": solver["element"].name, "strips": str(solver["strips"]), "accuracy": accuracy}
    for name, key in table_of(Solver).keys.items():
        if values[name]:
            yield Entry(f"solver.{name}", values[name], "", meaning_of(key), name not in table)


def _life_entries(table: Mapping[str, Any]) -> Iterator[Entry]:
    for name, key in table_of(Life).keys.items():
        if name == "spectrum" and table.get(name):
            (row,) = key.tables
            for number, case in enumerate(table[name], start=1):
                text = ", ".join(f"{each} {_entry_within(value, row.keys[each])}" for each, value in case.items())
                yield Entry(f"life.spectrum[{number}]", text, "", meaning_of(key), False)
        elif name in table:
            yield Entry(f"life.{name}", *with_unit(table[name], key), meaning_of(key), False)


def _profile_input(
    place: str, table: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> ProfileInput:
    kind = table["kind"]
    described = next((each for each in profile_kinds() if each.word == kind), Table(kind, kind, {}))
    function = prepare if kind == MEASURED else CATALOGUE.get(kind)
    entries = [Entry(f"{place}.kind", kind, "", "relief along the axis", default)]
    for name, key in described.keys.items():
        value, is_default = _parameter(name, table, function)
        meaning = meaning_of(key)
        if "drop" in table and name == determined(kind, table):
            value, is_default, meaning = made[name], False, f"{meaning}; from the drop"
        written = as_written(table, name) if unit_of(key) else ""
        if written:
            value = in_unit(name, written, unit_of(key))
        if value is not None:
            entries.append(
                Entry(f"{place}.{name}", *with_unit(value, key, small="um" in written), meaning, is_default, written)
            )
    what = described.meaning.rstrip(".")
    return ProfileInput(what[:1].upper() + what[1:], formula(function), source(function), tuple(entries))


def _parameter(name: str, table: Mapping[str, Any], function: Callable[..., Any] | None) -> tuple[Any, bool]:
    """Return the value of a profile's parameter, None if it has none, and whether it is a default."""
    if name in table:
        return table[name], False
    if name == "at" and "drop" in table:
        return _AT_THE_END, True
    known = inspect.signature(function).parameters.get(name) if function else None
    if known is None or (known.default is known.empty and "file" in table):
        return None, True
    if known.default is known.empty:
        return _OF_BOTH if name == "radius" else _OF_THE_BODY, True
    return known.default, True


def meaning_of(key: Key) -> str:
    """Return what a key is, without what it could be instead."""
    return key.each.meaning.partition(";")[0]


def with_unit(value: Any, key: Key | None = None, *, small: bool = False) -> tuple[str, str]:
    """Return a value as text and its unit; text of a file has its own unit, and tables say theirs within them.

    People read ``small`` lengths in micrometres.
    """
    of_list = isinstance(value, list | tuple) and key is not None and not key.tables
    has_unit = of_list or (isinstance(value, float | int | TabulatedDiameter) and not isinstance(value, bool))
    unit = unit_of(key) if key and has_unit else ""
    factor, word = amount((), unit, "um" if small and unit == "mm" else "").scale
    return shown(_times(value, factor), key), word


def _times(value: Any, factor: float) -> Any:
    """Return a value with all its numbers times a factor."""
    if isinstance(value, TabulatedDiameter):
        return replace(value, y=_times(value.y, factor), diameter=_times(value.diameter, factor))
    if isinstance(value, list | tuple):
        return [_times(each, factor) for each in value]
    return value if isinstance(value, bool) or not isinstance(value, float | int) or factor == 1.0 else factor * value


def shown(value: Any, key: Key | None = None) -> str:
    """Return a value as readable text; that of a key whose tables say the units within them."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float | int):
        return given(float(value))
    if isinstance(value, Material):
        return _material(value)
    if isinstance(value, TabulatedDiameter):
        return f"{_sequence(value.diameter)} at y = {_sequence(value.y)}"
    if isinstance(value, Chamfer):
        value = asdict(value)
    if isinstance(value, dict):
        keys = {name: each for table in (key.tables if key else ()) for name, each in table.keys.items()}
        return ", ".join(f"{name} = {_entry_within(entry, keys.get(name))}" for name, entry in value.items())
    return _sequence(value, key) if isinstance(value, list | tuple) else str(value)


def _entry_within(value: Any, key: Key | None) -> str:
    return " ".join(with_unit(value, key)).rstrip()


def _sequence(values: Sequence[Any], key: Key | None = None) -> str:
    if len(values) > LONGEST_LIST:
        return f"{len(values)} values, {shown(values[0], key)} to {shown(values[-1], key)}"
    return ", ".join(shown(value, key) for value in values)


def _material(material: Material) -> str:
    name = next((name for name, known in MATERIALS.items() if known == material), "")
    constants = [f"E = {mpa(material.modulus):g}", f"ν = {shown(material.poisson)}"]
    constants += [
        f"{words} {value if isinstance(value, str) else f'{mpa(value):g}'}"
        for field, words in _BORNE.items()
        if (value := getattr(material, field)) is not None
    ]
    return f"{name} ({', '.join(constants)})" if name else ", ".join(constants)


def as_written(table: Mapping[str, Any], name: str) -> str:
    """Return a quantity as written in the case file if it is text with a unit, recognised by its digits."""
    value = table.get(name)
    return value if isinstance(value, str) and _has_digit(value) else ""


def _has_digit(text: str) -> bool:
    return any(letter.isdigit() for letter in text)
