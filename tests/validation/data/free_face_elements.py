"""Stress near free side faces by finite elements: makes `free-faces.json`, in ten minutes.

A body between two free side faces, of infinite depth, bears pressures that vary as cos(k x): for each k elements of
degree 6 in a section along the axis, graded to the face, then a sum over k. Of the package only the pressures are used
(the pieces of strips that the field is the field of), and none of its fields, images or corrections.

Run as ``python free_face_elements.py``; it goes on where it was stopped.
"""

import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import scipy.sparse as sp
from numpy.polynomial import legendre
from scipy.sparse.linalg import splu
from scipy.special import j1

import nonhertz as nh
from nonhertz.subsurface.lamination import laminate

DATA = Path(__file__).with_name("free-faces.json")
DEGREE = 6
SMALLEST, GROWTH, LONGEST = 0.04, 2.2, 3.0  # elements [mm]
DISTANCES = (0.0, 0.1, 0.15, 0.25, 0.4, 0.7, 1.2)  # of the places from the face [mm]
DEPTHS = (0.25, 0.5, 0.8, 1.2)  # and across: over the half-width
ACROSS = (0.0, 0.5, 0.9)


def cases() -> dict[str, dict[str, object]]:
    """Return what is solved: both bodies of the issue's contact, and random ones."""
    found: dict[str, dict[str, object]] = {
        "both end": {
            "roller": {"diameter": 20.0, "length": 20.0}, "other": {"diameter": 80.0, "length": 20.0, "depth": 10.0},
            "poisson": 0.3, "profile": None, "load": 20e3, "tilt": 0.0,
        }
    }  # fmt: skip
    random = np.random.default_rng(33)
    for number in range(15):
        diameter, length = random.uniform(8.0, 40.0), random.uniform(4.0, 14.0)
        roller = {"diameter": diameter, "length": length}
        profile = [None, ["crown", random.uniform(200.0, 900.0)], ["tapered_ends", 0.6 * length, 2e-3]][number % 3]
        if number % 4 == 1:
            roller["corner_radius"] = random.uniform(0.1, 0.4)
        if number % 4 == 3:
            roller["chamfer"] = random.uniform(0.1, 0.3)
        other = {"diameter": float(random.choice([60.0, 120.0, -90.0])), "depth": 12.0}
        if number % 2:
            other["length"] = length
        found[f"random {number}"] = {
            "roller": roller, "other": other, "profile": profile,
            "poisson": float(random.choice([0.1, 0.2, 0.25, 0.3, 0.35, 0.45])),
            "load": random.uniform(300.0, 1200.0) * length, "tilt": random.uniform(0.0, 3e-4) * (number % 3 > 0),
        }  # fmt: skip
    for length, poisson in ((2.0, 0.3), (1.2, 0.3), (2.0, 0.4)):  # 6 and 4 half-widths
        narrow = {"length": length, "depth": "plane-strain"}
        found[f"{length:g} mm wide, nu = {poisson:g}"] = {
            "roller": {"diameter": 20.0, **narrow}, "other": {"diameter": 80.0, "length": length, "depth": 10.0},
            "poisson": poisson, "profile": None, "load": 1000.0 * length, "tilt": 0.0,
        }  # fmt: skip
    return found


def solved(case: dict[str, object]) -> nh.Solution:
    """Return the solution of a case."""
    material = nh.Material(206000.0, case["poisson"])
    given = dict(case["roller"])
    if "chamfer" in given:
        given["chamfer"] = nh.Chamfer(given["chamfer"], angle=np.pi / 6)
    if case["profile"] is not None:
        kind, *numbers = case["profile"]
        given["profile"] = getattr(nh.profile, kind)(*numbers)
    contact = nh.Contact(nh.Roller(material=material, **given), nh.Ring(material=material, **case["other"]))
    return nh.solve(contact, load=case["load"], tilt=case["tilt"])


def places(solution: nh.Solution) -> np.ndarray:
    """Return where the stress is compared, near the face at high y of body a, shape (places, 3)."""
    b, face = solution.max_half_width, solution.contact.a.faces[1]
    x, d, z = np.meshgrid(b * np.array(ACROSS), DISTANCES, b * np.array(DEPTHS), indexing="ij")
    kept = (d > 0.0) | (z > 0.1)
    return np.stack([x, face - d, z], axis=-1)[kept]


