"""Lives of whole bearings: several rows, thrust bearings, spectra, stressed volumes and static pressure."""

import dataclasses
import math

import numpy as np
import pytest
from crowned_rows import TAPER, barrels, washers
from crowned_rows import worked as row
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.bearing.fatigue import Calibration
from nonhertz.life.volume import section_exposure

B = nh.bearing


THRUST = washers(5.0, 50.0, crown=20000.0)


# Ratings


def test_two_rows_have_the_rating_of_twice_the_length():
    """ISO 281 writes (i L cos alpha)^(7/9); each row's contacts are what they are alone."""
    one, two = B.rating(TAPER), B.rating(B.paired(TAPER, "O", 20.0))
    assert two.dynamic / one.dynamic == pytest.approx(2.0 ** (7.0 / 9.0), rel=1e-12)
    assert two.static == pytest.approx(2.0 * one.static, rel=1e-12)
    assert (two.inner, two.outer) == pytest.approx((one.inner, one.outer), rel=1e-12)
    assert (one.rows, two.rows, one.material_factor, one.reduction) == (1, 2, 1.1, 0.83)
    # The same from the rating of a catalogue for both rows.
    assert B.rating(B.paired(TAPER, "O", 20.0), dynamic=two.dynamic).inner == pytest.approx(one.inner, rel=1e-12)


def test_spherical_bearings_and_drawn_cups_have_factors_of_their_own():
    rated = B.rating(barrels())
    assert rated.material_factor == 1.15
    assert rated.dynamic / B.rating(barrels(), material_factor=1.1).dynamic == pytest.approx(1.15 / 1.1)
    assert B.rating(row(), material_factor=1.0).dynamic == pytest.approx(B.rating(row()).dynamic / 1.1)


def test_a_thrust_bearing_has_the_factor_of_the_table():
    """ISO 281's table of f_c as it is recalled: 105.4, 122.9, 150.7 at D / D_pw = 0.01, 0.02, 0.05."""
    for ratio, factor in ((0.01, 105.4), (0.02, 122.9), (0.05, 150.7)):
        bearing = dataclasses.replace(THRUST, pitch_diameter=5.0 / ratio)
        size = 5.0 ** (7 / 9) * 20**0.75 * 5.0 ** (29 / 27)
        assert B.rating(bearing).dynamic / size == pytest.approx(factor, abs=0.051)
    rated = B.rating(THRUST)
    # Evenly loaded with C_a, (Q_c / Q)^-4.5 of both rings must add up to one: Q = C_a / Z, but for lambda.
    assert 2.0 * (rated.dynamic / 20 / (0.73 * rated.inner)) ** 4.5 == pytest.approx(1.0, rel=1e-12)


def test_static_ratings_are_where_hertz_has_4000_mpa():
    """Q_max = 5 C_0 / (Z cos alpha) in a radial bearing, C_0 / Z under an axial load; E = 206 to 210 GPa give 0.5 %."""
    for bearing, share, radius in ((row(), 5.0, 0.5 / (1 / 10 + 1 / 55)), (THRUST, 1.0, 2.5)):
        load = share * B.rating(bearing).static / bearing.rollers
        line = nh.hertz.line_contact(
            line_load=load / bearing.roller_length, radius=radius, compliance=bearing.contacts[0].compliance
        )
        assert line.max_pressure == pytest.approx(4000.0, rel=0.007)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: B.rating(B.Paired(bearings=(TAPER, row()), x=(-10, 10), turned=(False, True))),
            "bearing = 'Paired' must have rows of the same kind and size",
        ),
        (lambda: B.rating(B.paired(THRUST, "X", 20.0)), "bearing = 'Paired' must have all its thrust bearings turned "),
        (
            lambda: B.assess(B.solve(THRUST, axial=1e3, method="slices"), viscosity=20.0, speed=1e3),
            "viscosity = 20.0 must be left out for thrust bearings",
        ),
    ],
)
def test_what_has_no_rating_is_refused_in_one_sentence(make, message):
    with pytest.raises(nh.InputError) as refused:
        make()
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


# Equivalent loads


def loads(bearing, radial, axial):
    found = B.assess(B.solve(bearing, radial=radial, axial=axial, method="slices"))
    return found.equivalent_load, found.static_load


