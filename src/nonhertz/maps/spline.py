"""Splines of degree 5 on a grid of cells, in NumPy: basis, derivatives as sparse rows, polynomials of the cells.

A spline is given by a coefficient for each pair of basis functions in the two directions. With degree 5 the fourth
derivative is continuous, so that a stiffness, a second derivative, is smooth.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.maps.evaluation import ORDER

if TYPE_CHECKING:
    from scipy import sparse
    from scipy.interpolate import BSpline

Array = NDArray[np.float64]

DEGREE = ORDER - 1
_ROUGHNESS = 4  # order of the differences of coefficients that `roughness` measures


def knot_count(breaks: Array) -> int:
    """Return the number of basis functions on the intervals between ``breaks``."""
    return breaks.size - 1 + DEGREE


def basis(breaks: Array, derivative: int = 0) -> BSpline:
    """Return derivatives of all basis functions, as splines of a lower degree."""
    # Imported here: a map that is read does not need it.
    from scipy.interpolate import BSpline

    clamped = np.concatenate([np.repeat(breaks[0], DEGREE), breaks, np.repeat(breaks[-1], DEGREE)])
    return BSpline(clamped, np.eye(knot_count(breaks)), DEGREE).derivative(derivative)


def rows(
    breaks: tuple[Array, Array], places: tuple[Array, Array], derivatives: tuple[int, int] = (0, 0)
) -> sparse.csr_array:
    """Return rows from the coefficients of a spline to a derivative at places.

    Parameters
    ----------
    breaks : tuple of ndarray
        Borders of the cells in both directions, ascending.
    places : tuple of ndarray, shape (n,)
        First and second coordinate of each place.
    derivatives : tuple of int
        Order of the derivative in both directions.
    """
    from scipy import sparse
    from scipy.interpolate import NdBSpline

    first, second = (basis(knots, order) for knots, order in zip(breaks, derivatives, strict=True))
    lower = sparse.kron(
        *(sparse.csr_array(axis.c[: axis.t.size - axis.k - 1]) for axis in (first, second)), format="csr"
    )
    design = NdBSpline.design_matrix(np.column_stack(places), (first.t, second.t), (first.k, second.k))
    # Its shape ends with the last function that is nonzero at some place.
    values = sparse.csr_array((design.data, design.indices, design.indptr), (len(design.indptr) - 1, lower.shape[0]))
    return sparse.csr_array(values @ lower)


def roughness(breaks: tuple[Array, Array]) -> sparse.csr_array:
    """Return rows for the fourth differences of neighbouring coefficients in both directions.

    They determine coefficients in cells without data, and vanish for coefficients that vary slowly from cell to cell.
    """
    from scipy import sparse

    counts = [knot_count(knots) for knots in breaks]
    steps = [sparse.csr_array(np.diff(np.eye(count), n=_ROUGHNESS, axis=0)) for count in counts]
    same = [sparse.eye_array(count) for count in counts]
    return sparse.csr_array(sparse.vstack([sparse.kron(steps[0], same[1]), sparse.kron(same[0], steps[1])]))


def polynomials(breaks: Array) -> Array:
    """Return the powers of the local coordinate, 0 to 1, in each basis function: shape (intervals, 6, 6)."""
    powers = [basis(breaks, power)(breaks[:-1]) / math.factorial(power) for power in range(ORDER)]
    local = np.stack(powers, axis=-1) * np.diff(breaks)[:, None, None] ** np.arange(ORDER)
    own = np.arange(breaks.size - 1)[:, None] + np.arange(ORDER)
    return np.take_along_axis(local, own[:, :, None], axis=1)


def polynomials_in_cells(breaks: tuple[Array, Array], coefficients: Array) -> Array:
    """Return the polynomials of all cells, shape (..., first cells, second cells, 6, 6).

    Parameters
    ----------
    breaks : tuple of ndarray
        Borders of the cells.
    coefficients : ndarray, shape (..., first basis functions, second basis functions)
    """
    first, second = polynomials(breaks[0]), polynomials(breaks[1])
    windows = np.lib.stride_tricks.sliding_window_view(coefficients, (ORDER, ORDER), axis=(-2, -1))
    coefficients_of_cells: Array = np.einsum("ikp,...ijkl,jlq->...ijpq", first, windows, second, optimize=True)
    return coefficients_of_cells


def jumps(breaks: tuple[Array, Array], coefficients: Array, places: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return the changes of the highest derivative around the cells of places, in both directions.

    Times the size of the cell to the power of five they estimate the change by a finer spline.
    """
    polynomials = polynomials_in_cells(breaks, coefficients)
    at = [
        np.clip(np.searchsorted(knots, place, side="right") - 1, 0, knots.size - 2)
        for knots, place in zip(breaks, places, strict=True)
    ]
    local = [(place - knots[i]) / (knots[i + 1] - knots[i]) for knots, place, i in zip(breaks, places, at, strict=True)]
    powers = [fraction[:, None] ** np.arange(ORDER) for fraction in local]
    # The leading coefficient in one direction, along the other at the place.
    leading = (
        np.einsum("nq,inq->in", powers[1], polynomials[:, at[1], DEGREE, :]),
        np.einsum("np,jnp->jn", powers[0], polynomials[at[0], :, :, DEGREE].swapaxes(0, 1)),
    )
    changes = []
    for knots, rows, i in zip(breaks, leading, at, strict=True):
        derivatives = rows / np.diff(knots)[:, None] ** DEGREE
        around = np.abs(np.diff(derivatives, axis=0))
        padded = np.concatenate([np.zeros((1, i.size)), around, np.zeros((1, i.size))])
        largest = np.maximum(padded[i, np.arange(i.size)], padded[i + 1, np.arange(i.size)])
        changes.append(largest * (knots[i + 1] - knots[i]) ** DEGREE)
    return changes[0], changes[1]
