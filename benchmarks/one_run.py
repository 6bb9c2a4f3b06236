"""One run of the race in a process of its own: a program, a contact, a grid. JSON on stdin, JSON on the last line out.

A process of its own so that memory is nobody else's, and so that no program finds caches that another has warmed.
"""

from __future__ import annotations

import json
import resource
import statistics
import sys
import time
import warnings
from pathlib import Path
from typing import Any

import entrants
import numpy as np
import races
from threadpoolctl import threadpool_limits

import nonhertz as nh

# A tenth of what the page asks of the discretisation: 1e-4 of the approach, 2 % of the maximum pressure.
APPROACH_TARGET, PRESSURE_TARGET = 1e-5, 2e-3
LOOSEST, NOTCH, TIGHTEST = 1e-2, 10**0.5, 1e-11
CONVERGED = 1e-7
FEWEST_RUNS, SHORTEST = 5, 0.3  # runs, s

Run = tuple[float, entrants.Answer]


def main() -> None:
    """Read what is to be run, run it, write what came out."""
    asked = json.load(sys.stdin)
    with threadpool_limits(limits=asked["threads"]), warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        print("\n" + json.dumps(converged(asked) if "write" in asked else run(asked)))


def run(asked: dict[str, Any]) -> dict[str, Any]:
    """Return errors, time and memory of a program on a grid, stopped at the agreed algebraic error."""
    race = races.all_races()[asked["race"]]
    entrant, grid, threads = asked["entrant"], asked["grid"], asked["threads"]
    # Once beforehand, so that what is loaded then is no part of the memory.
    entrants.prepared(entrant, race, [32, 32] if isinstance(grid, list) else grid, threads)(LOOSEST)
    before = resident()
    solve = entrants.prepared(entrant, race, grid, threads)
    tolerance = asked["tolerance"]
    first = clocked(solve, tolerance)
    memory = peak() - before
    tolerance, last, algebraic = calibrated(solve, first, tolerance, asked["limit"])
    times, answer = timed(solve, last, tolerance, asked["longest"])
    found = {name: getattr(answer, name) for name in races.QUANTITIES}
    share = entrants.BATCH if entrant.startswith("batch") else 1
    return {
        "entrant": entrant,
        "grid": grid,
        "time": statistics.median(times) / share,
        "fastest": min(times) / share,
        "slowest": max(times) / share,
        "runs": len(times),
        "memory": max(memory, 0),
        "tolerance": tolerance if algebraic else None,
        "algebraic": algebraic,
        "found": {name: _or_none(value) for name, value in found.items()},
        "error": {name: _or_none(abs(value / race.answer[name] - 1.0)) for name, value in found.items()},
    }


def converged(asked: dict[str, Any]) -> dict[str, Any]:
    """Write the solution of the discrete equations on each grid: pressures, and the approach after them."""
    race = races.all_races()[asked["race"]]
    for grid, path in zip(asked["grids"], asked["write"], strict=True):
        answer = entrants.prepared(asked["entrant"], race, grid, asked["threads"])(CONVERGED)
        np.save(path, np.append(answer.pressure.ravel(), answer.approach))
    return {}


def calibrated(
    solve: entrants.Solve, run: Run, tolerance: float, limit: str | None
) -> tuple[float, Run, dict[str, float] | None]:
    """Return the loosest tolerance at which the program is as near to its own limit as all others are asked to be."""
    if limit is None:
        return tolerance, run, None
    at_limit = np.load(limit)
    found = distance(run[1], at_limit)
    while found["approach"] > APPROACH_TARGET or found["pressure"] > PRESSURE_TARGET:
        tolerance /= NOTCH
        if tolerance < TIGHTEST:
            raise RuntimeError("does not converge to the solution that the others converge to")
        run = clocked(solve, tolerance)
        found = distance(run[1], at_limit)
    return tolerance, run, found


def timed(solve: entrants.Solve, last: Run, tolerance: float, longest: float) -> tuple[list[float], entrants.Answer]:
    """Return the times of as many runs as fit; one that took longer than all may is not run again."""
    seconds, answer = last
    times = [seconds] if seconds > longest else []
    while sum(times) < min(SHORTEST, longest) or (len(times) < FEWEST_RUNS and sum(times) < longest):
        seconds, answer = clocked(solve, tolerance)
        times.append(seconds)
    return times, answer


def clocked(solve: entrants.Solve, tolerance: float) -> Run:
    """Return how long a solve takes, and its answer."""
    start = time.perf_counter()
    answer = solve(tolerance)
    return time.perf_counter() - start, answer


def distance(answer: entrants.Answer, at_limit: np.ndarray) -> dict[str, float]:
    """Return how far an answer is from the solution of the same equations: approach, and pressure anywhere."""
    pressure, approach = at_limit[:-1], at_limit[-1]
    return {
        "approach": float(abs(answer.approach / approach - 1.0)),
        "pressure": float(np.abs(answer.pressure.ravel() - pressure).max() / pressure.max()),
    }


def resident() -> int:
    """Return the memory in use [bytes], and let the peak start from here where the system can."""
    try:
        Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
        return _status("VmRSS")
    except OSError:
        return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def peak() -> int:
    """Return the largest memory in use [bytes] since then."""
    try:
        return _status("VmHWM")
    except OSError:
        return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def _or_none(number: float) -> float | None:
    return None if np.isnan(number) else float(number)


def _status(name: str) -> int:
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return 1024 * next(int(line.split()[1]) for line in lines if line.startswith(name))


if __name__ == "__main__":
    main()