def test_equivalent_loads_of_spherical_bearings_have_the_factors_of_a_catalogue():
    """FYH's table of spherical roller bearings, XS412: e = 0.25, Y_1 = 2.71, X_2 = 0.67, Y_2 = 4.03, to two digits."""
    pair = B.paired(barrels(math.atan(0.25 / 1.5), 12.0, 11.0, 60.2, 14), "O", 16.0, clearance=-0.005)
    below, above = loads(pair, 10e3, 2.4e3), loads(pair, 10e3, 2.6e3)
    assert below[0] == pytest.approx(10e3 + 2.71 * 2.4e3, rel=5e-3)
    assert above[0] == pytest.approx(0.67 * 10e3 + 4.03 * 2.6e3, rel=5e-3)
    assert above[1] == pytest.approx(10e3 + 0.44 / (0.25 / 1.5) * 2.6e3, rel=1e-6)


def test_tandem_rows_have_the_equivalent_load_of_one_and_cylindrical_ones_that_of_the_radial_force():
    tandem = B.paired(TAPER, "tandem", 20.0)
    assert loads(tandem, 20e3, 6e3)[0] == pytest.approx(20e3)
    steep = 9e3 / math.tan(0.207)
    assert loads(tandem, 20e3, 9e3)[0] == pytest.approx(0.4 * 20e3 + 0.4 * steep)
    assert loads(row(), 5e3, None) == pytest.approx((5e3, 5e3))
    assert loads(THRUST, None, 7e3) == pytest.approx((7e3, 7e3))


# Lives by laminae


def test_equal_rows_that_share_a_load_live_as_weibull_says():
    """Each row lives as long as alone under half of the load; of two, the first failure counts."""
    single = B.solve(TAPER, radial=10e3, axial=3e3, method="slices")
    pair = B.solve(B.paired(TAPER, "tandem", 20.0), radial=20e3, axial=6e3, method="slices")
    assert_allclose(pair.load, np.tile(single.load, (2, 1)), rtol=1e-7, atol=1e-4)
    oil = {"edge_stress": "none", "speed": 1500.0, "viscosity": 30.0, "cleanliness": "high"}
    alone, both = (B.assess(each, **oil) for each in (single, pair))
    assert both.life_factor == pytest.approx(alone.life_factor, rel=1e-6)
    assert both.reference_life == pytest.approx(alone.reference_life * 2.0 ** (-8.0 / 9.0), rel=1e-6)
    # C grows as 2^(7/9) and P doubles: with the power 10/3 nearly the same.
    assert both.basic_life == pytest.approx(alone.basic_life * 2.0 ** (-2.0 / 9.0 * 10.0 / 3.0), rel=1e-6)


def test_a_thrust_bearing_of_even_loads_has_the_l10r_of_its_capacity():
    """Q = F / Z on flat washers without a profile: {2 (Q / Q_c)^(9/2)}^(-8/9), whoever turns."""
    flat = dataclasses.replace(THRUST, roller=nh.Roller(diameter=5.0, length=5.0))
    expected = (2.0 * (500.0 / B.rating(flat).inner) ** 4.5) ** (-8.0 / 9.0)
    for turning in ("inner", "outer"):
        life = B.assess(B.solve(flat, axial=10e3, method="slices", turning=turning), edge_stress="none")
        assert life.reference_life == pytest.approx(expected, rel=1e-9)
    assert life.basic_life == pytest.approx((B.rating(flat).dynamic / 10e3) ** (10.0 / 3.0))


def test_the_ring_that_stands_still_suffers_more_from_a_load_on_few_rollers():
    solved = (B.solve(row(), radial=6e3, method="slices", turning=ring) for ring in ("inner", "outer"))
    inner, outer = (B.assess(solution, edge_stress="none").reference_life for solution in solved)
    # The inner ring has the smaller capacity, and the mean to the power 9/2 is above that to the power 4.
    assert outer < inner


def test_lives_and_films_follow_the_speed_and_the_ring_with_which_a_bearing_was_solved():
    solution = B.solve(row(), radial=6e3, speed=1500.0, turning="outer", method="slices")
    life, given = B.assess(solution), B.assess(solution, speed=3000.0)
    assert (life.speed, given.speed) == (1500.0, 3000.0)
    assert life.rated_hours == pytest.approx(2.0 * given.rated_hours)
    films = B.films(solution, lubrication=B.Lubrication(oil="ISO VG 68", temperature=70))
    assert (films.kinematics[0].inner_speed, films.kinematics[0].outer_speed) == (0.0, 1500.0)
    spectrum = [(solution, 0.5), (B.solve(row(), radial=6e3, method="slices"), 0.5)]
    assert B.assess(spectrum).speed is None


