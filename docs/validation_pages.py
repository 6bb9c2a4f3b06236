"""Set the numbers of the claims into the pages of docs/validation, and draw their figures.

    PYTHONPATH=tests python docs/validation_pages.py

A page keeps its text; what is between a comment that names claims by their ids, with wildcards and commas, and the
comment that ends it is written anew:

    <!-- off ID -->0.01 %<!-- . -->   the largest difference, relative in per cent
    <!-- found ID -->0.27 mm<!-- . --> the number found
    <!-- overview -->                 how many claims each section has, and how many hold
    <!-- table ID -->                 the claims by source, with the largest difference for each tolerance
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fnmatch import fnmatch
from pathlib import Path

from matplotlib.figure import Figure
from validation_figures import FIGURES

import claims
from claims.claim import Check, Section
from claims.page import overview, row, table
from nonhertz.errors import without_accuracy_warnings
from nonhertz.plot import save
from nonhertz.plot.sheets import WIDTH
from nonhertz.plot.style import sheet_style

FOLDER = Path(__file__).parent / "validation"
PLACE = re.compile(r"(<!-- (?P<what>off|found|table|overview) ?(?P<of>\S*) -->).*?(<!-- \. -->)", re.DOTALL)
HEAD = ("claims", "compared with", "largest difference (tolerance)")


def filled(page: str, sections: Sequence[Section]) -> str:
    """Return a page with the numbers of its claims."""
    checks = [check for section in sections for check in section.checks]
    if begins := re.search(r"^<!-- (off|found) .*", page, re.MULTILINE):
        raise ValueError(f"Markdown takes a line that begins with a comment for HTML: {begins[0]}")

    def number(place: re.Match[str]) -> str:
        of = place["of"].split(",")
        chosen = [check for check in checks if any(fnmatch(check.claim.id, each) for each in of)]
        if place["what"] == "overview":
            words = f"\n\n{overview(sections)}\n"
        elif not chosen:
            raise ValueError(f"no claim has the id {place['of']}")
        elif place["what"] == "table":
            words = f"\n\n{by_source(chosen)}\n"
        elif place["what"] == "found":
            words = f"{chosen[0].computed:.3g} {chosen[0].claim.unit}".strip()
        else:
            words = off(chosen)
        return f"{place[1]}{words}{place[4]}"

    return PLACE.sub(number, page)


def off(checks: Sequence[Check]) -> str:
    """Return the largest difference of some claims."""
    largest = max(checks, key=lambda check: abs(check.difference))
    with_unit = largest.claim.absolute and largest.claim.unit
    value, unit = (1.0, largest.claim.unit) if with_unit else (100.0, "%")
    return f"{value * abs(largest.difference):.2g} {unit}".replace("e-0", "e-")


def by_source(checks: Sequence[Check]) -> str:
    """Return a table of claims by source, with the largest difference for each tolerance."""
    sources: dict[str, dict[str, list[Check]]] = {}
    for check in checks:
        _, source, *_, tolerance, _ = row(check)
        kind = f"{tolerance} {check.claim.unit}".strip() if check.claim.absolute and tolerance else tolerance
        sources.setdefault(source, {}).setdefault(kind or "shown", []).append(check)
    rows = [
        (
            str(sum(map(len, groups.values()))),
            source,
            ", ".join(f"{largest_difference(group)} ({tolerance})" for tolerance, group in groups.items()),
        )
        for source, groups in sources.items()
    ]
    return table(HEAD, rows, numbers=HEAD[:1])


def largest_difference(checks: Sequence[Check]) -> str:
    """Return the largest difference of some claims as a power of ten."""
    return row(max(checks, key=lambda check: abs(check.difference)))[4].split()[0]


def main() -> None:
    """Write all pages and figures."""
    sections = list(claims.sections(announce=print))
    for path in sorted(FOLDER.glob("*.md")):
        path.write_text(filled(path.read_text(encoding="utf-8"), sections), encoding="utf-8")
        print(f"wrote {path.name}")
    with sheet_style(), without_accuracy_warnings():
        for name, (draw, height) in FIGURES.items():
            figure = Figure(figsize=(WIDTH, height), layout="constrained")
            draw(figure)
            _, pixels = save(figure, FOLDER / name)
            # The drawing is enough for the documents.
            pixels.unlink()
            print(f"wrote {name}.svg")


if __name__ == "__main__":
    main()
