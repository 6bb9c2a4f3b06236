"""``nonhertz verify`` as a user meets it: a table of numbers that are known, JSON, exit codes."""

import json

import pytest

from nonhertz import selfcheck
from nonhertz.bodies import images
from nonhertz.cli import main
from nonhertz.selfcheck import Claim
from nonhertz.subsurface.inside import Inside


@pytest.mark.slow
def test_every_part_computes_what_is_known(run):
    printed = run("verify")
    assert printed.err == ""
    lines = printed.out.splitlines()
    assert max(map(len, lines)) <= 120
    assert all(section in lines for section in selfcheck.SECTIONS)
    assert sum(" pass " in line for line in lines) == 29
    assert lines[-1] == "29 numbers: all as expected"


def test_a_number_that_is_off_is_told_in_the_table_as_json_and_by_the_exit_code(run, monkeypatch):
    monkeypatch.setattr(selfcheck, "SECTIONS", {"Counting": lambda: [Claim("two", "fingers", 3.0, 1e-6, lambda: 2.0)]})
    lines = run("verify", code=1).out.splitlines()
    assert lines[2].split() == ["two", "2", "3", "-3e-01", "1e-06", "FAIL", "fingers"]
    assert lines[-1] == "1 numbers: 1 off by more than allowed"
    (check,) = json.loads(run("verify", "--json", code=1).out)
    assert (check["section"], check["expected"], check["computed"], check["passed"]) == ("Counting", 3.0, 2.0, False)


@pytest.mark.parametrize(
    ("module", "name", "wrong", "section"),
    [
        (images, "chains", lambda right: lambda *given: {at: 0.9 * w for at, w in right(*given).items()}, "Ends of"),
        (Inside, "stress", lambda right: lambda *given, **more: 1.05 * right(*given, **more), "Stress below"),
    ],
)
@pytest.mark.slow
def test_a_mistake_in_a_part_shows(module, name, wrong, section, monkeypatch):
    monkeypatch.setattr(module, name, wrong(getattr(module, name)))
    failed = {check.section for check in selfcheck.run() if not check.passed}
    assert any(each.startswith(section) for each in failed)


def test_the_command_takes_nothing_else(capsys):
    assert main(["verify", "--only", "half-space"]) == 2
    assert "--only" in capsys.readouterr().err
