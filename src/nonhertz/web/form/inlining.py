"""Replaces the files that a case names by their points, since the page reads no files."""

from __future__ import annotations

from typing import Any

from nonhertz.files.document import Document
from nonhertz.files.paths import Parameter, body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.web.limits import POINTS


def inline_files(case: Document) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return the document of a case or a bearing with points in place of files of profiles, and a note on each file.

    The points are those that `Document.write` writes. In bodies that name files, profiles become lists.
    """
    document, notes, made = case.document, [], dict(body_tables(case.own_document))
    for place, body in body_tables(case.document):
        tables, written = profile_tables(body), iter(made[place].get("profile", ()))
        # A straight profile is not written.
        drawn = [table if table["kind"] == "straight" else next(written) for table in tables]
        for number, table in enumerate(tables):
            if "file" in table:
                tables[number], words = _thin(drawn[number])
                what = f"the {len(drawn[number]['y'])} points of {table['file']}"
                notes.append(f"{place}.profile[{number + 1}]: the page contains {what}{words}.")
        if tables != profile_tables(body):
            document = Parameter("", (*place.split("."), "profile"), None).put(document, tables)
    return document, tuple(notes)


def _thin(table: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """Return a table with no more points than the page accepts, and which are kept in words; "" if all are."""
    count = len(table["y"])
    step = -(-count // POINTS)
    if step <= 1:
        return table, ""
    chosen = sorted({*range(0, count, step), count - 1})
    points = {name: [table[name][point] for point in chosen] for name in ("y", "relief")}
    return table | points, f", of which every {step}{ {2: 'nd', 3: 'rd'}.get(step, 'th') } is kept"
