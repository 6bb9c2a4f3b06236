"""Stress in hollow rollers by finite elements of their own: prints hollow-roller-stress.txt.

Quadratic elements of nine nodes between bore and surface, one linear system for each number n of waves around, stress
from displacement at the elements' own shape functions. Nothing of `nonhertz.bodies` is used: of the package only the
loads and half-widths of the strips of a solved contact. Half the size of the elements moves the stress at the bore by
0.02 % (bores of half the diameter and more; 0.3 % at 0.3, 3 % at 0.15), in the middle of the wall by 0.5 %.
"""

import itertools

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu
from scipy.special import j1

import nonhertz as nh

MOST = 80  # waves around
POINTS = ((0.0, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.98, 0.0), (90.0, 0.0, 0.0), (90.0, 0.5, 0.5), (45.0, -0.7, 0.0))
"""Angle from the load [degrees], place over the half-length, share of the wall from the bore."""


def solutions():
    """Yield ten random contacts of hollow rollers, the last four tapered."""
    rng = np.random.default_rng(33)
    for number in range(10):
        diameter, shape, bore = rng.uniform(8.0, 60.0), rng.uniform(0.4, 2.2), rng.uniform(0.3, 0.88)
        length = shape * diameter
        sizes = {"diameter": diameter, "bore": bore * diameter}
        if number >= 6:
            ends, change = (-0.5 * length, 0.5 * length), rng.uniform(-0.08, 0.08, 2) * diameter * (1.0 - bore)
            sizes = {
                name: nh.TabulatedDiameter(ends, (size - by, size + by))
                for (name, size), by in zip(sizes.items(), change, strict=True)
            }
        roller = nh.Roller(
            **sizes,
            length=length,
            material=nh.Material(206e3, rng.uniform(0.2, 0.4)),
            profile=nh.profile.crown(radius=rng.uniform(100.0, 400.0) * diameter),
        )
        load = rng.uniform(20.0, 60.0) * length * diameter * (1.0 - bore)
        contact = nh.Contact(roller, nh.Ring(diameter=4.0 * diameter))
        yield nh.solve(contact, load=load, tilt=rng.uniform(0.0, 3e-4), strips=41)


def von_mises(solution, poisson=0.3, across=14, along=40):
    """Return the von Mises stress of body a at `POINTS`."""
    body = solution.contact.a
    half = 0.5 * body.length
    s = 0.5 - 0.5 * np.cos(np.pi * np.linspace(0.0, 1.0, 2 * across + 1))  # finer towards bore and surface
    z = half * np.sin(0.5 * np.pi * np.linspace(-1.0, 1.0, 2 * along + 1))
    s[1::2], z[1::2] = 0.5 * (s[:-1:2] + s[2::2]), 0.5 * (z[:-1:2] + z[2::2])
    outer, inner = (
        np.array([0.5 * float(d(y)) if callable(d) else 0.5 * d for y in z]) for d in (body.diameter, body.bore)
    )
    r = inner + s[:, None] * (outer - inner)
    mesh = _Mesh(r, np.broadcast_to(z, r.shape), poisson)
    total = np.zeros((len(POINTS), 6))
    for n in range(0, MOST + 1, 2):
        moved = mesh.solved(n, _forces(solution, n, z, outer, 2.0 if n else 1.0))
        for k, (angle, place, share) in enumerate(POINTS):
            turn = n * np.radians(angle)
            around = np.where([True, True, True, False, True, False], np.cos(turn), np.sin(turn))
            total[k] += around * mesh.stress_at(n, moved, s, z, share, half * place)
    a, b, c, d, e, f = total.T
    return np.sqrt(0.5 * ((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2) + 3.0 * (d * d + e * e + f * f))


def _forces(solution, n, z, outer, weight):
    """Return radial and axial forces normal to the surface at its nodes, consistent with quadratic shape functions.

    Under equal ones all around (n = 0) the axial ones are left to a rib.
    """
    node, gauss = np.polynomial.legendre.leggauss(4)
    slope = (outer[-1] - outer[0]) / (z[-1] - z[0])  # of a cylinder or a cone
    found = np.zeros(z.size)
    for low, high, q, b in zip(
        solution.edges[:-1], solution.edges[1:], solution.line_load, solution.half_width, strict=True
    ):
        # A strip may span several elements.
        cuts = np.unique(np.clip(np.concatenate([[low], z[::2], [high]]), low, high))
        for first, last in itertools.pairwise(cuts):
            if q == 0.0:
                continue
            for x, w in zip(node, gauss, strict=True):
                y = 0.5 * (first + last) + 0.5 * (last - first) * x
                turns = max(n * b / np.interp(y, z, outer), 1e-9)
                force = weight / np.pi * q * 2.0 * j1(turns) / turns * 0.5 * (last - first) * w
                e = min(max(int(np.searchsorted(z[::2], y)) - 1, 0), z[::2].size - 2)
                t = 2.0 * (y - z[2 * e]) / (z[2 * e + 2] - z[2 * e]) - 1.0
                found[2 * e : 2 * e + 3] -= force * _shape(t)[0]
    return found, -slope * found if n else np.zeros_like(found)


def _shape(t):
    """Return the three quadratic functions on -1, 0, 1 and their slopes."""
    return np.array([0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)]), np.array([t - 0.5, -2.0 * t, t + 0.5])


