"""Write docs/explain/end-table.md: what strips make of a sharp end, against solutions free across.

    python docs/end_study.py

The reference shares no equation with the strips, only the start of its iteration. Along y it has strips too, but
across each the pressure is (1 - xi^2)^(1/2) times a polynomial in xi^2 = (x / a)^2, and displacements are required at
several places across, not displacement and curvature on the centre line. The half-widths a(y) follow from the condition
that the pressure falls to zero at the edge: (1 - xi^2)^(-1/2) is a further shape, and where its coefficient is c times
that of the semi-ellipse, a is to be larger by the fraction c. a(y) is a smooth curve through these; what little of the
further shape remains makes up for it to first order. Both bodies are half-spaces, with an image of weight kappa about
each end.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.polynomial.chebyshev import chebvander
from numpy.typing import NDArray
from scipy.special import beta

import nonhertz as nh
from nonhertz.result import end_fit
from nonhertz.result.maximum import largest_half_width

Array = NDArray[np.float64]

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "explain" / "end-table.md"
RADIUS = 10.0  # mm
# Places across, and powers of 1 - xi^2. From 4 to 7 of them K changes by +9e-4, -3e-4, +1e-4.
ACROSS = 5
POWERS = np.arange(-1, ACROSS - 1) + 0.5
FIRST_STRIP, GROWTH = 1e-3, 1.15  # of the half-width; from strip to strip
NODES, STEP = 28, 0.1  # of the double exponential rule, on either side of its middle
SMOOTH = 8  # degree of a(y) in the logarithm of the distance from the end
PASSES, SETTLED = 20, 1e-6


@dataclass(frozen=True)
class Case:
    """A roller of diameter 20 mm on a flat."""

    kappa: float
    length: float
    load: float
    crown: float = math.inf

    @property
    def contact(self) -> nh.Contact:
        """The same for strips."""
        profile = nh.profile.crown(self.crown) if math.isfinite(self.crown) else nh.profile.straight()
        weight = 2.0 * self.kappa if self.kappa else "none"
        roller = nh.Roller(diameter=2.0 * RADIUS, length=self.length, profile=profile, side_faces=weight, depth="none")
        return nh.Contact(roller, nh.Plate())


@dataclass(frozen=True)
class FreeAcross:
    """A solution of one half of a symmetric contact, arrays from the end inwards."""

    edges: Array
    pressure: Array
    half_width: Array


CASES = (
    Case(0.0, 20.0, 20e3),
    Case(0.0, 20.0, 20e3, crown=4000.0),
    Case(0.0, 20.0, 500.0),
    Case(0.0, 6.0, 20e3),
    Case(0.0, 2.0, 4e3),
    Case(0.25, 20.0, 20e3),
    Case(0.5, 20.0, 20e3),
    Case(0.5, 20.0, 20e3, crown=4000.0),
    Case(0.5, 20.0, 500.0),
    Case(0.5, 2.0, 4e3),
    Case(0.8, 20.0, 20e3),
    Case(0.8, 20.0, 20e3, crown=4000.0),
)


def main() -> None:
    """Measure and write the page."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    PAGE.write_text("\n".join(_page()) + "\n", encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")


def _page() -> Iterator[str]:
    yield "# The strength of sharp ends, measured"
    yield ""
    yield "Computed by `docs/end_study.py`. [Theory](singular-ends.md#sharp-ends)."
    yield ""
    yield "Rollers of 20 mm diameter on a flat, both half-spaces of steel, with images that add up to kappa. The"
    yield "reference leaves the pressure across free (`docs/end_study.py`); the last four columns are over it. K *of"
    yield "strips*: on its own fine strips, without the factor for the shape across; *reported*: `strength` of a solve"
    yield "on the automatic grid. Half-widths of that solve: *at the end*, in the last strip, and *largest*,"
    yield "`max_half_width`, more than a half-width from sharp ends."
    yield ""
    roller = "length [mm], load [N], crown [mm]"
    head = "kappa", roller, "half-width / length", "K", "of strips", "reported", "at the end", "largest"
    yield "| " + " | ".join(head) + " |"
    yield "|---|---|---|---|---|---|---|---|"
    for case in CASES:
        yield _row(case)


def _row(case: Case) -> str:
    true = solve_free(case)
    fine = _on_edges(case, true.edges)
    solution = nh.solve(case.contact, load=case.load)
    edge = solution.edge_pressure[1]
    strength = _strength(true.edges, true.pressure, case.kappa, true.half_width[0])
    assert strength is not None
    assert edge.strength is not None
    of_strips = _strength(true.edges, fine.centre_pressure[::-1], case.kappa, fine.half_width[-1])
    assert of_strips is not None
    y = 0.5 * (true.edges[1:] + true.edges[:-1])
    inside = float(largest_half_width(y, true.half_width, np.zeros(1))[0])
    cells = (
        f"{case.kappa:g}",
        f"{case.length:g}, {case.load:g}, {case.crown:g}",
        f"{true.half_width[-1] / case.length:.3f}",
        f"{strength:.2f}",
        f"{of_strips / strength:.4f}",
        f"{edge.strength / strength:.4f}",
        f"{solution.half_width[-1] / true.half_width[0]:.3f}",
        f"{solution.max_half_width / inside:.4f}",
    )
    return "| " + " | ".join(cells) + " |"


def _strength(edges: Array, pressure: Array, kappa: float, half_width: float) -> float | None:
    # Any element but the semi-elliptic one, for which a factor stands for the shape across.
    return end_fit.fit_strength(edges, pressure[: edges.size - 1], (kappa, 0.0), half_width, nh.PARABOLIC)[0]


