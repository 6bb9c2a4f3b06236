"""Fatigue life: models, laminae, capacities, spectra, and what an assessment says."""

import dataclasses
import math
import warnings

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.life import (
    MODELS,
    ContactLoadCase,
    Raceway,
    VolumeModel,
    assess,
    exposure,
    ioannides_harris,
    iso_16281,
    lundberg_palmgren,
    model,
    raceway,
    solve_spectrum,
    weibull,
    zaretsky,
)
from nonhertz.life.lamina import LEFT_OUT, edge_function, laminae_of
from nonhertz.life.volume import section_exposure
from nonhertz.subsurface import passage

RING = nh.Ring(diameter=60)


def roller(profile=None, **changes):
    profile = profile or nh.profile.iso_logarithmic(diameter=15, length=12)
    return nh.Roller(**{"diameter": 15, "length": 12, "profile": profile, "side_faces": "mirror"} | changes)


def solved(load=8e3, tilt=0.0, profile=None, ring=RING, strips=31, **changes):
    return nh.solve(nh.Contact(roller(profile, **changes), ring), load=load, tilt=tilt, strips=strips)


@pytest.fixture(scope="module")
def logarithmic():
    return solved(tilt=5e-4)


@pytest.fixture(scope="module")
def sharp():
    return solved(profile=nh.profile.straight(), strips="auto")


@pytest.fixture(scope="module")
def lives(logarithmic):
    return {life.model.name: life for life in assess(logarithmic, rollers=12, body="b")}


# Models


def test_every_model_is_made_by_its_name():
    assert [model(name).name for name in MODELS] == list(MODELS)
    assert all(model(name).source for name in MODELS)


def test_the_parameters_are_those_of_the_publications():
    palmgren, harris = lundberg_palmgren(), ioannides_harris(fatigue_limit=276.0)
    assert (palmgren.stress, palmgren.exponent, palmgren.depth_exponent) == ("orthogonal_shear", 31 / 3, 7 / 3)
    assert (palmgren.slope, palmgren.fatigue_limit) == (9 / 8, 0.0)
    assert (harris.exponent, harris.depth_exponent, harris.fatigue_limit) == (31 / 3, 7 / 3, 276.0)
    assert (weibull().stress, weibull().exponent, weibull().depth_exponent) == ("shear", 31 / 3, 0.0)
    # Life goes with the ninth power of the stress whatever the slope.
    assert zaretsky(slope=2.0).exponent / 2.0 == zaretsky().exponent / zaretsky().slope == 9.0


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: model("palmgren"), "model = 'palmgren' must be a fatigue model: choose from lundberg-palmgren, "),
        (lambda: model("zaretsky", fatigue_limit=3.0), "fatigue_limit = 3.0 must be a parameter of zaretsky: it has s"),
        (lambda: lundberg_palmgren(slope=0.1), "slope = 0.1 must lie between 0.2 and 5"),
        (lambda: ioannides_harris(stress="von_mises"), "stress = 'von_mises' must be 'orthogonal_shear' where depth_e"),
        (lambda: VolumeModel("own", "shear", 9.0, 1.0, 1.1, 0.0, "none"), "stress = 'shear' must be 'orthogonal_shear"),
        (lambda: iso_16281(laminae=29), "laminae = 29 must be a whole number from 30 to 2000"),
        (lambda: ContactLoadCase(load=1.0, share=1.2), "share = 1.2 must not exceed 1"),
        (lambda: solve_spectrum(nh.Contact(roller(), RING), []), "cases = [] must be load cases"),
    ],
)
def test_what_no_model_is_ends_in_one_sentence(make, words):
    with pytest.raises(nh.InputError) as caught:
        make()
    assert str(caught.value).startswith(words)


# The volume


def test_the_ideal_pressure_is_the_reference():
    long = nh.Roller(diameter=15, length=8, side_faces="mirror", images="series")
    softer = dataclasses.replace(long, material=nh.Material(modulus=100e3, poisson=0.2))
    solution = nh.solve(nh.Contact(long, softer), load=9e3, strips=11)
    # With its images for ever the pressure is Hertz's line pressure from end to end.
    for life in assess(solution, body="a"):
        assert life.relative_life == pytest.approx(1.0, rel=2e-5)
        np.testing.assert_allclose(life.density, 1.0, rtol=1e-4)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_the_reference_is_the_integral_of_the_line_contact():
    line = nh.hertz.line_contact(
        line_load=9e3 / 12, radius=1 / (2 / 15 + 2 / 60), compliance=2 * nh.MATERIALS["steel"].compliance
    )
    z = np.geomspace(1e-3, 8.0, 400) * line.half_width
    x = np.linspace(0.0, 5.0, 2001)[:, None] * line.half_width
    amplitude = np.abs(line.stress(x, z, 0.3)[..., 4]).max(axis=0)
    expected = 12.0 * np.trapezoid(amplitude ** (31 / 3) * z ** (-7 / 3), z)
    seen = exposure(solved(load=9e3, strips=5))
    assert seen.reference is not None
    assert seen.reference.damage(lundberg_palmgren()) == pytest.approx(expected, rel=1e-3)