class _Mesh:
    def __init__(self, r, z, poisson):
        self.r, self.z, rows, columns = r, z, *r.shape
        i, j = np.meshgrid(np.arange(0, rows - 1, 2), np.arange(0, columns - 1, 2), indexing="ij")
        local = (np.arange(3)[:, None] * columns + np.arange(3)).ravel()
        self.nodes = (i * columns + j).ravel()[:, None] + local
        self.size = r.size
        self.elastic = np.diag([2.0, 2.0, 2.0, 1.0, 1.0, 1.0])
        self.elastic[:3, :3] += 2.0 * poisson / (1.0 - 2.0 * poisson)
        self.unknowns = np.concatenate([self.nodes + c * self.size for c in range(3)], axis=1)

    def strains(self, n, a, b, elements=slice(None)):
        """Return what makes strains rr, tt, zz, rt, rz, tz of nodal u, v, w at local places, and the measure."""
        (f, fa), (g, gb) = _shape(a), _shape(b)
        value, by_a, by_b = np.outer(f, g).ravel(), np.outer(fa, g).ravel(), np.outer(f, gb).ravel()
        r, z = self.r.ravel()[self.nodes[elements]], self.z.ravel()[self.nodes[elements]]
        ra, rb, za, zb, radius = r @ by_a, r @ by_b, z @ by_a, z @ by_b, r @ value
        determinant = ra * zb - rb * za
        by_r = (zb[:, None] * by_a - za[:, None] * by_b) / determinant[:, None]
        by_z = (ra[:, None] * by_b - rb[:, None] * by_a) / determinant[:, None]
        over, none = value / radius[:, None], np.zeros_like(by_r)
        rows = [
            [by_r, none, none], [over, n * over, none], [none, none, by_z],
            [-n * over, by_r - over, none], [by_z, none, by_r], [none, by_z, -n * over],
        ]  # fmt: skip
        return np.array([np.concatenate(row, axis=1) for row in rows]).transpose(1, 0, 2), determinant * radius

    def solved(self, n, forces):
        node, weight = np.polynomial.legendre.leggauss(3)
        local = 0.0
        for a, wa in zip(node, weight, strict=True):
            for b, wb in zip(node, weight, strict=True):
                strain, measure = self.strains(n, a, b)
                local = local + np.einsum(
                    "esi,st,etj->eij", strain * (wa * wb * measure)[:, None, None], self.elastic, strain, optimize=True
                )
        count = self.unknowns.shape[1]
        rows, columns = np.repeat(self.unknowns, count, axis=1), np.tile(self.unknowns, (1, count))
        stiffness = sparse.csc_matrix((local.ravel(), (rows.ravel(), columns.ravel())), shape=(3 * self.size,) * 2)
        free = np.ones(3 * self.size, dtype=bool)
        if n == 0:
            free[self.size : 2 * self.size] = False
            free[2 * self.size] = False
        load = np.zeros(3 * self.size)
        for component, of_nodes in zip((0, 2), forces, strict=True):
            last = (component + 1) * self.size
            load[last - of_nodes.size : last] = of_nodes
        moved = np.zeros(3 * self.size)
        moved[free] = splu(
            stiffness[free][:, free], "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        ).solve(load[free])
        return moved

    def stress_at(self, n, moved, s, z, share, place):
        """Return the six stresses at a place, the mean of the elements that meet there."""
        found = []
        for e_s in np.flatnonzero((s[:-1:2] <= share + 1e-9) & (s[2::2] >= share - 1e-9)):
            for e_z in np.flatnonzero((z[:-1:2] <= place + 1e-9) & (z[2::2] >= place - 1e-9)):
                a = 2.0 * (share - s[2 * e_s]) / (s[2 * e_s + 2] - s[2 * e_s]) - 1.0
                b = 2.0 * (place - z[2 * e_z]) / (z[2 * e_z + 2] - z[2 * e_z]) - 1.0
                element = int(e_s) * (z.size // 2) + int(e_z)
                strain, _ = self.strains(n, a, b, slice(element, element + 1))
                found.append(self.elastic @ (strain[0] @ moved[self.unknowns[element]]))
        return np.mean(found, axis=0)


if __name__ == "__main__":
    for one in solutions():
        print(*von_mises(one, one.contact.a.material.poisson).round(2))
