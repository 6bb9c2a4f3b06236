"""Products and systems of full matrices in the core."""

import numpy as np
import pytest

from nonhertz.native import core


def integers(rows, columns, seed):
    return np.random.default_rng(seed).integers(-9, 10, (rows, columns)).astype(float)


@pytest.mark.parametrize(("rows", "between", "columns"), [(1, 1, 1), (4, 3, 8), (7, 5, 9), (30, 41, 2)])
def test_products_of_whole_numbers_are_exact(rows, between, columns):
    a, b = integers(rows, between, 1), integers(between, columns, 2)
    np.testing.assert_array_equal(
        core.product(a, b), [[sum(x * y for x, y in zip(r, c, strict=True)) for c in b.T] for r in a]
    )


@pytest.mark.parametrize("size", [1, 2, 4, 5, 30, 43])
def test_systems_are_solved_for_what_made_them(size):
    a, x = integers(size, size, 3) + 0.5 * np.eye(size), integers(size, 3, 4)
    np.testing.assert_allclose(core.solve_dense(a, core.product(a, x)), x, rtol=0.0, atol=1e-10)


def test_a_pivot_that_is_zero_is_exchanged():
    np.testing.assert_allclose(
        core.solve_dense(np.array([[0.0, 2.0], [3.0, 1.0]]), np.array([[4.0], [5.0]])), [[1.0], [2.0]]
    )


def test_matrices_that_do_not_fit_are_refused():
    with pytest.raises(ValueError, match="as many columns"):
        core.product(np.ones((2, 3)), np.ones((2, 3)))
    with pytest.raises(ValueError, match="square"):
        core.solve_dense(np.ones((2, 3)), np.ones((2, 1)))
