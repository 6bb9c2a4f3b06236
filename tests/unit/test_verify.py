"""Checks, their verdicts, and the page that is made of them."""

from __future__ import annotations

import importlib
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

import nonhertz as nh
from nonhertz import verify
from nonhertz.verify.claim import Check, Picture, Section
from nonhertz.verify.page import COLUMNS, as_json, as_markdown, row, summary, tally, write_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COMMAND = "nonhertz verify --out DIR"


def check(computed: float = 2.001, tolerance: float | None = 1e-3, **more: bool | str) -> Check:
    return Check("a number", "a law", 2.0, computed, tolerance, **more)  # type: ignore[arg-type]


def draw(figure: Figure) -> None:
    figure.add_subplot().plot([0.0, 1.0], [1.0, 2.0])


FOUND = {
    "one": Section("The first", "Some *text*.\n", (check(), check(3.0, None)), (Picture("line", "A line.", draw),)),
    "two": Section("The second", "More text.", (check(3.0), Check("|p| of a_1 ~ b", "a\nlaw", 1e-7, 1e-7, 1e-3, "mm"))),
}


@pytest.mark.parametrize(
    ("computed", "tolerance", "absolute", "verdict"),
    [
        (2.0, 1e-3, False, "pass"),
        (2.0019, 1e-3, False, "pass"),
        (1.9981, 1e-3, False, "pass"),
        (2.0021, 1e-3, False, "FAIL"),
        (1.9979, 1e-3, False, "FAIL"),
        (2.0009, 1e-3, True, "pass"),
        (2.0019, 1e-3, True, "FAIL"),
        (1.9981, 1e-3, True, "FAIL"),
        (7.0, None, False, "shown"),
        (math.nan, 1e-3, False, "FAIL"),
        (math.nan, 1e-3, True, "FAIL"),
        (math.inf, math.inf, False, "FAIL"),
        (math.nan, None, False, "shown"),
    ],
)
def test_verdicts(computed, tolerance, absolute, verdict):
    assert check(computed, tolerance, absolute=absolute).verdict == verdict


def test_a_difference_is_relative_to_the_size_of_the_expected_value():
    assert Check("", "", -2.0, -3.0, 1.0).difference == -0.5
    assert Check("", "", -2.0, -3.0, 1.0, absolute=True).difference == -1.0


def test_numbers_of_numpy_are_counted_like_any_other():
    failing = Check("", "", np.float64(1.0), np.float64(2.0), 0.1)
    assert tally({"one": Section("", "", (failing,))}) == {"FAIL": 1}


def test_the_summary_counts_every_verdict():
    assert summary(FOUND) == "4 checks: 2 passed, 1 failed, 1 shown"
    assert summary({}) == "0 checks: 0 passed, 0 failed, 0 shown"


def test_a_row_is_readable():
    assert row(check(2.0000062)) == ("a number", "a law", "2", "2.00001", "3.1e-6", "1e-3", "pass")
    shown = Check("depth", "a law", 1234.5678, 1234.0, None, "mm", absolute=True)
    assert row(shown) == ("depth [mm]", "a law", "1234.57", "1234", "-5.7e-1 abs", "", "shown")
    assert row(check(math.nan))[3:5] == ("nan", "nan")
    assert len(row(check())) == len(COLUMNS)


def test_the_page_has_everything_in_order():
    page = as_markdown(FOUND, COMMAND)
    parts = [
        f"`{COMMAND}`",
        f"nonhertz {nh.__version__}",
        "| The first | 2 | 1 | 0 | 1 |",
        "| The second | 2 | 1 | 1 | 0 |",
        "| all | 4 | 2 | 1 | 1 |",
        "## The first",
        "Some *text*.",
        "![line](line.svg)",
        "Figure 1. A line.",
        "| a number | a law | 2 | 2.001 | 5.0e-4 | 1e-3 | pass |",
        "| a number | a law | 2 | 3 | 5.0e-1 |  | shown |",
        "## The second",
        "| a number | a law | 2 | 3 | 5.0e-1 | 1e-3 | FAIL |",
    ]
    places = [page.index(part) for part in parts]
    assert places == sorted(places)


