"""The figures of a report with their captions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from nonhertz.amounts import mm, mpa
from nonhertz.figures.contact import figures_of
from nonhertz.plot import dent_figure, figures, life_figure, stress_figures
from nonhertz.plot.overlay import all_pressed, compared_bearings, compared_contacts
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.show.sections import Picture, Row

_OF_BEARING = {
    "loads": "Loads of all rollers around the bearing's axis.",
    "pressure": "Pressure of all rollers on the centre lines of their contacts, over the angle and along the roller.",
    "roller": "The most loaded roller: pressure on both rings, and the relief that it starts from.",
    "displacement": "Displacement of the inner ring along the force under up to 1.5 times the load.",
}


def belonging(found: Results, numbers: Iterable[Row]) -> dict[str, list[Picture]]:
    """Return the figures of a result by the title of their section, empty for the one before all.

    The numbers that are looked for first describe them.
    """
    words = f"{found.case.title}: {'; '.join(' '.join(filter(None, row)) for row in numbers)}"
    finished = {} if found.solution is None else figures(found.solution)
    if isinstance(found, CaseResults):
        values = figures_of(found.solution)
        drawn = [Picture(finished[name], figure.caption, figure.description) for name, figure in values.items()]
        more = {"Stress below the surface": [*_of_stress(found)], "Life": [*_of_lives(found)]}
    else:
        drawn = [Picture(figure, _OF_BEARING[name], words) for name, figure in finished.items()]
        more = {}
    return {"": drawn[:1], "Results": drawn[1:]} | more


def _of_stress(found: CaseResults) -> Iterator[Picture]:
    """Yield both planes below the surface; none if stress was not requested."""
    if found.stress is None:
        return
    overall, section = found.stress
    captions = {
        "axial-plane": f"Von Mises stress in body {overall.body} below the centre line, along the contact.",
        "cross-section": f"Von Mises stress in the cross-section at y = {mm(section.von_mises.y):.4g}, in true "
        "proportions.",
    }
    largest = overall.von_mises
    at = f"{largest.site}x = {mm(largest.x):.3g}, y = {mm(largest.y):.3g}, z = {mm(largest.z):.3g}"
    for name, figure in stress_figures(found.solution, overall, section).items():
        yield Picture(figure, captions[name], f"The largest is {mpa(largest.max):.5g} {at}.")


def _of_lives(found: CaseResults) -> Iterator[Picture]:
    """Yield the damage along the bodies, and the surroundings of a dent that is rolled over if there is one."""
    assessed = found.lives
    if assessed is None:
        return
    caption = "Where along the contact the bodies fatigue: damage per length over its mean under the ideal pressure."
    lives = [life for body in assessed.lives.values() for life in body]
    words = "; ".join(f"{life.model.name} in body {life.body}: life {life.relative_life:.3g}" for life in lives)
    yield Picture(life_figure(assessed.spectrum, assessed.lives), caption, words)
    if assessed.dent is not None:
        caption = "The largest stress around the dent while it is rolled over, and where it adds damage."
        words = "; ".join(f"{name}: life {life:.3g}" for name, life in assessed.dent_lives.items())
        yield Picture(dent_figure(assessed.dent, assessed.judging_dents), caption, words)


def of_all(found: Sequence[Results]) -> list[Picture]:
    """Return what is along all contacts, or around the axes of all bearings that have a solution, in one figure."""
    words = ", ".join(each.label for each in found)
    bearings = {each.label: each.solution for each in found if isinstance(each, BearingResults) and each.solution}
    if bearings:
        what = "Load and maximum pressure" if all_pressed(bearings) else "Load"
        caption = f"{what} of all rollers at the inner ring, over the angle from the first one; each row has a line."
        return [Picture(compared_bearings(bearings), caption, words)]
    caption = (
        "Pressure on the centre line, half-width, and separation of the bodies before loading (the reliefs of both), "
        "as far as they touch."
    )
    contacts = {each.label: each.solution for each in found if isinstance(each, CaseResults)}
    return [Picture(compared_contacts(contacts), caption, words)] if contacts else []
