"""Every input of a bearing with value, unit and meaning, grouped by the headings of its file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from nonhertz.bearing.bearings import Pair, Paired, RollerBearing
from nonhertz.bearing.clearance import Housing, Mounting, Shaft
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.ribs import Rib
from nonhertz.bearing.verb import BearingSolver
from nonhertz.files.bearing_document import BearingLifeConditions
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.keys import Key, table_of
from nonhertz.report.inputs import Entry, InputGroup, as_written, body_group, meaning_of, shown, with_unit

_BODIES = {"roller": "Rollers", "inner": "Inner ring", "outer": "Outer ring"}
#: Lengths that people read in um.
_SMALL = {"interference", "smoothing", "clearance", "axial_clearance", "radial_displacement", "axial_displacement"}


def bearing_inputs(case: BearingCase) -> list[InputGroup]:
    """Return all inputs of a bearing, grouped by the headings of its file."""
    document = case.document
    row = case.bearing.rows[0].bearing
    groups = [InputGroup("Bearing", tuple(_bearing_entries(case, document["bearing"])))]
    groups += [body_group(title, name, document.get(name, {}), getattr(row, name)) for name, title in _BODIES.items()]
    groups.append(
        InputGroup("Load", tuple(_given_entries("load", document.get("load", {}), case.prescribed, BearingLoad)))
    )
    if case.fit:
        groups.append(InputGroup("Fits and temperatures", tuple(_fit_entries(case, document["fit"]))))
    groups.append(InputGroup("Solver", tuple(_solver_entries(document.get("solver", {}), case.solver))))
    if document.get("life"):
        groups.append(
            InputGroup("Life", tuple(_given_entries("life", document["life"], case.life, BearingLifeConditions)))
        )
    return groups


def _bearing_entries(case: BearingCase, table: Mapping[str, Any]) -> Iterator[Entry]:
    row = case.bearing.rows[0].bearing
    yield Entry("bearing.kind", shown(table["kind"]), "", "what it is", False)
    for name, key in table_of(RollerBearing).keys.items():
        if name == "pair" and name in table:
            yield from _pair_entries(case.bearing, table["pair"])
        elif hasattr(row, name):
            value = table.get(name) if name.endswith("_shape") else getattr(row, name)
            if value is None and name not in table:
                guessed = name == "rib" and bool(row.rib_contacts)
                value = {"pitch_diameter": row.pitch}.get(name, "a guess" if guessed else "none")
            yield _entry(f"bearing.{name}", value, key, table)


def _fit_entries(case: BearingCase, table: Mapping[str, Any]) -> Iterator[Entry]:
    for name, cls in (("shaft", Shaft), ("housing", Housing)):
        yield from _given_entries(f"fit.{name}", table[name], vars(case.fit[name]), cls)
    rest = {name: value for name, value in table.items() if name not in {"shaft", "housing"}}
    yield from _given_entries("fit", rest, case.fit, Mounting)


def _pair_entries(rows: RollerBearing | Paired, table: Mapping[str, Any]) -> Iterator[Entry]:
    values: dict[str, Any] = {}
    if isinstance(rows, Paired):
        values = {"distance": rows.x[-1] - rows.x[0], "clearance": rows.clearance}
    return _given_entries("bearing.pair", table, values, Pair)


def _given_entries(place: str, table: Mapping[str, Any], values: Mapping[str, Any], cls: Any) -> Iterator[Entry]:
    """Yield the keys that a table has, with the values that were made of them."""
    for name, key in table_of(cls).keys.items():
        if name in table:
            yield _entry(f"{place}.{name}", values.get(name, table[name]), key, table)


def _solver_entries(table: Mapping[str, Any], values: Mapping[str, Any]) -> Iterator[Entry]:
    """Yield all keys of a table, defaults too."""
    for name, key in table_of(BearingSolver).keys.items():
        yield _entry(f"solver.{name}", values.get(name, key.usual), key, table)


def _entry(place: str, value: Any, key: Key, table: Mapping[str, Any]) -> Entry:
    name = place.rpartition(".")[2]
    if isinstance(value, Rib):
        value = {name: each for name, each in vars(value).items() if each is not None}
    text, unit = with_unit(value, key, small=name in _SMALL)
    written = as_written(table, name)
    # What a file says, unless that is what is shown.
    unlike = "" if written.replace("um", "µm") == f"{text} {unit}" else written
    return Entry(place, text, unit, meaning_of(key), name not in table, unlike)
