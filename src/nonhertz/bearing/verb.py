"""The entry point: a bearing and its loading in, loads and motions out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.amounts import mm, newton
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.equilibrium import TOLERANCE, Joint, States, System, find_edge_rollers, solve_balance
from nonhertz.bearing.kinematics import PER_MINUTE
from nonhertz.bearing.laws import ContactLaw, MapLaw
from nonhertz.bearing.mapped import BearingMaps
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.prescribed import BearingLoad, Prescribed, TurningRing, many_states, motions, one_state
from nonhertz.bearing.section import raceway_motion
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE, standard_slices
from nonhertz.bearing.states import BearingSolutions
from nonhertz.bearing.strips import cut_into_strips
from nonhertz.errors import ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.findings import Finding, warn
from nonhertz.inputs.checks import thread_count
from nonhertz.inputs.descriptions import Count, Word
from nonhertz.inputs.fields import Input, document_parameters, input_class
from nonhertz.life.lamina import FEWEST, MOST, STIFFENING, roller_stiffness
from nonhertz.native import core
from nonhertz.result.data import name_axes

Array = NDArray[np.float64]
Method = Literal["strips", "slices"]

# Slices and a few strips give the start for the strips of the automatic grid, with a residual over the loads of NEARBY.
# Slices must be as narrow as the contacts of rollers that only speed loads are long.
GUIDING_SLICES, ROUGH_STRIPS, NEARBY = 81, 21, 1e-2
# Residual of slices over the loads, above which there is no equilibrium; where there is one, 1e-9 is left.
UNBALANCED = 1e-6
# Relative error of the preload that the clearance between two rows gives, and the largest number of steps.
_PRELOAD_WITHIN, _MOST_ADJUSTMENTS = 1e-5, 12
# Speed of the pitch circle [mm/s]. At half of it the hoop stress of a free ring of steel, rho v^2, is 1960 MPa.
_MOST_RIM_SPEED = 1e6


@input_class(kw_only=True)
class BearingSolver(Input):
    """How a bearing is solved."""

    method: Annotated[
        Method,
        Word(
            "'strips', on the automatic grid, or 'slices', the independent ones of ISO/TS 16281",
            "use 'strips', or 'slices' for comparison",
            get_args(Method),
        ),
    ] = "strips"
    laminae: Annotated[
        int, Count("number of slices, for the method 'slices'", FEWEST, MOST, "give the number of slices, 41 say")
    ] = LAMINAE


@document_parameters(BearingLoad, TurningRing)
def solve(
    bearing: RollerBearing | Paired,
    *,
    radial: ArrayLike | None = None,
    axial: float | None = None,
    moment: ArrayLike | None = None,
    radial_displacement: ArrayLike | None = None,
    axial_displacement: float | None = None,
    tilt: ArrayLike | None = None,
    speed: float = 0.0,
    turning: str = "inner",
    method: Method | BearingMaps = "strips",
    laminae: int = LAMINAE,
) -> BearingSolution:
    """Return a bearing in equilibrium, under loads on its inner ring or displacements of it; the outer ring is at rest.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    {BearingLoad}
    {TurningRing}
    method : {"strips", "slices"} or BearingMaps
        Strips on the automatic grid, the independent slices of ISO/TS 16281, or maps of this bearing, made by `maps`,
        which stand in for strips while equilibrium is sought.
    laminae : int
        Number of slices, for the method ``"slices"``.

    Returns
    -------
    BearingSolution
        Loads of all rollers, displacements, forces, stiffness and, by strips, pressures.

    Raises
    ------
    InputError
        If the input is invalid.
    ConvergenceError
        If no equilibrium is found.

    Warns
    -----
    AccuracyWarning
        If a contact is near the limits of the model, ends where the pressure is singular or is refused, if one on a rib
        reaches an edge, or if slices take hollow rollers as solid. The findings are in ``solution.findings`` too.

    Notes
    -----
    A direction in which neither force nor displacement is given has no force; without a moment or a tilt the ring does
    not tilt. Slices use the nominal contact angle at both rings and ignore the ribs of tapered rows.

    A roller has three degrees of freedom: along x, along r and about the tangent. Friction and skew are left out, and
    displacements are small compared with the rollers. The model of a whole roller assumes the same pressure on both
    sides; where the contacts on both sides are tilted differently, the antisymmetric part is neglected.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)
    >>> float(nh.bearing.solve(row, radial=20e3, method="slices").load[0, 0].round(-1))
    6840.0
    """
    solver, maps, speed, loaded = _check_options(bearing, speed, turning, method, laminae)
    inputs: dict[str, Any] = {
        "radial": radial, "axial": axial, "moment": moment, "radial_displacement": radial_displacement,
        "axial_displacement": axial_displacement, "tilt": tilt,
    }  # fmt: skip
    bearing = adjust_preload(bearing, solver.method, solver.laminae)
    system, states = _solve_states(bearing, loaded, solver, maps, one_state(bearing, BearingLoad(**inputs)))
    if not states.converged(TOLERANCE)[0]:
        words = f"No equilibrium of rollers and rings was found in {states.steps[0]} steps"
        remedy = "give forces that press the rings together, an axial one beside a moment, or check signs and units"
        raise ConvergenceError(f"{words}: the loads may leave the inner ring unsupported; {remedy}.", None)
    solution = BearingSolution.of(
        bearing, solver.method, turning, speed, states, loaded, find_edge_rollers(system, states)
    )
    try:
        findings = solution.findings
    except (InputError, ConvergenceError) as error:  # loads are known without pressures
        findings = (Finding.from_text(f"There are no pressures: {error}", "no-pressures"),)
    warn(findings)
    return solution


def solve_many(
    bearing: RollerBearing | Paired,
    *,
    radial: ArrayLike | None = None,
    axial: ArrayLike | None = None,
    moment: ArrayLike | None = None,
    radial_displacement: ArrayLike | None = None,
    axial_displacement: ArrayLike | None = None,
    tilt: ArrayLike | None = None,
    displacement: ArrayLike | None = None,
    speed: float = 0.0,
    turning: str = "inner",
    method: Method | BearingMaps = "strips",
    laminae: int = LAMINAE,
    threads: int | None = None,
) -> BearingSolutions:
    """Return a bearing in equilibrium under many loads; with maps a state takes half a millisecond.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    radial, axial, moment, radial_displacement, axial_displacement, tilt : array_like, optional
        As in `solve`, along y, x and about z, broadcast against each other.
    displacement : array_like, shape (..., 5), optional
        In their place, the whole displacement of the inner ring: along x, y and z [mm] and about y and z [rad].
    speed, turning, method, laminae
        As in `solve`, for all states.
    threads : int, optional
        Threads for slices and maps; all cores if left out. Results do not depend on it.

    Returns
    -------
    BearingSolutions

    Raises
    ------
    InputError
        If the input is invalid.
    """
    solver, maps, speed, loaded = _check_options(bearing, speed, turning, method, laminae)
    inputs = {
        "radial": radial, "axial": axial, "moment": moment, "radial_displacement": radial_displacement,
        "axial_displacement": axial_displacement, "tilt": tilt,
    }  # fmt: skip
    bearing = adjust_preload(bearing, solver.method, solver.laminae)
    acting, shape = many_states(bearing, inputs) if displacement is None else motions(displacement, inputs)
    _, states = _solve_states(bearing, loaded, solver, maps, acting, thread_count(threads))
    arrays = {name: np.broadcast_to(value, shape) for name, value in inputs.items() if value is not None}
    return BearingSolutions.of(
        bearing, solver.method, turning, speed, states, loaded, shape, name_axes(arrays, shape, "state")
    )


def adjust_preload(
    bearing: RollerBearing | Paired, method: Method = "strips", laminae: int = LAMINAE
) -> RollerBearing | Paired:
    """Return paired rows with the clearance that gives their preload; other bearings unchanged.

    Raises
    ------
    InputError
        If the rows cannot bear the preload.
    ConvergenceError
        If no such clearance is found.
    """
    if not isinstance(bearing, Paired) or bearing.preload is None:
        return bearing
    row, preload = bearing.bearings[0], bearing.preload

    def solve_half(clearance: float) -> BearingSolution:
        """Return one row held at the middle of the pair; the other is its mirror image."""
        half = Paired(bearings=(row,), x=(0.0,), turned=(False,), clearance=clearance)
        return solve(half, axial_displacement=0.0, method=method, laminae=laminae)

    with without_accuracy_warnings():
        try:
            # A row alone moves by half of the clearance, but for what ribs and unequal contact angles change.
            between = -2.0 * float(solve(row, axial=preload, method=method, laminae=laminae).displacement[0])
            for _ in range(_MOST_ADJUSTMENTS):
                solution = solve_half(between)
                missing = preload - float(solution.force[0])
                if abs(missing) <= _PRELOAD_WITHIN * preload:
                    return replace(bearing, clearance=between, preload=None)
                between -= 2.0 * missing / float(solution.stiffness[0, 0])
        except InputError as error:
            raise InputError("pair.preload", preload, "be borne by the rows", str(error)) from None
    raise ConvergenceError(f"No clearance was found that gives the rows a preload of {newton(preload):.4g}.", None)


def _check_options(
    bearing: RollerBearing | Paired, speed: float, turning: str, method: Any, laminae: int
) -> tuple[BearingSolver, BearingMaps | None, float, Array]:
    """Return how a bearing is solved, its speed [1/min] and the loads of that on rollers; refuse impossible input."""
    if not isinstance(bearing, RollerBearing | Paired):
        remedy = "make one, such as nonhertz.bearing.CylindricalRollerBearing, or take that of a BearingCase"
        raise InputError("bearing", bearing, "be a bearing", remedy)
    maps = method if isinstance(method, BearingMaps) else None
    solver = BearingSolver(method="strips" if maps else method, laminae=laminae)
    speed = BearingLoad(speed=speed).speed
    rate = PER_MINUTE * speed
    if maps is not None and maps.bearing != bearing:
        raise InputError("method", maps, "be maps of this bearing", "make them with nonhertz.bearing.maps")
    rows = [row.bearing for row in bearing.rows]
    pitch = max(row.pitch for row in rows)
    if 0.5 * pitch * rate > _MOST_RIM_SPEED:
        condition = (
            f"not exceed {2.0 * _MOST_RIM_SPEED / (pitch * PER_MINUTE):.3g} 1/min on a pitch circle of "
            f"{mm(pitch):g}, twice the speed at which rings of steel burst"
        )
        raise InputError("speed", speed, condition, "give that of the ring that turns in 1/min")
    loads = [np.tile(row.load_by_speed(rate, turning), (row.rollers, 1)) for row in rows]
    return solver, maps, speed, np.concatenate(loads)


def _solve_states(
    bearing: RollerBearing | Paired, load: Array, solver: BearingSolver, maps: BearingMaps | None, acting: Prescribed,
    threads: int = 1,
) -> tuple[System, States]:  # fmt: skip
    """Return the rollers with their contact laws, and the states of the bearing."""
    by_force, target = acting
    depth, start = _expected_depth(bearing, acting), np.zeros_like(target)
    start[:, 0] = np.where(target[:, 0] != 0.0, np.sign(target[:, 0]) * depth, 0.0)
    sliced = solver.method == "slices"
    count = solver.laminae if sliced else GUIDING_SLICES
    laws: list[Any] = [(standard_slices(row.bearing, count),) * 2 for row in bearing.rows]
    if maps is not None:
        laws = [[MapLaw(map_) for map_ in pair] for pair in maps.contacts]
    system = assemble(bearing, load, laws, nominal=sliced)
    states = solve_balance(system, by_force, target, start, depth, threads=threads)
    if maps is not None:
        _refuse_beyond(bearing, laws, states)
    # Whether loads can be balanced depends on where and in which directions rollers press, not on their stiffness:
    # where slices find no equilibrium, strips find none either, and would be pressed ever deeper.
    in_balance = np.flatnonzero(states.residual <= UNBALANCED)
    if sliced or maps is not None or not in_balance.size:
        return system, states
    return _refine_by_strips(bearing, load, acting, depth, states, in_balance)


def _refine_by_strips(
    bearing: RollerBearing | Paired, load: Array, acting: Prescribed, depth: float, states: States,
    in_balance: NDArray[np.int64],
) -> tuple[System, States]:  # fmt: skip
    """Return the rollers with strips, and their states, started from those of slices that are in equilibrium."""
    by_force, target = acting
    near, target = states.portion(in_balance), target[in_balance]
    # Slices are solved to the end: rollers that only speed presses on the outer ring bear less than the residual of a
    # rough solution. Rollers that the inner ring presses start where springs would have them, which is closer.
    idle = ~(near.load[:, :, :1] > 0.0)
    motion = np.where(idle, near.motion, np.nan)
    contacts = [[cut_into_strips(contact) for contact in row.bearing.contacts] for row in bearing.rows]
    few, many = ([core.StripLaw(contact, strips) for contact in contacts] for strips in (ROUGH_STRIPS, None))
    coarse, fine = (assemble(bearing, load, [(law, law) for law in laws]) for laws in (few, many))
    near = solve_balance(coarse, by_force, target, near.ring, depth, NEARBY, motion)
    near = solve_balance(fine, by_force, target, near.ring, depth, NEARBY, near.motion)
    # The grids of strips were made for the contacts of the first step.
    for law in many:
        law.lay_anew()
    near = solve_balance(fine, by_force, target, near.ring, depth, motion=near.motion)
    for into, values in zip(states, near, strict=True):
        into[in_balance] = values
    return fine, states


def _refuse_beyond(bearing: RollerBearing | Paired, laws: Sequence[Sequence[MapLaw]], states: States) -> None:
    """Refuse states with contacts outside the maps."""
    for row, pair in zip(bearing.rows, laws, strict=True):
        for k, law in enumerate(pair):
            approach, tilt = (states.pose[:, row.rollers, k, column].ravel() for column in range(2))
            if not np.all(law.covers(approach, tilt) | (states.load[:, row.rollers, k].ravel() == 0.0)):
                load, turned = float(states.load.max()), float(np.abs(states.pose[..., 1]).max())
                condition = (
                    f"reach to loads of {newton(load):.4g} and tilts of {turned:.4g} rad, which these states have"
                )
                raise InputError("method", "maps too small", condition, "make larger ones")


def _expected_depth(bearing: RollerBearing | Paired, acting: Prescribed) -> float:
    """Return an estimate of the penetration [mm]."""
    by_force, target = acting
    rows = [row.bearing for row in bearing.rows]
    pitch = max(row.pitch for row in rows)
    reach = np.array([1.0, 1.0, 1.0, pitch, pitch])
    most = float(np.max(np.where(by_force, np.abs(target) / reach, 0.0), initial=0.0)) * 5.0
    most /= sum(row.rollers for row in rows)
    length = min(row.roller_length for row in rows)
    by_load = float((most / roller_stiffness(length)) ** (1.0 / STIFFENING))
    moved = float(np.max(np.where(by_force, 0.0, np.abs(target * reach)), initial=0.0))
    gap = max(float(np.max(np.abs(gaps))) for row in bearing.rows for gaps in row.gaps)
    return max(by_load, moved, 1e-6 * max(row.roller_diameter for row in rows)) + 4.0 * gap


def assemble(
    bearing: RollerBearing | Paired, load: Array, laws: Sequence[Sequence[ContactLaw]], *, nominal: bool = False
) -> System:
    """Return the rollers with a contact law for each raceway of each row, and ribs; if nominal, as in ISO/TS 16281."""
    joints: list[Joint] = []
    load = load.copy()
    for row, of_row in zip(bearing.rows, laws, strict=True):
        angle, motions = row.bearing.nominal_angle, row.bearing.raceway_motions
        if nominal:
            # In the standard nothing holds tapered rollers along their axes: only the load on raceways counts.
            normal = np.array([math.sin(angle), math.cos(angle), 0.0])
            load[row.rollers] = np.outer(load[row.rollers] @ normal, normal)
            # Barrels align themselves; tapered rollers have the contact angle of the bearing at both rings.
            if len(set(row.bearing.contact_angles)) > 1:
                motions = raceway_motion(angle, inner=True), raceway_motion(angle, inner=False)
        for column, (motion, gap, law) in enumerate(zip(motions, row.gaps, of_row, strict=True)):
            joints.append(Joint(column == 0, motion, gap, law, column, row.first))
        for column, (rib, gap) in enumerate(zip(row.bearing.rib_contacts, row.rib_gaps, strict=True), start=2):
            if not (nominal and angle):
                joints.append(Joint(rib.ring == "inner", rib.motion, gap, rib.law, column, row.first))
    lever = 0.5 * max(row.bearing.roller_length for row in bearing.rows)
    return System(np.concatenate([row.ring_motion for row in bearing.rows]), tuple(joints), load, lever)
