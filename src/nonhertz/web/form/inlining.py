"""Replacing the files that a case names by their points, since the page reads no files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nonhertz.files.held import OF_BEARINGS
from nonhertz.files.mistakes import path_of
from nonhertz.files.profiles import Changes, profile_tables, read_profile
from nonhertz.model.profile import Tabulated
from nonhertz.web.limits import POINTS


def inlined(document: dict[str, Any], folder: Path) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return a valid case or bearing with the content of the files that it names in their place, and notes about it.

    Parameters
    ----------
    document : dict
        A document without mistakes.
    folder : Path
        Directory that file names are relative to.

    Returns
    -------
    document : dict
        The same, with the profile of each body that names a file as a list.
    notes : tuple of str
        A sentence for each file with points.
    """
    notes: list[str] = []
    if "body" in document:
        bodies = {name: _of_body(body, folder, ("body", name), notes) for name, body in document["body"].items()}
        return document | {"body": bodies}, tuple(notes)
    bodies = {name: _of_body(document[name], folder, (name,), notes) for name in OF_BEARINGS[1:] if name in document}
    return document | bodies, tuple(notes)


def _of_body(body: dict[str, Any], folder: Path, place: tuple[str, ...], notes: list[str]) -> dict[str, Any]:
    tables = profile_tables(body)
    if not any("file" in table for table in tables):
        return body
    made = [
        _points(table, folder, path_of((*place, "profile", number)), notes) if "file" in table else table
        for number, table in enumerate(tables, start=1)
    ]
    return body | {"profile": made}


def _points(table: dict[str, Any], folder: Path, path: str, notes: list[str]) -> dict[str, Any]:
    moved = {name: table[name] for name in Changes.descriptions if name in table}
    profile = read_profile({name: value for name, value in table.items() if name not in moved}, {}, folder)
    assert isinstance(profile, Tabulated)
    every = -(-len(profile.y) // POINTS)
    kept = sorted({*range(0, len(profile.y), every), len(profile.y) - 1})
    thinned = f", of which every {_ordinal(every)} is kept" if every > 1 else ""
    notes.append(f"{path}: the page holds the {len(profile.y)} points of {table['file']} itself{thinned}.")
    return {
        "kind": "tabulated",
        "y": [profile.y[point] for point in kept],
        "relief": [profile.values[point] for point in kept],
        "interpolation": profile.interpolation,
    } | moved


def _ordinal(number: int) -> str:
    return f"{number}{ {2: 'nd', 3: 'rd'}.get(number, 'th') }"
