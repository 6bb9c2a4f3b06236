"""Case files: what the keys mean, and that nothing but a list of sentences comes of a wrong one."""

import dataclasses
import datetime
import inspect
import json
import re
import tomllib
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from whole_case import TEXT

import nonhertz as nh
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.schemas import schema_of
from nonhertz.files.starting import starting_case
from nonhertz.life import MODELS, ContactLoadCase, ioannides_harris, iso_16281, zaretsky
from nonhertz.model.profile import CATALOGUE

PRINTED = Path(__file__).parents[2].joinpath("examples", "crowned-roller.toml").read_text(encoding="utf-8")
Y = np.linspace(-9.5, 9.5, 7)


def read(folder: Path, text: str) -> Case:
    path = folder / "case.toml"
    path.write_text(text, encoding="utf-8")
    return read_case(path)


def with_body(keys: str) -> str:
    """Return a case file with these keys in [body.a]."""
    return f"[body.a]\n{keys}\n[body.b]\n[load]\nload = 1000\n"


def mistakes_of(document: dict[str, Any]) -> tuple[str, ...]:
    try:
        Case.of(document, Path())
    except CaseError as error:
        return error.mistakes
    return ()


def test_the_case_file_of_the_specification(tmp_path):
    case = read(tmp_path, PRINTED)
    steel = nh.Material(modulus=207000, poisson=0.3)
    assert case.title == "Roller 20 x 20 on a plate"
    assert case.contact.a == nh.Roller(
        diameter=20.0,
        length=20.0,
        material=steel,
        profile=nh.profile.crown(radius=4000.0),
        side_faces="none",
        depth="none",
    )
    assert case.contact.b == nh.Body(material=steel, side_faces="none", depth="none")
    assert case.prescribed.keywords == {"load": 20000.0, "tilt": 0.0005}
    assert case.solver.keywords == {"element": "semi-elliptic", "strips": "auto"}


def test_everything_but_the_bodies_and_the_load_can_be_left_out(tmp_path):
    case = read(tmp_path, with_body("diameter = 20"))
    assert case.title == "case"
    assert case.solver.keywords == {"element": "semi-elliptic", "strips": "auto"}
    assert case.contact.a.material == nh.Material(207000.0, 0.3)


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        # What is convex and ends is a roller unless it says otherwise.
        ("diameter = 20\nlength = 20", nh.Roller(diameter=20.0, length=20.0)),
        ("diameter = 20", nh.Body(diameter=20.0)),
        ("diameter = -80\nlength = 20", nh.Body(diameter=-80.0, length=20.0)),
        ("kind = 'roller'\ndiameter = 20\nlength = 20", nh.Roller(diameter=20.0, length=20.0)),
        ("kind = 'ring'\ndiameter = 37.5\nlength = 16", nh.Ring(diameter=37.5, length=16.0)),
        ("kind = 'plate'\nlength = 16", nh.Plate(length=16.0)),
    ],
)
def test_what_is_left_out_is_as_in_python(tmp_path, keys, expected):
    other = "kind = 'roller'\ndiameter = 30\nlength = 20"
    case = read(tmp_path, f"[body.a]\n{keys}\n[body.b]\n{other}\n[load]\nload = 1000\n")
    assert case.contact.a == expected
    assert case.contact.b == nh.Roller(diameter=30.0, length=20.0)


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("side_faces = 'mirror'", {"side_faces": "mirror"}),
        ("side_faces = 'calibrated'", {"side_faces": "calibrated"}),
        ("side_faces = 'none'", {"side_faces": "none"}),
        ("side_faces = 1", {"side_faces": 1.0}),
        ("side_faces = 1.2", {"side_faces": 1.2}),
        ("side_faces = ['mirror', 'none']", {"side_faces": ("mirror", "none")}),
        ("side_faces = ['calibrated', 0]", {"side_faces": ("calibrated", 0.0)}),
        ("images = 3", {"images": 3}),
        ("images = 100.0", {"images": 100}),
        ("images = 'series'", {"images": "series"}),
        ("images = 'series'\nside_faces = [1, 0]", {"images": "series", "side_faces": (1.0, 0.0)}),
        ("depth = 'none'", {"depth": "none"}),
        ("depth = 'plane-strain'", {"depth": "plane-strain"}),
        ("depth = 'diameter'", {"depth": "diameter"}),
        ("depth = 8", {"depth": 8.0}),
        ("depth = '8 mm'", {"depth": 8.0}),
        ("depth = '0.8 cm'", {"depth": 8.0}),
        ("depth = '.5 in'", {"depth": 12.7}),
    ],
)
def test_what_makes_a_body_finite(tmp_path, keys, expected):
    case = read(tmp_path, with_body(f"kind = 'roller'\ndiameter = 20\nlength = 20\n{keys}"))
    assert case.contact.a == nh.Roller(diameter=20.0, length=20.0, **expected)
    assert type(case.contact.a.images) is type(expected.get("images", 1))


