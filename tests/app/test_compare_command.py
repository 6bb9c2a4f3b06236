"""``nonhertz compare`` as a user meets it: table, files, exit codes."""

import json
import re
from pathlib import Path

import jsonschema
import pytest

from nonhertz.files.schemas import schema_of

EXAMPLES = Path(__file__).parents[2] / "examples"


CELLS = ["--cells", "24", "48"]
FILES = {"comparison.json", "comparison.csv", "comparison-figure.csv", "comparison.svg", "comparison.png"}


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text((EXAMPLES / "crowned-roller.toml").read_text(encoding="utf-8"), encoding="utf-8")
    return "case.toml"


def test_the_table_has_all_three_methods_and_their_times(case, run):
    printed = run("compare", case, *CELLS)
    assert printed.err == ""
    lines = printed.out.splitlines()
    assert lines[0] == "Roller 20 x 20 on a plate"
    assert lines.pop(1).startswith("Pressure unbounded. ")
    assert lines[1].split() == "plane grid semi-elliptic difference parabolic difference".split()  # noqa: SIM905
    rows = {cells[0]: cells[1:] for cells in (re.split(r"\s{2,}", line.strip()) for line in lines[2:14])}
    assert {"approach [µm]", "tilt [mrad]", "moment [N m]", "pressure at y = 0 mm [MPa]", "time"} <= set(rows)
    assert rows["load [kN]"] == ["20.000", "20.000", "0 %", "20.000", "0 %"]
    assert rows["size"][0] == "24 x 48 cells"
    assert max(map(len, lines[:14])) <= 100
    text = " ".join(printed.out.split())
    assert "sharp ends at y = -10 and 10 mm, where it is unbounded" in text
    assert "- semi-elliptic strips, y = -10 to " in text
    assert "warning: On the plane grid: " in text


def test_json_is_one_object_and_nothing_else(case, run):
    printed = run("compare", case, *CELLS, "--json", "--out", "new/folder")
    assert printed.err == ""
    found = json.loads(printed.out)
    jsonschema.validate(found, schema_of("comparison"))
    assert found["cells"] == [24, 48]
    assert {"quantities", "stretches", "seconds", "stations", "warnings", "units", "patch"} <= set(found)
    assert json.loads(Path("new/folder/comparison.json").read_text(encoding="utf-8")) == found
    assert {path.name for path in Path("new/folder").iterdir()} == FILES


def test_the_strips_of_the_file_are_taken(case, run):
    text = Path(case).read_text(encoding="utf-8").replace('"auto"', "21").replace('"semi-elliptic"', '"parabolic"')
    Path(case).write_text(text, encoding="utf-8")
    found = run("compare", case, *CELLS, "--json").json
    assert (found["semi_elliptic"]["strips"], found["parabolic"]["strips"]) == (21, 21)
