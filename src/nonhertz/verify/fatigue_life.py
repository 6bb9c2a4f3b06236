"""Fatigue life: exponents, ideal integrals, the figures of ISO/TS 16281, and life on strips against a plane grid."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.hertz import line_contact
from nonhertz.life import (
    Life,
    Raceway,
    VolumeModel,
    assess,
    ioannides_harris,
    iso_16281,
    lundberg_palmgren,
    weibull,
    zaretsky,
)
from nonhertz.life.lamina import edge_function, laminae_of
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import iso_logarithmic
from nonhertz.patch import solve as solve_patch
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

STEEL = Material(206000.0, 0.3)
DIAMETER, LENGTH, LOAD_ON_LINE = 10.0, 10.0, 10e3  # mm, N
NARROW = 0.05  # mm: width of the outer two of three strips; a line contact is uniform along y and needs no more
RING_DIAMETER, LOAD, TILTS, CELLS = 80.0, 20e3, (0.0, 0.5e-3, 1e-3), (192, 64)
EXPONENT = 5e-4  # three digits
LAMINA_EXPONENT = 4.5  # of a lamina's load in the standard
_STANDARD = "ISO 281 and ISO/TS 16281, by public programs"
_STIFFNESS = 3.9707e-5  # mm, of one contact: delta = _STIFFNESS Q^0.9 / L^0.8
_LIVES = (50000.0, 6500.0, 1000.0)  # h
_HOURS = (40.0 / 60.0, 15.0 / 60.0, 5.0 / 60.0)  # of every load in a cycle of one hour
QUADRATURE = 1200  # depths of the second quadrature
ROLLERS = 14
_TEXT = """\
Lives are integrals of high powers of the stress below a contact. Where the contact is one of Hertz's, what they come to
is known:

- **Exponents.** Two equal rollers with their faces at the same places and all mirror images are a piece of a line
  contact, with $`p_0`$ and b like the root of the load per unit length. The integral of $s^k / z^h$ over the stressed
  section then goes with the load to the power $(k - h + 1)/2$ and with the length to the power $1 - (k - h + 1)/2$, and
  life is that to the power $-1/e$. For Lundberg and Palmgren that is 4 for the load and 28/9 for the length: for a
  given life the load goes with the length to the power 7/9. Each is found from two solved contacts, one under twice the
  load or twice as long. A fatigue limit breaks the law unless it is raised with the pressure.
- **Ideal integrals.** The integral itself, lengths over b and stresses over their largest value, against another
  quadrature: of McEwen's closed form on {quadrature} depths.
- **ISO/TS 16281.** Its capacities for {rollers} rollers of 10 x 9.6 mm on a pitch diameter of 65 mm, its function of
  the edge stress, and how much its slices yield. With a modulus of 210000 MPa, for which the standard's constant 271
  was made, laminae loaded by their pressures are those of its Eqs. (58) and (59); elsewhere the material's own modulus
  is used.
- **Strips and plane grid.** A roller of diameter and length 20 mm with the logarithmic profile of ISO 16281 on a ring
  of {ring:g} mm, {load:g} kN, {tilt:g} mrad, on strips and on a plane grid of {across} x {along} cells: relative lives
  by all models.
- **Load spectrum.** Three loads that are borne for {hours} minutes of every hour, and under each of which alone an
  ideal contact would live {lives} hours: by Palmgren and Miner it lives {hand:.2f} hours.

**Found.** The exponents are met within $10^{{{exponents}}}$ and the integrals within {integrals:.4f} %; the relative
life of the line contact is 1 within {ideal:.4f} %. The figures of the standard come out in all their digits. Relative
lives of the tilted roller on strips are {low:+.2f} to {high:+.2f} % off those on the plane grid:

