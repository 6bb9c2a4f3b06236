"""Corners that a trace holds: land and corner are prepared apart, and contacts end within the corner."""

import math
import warnings

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
from nonhertz.errors import InputError
from nonhertz.measured import Points, Trace, prepare
from nonhertz.model.corner import Chamfer, Corner, Cornered, Rounded

HALF, RADIUS, NOISE = 10.0, 0.5, 5e-5
NOMINAL = Rounded(RADIUS)
LAND = {"straight": nh.profile.straight(), "logarithmic": nh.profile.logarithmic(amplitude=0.004, length=20.0)}
MINUTES, LOAD = math.radians(2.0 / 60.0), 30e3


def trace(
    land: nh.profile.Profile = LAND["straight"],
    corner: Corner = NOMINAL,
    step: float = 2e-3,
    noise: float = NOISE,
    seed: int = 1,
    ends: tuple[float, float] = (-9.92, 9.92),
) -> Trace:
    """Return a roller of 20 mm in the machine: tilted by 2 mrad, 3.1 mm off, and as far as the stylus went."""
    y = np.arange(round(ends[0] / step), round(ends[1] / step) + 1) * step
    height = -Cornered(land, HALF, corner).relief_at(y) + 2e-3 * y - 0.3
    return Trace(y + 3.1, height + noise * np.random.default_rng(seed).standard_normal(len(y)))


def solved(profile: nh.profile.Profile, accuracy: float | None = None, **corner: object) -> nh.Solution:
    roller = nh.Roller(diameter=15, length=2.0 * HALF, profile=profile, **corner)  # type: ignore[arg-type]
    return nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=LOAD, tilt=MINUTES, accuracy=accuracy)


@pytest.mark.parametrize("land", LAND)
@pytest.mark.parametrize("step", [2e-3, *(pytest.param(step, marks=pytest.mark.slow) for step in (1e-3, 5e-3, 1e-2))])
def test_the_contact_is_that_of_the_nominal_corner(land, step):
    """Noise of 0.05 um left in a corner as waves of its cutoff takes pi E* A / l = 1 to 2 % of the pressure there."""
    nominal = solved(LAND[land], corner_radius=RADIUS)
    for seed in (1, 2):
        measured = prepare(trace(LAND[land], step=step, seed=seed))
        solution = solved(measured.profile())
        assert_allclose(solution.max_pressure, nominal.max_pressure, rtol=0.02)
        assert_allclose(solution.max_pressure_y, nominal.max_pressure_y, atol=0.01)
        assert solution.singular_ends == ()
    # The pressure that the corner has is missing where the trace is cut at the land.
    assert (
        solved(prepare(trace(LAND[land], step=step), corner="cut").profile()).max_pressure < 0.6 * nominal.max_pressure
    )


@pytest.mark.parametrize(
    ("corner", "rtol"),
    [(Rounded(0.2), 0.03), (Rounded(1.5), 0.02), (Chamfer(0.6, 0.3, 0.3), 0.02), (Chamfer(0.6, 0.3, 0.1), 0.08)],
    ids=["small", "large", "blended chamfer", "blend below the cutoff"],
)
def test_other_corners_keep_their_pressure(corner, rtol):
    """An arc of 30 um is shorter than the cutoff of 80 um: the filter makes it larger and the pressure lower."""
    nominal = solved(Cornered(LAND["straight"], HALF, corner))
    solution = solved(prepare(trace(corner=corner)).profile())
    assert_allclose(solution.max_pressure, nominal.max_pressure, rtol=rtol)
    assert_allclose(solution.max_pressure_y, nominal.max_pressure_y, atol=0.02)


@pytest.mark.slow
def test_the_noise_of_a_corner_does_not_make_the_pressure():
    pressures = [solved(prepare(trace(step=1e-3, seed=seed)).profile()).max_pressure for seed in range(5)]
    traces = (prepare(trace(step=1e-3, seed=seed), smooth=False, points=2001) for seed in range(2))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)  # noise is resolved by strips of its own step alone
        rough = [solved(each.profile(), 1e-5).max_pressure for each in traces]
    assert np.ptp(pressures) < 0.02 * np.mean(pressures)
    assert np.mean(rough) > 1.02 * max(pressures)


def test_the_corner_does_not_bend_the_land():
    """Level and land are those of the trace whose corners are cut, but for the last half millimetre."""
    kept, cut = prepare(trace()), prepare(trace(), corner="cut")
    assert kept.states[1].numbers == cut.states[1].numbers
    y = np.linspace(-9.0, 9.0, 181)
    # Near the ends the cut line has no points of its corner to its outside, but some of it inside: a tenth of a um.
    assert_allclose(kept.profile().relief(y) - cut.profile().relief(y), 0.0, atol=2e-5)


def test_land_and_corner_join_without_a_step():
    measured = prepare(trace(), points=False)
    height, step = measured.points.height, float(np.diff(measured.points.y)[0])
    joint = np.searchsorted(measured.points.y, measured.points.land[1])
    # The radius drops by x^2 / 2R, 4 nm, in a step of 2 um; the noise of 50 nm would be ten times as much.
    assert np.abs(np.diff(height[joint - 5 : joint + 5])).max() < 5.0 * 5.0 * step**2 / RADIUS
    assert_allclose(measured.points.land, [-9.5, 9.5], atol=0.015)


