"""Numbers with their units, as people read them: in SI units or in US customary ones.

Everything is computed and stored in mm, N, MPa and rad. Where a number becomes text for people, it does so as an
`Amount`, in the units that were chosen for this context (see `contextvars`): on a terminal, in a report, on the page,
in a figure. What programs read, JSON, CSV and other files, does not pass here.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterable, Iterator, Mapping
from contextvars import ContextVar
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from nonhertz.errors import InputError

INCH: Final = 25.4
"""One inch [mm], exactly: international yard and pound agreement of 1959."""
POUND_FORCE: Final = 4.4482216152605
"""One pound-force [N], exactly: 0.45359237 kg under 9.80665 m/s^2."""

_KSI: Final = 1e3 * POUND_FORCE / INCH**2  # MPa
_POUND: Final = 0.45359237  # kg
_ROUNDING = 1e-12  # relative: a prescribed load, say, is met to that
_FEWEST = 4  # significant digits of an input in converted units
_SMALL = 0.5  # mm, below which people read micrometres
_SAME = 1e-6  # relative: less than five digits show

#: Sizes of the units in which people read numbers, in those of Python and files.
SIZES: Final[Mapping[str, float]] = MappingProxyType(
    {
        "nm": 1e-6,
        "um": 1e-3,
        "m": 1e3,
        "km": 1e6,
        "mrad": 1e-3,
        "%": 1e-2,
        "N/um": 1e3,
        "N/mrad": 1e3,
        "N mm/um": 1e3,
        "N m/mrad": 1e6,
    }
)
Size = tuple[str, float]


@dataclass(frozen=True)
class Units:
    """Units in which people read results.

    Attributes
    ----------
    code : str
        ``"si"`` or ``"us"``.
    stated : str
        Words on the units of numbers that have none beside them.
    table : mapping
        By unit of the program: the one in its place, and how many of it make one of that; what is missing stays.
    sizes : mapping
        By unit that is shown: from which number on people write another, and that with its size.
    """

    code: str
    stated: str
    table: Mapping[str, Size]
    sizes: Mapping[str, tuple[float, Size]]

    def of(self, unit: str, values: Iterable[float] = ()) -> Size:
        """Return the unit in place of one of the program's, and how many of it make one of that.

        With ``values`` in the unit of the program, it is the one that suits the largest of them.
        """
        word, factor = self.table.get(unit, (unit, 1.0))
        # Whether a load of one kN is met to the last digit must not choose its unit.
        largest = (1.0 + _SAME) * max((abs(factor * value) for value in values), default=-1.0)
        least, (other, size) = self.sizes.get(word, (math.inf, (word, 1.0)))
        # Large numbers are written in larger units, but those of ksi that are small in smaller ones.
        return (other, factor / size) if (largest >= least if size > 1.0 else 0.0 < largest < least) else (word, factor)


SI: Final = Units(
    "si",
    "Units are mm, N, MPa and rad unless stated otherwise",
    MappingProxyType({unit: (unit.replace("um", "µm"), 1.0) for unit in ("um", "N/um", "N mm/um")}),
    MappingProxyType({"N": (1e3, ("kN", 1e3)), "N mm": (1e3, ("N m", 1e3))}),
)
US: Final = Units(
    "us",
    "Units are in, lbf, ksi and rad, those of files mm, N, MPa and rad, unless stated otherwise",
    MappingProxyType(
        {
            "mm": ("in", 1.0 / INCH),
            "um": ("µin", 1e3 / INCH),
            "µm": ("µin", 1e3 / INCH),
            "m": ("ft", 1e3 / (12.0 * INCH)),
            "km": ("mi", 1e6 / (63360.0 * INCH)),
            "nm": ("µin", 1.0 / INCH),
            "1/mm": ("1/in", INCH),
            "N": ("lbf", 1.0 / POUND_FORCE),
            "kN": ("lbf", 1e3 / POUND_FORCE),
            "MPa": ("ksi", 1.0 / _KSI),
            "GPa": ("ksi", 1e3 / _KSI),
            "1/MPa": ("1/ksi", _KSI),
            "N mm": ("lbf in", 1.0 / (POUND_FORCE * INCH)),
            "N m": ("lbf in", 1e3 / (POUND_FORCE * INCH)),
            "N/mm": ("lbf/in", INCH / POUND_FORCE),
            "N/um": ("lbf/µin", 1e-3 * INCH / POUND_FORCE),
            "N/µm": ("lbf/µin", 1e-3 * INCH / POUND_FORCE),
            "N/mrad": ("lbf/mrad", 1.0 / POUND_FORCE),
            "N mm/um": ("lbf in/mil", 1.0 / POUND_FORCE),
            "N mm/µm": ("lbf in/mil", 1.0 / POUND_FORCE),
            "N m/mrad": ("lbf in/mrad", 1e3 / (POUND_FORCE * INCH)),
            "t/mm^3": ("lb/in^3", 1e3 * INCH**3 / _POUND),
            "g": ("lb", 1e-3 / _POUND),
        }
    ),
    MappingProxyType({"ksi": (1.0, ("psi", 1e-3))}),
)
SYSTEMS: Final[Mapping[str, Units]] = MappingProxyType({units.code: units for units in (SI, US)})

_CHOSEN: ContextVar[Units] = ContextVar("units", default=SI)


def current_units() -> Units:
    """Return the units in which people read results in this context."""
    return _CHOSEN.get()


def choose_units(code: str) -> None:
    """Choose the units in which people read results from here on, in this context (see `contextvars`).

    Raises
    ------
    InputError
        If there are none of this code.
    """
    if code not in SYSTEMS:
        raise InputError("units", code, "be 'si' or 'us'", "write 'us' for in, lbf and ksi")
    _CHOSEN.set(SYSTEMS[code])


@contextlib.contextmanager
def display_units(code: str) -> Iterator[None]:
    """Show results in the units of a code within a ``with`` statement; raise what `choose_units` does."""
    before = _CHOSEN.get()
    choose_units(code)
    try:
        yield
    finally:
        _CHOSEN.set(before)


@dataclass(frozen=True)
class Amount:
    """One number with its unit, or several that share one; as text, in the units that people have chosen.

    The format says how many significant digits are worth reading, as in ``f"{amount:4}"``, by default 5; with a ``g``,
    ``f"{amount:.4g}"``, by default 6, zeros at the end are left out, as of inputs. In other units than SI these have no
    more digits than in SI, but four.

    Attributes
    ----------
    values : tuple of float
        In ``unit``.
    unit : str
        Of Python and files.
    read : str
        The unit in which people read such numbers, before they choose others.
    between : str
        What stands between several numbers.

    Examples
    --------
    >>> f"{newton(20000.0)}, {mm(0.0322131):3}, {mm(9.0):g}, {um(0.0123)}, {mpa(0.5)}"
    '20.000 kN, 0.0322 mm, 9 mm, 12.300 µm, 0.50000 MPa'
    >>> f"{newton(0.0, 20000.0, -310.0)}; {newton(820.0, 830.0, between=' and '):3}"
    '0, 20.000, -0.31000 kN; 820 and 830 N'
    >>> with display_units("us"):
    ...     f"{newton(20000.0)}, {mm(9.0):g}, {um(0.0123)}, {mpa(0.5):4}"
    '4496.2 lbf, 0.3543 in, 484.25 µin, 72.52 psi'
    """

    values: tuple[float, ...]
    unit: str = ""
    read: str = ""
    between: str = ", "

    def __str__(self) -> str:
        return format(self, "")

    def __format__(self, spec: str) -> str:
        numbers, unit = self.apart(spec)
        return f"{self.between.join(numbers)} {unit}".rstrip()

    def apart(self, spec: str = "") -> tuple[list[str], str]:
        """Return the numbers as text, and the unit that they share."""
        (factor, unit), precision = self.scale, spec.strip(".g")
        if not spec.endswith("g"):
            return [format_digits(factor * value, int(precision or 5)) for value in self.values], unit
        most = int(precision or 6)
        if current_units() is SI:
            return [format_input(factor * value, most) for value in self.values], unit
        # An input converted to other units has not become more exact by that.
        si = self._scale_in(SI)[0]
        exact = [min(most, max(_FEWEST, _written(si * value, most))) for value in self.values]
        return [format_input(factor * value, number) for value, number in zip(self.values, exact, strict=True)], unit

    @property
    def scale(self) -> tuple[float, str]:
        """What turns the values into numbers that people read, and the unit of these."""
        return self._scale_in(current_units())

    def _scale_in(self, units: Units) -> tuple[float, str]:
        size = SIZES.get(self.read or self.unit, 1.0)
        read = [value / size for value in self.values if math.isfinite(value)]
        unit, factor = units.of(self.read or self.unit, read)
        return factor / size, unit


def amount(values: float | Iterable[float], unit: str, read: str = "", between: str = ", ") -> Amount:
    """Return one number or several in a unit of Python and files, which people read in another one."""
    several = values if isinstance(values, Iterable) else (values,)
    return Amount(tuple(map(float, several)), unit, read, between)


def mm(*values: float, between: str = ", ") -> Amount:
    """Return lengths [mm]."""
    return amount(values, "mm", between=between)


def um(*values: float, between: str = ", ") -> Amount:
    """Return short lengths, given in mm, that people read in micrometres."""
    return amount(values, "mm", "um", between)


def mrad(*values: float, between: str = ", ") -> Amount:
    """Return angles, given in rad, that people read in milliradians."""
    return amount(values, "rad", "mrad", between)


def mpa(*values: float, between: str = ", ") -> Amount:
    """Return pressures or stresses [MPa]."""
    return amount(values, "MPa", between=between)


def newton(*values: float, between: str = ", ") -> Amount:
    """Return forces [N], in kN where they are large."""
    return amount(values, "N", between=between)


def newton_mm(*values: float, between: str = ", ") -> Amount:
    """Return moments [N mm], in N m where they are large."""
    return amount(values, "N mm", between=between)


def per_mm(*values: float, between: str = ", ") -> Amount:
    """Return forces per length [N/mm]."""
    return amount(values, "N/mm", between=between)


@dataclass(frozen=True)
class EndStrength:
    """The strength K of a pressure K / s^exponent towards a sharp end [MPa mm^exponent].

    Examples
    --------
    >>> str(EndStrength(348.4, 0.5))
    '348.4 MPa mm^0.5'
    """

    value: float
    exponent: float

    @property
    def values(self) -> tuple[float]:
        """The strength, as an `Amount` has it."""
        return (self.value,)

    @property
    def unit(self) -> str:
        """Its unit in files."""
        return f"MPa mm^{self.exponent:.3g}"

    @property
    def apart(self) -> tuple[float, str, str]:
        """The strength in the units that are read, and the units of pressure and of length."""
        (pressure, stress), (length, distance) = current_units().of("MPa"), current_units().of("mm")
        return self.value * stress * distance**self.exponent, pressure, length

    def __str__(self) -> str:
        value, pressure, length = self.apart
        return f"{format_digits(value, 4)} {pressure} {length}^{self.exponent:.3g}"


def describe_load(load: float, tilt: float) -> str:
    """Return a load [N] and a tilt [rad] in words.

    Examples
    --------
    >>> describe_load(20000.0, 0.0), describe_load(500.0, 5e-4)
    ('20 kN without tilt', '500 N at 0.5 mrad')
    """
    return f"{newton(load):.5g} {f'at {mrad(tilt):.4g}' if tilt else 'without tilt'}"


def of_dimension(values: Iterable[float], unit: str, between: str = " to ") -> Amount:
    """Return dimensions, angles or loads in the units in which people write them, micrometres where they are small.

    Examples
    --------
    >>> [f"{of_dimension(*each):g}" for each in (((0.012,), "mm"), ((20.0, 0.1), "mm"), ((1e-3,), "rad"))]
    ['12 µm', '20 to 0.1 mm', '1 mrad']
    """
    values = tuple(values)
    small = unit == "mm" and max(map(abs, values)) < _SMALL
    return amount(values, unit, "um" if small else "mrad" if unit == "rad" else "", between)


def format_digits(value: float, significant: int = 5) -> str:
    """Return a number with this many significant digits, without an exponent unless it is very small or large.

    Examples
    --------
    >>> [format_digits(value) for value in (0.0322131, 20000.0, 0.999999, 1.23456789e9, 0.0)]
    ['0.032213', '20000', '1.0000', '1.2346e+09', '0']
    """
    if value == 0.0 or not math.isfinite(value):
        return f"{value:g}".replace("-0", "0")
    # That of the rounded number: 0.999999 has one digit before the point.
    decade = int(f"{value:.{significant - 1}e}".partition("e")[2])
    if not -4 <= decade < 8:
        return f"{value:.{significant - 1}e}"
    return f"{value:.{max(0, significant - 1 - decade)}f}"


def format_input(value: float, significant: int = 6) -> str:
    """Return an input number without insignificant zeros.

    Examples
    --------
    >>> [format_input(value) for value in (9.0, 0.000523598775598, 207000.0, 2.5e-7)], format_input(57.3, 1)
    (['9', '0.000523599', '207000', '2.5e-07'], '57')
    """
    mantissa, exponent, power = format_digits(value, significant).partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + exponent + power


def _written(value: float, most: int) -> int:
    """Return with how many significant digits a number is written, of which zeros at the end are none."""
    mantissa = format_input(value, most).partition("e")[0]
    return len(mantissa.lstrip("-").replace(".", "").strip("0")) if math.isfinite(value) else most


def format_column(values: Iterable[float], significant: int = 5) -> list[str]:
    """Return numbers that stand below one another: with the decimals that suit the largest of them.

    Examples
    --------
    >>> format_column([3.80971, 0.903454, 0.0018632, 0.0])
    ['3.8097', '0.9035', '0.0019', '0']
    """
    values = tuple(values)
    largest = format_digits(max(map(abs, values), default=0.0), significant)
    if "e" in largest:
        return [format_digits(value, significant) for value in values]
    decimals = len(largest.partition(".")[2])
    return [f"{value:.{decimals}f}" if value else "0" for value in values]


def percent(relative: float, significant: int = 2) -> str:
    """Return a difference in per cent with its sign, without decimals where it is large; nothing where it is rounding.

    Examples
    --------
    >>> percent(0.1237), percent(-0.0251), percent(0.12371, 3), percent(1e-9)
    ('+12 %', '-2.5 %', '+12.4 %', '')
    """
    change = 100.0 * relative
    if abs(change) < 1e-6:
        return ""
    return f"{change:+.0f} %" if abs(change) >= 10 ** (significant - 1) else f"{change:+.{significant}g} %"


def with_error(shown: Amount, error: float) -> str:
    """Return an amount of one number with its standard error, in its unit, both to the second digit of that.

    Examples
    --------
    >>> with_error(mm(4361.8), 1034.0), with_error(amount(0.0123456, ""), 0.000789), with_error(um(0.012), 0.0)
    ('4400 +- 1000 mm', '0.01235 +- 0.00079', '12.000 +- 0 µm')
    >>> with_error(um(-1e-6), 0.023)
    '0 +- 23 µm'
    """
    factor, unit = shown.scale
    value, error = factor * shown.values[0], factor * error
    if not (math.isfinite(error) and error > 0.0):
        return f"{format_digits(value)} +- {format_digits(error)} {unit}".rstrip()
    place = 1 - math.floor(math.log10(error))
    # Nothing below zero is left of -0.4 that is rounded; the sum of -0.0 and 0.0 has no sign.
    return (
        f"{' +- '.join(f'{round(number, place) + 0.0:.{max(place, 0)}f}' for number in (value, error))} {unit}".rstrip()
    )


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
    return f"error {format_error(relative)}" if relative > _ROUNDING else ""


def worth_reading(relative: float) -> str:
    """Return the format of an amount with an estimated relative error, in which that is more than one of its digits.

    Examples
    --------
    >>> [f"{mm(0.0322131):{worth_reading(error)}}" for error in (0.0003, 0.001, 0.01, 0.5)]
    ['0.032213 mm', '0.03221 mm', '0.0322 mm', '0.032 mm']
    """
    return str(min(5, max(2, 1 - math.floor(math.log10(relative))))) if 0.0 < relative < math.inf else ""


def format_error(relative: float) -> str:
    """Return an estimated relative error in per cent: of an estimate, one digit is worth reading.

    Examples
    --------
    >>> format_error(0.112), format_error(0.0042)
    ('about 10 %', 'about 0.4 %')
    """
    return f"about {format_input(float(f'{100.0 * relative:.1g}'), 1)} %"
