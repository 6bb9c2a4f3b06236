"""The values of a parameter that is varied: one after the other, or drawn from a distribution.

In a file and on the command line they are a text or a list:

    "0 : 40 kN : 41"            evenly from lowest to highest
    ["5 kN", "15 kN"]           these; also "5 kN, 15 kN"
    "uniform(10 um, 20 um)"     lowest, highest
    "triangular(0, 2 um, 9 um)" lowest, likeliest, highest
    "normal(80 mm, 5 um)"       mean, standard deviation; perhaps "... within 79.99 mm : 80.01 mm"
    "normal(80 mm +- 15 um)"    between the limits of a drawing: normal with these at three standard deviations
    "uniform(80 mm 0 -30 um)"   the same with an upper and a lower deviation; also triangular, likeliest in the middle
    "+- 15 um"                  uniform about the nominal value

In a distribution the word ``nominal`` stands for the value that the case has.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import format_digits
from nonhertz.errors import InputError, join_words
from nonhertz.files.paths import Parameter
from nonhertz.inputs.checks import finite, numbers, one_of
from nonhertz.inputs.units import begins_with_digits, to_unit

Array = NDArray[np.float64]

_EXAMPLES = {
    "mm": "10um:20um", "N": "5kN:40kN", "rad": "-1mrad:1mrad", "MPa": "200GPa:210GPa", "N mm": "0:5Nm", "": "0.2:0.4",
    "1/min": "0:1500rpm",
}  # fmt: skip
#: Kinds of distribution, with the names of their numbers.
DISTRIBUTIONS = {
    "normal": ("mean", "standard deviation"),
    "uniform": ("lowest", "highest"),
    "triangular": ("lowest", "likeliest", "highest"),
}
_CALL = re.compile(r"\s*([a-z]+)\s*\(([^()]*)\)\s*(?:within\s+(.*))?", re.DOTALL)
_NOMINAL = "nominal"
_DEVIATION = r"0|[+-](?:[^-+:,]|e[-+])+"
_DEVIATIONS = re.compile(rf"\s*(?:(?P<about>.*?)\s+)?(?P<one>{_DEVIATION})\s+(?P<other>{_DEVIATION})")
_PLUS_MINUS = re.compile(r"(?P<about>.*?)(?:\+-|\+/-|±)(?P<size>[^:,]+)")
AT_LIMITS = 3.0  # standard deviations: limits of a drawing in a normal distribution
_PROBABILITY_REMEDY = "give probabilities"
MOST_VALUES = 10_000
FARTHEST = 6.0  # standard deviations to which a normal distribution is checked: one sample in 10^9 is beyond


@dataclass(frozen=True)
class Distribution:
    """The distribution of a number.

    Parameters
    ----------
    kind : {"normal", "uniform", "triangular"}
    numbers : tuple of float
        Mean and standard deviation; lowest and highest; or lowest, likeliest and highest.
    within : tuple of float, optional
        For a normal distribution, the lowest and the highest value that pass inspection; others are rejected.

    Raises
    ------
    InputError
        If the kind is unknown, or the numbers do not ascend, or the standard deviation is not above zero.

    Examples
    --------
    >>> Distribution("uniform", (10.0, 20.0)).quantile([0.0, 0.25, 1.0])
    array([10. , 12.5, 20. ])
    """

    kind: str
    numbers: tuple[float, ...]
    within: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        one_of("kind", self.kind, tuple(DISTRIBUTIONS), "choose one of them")
        names = DISTRIBUTIONS[self.kind]
        if not isinstance(self.numbers, tuple) or len(self.numbers) != len(names):
            raise InputError("numbers", self.numbers, f"be {len(names)} numbers", f"give {join_words(names)}")
        for name, number in zip(names, self.numbers, strict=True):
            finite(name, number, "give a number")
        if self.kind == "normal":
            if not self.numbers[1] > 0.0:
                remedy = "give one above zero, or leave the parameter out"
                raise InputError("standard deviation", self.numbers[1], "be above zero", remedy)
        elif not (self.numbers[0] < self.numbers[-1] and list(self.numbers) == sorted(self.numbers)):
            raise InputError("numbers", self.numbers, "ascend", f"give {join_words(names)}")
        if self.within is not None:
            self._check_within()

    def _check_within(self) -> None:
        if not isinstance(self.within, tuple) or len(self.within) != 2:
            raise InputError("within", self.within, "be two numbers", "give lowest and highest")
        for number in self.within:
            finite("within", number, "give lowest and highest")
        low, high = self.within
        if self.kind != "normal":
            raise InputError("within", self.within, "belong to a normal distribution", "leave it out")
        mean, deviation = self.numbers
        if not (low < high and low < mean + FARTHEST * deviation and high > mean - FARTHEST * deviation):
            remedy = "give lowest and highest within a few standard deviations of the mean"
            raise InputError("within", self.within, "ascend and include part of the distribution", remedy)

    def quantile(self, probability: ArrayLike) -> Array:
        """Return quantiles: the values below which a number lies with some probability.

        Parameters
        ----------
        probability : array_like
            From 0 to 1.

        Raises
        ------
        InputError
            If a probability lies outside.
        """
        u = numbers("probability", probability, _PROBABILITY_REMEDY)
        if not np.all((u >= 0.0) & (u <= 1.0)):
            raise InputError("probability", probability, "lie between 0 and 1", _PROBABILITY_REMEDY)
        from scipy import stats

        first, last = self.numbers[0], self.numbers[-1]
        if self.kind == "uniform":
            values = stats.uniform.ppf(u, first, last - first)
        elif self.kind == "triangular":
            values = stats.triang.ppf(u, (self.numbers[1] - first) / (last - first), first, last - first)
        elif self.within is None:
            values = stats.norm.ppf(u, first, last)
        else:
            limits = ((end - first) / last for end in self.within)
            values = np.clip(stats.truncnorm.ppf(u, *limits, first, last), *self.within)
        return np.asarray(values)

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest value; of a normal distribution without limits, those that one sample in 10^9 exceeds."""
        if self.kind != "normal":
            return self.numbers[0], self.numbers[-1]
        mean, deviation = self.numbers
        low, high = self.within or (-np.inf, np.inf)
        return float(max(low, mean - FARTHEST * deviation)), float(min(high, mean + FARTHEST * deviation))


