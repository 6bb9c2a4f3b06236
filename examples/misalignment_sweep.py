"""Pressure in the middle and near the end of a roller 20 x 20 against tilt, for three profiles.

The roller's ends are free and the plate goes on beyond them. Prints a table and writes out/misalignment-sweep.svg.
The pressure near the end is taken 0.5 mm from it: at a sharp end itself, on a body that goes on, it has no limit.

    python examples/misalignment_sweep.py
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh

ROLLER = nh.Roller(diameter=20, length=20)
TILTS = np.linspace(0.0, 1.5e-3, 7)  # rad
PROFILES = {
    "straight": nh.profile.straight(),
    "crown": nh.profile.crown(radius=2000),
    "logarithmic": nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999),
}


def sweep(profile: nh.profile.Profile) -> np.ndarray:
    """Return the pressures [MPa] in the middle and 0.5 mm from the loaded end at every tilt."""
    contact = nh.Contact(replace(ROLLER, profile=profile), nh.Plate())
    solutions = [nh.solve(contact, load=20e3, tilt=tilt) for tilt in TILTS]
    return np.array([np.interp([0.0, 9.5], s.y, s.centre_pressure) for s in solutions])


def main() -> dict[str, np.ndarray]:
    """Print the table, write the figure, return the pressures."""
    axes = Figure(figsize=(6.7, 3.7), layout="constrained").add_subplot()
    axes.set(xlabel="Tilt [mrad]", ylabel="Centre-line pressure $p_0$ [MPa]", ylim=(0, 3500))
    results = {name: sweep(profile) for name, profile in PROFILES.items()}
    for name, (middle, end) in ((name, result.T) for name, result in results.items()):
        (line,) = axes.plot(1e3 * TILTS, end, marker="o", label=f"{name}, 0.5 mm from the loaded end")
        axes.plot(1e3 * TILTS, middle, linestyle="--", color=line.get_color(), label=f"{name}, middle")
    axes.legend(ncols=2, frameon=False, fontsize="small", loc="lower left")
    Path("out").mkdir(exist_ok=True)
    axes.figure.savefig("out/misalignment-sweep.svg", metadata={"Date": None})
    print("Pressure [MPa] in the middle, and 0.5 mm from the loaded end\ntilt [mrad]", end="")
    print("".join(f"{name:>16}" for name in results))
    for k, tilt in enumerate(TILTS):
        print(f"{1e3 * tilt:11.2f}" + "".join(f"{r[k, 0]:8.0f}{r[k, 1]:8.0f}" for r in results.values()))
    return results


if __name__ == "__main__":
    main()
