"""Bearings from REXS and to it."""

import json
import tomllib
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from nonhertz.errors import CaseError, InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.rexs import bearing_file_of_rexs, read_rexs, to_rexs, write_rexs
from nonhertz.files.rexs.attributes import UNITS, lines
from nonhertz.files.starting import starting_bearing

FORMS = ("rexs", "rexs.json")


def case_of(template=None, **changes):
    return BearingCase.of(tomllib.loads(starting_bearing(template)), Path("bearing.toml"), changes=changes or None)


def with_spectrum(**changes):
    """Return the cylindrical bearing with the spectrum below."""
    document = tomllib.loads(starting_bearing("cylindrical"))
    document.setdefault("life", {})["spectrum"] = SPECTRUM
    return BearingCase.of(document, Path("bearing.toml"), changes=changes or None)


def same(one, other):
    """Compare documents, numbers to rounding."""
    if isinstance(one, dict):
        assert one.keys() == other.keys()
        for name, value in one.items():
            same(value, other[name])
    elif isinstance(one, list) and one and not isinstance(one[0], float):
        assert len(one) == len(other)
        for pair in zip(one, other, strict=True):
            same(*pair)
    else:
        assert one == (pytest.approx(other, rel=1e-14, abs=0.0) if isinstance(one, float | list) else other)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("template", [None, "cylindrical", "needle", "tapered-pair", "spherical", "thrust"])
def test_what_both_know_comes_back(template, form, tmp_path):
    case = case_of(template)
    solution = case.solve("slices")
    path = write_rexs(tmp_path / f"bearing.{form}", case, solution, case.rated(solution)[0])
    same(case.own_document, read_rexs(path).own_document)


@pytest.mark.parametrize("form", FORMS)
def test_classes_fits_and_oils_come_back(form, tmp_path):
    changes = {
        "bearing.clearance": "C3",
        "bearing.bore": 30.0, "bearing.outside_diameter": 62.0, "lubrication.viscosity": None,
        "lubrication.oil": "ISO VG 68", "lubrication.temperature": 70.0, "load.radial": [10e3, -2e3],
        "fit.shaft.diameter": 30.0, "fit.shaft.interference": 0.01,
        "fit.housing.diameter": 62.0, "fit.housing.interference": 0.0,
        "life.dynamic": 44e3, "life.turning": "outer",
    }  # fmt: skip
    case = case_of(None, **changes)
    same(case.own_document, read_rexs(write_rexs(tmp_path / f"bearing.{form}", case)).own_document)


def test_results_have_the_units_of_rexs():
    case = case_of()
    solution = case.solve()
    life = case.assess(solution)
    model = json.loads(to_rexs(case, solution, life, form="json"))["model"]
    types = {each["id"]: each["type"] for each in model["components"]}
    found: dict[str, list] = {}
    for each in model["load_spectrum"]["load_cases"][0]["components"]:
        values = [{one["id"]: next(one[key] for key in one if key not in ("id", "unit")) for one in each["attributes"]}]
        found.setdefault(types[each["id"]], []).extend(values)
    (bearing,) = found["rolling_bearing_with_detailed_geometry"]
    assert bearing["radial_force_in_v"] == 10.0  # kN
    assert bearing["force_acting_on_inner_component_v"] == pytest.approx(-10e3)
    assert bearing["operating_point_stiffness_f_v_d_v"] == pytest.approx(1e3 * solution.stiffness[1, 1])  # N/m
    assert bearing["operating_point_stiffness_m_w_rot_w"] == pytest.approx(solution.stiffness[4, 4])
    assert bearing["radial_deflection_in_v"] == pytest.approx(1e3 * solution.displacement[1])
    assert bearing["nominal_rating_life_rotations_iso_281_2007"] == pytest.approx(1e6 * life.basic_life)
    assert bearing["nominal_rating_life_time_iso_281_2007"] == pytest.approx(1e6 * life.basic_life / 180e3)
    assert bearing["radial_dynamic_load_rating"] == pytest.approx(1e-3 * life.rating.dynamic)
    contacts = found["rolling_element_contact"]
    assert len(contacts) == 26
    assert contacts[0]["rolling_element_force"] == pytest.approx(1e-3 * solution.load[0, 0])
    assert sum(contacts[0]["rolling_element_lamina_load"]) == pytest.approx(solution.load[0, 0], rel=1e-4)
    assert max(contacts[0]["rolling_element_pressure"]) == pytest.approx(solution.max_pressure[0, 0], rel=0.02)
    assert "rolling_element_lamina_load" not in contacts[12]  # unloaded
    assert not np.isnan(bearing["maximum_hertzian_pressure"])


