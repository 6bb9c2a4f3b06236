"""The bearing page: its numbers are those of the solver, its mistakes those of the command line, its limits hold."""

import copy
import json
import math
import re
import time
import tomllib
from pathlib import Path
from typing import Any

import few_rollers
import httpx
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from serving import post, running

import nonhertz as nh
from nonhertz.bearing.series import series_table
from nonhertz.cli.serve import starting_document
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.web import limits
from nonhertz.web.form.ranges import form_state
from nonhertz.web.form.schema import form_schema
from nonhertz.web.server import workers
from nonhertz.web.view import jobs

RINGS = ("inner", "outer")
STARTING = tomllib.loads(starting_bearing())
FEW_TEXT = few_rollers.changed(few_rollers.SIX, ('"six"', '"six & <seven>"'))
FEW = tomllib.loads(FEW_TEXT)
PAIR = tomllib.loads(
    few_rollers.changed(
        few_rollers.PAIR,
        ('{ kind = "crown", radius = 4000 }', '[{ kind = "crown", drop = 0.02 }]'),
        ('radial = "8 kN"', 'radial = ["8 kN", "1 kN"]'),
    )
)
THRUST = tomllib.loads(
    few_rollers.changed(
        few_rollers.THRUST,
        ("rollers = 20", "rollers = 8"),
        ("length = 8", 'length = 8\nprofile = { kind = "crown", radius = 1000 }'),
        ('axial = "20 kN"', 'axial_displacement = "5 um"\nmoment = "10 N m"'),
    )
)


def answer(given: Any, method: Any = "slices", roller: Any = None) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(jobs.load(given, method, roller))
    return found


def drawn(found: dict[str, Any]) -> dict[str, Any]:
    """Return the panels of the roller that is shown, by their names."""
    return {panel["name"]: panel for panel in found["lines"]["panels"]}


def of_rings(found: dict[str, Any], panel: str) -> dict[str, tuple[Any, Any]]:
    """Return the lines of a panel by the rings that they are of."""
    lines = [mark for mark in drawn(found)[panel]["marks"] if mark["kind"] == "line"]
    return {line["name"].split()[0]: (np.array(line["x"], float), np.array(line["y"], float)) for line in lines}


def changed(document: dict[str, Any], path: str, value: Any) -> dict[str, Any]:
    made = copy.deepcopy(document)
    *way, last = path.split(".")
    table = made
    for name in way:
        table = table.setdefault(name, {})
    table[last] = value
    return made


def solved(document: dict[str, Any], method: str) -> nh.bearing.BearingSolution:
    case = BearingCase.of(document, Path("b.toml"))
    return nh.bearing.solve(case.bearing, **case.prescribed.keywords, method=method)


# Answers


@pytest.mark.parametrize("method", ["slices", "strips"])
def test_numbers_are_those_of_the_solver(method):
    found, solution = answer(FEW, method), solved(FEW, method)
    assert found["ok"]
    assert found["method"] == method
    # The same solver on the same machine: all digits.
    assert found["load"] == solution.load.tolist()
    assert found["angle"] == solution.angle.tolist()
    assert found["force"] == solution.force.tolist()
    numbers = {each["name"]: each["number"] for each in found["numbers"]}
    assert numbers["Displacement"] == math.hypot(*solution.displacement[1:3])
    assert numbers["Largest roller load"] == solution.load.max()
    assert found["most"] == int(solution.load.max(axis=1).argmax())
    assert numbers["Loaded rollers"] == np.count_nonzero(solution.load.min(axis=1))
    if method == "strips":
        assert numbers["Maximum pressure"] == solution.max_pressure.max()
        roller, ring = np.argwhere(solution.max_pressure == solution.max_pressure.max())[0]
        assert found["numbers"][0]["where"] == f"roller {roller + 1}, {('inner', 'outer')[ring]} ring"
    else:
        assert numbers["Maximum pressure"] is None
    assert ("pressure" in drawn(found)) == (method == "strips")


@pytest.mark.parametrize("method", ["slices", "strips"])
@pytest.mark.parametrize("document", [FEW, PAIR], ids=["few", "pair"])
def test_line_loads_add_up_to_the_loads(document, method):
    for roller, loads in enumerate(answer(document, method)["load"]):
        lines = of_rings(json.loads(jobs.lines(document, method, roller)), "line")
        assert set(lines) == {ring for ring, load in zip(RINGS, loads, strict=True) if load > 0.0}
        for ring, (y, q) in lines.items():
            load = loads[RINGS.index(ring)]
            total = float(np.sum(0.5 * (q[1:] + q[:-1]) * np.diff(y)))
            # Steps are integrated exactly; through the centres of strips, to the curvature over a strip.
            assert_allclose(total, load, rtol=1e-9 if method == "slices" else 0.02)