@pytest.mark.slow
def test_damage_is_counted_up_to_two_half_widths_beyond_where_a_contact_runs_out():
    crowned = solved(load=2e3, profile=nh.profile.crown(radius=1000), length=20)
    seen = exposure(crowned)
    np.testing.assert_allclose(seen.y, -seen.y[::-1], rtol=0, atol=1e-9)
    first = crowned.edges[:-1][crowned.line_load > 0.0][0]
    half_width = crowned.half_width[crowned.line_load > 0.0][0]
    assert 1.0 * half_width < first - seen.y[0] < 2.0 * half_width


@pytest.mark.slow
def test_below_a_thin_wall_nothing_is_counted():
    thin = solved(load=2e3, strips=21, ring=nh.Plate(depth=0.5))
    seen, low = exposure(thin, body="b"), VolumeModel("low", "shear", 2.0, 0.0, 1.0, 0.0, "none")
    station = seen.half_width.argmax()
    assert 4.0 * seen.half_width[station] > 0.5
    z = 0.5 * (np.arange(250) + 0.5) / 250.0
    direct = np.mean(passage(thin, seen.y[station], z, body="b").shear ** 2) * 0.5
    assert seen.density(low)[station] == pytest.approx(direct, rel=1e-3)


@pytest.mark.slow
def test_more_strips_change_the_life_little(lives):
    for life in assess(solved(tilt=5e-4, strips=93), body="b"):
        assert life.relative_life == pytest.approx(lives[life.model.name].relative_life, rel=2e-2)


@pytest.mark.slow
def test_a_tilt_shortens_life_and_moves_the_damage(lives):
    upright = {life.model.name: life for life in assess(solved(), body="b")}
    for name, life in lives.items():
        assert life.relative_life < 0.99 * upright[name].relative_life < 1.0
        assert np.average(life.y, weights=life.density) > 0.3


@pytest.mark.slow
def test_above_all_stress_a_limit_leaves_no_damage_and_above_the_ideal_no_reference():
    (life,) = assess(solved(load=500.0, strips=9), ioannides_harris(fatigue_limit=2000.0))
    assert (life.damage, life.reference) == (0.0, 0.0)
    assert math.isnan(life.relative_life)
    (life,) = assess(solved(load=3e3, profile=nh.profile.crown(radius=400)), ioannides_harris(fatigue_limit=360.0))
    assert life.damage > 0.0
    assert (life.reference, life.relative_life) == (0.0, 0.0)


@pytest.mark.slow
def test_at_a_sharp_end_it_is_said_what_is_not_counted():
    (coarse,) = assess(solved(profile=nh.profile.straight(), strips=21), "zaretsky")
    assert f"nearer to them than {LEFT_OUT:g} of the largest half-width was left out" in coarse.warnings[-2]
    assert coarse.warnings[-1].startswith("The strips or cells at a sharp end are longer than the region left out")


def test_nothing_else_is_left_out():
    edges = np.union1d(np.linspace(-6.0, 6.0, 22), [-5.98, -5.96, -5.8, 5.8, 5.96, 5.98])
    solution = solved(profile=nh.profile.straight(), strips=edges)
    found = section_exposure(solution, body="a")
    from_end = np.min([np.hypot(found.y[:, None] - end, found.z) for end in solution.contact.interval], axis=0)
    np.testing.assert_array_equal(found.counted, from_end >= LEFT_OUT * solution.max_half_width)
    assert not np.all(found.counted)


@pytest.mark.slow
def test_at_a_corner_where_the_contact_ends_the_same_is_left_out_on_finer_strips():
    contact = nh.Contact(roller(nh.profile.chamfer(20, 1.0), length=20, diameter=20), nh.Ring(diameter=80))
    # Damage goes with the tenth power of the pressure, which has no limit there: finer than the default.
    with without_accuracy_warnings():
        corner = nh.solve(contact, load=20e3, accuracy=6e-5)
    halved = np.unique(np.concatenate([corner.edges, 0.5 * (corner.edges[1:] + corner.edges[:-1])]))
    lives = [assess(each, "lundberg-palmgren")[0] for each in (corner, nh.solve(contact, load=20e3, strips=halved))]
    assert lives[1].relative_life == pytest.approx(lives[0].relative_life, rel=0.05)
    words = "without limit towards the corners of the profile at y = -9 and 9 mm: the volume nearer to them than"
    assert all(any(words in warning for warning in life.warnings) for life in lives)


