"""What `solve` refuses, each with one sentence, and what it warns of."""

import math
import re
from dataclasses import dataclass
from decimal import Decimal

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import shown, without_accuracy_warnings
from nonhertz.model.prescription import loads_between
from nonhertz.model.profile import Profile


@dataclass(frozen=True)
class Gone(Profile):
    """No body anywhere."""

    def relief(self, y):
        return np.full_like(np.asarray(y, dtype=float), np.inf)


def roller(**changes):
    return nh.Roller(**({"diameter": 20, "length": 20, "profile": nh.profile.crown(4000)} | changes))


CONTACT = nh.Contact(roller(), nh.Plate())
OFF_CENTRE = nh.Contact(roller(position=20.0, profile=nh.profile.straight()), nh.Plate())
LOAD = {"load": 1000.0}


def refusal(contact=CONTACT, **arguments):
    """The sentence with which these arguments are refused, split at its colon."""
    with pytest.raises(nh.InputError) as refused:
        nh.solve(contact, **arguments)
    said, _, remedy = str(refused.value).partition(": ")
    assert re.fullmatch(r"[a-z].*[^.]\.", remedy), str(refused.value)
    return said


# Prescribed quantities


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ({}, "load must be given"),
        (
            {"load": 1.0, "approach": 0.1},
            "approach = 0.1 must not be given together with load",
        ),
        ({**LOAD, "tilt": 0.0, "moment": 5.0}, "moment = 5.0 must not be given together with tilt"),
        ({"load": "1 mm"}, "load = '1 mm' must have a unit of force"),
    ],
)
def test_impossible_prescriptions_are_refused(arguments, complaint):
    assert refusal(**arguments) == complaint


@pytest.mark.parametrize(
    "contact", [CONTACT, OFF_CENTRE, nh.Contact(roller(length=1e-6), nh.Plate())], ids=["a", "b", "c"]
)
@pytest.mark.parametrize("share", [0.5, 1e-30, 1e-280])
def test_loads_that_rounding_hides_are_refused_and_the_least_is_named(contact, share):
    least, _ = loads_between(contact)
    said = refusal(contact, load=share * least)
    assert said == f"load = {shown(share * least)} must be at least {least:.2g} N for bodies of this size and stiffness"
    with pytest.raises(nh.InputError, match=r"case 1\.load"):
        nh.solve_many(contact, load=[1e3 * least, share * least])
    assert nh.solve(contact, load=2.0 * least).load == pytest.approx(2.0 * least, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("load", [1e20, 1e300])
def test_loads_that_bodies_vanish_under_are_refused(load):
    ellipse = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(100)), nh.Body())
    assert "must leave the contact narrower than the bodies" in refusal(ellipse, load=load)


def test_an_approach_is_not_refused_in_a_false_sentence():
    ellipse = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(100)), nh.Body())
    assert refusal(ellipse, approach=1e-100) == "approach = 1e-100 must lead to a contact that strips can resolve"


@pytest.mark.parametrize("strips", [None, 41])
def test_an_approach_that_never_touches_is_refused(strips):
    said = refusal(approach=-0.5, strips=strips)
    region = " between y = -10 and 10 mm" if strips else ""
    assert re.fullmatch(rf"approach = -0\.5 must exceed \S+ mm, where the bodies begin to touch{region}", said)


def test_the_approach_of_first_touch_is_where_it_says():
    # A tilted crown touches first at y = tilt R, where the interference is approach + tilt^2 R / 2.
    said = refusal(approach=-0.5, tilt=1e-3)
    first_touch = float(re.search(r"exceed (\S+) mm", said)[1])
    np.testing.assert_allclose(first_touch, -0.5e-6 * 4000.0, rtol=0.02, atol=0.0)


