"""Write docs/explain/patch-table.md and the figures of dents: what cells cost, and what they give.

    python docs/patch_study.py

Time is the least of several solves from cold, on one thread. Errors are against Hertz's closed form.
"""

from __future__ import annotations

import importlib.util
import math
import os
import platform
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nonhertz as nh
from nonhertz.patch import PatchSolution, memory

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "explain" / "patch-table.md"
FIGURE = ROOT / "docs" / "figures" / "dented-raceway.png"
NUMBERS = (32, 64, 128, 256, 512, 1024, 2048)
WORTH_REPEATING = 2.0  # s
REPEATS = 5
HERTZ_NUMBERS = (16, 32, 64, 128, 256, 512)
SHARP_NUMBERS = (128, 256, 512, 1024)
SHARP_APPROACH = 0.02741221026671631  # mm, reference D of tests/validation/data
HALF_SPACE = {"side_faces": "none", "depth": "none", "material": nh.Material(207000, 0.3)}
PPM = 1e6


def main() -> None:
    """Measure and write the page and the figure."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    sections = (_head, _cost_table, _long_table, _hertz_table, _sharp_table)
    PAGE.write_text("\n".join(line for section in sections for line in section()), encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")
    example = _example("dented-raceway")
    example.draw(example.solve(), example.solve(example.DENT), FIGURE)
    print(f"wrote {FIGURE.relative_to(ROOT)}")
    _example("overrolled-dent").main(FIGURE.parent)
    FIGURE.with_name("overrolled-dent.svg").unlink()


def _example(name: str) -> Any:
    specification = importlib.util.spec_from_file_location(name.replace("-", "_"), ROOT / "examples" / f"{name}.py")
    assert specification is not None
    assert specification.loader is not None
    example = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(example)
    return example


def _head() -> Iterator[str]:
    yield "# Errors and cost of the plane grid, measured"
    yield ""
    yield "Computed by `docs/patch_study.py`. The method: [patch.md](patch.md)."
    yield f"Times: one thread of {os.cpu_count()} cores ({platform.machine()}), from cold, with the region, all coarser"
    yield f"grids and the transform of the kernel; least of up to {REPEATS} solves."
    yield ""


def _tilted() -> nh.Contact:
    profile = nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
    return nh.Contact(nh.Roller(diameter=20, length=20, profile=profile, **HALF_SPACE), _plate())


def _cost_table() -> Iterator[str]:
    yield "## Cost against cells"
    yield ""
    yield "Logarithmic roller 20 x 20 on a flat, 20 kN, tilted by 0.5 mrad, half-spaces, tolerance 1e-8."
    yield ""
    yield _row("cells", "time [s]", "convolutions", "memory [MiB]")
    yield _rule(4)
    seconds = []
    for number in NUMBERS:
        took, solution = _timed(lambda n=number: nh.patch.solve(_tilted(), load=20e3, tilt=5e-4, cells=(n, n)))
        seconds.append(took)
        mebibytes = memory((number, number)) / 2**20
        yield _row(f"{number} x {number}", f"{took:.3f}", solution.iterations, f"{mebibytes:.1f}")
    upper = slice(-4, None)
    order = np.polyfit(np.log(np.square(NUMBERS[upper])), np.log(seconds[upper]), 1)[0]
    yield ""
    yield f"From {NUMBERS[-4]} x {NUMBERS[-4]} on, time grows as cells^{order:.2f}. Memory: `nonhertz.patch.memory`."
    yield ""


def _long_table() -> Iterator[str]:
    yield "## Other contacts, 512 x 1024 cells"
    yield ""
    yield _row("contact", "time [s]", "convolutions", "residual", "memory [MiB]")
    yield _rule(5)
    mirrored = nh.Contact(
        nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000), side_faces="mirror"), nh.Plate()
    )
    straight = nh.Contact(nh.Roller(diameter=20, length=20, **HALF_SPACE), _plate())
    dent = nh.patch.Dent(y=1.0, depth=0.003, diameter=0.3)
    cases: dict[str, Callable[[], PatchSolution]] = {
        "the same roller": lambda: nh.patch.solve(_tilted(), load=20e3, tilt=5e-4, cells=(512, 1024)),
        "straight, up to sharp ends": lambda: nh.patch.solve(straight, load=20e3, cells=(512, 1024)),
        "crown 4000, mirrored faces, depth": lambda: nh.patch.solve(mirrored, load=6e3, cells=(512, 1024)),
        "that with a dent": lambda: nh.patch.solve(mirrored, load=6e3, features=[dent], cells=(512, 1024)),
    }
    for name, solve in cases.items():
        took, solution = _timed(solve)
        mebibytes = solution.memory / 2**20
        yield _row(name, f"{took:.2f}", solution.iterations, f"{solution.residual:.1e}", f"{mebibytes:.0f}")
    yield ""


def _hertz_table() -> Iterator[str]:
    bodies = nh.Contact(nh.Body(diameter=20), nh.Plate())
    exact = nh.hertz.point_contact(load=1000.0, radius_x=10.0, radius_y=100.0, compliance=bodies.compliance)
    yield "## Error: a Hertz ellipse"
    yield ""
    yield "Rx 10, Ry 100 mm, 1000 N, steel; errors in ppm; the estimate is `error_estimate`."
    yield ""
    yield _row("cells", "approach", "estimate", "centre pressure", "maximum pressure", "estimate", "half-width")
    yield _rule(7)
    errors = []
    for number in HERTZ_NUMBERS:
        found = nh.patch.solve(bodies, load=1000.0, gap=lambda x, y: x**2 / 20.0 + y**2 / 200.0, cells=(number, number))
        errors.append(found.approach / exact.approach - 1.0)
        yield _row(
            f"{number} x {number}",
            _ppm(errors[-1]),
            _ppm(found.error_estimate.approach),
            _ppm(float(np.interp(0.0, found.y, found.centre_pressure)) / exact.max_pressure - 1.0),
            _ppm(found.max_pressure / exact.max_pressure - 1.0),
            _ppm(found.error_estimate.max_pressure),
            _ppm(float(np.interp(0.0, found.y, found.half_width)) / exact.half_width - 1.0),
        )
    order = -np.polyfit(np.log(HERTZ_NUMBERS), np.log(np.abs(errors)), 1)[0]
    yield ""
    yield f"The error of the approach falls as side^{order:.1f} of a cell, with scatter."
    yield ""


def _sharp_table() -> Iterator[str]:
    straight = nh.Contact(nh.Roller(diameter=20, length=20, **HALF_SPACE), _plate())
    yield "## Error: up to sharp ends"
    yield ""
    yield "Straight roller 20 x 20 on a flat, 20 kN, half-spaces; 64 cells across; against an independent program"
    yield "(tests/validation/data/D.json). Last column: Richardson's extrapolation from two rows."
    yield ""
    yield _row("cells along", "approach [ppm]", "estimate", "extrapolated")
    yield _rule(4)
    before = None
    for number in SHARP_NUMBERS:
        found = nh.patch.solve(straight, load=20e3, cells=(64, number))
        extrapolated = "" if before is None else _ppm((2.0 * found.approach - before) / SHARP_APPROACH - 1.0)
        error = found.approach / SHARP_APPROACH - 1.0
        yield _row(number, _ppm(error), _ppm(found.error_estimate.approach), extrapolated)
        before = found.approach
    yield ""


def _plate() -> nh.Plate:
    return nh.Plate(material=nh.Material(207000, 0.3))


def _timed(solve: Callable[[], PatchSolution]) -> tuple[float, PatchSolution]:
    """Return the least time of a few solves [s], and the solution."""
    best = math.inf
    for _ in range(REPEATS):
        start = time.perf_counter()
        solution = solve()
        best = min(best, time.perf_counter() - start)
        if best > WORTH_REPEATING:
            break
    return best, solution


def _row(*cells: object) -> str:
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def _rule(columns: int) -> str:
    return "|" + "---|" * columns


def _ppm(value: float) -> str:
    return f"{PPM * value:.3g}"


if __name__ == "__main__":
    main()
