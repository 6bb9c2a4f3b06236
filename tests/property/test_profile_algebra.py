"""Laws that hold for every profile: adding, shifting, scaling, flipping, mirror symmetry, similarity."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nonhertz.model.profile import (
    chamfer,
    conical,
    crown,
    fujiwara_kawase,
    iso_logarithmic,
    iso_tapered,
    johns_gohar,
    logarithmic,
    lundberg,
    partial_crown,
    straight,
    tabulated,
    tapered_ends,
    two_radius,
)
from nonhertz.model.profile.base import at_ends

# The first profile of some kinds imports scipy, which may take longer than an example is allowed to.
untimed = settings(deadline=None)
LENGTH = 20.0
Y = np.linspace(-0.5 * LENGTH, 0.5 * LENGTH, 81)


def number(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False)


radii = number(50.0, 1e5)
loads = number(10.0, 1e5)
symmetric = st.one_of(
    st.just(straight()),
    st.builds(crown, radii),
    st.builds(partial_crown, radii, number(0.0, LENGTH), st.booleans()),
    st.builds(two_radius, radii, radii, number(0.1, LENGTH)),
    st.builds(logarithmic, number(0.0, 0.1), st.just(LENGTH), number(0.1, 1.0)),
    st.builds(lundberg, loads, st.just(LENGTH), number(1.0, 20.0)),
    st.builds(johns_gohar, loads, st.just(LENGTH), number(1.0, 20.0)),
    st.builds(
        lambda load, k1, k2, zm: fujiwara_kawase(load, LENGTH, k1=k1, k2=k2, zm=zm),
        loads,
        number(0.1, 10.0),
        number(0.05, 1.0),
        number(1e-4, 0.2),
    ),
    st.builds(iso_logarithmic, number(1.0, 40.0), st.just(LENGTH)),
    st.builds(iso_tapered, number(1.0, 40.0), st.just(LENGTH)),
    st.builds(tapered_ends, number(0.0, LENGTH), number(0.0, 0.1)),
    st.builds(chamfer, st.just(LENGTH), number(0.01, 5.0)),
)
tables = st.builds(
    lambda y, relief, kind: tabulated(y[: len(relief)], relief[: len(y)], kind),
    st.lists(st.integers(-100, 100), min_size=2, max_size=12, unique=True).map(
        lambda tenths: [0.1 * tenth for tenth in tenths]
    ),
    st.lists(number(-0.1, 0.1), min_size=2, max_size=12),
    st.sampled_from(["pchip", "linear"]),
)
profiles = st.one_of(symmetric, st.builds(conical, number(-0.1, 0.1)), tables)


@untimed
@given(profiles, profiles)
def test_reliefs_add_in_any_order(a, b):
    expected = a.relief(Y) + b.relief(Y)
    np.testing.assert_array_equal((a + b).relief(Y), expected)
    np.testing.assert_array_equal((b + a).relief(Y), expected)
    assert (a + b).bends == (b + a).bends
    assert (a + b).extent == (b + a).extent


@untimed
@given(profiles, number(-30.0, 30.0))
def test_shift_moves_relief_bends_and_extent(profile, by):
    moved = profile.shifted(by)
    # Where the plain difference is within a rounding of an end, it is the end.
    np.testing.assert_array_equal(moved.relief(Y), profile.relief(at_ends(Y - by, profile.extent)))
    assert moved.bends == tuple(bend + by for bend in profile.bends)
    assert moved.extent == tuple(end + by for end in profile.extent)


@untimed
@given(profiles, number(-10.0, 10.0))
def test_scale_multiplies_what_is_finite(profile, by):
    relief, scaled = profile.relief(Y), profile.scaled(by).relief(Y)
    present = np.isfinite(relief)
    np.testing.assert_array_equal(scaled[present], by * relief[present])
    assert np.all(scaled[~present] == np.inf)


@untimed
@given(profiles, number(-30.0, 30.0), number(-2.0, 2.0))
def test_flipping_mirrors_relief_bends_and_extent(profile, by, factor):
    made = (profile.shifted(by).scaled(factor)) + crown(500.0, 2.0)
    flipped = made.flipped()
    np.testing.assert_array_equal(flipped.relief(Y), made.relief(-Y))
    assert flipped.bends == tuple(sorted(-bend for bend in made.bends))
    assert flipped.crests == tuple(sorted(-crest for crest in made.crests))
    assert flipped.extent == tuple(-end for end in made.extent[::-1])
    assert flipped.flipped() == made


@untimed
@given(symmetric)
def test_both_sides_are_alike_and_fall_off(profile):
    relief = profile.relief(Y)
    np.testing.assert_allclose(relief, relief[::-1], rtol=1e-12, atol=1e-17)
    assert relief[40] == pytest.approx(0.0, abs=1e-15)
    outwards = relief[40:]
    with np.errstate(invalid="ignore"):  # inf - inf beyond the end of a curve
        assert not np.any(np.diff(outwards) < -1e-14)


@untimed
@given(number(0.1, 10.0), loads, number(1.0, 20.0), number(1.0, 30.0), number(0.5, 2.0))
def test_twice_the_size_is_twice_the_relief(size, load, radius, diameter, k1):
    # All lengths by one factor and loads by its square leave stresses and shapes as they were.
    y = np.linspace(-9.9, 9.9, 41)

    def pairs(make, lengths, loads=(), **fixed):  # type: ignore[no-untyped-def]
        scaled = {name: size * value for name, value in lengths.items()}
        scaled |= {name: size**2 * value for name, value in dict(loads).items()}
        return make(**lengths, **dict(loads), **fixed), make(**scaled, **fixed)

    for small, large in (
        pairs(crown, {"radius": 100.0 * radius}),
        pairs(two_radius, {"radius": 100.0 * radius, "end_radius": 50.0 * radius, "middle": 9.0}),
        pairs(iso_logarithmic, {"diameter": diameter, "length": LENGTH}),
        pairs(lundberg, {"length": LENGTH, "radius": radius}, {"load": load}),
        pairs(johns_gohar, {"length": LENGTH, "radius": radius}, {"load": load}),
        pairs(fujiwara_kawase, {"length": LENGTH, "radius": radius}, {"load": load}, k1=k1, k2=0.7),
        pairs(chamfer, {"length": LENGTH, "width": 1.0}),
    ):
        np.testing.assert_allclose(large.relief(size * y), size * small.relief(y), rtol=1e-9, atol=1e-13 * size)


@untimed
@given(loads, number(1.0, 20.0))
def test_lundberg_and_johns_gohar_tell_nearly_the_same(load, radius):
    exact, fitted = lundberg(load, LENGTH, radius), johns_gohar(load, LENGTH, radius)
    difference = np.abs(exact.relief(Y) - fitted.relief(Y))
    # Found for a half-width of 0.002 to 1.1: 0.103 amplitudes, half a half-width before the end.
    assert np.max(difference) < 0.104 * exact.amplitude
    assert math.isfinite(float(fitted.relief(0.5 * LENGTH)))
