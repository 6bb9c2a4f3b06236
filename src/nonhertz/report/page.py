"""From the results of cases to the text of an HTML file."""

from __future__ import annotations

import functools
import platform
import re
from collections.abc import Sequence
from importlib import metadata, resources
from typing import TYPE_CHECKING, Any

from nonhertz import __version__
from nonhertz.io.casefile import Case
from nonhertz.report.assumptions import assumptions
from nonhertz.report.differences import differing_inputs, lives, remarks_on_lives, results
from nonhertz.report.downloads import downloads
from nonhertz.report.figures import Gallery
from nonhertz.report.inputs import inputs
from nonhertz.report.measurements import Measurement, measurements
from nonhertz.report.method import paragraphs, references
from nonhertz.report.overview import ends_in_words, geometry, keys, opening
from nonhertz.report.results import CaseResults, examined, settled
from nonhertz.show.analysis import Announce, in_silence
from nonhertz.show.lives import LIFE_COLUMNS, RATIO, SPECTRUM_COLUMNS, life_rows, spectrum_rows
from nonhertz.show.lives import sentences as life_sentences
from nonhertz.show.stresses import COLUMNS, stress_rows
from nonhertz.show.stresses import sentences as stress_sentences
from nonhertz.show.summary import summary_rows

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

#: Identifies a report; it is near the beginning of the file.
MARK = '<meta name="generator" content="nonhertz report">'

_PACKAGES = ("numpy", "scipy", "numba", "matplotlib")
_ADDRESS = re.compile(r"doi:(10\.\S+?)(?=[.,;:]?(?:\s|$))|(https?://\S+?)(?=[.,;:]?(?:\s|$))")


def compose(
    cases: Sequence[Case],
    *,
    life: bool | None = None,
    stress: bool = True,
    announce: Announce = in_silence,
) -> str:
    """Return a report on one case, or on several with a comparison first, as the text of an HTML file.

    Parameters
    ----------
    cases : sequence of Case
        At least one; others are compared with the first.
    life : bool or None
        Whether to assess lives, which takes seconds; None for only those cases that mention life.
    stress : bool
        Whether to search for the largest stresses below the surface.
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
    """
    return rendered(examined(settled(cases), life=life, stress=stress, announce=announce))


def rendered(found: Sequence[CaseResults]) -> str:
    """Return the text of the report on these cases."""
    gallery = Gallery()
    several = len(found) > 1
    comparison = _comparison(found, gallery) if several else None
    parts = [_part(each, number, several, gallery) for number, each in enumerate(found, start=1)]
    title = f"{len(found)} cases compared" if several else found[0].case.title
    page = (
        _environment()
        .get_template("report.html")
        .render(
            title=title,
            mark=_safe(MARK),
            style=_safe(_resource("style.css")),
            comparison=comparison,
            parts=parts,
            versions=_versions(),
        )
    )
    return page.strip() + "\n"


def _part(found: CaseResults, number: int, several: bool, gallery: Gallery) -> dict[str, Any]:
    """Return what the template shows of one case."""
    solution = found.solution
    return {
        "anchor": f"case-{number}",
        "title": found.case.title,
        "label": found.label if several else "",
        "file": found.case.file_name,
        "opening": opening(found),
        "complaint": found.complaint,
        "warnings": found.warnings,
        "keys": keys(found),
        "figures": {name: _marked(picture) for name, picture in gallery.of_solution(found).items()},
        "inputs": inputs(found.case),
        "geometry": geometry(solution),
        "assumptions": assumptions(found),
        "summary": _merged(summary_rows(solution)),
        "ends": ends_in_words(solution),
        "stress": _stress(found, gallery),
        "life": _life(found, gallery),
        # Figures are numbered as they are drawn, so they must be drawn in the order of the page.
        "measured": [_measured(each, gallery) for each in measurements(found.case)],
        "method": paragraphs(found),
        "references": references(found),
        "downloads": downloads(found),
        "left_out": _left_out(found.case),
        "text": found.case.text,
    }


