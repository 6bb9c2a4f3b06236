"""Linear equations: against NumPy's, whatever the size, the order of the pivots and the padding."""

import numpy as np
import pytest

from nonhertz.native import core


@pytest.mark.parametrize("n", [1, 2, 7, 8, 9, 16, 31, 40, 87])
@pytest.mark.parametrize("sides", [1, 3, 20])
def test_solutions_are_those_of_lapack(n, sides):
    rng = np.random.default_rng(n)
    # The diagonal is none to rely on: most pivots lie elsewhere.
    matrix, right = rng.normal(size=(n, n)), rng.normal(size=(n, sides))
    # Both lose what the condition of the matrix costs.
    lost = 100.0 * np.finfo(float).eps * np.linalg.cond(matrix)
    np.testing.assert_allclose(core.solve_linear(matrix, right), np.linalg.solve(matrix, right), rtol=lost, atol=lost)


def test_rows_change_places_where_they_must():
    order = np.random.default_rng(5).permutation(19)
    right = np.arange(19.0)[:, None]
    assert np.array_equal(core.solve_linear(np.eye(19)[order], right), np.argsort(order)[:, None])


def test_a_singular_matrix_has_no_finite_solution():
    assert not np.all(np.isfinite(core.solve_linear(np.ones((9, 9)), np.ones((9, 1)))))


@pytest.mark.parametrize("n", [core.BLOCK, 5 * core.BLOCK - 3, 257])
def test_a_product_is_taken_away(n):
    """Also of more columns than are added up at a time."""
    rng = np.random.default_rng(n)
    left, right, result = rng.normal(size=(3, n, n))
    # Sums of n products of numbers of size one.
    found = core.subtract_product(result, left, right)
    np.testing.assert_allclose(found, result - left @ right, rtol=0.0, atol=1e-13)
