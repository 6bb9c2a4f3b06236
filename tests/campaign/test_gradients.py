"""300 random contacts: gradients by one adjoint solve beside contacts that are solved again on the same strips."""

import numpy as np
import pytest
from extent import extent

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.gradient import family_of
from nonhertz.result.measures import measure_of

CASES, SOME = 300, 12
SEED = 20261123
CLOSE = 1e-6  # relative to the number itself, for a parameter that changes by itself
POINTS = ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12))
HOLDING = [("load", "tilt"), ("approach", "tilt"), ("load", "moment"), ("approach", "moment")]


def random_solution(rng):
    diameter, length = 10.0 ** rng.uniform(0.3, 1.7), 10.0 ** rng.uniform(0.5, 1.5)
    # At 5 diameters the number of polynomials of a whole roller changes, and with it the sixth digit.
    length = min(max(length, 0.3 * diameter), 4.7 * diameter)
    profile = [
        nh.profile.crown(length**2 / (8.0 * diameter * 10.0 ** rng.uniform(-4.0, -2.3))),
        nh.profile.iso_logarithmic(diameter=diameter, length=length),
        nh.profile.partial_crown(300.0 * length, 0.5 * length),
    ][rng.integers(3)]
    material = nh.Material(modulus=10.0 ** rng.uniform(4.5, 5.4), poisson=rng.uniform(0.15, 0.4))
    roller = nh.Roller(
        diameter=diameter,
        length=length,
        profile=profile,
        corner_radius=0.03 * diameter if rng.random() < 0.5 else None,
        side_faces=str(rng.choice(["free", "mirror", "none"])),
        material=material,
    )
    across = diameter * 10.0 ** rng.uniform(0.3, 1.0) * rng.choice([-1.0, 1.0])
    depth = {"depth": 0.7 * diameter} if rng.random() < 0.5 else {}
    other = nh.Plate(**depth) if rng.random() < 0.2 else nh.Ring(diameter=across, **depth)
    load = 10.0 ** rng.uniform(-4.0, -1.7) * 2e5 * diameter * length / 100.0
    strips = int(rng.integers(15, 90))
    return nh.solve(
        nh.Contact(roller, other), load=load, tilt=rng.choice([0.0, 1.0]) * rng.uniform(-8e-4, 8e-4), strips=strips
    )


def random_measure(rng, solution):
    low, high = solution.contact_y[0]
    y = low + rng.uniform(0.05, 0.95) * (high - low)
    kinds = ["approach", "load", "tilt", "moment", "max_pressure", "max_half_width", nh.study.PressureAt(y)]
    kinds += [nh.study.HalfWidthAt(y), nh.study.PressureNorm(rng.uniform(2.0, 40.0))]
    kinds += [nh.study.PowerIntegral(rng.uniform(1.0, 11.0), rng.uniform(-2.0, 5.0))]
    return kinds[rng.integers(len(kinds))]


def fault(number):
    """What is wrong with a random gradient; None if nothing is, or if the number has a kink there."""
    rng = np.random.default_rng([SEED, number])
    with without_accuracy_warnings():
        solution = random_solution(rng)
        quantity, holding = random_measure(rng, solution), HOLDING[rng.integers(4)]
        found = solution.gradient(quantity, holding=holding)
        relief = "amplitude" if hasattr(solution.contact.a.profile, "amplitude") else "end_radius"
        paths = ["a.diameter", f"a.profile.{relief}", "a.material.modulus", "b.material.modulus", "given"]
        path = str(rng.choice(paths))
        if path == "given":
            name = holding[rng.integers(2)]
            at, derivative = getattr(solution, name), found.given[name]
            size = abs(at) if name in GIVEN_SIZES else 1e-4 if name == "tilt" else solution.load
        else:
            name, (family, at) = None, family_of(solution.contact, path)
            derivative, size = found.by(path), at

        def again(value):
            given = {each: getattr(solution, each) for each in holding}
            contact = solution.contact if name else family(value)
            given |= {name: value} if name else {}
            return nh.solve(contact, strips=solution.edges, **given)

        for relative in (2e-4, 2e-5, 4e-6):
            step = relative * size
            others = [again(at + steps * step) for steps, _ in POINTS]
            if all(alike(each, solution, quantity) for each in others):
                break
        else:
            return None
    values = [measure_of(quantity).partials(each).value for each in others]
    expected = sum(weight * value for (_, weight), value in zip(POINTS, values, strict=True)) / step
    # Equations are solved to 1e-11; what the shape of a whole roller adds is known to some nine digits.
    digits = 3e-9 if path == "a.diameter" else 1e-10
    scale = max(abs(found.value), scale_of(quantity, solution))
    off = abs(derivative - expected) * size / scale
    return (
        None
        if off <= max(CLOSE, digits / relative, CLOSE * abs(expected) * size / scale)
        else (number, str(quantity), holding, path, off, relative)
    )


GIVEN_SIZES = ("load", "approach")


def scale_of(quantity, solution):
    return {"moment": solution.load * 1.0, "tilt": 1e-4}.get(quantity, 0.0) if isinstance(quantity, str) else 0.0


def alike(one, other, quantity):
    """Whether there is no kink between two solutions."""
    same = np.array_equal(one.half_width > 0.0, other.half_width > 0.0)
    if quantity in ("max_pressure", "max_half_width"):
        return same and abs(one.max_pressure_y - other.max_pressure_y) < 1e-3 * np.diff(other.edges).min()
    return same


@pytest.mark.campaign
def test_random_gradients():
    found = [fault(number) for number in range(extent(CASES, SOME))]
    wrong = [each for each in found if each]
    assert not wrong, (len(wrong), wrong[:10])
