"""Gradients: the change of a number of a solution with all inputs, by one adjoint solve.

The strips stay where they are, or move in proportion with the length on which the bodies can touch, so that a gradient
is that of the number which these strips give, exactly.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.influence import Influence, influence_of
from nonhertz.errors import InputError, nearest
from nonhertz.inputs.checks import finite, positive
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.result.measures import Measure, measure_of
from nonhertz.result.outcome import Judgement
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.status import Status
from nonhertz.strip.adjoint import Linearisation, linearise
from nonhertz.strip.influence import kernel_of

if TYPE_CHECKING:
    from nonhertz.result.solution import Solution

Array = NDArray[np.float64]
Family = Callable[[float], Contact]

GIVEN = (("approach", "load"), ("tilt", "moment"))
# Of a parameter: the step of differences of the bodies' shapes, which err by its fourth power.
STEP = 1e-3
# Linear equations of solutions, for one gradient after the other; not part of these, which are saved and sent.
_KNOWN: WeakKeyDictionary[Solution, _Linear] = WeakKeyDictionary()
_FIVE_POINTS = ((-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0))


@dataclass(frozen=True, eq=False, repr=False)
class Gradient(ReadOnly):
    """The gradient of a number of a solution; made by `Solution.gradient`.

    Attributes
    ----------
    solution : Solution
        The solution.
    quantity : str or Measure
        The number.
    holding : tuple of str
        The quantities that are given and held constant: ``"load"`` or ``"approach"``, and ``"tilt"`` or ``"moment"``.
    value : float
        The number, in its unit.
    relief, curvature : ndarray, shape (strips,)
        Derivatives by the separation h [mm] and by the curvature across 1/rho [1/mm] at each strip; zero out of
        contact.
    given : dict
        Derivatives by the two quantities that are given.
    """

    solution: Solution
    quantity: str | Measure
    holding: tuple[str, str]
    value: float
    relief: Array
    curvature: Array
    given: dict[str, float]
    _at: _Linear
    _sensitivities: Array
    _by_compliance: float

    def __repr__(self) -> str:
        derivatives = ", ".join(f"d/d{name} {value:.6g}" for name, value in self.given.items())
        name = self.quantity if isinstance(self.quantity, str) else repr(self.quantity)
        return f"Gradient(of {name} = {self.value:.6g} at a given {' and '.join(self.holding)}: {derivatives})"

    @cached_property
    def modulus(self) -> tuple[float, float]:
        """Derivatives by Young's modulus of body a and of body b [per MPa]; of one material, their sum counts."""
        a, b = (self.by(f"{body}.material.modulus") for body in ("a", "b"))
        return a, b

    def by(self, name: str) -> float:
        """Return the derivative by a number in the contact.

        Parameters
        ----------
        name : str
            Its name, such as ``"a.profile.end_radius"``, ``"a.corner_radius"``, ``"b.diameter"``, or with an index
            ``"a.profile.profiles.0.radius"``.

        Returns
        -------
        float
            In the unit of the quantity over that of the number.

        Raises
        ------
        InputError
            If there is no such number, or it is zero, so that no relative step can be taken: then use `along`.
        """
        family, at = family_of(self.solution.contact, name)
        if at == 0.0 or not math.isfinite(at):
            raise InputError(name, at, "be finite and not zero, for a step relative to it", "use along() with a step")
        return self.along(family, at)

    def along(self, family: Family, at: float, step: float | None = None) -> float:
        """Return the derivative along a family of contacts with one parameter.

        Parameters
        ----------
        family : callable
            Parameter -> contact; smooth around ``at``, where it is the contact of the solution.
        at : float
            The parameter.
        step : float, optional
            Step of the parameter for differences of the shapes, two to each side; a thousandth of ``at`` by default. No
            contact is solved.

        Returns
        -------
        float
            Exact, except for these differences.

        Raises
        ------
        InputError
            If the family returns no contacts, or the step is not positive.
        """
        if not callable(family):
            raise InputError("family", family, "be a function", "give a function of a number that returns a Contact")
        finite("at", at, "give the parameter of the solution's contact")
        step = STEP * abs(at) if step is None else step
        positive("step", step, "give a step of the parameter")
        total, measure = 0.0, measure_of(self.quantity)
        for steps, weight in _FIVE_POINTS:
            contact = family(at + steps * step)
            if not isinstance(contact, Contact):
                raise InputError("family", contact, "return a Contact", "give a function of a number that returns one")
            moved = self._at.moved(contact)
            by_force = self.holding[0] == "load", self.holding[1] == "moment"
            value = -self._sensitivities @ self._at.residuals(contact, moved, by_force)
            value += self._by_compliance * contact.compliance
            if moved is not self.solution:
                value += measure.partials(moved).value
            total += weight / step * float(value)
        return total


