"""The numbers of nonhertz in C++: arrays in, arrays out."""

from collections.abc import Callable, Sequence
import enum
from typing import Annotated, overload

import numpy
from numpy.typing import NDArray


class Element:
    def __init__(self, like: Element, table: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> None:
        """The same with another table: to see what a mistake in it would do."""

    @property
    def name(self) -> str: ...

    @property
    def line_factor(self) -> float: ...

    @property
    def hertz_ratio(self) -> float: ...

    @property
    def far_constant(self) -> float: ...

    @property
    def leading(self) -> list[float]: ...

    @property
    def table(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

POWERS: int = 5

SEMI_ELLIPTIC: Element = ...

PARABOLIC: Element = ...

def evaluate(element: Element, t: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]:
    """A, t A', B and t B', shape (t, 4)."""

class Term:
    def __init__(self, sign: float, offset: float, weight: float) -> None: ...

def face_densities(element: Element, distances: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], weights: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], u: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], v: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]:
    """
    What a free side face adds to displacement and curvature of a load of unit length, shape (2, u).
    """

class FaceTable:
    def __init__(self, arg: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

def free_end(u: float, inner: float, outer: float, table: FaceTable, element: Element) -> list[float]:
    """
    What a free side face adds to [A], [t A'], [B] and [t B'] of a strip, all distances in half-widths.
    """

class Face:
    def __init__(self, place: float, side: float, weight: float, table: FaceTable) -> None: ...

class Kernel:
    def __init__(self, element: Element, terms: Sequence[Term], faces: Sequence[Face]) -> None: ...

    @property
    def element(self) -> Element: ...

class Grid:
    """
    Strips side by side, with everything that is known before their loads are.
    """

    def __init__(self, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], curvature: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], separation: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], min_depth: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], sharper: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], at_depth: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], by_width: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> None: ...

    @property
    def edges(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def y(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def separation(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def curvature(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def min_depth(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def sharper(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def at_depth(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), writable=False)]: ...

    @property
    def by_width(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), writable=False)]: ...

class Status(enum.IntEnum):
    CONVERGED = 0

    ITERATION_LIMIT = 1

    STAGNATED = 2

class State:
    """The unknowns of strips, and what follows from them."""

    def __init__(self, r: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], gap: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], rigid: Sequence[float], stiffness: Sequence[Sequence[float]], status: Status, steps: int, residual: float) -> None: ...

    @property
    def rigid(self) -> list[float]: ...

    @property
    def stiffness(self) -> list[list[float]]: ...

    @property
    def status(self) -> Status: ...

    @property
    def steps(self) -> int: ...

    @property
    def residual(self) -> float: ...

    @property
    def r(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def m(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def gap(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

def solve_on(grid: Grid, by_force: Sequence[bool], target: Sequence[float], kernel: Kernel, near_grid: Grid | None = None, near_state: State | None = None, tolerance: float = 1e-11, patient: bool = True) -> State: ...

class Following:
    """Strips on which solved contacts follow to other motions."""

    def __init__(self, grid: Grid, kernel: Kernel) -> None: ...

    def follow(self, motion: Sequence[float], state: State) -> tuple[list[float] | None, State]:
        """K Q and K T, None if the contact got lost, and the state that is left."""

TOLERANCE: float = 1e-11

ROUGH_TOLERANCE: float = 1e-06

PATIENT_STRIPS: int = 400

def steady(stiffness: Sequence[Sequence[float]], reach: float) -> bool: ...

def coefficients(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], active: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], kernel: Kernel) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None, None), writable=False)]:
    """
    [A], [t A'], [B] and [t B'] of the active strips at the centres of all, shape (4, n, active).
    """

def displacements(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], grid: Grid, r: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], kernel: Kernel) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
    """Displacement on the surface, points at depth left out."""

def by_own_width(by_width: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], strip: int, a: float) -> list[float]: ...

class HarmonicElements:
    def __init__(self, poisson: float, across: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], along: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], outer: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], inner: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], outer_slope: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], inner_slope: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], values: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], slopes: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], weights: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], bored: bool, symmetric: bool) -> None: ...

    def works(self, waves: Sequence[int], loads: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], readings: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int = 1) -> list[Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]]: ...

    def displacement(self, waves: int, loads: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class LogarithmicTable:
    def __init__(self, arg0: float, arg1: float, arg2: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], /) -> None: ...

