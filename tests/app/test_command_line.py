"""The command line as a user meets it: summaries, JSON, files, exit codes."""

import csv
import ctypes
import dataclasses
import errno
import io
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nonhertz as nh
import nonhertz.plot
import nonhertz.show.analysis
import nonhertz.solver.one
from nonhertz.cli import main
from nonhertz.cli.commands import COMMANDS, EXAMPLES, build_application, repeat_set_option
from nonhertz.cli.printing import print_result
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.starting import BEARING_TEMPLATES, TEMPLATES
from nonhertz.result.solution import Solution
from nonhertz.show.sections import Section, Table

CASE = Path(__file__).parents[2].joinpath("examples", "crowned-roller.toml").read_text(encoding="utf-8")
FILES = {f"{figure}.{ending}" for figure in ("pressure", "footprint", "profile") for ending in ("svg", "png")} | {
    "result.json",
    "table.csv",
    "pressure.csv",
    "footprint.csv",
    "profile.csv",
}


def refuse_constant(word: str) -> None:
    raise AssertionError(f"{word} is not JSON")


def parsed(text: str) -> dict[str, Any]:
    """Return the one JSON object that the text is, refusing what only Python calls JSON."""
    value = json.loads(text, parse_constant=refuse_constant)
    assert isinstance(value, dict)
    return value


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(CASE, encoding="utf-8")
    return "case.toml"


@pytest.fixture
def solution():
    profile = nh.profile.crown(radius=4000)
    roller = nh.Roller(diameter=20, length=20, profile=profile, side_faces="none", depth="none")
    with without_accuracy_warnings():
        return nh.solve(nh.Contact(roller, nh.Plate()), load=20000.0, tilt=0.0005)


def environment(**more: str) -> dict[str, str]:
    """Return the environment for another Python, which finds the package wherever it is started."""
    return os.environ | {"PYTHONPATH": str(Path(nh.__file__).parents[1])} | more


def stop_short(monkeypatch: pytest.MonkeyPatch, solution: Solution) -> None:
    """Let every solve end without a solution."""
    unfinished = dataclasses.replace(solution, status=nh.Status.ITERATION_LIMIT)

    def solve(*_: object, **__: object) -> Solution:
        raise nh.ConvergenceError("It did not converge.", unfinished)

    monkeypatch.setattr(nonhertz.solver.one, "solve", solve)


@pytest.mark.slow
def test_out_writes_results_table_and_figures(case, run):
    printed = run("solve", case, "--out", "new/results", "--json").out
    folder = Path("new/results")
    assert {path.name for path in folder.iterdir()} == FILES
    assert parsed((folder / "result.json").read_text(encoding="utf-8")) == parsed(printed)
    rows = list(csv.reader(io.StringIO((folder / "table.csv").read_text(encoding="utf-8"))))
    assert rows[0] == [
        "y [mm]",
        "strip_width [mm]",
        "line_load [N/mm]",
        "centre_pressure [MPa]",
        "half_width [mm]",
        "gap [mm]",
    ]
    np.testing.assert_array_equal(np.array(rows[1:], dtype=float)[:, 2], parsed(printed)["line_load"])
    drawn = list(csv.DictReader(io.StringIO((folder / "pressure.csv").read_text(encoding="utf-8"))))
    largest = max(float(row["value"]) for row in drawn if row["panel"] == "pressure")
    assert largest == max(float(row[3]) for row in rows[1:])
    for path in folder.glob("*.png"):
        assert path.read_bytes().startswith(b"\x89PNG")
    for path in folder.glob("*.svg"):
        assert "<svg" in path.read_text(encoding="utf-8")[:1000]


@pytest.mark.parametrize("out", ["case.toml/below", "new/page"])
def test_out_that_cannot_be_written_is_refused(case, run, monkeypatch, out):
    def refuse(*_: object, **__: object) -> str:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("tempfile.mkdtemp", refuse)  # whoever runs the tests may be allowed everything
    printed = run("solve", case, "--out", out, code=2)
    assert printed.out == ""
    assert len(printed.err.splitlines()) == 1
    assert "must be a directory to write to (" in printed.err
    assert [path.name for path in Path().iterdir()] == [case]


