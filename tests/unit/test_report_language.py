"""Reports in other languages: every sentence has a translation, and nothing English is left on the page."""

from __future__ import annotations

import ast
import re
import tomllib
import warnings
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from few_rollers import PAIR, SIX, changed

import nonhertz as nh
import nonhertz.report.bearing.page
import nonhertz.report.page
from nonhertz.bodies.depths import DEPTHS
from nonhertz.errors import InputError
from nonhertz.io.bearingfile import BearingCase, bearing_in, bearing_schema, read_bearing
from nonhertz.io.casefile import Case, parsed, schema, starting_case
from nonhertz.io.title_block import ENGLISH, LANGUAGES, TitleBlock
from nonhertz.measured import Trace, prepare
from nonhertz.report import compose
from nonhertz.report.assumptions import ENDS, Verdict
from nonhertz.report.language import Language
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.reading import in_letters
from nonhertz.result.solution import EdgeKind, Status
from nonhertz.show.lives import LIFE_COLUMNS, SPECTRUM_COLUMNS
from nonhertz.show.stresses import COLUMNS, NAMES

OTHERS = [code for code in LANGUAGES if code != ENGLISH]
PACKAGE = Path(nh.__file__).parent
# Where sentences are worded that reach a report only now and then.
WARNING = (
    *("bearing/solution.py", "measured/chain.py", "measured/roughness.py", "result/checks.py", "result/outcome.py"),
    *("result/validity.py", "strip/acceptance.py", "life/assessment.py", "bearing/verb.py", "bearing/strips.py"),
)
FOLDER = Path(__file__).parents[2] / "examples"
EXAMPLES = sorted(path for path in FOLDER.glob("*.toml") if "[body.a]" in path.read_text("utf-8"))
BEARINGS = sorted(path for path in FOLDER.glob("*.toml") if "[bearing]" in path.read_text("utf-8"))
# Words of sentences, none of which is German; titles of the examples have some, and are left out.
ENGLISH_WORDS = re.compile(
    r"\b(the|of|is|are|and|with|not|where|from|to|by|at|no|its|which|than|ends?|length|load|both|pressure|width|"
    r"inner|outer|rollers?|rows?|slices|strips|degrees|under|about|along|against|life|ribs?|without|whose)\b",
    re.I,
)
# Words in quotation marks, tables in brackets, and keys such as body.a.profile[1].length.
OF_FILES = re.compile(r"„[^“]*“|\[[a-z.]+\]|\b[a-z_]+(?:\.[a-z_]+(?:\[\d+\])?)+")
# Tables of the schemas whose keys a report shows.
SHOWN = ("BodyTable", "LoadTable", "SolverTable", "LifeTable")
OF_BEARINGS = (
    *("BearingTable", "PairTable", "RollerTable", "RacewayTable", "BearingLoadTable", "BearingSolverTable"),
    *("BearingLifeTable", "FitTable", "ShaftTable", "HousingTable"),
)
NOT_SHOWN = {
    *(("BodyTable", "profile"), ("RollerTable", "profile"), ("RacewayTable", "profile")),
    *(("BearingTable", "kind"), ("BearingTable", "pair"), ("FitTable", "shaft"), ("FitTable", "housing")),
    *(("RollerTable", "kind"), ("RacewayTable", "kind")),
}
CYLINDRICAL = changed(SIX, ('"six"', '"Sechs"')) + 'speed = "1500 rpm"\n'
RIB = "rib = { end_radius = 140, height = 4.8 }"
TAPERED = changed(PAIR, ('"pair"', '"Paar"'), ("pair = ", f"{RIB}\npair = "))
SPHERICAL = """
title = "Tonnen"
[bearing]
kind = "spherical"
rollers = 7
contact_angle = "10 deg"
profile_radius = 60
inner_groove = 61.5
outer_groove = 61.5
clearance = "30 um"
pair = { arrangement = "X", distance = 20 }
[roller]
diameter = 12
length = 14
side_faces = "none"
depth = "none"
[inner]
diameter = 60
[outer]
diameter = -84.35
[load]
radial = ["20 kN", "5 kN"]
axial = "2 kN"
"""
THRUST = """
title = "Scheiben"
[bearing]
kind = "thrust"
rollers = 8
pitch_diameter = 60
[roller]
diameter = 8
length = 8
corner_radius = 0.4
side_faces = "mirror"
depth = "none"
[inner]
[outer]
[load]
axial = "20 kN"
moment = "1 N m"
"""
SLICES = '[solver]\nmethod = "slices"\n'
RIBS = """rollers = 6
design = "NUP"
axial_clearance = "50 um"
density = "3.2 g/cm^3"
rib = { end_radius = 300, height = 4.2, edge = 3.9 }
inner_shape = { terms = [{ waves = 2, amplitude = "5 um" }] }
outer_shape = { angle = [0, 1, 2], deviation = [0, 0.003, 0] }
"""
SPECTRUM = """
[life]
viscosity = 20
cleanliness = "high"
[[life.spectrum]]
radial = "4 kN"
share = 0.5
[[life.spectrum]]
radial = "6 kN"
share = 0.3
"""


