"""Whole bearings: integrals over many rollers, published examples, single contacts, and sums in space."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

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
from nonhertz.bearing.equilibrium import Joint, System, balanced
from nonhertz.bearing.laws import Slices
from nonhertz.bearing.section import raceway_motion, ring_motion
from nonhertz.bearing.strips import StripLaw
from nonhertz.errors import without_accuracy_warnings
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, SMALL_SIZE
from nonhertz.verify import known_bearings as known
from nonhertz.verify.bearing_sums import sums_in_space
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
_Held = Callable[[Array], tuple[Array, Array]]  # a motion of the ring -> force and stiffness

_METHODS: tuple[Literal["strips", "slices"], ...] = ("strips", "slices")
# Enough rollers that their sums are the integrals to 1e-4, and the angle of their contacts [rad].
MANY, ANGLE = 360, 0.3
WITHIN_SLICES, WITHIN_STRIPS = 3e-3, 2e-2
# What of the lives with the edge function was not reproduced: 6e-5 of a figure of five digits.
EDGED = 8e-5
CAPACITY = 1e-3  # they are quoted with three to four digits
SAME, DERIVED, SYMMETRIC, BALANCED = 1e-4, 1e-6, 1e-4, 1e-8
DISTANCE, PRELOAD, SPEED = 30.0, -0.01, 3000.0  # mm, mm, 1/min
FORCE = np.array([6e3, 20e3, 5e3, 2e5, -1e5])  # N along x, y, z, N mm about y, z
# Under this load all rollers are pressed along their whole length, and no strip leaves the contact in a step.
ROW = np.array([40e3, 20e3, 8e3, 1e-4, 2e-4])  # N along x, y, z, tilts about y, z [rad]
STEP = 1e-5  # mm: of the difference quotient

_STANDARD = "ISO/TS 16281, recomputed independently"
_MASTA = "MASTA, as quoted"
_QUOTED = "quoted beside MASTA"
_RECOMPUTED = "slices, recomputed independently"
_HAND = "single contacts"
_TEXT = """\
Bearings are compared with what others found, and with what follows from the balance of forces alone:

- **Very many rollers.** Without clearance, and where the ring does not move along the axis, half of the rollers bear
  load, and $`Q_{{max}} Z \\cos\\alpha / F_r`$ and $`F_a / (F_r \\tan\\alpha)`$ are integrals over the angle
  (Stribeck, Sjövall). They depend on the exponent of the contacts alone: with 1.1 they are the usual 4.08 and 1.260,
  with the 10/9 of the standard {stribeck:.3f} and {sjovall:.3f}. {many} rollers stand for very many.
- **ISO/TS 16281.** Its slices in a row of 14 rollers of 10 x 9.6 mm under {lamina_load:g} N, with and without
  clearance, profile and tilt, against a program that was written apart from this one.
- **NSK HR30306J.** A tapered bearing under {radial:g} kN radial and {axial:g} kN axial load, with polynomial profiles
  of rollers and raceways, as MASTA solved it and a public program quotes it; details of that run are not stated.
- **NU 206.** {nu_load:g} kN and {nu_tilt:g} mrad, by strips, against a balance by hand: the motion of every roller,
  and then that of the ring, are searched for with contacts that `nonhertz.solve` solves one at a time.
- **Balance.** Two HR30306J back to back at {distance:g} mm with {preload:g} um of preload and {speed:g}/min, under
  forces in all directions and two moments: the forces on every roller and on the ring, summed as vectors in space.
  The stiffness is symmetric, since the forces have a potential. On a single row, whose rollers are all pressed along
  their whole length, it is compared with differences of the forces over {step:g} nm to both sides, on strips that are
  laid once: where strips are laid anew, or enter or leave a contact, forces are less smooth.

**Found.** Slices give every roller of the HR30306J the load that MASTA has, within {slices:.2f} %. Strips are up to
{strips:.1f} % off it. They differ in that the contact angle of the inner ring is smaller by the angle of the rollers'
cones and the rib bears the axial load that this leaves, and in how the bodies give way: slices do not press on each
other, and share the profiles of both raceways. Lives agree less:

