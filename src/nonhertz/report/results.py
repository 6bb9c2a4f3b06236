"""Results of the cases or bearings in a report: solutions, then stress below the surface, life and slices."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import CaseError, ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.files.bearing_document import with_file_path
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.lives import Assessment
from nonhertz.files.sections import Life
from nonhertz.files.stresses import all_findings
from nonhertz.files.toml import name_file_in_errors
from nonhertz.findings import sentences
from nonhertz.inputs.files import printable_name
from nonhertz.life import Model
from nonhertz.result.solution import Solution
from nonhertz.show.analysis import (
    Announce,
    assess_lives,
    choose_models,
    has_strength,
    largest_stresses,
    no_progress,
    solve_loads,
    strengths,
)
from nonhertz.show.solving import try_solve
from nonhertz.strength import Strength
from nonhertz.subsurface import Extremes
from nonhertz.verdict import Verdict, collect_findings, judge_contact, worst_verdict

Item = TypeVar("Item")
Made = TypeVar("Made")
STRESS_STEPS = 2  # searches: in the whole body and in a cross-section


@dataclass(frozen=True, eq=False)
class CaseResults:
    """The results of one case.

    Attributes
    ----------
    case : Case
        The case.
    label : str
        Short name that distinguishes it from other cases.
    solution : Solution
        The solution, or the state in which the solver stopped.
    complaint : str
        Why the solver stopped, or why there is no life; empty if neither failed.
    stress : tuple of two Extremes or None
        The largest stresses in body a and in one cross-section of it.
    strengths : tuple of Strength
        Whether body a, and body b if its strength is known, withstands the stress; empty without stress.
    lives : Assessment or None
        The lives of both bodies; None without them.
    """

    case: Case
    label: str
    solution: Solution
    complaint: str = ""
    stress: tuple[Extremes, Extremes] | None = None
    strengths: tuple[Strength, ...] = ()
    lives: Assessment | None = None

    @property
    def verdict(self) -> Verdict | None:
        """Whether limits are met."""
        if self.complaint:
            return None
        own = judge_contact(self.solution, self.strengths)
        several = self.lives is not None and len(self.lives.spectrum) > 1
        return worst_verdict({"": own, "in the spectrum": self.lives.verdict if several and self.lives else None})

    @property
    def warnings(self) -> tuple[str, ...]:
        """All warnings, without repeats."""
        of_lives = self.lives.warnings if self.lives else ()
        of_stress = sentences(all_findings(self.solution, *(self.stress or ())))
        return tuple(dict.fromkeys((*self.case.notes, *of_stress, *of_lives)))


@dataclass(frozen=True, eq=False)
class BearingResults:
    """The results of one bearing.

    Attributes
    ----------
    case : BearingCase
        The bearing and its loads.
    label : str
        Short name that distinguishes it from other bearings.
    solution : BearingSolution or None
        The loaded bearing; None if no equilibrium was found.
    complaint : str
        Why there is no solution; empty if there is one.
    life : BearingLife or None
        Its life; None if it is not rated, or if no life was requested.
    reason : str
        Why it is not rated.
    slices : BearingSolution or None
        The solution by slices, if a comparison was requested.
    """

    case: BearingCase
    label: str
    solution: BearingSolution | None
    complaint: str = ""
    life: BearingLife | None = None
    reason: str = ""
    slices: BearingSolution | None = None

    @property
    def verdict(self) -> Verdict | None:
        """Whether limits are met."""
        if self.solution is None:
            return None
        return self.case.verdict(self.solution, self.life)

    @property
    def warnings(self) -> tuple[str, ...]:
        """All warnings, without repeats."""
        clearance = self.case.operating_clearance
        messages = () if self.solution is None else sentences(collect_findings(self.solution, self.life, clearance))
        return tuple(dict.fromkeys((*self.case.notes, *messages)))


Results = CaseResults | BearingResults


def require_one_kind(cases: Sequence[Case | BearingCase]) -> Sequence[Case | BearingCase]:
    """Return the cases, which must be all of one kind.

    Raises
    ------
    InputError
        If there are contacts and bearings.
    """
    first = {case.kind: case.path for case in reversed(cases)}
    if len(first) > 1:
        both = f"{first['case']} and {first['bearing']}"
        remedy = "make two reports, one of each kind"
        raise InputError("cases", both, "be all case files or all bearing files", remedy)
    return cases


def solve_all(cases: Sequence[Case | BearingCase], announce: Announce = no_progress) -> tuple[Results, ...]:
    """Return the solutions of all cases, or of all bearings; ``announce`` is called with the label of each.

    Raises
    ------
    CaseError
        If the solver rejects any case, with every mistake; with several cases each is prefixed by its file's name.
    InputError
        If a case made in Python has no form as a case file, which a report shows, or cases and bearings are mixed;
        before anything is solved.
    """
    for case in require_one_kind(cases):
        _ = case.document
    labelled = list(zip(cases, case_labels(cases), strict=True))
    return tuple(make_all(labelled, lambda pair: pair[0].file_name, lambda pair: _solve(*pair, announce)))


def make_all(items: Sequence[Item], name: Callable[[Item], str | Path], make: Callable[[Item], Made]) -> list[Made]:
    """Return the values that ``make`` returns for the items.

    Raises
    ------
    CaseError
        With every mistake; with several items, each mistake is prefixed by the name of its item.
    """
    made: list[Made] = []
    mistakes: list[str] = []
    places: list[str] = []
    for item in items:
        try:
            with name_file_in_errors(name(item)) if len(items) > 1 else contextlib.nullcontext():
                made.append(make(item))
        except CaseError as error:
            mistakes += error.mistakes
            places += error.places
    if mistakes:
        raise CaseError(mistakes, places)
    return made


def _solve(case: Case | BearingCase, label: str, announce: Announce) -> Results:
    announce(label)
    if isinstance(case, Case):
        return CaseResults(case, label, *try_solve(case))
    with without_accuracy_warnings():
        try:
            return BearingResults(case, label, case.solve())
        except ConvergenceError as error:
            return BearingResults(case, label, None, str(error))
        except InputError as error:  # from a contact whose pressure is solved
            raise with_file_path(error, case.document) from None


def post_process(
    results: Sequence[Results],
    *,
    life: bool | None = None,
    stress: bool = True,
    compare: bool = False,
    announce: Announce = no_progress,
) -> tuple[Results, ...]:
    """Return results with stress, life and slices added, where requested and where the case has converged.

    Parameters
    ----------
    results : sequence of CaseResults or of BearingResults
        The results of `solve_all`.
    life : bool or None
        Whether to assess lives; None for cases with a table life, and for all bearings.
    stress : bool
        Whether to search for the largest stresses below the surface; without effect on bearings.
    compare : bool
        Whether to solve bearings by slices as well.
    announce : callable
        Called with the name of each step as it begins; `count_steps` returns how often.
    """
    living = [result for result in results if isinstance(result, CaseResults) and _wants_life(result, life)]
    # All cases by the models of the first, so that lives can be compared.
    models, notes = choose_models(living[0].case, (), [result.case for result in living]) if living else ((), ())

    def process(result: Results) -> Results:
        if result.complaint or result.solution is None:
            return result
        if isinstance(result, BearingResults):
            return _rate_bearing(result, life is not False, compare)
        if stress:
            result = _with_stress(result, announce)
        return _with_life(result, models, notes, announce) if _wants_life(result, life) else result

    return tuple(make_all(results, lambda result: result.case.file_name, process))


def _with_stress(result: CaseResults, announce: Announce) -> CaseResults:
    largest = largest_stresses(result.solution, announce=announce)
    return replace(result, stress=largest, strengths=strengths(result.solution, largest[0], announce))


def _with_life(
    result: CaseResults, models: tuple[Model, ...], notes: tuple[str, ...], announce: Announce
) -> CaseResults:
    try:
        return replace(result, lives=assess_lives(result.case, solve_loads(result.case), models, notes, announce))
    except ConvergenceError as error:
        return replace(result, complaint=str(error))


def count_steps(results: Sequence[Results], *, life: bool | None = None, stress: bool = True) -> int:
    """Return how many steps `post_process` will announce."""
    contacts = [result for result in results if isinstance(result, CaseResults) and not result.complaint]
    searches = sum(STRESS_STEPS + has_strength(result.solution.contact.b) for result in contacts) if stress else 0
    return searches + sum(result.case.life.steps for result in contacts if _wants_life(result, life))


def _rate_bearing(result: BearingResults, rated: bool, compare: bool) -> BearingResults:
    """Return a bearing with its life and its solution by slices, where requested."""
    assert result.solution is not None
    with without_accuracy_warnings():
        life, reason = result.case.rated(result.solution) if rated else (None, "")
        try:
            slices = result.case.solve("slices") if compare and result.solution.method == "strips" else None
        except ConvergenceError as error:
            return BearingResults(result.case, result.label, None, str(error))
    return replace(result, life=life, reason=reason, slices=slices)


def _wants_life(result: CaseResults, life: bool | None) -> bool:
    says_of_life = result.case.life != Life()
    return not result.complaint and (says_of_life if life is None else life)


def case_labels(cases: Sequence[Case | BearingCase]) -> list[str]:
    """Return the label of each case in tables and legends: its file's name, with path or number if ambiguous."""
    names = [Path(case.file_name).stem for case in cases]
    if len(set(names)) < len(names):
        names = [printable_name(str(case.path.with_suffix(""))) for case in cases]
    if len(set(names)) < len(names):
        names = [f"{name} ({number})" for number, name in enumerate(names, start=1)]
    return names