@pytest.mark.campaign
def test_towards_a_sharp_end_the_volume_left_out_is_the_same_on_all_grids(sharp):
    (automatic,) = assess(sharp, "zaretsky")
    edges = np.unique(np.concatenate([sharp.edges, 0.5 * (sharp.edges[1:] + sharp.edges[:-1])]))
    (finer,) = assess(nh.solve(sharp.contact, load=sharp.load, strips=edges), "zaretsky")
    assert finer.relative_life == pytest.approx(automatic.relative_life, rel=0.05)
    assert (
        f"the volume nearer to them than {LEFT_OUT:g} of the largest half-width was left out" in automatic.warnings[-1]
    )


@pytest.mark.campaign
def test_bodies_without_an_end_have_lives_that_can_be_compared_alone():
    crowned = nh.Body(diameter=15, profile=nh.profile.crown(radius=300))
    one, other = (
        assess(nh.solve(nh.Contact(crowned, nh.Plate()), load=load), "lundberg-palmgren")[0] for load in (500, 1000)
    )
    assert math.isnan(one.relative_life)
    assert one.no_revolutions
    # A point contact: life goes with the load to the power -(c - h + 2) / (3 e), e = 9/8 here.
    exponent = (31 / 3 - 7 / 3 + 2) / (3 * 9 / 8)
    # Two bounding widths along as well as across: the volume's length grows with the load too.
    assert math.log2(one.over(other)) == pytest.approx(exponent - 0.0, rel=2e-2)
    with pytest.raises(nh.InputError, match="length must be given for laminae"):
        assess(nh.solve(nh.Contact(crowned, nh.Plate()), load=500), "iso-16281")


# Laminae


def test_laminae_share_the_load(logarithmic):
    cut = laminae_of(logarithmic, iso_16281(laminae=41))
    assert cut.load.sum() == pytest.approx(logarithmic.load, rel=1e-12)
    assert cut.load @ (0.5 * (cut.edges[1:] + cut.edges[:-1])) == pytest.approx(logarithmic.moment, rel=2e-3)


def test_the_pressure_factor_is_one_under_hertz_and_more_where_the_pressure_is(logarithmic, sharp):
    middle = laminae_of(logarithmic, iso_16281(laminae=40)).factor[15:25]
    np.testing.assert_allclose(middle, 1.0, rtol=5e-3)
    of_sharp = laminae_of(sharp, iso_16281(laminae=40)).factor
    assert of_sharp[0] > 1.1
    assert of_sharp[0] == pytest.approx(of_sharp[-1], rel=1e-6)


def test_the_pressure_factor_is_the_standards_for_its_steel():
    # (p / 271)^2 D (1 - gamma) L / n_s is the line load of Hertz at E = 210000 MPa, nu = 0.3.
    steel = nh.Material(210000.0, 0.3)
    ring = nh.Ring(diameter=60, material=steel)
    solution = solved(ring=ring, material=steel, strips=240)
    cut = laminae_of(solution, iso_16281(laminae=40))
    pressure = solution.centre_pressure.reshape(40, 6)
    as_standard = (pressure**2).mean(axis=1) / 271.0**2 * 15.0 * (1.0 - 15.0 / 75.0) * 12.0 / 40
    np.testing.assert_allclose((cut.factor * cut.load)[5:-5], as_standard[5:-5], rtol=2e-3)


def test_the_standards_edge_function():
    found = edge_function(41)
    # 1 - 0.01 / ln(1.985 |(2 k - n - 1) / (2 n - 2)|) for k = 1, 2; the middle has the limit 1.
    expected = [1.0 - 0.01 / math.log(1.985 * 40 / 80), 1.0 - 0.01 / math.log(1.985 * 38 / 80), 1.0]
    np.testing.assert_allclose(found[[0, 1, 20]], expected, rtol=1e-12)
    np.testing.assert_array_equal(found, found[::-1])


def test_the_standards_slices_bear_load_and_tilt(logarithmic):
    cut = laminae_of(logarithmic, iso_16281(laminae=60, line_loads="standard", edge_stress="none"))
    assert cut.load.sum() == pytest.approx(logarithmic.load, rel=1e-9)
    # A straight, upright roller: q = c delta^(10/9) with one contact of both yielding 3.9707e-5 Q^0.9 / L^0.8.
    even = laminae_of(solved(profile=nh.profile.straight()), iso_16281(line_loads="standard", edge_stress="none"))
    np.testing.assert_allclose(even.load, 8e3 / 60, rtol=1e-9)
    assert cut.load[-5:].sum() > 1.2 * cut.load[:5].sum()


