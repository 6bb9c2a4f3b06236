"""What a gradient costs beside the solve that it belongs to.

    python benchmarks/gradients.py [OUT]

writes gradients.md and gradients.json into OUT, docs/benchmarks if left out. A solve, its first gradient, a further
one and the derivative by a dimension follow each other in turn; shares are medians of pairs.
"""

from __future__ import annotations

import json
import sys
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cases
import numpy as np
from machine import machine

import nonhertz as nh

OUT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
PAGE = Path("gradients.md")
ROUNDS, TARGET = 25, 0.3
WAYS = ("first gradient", "further gradient", "by a dimension")


def main(out: Path) -> None:
    """Measure and write."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    found: dict[str, Any] = {"machine": machine()}
    with cases.one_thread():
        found["cases"] = {name: shares(solve) for name, solve in solves().items()}
    (out / PAGE.with_suffix(".json")).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    (out / PAGE).write_text(page(found), encoding="utf-8")
    print(page(found))


def solves() -> dict[str, Callable[[], nh.Solution]]:
    """Return what is solved, by name."""
    roller = nh.Roller(diameter=15, length=20, corner_radius=0.5, profile=nh.profile.crown(radius=4000))
    real = nh.Contact(roller, nh.Ring(diameter=80, depth=6))
    return {
        "41 equal strips, half-spaces": cases.fixed(41),
        "200 equal strips, half-spaces": cases.fixed(200),
        "automatic grid, half-spaces": cases.fixed("auto"),
        "automatic grid, whole roller with free ends and a corner on a ring": lambda: nh.solve(
            real, load=15e3, tilt=2e-4
        ),
    }


def shares(solve: Callable[[], nh.Solution]) -> dict[str, float]:
    """Return the time of a solve [ms], and what else takes of it."""
    times: list[list[float]] = []
    for _ in range(ROUNDS + 1):
        marks = [time.perf_counter()]
        solution = solve()
        marks.append(time.perf_counter())
        first = solution.gradient("max_pressure")
        marks.append(time.perf_counter())
        solution.gradient("approach")
        marks.append(time.perf_counter())
        first.by("a.diameter")
        marks.append(time.perf_counter())
        times.append(np.diff(marks).tolist())
    taken = np.array(times[1:])
    ratios = np.median(taken[:, 1:] / taken[:, :1], axis=0)
    return {"solve": 1e3 * float(np.median(taken[:, 0]))} | dict(zip(WAYS, ratios.tolist(), strict=True))


def page(found: dict[str, Any]) -> str:
    """Return the page."""
    lines = [
        "# What a gradient costs",
        "",
        f"Measured by `benchmarks/gradients.py`. {found['machine']['processor']}, load average",
        f"{found['machine']['load']}, one thread. Shares of the solve before, medians of {ROUNDS} pairs. A gradient",
        f"has the derivatives by relief and curvature at every strip, for any number of parameters; target {TARGET}.",
        "A dimension by its name also takes the bodies anew, four times.",
        "",
        f"| | solve | {' | '.join(WAYS)} |",
        "|---|--:|--:|--:|--:|",
    ]
    for name, each in found["cases"].items():
        lines.append(f"| {name} | {each['solve']:.3g} ms | {' | '.join(f'{each[way]:.2f}' for way in WAYS)} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else OUT)
