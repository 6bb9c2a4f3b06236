"""
How does a spherical roller bearing respond to misalignment?
============================================================

It turns freely about the centre of its spherical outer raceway. A cylindrical roller bearing resists. Here both have a
bore of 30 mm, an outside diameter of 62 mm and a load of 8 kN; the rings are misaligned by up to 3 mrad. The
cylindrical one is an NU 206; the other has two rows of 15 barrels, an estimate of the usual size. Everything is solved
by strips.
"""

import math

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FIRST, INK, SECOND, sheet_style

LOAD = 8e3  # N
TILTS = 1e-3 * np.linspace(0, 3, 7)  # rad

DIAMETER, PITCH, ANGLE = 8.0, 46.5, math.radians(10)
SPHERE = 0.5 * PITCH / math.cos(ANGLE) + 0.5 * DIAMETER  # mm, the radius of the outer raceway
ACROSS = DIAMETER / math.cos(ANGLE)
BARRELS = nh.bearing.SphericalRollerBearing(
    roller=nh.Roller(diameter=DIAMETER, length=7.5),
    inner=nh.Ring(diameter=PITCH - ACROSS, depth=4.0),
    outer=nh.Ring(diameter=-(PITCH + ACROSS), depth=3.6),
    rollers=15,
    contact_angle=ANGLE,
    profile_radius=0.97 * SPHERE,
    inner_groove=SPHERE,
    outer_groove=SPHERE,
    clearance=0.0184,
)
BEARINGS = {
    # The lines of pressure of both rows meet in the middle of the sphere.
    "spherical": nh.bearing.paired(BARRELS, "X", PITCH * math.tan(ANGLE)),
    "cylindrical": nh.bearing.CylindricalRollerBearing(
        roller=nh.Roller(
            diameter=9, length=10, corner_radius=0.3, profile=nh.profile.iso_logarithmic(diameter=9, length=9.4)
        ),
        inner=nh.Ring(diameter=37.5, depth=3.75),
        outer=nh.Ring(diameter=-55.5, depth=3.25),
        rollers=13,
        clearance=0.0184,
    ),
}
STYLES = {"spherical": (FIRST, "-"), "cylindrical": (SECOND, "--")}

found = {
    name: [nh.bearing.solve(bearing, radial=LOAD, tilt=tilt) for tilt in TILTS] for name, bearing in BEARINGS.items()
}
for name, states in found.items():
    upright, tilted = states[0].load[:, 0], states[-1].load[:, 0]
    print(f"{name}: {upright.max():.0f} N on the most loaded roller;", end=" ")
    print(f"{1e3 * TILTS[-1]:.0f} mrad change the load of a roller by {np.abs(tilted - upright).max():.0f} N at most")

# %%
# Moment against misalignment
# ---------------------------
# The moment about the middle of the bearing, and the maximum pressure in it. In the cylindrical bearing the loads of
# the rollers hardly change either, but the pressure moves along them and grows with every milliradian.

with sheet_style():
    figure = Figure(figsize=(6.7, 3.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    for name, states in found.items():
        colour, dashes = STYLES[name]
        style = {"color": colour, "linestyle": dashes, "marker": "o", "markersize": 3, "mfc": "white", "label": name}
        left.plot(1e3 * TILTS, [1e-3 * each.force[4] for each in states], **style)
        right.plot(1e3 * TILTS, [each.max_pressure.max() for each in states], **style)
    left.set_ylabel("Moment on the inner ring [N m]")
    right.set_ylabel("Maximum pressure [MPa]")
    right.set_ylim(bottom=0)
    for axes in (left, right):
        axes.set(xlabel="Tilt between the rings [mrad]")
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(loc="upper left")

# %%
# Along the most loaded roller
# ----------------------------
# Pressure on the inner ring, aligned and tilted by 3 mrad. On the barrels it is Hertz's ellipse, and the two lines
# coincide.

with sheet_style():
    figure = Figure(figsize=(6.7, 3.0), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, (name, states) in zip(panels, found.items(), strict=True):
        for state, label, style in (
            (states[-1], "tilted", {"color": STYLES[name][0]}),
            (states[0], "upright", {"color": INK, "linestyle": ":"}),
        ):
            contact = state.contact(0, "inner")
            shown = np.convolve(contact.line_load > 0, [1, 1, 1], "same") > 0  # the contact and a strip beyond it
            axes.plot(contact.y[shown], contact.centre_pressure[shown], label=label, **style)
        axes.set(xlabel="Axial position $y$ [mm]", xlim=(-5.2, 5.2), ylim=(0, 2600))
        axes.set_title(name, loc="left")
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(loc="upper center")
    panels[0].set_ylabel("Pressure $p_0$ [MPa]")
