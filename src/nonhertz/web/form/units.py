"""The units of a field: those to choose from, and the one in which its value is shown."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

from nonhertz.amounts import INCH, POUND_FORCE, SI, chosen
from nonhertz.errors import InputError
from nonhertz.files.keys import MICROMETRES
from nonhertz.inputs.units import in_unit, number_and_unit

#: Per base unit, words as files have them and their size.
CHOICES: Final[dict[str, dict[str, float]]] = {
    "mm": {"um": 1e-3, "mm": 1.0, "m": 1e3, "in": INCH, "uin": 1e-6 * INCH},
    "N": {"N": 1.0, "kN": 1e3, "lbf": POUND_FORCE},
    "MPa": {"MPa": 1.0, "GPa": 1e3, "psi": POUND_FORCE / INCH**2, "ksi": 1e3 * POUND_FORCE / INCH**2},
    "rad": {"mrad": 1e-3, "arcmin": math.pi / 10800.0, "deg": math.pi / 180.0, "um/mm": 1e-3, "rad": 1.0},
    "N mm": {"N mm": 1.0, "N m": 1e3, "lbf in": POUND_FORCE * INCH},
    "1/min": {"1/min": 1.0},
    "mm^2/s": {"mm^2/s": 1.0},
    "t/mm^3": {"t/mm^3": 1.0, "kg/m^3": 1e-12},
}
SLOPE: Final = "um/mm"
"""Of this the angle is not proportional to the number."""
_LARGE: Final = {"N": (1e3, "kN"), "MPa": (1e4, "GPa"), "N mm": (1e4, "N m")}
_SMALL_ANGLE: Final = 0.05
_FIGURES: Final = 12
_LONGEST_WHOLE: Final = 1e9
_FEWER: Final = 6  # of one that was given in other units
_LINEAR: Final = 1e-3  # relative: the angle of a slope is not proportional to it, which a slider takes for granted


@dataclass(frozen=True)
class Unit:
    """A unit to choose.

    Attributes
    ----------
    word : str
        As files have it.
    factor : float or None
        Its size in the base unit; None where the value is not proportional to the number.
    """

    word: str
    factor: float | None

    @property
    def label(self) -> str:
        """As people read it."""
        return self.word.replace("um", "µm").replace("uin", "µin").replace("deg", "°").replace("arcmin", "′")


def units_of(base: str, name: str, value: Any) -> tuple[str | None, str, tuple[Unit, ...]]:
    """Return the number of a value in the unit in which it is shown, that unit, and all units to choose from.

    What was given with a unit is shown in that, unless results are read in US units.

    Parameters
    ----------
    base : str
        The unit of plain numbers.
    name : str
        The key, by which a plain number is shown in micrometres, say.
    value : object
        The value in the document; None if there is none.

    Returns
    -------
    text : str or None
        None for a value that is no number, with a unit or without.
    word : str
        The unit in which it is shown, as files have it.
    units : tuple of Unit
        Empty where there is nothing to choose.
    """
    known = CHOICES.get(base)
    if known is None:
        return None, "", ()
    units = tuple(Unit(word, factor) for word, factor in known.items())
    if isinstance(value, str):
        number, unit = number_and_unit(value) or ("", "")
        word = unit.replace("µ", "u").replace("μ", "u")
        if word not in known:
            try:
                size, one = (in_unit(name, each, base) for each in (value, f"1 {unit}"))
            except InputError:
                return None, _read(base)[0], units
            word = unit
            units += (Unit(word, one if math.isclose(one * float(number), size, rel_tol=_LINEAR) else None),)
        if chosen() is SI or word not in chosen().table:
            return number, word, units
        value = in_unit(name, value, base)
    there = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    word, factor = _read(_usual(base, name, abs(value) if there else 0.0))
    # Without the digits that dividing by a unit adds.
    figures = _FIGURES if factor == 1.0 else _FEWER
    return in_figures(float(f"{float(value) / known[word]:.{figures}g}")) if there else None, word, units


def _read(word: str) -> tuple[str, float]:
    """Return the unit in which one of files is read, as files have it, and how many of it make one of that."""
    read, factor = chosen().of(word)
    return read.replace("µ", "u"), factor


def _usual(base: str, name: str, size: float) -> str:
    """Return the unit of files in which people write a quantity of this name and size."""
    if base == "mm":
        return "um" if name in MICROMETRES and size < 1.0 else "mm"
    if base == "rad":
        return "mrad" if size < _SMALL_ANGLE else "deg"
    from_, word = _LARGE.get(base, (math.inf, base))
    return word if size >= from_ else base


def in_figures(number: float) -> str:
    """Return a number as a field has it, whole ones without a decimal point."""
    return str(int(number)) if number == int(number) and abs(number) < _LONGEST_WHOLE else repr(number)
