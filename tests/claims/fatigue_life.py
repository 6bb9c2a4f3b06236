"""Fatigue life: exponents, ideal integrals, the figures of ISO/TS 16281, and life on strips against a plane grid."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator

import numpy as np

from claims.claim import Array, Claim, Evidence, solved
from claims.subsurface_stress import LOAD, RING_DIAMETER, STEEL, TILT, mcewen, tilted_on_strips
from nonhertz import Contact, Material, Ring, Roller, Solution, solve
from nonhertz.hertz import line_contact
from nonhertz.life import MODELS, Life, Model, Raceway, VolumeModel, assess, ioannides_harris, iso_16281
from nonhertz.life.lamina import edge_function, laminae_of
from nonhertz.patch import PatchSolution
from nonhertz.patch import solve as solve_patch

DIAMETER, LENGTH, LOAD_ON_LINE = 10.0, 10.0, 10e3  # mm, N
NARROW = 0.05  # mm: width of the outer two of three strips; a line contact is uniform along y and needs no more
CELLS = 192, 64
ROLLERS = 14
_LIVES = (50000.0, 6500.0, 1000.0)  # h
_HOURS = (40.0 / 60.0, 15.0 / 60.0, 5.0 / 60.0)  # of every load in a cycle of one hour
BY_NAME: dict[str, Model] = {name: make() for name, make in MODELS.items()}
# A fatigue limit breaks the laws of the exponents unless it is raised with the pressure.
_LIMITED = "ioannides-harris"


@solved
def line(load: float = LOAD_ON_LINE, length: float = LENGTH) -> Solution:
    """Return a piece of a line contact."""
    roller = Roller(diameter=DIAMETER, length=length, material=STEEL, side_faces="mirror", images="series")
    end = 0.5 * length
    return solve(Contact(roller, roller), load=load, strips=(-end, NARROW - end, end - NARROW, end))


@solved
def lives(load: float = LOAD_ON_LINE, length: float = LENGTH, *, raised: float = 1.0) -> dict[str, Life]:
    """Return the lives of a line contact by all models, with a fatigue limit so many times as high."""
    limit = raised * ioannides_harris().fatigue_limit
    models = BY_NAME | {_LIMITED: ioannides_harris(fatigue_limit=limit)}
    found = assess(line(load, length), list(models.values()), body="b")
    return dict(zip(models, found, strict=True))


@solved
def tilted_lives(method: str) -> dict[str, Life]:
    """Return the lives of the tilted roller by all models, on strips or on cells."""
    solution: Solution | PatchSolution = tilted_on_strips()
    if method == "cells":
        # Many cells across, for the shear just below the surface; along, the pressure is smooth.
        solution = solve_patch(solution.contact, load=LOAD, tilt=TILT, cells=CELLS)
    return dict(zip(BY_NAME, assess(solution, body="b"), strict=True))


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for name in BY_NAME:
        yield from _exponents(name)
    for model in BY_NAME.values():
        if isinstance(model, VolumeModel) and model.fatigue_limit == 0.0:
            yield _integral(model)
    for name in BY_NAME:
        yield Evidence(name, "the ideal pressure", lives).claim(
            "relative life of a line contact", _relative(name), 1e-3, expected=1.0
        )
    yield from _of_standard()
    on_strips, on_grid = (functools.partial(tilted_lives, method) for method in ("strips", "cells"))
    for name in BY_NAME:
        of = Evidence(f"tilted roller, {name}", "plane grid", on_strips, on_grid)
        yield of.claim("relative life", _relative(name), 5e-3)
    by_hand = 1.0 / sum(hours / life for hours, life in zip(_HOURS, _LIVES, strict=True))
    for name in ("lundberg-palmgren", "iso-16281"):
        found = functools.partial(_under_three_loads, name)
        yield Claim(f"{name}: life under three loads", "Palmgren & Miner, by hand", by_hand, found, 1e-4, "h")


def _relative(name: str) -> Callable[[dict[str, Life]], float]:
    return lambda found: found[name].relative_life


def _exponents(name: str) -> Iterator[Claim]:
    """Yield those of load and length: with b and p0 like the root of the load, integrals of s^k / z^h have them."""
    model, source = BY_NAME[name], "b and p0 like the root of the load"
    # That of a lamina's load in the standard is 4.5.
    half = 0.5 * (model.exponent - model.depth_exponent + 1.0) if isinstance(model, VolumeModel) else 4.5

    def of_load() -> float:
        twice = lives(2.0 * LOAD_ON_LINE, raised=math.sqrt(2.0))
        return math.log2(twice[name].damage / lives()[name].damage) / model.slope

    def of_length() -> float:
        longer = lives(LOAD_ON_LINE, 2.0 * LENGTH)
        return math.log2(lives()[name].damage / longer[name].damage) / model.slope

    words, why = f"{name}, its limit raised with the pressure" if name == _LIMITED else name, "three digits"
    yield Claim(f"{words}: life goes with 1/load to the power", source, half / model.slope, of_load, 5e-4, why=why)
    if name != _LIMITED:
        yield Claim(
            f"{words}: life goes with the length to the power", source, (half - 1.0) / model.slope, of_length, 5e-4,
            why=why,
        )  # fmt: skip


def _integral(model: VolumeModel) -> Claim:
    def found() -> float:
        compliance = line().contact.compliance
        hertz = line_contact(line_load=LOAD_ON_LINE / LENGTH, radius=0.25 * DIAMETER, compliance=compliance)
        top = quadrature(model)[0] * hertz.max_pressure
        unit = top**model.exponent * hertz.half_width ** (1.0 - model.depth_exponent)
        return float(lives()[model.name].damage / unit / LENGTH)

    return Claim(
        f"{model.name}: integral of (s/s_max)^{model.exponent:.4g} / z^{model.depth_exponent:.3g} over the depth",
        "quadrature of McEwen's closed form", lambda: quadrature(model)[1], found, 1e-3,
        why="that of lives of smooth contacts",
    )  # fmt: skip


@solved
def quadrature(model: VolumeModel) -> tuple[float, float]:
    """Return the largest stress below Hertz's line contact over p0, and the model's integral over the depth over b."""
    logarithm = np.linspace(math.log(1e-5), math.log(60.0), 1200)
    z = np.exp(logarithm)[:, None]
    x = np.linspace(0.0, 1.0, 601) * (1.2 + z)
    largest = _over(x, z, model.stress)
    top = float(largest.max())
    integrand = (largest / top) ** model.exponent * z[:, 0] ** (1.0 - model.depth_exponent)
    return top, float(np.trapezoid(integrand, logarithm))


def _over(x: Array, z: Array, stress: str) -> Array:
    """Return the largest stress at each depth over p0, by the vertex of a parabola, lengths over b."""
    across, along, below, _, shear, _ = np.moveaxis(mcewen(x, np.broadcast_to(z, x.shape), STEEL.poisson), -1, 0)
    if stress == "orthogonal_shear":
        values = np.abs(shear)
    else:
        middle, half = 0.5 * (across + below), np.sqrt(0.25 * (across - below) ** 2 + shear**2)
        values = np.maximum(half, 0.5 * (half + np.abs(middle - along)))
    best = np.clip(values.argmax(axis=1), 1, x.shape[1] - 2)
    low, top, high = (values[np.arange(best.size), best + step] for step in (-1, 0, 1))
    bend = low - 2.0 * top + high
    vertex = top - np.divide((low - high) ** 2, 8.0 * bend, out=np.zeros_like(top), where=bend < 0.0)
    return np.asarray(np.maximum(vertex, values.max(axis=1)))


def _of_standard() -> Iterator[Claim]:
    """Yield figures of the standards, in as many digits as are published."""
    inner, outer = (Raceway(10.0, 9.6, 65.0, inner) for inner in (True, False))

    def factor() -> float:
        return float(inner.load_rating(ROLLERS) / (9.6 ** (7 / 9) * ROLLERS**0.75 * 10.0 ** (29 / 27)))

    def yielding() -> float:
        tilt = 0.1e-3
        roller = Roller(diameter=20.0, length=20.0, material=STEEL, side_faces="mirror")
        solution = solve(Contact(roller, Ring(diameter=RING_DIAMETER, material=STEEL)), load=LOAD, tilt=tilt)
        slices = laminae_of(solution, iso_16281(line_loads="standard"))
        y = 0.5 * (slices.edges[1:] + slices.edges[:-1])
        # Slices deform by the tilt times y: each as one contact deforms whose total load is that of the slice.
        return tilt * float(np.ptp(y) / np.ptp((slices.load * y.size) ** 0.9 / 20.0**0.8))

    for quantity, expected, found, within, unit in (
        ("ISO 281: b_m f_c", 97.126, factor, 1e-5, ""),
        ("ISO 281: C_r", 48416.8, lambda: inner.load_rating(ROLLERS), 1e-6, "N"),
        ("ISO/TS 16281: Q_ci", 11449.57, lambda: inner.capacity(ROLLERS), 1e-6, "N"),
        ("ISO/TS 16281: Q_ce", 17271.62, lambda: outer.capacity(ROLLERS), 1e-6, "N"),
        ("ISO/TS 16281: edge stress of the first of 30 laminae", 2.3283, lambda: edge_function(30)[0], 3e-5, ""),
        ("ISO/TS 16281: edge stress of the second", 1.1266, lambda: edge_function(30)[1], 5e-5, ""),
        # Of one contact: delta = 3.9707e-5 mm Q^0.9 / L^0.8.
        ("ISO/TS 16281: yielding of one contact over Q^0.9 / L^0.8", 3.9707e-5, yielding, 2e-5, ""),
    ):
        yield Claim(quantity, "ISO 281 and ISO/TS 16281, by public programs", expected, found, within, unit)
    for name, ring, sign in (("inner", 55.0, -1.0), ("outer", -75.0, 1.0)):
        yield _constant(name, ring, sign)


def _constant(name: str, ring: float, sign: float) -> Claim:
    """Return that laminae loaded by their pressures are those of the standard with its constant 271."""
    return Claim(
        f"{name} ring, E = 210000: f q of the lamina that differs most", "ISO/TS 16281, Eqs. (58), (59)",
        lambda: _most_different(ring, sign)[0], lambda: _most_different(ring, sign)[1], 5e-4, "N",
        why="271 has three digits: with this modulus it is 271.03",
    )  # fmt: skip


@solved
def _most_different(ring: float, sign: float) -> tuple[float, float]:
    """Return f q of the lamina on a ring that differs most from Eqs. (58) and (59), by these and as found [N]."""
    steel, laminae = Material(210000.0, 0.3), 30
    roller = Roller(diameter=10.0, length=9.6, material=steel, side_faces="mirror")
    contact = Contact(roller, Ring(diameter=ring, material=steel))
    solution = solve(contact, load=2000.0, tilt=0.2e-3, strips=laminae)
    found = laminae_of(solution, iso_16281(laminae=laminae))
    width = 10.0 * (1.0 + sign * 10.0 / 65.0) * 9.6 / laminae
    expected = (solution.centre_pressure / 271.0) ** 2 * width
    worst = int(np.argmax(np.abs(found.factor * found.load / expected - 1.0)))
    return float(expected[worst]), float(found.factor[worst] * found.load[worst])


def _under_three_loads(name: str) -> float:
    """Return the life [h] under three loads, of which each alone would give a life of its own."""
    solutions = [line(LOAD_ON_LINE * (_LIVES[0] / life) ** 0.25) for life in _LIVES]
    (longest,) = assess(solutions[0], name, body="b")
    (mixed,) = assess(list(zip(solutions, _HOURS, strict=True)), name, body="b")
    return _LIVES[0] * mixed.over(longest)
