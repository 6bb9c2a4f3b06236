"""Classes in place of numbers: what they leave open of a bearing, by hand, in files, results and on the page."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest
from few_rollers import changed

import nonhertz as nh
from nonhertz.files.bearing_results import as_object
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.toml import parse
from nonhertz.show.bearing import sections
from nonhertz.web.view.bearings import bearing_answer

NU206 = """
title = "NU 206"
[bearing]
kind = "cylindrical"
rollers = 13
bore = 30
outside_diameter = 62
clearance = "C3"
[roller]
diameter = 9.0
length = 10.0
profile = { kind = "crown", radius = 1200 }
[inner]
diameter = 37.5
[outer]
diameter = -55.5
[load]
radial = "10 kN"
speed = 3000
[fit]
shaft = "k5"
housing = "H7"
[solver]
method = "slices"
[lubrication]
viscosity = 20
cleanliness = "-/17/14"
"""
SPREAD = math.hypot(12.5, 0.8 * math.hypot(4.5, 5.0))  # um: C3; k5 and the bore, of which the raceway loses d / F = 0.8


def read(text, *changes):
    return BearingCase.of(parse(changed(text, *changes), "nu206.toml"), Path("nu206.toml"))


def in_um(found):
    return [1e3 * each for each in (found.least, found.likely, found.greatest)]


@pytest.fixture(scope="module")
def solved():
    case = read(NU206)
    solution = case.solve()
    return case, solution, case.assess(solution)


def test_k5_h7_and_c3_of_nu_206_by_hand(solved):
    case, solution, life = solved
    found = case.tolerances(solution, life).clearance
    # SKF, Rolling bearings (2018), B.6: k5 +2 to +11, bore -10 to 0; H7 0 to +30, outside diameter -13 to 0.
    assert in_um(found.shaft) == pytest.approx([2.0, 11.5, 21.0])
    assert in_um(found.housing) == pytest.approx([-43.0, -21.5, 0.0])
    assert in_um(found.unmounted) == pytest.approx([35.0, 47.5, 60.0])
    # A solid shaft of the same steel widens the raceway by d / F = 0.8 of the interference; speed takes 9 nm more.
    assert in_um(found.mounted) == pytest.approx([35.0 - 0.8 * 21.0, 47.5 - 0.8 * 11.5, 60.0 - 0.8 * 2.0])
    assert in_um(found.operating) == pytest.approx(in_um(found.mounted), abs=0.02)
    assert [1e3 * each for each in found.mounted.probable] == pytest.approx([38.3 - SPREAD, 38.3 + SPREAD])
    assert 1e3 * case.mounted.clearance == pytest.approx(38.3, abs=0.02)


def test_results_are_those_of_the_clearances(solved):
    case, solution, life = solved
    found = case.tolerances(solution, life)
    for which in nh.bearing.Range.AT:
        clearance = found.clearance.operating.at(which)
        alone = dataclasses.replace(case, fit=None, bearing=dataclasses.replace(case.bearing, clearance=clearance))
        by_hand = alone.assess(alone.solve())
        assert found.results["reference_life"].at(which) == pytest.approx(by_hand.reference_life, rel=1e-6)
        assert found.results["modified_life"].at(which) == pytest.approx(by_hand.modified_life, rel=1e-6)
    assert math.isnan(found.results["max_pressure"].likely)  # by slices


def test_numbers_take_the_place_of_classes(solved):
    case = solved[0]
    greatest = case.at("greatest")
    assert greatest.bearing.clearance == pytest.approx(0.060)
    assert greatest.fit.shaft.interference == pytest.approx(0.002)
    assert greatest.fit.housing.interference == pytest.approx(-0.043)
    assert greatest.tolerances(*solved[1:]) is None
    measured = read(NU206, ('shaft = "k5"', 'shaft = { fit = "k5", interference = "15 um", smoothing = "2 um" }'))
    found = measured.tolerances(*solved[1:]).clearance
    assert in_um(found.shaft) == pytest.approx([15.0] * 3)
    assert in_um(found.mounted)[1] == pytest.approx(47.5 - 0.8 * 13.0)


def test_files_and_python_have_the_same_words(solved, tmp_path):
    case = solved[0]
    fit = nh.bearing.Mounting(shaft="k5", housing=nh.bearing.Housing(fit="H7"))
    assert case.fit == fit
    case.write(tmp_path / "nu206.toml")
    assert read_bearing(tmp_path / "nu206.toml") == case
    pair = nh.bearing.paired(case.bearing, "tandem", 20.0)
    assert pair.at("least").bearings[1].clearance == 0.035
    assert dataclasses.replace(case, bearing=pair).at("least").bearing == pair.at("least")


def test_a_class_of_the_bearing_and_seats_of_their_own():
    case = read(NU206, ("bore = 30", 'bore = 30\ntolerance_class = "5"'), ('"H7"', '{ fit = "J7", diameter = 61.9 }'))
    found = case.fit.ranges(case.bearing)
    assert in_um(found.shaft) == pytest.approx([2.0, 9.5, 17.0])  # 0 to -6 um
    assert in_um(found.housing) == pytest.approx([-27.0, -7.5, 12.0])  # J7: -12 to +18; 0 to -9 um
    # Where both fits press, all three count.
    assert found.mounted.spread > math.hypot(0.0125, 0.8 * found.shaft.spread)


def test_clearance_alone_may_be_a_group():
    case = read(NU206, ('[fit]\nshaft = "k5"\nhousing = "H7"\n', ""))
    solution = case.solve()
    found = case.tolerances(solution, None)
    assert case.mounted.radial_clearance == 0.0475
    assert found.clearance.shaft is None
    assert found.clearance.operating == found.clearance.unmounted
    table = sections(case, solution, None, "")[1].blocks[0]
    assert table.rows[0][0] == "radial clearance unmounted [µm]"


def test_results_are_written_shown_and_read_back_without_solving(solved, tmp_path, monkeypatch):
    case, solution, life = solved
    written = as_object(solution, case, life, "")
    tolerances = written["tolerances"]
    assert tolerances["mounted"]["likely"] == pytest.approx(0.0383)
    assert tolerances["shaft"]["probable"] == pytest.approx([0.0115 - math.hypot(0.0045, 0.005), 0.01822681])
    assert written["units"]["tolerances"]["operating"] == "mm"
    assert bearing_answer(case, solution)["tolerances"]["columns"][1] == "least clearance"
    path = tmp_path / "result.json"
    path.write_text(json.dumps(written))
    monkeypatch.setattr(BearingCase, "solve", None)
    back = nh.read_result(path)
    restored, expected = (one.tolerances(of, life) for one, of in ((back.case, back.solution), (case, solution)))
    np.testing.assert_equal(dataclasses.asdict(restored), dataclasses.asdict(expected))  # a pressure by slices is NaN


def test_where_a_limit_has_no_solution_there_are_no_numbers(solved, monkeypatch):
    case, solution, life = solved
    fresh = dataclasses.replace(case)

    def refuse(self, method=None):
        raise nh.ConvergenceError("No equilibrium.", None)

    monkeypatch.setattr(BearingCase, "solve", refuse)
    found = fresh.tolerances(solution, life).results["reference_life"]
    assert math.isnan(found.least)
    assert found.likely == life.reference_life


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('"k5"', '"k15"', "fit.shaft = 'k15' must be a known tolerance class of a shaft: did you mean"),
        ('"k5"', '"H7"', "fit.shaft = 'H7' must be a known tolerance class of a shaft: did you mean 'h7'?"),
        ('"k5"', '{ fit = "x5" }', "fit.shaft.fit = 'x5' must be a known tolerance class: give"),
        (
            '"k5"',
            '{ fit = "k5", diameter = 560 }',
            "fit.shaft.diameter = 560.0 must lie above 0 and up to 500 mm, for which IT5",
        ),
        ("outside_diameter = 62\n", "", "fit.housing.diameter must be given where the bearing has no outside_diameter"),
        ("bore = 30\n", "", "bearing.bore must be given with the clearance group C3: give the nominal bore in mm"),
        ("bore = 30\n", "bore = 40\n", "bearing.bore = 40.0 must be less than the raceway's 37.5 mm"),
        ("= 62\n", "= 50\n", "bearing.outside_diameter = 50.0 must exceed the raceway's 55.5 mm"),
        ('"C3"', '"C9"', "bearing.clearance = 'C9' must be one of 'C2', 'CN', 'C3', 'C4', 'C5' or a number in mm"),
        (
            "bore = 30",
            'bore = 30\ntolerance_class = "6X"',
            "bearing.tolerance_class = '6X' must be one of 'Normal', '6', '5'",
        ),
    ],
)
def test_a_class_that_is_none_is_one_sentence(old, new, sentence):
    with pytest.raises(nh.CaseError) as caught:
        read(NU206, (old, new))
    assert len(caught.value.mistakes) == 1
    assert sentence in caught.value.mistakes[0]


def test_ceramic_rollers_grow_as_such_and_have_no_life_by_the_standard_of_steel():
    warm = ('housing = "H7"', 'housing = "H7"\ninner_temperature = 70\nouter_temperature = 60')
    case = read(NU206, warm, ("length = 10.0", 'length = 10.0\nmaterial = "silicon-nitride"'))
    # Raceways of 37.5 and 55.5 mm of steel, 12.5e-6 a kelvin, and rollers of 9 mm at the mean of 65 degrees, 3.2e-6.
    by_hand = 12.5e-6 * (37.5 * 50.0 - 55.5 * 40.0) + 3.2e-6 * 18.0 * 45.0
    assert case.operating_clearance.lost_to_temperatures == pytest.approx(by_hand, rel=1e-3)
    assert case.bearing.roller_density == 3.2e-9
    _, reason = case.rated(case.solve())
    assert reason.endswith("hybrid bearings are rated by ISO 20056-1 and -2, not by ISO 281")


def test_groups_are_not_those_of_tapered_bearings():
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-6, 6), (11, 10)), length=12)
    rings = {"inner": nh.Ring(diameter=41), "outer": nh.Ring(diameter=-62.5)}
    make = {"roller": cone, **rings, "rollers": 14, "contact_angle": 0.2}
    with pytest.raises(nh.InputError, match=r"clearance = 'C3' must be axial for a tapered bearing: give it in mm, or"):
        nh.bearing.TaperedRollerBearing(**make, bore=30, clearance="C3")
    row = nh.bearing.TaperedRollerBearing(**make, bore=30, outside_diameter=72, clearance=0.1)
    found = nh.bearing.Mounting(shaft="k5", housing="H7").ranges(row)
    assert in_um(found.shaft) == pytest.approx([2.0, 12.5, 23.0])  # bore 0 to -12 um
    assert in_um(found.unmounted) == pytest.approx([200.0 * math.tan(0.2)] * 3)
    assert found.mounted.spread > 0.0
