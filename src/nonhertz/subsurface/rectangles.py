"""The field below a plane grid of cells, each under a uniform pressure.

Love's closed form for one cell takes a logarithm and two arctangents per corner, too much for all cells of a grid
at thousands of points; it is used for the few cells around the point. Further away only the moments of the load
across a row of cells matter. The columns are repeatedly halved into panels, and the load of a row on a panel is
replaced by loads at the n Chebyshev nodes of the panel: the weight of each node is the integral of the pressure times
its Lagrange polynomial, so that all polynomials below degree n are integrated exactly. The field of a load at xi is
analytic up to the ellipse through the point with its foci at the panel's ends, so the error falls like exp(-n eta), eta
the ellipse's parameter, and a panel handles all rows outside the ellipse of its largest n; the rows inside are passed
on to its two halves, and from the smallest panels to Love's form.

All rows share their panels' nodes, and along a row the loads are uniform: they have the closed form of
`nonhertz.subsurface.tails`, evaluated once per edge between two rows, times the step of the weights there.

References
----------
A. E. H. Love, The stress produced in a semi-infinite solid by pressure on part of the boundary, Philosophical
Transactions of the Royal Society A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009. His corner functions are written
here in a form that also holds on the surface; they and the rest are derived here and tested against quadrature.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from nonhertz.native import core
from nonhertz.patch.kernel import edges_from
from nonhertz.subsurface.free_faces import Spectrum
from nonhertz.subsurface.tails import ALONE, Load

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

LADDER = (3, 4, 5, 6, 8, 10, 12, 16)
# Error over the maximum pressure, see `rule_ellipses`. For the worst distribution of pressure, the error of the stress
# summed cell by cell is five times as large.
ERROR = 1e-7
# A panel of fewer columns is no cheaper than Love's corners.
SMALLEST_PANEL = 6


class Panels(NamedTuple):
    """The pressure in the form used by the core.

    Attributes
    ----------
    x_edges, y_edges : ndarray, shape (nx + 1,) and (ny + 1,)
        Edges of the cells of the smallest block that contains all pressure [mm].
    pressure : ndarray, shape (nx, ny)
        Pressure in that block [MPa].
    columns, rows : ndarray of int, shape (panels, 2)
        First column, or loaded row, of a panel, and the index after its last. The halves of panel k are 2 k + 1 and
        2 k + 2.
    middle, half : ndarray, shape (panels,)
        Middle and half-length of the panels [mm].
    first_node : ndarray of int, shape (rules + 1,)
        Index of the first node of each rule.
    nodes : ndarray, shape (panels, nodes)
        Positions of the nodes of all rules [mm].
    weights : ndarray, shape (panels, ny, nodes)
        Load on each node per unit length along y [N/mm].
    ellipses : ndarray, shape (rules, 2)
        Squared half-axes, along and across a panel, of the ellipse outside which a rule suffices, in half-lengths.
    """

    x_edges: Array
    y_edges: Array
    pressure: Array
    columns: Integers
    rows: Integers
    middle: Array
    half: Array
    first_node: Integers
    nodes: Array
    weights: Array
    ellipses: Array


@dataclass(frozen=True, eq=False)
class Rectangles(Load):
    """The pressure of a plane grid, for the field below it.

    The error is below 1e-6 of the maximum pressure. At the edges of cells on the surface, where stresses jump, rounding
    decides between either side and their mean; at the corners, where a shear stress is unbounded, the result is a large
    number.

    Attributes
    ----------
    panels : Panels or None
        The pressure on panels of columns; None where there is no pressure.

    Examples
    --------
    Below the middle of one square cell:

    >>> one = np.zeros(1)
    >>> square = Rectangles.of(one, one, 1.0, 1.0, np.ones((1, 1)))
    >>> square.stress(np.array([[0.0, 0.0, 0.5]]), 0.28).round(6)[0, :3]
    array([-0.076224, -0.076224, -0.700886])
    """

    panels: Panels | None

    @classmethod
    def of(cls, x: Array, y: Array, dx: float, dy: float, pressure: Array) -> Rectangles:
        """Return the load of cells with sides ``dx``, ``dy`` [mm], centred at ``x``, ``y``, under ``pressure`` [MPa].

        Parameters
        ----------
        x, y : ndarray, shape (nx,) and (ny,)
            Centres of the cells [mm], equidistant.
        dx, dy : float
            Sides of a cell [mm].
        pressure : ndarray, shape (nx, ny)
            Pressure [MPa], uniform in each cell.
        """
        if not pressure.any():
            return cls(None)
        columns, rows = _span(np.count_nonzero(pressure, axis=1)), _span(np.count_nonzero(pressure, axis=0))
        block = np.ascontiguousarray(pressure[columns, rows])
        x_edges = edges_from(float(x[columns.start]), block.shape[0], dx)
        return cls(_panels(x_edges, edges_from(float(y[rows.start]), block.shape[1], dy), block))

    @cached_property
    def in_core(self) -> core.SurfaceLoad:
        """The same pressure in the core."""
        assert self.panels is not None
        of = self.panels
        return core.rectangles(*of._replace(weights=of.weights.reshape(-1, of.nodes.shape[1])))

    def six(self, points: Array, poisson: float, displaced: bool, terms: Array = ALONE) -> Array:
        """Return six components of the stress [MPa], or of the displacement, at ``points`` (n, 3), shape (n, 6)."""
        return np.zeros((len(points), 6)) if self.panels is None else super().six(points, poisson, displaced, terms)

    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of all rows at wave numbers ``k`` [1/mm], for any ``y``."""
        if self.panels is None:
            nothing = np.zeros((k.size, 0))
            return Spectrum(np.zeros(0), nothing, nothing)
        waves = np.diff(np.exp(1j * k[:, None] * self.panels.x_edges), axis=1) / (1j * k[:, None])
        rows = np.pad(waves @ self.panels.pressure, ((0, 0), (1, 1)))
        steps = -np.diff(rows, axis=1)
        return Spectrum(self.panels.y_edges, steps.real, steps.imag)


