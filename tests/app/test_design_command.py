"""``nonhertz design``: what people type."""

import json
import re

import jsonschema
import pytest
from crowned_roller import CASE

import nonhertz as nh
from nonhertz.files.schemas import schema_of

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
    assert verdict.startswith("Pressure unbounded under 20 kN at ")
    assert best.startswith("maximum pressure")
    assert "searches that agree" in out
    names = {path.name for path in (folder / "plan-design").iterdir()}
    assert names == {"case.toml", "profile.csv", "design.json", "design.svg", "design.png", "design.csv"}
    found = json.loads((folder / "plan-design" / "design.json").read_text(encoding="utf-8"))
    jsonschema.validate(found, schema_of("design"))
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


@pytest.mark.slow
def test_a_front_of_aligned_and_misaligned_loads(folder, run):
    out = run("design", "plan.toml", "--workers", "1", "--starts", "1", "--front", "3").out
    assert out.startswith("Pressure unbounded in point ")
    head = re.split(r"\s{2,}", out.splitlines()[1])
    radius = "body.a.profile.radius [mm]"
    assert head == ["point", "maximum pressure without tilt [MPa]", "maximum pressure with tilt [MPa]", radius]
    assert (folder / "plan-design" / "front.csv").read_text().startswith(",".join(head))
    files = {path.name for path in (folder / "plan-design").iterdir()}
    front = json.loads((folder / "plan-design" / "front.json").read_text(encoding="utf-8"))
    jsonschema.validate(front, schema_of("front"))
    points = front["points"]
    assert files == {"front.csv", "front.json", "front.svg", "front.png"} | {
        f"case-{k}.toml" for k in range(1, len(points) + 1)
    }
    case = nh.read_case(folder / "plan-design" / "case-1.toml")
    again = nh.solve(case.contact, load=20e3, strips=case.solver.strips)
    assert again.max_pressure == pytest.approx(points[0]["max_pressure_without_tilt"], rel=1e-6)
    assert len((folder / "plan-design" / "front.csv").read_text(encoding="utf-8").splitlines()) == 1 + len(points)
