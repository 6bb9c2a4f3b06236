"""Tables as Excel workbooks, read back by openpyxl."""

import builtins
import csv
import io
import math
from pathlib import Path
from typing import Any

import openpyxl
import pytest

import nonhertz as nh
from nonhertz.cli import main
from nonhertz.errors import InputError
from nonhertz.files.several import HEAD
from nonhertz.files.workbooks import MOST_ROWS, refuse_too_many, write_workbook

EXAMPLES = Path(__file__).parents[2] / "examples"
DIGITS = 1e-15  # openpyxl writes sixteen
CASES = [str(EXAMPLES / f"{name}.toml") for name in ("crowned-roller", "roller-15x20")]


def sheets(path: Path) -> dict[str, list[tuple[Any, ...]]]:
    book = openpyxl.load_workbook(path)
    try:
        return {sheet.title: list(sheet.iter_rows(values_only=True)) for sheet in book}
    finally:
        book.close()


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_cases_are_rows_of_numbers_and_inputs_a_second_sheet(run):
    assert (
        "wrote r.xlsx"
        in run("solve", *CASES, "missing.toml", "--set", "load.tilt=0.4 mrad", "--out", "r.xlsx", code=2).out
    )
    assert [path.name for path in Path().iterdir()] == ["r.xlsx"]
    found = sheets(Path("r.xlsx"))
    assert list(found) == ["cases", "inputs"]
    head, *rows = found["cases"]
    assert head == HEAD
    pressure = HEAD.index("max_pressure [MPa]")
    for row, case in zip(rows, CASES, strict=False):
        solution = nh.read_case(case, {"load.tilt": "0.4 mrad"}).solve()
        assert row[pressure] == pytest.approx(solution.max_pressure, rel=DIGITS)
    assert rows[2][2] == "not-solved"
    assert rows[2][pressure] is None
    inputs = {(case, path): value for case, path, value in found["inputs"][1:]}
    assert inputs[CASES[0], "load.tilt"] == "0.4 mrad"
    assert inputs[CASES[0], "load.load"] == 20000.0
    assert inputs[CASES[0], "body.a.profile[1].radius"] == 4000.0


def test_one_case_makes_a_table_too_and_csv_has_the_same():
    assert main(["solve", CASES[0], "--out", "one.xlsx"]) == 0
    assert main(["solve", CASES[0], "--out", "one.csv"]) == 0
    assert len(sheets(Path("one.xlsx"))["cases"]) == 2
    (row,) = csv.DictReader(io.StringIO(Path("one.csv").read_text(encoding="utf-8")))
    book = dict(zip(*sheets(Path("one.xlsx"))["cases"], strict=True))
    for name in HEAD[3:-2]:
        assert float(row[name]) == pytest.approx(book[name], rel=DIGITS), name


@pytest.mark.slow
def test_rows_of_a_sweep(run):
    words = ["sweep", CASES[0], "--over", "load.load=5kN:20kN:4", "--excel", "--out", "found"]
    assert str(Path("found", "rows.xlsx")) in run(*words).out
    found = sheets(Path("found", "rows.xlsx"))
    table = list(csv.reader(io.StringIO(Path("found", "rows.csv").read_text(encoding="utf-8"))))
    assert list(found["rows"][0]) == table[0]
    for row, cells in zip(found["rows"][1:], table[1:], strict=True):
        assert [None if cell == "" else pytest.approx(float(cell), rel=DIGITS) for cell in cells] == list(row)
    assert found["inputs"][1] == ("varied", "load.load", "5kN:20kN:4")
    assert "body.a.diameter" in {path for _, path, _ in found["inputs"]}


def test_text_is_text_and_what_is_not_finite_is_empty():
    write_workbook(Path("t.xlsx"), {"s": (("=1+1", "b"), [["=2*3", 1.5], [math.nan, math.inf], [None, 7]])})
    book = openpyxl.load_workbook("t.xlsx")
    assert [cell.data_type for cell in book["s"]["A"]] == ["s", "s", "n", "n"]
    assert list(book["s"].iter_rows(values_only=True)) == [("=1+1", "b"), ("=2*3", 1.5), (None, None), (None, 7)]
    assert book["s"].freeze_panes == "A2"
    book.close()


def test_more_rows_than_a_sheet_holds_are_refused():
    refuse_too_many("excel", MOST_ROWS - 1)
    with pytest.raises(InputError, match="at most 1,048,575 rows"):
        refuse_too_many("excel", MOST_ROWS)


def test_without_openpyxl_the_way_out_is_said_before_the_work(monkeypatch, run):
    whole = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name.partition(".")[0] == "openpyxl":
            raise ModuleNotFoundError("No module named 'openpyxl'", name="openpyxl")
        return whole(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    for words in (["solve", *CASES, "--out", "r.xlsx"], ["sweep", CASES[0], "--over", "load.load=5kN,6kN", "--excel"]):
        said = run(*words, code=2).err
        assert "needed for a workbook, is not installed: pip install openpyxl, or pip install '.[data]'" in said
    assert not list(Path().iterdir())
