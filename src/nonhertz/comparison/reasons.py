"""Where along the line strips and plane grid differ by more than 1 %, and what the solutions tell of why.

Nothing is known beforehand of a case. Each possible reason is a question put to the solutions: is a sharp end or the
end of the contact within a half-width; do semi-elliptic strips agree where parabolic ones do not; is the pressure so
steep that less than a strip or a cell along y makes up for it; is the pressure across no semi-ellipse; does the plane
grid doubt itself there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.comparison.value import (
    Stretch,
    away_from_sharp_ends,
    differences,
    excess_of_fourth_moment,
    sharp_ends,
)
from nonhertz.patch.solution import PatchSolution
from nonhertz.solution import EdgeKind, Solution

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

TOLD = 0.01
UNLIKE = 0.005  # of the fourth moment: cells leave 0.001 of a semi-ellipse
OF_PARABOLA = 3.0  # times worse than semi-elliptic strips


@dataclass(frozen=True)
class _Place:
    """A group of strips that differ, and everything there is to ask."""

    solution: Solution
    semi: Solution
    patch: PatchSolution
    members: Indices
    relative: Array

    @property
    def worst(self) -> int:
        return int(self.members[np.abs(self.relative[self.members]).argmax()])

    @property
    def y(self) -> Array:
        places: Array = self.solution.y[self.members]
        return places

    @property
    def largest(self) -> float:
        return float(abs(self.relative[self.worst]))

    @property
    def cells(self) -> Indices:
        """The rows of the plane grid that hold the middles of these strips."""
        cell = np.floor((self.y - self.patch.y[0]) / self.patch.dy + 0.5).astype(np.intp)
        return np.unique(np.clip(cell, 0, self.patch.y.size - 1))


def stretches(semi: Solution, parabola: Solution, patch: PatchSolution) -> tuple[Stretch, ...]:
    """Return every stretch of the line on which strips differ by more than 1 %, semi-elliptic ones first.

    Parameters
    ----------
    semi, parabola : Solution
        On semi-elliptic and on parabolic strips.
    patch : PatchSolution
        On the plane grid.
    """
    return tuple(
        _stretch(_Place(solution, semi, patch, members, relative))
        for solution in (semi, parabola)
        for relative in (differences(solution, patch),)
        for members in _groups(solution, relative)
    )


def _groups(solution: Solution, relative: Array) -> list[Indices]:
    """Return the strips that differ, those together between which there is less than a half-width.

    What is within a half-width of a sharp end is kept apart.
    """
    found = np.flatnonzero(np.abs(np.nan_to_num(relative, nan=0.0)) > TOLD)
    if found.size == 0:
        return []
    apart = solution.edges[found[1:]] - solution.edges[found[:-1] + 1] > float(solution.half_width.max())
    border = np.diff(away_from_sharp_ends(solution, solution.y[found]))
    return np.split(found, np.flatnonzero(apart | border) + 1)


def _stretch(place: _Place) -> Stretch:
    solution, bias = place.solution, _own_bias(place)
    # What else may be said of the place is no reason where semi-elliptic strips agree.
    asked = [_sharp_end(place), bias, _end_of_contact(place), *([] if bias else [_steep(place), _shape(place)])]
    return Stretch(
        element=solution.element.name,
        low=float(solution.edges[place.members[0]]),
        high=float(solution.edges[place.members[-1] + 1]),
        largest=float(place.relative[place.worst]),
        at=float(solution.y[place.worst]),
        reasons=tuple(sentence for sentence in (*asked, "" if bias else _doubt(place)) if sentence),
    )


def _sharp_end(place: _Place) -> str:
    for edge, width in sharp_ends(place.solution):
        farthest = float(np.max(np.abs(place.y - edge.y)))
        if farthest <= width:
            return (
                f"It lies within {farthest / width:.2g} half-widths of the sharp end at y = {edge.y:.5g} mm, where the "
                f"pressure has no limit: strips of {edge.strip_width:.2g} mm and cells of {place.patch.dy:.2g} mm bear "
                "different means of it."
            )
    return ""


def _own_bias(place: _Place) -> str:
    """Ask whether the element is to blame: strips that differ from these in their shape only do better."""
    if place.solution is place.semi:
        return ""
    near = np.interp(place.y, place.semi.y, np.nan_to_num(differences(place.semi, place.patch), posinf=1.0))
    best, here = (float(np.median(np.abs(each))) for each in (near, place.relative[place.members]))
    if best * OF_PARABOLA > here:
        return ""
    return (
        f"It is the parabola's own: in the median, semi-elliptic strips differ by {_percent(best)} there, parabolic "
        f"ones by {_percent(here)}."
    )


def _end_of_contact(place: _Place) -> str:
    solution, y = place.solution, float(place.solution.y[place.worst])
    sharp = [edge.y for edge, _ in sharp_ends(solution)]
    ends = [end for interval in solution.contact_y for end in interval if end not in sharp]
    nearest = min(ends, key=lambda end: abs(end - y), default=math.inf)
    away, widest = abs(nearest - y), float(solution.half_width.max())
    if away >= widest:
        return ""
    kinds = {edge.y: edge.kind for edge in solution.edge_pressure}
    ending = "is cut off by the strips" if kinds.get(nearest) is EdgeKind.CUT_OFF else "runs out"
    if kinds.get(nearest) is EdgeKind.FINITE:
        ending = "ends with the bodies"
    return f"The contact {ending} at y = {nearest:.5g} mm, {away / widest:.2g} half-widths from where they differ most."


def _steep(place: _Place) -> str:
    """Ask whether a shift along y of less than a strip or a cell makes up for the difference."""
    solution, patch, members = place.solution, place.patch, place.members
    if not away_from_sharp_ends(solution, place.y).all():
        return ""
    slopes = np.abs(np.diff(patch.centre_pressure)) / patch.dy
    steepest = np.maximum(np.append(slopes, 0.0), np.insert(slopes, 0, 0.0))
    slope = np.interp(place.y, patch.y, steepest)
    off = np.abs(solution.peak_pressure[members] - np.interp(place.y, patch.y, patch.centre_pressure))
    shift = np.divide(off, slope, out=np.full(off.shape, np.inf), where=slope > 0.0)
    length = np.maximum(solution.strip_width[members], patch.dy)
    if np.any(shift > length):
        return ""
    at = int(np.argmax(shift))
    return (
        f"The pressure is steep there: a shift along y by {shift[at]:.2g} mm at most, with strips and cells of "
        f"{solution.strip_width[members[at]]:.2g} and {patch.dy:.2g} mm, makes up for it."
    )


def _shape(place: _Place) -> str:
    excess = excess_of_fourth_moment(place.patch)[place.cells]
    if not np.any(np.abs(excess[np.isfinite(excess)]) > UNLIKE):
        return ""
    worst = float(excess[np.nanargmax(np.abs(excess))])
    return (
        f"Across, the pressure is no semi-ellipse there: its fourth moment is {_percent(abs(worst))} "
        f"{'above' if worst > 0.0 else 'below'} that of one with its load and second moment."
    )


def _doubt(place: _Place) -> str:
    """Ask what both methods say of their own errors, of the maximum if that is here."""
    own, patch = place.solution.error_estimate, place.patch
    own_doubt, doubt = max(own.approach, own.load), patch.error_estimate.max_pressure
    if OF_PARABOLA * own_doubt > TOLD:
        size = f"their error at {_percent(own_doubt)}" if math.isfinite(own_doubt) else "no error of their own"
        return f"The strips are few for this contact: they estimate {size}."
    here = np.min(np.abs(place.y - patch.max_pressure_at[1])) <= 2.0 * patch.dy
    if here and math.isfinite(doubt) and OF_PARABOLA * doubt > TOLD:
        return f"The plane grid estimates its own maximum, which is here, to be off by {_percent(doubt)}."
    return ""


def _percent(relative: float) -> str:
    return f"{100.0 * relative:.2g} %" if math.isfinite(relative) else "all of it"
