"""Difference between a whole roller and a flat body with free ends, in two parts.

A roller, solid or bored, is pressed on two opposite sides by the same load along its length. The pressure around it is
a sum of cos(n theta), n even, and each of these modes moves the surface in its own way. Near the contact, modes of high
n move it like waves of the wave number n / R on a flat body with the same free ends, which strips and their images
represent. A whole roller is thus the flat body, plus the sum of these differences over n, plus the difference between
the sum over n and the integral over all wave numbers. The width of the contact matters only on the strip itself.

Around an axis, a wave of the numbers n around and k along (radius 1, kappa^2 = n^2 + k^2) moves the surface by

    1 / kappa + [(1 - 2 nu) k^2 - beta n^2] / kappa^4 + O(kappa^-3),     beta = (1 - 2 nu) / (2 (1 - nu)),

of which a flat body has only the first term. The second is the *curved part*. Summed over all modes, it is a function
of the distance s from a line of load with a logarithm at s = 0, about the load and both its images, and is integrated
over strips in closed form. In plane strain, mode n moves the surface by (n - beta) / (n^2 - 1). The difference from
both terms is added on the strip itself, as is the effect of a half-width b there: 4 [2 J1(n b) / (n b) - 1] times
(n - beta) / (n^2 - 1) in the sum over n, minus the same with 1 / n in the integral. Both have closed forms, in |sin|
and the logarithm of sin, of which two powers of b are retained.

The remainder is smooth. It is a matrix between Legendre polynomials along the axis (Galerkin's method): for low n the
energy from finite elements, minus the flat and the curved part of the same modes; plus the sum over all n of the flat
body's functions, in closed form (Gradshteyn & Ryzhik 8.526), minus their integral. Modes and polynomials are faded out
by weights that are smooth functions of the shape, so that their number causes no jumps.

A bore affects waves that reach through the wall, which are among the low n. Where the diameter varies, n / R is
taken with the geometric mean of R at both ends of a distance.

Displacement is measured against the roller's axis and includes the load on the opposite side. The roller is free to
extend.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies import solid_rollers
from nonhertz.bodies.smooth_part import PER_TERM, curved_factors, fade_weights, response_matrix, terms_along
from nonhertz.bodies.stored import MOST, cache_on_disk
from nonhertz.model.outline import Outline
from nonhertz.native import core

Array = NDArray[np.float64]

_FARTHEST, _PLACES = 25.0, 5001  # of the table of the curved part [radii], evenly spaced; its error is 1e-12


@dataclass(frozen=True)
class WholeRoller:
    """Displacement of a whole roller minus that of a flat body with free ends.

    Attributes
    ----------
    outline : Outline
        A section through its axis.
    matrix : ndarray, shape (m, m)
        The smooth part between normalised Legendre polynomials: displacement over K times the load per length, for a
        radius of 1.
    curved : ndarray, shape (places, 4)
        Table of the curved part: values and slopes, without its logarithm and with it.
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
        """Return the difference for an outline, in radii of its surface, and a material."""
        _, decay, slope = curved_factors(poisson)
        return cls(outline, matrix, _curved_table(poisson), -0.5 * decay, 0.5 * (slope - decay))

    def displacement(self, y: Array, edges: Array) -> Array:
        """Return the difference at ``y`` under a unit load of usual width between neighbouring edges.

        Parameters
        ----------
        y : ndarray, shape (places,)
            Distances from the middle [radii].
        edges : ndarray, shape (strips + 1,)
            Edges of the strips, likewise.

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
        # The C++ part is made again from the rest.
        return {field.name: getattr(self, field.name) for field in fields(self)}


@lru_cache(MOST)
def whole_roller(outline: Outline, poisson: float) -> WholeRoller:
    """Return the difference for an outline, in radii of its surface, and a material.

    A solid cylinder is read from a table, within 1e-6 of the displacement; any other is computed in a tenth of a
    second.
    """
    shares = fade_weights(outline)
    solid = outline == Outline.cylinder(outline.half_length)
    matrix = solid_rollers.response_matrix(outline.half_length, poisson, shares.size) if solid else None
    if matrix is None:
        terms = terms_along(outline)
        matrix = response_matrix(outline, poisson, shares.size, PER_TERM * outline.half_length / terms)
    return WholeRoller.of(outline, poisson, shares[:, None] * matrix * shares)


@cache_on_disk("nonhertz.bodies.smooth_part", __name__)
def _curved_table(poisson: float) -> Array:
    """Return the integral of the curved part from 0 to s and its slope, both without its s ln s, then both with it.

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
