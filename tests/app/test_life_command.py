"""``nonhertz life`` as a user meets it: table, spectrum, comparison, files, exit codes."""

import csv
import html
import json
import re
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import nonhertz as nh
import nonhertz.plot
import nonhertz.show.analysis
from nonhertz.amounts import format_digits
from nonhertz.cli import main
from nonhertz.files.casefile import read_case
from nonhertz.files.schemas import schema_of
from nonhertz.life import ContactLoadCase, assess, ioannides_harris, solve_spectrum

pytestmark = pytest.mark.slow

CASE = """
title = "Roller on a ring"
[body.a]
kind = "roller"
diameter = 15
length = 15
profile = [{ kind = "iso-logarithmic" }]
[body.b]
kind = "ring"
diameter = 60
length = 20
[load]
load = "12 kN"
tilt = "0.1 mrad"
[solver]
strips = 15
[life]
rollers = 14
"""
LOADS = ((20e3, 0.5e-3, 0.1), (12e3, 0.0, 0.3), (5e3, 0.2e-3, 0.6))
SPECTRUM = "".join(f"[[life.spectrum]]\nload = {load}\ntilt = {tilt}\nshare = {share}\n" for load, tilt, share in LOADS)
FILES = {"life.json", "life.csv", "life-density.svg", "life-density.png", "life-density.csv"}
# Laminae take no time.
QUICK = ["--model", "iso-16281"]


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(CASE, encoding="utf-8")
    return "case.toml"


def changed(old: str, new: str, name: str = "other.toml", text: str = CASE) -> str:
    """Write the case file with something else in it and return its name."""
    assert old in text
    Path(name).write_text(text.replace(old, new, 1), encoding="utf-8")
    return name


def found_in(words: list[str], run) -> dict[str, Any]:
    printed = run("life", *words, "--json")
    assert printed.err == ""
    found: dict[str, Any] = json.loads(printed.out)
    jsonschema.validate(found, schema_of("life"))
    return found


def refused(words: list[str], run) -> str:
    printed = run("life", *words, code=2)
    assert printed.out == ""
    return printed.err


def solved(path: str) -> nh.Solution:
    problem = read_case(path)
    return nh.solve(problem.contact, **problem.prescribed.keywords, **problem.solver.keywords)


def test_the_table_says_what_its_numbers_mean(case, run):
    printed = run("life", case, "--model", "lundberg-palmgren", "iso-16281")
    assert printed.err == ""
    lines = printed.out.splitlines()
    assert lines[0] == "Roller on a ring"
    assert lines[1].startswith("Not judged. ")
    load = re.split(r"\s{2,}", lines[3].strip())
    assert [load[0], float(load[1]), load[-1]] == ["100 %", 12.0, "not judged"]
    assert re.split(r"\s{2,}", lines[4].strip()) == [
        "life relative to ideal profile: a",
        "b",
        "L10 [10^6 rev]",
        "damage",
    ]
    rows = {cells[0]: cells[1:] for cells in (re.split(r"\s{2,}", line.strip()) for line in lines[5:7])}
    (life,) = assess(solved(case), "lundberg-palmgren", rollers=14, body="b")
    assert float(rows["lundberg-palmgren"][1]) == pytest.approx(life.relative_life, rel=1e-3)
    assert float(rows["lundberg-palmgren"][2]) == pytest.approx(life.million_revolutions, rel=1e-3)
    assert rows["lundberg-palmgren"][3] == "tau_xz^10.33 / z^2.333, e = 1.125"
    assert rows["iso-16281"][3] == "60 laminae, edges as solved, e = 1.125"
    text = " ".join(printed.out.split())
    assert "1 is the life of the same bodies under Hertz's line pressure" in text
    assert "L10 is the life that 90 % of rings, body b, reach if all 14 rollers are under this load." in text
    assert "There is no absolute life" not in text


def test_a_spectrum_takes_the_place_of_the_load(case, run):
    Path(case).write_text(CASE + SPECTRUM, encoding="utf-8")
    printed = run("life", case, *QUICK).out
    rows = [line.split() for line in printed.splitlines() if re.match(r" *\d+ %", line)]
    assert [row[:3] for row in rows] == [["10", "%", "20.000"], ["30", "%", "12.000"], ["60", "%", "5.0000"]]
    # The others go on with [load].
    assert run("solve", case, "--json").json["load"] == pytest.approx(12e3, rel=1e-12)