def changed(text: str, *changes: tuple[str, str]) -> str:
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


OF_KINDS = {
    "tapered": [TAPERED, changed(TAPERED, ("8 kN", "9 kN"), ("-40 um", "-20 um")), TAPERED + SLICES],
    "spherical": [SPHERICAL],
    "thrust": [THRUST, changed(THRUST, ("[inner]", '[inner]\nmaterial = "silicon-nitride"'), ("mirror", "none"))],
    "needle": [changed(CYLINDRICAL, ("cylindrical", "needle"), ('tilt = "0.2 mrad"', 'moment = ["1 N m", "2 N m"]'))],
    "ribs": [
        changed(CYLINDRICAL, ("rollers = 6\n", RIBS), ('tilt = "0.2 mrad"', 'axial = "300 N"')),
        changed(CYLINDRICAL, ("rollers = 6", 'rollers = 6\ndesign = "NJ"'), ('tilt = "0.2 mrad"', 'axial = "300 N"')),
    ],
    "moved": [
        changed(CYLINDRICAL, ('radial = "5 kN"', 'radial_displacement = "20 um"\naxial_displacement = 0')),
        changed(CYLINDRICAL, ('radial = "5 kN"\ntilt = "0.2 mrad"\nspeed = "1500 rpm"\n', "")),
        changed(CYLINDRICAL, ("5 kN", "60 kN"), ("0.2 mrad", "12 mrad")),
    ],
    "spectrum": [changed(CYLINDRICAL, ('radial = "5 kN"\ntilt = "0.2 mrad"\n', "")) + SPECTRUM],
    "unsolved": [
        changed(CYLINDRICAL, ('depth = "none"\n[inner]', 'depth = "cylinder"\n[inner]\ndepth = 0.05\nlength = 8'))
    ],
}


class Listening(Language):
    """A language that remembers what it said."""

    def __init__(self, code: str) -> None:
        super().__init__(code)
        self.said: list[str] = []

    def __call__(self, text: str) -> str:
        self.said.append(super().__call__(text))
        return self.said[-1]


