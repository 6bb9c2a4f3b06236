"""What the page is told of a case: the numbers of the solver, the sentences of the command line."""

import copy
import json
import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
from changed_documents import changed_documents
from few_rollers import SIX
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from test_bad_input import MISTAKES

import nonhertz as nh
from nonhertz.amounts import display_units
from nonhertz.files.casefile import Case
from nonhertz.files.starting import starting_case
from nonhertz.strength import assess
from nonhertz.subsurface import extremes
from nonhertz.web import limits
from nonhertz.web.view import curves, jobs

STARTING = tomllib.loads(starting_case())


def answer(document, stress=False, body="a"):
    return json.loads(jobs.solve(document, stress, body))


def changed(**tables):
    document = copy.deepcopy(STARTING)
    for names, value in tables.items():
        *way, last = names.split("__")
        table = document
        for name in way:
            table = table.setdefault(name, {})
        if value is None:
            del table[last]
        else:
            table[last] = value
    return document


def solution_of(document):
    case = Case.of(document, Path("case.toml"))
    return nh.solve(case.contact, **case.prescribed.keywords, **case.solver.keywords)


def lines_of(answer):
    """Return the lines of pressure and half-width."""
    panels = answer["figures"]["pressure"]["panels"]
    return [next(mark for mark in panel["marks"] if mark["kind"] == "line") for panel in panels]


def tile(answer, name):
    """Return one of the numbers on top."""
    return next(each for each in answer["numbers"] if each["name"] == name)


def test_numbers_are_those_of_the_solver():
    found, solution = answer(STARTING), solution_of(STARTING)
    assert found["ok"]
    assert found["title"] == STARTING["title"]
    assert (found["status"], found["complaint"]) == ("converged", "")
    # The same solver on the same machine: all digits.
    assert found["key"]["approach"] == solution.approach
    assert found["key"]["max_pressure"] == tile(found, "Maximum pressure")["number"] == solution.max_pressure
    assert tile(found, "Half-width")["where"] == "largest"
    pressed = solution.line_load > 0.0
    pressure, half_width = lines_of(found)
    assert pressure["y"][1:-1] == solution.centre_pressure[pressed].tolist()
    assert half_width["y"][1:-1] == solution.half_width[pressed].tolist()
    assert pressure["x"][1:-1] == half_width["x"][1:-1] == solution.y[pressed].tolist()
    assert "planes" not in found


def test_lines_end_at_zero():
    sharp = changed(body__a__profile=[])
    for document in (STARTING, sharp):
        for line in lines_of(answer(document)):
            assert (line["y"][0], line["y"][-1]) == (0.0, 0.0)
            assert len(line["y"]) == len(line["x"])
            assert line["x"] == sorted(line["x"])
    assert line["y"][1] > 0.0, "a sharp end is cut off upright"


def test_the_gap_closes_where_the_bodies_touch():
    found, solution = answer(STARTING), solution_of(STARTING)
    touching = solution.line_load > 0.0
    # The solver is content with a residual of 1e-11 of the approach, here 30 um.
    (panel,) = found["figures"]["distance"]["panels"]
    undeformed, deformed = (mark["y"] for mark in panel["marks"] if mark["kind"] == "line")
    assert_allclose(np.array(deformed)[touching], 0.0, atol=1e-12)
    # -(approach + tilt y - separation); two roundings.
    y = solution.y
    before = solution.contact.separation(y) - solution.approach - solution.tilt * y
    assert_allclose(undeformed, before, rtol=1e-9)
    low, high = panel["upright"]["range"]
    assert low < before.min() < 0.0 < high


def profile_drawn(found, body):
    """Return the line of the profile of a body, and the panel that it is in."""
    (panel,) = found["profiles"][body]["panels"]
    (line,) = (mark for mark in panel["marks"] if mark["kind"] == "line")
    return line, panel


def test_the_profile_is_the_relief_of_each_body():
    found = answer(changed(body__b__position=3.0))
    (a, panel), (b, _) = (profile_drawn(found, body) for body in "ab")
    relief = nh.profile.logarithmic(amplitude=0.005, length=20.0, fraction=0.9999).relief(np.array(a["x"]))
    assert_allclose(a["y"], relief, rtol=1e-12)
    assert (a["x"][0], a["x"][-1]) == (-10.0, 10.0)
    assert (b["x"][0], b["x"][-1]) == (-7.0, 13.0), "a body without ends is drawn about its middle"
    assert set(b["y"]) == {0.0}
    assert (panel["name"], panel["upright"]["title"]) == ("profile-a", "Relief [µm]")
    assert panel["description"].startswith("Profile of body a: relief up to ")


