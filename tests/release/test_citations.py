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
DOI = re.compile(r"10\.\d{4,}/\S+")


def entries() -> dict[str, dict[str, str]]:
    """Return the fields of the entries of the bibliography by their keys."""
    found = {}
    for kind, key, body in re.findall(r"^@(\w+)\{(\w+),\n(.*?)^\}$", BIB, re.MULTILINE | re.DOTALL):
        fields = re.findall(r"^  (\w+) = \{(.*?)\},$", body, re.MULTILINE | re.DOTALL)
        found[key] = {"kind": kind} | {name: re.sub(r"\s+", " ", value) for name, value in fields}
    return found


def plain(title: str) -> str:
    return re.sub(r"[{}]", "", title).lower()


def test_the_citation_is_of_this_package():
    assert CITATION["cff-version"] == "1.2.0"
    assert {"message", "title", "authors", "type"} <= set(CITATION)
    assert CITATION["title"] == PROJECT["name"]
    assert CITATION["version"] == PROJECT["version"]
    assert CITATION["authors"] == PROJECT["authors"]
    assert CITATION["abstract"] == f"{PROJECT['description']}."
    assert CITATION["license"] == PROJECT["license"].split(" AND ")[0]


def test_the_citation_names_the_papers_of_the_methods():
    """Strips, and the plane grid that they are compared with."""
    cited = {plain(each["title"]): each for each in CITATION["references"]}
    for key in ("deMul1998", "deMul1986"):
        entry = entries()[key]
        reference = cited[plain(entry["title"])]
        assert str(reference["year"]) == entry["year"]
        names = [f"{each['family-names']}, {each['given-names']}" for each in reference["authors"]]
        assert names == entry["author"].split(" and ")
        assert reference.get("doi") == entry.get("doi")


@pytest.mark.slow
def test_the_paper_is_what_its_script_writes():
    """Numbers of the validation or of the benchmarks that change are written anew by paper/figures.py."""
    assert script(PAPER / "figures.py").text() == TEXT


def test_all_that_is_cited_is_in_the_bibliography_and_the_other_way_round():
    assert set(re.findall(r"@(\w+)", TEXT)) == set(entries())


def test_entries_are_whole_and_agree_with_the_documents():
    texts = [
        path.read_text(encoding="utf-8") for path in (*ROOT.glob("src/nonhertz/**/*.py"), *ROOT.glob("docs/**/*.md"))
    ]
    known = {doi.rstrip(").,;]") for text in texts for doi in DOI.findall(text)}
    shared = set()
    for key, entry in entries().items():
        assert {"author", "title", "year"} <= set(entry), key
        assert {"journal", "booktitle", "school", "institution"} & set(entry), key
        if "doi" in entry:
            assert DOI.fullmatch(entry["doi"]), key
            shared |= {entry["doi"]} & known
    assert {"10.1115/1.3261134", "10.1515/crll.1882.92.156", "10.1115/1.3261081"} <= shared
