"""Replacing the files that a case names by their points, since the page reads no files."""

from __future__ import annotations

from typing import Any

from nonhertz.files.document import Document
from nonhertz.files.paths import Parameter, body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.web.limits import POINTS


def inlined(case: Document) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return the document of a case or a bearing with points in place of the files that profiles name, and notes on it.

    The points are those that `Document.write` writes. Of the bodies that name files, profiles become lists; there is a
    sentence for each file.
    """
    document, notes, made = case.document, [], dict(body_tables(case.own_document))
    for place, body in body_tables(case.document):
        tables, written = profile_tables(body), iter(made[place].get("profile", ()))
        # A straight profile is not written.
        drawn = [table if table["kind"] == "straight" else next(written) for table in tables]
        for number, table in enumerate(tables):
            if "file" in table:
                points, kept = drawn[number], ""
                count = len(points["y"])
                every = -(-count // POINTS)
                if every > 1:
                    chosen = sorted({*range(0, count, every), count - 1})
                    points = points | {name: [points[name][point] for point in chosen] for name in ("y", "relief")}
                    kept = f", of which every {every}{ {2: 'nd', 3: 'rd'}.get(every, 'th') } is kept"
                what = f"the {count} points of {table['file']}"
                notes.append(f"{place}.profile[{number + 1}]: the page holds {what} itself{kept}.")
                tables[number] = points
        if any("file" in table for table in profile_tables(body)):
            document = Parameter("", (*place.split("."), "profile"), None).put(document, tables)
    return document, tuple(notes)
