"""The field below a plane grid of cells, each under a uniform pressure.

Love's closed form of one cell costs a logarithm and two arctangents per corner, too much for all cells of a grid
at thousands of points; it is kept for the few cells around the point. From further away only the moments of the load
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
here so that they hold on the surface too; they and the rest are derived here and tested against quadrature.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from nonhertz.compiled import compiled, plain_array
from nonhertz.patch.kernel import edges_from
from nonhertz.subsurface.free_faces import Spectrum
from nonhertz.subsurface.tails import TWO_PI, Load, Six, displacement_tail, stress_tail

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

LADDER = (3, 4, 5, 6, 8, 10, 12, 16)
# Of the largest pressure, see `rule_ellipses`. Summed cell by cell, the worst distribution of the pressure gives an
# error in stress five times as large.
ERROR = 1e-7
# A panel of fewer columns is no cheaper than Love's corners.
SMALLEST_PANEL = 6
# At a corner of a cell on the surface a shear stress is unbounded; it is evaluated at this distance, in cells.
AT_A_CORNER = 1e-12
EXACT = -1


class Panels(NamedTuple):
    """The pressure in the form that the compiled loops use.

    Attributes
    ----------
    x_edges, y_edges : ndarray, shape (nx + 1,) and (ny + 1,)
        Edges of the cells of the smallest block that contains all pressure [mm].
    pressure : ndarray, shape (nx, ny)
        Pressure in that block [MPa].
    columns, rows : ndarray of int, shape (panels, 2)
        First column, or loaded row, of a panel, and the one after its last. The halves of panel k are 2 k + 1 and
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

    Accurate to 1e-6 of the largest pressure. On the edges of cells on the surface, where stresses jump, rounding
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
        block = plain_array(pressure[columns, rows])
        x_edges = edges_from(float(x[columns.start]), block.shape[0], dx)
        return cls(_panels(x_edges, edges_from(float(y[rows.start]), block.shape[1], dy), block))

    def six(self, points: Array, poisson: float, displaced: bool) -> Array:
        """Return six components of its stress [MPa], or of the displacement, at ``points`` (n, 3), shape (n, 6)."""
        out = np.zeros((points.shape[0], 6))
        if self.panels is not None:
            (_displacement if displaced else _stress)(plain_array(points), poisson, self.panels, out)
        return out

    def spectrum(self, k: Array, y: float) -> Spectrum:
        """Return the transforms of all rows at wave numbers ``k`` [1/mm], wherever ``y`` is."""
        if self.panels is None:
            nothing = np.zeros((k.size, 0))
            return Spectrum(np.zeros(0), nothing, nothing)
        waves = np.diff(np.exp(1j * k[:, None] * self.panels.x_edges), axis=1) / (1j * k[:, None])
        rows = np.pad(waves @ self.panels.pressure, ((0, 0), (1, 1)))
        steps = -np.diff(rows, axis=1)
        return Spectrum(self.panels.y_edges, steps.real, steps.imag)


def _span(bearing: NDArray[np.intp]) -> slice:
    """Return the slice from the first to the last nonzero entry, empty if there is none."""
    found = np.flatnonzero(bearing)
    return slice(int(found[0]), int(found[-1]) + 1) if found.size else slice(0, 0)


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


@compiled
def _divide(x: float, y: float, z: float, panels: Panels, pieces: Integers) -> int:
    """Divide the load for one point; pieces are (panel, rule or EXACT, first row, row after the last)."""
    count, total = 0, panels.half.size
    todo = panels.rows.copy()
    for panel in range(total):
        first, end = todo[panel, 0], todo[panel, 1]
        for rule in range(panels.ellipses.shape[0]):
            if first >= end:
                break
            near, far = _rows_within(x, y, z, panels, panel, rule)
            near, far = max(near, first), min(far, end)
            if near >= far:
                near = far = end
            if first < near:
                pieces[count] = panel, rule, first, near
                count += 1
            if far < end:
                pieces[count] = panel, rule, far, end
                count += 1
            first, end = near, far
        if 2 * panel + 2 < total:
            for below in range(2 * panel + 1, 2 * panel + 3):
                todo[below, 0] = max(todo[below, 0], first)
                todo[below, 1] = min(todo[below, 1], end)
        elif first < end:
            pieces[count] = panel, EXACT, first, end
            count += 1
    return count