@pytest.mark.parametrize("approach", [1e-5, 1e-6])
def test_an_approach_that_barely_touches_is_solved(approach):
    # Hertz, to the resolution of strips on a contact of a hundredth of the body's length.
    contact = nh.Contact(roller(side_faces="none", depth="none"), nh.Plate())
    compliance = contact.compliance
    hertz = nh.hertz.point_contact(radius_x=10, radius_y=4000, compliance=compliance, approach=approach)
    solution = nh.solve(contact, approach=approach)
    np.testing.assert_allclose(solution.load, hertz.load, rtol=1e-3, atol=0.0)


@pytest.mark.parametrize("moment", [10.001e3, -10.001e3, 1e9])
def test_a_resultant_outside_the_bodies_is_refused(moment):
    said = refusal(**LOAD, moment=moment)
    assert said.startswith(f"moment = {moment!r} must ")
    assert "moment / load between" in said


def test_a_moment_that_no_strip_can_give_is_refused():
    # All of the roller lies at y > 0, so that any pressure has a positive moment.
    assert refusal(OFF_CENTRE, approach=0.01, moment=-100.0).startswith("moment = -100.0 must ")
    assert "must bring the bodies into contact" in refusal(OFF_CENTRE, approach=0.01, moment=0.0)


# Strips


@pytest.mark.parametrize("strips", [0, 2001, -4])
def test_too_few_or_too_many_strips_are_refused(strips):
    assert refusal(**LOAD, strips=strips) == f"strips = {strips} must lie between 1 and 2000"


@pytest.mark.parametrize(
    ("edges", "condition"),
    [
        ([0.0], "be a row of 2 to 2001 edges"),
        (np.linspace(-10.0, 10.0, 2002), "be a row of 2 to 2001 edges"),
        ([[-1.0, 0.0], [1.0, 2.0]], "be a row of 2 to 2001 edges"),
        ([-1.0, -2.0, 0.0, 1.0], "be ascending and finite"),
        ([-1.0, 0.0, 0.0, 1.0], "be ascending and finite"),
        ([-1.0, 0.0, math.nan, 1.0], "be ascending and finite"),
        ([-11.0, 0.0, 1.0, 2.0], "lie between -10.0 and 10.0"),
        ([-1.0, 0.0, 1.0, 10.1], "lie between -10.0 and 10.0"),
        (["a", "b", "c", "d"], "be ascending and finite"),
    ],
)
def test_impossible_edges_are_refused(edges, condition):
    said = refusal(**LOAD, strips=edges)
    assert said.startswith("strips = ")
    assert said.endswith(" must " + condition)


# Contacts


def test_what_the_accuracy_is_of_is_a_word_beside_an_automatic_grid():
    assert refusal(**LOAD, accuracy_of="load") == "accuracy_of = 'load' must be one of 'approach', 'pressure'"
    said = refusal(**LOAD, accuracy_of="pressure", strips=41)
    assert said == "accuracy_of = 'pressure' must be given only where the grid is automatic"
    assert "accuracy = 0.1 must lie between" in refusal(**LOAD, accuracy_of="pressure", accuracy=0.1)


def test_a_relief_without_end_is_refused():
    said = refusal(nh.Contact(roller(profile=Gone()), nh.Plate()), **LOAD)
    assert said == "profile = inf must leave a finite separation somewhere on the bodies"


# Warned of


def test_a_sound_contact_gives_no_warning():
    # Warnings are errors in these tests; the sharp ends are noted in the solution only.
    assert nh.solve(CONTACT, load=3000).warnings == ()


def test_a_contact_wider_than_long_warns_with_the_ratio():
    contact = nh.Contact(nh.Body(diameter=100, profile=nh.profile.crown(5)), nh.Plate())
    hertz = nh.hertz.point_contact(radius_x=50, radius_y=5, compliance=contact.compliance, load=500)
    with pytest.warns(nh.AccuracyWarning, match="wider than long: width / length") as caught:
        solution = nh.solve(contact, load=500)
    assert len(caught) == 1
    assert solution.warnings == (str(caught[0].message),)
    ratio = float(re.search(r"width / length = (\S+),", solution.warnings[0])[1])
    # 5 % off Hertz is what the warning is about.
    np.testing.assert_allclose(ratio, 1.0 / hertz.ellipticity, rtol=0.1, atol=0.0)


