"""Limits by classes: seats by ISO 286, bores and outside diameters by ISO 492, clearances by ISO 5753-1.

A class keeps a size between two limits. Sizes are assumed to be normally distributed, with six standard deviations
between the limits, and independent for different parts: the mean of a sum is in the middle of its limits, and its three
standard deviations are the root of the sum of squares of those of its parts. SKF's tables of fits list this as probable
interference, which these numbers reproduce, rounded outwards; the manual of MESYS calls it probable clearance.
"""

from __future__ import annotations

import math
import re
from bisect import bisect_left
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, ClassVar, Final

from nonhertz.errors import InputError
from nonhertz.inputs.checks import flag, one_of, positive
from nonhertz.inputs.short_repr import ShortRepr

_MICROMETRES: Final = 1e-3  # mm
_CLASS: Final = re.compile(r"([A-Za-z]+?)(\d+)")
_SHAFTS: Final = ("e", "f", "g", "h", "j", "js", "k", "m", "n", "p", "r", "s")
_HOLES: Final = ("E", "F", "G", "H", "J", "JS", "K", "M", "N", "P")
#: Classes that exist only in these grades: for others ISO 286-1 has no deviation, or a different one.
_GRADES: Final = {
    "j": (5, 6, 7), "J": (6, 7, 8), "K": (5, 6, 7, 8), "M": (5, 6, 7, 8), "N": (5, 6, 7, 8),
}  # fmt: skip
_EVERY_GRADE: Final = range(5, 11)
_OF_K: Final = 7  # up to this grade shafts k lie above their size
#: Up to this grade the upper deviations of holes are raised by the step from the previous grade.
_STEPPED: Final = {"K": 8, "M": 8, "N": 8, "P": 7}
_M6: Final = (6, 250.0, 315.0, -9.0)  # ISO 286-1: the only hole that does not follow from its shaft
#: All classes of shafts and of housings that have limits.
SHAFTS: Final = tuple(f"{letter}{grade}" for letter in _SHAFTS for grade in _GRADES.get(letter, _EVERY_GRADE))
HOUSINGS: Final = tuple(f"{letter}{grade}" for letter in _HOLES for grade in _GRADES.get(letter, _EVERY_GRADE))
TOLERANCE_CLASSES: Final = ("Normal", "6", "6X", "5")
CLEARANCE_GROUPS: Final = ("C2", "CN", "C3", "C4", "C5")
#: Tables of the clearance groups by kind of bearing.
_GROUPED: Final = {"cylindrical": "cylindrical", "needle": "cylindrical", "spherical": "spherical"}


@dataclass(frozen=True, repr=False)
class Range(ShortRepr):
    """A number that lies between limits.

    Attributes
    ----------
    least, greatest : float
        The limits.
    likely : float
        Its mean.
    spread : float
        Three standard deviations.
    """

    AT: ClassVar = ("least", "likely", "greatest")

    least: float
    likely: float
    greatest: float
    spread: float = 0.0

    @classmethod
    def between(cls, least: float, greatest: float) -> Range:
        """Return a number between the limits of a class."""
        return cls(least, 0.5 * (least + greatest), greatest, 0.5 * (greatest - least))

    @classmethod
    def exactly(cls, value: float) -> Range:
        """Return a range of a single known number."""
        return cls(value, value, value)

    @property
    def probable(self) -> tuple[float, float]:
        """Three standard deviations below and above the mean: 99.7 % lie there."""
        return self.likely - self.spread, self.likely + self.spread

    @property
    def known(self) -> bool:
        """Whether it is one number."""
        return self.least == self.greatest

    def at(self, clearance: str = "likely") -> float:
        """Return the ``"least"``, ``"likely"`` or ``"greatest"`` value."""
        one_of("clearance", clearance, self.AT, "name one of the three")
        return float(getattr(self, clearance))

    def scaled(self, factor: float) -> Range:
        """Return the range times a positive factor."""
        return Range(*(factor * value for value in (self.least, self.likely, self.greatest, self.spread)))

    def __neg__(self) -> Range:
        return Range(-self.greatest, -self.likely, -self.least, self.spread)

    def __add__(self, other: Range) -> Range:
        spread = math.hypot(self.spread, other.spread)
        return Range(self.least + other.least, self.likely + other.likely, self.greatest + other.greatest, spread)

    def __sub__(self, other: Range) -> Range:
        return self + -other


def seat_limits(fit: str, size: float) -> Range:
    """Return the deviations of a seat by a tolerance class of ISO 286.

    Parameters
    ----------
    fit : str
        The class: for shafts such as ``"k5"``, from e to s; for holes such as ``"H7"``, from E to P; grades 5 to 10.
    size : float
        Nominal diameter [mm], up to 500.

    Returns
    -------
    Range
        Lower and upper deviation [mm], and their mean.

    Raises
    ------
    InputError
        If there is no such class, or none for this size.

    Examples
    --------
    >>> k5, h7 = seat_limits("k5", 30.0), seat_limits("H7", 62.0)
    >>> (k5.least, k5.greatest), (h7.least, h7.greatest)
    ((0.002, 0.011), (0.0, 0.03))
    """
    match = _CLASS.fullmatch(fit) if isinstance(fit, str) else None
    letter, grade = (match[1], int(match[2])) if match else ("", 0)
    if letter not in (*_SHAFTS, *_HOLES):
        condition = f"be a tolerance class of ISO 286: one of {', '.join(_SHAFTS)} or {', '.join(_HOLES)} and a grade"
        raise InputError("fit", fit, condition, "write for example 'k5' for a shaft or 'H7' for a housing")
    grades = _GRADES.get(letter, _EVERY_GRADE)
    if grade not in grades:
        condition = f"have one of the grades {grades[0]} to {grades[-1]}, for which {letter} is tabulated"
        raise InputError("fit", fit, condition, "choose a grade, or give the interference in its place")
    width = _at("iso286", f"IT{grade}", size)
    if letter in ("js", "JS"):
        return _between(-0.5 * width, 0.5 * width)
    if letter in "efghEFGH":
        near = _at("iso286", letter.lower(), size)
        return _between(near - width, near) if letter.islower() else _between(-near, width - near)
    if letter.islower():
        low = _of_shaft(letter, grade, size)
        return _between(low, low + width)
    high = _of_hole(letter, grade, size)
    return _between(high - width, high)