# Spectra


def test_a_spectrum_lives_as_palmgren_and_miner_say():
    cases = [
        B.BearingLoadCase(share=0.25, radial=8e3, speed=1500.0),
        B.BearingLoadCase(share=0.75, radial=4e3, speed=500.0),
    ]
    pairs = B.solve_spectrum(row(), cases, method="slices")
    oil = {"viscosity": 40.0, "cleanliness": "-/17/14", "reliability": 0.95}
    both = B.assess(pairs, speed=[1500.0, 500.0], **oil)
    parts = [B.assess(each, speed=case.speed, **oil) for (each, _), case in zip(pairs, cases, strict=True)]
    for name in ("basic_life", "reference_life", "modified_life"):
        heavy, light = (getattr(each, name) for each in parts)
        assert getattr(both, name) == pytest.approx(1.0 / (0.25 / heavy + 0.75 / light), rel=1e-12)
    assert both.equivalent_load == pytest.approx((0.25 * 8e3 ** (10 / 3) + 0.75 * 4e3 ** (10 / 3)) ** 0.3, rel=1e-9)
    assert both.static_safety == min(each.static_safety for each in parts)
    assert both.viscosity_ratio == min(each.viscosity_ratio for each in parts)
    assert both.modified_life == pytest.approx(both.reliability_factor * both.life_factor * both.reference_life)
    assert [share for _, share in both.parts] == [0.25, 0.75]
    assert "under 2 loads" in repr(both)
    # Without a cleanliness there is no modified life, and a_1 L10r adds up as well.
    dry = B.assess(pairs, speed=[1500.0, 500.0], viscosity=40.0, reliability=0.95)
    assert dry.rated_life == pytest.approx(dry.reliability_factor * both.reference_life, rel=1e-12)
    assert (dry.viscosity_ratio, dry.contamination, dry.life_factor) == (both.viscosity_ratio, None, None)


def test_a_spectrum_has_no_basic_life_where_one_of_its_loads_has_none():
    """P leaves out moments: the life under a moment alone is not infinite, though P is zero."""
    force, moment = (B.solve(row(), **load, method="slices") for load in ({"radial": 8e3}, {"moment": 60e3}))
    alone, both = B.assess(moment), B.assess([(force, 0.5), (moment, 0.5)])
    assert math.isfinite(alone.reference_life)
    for life in (alone, both):
        assert life.internally_loaded
        assert math.isnan(life.basic_life)
        assert math.isnan(life.static_safety)
    assert both.equivalent_load > 0.0
    # Rollers that idle at speed load the outer ring too, which is of no account.
    idle = B.solve(row(clearance=0.02), speed=1000.0, method="slices")
    loaded = B.solve(row(clearance=0.02), radial=8e3, speed=1000.0, method="slices")
    assert B.assess(idle).internally_loaded
    assert B.assess([(loaded, 0.5), (idle, 0.5)]).basic_life == pytest.approx(2.0 * B.assess(loaded).basic_life)
    assert both.reference_life == pytest.approx(
        2.0 / (1.0 / B.assess(force).reference_life + 1.0 / alone.reference_life), rel=1e-12
    )


def test_hours_say_at_what_speed_the_bearing_turns_without_load():
    loads = [B.solve(row(), radial=8e3, method="slices"), B.solve(row(), radial=4e3, method="slices")]
    part = B.assess([(loads[0], 0.2), (loads[1], 0.3)], speed=[1500.0, 500.0])
    # 0.2 of the revolutions at 1500 and 0.3 at 500 take 0.2 / 1500 + 0.3 / 500 minutes.
    mean = 0.5 / (0.2 / 1500.0 + 0.3 / 500.0)
    assert part.speed == pytest.approx(mean)
    assert part.findings[-1].kind == "unloaded-speed"
    assert f"the mean speed of the loads, {mean:.4g} 1/min, for the 50 % of the revolutions" in part.warnings[-1]
    for speed, shares in ((1500.0, (0.2, 0.3)), ([1500.0, 500.0], (0.5, 0.5)), (None, (0.2, 0.3))):
        assert not B.assess(list(zip(loads, shares, strict=True)), speed=speed).findings


