"""Stress below the surface of a solved contact.

Use `stress` for any points, `axial_plane` and `cross_section` for planes, `volume` for grids, `passage` for the stress
history of points while the load rolls over them, and `extremes` for the largest stresses and their positions. All of
them accept solutions by strips and on plane grids, and give stress in MPa, compressive stress negative, with z pointing
into the body.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.subsurface.evaluation import axial_plane as axial_plane
    from nonhertz.subsurface.evaluation import cross_section as cross_section
    from nonhertz.subsurface.evaluation import memory as memory
    from nonhertz.subsurface.evaluation import stress as stress
    from nonhertz.subsurface.evaluation import volume as volume
    from nonhertz.subsurface.field import Field as Field
    from nonhertz.subsurface.rolling import Passage as Passage
    from nonhertz.subsurface.rolling import passage as passage
    from nonhertz.subsurface.search import Extreme as Extreme
    from nonhertz.subsurface.search import Extremes as Extremes
    from nonhertz.subsurface.search import extremes as extremes

__getattr__, __dir__ = attach(
    __name__,
    {
        "evaluation": ("axial_plane", "cross_section", "memory", "stress", "volume"),
        "field": ("Field",),
        "rolling": ("Passage", "passage"),
        "search": ("Extreme", "Extremes", "extremes"),
    },
)
