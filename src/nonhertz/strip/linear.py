"""Small dense linear equations, by Gaussian elimination with row pivoting.

With a hundred unknowns, a call to LAPACK loses in copies and thread synchronisation what it saves in arithmetic. Here
nearly all of the work is one matrix product, in tiles of 4 x 8 numbers that stay in registers while a row and a column
stream past them. Systems are padded to whole blocks with equations x = 0, so that tiles never meet an edge. Each system
is solved by one thread in a fixed order of operations: a contact solved among a thousand others gives the same bits as
on its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nonhertz.compiled import compiled

Array = NDArray[np.float64]
Eight = tuple[float, float, float, float, float, float, float, float]

BLOCK = 8  # rows and columns eliminated at a time, also the width of a tile
_TALL = 4  # the height of a tile
DEEP = 256  # columns of a product that are added up at a time, whose rows stay in the cache
_NONE = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def padded(count: int) -> int:
    """Return ``count`` rounded up to whole blocks."""
    return (count + BLOCK - 1) // BLOCK * BLOCK


@compiled
def blank(unknowns: int, sides: int) -> Array:
    """Return an empty system, all zero except for the padding.

    Returns
    -------
    ndarray, shape (padded(unknowns), padded(unknowns) + padded(sides))
        The matrix goes in the first rows and columns, the right-hand sides in the columns from
        ``padded(unknowns)`` onwards.
    """
    n = padded(unknowns)
    equations = np.zeros((n, n + padded(sides)))
    for i in range(unknowns, n):
        equations[i, i] = 1.0
    return equations


@compiled
def solve_in_place(equations: Array) -> None:
    """Replace the right-hand sides of a system from `blank` by its solutions.

    The matrix is overwritten. Where it is singular the solutions are not finite.
    """
    n, columns = equations.shape
    panel = np.empty((BLOCK, n))
    for first in range(0, n, BLOCK):
        beyond = first + BLOCK
        _pivot(equations, first, panel)
        for k in range(first + 1, beyond):
            for other in range(first, k):
                _subtract(equations[k, beyond:], equations[other, beyond:], equations[k, other])
        _subtract_tiles(equations, equations, equations, beyond, n, beyond, columns, first, first, 0, BLOCK)
    for first in range(n - BLOCK, -1, -BLOCK):
        for k in range(first + BLOCK - 1, first - 1, -1):
            for other in range(k + 1, first + BLOCK):
                _subtract(equations[k, n:], equations[other, n:], equations[k, other])
            _scale(equations[k, n:], 1.0 / equations[k, k])
        _subtract_tiles(equations, equations, equations, 0, first, n, columns, first, first, 0, BLOCK)


@compiled
def subtract_product(result: Array, left: Array, right: Array, column: int) -> None:
    """Subtract a product of padded square matrices from the left square of ``result``.

    Parameters
    ----------
    result, left : ndarray, shape (n, n or more)
        Arrays of whole blocks.
    right : ndarray, shape (n, column + n or more)
        Only the square starting at this ``column`` is used.
    """
    n = result.shape[0]
    for first in range(0, n, DEEP):
        _subtract_tiles(result, left, right, 0, n, 0, n, first, first, column, min(DEEP, n - first))


@compiled
def _pivot(equations: Array, first: int, panel: Array) -> None:
    """Eliminate within one block of columns, leaving the factors below the diagonal."""
    n = equations.shape[0]
    for i in range(first, n):
        for c in range(BLOCK):
            panel[c, i] = equations[i, first + c]
    for c in range(BLOCK):
        k = first + c
        largest = k
        for i in range(k + 1, n):
            if abs(panel[c, i]) > abs(panel[c, largest]):
                largest = i
        if largest != k:
            for j in range(first, equations.shape[1]):
                equations[k, j], equations[largest, j] = equations[largest, j], equations[k, j]
            for other in range(BLOCK):
                panel[other, k], panel[other, largest] = panel[other, largest], panel[other, k]
        _scale(panel[c, k + 1 :], 1.0 / panel[c, k])
        for other in range(c + 1, BLOCK):
            _subtract(panel[other, k + 1 :], panel[c, k + 1 :], panel[other, k])
    for i in range(first, n):
        for c in range(BLOCK):
            equations[i, first + c] = panel[c, i]


@compiled
def _scale(row: Array, factor: float) -> None:
    for j in range(row.size):
        row[j] *= factor


@compiled
def _subtract(row: Array, other: Array, factor: float) -> None:
    for j in range(row.size):
        row[j] -= factor * other[j]


@compiled
def _subtract_tiles(
    result: Array,
    left: Array,
    right: Array,
    top: int,
    bottom: int,
    begin: int,
    end: int,
    left_column: int,
    right_row: int,
    shift: int,
    depth: int,
) -> None:
    """Subtract a product from rows ``top`` to ``bottom`` and columns ``begin`` to ``end`` of ``result``.

    Its left factor has ``depth`` columns starting at ``left_column``; its right factor has as many rows starting at
    ``right_row``, and its columns lie ``shift`` to the right of those of the result. Unsigned integers avoid a check
    for negative indices.
    """
    tall, wide = np.uint64(_TALL), np.uint64(BLOCK)
    i = np.uint64(top)
    while i < np.uint64(bottom):
        j = np.uint64(begin)
        while j < np.uint64(end):
            one = two = three = four = _NONE
            for k in range(np.uint64(depth)):
                at, row, column = np.uint64(left_column) + k, np.uint64(right_row) + k, np.uint64(shift) + j
                one = _more(one, left[i, at], right, row, column)
                two = _more(two, left[i + np.uint64(1), at], right, row, column)
                three = _more(three, left[i + np.uint64(2), at], right, row, column)
                four = _more(four, left[i + np.uint64(3), at], right, row, column)
            _take_from(result, i, j, one)
            _take_from(result, i + np.uint64(1), j, two)
            _take_from(result, i + np.uint64(2), j, three)
            _take_from(result, i + np.uint64(3), j, four)
            j += wide
        i += tall


@compiled
def _more(s: Eight, factor: float, right: Array, row: np.uint64, column: np.uint64) -> Eight:
    """Return ``s`` plus ``factor`` times eight numbers of a row."""
    return (
        s[0] + factor * right[row, column],
        s[1] + factor * right[row, column + np.uint64(1)],
        s[2] + factor * right[row, column + np.uint64(2)],
        s[3] + factor * right[row, column + np.uint64(3)],
        s[4] + factor * right[row, column + np.uint64(4)],
        s[5] + factor * right[row, column + np.uint64(5)],
        s[6] + factor * right[row, column + np.uint64(6)],
        s[7] + factor * right[row, column + np.uint64(7)],
    )


@compiled
def _take_from(result: Array, row: np.uint64, column: np.uint64, s: Eight) -> None:
    result[row, column] -= s[0]
    result[row, column + np.uint64(1)] -= s[1]
    result[row, column + np.uint64(2)] -= s[2]
    result[row, column + np.uint64(3)] -= s[3]
    result[row, column + np.uint64(4)] -= s[4]
    result[row, column + np.uint64(5)] -= s[5]
    result[row, column + np.uint64(6)] -= s[6]
    result[row, column + np.uint64(7)] -= s[7]
