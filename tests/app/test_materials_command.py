"""``nonhertz materials``: the library as a table, as JSON, and one material with its source."""

import jsonschema

import nonhertz as nh
from nonhertz.files.schemas import schema_of
from nonhertz.model.materials import LIBRARY


def test_all_materials_are_listed_in_their_groups(run):
    lines = run("materials").out.splitlines()
    rows = {line.split(" ")[2].rstrip(","): line for line in lines[1:] if line.startswith("  ")}
    assert list(rows) == [each.name for each in LIBRARY]
    assert rows["EN-GJS-600-3"].split() == ["EN-GJS-600-3", "174000", "0.275", "370"]
    assert rows["100Cr6"].split() == ["100Cr6,", "52100", "210000", "0.3", "58", "HRC", "4000"]
    assert "rail steels" in [line.strip() for line in lines]


def test_one_material_says_where_its_numbers_come_from(run):
    shown = run("materials", "PA66").out
    assert "source: DuPont, Zytel 103HSL" in shown
    assert "note: viscoelastic" in shown
    assert "note" not in run("materials", "steel").out


def test_the_json_holds_every_number_and_source(run):
    found = run("materials", "--json").json
    jsonschema.validate(found, schema_of("materials"))
    assert list(found["materials"]) == [each.name for each in LIBRARY]
    rail = found["materials"]["R260"]
    assert rail["hardness"] == "260 HBW"
    assert rail["yield_strength"] is None
    assert "EN 13674-1" in rail["source"]
    assert found["materials"]["X105CrMo17"]["modulus"] == nh.MATERIALS["440C"].modulus
