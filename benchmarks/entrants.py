"""The programs in the race, each behind the same two steps: get ready for a contact and a grid, then solve.

Getting ready makes what a program could keep from one solve to the next (half-space operators, plans, the gap) and is
not timed, except where a program does it in its one call. Plane grids are told where the contact is; strips are not.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from races import Race

import nonhertz as nh

BATCH, LOAD_RANGE = 256, 0.1
DEAREST = 1.5  # s, a solve expected to take longer is left out
# Grids by their accuracy: an automatic grid for each case, or that of the middle one of many, used for all.
AUTOMATIC, LEARNT, TO = "automatic", "learnt", " to "
Cells = tuple[int, int]


@dataclass(frozen=True)
class Answer:
    """What a program found, and where: on centre lines of strips, or on cells across and along."""

    approach: float
    max_pressure: float
    pressure: np.ndarray | None = None
    places: tuple[np.ndarray, ...] = ()

    @property
    def centre_pressure(self) -> float:
        """The pressure at x = y = 0, between the nearest places; not a number if there are none."""
        if self.pressure is None:
            return float("nan")
        along = self.pressure
        for at in self.places:
            along = at_zero(at, along)
        return float(along)


def at_zero(places: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the values at zero by the cubic through the four nearest places, which the first axis belongs to."""
    near = np.argsort(np.abs(places), kind="stable")[:4]
    at = places[near]
    weights = np.array([np.prod([-other / (own - other) for other in at if other != own]) for own in at])
    return np.tensordot(weights, values[near], axes=1)


Solve = Callable[[float], Answer]  # of the program's own tolerance


def strips(race: Race, grid: int | str, element: str) -> Solve:
    """Return a solve on that many equal strips, or on the automatic grid of an accuracy."""
    chosen = {"semi-elliptic": nh.SEMI_ELLIPTIC, "parabolic": nh.PARABOLIC}[element]

    def solve(_: float) -> Answer:
        solution = nh.solve(race.contact, load=race.load, tilt=race.tilt, element=chosen, **asked(grid))
        # Pressures are computed when they are asked for: here, where the clock sees it.
        return Answer(solution.approach, solution.max_pressure, solution.centre_pressure, (solution.y,))

    return solve


def asked(grid: int | str) -> dict[str, Any]:
    """Return a grid as `nonhertz.solve` takes it: a number of strips, or an accuracy."""
    return {"strips": grid} if isinstance(grid, int) else {"accuracy": float(grid.partition(TO)[2])}


