"""The problem that strips solve: a contact and its loading."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.model.contact import Contact, get_or_compute
from nonhertz.native import core
from nonhertz.strip.element import Element
from nonhertz.strip.model import model_of

Flags = tuple[bool, bool]
Target = tuple[float, float]


@dataclass(frozen=True, eq=False)
class StripModel:
    """A contact for strips of one element, independent of loading and grid.

    Attributes
    ----------
    contact : Contact
        The bodies.
    element : Element
        The strip element.
    """

    contact: Contact
    element: Element

    @classmethod
    def of(cls, contact: Contact, element: Element) -> StripModel:
        """Return the model of a contact, which is stored with it."""
        # Holds a copy: a reference back to the contact would keep it alive until Python collects cycles.
        return get_or_compute(contact, (cls, id(element)), lambda: cls(replace(contact), element))

    def __reduce__(self) -> tuple[Any, ...]:
        return StripModel, (self.contact, self.element)

    @cached_property
    def influence(self) -> Influence:
        """Influence of the strips."""
        return influence_of(self.contact, self.element)

    @cached_property
    def in_core(self) -> core.Model:
        """The same for the core."""
        return model_of(self.contact, self.element)


@dataclass(frozen=True)
class Problem:
    """The conditions that the strips have to satisfy, on any grid.

    Attributes
    ----------
    contact : Contact
        The bodies, as the user gave them.
    model : StripModel
        The same bodies for strips.
    by_force : tuple of bool
        Whether the load (else the approach) and the moment (else the tilt) are given.
    target : tuple of float
        K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad], where K is the compliance of the contact.
    accuracy : float or None
        Relative error of approach or load that the automatic grid aims for; None where strips are given.
    accuracy_given : bool
        Whether the user gave that.
    pressure_accuracy : float or None
        Relative error of the maximum pressure that the grid also aims for, if any.
    """

    contact: Contact
    model: StripModel
    by_force: Flags
    target: Target
    accuracy: float | None = None
    accuracy_given: bool = False
    pressure_accuracy: float | None = None

    def of(self, target: Target) -> Problem:
        """Return the problem with another target."""
        return replace(self, target=target)
