"""50,000 contacts at and beyond the edge of what makes sense, each reproducible from its number.

Lengths from 1e-6 to 1e6 mm, every Poisson's ratio, reliefs with walls, cusps, steps and dimples, bodies that end
anywhere, 1 to 2000 strips. Nothing of it need have a solution; none may end in a wrong one.
"""

import math

import numpy as np
from own_theory import common_interval, compliance, separation

SEED = 20261121
FEW_OF_MANY_IMAGES = 60


def random_case(number):
    """The case of a number, as plain data."""
    rng = np.random.default_rng([SEED, number])
    while True:
        case, scale = _drawn(rng)
        low, high = common_interval(case)
        if low < high:
            return {**case, "strips": _strips(rng, case, scale["length"]), "given": prescribed(rng, case, scale)}


def _drawn(rng):
    length = log_uniform(rng, 1e-6, 1e6) if rng.random() < 0.4 else log_uniform(rng, 1e-1, 1e3)
    diameter = min(max(length * log_uniform(rng, *one_of(rng, [(0.05, 20.0), (1e-3, 1e3)])), 1e-6), 1e6)
    bodies = [_material(rng), _material(rng)]
    other = _other_diameter(rng, diameter)
    rho = 1.0 / (2.0 / diameter + (2.0 / other if other else 0.0))
    stiffness = [compliance(body) for body in bodies]
    pressure = log_uniform(rng, *one_of(rng, [(1e-8, 0.1), (1e-4, 0.3)])) * min(body["modulus"] for body in bodies)
    half_width = 2.0 * math.pi * sum(stiffness) * pressure * rho
    line_load = 0.5 * math.pi * half_width * pressure
    approach = sum(stiffness) * line_load * (2.0 * math.log(max(2.0 * length / half_width, 3.0)) + 1.0)
    scale = {
        "length": length,
        "rho": rho,
        "compliance": sum(stiffness),
        "approach": approach,
        "line_load": line_load,
        "half_width": half_width,
    }
    a, b = bodies
    a.update(_sized(rng, diameter, length, half_width))
    a["length"] = length
    a["position"] = (
        float(rng.choice([0.0, rng.uniform(-0.5, 0.5), log_uniform(rng, 1.0, 1e3)], p=[0.6, 0.3, 0.1])) * length
    )
    a["profile"] = relief(rng, scale)
    if rng.random() < 0.1:
        a["effective_length"] = length * rng.uniform(0.01, 1.0)
    b.update(_sized(rng, other, length, half_width))
    _end_of_the_other(rng, a, b, length)
    if b.get("length") is not None and rng.random() < 0.3:
        b["profile"] = relief(rng, scale)
    for body in (a, b):
        if body.get("length") is None:
            body.pop("side_faces", None)
    if rng.random() < 0.05:
        a.pop("length")
        a.pop("effective_length", None)
        a.pop("side_faces", None)
        a["images"] = 1
    _kinds(rng, a, b)
    case = {"a": a, "b": b, "element": one_of(rng, ["semi-elliptic", "parabolic"])}
    if rng.random() < 0.5:
        case["a"], case["b"] = b, a
    return case, scale


def _material(rng):
    poisson = one_of(rng, [0.3, 0.0, 0.5, -0.99, float(rng.uniform(-0.99, 0.5)), float(rng.uniform(0.0, 0.5))])
    return {"modulus": log_uniform(rng, 1.0, 1e6), "poisson": poisson}


def _other_diameter(rng, diameter):
    kind = rng.integers(4)
    if kind == 0:
        return None
    if kind == 1:
        return diameter * log_uniform(rng, 1e-2, 1e2)
    # A ring about the first body, down to one that nearly conforms.
    return -diameter * (1.0 + (log_uniform(rng, 1e-4, 0.3) if kind == 2 else log_uniform(rng, 0.1, 30.0)))


def _sized(rng, diameter, length, half_width):
    """Diameter, faces, images and depth of a body."""
    found = {"diameter": diameter, "depth": _depth(rng, diameter, length, half_width)}
    if diameter is not None and rng.random() < 0.05:
        ends = sorted(rng.uniform(0.6, 1.0, 2)) if diameter > 0.0 else sorted(rng.uniform(1.0, 1.5, 2))
        found["diameter"] = {"y": [-0.5 * length, 0.5 * length], "diameter": [float(diameter * end) for end in ends]}
    rules = [one_of(rng, ["none", "mirror", "mirror", "calibrated", float(rng.uniform(0.0, 2.5))]) for _ in "lh"]
    found["side_faces"] = rules[0] if rng.random() < 0.7 else tuple(rules)
    series = found["depth"] != "none"
    found["images"] = one_of(rng, [1] * 16 + [2, 5, 100, "series" if series else 1])
    return found


