"""The inside of bearings, guessed from catalogues."""

import dataclasses
import math

import pytest

import nonhertz as nh
from nonhertz.bearing import from_catalogue

NU206 = 30.0, 62.0, 16.0, 44e3, 36.5e3
# d, D, T, C and C_0 of the NSK HR30306J, as its maker has them.
HR30306J = 30.0, 72.0, 20.75, 59.5e3, 60e3


def tapered(*catalogue, **more):
    return from_catalogue(*catalogue, kind="tapered", **more)


def test_a_known_tapered_bearing():
    # The inside of the HR30306J as quoted in the tests of an open program that is compared with MASTA: 14
    # rollers of 10.53 x 11.65 mm on 51.56 mm. It helped to say what is usual; the guess is off by 0.8, 2.1 and 0.1 %.
    row = tapered(*HR30306J, contact_angle=math.radians(11.859)).bearing
    assert row.rollers == 14
    assert row.roller_diameter == pytest.approx(10.53, rel=0.012)
    assert row.roller_length == pytest.approx(11.65, rel=0.025)
    assert row.pitch == pytest.approx(51.56, rel=0.002)
    assert math.degrees(row.contact_angles[0]) == pytest.approx(7.85, abs=0.05)
    low, high = -0.5 * row.roller_length, 0.5 * row.roller_length
    assert row.roller.diameter(low) == pytest.approx(10.9371, rel=0.012)
    assert row.roller.diameter(high) == pytest.approx(10.1233, rel=0.012)


def test_a_tapered_bearing_that_did_not_say_what_is_usual():
    # Timken LM12749/LM12710: 17 rollers 10.8 mm long, cup angle 11 deg 32' (Zhou and Hoeprich, J. Tribol. 113, 1991,
    # Fig. 9). The ratings are recalled from a catalogue. Their effective length is less than the 10.8 mm over all.
    guess = tapered(21.986, 45.237, 15.494, 27.5e3, 31e3, contact_angle=math.radians(11.0 + 32.0 / 60.0))
    assert guess.bearing.rollers == 17
    assert 8.5 < guess.bearing.roller_length < 10.8


def test_a_cylindrical_bearing_whose_raceways_stand_in_the_catalogue():
    # 13 rollers of 9 x 10 mm, effective length 8.8 mm, between 37.5 and 55.5 mm: the example of these pages.
    given = from_catalogue(*NU206, inner_raceway=37.5, outer_raceway=55.5)
    assert given.bearing.rollers == 13
    assert given.bearing.roller_diameter == 9.0
    assert given.bearing.roller_length == pytest.approx(8.8, abs=0.02)
    # Without them the diameter is found to 1 %, and the ratings stay those of the catalogue.
    blind = from_catalogue(*NU206)
    assert blind.bearing.rollers == 13
    assert blind.bearing.roller_diameter == pytest.approx(9.0, rel=0.01)
    assert blind.bearing.pitch == pytest.approx(46.5, rel=0.002)
    for name, raceway in (("inner_raceway", 37.5), ("outer_raceway", 55.5)):
        one = from_catalogue(*NU206, **{name: raceway}).bearing
        assert abs(getattr(one, name.removesuffix("_raceway")).diameter) == raceway
        assert one.roller_diameter == pytest.approx(9.0, rel=0.015)


@pytest.mark.parametrize(
    "guess",
    [
        from_catalogue(*NU206),
        from_catalogue(25, 42, 17, 24.2e3, 34.5e3, kind="needle"),
        tapered(*HR30306J, limiting_ratio=0.31),
    ],
    ids=["cylindrical", "needle", "tapered"],
)
def test_the_guess_has_the_static_rating_and_says_how_far_off_the_other_is(guess):
    # By the ratings of the bearing, which know nothing of the guess.
    rated = nh.bearing.rating(guess.bearing)
    assert rated == guess.rated
    assert rated.static == pytest.approx(guess.static, rel=1e-9)
    assert 0.9 < guess.dynamic / rated.dynamic < 1.2
    assert guess.rollers[0] <= guess.bearing.rollers <= guess.rollers[1]
    solved = nh.bearing.solve(
        guess.bearing, radial=3e3, axial=None if guess.bearing.nominal_angle == 0.0 else 2e3, method="slices"
    )
    life = nh.bearing.assess(solved, dynamic=guess.dynamic, static=guess.static)
    assert life.rating.dynamic == guess.dynamic


@pytest.mark.parametrize(
    ("catalogue", "limiting_ratio"),
    [(HR30306J, 0.31), ((30.0, 72.0, 20.75, 47.3e3, 50e3), 0.83)],  # the other a 31306, of 29 degrees
    ids=["30306", "31306"],
)
def test_cones_of_a_guess_meet_in_one_point(catalogue, limiting_ratio):
    row = tapered(*catalogue, limiting_ratio=limiting_ratio).bearing
    apex = 0.5 * row.pitch / math.tan(0.5 * sum(row.contact_angles))
    for ring, angle in zip((row.inner, row.outer), row.contact_angles, strict=True):
        assert 0.5 * abs(ring.diameter) / math.tan(angle) == pytest.approx(apex)
    along = apex / math.cos(0.5 * sum(row.contact_angles))
    assert row.roller_diameter / along == pytest.approx(2.0 * math.tan(row.half_cone_angle))
    # So rollers fill the room exactly: other diameters than those within 2 % are refused, on either side.
    for by in (0.985, 1.015):
        dataclasses.replace(row, roller=narrowed(row.roller, by))
    for by in (0.975, 1.025):
        with pytest.raises(nh.InputError, match="must fill"):
            dataclasses.replace(row, roller=narrowed(row.roller, by))


