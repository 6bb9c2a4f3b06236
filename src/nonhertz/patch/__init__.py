"""Contacts with any gap, on a plane grid of rectangles with uniform pressure: an independent check of the strips.

The surface is divided into equal rectangles, each with its own pressure, and nothing is assumed about how the pressure
is distributed across the contact, whether it is symmetric, or how many separate contacts there are: dents, waves and
slanted chamfers are treated just like a crown. Nothing here comes from the strips, so the two methods check each other.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.patch.features import ChamferRun as ChamferRun
    from nonhertz.patch.features import Dent as Dent
    from nonhertz.patch.features import Waviness as Waviness
    from nonhertz.patch.resources import memory as memory
    from nonhertz.patch.solution import PatchSolution as PatchSolution
    from nonhertz.patch.solver import solve as solve
    from nonhertz.patch.surface import undeformed_gap as undeformed_gap

__getattr__, __dir__ = attach(
    __name__,
    {
        "features": ("ChamferRun", "Dent", "Waviness"),
        "resources": ("memory",),
        "solution": ("PatchSolution",),
        "solver": ("solve",),
        "surface": ("undeformed_gap",),
    },
)
