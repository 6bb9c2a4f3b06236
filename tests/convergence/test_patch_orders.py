"""How errors fall with the cells, and how the work grows with them."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.hertz import point_contact

pytestmark = pytest.mark.slow

BODIES = nh.Contact(nh.Body(diameter=20), nh.Plate())
HALF_SPACE = {"side_faces": "none", "depth": "none"}
LOGARITHMIC = nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
TILTED = nh.Contact(nh.Roller(diameter=20, length=20, profile=LOGARITHMIC, **HALF_SPACE), nh.Plate())


def on_ellipse(cells):
    return nh.patch.solve(BODIES, load=1000.0, gap=lambda x, y: x**2 / 20.0 + y**2 / 200.0, cells=cells)


def test_approach_on_an_ellipse_converges_faster_than_first_order():
    exact = point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=BODIES.compliance).approach
    numbers = np.array([16, 24, 32, 48, 64, 96, 128])
    errors = [abs(on_ellipse((n, n)).approach / exact - 1.0) for n in numbers]
    order = -np.polyfit(np.log(numbers), np.log(errors), 1)[0]
    # Single errors scatter, for the footprint's edge lies here or there in its cells.
    assert 1.4 < order < 2.6


def test_the_estimate_covers_the_error():
    exact = point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=BODIES.compliance)
    for n in (16, 24, 32, 48, 64, 96, 128):
        found = on_ellipse((n, n))
        assert abs(found.approach / exact.approach - 1.0) < found.error_estimate.approach
        assert abs(found.max_pressure / exact.max_pressure - 1.0) < found.error_estimate.max_pressure


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")  # of few cells
def test_a_direction_that_was_never_refined_has_no_estimate():
    for cells in ((4, 256), (256, 7)):
        assert on_ellipse(cells).error_estimate.approach == np.inf


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")  # of few cells
@pytest.mark.parametrize("tilt", [0.0, 5e-4])
def test_convolutions_hardly_grow_with_the_cells(tilt):
    # What makes the work that of n log n; the numbers that belong to it are in docs/explain/patch-table.md.
    counts = [nh.patch.solve(TILTED, load=20e3, tilt=tilt, cells=(n, n)).iterations for n in (32, 64, 128, 256)]
    assert max(counts) <= 40
    assert counts[-1] <= counts[0] + 16


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")  # of few cells
def test_the_solution_depends_on_the_tolerance_as_promised():
    tight = nh.patch.solve(TILTED, load=20e3, tilt=5e-4, cells=(64, 128), tolerance=1e-12)
    for tolerance in (1e-4, 1e-6, 1e-8):
        found = nh.patch.solve(TILTED, load=20e3, tilt=5e-4, cells=(64, 128), tolerance=tolerance)
        assert found.residual <= tolerance
        # The approach is one of the displacements that the residual is relative to.
        assert abs(found.approach / tight.approach - 1.0) < tolerance
