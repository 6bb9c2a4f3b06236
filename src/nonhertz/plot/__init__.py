"""Drawings of a solution or a whole bearing, for papers and reports.

Functions that draw take a result and axes of matplotlib, ``ax``, on which they draw and which they return. Without axes
each makes a figure of its own, ``ax.figure``. For a solution they are `pressure` (pressure and half-width along the
contact), `footprint` (the contact area) and `profile` (the surfaces before and after loading); with what
`nonhertz.subsurface` found below the surface, `axial_stress` (a plane along the contact) and `section_stress` (a plane
across it); of lives, `life_density`; of a `nonhertz.bearing.BearingSolution`, `bearing_loads`, `bearing_pressure`,
`most_loaded_roller`, `roller_relief` and `displacement_against_load`. `draw` chooses by name, as the method ``plot`` of
both does.

Finished figures are made by `figures` of a solution or a bearing, `bearing_figures` of a bearing with maps,
`stress_figures`, `comparison` (strips beside a plane grid), `life_figure` (where the bodies fatigue), `dent_figure` (a
dent that is rolled over) and `measured_figure` (the steps of a measured profile); `save` writes one to SVG and PNG.
Nothing here uses pyplot or leaves a setting changed, and matplotlib is imported only when something is drawn.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.plot.bearing.displacement import displacement_against_load as displacement_against_load
    from nonhertz.plot.bearing.loads import bearing_loads as bearing_loads
    from nonhertz.plot.bearing.pressure import bearing_pressure as bearing_pressure
    from nonhertz.plot.bearing.roller import most_loaded_roller as most_loaded_roller
    from nonhertz.plot.bearing.roller import roller_relief as roller_relief
    from nonhertz.plot.centre_line import pressure as pressure
    from nonhertz.plot.centre_line import profile as profile
    from nonhertz.plot.contact_area import footprint as footprint
    from nonhertz.plot.fatigue import dent_figure as dent_figure
    from nonhertz.plot.fatigue import life_density as life_density
    from nonhertz.plot.fatigue import life_figure as life_figure
    from nonhertz.plot.finished import bearing_figures as bearing_figures
    from nonhertz.plot.finished import comparison as comparison
    from nonhertz.plot.finished import draw as draw
    from nonhertz.plot.finished import figures as figures
    from nonhertz.plot.measured import measured_figure as measured_figure
    from nonhertz.plot.sheets import save as save
    from nonhertz.plot.sheets import save_all as save_all
    from nonhertz.plot.subsurface import axial_stress as axial_stress
    from nonhertz.plot.subsurface import section_stress as section_stress
    from nonhertz.plot.subsurface import stress_figures as stress_figures
    from nonhertz.plot.subsurface import stress_planes as stress_planes

__getattr__, __dir__ = attach(
    __name__,
    {
        "bearing.displacement": ("displacement_against_load",),
        "bearing.loads": ("bearing_loads",),
        "bearing.pressure": ("bearing_pressure",),
        "bearing.roller": ("most_loaded_roller", "roller_relief"),
        "centre_line": ("pressure", "profile"),
        "contact_area": ("footprint",),
        "fatigue": ("dent_figure", "life_density", "life_figure"),
        "finished": ("bearing_figures", "comparison", "draw", "figures"),
        "measured": ("measured_figure",),
        "sheets": ("save", "save_all"),
        "subsurface": ("axial_stress", "section_stress", "stress_figures", "stress_planes"),
    },
)
