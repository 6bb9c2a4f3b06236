"""What solutions by strips and on plane grids have in common."""

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

# Of the length common to both bodies: less than the first in contact, and within the second of an end of the land.
_PARTLY, _AT_END = 0.5, 0.05


if TYPE_CHECKING:

    class _Derived:
        """What is a field of one of both, and is worked out by the other."""

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
    """A solved contact, on strips or on a plane grid: what code that reads a result relies on.

    Attributes
    ----------
    contact : Contact
        What was solved.
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
        The ends at which the pressure has no limit, ascending.
    peaks_at_corner : bool
        Whether the largest pressure is at a corner of the profile, where it has no limit.
    error_estimate : ErrorEstimate
        Estimated discretisation errors.
    findings : tuple of Finding
        What strains the model.
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
        """The largest pressure more than a half-width from `singular_ends` [MPa]."""
        return self._largest[0]

    @property
    def max_pressure_y(self) -> float:
        """Where the largest pressure is [mm], the least y of two that are equal; nan where nothing touches."""
        return self._largest[1]

    @cached_property
    def max_half_width(self) -> float:
        """The largest half-width more than a half-width from `singular_ends` [mm], zero where nothing touches."""
        return largest_half_width(self.y, self.half_width, singular_y(self))[0]

    @property
    def contact_length(self) -> float:
        """Length of all intervals in contact together [mm]."""
        return math.fsum(high - low for low, high in self.contact_y)

    @property
    def remarks(self) -> tuple[Finding, ...]:
        """What is worth knowing of a result although it strains no model: that a tilt leaves it to bear on one end."""
        (low, high), (first, last) = self.contact.interval, self.contact.land
        common = high - low
        if not (self.contact_y and math.isfinite(common) and self.contact_length < _PARTLY * common):
            return ()
        if min(self.contact_y[0][0] - first, last - self.contact_y[-1][1]) > _AT_END * common:
            return ()  # a crowned body bears on its middle
        parts = mm(self.contact_length, common, between=" of ")
        return (finding("partial-contact", "Only {parts:.3g} are in contact, at one end.", parts=parts),)


FINITE: Final = ("approach", "tilt", "load", "moment", "max_pressure", "max_half_width")
"""The results that are finite in every solution that has converged."""


def not_finite(solution: Solved) -> list[str]:
    """Return which results of a solution are NaN or infinite that a converged one has."""
    return [name for name in FINITE if not math.isfinite(getattr(solution, name))]