def test_a_half_width_large_against_the_radius_warns_with_the_ratio():
    # Silicone on steel: b / R about 0.35.
    soft = nh.Material(modulus=10, poisson=0.49)
    contact = nh.Contact(nh.Roller(diameter=20, length=200, material=soft, side_faces="mirror"), nh.Plate())
    with pytest.warns(nh.AccuracyWarning) as caught:
        solution = nh.solve(contact, load=2500, strips=21)
    pattern = r"half-width is 0\.\d\d of the smaller radius .* over 0\.3"
    assert any(re.search(pattern, str(each.message)) for each in caught)
    said = next(text for text in solution.warnings if "half-width" in text)
    ratio = float(re.search(r"is (0\.\d\d) of", said)[1])
    assert abs(ratio - solution.half_width.max() / 10.0) < 0.006  # two decimals are printed


def test_a_sharp_end_in_contact_is_named_in_the_solution():
    solution = nh.solve(CONTACT, load=20e3)
    for said, place in zip(solution.warnings, ("-10", "10"), strict=True):
        assert f"sharp end at y = {place} mm" in said
    with pytest.warns(nh.AccuracyWarning, match="sharp end at y = 10 mm"):
        nh.solve(CONTACT, load=20e3)


@pytest.mark.parametrize("strips", [None, 41])
@pytest.mark.parametrize("given", [{"load": 20e3}, {"approach": 0.01}, {"load": 20e3, "moment": 3e3}], ids=str)
def test_a_body_thinner_than_its_contact_is_refused_in_one_sentence(given, strips):
    # Warnings are errors here: nothing may be divided by zero on the way to the sentence.
    words = r"body.a.depth = .* must be large compared with the half-width of the contact"
    for depth in (1e-5, 0.01, 0.05, 0.1, 0.2):
        for beside in ("none", depth):
            contact = nh.Contact(nh.Roller(diameter=20, length=20, depth=depth), nh.Plate(depth=beside))
            with pytest.raises(nh.InputError, match=words):
                nh.solve(contact, strips=strips, **given)


def test_a_body_that_is_rather_thin_is_warned_of():
    with pytest.warns(nh.AccuracyWarning, match="depth of body b is only"):
        solution = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate(depth=0.8)), load=20e3)
    assert solution.status is nh.Status.CONVERGED


def test_an_approach_that_no_thin_body_reaches_is_refused():
    # Where the half-width comes near to the depth the approach of a line contact turns back.
    soft = nh.Roller(diameter=1800, length=18000, depth=30, material=nh.Material(20000, 0.41))
    softer = nh.Body(diameter=7000, length=18000, depth=6, material=nh.Material(1000, 0.07))
    with pytest.raises(nh.InputError, match=r"body.b.depth = 6.0 must be large"):
        nh.solve(nh.Contact(soft, softer), approach=0.020, strips=24)


def test_a_thin_part_that_does_not_touch_does_not_matter():
    stepped = nh.TabulatedDiameter(y=(-10, -7, -6.9, 10), diameter=(0.2, 0.2, 20, 20))
    roller = nh.Roller(diameter=stepped, length=20, profile=nh.profile.crown(radius=500))
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=10e3)
    assert solution.status is nh.Status.CONVERGED


# Moments next to the ends


def test_a_moment_just_inside_the_end_of_a_logarithm_without_a_body_end():
    # The relief alone ends the contact: arms up to there are solved, or refused in words.
    logarithmic = nh.Contact(nh.Body(diameter=20, profile=nh.profile.iso_logarithmic(20, 20)), nh.Plate())
    solution = nh.solve(logarithmic, load=1e3, moment=9.5e3)
    np.testing.assert_allclose(solution.moment, 9.5e3, rtol=1e-8, atol=0.0)
    with pytest.raises(nh.ConvergenceError, match="Try another number of strips"):
        nh.solve(logarithmic, load=1e3, moment=9999.9999)
    beyond = r"moment / load = 11 mm between -10 and 10 mm: reduce it or raise the load"
    with pytest.raises(nh.InputError, match=beyond) as refused:
        nh.solve(logarithmic, load=1e3, moment=11e3)
    assert refused.value.field == "moment"
    np.testing.assert_allclose(refused.value.value, 11e3, rtol=1e-12, atol=0.0)