def test_units_are_accepted_everywhere_a_quantity_stands(tmp_path):
    case = read(
        tmp_path,
        """
        [body.a]
        diameter = "2 cm"
        length = "0.02 m"
        effective_length = "19000 um"
        position = "100 um"
        depth = "1 cm"
        material = { modulus = "207 GPa", poisson = 0.3 }
        profile = [
            { kind = "crown", radius = "4 m", shift = "50 um" },
            { kind = "tabulated", y = ["-1 cm", 0, "1 cm"], relief = ["5 um", 0.0, 0.005] },
            { kind = "lundberg", load = "20 kN", radius = "1 cm", compliance = "2.8e-6 1/MPa" },
            { kind = "conical", angle = "0.03 deg" },
        ]
        [body.b]
        diameter = { y = ["-1 cm", "1 cm"], diameter = ["50 mm", "0.06 m"] }
        [load]
        approach = "12 um"
        moment = "5 N m"
        """,
    )
    length = 20.0
    profile = (
        nh.profile.crown(radius=4000.0).shifted(0.05)
        + nh.profile.tabulated(y=[-10.0, 0.0, 10.0], relief=[0.005, 0.0, 0.005])
        + nh.profile.lundberg(load=20000.0, length=19.0, radius=10.0, compliance=2.8e-6)
        + nh.profile.conical(angle=np.radians(0.03))
    )
    body = nh.Body(diameter=20.0, length=length, effective_length=19.0, position=0.1, profile=profile)
    np.testing.assert_allclose(case.contact.a.relief(Y), body.relief(Y), rtol=1e-14)
    assert case.contact.a.interval == body.interval
    assert case.contact.a.depth == 10.0
    np.testing.assert_allclose(case.contact.a.curvature(Y), 0.1, rtol=1e-15)
    np.testing.assert_allclose(case.contact.b.curvature(np.zeros(1)), 2.0 / 55.0, rtol=1e-15)
    assert case.prescribed.keywords == {"approach": 0.012, "moment": 5000.0}


def test_profiles_take_length_and_diameter_from_their_body(tmp_path):
    case = read(tmp_path, with_body('diameter = 15\nlength = 18\nprofile = [{ kind = "iso-logarithmic" }]'))
    expected = nh.profile.iso_logarithmic(diameter=15.0, length=18.0)
    np.testing.assert_array_equal(case.contact.a.relief(0.9 * Y), expected.relief(0.9 * Y))


def test_a_straight_middle_leaves_the_rest_of_the_body_to_the_curve(tmp_path):
    table = '{ kind = "logarithmic", amplitude = 0.005, straight = 8, fraction = 0.99 }'
    case = read(tmp_path, with_body(f"diameter = 15\nlength = 20\nprofile = [{table}]"))
    end = -0.005 * np.log(1.0 - 0.99**2)
    np.testing.assert_allclose(case.contact.a.relief([4.0, 10.0]), [0.0, end], rtol=1e-12)


def test_a_profile_file_is_found_beside_the_case_file(tmp_path, monkeypatch):
    (tmp_path / "points.csv").write_text("y,relief\n-10,0.01\n0,0\n10,0.01\n", encoding="utf-8")
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    table = '{ kind = "tabulated", file = "points.csv", interpolation = "linear" }'
    case = read(tmp_path, with_body(f"diameter = 20\nprofile = [{table}]"))
    np.testing.assert_allclose(case.contact.a.relief(5.0), 0.005, rtol=1e-15)


@pytest.mark.parametrize("bom", ["", "\ufeff"])
@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_files_of_other_editors_are_read(tmp_path, bom, ending):
    path = tmp_path / "case.toml"
    path.write_bytes((bom + PRINTED.replace("\n", ending)).encode())
    assert read_case(path).prescribed.load == 20000.0


