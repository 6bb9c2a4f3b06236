"""One body below the pressure of a solution: the load, its mirror images, and the reference of displacement.

Strips and rectangles each provide the field of their own pressure in a half-space. The field at y of an image, the
pressure mapped to ``sign * y + offset``, is that of the pressure itself at ``sign * (y - offset)``, with the signs of
tau_yz, tau_xy and u_y reversed if the image is mirrored. In a complete series, images too far away to matter
individually are lumped into line loads that begin beyond the last separate image and extend to infinity.
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.images import DIRECT, SEPARATE_LINKS, chains, rows
from nonhertz.bodies.influence import Influence, influence_within
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.model.body import BODIES, Body, BodyName
from nonhertz.model.profile.base import at_ends
from nonhertz.model.side_faces import SERIES
from nonhertz.native import core
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.solution import Solution
from nonhertz.result.solved import Solved
from nonhertz.subsurface.extent import Extent
from nonhertz.subsurface.free_faces import Between, FreeFaceField
from nonhertz.subsurface.rectangles import Rectangles
from nonhertz.subsurface.strips import StripLoad
from nonhertz.subsurface.tails import DISPLACEMENT, Load
from nonhertz.subsurface.wall import Wall

Array = NDArray[np.float64]
U_Z = 2
# Decay of a strip's half-width with the distance along y, and the smallest that counts, relative to the largest.
NARROWING, LEAST = 0.5, 0.05

_BODY_REMEDY = "write 'a' or 'b'"


@dataclass(frozen=True, eq=False)
class Inside:
    """A body under the pressure of a solution.

    Attributes
    ----------
    name : str
        ``"a"`` or ``"b"``.
    body : Body
        The body.
    load : Load
        The pressure.
    terms : ndarray, shape (terms, 3)
        Rows (sign, offset, weight) of the pressure itself and its images in this body, for stress: all have weight 1,
        since no other weight frees a face of shear.
    faces : tuple of FreeFaceField
        Corrections for its free side faces.
    wall : Wall or None
        The additional stress of a hollow roller; None for other bodies.
    influence : Influence
        Displacement of its surface by the solution's strips, per unit of the compliance of the contact: images and free
        side faces with their weights, and the reference.
    edges, pressed, widened : ndarray, shape (stations + 1,) and (stations,)
        Edges along y [mm] and compliance times line load [mm] between them, for displacement at depth; and the
        additional displacement due to their own width [mm].
    afar : tuple of float, or None
        Positions where line loads begin on either side, beyond the last separate image [mm], and their size [N/mm];
        None without further images.
    """

    name: BodyName
    body: Body
    load: Load
    terms: Array
    faces: tuple[FreeFaceField, ...]
    wall: Wall | None
    influence: Influence
    edges: Array
    pressed: Array
    widened: Array
    afar: tuple[float, float, float] | None

    @classmethod
    def of(cls, solution: Solved, name: BodyName) -> Inside:
        """Return body ``name`` of a solution.

        Raises
        ------
        InputError
            If ``name`` is neither body, or ``solution`` is not a solution.
        """
        by_body = _KEPT.setdefault(check_solution(solution), {})
        if check_body(name) in by_body:
            return by_body[name]
        load: Load
        if by_body:
            load = next(iter(by_body.values())).load
        elif isinstance(solution, Solution):
            load = StripLoad.of(solution)
        else:
            assert isinstance(solution, PatchSolution)
            load = Rectangles.of(solution.x, solution.y, solution.dx, solution.dy, solution.pressure)
        which = BODIES.index(name)
        body = solution.contact.bodies[name]
        low, high = (float(weight > 0.0) for weight in body.face_weights)
        terms = rows({DIRECT: 1.0, **chains(body, (low, high), 1.0)})
        freed = [weight > 0.0 and side.of_body for side, weight in zip(body.sides, body.face_weights, strict=True)]
        afar = None
        # The bending of a hollow roller is defined relative to these images only.
        if (all(freed) and body.bore is None) or (body.images == SERIES and terms.shape[0] > SEPARATE_LINKS):
            apart = terms.shape[0] // 2 * (body.length or 0.0)
            mean = solution.load / (body.faces[1] - body.faces[0])
            afar = body.faces[0] - apart, body.faces[1] + apart, mean
        pressed = solution.contact.compliance * solution.line_load
        faces = _faces(solution, body, load, freed, Between(terms, afar) if all(freed) else None)
        influence = influence_within(solution.contact, solution.shape, which)
        widened = np.zeros(pressed.size)
        if isinstance(solution, Solution):  # a plane grid treats every contact as one of usual width
            by_width = influence.by_width(solution.y, 1.0)
            for strip in np.flatnonzero(pressed).tolist():
                own, _ = core.by_own_width(by_width, strip, float(solution.half_width[strip]))
                widened[strip] = pressed[strip] * own
        wall = Wall.of(solution, body, Extent(name, body), terms, faces)
        by_body[name] = cls(name, body, load, terms, faces, wall, influence, solution.edges, pressed, widened, afar)
        return by_body[name]

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Effects that its stress leaves out."""
        if self.body.bore is None or self.wall is not None:
            return ()
        solid = "stress below its surface is that of a solid body, without the bending of its wall"
        return (finding("stepped-bore", f"The bore of body {{body}} has steps: {solid}.", body=self.name),)

    @property
    def extent(self) -> Extent:
        """The material of the body."""
        return Extent(self.name, self.body)

    def refuse_outside(self, x: Array, y: Array, z: Array) -> None:
        """Reject points above the surface or beyond the side faces, and all points if none lies in the material.

        Raises
        ------
        InputError
        """
        if z.size and float(z.min()) < 0.0:
            remedy = "z points into the body, from 0 on its surface"
            raise InputError("z", float(z.min()), "not be negative", remedy)
        low, high = self.body.faces
        inwards = at_ends(y, (low, high))
        outside = (inwards < low) | (inwards > high)
        if outside.any():
            condition = f"lie between the side faces of body {self.name}, {mm(low, high, between=' and '):g}"
            raise InputError("y", float(y[outside][0]), condition, "choose points within the body, or the other body")
        if y.size and not self.extent.holds(x, y, z).any():
            self.extent.refuse(float(y.flat[0]), float(z.flat[0]))

    def stress(self, points: Array) -> Array:
        """Return the stress [MPa] at ``points`` (n, 3), shape (n, 6)."""
        return self._near(points) if self.wall is None else self.wall.stress(points, self._near)

    def _near(self, points: Array) -> Array:
        """Return the stress of pressure and images in a half-space, with the corrections for free side faces."""
        total = self.load.six(points, self.body.material.poisson, False, self.terms)
        for face in self.faces:
            total += face.stress(points)
        if self.afar is not None:
            core.add_from_afar(points, *self.afar, self.body.material.poisson, total)
        return total

    def displacement(self, points: Array) -> Array:
        """Return the displacement [mm] at ``points`` (n, 3), shape (n, 3)."""
        share = self.influence.terms[0, 2]
        weights = self.influence.terms / [1.0, 1.0, share]
        total = self.load.six(points, self.body.material.poisson, True, weights)[:, DISPLACEMENT]
        for side in self.influence.faces:
            face = next(candidate for candidate in self.faces if candidate.side == side.side)
            total += side.share / share * face.displacement(points)
        total /= self.body.material.shear_modulus
        y, back = np.unique(points[:, 1], return_inverse=True)
        strip = np.clip(np.searchsorted(self.edges, y, side="right") - 1, 0, self.widened.size - 1)
        sunk = self.influence.at_depth(y, self.edges) @ self.pressed - self.widened[strip]
        total[:, U_Z] -= sunk[back.ravel()]
        return total


