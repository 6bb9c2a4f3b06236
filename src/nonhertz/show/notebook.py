"""Results as notebooks show them: the tables of terminal and report as HTML, without a style of their own.

A module of this folder says what is shown of each kind of result; it is imported when such a result is shown.
"""

from __future__ import annotations

import html
import importlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from operator import attrgetter
from typing import Any, Final

import numpy as np

from nonhertz.result.solved import Solved
from nonhertz.show.sections import Cell, Notes, Section, Table, group_blocks, shown_columns, with_columns_of_remarks

MOST_ROWS, MOST_WARNINGS = 40, 3
DRAWN_WIDTH, DRAWN_HEIGHT, ROOM = 360, 90, 1.1  # px, px, of the reported maximum pressure

#: By class of result the function that returns its sections.
LAYOUTS: Final = {
    "BearingLife": "bearing.life_sections",
    "BearingMaps": "states.map_sections",
    "BearingSolution": "bearing.solution_sections",
    "BearingSolutions": "states.sections",
    "Comparison": "comparison.sections",
    "ContactMap": "maps.sections",
    "Design": "studies.design_sections",
    "Diagram": "studies.diagram_sections",
    "Extremes": "stresses.extremes_sections",
    "Films": "films.sections",
    "ForceTable": "states.force_table_sections",
    "Friction": "friction.sections",
    "Front": "studies.front_sections",
    "Kinematics": "bearing.kinematic_sections",
    "Life": "lives.life_sections",
    "Measured": "measured.sections",
    "OperatingClearance": "clearances.sections",
    "PatchSolution": "summary.sections",
    "ProfileFit": "measured.fit_sections",
    "Rating": "bearing.rating_sections",
    "Result": "results.sections",
    "Solution": "summary.sections",
    "Solutions": "summary.many_sections",
    "Strength": "stresses.strength_sections",
    "Sweep": "studies.sweep_sections",
    "Tolerance": "studies.tolerance_sections",
    "Tolerances": "clearances.tolerance_sections",
    "VolumeLife": "bearing.volume_life_sections",
}
#: Where a result has the title of its case.
_TITLES: Final = {
    "Design": "was.title", "Diagram": "sweep.plan.title", "Measured": "trace.name", "Result": "case.title",
    "Sweep": "plan.title", "Tolerance": "sweep.plan.title",
}  # fmt: skip


def to_html(result: object) -> str:
    """Return kind and title of a result, its tables and what strains the model, as HTML.

    Long tables end with how many rows more there are. Of one contact the pressure along it is drawn.
    """
    name = next(kind.__name__ for kind in type(result).__mro__ if kind.__name__ in LAYOUTS)
    title = attrgetter(_TITLES[name])(result) if name in _TITLES else ""
    heading = f"<strong>{type(result).__name__}</strong>{f' {html.escape(title)}' if title else ''}"
    picture = _draw_pressure(result) if isinstance(result, Solved) else ""
    body = "".join((*_blocks(sections_of(result, name)), *_warnings(getattr(result, "warnings", ()))))
    return f'<div class="nonhertz-result"><div>{heading}</div>{picture}{body}</div>'


def sections_of(result: object, name: str) -> Sequence[Section]:
    """Return the sections on a result of a class of `LAYOUTS`."""
    module, _, function = LAYOUTS[name].partition(".")
    layout: Callable[[Any], Sequence[Section]] = getattr(importlib.import_module(f"nonhertz.show.{module}"), function)
    return layout(result)


def _blocks(sections: Sequence[Section]) -> Iterator[str]:
    room, more = MOST_ROWS, 0
    for block in (block for group in group_blocks(sections) for block in group):
        if isinstance(block, Notes):
            yield from (_paragraph(str(sentence)) for sentence in block.sentences)
            continue
        if room:
            yield _table(with_columns_of_remarks(replace(block, rows=block.rows[:room])))
        more += max(0, len(block) - room)
        room = max(0, room - len(block))
    if more:
        yield _paragraph(f"and {more} more rows")


def _warnings(warnings: object) -> Iterator[str]:
    sentences = warnings if isinstance(warnings, tuple) else ()  # many solutions have theirs by case
    yield from (_paragraph(f"warning: {sentence}") for sentence in sentences[:MOST_WARNINGS])
    if len(sentences) > MOST_WARNINGS:
        yield _paragraph(f"and {len(sentences) - MOST_WARNINGS} more warnings")


def _paragraph(text: str) -> str:
    return f"<p>{html.escape(text)}</p>"


def _table(table: Table) -> str:
    columns = shown_columns(table)
    words = {*columns} if table.words is None else {*table.words}
    align = {at: "left" if at in words else "right" for at in columns}

    def cell(at: int, content: str | Cell, kind: str = "td") -> str:
        text = content if isinstance(content, str) else " ".join(filter(None, content))
        return f'<{kind} style="text-align:{align[at]}">{html.escape(text)}</{kind}>'

    def row(cells: Sequence[str | Cell]) -> str:
        if len(cells) == 1:
            return f'<th colspan="{len(columns)}" style="text-align:left">{html.escape(str(cells[0]))}</th>'
        kinds = {at: "th" if at == columns[0] and at in words else "td" for at in columns}
        return "".join(cell(at, cells[at] if at < len(cells) else "", kind) for at, kind in kinds.items())

    heads = "".join(cell(at, table.heads[at], "th") for at in columns) if table.heads else ""
    head = f"<thead><tr>{heads}</tr></thead>" if heads else ""
    return f"<table>{head}<tbody>{''.join(f'<tr>{row(cells)}</tr>' for cells in table.rows)}</tbody></table>"


def _draw_pressure(solution: Solved) -> str:
    """Return a plot of the pressure along the contact, clipped where it has no limit."""
    y, pressure = solution.y, solution.centre_pressure
    low, span = float(y[0]), float(np.ptp(y)) or 1.0
    top = ROOM * solution.max_pressure or 1.0
    points = " ".join(
        f"{DRAWN_WIDTH * (place - low) / span:.1f},{DRAWN_HEIGHT * (1.0 - min(value / top, 1.0)):.1f}"
        for place, value in zip(y.tolist(), pressure.tolist(), strict=True)
    )
    return (
        f'<svg role="img" aria-label="pressure along the contact" '
        f'viewBox="0 -2 {DRAWN_WIDTH} {DRAWN_HEIGHT + 4}" width="{DRAWN_WIDTH}" height="{DRAWN_HEIGHT}" '
        'style="display:block;margin:4px 0">'
        f'<polyline points="{points}" fill="none" stroke="currentColor" stroke-width="1.2"/></svg>'
    )
