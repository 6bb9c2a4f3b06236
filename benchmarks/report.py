"""Measure speed and write docs/benchmarks: results.json, the curve of cost against strips, and the page.

    python benchmarks/report.py

Everything is measured in one run, on one thread; figures are medians. Leave the machine alone meanwhile.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import cases
import numpy as np
from machine import machine
from matplotlib.figure import Figure

from nonhertz.native import core
from nonhertz.plot import save
from nonhertz.plot.style import FAINT_INK, FIRST, LINE, SECOND, THIN, sheet_style

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "docs" / "benchmarks"
CURVE = (5, 7, 10, 14, 20, 28, 41, 57, 80, 113, 160, 226, 320, 400)
GROWING = 80  # strips from which on the growth is fitted
SECONDS, FEWEST_RUNS = 1.0, 21  # of measuring each solve
COMMAND_RUNS = 11
SPLIT_RUNS = 101
MANY_ROUNDS = 9
BELOW_ROUNDS = 5
PARTS = ("the core", "Python around it")
# The site's table of contents shows these below the page.
CONTENTS = """```{toctree}
:hidden:

race
page
first-picture
bearings
gradients
studies
```
"""


def main() -> None:
    """Measure and write."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    with cases.one_thread():
        results = measured()
    (FOLDER / "results.json").write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    save(drawn(results), FOLDER / "cost-against-strips")
    (FOLDER / "index.md").write_text("\n".join(page(results)), encoding="utf-8")
    print(f"wrote {FOLDER.relative_to(ROOT)}")


def measured() -> dict[str, Any]:
    """Return every figure; times in seconds."""
    results: dict[str, Any] = {"machine": machine()}
    results["curve"] = {strips: median_time(cases.fixed(strips)) for strips in CURVE}
    results["growth"] = growth(results["curve"])
    results["automatic"] = {name: automatic(solve) for name, solve in cases.automatic().items()}
    results["many"] = {name: on_threads(run, MANY_ROUNDS, cases.MANY) for name, run in cases.many().items()}
    results["finite"] = {name: compared(*pair) for name, pair in cases.against_finite().items()}
    results["below"] = {name: on_threads(run, BELOW_ROUNDS) for name, run in cases.below().items()}
    results["split"] = {
        f"{cases.STRIPS} equal strips": split(cases.fixed(cases.STRIPS)),
        "400 equal strips": split(cases.fixed(400), runs=11),
        **{f"automatic: {name}": split(solve) for name, solve in cases.automatic().items()},
    }
    results["commands"] = {
        "nonhertz --help": command_time("-m", "nonhertz", "--help"),
        "import nonhertz": command_time("-c", "import nonhertz"),
        "import nonhertz; nonhertz.solve": command_time("-c", "import nonhertz; nonhertz.solve"),
        "python alone": command_time("-c", ""),
    }
    return results


def in_turn(*runs: Callable[[], object], rounds: int = FEWEST_RUNS, seconds: float = 0.0) -> np.ndarray:
    """Return the times of calls, a row a round, after a first round that does not count."""
    for run in runs:
        run()
    times, spent = [], 0.0
    while spent < seconds or len(times) < rounds:
        times.append([clocked(run) for run in runs])
        spent += sum(times[-1])
    return np.array(times)


