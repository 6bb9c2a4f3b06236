"""The life of a raceway with a dent that is rolled over.

A dent rolls with its surface through the contact, so that one solution with a dent is an instant of its passage. The
contact is solved on a plane grid with the dent in the middle of each cell across, from where it does not yet change the
pressure to where it no longer does, at the approach of the smooth contact: the load that a dent removes is too small to
move the bodies. Each point of the raceway travels with the dent and gets the largest value of its criterion, or half
the range of the orthogonal shear stress, over the whole passage. The damage added by the dent is the integral over its
surroundings, minus that of the same points on the smooth raceway.

The stress is that of the smooth strips plus that of the change of pressure by the dent on the cells. The change is
local, so at each depth its stress is a convolution on the grid of cells, by FFT, with the stress below one cell in
closed form. Below cell centres the steps between cells affect only the orthogonal shear stress, which is therefore
made proportional to the depth closer to the surface than half a cell.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import check_callback, flag, is_number, not_negative, positive, whole
from nonhertz.life.assessment import ratio
from nonhertz.life.catalogue import STRESSES, VolumeModel
from nonhertz.life.volume import Exposure, depths, exposure, integrate_over_depth, levels
from nonhertz.model.body import BodyName
from nonhertz.patch.features import Dent
from nonhertz.patch.solution import PatchSolution
from nonhertz.patch.solver import solve
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solved import Solved
from nonhertz.subsurface.evaluation import stress
from nonhertz.subsurface.field import TAU_XZ, max_shear_of, von_mises_of
from nonhertz.subsurface.inside import check_body, check_solution
from nonhertz.subsurface.rectangles import Rectangles

Array = NDArray[np.float64]

ACROSS_DENT, ACROSS_SHOULDER, ACROSS_CONTACT = 24, 8, 20  # cells at least; across half of a contact
EVERY = 2  # cells in either direction between the points that are followed
REACH = 3.0  # half-widths beyond the rim: extent of the surroundings
WINDOW = 3.5  # half-widths to either side: no point has its largest stress from further away
UNCHANGED = 1e-4  # of the maximum pressure: below this change the dent has no effect
WIDER = 1.2  # extent of the cells over that of the contact


@dataclass(frozen=True, eq=False, repr=False)
class Overrolled(HasFindings, ReadOnly):
    """Stresses in the surroundings of a dent while a contact rolls over them.

    Attributes
    ----------
    dent : Dent
        The dent.
    body : {"a", "b"}
        The body with the dent.
    diameter : float
        Diameter of that raceway [mm], positive; infinite where it is flat.
    smooth : Exposure
        The stresses of the smooth raceway, from its own solution.
    positions : ndarray, shape (stations,)
        Positions of the dent across the contact [mm] at which it changes the pressure; empty if it never does.
    max_pressure : ndarray, shape (stations,)
        Maximum pressure [MPa] within the surroundings at these positions.
    x, y, z : ndarray, shape (nx,), (ny,) and (depths,)
        Points of the surroundings [mm]: in the direction of rolling from the middle of the dent, along the contact, and
        below the surface.
    orthogonal_shear, shear, von_mises : ndarray, shape (nx, ny, depths)
        Half the range of tau_xz, and the largest maximum shear and von Mises stress, over the passage [MPa].
    smooth_orthogonal_shear, smooth_shear, smooth_von_mises : ndarray, shape (nx, ny, depths)
        The same without the dent.
    findings : tuple of Finding
        Strains of the solution with the dent where the pressure is largest, and whether cells were coarse.
    """

    dent: Dent
    body: BodyName
    diameter: float
    smooth: Exposure
    positions: Array
    max_pressure: Array
    x: Array
    y: Array
    z: Array
    orthogonal_shear: Array
    shear: Array
    von_mises: Array
    smooth_orthogonal_shear: Array
    smooth_shear: Array
    smooth_von_mises: Array
    findings: tuple[Finding, ...]

    def excess(self, model: VolumeModel, within: float = math.inf) -> float:
        """Return the damage added by the dent, an integral over its surroundings [MPa^k mm^(3-h)].

        Parameters
        ----------
        model : VolumeModel
            A model of `nonhertz.life`.
        within : float
            Distance from the middle of the dent [mm], in either direction, up to which points count: the excess hardly
            changes with it beyond a half-width or two from the rim.
        """
        if not is_number(within) or within != math.inf:
            positive("within", within, "give a distance from the middle of the dent in mm")
        x, y = np.abs(self.x) <= within, np.abs(self.y - self.dent.y) <= within
        added = self.density(model) - self.density(model, dented=False)
        return float(added[x][:, y].sum() * np.diff(self.x[:2])[0] * np.diff(self.y[:2])[0])

    def density(self, model: VolumeModel, *, dented: bool = True) -> Array:
        """Return the integral over the depth [MPa^k mm^(1-h)] at ``x`` and ``y``, with the dent or without."""
        flag("dented", dented, "write False for the smooth raceway")
        if not isinstance(model, VolumeModel):
            raise InputError("model", model, "be an integral over the volume", "give a VolumeModel")
        evaluated, fill = levels()
        stresses = np.maximum(getattr(self, model.stress if dented else f"smooth_{model.stress}") @ fill.T, 0.0)
        scale = self.z[-1] / evaluated[-1]
        return integrate_over_depth(model, stresses, *(scale * values for values in depths()))

    def relative_life(
        self,
        model: VolumeModel,
        *,
        dents: int = 1,
        per_area: float | None = None,
        raceway_diameter: float | None = None,
    ) -> float:
        """Return the life of the raceway with dents over that of the smooth one [-].

        Parameters
        ----------
        model : VolumeModel
            A model of `nonhertz.life`.
        dents : int
            Number of such dents around the raceway, at the same y, far enough apart not to meet in the contact.
        per_area : float, optional
            Instead of ``dents``, their number per area [1/mm^2] all over the raceway. The damage of each, relative to
            the smooth raceway at its y, is assumed equal to that of this one.
        raceway_diameter : float, optional
            Diameter of the raceway [mm]; by default that of the body.

        Raises
        ------
        InputError
            If the raceway is flat and has no diameter, or the dents would overlap.
        """
        excess, remedy = self.excess(model), "give the diameter of the raceway in mm"
        if raceway_diameter is None and per_area is None and math.isinf(self.diameter):
            raise InputError("raceway_diameter", None, "be given where the raceway is flat", remedy)
        if raceway_diameter is not None:
            positive("raceway_diameter", raceway_diameter, remedy)
        dents = whole("dents", dents, 0, math.inf, "give the number of dents around the raceway")
        if per_area is None:
            smooth = math.pi * (raceway_diameter or self.diameter) * self.smooth.damage(model)
            return ratio(smooth, smooth + dents * excess, model.slope)
        not_negative("per_area", per_area, "give the number of dents on a square millimetre")
        most = 4.0 / (math.pi * outer(self.dent) ** 2)
        if per_area > most:
            raise InputError("per_area", per_area, f"not exceed {most:.3g}", "with that many, dents cover the raceway")
        smooth = float(np.interp(self.dent.y, self.smooth.y, self.smooth.density(model)))
        return ratio(smooth, smooth + per_area * excess, model.slope)


def outer(dent: Dent) -> float:
    """Return the diameter [mm] within which a dent changes the surface."""
    return float(dent.shoulder_diameter or dent.diameter) if dent.shoulder > 0.0 else dent.diameter


def _usual_cell(dent: Dent, half_width: float) -> float:
    """Return the side of cells [mm] that shows the dent, its shoulder and the contact well enough."""
    shoulder = 0.5 * (outer(dent) - dent.diameter)
    sides = dent.diameter / ACROSS_DENT, half_width / ACROSS_CONTACT, shoulder / ACROSS_SHOULDER
    return min(sides if shoulder > 0.0 else sides[:2])


def overrolled(
    solution: Solved,
    dent: Dent,
    *,
    body: BodyName = "a",
    cell: float | None = None,
    reach: float = REACH,
    callback: Callable[[int, int], object] | None = None,
) -> Overrolled:
    """Roll a dent in a raceway through a contact, and return the stresses in its surroundings.

    Parameters
    ----------
    solution : Solution or PatchSolution
        The contact without the dent.
    dent : Dent
        The dent. Its ``y`` is its position along the contact; its ``x`` is ignored, since it rolls through.
    body : {"a", "b"}
        The body that has the dent and fatigues.
    cell : float, optional
        Side of the cells [mm]; if left out, the least of a 24th of the dent's diameter, an 8th of the width of its
        shoulder and a 20th of the half-width.
    reach : float
        How far the surroundings reach beyond the rim of the dent, in half-widths.
    callback : callable, optional
        Called with the number of positions done and the number expected.

    Returns
    -------
    Overrolled

    Raises
    ------
    InputError
        If the dent does not lie between the ends of the contact, with a half-width to spare, or a number is not valid.
    ConvergenceError
        If a position cannot be solved.

    Notes
    -----
    The dent keeps its shape: stress is elastic, without the residual stress of the displaced material. The calculation
    takes two to three minutes. The effect of side faces on the change of pressure by the dent is neglected.

    Examples
    --------
    A contact of 0.3 x 1.6 mm, on cells that are too coarse for more than two digits:

    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=8, profile=nh.profile.crown(radius=100))
    >>> dent = nh.patch.Dent(depth=0.002, diameter=0.3, shoulder=0.0005)
    >>> solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=300)
    >>> found = overrolled(solution, dent, body="b", cell=0.035, reach=1)
    >>> round(found.relative_life(nh.life.zaretsky(), dents=10), 1)
    0.9
    """
    check_body(body)
    contact, half_width = check_solution(solution).contact, solution.max_half_width
    _refuse_place(solution, dent)
    check_callback(callback)
    least = min(dent.diameter, half_width)
    usual = _usual_cell(dent, half_width)
    side = usual if cell is None else cell
    for name, value, most in (("reach", reach, 10.0), ("cell", side, 0.25 * least)):
        positive(name, value, f"give a number up to {most:.3g}, or leave it out")
        if value > most:
            raise InputError(name, value, f"not exceed {most:.3g}", "leave it out for the usual one")
    rim = 0.5 * outer(dent)
    words = (
        "Cells of {side:.3g} are coarser than the usual {usual:.3g}: the damage added by the dent may be wrong by half "
        "with orthogonal shear, by some per cent with other stresses."
    )
    coarse = [finding("coarse-cells", words, side=mm(side), usual=mm(usual))] if side > usual else []
    with without_accuracy_warnings():
        smooth, options = _grid(solution, dent, side)
        passed = _solve_passage(smooth, options, dent, callback)
    around = _Surroundings.of(solution, dent, body, smooth, rim + reach * half_width)
    differences = {place: patch.pressure - smooth.pressure for place, patch in passed.items()}
    places, near = sorted(passed), np.abs(smooth.y - dent.y) <= rim + half_width
    curvature = float(contact.bodies[body].curvature(np.array([dent.y]))[0])
    names = (*STRESSES, *(f"smooth_{name}" for name in STRESSES))
    return Overrolled(
        dent=dent,
        body=body,
        diameter=2.0 / abs(curvature) if curvature else math.inf,
        smooth=exposure(solution, body=body),
        positions=smooth.dx * np.array(places, dtype=float),
        max_pressure=np.array([passed[place].pressure[:, near].max() for place in places]),
        x=around.x,
        y=around.y,
        z=half_width * levels()[0],
        **dict(zip(names, around.largest(differences), strict=True)),
        findings=(*(max(passed.values(), key=lambda patch: patch.max_pressure).findings if passed else ()), *coarse),
    )


def _refuse_place(solution: Solved, dent: Dent) -> None:
    """Refuse a dent that meets one of the ends of a contact."""
    if not isinstance(dent, Dent):
        raise InputError("dent", dent, "be a dent", "make one with nonhertz.patch.Dent")
    room = 0.5 * outer(dent) + solution.max_half_width
    low, high = solution.contact.interval[0] + room, solution.contact.interval[1] - room
    if not low <= dent.y <= high:
        remedy = "choose a position where the ends of the contact have no effect"
        condition = (
            f"lie between {mm(low, high, between=' and '):.4g}"
            if low < high
            else "be narrower than the contact is long"
        )
        raise InputError("y" if low < high else "diameter", dent.y if low < high else dent.diameter, condition, remedy)


def _grid(solution: Solved, dent: Dent, side: float) -> tuple[PatchSolution, dict[str, Any]]:
    """Return the contact without the dent on cells of a size, and the options of all solutions on them.

    Their number across is odd, so that the middle of the dent passes over centres of cells.
    """
    contact, half_width = solution.contact, solution.max_half_width
    # The shoulder may touch beyond the edge, where the gap of Hertz's line contact is still smaller than its height:
    # 4 sqrt(2) / 3 (b^2 / 2 rho) (x / b - 1)^(3/2).
    rise = float(contact.curvature(np.array([dent.y]))[0]) * half_width**2 * 4.0 * math.sqrt(2.0) / 6.0
    across = half_width * (WIDER + (dent.shoulder / rise) ** (2.0 / 3.0))
    low, high = solution.contact_y[0][0] - 2.0 * half_width, solution.contact_y[-1][1] + 2.0 * half_width
    low, high = max(low, contact.interval[0]), min(high, contact.interval[1])
    cells = 2 * math.ceil(across / side) + 1, math.ceil((high - low) / side)
    options: dict[str, Any] = {"cells": cells, "region": ((-across, across), (low, high))}
    smooth = solve(contact, load=solution.load, tilt=solution.tilt, **options)
    return smooth, options | {"approach": smooth.approach, "tilt": smooth.tilt}


def _solve_passage(
    smooth: PatchSolution, options: dict[str, Any], dent: Dent, callback: Callable[[int, int], object] | None
) -> dict[int, PatchSolution]:
    """Return the solutions with the dent at all positions, in cells from the middle, where it changes the pressure."""
    solutions = dict[int, PatchSolution]()
    expected = math.ceil((0.5 * outer(dent) - smooth.x[0]) / smooth.dx)
    least = UNCHANGED * float(smooth.pressure.max())
    for place in count():
        solution = solve(smooth.contact, features=replace(dent, x=place * smooth.dx), **options)
        if np.abs(solution.pressure - smooth.pressure).max() < least:
            break
        solutions[-place] = replace(solution, pressure=solution.pressure[::-1], gap=solution.gap[::-1])
        solutions[place] = solution
        if callback is not None:
            callback(place + 1, max(expected, place + 1))
    return solutions


@dataclass(frozen=True, eq=False)
class _Surroundings:
    """The points that travel with the dent, and the stress below them."""

    x: Array  # the points [mm], from the middle of the dent across
    y: Array  # and along the contact
    columns: NDArray[np.int64]  # of cells, from the middle of the dent to the points on one side
    window: int  # columns of cells to either side of the contact for which stress is computed
    shallow: int  # number of `levels` that are less than half a cell deep
    smooth: Array  # stress of the smooth contact [MPa], shape (2 window + 1, ny, depths, 6)
    added: Callable[[Array], Array]  # differences of the pressure on cells -> the stress [MPa] they add, of that shape

    @classmethod
    def of(cls, solution: Solved, dent: Dent, body: BodyName, cells: PatchSolution, reach: float) -> _Surroundings:
        half_width = solution.max_half_width
        own = solution.contact.bodies[body]
        z = half_width * levels()[0]
        shallow = int(np.searchsorted(z, 0.5 * max(cells.dx, cells.dy)))
        columns = EVERY * np.arange(int(reach / (EVERY * cells.dx)) + 1)
        middle, most = round((dent.y - cells.y[0]) / cells.dy), int(reach / (EVERY * cells.dy))
        rows = middle + EVERY * np.arange(-most, most + 1)
        y = cells.y[0] + rows * cells.dy
        inside = (y > own.faces[0]) & (y < own.faces[1])
        rows, y = rows[inside], y[inside]
        window = int(WINDOW * half_width / cells.dx)
        across = cells.dx * np.arange(-window, window + 1)
        # No stress beyond the material of a thin wall.
        smooth = np.nan_to_num(stress(solution, across[:, None, None], y[:, None], z, body=body).stress)
        added = _stress_below(cells, window, rows, z, own.material.poisson)
        x = cells.dx * np.concatenate([-columns[:0:-1], columns])
        return cls(x, y, columns, window, shallow, smooth, added)

    def largest(self, differences: dict[int, Array]) -> list[Array]:
        """Return half the range of tau_xz and the largest stresses, over the passage: with the dent, then without."""
        alone = _measures(self.smooth)
        tops = [_Top(np.zeros((4, self.columns.size, *self.smooth.shape[1:3]))) for _ in range(2)]
        furthest = self.window + int(self.columns[-1]) + 2
        for place in range(-furthest, furthest + 1):
            at = place + self.columns + self.window
            seen = (at >= 0) & (at <= 2 * self.window)
            without = np.zeros_like(tops[0].last)
            without[:, seen] = alone[:, at[seen]]
            having = without
            if place in differences and seen.any():
                having = np.zeros_like(without)
                having[:, seen] = _measures(self.smooth[at[seen]] + self.added(differences[place])[at[seen]])
            for top, values in zip(tops, (having, without), strict=True):
                top.pass_by(values)
        return [largest_on_side for top in tops for largest_on_side in self._on_both_sides(top.best)]

    def _on_both_sides(self, best: Array) -> list[Array]:
        """Return the stresses on both sides of the dent, the orthogonal shear without the steps of cells."""
        both = np.stack([0.5 * (best[0] + best[1]), best[2], best[3]])
        depth, first = levels()[0], self.shallow
        both[0, ..., :first] = both[0, ..., first, None] * depth[:first] / depth[first]
        return list(np.concatenate([both[:, :0:-1], both], axis=1))


class _Top:
    """The largest value of a passing row of samples, refined by the parabola through three."""

    def __init__(self, nothing: Array) -> None:
        self.before, self.last, self.best = nothing, nothing, nothing

    def pass_by(self, values: Array) -> None:
        """Take the next sample of all points."""
        bend = 2.0 * self.last - self.before - values
        peaked = (self.last > self.before) & (self.last >= values)
        beyond = np.where(peaked, (values - self.before) ** 2 / (8.0 * np.where(bend > 0.0, bend, np.inf)), 0.0)
        self.best = np.maximum(self.best, self.last + beyond)
        self.before, self.last = self.last, values


def _measures(stresses: Array) -> Array:
    """Return tau_xz, -tau_xz, the maximum shear and the von Mises stress, shape (4, ...)."""
    tau = stresses[..., TAU_XZ]
    return np.stack([tau, -tau, max_shear_of(stresses), von_mises_of(stresses)])


def _stress_below(
    cells: PatchSolution, window: int, rows: NDArray[np.int64], z: Array, poisson: float
) -> Callable[[Array], Array]:
    """Return a function from pressures on cells to the stress below their middles, shape (columns, rows, depths, 6)."""
    # Imported here, because most lives are without a dent.
    from scipy.fft import irfft2, next_fast_len, rfft2

    half = cells.x.size // 2
    low, high = max(int(rows[0]), 0), min(int(rows[-1]) + 1, cells.y.size)
    shape = next_fast_len(2 * (half + window) + 1), next_fast_len(int(max(high, rows[-1]) - min(low, rows[0])) * 2 + 1)
    offsets = (np.rint(np.fft.fftfreq(n) * n) for n in shape)
    x, y = np.meshgrid(
        *(side * offset for side, offset in zip((cells.dx, cells.dy), offsets, strict=True)), indexing="ij"
    )
    one = np.zeros(1)
    cell = Rectangles.of(one, one, cells.dx, cells.dy, np.ones((1, 1)))
    kernels = []
    for depth in z:
        points = np.column_stack([x.ravel(), y.ravel(), np.full(x.size, depth)])
        kernels.append(rfft2(cell.stress(points, poisson).T.reshape(6, *shape)))
    columns = (np.arange(-window, window + 1) + half) % shape[0]
    out = np.ix_(columns, (rows - low) % shape[1])

    def added(pressure: Array) -> Array:
        spectrum = rfft2(pressure[:, low:high], shape)
        return np.stack([np.moveaxis(irfft2(spectrum * kernel, shape)[:, *out], 0, -1) for kernel in kernels], axis=-2)

    return added