def _on_edges(case: Case, edges: Array) -> nh.Solution:
    half = 0.5 * case.length
    outer = half - edges[:-1]
    return nh.solve(case.contact, load=case.load, strips=np.concatenate([-outer, [0.0], outer[::-1]]))


def solve_free(case: Case) -> FreeAcross:
    """Return the contact with the pressure free across."""
    half, compliance = 0.5 * case.length, case.contact.compliance
    a_line = math.sqrt(4.0 * compliance * case.load / case.length * RADIUS)
    edges = _graded(half, FIRST_STRIP * a_line)
    y = 0.5 * (edges[1:] + edges[:-1])
    relief = (half - y) ** 2 / (2.0 * case.crown)
    xi = np.cos((2.0 * np.arange(ACROSS) + 1.0) * math.pi / (4.0 * ACROSS))
    # The iteration converges quadratically, but only from near enough. The result does not depend on the start.
    a = _smoothed(y, np.diff(edges), _on_edges(case, edges).half_width[::-1][: y.size])
    for _ in range(PASSES):
        x = a[:, None] * xi
        matrix = np.zeros((x.size + 1, x.size + 1))
        matrix[:-1, :-1] = compliance * _displacements(edges, y, a, x, half, case.kappa)
        matrix[:-1, -1] = -1.0
        matrix[-1, :-1] = (2.0 * np.diff(edges)[:, None] * a[:, None] * beta(0.5, POWERS + 1.0)).ravel()
        known = np.append((-relief[:, None] - x**2 / (2.0 * RADIUS)).ravel(), case.load)
        scale = np.linalg.norm(matrix, axis=1)
        shapes = np.linalg.solve(matrix / scale[:, None], known / scale)[:-1].reshape(y.size, ACROSS)
        wider = _smoothed(y, np.diff(edges), a * np.clip(1.0 + shapes[:, 0] / shapes[:, 1], 0.7, 1.4))
        change, a = float(np.max(np.abs(wider / a - 1.0))), wider
        if change < SETTLED:
            return FreeAcross(edges, shapes.sum(axis=1), a)
    raise RuntimeError(f"the half-widths of {case} still change by {change:.1g}")


def _graded(half: float, first: float) -> Array:
    """Return edges of strips from an end to the middle, ever wider."""
    number = math.ceil(math.log1p(half / first * (GROWTH - 1.0)) / math.log(GROWTH))
    widths = GROWTH ** np.arange(number)
    return np.concatenate([[0.0], np.cumsum(widths) * half / widths.sum()])


def _smoothed(y: Array, width: Array, a: Array) -> Array:
    near = 0.02 * a[-1]
    log = np.log1p(y / (5.0 * near))
    powers = chebvander(2.0 * log / log.max() - 1.0, SMOOTH)
    weight = np.where(y > near, 1.0, 1e-3) * np.sqrt(width / (width + near))
    smooth: Array = powers @ np.linalg.lstsq(powers * weight[:, None], a * weight, rcond=None)[0]
    return smooth


def _displacements(edges: Array, y: Array, a: Array, x: Array, half: float, kappa: float) -> Array:
    """Return the integral of every shape of every strip over 1 / distance, (strips * ACROSS)^2."""
    t = STEP * np.arange(-NODES, NODES + 1)
    weight = STEP * 0.5 * math.pi * np.cosh(t) / np.cosh(0.5 * math.pi * np.sinh(t)) ** 2
    to_high = 2.0 / (1.0 + np.exp(math.pi * np.sinh(t)))  # 1 - u, and 1 + u is its mirror image
    to_low = to_high[::-1]
    at_y, at_x = np.repeat(y, ACROSS), x.ravel()
    columns = []
    for strip in range(y.size):
        # Two parts, divided where the distance is least, so that the rule's nodes crowd there and at both edges.
        inner = np.minimum(at_x / a[strip], 1.0)[:, None]
        beyond = np.maximum(at_x / a[strip], 1.0)[:, None] - 1.0
        total = np.zeros((at_x.size, ACROSS))
        for length, ahead, apart in (
            (0.5 * (1.0 + inner), 1.0 - inner + 0.5 * (1.0 + inner) * to_high, 0.5 * (1.0 + inner) * to_high),
            (0.5 * (1.0 - inner), 0.5 * (1.0 - inner) * to_high, 0.5 * (1.0 - inner) * to_low),
        ):
            distance = np.maximum(a[strip] * (apart + beyond), 1e-300)
            rest = ahead * (2.0 - ahead)  # 1 - xi^2
            sides = _along(edges[strip], edges[strip + 1], at_y[:, None], distance, half, kappa)
            kernel = sides * weight * length * a[strip]
            counted = rest > 0.0
            for which, power in enumerate(POWERS):
                total[:, which] += np.where(counted, kernel * np.where(counted, rest, 1.0) ** power, 0.0).sum(axis=1)
        columns.append(total)
    return np.concatenate(columns, axis=1)


def _along(low: float, high: float, y: Array, distance: Array, half: float, kappa: float) -> Array:
    """Return the integral along a strip, its mirror image in the middle and their images about both ends.

    Positions along are distances from one end.
    """
    total = np.zeros(np.broadcast_shapes(y.shape, distance.shape))
    whole = 2.0 * half
    pairs = [(low, high, 1.0), (whole - high, whole - low, 1.0)]
    if kappa > 0.0:
        pairs += [(-high, -low, kappa), (whole + low, whole + high, kappa)]
        pairs += [(low - whole, high - whole, kappa), (2.0 * whole - high, 2.0 * whole - low, kappa)]
    for start, end, weight in pairs:
        total += weight * (np.arcsinh((end - y) / distance) - np.arcsinh((start - y) / distance))
    return total


if __name__ == "__main__":
    main()
