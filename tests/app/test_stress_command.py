"""``nonhertz stress`` as a user meets it: numbers, files, refusals, exit codes."""

import json
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
import nonhertz.cli.stress
import nonhertz.show.analysis
import nonhertz.solver.one
from nonhertz.files.casefile import read_case
from nonhertz.files.schemas import schema_of

EXAMPLES = Path(__file__).parents[2] / "examples"
PLANES = ("axial-plane", "cross-section")
FILES = {"stress.json", *(f"{name}.{ending}" for name in PLANES for ending in ("csv", "svg", "png"))}

PLANE_STRAIN = """
title = "Two rollers with coincident ends"
[body.a]
kind = "roller"
diameter = 20
length = 20
side_faces = "mirror"
images = "series"
[body.b]
kind = "roller"
diameter = 20
length = 20
side_faces = "mirror"
images = "series"
material = { modulus = 207000, poisson = 0.25 }
[load]
load = 20000
[solver]
strips = 7
"""


@pytest.fixture
def case(tmp_path, monkeypatch):
    """An elliptical point contact, 0.262 by 1.179 mm, 1546 MPa."""
    monkeypatch.chdir(tmp_path)
    text = (EXAMPLES / "elliptical-point-contact.toml").read_text(encoding="utf-8")
    Path("case.toml").write_text(text, encoding="utf-8")
    return "case.toml"


@pytest.fixture
def sharp(case):
    Path(case).write_text((EXAMPLES / "crowned-roller.toml").read_text(encoding="utf-8"), encoding="utf-8")
    return case


def found(run, *words: str) -> Any:
    printed = run("stress", *words, "--json")
    assert printed.err == ""
    result = json.loads(printed.out)
    jsonschema.validate(result, schema_of("stress"))
    return result


@pytest.mark.slow
def test_without_a_station_the_section_is_the_worst(sharp, run):
    told = found(run, sharp)
    assert told["section"]["y"] == told["overall"]["von_mises"]["y"] > 9.0
    assert_allclose(told["section"]["von_mises"]["max"], told["overall"]["von_mises"]["max"], rtol=1e-6)


@pytest.mark.slow
def test_the_table_has_both_and_the_warnings(sharp, run):
    printed = run("stress", sharp, "--station", "9.9")
    rows = [line.split() for line in printed.out.splitlines()[4:11]]
    overall, section = ({" ".join(row[:2]): row[2:] for row in rows[k : k + 3]} for k in (0, 4))
    assert list(overall) == list(section) == ["von Mises", "maximum shear", "orthogonal shear"]
    largest = nh.subsurface.extremes(read_case(sharp).solve()).orthogonal_shear
    shown = [f"{largest.max:.2f}", f"{largest.y:.3f}", f"{largest.z:.4f}"]
    assert [overall["orthogonal shear"][k] for k in (0, 3, 4)] == shown
    assert section["von Mises"][2:4] == ["0", "9.900"]
    text = " ".join(printed.out.split())
    assert text.count("warning: The contact reaches the sharp end") == 2
    assert "The cross-section at y = 9.9 mm is within a half-width of the sharp end at y = 10 mm" in text


@pytest.mark.slow
def test_files_are_the_json_and_both_planes(case, run):
    told = found(run, case, "--station", "0.5", "--out", "new/folder")
    folder = Path("new/folder")
    assert {path.name for path in folder.iterdir()} == FILES
    assert json.loads((folder / "stress.json").read_text(encoding="utf-8")) == told
    for name, fixed, value in (("axial-plane", "x [mm]", 0.0), ("cross-section", "y [mm]", 0.5)):
        head, _ = (folder / f"{name}.csv").read_text(encoding="utf-8").split("\n", 1)
        table = dict(zip(head.split(","), np.loadtxt(folder / f"{name}.csv", delimiter=",", skiprows=1).T, strict=True))
        assert len(table) == 11
        assert set(table[fixed]) == {value}
        largest = told["overall" if name == "axial-plane" else "section"]["von_mises"]
        at = table["von_mises [MPa]"].argmax()
        assert_allclose(table["von_mises [MPa]"][at], largest["max"], rtol=2e-3)
        assert_allclose(table["z [mm]"][at], largest["z"], atol=0.01)
        surface = table["z [mm]"] == 0.0
        assert_allclose(
            table["sigma_z [MPa]"][surface].min(), -1546.19 if name == "axial-plane" else -1400.4, rtol=1e-2
        )


STRONG = PLANE_STRAIN.replace(
    "[body.b]",
    """case_depth = "2 mm"
material = { modulus = 207000, poisson = 0.3, yield_strength = 400, core_yield_strength = 700, pressure_limit = 4000 }
[body.b]""",
)


@pytest.mark.slow
def test_whether_the_body_bears_it_is_told(case, run):
    Path(case).write_text(STRONG, encoding="utf-8")
    told = found(run, case)
    strength, pressure = told["strength"], told["max_pressure"]
    assert_allclose(strength["static_safety"], (4000.0 / pressure) ** 2, rtol=1e-9)
    assert (strength["criterion"], strength["verdict"]) == ("von-mises", "over")
    # Johnson, Contact Mechanics, section 4.1, at nu = 0.3.
    assert_allclose(strength["checks"]["yield"]["ratio"], 0.5575 * pressure / 400.0, rtol=1e-3)
    printed = run("stress", case).out
    assert all(check["sentence"] in printed for check in strength["checks"].values())
    # Nothing is said of what the other roller bears.
    assert found(run, case, "--body", "b")["strength"]["static_safety"] is None
