"""Force against displacement of a bearing on a grid, for programs that move shafts themselves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import format_digits, format_input, mrad, um
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.mapped import BearingMaps
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.section import MOTIONS
from nonhertz.bearing.standard import LAMINAE
from nonhertz.bearing.verb import Method, solve_many
from nonhertz.errors import InputError
from nonhertz.findings import finding, warn
from nonhertz.inputs.checks import broadcast, numbers, one_of, whole
from nonhertz.maps.misses import SAFETY
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.read_only import ReadOnly, freeze

Array = NDArray[np.float64]
Kind = Literal["linear", "cubic"]

KINDS = ("linear", "cubic")
MOST_STATES = 200_000
CHECKS = 200
_LEAST = {"linear": 2, "cubic": 4}  # points on an axis
# States solved together: of 13 rollers each takes some 5 kB, and half a megabyte where its strips are kept.
_TOGETHER, _BY_STRIPS = 2000, 200


@dataclass(frozen=True, eq=False, repr=False)
class ForceTable(ReadOnly, HasHtml):
    """Forces on the inner ring of a bearing on a grid of its motions; made by `table`.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    method : str
        How its contacts were solved.
    speed : float
        Speed of the turning ring [1/min].
    turning : {"inner", "outer"}
        The ring that turns.
    names : tuple of str
        The displacements that vary: some of ``"x"``, ``"y"``, ``"z"`` [mm], ``"about_y"`` and ``"about_z"`` [rad].
    axes : tuple of ndarray
        Their values, ascending; the grid has an axis for each.
    displacement, force : ndarray, shape (..., 5)
        As in `BearingSolution` [mm, rad], [N, N mm].
    stiffness : ndarray, shape (..., 5, 5)
        d(force) / d(displacement).
    converged : ndarray of bool, shape (...)
        Whether equilibrium was found; where not, forces and stiffness are NaN.
    checked_displacement, checked_force : ndarray, shape (checks, 5)
        Solved in the middle of cells, for the error of interpolation; only those that converged.
    """

    bearing: RollerBearing | Paired
    method: str
    speed: float
    turning: str
    names: tuple[str, ...]
    axes: tuple[Array, ...]
    displacement: Array
    force: Array
    stiffness: Array
    converged: NDArray[np.bool_]
    checked_displacement: Array
    checked_force: Array

    def __post_init__(self) -> None:
        super().__post_init__()
        for axis in self.axes:
            freeze(axis)

    def __repr__(self) -> str:
        rows = [f"{type(row.bearing).__name__} of {row.bearing.rollers} rollers" for row in self.bearing.rows]
        grid = [
            f"{name} {(mrad if name.startswith('about') else um)(axis[0], axis[-1], between=' to '):.4g} in {axis.size}"
            for name, axis in zip(self.names, self.axes, strict=True)
        ]
        at = f", at {format_input(self.speed)} 1/min of the {self.turning} ring" if self.speed else ""
        lines = [
            f"{' and '.join(rows)}, by {self.method}{at}",
            "; ".join(grid),
            f"{np.count_nonzero(self.converged)} of {self.converged.size} states converged",
        ]
        if self.checked_force.size:
            lines.append(f"interpolated linearly, sampled error {self.error_in_words}")
        return plain_text("ForceTable", lines)

    @property
    def error_in_words(self) -> str:
        """The sampled errors of linear interpolation over the largest forces and moments."""
        off = self.sampled_error()
        parts = []
        for what, where in (("force", slice(0, 3)), ("moment", slice(3, 5))):
            largest = float(np.max(np.abs(np.nan_to_num(self.force[..., where]))))
            if largest > 0.0:
                parts.append(f"{format_digits(100.0 * float(np.max(off[where])) / largest, 2)} % of the largest {what}")
        return " and ".join(parts) or "0 %"

    def interpolated(
        self,
        *,
        x: ArrayLike | None = None,
        y: ArrayLike | None = None,
        z: ArrayLike | None = None,
        about_y: ArrayLike | None = None,
        about_z: ArrayLike | None = None,
        kind: Kind = "linear",
    ) -> Array:
        """Return forces and moments between the points of the grid.

        Parameters
        ----------
        x, y, z, about_y, about_z : array_like
            The displacements that vary in the table [mm, rad], and no others; broadcast against each other.
        kind : {"linear", "cubic"}
            Linear in each cell, or a cubic spline, which needs four points on every axis and smooths kinks;
            `sampled_error` gives the error of both.

        Returns
        -------
        ndarray, shape (..., 5)
            [N, N mm].

        Raises
        ------
        InputError
            If a displacement is missing, does not vary in the table, or lies outside it.
        """
        self._check_kind(kind)
        remedy = f"give {', '.join(self.names)}"
        motions = dict(zip(MOTIONS, (x, y, z, about_y, about_z), strict=True))
        for name, value in motions.items():
            if (value is not None) is not (name in self.names):
                condition = "be given" if value is None else "be left out: it does not vary in the table"
                raise InputError(name, value, condition, remedy)
        places = [numbers(name, motions[name], "give numbers in mm and rad") for name in self.names]  # type: ignore[arg-type]
        at = np.stack(broadcast(remedy, *places), axis=-1)
        for name, axis, values in zip(self.names, self.axes, np.moveaxis(at, -1, 0), strict=True):
            beyond = np.flatnonzero((values.ravel() < axis[0]) | (values.ravel() > axis[-1]))
            if beyond.size:
                condition = f"lie in the range of the table, {axis[0]:.6g} to {axis[-1]:.6g}"
                raise InputError(name, float(values.ravel()[beyond[0]]), condition, "make a table of a wider range")
        force: Array = self._interpolate(kind, at)
        return force

    def sampled_error(self, kind: Kind = "linear") -> Array:
        """Return one and a half times the largest error of interpolation that was found in the middle of cells.

        An estimate, no bound, as for `nonhertz.ContactMap`.

        Parameters
        ----------
        kind : {"linear", "cubic"}
            As for `interpolated`.

        Returns
        -------
        ndarray, shape (5,)
            [N, N mm]; NaN if nothing was checked.

        Raises
        ------
        InputError
            If the kind is unknown, or the grid too small for it.
        """
        self._check_kind(kind)
        at = self.checked_displacement[:, [list(MOTIONS).index(name) for name in self.names]]
        off = np.abs(self._interpolate(kind, at) - self.checked_force)
        off = off[np.isfinite(off.sum(axis=1))]
        return SAFETY * np.max(off, axis=0) if off.size else np.full(5, np.nan)

    def _interpolate(self, kind: Kind, at: Array) -> Array:
        # Slow to import, and few need it.
        from scipy.interpolate import RegularGridInterpolator

        force: Array = RegularGridInterpolator(self.axes, self.force, method=kind)(at)
        return force.reshape(*at.shape[:-1], 5)

    def _check_kind(self, kind: Kind) -> None:
        one_of("kind", kind, KINDS, "use 'linear', or 'cubic' for a spline")
        least = _LEAST[kind]
        for name, axis in zip(self.names, self.axes, strict=True):
            if axis.size < least:
                condition = f"not be used with {axis.size} points along {name}: it needs {least}"
                raise InputError("kind", kind, condition, "use 'linear', or make a larger table")
        if kind == "cubic" and not np.all(self.converged):
            condition = "not be used where states have not converged: a spline needs all of them"
            raise InputError("kind", kind, condition, "use 'linear', or make a table of a narrower range")


def table(
    bearing: RollerBearing | Paired,
    *,
    x: ArrayLike = 0.0,
    y: ArrayLike = 0.0,
    z: ArrayLike = 0.0,
    about_y: ArrayLike = 0.0,
    about_z: ArrayLike = 0.0,
    speed: float = 0.0,
    turning: str = "inner",
    method: Method | BearingMaps = "strips",
    laminae: int = LAMINAE,
    checks: int = CHECKS,
) -> ForceTable:
    """Return the forces on the inner ring of a bearing on a grid of its motions.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    x, y, z : float or array_like
        Displacements of the inner ring [mm]: a number if fixed, ascending numbers for an axis of the grid.
    about_y, about_z : float or array_like
        Rotations of the inner ring [rad], likewise.
    speed, turning, method, laminae
        As in `nonhertz.bearing.solve_many`; use maps for a large table.
    checks : int
        Number of cells, drawn at random, in the middle of which it is solved too, for the error of interpolation; all
        cells if there are fewer.

    Returns
    -------
    ForceTable

    Raises
    ------
    InputError
        If the input is invalid.
    ConvergenceError
        If a contact has no solution by strips.

    Warns
    -----
    AccuracyWarning
        If states have not converged.

    Examples
    --------
    >>> import numpy as np
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> forces = table(row, y=np.linspace(0, 0.03, 7), about_z=np.linspace(-1e-3, 1e-3, 5), method="slices")
    >>> forces.force.shape, forces.interpolated(y=0.012, about_z=0)[1].round(-2)
    ((7, 5, 5), np.float64(5000.0))
    """
    count = whole("checks", checks, 0, MOST_STATES, "give the number of cells to check, 200 say")
    motions = dict(zip(MOTIONS, (x, y, z, about_y, about_z), strict=True))
    values = {name: _values(name, value) for name, value in motions.items()}
    axes = {name: axis for name, axis in values.items() if axis.ndim}
    if not axes:
        raise InputError(
            "y", motions["y"], "be an array if no other displacement is", "give the values of one displacement or more"
        )
    states = math.prod(map(np.size, values.values()))
    if states > MOST_STATES:
        condition = f"be at most {MOST_STATES} points, not {states}"
        raise InputError("grid of " + ", ".join(axes), "too large", condition, "give fewer values")
    speed = BearingLoad(speed=speed).speed
    options: dict[str, Any] = {"speed": speed, "turning": turning, "method": method, "laminae": laminae}
    grid = _grid(values)
    force, stiffness, converged = _solve_grid(bearing, grid.reshape(-1, 5), options)
    middles = _grid({name: 0.5 * (axis[1:] + axis[:-1]) if axis.ndim else axis for name, axis in values.items()})
    middles = middles.reshape(-1, 5)
    if count < len(middles):
        middles = middles[np.sort(np.random.default_rng(0).choice(len(middles), count, replace=False))]
    checked, _, settled = _solve_grid(bearing, middles, options) if len(middles) else (middles, None, np.ones(0, bool))
    failed = np.count_nonzero(~converged) + np.count_nonzero(~settled)
    if failed:
        words = "No equilibrium was found for {failed} of {states} states of the bearing; see converged."
        warn([finding("no-balance", words, failed=failed, states=converged.size + settled.size)])
    shape = grid.shape[:-1]
    return ForceTable(
        bearing=bearing,
        method="strips" if isinstance(method, BearingMaps) else method,
        speed=speed,
        turning=turning,
        names=tuple(axes),
        axes=tuple(axes.values()),
        displacement=grid,
        force=force.reshape(*shape, 5),
        stiffness=stiffness.reshape(*shape, 5, 5),
        converged=converged.reshape(shape),
        checked_displacement=middles[settled],
        checked_force=checked[settled],
    )


def _values(name: str, value: ArrayLike) -> Array:
    """Return a number, or the values along an axis."""
    remedy = "give a number, or ascending ones"
    axis = numbers(name, value, remedy)
    if axis.ndim and (axis.ndim > 1 or axis.size < 2 or np.any(np.diff(axis) <= 0.0)):
        raise InputError(name, value, "be a number or two or more that ascend", remedy)
    return axis.copy()


def _grid(values: dict[str, Array]) -> Array:
    """Return all displacements at the points of a grid, of shape (..., 5)."""
    axes = [value for value in values.values() if value.ndim]
    spread = iter(np.meshgrid(*axes, indexing="ij"))
    shape = tuple(axis.size for axis in axes)
    return np.stack([next(spread) if value.ndim else np.full(shape, value) for value in values.values()], axis=-1)


def _solve_grid(
    bearing: RollerBearing | Paired, displacement: Array, options: dict[str, Any]
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return forces, stiffness and which states have converged; numbers are NaN where not."""
    parts = []
    method = options["method"]
    together = _BY_STRIPS if isinstance(method, str) and method == "strips" else _TOGETHER
    for first in range(0, len(displacement), together):
        solutions = solve_many(bearing, displacement=displacement[first : first + together], **options)
        settled = solutions.converged
        force = np.where(settled[:, None], solutions.force, np.nan)
        parts.append((force, np.where(settled[:, None, None], solutions.stiffness, np.nan), settled))
    force, stiffness, converged = (np.concatenate(part) for part in zip(*parts, strict=True))
    return force, stiffness, converged
