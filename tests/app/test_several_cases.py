"""``nonhertz solve`` with several case files: one row each, whatever becomes of the others."""

import csv
import io
from pathlib import Path

import pytest

import nonhertz as nh
import nonhertz.solver.one
from nonhertz.amounts import format_digits
from nonhertz.files.several import HEAD

EXAMPLES = Path(__file__).parents[2] / "examples"
CROWNED = (EXAMPLES / "crowned-roller.toml").read_text(encoding="utf-8")
FIGURES = {f"{name}.{ending}" for name in ("pressure", "footprint", "profile") for ending in ("svg", "png")}
FIGURES |= {"pressure.csv", "footprint.csv", "profile.csv"}


@pytest.fixture
def cases(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("other").mkdir()
    Path("one.toml").write_text(CROWNED, encoding="utf-8")
    Path("other", "one.toml").write_text(CROWNED.replace("load = 20000.0", "load = 5000.0"), encoding="utf-8")
    return ["one.toml", "other/one.toml"]


def test_a_row_for_each_case(cases, run):
    printed = run("solve", *cases)
    assert printed.err == ""
    lines = [line.split() for line in printed.out.splitlines()]
    rows = {line[0]: line for line in lines if line and line[0] in cases}
    assert set(rows) == set(cases)
    assert printed.out.startswith("Pressure unbounded in one.toml. ")
    expected = [nh.read_case(case).solve() for case in cases]
    for case, solution in zip(cases, expected, strict=True):
        assert format_digits(solution.load) in rows[case]
        assert rows[case][-2] == str(len(solution.warnings))
        assert rows[case][-1] in {"warning", "warnings"}
    assert sum(line[:1] == ["warning:"] for line in lines) == sum(len(each.warnings) for each in expected)


def test_json_is_a_list_of_what_each_alone_prints(cases, run):
    found = run("solve", *cases, "--json").json
    assert [each["file"] for each in found] == cases
    for case, each in zip(cases, found, strict=True):
        assert each["result"] == run("solve", case, "--json").json
        assert each["complaints"] == []


def test_one_that_fails_does_not_hide_the_others(cases, run):
    Path("bad.toml").write_text(CROWNED.replace("load = 20000.0", "load = -1.0\nlaod = 3"), encoding="utf-8")
    bearing = str(EXAMPLES / "nu206.toml")
    files = ["bad.toml", cases[0], "missing.toml", bearing]
    printed = run("solve", *files, code=2)
    assert printed.out.count("not solved") == 3
    assert "20000" in printed.out
    sentences = printed.err.splitlines()
    wrong = ("bad.toml: load.load = ", "bad.toml: Unknown key load.laod")
    assert all(sentence.startswith(beginning) for sentence, beginning in zip(sentences, wrong, strict=False))
    assert sentences[2].startswith("missing.toml must exist")
    assert "nonhertz bearing" in sentences[3]
    found = run("solve", *files, "--json", code=2).json
    assert [each["result"] is None for each in found] == [True, False, True, True]
    assert [len(each["complaints"]) for each in found] == [2, 0, 1, 1]


@pytest.mark.slow
def test_each_has_a_folder_of_its_own_beside_the_table(cases, run):
    printed = run("solve", *cases, "missing.toml", "--out", "results", code=2).out
    assert {path.name for path in Path("results").iterdir()} == {"one", "one-2", "cases.csv"}
    for folder, case in (("one", cases[0]), ("one-2", cases[1])):
        assert {path.name for path in Path("results", folder).iterdir()} == FIGURES | {"result.json", "table.csv"}
        assert nh.read_result(Path("results", folder, "result.json")).case == nh.read_case(case)
    assert printed.count("wrote ") == 2 * (len(FIGURES) + 2) + 1
    table = list(csv.reader(io.StringIO(Path("results", "cases.csv").read_text(encoding="utf-8"))))
    assert tuple(table[0]) == HEAD
    assert [row[0] for row in table[1:]] == [*cases, "missing.toml"]
    pressure = HEAD.index("max_pressure [MPa]")
    for row, case in zip(table[1:], cases, strict=False):
        assert float(row[pressure]) == nh.read_case(case).solve().max_pressure
    assert set(table[3][3:-1]) == {""}