def test_shares_below_one_are_taken_as_they_are_and_above_one_refused():
    found = B.solve(row(), radial=6e3, method="slices")
    assert B.assess([(found, 0.5)]).basic_life == pytest.approx(2.0 * B.assess(found).basic_life)
    with pytest.raises(nh.InputError, match=r"share = 1\.2 must add up to 1 at most"):
        B.assess([(found, 0.6), (found, 0.6)])
    with pytest.raises(nh.InputError, match=r"share = 1\.2 must add up to 1 at most"):
        B.solve_spectrum(row(), [B.BearingLoadCase(share=0.6, radial=1e3)] * 2)
    other = B.solve(row(rollers=12), radial=6e3, method="slices")
    with pytest.raises(nh.InputError, match="solution = 'several' must all belong to one bearing"):
        B.assess([(found, 0.5), (other, 0.5)])
    with pytest.raises(nh.InputError, match="speed = 3 must be one, or 2, one for each load"):
        B.assess([(found, 0.5), (found, 0.5)], speed=[1.0, 2.0, 3.0], viscosity=20.0)


def test_shares_of_time_become_shares_of_revolutions():
    assert_allclose(B.shares_of_revolutions([0.1, 0.2, 0.3], [3000, 1500, 1000]), [1 / 3] * 3)
    for times, speeds, message in (
        ([0.7, 0.7], [1, 1], r"times = 1\.4 must add up to 1 at most"),
        ([0.5], [1, 1], "speeds = 2 must be as many as times, 1"),
        ([0.5], [0.0], r"speeds = 0\.0 must be positive"),
    ):
        with pytest.raises(nh.InputError, match=message):
            B.shares_of_revolutions(times, speeds)


# Stressed volumes


@pytest.mark.parametrize(("rollers", "pitch"), [(14, 65.0), (40, 200.0), (8, 30.0)])
def test_the_capacities_of_both_rings_give_one_constant_of_the_material(rollers, pitch):
    """Passes, circumferences and volumes of two rings, against two formulas of ISO 281, which are 0.2 % apart.

    Counting Z / 2 (1 - gamma) passes at the inner ring as well would be 37 % off in the first bearing.
    """
    bearing = row(rollers=rollers, pitch=pitch)
    inner, outer = Calibration(bearing, B.rating(bearing), nh.life.lundberg_palmgren()).constants()
    assert inner == pytest.approx(outer, rel=3e-3)
    # It is that of the steel, whatever the bearing.
    first = row()
    reference = Calibration(first, B.rating(first), nh.life.lundberg_palmgren()).constants()[0]
    assert inner == pytest.approx(reference, rel=3e-3)


@pytest.mark.slow
def test_even_pressures_have_the_l10r_of_the_standard():
    """(mean Q^4)^(1/4) and (mean Q^(9/2))^(2/9) against Q_ci and Q_ce, from the loads of the rollers by hand."""
    found = B.solve(row(), radial=6e3)
    rated, load = B.rating(row()), found.load
    turning = np.mean(load[:, 0] ** 4.0) ** 0.25 / rated.inner
    standing = np.mean(load[:, 1] ** 4.5) ** (1.0 / 4.5) / rated.outer
    lives = B.volume_life(found)
    assert_allclose(lives.even[0, :2], [turning**-4.0, standing**-4.0], rtol=1e-6)
    # With the outer ring turning the powers change places.
    other = B.volume_life(B.solve(row(), radial=6e3, turning="outer")).even[0, 0]
    assert other == pytest.approx((np.mean(load[:, 0] ** 4.5) ** (1.0 / 4.5) / rated.inner) ** -4.0, rel=1e-6)


def test_an_evenly_loaded_bearing_has_a_closed_composition():
    """Equal loads: rings as (Q_c / Q)^4 times the relative life of one contact, rollers by passes and lengths.

    A roller of 5 mm on 50 mm turns 5 times in a revolution and has both rings over it, 10 passes on 20 rollers of 5 mm
    round; a ring has 10 passes on 50 mm. So the rollers have the damage of the ring times 20 * 5 / 50 = 2.
    """
    lives = B.volume_life(B.solve(THRUST, axial=10e3))
    ring = (B.rating(THRUST).inner / 500.0) ** 4.0
    assert_allclose(lives.even[0], [ring, ring, ring * 2.0 ** (-8.0 / 9.0)], rtol=1e-7)
    contact = B.solve(THRUST, axial=10e3).contact(0)
    model = nh.life.lundberg_palmgren()
    seen = section_exposure(contact, body="b")
    assert_allclose(seen.orthogonal_shear, seen.orthogonal_shear[::-1], rtol=1e-6)
    relative = (seen.reference.damage(model) / seen.damage(model)) ** (8.0 / 9.0)
    assert lives.inner == pytest.approx(ring * relative, rel=1e-7)
    assert lives.rings == pytest.approx(lives.inner * 2.0 ** (-8.0 / 9.0), rel=1e-7)
    assert lives.bearing == pytest.approx(lives.inner * 4.0 ** (-8.0 / 9.0), rel=1e-5)


