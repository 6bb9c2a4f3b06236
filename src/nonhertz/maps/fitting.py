"""From solved cases to a surrogate: weighted least squares for the coefficients of its splines.

The mean approach D is fitted to approach and moment, which are D + x/3 dD/dx and -Q dD/dgamma; to the three stiffnesses
with a small weight, because on a graded grid their discretisation error is ten times as large; and to the first touch,
which is known without solving: D(0, gamma). Weights turn a residual into a relative error of load or moment at a given
approach and tilt. The spline begins with dD/dx = 0 at no load, as point and line contacts do. The fit is the largest
smooth part of the solutions: their scatter from grid to grid is averaged out.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.maps.evaluation import CENTRE, NARROW, TILT_HIGH, TILT_LOW, WIDENING
from nonhertz.maps.spline import knot_count, polynomials_in_cells, roughness, rows
from nonhertz.native import core
from nonhertz.result.read_only import freeze

if TYPE_CHECKING:
    from scipy import sparse

Array = NDArray[np.float64]

#: Fraction of the largest load below which errors are no longer relative to the load.
LIGHT = 0.01
_STIFFNESS_WEIGHT = 0.05
_TOUCH_WEIGHT = 3.0
# Weight of fourth differences of coefficients beside the data: it matters only where there are no data.
_SMOOTHING, _SMOOTHING_OTHERS = 1e-3, 1e-2
_RIDGE = 1e-14  # of the mean diagonal


@dataclass(frozen=True)
class Samples:
    """Solved cases.

    Attributes
    ----------
    load, tilt, approach, moment : ndarray, shape (n,)
        As in `nonhertz.Solution` [N, rad, mm, N mm].
    stiffness : ndarray, shape (n, 2, 2)
    max_pressure, max_half_width : ndarray, shape (n,)
        [MPa], [mm].
    places : ndarray, shape (n, quantiles)
        Positions up to which the contact carries given fractions of the load [mm].
    strip_loads : ndarray, shape (n, stations)
        Load on the strips between stations [N], for checks.
    """

    load: Array
    tilt: Array
    approach: Array
    moment: Array
    stiffness: Array
    max_pressure: Array
    max_half_width: Array
    places: Array
    strip_loads: Array

    def joined(self, other: Samples) -> Samples:
        """Return the samples of both."""
        return Samples(*(np.concatenate([getattr(self, name), getattr(other, name)]) for name in vars(self)))


@dataclass(frozen=True)
class Shape:
    """The cells of a surrogate.

    Attributes
    ----------
    numbers : ndarray
        The first numbers of ``ContactMap.table``, without the numbers of cells.
    breaks : tuple of ndarray
        Borders of the cells in x and in z, from 0 to 1.
    half_length : float
        Lever arm [mm] to which errors of moments are relative.
    """

    numbers: Array
    breaks: tuple[Array, Array]
    half_length: float

    @property
    def counted(self) -> Array:
        """The first eleven of ``ContactMap.table``."""
        return np.concatenate([self.numbers, [knots.size - 1 for knots in self.breaks]])

    @property
    def max_load(self) -> float:
        """The largest load [N]."""
        return float(self.numbers[0])

    @property
    def tilt_range(self) -> tuple[float, float]:
        """Lowest and highest tilt [rad]."""
        return float(self.numbers[TILT_LOW]), float(self.numbers[TILT_HIGH])

    def prescribed(self, x: Array, z: Array) -> tuple[Array, Array]:
        """Return load and tilt at positions in the two coordinates."""
        tilts = self.tilt_range
        if self.numbers[WIDENING] == 0.0:
            return self.max_load * x**3, tilts[0] + (tilts[1] - tilts[0]) * z
        scale = self.numbers[NARROW] + self.numbers[WIDENING] * x**3
        low, high = (np.arcsinh((end - self.numbers[CENTRE]) / scale) for end in tilts)
        tilt = self.numbers[CENTRE] + scale * np.sinh(low + (high - low) * z)
        return self.max_load * x**3, np.clip(tilt, *tilts)

    def coordinates(self, load: Array, tilt: Array) -> tuple[Array, Array]:
        """Return x, and z with its five derivatives, shape (6, n)."""
        x = np.cbrt(load / self.max_load)
        inside = np.clip(tilt, self.numbers[TILT_LOW], self.numbers[TILT_HIGH])
        return x, core.map_tilt_coordinates(self.counted, x, inside).T


def fit_surfaces(shape: Shape, samples: Samples, touch: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return the coefficients of the mean approach, and those of all other quantities.

    ``touch`` are tilts [rad], and the approaches of first touch at them [mm].

    Returns
    -------
    tuple of ndarray
        Shapes (first basis functions, second basis functions) and (quantities, the same).
    """
    # Imported here: a map that is read does not need it.
    from scipy import sparse

    counts = [knot_count(knots) for knots in shape.breaks]
    x, z = shape.coordinates(samples.load, samples.tilt)
    light = np.maximum(samples.load, LIGHT * shape.max_load)
    system, right = _mean_approach_rows(shape, samples, x, z, light)
    touch_x, touch_z = shape.coordinates(np.zeros(touch[0].size), touch[0])
    weight = _TOUCH_WEIGHT * float(np.median(samples.stiffness[:, 0, 0] / light))
    system.append(weight * rows(shape.breaks, (touch_x, touch_z[0])))
    right.append(weight * touch[1])
    # The first two rows of coefficients are the same: no slope at no load.
    merged = sparse.kron(
        sparse.csr_array(np.concatenate([np.eye(1, counts[0] - 1), np.eye(counts[0] - 1)])),
        sparse.eye_array(counts[1]),
    )
    rough = _SMOOTHING * weight / _TOUCH_WEIGHT * roughness(shape.breaks)
    mean = merged @ _least_squares(system, right, rough, merged)
    relative = samples.load / light
    values = np.column_stack([samples.max_pressure / x, samples.max_half_width / x, samples.places])
    scale = np.array([values[:, 0].max(), values[:, 1].max(), *[shape.half_length] * (values.shape[1] - 2)])
    rough = _SMOOTHING_OTHERS * roughness(shape.breaks)
    plain = [sparse.diags_array(relative) @ rows(shape.breaks, (x, z[0]))]
    others = _least_squares(plain, [relative[:, None] * values / scale], rough, None) * scale
    return mean.reshape(counts), others.T.reshape(-1, *counts)


