"""The heads of reports in case files and bearing files: what is read, written and refused."""

from dataclasses import replace

import pytest

import nonhertz as nh
from nonhertz.errors import CaseError
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.title_block import TitleBlock
from nonhertz.web.form.schema import form_schema

TABLE = '\n[report]\nproject = "Gearbox"\n'


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "case.toml").write_text(starting_case() + TABLE, encoding="utf-8")
    (tmp_path / "bearing.toml").write_text(starting_bearing() + TABLE, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(("name", "read"), [("case.toml", nh.read_case), ("bearing.toml", nh.read_bearing)])
def test_a_title_block_is_read_and_written(folder, name, read):
    case = read(folder / name)
    assert case.title_block.lines == {"project": "Gearbox"}
    (folder / "new").mkdir()
    case.write(folder / "new" / "copy.toml")
    assert read(folder / "new" / "copy.toml").title_block == case.title_block
    assert replace(case, title_block=TitleBlock(author="A")).document["report"] == {"author": "A"}


def test_all_mistakes_of_a_title_block_are_named(folder):
    wrong = '\n[report]\nproject = 7\nauthor = "two\\nlines"\ndate = 2026-11-23\nauthors = "A"\n'
    (folder / "case.toml").write_text(starting_case() + wrong, encoding="utf-8")
    with pytest.raises(CaseError) as caught:
        nh.read_case(folder / "case.toml")
    assert set(caught.value.places) == {f"report.{name}" for name in ("project", "author", "date", "authors")}


def test_what_is_given_stands_over_another():
    found = TitleBlock(author="B", date=" ").over(TitleBlock(project="Gearbox", author="A", date="today"))
    assert found.lines == {"project": "Gearbox", "author": "B", "date": "today"}


def test_the_page_has_the_fields():
    assert list(form_schema("case")["$defs"]["TitleBlock"]["properties"]) == ["project", "author", "date"]
