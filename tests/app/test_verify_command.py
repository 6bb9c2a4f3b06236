"""``nonhertz verify`` as a user meets it: tables, page, JSON, exit codes."""

import json
import re
from pathlib import Path

import pytest

import nonhertz.verify.half_space
from nonhertz.cli import main
from nonhertz.verify import CATALOGUE
from nonhertz.verify.claim import Claim

TEXTS = {"validation.md", "verify.json"}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def let_it_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the section half-space be one claim, which fails."""
    monkeypatch.setattr(
        nonhertz.verify.half_space, "rollers", lambda: [Claim("two", "counting", 3.0, lambda: 2.0, 1e-6)]
    )


def test_a_section_is_printed_and_written(run):
    printed = run("verify", "--only", "half-space", "--out", "new/page")
    assert printed.err == ""
    lines = printed.out.splitlines()
    assert lines[0].split() == ["Rollers", "on", "half-spaces", "(half-space)"]
    assert lines[1].split() == ["claim", "source", "expected", "computed", "difference", "tolerance", "verdict"]
    assert max(map(len, lines)) <= 120
    assert {line.split()[-1] for line in lines[2:] if re.search(r" \S+e-\d+ ", line)} == {"pass", "shown"}
    assert {path.name for path in Path("new/page").iterdir()} == TEXTS
    assert "wrote new/page/validation.md" in printed.out.replace("\\", "/")

    checks = json.loads(Path("new/page/verify.json").read_text(encoding="utf-8"))
    verdicts = [check["verdict"] for check in checks]
    assert lines[-1] == (
        f"{len(checks)} checks: {verdicts.count('pass')} passed, 0 failed, {verdicts.count('shown')} shown"
    )
    page = Path("new/page/validation.md").read_text(encoding="utf-8")
    assert "`nonhertz verify --out DIR --only half-space`" in page


def test_a_failed_check_is_told_by_the_exit_code(run, monkeypatch):
    let_it_fail(monkeypatch)
    lines = run("verify", "--only", "half-space", "--out", "page", code=1).out.splitlines()
    assert lines[2].split() == ["two", "counting", "3", "2", "-3.3e-1", "1e-6", "FAIL"]
    assert lines[-1] == "1 checks: 0 passed, 1 failed, 0 shown"
    page = Path("page/validation.md").read_text(encoding="utf-8")
    assert "| two | counting | 3 | 2 | -3.3e-1 | 1e-6 | FAIL |" in page
    assert main(["verify", "--only", "half-space", "--json"]) == 1


def test_the_documentation_lists_every_section():
    page = Path(__file__).parents[2] / "docs" / "reference" / "command-line.md"
    text = page.read_text(encoding="utf-8")
    assert all(f"`{name}`" in text for name in CATALOGUE)