class Words(HTMLParser):
    """The text of a page in its own language: no code, no files, no references."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[tuple[str, bool]] = []
        self.found: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in {"meta", "br", "img", "link"}:
            other = dict(attrs).get("lang") in {"en", "zxx"} and tag != "html"
            self.open.append((tag, other or tag in {"style", "code", "pre", "svg", "title", "h1"}))

    def handle_endtag(self, tag: str) -> None:
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data: str) -> None:
        if data.strip() and not any(other for _, other in self.open):
            self.found.append(data.strip())


def sentences() -> Iterator[str]:
    """Yield words that a report may show and that stand in one place each."""
    yield from (each.value for each in Verdict)
    yield from (remark for _, remark in ENDS.values() if remark)
    yield from (quantity.label for quantity in QUANTITIES.values())
    for status in Status:
        yield from (status.label, status.value)
    for kind in EdgeKind:
        yield f"At y = 1.5 mm: {kind.value[0].lower()}{kind.value[1:]}"
    for depth in DEPTHS.values():
        yield f"Displacement of body a is measured against {depth.place}."
    yield from filter(None, (*COLUMNS[:3], *NAMES.values(), *LIFE_COLUMNS, *SPECTRUM_COLUMNS))
    tables = schema()["$defs"]
    for table, of_table in [(each, tables) for each in SHOWN] + [
        (each, bearing_schema()["$defs"]) for each in OF_BEARINGS
    ]:
        for key, property_ in of_table[table]["properties"].items():
            if (table, key) not in NOT_SHOWN and property_.get("description"):
                yield property_["description"]
    for kind in tables["BodyTable"]["properties"]["profile"]["anyOf"][0]["anyOf"]:
        what = kind["description"].rstrip(".")
        yield what[:1].upper() + what[1:]
        for key, property_ in kind["properties"].items():
            if key != "kind":
                yield property_.get("description", "").replace("`", "").rstrip(".")


def single_contacts(paths: list[Path]) -> list[Case]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        return [nh.read_case(path) for path in paths]


def german_page(
    cases: list[Case] | list[BearingCase], monkeypatch: pytest.MonkeyPatch, **options: bool
) -> tuple[str, Listening]:
    languages: list[Listening] = []

    def made(code: str) -> Language:
        languages.append(Listening(code))
        return languages[-1]

    for module in (nonhertz.report.page, nonhertz.report.bearing.page):
        monkeypatch.setattr(module, "Language", made)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        page = compose(cases, title_block=TitleBlock(language="de"), **options)
    (language,) = languages
    names = [name for case in cases for name in (case.title, Path(case.file_name).stem)]
    language.said = [_without(names, said) for said in language.said]
    return _without(names, page), language


def _without(names: list[str], text: str) -> str:
    for name in names:
        text = text.replace(name, "")
    return text


def is_english(words: str) -> bool:
    """Return whether a text has English words beside those of case files."""
    return ENGLISH_WORDS.search(OF_FILES.sub("", words)) is not None


def refuse_english(page: str, language: Listening) -> None:
    assert language.missing == set()
    assert [words for words in language.said if is_english(words)] == []
    assert [words for words in Words(page).found if is_english(words)] == []


def test_every_language_has_its_file() -> None:
    folder = Path(nonhertz.report.page.__file__).parent / "languages"
    assert sorted(path.stem for path in folder.glob("*.toml")) == sorted(OTHERS)


@pytest.mark.parametrize("code", OTHERS)
def test_every_sentence_has_a_translation(code: str) -> None:
    language = Language(code)
    for sentence in sentences():
        assert not is_english(language(sentence)), sentence
    assert language.missing == set()


def warnings_of(module: str) -> Iterator[list[str | None]]:
    """Yield the sentences that a module words, in pieces of text with None for what is put in between."""
    tree = ast.parse((PACKAGE / module).read_text("utf-8"))
    parts = {part for each in ast.walk(tree) if isinstance(each, ast.JoinedStr) for part in each.values}
    for each in ast.walk(tree):
        if isinstance(each, ast.Expr):  # a docstring
            parts.add(each.value)
    for each in ast.walk(tree):
        whole = isinstance(each, ast.JoinedStr | ast.Constant) and each not in parts
        values = each.values if isinstance(each, ast.JoinedStr) else [each]
        pieces = [str(part.value) if isinstance(part, ast.Constant) else None for part in values]
        if whole and len(_with(pieces, "1").split()) > 3 and (pieces[-1] or "").endswith("."):
            yield pieces


def _with(pieces: list[str | None], put_in: str) -> str:
    return "".join(put_in if piece is None else piece for piece in pieces)


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("module", WARNING)
def test_every_warning_has_a_translation(code: str, module: str) -> None:
    table = tomllib.loads((PACKAGE / "report" / "languages" / f"{code}.toml").read_text("utf-8"))
    entries = [re.split(r"(?<!_)(\{\w+\})", english) for part in table.values() for english in part]
    keys = [[None if number % 2 else piece for number, piece in enumerate(pieces)] for pieces in entries]
    found = list(warnings_of(module))
    assert found
    for sentence in found:
        # What is put in may be words that an entry has, and the other way round.
        assert any(_fits(sentence, key) or _fits(key, sentence) for key in keys), _with(sentence, "{}")


def _fits(pieces: list[str | None], other: list[str | None]) -> bool:
    pattern = "".join(".+" if piece is None else re.escape(piece) for piece in pieces)
    return re.fullmatch(pattern, _with(other, "1")) is not None


@pytest.mark.parametrize("cornered", [True, False])
@pytest.mark.parametrize(
    "options",
    [
        {},
        {"corner": "cut", "points": False},
        {"align": "symmetry", "smooth": "spline"},
        {"trim": 12.0, "points": 1000},
        {"align": False, "trim": False, "smooth": False},
    ],
)
def test_every_step_from_measured_points_has_a_translation(cornered: bool, options: dict[str, Any]) -> None:
    y = np.linspace(0.0, 20.0, 4001)
    beyond = np.maximum(np.abs(y - 10.0) - 9.0, 0.0) if cornered else 0.0
    rough = 1e-4 * np.random.default_rng(1).standard_normal(y.size)
    measured = prepare(Trace(y, 1e-3 * y - (y - 10.2) ** 4 / 5e5 - beyond**2 / 1.2 + rough), **options)
    for code in OTHERS:
        language = Language(code)
        for sentence in (*(in_letters(state.words) for state in measured.states), *measured.warnings):
            assert not is_english(language(sentence)), sentence
        assert language.missing == set()


def test_text_without_a_translation_stays_and_is_remembered() -> None:
    german = Language("de")
    assert german("An unheard-of sentence with 1.5 mm.") == "An unheard-of sentence with 1,5 mm."
    assert german.missing == {"An unheard-of sentence with 1.5 mm."}
    assert Language("en")("An unheard-of sentence with 1.5 mm.") == "An unheard-of sentence with 1.5 mm."


@pytest.mark.parametrize(
    ("english", "german"),
    [
        ("at y = -1.25 mm", "bei y = -1,25 mm"),
        ("1.5e-05", "1,5e-05"),
        ("0, 1.25, -0.5 kN", "0; 1,25; -0,5 kN"),
        ("case 1.2.3, page 4", "case 1.2.3, page 4"),
        (
            "A roller (diameter 9.5 mm, steel) and a plate (flat, steel) are pressed together with 1 N.",
            "Eine Rolle (Durchmesser 9,5 mm, Stahl) und eine Platte (eben, Stahl) werden mit 1 N aufeinandergedrückt.",
        ),
    ],
)
def test_places_are_translated_and_numbers_have_a_comma(english: str, german: str) -> None:
    assert Language("de")(english) == german


def test_thousands_are_separated_as_usual() -> None:
    assert Language("de").whole(1234567) == "1.234.567"
    assert Language("en").whole(1234567) == "1,234,567"


def test_a_german_report_has_nothing_english(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "case.toml").write_text(starting_case() + '\n[report]\nproject = "Getriebe"\n', encoding="utf-8")
    page, language = german_page(single_contacts([tmp_path / "case.toml"]), monkeypatch, stress=False)
    refuse_english(page, language)
    assert '<html lang="de">' in page
    assert "<dt>Projekt</dt><dd>Getriebe</dd>" in page
    assert re.search(r"<dt>größte Pressung</dt><dd><b>\d+,\d</b> MPa", page)


@pytest.mark.slow
def test_german_reports_of_all_examples_have_nothing_english(monkeypatch: pytest.MonkeyPatch) -> None:
    refuse_english(*german_page(single_contacts(EXAMPLES[:1]), monkeypatch, life=True))
    refuse_english(*german_page(single_contacts(EXAMPLES[1:]), monkeypatch))


@pytest.mark.slow
@pytest.mark.parametrize("kind", OF_KINDS)
def test_a_german_report_of_bearings_has_nothing_english(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    cases = [
        bearing_in(parsed(text, name), Path(name), text, files=False)
        for name, text in zip(("eins.toml", "zwei.toml", "drei.toml"), OF_KINDS[kind], strict=False)
    ]
    page, language = german_page(cases, monkeypatch, compare=kind in {"tapered", "spherical"})
    refuse_english(page, language)
    assert '<html lang="de">' in page
    assert "Ganzes Lager, Rollen und Ringe im Gleichgewicht" in page


@pytest.mark.slow
def test_german_reports_of_bearings_of_all_examples_have_nothing_english(monkeypatch: pytest.MonkeyPatch) -> None:
    refuse_english(*german_page([read_bearing(path) for path in BEARINGS], monkeypatch))


def test_a_bearing_file_names_its_language(tmp_path: Path) -> None:
    text = f'{CYLINDRICAL}{SLICES}[report]\nlanguage = "de"\n'
    (tmp_path / "bearing.toml").write_text(text, encoding="utf-8")
    page = compose([read_bearing(tmp_path / "bearing.toml")])
    assert re.search(r"<dt>größte Rollenlast</dt><dd><b>\d,\d+</b> kN", page)


def test_other_languages_are_refused() -> None:
    with pytest.raises(InputError, match=r"^language = 'fr' must be 'en' or 'de': "):
        TitleBlock(language="fr")