def test_a_corner_is_told_and_the_body_ends_with_the_trace():
    measured = prepare(trace())
    state = measured.states[3]
    assert state.words.startswith("Land from -9.49")
    assert "corners kept: low end 0.43 mm wide" in state.words
    # The circle is 0.229 mm deep 0.42 mm from where it begins.
    assert_allclose([state.numbers["depth_low"], state.numbers["depth_high"]], 0.229, atol=2e-3)
    assert measured.profile().extent == (measured.points.y[0], measured.points.y[-1])
    assert nh.Roller(diameter=15, length=20, profile=measured.profile()).interval == measured.profile().extent


@pytest.mark.parametrize(("ends", "name"), [((-9.92, 9.3), "low"), ((-9.3, 9.92), "high")])
def test_one_corner_is_kept_where_the_trace_holds_one(ends, name):
    measured = prepare(trace(ends=ends))
    words = measured.states[3].words
    assert f"corner kept: {name} end" in words
    assert [bool(np.any(corner)) for corner in measured.points.beyond_land] == [name == "low", name == "high"]


def test_a_trace_without_corners_is_prepared_as_before():
    """With nothing to keep, both choices are one."""
    land = nh.profile.crown(radius=1000.0)
    kept, cut = (prepare(trace(land, ends=(-9.3, 9.3)), corner=corner) for corner in ("keep", "cut"))
    assert [state.words for state in kept.states] == [state.words for state in cut.states]
    assert_array_equal(kept.relief, cut.relief)
    assert kept.profile().joints is None
    for options in ({"trim": 18.0}, {"trim": False}):
        kept, cut = (prepare(trace(), corner=corner, **options) for corner in ("keep", "cut"))
        assert_array_equal(kept.relief, cut.relief)


def test_a_coarse_corner_is_kept_and_warned_of():
    measured = prepare(trace(step=0.1, ends=(-9.8, 9.8)))
    told = [sentence for sentence in measured.warnings if "has only" in sentence]
    assert len(told) == 2
    assert "too few to be smoothed" in told[0]
    assert measured.interpolation == "pchip"
    # Nothing is made of the points that was not measured.
    smoothed, before = measured.states[-1].points, measured.states[4].points
    high = before.beyond_land[1]
    assert_array_equal(np.interp(before.y[high], smoothed.y, smoothed.height), before.height[high])


def test_what_rises_again_is_no_corner():
    """A rib beyond an undercut, or what the body lies on."""
    y = np.arange(0.0, 12.0, 2e-3)
    height = -(np.maximum(y - 10.0, 0.0) ** 2) / (2.0 * RADIUS)
    rib = np.where(y > 10.4, height + 3.0 * (y - 10.4), height)
    assert_allclose(prepare(Trace(y, rib), align=False).points.y[-1], 10.5, atol=0.2)
    flat = np.maximum(height, -0.1)
    assert_allclose(prepare(Trace(y, flat), align=False).points.y[-1], 10.0 + math.sqrt(0.1), atol=0.05)
    up = np.where(y > 10.0, 0.5 * (y - 10.0), 0.0)
    assert prepare(Trace(y, up), align=False).points.land is None


def test_dust_in_a_corner_goes():
    dirty = trace(noise=NOISE)
    height = dirty.height.copy()
    height[[-60, 70]] += 0.01
    measured = prepare(Trace(dirty.y, height))
    assert measured.states[4].numbers["removed"] == 2
    assert_allclose(measured.relief, prepare(dirty).relief, atol=1e-4)


def test_two_corners_at_one_end_are_refused():
    profile = prepare(trace()).profile()
    sentence = (
        r"corner_radius = 0.5 must not be given with a profile that holds the corners, beyond y = -9.\d+ and 9.\d+ mm"
    )
    for each in (profile, profile.shifted(0.01), profile.scaled(2.0), profile + nh.profile.crown(radius=1e4)):
        with pytest.raises(InputError, match=sentence):
            nh.Roller(diameter=15, length=20, profile=each, corner_radius=RADIUS)
    with pytest.raises(InputError, match="chamfer"):
        nh.Roller(diameter=15, length=20, profile=profile, chamfer=Chamfer(0.5, 0.3))
    cut = prepare(trace(), corner="cut").profile()
    assert_allclose(
        solved(cut, corner_radius=RADIUS).max_pressure,
        solved(LAND["straight"], corner_radius=RADIUS).max_pressure,
        rtol=0.02,
    )


def test_points_know_their_land():
    y = np.linspace(0.0, 1.0, 11)
    points = Points(y, np.zeros(11), land=(0.15, 0.85))
    assert_allclose(points.on_land.y, y[2:9])
    assert points.on_land.land is None
    assert [int(np.sum(corner)) for corner in points.beyond_land] == [2, 2]
    with pytest.raises(InputError, match="land"):
        Points(y, np.zeros(11), land=(0.8, 0.2))


def test_corner_is_kept_or_cut():
    with pytest.raises(InputError, match="corner = 'round' must be one of 'keep', 'cut'"):
        prepare(trace(), corner="round")  # type: ignore[arg-type]
