"""The page's form: all of a case file is in it, and what is in it is the case file again."""

import copy
import json
import tomllib
from functools import cache
from pathlib import Path
from typing import Any, Literal

import jinja2
import pytest
from changed_documents import changed_documents
from form_reading import Inputs, document_in, parts_of, set_at, value_of
from hypothesis import given, settings

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.files.bearingfile import BEARING_TEMPLATES, starting_bearing
from nonhertz.files.casefile import TEMPLATES as TEMPLATES_OF_CASES
from nonhertz.files.casefile import Case, starting_case
from nonhertz.files.schemas import schema_of
from nonhertz.hertz import line_contact
from nonhertz.inputs.units import in_unit
from nonhertz.solver.one import solve
from nonhertz.web.form.form import form
from nonhertz.web.form.units import CHOICES, SLOPE
from nonhertz.web.view import jobs

TEMPLATES = jinja2.Environment(
    loader=jinja2.PackageLoader("nonhertz.web"), autoescape=True, undefined=jinja2.StrictUndefined
)
STARTING = tomllib.loads(starting_case())


@cache
def kinds() -> dict[str, dict[str, Any]]:
    """Return the schema of each kind of profile."""
    tables = schema_of("case")["$defs"]["Body"]["properties"]["profile"]["anyOf"][0]["anyOf"]
    return {table["properties"]["kind"]["const"]: table for table in tables}


def form_of(document: dict[str, Any], file: Literal["case", "bearing"] = "case") -> str:
    return TEMPLATES.get_template("form.html").render(form=form(document, file))


def as_text(document: Any) -> str:
    """Return a document so that equal text means equal values: 1, 1.0 and true are three things in a case file."""
    if isinstance(document, dict):
        return "{" + ", ".join(f"{json.dumps(key)}: {as_text(document[key])}" for key in sorted(document)) + "}"
    if isinstance(document, list):
        return "[" + ", ".join(map(as_text, document)) + "]"
    whole = isinstance(document, float) and document == int(document)
    return json.dumps(int(document) if whole else document)


def with_life() -> dict[str, Any]:
    document = copy.deepcopy(STARTING)
    document["life"] = {
        "rollers": 14,
        "models": ["lundberg-palmgren", "iso-16281"],
        "slope": 1.1,
        "fatigue_limit": "300 MPa",
        "laminae": 60,
        "edge_stress": "standard",
        "line_loads": "solution",
        "spectrum": [{"load": "20 kN", "tilt": "0.5 mrad", "share": 0.2}, {"load": 8000.0, "share": 0.8}],
    }
    return document


def every_kind() -> dict[str, Any]:
    """Return a document with a profile of each kind, each with all of its keys."""
    document = copy.deepcopy(STARTING)
    document["body"]["a"]["profile"] = [
        {name: kind if name == "kind" else some_value(part) for name, part in table["properties"].items()}
        for kind, table in kinds().items()
    ]
    return document


def some_value(part: dict[str, Any]) -> Any:
    """Return a value that a key may hold."""
    if part.get("type") == "array":
        return [1.5, 2.5, "3 mm"]
    if part.get("type") == "boolean":
        return False
    if part.get("type") == "string":
        return "some text"
    return part["enum"][0] if "enum" in part else 1.5


DOCUMENTS = {
    "starting case": STARTING,
    "life": with_life(),
    "every kind of profile": every_kind(),
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
        "solver": {"strips": 40, "element": "parabolic"},
    },
    "many points": {
        "body": {
            "a": {"profile": [{"kind": "tabulated", "y": [0.1 * n for n in range(99)], "relief": [1e-3 / 7] * 99}]}
        }
    },
    "keys that nobody knows": {
        "body": {"a": {"radus": 3, "odd key": "x", 'a "quoted".key[1]': [1, {"b": []}]}},
        "loads": {"load": 1},
        "life": {"spectrum": [{"laod": 1.0}]},
    },
    "kinds that nobody knows": {"body": {"a": {"kind": "rolle", "profile": [{"kind": "crow", "radius": 3}, {}, 5]}}},
    "wrong types": {
        "title": 3,
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
        "title": "<script>alert('&amp;')</script> \u2028 ü",
        "body": {"a": {"diameter": "1e5", "length": "[1]", "kind": "true", "material": "{}"}},
        "life": {"models": ["a b", "[", "3"]},
    },
    "large and small numbers": {"load": {"load": 1e300, "tilt": -1e-300, "moment": 123456789012345.0}},
}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_a_form_is_the_document_again(name):
    document = DOCUMENTS[name]
    assert as_text(document_in(form_of(document))) == as_text(document)