def test_a_profile_is_drawn_to_the_scale_of_its_land():
    crown = [{"kind": "crown", "radius": 2000.0}]
    _, panel = profile_drawn(answer(changed(body__a__profile=crown, body__a__corner_radius=0.5)), "a")
    low, high = panel["upright"]["range"]
    at_the_end_of_the_land = 9.5**2 / 4000.0
    assert at_the_end_of_the_land < low < 1.3 * at_the_end_of_the_land, "the corner goes down 500 um"
    assert high < 0.0
    # 9.5^2 / 4000 mm, the corner's 0.5 mm, and 0.5 mm along the tangent of the crown.
    assert panel["remark"] == "axis cut, ends down to 525 µm"
    _, panel = profile_drawn(answer(STARTING), "a")
    assert 0.010 < panel["upright"]["range"][0] < 0.060, "a logarithm is cut at its ends"


def test_a_table_that_holds_corners_is_drawn_to_the_scale_of_what_lies_between():
    y = np.linspace(-10.0, 10.0, 401)
    relief = y**2 / 20000.0 + np.maximum(np.abs(y) - 9.8, 0.0)
    table = [{"kind": "tabulated", "y": y.tolist(), "relief": relief.tolist()}]
    _, panel = profile_drawn(answer(changed(body__a__profile=table)), "a")
    # Twice the relief at 96 % of the length, and an eighth of that beside; the corners go down 205 um.
    assert panel["upright"]["range"][0] == pytest.approx(2.0 * 1.12 * 9.6**2 / 20000.0, rel=0.02)


@pytest.mark.parametrize("body", ["a", "b"])
def test_stress_is_that_of_the_search(body):
    found, solution = answer(STARTING, True, body), solution_of(STARTING)
    fields = {}
    for name, plane in found["planes"].items():
        (fields[name],) = (mark for mark in plane["panels"][0]["marks"] if mark["kind"] == "contours")
        assert np.shape(fields[name]["values"]) == (len(fields[name]["x"]), len(fields[name]["y"]))
    section = fields["section"]
    assert_allclose(section["values"], section["values"][::-1], rtol=0, atol=0)
    searched = extremes(solution, solution.max_pressure_y, body=body).von_mises
    # A net of five between neighbours: a quarter of a mesh off a maximum that is flat.
    assert_allclose(found["stress"]["number"], searched.max, rtol=2e-3)
    (dot,) = (mark for mark in found["planes"]["section"]["panels"][0]["marks"] if mark["kind"] == "points")
    assert_allclose(dot["y"], [searched.z], rtol=0.1)
    # A drawing is rounded to a hundred-thousandth of the largest, and its net misses the largest by a hundredth.
    assert_allclose(np.max(section["values"]), searched.max, rtol=1e-2)


@pytest.mark.slow
def test_what_a_body_bears_is_said_as_everywhere():
    steel = {"modulus": 2.07e5, "poisson": 0.3, "yield_strength": 1000.0, "pressure_limit": 4000.0}
    document = changed(body__b__material=steel, body__b__case_depth=0.1, solver__strips=21)
    answer = json.loads(jobs.strength(document, "b"))
    strength = assess(solution_of(document), body="b")
    found = [(each["sentence"], each["verdict"]) for each in answer["checks"]]
    assert found == [(check.sentence, check.verdict) for check in strength.checks]
    assert {verdict for _, verdict in found} >= {"fine", "over"}
    assert answer["stress"]["number"] == strength.largest.von_mises.max


def test_stress_that_takes_too_long_is_left_out_with_a_sentence():
    document = changed(body__a__images=limits.IMAGES, solver__strips=200)
    found = answer(document, True)
    assert found["ok"]
    assert "planes" not in found
    assert "nonhertz stress" in found["stress_note"]


def test_singular_ends_are_told_and_scale_without_them():
    found = answer(changed(body__a__profile=[], body__a__side_faces="none", load__tilt=0.0))
    assert "away from singular ends" in tile(found, "Half-width")["where"]
    assert 0.0 < found["key"]["max_pressure"] < 0.5 * max(lines_of(found)[0]["y"])
    assert "away from singular ends" in tile(found, "Maximum pressure")["where"]


