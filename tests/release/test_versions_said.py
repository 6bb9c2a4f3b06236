"""The version is the same wherever it stands, and what the documents say of files is what happens."""

import re
import tomllib
from pathlib import Path

import pytest
from scripts import script

import nonhertz as nh
from nonhertz.files.bounds import FORMAT
from nonhertz.files.casefile import read_case
from nonhertz.files.starting import starting_case

ROOT = Path(__file__).resolve().parents[2]
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
PAGE = (ROOT / "docs/explain/versions.md").read_text(encoding="utf-8")


def test_the_package_has_the_version_of_the_project():
    assert nh.__version__ == VERSION


def test_a_tag_needs_the_version_and_a_date_in_the_changelog():
    tag = script(Path(__file__).with_name("tag.py"))
    said = tag.mistakes("v0.0.0")
    assert said[0] == f"The tag is v0.0.0, but pyproject.toml has version {VERSION}."
    heading = re.search(rf"^## {re.escape(VERSION)}, (.*)$", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE)
    assert heading is not None
    assert len(tag.mistakes(f"v{VERSION}")) == (heading[1] == "unreleased")


def test_a_newer_format_is_refused_as_documented(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(f"format = {FORMAT + 1}\n{starting_case()}", encoding="utf-8")
    with pytest.raises(nh.CaseError) as caught:
        read_case(path)
    (mistake,) = caught.value.mistakes
    assert f"    {mistake.removeprefix(f'{path}: ')}\n" in PAGE


def test_a_file_without_the_key_is_of_the_first_format(tmp_path):
    path, other = tmp_path / "case.toml", tmp_path / "other.toml"
    path.write_text(starting_case(), encoding="utf-8")
    other.write_text(f"format = 1\n{starting_case()}", encoding="utf-8")
    assert read_case(path) == read_case(other)
