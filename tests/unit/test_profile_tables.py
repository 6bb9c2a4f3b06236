"""Profiles in case files as drawings state them: drops, and dimensions that are taken from the bodies."""

import math
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case
from nonhertz.files.profiles import needed_keys
from nonhertz.files.schemas import schema_of
from nonhertz.model.profile import CATALOGUE
from nonhertz.report.inputs import collect_inputs

ROLLER = "diameter = 16\nlength = 20"
CORNERED = ROLLER + "\ncorner_radius = 0.5"
# What a table needs beside kind, drop and what it takes from the body.
NEEDED = {
    "partial-crown": "straight = 12",
    "two-radius": "radius = 50000, middle = 12",
    "tapered-ends": "straight = 14",
    "chamfer": "width = 3",
    "tabulated": "y = [-10, 0, 10], relief = [0, 1, 3]",
}


def case(profile: str, body: str = ROLLER, other: str = "diameter = 60", folder: Path = Path()) -> Case:
    text = f"[body.a]\n{body}\nprofile = [{{ {profile} }}]\n[body.b]\n{other}\n[load]\nload = 5000\n"
    return Case.of(tomllib.loads(text), folder / "case.toml")


def mistakes(profile: str, body: str = ROLLER, other: str = "diameter = 60") -> list[str]:
    with pytest.raises(CaseError) as caught:
        case(profile, body, other)
    return [each.removeprefix("body.a.profile[1].") for each in caught.value.mistakes]


def parameters(made: Case) -> dict[str, Any]:
    entry = made.contact.a.profile.catalogue_entry
    assert entry is not None
    return entry[1]


@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE if kind != "straight"])
def test_every_kind_has_the_drop_at_the_end_of_the_land(kind):
    more = f", {NEEDED[kind]}" if kind in NEEDED else ""
    made = case(f"kind = '{kind}', drop = '5 um'{more}", CORNERED)
    relief = made.contact.a.relief([9.5, 0.0])
    assert relief[0] - relief[1] == pytest.approx(0.005, rel=1e-12)
    # What is written has no drop any more, but the same relief.
    table = made.own_document["body"]["a"]["profile"][0]
    assert not {"drop", "at"} & set(table)
    again = Case.of(made.own_document, Path())
    y = np.linspace(-9.9, 9.9, 41)
    np.testing.assert_array_equal(again.contact.a.relief(y), made.contact.a.relief(y))


@pytest.mark.parametrize(
    ("body", "end"),
    [
        (ROLLER, 10.0),
        (CORNERED, 9.5),
        (ROLLER + "\neffective_length = 18", 9.0),
        (ROLLER + "\nchamfer = { length = '1.5 mm', angle = 0.3 }", 8.5),
        ("diameter = 16\neffective_length = 15", 7.5),
    ],
)
def test_the_land_ends_where_corners_begin(body, end):
    made = case("kind = 'crown', drop = 0.02", body)
    assert float(made.contact.a.profile.relief(end)) == pytest.approx(0.02, rel=1e-13)
    elsewhere = case("kind = 'crown', drop = 0.02, at = '-5 mm'", body)
    assert float(elsewhere.contact.a.profile.relief(-5.0)) == pytest.approx(0.02, rel=1e-13)


@pytest.mark.parametrize("kind", ["iso-logarithmic", "iso-tapered", "iso-thrust", "logarithmic"])
def test_corners_leave_a_logarithm_for_the_whole_body_finite(kind):
    made = case(f"kind = '{kind}', drop = '20 um'", CORNERED).contact.a
    assert float(made.relief(9.5)) == pytest.approx(0.02, rel=1e-12)
    assert math.isinf(made.profile.relief(10.0))
    assert mistakes(f"kind = '{kind}', drop = '20 um'") == [
        f"at = 10.0 must be where '{kind}' has a finite relief: give a place farther inside, in mm."
    ]


