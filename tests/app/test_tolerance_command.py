"""``nonhertz tolerance``: what people type."""

import json

import jsonschema
import pytest
from crowned_roller import CASE

from nonhertz.cli import main
from nonhertz.files.schemas import schema_of

PLAN = """
case = "roller.toml"
quantities = ["max_pressure"]
[tolerance]
"load.load" = "normal(nominal, 1 kN)"
"body.a.profile.radius" = "uniform(3.9 m, 4.1 m)"
[samples]
count = 80
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "roller.toml").write_text(CASE, encoding="utf-8")
    (tmp_path / "plan.toml").write_text(PLAN, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
def test_a_plan_is_studied(folder, capsys, run):
    assert main(["check", "plan.toml"]) == 0
    paths = "load.load, body.a.profile.radius"
    assert capsys.readouterr().out == f"plan.toml is fine: 'plan', a tolerance study over {paths}.\n"
    out = run("tolerance", "plan.toml").out
    title, verdict, rows, *_ = out.splitlines()
    assert (title, verdict[:26], rows) == ("plan", "Pressure unbounded in row ", "80 rows; 40 independent samples")
    assert "normal(nominal, 1 kN)" in out
    assert "load.load" in out
    assert "operating load" in out
    names = {path.name for path in (folder / "plan-tolerance").iterdir()}
    drawn = {f"{name}.{kind}" for name in ("distribution", "indices", "profiles") for kind in ("svg", "png", "csv")}
    assert names == drawn | {"rows.sqlite3", "rows.csv", "rows.parquet", "tolerance.json"}
    kept = json.loads((folder / "plan-tolerance" / "tolerance.json").read_text(encoding="utf-8"))
    assert kept["independent_samples"] == 40
    assert next(each["path"] for each in kept["indices"]["max_pressure"]) == "load.load"
    assert "load" not in kept["indices"]
    # Too few samples for the interval of 1 %: there is no infinity in JSON.
    assert kept["quantiles"]["max_pressure"][0]["low"] is None


def test_limits_are_stated_with_their_share_and_cpk(folder, run):
    with (folder / "plan.toml").open("a", encoding="utf-8") as plan:
        plan.write('[limits]\nload = "at most 20 kN"\n')
    found = run("tolerance", "plan.toml", "--workers", "1", "--out", "rows", "--json").json
    jsonschema.validate(found, schema_of("tolerance"))
    (limit,) = found["limits"]
    assert (limit["quantity"], limit["kind"], limit["limit"], limit["samples"]) == ("load", "at most", 20e3, 40)
    assert abs(limit["beyond"] - 20) <= 4  # half of a normal distribution about its limit
    assert abs(limit["cpk"]) < 0.05
    assert found["verdict"]["level"] == "not-met"
    said = run("tolerance", "plan.toml", "--workers", "1", "--out", "rows", "--limits", "load=at least 15 kN").out
    assert "load   at least 15 kN     0 %" in said
    assert "Limits not met" not in said


def test_mistakes_of_limits_are_named(folder, run):
    unknown = "Unknown quantity limits.lod. Did you mean limits.load?"
    for word, what in (("load", "--limits = 'load' must have an equals sign"), ("lod=at most 5 kN", unknown)):
        assert what in run("tolerance", "plan.toml", "--limits", word, code=2).err
    with (folder / "plan.toml").open("a", encoding="utf-8") as plan:
        plan.write('[limits]\nlod = "at most 20 kN"\n')
    assert unknown in run("check", "plan.toml", code=2).out