def test_figures_are_counted_through_the_page():
    picture = Picture("other", "Another.", draw)
    found = FOUND | {"three": Section("", "", (), (picture, picture))}
    page = as_markdown(found, COMMAND)
    assert "Figure 2. Another." in page
    assert "Figure 3. Another." in page


def test_words_in_a_table_stay_in_their_cell():
    line = next(line for line in as_markdown(FOUND, COMMAND).splitlines() if "a law | 1e-7" in line)
    assert line == r"| \|p\| of a\_1 \~ b [mm] | a law | 1e-7 | 1e-7 | 0 | 1e-3 | pass |"


def test_json_has_all_checks_and_no_infinity():
    found = FOUND | {"three": Section("The third", "", (check(math.nan),))}
    entries = json.loads(as_json(found))
    assert [entry["section"] for entry in entries] == ["one", "one", "two", "two", "three"]
    assert [entry["verdict"] for entry in entries] == ["pass", "shown", "FAIL", "pass", "FAIL"]
    assert [entry["tolerance"] for entry in entries] == [1e-3, None, 1e-3, 1e-3, 1e-3]
    assert entries[-1]["computed"] is None
    assert entries[3]["unit"] == "mm"
    assert json.loads(as_json({})) == []


def test_the_same_numbers_give_the_same_files(tmp_path):
    names = {"validation.md", "verify.json", "line.svg", "line.png"}
    written = [{path.name: path.read_bytes() for path in write_page(tmp_path / run, FOUND, COMMAND)} for run in "ab"]
    assert written[0].keys() == names
    assert written[0] == written[1]
    assert str(tmp_path).encode() not in written[0]["validation.md"]


def test_nothing_is_written_if_a_picture_fails(tmp_path):
    def fail(_: Figure) -> None:
        raise RuntimeError("the pen broke")

    found = FOUND | {"three": Section("", "", (), (Picture("broken", "", fail),))}
    with pytest.raises(RuntimeError, match="pen"):
        write_page(tmp_path / "new", found, COMMAND)
    assert list(tmp_path.iterdir()) == []


def test_sections_come_in_reading_order_and_unknown_ones_are_refused():
    assert verify.chosen() == tuple(verify.CATALOGUE)
    assert verify.chosen(["quarter-space", "half-space", "quarter-space"]) == ("half-space", "quarter-space")
    with pytest.raises(nh.InputError, match="choose from hertz-ellipse, line-limits, "):
        verify.chosen(["half-space", "nonsense"])


def test_each_section_is_announced_before_it_runs(monkeypatch):
    events = []

    def section() -> Section:
        events.append("runs")
        return FOUND["one"]

    monkeypatch.setattr(importlib.import_module(verify.CATALOGUE["half-space"]), "section", section)
    assert list(verify.sections(["half-space"], events.append)) == [("half-space", FOUND["one"])]
    assert events == ["half-space", "runs"]


def test_the_catalogue_lists_every_section():
    folder = Path(verify.__file__).parent
    modules = {f"nonhertz.verify.{path.stem}" for path in folder.glob("*.py")}
    apart = {f"nonhertz.verify.{name}" for name in ("__init__", "bearing_sums", "claim", "known_bearings", "page")}
    assert set(verify.CATALOGUE.values()) == modules - apart
    for name, module in verify.CATALOGUE.items():
        assert module.startswith(f"nonhertz.verify.{name.replace('-', '_')}")
        assert callable(importlib.import_module(module).section)


def test_a_section_that_cannot_finish_is_a_failed_check(monkeypatch):
    def stopped():
        raise nh.InputError("load", 0.0, "be positive", "raise it")

    monkeypatch.setattr(importlib.import_module(verify.CATALOGUE["line-limits"]), "section", stopped)
    ((name, section),) = verify.sections(["line-limits"])
    assert (name, section.failed) == ("line-limits", 1)
    assert "load = 0.0 must be positive" in section.text
