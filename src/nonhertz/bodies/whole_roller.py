"""What makes a flat body with free ends a whole roller: the difference, in two parts.

A roller, solid or bored, is pressed on two opposite sides by the same load along its length. The pressure around it is
a sum of cos(n theta), n even, and each of these modes moves the surface in its own way. Near the contact, modes of high
n move it as waves of the wave number n / R do on a flat body with the same free ends, which is what strips and their
images are made of. So a whole roller is the flat body, plus the sum over n of that difference, plus what a sum over n
differs from the integral over all wave numbers. How wide the contact is matters on the strip itself alone.

Around an axis, a wave of the numbers n around and k along (radius 1, kappa^2 = n^2 + k^2) moves the surface by

    1 / kappa + [(1 - 2 nu) k^2 - beta n^2] / kappa^4 + O(kappa^-3),     beta = (1 - 2 nu) / (2 (1 - nu)),

where a flat body has the first term alone. The second is the *curved part*. Of a line of load at a distance s, all
modes together make of it a function with a logarithm at s = 0, about the load and both its images, so it is integrated
over strips in closed form. In plane strain, mode n moves the surface by (n - beta) / (n^2 - 1): what that differs from
both terms is added on the strip itself, and what a half-width b changes there: 4 [2 J1(n b) / (n b) - 1] times
(n - beta) / (n^2 - 1) in the sum over n, less that of 1 / n in the integral. Of both there are closed forms, by |sin|
and the logarithm of sin, of which two powers of b are kept.

What is left is smooth, and a matrix between Legendre polynomials along the axis (Galerkin's method): for low n the
finite elements' energy, less the flat and the curved part of the same modes; then the sum over all n of the flat
body's functions, in closed form (Gradshteyn & Ryzhik 8.526), less their integral. Modes and polynomials fade with
weights that are smooth functions of the shape, so that no count of them makes a step.

A bore is felt by waves that reach through the wall, which are among the low n. Where the diameter varies, n / R is
taken with the geometric mean of R at both ends of a distance.

Displacement is measured against the roller's axis, and the load on the opposite side is in. The roller is free to grow
longer.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies import solid_rollers
from nonhertz.bodies.smooth_part import PER_TERM, curved_factors, fading, response_matrix, terms_along
from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.model.outline import Outline
from nonhertz.native import core

Array = NDArray[np.float64]

_FARTHEST, _PLACES = 25.0, 5001  # of the table of the curved part [radii], evenly spaced, which leaves 1e-12


@dataclass(frozen=True)
class WholeRoller:
    """What the displacement of a whole roller is more than that of a flat body with free ends.

    Attributes
    ----------
    outline : Outline
        A section through its axis.
    matrix : ndarray, shape (m, m)
        The smooth part, between normalised Legendre polynomials: displacement over K times the load per length, of a
        radius of 1.
    curved : ndarray, shape (places, 4)
        Table of the curved part: values and slopes without its logarithm, and with it.
    logarithm : float
        The factor of s ln s in the curved part of a load from 0 to s.
    beta : float
        (1 - 2 nu) / (2 (1 - nu)), the factor of the curved part in plane strain.
    """

    outline: Outline
    matrix: Array
    curved: Array
    logarithm: float
    beta: float

    @classmethod
    def of(cls, outline: Outline, poisson: float, matrix: Array) -> WholeRoller:
        """Return that of an outline, in a radius of the surface, and a material."""
        _, decay, slope = curved_factors(poisson)
        return cls(outline, matrix, _curved_table(poisson), -0.5 * decay, 0.5 * (slope - decay))

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return it at ``y`` under a unit load of usual width between neighbouring edges.

        Parameters
        ----------
        y : ndarray, shape (places,)
            Distances from the middle [radii].
        edges : ndarray, shape (strips + 1,)
            The same of edges.

        Returns
        -------
        ndarray, shape (places, strips)
        """
        return np.asarray(self.core.displacement(y, edges))

    @cached_property
    def core(self) -> core.WholeRoller:
        """The same in C++."""
        z, outer = np.array(self.outline.z), np.array(self.outline.outer)
        return core.WholeRoller(z, outer, np.ascontiguousarray(self.matrix), self.curved, self.logarithm, self.beta)

    def __getstate__(self) -> dict[str, Any]:
        # What is in C++ is made again from the rest.
        return {field.name: getattr(self, field.name) for field in fields(self)}


@lru_cache(MOST)
def whole_roller(outline: Outline, poisson: float) -> WholeRoller:
    """Return what makes a whole roller of an outline, in a radius of the surface, and a material.

    That of a solid cylinder comes from a table, within 1e-6 of the displacement; any other is worked out, in a tenth of
    a second.
    """
    shares = fading(outline)
    solid = outline == Outline.cylinder(outline.half_length)
    matrix = solid_rollers.response_matrix(outline.half_length, poisson, shares.size) if solid else None
    if matrix is None:
        terms = terms_along(outline)
        matrix = response_matrix(outline, poisson, shares.size, PER_TERM * outline.half_length / terms)
    return WholeRoller.of(outline, poisson, shares[:, None] * matrix * shares)


@cache_on_disk("nonhertz.bodies.smooth_part", __name__)
def _curved_table(poisson: float) -> Array:
    """Return the integral from 0 to s of the curved part and its slope, both but for its s ln s, and both as they are.

    The curved part is the sum over n = 2, 4 ... of exp(-n s) (A / n - B s), times 2 / pi times pi / 2, and of
    (1 - 2 nu) exp(-s) for n = 0.
    """
    from scipy import special

    along, decay, slope = curved_factors(poisson)
    s = np.linspace(0.0, _FARTHEST, _PLACES)
    at = np.maximum(s, np.finfo(float).tiny)
    less = -np.expm1(-2.0 * s)
    logarithm = np.log(np.maximum(less, np.finfo(float).tiny))
    dilogarithm = special.spence(less)
    whole = -along * np.exp(-s) - 0.25 * decay * dilogarithm - 0.5 * slope * (s * logarithm - 0.5 * dilogarithm)
    over = np.divide(s * np.exp(-2.0 * s), less, out=np.full_like(s, 0.5), where=s > 0.0)
    ratio = np.divide(less, s, out=np.full_like(s, 2.0), where=s > 0.0)
    smooth = along * np.exp(-s) - 0.5 * decay * np.log(ratio) - slope * over + 0.5 * decay
    rising = 0.5 * decay * s * np.log(at), 0.5 * decay * (np.log(at) + 1.0)
    whole -= whole[0]
    return np.stack([whole + rising[0], smooth, whole, smooth - rising[1]], axis=-1)
