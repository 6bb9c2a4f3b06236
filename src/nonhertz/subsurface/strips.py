"""The field below strips: uniform along y, semi-elliptic across.

For parabolic strips it is the field of the semi-ellipse of equal load, whose half-width and pressure a solution
reports: a parabola itself has a tenth less orthogonal shear stress than the contact it represents.

Across, the pressure of a strip is a Gaussian sum of line loads: n nodes integrate the field of a load at xi, a function
that is analytic up to the ellipse through the point with its foci at the strip's edges, with an error like
exp(-2 n eta), 2 cosh(eta) the sum of the distances from both edges over the half-width. Each strip uses as many nodes
as its distance requires, mostly two. Under the strip itself the distance would be the depth, and near the surface no
number of nodes would suffice: there the infinite strip has a closed form in plane strain, and quadrature is left only
with the tails that begin at the strip's ends (see `nonhertz.subsurface.tails`). Nearby strips are divided into pieces
that follow the pressure between their centres (see `nonhertz.subsurface.lamination`). With zeta = x + i z and the
Cauchy integral H = int p(xi) / (zeta - xi), plane strain is

    sigma_x = (Im H + z Re H') / pi     tau_xz = -z Im H' / pi
    sigma_z = (Im H - z Re H') / pi     sigma_y = nu (sigma_x + sigma_z)
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled
from nonhertz.result.solution import Solution
from nonhertz.subsurface.free_faces import Spectrum
from nonhertz.subsurface.lamination import Lamination, laminated
from nonhertz.subsurface.tails import TWO_PI, Load, Six, displacement_tail, stress_tail

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

LADDER = (2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 192, 256, 384, 512, 768, 1024)
ERROR = 1e-8  # of the contribution of a strip
# No tail begins nearer to a point than this, in half-widths: the smallest distance at which the rule of 256 nodes
# meets the error bound. A piece that ends nearer to a point on the surface is lengthened by the difference, and its
# neighbour shortened.
NEAREST = 0.04
# The same for displacement, whose singularity is only logarithmic: higher-order rules reach so much closer.
NEAREST_DISPLACED = 0.0025
# Beyond these distances, in half-widths and in its own lengths, a strip is not divided into pieces.
FAR, FAR_IN_LENGTHS = 16.0, 6.0
# Beyond these distances, in half-widths, nodes replace the closed form of the infinite strip, which begins to cancel.
CLOSED_FORM = 8.0


@dataclass(frozen=True, eq=False)
class StripLoad(Load):
    """The pressure of a strip solution, for the field below it.

    Attributes
    ----------
    strips : Lamination
        The strips and their pieces.
    """

    strips: Lamination

    @classmethod
    def of(cls, solution: Solution) -> StripLoad:
        """Return the load of a solution."""
        return cls(laminated(solution))

    def six(self, points: Array, poisson: float, displaced: bool) -> Array:
        """Return six components of its stress [MPa], or of the displacement, at ``points`` (n, 3), shape (n, 6)."""
        out = np.empty((points.shape[0], 6))
        (_displacement if displaced else _stress)(points, self.strips, rules(), poisson, out)
        return out

    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of the strips at wave numbers ``k`` [1/mm], and of their pieces near ``y``."""
        from scipy.special import j1

        of = self.strips
        counted = np.concatenate([np.arange(*_counted(j, y, of)) for j in range(of.first.size - 1)])
        low, high, load, half_width = (each[counted] for each in (of.low, of.high, of.line_load, of.half_width))
        s = k[:, None] * half_width
        transform = load * 2.0 * j1(s) / s
        edges, order = np.concatenate([low, high]), np.argsort(np.concatenate([low, high]), kind="stable")
        steps = np.concatenate([-transform, transform], axis=1)[:, order]
        # Neighbours share an edge.
        edges, first = np.unique(edges[order], return_index=True)
        return Spectrum(edges, np.add.reduceat(steps, first, axis=1), None)