def flat_modes(loads: LogarithmicTable, planes: LogarithmicTable, curved: LogarithmicTable, weights: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], distances: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], image: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], face: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half_length: float, places: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], points: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], radius: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

BLOCK: int = 8

def solve_linear(matrix: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], sides: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

def subtract_product(from_matrix: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], left: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], right: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]:
    """A square matrix less the product of two others."""

def newton(grid: Grid, by_force: Sequence[bool], target: Sequence[float], kernel: Kernel, state: State, tolerance: float = 1e-11, relaxation: float = 1.0, eager: bool = True) -> State: ...

def violation(grid: Grid, by_force: Sequence[bool], target: Sequence[float], kernel: Kernel, state: State) -> tuple[float, State]:
    """
    The largest relative violation of contact and balance, and the state with its gaps.
    """

def start_from_springs(grid: Grid, by_force: Sequence[bool], target: Sequence[float], kernel: Kernel) -> State:
    """The response of independent springs, not a solution."""

def start_from_other(other: Grid, solved: State, grid: Grid, by_force: Sequence[bool], target: Sequence[float]) -> State | None: ...

def product(a: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], b: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]:
    """a b, with the same last digits whatever the number of threads."""

def solve_dense(a: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], b: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]:
    """a^-1 b, with the same last digits whatever the number of threads."""

class Cubics:
    def __init__(self, places: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], coefficients: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> None: ...

class StripDisplacement:
    def __init__(self, cubics: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], nearest: float, far: float, step: float) -> None: ...

class Corner:
    def __init__(self, extent: float, radius: float, arc: float, slope: float) -> None: ...

class Relief:
    @staticmethod
    def straight() -> Relief: ...

    @staticmethod
    def arcs(radius: float, end_radius: float, junction: float, end_summit: float) -> Relief: ...

    @staticmethod
    def logarithmic(amplitude: float, length: float, rest: float, curved: float, at_end: float) -> Relief: ...

    @staticmethod
    def conical(slope: float) -> Relief: ...

    @staticmethod
    def tapered_ends(straight: float, slope: float) -> Relief: ...

    @staticmethod
    def uniform_pressure(amplitude: float, length: float, half_width: float, displacement: StripDisplacement) -> Relief: ...

    @staticmethod
    def polyline(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], values: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Relief: ...

    @staticmethod
    def cubics(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], coefficients: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Relief: ...

    @staticmethod
    def sum(parts: Sequence[Relief]) -> Relief: ...

    @staticmethod
    def moved(relief: Relief, scale: float, shift: float, flip: bool, low: float, high: float) -> Relief: ...

    @staticmethod
    def cornered(land: Relief, half_length: float, corner: Corner, tangents: Sequence[Sequence[float]]) -> Relief: ...

    @staticmethod
    def function(of: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]]) -> Relief: ...

    def __call__(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

class TabulatedDiameter:
    def __init__(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], diameter: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], middle: float) -> None: ...

class DepthInDiameters:
    def __init__(self, diameters: float, curvature: float | TabulatedDiameter | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], refuse: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]]) -> None: ...

class WholeRoller:
    def __init__(self, z: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], outer: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], smooth: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], curved: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], logarithm: float, beta: float) -> None: ...

    def by_width(self, radius: float) -> list[float]: ...

    def displacement(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class FarImages:
    def __init__(self, distance: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], weight: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], beyond: float, length: float) -> None: ...

class FreeFace:
    def __init__(self, place: float, side: float, weight: float) -> None: ...

class PointsAtDepth:
    def __init__(self, depth: float | DepthInDiameters | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], poisson_factor: float, terms: Sequence[Term], far: FarImages | None, faces: Sequence[FreeFace], over_image: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> None: ...

    def displacement(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class AxisOfCylinder:
    def __init__(self, diameter: float | DepthInDiameters | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], smooth: Cubics, terms: Sequence[Term]) -> None: ...

    def displacement(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class OtherReference:
    def __init__(self, below: float | DepthInDiameters | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], displaced: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]]) -> None: ...

class AxisOfRoller:
    def __init__(self, depth: float | DepthInDiameters | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], whole: WholeRoller, radius: float, middle: float, share: float) -> None: ...

    def displacement(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

    def by_width(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], ratio: float) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class Body:
    def __init__(self, relief: Relief, curvature: float | TabulatedDiameter | Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], modulus: float) -> None: ...

class FreedFace:
    def __init__(self, y: float, side: float, image_weight: float, free: float) -> None: ...

