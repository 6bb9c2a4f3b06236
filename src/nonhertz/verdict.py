"""Whether a contact or a bearing bears its load: one word, and what decides it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any, Final

import numpy as np

from nonhertz.amounts import mpa
from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.clearance import OperatingClearance
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.findings import Finding, finding
from nonhertz.result.ends import ends_in_words
from nonhertz.result.solution import Solution
from nonhertz.strength import Strength
from nonhertz.strength import Verdict as OfStrength

STATIC_LIMIT: Final = 4000.0
"""Pressure [MPa] under which a roller at rest dents bearing steel by 1/10000 of its diameter: ISO 76."""
#: What is said of ends and corners has a line of its own; all else that is found strains the model.
_OF_ENDS: Final = ("sharp-end", "corner-end", "corner-peak")


class Level(Enum):
    """How a verdict ends, from the best to the worst."""

    MET = "limits met"
    STRAINED = "model strained"
    UNLIMITED = "no limit of the pressure"
    NOT_MET = "limits not met"

    @property
    def rank(self) -> int:
        """The larger, the worse."""
        return list(Level).index(self)


@dataclass(frozen=True)
class Verdict:
    """Whether it bears it.

    Attributes
    ----------
    level : Level
        The worst of what was found.
    findings : tuple of Finding
        What decides it, the worst first.
    """

    level: Level
    findings: tuple[Finding, ...]

    @property
    def sentence(self) -> str:
        """What decides it first."""
        return str(self.findings[0]) if self.findings else ""

    def as_object(self) -> dict[str, Any]:
        """Return it for programs."""
        return {
            "level": self.level.name.lower().replace("_", "-"),
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
    bodies = {"a": solution.contact.a, "b": solution.contact.b}
    known = {name: each.material.pressure_limit for name, each in bodies.items()}
    limits = {name: limit for name, limit in known.items() if limit is not None}
    body = min(limits, key=lambda name: limits[name], default="")
    found = [_pressed(solution.max_pressure, limits.get(body, STATIC_LIMIT), body, "")]
    if solution.singular_ends or solution.peaks_at_corner:
        found.append((Level.UNLIMITED, _without_limit(solution)))
    found += [
        (Level.NOT_MET, check.finding)
        for each in strengths
        for check in each.checks
        if check.verdict is OfStrength.OVER
    ]
    return _worst([*found, *_strained(solution.findings)])


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
        found.append(_pressed(float(pressure[j, k]), STATIC_LIMIT, "", where))
    if life is not None and math.isfinite(life.static_safety) and not life.internally_loaded:
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


def _pressed(pressure: float, limit: float, body: str, where: str) -> tuple[Level, Finding]:
    """Return how the largest pressure stands against its limit: that of a body, or of bearing steel."""
    whose = f"the limit of body {body}" if body else "that of bearing steel at rest (ISO 76)"
    over = pressure > limit
    words = f"The largest pressure{where}, {{pressure:4}}, {'exceeds' if over else 'is below'} {{limit:g}}, {whose}."
    found = finding("pressure-limit", words, pressure=mpa(pressure), limit=mpa(limit))
    return (Level.NOT_MET if over else Level.MET), found


def _without_limit(solution: Solution) -> Finding:
    if solution.singular_ends:
        words = "The pressure has no limit towards {ends}."
        return finding("no-limit", words, ends=ends_in_words(solution.singular_ends))
    return finding("no-limit", "The pressure has no limit at a corner of the profile, where it is largest.")


def _strained(found: Iterable[Finding]) -> Iterator[tuple[Level, Finding]]:
    return ((Level.STRAINED, each) for each in found if each.kind not in _OF_ENDS)


def _worst(found: Sequence[tuple[Level, Finding]]) -> Verdict:
    ordered = sorted(found, key=lambda each: -each[0].rank)
    return Verdict(ordered[0][0], tuple(each for _, each in ordered))
