"""A bearing as the document of a bearing file, which `nonhertz.io.bearingfile.bearing_in` reads back as the same."""

from __future__ import annotations

from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Any

from nonhertz.bearing.bearings import Paired, RollerBearing, paired
from nonhertz.bearing.clearance import Housing, Shaft
from nonhertz.bearing.ribs import Rib
from nonhertz.bearing.shapes import RingShape
from nonhertz.errors import InputError
from nonhertz.io.bounds import FORMAT
from nonhertz.io.written import body_table, material_table

if TYPE_CHECKING:
    from nonhertz.io.bearingfile import BearingCase

_PARTS = ("roller", "inner", "outer")
_PYTHON = "solve such a bearing in Python"


def document(case: BearingCase) -> dict[str, Any]:
    """Return a bearing with its loads as the document of a bearing file.

    Raises
    ------
    InputError
        If no bearing file can hold it: a profile, diameter or shape of a raceway of a user-defined class, or rows that
        are not two equal ones.
    """
    row = case.bearing.rows[0].bearing
    found: dict[str, Any] = {"format": FORMAT} | ({"title": case.title} if case.title else {})
    found["bearing"] = _bearing(row)
    if isinstance(case.bearing, Paired):
        found["bearing"]["pair"] = _pair(case.bearing)
    for name in _PARTS:
        try:
            found[name] = body_table(getattr(row, name))
        except InputError as error:
            raise error.within(name) from None
    found["load"] = {name: _plain(value) for name, value in case.prescribed.items() if value is not None}
    if case.fit:
        seats = {name: value for name, value in case.fit.items() if isinstance(value, Shaft | Housing)}
        found["fit"] = case.fit | {name: _seat(value) for name, value in seats.items()}
    found["solver"] = dict(case.solver)
    life = {name: value for name, value in case.life.items() if name != "speed" and value is not None}
    if case.spectrum:
        life["spectrum"] = [
            {name: _plain(value) for name, value in vars(each).items() if value is not None} for each in case.spectrum
        ]
    block = case.title_block.table
    return found | ({"life": life} if life else {}) | ({"report": block} if block else {})


def _bearing(row: RollerBearing) -> dict[str, Any]:
    from nonhertz.io.bearing_document import KINDS, word_of

    if type(row) not in KINDS.values():
        raise InputError("bearing", type(row).__name__, "be of a kind that a bearing file knows", _PYTHON)
    table: dict[str, Any] = {"kind": word_of(type(row))}
    for field in fields(row):
        value = getattr(row, field.name)
        if field.name in _PARTS or (field.default is not MISSING and value == field.default):
            continue
        if field.name in {"inner_shape", "outer_shape"}:
            table[field.name] = _shape(field.name, value)
        else:
            rib = vars(value).items() if isinstance(value, Rib) else None
            table[field.name] = value if rib is None else {name: each for name, each in rib if each is not None}
    return table


def _shape(name: str, shape: Any) -> Any:
    """Return the shape of a ring as a table, or a list of tables that add."""
    tables = [_of_waves(each) for each in shape.tables] if isinstance(shape, RingShape) else []
    if not tables:
        condition = "be made by fourier_shape or tabulated_shape to go into a bearing file"
        raise InputError(name, shape, condition, _PYTHON)
    return tables[0] if len(tables) == 1 else tables


def _of_waves(table: dict[str, Any]) -> dict[str, Any]:
    if "terms" not in table:
        return table
    waves = [
        {"waves": order, "amplitude": amplitude, "phase": crest} for order, (amplitude, crest) in table["terms"].items()
    ]
    return {"terms": waves}


def _seat(seat: Shaft | Housing) -> dict[str, Any]:
    usual = {field.name: field.default for field in fields(seat)}
    table = {name: value for name, value in vars(seat).items() if value != usual[name]}
    return table | ({"material": material_table(seat.material)} if "material" in table else {})


def _pair(rows: Paired) -> dict[str, Any]:
    from nonhertz.bearing.bearings import ARRANGEMENTS

    first, distance = rows.bearings[0], rows.x[-1] - rows.x[0]
    for arrangement in ARRANGEMENTS if distance > 0.0 else ():
        if rows == paired(first, arrangement, distance, clearance=rows.clearance):
            return {"arrangement": arrangement, "distance": distance, "clearance": float(rows.clearance)}
    raise InputError("bearings", len(rows.bearings), "be two equal rows in X, O or tandem to go into a file", _PYTHON)


def _plain(value: Any) -> float | list[float]:
    return [float(each) for each in value] if hasattr(value, "__iter__") else float(value)
