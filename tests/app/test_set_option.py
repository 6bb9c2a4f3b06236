"""``--set``: values in place of those in a file, on every command that reads one."""

import tomllib
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.files.changes import parse_changes

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = str(EXAMPLES / "crowned-roller.toml")
TITLE = "Roller 20 x 20 on a plate"


def refused(run, *words: str) -> str:
    printed = run(*words, code=2)
    return printed.err + printed.out


def test_a_value_counts_as_if_the_file_held_it(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    text = Path(CASE).read_text(encoding="utf-8")
    assert "load = 20000.0" in text
    assert "radius = 4000.0" in text
    edited = text.replace("load = 20000.0", 'load = "5 kN"').replace("radius = 4000.0", 'radius = "2 m"')
    Path("edited.toml").write_text(edited, encoding="utf-8")
    expected = run("solve", "edited.toml", "--json").json
    found = run("solve", CASE, "--set", "load.load=5kN", "--set", "body.a.profile.radius=2m", "--json").json
    assert found["title"] == TITLE
    assert found["load"] == pytest.approx(5000.0, rel=1e-12)
    for name in ("max_pressure", "approach", "line_load", "edges"):
        assert found[name] == expected[name], name
    assert found["case"]["load"] == expected["case"]["load"]


@pytest.mark.parametrize(
    "words",
    [
        (CASE, "--set", "load.load=5kN", "load.tilt=1mrad"),
        ("--set", "load.load=5kN", "load.tilt=1mrad", CASE),
        ("--set", "load.load=5kN", "load.tilt=1mrad", "--", CASE),
    ],
)
def test_several_may_follow_one_option(words, run):
    found = run("solve", "--json", *words).json
    assert (found["load"], found["tilt"]) == pytest.approx((5000.0, 1e-3))


def test_a_file_whose_name_looks_like_a_change_is_a_file(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    Path("load=low.toml").write_text(Path(CASE).read_text(encoding="utf-8"), encoding="utf-8")
    assert run("solve", "--json", "--set", "load.load=5kN", "load=low.toml").json["load"] == pytest.approx(5000.0)


@pytest.mark.parametrize("words", [("load.approach=20um",), ("load.approach=20um", "load.load=")])
def test_a_key_makes_room_for_what_is_given_in_its_place(words, run):
    found = run("solve", CASE, "--set", *words, "--json").json
    assert found["approach"] == 0.02
    assert "load" not in found["case"]["load"]


def test_a_parameter_takes_the_place_of_the_drop_that_determines_it():
    dropped = nh.read_case(CASE, {"body.a.profile.drop": "12 um"})
    assert dropped.origin is not None
    case = type(dropped).of(dropped.document, Path(CASE), changes={"body.a.profile.radius": "2 m"})
    assert case.document["body"]["a"]["profile"] == [{"kind": "crown", "radius": "2 m"}]


def test_values_may_be_numbers_words_lists_and_tables():
    words = ["solver.strips=41", 'body.a.side_faces=["calibrated", 1.2]', "solver.element=parabolic", "load.tilt=0"]
    assert parse_changes(words) == {
        "solver.strips": 41,
        "body.a.side_faces": ["calibrated", 1.2],
        "solver.element": "parabolic",
        "load.tilt": 0,
    }
    case = nh.read_case(CASE, parse_changes([*words, 'body.a.profile=[{kind="crown", radius="1 m"}]']))
    assert (case.solver.strips, case.solver.element, case.prescribed.tilt) == (41, "parabolic", 0.0)
    assert case.document["body"]["a"]["profile"] == [{"kind": "crown", "radius": "1 m"}]


def test_what_was_set_is_in_the_text_of_the_case():
    case = nh.read_case(CASE, {"load.load": "5 kN", "load.tilt": None})
    assert case.text.startswith("# Set in place of what the file held: load.load = 5 kN, without load.tilt\n")
    assert tomllib.loads(case.text) == case.document
    assert nh.read_case(CASE).prescribed.load == 20000.0


def test_a_path_that_leads_nowhere_names_the_nearest_all_at_once(run):
    said = refused(run, "solve", CASE, "--set", "load.laod=5kN", "--set", "body.a.profile.radus=1m")
    assert said.splitlines() == [
        "1. Unknown key load.laod. Did you mean load.load?",
        "2. Unknown key body.a.profile.radus. Did you mean body.a.profile.radius?",
    ]


@pytest.mark.parametrize("path", ["body.a.profile.kind", "body.a.profile[1].kind"])
def test_a_kind_of_profile_is_set_with_the_whole_profile(path):
    with pytest.raises(nh.CaseError, match=r"come with the keys of the kind: set 'body.a.profile' to a table"):
        nh.read_case(CASE, {path: "straight"})
    case = nh.read_case(CASE, {"body.a.profile": {"kind": "crown", "radius": 2000}})
    assert case.contact.a.profile.relief(10.0) == pytest.approx(10.0**2 / 4000.0, rel=1e-4)


def test_a_part_of_a_named_material_is_set_in_a_table_in_place_of_the_name():
    named = {"body.a.material": "100Cr6"}
    with pytest.raises(
        nh.CaseError, match=r"'body.a.material' is one word in this file; set that .* with 'modulus' in"
    ):
        nh.read_case(CASE, named | {"body.a.material.modulus": 210e3})
    case = nh.read_case(CASE, {"body.a.material": {"modulus": "210 GPa", "poisson": 0.3}})
    assert case.contact.a.material.modulus == 210e3


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("load.load=5mm", "load.load = '5mm' must have a unit of force"),
        ("load.load=-5kN", "load.load = '-5kN' must be positive"),
        ("body.a.length=0", "body.a.length = 0.0 must be positive"),
        ("body.a.profile=crown", "body.a.profile = 'crown' must"),
        ("load.load", "--set = 'load.load' must have an equals sign"),
        ("=5", "--set = '=5' must have an equals sign"),
    ],
)
def test_values_go_through_all_checks_of_the_file(word, expected, run):
    assert expected in refused(run, "solve", CASE, "--set", word)