def batch(race: Race, grid: int | str, element: str, threads: int) -> Solve:
    """Return a solve of many loads in one call: on equal strips, automatic grids, or one learnt from the middle load.

    A learnt grid is that of the middle load; the last one counts, furthest from it.
    """
    chosen = {"semi-elliptic": nh.SEMI_ELLIPTIC, "parabolic": nh.PARABOLIC}[element]
    loads = race.load * np.linspace(1.0 - LOAD_RANGE, 1.0, BATCH)

    def solve(_: float) -> Answer:
        on = asked(grid)
        if isinstance(grid, str) and grid.startswith(LEARNT):
            on = {"strips": nh.solve(race.contact, load=loads[BATCH // 2], tilt=race.tilt, element=chosen, **on).edges}
        found = nh.solve_many(race.contact, load=loads, tilt=race.tilt, element=chosen, threads=threads, **on)
        return Answer(float(found.approach[-1]), float(found.max_pressure[-1]))

    return solve


def patch(race: Race, cells: Cells, threads: int) -> Solve:
    """Return a solve with this package's plane grid."""
    import nonhertz.patch

    def solve(tolerance: float) -> Answer:
        found = nonhertz.patch.solve(
            race.contact,
            load=race.load,
            tilt=race.tilt,
            cells=cells,
            region=race.under(cells),
            tolerance=tolerance,
            threads=threads,
        )
        return _on_cells(race, cells, found.approach, found.pressure)

    return solve


def tamaas(race: Race, cells: Cells) -> Solve:
    """Return a solve by tamaas: its only solver for this, Polonsky and Keer's as Rey has it, without periodicity."""
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.warning)
    gap, size = race.gap(cells), race.size(cells)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, size, list(cells))
    model.E, model.nu = 1.0 / (np.pi * race.contact.compliance), 0.0
    tm.ModelFactory.registerNonPeriodic(model, "free")
    heights = gap.min() - gap
    solver = tm.PolonskyKeerRey(model, heights, 1e-12)
    solver.setIntegralOperator("free")
    solver.max_iter = 100_000

    def solve(tolerance: float) -> Answer:
        solver.tolerance = tolerance
        model.traction[...] = 0.0  # or it would start from the solution of the last call
        solver.solve(race.load / np.prod(size))
        pressure = np.array(model.traction)
        # The model's own displacement has lost its mean, in which the approach would be.
        displacement = np.empty_like(pressure)
        model.operators["free"](pressure, displacement)
        return _on_cells(race, cells, float((displacement + gap)[pressure > 0.0].mean()), pressure)

    return solve


def contact_mechanics(race: Race, cells: Cells, solver: str) -> Solve:
    """Return a solve by ContactMechanics with prescribed load, by one of the solvers that it has for that."""
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    gap, size = race.gap(cells), tuple(race.size(cells))
    space = FreeFFTElasticHalfSpace(cells, 1.0 / (np.pi * race.contact.compliance), size)
    # The smallest gap taken off: tolerances are counted from the heights' own scale.
    system = NonSmoothContactSystem(space, Topography(gap.min() - gap, size))
    scale = race.answer.get("approach", 0.01)
    forces = {"minimize_proxy": _proxy, "with restart": _dual, "without restart": _dual}[solver]

    def solve(tolerance: float) -> Answer:
        force = forces(system, race.load, tolerance * scale, solver)
        touching = force > 0.0
        approach = float((space.evaluate_disp(-force) + gap)[touching].mean())
        return _on_cells(race, cells, approach, force / space.area_per_pt)

    return solve


def _proxy(system: Any, load: float, tolerance: float, _: str) -> np.ndarray:
    # Of its five tolerances the penetration is the one that counts here; the others only must not stop it.
    result = system.minimize_proxy(external_force=load, pentol=tolerance, thermotol=1e-4, forcetol=np.inf)
    return result.jac


def _dual(system: Any, load: float, tolerance: float, solver: str) -> np.ndarray:
    from NuMPI.Optimization import CCGWithoutRestart, CCGWithRestart

    # What dual_minimize_proxy calls, with the mean force prescribed, which it does not pass on.
    minimize = {
        "with restart": CCGWithRestart.constrained_conjugate_gradients_with_restart,
        "without restart": CCGWithoutRestart.constrained_conjugate_gradients,
    }[solver]
    shape = system.surface.nb_grid_pts
    mean = load / np.prod(shape)
    result = minimize(
        system.dual_objective(0.0),
        system.dual_hessian_product,
        x0=np.full(shape, mean),
        mean_val=mean,
        gtol=tolerance,
        maxiter=100_000,
    )
    return result.x.reshape(shape)


def aspher(race: Race, cells: Cells, way: str) -> Solve:
    """Return a solve by ASPHER, whose cells are square on a square: nested grids in one call, or one with its operator.

    Of its operators the H2 one is made for grids far larger than these; its periodic one is another contact.
    """
    import aspher as ap

    count, (side, _) = cells[0], race.size(cells)
    coarsest = count
    while coarsest > 16 and coarsest % 2 == 0:
        coarsest //= 2
    given = {"gap": race.gap(cells), "p_nominal": race.load / side**2}
    body = {"grid_size": count, "domain_size": side, "E_star": 1.0 / (np.pi * race.contact.compliance)}
    solves = {
        "nested FFT": lambda: partial(ap.solve_nested, **body, **given, coarsest=coarsest, backend="fft"),
        "nested H2": lambda: partial(ap.solve_nested, **body, **given, coarsest=coarsest, active_set=True),
        "FFT": lambda: partial(ap.ContactSolver(**body, backend="fft").solve, **given, precond="fourier"),
    }
    chosen = solves[way]()

    def solve(tolerance: float) -> Answer:
        found = chosen(tol=tolerance)
        return _on_cells(race, cells, found.approach, found.pressure)

    return solve


def _on_cells(race: Race, cells: Cells, approach: float, pressure: np.ndarray) -> Answer:
    return Answer(float(approach), float(np.max(pressure)), np.asarray(pressure), race.axes(cells))


PLANE = ("patch", "tamaas", "ContactMechanics", "ASPHER")
PEERS = {"tamaas": "tamaas", "ContactMechanics": "ContactMechanics", "ASPHER": "aspher"}
# Of programs with more than one solver the fastest takes part.
SOLVERS = {
    "ContactMechanics": ("with restart", "minimize_proxy", "without restart"),
    "ASPHER": ("nested FFT", "nested H2", "FFT"),
}


def prepared(entrant: str, race: Race, grid: Any, threads: int) -> Solve:
    """Return the solve of an entrant: a program, and after a colon its variant."""
    program, _, variant = entrant.partition(": ")
    cells = tuple(grid) if isinstance(grid, (list, tuple)) else grid
    ready: dict[str, Callable[[], Solve]] = {
        "strips": partial(strips, race, grid, variant),
        "batch": partial(batch, race, grid, variant, threads),
        "patch": partial(patch, race, cells, threads),
        "tamaas": partial(tamaas, race, cells),
        "ContactMechanics": partial(contact_mechanics, race, cells, variant),
        "ASPHER": partial(aspher, race, cells, variant),
    }
    return ready[program]()


def missing() -> dict[str, str]:
    """Return the programs that cannot take part, each with the reason."""
    reasons = {name: "not installed" for name, module in PEERS.items() if importlib.util.find_spec(module) is None}
    if not _has_patch():
        reasons["patch"] = "nonhertz.patch has no solve"
    if not hasattr(nh, "solve_many"):
        reasons["batch"] = "nonhertz has no solve_many"
    return reasons


def versions() -> dict[str, str]:
    """Return the versions of the peers that are there."""
    absent = missing()
    return {name: importlib.metadata.version(name) for name in PEERS if name not in absent}


def _has_patch() -> bool:
    import nonhertz.patch

    return hasattr(nonhertz.patch, "solve")