@dataclass(frozen=True, eq=False)
class _Linear:
    """A linearised solution, and its residuals for bodies of another shape."""

    solution: Solution
    linear: Linearisation
    influence: Influence
    grid: core.Grid

    @classmethod
    def of(cls, solution: Solution) -> _Linear:
        influence = influence_of(solution.contact, solution.element)
        m = solution.element_half_width**2
        r = np.divide(solution.contact.compliance * solution.line_load, m, out=np.zeros_like(m), where=m > 0.0)
        grid = _grid(solution, influence)
        return cls(solution, linearise(grid, r, m, kernel_of(influence, solution.element)), influence, grid)

    def moved(self, contact: Contact) -> Solution:
        """Return the same line loads and half-widths on strips that move with the ends of a contact.

        Bends of the profile, such as the beginnings of corners, keep their places among the strips.
        """
        old, new = landmarks(self.solution.contact), landmarks(contact)
        if old.size != new.size:
            old, new = old[[0, -1]], new[[0, -1]]
        if np.array_equal(old[[0, -1]], new[[0, -1]]) or not np.all(np.isfinite([old, new])):
            return self.solution

        def to(place: Any) -> Any:
            return np.interp(place, old, new)

        solution, edges = self.solution, to(self.solution.edges)
        forces = solution.line_load * np.diff(edges)
        return dataclasses.replace(
            solution,
            edges=edges,
            load=float(forces.sum()),
            moment=float(forces @ (0.5 * (edges[1:] + edges[:-1]))),
            judgement=Judgement.of(
                contact_y=tuple((to(start), to(end)) for start, end in solution.contact_y),
                edge_pressure=solution.edge_pressure,
                singular_ends=tuple(dataclasses.replace(end, y=to(end.y)) for end in solution.singular_ends),
                peaks_at_corner=solution.peaks_at_corner,
                error_estimate=solution.error_estimate,
                findings=(),
            ),
        )

    def residuals(self, contact: Contact, moved: Solution, by_force: tuple[bool, bool]) -> Array:
        """Return the residuals of loads and half-widths for a contact, shape (2 k + 2,).

        Parameters
        ----------
        contact : Contact
            Contact with curvature and gap.
        moved : Solution
            Strips, and sums of their loads.
        by_force : tuple of bool
            Whether load and moment are given.
        """
        linear = self.linear
        influence = influence_of(contact, moved.element)
        grid = _grid(moved, influence)
        y, (displaced, _, curved, _), loads = linear.y, linear.blocks, linear.r * linear.m
        alike = np.array_equal(influence.terms, self.influence.terms) and influence.faces == self.influence.faces
        alike = alike and np.array_equal(grid.by_width, self.grid.by_width)
        if moved is not self.solution or not alike:
            m = moved.element_half_width**2
            again = linearise(grid, m, m, kernel_of(influence, moved.element))
            y, (displaced, _, curved, _) = again.y, again.blocks
        elif not np.array_equal(grid.at_depth, self.grid.at_depth):
            displaced = displaced + (self.grid.at_depth - grid.at_depth)[np.ix_(linear.active, linear.active)]
        bent = curved @ linear.r - contact.curvature_at(y)
        gap = displaced @ loads + contact.separation_at(y) - moved.tilt * y
        forces = self.solution.contact.compliance * np.array([moved.load, moved.moment]) * by_force
        return np.concatenate([bent, gap, forces])


