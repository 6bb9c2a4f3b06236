"""What a machine's zero, tilt and direction have no part in: the profile that comes out."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from nonhertz.errors import InputError
from nonhertz.files.traces import read_trace
from nonhertz.measured import Trace, prepare

Y = np.linspace(-5.0, 5.0, 2001)


def line(radius: float, seed: int) -> np.ndarray:
    rough = 1e-4 * np.random.default_rng(seed).standard_normal(len(Y))
    return -(Y**2) / (2.0 * radius) - np.maximum(np.abs(Y) - 4.6, 0.0) + rough


@settings(max_examples=25, deadline=None)
@given(
    radius=st.floats(200.0, 5000.0),
    seed=st.integers(0, 1000),
    lean=st.floats(-0.02, 0.02),
    at=st.floats(-50.0, 50.0),
    up=st.floats(-3.0, 3.0),
)
@pytest.mark.slow
def test_tilt_and_zeros_of_the_machine_do_not_matter(radius, seed, lean, at, up):
    height = line(radius, seed)
    plain = prepare(Trace(Y, height))
    moved = prepare(Trace(Y + at, height + lean * Y + up))
    # Medians of slopes take the tilt exactly; what is left is rounding of positions of 50 mm and heights of 3 mm.
    assert_allclose(moved.points.y, plain.points.y, atol=1e-9)
    assert_allclose(moved.relief, plain.relief, atol=1e-9)


@settings(max_examples=25, deadline=None)
@given(radius=st.floats(200.0, 5000.0), seed=st.integers(0, 1000))
@pytest.mark.slow
def test_the_other_way_round_it_is_the_mirror_image(radius, seed):
    height = line(radius, seed)
    forth, back = prepare(Trace(Y, height)), prepare(Trace(Y, height[::-1]))
    assert len(forth.points) == len(back.points)
    # A median of an even number of slopes is one of the two in the middle, which differ by less than a microradian,
    # and so do the ends of the land, by a step of 5 um.
    assert_allclose(back.relief[::-1], forth.relief, atol=1e-5)


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200) | st.text("0123456789.,;- \t\n\rnaeE[]umz*", max_size=200).map(str.encode))
def test_whatever_is_read_ends_in_a_trace_or_one_sentence(data):
    refused = ""
    try:
        trace = read_trace(data, "fuzz")
    except InputError as error:
        refused = str(error)
    if refused:
        assert "\n" not in refused
    else:
        assert np.all(np.isfinite(trace.height))
        assert np.all(np.diff(trace.y) > 0.0)