def test_relations_follow_the_rules():
    """Combinations of roles that the database of REXS 1.4 allows."""
    root = ET.fromstring(to_rexs(case_of("tapered-pair")))
    types = {each.get("id"): each.get("type") for each in root.find("components")}
    allowed = {
        ("assembly", "gear_unit", "shaft"), ("assembly", "gear_unit", "gear_casing"),
        ("side", "rolling_bearing_with_detailed_geometry", "shaft", "gear_casing"),
        ("reference", "rolling_bearing_with_detailed_geometry", "lubricant"),
        ("reference", "rolling_bearing_with_detailed_geometry", "material"),
        ("reference", "rolling_element", "material"),
        ("ordered_assembly", "rolling_bearing_with_detailed_geometry", "rolling_bearing_row"),
        ("ordered_assembly", "rolling_bearing_row", "rolling_element"),
    }  # fmt: skip
    found = {(each.get("type"), *(types[ref.get("id")] for ref in each)) for each in root.find("relations")}
    assert found == allowed
    ways = [each.text for each in root.iter("attribute") if each.get("id") == "axial_force_absorption_of_row"]
    assert ways == ["positive", "negative"]  # back to back


def test_the_table_is_of_known_units_and_own_names_are_marked():
    for each in lines():
        assert each["unit"] in UNITS
        assert "nonhertz" not in each["attribute"] or each["attribute"].startswith("custom_nonhertz_")


def test_what_is_written_is_in_the_table():
    listed = {name for each in lines() if each["use"] != "left" for name in each["attribute"].split("|")}
    listed |= {name.replace("inner", "outer") for name in listed if "acting" in name}
    case = case_of()
    solution = case.solve()
    root = ET.fromstring(to_rexs(case, solution, case.assess(solution)))
    written = {each.get("id") for each in root.iter("attribute")}
    assert written <= listed
    assert {name for each in lines() if each["use"] == "word" for name in [each["attribute"]]} - written == {
        "operating_time_fraction", "custom_nonhertz_share_of_revolutions",  # there is no spectrum
    }  # fmt: skip


def attributes(**given):
    return "".join(f'<attribute id="{name}" unit="{unit}">{value}</attribute>' for name, (value, unit) in given.items())


def bearing(number, kind, name="", **given):
    word = {"bearing_type": (kind, "")}
    inside = attributes(**word | given)
    return f'<component id="{number}" type="rolling_bearing_with_detailed_geometry" name="{name}">{inside}</component>'


NEEDLES = bearing(
    5, "radial_needle_roller_bearing", "K 45x53x28", inner_diameter=("45", "mm"), outer_diameter=("53", "mm"),
    operating_radial_bearing_clearance=("20", "mum"), radial_dynamic_load_rating=("40.5", "kN"),
    speed_inner_ring=("1500", "1 / min"), contamination_factor_according_to_iso_281_2007=("0.5", ""),
)  # fmt: skip
BALLS = bearing(6, "radial_grooved_ball_bearing", "6210")
CATALOGUED = bearing(
    7, "radial_tapered_roller_bearing", "30306", inner_diameter=("30", "mm"), outer_diameter=("72", "mm"),
    width=("20.75", "mm"), radial_dynamic_load_rating=("59.5", "kN"), radial_static_load_rating=("60", "kN"),
    catalogue_value_e=("0.31", ""), axial_force_absorption=("negative", ""),
)  # fmt: skip
INSIDE = (
    '<component id="8" type="rolling_bearing_row">'
    + attributes(number_of_rolling_elements=("21", ""), pressure_angle=("0", "°"), reference_diameter=("49", "mm"))
    + '</component><component id="9" type="rolling_element">'
    + attributes(diameter_of_rolling_element=("4", "mm"), length_of_rolling_element=("24", "mm"))
    + "</component>"
)
RELATIONS = "".join(
    f'<relation id="{number}" type="ordered_assembly" order="1">'
    f'<ref id="{whole}" role="assembly"/><ref id="{part}" role="part"/></relation>'
    for number, whole, part in ((1, 5, 8), (2, 8, 9))
)


def written(tmp_path, components, loads="", version="1.4"):
    head = f'<model version="{version}" applicationId="other" applicationVersion="1" date="2024-01-01T00:00:00+01:00">'
    shaft = '<component id="1" type="shaft" name="Shaft"/>'
    spectrum = f'<load_spectrum id="1"><load_case id="1">{loads}</load_case></load_spectrum>' if loads else ""
    path = tmp_path / "gearbox.rexs"
    text = f"{head}<relations>{RELATIONS}</relations><components>{shaft}{components}</components>{spectrum}</model>"
    path.write_text(text, encoding="utf-8-sig")
    return path


LOADS = (
    '<component id="5">'
    + attributes(force_acting_on_inner_component_v=("-3000", "N"), angular_deflection_in_w=("0.0002", "rad"))
    + "</component>"
)


