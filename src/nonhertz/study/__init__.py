"""Studies: what the numbers of a contact or a bearing depend on.

`nonhertz.sweep` solves a case for many values of its inputs and returns a `Sweep`; `nonhertz.tolerance` finds
how its results are distributed when dimensions are, and returns a `Tolerance`.
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
from nonhertz.study.diagrams import Diagram as Diagram
from nonhertz.study.diagrams import diagram as diagram
from nonhertz.study.limits import Capability as Capability
from nonhertz.study.lives import damage as damage
from nonhertz.study.sweeps import Progress as Progress
from nonhertz.study.sweeps import Sweep as Sweep
from nonhertz.study.tolerances import Index as Index
from nonhertz.study.tolerances import Quantile as Quantile
from nonhertz.study.tolerances import Tolerance as Tolerance

__all__ = [
    "Capability", "Diagram", "Distribution", "Gradient", "HalfWidthAt", "Index", "Measure", "Partials", "PowerIntegral",
    "PressureAt", "PressureNorm", "Progress", "Quantile", "Sampling", "Sweep", "Tolerance", "damage", "diagram",
]  # fmt: skip
__dir__ = dir_of(__name__)
