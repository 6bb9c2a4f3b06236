"""Design: the dimensions of a contact for the lowest peak pressure or the longest life under all of its loads.

Both goals are searched from several starts (`nonhertz.study.search`), each in a process of its own.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import describe_load, format_digits, mpa, of_dimension
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.files.casefile import Case
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import check_callback, thread_count, whole
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.life import ContactLoadCase, Model
from nonhertz.life.spectrum import check_cases
from nonhertz.result.brief import HasHtml, plain_text, warning_lines
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.study.design_task import check_design, find_starts, shares_of
from nonhertz.study.objective import PRESSURE, DesignPoint, Task, try_point
from nonhertz.study.search import Search, search_from
from nonhertz.study.workers import LostError, Workers
from nonhertz.verdict import Verdict, judge_loads, judge_rows

Array = NDArray[np.float64]
_Point = tuple[dict[str, Any], float, float, Case]  # of a front: values, both pressures, and the case
Portions = Callable[..., Iterator[tuple[Any, Any]]]

POINTS, MOST_POINTS = 9, 50  # of a front
_MET = -1e-4  # of a limit: the rounding by which a search may miss it
AT_BOUND = 1e-3  # of a range: values this close to an end of it count as at the end
SAME = 0.01  # of the goal: starts this close have found the same optimum
COSTS = (0.01, 0.05)  # losses of the goal for which bands of variables are determined
PLACES = 401  # of a relief
BAND_STEPS, BAND_CLOSE = 10, 2e-3  # of the search for an end of a band, and its width in a variable


@dataclass(frozen=True, repr=False)
class Start(ShortRepr):
    """One search.

    Attributes
    ----------
    begun, ended : dict
        Values of the paths at its beginning and at its end.
    value : float
        The goal at its end: the maximum pressure [MPa], or the life relative to that of the original case; NaN if it
        failed.
    history : tuple of float
        The best goal so far, after every evaluation. A first, less accurate search is continued with the accuracy of
        the case, at which the goal may get slightly worse.
    meets : bool
        Whether all limits are met.
    failure : str
        Why the search failed; empty if it did not.
    """

    begun: dict[str, Any]
    ended: dict[str, Any]
    value: float
    history: tuple[float, ...]
    meets: bool
    failure: str = ""


@dataclass(frozen=True)
class Band:
    """The range of one variable in which the goal is worse by no more than a cost.

    Attributes
    ----------
    path : str
        The variable.
    cost : float
        Relative loss of the goal at the ends.
    low, high : float
        The band, in the base unit; an end at a bound of the variable is that bound.
    """

    path: str
    cost: float
    low: float
    high: float


@dataclass(frozen=True, eq=False, repr=False)
class Design(HasFindings, HasHtml):
    """The result of a design.

    Attributes
    ----------
    goal : {"pressure", "life"}
        The goal.
    values : dict
        The best value of every path, in its base unit; for a free profile the square roots of its increments.
    value, before : float
        The goal of the optimum and of the original case: the maximum pressure [MPa], or the life relative to that of
        the original case.
    starts : tuple of Start
        The searches, the best first.
    bands : tuple of Band
        How flat the optimum is; free profiles have none.
    worst : str
        The load with the maximum pressure, or with the largest share of the damage.
    case : Case
        The optimised case.
    was : Case
        The original case.
    loads : tuple of ContactLoadCase
        The loads.
    findings : tuple of Finding
        Values at an end of their range, beyond which better ones may lie.
    """

    goal: str
    values: dict[str, Any]
    value: float
    before: float
    starts: tuple[Start, ...]
    bands: tuple[Band, ...]
    worst: str
    case: Case
    was: Case
    loads: tuple[ContactLoadCase, ...]
    units: dict[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    def __repr__(self) -> str:
        what, unit = ("maximum pressure", " MPa") if self.goal == PRESSURE else ("life, times that before", "")
        lines = [f"{what} {format_digits(self.value)}{unit}, before {format_digits(self.before)}{unit}"]
        for path, value in self.values.items():
            if isinstance(value, float):
                lines.append(f"{path} = {format_digits(value)} {self.units.get(path, '')}".rstrip())
        lines.append(f"{self.agreeing} of {len(self.starts)} starts came within 1 %")
        lines += [f"worst: {self.worst}", *warning_lines(self.warnings)]
        return plain_text("Design", lines)

    @property
    def agreeing(self) -> int:
        """The number of starts that agree within 1 %."""
        return sum(abs(start.value - self.value) <= SAME * abs(self.value) for start in self.starts)

    @cached_property
    def verdict(self) -> Verdict | None:
        """The verdict on the optimised case under its loads: the worst of all."""
        return _verdict(self.case, self.loads)

    @cached_property
    def relief(self) -> tuple[Array, Array, Array]:
        """Positions along body a, its relief after and before, all [mm]; NaN where it has no relief."""
        y = np.linspace(*self.case.contact.interval, PLACES)
        new, old = (case.contact.a.relief(y) + case.contact.b.relief(y) for case in (self.case, self.was))
        new, old = (np.where(np.isfinite(relief), relief, np.nan) for relief in (new, old))
        return y, new, old


@dataclass(frozen=True, repr=False)
class Front(HasFindings, HasHtml):
    """A Pareto front: no design has less of one pressure without more of the other.

    Attributes
    ----------
    values : tuple of dict
        The values of the paths of each point, from the best for the second group to the best for the first.
    first, second : tuple of float
        The maximum pressures under both groups [MPa].
    cases : tuple of Case
        The cases of the points.
    loads : tuple of ContactLoadCase
        The loads of both groups.
    units : dict
        The units of the paths.
    findings : tuple of Finding
        Values at an end of their range, beyond which better points may lie.
    """

    values: tuple[dict[str, Any], ...]
    first: tuple[float, ...]
    second: tuple[float, ...]
    cases: tuple[Case, ...]
    loads: tuple[ContactLoadCase, ...]
    units: dict[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    def __repr__(self) -> str:
        ends = (str(mpa(min(group), max(group), between=" to ")) for group in (self.first, self.second))
        pressures = "maximum pressure {} under the first loads, {} under the second".format(*ends)
        return plain_text("Front", [f"{len(self.values)} points", pressures, *warning_lines(self.warnings)])

    @cached_property
    def verdict(self) -> Verdict | None:
        """Whether limits are met: the verdict on the point with the maximum pressure."""
        return judge_rows(
            np.maximum(self.first, self.second), lambda k: _verdict(self.cases[k], self.loads), what="point"
        )


def optimize(
    case: Case | str | Path,
    *,
    bounds: Mapping[str, Any] | None = None,
    goal: str | None = None,
    loads: Sequence[ContactLoadCase] | None = None,
    constraints: Mapping[str, Any] | None = None,
    model: Model | None = None,
    n_starts: int | None = None,
    workers: int | None = None,
    callback: Callable[[int, int], object] | None = None,
) -> Design:
    """Find the dimensions with which a contact has the lowest peak pressure, or the longest life.

    Parameters
    ----------
    case : Case or str or Path
        The case, or the file of a plan with the case and the other arguments; arguments given here take precedence.
    bounds : mapping
        Lowest and highest value of every path that may be chosen, such as ``{"body.a.profile.drop": "2 um : 60 um"}``;
        for a whole profile ``"free(60 um, 8)"``: one that grows from the middle to both ends by at most 60 um, in 8
        steps.
    goal : {"pressure", "life"}
        The lowest peak pressure under any load (default), or the longest life under all loads.
    loads : sequence of ContactLoadCase, optional
        The loads with their shares of the revolutions; by default the spectrum of the case, or its load.
    constraints : mapping, optional
        Limits of quantities of a solution under every load, such as ``{"approach": "at most 30 um"}``.
    model : Model, optional
        The fatigue model of lives, one without a fatigue limit; Lundberg and Palmgren's by default.
    n_starts : int
        Number of searches, 5 by default: one from the original case, if it lies within the bounds, the others spread
        between these.
    workers : int, optional
        Number of processes; all cores if left out. The result does not depend on it.
    callback : callable, optional
        Called with the number of searches that have ended, and their total number.

    Returns
    -------
    Design

    Raises
    ------
    CaseError
        If a file has mistakes.
    InputError
        If an argument is out of range, or no start finds a design that meets the limits.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
    >>> case = nh.Case(nh.Contact(roller, nh.Plate()), {"load": 20e3, "tilt": 0.5e-3}, {"strips": 41})
    >>> design = optimize(case, bounds={"body.a.profile.radius": (2e3, 2e4)}, n_starts=2, workers=1)
    >>> design.value < design.before, design.agreeing
    (True, 2)
    """
    check_callback(callback)
    task, count = check_design(case, bounds, goal, loads, constraints, model, n_starts)
    begins = find_starts(task, count)
    was = task.template.case({})
    assert isinstance(was, Case)
    as_it_was = Task(task.template, (), task.loads, task.goal, task.model, task.limits)
    before = try_point(as_it_was, np.zeros(0))
    ended: dict[int, Search | LostError] = {}
    processes = min(thread_count(workers), len(begins))
    with contextlib.closing(Workers()) as solving:
        searches = [(number, task, x) for number, x in enumerate(begins)]
        for (number, _, _), search in solving.portions(search_from, searches, processes):
            ended[number] = search
            if callback is not None:
                callback(len(ended), len(begins))
        portions = partial(solving.portions, processes=processes)
        return _summarize(task, was, before, [ended[number] for number in sorted(ended)], portions)


def pareto(
    case: Case | str | Path,
    *,
    first: Sequence[ContactLoadCase],
    second: Sequence[ContactLoadCase],
    bounds: Mapping[str, Any] | None = None,
    constraints: Mapping[str, Any] | None = None,
    points: int = POINTS,
    n_starts: int | None = None,
    workers: int | None = None,
) -> Front:
    """Find the Pareto front of the maximum pressures under two groups of loads, such as aligned and misaligned ones.

    Every point has the lowest peak pressure under the first group with that under the second below a cap. The caps are
    evenly spaced from the lowest possible pressure under the second group to that in the best design for the first.
    Points that are no better than another in either pressure are left out.

    Parameters
    ----------
    case, bounds, constraints, n_starts, workers
        As in `optimize`.
    first, second : sequence of ContactLoadCase
        The groups; their shares have no effect.
    points : int
        Largest number of points, 3 to 50.

    Returns
    -------
    Front

    Raises
    ------
    CaseError, InputError
        As `optimize`.
    """
    points = whole("points", points, 3, MOST_POINTS, "give the number of points")
    checked_groups = check_cases("first", first, ContactLoadCase), check_cases("second", second, ContactLoadCase)
    groups = [[replace(load, share=1.0 / len(group)) for load in group] for group in checked_groups]
    ends = [
        optimize(
            case, bounds=bounds, goal=PRESSURE, loads=group, constraints=constraints, n_starts=n_starts, workers=workers
        )
        for group in groups
    ]
    base, _ = check_design(case, bounds, PRESSURE, groups[0], constraints, None, n_starts)
    every = (*groups[0], *groups[1])
    free, capped = (None,) * len(groups[0]), len(groups[1])
    lowest, highest = ends[1].value, _largest_pressure(ends[0].case, groups[1])
    caps = np.linspace(lowest, highest, points)[1:-1].tolist()
    begins = [np.array(shares_of(base, end.values)) for end in ends]
    tasks = []
    for k, cap in enumerate(caps):
        task = replace(base, loads=every, caps=(*free, *(cap,) * capped))
        # Starts: both ends, and a point between them in proportion to the cap.
        share = (k + 1.0) / (points - 1.0)
        tasks += [(k, task, x) for x in (*begins, (1.0 - share) * begins[1] + share * begins[0])]
    ended = _solve_caps(tasks, workers)
    rows = [(ends[1].values, _largest_pressure(ends[1].case, groups[0]), lowest, ends[1].case)]
    for k in sorted(ended):
        case_at = base.case(ended[k].ended)
        rows.append((base.values(ended[k].ended), ended[k].value, _largest_pressure(case_at, groups[1]), case_at))
    rows.append((ends[0].values, ends[0].value, highest, ends[0].case))
    values, largest, others, cases = zip(*_without_worse(rows), strict=True)
    at_bounds = _at_bounds(base, [shares_of(base, point) for point in values], ends[0].units)
    return Front(values, largest, others, cases, every, ends[0].units, tuple(at_bounds))


def _solve_caps(tasks: Sequence[tuple[int, Task, Array]], workers: int | None) -> dict[int, Search]:
    """Return by number the best search that meets its limits."""
    ended: dict[int, Search] = {}
    with contextlib.closing(Workers()) as solving:
        for (k, _, _), search in solving.portions(search_from, tasks, min(thread_count(workers), len(tasks))):
            if isinstance(search, Search) and search.least_margin >= -1e-3 and search.value < math.inf:
                ended[k] = min(ended.get(k, search), search, key=lambda one: one.value)
    return ended


def _without_worse(rows: list[_Point]) -> list[_Point]:
    """Return the points that no other point improves in one pressure without a loss in the other."""
    return [
        row
        for row in rows
        if not any(other[1] <= row[1] and other[2] <= row[2] and other[1:3] != row[1:3] for other in rows)
    ]


def _largest_pressure(case: Case, loads: Sequence[ContactLoadCase]) -> float:
    with without_accuracy_warnings():
        return max(_solve_load(case, load).max_pressure for load in loads)


def _verdict(case: Case, loads: Sequence[ContactLoadCase]) -> Verdict | None:
    with without_accuracy_warnings():
        return judge_loads((_solve_load(case, load), load.share) for load in loads)


def _solve_load(case: Case, load: ContactLoadCase) -> Solution:
    return solve(case.contact, load=load.load, tilt=load.tilt, **case.solver.keywords)


def _summarize(
    task: Task, was: Case, before: DesignPoint | None, searches: Sequence[Any], portions: Portions
) -> Design:
    chosen = _choose_best(task, [search for search in searches if isinstance(search, Search)])
    judged = task.at(chosen.ended)
    reference = math.nan if before is None else before.value

    def goal(value: float) -> float:
        return value if task.goal == PRESSURE else reference / value

    starts = [_start_of(task, search, goal) for search in searches]
    starts.sort(key=lambda start: (math.isnan(start.value), start.value if task.goal == PRESSURE else -start.value))
    units = {variable.path: task.template.known[variable.path].unit or "" for variable in task.variables}
    return Design(
        task.goal, task.values(chosen.ended), goal(judged.value), goal(reference), tuple(starts),
        _bands(task, judged, portions), _worst_load(judged), judged.case, was, task.loads, units,
        tuple(_at_bounds(task, [chosen.ended.tolist()], units)),
    )  # fmt: skip


def _choose_best(task: Task, searches: Sequence[Search]) -> Search:
    """Return the best search that meets all limits; refuse where there is none."""
    good = [search for search in searches if math.isfinite(search.value)]
    if not good:
        why = searches[0].failure if searches else "no process came back"
        paths = ", ".join(dict.fromkeys(variable.path for variable in task.variables))
        raise InputError(
            "bounds", paths, f"be possible at a start ({why.rstrip('.')})", "change the bounds or the loads"
        )
    margin = max(search.least_margin for search in good)
    if margin < _MET:
        names = ", ".join(limit.name for limit in task.limits) or "bounds of free profiles"
        short = f"by {100.0 * -margin:.3g} %"
        raise InputError(
            "constraints", names, f"be possible, but every start falls short, {short} at least", "relax a limit"
        )
    return min((search for search in good if search.least_margin >= _MET), key=lambda search: search.value)


def _start_of(task: Task, search: Search | LostError, goal: Callable[[float], float]) -> Start:
    if isinstance(search, LostError):
        return Start({}, {}, math.nan, (), False, str(search))
    values, ended = task.values(search.begun), task.values(search.ended)
    history = tuple(map(goal, search.history))
    return Start(values, ended, goal(search.value), history, search.least_margin >= _MET, search.failure)


def _worst_load(judged: DesignPoint) -> str:
    """Return the load with the maximum pressure, or with the largest share of the damage, in words."""
    loads = judged.task.loads
    if judged.task.goal == PRESSURE:
        worst = loads[judged.largest[1]]
        return describe_load(worst.load, worst.tilt)
    parts = np.array([load.share for load in loads]) * judged.damages
    worst = loads[int(np.argmax(parts))]
    return f"{describe_load(worst.load, worst.tilt)}, {100.0 * parts.max() / parts.sum():.3g} % of the damage"


def _at_bounds(task: Task, points: Sequence[Sequence[float]], units: Mapping[str, str]) -> Iterator[Finding]:
    """Yield each variable that is best at an end of its range, at one point or at some of a front."""
    words = "The best {path} is the {end} of its range, {range:g}"
    words += ", at {count} of {points} points" if len(points) > 1 else ""
    words += ": a better one may lie beyond; widen the range, or accept it as the best within the range."
    for variable, *shares in zip(task.variables, *points, strict=True):
        for end, at in (("lowest", 0.0), ("highest", 1.0)) if variable.form is None else ():
            if count := sum(abs(share - at) < AT_BOUND for share in shares):
                numbers = {"count": count, "points": len(points)} if len(points) > 1 else {}
                bounds = of_dimension((variable.low, variable.high), units[variable.path])
                yield finding("at-bound", words, path=variable.path, end=end, range=bounds, **numbers)


def _bands(task: Task, judged: DesignPoint, portions: Portions) -> tuple[Band, ...]:
    """Return the band of each variable at each cost."""
    tasks = [
        (task, judged.x, judged.value, k, cost)
        for k, variable in enumerate(task.variables)
        if variable.form is None
        for cost in COSTS
    ]
    bands = {(job[3], job[4]): band for job, band in portions(_band, tasks) if isinstance(band, Band)}
    return tuple(bands[key] for key in sorted(bands))


def _band(job: tuple[Task, Array, float, int, float]) -> Band:
    """Return the band of a variable; called in other processes."""
    task, x, value, k, cost = job
    variable = task.variables[k]
    # A life that is shorter by a cost means damage that is larger by it.
    allowed = value * (1.0 + cost) if task.goal == PRESSURE else value / (1.0 - cost)

    def worse(share: float) -> bool:
        moved = x.copy()
        moved[k] = share
        judged = try_point(task, moved)
        return judged is None or judged.value > allowed

    def reach(end: float) -> float:
        if abs(end - x[k]) < BAND_CLOSE or not worse(end):
            return end
        inside, outside = float(x[k]), end
        for _ in range(BAND_STEPS):
            if abs(outside - inside) < BAND_CLOSE:
                break
            middle = 0.5 * (inside + outside)
            inside, outside = (inside, middle) if worse(middle) else (middle, outside)
        return inside  # the loss of what is stated is no larger than its cost

    return Band(variable.path, cost, variable.value(reach(0.0)), variable.value(reach(1.0)))
