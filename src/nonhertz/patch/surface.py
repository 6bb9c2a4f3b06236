"""The gap of the undeformed surfaces, from the bodies or a function, with all features, checked on every call.

User functions may return anything. Their values are checked only here, so that the error names a faulty function and
the rest of the package gets only arrays of numbers.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.model.contact import Contact

Array = NDArray[np.float64]
Feature = Callable[[Array, Array], ArrayLike]
Gap = Callable[[Array, Array], Array]  # of x and y [mm], of shapes (nx, 1) and (1, ny); infinite without a body

ALIKE = 1e-9  # of the largest relief

_CALLABLE = "give a function of x and y in mm that returns mm"
_RETURN = "let it return a gap in mm for every x and y"


def undeformed_gap(contact: Contact, x: ArrayLike, y: ArrayLike) -> Array:
    """Return the gap x^2 / (2 rho(y)) + h(y) [mm] of the undeformed bodies.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    x, y : array_like
        Positions [mm], broadcast against each other.

    Returns
    -------
    ndarray

    Raises
    ------
    InputError
        If ``contact`` is not a Contact, or a position is not a number.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> undeformed_gap(Contact(Roller(diameter=20, length=20), Plate()), [0.0, 0.2], 5.0).round(6).tolist()
    [0.0, 0.002]
    """
    refuse_no_bodies(contact)
    x, y = positions("x", x), positions("y", y)
    across: Array = 0.5 * x**2 * contact.curvature_at(y) + contact.separation_at(y)
    return across


def refuse_no_bodies(contact: object) -> None:
    """Refuse anything but a contact."""
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")


def positions(name: str, values: ArrayLike) -> Array:
    """Return positions as an array of floats, or refuse them."""
    numbers = np.asarray(values)
    if numbers.dtype.kind not in "fiu":
        raise InputError(name, values, "be numbers", "give positions in mm")
    return np.asarray(numbers, dtype=float)


@dataclass(frozen=True, eq=False)
class Surface:
    """The gap [mm] as a function of x and y.

    Attributes
    ----------
    contact : Contact
        The bodies.
    gap : callable or None
        Replaces the bodies' own gap.
    features : tuple of callable
        Reliefs to add.
    """

    contact: Contact
    gap: Feature | None
    features: tuple[Feature, ...]

    @classmethod
    def checked(cls, contact: Contact, gap: Feature | None, features: Feature | Iterable[Feature]) -> Surface:
        """Return the surface, refusing anything that cannot be called with x and y."""
        several: tuple[Feature, ...]
        if callable(features):
            several = (features,)
        elif isinstance(features, str) or not isinstance(features, Iterable):
            raise InputError("features", features, "be callable with x and y, or several that are", _CALLABLE)
        else:
            several = tuple(features)
        surface = cls(contact, gap, several)
        for name, part in surface.parts():
            _refuse_uncallable(name, part)
        return surface

    def parts(self) -> list[tuple[str, Feature]]:
        """Return every function given, with its name for error messages."""
        named = [(f"features[{i}]", feature) for i, feature in enumerate(self.features)]
        return named if self.gap is None else [("gap", self.gap), *named]

    def changes_across(self, x: Array, y: Array) -> bool:
        """Return whether a feature's relief changes with x of shape (nx, 1) at y of shape (1, ny)."""
        reliefs = (_call_function("features", feature, x, y) for feature in self.features)
        return any(bool(np.any(np.abs(relief - relief[:1]) > ALIKE * np.max(np.abs(relief)))) for relief in reliefs)

    def __call__(self, x: Array, y: Array) -> Array:
        """Return the gap at x of shape (nx, 1) and y of shape (1, ny), of shape (nx, ny).

        Raises
        ------
        InputError
            If a function returns another shape, values that are not real numbers, NaN, or minus infinity.
        """
        shape = np.broadcast_shapes(x.shape, y.shape)
        total: Array = np.zeros(shape)
        if self.gap is None:
            total += undeformed_gap(self.contact, x, y)
        for name, part in self.parts():
            total += _call_function(name, part, x, y)
        return total


def _refuse_uncallable(name: str, part: object) -> None:
    if not callable(part):
        raise InputError(name, part, "be callable with x and y", _CALLABLE)
    if isinstance(part, type):
        raise InputError(name, part, "be callable with x and y, not a class", f"make one: {part.__name__}(...)")
    try:
        signature = inspect.signature(part)
    except ValueError:  # compiled functions may have no signature
        return
    try:
        signature.bind(0.0, 0.0)
    except TypeError:
        raise InputError(name, part, "be callable with x and y", _CALLABLE) from None


def _call_function(name: str, function: Feature, x: Array, y: Array) -> Array:
    """Return the values of a user function, refusing anything but a number for every place."""
    answer = function(x, y)
    try:
        heights = np.asarray(answer)
        spread = np.broadcast_to(heights, np.broadcast_shapes(x.shape, y.shape))
    except ValueError:
        raise InputError(name, function, "return the broadcast shape of x and y", _RETURN) from None
    if heights.dtype.kind not in "fiu":
        raise InputError(name, function, f"return real numbers, not {heights.dtype.name}", _RETURN)
    lowest = heights.min() if heights.size else np.inf  # initial=inf fails for integers
    if np.isnan(lowest) or lowest == -np.inf:
        i = np.unravel_index(int(np.argmin(np.where(np.isnan(spread), -np.inf, spread))), spread.shape)
        place = f"x = {np.broadcast_to(x, spread.shape)[i]:.6g}, y = {np.broadcast_to(y, spread.shape)[i]:.6g}"
        condition = f"return a number everywhere, infinity where nothing can touch, but returns {lowest} at {place}"
        raise InputError(name, function, condition, _RETURN)
    return np.asarray(spread, dtype=float)