def _of_shaft(letter: str, grade: int, size: float) -> float:
    """Return the lower deviation of a shaft j to s [um]."""
    if letter == "k" and grade > _OF_K:
        return 0.0
    name = {"j": "j7" if grade == 7 else "j5"}.get(letter, letter)
    return float(_at("iso286_fine" if letter in "rs" else "iso286", name, size))


def _of_hole(letter: str, grade: int, size: float) -> float:
    """Return the upper deviation of a hole J to P [um]."""
    if letter == "J":
        return float(_at("iso286", f"J{grade}", size))
    special, over, upto, deviation = _M6
    if letter == "M" and grade == special and over < size <= upto:
        return deviation
    stepped = grade <= _STEPPED[letter] and size > 3.0
    step = _at("iso286", f"IT{grade}", size) - _at("iso286", f"IT{grade - 1}", size) if stepped else 0.0
    return float(step - _at("iso286", letter.lower(), size))


def ring_limits(ring: str, size: float, tolerance_class: str = "Normal", *, tapered: bool = False) -> Range:
    """Return the deviations of an inner ring's mean bore, or an outer ring's mean outside diameter, by ISO 492.

    Parameters
    ----------
    ring : {"inner", "outer"}
        Which ring.
    size : float
        Nominal bore or outside diameter [mm].
    tolerance_class : {"Normal", "6", "6X", "5"}
        Class of the bearing; ``"6"`` does not exist for tapered bearings, ``"6X"`` only for these.
    tapered : bool
        Whether it is a tapered roller bearing.

    Returns
    -------
    Range
        Lower and upper deviation [mm], and their mean.

    Raises
    ------
    InputError
        If there is no such class, or none for this size.

    Examples
    --------
    >>> ring_limits("inner", 30.0).least, ring_limits("outer", 62.0, "6").least
    (-0.01, -0.011)
    """
    one_of("ring", ring, ("inner", "outer"), "name one of both")
    flag("tapered", tapered, "give True or False")
    check_class(tolerance_class, tapered=tapered)
    place = f"iso492.{ring}.{'tapered' if tapered else 'radial'}"
    name = {"inner": "bore", "outer": "outside_diameter"}[ring]
    return _between(_at(place, tolerance_class, size, name), 0.0)


def check_class(tolerance_class: str, *, tapered: bool) -> None:
    """Refuse a tolerance class that ISO 492 does not have for this kind of bearing."""
    classes = tuple(name for name in TOLERANCE_CLASSES if name != ("6" if tapered else "6X"))
    kind = "tapered" if tapered else "other"
    one_of("tolerance_class", tolerance_class, classes, f"these are the classes of {kind} bearings in ISO 492")


def clearance_limits(group: str, bore: float, kind: str = "cylindrical") -> Range:
    """Return the radial internal clearance of an unmounted bearing with a cylindrical bore by its ISO 5753-1 group.

    Parameters
    ----------
    group : {"C2", "CN", "C3", "C4", "C5"}
        The group.
    bore : float
        Nominal bore [mm].
    kind : {"cylindrical", "needle", "spherical"}
        Kind of its rollers.

    Returns
    -------
    Range
        Least and greatest clearance [mm], and their mean.

    Raises
    ------
    InputError
        If there is no such group, or none for this kind or size.

    Examples
    --------
    >>> c3 = clearance_limits("C3", 30.0)
    >>> c3.least, round(c3.likely, 4), c3.greatest
    (0.035, 0.0475, 0.06)
    """
    one_of("kind", kind, tuple(_GROUPED), "only radial roller bearings other than tapered ones have groups")
    one_of("clearance", group, CLEARANCE_GROUPS, "give a group of ISO 5753-1, or the clearance in mm")
    table = _GROUPED[kind]
    return _between(*_at(f"iso5753.{table}", group, bore, "bore"))


def _between(least: float, greatest: float) -> Range:
    return Range.between(round(_MICROMETRES * least, 6), round(_MICROMETRES * greatest, 6))


def _at(place: str, name: str, size: float, field: str = "size") -> Any:
    """Return the entry of a table for a size, in um."""
    table = _table(place)
    positive(field, size, "give the nominal diameter in mm")
    entries, at, over = table[name], bisect_left(table["sizes"], size), table.get("over", 0.0)
    if at >= len(entries) or size <= over:
        upto = table["sizes"][len(entries) - 1]
        condition = f"lie above {over:g} and up to {upto:g} mm, for which {name} is tabulated"
        raise InputError(field, size, condition, "give the number in place of the class")
    return entries[at]


@cache
def _tables() -> dict[str, Any]:
    import tomllib  # imported here: classes are rare

    return tomllib.loads(Path(__file__).with_name("classes.toml").read_text("utf-8"))


def _table(place: str) -> dict[str, Any]:
    table = _tables()
    for name in place.split("."):
        table = table[name]
    return table