@settings(deadline=None, max_examples=30)
@given(changed_documents(with_life()))
def test_a_form_is_the_document_again_whatever_is_in_it(document):
    assert as_text(document_in(form_of(document))) == as_text(document)


def test_every_key_of_the_schema_is_in_the_form():
    document = every_kind() | {"life": with_life()["life"] | {"dent": {}}, "solver": {}, "report": {}}
    document["body"]["b"] |= {"diameter": {"y": [], "diameter": []}, "side_faces": ["mirror", "none"], "chamfer": {}}
    document["body"]["a"] |= {"chamfer": {}, "bore": {}}
    document["body"]["b"]["bore"] = {}
    document["body"]["b"]["profile"] = document["body"]["a"]["profile"]
    documents = [document, DOCUMENTS["tables for values"]]
    shown = {each["name"] for each in documents for each in Inputs(form_of(each)).fields}
    asked = set(keys_of(schema_of("case"), schema_of("case")["$defs"], ())) - {("format",)}
    assert asked - {plain_path(name) for name in shown} == set()


def plain_path(path: str) -> tuple[str, ...]:
    return tuple("" if isinstance(part, int) else part for part in parts_of(path))


def keys_of(part, definitions, place):
    """Yield the places of all keys of a schema; entries of lists are one place. Profiles are told apart by kind."""
    if "$ref" in part:
        part = definitions[part["$ref"].rpartition("/")[2]]
    for name, inner in part.get("properties", {}).items():
        yield (*place, name)
        yield from keys_of(inner, definitions, (*place, name))
    for inner in part.get("anyOf", ()):
        if place[-1:] != ("profile",) or inner.get("type") == "array":
            yield from keys_of(inner, definitions, place)
    if part.get("items", {}).get("type") != "number" and part.get("type") == "array":
        yield from keys_of(part["items"], definitions, (*place, ""))


@pytest.mark.parametrize("kind", [kind for kind, part in kinds().items() if "oneOf" in part])
def test_a_profile_can_be_switched_to_its_drop_and_back(kind):
    document = {"body": {"a": {"profile": [{"kind": kind}]}}}
    size = kinds()[kind]["oneOf"][0]["required"][0]
    for chosen, other in ((size, "drop"), ("drop", size), (size, "drop")):
        label = f"{size} or drop"
        (switch,) = (field for field in form(document).fields if field.label == label)
        (option,) = (option for option in switch.options if option.value == chosen)
        for path, value in option.edits:
            if value is not None or other in document["body"]["a"]["profile"][0]:
                set_at(document, path, value)
        shown = {field.path for field in form(document).fields}
        assert f"body.a.profile[1].{chosen}" in shown
        assert f"body.a.profile[1].{other}" not in shown
        assert other not in document["body"]["a"]["profile"][0]


@pytest.mark.slow
@pytest.mark.parametrize("number", range(3))
def test_every_choice_that_changes_the_form_leads_to_a_case_that_can_be_solved(number):
    """Nobody is to be met with a mistake that the page has made."""
    documents = [STARTING, DOCUMENTS["tables for values"] | {"title": "t"}, with_life()]
    document = copy.deepcopy(documents[number])
    if number == 1:
        document["body"]["a"] |= {"length": 20.0}
        document["body"]["b"] = {}
        document["load"] = {"load": 5000.0}
    options = [
        option for option in Inputs(form_of(document)).options if "data-edits" in option and "selected" not in option
    ]
    assert len(options) > 10
    for option in options:
        changed = copy.deepcopy(document)
        for path, value in json.loads(option["data-edits"]):
            if value is not None or path_exists(changed, path):
                set_at(changed, path, value)
        assert as_text(document_in(form_of(changed))) == as_text(changed)
        if option["value"] not in {"plate", "ring"}:  # the other body has to have a diameter then
            answer = json.loads(jobs.solve(changed, False, "a"))
            assert answer["ok"], (option["value"], answer["mistakes"])


