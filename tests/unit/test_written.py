"""Cases written and read back, results read back: the same values, and a sentence for what is none."""

import dataclasses
import json
import tomllib
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.bounds import FORMAT
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.contact_results import as_object
from nonhertz.files.results import key_by_key
from nonhertz.files.sections import Life, OverrolledDent
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.toml import to_toml
from nonhertz.life import ContactLoadCase
from nonhertz.model.profile import CATALOGUE, Profile

EXAMPLES = Path(__file__).parents[2] / "examples"
CASES = [path for path in sorted(EXAMPLES.glob("*.toml")) if "[body.a]" in path.read_text(encoding="utf-8")]
LENGTH = 20.0
PARAMETERS = {
    "straight": {},
    "crown": {"radius": 4000, "centre": 0.5},
    "partial-crown": {"radius": 1000.0, "straight": 12.0, "blended": False},
    "two-radius": {"radius": 5000.0, "end_radius": 500.0, "middle": 12.0},
    "logarithmic": {"amplitude": 0.005, "length": LENGTH, "fraction": 0.9999},
    "lundberg": {"load": 20e3, "length": LENGTH, "radius": 8.0},
    "johns-gohar": {"load": 20e3, "length": LENGTH, "radius": 8.0},
    "fujiwara-kawase": {"load": 20e3, "length": LENGTH, "k1": 1.5, "k2": 0.6, "zm": 0.03},
    "iso-logarithmic": {"diameter": 20.0, "length": LENGTH},
    "iso-tapered": {"diameter": 20.0, "length": LENGTH},
    "iso-thrust": {"diameter": 20.0, "length": LENGTH},
    "conical": {"angle": 1e-4},
    "tapered-ends": {"straight": 14.0, "angle": 0.004},
    "chamfer": {"length": LENGTH, "width": 1.0},
    "tabulated": {"y": [-10.0, 0.0, 10.0], "relief": [0.01, 0.0, 0.02], "interpolation": "linear"},
}


def made(profile=None, **changes):
    body = {"diameter": 20.0, "length": LENGTH} | ({} if profile is None else {"profile": profile}) | changes
    return nh.Case(nh.Contact(nh.Roller(**body), nh.Ring(diameter=80)), {"load": 5e3}, title="one")


def back(case):
    return Case.of(case.own_document, Path("case.toml"), files=False)


@pytest.mark.slow
def test_a_result_is_saved_as_the_command_writes_it(tmp_path):
    solution = made().solve()
    names = [path.name for path in solution.save(tmp_path / "new", title="A roller")]
    assert [each for each in names if not each.endswith("svg")] == [
        "footprint.csv", "footprint.png", "pressure.csv", "pressure.png", "profile.csv", "profile.png", "result.json",
        "table.csv",
    ]  # fmt: skip
    found = nh.read_result(tmp_path / "new" / "result.json")
    assert (found.case.title, found.solution.approach) == ("A roller", solution.approach)
    assert found.case.solve().approach == pytest.approx(solution.approach, rel=1e-9)
    (tmp_path / "file").touch()
    with pytest.raises(nh.InputError, match=r"^folder = .* must be a directory, not a file"):
        solution.save(tmp_path / "file")


def test_every_kind_of_profile_is_tried():
    assert set(PARAMETERS) == set(CATALOGUE)


@pytest.mark.parametrize("kind", CATALOGUE)
def test_every_kind_of_profile_is_written_as_it_was_made(kind, tmp_path):
    profile = CATALOGUE[kind](**PARAMETERS[kind])
    case, path = made(profile), tmp_path / "case.toml"
    case.write(path)
    found = read_case(path)
    assert found.contact == case.contact
    assert found.prescribed == case.prescribed
    y = np.linspace(-9.0, 9.0, 101)
    np.testing.assert_array_equal(found.contact.separation(y), case.contact.separation(y))
    tables = case.own_document["body"]["a"].get("profile", [])
    assert [table["kind"] for table in tables] == ([] if kind == "straight" else [kind])


