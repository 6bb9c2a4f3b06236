"""The kinds of ends of a contact, and the pressure there."""

from __future__ import annotations

import enum
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import EndStrength
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.inputs.checks import numbers

Array = NDArray[np.float64]


class EdgeKind(enum.Enum):
    """The kind of an end of a contact; each member's value is the sentence that the user reads."""

    RUN_OUT = "The contact ends inside the bodies, where the pressure falls to zero."
    FINITE = "The image weights of the side faces here add up to a full mirror: the pressure up to the end is finite."
    SINGULAR = "The contact reaches a sharp end, where the pressure grows without bound."
    CORNER = "The contact ends at a corner of the profile, where the pressure grows without bound."
    CUT_OFF = "The strips end here while the contact continues."

    @property
    def label(self) -> str:
        """The member's name as files and tables write it, such as ``"run-out"``."""
        return self.name.lower().replace("_", "-")


@dataclass(frozen=True)
class EdgePressure:
    """The pressure at one end of a contact, and its kind.

    Attributes
    ----------
    y : float
        Where the contact ends [mm].
    kind : EdgeKind
        Whether the pressure runs out, stays finite up to the end, or is unbounded there, at a sharp end or a corner.
    pressure : float
        Pressure of the last strip [MPa], zero where the contact runs out. Meaningful only if ``converges``.
    strip_width : float
        Width of that strip [mm], zero where the contact runs out.
    image_weight : float
        kappa [-]: image weight times share of the compliance, summed over the bodies with a free face here.
    exponent : float
        alpha [-] of p ~ K / s^alpha, s the distance from the end; zero where finite. Where faces are mirrored,
        cos(pi alpha) = kappa.
    strength : float or None
        K [MPa mm^alpha], from the strips within half a half-width of the end. None if the end is not singular, if too
        few strips or a face of the other body lie that close, and for alpha below 0.1, where the pressure is nearly
        constant and K by itself would mislead.
    correction : float or None
        c [mm^-beta] of p = K s^-alpha (1 + c s^beta), within 2 % up to half a half-width; see `at`.
    correction_exponent : float
        beta [-]: 2 alpha at a mirrored end, from the eigenvalues of the wedge at a free one; zero where finite.
    convention : Finding
        Bodies that end here, and the treatment of their side faces, in words.

    Notes
    -----
    On the automatic grid K of semi-elliptic strips is within 0.2 % of solutions whose shape across is free, 0.5 % where
    the contact is only five half-widths long (docs/explain/end-table.md). That includes the factor 1 / (1 + 0.006 (1 -
    kappa)) for the true shape across near the end, which those solutions gave. Parabolic strips are within 3 %. At
    faces that are free of normal stress, too, there is no such factor, and K has been compared with strips only.
    """

    y: float
    kind: EdgeKind
    pressure: float
    strip_width: float
    image_weight: float
    exponent: float
    strength: float | None
    correction: float | None
    correction_exponent: float
    convention: Finding

    def at(self, distance: ArrayLike) -> Array:
        """Return the pressure K s^-alpha (1 + c s^beta) [MPa] at a ``distance`` s > 0 from the end [mm].

        Parameters
        ----------
        distance : array_like
            s [mm], positive, at most half a half-width.

        Returns
        -------
        ndarray
            Pressures [MPa]; NaN if there is no strength.
        """
        remedy = "give distances from the end in mm"
        s = numbers("distance", distance, remedy)
        if np.any(s <= 0.0):
            raise InputError("distance", distance, "be positive", remedy)
        if self.strength is None or self.correction is None:
            return np.full(s.shape, np.nan)
        pressure: Array = self.strength * s**-self.exponent * (1.0 + self.correction * s**self.correction_exponent)
        return pressure

    @property
    def converges(self) -> bool:
        """Whether ``pressure`` converges under refinement."""
        return self.kind in {EdgeKind.RUN_OUT, EdgeKind.FINITE}

    @property
    def law(self) -> str:
        """The growth of the pressure towards a sharp end, as text; empty if the contact does not reach one."""
        return str(self.growth) if self.kind is EdgeKind.SINGULAR else ""

    @property
    def growth(self) -> Finding:
        """The growth of the pressure towards a sharp end, with exponent and strength."""
        strength = "unknown" if self.strength is None else EndStrength(self.strength, self.exponent)
        known = "{strength}" if self.strength is None else "= {strength}"
        return finding("growth", f"p ~ K / s^{{exponent:.3g}}, K {known}", exponent=self.exponent, strength=strength)


@dataclass(frozen=True)
class SingularEnd:
    """An end of a contact, or of one of its intervals, towards which pressure and stress are unbounded.

    Attributes
    ----------
    y : float
        Position [mm].
    kind : EdgeKind
        SINGULAR at a sharp end of a body, CORNER at a corner of the profile.
    """

    y: float
    kind: EdgeKind
