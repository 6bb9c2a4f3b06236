"""The verdict on several contacts at once: loads of a life, rows of a study, cases of one command, a design."""

import math

import pytest

import nonhertz as nh
from nonhertz.life import LoadCase
from nonhertz.verdict import Level, of_contact, of_loads, of_rows, worst_of

CROWN = nh.profile.crown(radius=1000)


def pressed(load, limit=None, **given):
    steel = nh.Material(207e3, 0.3, pressure_limit=limit)
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=CROWN, material=steel), nh.Plate(), **given)
    return nh.solve(contact, load=load)


def test_the_worst_load_decides_and_is_named():
    low, high = pressed(20e3, 2500.0), pressed(40e3, 2500.0)
    found = of_loads([(low, 0.9), (high, 0.1)])
    assert (found.level, found.where) == (Level.NOT_MET, "under 40 kN without tilt")
    assert found.words == "Limits not met under 40 kN without tilt."
    assert found.as_object()["where"] == found.where
    assert of_loads([(low, 1.0)]) == of_contact(low)


def test_of_limits_that_are_met_the_nearest_is_named():
    found = worst_of({"in a": of_contact(pressed(5e3)), "in b": of_contact(pressed(20e3)), "in c": None})
    assert found.words == "Limits met; worst in b."
    assert worst_of({"in c": None}) is None


def test_rows_are_counted_above_the_limit():
    contact = pressed(5e3, 2500.0).contact
    found = of_rows([2000.0, 2600.0, math.nan, 2700.0], contact, [0.0, 0.0, math.nan, 2.0])
    assert found.level is Level.NOT_MET
    assert found.sentence == (
        "The largest pressure of all rows, 2700 MPa, exceeds 2500 MPa, the limit of body a; 2 of 3 rows exceed it."
    )
    assert str(found.findings[1]).startswith("1 of 3 rows have warnings")
    assert of_rows([2000.0], None).sentence.endswith("is below 4000 MPa, that of bearing steel at rest (ISO 76).")
    assert of_rows([math.nan], None) is None


def test_a_sweep_has_that_of_its_rows_and_none_without_pressures():
    case = nh.Case(pressed(5e3).contact, {"load": 20e3}, {})
    over = {"load.load": [20e3, 200e3]}
    found = nh.sweep(case, over=over)
    assert found.verdict.level is Level.NOT_MET
    assert "1 of 2 rows exceeds it" in found.verdict.sentence
    assert nh.sweep(case, over=over, quantities=("approach",)).verdict is None


def test_a_design_has_that_of_its_best_case():
    case = nh.Case(pressed(5e3, 1500.0).contact, {"load": 5e3}, {})
    loads = [LoadCase(load=5e3, share=0.5), LoadCase(load=20e3, share=0.5)]
    found = nh.design.best(case, vary={"body.a.profile.radius": (800.0, 1200.0)}, loads=loads, starts=1, workers=1)
    assert found.verdict.words == "Limits not met under 20 kN without tilt."
    assert dict(found.verdict.findings[0].numbers)["pressure"].values[0] == pytest.approx(found.value, rel=1e-9)
