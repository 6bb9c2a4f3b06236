"""
Which loads and misalignments can a roller carry?
=================================================

Hundreds of cases in one call: maps of the maximum pressure and the tilting stiffness over load and tilt. The roller is
20 x 20 mm with a logarithmic profile, on a plate; both bodies continue as half-spaces beyond their ends, as in programs
for rough surfaces, with which one of the cases has been compared.
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import COLOUR_MAP, INK, SMALL_SIZE, sheet_style

profile = nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
roller = nh.Roller(diameter=20, length=20, profile=profile, side_faces="none", depth="none")
contact = nh.Contact(roller, nh.Plate())

LOADS = np.linspace(4e3, 40e3, 10)  # N
TILTS = np.linspace(-1.5e-3, 1.5e-3, 25)  # rad
many = nh.solve_many(contact, load=LOADS[:, None], tilt=TILTS)
print(many.max_pressure.shape, "all converged:", many.converged.all())
for number, load in enumerate(LOADS):
    case = many[number, TILTS.size // 2]
    print(
        f"upright, {1e-3 * load:2.0f} kN: {case.max_pressure:4.0f} MPa at y = {case.max_pressure_y:5.2f} mm,", end=" "
    )
    print(f"{case.max_pressure / load**0.5:.1f} times the root of the load")


def drawn(values, label, levels):
    """Return a map over tilt and load."""
    with sheet_style():
        figure = Figure(figsize=(6.7, 3.6), layout="constrained")
        axes = figure.add_subplot()
        field = axes.contourf(1e3 * TILTS, 1e-3 * LOADS, values, levels=levels, cmap=COLOUR_MAP)
        inks = ["white" if level < np.median(levels) else INK for level in levels]
        lines = axes.contour(1e3 * TILTS, 1e-3 * LOADS, values, levels=levels, colors=inks, linewidths=0.5)
        axes.clabel(lines, lines.levels[1::2], fontsize=SMALL_SIZE)
        axes.set(xlabel="Tilt [mrad]", ylabel="Load [kN]")
        figure.colorbar(field, label=label)
    return figure


# %%
# The maximum pressure
# --------------------
# When aligned it is in the middle and grows slightly more slowly than the square root of the load, as in a Hertz
# contact of fixed length: this contact also gets longer. Above about 30 kN the contact extends so far into the steep
# ends of the profile that the peaks are there, and the contours have a kink. A tilt does the same on one side.

figure = drawn(many.max_pressure, "Maximum pressure [MPa]", np.arange(800, 5601, 400))

# %%
# Tilting stiffness
# -----------------
# The derivative of the moment with respect to the tilt at fixed approach, for each case, for shaft
# calculations. Every solution has it, exact and without finite differences.

stiffness = many.stiffness[..., 1, 1]  # N mm / rad
figure = drawn(1e-6 * stiffness, "d moment / d tilt [N m / mrad]", np.arange(8, 45, 3))
