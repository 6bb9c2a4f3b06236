"""``nonhertz map`` as a user meets it: tables, files, refusals."""

import re
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.cli import main
from nonhertz.files.schemas import schema_of

CASE = """
title = "Crowned roller"
[body.a]
kind = "roller"
diameter = 20
length = 20
profile = { kind = "crown", radius = 4000 }
[body.b]
kind = "plate"
[load]
load = "5 kN"
tilt = "0.1 mrad"
"""


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(CASE, encoding="utf-8")
    return "case.toml"


@pytest.mark.slow
def test_a_map_is_printed_and_written_in_all_formats(case, run):
    words = ["map", case, "--accuracy", "0.02"]
    printed = run(*words, "--approach", "-5um:8um:14", "--tilt", "-0.2mrad:0.2mrad:5", "--out", "k.csv").out
    assert printed.startswith("Crowned roller\n")
    rows = [re.split(r"\s{2,}", line) for line in printed.splitlines()]
    assert ["approach", "-5 to 8 µm"] in [row[:2] for row in rows]
    assert ["tilt", "-0.2 to 0.2 mrad"] in [row[:2] for row in rows]
    assert "of the maximum pressure" in [row[-1] for row in rows]
    assert printed.endswith("wrote k.csv\n")
    lines = Path("k.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0].split(",")[:3] == ["approach [mm]", "tilt [rad]", "load [N]"]
    rows = np.array([[float(value) for value in line.split(",")] for line in lines[1:]])
    assert rows.shape == (14 * 5, 10)
    assert rows[0, :3].tolist() == [-0.005, -0.0002, 0.0]
    assert_allclose(rows[-1, :2], (0.008, 0.0002))

    assert main([*words, "--load", "0:1kN:4", "--out", "deep/k.csv"]) == 0
    tilt, load = np.loadtxt("deep/k.csv", delimiter=",", skiprows=1)[:, 1:3].T
    assert_allclose(load, [0.0, 1000 / 3, 2000 / 3, 1000.0], rtol=1e-9)
    assert_allclose(tilt, 1e-4, rtol=1e-9)  # that of the case

    said = run(*words, "--load", "0:1kN", "--tilt", "0.1 mrad", "--out", "k.npz", "--json").json
    jsonschema.validate(said, schema_of("map"))
    found = nh.ContactMap.read("k.npz")
    assert said["load"] == list(found.pressed) == [0.0, 1000.0]
    assert said["sampled_error"]["load"] == found.sampled_error.load
    assert_allclose(
        found.under(load=500.0, tilt=1e-4).approach, nh.solve(_contact(), load=500.0, tilt=1e-4).approach, rtol=0.02
    )


def _contact() -> nh.Contact:
    return nh.read_case("case.toml").contact
