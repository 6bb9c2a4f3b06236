"""The figures of a report with their captions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import count
from typing import TYPE_CHECKING

from nonhertz.amounts import mm, mpa
from nonhertz.plot import bearing_figures, dent_figure, figures, life_figure, measured_figure, stress_figures
from nonhertz.plot.units import rewrite_units
from nonhertz.report.bearing.overview import bearing_keys
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.drawing import inline_svg
from nonhertz.report.measurements import Measurement
from nonhertz.report.overlay import all_pressed, compared_bearings, compared_contacts
from nonhertz.report.overview import Key, keys
from nonhertz.report.results import CaseResults

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_OF_BEARING = {
    "loads": "Loads of all rollers around the bearing's axis.",
    "pressure": "Pressure of all rollers on the centre lines of their contacts, over the angle and along the roller.",
    "roller": "The most loaded roller: pressure on both rings, and the relief that it starts from.",
    "displacement": "Displacement of the inner ring along the force under up to 1.5 times the load.",
}
_SHARP = " Where the pressure has no limit the axis is cut, with exponent and strength beside it."


@dataclass(frozen=True)
class ReportFigure:
    """A figure of the page.

    Attributes
    ----------
    number : int
        Its number.
    svg : str
        An ``svg`` element.
    caption : str
        The text below it.
    """

    number: int
    svg: str
    caption: str


class Gallery:
    """Draws the figures of one page and numbers them."""

    def __init__(self) -> None:
        self._numbers = count(1)

    def of_solution(self, found: CaseResults) -> dict[str, ReportFigure]:
        """Return pressure, footprint and profile, by these names."""
        solution = found.solution
        captions = {
            "pressure": "Pressure on the centre line and half-width along the contact."
            + (_SHARP if solution.singular_ends else ""),
            "footprint": "Contact area, coloured by its pressure"
            + (" (the dotted line is the half-width)." if solution.element.name == "parabolic" else "."),
            "profile": "Distance of both surfaces on the centre line before and after loading.",
        }
        summary = f"{found.case.title}: {self.in_words(keys(found))}"
        return {name: self.picture(drawn, captions[name], summary) for name, drawn in figures(solution).items()}

    def of_stress(self, found: CaseResults) -> dict[str, ReportFigure]:
        """Return both planes below the surface; empty if stress was not requested."""
        if found.stress is None:
            return {}
        overall, section = found.stress
        captions = {
            "axial-plane": f"Von Mises stress in body {overall.body} below the centre line, along the contact.",
            "cross-section": f"Von Mises stress in the cross-section at y = {mm(section.von_mises.y):.4g}, in true "
            "proportions.",
        }
        largest = overall.von_mises
        at = f"{largest.site}x = {mm(largest.x):.3g}, y = {mm(largest.y):.3g}, z = {mm(largest.z):.3g}"
        summary = f"The largest is {mpa(largest.max):.5g} {at}."
        return {
            name: self.picture(drawn, captions[name], summary)
            for name, drawn in stress_figures(found.solution, overall, section).items()
        }

    def of_lives(self, found: CaseResults) -> ReportFigure | None:
        """Return the damage along the bodies, if lives were requested."""
        if found.lives is None:
            return None
        drawn = life_figure(found.lives.spectrum, found.lives.lives)
        caption = (
            "Where along the contact the bodies fatigue: damage per length over its mean under the ideal pressure."
        )
        lives = [life for body in found.lives.lives.values() for life in body]
        summary = "; ".join(f"{life.model.name} in body {life.body}: life {life.relative:.3g}" for life in lives)
        return self.picture(drawn, caption, summary)

    def of_dent(self, found: CaseResults) -> ReportFigure | None:
        """Return the surroundings of a dent that is rolled over, if there is one."""
        if found.lives is None or found.lives.dent is None:
            return None
        drawn = dent_figure(found.lives.dent, found.lives.judging_dents)
        caption = "The largest stress around the dent while it is rolled over, and where it adds damage."
        lives = (f"{name}: life {life:.3g}" for name, life in found.lives.dent_lives.items())
        return self.picture(drawn, caption, "; ".join(lives))

    def of_measurement(self, measurement: Measurement) -> ReportFigure:
        """Return the steps from measured points to a profile."""
        caption = f"From the measured points of {measurement.file} to the profile, step by step."
        summary = " ".join(words for _, words in measurement.rows)
        return self.picture(measured_figure(measurement.measured), caption, summary)

    def of_all(self, found: Sequence[CaseResults]) -> ReportFigure:
        """Return pressures, half-widths and separations of all cases."""
        caption = (
            "Pressure on the centre line, half-width, and separation of the bodies before loading (the reliefs of "
            "both), as far as they touch."
        )
        return self.picture(compared_contacts(found), caption, ", ".join(each.label for each in found))

    def of_bearing(self, found: BearingResults) -> Iterator[ReportFigure]:
        """Yield loads, and pressure, most loaded roller and displacement as far as there are any."""
        if found.solution is None:
            return
        summary = f"{found.case.title}: {self.in_words(bearing_keys(found))}"
        for name, drawn in bearing_figures(found.solution).items():
            yield self.picture(drawn, _OF_BEARING[name], summary)

    def of_bearings(self, found: Sequence[BearingResults]) -> ReportFigure | None:
        """Return the loads of the rollers of all bearings over their angle, and pressures if all have any."""
        solved = [each for each in found if each.solution is not None]
        if not solved:
            return None
        what = "Load and maximum pressure" if all_pressed(solved) else "Load"
        caption = f"{what} of all rollers at the inner ring, over the angle from the first one; each row has a line."
        return self.picture(compared_bearings(solved), caption, ", ".join(each.label for each in found))

    def in_words(self, numbers: Iterable[Key]) -> str:
        """Return key numbers as the description of a figure, for those who do not see it."""
        said = (f"{key.name} {key.value} {key.unit} {key.remark}".strip() for key in numbers)
        return "; ".join(said)

    def picture(self, figure: Figure, caption: str, description: str) -> ReportFigure:
        """Return a figure with the next number."""
        number = next(self._numbers)
        rewrite_units(figure)
        svg = inline_svg(figure, f"figure-{number}", caption, description)
        return ReportFigure(number, svg, caption)
