"""Sensitivity of a solved contact to small changes of all its inputs, by one solve of the transposed equations.

On fixed strips, with the same strips in contact, relative changes rho of r and mu of m and the changes of approach and
tilt follow from

    [B] r rho - [t B'] r mu / 2                     =  d(curvature)  - d[B] r
    [A] r m rho + ([A] - [t A'] / 2) r m mu - d(approach) - y d(tilt)  =  -d(separation) - d[A] r m
    sum w r m (rho + mu)                            =  d(K Q),   or the approach is given
    sum w r m y (rho + mu)                          =  d(K T),   or the tilt is given

with w the widths of strips: M x = c. A quantity with derivatives g by x then changes by g x = (M^-T g) c.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.native import core

Array = NDArray[np.float64]
Indices = NDArray[np.intp]


class Linearisation(NamedTuple):
    """A solved contact, linearised; arrays of strips have one entry per strip in contact.

    Attributes
    ----------
    active : ndarray of int, shape (k,)
        Indices of the strips in contact.
    blocks : ndarray, shape (4, k, k)
        [A], [t A'], [B] and [t B'] of each at the centre of each.
    r, m : ndarray, shape (k,)
        K q / a^2 and a^2.
    y, width : ndarray, shape (k,)
        Centres and widths [mm].
    """

    active: Indices
    blocks: Array
    r: Array
    m: Array
    y: Array
    width: Array

    @property
    def loads(self) -> Array:
        """K q times the width of each strip [mm^2]."""
        loads: Array = self.r * self.m * self.width
        return loads

    def matrix(self, by_force: tuple[bool, bool]) -> Array:
        """Return M, shape (2 k + 2, 2 k + 2)."""
        k = self.r.size
        (a, ta, b, tb), whole = self.blocks, np.zeros((2 * k + 2, 2 * k + 2))
        whole[:k, :k], whole[:k, k:-2] = b * self.r, -0.5 * tb * self.r
        whole[k:-2, :k], whole[k:-2, k:-2] = a * (self.r * self.m), (a - 0.5 * ta) * (self.r * self.m)
        whole[k:-2, -2], whole[k:-2, -1] = -1.0, -self.y
        for row, (force, weights) in enumerate(zip(by_force, (self.loads, self.loads * self.y), strict=True)):
            if force:
                whole[2 * k + row, :k] = whole[2 * k + row, k:-2] = weights
            else:
                whole[2 * k + row, 2 * k + row] = 1.0
        return whole

    def sensitivities(self, by_force: tuple[bool, bool], derivatives: Array) -> Array:
        """Return M^-T g.

        Parameters
        ----------
        by_force : tuple of bool
            Whether the load is given rather than the approach, and the moment rather than the tilt.
        derivatives : ndarray, shape (2 k + 2,) or (2 k + 2, numbers)
            g: derivatives by relative changes of r and of m, by approach and by tilt.

        Raises
        ------
        numpy.linalg.LinAlgError
            If the contact has no stiffness against a prescribed load or moment.
        """
        return np.asarray(np.linalg.solve(self.matrix(by_force).T, derivatives))


def linearise(grid: core.Grid, r: Array, m: Array, kernel: core.Kernel) -> Linearisation:
    """Return a solved contact, linearised.

    Parameters
    ----------
    grid : core.Grid
        The strips.
    r, m : ndarray, shape (strips,)
        K q / a^2 and a^2, zero out of contact.
    kernel : Kernel
        Influence of the strips.
    """
    active = np.flatnonzero(m > 0.0)
    blocks = core.coefficients(grid, m, active, kernel)[:, active]
    y, width = grid.y[active], np.diff(grid.edges)[active]
    return Linearisation(active, blocks, r[active], m[active], y, width)
