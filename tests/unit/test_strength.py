"""Does it yield: exact fields of Hertz's line contact, and what is said where something is not known.

On the axis below Hertz's line contact, with s = z / b: sigma_x = -p0 ((1 + 2 s^2) / r - 2 s), sigma_z = -p0 / r,
r = sqrt(1 + s^2), sigma_y = nu (sigma_x + sigma_z) (K. L. Johnson, Contact Mechanics, Cambridge University Press 1985,
section 4.2); so the maximum shear stress is p0 (s - s^2 / r).
"""

import dataclasses
import math
import re

import pytest
from scipy.optimize import minimize_scalar

import nonhertz as nh
from nonhertz.amounts import format_input
from nonhertz.strength import CRITERIA, CheckStatus, assess, judge
from nonhertz.subsurface import extremes

MODULUS, POISSON = 207000.0, 0.3
KNOWN = {"yield_strength": 1500.0, "core_yield_strength": 700.0, "pressure_limit": 4000.0}


def von_mises_on_axis(s):
    """Return the von Mises stress over p0 at a depth over b."""
    root = math.sqrt(1.0 + s * s)
    x, z = -((1.0 + 2.0 * s * s) / root - 2.0 * s), -1.0 / root
    y = POISSON * (x + z)
    return math.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2))


def shear_on_axis(s):
    """Return the maximum shear stress over p0 at a depth over b."""
    return s - s * s / math.sqrt(1.0 + s * s)


def largest_of(stress):
    found = minimize_scalar(lambda s: -stress(s), bounds=(0.1, 2.0), method="bounded", options={"xatol": 1e-10})
    return -found.fun, found.x


def line_contact(**body):
    """Return equal rollers whose ends coincide, mirrored for ever: Hertz's line contact from end to end."""
    material = nh.Material(MODULUS, POISSON, **{name: body.pop(name) for name in list(body) if name in KNOWN})
    roller = nh.Roller(diameter=20, length=10, side_faces="mirror", images="series", material=material, **body)
    return nh.solve(nh.Contact(roller, roller), load=10e3, strips=11)


@pytest.fixture(scope="module")
def plain():
    return line_contact()


def with_material(solution, **known):
    """Return a solution with other strengths, on which it does not depend."""
    depth = known.pop("case_depth", None)
    material = nh.Material(MODULUS, POISSON, **known)
    a = dataclasses.replace(solution.contact.a, material=material, case_depth=depth)
    return dataclasses.replace(solution, contact=dataclasses.replace(solution.contact, a=a))


def crowned(load=6e3, profile=None, solve=nh.solve, **body):
    material = nh.Material(MODULUS, POISSON, **{name: body.pop(name) for name in list(body) if name in KNOWN})
    profile = nh.profile.crown(radius=2000) if profile is None else profile
    roller = nh.Roller(diameter=20, length=20, profile=profile, material=material, **body)
    return solve(nh.Contact(roller, nh.Plate()), load=load)


@pytest.fixture(scope="module")
def largest(plain):
    return extremes(plain)


# Exact results


def test_what_is_known_of_the_line_contact_is_what_johnson_prints():
    assert [round(value, 3) for value in largest_of(von_mises_on_axis)] == [0.558, 0.704]
    assert [round(value, 3) for value in largest_of(shear_on_axis)] == [0.300, 0.786]
    # Section 6.1: yielding begins at p0 = 1.79 Y by von Mises and 1.67 Y = 3.3 k by Tresca, whose k is Y / 2.
    assert round(1.0 / largest_of(von_mises_on_axis)[0], 2) == 1.79
    assert round(0.5 / largest_of(shear_on_axis)[0], 2) == 1.67


@pytest.mark.slow
@pytest.mark.parametrize(
    ("criterion", "pressure_over_strength"),
    [("von-mises", 1.0 / largest_of(von_mises_on_axis)[0]), ("tresca", 0.5 / largest_of(shear_on_axis)[0])],
)
def test_a_line_contact_yields_from_the_exact_pressure_on(plain, criterion, pressure_over_strength, largest):
    # The search is within 1e-5 of the largest stress, strips within 1e-6 of Hertz's pressure.
    for factor, verdict in ((1.0 + 1e-4, CheckStatus.FINE), (1.0 - 1e-4, CheckStatus.OVER)):
        strength = factor * plain.max_pressure / pressure_over_strength
        found = assess(with_material(plain, yield_strength=strength), criterion=criterion, largest=largest)
        assert found.yield_ratio == pytest.approx(1.0 / factor, rel=2e-5)
        assert found.checks[1].verdict is verdict
        assert CRITERIA[criterion] in found.checks[1].sentence