def clocked(run: Callable[[], object]) -> float:
    """Return how long a call takes."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def median_time(run: Callable[[], object], rounds: int = FEWEST_RUNS, seconds: float = SECONDS) -> float:
    """Return the median time of a call."""
    return float(np.median(in_turn(run, rounds=rounds, seconds=seconds)))


def command_time(*words: str) -> float:
    """Return the median time of a fresh Python with these arguments."""
    return median_time(cases.command(*words), COMMAND_RUNS, 0.0)


def automatic(solve: cases.Solve) -> dict[str, float]:
    """Return time, strips and Newton steps of a solve on the automatic grid."""
    solution = solve()
    return {
        "time": median_time(solve),
        "strips": solution.strips,
        "steps": solution.iterations,
        "steps on all grids": sum(state.steps for _, state in solution.judgement.result.levels),
    }


def on_threads(run: Callable[[int], object], rounds: int, share: int = 1) -> dict[str, float]:
    """Return median times of a call on one thread and on two, taken in turn, and the median of their ratios."""
    times = in_turn(lambda: run(1), lambda: run(2), rounds=rounds) / share
    one, two = np.median(times, axis=0)
    return {"one thread": float(one), "two threads": float(two), "gain": float(np.median(times[:, 0] / times[:, 1]))}


def compared(one: cases.Solve, other: cases.Solve) -> dict[str, float]:
    """Return median times of two solves taken in turn, and the median of their ratios."""
    times = in_turn(one, other, seconds=2.0 * SECONDS)
    first, second = np.median(times, axis=0)
    return {"half-spaces": float(first), "finite": float(second), "ratio": float(np.median(times[:, 1] / times[:, 0]))}


def growth(curve: dict[int, float]) -> float:
    """Return the exponent with which time grows with the number of strips, where there are many."""
    many = [strips for strips in curve if strips >= GROWING]
    return float(np.polyfit(np.log(many), np.log([curve[strips] for strips in many]), 1)[0])


@contextmanager
def timed(module: ModuleType, name: str) -> Iterator[list[float]]:
    """Yield a list of how long every call takes that goes through a name of a module."""
    function, times = getattr(module, name), []

    def watched(*arguments: Any, **named: Any) -> Any:
        start = time.perf_counter()
        try:
            return function(*arguments, **named)
        finally:
            times.append(time.perf_counter() - start)

    setattr(module, name, watched)
    try:
        yield times
    finally:
        setattr(module, name, function)


def split(solve: cases.Solve, runs: int = SPLIT_RUNS) -> dict[str, float]:
    """Return the share of each part in the time of a solve, from the fastest of many runs."""
    with timed(core, "solve") as inside:
        whole = in_turn(solve, rounds=runs)[:, 0]
    best = int(whole.argmin())
    share = inside[best + 1] / float(whole[best])  # the first one did not count
    return dict(zip(PARTS, (share, 1.0 - share), strict=True))


def drawn(results: dict[str, Any]) -> Figure:
    """Return the curve of cost against strips."""
    strips = np.array(CURVE)
    milliseconds = 1e3 * np.array([results["curve"][count] for count in CURVE])
    with sheet_style():
        axes = Figure(figsize=(6.7, 3.7), layout="constrained").add_subplot()
        axes.loglog(strips, milliseconds, color=FIRST, linewidth=LINE, marker="o", markersize=4, label="solve")
        fit = milliseconds[-1] * (strips / strips[-1]) ** results["growth"]
        label = f"strips to the power of {results['growth']:.2f}"
        many = strips >= GROWING
        axes.loglog(strips[many], 0.6 * fit[many], color=FAINT_INK, linewidth=THIN, linestyle="--", label=label)
        target = 1e3 * cases.FIXED_TARGET
        label = f"target: {cases.STRIPS} strips in {target:g} ms"
        axes.plot(cases.STRIPS, target, color=SECOND, marker="v", linestyle="none", label=label)
        axes.set(xlabel="Equal strips", ylabel="Time of a solve [ms]", xlim=(4.5, 450))
        axes.set_xticks(CURVE[::2], [str(count) for count in CURVE[::2]])
        decades = (0.1, 1, 10, 100, 1000)
        axes.set_yticks(decades, [f"{tick:g}" for tick in decades])
        axes.set_ylim(0.5 * milliseconds.min(), 2.0 * milliseconds.max())
        axes.minorticks_off()
        axes.legend(loc="upper left")
        axes.set_title("Crowned roller 20 x 20 on a plate, 20 kN; one thread, median", loc="left")
        return axes.figure


def page(results: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of the page."""
    computer, commands = results["machine"], results["commands"]
    versions = ", ".join(f"{name} {version}" for name, version in computer["versions"].items())
    yield "# Speed"
    yield ""
    yield "Measured by `benchmarks/report.py` (`make bench`). Medians of one run,"
    yield f"{computer['threads']} thread. {computer['processor']}, {computer['cores']} cores, load average"
    yield f"{computer['load']}; {versions}."
    yield ""
    yield "[Other programs](race.md), [the page](page.md), [first steps](first-picture.md),"
    yield "[whole bearings](bearings.md), [gradients](gradients.md), [studies](studies.md)."
    yield ""
    yield from targets(results)
    yield "## Cost against strips"
    yield ""
    yield "![Time of a solve against the number of equal strips](cost-against-strips.svg)"
    yield ""
    yield f"From {GROWING} strips on the time grows as strips^{results['growth']:.2f}: matrices have strips^2"
    yield "entries, and solving takes strips^3 operations. A solve includes the coarser grids. Numbers, and where the"
    yield "time goes, are in [results.json](results.json)."
    yield ""
    yield from automatic_grid(results)
    yield from many_cases(results)
    yield from below(results)
    yield "## Starting"
    yield ""
    yield "| | time [ms] |"
    yield "|---|---|"
    for name, seconds in commands.items():
        yield f"| `{name}` | {_number(seconds)} |" if name != "python alone" else f"| {name} | {_number(seconds)} |"
    yield ""
    yield CONTENTS


