"""Measured profiles: each step does what it says, on lines whose truth is known."""

import math
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonhertz.errors import InputError
from nonhertz.measured import Measured, Points, Trace, prepare
from nonhertz.measured.filters import ALPHA, gaussian, spline
from nonhertz.measured.land import land, steps_in, symmetry, tilt
from nonhertz.measured.steps import Align, Level, Outliers, Smooth, Thin, Trim

SEED = 20240501


def roller(
    radius: float = 1500.0,
    lean: float = 0.0,
    at: float = 0.0,
    noise: float = 0.0,
    chamfer: float = 0.5,
    count: int = 6001,
) -> Trace:
    """Return a crowned roller of 12 mm in the machine: tilted, moved, rough, with chamfers of 45 degrees."""
    y = np.linspace(-6.0, 6.0, count)
    height = -(y**2) / (2.0 * radius)
    height -= np.maximum(np.abs(y) - (6.0 - chamfer), 0.0)
    height += noise * np.random.default_rng(SEED).standard_normal(count)
    return Trace(y + at, height + lean * y, name="roller")


def test_the_land_ends_where_the_chamfers_begin():
    low, high = land(roller(lean=3e-3, at=4.0))
    # A chord of half a per cent of the length sees a chamfer as soon as a twentieth of it is in it.
    assert_allclose([low, high], [4.0 - 5.5, 4.0 + 5.5], atol=0.0025 * 12.0)
    assert low > 4.0 - 5.5
    assert high < 4.0 + 5.5


def test_a_scratch_does_not_end_the_land():
    trace = roller()
    height = trace.height - 0.02 * ((trace.y > 2.0) & (trace.y < 2.1))
    low, high = land(Points(trace.y, height))
    assert_allclose([low, high], [-5.5, 5.5], atol=0.03)


@pytest.mark.parametrize(("height", "at"), [(-0.01, -3.0), (-0.005, 2.5), (0.005, 5.0), (0.019, -0.6)])
@pytest.mark.parametrize("noise", [pytest.param(0.0, marks=pytest.mark.slow), 1e-4])
def test_a_low_step_neither_ends_the_land_nor_goes_unsaid(noise, at, height):
    trace = roller(noise=noise)
    stepped = Trace(trace.y, trace.height + height * (trace.y > at))
    assert_allclose(land(stepped), land(trace), atol=5e-3)
    measured = prepare(stepped)
    assert_allclose(measured.states[2].numbers["shift"], 0.0, atol=3e-3)
    # The step is measured over a chord of 60 um, to what the crown falls in it, 0.2 um on 11 mm.
    assert_allclose(measured.states[1].numbers["tilt"], 0.0, atol=5e-5)
    sentences = [sentence for sentence in measured.warnings if "steps by" in sentence]
    assert len(sentences) == 1
    assert "both sides were taken for one body" in sentences[0]
    (found,) = steps_in(stepped)
    # The ends of the chords beside it lie half of a chord away, on the crown.
    assert found.y == pytest.approx(at, abs=0.01)
    assert found.height == pytest.approx(height, abs=5e-4)


def test_a_high_step_ends_the_land_and_is_said():
    trace = roller()
    stepped = Trace(trace.y, trace.height - 0.05 * (trace.y > 2.0))
    assert land(stepped)[1] < 2.0
    (found,) = steps_in(stepped)
    assert not found.within
    assert "steps by 50 µm at 2.001 mm in the file; the part beyond it was taken for another body" in " ".join(
        prepare(stepped).warnings
    )


def stepped(spacing: float, height: float, noise: float = 2e-5) -> Trace:
    """Return 10 mm of a crown whose first 3 mm are higher, in a machine that tilts it."""
    y = np.linspace(0.0, 10.0, round(10.0 / spacing) + 1)
    z = -((y - 4.9) ** 2) / 1000.0 + 1.5e-3 * y + noise * np.random.default_rng(SEED).standard_normal(len(y))
    z += height * (y < 3.0)
    return Trace(y, z)