def test_mistakes_are_listed_in_the_order_of_the_file():
    document = {
        "titel": "x",
        "load": {"tilt": "5 kg", "load": -5},
        "body": {"b": {"depth": "full"}, "a": {"profile": [{"kind": "crown"}], "length": -3}},
    }
    said = [mistake.removeprefix("Unknown key ").partition(" ")[0] for mistake in mistakes_of(document)]
    assert said == [
        "titel.",
        "load.tilt",
        "load.load",
        "body.b.depth",
        "body.a.profile[1].radius",
        "body.a.length",
    ]


def test_a_mistaken_key_does_not_accuse_the_keys_that_need_it():
    """One mistake in a body that uses everything is one sentence, whichever it is."""
    sound = {
        "kind": "roller",
        "diameter": 20.0,
        "length": 20.0,
        "effective_length": 19.0,
        "side_faces": ["calibrated", 1.2],
        "depth": "diameter",
        "images": "series",
    }
    for key in sound:
        document = {"body": {"a": sound | {key: True}, "b": {}}, "load": {"load": 1.0}}
        (mistake,) = mistakes_of(document)
        assert mistake.startswith(f"body.a.{key} = True must ")


def test_all_mistaken_parameters_of_one_profile_are_found():
    table = {
        "kind": "fujiwara-kawase",
        "load": -1,
        "length": -1,
        "k1": -1,
        "k2": 2,
        "zm": -1,
        "compliance": -1,
    }
    mistakes = mistakes_of({"body": {"a": {"profile": [table]}, "b": {"diameter": 20}}, "load": {"load": 1}})
    found = {mistake.partition(" ")[0].rpartition(".")[2] for mistake in mistakes}
    assert found == table.keys() - {"kind"}


def test_the_catalogue_leaves_the_common_keys_free():
    for kind in CATALOGUE:
        assert not {"kind", "shift", "scale", "file"} & inspect.signature(CATALOGUE[kind]).parameters.keys()


def test_the_schema_describes_every_key():
    whole = schema_of("case")
    assert json.loads(json.dumps(whole)) == whole
    tables = whole["$defs"]
    for name in ("Body", "Prescription", "Solver", "Material", "Life"):
        assert tables[name]["additionalProperties"] is False
        for key, entry in tables[name]["properties"].items():
            assert entry["description"], (name, key)
    kinds = tables["Body"]["properties"]["profile"]["anyOf"][0]["anyOf"]
    assert {kind["properties"]["kind"]["const"] for kind in kinds} == {*CATALOGUE, "measured"}
    for kind in kinds:
        for key, entry in kind["properties"].items():
            assert key == "kind" or entry["description"], (kind["title"], key)


@pytest.mark.parametrize("kind", ["roller", None])
def test_the_schema_allows_what_a_body_takes(kind):
    properties = schema_of("case")["$defs"]["Body"]["properties"]
    body = {"diameter": 20.0, "length": 20.0} | ({"kind": kind} if kind else {})

    def refused(keys: dict[str, Any]) -> bool:
        return bool(mistakes_of({"body": {"a": body | keys, "b": {}}, "load": {"load": 1.0}}))

    words, weight, pair = properties["side_faces"]["anyOf"]
    for rule in (*words["enum"], weight["minimum"]):
        assert not refused({"side_faces": rule})
        assert not refused({"side_faces": [rule] * pair["maxItems"]})
    assert refused({"side_faces": weight["minimum"] - 1e-9})
    assert pair["items"]["anyOf"] == [words, weight]
    assert (pair["minItems"], pair["maxItems"]) == (2, 2)

    series, count = properties["images"]["anyOf"]
    for images in (count["minimum"], count["maximum"], *series["enum"]):
        assert not refused({"images": images, "depth": "diameter"})
    assert refused({"images": count["minimum"] - 1})
    assert refused({"images": count["maximum"] + 1})

    words, number, text = properties["depth"]["anyOf"]
    for depth in (*words["enum"], 1e-9):
        assert not refused({"depth": depth, "side_faces": "none" if depth == "cylinder" else "free"})
    assert refused({"depth": number["exclusiveMinimum"]})
    assert re.search(text["pattern"], "8 mm")
    assert not any(re.search(text["pattern"], word) for word in words["enum"])


