"""``nonhertz report`` as a user meets it: file, names, what is refused, exit codes."""

import datetime
from pathlib import Path

import pytest

import nonhertz.cli.report
import nonhertz.report.layout
import nonhertz.show.analysis
import nonhertz.solver.one
from nonhertz.cli import main
from nonhertz.report import MARK

CASE = """
title = "Roller on a plate"
[body.a]
kind = "roller"
diameter = 20
length = 20
profile = [{ kind = "crown", radius = 2000 }]
[body.b]
kind = "plate"
[load]
load = "6 kN"
[solver]
strips = 15
"""
QUICK = ["--no-stress"]


@pytest.fixture(autouse=True)
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    # Figures take the time, and tests/unit/test_report.py looks at them.
    monkeypatch.setattr(nonhertz.report.layout, "image", lambda *_: b"<svg></svg>")
    Path("case.toml").write_text(CASE, encoding="utf-8")
    return "case.toml"


def refused(words: list[str], run) -> list[str]:
    before = sorted(Path().rglob("*"))
    printed = run("report", *words, code=2)
    assert printed.out == ""
    assert sorted(Path().rglob("*")) == before
    return printed.err.splitlines()


def test_a_report_is_written_beside_and_replaced(case, run):
    printed = run("report", case, *QUICK)
    assert (printed.out, printed.err) == ("wrote case-report.html\n", "")
    text = Path("case-report.html").read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert MARK in text[:500]
    assert "<h2>Stress below the surface" not in text
    Path(case).write_text(CASE.replace("6 kN", "7 kN"), encoding="utf-8")
    assert main(["report", case, *QUICK]) == 0
    assert "7000 N" in Path("case-report.html").read_text(encoding="utf-8")


def test_only_reports_are_replaced(case, run):
    (line,) = refused([case, "--out", case], run)
    assert line.startswith("--out = 'case.toml' must be a new file or an older nonhertz report: ")
    assert Path(case).read_text(encoding="utf-8") == CASE
    Path("folder").mkdir()
    (line,) = refused([case, "--out", "folder"], run)
    assert line.startswith("--out = 'folder' must be a file, not a directory: ")
    (line,) = refused([case, "--out", "case.toml/report.html"], run)
    assert line.startswith("--out = 'case.toml' must be a directory")
    (line,) = refused([case, "--out", "report.pdf"], run)
    assert line == "--out = 'report.pdf' must end in .html: give the name of a file such as report.html."
    (line,) = refused([case, "--out", "nowhere/x/report.html"], run)
    assert line.startswith("--out = 'nowhere/x/report.html' must be in an existing folder, or in a new one within it")
    assert line.endswith(": make nowhere first, or correct the name.")
    assert not Path("nowhere").exists()


def test_the_head_says_what_the_file_and_the_options_say(case):
    table = '[report]\nproject = "Gearbox & sons"\nauthor = "A"\n'
    Path(case).write_text(CASE + table, encoding="utf-8")
    assert main(["report", case, *QUICK, "--author", "B"]) == 0
    text = Path("case-report.html").read_text(encoding="utf-8")
    for shown in ("<dd>Gearbox &amp; sons</dd>", "<dt>author</dt><dd>B</dd>"):
        assert shown in text
    today = datetime.date.today().isoformat()
    assert f"<dt>date</dt><dd>{today}</dd>" in text
    assert f'@top-right {{ content: "B, {today}"; }}' in text
    Path(case).write_text(f'{CASE}[report]\ndate = "in spring"\n', encoding="utf-8")
    assert main(["report", case, *QUICK]) == 0
    assert "<dt>date</dt><dd>in spring</dd>" in Path("case-report.html").read_text(encoding="utf-8")
    Path(case).write_text(CASE, encoding="utf-8")
    assert main(["report", case, *QUICK, "--no-date"]) == 0
    text = Path("case-report.html").read_text(encoding="utf-8")
    assert '<dl class="title-block">' not in text
    assert "This file contains no date" in text


def test_all_mistakes_of_all_files_are_named(case, run):
    Path("wrong.toml").write_text(CASE.replace("length = 20", "length = -20"), encoding="utf-8")
    lines = refused([case, "wrong.toml", "nothing.toml"], run)
    assert [line.split(" ")[1] for line in lines] == ["wrong.toml:", "nothing.toml"]
    (line,) = refused(["wrong.toml"], run)
    assert line.startswith("body.a.length = ")
