"""Splines of degree 5 on a grid of cells, in NumPy: basis, derivatives as sparse rows, polynomials of the cells.

A spline is given by a coefficient for each pair of basis functions, one of the first direction, one of the second.
Degree 5 leaves the fourth derivative continuous, so that a stiffness, a second derivative, is smooth.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.interpolate import BSpline

from nonhertz.maps.evaluation import ORDER

Array = NDArray[np.float64]

DEGREE = ORDER - 1
_ROUGHNESS = 4  # order of the differences of coefficients that `roughness` measures


def size(breaks: Array) -> int:
    """Return the number of basis functions on the intervals between ``breaks``."""
    return breaks.size - 1 + DEGREE


def basis(breaks: Array, places: Array, derivative: int) -> tuple[NDArray[np.intp], Array]:
    """Return the first of the six basis functions that do not vanish at each place, and derivatives of all six."""
    clamped = np.concatenate([np.repeat(breaks[0], DEGREE), breaks, np.repeat(breaks[-1], DEGREE)])
    values = BSpline(clamped, np.eye(size(breaks)), DEGREE)(places, nu=derivative)
    first = np.clip(np.searchsorted(breaks, places, side="right") - 1, 0, breaks.size - 2)
    return first, np.take_along_axis(values, first[:, None] + np.arange(ORDER), axis=1)


class Rows:
    """Rows that turn the coefficients of a spline into its derivatives at places.

    Parameters
    ----------
    breaks : tuple of ndarray
        Borders of the cells in both directions, ascending.
    places : tuple of ndarray, shape (n,)
        First and second coordinate of each place.
    """

    def __init__(self, breaks: tuple[Array, Array], places: tuple[Array, Array]) -> None:
        self._shape = places[0].size, size(breaks[0]) * size(breaks[1])
        found = [[basis(each, place, order) for order in range(3)] for each, place in zip(breaks, places, strict=True)]
        self._first, self._second = ([values for _, values in each] for each in found)
        rows = found[0][0][0][:, None] + np.arange(ORDER)
        columns = found[1][0][0][:, None] + np.arange(ORDER)
        self._columns = (rows[:, :, None] * size(breaks[1]) + columns[:, None, :]).ravel()

    def derivative(self, first: int, second: int) -> sparse.csr_array:
        """Return the rows of a derivative, of order 0 to 2 in each direction."""
        values = self._first[first][:, :, None] * self._second[second][:, None, :]
        starts = np.arange(0, values.size + 1, ORDER * ORDER)
        return sparse.csr_array((values.ravel(), self._columns, starts), shape=self._shape)


def roughness(breaks: tuple[Array, Array]) -> sparse.csr_array:
    """Return rows for the fourth differences of neighbouring coefficients in both directions.

    They determine coefficients in cells without data, and vanish for what varies little from cell to cell.
    """
    counts = [size(each) for each in breaks]
    steps = [sparse.csr_array(np.diff(np.eye(count), n=_ROUGHNESS, axis=0)) for count in counts]
    return sparse.csr_array(
        sparse.vstack([sparse.kron(steps[0], sparse.eye(counts[1])), sparse.kron(sparse.eye(counts[0]), steps[1])])
    )


def polynomials(breaks: Array) -> Array:
    """Return the powers of the local coordinate, 0 to 1, in each basis function: shape (intervals, 6, 6)."""
    widths = np.diff(breaks)
    found = np.empty((widths.size, ORDER, ORDER))
    for power in range(ORDER):
        _, values = basis(breaks, breaks[:-1], power)
        found[:, :, power] = values * (widths**power / math.factorial(power))[:, None]
    return found


def cells(breaks: tuple[Array, Array], coefficients: Array) -> Array:
    """Return the polynomials of all cells, shape (..., first cells, second cells, 6, 6).

    Parameters
    ----------
    breaks : tuple of ndarray
        Borders of the cells.
    coefficients : ndarray, shape (..., first basis functions, second basis functions)
    """
    first, second = polynomials(breaks[0]), polynomials(breaks[1])
    windows = np.lib.stride_tricks.sliding_window_view(coefficients, (ORDER, ORDER), axis=(-2, -1))
    found: Array = np.einsum("ikp,...ijkl,jlq->...ijpq", first, windows, second, optimize=True)
    return found


def jumps(breaks: tuple[Array, Array], coefficients: Array, places: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return how much the highest derivative changes around the cells of places, in both directions.

    Times the size of the cell to the power of five it estimates what a finer spline would change there.
    """
    found = cells(breaks, coefficients)
    at = [
        np.clip(np.searchsorted(each, place, side="right") - 1, 0, each.size - 2)
        for each, place in zip(breaks, places, strict=True)
    ]
    local = [(place - each[i]) / (each[i + 1] - each[i]) for each, place, i in zip(breaks, places, at, strict=True)]
    powers = [each[:, None] ** np.arange(ORDER) for each in local]
    # The leading coefficient in one direction, along the other at the place.
    leading = (
        np.einsum("nq,inq->in", powers[1], found[:, at[1], DEGREE, :]),
        np.einsum("np,jnp->jn", powers[0], found[at[0], :, :, DEGREE].swapaxes(0, 1)),
    )
    changes = []
    for each, rows, i in zip(breaks, leading, at, strict=True):
        derivatives = rows / np.diff(each)[:, None] ** DEGREE
        around = np.abs(np.diff(derivatives, axis=0))
        padded = np.concatenate([np.zeros((1, i.size)), around, np.zeros((1, i.size))])
        largest = np.maximum(padded[i, np.arange(i.size)], padded[i + 1, np.arange(i.size)])
        changes.append(largest * (each[i + 1] - each[i]) ** DEGREE)
    return changes[0], changes[1]