def check_solution(solution: object) -> Solved:
    """Return a solution with something in contact, or reject anything else.

    Raises
    ------
    InputError
    """
    if not isinstance(solution, Solution | PatchSolution):
        raise InputError("solution", solution, "be a solved contact", "give what solve or patch.solve returns")
    if not np.any(solution.line_load > 0.0):
        raise InputError("solution", solution.status.label, "have a contact", "press the bodies together")
    return solution


def check_body(name: object) -> BodyName:
    """Return the name of a body, or reject anything but "a" and "b"."""
    if isinstance(name, str):
        if name == "a":
            return "a"
        if name == "b":
            return "b"
    raise InputError("body", name, "be one of the two bodies", _BODY_REMEDY)


# Solutions are immutable, and a search evaluates the field below one a hundred times.
_KEPT: WeakKeyDictionary[Solved, dict[BodyName, Inside]] = WeakKeyDictionary()


def _faces(
    solution: Solved, body: Body, load: Load, freed: list[bool], between: Between | None
) -> tuple[FreeFaceField, ...]:
    """Return the corrections for the free side faces of a body."""
    loaded = solution.line_load > 0.0
    y, half_width = solution.y[loaded], solution.extent_across[1][loaded]
    low, high = solution.edges[:-1][loaded][0], solution.edges[1:][loaded][-1]
    faces, sides = body.faces, (-1.0, 1.0)
    near = [
        float(np.max(half_width - NARROWING * np.abs(y - place), initial=LEAST * half_width.max())) for place in faces
    ]
    reach = [max(high - place, place - low) for place in faces]
    poisson = body.material.poisson
    if between is not None:
        return FreeFaceField.pair(load.spectrum, faces, (near[0], near[1]), (reach[0], reach[1]), poisson, between)
    return tuple(
        FreeFaceField.of(load.spectrum, faces[k], sides[k], near[k], reach[k], poisson) for k in (0, 1) if freed[k]
    )
