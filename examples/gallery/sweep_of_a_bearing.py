"""
How much clearance, and how much tilt?
======================================

A sweep over inputs of a bearing file: the largest roller load and the life of NU 206 over its internal clearance and
the misalignment of its rings, by the slices of ISO/TS 16281.
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.studies import study_map
from nonhertz.plot.style import sheet_style

bearing = nh.bearing.CylindricalRollerBearing(
    roller=nh.Roller(
        diameter=9, length=10, corner_radius=0.3, profile=nh.profile.iso_logarithmic(diameter=9, length=9.4)
    ),
    inner=nh.Ring(diameter=37.5, depth=3.75),
    outer=nh.Ring(diameter=-55.5, depth=3.25),
    rollers=13,
    clearance=0.0184,
)
case = nh.BearingCase(bearing, {"radial": 11e3, "tilt": 0.5e-3}, {"method": "slices"}, title="NU 206 by slices")
found = nh.sweep(
    case,
    over={
        "bearing.clearance": "-10 um : 40 um : 11",
        "load.tilt": "0 : 1.5 mrad : 9",
    },
    quantities=("max_load", "reference_life"),
    workers=1,
)
print(found)

# %%
# A little preload makes the life longest; clearance shortens it, and so does misalignment.

life = found["reference_life"]
best = np.unravel_index(life.argmax(), life.shape)
print(f"longest at {1e3 * found['bearing.clearance'][best]:.0f} um and {1e3 * found['load.tilt'][best]:.1f} mrad")

with sheet_style():
    figure = Figure(figsize=(6.7, 2.9), layout="constrained")
    x, y = 1e3 * found["bearing.clearance"][:, 0], 1e3 * found["load.tilt"][0]
    labels = {"x_label": "Clearance [um]", "y_label": "Tilt [mrad]"}
    study_map(x, y, life.T, figure.add_subplot(1, 2, 1), label="L10r [million revolutions]", **labels)
    study_map(x, y, found["max_load"].T, figure.add_subplot(1, 2, 2), label="Largest load [N]", **labels)
