"""From the results of bearings to the text of an HTML file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePosixPath
from typing import Any

from nonhertz.files.bearing_results import as_json, as_object, comparison_files, rollers_table
from nonhertz.files.title_block import TitleBlock
from nonhertz.report.bearing.assumptions import bearing_assumptions
from nonhertz.report.bearing.basis import bearing_basis
from nonhertz.report.bearing.differences import bearing_differences
from nonhertz.report.bearing.figures import bearing_pictures, compared_picture
from nonhertz.report.bearing.inputs import bearing_inputs
from nonhertz.report.bearing.method import bearing_paragraphs, bearing_references
from nonhertz.report.bearing.overview import PART_COLUMNS, bearing_geometry, bearing_keys, bearing_opening, part_rows
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.differences import differing_inputs
from nonhertz.report.downloads import Download, given_files, left_out, text_download
from nonhertz.report.figures import Gallery
from nonhertz.report.layout import Words, laid_out, marked, measured, merged
from nonhertz.report.measurements import measurements
from nonhertz.show.bearing import (
    OF_LARGEST,
    compared_rows,
    compared_table,
    life_rows,
    roller_table,
    spectrum_rows,
    summary_rows,
)
from nonhertz.verdict import of_bearing

WORDS = Words(
    kind="Whole bearing, rollers and rings in equilibrium",
    what="bearings",
    conventions="x is the bearing's axis, y points to the first "
    "roller; forces and motions are those of the inner ring. Along a roller, y is its own axis, from its middle; "
    "positive relief is material removed; positive clearance is room.",
)


def rendered_bearings(found: Sequence[BearingResults], block: TitleBlock | None = None) -> str:
    """Return the text of the report on these bearings; what ``block`` leaves empty in its head is that of the first."""
    head = (block or TitleBlock()).over(found[0].case.title_block)
    gallery = Gallery()
    several = len(found) > 1
    comparison = _comparison(found, gallery) if several else None
    parts = [_part(each, number, several, gallery) for number, each in enumerate(found, start=1)]
    title = f"{len(found)} bearings compared" if several else found[0].case.title
    return laid_out(title, WORDS, head, comparison, parts)


def _part(found: BearingResults, number: int, several: bool, gallery: Gallery) -> dict[str, Any]:
    """Return what the template shows of one bearing."""
    case = found.case
    return {
        "template": "bearing.html",
        "anchor": f"case-{number}",
        "title": case.title,
        "label": found.label if several else "",
        "file": case.file_name,
        "opening": bearing_opening(case),
        "complaint": found.complaint,
        "warnings": found.warnings,
        "verdict": None if found.solution is None else of_bearing(found.solution, found.life),
        "keys": bearing_keys(found),
        # Figures are numbered as they are drawn, so they must be drawn in the order of the page.
        "figures": {name: marked(picture) for name, picture in bearing_pictures(found, gallery).items()},
        "part_columns": PART_COLUMNS,
        "parts": part_rows(case),
        "inputs": bearing_inputs(case),
        "geometry": bearing_geometry(case),
        "assumptions": bearing_assumptions(found),
        **_results(found),
        "slices": _slices(found),
        "measured": [measured(each, gallery.of_measurement(each)) for each in measurements(case)],
        "method": bearing_paragraphs(found),
        "references": bearing_references(found),
        "downloads": _downloads(found),
        "left_out": left_out(case),
        "text": case.text,
    }


def _results(found: BearingResults) -> dict[str, Any]:
    if found.solution is None:
        return {"summary": [], "life": [], "rollers": None}
    rated = found.life is not None or found.reason
    lives = [*spectrum_rows(found.case), *life_rows(found.life, found.reason, found.speed)] if rated else []
    return {
        "summary": merged(summary_rows(found.case, found.solution)),
        "life": merged(lives),
        "rollers": _table(*roller_table(found.solution)),
    }


def _slices(found: BearingResults) -> dict[str, Any] | None:
    if found.slices is None or found.solution is None:
        return None
    both = found.solution, found.slices
    return {
        "whole": _table(("", "strips", "slices", "difference"), compared_rows(*both)),
        "rollers": _table(*compared_table(*both)),
        "sentence": OF_LARGEST,
    }


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> dict[str, Any]:
    """Return a table without the columns that are blank throughout, with units as they are printed."""
    kept = [column for column in range(len(columns)) if any(row[column] for row in rows)]
    return {
        "columns": [columns[column] for column in kept],
        "rows": [[row[column] for column in kept] for row in rows],
    }


def _downloads(found: BearingResults) -> list[Download]:
    """Return the bearing file, the files that it names, and all results."""
    case, solution = found.case, found.solution
    files = given_files(case, "bearing file")
    if solution is None:
        return files
    stem = PurePosixPath(case.file_name).stem
    text = as_json(as_object(solution, case, found.life, found.reason, found.strained)) + "\n"
    files.append(text_download(f"{stem}-rollers.csv", "all rollers", rollers_table(solution)))
    files.append(text_download(f"{stem}-result.json", "all numbers of the bearing", text))
    if found.slices is not None:
        for name, text in comparison_files(solution, found.slices, case.title).items():
            files.append(text_download(f"{stem}-{name}", "strips beside slices", text))
    return files


def _comparison(found: Sequence[BearingResults], gallery: Gallery) -> dict[str, Any]:
    picture = compared_picture(found, gallery)
    return {
        "template": "bearings.html",
        "heads": [{"label": each.label, "title": each.case.title, "complaint": each.complaint} for each in found],
        "inputs": differing_inputs([bearing_inputs(each.case) for each in found]),
        "basis": bearing_basis(found),
        "results": bearing_differences(found),
        "figures": [] if picture is None else [marked(picture)],
    }
