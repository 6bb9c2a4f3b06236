"""Bodies and contacts: where they are, how they are curved, and what is refused."""

import dataclasses
import math
import re

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


def test_bodies_and_contacts_are_values():
    assert roller() == roller()
    contact = nh.Contact(roller(), nh.Plate())
    assert contact == nh.Contact(roller(), nh.Plate())
    shorter = dataclasses.replace(contact.a, length=16.0)
    assert (shorter.length, contact.a.length) == (16.0, 20.0)
    with pytest.raises(dataclasses.FrozenInstanceError):
        contact.a.length = 1.0


# Refused, each with one sentence: "field = value must condition: remedy."


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda: roller(length=-5.0), "length = -5.0 must be positive"),
        (lambda: roller(length=math.nan), "length = nan must be a finite number"),
        (lambda: roller(length=None), "length = None must be given"),
        (lambda: roller(diameter=0.0), "diameter = 0.0 must not be zero"),
        (lambda: roller(diameter=math.inf), "diameter = inf must be a finite number"),
        (lambda: roller(diameter=-20.0), "diameter = -20.0 must be positive"),
        (lambda: nh.Ring(length=20.0), "diameter = None must be given"),
        (lambda: nh.Plate(diameter=20.0), "diameter = 20.0 must be left out"),
        (lambda: roller(material="steel"), "material = 'steel' must be a Material"),
        (lambda: roller(profile="crown"), "profile = 'crown' must be a Profile"),
        (lambda: roller(position=math.nan), "position = nan must be a finite number"),
        (lambda: roller(effective_length=0.0), "effective_length = 0.0 must be positive"),
        (
            lambda: roller(effective_length=21.0),
            "effective_length = 21.0 must not exceed the length of 20.0 mm",
        ),
        (lambda: roller(side_faces="mirror"), "side_faces = 'mirror' must be one of 'none'"),
        (lambda: roller(depth="paper"), "depth = 'paper' must be one of 'none'"),
        (lambda: nh.Contact(roller(), "plate"), "b = 'plate' must be a Body"),
        (
            lambda: nh.Contact(roller(), roller(position=20.0)),
            "position = 20.0 must let the bodies overlap along y",
        ),
        (
            lambda: nh.TabulatedDiameter((0.0,), (20.0,)),
            "y = (0.0,) must hold as many points as diameter, two at least",
        ),
        (
            lambda: nh.TabulatedDiameter((0.0, 0.0), (20.0, 20.0)),
            "y = (0.0, 0.0) must be finite and ascend",
        ),
        (
            lambda: nh.TabulatedDiameter((0.0, math.nan), (20.0, 20.0)),
            "y = (0.0, nan) must be finite and ascend",
        ),
        (
            lambda: nh.TabulatedDiameter((0.0, 1.0), (20.0, -20.0)),
            "diameter = (20.0, -20.0) must be finite and of one sign",
        ),
        (
            lambda: nh.TabulatedDiameter((0.0, 1.0), (20.0, math.nan)),
            "diameter = (20.0, nan) must be finite and of one sign",
        ),
        (
            lambda: nh.Contact(roller(), nh.Ring(diameter=-20.0)).curvature(Y),
            "diameter = (20.0, -20.0) must leave a positive combined curvature",
        ),
        (
            lambda: nh.Contact(nh.Plate(length=20.0), nh.Plate()).curvature(Y),
            "diameter = (None, None) must leave a positive combined curvature",
        ),
    ],
)
def test_impossible_bodies_and_contacts_are_refused(make, complaint):
    with pytest.raises(nh.InputError) as refusal:
        make()
    said, _, remedy = str(refusal.value).partition(": ")
    assert said == complaint
    assert re.fullmatch(r"[a-z].*[^.]\.", remedy)


def test_a_diameter_that_vanishes_somewhere_is_refused_when_asked_for():
    with pytest.raises(nh.InputError, match="must return a finite diameter other than zero for every y"):
        nh.Ring(diameter=lambda y: 4.0 + y).curvature(Y)
