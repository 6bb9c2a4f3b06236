"""What lies between the centres of cells, and cells without a body, where the gap is infinite."""

import math
import re
import warnings

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.patch.between import centres_of_parts, find_unseen_overlap
from nonhertz.patch.cascade import refine_pressure
from nonhertz.patch.grid import Grid, interpolation
from nonhertz.patch.nearness import scan

PLATES = nh.Contact(nh.Plate(), nh.Plate())
REGION = ((-0.8, 0.8), (-0.8, 0.8))
CELLS = (32, 32)
SIDE = 0.05  # of a cell


def ball(x, y):
    return (x**2 + y**2) / 20.0


def spike(x_at, y_at, height=0.01):
    """A ball with a spike that is gone half a cell away."""
    return lambda x, y: ball(x, y) - height * np.exp(-((x - x_at) ** 2 + (y - y_at) ** 2) / (0.25 * SIDE) ** 2)


def pin(x_at, y_at):
    """A ball, and beside it nothing but a pin that no centre of a cell lies upon."""

    def gap(x, y):
        beside = np.where(np.hypot(x - x_at, y - y_at) < 0.4 * SIDE, 0.0, math.inf)
        return np.where(np.hypot(x, y) < 0.4, ball(x, y), beside)

    return gap


def solve(gap, **given):
    return nh.patch.solve(PLATES, gap=gap, cells=CELLS, region=REGION, **{"load": 500.0, **given})


@pytest.mark.parametrize("nodes", [2, 4])
def test_interpolation_is_exact_for_polynomials(nodes):
    centres = 0.3 + 0.1 * np.arange(9)
    places = centres_of_parts(centres, 0.1)
    assert places.size == 36
    polynomial = np.polynomial.Polynomial([0.3, -2.0, 1.5, 4.0][:nodes])
    found = interpolation((places - centres[0]) / 0.1, 9, nodes) @ polynomial(centres)
    np.testing.assert_allclose(found, polynomial(places), rtol=1e-12, atol=0.0)


def test_a_pressure_is_linear_between_the_centres_of_a_coarser_grid():
    coarse = np.random.default_rng(1).uniform(1.0, 2.0, 5)
    centres, finer = ((np.arange(n) + 0.5) / n for n in (5, 15))
    expected = np.interp(finer, centres, coarse)[1:-1]
    for pressure in (np.tile(coarse, (4, 1)), np.tile(coarse, (4, 1)).T):
        found = refine_pressure(pressure, tuple(3 * n for n in pressure.shape))
        found = found if pressure.shape == (4, 5) else found.T
        np.testing.assert_allclose(found[:, 1:-1], np.tile(expected, (12, 1)), rtol=1e-12)


def test_there_is_nothing_between_the_cells_of_a_smooth_gap():
    solution = solve(ball)
    unseen = find_unseen_overlap(solution, ball)
    # A parabola is interpolated to rounding, and what touches is off by the tolerance.
    assert unseen.overlap < 1e-7 * solution.approach
    assert unseen.pressure < 1e-9 * solution.max_pressure
    assert solution.warnings == ()


# In contact, at the corner of four cells; and beside it.
@pytest.mark.parametrize("at", [(0.1, 0.15), (0.1 + 0.3 * SIDE, 0.15), (0.3, -0.3)])
def test_a_spike_between_centres_is_warned_of(at):
    gap = spike(*at)
    with warnings.catch_warnings(record=True, action="always") as caught:
        solution = solve(gap)
    assert re.match(r"The bodies overlap by 0.00\d* mm between cell centres, at x = ", str(caught[0].message))
    assert [str(warning.message) for warning in caught] == list(solution.warnings)
    unseen = find_unseen_overlap(solution, gap)
    # Parts of a cell lie at most an eighth of its side off the spike, which is down by a third there.
    np.testing.assert_allclose((unseen.x, unseen.y), at, rtol=0.0, atol=0.15 * SIDE)
    assert 0.2 < unseen.overlap / 0.01 < 1.1


def test_a_spike_beside_the_contact_overlaps_by_what_the_clearance_leaves_of_it():
    solution, at = solve(ball), (0.54375, 0.03125)  # the middle of a part of a cell
    unseen = find_unseen_overlap(
        solution, lambda x, y: ball(x, y) - 0.02 * np.exp(-((x - at[0]) ** 2 + (y - at[1]) ** 2) / 3e-6)
    )
    across, along = (np.maximum(1.0 - np.abs(axis) / SIDE, 0.0) for axis in (solution.x - at[0], solution.y - at[1]))
    assert (unseen.x, unseen.y) == pytest.approx(at)
    assert unseen.overlap == pytest.approx(0.02 - across @ solution.gap @ along, rel=1e-6)


