"""The strips' equations written a second time, from the theory alone: nothing here comes from the package.

A strip with the line load q and the pressure shape phi of half-width a moves the centre line, by Boussinesq, by

    w = K q [A],  A(t) = int phi(xi) asinh(t / |xi|) dxi,         -w'' = K q [B] / a^2,  B(t) = int psi t / sqrt(xi^2 +
    t^2) dxi,  psi = -phi' / xi,  t = (edge - y) / a.

A is integrated numerically on panels that halve towards xi = 0, B has closed forms; both are splines in ln t. Images
are set down one by one, a series of them by strips, forces and an integral, in this order. Bodies and profiles are
read from plain data.
"""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.special import ellipkm1
from shapes import Cusp, Dimple, Step, Wave

LEAST, MOST, STEP = math.log(1e-10), math.log(1e9), 0.004  # of ln t, in the splines
PANELS, NODES = 82, 12
APART, TOGETHER = 0.02, 1.0 - 1e-4  # documented: within which distance, of the radius, faces of two bodies act as one
NEAR_LINKS, MOST_NEAR_LINKS, NEAR_WIDTHS, FAR_LINKS = 30, 1000, 20.0, 3000  # of a series: as strips, and as forces
CALIBRATED = ((0.0, 0.2, 0.25, 0.28, 0.3, 0.33, 0.4), (1.10, 1.35, 1.45, 1.50, 1.60, 1.65, 1.95))
HERTZ_RATIO = {"semi-elliptic": 1.0, "parabolic": math.sqrt(2.0 / 3.0)}
EPS = float(np.finfo(float).eps)


@dataclass(frozen=True)
class Kernel:
    """A and B of one element for any t, as splines of A / t and B / t in ln t."""

    of_a: np.ndarray
    of_b: np.ndarray
    leading_a: tuple[float, float]
    leading_b: tuple[float, float]
    far: float
    limit: float

    def __call__(self, t):
        size = np.abs(t)
        with np.errstate(divide="ignore"):
            u = np.log(size)
        place = (np.clip(u, LEAST, MOST - STEP) - LEAST) / STEP
        cell = place.astype(np.intp)
        x = (place - cell) * STEP
        a, b = (self._cubic(table, cell, x) * size for table in (self.of_a, self.of_b))
        near = (size < 1.01e-10) & (size > 0.0)
        if near.any():
            factor, ratio = self.leading_a
            a[near] = factor * size[near] * (math.log(ratio) - u[near])
            factor, ratio = self.leading_b
            b[near] = factor * size[near] * (math.log(ratio) - u[near])
        far = size > 0.99e9
        if far.any():
            a[far], b[far] = u[far] + math.log(2.0) + self.far, self.limit
        return np.copysign(a, t), np.copysign(b, t)

    @staticmethod
    def _cubic(table, cell, x):
        return ((table[0].take(cell) * x + table[1].take(cell)) * x + table[2].take(cell)) * x + table[3].take(cell)


@cache
def kernel(element):
    """The kernel of an element: the pressure shape is all that goes in."""
    u = LEAST + STEP * np.arange(round((MOST - LEAST) / STEP) + 2)
    t = np.exp(u)
    theta, weight = _panels()
    # phi dxi = (2 / pi) cos^2 for the semi-ellipse and (3 / 4) cos^3 for the parabola, xi = sin(theta); twice half.
    density = weight * (4.0 / np.pi * np.cos(theta) ** 2 if element == "semi-elliptic" else 1.5 * np.cos(theta) ** 3)
    inverse = 1.0 / np.sin(theta)
    a = np.array([np.arcsinh(one * inverse) @ density for one in t])
    if element == "semi-elliptic":
        b = 4.0 / np.pi * t / np.sqrt(1.0 + t * t) * ellipkm1(t * t / (1.0 + t * t))
        leading = (4.0 / np.pi, 4.0), (4.0 / np.pi, 4.0)
        limit = 2.0
    else:
        b = 3.0 * t * np.arcsinh(1.0 / t)
        leading, limit = ((1.5, 2.0 * math.sqrt(math.e)), (3.0, 2.0)), 3.0
    return Kernel(CubicSpline(u, a / t).c, CubicSpline(u, b / t).c, *leading, far_constant(element), limit)


def _panels():
    edges = 0.5 * np.pi * 2.0 ** -np.arange(PANELS + 1.0)[::-1]
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (1.0 + nodes)).ravel(), (half * weights).ravel()


def compliance(body):
    return (1.0 - body["poisson"] ** 2) / (math.pi * body["modulus"])


def far_constant(element):
    return math.log(2.0) + 0.5 if element == "semi-elliptic" else 4.0 / 3.0


