"""Ratings and lives of bearings, against public figures and sums by hand."""

import dataclasses
import math
import re

import numpy as np
import pytest
from crowned_rows import nu206
from crowned_rows import worked as row

import nonhertz as nh
from claims.known_bearings import LIFE_FACTORS, LIMITS
from nonhertz.bearing import life_factor, reliability_factor
from nonhertz.bearing.laminae import lamina_life, mean_over_rollers
from nonhertz.files.bearing_results import as_object
from nonhertz.files.bearingfile import BearingCase
from nonhertz.show.bearing import life_rows

B = nh.bearing


@pytest.mark.parametrize(
    ("given", "length"),
    [
        ({"outer": {"effective_length": 8.0}}, 8.0),
        ({"corner_radius": 0.3}, 9.4),
        ({"corner_radius": 2.0}, 6.0),
        ({"chamfer": nh.Chamfer(length=0.5, angle=0.5)}, 9.0),
        ({"profile": nh.profile.chamfer(10.0, 0.5)}, 9.0),
    ],
)
def test_the_effective_length_is_that_of_the_shortest_contact_without_corners(given, length):
    """ISO 281, effective roller length: C grows with its power 7/9, C0 with itself, L10 with C^(10/3).

    L10r by slices with Q_c^4, which has C's power, and of laminae that all bear (ISO/TS 16281).
    """
    cut, whole = nu206(**given), nu206(effective_length=length)
    lows, highs = zip(*(contact.land for contact in cut.contacts), strict=True)
    assert min(highs) - max(lows) == pytest.approx(length)
    rated = B.rating(cut)
    assert rated.dynamic == pytest.approx(42427.66 * (length / 10.0) ** (7.0 / 9.0), rel=1e-6)
    assert rated.static == pytest.approx(44.0 * (1.0 - 9.0 / 46.5) * 13 * length * 9.0, rel=1e-12)
    lives = [B.assess(B.solve(each, radial=10e3, method="slices")).reference_life for each in (cut, whole)]
    assert lives[0] == pytest.approx(lives[1], rel=1e-9)


def test_the_fatigue_limit_is_that_of_the_static_rating():
    """ISO 281, B.3.3.3, roller bearings: C0 / 8.2, above a pitch diameter of 100 mm times (100 / D_pw)^0.3."""
    small, large = nu206(), B.from_catalogue(100, 180, 34, 251e3, 305e3).bearing
    assert B.rating(small).fatigue_limit == pytest.approx(B.rating(small).static / 8.2)
    assert 130.0 < large.pitch < 150.0
    assert B.rating(large).fatigue_limit == pytest.approx(B.rating(large).static / 8.2 * (100.0 / large.pitch) ** 0.3)


@pytest.mark.parametrize("given", [{"outer": {"length": 8.6, "corner_radius": 0.3}}, {"corner_radius": 0.3}])
def test_the_life_by_pressures_is_the_sum_over_all_that_presses(given):
    """Laminae have a capacity per length, whatever length was rated: sum (q / q_c)^(9/2) is an integral along y."""
    found = B.solve(nu206(**given, profile=nh.profile.crown(radius=1200.0)), radial=6e3)
    rated = B.rating(found.bearing)
    length = np.diff(found.bearing.effective_interval)[0]
    y, damage = np.linspace(-4.999, 4.999, 4001), 0.0
    for k, (capacity, power) in enumerate(((rated.inner, 4.0), (rated.outer, 4.5))):
        contact = found.bearing.contacts[k]
        solutions = [found.contact(j, ("inner", "outer")[k]) for j in range(13)]
        pressure = np.array([np.zeros(y.size) if each is None else each.pressure(0.0, y) for each in solutions])
        # Of Hertz's line contact under this pressure.
        line_load = np.pi**2 * contact.compliance / contact.curvature(0.0) * pressure**2
        mean = np.mean(line_load**power, axis=0) ** (1.0 / power)
        damage += np.trapezoid((mean * length ** (7.0 / 9.0) / capacity) ** 4.5, y)
    assert B.assess(found).reference_life == pytest.approx(damage ** (-8.0 / 9.0), rel=5e-3)


