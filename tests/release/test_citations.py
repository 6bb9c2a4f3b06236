"""CITATION.cff and the paper: what they say of the package, and whom they cite."""

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml
from scripts import script

ROOT = Path(__file__).resolve().parents[2]
PAPER = ROOT / "paper"
TEXT = (PAPER / "paper.md").read_text(encoding="utf-8")
BIB = (PAPER / "paper.bib").read_text(encoding="utf-8")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
CITATION: dict[str, Any] = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))


def entries() -> dict[str, dict[str, str]]:
    """Return the fields of the entries of the bibliography by their keys."""
    found = {}
    for kind, key, body in re.findall(r"^@(\w+)\{(\w+),\n(.*?)^\}$", BIB, re.MULTILINE | re.DOTALL):
        fields = re.findall(r"^  (\w+) = \{(.*?)\},$", body, re.MULTILINE | re.DOTALL)
        found[key] = {"kind": kind} | {name: re.sub(r"\s+", " ", value) for name, value in fields}
    return found


def test_the_citation_is_of_this_package():
    assert CITATION["cff-version"] == "1.2.0"
    assert {"message", "title", "authors", "type"} <= set(CITATION)
    assert CITATION["title"] == PROJECT["name"]
    assert CITATION["version"] == PROJECT["version"]
    assert CITATION["authors"] == PROJECT["authors"]
    assert CITATION["abstract"] == f"{PROJECT['description']}."
    assert CITATION["license"] == PROJECT["license"].split(" AND ")[0]


@pytest.mark.slow
def test_the_paper_is_what_its_script_writes():
    """Numbers of the validation or of the benchmarks that change are written anew by paper/figures.py."""
    assert script(PAPER / "figures.py").text() == TEXT


def test_all_that_is_cited_is_in_the_bibliography_and_the_other_way_round():
    assert set(re.findall(r"@(\w+)", TEXT)) == set(entries())
