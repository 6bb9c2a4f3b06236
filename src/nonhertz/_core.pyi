"""The numbers of nonhertz in C++: arrays in, arrays out."""

from collections.abc import Callable, Sequence
import enum
from typing import Annotated

import numpy
from numpy.typing import NDArray


class Element:
    def __init__(self, arg0: str, arg1: float, arg2: float, arg3: float, arg4: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

    @property
    def name(self) -> str: ...

    @property
    def line_factor(self) -> float: ...

    @property
    def hertz_ratio(self) -> float: ...

    @property
    def far_constant(self) -> float: ...

    @property
    def table(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

SEMI_ELLIPTIC: Element = ...

PARABOLIC: Element = ...

def evaluate(element: Element, t: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]:
    """A, t A', B and t B' of each t, one after the other."""

class Term:
    def __init__(self, sign: float, offset: float, weight: float) -> None: ...

class FaceTable:
    def __init__(self, arg: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

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

def steady(arg0: Sequence[Sequence[float]], arg1: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> bool: ...

def by_own_width(by_width: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], strip: int, a: float) -> list[float]: ...

class Arcs:
    def __init__(self, arg0: float, arg1: float, arg2: float, arg3: float, /) -> None: ...

class Logarithmic:
    def __init__(self, arg0: float, arg1: float, arg2: float, arg3: float, arg4: float, /) -> None: ...

class Function:
    def __init__(self, arg: Callable[[Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]], Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]], /) -> None: ...

class Moved:
    def __init__(self, arg0: Arcs | Logarithmic | Function, arg1: float, arg2: float, arg3: bool, arg4: float, arg5: float, /) -> None: ...

class Relief:
    def __init__(self, arg0: Sequence[Moved], arg1: float, arg2: float, arg3: float, /) -> None: ...

class Body:
    def __init__(self, arg0: Relief, arg1: float, arg2: float, /) -> None: ...

class FreedFace:
    def __init__(self, arg0: float, arg1: float, arg2: float, arg3: float, /) -> None: ...

class FreeFace:
    def __init__(self, arg0: float, arg1: float, arg2: float, /) -> None: ...

class PointsAtDepth:
    def __init__(self, arg0: float, arg1: float, arg2: Sequence[Term], arg3: Sequence[FreeFace], arg4: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

class AxisOfRoller:
    def __init__(self, arg0: float, arg1: float, arg2: float, arg3: float, arg4: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], arg5: Annotated[NDArray[numpy.float64], dict(shape=(None, None), order='C', device='cpu', writable=False)], arg6: float, arg7: float, /) -> None: ...

class Model:
    def __init__(self, arg0: Sequence[Body], arg1: Element, arg2: Sequence[Term], arg3: Sequence[Face], arg4: Sequence[PointsAtDepth | AxisOfRoller], arg5: Sequence[FreedFace], arg6: float, arg7: Sequence[float], arg8: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg9: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> None: ...

    def separation(self, arg: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], /) -> object: ...

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
    def __init__(self, arg0: Model, arg1: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg2: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg3: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg4: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], arg5: Sequence[float], arg6: Sequence[Sequence[float]], arg7: Status, /) -> None: ...

def judge(model: Model, by_force: Sequence[bool], target: Sequence[float], levels: Sequence[Level], accuracy: float) -> Judgement: ...

def counted(y: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], values: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], half_width: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)], ends: Annotated[NDArray[numpy.float64], dict(shape=(None,), order='C', device='cpu', writable=False)]) -> tuple: ...

class Result:
    @property
    def status(self) -> Status: ...

    @property
    def rigid(self) -> list[float]: ...

    @property
    def stiffness(self) -> list[list[float]]: ...

    @property
    def steps(self) -> int: ...

    @property
    def edges(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def r(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def m(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def gap(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def q(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def a(self) -> Annotated[NDArray[numpy.float64], dict(shape=(None,), writable=False)]: ...

    @property
    def resultant(self) -> list[float]: ...

    @property
    def grids(self) -> int: ...

    @property
    def unmet(self) -> tuple[int, float, int]: ...

    @property
    def is_steady(self) -> bool: ...

    @property
    def judgement(self) -> Judgement: ...

class Refused(Exception):
    pass

class Automatic:
    def __init__(self, arg: float, /) -> None: ...

def solve(model: Model, by_force: Sequence[bool], target: Sequence[float], strips: Automatic | int | Sequence[float]) -> Result: ...

def solve_many(model: Model, by_force: Sequence[bool], targets: Sequence[Sequence[float]], strips: Automatic | int | Sequence[float], threads: int = 1) -> list[Result]: ...
