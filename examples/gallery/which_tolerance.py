"""
Which tolerance matters?
========================

The radii of crown and corners, the load and the misalignment of a roller vary. How much does the maximum pressure vary,
and which of them is worth tightening?
"""

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.studies import histogram, tornado
from nonhertz.plot.style import sheet_style

roller = nh.Roller(diameter=20, length=20, corner_radius=0.5, profile=nh.profile.crown(radius=3000))
case = nh.Case(
    nh.Contact(roller, nh.Ring(diameter=80, length=30)), {"load": 15e3}, {"strips": 61}, title="Roller 20 x 20"
)
DISTRIBUTIONS = {
    "load.load": "normal(nominal, 0.5 kN)",
    "load.tilt": "normal(0, 0.25 mrad)",
    "body.a.profile.radius": "uniform(2600 mm, 3400 mm)",
    "body.a.corner_radius": "triangular(0.4 mm, 0.5 mm, 0.8 mm)",
}
found = nh.tolerance(case, over=DISTRIBUTIONS, samples=1500, quantities=("max_pressure",), workers=1)

# %%
# The distribution
# ----------------
# Each quantile lies within its interval with 95 % confidence, for any distribution.

quantiles = found.quantiles("max_pressure")
for each in quantiles:
    print(
        f"{100 * each.probability:3.0f} % below {each.value:4.0f} MPa, "
        f"certainly between {each.low:4.0f} and {each.high:4.0f}"
    )

# %%
# Causes
# ------
# The first index is the share of the variance due to a parameter alone, the total one with its interactions.

indices = found.indices("max_pressure")
for each in indices:
    certain = f"({each.first_low:.2f} to {each.first_high:.2f})"
    print(f"{each.path:22} alone {each.first:4.2f} {certain}, in total {each.total:4.2f}")
print("tighten first:", *found.tightened_first["max_pressure"])

with sheet_style():
    figure = Figure(figsize=(6.7, 2.7), layout="constrained")
    histogram(
        found.samples("max_pressure"),
        figure.add_subplot(1, 2, 1),
        label="Maximum pressure [MPa]",
        quantiles={each.probability: (each.low, each.high) for each in quantiles if np.isfinite(each.low + each.high)},
    )
    names = ("first", "total", "first_low", "first_high", "total_low", "total_high")
    first, total, *ends = np.array([[getattr(each, name) for name in names] for each in indices]).T
    intervals = (ends[:2], ends[2:])
    tornado([each.path for each in indices], first, total, figure.add_subplot(1, 2, 2), intervals=intervals)
