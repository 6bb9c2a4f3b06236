r"""
What can be said about a sharp end?
===================================

A straight roller ends on a longer ring. At its edge the pressure between elastic bodies is unbounded: it grows
as :math:`p = K s^{-\alpha}` towards the edge, and a maximum printed there only reflects the mesh size. The exponent and
the strength K converge. Straight roller 20 x 20 mm on a ring of 80 mm, 20 kN.
"""

import warnings

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, sheet_style

RING = nh.Ring(diameter=80)
warnings.simplefilter("ignore", nh.AccuracyWarning)  # they are what this page is about


def solved(side_faces, strips="auto"):
    """Return the straight roller on the ring."""
    roller = nh.Roller(diameter=20, length=20, side_faces=side_faces)
    return nh.solve(nh.Contact(roller, RING), load=20e3, strips=strips)


mirrored, half_spaces = solved("mirror"), solved("none")
for name, solution in {"roller's end freed of shear": mirrored, "half-spaces": half_spaces}.items():
    edge = solution.edge_pressure[1]
    print(f"{name:28} exponent {edge.exponent:.4f}   K = {edge.strength:.1f} MPa mm^{edge.exponent:.3f}")

# %%
# The maximum is the mesh
# -----------------------
# Strips that widen by a fifth from both ends inwards, with an ever narrower first strip. The pressure of the last strip
# rises without bound. K, computed from the strips near the end, does not change.


def graded(narrowest):
    """Return edges of strips [mm] that grow from the ends inwards."""
    widths = [narrowest]
    while sum(widths) < 10:
        widths.append(min(1.2 * widths[-1], 1.0))
    inwards = np.cumsum(widths) * 10 / sum(widths)
    return np.concatenate([[-10.0], inwards - 10, 10 - inwards[-2::-1], [10.0]])


WIDTHS = np.geomspace(0.001, 0.018, 9)  # mm
refined = [solved("mirror", graded(width)) for width in WIDTHS]
last = [solution.centre_pressure[-1] for solution in refined]
strengths = [solution.edge_pressure[1].strength for solution in refined]

with sheet_style():
    figure = Figure(figsize=(6.7, 2.9), layout="constrained")
    left, right = figure.subplots(1, 2)
    left.semilogx(1e3 * WIDTHS, last, "o-", color=FIRST, mfc="white")
    left.set(ylabel="Pressure of the last strip [MPa]", ylim=(0, 16000))
    right.semilogx(1e3 * WIDTHS, strengths, "s-", color=SECOND, mfc="white")
    right.set(ylabel="Strength $K$ [MPa mm$^{1/3}$]", ylim=(0, 1100))
    for axes in (left, right):
        axes.set_xlabel("Width of the narrowest strip [μm]")
        axes.set_xticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
        axes.minorticks_off()
        axes.spines[["top", "right"]].set_visible(False)

# %%
# Closer and closer to the edge
# -----------------------------
# On logarithmic axes a power law is a straight line. With the roller's end freed of shear and the ring continuing, the
# exponent is 1/3; as half-spaces, which is how many programs model the roller, it would be 1/2. The thin lines are K
# and the exponent alone; the thick ones include the next term and are valid up to half a half-width (grey beyond). The
# strip at the very end, the first marker of each, represents its whole width and lies off the line.

distance = np.geomspace(1e-3, 2.0, 200)
with sheet_style():
    figure = Figure(figsize=(6.7, 3.6), layout="constrained")
    axes = figure.add_subplot()
    half_width = mirrored.half_width[mirrored.strips // 2]
    axes.axvspan(0.5 * half_width, 2.0, color=FAINT_INK, alpha=0.12, linewidth=0)
    for solution, name, colour in ((mirrored, "end freed of shear", FIRST), (half_spaces, "half-spaces", SECOND)):
        edge = solution.edge_pressure[1]
        near = distance[distance < 0.5 * half_width]
        axes.loglog(10 - solution.y, solution.centre_pressure, "o", color=colour, markersize=3, mfc="white", label=name)
        axes.loglog(near, edge.at(near), color=colour)
        axes.loglog(distance, edge.strength * distance**-edge.exponent, color=colour, linewidth=0.6, linestyle="--")
        axes.annotate(rf"$s^{{-{edge.exponent:.3g}}}$", (1.5e-3, edge.at(1.5e-3)), xytext=(4, 4),
                      textcoords="offset points", color=colour)  # fmt: skip
    axes.set(xlim=(1e-3, 2), ylim=(700, 4e4), xlabel="Distance from the end $s$ [mm]", ylabel="Pressure $p_0$ [MPa]")
    axes.set_yticks([1000, 2000, 5000, 10000, 20000], ["1000", "2000", "5000", "10 000", "20 000"])
    axes.minorticks_off()
    axes.tick_params(colors=INK)
    axes.legend(loc="upper right")
    axes.spines[["top", "right"]].set_visible(False)

# sphinx_gallery_thumbnail_number = 2
