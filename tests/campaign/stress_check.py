"""A field looked at without the package: point loads, pressures and images worked out here, from arrays alone.

The pressure follows nonhertz/subsurface/lamination.py: semi-ellipses across; along, curves between the centres of the
strips that bear the load of each. Here it is a function of y that is integrated point by point, with neither pieces nor
closed forms.
"""

from itertools import pairwise

import numpy as np
from scipy.interpolate import PchipInterpolator

TURNS, TURN_WEIGHTS = np.polynomial.legendre.leggauss(8)
ACROSS = 64
ROWS, COLUMNS = 40, 14  # of a deep plane
NARROWEST = 1e-4  # of a strip's squared half-width


class Pressed:
    """Line load and half-width of a solution as functions along y."""

    def __init__(self, edges, line_load, half_width, contact_y):
        self.edges, self.q, self.b = (np.asarray(each, dtype=float) for each in (edges, line_load, half_width))
        self.y, self.width = 0.5 * (self.edges[1:] + self.edges[:-1]), np.diff(self.edges)
        self.strips = np.flatnonzero(self.q > 0.0)
        self.load = float(np.sum(self.q * self.width))
        self.moment = float(np.sum(self.q * self.width * self.y))
        self.reach = 0.5 * float(self.edges[self.strips[-1] + 1] - self.edges[self.strips[0]])
        self.at_edges, self.vanishing = {}, {}
        for run, ends in zip(self._runs(), contact_y, strict=True):
            self._see(run, ends)
        self._limit()

    def _runs(self):
        return np.split(self.strips, np.flatnonzero(np.diff(self.strips) > 1) + 1)

    def _see(self, run, ends):
        """Note load and m at the edges of each strip of one contact, and where its ends run out."""
        m = self.b[run] ** 2
        r = self.q[run] / m
        edges = self.edges[run[0] : run[-1] + 2]
        of_m, of_r = self._through(run, m, edges, 0.0), self._through(run, r, edges, 0.5)
        for k, strip in enumerate(run):
            self.at_edges[strip] = [
                (of_m[j] * of_r[j] / self.q[strip], of_m[j] / m[k]) for j in (k, k + 1)
            ]  # load and m at either edge
        if run.size > 1:
            for strip, end, side in ((run[0], ends[0], -1), (run[-1], ends[1], 1)):
                edge = self.edges[strip + (side > 0)]
                next_out = self.y[strip + side] if 0 <= strip + side < self.y.size else edge
                if end not in (edge, next_out, self.y[strip]):
                    self.vanishing[strip] = 2.0 * (end - self.y[strip]) / self.width[strip]

    def _through(self, run, value, edges, least):
        if run.size == 1:
            return np.array([value[0], value[0]])
        y = self.y[run]
        low = value[0] + (edges[0] - y[0]) * (value[1] - value[0]) / (y[1] - y[0])
        high = value[-1] + (edges[-1] - y[-1]) * (value[-1] - value[-2]) / (y[-1] - y[-2])
        low, high = min(max(low, least * value[0]), 2.0 * value[0]), min(max(high, least * value[-1]), 2.0 * value[-1])
        return np.maximum(PchipInterpolator([edges[0], *y, edges[-1]], [low, *value, high])(edges), 0.0)

    def _limit(self):
        """Find by how much slopes and bends are lowered, how far run-outs are followed, and the scale of it all."""
        t = np.linspace(-1.0, 1.0, 53)
        self.lowered = {}
        for strip, ((low, _), (high, _)) in self.at_edges.items():
            slope, bend = 0.5 * (high - low), 0.5 * (high + low) - 1.0
            self.lowered[strip] = 1.0 / max(1.0, -np.min(slope * t + bend * t**2 * (2.5 * t**2 - 1.5)))
        excess = abs(
            sum(
                self.q[strip] * self.lowered[strip] * 0.5 * (high[0] - low[0]) * self.width[strip] ** 2 / 6.0
                for strip, (low, high) in self.at_edges.items()
            )
        )
        allowed = 2.5e-4 * self.load * self.reach
        self.slopes = allowed / excess if excess > allowed else 1.0
        added = sum(
            self.q[strip] * self.width[strip] * (1.0 - abs(t)) ** 2 / (4.0 * abs(t))
            for strip, t in self.vanishing.items()
        )
        # The line 1 - t / end from one edge to its end, times t.
        turned = sum(
            self.q[strip]
            * self.width[strip] ** 2
            / 4.0
            * abs((t**2 - 1.0) / 2.0 - (abs(t) ** 3 + 1.0) / (3.0 * abs(t)))
            for strip, t in self.vanishing.items()
        )
        self.followed = 1.0 / max(1.0, added / (2e-4 * self.load), turned / allowed)
        self.scale = self.load / (self.load + self.followed * added)

    def cells(self):
        """Yield (strip, first t, last t) of smooth stretches along y."""
        for strip in self.strips:
            end = self.vanishing.get(strip)
            places = sorted({-1.0, 0.0, 1.0} | ({end} if end is not None else set()))
            yield from ((strip, low, high) for low, high in pairwise(places))

    def at(self, strip, t):
        """Line load and half-width at places t of a strip."""
        (low, low_m), (high, high_m) = self.at_edges[strip]
        curve, share = t**2 * (2.5 * t**2 - 1.5), self.lowered[strip]
        of_q, of_m = (
            1.0 + share * (self.slopes * 0.5 * (last - first) * t + (0.5 * (first + last) - 1.0) * curve)
            for first, last in ((low, high), (low_m, high_m))
        )
        inside = np.abs(t) <= 1.0
        of_q, of_m = np.where(inside, np.maximum(of_q, 0.0), 0.0), np.where(inside, np.maximum(of_m, 0.0), 0.0)
        end = self.vanishing.get(strip)
        if end is not None:
            line = np.maximum(1.0 - t / end, 0.0)
            of_q, of_m = (self.followed * line + (1.0 - self.followed) * each for each in (of_q, of_m))
        else:
            highest = max(1.0, *(q / np.sqrt(max(m, NARROWEST)) for q, m in self.at_edges[strip]))
            of_m = np.maximum(of_m, (of_q / highest) ** 2)
        of_m = np.maximum(of_m, NARROWEST)
        return self.scale * self.q[strip] * of_q, self.b[strip] * np.sqrt(of_m)