def interval(body):
    """Where a body can touch."""
    length = body.get("effective_length", body.get("length"))
    low, high = (-math.inf, math.inf) if length is None else (-0.5 * length, 0.5 * length)
    for part in body.get("profile", []):
        if part["of"] == "tabulated":
            shift = part.get("shift", 0.0)
            low, high = max(low, min(part["with"]["y"]) + shift), min(high, max(part["with"]["y"]) + shift)
    position = body.get("position", 0.0)
    return position + low, position + high


def common_interval(case):
    (low, high), (other_low, other_high) = interval(case["a"]), interval(case["b"])
    return max(low, other_low), min(high, other_high)


def separation(case, y):
    """The sum of both reliefs."""
    return relief(case["a"], y) + relief(case["b"], y)


def relief(body, y):
    total = np.zeros_like(y)
    for part in body.get("profile", []):
        local = y - body.get("position", 0.0)
        local = local - part.get("shift", 0.0)
        given = part["with"]
        total = total + (_tabulated(local, given) if part["of"] == "tabulated" else RELIEFS[part["of"]](local, **given))
    return total


def curvature(case, y):
    return _curvature_of(case["a"], y) + _curvature_of(case["b"], y)


def _curvature_of(body, y):
    diameter = body.get("diameter")
    if diameter is None:
        return np.zeros_like(y)
    if isinstance(diameter, dict):
        return 2.0 / np.interp(y - body.get("position", 0.0), diameter["y"], diameter["diameter"])
    return np.full_like(y, 2.0 / diameter)


def _circle(radius, y):
    size, distance = abs(radius), np.abs(y)
    if math.isinf(size):
        return np.zeros_like(y)
    with np.errstate(invalid="ignore"):
        drop = distance**2 / (size + np.sqrt((size - distance) * (size + distance)))
    return np.where(distance <= size, math.copysign(1.0, radius) * drop, np.inf)


def _crown(y, radius, centre=0.0):
    return _circle(radius, y - centre)


def _partial_crown(y, radius, straight, blended=True):
    past = np.maximum(np.abs(y), 0.5 * straight)
    start = 0.5 * straight if blended else 0.0
    return _circle(radius, past - start) - _circle(radius, np.full_like(y, 0.5 * straight - start))


def _two_radius(y, radius, end_radius, middle):
    half = 0.5 * middle
    summit = half * (1.0 - end_radius / radius)
    past = np.maximum(np.abs(y), half)
    joint = _circle(radius, np.full_like(y, half)) - _circle(end_radius, np.full_like(y, half - summit))
    return np.where(np.abs(y) <= half, _circle(radius, y), _circle(end_radius, past - summit) + joint)


def _logarithm(y, amplitude, length, rest, straight):
    s = np.maximum(np.abs(y) - 0.5 * straight, 0.0) * (2.0 / length)
    # 1 - (1 - rest) s^2 in two parts, neither of which cancels near the end; near the middle it is 1 but for the last
    # digits, and its logarithm no better than they are.
    argument = (1.0 - s) * (1.0 + s) + rest * s * s
    with np.errstate(divide="ignore", invalid="ignore"):
        near = np.log1p(s * s * np.where(s < 0.5, rest - 1.0, 0.0))
        return np.where(argument > 0.0, -amplitude * np.where(s < 0.5, near, np.log(argument)), np.inf)


def _logarithmic(y, amplitude, length, fraction=1.0, straight=0.0):
    return _logarithm(y, amplitude, length, (1.0 - fraction) * (1.0 + fraction), straight)


def _iso_logarithmic(y, diameter, length):
    if length <= 2.5 * diameter:
        return _logarithm(y, 0.00035 * diameter, length, 0.0, 0.0)
    return _logarithm(y, 0.0005 * diameter, 2.5 * diameter, 0.0, length - 2.5 * diameter)


def _iso_tapered(y, diameter, length):
    return _logarithm(y, 0.00045 * diameter, length, 0.0, 0.0)


def _design(load, length, radius, compliance):
    amplitude = load / length * compliance
    return amplitude, 2.0 * math.sqrt(amplitude * radius)


def _johns_gohar(y, load, length, radius, compliance):
    amplitude, half_width = _design(load, length, radius, compliance)
    return _logarithm(y, amplitude, length, 0.6066 * half_width / length, 0.0)


def _fujiwara_kawase(y, load, length, compliance, radius=None, k1=1.0, k2=1.0, zm=None):
    amplitude = k1 * load / length * compliance
    rest = (
        math.exp(-zm / amplitude) if zm is not None else 0.6066 * _design(load, length, radius, compliance)[1] / length
    )
    return _logarithm(y, amplitude, k2 * length, rest, (1.0 - k2) * length)


