"""Rings that are not round, as values: from Fourier terms, from numbers, from files."""

import dataclasses
import math

import numpy as np
import pytest
from crowned_rows import barrels, row, washers

import nonhertz as nh
from nonhertz.bearing import fourier_shape, tabulated_shape
from nonhertz.files.ring_shapes import read_ring_shape

ROW = row(clearance=0.0, radius=4000.0, ends={})
AROUND = np.linspace(-7.0, 7.0, 57)
TURN = 2.0 * math.pi


def oval(angle):
    return 0.005 * np.cos(2.0 * (angle - 0.3))


def test_a_bearing_with_a_shape_is_one_with_its_function():
    shape = fourier_shape({2: (0.005, 0.3)})
    by_value, by_function = (dataclasses.replace(ROW, outer_shape=each) for each in (shape, oval))
    np.testing.assert_allclose(by_value.gaps[1], by_function.gaps[1], rtol=0.0, atol=1e-17)
    # Positive leaves less room: the roller nearest a crest touches first.
    assert by_value.gaps[1].argmin() == np.abs(np.cos(ROW.angles - 0.3)).argmax()
    same = dataclasses.replace(ROW, outer_shape=fourier_shape({2: (0.005, 0.3)}))
    assert by_value == same
    assert hash(shape) == hash(same.outer_shape)
    assert by_value != by_function
    assert by_value != dataclasses.replace(ROW, outer_shape=fourier_shape({2: (0.005, 0.4)}))


def test_an_outer_ring_off_its_centre_is_an_inner_ring_that_has_moved():
    # Order 1 on the outer ring: it lies nearer at a crest, as if the inner ring had moved there.
    shifted = dataclasses.replace(ROW, outer_shape=fourier_shape({1: 0.01}))
    centred = nh.bearing.solve(ROW, radial=3e3, method="slices")
    found = nh.bearing.solve(shifted, radial=3e3, method="slices")
    assert found.displacement[1] == pytest.approx(centred.displacement[1] - 0.01, abs=1e-9)
    np.testing.assert_allclose(found.load, centred.load, rtol=1e-6, atol=1e-3)


@pytest.mark.parametrize("curve", ["cubic", "linear"])
def test_a_table_goes_through_its_numbers_and_closes(curve):
    angle, deviation = np.array([0.4, 1.1, 2.0, 3.5, 5.9]), np.array([1.0, -2.0, 0.5, 0.7, -0.3])
    shape = tabulated_shape(angle, deviation, curve)
    for turns in (-3, 0, 2):
        np.testing.assert_allclose(shape(angle + turns * TURN), deviation, atol=1e-12)
    shuffled = tabulated_shape(angle[[3, 1, 0, 4, 2]], deviation[[3, 1, 0, 4, 2]], curve)
    assert shape == shuffled
    # Also across the angle at which the table begins.
    before, after = shape([0.4 - 1e-9]), shape([0.4 + 1e-9])
    assert before == pytest.approx(after, abs=1e-7)


def test_lines_are_straight_over_the_end_of_the_turn():
    shape = tabulated_shape([0.5, 2.0, 4.0], [0.0, 1.0, 2.0], "linear")
    # From 2 at 4.0 to 0 at 0.5 + 2 pi.
    assert shape([5.0]) == pytest.approx(2.0 - 2.0 * 1.0 / (0.5 + TURN - 4.0))
    assert shape([0.0]) == pytest.approx(2.0 - 2.0 * (TURN - 4.0) / (0.5 + TURN - 4.0))


def test_the_spline_follows_a_smooth_ring():
    # Fourth order: half of the step, a sixteenth of the error.
    errors = []
    for points in (24, 48):
        angle = np.arange(points) * TURN / points
        errors.append(np.abs(tabulated_shape(angle, np.cos(3.0 * angle))(AROUND) - np.cos(3.0 * AROUND)).max())
    assert errors[1] < errors[0] / 12.0
    assert errors[1] < 1e-3


def test_the_angle_that_closes_the_ring_may_be_given():
    angle = np.linspace(0.0, TURN, 13)
    assert tabulated_shape(angle, np.cos(angle)) == tabulated_shape(angle[:-1], np.cos(angle[:-1]))


@pytest.mark.parametrize("last", [6.2832, 6.28319, 6.283, 6.28318])
@pytest.mark.parametrize("first", [0.0, -3.1416, 1.0])
def test_a_turn_may_be_rounded_to_four_digits(first, last):
    shape = tabulated_shape([first, first + 1.5708, first + 3.1416, first + last], [0.0, 0.01, 0.0, 0.0], "linear")
    assert len(shape.parts[0].angle) == 3
    # A straight line from (3.1416, 0) to the first, a turn later.
    assert shape([first + 5.0])[0] == pytest.approx(0.0, abs=1e-12)