def test_a_pin_between_centres_is_warned_of():
    gap = pin(0.6, 0.6)  # a corner of four cells
    with warnings.catch_warnings(record=True, action="always") as caught:
        solution = solve(gap, load=2000.0)
    assert re.match(r"The bodies overlap by 0.0\d* mm between cell centres, at x = ", str(caught[0].message))
    unseen = find_unseen_overlap(solution, gap)
    assert math.hypot(unseen.x - 0.6, unseen.y - 0.6) < 0.4 * SIDE
    # By less than the approach, since the surface is raised there, by about a force at that distance.
    raised = solution.contact.compliance * solution.load / math.hypot(unseen.x, unseen.y)
    np.testing.assert_allclose(unseen.overlap, solution.approach - raised, rtol=0.05, atol=0.0)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("wavelength", [0.6, 2.02])
def test_waves_shorter_than_cells_do_not_escape_the_estimate(wavelength):
    def gap(x, y):
        # In cells: aliases of longer waves, for which grids with half the cells change little.
        return ball(x, y) + 3e-4 * np.cos(2.0 * math.pi * (x / SIDE + 0.07) / wavelength) + 0.0 * y

    found = solve(gap)
    finer = nh.patch.solve(PLATES, gap=gap, cells=(8 * CELLS[0], CELLS[1]), region=REGION, load=500.0, tolerance=1e-4)
    assert abs(found.max_pressure / finer.max_pressure - 1.0) < found.error_estimate.max_pressure


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_a_pressure_without_a_limit_has_no_estimate():
    assert solve(lambda x, y: np.where(x < 0.6, ball(x, y), math.inf)).warnings == ()  # which it does not reach
    wall = solve(lambda x, y: np.where(x < 0.11, ball(x, y), math.inf))
    assert wall.error_estimate.max_pressure == math.inf
    assert wall.warnings[-1].startswith("The contact reaches the edge of a body at x = 0.075 mm, y = ")
    cut = nh.patch.solve(PLATES, gap=ball, cells=CELLS, region=((-0.8, 0.1), (-0.8, 0.8)), load=500.0)
    assert cut.error_estimate.max_pressure == math.inf
    lost = solve(ball, features=nh.patch.Dent(x=0.1, depth=0.01, diameter=0.2 * SIDE))
    assert lost.error_estimate.max_pressure == math.inf


def test_a_scan_covers_all_that_it_says():
    parts = list(scan(Grid((1.0, 2.0), (-3.0, 3.0), (128, 512), (-10.0, 200.0)), (40.0, 400.0)))
    # As fine as half a cell in twice the region, and s / 48 at a distance s from its middle.
    for x, y in ((1.03, 2.9), (2.4, -5.5), (30.0, 150.0), (-38.0, -9.9)):
        around = [part for part in parts if part.x[0] <= x <= part.x[-1] and part.y[0] <= y <= part.y[-1]]
        finest = min(max(float(np.diff(part.x).max()), float(np.diff(part.y).max())) for part in around)
        away = max(abs(x - 1.5), abs(y))
        assert finest <= max(0.5 * 6.0 / 512, away / 48.0)
    assert min(part.y[0] for part in parts) == -10.0
    assert max(part.y[-1] for part in parts) == 200.0
    assert max(part.x.size * part.y.size for part in parts) < 2**18


def test_a_small_bump_far_from_the_region_is_taken_in():
    # What is to touch of it is a tenth of a millimetre wide, and 4 mm off.
    def gap(x, y):
        return ball(x, y) - 1.2 * np.exp(-((x - 2.37) ** 2 + (y - 3.11) ** 2) / 0.0064)

    with pytest.warns(nh.AccuracyWarning, match="The mean pressure is"):
        found = nh.patch.solve(PLATES, gap=gap, load=500.0, cells=(128, 128))
    np.testing.assert_allclose((found.max_pressure_x, found.max_pressure_y), (2.37, 3.11), rtol=0.0, atol=0.08)


# Without a body: such cells bear nothing, and no moment counts on them


RUBBER = nh.Contact(nh.Body(material=nh.Material(5.0, 0.49)), nh.Plate())


def disc(radius, x_at=0.0, y_at=0.0):
    """A flat punch, with no body beside it."""
    return lambda x, y: np.where(np.hypot(x - x_at, y - y_at) <= radius, 0.0, math.inf)


