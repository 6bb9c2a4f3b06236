"""Reports in other languages: every sentence has a translation, and nothing English is left on the page."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path

import pytest

import nonhertz as nh
import nonhertz.report.page
from nonhertz.bodies.depths import DEPTHS
from nonhertz.errors import InputError
from nonhertz.io.bearingfile import starting_bearing
from nonhertz.io.casefile import schema, starting_case
from nonhertz.io.title_block import ENGLISH, LANGUAGES, TitleBlock
from nonhertz.report import compose
from nonhertz.report.assumptions import ENDS, Verdict
from nonhertz.report.language import Language
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import EdgeKind, Status
from nonhertz.show.lives import LIFE_COLUMNS, SPECTRUM_COLUMNS
from nonhertz.show.stresses import COLUMNS, NAMES

OTHERS = [code for code in LANGUAGES if code != ENGLISH]
EXAMPLES = sorted(
    path for path in (Path(__file__).parents[2] / "examples").glob("*.toml") if "[body.a]" in path.read_text("utf-8")
)
# Words of sentences, none of which is German; titles of the examples have some, and are left out.
ENGLISH_WORDS = re.compile(
    r"\b(the|of|is|are|and|with|not|where|from|to|by|at|no|its|which|than|ends?|length|load|both|pressure|width)\b",
    re.I,
)
# Words in quotation marks, tables in brackets, and keys such as body.a.profile[1].length.
OF_FILES = re.compile(r"„[^“]*“|\[[a-z.]+\]|\b[a-z_]+(?:\.[a-z_]+(?:\[\d+\])?)+")
# Tables of the schema whose keys a report shows.
SHOWN = ("BodyTable", "LoadTable", "SolverTable", "LifeTable")


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
    yield from (each.label for each in Status)
    for kind in EdgeKind:
        yield f"At y = 1.5 mm: {kind.value[0].lower()}{kind.value[1:]}"
    for depth in DEPTHS.values():
        yield f"Displacement of body a is measured against {depth.place}."
    yield from filter(None, (*COLUMNS[:3], *NAMES.values(), *LIFE_COLUMNS, *SPECTRUM_COLUMNS))
    tables = schema()["$defs"]
    for table in SHOWN:
        for key, property_ in tables[table]["properties"].items():
            if (table, key) != ("BodyTable", "profile"):
                yield property_["description"]
    for kind in tables["BodyTable"]["properties"]["profile"]["anyOf"][0]["anyOf"]:
        what = kind["description"].rstrip(".")
        yield what[:1].upper() + what[1:]
        for key, property_ in kind["properties"].items():
            if key != "kind":
                yield property_.get("description", "").replace("`", "").rstrip(".")


def german_page(paths: list[Path], monkeypatch: pytest.MonkeyPatch, **options: bool) -> tuple[str, Language]:
    languages = []

    def made(code: str) -> Language:
        languages.append(Language(code))
        return languages[-1]

    monkeypatch.setattr(nonhertz.report.page, "Language", made)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        cases = [nh.read_case(path) for path in paths]
        page = compose(cases, title_block=TitleBlock(language="de"), **options)
    (language,) = languages
    for case in cases:
        page = page.replace(case.title, "").replace(Path(case.file_name).stem, "")
    return page, language


def is_english(words: str) -> bool:
    """Return whether a text has English words beside those of case files."""
    return ENGLISH_WORDS.search(OF_FILES.sub("", words)) is not None


def refuse_english(page: str, language: Language) -> None:
    assert language.missing == set()
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
    page, language = german_page([tmp_path / "case.toml"], monkeypatch, stress=False)
    refuse_english(page, language)
    assert '<html lang="de">' in page
    assert "<dt>Projekt</dt><dd>Getriebe</dd>" in page
    assert re.search(r"<dt>größte Pressung</dt><dd><b>\d+,\d</b> MPa", page)


@pytest.mark.slow
def test_german_reports_of_all_examples_have_nothing_english(monkeypatch: pytest.MonkeyPatch) -> None:
    refuse_english(*german_page(EXAMPLES[:1], monkeypatch, life=True))
    refuse_english(*german_page(EXAMPLES[1:], monkeypatch))


def test_other_languages_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"^language = 'fr' must be 'en' or 'de': "):
        TitleBlock(language="fr")
    (tmp_path / "bearing.toml").write_text(starting_bearing(), encoding="utf-8")
    with pytest.raises(InputError, match=r"^language = 'de' must be 'en' for bearings: "):
        compose([nh.read_bearing(tmp_path / "bearing.toml")], title_block=TitleBlock(language="de"))
