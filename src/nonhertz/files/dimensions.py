"""What profiles take from their body where their tables leave it out."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from nonhertz.model.body import TabulatedDiameter

#: Stands for a value of the body that is itself invalid.
BROKEN: Final = object()


def dimensions(body: Mapping[str, Any], radius: Any) -> dict[str, Any]:
    """Return the dimensions of a body that its profiles may need: each a number, None where it has none, or `BROKEN`.

    Parameters
    ----------
    body : mapping
        The keys of the body that have been read so far; an invalid one is absent.
    radius : object
        Combined radius of both bodies across the contact [mm], None or `BROKEN`.

    Returns
    -------
    dict
        ``length`` and ``diameter`` of the body, the combined ``radius``, and ``at``, where its land ends, all in mm.
    """
    length, diameter = body.get("length", BROKEN), body.get("diameter", BROKEN)
    across = _across_the_axis(diameter, length) if isinstance(diameter, TabulatedDiameter) else diameter
    return {"length": length, "diameter": across, "radius": radius, "at": _land_end(body)}


def _across_the_axis(diameter: TabulatedDiameter, length: Any) -> float:
    """Return the diameter [mm] in the middle of a body, normal to the axis of its cone.

    A table holds twice the radius of curvature in the plane normal to the line of contact, which is the diameter
    normal to the axis over the cosine of the angle between axis and surface. Half its slope is the tangent.
    """
    half = 0.5 * length if isinstance(length, float) else math.inf
    low, high = max(-half, diameter.y[0]), min(half, diameter.y[-1])
    ends = diameter([low, high])
    tangent = float(ends[1] - ends[0]) / (2.0 * (high - low)) if high > low else 0.0
    return float(diameter(0.0)) / math.hypot(1.0, tangent)


def _land_end(body: Mapping[str, Any]) -> Any:
    """Return where the corners of a body begin [mm] or, without any, where it can no longer touch."""
    names = ("length", "effective_length", "corner_radius", "chamfer")
    length, effective, corner, chamfer = (body.get(name, BROKEN) for name in names)
    if any(each is BROKEN for each in (length, effective, corner, chamfer)):
        return BROKEN
    whole = length if effective is None else effective
    if whole is None:
        return None
    taken = corner or (0.0 if chamfer is None else chamfer.length)
    # Corners that leave no land are a mistake of the body.
    return 0.5 * whole - taken if 0.5 * whole > taken else BROKEN
