"""Small dense linear equations, by Gaussian elimination with row pivoting.

With a hundred unknowns a call to LAPACK is as dear in copies, and in threads that wait for each other, as it is cheap
in arithmetic. Four rows are subtracted at a time, so that each number is fetched and put back once for four
multiplications. One thread does the same in the same order whoever else is at work, so that a contact solved among a
thousand others comes out as if it had been alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled

Array = NDArray[np.float64]

BLOCK = 4


@compiled
def solve_in_place(equations: Array) -> None:
    """Replace the right-hand sides in ``equations`` by the solutions.

    Parameters
    ----------
    equations : ndarray, shape (n, n + sides)
        A matrix, and beside it the right-hand sides. The matrix is overwritten. Where it is singular the solutions are
        not finite.
    """
    n = equations.shape[0]
    for first in range(0, n, BLOCK):
        beyond = min(first + BLOCK, n)
        _pivot(equations, first, beyond)
        for k in range(first + 1, beyond):
            for other in range(first, k):
                _subtract(equations[k, beyond:], equations[other, beyond:], equations[k, other])
        _subtract_rows(equations, first, beyond, beyond, n, beyond)
    for first in range((n - 1) // BLOCK * BLOCK, -1, -BLOCK):
        beyond = min(first + BLOCK, n)
        for k in range(beyond - 1, first - 1, -1):
            for other in range(k + 1, beyond):
                _subtract(equations[k, n:], equations[other, n:], equations[k, other])
            equations[k, n:] *= 1.0 / equations[k, k]
        _subtract_rows(equations, first, beyond, 0, first, n)


@compiled
def _pivot(equations: Array, first: int, beyond: int) -> None:
    """Eliminate within the columns from ``first`` to ``beyond``, leaving the factors below the diagonal."""
    n = equations.shape[0]
    for k in range(first, beyond):
        largest = k
        for i in range(k + 1, n):
            if abs(equations[i, k]) > abs(equations[largest, k]):
                largest = i
        if largest != k:
            for j in range(first, equations.shape[1]):
                equations[k, j], equations[largest, j] = equations[largest, j], equations[k, j]
        inverse = 1.0 / equations[k, k]
        for i in range(k + 1, n):
            factor = equations[i, k] * inverse
            equations[i, k] = factor
            for j in range(k + 1, beyond):
                equations[i, j] -= factor * equations[k, j]


@compiled
def _subtract_rows(equations: Array, first: int, beyond: int, start: int, stop: int, column: int) -> None:
    """Subtract the rows from ``first`` to ``beyond`` from those between ``start`` and ``stop``.

    The factors are what these have in the columns from ``first`` to ``beyond``; what lies from ``column`` on is
    changed.
    """
    if beyond - first < BLOCK:
        for i in range(start, stop):
            for other in range(first, beyond):
                _subtract(equations[i, column:], equations[other, column:], equations[i, other])
        return
    one, two = equations[first, column:], equations[first + 1, column:]
    three, four = equations[first + 2, column:], equations[first + 3, column:]
    for i in range(start, stop):
        row = equations[i]
        f1, f2, f3, f4 = row[first], row[first + 1], row[first + 2], row[first + 3]
        _subtract_four(row[column:], one, two, three, four, f1, f2, f3, f4)


@compiled
def add_product(result: Array, left: Array, right: Array) -> None:
    """Add the matrix product ``left @ right`` to the first columns of ``result``."""
    n, columns = right.shape
    whole = n // BLOCK * BLOCK
    for k in range(0, whole, BLOCK):
        one, two, three, four = right[k], right[k + 1], right[k + 2], right[k + 3]
        for i in range(result.shape[0]):
            f1, f2, f3, f4 = -left[i, k], -left[i, k + 1], -left[i, k + 2], -left[i, k + 3]
            _subtract_four(result[i, :columns], one, two, three, four, f1, f2, f3, f4)
    for k in range(whole, n):
        for i in range(result.shape[0]):
            _subtract(result[i, :columns], right[k], -left[i, k])


@compiled
def _subtract(row: Array, other: Array, factor: float) -> None:
    for j in range(row.size):
        row[j] -= factor * other[j]


@compiled
def _subtract_four(
    row: Array, one: Array, two: Array, three: Array, four: Array, f1: float, f2: float, f3: float, f4: float
) -> None:
    for j in range(row.size):
        row[j] -= f1 * one[j] + f2 * two[j] + f3 * three[j] + f4 * four[j]
