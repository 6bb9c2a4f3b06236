"""Numbers of a solution with a gradient, and their dependence on the pressures and half-widths of strips.

`Gradient` takes their names, ``"approach"``, ``"load"``, ``"tilt"``, ``"moment"``, ``"max_pressure"`` and
``"max_half_width"``, or one of the values made here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, positive
from nonhertz.native import core
from nonhertz.result.maximum import singular_y, values_that_count
from nonhertz.result.solution import runs_out

if TYPE_CHECKING:
    from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

STEP = 1e-6  # relative, of half-widths, for derivatives of the ends of a contact and of interpolated values there


@dataclass
class Partials:
    """The value of a measure, and its derivatives.

    Attributes
    ----------
    value : float
        In the unit of the measure.
    by_pressure, by_half_width : ndarray, shape (strips,)
        Derivatives by centre-line pressures and half-widths.
    by_approach, by_tilt, by_load, by_moment : float
        Derivatives by approach, tilt, load and moment.
    """

    value: float
    by_pressure: Array
    by_half_width: Array
    by_approach: float = 0.0
    by_tilt: float = 0.0
    by_load: float = 0.0
    by_moment: float = 0.0

    @classmethod
    def of(cls, solution: Solution, value: float, **motions: float) -> Partials:
        """Return a value that does not depend on single strips."""
        return cls(float(value), np.zeros(solution.strips), np.zeros(solution.strips), **motions)


class Measure(Protocol):
    """A number of a solution that has a gradient."""

    def partials(self, solution: Solution) -> Partials:
        """Return its value and derivatives."""
        ...


@dataclass(frozen=True)
class PressureAt:
    """The centre-line pressure at a place [MPa], interpolated as `Solution.pressure` does.

    Parameters
    ----------
    y : float
        The place [mm].
    """

    y: float

    def __post_init__(self) -> None:
        finite("y", self.y, "give a place along the contact in mm")

    def partials(self, solution: Solution) -> Partials:
        """Return its value and derivatives; both are zero out of contact."""
        return _root(solution, self.y, solution.centre_pressure, of_pressure=True)


@dataclass(frozen=True)
class HalfWidthAt:
    """The half-width at a place [mm], interpolated as for `Solution.pressure`.

    Parameters
    ----------
    y : float
        The place [mm].
    """

    y: float

    def __post_init__(self) -> None:
        finite("y", self.y, "give a place along the contact in mm")

    def partials(self, solution: Solution) -> Partials:
        """Return its value and derivatives; both are zero out of contact."""
        return _root(solution, self.y, solution.half_width, of_pressure=False)


@dataclass(frozen=True)
class PowerIntegral:
    """The integral of p^k b^l over the length in contact, p on the centre line [MPa] and b the half-width [mm].

    Damage by rolling is such an integral: with k = c and l = 1 - h that of Lundberg and Palmgren, up to a factor; with
    k = l = 4.5 that of independent laminae, whose load is proportional to p b.

    Parameters
    ----------
    pressure_power, half_width_power : float
        k and l.
    """

    pressure_power: float
    half_width_power: float = 0.0

    def __post_init__(self) -> None:
        positive("pressure_power", self.pressure_power, "give the power of the pressure, 31/3 say")
        finite("half_width_power", self.half_width_power, "give the power of the half-width")

    def partials(self, solution: Solution) -> Partials:
        """Return its value and derivatives."""
        touching = solution.half_width > 0.0
        p, b = solution.centre_pressure[touching], solution.half_width[touching]
        parts = solution.strip_width[touching] * p**self.pressure_power * b**self.half_width_power
        integral = Partials.of(solution, float(parts.sum()))
        integral.by_pressure[touching] = self.pressure_power * parts / p
        integral.by_half_width[touching] = self.half_width_power * parts / b
        return integral


@dataclass(frozen=True)
class PressureNorm:
    """A smooth approximation of the maximum pressure: the mean of p^k over the contact to the power 1/k [MPa].

    Parameters
    ----------
    power : float
        k; higher values are closer to the maximum pressure. 20 is usual.
    """

    power: float = 20.0

    def __post_init__(self) -> None:
        positive("power", self.power, "give the power, 20 say")

    def partials(self, solution: Solution) -> Partials:
        """Return its value and derivatives, the strips in contact being the same."""
        touching = solution.half_width > 0.0
        p, width = solution.centre_pressure[touching], solution.strip_width[touching]
        most = p.max(initial=0.0)
        if not most > 0.0:
            return Partials.of(solution, 0.0)
        parts = width / width.sum() * (p / most) ** self.power
        value = most * parts.sum() ** (1.0 / self.power)
        norm = Partials.of(solution, value)
        norm.by_pressure[touching] = value * parts / parts.sum() / p
        return norm


@dataclass(frozen=True)
class _Largest:
    """The maximum pressure, or the largest half-width, that counts."""

    of_pressure: bool

    def partials(self, solution: Solution) -> Partials:
        b, ends = solution.half_width, singular_y(solution)
        values = solution.centre_pressure if self.of_pressure else b
        _, candidates, at = values_that_count(solution.y, values, b, ends)
        partials = Partials.of(solution, float(candidates.max()))
        into = partials.by_pressure if self.of_pressure else partials.by_half_width
        if at < solution.strips:
            into[at] = 1.0
            return partials
        # Between two strips, a half-width from an end, by both pressures and both half-widths.
        pair = np.array([at - solution.strips, at - solution.strips + 1])

        def value_at(of_values: Array, of_widths: Array) -> float:
            return float(values_that_count(solution.y[pair], of_values, of_widths, ends)[1][2])

        p, widths = values[pair], b[pair]
        for k, strip in enumerate(pair.tolist()):
            up, down = 1.0 + STEP * (np.arange(2) == k), 1.0 - STEP * (np.arange(2) == k)
            if self.of_pressure:
                change = value_at(p * up, widths) - value_at(p * down, widths)
                partials.by_pressure[strip] = change / (2.0 * STEP * p[k])
                change = value_at(p, widths * up) - value_at(p, widths * down)
            else:
                change = value_at(widths * up, widths * up) - value_at(widths * down, widths * down)
            partials.by_half_width[strip] = change / (2.0 * STEP * widths[k])
        return partials


@dataclass(frozen=True)
class _Motion:
    """Approach, tilt, load or moment."""

    name: str

    def partials(self, solution: Solution) -> Partials:
        motion = {f"by_{self.name}": 1.0}
        return Partials.of(solution, float(getattr(solution, self.name)), **motion)


NAMED: dict[str, Measure] = {name: _Motion(name) for name in ("approach", "load", "tilt", "moment")} | {
    "max_pressure": _Largest(of_pressure=True),
    "max_half_width": _Largest(of_pressure=False),
}


def measure_of(quantity: str | Measure) -> Measure:
    """Return the measure of a name, or a given measure.

    Raises
    ------
    InputError
        If it is neither.
    """
    if isinstance(quantity, str) and quantity in NAMED:
        return NAMED[quantity]
    if isinstance(quantity, str) or not hasattr(quantity, "partials"):
        remedy = "or give a PressureAt, HalfWidthAt, PressureNorm or PowerIntegral"
        raise InputError("quantity", quantity, f"be one of {', '.join(map(repr, NAMED))}", remedy)
    return quantity


def _root(solution: Solution, y: float, values: Array, *, of_pressure: bool) -> Partials:
    """Return the value of `Solution.pressure` at a place: interpolated in the squares of the ``values`` of strips."""
    partials = Partials.of(solution, 0.0)
    number = next((k for k, (low, high) in enumerate(solution.contact_y) if low <= y <= high), None)
    if number is None:
        return partials
    low, high = solution.contact_y[number]
    inside = np.flatnonzero((solution.y > low) & (solution.y < high))
    into = partials.by_pressure if of_pressure else partials.by_half_width
    first, last = int(inside[0]), int(inside[-1])
    if solution.y[first] <= y <= solution.y[last]:
        one = int(np.clip(np.searchsorted(solution.y, y) - 1, first, max(last - 1, first)))
        other = min(one + 1, last)
        share = (y - solution.y[one]) / (solution.y[other] - solution.y[one]) if other > one else 0.0
        partials.value = float(np.sqrt((1.0 - share) * values[one] ** 2 + share * values[other] ** 2))
        into[one] += (1.0 - share) * values[one] / partials.value
        into[other] += share * values[other] / partials.value
        return partials
    side, strip = (0, first) if y < solution.y[first] else (1, last)
    if not runs_out(solution, number, side):
        partials.value = float(values[strip])
        into[strip] = 1.0
        return partials
    # Up to the end of the contact, which follows from the half-widths of the two strips next to it.
    end, here = (low, high)[side], solution.y[strip]
    share = (end - y) / (end - here)
    partials.value = float(values[strip] * np.sqrt(share))
    if not partials.value > 0.0:
        return partials
    into[strip] = np.sqrt(share)
    by_end = 0.5 * values[strip] ** 2 / partials.value * (y - here) / (end - here) ** 2
    for near in {strip, min(max(strip + 1 - 2 * side, first), last)}:
        change = STEP * (np.arange(solution.strips) == near)
        squares = [(solution.half_width * (1.0 + sign * change)) ** 2 for sign in (1, -1)]
        wider, narrower = (core.intervals(solution.edges, widths)[number][side] for widths in squares)
        moved = (wider - narrower) / (2.0 * STEP * solution.half_width[near])
        partials.by_half_width[near] += by_end * moved
    return partials