def test_a_path_is_set_once(run):
    said = refused(run, "solve", CASE, "--set", "load.load=5kN", "--set", "load.load=6kN")
    assert "must set each path once" in said


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            "load.load=1e30kN",
            "load.load = '1e30kN' must leave the contact narrower than the bodies: check its unit, or",
        ),
        ("load.approach=-1mm", "load.approach = '-1mm' must exceed "),
        ("load.moment=1e9N m", "load.moment = '1e9N m' must keep moment / load between "),
    ],
)
def test_what_the_solver_refuses_is_shown_as_it_was_typed(run, change, said):
    assert refused(run, "solve", CASE, "--set", change).startswith(said)


def test_a_file_with_mistakes_is_read_to_the_end(tmp_path, run):
    broken = tmp_path / "broken.toml"
    broken.write_text("body = 3\nload = 4\n", encoding="utf-8")
    assert "Unknown key load.load: " in refused(run, "check", str(broken), "--set", "load.load=5kN")
    misspelled = tmp_path / "misspelled.toml"
    misspelled.write_text(Path(CASE).read_text(encoding="utf-8").replace("20000.0", "-1.0"), encoding="utf-8")
    assert "load = 5000 N" in run("check", str(misspelled), "--set", "load.load=5kN").out


def test_a_bearing_takes_it_too(run):
    file = str(EXAMPLES / "nu206.toml")
    words = ["--set", "load.radial=5kN", "--set", "solver.method=slices", "--json"]
    found = run("bearing", file, *words).json
    assert found["method"] == "slices"
    assert max(map(abs, found["force"])) == pytest.approx(5e3, rel=1e-6)
    assert nh.read_bearing(file, {"load.radial": 5e3}).prescribed.radial == 5000.0
