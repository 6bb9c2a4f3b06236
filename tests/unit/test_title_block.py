"""Title blocks in case files and bearing files, and logos: what is read, cleaned and refused."""

from __future__ import annotations

import base64
from dataclasses import replace
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.errors import CaseError, InputError
from nonhertz.io.bearingfile import starting_bearing
from nonhertz.io.casefile import starting_case
from nonhertz.io.logo import LARGEST, logo_from
from nonhertz.io.title_block import TitleBlock
from nonhertz.web.form.form import form
from nonhertz.web.form.inlining import inlined

PNG = b"\x89PNG\r\n\x1a\n and so on"
HOSTILE = """<?xml version="1.0"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 9 9" onload="bad()">
  <script>bad()</script><style>@import "http://bad";</style><style>.a { fill: red }</style>
  <a xlink:href="http://bad"><rect width="1"/></a>
  <foreignObject><p xmlns="http://www.w3.org/1999/xhtml">bad</p></foreignObject>
  <image href="http://bad/x.png" width="2"/><use href="#good"/><animate onbegin="bad()"/>
  <rect class="a" fill="url(http://bad)" style="fill: url( 'http://bad' )" stroke="url(#good)" OnClick="bad()"/>
</svg>"""
TABLE = '\n[report]\nproject = "Gearbox"\nremarks = "One.\\n\\nTwo."\nlogo = "logo.png"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "logo.png").write_bytes(PNG)
    (tmp_path / "logo.svg").write_text(HOSTILE, encoding="utf-8")
    (tmp_path / "case.toml").write_text(starting_case() + TABLE, encoding="utf-8")
    (tmp_path / "bearing.toml").write_text(starting_bearing() + TABLE, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(("name", "read"), [("case.toml", nh.read_case), ("bearing.toml", nh.read_bearing)])
def test_a_title_block_is_read_and_written(folder: Path, name, read) -> None:
    case = read(folder / name)
    assert case.title_block.lines == (("project", "Gearbox"),)
    assert case.title_block.paragraphs == ("One.", "Two.")
    assert case.title_block.logo.content == PNG
    assert case.attachments["logo.png"] == PNG
    # Written elsewhere it has no need of the file.
    (folder / "new").mkdir()
    case.write(folder / "new" / "copy.toml")
    assert read(folder / "new" / "copy.toml").title_block == case.title_block
    assert replace(case, title_block=TitleBlock(author="A")).document["report"] == {"author": "A"}


def test_what_is_left_of_an_svg_file_only_draws(folder: Path) -> None:
    left = logo_from("logo.svg", folder).content.decode()
    for gone in ("bad", "script", "foreignObject", "import", "onload", "OnClick", "DOCTYPE", "<a", "animate"):
        assert gone not in left, gone
    for kept in ('viewBox="0 0 9 9"', ".a { fill: red }", 'href="#good"', 'stroke="url(#good)"', 'class="a"'):
        assert kept in left, kept


@pytest.mark.parametrize(
    ("name", "content", "condition"),
    [
        ("a.png", b"GIF89a", "be a PNG or SVG file"),
        ("a.svg", b"<html xmlns='http://www.w3.org/1999/xhtml'/>", "be a PNG or SVG file"),
        ("a.svg", b"<svg/>", "be a PNG or SVG file"),
        ("a.svg", b"<!DOCTYPE svg [<!ENTITY a 'b'>]><svg xmlns='http://www.w3.org/2000/svg'/>", "entities"),
        ("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>".encode("utf-16"), "UTF-8"),
        ("a.png", PNG + bytes(LARGEST), "have at most 200 kB"),
    ],
)
def test_other_files_are_refused(folder: Path, name: str, content: bytes, condition: str) -> None:
    (folder / name).write_bytes(content)
    with pytest.raises(InputError, match=condition):
        logo_from(name, folder)
    with pytest.raises(InputError, match=condition):
        logo_from(f"data:image/png;base64,{base64.b64encode(content).decode()}", None)


@pytest.mark.parametrize("text", ["data:text/html;base64,AAAA", "data:image/png;base64,A", "data:image/png,AAAA"])
def test_other_data_is_refused(text: str) -> None:
    with pytest.raises(InputError, match="be a data URI in base64"):
        logo_from(text, None)


def test_all_mistakes_of_a_title_block_are_named(folder: Path) -> None:
    wrong = '\n[report]\nproject = 7\nauthor = "two\\nlines"\ndate = 2026-11-23\nlogo = "none.svg"\nauthors = "A"\n'
    (folder / "case.toml").write_text(starting_case() + wrong, encoding="utf-8")
    with pytest.raises(CaseError) as caught:
        nh.read_case(folder / "case.toml")
    assert set(caught.value.places) == {f"report.{name}" for name in ("project", "author", "date", "logo", "authors")}


def test_the_page_has_the_fields_and_holds_the_logo_itself(folder: Path) -> None:
    document, _ = inlined(nh.read_case(folder / "case.toml").document, folder)
    assert document["report"]["logo"] == logo_from("logo.png", folder).address
    (group,) = [each for each in form(document).folded if each.path == "report"]
    shown = [field.path for field in group.members]
    names = ("project", "author", "revision", "date", "remarks", "logo")
    assert shown == [f"report.{name}" for name in names]
    (group,) = [each for each in form({}).folded if each.path == "report"]
    assert "report.logo" not in [field.path for field in group.members]