class Model:
    def __init__(self, bodies: Sequence[Body], kernel: Kernel, references: Sequence[PointsAtDepth | AxisOfCylinder | AxisOfRoller | OtherReference], freed: Sequence[FreedFace], compliance: float, interval: Sequence[float], bends: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], crests: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], refuse: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]]) -> None: ...

    def separation(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    def curvature(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    def sharper_curvature(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    def min_depth(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    def by_width(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

    def at_depth(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

    def grid(self, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Grid: ...

    @property
    def kernel(self) -> Kernel: ...

class Refusal(enum.Enum):
    """Why no strips can meet a prescription."""

    NAN_RELIEF = 0

    ENDLESS_RELIEF = 1

    ARM_OUTSIDE = 2

    ARM_OFF_STRIPS = 3

    TILTED_APART = 4

    BETWEEN_STRIPS = 5

    UNRESOLVED = 6

    APART = 7

    NO_END = 8

class Refused(Exception):
    pass

ACCURACY: float = 0.0001

class Accuracy:
    """The relative errors that an automatic grid aims for."""

    def __init__(self, of_motion: float, of_pressure: float) -> None: ...

def bound_contact(model: Model, by_force: Sequence[bool], target: Sequence[float]) -> list[float]:
    """
    The interval in which to look for the contact [mm]; finite even where the bodies are unbounded.
    """

def is_feasible(model: Model, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], by_force: Sequence[bool], target: Sequence[float]) -> bool:
    """
    Whether some loads on the strips between these edges can meet what is prescribed.
    """

def refuse_infeasible(model: Model, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], by_force: Sequence[bool], target: Sequence[float], chosen: bool = True) -> None: ...

def first_strips(model: Model, by_force: Sequence[bool], target: Sequence[float]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
    """The edges of the equal strips that an automatic grid begins with [mm]."""

def kinks_among(model: Model, bends: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], length: float) -> tuple[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]]:
    """
    Those of the bends [mm] at which the slope of the separation jumps, and by how much [rad].
    """

def springs(model: Model, by_force: Sequence[bool], target: Sequence[float], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
    """Squares of the half-widths of independent springs [mm^2]."""

@overload
def intervals(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> list[list[float]]:
    """Both ends of every interval in contact [mm]."""

@overload
def intervals(edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> list[list[float]]: ...

def reaches(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], side: int) -> bool:
    """
    Whether a contact extends to the outer edge of its strips on that side, -1 or 1.
    """

def is_nearly_touching(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], place: float) -> bool:
    """
    Whether the strip around a place or one of its neighbours is in contact.
    """

def width_near(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], place: float) -> float:
    """
    The largest half-width of the few strips in contact nearest to a place [mm].
    """

def fall(grid: Grid, m: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], low: float, high: float, side: int) -> float:
    """
    The distance from one end of a contact at which m is half its value at the nearest peak [mm].
    """

def peaks(grid: Grid, state: State, kinks: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], allowed: float) -> list[list[float]]:
    """
    Where the largest pressure is too pointed for its strips, the width wanted there and that of the strip [mm].
    """

def summits_of(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], depth: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
    """
    The vertices of parabolas through three neighbouring places each, where they are deeper than zero.
    """

def overlaps(model: Model, grid: Grid, state: State, low: float, high: float) -> list[list[float]]:
    """
    Where another contact may have been missed, and widths for strips there [mm].
    """

def lay(model: Model, grid: Grid, state: State, low: float, high: float, extras: Sequence[Sequence[float]], coarseness: float, share: float, limit: float) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
    """
    The edges of the strips [mm] that a coarser solution calls for, within an interval.
    """

class EndKind(enum.IntEnum):
    RUN_OUT = 0

    FINITE = 1

    SINGULAR = 2

    CORNER = 3

    CUT_OFF = 4

class End:
    @property
    def kind(self) -> EndKind: ...

    @property
    def y(self) -> float: ...

    @property
    def width(self) -> float: ...

    @property
    def pressure(self) -> float: ...

    @property
    def image_weight(self) -> float: ...

    @property
    def exponent(self) -> float: ...

    @property
    def correction_exponent(self) -> float: ...

class SingularEnd:
    @property
    def y(self) -> float: ...

    @property
    def is_corner(self) -> bool: ...

    @property
    def width(self) -> float: ...

class Errors:
    @property
    def approach(self) -> float: ...

    @property
    def load(self) -> float: ...

    @property
    def max_pressure(self) -> float: ...

    @property
    def moment(self) -> float: ...

    @property
    def tilt(self) -> float: ...

    @property
    def left_by_modes(self) -> float: ...

    @property
    def pressure_left_by_modes(self) -> float: ...

class Checks:
    @property
    def length_ratio(self) -> float: ...

    @property
    def radius_ratio(self) -> float: ...

    @property
    def depth_ratio(self) -> float: ...

    @property
    def half_width(self) -> float: ...

    @property
    def unevenness(self) -> float: ...

    @property
    def deepest(self) -> float: ...

    @property
    def pressed(self) -> float: ...

    @property
    def mean_pressure(self) -> float: ...

    @property
    def missed(self) -> float: ...

    @property
    def missed_y(self) -> float: ...

class Judgement:
    @property
    def contact(self) -> list[list[float]]: ...

    @property
    def ends(self) -> list[End]: ...

    @property
    def singular(self) -> list[SingularEnd]: ...

    @property
    def max_pressure(self) -> float: ...

    @property
    def max_pressure_y(self) -> float: ...

    @property
    def max_half_width(self) -> float: ...

    @property
    def peaks_at_corner(self) -> bool: ...

    @property
    def penetration(self) -> float: ...

    @property
    def errors(self) -> Errors: ...

    @property
    def checks(self) -> Checks: ...

class Level:
    """A state with the strips that it is of."""

    def __init__(self, model: Model, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], state: State) -> None: ...

def judge(model: Model, by_force: Sequence[bool], target: Sequence[float], levels: Sequence[Level], accuracy: float) -> Judgement: ...

def values_that_count(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], values: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half_width: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], ends: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], int]: ...

