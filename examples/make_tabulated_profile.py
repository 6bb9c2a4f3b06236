"""Write tabulated-profile.csv: the relief of a ground roller 16 x 24, at points 0.04 mm apart.

The relief is the sum of a logarithmic profile, a waviness of the grinding, and the rounding of the ends.
Nothing in it is measured, and nothing is random: the same file comes out every time. It is rounded to 10 nm,
as instruments do.

    python examples/make_tabulated_profile.py [DIRECTORY]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import nonhertz as nh

LENGTH = 24.0  # mm
STEP = 0.04  # mm
AMPLITUDE = 0.005  # mm, of the logarithm
WAVINESS, WAVELENGTH = 0.0003, 3.0  # mm
ROUNDING, ROUNDED = 12.0, 1.2  # mm: radius of the ends, and the length over which they are rounded


def relief(y: np.ndarray) -> np.ndarray:
    """Return the relief [mm] at ``y`` [mm]."""
    logarithm = nh.profile.logarithmic(amplitude=AMPLITUDE, length=LENGTH, fraction=0.999).relief(y)
    waves = 0.5 * WAVINESS * (1.0 - np.cos(2.0 * np.pi * y / WAVELENGTH))
    into_rounding = np.maximum(np.abs(y) - (0.5 * LENGTH - ROUNDED), 0.0)
    return logarithm + waves + ROUNDING - np.sqrt(ROUNDING**2 - into_rounding**2)


def main(directory: Path) -> Path:
    """Write the file and return its path."""
    y = STEP * np.arange(-round(0.5 * LENGTH / STEP), round(0.5 * LENGTH / STEP) + 1)
    path = directory / "tabulated-profile.csv"
    lines = [f"{a:.2f},{b:.5f}" for a, b in zip(y, relief(y), strict=True)]
    path.write_text("\n".join(["y [mm],relief [mm]", *lines]) + "\n", encoding="utf-8")
    return path


if __name__ == "__main__":
    print(f"wrote {main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)}")
