"""The form: all that a file may hold is in it, and what it does to a document can be solved."""

import copy
import json
import re
import tomllib
from typing import Any

import pytest
from desk import Desk, packed, unpacked

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.files.schemas import schema_of
from nonhertz.files.starting import BEARING_TEMPLATES, starting_bearing, starting_case

pytestmark = pytest.mark.browser

STARTING = tomllib.loads(starting_case())


def profiles() -> dict[str, dict[str, Any]]:
    """Return the schema of each kind of profile."""
    tables = schema_of("case")["$defs"]["Body"]["properties"]["profile"]["anyOf"][0]["anyOf"]
    return {table["properties"]["kind"]["const"]: table for table in tables}


def some_value(part: dict[str, Any]) -> Any:
    """Return a value that a key may hold."""
    if part.get("type") == "array":
        return [1.5, 2.5, "3 mm"]
    if part.get("type") == "boolean":
        return False
    return part["enum"][0] if "enum" in part else "some text" if part.get("type") == "string" else 1.5


EVERY_KIND = [
    {name: kind if name == "kind" else some_value(part) for name, part in table["properties"].items()}
    for kind, table in profiles().items()
]
DOCUMENTS = {
    "nothing": {},
    "empty tables": {"body": {"a": {}, "b": {"profile": []}}, "load": {}, "life": {"spectrum": [{}]}},
    "one table for a profile": {"body": {"a": {"profile": {"kind": "crown", "radius": "4 m"}}}},
    "tables for values": {
        "body": {
            "a": {
                "diameter": {"y": [-10.0, 10.0], "diameter": [20.0, "21 mm"]},
                "material": {"modulus": "207 GPa", "poisson": 0.3},
                "side_faces": ["mirror", 1.6],
                "images": "series",
                "depth": "8 mm",
            },
            "b": {"side_faces": 1.2, "images": 3, "depth": 8.0, "position": "1 cm"},
        },
        "load": {"approach": 0.02, "moment": -5e4},
    },
    "many points": {
        "body": {"a": {"profile": [{"kind": "tabulated", "y": [0.1 * n for n in range(99)], "relief": [1e-3] * 99}]}}
    },
    "keys that nobody knows": {
        "body": {"a": {"radus": 3, "odd key": "x", 'a "quoted".key[1]': [1, {"b": []}]}},
        "loads": {"load": 1},
        "life": {"spectrum": [{"laod": 1.0}]},
    },
    "kinds that nobody knows": {"body": {"a": {"kind": "rolle", "profile": [{"kind": "crow", "radius": 3}, {}, 5]}}},
    "wrong types": {
        "body": {
            "a": {"diameter": "20", "length": True, "kind": 1, "profile": "crown", "material": ["steel"]},
            "b": {"position": {"y": 1}, "side_faces": ["mirror", "none", 3], "images": [], "depth": {}, "diameter": ""},
        },
        "load": [1, 2],
        "solver": "auto",
        "life": {"spectrum": {"load": 1}, "models": "weibull", "rollers": "a dozen", "slope": " 1.1 "},
    },
    "both of a pair": {"load": {"load": 1.0, "approach": 1.0, "tilt": "x", "moment": False}},
    "text that looks like something else": {
        "body": {"a": {"diameter": "1e5", "length": "[1]", "kind": "true", "material": "{}"}},
        "life": {"models": ["a b", "[", "3"]},
    },
    "every kind of profile": {"body": {"a": {"profile": EVERY_KIND}}},
}


def kept(desk: Desk) -> dict[str, Any]:
    """Return the document that the address of the page holds, once it has a new title."""
    desk.type(desk.field("title"), "another title")
    for _ in range(50):
        document = unpacked(desk.page.evaluate("() => location.hash").removeprefix("#c=").partition("&")[0])
        if document.get("title") == "another title":
            break
        desk.page.wait_for_timeout(100)
    return document


@pytest.mark.parametrize("name", DOCUMENTS)
def test_nothing_of_a_document_is_lost_in_its_form(open_desk, name):
    desk = open_desk(f"contact#c={packed(DOCUMENTS[name])}")
    assert kept(desk) == DOCUMENTS[name] | {"title": "another title"}