def path_exists(document: Any, path: str) -> bool:
    for part in parts_of(path):
        if isinstance(document, dict) and part not in document:
            return False
        document = document[part]
    return True


def test_what_is_added_can_be_solved():
    found = Inputs(form_of(STARTING))
    additions = [option for option in found.options if "data-additions" in option["select"]]
    assert {json.loads(option["data-value"])["kind"] for option in additions} == set(kinds()) - {"measured"}
    for option in additions:
        document = copy.deepcopy(STARTING)
        document["body"]["b"]["profile"] = [json.loads(option["data-value"])]
        if option["value"].startswith("iso-"):
            continue  # they ask for a length and a diameter, which a plate has not
        answer = json.loads(jobs.solve(document, False, "a"))
        asks = [mistake["path"] for mistake in answer.get("mistakes", [])]
        assert answer["ok"] or asks == ["body.b.profile[1].length"], (option["value"], answer["mistakes"])


def field_of(path: str, value: Any) -> Any:
    fields = form(nested(path, value)).fields
    return next(field for field in fields if field.path == path and field.kind != "switch")


def nested(path: str, value: Any) -> dict[str, Any]:
    for part in reversed(path.split(".")):
        value = {part: value}
    return value


def chosen(field: Any) -> str:
    return str(field.word)


@pytest.mark.parametrize(
    ("path", "value", "text", "unit"),
    [
        ("load.load", 20000.0, "20", "kN"),
        ("load.load", 800, "800", "N"),
        ("load.load", "4.2 kN", "4.2", "kN"),
        ("load.load", "4500 lbf", "4500", "lbf"),
        ("load.load", "3 MN", "3", "MN"),
        ("load.tilt", 0.0005, "0.5", "mrad"),
        ("load.tilt", "2 arcmin", "2", "arcmin"),
        ("load.tilt", "0.5 um/mm", "0.5", "um/mm"),
        ("load.tilt", "8 um/25 mm", "8", "um/25 mm"),
        ("load.approach", 0.02, "20", "um"),
        ("load.moment", 5000.0, "5000", "N mm"),
        ("load.moment", 2.5e5, "250", "N m"),
        ("body.a.diameter", 15.0, "15", "mm"),
        ("body.a.diameter", "0.5 in", "0.5", "in"),
        ("body.a.length", "20 kg", "20 kg", "mm"),
        ("load.load", "a lot", "a lot", "N"),
    ],
)
def test_a_value_is_shown_in_the_unit_in_which_people_read_it(path, value, text, unit):
    field = field_of(path, value)
    assert (field.value, chosen(field)) == (text, unit)
    said = value_of(field.kind, text)
    if isinstance(said, float) and unit != field.unit:
        said = f"{text} {unit}"
    if isinstance(said, float | str) and text not in {"20 kg", "a lot"}:
        # What the field says is the value, even if it is written in another way.
        assert in_unit("x", said, field.unit) == pytest.approx(in_unit("x", value, field.unit))
    assert field.stands_for == ("" if said == value else json.dumps(value))


def test_sizes_of_units_are_those_of_files():
    for base, words in CHOICES.items():
        for word, factor in words.items():
            if word != SLOPE:
                assert in_unit("x", f"1 {word}", base) == pytest.approx(factor, rel=1e-12)
    assert in_unit("x", "1e-3 um/mm", "rad") == pytest.approx(1e-3 * CHOICES["rad"][SLOPE], rel=1e-9)


