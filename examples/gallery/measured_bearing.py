"""
How do measured profiles affect a bearing?
==========================================

ISO 16281 assumes a logarithmic profile; ground rollers differ. NU 206 under 10 kN with rollers of the
standard's profile, and with two rollers and a raceway as measured. All contacts are solved by strips.
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, sheet_style

LOAD = 10e3  # N
TILTS = {"upright": 0.0, "tilted by 1 mrad": 1e-3}

# %%
# The profiles
# ------------
# Rollers and the inner ring of bearings NU 206, measured by others: NU206-RE-1, NU206-RE-2 and NU206-IR-1 of
# github.com/moritzploss/tribology (MIT licence). ``nonhertz.measured.prepare`` levelled, centred, trimmed and smoothed
# them, as in the how-to page on measured profiles; these are some points of the results, between which a smooth curve
# is within 0.1 μm of all others. Both rollers are straight in the middle and drop by 10 μm and more towards the ends.
# The raceway is straight within the roughness.

OUTWARDS = np.array([0.5, 1, 1.5, 2, 2.5, 3, 3.25, 3.5, 3.75, 4, 4.15, 4.3, 4.4, 4.5, 4.6, 4.7])  # mm
Y_FIRST = np.concatenate([-OUTWARDS[::-1], [0], OUTWARDS])
FIRST_ROLLER = 1e-3 * np.array([
    10.98, 10.19, 9.38, 8.58, 7.82, 6.76, 5.82, 4.54, 3.56, 2.78, 2.08, 0.91, 0.36, 0.20, 0.07, 0.04, 0.02,
    0.00, 0.03, 0.08, 0.32, 0.79, 1.93, 2.74, 3.59, 4.69, 6.04, 6.94, 7.91, 8.63, 9.43, 10.32, 11.29,
])  # fmt: skip
Y_SECOND = Y_FIRST[2:-2]
SECOND_ROLLER = 1e-3 * np.array([
    15.88, 14.47, 13.21, 11.55, 10.09, 7.94, 5.99, 4.37, 3.09, 1.46, 0.62, 0.22, 0.08, 0.01, 0.00,
    0.12, 0.16, 0.27, 0.59, 1.60, 3.34, 4.56, 6.01, 7.73, 9.85, 11.33, 12.97, 14.24, 15.71,
])  # fmt: skip
Y_RACEWAY = np.linspace(-5.5, 5.5, 23)
RACEWAY = 1e-3 * np.array([
    0.11, 0.06, 0.01, 0.04, 0.03, 0.05, 0.08, 0.09, 0.14, 0.10, 0.16, 0.11,
    0.10, 0.08, 0.13, 0.09, 0.07, 0.06, 0.07, 0.01, 0.00, 0.00, 0.11,
])  # fmt: skip


def roller(profile, corner_radius):
    """Return a roller with a profile [mm] up to corners of a radius [mm]."""
    return nh.Roller(diameter=9, length=10, corner_radius=corner_radius, profile=profile)


def bearing(of, raceway):
    """Return the bearing with a roller, and a profile on its inner raceway."""
    return nh.bearing.CylindricalRollerBearing(
        roller=of,
        inner=nh.Ring(diameter=37.5, length=11, depth=3.75, profile=raceway),
        outer=nh.Ring(diameter=-55.5, depth=3.25),
        rollers=13,
        clearance=0.0184,
    )


# The corners begin where the lands end. Those of the second roller are larger.
ROLLERS = {
    "ISO 16281": roller(nh.profile.iso_logarithmic(diameter=9, length=9.4), 0.3),
    "first roller": roller(nh.profile.tabulated(Y_FIRST, FIRST_ROLLER), 0.3),
    "second roller": roller(nh.profile.tabulated(Y_SECOND, SECOND_ROLLER), 0.5),
}
STYLES = dict(zip(ROLLERS, ((INK, (0, (5, 2))), (FIRST, "-"), (SECOND, "--")), strict=True))
BEARINGS = {
    name: bearing(of, nh.profile.straight() if name == "ISO 16281" else nh.profile.tabulated(Y_RACEWAY, RACEWAY))
    for name, of in ROLLERS.items()
}

with sheet_style():
    figure = Figure(figsize=(6.7, 3.0), layout="constrained")
    axes = figure.add_subplot()
    for name, of in ROLLERS.items():
        colour, dashes = STYLES[name]
        y = np.linspace(-1, 1, 401) * (5.0 - of.corner_radius)
        axes.plot(y, 1e3 * of.profile.relief(y), color=colour, linestyle=dashes, label=name)
    axes.plot(Y_RACEWAY, 1e3 * RACEWAY, color=FAINT_INK, linestyle=":", label="inner raceway")
    axes.set(xlabel="Axial position $y$ [mm]", ylabel="Relief [μm]", xlim=(-5.2, 5.2), ylim=(17, -0.8))
    axes.legend(loc="lower center")
    axes.spines[["top", "right"]].set_visible(False)

# %%
# Pressures and lives
# -------------------
# All rollers of a bearing are assumed equal. The measured ones have a shorter straight part, so the pressure is higher
# and the life shorter. A misalignment of the rings causes no edge loading.
# L10r is that of the laminae of ISO/TS 16281 with these pressures.

found = {
    name: [nh.bearing.solve(each, radial=LOAD, tilt=tilt) for tilt in TILTS.values()] for name, each in BEARINGS.items()
}
for name, states in found.items():
    for words, state in zip(TILTS, states, strict=True):
        life = nh.bearing.assess(state).reference_life
        print(f"{name}, {words}: {state.load[0, 0]:.0f} N on the most loaded roller,", end=" ")
        print(f"{state.max_pressure[0, 0]:.0f} MPa on the inner ring; L10r {life:.0f} million revolutions")

with sheet_style():
    figure = Figure(figsize=(6.7, 3.2), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, words, number in zip(panels, TILTS, range(2), strict=True):
        for name, states in found.items():
            colour, dashes = STYLES[name]
            contact = states[number].contact(0, "inner")
            shown = np.convolve(contact.line_load > 0, [1, 1, 1], "same") > 0  # the contact and a strip beyond it
            axes.plot(contact.y[shown], contact.centre_pressure[shown], color=colour, linestyle=dashes, label=name)
        axes.set(xlabel="Axial position $y$ [mm]", xlim=(-5.2, 5.2))
        axes.set_title(words, loc="left")
        axes.spines[["top", "right"]].set_visible(False)
    panels[0].set_ylim(bottom=0)
    panels[0].set_ylabel("Pressure $p_0$ [MPa]")
    panels[0].legend(loc="lower center")

# sphinx_gallery_thumbnail_number = 2