def targets(results: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of what was aimed at, and what was measured."""
    curve, commands = results["curve"], results["commands"]
    slowest = max(entry["time"] for entry in results["automatic"].values())
    yield "| | target | measured |"
    yield "|---|---|---|"
    yield f"| {cases.STRIPS} equal strips | {_ms(cases.FIXED_TARGET)} | {_ms(curve[cases.STRIPS])} |"
    yield f"| automatic grid, slowest case below | {_ms(cases.AUTOMATIC_TARGET)} | {_ms(slowest)} |"
    slowest_of_many = max(entry["one thread"] for entry in results["many"].values())
    least_gain = min(entry["gain"] for entry in results["many"].values())
    label = f"{cases.STRIPS} equal strips, each of {cases.MANY} in `solve_many`, one thread"
    yield f"| {label} | {_ms(cases.MANY_TARGET)} | {_ms(slowest_of_many)} |"
    yield f"| gain on two threads | {cases.GAIN_TARGET} | {least_gain:.2f} |"
    largest = max(entry["ratio"] for entry in results["finite"].values())
    yield f"| faces and depth on both bodies, slowest case below | {cases.FINITE_TARGET} times | {largest:.2f} times |"
    label, entry = next((name, entry) for name, entry in results["below"].items() if "mirrored" in name)
    yield f"| stress at {label}, two threads | {cases.BELOW_TARGET:g} s | {entry['two threads']:.2f} s |"
    yield f"| `nonhertz --help` | {_ms(cases.HELP_TARGET)} | {_ms(commands['nonhertz --help'])} |"
    yield ""


def many_cases(results: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of many cases in one call."""
    yield "## Many cases in one call"
    yield ""
    yield f"{cases.MANY} cases on {cases.STRIPS} equal strips in one `solve_many`: time for each, and the median gain."
    yield "In a sweep, each case starts from the one before."
    yield ""
    yield "| cases | one thread [ms] | two threads [ms] | gain |"
    yield "|---|---|---|---|"
    for name, entry in results["many"].items():
        yield f"| {name} | {_number(entry['one thread'])} | {_number(entry['two threads'])} | {entry['gain']:.2f} |"
    yield ""


def below(results: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of stress below the surface and life."""
    yield "## Below the surface"
    yield ""
    yield "Below a tilted logarithmic roller on a plate, without the solve; random points down to three half-widths."
    yield ""
    yield "| | one thread [s] | two threads [s] |"
    yield "|---|---|---|"
    for name, entry in results["below"].items():
        yield f"| {name} | {entry['one thread']:.2f} | {entry['two threads']:.2f} |"
    yield ""


def automatic_grid(results: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of solves on the automatic grid, with half-spaces and finite bodies."""
    yield "## Automatic grid"
    yield ""
    yield "*Finite*: both bodies have mirrored faces (at four places of their own) and a depth; solved in turn with"
    yield "half-spaces, with the median ratio. Newton steps are those on the last grid, and on all."
    yield ""
    yield "| case | strips | steps | on all | time [ms] | half-spaces | finite | ratio |"
    yield "|---|---|---|---|---|---|---|---|"
    for name, pair in results["finite"].items():
        solve = [""] * 4
        if alone := results["automatic"].get(name):
            solve = [alone["strips"], alone["steps"], alone["steps on all grids"], _number(alone["time"])]
        cells = (name, *solve, _number(pair["half-spaces"]), _number(pair["finite"]), f"{pair['ratio']:.2f}")
        yield f"| {' | '.join(map(str, cells))} |"
    yield ""


def _ms(seconds: float) -> str:
    return f"{_number(seconds)} ms"


def _number(seconds: float) -> str:
    milliseconds = 1e3 * seconds
    return f"{milliseconds:.0f}" if milliseconds >= 100 else f"{milliseconds:.3g}"


if __name__ == "__main__":
    main()