def test_lines_end_where_the_contact_ends():
    # So much of a crown that the ends of the rollers do not touch, where the pressure would have no limit.
    crowned = changed(FEW, "roller.profile", {"kind": "crown", "drop": "80 um"})
    contacts = solved(crowned, "strips")
    for roller in range(6):
        found = json.loads(jobs.lines(crowned, "strips", roller))
        assert found["shown"] == roller
        for ring, (y, pressure) in of_rings(found, "pressure").items():
            contact = contacts.contact(roller, ring)
            assert_array_equal(y[[0, -1]], np.ravel(contact.contact_y)[[0, -1]])
            assert_array_equal(pressure[[0, -1]], 0.0)
            assert np.nanmax(pressure) == pytest.approx(contact.max_pressure, rel=0.02)


def test_relief_is_read_in_um():
    found = answer(FEW)
    assert drawn(found)["relief"]["upright"]["title"] == "Joint relief [µm]"
    for y, relief in of_rings(found, "relief").values():
        # A circle of 1200 mm: y^2 / 2 R to (y / R)^2 / 4.
        assert_allclose(relief, y**2 / 2400.0, rtol=1e-5, atol=1e-15)


def test_a_roller_that_is_not_there_is_the_most_loaded():
    assert answer(FEW, roller=17)["shown"] == answer(FEW, roller=-1)["shown"] == answer(FEW)["most"]
    assert answer(FEW, roller=2)["shown"] == 2


def test_the_file_says_the_method():
    assert answer(FEW)["file_method"] == "strips"
    sliced = changed(FEW, "solver.method", "slices")
    found = answer(sliced, None)
    assert (found["file_method"], found["method"]) == ("slices", "slices")


# What the form has of the geometry


def sliders(document: dict[str, Any]) -> dict[str, Any]:
    ranges: dict[str, Any] = form_state(document, "bearing")["ranges"]
    return ranges


@pytest.mark.parametrize("document", [STARTING, FEW, PAIR, THRUST])
def test_every_place_of_a_slider_of_loads_can_be_solved(document):
    paths = [
        *(f"load.{name}" for name in document["load"]),
        *(["bearing.clearance"] * ("clearance" in document["bearing"])),
    ]
    for path in paths:
        name = path.partition(".")[2]
        slider = sliders(document).get(name)
        if slider is None:
            continue
        for value in (slider["low"], slider["high"]):
            made = changed(document, path, value)
            found = answer(made)
            assert found["ok"], (path, value, found["mistakes"])
            assert sliders(made)[name] == slider, "it would run away from the hand"


def test_what_a_bearing_does_not_bear_has_no_slider():
    assert sliders(FEW)["axial"] is None
    assert sliders(changed(FEW, "bearing.design", "NUP"))["axial"] is not None
    assert sliders(changed(THRUST, "load", {"axial": 1.0}))["radial"] is None


def test_a_load_at_the_end_of_its_slider_is_what_steel_bears():
    high = sliders(STARTING)["radial"]["high"]
    found = answer(changed(changed(STARTING, "load.radial", high), "load.tilt", 0.0), "strips")
    middle = [np.nanmax(pressure[20:-20]) for _, pressure in of_rings(found, "pressure").values()]
    assert 2500.0 < max(middle) < 4000.0


def test_another_kind_of_bearing_begins_with_one_that_can_be_solved():
    examples = form_schema("bearing")["x-examples"]
    assert set(examples) == set(nh.bearing.RollerBearing.kinds)
    for kind, edits in examples.items():
        made = PAIR | edits
        found = answer({name: value for name, value in made.items() if value is not None})
        assert found["ok"], (kind, found["mistakes"])
        assert made["bearing"]["kind"] == kind


# Mistakes


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        ("bearing.rollers", 101, "must be at most 100 on the page"),
        ("solver.laminae", 201, "must be at most 200 on the page"),
        ("life.laminae", 201, "must be at most 200 on the page"),
        ("roller.images", 11, "must be at most 10 on the page"),
    ],
)
def test_limits(path, value, words):
    document = changed(FEW, path, value)
    if path == "bearing.rollers":
        document = changed(changed(document, "inner.diameter", 391.0), "outer.diameter", -409.0)
    if path == "roller.images":
        document = changed(changed(document, "roller.side_faces", "calibrated"), "roller.depth", "diameter")
    (mistake,) = answer(document)["mistakes"]
    assert mistake["path"] == path
    assert words in mistake["sentence"]


