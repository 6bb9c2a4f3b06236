"""The verdict judges by what is known of each material, and no command says the opposite of another."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import nonhertz as nh
from nonhertz.files.casefile import read_case
from nonhertz.model.materials import LIBRARY
from nonhertz.strength import CheckStatus, assess, judge, onset_of_yield
from nonhertz.subsurface import extremes
from nonhertz.verdict import Level, judge_bearing, judge_contact

CONTACTS = ("cam", "cylindrical", "gear-flank", "needle", "spherical", "tapered", "wheel-on-rail")


def crowned(load=20e3, radius=1000.0, **both):
    material = nh.Material(207e3, both.pop("poisson", 0.3), **both)
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=radius), material=material)
    return nh.solve(nh.Contact(roller, nh.Plate(material=material)), load=load)


def of_material(solution, material):
    """Return a solution as if both bodies were of a material, whose strength decides nothing of the solution."""
    contact = solution.contact
    known = {name: getattr(material, name) for name in ("yield_strength", "core_yield_strength", "pressure_limit")}
    bodies = {name: getattr(contact, name) for name in ("a", "b")}
    bodies = {name: replace(body, material=replace(body.material, **known)) for name, body in bodies.items()}
    return replace(solution, contact=replace(contact, **bodies))


def test_every_row_is_judged_by_its_own_material():
    def row(material):
        rings = {
            "inner": nh.Ring(diameter=37.5, material=material),
            "outer": nh.Ring(diameter=-55.5, material=material),
        }
        roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=1500), material=material)
        return nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)

    hard, soft = row(nh.MATERIALS["100Cr6"]), row(nh.Material(210e3, 0.3, yield_strength=300.0))
    pair = nh.bearing.Paired(bearings=(hard, soft), x=(-10.0, 10.0), turned=(False, False))
    # The moment loads the first row more.
    solution = nh.bearing.solve(pair, radial=8e3, moment=-20e3)
    first, second = (solution.max_pressure[row.rollers].max() for row in pair.rows)
    assert 1.8 * 300.0 < second < first < 4000.0
    verdict = judge_bearing(solution, None, None)
    assert verdict.level is Level.NOT_MET
    assert verdict.sentence.startswith(f"The roller of row 2 yields: the maximum pressure of {second:.1f} MPa")
    unknown = nh.bearing.Paired(bearings=(hard, row(nh.Material(210e3, 0.3))), x=(-10.0, 10.0), turned=(False, False))
    sentences = [str(finding) for finding in judge_bearing(nh.bearing.solve(unknown, radial=8e3), None, None).findings]
    whose = "the roller of row 2, the inner ring of row 2 and the outer ring of row 2"
    assert f"No limit is known of the material of {whose}: give its yield strength or pressure limit." in sentences


@pytest.mark.parametrize("poisson", [0.0, 0.2, 0.3, 0.45])
def test_onset_of_yield_is_that_of_the_stress_on_the_axis(poisson):
    """Against the stresses of Johnson (3.45) for a circle and the potential of a line (4.45), each by an own route."""

    def circle(z):
        ratio = z * (np.pi / 2.0 - np.arctan(z))
        radial = -(1.0 + poisson) * (1.0 - ratio) + 0.5 / (1.0 + z * z)
        return -abs(radial + 1.0 / (1.0 + z * z))

    def line(z):
        across, normal = -((1.0 + 2.0 * z * z) / np.sqrt(1.0 + z * z) - 2.0 * z), -1.0 / np.sqrt(1.0 + z * z)
        three = np.array([across, normal, poisson * (across + normal)])
        return -np.sqrt(1.5 * np.sum((three - three.mean()) ** 2))

    for law, onset in zip((circle, line), onset_of_yield(poisson), strict=True):
        best = min(float(minimize_scalar(law, bounds=(0.0, 2.0), method="bounded").fun), law(0.0))
        assert onset == pytest.approx(-1.0 / best, rel=1e-5)


def test_published_onsets():
    """Johnson 1985: Eq. (4.57) and section 6.1 for a line by von Mises, 1.6 Y for a point (Eq. 6.9)."""
    point, line = onset_of_yield(0.3)
    assert (round(point, 1), round(line, 2)) == (1.6, 1.79)


def test_nothing_is_judged_by_the_limit_of_another_material():
    found = judge_contact(crowned())
    assert (found.level, found.words) == (Level.NOT_JUDGED, "Not judged.")
    assert found.sentence == (
        "No limit is known of steel of no particular grade (body a and body b): name its grade, such as 100Cr6, or "
        "give its yield strength or pressure limit."
    )
    assert found.as_object()["level"] == "not-judged"


def test_both_bodies_are_judged():
    steel = nh.MATERIALS["100Cr6"]
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=1000), material=steel)
    for other, level in (("100Cr6", Level.MET), ("R260", Level.NOT_JUDGED), ("EN-AW-6082-T6", Level.NOT_MET)):
        found = judge_contact(nh.solve(nh.Contact(roller, nh.Plate(material=nh.MATERIALS[other])), load=20e3))
        assert (other, found.level) == (other, level)
        swapped = nh.Contact(nh.Plate(material=nh.MATERIALS[other]), roller)
        assert judge_contact(nh.solve(swapped, load=20e3)).level is level


@pytest.mark.parametrize(
    ("share", "level"),
    [(1.0 / 1.2, Level.MET), (1.2, Level.NOT_MET)],
)
def test_yielding_is_judged_by_the_onset_in_point_and_line_contact(share, level):
    onset = onset_of_yield(0.3)[0 if share < 1.0 else 1]
    pressure = crowned().max_pressure
    found = judge_contact(crowned(yield_strength=pressure / (share * onset)), search=False)
    assert found.level is level
    assert found.words == {Level.MET: "No yielding.", Level.NOT_MET: "Limits not met."}[level]


def test_in_between_only_the_stress_decides():
    pressure = crowned().max_pressure
    between = crowned(yield_strength=pressure / 1.7)
    assert judge_contact(between, search=False).level is Level.NOT_JUDGED
    # The contact is long: nearly a line, which yields at 1.79 times the yield strength.
    assert judge_contact(between).level is Level.MET


def test_the_sentence_says_what_was_judged():
    found = judge_contact(crowned(pressure_limit=4000.0))
    assert found.words == "Static pressure below its limit."
    pressure = crowned().max_pressure
    assert dict(found.findings[0].numbers)["pressure"].values[0] == pytest.approx(pressure)
    assert f"static safety S0 = {(4000.0 / pressure) ** 2:.3g}" in found.sentence


@pytest.mark.slow
@pytest.mark.parametrize("template", CONTACTS)
def test_pressure_and_search_never_say_the_opposite(template):
    """Where the pressure alone decides, the field searched with an independent routine decides the same."""
    solution = _template(template)
    for body in ("a", "b"):
        largest = extremes(solution, body=body)
        for share in (0.5, 1.0, 1.3, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.5, 4.0):
            material = nh.Material(207e3, 0.3, yield_strength=solution.max_pressure / share)
            given = of_material(solution, material)
            hardened = getattr(given.contact, body).case_depth is not None
            quick = {check.name: check for check in judge(given, body=body, search=False)}
            if quick["yield"].verdict is not CheckStatus.UNKNOWN:
                searched = assess(given, body=body, largest=None if hardened else largest)
                assert next(each for each in searched.checks if each.name == "yield").verdict in {
                    quick["yield"].verdict,
                    CheckStatus.UNKNOWN,
                }, (body, share)


def _template(name):
    from importlib import resources

    with resources.as_file(resources.files("nonhertz.files").joinpath("templates", f"{name}.toml")) as path:
        return read_case(path).solve()


@pytest.mark.slow
@pytest.mark.parametrize("name", [each.name for each in LIBRARY])
def test_verdicts_of_the_library_agree_however_they_are_asked(name):
    """What `solve`, `stress` of either body, and a row of a study say of one contact is the same."""
    material = nh.MATERIALS[name]
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=1000), material=material)
    case = nh.Case(nh.Contact(roller, nh.Plate(material=material)), {"load": 5e3}, {})
    solution = case.solve()
    found = judge_contact(solution)
    known = material.pressure_limit is not None or material.yield_strength is not None
    assert (found.level is Level.NOT_JUDGED) is not known
    assert {judge_contact(solution, (assess(solution, body=body),)).level for body in ("a", "b")} == {found.level}
    assert nh.sweep(case, over={"load.load": [4e3, 5e3]}).verdict.level is found.level


def test_a_bearing_is_judged_by_its_own_materials():
    def bearing(rollers, rings):
        roller = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(radius=1200),
                           material=nh.MATERIALS[rollers])  # fmt: skip
        inner, outer = (nh.Ring(diameter=each, material=nh.MATERIALS[rings]) for each in (37.5, -55.5))
        row = nh.bearing.CylindricalRollerBearing(roller=roller, inner=inner, outer=outer, rollers=13)
        return nh.bearing.solve(row, radial=5e3)

    assert judge_bearing(bearing("100Cr6", "100Cr6"), None, None).level is Level.MET
    hybrid = judge_bearing(bearing("silicon-nitride", "100Cr6"), None, None)
    assert hybrid.level is Level.NOT_JUDGED
    assert hybrid.sentence.startswith("No limit is known of silicon-nitride (the roller): ")
    assert any("the limit of 100Cr6" in str(each) for each in hybrid.findings)
    assert judge_bearing(bearing("100Cr6", "EN-AW-6082-T6"), None, None).level is Level.NOT_MET
    assert judge_bearing(bearing("steel", "steel"), None, None).level is Level.NOT_JUDGED