def test_a_series_of_images_is_refused_under_a_contact_much_wider_than_the_body():
    # Its far images are line loads, 5 % off in the gap where the half-width is 16 lengths.
    wide = nh.Contact(
        nh.Ring(diameter=-252.7, length=1.12, side_faces="mirror", images="series", depth=168.6),
        nh.Roller(diameter=93.5, length=1.12, side_faces="mirror", depth="none"),
    )
    with pytest.raises(
        nh.InputError, match=r"body.a.images = 'series' must only be used where the half-width, 22\.2 mm here"
    ):
        nh.solve(wide, approach=10.0, strips=2)


def test_a_contact_wider_than_a_body_is_round_is_refused_alone_and_among_many():
    # A load in the wrong unit: as wide as that no roller is.
    roller = nh.Roller(diameter=2, length=20, side_faces="none", depth="none")
    contact = nh.Contact(roller, nh.Plate(depth="none"))
    with pytest.raises(nh.InputError, match=r"must leave the half-width, .* below the radius of 1 mm") as refused:
        nh.solve(contact, load=8e6, strips=41)
    assert (refused.value.field, refused.value.value) == ("load", 8e6)
    many = nh.solve_many(contact, load=[1e3, 8e6], strips=41)
    assert str(many.failures[1]) == str(refused.value)
    assert many.converged.tolist() == [True, False]


@pytest.mark.parametrize(
    ("roller", "given"),
    [
        ({}, {"load": 1e9}),
        ({}, {"approach": 40.0}),
        ({"bore": 18.0}, {"load": 2e5}),
    ],
)
@pytest.mark.slow
def test_bodies_too_small_for_the_load_refuse_what_was_given(roller, given):
    contact = nh.Contact(nh.Roller(**({"diameter": 20.0, "length": 20.0} | roller)), nh.Plate())
    name, value = next(iter(given.items()))
    said = rf"^{name} = {value} must leave the half-width, .* (radius of 10 mm|mm of body a)"
    with without_accuracy_warnings():
        for solve in (nh.solve, nh.patch.solve):
            with pytest.raises(nh.InputError, match=said):
                solve(contact, **given)
        # The way out is one.
        assert nh.solve(contact, **(given | {name: 1e-3 * value})).load > 0.0


@pytest.mark.parametrize("tilt", [0.5, -0.301])
def test_a_tilt_in_the_wrong_unit_is_refused_alone_and_among_many(tilt):
    contact = nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate())
    with pytest.raises(nh.InputError, match=r"must be a small angle, of at most 0\.3 rad: give it in rad"):
        nh.solve(contact, load=1e3, tilt=tilt)
    with pytest.raises(nh.InputError, match=r"case 1\.tilt"):
        nh.solve_many(contact, load=1e3, tilt=[1e-3, tilt], strips=11)


def test_a_pressure_that_no_material_bears_is_told_alone_and_among_many():
    contact = nh.Contact(nh.Roller(diameter=20, length=20, side_faces="mirror", depth="none"), nh.Plate())
    with pytest.warns(nh.AccuracyWarning) as caught:
        nh.solve(contact, load=20e6, strips=21)
    assert any(re.search(r"mean pressure is \S+ MPa, 0\.\d+ of the softer", str(each.message)) for each in caught)
    with pytest.warns(nh.AccuracyWarning, match="1 of 2 cases") as among_many:
        many = nh.solve_many(contact, load=[20e3, 20e6], strips=41)
    assert {each.filename for each in (*caught, *among_many)} == {__file__}
    assert any("of the softer body's modulus" in said for said in many.warnings[1])


