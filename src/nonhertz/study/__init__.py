"""Studies: how the results of a contact or a bearing depend on its inputs.

`sweep` solves a case for many values of its inputs and returns a `Sweep`; `tolerance` propagates distributions of its
inputs to its results and returns a `Tolerance`; `optimize` finds the best dimensions, a `Design`; `pareto` trades two
groups of loads against each other and returns a `Front`. All four are also names of `nonhertz`.
`nonhertz.Solution.gradient` makes a `Gradient` of a named number of a solution, or of one of these: `PressureAt`,
`HalfWidthAt`, `PressureNorm`, `PowerIntegral`, or `damage` by a model of fatigue.
"""

from nonhertz.files.sampling import Sampling as Sampling
from nonhertz.files.spreads import Distribution as Distribution
from nonhertz.lazy import dir_of
from nonhertz.result.gradient import Gradient as Gradient
from nonhertz.result.measures import HalfWidthAt as HalfWidthAt
from nonhertz.result.measures import Measure as Measure
from nonhertz.result.measures import Partials as Partials
from nonhertz.result.measures import PowerIntegral as PowerIntegral
from nonhertz.result.measures import PressureAt as PressureAt
from nonhertz.result.measures import PressureNorm as PressureNorm
from nonhertz.study.design import Band as Band
from nonhertz.study.design import Design as Design
from nonhertz.study.design import Front as Front
from nonhertz.study.design import Start as Start
from nonhertz.study.design import optimize as optimize
from nonhertz.study.design import pareto as pareto
from nonhertz.study.diagrams import Diagram as Diagram
from nonhertz.study.diagrams import diagram as diagram
from nonhertz.study.limits import Capability as Capability
from nonhertz.study.limits import Limit as Limit
from nonhertz.study.lives import damage as damage
from nonhertz.study.sweeps import Progress as Progress
from nonhertz.study.sweeps import Sweep as Sweep
from nonhertz.study.sweeps import sweep as sweep
from nonhertz.study.tolerances import Index as Index
from nonhertz.study.tolerances import Quantile as Quantile
from nonhertz.study.tolerances import Tolerance as Tolerance
from nonhertz.study.tolerances import tolerance as tolerance

__all__ = [
    "Band", "Capability", "Design", "Diagram", "Distribution", "Front", "Gradient", "HalfWidthAt", "Index", "Limit",
    "Measure", "Partials", "PowerIntegral", "PressureAt", "PressureNorm", "Progress", "Quantile", "Sampling", "Start",
    "Sweep", "Tolerance", "damage", "diagram", "optimize", "pareto", "sweep", "tolerance",
]  # fmt: skip
__dir__ = dir_of(__name__)
