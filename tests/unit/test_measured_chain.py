"""A measured profile as a whole: truth comes back, steps can be undone, roughness is told and warned of."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
from nonhertz.errors import InputError
from nonhertz.measured import Measured, Trace, prepare
from nonhertz.measured.roughness import STEEL_COMPLIANCE, roughness_in, short_wave_slope
from nonhertz.measured.trace import Points, holes

RADIUS, NOISE, SEED = 1500.0, 2e-4, 7


def rough_roller() -> Trace:
    """Return a crown of 11 mm with chamfers, tilted by 6 mrad, 7 mm off, rough by 0.2 um, with three grains of dust."""
    y = np.linspace(-6.0, 6.0, 6001)
    height = -(y**2) / (2.0 * RADIUS) - np.maximum(np.abs(y) - 5.5, 0.0)
    height += NOISE * np.random.default_rng(SEED).standard_normal(len(y))
    height[[1000, 3000, 5000]] += 0.01
    return Trace(y + 7.0, height + 6e-3 * y, name="roller")


@pytest.fixture(scope="module")
def measured():
    return prepare(rough_roller())


def test_a_crown_comes_back_out_of_tilt_noise_chamfers_and_dust(measured):
    """Its curvature c = 1/R is that of a least-squares parabola, of which n points of noise s on a length L leave

    a standard deviation of s sqrt(720 / n) / L^2 in c (the variance of the third Legendre coefficient).
    """
    found = measured.fit("crown")
    points, length = 5500, 11.0
    sigma = NOISE * math.sqrt(720.0 / points) / length**2
    assert_allclose(1.0 / found.parameters["radius"], 1.0 / RADIUS, atol=4.0 * sigma)
    # The dust is gone and the profile's own drop is that of the crown: at its end, 11 mm less a chord at either side,
    # within three standard deviations of a mean over the filter's width, 150 um of points 2 um apart.
    profile = measured.profile()
    end = float(measured.points.on_land.y[-1])
    assert_allclose(profile.relief(end), end**2 / (2.0 * RADIUS), atol=3.0 * NOISE / math.sqrt(75.0) * 2.0)
    assert measured.states[4].numbers["removed"] == 3


def test_the_standard_error_of_a_fit_is_honest():
    """Over forty rollers the radius scatters as the fits say of themselves."""
    y = np.linspace(-5.5, 5.5, 1101)
    rng = np.random.default_rng(SEED)
    fits = [
        Measured(Trace(y, -(y**2) / (2.0 * RADIUS) + NOISE * rng.standard_normal(len(y)))).fit("crown")
        for _ in range(40)
    ]
    radii = np.array([each.parameters["radius"] for each in fits])
    told = np.array([each.standard_errors["radius"] for each in fits])
    # A standard deviation of forty is good to 11 %; three of them.
    assert_allclose(np.median(told), radii.std(ddof=1), rtol=0.35)


def test_steps_are_undone_one_by_one(measured):
    names = [step.name for step in measured.steps]
    assert names == ["level", "align", "trim", "outliers", "smooth", "thin"]
    left = measured
    for name in reversed(names):
        left = left.without(name)
    assert left.steps == ()
    assert_array_equal(left.points.height, measured.trace.height)
    again = measured.without("align").aligned()
    assert {step.name for step in again.steps} == set(names)
    slope = np.polyfit(measured.without("level").points.y, measured.without("level").points.height, 1)[0]
    # The tilt of 6 mrad is there again; noise over the length is a thousandth of it.
    assert_allclose(slope, 6e-3, rtol=2e-3)
    # One that is repeated takes the place of the first.
    changed = measured.smoothed(cutoff=0.25)
    assert [step.name for step in changed.steps] == names
    assert [each.states[5].numbers["cutoff"] for each in (changed, measured)] == [0.25, 0.8]
    with pytest.raises(InputError, match="step = 'smoth' must be one of 'level'"):
        measured.without("smoth")


def test_what_every_step_removed_adds_up_to_the_raw_line(measured):
    raw, level, _, trim, outliers, smooth, _ = measured.states
    assert_allclose(level.height + level.removed_height, raw.height, rtol=0, atol=1e-15)
    assert len(trim.points) + len(trim.removed[0]) == len(raw.points)
    assert len(outliers.points) + len(outliers.removed[0]) == len(trim.points)
    assert_allclose(smooth.height + smooth.removed_height, outliers.height, rtol=0, atol=1e-15)


def test_the_raw_line_cannot_be_changed(measured):
    with pytest.raises(ValueError, match="read-only"):
        measured.trace.height[0] = 1.0


def test_the_profile_is_zero_at_its_highest_point_and_solves(measured):
    profile = measured.profile()
    assert measured.relief.min() == 0.0
    assert profile.extent == (measured.points.y[0], measured.points.y[-1])
    roller = nh.Roller(diameter=10, length=12, profile=profile)
    load = 2000.0
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=load)
    crown = nh.Roller(diameter=10, length=12, profile=nh.profile.crown(radius=RADIUS))
    true = nh.solve(nh.Contact(crown, nh.Plate()), load=load)
    # What is left of the roughness, waves of 0.8 mm and 20 nm, moves an approach of some micrometres by as much.
    assert_allclose(solution.approach, true.approach, atol=5e-5)


def test_roughness_without_a_filter_is_warned_of(measured):
    rough = measured.without("smooth").without("thin")
    assert any("pressing them flat takes" in sentence for sentence in rough.warnings)
    assert measured.warnings == ()


def test_the_slope_of_short_waves_is_that_of_the_wave():
    """A wave of amplitude A and length l has the root mean square slope 2 pi A / (sqrt(2) l)."""
    y = np.linspace(0.0, 20.0, 20001)
    points = Points(y, 1e-4 * np.sin(2.0 * np.pi * y / 0.1) + 0.01 * np.sin(2.0 * np.pi * y / 20.0))
    # Chords of 1 um shorten a wave of 0.1 mm by 2e-4; its ends add a little.
    assert_allclose(short_wave_slope(points, 0.6), 2.0 * np.pi * 1e-4 / 0.1 / math.sqrt(2.0), rtol=2e-3)
    assert short_wave_slope(Points(y[::500], np.zeros(41)), 0.6) == 0.0


def test_the_ripple_is_that_of_westergaard():
    """pi E* A / l is the amplitude of the pressure that flattens a wave; a tenth of the contact's is warned of."""
    modulus = 207000.0 / (2.0 * (1.0 - 0.3**2))
    assert_allclose(1.0 / (math.pi * STEEL_COMPLIANCE), modulus, rtol=1e-12)
    y = np.linspace(-5.0, 5.0, 20001)
    length, pressure = 0.2, 1500.0
    amplitude = 0.1 * pressure * math.sqrt(2.0) * length / (math.pi * modulus)  # 0.1 p0 root mean square
    wave = np.sin(2.0 * np.pi * y / length)
    warned = [bool(Measured(Trace(y, factor * amplitude * wave)).warnings) for factor in (0.97, 1.03)]
    assert warned == [False, True]


