"""From the results of cases to the text of an HTML file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nonhertz.amounts import read_in
from nonhertz.errors import InputError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.title_block import TitleBlock
from nonhertz.report.assumptions import assumptions
from nonhertz.report.basis import basis
from nonhertz.report.bearing.page import rendered_bearings
from nonhertz.report.bearing.results import settled_bearings
from nonhertz.report.differences import differing_inputs, lives, remarks_on_lives, results
from nonhertz.report.downloads import downloads, left_out
from nonhertz.report.figures import Gallery
from nonhertz.report.inputs import inputs
from nonhertz.report.layout import Words, laid_out, marked, measured, merged
from nonhertz.report.measurements import measurements
from nonhertz.report.method import paragraphs, references
from nonhertz.report.overview import ends_in_words, geometry, keys, opening
from nonhertz.report.results import CaseResults, examined, settled
from nonhertz.show.analysis import Announce, in_silence
from nonhertz.show.lives import LIFE_COLUMNS, RATIO, life_rows, spectrum_table
from nonhertz.show.lives import sentences as life_sentences
from nonhertz.show.stresses import sentences as stress_sentences
from nonhertz.show.stresses import stress_table
from nonhertz.show.summary import summary_rows
from nonhertz.verdict import of_contact

WORDS = Words(
    kind="Elastic contact, solved with strip elements",
    what="cases",
    conventions="The axis y runs along the contact from the middle of the "
    "bodies, x across it, z down into a body; positive relief is material removed; a positive tilt loads the side of "
    "positive y.",
)


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
    """Return a report on one case, or on several with a comparison first, as the text of an HTML file.

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
            found = settled_bearings(bearings, life=life, compare=compare, announce=announce)
            return rendered_bearings(found, title_block)
        return rendered(examined(settled(contacts), life=life, stress=stress, announce=announce), title_block)


def rendered(found: Sequence[CaseResults], block: TitleBlock | None = None) -> str:
    """Return the text of the report on these cases; what ``block`` leaves empty in its head is that of the first."""
    head = (block or TitleBlock()).over(found[0].case.title_block)
    gallery = Gallery()
    several = len(found) > 1
    comparison = _comparison(found, gallery) if several else None
    parts = [_part(each, number, several, gallery) for number, each in enumerate(found, start=1)]
    title = f"{len(found)} cases compared" if several else found[0].case.title
    return laid_out(title, WORDS, head, comparison, parts)


def _part(found: CaseResults, number: int, several: bool, gallery: Gallery) -> dict[str, Any]:
    """Return what the template shows of one case."""
    solution = found.solution
    return {
        "template": "case.html",
        "anchor": f"case-{number}",
        "title": found.case.title,
        "label": found.label if several else "",
        "file": found.case.file_name,
        "opening": opening(found),
        "complaint": found.complaint,
        "warnings": found.warnings,
        "verdict": None if found.complaint else of_contact(solution, found.strengths),
        "keys": keys(found),
        "figures": {name: marked(picture) for name, picture in gallery.of_solution(found).items()},
        "inputs": inputs(found.case),
        "geometry": geometry(solution),
        "assumptions": assumptions(found),
        "summary": merged(summary_rows(solution)),
        "ends": ends_in_words(solution),
        "stress": _stress(found, gallery),
        "life": _life(found, gallery),
        # Figures are numbered as they are drawn, so they must be drawn in the order of the page.
        "measured": [measured(each, gallery.of_measurement(each)) for each in measurements(found.case)],
        "method": paragraphs(found),
        "references": references(found),
        "downloads": downloads(found),
        "left_out": left_out(found.case),
        "text": found.case.text,
    }


def _comparison(found: Sequence[CaseResults], gallery: Gallery) -> dict[str, Any]:
    shown = lives(found)
    return {
        "template": "comparison.html",
        "heads": [{"label": each.label, "title": each.case.title, "complaint": each.complaint} for each in found],
        "inputs": differing_inputs([inputs(each.case) for each in found]),
        "basis": basis(found),
        "results": results(found),
        "lives": shown,
        "life_sentences": [RATIO, *remarks_on_lives(found)] if shown else [],
        "figures": [marked(picture) for picture in gallery.of_all(found)],
    }


def _stress(found: CaseResults, gallery: Gallery) -> dict[str, Any] | None:
    if found.stress is None:
        return None
    heads, rows = stress_table(found.solution, *found.stress)
    return {
        "columns": heads,
        "rows": [[cell.replace("+-", "±") for cell in row] for row in rows],
        "sentences": stress_sentences(found.solution, found.stress[1]),
        "strength": [sentence for each in found.strengths for sentence in each.sentences],
        "figures": [marked(picture) for picture in gallery.of_stress(found).values()],
    }


def _life(found: CaseResults, gallery: Gallery) -> dict[str, Any] | None:
    if found.lives is None:
        return None
    rows = life_rows(found.lives)
    # Drop columns that are blank throughout, as revolutions are without a raceway.
    kept = [column for column in range(len(LIFE_COLUMNS)) if any(row[column] for row in rows)]
    heads, loads = spectrum_table(found.lives)
    pictures = [gallery.of_lives(found), gallery.of_dent(found)]
    return {
        "columns": [LIFE_COLUMNS[column] for column in kept],
        "rows": [[row[column] for column in kept] for row in rows],
        "sentences": life_sentences(found.lives),
        "spectrum_columns": heads,
        "spectrum": loads if len(found.lives.spectrum) > 1 else [],
        "figures": [marked(picture) for picture in pictures if picture],
    }
