"""50,000 contacts as they are met in practice, each reproducible from its number.

Cylindrical, tapered and needle rollers of 3 to 80 mm on inner and outer rings, flanks and plates, with every profile
of the catalogue, chamfers and reliefs as measured, tilted by up to 3 mrad, at Hertz pressures of up to 5 GPa.

    python tests/campaign/practice_cases.py --first 0 --last 5000 --workers 2 --out fails.jsonl
"""

import math
import sys

import campaign_run
import numpy as np
from extreme_cases import either, log_uniform, one_of
from own_theory import common_interval, compliance, separation

SEED = 20261122
MATERIALS = [(207000.0, 0.3)] * 6 + [(310000.0, 0.26), (110000.0, 0.34), (205000.0, 0.29), (193000.0, 0.28)]


def random_case(number):
    """The case of a number, as plain data."""
    rng = np.random.default_rng([SEED, number])
    modulus, poisson = one_of(rng, MATERIALS)
    a = {"modulus": modulus, "poisson": poisson}
    modulus, poisson = one_of(rng, MATERIALS)
    b = {"modulus": modulus, "poisson": poisson}
    diameter, length = _roller(rng)
    other = one_of(rng, [None, 1.0, 1.0, -1.0, -1.0])
    if other is not None:
        other *= diameter * (log_uniform(rng, 2.0, 12.0) if other > 0.0 else log_uniform(rng, 3.0, 14.0))
    rho = 1.0 / (2.0 / diameter + (2.0 / other if other else 0.0))
    total = compliance(a) + compliance(b)
    pressure = log_uniform(rng, 100.0, 5000.0)
    half_width = 2.0 * math.pi * total * pressure * rho
    line_load = 0.5 * math.pi * half_width * pressure
    approach = total * line_load * (2.0 * math.log(2.0 * diameter / half_width) + 1.0)
    scale = {"length": length, "diameter": diameter, "rho": rho, "compliance": total, "line_load": line_load}
    a |= {"kind": "Roller", "diameter": diameter, "length": length, "profile": relief(rng, scale)}
    if rng.random() < 0.25:
        angle = either(rng) * rng.uniform(0.0, 0.12)
        ends = [diameter - math.tan(angle) * length, diameter + math.tan(angle) * length]
        if min(ends) > 0.4 * diameter:
            a["diameter"] = {"y": [-0.5 * length, 0.5 * length], "diameter": ends}
    if rng.random() < 0.15:
        a["position"] = float(rng.uniform(-0.1, 0.1) * length)
    if rng.random() < 0.1:
        a["effective_length"] = length * float(rng.uniform(0.8, 0.99))
    _faces(rng, a)
    _raceway(rng, b, other, a, length, approach)
    case = {"a": a, "b": b, "element": one_of(rng, ["semi-elliptic"] * 4 + ["parabolic"])}
    case["strips"] = None if rng.random() < 0.7 else one_of(rng, [15, 21, 30, 41, 50, 81, 101, 200])
    case["given"] = _prescribed(rng, case, scale, approach)
    return case


def _roller(rng):
    """Diameter and length of a cylindrical, tapered or needle roller."""
    if rng.random() < 0.25:
        diameter = log_uniform(rng, 3.0, 8.0)
        return diameter, min(diameter * rng.uniform(3.0, 10.0), 80.0)
    diameter = log_uniform(rng, 3.0, 80.0)
    return diameter, min(max(diameter * rng.uniform(0.6, 3.0), 3.0), 80.0)


def _faces(rng, body):
    if rng.random() < 0.3:
        body["side_faces"] = one_of(rng, ["none", "calibrated", "calibrated"])
    if rng.random() < 0.2:
        body["depth"] = one_of(rng, ["none", "diameter"])


def _raceway(rng, b, diameter, a, length, approach):
    """A raceway without ends, with ends beyond the roller or within it, shifted or not, and crowned."""
    b["kind"] = "Plate" if diameter is None else "Ring"
    if diameter is not None:
        b["diameter"] = diameter
    if rng.random() < 0.4:
        b["length"] = length * float(one_of(rng, [1.0, rng.uniform(1.02, 1.6), rng.uniform(0.6, 0.98)]))
        b["position"] = float(one_of(rng, [0.0, rng.uniform(-0.1, 0.1)]) * length)
        _faces(rng, b)
        b.pop("depth", None)
    if rng.random() < 0.2:
        b["depth"] = float(rng.uniform(0.3, 1.0) * (a["diameter"] if not isinstance(a["diameter"], dict) else length))
    if rng.random() < 0.25:
        drop = approach * log_uniform(rng, 0.05, 2.0)
        b["profile"] = [{"of": "crown", "with": {"radius": length**2 / (8.0 * drop)}, "shift": 0.0}]


def relief(rng, scale):
    """A profile of the catalogue, often with chamfers, or one as measured."""
    length, diameter = scale["length"], scale["diameter"]
    name = one_of(rng, list(PROFILES))
    found = [{"of": name, "with": PROFILES[name](rng, scale, length, diameter), "shift": 0.0}]
    if rng.random() < 0.35 and name != "measured":
        width = float(min(log_uniform(rng, 0.1, 2.0), 0.15 * length))
        found.append({"of": "chamfer", "with": {"length": length, "width": width}, "shift": 0.0})
    if name == "measured":
        found[0]["of"] = "tabulated"
    return found


