"""What strips have to satisfy: a contact, and what presses its bodies together."""

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
    """A contact as strips of one element see it, whatever is prescribed and wherever they lie.

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
        """Return the model of a contact, which is kept with it."""
        # Of a twin: a contact that is kept by what it keeps would stay until Python looks for cycles.
        return get_or_compute(contact, (cls, id(element)), lambda: cls(replace(contact), element))

    def __reduce__(self) -> tuple[Any, ...]:
        return StripModel, (self.contact, self.element)

    @cached_property
    def influence(self) -> Influence:
        """How strips act."""
        return influence_of(self.contact, self.element)

    @cached_property
    def in_core(self) -> core.Model:
        """The same for the core."""
        return model_of(self.contact, self.element)


@dataclass(frozen=True)
class Problem:
    """What the strips have to satisfy, on any grid.

    Attributes
    ----------
    contact : Contact
        The bodies, as the user gave them.
    model : StripModel
        The same as strips see them.
    by_force : tuple of bool
        Whether the load (else the approach) and the moment (else the tilt) are given.
    target : tuple of float
        K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad], where K is the compliance of the contact.
    accuracy : float or None
        Relative error of approach or load that the automatic grid aims for; None where strips are given.
    accuracy_given : bool
        Whether the user gave that.
    pressure_accuracy : float or None
        Relative error of the largest pressure that it aims for too, if any.
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