def test_parameters_come_from_the_file_and_models_from_either(case, run):
    table = 'rollers = 14\nmodels = ["iso-16281"]\nlaminae = 40\nfatigue_limit = "0.3 GPa"\nslope = 1.5'
    path = changed("rollers = 14", table)
    (of_file,) = found_in([path], run)["models"]
    assert (of_file["name"], of_file["parameters"]["laminae"]) == ("iso-16281", 40)
    (asked,) = found_in([path, "--model", "ioannides-harris"], run)["models"]
    assert (asked["parameters"]["fatigue_limit"], asked["parameters"]["slope"]) == (300.0, 1.5)
    (life,) = assess(solved(case), ioannides_harris(fatigue_limit=300.0, slope=1.5), body="b")
    assert asked["relative_life"]["b"] == life.relative_life


def test_another_case_is_compared_by_the_models_of_the_first(case, run):
    table = 'rollers = 15\nmodels = ["zaretsky"]\nlaminae = 100\n' + SPECTRUM
    other = changed("rollers = 14", table)
    found = found_in([case, *QUICK, "--compare", other], run)
    compared = found["compared_with"]
    assert (compared["rollers"], len(compared["spectrum"])) == (15, 3)
    assert compared["models"][0]["parameters"]["laminae"] == 60
    problem = read_case(other)
    (of_first,) = assess(solved(case), "iso-16281", body="b")
    spectrum = solve_spectrum(
        problem.contact, [ContactLoadCase(load=q, tilt=t, share=u) for q, t, u in LOADS], strips=15
    )
    (of_other,) = assess(spectrum, "iso-16281", body="b")
    assert compared["models"][0]["ratio"] == dict.fromkeys("ab", of_first.over(of_other))
    assert abs(compared["models"][0]["ratio"]["b"] - 1.0) > 1e-3
    lines = run("life", case, *QUICK, "--compare", other).out.splitlines()
    assert f"{case}: Roller on a ring" in lines
    assert f"compared with {other}: Roller on a ring" in lines
    (row,) = (line.split() for line in lines if line.startswith("iso-16281, body b"))
    assert float(row[-1]) == pytest.approx(of_first.over(of_other), rel=1e-3)


