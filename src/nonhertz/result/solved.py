"""The common base of solutions by strips and on plane grids."""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.bodies.shape import Shape
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.model.contact import Contact
from nonhertz.result import brief
from nonhertz.result.edges import SingularEnd
from nonhertz.result.maximum import largest_half_width, largest_pressure, singular_y
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.status import ErrorEstimate, Status

if TYPE_CHECKING:
    pass

Array = NDArray[np.float64]
Values = TypeVar("Values", bound=NDArray[Any])

# Fractions of the length common to both bodies: contact shorter than the first, and closer than the second to an end of
# the land.
_PARTLY, _AT_END = 0.5, 0.05


if TYPE_CHECKING:

    class _Derived:
        """Attributes that are fields of one kind of solution and derived by the other."""

        @property
        def penetration(self) -> float: ...
        @property
        def y(self) -> Array: ...
        @property
        def edges(self) -> Array: ...
        @property
        def line_load(self) -> Array: ...
        @property
        def half_width(self) -> Array: ...
        @property
        def centre_pressure(self) -> Array: ...
        @property
        def largest_across(self) -> Array: ...
        @property
        def extent_across(self) -> tuple[Array, Array]: ...
        @property
        def symmetric_across(self) -> bool: ...
        @property
        def shape(self) -> Shape: ...
        @property
        def contact_y(self) -> tuple[tuple[float, float], ...]: ...
        @property
        def singular_ends(self) -> tuple[SingularEnd, ...]: ...
        @property
        def peaks_at_corner(self) -> bool: ...

else:
    _Derived = object


class Solved(HasFindings, ReadOnly, brief.HasHtml, _Derived):
    """A solved contact, on strips or on a plane grid: the attributes on which code that reads results relies.

    Attributes
    ----------
    contact : Contact
        The solved contact.
    status : Status
        How the solve ended.
    approach, tilt : float
        delta [mm] and gamma [rad].
    load, moment : float
        Q [N] and T [N mm].
    penetration : float
        The largest interference of the undeformed bodies [mm].
    y : ndarray, shape (n,)
        Centres of the strips, or of the rows of cells [mm], ascending.
    edges : ndarray, shape (n + 1,)
        Their edges [mm].
    line_load : ndarray, shape (n,)
        Load per length q [N/mm].
    half_width : ndarray, shape (n,)
        b [mm].
    centre_pressure, largest_across : ndarray, shape (n,)
        Pressure p0 on the centre line, and the largest one across the contact [MPa].
    extent_across : tuple of ndarray, shape (n,)
        Middle of the contact across, and half of its extent [mm].
    symmetric_across : bool
        Whether the pressure is the same at x and at -x.
    shape : Shape
        Shape of the pressure across that the influence is computed with.
    contact_y : tuple of (float, float)
        The intervals in contact along y [mm], ascending.
    singular_ends : tuple of SingularEnd
        The ends at which the pressure is unbounded, ascending.
    peaks_at_corner : bool
        Whether the maximum pressure is at a corner of the profile, where it is unbounded.
    error_estimate : ErrorEstimate
        Estimated discretisation errors.
    findings : tuple of Finding
        Strains of the model.
    """

    contact: Contact
    status: Status
    approach: float
    tilt: float
    load: float
    moment: float
    error_estimate: ErrorEstimate

    def __repr__(self) -> str:
        return brief.plain_text(type(self).__name__, self._said())

    def _said(self) -> list[str]:
        raise NotImplementedError

    @cached_property
    def _largest(self) -> tuple[float, float]:
        if not self.contact_y:
            return 0.0, math.nan
        return largest_pressure(self.y, self.largest_across, self.half_width, singular_y(self))

    @property
    def max_pressure(self) -> float:
        """The maximum pressure more than a half-width from `singular_ends` [MPa]."""
        return self._largest[0]

    @property
    def max_pressure_y(self) -> float:
        """Position of the maximum pressure [mm], the smaller y of two that are equal; NaN without contact."""
        return self._largest[1]

    @cached_property
    def max_half_width(self) -> float:
        """The largest half-width more than a half-width from `singular_ends` [mm]; zero without contact."""
        return largest_half_width(self.y, self.half_width, singular_y(self))[0]

    @property
    def contact_length(self) -> float:
        """Length of all intervals in contact together [mm]."""
        return math.fsum(high - low for low, high in self.contact_y)

    @property
    def remarks(self) -> tuple[Finding, ...]:
        """Remarks that do not strain the model: edge loading, where contact is left at the ends only."""
        (low, high), (first, last) = self.contact.interval, self.contact.land
        common = high - low
        if not (self.contact_y and math.isfinite(common) and self.contact_length < _PARTLY * common):
            return ()
        reached = sum(gap <= _AT_END * common for gap in (self.contact_y[0][0] - first, last - self.contact_y[-1][1]))
        if not reached:
            return ()  # a crowned body touches in its middle
        parts, where = mm(self.contact_length, common, between=" of "), ("one end", "both ends")[reached - 1]
        return (finding("partial-contact", f"Only {{parts:.3g}} are in contact, at {where}.", parts=parts),)


FINITE: Final = ("approach", "tilt", "load", "moment", "max_pressure", "max_half_width")
"""The results that are finite in every solution that has converged."""


def not_finite(solution: Solved) -> list[str]:
    """Return the results of a solution that are NaN or infinite, but finite in every converged one."""
    return [name for name in FINITE if not math.isfinite(getattr(solution, name))]
