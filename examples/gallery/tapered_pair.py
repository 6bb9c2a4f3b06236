"""
How much preload does a pair of tapered rollers need?
=====================================================

Two rows of HR30306J back to back (O), 20 mm apart, hold a shaft under 10 kN radially and 1.5 kN axially. Thrust
relieves one of the rows; preload keeps it loaded and makes the bearing stiff, until it costs life. Here the axial
clearance of the pair goes from 20 μm of play to 60 μm of preload. Everything is solved by strips.
"""

import math

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FAINT_INK, FIRST, INK, PALE, SECOND, SMALL_SIZE, sheet_style

RADIAL, AXIAL = 10e3, 1.5e3  # N
ANGLE = math.radians(11.859)  # of the outer raceways
PRELOADS = 1e-3 * np.linspace(-20, 60, 9)  # mm
ROW = nh.bearing.TaperedRollerBearing(
    roller=nh.Roller(
        diameter=nh.TabulatedDiameter((-5.825, 5.825), (10.9371, 10.123273)),
        length=11.65,
        corner_radius=0.3,
        profile=nh.profile.crown(radius=1500),
    ),
    inner=nh.Ring(diameter=40.80017, depth=5.0),
    outer=nh.Ring(diameter=-62.31983, depth=4.5),
    rollers=14,
    contact_angle=ANGLE,
    rib=nh.bearing.Rib(145.0, 4.7),
)


def pair(preload):
    """Return both rows with a preload [mm]; negative is play."""
    return nh.bearing.paired(ROW, "O", 20, clearance=-preload)


states = [nh.bearing.solve(pair(preload), radial=RADIAL, axial=AXIAL) for preload in PRELOADS]


def thrusts(state):
    """Return the axial load of both rows [N], seen at the outer rings, which have no ribs."""
    rows = state.load[state.rollers_of(0), 1], state.load[state.rollers_of(1), 1]
    return np.array([math.sin(ANGLE) * loads.sum() for loads in rows])


def plain(xlabel, ylabel):
    """Return a figure and its axes."""
    figure = Figure(figsize=(6.7, 3.2), layout="constrained")
    axes = figure.add_subplot()
    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def over_preload(ylabel):
    """Return a figure and its axes, on which play is shaded."""
    figure, axes = plain("Preload [μm]", ylabel)
    axes.axvspan(1e3 * PRELOADS[0], 0, color=PALE, linewidth=0)
    axes.annotate("play", (0, 0), xycoords=("data", "axes fraction"), xytext=(-4, 4), textcoords="offset points",
                  ha="right", fontsize=SMALL_SIZE, color=FAINT_INK)  # fmt: skip
    axes.set_xlim(1e3 * PRELOADS[[0, -1]])
    return figure, axes


# %%
# Axial load of each row
# ----------------------
# A tapered row under radial load pushes its rings apart along the axis. Both rows therefore carry thrust, and the
# difference is that of the shaft. Without preload half of the rollers are unloaded.

rows = np.array([thrusts(state) for state in states])
loaded = np.array([state.loaded_share for state in states])
for preload, both, shares in zip(PRELOADS, rows, 14 * loaded, strict=True):
    print(f"preload {1e3 * preload:3.0f} um: {both[0]:4.0f} and {both[1]:4.0f} N,", end=" ")
    print(f"{shares[0]:.0f} and {shares[1]:.0f} of 14 rollers loaded")

with sheet_style():
    figure, axes = over_preload("Thrust on the row [kN]")
    for k, (name, colour, dashes) in enumerate(
        (("row that carries the thrust", FIRST, "-"), ("other row", SECOND, "--"))
    ):
        axes.plot(
            1e3 * PRELOADS, 1e-3 * rows[:, k], color=colour, linestyle=dashes, marker="o", markersize=3, label=name
        )
    axes.set_ylim(0, 3)
    axes.legend(loc="upper left", ncols=2)

# %%
# Stiffness and life
# ------------------
# Stiffness against each motion of the shaft, and L10r by the laminae of ISO/TS 16281 with the solved pressures,
# relative to those without preload. Kinks are where another roller becomes loaded; above 50 μm of preload the
# whole first row is. Radial and tilting stiffness grow equally.

KINDS = {
    "axial": (0, FIRST, "-"),
    "radial, along the load": (1, SECOND, "--"),
    "against tilt in its plane": (4, INK, ":"),
}
stiffness = np.array([np.diag(state.stiffness) for state in states])
lives = np.array([nh.bearing.assess(state).reference_life for state in states])
unloaded = int(np.argmin(np.abs(PRELOADS)))

with sheet_style():
    figure, axes = over_preload("Relative to that without preload")
    for name, (motion, colour, dashes) in KINDS.items():
        relative = stiffness[:, motion] / stiffness[unloaded, motion]
        axes.plot(1e3 * PRELOADS, relative, color=colour, linestyle=dashes, label=f"stiffness, {name}")
    axes.plot(1e3 * PRELOADS, lives / lives[unloaded], color=FAINT_INK, marker="o", markersize=3, label="life L10r")
    axes.legend(loc="upper left")
print(f"longest life at {1e3 * PRELOADS[lives.argmax()]:.0f} um")

# %%
# Thrust that unloads the second row
# ----------------------------------
# Without radial load, and with 20 μm of preload. The bearing is as stiff as two rows until the second one lifts off.
# Then the other one has twice the approach, and carries 2^n times the preload. For line contacts that is 2.16,
# n being 10/9; rollers with a crown touch on ellipses as long as loads are light, with Hertz's n = 3/2 and 2.83. Here
# it is a little more, since the rings are thin: they yield as the load, which reduces Hertz's approach.

TAKEN = 0.02  # mm
at_rest = nh.bearing.solve(pair(TAKEN), axial=0.0)
preload = thrusts(at_rest)[0]
let_go = nh.bearing.solve(pair(TAKEN), axial_displacement=0.5 * TAKEN).force[0]
shaft = np.array([0, 0.25, 0.5, 0.75, 1, 1.4]) * let_go
pushed = np.array([thrusts(nh.bearing.solve(pair(TAKEN), axial=axial)) for axial in shaft])
print(f"preload {preload:.0f} N; the second row lets go at {let_go:.0f} N, {let_go / preload:.2f} times that")

with sheet_style():
    figure, axes = plain("Thrust on the shaft [kN]", "Thrust on the row [kN]")
    axes.plot(1e-3 * shaft, 1e-3 * pushed[:, 0], color=FIRST, marker="o", markersize=3, label="row that carries it")
    axes.plot(
        1e-3 * shaft, 1e-3 * pushed[:, 1], color=SECOND, linestyle="--", marker="o", markersize=3, label="other row"
    )
    axes.plot(1e-3 * shaft, 1e-3 * shaft, color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
    axes.axvline(1e-3 * let_go, color=FAINT_INK, linewidth=0.7)
    axes.annotate("lets go", (1e-3 * let_go, 0), xytext=(4, 14), textcoords="offset points", fontsize=SMALL_SIZE,
                  color=FAINT_INK)  # fmt: skip
    axes.set(xlim=(0, None), ylim=(0, None))
    axes.legend(loc="upper left")
