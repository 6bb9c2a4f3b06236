"""The stress in a hollow roller of a solution: that of both contacts, and the bending of the wall between them.

A roller is pressed alike on the opposite side, so a point in the lower half is seen from there, and the opposite
contact is so far away that point loads stand for its strips. See `nonhertz.bodies.wall_stress` for the bending.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from nonhertz.bodies.wall_stress import OPPOSITE, TOP, bending_of
from nonhertz.compiled import compiled, plain_array
from nonhertz.model.body import Body
from nonhertz.result.solution import Solved
from nonhertz.subsurface.extent import Extent
from nonhertz.subsurface.free_faces import FreeFaceField
from nonhertz.subsurface.tails import TWO_PI

Array = NDArray[np.float64]

_NODES = 2  # of Gauss's rule on a strip, for the far contact
_NODES_OF_MODES = 8  # and for its share in polynomials


@dataclass(frozen=True, eq=False)
class Wall:
    """A hollow roller under the pressure of a solution.

    Attributes
    ----------
    extent : Extent
        Where its material is.
    modes : ndarray, shape (waves, 6, through, along)
        Chebyshev coefficients of the polar stress of each mode [MPa].
    loads : ndarray, shape (loads, 2)
        Places [mm] and forces [N] of the point loads that stand for a contact seen from the opposite side.
    faces : tuple of FreeFaceField
        What free side faces add to the field of one contact.
    """

    extent: Extent
    modes: Array
    loads: Array
    faces: tuple[FreeFaceField, ...]

    @classmethod
    def of(
        cls, solution: Solved, body: Body, extent: Extent, images: Array, faces: tuple[FreeFaceField, ...]
    ) -> Wall | None:
        """Return that of a body; None if it has no bore, or one with steps.

        ``images`` are rows (sign, offset, weight) of the pressure and its images.
        """
        found = bending_of(body)
        if found is None:
            return None
        (bending, radius), middle = found, body.position
        pressed = solution.line_load > 0.0
        low, high, line_load = solution.edges[:-1][pressed], solution.edges[1:][pressed], solution.line_load[pressed]
        y, width = _on_strips(low, high, _NODES_OF_MODES)
        shares = _spread(bending.waves, solution.extent_across[1][pressed] / extent.radii(0.5 * (low + high))[0])
        on_strips = np.sum(width[..., None] * bending.polynomials((y - middle) / radius), axis=1) / radius
        modes = bending.stress((shares * line_load / radius) @ on_strips)
        y, width = _on_strips(low, high, _NODES)
        places, forces = y.ravel(), (line_load[:, None] * width).ravel()
        rows = [np.column_stack([sign * places + offset, weight * forces]) for sign, offset, weight in images]

        def of_faces(points: Array) -> Array:
            return sum((each.stress(radius * points + [0.0, middle, 0.0]) for each in faces), np.zeros(6))

        return cls(extent, plain_array(modes - bending.of_field(of_faces)), np.concatenate(rows), faces)

    def stress(self, points: Array, near: Callable[[Array], Array]) -> Array:
        """Return the stress [MPa] at ``points`` (n, 3), shape (n, 6), given that of the contact itself."""
        outer, inner = map(plain_array, self.extent.radii(points[:, 1]))
        lower = points[:, 2] > outer
        opposite = np.column_stack([-points[:, 0], points[:, 1], 2.0 * outer - points[:, 2]])
        seen, opposite = np.where(lower[:, None], opposite, points), np.where(lower[:, None], points, opposite)
        total = near(seen)
        for face in self.faces:
            total += OPPOSITE * face.stress(opposite)
        low, high = self.extent.body.faces
        along = (2.0 * seen[:, 1] - low - high) / (high - low)
        _add(seen, along, outer, inner, self.modes, self.loads, self.extent.body.material.poisson, total)
        total[lower] *= OPPOSITE
        return total


def _on_strips(low: Array, high: Array, count: int) -> tuple[Array, Array]:
    """Return Gauss's points on strips, and their weights, shape (strips, count)."""
    node, weight = legendre.leggauss(count)
    half = 0.5 * (high - low)[:, None]
    return low[:, None] + half * (1.0 + node), half * weight


def _spread(waves: Array, half_width: Array) -> Array:
    """Return how much of each mode a semi-ellipse of a half-width [radii] has of a line load's, (waves, strips)."""
    from scipy import special

    turns = np.maximum(waves[:, None] * half_width, 1e-9)
    found: Array = 2.0 * special.j1(turns) / turns
    return found


@compiled
def _add(
    points: Array, along: Array, outer: Array, inner: Array, modes: Array, loads: Array, poisson: float, total: Array
) -> None:
    """Add the stress of the opposite contact, and of all modes."""
    waves, through, axial = modes.shape[0], modes.shape[2], modes.shape[3]
    lateral = 1.0 - 2.0 * poisson
    by_radius, by_place, found = np.empty(through), np.empty(axial), np.empty(6)
    for i in range(points.shape[0]):
        x, y, z = -points[i, 0], points[i, 1], 2.0 * outer[i] - points[i, 2]
        for c in range(6):
            found[c] = 0.0
        for k in range(loads.shape[0]):
            Y, force = y - loads[k, 0], loads[k, 1] / TWO_PI
            square = max(x * x + Y * Y, 1e-16)
            R = math.sqrt(square + z * z)
            side, g = lateral / square, (1.0 - z / R) / square
            cube, fifth = z / (R * R * R), 3.0 * z / (R * R * R * R * R)
            found[0] += force * (side * (g * (x * x - Y * Y) + cube * Y * Y) - fifth * x * x)
            found[1] += force * (side * (g * (Y * Y - x * x) + cube * x * x) - fifth * Y * Y)
            found[2] -= force * fifth * z * z
            found[3] += force * fifth * Y * z
            found[4] -= force * fifth * x * z
            found[5] -= force * (side * x * Y * (g - cube) - fifth * x * Y)
        for c in range(6):
            total[i, c] += found[c]
            found[c] = 0.0
        x, z = points[i, 0], outer[i] - points[i, 2]
        share = min((math.sqrt(x * x + z * z) - inner[i]) / (outer[i] - inner[i]), 1.0)
        _polynomials(2.0 * share / TOP - 1.0, by_radius)
        _polynomials(along[i], by_place)
        theta = math.atan2(x, z)
        for n in range(waves):
            cosine, sine = math.cos(2.0 * n * theta), math.sin(2.0 * n * theta)
            for c in range(6):
                amplitude = 0.0
                for p in range(through):
                    for q in range(axial):
                        amplitude += by_radius[p] * by_place[q] * modes[n, c, p, q]
                found[c] += amplitude * (sine if c in (3, 5) else cosine)
        rr, tt, yy, rt, ry, ty = found[0], found[1], found[2], found[3], found[4], found[5]
        sine, cosine = math.sin(theta), math.cos(theta)
        total[i, 0] += rr * sine * sine + tt * cosine * cosine + 2.0 * rt * sine * cosine
        total[i, 1] += yy
        total[i, 2] += rr * cosine * cosine + tt * sine * sine - 2.0 * rt * sine * cosine
        total[i, 3] += ty * sine - ry * cosine
        total[i, 4] += (tt - rr) * sine * cosine + rt * (sine * sine - cosine * cosine)
        total[i, 5] += ry * sine + ty * cosine


@compiled
def _polynomials(x: float, out: Array) -> None:
    """Fill in Chebyshev's polynomials at x."""
    out[0] = 1.0
    out[1] = x
    for k in range(2, out.size):
        out[k] = 2.0 * x * out[k - 1] - out[k - 2]
