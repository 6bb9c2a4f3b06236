"""Strength of the bodies of a solved contact: yielding, hardened cases, static safety.

`assess` compares a solution with the strength of a body's material (`nonhertz.Material`): the maximum pressure with its
limit; the largest equivalent stress below the surface with the yield strength, in a hardened case and in the core below
it; and the depth of the case with the depths of the largest shear stresses. Each comparison is one `Check` with one
sentence, which also says if a strength is not known or the stress is singular. `judge` answers the same questions
without the search of the stress field, which takes seconds, wherever the pressure is far enough from that at which
Hertzian contacts begin to yield.

The solution is elastic, without friction and residual stress: a ratio above 1 says that yielding begins, not how far it
goes, and compressive residual stress in a case is not counted.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TYPE_CHECKING, Any, Final, Unpack

import numpy as np

from nonhertz.amounts import format_digits, format_input, mm, mpa
from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.hertz.onset import DEPTHS, onset_of_yield, von_mises_on_axis
from nonhertz.inputs.checks import one_of
from nonhertz.lazy import dir_of
from nonhertz.model.body import Body, BodyName
from nonhertz.model.materials import name_of
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.edges import EdgeKind
from nonhertz.result.ends import ends_in_words, outermost
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solution import Solution
from nonhertz.result.solved import Solved

if TYPE_CHECKING:
    from nonhertz.subsurface import Extreme, Extremes
    from nonhertz.subsurface.evaluation import Within

__all__ = ["CRITERIA", "Check", "CheckStatus", "Strength", "assess", "judge", "onset_of_yield"]
__dir__ = dir_of(__name__)

#: Criteria of yielding, with the names of their equivalent stresses.
CRITERIA: Final = {"von-mises": "von Mises stress", "tresca": "Tresca stress (twice the maximum shear stress)"}

EQUAL = 1e-6  # relative: half-widths that differ by less count as equal
#: The field is not searched where the pressure and the onset of yield of a Hertzian contact differ by this factor.
CLEAR: Final = 1.1
_DEEPEST_SHEAR: Final = 0.786  # half-widths below a line contact: the maximum shear stress; Johnson 1985, section 4.2


class CheckStatus(StrEnum):
    """Outcome of a comparison."""

    FINE = "fine"
    OVER = "over"
    UNKNOWN = "not known"


@dataclass(frozen=True, repr=False)
class Check(ReadOnly):
    """A stress or pressure compared with the strength of the material.

    Attributes
    ----------
    name : str
        ``"pressure"``, ``"yield"``, ``"bore"``, ``"core"`` or ``"case depth"``.
    verdict : Verdict
        Whether the strength of the material is exceeded.
    ratio : float
        Stress over strength [-], above 1 where the strength is exceeded; NaN where it is not known.
    finding : Finding
        The comparison in one sentence, with its numbers.
    unasked : bool
        Whether the outcome is not known because the material lacks the strength to compare with.
    """

    name: str
    verdict: CheckStatus
    ratio: float
    finding: Finding
    unasked: bool = False

    @property
    def sentence(self) -> str:
        """The comparison in one sentence."""
        return str(self.finding)


@dataclass(frozen=True, repr=False)
class Strength(HasFindings, ReadOnly, HasHtml):
    """Whether the strength of one body of a contact is exceeded.

    Attributes
    ----------
    body : {"a", "b"}
        Which body.
    criterion : str
        The criterion of yielding, a key of `CRITERIA`.
    checks : tuple of Check
        Pressure and yielding; for a hollow roller also the bore, for a case-hardened body the core and the depth of the
        case.
    largest : Extremes
        The largest stresses in the body, with their positions.
    core : Extremes or None
        The largest stresses below the case; None without a case.
    findings : tuple of Finding
        Limitations, such as places left out of the search for the largest stresses.
    """

    body: BodyName
    criterion: str
    checks: tuple[Check, ...]
    largest: Extremes
    core: Extremes | None
    findings: tuple[Finding, ...]

    def __repr__(self) -> str:
        return plain_text("Strength", [f"body {self.body}, {CRITERIA[self.criterion]}", *self.sentences])

    @property
    def sentences(self) -> tuple[str, ...]:
        """One sentence for each check."""
        return tuple(check.sentence for check in self.checks)

    @property
    def static_safety(self) -> float:
        """S_0 = (limit of pressure / maximum pressure)^2 [-], as for a line contact; NaN where it is not known."""
        return 1.0 / self._ratio("pressure") ** 2

    @property
    def yield_ratio(self) -> float:
        """Largest equivalent stress over the yield strength [-], in the case of a hardened body; NaN if not known."""
        return self._ratio("yield")

    @property
    def core_yield_ratio(self) -> float:
        """Largest equivalent stress below the case over the yield strength of the core [-]; NaN if not known."""
        return self._ratio("core")

    @property
    def verdict(self) -> CheckStatus:
        """The worst of the checks: over, else not known, else fine."""
        verdicts = {check.verdict for check in self.checks}
        return next(level for level in (CheckStatus.OVER, CheckStatus.UNKNOWN, CheckStatus.FINE) if level in verdicts)

    def _ratio(self, name: str) -> float:
        return next((check.ratio for check in self.checks if check.name == name), math.nan)


def assess(
    solution: Solved, *, criterion: str = "von-mises", largest: Extremes | None = None, **options: Unpack[Within]
) -> Strength:
    """Return whether the strength of one body of a solved contact is exceeded.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact, with the strength of its materials.
    criterion : str
        ``"von-mises"``, or ``"tresca"``, which predicts yielding at the same or a smaller load.
    largest : Extremes, optional
        The largest stresses of the body from `nonhertz.subsurface.extremes`, if already computed; searched otherwise.
    **options
        ``body``, ``threads`` and ``callback`` as in `nonhertz.subsurface.stress`.

    Returns
    -------
    Strength

    Raises
    ------
    InputError
        If nothing is in contact, the criterion is unknown, or ``largest`` is of the other body.

    Notes
    -----
    The static safety of ISO 76 is a ratio of loads. Under Hertz's line contact the load grows with the square of the
    pressure, hence the square here; in a point contact it grows with the cube, and at an end or under a tilt by no
    power at all: `nonhertz.bearing.pressure_safety` solves for the load.

    Yielding begins where the equivalent stress reaches the yield strength Y: in Hertz's line contact at a
    pressure of 1.67 Y by Tresca and 1.79 Y by von Mises [1]_. A hardened body has the yield strength of its case down
    to ``case_depth`` and that of its core below: a step, where hardness falls gradually. The case has to reach below
    the largest shear stresses of the whole body and of the cross-section where the contact is widest, where they lie
    deepest.

    References
    ----------
    .. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, section 6.1, for nu = 0.3.

    Examples
    --------
    >>> import nonhertz as nh
    >>> steel = nh.Material(207000, 0.3, yield_strength=1500, pressure_limit=4000)
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000), material=steel)
    >>> found = assess(nh.solve(nh.Contact(roller, nh.Plate()), load=6e3))
    >>> round(found.static_safety, 2)
    7.02
    >>> found.yield_ratio < 1.0
    True
    """
    # Imported here: most contacts are judged without a search.
    from nonhertz.subsurface import Extremes, extremes
    from nonhertz.subsurface.evaluation import Within, refuse_options
    from nonhertz.subsurface.inside import Inside, check_solution

    refuse_options("assess", options, Within)
    check_solution(solution)
    one_of("criterion", criterion, tuple(CRITERIA), "choose how the material yields")
    name = options.get("body", "a")
    if largest is None:
        largest = extremes(solution, **options)
    elif not isinstance(largest, Extremes) or largest.body != name:
        remedy = "leave it out, or give what nonhertz.subsurface.extremes returns for this body"
        raise InputError("largest", largest, f"be the largest stresses of body {name}", remedy)
    body = solution.contact.bodies[name]
    inside = Inside.of(solution, name)
    case, core, below_contact = largest, None, []
    if body.case_depth is not None:
        options.pop("callback", None)
        at = (largest.von_mises.z, largest.shear.z)
        # The largest value of the whole body is also the largest of the part that it lies in.
        case = largest if max(at) <= body.case_depth else extremes(solution, depths=(0.0, body.case_depth), **options)
        below = (body.case_depth, math.inf)
        core = largest if min(at) >= body.case_depth else None
        if core is None and body.case_depth < inside.extent.thickness(solution.y).max():
            core = extremes(solution, depths=below, **options)
        # Not at a bore: the case of the surface does not reach it.
        half = (0.0, 0.5 * float(inside.extent.thickness(solution.y).min()))
        below_contact.append(extremes(solution, depths=half, **options) if largest.shear.at_bore else largest)
        # A narrow peak of pressure has its largest stress near the surface; below a wide contact it is deepest.
        below_contact.append(extremes(solution, _widest(solution), depths=half, **options))
    question = _BodyCheck(f"body {name}", body, criterion, _Limit.of(solution), bool(inside.findings))
    checks = (
        question.pressure(solution.max_pressure),
        question.yields(case),
        *question.of_bore(largest.bore),
        *question.of_core(core),
        *question.of_case(below_contact),
    )
    return Strength(name, criterion, checks, largest, core, largest.findings)


@functools.lru_cache(maxsize=64)
def judge(
    solution: Solution, *, body: BodyName, search: bool = True, called: str = "", where: str = ""
) -> tuple[Check, ...]:
    """Return the checks of `assess` that the material allows, from the maximum pressure alone where that decides.

    Parameters
    ----------
    solution : Solution
        A solved contact with something in contact.
    body : {"a", "b"}
        Which body.
    search : bool
        Whether the stress below the surface is searched where the pressure does not decide, which takes seconds; the
        question is left open otherwise.
    called, where : str
        For a contact in a bearing, the name of the body in sentences, such as ``"the inner ring"``, and the place of
        the pressure; by default ``"body a"`` and none.

    Returns
    -------
    tuple of Check
        Empty where no strength of the body is known.

    Notes
    -----
    The criterion is von Mises. The largest von Mises stress of any contact lies between those of a circular and of a
    line contact at the same pressure: a body does not yield below the pressure at which a point contact begins to
    yield, and yields above that of a line contact, see `onset_of_yield`, both with a margin of 10 %. A case and the
    core below it are judged in the same way by Hertz's line contact, whose stress reaches deepest. Bodies with a bore,
    and contacts whose pressure does not fall to zero at their ends, have other stresses, which are searched.
    """
    part = solution.contact.bodies[body]
    question = _BodyCheck(called or f"body {body}", part, "von-mises", _Limit.of(solution), stepped=False, where=where)
    pressure = () if part.material.pressure_limit is None else (question.pressure(solution.max_pressure),)
    if part.material.yield_strength is None and part.case_depth is None:
        return pressure
    by_pressure = tuple(question.without_search(solution))
    if all(check.verdict is not CheckStatus.UNKNOWN for check in by_pressure) or not search:
        return (*pressure, *by_pressure)
    checks = assess(solution, body=body).checks
    return tuple(check for check in checks if check.name != "pressure" or pressure)


@dataclass(frozen=True)
class _Limit:
    """Whether pressure and stress are bounded everywhere.

    Attributes
    ----------
    towards : Finding or None
        The places at which they are singular.
    away : bool
        Whether the largest values reported lie more than a half-width away from these places: refinement does not
        change them, so a strength that they exceed is exceeded.
    """

    towards: Finding | None
    away: bool

    @classmethod
    def of(cls, solution: Solved) -> _Limit:
        """Return the limit of a solution."""
        places = {"ends": ends_in_words(solution.singular_ends)} if solution.singular_ends else {}
        if solution.peaks_at_corner:
            corner = "the corner of the profile at y = {y:.5g}"
            places["corner"] = finding("corner", corner, y=mm(solution.max_pressure_y))
        towards = finding("ends", " and ".join(f"{{{name}}}" for name in places), **places) if places else None
        away = not solution.peaks_at_corner
        if solution.singular_ends:
            from nonhertz.subsurface.search import clear_of_ends  # here, as in `assess`

            away = away and clear_of_ends(solution)
        return cls(towards, away)

    def __bool__(self) -> bool:
        return self.towards is None


@dataclass(frozen=True)
class _BodyCheck:
    """The checks of one body."""

    name: str
    body: Body
    criterion: str
    limit: _Limit
    stepped: bool
    where: str = ""

    def pressure(self, largest: float) -> Check:
        """Return the check of the maximum pressure [MPa]."""
        allowed = self.body.material.pressure_limit
        if allowed is None:
            words = f"Static safety is not known: the material of {self.name} has no pressure limit."
            return _not_known("pressure", words, unasked=True)
        ratio = largest / allowed
        # A bearing has an S0 of its own, C0 / P0.
        safety = "" if self.where else f"static safety S0 = {format_digits(ratio**-2.0, 3)} as for a line contact"
        limit = f"the limit of {name_of(self.body.material) or self.name}, {{allowed:g}},"
        if self.limit:
            what = f"The maximum pressure of {{pressure}}{self.where}"
            return _compare("pressure", ratio, what, allowed, limit, safety, pressure=mpa(largest))
        towards = "he pressure grows without limit towards {ends}"
        if ratio <= 1.0 or not self.limit.away:
            return _not_known("pressure", f"Static safety is not known: t{towards}.", ends=self.limit.towards)
        numbers = {"ends": self.limit.towards, "pressure": mpa(largest)}
        what = f"T{towards}; more than a half-width away {{pressure}}"
        return _compare("pressure", ratio, what, allowed, limit, safety, **numbers)

    def without_search(self, solution: Solution) -> Iterator[Check]:
        """Yield the checks of yielding and the case by the maximum pressure: not known where only a search can tell."""
        material, depth = self.body.material, self.body.case_depth
        pressure, wide = solution.max_pressure, solution.max_half_width
        usual = self.body.bore is None and all(end.kind is EdgeKind.RUN_OUT for end in solution.edge_pressure)
        if material.yield_strength is not None:
            yield self._onset(solution, material.yield_strength, usual)
        if depth is None:
            return
        core = material.core_yield_strength
        below = np.minimum(depth / wide, 10.0) <= DEPTHS
        stress = CLEAR * pressure * von_mises_on_axis(material.poisson)[1][below].max()
        if not (usual and (core is None or stress <= core) and CLEAR * _DEEPEST_SHEAR * wide <= depth):
            yield _not_known("core", f"Whether the case or core of {self.name} yields can only be decided by a search.")
            return
        if core is not None:
            words = f"The core of {self.name} does not yield: its stress is at most {{stress:3}}, below {{core:g}}."
            yield _judged("core", stress / core, words, stress=mpa(stress), core=mpa(core))
        words = f"The case of {self.name}, {{depth:g}} deep, reaches below the largest shear stresses."
        yield _judged("case depth", _DEEPEST_SHEAR * wide / depth, words, depth=mm(depth))

    def _onset(self, solution: Solution, strength: float, usual: bool) -> Check:
        """Return the check of yielding by the pressures at which Hertz's contacts begin to yield."""
        pressure, what = solution.max_pressure, f"{'the case of ' * (self.body.case_depth is not None)}{self.name}"
        point, line = onset_of_yield(self.body.material.poisson)
        if self.body.bore is None and not solution.peaks_at_corner and pressure >= CLEAR * (line * strength):
            kind, factor, answer, beside = "line", line, "yields", "exceeds"
        elif usual and CLEAR * pressure <= point * strength:
            kind, factor, answer, beside = "point", point, "does not yield", "is below"
        else:
            return _not_known("yield", f"Whether {what} yields can only be decided by a search for its largest stress.")
        words = f"{_capitalise(what)} {answer}: the maximum pressure of {{pressure}} {beside} {{onset:4}}, "
        words += f"{factor:.3g} times its yield strength, at which a {kind} contact begins to yield."
        onset = factor * strength
        return _judged("yield", pressure / onset, words, onset=mpa(onset), pressure=mpa(pressure))

    def yields(self, case: Extremes) -> Check:
        """Return the check of the yield strength, of a hardened body in its case."""
        hardened = self.body.case_depth is not None
        what = f"the case of {self.name}" if hardened else self.name
        return self._against("yield", what, self._equivalent(case), "yield_strength")

    def of_bore(self, bore: Extreme | None) -> Iterator[Check]:
        """Yield the check of the bore, which no case of the surface reaches, by von Mises stress."""
        strength = "yield_strength" if self.body.case_depth is None else "core_yield_strength"
        if bore is not None and getattr(self.body.material, strength) is not None:
            where = replace(self, criterion="von-mises", limit=_Limit(None, away=True))
            yield where._against("bore", f"the bore of {self.name}", bore, strength)

    def of_core(self, core: Extremes | None) -> Iterator[Check]:
        """Yield the check of the core, if the body or its material has one."""
        what = f"the core of {self.name}"
        if core is not None:
            yield self._against("core", what, self._equivalent(core), "core_yield_strength")
        elif self.body.material.core_yield_strength is not None and self.body.case_depth is None:
            yield _not_known("core", f"Whether {what} yields is not known: the body has no case depth.", unasked=True)

    def of_case(self, largest: list[Extremes]) -> Iterator[Check]:
        """Yield the check of the case depth, if there is a case: it must reach below the largest shear stresses."""
        name, depth, case = "case depth", self.body.case_depth, f"the case of {self.name}"
        if depth is None:
            return
        if not self.limit:
            words = f"Whether {case} is deep enough is not known: the stress grows without limit towards {{ends}}."
            yield _not_known(name, words, ends=self.limit.towards)
            return
        shear = max(extremes.shear.z for extremes in largest)
        orthogonal = max(extremes.orthogonal_shear.z for extremes in largest)
        ratio = max(shear, orthogonal) / depth
        enough = "reaches below" if ratio <= 1.0 else "does not reach below"
        words = (
            f"{_capitalise(case)}, {{depth:g}} deep, {enough} the largest maximum shear stress, at z = {{shear:3}} or "
            "less, and the largest orthogonal one, at z = {orthogonal:3} or less."
        )
        numbers = {"depth": mm(depth), "shear": mm(shear), "orthogonal": mm(orthogonal)}
        yield _judged(name, ratio, words, **numbers)

    def _equivalent(self, extremes: Extremes) -> Extreme:
        if self.criterion == "von-mises":
            return extremes.von_mises
        shear = extremes.shear
        return replace(shear, max=2.0 * shear.max)

    def _against(self, name: str, what: str, extreme: Extreme, strength: str) -> Check:
        """Return the check of an equivalent stress with a strength of the material."""
        allowed = getattr(self.body.material, strength)
        open_question = f"Whether {what} yields is not known"
        stress = CRITERIA[self.criterion]
        found_there = f"{{stress}} {extreme.site}y = {{y:3}} and z = {{z:3}}"
        numbers: dict[str, Any] = {"ends": self.limit.towards, "stress": mpa(extreme.max)}
        numbers |= {"y": mm(extreme.y), "z": mm(extreme.z)}
        towards = "the stress grows without limit towards {ends}"
        if allowed is None:
            known = f"; its largest {stress} is {found_there}" if self.limit else ""
            return _not_known(
                name,
                f"{open_question}: the material has no {strength.replace('_', ' ')}{known}.",
                unasked=True,
                **numbers,
            )
        ratio = extreme.max / allowed
        if self.stepped and ratio <= 1.0:
            return _not_known(name, f"{open_question}: bending of the wall between steps of its bore is not computed.")
        if self.limit:
            answer = "does not yield" if ratio <= 1.0 else "yields"
            words = f"{_capitalise(what)} {answer}: its largest {stress}, {found_there},"
            return _compare(name, ratio, words, allowed, "the yield strength of {allowed:g}", **numbers)
        if ratio <= 1.0 or not self.limit.away:
            return _not_known(name, f"{open_question}: {towards}.", **numbers)
        words = (
            f"{_capitalise(what)} yields: {towards}; more than a half-width away the largest {stress}, {found_there},"
        )
        return _compare(name, ratio, words, allowed, "the yield strength of {allowed:g}", **numbers)


