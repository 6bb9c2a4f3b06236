"""The published JSON schemas, by a validator that knows nothing of the program."""

import copy
import json
import math
import tomllib
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import nonhertz as nh
from nonhertz.cli import main
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.schemas import KINDS, schema_of
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.toml import file_kind

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = sorted(EXAMPLES.glob("*.toml"))
# What Even Better TOML and its Taplo go by, and what the schemas are written in.
VALIDATORS = (jsonschema.Draft4Validator, jsonschema.Draft202012Validator)


def document(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / f"{name}.toml").read_text(encoding="utf-8"))


def mistakes(kind: str, found: Any) -> list[list[str]]:
    """Return the mistakes that each validator finds."""
    return [[error.message for error in each(schema_of(kind)).iter_errors(found)] for each in VALIDATORS]


@pytest.mark.parametrize("kind", KINDS)
def test_a_schema_is_one(kind, run, tmp_path):
    printed = run("schema", kind).out
    assert json.loads(printed) == schema_of(kind)
    jsonschema.Draft202012Validator.check_schema(schema_of(kind))
    for name, table in schema_of(kind).get("$defs", {}).items():
        for key, value in table.get("properties", {}).items():
            assert value.get("description") or key == "kind", f"{name}.{key}"
    file = tmp_path / "made" / f"{kind}.json"
    assert main(["schema", kind, "--out", str(file)]) == 0
    assert file.read_text(encoding="utf-8") == printed


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_examples_are_valid(file):
    found = tomllib.loads(file.read_text(encoding="utf-8"))
    assert mistakes(file_kind(found), found) == [[], []]


def test_so_are_changes_of_a_profile():
    found = document("crowned-roller")
    changes = {"shift": "20 um", "scale": 1.1, "flip": True, "drop": "9 um", "at": 8.0}
    found["body"]["a"]["profile"] = {"kind": "crown", **changes}
    assert mistakes("case", found) == [[], []]


def test_so_are_the_files_to_start_from():
    assert mistakes("case", tomllib.loads(starting_case())) == [[], []]
    assert mistakes("bearing", tomllib.loads(starting_bearing())) == [[], []]
    assert {file_kind(tomllib.loads(file.read_text(encoding="utf-8"))) for file in FILES} == {"case", "bearing", "plan"}


@pytest.mark.parametrize(
    ("name", "place", "value"),
    [
        ("crowned-roller", ("load", "laod"), 3.0),
        ("crowned-roller", ("load", "load"), [1, 2]),
        ("crowned-roller", ("body", "a", "lenght"), 20.0),
        ("crowned-roller", ("body", "a", "kind"), "wheel"),
        ("crowned-roller", ("body", "a", "profile"), {"kind": "crowned", "radius": 4000.0}),
        ("crowned-roller", ("body", "a", "profile"), {"kind": "crown", "radis": 4000.0}),
        ("crowned-roller", ("solver", "element"), "elliptic"),
        ("crowned-roller", ("body", "b"), None),
        ("nu206", ("bearing", "kind"), "ball"),
        ("nu206", ("bearing", "rollers"), "many"),
        ("nu206", ("load", "radail"), 1.0),
        ("roller-15x20-sweep", ("overs",), {}),
        ("roller-15x20-sweep", ("case",), None),
        ("roller-15x20-sweep", ("samples",), {"method": "guess"}),
        ("roller-15x20-design", ("design", "goal"), "beauty"),
    ],
)
def test_mistakes_are_found(name, place, value):
    whole = document(name)
    kind = file_kind(whole)
    *tables, last = place
    table = whole
    for key in tables:
        table = table.setdefault(key, {})
    if value is None:
        del table[last]
    else:
        table[last] = value
    for found in mistakes(kind, whole):
        assert found, place


@pytest.fixture(scope="module")
def results():
    """Return the results of all kinds of ends, of an approach, of both elements, and one that did not converge."""
    changes: list[tuple[str, dict[str, Any]]] = [
        *((name, {}) for name in ("crowned-roller", "measured-roller", "elliptical-point-contact")),
        ("crowned-roller", {"solver.element": "parabolic", "solver.strips": 31}),
        ("crowned-roller", {"solver.strips": 1}),
        ("crowned-roller", {"load.load": None, "load.approach": "5 um"}),
        ("crowned-roller", {"load.tilt": None, "load.moment": "10 N m"}),
        ("crowned-roller", {"load.load": "500 N", "load.tilt": "2 deg"}),  # one end alone is in contact: a remark
        ("roller-15x20", {"load.load": "100 kN", "body.a.side_faces": "mirror"}),
    ]
    found = []
    with without_accuracy_warnings():
        for name, each in changes:
            case = nh.read_case(EXAMPLES / f"{name}.toml", each)
            solution = case.solve()
            found.append(json.loads(nh.Result(case, solution).to_json()))
        object.__setattr__(solution, "status", nh.Status.STAGNATED)
        found.append(json.loads(nh.Result(case, solution).to_json()))
    return found


def test_every_result_is_valid(results):
    for result in results:
        assert mistakes("result", result) == [[], []], result["title"]
    kinds = {edge["kind"] for result in results for edge in result["edge_pressure"]}
    assert {"run-out", "singular"} <= kinds
    assert any(result["error_estimate"]["max_pressure"] is None for result in results)
    assert any("remarks" in result for result in results)


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("nu206", {"solver.method": "slices"}),
        ("nu206-mounted", {"solver.method": "slices"}),
        ("nu206-classes", {"solver.method": "slices"}),
        ("tapered-pair", {"solver.method": "slices", "load.radial": 0.0, "load.axial": None}),
        ("nu206", {"solver.method": "slices", "roller.material": "silicon-nitride"}),  # without a life
        pytest.param("nu206-mounted", {}, marks=pytest.mark.slow),
    ],
)
def test_every_result_of_a_bearing_is_valid(name, changes):
    case = nh.read_bearing(EXAMPLES / f"{name}.toml", changes)
    with without_accuracy_warnings():
        result = json.loads(nh.Result(case, case.solve()).to_json())
    assert mistakes("bearing-result", result) == [[], []]
    for key in result:
        less = {name: value for name, value in result.items() if name != key}
        assert all(mistakes("bearing-result", less)), key
    assert all(mistakes("bearing-result", result | {"more": 1}))
    assert all(mistakes("bearing-result", result | {"load": 1.0}))


def test_a_result_with_a_key_too_few_or_too_many_is_not(results):
    for key in results[0]:
        less = {name: value for name, value in results[0].items() if name != key}
        assert all(mistakes("result", less)), key
    for change in ({"more": 1}, {"status": "fine"}, {"y": "all"}, {"contact_y": [[1.0]]}, {"load": "20 kN"}):
        assert all(mistakes("result", results[0] | change)), change
    wrong = copy.deepcopy(results[0])
    wrong["edge_pressure"][0]["kind"] = "blunt"
    assert all(mistakes("result", wrong))


def test_what_python_writes_is_what_the_command_prints(capsys):
    file = EXAMPLES / "roller-15x20.toml"
    assert main(["solve", str(file), "--json"]) == 0
    case = nh.read_case(file)
    solution = case.solve()
    assert nh.Result(case, solution).to_json() + "\n" == capsys.readouterr().out
    assert math.isfinite(solution.load)
