"""Values of a file by dotted paths."""

import pytest

import nonhertz as nh
from nonhertz.files.bearing_document import BearingFile
from nonhertz.files.paths import drop_before_parameters, find_parameter, list_parameters
from nonhertz.files.sections import CaseDocument

CASE = {
    "body": {
        "a": {
            "diameter": 20.0,
            "length": 20.0,
            "profile": [{"kind": "crown", "radius": "4 m"}, {"kind": "logarithmic", "length": 20.0}],
        },
        "b": {"material": "steel"},
    },
    "load": {"load": "20 kN"},
}


@pytest.fixture
def known():
    return list_parameters(CASE, CaseDocument)


@pytest.mark.parametrize(
    ("path", "unit", "whole"),
    [
        ("load.load", "N", False),
        ("load.tilt", "rad", False),
        ("body.a.diameter", "mm", False),
        ("body.b.depth", "mm", False),
        ("body.b.material", None, False),
        ("solver.strips", "", True),
        ("body.a.side_faces", "", False),
        ("body.a.profile[1].radius", "mm", False),
        ("body.a.profile.radius", "mm", False),  # only a crown has one
        ("body.a.profile[2].drop", "mm", False),
        ("body.a.chamfer.angle", "rad", False),
    ],
)
def test_a_path_has_the_unit_of_its_key(known, path, unit, whole):
    found = find_parameter(path, known)
    assert (found.unit, found.whole) == (unit, whole)


def test_a_key_that_both_profiles_can_have_needs_a_position(known):
    assert "body.a.profile.drop" not in known
    with pytest.raises(nh.InputError, match=r"Did you mean body\.a\.profile\[[12]\]\.drop\?"):
        find_parameter("body.a.profile.drop", known)


@pytest.mark.parametrize(
    ("path", "nearest"),
    [("load.laod", "load.load"), ("tilt", "load.tilt"), ("body.a.diametre", "body.a.diameter")],
)
def test_of_an_unknown_path_the_nearest_is_named(known, path, nearest):
    with pytest.raises(nh.InputError, match=rf"Did you mean {nearest}\?"):
        find_parameter(path, known)


def test_a_document_with_another_value_leaves_the_first_as_it_was(known):
    changed = known["body.a.profile.radius"].put(CASE, 5e3)
    assert changed["body"]["a"]["profile"][0] == {"kind": "crown", "radius": 5e3}
    assert changed["body"]["a"]["profile"][1] is CASE["body"]["a"]["profile"][1]
    assert CASE["body"]["a"]["profile"][0]["radius"] == "4 m"
    assert known["body.a.profile.radius"].value_in(CASE) == "4 m"


@pytest.mark.parametrize(
    ("table", "left"),
    [
        ({"kind": "crown", "radius": 4e3, "at": 9.0}, {"kind": "crown", "at": 9.0}),
        ({"kind": "logarithmic", "amplitude": 5e-3, "fraction": 0.9}, {"kind": "logarithmic", "fraction": 0.9}),
        ({"kind": "partial-crown", "radius": 1e3}, {"kind": "partial-crown", "radius": 1e3}),
        ({"kind": "partial-crown", "radius": 1e3, "straight": 9.0}, {"kind": "partial-crown", "straight": 9.0}),
    ],
)
def test_a_drop_takes_the_place_of_what_it_determines(table, left):
    case = {"body": {"a": {"profile": [table]}}}
    drop = list_parameters(case, CaseDocument)["body.a.profile.drop"]
    assert drop.put(case, 0.01)["body"]["a"]["profile"] == [left | {"drop": 0.01}]
    assert drop_before_parameters({"body.a.profile.radius": 1.0, "body.a.profile.drop": 2.0})[0] == (
        "body.a.profile.drop",
        2.0,
    )


@pytest.mark.parametrize(
    ("table", "name", "drop"),
    [
        ({"kind": "crown", "drop": 0.01}, "radius", "body.a.profile.drop"),
        ({"kind": "crown", "radius": 4e3}, "radius", ""),
        ({"kind": "crown", "drop": 0.01}, "shift", ""),
        ({"kind": "partial-crown", "drop": 0.01, "straight": 9.0}, "radius", "body.a.profile.drop"),
        ({"kind": "partial-crown", "drop": 0.01, "straight": 9.0}, "straight", ""),
        ({"kind": "partial-crown", "drop": 0.01, "radius": 1e3}, "straight", "body.a.profile.drop"),
    ],
)
def test_what_a_drop_determines_is_not_varied_beside_it(table, name, drop):
    case = {"body": {"a": {"profile": [table]}}}
    assert list_parameters(case, CaseDocument)[f"body.a.profile.{name}"].drop_beside(case) == drop


def test_tables_that_are_missing_are_made(known):
    assert known["solver.strips"].value_in(CASE) is None
    assert known["solver.strips"].put(CASE, 41)["solver"] == {"strips": 41}


def test_a_material_by_its_name_has_no_modulus_to_vary(known):
    assert "body.b.material.modulus" not in known
    assert "body.a.material.modulus" in known


def test_bearing_files_have_paths_too():
    document = {"bearing": {"kind": "cylindrical"}, "roller": {"profile": {"kind": "crown", "radius": 1e3}}}
    known = list_parameters(document, BearingFile)
    assert known["roller.profile.drop"].unit == "mm"
    assert known["fit.shaft.interference"].unit == "mm"
    assert known["bearing.rollers"].whole
    assert known["bearing.kind"].unit is None
    assert "roller.profile.kind" not in known
