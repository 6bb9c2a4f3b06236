"""Random rollers on rings and plates as engineers draw them, each reproducible from its number."""

from dataclasses import replace

import numpy as np

import nonhertz as nh

SEED = 20261122
HALF_SPACE = {"side_faces": "none", "depth": "none"}
MIRRORED = {"side_faces": "mirror", "depth": "plane-strain"}


def roller_case(number):
    """Contact and what is prescribed, of rollers with free ends, whole ones or with a depth, mostly with corners."""
    rng = np.random.default_rng([SEED, 1, number])
    diameter = rng.uniform(6.0, 40.0)
    length = diameter * rng.choice([0.7, 1.0, 1.6, 2.5])  # each takes a second before its first roller
    load = length * diameter / 20.0 * 10.0 ** rng.uniform(1.7, 3.3)
    given = {"side_faces": "free", "depth": rng.choice(["finite", "finite", "plane-strain", "none"])}
    corner = diameter * rng.uniform(0.02, 0.1)
    way = rng.integers(4)
    if way < 2:
        given["corner_radius"] = corner
    elif way == 2:
        angle = rng.uniform(0.1, 0.6)
        given["chamfer"] = nh.Chamfer(corner, angle, blend_radius=corner * rng.uniform(0.3, 0.9) / np.sin(angle))
    roller = nh.Roller(diameter=diameter, length=length, profile=profile(rng, diameter, length, load), **given)
    other = other_body(rng, diameter, length)
    if other.length is not None and rng.random() < 0.5:
        other = replace(other, side_faces="free")
    return pressed(rng, roller, other, load)


def cornered_case(number):
    """The same of partial crowns that end in rounded corners, of any fineness."""
    rng = np.random.default_rng([SEED, 2, number])
    diameter = rng.uniform(6.0, 40.0)
    length = diameter * rng.choice([0.7, 1.0, 1.6, 2.5])
    load = length * diameter / 20.0 * 10.0 ** rng.uniform(1.7, 3.3)
    straight = length * rng.uniform(0.3, 0.8)
    shape = nh.profile.partial_crown(length * rng.uniform(10.0, 60.0), straight, blended=bool(rng.random() < 0.6))
    corner = diameter * 10.0 ** rng.uniform(-3.5, -1.0)
    ends = ({}, HALF_SPACE, MIRRORED)[rng.integers(3)]
    roller = nh.Roller(diameter=diameter, length=length, profile=shape, corner_radius=corner, **ends)
    return pressed(rng, roller, other_body(rng, diameter, length), load)


def pressed(rng, roller, other, load):
    """Contact and what is prescribed."""
    contact, length = nh.Contact(roller, other), roller.length
    tilt = rng.choice([0.0, 1.0]) * rng.uniform(-1e-3, 1e-3)
    way = rng.integers(4)
    if way == 0:
        return contact, {"approach": nh.solve(contact, load=load, tilt=tilt).approach, "tilt": tilt}
    if way == 1:
        return contact, {"load": load, "moment": load * length * rng.uniform(-0.1, 0.1)}
    return contact, {"load": load, "tilt": tilt}


def profile(rng, diameter, length, load):
    """One of the usual profiles, from too little relief to too much."""
    make, drop_of_one = nh.profile, length**2 / 8.0  # the radius of a crown that falls by 1 mm at its ends
    radius = drop_of_one / 10.0 ** rng.uniform(-3.0, -2.0)
    drawn = {
        "straight": make.straight,
        "crown": lambda: make.crown(drop_of_one / 10.0 ** rng.uniform(-2.5, -1.0)),
        "logarithmic": lambda: make.iso_logarithmic(diameter=diameter, length=length),
        "two radii": lambda: make.two_radius(radius, radius / rng.uniform(3.0, 20.0), length * rng.uniform(0.4, 0.8)),
        "partial crown": lambda: make.partial_crown(length * rng.uniform(10.0, 60.0), length * rng.uniform(0.3, 0.8)),
        "lundberg": lambda: make.lundberg(load=load * rng.uniform(0.5, 1.5), length=length, radius=0.5 * diameter),
        "tapered ends": lambda: make.tapered_ends(length * rng.uniform(0.3, 0.8), 10.0 ** rng.uniform(-3.3, -2.0)),
    }
    return drawn[rng.choice(list(drawn))]()


def other_body(rng, diameter, length):
    """A plate, or a ring inside or outside, with its ends near those of the roller or far away."""
    if rng.random() < 0.3:
        return nh.Plate()
    ring = diameter * rng.uniform(2.0, 8.0) * rng.choice([-1.0, 1.0])
    return nh.Ring(
        diameter=ring, length=None if rng.random() < 0.6 else length * rng.uniform(0.9, 1.3), side_faces="mirror"
    )
