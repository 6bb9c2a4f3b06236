"""
How exact is an elliptical contact?
===================================

Where bodies are curved both ways, Hertz has the answer. Strips do not use it: length, width and
load distribution of the contact are solved for. A roller of 20 mm with a crown of 100 mm on a plate, 1000 N.
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot import figures
from nonhertz.plot.style import FIRST, INK, SECOND, sheet_style

ball = nh.Body(diameter=20, profile=nh.profile.crown(radius=100))
contact = nh.Contact(ball, nh.Plate())
solution = nh.solve(contact, load=1000)
hertz = nh.hertz.point_contact(load=1000, radius_x=10, radius_y=100, compliance=contact.compliance)

for quantity in ("approach", "max_pressure"):
    found, exact = getattr(solution, quantity), getattr(hertz, quantity)
    print(f"{quantity:14}{found:14.6f}  Hertz {exact:14.6f}  off by {1e6 * (found / exact - 1):6.1f} ppm")

# %%
# The footprint, in true proportions.

figure = figures(solution, "Roller 20 mm, crown 100 mm, on a plate")["footprint"]

# %%
# Pressure and half-width along the contact: Hertz as lines, the strips as markers.

y = np.linspace(-1.05, 1.05, 401) * hertz.half_length
with sheet_style():
    figure = Figure(figsize=(6.7, 3.3), layout="constrained")
    axes = figure.add_subplot()
    right = axes.twinx()
    axes.plot(y, hertz.pressure(y), color=FIRST, linewidth=1.0, label="pressure, Hertz")
    axes.plot(solution.y, solution.centre_pressure, "o", color=FIRST, markersize=3.2, mfc="white", label="strips")
    right.plot(y, hertz.half_width_at(y), color=SECOND, linestyle="--", linewidth=1.0, label="half-width, Hertz")
    right.plot(solution.y, solution.half_width, "s", color=SECOND, markersize=2.8, mfc="white", label="strips")
    axes.set(xlabel="Axial position $y$ [mm]", xlim=(y[0], y[-1]), ylim=(0, 2100))
    axes.set_ylabel("Pressure $p_0$ [MPa]", color=FIRST)
    right.set_ylabel("Half-width $b$ [mm]", color=SECOND)
    right.set_ylim(0, 0.42)
    axes.legend(loc="upper left", ncols=2)
    right.legend(loc="upper right", ncols=2)
    for each in (axes, right):
        each.spines["top"].set_visible(False)

# %%
# How accurate strips are
# -----------------------
# With more strips the error falls, though not at every step. The square is the automatic grid.

counts = np.array([11, 15, 21, 31, 41, 61, 81, 121, 161])
edges = [np.linspace(-1.3, 1.3, count + 1) * hertz.half_length for count in counts]
approaches = np.array([nh.solve(contact, load=1000, strips=each).approach for each in edges])
with sheet_style():
    figure = Figure(figsize=(6.7, 3.0), layout="constrained")
    axes = figure.add_subplot()
    axes.loglog(
        counts, 1e6 * np.abs(approaches / hertz.approach - 1), "o-", color=FIRST, mfc="white", label="equal strips"
    )
    axes.loglog(
        solution.strips, 1e6 * abs(solution.approach / hertz.approach - 1), "s", color=INK, label="automatic grid"
    )
    axes.set(xlabel="Strips", ylabel="Error of the approach [ppm]")
    axes.set_xticks([10, 20, 40, 80, 160], ["10", "20", "40", "80", "160"])
    axes.xaxis.set_minor_locator(axes.xaxis.get_major_locator())
    axes.legend(loc="lower left")
    axes.spines[["top", "right"]].set_visible(False)

# sphinx_gallery_thumbnail_number = 2
