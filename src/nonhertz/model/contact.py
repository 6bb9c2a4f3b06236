"""Two bodies in contact."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import cached_property
from typing import Annotated, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.descriptions import Part
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.body import Body, BodyName
from nonhertz.model.profile.base import places

Array = NDArray[np.float64]
Derived = TypeVar("Derived")

# Fraction of the distance from y = 0 by which two bodies must overlap, so that positions within can be distinguished.
RESOLVED = 1e-8


_MADE_BY = "make one with Roller, Ring, Plate or Body"


@input_class()
class Contact(Input):
    """Two bodies that are about to touch along the y axis.

    y runs along the contact, x across it, in the direction of rolling. Positions of both bodies have the same origin.

    Raises
    ------
    InputError
        If the bodies do not overlap along y, or their combined curvature is not positive.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> contact = Contact(Roller(diameter=20, length=20), Plate())
    >>> contact.interval
    (-10.0, 10.0)
    >>> float(contact.curvature(0.0))
    0.1
    """

    a: Annotated[Body, Part("one body; the order matters only for results about each body", Body, _MADE_BY)]
    b: Annotated[Body, Part("the other body", Body, _MADE_BY)]

    @cross_check("a", "b")
    def _check_overlap(self) -> None:
        low, high = self.interval
        if not low < high:
            raise InputError(
                "position", self.b.position, "let the bodies overlap along y", "move one body or lengthen it"
            )
        if high - low < RESOLVED * max(abs(low), abs(high)):
            condition = f"let the bodies overlap by more than {RESOLVED:g} of their distance from y = 0"
            raise InputError("position", self.b.position, condition, "move both bodies towards y = 0")

    @property
    def bodies(self) -> dict[BodyName, Body]:
        """Both bodies by name."""
        return {"a": self.a, "b": self.b}

    @cached_property
    def interval(self) -> tuple[float, float]:
        """The axial interval [mm] on which both bodies can touch; infinite on a side where neither ends."""
        (low_a, high_a), (low_b, high_b) = self.a.interval, self.b.interval
        return (max(low_a, low_b), min(high_a, high_b))

    @property
    def land(self) -> tuple[float, float]:
        """The part of ``interval`` [mm] without corners or chamfers; its length is the effective length of ISO 281."""
        (low_a, high_a), (low_b, high_b) = self.a.land, self.b.land
        low, high = max(low_a, low_b), min(high_a, high_b)
        # Chamfers may leave nothing between them, and the lands of the two bodies may not overlap.
        return (low, high) if low < high else self.interval

    @cached_property
    def bends(self) -> tuple[float, ...]:
        """Axial positions [mm] where either relief bends, ascending."""
        return tuple(sorted({*self.a.bends, *self.b.bends}))

    @cached_property
    def crests(self) -> tuple[float, ...]:
        """Axial positions [mm] at which either relief may have a peak, ascending; they include the bends."""
        return tuple(sorted({*self.a.crests, *self.b.crests, *self.bends}))

    @cached_property
    def compliance(self) -> float:
        """Sum of both half-space compliances K = (1 - nu^2) / (pi E) [1/MPa]."""
        return self.a.material.compliance + self.b.material.compliance

    @cached_property
    def _derived(self) -> dict[Hashable, Any]:
        return {}

    def __getstate__(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in self.descriptions}

    def separation(self, y: ArrayLike) -> Array:
        """Return the undeformed separation h [mm] on the centre line at ``y`` [mm]: the sum of both reliefs."""
        return self.separation_at(places(y))

    def separation_at(self, y: Array) -> Array:
        """Return the separation at positions that are known to be finite numbers."""
        return self.a.relief_at(y) + self.b.relief_at(y)

    def curvature(self, y: ArrayLike) -> Array:
        """Return the combined curvature 1/rho = 1/rho_a + 1/rho_b [1/mm] across the contact at ``y`` [mm].

        Raises
        ------
        InputError
            If it is not positive somewhere: the surfaces conform there and the method does not hold.
        """
        return self.curvature_at(places(y))

    def curvature_at(self, y: Array) -> Array:
        """Return the curvature at positions that are known to be finite numbers."""
        combined = self.a.curvature_at(y) + self.b.curvature_at(y)
        if np.any(combined <= 0.0):
            raise InputError(
                "diameter",
                (self.a.diameter, self.b.diameter),
                "leave a positive combined curvature",
                "make the concave body's diameter larger than the convex one's",
            )
        return combined


def sharper_curvature(contact: Contact, y: Array) -> Array:
    """Return the larger of the two bodies' curvatures across the contact [1/mm], in magnitude."""
    return np.maximum(np.abs(contact.a.curvature_at(y)), np.abs(contact.b.curvature_at(y)))


def get_or_compute(contact: Contact, what: Hashable, make: Callable[[], Derived]) -> Derived:
    """Return a value derived from a contact, computed by ``make`` once and stored with the contact."""
    known = contact._derived
    if what not in known:
        known[what] = make()
    value: Derived = known[what]
    return value
