"""Any gap on a plane grid: uniform-pressure rectangles, the independent check of the strips.

The surface is cut into equal rectangles, each with a pressure of its own, and nothing is assumed of how the pressure
is distributed across the contact, whether it is symmetric, or in how many pieces the bodies touch: dents, waves and
slanted chamfers are as good as a crown. Nothing here comes from the strips, so both methods check each other.
"""

from nonhertz.patch.features import ChamferRun as ChamferRun
from nonhertz.patch.features import Dent as Dent
from nonhertz.patch.features import Waviness as Waviness
from nonhertz.patch.resources import memory as memory
from nonhertz.patch.solution import PatchSolution as PatchSolution
from nonhertz.patch.solver import solve as solve
from nonhertz.patch.surface import undeformed_gap as undeformed_gap
