"""The result of a solve: a read-only value with the strip results and everything derived from them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.findings import Finding
from nonhertz.inputs.assumed import collect_assumptions
from nonhertz.inputs.checks import broadcast, numbers
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.model.profile.base import at_ends
from nonhertz.result import brief
from nonhertz.result.data import library
from nonhertz.result.edges import EdgeKind, EdgePressure, SingularEnd
from nonhertz.result.quantities import ALONG
from nonhertz.result.read_only import freeze
from nonhertz.result.solved import Solved
from nonhertz.result.status import ErrorEstimate, Status
from nonhertz.strip.element import Element

if TYPE_CHECKING:
    from pathlib import Path

    import pandas as pd
    from matplotlib.axes import Axes

    from nonhertz.result.gradient import Gradient
    from nonhertz.result.measures import Measure
    from nonhertz.result.nodes import NodalLoads
    from nonhertz.result.outcome import Judgement

Array = NDArray[np.float64]
Values = TypeVar("Values", bound=NDArray[Any])


@dataclass(frozen=True, eq=False, repr=False)
class Solution(Solved):
    """A solved contact; its arrays have one value for each strip, at the positions ``y``.

    Attributes
    ----------
    contact : Contact
        The solved contact.
    element : Element
        The strip element of the solve.
    status : Status
        How the solve ended.
    approach : float
        delta [mm], how far the bodies moved together on the line y = 0 beyond first touch at zero separation.
    tilt : float
        gamma [rad] about x; positive tilt loads the side of positive y.
    load : float
        Q [N], integral of the pressure.
    moment : float
        T [N mm], integral of pressure times y.
    stiffness : ndarray, shape (2, 2)
        d(load, moment) / d(approach, tilt) [[N/mm, N/rad], [N mm/mm, N mm/rad]], exact for the strips.
    edges : ndarray, shape (strips + 1,)
        Edges of the strips [mm], ascending; usable as ``strips`` of another solve.
    line_load : ndarray, shape (strips,)
        q [N/mm], zero out of contact.
    element_half_width : ndarray, shape (strips,)
        Half-width a [mm] of the element's own pressure shape.
    gap : ndarray, shape (strips,)
        Deformed gap on the centre line [mm]; zero in contact.
    contact_y : tuple of (float, float)
        The intervals [mm] along y that are in contact, ascending; an end inside the bodies lies where the
        square of the half-width, continued linearly, vanishes.
    edge_pressure : tuple of two EdgePressure
        The pressure at the low and at the high end, and its kind.
    singular_ends : tuple of SingularEnd
        The ends at which the pressure is unbounded, ascending, including those of inner intervals.
    peaks_at_corner : bool
        Whether the maximum pressure is at a corner of the profile within the contact, where it is also unbounded.
    iterations : int
        Newton steps on the grid of the result.
    error_estimate : ErrorEstimate
        The solve's own estimate of its discretisation errors.
    findings : tuple of Finding
        Remarks on where this case strains the model; empty if it does not.
    judgement : Judgement
        The last six of these attributes, computed when they are first read.
    """

    contact: Contact
    element: Element
    status: Status
    approach: float
    tilt: float
    load: float
    moment: float
    stiffness: Array
    edges: Array
    line_load: Array
    element_half_width: Array
    gap: Array
    iterations: int
    judgement: Judgement

    @property
    def contact_y(self) -> tuple[tuple[float, float], ...]:
        """The intervals in contact along y [mm], ascending."""
        return self.judgement.contact_y

    @property
    def edge_pressure(self) -> tuple[EdgePressure, EdgePressure]:
        """The pressure at the low and at the high end."""
        return self.judgement.edge_pressure

    @property
    def singular_ends(self) -> tuple[SingularEnd, ...]:
        """The ends at which the pressure is unbounded, ascending."""
        return self.judgement.singular_ends

    @property
    def peaks_at_corner(self) -> bool:
        """Whether the maximum pressure is at a corner of the profile within the contact."""
        return self.judgement.peaks_at_corner

    @property
    def error_estimate(self) -> ErrorEstimate:  # type: ignore[override]  # of a plane grid it is a field
        """The solve's own estimate of its discretisation errors."""
        return self.judgement.error_estimate

    @property
    def assumed(self) -> tuple[Finding, ...]:
        """The assumptions for inputs of the bodies that are left out and decide the result."""
        return collect_assumptions({"a": self.contact.a, "b": self.contact.b})

    @cached_property
    def findings(self) -> tuple[Finding, ...]:  # type: ignore[override]
        """Strains of the model in this case."""
        return self.judgement.found(self)

    def _said(self) -> list[str]:
        ends = [edge.kind.label.replace("-", " ") for edge in self.edge_pressure]
        return brief.lines(self, f"{self.strips} {self.element.name} strips", ends)

    @property
    def strips(self) -> int:
        """Number of strips."""
        return int(self.edges.size) - 1

    @cached_property
    def y(self) -> Array:
        """Strip centres [mm], ascending."""
        return freeze(0.5 * (self.edges[1:] + self.edges[:-1]))

    @cached_property
    def strip_width(self) -> Array:
        """Strip widths along y [mm]."""
        return freeze(np.diff(self.edges))

    @cached_property
    def half_width(self) -> Array:
        """Half-width b [mm] at each strip: that of the semi-ellipse, or the Hertz equivalent of a parabola."""
        return freeze(self.element.hertz_ratio * self.element_half_width)

    @cached_property
    def centre_pressure(self) -> Array:
        """Pressure p0 = 2 q / (pi b) on the centre line [MPa] at each strip."""
        touching = self.half_width > 0.0
        pressure = np.zeros_like(self.line_load)
        pressure[touching] = 2.0 * self.line_load[touching] / (np.pi * self.half_width[touching])
        return freeze(pressure)

    @property
    def largest_across(self) -> Array:
        """Maximum pressure across the contact [MPa] at each strip: that on the centre line."""
        return self.centre_pressure

    @property
    def extent_across(self) -> tuple[Array, Array]:
        """Middle of the contact across, x = 0, and half-width b [mm] at each strip."""
        return np.zeros(self.strips), self.half_width

    @property
    def symmetric_across(self) -> bool:
        """Whether the pressure is the same at x and at -x: that of strips is."""
        return True

    @property
    def shape(self) -> Element:
        """Shape of the pressure across: the element."""
        return self.element

    def pressure(self, x: ArrayLike, y: ArrayLike) -> Array:
        """Return the pressure anywhere on the surface [MPa].

        Across, it is the semi-ellipse of ``centre_pressure`` and ``half_width``. Between strip centres the squares of
        both are linear in y, and fall to zero where the contact runs out; up to any other end they stay constant.

        Parameters
        ----------
        x, y : array_like
            Places [mm]; they broadcast.

        Returns
        -------
        ndarray
            Zero out of contact; exact at strip centres; in a strip at a singular end not a converged value.

        Raises
        ------
        InputError
            If the places are not numbers, or their shapes do not broadcast.
        """
        remedy = "give places in mm"
        across, along = broadcast(remedy, numbers("x", x, remedy), numbers("y", y, remedy))
        highest, widest = np.zeros(along.shape), np.zeros(along.shape)
        for number, (low, high) in enumerate(self.contact_y):
            strips = (self.y > low) & (self.y < high)
            before = [low] if runs_out(self, number, 0) else []
            after = [high] if runs_out(self, number, 1) else []
            places = np.concatenate([before, self.y[strips], after])
            along = at_ends(along, (low, high))
            within = (along >= low) & (along <= high)
            for into, values in ((highest, self.centre_pressure), (widest, self.half_width)):
                squares = np.concatenate([[0.0] * len(before), values[strips] ** 2, [0.0] * len(after)])
                into[within] = np.sqrt(np.interp(along[within], places, squares))
        share = np.divide(across, widest, out=np.ones(along.shape), where=widest > 0.0)
        pressure: Array = highest * np.sqrt(np.maximum(1.0 - share**2, 0.0))
        return pressure

    def at_nodes(self, x: ArrayLike, y: ArrayLike) -> NodalLoads:
        """Return pressures and forces at the nodes of a mesh of the surface, as boundary conditions of finite elements.

        Parameters
        ----------
        x, y : array_like
            Coordinates of the nodes [mm], across and along the contact; they broadcast, and are flattened.

        Returns
        -------
        NodalLoads
            Pressure and force at each node, and how their sums relate to the load: ``pressure``, ``force``, ``area``,
            ``outside`` and ``interpolated_load``.

        Raises
        ------
        InputError
            If the coordinates are not finite numbers, or their shapes do not broadcast.

        Examples
        --------
        >>> import numpy as np
        >>> import nonhertz as nh
        >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000))
        >>> solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=5e3)
        >>> x, y = np.meshgrid(np.linspace(-0.4, 0.4, 41), np.linspace(-10.0, 10.0, 81))
        >>> nodes = solution.at_nodes(x.ravel(), y.ravel())
        >>> round(float(nodes.force.sum()), 6), round(nodes.interpolated_load / 5e3, 2)
        (5000.0, 1.0)
        """
        from nonhertz.result.nodes import nodal_loads

        return nodal_loads(self, x, y)

    def table(self) -> dict[str, Array]:
        """Return the quantities along the contact by name, one array each: the columns of ``table.csv``."""
        return {name: quantity.get(self) for name, quantity in ALONG.items()}

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each strip, the columns of `table`, units in ``attrs["units"]``.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        frame: pd.DataFrame = library("pandas", "to_dataframe").DataFrame(self.table())
        frame.attrs["units"] = {name: quantity.unit for name, quantity in ALONG.items()}
        return frame

    def plot(self, what: str = "pressure", ax: Axes | None = None) -> Axes:
        """Draw the contact, and return the axes; ``figure`` of the axes is the figure.

        Parameters
        ----------
        what : str
            ``"pressure"``, ``"footprint"`` or ``"profile"``, as the functions of these names in `nonhertz.plot`.
        ax : matplotlib.axes.Axes, optional
            Axes to draw on; by default those of a new figure.

        Raises
        ------
        InputError
            If there is no such drawing.
        """
        import nonhertz  # what draws stands above what is drawn

        return nonhertz.plot.draw(self, what, ax)

    def save(self, folder: str | os.PathLike[str], title: str = "Contact") -> tuple[Path, ...]:
        """Write ``result.json``, ``table.csv`` and figures into a directory, as ``nonhertz solve`` does.

        The case in the result, from which `nonhertz.read_result` restores the contact, prescribes load and tilt.

        Parameters
        ----------
        folder : str or os.PathLike
            Created if it does not exist; files of these names are replaced, all of them or none.
        title : str
            Heading of the figures, and title of the case.

        Returns
        -------
        tuple of Path
            The files.

        Raises
        ------
        InputError
            If the contact cannot be written, such as with a user-defined profile, or the folder cannot be written to.
        """
        import nonhertz  # what writes stands above what is written

        prescribed = Prescription(load=self.load, tilt=self.tilt)
        case = nonhertz.Case(title=title, contact=self.contact, prescribed=prescribed)
        return nonhertz.Result(case, self).save(os.fspath(folder))

    @cached_property
    def penetration(self) -> float:
        """The largest interference of the undeformed bodies within the strips [mm]: the approach beyond first touch."""
        return self.judgement.judged(self).penetration

    def gradient(self, quantity: str | Measure, *, holding: tuple[str, str] = ("load", "tilt")) -> Gradient:
        """Return the gradient of a number of the solution with respect to the bodies' shapes and all given quantities.

        Parameters
        ----------
        quantity : str or Measure
            ``"approach"``, ``"load"``, ``"tilt"``, ``"moment"``, ``"max_pressure"``, ``"max_half_width"``; or a place
            or an integral: `PressureAt`, `HalfWidthAt`, `PressureNorm`, `PowerIntegral` of `nonhertz.study`.
        holding : tuple of str
            The quantities held constant when a shape changes: ``"load"`` or ``"approach"``, and ``"tilt"`` or
            ``"moment"``, independent of those prescribed in the solve.

        Returns
        -------
        Gradient
            Exact for these strips, and for the strips that are in contact now.

        Raises
        ------
        InputError
            If the solution has not converged, or there is no such quantity.

        Examples
        --------
        >>> import nonhertz as nh
        >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
        >>> solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=20e3)
        >>> stiffness = 1.0 / solution.gradient("approach").given["load"]
        >>> round(float(stiffness / solution.stiffness[0, 0]), 6)
        1.0
        >>> solution.gradient("max_pressure").by("a.profile.end_radius") < 0.0  # a flatter roller has a lower pressure
        True
        """
        from nonhertz.result.gradient import gradient

        return gradient(self, quantity, holding)

    @property
    def interference(self) -> Array:
        """Undeformed interference d = approach + tilt y - separation [mm] at each strip."""
        return self.approach + self.tilt * self.y - self.contact.separation_at(self.y)

    @property
    def displacement(self) -> Array:
        """Summed elastic displacement of both surfaces on the centre line [mm] at each strip; NaN beyond an end."""
        return self.gap + self.interference


def runs_out(solution: Solution, number: int, side: int) -> bool:
    """Return whether the pressure falls to zero at an end of an interval in contact.

    Parameters
    ----------
    solution : Solution
        The solution.
    number : int
        Index of the interval in ``contact_y``.
    side : {0, 1}
        The low or the high end.
    """
    inner = (number > 0, number + 1 < len(solution.contact_y))[side]
    return inner or solution.edge_pressure[side].kind is EdgeKind.RUN_OUT
