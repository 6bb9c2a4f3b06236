"""
Crown or logarithm, when the roller tilts?
==========================================

A crown is easy to grind; a logarithmic profile spreads the load better. Which tolerates more misalignment? A roller of
15 x 15 mm on an inner ring of 60 mm under 12 kN, tilted by up to 2 mrad: straight, with a flat and a strong crown, and
with Lundberg's profile for exactly this load.
"""

import warnings

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, SMALL_SIZE, sheet_style

warnings.simplefilter("ignore", nh.AccuracyWarning)  # with two of the profiles sharp ends carry load, as we will see

DIAMETER = LENGTH = 15.0
RING = nh.Ring(diameter=60)
LOAD = 12e3
RADIUS = 1 / (2 / DIAMETER + 2 / 60)  # mm, combined

PROFILES = {
    "straight": nh.profile.straight(),
    "crown, radius 1.5 m": nh.profile.crown(radius=1500),
    "crown, radius 0.6 m": nh.profile.crown(radius=600),
    "Lundberg for 12 kN": nh.profile.lundberg(load=LOAD, length=LENGTH, radius=RADIUS),
}


def contact(profile):
    """Return the roller with a profile on the ring."""
    return nh.Contact(nh.Roller(diameter=DIAMETER, length=LENGTH, profile=profile), RING)


# %%
# Upright
# -------
# The pressure along the roller. The straight roller and the flat crown carry load on their sharp ends, where the
# pressure between elastic bodies is unbounded; their lines end with the last strip or leave the figure. Under
# Lundberg's profile it is even over nearly the whole length, close to Hertz's value for a line contact of this load and
# length (thin line).

hertz = nh.hertz.line_contact(
    line_load=LOAD / LENGTH, radius=RADIUS, compliance=contact(PROFILES["straight"]).compliance
)
upright = {name: nh.solve(contact(profile), load=LOAD) for name, profile in PROFILES.items()}
tilted = {name: nh.solve(contact(profile), load=LOAD, tilt=1e-3) for name, profile in PROFILES.items()}
STYLES = dict(zip(PROFILES, ((FAINT_INK, ":"), (INK, (0, (5, 2))), (SECOND, "--"), (FIRST, "-")), strict=True))


def along(solutions, title):
    """Return a drawing of pressures along the roller."""
    with sheet_style():
        figure = Figure(figsize=(6.7, 3.1), layout="constrained")
        axes = figure.add_subplot()
        for name, solution in solutions.items():
            colour, dashes = STYLES[name]
            shown = np.convolve(solution.line_load > 0, [1, 1, 1], "same") > 0  # the contact and a strip beyond it
            axes.plot(solution.y[shown], solution.centre_pressure[shown], color=colour, linestyle=dashes, label=name)
        axes.axhline(hertz.max_pressure, color=FAINT_INK, linewidth=0.7)
        axes.set(xlabel="Axial position $y$ [mm]", ylabel="Pressure $p_0$ [MPa]", xlim=(-8, 8), ylim=(0, 3600))
        axes.set_title(title, loc="left")
        axes.legend(loc="lower center", ncols=2)
        axes.spines[["top", "right"]].set_visible(False)
    return figure


figure = along(upright, "Upright")

# %%
# Tilted by 1 mrad
# ----------------
# The logarithmic profile drops off steeply near the ends and so relieves them; the flat crown digs in.

figure = along(tilted, "Tilted by 1 mrad")

# %%
# The maximum pressure against the tilt
# -------------------------------------
# Where an end carries load the pressure is singular: Lundberg's line stops at that tilt, and the straight roller
# and the flat crown have no line at all. Up to that tilt the logarithmic profile is better. The strong crown is hardly
# affected by tilt, but its pressure is high from the start.

TILTS = np.linspace(0.0, 2e-3, 11)
highest = {}
for name in ("crown, radius 0.6 m", "Lundberg for 12 kN"):
    solutions = nh.solve_many(contact(PROFILES[name]), load=LOAD, tilt=TILTS)
    highest[name] = np.where(solutions.singular, np.nan, solutions.max_pressure)

with sheet_style():
    figure = Figure(figsize=(6.7, 3.2), layout="constrained")
    axes = figure.add_subplot()
    for name, pressures in highest.items():
        colour, dashes = STYLES[name]
        axes.plot(1e3 * TILTS, pressures, color=colour, linestyle=dashes, marker="o", markersize=3, label=name)
    axes.axhline(hertz.max_pressure, color=FAINT_INK, linewidth=0.7)
    axes.annotate("Hertz, line contact", (2.0, hertz.max_pressure), xytext=(0, -3), textcoords="offset points",
                  ha="right", va="top", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    axes.set(xlabel="Tilt [mrad]", ylabel="Maximum pressure [MPa]", ylim=(2000, 3600))
    axes.legend(loc="upper left")
    axes.spines[["top", "right"]].set_visible(False)

# sphinx_gallery_thumbnail_number = 2
