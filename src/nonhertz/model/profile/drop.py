"""A profile by its drop at a position, as a drawing states it, instead of the parameter that sets its size.

The drop is the relief at the position minus the relief in the middle of the body. Relief is proportional to an
amplitude, to the tangent of an angle and to an overall factor, so these follow from one evaluation. Other parameters
are searched on a logarithmic scale: first in steps over all sizes, to bracket the stated drop whether it grows or
falls with the parameter and wherever the kind refuses values, then by Brent's method.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from itertools import pairwise
from typing import Any, Final

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, number_that, one_of
from nonhertz.inputs.descriptions import unknown_key_error
from nonhertz.model.profile.base import Profile
from nonhertz.model.profile.kind import CATALOGUE, PARAMETERS

#: Stands for a parameter in kinds without one that a drop could determine.
SCALE: Final = "scale"

AT_REMEDY = "give the position in mm from the middle of the body, on the side where the drop is measured"
_DROP_REMEDY = "give the relief in mm minus that in the middle, negative where the surface is higher than the middle"
# Parameters to which relief is proportional: the value for a multiple of the relief at the value for 1.
_PROPORTIONAL: Final[dict[str, Callable[[float], float]]] = {"amplitude": float, "angle": math.atan}
# Relative difference of drops that is rounding error for the largest arcs.
_UNCHANGED: Final = 1e-6
# Relative error of a drop beyond which the search ended at a jump.
_PASSED: Final = 1e-9
# Steps of the search, in mm or N: beyond anything manufactured, and three to a decade, so that a drop that first
# grows and then falls with a parameter is bracketed on both branches.
_STEPS: Final = np.geomspace(1e-12, 1e12, 73).tolist()


def with_drop(kind: str, drop: float, at: float, **parameters: Any) -> Profile:
    """Return a profile of the catalogue from its drop at a position, which determines one of its parameters.

    Parameters
    ----------
    kind : str
        Its name in case files, such as ``"crown"``.
    drop : float
        Relief at ``at`` minus the relief in the middle of the body [mm].
    at : float
        Position from the middle of the body [mm], not zero; negative for the side of negative y.
    **parameters : object
        The other parameters of the kind, as in the function of that name. The drop determines the first of these that
        is not given: ``radius``, ``straight`` of a partial crown; ``end_radius``, ``radius`` of two radii;
        ``amplitude`` of a logarithm; ``load`` of a profile for a design load, then ``zm``; ``angle``, then ``straight``
        of tapered ends and ``width`` of a chamfer. Profiles of ISO 16281 and tabulated ones are scaled.

    Returns
    -------
    Profile
        The profile. Its drop has a relative error below 1e-12; its catalogue entry has the parameter determined.

    Raises
    ------
    InputError
        If no value of the parameter gives that drop, it is already given, or another value is out of range.

    Notes
    -----
    If several values give the drop, because it first grows with the parameter and then falls, the smallest is
    returned.

    Examples
    --------
    >>> crown = with_drop("crown", drop=0.02, at=9.5)
    >>> round(crown.catalogue_entry[1]["radius"], 3), round(float(crown.relief(9.5)), 12)
    (2256.26, 0.02)
    """
    one_of("kind", kind, tuple(CATALOGUE), "choose a profile of the catalogue")
    finite("drop", drop, _DROP_REMEDY)
    off_the_middle("at", at, AT_REMEDY)
    if kind == "straight":
        raise InputError("drop", drop, "be left out of 'straight', which has no relief", "choose another kind")
    free = parameter_from_drop(kind, parameters)
    if free is None:
        names = " and ".join(PARAMETERS[kind].by_drop)
        raise InputError("drop", drop, f"not be given together with {names}", "leave one out")
    _check_names(kind, free, parameters)
    make = CATALOGUE[kind]
    if free == SCALE:
        return scaled_to_drop(make(**parameters), kind, drop, at)
    if free in _PROPORTIONAL:
        return _scale_parameter(lambda value: make(**parameters, **{free: value}), kind, free, drop, at)
    return _search(lambda value: make(**parameters, **{free: value}), kind, free, drop, at)


#: Drops are measured from the middle of the body.
off_the_middle = number_that(lambda at: at != 0.0, "not be the middle of the body")


def parameter_from_drop(kind: str, parameters: Iterable[str]) -> str | None:
    """Return the parameter that a drop determines beside the given ones; `SCALE` if it scales the relief, else None."""
    names = PARAMETERS[kind].by_drop
    return next((name for name in names if name not in parameters), None) if names else SCALE


def scaled_to_drop(profile: Profile, kind: str, drop: float, at: float) -> Profile:
    """Return a profile scaled to have a drop.

    Parameters
    ----------
    profile : Profile
        The profile, whose relief must differ between the position and the middle.
    kind : str
        Name of the profile in errors.
    drop, at : float
        As in `with_drop` [mm].
    """
    return profile.scaled(drop / _own_drop(profile, kind, SCALE, at))


def _check_names(kind: str, free: str, parameters: Mapping[str, Any]) -> None:
    known = PARAMETERS[kind]
    for name, value in parameters.items():
        if name not in known.descriptions:
            raise unknown_key_error(name, value, known.descriptions, "parameter", f"'{kind}'")
    for name in known.descriptions:
        if name in known.without_default and name not in parameters and name != free:
            raise InputError(name, None, f"be given, because the drop determines {free}", "give both")


def _own_drop(profile: Profile, kind: str, name: str, at: float) -> float:
    drop = _drop(profile, at)
    if not math.isfinite(drop):
        raise InputError("at", at, f"be where '{kind}' has a finite relief", "give a place farther inside, in mm")
    if drop == 0.0:
        raise _no_effect_error(kind, name, at)
    return drop


def _no_effect_error(kind: str, name: str, at: float) -> InputError:
    return InputError("at", at, f"be where the {name} of '{kind}' changes the drop", "give a place farther out, in mm")


def _drop(profile: Profile, at: float) -> float:
    edge, middle = profile.relief_at(np.array([float(at), 0.0])).tolist()
    # A table may have no body in the middle: no drop can be measured from there.
    return math.nan if math.isinf(middle) else edge - middle


def _scale_parameter(make: Callable[[float], Profile], kind: str, name: str, drop: float, at: float) -> Profile:
    value = _PROPORTIONAL[name]
    multiple = drop / _own_drop(make(value(1.0)), kind, name, at)
    try:
        return make(value(multiple))
    except InputError as error:
        if error.field != name:
            raise
        condition = f"not make {name} = {error.value:.3g}, which in '{kind}' must {error.condition}"
        raise InputError("drop", drop, condition, "check drop and at") from None


def _search(make: Callable[[float], Profile], kind: str, name: str, drop: float, at: float) -> Profile:
    from scipy.optimize import brentq

    if drop == 0.0:
        raise InputError("drop", drop, f"not be zero, which no {name} of '{kind}' gives", "leave the profile out")
    tried = _scan(make, name, at)
    drops = [value for _, value in tried if math.isfinite(value)]
    if not drops:
        raise InputError("at", at, f"be where some {name} of '{kind}' has a finite relief", "give a place in mm")
    if max(drops) - min(drops) <= _UNCHANGED * max(drops):
        raise _no_effect_error(kind, name, at)

    def between(share: float, first: float, second: float) -> float:
        # Exactly the ends, without rounding, so that the signs computed there hold.
        return second if share == 1.0 else first * (second / first) ** share

    def excess(share: float, first: float, second: float) -> float:
        # Bounded, because it is infinite where the profile has ended before the place.
        missed = _drop(make(between(share, first, second)), at) - drop
        return min(max(missed, -abs(drop)), abs(drop))

    for (first, one), (second, other) in pairwise(tried):
        if first * second > 0.0 and (one - drop) * (other - drop) <= 0.0:
            ends = (first, second)
            share = brentq(excess, 0.0, 1.0, args=ends, xtol=1e-16, rtol=4.0 * np.finfo(float).eps)
            # At the end of a circle the drop jumps to infinity, past values that no radius gives.
            if abs(excess(share, *ends)) < _PASSED * abs(drop):
                return make(between(share, *ends))
    which = f"the drops that any {name} of '{kind}' gives at y = {mm(at):g}"
    condition = f"lie between about {mm(min(drops), max(drops), between=' and '):.3g}, {which}"
    raise InputError("drop", drop, condition, "check drop and at")


def _scan(make: Callable[[float], Profile], name: str, at: float) -> list[tuple[float, float]]:
    """Return values of a parameter with their drops, smallest values first, then negative ones.

    Values that the kind refuses are left out. If it refuses all, another parameter is wrong.
    """
    values, refused = [], None
    for value in (*_STEPS, *(-step for step in _STEPS)):
        try:
            values.append((value, _drop(make(value), at)))
        except InputError as error:
            refused = error if refused is None or refused.field == name else refused
    if not values and refused is not None:
        raise refused
    return values