def test_one_loaded_roller_of_a_standing_ring_is_a_single_contact():
    """Of Z places on the standing ring one is loaded: its damage is a Z-th, and its life Z^(8/9) of that of all."""
    wide = row(clearance=0.15)
    found = B.solve(wide, radial=300.0)
    assert np.count_nonzero(found.load[:, 1]) == 1
    lives = B.volume_life(found)
    load = found.load.max()
    full = (B.rating(wide).outer / load) ** 4.0
    assert lives.even[0, 1] == pytest.approx(full * 14.0 ** (8.0 / 9.0), rel=1e-5)
    # The turning ring is under it for a Z-th of the passes, everywhere.
    assert lives.even[0, 0] == pytest.approx((B.rating(wide).inner / load) ** 4.0 * 14.0, rel=1e-5)


def test_lives_by_volume_and_by_laminae_agree_where_pressures_are_smooth():
    """Both know the pressures; laminae take the power 9/2 of the line load that would have them."""
    found = B.solve(row(profile=nh.profile.crown(1200)), radial=6e3)
    assert B.volume_life(found).rings == pytest.approx(B.assess(found).reference_life, rel=0.01)


@pytest.mark.slow
def test_a_tilt_shortens_lives_by_all_models_and_a_limit_lengthens_them():
    bearing = row(profile=nh.profile.iso_logarithmic(diameter=10, length=9.6))
    upright, tilted = (B.solve(bearing, radial=12e3, tilt=tilt) for tilt in (0.0, 3e-3))
    for model in ("lundberg-palmgren", "zaretsky", "weibull", "ioannides-harris"):
        lives = [B.volume_life(each, model) for each in (upright, tilted)]
        assert lives[1].bearing < 0.8 * lives[0].bearing
        assert lives[1].relative_life < lives[0].relative_life
    limited = nh.life.ioannides_harris(fatigue_limit=100.0)
    assert B.volume_life(upright, limited).rings > B.volume_life(upright).rings


@pytest.mark.slow
def test_the_rating_of_a_catalogue_calibrates_lives():
    """Lives go with the fourth power of the capacity, which goes with C."""
    found = B.solve(row(), radial=6e3)
    twice = B.volume_life(found, dynamic=2.0 * B.rating(row()).dynamic)
    assert_allclose(twice.of_rows, 16.0 * B.volume_life(found).of_rows, rtol=1e-6)


@pytest.mark.slow
def test_rows_that_differ_have_lives_by_volume_of_their_own():
    thick = dataclasses.replace(row(), roller=nh.Roller(diameter=10.0, length=12.0, profile=nh.profile.crown(2000)))
    mixed = B.Paired(bearings=(row(), thick), x=(-8.0, 8.0), turned=(False, False))
    lives = B.volume_life(B.solve(mixed, radial=9e3))
    assert lives.of_rows.shape == (2, 3)
    assert lives.inner == pytest.approx(np.sum(lives.of_rows[:, 0] ** (-9.0 / 8.0)) ** (-8.0 / 9.0))
    assert lives.bearing < lives.of_rows.min()


@pytest.mark.filterwarnings("ignore:roller .* uncertain")
@pytest.mark.slow
def test_steep_pressures_are_said_where_sections_do_not_do():
    corner = dataclasses.replace(row(), roller=nh.Roller(diameter=10.0, length=9.6, corner_radius=0.3))
    smooth, steep = B.solve(row(profile=nh.profile.crown(1000)), radial=3e3), B.solve(corner, radial=6e3, tilt=1e-3)
    assert not B.volume_life(smooth, "zaretsky").warnings
    assert not B.volume_life(steep).warnings
    assert "sections overestimate shear" in B.volume_life(steep, "zaretsky").warnings[0]