@pytest.mark.parametrize("slope", [0.05, 0.5])
@pytest.mark.parametrize("height", [-0.021, -0.019, 0.0195, 0.0205, 0.1])
@pytest.mark.parametrize("spacing", [0.2, 0.02, 0.005])
def test_what_a_step_is_depends_on_its_height_alone(spacing, height, slope):
    """Not on the spacing of the points or the slope of a chamfer: up to 20 um it does not end the land."""
    trace = stepped(spacing, height)
    (found,) = steps_in(trace, slope)
    assert found.within == (abs(height) < 0.02)
    assert abs(found.height) == pytest.approx(abs(height), rel=0.02)
    assert found.y == pytest.approx(3.0, abs=spacing)
    measured = prepare(trace, slope=slope, smooth=False, points=False)
    kept = measured.points.span
    # A chord of a quarter of a per cent of the trace, or two points, is lost at the step.
    assert kept == pytest.approx(10.0 if found.within else 7.0, abs=max(0.05, 3.0 * spacing))
    assert sum("The surface steps by" in sentence for sentence in measured.warnings) == 1


@pytest.mark.parametrize("mirrored", [False, True], ids=["", "mirrored"])
def test_of_two_stretches_that_are_as_long_the_higher_one_is_the_land(mirrored):
    y = np.linspace(0.0, 10.0, 501)
    trace = Trace(y, 0.05 * ((y < 5.0) ^ mirrored))
    low, high = land(trace)
    assert_allclose([low, high], [5.0, 10.0] if mirrored else [0.0, 5.0], atol=0.07)


@pytest.mark.parametrize("between", ["groove", "steep"])
def test_a_stretch_beyond_a_groove_at_another_height_is_not_left_out_in_silence(between):
    y = np.linspace(0.0, 10.0, 1001)
    trace = Trace(
        y,
        np.interp(y, [0.0, 3.0, 3.3, 10.0], [0.03, 0.03, 0.0, 0.0])
        - 0.05 * (between == "groove") * (np.abs(y - 3.15) < 0.15),
    )
    measured = prepare(trace, smooth=False, points=False)
    assert measured.points.span < 7.1
    assert "The surface steps by 30 µm at 3.1" in " ".join(measured.warnings)


def test_waves_grooves_and_kinks_are_no_steps():
    y = np.linspace(-6.0, 6.0, 501)
    shapes = [
        0.002 * np.sin(2.0 * np.pi * y / 0.4),
        0.003 * np.sin(2.0 * np.pi * y / 0.5) * (np.abs(y) < 0.25),
        -0.02 * np.exp(-(((y - 1.0) / 0.15) ** 2)),
        -0.002 * np.maximum(np.abs(y) - 3.0, 0.0),
        0.01 * np.log(1.0 - (0.16 * y) ** 2),
        -(y**2) / 120.0,
        -0.003 * (np.abs(y - 1.0) < 0.3),
    ]
    for shape in shapes:
        for noise in (0.0, 1e-4):
            rough = noise * np.random.default_rng(SEED).standard_normal(len(y))
            assert steps_in(Points(y, shape + rough), 0.2) == ()


def test_chamfers_ribs_and_scratches_are_no_steps():
    trace = roller(noise=1e-4)
    scratched = trace.height - 0.02 * ((trace.y > 2.0) & (trace.y < 2.05))
    ribs = trace.height + np.where(np.abs(trace.y) > 5.0, 1.0, 0.0)
    for height in (trace.height, scratched, ribs):
        assert steps_in(Points(trace.y, height)) == ()


def test_a_line_that_is_steep_everywhere_has_no_land():
    y = np.linspace(0.0, 1.0, 200)
    with pytest.raises(InputError, match=r"slope = 0\.05 must leave 5 neighbouring points that are less steep"):
        land(Points(y, np.sin(300.0 * y)))


def test_a_land_without_chamfers_is_the_whole_line():
    trace = roller(chamfer=0.0)
    assert land(trace) == (trace.y[0], trace.y[-1])