def _depth(rng, diameter, length, half_width):
    if rng.random() < 0.4:
        return "none"
    if diameter is not None and diameter > 0.0 and rng.random() < 0.6:
        return one_of(rng, ["plane-strain", "diameter"])
    return max(1e-6, one_of(rng, [half_width * log_uniform(rng, 0.5, 20.0), length * log_uniform(rng, 1e-2, 1e2)]))


def _end_of_the_other(rng, a, b, length):
    """Where the other body ends: nowhere, anywhere, with the first one or just past y = 0."""
    kind = one_of(rng, ["endless", "endless", "coincident", "nearly", "anywhere", "past zero", "within", "corner"])
    position = a["position"]
    if kind == "endless":
        return
    if kind == "coincident":
        b["length"], b["position"] = length, position
    elif kind == "nearly":
        b["length"], b["position"] = length * (1.0 + either(rng) * log_uniform(rng, 1e-12, 1e-2)), position
    elif kind == "anywhere":
        b["length"], b["position"] = length * log_uniform(rng, 1e-2, 10.0), position + rng.uniform(-0.6, 0.6) * length
    elif kind == "within":
        b["length"], b["position"] = length * rng.uniform(0.05, 1.0), position
    else:
        # One end of the common interval lies just beside y = 0, or beside the middle of the first body.
        beside = log_uniform(rng, 1e-12, 1e-2) * one_of(rng, [1.0, length]) * either(rng)
        beside += 0.0 if kind == "past zero" else position
        if kind == "past zero":
            a["position"] = one_of(rng, [0.0, 0.0, rng.uniform(-0.4, 0.4) * length])
        b["length"] = length * one_of(rng, [1.0, 2.0, log_uniform(rng, 0.1, 10.0)])
        b["position"] = beside + either(rng) * 0.5 * b["length"]


def _kinds(rng, a, b):
    for body in (a, b):
        kind, diameter = "Body", body.get("diameter")
        if diameter is None:
            body.pop("diameter", None)
            kind = one_of(rng, ["Body", "Plate"])
        else:
            convex = isinstance(diameter, dict) and diameter["diameter"][0] > 0.0
            convex = convex or (not isinstance(diameter, dict) and diameter > 0.0)
            kind = one_of(rng, ["Roller" if convex and body.get("length") is not None else "Body", "Ring"])
        body["kind"] = kind
        for name in ("position", "length"):
            if name in body:
                body[name] = float(body[name])


def relief(rng, scale):
    """One or two reliefs; heights far below and far above the approach."""
    return [_part(rng, scale) for _ in range(1 if rng.random() < 0.75 else 2)]


def _part(rng, scale):
    length, height = scale["length"], scale["approach"] * log_uniform(rng, *one_of(rng, [(0.03, 30.0), (1e-4, 1e4)]))
    name = one_of(rng, list(PARTS))
    part = {"of": name, "with": PARTS[name](rng, scale, length, height), "shift": 0.0}
    if rng.random() < 0.25 and name not in {"straight", "logarithmic", "iso_logarithmic", "iso_tapered", "conical"}:
        part["shift"] = float(rng.uniform(-0.5, 0.5) * length)
    return part


def _radius(length, height):
    return max(length * length / (8.0 * height), 0.5 * length)


def _design(rng, scale, length):
    """A design load that leaves a line contact on the length."""
    load = scale["line_load"] * length * log_uniform(rng, 0.01, 10.0)
    widest = 0.2 * length  # twice the half-width 2 sqrt(load / length compliance rho) stays below half of the length
    load = min(load, widest**2 / 4.0 / scale["compliance"] / scale["rho"] * length)
    return {"load": load, "length": length, "radius": scale["rho"], "compliance": scale["compliance"]}


def _fujiwara(rng, scale, length):
    given = _design(rng, scale, length) | {"k1": log_uniform(rng, 0.5, 5.0), "k2": float(rng.uniform(0.1, 1.0))}
    if rng.random() < 0.5:
        given["zm"] = given["load"] / length * given["compliance"] * log_uniform(rng, 0.1, 30.0)
    return given


