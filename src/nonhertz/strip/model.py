"""A contact as the core in C++ sees it: made once for a contact, and used by any number of threads."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from nonhertz.bodies.formulas import curvature_of, of_whole_arrays, relief_of_body
from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.bodies.stored import MOST
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.strip.element import ELEMENTS, SEMI_ELLIPTIC, Element
from nonhertz.strip.free_end import free_end_table

#: Each element with a table that the core makes itself.
IN_CORE = {"semi-elliptic": core.SEMI_ELLIPTIC, "parabolic": core.PARABOLIC}


def model_of(
    contact: Contact, element: Element = SEMI_ELLIPTIC, *, as_functions: bool = False, same_table: bool = True
) -> core.Model:
    """Return the core's model of a contact.

    Parameters
    ----------
    contact : Contact
        The bodies.
    element : Element
        The strip element.
    as_functions : bool
        Whether every profile is called in Python, also those that the core has a formula of: for comparisons.
    same_table : bool
        Whether the element reads the table made in Python: for comparisons.

    Raises
    ------
    InputError
        If a depth is in diameters of a body that is not convex.
    """
    influence = influence_of(contact, element)
    return core.Model(
        bodies=[_body(body, as_functions) for body in (contact.a, contact.b)],
        kernel=kernel_of(influence, element, same_table=same_table),
        references=[each.core for each in influence.references],
        freed=[core.FreedFace(end.y, end.side, end.image_weight, end.free) for end in influence.ends],
        compliance=contact.compliance,
        interval=contact.interval,
        bends=np.array(contact.bends, dtype=float),
        crests=np.array(contact.crests, dtype=float),
        # Of a twin: a contact that is kept by what it keeps would stay for ever.
        refuse=of_whole_arrays(replace(contact).curvature_at),
    )


def kernel_of(influence: Influence, element: Element, *, same_table: bool = False) -> core.Kernel:
    """Return how strips act on both surfaces; ``same_table`` as for `model_of`."""
    own = IN_CORE[element.name] if ELEMENTS.get(element.name) == element else None
    return core.Kernel(
        _with_table_of(element) if same_table or own is None else own,
        [core.Term(*term) for term in influence.terms.tolist()],
        [core.Face(face.y, face.side, face.share, _face_table(element, face.poisson)) for face in influence.faces],
    )


def _body(body: Body, as_functions: bool) -> core.Body:
    relief = core.Relief.function(of_whole_arrays(body.relief_at)) if as_functions else relief_of_body(body)
    return core.Body(relief, curvature_of(body), body.material.modulus)


@lru_cache(MOST)
def _face_table(element: Element, poisson: float) -> core.FaceTable:
    return core.FaceTable(free_end_table(element, poisson))


@lru_cache
def _with_table_of(element: Element) -> core.Element:
    return core.Element(
        element.name, element.line_factor, element.hertz_ratio, element.far_constant, np.ravel(element.table)
    )