def test_an_unconverged_solve_is_shown_with_its_complaint(monkeypatch):
    # Under less than the least load, which is refused first, the loop fails.
    monkeypatch.setattr("nonhertz.model.prescription.LEAST", 0.0)
    found = answer(changed(load__load=1e-300), True)
    assert found["ok"]
    assert found["status"] != "converged"
    assert found["complaint"].startswith("The iterations")
    assert "planes" not in found
    assert found["figures"]["distance"]["panels"][0]["marks"]


@pytest.mark.parametrize("text", [MISTAKES[0][0], MISTAKES[-1][0]])
def test_mistakes_are_those_of_the_command_line(text, tmp_path, run):
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    printed = [line.partition(". ")[2] for line in run("check", str(path), code=2).out.splitlines()]
    assert [mistake["sentence"] for mistake in answer(tomllib.loads(text))["mistakes"]] == printed


def test_mistakes_stand_at_their_fields():
    document = changed(
        body__a__profile=[{"kind": "crown", "radius": "4 kN"}],
        body__b__side_faces=["mirror", "glass"],
        load__load=-1.0,
        life={"models": ["weibul"]},
    )
    paths = [mistake["path"] for mistake in answer(document)["mistakes"]]
    assert paths == ["body.a.profile[1].radius", "body.b.side_faces[2]", "load.load", "life.models[1]"]


def test_what_the_solver_refuses_stands_at_its_field():
    found = answer(changed(load__load=None, load__approach=-0.01))
    assert [mistake["path"] for mistake in found["mistakes"]] == ["load.approach"]
    found = answer(changed(body__a__depth=0.01))
    assert [mistake["path"] for mistake in found["mistakes"]] == ["body.a.depth"]
    found = answer(changed(body__a__profile=[{"kind": "crown", "radius": 1e-9}]))
    assert [mistake["path"] for mistake in found["mistakes"]] == ["body.a.profile"]


@pytest.mark.parametrize("document", [{}, {"body": 3}, {"body": {"a": []}}, {"": {}}, {"load": {"load": True}}])
def test_what_is_hardly_a_case_is_answered(document):
    found = answer(document, True)
    assert not found["ok"]
    assert found["mistakes"]


@pytest.mark.slow
@settings(deadline=None, suppress_health_check=list(HealthCheck))
@given(changed_documents(changed(solver__strips=15)), st.booleans())
def test_whatever_is_in_a_case_it_is_answered(document, in_us_units):
    with display_units("us" if in_us_units else "si"):
        assert_answered(answer(document))


@pytest.mark.slow
@settings(deadline=None, suppress_health_check=list(HealthCheck))
@given(changed_documents(tomllib.loads(SIX)))
def test_whatever_is_in_a_bearing_it_is_answered(document):
    assert_answered(json.loads(jobs.load(document, "slices")))


def assert_answered(found):
    """Assert that what is asked is answered, or refused in sentences that each are one line."""
    assert found["ok"] or found["mistakes"]
    assert not found.get("internal")
    for mistake in found.get("mistakes", ()):
        assert mistake["sentence"].endswith((".", "?"))
        assert len(mistake["sentence"].splitlines()) == 1


