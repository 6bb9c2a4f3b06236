"""Linear equations: against NumPy's, whatever the size, the order of the pivots and the padding."""

import numpy as np
import pytest

from nonhertz.strip.linear import BLOCK, DEEP, blank, padded, solve_in_place, subtract_product


def solved(matrix, sides):
    n, count = sides.shape
    equations = blank(n, count)
    at = padded(n)
    equations[:n, :n], equations[:n, at : at + count] = matrix, sides
    solve_in_place(equations)
    return equations[:, at : at + count]


@pytest.mark.parametrize("n", [1, 2, 7, 8, 9, 16, 31, 40, 87])
@pytest.mark.parametrize("sides", [1, 3, 20])
def test_solutions_are_those_of_lapack(n, sides):
    rng = np.random.default_rng(n)
    # The diagonal is none to rely on: most pivots lie elsewhere.
    matrix, right = rng.normal(size=(n, n)), rng.normal(size=(n, sides))
    found = solved(matrix, right)
    # Both lose what the condition of the matrix costs.
    lost = 100.0 * np.finfo(float).eps * np.linalg.cond(matrix)
    np.testing.assert_allclose(found[:n], np.linalg.solve(matrix, right), rtol=lost, atol=lost)
    assert np.all(found[n:] == 0.0)


def test_rows_change_places_where_they_must():
    order = np.random.default_rng(5).permutation(19)
    right = np.arange(19.0)[:, None]
    assert np.array_equal(solved(np.eye(19)[order], right)[:19], np.argsort(order)[:, None])


def test_a_singular_matrix_has_no_finite_solution():
    matrix = np.ones((9, 9))
    assert not np.all(np.isfinite(solved(matrix, np.ones((9, 1)))))


@pytest.mark.parametrize("n", [BLOCK, 5 * BLOCK, DEEP + BLOCK])
@pytest.mark.parametrize("column", [0, BLOCK])
def test_a_product_is_taken_away(n, column):
    rng = np.random.default_rng(n)
    left, right, result = rng.normal(size=(n, n)), rng.normal(size=(n, column + n)), rng.normal(size=(n, n + BLOCK))
    expected = result.copy()
    expected[:, :n] -= left @ right[:, column:]
    subtract_product(result, left, right, column)
    # Sums of n products of numbers of size one.
    np.testing.assert_allclose(result, expected, rtol=0.0, atol=1e-13)