def _mean_approach_rows(
    shape: Shape, samples: Samples, x: Array, z: Array, light: Array
) -> tuple[list[sparse.sparray], list[Array]]:
    """Return weighted equations for the mean approach: approach, moment and the three stiffnesses."""
    from scipy import sparse

    at, z_x, z_g, z_xx, z_xg, z_gg = z
    load = samples.load

    def combined(*terms: tuple[Array, tuple[int, int]]) -> sparse.sparray:
        first, *others = (sparse.diags_array(factor) @ rows(shape.breaks, (x, at), order) for factor, order in terms)
        return sum(others, first)

    def by_x(factor: Array) -> tuple[tuple[Array, tuple[int, int]], ...]:
        return (factor, (1, 0)), (factor * z_x, (0, 1))

    k11, k12, k22 = samples.stiffness[:, 0, 0], samples.stiffness[:, 0, 1], samples.stiffness[:, 1, 1]
    half = shape.half_length
    of_approach, of_arm = k11 / light, load / light / half
    one = np.ones(x.size)
    small = _STIFFNESS_WEIGHT
    by_load = x / (9.0 * load)  # x / 3 dD/dx by the load
    return [
        combined((of_approach, (0, 0)), *by_x(of_approach * x / 3.0)),
        combined((-of_arm * z_g, (0, 1))),
        combined(*by_x(small * load * of_approach * 4.0 * by_load),
                 *((small * load * of_approach * by_load * x * factor, order) for factor, order in
                   ((one, (2, 0)), (2.0 * z_x, (1, 1)), (z_x**2, (0, 2)), (z_xx, (0, 1))))),
        combined((-small * of_arm * z_g, (0, 1)),
                 *((-small * of_arm * x / 3.0 * factor, order) for factor, order in
                   ((z_g, (1, 1)), (z_x * z_g, (0, 2)), (z_xg, (0, 1))))),
        combined(*((-small * load / k11 / half**2 * factor, order) for factor, order in
                   ((z_g**2, (0, 2)), (z_gg, (0, 1))))),
    ], [
        of_approach * samples.approach,
        of_arm * samples.moment / load,
        small * load / light,
        small * of_arm * k12 / k11,
        small / k11 / half**2 * (k22 - k12**2 / k11),
    ]  # fmt: skip


def _least_squares(
    system: list[sparse.sparray], right: list[Array], rough: sparse.sparray, merged: sparse.sparray | None
) -> Array:
    from scipy import sparse
    from scipy.sparse.linalg import splu

    rows = sparse.vstack([*system, rough])
    if merged is not None:
        rows = rows @ merged
    zeros = np.zeros((rough.shape[0], *right[0].shape[1:]))
    values = np.concatenate([*right, zeros])
    normal = sparse.csc_array(rows.T @ rows)
    normal += sparse.diags_array(np.full(normal.shape[0], _RIDGE * normal.diagonal().mean()), format="csc")
    solver = splu(normal)
    solution = solver.solve(rows.T @ values)
    # Once more on the residual: normal equations square the condition number.
    improved: Array = solution + solver.solve(rows.T @ (values - rows @ solution))
    return improved


def table(numbers: Array, breaks: tuple[Array, Array], mean_approach: Array, others: Array) -> Array:
    """Return all numbers of a map in one row, in the layout that is evaluated.

    Parameters
    ----------
    numbers : ndarray, shape (11,)
        The first numbers.
    breaks : tuple of ndarray
        Borders of the cells in x and in z.
    mean_approach, others : ndarray
        Coefficients, as `fit_surfaces` returns them. The table holds polynomials of the cells; those of the other
        quantities cell by cell.
    """
    arranged = np.moveaxis(polynomials_in_cells(breaks, others), 0, 2)
    return freeze(
        np.concatenate([numbers, *breaks, polynomials_in_cells(breaks, mean_approach).ravel(), arranged.ravel()])
    )