def _compare(name: str, ratio: float, what: str, allowed: float, noun: str, then: str = "", /, **numbers: Any) -> Check:
    percent = format_input(100.0 * (ratio if ratio <= 1.0 else ratio - 1.0), 3)
    compared = f"is {percent} % of {noun.rstrip(',')}" if ratio <= 1.0 else f"exceeds {noun} by {percent} %"
    words = f"{what} {compared}{f': {then}' if then else ''}."
    return _judged(name, ratio, words, allowed=mpa(allowed), **numbers)


def _judged(name: str, ratio: float, words: str, /, **numbers: Any) -> Check:
    return Check(name, CheckStatus.FINE if ratio <= 1.0 else CheckStatus.OVER, ratio, finding(name, words, **numbers))


def _widest(solution: Solved) -> float:
    """Return the place along y where the contact is widest; of several the one nearest to the middle."""
    width = solution.extent_across[1]
    places = solution.y[width >= (1.0 - EQUAL) * width.max()]
    return float(places[np.abs(places - 0.5 * np.sum(outermost(solution))).argmin()])


def _not_known(name: str, words: str, /, *, unasked: bool = False, **numbers: Any) -> Check:
    return Check(name, CheckStatus.UNKNOWN, math.nan, finding(name, words, **numbers), unasked)


def _capitalise(text: str) -> str:
    return text[:1].upper() + text[1:]
