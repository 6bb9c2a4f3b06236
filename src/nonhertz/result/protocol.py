"""What solutions of strips and of the plane grid have in common, and all that code reading a result relies on."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.solid import Shape
from nonhertz.findings import Finding
from nonhertz.model.contact import Contact
from nonhertz.result.solution import ErrorEstimate, SingularEnd, Status

Array = NDArray[np.float64]


class Solved(Protocol):
    """A solved contact, by either method; arrays have an entry for each strip, or each row of cells."""

    @property
    def contact(self) -> Contact:
        """What was solved."""

    @property
    def status(self) -> Status:
        """How the solve ended."""

    @property
    def approach(self) -> float:
        """Delta [mm]."""

    @property
    def penetration(self) -> float:
        """The largest interference of the undeformed bodies [mm]."""

    @property
    def tilt(self) -> float:
        """Gamma [rad]."""

    @property
    def load(self) -> float:
        """Q [N]."""

    @property
    def moment(self) -> float:
        """T [N mm]."""

    @property
    def y(self) -> Array:
        """Centres along the contact [mm], ascending, shape (n,)."""

    @property
    def edges(self) -> Array:
        """Edges along the contact [mm], ascending, shape (n + 1,)."""

    @property
    def line_load(self) -> Array:
        """Load per length q [N/mm], shape (n,)."""

    @property
    def half_width(self) -> Array:
        """Half-width b [mm], shape (n,)."""

    @property
    def centre_pressure(self) -> Array:
        """Pressure p0 on the centre line [MPa], shape (n,)."""

    @property
    def largest_across(self) -> Array:
        """Largest pressure across the contact [MPa], shape (n,)."""

    @property
    def extent_across(self) -> tuple[Array, Array]:
        """Middle of the contact across and half of its extent [mm], shape (n,) each."""

    @property
    def symmetric_across(self) -> bool:
        """Whether the pressure is the same at x and at -x."""

    @property
    def shape(self) -> Shape:
        """Shape of the pressure across that the influence is computed with."""

    @property
    def contact_y(self) -> tuple[tuple[float, float], ...]:
        """The intervals in contact along y [mm], ascending."""

    @property
    def singular_ends(self) -> tuple[SingularEnd, ...]:
        """The ends at which the pressure has no limit, ascending."""

    @property
    def max_pressure(self) -> float:
        """The largest pressure more than a half-width from `singular_ends` [MPa]."""

    @property
    def max_pressure_y(self) -> float:
        """Where along y it is [mm]."""

    @property
    def max_half_width(self) -> float:
        """The largest half-width more than a half-width from `singular_ends` [mm]."""

    @property
    def contact_length(self) -> float:
        """Length of all intervals in contact together [mm]."""

    @property
    def peaks_at_corner(self) -> bool:
        """Whether the largest pressure is at a corner of the profile, where it has no limit."""

    @property
    def error_estimate(self) -> ErrorEstimate:
        """Estimated discretisation errors."""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What strains the model."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """The same, a sentence each."""