def _lundberg(y, load, length, radius, compliance):
    amplitude, half_width = _design(load, length, radius, compliance)
    of = kernel("semi-elliptic")
    middle, _ = of(np.array([0.5 * length / half_width]))
    ends = of((0.5 * length - y) / half_width)[0] + of((0.5 * length + y) / half_width)[0]
    return amplitude * (2.0 * middle[0] - ends)


def amplitudes_from_tables(case):
    """Amplitudes of the reliefs that have no closed form."""
    parts = [part for body in (case["a"], case["b"]) for part in body.get("profile", []) if part["of"] == "lundberg"]
    return [part["with"]["load"] / part["with"]["length"] * part["with"]["compliance"] for part in parts]


def _tapered_ends(y, straight, angle):
    return math.tan(angle) * np.maximum(np.abs(y) - 0.5 * straight, 0.0)


def _chamfer(y, length, width, angle=0.25 * math.pi):
    return _tapered_ends(y, length - 2.0 * width, angle)


def _tabulated(y, table):
    points, order = np.array(table["y"]), np.argsort(table["y"])
    values, points = np.array(table["relief"])[order], points[order]
    inside = (y >= points[0]) & (y <= points[-1])
    make = {"linear": _polyline, "pchip": PchipInterpolator, "cubic": CubicSpline}[table.get("interpolation", "pchip")]
    try:
        curve = make(points, values)
    except np.linalg.LinAlgError:  # points so close that no spline goes through them
        return np.full_like(y, np.nan)
    return np.where(inside, curve(np.where(inside, y, points[0])), np.inf)


def _polyline(points, values):
    return lambda y: np.interp(y, points, values)


def _of_shape(shape):
    return lambda y, **given: shape(**given).relief(y)


RELIEFS = {
    "straight": np.zeros_like,
    "crown": _crown,
    "partial_crown": _partial_crown,
    "two_radius": _two_radius,
    "logarithmic": _logarithmic,
    "iso_logarithmic": _iso_logarithmic,
    "iso_thrust": _iso_logarithmic,
    "iso_tapered": _iso_tapered,
    "johns_gohar": _johns_gohar,
    "fujiwara_kawase": _fujiwara_kawase,
    "lundberg": _lundberg,
    "conical": lambda y, angle: math.tan(angle) * y,
    "tapered_ends": _tapered_ends,
    "chamfer": _chamfer,
    "Cusp": _of_shape(Cusp),
    "Step": _of_shape(Step),
    "Dimple": _of_shape(Dimple),
    "Wave": _of_shape(Wave),
}


