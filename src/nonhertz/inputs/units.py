"""Quantities as users write them: a number, or text such as ``"0.5 mrad"``, converted to a number in base units.

Everything inside the package is in mm, N, MPa and rad, speeds in 1/min. Only this module knows other units: the most
common ones itself, all others through pint, which takes a third of a second to import and is imported only for those.
Text is parsed here and pint gets only the unit, because pint's own parser evaluates arithmetic and would work for hours
on ``"9**9**9 mm"``.
"""

from __future__ import annotations

import contextlib
import functools
import math
import re
from typing import TYPE_CHECKING, Any

from nonhertz.errors import InputError

if TYPE_CHECKING:
    import pint

_KINDS = {
    "mm": ("length", "20 mm"),
    "N": ("force", "20 kN"),
    "MPa": ("stress", "207 GPa"),
    "1/MPa": ("inverse stress", "2.8e-6 1/MPa"),
    "rad": ("angle", "0.5 mrad' or '8 um/25 mm"),
    "N mm": ("moment", "5 N m"),
    "1/min": ("speed", "1500 1/min' or '1500 rpm"),
    "mm^2/s": ("viscosity", "20 mm^2/s"),
    "mPa s": ("dynamic viscosity", "20 mPa s"),
    "t/mm^3": ("density", "7850 kg/m^3"),
}
_BEGINNING = re.compile(r"\s*[-+]?\.?\d")
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_QUANTITY = re.compile(rf"\s*({_NUMBER})\s*(.*?)\s*", re.DOTALL)
_FACTOR = r"(?:[A-Za-zµμ°%]+(?:(?:\^|\*\*)?-?[1-9]|[²³])?)"
_UNIT = re.compile(rf"(?:1\s*/\s*|/\s*)?{_FACTOR}(?:(?:\s*[*·/]\s*|\s+){_FACTOR})*")
# The slope of a line as on drawings: a rise over a length.
_SLOPE = re.compile(rf"\s*({_NUMBER})\s*({_FACTOR})\s*/\s*(?:({_NUMBER})\s*)?({_FACTOR})\s*")
_DECIMAL_COMMA = re.compile(r"\s*[-+]?\d+,\d")
_LONGEST = 40
# Factors of the most common units, equal to pint's to the last bit.
_KNOWN = {
    "mm": {"mm": 1.0, "um": 1e-3, "µm": 1e-3, "m": 1e3},
    "N": {"N": 1.0, "kN": 1e3},
    "MPa": {"MPa": 1.0, "GPa": 1e3},
    "rad": {"rad": 1.0, "mrad": 1e-3, "deg": math.pi / 180.0},
    "N mm": {"N mm": 1.0, "N m": 1e3},
    "1/min": {"1/min": 1.0, "rpm": 1.0},
    "mm^2/s": {"mm^2/s": 1.0},
}
# Units probably meant by the same letters in another case, or by a mass given for a force.
_USUAL = (
    "N", "kN", "MN", "N m", "Nm", "N mm", "Nmm", "kN m", "MPa", "GPa", "mm", "um", "rad", "mrad", "deg", "Hz", "rpm",
    "Msi", "psi", "cSt",
)  # fmt: skip
_TONS = ("tonf", "ton", "tons")  # 1000 kgf, 2000 lbf or 2240 lbf
_USUAL_DENSITY = 0.87  # g/cm^3, of mineral oil
_MEANT = {unit.lower(): unit for unit in _USUAL} | {"lb": "lbf", "lbs": "lbf", "kg": "kgf", "t": "tf"}
# To pint "Nm" is a measure of yarn and "Nmm" is unknown; on drawings both are moments. "mPas" is used for oils.
_RUN_TOGETHER = re.compile(r"\b(?:([kM]?N)(?=(?:m|cm|mm)\b)|(m?Pa)(?=s\b))")
# Revolutions as ISO writes them; pint knows neither.
_TURN = re.compile(r"\br(?:ev)?\b")
# A thousandth of an inch; to pint one of three angular mils.
_MIL = re.compile(r"\bmils?\b")
_BARE_EXPONENT = re.compile(r"(?<=[A-Za-zµμ])(-?\d)")


def split_quantity(text: str) -> tuple[str, str] | None:
    """Return number and unit of text such as ``"0.5 mrad"``, as they are written; None if one of them is missing.

    Examples
    --------
    >>> split_quantity("0.5 mrad"), split_quantity("20"), split_quantity("auto")
    (('0.5', 'mrad'), None, None)
    """
    match = _QUANTITY.fullmatch(text)
    return (match[1], match[2]) if match and match[2] else None


def to_unit(field: str, value: Any, unit: str) -> Any:
    """Return a quantity as a number in ``unit``.

    Parameters
    ----------
    field : str
        Name of the input, for the message.
    value : object
        A number, already in ``unit``, or text with a number and a unit. An angle may also be text of one length over
        another, its tangent. Anything else is returned unchanged; the model refuses it in its own words.
    unit : str
        ``"mm"``, ``"N"``, ``"MPa"``, ``"1/MPa"``, ``"rad"``, ``"N mm"``, ``"1/min"``, ``"mm^2/s"``, ``"t/mm^3"``, or
        ``""`` for a plain number.

    Returns
    -------
    object
        A float if ``value`` is a number or text.

    Raises
    ------
    InputError
        If the text is not a quantity, or has no unit or one of another dimension. A number in quotes without a unit
        is also refused: quotes suggest that a unit was meant, and a wrong guess would go unnoticed.

    Examples
    --------
    >>> to_unit("tilt", 0.0005, "rad")
    0.0005
    >>> to_unit("tilt", "0.5 mrad", "rad")
    0.0005
    >>> to_unit("moment", "5 N m", "N mm")
    5000.0
    >>> to_unit("angle", "25 mm/25 mm", "rad") == math.atan(1.0)
    True
    >>> to_unit("speed", "1500 rpm", "1/min"), to_unit("speed", "25 Hz", "1/min")
    (1500.0, 1500.0)
    """
    if isinstance(value, bool):
        return value
    if isinstance(value, int):
        try:
            return float(value)
        except OverflowError:
            return math.inf if value > 0 else -math.inf
    if not isinstance(value, str):
        return value
    if unit == "":
        raise InputError(field, value, "be a plain number", "write it without quotes and without a unit")
    try:
        return _convert(field, value, unit)
    except ModuleNotFoundError:  # pint is an extra
        condition = f"be a plain number in {unit} where pint, which reads units, is not installed"
        raise InputError(field, value, condition, "give the number, or install it: pip install pint") from None