@compiled
def _rows_within(x: float, y: float, z: float, panels: Panels, panel: int, rule: int) -> tuple[int, int]:
    """Return the first row that reaches into the ellipse of a rule about the point, and the one after the last."""
    half = panels.half[panel]
    along, across = panels.ellipses[rule]
    reach = across * (half * half - (x - panels.middle[panel]) ** 2 / along) - z * z
    if reach < 0.0:
        return 0, 0
    first_edge = panels.y_edges[0]
    side = panels.y_edges[1] - first_edge
    low, high = (y - first_edge - math.sqrt(reach)) / side, (y - first_edge + math.sqrt(reach)) / side
    return math.floor(low), math.ceil(high)


@compiled
def _row_over(y: float, y_edges: Array, first: int, end: int) -> int:
    """Return the row from ``first`` up to but excluding ``end`` that the point lies under, -1 for none."""
    if not y_edges[first] < y <= y_edges[end]:
        return -1
    row = first
    while y_edges[row + 1] < y:
        row += 1
    return row


@compiled
def _step_at_corner(pressure: Array, i: int, j: int, left: int, right: int, first: int, end: int) -> float:
    """Return the second difference of the pressure at the low corner of cell (i, j), within a block of cells only."""
    step = 0.0
    if i < right and j < end:
        step += pressure[i, j]
    if i > left and j > first:
        step += pressure[i - 1, j - 1]
    if i > left and j < end:
        step -= pressure[i - 1, j]
    if i < right and j > first:
        step -= pressure[i, j - 1]
    return step


@compiled
def _stress_corner(X: float, Y: float, z: float, poisson: float, least: float) -> Six:
    """Return 2 pi times the stresses of Love's corner (X, Y) ahead of the point, in our order."""
    R = max(math.sqrt(X * X + Y * Y + z * z), least)
    across, along = max(X * X + z * z, least * least), max(Y * Y + z * z, least * least)
    lateral = 1.0 - 2.0 * poisson
    angle = math.atan2(X * Y, z * R)
    angle_x = math.atan2(X * Y, across + z * R)
    in_x, in_y = z * X * Y / (R * across), z * X * Y / (R * along)
    return (
        in_x - 2.0 * poisson * angle - lateral * angle_x,
        in_y - 2.0 * poisson * angle - lateral * (angle - angle_x),
        -angle - in_x - in_y,
        -z * z * X / (R * along),
        -z * z * Y / (R * across),
        -z / R - lateral * math.log(R + z),
    )


@compiled
def _displacement_corner(X: float, Y: float, z: float, poisson: float, least: float) -> Six:
    """Return 4 pi G times u_x, 0, u_z, u_y, 0, 0 of Love's corner (X, Y) ahead of the point."""
    R = max(math.sqrt(X * X + Y * Y + z * z), least)
    across, along = max(X * X + z * z, least * least), max(Y * Y + z * z, least * least)
    lateral = 1.0 - 2.0 * poisson
    angle = math.atan2(X * Y, z * R)
    angle_x = math.atan2(X * Y, across + z * R)
    of_y = math.copysign(math.log((abs(Y) + R) / math.sqrt(across)), Y)
    of_x = math.copysign(math.log((abs(X) + R) / math.sqrt(along)), X)
    depth = math.log(R + z)
    return (
        z * of_y + lateral * (Y * depth + z * of_y + X * angle_x),
        0.0,
        2.0 * (1.0 - poisson) * (X * of_y + Y * of_x) - lateral * z * angle,
        z * of_x + lateral * (X * depth + z * of_x + Y * (angle - angle_x)),
        0.0,
        0.0,
    )


@compiled
def _stress_of_line(X: float, z: float, poisson: float) -> Six:
    """Return 2 pi times the stress of an infinite line, in plane strain."""
    squared = X * X + z * z
    radial = -4.0 * z / squared
    return radial * X * X / squared, radial * poisson, radial * z * z / squared, 0.0, radial * X * z / squared, 0.0


@compiled
def _displacement_of_line(X: float, z: float, poisson: float) -> Six:
    """Return 4 pi G times its displacement, up to the constant of two tails."""
    squared = X * X + z * z
    u_x = 2.0 * (z * X / squared - (1.0 - 2.0 * poisson) * math.atan2(X, z))
    return u_x, 0.0, 2.0 * (z * z / squared - (1.0 - poisson) * math.log(squared)), 0.0, 0.0, 0.0


