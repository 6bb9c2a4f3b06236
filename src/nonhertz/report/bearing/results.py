"""Results of the bearings in a report: motions and loads, life, and the same by slices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase, placed
from nonhertz.findings import Finding, sentences
from nonhertz.report.results import of_each
from nonhertz.show.analysis import Announce, in_silence


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
    strained : tuple of Finding
        What strains the model.
    slices : BearingSolution or None
        The same by slices, if a comparison was asked for.
    """

    case: BearingCase
    label: str
    solution: BearingSolution | None
    complaint: str = ""
    life: BearingLife | None = None
    reason: str = ""
    strained: tuple[Finding, ...] = ()
    slices: BearingSolution | None = None

    @property
    def speed(self) -> float | None:
        """The speed that turns life into hours [1/min]; None without one, and of a spectrum."""
        return None if self.case.spectrum else self.case.prescribed.get("speed")

    @property
    def warnings(self) -> tuple[str, ...]:
        """All warnings, without repeats."""
        return tuple(dict.fromkeys((*self.case.notes, *sentences(self.strained))))


def settled_bearings(
    cases: Sequence[BearingCase],
    *,
    life: bool | None = None,
    compare: bool = False,
    announce: Announce = in_silence,
) -> tuple[BearingResults, ...]:
    """Return the results of all bearings.

    Parameters
    ----------
    cases : sequence of BearingCase
        The bearings.
    life : bool or None
        Whether to rate them, which costs nothing; only False leaves it out.
    compare : bool
        Whether to solve them by slices as well.
    announce : callable
        Called with the label of each bearing as it begins.

    Raises
    ------
    CaseError, InputError
        As `nonhertz.report.results.of_each`.
    """

    def settle(case: BearingCase, label: str) -> BearingResults:
        announce(label)
        return _settled(case, label, life is not False, compare)

    return of_each(cases, settle)


def _settled(case: BearingCase, label: str, life: bool, compare: bool) -> BearingResults:
    with without_accuracy_warnings():
        try:
            solution = case.solve()
            slices = case.solve("slices") if compare and solution.method == "strips" else None
            rating, reason = case.rated(solution) if life else (None, "")
            strained = solution.findings
        except ConvergenceError as error:
            return BearingResults(case, label, None, str(error))
        except InputError as error:  # of a contact, when its pressure is solved
            raise placed(error) from None
    return BearingResults(case, label, solution, "", rating, reason, strained, slices)
