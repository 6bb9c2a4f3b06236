"""The field below strips: uniform along y, semi-elliptic across.

For parabolic strips it is the field of the semi-ellipse of equal load, whose half-width and pressure a solution
reports: a parabola itself has a tenth less orthogonal shear stress than the contact it represents.

Across, the pressure of a strip is a Gaussian sum of line loads: n nodes integrate the field of a load at xi, a function
that is analytic up to the ellipse through the point with its foci at the strip's edges, with an error like
exp(-2 n eta), 2 cosh(eta) the sum of the distances from both edges over the half-width. Each strip uses as many nodes
as its distance requires, mostly two. Under the strip itself the distance would be the depth, and near the surface no
number of nodes would suffice: there the infinite strip has a closed form in plane strain, and quadrature is needed only
for the tails that begin at the strip's ends (see `nonhertz.subsurface.tails`). Nearby strips are divided into pieces
that follow the pressure between their centres (see `nonhertz.subsurface.lamination`). With zeta = x + i z and the
Cauchy integral H = int p(xi) / (zeta - xi), plane strain is

    sigma_x = (Im H + z Re H') / pi     tau_xz = -z Im H' / pi
    sigma_z = (Im H - z Re H') / pi     sigma_y = nu (sigma_x + sigma_z)
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.native import core
from nonhertz.result.solution import Solution
from nonhertz.subsurface.free_faces import Spectrum
from nonhertz.subsurface.lamination import Lamination, laminate
from nonhertz.subsurface.tails import Load

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

# Beyond these distances, in half-widths and in its own length, a strip is not divided into pieces; as in the core.
FAR, FAR_IN_LENGTHS = 16.0, 6.0


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
        return cls(laminate(solution))

    @cached_property
    def in_core(self) -> core.SurfaceLoad:
        """The same pressure in the core."""
        return core.strip_load(*self.strips)

    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of the strips at wave numbers ``k`` [1/mm], and of their pieces near ``y``."""
        from scipy.special import j1

        of = self.strips
        counted = _pieces_of(y, of)
        low, high, load, half_width = (values[counted] for values in (of.low, of.high, of.line_load, of.half_width))
        s = k[:, None] * half_width
        transform = load * 2.0 * j1(s) / s
        edges, order = np.concatenate([low, high]), np.argsort(np.concatenate([low, high]), kind="stable")
        steps = np.concatenate([-transform, transform], axis=1)[:, order]
        # Neighbours share an edge.
        edges, first = np.unique(edges[order], return_index=True)
        return Spectrum(edges, np.add.reduceat(steps, first, axis=1), None)


def _pieces_of(y: float, of: Lamination) -> Integers:
    """Return the indices that represent the strips: a distant strip itself, pieces of a near one."""
    strips = np.arange(of.first.size - 1)
    low, high = of.low[strips], of.high[strips]
    apart = np.maximum(low - y, y - high)
    whole = (apart > FAR * of.half_width[strips]) & (apart > FAR_IN_LENGTHS * (high - low))
    count = np.where(whole, 1, np.diff(of.first))
    begin = np.where(whole, strips, of.first[:-1])
    return np.repeat(begin - np.cumsum(count) + count, count) + np.arange(count.sum())
