"""Plan files: what they hold, and all their mistakes at once."""

from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.files.planfile import Plan, read_any, read_design, read_plan, starting_plan
from nonhertz.files.spreads import Distribution
from nonhertz.files.starting import starting_case
from nonhertz.files.toml import is_plan


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "case.toml").write_text(starting_case(), encoding="utf-8")
    return tmp_path


def plan(folder: Path, text: str) -> Path:
    path = folder / "plan.toml"
    path.write_text(f'case = "case.toml"\n{text}', encoding="utf-8")
    return path


def test_a_plan_holds_what_its_case_is_varied_over(folder):
    found = read_plan(
        plan(
            folder,
            """
title = "A study"
quantities = ["max_pressure"]
[over]
"load.load" = "5 kN : 15 kN : 3"
load.tilt = [0, "0.5 mrad"]
"body.a.diameter" = "normal(nominal, 5 um)"
[samples]
count = 7
method = "sobol"
seed = 3
""",
        )
    )
    assert found.title == "A study"
    assert found.quantities == ("max_pressure",)
    assert found.spreads["load.load"] == (5e3, 10e3, 15e3)
    assert found.spreads["load.tilt"] == (0.0, 0.5e-3)
    assert isinstance(found.spreads["body.a.diameter"], Distribution)
    assert (found.samples.count, found.samples.method, found.samples.seed) == (7, "sobol", 3)


def test_a_plan_is_written_with_the_way_to_its_case(folder):
    made = Plan(
        read_any(folder / "case.toml"),
        over={"load.load": "5 kN : 15 kN : 3", "load.tilt": np.array([0.0, 0.5e-3])},
        quantities=["max_pressure"],
        title="A study",
    )
    assert made.document["over"] == {"load.load": "5 kN : 15 kN : 3", "load.tilt": [0.0, 0.5e-3]}
    (folder / "studies").mkdir()
    made.write(folder / "studies" / "plan.toml")
    found = read_plan(folder / "studies" / "plan.toml")
    assert found.document["case"] == "../case.toml"
    assert 'title = "A study"' in found.text
    assert (found.title, found.quantities, found.samples) == (made.title, made.quantities, made.samples)
    assert found.spreads == made.spreads
    assert found.case == made.case


TABLES = ("over", "tolerance", "vary")


def test_the_plan_to_start_from_goes_with_the_case_to_start_from(folder):
    path = folder / "plan.toml"
    path.write_text(starting_plan(), encoding="utf-8")
    (folder / "studies").mkdir()
    read_plan(path, "tolerance").write(folder / "studies" / "same.toml")
    for table in TABLES[:2]:
        assert read_plan(path, table).over == read_plan(folder / "studies" / "same.toml", table).over != {}
    case, asked = read_design(path)
    assert read_design(folder / "studies" / "same.toml")[1]["bounds"] == asked["bounds"]
    assert case.title == nh.read_case(folder / "case.toml").title
    assert list(asked["bounds"]) == ["body.a.profile.amplitude"]


def test_the_plan_of_the_reference_is_one(tmp_path):
    text = starting_case("cylindrical").replace("diameter = 10.0", "diameter = 20.0")
    (tmp_path / "roller.toml").write_text(text, encoding="utf-8")
    reference = (Path(__file__).parents[2] / "docs" / "reference" / "plan-file.md").read_text(encoding="utf-8")
    path = tmp_path / "plan.toml"
    path.write_text(reference.partition("```toml\n")[2].partition("```")[0], encoding="utf-8")
    assert read_plan(path).spreads["load.tilt"] == (0.0, 0.5e-3, 1e-3)
    assert len(read_plan(path, "tolerance").spreads) == 4
    assert read_design(path)[1]["goal"] == "life"


def test_a_missing_case_is_named_beside_other_mistakes(tmp_path):
    path = tmp_path / "plan.toml"
    path.write_text('case = "no.toml"\n[design]\nloads = [{ lod = 1 }]\n', encoding="utf-8")
    with pytest.raises(nh.CaseError) as caught:
        read_plan(path)
    first, second = caught.value.mistakes
    assert "lod" in first
    assert second.startswith(f"{tmp_path / 'no.toml'} must exist")


def test_all_mistakes_are_listed_at_once(folder):
    text = """
[over]
"load.laod" = "5 kN : 15 kN : 3"
load.tilt = []
"body.a.length" = "normal(20 mm, 10 mm)"
"body.b.material" = ["steel", "stele"]
"body.a.material" = [5.0]
"body.a.profile" = [[{ kind = "straight" }]]
"""
    with pytest.raises(nh.CaseError) as caught:
        read_plan(plan(folder, text))
    said = caught.value.mistakes
    assert len(said) == 6
    for sentence, words in zip(
        sorted(said),
        (
            "Unknown key over.load.laod. Did you mean over.load.load?",
            "over.body.a.length = 'normal(20 mm, 10 mm)' must be valid in the case (at -40.000 mm: ",
            "over.body.a.material = [5.0] must be a word, or true or false",
            "over.body.a.profile = [[{'kind': 'straight'}]] must be a word, or true or false",
            "over.body.b.material = ['steel', 'stele'] must be valid in the case (at stele: ",
            "over.load.tilt = [] must hold values",
        ),
        strict=True,
    ):
        assert sentence.startswith(words)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("[samples]\ncount = 0", "samples.count = 0 must be a whole number from 1"),
        ('[samples]\nmethod = "sobl"', "samples.method = 'sobl' must be one of"),
        ("[ovre]\n", "Unknown key ovre. Did you mean over?"),
        ('quantities = "approach"', "quantities = 'approach' must be names"),
        ("over = 3", "over = 3 must be a table"),
    ],
)
def test_what_is_wrong_elsewhere_is_said_in_one_sentence(folder, text, sentence):
    with pytest.raises(nh.CaseError) as caught:
        read_plan(plan(folder, text))
    (said,) = caught.value.mistakes
    assert said.startswith(sentence)


def test_mistakes_of_the_case_are_named_with_its_file(folder):
    (folder / "case.toml").write_text("[body.a]\ndiameter = -1\n", encoding="utf-8")
    with pytest.raises(nh.CaseError) as caught:
        read_plan(plan(folder, '[over]\n"load.load" = [1.0]'))
    assert all("case.toml: " in sentence for sentence in caught.value.mistakes)


def test_plans_and_cases_are_told_apart():
    assert is_plan({"case": "x"})
    assert is_plan({"over": {}})
    assert not is_plan({"body": {}})


def test_values_that_exclude_each_other_are_refused_before_the_work_starts(folder):
    case = read_any(folder / "case.toml")
    with pytest.raises(nh.InputError, match="not be given together with"):
        Plan(case, over={"load.approach": ["10 um"]})
