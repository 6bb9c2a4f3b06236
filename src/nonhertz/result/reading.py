"""The units in which people read results: SI, in which all text of the program is worded, or US customary ones.

Everything is computed, worded and stored in mm, N and MPa. Where text and figures leave the program for people - a
terminal, a report - the units chosen in this context (see `contextvars`) rewrite them: a number, or several in a row
that share a unit, together with that unit. Nothing below knows of this, and what other programs read never changes.

A number keeps its significant digits: more would not be true of one that was rounded. A whole one, or one with fewer
than three, such as a size or a limit, is shown with up to four, and an input with up to six. A standard error stays at
its second digit, and so does the number before it.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from types import MappingProxyType
from typing import Final

from nonhertz.errors import InputError
from nonhertz.result.numerals import digits, given, with_error

INCH: Final = 25.4
"""One inch [mm], exactly: international yard and pound agreement of 1959."""
POUND_FORCE: Final = 4.4482216152605
"""One pound-force [N], exactly: 0.45359237 kg under 9.80665 m/s^2."""

_KSI: Final = 1e3 * POUND_FORCE / INCH**2  # MPa
_POUND: Final = 0.45359237  # kg
_FIGURES, _OF_INPUTS = 4, 6
_ROUNDED = 3  # figures of a number with decimals that has been computed
_LEAST_KSI: Final = 1.0  # below which a pressure is shown in psi

US_UNITS: Final[Mapping[str, tuple[str, float]]] = MappingProxyType(
    {
        "mm": ("in", 1.0 / INCH),
        "um": ("uin", 1e3 / INCH),
        "µm": ("µin", 1e3 / INCH),
        "nm": ("uin", 1.0 / INCH),
        "1/mm": ("1/in", INCH),
        "N": ("lbf", 1.0 / POUND_FORCE),
        "kN": ("lbf", 1e3 / POUND_FORCE),
        "MPa": ("ksi", 1.0 / _KSI),
        "GPa": ("ksi", 1e3 / _KSI),
        "1/MPa": ("1/ksi", _KSI),
        "N mm": ("lbf in", 1.0 / (POUND_FORCE * INCH)),
        "N m": ("lbf in", 1e3 / (POUND_FORCE * INCH)),
        "N/mm": ("lbf/in", INCH / POUND_FORCE),
        "N/um": ("lbf/uin", 1e-3 * INCH / POUND_FORCE),
        "N/µm": ("lbf/µin", 1e-3 * INCH / POUND_FORCE),
        "N/mrad": ("lbf/mrad", 1.0 / POUND_FORCE),
        "N mm/um": ("lbf in/mil", 1.0 / POUND_FORCE),
        "N mm/µm": ("lbf in/mil", 1.0 / POUND_FORCE),
        "N m/mrad": ("lbf in/mrad", 1e3 / (POUND_FORCE * INCH)),
        "t/mm^3": ("lb/in^3", 1e3 * INCH**3 / _POUND),
        "g": ("lb", 1e-3 / _POUND),
    }
)
# Ratios without a dimension, and centistokes, which are those of US catalogues too.
_SAME: Final = ("um/mm", "mm^2/s")

_SIGN = r"(?:\+-|[-+−±])?"
_NUMBER: Final = rf"{_SIGN}(?:\d+\.?\d*|\.\d+)(?:e[-+−]?\d+)?"
_NAMED = r"(?:\$?[xyz]\$? = |R[aqz] |length )?"
_BETWEEN: Final = rf"(?: (?:\+-|±|to|or|:) |; |,? and {_NAMED}|, {_NAMED})"
_LONGEST_FIRST = sorted((*US_UNITS, *_SAME), key=len, reverse=True)
_UNIT: Final = "|".join(re.escape(word) for word in _LONGEST_FIRST)
# Of strength: stress times a length to a power, which figures have in mathtext.
_STRENGTH: Final = re.compile(rf"({_NUMBER}) MPa mm(\$\^\{{|\^)([\d.]+)(\}}\$)?")
_TEXT: Final = re.compile(
    rf"(?<![\w.^/$])(?P<numbers>{_NUMBER}(?: [x×] {_NUMBER})+|{_NUMBER}(?:{_BETWEEN}{_NUMBER})*) "
    rf"(?P<unit>{_UNIT})(?![\w/^²³$]|\.\w)"
)
_PAIR: Final = re.compile(rf"({_NUMBER}) (\+-|±) ({_NUMBER})")
_ONE: Final = re.compile(rf"(?<![\w.^])(?>{_NUMBER})(?![\w^]| values| %)")
_HEAD: Final = re.compile(rf"\[({_UNIT})\]")
_MICROMETRE: Final = re.compile(r"(?<=[ /\[])um\b")
_MIXED: Final = re.compile(rf"({_NUMBER}) ({_UNIT})")
_BARE: Final = re.compile(rf"{_NUMBER}(?: to {_NUMBER})?")

Rows = list[tuple[str, ...]]
Ticks = Callable[[float, float], Sequence[float]]


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
    """

    def __init__(self, code: str, stated: str, table: Mapping[str, tuple[str, float]]) -> None:
        self.code, self.stated, self.table = code, stated, table

    def __call__(self, text: str) -> str:
        """Return text of the program with every number and unit in these units; one without units is unchanged."""
        if not self.table:
            return text
        return _TEXT.sub(self._rewritten, _STRENGTH.sub(self._of_strength, text))

    def of(self, unit: str) -> tuple[str, float]:
        """Return the unit in place of one of the program's, and how many of it make one of that."""
        return self.table.get(unit, (unit, 1.0))

    def value(self, text: str, unit: str, *, given: bool = False) -> tuple[str, str]:
        """Return a value, and the unit that is shown apart from it; all numbers of the value have that unit.

        An input that was given is exact.
        """
        word, factor = self.of(unit)
        if unit not in self.table:
            return text, unit
        return _each(text, factor, _OF_INPUTS if given else _FIGURES), word

    def head(self, text: str) -> str:
        """Return the head of a column, or what an axis is labelled with, whose unit is in brackets."""
        return _HEAD.sub(lambda found: f"[{self.of(found[1])[0]}]", self(text))

    def columns(self, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> tuple[tuple[str, ...], Rows]:
        """Return a table whose numbers have the units in brackets of its heads or of their row's name, or their own."""
        units = [_unit_in(head) for head in heads]
        found = []
        for row in rows:
            own = _unit_in(row[0])
            first = self.head(row[0]) if own else self._cell(row[0], units[0])
            rest = zip(row[1:], units[1:], strict=True)
            found.append((first, *(self._cell(cell, unit or own) for cell, unit in rest)))
        return tuple(map(self.head, heads)), found

    def row(self, cells: Sequence[str], *, given: bool = False) -> tuple[str, ...]:
        """Return a row whose numbers have the unit in brackets of its name, or the bare ones that of another cell.

        Inputs that were given are exact.
        """
        unit = _unit_in(cells[0])
        if unit:
            return self.head(cells[0]), *(self._cell(cell, unit) for cell in cells[1:])
        own = (found[2] for cell in cells if (found := _MIXED.fullmatch(cell)))
        unit = next((cell for cell in cells if cell in self.table), "") or next(own, "")
        return tuple(self._of_row(cell, unit, given) for cell in cells)

    def ticks(self, ticks: Ticks, low: float, high: float, unit: str) -> list[float]:
        """Return values in the program's ``unit``, between two others, that are round in these units."""
        factor = self.of(unit)[1]
        return [float(each) / factor for each in ticks(factor * low, factor * high)]

    def _of_row(self, cell: str, unit: str, given: bool) -> str:
        if cell in self.table:
            return self.of(cell)[0]
        if unit and _BARE.fullmatch(cell):
            return self.value(cell, unit, given=given)[0]
        mixed = _MIXED.fullmatch(cell)
        # Of one kind with the bare numbers, however small it is.
        return " ".join(self.value(mixed[1], unit, given=given)) if mixed and mixed[2] == unit else self.head(cell)

    def _cell(self, text: str, unit: str) -> str:
        if not unit:
            return self(text)
        said, at = [], 0
        for found in _TEXT.finditer(text):
            # A number with a unit of its own has that, whatever the head says.
            said += [self.value(text[at : found.start()], unit)[0], self._rewritten(found)]
            at = found.end()
        return "".join([*said, self.value(text[at:], unit)[0]])

    def _rewritten(self, found: re.Match[str]) -> str:
        numbers, unit = found["numbers"], found["unit"]
        if unit not in self.table:
            return found[0]
        word, factor = self.of(unit)
        if word == "ksi":
            sizes = [abs(factor * _read(each)) for each in re.findall(_NUMBER, numbers)]
            word, factor = ("ksi", factor) if max(sizes) >= _LEAST_KSI else ("psi", 1e3 * factor)
        return f"{_each(numbers, factor)} {word}"

    def _of_strength(self, found: re.Match[str]) -> str:
        factor = self.of("MPa")[1] * self.of("mm")[1] ** float(found[3])
        return f"{_shown(found[1], factor)} ksi in{found[2]}{found[3]}{found[4] or ''}"


SI: Final = Units("si", "Units are mm, N, MPa and rad unless stated otherwise", {})
US: Final = Units(
    "us", "Units are in, lbf, ksi and rad, those of files mm, N, MPa and rad, unless stated otherwise", US_UNITS
)
SYSTEMS: Final[Mapping[str, Units]] = MappingProxyType({each.code: each for each in (SI, US)})

_CHOSEN: ContextVar[Units] = ContextVar("units", default=SI)


def chosen() -> Units:
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
def read_in(code: str) -> Iterator[None]:
    """Show results in the units of a code within a ``with`` statement; raise what `choose_units` does."""
    before = _CHOSEN.get()
    choose_units(code)
    try:
        yield
    finally:
        _CHOSEN.set(before)


def in_letters(text: str) -> str:
    """Return text of the program with units as they are printed, where all letters can be."""
    return _MICROMETRE.sub("µm", text)


def _unit_in(head: str) -> str:
    found = _HEAD.search(head)
    return found[1] if found else ""


def _each(text: str, factor: float, least: int = _FIGURES) -> str:
    """Return text with every number times a factor, errors with the numbers that they belong to."""
    parts = _PAIR.split(text)
    said = [_ONE.sub(lambda found: _shown(found[0], factor, least), parts[0])]
    for at in range(1, len(parts), 4):
        value, between, error, rest = parts[at : at + 4]
        both = with_error(factor * _read(value), factor * _read(error)).split(" +- ")
        said.append(f" {between} ".join(both))
        said.append(_ONE.sub(lambda found: _shown(found[0], factor, least), rest))
    return "".join(said)


def _shown(number: str, factor: float, least: int = _FIGURES) -> str:
    """Return a number times a factor with as many significant digits, or with up to ``least`` if it may be exact."""
    sign = "+-" if number.startswith("+-") else number[0] if number[0] in "+±" else ""
    bare = number.removeprefix(sign)
    mantissa = re.split("e", bare)[0]
    figures = len(re.sub(r"\D", "", mantissa).lstrip("0"))
    value = factor * _read(bare)
    is_rounded = figures >= least or (least == _FIGURES and figures >= _ROUNDED and "." in mantissa)
    text = digits(value, figures) if is_rounded else given(value, least)
    return sign + (text.replace("-", "−") if "−" in bare else text)


def _read(number: str) -> float:
    return float(number.replace("−", "-").replace("±", "").removeprefix("+-"))