def test_no_file_is_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("points.csv").write_text("-5, 0.01\n0, 0\n5, 0.01\n")
    for kind in ("tabulated", "measured"):
        for part in ("roller", "inner", "outer"):
            document = changed(FEW, f"{part}.profile", {"kind": kind, "file": "points.csv"})
            (mistake,) = answer(document)["mistakes"]
            assert mistake["path"] == f"{part}.profile.file"
            assert "not be read here" in mistake["sentence"]
            assert form_state(document, "bearing")["bodies"]
            assert b"must not be read here" in jobs.written(document, BearingCase, "rollers.csv")
            assert b"must not be read here" in jobs.drawn(document, "loads", "svg")


# The server


@pytest.fixture(scope="module")
def page():
    with (
        running(FEW, text=FEW_TEXT) as port,
        httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=workers.WARM_UP_SECONDS) as made,
    ):
        yield made


def test_a_bearing_is_what_the_page_begins_with(page):
    text = page.get("/").text
    start = json.loads(re.search(r'<script type="application/json" id="start">(.*?)</script>', text, re.S)[1])
    assert (start["document"], start["text"]) == (FEW, FEW_TEXT)
    assert "<seven>" not in text
    assert text == page.get("/bearing").text
    assert '"title": "nonhertz case file"' in page.get("/contact").text
    assert 'href="contact"' in text
    assert 'href="bearing"' in page.get("/contact").text


@pytest.mark.slow
def test_processes_start_when_their_page_is_opened(page):
    assert post(page, "/bearing/solve", json={"document": FEW, "method": "slices"}).json()["ok"]
    assert page.get("/bearing/status").json() == {"ready": True}
    with running(tomllib.loads(starting_case()), workers=1) as port:
        client = httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=60.0)
        assert client.get("/bearing/status").json() == {"ready": False}
        assert client.post("/bearing/solve", json={"document": FEW, "method": "slices"}).json()["ok"]
        assert client.get("/bearing/status").json() == {"ready": True}
        client.close()


def test_without_a_file_there_is_a_bearing_beside_the_contact():
    with running(tomllib.loads(starting_case()), workers=0) as port:
        client = httpx.Client(base_url=f"http://127.0.0.1:{port}")
        assert client.get("/").text == client.get("/contact").text
        assert "NU 206" in client.get("/bearing").text
        client.close()


@pytest.mark.slow
def test_nobody_computes_for_one_who_has_gone(page):
    with pytest.raises(httpx.ReadTimeout):
        page.post("/bearing/solve", json={"document": STARTING, "method": "strips"}, timeout=0.01)
    begun = time.monotonic()
    assert post(page, "/bearing/solve", json={"document": FEW, "method": "strips"}).json()["ok"]
    assert time.monotonic() - begun < limits.ANSWER_SECONDS


@pytest.mark.slow
def test_the_bearing_file_and_a_table_are_downloaded(page):
    made = post(page, "/bearing/download/bearing.toml", json={"document": FEW})
    assert tomllib.loads(made.text) == FEW
    commented = "# Six rollers.\n" + FEW_TEXT
    other = changed(FEW, "load.radial", "7 kN")
    made = post(page, "/bearing/download/bearing.toml", json={"document": other, "text": commented})
    assert made.text == commented.replace("5 kN", "7 kN")
    assert page.post("/bearing/download/bearing.toml", json={"document": other, "text": 3}).status_code == 400
    assert made.headers["content-disposition"] == 'attachment; filename="six-seven.toml"'
    table = post(page, "/bearing/download/rollers.csv", json={"document": FEW})
    assert table.headers["content-disposition"] == 'attachment; filename="six-seven-rollers.csv"'
    lines = table.text.splitlines()
    assert len(lines) == 1 + 6
    load = float(lines[1].split(",")[lines[0].split(",").index("load_inner [N]")])
    assert load == solved(FEW, "strips").load[0, 0]


def test_a_figure_that_there_is_none_of():
    sliced = changed(FEW, "solver.method", "slices")
    assert b"solve by strips" in jobs.drawn(sliced, "pressure", "svg")
    idle = changed(FEW, "load", {"radial_displacement": 0.0})
    assert b"load the bearing" in jobs.drawn(idle, "roller", "svg")
    assert b"give lubrication.oil" in jobs.drawn(changed(FEW, "lubrication", {}), "film", "svg")