@pytest.mark.slow
def test_towards_a_sharp_end_there_is_no_reference_life():
    """The pressure grows as s^-0.226 (Dundurs and Lee), p^9 as s^-2.03: its integral has no limit.

    By what was counted, sharp rollers lasted 450 million revolutions, and those with corners of 0.01 mm a thirtieth.
    """
    under = {"radial": 10e3, "tilt": 0.3e-3}
    found = B.solve(nu206(), **under)
    life = B.assess([(found, 0.7)], speed=1e3, viscosity=30.0, cleanliness="high")
    why = "the damage grows without limit towards the sharp ends at y = -5 and 5 mm"
    for each in (life, life.parts[0][0]):
        assert np.isnan([each.reference_life, each.modified_life, each.life_factor]).all()
        assert each.no_reference.startswith(why)
        assert f"no L10r: {why}" in repr(each)
    written = as_object(found, BearingCase(found.bearing, under), life, "")["life"]
    assert written["reference_life"] is None
    assert written["no_reference"] == life.no_reference
    assert ("L10r", "none", life.no_reference) in life_rows(life, "")
    assert B.assess(found, edge_stress="standard").reference_life == pytest.approx(119.29, rel=1e-3)
    assert B.assess(B.solve(nu206(corner_radius=0.01), **under)).reference_life < 450.0 / 25.0
    contact = nh.solve(found.bearing.contacts[0], load=3e3)
    for each in nh.life.assess(contact, ("iso-16281", "lundberg-palmgren"), body="b", rollers=13):
        assert each.million_revolutions is None
        assert each.no_revolutions == why
        assert "upper bound" in each.warnings[-1]


@pytest.mark.parametrize("kappa", LIFE_FACTORS)
def test_the_life_factor_is_that_of_the_standard(kappa):
    for limit, factor in zip(LIMITS, LIFE_FACTORS[kappa], strict=True):
        assert life_factor(kappa, limit) == pytest.approx(factor, abs=5.1e-4)


def test_the_life_factor_is_continuous_capped_and_has_a_lower_end():
    for at in (0.4, 1.0):
        assert life_factor(at * (1.0 - 1e-9), 0.3) == pytest.approx(life_factor(at, 0.3), rel=1e-3)
    assert life_factor(4.0, 5.0) == 50.0
    assert life_factor(9.0, 0.5) == life_factor(4.0, 0.5)
    with pytest.raises(nh.InputError, match=r"viscosity_ratio = 0\.05 must be at least 0\.1"):
        life_factor(0.05, 0.5)


@pytest.mark.parametrize(("reliability", "factor"), [(0.95, 0.64), (0.96, 0.55), (0.98, 0.37), (0.99, 0.25)])
def test_the_factor_of_reliability_is_near_the_table(reliability, factor):
    assert reliability_factor(reliability) == pytest.approx(factor, abs=0.006)


def test_the_reference_life_of_one_load_everywhere_is_that_of_the_capacities():
    rated = B.rating(row())
    loads = np.full((14, 2, 40), 2000.0 / 40)
    expected = ((2000.0 / rated.inner) ** 4.5 + (2000.0 / rated.outer) ** 4.5) ** (-8.0 / 9.0)
    means = [mean_over_rollers(loads, "inner")]
    assert lamina_life(rated, means) == pytest.approx(expected, rel=1e-12)
    # A factor of every lamina is one of the life.
    assert lamina_life(rated, means, [np.full(40, 3.0)]) == pytest.approx(3.0 * expected, rel=1e-12)


def test_pressures_of_strips_shorten_the_life_where_a_tilt_loads_an_end():
    upright, tilted = (B.solve(row(corner_radius=0.3), radial=6e3, tilt=tilt) for tilt in (0.0, 3e-3))
    lives = [B.assess(each).reference_life for each in (upright, tilted)]
    assert lives[1] < 0.8 * lives[0]
    # Without edge stress the load per length alone counts, and pressures of a good profile add little to it.
    assert B.assess(upright, edge_stress="none").reference_life == pytest.approx(lives[0], rel=0.05)


