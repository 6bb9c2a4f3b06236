"""``"plane-strain"``: the depth at which the compression of a long cylinder is that of plane strain."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from nonhertz.bodies.depths.diameter import Diameter

if TYPE_CHECKING:
    from nonhertz.bodies.solid import Shape, Solid


class PlaneStrain(Diameter):
    """Displacement against a point at the depth that makes the compression of a long cylinder that of plane strain.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985, Section 5.6, Eq. (5.57),
    doi:10.1017/CBO9781139171731.
    """

    word = "plane-strain"
    meaning = "where it makes the compression of a long cylinder that of plane strain"
    place = "the depth that makes the compression of a long cylinder that of plane strain"

    def diameters(self, body: Solid, shape: Shape) -> float:
        """Return depth / diameter."""
        return plane_strain_depth(shape, body.material.poisson)


def plane_strain_depth(shape: Shape, poisson: float) -> float:
    """Return depth / diameter at which a long cylinder's compression is that of plane strain.

    In plane strain the displacement of a strip of infinite length relative to depth d is 2 K q (ln(d / a) + C - 1 /
    (2 (1 - nu))), C being the element's constant; a long cylinder is compressed by K q (2 ln(2 D / b) - 1). The two
    agree at d = 2 D (a / b) exp(1 / (2 (1 - nu)) - C - 1/2), in which the load cancels.

    Examples
    --------
    >>> from nonhertz.strip.element import SEMI_ELLIPTIC
    >>> round(plane_strain_depth(SEMI_ELLIPTIC, 0.3), 4)
    0.7515
    """
    exponent = 1.0 / (2.0 * (1.0 - poisson)) - shape.far_constant - 0.5
    return 2.0 / shape.hertz_ratio * math.exp(exponent)
