"""What a machine's zero, tilt and direction have no part in: the profile that comes out."""

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from nonhertz.errors import InputError
from nonhertz.files.traces import read_trace
from nonhertz.measured import Trace, prepare

Y = np.linspace(-5.0, 5.0, 1001)


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
    assert_allclose(back.relief[::-1], forth.relief, atol=1e-9)


@settings(max_examples=40, deadline=None)
@given(
    radius=st.floats(300.0, 5000.0),  # nowhere as steep as a chamfer
    count=st.integers(101, 2001),
    length=st.sampled_from([1.0, 10.0, 12.5, 40.0]),
    at=st.floats(0.02, 0.98),
    height=st.sampled_from([0.0, 2e-3, 5e-3, 0.01, 0.019, 0.02, 0.021, 0.03, 0.1, 0.18]),
    down=st.booleans(),
    lean=st.floats(-3e-3, 3e-3),
    noise=st.sampled_from([0.0, 1e-5, 1e-4]),
    uneven=st.booleans(),
    slope=st.sampled_from([0.05, 0.5]),
    seed=st.integers(0, 1000),
)
@example(300.0, 101, 12.5, 0.02, 0.01, False, 0.0, 0.0, False, 0.05, 0)  # a run as wide as the widest that is removed
def test_a_step_is_the_same_from_either_side(radius, count, length, at, height, down, lean, noise, uneven, slope, seed):
    """The same points are kept and fitted, the same is warned of, and nothing is left out without a word."""
    assume(height < 0.02 or abs(at - 0.5) > 0.02)  # of two stretches of one length either may be the land
    random = np.random.default_rng(seed)
    y = np.linspace(0.0, length, count)
    y = np.sort(y + uneven * random.uniform(-0.3, 0.3, count) * length / count)
    z = -((y - 0.49 * length) ** 2) / (0.2 * radius * length) + lean * y + noise * random.standard_normal(count)
    z += (-height if down else height) * (y < at * length)
    traces = Trace(y, z), Trace(length - y[::-1], z[::-1])
    forth, back = (prepare(trace, slope=slope, smooth=False, points=False) for trace in traces)
    assert_allclose(forth.points.y, -back.points.y[::-1], atol=1e-9 * length)
    assert_allclose(forth.points.height, back.points.height[::-1], atol=1e-9)
    warned = [sorted(found.kind for found in each.findings_for()) for each in (forth, back)]
    assert warned[0] == warned[1]
    # What is shorter than the surface beside a step, 2 % or six points, and a chord is an end, not a stretch.
    if forth.trace.span - forth.points.span > length * (0.025 + 9.0 / count):
        assert "surface-step" in warned[0]
    one, other = (each.fit("crown").rms for each in (forth, back))
    # Of a line with a step the least is flat, and least squares end somewhere in it.
    assert_allclose(one, other, rtol=1e-4, atol=1e-8)


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
