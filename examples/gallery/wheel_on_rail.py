"""
Wheel on rail: what does the cone angle do?
===========================================

The head of the 60E1 rail of EN 13674-1 has radii of 300 mm in the middle, 80 mm on either side and 13 mm at the
corners; only the first two are used here. A wheel of 920 mm with a conical tread touches it where the slopes are equal.
The steeper the cone relative to the head, the farther out that is; where both arcs carry load, the contact is not an
ellipse and no Hertz formula applies. Wheel load 100 kN.

The angle is measured from the tangent at the middle of the head. A rail is itself laid at an inclination of 1 in 40 or
1 in 20, which must be subtracted from the cone of the wheel. The corners, where flanges touch, are beyond this model:
the slopes there are no longer small, and the contact is many times wider than long.
"""

import warnings

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import BACKING, FAINT_INK, FIRST, SECOND, SMALL_SIZE, sheet_style

LOAD = 100e3
FLAT_ARC, STEEP_ARC, FLAT_WIDTH = 300.0, 80.0, 20.456  # mm, EN 13674-1, 60E1

rail = nh.Body(profile=nh.profile.two_radius(radius=FLAT_ARC, end_radius=STEEP_ARC, middle=FLAT_WIDTH))
wheel = nh.Body(diameter=920)
contact = nh.Contact(wheel, rail)

# The warnings say that the contact is wider than long; the end of the page gives the error.
warnings.simplefilter("ignore", nh.AccuracyWarning)

CONES = np.linspace(0.0, 0.1, 21)  # rad; new wheels have 1 in 40 to 1 in 20 against the axle
solutions = [nh.solve(contact, load=LOAD, tilt=cone) for cone in CONES]

# %%
# The pressure along the head of the rail
# ---------------------------------------
# Each line is one cone angle. As long as the contact stays on one arc it is Hertz's ellipse; across the junction of the
# arcs it has a shoulder on one side and a peak on the other.

shown = [solutions[number] for number in (0, 4, 6, 8, 12, 20)]
with sheet_style():
    figure = Figure(figsize=(6.7, 3.5), layout="constrained")
    axes = figure.add_subplot()
    for number, solution in enumerate(shown):
        share = number / (len(shown) - 1)
        colour = tuple(np.array(to_rgb(FIRST)) * (1 - share) + np.array(to_rgb(SECOND)) * share)
        here = np.convolve(solution.line_load > 0, [1, 1, 1], "same") > 0  # the contact and a strip beyond it
        axes.plot(solution.y[here], solution.centre_pressure[here], color=colour)
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
# The maximum pressure against the cone angle
# -------------------------------------------
# The dotted lines are Hertz's values for a wheel on one arc alone; only a method for arbitrary profiles can give the
# transition between them. All of these contacts are wider than long, for which strips are not intended. The squares are
# from a plane grid, which makes no assumption about the pressure across.
#
# The curve crosses Hertz's upper line and keeps rising. The tilt is modelled as a displacement proportional to y,
# without rotation, so an arc of radius R at the slope s counts as a level one of radius R / (1 + s^2)^1.5: 79 mm at 100
# mrad.

CHECKED = [0, 5, 6, 8, 10, 20]  # numbers of solutions
on_grid = [nh.patch.solve(contact, load=LOAD, tilt=CONES[number], cells=(64, 128)) for number in CHECKED]
for number, grid in zip(CHECKED, on_grid, strict=True):
    largest = solutions[number].max_pressure
    off = 100 * (largest / grid.max_pressure - 1)
    print(f"{1e3 * CONES[number]:4.0f} mrad: {largest:.0f} MPa, {off:+.2f} % from the plane grid")

hertz = {
    arc: nh.hertz.point_contact(load=LOAD, radius_x=460, radius_y=arc, compliance=contact.compliance)
    for arc in (FLAT_ARC, STEEP_ARC)
}
with sheet_style():
    figure = Figure(figsize=(6.7, 3.1), layout="constrained")
    axes = figure.add_subplot()
    for arc, exact in hertz.items():
        axes.axhline(exact.max_pressure, color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
        axes.annotate(f"Hertz, {arc:.0f} mm", (80, exact.max_pressure), xytext=(0, -4), textcoords="offset points",
                      ha="center", va="top", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    pressures = [solution.max_pressure for solution in solutions]
    axes.plot(1e3 * CONES, pressures, "o-", color=FIRST, markersize=3, label="strips")
    axes.plot(1e3 * CONES[CHECKED], [grid.max_pressure for grid in on_grid], "s", color=SECOND, markersize=6,
              mfc="none", label="plane grid")  # fmt: skip
    axes.set(xlabel="Cone angle against the head [mrad]", ylabel="Maximum pressure [MPa]", ylim=(1000, 2300))
    axes.legend(loc="lower right", bbox_to_anchor=(1, 0.25))
    axes.spines[["top", "right"]].set_visible(False)