def test_the_life_equation_holds_up_to_half_of_c():
    light, heavy = (B.solve(row(), radial=share * B.rating(row()).dynamic, method="slices") for share in (0.49, 0.51))
    assert B.assess(light).findings == ()
    (found,) = B.assess(heavy).findings
    assert found.kind == "heavy-load"
    assert re.match(
        r"The equivalent load P of 2\d\.\d+ kN exceeds half the rating C of 4\d\.\d+ kN: .*hold\.$", str(found)
    )
    assert str(found) in repr(B.assess(heavy))
    # Half of the revolutions under nothing: P as such is below half of C, but not the load that is borne.
    spectrum = B.assess([(heavy, 0.5)])
    assert spectrum.equivalent_load < 0.5 * spectrum.rating.dynamic
    assert [each.kind for each in spectrum.findings] == ["heavy-load"]
    # A larger rating of a catalogue is another bearing.
    assert B.assess(heavy, dynamic=2.0 * B.rating(row()).dynamic).findings == ()


def test_rollers_may_be_loaded_too_much_without_an_equivalent_load():
    life = B.assess(B.solve(dataclasses.replace(row(), clearance=-0.12), method="slices"))
    assert life.equivalent_load == 0.0
    assert life.reference_load == pytest.approx(life.rating.dynamic * life.reference_life**-0.3)
    (found,) = life.findings
    assert str(found).startswith("Rollers are loaded as by a P of ")


@pytest.mark.parametrize("moment", [0.0, 20e3])
def test_of_preload_and_moments_alone_there_is_no_equivalent_load(moment):
    """Sum of forces: zero. What rounding left of it was a P of 4e-13 N, for an S0 of 5.6e16 and an L10 of 7e55."""
    preloaded = dataclasses.replace(nu206(corner_radius=0.3), clearance=-0.01)
    found = B.solve(preloaded, moment=moment, method="slices")
    life = B.assess(found)
    # What is left of the balance is no force to be shown: it was 2.6e-13 N.
    assert "force 0, 0, 0 N along x, y, z" in repr(found)
    assert life.equivalent_load == life.static_load == 0.0
    assert math.isfinite(life.reference_life)
    assert math.isnan(life.basic_life)
    assert math.isnan(life.static_safety)
    rows = {name: value for name, *value in life_rows(life, "")}
    assert rows["equivalent load"] == ["P = 0 N, P0 = 0 N", "leaves out preload, moments, speed and ribs"]
    assert rows["static safety"][0] == rows["life L10"][0] == "none"
    assert "S0 = none\n  L10 = none" in repr(life)
    assert "no S0 and no L10: P leaves out preload, moments, speed and ribs" in repr(life)


def test_an_unloaded_bearing_lasts():
    found = B.assess(B.solve(row(clearance=0.02), method="slices"), speed=1000.0, viscosity=20.0, contamination=0.5)
    assert found.basic_life == found.reference_life == found.modified_life == found.static_safety == math.inf


def test_what_speed_presses_on_the_outer_ring_counts_without_a_load_as_under_a_small_one():
    """There was no damage without a load on the inner ring, and under the least of them a life of 62,000 10^6."""
    bearing = nu206(corner_radius=0.3, profile=nh.profile.crown(radius=1200.0))
    idle, loaded = (B.solve(bearing, radial=load, speed=60e3) for load in (0.0, 0.01))
    assert np.all(idle.load[:, 0] == 0.0)
    life = B.assess(idle)
    assert life.reference_life == pytest.approx(B.assess(loaded).reference_life, rel=1e-5)
    assert math.isnan(life.basic_life)
    volume = B.volume_life(idle)
    assert volume.inner == math.inf
    assert volume.outer == volume.rings == pytest.approx(life.reference_life, rel=0.01)
    assert volume.outer == pytest.approx(B.volume_life(loaded).outer, rel=1e-5)
    # Of a spectrum an idle load counts for what its speed does.
    spectrum = B.assess([(idle, 0.5), (B.solve(bearing, radial=5e3, speed=60e3), 0.5)])
    assert spectrum.equivalent_load == pytest.approx(5e3 * 0.5**0.3)
    assert math.isfinite(spectrum.basic_life)


