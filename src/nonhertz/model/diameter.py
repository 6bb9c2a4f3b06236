"""Diameters of bodies: a number, a table along the axis, or a function."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Real
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import LEAST, finite, numbers, positive
from nonhertz.inputs.descriptions import Quantities
from nonhertz.inputs.fields import Input, cross_check, input_class

Array = NDArray[np.float64]
DIAMETER_REMEDY = "give the diameter in mm, negative for a concave surface, or leave it out for a flat one"


@input_class()
class TabulatedDiameter(Input):
    """A diameter that changes along the axis, linear between points.

    Examples
    --------
    >>> tapered = TabulatedDiameter(y=(-10.0, 10.0), diameter=(18.0, 20.0))
    >>> float(tapered(0.0))
    19.0
    """

    y: Annotated[tuple[float, ...], Quantities("mm", "axial positions from the middle of the body, ascending")]
    diameter: Annotated[
        tuple[float, ...], Quantities("mm", "diameters there, all of one sign; 0 only in a bore, where there is none")
    ]

    @cross_check("y", "diameter")
    def _check_length(self) -> None:
        if len(self.y) != len(self.diameter) or len(self.y) < 2:
            raise InputError("y", self.y, "hold as many points as diameter, at least two", "give both lists")

    @cross_check("y")
    def _check_order(self) -> None:
        if not np.all(np.diff(self.y) > 0.0):
            raise InputError("y", self.y, "be finite and ascending", "sort the points along the axis")

    @cross_check("diameter")
    def _check_signs(self) -> None:
        low, high = min(self.diameter, default=1.0), max(self.diameter, default=1.0)
        if low * high < 0.0 or low == high == 0.0:
            raise InputError("diameter", self.diameter, "be finite and of one sign", DIAMETER_REMEDY)

    def __call__(self, y: ArrayLike) -> Array:
        """Return the diameter [mm] at ``y`` [mm]; constant beyond the outermost points."""
        diameter: Array = np.interp(numbers("y", y, "give positions in mm"), self.y, self.diameter)
        return diameter


Diameter = float | TabulatedDiameter | Callable[[Array], ArrayLike] | None


def convex(diameter: Diameter) -> bool:
    """Return whether a diameter is positive, as far as that is known before the contact is placed."""
    if isinstance(diameter, TabulatedDiameter):
        return max(diameter.diameter) > 0.0
    return callable(diameter) or (isinstance(diameter, Real) and diameter > 0.0)


def check_diameter(name: str, value: Any, remedy: str) -> None:
    """Refuse anything but the diameter of a surface."""
    if isinstance(value, TabulatedDiameter):
        if 0.0 in value.diameter:
            raise InputError(name, value.diameter, "not be zero", remedy)
    elif not callable(value):
        finite(name, value, remedy)
        if abs(value) < LEAST:
            condition = f"be at least {LEAST:g} in magnitude" if value else "not be zero"
            raise InputError(name, value, condition, remedy)


def check_bore(name: str, value: Any, remedy: str) -> None:
    """Refuse anything but the diameter of a bore."""
    if not isinstance(value, TabulatedDiameter):
        positive(name, value, remedy)
    elif min(value.diameter) < 0.0:
        raise InputError(name, value.diameter, "be positive", remedy)