def _span(bearing: NDArray[np.intp]) -> slice:
    """Return the slice from the first to the last nonzero entry, empty if there is none."""
    indices = np.flatnonzero(bearing)
    return slice(int(indices[0]), int(indices[-1]) + 1) if indices.size else slice(0, 0)


def _panels(x_edges: Array, y_edges: Array, pressure: Array) -> Panels:
    columns = np.array(list(_halvings(pressure.shape[0])))
    middle = 0.5 * (x_edges[columns[:, 1]] + x_edges[columns[:, 0]])
    half = 0.5 * (x_edges[columns[:, 1]] - x_edges[columns[:, 0]])
    first_node = np.concatenate([[0], np.cumsum(LADDER)])
    nodes = middle[:, None] + half[:, None] * np.concatenate([chebyshev.chebpts1(n) for n in LADDER])
    rows = np.zeros_like(columns)
    weights = np.empty((len(columns), pressure.shape[1], nodes.shape[1]))
    for panel, (first, end) in enumerate(columns):
        bearing = pressure[first:end]
        span = _span(np.count_nonzero(bearing, axis=0))
        rows[panel] = span.start, span.stop
        edges = (x_edges[first : end + 1] - middle[panel]) / half[panel]
        lagrange = np.hstack([_lagrange_integrals(edges, n) for n in LADDER])
        weights[panel] = bearing.T @ (half[panel] * lagrange)
    return Panels(x_edges, y_edges, pressure, columns, rows, middle, half, first_node, nodes, weights, rule_ellipses())


def _halvings(count: int) -> Iterator[tuple[int, int]]:
    """Yield the first and end column of all panels, level by level; all levels are complete."""
    parts = 1
    while True:
        ends = np.rint(np.linspace(0.0, count, parts + 1)).astype(np.int64).tolist()
        yield from pairwise(ends)
        if count <= SMALLEST_PANEL * parts:
            return
        parts *= 2


def _lagrange_integrals(edges: Array, n: int) -> Array:
    """Return the integrals over cells between ``edges`` of the Lagrange polynomials of n nodes, shape (cells, n)."""
    antiderivatives = chebyshev.chebval(edges, chebyshev.chebint(np.eye(n)))
    coefficients = chebyshev.chebvander(chebyshev.chebpts1(n), n - 1) * (2.0 / n)
    coefficients[:, 0] *= 0.5
    integrals: Array = np.diff(antiderivatives).T @ coefficients.T
    return integrals


def rule_ellipses() -> Array:
    """Return the squared half-axes of the ellipse of every rule.

    A row at a distance h from a panel of half-length 1 adds a stress error proportional to exp(-n eta) / h^2, so all
    rows beyond that distance add exp(-n eta) / h with h = sinh(eta).
    """
    axes = np.empty((len(LADDER), 2))
    for rule, n in enumerate(LADDER):
        eta = 1.0
        for _ in range(60):
            eta = -math.log(ERROR * math.sinh(eta)) / n
        axes[rule] = math.cosh(eta) ** 2, math.sinh(eta) ** 2
    return axes
