"""
How much should a profile drop off?
===================================

Too little, and misalignment overloads the ends; too much, and the middle carries everything. The drop of a logarithmic
profile is proportional to its design load (Johns and Gohar). Which drop makes the ring under a misaligned
roller last longest? Roller 12.7 x 12.7 mm on an inner ring of 50 mm, 10 kN.
"""

import warnings

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, SMALL_SIZE, sheet_style

DIAMETER = LENGTH = 12.7  # mm
RING = nh.Ring(diameter=50)
RADIUS = 1 / (2 / DIAMETER + 2 / 50)  # mm, combined
LOAD = 10e3  # N
TILTS = {"upright": 0.0, "0.5 mrad": 0.5e-3, "1 mrad": 1e-3, "1.5 mrad": 1.5e-3}
warnings.simplefilter("ignore", nh.AccuracyWarning)  # small drops load the ends, which is what we want to see


def solved(profile, tilt):
    """Return the roller with a profile on the ring."""
    roller = nh.Roller(diameter=DIAMETER, length=LENGTH, profile=profile)
    return nh.solve(nh.Contact(roller, RING), load=LOAD, tilt=tilt, strips=61)


def life(profile, tilt, model):
    """Return the life of the ring over that under Hertz's even pressure."""
    (found,) = nh.life.assess(solved(profile, tilt), model, body="b")
    return found


# %%
# Life against drop
# -----------------
# By the laminae of ISO/TS 16281, which cost next to nothing. An aligned roller needs little drop; the optimum (circles)
# grows with the misalignment. The profile designed for the load itself (dotted) is a good choice up to
# about 1 mrad.

DESIGN_LOADS = LOAD * np.geomspace(0.15, 5, 29)
profiles = [nh.profile.johns_gohar(load=load, length=LENGTH, radius=RADIUS) for load in DESIGN_LOADS]
drops = np.array([1e3 * float(profile.relief(0.5 * LENGTH)) for profile in profiles])  # um
lives = {
    name: np.array([life(profile, tilt, "iso-16281").relative_life for profile in profiles])
    for name, tilt in TILTS.items()
}
designed = nh.profile.johns_gohar(load=LOAD, length=LENGTH, radius=RADIUS)

with sheet_style():
    figure = Figure(figsize=(6.7, 3.5), layout="constrained")
    axes = figure.add_subplot()
    for (name, found), colour, dashes in zip(
        lives.items(), (FAINT_INK, INK, SECOND, FIRST), (":", (0, (5, 2)), "--", "-"), strict=True
    ):
        axes.plot(drops, found, color=colour, linestyle=dashes, label=name)
        best = int(found.argmax())
        axes.plot(drops[best], found[best], "o", color=colour, markersize=4, mfc="white")
    axes.axvline(1e3 * float(designed.relief(0.5 * LENGTH)), color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
    axes.annotate("designed for the load", (1e3 * float(designed.relief(0.5 * LENGTH)), 0.03), xytext=(4, 0),
                  textcoords="offset points", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    axes.set(xlabel="Drop at the ends of the roller [μm]", ylabel="Life / life under even pressure", ylim=(0, 1.1))
    axes.set(xlim=(0, drops[-1]))
    axes.legend(loc="lower right", ncols=2)
    axes.spines[["top", "right"]].set_visible(False)

# %%
# Where the ring fatigues
# -----------------------
# Damage per length at 1 mrad, relative to that under the even pressure, by Lundberg and Palmgren from the subsurface
# stress: with the profile designed for the load, and with one designed for twice the load.

found = {
    "designed for 10 kN": life(designed, 1e-3, "lundberg-palmgren"),
    "designed for 20 kN": life(
        nh.profile.johns_gohar(load=2 * LOAD, length=LENGTH, radius=RADIUS), 1e-3, "lundberg-palmgren"
    ),
}
with sheet_style():
    figure = Figure(figsize=(6.7, 3.0), layout="constrained")
    axes = figure.add_subplot()
    for (name, each), colour, dashes in zip(found.items(), (FIRST, SECOND), ("-", "--"), strict=True):
        axes.plot(each.y, each.density, color=colour, linestyle=dashes, label=f"{name}: life {each.relative_life:.2f}")
    axes.axhline(1, color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
    axes.set(xlabel="Axial position $y$ [mm]", ylabel="Damage / even damage", xlim=(-6.4, 6.4))
    axes.set_ylim(bottom=0)
    axes.legend(loc="upper left")
    axes.spines[["top", "right"]].set_visible(False)
