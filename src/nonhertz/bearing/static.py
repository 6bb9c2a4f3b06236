"""Static safety of a bearing by the maximum pressure.

ISO 76 defines the static rating by 4000 MPa, which leave a permanent dent of 1e-4 of the roller's diameter. The safety
here is the factor on the load of the contact with the maximum pressure at which it reaches the limit, at constant tilt,
from a solution of the contact itself. For Hertz's line contact it would be (4000 / p)^2; profiles or a tilt change it,
since the load then spreads along the roller or shifts to an end.
"""

from __future__ import annotations

import math

from nonhertz.bearing.laminae import singular_ends
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.inputs.checks import positive
from nonhertz.result.ends import ends_in_words
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve

LIMIT = 4000.0  # MPa
_FURTHEST, _STEP = 1e6, 4.0
_EXACT = 1e-6


def pressure_safety(solution: BearingSolution, limit: float = LIMIT) -> float:
    """Return the load at which the contact with the maximum pressure reaches a limit over its load [-].

    Parameters
    ----------
    solution : BearingSolution
        The loaded bearing, solved by strips.
    limit : float
        Pressure limit [MPa].

    Returns
    -------
    float
        The safety; infinite where nothing is loaded, below 1 where the limit is exceeded.

    Raises
    ------
    InputError
        If the bearing was solved by slices, or the pressure is singular at an end of a loaded contact.

    Notes
    -----
    Only the load of that contact is raised, at its tilt. In the bearing a larger load is shared by more rollers, so
    that the bearing's load may grow by more, and tilts may change: solve it under the larger load to be sure.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, corner_radius=0.3, profile=nh.profile.crown(radius=1200))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> pressure_safety(nh.bearing.solve(row, radial=10e3)) > 1.5
    True
    """
    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a loaded bearing", "solve one with nonhertz.bearing.solve")
    positive("limit", limit, "give the pressure in MPa, 4000 by ISO 76")
    if ends := singular_ends(solution):
        condition = f"have finite pressure at its ends, but it is singular towards {ends_in_words(ends)}"
        raise InputError("solution", "a loaded bearing", condition, "give the rollers a corner_radius or a profile")
    contacts = [contact.solved for contact in solution.distinct_contacts]
    return _factor(max(contacts, key=lambda contact: contact.max_pressure), limit) if contacts else math.inf


def _factor(contact: Solution, limit: float) -> float:
    """Return the factor on the load at which a contact reaches a pressure."""
    from scipy.optimize import brentq

    def above(factor: float) -> float:
        with without_accuracy_warnings():
            solved = solve(contact.contact, load=factor * contact.load, tilt=contact.tilt)
        return math.log(solved.max_pressure / limit)

    step = _STEP if above(1.0) < 0.0 else 1.0 / _STEP
    factor = step
    while (above(factor) < 0.0) is (step > 1.0):
        factor *= step
        if not 1.0 / _FURTHEST < factor < _FURTHEST:
            condition = "be reached within a millionth and a million times the load of the contact"
            raise InputError("limit", limit, condition, "give the pressure in MPa, 4000 by ISO 76")
    low, high = sorted((factor / step, factor))
    return float(brentq(above, low, high, rtol=_EXACT, xtol=_EXACT * low))
