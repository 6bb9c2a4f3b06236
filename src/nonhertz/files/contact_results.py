"""A solved contact as text and as files: one JSON object, one table, and whatever figures the caller draws."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, quantity_keys, within
from nonhertz.model.body import BODIES
from nonhertz.result.edges import EdgeKind
from nonhertz.result.quantities import ALONG, QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.result.status import Status
from nonhertz.result.tables import csv_text, heading
from nonhertz.strip.element import ELEMENTS
from nonhertz.verdict import judge_contact

if TYPE_CHECKING:
    from nonhertz.files.casefile import Case


_END: Final = (
    Key("y", "where it is", "mm", holds="number"),
    Key("kind", "kind of end", get="kind.label", holds=[kind.label for kind in EdgeKind]),
)
_EDGE: Final = (
    *_END,
    Key("pressure", "pressure of the last strip", "MPa", holds="number"),
    Key("strip_width", "width of the last strip", "mm", holds="number"),
    Key("image_weight", "kappa, summed over the bodies that end here", holds="number"),
    Key("exponent", "alpha of p = K s^-alpha (1 + c s^beta) at a distance s; 0 if not singular", holds="number"),
    Key("strength", "K, up to half a half-width from the end; null where unknown or not singular", "MPa mm^exponent"),
    Key("correction", "c; null where unknown or not singular", "mm^-correction_exponent"),
    Key("correction_exponent", "beta; 0 if not singular", holds="number"),
    Key("convention", "bodies that end here, and the treatment of their side faces", holds="string"),
    Key("converges", "whether the pressure converges with more strips", holds="boolean"),
)
_ERRORS: Final = (
    Key("approach", "of the penetration"),
    Key("load", "of the load"),
    Key("max_pressure", "of the maximum pressure; null at a corner of the profile, where it is unbounded"),
    Key("moment", "of load times half the length of the strips"),
    Key("tilt", "of the penetration, at half the length of the strips"),
)
#: Keys of the file of a solved contact.
CONTACT: Final = (
    results.FORMAT_KEY,
    Key("title", "title of the case", get="case.title", holds="string"),
    *within(
        "solution",
        Key("status", "how the solve ended", get="status.label", holds=[status.label for status in Status]),
        Key("element", "the strip element", get="element.name", holds=[*ELEMENTS]),
        results.models_key("contact", {name: f"body {name}" for name in BODIES}),
        *quantity_keys(quantity for quantity in QUANTITIES.values() if not quantity.within),
        Key("contact_y", "the intervals in contact", "mm", holds=ListOf(ListOf("number", 2))),
        Key("edge_pressure", "at the low and at the high end", holds=ListOf(_EDGE, 2)),
        Key("singular_ends", "ends towards which the pressure is unbounded", holds=ListOf(_END)),
        Key(
            "stiffness", "d(load, moment) / d(approach, tilt)", [["N/mm", "N/rad"], ["N mm/mm", "N mm/rad"]],
            holds=ListOf(ListOf(count=2), 2),
        ),
        Key("peaks_at_corner", "whether the maximum pressure is at a corner", holds="boolean"),
        Key("iterations", "Newton steps", holds="integer"),
        Key("strips", "number of strips", holds="integer"),
        Key("error_estimate", "estimated discretisation errors, relative", holds=_ERRORS),
    ),
    results.verdict_key(lambda solved: judge_contact(solved.solution)),
    results.assumed_key("case.assumed"),
    *results.warning_keys(lambda solved: solved.solution.findings),
    results.findings_key(
        "remarks", "remarks that strain no model; left out if there are none", "solution.remarks",
        applies=lambda solved: bool(solved.solution.remarks),
    ),
    results.UNITS,
    *within(
        "solution",
        *quantity_keys(ALONG.values(), ListOf()),
        Key("edges", "edges of the strips", "mm", holds=ListOf("number")),
        Key("element_half_width", "half-width of the element's own pressure", "mm", holds=ListOf("number")),
    ),
    Key("case", "the case as in a file, with all defaults and profile points", get="case.own_document", holds="object"),
)  # fmt: skip


def as_object(solution: Solution, case: Case) -> dict[str, Any]:
    """Return a solution as results.plain numbers, text, lists and dictionaries, with the case it belongs to.

    `nonhertz.files.resultfile.read_result` reads it back. Numbers are unrounded.
    """
    return results.document(CONTACT, case=case, solution=solution)


def as_table(solution: Solution) -> str:
    """Return the strips as CSV with a header of names and units."""
    columns = (column.tolist() for column in solution.table().values())
    return csv_text((heading(name, quantity.unit) for name, quantity in ALONG.items()), zip(*columns, strict=True))


def files(solution: Solution, case: Case) -> dict[str, str]:
    """Return the texts of result.json and table.csv, by file name."""
    return {"result.json": results.key_by_key(as_object(solution, case)) + "\n", "table.csv": as_table(solution)}