@pytest.mark.parametrize("lean", [0.0, 1e-3, -0.02])
def test_level_takes_off_the_tilt_of_a_crown_exactly(lean):
    """All of a crown is even: only the ends of the land, found to a step of 2 um, turn it, by 2 um / radius."""
    assert_allclose(tilt(roller(lean=lean)), lean, atol=2e-3 / 1500.0 + 1e-12)


def test_level_is_not_turned_by_one_end_that_has_lost_more():
    """A straight middle with 3 mm of a drop on one side: least squares would be off by over 0.1 mrad."""
    y = np.linspace(-5.0, 5.0, 5001)
    drop = 0.004 * (np.maximum(y - 2.0, 0.0) / 3.0) ** 2
    noise = 1e-4 * np.random.default_rng(SEED).standard_normal(len(y))
    points = Points(y, 2e-3 * y - drop + noise)
    by_squares = np.polyfit(points.y, points.height, 1)[0]
    assert abs(by_squares - 2e-3) > 0.1e-3
    # Weight goes with distance: what lies beyond 2 mm has 21/25 of it, more than the half that a median forgives, and
    # the drop turns it by what it has gained at the median's distance, sqrt(12.5) mm.
    distance = np.sqrt(12.5)
    expected = 2e-3 - 0.5 * 0.004 * ((distance - 2.0) / 3.0) ** 2 / distance
    assert_allclose(tilt(points), expected, atol=1e-5)


def test_level_keeps_the_height_of_the_middle():
    trace = roller(lean=5e-3, at=3.0)
    state = Level().apply(trace)
    middle = np.argmin(np.abs(trace.y - 3.0))
    assert_allclose(state.height[middle], trace.height[middle], atol=1e-5)


def test_level_and_align_undo_a_tilt_and_a_shift():
    straight, moved = roller(), roller(lean=4e-3, at=-2.0)
    measured = Measured(moved).levelled().aligned()
    expected = np.interp(measured.points.y, straight.y, straight.height)
    inside = np.abs(measured.points.y) < 5.4
    found = measured.points.height - measured.points.height.max()
    # The middle is found to one step of 2 um, which moves a crown by 2 um * 5.5 mm / 1500 mm at its end.
    assert_allclose(found[inside], expected[inside], atol=1e-5)


def test_symmetry_finds_the_middle_of_a_flat_with_two_drops():
    y = np.linspace(0.0, 9.0, 3001)
    height = -(np.maximum(np.abs(y - 4.2) - 2.0, 0.0) ** 2) / 600.0 + 1e-3 * y
    found = symmetry(Points(y, height))
    # The grid of places is 9 um fine; a parabola through three of them does better.
    assert found == pytest.approx(4.2, abs=0.01)


def test_no_symmetry_is_claimed_for_an_arc():
    y = np.linspace(0.0, 9.0, 3001)
    points = Points(y, -((y - 4.2) ** 2) / 1000.0)
    assert symmetry(points) is None
    with pytest.raises(InputError, match="align = 'symmetry' must find a place about which"):
        Align("symmetry").apply(points)


def test_trim_keeps_a_length_about_the_middle():
    state = Trim(8.0).apply(roller())
    assert_allclose(state.y[[0, -1]], [-4.0, 4.0], atol=2e-3)
    assert state.numbers["removed"] == len(roller()) - len(state.points)


def test_trim_says_how_much_is_cut_off_at_either_end():
    y = np.linspace(-4.0, 5.0, 91)
    assert Trim(6.0).apply(Points(y, 0.0 * y)).words == "Kept from -3 to 3 mm; cut off 1 and 2 mm."


def test_gaps_beyond_the_points_that_are_kept_are_none_of_them():
    y = np.concatenate([np.linspace(0.0, 2.0, 21), np.linspace(3.0, 9.0, 61)])
    points = Points(y, 0.0 * y, ((2.0, 3.0),))
    assert points.kept(y > 1.0).gaps == ((2.0, 3.0),)
    assert points.kept(y > 4.0).gaps == points.kept(y < 1.5).gaps == ()


def test_trim_refuses_a_length_that_was_not_measured():
    with pytest.raises(InputError, match=r"trim = 14.0 must lie within the points, which go from -6 to 6 mm"):
        Trim(14.0).apply(roller())


