"""A contact as the core sees it: made once for a contact, kept with it, and used by any number of threads."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths import AxisOfRoller, PointsAtDepth, Reference
from nonhertz.bodies.influence import influence_of
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.model.profile.base import Moved, Profile, Straight, Sum
from nonhertz.model.profile.circular import Arcs
from nonhertz.model.profile.logarithm import Logarithmic
from nonhertz.native import core
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.free_end import free_end_table

Array = NDArray[np.float64]

ELEMENTS = {"semi-elliptic": core.SEMI_ELLIPTIC, "parabolic": core.PARABOLIC}


def model_of(
    contact: Contact, element: Element = SEMI_ELLIPTIC, *, as_functions: bool = False, same_table: bool = False
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
    """
    influence = influence_of(contact, element)
    shape = ELEMENTS[element.name]
    bodies = [_body(body, as_functions) for body in (contact.a, contact.b)]
    tables = {face.poisson: core.FaceTable(np.array(free_end_table(element, face.poisson))) for face in influence.faces}
    return core.Model(
        bodies,
        core.element(shape, element.table) if same_table else shape,
        [core.Term(*term) for term in influence.terms.tolist()],
        [core.Face(face.y, face.side, face.share, tables[face.poisson]) for face in influence.faces],
        [_reference(each) for each in influence.references],
        [core.FreedFace(end.y, end.side, end.image_weight, end.free) for end in influence.ends],
        contact.compliance,
        contact.interval,
        np.array(contact.bends),
        np.array(contact.crests),
    )


def _body(body: Body, as_functions: bool) -> core.Body:
    parts = [core.Moved(core.Function(_float(body.surface.relief_at)), 1.0, 0.0, False, -math.inf, math.inf)]
    if not as_functions:
        parts = list(_parts(body.surface))
    curvature = float(body.curvature_at(np.zeros(1))[0])
    return core.Body(core.Relief(parts, body.position, *body.surface.extent), curvature, body.material.modulus)


def _parts(profile: Profile, scale: float = 1.0, shift: float = 0.0, flip: bool = False) -> Iterator[core.Moved]:
    """Yield the formulas that a profile is made of; what is none of the core's own is called in Python."""
    if type(profile) is Straight:
        return
    if type(profile) is Sum:
        for part in profile.parts:
            yield from _parts(part)
        return
    if type(profile) is Moved and type(profile.profile) in FORMULAS:
        yield from _parts(profile.profile, profile.scale, profile.shift, profile.flip)
        return
    make = FORMULAS.get(type(profile))
    formula = make(profile) if make else core.Function(_float(profile.relief_at))
    yield core.Moved(formula, scale, shift, flip, *profile.extent)


FORMULAS: dict[type[Profile], Callable[[Any], Any]] = {
    Arcs: lambda of: core.Arcs(of.radius, of.end_radius, of.junction, of.end_summit),
    Logarithmic: lambda of: core.Logarithmic(of.amplitude, of.length, of.rest, of.curved, of.at_end),
}


def _float(relief: Callable[[Array], Array]) -> Callable[[Array], Array]:
    return lambda y: np.ascontiguousarray(relief(y), dtype=float)


def _reference(of: Reference) -> core.AxisOfRoller | core.PointsAtDepth:
    if isinstance(of, AxisOfRoller):
        whole = of.whole
        own = -float(whole.by_width(np.ones(1))[0, 0])
        return core.AxisOfRoller(
            of.radius, of.middle, of.share, whole.outline.half_length, np.ascontiguousarray(whole.matrix),
            np.ascontiguousarray(whole.curved), whole.logarithm, own,
        )  # fmt: skip
    assert isinstance(of, PointsAtDepth) and of.far is None
    return core.PointsAtDepth(
        float(of.below(np.zeros(1))[0]), of.poisson_factor, [core.Term(*term) for term in of.terms.tolist()],
        [core.FreeFace(*face) for face in of.faces.tolist()], np.array(of.over_image),
    )  # fmt: skip
