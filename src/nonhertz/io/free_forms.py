"""Free profiles: relief that only has to grow from the middle to both ends, as a design may choose it.

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
from nonhertz.inputs.checks import whole
from nonhertz.io.paths import Keys
from nonhertz.io.ranges import number_in
from nonhertz.io.units import in_unit

Array = NDArray[np.float64]

FEWEST_KNOTS, MOST_KNOTS, USUAL_KNOTS = 2, 20, 8
_FREE = re.compile(r"\s*free\s*\(([^(),]*)(?:,([^(),]*))?\)\s*")


@dataclass(frozen=True)
class FreeForm:
    """A free profile.

    Attributes
    ----------
    deepest : float
        The most relief at the ends [mm].
    knots : int
        Number of increments from the middle to an end.
    """

    deepest: float
    knots: int = USUAL_KNOTS

    def relief(self, shares: Sequence[float] | Array) -> Array:
        """Return the relief at the knots from the middle outwards, that in the middle first [mm].

        Parameters
        ----------
        shares : array_like, shape (knots,)
            Square roots of the increments over the deepest relief; their squares add up to at most 1.
        """
        return self.deepest * np.concatenate([[0.0], np.cumsum(np.square(shares))])

    def places(self, half_length: float) -> Array:
        """Return where the knots are, from the middle outwards [mm]."""
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
    length = in_unit("length", body.get("effective_length", body.get("length")), "mm")
    if not isinstance(length, float) or not 0.0 < length < math.inf:
        raise InputError(f"{place}.length", body.get("length"), "be given for a free profile", "give it in mm")
    corner = in_unit("corner_radius", body.get("corner_radius", 0.0), "mm")
    chamfer = body.get("chamfer")
    taken = in_unit("length", chamfer["length"], "mm") if isinstance(chamfer, dict) else corner
    return 0.5 * length - (taken if isinstance(taken, float) else 0.0)


def free_form_in(field: str, given: Any) -> FreeForm | None:
    """Return the free profile that a text such as ``"free(60 um, 8)"`` stands for; None if it is no such text.

    Raises
    ------
    InputError
        If its numbers are out of range.
    """
    found = _FREE.fullmatch(given) if isinstance(given, str) else None
    if found is None:
        return None
    deepest = number_in(field, found[1], "mm")
    if not 0.0 < deepest < math.inf:
        raise InputError(field, given, "have a relief above zero", "write free(60 um), the most relief at the ends")
    knots = number_in(field, found[2], "") if found[2] is not None else USUAL_KNOTS
    return FreeForm(deepest, whole(field, knots, FEWEST_KNOTS, MOST_KNOTS, "give the number of knots"))  # type: ignore[arg-type]
