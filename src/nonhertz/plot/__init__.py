"""Drawings of a solution, for papers and reports.

Three functions take a solution and matplotlib axes, draw, and return the axes: `pressure` (pressure and
half-width along the contact), `footprint` (the contact area) and `profile` (the surfaces before and after
loading). `figures` makes one finished figure of each, `comparison` one of strips beside a plane grid, and `save` writes
a figure to SVG and PNG. Nothing here uses pyplot or leaves a setting changed, and matplotlib is imported only when
something is drawn.
"""

from nonhertz.plot.centre_line import pressure
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.sheets import figures, save
from nonhertz.plot.side_by_side import comparison
from nonhertz.plot.surfaces import profile

__all__ = ["comparison", "figures", "footprint", "pressure", "profile", "save"]
