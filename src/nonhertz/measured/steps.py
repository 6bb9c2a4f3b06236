"""The steps from a raw trace to a profile: each a value with its parameters, applied to points.

A step takes points and returns a `StepResult`: the points after it, what it removed and a sentence on what it did. It
modifies nothing, so that a step can be left out or repeated with other parameters, and the raw points are kept.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, ClassVar, Literal, Protocol, get_args

import numpy as np

from nonhertz.amounts import amount, mm, mrad, um
from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive
from nonhertz.inputs.descriptions import Count, Quantity, Word
from nonhertz.inputs.fields import Input, input_class
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.measured.corners import CORNER_CUTOFF, FEWEST_IN_CORNER, SHARPEST, joint, positions, smooth_corners, turns
from nonhertz.measured.filters import check_cutoff, gaussian, spline
from nonhertz.measured.land import CHAMFER_SLOPE, corner_ends, land, symmetry, tilt
from nonhertz.measured.outlying import THRESHOLD, outliers
from nonhertz.measured.trace import FEWEST_POINTS, Array, Points

#: Wavelength [mm] that separates roughness from form: the value of ISO 21920-3 and ISO 4288 for finely ground surfaces.
CUTOFF = 0.8

_POINTS_PER_CUTOFF = 8
_FEWEST_THINNED, _MOST_THINNED = 51, 1001
#: How the middle of a body is found.
Middle = Literal["ends", "symmetry"]
#: How roughness is removed.
Filter = Literal["gaussian", "spline"]
#: Treatment of the corners beyond the land.
Corners = Literal["keep", "cut"]
ChamferSlope = Annotated[
    float,
    Quantity(
        "",
        "slope at which the land ends and a chamfer begins",
        positive,
        "give the slope at which a chamfer begins, such as 0.05, 50 um in a millimetre",
    ),
]
CornersKept = Annotated[
    Corners,
    Word(
        "whether corners in the trace are kept ('keep'), smoothed separately from the land, or cut off ('cut')",
        "choose one of them",
        get_args(Corners),
    ),
]


@dataclass(frozen=True, eq=False, repr=False)
class StepResult(ShortRepr):
    """The points after a step, and its effect.

    Attributes
    ----------
    name : str
        The step's name; ``"raw"`` before all steps.
    points : Points
        The remaining points.
    words : str
        A sentence on the step, with its numbers.
    numbers : mapping of str to float
        The numbers: ``tilt`` [rad], ``shift``, ``low``, ``high`` [mm], ``removed`` (a count) and so on.
    removed : tuple of array or None
        Positions and heights [mm] of the points removed.
    removed_height : array or None
        What was subtracted from the heights of the remaining points [mm].
    """

    name: str
    points: Points
    words: str
    numbers: Mapping[str, float] = field(default_factory=dict)
    removed: tuple[Array, Array] | None = None
    removed_height: Array | None = None

    @property
    def y(self) -> Array:
        """Positions [mm] of the remaining points."""
        return self.points.y

    @property
    def height(self) -> Array:
        """Heights [mm] of the remaining points."""
        return self.points.height

    @property
    def gaps(self) -> tuple[tuple[float, float], ...]:
        """Intervals [mm] without points in which something should have been measured."""
        return self.points.gaps


class Step(Protocol):
    """A step: a name by which to undo it, and its action on points."""

    name: ClassVar[str]

    def apply(self, points: Points) -> StepResult:
        """Return the points after the step, and its effect."""


@input_class()
class Level(Input):
    """Remove the tilt of the body in the measuring machine.

    Chamfers are left out. About the middle of the land between them the heights have an even part, which contains any
    symmetric shape, and an odd part, in which a tilt is a straight line. The line of least absolute deviations through
    the odd part is subtracted: a crown does not affect it, whatever its drop, and one end that has lost more material
    than the other hardly does.
    """

    name: ClassVar[str] = "level"
    slope: ChamferSlope = CHAMFER_SLOPE

    def apply(self, points: Points) -> StepResult:
        """Return the levelled points; the middle of the land keeps its height."""
        low, high = land(points, self.slope)
        lean = tilt(points, self.slope)
        line = lean * (points.y - 0.5 * (low + high))
        words = f"A tilt of {mrad(lean):.4g} was removed, that of the land from {mm(low, high, between=' to '):.4g}."
        after = points.lifted(points.height - line)
        return StepResult(self.name, after, words, {"tilt": lean, "low": low, "high": high}, removed_height=line)


@input_class()
class Align(Input):
    """Move y = 0 to the middle of the body.

    Raises
    ------
    InputError
        When ``"symmetry"`` is applied to a land without a centre of symmetry, such as a single circular arc.
    """

    name: ClassVar[str] = "align"
    by: Annotated[
        Middle,
        Word(
            "how the middle is found: 'ends', half-way between the ends of the land, where the chamfers begin (or of "
            "the trace, if there are none); 'symmetry', where the land is most like its own mirror image",
            "choose how to find the middle",
            get_args(Middle),
        ),
    ] = "ends"
    slope: ChamferSlope = CHAMFER_SLOPE

    def apply(self, points: Points) -> StepResult:
        """Return the points moved along y."""
        low, high = land(points, self.slope)
        if self.by == "ends":
            middle: float | None = 0.5 * (low + high)
        else:
            middle = symmetry(points, self.slope)
        if middle is None:
            condition = "find a place about which the land is symmetric"
            raise InputError("align", self.by, condition, "align by 'ends', or leave align out and shift the profile")
        at_end = [end for end, last in ((low, points.y[0]), (high, points.y[-1])) if end == last]
        symmetric = "is symmetric about it and " if self.by == "symmetry" else ""
        words = f"The middle of the body, {mm(middle):.5g} in the file, became y = 0; the land {symmetric}ends at "
        words += f"{mm(low, high, between=' and '):.5g}"
        words += (".", ", one of which is an end of the trace.", ", where the trace ends.")[len(at_end)]
        gaps = tuple((a - middle, b - middle) for a, b in points.gaps)
        ends = None if points.land is None else (points.land[0] - middle, points.land[1] - middle)
        after = Points(points.y - middle, points.height, gaps, land=ends)
        return StepResult(self.name, after, words, {"shift": -middle, "low": low - middle, "high": high - middle})


@input_class()
class Trim(Input):
    """Cut off everything that does not belong to the body, and mark the ends of the land, where corners begin.

    See `nonhertz.measured.corners`.

    Raises
    ------
    InputError
        When a length is applied that the points do not cover.
    """

    name: ClassVar[str] = "trim"
    length: Annotated[
        float | None,
        Quantity(
            "mm",
            "length to keep, half of it on either side of y = 0, all of it as one land; if left out, the land and its "
            "corners are kept, each corner up to its lowest point",
            positive,
            "give the length to keep in mm, or 'auto'",
        ),
    ] = None
    slope: ChamferSlope = CHAMFER_SLOPE
    corner: CornersKept = "keep"

    def apply(self, points: Points) -> StepResult:
        """Return the points that are kept."""
        points, ends = Points(points.y, points.height, points.gaps), None
        low, high = land(points, self.slope) if self.length is None else (-0.5 * self.length, 0.5 * self.length)
        if self.length is None and self.corner == "keep":
            ends, (low, high) = _find_corners(points, (low, high), self.slope)
        if low < points.y[0] - 1e-9 or high > points.y[-1] + 1e-9:
            condition = f"lie within the points, which go from {mm(points.y[0], points.y[-1], between=' to '):.5g}"
            raise InputError("trim", self.length, condition, "give a shorter length, and align before trimming")
        inside = (points.y >= low - 1e-9) & (points.y <= high + 1e-9)
        after = replace(points.kept(inside), land=ends)
        cut = float(after.y[0] - points.y[0]), float(points.y[-1] - after.y[-1])
        lost = f"; cut off {mm(*cut, between=' and '):.3g}." if any(cut) else ""
        words = f"Kept from {mm(after.y[0], after.y[-1], between=' to '):.5g}"
        words += lost or "; there was nothing to cut off."
        numbers = {"low": float(after.y[0]), "high": float(after.y[-1]), "removed": float(np.sum(~inside))}
        if ends is not None:
            numbers |= {"land_low": ends[0], "land_high": ends[1]}
            corners_found = []
            for name, corner, at_end in zip(("low", "high"), after.beyond_land, (0, -1), strict=True):
                if np.any(corner):
                    width = abs(float(after.y[at_end] - after.on_land.y[at_end]))
                    depth = float(after.on_land.height[at_end] - after.height[at_end])
                    numbers |= {f"width_{name}": width, f"depth_{name}": depth}
                    corners_found.append(f"{name} end {mm(width):.2g} wide, {um(depth):.3g} deep")
            corners = "corners" if len(corners_found) > 1 else "corner"
            words = (
                f"Land from {mm(*ends, between=' to '):.5g}, {corners} kept: {'; '.join(corners_found)}{lost or '.'}"
            )
        return StepResult(self.name, after, words, numbers, (points.y[~inside], points.height[~inside]))


def _find_corners(
    points: Points, ends: tuple[float, float], slope: float
) -> tuple[tuple[float, float] | None, tuple[float, float]]:
    """Return where the corners begin and end [mm]; None and the ends of the land if there are none."""
    begins, bounds = list(ends), list(ends)
    for k, (end, outermost, side) in enumerate(zip(ends, corner_ends(points, slope), (-1, 1), strict=True)):
        beyond = (side * points.y > side * end) & (side * points.y <= side * outermost)
        if np.sum(beyond) >= FEWEST_IN_CORNER:
            begins[k], bounds[k] = joint(points, end, side), outermost
    if bounds == list(ends):
        return None, ends
    return (begins[0], begins[1]), (bounds[0], bounds[1])


@input_class()
class Outliers(Input):
    """Remove points that do not belong to the surface: dust, scratches, lost contact of the stylus.

    A point is removed if it lies further than a limit off the surface on its left, extrapolated to it, off that on its
    right, and off the chord between the two, on the same side of all; and if it and its neighbours that do so amount to
    no more than a scratch or a grain, up to a hundredth of the line wide and at most 0.2 mm. Anything wider, a dent, is
    form and stays as measured. Beside a scratch, at a wall and at an edge a point still has a side that it belongs to,
    and stays as well. See `nonhertz.measured.outlying`.

    The limit is a number of robust standard deviations of the distances from chords: 1.4826 times their median, or
    0.608 times their 90 % quantile if that is more. Rounded heights, or chatter on a part of the line, have a median of
    nearly zero, and what one point in ten does is still the surface. Neither measure is affected by fewer points, which
    is the idea of the robust filter of ISO 16610-31. Removed points are not replaced. The land is searched by itself;
    for the corners beyond it the limit is that of the roughest of the three.
    """

    name: ClassVar[str] = "outliers"
    threshold: Annotated[
        float,
        Quantity(
            "",
            "number of robust standard deviations beyond which a point is removed",
            positive,
            "give a number of robust standard deviations, such as 5",
        ),
    ] = THRESHOLD

    def apply(self, points: Points) -> StepResult:
        """Return the remaining points."""
        out, limit = outliers(points, self.threshold)
        count = int(np.sum(out))
        if len(points) - count < FEWEST_POINTS:
            condition = f"leave at least {FEWEST_POINTS} points"
            raise InputError("outliers", self.threshold, condition, "raise the number of standard deviations")
        share = 100.0 * count / len(points)
        words = f"{count} of {len(points)} points ({share:.2g} %) lay more than {um(limit):.3g} "
        words += "off the surface on both sides and were removed."
        after = points.kept(~out)
        numbers = {"removed": float(count), "limit": limit}
        return StepResult(self.name, after, words, numbers, (points.y[out], points.height[out]))


@input_class()
class Smooth(Input):
    """Remove roughness: waves shorter than a cutoff.

    Corners, where the trace holds any, are smoothed apart from the land and joined to it, with a cutoff of 0.08 mm or
    this one, if it is shorter. See `nonhertz.measured.corners`.

    Raises
    ------
    InputError
        When a cutoff shorter than five points or longer than the line is applied.
    """

    name: ClassVar[str] = "smooth"
    cutoff: Annotated[
        float,
        Quantity(
            "mm",
            "wavelength at which the filter transmits 50 %",
            positive,
            "give a wavelength in mm, such as 0.8",
        ),
    ] = CUTOFF
    method: Annotated[
        Filter,
        Word(
            "'gaussian', the filter of ISO 16610-21, or 'spline', that of ISO 16610-22, which transmits less of "
            "shorter and more of longer waves; see `nonhertz.measured.filters` for their behaviour at the ends",
            "choose a filter",
            get_args(Filter),
        ),
    ] = "gaussian"

    def apply(self, points: Points) -> StepResult:
        """Return the smooth points."""
        land = points.on_land
        check_cutoff(land, self.cutoff)
        height = (gaussian if self.method == "gaussian" else spline)(land, self.cutoff)
        corner_cutoff = min(CORNER_CUTOFF, self.cutoff)
        if points.land is not None:
            height = smooth_corners(points, height, corner_cutoff)
        rough = points.height - height
        rms = float(np.sqrt(np.mean(rough[~np.logical_or(*points.beyond_land)] ** 2)))
        words = f"Waves shorter than {mm(self.cutoff):.4g} were removed by the {self.method} filter: "
        words += f"{um(rms):.3g} root mean square."
        if points.land is not None:
            words = words[:-1] + f"; in the corners those shorter than {mm(corner_cutoff):.2g}."
        after = points.lifted(height)
        edges = [name for name, turn in zip(("low", "high"), turns(after), strict=True) if turn > SHARPEST]
        if edges:
            words += f" At the {' and '.join(edges)} end the corner begins with an edge, at which the maximum pressure "
            words += "depends on the points."
        return StepResult(self.name, after, words, {"cutoff": self.cutoff, "rms": rms}, removed_height=rough)


@input_class()
class Thin(Input):
    """Keep only as many points as a smooth line needs: the solver has a few hundred strips, a trace 10,000 points.

    Heights at evenly spaced positions are interpolated linearly between neighbouring points. Gaps narrower than the new
    spacing are bridged and no longer count as gaps. Corners keep points of their own, 10 um apart where they begin.
    """

    name: ClassVar[str] = "thin"
    count: Annotated[
        int,
        Count(
            "number of points of the land to keep; a land with fewer is left unchanged",
            FEWEST_POINTS,
            math.inf,
            "give a number of points to keep, or 'auto'",
        ),
    ] = 201

    def apply(self, points: Points) -> StepResult:
        """Return the points kept."""
        land = points.on_land
        if len(land) <= self.count:
            return StepResult(self.name, points, f"All {len(points)} points were kept.", {"points": float(len(points))})
        y = np.linspace(land.y[0], land.y[-1], self.count)
        gaps = tuple((low, high) for low, high in points.gaps if high - low > y[1] - y[0])
        if points.land is not None:
            y = _merge(y, positions(points))
        height = np.interp(y, points.y, points.height)
        for low, high in gaps:
            hollow = (y > low) & (y < high)
            y, height = y[~hollow], height[~hollow]
        after = Points(y, height, gaps, land=points.land)
        lost = land.height - np.interp(land.y, y, height)
        apart = np.diff(after.y) if points.land is None else np.array([land.span / (self.count - 1)])
        words = f"{len(after)} of {len(points)} points were kept, {um(float(apart.mean())):.3g} apart"
        words += "" if points.land is None else " on the land and closer at the corners"
        missed = amount(float(np.max(np.abs(lost))), "mm", "nm")
        words += f"; straight lines between them miss {missed:.2g} at most"
        words += "." if points.land is None else ", on the land."
        return StepResult(self.name, after, words, {"points": float(len(after))})


def enough_points(length: float, cutoff: float) -> int:
    """Return how many points a line smoothed at a cutoff [mm] needs: eight per cutoff."""
    # A length of whole cutoffs needs no point more because of rounding.
    enough = math.ceil(_POINTS_PER_CUTOFF * length / cutoff - 1e-6) + 1
    return min(max(enough, _FEWEST_THINNED), _MOST_THINNED)


def _merge(y: Array, more: Array) -> Array:
    """Return positions and those of the corners, without any so close to those that a spline would swing."""
    nearest = np.abs(y[:, np.newaxis] - more).min(axis=1, initial=math.inf)
    # Not half, which rounding would make more or less of where both are multiples of one step.
    least = 0.49 * float(np.min(np.diff(np.sort(more)), initial=math.inf))
    return np.union1d(y[nearest > min(least, y[1] - y[0])], more)
