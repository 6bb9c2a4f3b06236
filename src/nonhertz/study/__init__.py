"""Studies of a contact: what its numbers depend on.

`nonhertz.Solution.gradient` makes a `Gradient` of a named number of a solution, or of one of these: `PressureAt`,
`HalfWidthAt`, `PressureNorm`, `PowerIntegral`, or `damage` by a model of fatigue.
"""

from nonhertz.result.gradient import Gradient as Gradient
from nonhertz.result.measures import HalfWidthAt as HalfWidthAt
from nonhertz.result.measures import Measure as Measure
from nonhertz.result.measures import Partials as Partials
from nonhertz.result.measures import PowerIntegral as PowerIntegral
from nonhertz.result.measures import PressureAt as PressureAt
from nonhertz.result.measures import PressureNorm as PressureNorm
from nonhertz.study.lives import damage as damage

__all__ = ["Gradient", "HalfWidthAt", "Measure", "Partials", "PowerIntegral", "PressureAt", "PressureNorm", "damage"]
