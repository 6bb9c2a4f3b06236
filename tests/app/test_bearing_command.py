"""`nonhertz bearing`, and what `new`, `check` and `solve` make of bearing files."""

import csv
import json
import re
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from few_rollers import PAIR, SIX, changed
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
import nonhertz.files.bearing_results
import nonhertz.plot
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.cli import main
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.bearingfile import read_bearing
from nonhertz.files.changes import parse_changes
from nonhertz.files.results import units_of
from nonhertz.files.schemas import schema_of
from nonhertz.files.toml import to_toml
from nonhertz.result.quantities import Quantity

FEW = changed(SIX, ('clearance = "12 um"\n', ""))
SLICES = '[solver]\nmethod = "slices"\n'


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in (("few", FEW), ("pair", PAIR), ("sliced", FEW + SLICES)):
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return tmp_path


@pytest.fixture(scope="module")
def few(tmp_path_factory):
    path = tmp_path_factory.mktemp("few") / "few.toml"
    path.write_text(FEW, encoding="utf-8")
    case = read_bearing(path)
    return case, case.solve()


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    path = tmp_path_factory.mktemp("pair") / "pair.toml"
    path.write_text(PAIR, encoding="utf-8")
    case = read_bearing(path)
    return case, case.solve()


# What is printed


def test_the_summary_says_what_an_engineer_asks_for(folder, run, few):
    printed = run("bearing", "few.toml")
    assert printed.err == ""
    _, found = few
    head, _, table = printed.out.partition("\n\n")
    rows = {line[:20].strip(): line[20:].strip() for line in head.splitlines()}
    assert printed.out.startswith("six\n")
    assert rows["bearing"] == "cylindrical roller bearing"
    assert re.fullmatch(r"6, 9 x 10 mm +pitch circle 46.5 mm", rows["rollers"])
    assert rows["force"].startswith("0, 5.0000, 0 kN")
    um = float(rows["displacement"].split(", ")[1])
    assert_allclose(um, 1e3 * found.displacement[1], rtol=1e-4)
    assert rows["tilt"].startswith("0, 0.20000 mrad")
    assert re.fullmatch(r"3 of 6 +-60.0 to 60.0 degrees", rows["loaded rollers"])
    loads = [float(each) for each in re.findall(r"[\d.]+(?= and| kN)", rows["most loaded roller"])]
    assert_allclose(loads, 1e-3 * found.load[0], rtol=1e-4)
    pressure = float(rows["maximum pressure"].split()[0])
    assert_allclose(pressure, found.max_pressure[0, 0], rtol=1e-4)
    stiffness = float(rows["stiffness"].split(", ")[1])
    assert_allclose(stiffness, 1e-3 * found.stiffness[1, 1], rtol=1e-4)
    life = nh.bearing.assess(found)
    assert rows["load ratings"].startswith(f"C = {1e-3 * life.rating.dynamic:.2f} kN")
    # The contacts reach the sharp ends of the rollers.
    assert life.no_reference in " ".join(printed.out.split())
    assert rows["L10r"].startswith("none")
    lines = table.splitlines()
    assert "load inner [kN]" in lines[0]
    loads = [1e3 * float(line.split()[2]) for line in lines[1:7]]
    assert_allclose(loads, found.load[:, 0], rtol=1e-4)
    assert "rib load" not in printed.out


def test_a_pair_is_shown_with_its_rows_ribs_and_life(folder, run, pair):
    out = run("bearing", "pair.toml").out
    _, found = pair
    assert "tapered roller bearing, 2 rows" in out
    assert re.search(r"loaded rollers +7 of 12 +row 1: all round; row 2: 0\.0 degrees", out)
    life = re.search(r"life L10 +([\d.]+)", out)
    assert life is not None
    assert_allclose(float(life[1]), nh.bearing.assess(found).basic_life, rtol=1e-3)
    rib = re.search(r"rib load +([\d.]+) N", out)
    assert rib is not None
    assert_allclose(float(rib[1]), found.rib_load.max(), rtol=1e-4)


