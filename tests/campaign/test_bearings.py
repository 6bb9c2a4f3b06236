"""5,000 random bearings of all kinds under loads up to twice their static rating, with forces summed in space."""

import os
import warnings
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
from extent import extent

import nonhertz as nh

CASES, SOME = 5_000, {"strips": 12, "slices": 60}
SEED = 20261124
BALANCE = 1e-8  # of the loads
KINDS = ("cylindrical", "needle", "tapered", "spherical", "thrust", "X", "O", "tandem")
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
    if kind in ("cylindrical", "needle"):
        cls = B.CylindricalRollerBearing if kind == "cylindrical" else B.NeedleRollerBearing
        inner, outer = nh.Ring(diameter=pitch - diameter, **depth), nh.Ring(diameter=-(pitch + diameter), **depth)
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
    half = 0.5 * length * np.tan(rng.uniform(0.1, 0.25) * angle) * 2.0
    cone = nh.TabulatedDiameter((-0.5 * length, 0.5 * length), (diameter + half, diameter - half))
    return B.TaperedRollerBearing(
        roller=nh.Roller(diameter=cone, **roller), contact_angle=angle, clearance=clearance, **rings, **given
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
    if row.holds_axially:
        mass, _ = row.inertia()
        pushed = row.rollers * (row.load_by_speed(given["speed"] * np.pi / 30.0)[1] + 1e3 * mass)
        given["axial"] = np.tan(row.nominal_angle) * (1.3 * size + pushed) * rng.uniform(1.0, 3.0)
    if kind in ("X", "O", "tandem"):
        pair = B.paired(row, kind, 2.5 * row.roller_length, clearance=rng.choice([0.0, -1e-3]) * row.roller_diameter)
        if kind != "tandem":
            given["axial"] = rng.uniform(-0.3, 0.3) * size
        return pair, given
    return row, given


def faults(task):
    """The kind of outcome, and what is wrong with it."""
    number, method = task
    bearing, given = random_bearing(number)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        try:
            found = B.solve(bearing, method=method, **given)
        except nh.ConvergenceError as error:
            return f"unconverged: {str(error)[:40]}", []
        except nh.InputError as error:
            return f"refused: {error.field}", []
    return "solved", out_of_balance(found, given)


def out_of_balance(found, given):
    """What forces and moments on ring and rollers, as vectors in space, do not add up to."""
    loads = np.abs(found.load).sum() + np.abs(found.roller_load[:, :2]).sum()
    total, moment, worst, first = np.zeros(3), np.zeros(3), 0.0, 0
    reach = 0.0
    for row in found.bearing.rows:
        bearing, way = row.bearing, -1.0 if row.turned else 1.0
        reach = max(reach, abs(row.x) + 0.5 * bearing.pitch)
        angles = bearing.contact_angles if found.method == "strips" else (bearing.nominal_angle,) * 2
        barrel = getattr(bearing, "profile_radius", np.inf) if found.method == "strips" else np.inf
        for j in range(first, first + bearing.rollers):
            radial = np.array([0.0, np.cos(found.angle[j]), np.sin(found.angle[j])])
            axis = np.array([way, 0.0, 0.0])
            middle = row.x * np.array([1.0, 0.0, 0.0]) + 0.5 * bearing.pitch * radial
            on_roller = found.roller_load[j, 1] * radial
            turning = np.zeros(3)
            if found.method == "strips":
                turning += found.roller_load[j, 2] * np.cross(axis, radial)
            for k, sign in enumerate((1.0, -1.0)):
                normal = sign * (np.sin(angles[k]) * axis + np.cos(angles[k]) * radial)
                along = np.cos(angles[k]) * axis - np.sin(angles[k]) * radial
                place = -0.5 * bearing.roller_diameter * normal
                force = found.load[j, k] * normal - found.moment[j, k] / barrel * along
                couple = found.moment[j, k] * np.cross(along, normal)
                on_roller, turning = on_roller + force, turning + np.cross(place, force) + couple
                if k == 0:
                    total += force
                    moment += np.cross(middle + place, force) + couple
            if found.method == "strips" and isinstance(bearing, B.TaperedRollerBearing):
                (normal_x, normal_r, arm), _ = bearing.end_contact()[0]
                force = found.rib_load[j] * (normal_x * axis + normal_r * radial)
                # The arm of the force about the roller's middle.
                couple = found.rib_load[j] * arm * np.cross(axis, radial)
                on_roller, turning = on_roller + force, turning + couple
                total += force
                moment += np.cross(middle, force) + couple
            # Slices hold no roller along its axis.
            held = np.sin(angles[1]) * axis + np.cos(angles[1]) * radial
            left = on_roller if found.method == "strips" else (on_roller @ held) * held
            worst = max(worst, np.linalg.norm(left), np.linalg.norm(turning) / bearing.roller_length)
        first += bearing.rollers
    wrong = []
    if worst > BALANCE * loads:
        wrong.append(f"rollers {worst / loads:.1e}")
    off = np.abs(np.concatenate([(total - found.force[:3]) / loads, (moment[1:] - found.force[3:]) / loads / reach]))
    if off.max() > BALANCE:
        wrong.append(f"sums {off.round(12).tolist()}")
    asked = np.array([given.get("axial", np.nan), *given.get("radial", (np.nan, np.nan))])
    missed = np.abs(asked - found.force[:3])[np.isfinite(asked)] / loads
    if missed.max() > BALANCE:
        wrong.append(f"forces {missed.tolist()}")
    return wrong


@pytest.mark.campaign
@pytest.mark.parametrize("method", ["strips", "slices"])
def test_every_bearing_comes_to_a_balance(method):
    count = extent(CASES, SOME[method])
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(faults, [(number, method) for number in range(count)], chunksize=5))
    print(f"\n{Counter(kind for kind, _ in found).most_common()}")
    wrong = [(number, *each) for number, each in enumerate(found) if each[1] or each[0] != "solved"]
    assert not wrong, (len(wrong), wrong[:10])