class Body:
    """A section of elements along the axis (from the face at high y inwards) and below the surface, for one k."""

    def __init__(self, y: np.ndarray, z: np.ndarray, k: float, poisson: float) -> None:
        self.y, self.z, self.k, self.poisson = y, z, k, poisson
        self.nodes = np.concatenate([[-1.0], np.sort(legendre.Legendre.basis(DEGREE).deriv().roots().real), [1.0]])
        (m_y, s_y, g_y), (m_z, s_z, g_z) = self._line(y), self._line(z)
        self.shape = m_y.shape[0], m_z.shape[0]
        mu, lam = 0.5 / (1.0 + poisson), poisson / (1.0 + poisson) / (1.0 - 2.0 * poisson)
        self.mu, self.lam, a, both = mu, lam, lam + 2.0 * mu, sp.kron
        # u_x varies as sin(k x), the others as cos(k x).
        xx = a * k * k * both(m_y, m_z) + mu * (both(s_y, m_z) + both(m_y, s_z))
        xy = lam * k * both(g_y.T, m_z) - mu * k * both(g_y, m_z)
        xz = lam * k * both(m_y, g_z.T) - mu * k * both(m_y, g_z)
        yy = a * both(s_y, m_z) + mu * (k * k * both(m_y, m_z) + both(m_y, s_z))
        yz = lam * both(g_y, g_z.T) + mu * both(g_y.T, g_z)
        zz = a * both(m_y, s_z) + mu * (k * k * both(m_y, m_z) + both(s_y, m_z))
        stiffness = sp.bmat([[xx, xy, xz], [xy.T, yy, yz], [xz.T, yz.T, zz]], format="csc")
        fixed = np.zeros((3, *self.shape), dtype=bool)
        fixed[:, :, -1] = True
        self.free = np.flatnonzero(~fixed.ravel())
        self.solved = splu(
            stiffness[self.free][:, self.free], permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}
        )

    def _at(self, local: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the polynomials of an element and their slopes, shape (places, degree + 1)."""
        to = np.linalg.inv(legendre.legvander(self.nodes, DEGREE))
        slopes = np.array([legendre.legval(local, legendre.legder(unit)) for unit in np.eye(DEGREE + 1)]).T
        return legendre.legvander(local, DEGREE) @ to, slopes @ to

    def _line(self, edges: np.ndarray) -> tuple[sp.csr_matrix, sp.csr_matrix, sp.csr_matrix]:
        """Return the matrices of value times value, slope times slope, slope times value."""
        point, weight = legendre.leggauss(DEGREE + 2)
        value, slope = self._at(point)
        size = (edges.size - 1) * DEGREE + 1
        found = [sp.lil_matrix((size, size)) for _ in range(3)]
        for i, half in enumerate(0.5 * np.diff(edges)):
            own = slice(i * DEGREE, (i + 1) * DEGREE + 1)
            found[0][own, own] += half * (value.T * weight) @ value
            found[1][own, own] += (slope.T * weight) @ slope / half
            found[2][own, own] += (slope.T * weight) @ value
        return tuple(each.tocsr() for each in found)

    def bear(self, low: np.ndarray, high: np.ndarray, pressure: np.ndarray) -> None:
        """Solve for a pressure that is constant between distances from the face, ``low`` to ``high``."""
        force = np.zeros((3, *self.shape))
        point, weight = legendre.leggauss(DEGREE + 2)
        cuts = np.unique(np.concatenate([self.y, low, high]))
        cuts = cuts[(cuts >= 0.0) & (cuts <= self.y[-1])]
        middle, half = 0.5 * (cuts[1:] + cuts[:-1]), 0.5 * np.diff(cuts)
        element = np.searchsorted(self.y, middle) - 1
        order = np.argsort(low)
        piece = order[np.clip(np.searchsorted(low[order], middle) - 1, 0, None)]
        acting = np.where((middle > low[piece]) & (middle < high[piece]), pressure[piece], 0.0)
        for m, h, e, p in zip(middle, half, element, acting, strict=True):
            if p:
                size = self.y[e + 1] - self.y[e]
                value, _ = self._at((2.0 * (m + h * point) - self.y[e] - self.y[e + 1]) / size)
                force[2, e * DEGREE : (e + 1) * DEGREE + 1, 0] += p * h * weight @ value
        moved = np.zeros(force.size)
        moved[self.free] = self.solved.solve(force.ravel()[self.free])
        self.moved = moved.reshape(force.shape)

    def stress(self, distance: float, depth: float) -> np.ndarray:
        """Return sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy, with y from the face inwards."""
        if depth > self.z[-1]:
            return np.zeros(6)
        (i, v, v_y), (j, w, w_z) = (self._place(edges, at) for edges, at in ((self.y, distance), (self.z, depth)))
        u = self.moved[:, i, j]
        of = lambda a, c, b: float(a @ u[c] @ b)  # noqa: E731
        e_x, e_y, e_z = self.k * of(v, 0, w), of(v_y, 1, w), of(v, 2, w_z)
        mean = self.lam * (e_x + e_y + e_z)
        shear = (
            of(v, 1, w_z) + of(v_y, 2, w),
            of(v, 0, w_z) - self.k * of(v, 2, w),
            of(v_y, 0, w) - self.k * of(v, 1, w),
        )
        return np.array([*(mean + 2.0 * self.mu * each for each in (e_x, e_y, e_z)), *(self.mu * s for s in shear)])

    def _place(self, edges: np.ndarray, at: float) -> tuple[slice, np.ndarray, np.ndarray]:
        i = int(np.clip(np.searchsorted(edges, at, side="right") - 1, 0, edges.size - 2))
        size = edges[i + 1] - edges[i]
        value, slope = self._at(np.array([(2.0 * at - edges[i] - edges[i + 1]) / size]))
        return slice(i * DEGREE, (i + 1) * DEGREE + 1), value[0], slope[0] * 2.0 / size


def graded(through: list[float], end: float, longest: float) -> np.ndarray:
    """Return edges of elements from 0 to ``end`` that are small at all places to go through."""
    points = sorted({0.0, *(each for each in through if 0.0 < each < end)})
    found = [0.0]
    while found[-1] < end:
        nearest = min(abs(found[-1] - each) for each in points)
        ahead = min([each - found[-1] for each in points if each > found[-1]], default=np.inf)
        step = min(max(SMALLEST, (GROWTH - 1.0) * nearest), longest, max(SMALLEST, 0.5 * ahead))
        found.append(found[-1] + step)
    return np.append(found[:-1], end)


def reference(solution: nh.Solution) -> np.ndarray:
    """Return the stress at `places`, shape (places, 6)."""
    pieces, body = laminate(solution), solution.contact.a
    own = slice(pieces.first[0], None)
    face, length, b = body.faces[1], body.length, solution.max_half_width
    low, high = face - pieces.high[own], face - pieces.low[own]
    load, width = pieces.line_load[own], pieces.half_width[own]
    points = places(solution)
    section, back = np.unique(np.column_stack([face - points[:, 1], points[:, 2]]), axis=0, return_inverse=True)
    edges = [0.0, 0.3 / length]
    while edges[-1] < 18.0 / b:
        edges.append(edges[-1] + min(edges[-1], 4.0 / b))
    total = np.zeros((len(points), 6))
    for first, last in pairwise(edges):
        # The first part adds half a per cent, evenly, and the elements of a long thin body are ill-conditioned.
        node, weight = legendre.leggauss(1 if first == 0.0 else 3 if last - first < 3.9 / b else 4)
        for k, share in zip(0.5 * (first + last) + 0.5 * (last - first) * node, weight, strict=True):
            mesh = graded([float(low.min())], length, LONGEST), graded([], 14.0 / k, max(3.0 / k, 0.1))
            elements = Body(*mesh, k, body.material.poisson)
            elements.bear(low, high, load * 2.0 * j1(k * width) / (k * width))
            mode = np.array([elements.stress(*each) for each in section])[back.ravel()]
            phase = k * points[:, :1]
            wave = np.concatenate([np.cos(phase)] * 4 + [np.sin(phase)] * 2, axis=1)
            total += 0.5 * (last - first) * share / np.pi * mode * wave
    total[:, [3, 5]] *= -1.0  # y points outwards
    return total


def main() -> None:
    """Solve all cases that are not stored yet."""
    stored = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    for name, case in cases().items():
        if name not in stored:
            solution = solved(case)
            stored[name] = case | {"stress": reference(solution).round(2).tolist()}
            DATA.write_text(json.dumps(stored) + "\n", encoding="utf-8")
            print(name, flush=True)


if __name__ == "__main__":
    main()
