"""``--decimal-comma``: every table, as a spreadsheet in German reads it."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import pytest

from nonhertz.cli import main
from nonhertz.io.dialect import choose_decimal_commas
from nonhertz.io.folder import write_files

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = str(EXAMPLES / "crowned-roller.toml")
NUMBER = re.compile(r"[-+]?\d+(\.\d*)?(e[-+]?\d+)?")
GERMAN = re.compile(r"[-+]?\d+(,\d*)?(e[-+]?\d+)?")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("nodes.csv").write_text("x, y\n0.1, 0.5\n0, 1\n0.1, 2\n", encoding="utf-8")
    return tmp_path


def rows(path: Path, **how: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(path.read_text(encoding="utf-8-sig")), **how))


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ["solve", CASE],
        ["solve", CASE, str(EXAMPLES / "roller-15x20.toml")],
        ["bearing", str(EXAMPLES / "nu206.toml"), "--set", "solver.method=slices"],
        ["stress", CASE],
        ["compare", CASE, "--cells", "16", "32"],
        ["profile", str(EXAMPLES / "measured-roller.txt")],
        ["map", CASE, "--load", "0:5kN:5", "--tilt", "0", "--accuracy", "0.1"],
        ["sweep", CASE, "--over", "load.load=5kN:20.5kN:3"],
        ["nodes", CASE, "nodes.csv"],
    ],
    ids=lambda words: f"{words[0]} {len(words)}",
)
def test_every_table_is_the_same_but_for_its_commas(words: list[str]) -> None:
    name = "found.csv" if words[0] in {"map", "nodes"} else "found"
    assert main([*words, "--out", f"plain/{name}"]) == 0
    assert main([*words, "--out", f"german/{name}", "--decimal-comma"]) == 0
    tables = [path.relative_to("plain") for path in Path("plain").rglob("*.csv")]
    assert tables
    for table in tables:
        plain, german = rows(Path("plain", table)), rows(Path("german", table), delimiter=";")
        assert Path("german", table).read_bytes().startswith(b"\xef\xbb\xbf")
        assert len(plain) == len(german) > 1
        for cells, others in zip(plain, german, strict=True):
            assert [cell.replace(".", ",") if NUMBER.fullmatch(cell) else cell for cell in cells] == others
        assert any("," in cell and GERMAN.fullmatch(cell) for row in german for cell in row)
    assert not list(Path("german").rglob("*.rewritten"))


@pytest.mark.slow
def test_a_profile_in_this_form_can_be_solved_with() -> None:
    assert main(["profile", str(EXAMPLES / "measured-roller.txt"), "--out", "p", "--decimal-comma"]) == 0
    text = '[body.a]\ndiameter = 16\nlength = 20\nprofile = [{ kind = "tabulated", file = "p/profile.csv" }]\n'
    Path("case.toml").write_text(text + '[body.b]\n[load]\nload = "3 kN"\n', encoding="utf-8")
    assert main(["check", "case.toml"]) == 0


@pytest.mark.slow
def test_the_choice_ends_with_the_command() -> None:
    assert main(["solve", CASE, "--out", "german", "--decimal-comma"]) == 0
    assert main(["solve", CASE, "--out", "plain"]) == 0
    assert ";" not in Path("plain", "table.csv").read_text(encoding="utf-8")


def test_words_keep_their_points() -> None:
    choose_decimal_commas(True)
    try:
        text = 'name,value\n"a; b. c",1.5\n1.2.3,-4.5e-06\nv1.5,7\n'
        write_files("folder", {"table.csv": text, "other.txt": text})
    finally:
        choose_decimal_commas(False)
    written = Path("folder", "table.csv").read_text(encoding="utf-8-sig")
    assert written == 'name;value\n"a; b. c";1,5\n1.2.3;-4,5e-06\nv1.5;7\n'
    assert Path("folder", "other.txt").read_text(encoding="utf-8") == text
