"""Figure of the profile of a body: relief over the length on which it can touch, to the scale of its land."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import um
from nonhertz.bearing.section import RINGS
from nonhertz.figures.value import Axis, Band, Figure, Line, Panel, Range
from nonhertz.model.body import BODIES, Body

Array = NDArray[np.float64]

POINTS = 161
"""Places of a relief, denser at the ends."""
FAR = 10.0
"""mm on either side of the middle, over which the profile of an unbounded body is drawn."""
INNER, STEEP = 0.96, 6.0
"""Of the length of a land: what is drawn whole, and of how many times its relief ends may be."""
ROOM, FLAT = 0.12, 1e-3
"""Beside the relief of a land, of its range; what is drawn of a body without relief [mm]."""


def body_relief(body: Body, name: str) -> Figure:
    """Return the relief of a body, cut where corners or the ends of a logarithm would flatten that of its land.

    Parameters
    ----------
    body : Body
        The body.
    name : {"a", "b", "roller", "inner", "outer"}
        Which one it is; its panel is called ``"profile-"`` and that.
    """
    low, high = body.interval
    low = low if math.isfinite(low) else min(body.position, high) - FAR
    high = high if math.isfinite(high) else max(body.position, low) + FAR
    y, relief = relief_between(low, high, body.relief)
    ends = max(low, body.land[0]), min(high, body.land[1])
    top, bottom = _range_of(np.interp(np.linspace(*ends, POINTS), y, relief))
    called = f"body {name}" if name in BODIES else f"{name} ring" if name in RINGS else name
    deepest = float(np.nanmax(relief, initial=0.0))
    panel = Panel(
        f"profile-{name}",
        "",
        Axis("Relief", "relief", "mm", "um", (bottom, top)),  # downwards, as material is taken away
        [Band(y, relief, np.full_like(y, bottom), colour="ink"), Line(y, relief)],
        f"Profile of {called}: relief up to {um(deepest):.3g}.",
        f"axis cut, ends down to {um(deepest):.3g}" if deepest > bottom else "",
        120,
    )
    along = Axis("Axial position y", "y", "mm", range=(low, high))
    return Figure(along, [panel], caption=f"Profile of {called}: its relief along the axis.")


def _range_of(relief: Array) -> Range:
    """Return the range in which the relief of a land is drawn: corners would flatten it, and a logarithm has no end."""
    values = relief[np.isfinite(relief)]
    if not values.size:
        return 0.0, FLAT
    low, inner, high = np.quantile(values, (0.0, INNER, 1.0)).tolist()
    bottom = 2.0 * inner if high > STEEP * inner > 0.0 else high
    room = ROOM * (bottom - low) or FLAT
    return low - room, bottom + room


def relief_between(low: float, high: float, relief: Callable[[Array], Array]) -> tuple[Array, Array]:
    """Return places from one position to another, denser at the ends, and a relief there; nan where it is infinite."""
    spread = np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, POINTS))
    y = np.clip(0.5 * (low + high) + 0.5 * (high - low) * spread, low, high)
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        values = np.array(relief(y))
    return y, np.where(np.isfinite(values), values, np.nan)
