"""A contact in the C++ core: made once for a contact and used by any number of threads."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths import in_core
from nonhertz.bodies.formulas import apply_to_whole_arrays, curvature_of, relief_of_body
from nonhertz.bodies.influence import influence_of
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.influence import kernel_of

Array = NDArray[np.float64]


def model_of(contact: Contact, element: Element = SEMI_ELLIPTIC, *, as_functions: bool = False) -> core.Model:
    """Return the core's model of a contact.

    Parameters
    ----------
    contact : Contact
        The bodies.
    element : Element
        The strip element.
    as_functions : bool
        Whether every profile is called in Python, even if the core has its formula: for comparisons.

    Raises
    ------
    InputError
        If a depth is in diameters of a body that is not convex.
    """
    influence = influence_of(contact, element)
    return core.Model(
        bodies=[_body(body, as_functions) for body in (contact.a, contact.b)],
        kernel=kernel_of(influence, element),
        references=[in_core(reference) for reference in influence.references],
        freed=[core.FreedFace(end.y, end.side, end.image_weight, end.free) for end in influence.ends],
        compliance=contact.compliance,
        interval=contact.interval,
        bends=np.array(contact.bends, dtype=float),
        crests=np.array(contact.crests, dtype=float),
        # Holds the bodies only: a reference back to the contact would keep it alive for ever.
        refuse=apply_to_whole_arrays(partial(_curvature, contact.a, contact.b)),
    )


def _curvature(a: Body, b: Body, y: Array) -> Array:
    return Contact(a, b).curvature_at(y)


def _body(body: Body, as_functions: bool) -> core.Body:
    relief = core.Relief.function(apply_to_whole_arrays(body.relief_at)) if as_functions else relief_of_body(body)
    return core.Body(relief, curvature_of(body), body.material.modulus)