Sum = Callable[[Array, float, Panels, Array], None]


Part = Callable[[float, float, float, float, Panels, Integers, Array], None]


def _lines(scale: float, tail: Callable[..., Six], infinite: Callable[..., Six]) -> Part:
    """Return what adds up the lines of a piece, by what a tail and an infinite line do."""

    @compiled
    def add_lines(x: float, y: float, z: float, poisson: float, panels: Panels, piece: Integers, out: Array) -> None:
        panel, rule, first, end = piece
        weights = panels.weights[panel]
        begin, stop = panels.first_node[rule], panels.first_node[rule + 1]
        xx = yy = zz = yz = xz = xy = 0.0
        for k in range(begin, stop):
            X = x - panels.nodes[panel, k]
            before = 0.0
            for edge in range(first, end + 1):
                after = weights[edge, k] if edge < end else 0.0
                Y = panels.y_edges[edge] - y
                step = after - before
                if step == 0.0:
                    continue
                before = after
                mirrored = step if Y >= 0.0 else -step
                t_xx, t_yy, t_zz, t_yz, t_xz, t_xy = tail(X, abs(Y), z, poisson)
                xx += mirrored * t_xx
                yy += mirrored * t_yy
                zz += mirrored * t_zz
                yz += step * t_yz
                xz += mirrored * t_xz
                xy += step * t_xy
        own = _row_over(y, panels.y_edges, first, end)
        if own >= 0:
            for k in range(begin, stop):
                t_xx, t_yy, t_zz, _, t_xz, _ = infinite(x - panels.nodes[panel, k], z, poisson)
                xx += weights[own, k] * t_xx
                yy += weights[own, k] * t_yy
                zz += weights[own, k] * t_zz
                xz += weights[own, k] * t_xz
        out[0] += scale * xx
        out[1] += scale * yy
        out[2] += scale * zz
        out[3] += scale * yz
        out[4] += scale * xz
        out[5] += scale * xy

    return add_lines


def _cells(scale: float, corner: Callable[..., Six]) -> Part:
    """Return what adds up the cells of a piece, by what Love's corners do."""

    @compiled
    def add_cells(x: float, y: float, z: float, poisson: float, panels: Panels, piece: Integers, out: Array) -> None:
        panel, _, first, end = piece
        left, right = panels.columns[panel]
        least = AT_A_CORNER * (panels.x_edges[1] - panels.x_edges[0])
        for i in range(left, right + 1):
            for j in range(first, end + 1):
                step = scale * _step_at_corner(panels.pressure, i, j, left, right, first, end)
                if step != 0.0:
                    of_corner = corner(panels.x_edges[i] - x, panels.y_edges[j] - y, z, poisson, least)
                    for component in range(6):
                        out[component] += step * of_corner[component]

    return add_cells


def _sum_of(name: str, add_lines: Part, add_cells: Part) -> Sum:
    """Return a compiled loop, kept by its name, that adds up all pieces at points."""

    def add_up(points: Array, poisson: float, panels: Panels, out: Array) -> None:
        # Room for the pieces of one point: two for each rule of a panel, and one for Love's form.
        pieces = np.empty((panels.half.size * (2 * panels.ellipses.shape[0] + 1), 4), dtype=np.int64)
        for n in range(points.shape[0]):
            # A negative zero would put the arctangents on the other branch.
            x, y, z = points[n, 0], points[n, 1], points[n, 2] + 0.0
            for k in range(_divide(x, y, z, panels, pieces)):
                if pieces[k, 1] == EXACT:
                    add_cells(x, y, z, poisson, panels, pieces[k], out[n])
                else:
                    add_lines(x, y, z, poisson, panels, pieces[k], out[n])

    add_up.__name__ = name
    return compiled(add_up)


_stress = _sum_of("_stress", _lines(1.0 / TWO_PI, stress_tail, _stress_of_line), _cells(1.0 / TWO_PI, _stress_corner))
_displacement = _sum_of(
    "_displacement",
    _lines(0.5 / TWO_PI, displacement_tail, _displacement_of_line),
    _cells(0.5 / TWO_PI, _displacement_corner),
)