def test_a_drop_is_that_before_shift_and_flip():
    plain = case("kind = 'crown', drop = 0.02, at = 9, centre = 1").contact.a.profile
    moved = case("kind = 'crown', drop = 0.02, at = 9, centre = 1, shift = 0.5, flip = true").contact.a.profile
    y = np.linspace(-9.0, 9.0, 19)
    np.testing.assert_allclose(moved.relief(y), plain.relief(-y - 0.5), rtol=1e-13, atol=1e-18)


def test_points_in_a_file_are_scaled(tmp_path):
    (tmp_path / "points.csv").write_text("-10, 1\n0, 0\n10, 3\n", encoding="utf-8")
    made = case("kind = 'tabulated', file = 'points.csv', drop = '30 um'", folder=tmp_path)
    np.testing.assert_allclose(made.contact.a.profile.relief([-10.0, 10.0]), [0.01, 0.03], rtol=1e-14)


@pytest.mark.parametrize("kind", ["lundberg", "johns-gohar", "fujiwara-kawase"])
def test_the_radius_of_a_design_load_is_that_of_both_bodies(kind):
    for other, radius in (("diameter = 60", 8 * 30 / 38), ("diameter = -60", 8 * 30 / 22), ("", 8.0)):
        found = parameters(case(f"kind = '{kind}', load = '20 kN'", other=other))
        assert found["radius"] == pytest.approx(radius, rel=1e-14)
        assert found["length"] == 20.0
    own = parameters(case(f"kind = '{kind}', load = '20 kN', radius = 5"))
    assert own["radius"] == 5.0
    on_b = {
        "body": {
            "a": {"diameter": 60.0},
            "b": {"diameter": 16.0, "length": 20.0, "profile": {"kind": kind, "load": 2e4}},
        }
    }
    made = Case.of(on_b | {"load": {"load": 1e3}}, Path())
    assert made.contact.b.profile == case(f"kind = '{kind}', load = '20 kN'").contact.a.profile


def test_the_radius_counts_in_the_middle_of_a_table_of_diameters():
    found = parameters(
        case("kind = 'lundberg', load = '20 kN'", "diameter = { y = [-10, 10], diameter = [14, 18] }\nlength = 20")
    )
    assert found["radius"] == pytest.approx(8 * 30 / 38, rel=1e-14)


def test_no_radius_is_taken_where_the_relief_at_the_end_is_given():
    assert "radius" not in parameters(case("kind = 'fujiwara-kawase', load = '20 kN', zm = 0.02"))


@pytest.mark.parametrize("kind", ["iso-tapered", "iso-logarithmic", "iso-thrust"])
def test_the_diameter_of_a_cone_is_that_normal_to_its_axis(kind):
    # As in the how-to: 12 mm and 14 mm normal to the axis, 18 mm apart along the surface.
    cosine = math.sqrt(1.0 - (1.0 / 18.0) ** 2)
    ends = [12.0 / cosine, 14.0 / cosine]
    for body in (
        f"diameter = {{ y = [-9, 9], diameter = {ends} }}\nlength = 18",
        f"diameter = {{ y = [-9, 9], diameter = {ends} }}\nlength = 16",
    ):
        assert parameters(case(f"kind = '{kind}'", body))["diameter"] == pytest.approx(13.0, rel=1e-14)
    barrel = "diameter = { y = [-9, 0, 9], diameter = [12, 13, 12] }\nlength = 18"
    assert parameters(case(f"kind = '{kind}'", barrel))["diameter"] == 13.0


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("drop = 0.02, at = 9500", ["at = 9500.0 must lie on the body, which ends 10 mm from its mi"]),
        ("drop = '20 um', radius = 3", ["drop = '20 um' must not be given together with radius: "]),
        ("drop = 0.02, scale = 2", ["scale = 2 must not be given together with drop: leave one"]),
        ("at = 9", ["at = 9.0 must not be given without drop: ", "radius must be given: "]),
        ("drop = '20 kg', at = 'x'", ["drop = '20 kg' must have a unit of len", "at = 'x' must be a"]),
        ("dorp = 0.02", ["Unknown key body.a.profile[1].dorp. Did you mean body.a.profile[1].drop?"]),
        ("drop = 0.02, at = nan", ["at = nan must be a finite number: "]),
        ("drop = 0.02, centre = '5 kg'", ["centre = '5 kg' must have a unit of length: "]),
    ],
)
def test_nonsense_is_refused_once_and_at_its_key(keys, expected):
    for found, beginning in zip(mistakes(f"kind = 'crown', {keys}"), expected, strict=True):
        assert found.startswith(beginning)


