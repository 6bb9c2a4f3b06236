"""Common parts of point and line contacts: the compliance of both bodies, and Hertz's semi-elliptic pressure."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import positive
from nonhertz.model.material import Material
from nonhertz.model.materials import NAMED

Array = NDArray[np.float64]
Materials = tuple[Material | str, Material | str]

PLACES_REMEDY = "give positions in mm"


def total_compliance(compliance: float | None, e_star: float | None, materials: Materials | None) -> float:
    """Return K = 1 / (pi E*) of both bodies [1/MPa] from the one of the three that is given."""
    values: dict[str, Any] = {"compliance": compliance, "e_star": e_star, "materials": materials}
    names = [name for name, value in values.items() if value is not None]
    if len(names) != 1:
        name = names[1] if names else "materials"
        condition = f"be left out where {names[0]} is given" if names else "be given"
        raise InputError(name, values[name], condition, "give one of materials, e_star and compliance")
    if materials is not None:
        if not (isinstance(materials, tuple | list) and len(materials) == 2):
            raise InputError("materials", materials, "be a pair", "give those of body a and body b")
        return float(sum(NAMED.validate(f"materials[{i}]", one).compliance for i, one in enumerate(materials)))
    if e_star is not None:
        positive("e_star", e_star, "give 1 / ((1 - nu_a^2) / E_a + (1 - nu_b^2) / E_b) in MPa")
        return 1.0 / (math.pi * float(e_star))
    compliance = values["compliance"]
    positive("compliance", compliance, "give the sum of both bodies' (1 - nu^2) / (pi E) in 1/MPa")
    return float(compliance)


def semicircle(position: Array) -> Array:
    """Return the pressure over the largest at positions over the half-width."""
    # As a product: 1 - position^2 would cancel close to the edge.
    return np.asarray(np.sqrt(np.maximum((1.0 - position) * (1.0 + position), 0.0)))