def test_a_bearing_of_another_program(tmp_path):
    path = written(tmp_path, NEEDLES + INSIDE + BALLS + CATALOGUED, LOADS)
    case = read_rexs(path, 5)
    row = case.bearing
    assert (case.title, row.rollers, row.roller_diameter, row.pitch) == ("K 45x53x28", 21, 4.0, 49.0)
    assert (row.inner.diameter, row.outer.diameter, row.clearance) == (45.0, -53.0, pytest.approx(0.02))
    assert (case.prescribed.radial, case.prescribed.tilt, case.prescribed.speed) == (3000.0, 0.0002, 1500.0)
    assert case.life.dynamic == pytest.approx(40.5e3)
    assert case.lubrication.contamination is None  # there is no oil
    assert "reference profile of ISO 16281" in case.text
    assert case.solve("slices").force[1] == pytest.approx(3000.0)


def test_a_row_that_bears_loads_against_u_is_turned(tmp_path):
    given = {"axial_force": ("-8", "kN"), "radial_force_in_v": ("10", "kN"), "radial_force_in_w": ("-2", "kN")}
    loads = f'<component id="7">{attributes(**given)}</component>'
    load = read_rexs(written(tmp_path, CATALOGUED + NEEDLES + INSIDE, loads), 7).prescribed
    assert (load.axial, load.radial) == (8e3, (10e3, 2e3))


@pytest.mark.parametrize(
    "rest",
    ["5", "[]", '{"bearing": 5}', '{"bearing": {"pair": 5}}', '{"inner": {"diameter": "x"}}', '{"roller": {"a": 1}}'],
)
def test_own_attributes_that_are_damaged(rest, tmp_path):
    text = to_rexs(case_of("tapered-pair"), form="json")
    model = json.loads(text)
    for component in model["model"]["components"]:
        component["attributes"] = [
            each | ({"string": rest} if each["id"] == "custom_nonhertz_bearing_file" else {})
            for each in component["attributes"]
            if "diameter_of" not in each["id"]
        ]
    path = tmp_path / "damaged.rexs.json"
    path.write_text(json.dumps(model))
    with pytest.raises((InputError, CaseError)):
        read_rexs(path)


def test_an_inside_that_is_guessed(tmp_path):
    text = bearing_file_of_rexs(written(tmp_path, NEEDLES + INSIDE + CATALOGUED), 7)
    assert "estimated internal geometry of a tapered roller bearing" in text
    assert "no loads of this bearing" in text
    assert tomllib.loads(text)["bearing"]["rollers"] == 14


@pytest.mark.parametrize(
    ("components", "number", "words"),
    [
        (NEEDLES + INSIDE + BALLS, None, r"5 \(K 45x53x28\) or 6 \(6210\): name one"),
        (NEEDLES + INSIDE + BALLS, 1, r"5 \(K 45x53x28\) or 6 \(6210\): name one"),
        (BALLS, None, "'radial_grooved_ball_bearing' must be a roller bearing"),
        ("", None, "no rolling bearing"),
        (
            bearing(7, "radial_roller_bearing"),
            None,
            "number_of_rolling_elements, reference_diameter, .* are missing, or",
        ),
        (bearing(7, "radial_self_aligning_roller_bearing"), None, "roller_crowning_radius .*are missing: export"),
        (bearing(7, "radial_roller_bearing", width=("wide", "mm")), None, "width = 'wide' must be a number"),
        (bearing(7, "radial_roller_bearing", width=("1", "inch")), None, "the unit of width = 'inch' must be mm"),
    ],
)
def test_bearings_that_are_refused(components, number, words, tmp_path):
    with pytest.raises(InputError, match=words):
        read_rexs(written(tmp_path, components), number)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("load = 5", "be a model in REXS, as XML or JSON"),
        ("<a/>", "its root is 'a'"),
        ('<!DOCTYPE model [<!ENTITY a "a">]><model version="1.4"/>', "document type"),
        ("<model/>", "be a model in REXS"),
        ("{}", "be a model in REXS"),
        ('{"model": [', "be a model in REXS"),
        ('<model version="1.3"/>', "be of version 1.4 or later, not '1.3'"),
        ('{"model": {"version": "x", "components": []}}', "be of version 1.4 or later, not 'x'"),
    ],
)
def test_files_that_are_refused(text, words, tmp_path):
    path = tmp_path / "other.rexs"
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        read_rexs(path)
    with pytest.raises(InputError, match="file that can be read"):
        read_rexs(tmp_path / "none.rexs")


def test_names_of_files_and_forms(tmp_path):
    with pytest.raises(InputError, match="end with"):
        write_rexs(tmp_path / "bearing.xml", case_of())
    with pytest.raises(InputError, match="'xml' or 'json'"):
        to_rexs(case_of(), form="yaml")


SPECTRUM = [
    {"share": 0.1, "radial": 20e3},
    {"share": 0.8, "radial": [6e3, 1e3], "speed": 500.0, "tilt": 2e-4},
]


