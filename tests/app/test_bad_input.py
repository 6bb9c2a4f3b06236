"""Bad input through the command line: each mistake one sentence, exit code 2, and nothing solved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nonhertz as nh
from nonhertz.cli import main
from nonhertz.files.casefile import Case, placed

A = "[body.a]\ndiameter = 20.0\nlength = 20.0\n"
B = "[body.b]\n"
LOAD = "[load]\nload = 20000.0\n"
LENGTH = "a number in mm, or text with a unit of length such as '20 mm'"
LENGTH_REMEDY = "give the distance between the side faces in mm, or leave it out for an unbounded body"
DIAMETER_REMEDY = "give the diameter in mm, negative for a concave surface, or leave it out for a flat one"
FACES_REMEDY = "write 'free', 'mirror', 'calibrated', 'none' or a weight of the images, or a pair for low and high y"
IMAGES_REMEDY = "give 1 to 100, or 'series' for all of them"
DEPTH_REMEDY = (
    "write 'none', 'plane-strain', 'diameter', 'cylinder', 'finite' or a depth in mm such as the thickness of a ring"
)
NOT_CONVEX = (
    "must only be used for a convex body, which has a diameter: "
    "give the thickness of a ring or plate in mm, or write 'none'."
)
NO_COUNT = "be 'series' or a whole number from 1 to 100"
PLAIN = "must be a plain number: write it without quotes and without a unit."
STRIPS = "be 'auto' or a whole number from 1 to 2000: leave it out for an automatic grid"
KEYS_OF_MATERIAL = (
    "choose from 'modulus', 'poisson', 'yield_strength', 'core_yield_strength', 'hardness', 'pressure_limit'"
)


def profile(table: str) -> str:
    return f"{A}profile = [{table}]\n{B}{LOAD}"


def with_keys(keys: str) -> str:
    """Return a case file with these keys beside the diameter and the length of body a."""
    return f"{A}{keys}\n{B}{LOAD}"


def refused_word(key: str, word: str, condition: str, remedy: str) -> tuple[str, list[str]]:
    return with_keys(f"{key} = {word}"), [f"body.a.{key} = {word} must {condition}: {remedy}."]


MISTAKES = {
    # Numbers
    "negative length": (
        f"[body.a]\ndiameter = 20.0\nlength = -5.0\n{B}{LOAD}",
        [f"body.a.length = -5.0 must be positive: {LENGTH_REMEDY}."],
    ),
    "negative length in a unit": (
        f"[body.a]\nlength = '-5 um'\n{B}diameter = 20\n{LOAD}",
        [f"body.a.length = '-5 um' must be positive: {LENGTH_REMEDY}."],
    ),
    "nan": (
        f"[body.a]\ndiameter = nan\n{B}{LOAD}",
        [f"body.a.diameter = nan must be a finite number: {DIAMETER_REMEDY}."],
    ),
    "inf": (
        f"[body.a]\ndiameter = -inf\n{B}{LOAD}",
        [f"body.a.diameter = -inf must be a finite number: {DIAMETER_REMEDY}."],
    ),
    "nan as the load": (
        f"{A}{B}[load]\nload = nan\n",
        ["load.load = nan must be a finite number: give the force in N that presses the bodies together."],
    ),
    "boolean": (
        f"[body.a]\nlength = true\n{B}diameter = 20\n{LOAD}",
        [f"body.a.length = True must be a finite number: {LENGTH_REMEDY}."],
    ),
    "list": (
        f"[body.a]\nlength = [20.0]\n{B}diameter = 20\n{LOAD}",
        [f"body.a.length = [20.0] must be a finite number: {LENGTH_REMEDY}."],
    ),
    "zero diameter": (
        f"[body.a]\ndiameter = 0\n{B}{LOAD}",
        [f"body.a.diameter = 0.0 must not be zero: {DIAMETER_REMEDY}."],
    ),
    "diameter of nearly zero": (
        f"[body.a]\ndiameter = 1e-320\nlength = 20\n{B}{LOAD}",
        [f"body.a.diameter = 1e-320 must be at least 1e-100 in magnitude: {DIAMETER_REMEDY}."],
    ),
    "effective length beyond the length": (
        f"{A}effective_length = 21\n{B}{LOAD}",
        [
            "body.a.effective_length = 21.0 must not exceed the length of 20 mm: "
            "give the length that can touch in mm, or leave it out for all of the body."
        ],
    ),
    # Units
    "unit of another kind": (
        f"[body.a]\ndiameter = '5 kg'\n{B}{LOAD}",
        [f"body.a.diameter = '5 kg' must have a unit of length: write {LENGTH}."],
    ),
    "no quantity": (
        f"[body.a]\ndiameter = 'twenty'\n{B}{LOAD}",
        [f"body.a.diameter = 'twenty' must be a number with a unit: write {LENGTH}."],
    ),
    "number in quotes": (
        f"[body.a]\ndiameter = '20'\n{B}{LOAD}",
        ["body.a.diameter = '20' must have a unit: write 20 without quotes if it is in mm."],
    ),
    "unknown unit": (
        f"[body.a]\ndiameter = '20 mmm'\n{B}{LOAD}",
        [f"body.a.diameter = '20 mmm' must have a known unit: write {LENGTH}."],
    ),
    "moment without a length": (
        f"{A}{B}{LOAD}moment = '5 N'\n",
        [
            "load.moment = '5 N' must have a unit of moment: "
            "write a number in N mm, or text with a unit of moment such as '5 N m'."
        ],
    ),
    # Materials
    "poisson above a half": (
        f"{A}material = {{ modulus = 207000, poisson = 0.51 }}\n{B}{LOAD}",
        ["body.a.material.poisson = 0.51 must lie in (-1, 0.5]: give Poisson's ratio, 0.3 for steel."],
    ),
    "poisson of -1": (
        f"{A}material = {{ modulus = 207000, poisson = -1 }}\n{B}{LOAD}",
        ["body.a.material.poisson = -1.0 must lie in (-1, 0.5]: give Poisson's ratio, 0.3 for steel."],
    ),
    "unknown material": (
        f"{A}material = 'Stel'\n{B}{LOAD}",
        ["body.a.material = 'Stel' must be a known material: the nearest is 'steel'."],
    ),
    "half a material": (
        f"{A}material = {{ modulus = 207000 }}\n{B}{LOAD}",
        ["body.a.material.poisson must be given: give Poisson's ratio, in (-1, 0.5]."],
    ),
    "material of another type": (
        f"{A}material = 207000\n{B}{LOAD}",
        [
            "body.a.material = 207000 must be a name or a table: "
            "give a name such as 'steel', 'nonhertz materials' lists them all, or modulus and poisson."
        ],
    ),
    # Profiles
    "unknown profile": (
        profile("{ kind = 'crwon', radius = 4000 }"),
        ["body.a.profile[1].kind = 'crwon' must be a known profile: the nearest is 'crown'."],
    ),
    "profile without a kind": (
        profile("{ kind = 'straight' }, { radius = 4000 }"),
        ["body.a.profile[2].kind must be given: name the profile, such as kind = 'crown'."],
    ),
    "unknown profile parameter": (
        profile("{ kind = 'crown', radus = 4000 }"),
        ["body.a.profile[1].radus = 4000 must be a known key: the nearest is 'radius'."],
    ),
    "missing profile parameter": (
        profile("{ kind = 'crown' }"),
        ["body.a.profile[1].radius must be given: give the crown radius in mm, negative for a hollow profile."],
    ),
    "profile on a body without a length": (
        f"[body.a]\ndiameter = 20\nprofile = {{ kind = 'iso-logarithmic' }}\n{B}{LOAD}",
        ["body.a.profile.length must be given: give the roller's effective length in mm, unless the body has one."],
    ),
    "profile that is no table": (
        f"{A}profile = 'crown'\n{B}{LOAD}",
        [
            "body.a.profile = 'crown' must be a list of tables: "
            "write a list of tables such as [{ kind = 'crown', radius = 4000.0 }]."
        ],
    ),
    "empty profile file": (
        profile("{ kind = 'tabulated', file = 'empty.csv' }"),
        [
            "body.a.profile[1].file = 'empty.csv' must name a file of at least two points "
            "(empty.csv holds no data): write one point per line, y and relief in mm."
        ],
    ),
    "profile file with a word": (
        profile("{ kind = 'tabulated', file = 'word.csv' }"),
        [
            "body.a.profile[1].file, line 2 of word.csv = '1,x' must hold two finite numbers: "
            "write one point per line, y and relief in mm."
        ],
    ),
    "points and a file": (
        profile("{ kind = 'tabulated', file = 'two.csv', y = [0, 1] }"),
        ["body.a.profile[1].y = [0, 1] must not be given together with file: leave one out."],
    ),
    "table without points": (
        profile("{ kind = 'tabulated' }"),
        [f"body.a.profile[1].{key} must be given: give the lists y and relief, or a file." for key in ("y", "relief")],
    ),
    "nan in a table": (
        profile("{ kind = 'tabulated', y = [0, 1], relief = [0, nan] }"),
        ["body.a.profile[1].relief = [0, nan] must be finite: give a list of numbers in mm."],
    ),
    "diameters of two signs": (
        f"[body.a]\ndiameter = {{ y = [0, 1], diameter = [1, -1] }}\n{B}{LOAD}",
        [f"body.a.diameter.diameter = (1.0, -1.0) must be finite and of one sign: {DIAMETER_REMEDY}."],
    ),
    # Load
    "negative load": (
        f"{A}{B}[load]\nload = -5.0\n",
        ["load.load = -5.0 must be positive: give the force in N that presses the bodies together."],
    ),
    "load and approach": (
        f"{A}{B}{LOAD}approach = 0.01\n",
        ["load.approach = 0.01 must not be given together with load: leave one out."],
    ),
    "tilt and moment": (
        f"{A}{B}{LOAD}moment = 1.0\ntilt = 0.0\n",
        ["load.moment = 1.0 must not be given together with tilt: leave one out."],
    ),
    "neither load nor approach": (
        f"{A}{B}[load]\ntilt = 0.0\n",
        ["load.load must be given: give the load in N, or an approach in mm."],
    ),
    # Solver
    "unknown element": (
        f"{A}{B}{LOAD}[solver]\nelement = 'parabola'\n",
        ["solver.element = 'parabola' must be one of 'semi-elliptic', 'parabolic': the nearest is 'parabolic'."],
    ),
    "no strips": (f"{A}{B}{LOAD}[solver]\nstrips = 0\n", [f"solver.strips = 0 must {STRIPS}."]),
    "half a strip": (f"{A}{B}{LOAD}[solver]\nstrips = 40.5\n", [f"solver.strips = 40.5 must {STRIPS}."]),
    "strips in words": (
        f"{A}{B}{LOAD}[solver]\nstrips = 'many'\n",
        [f"solver.strips = 'many' must {STRIPS}."],
    ),
    # Keys and sections
    "unknown key": (
        f"{A}lenght = 20\n{B}{LOAD}",
        ["body.a.lenght = 20 must be a known key: the nearest is 'length'."],
    ),
    "unknown key like no other": (
        f"{A}material = {{ modulus = 1, poisson = 0, x = 2 }}\n{B}{LOAD}",
        [f"body.a.material.x = 2 must be a known key: {KEYS_OF_MATERIAL}."],
    ),
    "strengths of a material": (
        f"{A}case_depth = -1\n"
        f"material = {{ modulus = 1, poisson = 0, hardness = '60', yield_strength = 0 }}\n{B}{LOAD}",
        [
            "body.a.case_depth = -1.0 must be positive: give the depth of the case in mm, or leave it out.",
            "body.a.material.hardness = '60' must be a number with its scale, HV, HRC or HBW: "
            "write a number and its scale such as '60 HRC', '700 HV' or '280 HBW', or leave it out.",
            "body.a.material.yield_strength = 0.0 must be positive: "
            "give the stress in MPa, or leave it out where it is not known.",
        ],
    ),
    "unknown section": (
        f"{A}{B}{LOAD}[sovler]\n",
        ["sovler must be a known key: the nearest is 'solver'."],
    ),
    "third body": (
        f"{A}{B}[body.c]\n{LOAD}",
        ["body.c must be a known key: choose from 'a', 'b'."],
    ),
    "missing body": (f"{A}{LOAD}", ["body.b must be given: write it under a heading [body.b]."]),
    "missing load": (f"{A}{B}", ["load must be given: write it under a heading [load]."]),
    "empty file": (
        "",
        [
            "body must be given: write it under a heading [body.a] and [body.b].",
            "load must be given: write it under a heading [load].",
        ],
    ),
    "number for a section": (
        f"body = 3\n{LOAD}",
        ["body = 3 must be a section: write it under a heading [body]."],
    ),
    "text for the load": (
        f"load = '20 kN'\n{A}{B}",
        ["load = '20 kN' must be a section: write it under a heading [load]."],
    ),
    "a title of two lines": (
        f'title = "a\\nb"\n{A}{B}{LOAD}',
        [r"title = 'a\nb' must be one line of text without control characters: write a short name."],
    ),
    "a bell in a title": (
        f'title = "a\\u0007"\n{A}{B}{LOAD}',
        [r"title = 'a\x07' must be one line of text without control characters: write a short name."],
    ),
    "number for a title": (f"title = 3\n{A}{B}{LOAD}", ["title = 3 must be text: put it in quotes."]),
    # Side faces
    "misspelt side faces": refused_word(
        "side_faces", "'miror'", "be one of 'free', 'mirror', 'calibrated', 'none' or a number", FACES_REMEDY
    ),
    "negative weight": refused_word("side_faces", "-1.2", "not be negative", FACES_REMEDY),
    "weight of nan": refused_word("side_faces", "nan", "be a finite number", FACES_REMEDY),
    "weight in quotes": (with_keys("side_faces = '1'"), [f"body.a.side_faces = '1' {PLAIN}"]),
    "weight with a unit": (with_keys("side_faces = '1 mm'"), [f"body.a.side_faces = '1 mm' {PLAIN}"]),
    "side faces that are true": (
        with_keys("side_faces = true"),
        [
            "body.a.side_faces = True must be one of 'free', 'mirror', 'calibrated', 'none' or a number: "
            f"{FACES_REMEDY}."
        ],
    ),
    "table of side faces": (
        with_keys("side_faces = {}"),
        [f"body.a.side_faces must be one of 'free', 'mirror', 'calibrated', 'none' or a number: {FACES_REMEDY}."],
    ),
    "no side faces in a list": (
        with_keys("side_faces = []"),
        [f"body.a.side_faces = [] must be one value or two: {FACES_REMEDY}."],
    ),
    "three side faces": (
        with_keys("side_faces = [1, 2, 3]"),
        [f"body.a.side_faces = [1, 2, 3] must be one value or two: {FACES_REMEDY}."],
    ),
    "both side faces": (
        with_keys("side_faces = ['miror', '1']"),
        [
            "body.a.side_faces[1] = 'miror' must be one of 'free', 'mirror', 'calibrated', 'none' or a number: "
            f"{FACES_REMEDY}.",
            f"body.a.side_faces[2] = '1' {PLAIN}",
        ],
    ),
    "list in a list of side faces": (
        with_keys("side_faces = ['none', [1, 2]]"),
        [
            "body.a.side_faces[2] = [1, 2] must be one of 'free', 'mirror', 'calibrated', 'none' or a number: "
            f"{FACES_REMEDY}."
        ],
    ),
    "side faces without a length": (
        f"[body.a]\ndiameter = 20\nside_faces = 'calibrated'\n{B}{LOAD}",
        [
            "body.a.length must be given where side_faces = 'calibrated': "
            "give the distance between the side faces in mm, or leave out side_faces."
        ],
    ),
    "side faces with a misspelt length": (
        f"[body.a]\ndiameter = 20\nlenght = 20\nside_faces = 'calibrated'\n{B}{LOAD}",
        ["body.a.lenght = 20 must be a known key: the nearest is 'length'."],
    ),
    # Images
    "no image": refused_word("images", "0", NO_COUNT, IMAGES_REMEDY),
    "half an image": refused_word("images", "1.5", NO_COUNT, IMAGES_REMEDY),
    "too many images": refused_word("images", "101", NO_COUNT, IMAGES_REMEDY),
    "images in a word": refused_word("images", "'all'", NO_COUNT, IMAGES_REMEDY),
    "images in quotes": refused_word("images", "'3'", NO_COUNT, IMAGES_REMEDY),
    "images that are true": (
        with_keys("images = true"),
        [f"body.a.images = True must be 'series' or a whole number from 1 to 100: {IMAGES_REMEDY}."],
    ),
    "infinitely many images": refused_word("images", "inf", NO_COUNT, IMAGES_REMEDY),
    "list of images": refused_word("images", "[3]", NO_COUNT, IMAGES_REMEDY),
    "series without a depth": (
        f"{A}kind = 'body'\nimages = 'series'\n{B}{LOAD}",
        [
            "body.a.images = 'series' must only be used for a body with a depth, without which it has no sum: "
            "give the body a depth, or a number of images."
        ],
    ),
    # Depth
    "misspelt depth": refused_word(
        "depth",
        "'plane-strian'",
        "be one of 'none', 'plane-strain', 'diameter', 'cylinder', 'finite' or a number in mm",
        DEPTH_REMEDY,
    ),
    "no depth": refused_word("depth", "0.0", "be positive", DEPTH_REMEDY),
    "negative depth in a unit": refused_word("depth", "'-1 mm'", "be positive", DEPTH_REMEDY),
    "depth of another kind": refused_word("depth", "'8 kg'", "have a unit of length", f"write {LENGTH}"),
    "depth in quotes": refused_word("depth", "'8'", "have a unit", "write 8 without quotes if it is in mm"),
    "depth of nan": refused_word("depth", "nan", "be a finite number", DEPTH_REMEDY),
    "list of depths": refused_word(
        "depth",
        "[8]",
        "be one of 'none', 'plane-strain', 'diameter', 'cylinder', 'finite' or a number in mm",
        DEPTH_REMEDY,
    ),
    "diameter of a plate for its depth": (
        f"{A}[body.b]\ndepth = 'diameter'\n{LOAD}",
        [f"body.b.depth = 'diameter' {NOT_CONVEX}"],
    ),
    "diameter of an outer ring for its depth": (
        f"{A}[body.b]\ndiameter = -120\ndepth = 'diameter'\n{LOAD}",
        [f"body.b.depth = 'diameter' {NOT_CONVEX}"],
    ),
    "plane strain in a plate": (
        f"{A}[body.b]\nkind = 'plate'\ndepth = 'plane-strain'\n{LOAD}",
        [f"body.b.depth = 'plane-strain' {NOT_CONVEX}"],
    ),
    # Kinds of body
    "unknown kind of body": (
        f"{A}kind = 'rollr'\nimages = 'series'\n{B}{LOAD}",
        ["body.a.kind = 'rollr' must be a known kind of body: the nearest is 'roller'."],
    ),
    "number for a kind": (
        f"{A}kind = 1\n{B}{LOAD}",
        ["body.a.kind = 1 must be a known kind of body: choose from 'roller', 'ring', 'plate', 'body'."],
    ),
    "roller without diameter and length": (
        f"[body.a]\nkind = 'roller'\n{B}{LOAD}",
        [
            "body.a.diameter must be positive: give the roller's diameter in mm.",
            "body.a.length must be given: give the roller's length in mm.",
        ],
    ),
    "concave roller without a length": (
        f"[body.a]\nkind = 'roller'\ndiameter = -20\n{B}{LOAD}",
        [
            "body.a.diameter = -20.0 must be positive: give the roller's diameter in mm.",
            "body.a.length must be given: give the roller's length in mm.",
        ],
    ),
    "roller with a misspelt diameter": (
        f"[body.a]\nkind = 'roller'\ndiametr = 20\nlength = 20\n{B}{LOAD}",
        ["body.a.diametr = 20 must be a known key: the nearest is 'diameter'."],
    ),
    "flat ring": (
        f"{A}[body.b]\nkind = 'ring'\n{LOAD}",
        ["body.b.diameter must be given: give the raceway's diameter in mm, negative for an outer ring."],
    ),
    "round plate": (
        f"{A}[body.b]\nkind = 'plate'\ndiameter = 20\n{LOAD}",
        ["body.b.diameter = 20.0 must be left out: make a curved one a roller or a ring, or leave its kind open."],
    ),
    "all of a finite body": (
        f"{A}kind = 'roller'\nside_faces = 'clibrated'\nimages = 0\ndepth = '8 N'\neffective_length = 21\n{B}{LOAD}",
        [
            "body.a.side_faces = 'clibrated' must be one of 'free', 'mirror', 'calibrated', 'none' or a number: "
            f"{FACES_REMEDY}.",
            f"body.a.images = 0 must be 'series' or a whole number from 1 to 100: {IMAGES_REMEDY}.",
            f"body.a.depth = '8 N' must have a unit of length: write {LENGTH}.",
            "body.a.effective_length = 21.0 must not exceed the length of 20 mm: "
            "give the length that can touch in mm, or leave it out for all of the body.",
        ],
    ),
    # Bodies that do not go together
    "bodies that never meet": (
        f"{A}{B}position = 30\nlength = 5\n{LOAD}",
        ["body.b.position = 30.0 must let the bodies overlap along y: move one body or lengthen it."],
    ),
    "conforming bodies": (
        f"{A}{B}diameter = -20\n{LOAD}",
        [
            "body.b.diameter = -20.0 must leave a positive combined curvature with body.a.diameter = 20.0: "
            "make the concave body's diameter larger than the convex one's."
        ],
    ),
    "concave body on a flat one": (
        f"[body.a]\ndiameter = -20\nlength = 5\n{B}{LOAD}",
        [
            "body.a.diameter = -20.0 must leave a positive combined curvature with body.b, which is flat: "
            "make the concave body's diameter larger than the convex one's."
        ],
    ),
    "body in a changing one that is narrower somewhere": (
        f"[body.a]\ndiameter = {{ y = [-10, 10], diameter = [-30, -19] }}\n[body.b]\ndiameter = 20\n{LOAD}",
        [
            "body.a.diameter must leave a positive combined curvature with body.b.diameter = 20.0: "
            "make the concave body's diameter larger than the convex one's."
        ],
    ),
    "two flat bodies": (
        f"[body.a]\nlength = 20\n{B}{LOAD}",
        ["body.a.diameter must be given: the bodies are both flat, so give the diameter of one of them in mm."],
    ),
    "several": (
        f"{A}lenght = 3\n{B}material = 'bras'\n[load]\nload = -1\ntilt = '5 kg'\n",
        [
            "body.a.lenght = 3 must be a known key: the nearest is 'length'.",
            "body.b.material = 'bras' must be a known material: "
            "give a name such as 'steel', 'nonhertz materials' lists them all, or modulus and poisson.",
            "load.load = -1.0 must be positive: give the force in N that presses the bodies together.",
            "load.tilt = '5 kg' must have a unit of angle: "
            "write a number in rad, or text with a unit of angle such as '0.5 mrad' or '8 um/25 mm'.",
        ],
    ),
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "empty.csv").write_text("", encoding="utf-8")
    (tmp_path / "word.csv").write_text("0,0\n1,x\n", encoding="utf-8")
    (tmp_path / "two.csv").write_text("0,0\n1,0\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def numbered(sentences: list[str]) -> list[str]:
    return [f"{number}. {sentence}" for number, sentence in enumerate(sentences, start=1)]


@pytest.mark.parametrize(("text", "sentences"), MISTAKES.values(), ids=MISTAKES)
def test_each_mistake_is_one_sentence(
    folder: Path, capsys: pytest.CaptureFixture[str], text: str, sentences: list[str]
) -> None:
    (folder / "case.toml").write_text(text, encoding="utf-8")

    assert main(["solve", "case.toml", "--json", "--out", "results"]) == 2
    solved = capsys.readouterr()
    assert solved.out == ""
    assert solved.err.splitlines() == (sentences if len(sentences) == 1 else numbered(sentences))
    assert not (folder / "results").exists()

    assert main(["check", "case.toml"]) == 2
    checked = capsys.readouterr()
    assert checked.out.splitlines() == numbered(sentences)
    assert checked.err == ""


FILES = {
    "not there": (None, "must exist: give the path of a case file, or begin with one from 'nonhertz new case.toml'."),
    "not TOML": (b"[body.a]\nlength = \n", "must be valid TOML: invalid value (at line 2, column 10)."),
    "a key twice": (b"a = 1\na = 2\n", "must be valid TOML: cannot overwrite a value (at line 2, column 6)."),
    "not closed": (
        b"[body",
        "must be valid TOML: expected ']' at the end of a table declaration (at end of document).",
    ),
    "not text": (
        b'title = "a"\n\xff\xfe',
        ", line 2, must be text in UTF-8: save the file with that encoding.",
    ),
    "too deep": (b"a = " + b"[" * 5000, "must be valid TOML: lists or tables are nested too deeply."),
    "too long a number": (b"a = 1" + b"0" * 5000, "must be valid TOML: a number has thousands of digits."),
}


@pytest.mark.parametrize(("content", "sentence"), FILES.values(), ids=FILES)
@pytest.mark.parametrize("command", ["solve", "check"])
def test_files_that_cannot_be_read(
    folder: Path, capsys: pytest.CaptureFixture[str], command: str, content: bytes | None, sentence: str
) -> None:
    if content is not None:
        (folder / "case.toml").write_bytes(content)
    assert main([command, "case.toml"]) == 2
    printed = "".join(capsys.readouterr())
    if command == "check":
        sentence = sentence.replace("a case file,", "a case file, bearing file or plan file,")
    space = "" if sentence.startswith(",") else " "
    assert printed.removeprefix("1. ") == f"case.toml{space}{sentence}\n"


def test_a_directory_is_no_case_file(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "."]) == 2
    assert capsys.readouterr().err == ". must be a file, not a directory: give the path of a case file.\n"


def test_what_only_the_solver_sees_is_a_sentence_too(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # A cylinder without ends on a plane without ends: nothing ends the contact.
    (folder / "case.toml").write_text(f"[body.a]\ndiameter = 20\n{B}{LOAD}", encoding="utf-8")
    assert main(["solve", "case.toml"]) == 2
    sentence = capsys.readouterr().err
    assert sentence.startswith("body.a.length must be given where nothing else ends the contact: ")
    assert len(sentence.splitlines()) == 1
    assert main(["check", "case.toml"]) == 2
    assert capsys.readouterr().out == f"1. {sentence}"


def test_a_complaint_of_the_solver_about_both_bodies_names_keys_of_the_file() -> None:
    with pytest.raises(nh.InputError) as caught:
        nh.Contact(nh.Roller(diameter=20.0, length=20.0), nh.Ring(diameter=-10.0)).curvature(0.0)
    complaint = placed(caught.value)
    assert complaint.places == ("body.b.diameter",)
    assert str(complaint).startswith("body.b.diameter = -10.0 must leave a positive combined curvature with body.a")


def test_a_complaint_names_the_key_that_it_is_about(folder: Path) -> None:
    document = {"body": {"a": {"lenght": 20.0, "profile": [{"kind": "crown", "radius": 0.0}]}, "b": {}}, "load": {}}
    with pytest.raises(nh.CaseError) as caught:
        Case.of(document, folder / "case.toml")
    found = dict(zip(caught.value.places, caught.value.mistakes, strict=True))
    assert set(found) >= {"body.a.lenght", "body.a.profile[1].radius", "load.load"}
    assert all(sentence.startswith(place) for place, sentence in found.items())


def test_a_document_from_elsewhere_cannot_have_files_read(folder: Path) -> None:
    (folder / "points.csv").write_text("-10, 0.01\n10, 0.01\n", encoding="utf-8")
    table = {"kind": "tabulated", "file": "points.csv"}
    document = {"body": {"a": {"diameter": 20.0, "length": 20.0, "profile": [table]}, "b": {}}, "load": {"load": 1e3}}
    assert Case.of(document, folder / "case.toml").contact.a.profile.extent == (-10.0, 10.0)
    with pytest.raises(nh.CaseError, match="not be read here") as caught:
        Case.of(document, folder / "case.toml", files=False)
    assert caught.value.places == ("body.a.profile[1].file",)


def test_a_body_thinner_than_its_contact_is_wide_is_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "case.toml").write_text(with_keys("depth = '0.3 mm'"), encoding="utf-8")
    assert main(["solve", "case.toml"]) == 2
    sentence = capsys.readouterr().err
    assert sentence.startswith("body.a.depth = 0.3 must be large compared with the half-width of the contact")
    assert len(sentence.splitlines()) == 1


BODY_MISTAKES: list[dict[str, Any]] = [
    {"side_faces": "miror"},
    {"side_faces": -1.0},
    {"side_faces": []},
    {"images": 0},
    {"images": "all"},
    {"images": "series", "depth": "none"},
    {"depth": "plane-strian"},
    {"depth": 0.0},
    {"diameter": -20.0},
]


@pytest.mark.parametrize("keys", BODY_MISTAKES, ids=str)
def test_a_body_is_refused_in_the_words_of_python(
    folder: Path, capsys: pytest.CaptureFixture[str], keys: dict[str, Any]
) -> None:
    given = {"diameter": 20.0, "length": 20.0} | keys
    with pytest.raises(nh.InputError) as caught:
        nh.Roller(**given)
    written = "".join(f"{key} = {value!r}\n" for key, value in given.items())
    (folder / "case.toml").write_text(f"[body.a]\nkind = 'roller'\n{written}{B}{LOAD}", encoding="utf-8")
    assert main(["solve", "case.toml"]) == 2
    assert capsys.readouterr().err == f"{caught.value.within('body.a')}\n"


@pytest.mark.parametrize(
    ("keys", "arguments"),
    [
        ("load = -5.0", {"load": -5.0}),
        ("load = inf", {"load": float("inf")}),
        ("approach = nan", {"approach": float("nan")}),
        ("load = 1.0\ntilt = nan", {"load": 1.0, "tilt": float("nan")}),
        ("load = 1.0\nmoment = inf", {"load": 1.0, "moment": float("inf")}),
    ],
)
def test_a_file_is_refused_in_the_words_of_python(
    folder: Path, capsys: pytest.CaptureFixture[str], keys: str, arguments: dict[str, float]
) -> None:
    contact = nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate())
    with pytest.raises(nh.InputError) as caught:
        nh.solve(contact, **arguments)
    (folder / "case.toml").write_text(f"{A}{B}[load]\n{keys}\n", encoding="utf-8")
    assert main(["solve", "case.toml"]) == 2
    assert capsys.readouterr().err == f"{caught.value.within('load')}\n"


@pytest.mark.parametrize(
    ("words", "beginning"),
    [
        (["slove", "case.toml"], 'Unknown command "slove". Did you mean "solve"? See \''),
        (["solve"], 'Command "solve" parameter CASE requires an argument'),
        (["check", "a", "b"], "This command takes no 'b'; see"),
        (["solve", "a", "--jsn"], "Unknown option: --jsn. Did you mean --json?"),
        (["check"], 'Command "check" parameter FILE requires an argument'),
    ],
)
def test_wrong_usage_is_one_sentence(capsys: pytest.CaptureFixture[str], words: list[str], beginning: str) -> None:
    assert main(words) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith(beginning)
    assert printed.err.endswith(("; see 'nonhertz --help'.\n", "? See 'nonhertz --help'.\n"))
    assert len(printed.err.splitlines()) == 1
