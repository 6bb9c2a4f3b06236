"""Verdict on a contact, a bearing or several of them under load: one word, and the finding that decides it.

Each body is judged by the known limits of its material: pressure limit and yield strength. Where neither is known,
no limit is reported as met.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import describe_load, mpa
from nonhertz.bearing.section import RINGS
from nonhertz.errors import join_words
from nonhertz.findings import Finding, finding
from nonhertz.model.body import BODIES
from nonhertz.model.material import STEEL, Material
from nonhertz.model.materials import name_of
from nonhertz.result.ends import ends_in_words
from nonhertz.result.solution import Solution
from nonhertz.strength import Check, CheckStatus, Strength, judge

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.bearing.film import Films
    from nonhertz.bearing.limits import Limit
    from nonhertz.bearing.operating import OperatingClearance
    from nonhertz.bearing.roller_bearing import RollerBearing
    from nonhertz.bearing.solution import BearingSolution

#: Words for a check that is passed.
_PASSED: Final = {
    "pressure": "static pressure below its limit",
    **dict.fromkeys(("yield", "bore", "core"), "no yielding"),
    "case depth": "case deep enough",
    "static-safety": "static safety S0 of at least 1",
    "life": "life as required",
    "film": "lambda of at least 1",
    "rib-limit": "axial load as permitted",
}
_PARTS: Final = {"roller": "the roller", **{ring: f"the {ring} ring" for ring in RINGS}}
#: Findings on ends and corners have a line of their own; all other findings strain the model.
_OF_ENDS: Final = ("sharp-end", "corner-end", "corner-peak")
_MOST_MATERIALS: Final = 12  # in one study; the worst row of each is solved once more


class Level(Enum):
    """Outcome of a verdict, from the best to the worst."""

    MET = "below limits"
    STRAINED = "model strained"
    NOT_JUDGED = "not judged"
    UNLIMITED = "pressure unbounded"
    NOT_MET = "limits not met"

    @property
    def rank(self) -> int:
        """Rank of the level: the larger, the worse."""
        return list(Level).index(self)


_OF_LIMIT: Final = {True: Level.MET, None: Level.NOT_JUDGED, False: Level.NOT_MET}


@dataclass(frozen=True)
class Verdict:
    """Whether limits are met.

    Attributes
    ----------
    level : Level
        The worst level of its findings.
    findings : tuple of Finding
        The findings that decide it, the worst first.
    where : str
        Which of several it is about, such as ``"under 20 kN"``; empty if there is only one.
    severity : tuple of two float
        The largest ratio of stress to strength [-] and the maximum pressure [MPa]; verdicts of equal level are ordered
        by them.
    """

    level: Level
    findings: tuple[Finding, ...]
    where: str = ""
    severity: tuple[float, float] = (0.0, 0.0)

    @property
    def words(self) -> str:
        """The level in words; where no limit is exceeded, the checks that were passed."""
        passed = dict.fromkeys(_PASSED[finding.kind] for finding in self.findings if finding.kind in _PASSED)
        ends = ", ".join(passed) if self.level is Level.MET else self.level.value
        among = ("; worst " if self.level is Level.MET else " ") if self.where else ""
        return f"{ends[:1].upper()}{ends[1:]}{among}{self.where}."

    @property
    def sentence(self) -> str:
        """The first finding that decides it, as a sentence."""
        return str(self.findings[0]) if self.findings else ""

    def as_object(self) -> dict[str, Any]:
        """Return the verdict for JSON."""
        return {
            "level": self.level.name.lower().replace("_", "-"),
            **({"where": self.where} if self.where else {}),
            "findings": [item.as_object() for item in self.findings],
        }


def verdict_to_object(verdict: Verdict | None) -> dict[str, Any] | None:
    """Return a verdict, if there is one, as files store it."""
    return None if verdict is None else verdict.as_object()


def judge_contact(solution: Solution, strengths: Iterable[Strength] = (), *, search: bool = True) -> Verdict | None:
    """Return the verdict on a contact; None where nothing touches.

    Parameters
    ----------
    solution : Solution
        The solved contact.
    strengths : iterable of Strength
        Results of `nonhertz.strength.assess`, if it was called; the other bodies are judged here.
    search : bool
        Whether the stress field is searched, which takes seconds, where the pressure does not decide whether a body
        yields.
    """
    if not solution.contact_y:
        return None
    at_hand = {strength.body: strength.checks for strength in strengths}
    checks = [check for name in BODIES for check in at_hand.get(name) or judge(solution, body=name, search=search)]
    return _make_verdict(
        [
            *_order_checks(checks),
            *_unknown({f"body {name}": body.material for name, body in solution.contact.bodies.items()}),
            *_judge_ends(solution),
            *_list_strains(solution.findings),
        ],
        checks,
        solution.max_pressure,
    )


def judge_loads(solved: Iterable[tuple[Solution, Any]]) -> Verdict | None:
    """Return the worst verdict on a contact under several loads, from pairs of a solution and its share or the like."""
    return worst_verdict(
        {f"under {describe_load(solution.load, solution.tilt)}": judge_contact(solution) for solution, _ in solved}
    )


def add_life(verdict: Verdict | None, life: float | None, required: float | None) -> Verdict | None:
    """Return a verdict that includes whether a life [10^6 revolutions] reaches the required one, if one is required."""
    if verdict is None or required is None:
        return verdict
    return _add_findings(verdict, [_judge_life(life, required)])


def worst_verdict(verdicts: Mapping[str, Verdict | None]) -> Verdict | None:
    """Return the worst of several verdicts, with its name as ``where``; None if there are none.

    Examples
    --------
    >>> strained, met = Verdict(Level.STRAINED, (), "under 5 kN"), Verdict(Level.MET, ())
    >>> worst_verdict({"in a.toml": met, "in b.toml": strained}).words
    'Model strained in b.toml under 5 kN.'
    """
    known = {where: verdict for where, verdict in verdicts.items() if verdict is not None}
    worst = max(known, key=lambda where: (known[where].level.rank, known[where].severity), default=None)
    if worst is None:
        return None
    found_worst = known[worst]
    return replace(found_worst, where=f"{worst} {found_worst.where}".strip()) if len(known) > 1 else found_worst


def judge_rows(
    pressures: ArrayLike,
    judged: Callable[[int], Verdict | None],
    materials: Sequence[Hashable] = (),
    warned: ArrayLike = (),
    what: str = "row",
) -> Verdict | None:
    """Return the verdict on the rows of a study: the verdict on the row with the maximum pressure.

    Parameters
    ----------
    pressures : array_like
        The maximum pressure of each row [MPa], nan where it has failed.
    judged : callable
        Returns the verdict on a row by its number.
    materials : sequence of hashable
        For each row, the values of varied materials, if any are varied: each material has its own limit.
    warned : array_like
        Number of warnings of each row, if known.
    what : str
        Name of a row, such as ``"row"``.
    """
    known = np.asarray(pressures, dtype=float).ravel()
    solved = np.flatnonzero(np.isfinite(known)).tolist()
    largest: dict[Hashable, int] = {}
    for row in sorted(solved, key=known.__getitem__):
        largest[materials[row] if materials else None] = row
    if not largest:
        return None
    if len(largest) > _MOST_MATERIALS:
        words = "The rows have {count} materials: vary no more than {most} for a verdict on all."
        many = finding("many-materials", words, count=len(largest), most=_MOST_MATERIALS)
        return Verdict(Level.NOT_JUDGED, (many,))
    worst = worst_verdict({f"in {what} {row}": judged(row) for row in largest.values()})
    strained = int(np.count_nonzero(np.asarray(warned, dtype=float) > 0.0))
    if worst is None or len(solved) == 1:
        return worst
    findings: list[tuple[Level, Finding]] = []
    if len(largest) == 1:
        worst = replace(worst, where=f"in {what} {largest.popitem()[1]}")
        findings += _count_beyond(known[solved], worst, f"{what}s")
    if strained:
        words = f"{{strained}} of {{rows}} {what}s have warnings: solve one of them to read which."
        findings.append((Level.STRAINED, finding("rows-warned", words, strained=strained, rows=len(solved))))
    return _add_findings(worst, findings)


def _count_beyond(pressures: NDArray[np.float64], worst: Verdict, what: str) -> Iterator[tuple[Level, Finding]]:
    """Yield how many rows exceed the pressure limit that the worst row exceeds."""
    for passed in worst.findings:
        limit = dict(passed.numbers).get("allowed") if passed.kind == "pressure" else None
        if limit is not None and (over := int(np.count_nonzero(pressures > limit.values[0]))):
            words = "{over} of {rows} " + f"{what} exceed{'s' if over == 1 else ''} {{limit:g}}."
            yield Level.NOT_MET, finding("rows-beyond", words, over=over, rows=len(pressures), limit=limit)
            return


def judge_bearing(
    solution: BearingSolution,
    life: BearingLife | None,
    clearance: OperatingClearance | None,
    films: Films | None = None,
    limits: Iterable[Limit] = (),
) -> Verdict | None:
    """Return the verdict on a loaded bearing; None where there is nothing to judge.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    life : BearingLife or None
        Its rating life, if it is rated.
    clearance : OperatingClearance or None
        Its operating clearance, if its fits are known.
    films : Films or None
        Its oil films, if speed and oil are known; judged where the roughness is known too.
    limits : iterable of Limit
        Comparisons with limits that manufacturers publish.
    """
    findings = list(_judge_fits(clearance))
    checks = list(_check_contacts(solution)) if solution.method == "strips" and solution.load.any() else []
    findings += _order_checks(checks)
    findings += [*_judge_rating(life), *_judge_films(films)]
    findings += [(_OF_LIMIT[met], item) for met, item in limits]
    if findings or solution.load.any():
        findings += _unknown(
            {
                f"{name}{of}": getattr(row, part).material
                for of, row, _ in _different_rows(solution)
                for part, name in _PARTS.items()
            }
        )
    if not findings:
        return None
    return _make_verdict([*findings, *_list_strains(collect_findings(solution, life, clearance))], checks)


def collect_findings(
    solution: BearingSolution, life: BearingLife | None, clearance: OperatingClearance | None
) -> tuple[Finding, ...]:
    """Return the findings on a loaded bearing, its life and its operating clearance."""
    beside = (source.findings for source in (life, clearance) if source is not None)
    return (*solution.findings, *(item for source in beside for item in source))


def _judge_rating(life: BearingLife | None) -> Iterator[tuple[Level, Finding]]:
    """Yield the findings on static safety and on rated against required life."""
    if life is None:
        return
    if math.isfinite(life.static_safety):
        enough = life.static_safety >= 1.0
        words = "The static safety S0 is {safety:.3g}" + (", at least 1." if enough else ", below 1.")
        yield _OF_LIMIT[enough], finding("static-safety", words, safety=life.static_safety)
    if life.required is not None:
        yield _judge_life(None if math.isnan(life.rated_life) else life.rated_life, life.required)


def _judge_films(films: Films | None) -> Iterator[tuple[Level, Finding]]:
    """Yield the smallest film parameter against 1, below which the surfaces touch all over (Hamrock 2004, ch. 3).

    That is not a manufacturer's limit: it shortens the life (RBC, Heavy Duty Needle Roller Bearings, section 6.2),
    which ISO 281 counts by kappa, and additives are recommended (SKF 2018, page 102). But film and pressure then
    differ from those of the smooth surfaces that the model assumes.
    """
    at = None if films is None else films.least_parameter
    if films is not None and films.film_parameter is not None and at is not None:
        smallest = float(films.film_parameter[at])
        enough = smallest >= 1.0
        state = "below 1: the film does not part the surfaces, which shortens the life unless additives protect them"
        if enough:
            state = "of at least 3: the film parts them" if smallest >= 3.0 else "between 1 and 3: their peaks touch"
        words = f"The smallest film parameter lambda is {{parameter:.3g}}, {state}."
        yield Level.MET if enough else Level.STRAINED, finding("film", words, parameter=smallest)


def _judge_fits(clearance: OperatingClearance | None) -> Iterator[tuple[Level, Finding]]:
    if clearance is None:
        return
    for ring, fit, seat in (("inner", clearance.inner, "on its shaft"), ("outer", clearance.outer, "in its housing")):
        if fit.loosened:
            words = "The {ring} ring has come loose {seat}: {mounted:4} between them when mounted, none in operation."
            yield Level.NOT_MET, finding("loosened-fit", words, ring=ring, seat=seat, mounted=mpa(fit.mounted_pressure))


def _check_contacts(solution: BearingSolution) -> Iterator[Check]:
    """Yield the checks of the contact with the maximum pressure at each ring of every different row."""
    for of, _, rollers in _different_rows(solution):
        for k, ring in enumerate(RINGS):
            roller = rollers[int(np.argmax(solution.max_pressure[rollers, k]))]
            contact = solution.contact(roller, ring)
            if contact is not None:
                where = f", between {solution.place_of(roller)} and the {ring} ring,"
                for body, part in zip(BODIES, ("roller", ring), strict=True):
                    yield from judge(contact, body=body, called=f"{_PARTS[part]}{of}", where=where)


def _different_rows(solution: BearingSolution) -> list[tuple[str, RollerBearing, list[int]]]:
    """Return the different rows: whose parts they are in words, the row, and the rollers of all rows like it."""
    rows = solution.bearing.rows
    different: list[tuple[str, RollerBearing, list[int]]] = []
    for number, row in enumerate(rows, start=1):
        rollers = range(row.rollers.start, row.rollers.stop)
        alike = next((others for _, other, others in different if other == row.bearing), None)
        if alike is None:
            different.append((f" of row {number}", row.bearing, list(rollers)))
        else:
            alike += rollers
    return different if len(different) > 1 else [("", *entry[1:]) for entry in different]


def _order_checks(checks: Iterable[Check]) -> Iterator[tuple[Level, Finding]]:
    """Yield each comparison that the material allows, those of equal wording once, the largest ratio first."""
    levels = {CheckStatus.FINE: Level.MET, CheckStatus.OVER: Level.NOT_MET, CheckStatus.UNKNOWN: Level.NOT_JUDGED}
    required = [check for check in checks if not check.unasked]
    ordered = sorted(required, key=lambda check: -check.ratio if math.isfinite(check.ratio) else 0.0)
    yield from {str(check.finding): (levels[check.verdict], check.finding) for check in ordered}.values()


def _unknown(materials: Mapping[str, Material]) -> Iterator[tuple[Level, Finding]]:
    """Yield each material whose pressure limit and yield strength are both unknown, with its parts."""
    parts: dict[Material, list[str]] = {}
    for part, material in materials.items():
        if material.pressure_limit is None and material.yield_strength is None:
            parts.setdefault(material, []).append(part)
    for material, of in parts.items():
        name = f"{name_of(material)} ".lstrip() + ("of no particular grade " if material == STEEL else "")
        what = f"of {name}({join_words(of)})" if name else f"of the material of {join_words(of)}"
        grade = "name its grade, such as 100Cr6, or " if material == STEEL else ""
        words = f"No limit is known {what}: {grade}give its yield strength or pressure limit."
        yield Level.NOT_JUDGED, finding("no-limit-known", words)


def _judge_life(life: float | None, required: float) -> tuple[Level, Finding]:
    if life is None:
        words = "A life of {required:.4g} million revolutions is required, but the life is not known in revolutions."
        return Level.NOT_JUDGED, finding("life", words, required=required)
    enough = life >= required
    verb = "reaches" if enough else "is below"
    words = f"The life of {{life:.4g}} million revolutions {verb} the required {{required:.4g}}."
    return _OF_LIMIT[enough], finding("life", words, life=life, required=required)


def _judge_ends(solution: Solution) -> Iterator[tuple[Level, Finding]]:
    if solution.singular_ends:
        words = "The pressure grows without limit towards {ends}."
        yield Level.UNLIMITED, finding("no-limit", words, ends=ends_in_words(solution.singular_ends))
    elif solution.peaks_at_corner:
        words = "The pressure grows without limit at a corner of the profile, where it is largest."
        yield Level.UNLIMITED, finding("no-limit", words)


def _list_strains(findings: Iterable[Finding]) -> Iterator[tuple[Level, Finding]]:
    return ((Level.STRAINED, item) for item in findings if item.kind not in _OF_ENDS)


def _add_findings(verdict: Verdict, more: Iterable[tuple[Level, Finding]]) -> Verdict:
    """Return a verdict with more findings, ordered again."""
    together = _make_verdict([*((verdict.level, item) for item in verdict.findings), *more], ())
    return replace(verdict, level=together.level, findings=together.findings)


def _make_verdict(findings: Sequence[tuple[Level, Finding]], checks: Iterable[Check], pressure: float = 0.0) -> Verdict:
    ordered = sorted(findings, key=lambda entry: -entry[0].rank)
    ratio = max((check.ratio for check in checks if math.isfinite(check.ratio)), default=0.0)
    return Verdict(ordered[0][0], tuple(item for _, item in ordered), severity=(ratio, pressure))