@pytest.mark.parametrize("form", FORMS)
def test_spectra_seats_and_classes_come_back(form, tmp_path):
    changes = {
        "bearing.bore": 30.0, "bearing.outside_diameter": 62.0, "bearing.width": 16.0, "bearing.clearance": "C3",
        "bearing.tolerance_class": "6", "fit.shaft": "k5", "fit.housing": "J7", "fit.inner_temperature": 70.0,
    }  # fmt: skip
    case = with_spectrum(**changes)
    path = write_rexs(tmp_path / f"bearing.{form}", case)
    same(case.own_document, read_rexs(path).own_document)
    text = path.read_text(encoding="utf-8")
    for word in ("k5", "J7", "P6", "C3"):
        assert (f">{word}<" if form == "rexs" else f'"{word}"') in text


def test_time_shares_of_a_spectrum_are_those_of_revolutions_over_speed():
    model = json.loads(to_rexs(with_spectrum(), form="json"))["model"]
    (unit,) = (entry["id"] for entry in model["components"] if entry["type"] == "gear_unit")
    cases = [case["components"] for case in model["load_spectrum"]["load_cases"]]
    shares = [entry["attributes"][0] for case in cases for entry in case if entry["id"] == unit]
    times = 0.1 / 3000.0, 0.8 / 500.0  # the first load has the speed of [load]
    expected = [90.0 * time / sum(times) for time in times]
    assert [share["floating_point"] for share in shares] == pytest.approx(expected)
    assert {share["id"] for share in shares} == {"operating_time_fraction"}


def load_case(number, force, percent, speed):
    unit = f'<component id="2">{attributes(operating_time_fraction=(percent, "%"))}</component>'
    force = attributes(radial_force_in_v=(force, "kN"), speed_inner_ring=(speed, "1 / min"))
    return f'<load_case id="{number}">{unit}<component id="5">{force}</component></load_case>'


def test_a_spectrum_of_another_program(tmp_path):
    path = written(tmp_path, '<component id="2" type="gear_unit"/>' + NEEDLES + INSIDE, "x")
    cases = load_case(1, "3", "40", "1500") + load_case(2, "1", "60", "500")
    text = path.read_text(encoding="utf-8-sig").replace('<load_case id="1">x</load_case>', cases)
    path.write_text(text, encoding="utf-8")
    case = read_rexs(path, 5)
    assert (case.prescribed.radial, case.prescribed.speed) == (3000.0, 1500.0)
    # In an hour 0.4 x 1500 and 0.6 x 500 of 900 mean revolutions a minute.
    assert [(entry.radial, entry.speed) for entry in case.life.spectrum] == [(3000.0, 1500.0), (1000.0, 500.0)]
    assert [entry.share for entry in case.life.spectrum] == pytest.approx([600 / 900, 300 / 900])
    alone = text.replace("operating_time_fraction", "operating_time")
    path.write_text(alone, encoding="utf-8")
    assert "first of 2 load cases; the others are left out" in read_rexs(path, 5).text


def test_seats_of_another_program_count_unless_the_clearance_is_that_in_operation(tmp_path):
    seats = {"shaft_tolerance_class": ("k5", ""), "casing_bore_tolerance_class": ("H7", "")}
    for clearance, expected in (("radial_bearing_clearance", "k5"), ("operating_radial_bearing_clearance", None)):
        needles = NEEDLES.replace("operating_radial_bearing_clearance", clearance).replace(">45<", ">35<")
        needles = needles.replace(">53<", ">60<")
        needles = needles.replace("</component>", f"{attributes(**seats)}</component>")
        case = read_rexs(written(tmp_path, needles + INSIDE, LOADS), 5)
        assert (case.fit.shaft.fit if case.fit is not None else None) == expected
    half = needles.replace("operating_radial", "radial").replace("casing_bore_tolerance_class", "other")
    assert read_rexs(written(tmp_path, half + INSIDE, LOADS), 5).fit is None


@pytest.mark.parametrize("form", FORMS)
def test_profiles_and_cones_come_back_where_other_programs_have_passed_over_the_rest(form, tmp_path):
    case = case_of("tapered-pair")
    path = write_rexs(tmp_path / f"bearing.{form}", case)
    path.write_text(path.read_text(encoding="utf-8").replace("custom_nonhertz_bearing_file", "custom_lost"), "utf-8")
    row, again = (one.bearing.rows[0].bearing for one in (case, read_rexs(path)))
    y = np.linspace(-0.4, 0.4, 9) * row.roller_length
    assert again.roller.profile.relief(y) == pytest.approx(row.roller.profile.relief(y), abs=2e-5)
    assert again.half_cone_angle == pytest.approx(row.half_cone_angle, rel=1e-6)
    assert "reference profile" not in read_rexs(path).text
