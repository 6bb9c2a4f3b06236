"""Levels of grids, and the error that their changes estimate."""

import numpy as np
import pytest
from core_pieces import state_of, strips_between

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.prescription import Prescription
from nonhertz.native import core
from nonhertz.result.outcome import outcome
from nonhertz.solver.one import problem_of
from nonhertz.strip.model import model_of


@pytest.mark.parametrize(
    "pressure",
    [
        (0.5, 0.9, 1.0, 0.9, 0.5),
        (0.5, 0.99, 0.97, 1.0, 0.98, 0.9, 0.5),
        (0.5, 0.8, 0.6, 1.0, 0.99, 0.995, 0.5),
        (0.2, 0.995, 0.2, 0.994, 0.3, 0.1, 0.0),
    ],
)
def test_peaks_are_looked_for_alike_on_both_sides(pressure):
    """A strip on y = 0 belongs to both."""
    found, mirrored = peaks(pressure), peaks(pressure[::-1])
    np.testing.assert_array_equal(found[:, 0], -mirrored[::-1, 0])
    np.testing.assert_array_equal(found[:, 1:], mirrored[::-1, 1:])
    assert found.size


@pytest.mark.parametrize("rounding", [0.0, 1e-15, -1e-15])
def test_a_strip_beside_the_middle_belongs_to_its_side_alone(rounding):
    """Of two strips that bear the same, an ulp decided otherwise which was the maximum pressure on both sides."""
    for more in ((0.0, 1e-15), (1e-15, 0.0)):
        found = peaks((0.5, 0.9, 1.0 + more[0], 1.0 + more[1], 0.9, 0.5), middle=rounding)
        np.testing.assert_allclose(found[:, 0], [-1.0, 1.0], rtol=1e-12)


def peaks(pressure, middle=0.0):
    """Peaks of a pressure on strips 2 mm wide around the middle."""
    m, n = np.square(pressure), len(pressure)
    grid = strips_between(np.linspace(-n, n, n + 1) + middle)
    return np.array(core.peaks(grid, state_of(np.ones(n), m, (0.0, 0.0)), np.zeros(0), 1e-4))


@pytest.mark.filterwarnings("ignore:.*maximum pressure is not known")
def test_a_single_strip_has_no_estimate():
    with pytest.warns(nh.AccuracyWarning, match="error of the approach is not known"):
        solution = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate()), load=1e3, strips=1)
    assert solution.error_estimate.approach == np.inf
    assert solution.error_estimate.load == 0.0


def test_a_grid_can_be_given_to_another_solve():
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000)), nh.Plate())
    first = nh.solve(contact, load=5e3)
    second = nh.solve(contact, load=5e3, strips=first.edges)
    assert np.array_equal(second.edges, first.edges)
    np.testing.assert_allclose(second.approach, first.approach, rtol=1e-11, atol=0.0)


@pytest.mark.parametrize(("strips", "way_out"), [(399, "another number"), (1600, "fewer strips")])
def test_where_very_many_strips_fail_fewer_are_the_way_out(strips, way_out):
    contact = nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate())
    problem = problem_of(contact, Prescription(load=1e3), nh.SEMI_ELLIPTIC, strips)
    failed = np.linspace(-10.0, 10.0, strips + 1), state_of(np.zeros(strips), np.zeros(strips), (0.0, 0.0))
    result = core.restored(problem.model.in_core, problem.by_force, problem.target, [failed], 0.0, accepted=False)
    with pytest.raises(nh.ConvergenceError, match=way_out):
        outcome(problem, result)


@pytest.mark.parametrize("times", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("load", [1e-8, 1e3])
def test_bodies_without_ends_are_looked_at_as_far_as_the_contact_calls_for(times, load):
    # From half-widths of 1e-6 of the radius to 0.01: neither lost in the net of places nor in one of its meshes.
    crown = nh.profile.crown(50 * times)
    contact = nh.Contact(nh.Ring(diameter=100 * times, profile=crown), nh.Plate())
    with without_accuracy_warnings():
        exact = nh.hertz.point_contact(
            load=load * times**2, radius_x=50 * times, radius_y=50 * times, compliance=contact.compliance
        )
    low, high = core.bound_contact(model_of(contact), (False, False), (exact.approach, 0.0))
    assert low < -exact.half_length
    assert high > exact.half_length
    assert high - low < 20.0 * exact.half_length


@pytest.mark.slow
def test_the_maximum_at_a_small_rounding_is_found_to_ten_times_the_accuracy():
    # The contact runs out on a rounding of 5 mm radius, 1 mm long, where the pressure has a narrow peak.
    y = np.linspace(-10.0, 10.0, 401)
    rounding = np.maximum(np.abs(y) - 9.0, 0.0) ** 2 / (2.0 * 5.0)
    profile = nh.profile.crown(radius=4000) + nh.profile.tabulated(y, rounding)
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=profile, side_faces="mirror"), nh.Plate())
    fine = nh.solve(contact, load=20e3, tilt=0.5e-3, accuracy=1e-6)
    found = nh.solve(contact, load=20e3, tilt=0.5e-3)
    np.testing.assert_allclose(found.max_pressure, fine.max_pressure, rtol=10.0 * core.ACCURACY, atol=0.0)
    assert found.strips < 200