@pytest.mark.parametrize("name", [None, *TEMPLATES_OF_CASES])
def test_sliders_of_a_load_end_at_what_steel_bears(name):
    document = tomllib.loads(starting_case(name))
    contact = Case.of(document, Path("case.toml")).contact
    fields = {field.path: field.slider for field in form(document).fields if field.slider}
    low, high = contact.interval
    radius = 1.0 / float(contact.curvature(0.5 * (low + high)))
    load = fields["load.load"].high
    hertz = line_contact(line_load=load / (high - low), radius=radius, compliance=contact.compliance)
    # Where bodies are curved along the axis they touch along less of it.
    assert hertz.max_pressure < 1.1 * 3500.0
    if name in {None, "cylindrical", "needle"}:
        assert hertz.max_pressure == pytest.approx(3500.0, rel=0.1)
    if name not in {"spherical", "wheel-on-rail", "cam"}:
        flat, tilted = (
            solve(contact, load=0.3 * load, tilt=share * fields["load.tilt"].high).contact_y for share in (0.0, 1.0)
        )
        lifted = sum(end - begin for begin, end in flat) - sum(end - begin for begin, end in tilted)
        assert 0.05 < lifted / (high - low) < 0.3, "at the end of the slider the roller begins to lift off"
    stops = [each.high for each in (fields["load.load"], fields["load.tilt"])]
    assert all(float(f"{stop:.2g}") == stop for stop in stops)


@pytest.mark.parametrize("name", ["cylindrical", "needle", "tapered"])
def test_sliders_of_a_body_stay_on_it(name):
    document = tomllib.loads(starting_case(name))
    document["body"]["a"]["profile"][0]["drop"] = "10 um"
    sliders = {field.path: field.slider for field in form(document).fields if field.slider}
    assert "body.a.effective_length" not in sliders, "a body with corners has none"
    for key in ("profile[1].at", "corner_radius"):
        for value in (sliders[f"body.a.{key}"].low, sliders[f"body.a.{key}"].high):
            made = copy.deepcopy(document)
            set_at(made, f"body.a.{key}", value)
            answer = json.loads(jobs.solve(made, False, "a"))
            assert answer["ok"], (key, value, answer["mistakes"])


def test_a_form_of_a_bearing_is_the_document_again():
    for name in (None, *BEARING_TEMPLATES):
        document = tomllib.loads(starting_bearing(name))
        for changes in ({}, {"load": {"radial": ["8 kN", "x"], "tilt": [0.0, "1 mrad"], "moment": 5}}):
            changed = {key: value for key, value in (document | changes).items() if key != "format"}
            assert as_text(document_in(form_of(changed, "bearing"))) == as_text(changed), name


def test_every_key_of_a_bearing_is_in_its_form():
    shapes = [{"terms": [{}]}, {"angle": [], "deviation": []}, {"file": "x"}]
    tables = ("chamfer", "bore", "material", "diameter")
    body = {"profile": every_kind()["body"]["a"]["profile"], "side_faces": ["free", 1], **{key: {} for key in tables}}
    load = {name: [1, 2] for name in BearingLoad.descriptions}
    document = {"roller": body, "inner": body, "outer": body, "load": load, "life": {"spectrum": [load]}}
    document |= {"fit": {"shaft": {"material": {}}, "housing": {"material": {}}}}
    rows = [{"kind": kind, "rib": {}, "inner_shape": shapes, "outer_shape": shapes} for kind in RollerBearing.kinds]
    rows += [{"inner_shape": shape, "outer_shape": shape, "pair": {}} for shape in shapes]
    documents = [document | {"bearing": row} for row in rows] + [
        {"bearing": {}, "load": {}, "life": {"spectrum": [{}]}}
    ]
    shown = {each["name"] for each in documents for each in Inputs(form_of(each, "bearing")).fields}
    asked = set(keys_of(schema_of("bearing"), schema_of("bearing")["$defs"], ()))
    optional = {("format",), ("fit",), ("solver",), ("report",), ("bearing", "pair")}  # tables themselves
    assert asked - {plain_path(name) for name in shown} - optional == set()
