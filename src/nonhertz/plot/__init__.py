"""Drawings of a solution or a whole bearing, for papers and reports.

Three functions take a solution and matplotlib axes, draw, and return the axes: `pressure` (pressure and
half-width along the contact), `footprint` (the contact area) and `profile` (the surfaces before and after
loading). Two more take what `nonhertz.subsurface` found below the surface as well: `axial_stress` (a plane along the
contact) and `section_stress` (a plane across it). `figures` makes one finished figure of each of the first three,
`stress_figures` of the other two, `comparison` one of strips beside a plane grid, `life_figure` one of where the bodies
fatigue (which `life_density` draws), `dent_figure` one of a dent that is rolled over,
`measured_figure` one of the steps of a measured profile, and `save` writes a
figure to SVG and PNG. Of bearings, `bearing_loads`, `bearing_pressure`, `most_loaded_roller`, `roller_relief` and
`displacement_against_load` take a `nonhertz.bearing.BearingSolution` and axes, and `bearing_figures` makes finished
figures. Nothing here uses pyplot or leaves a setting changed, and matplotlib is imported only when something is drawn.
"""

from nonhertz.plot.bearing.displacement import displacement_against_load
from nonhertz.plot.bearing.loads import bearing_loads
from nonhertz.plot.bearing.pressure import bearing_pressure
from nonhertz.plot.bearing.roller import most_loaded_roller, roller_relief
from nonhertz.plot.bearing.sheets import bearing_figures
from nonhertz.plot.centre_line import pressure
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.fatigue import dent_figure, life_density, life_figure
from nonhertz.plot.measured import measured_figure
from nonhertz.plot.sheets import figures, save
from nonhertz.plot.side_by_side import comparison
from nonhertz.plot.subsurface import axial_stress, section_stress, stress_figures, stress_planes
from nonhertz.plot.surfaces import profile

__all__ = [
    "axial_stress",
    "bearing_figures",
    "bearing_loads",
    "bearing_pressure",
    "comparison",
    "dent_figure",
    "displacement_against_load",
    "figures",
    "footprint",
    "life_density",
    "life_figure",
    "measured_figure",
    "most_loaded_roller",
    "pressure",
    "profile",
    "roller_relief",
    "save",
    "section_stress",
    "stress_figures",
    "stress_planes",
]
