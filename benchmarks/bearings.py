"""What whole bearings cost: by strips from nothing, by maps, by slices, and 10,000 states of one.

    python benchmarks/bearings.py [OUT]

writes bearings.md and bearings.json into OUT, docs/benchmarks if left out. The ways of a bearing are taken in turn,
and figures are medians, so that what else the machine does falls on all of them alike; to compare revisions, run
it in both. Leave the machine alone meanwhile.
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
from nonhertz.native import core

OUT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
PAGE = Path("bearings.md")
ROUNDS, STATES, STATES_ROUNDS = 15, 10_000, 3
# A map costs the same whatever its accuracy, but to make it.
MAPPED = 1e-2
TARGETS = {("cylindrical", "strips"): 50.0, ("cylindrical", "maps"): 2.0, ("pair", "maps"): 10.0}  # ms
STATES_TARGET = 20.0  # s on two threads
Way = Callable[[], nh.bearing.BearingSolution]


def cylindrical() -> nh.bearing.RollerBearing:
    """Return a misaligned bearing's rollers and rings."""
    roller = nh.Roller(diameter=15, length=20, corner_radius=0.5, profile=nh.profile.crown(radius=4000))
    rings = {"inner": nh.Ring(diameter=90), "outer": nh.Ring(diameter=-120)}
    return nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=20, clearance=0.02)


def pair() -> nh.bearing.Paired:
    """Return two rows of tapered rollers back to back, preloaded."""
    cone = nh.TabulatedDiameter((-9.0, 9.0), (12.8, 11.2))
    roller = nh.Roller(diameter=cone, length=18, corner_radius=0.4, profile=nh.profile.crown(radius=3500))
    across = 12.0 / np.cos(0.25)
    rings = {"inner": nh.Ring(diameter=72 - across), "outer": nh.Ring(diameter=-(72 + across))}
    row = nh.bearing.TaperedRollerBearing(roller=roller, **rings, rollers=17, contact_angle=0.25)
    return nh.bearing.paired(row, "O", 40.0, clearance=-0.01)


CASES: dict[str, tuple[Callable[[], Any], dict[str, float], dict[str, float]]] = {
    "cylindrical": (cylindrical, {"radial": 50e3, "tilt": 5e-4}, {"load": 30e3, "tilt": 1.5e-3}),
    "pair": (pair, {"radial": 20e3, "axial": 8e3, "tilt": 3e-4}, {"load": 20e3, "tilt": 2e-3}),
}
NAMED = {
    "cylindrical": "20 cylindrical rollers 15 x 20, 50 kN, tilted by 0.5 mrad",
    "pair": "2 x 17 tapered rollers in O, 20 kN radial, 8 kN axial, tilted by 0.3 mrad",
}


def main(out: Path) -> None:
    """Measure and write."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    found: dict[str, Any] = {"machine": machine()}
    with cases.one_thread():
        for name, (make, given, reach) in CASES.items():
            bearing = make()
            maps = nh.bearing.maps(bearing, **reach, accuracy=MAPPED)
            ways = {
                "strips": lambda b=bearing, g=given: nh.bearing.solve(b, **g),
                "maps": lambda b=bearing, g=given, m=maps: nh.bearing.solve(b, **g, method=m),
                "slices": lambda b=bearing, g=given: nh.bearing.solve(b, **g, method="slices"),
            }
            found[name] = {"ms": in_turn(ways), "asked": counted(ways["strips"])}
            if name == "cylindrical":
                found["states"] = {threads: states(bearing, maps, threads) for threads in (1, 2)}
    (out / PAGE.with_suffix(".json")).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    (out / PAGE).write_text(page(found), encoding="utf-8")
    print(page(found))


def in_turn(ways: dict[str, Way]) -> dict[str, list[float]]:
    """Return how long each takes [ms]: the median, and the least."""
    times: dict[str, list[float]] = {name: [] for name in ways}
    for run in ways.values():
        run()
    for _ in range(ROUNDS):
        for name, run in ways.items():
            begun = time.perf_counter()
            run()
            times[name].append(1e3 * (time.perf_counter() - begun))
    return {name: [float(np.median(each)), min(each)] for name, each in times.items()}


def counted(run: Way) -> dict[str, int]:
    """Return how often what is asked while a bearing is solved: figures that no other work on the machine changes."""
    laws, make = [], core.StripLaw

    def law(*given: Any) -> Any:
        laws.append(make(*given))
        return laws[-1]

    core.StripLaw = law  # type: ignore[assignment, misc]
    try:
        run()
    finally:
        core.StripLaw = make  # type: ignore[misc]
    return {
        "contacts asked": sum(sum(each.asked.values()) for each in laws),
        "led to another pose": sum(each.followed for each in laws),
        "solved on strips": sum(each.solved for each in laws),
        "strips laid": sum(len(each.laid_for) for each in laws),
    }


def states(bearing: Any, maps: Any, threads: int) -> float:
    """Return how long 10,000 states by maps take [s], loads by tilts: the median."""
    radial, tilt = np.linspace(1e3, 60e3, 100)[:, None], np.linspace(-1e-3, 1e-3, STATES // 100)
    times = []
    for _ in range(STATES_ROUNDS):
        begun = time.perf_counter()
        nh.bearing.solve_many(bearing, radial=radial, tilt=tilt, method=maps, threads=threads)
        times.append(time.perf_counter() - begun)
    return float(np.median(times))


def page(found: dict[str, Any]) -> str:
    """Return the page."""
    lines = [
        "# What whole bearings cost",
        "",
        f"Measured by `benchmarks/bearings.py`. {found['machine']['processor']}, load average",
        f"{found['machine']['load']}, one thread. Medians of {ROUNDS} rounds in turn, the least in brackets.",
        "Strips start cold.",
        "",
        "| | strips | maps made before | slices |",
        "|---|--:|--:|--:|",
    ]
    for name in CASES:
        cells = [said(name, way, *found[name]["ms"][way]) for way in ("strips", "maps", "slices")]
        lines.append(f"| {NAMED[name]} | {' | '.join(cells)} |")
    one, two = found["states"][1], found["states"][2]
    lines += [
        "",
        f"{STATES:,} states of the cylindrical bearing by maps, loads by tilts: {one:.2g} s on one thread,",
        f"{two:.2g} s on two (target {STATES_TARGET:.0f} s).",
        "",
    ]
    return "\n".join(lines)


def said(name: str, way: str, median: float, least: float) -> str:
    """Return a time, and its target if it has one."""
    target = TARGETS.get((name, way))
    return f"{median:.3g} ms ({least:.3g})" + (f", target {target:.0f}" if target else "")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else OUT)
