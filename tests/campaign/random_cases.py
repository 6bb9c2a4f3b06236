"""Random contacts over the whole range that the package is meant for, each reproducible from its number.

Even numbers are half-spaces; odd ones are bodies that end and have a thickness, with every rule for faces, images
and depth, and with faces that lie apart, together and all but together.
"""

import math
from dataclasses import dataclass

import numpy as np
from shapes import Wave

import nonhertz as nh
from nonhertz.model.profile import Profile

SEED = 19980901
MOST_STRIPS_OF_MANY_IMAGES = 60  # so that the campaign ends in minutes


@dataclass(frozen=True)
class Parabola(Profile):
    """Relief height (2 y / length)^2 past a straight middle."""

    height: float
    length: float
    straight: float

    def relief(self, y):
        past = np.maximum(np.abs(y) - 0.5 * self.straight, 0.0) / (0.5 * (self.length - self.straight))
        return self.height * past**2


@dataclass(frozen=True)
class Scale:
    """What a contact is drawn from: sizes of the first body, and a load that presses about as hard as wanted."""

    diameter: float
    length: float
    other_diameter: float | None
    half_width: float
    line_load: float
    compliances: tuple[float, float]

    @classmethod
    def drawn(cls, rng, materials):
        diameter = log_uniform(rng, 2.0, 2000.0)
        length = diameter * log_uniform(rng, 0.2, 20.0)
        other = second_diameter(rng, diameter)
        rho = 1.0 / (2.0 / diameter + (2.0 / other if other else 0.0))
        compliances = tuple(material.compliance for material in materials)
        hertz_pressure = log_uniform(rng, 1e-5, 0.02) * min(material.modulus for material in materials)
        half_width = 2.0 * math.pi * sum(compliances) * hertz_pressure * rho
        return cls(diameter, length, other, half_width, 0.5 * math.pi * half_width * hertz_pressure, compliances)

    def approach(self, depths=(math.inf, math.inf)):
        """The approach of a straight contact, roughly; ``depths`` of both bodies, infinite for half-spaces."""
        return sum(
            compliance * self.line_load * (2.0 * math.log(max(2.0 * reach / self.half_width, 3.0)) + 1.0)
            for compliance, depth in zip(self.compliances, depths, strict=True)
            for reach in (min(self.length, depth),)
        )


def random_case(number):
    """Contact, prescribed quantities and options."""
    rng = np.random.default_rng([SEED, number])
    return finite_bodies(rng) if number % 2 else half_spaces(rng)


def first_body(rng, scale, material, approach, **changes):
    """The first body, of the sizes of a scale."""
    relief = profile(rng, approach, scale.length)
    return nh.Body(diameter=scale.diameter, length=scale.length, material=material, profile=relief, **changes)


def half_spaces(rng):
    materials = [nh.Material(modulus=log_uniform(rng, 1e3, 7e5), poisson=rng.uniform(0.0, 0.49)) for _ in "ab"]
    scale = Scale.drawn(rng, materials)
    approach = scale.approach()
    contact = nh.Contact(
        first_body(rng, scale, materials[0], approach, side_faces="none"),
        nh.Body(diameter=scale.other_diameter, material=materials[1]),
    )
    return contact, prescribed(rng, contact, scale, approach), options(rng)


def finite_bodies(rng):
    modulus = log_uniform(rng, 1e3, 7e5)
    moduli = (modulus, modulus * log_uniform(rng, 0.1, 10.0))
    materials = [nh.Material(modulus=value, poisson=poisson(rng)) for value in moduli]
    scale = Scale.drawn(rng, materials)
    depths = [depth(rng, diameter, scale.half_width) for diameter in (scale.diameter, scale.other_diameter)]
    below = (thickness(depths[0], scale.diameter), thickness(depths[1], scale.other_diameter))
    approach = scale.approach(below)
    position = float(rng.choice([0.0, 1.0]) * rng.uniform(-0.3, 0.3) * scale.length)
    length, offset = second_length(rng, scale.length)
    images = [number_of_images(rng, rule) for rule in depths]
    faces = [side_faces(rng), "none" if length is None else side_faces(rng)]
    contact = nh.Contact(
        first_body(
            rng,
            scale,
            materials[0],
            approach,
            position=position,
            side_faces=faces[0],
            images=images[0],
            depth=depths[0],
        ),
        nh.Body(
            diameter=scale.other_diameter,
            length=length,
            material=materials[1],
            position=position + offset,
            side_faces=faces[1],
            images=images[1],
            depth=depths[1],
        ),
    )
    chosen = options(rng)
    if chosen["strips"] is not None and any(number not in {1, 2} for number in images):
        chosen["strips"] = min(chosen["strips"], MOST_STRIPS_OF_MANY_IMAGES)
    return contact, prescribed(rng, contact, scale, approach), chosen