@pytest.mark.parametrize(("radial", "basic"), [(0.0, math.nan), (8e3, (48416.8 / 8e3) ** (10 / 3))])
def test_axial_loads_on_ribs_are_in_no_life(radial, basic):
    """P of a cylindrical bearing is its radial load, whatever its ribs bear: L10 was infinite."""
    life = B.assess(B.solve(dataclasses.replace(row(), design="NUP"), radial=radial, axial=2e3, method="slices"))
    assert life.basic_life == pytest.approx(basic, rel=1e-3, nan_ok=True)
    (found,) = life.findings
    assert found.kind == "load-on-ribs"
    assert str(found).startswith("Ribs support the axial load of 2.000 kN, which no life here includes")
    assert [each.kind for each in B.assess([(B.solve(row(), radial=4e3, method="slices"), 1.0)]).findings] == []


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"viscosity": 20.0}, "speed must be given with a viscosity"),
        ({"viscosity": 20.0, "speed": 1e3, "contamination": 2.0}, "contamination = 2.0 must not exceed 1"),
        ({"reliability": 99.0}, "reliability = 99.0 must lie between 0.9 and 0.9995"),
        ({"edge_stress": "pressure"}, "edge_stress = 'pressure' must be 'standard' or 'none' for slices"),
        ({"laminae": 3}, "laminae = 3 must be a whole number from 30"),
    ],
)
def test_what_is_out_of_range_is_refused_in_one_sentence(given, message):
    found = B.solve(row(), radial=6e3, method="slices")
    with pytest.raises(nh.InputError) as refused:
        B.assess(found, **given)
    assert message in str(refused.value)


def test_shares_of_contacts_are_taken_as_they_are():
    """The load zone of a bearing: five of thirteen rollers, and nothing for the rest of the revolution."""
    roller = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(2000))
    contact = nh.Contact(roller, nh.Ring(diameter=37.5))
    loads = [5e3, 4e3, 4e3, 2e3, 2e3]
    pairs = [(nh.solve(contact, load=load), 1.0 / 13.0) for load in loads]
    (zone,) = nh.life.assess(pairs, "iso-16281", body="b", rollers=13)
    alone = [nh.life.assess(each, "iso-16281", body="b", rollers=13)[0].million_revolutions for each, _ in pairs]
    assert zone.million_revolutions == pytest.approx(1.0 / sum(1.0 / 13.0 / life for life in alone), rel=1e-9)
    with pytest.raises(nh.InputError, match=r"share = 1\.5 must add up to 1 at most"):
        nh.life.assess([(pairs[0][0], 0.75), (pairs[1][0], 0.75)], "iso-16281", body="b")


@pytest.mark.parametrize("name", ["zirconia", "R260", "R350HT", "silicon-nitride"])
def test_what_is_as_stiff_as_bearing_steel_is_not_rated_as_it(name):
    """ISO 281 is for hardened steel: zirconia has 1200 HV, rails have 260 and 350 HBW, all with 210 GPa."""
    with pytest.raises(nh.InputError, match=r"must (be|have rollers) of bearing steel"):
        B.rating(nu206(material=nh.MATERIALS[name]))
    contact = nh.solve(nu206(material=nh.MATERIALS[name], corner_radius=0.3).contacts[0], load=1e3)
    (life,) = nh.life.assess(contact, "iso-16281", body="b", rollers=13)
    assert life.no_revolutions == "the capacity of ISO 281 holds only for bearing steel"
    for steel in ("steel", "100Cr6", "X105CrMo17", "16MnCr5"):
        assert B.rating(nu206(material=nh.MATERIALS[steel])).dynamic == B.rating(nu206()).dynamic


def test_hollow_rollers_are_not_rated_as_solid_ones():
    with pytest.raises(nh.InputError, match="must have solid rollers"):
        B.rating(nu206(bore=4.0))
    assert B.rating(nu206(bore=nh.TabulatedDiameter((-5, -4, 4, 5), (3, 0, 0, 3)))).dynamic == B.rating(nu206()).dynamic
