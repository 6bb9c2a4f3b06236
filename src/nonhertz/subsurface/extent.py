"""The material of a body: above its bore, within its diameter, within its thickness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.model.body import Body, BodyName

Array = NDArray[np.float64]

_ROUNDING = 1e-9  # of the thickness


@dataclass(frozen=True)
class Extent:
    """The material of one body below its surface, unlimited where ``depth`` is not a thickness.

    Parameters
    ----------
    name : {"a", "b"}
        Which body.
    body : Body
        The body.
    """

    name: BodyName
    body: Body

    @property
    def round(self) -> bool:
        """Whether a diameter, not a thickness, limits it."""
        return self.body.behind.of_diameter

    def radii(self, y: Array) -> tuple[Array, Array]:
        """Return the radii of the surface and of the bore of a round body [mm], 0 where there is no bore."""
        bore = self.body.bore
        inner = 0.5 * np.asarray(bore(y - self.body.position) if callable(bore) else bore or 0.0, dtype=float)
        return 1.0 / self.body.curvature_at(y), np.broadcast_to(inner, y.shape)

    def thickness(self, y: Array) -> Array:
        """Return the depth of material below the centre line [mm]; infinite where it is not known."""
        if self.round:
            outer, inner = self.radii(y)
            return np.where(inner > 0.0, outer - inner, 2.0 * outer)
        return np.full(y.shape, self.body.behind.thickness)

    def holds(self, x: Array, y: Array, z: Array) -> NDArray[np.bool_]:
        """Return at which points there is material.

        As for the half-space, the whole plane z = 0 within the diameter represents the surface.
        """
        thickness = self.thickness(y)
        room = 1.0 + _ROUNDING
        if not self.round:
            return np.asarray(z <= room * thickness)
        outer, inner = self.radii(y)
        below = outer + np.sqrt(np.maximum(outer**2 - x**2, 0.0))
        within = (np.abs(x) <= room * outer) & (z <= room * below)
        return np.asarray(within & (room * np.hypot(x, outer - z) >= inner))

    def findings(self, inside: NDArray[np.bool_]) -> tuple[Finding, ...]:
        """Return a finding if some points lie outside the material."""
        missing = inside.size - int(np.count_nonzero(inside))
        if not missing:
            return ()
        where = "in its bore or beyond its surface" if self.round else "below its thickness"
        words = f"{{missing}} of {{points}} points lie outside the material of body {{body}}, {where}: they are NaN."
        return (finding("outside-the-body", words, missing=missing, points=inside.size, body=self.name),)

    def refuse(self, y: float, z: float) -> None:
        """Reject a point where there is no material.

        Raises
        ------
        InputError
        """
        thickness = float(self.thickness(np.array([y]))[0])
        bored = self.round and float(self.radii(np.array([y]))[1][0]) > 0.0
        where = "whose wall is" if bored else "which is"
        condition = f"lie in the material of body {self.name}, {where} {mm(thickness):.6g} thick at y = {mm(y):.6g}"
        raise InputError("z", z, condition, "choose points within the body, or the other body")