def test_a_life_table_holds_models_and_a_spectrum():
    life = Case.of(WHOLE, Path()).life
    assert life.contact_angle == pytest.approx(np.radians(12.0))
    assert (life.rollers, life.models) == (14, ("zaretsky", "iso-16281"))
    assert life.spectrum == (ContactLoadCase(load=10e3, share=0.25, tilt=-1e-3), ContactLoadCase(load=5e3, share=0.75))
    volume, laminae = life.build_models()
    assert volume == zaretsky(slope=1.5)
    assert laminae == iso_16281(laminae=40, edge_stress="none", line_loads="standard")
    assert life.build_models(["ioannides-harris"]) == (ioannides_harris(slope=1.5, fatigue_limit=300.0),)


def test_without_a_life_table_all_models_are_wanted_as_they_are():
    document = {name: table for name, table in WHOLE.items() if name != "life"}
    assert Case.of(document, Path()).life.build_models() == tuple(make() for make in MODELS.values())


@pytest.mark.parametrize(
    ("life", "sentences"),
    [
        ({"contact_angle": 12.0}, ["contact_angle = 12.0 must not exceed 0.7854 rad"]),
        ({"rollers": -1, "laminae": 3}, ["rollers = -1 must be a whole", "laminae = 3 must be a whole number from 30"]),
        ({"models": []}, ["models = [] must be a list of names"]),
        ({"models": ["zaretzky", 3]}, ["models[1] = 'zaretzky' must be one of ", "models[2] = 3 must be one of "]),
        ({"slope": 100}, ["slope = 100.0 must lie between 0.2 and 5"]),
        ({"edge_stress": "presure"}, ["edge_stress = 'presure' must be one of 'pressure', "]),
        ({"modles": []}, ["modles. Did you mean life.models?"]),
        ({"spectrum": {"load": 1}}, ["spectrum must be a list of tables"]),
        (
            {"spectrum": [3, {"load": -1, "tlit": 0}]},
            [
                "spectrum[1] = 3 must be a section",
                "spectrum[2].load = -1.0 must be positive",
                "spectrum[2].tlit. Did you mean life.spectrum[2].tilt?",
                "spectrum[2].share must be given: give its share of the revolutions",
            ],
        ),
        ({"spectrum": [{"load": 1, "share": 0.5}]}, ["spectrum.share = 0.5 must add up to 1: give all loads with "]),
    ],
)
def test_mistakes_in_a_life_table(life, sentences):
    for found, beginning in zip(mistakes_of(WHOLE | {"life": life}), sentences, strict=True):
        assert found.removeprefix("Unknown key ").startswith(f"life.{beginning}")


@pytest.mark.parametrize("short", [0.9e-3, -0.9e-3])
def test_shares_are_taken_to_a_thousandth(short):
    spectrum = [{"load": 1, "share": 0.5}, {"load": 2, "share": 0.5 - short}]
    assert len(Case.of(WHOLE | {"life": {"spectrum": spectrum}}, Path()).life.spectrum) == 2
    spectrum[1]["share"] -= 0.2e-3 if short > 0.0 else -0.2e-3
    assert len(mistakes_of(WHOLE | {"life": {"spectrum": spectrum}})) == 1


NUMBERS = st.one_of(st.floats(), st.integers(), st.just(10**400))
KNOWN = ["steel", "crown", "ring", "5 mm", "1e999 m", "auto", "none", "mirror", "series", "plane-strain"]
WORDS = st.one_of(st.text(max_size=5), st.sampled_from(KNOWN))
SCALARS = st.one_of(NUMBERS, WORDS, st.booleans(), st.just(datetime.date(2026, 1, 1)))
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=5), inner, max_size=3)),
    max_leaves=5,
)
# Without what is in files.
WHOLE = tomllib.loads(TEXT)
WHOLE["body"]["a"]["profile"] = [table for table in WHOLE["body"]["a"]["profile"] if "file" not in table]
del WHOLE["body"]["b"]["profile"]