class Surfaces:
    """Both bodies of a case under strips with loads ``q`` and half-widths ``a`` between ``low`` and ``high``.

    After a call, ``noise`` holds what rounding may do to the displacement.
    """

    def __init__(self, case, low, high, q, a):
        self.case, self.kernel = case, kernel(case["element"])
        self.low, self.high, self.q, self.a = low, high, q, a
        self.bodies = (case["a"], case["b"])
        self.compliances = [compliance(body) for body in self.bodies]
        self.weights = face_weights(case)
        self.endless = any(body.get("images") == "series" for body in self.bodies)

    def displacement_and_curvature(self, y):
        """What both bodies do at ``y``, a displacement against the points at depth where a body has one."""
        self.noise = np.zeros_like(y)
        w, bent = self._strips(y, self.low, self.high, sum(self.compliances))
        for body, weights, k in zip(self.bodies, self.weights, self.compliances, strict=True):
            depth = depth_of(body, self.case["element"], y)
            beta = 0.5 / (1.0 - body["poisson"])
            if depth is not None:
                w -= k * self._at_depth(y, self.low, self.high, depth, beta)
            for weight, low, high in self._images(body, weights):
                moved, curved = self._strips(y, low, high, k * weight)
                w, bent = w + moved, bent + curved
                if depth is not None:
                    w -= k * weight * self._at_depth(y, low, high, depth, beta)
            if body.get("images") == "series" and min(weights) > 0.0 and depth is not None:
                w += k * self._from_afar(body, weights, y, depth, beta)
        return w, bent

    def _images(self, body, weights):
        """Yield (weight, low, high) of the strips mirrored at either face, at the other one, and so on."""
        if body.get("length") is None:
            return
        images = body.get("images", 1)
        count = self._near_links(body) if images == "series" else 2 * images - 1
        faces = faces_of(body)
        for first in (0, 1):
            low, high, weight = self.low, self.high, 1.0
            for link in range(count):
                at = (first + link) % 2
                weight *= weights[at] if link == 0 else min(weights[at], 1.0)
                if weight < 1e-13:
                    break
                low, high = 2.0 * faces[at] - high, 2.0 * faces[at] - low
                yield weight, low, high

    def _near_links(self, body):
        """Images nearer than some half-widths are no forces."""
        return min(max(NEAR_LINKS, math.ceil(NEAR_WIDTHS * self.a.max() / body["length"])), MOST_NEAR_LINKS)

    def _strips(self, y, low, high, k):
        a_high, b_high = self.kernel((high - y[:, None]) / self.a)
        a_low, b_low = self.kernel((low - y[:, None]) / self.a)
        self.noise += 4.0 * EPS * k * ((np.abs(a_high) + np.abs(a_low)) @ self.q)
        return k * ((a_high - a_low) @ self.q), k * ((b_high - b_low) @ (self.q / self.a**2))

    def _at_depth(self, y, low, high, depth, beta):
        """Boussinesq's displacement below the centre line, 1/R + beta d^2/R^3 per unit force, along each strip."""

        def integral(edge):
            u = (edge - y[:, None]) / depth[:, None]
            return np.arcsinh(u) + beta * u / np.sqrt(1.0 + u * u)

        return (integral(high) - integral(low)) @ self.q

    def _from_afar(self, body, weights, y, depth, beta):
        """The images of a series beyond the near ones: forces where their loads have their centre, then an integral."""
        forces = self.q * (self.high - self.low)
        centre, length, faces = (
            float(forces @ (0.5 * (self.low + self.high)) / forces.sum()),
            body["length"],
            faces_of(body),
        )
        total = np.zeros_like(y)
        for first in (0, 1):
            place, weight, places, kept = centre, 1.0, [], []
            for link in range(FAR_LINKS):
                at = (first + link) % 2
                weight *= weights[at] if link == 0 else min(weights[at], 1.0)
                place = 2.0 * faces[at] - place
                if link >= self._near_links(body):
                    places.append(place)
                    kept.append(weight)
            s = np.abs(np.array(places) - y[:, None])
            slant = np.hypot(s, depth[:, None])
            total += (1.0 / s - (1.0 + beta * (depth[:, None] / slant) ** 2) / slant) @ np.array(kept)
            u = length * (FAR_LINKS + 0.5) / depth
            total += kept[-1] / length * (np.arcsinh(u) - np.log(2.0 * u) - beta * (1.0 - u / np.hypot(1.0, u)))
        return total * forces.sum()


def faces_of(body):
    half = math.inf if body.get("length") is None else 0.5 * body["length"]
    return body.get("position", 0.0) - half, body.get("position", 0.0) + half


def face_weights(case):
    """Weights (low, high) of each body's images, lowered where those on one side exceed 1 together."""
    bodies = (case["a"], case["b"])
    asked = [_asked(body) for body in bodies]
    stiffness = np.array([compliance(body) for body in bodies])
    shares = stiffness / stiffness.sum()
    weights = [[0.0, 0.0], [0.0, 0.0]]
    for side in (0, 1):
        faces = [faces_of(body)[side] for body in bodies]
        nearness = 0.0
        if all(math.isfinite(face) for face in faces):
            low, high = common_interval(case)
            place = np.array([min(max(0.5 * (faces[0] + faces[1]), low), high)])
            nearness = max(0.0, 1.0 - abs(faces[0] - faces[1]) * float(curvature(case, place)[0]) / APART)
            nearness = 1.0 if nearness > TOGETHER else nearness
        for one, other in ((0, 1), (1, 0)):
            kappa = shares[one] * asked[one][side] + nearness * shares[other] * asked[other][side]
            weights[one][side] = asked[one][side] / max(kappa, 1.0)
    return weights


def _asked(body):
    if body.get("length") is None:
        return 0.0, 0.0
    rules = body.get("side_faces", "mirror")
    rules = rules if isinstance(rules, tuple) else (rules, rules)
    words = {"none": 0.0, "mirror": 1.0, "calibrated": float(np.interp(body["poisson"], *CALIBRATED))}
    return tuple(words[rule] if isinstance(rule, str) else float(rule) for rule in rules)


def depth_of(body, element, y):
    """Depth under each ``y`` of the point that displacement is measured against; None for one far away."""
    rule = body.get("depth", "plane-strain" if body["kind"] == "Roller" else "none")
    if rule == "none":
        return None
    if not isinstance(rule, str):
        return np.full_like(y, rule)
    diameter = 2.0 / _curvature_of(body, y)
    if rule == "diameter":
        return diameter
    # 2 K q (ln(d / a) + C - beta) of a long strip has to be Johnson's K q (2 ln(2 D / b) - 1), b = ratio a.
    beta = 0.5 / (1.0 - body["poisson"])
    return diameter * 2.0 / HERTZ_RATIO[element] * math.exp(beta - far_constant(element) - 0.5)