def in_decimals(position, length):
    """Return the ends of a body as one writes them down."""
    half = Decimal(str(length)) / 2
    return float(Decimal(str(position)) - half), float(Decimal(str(position)) + half)


def at_position(position, length, held):
    """Return a straight roller at a position along a plate, which ends with it in one of three ways."""
    keys = {
        "length": {"length": length},
        "effective_length": {"length": 25.0, "effective_length": length},
        "table": {"length": 25.0, "profile": nh.profile.tabulated([-length / 2, length / 2], [0.0, 0.0])},
    }[held]
    return nh.Contact(nh.Roller(diameter=15.0, position=position, side_faces="mirror", **keys), nh.Plate())


def solved_quietly(contact, strips):
    with without_accuracy_warnings():
        return nh.solve(contact, load=5e3, strips=strips)


POSITIONS, LENGTHS = (0.1, 0.3, -0.7, 1.1, 12.3), (10.7, 9.4, 8.2, 20.2, 9.6)
OFF = (0.0, 4e-10, -4e-10)  # of the length


@pytest.mark.parametrize("held", ["length", "effective_length", "table"])
@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("position", POSITIONS)
def test_edges_in_decimals_that_end_with_a_body_end_there(position, length, held):
    share = np.array([0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0])
    centred = at_position(0.0, length, held)
    low, high = centred.interval
    # The same body in the middle, on the same strips.
    expected = solved_quietly(centred, low + length * share)
    ends = in_decimals(position, length)
    for off in OFF:
        edges = ends[0] + length * share
        edges[[0, -1]] = ends[0] + off * length, ends[1] - off * length
        found = solved_quietly(at_position(position, length, held), edges)
        assert [end.kind for end in found.edge_pressure] == [nh.EdgeKind.SINGULAR] * 2
        assert found.max_pressure == pytest.approx(expected.max_pressure, rel=1e-8)
        # A node of a mesh at the end is on the body, too.
        on_end = found.pressure(0.0, np.array(ends))
        np.testing.assert_allclose(on_end, expected.pressure(0.0, np.array([low, high])), rtol=1e-7)
        assert np.all(np.isfinite(found.contact.a.relief(edges[[0, -1]])))


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("position", POSITIONS)
def test_sections_regions_and_stations_in_decimals_may_lie_on_the_ends_of_a_body(position, length):
    contact, ends = at_position(position, length, "length"), np.array(in_decimals(position, length))
    solution = solved_quietly(contact, 8)
    for end in ends:
        assert np.all(np.isfinite(nh.subsurface.stress(solution, 0.0, end, 0.2).von_mises))
    region = ((-1.0, 1.0), (ends[0], ends[1]))
    with without_accuracy_warnings():
        patch = nh.patch.solve(contact, load=5e3, region=region, cells=(16, 16))
    assert [end.kind for end in patch.singular_ends] == [nh.EdgeKind.SINGULAR] * 2
    for end in ends:
        assert patch.across(end)[1].shape == (16,)


@pytest.mark.slow
@pytest.mark.parametrize(("position", "length"), [(0.1, 10.7), (0.3, 9.4), (-0.7, 10.7)])
def test_stations_of_a_map_in_decimals_may_end_with_a_body(position, length):
    roller = nh.Roller(diameter=15.0, length=length, position=position, profile=nh.profile.crown(radius=900.0))
    ends = in_decimals(position, length)
    made = nh.contact_map(nh.Contact(roller, nh.Plate()), load=(10.0, 2e3), stations=np.linspace(*ends, 5))
    assert float(np.sum(made.strip_loads(made.under(load=1e3)))) == pytest.approx(1e3, rel=2e-3)


def test_an_edge_that_is_farther_out_than_a_rounding_is_refused():
    low, high = in_decimals(0.1, 10.7)
    edges = np.linspace(low, high + 1e-7, 9)
    with pytest.raises(nh.InputError, match=r"strips = \(-5.25, 5.4500001\) must lie between -5.25 and 5.45"):
        nh.solve(at_position(0.1, 10.7, "length"), load=5e3, strips=edges)
