"""The final check of a solution: whether it meets what was prescribed, computed from its own arrays alone.

The Newton loop judges itself by the residual of the equations it has just linearised, on the strips it holds active,
and a globalisation may solve a different problem on the way. This check shares nothing with the loop but the element's
table and the images: from edges, loads, half-widths, approach and tilt it recomputes displacement and curvature at
every strip and compares them with the bodies and with the prescription. A state that fails it is not a solution, even
if the loop reported convergence.
"""

from __future__ import annotations

import numpy as np

from nonhertz.amounts import mm, per_mm, um
from nonhertz.native import core
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import Array, Flags, Grids, States
from nonhertz.strip.solving import flags

MET, NOT_FINITE, FIRST, SECOND, TENSION, UNCLOSED, OVERLAP, BENT, HIDDEN = range(9)


def shortfall(
    problem: Problem, grids: Grids, line_load: Array, half_width: Array, gap: Array, motion: Array
) -> str | None:
    """Return one sentence on what a solution fails to meet, or None if it meets everything.

    Parameters
    ----------
    problem : Problem
        What was prescribed.
    grids : Grids
        One grid: the strips.
    line_load, half_width, gap : ndarray, shape (n,)
        Load per length q [N/mm], half-width a of the element [mm] and gap [mm] of each strip.
    motion : ndarray, shape (2,)
        Approach [mm] and tilt [rad].
    """
    y, compliance = grids.y[0], problem.contact.compliance
    condition, found, at = core.first_unmet(
        grids, flags(problem.prescribed), problem.target.tolist(), problem.model.kernel,
        compliance * line_load, half_width, gap, motion.tolist(),
    )  # fmt: skip
    if condition == MET:
        return None
    if condition in {FIRST, SECOND}:
        which = condition - FIRST
        by_force = bool(problem.prescribed[which])
        name, unit = (("approach", "mm"), ("tilt", "rad"), ("load", "N"), ("moment", "N mm"))[2 * by_force + which]
        per = compliance if by_force else 1.0
        return f"The {name} of the state reached is {found / per:.6g} {unit}, not {problem.target[which] / per:.6g}."
    place = f"at y = {mm(y[at]):.6g}"
    return {
        NOT_FINITE: f"The state reached is not finite {place}.",
        TENSION: f"The state reached has tension {place}, {per_mm(found / compliance):.3g}.",
        UNCLOSED: f"The state reached leaves a gap of {um(found):.3g} {place}, where it bears load.",
        OVERLAP: f"In the state reached, the bodies overlap by {um(found):.3g} {place}.",
        BENT: f"In the state reached, the curvatures across the contact do not match {place}: the relative error is "
        f"{found:.2g}.",
        HIDDEN: f"In the state reached, the bodies interfere by only {um(found):.3g}, which is lost in the "
        "rounding of tilt and relief.",
    }[condition]


def met_by(problem: Problem, grids: Grids, states: States, targets: Array) -> Flags:
    """Return which of many states meet everything; ``targets`` as `Problem.target`, shape (cases, 2)."""
    return np.array(core.met_by(grids, flags(problem.prescribed), targets, problem.model.kernel, states), dtype=bool)


def steadily(states: States) -> Flags:
    """Return in which of many cases the bodies resist being pressed together and being tilted."""
    reach = np.max(np.abs(states.edges[:, [0, -1]]), axis=1)
    cases = zip(states.stiffness, np.broadcast_to(reach, states.status.shape).tolist(), strict=True)
    return np.array([steady(stiffness, far) for stiffness, far in cases], dtype=bool)


def steady(stiffness: Array, reach: float) -> bool:
    """Return whether the bodies resist being pressed together and being tilted.

    Far outside the model's validity (bodies as thin as their contact is wide, contacts several times as wide as long)
    the equations have additional, spurious solutions whose load or moment falls as the bodies approach.

    Parameters
    ----------
    stiffness : ndarray, shape (2, 2)
        As in the solution.
    reach : float
        Largest distance from y = 0 [mm].
    """
    return core.steady(stiffness.tolist(), reach)
