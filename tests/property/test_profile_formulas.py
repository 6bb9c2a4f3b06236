"""Every profile of the catalogue is a formula in C++, which gives the relief of its class in Python."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_profile_algebra import LENGTH, number, profiles, untimed

from nonhertz import Body, Chamfer, InputError
from nonhertz.bodies.formulas import relief_of, relief_of_body
from nonhertz.model.profile import CATALOGUE, Arcs, Profile, crown, iso_thrust, tabulated
from nonhertz.model.profile.base import Sum

splines = st.builds(
    lambda y, relief: tabulated(y, relief[: len(y)], "cubic"),
    st.lists(st.integers(-100, 100), min_size=3, max_size=8, unique=True).map(lambda tenths: [0.1 * t for t in tenths]),
    st.lists(number(-0.1, 0.1), min_size=8, max_size=8),
)
simple = st.one_of(profiles, splines, st.builds(iso_thrust, number(1.0, 40.0), st.just(LENGTH)))
composed = st.recursive(
    simple,
    lambda parts: st.one_of(
        st.builds(lambda a, b: a + b, parts, parts),
        st.builds(lambda of, by: of.shifted(by), parts, number(-3.0, 3.0)),
        st.builds(lambda of, by: of.scaled(by), parts, st.sampled_from([-1.5, 0.0, 0.3, 1.0])),
        st.builds(lambda of: of.flipped(), parts),
    ),
    max_leaves=4,
)
corners = st.one_of(
    st.builds(lambda radius: {"corner_radius": radius}, number(1e-3, 2.0)),
    st.builds(lambda angle, blend: {"chamfer": Chamfer(1.0, angle, blend)}, number(0.05, 1.0), number(0.0, 1.0)),
)
places = st.lists(number(-12.0, 12.0), min_size=1, max_size=30)


def assert_the_same(profile: Profile, found: np.ndarray, expected: np.ndarray) -> None:
    """Infinite at the same places, and elsewhere the relief within 1e-12 of itself.

    Where large reliefs leave a small one, it is within 1e-14 of the largest of all: logarithms differ in their last
    digit from one library to another.
    """
    np.testing.assert_array_equal(np.isinf(found), np.isinf(expected))
    present = np.isfinite(expected)
    np.testing.assert_allclose(found[present], expected[present], rtol=1e-12, atol=1e-14 * largest(profile))


def largest(profile: Profile) -> float:
    """Return the largest relief in magnitude that a profile adds up, in its extent."""
    parts = profile.parts if isinstance(profile, Sum) else (profile,)
    y = np.linspace(-15.0, 15.0, 401)
    reliefs = [part.relief(np.clip(y, *part.extent)) for part in parts]
    return max((float(np.abs(relief[np.isfinite(relief)]).max(initial=0.0)) for relief in reliefs), default=0.0)


@untimed
@given(composed, places)
def test_formulas_are_those_of_python(profile, y):
    y = np.array(y)
    assert_the_same(profile, relief_of(profile)(y), profile.relief(y))


@untimed
@given(composed, corners, st.sampled_from([0.0, 3.0]), places)
def test_corners_are_those_of_python(profile, corner, position, y):
    try:
        body = Body(length=LENGTH, profile=profile, position=position, **corner)
    except InputError:  # corners that leave no land, and profiles that end on it
        return
    y = np.array(y) + position
    assert_the_same(profile, relief_of_body(body)(y), body.relief(y))


def test_the_end_of_a_moved_table_is_where_the_body_ends():
    # 0.1 + 0.2 is not 0.3: a plain difference of positions would put the end outside.
    relief = relief_of(tabulated([-0.1, 0.1], [0.0, 0.01]).shifted(0.2))
    assert np.all(np.isfinite(relief(np.array([0.1 + 0.2, 0.3, 0.2 - 0.1]))))
    assert np.all(np.isinf(relief(np.array([0.31, 0.09]))))


def test_no_profile_of_the_catalogue_is_called_in_python(monkeypatch):
    examples = {
        "straight": {},
        "crown": {"radius": 900.0, "centre": 0.5},
        "partial-crown": {"radius": 900.0, "straight": 8.0},
        "two-radius": {"radius": 900.0, "end_radius": 90.0, "middle": 8.0},
        "logarithmic": {"amplitude": 0.005, "length": 20.0},
        "iso-logarithmic": {"diameter": 10.0, "length": 20.0},
        "iso-tapered": {"diameter": 10.0, "length": 20.0},
        "iso-thrust": {"diameter": 10.0, "length": 20.0},
        "johns-gohar": {"load": 1e4, "length": 20.0, "radius": 10.0},
        "fujiwara-kawase": {"load": 1e4, "length": 20.0, "radius": 10.0},
        "lundberg": {"load": 1e4, "length": 20.0, "radius": 10.0},
        "conical": {"angle": 1e-3},
        "tapered-ends": {"straight": 8.0, "angle": 1e-3},
        "chamfer": {"length": 20.0, "width": 1.0},
        "tabulated": {"y": [-10.0, 0.0, 10.0], "relief": [0.01, 0.0, 0.01]},
    }
    assert examples.keys() == CATALOGUE.keys()
    made = {kind: CATALOGUE[kind](**values) for kind, values in examples.items()}
    summed = (made["crown"] + made["logarithmic"]).scaled(2.0) + made["iso-tapered"].flipped()
    # Chamfers of the profile leave no room for corners.
    cornered = [Body(length=20.0, profile=made[kind], corner_radius=1.0).surface for kind in made if kind != "chamfer"]
    reliefs, y = [*made.values(), summed, *cornered], np.array([2.0, -9.5])
    expected, formulas = [profile.relief(y) for profile in reliefs], [relief_of(profile) for profile in reliefs]
    for cls in {*map(type, reliefs), *map(type, summed.parts)}:
        monkeypatch.setattr(cls, "relief_at", None)
    np.testing.assert_allclose([formula(y) for formula in formulas], expected, rtol=1e-12, atol=0.0)


class Raised(Arcs):
    """A class of the user's, derived from one that has a formula."""

    def relief(self, y):
        return self.radius + super().relief(y)


class RaisedAtPlaces(Raised):
    """One more, which redefines what the solver calls."""

    def relief_at(self, y):
        return 1.0 + super().relief_at(y)


class RaisedTwice(Raised):
    """One more, which redefines what everybody calls."""

    def relief(self, y):
        return 1.0 + super().relief(y)


@pytest.mark.parametrize(("cls", "by"), [(Raised, 700.0), (RaisedAtPlaces, 701.0), (RaisedTwice, 701.0)])
def test_a_class_derived_from_one_of_the_catalogue_has_its_own_relief(cls, by):
    profile, base = (of(700.0, 900.0, 8.0, 0.0) for of in (cls, Arcs))
    y = np.array([0.0, 5.0])
    for summed in (profile, profile + crown(800.0)):
        np.testing.assert_array_equal(relief_of(summed)(y), summed.relief(y))
    np.testing.assert_array_equal(profile.relief(y.tolist()), by + base.relief(y))
