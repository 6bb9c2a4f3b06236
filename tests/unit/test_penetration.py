"""The approach beyond first touch, by which the error of the approach is measured."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.result.penetration import deepest

HALF_SPACE = {"side_faces": "none", "depth": "none"}
LOGARITHMIC = nh.profile.logarithmic(amplitude=0.005, length=20, fraction=1.0)  # infinite at the ends
PROFILES = {
    "straight": nh.profile.straight(),
    "crown": nh.profile.crown(400),
    "logarithmic": LOGARITHMIC,
    "chamfer": nh.profile.chamfer(20, 1.0),
    "shifted crown": nh.profile.crown(400).shifted(3.1),
    "points": nh.profile.tabulated(
        [-10.0, -7.3, 2.1, 4.7, 10.0], [0.01, 0.0, 0.004, 0.0, 0.02], interpolation="linear"
    ),
}


def on_plate(profile, **options):
    return nh.Contact(nh.Roller(**({"diameter": 20, "length": 20, "profile": profile} | options)), nh.Plate())


class Lifted(nh.profile.Profile):
    """A crown that starts 0.182 mm away, like a wheel above its rail."""

    def relief(self, y):
        return 0.182 + np.asarray(y, dtype=float) ** 2 / 600.0


def test_between_places_it_is_that_of_a_parabola():
    # A crown whose drop is y^2 / (2 R), seen at three uneven places: at a tilt its summit is at y = tilt R.
    def separation(y):
        return y**2 / 800.0

    tilt = np.array([0.0, 2e-3, -3e-3])
    found = deepest(separation, np.array([-3.0, 0.5, 1.0, 4.0]), np.column_stack([[0.01, 0.02, 0.03], tilt]))
    np.testing.assert_allclose(found, [0.01, 0.02, 0.03] + 0.5 * 400.0 * tilt**2, rtol=1e-12, atol=0.0)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("tilt", [0.0, 2e-3, -7e-4])
def test_it_is_the_deepest_interference(name, tilt):
    contact = on_plate(PROFILES[name])
    solution = nh.solve(contact, load=5e3, tilt=tilt)
    y = np.linspace(solution.edges[0], solution.edges[-1], 400_001)
    dense = solution.approach + tilt * y - contact.separation(y)
    assert solution.penetration == pytest.approx(dense.max(), rel=1e-6)
    assert solution.penetration >= solution.interference.max()


def test_a_gap_before_touch_changes_neither_it_nor_the_estimated_error():
    plain = nh.solve(on_plate(nh.profile.crown(300), **HALF_SPACE), load=5e3)
    lifted = nh.solve(on_plate(Lifted(), **HALF_SPACE), load=5e3)
    # A circle and its parabola differ by 1e-5 here.
    assert lifted.approach == pytest.approx(0.182 + plain.approach, rel=1e-6)
    assert lifted.penetration == pytest.approx(plain.penetration, rel=1e-4)
    assert lifted.error_estimate.approach == pytest.approx(plain.error_estimate.approach, rel=0.05)


def test_a_moment_that_tilts_the_bodies_leaves_the_error_of_the_approach_finite():
    # At y = 0 the bodies move apart, and near some moment the approach there is zero.
    contact = on_plate(nh.profile.crown(400))
    for moment in (3e3, 8e3):
        solution = nh.solve(contact, load=2e3, moment=moment)
        assert solution.penetration > solution.approach
        assert solution.error_estimate.approach < 1e-3


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_batches_and_plane_grids_have_it():
    contact = on_plate(nh.profile.crown(400), **HALF_SPACE)
    solutions = nh.solve_many(contact, load=[2e3, 5e3], tilt=[1e-3, -2e-3])
    np.testing.assert_allclose(solutions.penetration, [each.penetration for each in solutions], rtol=1e-12, atol=0.0)
    patch = nh.patch.solve(contact, load=2e3, tilt=1e-3, cells=(32, 64))
    assert patch.penetration == pytest.approx(solutions.penetration[0], rel=2e-3)
    # First touch of the parabola y^2 / 800 is at y = 400 tilt.
    assert patch.approach - patch.penetration == pytest.approx(-400.0 * 1e-3**2 / 2.0, rel=1e-4)


def test_relative_error_of_the_plane_grid_does_not_depend_on_a_gap_before_touch():
    def error(lift):
        def gap(x, y):
            return lift + x**2 / 20.0 + y**2 / 800.0

        contact = on_plate(nh.profile.crown(400), **HALF_SPACE)
        solution = nh.patch.solve(contact, load=2e3, gap=gap, cells=(32, 32), region=((-0.3, 0.3), (-3.0, 3.0)))
        return solution.penetration, solution.error_estimate.approach

    assert error(0.2) == pytest.approx(error(0.0), rel=1e-4)