#: Values one after the other, or a distribution.
Spread = tuple[Any, ...] | Distribution


def parse_spread(parameter: Parameter, value: Any, document: Mapping[str, Any]) -> Spread:
    """Return the values of a parameter in its base unit, or its distribution.

    Parameters
    ----------
    parameter : Parameter
        The parameter that is varied.
    value : object
        A text or a list as above, an array of numbers, or a `Distribution`.
    document : mapping
        The document of the file, for nominal values.

    Raises
    ------
    InputError
        If it is neither, or empty.
    """
    if isinstance(value, Distribution):
        if parameter.unit is None:
            remedy = "write a list of words, such as ['one', 'other']"
            raise InputError(parameter.path, value, "be a list, because it is not a number", remedy)
        return value
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, str):
        return _parse_text(parameter, value, document)
    if not isinstance(value, list | tuple) or not value:
        remedy = "write a list, a range such as '0 : 40 kN : 41', or a distribution such as 'normal(80 mm, 5 um)'"
        raise InputError(parameter.path, value, "hold values", remedy)
    if len(value) > MOST_VALUES:
        remedy = "write fewer, or a distribution to draw from"
        raise InputError(parameter.path, f"{len(value)} values", f"have {MOST_VALUES} values at most", remedy)
    return tuple(_parse_entry(parameter, entry) for entry in value)


def _parse_text(parameter: Parameter, text: str, document: Mapping[str, Any]) -> Spread:
    """Return the distribution, the steps or the list of values in a text."""
    bare = parameter.unit is not None and (_PLUS_MINUS.fullmatch(text) or _DEVIATIONS.fullmatch(text))
    called = _CALL.fullmatch(f"uniform({text})" if bare and "(" not in text else text)
    if called is not None:
        return _parse_distribution(parameter, text, called, document)
    words = list(map(str.strip, text.split(",")))
    if parameter.unit is None:
        # A text of words is always a list; words have no commas.
        return tuple({"true": True, "false": False}.get(word, word) for word in words)
    if ":" in text:
        return _parse_steps(parameter, text)
    return tuple(_parse_value(parameter, word, bare=True) for word in words)


