"""What is assumed where a file leaves something out: that it is said, and that it matters."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.files.bearing_results import as_object as bearing_object
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.contact_results import as_object
from nonhertz.report import compose
from nonhertz.web.view.answers import answer
from nonhertz.web.view.bearings import bearing_answer

BEARING = """
[bearing]
kind = "cylindrical"
rollers = 13
[roller]
diameter = 9.0
length = 10.0
corner_radius = 0.3
profile = [{ kind = "crown", radius = 1200.0 }]
[inner]
diameter = 37.5
[outer]
diameter = -55.5
[load]
radial = "10 kN"
[solver]
method = "slices"
"""
FITTED = """
[fit.shaft]
diameter = 30
interference = "12 um"
[fit.housing]
diameter = 62
"""
CONTACT = """
[body.a]
kind = "roller"
diameter = 20.0
length = 20.0
profile = [{ kind = "crown", radius = 4000.0 }]
[body.b]
kind = "plate"
[load]
load = 2e4
"""


def bearing(text=BEARING, **changes):
    return BearingCase.of(
        tomllib.loads(text), Path("bearing.toml"), changes={k.replace("__", "."): v for k, v in changes.items()}
    )


def contact(**changes):
    return Case.of(
        tomllib.loads(CONTACT), Path("case.toml"), changes={k.replace("__", "."): v for k, v in changes.items()}
    )


def keys(case):
    return {key for each in case.assumed for key in dict(each.numbers)["keys"].replace(" and ", ", ").split(", ")}


def headline(case):
    """Return the numbers that people look for first."""
    found = case.solve()
    if isinstance(case, Case):
        return {"approach": found.approach, "pressure": found.max_pressure}
    life = case.assess(found)
    return {
        "load": found.load.max(), "L10": life.basic_life, "L10r": life.reference_life, "life": life.rated_life,
        "S0": life.static_safety, "clearance": case.mounted.clearance,
    }  # fmt: skip


# A usual value in place of each default, and what it moves by more than 5 %.
@pytest.mark.parametrize(
    ("make", "key", "usual", "moved"),
    [
        (bearing, "bearing.clearance", 0.03, "load"),
        (bearing, "life.reliability", 0.95, "life"),
        (bearing, "life.turning", "outer", "L10r"),
        (bearing, "life.dynamic", 44e3, "L10"),
        (bearing, "life.static", 36.5e3, "S0"),
        (lambda **more: bearing(BEARING + FITTED, **more), "fit.inner_temperature", 60.0, "clearance"),
        (lambda **more: bearing(BEARING + FITTED, **more), "fit.outer_temperature", 60.0, "clearance"),
        (lambda **more: bearing(BEARING + FITTED, **more), "fit.housing.interference", 0.01, "clearance"),
        (
            lambda **more: bearing(BEARING + FITTED, **({"fit__housing__interference": 0.02} | more)),
            "fit.housing.outside_diameter",
            70.0,
            "clearance",
        ),
        (contact, "body.b.material", "EN-GJL-250", "pressure"),
        (contact, "body.b.depth", 8.0, "approach"),
        (contact, "body.b.length", 24.0, "approach"),
    ],
)
def test_what_is_said_to_be_assumed_moves_a_headline_number(make, key, usual, moved):
    before, after = make(), make(**{key.replace(".", "__"): usual})
    assert key in keys(before)
    assert key not in keys(after)
    assert abs(headline(after)[moved] / headline(before)[moved] - 1.0) > 0.05


def test_what_a_file_gives_is_not_assumed_even_if_it_is_the_default():
    given = {"roller__material": "steel", "bearing__clearance": 0.0, "life__reliability": 0.9, "life__turning": "inner"}
    assert {each.replace("__", ".") for each in given} <= keys(bearing())
    assert not {each.replace("__", ".") for each in given} & keys(bearing(**given))
    # Bearings that have no rating have no life that rests on anything.
    assert not [each for each in keys(bearing(roller__material="silicon-nitride")) if each.startswith("life")]
    # What is made in Python has no file: there the default is assumed.
    made = BearingCase(bearing().bearing, {"radial": 1e4}, {"method": "slices"})
    assert "bearing.clearance" in keys(made)
    assert "bearing.clearance" not in keys(BearingCase(bearing(bearing__clearance=0.02).bearing))


def test_the_clearance_of_a_pair_is_that_of_both():
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-5.0, 5.0), (9.4, 8.6)), length=10.0)
    rings = {"inner": nh.Ring(diameter=37.3), "outer": nh.Ring(diameter=-55.7)}
    row = nh.bearing.TaperedRollerBearing(roller=cone, **rings, rollers=13, contact_angle=0.2)
    assert "bearing.pair.clearance" in keys(BearingCase(nh.bearing.paired(row, "O", 20.0)))
    preloaded = keys(BearingCase(nh.bearing.paired(row, "O", 20.0, clearance=-0.01)))
    assert not {"bearing.pair.clearance", "bearing.clearance"} & preloaded


def test_every_output_of_a_contact_says_what_is_assumed():
    case = contact()
    solution = case.solve()
    sentence = "Assumed: half-space. Give body.b.depth if that is not so: it decides displacements."
    assert sentence in map(str, case.assumed)
    assert sentence in [each["sentence"] for each in as_object(solution, case)["assumed"]]
    row = ("half-space", "for body.b.depth; decides displacements")
    assert row in [tuple(each[1:]) for each in answer(case, solution, "")["summary"]]
    report = compose([case], stress=False)
    assert all(words in report for words in row)
    assert "half-space" in [dict(each.numbers)["default"] for each in solution.assumed]


def test_every_output_of_a_bearing_says_what_is_assumed():
    case = bearing()
    solution = case.solve()
    life = case.assess(solution)
    assert "assumed: reliability of 90 %" in repr(life)
    written = [each["numbers"]["default"] for each in bearing_object(solution, case, life, "")["assumed"]]
    page = [tuple(each[1:]) for each in bearing_answer(case, solution)["summary"]]
    report = compose([case])
    for default, key in (("no clearance", "bearing.clearance"), ("inner ring turns", "life.turning")):
        assert default in written
        (row,) = [each for each in page if each[0] == default]
        assert row[1].startswith(f"for {key}; decides ")
        assert default in report
        assert row[1] in report
    assert np.isfinite(life.rated_life)


def test_studies_say_what_is_assumed_but_for_what_they_vary():
    from nonhertz.show.studies import sweep_sections

    case = bearing()
    for path, values in (("life.reliability", [0.9, 0.95]), ("load.radial", [8e3, 1e4])):
        found = nh.sweep(case, over={path: values}, workers=1)
        said = {dict(each.numbers)["keys"] for each in found.assumed}
        assert ("life.reliability" in said) is (path != "life.reliability")
        assert "life.turning" in said
        text = str([block for section in sweep_sections(found) for block in section.blocks])
        assert "inner ring turns" in text
        assert "No modified life: give viscosity and cleanliness for the modified life." in text