def test_an_unloaded_bearing_is_no_failure(folder, run):
    Path("idle.toml").write_text(FEW.partition("[load]")[0] + "[load]\n", encoding="utf-8")
    out = run("bearing", "idle.toml").out
    assert re.search(r"loaded rollers +none of 6", out)
    assert re.search(r"static safety +no load", out)
    assert re.search(r"rated life +no damage", out)


# Lives: every output of one bearing whose oil is known, but not how clean it is

EXAMPLE = Path(__file__).parents[2] / "examples" / "nu206-mounted.toml"
NO_MODIFIED = "give viscosity and cleanliness for the modified life"


def test_no_output_assumes_a_cleanliness(folder, run):
    from nonhertz.report import compose
    from nonhertz.web.view.bearings import bearing_answer

    case = nh.read_bearing(EXAMPLE)
    found = case.solve()
    life = case.assess(found)
    hours = f"{life.reference_life * 1e6 / 60.0 / 3000.0:.0f} hours"
    printed = " ".join(run("bearing", str(EXAMPLE)).out.split())
    assert NO_MODIFIED in printed
    assert hours in printed
    result = run("bearing", str(EXAMPLE), "--json").json["life"]
    assert (result["no_modified"], result["modified_life"]) == (NO_MODIFIED, None)
    assert result["rated_life"] == result["reference_life"]
    report = compose([case])
    assert NO_MODIFIED in report
    assert hours in report
    page = bearing_answer(case, found)
    assert f"{life.reference_life * 1e6 / 60.0 / 3000.0:.0f}" in {
        each["value"] for each in page["numbers"] if each["name"] == "Rated life"
    }
    assert NO_MODIFIED in repr(life)


@pytest.mark.parametrize(("cleanliness", "hours"), [("-/15/12", 806), ("-/17/14", 509), ("-/19/16", 358)])
def test_a_cleanliness_has_the_life_of_its_class(folder, run, cleanliness, hours):
    # Found with the modulus of 207 GPa in place of 210 of 100Cr6, in a review of the example.
    steel = [each for part in ("roller", "inner", "outer") for each in ("--set", f"{part}.material=steel")]
    printed = run("bearing", str(EXAMPLE), *steel, "--set", f"lubrication.cleanliness={cleanliness}").out
    (found,) = re.findall(r"modified life +[\d.]+ million revolutions +([\d.]+) hours", printed)
    assert float(found) == pytest.approx(hours, abs=0.5)


# JSON and files


def test_json_is_one_strict_object_with_all_numbers(folder, run, few):
    printed = run("bearing", "few.toml", "--json")
    assert printed.err == ""
    result, (case, found) = printed.json, few
    for name in ("angle", "load", "moment", "approach", "tilt", "contact_angle", "rib_load", "displacement", "force"):
        assert_array_equal(result[name], getattr(found, name), err_msg=name)
    assert_array_equal(result["stiffness"], found.stiffness)
    assert_array_equal(result["max_pressure"], found.max_pressure)
    # Where there is no load there is no place of the maximum pressure.
    assert result["max_pressure_y"][3] == [None, None]
    life = case.assess(found)
    assert result["life"]["rating"]["dynamic"] == life.rating.dynamic
    assert result["life"]["basic_life"] == life.basic_life
    assert result["life"]["modified_life"] is None
    assert result["life"]["no_reference"] == life.no_reference != ""
    assert result["life"]["life_factor"] is None
    units = units_of(nonhertz.files.bearing_results.keys())
    assert result["units"] == units
    for name in ("roller_load", "displacement", "force", "stiffness"):  # each entry has its own
        shape = np.shape(units[name])
        assert np.shape(result[name])[-len(shape) :] == shape, name
    assert units.keys() <= result.keys()
    assert units["life"].keys() <= result["life"].keys()
    Path("again.toml").write_text(to_toml(result["case"]), encoding="utf-8")
    assert read_bearing("again.toml").bearing == case.bearing