def test_what_is_short_of_a_turn_by_a_step_does_not_close_it():
    angle = np.arange(30_000) * (TURN / 30_000)
    assert len(tabulated_shape(angle, np.cos(angle)).parts[0].angle) == 30_000
    with pytest.raises(nh.InputError, match=r"span no more than one turn"):
        tabulated_shape([0.0, 3.0, 6.3], [0.0, 0.01, 0.0])


@pytest.mark.parametrize(
    "shape",
    [
        fourier_shape({1: 0.002, 2: (0.005, 0.3)}),
        tabulated_shape([0.0, 1.0, 3.0, 5.0], [0.0, 0.003, -0.001, 0.002]),
        fourier_shape({3: 0.001}) + tabulated_shape([0.0, 2.0, 4.0], [0.0, 0.003, -0.001], "linear"),
    ],
)
def test_shapes_can_be_added_turned_and_scaled(shape):
    np.testing.assert_allclose(shape.turned(0.7)(AROUND), shape(AROUND - 0.7), atol=1e-15)
    np.testing.assert_allclose(shape.turned(0.7).turned(-0.2)(AROUND), shape(AROUND - 0.5), atol=1e-15)
    np.testing.assert_allclose(shape.scaled(-2.0)(AROUND), -2.0 * shape(AROUND), atol=1e-15)
    both = shape + fourier_shape({4: 0.001})
    np.testing.assert_allclose(both(AROUND), shape(AROUND) + 0.001 * np.cos(4.0 * AROUND), atol=1e-15)
    assert both == shape + fourier_shape({4: 0.001})
    assert isinstance(hash(both), int)
    with pytest.raises(TypeError):
        _ = shape + 3.0


# Files
def written(tmp_path, text):
    path = tmp_path / "ring.csv"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("angle [deg]; deviation [um]\n0; 5\n90; -5\n180; 5\n270; -5\n", {}),
        ("angle [deg]\tdeviation [um]\n0,0\t5,0\n90,0\t-5,0\n180,0\t5,0\n270,0\t-5,0\n", {}),
        ("# angle (rad), z (mm)\n0, 0.005\n1.570796327, -0.005\n3.141592654, 0.005\n4.712388980, -0.005\n", {}),
        ("0 5\n90 -5\n180 5\n270 -5\n360 5\n", {"angle_unit": "deg", "deviation_unit": "um"}),
        ("angle in °; z in um\n-90; -5\n0; 5\n90; -5\n180; 5\n", {}),
    ],
)  # fmt: skip
def test_a_file_is_its_numbers(tmp_path, text, units):
    shape = read_ring_shape(written(tmp_path, text), **units)
    right = tabulated_shape(np.arange(4) * math.pi / 2.0, [0.005, -0.005, 0.005, -0.005])
    np.testing.assert_allclose(shape(AROUND), right(AROUND), atol=1e-10)  # nine digits of an angle


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        ("0 5\n90 -5\n", {"deviation_unit": "um"}, "must state the unit of its angles: write it above the column"),
        ("angle [deg] z\n0 5\n90 -5\n", {}, "must state the unit of its deviations: write it above the column"),
        ("", {}, "file = 'ring.csv' must not be empty"),
        ("angle [deg]; z [um]\n", {}, "must hold two columns of numbers"),
        ("angle [rad]; z [um]\n0; 1\n90; 2\n180; 1\n", {}, "must hold one turn of a ring (angle = 180.0 must span"),
        ("angle [deg]; z [um]; n\n0; 1; 2\n90; 2; 3\n", {}, "must hold two columns, angle and deviation: delete the"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n90; 3\n", {}, "must occur once"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n360; 3\n", {}, "must be the same where the ring closes"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n", {"angle_unit": "grad"}, "angle_unit = 'grad' must be one of 'rad'"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n", {"deviation_unit": "kg"}, "deviation_unit = 'kg' must"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n", {"deviation_unit": 3}, "deviation_unit = 3 must be text"),
        ("angle [deg]; z [um]\n0; 1\n90; 2\n", {"curve": "quintic"}, "curve = 'quintic' must be one of"),
    ],
)  # fmt: skip
def test_a_file_that_is_no_ring_is_refused(tmp_path, text, options, message):
    with pytest.raises(nh.InputError) as raised:
        read_ring_shape(written(tmp_path, text), **options)
    assert message in str(raised.value)
    assert len(str(raised.value).splitlines()) == 1