@pytest.mark.parametrize("laminae", [31, 60])
@pytest.mark.parametrize("beyond", [1e3, 2e7])
def test_the_standards_slices_bear_their_load_whatever_the_relief(beyond, laminae):
    """Metres of relief are a slip of the pen, but no reason to fail; so is a peak on which one slice bears it all."""
    standard = iso_16281(line_loads="standard", edge_stress="none", laminae=laminae)
    even = nh.profile.tabulated([-10.0, 10.0], [-beyond, -beyond], interpolation="linear")
    peak = nh.profile.tabulated([-10.0, 0.0, 10.0], [0.0, -beyond, 0.0], interpolation="linear")
    for profile in (even, peak):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", nh.AccuracyWarning)  # of a contact as wide as it is long
            solution = solved(profile=profile)
        assert laminae_of(solution, standard).load.sum() == pytest.approx(8e3, rel=1e-9)


def test_the_standards_slices_are_as_stiff_as_both_contacts_in_a_row():
    """Under a tilt the loads of the ends tell the deflection that they were made of, and so the stiffness."""
    solution = solved(profile=nh.profile.straight(), tilt=2e-4)
    cut = laminae_of(solution, iso_16281(laminae=60, line_loads="standard", edge_stress="none"))
    y = 0.5 * (cut.edges[1:] + cut.edges[:-1])
    ratio = (cut.load[-1] / cut.load[0]) ** 0.9
    deflection = 2e-4 * (y[-1] - ratio * y[0]) / (ratio - 1.0)
    # One contact yields 3.9707e-5 Q^0.9 / L^0.8 [mm, N]; Palmgren's own constant is 3.84e-5.
    evenly = cut.load * (deflection / (deflection + 2e-4 * y)) ** (10 / 9)
    np.testing.assert_allclose(evenly, evenly[0], rtol=1e-9)
    np.testing.assert_allclose(deflection, 3.9707e-5 * evenly.sum() ** 0.9 / 12.0**0.8, rtol=1e-4)


# Capacities and revolutions


def test_the_raceway_is_the_ring_whichever_body_it_is():
    small = roller()
    inner, outer = nh.Ring(diameter=60, length=14), nh.Ring(diameter=-90, length=14)
    of_inner, _ = raceway(nh.Contact(small, inner))
    of_outer, _ = raceway(nh.Contact(outer, small))
    assert of_inner == Raceway(15.0, 12.0, 75.0, True, "b")
    assert of_outer == Raceway(15.0, 12.0, 75.0, False, "a")
    smaller, _ = raceway(nh.Contact(nh.Roller(diameter=60, length=12), nh.Ring(diameter=40)))
    assert smaller == Raceway(60.0, 12.0, 100.0, True, "b")
    minute, _ = raceway(nh.Contact(nh.Roller(diameter=0.1, length=0.2), nh.Ring(diameter=0.8)))
    assert minute.inner
    assert minute.pitch_diameter == pytest.approx(0.9)
    for other in (nh.Plate(), nh.Ring(diameter=nh.TabulatedDiameter(y=(-8.0, 8.0), diameter=(59.0, 61.0)))):
        none, why = raceway(nh.Contact(small, other))
        assert none is None
        assert why


def test_life_in_revolutions_is_the_capacity_over_the_load(lives, logarithmic):
    ring, _ = raceway(logarithmic.contact)
    palmgren = lives["lundberg-palmgren"]
    expected = (ring.capacity(12) / logarithmic.load) ** 4 * palmgren.relative_life
    assert palmgren.million_revolutions == pytest.approx(expected, rel=1e-9)
    laminar = laminae_of(logarithmic, iso_16281()).life(ring.capacity(12))
    assert lives["iso-16281"].million_revolutions == pytest.approx(laminar, rel=1e-9)
    # Two ways to say the same: within a few per cent.
    assert laminar == pytest.approx(expected, rel=0.02)
    assert lives["zaretsky"].million_revolutions is None
    assert lives["zaretsky"].no_revolutions == "zaretsky has no capacity of its own"
    (unrated,) = assess(logarithmic, "iso-16281", body="b")
    assert (unrated.million_revolutions, unrated.no_revolutions) == (None, "it needs the number of rollers")


