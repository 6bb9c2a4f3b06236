"""
What does a dent do to the pressure?
====================================

A hard particle has left a dent in the raceway, half a millimetre wide and 3 micrometres deep, with a shoulder of 0.4
micrometres. Its relief changes across the contact, so it needs a plane grid. Roller 20 x 20 mm on an inner ring of 80
mm, 20 kN.
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import COLOUR_MAP, FIRST, INK, SECOND, sheet_style

roller = nh.Roller(diameter=20, length=20, profile=nh.profile.iso_logarithmic(diameter=20, length=20))
contact = nh.Contact(roller, nh.Ring(diameter=80))
dent = nh.patch.Dent(x=0.0, y=3.0, depth=0.003, diameter=0.5, shoulder=0.0004, shoulder_diameter=1.0)

strips = nh.solve(contact, load=20e3)
dented = nh.patch.solve(contact, load=20e3, features=[dent], cells=(64, 1024))
print(f"maximum pressure: smooth {strips.max_pressure:.0f} MPa, dented {dented.max_pressure:.0f} MPa")

# %%
# The pressure around the dent
# ----------------------------
# In true proportions; the white circle is the rim of the bowl. The bowl carries less, and the rim and the shoulder
# carry what the bowl does not. The contact ends on cell edges, hence the steps.

with sheet_style():
    figure = Figure(figsize=(6.7, 2.6), layout="constrained")
    axes = figure.add_subplot()
    pressing = np.where(dented.footprint, dented.pressure, np.nan)
    field = axes.pcolormesh(dented.y, dented.x, pressing, cmap=COLOUR_MAP, vmin=0, shading="nearest", rasterized=True)
    axes.contour(dented.y, dented.x, dented.footprint.astype(float), levels=[0.5], colors=INK, linewidths=0.7)
    around = np.linspace(0, 2 * np.pi, 200)
    rim = 0.5 * dent.diameter
    axes.plot(dent.y + rim * np.cos(around), rim * np.sin(around), color="white", linestyle=":", linewidth=0.9)
    axes.set(xlabel="Axial position $y$ [mm]", ylabel="Across $x$ [mm]", xlim=(1.5, 4.5), aspect="equal")
    figure.colorbar(field, label="Pressure $p$ [MPa]", shrink=0.9)

# %%
# Along the line of contact
# -------------------------
# Away from the dent both methods agree: the markers are strips of the contact without a dent.

with sheet_style():
    figure = Figure(figsize=(6.7, 3.0), layout="constrained")
    axes = figure.add_subplot()
    axes.plot(dented.y, dented.centre_pressure, color=FIRST, label="dented, plane grid")
    axes.plot(strips.y, strips.centre_pressure, "o", color=SECOND, markersize=3, mfc="white", label="smooth, strips")
    axes.set(xlabel="Axial position $y$ [mm]", ylabel="Pressure on the centre line [MPa]", xlim=(-10, 10))
    axes.set_ylim(bottom=0)
    axes.legend(loc="lower center")
    axes.spines[["top", "right"]].set_visible(False)
