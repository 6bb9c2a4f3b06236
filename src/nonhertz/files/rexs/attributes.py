"""The table of REXS attributes and the keys of bearing files and results, for reader, writer and reference.

REXS has u along the axis, v towards the first roller and w; here these are x, y and z.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from typing import Any, Final

from nonhertz.errors import InputError
from nonhertz.files.rexs.model import Attributes

BEARING: Final = "rolling_bearing_with_detailed_geometry"
CATALOGUE: Final = "rolling_bearing_with_catalog_geometry"
ROW, ROLLER, CONTACT = "rolling_bearing_row", "rolling_element", "rolling_element_contact"
MATERIAL, OIL, GEAR_UNIT = "material", "lubricant", "gear_unit"
_COMPONENTS: Final = {
    "bearing": BEARING, "row": ROW, "roller": ROLLER, "contact": CONTACT, "material": MATERIAL, "oil": OIL,
    "gear_unit": GEAR_UNIT,
}  # fmt: skip
#: The parts of a bearing file without an attribute, as JSON; and the loads and displacements that are prescribed.
REST, PRESCRIBED = "custom_nonhertz_bearing_file", "custom_nonhertz_prescribed"
#: Sizes of the units of REXS in those of bearing files.
UNITS: Final = dict.fromkeys(("", "none", "mm", "rad", "N", "N / mm^2", "MPa", "N / rad", "N mm / rad"), 1.0) | {
    "1 / min": 1.0, "Hz": 1.0, "h": 1.0, "C": 1.0, "mm^2 / s": 1.0, "mum": 1e-3, "kN": 1e3, "N m": 1e3, "%": 1e-2,
    "N / m": 1e-3, "deg": math.pi / 180.0, "°": math.pi / 180.0,
}  # fmt: skip
#: The words of kinds, the first of which is written; other kinds are refused.
TYPES: Final = {
    "cylindrical": ("radial_roller_bearing",),
    "needle": ("radial_needle_roller_bearing",),
    "tapered": ("radial_tapered_roller_bearing",),
    "spherical": ("radial_self_aligning_roller_bearing", "radial_spherical_roller_bearing"),
    "thrust": ("axial_roller_bearing", "axial_needle_roller_bearing"),
}
_LETTERS: Final = dict(zip("cntsa", TYPES, strict=True))
#: Classes of ISO 492 and groups of ISO 5753-1 in REXS; those of seats, ISO 286, have the same names.
CLASS_WORDS: Final = {"Normal": "P0", "6": "P6", "5": "P5", "CN": "C0"}
#: The duration of a load case: in REXS, and as the share of revolutions in bearing files.
TIME_SHARE, REVOLUTION_SHARE = "operating_time_fraction", "custom_nonhertz_share_of_revolutions"
#: Loads and displacements with two axes, and the axis of a single number.
PAIRS: Final = {"radial": 0, "radial_displacement": 0, "moment": 1, "tilt": 1}
#: By whether the inner ring supports axial loads along +u and along -u.
DIRECTIONS: Final = {
    (False, False): "no_direction",
    (True, False): "positive",
    (False, True): "negative",
    (True, True): "both_directions",
}


@dataclass(frozen=True)
class Attribute:
    """A line of the table.

    Attributes
    ----------
    component, ids, unit : str, tuple of str, str
        Its component type, its names, the first of which is written, and its unit.
    sign : int
        -1 if it has the opposite sign.
    key, value : str
        Dotted paths in a bearing file, and in the data of the writer.
    kinds : frozenset of str
        Kinds of bearings that have it.
    """

    component: str
    ids: tuple[str, ...]
    unit: str
    sign: int
    key: str
    value: str
    kinds: frozenset[str]

    @property
    def id(self) -> str:
        """The name that is written."""
        return self.ids[0]

    @property
    def size(self) -> float:
        """Its unit in that of a bearing file, with the sign."""
        return self.sign * UNITS[self.unit]

    def number(self, attributes: Attributes) -> float | None:
        """Return its number among attributes in the unit of a bearing file; None if it is missing or empty."""
        number = number_of(attributes, self.unit, *self.ids)
        return None if number is None else self.sign * number

    def of(self, known: Any) -> Any:
        """Return its value in the data of the writer; None if a part of the path is None."""
        for name in self.value.split("."):
            known = known.get(name) if isinstance(known, Mapping) else getattr(known, name)
            if known is None:
                return None
        return known


def word_of(attributes: Attributes, name: str) -> str:
    """Return an attribute as a word; empty if it is missing."""
    return str(attributes.get(name, ("", ""))[0] or "")


def number_of(attributes: Attributes, unit: str, *names: str) -> float | None:
    """Return the first attribute of these names in units of a bearing file; None if it is missing or empty.

    Raises
    ------
    InputError
        If it is not a number, or in an unknown unit.
    """
    name = next((entry for entry in names if entry in attributes), "")
    value, stated = attributes.get(name, (None, ""))
    if value is None or value == "":
        return None
    return _size(name, stated, unit) * _finite(name, value)


def array_of(attributes: Attributes, unit: str, name: str) -> list[float]:
    """Return an array in units of a bearing file, empty if it is missing; raises as `number_of`."""
    values, stated = attributes.get(name, ([], ""))
    size = _size(name, stated, unit)
    return [size * _finite(name, value) for value in (values if isinstance(values, list) else [values])]


def _size(name: str, stated: str, unit: str) -> float:
    # A number without a unit is in that of REXS.
    size = UNITS.get(unit if stated in ("", "none") else stated)
    if size is None:
        raise InputError(f"the unit of {name}", stated, f"be {unit}", "correct it in the file")
    return size


def _finite(name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number):
        raise InputError(name, str(value)[:40], "be a number", "correct it in the file")
    return number


def lines() -> list[dict[str, str]]:
    """Return the lines of the table as texts."""
    text = resources.files(__package__).joinpath("attributes.csv").read_text(encoding="utf-8")
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def _attributes(use: str) -> tuple[Attribute, ...]:
    return tuple(
        Attribute(
            _COMPONENTS[line["component"]], tuple(line["attribute"].split("|")), line["unit"], int(line["sign"]),
            line["key"], line["value"], frozenset(_LETTERS[letter] for letter in line["kinds"] or _LETTERS),
        )
        for line in lines() if line["use"] == use
    )  # fmt: skip


EXCHANGED, CLASSES, LOADS, REACTIONS, SPEEDS, RESULTS, CONTACTS, PROFILE = map(
    _attributes, ("exchange", "class", "load", "reaction", "speed", "result", "contact", "profile")
)