def test_outliers_are_taken_out_and_counted_and_nothing_else():
    trace = roller(noise=1e-4, chamfer=0.0)
    height = np.array(trace.height)
    spikes = np.array([100, 101, 2500, 4000, 5998])
    height[spikes] += np.array([5e-3, 5e-3, -4e-3, 3e-3, 6e-3])
    state = Outliers().apply(Points(trace.y, height))
    assert state.removed is not None
    # Five robust sigmas: 6001 points of noise have a chance of 0.3 % to lose one of themselves.
    assert_array_equal(state.removed[0], trace.y[spikes])
    assert state.numbers["removed"] == 5


def test_a_line_without_noise_has_no_outliers():
    """The shape itself is none, also where it turns and a running median cannot follow."""
    y = np.linspace(-10.0, 10.0, 201)
    for height in (-(y**2) / 200.0, 0.05 * np.cos(y), np.zeros(201), 0.001 * y):
        assert Outliers().apply(Points(y, height)).numbers["removed"] == 0


@pytest.mark.parametrize("grain", [slice(-1, None), slice(0, 1), slice(-4, None)], ids=["last", "first", "last four"])
def test_dust_on_an_end_goes_and_what_lies_beside_it_stays(grain):
    trace = roller(noise=1e-4, chamfer=0.0)
    height = np.array(trace.height)
    height[grain] += 5e-3
    state = Outliers().apply(Points(trace.y, height))
    assert state.removed is not None
    assert_array_equal(state.removed[0], trace.y[grain])


def test_heights_that_were_rounded_off_are_no_outliers():
    """Of stairs most points lie on their chords and the median deviation is nothing; a tenth of a micrometre stays."""
    trace = roller(chamfer=0.0)
    rounded = np.round(trace.height, 4)
    assert Outliers().apply(Points(trace.y, rounded)).numbers["removed"] == 0
    rounded[3000] += 0.005
    state = Outliers().apply(Points(trace.y, rounded))
    assert state.removed is not None
    assert_array_equal(state.removed[0], trace.y[[3000]])


@pytest.mark.parametrize(("cutoff", "count"), [(0.5, 401), (6.0, 400)])
def test_the_gaussian_filter_is_the_line_that_fits_best_around_each_point(cutoff, count):
    """Point by point, as ISO 16610-28 has it; one lies alone, where a line is carried on from afar if at all."""
    random = np.random.default_rng(5)
    y = np.sort(np.append(random.uniform(0.0, 6.0, 400), 7.0))
    height = random.normal(0.0, 1e-3, y.size)
    points = Points(y, height, ((y[-2], 7.0),))
    form = np.polynomial.Polynomial.fit(y, height, 2, w=np.sqrt(np.maximum(points.weights, 1e-12)))(y)
    expected = []
    for place in y:
        share = np.maximum(points.weights, 1e-12) * np.exp(-math.pi * ((y - place) / (ALPHA * cutoff)) ** 2)
        share[np.abs(y - place) > cutoff] = 0.0
        terms = np.stack([np.ones_like(y), y - place])
        normal = (share * terms) @ terms.T + np.diag([0.0, 1e-12 * share.sum()])
        expected.append(np.linalg.solve(normal, (share * terms) @ (height - form))[0])
    # Steps of a 64th of the cutoff, and a kernel that ends where it has fallen to 7e-7.
    assert_allclose(gaussian(points, cutoff)[:count], (form + expected)[:count], atol=5e-6)


@pytest.mark.parametrize("wavelength", [0.1, 0.25])
def test_chatter_on_a_part_of_the_line_is_surface(wavelength):
    """A fifth of the line has waves of 0.5 um, the rest a roughness of 10 nm."""
    trace = roller(noise=1e-5, chamfer=0.0)
    chatter = 5e-4 * np.sin(2.0 * np.pi * trace.y / wavelength) * (np.abs(trace.y) < 1.2)
    assert Outliers().apply(Points(trace.y, trace.height + chatter)).numbers["removed"] == 0


