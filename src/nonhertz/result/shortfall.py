"""The condition that the final state of a loop fails to meet, in one sentence."""

from __future__ import annotations

from nonhertz.amounts import mm, per_mm, um
from nonhertz.native import core
from nonhertz.strip.problem import Problem

_PRESCRIBED = {core.Unmet.FIRST: ("approach", "mm", "load", "N"), core.Unmet.SECOND: ("tilt", "rad", "moment", "N mm")}


def shortfall(problem: Problem, result: core.Result) -> str | None:
    """Return the condition that a converged state does not meet, or None if it meets all."""
    if not result.is_steady:
        return "The stiffness of the state reached is negative or not finite: the equilibrium is unstable."
    unmet, compliance = result.shortfall, problem.contact.compliance
    condition, value = unmet.condition, unmet.value
    if condition is core.Unmet.NONE:
        return None
    if condition in _PRESCRIBED:
        which = int(condition is core.Unmet.SECOND)
        by_force = problem.by_force[which]
        name, unit = _PRESCRIBED[condition][2 * by_force : 2 * by_force + 2]
        per = compliance if by_force else 1.0
        return f"The {name} of the state reached is {value / per:.6g} {unit}, not {problem.target[which] / per:.6g}."
    if condition is core.Unmet.HIDDEN:
        return (
            f"In the state reached, the bodies interfere by only {um(value):.3g}, which is lost in the "
            "rounding of tilt and relief."
        )
    edges = result.edges
    place = f"at y = {mm(0.5 * (edges[unmet.at + 1] + edges[unmet.at])):.6g}"
    return {
        core.Unmet.NOT_FINITE: f"The state reached is not finite {place}.",
        core.Unmet.TENSION: f"The state reached has tension {place}, {per_mm(value / compliance):.3g}.",
        core.Unmet.UNCLOSED: f"The state reached leaves a gap of {um(value):.3g} {place}, where it is loaded.",
        core.Unmet.OVERLAP: f"In the state reached, the bodies overlap by {um(value):.3g} {place}.",
        core.Unmet.BENT: f"In the state reached, the curvatures across the contact do not match {place}: the relative "
        f"error is {value:.2g}.",
    }[condition]
