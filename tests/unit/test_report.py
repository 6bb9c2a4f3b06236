"""The report: what it tells, that it stands alone, and that nothing a user writes becomes markup."""

import copy
import json
import re
from dataclasses import replace
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest
from report_page import Page

import nonhertz as nh
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.toml import parse
from nonhertz.report import CaseResults, count_steps, post_process, solve_all
from nonhertz.report.assumptions import Verdict, judge_assumptions
from nonhertz.report.differences import compare_inputs, result_rows
from nonhertz.report.downloads import collect_downloads
from nonhertz.report.inputs import collect_inputs
from nonhertz.report.layout import with_links
from nonhertz.report.method import describe_method
from nonhertz.report.overview import key_numbers, opening_sentence
from nonhertz.report.page import compose, to_html
from nonhertz.result.status import Status
from nonhertz.show.beside import beside
from nonhertz.show.lives import compared_section
from nonhertz.show.sections import Cell
from nonhertz.show.solving import solve_case

TITLE = "Roller & <script>alert('title')</script>"
POINTS = "y, relief\n" + "".join(f"{y}, {1e-5 * y**4}\n" for y in range(-7, 8))
CASE = f"""# <b>a comment</b>
title = "{TITLE}"
[body.a]
kind = "roller"
diameter = 15
length = 15
profile = [{{ kind = "tabulated", file = "points/a.csv" }}, {{ kind = "conical", angle = "0.1 mrad" }}]
[body.b]
kind = "ring"
diameter = 60
[load]
load = "4 kN"
[solver]
strips = 15
"""
PLAIN = (
    CASE.replace(TITLE, "Plain")
    .replace('{ kind = "tabulated", file = "points/a.csv" }', '{ kind = "iso-logarithmic" }')
    .replace("strips = 15", 'strips = "auto"')
)


def case_of(text: str, name: str = "case.toml") -> Case:
    return Case.of(parse(text, name), Path(name), text, files=False)


def found_in(text: str, name: str = "case.toml") -> CaseResults:
    (found,) = solve_all([case_of(text, name)])
    assert isinstance(found, CaseResults)
    return found


def numbers_of(found: CaseResults) -> dict[str, tuple[str, str]]:
    return {name: (value, remark) for name, value, remark in key_numbers(found)}