@pytest.mark.slow
def test_out_refuses_a_directory_in_the_place_of_a_file(case, run):
    Path("results/table.csv").mkdir(parents=True)
    assert "must not hold a directory named table.csv" in run("solve", case, "--out", "results", code=2).err
    assert [path.name for path in Path("results").iterdir()] == ["table.csv"]


@pytest.mark.slow
def test_an_unconverged_solve_is_shown_for_what_it_is(case, run, monkeypatch, solution):
    stop_short(monkeypatch, solution)
    printed = run("solve", case, code=1)
    assert "iteration-limit" in printed.out
    assert printed.err == "It did not converge.\n"

    assert run("solve", case, "--json", "--out", "results", code=1).json["status"] == "iteration-limit"
    assert parsed(Path("results/result.json").read_text(encoding="utf-8"))["status"] == "iteration-limit"


def test_new_prints_a_case_that_solves(tmp_path, run, monkeypatch):
    monkeypatch.chdir(tmp_path)
    printed = run("new").out
    assert main(["new", "first.toml"]) == 0
    assert Path("first.toml").read_text(encoding="utf-8") == printed
    assert run("solve", "first.toml", "--json").json["warnings"] == []


@pytest.mark.parametrize("kind", ["", *TEMPLATES, *(f"--bearing --template {name}" for name in BEARING_TEMPLATES)])
def test_a_plan_for_a_case_varies_what_that_has(kind, tmp_path, run, monkeypatch):
    monkeypatch.chdir(tmp_path)
    words = kind.split() if kind.startswith("--") or not kind else ["--template", kind]
    assert main(["new", "own.toml", *words]) == 0
    assert main(["new", "plan.toml", "--plan", "--case", "own.toml"]) == 0
    said = run("check", "plan.toml").out
    assert "a sweep of" in said
    assert "a tolerance study" in said


def test_a_plan_names_the_file_that_it_is_for(tmp_path, run, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("studies").mkdir()
    assert main(["new", "a roller.toml"]) == 0
    assert (
        "for a roller.toml; try it with: nonhertz design studies/plan.toml"
        in run("new", "studies/plan.toml", "--plan", "--case", "a roller.toml").out
    )
    assert 'case = "../a roller.toml"' in Path("studies/plan.toml").read_text(encoding="utf-8")
    assert main(["check", "studies/plan.toml"]) == 0
    assert "nothing.toml must exist" in run("new", "other.toml", "--plan", "--case", "nothing.toml", code=2).err
    assert not Path("other.toml").exists()
    assert (
        "--case = 'a roller.toml' must be given with --plan"
        in run("new", "other.toml", "--case", "a roller.toml", code=2).err
    )


def test_new_never_overwrites(case, run):
    assert run("new", case, code=2).err == (
        "case.toml already exists: choose another name, since nothing is overwritten.\n"
    )
    assert Path(case).read_text(encoding="utf-8") == CASE
    nowhere = run("new", "nowhere/case.toml", code=2).err
    assert nowhere.endswith("cannot be written (no such file or directory): make its folder first.\n")


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="a file that may not grow stands for a full disk")
def test_new_leaves_nothing_on_a_full_disk(tmp_path):
    import resource

    run = subprocess.run(
        [sys.executable, "-m", "nonhertz", "new", "case.toml"],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env=environment(),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)),
    )
    assert run.returncode == 2
    assert run.stderr == ("case.toml cannot be written (file too large): choose another name.\n")
    assert list(tmp_path.iterdir()) == []


def test_a_table_is_not_cut_to_a_narrow_terminal(capsys):
    cells = ["0.032151 mm", "20000 N", "some words that may be broken between lines", "2060.5"]
    table = Table([cells], [f"column {position}" for position in range(len(cells))], (1, 2))
    print_result("", [Section("", [table])], piped=20)
    printed = capsys.readouterr().out
    assert {word for cell in cells for word in cell.split()} <= set(printed.split())
    assert {"0.032151 mm", "20000 N", "column 0"} <= set(re.split(r"  +|\n", printed))
    assert cells[2] not in printed


def test_version(run):
    assert run("--version").out == f"{nh.__version__}\n"


@pytest.mark.parametrize(
    ("change", "doubt"),
    [
        ("body.a.profile=[{kind='crown', radius=60}]", "body a drops by 0.209 mm half-way to its end, over 1 %"),
        ("load.load=3MN", "no metal withstands the maximum pressure, "),
    ],
    ids=range(2),
)
def test_check_doubts_slips_of_units(case, run, change, doubt):
    assert f"\ndoubtful: {doubt}" in run("check", case, "--set", change).out