| life of the HR30306J | L10r (million revolutions) | a_ISO |
|---|---:|---:|
{lives}

L10r by slices is {high:.0f} % longer than that of MASTA without the function of the edge stress and {low:.0f} %
longer with it, {program:.1f} % off that of the program. Loads, viscosity ratio and contamination agree, and the
capacities within {capacity}; how MASTA sums up the laminae is not stated, and the difference is left open. Strips have
the profiles of each contact alone; with the function of the edge stress their life is {short:+.0f} % off that of MASTA.
Their contacts reach sharp ends, so that their pressures give no life.

The NU 206 has the loads of contacts solved by hand within {hand}. The example of the standard comes out in all digits
but for the lives with the function of the edge stress, three of which are up to {edged} off: that is known, and not
explained.
"""


@dataclass(frozen=True, eq=False)
class _Tapered:
    """The HR30306J as it is solved here."""

    slices: BearingSolution
    strips: BearingSolution
    plain: BearingLife
    edged: BearingLife
    by_strips: BearingLife

    @classmethod
    def solved(cls) -> _Tapered:
        bearing, given = known.hr30306j(), known.MASTA
        slices, strips = (
            solve(bearing, radial=given.radial, axial=given.axial, method=each, laminae=given.laminae)
            for each in reversed(_METHODS)
        )
        plain, edged, by_strips = (
            assess(
                each, dynamic=given.dynamic, static=given.static, laminae=given.laminae, edge_stress=stress,
                speed=given.speed, viscosity=given.viscosity,
            )
            for each, stress in ((slices, "none"), (slices, "standard"), (strips, "standard"))
        )  # fmt: skip
        return cls(slices, strips, plain, edged, by_strips)


@dataclass(frozen=True, eq=False)
class _Nu206:
    strips: BearingSolution
    slices: BearingSolution
    displacement: float
    loads: Array

    @classmethod
    def solved(cls) -> _Nu206:
        bearing = known.nu206()
        strips = solve(bearing, radial=known.NU206_LOAD, tilt=known.NU206_TILT)
        slices = solve(bearing, radial=known.NU206_LOAD, tilt=known.NU206_TILT, method="slices")
        return cls(strips, slices, *known.by_hand(bearing, known.NU206_LOAD, known.NU206_TILT))


@without_accuracy_warnings()
def section() -> Section:
    """Return all comparisons."""
    tapered, nu206 = _Tapered.solved(), _Nu206.solved()
    of_laminae, of_ratings, of_hand = _laminae(), _ratings(tapered), _by_hand(nu206)
    checks = (
        *_spreads(), *of_laminae, *_loads(tapered), *of_ratings, *_factors(), *_lives(tapered), *of_hand,
        *_in_space(), *_derivatives(),
    )  # fmt: skip
    picture = Picture(
        "bearings",
        "Left: loads of the rollers of the HR30306J, on one side of the radial load, and how far they are from those "
        "of MASTA. Right: loads of the NU 206, tilted, by strips, by contacts solved one by one, and by slices.",
        functools.partial(_draw, tapered, nu206),
        height=3.8,
    )
    text = _text(tapered, of_laminae, of_ratings, of_hand)
    return Section("Whole bearings", text, checks, (picture,))


def _text(tapered: _Tapered, of_laminae: list[Check], of_ratings: list[Check], of_hand: list[Check]) -> str:
    *_, (_, stribeck, sjovall) = known.SPREADS
    given = known.MASTA
    rows = (
        ("MASTA", given.life, given.life_factor),
        ("the program that quotes it", known.PROGRAM_LIFE, known.PROGRAM_FACTOR),
        ("slices, without edge stress", tapered.plain.reference, tapered.plain.life_factor),
        ("slices, with the function of the edge stress", tapered.edged.reference, tapered.edged.life_factor),
        ("strips, with the function of the edge stress", tapered.by_strips.reference, tapered.by_strips.life_factor),
    )
    off_slices, off_strips = (np.abs(_off(each)) for each in (tapered.slices, tapered.strips))
    return _TEXT.format(
        stribeck=stribeck,
        sjovall=sjovall,
        many=MANY,
        lamina_load=known.LAMINA_LOAD,
        radial=1e-3 * given.radial,
        axial=1e-3 * given.axial,
        nu_load=1e-3 * known.NU206_LOAD,
        nu_tilt=1e3 * known.NU206_TILT,
        distance=DISTANCE,
        preload=-1e3 * PRELOAD,
        speed=SPEED,
        slices=off_slices.max(),
        strips=off_strips.max(),
        lives="\n".join(f"| {name} | {life:.2f} | {factor:.3f} |" for name, life, factor in rows),
        high=100.0 * (tapered.plain.reference / given.life - 1.0),
        low=100.0 * (tapered.edged.reference / given.life - 1.0),
        short=100.0 * (tapered.by_strips.reference / given.life - 1.0),
        step=1e6 * STEP,
        program=100.0 * abs(tapered.edged.reference / known.PROGRAM_LIFE - 1.0),
        capacity=_power(max(abs(each.difference) for each in of_ratings if each.tolerance == CAPACITY)),
        hand=f"$10^{{{math.ceil(math.log10(max(abs(each.difference) for each in of_hand if not each.absolute)))}}}$",
        edged=_power(max(abs(each.difference) for each in of_laminae if each.tolerance == EDGED)),
    )


def _power(value: float) -> str:
    exponent = math.floor(math.log10(value))
    return f"${value / 10.0**exponent:.0f} \\cdot 10^{{{exponent}}}$"


def _spreads() -> list[Check]:
    checks = []
    for exponent, *_ in known.SPREADS:
        law = Slices(np.zeros(1), np.zeros(1), 3e5, exponent)
        factor, ratio = _spread(law)
        weighted, plain = (known.zone_integral(exponent, weighted=each) for each in (True, False))
        words, published = f"exponent {exponent:.4g}", 1e-3 if exponent == 1.1 else None
        checks += [
            Check(f"{words}: Q_max Z cos(alpha) / F_r", "integral over the angle", 1.0 / weighted, factor, 1e-4),
            Check(f"{words}: F_a / (F_r tan(alpha))", "integral over the angle", plain / weighted, ratio, 1e-4),
            # Published with three digits, for 1.1.
            Check(f"{words}: Q_max Z cos(alpha) / F_r", "Stribeck", known.STRIBECK, factor, published),
            Check(f"{words}: F_a / (F_r tan(alpha))", "Sjovall", known.SJOVALL, ratio, published),
        ]
    return checks


def _spread(law: Slices) -> tuple[float, float]:
    """Return Q_max Z cos(alpha) / F_r, and F_a / (F_r tan(alpha)), of rollers that a ring presses without tilting."""
    load = 1e5
    at, none = 2.0 * np.pi * np.arange(MANY) / MANY, np.zeros(MANY)
    joints = (
        Joint(True, raceway_motion(ANGLE, inner=True), none, law, 0),
        Joint(False, raceway_motion(ANGLE, inner=False), none, law, 1),
    )
    # A ring that does not move along the axis loads half of the rollers.
    system = System(ring_motion(at, (0.0, 2000.0)), joints, np.zeros((MANY, 3)), 5.0)
    radial = np.array([False, True, True, False, False])
    states = balanced(system, radial, np.array([[0.0, load, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
    factor = float(states.rollers.load.max()) * MANY * math.cos(ANGLE) / load
    return factor, float(states.force[0, 0]) / (load * math.tan(ANGLE))


def _laminae() -> list[Check]:
    """Return the example of the standard, in as many digits as its figures have."""
    checks = []
    for case in known.LAMINA_CASES:
        found = solve(case.bearing, radial=known.LAMINA_LOAD, tilt=case.tilt, method="slices")
        if case.displacement is not None:
            moved, digit = 1e3 * float(found.displacement[1]), 6e-6 if case.displacement < 10.0 else 6e-5
            checks.append(
                Check(f"{case.name}: displacement", _STANDARD, case.displacement, moved, digit, "um", absolute=True)
            )
        for number, load in enumerate(case.loads):
            claim = f"{case.name}: load of roller {number}"
            checks.append(Check(claim, _STANDARD, load, float(found.load[number, 0]), 0.006, "N", absolute=True))
        plain, edged = (assess(found, edge_stress=each).reference for each in ("none", "standard"))
        digit = 0.6 if case.life > 1e4 else 0.06
        checks += [
            Check(f"{case.name}: L10r, f = 1", _STANDARD, case.life, plain, digit, "million", absolute=True),
            Check(f"{case.name}: L10r, edge function", _STANDARD, case.edged_life, edged, EDGED, "million"),
        ]
    basic = assess(found).basic
    return [*checks, Check("L10", _STANDARD, known.LAMINA_BASIC_LIFE, basic, 0.06, "million", absolute=True)]


def _loads(tapered: _Tapered) -> list[Check]:
    checks = []
    ways = (("slices", tapered.slices, WITHIN_SLICES), ("strips", tapered.strips, WITHIN_STRIPS))
    for name, found, tolerance in ways:
        for number, load in enumerate(known.MASTA.loads):
            claim = f"HR30306J, {name}: load at {math.degrees(found.angle[number]):.1f} degrees"
            outer = float(found.load[number, 1])
            # Of an idle roller there is no relative difference.
            checks.append(Check(claim, _MASTA, load, outer, tolerance if load else 1.0, "N", absolute=not load))
    moved = 1e3 * float(tapered.slices.displacement[1])
    claim = "HR30306J, slices: radial displacement"
    return [
        *checks,
        Check(claim, _RECOMPUTED, known.SLICES_DISPLACEMENT, moved, 6e-3, "um", absolute=True),
    ]


def _off(found: BearingSolution) -> Array:
    """Return by how many per cent the loads of the HR30306J are off those of MASTA, where these are not zero."""
    loads = np.array(known.MASTA.loads)
    loaded = np.flatnonzero(loads)
    return np.asarray(100.0 * (found.load[loaded, 1] / loads[loaded] - 1.0))


def _ratings(tapered: _Tapered) -> list[Check]:
    """Return ratings and ratios in the digits that are quoted; the outer capacity is one digit off."""
    bearing, given = known.hr30306j(), known.MASTA
    rated, found = tapered.edged.rating, tapered.edged
    per_lamina = given.laminae ** (-7.0 / 9.0)
    own = rating(bearing)
    numbers = (
        ("Q_ci", 14.16, 1e-3 * rated.inner, CAPACITY, "kN"),
        ("Q_ce", 24.20, 1e-3 * rated.outer, CAPACITY, "kN"),
        ("q_ci of a lamina", 0.803, 1e-3 * rated.inner * per_lamina, CAPACITY, "kN"),
        ("q_ce of a lamina", 1.373, 1e-3 * rated.outer * per_lamina, CAPACITY, "kN"),
        ("C_u", 7.317, 1e-3 * rated.fatigue_limit, 1e-4, "kN"),
        ("nu_1", 16.18, reference_viscosity(given.speed, bearing.pitch), 4e-4, "mm^2/s"),
        ("kappa", 3.413, found.viscosity_ratio or math.nan, 2e-4, ""),
        ("e_C", 0.8174, found.contamination or math.nan, 7e-5, ""),
    )
    return [
        *(
            Check(f"HR30306J: {name}", _QUOTED, expected, computed, tolerance, unit)
            for name, expected, computed, tolerance, unit in numbers
        ),
        Check(
            "HR30306J: C by the formula of ISO 281", "catalogue", 1e-3 * given.dynamic, 1e-3 * own.dynamic, None, "kN"
        ),
        Check(
            "HR30306J: C_0 by the formula of ISO 76", "catalogue", 1e-3 * given.static, 1e-3 * own.static, None, "kN"
        ),
    ]


def _factors() -> list[Check]:
    return [
        Check(
            f"a_ISO at kappa = {kappa:g} and e_C C_u / P = {limit:g}", "five public programs", expected,
            life_factor(kappa, limit), 5.1e-4, absolute=True,
        )
        for kappa, row in known.LIFE_FACTORS.items()
        for limit, expected in zip(known.LIMITS, row, strict=True)
    ]  # fmt: skip


def _lives(tapered: _Tapered) -> list[Check]:
    """Return lives, judged where they were recomputed by the same slices."""
    plain, edged, by_strips = (each.reference for each in (tapered.plain, tapered.edged, tapered.by_strips))
    factor = tapered.edged.life_factor or math.nan
    own = "HR30306J, slices"
    return [
        Check(f"{own}: L10r, f = 1", _RECOMPUTED, known.SLICES_LIFE, plain, 6e-3, "million", absolute=True),
        Check(
            f"{own}: L10r, edge function", _RECOMPUTED, known.SLICES_EDGED_LIFE, edged, 6e-3, "million", absolute=True
        ),
        Check(f"{own}: a_ISO, edge function", _RECOMPUTED, known.SLICES_FACTOR, factor, 6e-3, absolute=True),
        Check(f"{own}: L10r, f = 1", _MASTA, known.MASTA.life, plain, None, "million"),
        Check(f"{own}: L10r, edge function", _MASTA, known.MASTA.life, edged, None, "million"),
        Check("HR30306J, strips: L10r, edge function", _MASTA, known.MASTA.life, by_strips, None, "million"),
        Check(f"{own}: L10r, edge function", "the program that quotes it", known.PROGRAM_LIFE, edged, None, "million"),
        Check(f"{own}: a_ISO, edge function", _MASTA, known.MASTA.life_factor, factor, None),
        Check(f"{own}: a_ISO, edge function", "the program that quotes it", known.PROGRAM_FACTOR, factor, None),
    ]


def _by_hand(found: _Nu206) -> list[Check]:
    moved = float(found.strips.displacement[1])
    checks = [Check("NU 206: displacement", _HAND, 1e3 * found.displacement, 1e3 * moved, SAME, "um")]
    for number, load in enumerate(found.loads.tolist()):
        claim = f"NU 206: load at {math.degrees(found.strips.angle[number]):.1f} degrees"
        computed = float(found.strips.load[number, 0])
        checks.append(Check(claim, _HAND, load, computed, SAME if load else 0.1, "N", absolute=not load))
    return checks


def _in_space() -> list[Check]:
    pair = paired(known.hr30306j(), "O", DISTANCE, clearance=PRELOAD)
    checks = []
    for method in _METHODS:
        found = solve(pair, axial=float(FORCE[0]), radial=FORCE[1:3], moment=FORCE[3:], speed=SPEED, method=method)
        sums, stiffness = sums_in_space(found), found.stiffness
        numbers = (
            ("what is left of a roller's balance, over all loads", "sum of vectors", sums.rollers_left, BALANCED),
            (
                "what the ring bears beside what is given, over all loads",
                "sum of vectors",
                float(np.max(np.abs(sums.off(FORCE)))),
                BALANCED,
            ),
            (
                "largest K_ij - K_ji, over the root of K_ii K_jj",
                "forces with a potential",
                _largest(stiffness - stiffness.T, stiffness),
                SYMMETRIC,
            ),
        )
        checks += [
            Check(f"two HR30306J, {method}: {claim}", source, 0.0, computed, tolerance, absolute=True)
            for claim, source, computed, tolerance in numbers
        ]
    return checks


def _derivatives() -> list[Check]:
    row, checks = known.hr30306j(), []
    for method in _METHODS:
        found = solve(row, axial=float(ROW[0]), radial=ROW[1:3], tilt=ROW[3:], speed=SPEED, method=method)
        held = _of_kept_strips(found) if method == "strips" else functools.partial(_of_slices, row)
        off = _derivative_off(held, found.displacement)
        claim = f"HR30306J, {method}: largest error of K_ij, over the root of K_ii K_jj"
        checks.append(Check(claim, "differences of forces", 0.0, off, DERIVED, absolute=True))
    return checks


def _largest(difference: Array, stiffness: Array) -> float:
    """Return the largest entry of a difference of stiffnesses, so that lengths and angles are alike."""
    size = np.sqrt(np.diag(stiffness))
    return float(np.max(np.abs(difference) / np.outer(size, size)))


def _derivative_off(held: _Held, ring: Array) -> float:
    """Return the largest difference of the stiffness at a motion of the ring from the forces' difference quotient."""
    lever = 2.0 / known.hr30306j().pitch
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


