"""Numbers as people write them."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray


def digits(value: float, significant: int = 5) -> str:
    """Return a number with this many significant digits, without an exponent unless it is very small or large.

    Examples
    --------
    >>> digits(0.0322131), digits(20000.0), digits(1.23456789e9), digits(0.0)
    ('0.032213', '20000', '1.2346e+09', '0')
    """
    if value == 0.0 or not math.isfinite(value):
        return f"{value:g}".replace("-0", "0")
    decade = math.floor(math.log10(abs(value)))
    if not -4 <= decade < 8:
        return f"{value:.{significant - 1}e}"
    return f"{value:.{max(0, significant - 1 - decade)}f}"


def given(value: float, significant: int = 6) -> str:
    """Return an input number without insignificant zeros.

    Examples
    --------
    >>> given(9.0), given(0.000523598775598), given(207000.0), given(2.5e-7), given(57.3, 1)
    ('9', '0.000523599', '207000', '2.5e-07', '57')
    """
    mantissa, exponent, power = digits(value, significant).partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + exponent + power


def as_csv(columns: Mapping[str, NDArray[np.float64]]) -> str:
    """Return columns as CSV, their names in the first line, with ten significant digits.

    Examples
    --------
    >>> print(as_csv({"y [mm]": np.array([0.0, 0.1]), "force_y [N]": np.array([0.0, 1234.5])}), end="")
    y [mm],force_y [N]
    0,0
    0.1,1234.5
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    rows = np.transpose([np.ravel(column) for column in columns.values()]).tolist()
    writer.writerows([f"{value:.10g}" for value in row] for row in rows)
    return text.getvalue()