def names(desk: Desk) -> set[str]:
    """Return the paths of all fields and groups, without the numbers of entries."""
    shown = desk.page.locator("#case [data-path], #case [data-group]")
    paths = shown.evaluate_all("all => all.map((each) => each.dataset.path ?? each.dataset.group)")
    return {re.sub(r"\[\d+\]", "", path) for path in paths}


def keys_of(part: Any, definitions: Any, path: str) -> Any:
    """Yield the paths of all keys of a schema."""
    if "$ref" in part:
        part = definitions[part["$ref"].rpartition("/")[2]]
    for name, inner in part.get("properties", {}).items():
        yield f"{path}.{name}".removeprefix(".")
        yield from keys_of(inner, definitions, f"{path}.{name}")
    for inner in part.get("anyOf", ()):
        if not path.endswith(".profile") or inner.get("type") == "array":
            yield from keys_of(inner, definitions, path)
    if part.get("type") == "array" and part.get("items", {}).get("type") != "number":
        yield from keys_of(part["items"], definitions, path)


def test_every_key_of_a_case_is_in_the_form(open_desk):
    body = {"profile": EVERY_KIND, "side_faces": ["mirror", "none"], "diameter": {}, "bore": {}, "material": {}}
    life = {"spectrum": [{}], "dent": {}}
    documents = [
        {"body": {name: body | {"chamfer": {}} for name in "ab"}, "life": life, "load": {"load": 1, "tilt": 1}},
        {"body": {name: {"corner_radius": 1, "length": 1} for name in "ab"}, "load": {"approach": 1, "moment": 1}},
        {"body": {name: {"effective_length": 1, "depth": "finite"} for name in "ab"}},
    ]
    shown = {path for each in documents for path in names(open_desk(f"contact#c={packed(each)}"))}
    asked = set(keys_of(schema_of("case"), schema_of("case")["$defs"], "")) - {"format"}
    assert asked - shown == set()


def test_every_key_of_a_bearing_is_in_the_form(open_desk):
    shapes = [{"terms": [{}]}, {"angle": [], "deviation": []}, {"file": "x"}]
    tables = {key: {} for key in ("chamfer", "bore", "material", "diameter", "corner_radius", "effective_length")}
    body = {"profile": EVERY_KIND, "side_faces": ["free", 1], "length": 1, **tables}
    load = {name: [1, 2] for name in BearingLoad.descriptions}
    document = {"roller": body, "inner": body, "outer": body, "load": load, "life": {"spectrum": [load]}}
    document |= {"fit": {"shaft": {"material": {}}, "housing": {"material": {}}}}
    rows = [{"kind": kind, "rib": {}, "inner_shape": shapes, "outer_shape": shapes} for kind in RollerBearing.kinds]
    rows += [{"pair": {}, **{f"{ring}_shape": shape for ring in ("inner", "outer")}} for shape in shapes]
    documents = [document | {"bearing": row} for row in rows] + [{"lubrication": {"oil": "ISO VG 68"}}]
    shown = {path for each in documents for path in names(open_desk(f"bearing#c={packed(each)}"))}
    asked = set(keys_of(schema_of("bearing"), schema_of("bearing")["$defs"], "")) - {"format"}
    assert asked - shown == set()


def test_what_a_bearing_cannot_have_is_not_offered(open_desk):
    offered = {
        name: names(open_desk(f"bearing#c={packed(tomllib.loads(starting_bearing(name)))}"))
        for name in BEARING_TEMPLATES
        if name in {"cylindrical", "thrust"}
    }
    assert "fit" in offered["cylindrical"]
    assert "fit" not in offered["thrust"]
    assert not {"inner.diameter", "outer.diameter"} & offered["thrust"]
    assert "inner.diameter" in offered["cylindrical"]


OTHERS = """all => all.flatMap((each, at) => [...each.options].map((option) => option.value)
    .filter((value) => value && value !== each.value).map((value) => [at, value]))"""


