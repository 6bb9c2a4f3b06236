"""Bodies and contacts: where they are, how they are curved, and what is refused."""

import inspect
import math

import numpy as np
import pytest

import nonhertz as nh

Y = np.array([-4.0, 0.0, 2.5])


def roller(**changes):
    return nh.Roller(**({"diameter": 20.0, "length": 20.0} | changes))


# Where a body is


@pytest.mark.parametrize(
    ("body", "interval"),
    [
        (nh.Plate(), (-math.inf, math.inf)),
        (roller(), (-10.0, 10.0)),
        (roller(position=3.0), (-7.0, 13.0)),
        (roller(effective_length=18.0), (-9.0, 9.0)),
        (roller(effective_length=18.0, position=3.0), (-6.0, 12.0)),
        (nh.Plate(effective_length=18.0), (-9.0, 9.0)),
        (roller(profile=nh.profile.tabulated([-8.0, 9.5], [0.0, 0.0])), (-8.0, 9.5)),
        (roller(profile=nh.profile.tabulated([-8.0, 9.5], [0.0, 0.0]), position=3.0), (-5.0, 12.5)),
    ],
)
def test_interval_is_where_the_body_can_touch(body, interval):
    assert body.interval == interval


def test_position_moves_relief_and_bends():
    body = roller(profile=nh.profile.tapered_ends(straight=8.0, angle=0.01), position=1.0)
    np.testing.assert_allclose(body.relief([-4.0, 1.0, 6.0]), np.array([1.0, 0.0, 1.0]) * math.tan(0.01), rtol=1e-14)
    assert body.bends == (-3.0, 5.0)


# How it ends and how thick it is


@pytest.mark.parametrize(
    ("body", "faces", "weights", "depth"),
    [
        (nh.Body(diameter=20.0), (-math.inf, math.inf), (0.0, 0.0), "none"),
        (nh.Body(diameter=20.0, length=20.0), (-10.0, 10.0), (1.0, 1.0), "none"),
        (roller(), (-10.0, 10.0), (1.0, 1.0), "finite"),
        (roller(side_faces="mirror"), (-10.0, 10.0), (1.0, 1.0), "plane-strain"),
        (roller(length=400.0), (-200.0, 200.0), (1.0, 1.0), "plane-strain"),
        (nh.Ring(diameter=-80.0), (-math.inf, math.inf), (0.0, 0.0), "none"),
        (nh.Ring(diameter=-80.0, length=24.0), (-12.0, 12.0), (1.0, 1.0), "none"),
        (nh.Plate(), (-math.inf, math.inf), (0.0, 0.0), "none"),
        (nh.Plate(length=24.0), (-12.0, 12.0), (1.0, 1.0), "none"),
    ],
)
def test_what_ends_has_free_faces_and_a_roller_is_whole_where_it_can_be(body, faces, weights, depth):
    assert (body.faces, body.face_weights, body.images, body.behind.word) == (faces, weights, 1, depth)
    assert all(body.free_faces) == (body.length is not None and body.side_faces == "free")


def test_faces_are_those_of_the_body_not_of_the_length_that_touches():
    body = roller(position=3.0, effective_length=18.0, profile=nh.profile.tabulated([-8.0, 8.0], [0.0, 0.0]))
    assert body.faces == (-7.0, 13.0)


@pytest.mark.parametrize(
    ("rule", "weights"),
    [
        ("mirror", (1.0, 1.0)),
        ("calibrated", (1.6, 1.6)),
        ("none", (0.0, 0.0)),
        (1.25, (1.25, 1.25)),
        (0, (0.0, 0.0)),
        (("mirror", "none"), (1.0, 0.0)),
        (["calibrated", 0.5], (1.6, 0.5)),
    ],
    ids=str,
)
def test_weights_of_the_images_at_low_and_high_y(rule, weights):
    assert roller(side_faces=rule).face_weights == pytest.approx(weights, rel=1e-15)


@pytest.mark.parametrize(
    ("poisson", "weight"),
    [
        (-0.5, 1.10),
        (0.1, 0.5 * (1.10 + 1.35)),
        (0.28, 1.50),
        (0.365, 0.5 * (1.65 + 1.95)),
        (0.49, 1.95),
    ],
)
def test_the_calibrated_weight_goes_by_poissons_ratio_of_the_body(poisson, weight):
    body = roller(side_faces="calibrated", material=nh.Material(200e3, poisson))
    assert body.face_weights == pytest.approx((weight, weight), rel=1e-12)


@pytest.mark.parametrize(
    "body",
    [
        roller(images="series"),
        nh.Ring(diameter=-80.0, length=24.0, depth=5.0, images="series"),
        # A single face has a single image: nothing to sum.
        roller(images="series", depth="none", side_faces=("mirror", "none")),
        roller(images="series", depth="none", side_faces="none"),
    ],
    ids=["roller", "ring with a depth", "one face", "no face"],
)
def test_a_series_is_taken_where_it_has_a_sum(body):
    assert body.images == "series"


@pytest.mark.parametrize("diameter", [20.0, nh.TabulatedDiameter((-2.0, 2.0), (18.0, 22.0)), lambda y: 20.0 + y])
def test_any_convex_body_has_a_diameter_to_go_by(diameter):
    assert nh.Body(diameter=diameter, depth="diameter").depth == "diameter"


# How it is curved


