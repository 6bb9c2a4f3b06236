"""How often the plane grid's estimate of its own error covers it: random contacts, and the truth from finer cells."""

import math

import numpy as np
import pytest
from extent import extent

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.patch import Dent, Waviness

KINDS = ("ellipse", "crown", "iso", "dent", "waves", "bumps", "balls", "rough", "punch", "wall", "straight", "moment")
PER_KIND, FINER = extent(8, 1), 4
BODY = nh.Contact(nh.Body(diameter=20), nh.Plate())


def paraboloid(generator):
    radius = 10.0 * 10.0 ** generator.uniform(0.0, 2.0)
    return lambda x, y: x**2 / 20.0 + y**2 / (2.0 * radius)


def bumps(generator):
    """A paraboloid with Gaussian bumps, some narrower than a cell."""
    count = int(generator.integers(2, 6))
    places = generator.uniform((-1.0, -2.0), (1.0, 2.0), (count, 2))
    heights, widths = 10.0 ** generator.uniform(-3.0, -1.7, count), 10.0 ** generator.uniform(-1.5, 0.0, count)

    def gap(x, y):
        several = zip(places, heights, widths, strict=True)
        return (
            x**2 / 40.0
            + y**2 / 100.0
            - sum(h * np.exp(-((x - a) ** 2 + (y - b) ** 2) / w**2) for (a, b), h, w in several)
        )

    return gap


def balls(generator):
    apart, radii = generator.uniform(0.05, 2.0), generator.uniform(5.0, 30.0, 2)
    return lambda x, y: np.minimum(
        (x**2 + (y - apart) ** 2) / (2.0 * radii[0]), (x**2 + (y + apart) ** 2) / (2.0 * radii[1])
    )


def rough(generator):
    smooth = paraboloid(generator)
    waves = [
        Waviness(
            amplitude=10.0 ** generator.uniform(-5.0, -3.3),
            wavelength=10.0 ** generator.uniform(-1.3, 0.3),
            direction=generator.uniform(-1.5, 1.5),
        )
        for _ in range(6)
    ]
    return lambda x, y: smooth(x, y) + sum(wave(x, y) for wave in waves)


def punch(generator):
    radius = generator.uniform(0.5, 20.0)
    return lambda x, y: np.where(x**2 + y**2 <= radius**2, 1e-4 * (x**2 + y**2), math.inf)


def wall(generator):
    at, smooth = generator.uniform(0.02, 0.5), paraboloid(generator)
    return lambda x, y: np.where(x < at, smooth(x, y), math.inf)


GAPS = {"ellipse": paraboloid, "bumps": bumps, "balls": balls, "rough": rough, "punch": punch, "wall": wall}


def roller_case(kind, generator):
    diameter = generator.uniform(6.0, 40.0)
    length = generator.uniform(0.8, 2.0) * diameter
    crown = nh.profile.crown(10.0 ** generator.uniform(2.0, 3.7))
    profile = {"iso": nh.profile.iso_logarithmic(diameter=diameter, length=length), "straight": None}.get(kind, crown)
    roller = nh.Roller(diameter=diameter, length=length, **({} if profile is None else {"profile": profile}))
    load = diameter * length * 10.0 ** generator.uniform(-0.5, 1.2)
    contact = nh.Contact(roller, nh.Plate())
    width = math.sqrt(contact.compliance * load / length * diameter)
    given = {"load": load}
    if kind == "moment":
        given["moment"] = load * length * generator.uniform(-0.25, 0.25)
    if kind == "dent":
        size = width * 10.0 ** generator.uniform(-0.3, 0.8)
        given["features"] = Dent(x=generator.uniform(-0.5, 0.5) * width, depth=0.002, diameter=size)
    if kind == "waves":
        amplitude, length = 10.0 ** generator.uniform(-4.5, -3.0), width * 10.0 ** generator.uniform(-0.2, 1.3)
        given["features"] = Waviness(amplitude=amplitude, wavelength=length, direction=generator.uniform(-1.5, 1.5))
    return contact, given


def case(kind, generator):
    if kind not in GAPS:
        return roller_case(kind, generator)
    return BODY, {"gap": GAPS[kind](generator), "load": 10.0 ** generator.uniform(1.5, 4.0)}


def region_of(solution):
    half = 0.5 * solution.dx, 0.5 * solution.dy
    return tuple((each[0] - more, each[-1] + more) for each, more in zip((solution.x, solution.y), half, strict=True))


def stated_over_true(kind, number):
    """Return what the estimate of approach and of the maximum pressure is of the true error; infinite where it is."""
    generator = np.random.default_rng((KINDS.index(kind), number))
    contact, given = case(kind, generator)
    cells = int(generator.integers(16, 49)), int(generator.integers(24, 97))
    with without_accuracy_warnings():
        found = nh.patch.solve(contact, cells=cells, **given)
        finer = tuple(FINER * count for count in cells)
        true = nh.patch.solve(contact, cells=finer, region=region_of(found), tolerance=1e-6, **given)
    of_approach = abs(found.approach - true.approach) / true.penetration
    errors = of_approach, abs(found.max_pressure / true.max_pressure - 1.0)
    return found.error_estimate.approach / errors[0], found.error_estimate.max_pressure / errors[1]


@pytest.mark.campaign
def test_the_estimate_covers_the_error_of_nearly_all_random_contacts():
    ratios = np.array([stated_over_true(kind, number) for kind in KINDS for number in range(PER_KIND)])
    covered = np.mean(ratios > 1.0, axis=0)
    assert np.all(covered >= 0.97), covered
    # By several times, not by orders of magnitude.
    assert np.all(np.median(np.where(np.isinf(ratios), np.nan, ratios)[~np.isinf(ratios).any(axis=1)], axis=0) < 50.0)
