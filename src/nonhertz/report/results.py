"""Results of the cases or bearings in a report: solutions first, then stress below the surface, life and slices."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import CaseError, ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase, with_file_path
from nonhertz.files.casefile import Case
from nonhertz.files.lives import Assessment
from nonhertz.files.sections import Life
from nonhertz.files.stresses import all_findings
from nonhertz.files.toml import name_file_in_errors
from nonhertz.findings import sentences
from nonhertz.inputs.files import printable_name
from nonhertz.result.solution import Solution
from nonhertz.show.analysis import (
    Announce,
    assessed,
    bears_something,
    in_silence,
    largest_stresses,
    models_for,
    spectrum_solved,
    strengths,
)
from nonhertz.show.solving import attempted
from nonhertz.strength import Strength
from nonhertz.subsurface import Extremes
from nonhertz.verdict import Verdict, collect_findings, judge_contact, worst_verdict

Given = TypeVar("Given")
Made = TypeVar("Made")
STRESS_STEPS = 2  # in the whole body and in a cross-section


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
        Why the solver stopped, or why there is no life; empty if nothing failed.
    stress : tuple of two Extremes or None
        The largest stresses in body a and in one cross-section of it.
    strengths : tuple of Strength
        Whether body a, and body b if anything is known of it, bears the stress; empty without stress.
    lives : Assessment or None
        How long both bodies last.
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
        """Whether it bears its load."""
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
        The loaded bearing; None if no balance was found.
    complaint : str
        Why there is no solution; empty if there is one.
    life : BearingLife or None
        How long it lasts; None if it is not rated, or if nobody asked.
    reason : str
        Why it is not rated.
    slices : BearingSolution or None
        The same by slices, if a comparison was asked for.
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
        """Whether it bears its load."""
        if self.solution is None:
            return None
        return self.case.verdict(self.solution, self.life)

    @property
    def warnings(self) -> tuple[str, ...]:
        """All warnings, without repeats."""
        clearance = self.case.operating_clearance
        found = () if self.solution is None else sentences(collect_findings(self.solution, self.life, clearance))
        return tuple(dict.fromkeys((*self.case.notes, *found)))


Results = CaseResults | BearingResults


def of_one_kind(cases: Sequence[Case | BearingCase]) -> Sequence[Case | BearingCase]:
    """Return the cases, which must be all of one kind.

    Raises
    ------
    InputError
        If there are contacts and bearings.
    """
    first = {case.kind: case.path for case in reversed(cases)}
    if len(first) > 1:
        both = f"{first['case']} and {first['bearing']}"
        remedy = "make a report of each kind, with 'nonhertz report' twice"
        raise InputError("cases", both, "be all case files or all bearing files", remedy)
    return cases


def settled(cases: Sequence[Case | BearingCase], announce: Announce = in_silence) -> tuple[Results, ...]:
    """Return the solutions of all cases, or of all bearings; ``announce`` is called with the label of each.

    Raises
    ------
    CaseError
        If the solver rejects any case, with every mistake; with several cases each is prefixed by its file's name.
    InputError
        If a case made in Python has something no case file can hold, which a report shows, or there are cases of both
        kinds; before anything is solved.
    """
    for case in of_one_kind(cases):
        _ = case.document
    each = list(zip(cases, labels(cases), strict=True))
    return tuple(of_each(each, lambda one: one[0].file_name, lambda one: _solved(*one, announce)))


def of_each(given: Sequence[Given], name: Callable[[Given], str | Path], make: Callable[[Given], Made]) -> list[Made]:
    """Return what is made of each.

    Raises
    ------
    CaseError
        With every mistake; with several, each is prefixed by the name of what it is in.
    """
    made: list[Made] = []
    mistakes: list[str] = []
    places: list[str] = []
    for each in given:
        try:
            with name_file_in_errors(name(each)) if len(given) > 1 else contextlib.nullcontext():
                made.append(make(each))
        except CaseError as error:
            mistakes += error.mistakes
            places += error.places
    if mistakes:
        raise CaseError(mistakes, places)
    return made


def _solved(case: Case | BearingCase, label: str, announce: Announce) -> Results:
    announce(label)
    if isinstance(case, Case):
        return CaseResults(case, label, *attempted(case))
    with without_accuracy_warnings():
        try:
            return BearingResults(case, label, case.solve())
        except ConvergenceError as error:
            return BearingResults(case, label, None, str(error))
        except InputError as error:  # of a contact, when its pressure is solved
            raise with_file_path(error, document=case.document) from None


def examined(
    found: Sequence[Results],
    *,
    life: bool | None = None,
    stress: bool = True,
    compare: bool = False,
    announce: Announce = in_silence,
) -> tuple[Results, ...]:
    """Return results with all that follows from the solutions, where requested and the case has converged.

    Parameters
    ----------
    found : sequence of CaseResults or of BearingResults
        What `settled` returned.
    life : bool or None
        Whether to assess lives; None for only those cases that mention life, and for all bearings.
    stress : bool
        Whether to search for the largest stresses below the surface; bearings have none.
    compare : bool
        Whether to solve bearings by slices as well.
    announce : callable
        Called with the name of each step as it begins; `steps` returns how often.
    """
    living = [each for each in found if isinstance(each, CaseResults) and _wants_life(each, life)]
    # By the models of the first case, so that lives can be compared.
    models, notes = models_for(living[0].case, (), [each.case for each in living]) if living else ((), ())

    def after(each: Results) -> Results:
        if each.complaint or each.solution is None:
            return each
        if isinstance(each, BearingResults):
            return _rated(each, life is not False, compare)
        if stress:
            largest = largest_stresses(each.solution, announce=announce)
            each = replace(each, stress=largest, strengths=strengths(each.solution, largest[0], announce))
        if not _wants_life(each, life):
            return each
        try:
            return replace(each, lives=assessed(each.case, spectrum_solved(each.case), models, notes, announce))
        except ConvergenceError as error:
            return replace(each, complaint=str(error))

    return tuple(of_each(found, lambda each: each.case.file_name, after))


def steps(found: Sequence[Results], *, life: bool | None = None, stress: bool = True) -> int:
    """Return how many steps `examined` will announce."""
    contacts = [each for each in found if isinstance(each, CaseResults)]
    searches = sum(
        STRESS_STEPS + bears_something(each.solution.contact.b) for each in contacts if stress and not each.complaint
    )
    return searches + sum(each.case.life.steps for each in contacts if _wants_life(each, life))


def _rated(found: BearingResults, rated: bool, compare: bool) -> BearingResults:
    """Return a bearing with its rating, and by slices."""
    assert found.solution is not None
    with without_accuracy_warnings():
        life, reason = found.case.rated(found.solution) if rated else (None, "")
        try:
            slices = found.case.solve("slices") if compare and found.solution.method == "strips" else None
        except ConvergenceError as error:
            return BearingResults(found.case, found.label, None, str(error))
    return replace(found, life=life, reason=reason, slices=slices)


def _wants_life(found: CaseResults, life: bool | None) -> bool:
    says_of_life = found.case.life != Life()
    return not found.complaint and (says_of_life if life is None else life)


def labels(cases: Sequence[Case | BearingCase]) -> list[str]:
    """Return the label of each case in tables and legends: its file's name, with its path or a number if ambiguous."""
    names = [Path(case.file_name).stem for case in cases]
    if len(set(names)) < len(names):
        names = [printable_name(str(case.path.with_suffix(""))) for case in cases]
    if len(set(names)) < len(names):
        names = [f"{name} ({number})" for number, name in enumerate(names, start=1)]
    return names
