"""Contacts of rollers by the strip-element method, each on strips that are reused from one step to the next.

The core lays and solves the strips; see ``src/core/bearing/strip_law.hpp``.
"""

from __future__ import annotations

from nonhertz.amounts import mrad, um
from nonhertz.errors import ConvergenceError
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.problem import StripModel


def cut_into_strips(contact: Contact, element: Element = SEMI_ELLIPTIC) -> core.StrippedContact:
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
    return core.StrippedContact(StripModel.of(contact, element).in_core)


def no_solution_error(error: core.Unsolved) -> ConvergenceError:
    """Return the error of a roller contact without a solution, with a remedy."""
    approach, tilt = error.args
    at = f"a roller pressed {um(approach):.4g} into its raceway at a tilt of {mrad(tilt):.4g} has no solution"
    remedy = "give smaller loads or displacements, or check their units"
    return ConvergenceError(f"The contact of {at}: {remedy}.", None)
