"""A plain ring under pressure on its faces and rotation: Lamé's solution and that of a rotating disc.

The ring between the radii a and b is in plane stress, without axial stress. Pressures p inside and q outside, and a
speed omega, give

    sigma_r = A - B / r^2 - (3 + nu) / 8 rho omega^2 r^2
    sigma_t = A + B / r^2 - (1 + 3 nu) / 8 rho omega^2 r^2        E u = r (sigma_t - nu sigma_r)

with A and B from sigma_r(a) = -p and sigma_r(b) = -q. In a disc without a hole B = 0; around a hole in an infinite
plate at rest A = -q. All results are linear in p, q and omega^2, so that one routine serves all cases.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from nonhertz.model.material import Material


@dataclass(frozen=True)
class ThickRing:
    """A ring of rectangular section: a disc without an inner radius, a plate with a hole if the outer is infinite."""

    inner: float  # a [mm]
    outer: float  # b [mm]
    material: Material
    density: float  # [t/mm^3]

    def hoop_stress(self, radius: float, *, inside: float = 0.0, outside: float = 0.0, speed: float = 0.0) -> float:
        """Return the tangential stress at a radius [MPa], under pressures [MPa] and a speed [rad/s]."""
        mean, share, body = self._constants(inside, outside, speed)
        nu = self.material.poisson
        return mean + share / radius**2 - (1.0 + 3.0 * nu) / 8.0 * body * radius**2

    def radial_stress(self, radius: float, *, inside: float = 0.0, outside: float = 0.0, speed: float = 0.0) -> float:
        """Return the radial stress at a radius [MPa], negative in compression."""
        mean, share, body = self._constants(inside, outside, speed)
        return mean - share / radius**2 - (3.0 + self.material.poisson) / 8.0 * body * radius**2

    def growth(self, radius: float, *, inside: float = 0.0, outside: float = 0.0, speed: float = 0.0) -> float:
        """Return the growth of a radius [mm]."""
        loads = {"inside": inside, "outside": outside, "speed": speed}
        strained = self.hoop_stress(radius, **loads) - self.material.poisson * self.radial_stress(radius, **loads)
        return radius * strained / self.material.modulus

    def _constants(self, inside: float, outside: float, speed: float) -> tuple[float, float, float]:
        """Return A, B and rho omega^2."""
        a, b, body = self.inner, self.outer, self.density * speed**2
        third = (3.0 + self.material.poisson) / 8.0 * body
        if math.isinf(b):
            return -outside, (inside - outside) * a**2, body
        if a == 0.0:
            return third * b**2 - outside, 0.0, body
        difference = b**2 - a**2
        mean = (inside * a**2 - outside * b**2) / difference + third * (a**2 + b**2)
        return mean, a**2 * b**2 * ((inside - outside) / difference + third), body
