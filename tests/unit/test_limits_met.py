"""The verdict: judged by what is known of each material; on loads of a life, rows of a study, cases of a command."""

import math

import pytest

import nonhertz as nh
from nonhertz.life import ContactLoadCase
from nonhertz.verdict import Level, judge_contact, judge_loads, judge_rows, worst_verdict

CROWN = nh.profile.crown(radius=1000)


def pressed(load, limit=4000.0, **known):
    steel = nh.Material(207e3, 0.3, pressure_limit=limit, **known)
    roller = nh.Roller(diameter=20, length=20, profile=CROWN, material=steel)
    return nh.solve(nh.Contact(roller, nh.Plate(material=steel)), load=load)


def test_the_worst_load_decides_and_is_named():
    low, high = pressed(20e3, 2500.0), pressed(40e3, 2500.0)
    found = judge_loads([(low, 0.9), (high, 0.1)])
    assert (found.level, found.where) == (Level.NOT_MET, "under 40 kN without tilt")
    assert found.words == "Limits not met under 40 kN without tilt."
    assert found.as_object()["where"] == found.where
    assert judge_loads([(low, 1.0)]) == judge_contact(low)


def test_of_limits_that_are_met_the_nearest_is_named():
    found = worst_verdict({"in a": judge_contact(pressed(5e3)), "in b": judge_contact(pressed(20e3)), "in c": None})
    assert found.words == "Static pressure below its limit; worst in b."
    assert worst_verdict({"in c": None}) is None


def test_rows_are_counted_above_the_limit():
    loads, pressures = {1: 30e3, 3: 40e3}, [2000.0, 2600.0, math.nan, 2700.0]
    judged = {row: judge_contact(pressed(load, 2500.0)) for row, load in loads.items()}
    found = judge_rows(pressures, judged.get, warned=[0.0, 0.0, math.nan, 2.0])
    assert (found.level, found.words) == (Level.NOT_MET, "Limits not met in row 3.")
    assert found.findings[0] == judged[3].findings[0]
    assert [str(each) for each in found.findings[-2:]] == [
        "2 of 3 rows exceed 2500 MPa.",
        "1 of 3 rows have warnings: solve one of them to read which.",
    ]
    assert judge_rows([math.nan], judged.get) is None


def test_of_rows_with_several_materials_the_worst_of_each_is_judged():
    judged = [judge_contact(pressed(20e3, limit)) for limit in (4000.0, 1000.0)]
    assert judge_rows([2300.0, 2300.0], judged.__getitem__, ["100Cr6", "soft"]).words == "Limits not met in row 1."
    assert judge_rows(range(1, 14), judged.__getitem__, range(13)).level is Level.NOT_JUDGED


def test_a_sweep_has_that_of_its_rows_and_none_without_pressures():
    case = nh.Case(pressed(5e3, 3000.0).contact, {"load": 20e3}, {})
    over = {"load.load": [20e3, 90e3]}
    found = nh.sweep(case, over=over)
    assert found.verdict.level is Level.NOT_MET
    assert "1 of 2 rows exceeds 3000 MPa." in map(str, found.verdict.findings)
    assert nh.sweep(case, over=over, quantities=("approach",)).verdict is None


def test_a_design_has_that_of_its_best_case():
    case = nh.Case(pressed(5e3, 1500.0).contact, {"load": 5e3}, {})
    loads = [ContactLoadCase(load=5e3, share=0.5), ContactLoadCase(load=20e3, share=0.5)]
    found = nh.optimize(case, bounds={"body.a.profile.radius": (800.0, 1200.0)}, loads=loads, n_starts=1, workers=1)
    assert found.verdict.words == "Limits not met under 20 kN without tilt."
    assert dict(found.verdict.findings[0].numbers)["pressure"].values[0] == pytest.approx(found.value, rel=1e-9)
