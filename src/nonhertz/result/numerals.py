"""Numbers as people write them."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ROUNDING = 1e-12  # relative: a prescribed load, say, is met to that
_SMALL = 0.5  # mm, below which people read micrometres
_SAME = 1e-6  # relative: less than five digits show


def digits(value: float, significant: int = 5) -> str:
    """Return a number with this many significant digits, without an exponent unless it is very small or large.

    Examples
    --------
    >>> digits(0.0322131), digits(20000.0), digits(0.999999), digits(1.23456789e9), digits(0.0)
    ('0.032213', '20000', '1.0000', '1.2346e+09', '0')
    """
    if value == 0.0 or not math.isfinite(value):
        return f"{value:g}".replace("-0", "0")
    # That of the rounded number: 0.999999 has one digit before the point.
    decade = int(f"{value:.{significant - 1}e}".partition("e")[2])
    if not -4 <= decade < 8:
        return f"{value:.{significant - 1}e}"
    return f"{value:.{max(0, significant - 1 - decade)}f}"


def in_column(values: Iterable[float], significant: int = 5) -> list[str]:
    """Return numbers that stand below one another: with the decimals that suit the largest of them.

    Examples
    --------
    >>> in_column([3.80971, 0.903454, 0.0018632, 0.0])
    ['3.8097', '0.9035', '0.0019', '0']
    """
    values = tuple(values)
    largest = digits(max(map(abs, values), default=0.0), significant)
    if "e" in largest:
        return [digits(value, significant) for value in values]
    decimals = len(largest.partition(".")[2])
    return [f"{value:.{decimals}f}" if value else "0" for value in values]


def given(value: float, significant: int = 6) -> str:
    """Return an input number without insignificant zeros.

    Examples
    --------
    >>> given(9.0), given(0.000523598775598), given(207000.0), given(2.5e-7), given(57.3, 1)
    ('9', '0.000523599', '207000', '2.5e-07', '57')
    """
    mantissa, exponent, power = digits(value, significant).partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + exponent + power


def given_sized(value: float, unit: str, significant: int = 6) -> str:
    """Return an input number without insignificant zeros, in the unit that suits its size.

    Examples
    --------
    >>> given_sized(20000.0, "N"), given_sized(820.0, "N"), given_sized(1500.0, "N mm"), given_sized(30.0, "um")
    ('20 kN', '820 N', '1.5 N m', '30 um')
    """
    factor, unit = unit_for((value,), unit)
    return f"{given(factor * value, significant)} {unit}"


#: Units a thousand times as large in which people write large numbers of these, and from which value on.
_LARGER = {"N": (1e3, "kN"), "N mm": (1e3, "N m")}


def sized(value: float, unit: str) -> str:
    """Return a number with its unit, a force in kN and a moment in N m where it is large.

    Examples
    --------
    >>> sized(20000.0, "N"), sized(820.0, "N"), sized(-15.8e3, "N mm"), sized(2086.34, "MPa")
    ('20.000 kN', '820.00 N', '-15.800 N m', '2086.3 MPa')
    """
    return sized_list((value,), unit)


def sized_list(values: Iterable[float], unit: str, between: str = ", ", significant: int = 5) -> str:
    """Return several numbers with the unit that suits the largest of them.

    Examples
    --------
    >>> sized_list((0.0, 20000.0, -310.0), "N"), sized_list((820.0, 830.0), "N", " and ", 3)
    ('0, 20.000, -0.31000 kN', '820 and 830 N')
    """
    values = tuple(values)
    factor, unit = unit_for(values, unit)
    return f"{between.join(digits(factor * value, significant) for value in values)} {unit}".rstrip()


def unit_for(values: Iterable[float], unit: str) -> tuple[float, str]:
    """Return the unit in which people write numbers of which the largest is so large, and what turns them into it.

    Examples
    --------
    >>> unit_for((0.0, 20000.0), "N"), unit_for((820.0,), "N"), unit_for((1e9,), "MPa")
    ((0.001, 'kN'), (1.0, 'N'), (1.0, 'MPa'))
    """
    least, larger = _LARGER.get(unit, (math.inf, unit))
    # Whether a load of one kN is met to the last digit must not choose its unit.
    largest = (1.0 + _SAME) * max(map(abs, values), default=0.0)
    return (1.0, unit) if largest < least else (1e-3, larger)


def unit_of_dimension(values: Iterable[float], unit: str) -> tuple[float, str]:
    """Return the unit in which people write dimensions, angles and loads of this size, and what turns them into it.

    Examples
    --------
    >>> unit_of_dimension((0.012,), "mm"), unit_of_dimension((20.0, 0.1), "mm"), unit_of_dimension((1e-3,), "rad")
    ((1000.0, 'um'), (1.0, 'mm'), (1000.0, 'mrad'))
    """
    values = tuple(values)
    if unit == "mm" and max(map(abs, values)) < _SMALL:
        return 1e3, "um"
    return (1e3, "mrad") if unit == "rad" else unit_for(values, unit)


def with_error(value: float, error: float) -> str:
    """Return a number with its standard error, both to the second digit of that.

    Examples
    --------
    >>> with_error(4361.8, 1034.0), with_error(0.0123456, 0.000789), with_error(12.0, 0.0)
    ('4400 +- 1000', '0.01235 +- 0.00079', '12.000 +- 0')
    """
    if not (math.isfinite(error) and error > 0.0):
        return f"{digits(value)} +- {digits(error)}"
    place = 1 - math.floor(math.log10(error))
    shown = [f"{round(each, place):.{max(place, 0)}f}" for each in (value, error)]
    return " +- ".join(shown)


def error_words(relative: float) -> str:
    """Return words about an estimated relative error; none where it is only rounding.

    Examples
    --------
    >>> error_words(0.0042), error_words(0.53), error_words(1.7), error_words(1e-15), error_words(math.inf)
    ('error about 0.4 %', 'error about 50 %', 'error as large as the number', '', 'error unknown')
    """
    if not math.isfinite(relative):
        return "error unknown"
    if relative >= 1.0:
        return "error as large as the number"
    return f"error about {given(float(f'{100.0 * relative:.1g}'), 1)} %" if relative > _ROUNDING else ""


def as_csv(columns: Mapping[str, NDArray[np.float64]]) -> str:
    """Return columns as CSV, their names in the first line, with ten significant digits.

    Examples
    --------
    >>> print(as_csv({"y [mm]": np.array([0.0, 0.1]), "force_y [N]": np.array([0.0, 1234.5])}), end="")
    y [mm],force_y [N]
    0,0
    0.1,1234.5
    """
    rows = np.transpose([np.ravel(column) for column in columns.values()]).tolist()
    return csv_text(columns, ([f"{value:.10g}" for value in row] for row in rows))


def csv_text(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> str:
    """Return a table as CSV; None is an empty cell, and numbers have all their digits.

    Examples
    --------
    >>> print(csv_text(["title", "load [N]"], [["a, b", 20000.0], ["c", None]]), end="")
    title,load [N]
    "a, b",20000.0
    c,
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()