def places(value: Any, place: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    keys: Any = ()
    if isinstance(value, dict):
        keys = list(value)
    elif isinstance(value, list):
        keys = range(len(value))
    return [place] * bool(place) + [inner for key in keys for inner in places(value[key], (*place, key))]


@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(place=st.sampled_from(places(WHOLE)), value=VALUES, extra=st.text(max_size=8))
def test_any_value_anywhere_is_read_or_refused_in_words(place, value, extra):
    document = deepcopy(WHOLE)
    holder: Any = document
    for key in place[:-1]:
        holder = holder[key]
    holder[place[-1]] = value
    if isinstance(holder, dict):
        holder.setdefault(extra, value)
    for mistake in mistakes_of(document):
        assert " must " in mistake or mistake.startswith("Unknown key ")
        assert mistake.endswith((".", "?"))  # did you mean another one?
        assert len(mistake.splitlines()) == 1


DOCS = Path(__file__).parents[2] / "docs" / "reference"


def test_the_reference_names_the_parameters_of_every_profile():
    page = (DOCS / "case-file.md").read_text(encoding="utf-8")
    for kind, function in CATALOGUE.items():
        row = [line for line in page.splitlines() if line.startswith(f"| `{kind}` |")][-1]  # `chamfer` is a key, too
        named = set(re.findall(r"`(\w+)`", row.split("|")[2]))
        allowed = {"file"} if kind == "tabulated" else set()
        assert named - allowed == inspect.signature(function).parameters.keys()


def test_the_reference_s_examples_are_sound(tmp_path):
    page = (DOCS / "case-file.md").read_text(encoding="utf-8")
    whole, life = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert read(tmp_path, whole).contact.interval
    assert [case.share for case in read(tmp_path, whole + life).life.spectrum] == [0.2, 0.8]


@pytest.mark.parametrize(
    ("ends", "land"),
    [
        ("", 20.0),
        ("corner_radius = '500 um'", 19.0),
        ("chamfer = { length = 1.5, angle = 0.3 }", 17.0),
        ("effective_length = 18", 18.0),
        ("effective_length = 18\nposition = 0.1", 18.0),
    ],
)
def test_profiles_along_the_contact_end_with_the_land(tmp_path, ends, land):
    def profile(table):
        text = with_body(f"diameter = 20\nlength = 20\n{ends}\nprofile = {{ {table} }}")
        return read(tmp_path, text).contact.a.profile

    make = nh.profile
    assert profile("kind = 'iso-logarithmic'") == make.iso_logarithmic(diameter=20.0, length=land)
    assert profile("kind = 'iso-tapered'") == make.iso_tapered(diameter=20.0, length=land)
    assert profile("kind = 'logarithmic', amplitude = 1e-3") == make.logarithmic(1e-3, land)
    assert profile("kind = 'logarithmic', amplitude = 1e-3, straight = 2") == make.logarithmic(
        1e-3, land - 2.0, straight=2.0
    )
    for kind in (make.lundberg, make.johns_gohar, make.fujiwara_kawase):
        word = kind.__name__.replace("_", "-")
        assert profile(f"kind = '{word}', load = 4e3") == kind(load=4e3, length=land, radius=10.0)
    # What is stated is taken as it is, and a chamfer belongs to the body.
    assert profile("kind = 'iso-logarithmic', length = 20") == make.iso_logarithmic(diameter=20.0, length=20.0)
    assert profile("kind = 'chamfer', width = 1, angle = 1e-3") == make.chamfer(length=20.0, width=1.0, angle=1e-3)


def test_the_standard_s_profile_leaves_no_spike_in_the_first_template(tmp_path):
    case = read(tmp_path, starting_case("cylindrical"))
    solution = case.solve()
    assert abs(solution.max_pressure_y) < 2.0
    # A body that ends where the corners begin, below a profile that it is given, bears the same.
    cut = dataclasses.replace(
        case.contact.a,
        corner_radius=None,
        effective_length=9.4,
        profile=nh.profile.iso_logarithmic(diameter=10.0, length=9.4),
    )
    tilt = case.prescribed.keywords["tilt"]
    same = nh.solve(dataclasses.replace(case.contact, a=cut), load=4e3, tilt=tilt)
    assert solution.max_pressure == pytest.approx(same.max_pressure, rel=1e-3)


def test_a_profile_is_flipped_about_the_middle_of_the_body_after_its_shift(tmp_path):
    table = "{ kind = 'crown', radius = 4000, centre = 1, shift = 2, flip = true }"
    body = read(tmp_path, with_body(f"diameter = 20\nlength = 20\nprofile = {table}")).contact.a
    assert float(body.relief(-3.0)) == 0.0
    assert float(body.relief(3.0)) == pytest.approx(36.0 / 8000.0, rel=1e-5)
    assert mistakes_of({"body": {"a": {"profile": [{"kind": "straight", "flip": 1}]}, "b": {}}, "load": {"load": 1}})[
        0
    ].startswith("body.a.profile[1].flip = 1 must be True or False: write true or false")
