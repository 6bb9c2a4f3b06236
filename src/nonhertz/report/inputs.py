"""Every input of a case with value, unit and meaning, and whether it is a default.

Meanings and units come from what the fields of inputs say, values from what was made of the file. A case and a bearing
are lists of the same tables.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

from nonhertz.amounts import amount, given, mpa
from nonhertz.bearing.bearings import Pair, Paired, RollerBearing
from nonhertz.bearing.clearance import Housing, Mounting, Shaft
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.ribs import Rib
from nonhertz.bearing.verb import BearingSolver
from nonhertz.files.bearing_document import BearingLifeConditions
from nonhertz.files.bearingfile import BearingCase
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
_PARTS = {"roller": "Rollers", "inner": "Inner ring", "outer": "Outer ring"}
#: Lengths of bearings that people read in um.
_SMALL = {"interference", "smoothing", "clearance", "axial_clearance", "radial_displacement", "axial_displacement"}


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
        """The last part of the place, of fits with what is fitted."""
        return self.place.removeprefix("fit.") if self.place.startswith("fit.") else self.place.rpartition(".")[2]

    @property
    def shown(self) -> str:
        """The value with its unit."""
        return f"{self.value} {self.unit}".strip()


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
    def every(self) -> tuple[Entry, ...]:
        """All of them, of profiles too."""
        return (*self.entries, *(each for profile in self.profiles for each in profile.entries))


def inputs(case: Case | BearingCase) -> list[InputGroup]:
    """Return all inputs of a case, or of a bearing, grouped by the headings of its file."""
    document = case.document
    groups = list(_of_bearing(case) if isinstance(case, BearingCase) else _of_contact(case))
    if document.get("life"):
        cls, values = (BearingLifeConditions, case.life) if isinstance(case, BearingCase) else (Life, {})
        groups.append(InputGroup("Life", tuple(_entries("life", cls, document["life"], values))))
    return groups


def _of_contact(case: Case) -> Iterator[InputGroup]:
    document, contact, load = case.document, case.contact, case.document.get("load", {})
    for name, body in (("a", contact.a), ("b", contact.b)):
        yield _body_group(f"Body {name}", f"body.{name}", document["body"][name], body)
    entries = [*_entries("load", Prescription, load, case.prescribed)]
    if not {"tilt", "moment"} & set(case.prescribed):
        meaning = _meaning_of(table_of(Prescription).keys["tilt"])
        entries.append(Entry("load.tilt", "0", "rad", meaning, True))
    yield InputGroup("Prescription", tuple(entries))
    values = case.solver | {"element": case.solver["element"].name}
    yield InputGroup("Solver", tuple(_entries("solver", Solver, document.get("solver", {}), values, defaults=True)))


def _of_bearing(case: BearingCase) -> Iterator[InputGroup]:
    document, row = case.document, case.bearing.rows[0].bearing
    yield InputGroup("Bearing", tuple(_bearing_entries(case, document["bearing"])))
    for name, title in _PARTS.items():
        yield _body_group(title, name, document.get(name, {}), getattr(row, name))
    yield InputGroup("Load", tuple(_entries("load", BearingLoad, document.get("load", {}), case.prescribed)))
    if case.fit:
        fit = document["fit"]
        parts = [_entries(f"fit.{name}", cls, fit[name], vars(case.fit[name])) for name, cls in _FITTED.items()]
        rest = {name: value for name, value in fit.items() if name not in _FITTED}
        entries = (each for part in (*parts, _entries("fit", Mounting, rest, case.fit)) for each in part)
        yield InputGroup("Fits and temperatures", tuple(entries))
    solver = document.get("solver", {})
    yield InputGroup("Solver", tuple(_entries("solver", BearingSolver, solver, case.solver, defaults=True)))


_FITTED: dict[str, Any] = {"shaft": Shaft, "housing": Housing}


def _bearing_entries(case: BearingCase, table: Mapping[str, Any]) -> Iterator[Entry]:
    row = case.bearing.rows[0].bearing
    yield Entry("bearing.kind", shown(table["kind"]), "", "what it is", False)
    for name, key in table_of(RollerBearing).keys.items():
        if name == "pair" and name in table:
            rows, values = case.bearing, {}
            if isinstance(rows, Paired):
                values = {"distance": rows.x[-1] - rows.x[0], "clearance": rows.clearance}
            yield from _entries("bearing.pair", Pair, table["pair"], values)
        elif hasattr(row, name):
            value = table.get(name) if name.endswith("_shape") else getattr(row, name)
            if value is None and name not in table:
                guessed = name == "rib" and bool(row.rib_contacts)
                value = {"pitch_diameter": row.pitch}.get(name, "a guess" if guessed else "none")
            yield _entry(f"bearing.{name}", value, key, table)


def _entries(
    place: str, cls: Any, table: Mapping[str, Any], values: Mapping[str, Any], *, defaults: bool = False
) -> Iterator[Entry]:
    """Yield the keys that a table has, with the values that were made of them, and on request its defaults.

    Of a list of tables each is an entry.
    """
    for name, key in table_of(cls).keys.items():
        value = values.get(name, table.get(name, key.usual))
        given_tables = table.get(name)
        if isinstance(given_tables, list) and key.tables:
            for number, each in enumerate(given_tables, start=1):
                yield Entry(f"{place}.{name}[{number}]", shown(each, key), "", _meaning_of(key), False)
        elif name in table or (defaults and value is not None):
            yield _entry(f"{place}.{name}", value, key, table)


def _entry(place: str, value: Any, key: Key, table: Mapping[str, Any]) -> Entry:
    name = place.rpartition(".")[2]
    if isinstance(value, Rib):
        value = {name: each for name, each in vars(value).items() if each is not None}
    text, unit = _with_unit(value, key, small=name in _SMALL)
    written = _as_written(table, name)
    # What a file says, unless that is what is shown.
    unlike = "" if written.replace("um", "µm") == f"{text} {unit}" else written
    return Entry(place, text, unit, _meaning_of(key), name not in table, unlike)


def _body_group(title: str, place: str, table: Mapping[str, Any], body: Body) -> InputGroup:
    """Return the inputs of a body, from its table and from what was made of that."""
    made = type(body).__name__.lower()
    kind = table.get("kind") or ("any body" if made == "body" else made)
    entries = [Entry(f"{place}.kind", kind, "", "what the body is", "kind" not in table)]
    for name, key in table_of(Body).keys.items():
        if name != "profile":
            value = getattr(body, name)
            if name == "depth" and value is None:
                value = body.behind.shown
            entries.append(_entry(f"{place}.{name}", _ABSENT.get(name, "none") if value is None else value, key, table))
    tables = profile_tables(table)
    drawn = iter(written_profiles(body.profile))
    profiles = tuple(
        # A straight profile is left out of what was made.
        _profile_input(f"{place}.profile[{number}]", profile, {} if profile["kind"] == "straight" else next(drawn))
        for number, profile in enumerate(tables, start=1)
    )
    if not tables:
        profiles = (_profile_input(f"{place}.profile", {"kind": "straight"}, {}, default=True),)
    return InputGroup(title, tuple(entries), profiles)


def _profile_input(
    place: str, table: Mapping[str, Any], made: Mapping[str, Any], *, default: bool = False
) -> ProfileInput:
    kind = table["kind"]
    described = next((each for each in profile_kinds() if each.word == kind), Table(kind, kind, {}))
    function = prepare if kind == MEASURED else CATALOGUE.get(kind)
    entries = [Entry(f"{place}.kind", kind, "", "relief along the axis", default)]
    for name, key in described.keys.items():
        value, is_default = _parameter(name, table, function)
        meaning = _meaning_of(key)
        if "drop" in table and name == determined(kind, table):
            value, is_default, meaning = made[name], False, f"{meaning}; from the drop"
        written = _as_written(table, name) if unit_of(key) else ""
        if written:
            value = in_unit(name, written, unit_of(key))
        if value is not None:
            text, unit = _with_unit(value, key, small="um" in written)
            entries.append(Entry(f"{place}.{name}", text, unit, meaning, is_default, written))
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


def _meaning_of(key: Key) -> str:
    """Return what a key is, without what it could be instead."""
    return key.each.meaning.partition(";")[0]


def _with_unit(value: Any, key: Key | None = None, *, small: bool = False) -> tuple[str, str]:
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
        cells = ((name, " ".join(_with_unit(entry, keys.get(name))).rstrip()) for name, entry in value.items())
        return ", ".join(f"{name} = {cell}" for name, cell in cells)
    return _sequence(value, key) if isinstance(value, list | tuple) else str(value)


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


def _as_written(table: Mapping[str, Any], name: str) -> str:
    """Return a quantity as written in the case file if it is text with a unit, recognised by its digits."""
    value = table.get(name)
    return value if isinstance(value, str) and any(letter.isdigit() for letter in value) else ""