def test_json_says_why_there_is_no_life(folder, run):
    ceramic = FEW.replace("[roller]\n", "[roller]\nmaterial = { modulus = 310000, poisson = 0.27 }\n") + SLICES
    Path("ceramic.toml").write_text(ceramic, encoding="utf-8")
    result = run("bearing", "ceramic.toml", "--json").json
    assert result["life"] is None
    assert result["life_reason"] == "the bearing must be of bearing steel"


def table(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.slow
def test_out_writes_result_rollers_and_lines(folder, capsys, few):
    assert main(["bearing", "few.toml", "--out", "new/results"]) == 0
    out = Path("new/results")
    written = {line.removeprefix("wrote ") for line in capsys.readouterr().out.splitlines() if line.startswith("wrote")}
    assert (
        written
        == {str(path) for path in out.iterdir()}
        >= {str(out / name) for name in ("result.json", "rollers.csv", "lines.csv")}
    )
    _, found = few
    assert json.loads((out / "result.json").read_text(encoding="utf-8"))["title"] == "six"
    rollers = table(out / "rollers.csv")
    assert_array_equal([float(row["load_inner [N]"]) for row in rollers], found.load[:, 0])
    assert_array_equal([float(row["max_pressure_outer [MPa]"]) for row in rollers], found.max_pressure[:, 1])
    assert rollers[3]["max_pressure_y_inner [mm]"] == ""
    lines = table(out / "lines.csv")
    assert {(row["roller"], row["ring"]) for row in lines} == {(j, ring) for j in "126" for ring in ("inner", "outer")}
    for j in (0, 1, 5):
        # Line loads over the widths of their strips add up to the loads of the rollers, and to moments about y = 0.
        own = [row for row in lines if row["roller"] == str(j + 1) and row["ring"] == "outer"]
        load, width, y = (
            np.array([float(row[name]) for row in own]) for name in ("line_load [N/mm]", "strip_width [mm]", "y [mm]")
        )
        assert_allclose(load @ width, found.load[j, 1], rtol=1e-6)
        assert_allclose((load * y) @ width, found.moment[j, 1], rtol=1e-2)
        assert (
            max(float(row["centre_pressure [MPa]"]) for row in own) == found.contact(j, "outer").centre_pressure.max()
        )


def test_a_further_number_of_bearings_is_one_entry(folder, run, monkeypatch):
    mean = Quantity("mean_load", "mean load", "", "N", lambda solved: solved.solution.load.mean())
    monkeypatch.setitem(QUANTITIES, "mean_load", mean)
    loads = read_bearing("sliced.toml").solve().load
    (line,) = (line for line in run("bearing", "sliced.toml").out.splitlines() if line.startswith("mean load "))
    assert_allclose(1e3 * float(line.split()[2]), loads.mean(), rtol=1e-4)
    assert run("bearing", "sliced.toml", "--json").json["mean_load"] == loads.mean()


# Both methods


def test_strips_are_printed_and_written_beside_slices(folder, run, few):
    assert "inner: strips [kN]" in run("bearing", "few.toml", "--compare").out
    result = run("bearing", "few.toml", "--compare", "--json", "--out", "both").json
    jsonschema.validate(result, schema_of("bearing-comparison"))
    case, strips = few
    slices = case.solve("slices")
    assert_array_equal(result["strips"]["load"], strips.load)
    assert_array_equal(result["slices"]["load"], slices.load)
    assert_array_equal(result["differences"]["displacement"], slices.displacement - strips.displacement)
    assert json.loads(Path("both/comparison.json").read_text(encoding="utf-8")) == result
    rows = table(Path("both/comparison.csv"))
    assert_array_equal([float(row["load_outer_slices [N]"]) for row in rows], slices.load[:, 1])
    assert {path.name for path in Path("both").iterdir()} == {"comparison.json", "comparison.csv"}


# Other commands


def test_check_says_in_one_line_that_all_is_well(folder, run):
    assert run("check", "pair.toml").out == (
        "pair.toml is fine: 'pair', a tapered bearing of 12 rollers, radial = 8000 N, axial = 3000 N.\n"
    )
    Path("both.toml").write_text(FEW.replace('"5 kN"', "[3e3, 4e3]"), encoding="utf-8")
    assert "radial = 3000, 4000 N, tilt = 0.0002 rad." in run("check", "both.toml").out


@pytest.mark.parametrize("change", ["load.radial=4MN", "load.tilt=0.05"])
def test_check_doubts_a_load_or_a_tilt_that_no_metal_bears(folder, run, change):
    out = run("check", "few.toml", "--set", change).out
    largest = float(re.search(r"\ndoubtful: no metal withstands the maximum pressure, ([\d.]+) MPa", out)[1])
    with without_accuracy_warnings():
        solved = read_bearing("few.toml", parse_changes([change])).solve("strips").max_pressure.max()
    assert 0.3 < largest / solved < 3.0  # slices of the standard do not feel each other


@pytest.mark.parametrize(("speed", "doubted"), [(3000, False), (180_000, True)])
def test_check_doubts_a_speed_that_no_bearing_has_reached(folder, run, speed, doubted):
    out = run("check", "few.toml", "--set", f"load.speed={speed}").out
    assert (f"\ndoubtful: speed = {speed} is in 1/min" in out) is doubted


def test_check_knows_a_bearing_file_without_its_bearing(folder, run):
    Path("bad.toml").write_text(FEW.replace("[bearing]", "[baering]"), encoding="utf-8")
    assert "Unknown key baering. Did you mean bearing?" in run("check", "bad.toml", code=2).out


def test_a_load_beyond_the_model_is_one_sentence(folder, run):
    Path("over.toml").write_text(FEW.replace("5 kN", "50 MN"), encoding="utf-8")
    run("check", "over.toml")
    (line,) = run("bearing", "over.toml", "--out", "results", code=2).err.splitlines()
    assert line.startswith("load must leave every contact of the rollers within the model: load = ")
    assert not Path("results").exists()


# Fits


FIT = """
[fit]
inner_temperature = 40
roller_temperature = 20
[fit.shaft]
diameter = 30
interference = "12 um"
temperature = 40
[fit.housing]
diameter = 62
"""


def test_the_summary_and_the_file_say_what_takes_the_clearance(folder, run):
    text = (FEW + SLICES).replace("rollers = 6", 'rollers = 6\nclearance = "40 um"')
    Path("fit.toml").write_text(text + FIT, encoding="utf-8")
    printed = run("bearing", "fit.toml").out
    taken = {remark: float(value) for value, remark in re.findall(r"([-\d.]+) µm +(reduction by .*?) *\n", printed)}
    # NSK's formula, and 12.5e-6 a kelvin.
    assert taken["reduction by the fit of the inner ring"] == pytest.approx(12.0 * 30.0 / 37.5, rel=1e-3)
    assert taken["reduction by temperatures"] == pytest.approx(1e3 * 12.5e-6 * 20.0 * 37.5, rel=1e-3)
    (left,) = re.findall(r"clearance +([-\d.]+) µm +radial, in operation", printed)
    (before,) = re.findall(r"before mounting +([-\d.]+) µm +radial", printed)
    assert float(left) == pytest.approx(float(before) - sum(taken.values()), abs=0.01)
    found = run("bearing", "fit.toml", "--json").json
    clearance = found["operating_clearance"]
    assert clearance["clearance"] == pytest.approx(1e-3 * float(left), rel=1e-3)
    assert clearance["inner"]["mounted_pressure"] > 0.0
    assert set(clearance) - {"axial"} == set(found["units"]["operating_clearance"]) - {"axial"}
    assert found["case"]["fit"]["shaft"]["interference"] == 0.012
    assert run("bearing", "sliced.toml", "--json").json["operating_clearance"] is None


@pytest.mark.parametrize(("temperature", "met"), [(20, True), (120, False)])
def test_a_ring_that_came_loose_is_a_limit_not_met(folder, run, temperature, met):
    text = FEW + SLICES + FIT.replace("inner_temperature = 40", f"inner_temperature = {temperature}")
    Path("loose.toml").write_text(text, encoding="utf-8")
    printed = run("bearing", "loose.toml").out
    assert ("Not judged." in printed, "Limits not met" in printed) == (met, not met)
    as_json = run("bearing", "loose.toml", "--json").json
    assert ("temperature-step" in [each["kind"] for each in as_json["findings"]]) is not met
    assert ("warning: The inner ring is 80 K warmer than the shaft" in printed) is not met
    verdict = as_json["verdict"]
    assert verdict["level"] == ("not-judged" if met else "not-met")
    sentence = re.compile(
        "The inner ring has come loose on its shaft: .* MPa between them when mounted, none in operation."
    )
    assert (
        sentence.search(" ".join(printed.split())) is None
        if met
        else sentence.fullmatch(verdict["findings"][0]["sentence"])
    )


def test_a_load_beyond_half_of_c_is_said(folder, capsys, run):
    Path("heavy.toml").write_text((FEW + SLICES).replace('radial = "5 kN"', 'radial = "15 kN"'), encoding="utf-8")
    assert main(["bearing", "heavy.toml"]) == 0
    words = "exceeds half the rating C of 23.76 kN: contacts may yield"
    assert words in " ".join(capsys.readouterr().out.split())
    found = run("bearing", "heavy.toml", "--json").json
    assert words in " ".join(found["warnings"])
    assert "heavy-load" in [each["kind"] for each in found["findings"]]
    assert "heavy-load" in [each["kind"] for each in found["verdict"]["findings"]]


def test_a_contact_is_printed_as_a_case_file(folder, run, few):
    Path("contact.toml").write_text(run("bearing", "few.toml", "--contact", "2", "outer").out, encoding="utf-8")
    _, loaded = few
    case = nh.read_case("contact.toml")
    assert case.title == "six, roller 2 on the outer ring"
    assert_allclose(case.solve().max_pressure, loaded.max_pressure[1, 1], rtol=1e-9)  # a file holds all digits


def test_a_diagram_is_of_the_values_that_single_solves_have(folder, run):
    """Each value is solved again alone; the longest life is the longest of these."""
    found = run("bearing", "few.toml", "--over", "clearance=0:60um:4", "--set", "solver.method=slices", "--json").json
    jsonschema.validate(found, schema_of("diagram"))
    assert found["over"] == "bearing.clearance"
    assert_allclose(found["values"], [0.0, 0.02, 0.04, 0.06], atol=1e-12)
    lives = []
    numbers = found["numbers"]
    for value, load, life in zip(found["values"], numbers["max_load"], numbers["reference_life"], strict=True):
        case = read_bearing("few.toml", {"solver.method": "slices", "bearing.clearance": value})
        solution = case.solve()
        assert solution.load.max() == pytest.approx(load, rel=1e-9)
        lives.append(case.assess(solution).reference_life)
        assert lives[-1] == pytest.approx(life, rel=1e-9)
    best = int(np.argmax(lives))
    assert found["longest_life"] == {"value": found["values"][best], "life": pytest.approx(lives[best])}


def test_a_diagram_is_written_as_rows_json_and_figure(folder, run):
    words = ("--over", "load=5kN:10kN:3", "--set", "solver.method=slices", "--out", "over")
    out = run("bearing", "few.toml", *words).out
    assert "longest life" in out
    assert {path.name for path in Path("over").iterdir()} >= {"diagram.json", "diagram.png", "diagram.svg", "rows.csv"}
    assert "Radial" in Path("over/diagram.svg").read_text(encoding="utf-8")
    assert json.loads(Path("over/diagram.json").read_text(encoding="utf-8"))["over"] == "load.radial"


def test_a_diagram_shades_the_group_of_the_clearance(folder, run):
    changes = {"solver.method": "slices", "bearing.clearance": "C3", "bearing.bore": 30.0}
    case = read_bearing("few.toml", changes)
    made = nh.study.diagram(case, "clearance", "0 : 60 um : 3")
    assert made.present is None
    assert made.class_limits is not None
    assert_allclose([made.class_limits.least, made.class_limits.greatest], [0.035, 0.060])
    (span,) = (mark for mark in made.figure().panels[0].marks if type(mark).__name__ == "Span")
    assert (span.low, span.high, span.name) == (0.035, 0.060, "C3")