def _of_kept_strips(solution: BearingSolution) -> _Held:
    """Return the same by strips that are laid once: where they are laid anew, the error of the grid jumps."""
    ((row, bearing),) = ((row, row.bearing) for row in solution.bearing.rows)
    contacts = zip(bearing.raceway_motions, row.gaps, bearing.contacts, strict=True)
    joints = [
        Joint(column == 0, motion, gap, StripLaw(contact), column)
        for column, (motion, gap, contact) in enumerate(contacts)
    ]
    for column, rib in enumerate(bearing.rib_contacts, start=2):
        joints.append(Joint(rib.ring == "inner", rib.motion, np.full(bearing.rollers, rib.gap), rib.law, column))
    system = System(row.ring_motion, tuple(joints), solution.roller_load, 0.5 * bearing.roller_length)
    none, ring = np.zeros(5, dtype=bool), solution.displacement[None]
    begun = balanced(system, none, ring, ring, 0.01).rollers.motion

    def held(ring: Array) -> tuple[Array, Array]:
        found = balanced(system, none, ring[None], ring[None], 0.01, motion=begun)
        return found.force[0], found.stiffness[0]

    return held


def _draw(tapered: _Tapered, nu206: _Nu206, figure: Figure) -> None:
    grid = figure.add_gridspec(2, 2, height_ratios=(2.0, 1.0))
    loads = figure.add_subplot(grid[0, 0])
    _draw_tapered(tapered, loads, figure.add_subplot(grid[1, 0], sharex=loads))
    _draw_nu206(nu206, figure.add_subplot(grid[:, 1]))


