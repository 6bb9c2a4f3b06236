"""Contacts of rollers by the strip-element method, each on strips that are kept from one step to the next.

The core lays and solves them; see ``src/core/bearing/strip_law.hpp``.
"""

from __future__ import annotations

from dataclasses import replace

from nonhertz.amounts import mrad, um
from nonhertz.errors import ConvergenceError
from nonhertz.model.contact import Contact, derived
from nonhertz.native import core
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.model import model_of


def stripped(contact: Contact, element: Element = SEMI_ELLIPTIC) -> core.StrippedContact:
    """Return a contact between roller and ring, to be solved on strips.

    Parameters
    ----------
    contact : Contact
        Roller and ring.
    element : Element
        The strip element.

    Raises
    ------
    InputError
        If a depth is in diameters of a body that is not convex.
    """
    # Of a twin: a contact that is kept by what it keeps would stay for ever.
    model = derived(contact, (core.Model, id(element)), lambda: model_of(replace(contact), element))
    return core.StrippedContact(model)


def unsolved(error: core.Unsolved) -> ConvergenceError:
    """Return what a contact of a roller without a solution is told as."""
    approach, tilt = error.args
    at = f"an approach of {um(approach):.6g} and a tilt of {mrad(tilt):.6g}"
    return ConvergenceError(f"The contact of a roller at {at} has no solution: is a load too large?", None)