@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE if kind != "straight"])
def test_sums_shifts_factors_and_flips_are_written_too(kind):
    profile, y = CATALOGUE[kind](**PARAMETERS[kind]), np.linspace(-8.0, 8.0, 101)
    flipped = made((profile.shifted(0.25) + nh.profile.crown(8000, 1.0).flipped()).flipped().scaled(0.5).shifted(0.125))
    for case in (
        made(profile.scaled(2.0).shifted(0.25) + nh.profile.crown(8000).shifted(-0.5)),
        made(profile.shifted(0.25).scaled(2.0)),
        flipped,
    ):
        np.testing.assert_allclose(back(case).contact.separation(y), case.contact.separation(y), rtol=1e-12, atol=1e-15)
    first, second = flipped.own_document["body"]["a"]["profile"]
    assert first["flip"] is True
    assert "flip" not in second


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_the_examples_come_back_as_they_are_and_need_no_other_file(path, tmp_path):
    case = read_case(path)
    case.write(tmp_path / "again.toml")
    again = read_case(tmp_path / "again.toml")
    assert again == case
    assert '"file"' not in json.dumps(case.own_document)


BODIES = {
    "body of any kind": nh.Body(diameter=20.0, length=LENGTH, depth="diameter"),
    "concave": nh.Ring(diameter=-30.0, length=25.0, side_faces=("calibrated", 1.2), images=3),
    "series": nh.Roller(diameter=20.0, length=LENGTH, images="series", depth=8.0),
    "changing diameter": nh.Ring(diameter=nh.TabulatedDiameter(y=(-10.0, 10.0), diameter=(79.0, 81.0)), length=LENGTH),
    "own material": nh.Plate(material=nh.Material(100e3, 0.25), depth=12.0, length=40.0, position=0.5),
    "corner radius": nh.Roller(diameter=20.0, length=LENGTH, corner_radius=0.5, side_faces="free"),
    "chamfer": nh.Roller(diameter=20.0, length=LENGTH, chamfer=nh.Chamfer(1.0, 0.3, blend_radius=2.0)),
    "hollow": nh.Roller(diameter=20.0, length=LENGTH, bore=8.0, side_faces="free", depth="finite"),
    "stepped bore": nh.Roller(
        diameter=20.0,
        length=LENGTH,
        bore=nh.TabulatedDiameter(y=(0.0, 0.5), diameter=(8.0, 10.0)),
        side_faces="free",
        depth="finite",
    ),
    "effective length": nh.Roller(diameter=20.0, length=LENGTH, effective_length=18.0),
}


@pytest.mark.parametrize("name", BODIES)
def test_every_kind_of_body_comes_back(name):
    case = nh.Case(nh.Contact(nh.Roller(diameter=15.0, length=LENGTH), BODIES[name]), {"approach": 0.01, "moment": 5.0})
    found = back(case)
    assert found.contact == case.contact
    assert type(found.contact.b) is type(case.contact.b)
    assert found.prescribed == case.prescribed


def test_options_and_life_come_back():
    spectrum = (ContactLoadCase(load=5e3, share=0.25), ContactLoadCase(load=2e3, share=0.75))
    life = Life(rollers=14, models=("iso-16281",), laminae=40, spectrum=spectrum)
    case = dataclasses.replace(made(), solver={"element": "parabolic", "strips": 41}, life=life)
    assert back(case) == case
    dented = Life(dent=OverrolledDent(depth=0.002, diameter=0.3, per_area=0.1))
    assert back(dataclasses.replace(case, life=dented)).life == dented


@dataclasses.dataclass(frozen=True)
class Own(Profile):
    """A profile that no case file has."""

    def relief(self, y):
        return 1e-5 * np.asarray(y, dtype=float) ** 2


@pytest.mark.parametrize(
    ("case", "sentence"),
    [
        (made(Own()), r"body\.a\.profile = 'Own' must be from the catalogue to be written to a case file: tabulate it"),
    ],
)
def test_what_no_case_file_has_is_refused_and_nothing_is_left_behind(case, sentence, tmp_path):
    with pytest.raises(nh.InputError, match=sentence):
        case.write(tmp_path / "case.toml")
    assert list(tmp_path.iterdir()) == []


