"""5,000 random bearings of all kinds under loads up to twice their static rating, with forces summed in space."""

from collections import Counter

import numpy as np
import pytest
from extent import extent
from pool import of_each

import nonhertz as nh
from claims.bearing_sums import sums_in_space
from nonhertz.errors import without_accuracy_warnings

CASES, SOME = 5_000, {"strips": 8, "slices": 40}
SEED = 20261124
BALANCE = 1e-8  # of the loads
KINDS = ("cylindrical", "needle", "ribbed", "tapered", "spherical", "thrust", "X", "O", "tandem")
B = nh.bearing


def random_row(rng, kind):
    diameter = 10.0 ** rng.uniform(0.5, 1.6)
    slender = rng.uniform(3.0, 8.0) if kind == "needle" else rng.uniform(0.8, 2.0)
    length, pitch = slender * diameter, diameter * rng.uniform(4.0, 12.0)
    if kind == "thrust":
        pitch = max(pitch, 2.5 * length)
    most = int(np.pi / np.arcsin(diameter / pitch))
    profile = [
        nh.profile.crown(length**2 / (8.0 * diameter * 10.0 ** rng.uniform(-4.0, -2.7))),
        nh.profile.iso_logarithmic(diameter=diameter, length=length),
        nh.profile.partial_crown(200.0 * length, 0.6 * length),
    ][rng.integers(3)]
    corner = {"corner_radius": 0.03 * diameter} if rng.random() < 0.6 else {}
    given = {
        "rollers": int(rng.integers(max(3, most // 2), most + 1)),
        "pitch_diameter": pitch,
        "inner_shape": _oval(rng, diameter),
        "outer_shape": _oval(rng, diameter),
    }
    clearance = diameter * rng.choice([0.0, 1.0, -0.2]) * 10.0 ** rng.uniform(-4.0, -2.5)
    roller = {"length": length, "profile": profile, **corner}
    depth = {"depth": diameter * rng.uniform(0.3, 1.0)} if rng.random() < 0.5 else {}
    if kind in ("cylindrical", "needle", "ribbed"):
        cls = B.NeedleRollerBearing if kind == "needle" else B.CylindricalRollerBearing
        inner, outer = nh.Ring(diameter=pitch - diameter, **depth), nh.Ring(diameter=-(pitch + diameter), **depth)
        if kind == "ribbed":
            end_radius, height = diameter * 10.0 ** rng.uniform(0.5, 2.0), 0.5 * diameter * rng.uniform(0.5, 0.85)
            given |= {
                "design": str(rng.choice(["NJ", "NF", "NUP"])),
                "rib": B.Rib(end_radius, height, 10.0 * diameter if rng.random() < 0.5 else None),
                "axial_clearance": diameter * rng.choice([0.0, 1.0]) * 10.0 ** rng.uniform(-4.0, -2.5),
            }
        return cls(
            roller=nh.Roller(diameter=diameter, **roller), inner=inner, outer=outer, clearance=clearance, **given
        )
    if kind == "thrust":
        return B.CylindricalThrustBearing(
            roller=nh.Roller(diameter=diameter, **roller), inner=nh.Plate(**depth), outer=nh.Plate(**depth), **given
        )
    angle = rng.uniform(0.1, 0.5)
    across = diameter / np.cos(angle)
    rings = {"inner": nh.Ring(diameter=pitch - across, **depth), "outer": nh.Ring(diameter=-(pitch + across), **depth)}
    if kind == "spherical":
        sphere = 0.5 * pitch / np.cos(angle) + 0.5 * diameter
        return B.SphericalRollerBearing(
            roller=nh.Roller(diameter=diameter, length=length),
            contact_angle=angle,
            profile_radius=rng.uniform(0.95, 0.985) * sphere,
            inner_groove=sphere,
            outer_groove=sphere,
            clearance=clearance,
            **rings,
            **given,
        )
    tip = rng.uniform(0.1, 0.25) * angle
    half = length * np.tan(tip)
    cone = nh.TabulatedDiameter((-0.5 * length, 0.5 * length), (diameter + half, diameter - half))
    # Where cones that meet in one point leave room for the roller between them.
    across = diameter * np.cos(angle - tip) * np.cos(tip) ** 2 / (np.cos(angle) * np.cos(angle - 2.0 * tip))
    rings = {"inner": nh.Ring(diameter=pitch - across, **depth), "outer": nh.Ring(diameter=-(pitch + across), **depth)}
    return B.TaperedRollerBearing(
        roller=nh.Roller(diameter=cone, **roller),
        contact_angle=angle,
        clearance=clearance,
        **rings,
        **(given | {"pitch_diameter": None}),
    )


def _oval(rng, diameter):
    if rng.random() < 0.7:
        return None
    size, waves = diameter * 10.0 ** rng.uniform(-5.0, -3.5), int(rng.integers(2, 5))
    return _Oval(size, waves)


class _Oval:
    def __init__(self, size, waves):
        self.size, self.waves = size, waves

    def __call__(self, angle):
        return self.size * np.cos(self.waves * angle)


def random_bearing(number):
    """A bearing and what acts on it."""
    rng = np.random.default_rng([SEED, number])
    kind = KINDS[rng.integers(len(KINDS))]
    row = random_row(rng, "tapered" if kind in ("X", "O", "tandem") else kind)
    size = 44.0 * row.rollers * row.roller_length * row.roller_diameter * 10.0 ** rng.uniform(-4.0, np.log10(2.0))
    given = {"speed": rng.choice([0.0, 1e4 / row.pitch * 10.0])}
    if kind == "thrust":
        given |= {"axial": size, "tilt": 1e-4 * rng.normal()}
        return row, given
    direction = rng.uniform(0.0, 2.0 * np.pi)
    given["radial"] = (size * np.cos(direction), size * np.sin(direction))
    given["tilt"] = tuple(1e-3 * rng.uniform(-1.0, 1.0, 2))
    if row.nominal_angle:
        mass = row.inertia.mass
        pushed = row.rollers * (row.load_by_speed(given["speed"] * np.pi / 30.0)[1] + 1e3 * mass)
        given["axial"] = np.tan(row.nominal_angle) * (1.3 * size + pushed) * rng.uniform(1.0, 3.0)
    if kind == "ribbed":
        given["axial"] = 0.1 * size * rng.uniform(0.0, 1.0) * (rng.choice([-1, 1]) if row.design == "NUP" else 1)
    if kind in ("X", "O", "tandem"):
        pair = B.paired(row, kind, 2.5 * row.roller_length, clearance=rng.choice([0.0, -1e-3]) * row.roller_diameter)
        # Speed flings the rollers of both rows of a tandem out of the rings' cones.
        given["axial"] = 2.0 * given["axial"] if kind == "tandem" else rng.uniform(-0.3, 0.3) * size
        return pair, given
    return row, given


def faults(task):
    """The kind of outcome, and what is wrong with it."""
    number, method = task
    bearing, given = random_bearing(number)
    with without_accuracy_warnings():
        try:
            found = B.solve(bearing, method=method, **given)
        except nh.ConvergenceError as error:
            return f"unconverged: {str(error)[:40]}", []
        except nh.InputError as error:
            return f"refused: {error.field}", []
    return "solved", out_of_balance(found, given)


def out_of_balance(found, given):
    """What forces and moments on ring and rollers, as vectors in space, do not add up to."""
    sums = sums_in_space(found)
    wrong = []
    if sums.rollers_left > BALANCE:
        wrong.append(f"rollers {sums.rollers_left:.1e}")
    off = sums.off(found.force)
    if np.abs(off).max() > BALANCE:
        wrong.append(f"sums {off.round(12).tolist()}")
    asked = np.array([given.get("axial", np.nan), *given.get("radial", (np.nan, np.nan))])
    missed = np.abs(asked - found.force[:3])[np.isfinite(asked)] / sums.loads
    if missed.max() > BALANCE:
        wrong.append(f"forces {missed.tolist()}")
    return wrong


@pytest.mark.campaign
@pytest.mark.parametrize("method", ["strips", "slices"])
def test_every_bearing_comes_to_a_balance(method):
    count = extent(CASES, SOME[method])
    found = of_each(faults, [(number, method) for number in range(count)])
    print(f"\n{Counter(kind for kind, _ in found).most_common()}")
    wrong = [(number, *each) for number, each in enumerate(found) if each[1] or each[0] != "solved"]
    assert not wrong, (len(wrong), wrong[:10])
