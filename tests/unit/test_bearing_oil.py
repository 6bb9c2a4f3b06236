"""Viscosity at a temperature and cleanliness, against public figures."""

import math

import pytest

import nonhertz as nh
from nonhertz.bearing import contamination_factor, oil_viscosity


def test_the_viscosities_given_are_met_in_either_order():
    for at, expected in ((40, 46.0), (100, 6.8)):
        assert oil_viscosity(at, viscosities=(46.0, 6.8)) == pytest.approx(expected, rel=1e-12)
        turned = oil_viscosity(at, viscosities=(6.8, 46.0), temperatures=(100, 40))
        assert turned == pytest.approx(expected, rel=1e-12)
    # On paper for viscosities an oil is a straight line, whichever two points of it are known.
    middle = oil_viscosity(70, viscosities=(46.0, 6.8))
    assert oil_viscosity(100, viscosities=(46.0, middle), temperatures=(40, 70)) == pytest.approx(6.8, rel=1e-12)


@pytest.mark.parametrize(
    ("temperature", "given", "message"),
    [
        (-300, {"viscosities": (46, 6.8)}, "temperature = -300 must lie above -273.15 degC"),
        (300, {"viscosities": (46, 6.8)}, "temperature = 300 must leave the oil with more than 2 mm2/s"),
        (-270, {"viscosities": (46, 6.8)}, "temperature = -270 must leave the oil with more than 2 mm2/s"),
        (
            70,
            {"viscosities": (6.8, 46)},
            "viscosities = (6.8, 46) must exceed 2 mm2/s and be lower at the higher temperature",
        ),
        (70, {"viscosities": (46, 1.5)}, "viscosities = (46, 1.5) must exceed 2 mm2/s"),
        (70, {"viscosities": (46, 6.8), "temperatures": (40, 40)}, "temperatures = (40, 40) must differ"),
    ],
)
def test_impossible_oils_are_refused_in_one_sentence(temperature, given, message):
    with pytest.raises(nh.InputError) as refused:
        oil_viscosity(temperature, **given)
    assert message in str(refused.value)


# ISO 281's guide values as three public sources quote them, below a pitch diameter of 100 mm: high cleanliness 0.6 to
# 0.8, from there on 0.8 to 0.9. Its formula, with a film that is thick enough, ought to lie there.
@pytest.mark.parametrize(("pitch", "low", "high"), [(20.0, 0.6, 0.8), (40.0, 0.6, 0.81), (150.0, 0.8, 0.9)])
def test_high_cleanliness_has_the_guide_values(pitch, low, high):
    assert low <= contamination_factor(4.0, pitch, "high") <= high


def test_classes_of_circulating_oil_are_ordered_and_never_negative():
    factors = [contamination_factor(2.0, 60.0, each) for each in ("high", "-/15/12", "-/17/14", "-/19/16")]
    assert factors == sorted(factors, reverse=True)
    # By hand: min(0.0288 * 2^0.68 * 60^0.55, 1) = 0.4383, and 1 - 1.6329 / 60^(1/3) = 0.5829.
    assert factors[2] == pytest.approx(0.4383 * 0.5829, abs=2e-4)
    assert contamination_factor(2.0, 12.0, "-/19/16") == 0.0
    with pytest.raises(nh.InputError, match=r"cleanliness = 'spotless' must be one of 'high'"):
        contamination_factor(2.0, 60.0, "spotless")


def test_dirt_that_leaves_no_limit_leaves_the_smallest_factor():
    roller = nh.Roller(diameter=2.0, length=4.0)
    rings = {"inner": nh.Ring(diameter=9.0), "outer": nh.Ring(diameter=-13.0)}
    row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=12)
    found = nh.bearing.solve(row, radial=500.0, method="slices")
    dirty = nh.bearing.assess(found, speed=3e3, viscosity=60.0, cleanliness="-/19/16")
    assert dirty.contamination == 0.0
    assert dirty.life_factor == pytest.approx(0.1)
    assert math.isfinite(dirty.modified_life)


@pytest.mark.parametrize("oil", [{}, {"speed": 3e3, "viscosity": 20.0}])
@pytest.mark.parametrize("reliability", [0.9, 0.95])
def test_without_a_cleanliness_the_reference_life_stands(oil, reliability):
    roller = nh.Roller(diameter=9.0, length=10.0, corner_radius=0.3, profile=nh.profile.crown(1200))
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    found = nh.bearing.solve(row, radial=1e4, method="slices")
    life = nh.bearing.assess(found, **oil, reliability=reliability)
    assert life.life_factor is life.contamination is None
    assert (life.viscosity_ratio is None) is not bool(oil)
    assert math.isnan(life.modified_life)
    # a_1 of ISO 281's table: 0.64 at 95 %.
    assert life.rated_life == pytest.approx({0.9: 1.0, 0.95: 0.64}[reliability] * life.reference_life, rel=0.005)
    assert "give viscosity and cleanliness for the modified life" in repr(life)
    full = nh.bearing.assess(found, speed=3e3, viscosity=20.0, cleanliness="-/17/14", reliability=reliability)
    assert full.rated_life == full.modified_life < life.rated_life
    assert full.no_modified == ""


@pytest.mark.parametrize("given", [{"cleanliness": "high"}, {"contamination": 0.5}])
def test_a_cleanliness_is_that_of_an_oil(given):
    (name,) = given
    with pytest.raises(nh.InputError, match=f"^{name} = .* must be given with a viscosity"):
        nh.bearing.Lubrication(**given)