@pytest.mark.parametrize(
    ("table", "body", "expected"),
    [
        (
            "kind = 'crown', drop = 0.02",
            "diameter = 16",
            ["at must be given: give the position of the drop in mm, becaus"],
        ),
        ("kind = 'crown', drop = 0.02", "diameter = 16\nlength = -20", ["body.a.length = -20.0 must be positive: "]),
        ("kind = 'crown', drop = 0.02", ROLLER + "\ncorner_radius = 11", ["body.a.length = 20.0 must leave a land: "]),
        ("kind = 'two-radius', drop = 0.02", ROLLER, ["radius must be given: ", "middle must be given: "]),
        ("kind = 'lundberg', drop = 0.02, length = -3", ROLLER, ["length = -3.0 must be positive: "]),
        ("kind = 'measured', file = 'x', drop = 0.02", ROLLER, ["Unknown key body.a.profile[1].drop: "]),
    ],
)
def test_a_drop_that_a_body_or_kind_has_not_is_refused(table, body, expected):
    for found, beginning in zip(mistakes(table, body), expected, strict=True):
        assert found.startswith(beginning)


@pytest.mark.parametrize("kind", ["lundberg", "johns-gohar", "fujiwara-kawase"])
def test_bodies_without_a_radius_are_the_mistake(kind):
    table = f"kind = '{kind}', drop = '20 um'"
    (sentence,) = mistakes(table, ROLLER, "diameter = 'x'")
    assert sentence.startswith("body.b.diameter = 'x' must be a number with a unit")
    found = mistakes(table, ROLLER, "diameter = -10")
    assert len(found) == 1
    assert found[0].startswith(
        "radius must be given: " if kind != "fujiwara-kawase" else "zm must be given where radius"
    )


def test_the_schema_needs_a_size_or_a_drop():

    kinds = schema_of("case")["$defs"]["Body"]["properties"]["profile"]["anyOf"][0]["anyOf"]
    found = {each["properties"]["kind"]["const"]: each for each in kinds}
    assert needed_keys("crown") == ["radius"]
    assert found["crown"]["required"] == ["kind"]
    assert found["crown"]["oneOf"] == [{"required": ["radius"], "not": {"required": ["drop"]}}, {"required": ["drop"]}]
    assert needed_keys("lundberg") == ["load"]
    assert "oneOf" not in found["iso-tapered"]


def test_a_report_shows_what_a_drop_determined():
    def entries(made):
        profile = (entry for entry in collect_inputs(made)[0].entries if ".profile" in entry.place)
        return {entry.place.rpartition(".")[2]: (entry.value_with_unit, entry.default) for entry in profile}

    shown = entries(case("kind = 'crown', drop = '20 um'", CORNERED))
    assert shown["radius"] == ("2256.26 mm", False)
    assert shown["drop"] == ("20 µm", False)
    assert shown["at"] == ("the end of the land", True)
    assert entries(case("kind = 'iso-tapered', drop = '20 um'", CORNERED))["scale"][0] == "1.19325"
    made = case("kind = 'lundberg', load = '20 kN'")
    radius = 1.0 / float(made.contact.curvature(0.0))
    assert entries(made)["radius"][0] == f"{radius:.6g} mm"


def test_a_case_of_python_with_a_drop_is_written():
    profile = nh.profile.with_drop("iso-logarithmic", 0.02, 9.5, diameter=16.0, length=20.0).flipped()
    roller = nh.Roller(diameter=16.0, length=20.0, corner_radius=0.5, profile=profile)
    made = nh.Case(nh.Contact(roller, nh.Ring(diameter=60.0)), {"load": 5e3})
    y = np.linspace(-9.9, 9.9, 41)
    found = Case.of(made.own_document, Path("case.toml"))
    np.testing.assert_array_equal(found.contact.a.relief(y), roller.relief(y))
