"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from the case file's schema, values from the bodies made from it.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from nonhertz.io.casefile import Case, schema
from nonhertz.io.measured import KIND as MEASURED
from nonhertz.io.profiles import profile_tables
from nonhertz.io.writing import profile_tables as written_profiles
from nonhertz.measured import prepare
from nonhertz.model.body import Body, TabulatedDiameter
from nonhertz.model.corner import Chamfer
from nonhertz.model.material import Material
from nonhertz.model.materials import MATERIALS
from nonhertz.model.profile import CATALOGUE
from nonhertz.model.profile.drop import determined
from nonhertz.report.method import formula, source
from nonhertz.result.numerals import given

LONGEST_LIST = 8  # entries; a longer list is summarised
_ABSENT = {
    "diameter": "flat",
    "bore": "none",
    "length": "unbounded",
    "effective_length": "the whole length",
    "corner_radius": "none",
    "chamfer": "none",
    "case_depth": "none",
}
# What is known of a material beside its elastic constants: words before the value, and unit.
_BORNE = {
    "yield_strength": ("yield strength", " MPa"),
    "core_yield_strength": ("core", " MPa"),
    "hardness": ("hardness", ""),
    "pressure_limit": ("limit of pressure", " MPa"),
}
# Units of numbers within an input that is a table.
_WITHIN = {
    **dict.fromkeys(("length", "blend_radius", "approach", "end_radius", "height", "crown_radius", "edge"), " mm"),
    **dict.fromkeys(("depth", "diameter", "shoulder", "shoulder_diameter", "y", "raceway_diameter"), " mm"),
    "per_area": " /mm^2",
    **dict.fromkeys(("load", "radial", "axial"), " N"),
    **dict.fromkeys(("angle", "tilt"), " rad"),
    "moment": " N mm",
    "speed": " 1/min",
}
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
    for name, property_ in _properties("Body").items():
        if name not in {"kind", "profile"}:
            value = getattr(body, name)
            if name == "depth" and value is None:
                value = body.behind.shown
            text = _ABSENT[name] if value is None else shown(value)
            unit = unit_of(property_) if isinstance(value, float | int | TabulatedDiameter) else ""
            entries.append(
                Entry(
                    f"{place}.{name}", text, unit, property_["description"], name not in table, as_written(table, name)
                )
            )
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
    prescribed = case.prescribed
    for name, property_ in _properties("Prescription").items():
        if name in prescribed:
            value = given(prescribed[name])
            yield Entry(
                f"load.{name}", value, unit_of(property_), property_["description"], False, as_written(table, name)
            )
    if not {"tilt", "moment"} & set(prescribed):
        yield Entry("load.tilt", "0", "rad", _properties("Prescription")["tilt"]["description"], True)


def _solver_entries(case: Case, table: Mapping[str, Any]) -> Iterator[Entry]:
    solver = case.solver
    accuracy = "" if solver["accuracy"] is None else f"{solver['accuracy']:g}"
    values = {"element": solver["element"].name, "strips": str(solver["strips"]), "accuracy": accuracy}
    for name, property_ in _properties("Solver").items():
        if values[name]:
            yield Entry(f"solver.{name}", values[name], "", property_["description"], name not in table)


def _life_entries(table: Mapping[str, Any]) -> Iterator[Entry]:
    for name, property_ in _properties("Life").items():
        if name == "spectrum" and table.get(name):
            for number, case in enumerate(table[name], start=1):
                text = ", ".join(f"{key} {_entry_within(key, value)}" for key, value in case.items())
                yield Entry(f"life.spectrum[{number}]", text, "", property_["description"], False)
        elif name in table:
            yield Entry(f"life.{name}", shown(table[name]), unit_of(property_), property_["description"], False)


def _profile_input(
    place: str, table: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> ProfileInput:
    kind = table["kind"]
    described = _profile_kinds().get(kind, {})
    function = prepare if kind == MEASURED else CATALOGUE.get(kind)
    entries = [Entry(f"{place}.kind", kind, "", "relief along the axis", default)]
    for name, property_ in described.get("properties", {}).items():
        value, is_default = _parameter(name, table, function)
        meaning = property_.get("description", "").replace("`", "").rstrip(".")
        if "drop" in table and name == determined(kind, table):
            value, is_default, meaning = shown(made[name]), False, f"{meaning}; from the drop"
        if name != "kind" and value is not None:
            # Text includes its unit, and a word such as "auto" has none.
            unit = unit_of(property_) if _has_digit(value) and not isinstance(table.get(name), str) else ""
            entries.append(Entry(f"{place}.{name}", value, unit, meaning, is_default))
    what = described.get("description", kind).rstrip(".")
    return ProfileInput(what[:1].upper() + what[1:], formula(function), source(function), tuple(entries))


def _parameter(name: str, table: Mapping[str, Any], function: Callable[..., Any] | None) -> tuple[str | None, bool]:
    """Return the value of a profile's parameter as text, None if it has none, and whether it is a default."""
    if name in table:
        return shown(table[name]), False
    if name == "at" and "drop" in table:
        return _AT_THE_END, True
    known = inspect.signature(function).parameters.get(name) if function else None
    if known is None or (known.default is known.empty and "file" in table):
        return None, True
    if known.default is known.empty:
        return _OF_BOTH if name == "radius" else _OF_THE_BODY, True
    return (None if known.default is None else shown(known.default)), True


def shown(value: Any) -> str:
    """Return a value as readable text."""
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
        return ", ".join(f"{key} = {_entry_within(key, entry)}" for key, entry in value.items())
    return _sequence(value) if isinstance(value, list | tuple) else str(value)


def _entry_within(key: str, value: Any) -> str:
    return shown(value) + (_WITHIN.get(key, "") if isinstance(value, float | int | list | tuple) else "")


def _sequence(values: Sequence[Any]) -> str:
    if len(values) > LONGEST_LIST:
        return f"{len(values)} values, {shown(values[0])} to {shown(values[-1])}"
    return ", ".join(map(shown, values))


def _material(material: Material) -> str:
    name = next((name for name, known in MATERIALS.items() if known == material), "")
    constants = [f"E = {shown(material.modulus)} MPa", f"ν = {shown(material.poisson)}"]
    constants += [
        f"{words} {shown(getattr(material, field))}{unit}"
        for field, (words, unit) in _BORNE.items()
        if getattr(material, field) is not None
    ]
    return f"{name} ({', '.join(constants)})" if name else ", ".join(constants)


def as_written(table: Mapping[str, Any], name: str) -> str:
    """Return a quantity as written in the case file if it is text with a unit, recognised by its digits."""
    value = table.get(name)
    return value if isinstance(value, str) and _has_digit(value) else ""


def _has_digit(text: str) -> bool:
    return any(letter.isdigit() for letter in text)


def unit_of(property_: Mapping[str, Any]) -> str:
    """Return the unit in a key's schema, wherever it is given."""
    choices = [property_, *property_.get("anyOf", ()), property_.get("items", {})]
    return next((str(each["unit"]) for each in choices if each.get("unit")), "")


def _properties(table: str) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = schema()["$defs"][table]["properties"]
    return found


def _profile_kinds() -> dict[str, dict[str, Any]]:
    single = _properties("Body")["profile"]["anyOf"][0]
    return {each["title"]: each for each in single["anyOf"]}
