"""Profiles by their drop at a place: every kind of the catalogue, and what no parameter makes."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nonhertz.errors import InputError
from nonhertz.model.profile import CATALOGUE, PARAMETERS, Profile, crown, with_drop
from nonhertz.model.profile.drop import parameter_from_drop

LENGTH = 20.0
AT = 9.5
ROLLER = {"diameter": 16.0, "length": LENGTH}
DESIGN = {"length": LENGTH, "radius": 8.0}
# The parameters that go with a drop, for every parameter that it can determine in every kind.
GIVEN: dict[tuple[str, str], dict[str, Any]] = {
    ("crown", "radius"): {},
    ("partial-crown", "radius"): {"straight": 12.0},
    ("partial-crown", "straight"): {"radius": 1500.0},
    ("two-radius", "end_radius"): {"radius": 50e3, "middle": 12.0},
    ("two-radius", "radius"): {"end_radius": 2000.0, "middle": 12.0},
    ("logarithmic", "amplitude"): {"length": LENGTH},
    ("lundberg", "load"): DESIGN,
    ("johns-gohar", "load"): DESIGN,
    ("fujiwara-kawase", "load"): {"length": LENGTH, "zm": 0.01, "k2": 0.7},
    ("fujiwara-kawase", "zm"): {"length": LENGTH, "load": 20e3, "k1": 1.5},
    ("iso-logarithmic", "scale"): ROLLER,
    ("iso-tapered", "scale"): ROLLER,
    ("iso-thrust", "scale"): ROLLER,
    ("conical", "angle"): {},
    ("tapered-ends", "angle"): {"straight": 14.0},
    ("tapered-ends", "straight"): {"angle": 0.002},
    ("chamfer", "angle"): {"length": LENGTH, "width": 3.0},
    ("chamfer", "width"): {"length": LENGTH, "angle": 0.002},
    ("tabulated", "scale"): {"y": [-10.0, 0.0, 10.0], "relief": [0.01, 0.002, 0.02]},
}


def drop_of(profile: Profile, at: float) -> float:
    there, middle = profile.relief([at, 0.0])
    return float(there - middle)


def test_every_kind_and_every_parameter_is_tried():
    expected = {(kind, name) for kind in CATALOGUE for name in PARAMETERS[kind].by_drop or ("scale",)}
    assert set(GIVEN) == expected - {("straight", "scale")}


@pytest.mark.parametrize(("kind", "name"), GIVEN)
@pytest.mark.parametrize("drop", [0.004, 0.006])
def test_the_relief_at_the_place_is_the_stated_one(kind, name, drop):
    parameters = GIVEN[kind, name]
    assert parameter_from_drop(kind, parameters) == name
    made = with_drop(kind, drop, AT, **parameters)
    assert drop_of(made, AT) == pytest.approx(drop, rel=1e-12, abs=1e-12 * 0.02)
    if name == "scale":
        # Nothing but the size differs from the profile that the parameters make.
        y, whole = np.linspace(-9.9, 9.9, 23), CATALOGUE[kind](**parameters)
        np.testing.assert_allclose(made.relief(y) / made.relief(AT), whole.relief(y) / whole.relief(AT), rtol=1e-12)
    else:
        assert made.catalogue_entry is not None
        assert made == CATALOGUE[kind](**parameters, **{name: made.catalogue_entry[1][name]})


def test_the_radius_of_a_crown_is_that_of_the_circle_through_three_points():
    entry = with_drop("crown", 0.02, AT).catalogue_entry
    assert entry is not None
    assert entry[1]["radius"] == pytest.approx((AT**2 + 0.02**2) / 0.04, rel=1e-13)
    hollow = with_drop("crown", -0.02, AT).catalogue_entry
    assert hollow is not None
    assert hollow[1]["radius"] == pytest.approx(-(AT**2 + 0.02**2) / 0.04, rel=1e-13)


def test_a_place_on_the_other_side_counts_there():
    assert drop_of(with_drop("crown", 0.02, -AT, centre=1.0), -AT) == pytest.approx(0.02, rel=1e-12)
    assert drop_of(with_drop("conical", 0.02, -AT), AT) == pytest.approx(-0.02, rel=1e-12)


@pytest.mark.slow
@settings(deadline=None)
@given(radius=st.floats(30.0, 1e6), at=st.floats(0.1, 20.0), centre=st.floats(-0.04, 0.04))
def test_a_crown_is_found_from_its_drop(radius, at, centre):
    profile = crown(radius, centre)
    entry = with_drop("crown", drop_of(profile, at), at, centre=centre).catalogue_entry
    assert entry is not None
    # The drop is a difference of two reliefs, the smaller of which is up to a sixth of the larger.
    assert entry[1]["radius"] == pytest.approx(radius, rel=1e-11)


@pytest.mark.parametrize(
    ("arguments", "parameters", "sentence"),
    [
        (("crown", 30.0, AT), {}, "drop = 30.0 must lie between about -6.88 and 6.88 mm, the drops that any radius"),
        (("crown", 0.0, AT), {}, "drop = 0.0 must not be zero, which no radius of 'crown' gives: leave the profile"),
        (("crown", 0.02, AT), {"radius": 3e3}, "drop = 0.02 must not be given together with radius: leave one out."),
        (("crown", 0.02, 0.0), {}, "at = 0.0 must not be the middle of the body: give the position in mm"),
        (("crown", 0.02, 1e50), {}, "at = 1e+50 must be where some radius of 'crown' has a finite relief: "),
        (("crown", 0.02, AT), {"radus": 3000.0}, "Unknown parameter radus of 'crown'. Did you mean radius?"),
        (("crwn", 0.02, AT), {}, "kind = 'crwn' must be one of 'crown', "),
        (("partial-crown", 0.02, AT), {}, "straight must be given, because the drop determines radius: "),
        (("partial-crown", 0.02, 5.0), {"straight": 12.0}, "at = 5.0 must be where the radius of 'partial-crown' ch"),
        (("two-radius", 0.02, 5.0), {"radius": 5e3, "middle": 12.0}, "at = 5.0 must be where the end_radius of "),
        (("logarithmic", -0.02, AT), {"length": LENGTH}, "drop = -0.02 must not make amplitude = -0.00859, which in"),
        (("logarithmic", 0.02, 10.0), {"length": LENGTH}, "at = 10.0 must be where 'logarithmic' has a finite relief"),
        (("iso-tapered", 0.02, 10.0), ROLLER, "at = 10.0 must be where 'iso-tapered' has a finite relief: give a pl"),
        (("chamfer", 0.3, AT), {"length": LENGTH, "angle": 0.7, "width": 1.0}, "drop = 0.3 must not be given together"),
        (("fujiwara-kawase", 0.2, AT), {"load": 2e4, "length": LENGTH}, "drop = 0.2 must lie between about 9.02e-13 "),
        (("lundberg", 20.0, AT), DESIGN, "drop = 20.0 must lie between about 3.26e-19 and 3.14 mm, the drops that "),
        (("straight", 0.02, AT), {}, "drop = 0.02 must be left out of 'straight', which has no relief: "),
        (("tabulated", 0.02, AT), {"y": [1.0, 9.9], "relief": [0.0, 1.0]}, "at = 9.5 must be where 'tabulated' has"),
    ],
)
def test_what_no_parameter_makes_is_refused_in_a_sentence(arguments, parameters, sentence):
    with pytest.raises(InputError) as caught:
        with_drop(*arguments, **parameters)
    assert str(caught.value).startswith(sentence)
    assert "\n" not in str(caught.value)


def test_a_table_is_scaled_about_its_own_middle():
    y, relief = [-10.0, 0.0, 10.0], [0.01, 0.002, 0.02]
    made = with_drop("tabulated", 0.05, 10.0, y=y, relief=relief, interpolation="linear")
    np.testing.assert_allclose(made.relief(y), np.array(relief) * 0.05 / 0.018, rtol=1e-14)
