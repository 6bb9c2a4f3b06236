"""20,000 random cases: every one converges, and every answer is checked without the solver's own loops."""

import math
import os
import warnings
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.profile import Profile

CASES = 20_000
SEED = 19980901
CHUNK = 250


@dataclass(frozen=True)
class Wave(Profile):
    """Waviness along the axis, so that a contact falls apart."""

    height: float
    length: float
    waves: int
    phase: float

    def relief(self, y):
        return self.height * (0.5 - 0.5 * np.cos(2.0 * np.pi * self.waves * np.asarray(y) / self.length + self.phase))


@dataclass(frozen=True)
class Parabola(Profile):
    """Relief height (2 y / length)^2 past a straight middle."""

    height: float
    length: float
    straight: float

    def relief(self, y):
        past = np.maximum(np.abs(y) - 0.5 * self.straight, 0.0) / (0.5 * (self.length - self.straight))
        return self.height * past**2


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def profile(rng, kind, height, length):
    """A profile whose relief at the end is about ``height``."""
    if kind == "straight":
        return nh.profile.straight()
    if kind == "crown":
        return Parabola(height, length, 0.0)
    if kind == "partial crown":
        return Parabola(height, length, length * rng.uniform(0.1, 0.9))
    if kind == "logarithmic":
        return nh.profile.logarithmic(amplitude=height / 8.0, length=length, fraction=0.9999)
    return Wave(height, length, int(rng.integers(1, 4)), rng.uniform(0.0, math.pi))


def second_diameter(rng, diameter):
    kind = rng.integers(3)
    if kind == 0:
        return None
    return diameter * log_uniform(rng, 1.0, 30.0) if kind == 1 else -diameter * log_uniform(rng, 1.2, 30.0)


def random_case(seed):
    """Contact, prescribed quantities and options of one case, over the whole range that the package is meant for."""
    rng = np.random.default_rng([SEED, seed])
    diameter = log_uniform(rng, 2.0, 2000.0)
    length = diameter * log_uniform(rng, 0.2, 20.0)
    materials = [nh.Material(modulus=log_uniform(rng, 1e3, 7e5), poisson=rng.uniform(0.0, 0.49)) for _ in "ab"]
    other = second_diameter(rng, diameter)
    rho = 1.0 / (2.0 / diameter + (2.0 / other if other else 0.0))
    compliance = sum(material.compliance for material in materials)
    hertz_pressure = log_uniform(rng, 1e-5, 0.02) * min(material.modulus for material in materials)
    half_width = 2.0 * math.pi * compliance * hertz_pressure * rho
    line_load = 0.5 * math.pi * half_width * hertz_pressure
    approach = compliance * line_load * (2.0 * math.log(max(2.0 * length / half_width, 3.0)) + 1.0)
    kind = rng.choice(["straight", "crown", "partial crown", "logarithmic", "wave"])
    height = approach * rng.choice([0.0, log_uniform(rng, 1e-2, 100.0)], p=[0.1, 0.9])
    contact = nh.Contact(
        nh.Body(diameter=diameter, length=length, material=materials[0], profile=profile(rng, kind, height, length)),
        nh.Body(diameter=other, material=materials[1]),
    )
    # Tilt that lifts half the length off: the interference vanishes in the middle, twice the mean at the end.
    tilt = rng.choice([0.0, 1.0], p=[0.2, 0.8]) * rng.uniform(-1.0, 1.0) * 2.0 * approach / length
    load = line_load * length
    by_load, by_moment = rng.integers(2, size=2)
    strips = None if rng.random() < 0.15 else round(log_uniform(rng, 5, 400))
    prescribed = {}
    if by_load:
        prescribed["load"] = load
    else:
        y = np.linspace(-0.499 * length, 0.499 * length, 4001)
        prescribed["approach"] = approach + float(np.min(contact.separation(y) - (0.0 if by_moment else tilt) * y))
    if by_moment:
        # The resultant of half a lifted contact lies a third of the length from the middle.
        share = tilt * length / (2.0 * approach) / 3.0
        prescribed["moment"] = share * load * length * (1.0 if by_load else 0.3)
    else:
        prescribed["tilt"] = tilt
    element = (nh.SEMI_ELLIPTIC, nh.PARABOLIC)[rng.integers(2)]
    return contact, prescribed, {"strips": strips, "element": element}


