"""What others wrote and the package ships: listed in NOTICE.md, with the text of its licence."""

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
VENDOR = ROOT / "src/nonhertz/web/static/vendor"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in (ROOT / "NOTICE.md").read_text(encoding="utf-8").splitlines()
    if line.startswith("| `")
]
# Words that stand in one licence and in none of the others.
WORDS = {
    "Apache-2.0": "Licensed under the Apache License, Version 2.0",
    "BSD-3-Clause": "Neither the name of the author nor the names of contributors",
    "ISC": "Permission to use, copy, modify, and/or distribute this software for any",
    "MIT": "Permission is hereby granted, free of charge, to any person obtaining a copy",
    "Unlicense": "This is free and unencumbered software released into the public domain.",
}


def texts_of(row: list[str]) -> list[str]:
    return [re.sub(r"\s+", " ", (VENDOR / name).read_text(encoding="utf-8")) for name in re.findall(r"`(.+?)`", row[4])]


def test_every_file_of_others_is_listed():
    listed = {name for row in ROWS for cell in (row[0], row[4]) for name in re.findall(r"`(.+?)`", cell)}
    assert listed == {path.name for path in VENDOR.iterdir()} - {"README.md"}


def test_nothing_of_others_lies_elsewhere():
    """A head that names somebody's copyright is the mark of a file that was taken over."""
    package = ROOT / "src/nonhertz"
    heads = {path: path.read_bytes()[:2000] for path in package.rglob("*") if path.is_file() and path.suffix != ".pyc"}
    theirs = {path for path, head in heads.items() if re.search(rb"\bcopyright\b", head, re.IGNORECASE)}
    assert theirs
    assert {path.parent for path in theirs} == {VENDOR}


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[1])
def test_each_has_the_text_of_its_licence(row):
    licences = {name for name, words in WORDS.items() if any(words in text for text in texts_of(row))}
    assert licences == set(row[3].split(", "))


@pytest.mark.parametrize("name", ["d3.min.js", "plot.umd.min.js"])
def test_the_head_of_a_bundle_agrees_with_what_is_listed(name):
    head = (VENDOR / name).read_text(encoding="utf-8").partition("\n")[0]
    (row,) = [row for row in ROWS if row[0] == f"`{name}`" and row[2]]
    assert f"v{row[2]} " in head
    assert head[head.index("Copyright") :] in texts_of(row)[0]


def test_the_metadata_names_all_licences():
    listed = {licence for row in ROWS for licence in row[3].split(", ")}
    assert set(PROJECT["license"].split(" AND ")) == {"MIT"} | listed


def test_all_texts_are_licence_files_of_the_distributions():
    found = {path for pattern in PROJECT["license-files"] for path in ROOT.glob(pattern)}
    assert found == {ROOT / "LICENSE", ROOT / "NOTICE.md", *VENDOR.glob("*.LICENSE")}