@pytest.mark.parametrize("path", ["missing.csv", "\0", 3.5, None])
def test_a_file_that_cannot_be_read_is_refused(path):
    with pytest.raises(nh.InputError, match=r"must be (a file that can be read|the path of a file: give a string)"):
        read_ring_shape(path)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: fourier_shape({2.5: 0.005}), "order = 2.5 must be a whole number from 0 to 10000"),
        (lambda: fourier_shape({2: (1.0, 2.0, 3.0)}), "terms[2] = (1.0, 2.0, 3.0) must be an amplitude"),
        (lambda: fourier_shape({2: math.nan}), "terms[2] = nan must be finite"),
        (lambda: tabulated_shape([0.0], [1.0]), "angle = (0.0,) must be a row of at least two angles"),
        (lambda: tabulated_shape([0.0, 1.0, 1.0], [1.0, 2.0, 3.0]), "angle = 1.0 must occur once"),
    ],
)
def test_what_is_no_shape_is_refused(make, message):
    with pytest.raises(nh.InputError) as raised:
        make()
    assert message in str(raised.value)


@pytest.mark.parametrize("unit", [1.0, 1e3])
def test_radii_in_place_of_deviations_are_known_as_such(tmp_path, unit):
    degrees = np.arange(0.0, 361.0)
    radii = unit * (27.75 + 0.005 * np.cos(2.0 * np.radians(degrees)))
    rows = "".join(f"{angle:.4f},{radius:.6f}\n" for angle, radius in zip(degrees, radii, strict=True))
    path = tmp_path / "ring.csv"
    path.write_text(f"Angle (deg),Radius ({'mm' if unit == 1.0 else 'um'})\n{rows}")
    shape = read_ring_shape(path)
    with pytest.raises(
        nh.InputError, match=r"outer_shape = 27\.755 must .*: these are radii .* give their mean less each"
    ):
        dataclasses.replace(ROW, outer_shape=shape)
    with pytest.raises(
        nh.InputError, match=r"inner_shape = 27\.755 must deviate from a circle by at most 0\.465 mm: give"
    ):
        dataclasses.replace(ROW, inner_shape=shape)
    with pytest.raises(
        nh.InputError, match=r"inner_shape = 18\.755 must .*: these are radii .* give each less their mean"
    ):
        dataclasses.replace(ROW, inner_shape=fourier_shape({0: 18.75, 2: 0.005}))
    # The mean radius less each is an oval with its crests, where there is least room, at 90 degrees to the load.
    small = (shape + fourier_shape({0: -27.75})).scaled(-1)
    oval = dataclasses.replace(ROW, outer_shape=fourier_shape({2: (0.005, math.pi / 2)}))
    loads = [
        nh.bearing.solve(each, radial=1e4, method="slices").load
        for each in (oval, dataclasses.replace(ROW, outer_shape=small))
    ]
    np.testing.assert_allclose(*loads, rtol=1e-4)


@pytest.mark.parametrize("degrees", [10.0, 30.0, 45.0])
@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_a_shape_of_order_zero_is_clearance_at_any_contact_angle(degrees, ring):
    """10 um along the radius take 20 um of the radial clearance (E - F - 2 D / cos alpha, see `clearance`)."""
    angle = math.radians(degrees)
    smooth = barrels(angle, 9.0, 10.0, 46.5, 13)
    shaped = dataclasses.replace(smooth, **{f"{ring}_shape": fourier_shape({0: 0.01})})
    still = {"axial_displacement": 0.0, "radial_displacement": 0.0, "method": "slices"}
    tight = nh.bearing.solve(dataclasses.replace(smooth, clearance=-0.02), **still)
    np.testing.assert_allclose(nh.bearing.solve(shaped, **still).load, tight.load, rtol=1e-9)


@pytest.mark.parametrize("washer", ["inner", "outer"])
def test_a_washer_that_is_higher_all_around_moves_the_shaft_along_the_axis(washer):
    plain = washers(9.0, 60.0, 12)
    higher = dataclasses.replace(plain, **{f"{washer}_shape": fourier_shape({0: 0.01})})
    flat, found = (nh.bearing.solve(each, axial=5e3, method="slices") for each in (plain, higher))
    assert found.displacement[0] == pytest.approx(flat.displacement[0] - 0.01, rel=1e-6)
    np.testing.assert_allclose(found.load, flat.load, rtol=1e-6)