def test_roughness_is_that_of_a_wave():
    """Ra = 2 A / pi, Rq = A / sqrt(2), Rz = 2 A, all of it in the octave of its wavelength."""
    y = np.linspace(0.0, 8.0, 16001)
    found = roughness_in(Points(y, 1e-3 * np.sin(2.0 * np.pi * y / 0.03)), 0.8)
    # Without half a cutoff at either end.
    assert_allclose([found.ra, found.rq, found.rz], [2e-3 / np.pi, 1e-3 / np.sqrt(2.0), 2e-3], rtol=5e-3)
    assert found.sections == 9
    assert found.main_band[0] < 0.03 < found.main_band[1]
    assert_allclose(math.hypot(*(band[2] for band in found.bands)), found.rq, rtol=5e-3)
    # Octaves, the shortest open towards zero.
    edges = [high for _, high, _ in found.bands]
    assert_allclose(edges, edges[-1] * 0.5 ** np.arange(len(edges))[::-1], rtol=1e-12)


@pytest.mark.parametrize(
    ("form", "rtol"),
    [
        (lambda y: -(y**2) / 120.0, 2e-3),
        (lambda y: np.sqrt(400.0 - y**2), 2e-3),
        (lambda y: 2e-3 * y - y**4 / 1e5, 2e-3),
        (lambda y: 3.3e-3 * np.log(1.0 - 0.98 * (y / 4.0) ** 2), 0.2),  # no polynomial, and 13 um at its ends
    ],
    ids=["barrel", "circle", "quartic", "logarithmic"],
)
def test_roughness_is_that_of_the_surface_whatever_its_form(form, rtol):
    y = np.linspace(-4.0, 4.0, 801)
    rough = 5e-5 * np.sin(2.0 * np.pi * y / 0.05)
    flat, found = roughness_in(Points(y, rough), 0.8), roughness_in(Points(y, form(y) + rough), 0.8)
    assert_allclose(flat.ra, np.mean(np.abs(rough)), rtol=2e-3)
    assert_allclose(found.ra, flat.ra, rtol=rtol)
    assert found.rz >= 2.0 * found.ra


def test_a_line_in_wrong_units_is_doubted():
    """Positions in um that are taken for mm, of a crown of 500 mm and 10 mm; of one of 5 mm and 0.1 mm."""
    for length, radius, what in ((1e4, 5e8, "is 10 m long"), (100.0, 5e6, "has a radius of 5 km")):
        y = np.linspace(-0.5 * length, 0.5 * length, 501)
        found = prepare(Trace(y, -(y**2) / (2.0 * radius)), smooth=False).warnings
        assert [each for each in found if "check the units" in each] == [
            f"The line {what}: check the units of its positions and heights."
        ]
    y = np.linspace(-5.0, 5.0, 501)
    straight = Trace(y, 1e-5 * np.random.default_rng(1).standard_normal(501))
    assert not any("check the units" in each for each in prepare(straight).warnings)


def test_a_gap_is_told(measured):
    y = np.concatenate([np.linspace(0.0, 4.0, 2001), np.linspace(4.5, 10.0, 2751)])
    assert holes(y) == ((4.0, 4.5),)
    trace = Trace(y, np.zeros(len(y)), holes(y))
    told = [sentence for sentence in prepare(trace, outliers=False).warnings if "Nothing was measured" in sentence]
    assert told == ["Nothing was measured between y = -1 and -0.5 mm; the profile bridges it with a curve."]


def test_uneven_spacing_is_no_gap():
    assert holes(np.array([0.0, 0.1, 0.3, 0.9, 1.0, 3.0, 3.1])) == ()


def test_prepare_leaves_out_what_is_not_wanted():
    bare = prepare(rough_roller(), level=False, align=False, trim=False, outliers=False, smooth=False)
    assert bare.steps == ()
    some = prepare(rough_roller(), trim=10.0, outliers=4.0, smooth="spline", cutoff=0.25, points=101, align="ends")
    assert [type(step).__name__ for step in some.steps] == ["Level", "Align", "Trim", "Outliers", "Smooth", "Thin"]
    assert len(some.points) == 101
    assert_allclose(some.points.y[[0, -1]], [-5.0, 5.0], atol=3e-3)
    by_hand = Measured(rough_roller()).levelled().aligned().trimmed(10.0).without_outliers(4.0)
    assert some.steps == by_hand.smoothed(0.25, "spline").thinned(101).steps
