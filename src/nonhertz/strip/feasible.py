"""Prescriptions that no strip loads can meet, refused before a loop is started."""

from __future__ import annotations

import math

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.strip.grid import uniform
from nonhertz.strip.problem import KEPT_STRIPS, Problem, row_of, winkler_state
from nonhertz.strip.records import Array

LOOKS, CLOSER_LOOKS = 20000, 4
FINE_STRIPS = 2000  # spring strips, to find a contact that falls between a grid's strip centres


def feasible(problem: Problem, edges: Array) -> bool:
    """Return whether some loads on the strips between ``edges`` can meet what is prescribed."""
    try:
        refuse_infeasible(problem, edges)
    except InputError:
        return False
    return True


def refuse_infeasible(problem: Problem, edges: Array, *, chosen: bool = True) -> None:
    """Refuse a prescription that no loads on these strips can meet; ``chosen`` if the user gave the strips."""
    kept = chosen and edges.size <= KEPT_STRIPS
    strips = problem.model.kept_grid(edges) if kept else problem.model.grids(*row_of(edges))
    y, separation = strips.y[0], strips.separation[0]
    usable = y[np.isfinite(separation)]
    refuse_endless_relief(y, separation)
    by_load, by_moment = problem.prescribed
    first, second = problem.target
    if by_load and by_moment:
        if not chosen:
            refuse_arm_outside(problem, (float(usable[0]), float(usable[-1])))
        arm = second / first
        if not usable[0] <= arm <= usable[-1]:
            condition = f"have centres on both sides of moment / load = {mm(arm):.9g}"
            raise InputError("strips", edges.size - 1, condition, "use more strips or reduce the moment")
    elif by_moment:
        if not np.any(winkler_state(problem, edges).m > 0.0):
            condition = "bring the bodies into contact at the tilt that the moment causes"
            raise InputError("approach", float(first), condition, "raise it, or give a tilt")
    elif not by_load and not np.any(first + second * y - separation > 0.0):
        refuse_no_contact(problem, edges, chosen=chosen)


def refuse_arm_outside(problem: Problem, within: tuple[float, float]) -> None:
    """Refuse a load and moment whose resultant lies outside the interval where there can be pressure."""
    if not np.all(problem.prescribed):
        return
    arm = float(problem.target[1] / problem.target[0])
    if not within[0] <= arm <= within[1]:
        condition = f"keep moment / load = {mm(arm):.9g} between {mm(within[0], within[1], between=' and '):.9g}"
        moment = float(problem.target[1]) / problem.contact.compliance
        raise InputError("moment", moment, condition, "reduce it or raise the load")


def refuse_endless_relief(y: Array, separation: Array) -> None:
    """Refuse bodies whose relief is NaN somewhere, or infinite everywhere."""
    if np.any(np.isnan(separation)):
        place = float(y[np.argmax(np.isnan(separation))])
        raise InputError("profile", math.nan, f"not be NaN, but is at y = {place:g}", "correct its relief")
    if not np.any(np.isfinite(separation)):
        remedy = "reduce the relief or lengthen the logarithmic profile"
        raise InputError("profile", math.inf, "leave a finite separation somewhere on the bodies", remedy)


def refuse_no_contact(problem: Problem, edges: Array, *, chosen: bool = True) -> None:
    """Say why no strip touches at the prescribed approach: too few strips, or bodies too far apart."""
    fine = winkler_state(problem, uniform(float(edges[0]), float(edges[-1]), FINE_STRIPS))
    if chosen and np.any(fine.m > 0.0):
        remedy = "use more strips, or leave it out for an automatic grid"
        raise InputError("strips", edges.size - 1, "put the centre of a strip inside the contact", remedy)
    tilt = 0.0 if problem.prescribed[1] else problem.target[1]
    # Graded strips may be finer than the equal spring strips, so their edges are searched too.
    within = np.interp(np.linspace(0.0, edges.size - 1.0, LOOKS), np.arange(edges.size), edges)
    needed = _first_touch(problem, tilt, np.unique(np.concatenate([fine.y, edges, within])))
    given = float(problem.target[0])
    if given > needed:
        raise InputError("approach", given, "lead to a contact that strips can resolve", "raise it")
    condition = f"exceed {mm(needed):.6g}, where the bodies begin to touch"
    if chosen:
        condition += f" between y = {mm(edges[0], edges[-1], between=' and '):.6g}"
    raise InputError("approach", given, condition, "raise it, or prescribe the load")


def _first_touch(problem: Problem, tilt: float, y: Array) -> float:
    """Return the smallest approach [mm] at which the bodies touch, by repeated refinement around the best place."""
    least = math.inf
    for _ in range(CLOSER_LOOKS):
        separation = problem.model.separation(y)
        refuse_endless_relief(y, separation)
        needed = separation - tilt * y
        best = int(np.argmin(needed))
        least = min(least, float(needed[best]))
        y = np.linspace(y[max(best - 1, 0)], y[min(best + 1, y.size - 1)], 101)
    return least
