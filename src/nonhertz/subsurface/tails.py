"""Closed forms of a semi-infinite line load on a half-space.

A load of 1 per unit length acts on the surface of a half-space along y, from the distance Y ahead of a point to
infinity. With X across from the load to the point, z the depth and R^2 = X^2 + Y^2 + z^2, Boussinesq's point load
integrates to

    2 pi sigma_z = -z^3 T                                     T = (2 R + Y) / (R^3 (R + Y)^2)
    2 pi sigma_x = -z X^2 T - (1 - 2 nu) Y / (R (R + z))      c = 1 / (R (R + Y))
    2 pi sigma_y = -2 nu z c - z Y / R^3 + (1 - 2 nu) Y / (R (R + z))
    2 pi tau_xz  = -z^2 X T        2 pi tau_yz = z^2 / R^3    2 pi tau_xy = z X / R^3 - (1 - 2 nu) X / (R (R + z))

and there is no cancellation for Y >= 0, however near the line the point is, unlike in the textbook form, a segment's
two ends in powers of X^2 + z^2. A strip beside the point is the difference between two tails. A strip over the point is
the infinite line less a tail on either side; and the infinite line has a closed form in plane strain for the whole
width of the strip, so that what is left to quadrature is no nearer to the point than the strip's ends. Tails behind the
point are mirrored: tau_yz, tau_xy and u_y change sign. Displacement is kept in the places of the stresses that have its
symmetry, u_x, 0, u_z, u_y, 0, 0, so that one loop adds up either.

References
----------
J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885. K. L. Johnson, Contact Mechanics, Cambridge
University Press, 1985, Eqs. (3.18), (3.19), doi:10.1017/CBO9781139171731. The integrals are derived here and tested
against quadrature.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.subsurface.free_faces import Spectrum

Array = NDArray[np.float64]

TWO_PI = 2.0 * math.pi

Six = tuple[float, float, float, float, float, float]
#: Which of six components change their sign with y, and which are a displacement's.
ODD, DISPLACEMENT = [3, 5], [0, 3, 2]


class Load(ABC):
    """A pressure on the surface of a half-space."""

    @abstractmethod
    def six(self, points: Array, poisson: float, displaced: bool) -> Array:
        """Return six components of its stress [MPa], or of the displacement, at ``points`` (n, 3), shape (n, 6)."""

    @abstractmethod
    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of the pressure across at wave numbers ``k`` [1/mm], for the field near ``y`` [mm]."""

    def stress(self, points: Array, poisson: float) -> Array:
        """Return sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy [MPa] at ``points`` (n, 3), shape (n, 6)."""
        return self.six(points, poisson, displaced=False)

    def displacement(self, points: Array, poisson: float) -> Array:
        """Return the shear modulus times u_x, u_y, u_z [N/mm] at ``points`` (n, 3), shape (n, 3)."""
        return self.six(points, poisson, displaced=True)[:, DISPLACEMENT]


@compiled
def stress_tail(X: float, Y: float, z: float, poisson: float) -> Six:
    """Return 2 pi times sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy of the tail, Y > 0."""
    R = math.sqrt(X * X + Y * Y + z * z)
    inverse, sum_inverse = 1.0 / R, 1.0 / (R + Y)
    c = inverse * sum_inverse
    cube = inverse * inverse * inverse
    T = (2.0 * R + Y) * cube * sum_inverse * sum_inverse
    lateral = (1.0 - 2.0 * poisson) * inverse / (R + z)
    zT = z * T
    return (
        -zT * X * X - lateral * Y,
        -z * (2.0 * poisson * c + Y * cube) + lateral * Y,
        -zT * z * z,
        z * z * cube,
        -zT * z * X,
        X * (z * cube - lateral),
    )


@compiled
def displacement_tail(X: float, Y: float, z: float, poisson: float) -> Six:
    """Return 4 pi G times u_x, 0, u_z, u_y, 0, 0 of the tail, Y > 0, u_y and u_z up to constants two tails share."""
    R = math.sqrt(X * X + Y * Y + z * z)
    lateral = 1.0 - 2.0 * poisson
    c = 1.0 / (R * (R + Y))
    return (
        z * X * c - 2.0 * lateral * math.atan2(X, Y + R + z),
        0.0,
        -2.0 * (1.0 - poisson) * math.log(R + Y) + z * z * c,
        -z / R - lateral * math.log(R + z),
        0.0,
        0.0,
    )