@pytest.fixture(scope="module")
def results_of_case(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    (folder / "points").mkdir()
    (folder / "points/a.csv").write_text(POINTS, encoding="utf-8")
    (folder / "roller.toml").write_text(CASE, encoding="utf-8")
    (found,) = post_process(solve_all([read_case(folder / "roller.toml")]))
    return found


@pytest.fixture(scope="module")
def text(results_of_case):
    return to_html([results_of_case])


@pytest.fixture(scope="module")
def page(text):
    return Page(text)


@pytest.fixture
def undrawn(monkeypatch):
    """Leave the figures out, which take the time."""
    monkeypatch.setattr("nonhertz.report.layout.image", lambda *_: b"<svg></svg>")


def test_it_loads_nothing_and_runs_nothing(text, page):
    tags = {tag for tag, _ in page.elements}
    assert not tags & {"script", "link", "iframe", "object", "embed", "base", "form"}
    for tag, attributes in page.elements:
        assert not [name for name in attributes if name.startswith("on")]
        for name in ("src", "href", "srcset", "xlink:href", "data", "poster"):
            value = attributes.get(name, "#")
            assert value.startswith(("#", "data:")) or (tag == "a" and value.startswith("https://")), (tag, value[:60])
    outside = re.findall(r"@import|url\((?!#)[^)]*\)|javascript:", unquote(text))
    assert outside == []


def test_what_a_user_writes_stays_text(text, page):
    assert TITLE in page.text
    assert "<script" not in text
    assert "<b>a comment" not in text


def test_each_figure_tells_a_screen_reader_what_it_is(page):
    drawn = [attributes for tag, attributes in page.elements if tag == "img"]
    assert len(drawn) == 5
    for each in drawn:
        kind, _, content = each["src"].partition(",")
        assert kind == "data:image/svg+xml"
        assert unquote(content).startswith("<?xml")
        assert len(content) < 200_000
    beginnings = ("Pressure on the centre line", "Contact area", "Distance of both", "Von Mises", "Von Mises")
    assert [each["alt"].startswith(begin) for each, begin in zip(drawn, beginnings, strict=True)] == [True] * 5
    # The caption is followed by what the figure shows, in numbers.
    assert all(re.search(r"\d (MPa|mm|µm)\b", each["alt"].partition(". ")[2]) for each in drawn)


def test_the_files_inside_solve_to_the_same_numbers(page, results_of_case, tmp_path):
    files = page.files()
    assert set(files) == {"roller.toml", "a.csv", "roller-table.csv", "roller-result.json", "roller-stress.json"}
    assert files["roller.toml"].decode() == CASE
    (tmp_path / "points").mkdir()
    (tmp_path / "points/a.csv").write_bytes(files["a.csv"])
    (tmp_path / "roller.toml").write_bytes(files["roller.toml"])
    again = solve_case(read_case(tmp_path / "roller.toml"))
    told = json.loads(files["roller-result.json"])
    assert (again.approach, again.centre_pressure.tolist()) == (told["approach"], told["centre_pressure"])
    assert files["roller-table.csv"].count(b"\n") == 16


def test_key_numbers_stand_first(results_of_case):
    shown = {name: float(value.split()[0]) for name, (value, _) in numbers_of(results_of_case).items()}
    assert shown["Maximum pressure"] == pytest.approx(results_of_case.solution.max_pressure, rel=5e-4)
    assert shown["Approach"] == pytest.approx(1e3 * results_of_case.solution.approach, rel=5e-4)
    assert results_of_case.stress is not None
    largest = results_of_case.stress[0].von_mises.max
    assert shown["von Mises stress"] == pytest.approx(largest, rel=5e-4)
    assert opening_sentence(results_of_case) == (
        "A roller (diameter 15 mm, length 15 mm, steel) and a ring (diameter 60 mm, steel) under a load of 4 kN."
    )


def test_inputs_have_value_unit_meaning_and_say_what_is_a_default():
    body, other, load, solver = collect_inputs(case_of(PLAIN))
    entries = {entry.place: entry for entry in (*body.entries, *other.entries, *load.entries, *solver.entries)}
    assert (entries["body.a.diameter"].value, entries["body.a.diameter"].unit) == ("15", "mm")
    assert not entries["body.a.diameter"].default
    assert (entries["body.b.length"].value, entries["body.b.length"].default) == ("unbounded", True)
    assert entries["body.a.depth"].value == "finite"
    assert entries["body.b.depth"].value == "none"
    assert (entries["load.load"].value, entries["load.load"].written) == ("4000", "4 kN")
    assert (entries["load.tilt"].value, entries["load.tilt"].default) == ("0", True)
    assert (entries["solver.strips"].value, entries["solver.strips"].default) == ("auto", False)
    assert all(entry.meaning for entry in entries.values())
    first, second = "body.a.profile[1].", "body.a.profile[2]."
    logarithmic = {place.removeprefix(first): entry.value for place, entry in entries.items() if first in place}
    assert logarithmic == {"kind": "iso-logarithmic", "diameter": "15", "length": "15"}
    remarks = [row[0].remark for row in body.rows if isinstance(row, tuple) and isinstance(row[0], Cell)]
    assert "ISO/TS 16281:2008" in remarks[0].partition("Source: ")[2]
    angle = entries[f"{second}angle"]
    assert (angle.value, angle.unit, angle.written) == ("0.0001", "rad", "0.1 mrad")


def told_of_steps(case: Case) -> dict[str, str]:
    """Return what a report says of each step of the only measured profile."""
    page = compose([case], stress=False)
    (part,) = re.findall(r"Preparation of roller.txt: body a, profile 1</h2>.*?<tbody>(.*?)</tbody>", page, re.DOTALL)
    return dict(re.findall(r'<th scope="row">(.*?)</th>\s*<td[^>]*>(.*?)</td>', part))


@pytest.mark.usefixtures("undrawn")
def test_what_was_done_to_a_measured_profile_is_told_and_drawn(tmp_path):
    # A crown of 500 mm that lies askew by 2 mrad and 4 mm off the middle of the trace.
    rows = (f"{y:.3f}\t{2.0 * y - (y - 4.0) ** 2:.4f}" for y in np.linspace(-1.0, 9.0, 401))
    (tmp_path / "roller.txt").write_text("\n".join(rows), encoding="utf-8")
    table = '{ kind = "measured", file = "roller.txt", height_unit = "um" }'
    case = f"[body.a]\ndiameter = 10\nlength = 10\nprofile = [{table}]\n[body.b]\n[load]\nload = 100\n"
    (tmp_path / "case.toml").write_text(case, encoding="utf-8")
    case = read_case(tmp_path / "case.toml")
    told = told_of_steps(case)
    assert list(told) == ["raw", "level", "align", "trim", "outliers", "smooth", "thin", "relief", "roughness"]
    assert told["level"].startswith("A tilt of 2 mrad was removed")
    assert told["align"].startswith("The middle of the body, 4 mm in the file, became y = 0")
    page = compose([case], stress=False)
    assert "Preparation of roller.txt" in page
    assert told["level"] in page
    assert "From the measured points of roller.txt to the profile, step by step." in page


STRAINED = {
    "coarse grid": ('strips = "auto"', "strips = 6", "Grid fine enough for the approach", Verdict.STRAINED),
    "sharp ends": ('{ kind = "iso-logarithmic" }, ', "", "Contact ends inside the bodies", Verdict.NOT_MET),
    "thin body": ("diameter = 60", "diameter = 60\ndepth = 0.3", "Body b is thick", Verdict.STRAINED),
    "wide half-width": ("4 kN", "1500 kN", "Half-spaces, parabolic separation across", Verdict.STRAINED),
}


@pytest.mark.parametrize("name", STRAINED)
def test_a_strained_assumption_is_one_that_the_solver_warns_of(name):
    old, new, assumption, verdict = STRAINED[name]
    changed = PLAIN.replace(old, new)
    assert changed != PLAIN
    found = found_in(changed)
    told = {each.name: each.verdict for each in judge_assumptions(found)}
    assert told[assumption] is verdict
    assert found.solution.warnings
    fine = found_in(PLAIN)
    assert fine.solution.warnings == ()
    assert {each.verdict for each in judge_assumptions(fine)} == {Verdict.HOLDS, Verdict.OPEN}


def test_references_become_links_and_stay_escaped():
    told = str(with_links("A & B, doi:10.1000/1.2; https://example.org/a.html, <i>."))
    assert '<a href="https://doi.org/10.1000/1.2" rel="noreferrer">doi:10.1000/1.2</a>;' in told
    assert '<a href="https://example.org/a.html" rel="noreferrer">https://example.org/a.html</a>,' in told
    assert told.startswith("A &amp; B")
    assert told.endswith("&lt;i&gt;.")


@pytest.mark.usefixtures("undrawn")
def test_two_cases_are_compared_by_what_differs():
    other = PLAIN.replace("4 kN", "8 kN").replace("diameter = 60", "diameter = 60\nposition = 0")
    pair = [case_of(PLAIN, "first.toml"), case_of(other, "second.toml")]
    # A default that is written down is no difference.
    differing, same, notes = compare_inputs([collect_inputs(each) for each in pair])
    assert differing == [("load", "4000 N", "8000 N")]
    assert notes == ["Not all results are comparable, since more than shapes differs: load."]
    assert {row[0]: row[1] for row in same}["body a, diameter"] == "15 mm"
    assert "body b, position" in {row[0] for row in same}
    assert "body a, side faces" not in {row[0] for row in same}
    found = solve_all(pair)
    rows = {name: cells for name, *cells in beside(result_rows(found), ["first", "second"]).rows}
    assert [cell.remark for cell in rows["load [kN]"]] == ["", "+100 %"]
    ratio = found[1].solution.max_pressure / found[0].solution.max_pressure
    change = float(rows["maximum pressure [MPa]"][1].remark.rstrip(" %"))
    assert change == pytest.approx(100.0 * (ratio - 1.0), rel=5e-3)  # three digits are told
    text = to_html(found)
    page = Page(text)
    assert "first and second compared" in page.text
    first, second = (f"{each.solution.max_pressure:.1f} MPa in {each.label}" for each in found)
    assert f"Maximum pressure: {first}, {second} ({change:+.3g} %)." in page.text
    assert notes[0] in page.text
    # Nothing of one case alone is shown before it is unfolded.
    assert text.count("<figure") == 1
    before, *folded = text.split("<summary>Assumptions, inputs, method and files of ")
    assert [each.count("<caption>Body a</caption>") for each in (before, *folded)] == [0, 1, 1]
    assert {"first.toml", "second.toml", "second-table.csv"} <= set(page.files())
    assert len(page.values("id")) == len(set(page.values("id")))


@pytest.mark.parametrize(
    ("names", "told"),
    [
        (("a.toml", "b.toml"), ["a", "b"]),
        (("x/a.toml", "y/a.toml"), ["x/a", "y/a"]),
        (("a.toml", "a.toml"), ["a (1)", "a (2)"]),
    ],
    ids=["names", "folders", "numbers"],
)
def test_cases_of_one_title_are_told_apart(names, told):
    cases = [case_of(PLAIN, name) for name in names]
    assert [each.label for each in solve_all(cases)] == told


def test_lives_are_told_where_the_case_asks_and_compared():
    asked = PLAIN + '[life]\nmodels = ["iso-16281"]\n'
    pair = solve_all([case_of(asked, "a.toml"), case_of(asked.replace("4 kN", "2 kN"), "b.toml")])
    assert [count_steps(pair, life=life, stress=False) for life in (None, True, False)] == [4, 4, 0]
    assert count_steps([found_in(PLAIN)], stress=True) == 2
    announced: list[str] = []
    found = post_process(pair, stress=False, announce=announced.append)
    assert len(announced) == 4
    assert found[0].lives is not None
    row_a, _ = compared_section([(each.label, each.lives) for each in found]).blocks[0].rows
    ratio = found[1].lives.over(found[0].lives, "a", 0) if found[1].lives else 0.0
    assert float(row_a[2].remark.lstrip("× ")) == pytest.approx(ratio, rel=1e-3)
    assert ratio > 5.0  # half the load lives longer by a power of about 4 and what the edges add
    assert "a-life.json" in {each.name for each in collect_downloads(found[0])}
    assert any("ISO/TS 16281" in each for each in describe_method(found[0])[1])
    assert post_process(pair, life=False, stress=False)[0].lives is None


@pytest.mark.usefixtures("undrawn")
def test_a_case_that_has_not_converged_is_told_as_such(results_of_case):
    without_points = copy.copy(results_of_case.case)
    object.__setattr__(without_points, "origin", replace(without_points.origin, folder=None))
    stopped = replace(
        results_of_case,
        case=without_points,
        solution=replace(results_of_case.solution, status=Status.STAGNATED),
        complaint="It stopped.",
        stress=None,
    )
    (found,) = post_process([stopped], life=True)
    assert found.stress is found.lives is None
    assert judge_assumptions(found)[0].verdict is Verdict.NOT_MET
    page = Page(to_html([found]))
    assert "Not solved. It stopped." in page.text
    assert "stagnated" in page.text
    # Nor are the points there, as where they are too many.
    assert "points/a.csv is named in the case file, but not included here" in page.text


def test_what_the_solver_refuses_is_named_by_its_file():
    never = PLAIN.replace('load = "4 kN"', "approach = -1.0")
    with pytest.raises(CaseError) as caught:
        compose([case_of(never, "a.toml"), case_of(PLAIN, "b.toml"), case_of(never, "c.toml")])
    assert [mistake.partition(":")[0] for mistake in caught.value.mistakes] == ["a.toml", "c.toml"]
    with pytest.raises(CaseError, match=r"^load\.approach = -1\.0 must "):
        compose([case_of(never)])


def test_files_that_are_too_large_are_left_out(tmp_path, monkeypatch):
    monkeypatch.setattr("nonhertz.files.document.MOST_ATTACHED", 10)
    (tmp_path / "points").mkdir()
    (tmp_path / "points/a.csv").write_text(POINTS, encoding="utf-8")
    (tmp_path / "roller.toml").write_text(CASE, encoding="utf-8")
    found = read_case(tmp_path / "roller.toml")
    assert found.origin.files == ("points/a.csv",)
    assert found.attachments == {}


@pytest.mark.usefixtures("undrawn")
def test_a_case_that_was_made_in_python_has_a_report_and_a_file_of_its_own():
    roller = nh.Roller(diameter=10, length=10, profile=nh.profile.crown(radius=500))
    case = nh.Case(nh.Contact(roller, nh.Plate()), {"load": 300.0}, title="Made in Python")
    page = Page(compose([case], stress=False))
    assert "Made in Python" in page.text
    again = case_of(page.files()["case.toml"].decode())
    assert again == case


def test_a_changed_copy_of_a_case_does_not_carry_the_text_of_the_case_it_was_made_from():
    case = case_of(PLAIN)
    heavier = replace(case, prescribed={"load": 8e3})
    assert case.text == PLAIN
    assert "load = 8000.0" in heavier.text
    assert case_of(heavier.text) == heavier


def test_a_case_that_no_file_can_hold_is_refused_before_it_is_solved(monkeypatch):
    class Own(nh.profile.Profile):
        def relief(self, y: np.ndarray) -> np.ndarray:
            return 0.0 * np.asarray(y)

    roller = nh.Roller(diameter=10, length=10, profile=Own())
    monkeypatch.setattr("nonhertz.report.results.try_solve", lambda _: pytest.fail("it was solved"))
    with pytest.raises(nh.InputError, match=r"^body\.a\.profile = 'Own' must be from the catalogue"):
        compose([nh.Case(nh.Contact(roller, nh.Plate()), {"load": 300.0})])


def test_without_strengths_the_report_leaves_the_question_open(results_of_case):
    (only,) = results_of_case.strengths
    assert only.body == "a"
    shown = {each.name: each for each in judge_assumptions(results_of_case)}
    assert shown["Linear elastic below the surface of body a"].verdict is Verdict.OPEN


@pytest.mark.slow
def test_whether_both_bodies_bear_it_is_told():
    strong = "material = { modulus = 207000, poisson = 0.3, yield_strength = 1500 }"
    text = PLAIN.replace("[body.b]", f"{strong}\n[body.b]\n{strong.replace('1500', '100')}")
    (found,) = post_process(solve_all([case_of(text)]))
    shown = {each.name: each.verdict for each in judge_assumptions(found)}
    told = [shown[f"Linear elastic below the surface of body {body}"] for body in "ab"]
    assert told == [Verdict.HOLDS, Verdict.NOT_MET]
