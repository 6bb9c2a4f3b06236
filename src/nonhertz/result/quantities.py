"""The numbers of a result, each defined once: name, symbol, units, and how to get it.

Terminal output, report, web page, files, comparisons and data tables are made from these; a quantity added here appears
in all of them. People are shown micrometres and milliradians where Python and files have mm and rad.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.amounts import Amount, amount

if TYPE_CHECKING:
    from nonhertz.result.solution import Solved

_ROUNDING = 1e-12  # of the terms of a sum: less is shown as zero, since symmetric terms cancel only to rounding


@dataclass(frozen=True)
class Quantity:
    """One number of a solution.

    Those that are attributes exist for every kind of solution; the stiffness only for strips.

    Attributes
    ----------
    name : str
        Its name in Python, files and data tables.
    label : str
        Its name for people.
    symbol : str
        In formulas; may be empty.
    unit : str
        In Python and files.
    get : callable
        Solution -> value in ``unit``.
    shown_unit : str
        The unit in which people are shown it.
    factor : float
        Values in ``shown_unit`` over those in ``unit``.
    scale : callable or None
        Solution -> size of the terms that it sums, in ``unit``; None if it is not a sum that may cancel to zero.
    """

    name: str
    label: str
    symbol: str
    unit: str
    get: Callable[[Any], float]
    shown_unit: str
    factor: float = 1.0
    scale: Callable[[Any], float] | None = None

    def clean(self, solution: Any) -> Any:
        """Return the value in ``unit``, zero where it is only rounding; of many solutions at once, of each."""
        value = self.get(solution)
        if self.scale is None:
            return value
        is_more = np.abs(value) > _ROUNDING * np.abs(self.scale(solution))
        return value * is_more + 0.0  # no zero is negative

    def amount(self, *values: float, between: str = ", ") -> Amount:
        """Return values of the quantity as people read them, all in one unit."""
        return amount(values, self.unit, self.shown_unit, between)

    def text(self, solution: Solved) -> str:
        """Return the value as people read it, with its unit."""
        return str(self.amount(float(self.clean(solution))))


def _own(
    name: str,
    label: str,
    symbol: str,
    unit: str,
    shown: tuple[str, float] | None = None,
    scale: Callable[[Any], float] | None = None,
) -> Quantity:
    """Return the quantity that is an attribute of the solution."""
    get: Callable[[Any], float] = attrgetter(name)
    shown_unit, factor = shown or (unit, 1.0)
    return Quantity(name, label, symbol, unit, get, shown_unit, factor, scale)


def _slope(
    row: int, column: int, name: str, unit: str, shown: tuple[str, float], scale: Callable[[Any], float] | None = None
) -> Quantity:
    """Return the quantity that is an entry of the stiffness."""
    force, _, motion = name.partition("_by_")

    def get(solution: Any) -> Any:  # works on Solutions too, all cases at once
        return solution.stiffness[..., row, column]

    return Quantity(name, f"d {force} / d {motion}", "", unit, get, *shown, scale)


def _by_approach_on_lever(solution: Any) -> Any:
    return solution.stiffness[..., 0, 0] * solution.contact_length


_ALL = (
    _own("approach", "approach", "delta", "mm", ("um", 1e3)),
    _own("penetration", "penetration", "", "mm", ("um", 1e3)),
    _own("tilt", "tilt", "gamma", "rad", ("mrad", 1e3)),
    _own("load", "load", "Q", "N"),
    _own("moment", "moment", "T", "N mm", scale=lambda solution: solution.load * solution.contact_length),
    _own("max_pressure", "maximum pressure", "", "MPa"),
    _own("max_pressure_y", "position of the maximum", "", "mm"),
    _own("max_half_width", "largest half-width", "", "mm"),
    _own("contact_length", "length of contact", "", "mm"),
    _slope(0, 0, "load_by_approach", "N/mm", ("N/um", 1e-3)),
    _slope(0, 1, "load_by_tilt", "N/rad", ("N/mrad", 1e-3), _by_approach_on_lever),
    _slope(1, 0, "moment_by_approach", "N mm/mm", ("N mm/um", 1e-3), _by_approach_on_lever),
    _slope(1, 1, "moment_by_tilt", "N mm/rad", ("N m/mrad", 1e-6)),
)

#: Every number of a solution, by name.
QUANTITIES: dict[str, Quantity] = {quantity.name: quantity for quantity in _ALL}

#: Arrays along the contact, by name, with their units.
ALONG: dict[str, str] = {
    "y": "mm",
    "strip_width": "mm",
    "line_load": "N/mm",
    "centre_pressure": "MPa",
    "half_width": "mm",
    "gap": "mm",
}
