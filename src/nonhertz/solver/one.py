"""The entry point for one case: a contact and its loading in, a solution out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError, shown
from nonhertz.findings import warn
from nonhertz.inputs.checks import finite, numbers, one_of
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.model.profile.base import at_ends
from nonhertz.native import core
from nonhertz.result.outcome import outcome
from nonhertz.result.solution import Solution
from nonhertz.solver.refusals import refusal
from nonhertz.strip.element import ELEMENTS, SEMI_ELLIPTIC, Element
from nonhertz.strip.problem import Flags, Problem, StripModel, Target

Array = NDArray[np.float64]
#: A number of equal strips, the edges of strips, or an automatic grid.
Strips = int | Literal["auto"] | ArrayLike | None
#: Quantities that the accuracy may refer to.
Goal = Literal["approach", "pressure"]
GOALS: tuple[Goal, ...] = ("approach", "pressure")

ACCURACY = 1e-4  # of the approach, by default
FEWEST_STRIPS, MOST_STRIPS = 1, 2000
# Coarser grids take as long, and some miss peaks of the pressure without notice.
FINEST_ACCURACY, COARSEST_ACCURACY = 1e-6, 1e-3
PRESSURE_ACCURACY = 1e-3  # of the maximum pressure, by default


def solve(
    contact: Contact,
    *,
    approach: float | None = None,
    load: float | None = None,
    tilt: float | None = None,
    moment: float | None = None,
    element: Element | str = SEMI_ELLIPTIC,
    strips: Strips = None,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
) -> Solution:
    """Solve the elastic contact of two bodies under a load or approach, and a tilt or moment.

    Quantities may be text with a unit, such as ``"20 kN"``.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    approach : float, optional
        delta [mm]: how far the bodies move together on the line y = 0. Give this or ``load``.
    load : float, optional
        Q [N], positive. Give this or ``approach``.
    tilt : float, optional
        gamma [rad] about x; the interference is approach + tilt y - separation. Zero if neither this nor
        ``moment`` is given.
    moment : float, optional
        T [N mm], integral of pressure times y.
    element : Element or str
        SEMI_ELLIPTIC, or the paper's PARABOLIC, or its name.
    strips : int or array_like or "auto", optional
        A number: that many equal strips over the length on which both bodies can touch. An array: the edges of
        the strips [mm], ascending. Omitted or ``"auto"``: a graded grid adapted to the contact.
    accuracy : float, optional
        The target relative error of the approach, or of the load where the approach is given, from 1e-6 to 1e-3; the
        automatic grid gets as many strips as that needs. If left out, 1e-4. ``solution.error_estimate`` says
        whether it was met.
    accuracy_of : str, optional
        ``"approach"``, or ``"pressure"`` for a grid that aims at this relative error of the maximum pressure, and
        at least at the default accuracy of the approach; ``accuracy`` is then 1e-3 if left out.

    Returns
    -------
    Solution
        Approach, load, tilt and moment, pressures and half-widths along y, stiffness and estimated errors.

    Raises
    ------
    InputError
        If the input is invalid.
    ConvergenceError
        If the Newton loop fails; its ``solution`` holds the state reached.

    Warns
    -----
    AccuracyWarning
        If the result strains the model's validity, the requested accuracy was not met, or the pressure is singular at
        an end of the contact; ``solution.findings`` has the details.

    Notes
    -----
    The contact is cut along y into strips, each with a pressure of fixed shape across x; both surfaces touch to second
    order on the centre line of every loaded strip. Bodies are linear elastic, without friction; the contact must be
    longer than wide and small compared with the radii. Findings report a case beyond these limits: see
    docs/explain/validity.md.

    References
    ----------
    J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal uniform/parabolic surface pressure half-space element for the
    analysis of non-Hertzian contact, Computational Mechanics, CIMNE, Barcelona 1998. H. Reusner, the semi-elliptic
    element; see `nonhertz.strip.element.Element`.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
    >>> solution = nh.solve(nh.Contact(roller, nh.Plate()), load=20e3, tilt=0.5e-3)
    >>> round(solution.moment / solution.load, 2)
    0.81
    """
    prescription = Prescription(approach=approach, load=load, tilt=tilt, moment=moment)
    problem = problem_of(contact, prescription, element, strips, accuracy, accuracy_of)
    solution = outcome(problem, result_of(problem, strips_of(problem, strips)))
    warn(solution.findings)
    return solution


def problem_of(
    contact: Contact,
    prescription: Prescription,
    element: Element | str,
    strips: Strips = None,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
) -> Problem:
    """Return the problem that the strips have to solve.

    Raises
    ------
    InputError
        If ``contact`` or ``element`` is not a Contact or an Element, no pressure between the ends of the bodies can
        produce the moment, or ``accuracy`` or ``accuracy_of`` is out of range.
    """
    if not isinstance(contact, Contact):
        raise InputError("contact", contact, "be a Contact", "make one of two bodies with nonhertz.Contact")
    element = element_of(element)
    refuse_accuracy(strips, accuracy, accuracy_of)
    prescription.refuse_outside(contact)
    problem = pose_problem(
        contact, element, prescription.by_force, prescription.target(contact.compliance),
        (accuracy or ACCURACY) if is_automatic(strips) else None, accuracy_given=accuracy is not None,
    )  # fmt: skip
    if accuracy_of != "pressure":
        return problem
    of_pressure = accuracy or PRESSURE_ACCURACY
    # The estimate for the maximum pressure is never below the grid's target for the approach.
    return replace(problem, accuracy=min(0.5 * of_pressure, ACCURACY), pressure_accuracy=of_pressure)


def bound_contact(problem: Problem) -> tuple[float, float]:
    """Return the interval that contains the contact [mm]; finite even where the bodies are unbounded.

    Raises
    ------
    InputError
        If the contact is unbounded, or the prescribed values cannot be met.
    """
    try:
        low, high = core.bound_contact(problem.model.in_core, problem.by_force, problem.target)
    except core.Refused as refused:
        raise refusal(problem, refused) from None
    return low, high


def pose_problem(
    contact: Contact,
    element: Element,
    by_force: Flags,
    target: Target,
    accuracy: float | None,
    *,
    accuracy_given: bool,
) -> Problem:
    """Return the problem of a contact; arguments as in `Problem`."""
    return Problem(contact, StripModel.of(contact, element), by_force, target, accuracy, accuracy_given)


def element_of(element: Element | str) -> Element:
    """Return a strip element, which may be given by its name."""
    chosen = ELEMENTS.get(element, element) if isinstance(element, str) else element
    if not isinstance(chosen, Element):
        remedy = "use nonhertz.SEMI_ELLIPTIC or nonhertz.PARABOLIC"
        raise InputError("element", element, "be an element", remedy)
    return chosen


def refuse_accuracy(strips: Strips, accuracy: float | None, accuracy_of: str | None = None) -> None:
    """Refuse an accuracy out of range, and any accuracy together with given strips."""
    if accuracy_of is not None:
        one_of("accuracy_of", accuracy_of, GOALS, "leave it out for the accuracy of the approach")
        if not is_automatic(strips):
            remedy = "leave out one of the two"
            raise InputError("accuracy_of", accuracy_of, "be given only where the grid is automatic", remedy)
    if accuracy is None:
        return
    remedy = f"leave it out for {ACCURACY:g}"
    finite("accuracy", accuracy, remedy)
    if not FINEST_ACCURACY <= accuracy <= COARSEST_ACCURACY:
        raise InputError("accuracy", accuracy, f"lie between {FINEST_ACCURACY:g} and {COARSEST_ACCURACY:g}", remedy)
    if not is_automatic(strips):
        remedy = "leave out the accuracy or the strips"
        raise InputError("accuracy", accuracy, "be given only where the grid is automatic", remedy)


def is_automatic(strips: Strips) -> bool:
    """Return whether the grid is to be adapted to the contact."""
    return strips is None or (isinstance(strips, str) and strips == "auto")


def strips_of(problem: Problem, strips: Strips) -> core.Accuracy | int | Array:
    """Return the requested strips, as the core takes them."""
    count, edges = requested_strips(problem.contact, strips)
    if edges is not None:
        return edges
    if count is not None:
        return count
    of_pressure = math.inf if problem.pressure_accuracy is None else problem.pressure_accuracy
    return core.Accuracy(problem.accuracy or ACCURACY, of_pressure)


def result_of(problem: Problem, strips: core.Accuracy | int | Array) -> core.Result:
    """Return the result from the core.

    Raises
    ------
    InputError
        If no strips can meet the prescribed values.
    """
    try:
        result = core.solve(problem.model.in_core, problem.by_force, problem.target, strips)
    except core.Refused as refused:
        raise refusal(problem, refused) from None
    assert result is not None  # only a signal stops it, whose exception propagates
    return result


def requested_strips(contact: Contact, strips: Strips) -> tuple[int | None, Array | None]:
    """Return the number of equal strips or the edges of given ones; both None for an automatic grid."""
    remedy = "leave it out for an automatic grid"
    if is_automatic(strips):
        return None, None
    if isinstance(strips, (int, np.integer)) and not isinstance(strips, bool):
        if not FEWEST_STRIPS <= strips <= MOST_STRIPS:
            raise InputError("strips", strips, f"lie between {FEWEST_STRIPS} and {MOST_STRIPS}", remedy)
        return int(strips), None
    if isinstance(strips, (Sequence, np.ndarray)) and not isinstance(strips, str):
        return None, _check_edges(contact, strips)
    raise InputError("strips", strips, "be 'auto', a whole number or edges", remedy)


def _check_edges(contact: Contact, strips: ArrayLike) -> Array:
    low, high = contact.interval
    remedy = "give ascending strip edges in mm within the bodies"
    try:
        edges = numbers("strips", strips, remedy)
    except InputError:
        raise InputError("strips", strips, "be ascending and finite", remedy) from None
    if edges.ndim != 1 or not FEWEST_STRIPS < edges.size <= MOST_STRIPS + 1:
        raise InputError(
            "strips",
            edges.shape,
            f"be a row of {FEWEST_STRIPS + 1} to {MOST_STRIPS + 1} edges",
            remedy,
        )
    edges = at_ends(edges, contact.interval)
    if not np.all(np.isfinite(edges)) or np.any(np.diff(edges) <= 0.0):
        raise InputError("strips", edges.tolist(), "be ascending and finite", remedy)
    if edges[0] < low or edges[-1] > high:
        condition = f"lie between {shown(low)} and {shown(high)}"
        raise InputError("strips", (float(edges[0]), float(edges[-1])), condition, remedy)
    return edges