@pytest.mark.slow
def test_every_choice_that_changes_the_form_leads_to_a_case_that_can_be_solved(desk):
    """Nobody is to be met with a mistake that the page has made."""
    desk.page.evaluate("() => document.querySelectorAll('#case details').forEach((each) => (each.open = true))")
    selects = desk.page.locator('#case select[data-structure], #case select[name$=".kind"]')
    choices = selects.evaluate_all(OTHERS)
    assert len(choices) > 20
    for at, value in choices:
        before = desk.answers
        selects.nth(at).select_option(value)
        desk.wait_for_answer(before)
        if value not in {"plate", "ring"}:  # the other body has to have a diameter then
            assert desk.mistakes == [], value
        desk.page.locator("#undo:enabled").wait_for()
        desk.press("#undo")
        assert desk.mistakes == []


def test_a_profile_is_switched_to_its_drop_and_back(desk):
    pressure = desk.numbers["Maximum pressure"]
    for before, after in (("amplitude", "drop"), ("drop", "amplitude")):
        answers = desk.answers
        desk.page.locator(f'.field[data-path="body.a.profile[1].{before}"] select.swap').select_option(after)
        desk.wait_for_answer(answers)
        assert desk.field(f"body.a.profile[1].{before}").count() == 0
        assert desk.mistakes == []
        # It begins with the size that the profile has, to four figures.
        assert desk.numbers["Maximum pressure"] == pytest.approx(pressure, rel=1e-3)


@pytest.mark.slow
def test_what_is_added_can_be_solved(desk):
    kinds = desk.page.locator('[data-additions="body.b.profile"] option').all_text_contents()
    assert set(kinds) == set(profiles()) - {"measured"}
    for kind in kinds:
        if kind.startswith("iso-"):
            continue  # they ask for a length and a diameter, which a plate has not
        desk.page.locator('[data-additions="body.b.profile"]').select_option(kind)
        desk.press('[data-action="add"][data-path="body.b.profile"]')
        assert desk.mistakes == [] or ", length must be given" in desk.mistakes[0], kind
        desk.press('[data-action="remove"][data-path="body.b.profile[1]"]')


def shown(desk: Desk, path: str, value: Any) -> tuple[str, str]:
    """What a field shows of a value, and in which unit."""
    document = copy.deepcopy(STARTING)
    *way, last = path.split(".")
    table = document
    for key in way:
        table = table[key]
    table.clear()
    table[last] = value
    before = desk.page.evaluate("() => location.hash")
    desk.page.evaluate("hash => { location.hash = hash; }", f"#c={packed(document)}")
    desk.page.wait_for_function("before => location.hash !== before", arg=before)
    text = desk.field(path)
    desk.page.wait_for_function(
        "([path, value]) => document.querySelector(`#case [name='${path}']`)?.value === value",
        arg=[path, SHOWN[path, json.dumps(value)][0]],
    )
    return text.input_value(), desk.page.locator(f'.field[data-path="{path}"] select.unit').input_value()


SHOWN = {
    (path, json.dumps(value)): (text, unit)
    for path, value, text, unit in (
        ("load.load", 20000.0, "20", "kN"), ("load.load", 800, "800", "N"), ("load.load", "4.2 kN", "4.2", "kN"),
        ("load.load", "4500 lbf", "4500", "lbf"), ("load.load", "3 MN", "3 MN", "N"),
        ("load.tilt", 0.0005, "0.5", "mrad"), ("load.tilt", "2 arcmin", "2", "arcmin"),
        ("load.tilt", "0.5 um/mm", "0.5", "um/mm"), ("load.approach", 0.02, "20", "um"),
        ("load.moment", 5000.0, "5000", "N mm"), ("load.moment", 2.5e5, "250", "N m"),
        ("body.a.diameter", 15.0, "15", "mm"), ("body.a.diameter", "0.5 in", "0.5", "in"),
        ("body.a.length", "20 kg", "20 kg", "mm"), ("load.load", "a lot", "a lot", "N"),
    )
}  # fmt: skip


def test_a_value_is_shown_in_the_unit_in_which_people_read_it(open_desk):
    desk = open_desk("contact")
    for (path, value), expected in SHOWN.items():
        assert shown(desk, path, json.loads(value)) == expected