def ground(length: float = 20.0, count: int = 8001) -> Trace:
    """Return a line of a crown of 600 mm with a roughness of 0.1 um."""
    y = np.linspace(-0.5 * length, 0.5 * length, count)
    return Trace(y, -(y**2) / 1200.0 + 1e-4 * np.random.default_rng(SEED).standard_normal(count))


def taken_out(trace: Trace, change: np.ndarray) -> np.ndarray:
    """Return which points go when a line is changed, but for those that go anyway."""
    state, before = (Outliers().apply(Points(trace.y, trace.height + of)) for of in (change, 0.0))
    return np.isin(trace.y, state.y, invert=True) & np.isin(trace.y, before.y)


@pytest.mark.parametrize("shape", ["round", "with walls"])
@pytest.mark.parametrize("depth", [1e-3, 3e-3, 0.02])
@pytest.mark.parametrize("width", [0.22, 0.6, 1.0])
def test_a_dent_is_shape_and_none_of_its_points_goes(width, depth, shape):
    """Nor does any beside it: the surface goes on into the wall, or out of it."""
    width *= 2.0 if shape == "round" and width < 0.4 else 1.0  # which is narrower at its foot
    trace = ground()
    inside = np.abs(trace.y - 1.0) < 0.5 * width
    bottom = 0.5 + 0.5 * np.cos(2.0 * np.pi * (trace.y - 1.0) / width) if shape == "round" else 1.0
    near = np.abs(trace.y - 1.0) < width + 0.5
    assert not np.any(taken_out(trace, -depth * bottom * inside) & near)


@pytest.mark.parametrize("length", [12.0, 20.0, 50.0])
@pytest.mark.parametrize("depth", [2e-3, 0.02])
@pytest.mark.parametrize("width", [0.01, 0.03, 0.08])
def test_a_scratch_goes_and_all_points_beside_it_stay(width, depth, length):
    """Also beside a ridge that the scratch has thrown up, and between two scratches."""
    trace = ground(length)
    distance = (trace.y - 1.0) / width
    scratch, ridge, other = (np.abs(distance - place) < 0.499 for place in (0.0, 1.0, 2.0))
    assert_array_equal(taken_out(trace, -depth * scratch), scratch)
    assert_array_equal(taken_out(trace, -depth * (scratch | other)), scratch | other)
    both = taken_out(trace, depth * (1.0 * ridge - 1.0 * scratch))
    assert not np.any(both & ~(scratch | ridge))


@pytest.mark.parametrize("change", ["step", "edge"])
def test_a_step_and_a_rounded_edge_lose_no_points(change):
    trace = ground()
    rounded = np.maximum(np.abs(trace.y) - 9.95, 0.0) ** 2 / 0.2
    assert not np.any(taken_out(trace, -0.005 * (trace.y > 0.3) if change == "step" else -rounded))


def transmitted(y: np.ndarray, phase: float) -> float:
    """Return how much of a wave of the cutoff is left by the Gaussian filter, away from the ends."""
    wave = np.cos(2.0 * np.pi * (y / 0.8 + phase))
    inside = slice(np.searchsorted(y, 1.6), np.searchsorted(y, y[-1] - 1.6))
    across = np.sin(2.0 * np.pi * (y / 0.8 + phase))
    found = np.linalg.lstsq(np.column_stack([wave, across])[inside], gaussian(Points(y, wave), 0.8)[inside], rcond=None)
    return float(found[0][0])


@pytest.mark.parametrize("phase", [0.0, 0.25])
@pytest.mark.parametrize("count", [5, 6, 7.3, 10, 20, 40, 333])
def test_half_of_a_wave_of_the_cutoff_is_let_through_however_few_points_it_has(count, phase):
    """What is beyond half at five points is the wave's alias, 2^-16 over 2; interpolating first would leave 0.44."""
    y = np.arange(0.0, 40.0, 0.8 / count)
    assert_allclose(transmitted(y, phase), 0.5, atol=2e-5)


