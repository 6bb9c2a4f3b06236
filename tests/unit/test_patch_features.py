"""Dents, waves and slanted chamfers: what they take away where, and what they refuse."""

import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.patch import ChamferRun, Dent, Waviness


def test_a_dent_is_deepest_in_its_middle_round_and_ends_smoothly():
    dent = Dent(x=0.1, y=-2.0, depth=0.003, diameter=0.4)
    # cos^2 of 0, 1/4, 1/2 of a right angle twice: 1, 1/2, 0.
    found = dent(np.array([0.1, 0.2, 0.3, 0.5]), -2.0)
    np.testing.assert_allclose(found, [0.003, 0.0015, 0.0, 0.0], rtol=0.0, atol=1e-17)  # rounding
    step = 1e-6
    assert abs(float(dent(0.3, -2.0) - dent(0.3 - step, -2.0))) < 1e-6 * step  # of 0.02 at mid-slope
    # The shoulder is material left standing, highest half way, 0.3 from the middle.
    shoulder = Dent(depth=0.003, diameter=0.4, shoulder=0.0006, shoulder_diameter=0.8)
    np.testing.assert_allclose(shoulder(0.0, [0.2, 0.3, 0.4, 9.0]), [0.0, -0.0006, 0.0, 0.0], rtol=0.0, atol=1e-17)
    around = np.linspace(0.0, 2.0 * math.pi, 13)
    for away in (0.1, 0.25):
        relief = shoulder(away * np.cos(around), away * np.sin(around))
        np.testing.assert_allclose(relief, relief[0], rtol=1e-12, atol=0.0)  # rounding of the angles


@pytest.mark.parametrize(
    ("direction", "x", "y"),
    [("across", 0.25, 0.0), ("along", 0.0, 0.25), (math.pi / 4.0, 0.25 / math.sqrt(2.0), 0.25 / math.sqrt(2.0))],
)
def test_waves_run_in_their_direction(direction, x, y):
    waves = Waviness(amplitude=0.001, wavelength=0.5, direction=direction)
    # A crest at the origin, a valley half a wave on, nothing changes at right angles.
    np.testing.assert_allclose([waves(0.0, 0.0), waves(x, y)], [0.0, 0.002], rtol=0.0, atol=1e-16)
    np.testing.assert_allclose(waves(x - 7.0 * y, y + 7.0 * x), 0.002, rtol=1e-12, atol=0.0)


def test_the_phase_moves_the_crest():
    waves = Waviness(amplitude=0.001, wavelength=0.5, phase=math.pi)
    np.testing.assert_allclose(waves(0.0, 3.0), 0.002, rtol=1e-15, atol=0.0)


@pytest.mark.parametrize("end", [1.0, -1.0])
def test_a_chamfer_runs_out_to_its_end_along_a_slanted_edge(end):
    chamfer = ChamferRun(start=end * 9.0, slope=0.1, skew=0.5)
    # At x = 0.4 the edge has moved by 0.2 towards high y.
    np.testing.assert_allclose(
        [chamfer(0.0, 8.9 * end), chamfer(0.0, 9.5 * end), chamfer(0.4, 9.5 * end + 0.2)],
        [0.0, 0.05, 0.05],
        rtol=1e-12,
        atol=0.0,
    )


def test_a_rounded_corner_is_smooth_and_leaves_the_rest():
    sharp, round_ = ChamferRun(start=9.0, slope=0.1), ChamferRun(start=9.0, slope=0.1, blend=0.2)
    y = np.array([8.7, 8.8, 9.2, 9.5])
    np.testing.assert_allclose(round_(0.0, y), sharp(0.0, y), rtol=1e-12, atol=1e-17)
    np.testing.assert_allclose(round_(0.0, 9.0), 0.1 * 0.2 / 4.0, rtol=1e-12, atol=0.0)
    step = 1e-7
    for corner in (8.8, 9.2):
        before, after = (round_(0.0, corner + s * step) - round_(0.0, corner) for s in (-1, 1))
        assert abs(float(before + after)) < 1e-12  # slopes agree to second order of the step


@pytest.mark.parametrize(
    ("feature", "values", "sentence"),
    [
        (Dent, {"depth": 1.0, "diameter": 2.0, "shoulder_diameter": 1.5}, "shoulder_diameter = 1.5 must exceed"),
        (Waviness, {"amplitude": 1.0, "wavelength": 1.0, "direction": "up"}, "direction = 'up' must be a finite"),
        (ChamferRun, {"start": 0.0, "slope": 0.1}, "start = 0.0 must not be zero"),
    ],
)
def test_what_is_refused(feature, values, sentence):
    with pytest.raises(nh.InputError) as caught:
        feature(**values)
    assert str(caught.value).startswith(sentence)
