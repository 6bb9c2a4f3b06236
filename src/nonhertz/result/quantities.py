"""The numbers of a result, each defined once: name, symbol, units, and how to get it.

Terminal output, report, web page, files, comparisons and data tables are made from these; a quantity added here appears
in all of them. Micrometres and milliradians are shown where Python and files have mm and rad.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.amounts import Amount, amount

if TYPE_CHECKING:
    from nonhertz.result.solved import Solved

_ROUNDING = (
    1e-12  # of the terms of a sum: smaller sums are shown as 0, since symmetric terms cancel only up to rounding
)


@dataclass(frozen=True)
class Quantity:
    """One number of a solution.

    Attributes exist for every kind of solution; the stiffness only for strips.

    Attributes
    ----------
    name : str
        Its name in Python, files and data tables.
    label : str
        Its name in sentences and tables.
    symbol : str
        Symbol in formulas; may be empty.
    unit : str
        Unit in Python and files.
    get : callable
        Solution -> value in ``unit``.
    shown_unit : str
        The unit in which it is shown; that of files if empty.
    scale : callable or None
        Solution -> size of the terms of its sum, in ``unit``; None if it is not a sum that may cancel to zero.
    within : str
        The array or the part of a result that contains it in summaries and JSON; empty for a place of its own.
    meaning : str
        Its meaning, if the label is not sufficient.
    """

    name: str
    label: str
    symbol: str
    unit: str
    get: Callable[[Any], Any]
    shown_unit: str = ""
    scale: Callable[[Any], float] | None = None
    within: str = ""
    meaning: str = ""

    def clean(self, solution: Any) -> Any:
        """Return the value in ``unit``, zero if it is only rounding; for many solutions at once, of each."""
        value = self.get(solution)
        if self.scale is None:
            return value
        is_more = np.abs(value) > _ROUNDING * np.abs(self.scale(solution))
        return value * is_more + 0.0  # removes the sign of zeros

    def amount(self, *values: float, between: str = ", ") -> Amount:
        """Return values of the quantity for display, all in one unit."""
        return amount(values, self.unit, self.shown_unit, between)

    def text(self, solution: Solved, spec: str = "") -> str:
        """Return the value as text, with its unit; ``spec`` is the format of an `Amount`."""
        return format(self.amount(float(self.clean(solution))), spec)


def _own(name: str, label: str, symbol: str, unit: str, shown: str = "", **options: Any) -> Quantity:
    """Return the quantity that is an attribute of the solution."""
    return Quantity(name, label, symbol, unit, attrgetter(name), shown, **options)


def _slope(
    row: int, column: int, name: str, unit: str, shown: str, scale: Callable[[Any], float] | None = None
) -> Quantity:
    """Return the quantity that is an entry of the stiffness."""
    force, _, motion = name.partition("_by_")

    def get(solution: Any) -> Any:  # works on Solutions too, all cases at once
        return solution.stiffness[..., row, column]

    return Quantity(name, f"d {force} / d {motion}", "", unit, get, shown, scale, "stiffness")


def _by_approach_on_lever(solution: Any) -> Any:
    return solution.stiffness[..., 0, 0] * solution.contact_length


_ALL = (
    _own("approach", "approach", "delta", "mm", "um", meaning="how much closer the bodies are than at first touch"),
    _own("penetration", "penetration", "", "mm", "um", meaning="approach beyond first touch at this tilt"),
    _own("tilt", "tilt", "gamma", "rad", "mrad", meaning="rotation about x; positive: loads the positive-y side"),
    _own("load", "load", "Q", "N", meaning="integral of the pressure"),
    _own(
        "moment", "moment", "T", "N mm", scale=lambda solution: solution.load * solution.contact_length,
        meaning="integral of the pressure times y",
    ),
    _own("max_pressure", "maximum pressure", "", "MPa", meaning="largest more than a half-width from singular ends"),
    _own("max_pressure_y", "position of the maximum", "", "mm"),
    _own("max_half_width", "largest half-width", "", "mm", meaning="largest more than a half-width from singular ends"),
    _own("contact_length", "length of contact", "", "mm"),
    _slope(0, 0, "load_by_approach", "N/mm", "N/um"),
    _slope(0, 1, "load_by_tilt", "N/rad", "N/mrad", _by_approach_on_lever),
    _slope(1, 0, "moment_by_approach", "N mm/mm", "N mm/um", _by_approach_on_lever),
    _slope(1, 1, "moment_by_tilt", "N mm/rad", "N m/mrad"),
)  # fmt: skip

#: Every number of a solution, by name.
QUANTITIES: dict[str, Quantity] = {quantity.name: quantity for quantity in _ALL}


def attributes(*quantities: tuple[str, str, str]) -> dict[str, Quantity]:
    """Return quantities that are attributes of the solution, given as name, label and unit, by name."""
    return {name: _own(name, label, "", unit) for name, label, unit in quantities}


#: Arrays along the contact, by name.
ALONG: dict[str, Quantity] = attributes(
    ("y", "centre of every strip", "mm"),
    ("strip_width", "width of every strip", "mm"),
    ("line_load", "load per length of every strip", "N/mm"),
    ("centre_pressure", "pressure on the centre line of every strip", "MPa"),
    ("half_width", "half-width across of every strip", "mm"),
    ("gap", "distance of the deformed surfaces on the centre line; zero in contact", "mm"),
)