@pytest.mark.parametrize(("count", "error"), [(10, 2e-3), (20, 5e-4), (40, 1e-4)])
def test_half_is_let_through_by_points_of_two_strokes_and_by_unevenly_spaced_ones(count, error):
    """Pairs a sixteenth of a step apart, and points moved by up to three tenths; interpolating first leaves 0.44."""
    pairs = np.sort(np.concatenate([np.arange(0.0, 40.0, 1.6 / count) + k * 0.1 / count for k in range(2)]))
    assert_allclose(transmitted(pairs, 0.0), 0.5, atol=1e-4)
    y = np.arange(0.0, 160.0, 0.8 / count)
    moved = y + 0.3 * 0.8 / count * np.random.default_rng(SEED).uniform(-1.0, 1.0, len(y))
    assert_allclose(transmitted(moved, 0.0), 0.5, atol=error)


def test_a_line_that_is_too_coarse_for_the_cutoff_in_places_is_warned_of():
    fine, coarse = np.arange(0.0, 8.0, 0.01), np.arange(8.0, 12.0, 0.3)
    y = np.concatenate([fine, coarse])
    measured = Measured(Trace(y, -(y**2) / 1000.0)).smoothed()
    assert "On 3.9 mm of 11.9 mm points lie further apart than a fifth of the cutoff" in " ".join(measured.warnings)
    assert "fifth" not in " ".join(Measured(Trace(fine, -(fine**2) / 1000.0)).smoothed().warnings)


def test_the_gaussian_filter_keeps_what_was_measured_alone_between_gaps():
    """One point between two gaps stands for no length; nothing is left to smooth it with."""
    y = np.concatenate([np.linspace(0.0, 3.0, 301), [5.0], np.linspace(7.0, 10.0, 301)])
    height = np.where(y == 5.0, 0.01, 0.002 * y)
    smooth = gaussian(Points(y, height, gaps=((3.0, 5.0), (5.0, 7.0))), 0.8)
    assert_allclose(smooth, height, atol=1e-12)


def test_a_long_line_is_filtered_in_pieces_that_meet():
    y = np.linspace(0.0, 300.0, 30001)
    height = 1e-3 * np.random.default_rng(SEED).standard_normal(len(y))
    whole = gaussian(Points(y, height), 0.1)
    part = gaussian(Points(y[9000:11001], height[9000:11001]), 0.1)
    # Pieces are of a thousand cutoffs, 100 mm; their grids differ, which are exact to 2e-6.
    assert_allclose(whole[9100:10901], part[100:-100], atol=1e-8)


@pytest.mark.parametrize("ratio", [0.5, 1.0, 2.0, 4.0])
@pytest.mark.parametrize("smooth", [gaussian, spline])
def test_filters_transmit_what_iso_16610_21_and_22_say(smooth, ratio):
    """Half of a wave of the cutoff c, exp(-pi (alpha c / l)^2) or 1 / (1 + (c / l)^4) of any other."""
    y = np.linspace(0.0, 32.0, 16001)
    wave = np.cos(2.0 * np.pi * y / (0.8 * ratio))
    inside = (y > 4.8 - 1e-3) & (y < 27.2 - 1e-3) if ratio < 4.0 else (y > 3.2 - 1e-3) & (y < 28.8 - 1e-3)
    found = 2.0 * np.mean((smooth(Points(y, wave), 0.8) * wave)[inside])
    if smooth is gaussian:
        # The weight is cut at one cutoff, where 7e-7 of its peak are left, and the mean is over whole waves.
        assert_allclose(found, math.exp(-math.pi * (ALPHA / ratio) ** 2), atol=1e-5)
    else:
        # It is fitted to means over a fortieth of the cutoff, sinc(1 / 20) = 0.996 of the shortest wave.
        assert_allclose(found, 1.0 / (1.0 + ratio**-4), rtol=5e-3)


@pytest.mark.parametrize("smooth", [gaussian, spline], ids=["gaussian", "spline"])
def test_filters_leave_a_line_and_a_parabola_alone_up_to_their_ends(smooth):
    """A running mean would lift the end of this crown by a micrometre."""
    y = np.linspace(0.0, 10.0, 5001)
    line = 5.0 + 0.003 * y - (y - 4.0) ** 2 / 1000.0
    # Rounding, of an FFT or of a smoothing spline's equations, over heights of 5 mm.
    assert_allclose(smooth(Points(y, line), 0.8), line, atol=1e-9)