def test_films_are_drawn_where_oil_and_speed_are_known():
    oiled = changed(changed(FEW, "lubrication", {"viscosity": 20.0}), "load.speed", 1000.0)
    found = answer(oiled)
    assert [panel["name"] for panel in found["films"]["film"]["panels"]] == ["film-1"]
    assert found["films"]["film-along"]["panels"][0]["upright"]["unit"] == "µm"
    assert any(name == "minimum film" for name, *_ in found["summary"])
    assert answer(changed(FEW, "lubrication", {}))["films"] == {}
    assert b"<svg" in jobs.drawn(oiled, "film-along", "svg")


# The command


def test_a_bearing_file_is_recognised(tmp_path):
    path = tmp_path / "six.toml"
    path.write_text(FEW_TEXT)
    assert starting_document(path) == (FEW, (), FEW_TEXT)


def test_files_that_a_bearing_names_become_points(tmp_path):
    (tmp_path / "points.csv").write_text("-5, 0.01\n0, 0\n5, 0.01\n")
    path = tmp_path / "my bearing.toml"
    text = FEW_TEXT.replace('title = "six & <seven>"', "")
    path.write_text(text.replace('"crown", radius = 1200', '"tabulated", file = "points.csv"'))
    start = starting_document(path)
    assert start.document["title"] == "my bearing"
    assert start.notes == ("roller.profile[1]: the page contains the 3 points of points.csv.",)
    assert start.document["roller"]["profile"][0]["relief"] == [0.01, 0.0, 0.01]
    assert answer(start.document)["load"] == solved_file(path)


def solved_file(path: Path) -> list[list[float]]:
    found: list[list[float]] = nh.read_bearing(path).solve("slices").load.tolist()
    return found


def test_a_contact_is_a_case_of_the_other_page():
    found = json.loads(jobs.contact(FEW, 0, "outer"))["document"]
    loaded = solved(FEW, "strips")
    shown = json.loads(jobs.solve(found, False, "a"))
    assert shown["title"].endswith("roller 1 on the outer ring")
    assert shown["key"]["load"] == pytest.approx(loaded.load[0, 1], rel=1e-9)
    assert shown["key"]["max_pressure"] == pytest.approx(loaded.max_pressure[0, 1], rel=1e-9)


def test_what_was_solved_last_is_not_solved_again(monkeypatch):
    first = answer(FEW, "strips")
    monkeypatch.setattr(BearingCase, "solve", None)
    assert json.loads(jobs.contact(FEW, 0, "inner"))["ok"]
    monkeypatch.undo()
    other = changed(FEW, "load", {"radial": 10000.0})
    found = json.loads(jobs.contact(other, 0, "inner"))["document"]
    assert found["load"]["load"] > 1.5 * first["load"][0][0]


def test_a_catalogue_gives_a_bearing_and_says_what_is_estimated():
    data = {"d": "30", "D": "62", "B": "16", "C": "44 kN", "C0": "36.5 kN", "F": "37.5", "E": "55.5"}
    found = json.loads(jobs.catalogue(data))
    assert tomllib.loads(found["text"]) == found["document"]
    assert found["document"]["bearing"]["bore"] == 30.0
    estimates = found["estimates"]["values"]
    assert list(estimates) == ["bearing.rollers", "bearing.clearance", "roller.length", "inner.depth", "outer.depth"]
    assert estimates["roller.length"] == found["document"]["roller"]["length"]
    assert "bearing.clearance" not in json.loads(jobs.catalogue(data | {"clearance": "20 um"}))["estimates"]["values"]


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        ({}, "must include d, D, B, C and C0: add them, as in d=30"),
        ({"d": 30}, "must be short text"),
        ({"d": "9" * 101}, "must be short text"),
        ({"z": "1"}, "catalogue = 'z' must be a known symbol"),
        ({"d": "30 kN", "D": "62", "B": "16", "C": "44", "C0": "36"}, "d = '30 kN' must have a unit of length"),
    ],
)
def test_what_no_catalogue_has_is_refused_on_the_page(data, sentence):
    found = json.loads(jobs.catalogue(data))
    assert not found["ok"]
    assert sentence in found["mistakes"][0]["sentence"]


def test_series_are_those_of_the_kind():
    kinds = form_schema("bearing")["$defs"]["RollerBearing"]["x-kinds"]
    assert {kind: tuple(of["words"]["series"]) for kind, of in kinds.items()} == {
        kind: tuple(series) for kind, series in series_table().items()
    }
