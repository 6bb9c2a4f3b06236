"""Errors for prescribed values that no strips can meet."""

from __future__ import annotations

import math
from collections.abc import Iterable

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.native import core
from nonhertz.strip.problem import Problem


def refusal(problem: Problem, refused: core.Refused) -> InputError:
    """Return the error of a case that the core has refused."""
    return refusal_in_words(refused, problem.contact.compliance, problem.target)


def refusal_in_words(refused: core.Refused, compliance: float, target: Iterable[float]) -> InputError:
    """Return the error of a refusal by the core, for a compliance K, and K Q or delta and K T or gamma."""
    why, value, low, high, strips = refused.args
    first, second = target
    between, arm = mm(low, high, between=" and "), mm(value)
    apart = f"exceed {mm(value):.6g}, where the bodies begin to touch"
    words: dict[core.Refusal, tuple[str, object, str, str]] = {
        core.Refusal.NAN_RELIEF: (
            "profile", math.nan, f"not be NaN, but is at y = {value:g}", "correct its relief"
        ),
        core.Refusal.ENDLESS_RELIEF: (
            "profile", math.inf, "leave a finite separation somewhere on the bodies",
            "reduce the relief or lengthen the logarithmic profile",
        ),
        core.Refusal.ARM_OUTSIDE: (
            "moment", second / compliance, f"keep moment / load = {arm:.9g} between {between:.9g}",
            "reduce it or raise the load",
        ),
        core.Refusal.ARM_OFF_STRIPS: (
            "strips", strips, f"have centres on both sides of moment / load = {arm:.9g}",
            "use more strips or reduce the moment",
        ),
        core.Refusal.TILTED_APART: (
            "approach", first, "bring the bodies into contact at the tilt that the moment causes",
            "raise it, or give a tilt",
        ),
        core.Refusal.BETWEEN_STRIPS: (
            "strips", strips, "put the centre of a strip inside the contact",
            "use more strips, or leave it out for an automatic grid",
        ),
        core.Refusal.UNRESOLVED: ("approach", first, "lead to a contact that strips can resolve", "raise it"),
        core.Refusal.APART: (
            "approach", first, f"{apart} between y = {between:.6g}" if strips else apart,
            "raise it, or prescribe the load",
        ),
        core.Refusal.NO_END: (
            "length", None, "be given where nothing else ends the contact",
            "give one of the bodies a length, or a profile that falls away",
        ),
    }  # fmt: skip
    return InputError(*words[why])
