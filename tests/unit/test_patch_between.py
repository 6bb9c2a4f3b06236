"""What lies between the centres of cells: said in words, and counted in the estimate of the error."""

import math
import warnings

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.patch.between import between, centres_of_parts
from nonhertz.patch.cascade import refined
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
        found = refined(pressure, tuple(3 * n for n in pressure.shape))
        found = found if pressure.shape == (4, 5) else found.T
        np.testing.assert_allclose(found[:, 1:-1], np.tile(expected, (12, 1)), rtol=1e-12)


def test_there_is_nothing_between_the_cells_of_a_smooth_gap():
    solution = solve(ball)
    unseen = between(solution, ball)
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
    assert str(caught[0].message).startswith("Between the centres of cells the bodies overlap, by 0.00")
    assert [str(warning.message) for warning in caught] == list(solution.warnings)
    unseen = between(solution, gap)
    # Parts of a cell lie at most an eighth of its side off the spike, which is down by a third there.
    np.testing.assert_allclose((unseen.x, unseen.y), at, rtol=0.0, atol=0.15 * SIDE)
    assert 0.2 < unseen.overlap / 0.01 < 1.1


def test_a_spike_beside_the_contact_overlaps_by_what_the_clearance_leaves_of_it():
    solution, at = solve(ball), (0.54375, 0.03125)  # the middle of a part of a cell
    unseen = between(solution, lambda x, y: ball(x, y) - 0.02 * np.exp(-((x - at[0]) ** 2 + (y - at[1]) ** 2) / 3e-6))
    across, along = (np.maximum(1.0 - np.abs(axis) / SIDE, 0.0) for axis in (solution.x - at[0], solution.y - at[1]))
    assert (unseen.x, unseen.y) == pytest.approx(at)
    assert unseen.overlap == pytest.approx(0.02 - across @ solution.gap @ along, rel=1e-6)


def test_a_pin_between_centres_is_warned_of():
    gap = pin(0.6, 0.6)  # a corner of four cells
    with warnings.catch_warnings(record=True, action="always") as caught:
        solution = solve(gap, load=2000.0)
    assert str(caught[0].message).startswith("Between the centres of cells the bodies overlap, by 0.0")
    unseen = between(solution, gap)
    assert math.hypot(unseen.x - 0.6, unseen.y - 0.6) < 0.4 * SIDE
    # By less than the approach, since the surface is raised there, by about a force at that distance.
    raised = solution.contact.compliance * solution.load / math.hypot(unseen.x, unseen.y)
    np.testing.assert_allclose(unseen.overlap, solution.approach - raised, rtol=0.05, atol=0.0)


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.parametrize("wavelength", [0.6, 1.3, 2.02])
def test_waves_shorter_than_cells_do_not_escape_the_estimate(wavelength):
    def gap(x, y):
        # In cells: aliases of longer waves, for which grids with half the cells change little.
        return ball(x, y) + 3e-4 * np.cos(2.0 * math.pi * (x / SIDE + 0.07) / wavelength) + 0.0 * y

    found = solve(gap)
    finer = nh.patch.solve(PLATES, gap=gap, cells=(8 * CELLS[0], CELLS[1]), region=REGION, load=500.0, tolerance=1e-4)
    assert abs(found.max_pressure / finer.max_pressure - 1.0) < found.error_estimate.max_pressure


@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_a_pressure_without_a_limit_has_no_estimate():
    wall = solve(lambda x, y: np.where(x < 0.11, ball(x, y), math.inf))
    assert wall.error_estimate.max_pressure == math.inf
    assert wall.warnings[-1].startswith("The contact reaches the edge of a body at x = 0.075 mm, y = ")
    cut = nh.patch.solve(PLATES, gap=ball, cells=CELLS, region=((-0.8, 0.1), (-0.8, 0.8)), load=500.0)
    assert cut.error_estimate.max_pressure == math.inf
    lost = solve(ball, features=nh.patch.Dent(x=0.1, depth=0.01, diameter=0.2 * SIDE))
    assert lost.error_estimate.max_pressure == math.inf


def test_a_wall_that_the_contact_does_not_reach_changes_nothing():
    assert solve(lambda x, y: np.where(x < 0.6, ball(x, y), math.inf)).warnings == ()


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
