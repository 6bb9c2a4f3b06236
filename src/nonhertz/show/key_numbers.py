"""The key figures at the top of a page or a report."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from nonhertz.amounts import Amount, amount, format_digits, mm, mpa, newton, um
from nonhertz.bearing.assessed import BearingLife
from nonhertz.bearing.equilibrium import drop_rounding
from nonhertz.bearing.section import RINGS
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import NonhertzError
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.results import plain
from nonhertz.life.capacity import of_rolling_bearing
from nonhertz.result.along import unlimited_ends
from nonhertz.result.brief import where_largest
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution
from nonhertz.show.bearing import most_loaded
from nonhertz.study.quantities import LIFE_MODEL, life_of
from nonhertz.subsurface import Extreme


@dataclass(frozen=True)
class KeyNumber:
    """A key figure.

    Attributes
    ----------
    name : str
        Name of the quantity.
    amount : Amount
        One value.
    where : str
        Place or basis of the value.
    spec : str
        Format of the value, as an `Amount` takes it.
    under : float or None
        The load under which alone the value can be compared with others; None for any.
    """

    name: str
    amount: Amount
    where: str = ""
    spec: str = "4"
    under: float | None = None

    @property
    def shown(self) -> tuple[str, str]:
        """Number and unit as text; a dash if there is no number."""
        ([value], unit) = self.amount.apart(self.spec)
        return (value, unit) if math.isfinite(self.amount.values[0]) else ("–", "")


def contact_numbers(case: Case, solution: Solution, complaint: str) -> list[KeyNumber]:
    """Return the key figures of a contact, with its life unless a complaint says that it is not solved."""
    names = ("max_pressure", "approach", "penetration", "load", "tilt", "moment", "max_half_width")
    pressure, approach, penetration, load, tilt, moment, half_width = (
        QUANTITIES[name].amount(float(QUANTITIES[name].clean(solution))) for name in names
    )
    tilted = f"tilt {tilt:3}"
    if is_noticeable(solution.approach, solution.penetration):
        tilted += f", {penetration:4} after first touch"
    away = "largest, away from singular ends" if unlimited_ends(solution) else "largest"
    return [
        KeyNumber("Maximum pressure", pressure, where_largest(solution, 3)),
        KeyNumber("Approach", approach, tilted),
        KeyNumber("Load", load, f"moment {moment:3}"),
        KeyNumber("Half-width", half_width, away),
        *([] if complaint else _life(case, solution)),
    ]


def _life(case: Case, solution: Solution) -> list[KeyNumber]:
    """Return the life of a contact by laminae, of the body with a raceway, else of body a; none if not of a bearing.

    It is in revolutions if there is a rating, else relative to that under an even pressure of the same load.
    """
    if not (of_rolling_bearing(case.contact) and solution.contact_y):
        return []
    try:
        life = life_of(case, solution, LIFE_MODEL)
    except NonhertzError:
        return []
    # The only warning that a life adds to those of its solution is of unbounded damage towards sharp ends.
    left_out = "" if set(life.warnings) <= set(solution.warnings) else ", sharp ends not counted"
    model = f"ISO/TS 16281, body {life.body}{left_out}"
    if life.million_revolutions is not None:
        return [KeyNumber("Life", amount(life.million_revolutions, "10⁶ rev."), f"L₁₀, {model}")]
    return [KeyNumber("Life", amount(life.relative_life, "× ideal profile"), model, "3", under=solution.load)]


def stress_number(body: str, largest: Extreme, *, searched: bool) -> KeyNumber:
    """Return the largest von Mises stress in all of a body, or only in the plane below the maximum pressure."""
    bore = "at the bore, " if largest.at_bore else ""
    place = f"{bore}y = {mm(largest.y):3}, {mm(largest.z):3} deep" if searched else "below the maximum pressure"
    return KeyNumber("von Mises stress", mpa(largest.max), f"body {body}, {place}")


def bearing_numbers(case: BearingCase, solution: BearingSolution, life: BearingLife | None) -> list[KeyNumber]:
    """Return the key figures of a loaded bearing; by slices there is no pressure."""
    most = most_loaded(solution)
    load = float(solution.load[most].max())
    angle = f"roller {most + 1} at {math.degrees(solution.angle[most]):.1f}°" if load > 0.0 else ""
    along, *across = drop_rounding(solution.displacement[:3], np.ones(3))
    moved = f"radial; axial {um(along):3}" if along else "radial, of the inner ring"
    loaded = amount(float(np.count_nonzero(solution.load.min(axis=1) > 0.0)), f"of {solution.angle.size}")
    clearance = case.operating_clearance
    return [
        _pressure(solution),
        *(() if life is None else _ratings(case, life, solution.method)),
        *(() if clearance is None else (KeyNumber("Operating clearance", um(clearance.clearance), "radial"),)),
        KeyNumber("Largest roller load", newton(load), angle, "4g"),
        KeyNumber("Loaded rollers", loaded, spec="4g"),
        KeyNumber("Displacement", um(math.hypot(*across)), moved),
    ]


def _pressure(solution: BearingSolution) -> KeyNumber:
    if solution.method == "slices" or not solution.load.any():
        return KeyNumber("Maximum pressure", mpa(math.nan), "by strips only" if solution.method == "slices" else "")
    roller, ring = np.unravel_index(int(np.argmax(solution.max_pressure)), solution.load.shape)
    where = f"roller {roller + 1}, {RINGS[ring]} ring"
    return KeyNumber("Maximum pressure", mpa(float(solution.max_pressure[roller, ring])), where)


def _ratings(case: BearingCase, life: BearingLife, method: str) -> list[KeyNumber]:
    """Return life, in hours where the speed is known, static safety, and the viscosity ratio with the cleanliness."""
    kappa = life.viscosity_ratio
    # A missing cleanliness is named beside the viscosity ratio.
    how = life.no_modified if life.no_modified and kappa is None else f"by {method}"
    revolutions, name = life.rated_life, "Rated life" if life.no_modified else "Modified life"
    shown = KeyNumber(name, amount(revolutions, "10⁶ rev"), how, "3")
    if life.speed:
        shown = KeyNumber(name, amount(life.rated_hours, "hours"), f"{format_digits(revolutions, 3)} 10⁶ rev, {how}")
    clean = "cleanliness not given"
    if life.contamination is not None:
        clean = f"cleanliness e_C = {format_digits(life.contamination, 3)}"
    return [
        shown,
        *(
            [KeyNumber("Static safety", amount(life.static_safety, "S₀"), "C₀ / P₀", "3")]
            if plain(life.static_safety)
            else []
        ),
        *([] if kappa is None else [KeyNumber("Viscosity ratio", amount(kappa, "κ"), clean, "3")]),
    ]
