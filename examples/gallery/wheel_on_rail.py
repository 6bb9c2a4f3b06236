"""
Wheel on rail: what does the cone angle do?
===========================================

The head of a rail is rounded by 300 mm in the middle and by 80 mm towards its shoulders, as that of the rail 60E1 in
EN 13674-1. A wheel of 920 mm, conical where it runs, touches it where the slopes are equal. The steeper the cone, the
farther out that is; where both arcs bear, the contact is no ellipse and no formula of Hertz fits. Wheel load 100 kN.
"""

import warnings

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, SECOND, SMALL_SIZE, sheet_style

LOAD = 100e3
FLAT_ARC, STEEP_ARC, FLAT_WIDTH = 300.0, 80.0, 20.5  # mm

rail = nh.Body(profile=nh.profile.two_radius(radius=FLAT_ARC, end_radius=STEEP_ARC, middle=FLAT_WIDTH))
wheel = nh.Body(diameter=920)
contact = nh.Contact(wheel, rail)

# Where the small arc bears, the contact is wider than long, which strips are not meant for; see the end of the page.
warnings.simplefilter("ignore", nh.AccuracyWarning)

CONES = np.linspace(0.0, 0.1, 21)  # rad; new wheels have 0.025 to 0.05
solutions = [nh.solve(contact, load=LOAD, tilt=cone) for cone in CONES]

# %%
# The pressure along the head of the rail
# ---------------------------------------
# Each line is one cone angle. As long as the contact stays on one arc it is Hertz's ellipse; over the joint of both
# arcs it has a shoulder on one side and a peak on the other.

shown = [solutions[number] for number in (0, 4, 6, 8, 12, 20)]
with sheet_style():
    figure = Figure(figsize=(6.7, 3.5), layout="constrained")
    axes = figure.add_subplot()
    for number, solution in enumerate(shown):
        share = number / (len(shown) - 1)
        colour = tuple(np.array(to_rgb(FIRST)) * (1 - share) + np.array(to_rgb(SECOND)) * share)
        here = np.convolve(solution.line_load > 0, [1, 1, 1], "same") > 0  # the contact and a strip beyond it
        axes.plot(solution.y[here], solution.peak_pressure[here], color=colour)
        top = (solution.max_pressure_y, solution.max_pressure)
        axes.annotate(f"{1e3 * solution.tilt:.0f} mrad", top, xytext=(2, 3), textcoords="offset points",
                      fontsize=SMALL_SIZE, color=colour, bbox=BACKING)  # fmt: skip
    axes.axvline(0.5 * FLAT_WIDTH, color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
    axes.annotate("joint of the arcs", (0.5 * FLAT_WIDTH, 0.95), xycoords=axes.get_xaxis_transform(), xytext=(-4, 0),
                  textcoords="offset points", ha="right", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    axes.set(xlabel="Position on the head of the rail $y$ [mm]", ylabel="Pressure $p_0$ [MPa]")
    axes.set(xlim=(-6, 20), ylim=(0, 2300))
    axes.spines[["top", "right"]].set_visible(False)

# %%
# The largest pressure against the cone angle
# -------------------------------------------
# On the dotted lines is Hertz, for a wheel on one arc alone. The way from one to the other is what only a method for
# any profile can tell. Both contacts are wider than long, and strips should be long against their width in sum; Hertz
# tells what that costs.

hertz = {
    arc: nh.hertz.point_contact(load=LOAD, radius_x=460, radius_y=arc, compliance=contact.compliance)
    for arc in (FLAT_ARC, STEEP_ARC)
}
for arc, solution in zip(hertz, (solutions[0], solutions[-1]), strict=True):
    excess = solution.max_pressure / hertz[arc].max_pressure - 1
    print(f"on the arc of {arc:.0f} mm: {solution.max_pressure:.0f} MPa, {100 * excess:+.2f} % against Hertz")

with sheet_style():
    figure = Figure(figsize=(6.7, 3.1), layout="constrained")
    axes = figure.add_subplot()
    for arc, exact in hertz.items():
        axes.axhline(exact.max_pressure, color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
        axes.annotate(f"Hertz, {arc:.0f} mm", (50, exact.max_pressure), xytext=(0, 3), textcoords="offset points",
                      ha="center", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    axes.plot(1e3 * CONES, [solution.max_pressure for solution in solutions], "o-", color=FIRST, markersize=3)
    axes.set(xlabel="Cone angle [mrad]", ylabel="Largest pressure [MPa]", ylim=(1000, 2300))
    axes.spines[["top", "right"]].set_visible(False)
