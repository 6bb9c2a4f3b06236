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


def belonging(found: Results) -> dict[str, list[Picture]]:
    """Return the figures of a result by the title of their section, empty for the one before all."""
    if isinstance(found, CaseResults):
        values = contact.figures_of(found.solution)
        planes = stress_planes_drawn(found.solution, *found.stress) if found.stress else {}
        more = {"Stress below the surface": pictures_of(planes), "Life": [*_of_lives(found)]}
    else:
        values, more = {}, {}
        if found.solution is not None:
            values = bearing.figures_of(found.solution, films=found.case.films(found.solution))
            more = {OF_OPERATION: pictures_of(_of_films(values)), ALL_ROLLERS: pictures_of(_named(values, "roller"))}
            values = _named(values, "loads", "pressure", "displacement")
    drawn = pictures_of(values)
    return {"": drawn[:1], "Results": drawn[1:]} | more


def _named(values: Mapping[str, Figure], *names: str) -> dict[str, Figure]:
    """Return the figures of these names, as far as there are any, with lower panels: lettering stays as large."""
    return {
        name: replace(figure, panels=[replace(panel, height=round(_LOWER * panel.height)) for panel in figure.panels])
        for name, figure in values.items()
        if name in names
    }


def _of_films(values: Mapping[str, Figure]) -> dict[str, Figure]:
    """Return the figures of films beside each other on one sheet; none if there are none."""
    films = [*_named(values, "film", "film-along").values()]
    if not films:
        return {}
    panels = [replace(panel, along=_half(figure.along)) for figure in films for panel in figure.panels]
    panels = [replace(panel, beside=bool(number % 2)) for number, panel in enumerate(panels)]
    captions = " ".join(figure.caption for figure in films)
    return {"films": Figure(films[0].along, panels, films[0].conditions, captions)}


def _half(along: Axis) -> Axis:
    """Return an axis for half the width, with every second tick of many."""
    return replace(along, ticks=along.ticks[::2]) if len(along.ticks) > _MOST_TICKS else along


def pictures_of(values: Mapping[str, Figure]) -> list[Picture]:
    """Draw figures, each with what it says of itself."""
    with sheet_style():
        return [Picture(sheet_of(figure), figure.caption, figure.description) for figure in values.values()]


def _of_lives(found: CaseResults) -> Iterator[Picture]:
    """Yield the damage along the bodies, and the surroundings of a dent that is rolled over if there is one."""
    assessed = found.lives
    if assessed is None:
        return
    yield from pictures_of({"": life_densities(assessed.spectrum, assessed.lives)})
    if assessed.dent is not None:
        yield from pictures_of({"": around_dent(assessed.dent, assessed.judging_dents)})


def of_all(found: Sequence[Results]) -> list[Picture]:
    """Return what is along all contacts, or around the axes of all bearings that have a solution, in one figure."""
    bearings = {each.label: each.solution for each in found if isinstance(each, BearingResults) and each.solution}
    contacts = {each.label: each.solution for each in found if isinstance(each, CaseResults)}
    if bearings:
        return pictures_of({"": compared_bearings(bearings)})
    return pictures_of({"": compared_contacts(contacts)}) if contacts else []
