"""A life that is asked for counts in the verdict of a contact and of a bearing."""

import json
import math

import pytest

import nonhertz as nh
from nonhertz.verdict import Level, judge_bearing

CASE = """
title = "asked"
[body.a]
kind = "roller"
diameter = 9.0
length = 10.0
corner_radius = 0.3
profile = [{ kind = "crown", radius = 2000.0 }]
material = "100Cr6"
[body.b]
kind = "ring"
diameter = 37.5
material = "100Cr6"
[load]
load = "3 kN"
[life]
rollers = 13
models = ["iso-16281"]
"""


@pytest.fixture(scope="module")
def loaded():
    steel = nh.MATERIALS["100Cr6"]
    roller = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(radius=1200), material=steel)
    inner, outer = (nh.Ring(diameter=each, material=steel) for each in (37.5, -55.5))
    row = nh.bearing.CylindricalRollerBearing(roller=roller, inner=inner, outer=outer, rollers=13)
    return nh.bearing.solve(row, radial=5e3, method="slices")


def test_a_bearing_that_does_not_last_is_a_limit_not_met(loaded):
    life = nh.bearing.assess(loaded)
    for share, level in ((0.9, Level.MET), (1.1, Level.NOT_MET)):
        found = judge_bearing(loaded, nh.bearing.assess(loaded, required=share * life.rated_life), None)
        assert found.level is level
        words = "reaches" if level is Level.MET else "is below"
        assert any(f"million revolutions {words} the" in str(each) for each in found.findings)
    assert found.findings[0].kind == "life"


def test_hours_are_revolutions_at_the_speed(loaded):
    assert nh.bearing.assess(loaded, required="1000 h", speed=3000).required == pytest.approx(180.0)
    # Half of the revolutions at 1000, half at 3000 1/min: an hour has 60 / (1/2000 + 1/6000) = 90,000 of them.
    both = nh.bearing.assess([(loaded, 0.5), (loaded, 0.5)], required="1000 h", speed=[1000, 3000])
    assert both.required == pytest.approx(90.0)
    with pytest.raises(nh.InputError, match="required = '1000 h' must be in millions of revolutions where there is no"):
        nh.bearing.assess(loaded, required="1000 h")


def test_every_life_is_in_hours_too_where_the_speed_is_known(loaded):
    life = nh.bearing.assess(loaded, speed=1500)
    # 1500 1/min are 0.09 million revolutions an hour.
    assert life.rated_hours == pytest.approx(life.rated_life / 0.09)
    assert life.hours_per_million * life.basic_life == pytest.approx(life.basic_life / 0.09)
    both = nh.bearing.assess([(loaded, 0.5), (loaded, 0.5)], speed=[1000, 3000])
    # As above, 0.09 million revolutions an hour; the parts have speeds of their own.
    assert both.rated_hours == pytest.approx(life.rated_hours)
    assert [part.speed for part, _ in both.parts] == [1000, 3000]
    assert math.isnan(nh.bearing.assess(loaded).rated_hours)


@pytest.mark.parametrize("wrong", ["20000", "0 h", "-3 h", "a while", 0.0, -1.0, math.nan, True])
def test_other_lives_are_refused(loaded, wrong):
    with pytest.raises(nh.InputError, match=r"^required = "):
        nh.bearing.assess(loaded, required=wrong)


def test_a_contact_counts_its_life(tmp_path, monkeypatch, capsys):
    from nonhertz.cli import main

    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")

    def level(required):
        assert main(["life", "case.toml", "--json", *(["--set", f"life.required={required}"] if required else [])]) == 0
        return json.loads(capsys.readouterr().out)

    free = level("")
    assert free["verdict"]["level"] == "met"
    life = free["models"][0]["million_revolutions"]
    assert level(0.9 * life)["verdict"]["level"] == "met"
    short = level(1.1 * life)["verdict"]
    assert (short["level"], short["findings"][0]["kind"]) == ("not-met", "life")
    assert main(["life", "case.toml", "--set", "life.required=1000h"]) == 2
    assert "must be in millions of revolutions where there is no speed" in capsys.readouterr().err
