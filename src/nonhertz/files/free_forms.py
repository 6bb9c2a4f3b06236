"""Free profiles: any relief that grows from the middle to both ends, for a design to choose.

The relief is zero in the middle and rises by an increment from knot to knot, the same on both sides, with the monotone
cubic of ``kind = "tabulated"`` between them. Knots are closer to each other towards the ends, where profiles bend most.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.files.paths import Keys
from nonhertz.files.spreads import parse_number
from nonhertz.inputs.checks import whole
from nonhertz.inputs.units import to_unit

Array = NDArray[np.float64]

FEWEST_KNOTS, MOST_KNOTS, USUAL_KNOTS = 2, 20, 8
_FREE = re.compile(r"\s*free\s*\(([^()]*)\)\s*")
_BOUND = re.compile(r"\s*(slope|radius)\s+(.*)")
_UNITS = {"slope": "rad", "radius": "mm"}
_REMEDY = "write free(60 um, 8), say, or free(60 um, 8, slope 5 mrad, radius 200 mm)"


@dataclass(frozen=True)
class FreeForm:
    """A free profile.

    Attributes
    ----------
    deepest : float
        Largest relief at the ends [mm].
    knots : int
        Number of increments from the middle to an end.
    steepest : float or None
        Largest slope from knot to knot [rad].
    roundest : float or None
        Smallest radius of curvature at a knot [mm], from the slopes on both sides of it.
    """

    deepest: float
    knots: int = USUAL_KNOTS
    steepest: float | None = None
    roundest: float | None = None

    def relief(self, shares: Sequence[float] | Array) -> Array:
        """Return the relief at the knots from the middle outwards, that in the middle first [mm].

        Parameters
        ----------
        shares : array_like, shape (knots,)
            Square roots of the increments over the deepest relief; their squares add up to at most 1.
        """
        return self.deepest * np.concatenate([[0.0], np.cumsum(np.square(shares))])

    def margins(self, shares: Sequence[float] | Array, half_length: float) -> tuple[Array, Array]:
        """Return the relative margin of every bound, and its derivatives with respect to the shares.

        Parameters
        ----------
        shares : array_like, shape (knots,)
            As for `relief`.
        half_length : float
            Half the length of the profile [mm].

        Returns
        -------
        margins : ndarray, shape (bounds,)
            Limits of the deepest relief, of the slopes, and of the curvatures of either sign.
        slopes : ndarray, shape (bounds, knots)
        """
        roots = np.asarray(shares, dtype=float)
        widths = np.diff(self.places(half_length))
        # Slopes of the secants, and curvatures from those; in the middle the profile is its own mirror image.
        to_secants = np.diag(self.deepest / widths)
        bend = np.diff(to_secants, axis=0, prepend=-to_secants[:1])
        between = 0.5 * (np.append(widths[0], widths[:-1]) + widths)
        parts = [np.ones((1, self.knots))]
        if self.steepest is not None:
            parts.append(to_secants / self.steepest)
        if self.roundest is not None:
            curved = self.roundest * bend / between[:, None]
            parts += [curved, -curved]
        rows = np.concatenate(parts)
        return 1.0 - rows @ roots**2, -2.0 * rows * roots

    def places(self, half_length: float) -> Array:
        """Return the positions of the knots, from the middle outwards [mm]."""
        return half_length * np.sin(0.5 * math.pi * np.arange(self.knots + 1) / self.knots)

    def tables(self, document: Mapping[str, Any], keys: Keys, shares: Sequence[float] | Array) -> list[dict[str, Any]]:
        """Return the profile of a body in a document, at ``keys``.

        Raises
        ------
        InputError
            If the body has no length.
        """
        half, relief = half_length(document, keys), self.relief(shares)
        y = self.places(half)
        both = np.concatenate([-y[:0:-1], y]), np.concatenate([relief[:0:-1], relief])
        return [{"kind": "tabulated", "y": both[0].tolist(), "relief": both[1].tolist(), "interpolation": "pchip"}]


def half_length(document: Mapping[str, Any], keys: Keys) -> float:
    """Return half the length [mm] over which the body of a profile can touch.

    Raises
    ------
    InputError
        If the body has no length.
    """
    body: Any = document
    for key in keys[:-1]:
        body = body[key]
    place = ".".join(map(str, keys[:-1]))
    length = to_unit("length", body.get("effective_length", body.get("length")), "mm")
    if not isinstance(length, float) or not 0.0 < length < math.inf:
        raise InputError(f"{place}.length", body.get("length"), "be given for a free profile", "give it in mm")
    corner = to_unit("corner_radius", body.get("corner_radius", 0.0), "mm")
    chamfer = body.get("chamfer")
    taken = to_unit("length", chamfer["length"], "mm") if isinstance(chamfer, dict) else corner
    return 0.5 * length - (taken if isinstance(taken, float) else 0.0)


def parse_free_form(field: str, value: Any) -> FreeForm | None:
    """Return the free profile that a text such as ``"free(60 um, 8)"`` stands for; None if it is no such text.

    Raises
    ------
    InputError
        If its numbers are out of range.
    """
    match = _FREE.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        return None
    relief, *rest = match[1].split(",")
    deepest = parse_number(field, relief, "mm")
    if not 0.0 < deepest < math.inf:
        raise InputError(field, value, "have a relief above zero", "write free(60 um), the most relief at the ends")
    knots: float = USUAL_KNOTS
    if rest and not _BOUND.fullmatch(rest[0]):
        knots = parse_number(field, rest.pop(0), "")
    bounds = {}
    for text in rest:
        bound = _BOUND.fullmatch(text)
        if bound is None or bound[1] in bounds:
            raise InputError(field, value, "hold a slope and a radius at most once after its knots", _REMEDY)
        bounds[bound[1]] = parse_number(field, bound[2], _UNITS[bound[1]])
        if not 0.0 < bounds[bound[1]] < math.inf:
            raise InputError(field, value, f"have a {bound[1]} above zero", _REMEDY)
    number = whole(field, knots, FEWEST_KNOTS, MOST_KNOTS, "give the number of knots")  # type: ignore[arg-type]
    return FreeForm(deepest, number, bounds.get("slope"), bounds.get("radius"))
