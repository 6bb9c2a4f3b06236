"""Love's rectangle against the corner formula in fifty digits."""

import itertools

import mpmath
import numpy as np
import pytest

from nonhertz.patch.kernel import edges_from, rectangles


def exact(x, y, dx, dy):
    """The textbook's corners, which fifty digits can afford."""
    with mpmath.workdps(50):
        total = mpmath.mpf(0)
        for i, j in itertools.product((-1, 1), repeat=2):
            a, b = mpmath.mpf(x) + i * mpmath.mpf(dx) / 2, mpmath.mpf(y) + j * mpmath.mpf(dy) / 2
            corner = (a * mpmath.asinh(b / abs(a)) if a else 0) + (b * mpmath.asinh(a / abs(b)) if b else 0)
            total += i * j * corner
        return total


def found(x, y, dx, dy):
    return float(rectangles(edges_from(x, 1, dx), edges_from(y, 1, dy))[0, 0])


@pytest.mark.parametrize("sides", [(1.0, 1.0), (1.0, 17.0), (100.0, 1.0), (0.001, 0.02)], ids=str)
def test_within_1e_12_up_to_a_thousand_sides_away(sides):
    # Steps of whole cells, and of fractions, as images are seen, to either side.
    steps = (-300.0, -2.3, -0.5, 0.0, 0.5, 1.0, 2.3, 30.0, 300.0, 1000.0)
    for i, j in itertools.product(steps, steps):
        x, y = i * sides[0], j * sides[1]
        with mpmath.workdps(50):
            error = abs(mpmath.mpf(found(x, y, *sides)) / exact(x, y, *sides) - 1)
        # What the kernel promises: a thousand cells away times the last digit, and as much again.
        assert error < 1e-12, (x, y)


def test_cells_add_up_to_the_cell_that_they_make_up():
    whole = found(0.3, -0.2, 2.0, 3.0)
    x, y = np.linspace(-0.7, 1.3, 21), np.linspace(-1.7, 1.3, 31)
    np.testing.assert_allclose(rectangles(x, y).sum(), whole, rtol=1e-13, atol=0.0)  # rounding of 600 terms