def _left_out(case: Case) -> list[str]:
    """Return the files that a case names but the page does not include."""
    return [] if case.origin is None else [name for name in case.origin.files if name not in case.attachments]


def _measured(measurement: Measurement, gallery: Gallery) -> dict[str, Any]:
    return {
        "place": measurement.place,
        "file": measurement.file,
        "rows": [(name, words.replace(" um", " µm")) for name, words in measurement.rows],
        "figure": _marked(gallery.of_measurement(measurement)),
    }


def _comparison(found: Sequence[CaseResults], gallery: Gallery) -> dict[str, Any]:
    shown = lives(found)
    return {
        "heads": [{"label": each.label, "title": each.case.title, "complaint": each.complaint} for each in found],
        "inputs": differing_inputs([each.case for each in found]),
        "results": results(found),
        "lives": shown,
        "life_sentences": [RATIO, *remarks_on_lives(found)] if shown else [],
        "figures": [_marked(picture) for picture in gallery.of_all(found)],
    }


def _stress(found: CaseResults, gallery: Gallery) -> dict[str, Any] | None:
    if found.stress is None:
        return None
    return {
        "columns": COLUMNS,
        "rows": [[cell.replace("+-", "±") for cell in row] for row in stress_rows(found.solution, *found.stress)],
        "sentences": stress_sentences(found.solution, found.stress[1]),
        "figures": [_marked(picture) for picture in gallery.of_stress(found).values()],
    }


def _life(found: CaseResults, gallery: Gallery) -> dict[str, Any] | None:
    if found.lives is None:
        return None
    rows = life_rows(found.lives)
    # Drop columns that are blank throughout, as revolutions are without a raceway.
    kept = [column for column in range(len(LIFE_COLUMNS)) if any(row[column] for row in rows)]
    picture = gallery.of_lives(found)
    return {
        "columns": [LIFE_COLUMNS[column] for column in kept],
        "rows": [[row[column] for column in kept] for row in rows],
        "sentences": life_sentences(found.lives),
        "spectrum_columns": SPECTRUM_COLUMNS,
        "spectrum": spectrum_rows(found.lives) if len(found.lives.spectrum) > 1 else [],
        "figures": [_marked(picture)] if picture else [],
    }


def _merged(rows: Sequence[tuple[str, str, str]]) -> list[tuple[str, list[tuple[str, str]]]]:
    """Return names with their values and remarks; a row without a name continues the one before."""
    merged: list[tuple[str, list[tuple[str, str]]]] = []
    for name, value, remark in rows:
        if name or not merged:
            merged.append((name, []))
        merged[-1][1].append((value.replace(" um", " µm"), remark))
    return merged


def _versions() -> list[tuple[str, str]]:
    packages = [(name, metadata.version(name)) for name in _PACKAGES]
    return [("nonhertz", __version__), ("Python", platform.python_version()), *packages]


def _marked(picture: Any) -> dict[str, Any]:
    return {"number": picture.number, "svg": _safe(picture.svg), "caption": picture.caption}


@functools.cache
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("nonhertz.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["linked"] = _linked
    return environment


def _linked(text: str) -> Markup:
    """Return a reference with its DOIs and URLs as links."""
    from markupsafe import Markup, escape

    shown, at = Markup(), 0
    for found in _ADDRESS.finditer(text):
        address = found[2] or f"https://doi.org/{found[1]}"
        shown += escape(text[at : found.start()])
        shown += Markup('<a href="{}" rel="noreferrer">{}</a>').format(address, found[0])
        at = found.end()
    return shown + escape(text[at:])


def _safe(text: str) -> Markup:
    """Return trusted text as HTML that is not escaped."""
    from markupsafe import Markup

    return Markup(text)


def _resource(name: str) -> str:
    return resources.files("nonhertz.report").joinpath("templates", name).read_text(encoding="utf-8")