def test_a_place_that_cannot_be_written_to_is_named(tmp_path):
    (tmp_path / "taken").write_text("")
    with pytest.raises(nh.InputError, match=r"^path = .* must be a directory, not a file"):
        made().write(tmp_path / "taken" / "case.toml")


def test_a_case_is_written_to_a_file_and_to_nothing_else():
    with pytest.raises(nh.InputError, match="path = 3 must be the name of a file to write"):
        made().write(3)


@pytest.mark.parametrize("value", [2, 0, "1", True])
def test_other_formats_of_case_files_are_refused(value):
    with pytest.raises(nh.CaseError, match=r"format = .* must be 1, the newest format this release reads"):
        Case.of(made().own_document | {"format": value}, Path("case.toml"))


# Results

SOLVED = {
    "runs out": made(nh.profile.iso_logarithmic(20.0, LENGTH)),
    "sharp ends": made(),
    "grooved": made(nh.profile.tabulated([-10, -2.1, -2, 2, 2.1, 10], [0, 0, 1, 1, 0, 0])),
    "few strips": dataclasses.replace(made(), solver={"strips": 1, "element": "parabolic"}),
}


def test_the_document_for_another_folder_names_the_same_files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for folder in ("data", "cases", "found/best"):
        Path(folder).mkdir(parents=True)
    Path("data/relief.csv").write_text("-10, 0.01\n0, 0\n10, 0.02\n")
    names = "../data/relief.csv", f"{tmp_path.as_posix()}/data/relief.csv"
    tables = ", ".join(f'{{ kind = "tabulated", file = "{name}" }}' for name in names)
    logarithm = '{ kind = "logarithmic", amplitude = 0.005, fraction = 0.9999 }'
    Path("cases/case.toml").write_text(starting_case().replace(logarithm, tables))
    case = read_case("cases/case.toml")
    Path("found/best/case.toml").write_text(to_toml(case.document_in(Path("found/best"))))
    found = read_case("found/best/case.toml")
    assert [each["file"] for each in found.document["body"]["a"]["profile"]] == ["../../data/relief.csv", names[1]]
    assert found.contact == case.contact


@pytest.fixture(scope="module", params=SOLVED)
def solved(request):
    case = SOLVED[request.param]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("warnings.warn", lambda *_, **__: None)
        return case, case.solve()


def test_a_result_is_read_back_to_the_last_digit(solved, tmp_path):
    case, solution = solved
    path = tmp_path / "result.json"
    path.write_text(key_by_key(as_object(solution, case)))
    found = nh.read_result(path)
    assert found.case.contact == case.contact
    # Of what was found there are the words.
    names = {each.name for each in dataclasses.fields(solution)} - {"judgement"}
    for name in names | {"contact_y", "singular_ends", "peaks_at_corner", "error_estimate"}:
        one, other = getattr(solution, name), getattr(found.solution, name)
        if isinstance(one, np.ndarray):
            np.testing.assert_array_equal(other, one)
        else:
            assert other == one
    of_both = [[(each.kind, str(each)) for each in of.findings] for of in (found.solution, solution)]
    assert of_both[0] == of_both[1]
    for one, other in zip(solution.edge_pressure, found.solution.edge_pressure, strict=True):
        assert str(one.convention) == str(other.convention)
        assert dataclasses.replace(one, convention=other.convention) == other
    assert found.solution.max_pressure == solution.max_pressure
    assert repr(found.solution) == repr(solution)


@pytest.fixture(scope="module")
def bearing_result():
    case = BearingCase.of(tomllib.loads(starting_bearing()), Path("bearing.toml"))
    return nh.Result(case, case.solve("slices"))


@pytest.mark.parametrize(
    ("template", "method"), [("cylindrical", "strips"), ("tapered-pair", "slices"), ("spherical", "slices")]
)
def test_so_is_that_of_a_bearing(template, method, tmp_path):
    path = tmp_path / "bearing.toml"
    path.write_text(starting_bearing(template))
    case = nh.read_bearing(path, {"solver.method": method})
    solution = case.solve()
    text = nh.Result(case, solution).to_json()
    (tmp_path / "result.json").write_text(text)
    found = nh.read_result(tmp_path / "result.json")
    assert found.case == case
    for field in dataclasses.fields(solution):
        np.testing.assert_equal(getattr(found.solution, field.name), getattr(solution, field.name))
    assert repr(found.solution) == repr(solution)
    assert found.to_json() == text