def test_files_are_not_read(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("-10, 0\n10, 0\n")
    for kind in ("tabulated", "measured"):
        for table in ([{"kind": kind, "file": str(path)}], {"kind": kind, "file": str(path)}):
            found = answer(changed(body__a__profile=table))
            assert [mistake["path"].rpartition(".")[2] for mistake in found["mistakes"]] == ["file"]
            assert "not be read here" in found["mistakes"][0]["sentence"]


EXCESSES = {
    "solver.strips": (changed(solver__strips=2000), "solver.strips = 2000 must be at most 300 on the page: "),
    "body.b.images": (changed(body__b__images=100), "body.b.images = 100 must be at most 10 on the page: "),
    "body.a.profile": (changed(body__a__profile=[{"kind": "straight"}] * 21), "must have at most 20 profiles"),
    "life.spectrum": (changed(life={"spectrum": [{"load": 1, "share": 1}] * 31}), "must have at most 30 rows"),
    "body.a.profile[1].y": (
        changed(body__a__profile=[{"kind": "tabulated", "y": list(range(2001)), "relief": [0, 1]}]),
        "must have at most 2000 entries",
    ),
    "load": (changed(load={f"k{n}": n for n in range(41)}), "must have at most 40 keys"),
    "load.tilt": (changed(load={"load": 1.0, "tilt": None}), "load.tilt must be a number"),
    "life.models[2]": (changed(life={"models": ["weibull", None]}), "life.models[2] must be a number"),
}


@pytest.mark.parametrize("path", EXCESSES)
def test_what_is_more_than_the_page_takes_is_refused_at_its_field(path):
    document, words = EXCESSES[path]
    found = answer(document)
    assert [mistake["path"] for mistake in found["mistakes"]] == [path]
    assert words in found["mistakes"][0]["sentence"]


def test_all_numbers_are_json():
    for document in (STARTING, changed(body__a__profile=[]), changed(load__load=1e-300), changed(body__a__length=None)):
        text = jobs.solve(document, True, "a").decode()
        assert all(math.isfinite(number) for number in numbers_in(json.loads(text, parse_constant=pytest.fail)))


def numbers_in(value):
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        for entry in value:
            yield from numbers_in(entry)
    elif isinstance(value, float):
        yield value


def test_the_how_to_tells_the_limits():
    page = Path(__file__).parents[2].joinpath("docs", "how-to", "page.md")
    text = " ".join(page.read_text(encoding="utf-8").split())
    assert (
        f"at most {limits.STRIPS} strips, {limits.IMAGES} images per face, {limits.PROFILES} profiles per body, "
        f"{limits.POINTS} points per list"
    ) in text
    assert f"a case, a bearing or a search that takes longer than {limits.ANSWER_SECONDS:g} s is abandoned" in text
    assert f"uploaded, {limits.UPLOAD_BYTES // 2**20} MB at most" in text
    assert f"more than {limits.UPLOAD_POINTS:,} points, neighbours are averaged" in text


def curve(document, path, values):
    """Return a whole curve, which the page asks for piece by piece if there is no time for it at once."""
    found = json.loads(curves.curve(document, path, values))
    while found["ok"] and len(found["points"]) < len(values):
        found["points"] += json.loads(curves.curve(document, path, values[len(found["points"]) :]))["points"]
    return found


@pytest.mark.parametrize(("path", "values"), [("load.load", [1e4, 3e4]), ("body.a.profile[1].amplitude", [2e-3, 6e-3])])
def test_a_curve_has_the_numbers_of_single_cases(path, values):
    found = curve(STARTING, path, values)
    names = [each["name"] for each in found["quantities"]]
    keys = ("load__load",) if path == "load.load" else ("body__a__profile",)
    for point, value in zip(found["points"], values, strict=True):
        given = value if path == "load.load" else [STARTING["body"]["a"]["profile"][0] | {"amplitude": value}]
        solution = solution_of(changed(**{keys[0]: given}))
        numbers = dict(zip(names, point["numbers"], strict=True))
        assert point["value"] == value
        assert numbers["max_pressure"] == solution.max_pressure
        assert numbers["approach"] == 1e3 * solution.approach


def test_a_value_without_a_solution_is_a_sentence_on_the_curve():
    good, bad = curve(STARTING, "body.a.length", [18.0, -1.0])["points"]
    assert good["numbers"]
    assert "positive" in bad["sentence"]


def test_points_for_which_there_is_no_time_are_left_to_the_next_request(monkeypatch):
    monkeypatch.setattr(curves, "CURVE_SECONDS", 0.0)
    found = json.loads(curves.curve(STARTING, "load.load", [1e4, 2e4, 3e4]))
    assert [point["value"] for point in found["points"]] == [1e4]


def test_the_life_is_that_of_the_command_line():
    document = changed(body__b={"kind": "ring", "diameter": 80.0, "length": 24.0}, life={"rollers": 14})
    found = tile(answer(document), "Life")
    solution = solution_of(document)
    alone = nh.life.assess(solution, nh.life.iso_16281(), body="b", rollers=14)[0]
    assert found["where"] == "L₁₀, ISO/TS 16281, body b"
    assert (found["number"], found["unit"], found["under"]) == (alone.million_revolutions, "10⁶ rev.", None)
    # Without a rating, that of body a over the ideal, under this load.
    found = tile(answer(STARTING), "Life")
    solution = solution_of(STARTING)
    assert found["number"] == nh.life.assess(solution, nh.life.iso_16281())[0].relative_life
    assert (found["where"], found["under"]) == ("ISO/TS 16281, body a", solution.load)
    sharp = changed(body__a__profile=[])
    assert tile(answer(sharp), "Life")["where"].endswith(", sharp ends not counted")
