"""What the page's form takes from the program: a schema with hints, units, and what follows from the geometry."""

import copy
import json
import tomllib
from pathlib import Path

import pytest
from changed_documents import changed_documents
from hypothesis import given, settings

from nonhertz.files.casefile import Case
from nonhertz.files.starting import TEMPLATES as TEMPLATES_OF_CASES
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.hertz import line_contact
from nonhertz.inputs.units import to_unit
from nonhertz.solver.one import solve
from nonhertz.web.form.ranges import form_state
from nonhertz.web.form.schema import form_schema
from nonhertz.web.form.units import CHOICES, SLOPE
from nonhertz.web.view import jobs

FILES = {"case": tomllib.loads(starting_case()), "bearing": tomllib.loads(starting_bearing())}


def tables_of(part):
    """Yield all tables of a schema."""
    if isinstance(part, dict):
        if isinstance(part.get("properties"), dict):
            yield part
        for inner in part.values():
            yield from tables_of(inner)
    for inner in part if isinstance(part, list) else ():
        yield from tables_of(inner)


@pytest.mark.parametrize("file", FILES)
def test_hints_of_a_schema_are_of_its_own_keys(file):
    schema = form_schema(file)
    tables = list(tables_of({name: part for name, part in schema.items() if name != "x-examples"}))
    for table in tables:
        keys = set(table["properties"])
        kinds = table.get("x-kinds", {})
        assert keys >= {name for group in (*table.get("x-pairs", ()), *table.get("x-apart", ())) for name in group}
        assert all(keys >= {*kind["keys"], *kind["needed"]} for kind in kinds.values())
        assert set(kinds) == set(table["properties"]["kind"]["enum"] if kinds else ())
    hinted = {hint for table in tables for part in (table, *table["properties"].values()) for hint in part}
    assert {"x-pairs", "x-apart", "x-kinds", "x-words", "x-names", "x-single"} <= hinted


def test_of_every_profile_that_a_drop_may_size_one_key_is_its_pair():
    profiles = [each for each in tables_of(form_schema("case")) if "oneOf" in each]
    assert profiles
    for each in profiles:
        assert each["x-pairs"] == [(each["oneOf"][0]["required"][0], "drop")]


def test_a_profile_has_sizes_of_which_each_begins_in_place_of_another():
    sizes = form_state(FILES["case"], "case")["bodies"]["body.a"]["sizes"]
    (profile,) = FILES["case"]["body"]["a"]["profile"]
    assert sizes["amplitude"] == profile["amplitude"]
    assert sizes["drop"] > profile["amplitude"]


@settings(deadline=None, max_examples=30)
@given(changed_documents(FILES["case"]))
def test_any_document_has_a_state(document):
    json.dumps(form_state(document, "case"), allow_nan=False)
    json.dumps(form_state(document, "bearing"), allow_nan=False)


@pytest.mark.parametrize("file", FILES)
def test_what_is_warned_of_stands_in_the_answer_alone(file):
    """The form, which is asked of the same document, warns of nothing: the terminal of the server stays empty."""
    document = copy.deepcopy(FILES[file])
    body = document["body"]["a"] if file == "case" else document["inner"]
    body["material"] = {"modulus": 207.0, "poisson": 0.3}
    document["load"]["load" if file == "case" else "radial"] = 10.0
    answer = jobs.solve(document, False, "a") if file == "case" else jobs.load(document, "slices")
    assert json.loads(answer)["warnings"][0].startswith("A modulus of 207 MPa with a Poisson's ratio of 0.3")
    form_state(document, file)


def test_sizes_of_units_are_those_of_files():
    for base, words in CHOICES.items():
        for word, factor in words.items():
            if word != SLOPE:
                assert to_unit("x", f"1 {word}", base) == pytest.approx(factor, rel=1e-12)
    assert to_unit("x", "1e-3 um/mm", "rad") == pytest.approx(1e-3 * CHOICES["rad"][SLOPE], rel=1e-9)


@pytest.mark.parametrize("name", [None, *TEMPLATES_OF_CASES])
def test_sliders_of_a_load_end_at_what_steel_bears(name):
    document = tomllib.loads(starting_case(name))
    contact = Case.of(document, Path("case.toml")).contact
    ranges = form_state(document, "case")["ranges"]
    low, high = contact.interval
    radius = 1.0 / float(contact.curvature(0.5 * (low + high)))
    load = ranges["load"]["high"]
    hertz = line_contact(line_load=load / (high - low), radius=radius, compliance=contact.compliance)
    # Where bodies are curved along the axis they touch along less of it.
    assert hertz.max_pressure < 1.1 * 3500.0
    if name in {None, "cylindrical", "needle"}:
        assert hertz.max_pressure == pytest.approx(3500.0, rel=0.1)
    if name not in {"spherical", "wheel-on-rail", "cam"}:
        flat, tilted = (
            solve(contact, load=0.3 * load, tilt=share * ranges["tilt"]["high"]).contact_y for share in (0.0, 1.0)
        )
        lifted = sum(end - begin for begin, end in flat) - sum(end - begin for begin, end in tilted)
        assert 0.05 < lifted / (high - low) < 0.3, "at the end of the slider the roller begins to lift off"
    assert all(float(f"{stop:.2g}") == stop for stop in (load, ranges["tilt"]["high"]))


@pytest.mark.parametrize("name", ["cylindrical", "needle", "tapered"])
def test_sliders_of_a_body_stay_on_it(name):
    document = tomllib.loads(starting_case(name))
    document["body"]["a"]["profile"][0]["drop"] = "10 um"
    ranges = form_state(document, "case")["bodies"]["body.a"]["ranges"]
    for key in ("at", "corner_radius"):
        for value in (ranges[key]["low"], ranges[key]["high"]):
            made = copy.deepcopy(document)
            body = made["body"]["a"]
            (body["profile"][0] if key == "at" else body)[key] = value
            answer = json.loads(jobs.solve(made, False, "a"))
            assert answer["ok"], (key, value, answer["mistakes"])