def stress_below(pressed, point, poisson, images=((1.0, 0.0, 1.0),)):
    """Return the six components at a point below a pressure and its images (sign, offset, weight)."""
    total = np.zeros(6)
    for sign, offset, weight in images:
        seen = (point[0], sign * (point[1] - offset), point[2])
        part = _of_strips(pressed, seen, poisson)
        part[[3, 5]] *= sign
        total += weight * part
    return total


def _of_strips(pressed, point, poisson):
    x, y, z = point
    angle = (np.arange(ACROSS) + 0.5) * np.pi / ACROSS
    across, share = np.cos(angle), 2.0 * np.sin(angle) ** 2 / ACROSS
    total = np.zeros(6)
    for strip, first, last in pressed.cells():
        half = 0.5 * pressed.width[strip]
        # Stretches are halved towards the point until each is no longer than its distance from it.
        for low, high in _towards(first, last, (y - pressed.y[strip]) / half, max(z, 1e-3) / half):
            t = 0.5 * (low + high) + 0.5 * (high - low) * TURNS
            q, b = pressed.at(strip, t)
            load = (q * TURN_WEIGHTS * 0.5 * (high - low) * half)[:, None] * share
            total += _point_loads(x - b[:, None] * across, y - (pressed.y[strip] + half * t)[:, None], z, load, poisson)
    return total


def _towards(low, high, place, distance):
    pending, found = [(low, high)], []
    while pending:
        first, last = pending.pop()
        apart = max(first - place, place - last, 0.0)
        if last - first <= max(distance, apart):
            found.append((first, last))
        else:
            middle = 0.5 * (first + last)
            pending += [(first, middle), (middle, last)]
    return found


def _point_loads(x, y, z, load, poisson):
    """Boussinesq's point loads, summed: Johnson, Contact Mechanics, 1985, Eq. (3.18), in polar coordinates."""
    flat = x * x + y * y
    far = np.sqrt(flat + z * z)
    cosine, sine = x / np.sqrt(flat), y / np.sqrt(flat)
    lateral = (1.0 - 2.0 * poisson) / (far * (far + z))
    radial = lateral - 3.0 * flat * z / far**5
    hoop = (1.0 - 2.0 * poisson) * (z / far**3 - 1.0 / (far * (far + z)))
    shear = -3.0 * np.sqrt(flat) * z * z / far**5
    parts = [
        radial * cosine**2 + hoop * sine**2,
        radial * sine**2 + hoop * cosine**2,
        -3.0 * z**3 / far**5,
        shear * sine,
        shear * cosine,
        (radial - hoop) * cosine * sine,
    ]
    return np.array([np.sum(part * load) for part in parts]) / (2.0 * np.pi)


def images_of(face_low, face_high, weights, links=1):
    """Rows (sign, offset, weight) of a pressure and of its mirror images about two faces, link by link."""
    rows = [(1.0, 0.0, 1.0)]
    for start in (0, 1):
        sign, offset, weight = 1.0, 0.0, 1.0
        for link in range(links):
            at = (start + link) % 2
            face = (face_low, face_high)[at]
            weight *= weights[at]
            if weight == 0.0:
                break
            sign, offset = -sign, 2.0 * face - offset
            rows.append((sign, offset, weight))
    return rows


def carried(stress_at, reach, depth, middle):
    """Return load and moment about y = 0 that a half-space carries through the plane at a depth."""
    turns = (np.arange(ROWS) + 0.5) * np.pi / ROWS - 0.5 * np.pi
    y, dy = middle + reach * np.tan(turns), reach * np.pi / ROWS / np.cos(turns) ** 2
    turns = (np.arange(COLUMNS) + 0.5) * 0.5 * np.pi / COLUMNS
    x, dx = depth * np.tan(turns), 2.0 * depth * 0.5 * np.pi / COLUMNS / np.cos(turns) ** 2
    stress = stress_at(x[:, None], y, depth)
    area = dx[:, None] * dy
    return -float(np.sum(area * stress[..., 2])), -float(np.sum(area * (y * stress[..., 2] - depth * stress[..., 3])))