class Rules(NamedTuple):
    """Gaussian rules for a semi-ellipse whose integral is 1 (Chebyshev, second kind).

    Attributes
    ----------
    nodes, weights : ndarray
        Of all rules, one after the other.
    starts : ndarray of int, shape (rules + 1,)
        Where each rule begins.
    enough : ndarray, shape (rules,)
        The smallest sum of distances from both edges over the half-width at which each suffices, descending.
    """

    nodes: Array
    weights: Array
    starts: Integers
    enough: Array


@cache
def rules() -> Rules:
    """Return the rules of `LADDER`."""
    angles = [np.pi * np.arange(1, count + 1) / (count + 1) for count in LADDER]
    nodes = np.concatenate([np.cos(angle) for angle in angles])
    weights = np.concatenate([2.0 / (angle.size + 1) * np.sin(angle) ** 2 for angle in angles])
    starts = np.concatenate([[0], np.cumsum(LADDER)])
    return Rules(nodes, weights, starts, 2.0 * np.cosh(-math.log(ERROR) / (2.0 * np.array(LADDER))))


@compiled
def _infinite(x: float, z: float, a: float) -> tuple[complex, complex, complex]:
    """Return H, H' and the integral of p ln(zeta - xi) of an infinite strip under unit line load."""
    zeta = complex(x / a, z / a)
    # Two separate roots, for the branch that behaves like zeta far away.
    root = cmath.sqrt(zeta - 1.0) * cmath.sqrt(zeta + 1.0)
    if root == 0.0:
        root = complex(1e-150, 0.0)
    outside = zeta + root
    potential = cmath.log(0.5 * outside) + 0.5 / (outside * outside)
    return 2.0 / (a * outside), -2.0 / (a * a * root * outside), potential + math.log(a)


@compiled
def _sufficient(x: float, distance: float, a: float, enough: Array) -> int:
    """Return the first rule that suffices at a distance, in y and z, from line loads within a of x = 0."""
    across, apart = x / a, distance / a
    total = math.sqrt((across - 1.0) ** 2 + apart * apart) + math.sqrt((across + 1.0) ** 2 + apart * apart)
    rule = 0
    while rule < enough.size - 1 and total < enough[rule]:
        rule += 1
    return rule


@compiled
def _tails(
    low: float, high: float, z: float, a: float, nearest: float
) -> tuple[float, float, float, float, float, float, float]:
    """Return both tails that make up a segment: for each its distance, sign, and sign of components odd in y.

    ``low`` and ``high`` are the segment's ends relative to the point, positive if ahead of it. The last value is the
    fraction of the infinite strip that counts: all of it under the segment, and half exactly at one of its ends, where
    the tail that begins at the point is half the infinite strip except for the odd components. No tail begins within
    ``nearest`` half-widths of the point.
    """
    least = math.sqrt(max((nearest * a) ** 2 - z * z, (1e-9 * a) ** 2))
    if low > 0.0:
        return max(low, least), 1.0, 1.0, max(high, least), -1.0, -1.0, 0.0
    if high < 0.0:
        return max(-high, least), 1.0, -1.0, max(-low, least), -1.0, 1.0, 0.0
    if low == 0.0:
        return least, 0.0, 1.0, max(high, least), -1.0, -1.0, 0.5
    if high == 0.0:
        return least, 0.0, -1.0, max(-low, least), -1.0, 1.0, 0.5
    return max(high, least), -1.0, -1.0, max(-low, least), -1.0, 1.0, 1.0


@compiled
def _counted(j: int, y: float, strips: Lamination) -> tuple[int, int]:
    """Return the index range that represents strip ``j``: the strip itself from afar, else its pieces."""
    low, high = strips.low[j], strips.high[j]
    apart = max(low - y, y - high)
    if apart > FAR * strips.half_width[j] and apart > FAR_IN_LENGTHS * (high - low):
        return j, j + 1
    return strips.first[j], strips.first[j + 1]