def _design(rng, scale, length):
    # Up to 4 GPa, and a contact that is longer than wide.
    load = scale["line_load"] * length * log_uniform(rng, 0.1, 3.0)
    load = min(load, length**3 / scale["compliance"] / scale["rho"] / 64.0)
    return {"load": load, "length": length, "radius": scale["rho"], "compliance": scale["compliance"]}


def _end_relief(rng, length):
    return length * log_uniform(rng, 2e-4, 4e-3)


def _measured(rng, scale, length, diameter):
    """A logarithm or a partial crown, with the roughness of grinding, at 40 to 250 points."""
    y = np.linspace(-0.5, 0.5, int(rng.integers(40, 250))) * length
    s = 2.0 * np.abs(y) / length
    drop = _end_relief(rng, length)
    form = drop * (-np.log(1.0 - 0.999 * s**2) / 7.0 if rng.random() < 0.6 else np.maximum(s - 0.6, 0.0) ** 2 / 0.16)
    form += rng.uniform(-2e-4, 2e-4) * y * float(rng.integers(2))
    form += rng.normal(0.0, one_of(rng, [0.0, 1e-5, 1e-4, 3e-4]), y.size)
    return {
        "y": y.tolist(),
        "relief": form.tolist(),
        "interpolation": one_of(rng, ["pchip", "pchip", "linear", "cubic"]),
    }


PROFILES = {
    "straight": lambda rng, scale, length, diameter: {},
    "crown": lambda rng, scale, length, diameter: {"radius": length**2 / 8.0 / _end_relief(rng, length)},
    "partial_crown": lambda rng, scale, length, diameter: {
        "radius": length**2 / 16.0 / _end_relief(rng, length),
        "straight": length * float(rng.uniform(0.2, 0.9)),
        "blended": bool(rng.random() < 0.8),
    },
    "two_radius": lambda rng, scale, length, diameter: {
        "radius": length * log_uniform(rng, 50.0, 500.0),
        "end_radius": length * log_uniform(rng, 3.0, 50.0),
        "middle": length * float(rng.uniform(0.5, 0.9)),
    },
    "logarithmic": lambda rng, scale, length, diameter: {
        "amplitude": _end_relief(rng, length) / 7.0,
        "length": length,
        "fraction": one_of(rng, [0.9999, 1.0, 0.99]),
    },
    "lundberg": lambda rng, scale, length, diameter: _design(rng, scale, length),
    "johns_gohar": lambda rng, scale, length, diameter: _design(rng, scale, length),
    "fujiwara_kawase": lambda rng, scale, length, diameter: (
        _design(rng, scale, length) | {"k1": float(rng.uniform(1.0, 3.0)), "k2": float(rng.uniform(0.3, 1.0))}
    ),
    "iso_logarithmic": lambda rng, scale, length, diameter: {"diameter": diameter, "length": length},
    "iso_tapered": lambda rng, scale, length, diameter: {"diameter": diameter, "length": length},
    "iso_thrust": lambda rng, scale, length, diameter: {"diameter": diameter, "length": length},
    "conical": lambda rng, scale, length, diameter: {"angle": float(rng.uniform(-3e-4, 3e-4))},
    "tapered_ends": lambda rng, scale, length, diameter: {
        "straight": length * float(rng.uniform(0.5, 0.9)),
        "angle": log_uniform(rng, 5e-4, 2e-2),
    },
    "chamfer": lambda rng, scale, length, diameter: {
        "length": length,
        "width": float(min(log_uniform(rng, 0.1, 2.0), 0.15 * length)),
        "angle": one_of(rng, [0.25 * math.pi, 0.17, 0.35]),
    },
    "measured": _measured,
}


def _prescribed(rng, case, scale, approach):
    """Mostly load and tilt; tilts of up to 3 mrad, moments of up to a seventh of the length."""
    low, high = common_interval(case)
    length, middle = high - low, 0.5 * (low + high)
    load = float(scale["line_load"] * length)
    tilt = float(either(rng) * one_of(rng, [0.0, rng.uniform(0.0, 3e-3), log_uniform(rng, 1e-5, 3e-3)]))
    kind = rng.random()
    if kind < 0.65:
        return {"load": load, "tilt": tilt} if tilt or kind < 0.3 else {"load": load}
    arm = float(middle + rng.uniform(-0.14, 0.14) * length)
    if kind < 0.82:
        return {"load": load, "moment": arm * load}
    y = middle + np.linspace(-0.499, 0.499, 801) * length
    if kind < 0.94:
        return {"approach": approach + float(np.nanmin(separation(case, y) - tilt * y)), "tilt": tilt}
    return {"approach": approach + float(np.nanmin(separation(case, y))), "moment": 0.3 * arm * load}


if __name__ == "__main__":
    sys.exit(campaign_run.main("practice_cases"))
