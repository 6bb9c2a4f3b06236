"""The figures of a report with their captions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

from nonhertz.figures import bearing, contact
from nonhertz.figures.dent import around_dent
from nonhertz.figures.life import life_densities
from nonhertz.figures.overlay import compared_bearings, compared_contacts
from nonhertz.figures.value import Axis, Figure
from nonhertz.plot.drawer import sheet_of
from nonhertz.plot.style import sheet_style
from nonhertz.plot.subsurface import stress_planes_drawn
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.show.bearing import ALL_ROLLERS
from nonhertz.show.sections import Picture

OF_OPERATION: Final = "Film, friction and frequencies"
_LOWER, _MOST_TICKS = 0.64, 5  # of the height of panels, and ticks of half the width


def draw_figures(result: Results) -> dict[str, list[Picture]]:
    """Return the figures of a result by the title of their section, "" for figures before the first section."""
    if isinstance(result, CaseResults):
        values = contact.figures_of(result.solution)
        planes = stress_planes_drawn(result.solution, *result.stress) if result.stress else {}
        more = {"Stress below the surface": draw_pictures(planes), "Life": [*_draw_lives(result)]}
    else:
        values, more = {}, {}
        if result.solution is not None:
            values = bearing.figures_of(result.solution, films=result.case.films(result.solution))
            more = {
                OF_OPERATION: draw_pictures(_film_sheet(values)),
                ALL_ROLLERS: draw_pictures(_select_lower(values, "roller")),
            }
            values = _select_lower(values, "loads", "pressure", "displacement")
    drawn = draw_pictures(values)
    return {"": drawn[:1], "Results": drawn[1:]} | more


def _select_lower(values: Mapping[str, Figure], *names: str) -> dict[str, Figure]:
    """Return the figures of these names that exist, with lower panels; lettering keeps its size."""
    return {
        name: replace(figure, panels=[replace(panel, height=round(_LOWER * panel.height)) for panel in figure.panels])
        for name, figure in values.items()
        if name in names
    }


def _film_sheet(values: Mapping[str, Figure]) -> dict[str, Figure]:
    """Return the figures of films beside each other on one sheet; none if there are none."""
    films = [*_select_lower(values, "film", "film-along").values()]
    if not films:
        return {}
    panels = [replace(panel, along=_halve(figure.along)) for figure in films for panel in figure.panels]
    panels = [replace(panel, beside=bool(number % 2)) for number, panel in enumerate(panels)]
    captions = " ".join(figure.caption for figure in films)
    return {"films": Figure(films[0].along, panels, films[0].conditions, captions)}


def _halve(along: Axis) -> Axis:
    """Return an axis for half the width, with every second tick if there are many."""
    return replace(along, ticks=along.ticks[::2]) if len(along.ticks) > _MOST_TICKS else along


def draw_pictures(values: Mapping[str, Figure]) -> list[Picture]:
    """Draw figures, each with its caption and description."""
    with sheet_style():
        return [Picture(sheet_of(figure), figure.caption, figure.description) for figure in values.values()]


def _draw_lives(result: CaseResults) -> Iterator[Picture]:
    """Yield the damage along the bodies, and that around a dent if one is rolled over."""
    assessed = result.lives
    if assessed is None:
        return
    yield from draw_pictures({"": life_densities(assessed.spectrum, assessed.lives)})
    if assessed.dent is not None:
        yield from draw_pictures({"": around_dent(assessed.dent, assessed.judging_dents)})


def draw_comparison(results: Sequence[Results]) -> list[Picture]:
    """Return one figure of all contacts along y, or of all solved bearings around their axes."""
    bearings = {one.label: one.solution for one in results if isinstance(one, BearingResults) and one.solution}
    contacts = {one.label: one.solution for one in results if isinstance(one, CaseResults)}
    if bearings:
        return draw_pictures({"": compared_bearings(bearings)})
    return draw_pictures({"": compared_contacts(contacts)}) if contacts else []