@pytest.mark.slow
@pytest.mark.parametrize("depth", [1.0, 2.0])
def test_the_core_bears_the_stress_at_the_case_core_boundary(plain, largest, depth):
    # Below the depth of the largest stress, it is largest at the boundary; for nu = 0.3 on the axis.
    half_width, pressure = plain.max_half_width, plain.max_pressure
    solution = with_material(plain, **KNOWN, case_depth=depth * half_width)
    found = assess(solution, largest=largest)
    assert found.core_yield_ratio == pytest.approx(von_mises_on_axis(depth) * pressure / 700.0, rel=1e-4)
    assert found.core.von_mises.z == pytest.approx(depth * half_width, rel=1e-6)
    tresca = assess(solution, criterion="tresca", largest=largest)
    assert tresca.core_yield_ratio == pytest.approx(2.0 * shear_on_axis(depth) * pressure / 700.0, rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize(("depth", "verdict"), [(0.78, CheckStatus.OVER), (0.79, CheckStatus.FINE)])
def test_a_case_has_to_reach_below_the_largest_shear_stresses(plain, largest, depth, verdict):
    # The maximum shear stress is largest at 0.786 b, the orthogonal one at 0.5 b.
    found = assess(with_material(plain, **KNOWN, case_depth=depth * plain.max_half_width), largest=largest)
    check = found.checks[3]
    assert (check.name, check.verdict) == ("case depth", verdict)
    assert check.ratio == pytest.approx(largest_of(shear_on_axis)[1] / depth, rel=2e-3)
    assert found.largest.orthogonal_shear.z == pytest.approx(0.5 * plain.max_half_width, rel=2e-3)
    assert found.largest.orthogonal_shear.max == pytest.approx(0.25 * plain.max_pressure, rel=1e-4)


@pytest.mark.slow
def test_a_case_has_to_reach_below_the_middle_where_the_ends_are_stressed_more():
    # A peak of the pressure beside the corner, half as wide as the contact in the middle, has the largest stress.
    solution = crowned(12e3, profile=nh.profile.crown(radius=4000), corner_radius=0.5, **KNOWN, case_depth=0.1)
    found = assess(solution)
    assert found.largest.shear.z < 0.1
    check = found.checks[3]
    assert check.verdict is CheckStatus.OVER
    middle = extremes(solution, 0.0).shear.z
    assert check.ratio == pytest.approx(middle / 0.1, rel=0.01)


@pytest.mark.slow
def test_a_shallow_case_yields_by_the_stress_within_it(plain, largest):
    found = assess(with_material(plain, **KNOWN, case_depth=0.3 * plain.max_half_width), largest=largest)
    within = extremes(plain, depths=(0.0, 0.3 * plain.max_half_width)).von_mises.max
    assert within < 0.95 * found.largest.von_mises.max
    assert found.yield_ratio == pytest.approx(within / 1500.0, rel=1e-6)
    assert found.core_yield_ratio == pytest.approx(found.largest.von_mises.max / 700.0, rel=1e-5)


@pytest.mark.slow
def test_static_safety_is_the_square_of_the_pressures(plain, largest):
    found = assess(with_material(plain, pressure_limit=2.0 * plain.max_pressure), largest=largest)
    assert found.static_safety == pytest.approx(4.0, rel=1e-12)
    assert found.checks[0].sentence.endswith(
        f"MPa is 50 % of the limit of body a, {format_input(2.0 * plain.max_pressure)} MPa: static safety S0 = 4.00 "
        "as for a line contact."
    )
    over = assess(with_material(plain, pressure_limit=0.8 * plain.max_pressure), largest=largest)
    assert over.static_safety == pytest.approx(0.64, rel=1e-12)
    assert over.verdict is CheckStatus.OVER
    assert " by 25 %: static safety S0 = 0.640 as for a line contact." in over.sentences[0]


# What is not known


@pytest.mark.slow
def test_what_is_not_given_is_not_known(plain):
    found = assess(plain)
    assert found.verdict is CheckStatus.UNKNOWN
    assert math.isnan(found.static_safety)
    assert math.isnan(found.yield_ratio)
    assert math.isnan(found.core_yield_ratio)
    assert found.sentences[0] == "Static safety is not known: the material of body a has no pressure limit."
    assert found.sentences[1].startswith(
        "Whether body a yields is not known: the material has no yield strength; its largest von Mises stress is "
    )
    assert len(found.checks) == 2


@pytest.mark.slow
def test_a_core_without_a_depth_or_a_strength_is_not_known(plain, largest):
    found = assess(with_material(plain, **KNOWN), largest=largest)
    assert found.checks[2].sentence == "Whether the core of body a yields is not known: the body has no case depth."
    assert found.checks[2].verdict is CheckStatus.UNKNOWN
    found = assess(with_material(plain, yield_strength=1500.0, case_depth=1.0), largest=largest)
    assert found.checks[2].sentence.startswith("Whether the core of body a yields is not known: the material has no")
    assert math.isnan(found.core_yield_ratio)


@pytest.mark.slow
def test_a_sharp_end_leaves_no_confident_number():
    found = assess(crowned(profile=nh.profile.straight(), **KNOWN, case_depth=1.0))
    assert {check.verdict for check in found.checks} == {CheckStatus.UNKNOWN}
    assert all(math.isnan(check.ratio) for check in found.checks)
    assert all("the sharp ends at y = -10 and 10 mm" in sentence for sentence in found.sentences)
    assert found.warnings


@pytest.mark.slow
def test_what_yields_away_from_a_sharp_end_yields():
    found = assess(crowned(60e3, **KNOWN, case_depth=0.3))
    assert [check.verdict for check in found.checks] == [
        CheckStatus.UNKNOWN, CheckStatus.OVER, CheckStatus.OVER, CheckStatus.UNKNOWN,
    ]  # fmt: skip
    assert "more than a half-width away" in found.sentences[1]
    weak = assess(crowned(60e3, pressure_limit=1000.0))
    assert weak.checks[0].verdict is CheckStatus.OVER


@pytest.mark.slow
def test_a_contact_with_nothing_away_from_its_ends_is_never_known():
    # 1 mm long and wider than that.
    roller = nh.Roller(
        diameter=200, length=1, material=nh.Material(MODULUS, POISSON, **KNOWN | {"yield_strength": 1.0})
    )
    with pytest.warns(nh.AccuracyWarning):
        solution = nh.solve(nh.Contact(roller, nh.Plate()), load=20e3)
    assert {check.verdict for check in assess(solution).checks} == {CheckStatus.UNKNOWN}


@pytest.mark.slow
def test_a_corner_within_the_contact_leaves_no_confident_number():
    profile = nh.profile.tapered_ends(straight=10, angle=2e-3) + nh.profile.crown(radius=20000)
    solution = crowned(10e3, profile=profile, **KNOWN | {"yield_strength": 1.0, "pressure_limit": 1.0})
    assert solution.peaks_at_corner
    found = assess(solution)
    assert {check.verdict for check in found.checks} == {CheckStatus.UNKNOWN}
    assert "the corner of the profile at y = " in found.sentences[0]


# The rest


@pytest.mark.slow
def test_both_bodies_and_both_methods():
    strips = crowned(**KNOWN)
    patch = crowned(solve=lambda *case, **options: nh.patch.solve(*case, cells=(24, 64), **options), **KNOWN)
    # Grid: 24 cells across resolve the pressure to a per cent.
    assert assess(patch).yield_ratio == pytest.approx(assess(strips).yield_ratio, rel=0.02)
    other = assess(strips, body="b")
    assert other.body == "b"
    assert other.checks[0].verdict is CheckStatus.UNKNOWN  # the plate's material knows nothing


@pytest.mark.slow
def test_stresses_at_hand_are_not_searched_again_and_those_of_the_other_body_refused(plain, largest):
    assert assess(plain, largest=largest).largest is largest
    with pytest.raises(nh.InputError, match="be the largest stresses of body b"):
        assess(plain, body="b", largest=largest)


def test_what_the_core_bears_at_most_without_a_search_is_not_exceeded():
    """A crowned roller in a hollow ring, whose stress at the depth of the case is above that below its line load."""
    steel = nh.Material(206000.0, 0.3, yield_strength=1500.0, core_yield_strength=800.0)
    roller = nh.Roller(
        diameter=15.0, length=20.0, corner_radius=0.5, profile=nh.profile.crown(800.0), material=steel, case_depth=0.8
    )
    contact = nh.Contact(roller, nh.Ring(diameter=-80.0, material=steel, case_depth=0.8))
    solution = nh.solve(contact, load=8e3, tilt=1e-4)
    (core,) = [check for check in judge(solution, body="b", search=False) if "core" in check.sentence]
    bound = float(re.search(r"at most (\S+) MPa", core.sentence)[1])
    assert bound >= assess(solution, body="b").core.von_mises.max