def begins_with_digits(text: str) -> bool:
    """Return whether a text is meant as a number, with or without a unit, rather than as a word.

    Examples
    --------
    >>> begins_with_digits("8 mm"), begins_with_digits("plane-strain")
    (True, False)
    """
    return _BEGINNING.match(text) is not None


def _convert(field: str, text: str, unit: str) -> float:
    kind, example = _KINDS[unit]
    remedy = f"write a number in {unit}, or text with a unit of {kind} such as '{example}'"
    if _DECIMAL_COMMA.match(text):
        raise InputError(field, text, "have a decimal point", f"write {text.strip().replace(',', '.', 1)}")
    slope = _slope(field, text) if unit == "rad" else None
    if slope is not None:
        return math.atan(slope)
    taken_apart = _QUANTITY.fullmatch(text)
    if taken_apart is None:
        raise InputError(field, text, "be a number with a unit", remedy)
    number, written = float(taken_apart[1]), taken_apart[2]
    if not written:
        raise InputError(field, text, "have a unit", f"write {taken_apart[1]} without quotes if it is in {unit}")
    try:
        factor = _factor(written, unit)
    except ValueError as error:
        condition, meant = str(error), _MEANT.get(written.lower(), written)
        with contextlib.suppress(ValueError):
            _factor(meant, unit)
            remedy = f"write {taken_apart[1]} {meant}"
        if unit == "N" and written in _TONS:
            condition = "have a unit of one meaning"
            remedy = f"write {number:g} tf for tonnes, {2e3 * number:g} lbf for short, {2240 * number:g} for long tons"
        if unit == "mm^2/s":
            with contextlib.suppress(ValueError):
                kinematic = _times(number, _factor(written, "mPa s")) / _USUAL_DENSITY
                condition = "be a kinematic viscosity"
                remedy = f"divide by the oil's density: {_USUAL_DENSITY} g/cm^3 would give '{kinematic:.4g} mm^2/s'"
        raise InputError(field, text, condition, remedy) from None
    return _times(number, factor)


def _slope(field: str, text: str) -> float | None:
    """Return the ratio of two lengths written as a quotient; None if the text is not one."""
    taken_apart = _SLOPE.fullmatch(text)
    if taken_apart is None:
        return None
    rise, risen, run, along = taken_apart.groups(default="1")
    try:
        height, length = (_times(float(number), _factor(unit, "mm")) for number, unit in ((rise, risen), (run, along)))
    except ValueError:  # not lengths
        return None
    if length <= 0.0:
        raise InputError(field, text, "divide by a length above zero", "write a rise over a length")
    return height / length


def _times(number: float, factor: float) -> float:
    # Dividing where the factor is below one gives exactly 0.0001 for "0.1 um"; multiplying would not.
    inverse = 1.0 / factor
    return number / round(inverse) if factor < 1.0 and round(inverse) * factor == 1.0 else number * factor


@functools.lru_cache(maxsize=256)
def _factor(written: str, unit: str) -> float:
    """Return how many ``unit`` make one ``written``; a ValueError holds the condition that the quantity must meet."""
    if written in _KNOWN.get(unit, ()):
        return _KNOWN[unit][written]
    if len(written) > _LONGEST or _UNIT.fullmatch(written) is None:
        raise ValueError("be a number with a unit")
    import pint

    spelled = _RUN_TOGETHER.sub(r"\g<0> ", written)
    spelled = _BARE_EXPONENT.sub(r"^\1", spelled.replace("**", "^"))
    spelled = "1" + spelled if spelled.startswith("/") else spelled
    if unit == "rad" and _MIL.search(spelled):
        raise ValueError("have a unit of angle, and a mil is a thousandth of an inch")
    spelled = _MIL.sub("thou", spelled)
    if unit == "1/min":
        spelled = _TURN.sub("turn", spelled)
    try:
        quantity = _registry().Quantity(1.0, _registry().parse_units(spelled))
        # To pint an angle is a number and 1/min means radians per minute: revolutions are converted to revolutions.
        turning = unit == "1/min" and "radian" in str(quantity.to_root_units().units)
        unit_there = "turn/min" if turning else unit
        factor = float(quantity.to(unit_there).magnitude)
        # Degrees Celsius and decibels cannot be converted by a factor.
        linear = math.isclose(float((2.0 * quantity).to(unit_there).magnitude), 2.0 * factor)
    except pint.UndefinedUnitError:
        raise ValueError("have a known unit") from None
    except (pint.PintError, ValueError, TypeError, AssertionError, ArithmeticError, LookupError):
        linear = False
    if not linear:
        raise ValueError(f"have a unit of {_KINDS[unit][0]}")
    return factor


@functools.cache
def _registry() -> pint.UnitRegistry[float]:
    import pint

    known: pint.UnitRegistry[float] = pint.UnitRegistry()
    known.define("megapound_force_per_square_inch = 1e6 * psi = Msi")
    known.define("kilopond = kilogram_force = kp")
    return known
