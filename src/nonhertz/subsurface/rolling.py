"""Stress history of a point below the surface while the load rolls over it, in the direction of x.

At each y and z the stress over a pass is the stress along the line in x. Its largest values are found on samples that
are denser at the edge of the contact, where the peak just below the surface is as narrow as the depth, and that extend
further with depth; they are refined by the vertex of a parabola through three neighbours.

The bending of the wall of a hollow roller extends all around it, and its points move on circles. Both halves have the
same load, so a quarter of a turn is enough, or half a turn where the pressure is not symmetric. Where the bodies touch
the surface is flat, and so are the paths just below; further away they approach the circles.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.hertz import LineContact
from nonhertz.inputs.checks import broadcast
from nonhertz.model.body import BodyName
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solved import Solved
from nonhertz.subsurface.evaluation import POINTS_REMEDY, Within, across_at, field_at, finite_numbers, refuse_options
from nonhertz.subsurface.field import (
    SIGMA_X,
    SIGMA_Z,
    TAU_XY,
    TAU_XZ,
    TAU_YZ,
    max_shear_of,
    orthogonal_shear_of,
    von_mises_of,
)
from nonhertz.subsurface.inside import Inside, check_solution

Array = NDArray[np.float64]

StressMeasure = Callable[[Array], Array]

#: The quantities whose largest value over a pass is found, with the functions that give them from the stress.
QUANTITIES: dict[str, StressMeasure] = {
    "von_mises": von_mises_of,
    "shear": max_shear_of,
    "orthogonal_shear": orthogonal_shear_of,
}

WITHIN, OUTSIDE = 12, 6  # samples from the middle to the edge, and beyond
# Reach of the samples, in half-widths and in depths: far below, |tau_xz| is largest at x = z / sqrt(3).
WIDER, DEEPER = 1.15, 0.8
FLAT = 3.0  # half-widths deep: halfway between a straight path and a circle next to the contact
AROUND = 12  # further samples in a quarter of a turn
REFINEMENTS = 3
DEEP = 0.15  # half-widths: below this every other sample suffices to find the passes that matter
POINTS_AT_ONCE = 2**18


@dataclass(frozen=True, eq=False, repr=False)
class Passage(ReadOnly):
    """The largest stresses over a pass of the load, at points (y, z) inside one body.

    Attributes
    ----------
    body : {"a", "b"}
        Which body.
    y, z : ndarray, shape (...)
        The points [mm].
    von_mises, shear, orthogonal_shear : ndarray, shape (...)
        Largest von Mises stress, maximum shear stress and |tau_xz| [MPa] over all x.
    von_mises_x, shear_x, orthogonal_shear_x : ndarray, shape (...)
        Positions x of these values [mm], x >= 0 where the field is symmetric.
    orthogonal_shear_range : ndarray, shape (...)
        Range of tau_xz over the pass, largest minus smallest [MPa]: twice the largest where the field is symmetric.
    """

    body: BodyName
    y: Array
    z: Array
    von_mises: Array
    shear: Array
    orthogonal_shear: Array
    von_mises_x: Array
    shear_x: Array
    orthogonal_shear_x: Array
    orthogonal_shear_range: Array


def passage(solution: Solved, y: ArrayLike, z: ArrayLike, **options: Unpack[Within]) -> Passage:
    """Return the largest stresses at points below a contact while the load rolls over them.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    y, z : array_like
        Points [mm] along and below the surface, broadcast against each other.
    **options
        ``body``, ``threads`` and ``callback`` as in `stress`.

    Returns
    -------
    Passage

    Raises
    ------
    InputError
        As for `stress`.

    Notes
    -----
    In a smooth field the error is below 1e-5 of the largest value at depths of 0.01 half-widths or more. Steps of the
    pressure on the surface may hide narrower peaks at depths below 0.05 half-widths.
    """
    refuse_options("passage", options, Within)
    return _passage(solution, y, z, options, turning=False)


def sampled_passage(solution: Solved, y: ArrayLike, z: ArrayLike, **options: Unpack[Within]) -> Passage:
    """Return the same from samples alone, within a few per cent: enough to locate the largest values."""
    return _passage(solution, y, z, options, turning=False, sampled=True)


def revolution(solution: Solved, y: ArrayLike, z: ArrayLike, **options: Unpack[Within]) -> Passage:
    """Return the largest stresses at points in a round body over a revolution.

    As `passage`, but the points turn with the body: x is replaced by the arc length, and tau_xz by the shear stress
    between the directions of the arc and of the depth.
    """
    return _passage(solution, y, z, options, turning=True)


def _passage(
    solution: Solved, y: ArrayLike, z: ArrayLike, options: Within, *, turning: bool, sampled: bool = False
) -> Passage:
    """Return the largest stresses along straight lines, or along circles about the axis."""
    check_solution(solution)
    along, below = broadcast(POINTS_REMEDY, finite_numbers("y", y), finite_numbers("z", z))
    inside = Inside.of(solution, options.get("body", "a"))
    inside.refuse_outside(np.zeros(along.shape), along, below)
    callback = options.get("callback")
    results = np.empty((2 * len(QUANTITIES) + 1, along.size))
    at_once = POINTS_AT_ONCE // (2 * (WITHIN + OUTSIDE))
    for start in range(0, along.size, at_once):
        part = np.arange(start, min(start + at_once, along.size))
        deep = below.flat[part] >= DEEP * across_at(solution, along.flat[part])[1] if sampled else np.zeros(part.size)
        for of, every in ((part[deep == 0], 1), (part[deep != 0], 2)):
            if of.size:
                places = along.flat[of], below.flat[of]
                refinements = 0 if sampled else REFINEMENTS
                results[:, of] = _largest_over_pass(
                    solution, inside, *places, options.get("threads"), turning, every, refinements
                )
        if callback is not None:
            callback(min(start + at_once, along.size), along.size)
    largest = [values.reshape(along.shape) for values in results]
    return Passage(inside.name, along, below, *largest)


def _largest_over_pass(
    solution: Solved,
    inside: Inside,
    y: Array,
    z: Array,
    threads: int | None,
    turning: bool,
    every: int,
    refinements: int,
) -> Array:
    """Return the largest values, their x, and the range of tau_xz, shape (7, points)."""
    centre, half_width = across_at(solution, y)
    along, below = y[:, None], z[:, None]
    if not turning:
        x = _samples(half_width, WIDER * half_width + DEEPER * z)
    else:
        outer = inside.extent.radii(along)[0]
        radius = outer - below
        quarter = 0.5 * np.pi * radius[:, 0]
        flat = np.minimum(half_width, 0.25 * quarter)
        x = _samples(flat, np.minimum(WIDER * flat + DEEPER * z, 0.5 * quarter))
        around = np.linspace(0.0, 1.0, AROUND + 1)[1:] ** 2
        x = np.concatenate([x, x[:, -1:] + (quarter[:, None] - x[:, -1:]) * around], axis=1)
    x = x[:, ::every]
    if not solution.symmetric_across:
        x = centre[:, None] + np.concatenate([-x[:, :0:-1], x], axis=1)

    def at(x: Array) -> Array:
        if not turning:
            return field_at(inside, np.broadcast_arrays(x, along, below), threads=threads).stress
        wide = half_width[:, None]
        apart = np.maximum(np.abs(x - centre[:, None]), WIDER * wide)
        curved = 1.0 - (WIDER * wide / apart) ** 2 / (1.0 + (below / (FLAT * wide)) ** 4)
        angle = x / radius
        path = np.broadcast_arrays(radius * np.sin(angle), along, below + curved * radius * (1.0 - np.cos(angle)))
        return _turn_stresses(field_at(inside, path, threads=threads).stress, curved * angle)

    sampled = at(x)
    if not solution.symmetric_across:
        signed = {"up": lambda stress: stress[..., TAU_XZ], "down": lambda stress: -stress[..., TAU_XZ]}
    else:
        signed = {}
    tops = {name: _largest(quantity, x, sampled, at, refinements) for name, quantity in (QUANTITIES | signed).items()}
    reach = tops["up"][0] + tops["down"][0] if signed else 2.0 * tops["orthogonal_shear"][0]
    values, places = zip(*(tops[name] for name in QUANTITIES), strict=True)
    return np.stack([*values, *places, reach])


def _turn_stresses(stresses: Array, angle: Array) -> Array:
    """Return stresses in the directions of arc, y and depth, at an angle from the line of contact."""
    cosine, sine = np.cos(angle), np.sin(angle)
    x, z, yz, xz, xy = (stresses[..., component] for component in (SIGMA_X, SIGMA_Z, TAU_YZ, TAU_XZ, TAU_XY))
    turned = stresses.copy()
    turned[..., SIGMA_X] = cosine**2 * x + sine**2 * z + 2.0 * sine * cosine * xz
    turned[..., SIGMA_Z] = sine**2 * x + cosine**2 * z - 2.0 * sine * cosine * xz
    turned[..., TAU_XZ] = (cosine**2 - sine**2) * xz + sine * cosine * (z - x)
    turned[..., TAU_XY], turned[..., TAU_YZ] = cosine * xy + sine * yz, cosine * yz - sine * xy
    return turned


def plane_strain_passage(line: LineContact, z: Array, poisson: float) -> dict[str, Array]:
    """Return the largest stresses [MPa] over a pass of Hertz's line contact at depths ``z`` [mm], by quantity."""
    half_width = np.full(z.shape, line.half_width)
    x = _samples(half_width, WIDER * half_width + DEEPER * z)

    def at(x: Array) -> Array:
        return line.stress(x, z[:, None], poisson)

    return {name: _largest(quantity, x, at(x), at)[0] for name, quantity in QUANTITIES.items()}