def test_filters_take_unevenly_spaced_points():
    rng = np.random.default_rng(SEED)
    y = np.sort(rng.uniform(0.0, 20.0, 8000))
    y = np.unique(np.concatenate([[0.0], y, [20.0]]))
    form = 0.01 * np.cos(2.0 * np.pi * y / 10.0)
    for smooth in (gaussian, spline):
        found = smooth(Points(y, form + 1e-3 * np.cos(2.0 * np.pi * y / 0.1)), 0.8)
        # Of the short wave a few per cent of its sampling noise are left, of the form 0.2 % are lost.
        assert_allclose(found, form, atol=2e-4)


def test_the_gaussian_filter_does_not_reach_across_a_gap():
    """A step hidden in a gap wider than the filter stays as it is."""
    y = np.concatenate([np.linspace(0.0, 4.0, 2001), np.linspace(6.0, 10.0, 2001)])
    height = np.where(y < 5.0, 0.0, 0.01)
    smooth = gaussian(Points(y, height, gaps=((4.0, 6.0),)), 0.8)
    assert_allclose(smooth, height, atol=1e-9)


@pytest.mark.parametrize("cutoff", [0.001, 20.0])
def test_a_cutoff_that_means_nothing_is_refused(cutoff):
    with pytest.raises(InputError, match=r"must lie between five points, 0.01 mm, and the length of the line, 12 mm"):
        Smooth(cutoff).apply(roller())


def test_thinning_keeps_the_ends_and_leaves_gaps_open():
    y = np.concatenate([np.linspace(0.0, 4.0, 2001), np.linspace(6.0, 10.0, 2001)])
    state = Thin(101).apply(Points(y, 0.001 * y, gaps=((4.0, 6.0),)))
    assert_allclose(state.y[[0, -1]], [0.0, 10.0], rtol=0, atol=0)
    assert not np.any((state.y > 4.0) & (state.y < 6.0))
    assert len(Thin(101).apply(roller(count=51)).points) == 51


def test_gaps_narrower_than_the_points_that_are_kept_are_bridged():
    y = np.linspace(0.0, 10.0, 10001)
    inside = ~((y > 4.0) & (y < 4.05)) & ~((y > 6.0) & (y < 7.0))
    state = Thin(101).apply(Points(y[inside], 0.001 * y[inside], gaps=((4.0, 4.05), (6.0, 7.0))))
    assert state.gaps == ((6.0, 7.0),)
    assert_allclose(np.diff(state.y)[:59], 0.1, rtol=1e-9)


def test_points_of_gaps_alone_are_refused():
    """They would have no weight at all, and a mean of them none either."""
    y = np.arange(6.0)
    with pytest.raises(InputError, match="must leave two neighbouring points that were measured"):
        Points(y, np.zeros(6), gaps=tuple(pairwise(y)))


def test_many_gaps_are_told_in_one_sentence():
    y = np.delete(np.linspace(0.0, 10.0, 1001), [place + k for place in range(100, 900, 100) for k in range(5)])
    measured = Measured(Trace(y, -(y**2) / 4000.0, tuple((k - 0.01, k + 0.05) for k in range(1, 9))))
    told = [sentence for sentence in measured.warnings if "Nothing was measured" in sentence]
    assert len(told) == 1
    assert "in 8 places, 0.48 mm in all" in told[0]


@pytest.mark.parametrize(
    ("y", "height", "field"),
    [([0, 1, 2, 3], [0, 0, 0, 0], "points"), ([0, 1, 1, 2, 3], [0] * 5, "y"), ([0, 1, 2, 3, np.nan], [0] * 5, "y"),
     ([0, 1, 2, 3, 4], [0] * 4, "height")],
    ids=range(4),
)  # fmt: skip
def test_points_that_are_no_line_are_refused(y, height, field):
    with pytest.raises(InputError) as caught:
        Points(y, height)
    assert caught.value.field == field
