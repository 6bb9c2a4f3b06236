"""The units to choose from beside a field, and the sizes above which plain numbers are shown in other units."""

from __future__ import annotations

import math
from typing import Any, Final

from nonhertz.amounts import INCH, POUND_FORCE
from nonhertz.files.keys import MICROMETRES

#: By base unit, units as written in files, and their sizes.
CHOICES: Final[dict[str, dict[str, float]]] = {
    "mm": {"um": 1e-3, "mm": 1.0, "m": 1e3, "in": INCH, "uin": 1e-6 * INCH},
    "N": {"N": 1.0, "kN": 1e3, "lbf": POUND_FORCE},
    "MPa": {"MPa": 1.0, "GPa": 1e3, "psi": POUND_FORCE / INCH**2, "ksi": 1e3 * POUND_FORCE / INCH**2},
    "rad": {"mrad": 1e-3, "arcmin": math.pi / 10800.0, "deg": math.pi / 180.0, "um/mm": 1e-3, "rad": 1.0},
    "N mm": {"N mm": 1.0, "N m": 1e3, "lbf in": POUND_FORCE * INCH},
    "1/min": {"1/min": 1.0, "rpm": 1.0},
    "mm^2/s": {"mm^2/s": 1.0},
    "t/mm^3": {"t/mm^3": 1.0, "kg/m^3": 1e-12},
}
SLOPE: Final = "um/mm"
"""A slope: the angle is not proportional to it."""

#: By base unit, in ascending order: the size above which a plain number is shown in a unit.
SHOWN_IN: Final[dict[str, list[tuple[float, str]]]] = {
    "N": [(0.0, "N"), (1e3, "kN")],
    "MPa": [(0.0, "MPa"), (1e4, "GPa")],
    "N mm": [(0.0, "N mm"), (1e4, "N m")],
    "rad": [(0.0, "mrad"), (0.05, "deg")],
}


def units_of_fields() -> dict[str, Any]:
    """Return the data with which a page shows and reads numbers with units."""
    return {"choices": CHOICES, "shown_in": SHOWN_IN, "micrometres": sorted(MICROMETRES)}
