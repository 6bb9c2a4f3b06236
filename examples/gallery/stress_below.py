"""
Where is a misaligned roller contact stressed most?
===================================================

Fatigue begins below the surface. A roller of 15 x 15 mm with the profile of ISO 16281 on an inner ring, 12 kN, tilted
by 1 mrad: where is the largest von Mises stress in the ring, and how much larger is it than under an aligned roller?
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot import stress_figures
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND, sheet_style

roller = nh.Roller(diameter=15, length=15, profile=nh.profile.iso_logarithmic(diameter=15, length=15))
contact = nh.Contact(roller, nh.Ring(diameter=60))
upright = nh.solve(contact, load=12e3)
tilted = nh.solve(contact, load=12e3, tilt=1e-3)

largest = nh.subsurface.extremes(tilted, body="b")  # body b is the ring
for name, worst in {
    "upright": nh.subsurface.extremes(upright, body="b").von_mises,
    "tilted": largest.von_mises,
}.items():
    print(f"{name:8}{worst.max:.0f} MPa at y = {worst.y:.2f} mm, {1e3 * worst.z:.0f} um below the surface")

# %%
# In the ring, along the contact
# ------------------------------
# The plane under the line of contact, and the cross-section in which the largest stress lies.

section = nh.subsurface.extremes(tilted, largest.von_mises.y, body="b")
figures = stress_figures(tilted, largest, section, "Ring under a roller tilted by 1 mrad")
figure = figures["axial-plane"]

# %%

figure = figures["cross-section"]

# %%
# Down from the surface
# ---------------------
# Under the middle of the upright roller the stress is that below a Hertz line contact: the maximum shear stress is 0.30
# of the pressure, 0.78 half-widths deep (K. L. Johnson, Contact Mechanics, 1985, section 4.2). The dotted line marks
# the depth found here.

depths = np.linspace(0, 2.5, 101)
middle = int(np.argmin(np.abs(upright.y)))
pressure, half_width = upright.centre_pressure[middle], upright.half_width[middle]
below = nh.subsurface.stress(upright, 0.0, upright.y[middle], depths * half_width, body="b")
deepest = int(np.argmax(below.max_shear))
print(
    f"maximum shear {below.max_shear[deepest] / pressure:.3f} of the pressure, {depths[deepest]:.3f} half-widths deep"
)

with sheet_style():
    figure = Figure(figsize=(6.7, 3.4), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    left.plot(below.sigma_x / pressure, depths, color=FIRST, label=r"$\sigma_x$, across")
    left.plot(below.sigma_y / pressure, depths, color=SECOND, linestyle="--", label=r"$\sigma_y$, along")
    left.plot(below.sigma_z / pressure, depths, color=INK, linestyle=":", label=r"$\sigma_z$, downwards")
    right.plot(below.max_shear / pressure, depths, color=FIRST, label="maximum shear")
    right.plot(below.von_mises / pressure, depths, color=SECOND, linestyle="--", label="von Mises")
    right.axhline(depths[deepest], color=FAINT_INK, linewidth=0.7, linestyle=(0, (1, 2)))
    left.set(ylabel="Depth / half-width", xlim=(-1.05, 0), ylim=(2.5, 0))
    right.set(xlim=(0, 0.65))
    for axes in (left, right):
        axes.set_xlabel("Stress / pressure $p_0$")
        axes.legend(loc="lower left" if axes is left else "lower right")
        axes.spines[["top", "right"]].set_visible(False)
