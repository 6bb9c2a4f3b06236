"""``nonhertz design``: what people type."""

import json
import re

import pytest
from crowned_roller import CASE

import nonhertz as nh
from nonhertz.cli import main

PLAN = """
case = "roller.toml"
[vary]
"body.a.profile.radius" = "1500 mm : 30 m"
[design]
starts = 2
loads = [{ load = "20 kN" }, { load = "20 kN", tilt = "2 arcmin" }]
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "roller.toml").write_text(CASE, encoding="utf-8")
    (tmp_path / "plan.toml").write_text(PLAN, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
def test_a_plan_is_designed(folder, run):
    assert run("check", "plan.toml").out == "plan.toml is fine: 'plan', a design over body.a.profile.radius.\n"
    out = run("design", "plan.toml", "--workers", "1").out
    title, verdict, best, *_ = out.splitlines()
    assert title == "A roller on a plate"
    assert verdict.startswith("No limit of the pressure under 20 kN at ")
    assert best.startswith("largest pressure")
    assert "searches that agree" in out
    names = {path.name for path in (folder / "plan-design").iterdir()}
    assert names == {"case.toml", "profile.csv", "design.json", "design.svg", "design.png"}
    found = json.loads((folder / "plan-design" / "design.json").read_text(encoding="utf-8"))
    assert found["value"] < found["before"]
    # The case that is written is the one that was found.
    case = nh.read_case(folder / "plan-design" / "case.toml")
    assert case.title == "A roller on a plate, designed"
    with pytest.warns(nh.AccuracyWarning):
        tilted = nh.solve(case.contact, load=20e3, tilt=found["loads"][1]["tilt"], strips=41)
    assert tilted.max_pressure == pytest.approx(found["value"], rel=0.02)
    lines = (folder / "plan-design" / "profile.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "y [mm],relief [mm],relief before [mm]"
    assert len(lines) == 402


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (('"1500 mm : 30 m"', '"30 m : 1500 mm"'), "must ascend"),
        (("body.a.profile.radius", "body.a.profile.radios"), "the nearest is 'body.a.profile.radius'"),
        (("starts = 2", "starts = 0"), "starts = 0 must be"),
        (("starts = 2", 'goal = "price"'), "goal = 'price' must be one of"),
        (("starts = 2", 'model = "lundberg"'), "design.model = 'lundberg' must be one of 'lundberg-palmgren', "),
        (("starts = 2", 'where = { approach = "30 um" }'), "begin with 'at most'"),
        (('{ load = "20 kN" }', '{ load = "20 kN", share = 0.2 }'), "share"),
        (("[vary]", "[varied]"), "varied"),
    ],
)
def test_a_mistake_ends_in_a_sentence_and_leaves_nothing(folder, run, change, sentence):
    (folder / "plan.toml").write_text(PLAN.replace(*change), encoding="utf-8")
    before = sorted(folder.iterdir())
    captured = run("design", "plan.toml", code=2)
    assert captured.out == ""
    assert sentence in captured.err
    assert sorted(folder.iterdir()) == before


@pytest.mark.parametrize(("options", "held"), [((), "case"), (("--bearing",), "bearing")])
def test_a_case_is_no_plan(folder, capsys, run, options, held):
    run("new", *options, "alone.toml")
    assert main(["design", "alone.toml"]) == 2
    remedy = f"begin with one from 'nonhertz new --plan', and name the {held} file in it"
    assert capsys.readouterr().err == f"alone.toml must be a plan, and holds a {held}: {remedy}.\n"


def test_a_bearing_is_no_case_of_a_design(folder, run):
    assert main(["new", "--bearing", "bearing.toml"]) == 0
    (folder / "plan.toml").write_text(
        'case = "bearing.toml"\n[vary]\n"load.radial" = "1 kN : 2 kN"\n', encoding="utf-8"
    )
    assert "a bearing is swept over" in run("design", "plan.toml", code=2).err


@pytest.mark.slow
def test_a_front_of_aligned_and_misaligned_loads(folder, run):
    out = run("design", "plan.toml", "--workers", "1", "--starts", "1", "--front", "3").out
    assert out.startswith("Limits met. The largest pressure of all points, ")
    head = re.split(r"\s{2,}", out.splitlines()[1])
    radius = "body.a.profile.radius [mm]"
    assert head == ["point", "largest pressure without tilt [MPa]", "largest pressure with tilt [MPa]", radius]
    assert (folder / "plan-design" / "front.csv").read_text().startswith(",".join(head))
    files = {path.name for path in (folder / "plan-design").iterdir()}
    points = json.loads((folder / "plan-design" / "front.json").read_text(encoding="utf-8"))["points"]
    assert files == {"front.csv", "front.json", "front.svg", "front.png"} | {
        f"case-{k}.toml" for k in range(1, len(points) + 1)
    }
    case = nh.read_case(folder / "plan-design" / "case-1.toml")
    again = nh.solve(case.contact, load=20e3, strips=case.solver["strips"])
    assert again.max_pressure == pytest.approx(points[0]["max_pressure_without_tilt"], rel=1e-6)
    assert len((folder / "plan-design" / "front.csv").read_text(encoding="utf-8").splitlines()) == 1 + len(points)


@pytest.mark.parametrize(
    ("change", "arguments", "sentence"),
    [
        ((', tilt = "2 arcmin"', ""), ("3",), "must hold loads without tilt and loads with tilt for a front"),
        (("starts = 2", 'goal = "life"'), ("3",), "goal = 'life' must be 'pressure' for a front"),
        (("starts = 2", "starts = 1"), ("2",), "--front = 2 must be a whole number from 3 to 50"),
    ],
)
def test_what_has_no_front_is_told(folder, run, change, arguments, sentence):
    (folder / "plan.toml").write_text(PLAN.replace(*change), encoding="utf-8")
    assert sentence in run("design", "plan.toml", "--front", *arguments, code=2).err
    assert not (folder / "plan-design").exists()
