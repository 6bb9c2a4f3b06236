"""Write measured-roller.txt: a roller 10 x 12 as a measuring machine leaves it, not levelled and not centred.

Nothing in it is measured. It is a logarithmic profile with chamfers of 30 degrees that an arc of 0.5 mm blends in, a
waviness of the grinding, roughness of 0.1 um and five grains of dust, tilted by 1.2 mrad in a machine whose zero is
somewhere else. The random numbers are those of one seed, so that the same file comes out every time.

    python examples/make_measured_roller.py [DIRECTORY]
"""

from __future__ import annotations

import math
import random
import sys
from pathlib import Path

import numpy as np

import nonhertz as nh

LENGTH = 12.0  # mm
CHAMFER = nh.Chamfer(length=0.4, angle=math.pi / 6, blend_radius=0.5)
STEP, BEYOND = 0.004, 0.05  # mm: between points, and what the stylus leaves out at either end
AMPLITUDE, STRAIGHT = 0.006, 4.0  # mm, of the logarithm and its straight middle
WAVINESS, WAVELENGTH = 5e-5, 1.9  # mm
ROUGHNESS = 1e-4  # mm
TILT, START, LEVEL = 1.2e-3, 3.2, -0.4  # rad; mm, of the middle in the machine
DUST = {400: 0.004, 401: 0.003, 1200: 0.006, 1777: -0.003, 2500: 0.005}  # mm, by the number of the point
HEAD = """# roller 10 x 12, along its axis
# points every {step} um
position [mm]\theight [um]
"""


def profile() -> nh.profile.Profile:
    """Return the profile without anything that a machine adds."""
    return nh.profile.logarithmic(amplitude=AMPLITUDE, length=LENGTH - STRAIGHT, straight=STRAIGHT)


def height(y: np.ndarray) -> np.ndarray:
    """Return the heights [mm] of the surface at ``y`` [mm] from the middle of the roller."""
    land = 0.5 * LENGTH - CHAMFER.length
    inside = np.clip(y, -land, land)
    form = -profile().relief(inside) - CHAMFER.drop(np.abs(y) - np.abs(inside))
    return form + WAVINESS * np.sin(2.0 * np.pi * y / WAVELENGTH)


def main(directory: Path) -> Path:
    """Write the file and return its path."""
    half = 0.5 * LENGTH - BEYOND
    y = np.arange(-round(half / STEP), round(half / STEP) + 1) * STEP
    # Python's own generator gives the same numbers in every version.
    draw = random.Random(12)
    measured = height(y) + TILT * y + LEVEL + np.array([draw.gauss(0.0, ROUGHNESS) for _ in y])
    for point, dust in DUST.items():
        measured[point] += dust
    path = directory / "measured-roller.txt"
    lines = [f"{a:.3f}\t{1e3 * b:.3f}" for a, b in zip(y + START, measured, strict=True)]
    path.write_text(HEAD.format(step=round(1e3 * STEP)) + "\n".join(lines) + "\n", encoding="utf-8")
    return path


if __name__ == "__main__":
    print(f"wrote {main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)}")
