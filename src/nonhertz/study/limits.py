"""Limits of quantities, and samples compared with them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.files.spreads import parse_number
from nonhertz.inputs.descriptions import unknown_key_error
from nonhertz.result.quantities import Quantity

CERTAINTY = 0.95


@dataclass(frozen=True)
class Limit:
    """The limits of a quantity.

    Attributes
    ----------
    name : str
        The quantity of a solution.
    most : float or None
        At most this, in its base unit.
    least : float or None
        At least this.
    """

    name: str
    most: float | None = None
    least: float | None = None

    @property
    def sides(self) -> list[tuple[float, float]]:
        """The bounds, each with the sign of the direction beyond it."""
        return [(sign, bound) for sign, bound in ((-1.0, self.most), (1.0, self.least)) if bound is not None]


def limits_in(limits: Mapping[str, Any], known: Mapping[str, Quantity]) -> tuple[Limit, ...]:
    """Return limits of texts such as ``"at most 30 um"``, by quantity.

    Parameters
    ----------
    limits : mapping of str to str or Limit
        Texts, or limits as they are.
    known : mapping of str to Quantity
        The quantities that may have one.

    Raises
    ------
    InputError
        If there is no such quantity, or the text is not a limit.
    """
    checked = []
    for name, text in limits.items():
        if name not in known:
            raise unknown_key_error(str(name), text, known, "quantity")
        if isinstance(text, Limit):
            checked.append(text)
            continue
        kind = next((word for word in ("at most", "at least") if str(text).strip().startswith(word)), None)
        if kind is None:
            remedy = "write for example 'at most 30 um' or 'at least 500000'"
            raise InputError(str(name), text, "begin with 'at most' or 'at least'", remedy)
        unit = known[name].unit
        unit = unit if unit in {"mm", "N", "MPa", "rad", "N mm"} else ""
        number = parse_number(str(name), str(text).strip().removeprefix(kind), unit)
        if number == 0.0:
            raise InputError(str(name), text, "not be zero", "give a number to which a margin can be relative")
        checked.append(Limit(name, most=number) if kind == "at most" else Limit(name, least=number))
    return tuple(checked)


@dataclass(frozen=True)
class Capability:
    """Independent samples of a quantity compared with one limit.

    Attributes
    ----------
    quantity : str
        The quantity.
    kind : str
        ``"at most"`` or ``"at least"``.
    limit : float
        The limit, in the base unit of the quantity.
    samples, beyond : int
        Numbers of samples, and of samples beyond the limit.
    fraction, low, high : float
        The fraction beyond the limit, and its 95 % confidence interval for any distribution (Clopper and Pearson).
    mean, deviation : float
        Mean and standard deviation of the samples, in the base unit.
    cpk : float
        Distance of the mean from the limit in units of three standard deviations, positive on the right side: the
        one-sided capability index of ISO 22514-2 for a normal distribution. Infinite if nothing varies.

    References
    ----------
    ISO 22514-2:2017, Statistical methods in process management - Capability and performance - Part 2.

    C. J. Clopper, E. S. Pearson, The use of confidence or fiducial limits illustrated in the case of the binomial,
    Biometrika 26 (1934) 404-413, doi:10.1093/biomet/26.4.404.
    """

    quantity: str
    kind: str
    limit: float
    samples: int
    beyond: int
    fraction: float
    low: float
    high: float
    mean: float
    deviation: float
    cpk: float

    @property
    def normal_fraction(self) -> float:
        """The fraction that would lie beyond if the quantity were normally distributed."""
        from scipy.stats import norm

        return float(norm.sf(3.0 * self.cpk))


def capabilities(limit: Limit, values: NDArray[np.float64]) -> list[Capability]:
    """Return the comparison of samples with each side of a limit.

    Parameters
    ----------
    limit : Limit
        The limit.
    values : ndarray, shape (n,)
        At least two samples; those that are not finite are left out.
    """
    from scipy.stats import binomtest

    numbers = values[np.isfinite(values)]
    if numbers.size < 2:
        return []
    mean, deviation, rows = float(numbers.mean()), float(numbers.std(ddof=1)), []
    for sign, bound in limit.sides:
        beyond = int(np.count_nonzero(sign * (numbers - bound) < 0.0))
        certain = binomtest(beyond, numbers.size).proportion_ci(CERTAINTY, method="exact")
        margin = sign * (mean - bound)
        cpk = margin / (3.0 * deviation) if deviation > 0.0 else math.copysign(math.inf, margin)
        fraction, low, high = beyond / numbers.size, float(certain.low), float(certain.high)
        kind = "at most" if sign < 0.0 else "at least"
        rows.append(
            Capability(limit.name, kind, bound, numbers.size, beyond, fraction, low, high, mean, deviation, cpk)
        )
    return rows
