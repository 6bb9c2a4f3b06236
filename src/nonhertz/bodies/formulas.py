"""Profiles and diameters as formulas of the C++ core; those without a formula there are called in Python.

A profile's class alone reads, checks and describes it, and its own formula is the readable one. A class that is not
listed here, such as one of the user's, is called as a function of whole arrays.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.inputs.checks import LEAST
from nonhertz.model.body import Body
from nonhertz.model.corner import Chamfer, Corner, Cornered, Rounded
from nonhertz.model.diameter import TabulatedDiameter
from nonhertz.model.profile import uniform_pressure
from nonhertz.model.profile.base import Profile, Straight, Sum, Transformed
from nonhertz.model.profile.circular import Arcs
from nonhertz.model.profile.linear import Chamfers, Conical, TaperedEnds
from nonhertz.model.profile.logarithm import Logarithmic
from nonhertz.model.profile.table import Tabulated
from nonhertz.model.profile.uniform_pressure import UniformPressure
from nonhertz.native import core

Array = NDArray[np.float64]
Function = Callable[[Array], Array]
Curvature = float | core.TabulatedDiameter | Function


def relief_of(profile: Profile) -> core.Relief:
    """Return the formula of a profile, or the profile itself to be called."""
    make = FORMULAS.get(type(profile))
    relief: core.Relief | None = None if make is None else make(profile)
    return core.Relief.function(apply_to_whole_arrays(profile.relief_at)) if relief is None else relief


def relief_of_body(body: Body) -> core.Relief:
    """Return the formula of a body's surface over positions along the contact."""
    return core.Relief.moved(relief_of(body.surface), 1.0, body.position, False, *body.surface.extent)


def curvature_of(body: Body) -> Curvature:
    """Return the curvature across the contact: a constant, a table, or a function."""
    diameter = body.diameter
    if diameter is None:
        return 0.0
    if not callable(diameter):
        return float(2.0 / diameter)
    if type(diameter) is TabulatedDiameter and min(map(abs, diameter.diameter)) >= LEAST:
        return core.TabulatedDiameter(np.array(diameter.y), np.array(diameter.diameter), body.position)
    return apply_to_whole_arrays(body.curvature_at)


def apply_to_whole_arrays(function: Callable[[Array], ArrayLike]) -> Function:
    """Return a function whose result has the shape of its argument."""

    def answer(y: Array) -> Array:
        return np.ascontiguousarray(np.broadcast_to(np.asarray(function(y), dtype=float), y.shape))

    return answer


def _moved_relief(of: Transformed) -> core.Relief:
    return core.Relief.moved(relief_of(of.profile), of.scale, of.shift, of.flip, *of.profile.extent)


def _table(of: Tabulated) -> core.Relief:
    y, curve = np.array(of.y), of.curve
    if of.interpolation == "linear":
        return core.Relief.polyline(y, np.array(of.values))
    return core.Relief.cubics(y, np.ascontiguousarray(curve.c.T))


def _uniform_pressure(of: UniformPressure) -> core.Relief:
    return core.Relief.uniform_pressure(of.amplitude, of.length, of.half_width, _strip_displacement())


@cache
def _strip_displacement() -> core.StripDisplacement:
    return core.StripDisplacement(np.ascontiguousarray(uniform_pressure.table().T), *uniform_pressure.TABLE_RANGE)


def _corner_relief(of: Cornered) -> core.Relief | None:
    corner = _corner(of.corner)
    if corner is None:
        return None
    return core.Relief.cornered(relief_of(of.land), of.half_length, corner, of.tangents.tolist())


def _corner(of: Corner) -> core.Corner | None:
    if type(of) is Rounded:
        return core.Corner(of.extent, of.radius, math.inf, 0.0)
    if type(of) is Chamfer:
        return core.Corner(of.extent, of.blend_radius, of.arc, math.tan(of.angle))
    return None


#: By the exact class, since a derived class may have a relief of its own.
FORMULAS: Final[Mapping[type[Profile], Callable[[Any], core.Relief | None]]] = MappingProxyType(
    {
        Straight: lambda of: core.Relief.straight(),
        Arcs: lambda of: core.Relief.arcs(of.radius, of.end_radius, of.junction, of.end_summit),
        Logarithmic: lambda of: core.Relief.logarithmic(of.amplitude, of.length, of.rest, of.curved, of.at_end),
        Conical: lambda of: core.Relief.conical(math.tan(of.angle)),
        TaperedEnds: lambda of: core.Relief.tapered_ends(of.straight, math.tan(of.angle)),
        Chamfers: lambda of: core.Relief.tapered_ends(of.straight, math.tan(of.angle)),
        UniformPressure: _uniform_pressure,
        Tabulated: _table,
        Sum: lambda of: core.Relief.sum([relief_of(part) for part in of.parts]),
        Transformed: _moved_relief,
        Cornered: _corner_relief,
    }
)