def gradient(solution: Solution, quantity: str | Measure, holding: tuple[str, str]) -> Gradient:
    """Return a gradient; see `Solution.gradient`."""
    if solution.status is not Status.CONVERGED:
        raise InputError("solution", solution.status.name, "have converged", "solve on other strips")
    if not isinstance(holding, tuple | list) or len(holding) != 2:
        raise InputError("holding", holding, "name two quantities", "give ('load', 'tilt'), say")
    for name, names in zip(holding, GIVEN, strict=True):
        if name not in names:
            raise InputError("holding", tuple(holding), f"have {names[0]} or {names[1]}", "give ('load', 'tilt'), say")
    partials = measure_of(quantity).partials(solution)
    at = _linear(solution)
    active, y, k = at.linear.active, at.linear.y, at.linear.r.size
    by_p = (partials.by_pressure * solution.centre_pressure)[active]
    by_b = (partials.by_half_width * solution.half_width)[active]
    # p = 2 q / (pi b), and both p and the loads are over K.
    loads = at.linear.loads / solution.contact.compliance
    by_loads = (partials.by_load + partials.by_moment * y) * loads
    derivatives = np.concatenate(
        [by_p + by_loads, 0.5 * by_p + 0.5 * by_b + by_loads, [partials.by_approach, partials.by_tilt]]
    )
    by_force = holding[0] == "load", holding[1] == "moment"
    sensitivities = at.linear.sensitivities(by_force, derivatives)
    compliance = solution.contact.compliance
    by_prescribed, by_compliance = {}, -float(by_p.sum() + by_loads.sum()) / compliance
    for name, force, sensitivity in zip(holding, by_force, sensitivities[2 * k :].tolist(), strict=True):
        by_prescribed[name] = compliance * sensitivity if force else sensitivity
        by_compliance += sensitivity * getattr(solution, name) if force else 0.0
    relief, curvature = np.zeros(solution.strips), np.zeros(solution.strips)
    relief[active], curvature[active] = -sensitivities[k : 2 * k], sensitivities[:k]
    return Gradient(
        solution,
        quantity,
        (holding[0], holding[1]),
        partials.value,
        relief,
        curvature,
        by_prescribed,
        at,
        sensitivities,
        by_compliance,
    )


def _linear(solution: Solution) -> _Linear:
    if solution not in _KNOWN:
        _KNOWN[solution] = _Linear.of(solution)
    return _KNOWN[solution]


def landmarks(contact: Contact) -> Array:
    """Return the ends of the interval that can touch, and the bends of the profiles between them [mm]."""
    low, high = contact.interval
    return np.array([low, *(bend for bend in contact.bends if low < bend < high), high])


def family_of(contact: Contact, name: str) -> tuple[Family, float]:
    """Return the family of contacts that differ in one number, and its value.

    Parameters
    ----------
    contact : Contact
        The contact.
    name : str
        Names of attributes and indices, joined by dots.

    Raises
    ------
    InputError
        If it does not lead to a number; the sentence names the existing ones.
    """
    if not isinstance(name, str):
        raise InputError("name", name, "be text", "give a name such as 'a.corner_radius'")
    parts = name.split(".")
    inside: list[Any] = [contact]
    for part in parts:
        names = _names(inside[-1])
        if part not in names:
            near = nearest(part, names)
            remedy = f"did you mean {near!r}?" if near else f"there are {', '.join(names) or 'no numbers below it'}"
            raise InputError("name", name, "lead to a number of the contact", remedy)
        inside.append(names[part])
    at = inside.pop()
    if isinstance(at, bool) or not isinstance(at, int | float):
        remedy = f"go on to one of {', '.join(_names(at))}" if _names(at) else "name one that is a number"
        raise InputError("name", name, "lead to a number of the contact", remedy)

    def family(value: float) -> Contact:
        changed: Any = value
        for holder, part in zip(reversed(inside), reversed(parts), strict=True):
            changed = _with(holder, part, changed)
        assert isinstance(changed, Contact)
        return changed

    return family, float(at)


def _names(holder: object) -> dict[str, Any]:
    if dataclasses.is_dataclass(holder) and not isinstance(holder, type):
        return {field.name: getattr(holder, field.name) for field in dataclasses.fields(holder) if field.init}
    if isinstance(holder, tuple):
        return {str(number): item for number, item in enumerate(holder)}
    return {}


def _with(holder: Any, part: str, value: object) -> Any:
    if isinstance(holder, tuple):
        number = int(part)
        return (*holder[:number], value, *holder[number + 1 :])
    return dataclasses.replace(holder, **{part: value})


def _grid(solution: Solution, influence: Influence) -> core.Grid:
    """Return the strips of a solution without the bodies' shapes."""
    y, edges, nothing = solution.y, solution.edges, np.zeros(solution.strips)
    at_depth = influence.at_depth(y, edges) if influence.references else np.zeros((0, 0))
    by_width = influence.by_width(y, solution.element.hertz_ratio)
    return core.Grid(edges, nothing, nothing, nothing, nothing, at_depth, by_width)
