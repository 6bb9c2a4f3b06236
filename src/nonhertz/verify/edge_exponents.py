r"""Sharp ends: how the pressure grows towards them, for several image weights and pairs of materials.

Close to the end p ~ K / s^alpha with cos(pi alpha) = kappa, the weight of the roller's images times its share of the
compliance. The exponent appears only very close to the end: at a tenth of the half-width the slope of ln p is still far
from it. So the strips narrow geometrically, and the exponent is that of the fit

    ln p = ln K - alpha ln s + c1 s^(2 alpha) + c2 s

from some strips off the end to a fraction of the half-width, which is independent of the formula.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Claim, solved

Array = NDArray[np.float64]

TITLE = "Sharp ends: the exponent of the singularity"
LENGTH, LOAD, MODULUS = 20.0, 20000.0, 207000.0
# Weight of the roller's images, and modulus of the plate over that of the roller.
CASES = ((0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.4), (1.0, 2.277), (1.39, 1.0), (1.6, 1.0))
NARROWEST, GROWTH, WIDEST = 3e-5, 1.15, 0.6  # mm, from strip to strip, mm
BIASED_STRIPS, FIT_REACH = 9, 0.3  # the latter in half-widths


@dataclass(frozen=True, eq=False)
class End:
    """Kappa of an end, and the pressure at distances from it in half-widths."""

    kappa: float
    distance: Array
    pressure: Array

    @property
    def expected(self) -> float:
        """The exponent of the formula."""
        return math.acos(self.kappa) / math.pi

    def extrapolated(self) -> float:
        """Return the exponent of the fit."""
        near = (np.arange(self.distance.size) >= BIASED_STRIPS) & (self.distance < FIT_REACH)
        s, log_pressure = self.distance[near], np.log(self.pressure[near])

        def misfit(exponent: float) -> float:
            shape = np.column_stack([np.ones(s.size), s ** (2.0 * exponent), s])
            target = log_pressure + exponent * np.log(s)
            return float(np.sum((shape @ np.linalg.lstsq(shape, target, rcond=None)[0] - target) ** 2))

        return float(minimize_scalar(misfit, bounds=(0.05, 0.7), method="bounded", options={"xatol": 1e-6}).x)


@solved
def end(weight: float, ratio: float) -> End:
    """Return the end of a roller on a plate that goes on beyond it."""
    roller = Roller(diameter=20.0, length=LENGTH, material=Material(MODULUS, 0.3), side_faces=weight, depth="none")
    plate = Plate(material=Material(ratio * MODULUS, 0.3))
    edges = graded_edges(LENGTH, NARROWEST, GROWTH, WIDEST)
    solution = solve(Contact(roller, plate), load=LOAD, strips=edges)
    inwards = slice(None, None, -1)
    distance = (0.5 * LENGTH - solution.y[inwards]) / solution.half_width[-1]
    return End(solution.edge_pressure[1].image_weight, distance, solution.centre_pressure[inwards])


def graded_edges(length: float, narrowest: float, growth: float, widest: float) -> Array:
    """Return the edges of strips over a length, narrowing geometrically towards both ends."""
    widths = [narrowest]
    while widths[-1] < widest and sum(widths) < 0.4 * length:
        widths.append(widths[-1] * growth)
    outer = np.concatenate([[0.0], np.cumsum(widths)])
    inner = np.linspace(outer[-1], 0.5 * length, math.ceil((0.5 * length - outer[-1]) / widths[-1]) + 1)
    from_end = np.concatenate([outer, inner[1:]])
    return np.concatenate([from_end - 0.5 * length, (0.5 * length - from_end)[-2::-1]])


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for weight, ratio in CASES:
        yield _exponent(weight, ratio)


def _exponent(weight: float, ratio: float) -> Claim:
    kappa = weight * ratio / (1.0 + ratio)
    return Claim(
        f"exponent, image weight {weight:g}, modulus of plate / roller {ratio:g}: kappa {kappa:.3f}",
        "cos(pi alpha) = kappa", lambda: end(weight, ratio).expected, lambda: end(weight, ratio).extrapolated(), 0.03,
        absolute=True,
    )  # fmt: skip