def _table(rng, length, height):
    kind = one_of(rng, ["wall", "random", "dimple", "cusp", "steps", "short"])
    half = 0.5 * length
    if kind == "wall":
        near = 1.0 - log_uniform(rng, 1e-9, 0.1)
        y, relief = [-1.0, -near, near, 1.0], [1e3, 0.0, 0.0, 1e3 * float(rng.integers(2))]
    elif kind == "dimple":
        inner = float(rng.uniform(0.05, 0.9))
        outer = inner + (1.0 - inner) * log_uniform(rng, 1e-4, 0.5)
        y, relief = [-1.0, -outer, -inner, inner, outer, 1.0], [1.0, 1.0, 0.0, 0.0, 1.0, 1.0]
        relief = [1.0 - one for one in relief] if rng.random() < 0.5 else relief
    elif kind == "cusp":
        at = float(rng.uniform(-0.9, 0.9))
        y, relief = [-1.0, at, 1.0], [1.0, 0.0, float(rng.uniform(0.0, 3.0))]
    elif kind == "steps":
        y = sorted({-1.0, 1.0, *rng.uniform(-0.95, 0.95, int(rng.integers(2, 6))).tolist()})
        y = [place for one in y for place in (one, one + 1e-3 * rng.uniform(0.001, 1.0))][:-1]
        steps = rng.integers(0, 2, len(y) // 2 + 1).astype(float)
        relief = [float(steps[k // 2]) for k in range(1, len(y) + 1)]
    elif kind == "short":
        reach = rng.uniform(0.01, 0.9)
        y, relief = [-reach, float(rng.uniform(0.1, 0.9)) * reach, reach], [0.2, 0.0, 1.0]
    elif rng.random() < 0.1:
        y, relief = [-1.0, 0.0, 10.0 ** -rng.uniform(10.0, 320.0), 1.0], [1.0, 0.0, 0.0, 1.0]
    else:
        count = int(rng.integers(2, 40))
        y, relief = np.sort(rng.uniform(-1.0, 1.0, count)).tolist(), rng.random(count).tolist()
    y, relief = [half * one for one in y], [height * one for one in relief]
    return {"y": y, "relief": relief, "interpolation": one_of(rng, ["linear", "pchip", "pchip", "cubic"])}


PARTS = {
    "straight": lambda rng, scale, length, height: {},
    "crown": lambda rng, scale, length, height: {
        "radius": _radius(length, height) * one_of(rng, [1.0, 1.0, 1.0, -1.0]),
        "centre": one_of(rng, [0.0, float(rng.uniform(-0.4, 0.4)) * length]),
    },
    "partial_crown": lambda rng, scale, length, height: {
        "radius": _radius(length, height),
        "straight": length * float(rng.uniform(0.0, 0.9)),
        "blended": bool(rng.random() < 0.7),
    },
    "two_radius": lambda rng, scale, length, height: {
        "radius": _radius(length, 0.1 * height),
        "end_radius": _radius(length, height) * log_uniform(rng, 0.5, 2.0),
        "middle": length * float(rng.uniform(0.1, 0.9)),
    },
    "logarithmic": lambda rng, scale, length, height: {
        "amplitude": height * log_uniform(rng, 0.01, 1.0),
        "length": length * one_of(rng, [1.0, 1.0, float(rng.uniform(0.5, 1.5))]),
        "fraction": one_of(rng, [1.0, 0.9999, float(rng.uniform(0.1, 1.0))]),
    },
    "iso_logarithmic": lambda rng, scale, length, height: {"diameter": 2.0 * scale["rho"], "length": length},
    "iso_tapered": lambda rng, scale, length, height: {"diameter": 2.0 * scale["rho"], "length": length},
    "johns_gohar": lambda rng, scale, length, height: _design(rng, scale, length),
    "lundberg": lambda rng, scale, length, height: _design(rng, scale, length),
    "fujiwara_kawase": lambda rng, scale, length, height: _fujiwara(rng, scale, length),
    "conical": lambda rng, scale, length, height: {"angle": either(rng) * min(math.atan(height / length), 1.4)},
    "tapered_ends": lambda rng, scale, length, height: {
        "straight": length * float(rng.uniform(0.0, 0.95)),
        "angle": min(math.atan(10.0 * height / length), 1.5),
    },
    "chamfer": lambda rng, scale, length, height: {"length": length, "width": length * log_uniform(rng, 1e-6, 0.4)},
    "tabulated": lambda rng, scale, length, height: _table(rng, length, height),
    "Cusp": lambda rng, scale, length, height: {
        "at": float(rng.uniform(-0.5, 0.5)) * length * float(rng.integers(2)),
        "height": height,
        "reach": 0.5 * length,
        "power": log_uniform(rng, 0.3, 20.0),
    },
    "Step": lambda rng, scale, length, height: {
        "at": float(rng.uniform(-0.5, 0.5)) * length,
        "height": height,
        "side": either(rng),
    },
    "Dimple": lambda rng, scale, length, height: {
        "at": float(rng.uniform(-0.5, 0.5)) * length,
        "height": height * either(rng),
        "reach": length * log_uniform(rng, 1e-3, 1.0),
    },
    "Wave": lambda rng, scale, length, height: {
        "height": height,
        "length": length * log_uniform(rng, 0.05, 2.0),
        "phase": float(rng.uniform(0.0, 2.0 * math.pi)),
    },
}


def _strips(rng, case, length):
    """Automatic, a number of equal ones, or edges of every kind."""
    kind = rng.random()
    if kind < 0.45:
        return None
    many_images = any(body.get("images", 1) not in {1, 2} for body in (case["a"], case["b"]))
    most = FEW_OF_MANY_IMAGES if many_images else one_of(rng, [100] * 12 + [400, 400, 2000])
    count = round(log_uniform(rng, 1.0, most))
    if kind < 0.8:
        return count
    low, high = common_interval(case)
    low, high = max(low, min(high, 0.0) - 5.0 * length), min(high, max(low, 0.0) + 5.0 * length)
    return _edges(rng, low, high, min(count, 300))


def _edges(rng, low, high, count):
    kind = one_of(rng, ["equal", "uneven", "random", "graded", "part", "sliver"])
    share = np.linspace(0.0, 1.0, count + 1)
    if kind == "uneven":
        share[1:-1] += rng.uniform(-0.4, 0.4, count - 1) / count
    elif kind == "random":
        share = np.sort(np.concatenate([[0.0, 1.0], rng.random(count - 1)]))
    elif kind == "graded":
        share = share ** log_uniform(rng, 0.2, 5.0)
    elif kind == "part":
        first, last = np.sort(rng.random(2))
        share = first + (last - first) * share
    elif kind == "sliver" and count > 1:
        share[1] = share[0] + log_uniform(rng, 1e-9, 1e-3) * share[1]
    edges = np.unique(np.clip(low + (high - low) * share, low, high))
    return edges.tolist() if edges.size > 1 else [low, high]


def prescribed(rng, case, scale):
    """Two of approach, load, tilt and moment; moments up to just inside the ends, loads tiny and huge."""
    low, high = common_interval(case)
    low, high = max(low, min(high, 0.0) - 50.0 * scale["length"]), min(high, max(low, 0.0) + 50.0 * scale["length"])
    middle, length = 0.5 * (low + high), high - low
    tilt = either(rng) * rng.choice([0.0, rng.random(), log_uniform(rng, 1e-3, 30.0)], p=[0.3, 0.5, 0.2])
    tilt *= 2.0 * scale["approach"] / length
    load = scale["line_load"] * length
    if rng.random() < 0.08:
        load *= log_uniform(rng, *one_of(rng, [(1e-16, 1.0), (1.0, 1e6), (1e-320, 1e-100)]))
    by_load, by_moment = rng.random() < 0.65, rng.random() < 0.4
    given = {}
    if by_load:
        given["load"] = float(load)
    else:
        y = middle + np.linspace(-0.499 * length, 0.499 * length, 2001)
        h = separation(case, y) - (0.0 if by_moment else tilt) * y
        h = h[np.isfinite(h)]
        given["approach"] = float(scale["approach"] * log_uniform(rng, 0.01, 10.0) + (h.min() if h.size else 0.0))
    if by_moment:
        given["moment"] = _moment(rng, load, low, high) * (1.0 if by_load else log_uniform(rng, 1e-2, 1.0))
    elif tilt != 0.0 or rng.random() < 0.5:
        given["tilt"] = float(tilt)
    return given


def _moment(rng, load, low, high):
    kind = rng.random()
    if kind < 0.25:
        inside = (high - low) * log_uniform(rng, 1e-12, 0.1)
        arm = high - inside if rng.random() < 0.5 else low + inside
    elif kind < 0.3:
        arm = high + (high - low) * log_uniform(rng, 1e-9, 1.0)
    else:
        arm = rng.uniform(low, high) if kind < 0.6 else 0.5 * (low + high) + rng.uniform(-0.15, 0.15) * (high - low)
    return float(arm * load)


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def one_of(rng, choices):
    return choices[int(rng.integers(len(choices)))]


def either(rng):
    return float(rng.choice([-1.0, 1.0]))
