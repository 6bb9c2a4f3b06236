"""The ends of a contact at which the pressure has no limit, and which strips are away from them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import Contact, derived
from nonhertz.model.profile.base import SAME_PLACE
from nonhertz.result.maximum import distance_beyond, singular_y
from nonhertz.result.solution import EdgeKind, EdgePressure, SingularEnd, Solved
from nonhertz.strip.overlaps import runs

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

# A contact that extends past a corner by less than this, in half-widths, ends there: fine strips reach round it.
PAST_CORNER = 0.1
# The pressure at a corner that turns by theta grows by theta / (2 pi^2 K) each time the distance falls by a factor e.
# Where that is less than this fraction of it, refinement makes no significant difference.
COUNTS = 0.02
LEFT_AT_CORNER = 0.5  # of the squared pressure in the strip next to it: if extrapolation leaves less, it is a run-out
# Of the largest pressure: where less is left at a corner, the contact runs out there, as near as its end is known.
RUNS_OUT = 0.05
STEP = 1e-5  # of the length: step of the differences that distinguish a corner from a curve
KEPT_TURNS = 64


def away_from_ends(solution: Solved, y: Array) -> Flags:
    """Return which places [mm] are more than a half-width from the singular ends of a contact, shape (n,).

    Closer to such an end the pressure grows with every refinement, so it is meaningless as a maximum.
    """
    half_width = np.interp(y, solution.y, solution.half_width)
    away: Flags = distance_beyond(y, half_width, singular_y(solution)) > 0.0
    return away


def leaves_stress(contact: Contact, edge: EdgePressure) -> bool:
    """Return whether a side face at the end of a contact is freed of shear alone, which makes the body too stiff."""
    faces = [
        (face, weight, free)
        for body in (contact.a, contact.b)
        for face, weight, free in zip(body.faces, body.face_weights, body.free_faces, strict=True)
    ]
    return any(weight > 0.0 and not free and abs(face - edge.y) <= edge.strip_width for face, weight, free in faces)


def singular_ends(sharp: Iterable[float], corners: Iterable[float], length: float) -> tuple[SingularEnd, ...]:
    """Return the ends at which the pressure has no limit, ascending: sharp ends of bodies, corners of profiles.

    Parameters
    ----------
    sharp : iterable of float
        Where the contact reaches a sharp end [mm].
    corners : iterable of float
        From `corner_ends` [mm]; those at a sharp end count as sharp.
    length : float
        Length of the region that the contact may cover [mm].
    """
    found = [SingularEnd(y, EdgeKind.SINGULAR) for y in sharp]
    room = SAME_PLACE * length
    found += [SingularEnd(y, EdgeKind.CORNER) for y in corners if all(abs(y - end.y) > room for end in found)]
    return tuple(sorted(found, key=lambda end: end.y))


def corner_ends(contact: Contact, edges: Array, pressure: Array, half_width: Array) -> tuple[float, ...]:
    """Return the corners of the profile at which a contact ends under pressure [mm], ascending.

    There the pressure has no limit, as at a sharp end: it does not fall towards the corner, and beyond it the surfaces
    are apart. A contact that runs out next to a corner does not count, because its pressure falls to zero.

    Parameters
    ----------
    contact : Contact
        What was solved.
    edges : ndarray, shape (n + 1,)
        Edges of strips, or of rows of cells [mm].
    pressure, half_width : ndarray, shape (n,)
        Largest pressure [MPa] and half-width [mm] of each, zero out of contact.
    """
    found: set[float] = set()
    y = 0.5 * (edges[1:] + edges[:-1])
    for first, last in runs(pressure > 0.0):
        room = PAST_CORNER * float(half_width[first : last + 1].max())
        # Outermost strip first; multiplied by ``side``, positions increase outwards.
        for side, run in ((-1.0, np.arange(first, last + 1)), (1.0, np.arange(last, first - 1, -1))):
            beyond = run[0] + int(side)
            outermost = y[beyond] if 0 <= beyond < y.size else edges[run[0] + (side > 0.0)]
            inner = min(side * edges[run[0] + (side < 0.0)], side * y[run[0]] - room)
            near = [bend for bend in contact.bends if inner < side * bend < side * outermost]
            found.update(bend for bend in near if _presses(contact, bend, side, y, pressure, run))
    return tuple(sorted(found))


def _presses(contact: Contact, bend: float, side: float, y: Array, pressure: Array, run: NDArray[np.int64]) -> bool:
    """Return whether a bend is a corner that a contact presses against; ``run`` are its strips, outermost first."""
    within = run[side * y[run] < side * bend]
    if within.size == 0:
        return False
    step = STEP * float(np.ptp(y)) if y.size > 1 else STEP
    turn = min(_turn(contact, bend, step), 2.0 * _turn(contact, bend, 0.1 * step))
    beside = float(pressure[within[0]])
    if turn < COUNTS * 2.0 * np.pi**2 * contact.compliance * beside or beside < RUNS_OUT * float(pressure.max()):
        return False
    if within[0] != run[0] and within.size > 1 and pressure[within[0]] < pressure[within[1]]:
        return False
    if within.size == 1:
        return True
    # The square of the pressure falls linearly to zero where a contact runs out. Given three strips the outermost is
    # left out, because it may carry load for what lies beyond it.
    last, next_in = within[1:3] if within.size > 2 else within[:2]
    square = float(pressure[last] ** 2)
    fall = (float(pressure[next_in] ** 2) - square) / abs(y[next_in] - y[last])
    return bool(square - fall * abs(bend - y[last]) > LEFT_AT_CORNER * square)


def _turn(contact: Contact, place: float, step: float) -> float:
    """Return by how much the slope of the separation increases across a place [rad]."""
    known = derived(contact, "turns", dict[tuple[float, float], float])
    turn = known.get((place, step))
    if turn is None:
        before, there, after = contact.separation_at(np.array([place - step, place, place + step])).tolist()
        turn = float((after - there) / step + (before - there) / step) if np.isfinite(there) else 0.0
        if len(known) >= KEPT_TURNS:
            known.clear()
        known[place, step] = turn
    return turn


def ends_in_words(ends: Iterable[SingularEnd]) -> Finding:
    """Return in words where pressure and stress have no limit.

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
