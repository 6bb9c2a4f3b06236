"""From the results of contacts or bearings to the text of an HTML file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from nonhertz.amounts import read_in
from nonhertz.errors import InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.title_block import TitleBlock
from nonhertz.report.assumptions import assumptions
from nonhertz.report.bearing.assumptions import bearing_assumptions
from nonhertz.report.bearing.inputs import bearing_inputs
from nonhertz.report.bearing.method import bearing_paragraphs, bearing_references
from nonhertz.report.bearing.overview import PART_COLUMNS, bearing_geometry, bearing_keys, bearing_opening, part_rows
from nonhertz.report.bearing.results import BearingResults, settled_bearings
from nonhertz.report.differences import Row, basis, bearing_results, differing_inputs, lives, remarks_on_lives, results
from nonhertz.report.downloads import bearing_downloads, downloads, left_out
from nonhertz.report.figures import Gallery, ReportFigure
from nonhertz.report.inputs import inputs
from nonhertz.report.layout import Block, Section, Words, laid_out, marked, merged
from nonhertz.report.measurements import measurements
from nonhertz.report.method import paragraphs, references
from nonhertz.report.overview import ends_in_words, geometry, keys, opening
from nonhertz.report.results import CaseResults, examined, settled
from nonhertz.show.analysis import Announce, in_silence
from nonhertz.show.bearing import OF_LARGEST, compared_rows, compared_table, roller_table
from nonhertz.show.bearing import life_rows as bearing_life_rows
from nonhertz.show.bearing import spectrum_rows as bearing_spectrum_rows
from nonhertz.show.bearing import summary_rows as bearing_summary_rows
from nonhertz.show.lives import LIFE_COLUMNS, RATIO, life_rows, spectrum_table
from nonhertz.show.lives import sentences as life_sentences
from nonhertz.show.stresses import sentences as stress_sentences
from nonhertz.show.stresses import stress_table
from nonhertz.show.summary import summary_rows
from nonhertz.verdict import of_bearing, of_contact

_NOTHING = dict.fromkeys(
    ("class", "anchor", "label", "title", "opening", "complaint", "warnings", "verdict", "keys", "sections", "folded"),
    "",
)
_BEYOND = (
    "Beyond these: bodies keep their shape apart from the contact (no bending of rollers, rings or shafts), and no "
    "other contact acts on them but the equal one on the opposite side of a whole roller."
)


@dataclass(frozen=True)
class _Kind:
    """What reports of contacts and reports of bearings say in ways of their own, of the results of one."""

    words: Words
    opening: Callable[[Any], str]
    verdict: Callable[[Any], Any]
    keys: Callable[[Any], Any]
    results: Callable[[Any, Gallery], list[Section]]
    assumptions: Callable[[Any], Any]
    beyond: tuple[str, ...]
    inputs: Callable[[Any], Any]
    geometry: Callable[[Any], Any]
    method: Callable[[Any], list[str]]
    references: Callable[[Any], list[str]]
    downloads: Callable[[Any], Any]
    compared: Callable[[Any, Gallery], list[Section]]


def compose(
    cases: Sequence[Case] | Sequence[BearingCase],
    *,
    life: bool | None = None,
    stress: bool = True,
    compare: bool = False,
    title_block: TitleBlock | None = None,
    units: str = "si",
    announce: Announce = in_silence,
) -> str:
    """Return a report on one case, or a comparison of several, as the text of an HTML file.

    Parameters
    ----------
    cases : sequence of Case or sequence of BearingCase
        At least one; others are compared with the first.
    life : bool or None
        Whether to assess lives, which takes seconds; None for only those cases that mention life. Bearings are rated
        unless it is False.
    stress : bool
        Whether to search for the largest stresses below the surface; bearings have none.
    compare : bool
        Whether to solve bearings by slices as well.
    title_block : TitleBlock or None
        Project, author and date for the head of the page; what it leaves empty is that of the first case.
    units : {"si", "us"}
        Units in which numbers are shown: ``"us"`` for in, lbf and ksi. The files in the report keep theirs.
    announce : callable
        Called with the name of each step as it begins.

    Returns
    -------
    str
        The file. Cases that have not converged are reported without stress and life.

    Raises
    ------
    CaseError
        If the solver rejects a case.
    InputError
        If there are cases of both kinds.
    """
    if not (title_block is None or isinstance(title_block, TitleBlock)):
        remedy = "make one with nonhertz.report.TitleBlock"
        raise InputError("title_block", title_block, "be a TitleBlock", remedy)
    contacts = [case for case in cases if isinstance(case, Case)]
    bearings = [case for case in cases if isinstance(case, BearingCase)]
    if contacts and bearings:
        remedy = "make a report of each kind"
        raise InputError("cases", "of both kinds", "be all single contacts or all bearings", remedy)
    with read_in(units):
        if bearings:
            return rendered(settled_bearings(bearings, life=life, compare=compare, announce=announce), title_block)
        return rendered(examined(settled(contacts), life=life, stress=stress, announce=announce), title_block)


def rendered(found: Sequence[CaseResults] | Sequence[BearingResults], block: TitleBlock | None = None) -> str:
    """Return the text of the report on these results; what ``block`` leaves empty in its head is that of the first.

    Of several there is a comparison, and of each what it was given, folded.
    """
    kind = _BEARING if isinstance(found[0], BearingResults) else _CONTACT
    head, gallery = (block or TitleBlock()).over(found[0].case.title_block), Gallery()
    if len(found) == 1:
        parts = [_part(kind, found[0], gallery)]
        return laid_out(found[0].case.title, kind.words, head, kind.opening(found[0]), parts)
    parts = [
        _NOTHING | {"class": "comparison", "sections": _differing(kind, found) + kind.compared(found, gallery)},
        *(_part(kind, each, gallery, number) for number, each in enumerate(found, start=1)),
    ]
    return laid_out(f"{len(found)} {kind.words.what} compared", kind.words, head, "", parts)


def _part(kind: _Kind, found: Any, gallery: Gallery, number: int = 0) -> dict[str, Any]:
    """Return what the template shows of a result; of one of several, which have numbers, what is not compared."""
    head = {"opening": kind.opening(found)} if number else {"keys": kind.keys(found)}
    # Figures are numbered as they are drawn, so they must be drawn in the order of the page.
    sections = [] if number else kind.results(found, gallery)
    given = [
        Section(
            "Assumptions and whether they hold",
            [("assumptions", {"rows": kind.assumptions(found), "here": kind.words.here}), _note(kind.beyond)],
        ),
        Section("Inputs", [*kind.inputs(found), ("derived", {"rows": kind.geometry(found)})]),
        *_measured(found.case, gallery),
        Section("Method", [_block("paragraphs", kind.method(found))]),
        Section("References", [_block("references", kind.references(found))]),
        Section(
            "Files",
            [
                (
                    "files",
                    {
                        "case": found.case, "words": kind.words, "downloads": kind.downloads(found),
                        "left_out": left_out(found.case),
                    },
                )
            ],
        ),
    ]  # fmt: skip
    return (
        _NOTHING
        | {
            "class": "case",
            "anchor": f"case-{number}" if number else "",
            "label": found.label,
            "title": found.case.title,
            "complaint": found.complaint,
            "warnings": found.warnings,
            "verdict": None if found.complaint else kind.verdict(found),
            "sections": sections if number else sections + given,
            "folded": given if number else [],
        }
        | head
    )


def _measured(case: Case | BearingCase, gallery: Gallery) -> Iterable[Section]:
    for each in measurements(case):
        rows = merged([(name, words, "") for name, words in each.rows])
        blocks = [_block("summary", rows), _figure(gallery.of_measurement(each))]
        yield Section(f"What was done to {each.file}, {each.place}", blocks)


# One contact


def _contact_results(found: CaseResults, gallery: Gallery) -> list[Section]:
    figures = {name: _figure(picture) for name, picture in gallery.of_solution(found).items()}
    ends = ("bullets", {"title": "The pressure at both ends", "rows": ends_in_words(found.solution)})
    summary = _block("summary", merged(summary_rows(found.solution)))
    return [
        Section("", [figures["pressure"]]),
        Section("Results", [summary, ends, figures["footprint"], figures["profile"]]),
        *_stress(found, gallery),
        *_life(found, gallery),
    ]


def _stress(found: CaseResults, gallery: Gallery) -> Iterable[Section]:
    if found.stress is None:
        return
    heads, rows = stress_table(found.solution, *found.stress)
    blocks = [
        _table(heads, [[cell.replace("+-", "±") for cell in row] for row in rows]),
        _note(stress_sentences(found.solution, found.stress[1])),
        _block("bullets", [sentence for each in found.strengths for sentence in each.sentences]),
    ]
    yield Section("Stress below the surface", blocks + [_figure(each) for each in gallery.of_stress(found).values()])


def _life(found: CaseResults, gallery: Gallery) -> Iterable[Section]:
    if found.lives is None:
        return
    blocks = [_table(LIFE_COLUMNS, life_rows(found.lives), ends=True), _note(life_sentences(found.lives))]
    if len(found.lives.spectrum) > 1:
        blocks.append(_table(*spectrum_table(found.lives), names=False))
    pictures = (gallery.of_lives(found), gallery.of_dent(found))
    yield Section("Life", blocks + [_figure(each) for each in pictures if each])


def _contacts_compared(found: Sequence[CaseResults], gallery: Gallery) -> list[Section]:
    shown, labels = lives(found), [each.label for each in found]
    notes = ["The factor after × is the ratio to the life of the first case.", RATIO, *remarks_on_lives(found)]
    return [
        Section("", [_figure(gallery.of_all(found))]),
        Section("Results", [_compared("Result", labels, results(found)), _note(["Percentages are differences from the "
                "first case."])]),
        Section("Lives", [_compared("Life relative to the ideal one", labels, shown), _note(notes)] if shown else []),
    ]  # fmt: skip


# A bearing


def _bearing_results(found: BearingResults, gallery: Gallery) -> list[Section]:
    solution = found.solution
    if solution is None:
        return []
    first, *figures = map(_figure, gallery.of_bearing(found))
    rated = found.life is not None or found.reason
    lives = [*bearing_spectrum_rows(found.case), *bearing_life_rows(found.life, found.reason, found.speed)]
    sections = [
        Section("", [first]),
        Section("Results", [_block("summary", merged(bearing_summary_rows(found.case, solution))), *figures]),
        Section("Ratings and life", [_block("summary", merged(lives))] if rated else []),
        Section("All rollers", [_table(*roller_table(solution), names=False, narrow=True)]),
    ]
    if found.slices is not None:
        both = solution, found.slices
        whole = _table(("", "strips", "slices", "difference"), compared_rows(*both))
        rollers = _table(*compared_table(*both), names=False, narrow=True)
        sections.append(Section("Strips beside slices", [whole, rollers, _note([OF_LARGEST])]))
    return sections


def _bearings_compared(found: Sequence[BearingResults], gallery: Gallery) -> list[Section]:
    picture, note = gallery.of_bearings(found), _note(["Percentages are differences from the first bearing."])
    return [
        Section("", [_figure(picture)] if picture else []),
        Section("Results", [_compared("Result", [each.label for each in found], bearing_results(found)), note]),
    ]


# Parts of pages


def _differing(kind: _Kind, found: Sequence[Any]) -> list[Section]:
    """Return the inputs in which cases differ, and what that means for their numbers."""
    groups = [[group for _, content in kind.inputs(each) for group in content.get("groups", ())] for each in found]
    rows = differing_inputs(groups)
    if not rows:
        return [Section("Inputs that differ", [_block("paragraphs", [f"None: the {kind.words.what} have the same."])])]
    table = _compared("Input", [each.label for each in found], rows)
    return [Section("Inputs that differ", [table, _note(basis(rows))])]


def _block(name: str, rows: Sequence[Any]) -> Block:
    return name, {"rows": rows}


def _note(sentences: Sequence[str]) -> Block:
    return "note", {"rows": sentences}


def _figure(picture: ReportFigure) -> Block:
    return "figure", {"picture": marked(picture)}


def _compared(name: str, labels: Sequence[str], rows: Sequence[Row]) -> Block:
    return "compared", {"name": name, "labels": labels, "rows": rows}


def _table(
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    *,
    names: bool = True,
    ends: bool = False,
    narrow: bool = False,
) -> Block:
    """Return a table without the columns that are blank throughout.

    The first column is ``names``, else it is numbers like the others; the last may be words at the line's ``ends``.
    """
    kept = [column for column in range(len(heads)) if any(row[column] for row in rows)]
    left = ([0] if names else []) + ([len(kept) - 1] if ends else [])
    return "table", {
        "heads": [heads[column] for column in kept],
        "rows": [[row[column] for column in kept] for row in rows],
        "left": left,
        "narrow": narrow,
    }


_CONTACT = _Kind(
    words=Words(
        kind="Elastic contact, solved with strip elements",
        what="cases",
        here="This case",
        file="case file",
        command="solve",
        conventions="The axis y runs along the contact from the middle of the bodies, x across it, z down into a body; "
        "positive relief is material removed; a positive tilt loads the side of positive y.",
    ),
    opening=opening,
    verdict=lambda found: of_contact(found.solution, found.strengths),
    keys=keys,
    results=_contact_results,
    assumptions=assumptions,
    beyond=(_BEYOND,),
    inputs=lambda found: [("inputs", {"groups": inputs(found.case)})],
    geometry=lambda found: geometry(found.solution),
    method=paragraphs,
    references=references,
    downloads=downloads,
    compared=_contacts_compared,
)
_BEARING = _Kind(
    words=Words(
        kind="Whole bearing, rollers and rings in equilibrium",
        what="bearings",
        here="This bearing",
        file="bearing file",
        command="bearing",
        conventions="x is the bearing's axis, y points to the first roller; forces and motions are those of the inner "
        "ring. Along a roller, y is its own axis, from its middle; positive relief is material removed; positive "
        "clearance is room.",
    ),
    opening=lambda found: bearing_opening(found.case),
    verdict=lambda found: of_bearing(found.solution, found.life),
    keys=bearing_keys,
    results=_bearing_results,
    assumptions=bearing_assumptions,
    beyond=(),
    inputs=lambda found: [
        _table(PART_COLUMNS, part_rows(found.case)),
        ("inputs", {"groups": bearing_inputs(found.case)}),
    ],
    geometry=lambda found: bearing_geometry(found.case),
    method=bearing_paragraphs,
    references=bearing_references,
    downloads=bearing_downloads,
    compared=_bearings_compared,
)
