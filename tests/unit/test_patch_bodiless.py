"""Cells without a body, where the gap is infinite: they bear nothing, and no moment counts on them."""

import math

import numpy as np
import pytest

import nonhertz as nh

PLATES = nh.Contact(nh.Plate(), nh.Plate())
RUBBER = nh.Contact(nh.Body(material=nh.Material(5.0, 0.49)), nh.Plate())


def disc(radius, x_at=0.0, y_at=0.0):
    """A flat punch, with no body beside it."""
    return lambda x, y: np.where((x - x_at) ** 2 + (y - y_at) ** 2 <= radius**2, 0.0, math.inf)


def rail(x, y):
    """A cylinder of 10 mm radius that ends at y = -5 and y = 5."""
    return np.where(np.abs(y) < 5.0, x**2 / 20.0, math.inf) + 0.0 * x


def punch_load(contact, radius, approach):
    """Load of a rigid flat punch, 2 a E* delta; K = 1 / (pi E*)."""
    return 2.0 * radius * approach / (math.pi * contact.compliance)


def region(half):
    return ((-half, half), (-half, half))


def assert_nothing_without_a_body(solution, gap):
    assert not solution.footprint[~np.isfinite(gap(solution.x[:, None], solution.y[None, :]))].any()
    assert np.all(np.isinf(solution.gap) == ~np.isfinite(gap(solution.x[:, None], solution.y[None, :])))


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
    with pytest.raises(nh.InputError, match=rf"keep moment / load = {arm} mm between -(4\.8\d+|5\.0\d*) and") as caught:
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
    with pytest.raises(
        nh.InputError, match=r"moment = -5\.0 must have the sign of the lever arms, which lie between 0"
    ):
        nh.patch.solve(
            PLATES,
            gap=lambda x, y: np.where(y > 0.0, (x**2 + (y - 1.0) ** 2) / 20.0, math.inf),
            approach=0.001,
            moment=-5.0,
            cells=(32, 32),
            region=region(2.0),
        )


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
    with pytest.raises(
        nh.InputError, match="gap = inf must be finite at the centre of at least one cell: give more cells"
    ):
        nh.patch.solve(PLATES, gap=disc(0.02), load=100.0, cells=(16, 16), region=region(3.0))


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
@pytest.mark.slow
def test_whatever_the_shape_of_the_bodies_and_whatever_is_given(seed):
    # Holes and islands a few cells wide, whose coarse levels look quite different.
    generator = np.random.default_rng(seed)
    waves = generator.normal(0.0, 4.0, (4, 2))
    phases = generator.uniform(0.0, 6.0, 4)

    def gap(x, y):
        wave = sum(np.cos(a * x + b * y + phase) for (a, b), phase in zip(waves, phases, strict=True))
        return np.where(wave > 0.3, (x**2 + y**2) / 20.0, math.inf)

    prescribed = [
        {"load": 2e3},
        {"load": 2e3, "moment": 300.0},
        {"approach": 0.02},
        {"approach": 0.02, "moment": 300.0},
    ]
    for given in prescribed:
        found = nh.patch.solve(PLATES, gap=gap, cells=(40, 56), region=region(1.5), **given)
        assert_nothing_without_a_body(found, gap)