def _samples(half_width: Array, reach: Array) -> Array:
    """Return the initial samples of x [mm], from the middle outwards up to ``reach``, shape (points, samples)."""
    inwards = np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, WITHIN))
    outwards = np.linspace(0.0, 1.0, OUTSIDE + 1)[1:] ** 2
    beyond = reach - half_width
    return np.concatenate([half_width[:, None] * inwards, half_width[:, None] + beyond[:, None] * outwards], axis=1)


def _largest(
    measure: StressMeasure, x: Array, stresses: Array, at: Callable[[Array], Array], refinements: int = REFINEMENTS
) -> tuple[Array, Array]:
    """Return the largest value along each row of samples, and its x, refined between the samples.

    Samples without material are ignored; a row without any material gives NaN.
    """

    def quantity(stress: Array) -> Array:
        return np.nan_to_num(measure(stress), nan=0.0)

    none = np.isnan(stresses[..., 0]).all(axis=1)
    values = quantity(stresses)
    best = values.argmax(axis=1)
    if x[0, 0] == 0.0:  # the other side is this side's mirror image
        x, values, best = (np.column_stack([-x[:, 1], x]), np.column_stack([values[:, 1], values]), best + 1)
    best = np.clip(best, 1, x.shape[1] - 2)
    rows = np.arange(best.size)[:, None]
    near = best[:, None] + np.array([-1, 0, 1])
    x, values = x[rows, near], values[rows, near]
    for _ in range(refinements):
        vertex = _vertex(x, values)[:, None]
        x = np.concatenate([x, vertex], axis=1)
        values = np.concatenate([values, quantity(at(vertex))], axis=1)
        x, values = _around_the_largest(x, values)
    top = values.argmax(axis=1)[:, None]
    return np.where(none, np.nan, values[rows, top][:, 0]), x[rows, top][:, 0]


def _vertex(x: Array, values: Array) -> Array:
    """Return the position of the maximum of the parabola through three points of each row, within these points."""
    (before, middle, after), (low, top, high) = x.T, values.T
    to_left, to_right = (top - low) * (after - middle), (top - high) * (middle - before)
    bend = to_left + to_right
    moved = 0.5 * (to_left * (after - middle) - to_right * (middle - before)) / np.where(bend > 0.0, bend, np.inf)
    vertex: Array = np.clip(middle + moved, before, after)
    return vertex


def _around_the_largest(x: Array, values: Array) -> tuple[Array, Array]:
    """Return the largest of four points of each row and its two neighbours."""
    rows = np.arange(x.shape[0])[:, None]
    order = x.argsort(axis=1, kind="stable")
    x, values = x[rows, order], values[rows, order]
    near = np.clip(values.argmax(axis=1), 1, x.shape[1] - 2)[:, None] + np.array([-1, 0, 1])
    return x[rows, near], values[rows, near]
