"""Stress and displacement below a plane grid, against point loads and Love's sums over all corners."""

import numpy as np
import pytest

from nonhertz.patch.kernel import rectangles
from nonhertz.subsurface.rectangles import ERROR, LADDER, Rectangles, rule_ellipses

ONE = np.zeros(1)


def centres(count, side):
    return side * (np.arange(count) - 0.5 * (count - 1))


def edges(centre, side):
    return np.append(centre - 0.5 * side, centre[-1] + 0.5 * side)


def corner(X, Y, z, nu):
    """2 pi times the stresses of a corner, as the textbooks have them."""
    r = np.sqrt(X**2 + Y**2 + z**2)
    V_z = -np.arctan2(X * Y, z * r)
    V_xx, V_yy = -X * Y / (r * (X**2 + z**2)), -X * Y / (r * (Y**2 + z**2))
    chi_xx, chi_yy = np.arctan2(X * Y, X**2 + z**2 + z * r), np.arctan2(X * Y, Y**2 + z**2 + z * r)
    return np.array(
        [
            2 * nu * V_z - z * V_xx - (1 - 2 * nu) * chi_xx,
            2 * nu * V_z - z * V_yy - (1 - 2 * nu) * chi_yy,
            V_z + z * (V_xx + V_yy),
            -(z**2) * X / (r * (Y**2 + z**2)),
            -(z**2) * Y / (r * (X**2 + z**2)),
            -z / r - (1 - 2 * nu) * np.log(z + r),
        ]
    )


def love(x, y, dx, dy, pressure, points, nu):
    """Every corner of every cell."""
    weight = np.diff(np.diff(np.pad(pressure, 1), axis=0), axis=1)
    X, Y = np.meshgrid(edges(x, dx), edges(y, dy), indexing="ij")
    return np.array([(weight * corner(X - px, Y - py, pz, nu)).sum(axis=(1, 2)) for px, py, pz in points]) / (2 * np.pi)


def point_load(x, y, z, nu):
    """Boussinesq's stresses and G times displacements for a unit load at the origin."""
    r = np.sqrt(x**2 + y**2 + z**2)
    far, lateral = 1 / (r * (r + z)), (1 - 2 * nu) / (2 * np.pi)
    bend = (2 * r + z) / (r**3 * (r + z) ** 2)
    stress = [
        lateral * (z / r**3 - far + x**2 * bend) - 3 * z * x**2 / (2 * np.pi * r**5),
        lateral * (z / r**3 - far + y**2 * bend) - 3 * z * y**2 / (2 * np.pi * r**5),
        *(-3 * z**2 * s / (2 * np.pi * r**5) for s in (z, y, x)),
        lateral * x * y * bend - 3 * x * y * z / (2 * np.pi * r**5),
    ]
    across = z / r**3 - (1 - 2 * nu) * far
    return stress, [x * across / (4 * np.pi), y * across / (4 * np.pi), (2 * (1 - nu) / r + z**2 / r**3) / (4 * np.pi)]


@pytest.fixture(scope="module", params=["7x9", "60x40", "with a hole"])
def grid(request):
    draw = np.random.default_rng(3)
    nx, ny = (7, 9) if request.param == "7x9" else (60, 40)
    pressure = draw.uniform(0.0, 100.0, (nx, ny))
    if request.param == "with a hole":
        pressure[:9] = pressure[:, -6:] = pressure[20:40, 10:25] = pressure[:, 28:31] = 0.0
    x, y = 0.2 + centres(nx, 0.7 / nx), -0.3 + centres(ny, 0.03)
    return x, y, 0.7 / nx, 0.03, pressure


@pytest.fixture(scope="module")
def points():
    """Between a thousandth of the contact's width and ten widths deep, under it, beside it and on the surface."""
    draw = np.random.default_rng(4)
    depth = np.append(10.0 ** draw.uniform(-3.5, 0.8, 60), np.zeros(20))
    wide = np.where(np.arange(80) % 4 == 0, 6.0, 1.0)
    return np.column_stack([0.2 + wide * draw.uniform(-0.5, 0.5, 80), -0.3 + wide * draw.uniform(-0.8, 0.8, 80), depth])


