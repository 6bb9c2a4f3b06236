"""A trace and the steps that turn it into a profile; any of them can be undone."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, get_args

import numpy as np

from nonhertz.amounts import amount, mm, um
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding, sentences
from nonhertz.inputs.checks import check_list, one_of, positive
from nonhertz.inputs.descriptions import Count, Flag, OrFlag, Part, Quantity, Word
from nonhertz.inputs.fields import validate_call
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.measured.corners import CORNER_CUTOFF, is_resolved
from nonhertz.measured.filters import nominal_form, shortest_cutoff, unresolved_length
from nonhertz.measured.land import steps_in
from nonhertz.measured.outlying import THRESHOLD
from nonhertz.measured.roughness import (
    HALF_WIDTH,
    PRESSURE,
    STEEL_COMPLIANCE,
    Roughness,
    roughness_in,
    strain_on_strips,
)
from nonhertz.measured.steps import (
    CUTOFF,
    Align,
    Corners,
    CornersKept,
    Filter,
    Level,
    Middle,
    Outliers,
    Smooth,
    Step,
    StepResult,
    Thin,
    Trim,
    enough_points,
)
from nonhertz.measured.trace import FEWEST_POINTS, LONGEST, Array, Points, Trace
from nonhertz.model.profile import Profile, Tabulated, tabulated
from nonhertz.model.profile.table import Interpolation
from nonhertz.result.brief import HasHtml

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from nonhertz.measured.fitting import ProfileFit

# Fraction of outliers above that of any sound surface: the threshold is wrong or the surface is scratched.
_MANY_OUTLIERS = 0.02
_MANY_GAPS = 5
# Fraction of the line whose points may lie too far apart for the filter before a warning is given.
_COARSE = 0.01
# mm, and the ratio of the height of a parabola of that radius to all other deviations: a line in wrong units.
_LARGEST_RADIUS, _PLAIN = 1e6, 5.0
_SURELY_LONG = 10.0  # mm: the land of such a trace is certainly longer than the cutoff


@dataclass(frozen=True, eq=False, repr=False)
class Measured(ShortRepr, HasHtml):
    """A raw trace and an ordered list of steps that turn it into a profile.

    Methods return changed copies; the raw trace is never modified. A step that already exists is replaced in place; a
    new one is added at the end.

    Parameters
    ----------
    trace : Trace
        The raw measurement.
    steps : tuple of Step
        The steps, in order of application, each kind at most once.

    Examples
    --------
    >>> y = np.linspace(0, 10, 1001)
    >>> trace = Trace(y, 0.002 * y - (y - 5) ** 2 / 2000, name="tilted crown")
    >>> measured = Measured(trace).levelled().aligned()
    >>> [state.name for state in measured.states]
    ['raw', 'level', 'align']
    >>> round(measured.states[1].numbers["tilt"], 6), round(float(measured.profile().relief(5.0)), 6)
    (0.002, 0.0125)
    >>> measured.without("level").steps
    (Align(),)
    """

    trace: Trace
    steps: tuple[Step, ...] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.trace, Trace):
            raise InputError("trace", self.trace, "be a Trace", "read one with nonhertz.files.read_trace")
        steps = check_list("steps", self.steps, "be a list of steps", "give Level(), Align() and the like")
        for step in steps:
            if not (isinstance(getattr(step, "name", None), str) and callable(getattr(step, "apply", None))):
                raise InputError("steps", step, "be a step", "give Level(), Align() and the like")
        object.__setattr__(self, "steps", tuple(steps))
        names = [step.name for step in self.steps]
        twice = [name for name in names if names.count(name) > 1]
        if twice:
            raise InputError("steps", twice[0], "occur only once", "replace the step")

    def levelled(self, slope: float | None = None) -> Measured:
        """Return a copy with the tilt removed; see `Level`."""
        return self._with(Level() if slope is None else Level(slope))

    def aligned(self, by: Middle = "ends") -> Measured:
        """Return a copy with y = 0 in the middle of the body; see `Align`."""
        return self._with(Align(by))

    def trimmed(self, length: float | None = None, slope: float | None = None, corner: Corners = "keep") -> Measured:
        """Return a copy of the body alone, with its corners or without; see `Trim`."""
        return self._with(Trim(length, Trim.slope if slope is None else slope, corner))

    def without_outliers(self, threshold: float = THRESHOLD) -> Measured:
        """Return a copy without points that do not belong to the surface; see `Outliers`."""
        return self._with(Outliers(threshold))

    def smoothed(self, cutoff: float = CUTOFF, method: Filter = "gaussian") -> Measured:
        """Return a copy without roughness; see `Smooth`."""
        return self._with(Smooth(cutoff, method))

    def thinned(self, points: int | None = None) -> Measured:
        """Return a copy with fewer points; None keeps eight per cutoff. See `Thin`."""
        if points is None:
            cutoffs = [step.cutoff for step in self.steps if isinstance(step, Smooth)]
            points = enough_points(self.points.on_land.span, cutoffs[0] if cutoffs else CUTOFF)
        return self._with(Thin(points))

    def without(self, name: str) -> Measured:
        """Return a copy without one step; the others stay.

        Parameters
        ----------
        name : str
            ``"level"``, ``"align"``, ``"trim"``, ``"outliers"``, ``"smooth"`` or ``"thin"``.

        Raises
        ------
        InputError
            If there is no such step.
        """
        one_of("step", name, tuple(step.name for step in self.steps), "name a step that was made")
        return replace(self, steps=tuple(step for step in self.steps if step.name != name))

    @cached_property
    def states(self) -> tuple[StepResult, ...]:
        """The raw points, and the points after each step with its effect."""
        words = f"{len(self.trace)} points from {mm(self.trace.y[0], self.trace.y[-1], between=' to '):.5g}."
        states = [StepResult("raw", self.trace, words, {"points": float(len(self.trace))})]
        for step in self.steps:
            states.append(step.apply(states[-1].points))
        return tuple(states)

    @property
    def points(self) -> Points:
        """The points after the last step."""
        return self.states[-1].points

    @property
    def relief(self) -> Array:
        """Relief [mm] at the points after the last step: greatest height minus height."""
        return np.asarray(self.points.height.max() - self.points.height)

    @property
    def interpolation(self) -> Interpolation:
        """The suitable curve through the points."""
        smooth = self._has("smooth") and not self.points.gaps and not self._coarse_corners()
        return "cubic" if smooth else "pchip"

    def profile(self, interpolation: Interpolation | None = None) -> Profile:
        """Return the profile to solve with, zero at its highest point.

        Parameters
        ----------
        interpolation : str or None
            The curve through the points, as in `nonhertz.profile.tabulated`. None takes ``"cubic"`` for a smoothed
            line, which is dense and smooth enough not to overshoot, and ``"pchip"`` for any other, and where a corner
            has too few points to be smoothed.

        Returns
        -------
        Profile
            The profile, defined between the outermost points.
        """
        table = tabulated(self.points.y.tolist(), self.relief.tolist(), interpolation or self.interpolation)
        assert isinstance(table, Tabulated)
        return table if self.points.land is None else replace(table, joints=self.points.land)

    @property
    def roughness(self) -> Roughness:
        """Roughness that the filter removed, or would remove at the default cutoff."""
        return roughness_in(self._before("smooth", "thin").on_land, self._cutoff)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Doubts before solving with the profile, judged for a typical bearing contact of steel."""
        return sentences(self.findings_for())

    def findings_for(
        self, half_width: float = HALF_WIDTH, pressure: float = PRESSURE, compliance: float = STEEL_COMPLIANCE
    ) -> tuple[Finding, ...]:
        """Return doubts before solving with the profile.

        Parameters
        ----------
        half_width : float
            Half-width of the contact [mm].
        pressure : float
            Pressure of the contact [MPa].
        compliance : float
            Compliance of both bodies together [1/MPa], that of a body being (1 - nu^2) / (pi E).

        Returns
        -------
        tuple of Finding
            Empty if there are none.
        """
        findings = list(strain_on_strips(self.points.on_land, half_width, pressure, compliance, self._has("smooth")))
        findings += [*self._doubt_units(), *_describe_gaps(self.points.gaps), *self._coarse(), *self._coarse_corners()]
        findings += self._report_steps()
        for state in self.states:
            count = state.numbers.get("removed", 0.0)
            if state.name == "outliers" and count > _MANY_OUTLIERS * (len(state.points) + count):
                words = (
                    "{count:.0f} points were removed as outliers, more than {limit:.0f} % of all; check whether they "
                    "are part of the surface."
                )
                findings.append(finding("many-outliers", words, count=count, limit=100 * _MANY_OUTLIERS))
        return tuple(findings)

    def fit(self, kind: str, *, shift: bool = True, tilt: bool = False, **fixed: float) -> ProfileFit:
        """Return the best-fitting profile of one kind from the catalogue; see `nonhertz.measured.fit`."""
        from nonhertz.measured.fitting import fit

        highest = float(self.points.height.max())
        return fit(self._before("smooth", "thin").on_land, kind, shift=shift, tilt=tilt, highest=highest, **fixed)

    def fit_best(
        self, kinds: Iterable[str] | None = None, *, shift: bool = True, tilt: bool = False
    ) -> tuple[ProfileFit, ...]:
        """Return fits of several kinds, best first; see `nonhertz.measured.fit_best`."""
        from nonhertz.measured.fitting import fit_best

        highest = float(self.points.height.max())
        return fit_best(self._before("smooth", "thin").on_land, kinds, shift=shift, tilt=tilt, highest=highest)

    def _before(self, *names: str) -> Points:
        """Return the points before the first of the named steps, or after the last step if none occurs."""
        for state, step in zip(self.states, self.steps, strict=False):
            if step.name in names:
                return state.points
        return self.points

    def _report_steps(self) -> Iterator[Finding]:
        """Yield each step of the surface found in the search for the land."""
        slopes = {step.name: step.slope for step in self.steps if isinstance(step, Level | Align | Trim)}
        for step in steps_in(self._before(*slopes), next(iter(slopes.values()))) if slopes else ():
            beyond = "the part beyond it was taken for another body: if it is not, omit align and trim to a length."
            what = "both sides were taken for one body: check that they are." if step.within else beyond
            words = f"The surface steps by {{height:.3g}} at {{y:.5g}} in the file; {what}"
            yield finding("surface-step", words, height=um(abs(step.height)), y=mm(step.y))

    def _doubt_units(self) -> Iterator[Finding]:
        """Yield that the line is so long, or so little curved, that its units are probably wrong."""
        points = self._before("smooth", "thin").on_land
        curve = nominal_form(points, 2)
        bow = curve - nominal_form(points, 1)
        radius = points.span**2 / (8.0 * max(float(np.ptp(bow)), 1e-300))
        if self.trace.span > LONGEST:
            words = "The line is {span:.3g} long: check the units of its positions and heights."
            yield finding("doubtful-units", words, span=amount(self.trace.span, "mm", "m"))
        elif radius > _LARGEST_RADIUS and np.std(bow) > _PLAIN * np.std(points.height - curve):
            words = "The line has a radius of {radius:.3g}: check the units of its positions and heights."
            yield finding("doubtful-units", words, radius=amount(radius, "mm", "km"))

    def _coarse(self) -> Iterator[Finding]:
        """Yield that the points that were smoothed do not resolve the cutoff everywhere."""
        if not self._has("smooth"):
            return
        points, cutoff = self._before("smooth").on_land, self._cutoff
        length = unresolved_length(points, cutoff)
        if length > _COARSE * points.span:
            yield finding(
                "coarse-points",
                "On {length:.3g} of {span:.4g} points lie further apart than a fifth of the cutoff, {cutoff:.3g}; "
                "there the filter transmits more or less than half of a wave of that length.",
                length=mm(length),
                span=mm(points.span),
                cutoff=mm(cutoff),
            )

    def _coarse_corners(self) -> list[Finding]:
        """Return each corner that has too few points to be smoothed."""
        points, cutoff = self._before("smooth", "thin"), min(CORNER_CUTOFF, self._cutoff)
        corners = zip(("low", "high"), points.beyond_land, strict=True)
        return [
            finding(
                "coarse-corner",
                f"The corner at the {name} end has only {{points}} points, more than a fifth of {{cutoff:.2g}} apart: "
                "too few to be smoothed, and the pressure there depends on where they lie; measure it in finer steps, "
                "or cut it off and give corner_radius.",
                points=int(np.sum(corner)),
                cutoff=mm(cutoff),
            )
            for name, corner in corners
            if np.any(corner) and not is_resolved(points, corner, cutoff)
        ]

    @property
    def _cutoff(self) -> float:
        cutoffs = [step.cutoff for step in self.steps if isinstance(step, Smooth)]
        points = self._before("smooth", "thin").on_land
        return cutoffs[0] if cutoffs else max(min(CUTOFF, 0.2 * points.span), shortest_cutoff(points))

    def _has(self, name: str) -> bool:
        return any(step.name == name for step in self.steps)

    def _with(self, step: Step) -> Measured:
        if self._has(step.name):
            steps = tuple(step if old.name == step.name else old for old in self.steps)
        else:
            steps = (*self.steps, step)
        return replace(self, steps=steps)


