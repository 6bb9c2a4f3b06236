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
the infinite line minus a tail on either side; the infinite line has a closed form in plane strain for the whole width
of the strip, so that quadrature is needed only for loads no nearer to the point than the strip's ends. Tails behind the
point are mirrored: tau_yz, tau_xy and u_y change sign. Displacement is stored in the places of stresses of the same
symmetry, u_x, 0, u_z, u_y, 0, 0, so that one loop adds up either. The loops are in ``src/core/subsurface``.

References
----------
J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885. K. L. Johnson, Contact Mechanics, Cambridge
University Press, 1985, Eqs. (3.18), (3.19), doi:10.1017/CBO9781139171731. The integrals are derived here and tested
against quadrature.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.subsurface.free_faces import Spectrum

if TYPE_CHECKING:
    from nonhertz.native import core

Array = NDArray[np.float64]

#: Indices among the six components that hold a displacement.
DISPLACEMENT = [0, 3, 2]


#: Rows (sign, offset, weight) of a pressure without mirror images.
ALONE: Array = np.array([[1.0, 0.0, 1.0]])


class Load(ABC):
    """A pressure on the surface of a half-space."""

    @cached_property
    @abstractmethod
    def in_core(self) -> core.SurfaceLoad:
        """The same pressure in the core."""

    @abstractmethod
    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of the pressure across at wave numbers ``k`` [1/mm], for the field near ``y`` [mm]."""

    def six(self, points: Array, poisson: float, displaced: bool, terms: Array = ALONE) -> Array:
        """Return six components of the stress [MPa], or of the displacement, at ``points`` (n, 3), shape (n, 6).

        ``terms`` are rows (sign, offset, weight) of the pressure and its images, which lie at ``sign * y + offset``.
        """
        return self.in_core.six(points, terms, poisson, displaced)

    def stress(self, points: Array, poisson: float) -> Array:
        """Return sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy [MPa] at ``points`` (n, 3), shape (n, 6)."""
        return self.six(points, poisson, displaced=False)

    def displacement(self, points: Array, poisson: float) -> Array:
        """Return the shear modulus times u_x, u_y, u_z [N/mm] at ``points`` (n, 3), shape (n, 3)."""
        return self.six(points, poisson, displaced=True)[:, DISPLACEMENT]