@pytest.mark.parametrize(
    ("depth", "lateral", "normal"),
    [
        (0.1, -0.556117, -0.994294),
        (0.4, -0.134495, -0.799721),
        (0.7, -0.019815, -0.522012),
        (1.0, 0.003973, -0.336108),
        (5.0, 0.001325, -0.018785),
    ],
)
def test_on_the_axis_of_a_unit_square(depth, lateral, normal):
    # Six figures as printed; CONTACT's example of a square has the same to its four.
    (found,) = Rectangles.of(ONE, ONE, 1.0, 1.0, np.ones((1, 1))).stress(np.array([[0.0, 0.0, depth]]), 0.28)
    np.testing.assert_allclose(found, [lateral, lateral, normal, 0.0, 0.0, 0.0], rtol=0.0, atol=6e-7)


@pytest.mark.parametrize("point", [(0.9, -0.3, 0.4), (-1.3, 2.0, 0.01), (0.1, 0.2, 0.6)], ids=str)
def test_one_cell_is_the_integral_of_point_loads(point):
    cell = Rectangles.of(ONE, ONE, 1.0, 1.6, np.ones((1, 1)))
    found = np.concatenate([cell.stress(np.array([point]), 0.3)[0], cell.displacement(np.array([point]), 0.3)[0]])
    # Gauss-Legendre in 60 x 60 points of the cell is exact here, so a tenth of what the module promises has to do.
    at, weight = np.polynomial.legendre.leggauss(60)
    x, y = np.meshgrid(0.5 * at, 0.8 * at, indexing="ij")
    stress, displacement = point_load(point[0] - x, point[1] - y, point[2], 0.3)
    expected = [0.4 * weight @ component @ weight for component in (*stress, *displacement)]
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=1e-7)


def test_stress_is_the_sum_over_all_corners(grid, points):
    found = Rectangles.of(*grid).stress(points, 0.3)
    # What the module promises, of the maximum pressure.
    np.testing.assert_allclose(found, love(*grid, points, 0.3), rtol=0.0, atol=1e-6 * grid[-1].max())


def test_displacement_of_the_surface(grid, points):
    x, y, dx, dy, pressure = grid
    on_surface = points[-20:]
    found = Rectangles.of(*grid).displacement(on_surface, 0.3)[:, 2]
    expected = [(pressure * rectangles(edges(x, dx) - px, edges(y, dy) - py)).sum() for px, py, _ in on_surface]
    # The half-width is 0.35 mm, and again a millionth of the maximum pressure.
    np.testing.assert_allclose(found, 0.7 / (2 * np.pi) * np.array(expected), rtol=0.0, atol=0.35e-6 * pressure.max())


def test_finite_on_edges_and_corners_of_the_surface(grid):
    x, y, dx, dy, pressure = grid
    along_x, along_y = np.sort(np.append(x, edges(x, dx)))[::7], np.sort(np.append(y, edges(y, dy)))[::7]
    at = np.stack([*np.meshgrid(along_x, along_y, indexing="ij")], axis=-1).reshape(-1, 2)
    load = Rectangles.of(*grid)
    for depth in (0.0, -0.0, 1e-200):
        surface = np.column_stack([at, np.full(len(at), depth)])
        assert np.isfinite(load.displacement(surface, 0.3)).all()
        # The logarithm at a corner, twelve decades below a cell's side.
        assert np.abs(load.stress(surface, 0.3)).max() < 10.0 * pressure.max()


def test_beyond_its_ellipse_a_rule_errs_by_what_is_allowed():
    for points, (long, short) in zip(LADDER, rule_ellipses(), strict=True):
        # Foci at the ends of a panel of half-length 1, and rows that add exp(-n eta) / sinh(eta).
        assert long - short == pytest.approx(1.0, rel=1e-12)
        eta = np.arcsinh(np.sqrt(short))
        assert np.exp(-points * eta) == pytest.approx(ERROR * np.sinh(eta), rel=1e-9)