@validate_call
def prepare(
    trace: Annotated[Trace, Part("the raw measurement", Trace, "read one with nonhertz.files.read_trace")],
    *,
    level: Annotated[bool, Flag("whether to remove the tilt of the body in the measuring machine")] = True,
    align: Annotated[
        bool | Middle,
        OrFlag(
            Word("", "choose how to find the middle", get_args(Middle)),
            "how to find the middle of the body, 'ends' (true) or 'symmetry'; false leaves y unchanged",
        ),
    ] = True,
    trim: Annotated[
        float | str | bool,
        OrFlag(
            Quantity("mm", "", positive, "give the length to keep in mm, or 'auto'", {"auto": "land and corners"}),
            "'auto' keeps the land and its corners, a number that length about y = 0, false everything",
        ),
    ] = "auto",
    corner: CornersKept = "keep",
    outliers: Annotated[
        float | bool,
        OrFlag(
            Quantity("", "", positive, "give a number of robust standard deviations, such as 5"),
            "number of robust standard deviations beyond which points are removed; true for 5, false for none",
        ),
    ] = True,
    smooth: Annotated[
        bool | Filter,
        OrFlag(
            Word("", "choose a filter", get_args(Filter)),
            "the filter that removes roughness, 'gaussian' (true) or 'spline', or false",
        ),
    ] = "gaussian",
    cutoff: Annotated[float | None, Smooth.descriptions["cutoff"]] = None,
    slope: Annotated[float | None, Level.descriptions["slope"]] = None,
    points: Annotated[
        int | str | bool,
        OrFlag(
            Count("", FEWEST_POINTS, math.inf, "give a number of points to keep", {"auto": "eight per cutoff"}),
            "number of points to keep; 'auto' for eight per cutoff, false for all",
        ),
    ] = "auto",
) -> Measured:
    """Return a trace with the usual steps: level, align, trim, outliers, smooth, thin.

    The default cutoff is that usual for rollers, or a fifth of a shorter land; the default slope is 0.05. Without a
    filter all points are kept instead of eight per cutoff; corners have points of their own.

    Returns
    -------
    Measured
        The trace with its steps.

    Raises
    ------
    InputError
        If a value is out of range.
    """
    limit = Level().slope if slope is None else slope
    steps: list[Step] = []
    if level:
        steps.append(Level(limit))
    if align is not False:
        steps.append(Align("ends" if align is True else align, limit))
    if trim is not False:
        steps.append(Trim(None if isinstance(trim, bool | str) else trim, limit, corner))
    if outliers is not False:
        steps.append(Outliers(THRESHOLD if outliers is True else outliers))
    measured = Measured(trace, tuple(steps))
    if smooth is not False:
        if cutoff is None:
            length = trace.span if trace.span > _SURELY_LONG else measured.points.on_land.span
            cutoff = CUTOFF if length >= CUTOFF else 0.2 * length
        measured = measured.smoothed(cutoff, "gaussian" if smooth is True else smooth)
    if points is False or (smooth is False and isinstance(points, bool | str)):
        return measured
    return measured.thinned(None if isinstance(points, bool | str) else points)


def _describe_gaps(gaps: tuple[tuple[float, float], ...]) -> list[Finding]:
    """Return each gap, or that there are many."""
    if len(gaps) <= _MANY_GAPS:
        words = "Nothing was measured between y = {gap:.5g}; the profile bridges it with a curve."
        return [finding("gap", words, gap=mm(*gap, between=" and ")) for gap in gaps]
    low, high = max(gaps, key=lambda gap: gap[1] - gap[0])
    length = sum(high - low for low, high in gaps)
    words = (
        "Nothing was measured in {gaps} places, {length:.3g} in all, the widest between y = {widest:.5g}; the profile "
        "bridges them with curves."
    )
    return [finding("gap", words, gaps=len(gaps), length=mm(length), widest=mm(low, high, between=" and "))]