def profile(rng, approach, length):
    """A profile whose relief at the end is somewhere about the approach, far less or far more."""
    kind = rng.choice(["straight", "crown", "partial crown", "logarithmic", "wave"])
    height = approach * rng.choice([0.0, log_uniform(rng, 1e-2, 100.0)], p=[0.1, 0.9])
    if kind == "straight":
        return nh.profile.straight()
    if kind == "crown":
        return Parabola(height, length, 0.0)
    if kind == "partial crown":
        return Parabola(height, length, length * rng.uniform(0.1, 0.9))
    if kind == "logarithmic":
        return nh.profile.logarithmic(amplitude=height / 8.0, length=length, fraction=0.9999)
    return Wave(height, length / int(rng.integers(1, 4)), rng.uniform(0.0, math.pi))


def prescribed(rng, contact, scale, approach):
    """Two of approach, load, tilt and moment."""
    low, high = contact.interval
    length, middle = high - low, 0.5 * (low + high)
    # Tilt that lifts half the length off: the interference vanishes in the middle, twice the mean at the end.
    tilt = rng.choice([0.0, 1.0], p=[0.2, 0.8]) * rng.uniform(-1.0, 1.0) * 2.0 * approach / length
    load = scale.line_load * length
    by_load, by_moment = rng.integers(2, size=2)
    wanted = {}
    if by_load:
        wanted["load"] = load
    else:
        y = middle + np.linspace(-0.499 * length, 0.499 * length, 4001)
        wanted["approach"] = approach + float(np.min(contact.separation(y) - (0.0 if by_moment else tilt) * y))
    if by_moment:
        # The resultant of half a lifted contact lies a third of the length from the middle.
        share = tilt * length / (2.0 * approach) / 3.0
        wanted["moment"] = (middle + share * length) * load * (1.0 if by_load else 0.3)
    else:
        wanted["tilt"] = tilt
    return wanted


def options(rng):
    strips = None if rng.random() < 0.15 else round(log_uniform(rng, 5, 400))
    return {"strips": strips, "element": (nh.SEMI_ELLIPTIC, nh.PARABOLIC)[rng.integers(2)]}


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def poisson(rng):
    return (0.0, 0.5, rng.uniform(0.0, 0.5))[rng.choice(3, p=[0.05, 0.05, 0.9])]


def second_diameter(rng, diameter):
    kind = rng.integers(3)
    if kind == 0:
        return None
    return diameter * log_uniform(rng, 1.0, 30.0) if kind == 1 else -diameter * log_uniform(rng, 1.2, 30.0)


def second_length(rng, length):
    """Length of the second body, None for no end, and where its middle lies from that of the first."""
    kind = rng.choice(["endless", "narrower", "wider", "overlapping", "coincident", "nearly", "shifted a little"])
    if kind == "endless":
        return None, 0.0
    if kind == "coincident":
        return length, 0.0
    if kind == "shifted a little":
        return length, rng.choice([-1.0, 1.0]) * min(log_uniform(rng, 1e-9, 1.0), 0.3 * length)
    if kind == "nearly":
        return length + rng.choice([-1.0, 1.0]) * min(log_uniform(rng, 1e-9, 1.0), 0.3 * length), 0.0
    if kind == "overlapping":
        return length * log_uniform(rng, 0.5, 2.0), rng.uniform(-0.5, 0.5) * length
    other = length * (rng.uniform(0.3, 0.99) if kind == "narrower" else log_uniform(rng, 1.01, 3.0))
    return other, rng.choice([0.0, 1.0]) * rng.uniform(-0.5, 0.5) * (other - length)


def side_faces(rng):
    rules = [
        ("none", "mirror", "calibrated", rng.uniform(0.0, 2.0))[rng.choice(4, p=[0.15, 0.3, 0.25, 0.3])] for _ in "lh"
    ]
    return rules[0] if rng.random() < 0.75 else tuple(rules)


def depth(rng, diameter, half_width):
    """A rule for the depth, mostly one that the contact is not too wide for."""
    if rng.random() < 0.35:
        return "none"
    if diameter is not None and diameter > 0.0 and rng.random() < 0.6:
        return rng.choice(["plane-strain", "diameter"]).item()
    return max(log_uniform(rng, 0.5, 100.0), half_width * log_uniform(rng, 0.7, 10.0))


def thickness(rule, diameter):
    if isinstance(rule, str):
        return math.inf if rule == "none" else diameter
    return rule


def number_of_images(rng, depth_rule):
    number = (1, 2, 5, "series")[rng.choice(4, p=[0.84, 0.07, 0.04, 0.05])]
    return 1 if number == "series" and depth_rule == "none" else number