def parse_bounds(parameter: Parameter, value: Any) -> tuple[float, float]:
    """Return the lowest and the highest value that a parameter may take.

    Raises
    ------
    InputError
        If it is not a range.
    """
    if parameter.unit is None or parameter.whole:
        raise InputError(parameter.path, value, "be a number that can change gradually", "sweep over its values")
    if isinstance(value, str):
        low, high, count = parse_range(parameter.path, value, parameter.unit, _example(parameter))
        if count is not None:
            raise InputError(parameter.path, value, "be a range without a number of values", "leave the number out")
        return low, high
    if not isinstance(value, Sequence) or len(value) != 2:
        remedy = f"write lowest and highest, such as '{_example(parameter)}'"
        raise InputError(parameter.path, value, "be a range", remedy)
    low, high = (_parse_entry(parameter, entry) for entry in value)
    if not low < high:
        raise InputError(parameter.path, value, "ascend", "give lowest and highest")
    return float(low), float(high)


def parse_range(field: str, text: str, unit: str, example: str) -> tuple[float, float, int | None]:
    """Return the range in a text: lowest, highest, and the number of values or None.

    Parameters
    ----------
    field : str
        Name of the input, for the message.
    text : str
        Lowest and highest with units, optionally the number of values, separated by colons. Zero needs no unit.
    unit : str
        As for `nonhertz.inputs.units.to_unit`.
    example : str
        A range without a count, for the message.

    Raises
    ------
    InputError
        If the text is not a range, is empty, or has too many values.

    Examples
    --------
    >>> parse_range("load", "0 : 40 kN : 41", "N", "0:40kN")
    (0.0, 40000.0, 41)
    """
    parts = text.split(":")
    what = "with units, such as" if unit else "such as"
    remedy = f"write lowest and highest {what} {example}, optionally with the number of values, {example}:21"
    if len(parts) not in {2, 3}:
        raise InputError(field, text, "be a range", remedy)
    low, high = (parse_number(field, part, unit) for part in parts[:2])
    if not low < high:
        condition = f"ascend, not go from {format_digits(low)} to {format_digits(high)} {unit}".rstrip()
        raise InputError(field, text, condition, remedy)
    if len(parts) == 2:
        return low, high, None
    count = parts[2].strip()
    if not count.isascii() or not count.isdigit() or not 2 <= int(count[:9]) <= MOST_VALUES:
        raise InputError(field, text, f"have a whole number from 2 to {MOST_VALUES} as its third part", remedy)
    return low, high, int(count)


def parse_number(field: str, text: str, unit: str) -> float:
    """Return a quantity that is written without quotes, in a unit; zero and plain numbers need none.

    Raises
    ------
    InputError
        If it is not such a quantity.
    """
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if number == 0.0:
        return 0.0
    if unit == "":
        if not math.isfinite(number):
            raise InputError(field, text.strip(), "be a plain number", "write it without a unit")
        return number
    try:
        return float(to_unit(field, text, unit))
    except InputError as error:
        # Nothing is in quotes here.
        remedy = f"append a unit, such as {text.strip()}{'mrad' if unit == 'rad' else unit}"
        raise InputError(
            field, text, error.condition, remedy if error.condition == "have a unit" else error.remedy
        ) from None


def _parse_entry(parameter: Parameter, value: Any) -> Any:
    """Return an entry of a list in the base unit; zero needs no unit, even in quotes."""
    return _parse_value(parameter, value, bare=parameter.unit not in {None, ""})


def _parse_value(parameter: Parameter, written: Any, *, bare: bool) -> Any:
    """Return a single value in the base unit; words and switches unchanged, for the file's own checks.

    ``bare`` is a text without quotes of its own.
    """
    if isinstance(written, bool):
        return written
    is_text = isinstance(written, str)
    if parameter.unit is None:
        if not is_text:
            raise InputError(parameter.path, written, "be a word, or true or false", "give the path of a single value")
        return written
    if is_text and not begins_with_digits(written):
        return written
    value = (parse_number if bare and is_text else to_unit)(parameter.path, written, parameter.unit)
    finite(parameter.path, value, "give a number")
    return int(value) if parameter.whole and value == int(value) else value