@compiled
def _stress_of_infinite(x: float, z: float, a: float, poisson: float, rules: Rules) -> Six:
    """Return 2 pi times the stress of an infinite strip under unit line load."""
    if abs(x) + z < CLOSED_FORM * a:
        H, slope, _ = _infinite(x, z, a)
        s_x, s_z = 2.0 * (H.imag + z * slope.real), 2.0 * (H.imag - z * slope.real)
        s_xz = -2.0 * z * slope.imag
    else:
        s_x, s_z, s_xz = 0.0, 0.0, 0.0
        rule = _sufficient(x, z, a, rules.enough)
        for k in range(rules.starts[rule], rules.starts[rule + 1]):
            X = x - a * rules.nodes[k]
            square = X * X + z * z
            common = -4.0 * rules.weights[k] * z / (square * square)
            s_x += common * X * X
            s_z += common * z * z
            s_xz += common * X * z
    return s_x, poisson * (s_x + s_z), s_z, 0.0, s_xz, 0.0


@compiled
def _displacement_of_infinite(x: float, z: float, a: float, poisson: float, rules: Rules) -> Six:
    """Return 4 pi G times its displacement, as `displacement_tail` does and up to the same constants."""
    H, _, potential = _infinite(x, z, a)
    turned = math.pi - 2.0 * potential.imag
    u_x = 2.0 * z * H.real - (1.0 - 2.0 * poisson) * turned
    return u_x, 0.0, -4.0 * (1.0 - poisson) * potential.real - 2.0 * z * H.imag, 0.0, 0.0, 0.0


Sum = Callable[[Array, Lamination, Rules, float, Array], None]


def _sum_of(name: str, scale: float, nearest: float, tail: Callable[..., Six], infinite: Callable[..., Six]) -> Sum:
    """Return a compiled loop, kept by its name, that adds up at points what all tails and infinite strips do there."""

    def add_up(points: Array, strips: Lamination, rules: Rules, poisson: float, out: Array) -> None:
        for i in range(points.shape[0]):
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            t_x, t_y, t_z, t_yz, t_xz, t_xy = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
            for j in range(strips.first.size - 1):
                begin, end = _counted(j, y, strips)
                for p in range(begin, end):
                    a, q = strips.half_width[p], scale * strips.line_load[p]
                    Y1, even1, odd1, Y2, even2, odd2, whole = _tails(
                        strips.low[p] - y, strips.high[p] - y, z, a, nearest
                    )
                    if whole > 0.0:
                        s_x, s_y, s_z, _, s_xz, _ = infinite(x, z, a, poisson, rules)
                        t_x += whole * q * s_x
                        t_y += whole * q * s_y
                        t_z += whole * q * s_z
                        t_xz += whole * q * s_xz
                    rule = _sufficient(x, math.sqrt(z * z + min(Y1, Y2) ** 2), a, rules.enough)
                    for k in range(rules.starts[rule], rules.starts[rule + 1]):
                        X, w = x - a * rules.nodes[k], q * rules.weights[k]
                        f_x, f_y, f_z, f_yz, f_xz, f_xy = tail(X, Y1, z, poisson)
                        g_x, g_y, g_z, g_yz, g_xz, g_xy = tail(X, Y2, z, poisson)
                        t_x += w * (even1 * f_x + even2 * g_x)
                        t_y += w * (even1 * f_y + even2 * g_y)
                        t_z += w * (even1 * f_z + even2 * g_z)
                        t_yz += w * (odd1 * f_yz + odd2 * g_yz)
                        t_xz += w * (even1 * f_xz + even2 * g_xz)
                        t_xy += w * (odd1 * f_xy + odd2 * g_xy)
            out[i, 0], out[i, 1], out[i, 2], out[i, 3], out[i, 4], out[i, 5] = t_x, t_y, t_z, t_yz, t_xz, t_xy

    add_up.__name__ = name
    return compiled(add_up)


_stress = _sum_of("_stress", 1.0 / TWO_PI, NEAREST, stress_tail, _stress_of_infinite)
_displacement = _sum_of("_displacement", 0.5 / TWO_PI, NEAREST_DISPLACED, displacement_tail, _displacement_of_infinite)
