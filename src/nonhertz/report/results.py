"""Results of the cases in a report: solutions, then stress below the surface and life."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeVar

from nonhertz.errors import CaseError, ConvergenceError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.held import named
from nonhertz.files.lives import Assessment
from nonhertz.files.sections import Life
from nonhertz.files.stresses import all_findings
from nonhertz.findings import sentences
from nonhertz.inputs.files import legible
from nonhertz.result.solution import Solution
from nonhertz.show.analysis import (
    Announce,
    assessed,
    attempted,
    bears_something,
    in_silence,
    largest_stresses,
    models_for,
    spectrum_solved,
    strengths,
)
from nonhertz.strength import Strength
from nonhertz.subsurface import Extremes

Given = TypeVar("Given", Case, BearingCase)
Found = TypeVar("Found")
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
    def warnings(self) -> tuple[str, ...]:
        """All warnings, without repeats."""
        of_lives = self.lives.warnings if self.lives else ()
        of_stress = sentences(all_findings(self.solution, *(self.stress or ())))
        return tuple(dict.fromkeys((*self.case.notes, *of_stress, *of_lives)))


def settled(cases: Sequence[Case]) -> tuple[CaseResults, ...]:
    """Return the solutions of all cases; raise what `of_each` does."""
    return of_each(cases, lambda case, label: CaseResults(case, label, *attempted(case)))


def of_each(cases: Sequence[Given], settle: Callable[[Given, str], Found]) -> tuple[Found, ...]:
    """Return what ``settle`` makes of each case and its label.

    Raises
    ------
    CaseError
        If the solver rejects any case, with every mistake; with several cases each is prefixed by its file's name.
    InputError
        If a case made in Python has something no case file can hold, which a report shows; before anything is solved.
    """
    for case in cases:
        _ = case.document
    found: list[Found] = []
    mistakes: list[str] = []
    places: list[str] = []
    for case, label in zip(cases, labels(cases), strict=True):
        try:
            with named(case.file_name) if len(cases) > 1 else contextlib.nullcontext():
                found.append(settle(case, label))
        except CaseError as error:
            mistakes += error.mistakes
            places += error.places
    if mistakes:
        raise CaseError(mistakes, places)
    return tuple(found)


def examined(
    found: Sequence[CaseResults], *, life: bool | None = None, stress: bool = True, announce: Announce = in_silence
) -> tuple[CaseResults, ...]:
    """Return the results with stress below the surface and life, where requested and the case has converged.

    Parameters
    ----------
    found : sequence of CaseResults
        What `settled` returned.
    life : bool or None
        Whether to assess lives; None for only those cases that mention life.
    stress : bool
        Whether to search for the largest stresses.
    announce : callable
        Called with the name of each step as it begins; `steps` returns how often.
    """
    found = [_stressed(each, announce) if stress else each for each in found]
    living = [each for each in found if _wants_life(each, life)]
    with_lives = iter(_assessed(living, announce))
    return tuple(next(with_lives) if each in living else each for each in found)


def steps(found: Sequence[CaseResults], *, life: bool | None = None, stress: bool = True) -> int:
    """Return how many steps `examined` will announce."""
    searches = sum(
        STRESS_STEPS + bears_something(each.solution.contact.b) for each in found if stress and not each.complaint
    )
    return searches + sum(each.case.life.steps for each in found if _wants_life(each, life))


def _stressed(found: CaseResults, announce: Announce) -> CaseResults:
    if found.complaint:
        return found
    stress = largest_stresses(found.solution, announce=announce)
    return replace(found, stress=stress, strengths=strengths(found.solution, stress[0], announce))


def _wants_life(found: CaseResults, life: bool | None) -> bool:
    says_of_life = found.case.life != Life()
    return not found.complaint and (says_of_life if life is None else life)


def _assessed(found: Sequence[CaseResults], announce: Announce) -> list[CaseResults]:
    """Return results with lives, all by the models of the first case, so that they can be compared."""
    if not found:
        return []
    cases = [each.case for each in found]
    models, notes = models_for(cases[0], (), cases[1:])
    results = []
    for each, case in zip(found, cases, strict=True):
        try:
            with named(case.file_name) if len(found) > 1 else contextlib.nullcontext():
                lives = assessed(case, spectrum_solved(case), models, notes, announce)
            results.append(replace(each, lives=lives))
        except ConvergenceError as error:
            results.append(replace(each, complaint=str(error)))
    return results


def labels(cases: Sequence[Case | BearingCase]) -> list[str]:
    """Return the label of each case in tables and legends: its file's name, with its path or a number if ambiguous."""
    names = [Path(case.file_name).stem for case in cases]
    if len(set(names)) < len(names):
        names = [legible(str(case.path.with_suffix(""))) for case in cases]
    if len(set(names)) < len(names):
        names = [f"{name} ({number})" for number, name in enumerate(names, start=1)]
    return names
