"""Whole bearings: integrals over many rollers, published examples, single contacts, and sums in space.

What is known of them is in `claims.known_bearings`.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Iterator
from typing import Literal

import numpy as np

from claims import known_bearings as known
from claims.bearing_sums import sums_in_space
from claims.claim import Array, Claim, Evidence, solved
from nonhertz.bearing import (
    BearingLife,
    BearingSolution,
    TaperedRollerBearing,
    assess,
    life_factor,
    paired,
    rating,
    reference_viscosity,
    solve,
)
from nonhertz.bearing.equilibrium import Joint, System, solve_balance
from nonhertz.bearing.laws import Slices
from nonhertz.bearing.section import raceway_motion, ring_motion
from nonhertz.bearing.strips import cut_into_strips
from nonhertz.bearing.verb import assemble
from nonhertz.native import core

Method = Literal["strips", "slices"]

METHODS: tuple[Method, Method] = ("strips", "slices")
# Enough rollers that their sums are the integrals to 1e-4, and the angle of their contacts [rad].
MANY, ANGLE = 360, 0.3
WITHIN: dict[Method, float] = {"slices": 3e-3, "strips": 2e-2}
DISTANCE, PRELOAD, SPEED = 30.0, -0.01, 3000.0  # mm, mm, 1/min
FORCE = np.array([6e3, 20e3, 5e3, 2e5, -1e5])  # N along x, y, z, N mm about y, z
# Under this load all rollers are pressed along their whole length, and no strip leaves the contact in a step.
ROW = np.array([40e3, 20e3, 8e3, 1e-4, 2e-4])  # N along x, y, z, tilts about y, z [rad]
STEP = 1e-5  # mm: of the difference quotient

_STANDARD = "ISO/TS 16281, recomputed independently"
_MASTA = "MASTA, by a public program"
_RECOMPUTED = "slices, recomputed independently"


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for exponent in known.EXPONENTS:
        yield from _of_many(exponent)
    for case in known.LAMINA_CASES:
        yield from _laminae(case)
    yield Claim(
        "L10", _STANDARD, known.LAMINA_BASIC_LIFE, lambda: _lamina_life(known.LAMINA_CASES[-1], "standard").basic_life,
        0.06, "million", absolute=True,
    )  # fmt: skip
    yield from _loads()
    yield from _ratings()
    for kappa, row in known.LIFE_FACTORS.items():
        factors = Evidence("", "five public programs", functools.partial(_life_factors, kappa))
        names = [f"a_ISO at kappa = {kappa:g} and e_C C_u / P = {limit:g}" for limit in known.LIMITS]
        yield from factors.each(names, 5.1e-4, expected=row, absolute=True, why="all their digits")
    yield from _lives()
    yield from _by_hand()
    for method in METHODS:
        yield from _in_space(method)
    for method in METHODS:
        name = f"HR30306J, {method}: largest error of K_ij, over the root of K_ii K_jj"
        yield Claim(name, "differences of forces", 0.0, functools.partial(_derivative_off, method), 1e-6)


# Very many rollers, between two rings without clearance


def _of_many(exponent: float) -> Iterator[Claim]:
    of = Evidence(f"exponent {exponent:.4g}", "integral over the angle", functools.partial(_spread, exponent))
    factor, ratio = ratios = "Q_max Z cos(alpha) / F_r", "F_a / (F_r tan(alpha))"
    weighted, plain = (known.zone_integral(exponent, weighted=each) for each in (True, False))
    yield from of.each(ratios, 1e-4, expected=(1.0 / weighted, plain / weighted))
    within, why = 1e-3 if exponent == 1.1 else None, "published with three digits, for 1.1"
    yield of.claim(factor, operator.itemgetter(0), within, expected=known.STRIBECK, source="Stribeck", why=why)
    yield of.claim(ratio, operator.itemgetter(1), within, expected=known.SJOVALL, source="Sjovall", why=why)


@solved
def _spread(exponent: float) -> tuple[float, float]:
    """Return Q_max Z cos(alpha) / F_r, and F_a / (F_r tan(alpha)), of rollers that a ring presses without tilting."""
    law, load = Slices(np.zeros(1), np.zeros(1), 3e5, exponent), 1e5
    at, none = 2.0 * np.pi * np.arange(MANY) / MANY, np.zeros(MANY)
    joints = (
        Joint(True, raceway_motion(ANGLE, inner=True), none, law, 0),
        Joint(False, raceway_motion(ANGLE, inner=False), none, law, 1),
    )
    # A ring that does not move along the axis loads half of the rollers.
    system = System(ring_motion(at, (0.0, 2000.0)), joints, np.zeros((MANY, 3)), 5.0)
    radial = np.array([False, True, True, False, False])
    states = solve_balance(system, radial, np.array([[0.0, load, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
    factor = float(states.load.max()) * MANY * math.cos(ANGLE) / load
    return factor, float(states.force[0, 0]) / (load * math.tan(ANGLE))


# The example of the standard, in as many digits as its figures have


def _moved(solution: BearingSolution) -> float:
    """Return the displacement of the inner ring along y [um]."""
    return 1e3 * float(solution.displacement[1])


@solved
def _lamina_solution(case: known.LaminaCase) -> BearingSolution:
    return solve(case.bearing, radial=known.LAMINA_LOAD, tilt=case.tilt, method="slices")


@solved
def _lamina_life(case: known.LaminaCase, edge_stress: Literal["none", "standard"]) -> BearingLife:
    return assess(_lamina_solution(case), edge_stress=edge_stress)


def _laminae(case: known.LaminaCase) -> Iterator[Claim]:
    """Yield the numbers of one line of the example."""
    of = Evidence(case.name, _STANDARD, functools.partial(_lamina_solution, case))
    if case.displacement is not None:
        digit = 6e-6 if case.displacement < 10.0 else 6e-5
        yield of.claim("displacement", _moved, digit, "um", expected=case.displacement, absolute=True)
    loads = Evidence(case.name, _STANDARD, lambda: of.found().load[:, 0])
    names = [f"load of roller {number}" for number in range(len(case.loads))]
    yield from loads.each(names, 0.006, "N", expected=case.loads, absolute=True)
    digit = 0.6 if case.life > 1e4 else 0.06
    yield of.claim(
        "L10r, f = 1", lambda _: _lamina_life(case, "none").reference_life, digit, "million", expected=case.life,
        absolute=True,
    )  # fmt: skip
    yield of.claim(
        "L10r, edge function", lambda _: _lamina_life(case, "standard").reference_life, 8e-5, "million",
        expected=case.edged_life, why="three of them are up to 6e-5 off, in the fifth digit: known, and not explained",
    )  # fmt: skip


# NSK HR30306J as MASTA solved it


@solved
def tapered(method: Method) -> BearingSolution:
    """Return the HR30306J under its loads."""
    given = known.MASTA
    return solve(known.hr30306j(), radial=given.radial, axial=given.axial, method=method, laminae=given.laminae)


@solved
def tapered_life(method: Method, edge_stress: Literal["none", "standard"]) -> BearingLife:
    """Return its life."""
    given = known.MASTA
    return assess(
        tapered(method), dynamic=given.dynamic, static=given.static, laminae=given.laminae, edge_stress=edge_stress,
        speed=given.speed, viscosity=given.viscosity, cleanliness="high",
    )  # fmt: skip


def _loads() -> Iterator[Claim]:
    for method in ("slices", "strips"):
        of, loads = Evidence(f"HR30306J, {method}", _MASTA, functools.partial(_outer_loads, method)), known.MASTA.loads
        names = [f"load at {360.0 / 14 * number:.1f} degrees" for number in range(len(loads))]
        # Of an idle roller there is no relative difference.
        yield from of.each(names, [WITHIN[method] if load else 1.0 for load in loads], "N", expected=loads)
    yield Evidence("HR30306J, slices", _RECOMPUTED, lambda: tapered("slices")).claim(
        "radial displacement", _moved, 6e-3, "um", expected=known.SLICES_DISPLACEMENT, absolute=True
    )


def _outer_loads(method: Method) -> Array:
    return tapered(method).load[:, 1]


def _ratings() -> Iterator[Claim]:
    """Yield ratings and ratios in the digits that are quoted; the outer capacity is one digit off."""
    bearing, given = known.hr30306j(), known.MASTA
    per_lamina = given.laminae ** (-7.0 / 9.0)

    def found() -> list[float]:
        life = tapered_life("slices", "standard")
        inner, outer = 1e-3 * life.rating.inner, 1e-3 * life.rating.outer
        of_oil = reference_viscosity(given.speed, bearing.pitch), life.viscosity_ratio, life.contamination
        return [inner, outer, inner * per_lamina, outer * per_lamina, 1e-3 * life.rating.fatigue_limit, *of_oil]

    names = ("Q_ci", "Q_ce", "q_ci of a lamina", "q_ce of a lamina", "C_u", "nu_1", "kappa", "e_C")
    yield from Evidence("HR30306J", "quoted beside MASTA", found).each(
        names, (1e-3, 1e-3, 1e-3, 1e-3, 1e-4, 4e-4, 2e-4, 7e-5), ("kN", "kN", "kN", "kN", "kN", "mm^2/s", "", ""),
        expected=(14.16, 24.20, 0.803, 1.373, 7.317, 16.18, 3.413, 0.8174),
    )  # fmt: skip
    formulas, capacities = (
        ("C by the formula of ISO 281", "C_0 by the formula of ISO 76"),
        (given.dynamic, given.static),
    )
    of = Evidence("HR30306J", "catalogue", lambda: (1e-3 * rating(bearing).dynamic, 1e-3 * rating(bearing).static))
    yield from of.each(formulas, None, "kN", expected=[1e-3 * each for each in capacities])


def _life_factors(kappa: float) -> list[float]:
    return [life_factor(kappa, limit) for limit in known.LIMITS]


def _lives() -> Iterator[Claim]:
    """Yield lives, judged where they were recomputed by the same slices.

    How MASTA sums up the laminae is not stated, and the difference is left open.
    """
    plain, edged = (functools.partial(tapered_life, "slices", edges) for edges in ("none", "standard"))
    by_strips = functools.partial(tapered_life, "strips", "standard")
    program, life = "the program that quotes it", (operator.attrgetter("reference_life"), "million")
    factor = (lambda found: found.life_factor or math.nan, "")
    for method, found, quantity, (measure, unit), source, expected in (
        ("slices", plain, "L10r, f = 1", life, _RECOMPUTED, known.SLICES_LIFE),
        ("slices", edged, "L10r, edge function", life, _RECOMPUTED, known.SLICES_EDGED_LIFE),
        ("slices", edged, "a_ISO, edge function", factor, _RECOMPUTED, known.SLICES_FACTOR),
        ("slices", plain, "L10r, f = 1", life, _MASTA, known.MASTA.life),
        ("slices", edged, "L10r, edge function", life, _MASTA, known.MASTA.life),
        ("strips", by_strips, "L10r, edge function", life, _MASTA, known.MASTA.life),
        ("slices", edged, "L10r, edge function", life, program, known.PROGRAM_LIFE),
        ("slices", edged, "a_ISO, edge function", factor, _MASTA, known.MASTA.life_factor),
        ("slices", edged, "a_ISO, edge function", factor, program, known.PROGRAM_FACTOR),
    ):
        recomputed = source is _RECOMPUTED
        yield Evidence(f"HR30306J, {method}", source, found).claim(
            quantity, measure, 6e-3 if recomputed else None, unit, expected=expected, absolute=recomputed
        )


# NU 206 by contacts solved one at a time


@solved
def nu206(method: Method) -> BearingSolution:
    """Return the NU 206 under its load."""
    return solve(known.nu206(), radial=known.NU206_LOAD, tilt=known.NU206_TILT, method=method)


@solved
def nu206_by_hand() -> tuple[float, Array]:
    """Return displacement [mm] and loads [N] by single contacts."""
    return known.by_hand(known.nu206(), known.NU206_LOAD, known.NU206_TILT)


def _by_hand() -> Iterator[Claim]:
    """Yield the displacement and the loads of the NU 206; the fourth roller is idle."""
    of = Evidence("NU 206", "single contacts", lambda: nu206("strips"))
    yield of.claim("displacement", _moved, 1e-4, "um", expected=lambda: 1e3 * nu206_by_hand()[0])
    *loaded, idle = [f"load at {360.0 / 13 * number:.1f} degrees" for number in range(4)]
    loads = Evidence(of.name, of.source, lambda: nu206("strips").load[:, 0], lambda: nu206_by_hand()[1])
    yield from loads.each(loaded, 1e-4, "N")
    yield loads.claim(idle, operator.itemgetter(len(loaded)), 0.1, "N", absolute=True)


# Forces in space, and their derivatives


@solved
def _pair(method: Method) -> BearingSolution:
    pair = paired(known.hr30306j(), "O", DISTANCE, clearance=PRELOAD)
    return solve(pair, axial=float(FORCE[0]), radial=FORCE[1:3], moment=FORCE[3:], speed=SPEED, method=method)


def _in_space(method: Method) -> Iterator[Claim]:
    """Yield that the forces on two HR30306J are in balance, and have a potential."""
    of = Evidence(f"two HR30306J, {method}", "sum of vectors", lambda: sums_in_space(_pair(method)))
    beside = "what the ring bears beside what is given, over all loads"
    yield of.claim("what is left of a roller's balance, over all loads", "rollers_left", 1e-8)
    yield of.claim(beside, lambda sums: np.max(np.abs(sums.off(FORCE))), 1e-8)
    yield Evidence(of.name, "forces with a potential", lambda: _pair(method).stiffness).claim(
        "largest K_ij - K_ji, over the root of K_ii K_jj", lambda K: _largest(K - K.T, K), 1e-4
    )


def _largest(difference: Array, stiffness: Array) -> float:
    """Return the largest entry of a difference of stiffnesses, so that lengths and angles are alike."""
    size = np.sqrt(np.diag(stiffness))
    return float(np.max(np.abs(difference) / np.outer(size, size)))


def _derivative_off(method: Method) -> float:
    """Return the largest difference of a row's stiffness and the difference quotient of its forces."""
    row = known.hr30306j()
    found = solve(row, axial=float(ROW[0]), radial=ROW[1:3], tilt=ROW[3:], speed=SPEED, method=method)
    held = _of_kept_strips(found) if method == "strips" else functools.partial(_of_slices, row)
    ring, lever = found.displacement, 2.0 / row.pitch
    steps = STEP * np.diag([1.0, 1.0, 1.0, lever, lever])
    stiffness = held(ring)[1]
    quotients = [(held(ring + step)[0] - held(ring - step)[0]) / (2.0 * np.sum(step)) for step in steps]
    return _largest(np.transpose(quotients) - stiffness, stiffness)


def _of_slices(bearing: TaperedRollerBearing, ring: Array) -> tuple[Array, Array]:
    """Return force and stiffness at a motion of the ring."""
    found = solve(
        bearing, axial_displacement=float(ring[0]), radial_displacement=ring[1:3], tilt=ring[3:], speed=SPEED,
        method="slices",
    )  # fmt: skip
    return found.force, found.stiffness


def _of_kept_strips(solution: BearingSolution) -> Callable[[Array], tuple[Array, Array]]:
    """Return the same by strips that are laid once: where they are laid anew, the error of the grid jumps."""
    laws = [core.StripLaw([cut_into_strips(contact)]) for contact in solution.bearing.rows[0].bearing.contacts]
    system = assemble(solution.bearing, solution.roller_load, [laws])
    none, ring = np.zeros(5, dtype=bool), solution.displacement[None]
    begun = solve_balance(system, none, ring, ring, 0.01).motion

    def held(ring: Array) -> tuple[Array, Array]:
        found = solve_balance(system, none, ring[None], ring[None], 0.01, motion=begun)
        return found.force[0], found.stiffness[0]

    return held