def corner_ends(bends: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], compliance: float, separation: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], pressure: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half_width: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

def penetration(model: Model, edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], rigid: Sequence[float]) -> float: ...

class Unmet(enum.Enum):
    NONE = 0

    NOT_FINITE = 1

    FIRST = 2

    SECOND = 3

    TENSION = 4

    UNCLOSED = 5

    OVERLAP = 6

    BENT = 7

    HIDDEN = 8

class Shortfall:
    @property
    def condition(self) -> Unmet: ...

    @property
    def value(self) -> float: ...

    @property
    def at(self) -> int: ...

class Result:
    """A case as it ended, judged."""

    @property
    def edges(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def gap(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def status(self) -> Status: ...

    @property
    def rigid(self) -> list[float]:
        """Approach and tilt."""

    @property
    def stiffness(self) -> list[list[float]]:
        """Scaled."""

    @property
    def resultant(self) -> list[float]:
        """K Q and K T."""

    @property
    def steps(self) -> int: ...

    def line_load(self, compliance: float) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    def half_width(self, compliance: float = 1.0) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
        """Of the element's own pressure."""

    @property
    def levels(self) -> list[tuple[NDArray[numpy.float64], State]]:
        """Edges and states, finest first."""

    @property
    def accuracy(self) -> float: ...

    @property
    def is_steady(self) -> bool: ...

    @property
    def holds(self) -> bool: ...

    @property
    def shortfall(self) -> Shortfall: ...

    @property
    def judgement(self) -> Judgement: ...

class Stop:
    """Stops the solves that look at it within a Newton step."""

    def __init__(self) -> None: ...

    def set(self) -> bool: ...

    @property
    def is_set(self) -> bool: ...

def solve(model: Model, by_force: Sequence[bool], target: Sequence[float], strips: Accuracy | int | NDArray[numpy.float64], stop: Stop | None = None) -> Result | None:
    """Solve a case; None once stopped."""

def solve_in_turn(model: Model, by_force: Sequence[bool], targets: Sequence[Sequence[float]], strips: Accuracy | int | NDArray[numpy.float64], stop: Stop | None = None) -> list[Result | Exception]:
    """Solve similar cases; less of them once stopped."""

def restored(model: Model, by_force: Sequence[bool], target: Sequence[float], levels: Sequence[tuple[Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], State]], accuracy: float, accepted: bool) -> Result:
    """
    A result from states that were kept, checked again unless they are known to be accepted.
    """

def columns(results: Sequence[Result], compliance: float) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class Slices:
    def __init__(self, y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], relief: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], stiffness: float, exponent: float) -> None: ...

class MapLaw:
    def __init__(self, table: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> None: ...

class GroupLaw:
    """A law that is asked for the contacts of many rollers at once."""

    def answer(self, rollers: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], poses: Annotated[NDArray[numpy.float64], dict(shape=(None, None, None), order='C', device='cpu', writable=False)]) -> NDArray[numpy.float64]:
        """
        Answers of contacts, shape (n, contacts, 7), at poses of the shape (n, contacts, 2).
        """

