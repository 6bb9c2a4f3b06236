"""``nonhertz report`` of whole bearings: what the page says, what is in it, and what is refused."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from few_rollers import PAIR, SIX, changed
from report_page import Page

import nonhertz as nh
import nonhertz.report.layout
from nonhertz.cli import main
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.toml import parse
from nonhertz.report import MARK, BearingResults, compose, post_process, solve_all, to_html
from nonhertz.report.assumptions import Verdict, judge_assumptions
from nonhertz.report.differences import result_rows
from nonhertz.report.inputs import collect_inputs
from nonhertz.report.method import describe_method
from nonhertz.report.overview import derived_quantities, key_numbers
from nonhertz.show.beside import beside
from nonhertz.verdict import Level

CROWN = '{ kind = "crown", radius = 1200 }'
PLAIN = changed(SIX, ('"six"', '"Six & <b>few</b>"')) + 'speed = "1500 rpm"\n'
FEW = changed(PLAIN, (CROWN, '{ kind = "tabulated", file = "points/crown.csv" }'))
POINTS = "y, relief\n" + "".join(f"{y}, {y**2 / 2400.0}\n" for y in range(-5, 6))
SLICES = '[solver]\nmethod = "slices"\n'
CASE = """
[body.a]
kind = "roller"
diameter = 20
length = 20
[body.b]
kind = "plate"
[load]
load = "6 kN"
"""
RIB = "rib = { end_radius = 140, height = 4.8 }"
TAPERED = changed(PAIR, ('"pair"', '"Pair"'), ("pair = ", f"{RIB}\npair = "))


def case_of(text: str, name: str = "bearing.toml") -> BearingCase:
    return BearingCase.of(parse(text, name), Path(name), text, files=False)


def numbers_of(found: BearingResults) -> dict[str, tuple[str, str]]:
    return {name: (value, remark) for name, value, remark in key_numbers(found)}


def found_in(text: str, *, compare: bool = False) -> BearingResults:
    (found,) = post_process(solve_all([case_of(text)]), compare=compare)
    return found


@pytest.fixture(scope="module")
def few():
    return found_in(PLAIN)


@pytest.fixture(scope="module")
def pair():
    return found_in(TAPERED)


@pytest.fixture
def undrawn(monkeypatch):
    monkeypatch.setattr(nonhertz.report.layout, "image", lambda *_: b"<svg></svg>")


@pytest.fixture
def folder(tmp_path, monkeypatch, undrawn):
    monkeypatch.chdir(tmp_path)
    Path("points").mkdir()
    Path("points/crown.csv").write_text(POINTS, encoding="utf-8")
    for name, text in (("few", FEW), ("sliced", PLAIN + SLICES), ("case", CASE)):
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return tmp_path


def refused(words: list[str], run) -> str:
    printed = run("report", *words, code=2)
    assert printed.out == ""
    assert not list(Path().glob("*.html"))
    (line,) = printed.err.splitlines()
    return line


# The file


def test_a_bearing_file_becomes_one_page_with_its_files(folder, run):
    assert run("report", "few.toml").out == "wrote few-report.html\n"
    text = Path("few-report.html").read_text(encoding="utf-8")
    assert MARK in text[:500]
    page = Page(text)
    assert "<b>few</b>" not in text
    assert not re.search(r'<script|<link|<img src="(?!data:)|url\((?!#)', text)
    assert set(page.files()) == {"few.toml", "crown.csv", "few-rollers.csv", "few-result.json"}
    headings = re.findall(r"<h[23][^>]*>([^<]*)<", text)
    assert headings == [
        "Results", "Ratings and life", "Film, friction and frequencies", "Manufacturers&#39; limits", "All rollers",
        "Inputs", "Assumptions and whether they hold", "Method", "References", "Files",
    ]  # fmt: skip
    assert text.count('<th scope="row">material</th>') == 1, "all bodies are of one material, said once"
    identifiers = [attributes["id"] for _, attributes in page.elements if "id" in attributes]
    assert len(identifiers) == len(set(identifiers)) > 4


def test_the_files_inside_solve_to_the_same_numbers(folder, tmp_path):
    assert main(["report", "few.toml"]) == 0
    files = Page(Path("few-report.html").read_text(encoding="utf-8")).files()
    (tmp_path / "again" / "points").mkdir(parents=True)
    (tmp_path / "again" / "few.toml").write_bytes(files["few.toml"])
    (tmp_path / "again" / "points" / "crown.csv").write_bytes(files["crown.csv"])
    solved = read_bearing(tmp_path / "again" / "few.toml").solve()
    assert json.loads(files["few-result.json"])["load"] == solved.load.tolist()
    assert len(files["few-rollers.csv"].splitlines()) == 1 + solved.angle.size


def test_references_are_those_of_what_was_used(folder):
    """Classes name their standards; nothing is said of standards, makers and films that have no part in it."""
    example = Path(__file__).parents[2] / "examples" / "nu206-classes.toml"
    with_classes, plain = describe_method(found_in(example.read_text("utf-8")))[1], describe_method(found_in(PLAIN))[1]
    for standard in ("ISO 286-1:2010", "ISO 492:2014", "ISO 5753-1:2009", "NTN", "Pan, B. J. Hamrock"):
        assert any(standard in each for each in with_classes)
        assert not any(standard in each for each in plain)
    assert not any("ZKL" in each or "point contacts" in each for each in with_classes)


def test_mixed_lists_are_refused_in_a_sentence(folder, run):
    line = refused(["case.toml", "few.toml"], run)
    assert line == (
        "CASE = 'case.toml and few.toml' must be all case files or all bearing files: make two reports, one of "
        "each kind."
    )
    with pytest.raises(nh.InputError, match="must be all case files or all bearing files"):
        compose([nh.read_case("case.toml"), read_bearing("few.toml")])


def test_strips_are_compared_with_slices_for_bearings_alone(folder, run):
    line = refused(["case.toml", "--compare"], run)
    assert line.startswith("--compare = 'case.toml' must be used with bearing files: use 'nonhertz compare case.toml'")
    assert main(["report", "few.toml", "--compare"]) == 0
    text = Path("few-report.html").read_text(encoding="utf-8")
    assert "Strips compared with slices" in text
    assert text.count("</b> Loads of all rollers around the") == 1, "a figure stands in one section"
    assert {"few-comparison.json", "few-comparison.csv"} <= set(Page(text).files())


def test_a_bearing_without_balance_is_reported_as_such(folder, monkeypatch, run):
    def stop(*_: object, **__: object) -> None:
        raise nh.ConvergenceError("No balance.", None)

    monkeypatch.setattr("nonhertz.bearing.verb.solve", stop)
    printed = run("report", "few.toml", code=1)
    assert (printed.out, printed.err) == ("wrote few-report.html\n", "few: No balance.\n")
    text = Path("few-report.html").read_text(encoding="utf-8")
    assert "No balance." in text
    assert "not met" in text
    assert set(Page(text).files()) == {"few.toml", "crown.csv"}
    assert main(["report", "few.toml", "sliced.toml", "--out", "two.html"]) == 1


# What it says


def test_key_numbers_are_those_of_the_solution(few):
    shown = numbers_of(few)
    solution = few.solution
    value, where = shown["Maximum pressure"]
    assert float(value.split()[0]) == pytest.approx(solution.max_pressure.max(), rel=5e-4)
    assert where == "roller 1, inner ring"
    value, where = shown["Largest roller load"]
    assert float(value.removesuffix(" kN")) == pytest.approx(1e-3 * solution.load[0].max(), rel=5e-4)
    assert where == "roller 1 at 0.0°"
    # One of them bears what a force towards it alone leaves to the neighbours, which are 60 degrees off.
    loaded = np.flatnonzero(solution.load[:, 0])
    assert shown["Loaded rollers"][0] == f"{loaded.size} of 6"
    moved = float(shown["Displacement"][0].removesuffix(" µm"))
    assert moved == pytest.approx(1e3 * np.hypot(*solution.displacement[1:3]), rel=5e-4)
    # They reach the sharp ends of the rollers.
    assert shown["Rated life"][0] == "–"
    rounded = found_in(PLAIN.replace("length = 10.0", "length = 10.0\ncorner_radius = 0.3"))
    hours = rounded.life.reference_life * 1e6 / (60.0 * 1500.0)
    value, remark = numbers_of(rounded)["Rated life"]
    assert float(value.split()[0]) == pytest.approx(hours, rel=1e-3)
    assert remark.endswith("give viscosity and cleanliness for the modified life")


def test_geometry_follows_from_the_dimensions(few, pair):
    rows = dict(derived_quantities(few))
    # Six on a circle: neighbours are half a pitch diameter apart.
    assert float(rows["distance between neighbouring rollers"].removesuffix(" mm")) == pytest.approx(
        46.5 / 2.0 - 9.0, rel=1e-3
    )
    assert float(rows["combined radius across, inner ring"].removesuffix(" mm")) == pytest.approx(
        1.0 / (2 / 9 + 2 / 37.5), rel=1e-4
    )
    assert float(rows["combined radius across, outer ring"].removesuffix(" mm")) == pytest.approx(
        1.0 / (2 / 9 - 2 / 55.5), rel=1e-4
    )
    # Steel of 7.85 g/cm3.
    assert float(rows["mass of a roller"].removesuffix(" g")) == pytest.approx(
        np.pi / 4 * 0.9**2 * 1.0 * 7.85, rel=1e-3
    )
    rows = dict(derived_quantities(pair))
    inner, outer = map(float, rows["contact angles at inner and outer ring"].removesuffix(" degrees").split(" and "))
    cone = 2.0 * np.degrees(np.arctan(0.5 * 0.82 / 11.6))
    assert (outer, inner) == pytest.approx((12.0, 12.0 - cone), abs=1e-3)
    assert rows["rows at x ="] == "-10 and 10 mm"


def test_a_fit_and_a_shape_are_among_the_inputs_and_the_clearance_is_told(undrawn):
    fit = '[fit.shaft]\ndiameter = 30\ninterference = "10 um"\n[fit.housing]\ndiameter = 62\n'
    shape = '\nouter_shape = { terms = [{ waves = 2, amplitude = "4 um" }] }'
    found = found_in(PLAIN.replace("rollers = 6", f"rollers = 6{shape}") + fit)
    entries = {entry.place: entry for group in collect_inputs(found.case) for entry in group.entries}
    assert (entries["fit.shaft.interference"].value, entries["fit.shaft.interference"].unit) == ("10", "µm")
    assert "waves = 2" in entries["bearing.outer_shape"].value
    # NSK: a raceway grows by d / F of the interference on a solid shaft.
    (left,) = re.findall(r"([\d.]+) µm radial, in operation", Page(to_html([found])).text)
    assert float(left) == pytest.approx(12.0 - 10.0 * 30.0 / 37.5, abs=0.005)  # the speed takes little
    rows = {row.name: row for row in judge_assumptions(found)}
    assert rows["Rings keep their shape"].number == "outer ring with a shape"


# Assumptions


def test_what_is_neglected_is_named_and_not_judged(few):
    rows = {row.name: row for row in judge_assumptions(few)}
    neglected = {
        "Rollers do not skew",
        "No friction, no film",
        "Rings keep their shape",
        "Equally spaced rollers",
        "Surfaces",
    }
    assert neglected <= set(rows)
    assert {rows[name].verdict for name in neglected} == {Verdict.OPEN}
    assert rows["Rollers and rings in equilibrium"].verdict is Verdict.HOLDS
    assert rows["Contact angles do not change"].number == "0.2000 mrad"
    # Von Mises, 0.558 p0 at 0.70 half-widths below a line contact.
    assert f"{few.solution.max_pressure.max() * 0.5577:.0f}" in rows["Linear elastic bodies"].remark


def test_a_strained_contact_is_found_wherever_it_is():
    """Crowns as sharp as the rollers are round make contacts that are wider than long, at the outer ring first."""
    found = found_in(PLAIN.replace("radius = 1200", "radius = 4.3").replace("5 kN", "100 N"))
    rows = {row.name: row for row in judge_assumptions(found)}
    wide = rows["Strips across a contact that is long"]
    assert wide.verdict is Verdict.STRAINED
    inner, outer = map(float, re.findall(r"([\d.]+) at the", wide.number))
    for ratio, across in ((inner, 1.0 / (2 / 9 + 2 / 37.5)), (outer, 1.0 / (2 / 9 - 2 / 55.5))):
        ellipse = nh.hertz.point_contact(load=1.0, radius_x=across, radius_y=4.3, compliance=1e-5)
        # Strips are not made for round contacts.
        assert ratio == pytest.approx(ellipse.half_width / ellipse.half_length, rel=0.05)
    assert any("wider than long" in warning and "outer ring" in warning for warning in found.warnings)


def test_too_high_a_pressure_and_too_large_a_tilt_are_told(few):
    hardened = re.sub(r"(?m)^(\[(roller|inner|outer)\])$", r'\1\nmaterial = "100Cr6"', PLAIN)
    found = found_in(hardened.replace("5 kN", "60 kN").replace("0.2 mrad", "0 mrad"))
    assert found.solution.max_pressure.max() > 4000.0
    assert (found.verdict.level, few.verdict.level is Level.NOT_MET) == (Level.NOT_MET, False)
    rows = {row.name: row for row in judge_assumptions(found)}
    assert rows["Contact angles do not change"].verdict is Verdict.HOLDS
    tilted = found_in(PLAIN.replace("0.2 mrad", "11 mrad") + SLICES)
    rows = {row.name: row for row in judge_assumptions(tilted)}
    assert rows["Contact angles do not change"].verdict is Verdict.STRAINED


def test_ribs_are_judged_by_the_edge_that_the_ellipse_reaches(pair):
    (rib,) = [row for row in judge_assumptions(pair) if row.name.startswith("Ellipse on the ribs")]
    ellipse = max(
        (pair.solution.rib_contact(j) for j in range(12)), key=lambda each: 0.0 if each is None else each.load
    )
    assert float(rib.number.split(" mm")[0]) == pytest.approx(ellipse.half_length, rel=5e-3)
    edge = float(re.search(r"([\d.]+) mm away", rib.criterion)[1])
    assert rib.verdict is (Verdict.STRAINED if ellipse.half_length > edge else Verdict.HOLDS)
    assert "bearing.rib.edge" in rib.remark
    guessed = found_in(TAPERED.replace("rib = { end_radius = 140, height = 4.8 }\n", ""))
    (rib,) = [row for row in judge_assumptions(guessed) if row.name.startswith("Ellipse on the ribs")]
    assert "is a guess" in rib.remark


# Several


@pytest.mark.slow
def test_several_bearings_are_compared_with_the_first():
    found = post_process(solve_all([case_of(PLAIN), case_of(PLAIN.replace("12 um", "30 um").replace("five", "six"))]))
    rows = {name: cells for name, *cells in beside(result_rows(found), ["a", "b"]).rows}
    loads = [each.solution.load.max() for each in found]
    change = float(rows["largest load of a contact [kN]"][1].remark.rstrip(" %"))
    assert change == pytest.approx(100.0 * (loads[1] / loads[0] - 1.0), rel=5e-3)  # three digits are shown
    for k, ring in enumerate(("inner", "outer")):
        shown = [float(cell.text) for cell in rows[f"maximum pressure at the {ring} ring [MPa]"]]
        assert shown == pytest.approx([each.solution.max_pressure[:, k].max() for each in found], rel=1e-4)


def test_classes_in_place_of_numbers_are_among_the_inputs():
    classes = changed(PLAIN, ('kind = "cylindrical"', 'kind = "cylindrical"\nbore = 30\noutside_diameter = 62'))
    case = case_of(classes + '[fit]\nshaft = "k5"\nhousing = { fit = "J7", temperature = 40 }\n')
    entries = {entry.place: entry for group in collect_inputs(case) for entry in group.entries}
    assert (entries["fit.shaft.fit"].value_with_unit, entries["fit.shaft.fit"].written) == ("k5", "")
    assert entries["fit.housing.fit"].value_with_unit == "J7"
    assert entries["fit.housing.temperature"].value_with_unit.startswith("40")