def faults(solution, prescribed, automatic):
    """What an independent look at the answer finds wrong with it."""
    touching = solution.line_load > 0.0
    low, high = solution.edges[:-1], solution.edges[1:]
    a = solution.element_half_width[touching]
    upper = solution.element.functions((high[touching] - solution.y[:, None]) / a)
    lower = solution.element.functions((low[touching] - solution.y[:, None]) / a)
    q = solution.line_load[touching]
    compliance = solution.contact.compliance
    displacement = compliance * (upper[0] - lower[0]) @ q
    curvature = compliance * (upper[2] - lower[2])[touching] @ (q / a**2)
    interference = solution.approach + solution.tilt * solution.y - solution.contact.separation(solution.y)
    depth = float(np.max(interference))
    gap = displacement - interference
    load = float(np.sum(solution.line_load * solution.strip_width))
    moment = float(np.sum(solution.line_load * solution.strip_width * solution.y))
    reach = 0.5 * float(np.sum(solution.strip_width))
    checks = {
        "load": abs(load / prescribed.get("load", load) - 1.0),
        "moment": abs(moment - prescribed.get("moment", moment)) / (load * reach),
        "gap in contact": float(np.max(np.abs(gap[touching]))) / depth,
        "penetration": max(0.0, -float(np.min(gap, where=~touching, initial=0.0))) / depth,
        "curvature": float(np.max(np.abs(curvature / solution.contact.curvature(solution.y[touching]) - 1.0))),
        "negative load": 0.0 if np.all(solution.line_load >= 0.0) else 1.0,
        "approach": abs(solution.approach - prescribed.get("approach", solution.approach)) / depth,
        "tilt": abs(solution.tilt - prescribed.get("tilt", solution.tilt)) * reach / depth,
    }
    wrong = [f"{name} {value:.1e}" for name, value in checks.items() if not value < 1e-9]
    overlap = overlap_between_strips(solution) / depth
    # An automatic grid must not miss a place of contact; a speck beside the end of one is within its resolution.
    return wrong + ([f"overlap between strips {overlap:.1e}"] if automatic and overlap > 0.01 else [])


def overlap_between_strips(solution):
    """The deepest overlap at many points on the whole length, away from the intervals in contact."""
    low, high = solution.contact.interval
    y = np.linspace(low, high, 1001)
    for start, end in solution.contact_y:
        margin = 0.03 * (end - start)
        y = y[(y < start - margin) | (y > end + margin)]
    if y.size == 0:
        return 0.0
    touching = solution.line_load > 0.0
    a = solution.element_half_width[touching]
    upper = solution.element.functions((solution.edges[1:][touching] - y[:, None]) / a)[0]
    lower = solution.element.functions((solution.edges[:-1][touching] - y[:, None]) / a)[0]
    displacement = solution.contact.compliance * (upper - lower) @ solution.line_load[touching]
    gap = displacement - (solution.approach + solution.tilt * y - solution.contact.separation(y))
    return max(0.0, -float(np.min(gap)))


def run(seed):
    """Outcome of one case: 'solved', 'refused' or a description of the failure; and the Newton steps."""
    contact, prescribed, options = random_case(seed)
    try:
        solution = nh.solve(contact, **prescribed, **options)
    except nh.InputError as error:
        return ("refused: " + error.field, 0) if foreseen(error) else (f"seed {seed}: {error}", 0)
    except nh.NonhertzError as error:
        return f"seed {seed}: {error}", 0
    wrong = faults(solution, prescribed, options["strips"] is None)
    return (f"seed {seed}: {wrong}" if wrong else "solved"), solution.iterations


def foreseen(error):
    """What no solution exists for: a resultant outside, a contact between strip centres, lift-off at zero moment."""
    return error.field in {"moment", "strips"} or "the moment leads to" in str(error)


def run_chunk(first):
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    return [run(seed) for seed in range(first, first + CHUNK)]


@pytest.mark.campaign
def test_every_sensible_case_converges_to_a_right_answer():
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        outcomes = [outcome for chunk in pool.map(run_chunk, range(0, CASES, CHUNK)) for outcome in chunk]
    counts = Counter(text for text, _ in outcomes if not text.startswith("seed"))
    failures = [text for text, _ in outcomes if text.startswith("seed")]
    steps = [count for text, count in outcomes if text == "solved"]
    percentile = float(np.percentile(steps, 95))
    print(f"\n{dict(counts)}; failures {len(failures)}; Newton steps: 95th percentile {percentile}, max {max(steps)}")
    assert not failures, failures[:20]
    # A refusal is a case that the drawn number of strips cannot carry; there must be next to none.
    assert counts["solved"] >= 0.99 * CASES
    assert percentile <= 12
