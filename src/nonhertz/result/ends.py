"""The ends of a contact at which the pressure is unbounded, and the strips that are away from them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import Contact
from nonhertz.model.profile.base import SAME_PLACE
from nonhertz.native import core
from nonhertz.result.edges import EdgeKind, EdgePressure, SingularEnd
from nonhertz.result.maximum import distance_beyond, singular_y
from nonhertz.result.solved import Solved

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


def away_from_ends(solution: Solved, y: Array) -> Flags:
    """Return which places [mm] are more than a half-width from the singular ends of a contact, shape (n,).

    Closer to such an end the pressure grows with every refinement, so it is meaningless as a maximum.
    """
    half_width = np.interp(y, solution.y, solution.half_width)
    away: Flags = distance_beyond(y, half_width, singular_y(solution)) > 0.0
    return away


def leaves_stress(contact: Contact, edge: EdgePressure) -> bool:
    """Return whether a side face at the end of a contact is freed of shear only, which makes the body too stiff."""
    faces = [
        (face, weight, free)
        for body in (contact.a, contact.b)
        for face, weight, free in zip(body.faces, body.face_weights, body.free_faces, strict=True)
    ]
    return any(weight > 0.0 and not free and abs(face - edge.y) <= edge.strip_width for face, weight, free in faces)


def singular_ends(sharp: Iterable[float], corners: Iterable[float], length: float) -> tuple[SingularEnd, ...]:
    """Return the ends at which the pressure is unbounded, ascending: sharp ends of bodies, corners of profiles.

    Parameters
    ----------
    sharp : iterable of float
        Where the contact reaches a sharp end [mm].
    corners : iterable of float
        From `corner_ends` [mm]; those at a sharp end count as sharp.
    length : float
        Length of the region that the contact may cover [mm].
    """
    ends = [SingularEnd(y, EdgeKind.SINGULAR) for y in sharp]
    room = SAME_PLACE * length
    ends += [SingularEnd(y, EdgeKind.CORNER) for y in corners if all(abs(y - end.y) > room for end in ends)]
    return tuple(sorted(ends, key=lambda end: end.y))


def corner_ends(contact: Contact, edges: Array, pressure: Array, half_width: Array) -> tuple[float, ...]:
    """Return the corners of the profile at which a contact ends under pressure [mm], ascending.

    There the pressure is unbounded, as at a sharp end: it does not fall towards the corner, and beyond it the surfaces
    are apart. A contact that runs out next to a corner does not count, because its pressure falls to zero.

    Parameters
    ----------
    contact : Contact
        The solved contact.
    edges : ndarray, shape (n + 1,)
        Edges of strips, or of rows of cells [mm].
    pressure, half_width : ndarray, shape (n,)
        Maximum pressure [MPa] and half-width [mm] of each, zero out of contact.
    """
    bends = np.array(contact.bends, dtype=float)
    places = core.corner_ends(bends, contact.compliance, contact.separation_at, edges, pressure, half_width)
    return tuple(places)


def ends_in_words(ends: Iterable[SingularEnd]) -> Finding:
    """Return in words where pressure and stress are unbounded.

    Examples
    --------
    >>> str(ends_in_words([SingularEnd(-10.0, EdgeKind.SINGULAR), SingularEnd(9.0, EdgeKind.CORNER)]))
    'the sharp end at y = -10 mm and the corner of the profile at y = 9 mm'
    """
    parts, numbers = [], {}
    for one, many, kind in (
        ("sharp end", "sharp ends", EdgeKind.SINGULAR),
        ("corner of the profile", "corners of the profile", EdgeKind.CORNER),
    ):
        places = sorted({end.y for end in ends if end.kind is kind})
        if places:
            name = one if len(places) == 1 else many
            parts.append(f"the {name} at y = {{{kind.name}:.5g}}")
            numbers[kind.name] = mm(*places, between=" and ")
    return finding("ends", " and ".join(parts), **numbers)


def step_at(solution: Solved, end: SingularEnd) -> float:
    """Return the width of the strip, or of the row of cells, at an end [mm]."""
    edges = solution.edges
    touching = np.flatnonzero(solution.line_load > 0.0)
    distance = np.abs(0.5 * (edges[1:] + edges[:-1]) - end.y)[touching]
    return float(np.diff(edges)[touching[distance.argmin()]])


def outermost(solution: Solved) -> tuple[float, float]:
    """Return the outermost ends [mm] of a contact."""
    return solution.contact_y[0][0], solution.contact_y[-1][1]
