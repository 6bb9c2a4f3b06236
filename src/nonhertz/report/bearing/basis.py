"""What several bearings rest on, where that differs so much that their numbers do not compare."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nonhertz.amounts import um
from nonhertz.bearing.frames import RINGS
from nonhertz.errors import CaseError
from nonhertz.report.basis import differing, of_body
from nonhertz.report.bearing.overview import loads_in_words
from nonhertz.report.bearing.results import BearingResults


def bearing_basis(found: Sequence[BearingResults]) -> list[str]:
    """Return a sentence for each difference between bearings that keeps numbers from being compared."""
    return list(_of_bearings(found))


def _of_bearings(found: Sequence[BearingResults]) -> Iterator[str]:
    labels = [each.label for each in found]
    for sentence, words in (
        (
            "Loads of rollers, stiffness and lives not comparable, since contacts are solved differently",
            lambda each: f"by {each.solution.method}" if each.solution else "",
        ),
        ("Displacements, pressures and lives are those of different loads", lambda each: loads_in_words(each.case)),
        ("Displacements are measured from different clearances", _clearance),
    ):
        yield from differing(labels, sentence, map(words, found))
    for name in ("roller", *RINGS):
        part = "the rollers" if name == "roller" else f"the {name} ring"
        yield from of_body(labels, part, [getattr(each.case.bearing.rows[0].bearing, name) for each in found])


def _clearance(found: BearingResults) -> str:
    try:
        clearance: float | None = getattr(found.case.mounted.rows[0].bearing, "clearance", None)
    except CaseError:
        return ""
    return "" if clearance is None else f"{um(clearance):.4g}"