@pytest.mark.parametrize("angle", [15.0, 30.0, 38.0, 41.0])
def test_raceways_lie_between_bore_and_outside_diameter_at_their_ends_too(angle):
    row = tapered(40.0, 80.0, 19.75, 75e3, 68e3, contact_angle=math.radians(angle)).bearing
    inner, outer = (
        abs(ring.diameter) + sign * row.roller_length * math.sin(of)
        for ring, of, sign in zip((row.inner, row.outer), row.contact_angles, (-1.0, 1.0), strict=True)
    )
    assert inner > 40.0
    assert outer < 80.0


def narrowed(roller, by):
    """Return a roller with other diameters and the same cone angle."""
    less = (by - 1.0) * sum(roller.diameter.diameter) / 2.0
    return dataclasses.replace(
        roller,
        diameter=nh.TabulatedDiameter(roller.diameter.y, tuple(each + less for each in roller.diameter.diameter)),
    )


def test_three_ways_to_say_the_contact_angle():
    angle = 0.2
    rows = [
        tapered(*HR30306J, contact_angle=angle),
        tapered(*HR30306J, limiting_ratio=1.5 * math.tan(angle)),
        tapered(*HR30306J, axial_factor=0.4 / math.tan(angle)),
    ]
    for each in rows:
        assert each.bearing.contact_angle == pytest.approx(angle)
    # e = 0.31 and Y = 1.9 of the maker mean 11.7 and 11.9 degrees; it has 11.859.
    assert math.degrees(tapered(*HR30306J, limiting_ratio=0.31).bearing.contact_angle) == pytest.approx(11.859, abs=0.2)
    assert math.degrees(tapered(*HR30306J, axial_factor=1.9).bearing.contact_angle) == pytest.approx(11.859, abs=0.2)


def test_a_bearing_twice_as_large_is_guessed_twice_as_large():
    # C_0 grows with the square of lengths, C with the power 7/9 + 29/27.
    d, outside, width, dynamic, static = NU206
    small, large = (
        from_catalogue(
            by * d, by * outside, by * width, by ** (50 / 27) * dynamic, by**2 * static, clearance=0.03
        ).bearing
        for by in (1.0, 2.0)
    )
    assert large.rollers == small.rollers
    assert large.roller_diameter == pytest.approx(2.0 * small.roller_diameter, rel=1e-3)
    assert large.roller_length == pytest.approx(2.0 * small.roller_length, rel=1e-3)


# Bores [mm], least and most [um], as catalogues of SKF and NSK print them.
NORMAL_CLEARANCE = [
    (45, 30, 60), (60, 40, 70), (75, 40, 75), (95, 50, 85), (115, 50, 90), (130, 60, 105), (150, 70, 120),
    (170, 75, 125), (190, 90, 145), (220, 105, 165), (240, 110, 175), (260, 125, 195), (300, 130, 205),
]  # fmt: skip


def test_clearance_is_the_middle_of_the_normal_group():
    # ISO 5753-1, cylindrical bore: 20 to 45 um up to a bore of 30 mm, 25 to 50 above.
    assert from_catalogue(*NU206).bearing.clearance == pytest.approx(0.0325)
    assert from_catalogue(35, 72, 17, 56e3, 48e3).bearing.clearance == pytest.approx(0.0375)
    for bore, least, most in NORMAL_CLEARANCE:
        by = bore / 30.0
        d, outside, width, dynamic, static = NU206
        sizes = (by * d, by * outside, by * width, by ** (50 / 27) * dynamic, by**2 * static)
        assert from_catalogue(*sizes).bearing.clearance == pytest.approx(0.5e-3 * (least + most))
    assert from_catalogue(*NU206, clearance=0.01).bearing.clearance == 0.01
    assert tapered(*HR30306J, limiting_ratio=0.31).bearing.clearance == 0.0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: from_catalogue(62, 30, 16, 44e3, 36.5e3), "outside_diameter = 30.0 must exceed the bore of 62 mm"),
        (lambda: from_catalogue(30, 62, 16, 44.0, 36.5), "static = 36.5 must be that of rollers which fit between rin"),
        (lambda: from_catalogue(30, 62, 16, 44.0, 36.5e3), "dynamic = 44.0 must be near 3"),
        (lambda: from_catalogue(30, 62, 16, 44e3, 90e3), "static = 90000.0 must be that of rollers which fit"),
        (lambda: from_catalogue(*NU206, contact_angle=0.2), "contact_angle = 0.2 must be left out for a cylindrical"),
        (lambda: tapered(*HR30306J), "contact_angle must be given for a tapered bearing"),
        (lambda: tapered(*HR30306J, contact_angle=0.2, axial_factor=1.9), "must not be given together with axial_fact"),
        (lambda: tapered(*HR30306J, contact_angle=12.0), "contact_angle = 12.0 must mean no more than 0.7854 rad"),
        (lambda: tapered(*HR30306J, limiting_ratio=0.31, inner_raceway=40), "inner_raceway = 40.0 must be left out"),
        (lambda: from_catalogue(*NU206, inner_raceway=29), "inner_raceway = 29.0 must lie between 30 and 62 mm"),
        (
            lambda: from_catalogue(*NU206, inner_raceway=37.5, outer_raceway=36),
            "outer_raceway = 36.0 must lie between 3",
        ),
        (lambda: from_catalogue(1200, 1420, 106, 3e6, 6.5e6), "clearance must be given for a bore of more than"),
    ],
)
def test_what_is_in_no_catalogue_is_refused(make, message):
    with pytest.raises(nh.InputError) as raised:
        make()
    assert message in str(raised.value)