@pytest.mark.slow
def test_the_roller_has_no_capacity_and_other_materials_and_slopes_have_none(logarithmic):
    whys = {
        "the capacity is that of the ring, body b": assess(logarithmic, "iso-16281", rollers=12),
        "the capacity of ISO 281 holds for the slope 9/8 and the usual exponents": assess(
            logarithmic, lundberg_palmgren(slope=1.5), rollers=12, body="b"
        ),
        "the capacity of ISO 281 holds only for bearing steel": assess(
            solved(ring=nh.Ring(diameter=60, material=nh.MATERIALS["bronze"]), strips=9), "iso-16281", rollers=12
        ),
        "neither of the bodies is a ring; give one of them kind = 'ring'": assess(
            solved(ring=roller(nh.profile.straight()), strips=9), "iso-16281", rollers=12
        ),
    }
    for why, (life,) in whys.items():
        assert (life.million_revolutions, life.no_revolutions) == (None, why)


@pytest.mark.slow
def test_a_plane_grid_leaves_out_sharp_ends_too():
    straight = nh.Contact(roller(nh.profile.straight()), RING)
    laminae = [assess(nh.patch.solve(straight, load=8e3, cells=(across, 512)), "iso-16281")[0] for across in (16, 32)]
    (strips,) = assess(nh.solve(straight, load=8e3), "iso-16281")
    for life in laminae:
        # Rows of cells, too, are cut off a tenth of a half-width from the end, to a row.
        assert life.relative_life == pytest.approx(strips.relative_life, rel=0.08)
        assert any("without limit towards the sharp ends" in sentence for sentence in life.warnings)
    seen = exposure(nh.patch.solve(straight, load=8e3, cells=(8, 32)), body="b")
    assert seen.sharp == (-6.0, 6.0)
    assert not seen.counted.all()


# Spectra


@pytest.mark.filterwarnings("ignore:.*maximum pressure is uncertain")
@pytest.mark.parametrize("model", [pytest.param("lundberg-palmgren", marks=pytest.mark.slow), "iso-16281"])
def test_a_spectrum_adds_damage_as_palmgren_and_miner_do(model):
    contact = nh.Contact(roller(), RING)
    cases = [ContactLoadCase(load=8e3, share=0.25, tilt=5e-4), ContactLoadCase(load=5e3, share=0.75)]
    spectrum = solve_spectrum(contact, cases, strips=15)
    (life,) = assess(spectrum, model, rollers=12, body="b")
    alone = [assess(solution, model, rollers=12, body="b")[0] for solution, _ in spectrum]
    expected = 1.0 / sum(case.share / each.million_revolutions for case, each in zip(cases, alone, strict=True))
    assert life.million_revolutions == pytest.approx(expected, rel=1e-9)
    assert np.ptp(life.y) > 11.0
    # The density of the spectrum adds up to its damage as those of the single loads do to theirs.
    sums = [np.trapezoid(each.density, each.y) * each.reference / each.damage for each in (life, *alone)]
    assert sums[0] == pytest.approx(sums[1], rel=0.03)
    assert sums[1] == pytest.approx(sums[2], rel=0.03)
    assert life.relative_life < max(each.relative_life for each in alone)


@pytest.mark.slow
def test_one_load_twice_is_that_load(logarithmic):
    life, of_one = (
        assess(spectrum, "lundberg-palmgren", rollers=12, body="b")[0]
        for spectrum in ([(logarithmic, 0.3), (logarithmic, 0.7)], logarithmic)
    )
    assert life.relative_life == pytest.approx(of_one.relative_life, rel=1e-12)
    np.testing.assert_allclose(life.density, of_one.density, rtol=1e-9, atol=1e-12)


@pytest.mark.slow
def test_lives_are_compared_by_one_model(lives):
    shorter, longer = assess(solved(strips=9), ["zaretsky", "lundberg-palmgren"])
    assert lives["zaretsky"].over(shorter) == pytest.approx((shorter.damage / lives["zaretsky"].damage) ** (8 / 9))
    with pytest.raises(nh.InputError, match="other = 'zaretsky' must be by the model lundberg-palmgren: compare"):
        longer.over(shorter)


def test_laminae_are_compared_where_both_have_raceways_or_neither(logarithmic):
    plain = solved(ring=nh.Plate())
    (with_raceway,), (without,) = assess(logarithmic, "iso-16281", rollers=12, body="b"), assess(plain, "iso-16281")
    assert with_raceway.raceway is not None
    assert without.raceway is None
    assert without.over(without) == pytest.approx(1.0)
    assert with_raceway.over(with_raceway) == pytest.approx(1.0)
    assert np.isnan(with_raceway.over(without))
    assert np.isnan(without.over(with_raceway))