def _parse_steps(parameter: Parameter, text: str) -> tuple[float, ...]:
    assert parameter.unit is not None
    example = _example(parameter)
    low, high, count = parse_range(parameter.path, text, parameter.unit, example)
    if count is None:
        raise InputError(parameter.path, text, "have a number of values", f"append it, such as {example}:21")
    values = np.linspace(low, high, count).tolist()
    if parameter.whole and any(value != int(value) for value in values):
        remedy = "choose a number of values that divides the range, or write a list"
        raise InputError(parameter.path, text, "step through whole numbers", remedy)
    return tuple(int(value) if parameter.whole else value for value in values)


def _example(parameter: Parameter) -> str:
    return _EXAMPLES.get(parameter.unit or "", f"1 {parameter.unit}:2 {parameter.unit}")


def _parse_distribution(
    parameter: Parameter, text: str, called: re.Match[str], document: Mapping[str, Any]
) -> Distribution:
    """Return the distribution in a text such as ``"normal(80 mm, 5 um)"``."""
    kind, inside, limits = called.groups()
    if parameter.unit is None or parameter.whole:
        raise InputError(parameter.path, text, "be a list, because it cannot change gradually", "write one")
    if kind not in DISTRIBUTIONS:
        raise InputError(parameter.path, text, f"be one of {', '.join(DISTRIBUTIONS)}", "choose one of them")
    names = DISTRIBUTIONS[kind]
    parts = inside.split(",")
    if (limits_of_drawing := _parse_limits(parameter, inside, document)) is not None:
        low, high = limits_of_drawing
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        by_kind: dict[str, tuple[float, ...]] = {"normal": (middle, half / AT_LIMITS), "uniform": (low, high)}
        given_numbers = by_kind.get(kind, (low, middle, high))
    elif len(parts) != len(names):
        remedy = f"write {kind}({', '.join(names)}), or {kind}(nominal +- tolerance)"
        raise InputError(parameter.path, text, f"have {len(names)} numbers", remedy)
    else:
        given_numbers = tuple(_number(parameter, part, document) for part in parts)
    within = None if limits is None else parse_range(parameter.path, limits, parameter.unit, _example(parameter))[:2]
    try:
        return Distribution(kind, given_numbers, within)
    except InputError as error:
        named = {"numbers": "have numbers that", "within": "have limits that"}.get(error.field, f"have a {error.field}")
        raise InputError(parameter.path, text, f"{named} {error.condition.removeprefix('be ')}", error.remedy) from None


def _parse_limits(parameter: Parameter, text: str, document: Mapping[str, Any]) -> tuple[float, float] | None:
    """Return the limits of a text such as ``"80 mm +- 5 um"`` or ``"80 mm +12 um +1 um"``; None if it has none."""
    assert parameter.unit is not None
    if about := _PLUS_MINUS.fullmatch(text):
        size = parse_number(parameter.path, about["size"], parameter.unit)
        deviations = [-size, size]
    elif about := _DEVIATIONS.fullmatch(text):
        words = (about[name].replace("+", "", 1) for name in ("one", "other"))
        deviations = sorted(parse_number(parameter.path, word, parameter.unit) for word in words)
    else:
        return None
    centre = _number(parameter, (about["about"] or "").strip() or _NOMINAL, document)
    return centre + deviations[0], centre + deviations[1]


def _number(parameter: Parameter, text: str, document: Mapping[str, Any]) -> float:
    assert parameter.unit is not None
    if text.strip() != _NOMINAL:
        return parse_number(parameter.path, text, parameter.unit)
    value = parameter.value_in(document)
    number = to_unit(parameter.path, value, parameter.unit) if value is not None else None
    if not isinstance(number, float):
        remedy = "give the number itself"
        raise InputError(parameter.path, text.strip(), "refer to a number that the case gives", remedy)
    return number
