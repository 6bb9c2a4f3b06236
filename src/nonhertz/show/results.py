"""What a result file holds in rows: of a contact or a bearing, with the case that it belongs to."""

from __future__ import annotations

from collections.abc import Sequence

from nonhertz.files.casefile import Case
from nonhertz.files.resultfile import Result
from nonhertz.result.solution import Solution
from nonhertz.show import summary
from nonhertz.show.sections import Section


def sections(result: Result) -> Sequence[Section]:
    """Return the sections on a contact, or of a bearing and its life."""
    if isinstance(result.case, Case) and isinstance(result.solution, Solution):
        return summary.sections(result.solution, result.case)
    # Imported here, since a contact needs nothing of them.
    from nonhertz.bearing.solution import BearingSolution
    from nonhertz.files.bearingfile import BearingCase
    from nonhertz.show.bearing import case_sections

    assert isinstance(result.case, BearingCase)
    assert isinstance(result.solution, BearingSolution)
    return case_sections(result.case, result.solution, *(result.rated or result.case.rated(result.solution)))