def test_all_files_are_written(case, run):
    models = ["--model", "lundberg-palmgren", "iso-16281"]
    found = found_in([case, *models, "--out", "new/folder", "--compare", case], run)
    folder = Path("new/folder")
    assert {path.name for path in folder.iterdir()} == FILES | {"compared.csv"}
    assert json.loads((folder / "life.json").read_text(encoding="utf-8")) == found
    with (folder / "life.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    laminae = [row for row in rows if (row["body"], row["model"]) == ("a", "iso-16281")]
    assert len(laminae) == 60
    # Of equal laminae the mean density is the damage over that under the ideal pressure.
    mean = np.mean([float(row["density"]) for row in laminae])
    model = found["models"][1]
    assert mean == pytest.approx(model["damage"]["a"] / model["reference"]["a"], rel=1e-9)
    assert found["compared_with"]["models"][0]["ratio"] == {"a": 1.0, "b": 1.0}


def test_what_is_no_number_is_null_and_said_in_words(case, run):
    unbounded = Path("endless.toml")
    text = re.sub("(?m)^(kind|length) .*\n", "", CASE).replace("12 kN", "1 kN")
    unbounded.write_text(text.replace('"iso-logarithmic"', '"crown", radius = 100'), encoding="utf-8")
    printed = " ".join(run("life", "endless.toml", "--out", "folder").out.split())
    assert "none: the bodies can touch over an unlimited length" in printed
    assert "warning: iso-16281 is left out: it needs a length" in printed
    found = json.loads(Path("folder/life.json").read_text(encoding="utf-8"))
    assert found["models"][0]["relative_life"] == {"a": None, "b": None}
    assert found["models"][0]["damage"]["b"] > 0.0
    sentence = refused(["endless.toml", *QUICK], run)
    assert sentence.startswith("body.a.length must be given for laminae: ")


def test_mistakes_of_the_other_file_are_named_with_its_path(case, run):
    other = changed("rollers = 14", "rollers = -1\nslope = 0")
    first, second = refused([case, "--compare", other], run).splitlines()
    assert first.startswith("1. other.toml: life.rollers = -1 must be a whole number of at least 1: ")
    assert second.startswith("2. other.toml: life.slope = 0.0 must be positive: ")


def test_no_life_without_a_solution_of_the_other_file(case, monkeypatch, run):
    def stop(contact: nh.Contact, *_: object, **__: object) -> Any:
        raise nh.ConvergenceError("It stopped.", None)

    monkeypatch.setattr(nonhertz.show.analysis, "solve_spectrum", stop)
    stopping = changed("rollers = 14", "rollers = 14\n" + SPECTRUM)
    printed = run("life", case, "--compare", stopping, *QUICK, "--out", "folder", code=1)
    assert (printed.out, printed.err) == ("", "other.toml: It stopped.\n")
    assert not Path("folder").exists()


DENTED = """
[body.a]
kind = "roller"
diameter = 20
length = 8
profile = [{ kind = "crown", radius = 100 }]
[body.b]
kind = "ring"
diameter = 80
[load]
load = 300
[solver]
strips = 15
[life]
models = ["zaretsky", "iso-16281"]
[life.dent]
depth = "2 um"
diameter = 0.3
shoulder = "0.5 um"
dents = 10
"""


def test_a_dent_that_is_rolled_over_is_in_table_files_and_report(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("dent.toml").write_text(DENTED, encoding="utf-8")
    dent, contact = nh.patch.Dent(depth=0.002, diameter=0.3, shoulder=0.0005), read_case("dent.toml").contact
    coarse = nonhertz.life.overrolled(solved("dent.toml"), dent, body="b", cell=0.038, reach=0.6)

    def overrolled(solution: nh.Solution, asked: nh.patch.Dent, body: str = "b", **_: object) -> object:
        assert (solution.contact, solution.load, asked, body) == (contact, pytest.approx(300.0), dent, "b")
        return coarse

    monkeypatch.setattr(nonhertz.show.analysis, "overrolled", overrolled)
    monkeypatch.setattr("nonhertz.report.layout.image", lambda *_: b"<svg></svg>")
    assert main(["life", "dent.toml", "--out", "out"]) == 0
    life = coarse.relative_life(nonhertz.life.zaretsky(), dents=10)
    sentence = (
        f"10 dents in the raceway of body b reduce its life to this fraction: {format_digits(life, 4)} (zaretsky)."
    )
    assert sentence in capsys.readouterr().out
    assert {each.name for each in Path("out").iterdir()} == FILES | {"life-dent.svg", "life-dent.png", "life-dent.csv"}
    (of_zaretsky, of_laminae) = json.loads(Path("out/life.json").read_text(encoding="utf-8"))["models"]
    assert of_zaretsky["with_dents"] == pytest.approx(life, rel=1e-12)
    assert "with_dents" not in of_laminae
    assert main(["report", "dent.toml", "--out", "report.html"]) == 0
    page = Path("report.html").read_text(encoding="utf-8")
    assert sentence in html.unescape(page)
    assert "The largest stress around the dent while it is rolled over" in page


def test_dents_are_refused_by_their_keys(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    for old, new, words in (
        ('depth = "2 um"', "depth = -1", "life.dent.depth = -1.0 must be positive"),
        ("dents = 10", "dents = 1.5", "life.dent.dents = 1.5 must be a whole number"),
        ("dents = 10", 'body = "c"', "life.dent.body = 'c' must be one of 'a', 'b'"),
        ("dents = 10", "y = 3.9", "life.dent.y = 3.9 must lie between"),
        (
            "dents = 10",
            "[[life.spectrum]]\nload = 1\nshare = 1",
            "life.dent = 'with a spectrum' must be under one load",
        ),
    ):
        assert words in refused([changed(old, new, text=DENTED)], run)


def test_what_models_assume_is_said_where_it_is_left_out(case, run):
    def defaults(*words: str) -> list[str]:
        found = run("life", case, "--json", *words).json["assumed"]
        return [each["numbers"]["default"] for each in found]

    by_laminae = ("--model", "iso-16281")
    assert defaults(*by_laminae) == ["edge stress as solved", "line loads as solved"]
    assert defaults(*by_laminae, "--set", "life.line_loads=standard") == ["edge stress as solved"]
    # What a file gives is not assumed, even if it is the default.
    assert defaults(*by_laminae, "--set", "life.edge_stress=pressure") == ["line loads as solved"]
    printed = run("life", case, *by_laminae).out
    assert re.search(r"assumed +edge stress as solved +for life.edge_stress; decides the life by iso-16281", printed)