def test_check_names_each_of_several_files(case, run):
    first, second, third = run("check", case, "none.toml", code=2).out.splitlines()
    assert first.startswith("case.toml is fine: ")
    assert (second, third[:27]) == ("none.toml:", "1. none.toml must exist: gi")


def test_every_command_has_an_example_that_is_understood():
    assert set(EXAMPLES) == set(COMMANDS)
    for name, example in EXAMPLES.items():
        for words in example.split(", nonhertz "):
            command, *_ = build_application().parse_args(
                repeat_set_option(shlex.split(words)), exit_on_error=False, print_error=False
            )
            assert words.startswith(name)
            assert command.__wrapped__ is build_application()[name].default_command.__wrapped__


@pytest.mark.parametrize("words", [[], ["--help"], ["help"], ["solve", "--help"], ["help", "new"]])
def test_help(run, words):
    assert "Usage: nonhertz" in run(*words).out


def test_an_internal_error_is_one_sentence(case, run, monkeypatch):
    def break_down(*_: object, **__: object) -> Solution:
        raise ZeroDivisionError("float division\nby zero")

    monkeypatch.delenv("NONHERTZ_DEBUG", raising=False)
    monkeypatch.setattr(nonhertz.solver.one, "solve", break_down)
    printed = run("solve", case, code=3)
    assert printed.out == ""
    assert printed.err.startswith("This is an error in nonhertz (ZeroDivisionError: float division by zero)")
    assert len(printed.err.splitlines()) == 1

    assert "Traceback" in run("solve", case, "--debug", code=3).err
    monkeypatch.setenv("NONHERTZ_DEBUG", "1")
    assert "Traceback" in run("solve", case, code=3).err


def test_an_interruption_of_a_callback_ends_the_program(case, capsys, monkeypatch):
    # C code ignores what a callback raises, and Python drops it.
    callback = ctypes.CFUNCTYPE(None)(lambda: signal.raise_signal(signal.SIGINT))

    def interrupted_in_callback(*_: object, **__: object) -> None:
        callback()
        for _ in range(1000):  # a sleep would last to its end
            time.sleep(0.01)
        pytest.fail("The interruption was dropped.")

    monkeypatch.setattr(nonhertz.solver.one, "solve", interrupted_in_callback)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        assert main(["solve", case]) == 130
    finally:
        signal.signal(signal.SIGINT, before)
    assert capsys.readouterr().err == "Interrupted.\n"


@pytest.mark.parametrize("command", ["solve", "bearing", "sweep", "verify"])
@pytest.mark.parametrize("words", [["--out", ""], ["--out="]])
def test_an_empty_name_for_results_is_refused(case, capsys, command, words):
    assert main([command, case, *words]) == 2
    error = "--out = '' must name a directory or a file: write --out . for the current directory.\n"
    assert capsys.readouterr().err == error
    assert [path.name for path in Path.cwd().iterdir()] == [case]


@pytest.mark.parametrize("package", ["cyclopts", "matplotlib"])
@pytest.mark.slow
def test_a_missing_extra_says_how_to_install_it(case, package):
    Path(case).write_text(CASE.replace("diameter = 20.0", 'diameter = "20 mm"'), encoding="utf-8")
    program = (
        "import sys\n"
        f"sys.modules[{package!r}] = None\n"
        "from nonhertz.cli import main\n"
        "sys.exit(main(['solve', 'case.toml', '--out', 'results']))\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False, env=environment()
    )
    assert run.returncode == 2
    assert run.stderr == (
        f"The package {package}, needed for the command line, is not installed: "
        f"pip install {package}, or pip install '.[cli]' in the folder of nonhertz\n"
    )
    assert not Path("results").exists()


@pytest.mark.slow
def test_a_title_in_greek_survives_a_terminal_that_knows_ascii_only(case):
    Path(case).write_text(CASE.replace("Roller 20", "Rolle \u0394 [bold]"), encoding="utf-8")
    command = [sys.executable, "-m", "nonhertz", "solve", case]
    ascii_only = environment(PYTHONIOENCODING="ascii")
    run = subprocess.run(command, capture_output=True, check=False, env=ascii_only)
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith(b"Rolle ? [bold] x 20 on a plate")