def test_sharp_ends_are_said_and_unloaded_bearings_last():
    sharp = B.volume_life(B.solve(row(profile=nh.profile.straight()), radial=6e3))
    assert "without limit towards the sharp ends" in sharp.warnings[0]
    still = B.volume_life(B.solve(row(clearance=0.02), radial_displacement=0.0))
    assert still.bearing == still.rings == math.inf
    assert math.isnan(still.relative_life)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"model": "iso-16281"}, "model = 'iso-16281' must be a model of the stressed volume"),
        ({"model": nh.life.ioannides_harris(fatigue_limit=5e3)}, "model = 'ioannides-harris' must cause damage at the"),
        ({"field": "half"}, "field = 'half' must be one of"),
    ],
)
def test_what_volumes_cannot_do_is_refused(given, message):
    found = B.solve(row(rollers=6), radial=1e3)
    with pytest.raises(nh.InputError) as refused:
        B.volume_life(found, **given)
    assert message in str(refused.value)
    with pytest.raises(nh.InputError, match="solution = 'by slices' must be by strips"):
        B.volume_life(B.solve(row(), radial=1e3, method="slices"))


@pytest.mark.slow
def test_sections_are_good_for_the_whole_field():
    """Crowned rollers that do not reach their ends; the field of a whole contact takes a quarter of a minute."""
    bearing = dataclasses.replace(THRUST, roller=nh.Roller(diameter=5.0, length=5.0, profile=nh.profile.crown(300)))
    found = B.solve(bearing, axial=2e3)
    sections, whole = (B.volume_life(found, field=each) for each in ("sections", "whole"))
    assert_allclose(sections.of_rows, whole.of_rows, rtol=0.01)


@pytest.mark.slow
def test_sections_are_good_at_the_peak_of_a_corner():
    """Neither the corner of 0.5 mm nor the outer ring was used to find how far a section's pressure acts."""
    roller = nh.Roller(diameter=10, length=9.6, corner_radius=0.5, profile=nh.profile.crown(2000))
    contact = nh.solve(nh.Contact(roller, nh.Ring(diameter=-75.0)), load=4e3, tilt=7e-4)
    assert contact.max_pressure > 1.4 * contact.centre_pressure[contact.centre_pressure.size // 2]
    seen, sections = nh.life.exposure(contact, body="a"), section_exposure(contact, body="a")
    for model in (nh.life.lundberg_palmgren(), nh.life.ioannides_harris(fatigue_limit=200.0)):
        # In life: damage to the power 8 / 9.
        assert sections.damage(model) == pytest.approx(seen.damage(model), rel=0.015)


# Static pressure


def test_the_safety_against_a_pressure_is_the_factor_on_the_load():
    found = B.solve(row(profile=nh.profile.crown(1000)), radial=6e3)
    factor = B.pressure_safety(found)
    most = found.contact(0)
    loaded = nh.solve(most.contact, load=factor * most.load, tilt=most.tilt)
    assert loaded.max_pressure == pytest.approx(4000.0, rel=1e-5)
    assert B.pressure_safety(found, limit=0.9 * most.max_pressure) < 1.0
    assert B.pressure_safety(B.solve(row(clearance=0.02), radial_displacement=0.0)) == math.inf


def test_a_sharp_end_has_no_safety():
    found = B.solve(row(profile=nh.profile.straight()), radial=6e3)
    with pytest.raises(nh.InputError, match="must have finite pressure at its ends, but it is singular towards"):
        B.pressure_safety(found)


# Single contacts of tapered rollers


def test_a_tapered_contact_has_a_life_with_its_contact_angle():
    solution = nh.solve(TAPER.contacts[1], load=100.0)
    (without,) = nh.life.assess(solution, "iso-16281", body="b", rollers=14)
    assert without.million_revolutions is None
    assert "give contact_angle" in without.no_revolutions
    (life,) = nh.life.assess(solution, "iso-16281", body="b", rollers=14, contact_angle=0.207)
    assert life.million_revolutions > 0.0


def test_a_tapered_contact_has_the_capacity_of_its_bearing():
    """Its rings are 0.13 mm off a fit without clearance, of 51.56 mm, and so is the pitch circle: 0.3 %."""
    rated = B.rating(TAPER)
    for contact, expected in zip(TAPER.contacts, (rated.inner, rated.outer), strict=True):
        ring, why = nh.life.raceway(contact, contact_angle=0.207)
        assert not why
        assert ring.roller_diameter == pytest.approx(TAPER.roller_diameter, rel=1e-12)
        assert ring.pitch_diameter == pytest.approx(TAPER.pitch, rel=4e-3)
        assert ring.capacity(14) == pytest.approx(expected, rel=4e-3)
