"""Influence of loads on the surfaces of two bodies: direct effect, mirror images, and reference points.

Each contribution is a *term*: a row (sign, offset, weight) that maps y to ``sign * y + offset`` and is multiplied by
``weight``. The direct effect is the term (1, 0, 1); a mirror image about a face at f is (-1, 2 f, weight).
Displacements are measured against *references*, such as points at depth, which also move: a matrix for each grid gives
their displacement.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.depths import AxisOfRoller, Reference, reference_of
from nonhertz.bodies.ends import IN_SPACE, End, corner_weights, ends, shares
from nonhertz.bodies.images import DIRECT, Images, rows
from nonhertz.bodies.shape import Shape
from nonhertz.model.contact import Contact

Array = NDArray[np.float64]

#: The direct effect alone, as `Influence.terms`: two half-spaces.
HALF_SPACE = np.array([[*DIRECT, 1.0]])


@dataclass(frozen=True)
class FreeSide:
    """A side face that is also free of normal stress.

    Attributes
    ----------
    y : float
        Position [mm].
    side : int
        -1 at the low, 1 at the high end of its body.
    share : float
        Share of its body in the compliance of the contact, times its weight where the corner is not a right angle.
    poisson : float
        Poisson's ratio of its body.
    """

    y: float
    side: int
    share: float
    poisson: float


@dataclass(frozen=True)
class Influence:
    """Effect of strips on the centre line: on both surfaces, and on the references of their displacement.

    Attributes
    ----------
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight); see the module.
    references : tuple of Reference
        One for each body whose displacement is not measured against a point far away.
    ends : tuple of End
        The free side faces that the images in ``terms`` are about.
    faces : tuple of FreeSide
        Those of them that are also free of normal stress. The stress that images about one face leave on another is not
        removed.
    """

    terms: Array
    references: tuple[Reference, ...] = ()
    ends: tuple[End, ...] = ()
    faces: tuple[FreeSide, ...] = ()

    def at_depth(self, y: Array, edges: Array) -> Array:
        """Return the displacement of the references under ``y`` per unit of K q, shape (places, strips)."""
        if not self.references:
            return np.zeros((y.size, edges.size - 1))
        first, *others = (reference.displacement(y, edges) for reference in self.references)
        return sum(others, first)

    def by_width(self, y: Array, ratio: float) -> Array:
        """Return the effect of half-widths, ``ratio`` times Hertz's, on strips at ``y``; see `WholeRoller.by_width`."""
        rollers = (reference for reference in self.references if isinstance(reference, AxisOfRoller))
        return sum((reference.by_width(y, ratio) for reference in rollers), np.zeros((4, y.size)))


def influence_of(contact: Contact, shape: Shape) -> Influence:
    """Return the influence of strips between two bodies, with their side faces and depths."""
    ends_of_contact = ends(contact)
    terms, references, faces = {DIRECT: 1.0}, [], []
    for which in (0, 1):
        images, reference, free = _of_body(contact, shape, ends_of_contact, which)
        for place, weight in images.places.items():
            terms[place] = terms.get(place, 0.0) + weight
        if reference is not None:
            references.append(reference)
        faces += free
    return Influence(rows(terms), tuple(references), ends_of_contact, tuple(faces))


def influence_within(contact: Contact, shape: Shape, which: int) -> Influence:
    """Return the influence of strips on body a (0) or b (1) alone, with the weights of the contact's solution.

    Weights, also of the direct effect, include the body's share of the compliance of the contact.
    """
    ends_of_contact = ends(contact)
    images, reference, free = _of_body(contact, shape, ends_of_contact, which)
    return Influence(images.with_direct(), () if reference is None else (reference,), ends_of_contact, tuple(free))


def _of_body(
    contact: Contact, shape: Shape, ends_of_contact: tuple[End, ...], which: int
) -> tuple[Images, Reference | None, list[FreeSide]]:
    body, share = (contact.a, contact.b)[which], shares(contact)[which]
    weights = {end.side: end.weights[which] for end in ends_of_contact if end.weights[which] > 0.0}
    images = Images.of(body, (weights.get(-1, 0.0), weights.get(1, 0.0)), share)
    free = [
        FreeSide(y, side, share * (1.0 + IN_SPACE * corner_weights(angle)[1]), body.material.poisson)
        for y, side, is_free, angle in zip(body.faces, (-1, 1), body.free_faces, body.corner_angles, strict=True)
        if is_free
    ]
    return images, reference_of(body, shape, images), free
