"""Whether a contact, a bearing or several of them bear their loads: one word, and what decides it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from nonhertz.amounts import loaded, mpa
from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.clearance import OperatingClearance
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.findings import Finding, finding
from nonhertz.model.contact import Contact
from nonhertz.result.ends import ends_in_words
from nonhertz.result.solution import Solution
from nonhertz.strength import Strength
from nonhertz.strength import Verdict as OfStrength

STATIC_LIMIT: Final = 4000.0
"""Pressure [MPa] under which a roller at rest dents bearing steel by 1/10000 of its diameter: ISO 76."""
_PRESSURE: Final = "pressure-limit"
#: What is said of ends and corners has a line of its own; all else that is found strains the model.
_OF_ENDS: Final = ("sharp-end", "corner-end", "corner-peak")


class Level(Enum):
    """How a verdict ends, from the best to the worst."""

    MET = "limits met"
    STRAINED = "model strained"
    UNLIMITED = "pressure unbounded"
    NOT_MET = "limits not met"

    @property
    def rank(self) -> int:
        """The larger, the worse."""
        return list(Level).index(self)


@dataclass(frozen=True)
class Verdict:
    """Whether limits are met.

    Attributes
    ----------
    level : Level
        The worst of what was found.
    findings : tuple of Finding
        What decides it, the worst first.
    where : str
        Of several, what it is the verdict on, such as ``"under 20 kN"``; empty if there is only one.
    """

    level: Level
    findings: tuple[Finding, ...]
    where: str = ""

    @property
    def words(self) -> str:
        """How it ends, as the beginning of what people read."""
        among = ("; worst " if self.level is Level.MET else " ") if self.where else ""
        return f"{self.level.value.capitalize()}{among}{self.where}."

    @property
    def sentence(self) -> str:
        """What decides it first."""
        return str(self.findings[0]) if self.findings else ""

    @property
    def share(self) -> float:
        """The largest pressure over its limit, as far as it is known."""
        numbers = (dict(each.numbers) for each in self.findings if each.kind == _PRESSURE)
        return max((each["pressure"].values[0] / each["limit"].values[0] for each in numbers), default=0.0)

    def as_object(self) -> dict[str, Any]:
        """Return it for programs."""
        return {
            "level": self.level.name.lower().replace("_", "-"),
            **({"where": self.where} if self.where else {}),
            "findings": [each.as_object() for each in self.findings],
        }


def given_verdict(found: Verdict | None) -> dict[str, Any] | None:
    """Return a verdict, if there is one, as files have it."""
    return None if found is None else found.as_object()


def of_contact(solution: Solution, strengths: Iterable[Strength] = ()) -> Verdict | None:
    """Return the verdict on a contact; None where nothing touches.

    Parameters
    ----------
    solution : Solution
        The solved contact.
    strengths : iterable of Strength
        What `nonhertz.strength.assess` found of the bodies, if it was asked.
    """
    if not solution.contact_y:
        return None
    found = [_pressed(solution.max_pressure, *_limit(solution.contact))]
    if solution.singular_ends or solution.peaks_at_corner:
        found.append((Level.UNLIMITED, _without_limit(solution)))
    found += [
        (Level.NOT_MET, check.finding)
        for each in strengths
        for check in each.checks
        if check.verdict is OfStrength.OVER
    ]
    return _worst([*found, *_strained(solution.findings)])


def of_loads(solved: Iterable[tuple[Solution, Any]]) -> Verdict | None:
    """Return the worst verdict on a contact under several loads; of pairs, each with something else such as a share."""
    pairs = [*solved]
    return worst_of({f"under {loaded(each.load, each.tilt)}": of_contact(each) for each, _ in pairs})


def worst_of(found: Mapping[str, Verdict | None]) -> Verdict | None:
    """Return the worst of several verdicts, which says by its name which one it is; None if there are none.

    Examples
    --------
    >>> strained, met = Verdict(Level.STRAINED, (), "under 5 kN"), Verdict(Level.MET, ())
    >>> worst_of({"in a.toml": met, "in b.toml": strained}).words
    'Model strained in b.toml under 5 kN.'
    """
    given = {where: each for where, each in found.items() if each is not None}
    worst = max(given, key=lambda where: (given[where].level.rank, given[where].share), default=None)
    if worst is None:
        return None
    found_worst = given[worst]
    return replace(found_worst, where=f"{worst} {found_worst.where}".strip()) if len(given) > 1 else found_worst


def of_rows(
    pressures: ArrayLike, contact: Contact | None, warned: ArrayLike = (), what: str = "rows"
) -> Verdict | None:
    """Return the verdict on the rows of a study, of which the largest pressures are known.

    Parameters
    ----------
    pressures : array_like
        The largest pressure of each row [MPa], nan where it has failed.
    contact : Contact or None
        The bodies, for their limits; None for bearings.
    warned : array_like
        How many warnings each row has, if that is known.
    what : str
        What the rows are called.
    """
    known = np.asarray(pressures, dtype=float)
    known = known[np.isfinite(known)]
    if not known.size:
        return None
    limit, body = (STATIC_LIMIT, "") if contact is None else _limit(contact)
    over = np.count_nonzero(known > limit)
    verb = "exceeds" if over == 1 else "exceed"
    among = f"; {over} of {known.size} {what} {verb} it" if over and known.size > 1 else ""
    found = [_pressed(float(known.max()), limit, body, f" of all {what}", among)]
    strained = np.count_nonzero(np.asarray(warned, dtype=float) > 0.0)
    if strained:
        words = "{strained} of {rows} " + what + " have warnings: solve one of them to read which."
        found.append((Level.STRAINED, finding("rows-warned", words, strained=strained, rows=known.size)))
    return _worst(found)


def of_bearing(
    solution: BearingSolution, life: BearingLife | None, clearance: OperatingClearance | None
) -> Verdict | None:
    """Return the verdict on a loaded bearing; None where nothing is known of it.

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing.
    life : BearingLife or None
        How long it lasts, if it is rated.
    clearance : OperatingClearance or None
        What is left of its clearance, if its fits are known.
    """
    found = [] if clearance is None else list(_loosened(clearance))
    if solution.method == "strips" and solution.load.any():
        pressure = solution.max_pressure
        j, k = np.unravel_index(int(np.argmax(pressure)), pressure.shape)
        where = f" between {solution.place_of(int(j))} and the {RINGS[k]} ring"
        found.append(_pressed(float(pressure[j, k]), STATIC_LIMIT, where=where))
    if life is not None and math.isfinite(life.static_safety):
        enough = life.static_safety >= 1.0
        words = "The static safety S0 is {safety:.3g}" + (", at least 1." if enough else ", below 1.")
        found.append(
            (Level.MET if enough else Level.NOT_MET, finding("static-safety", words, safety=life.static_safety))
        )
    return _worst([*found, *_strained(findings_of(solution, life))]) if found else None


def findings_of(solution: BearingSolution, life: BearingLife | None) -> tuple[Finding, ...]:
    """Return what is found about a loaded bearing and its life."""
    return (*solution.findings, *(life.findings if life is not None else ()))


def _loosened(clearance: OperatingClearance) -> Iterator[tuple[Level, Finding]]:
    for ring, fit, seat in (("inner", clearance.inner, "on its shaft"), ("outer", clearance.outer, "in its housing")):
        if fit.loosened:
            words = "The {ring} ring has come loose {seat}: {mounted:4} between them when mounted, none in operation."
            yield Level.NOT_MET, finding("loosened-fit", words, ring=ring, seat=seat, mounted=mpa(fit.mounted_pressure))


def _limit(contact: Contact) -> tuple[float, str]:
    """Return the lowest limit of the pressure and the body that has it; that of bearing steel if none is known."""
    bodies = {"a": contact.a, "b": contact.b}
    known = {name: each.material.pressure_limit for name, each in bodies.items()}
    limits = {name: limit for name, limit in known.items() if limit is not None}
    body = min(limits, key=lambda name: limits[name], default="")
    return limits.get(body, STATIC_LIMIT), body


def _pressed(pressure: float, limit: float, body: str = "", where: str = "", more: str = "") -> tuple[Level, Finding]:
    """Return how the largest pressure stands against its limit: that of a body, or of bearing steel."""
    whose = f"the limit of body {body}" if body else "that of bearing steel at rest (ISO 76)"
    over = pressure > limit
    words = (
        f"The largest pressure{where}, {{pressure:4}}, {'exceeds' if over else 'is below'} {{limit:g}}, {whose}{more}."
    )
    found = finding(_PRESSURE, words, pressure=mpa(pressure), limit=mpa(limit))
    return (Level.NOT_MET if over else Level.MET), found


def _without_limit(solution: Solution) -> Finding:
    if solution.singular_ends:
        words = "The pressure grows without limit towards {ends}."
        return finding("no-limit", words, ends=ends_in_words(solution.singular_ends))
    return finding("no-limit", "The pressure grows without limit at a corner of the profile, where it is largest.")


def _strained(found: Iterable[Finding]) -> Iterator[tuple[Level, Finding]]:
    return ((Level.STRAINED, each) for each in found if each.kind not in _OF_ENDS)


def _worst(found: Sequence[tuple[Level, Finding]]) -> Verdict:
    ordered = sorted(found, key=lambda each: -each[0].rank)
    return Verdict(ordered[0][0], tuple(each for _, each in ordered))