class PythonLaw(GroupLaw):
    def __init__(self, law: Callable[[object, object], object]) -> None: ...

class Unsolved(Exception):
    pass

class StrippedContact:
    """A contact between roller and ring, to be solved on strips."""

    def __init__(self, model: Model) -> None: ...

    @property
    def loops(self) -> int:
        """How many loops are kept for strips."""

    def penetration(self, poses: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
        """
        How deep the undeformed bodies overlap where they do most [mm], at poses of the shape (n, 2).
        """

class StripLaw(GroupLaw):
    """How the contacts of rollers answer by strips."""

    def __init__(self, contacts: Sequence[StrippedContact], strips: int | None = None) -> None: ...

    def lay_anew(self) -> None:
        """
        From now on lay strips anew for contacts that are not nearly those which they were laid for.
        """

    def edges(self, roller: int, contact: int = 0) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]:
        """Of the strips on which a contact was solved last [mm]."""

    @property
    def laid_for(self) -> list[tuple[float, float]]:
        """The poses for which strips of the automatic grid were laid."""

    @property
    def evaluations(self) -> dict[int, int]:
        """How often the contacts of each roller were evaluated."""

    @property
    def followed(self) -> int:
        """How many contacts were led on."""

    @property
    def solved(self) -> int:
        """How many were solved on strips."""

class Joint:
    def __init__(self, inner: bool, motion: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], gap: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], law: Slices | MapLaw | GroupLaw, column: int, first: int) -> None: ...

class Assembly:
    def __init__(self, ring: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], joints: Sequence[Joint], load: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], lever: float, stiffness: float) -> None: ...

def balance(assembly: Assembly, by_force: Sequence[bool], depth: float, tolerance: float, steps: int, target: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], start: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], motion: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], threads: int, stop: Stop | None = None) -> tuple[NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.int64], NDArray[numpy.float64], NDArray[numpy.float64], NDArray[numpy.float64]] | None:
    """States of a bearing in balance; None once stopped."""

def map_states(table: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], by_load: bool, values: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], tilts: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

def map_shares(table: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], loads: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], tilts: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], stations: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

def map_tilt_coordinates(numbers: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], x: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], tilts: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

def map_functions() -> list[int]: ...

class SurfaceLoad:
    def six(self, points: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], terms: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], poisson: float, displaced: bool) -> NDArray[numpy.float64]: ...

def strip_load(low: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], high: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], line_load: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half_width: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], first: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> SurfaceLoad: ...

def rectangles(x_edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], y_edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], pressure: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], columns: Annotated[NDArray[numpy.int64], dict(shape=(None, 2), order='C', device='cpu', writable=False)], rows: Annotated[NDArray[numpy.int64], dict(shape=(None, 2), order='C', device='cpu', writable=False)], middle: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], starts: Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)], nodes: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], weights: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], ellipses: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> SurfaceLoad: ...

class SemiEllipseRules:
    @property
    def starts(self) -> Annotated[NDArray[numpy.int64], dict(shape=(None,), order='C', device='cpu', writable=False)]: ...

    @property
    def nodes(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def weights(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def enough(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

def semi_ellipse_rules() -> SemiEllipseRules: ...

def stress_tail(X: float, Y: float, z: float, poisson: float) -> list[float]: ...

def displacement_tail(X: float, Y: float, z: float, poisson: float) -> list[float]: ...

def add_from_afar(arg0: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], arg1: float, arg2: float, arg3: float, arg4: float, arg5: Annotated[NDArray[numpy.float64], dict(shape=(None, 6), order='C', device='cpu')], /) -> None: ...

def at_nodes(panels: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], to_nodes: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], weights: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], k: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], edges: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], steps: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

def between_distances(knots: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], log_k: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], log_r: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], coefficients: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)]: ...

class Wall:
    def __init__(self, arg0: Annotated[NDArray[numpy.float64], dict(shape=(None, None, None, None), order='C', device='cpu', writable=False)], arg1: float, arg2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg3: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

    def add(self, arg0: Annotated[NDArray[numpy.float64], dict(shape=(None, 3), order='C', device='cpu', writable=False)], arg1: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg3: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg4: float, arg5: Annotated[NDArray[numpy.float64], dict(shape=(None, 6), order='C', device='cpu')], /) -> None: ...