def rail(x, y):
    """A cylinder of 10 mm radius that ends at y = -5 and y = 5."""
    return np.where(np.abs(y) < 5.0, x**2 / 20.0, math.inf) + 0.0 * x


def punch_load(contact, radius, approach):
    """Load of a rigid flat punch, 2 a E* delta; K = 1 / (pi E*)."""
    return 2.0 * radius * approach / (math.pi * contact.compliance)


def region(half):
    return ((-half, half), (-half, half))


def assert_nothing_without_a_body(solution, gap):
    bare = np.isinf(gap(solution.x[:, None], solution.y[None, :]))
    assert not solution.footprint[bare].any()
    np.testing.assert_array_equal(np.isinf(solution.gap), bare)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("where", [None, region(60.0)], ids=["found", "given"])
@pytest.mark.parametrize("given", [{"approach": 2.0}, {"load": 526.4}, {"approach": 2.0, "moment": 0.0}], ids=str)
def test_a_deep_rubber_punch_bears_on_its_face_alone(where, given):
    gap = disc(20.0)
    found = nh.patch.solve(RUBBER, gap=gap, cells=(90, 90), region=where, **given)
    assert_nothing_without_a_body(found, gap)
    # A circle of square cells, 30 across.
    np.testing.assert_allclose(found.load, punch_load(RUBBER, 20.0, found.approach), rtol=5e-3, atol=0.0)


@pytest.mark.parametrize("where", [None, ((-0.3, 0.3), (-10.0, 10.0))], ids=["found", "given"])
@pytest.mark.parametrize("arm", [7.5, -7.5])
def test_a_moment_beyond_the_cells_that_can_bear_is_refused(where, arm):
    with pytest.raises(
        nh.InputError, match=rf"moment / load = {arm} mm between -(4\.8\d+|5\.0\d*) and \1 mm"
    ) as caught:
        nh.patch.solve(PLATES, gap=rail, load=1e3, moment=1e3 * arm, cells=(32, 64), region=where)
    assert caught.value.field == "moment"
    assert caught.value.value == 1e3 * arm


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("arm", [0.0, 2.0, -4.0, 4.8])
def test_a_moment_within_their_reach_is_borne(arm):
    found = nh.patch.solve(
        PLATES, gap=rail, load=1e3, moment=1e3 * arm, cells=(32, 64), region=((-0.6, 0.6), (-10.0, 10.0))
    )
    assert_nothing_without_a_body(found, rail)
    np.testing.assert_allclose([found.load, found.moment], [1e3, 1e3 * arm], rtol=1e-8, atol=1e-5)


def test_the_sign_of_a_moment_by_approach_is_checked_against_the_cells_that_can_bear():
    def half(x, y):
        return np.where(y > 0.0, (x**2 + (y - 1.0) ** 2) / 20.0, math.inf)

    for where in (region(2.0), None):
        with pytest.raises(nh.InputError, match=r"moment = -5\.0 must have the sign of the lever arms, which"):
            nh.patch.solve(PLATES, gap=half, approach=0.001, moment=-5.0, cells=(32, 32), region=where)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("place", [(0.0, 0.0), (3.3, 4.7)])
@pytest.mark.parametrize("given", [{"load": 100.0}, {"approach": 0.002}, {"load": 100.0, "moment": 470.0}], ids=str)
def test_a_body_smaller_than_the_cells_of_the_search_is_found(place, given):
    if given.get("moment", 0.0) != 0.0 and place == (0.0, 0.0):
        given = {"load": 100.0, "moment": 5.0}  # further out the punch would lift off
    gap = disc(0.2, *place)
    found = nh.patch.solve(PLATES, gap=gap, cells=(64, 64), **given)
    assert_nothing_without_a_body(found, gap)
    approach = found.approach + found.tilt * place[1]
    # A circle of 50 cells or so across, its ragged edge counted in whole cells.
    np.testing.assert_allclose(found.load, punch_load(PLATES, 0.2, approach), rtol=2e-2, atol=0.0)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_coarse_levels_whose_centres_all_miss_a_body_are_left_out():
    # The pin is two fine cells wide, and lies between the centres of all coarser cells.
    found = nh.patch.solve(PLATES, gap=disc(0.2), load=100.0, cells=(64, 64), region=region(3.0))
    assert found.load == pytest.approx(100.0, rel=1e-9)
    assert found.footprint.sum() == 16


def test_a_grid_whose_centres_all_miss_the_body_is_refused():
    with pytest.raises(nh.InputError, match="gap = inf must be finite at the centre of at least one cell: give more"):
        nh.patch.solve(PLATES, gap=disc(0.02), load=100.0, cells=(16, 16), region=region(3.0))