def _draw_tapered(tapered: _Tapered, loads: Axes, off: Axes) -> None:
    degrees = np.degrees(tapered.slices.angle[: len(known.MASTA.loads)])
    loaded = np.count_nonzero(known.MASTA.loads)
    loads.plot(
        degrees, 1e-3 * np.array(known.MASTA.loads), "o", color=INK, markersize=5.0, fillstyle="none", label="MASTA"
    )
    for name, found, colour, dashes in (
        ("slices", tapered.slices, FIRST, "-"), ("strips", tapered.strips, SECOND, "--"),
    ):  # fmt: skip
        loads.plot(degrees, 1e-3 * found.load[: degrees.size, 1], color=colour, linestyle=dashes, label=name)
        off.plot(degrees[:loaded], _off(found), marker=".", color=colour, linestyle=dashes)
    off.axhline(0.0, color=FAINT_INK, linewidth=0.6)
    loads.set(ylabel="load (kN)", ylim=(-0.3, 9.5), title="HR30306J")
    off.set(xlabel="angle from the load (degrees)", ylabel="from MASTA (%)", xlim=(-4.0, 135.0), ylim=(-2.0, 2.0))
    off.set_xticks(range(0, 121, 30))
    loads.legend(loc="upper right", fontsize=SMALL_SIZE)


def _draw_nu206(found: _Nu206, axes: Axes) -> None:
    degrees = np.degrees(found.strips.angle[: found.loads.size])
    axes.plot(
        degrees, 1e-3 * found.loads, "o", color=INK, markersize=5.0, fillstyle="none", label="contacts one by one"
    )
    for name, each, colour, dashes in (
        ("slices", found.slices, FIRST, "-"), ("strips", found.strips, SECOND, "--"),
    ):  # fmt: skip
        axes.plot(degrees, 1e-3 * each.load[: degrees.size, 0], color=colour, linestyle=dashes, label=name)
    axes.set(
        xlabel="angle from the load (degrees)", ylabel="load (kN)", xlim=(-4.0, 90.0), ylim=(-0.25, 7.7), title="NU 206"
    )
    axes.set_xticks(range(0, 91, 30))
    axes.legend(loc="upper right", fontsize=SMALL_SIZE)
