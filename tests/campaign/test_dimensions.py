"""Whole rollers that differ a little in one dimension have no steps between them."""

import dataclasses
import math

import numpy as np
import pytest
from extent import extent

import nonhertz as nh
from nonhertz.bodies import smooth_part
from nonhertz.bodies.harmonic_elements import HarmonicElements
from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.outline import outline_of

SEED = 20261124
PAIRS, SOME_PAIRS = 100, 6
APART = 1e-7  # mm


ROUND = (0.5, 0.75, 1.0, 1.2, 1.5, 2.0)  # lengths over diameters


def random_roller(rng):
    diameter = 10.0 ** rng.uniform(0.7, 1.6)
    ratio = rng.choice(ROUND) if rng.random() < 0.3 else 10.0 ** rng.uniform(-0.5, 0.5)
    length = diameter * ratio
    crown = nh.profile.crown(radius=length**2 / (8.0 * diameter * 10.0 ** rng.uniform(-4.0, -2.7)))
    return nh.Roller(
        diameter=diameter,
        length=length,
        profile=crown if rng.random() < 0.5 else nh.profile.straight(),
        bore=diameter * rng.uniform(0.2, 0.8) if rng.random() < 0.4 else None,
        corner_radius=0.02 * diameter if rng.random() < 0.3 else None,
    )


def random_case(rng, roller):
    load = 10.0 ** rng.uniform(-3.5, -2.2) * 2e3 * roller.diameter * roller.length * (0.1 if roller.bore else 1.0)
    return {"load": load, "tilt": rng.choice([0.0, 1.0]) * rng.uniform(-5e-4, 5e-4)}


def dimension(rng, roller):
    return str(rng.choice(["diameter", "length"] if roller.bore is None else ["diameter", "length", "bore"]))


def counts(roller):
    """The whole numbers that follow from a shape: polynomials, and elements along and across."""
    outline, _ = outline_of(roller)
    terms, most = smooth_part.terms_along(outline), smooth_part.modes_around(outline)
    elements = HarmonicElements(outline, 0.3, most, smooth_part.PER_TERM * outline.half_length / terms)
    return math.ceil(terms), elements.axial_borders.size, elements.wall_borders.size


def pair(rng, *, at_step):
    """Two rollers that are almost alike, between which a whole number changes if that is asked for."""
    while True:
        roller = random_roller(rng)
        name = dimension(rng, roller)

        def made(value, roller=roller, name=name):
            return dataclasses.replace(roller, **{name: value})

        low, high = getattr(roller, name), 1.05 * getattr(roller, name)
        if not at_step:
            return roller, made(low + APART)
        if counts(made(low)) == counts(made(high)):
            continue
        while high - low > 0.5 * APART:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if counts(made(middle)) == counts(made(low)) else (low, middle)
        return made(high - 0.5 * APART), made(high + 0.5 * APART)


@pytest.mark.campaign
def test_rollers_that_are_almost_alike_have_almost_the_same_contact():
    ring = nh.Ring(diameter=80.0)
    for number in range(extent(PAIRS, SOME_PAIRS)):
        rng = np.random.default_rng([SEED, number])
        rollers = pair(rng, at_step=number % 2 == 0)
        given = random_case(rng, rollers[0])
        with without_accuracy_warnings():
            one, other = (nh.solve(nh.Contact(roller, ring), **given) for roller in rollers)
        assert other.approach == pytest.approx(one.approach, rel=1e-5), (number, rollers)
        assert other.max_pressure == pytest.approx(one.max_pressure, rel=1e-5), (number, rollers)