def test_a_case_and_the_solution_of_another_kind_are_no_result(bearing_result):
    with pytest.raises(nh.InputError, match="solution = 'BearingSolution' must be that of the case"):
        nh.Result(made(), bearing_result.solution).to_json()


@pytest.mark.parametrize(
    ("key", "value"), [("each_rib_load", None), ("each_rib_load", [[1.0]]), ("load", [[1.0]]), ("iterations", [1])]
)
def test_a_bearing_that_is_incomplete_is_refused_in_one_sentence(key, value, bearing_result, tmp_path):
    result = json.loads(bearing_result.to_json())
    changed = {name: entry for name, entry in (result | {key: value}).items() if entry is not None}
    (tmp_path / "result.json").write_text(json.dumps(changed))
    with pytest.raises(nh.InputError, match=r"hold a complete solution \((KeyError|ValueError|TypeError)"):
        nh.read_result(tmp_path / "result.json")


def whole():
    case = SOLVED["runs out"]
    return as_object(case.solve(), case)


BROKEN = {
    "another format": (lambda result: result | {"format": FORMAT + 1}, "hold a result of format 1, not 2"),
    "of an older release": (
        lambda result: {k: v for k, v in result.items() if k != "format"},
        "hold a result of format 1",
    ),
    "no case": (lambda result: {k: v for k, v in result.items() if k != "case"}, "hold a complete solution .KeyError"),
    "a case that is none": (lambda result: result | {"case": {"load": {}}}, r"hold a case \(load\.load must be given"),
    "a list": (lambda result: [result], "hold one JSON object"),
    "no ends": (lambda result: result | {"edge_pressure": []}, "hold a complete solution"),
    "an unknown element": (lambda result: result | {"element": "cubic"}, "hold a complete solution"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_file_that_is_no_result_is_refused_in_one_sentence(name, tmp_path):
    change, sentence = BROKEN[name]
    path = tmp_path / "result.json"
    path.write_text(json.dumps(change(whole())))
    with pytest.raises(nh.InputError, match=sentence) as caught:
        nh.read_result(path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("text", ["", "{", "[" * 100_000, "\x00", '{"format": 1'])
def test_text_that_is_no_json_is_refused(text, tmp_path):
    path = tmp_path / "result.json"
    path.write_text(text)
    with pytest.raises(nh.InputError, match=r"must be a result file \(not json\)"):
        nh.read_result(path)


def test_a_missing_file_and_a_wrong_argument_are_named(tmp_path):
    with pytest.raises(nh.InputError, match="no such file"):
        nh.read_result(tmp_path / "nothing.json")
    with pytest.raises(nh.InputError, match="path = 3 must be the name of a result file"):
        nh.read_result(3)


def test_what_materials_bear_is_written_as_it_was_given(tmp_path):
    strong = nh.Material(
        210000, 0.3, yield_strength=1800, core_yield_strength=800.0, hardness="60 HRC", pressure_limit=4000
    )
    case, path = made(material=strong, case_depth=1.2), tmp_path / "case.toml"
    case.write(path)
    found = read_case(path)
    assert found.contact == case.contact
    assert found.contact.a.material.hardness == "60 HRC"
    assert found.contact.a.case_depth == 1.2


def test_what_is_not_known_is_not_written():
    table = made(material=nh.Material(210000, 0.3)).own_document["body"]["a"]
    assert table["material"] == {"modulus": 210000.0, "poisson": 0.3}
    assert "case_depth" not in table


def test_strength_does_not_change_the_solution():
    strong = nh.Material(207000, 0.3, yield_strength=1800, core_yield_strength=800)
    plain, changed = made().solve(), made(material=strong, case_depth=1.0).solve()
    np.testing.assert_array_equal(changed.centre_pressure, plain.centre_pressure)
    assert changed.approach == plain.approach