| model | strips | plane grid |
|---|---:|---:|
{rows}
"""


def section() -> Section:
    """Return all comparisons."""
    tilted = {tilt: _tilted(tilt) for tilt in TILTS}
    on_strips, on_cells = assess(tilted[TILTS[1]], body="b"), _on_cells()
    line = _line()
    lives = assess(line, body="b")
    of_exponents, of_integrals, of_ideal = _exponents(lives), _integrals(line, lives), _ideal(lives)
    of_grids = [
        Check(f"tilted roller, {ours.model.name}: relative life", "plane grid", theirs.relative, ours.relative, 5e-3)
        for ours, theirs in zip(on_strips, on_cells, strict=True)
    ]
    differences = [100.0 * check.difference for check in of_grids]
    text = _TEXT.format(
        quadrature=QUADRATURE,
        rollers=ROLLERS,
        ring=RING_DIAMETER,
        load=1e-3 * LOAD,
        tilt=1e3 * TILTS[1],
        across=CELLS[0],
        along=CELLS[1],
        hours=", ".join(f"{60.0 * each:g}" for each in _HOURS),
        lives=", ".join(f"{each:g}" for each in _LIVES),
        hand=_by_hand(),
        exponents=math.ceil(math.log10(max(abs(check.difference) for check in of_exponents))),
        integrals=100.0 * max(abs(check.difference) for check in of_integrals),
        ideal=100.0 * max(abs(check.difference) for check in of_ideal),
        low=min(differences),
        high=max(differences),
        rows="\n".join(
            f"| {ours.model.name} | {ours.relative:.4f} | {theirs.relative:.4f} |"
            for ours, theirs in zip(on_strips, on_cells, strict=True)
        ),
    )
    pictures = (
        Picture(
            "fatigue-life",
            "Left: life over load of a piece of a line contact, over that under 1 kN/mm. Right: damage of the tilted "
            "roller along y by Lundberg and Palmgren, over that under the ideal pressure.",
            functools.partial(_draw, tilted, on_strips),
        ),
    )
    checks = (*of_exponents, *of_integrals, *of_ideal, *_standard(), *_constant(), *of_grids, *_miner())
    return Section("Fatigue life", text, checks, pictures)


def _line(load: float = LOAD_ON_LINE, length: float = LENGTH) -> Solution:
    """Return a piece of a line contact."""
    roller = Roller(diameter=DIAMETER, length=length, material=STEEL, side_faces="mirror", images="series")
    end = 0.5 * length
    return solve(Contact(roller, roller), load=load, strips=(-end, NARROW - end, end - NARROW, end))


def _roller() -> Contact:
    profile = iso_logarithmic(diameter=20.0, length=20.0)
    roller = Roller(diameter=20.0, length=20.0, material=STEEL, profile=profile, side_faces="mirror")
    return Contact(roller, Ring(diameter=RING_DIAMETER, material=STEEL))


def _tilted(tilt: float) -> Solution:
    return solve(_roller(), load=LOAD, tilt=tilt)


def _on_cells() -> tuple[Life, ...]:
    # Many cells across, for the shear just below the surface; along, the pressure is smooth.
    return assess(solve_patch(_roller(), load=LOAD, tilt=TILTS[1], cells=CELLS), body="b")


def _exponents(once: tuple[Life, ...]) -> list[Check]:
    limit = ioannides_harris().fatigue_limit
    raised = ioannides_harris(fatigue_limit=math.sqrt(2.0) * limit)
    models = [life.model for life in once]
    twice = assess(
        _line(2.0 * LOAD_ON_LINE), [raised if each.name == raised.name else each for each in models], body="b"
    )
    longer = assess(_line(length=2.0 * LENGTH), models, body="b")
    source = "b and p0 like the root of the load"
    checks = []
    for first, loaded, long in zip(once, twice, longer, strict=True):
        model = first.model
        half = (
            0.5 * (model.exponent - model.depth_exponent + 1.0) if isinstance(model, VolumeModel) else LAMINA_EXPONENT
        )
        of_load = math.log2(loaded.damage / first.damage) / model.slope
        of_length = math.log2(first.damage / long.damage) / model.slope
        limited = model.name == raised.name
        words = ", its limit raised with the pressure" if limited else ""
        claim = f"{model.name}{words}: life goes with 1/load to the power"
        checks.append(Check(claim, source, half / model.slope, of_load, EXPONENT))
        if not limited:
            claim = f"{model.name}: life goes with the length to the power"
            checks.append(Check(claim, source, (half - 1.0) / model.slope, of_length, EXPONENT))
    return checks


def _integrals(line: Solution, lives: tuple[Life, ...]) -> list[Check]:
    hertz = line_contact(line_load=LOAD_ON_LINE / LENGTH, radius=0.25 * DIAMETER, compliance=line.contact.compliance)
    checks = []
    for life in lives:
        model = life.model
        if not isinstance(model, VolumeModel) or model.fatigue_limit > 0.0:
            continue
        top, expected = _quadrature(model)
        unit = (top * hertz.max_pressure) ** model.exponent * hertz.half_width ** (1.0 - model.depth_exponent)
        claim = (
            f"{model.name}: integral of (s/s_max)^{model.exponent:.4g} / z^{model.depth_exponent:.3g} over the depth"
        )
        # Tolerance for lives of smooth contacts.
        checks.append(Check(claim, "quadrature of McEwen's closed form", expected, life.damage / unit / LENGTH, 1e-3))
    return checks


def _quadrature(model: VolumeModel) -> tuple[float, float]:
    """Return the largest stress below Hertz's line contact over p0, and the model's integral over the depth over b."""
    logarithm = np.linspace(math.log(1e-5), math.log(60.0), QUADRATURE)
    z = np.exp(logarithm)[:, None]
    x = np.linspace(0.0, 1.0, 601) * (1.2 + z)
    largest = _over(x, z, model.stress)
    top = float(largest.max())
    integrand = (largest / top) ** model.exponent * z[:, 0] ** (1.0 - model.depth_exponent)
    return top, float(np.trapezoid(integrand, logarithm))


def _over(x: Array, z: Array, stress: str) -> Array:
    """Return the largest stress at each depth over p0, by the vertex of a parabola, lengths over b."""
    apart = 1.0 - x**2 + z**2
    root = np.sqrt(apart**2 + 4.0 * x**2 * z**2)
    m, n = np.sqrt(0.5 * (root + apart)), np.sqrt(np.maximum(0.5 * (root - apart), 0.0))
    fraction = (z**2 + n**2) / (m**2 + n**2)
    across, below, shear = 2.0 * z - m * (1.0 + fraction), -m * (1.0 - fraction), n * (m**2 - z**2) / (m**2 + n**2)
    if stress == "orthogonal_shear":
        values = np.abs(shear)
    else:
        middle, half = 0.5 * (across + below), np.sqrt(0.25 * (across - below) ** 2 + shear**2)
        along = 2.0 * STEEL.poisson * middle
        values = np.maximum(half, 0.5 * (half + np.abs(middle - along)))
    best = np.clip(values.argmax(axis=1), 1, x.shape[1] - 2)
    low, top, high = (values[np.arange(best.size), best + step] for step in (-1, 0, 1))
    bend = low - 2.0 * top + high
    vertex = top - np.divide((low - high) ** 2, 8.0 * bend, out=np.zeros_like(top), where=bend < 0.0)
    return np.asarray(np.maximum(vertex, values.max(axis=1)))


def _ideal(lives: tuple[Life, ...]) -> list[Check]:
    return [
        Check(f"{life.model.name}: relative life of a line contact", "the ideal pressure", 1.0, life.relative, 1e-3)
        for life in lives
    ]


def _standard() -> list[Check]:
    inner, outer = (Raceway(10.0, 9.6, 65.0, inner) for inner in (True, False))
    rating = inner.load_rating(ROLLERS)
    of_edge = edge_function(30)
    # As many digits as the published figures have.
    checks = [
        Check(
            "ISO 281: b_m f_c", _STANDARD, 97.126, rating / (9.6 ** (7 / 9) * ROLLERS**0.75 * 10.0 ** (29 / 27)), 1e-5
        ),
        Check("ISO 281: C_r", _STANDARD, 48416.8, rating, 1e-6, "N"),
        Check("ISO/TS 16281: Q_ci", _STANDARD, 11449.57, inner.capacity(ROLLERS), 1e-6, "N"),
        Check("ISO/TS 16281: Q_ce", _STANDARD, 17271.62, outer.capacity(ROLLERS), 1e-6, "N"),
        Check("ISO/TS 16281: edge stress of the first of 30 laminae", _STANDARD, 2.3283, float(of_edge[0]), 3e-5),
        Check("ISO/TS 16281: edge stress of the second", _STANDARD, 1.1266, float(of_edge[1]), 5e-5),
    ]
    tilt = 0.1e-3
    roller = Roller(diameter=20.0, length=20.0, material=STEEL, side_faces="mirror")
    solution = solve(Contact(roller, Ring(diameter=RING_DIAMETER, material=STEEL)), load=LOAD, tilt=tilt)
    slices = laminae_of(solution, iso_16281(line_loads="standard"))
    y = 0.5 * (slices.edges[1:] + slices.edges[:-1])
    # Slices deform by the tilt times y: each as one contact deforms whose total load is that of the slice.
    yielding = (slices.load * y.size) ** 0.9 / 20.0**0.8
    per_load = tilt * float(np.ptp(y) / np.ptp(yielding))
    checks.append(
        Check("ISO/TS 16281: yielding of one contact over Q^0.9 / L^0.8", _STANDARD, _STIFFNESS, per_load, 2e-5)
    )
    return checks


def _constant() -> list[Check]:
    """Return that laminae loaded by their pressures are those of Eqs. (58) and (59) with the constant 271."""
    steel, laminae = Material(210000.0, 0.3), 30
    checks = []
    for name, ring, sign in (("inner", 55.0, -1.0), ("outer", -75.0, 1.0)):
        contact = Contact(
            Roller(diameter=10.0, length=9.6, material=steel, side_faces="mirror"), Ring(diameter=ring, material=steel)
        )
        solution = solve(contact, load=2000.0, tilt=0.2e-3, strips=laminae)
        found = laminae_of(solution, iso_16281(laminae=laminae))
        width = 10.0 * (1.0 + sign * 10.0 / 65.0) * 9.6 / laminae
        expected = (solution.centre_pressure / 271.0) ** 2 * width
        worst = int(np.argmax(np.abs(found.factor * found.load / expected - 1.0)))
        claim = f"{name} ring, E = 210000: f q of the lamina that differs most"
        computed = float(found.factor[worst] * found.load[worst])
        # 271 has three digits: with this modulus it is 271.03.
        checks.append(Check(claim, "ISO/TS 16281, Eqs. (58), (59)", float(expected[worst]), computed, 5e-4, "N"))
    return checks


def _by_hand() -> float:
    return 1.0 / sum(hours / life for hours, life in zip(_HOURS, _LIVES, strict=True))


def _miner() -> list[Check]:
    loads = [LOAD_ON_LINE * (_LIVES[0] / life) ** 0.25 for life in _LIVES]
    solutions = [_line(load) for load in loads]
    checks = []
    for name in ("lundberg-palmgren", "iso-16281"):
        (longest,), (mixed,) = (
            assess(solutions[0], name, body="b"),
            assess(list(zip(solutions, _HOURS, strict=True)), name, body="b"),
        )
        lived = _LIVES[0] * mixed.over(longest)
        checks.append(
            Check(f"{name}: life under three loads", "Palmgren & Miner, by hand", _by_hand(), lived, 1e-4, "h")
        )
    return checks


def _draw(tilted: dict[float, Solution], known: tuple[Life, ...], figure: Figure) -> None:
    left, right = figure.subplots(1, 2)
    loads = np.geomspace(0.5, 2.0, 5) * LOAD_ON_LINE
    models = [lundberg_palmgren(), zaretsky(), weibull(), ioannides_harris()]
    lives = [assess(_line(load), models, body="b") for load in loads]
    styles = ((FIRST, "-"), (SECOND, "--"), (INK, ":"), (FAINT_INK, "-."))
    for i, (model, (colour, dashes)) in enumerate(zip(models, styles, strict=True)):
        lived = np.array([each[i].damage for each in lives]) ** (-1.0 / model.slope)
        left.loglog(
            1e-3 * loads / LENGTH, lived / lived[loads.size // 2], color=colour, linestyle=dashes, label=model.name
        )
    left.set(xlabel="load per length (kN/mm)", ylabel="life / life under 1 kN/mm", xlim=(0.5, 2.0))
    left.set_xticks([0.5, 1.0, 2.0], ["0.5", "1", "2"])
    left.minorticks_off()
    left.legend(loc="upper right")
    for (tilt, solution), (colour, dashes) in zip(tilted.items(), styles, strict=False):
        life, *_ = known if tilt == TILTS[1] else assess(solution, "lundberg-palmgren", body="b")
        words = f"{1e3 * tilt:g} mrad: life {life.relative:.2f}"
        right.semilogy(life.y, life.density, color=colour, linestyle=dashes, label=words)
    right.set(xlabel="y (mm)", ylabel="damage / ideal", xlim=(-10.0, 10.0), ylim=(1e-3, 10.0))
    right.legend(loc="lower center")
