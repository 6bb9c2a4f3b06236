"""A map of a contact as text: its range and its errors, without the data for its evaluation."""

from __future__ import annotations

from operator import attrgetter
from typing import Any, Final

from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, within
from nonhertz.maps import ContactMap

_RANGE: Final = ListOf("number", 2)
_ERRORS: Final = (
    Key("load", "of the load"),
    Key("moment", "of load times half-length"),
    Key("stiffness", "of the stiffness"),
    Key("max_pressure", "of the maximum pressure"),
    Key("max_half_width", "of the half-width"),
    Key("strip_loads", "of the load on a strip, relative to the total load"),
    Key("points", "number of points at which errors were sampled", holds="integer"),
)


def _range(name: str, unit: str) -> Key:
    meaning = f"lowest and highest {name}, if the map was made over it"
    return Key(name, meaning, unit, "pressed", _RANGE, applies=lambda file: file.map.given == name)


#: Keys of a map.
MAP: Final = (
    Key("title", "title of the case", holds="string"),
    *within(
        "map",
        Key("description", "the contact", holds="string"),
        _range("approach", "mm"),
        _range("load", "N"),
        Key("tilt", "lowest and highest tilt", "rad", "tilt_range", _RANGE),
        Key("max_load", "largest load", "N"),
        Key("accuracy", "target relative error of load and moment"),
        Key("sampled_error", "relative errors at independent points", holds=_ERRORS),
        Key("cases", "number of solves from which it was built", holds="integer"),
        Key("failed", "solves without a solution", holds="integer"),
        Key("stations", "edges of the strips whose loads it gives", "mm", holds=ListOf("number")),
    ),
    *results.warning_keys(attrgetter("map.findings")),
    results.UNITS,
)


def as_object(contact_map: ContactMap, title: str) -> dict[str, Any]:
    """Return the range and the sampled errors of a map as plain numbers, text, lists and dictionaries."""
    return results.document(MAP, map=contact_map, title=title)