@pytest.mark.parametrize(
    ("body", "curvature"),
    [
        (nh.Plate(), [0.0, 0.0, 0.0]),
        (roller(), [0.1, 0.1, 0.1]),
        (nh.Ring(diameter=-80.0), [-0.025, -0.025, -0.025]),
        (nh.Ring(diameter=lambda y: 20.0 + y), [2.0 / 16.0, 0.1, 2.0 / 22.5]),
        (nh.Ring(diameter=lambda y: 20.0 + y, position=1.0), [2.0 / 15.0, 2.0 / 19.0, 2.0 / 21.5]),
        (nh.Ring(diameter=nh.TabulatedDiameter((-2.0, 2.0), (18.0, 22.0))), [2.0 / 18.0, 0.1, 2.0 / 22.0]),
    ],
)
def test_curvature_across_the_contact(body, curvature):
    np.testing.assert_allclose(body.curvature(Y), curvature, rtol=1e-15, atol=0.0)


# Together


def test_a_contact_adds_both_bodies():
    # Different lengths, positions, curvatures, profiles and materials: each body counts for itself.
    a = roller(profile=nh.profile.crown(1000.0), material=nh.MATERIALS["silicon-nitride"], position=1.0)
    b = nh.Ring(diameter=-60.0, length=16.0, profile=nh.profile.conical(0.01), material=nh.MATERIALS["steel"])
    contact = nh.Contact(a, b)
    assert contact.interval == (-8.0, 8.0)
    np.testing.assert_allclose(contact.curvature(Y), 0.1 - 2.0 / 60.0, rtol=1e-14, atol=0.0)
    separation = nh.profile.crown(1000.0).relief(Y - 1.0) + math.tan(0.01) * Y
    np.testing.assert_allclose(contact.separation(Y), separation, rtol=1e-14, atol=0.0)
    # (1 - 0.26^2) / (pi 310000) + (1 - 0.3^2) / (pi 207000), worked out by hand.
    assert abs(contact.compliance - 2.356727e-6) < 1e-12


def test_a_contact_collects_the_bends_of_both_bodies_in_order():
    tapered = nh.profile.tapered_ends(straight=8.0, angle=0.01)
    contact = nh.Contact(roller(profile=tapered), nh.Plate(profile=tapered, position=1.0))
    assert contact.bends == (-4.0, -3.0, 4.0, 5.0)


# Refused, each with one sentence: "field = value must condition: remedy."


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda: roller(profile="crown"), "profile = 'crown' must be a Profile"),
        (lambda: roller(side_faces=True), "side_faces = True must be one of 'free', 'mirror', 'calibrated', 'none' or"),
        (lambda: roller(side_faces=("mirror",)), "side_faces = ('mirror',) must be one value or two"),
        (lambda: nh.Plate(side_faces=("mirror", "none")), "length must be given where side_faces = ('mirror', "),
        (lambda: roller(depth="paper"), "depth = 'paper' must be one of 'none', 'plane-strain', 'diameter', 'cylin"),
        (lambda: roller(images=0), "images = 0 must be 'series' or a whole number from 1 to 100"),
        (lambda: roller(images=True), "images = True must be 'series' or a whole number from 1 to 100"),
        (lambda: roller(images="series", depth="none"), "images = 'series' must only be used for a body with a depth"),
        (lambda: nh.Contact(roller(), "plate"), "b = 'plate' must be a Body"),
        (lambda: nh.Contact(roller()), "b must be given: make one with Roller, Ring, Plate or Body"),
        (lambda: nh.TabulatedDiameter((0.0,), (20.0,)), "y = (0.0,) must hold as many points as diameter, at least"),
        (lambda: nh.TabulatedDiameter((0.0, 0.0), (20.0, 20.0)), "y = (0.0, 0.0) must be finite and ascending"),
        (lambda: nh.TabulatedDiameter((0.0, 1.0), (20.0, -20.0)), "diameter = (20.0, -20.0) must be finite and of one"),
        (lambda: roller(diameter=nh.TabulatedDiameter((0.0, 1.0), (20.0, 0.0))), "diameter = (20.0, 0.0) must not be"),
    ],
)
def test_impossible_bodies_and_contacts_are_refused(make, complaint):
    with pytest.raises(nh.InputError) as refusal:
        make()
    assert str(refusal.value).startswith(complaint)


def test_values_without_names_are_refused_with_the_names():
    with pytest.raises(
        TypeError, match=r"^Roller takes its values by name: choose from 'material', 'diameter', 'bore'"
    ):
        nh.Roller(20, 20)


def test_the_signature_of_a_body_is_readable():
    assert "| collections.abc.Callable | None = None, bore: float |" in str(inspect.signature(nh.Roller))
    assert "_array_like" not in str(inspect.signature(nh.Roller))


def test_a_diameter_that_vanishes_somewhere_is_refused_when_asked_for():
    with pytest.raises(nh.InputError, match="must return a finite diameter other than zero for every y"):
        nh.Ring(diameter=lambda y: 4.0 + y).curvature(Y)


@pytest.mark.parametrize("rules", [["mirror", 0.5], np.array([1.0, 0.5])], ids=["list", "array"])
def test_a_pair_of_faces_is_kept_as_a_tuple(rules):
    body = roller(side_faces=rules)
    assert isinstance(body.side_faces, tuple)
    assert body.face_weights == (1.0, 0.5)
    assert hash(body) == hash(roller(side_faces=tuple(rules)))


def test_a_diameter_whose_curvature_no_double_can_hold_is_refused():
    cone = nh.TabulatedDiameter((-1.0, 1.0), (1e-320, 1.0))
    with pytest.raises(nh.InputError, match="a finite diameter other than zero"):
        nh.Body(diameter=cone, length=2.0).curvature([-1.0])
