"""Elliptical contacts: both elements against Hertz (paper, Fig. 3), and the parabola's bias by a second program."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.hertz import PointContact, point_contact
from nonhertz.model.body import Body, Plate
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import Profile
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Claim, pressures, series, solved

Array = NDArray[np.float64]

TITLE = "Elliptical contacts: Hertz (paper, Fig. 3)"
STEEL = Material(206000.0, 0.3)
RADIUS_X, RADIUS_Y, LOAD = 10.0, 100.0, 1000.0
EQUAL_STRIPS, REACH = 41, 1.3  # the latter: half the length of the body, in half-lengths of the contact
INSIDE = 0.9  # of the half-length: strips at the end carry a mean over their width
QUANTITIES, UNITS = ("greatest pressure", "greatest half-width", "approach"), ("MPa", "mm", "mm")
# What refinement does not remove from parabolic strips in this contact, in pressure, half-width and approach.
PARABOLIC_BIAS = (0.0061, 0.0065, -0.0143)

# The paper's element in a separate program: Rx 10, 2000 N, 41 strips over 1.35 half-lengths to either side.
# Ellipticity a/b and Ry [mm]; errors of pressure, half-width and approach against Hertz [%].
SECOND, SECOND_LOAD, SECOND_REACH = "a second, separate implementation", 2000.0, 1.35
SECOND_ERRORS = (
    (3, 53.0, (0.72, 0.79, -1.64)),
    (5, 118.3, (0.60, 0.63, -1.39)),
    (10, 365.4, (0.47, 0.47, -1.13)),
    (20, 1176.5, (0.38, 0.37, -0.95)),
    (50, 5810.0, (0.29, 0.29, -0.79)),
)
# Pressure over Hertz's greatest at places over the half-length, with a/b = 10.
SHAPE = {0.4: 0.9191, 0.6: 0.7993, 0.8: 0.5920, 0.9: 0.4159}


@dataclass(frozen=True)
class Parabola(Profile):
    """The relief of Hertz's theory, y^2 / (2 R); a circle differs from it by more than the tolerances here."""

    radius: float

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]."""
        return np.asarray(np.asarray(y, dtype=float) ** 2 / (2.0 * self.radius))


def hertz(radius_y: float = RADIUS_Y, load: float = LOAD) -> PointContact:
    """Return the exact solution."""
    return point_contact(radius_x=RADIUS_X, radius_y=radius_y, load=load, compliance=2.0 * STEEL.compliance)


@solved
def on_strips(exact: PointContact, element: Element, reach: float, strips: int | None) -> Solution:
    """Return the same contact on equal strips, or on the automatic grid (None)."""
    body = Body(
        diameter=2.0 * exact.radius_x, length=2.0 * reach * exact.half_length, profile=Parabola(exact.radius_y),
        material=STEEL, side_faces="none", depth="none",
    )  # fmt: skip
    accuracy = 1e-5 if strips is None else None
    contact = Contact(body, Plate(material=STEEL))
    return solve(contact, load=exact.load, element=element, strips=strips, accuracy=accuracy)


def found(solution: Solution) -> tuple[float, float, float]:
    """Return pressure, half-width and approach."""
    return solution.max_pressure, float(solution.half_width.max()), solution.approach


def errors(solution: Solution, exact: PointContact) -> Array:
    """Return their relative differences from Hertz."""
    return np.asarray(np.array(found(solution)) / (exact.max_pressure, exact.half_width, exact.approach) - 1.0)


def off(solution: Solution, exact: PointContact) -> tuple[Array, Array, Array]:
    """Return positions inside [mm], and the differences of pressure and half-width there over Hertz's maxima."""
    inside = np.abs(solution.y) < INSIDE * exact.half_length
    y = solution.y[inside]
    pressure = (solution.centre_pressure[inside] - exact.pressure(y)) / exact.max_pressure
    return y, pressure, (solution.half_width[inside] - exact.half_width_at(y)) / exact.half_width


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for element in (SEMI_ELLIPTIC, PARABOLIC):
        yield from _against_hertz(element, EQUAL_STRIPS, f"{EQUAL_STRIPS} equal strips", 2e-4, 3e-3)
        yield from _against_hertz(element, None, "automatic grid", 5e-5, 5e-4)
    for ellipticity, radius_y, expected in SECOND_ERRORS:
        yield from series(
            [f"parabolic, a/b = {ellipticity}: {name} over Hertz's" for name in QUANTITIES], SECOND, expected,
            functools.partial(_second_errors, radius_y), 0.006, "%", absolute=True, why="two decimals are given",
        )  # fmt: skip
    yield from series(
        [f"parabolic, a/b = 10: pressure at y/a = {place:g} over Hertz's greatest" for place in SHAPE],
        SECOND, list(SHAPE.values()), _shape, 2e-4, absolute=True,
        why="between strip centres the pressure is interpolated linearly, as in the other program",
    )  # fmt: skip


def _against_hertz(
    element: Element, strips: int | None, grid: str, within: float, along_within: float
) -> Iterator[Claim]:
    exact, biased = hertz(), element is PARABOLIC
    targets = [exact.max_pressure, exact.half_width, exact.approach]
    sources, case, why = ["Hertz"] * 3, f"{element.name}, {grid}", ""
    if biased:
        sources = [f"Hertz {100.0 * bias:+.2f} %, the element's bias" for bias in PARABOLIC_BIAS]
        targets = [target * (1.0 + bias) for target, bias in zip(targets, PARABOLIC_BIAS, strict=True)]
        within, why = 3e-4, "41 strips add 2e-4 to the bias"

    def solution() -> Solution:
        return on_strips(exact, element, REACH, strips)

    quantities = [f"{case}: {name}" for name in QUANTITIES]
    yield from series(quantities, sources, targets, lambda: found(solution()), within, UNITS, why=why)
    yield Claim(
        f"{case}: largest difference of pressure within {INSIDE:g} half-lengths, of the greatest", "Hertz", 0.0,
        lambda: float(np.max(np.abs(off(solution(), exact)[1]))), None if biased else along_within, absolute=True,
    )  # fmt: skip


def _second_errors(radius_y: float) -> Array:
    exact = hertz(radius_y, SECOND_LOAD)
    return 100.0 * errors(on_strips(exact, PARABOLIC, SECOND_REACH, EQUAL_STRIPS), exact)


def _shape() -> Array:
    exact = hertz(365.4, SECOND_LOAD)
    solution = on_strips(exact, PARABOLIC, SECOND_REACH, EQUAL_STRIPS)
    return np.array(pressures(solution, np.array(list(SHAPE)) * exact.half_length)) / exact.max_pressure
