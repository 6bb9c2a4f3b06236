"""Numbers with their units, as people read them: in SI units or in US customary ones.

Everything is computed and stored in mm, N, MPa and rad. Numbers shown to people, on a terminal, in
a report, on the page or in a figure, are formatted as an `Amount`, in the units chosen for the current context (see
`contextvars`). JSON, CSV and other files for programs do not use this module.
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
_ROUNDING = 1e-12  # relative: a prescribed load, for instance, is met this closely
_FEWEST = 4  # significant digits of an input in converted units
_SMALL = 0.5  # mm; smaller lengths are shown in micrometres
_SAME = 1e-6  # relative: less than five digits can show

#: Sizes of the displayed units, in units of Python and files.
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
    """Units in which results are displayed.

    Attributes
    ----------
    code : str
        ``"si"`` or ``"us"``.
    stated : str
        Sentence that states the units of numbers shown without one.
    table : mapping
        For each unit of the program, the unit displayed instead and the factor between them; other units stay.
    sizes : mapping
        For each displayed unit: the number from which on a larger or smaller one is used, and that unit with its size.
    """

    code: str
    stated: str
    table: Mapping[str, Size]
    sizes: Mapping[str, tuple[float, Size]]

    def of(self, unit: str, values: Iterable[float] = ()) -> Size:
        """Return the displayed unit for one of the program's, and the factor that converts a number to it.

        With ``values`` in the unit of the program, the unit suits the largest of them.
        """
        word, factor = self.table.get(unit, (unit, 1.0))
        # The last digit of a load close to 1 kN must not decide its unit.
        largest = (1.0 + _SAME) * max((abs(factor * value) for value in values), default=-1.0)
        least, (other, size) = self.sizes.get(word, (math.inf, (word, 1.0)))
        # Large numbers are written in larger units; small numbers of ksi are written in psi.
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
    """Return the units in which results are displayed in this context."""
    return _CHOSEN.get()


def choose_units(code: str) -> None:
    """Set the units in which results are displayed from here on, in this context (see `contextvars`).

    Raises
    ------
    InputError
        If the code is unknown.
    """
    if code not in SYSTEMS:
        raise InputError("units", code, "be 'si' or 'us'", "write 'us' for in, lbf and ksi")
    _CHOSEN.set(SYSTEMS[code])


@contextlib.contextmanager
def display_units(code: str) -> Iterator[None]:
    """Show results in these units within a ``with`` statement; raises what `choose_units` does."""
    before = _CHOSEN.get()
    choose_units(code)
    try:
        yield
    finally:
        _CHOSEN.set(before)


@dataclass(frozen=True)
class Amount:
    """One number with its unit, or several that share one; as text, in the units chosen for display.

    The format sets the number of significant digits, as in ``f"{amount:4}"``, 5 by default; with a ``g``, as in
    ``f"{amount:.4g}"``, 6 by default, trailing zeros are dropped, as for inputs. An input converted from SI has as many
    digits as in SI, but at least four.

    Attributes
    ----------
    values : tuple of float
        The numbers, in ``unit``.
    unit : str
        The unit in Python and files.
    read : str
        The SI unit in which such numbers are displayed.
    between : str
        Separator between several numbers.

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
        """Return the numbers as text and the unit that they share."""
        (factor, unit), precision = self.scale, spec.strip(".g")
        if not spec.endswith("g"):
            return [format_digits(factor * value, int(precision or 5)) for value in self.values], unit
        most = int(precision or 6)
        if current_units() is SI:
            return [format_input(factor * value, most) for value in self.values], unit
        # Conversion to other units does not make an input more precise.
        si = self._scale_in(SI)[0]
        exact = [min(most, max(_FEWEST, _written(si * value, most))) for value in self.values]
        return [format_input(factor * value, number) for value, number in zip(self.values, exact, strict=True)], unit

    @property
    def scale(self) -> tuple[float, str]:
        """Factor that converts the values to the displayed unit, and that unit."""
        return self._scale_in(current_units())

    def _scale_in(self, units: Units) -> tuple[float, str]:
        size = SIZES.get(self.read or self.unit, 1.0)
        read = [value / size for value in self.values if math.isfinite(value)]
        unit, factor = units.of(self.read or self.unit, read)
        return factor / size, unit


def amount(values: float | Iterable[float], unit: str, read: str = "", between: str = ", ") -> Amount:
    """Return one number or several in a unit of Python and files, with the SI unit in which they are displayed."""
    several = values if isinstance(values, Iterable) else (values,)
    return Amount(tuple(map(float, several)), unit, read, between)


def mm(*values: float, between: str = ", ") -> Amount:
    """Return lengths [mm]."""
    return amount(values, "mm", between=between)


def um(*values: float, between: str = ", ") -> Amount:
    """Return short lengths, given in mm and displayed in micrometres."""
    return amount(values, "mm", "um", between)


def mrad(*values: float, between: str = ", ") -> Amount:
    """Return angles, given in rad and displayed in milliradians."""
    return amount(values, "rad", "mrad", between)


def mpa(*values: float, between: str = ", ") -> Amount:
    """Return pressures or stresses [MPa]."""
    return amount(values, "MPa", between=between)


def newton(*values: float, between: str = ", ") -> Amount:
    """Return forces [N], displayed in kN where they are large."""
    return amount(values, "N", between=between)


def newton_mm(*values: float, between: str = ", ") -> Amount:
    """Return moments [N mm], displayed in N m where they are large."""
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
        """The strength as a tuple, like `Amount.values`."""
        return (self.value,)

    @property
    def unit(self) -> str:
        """Its unit in files."""
        return f"MPa mm^{self.exponent:.3g}"

    @property
    def apart(self) -> tuple[float, str, str]:
        """The strength in displayed units, and the units of pressure and of length."""
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
    """Return dimensions, angles or loads in the units in which drawings write them, micrometres where they are small.

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
    # The decade of the rounded number: 0.999999 rounds to 1.0000.
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
    """Return the number of significant digits of a number, without trailing zeros."""
    mantissa = format_input(value, most).partition("e")[0]
    return len(mantissa.lstrip("-").replace(".", "").strip("0")) if math.isfinite(value) else most


def format_column(values: Iterable[float], significant: int = 5) -> list[str]:
    """Return the numbers of a column, all with the decimals that suit the largest of them.

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
    """Return a difference in per cent with its sign, without decimals if it is large; empty if it is rounding error.

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
    """Return an amount of one number with its standard error, both to the second digit of the error.

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
    # -0.4 rounds to -0.0; adding 0.0 drops the sign.
    return (
        f"{' +- '.join(f'{round(number, place) + 0.0:.{max(place, 0)}f}' for number in (value, error))} {unit}".rstrip()
    )


def error_words(relative: float) -> str:
    """Return an estimated relative error in words; empty if it is only rounding error.

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
    """Return the format of an amount with this estimated relative error, without digits smaller than the error.

    Examples
    --------
    >>> [f"{mm(0.0322131):{worth_reading(error)}}" for error in (0.0003, 0.001, 0.01, 0.5)]
    ['0.032213 mm', '0.03221 mm', '0.0322 mm', '0.032 mm']
    """
    return str(min(5, max(2, 1 - math.floor(math.log10(relative))))) if 0.0 < relative < math.inf else ""


def format_error(relative: float) -> str:
    """Return an estimated relative error in per cent, with one digit: an estimate deserves no more.

    Examples
    --------
    >>> format_error(0.112), format_error(0.0042)
    ('about 10 %', 'about 0.4 %')
    """
    return f"about {format_input(float(f'{100.0 * relative:.1g}'), 1)} %"
