"""Speed against an earlier revision, on the same cases in turn.

    python benchmarks/against.py REVISION [--rounds N]

Both revisions run in processes of their own that solve when they are told to, so that neither has the machine on a
better day. Ratios are medians of pairs.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from machine import machine

ROOT = Path(__file__).parents[1]
# Of either revision, whose own benchmarks know the cases by the same names.
WORKER = """
import sys, time
sys.path.insert(0, sys.argv[1] + "/benchmarks")
import cases
with cases.one_thread():
    solves = {f"{cases.STRIPS} equal strips": cases.fixed(cases.STRIPS), "161 equal strips": cases.fixed(161)}
    solves |= {f"automatic: {name}": solve for name, solve in cases.automatic().items()}
    for solve in solves.values():
        solve()
    print("|".join(solves), flush=True)
    for line in sys.stdin:
        solve = solves[line.strip()]
        start = time.perf_counter()
        for _ in range(5):
            solve()
        print((time.perf_counter() - start) / 5, flush=True)
"""


def main() -> None:
    """Measure and print."""
    asked = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    asked.add_argument("revision", help="what to compare with, as git knows it")
    asked.add_argument("--rounds", type=int, default=25)
    options = asked.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        before = Path(folder) / "before"
        subprocess.run(["git", "worktree", "add", "--detach", before, options.revision], cwd=ROOT, check=True)
        try:
            results = measured(before, options.rounds)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", before], cwd=ROOT, check=True)
    results["revision"] = git("rev-parse", "--short", options.revision)
    results["date"] = git("log", "-1", "--format=%as", options.revision)
    print("\n".join(page(results)))


def measured(before: Path, rounds: int) -> dict[str, Any]:
    """Return median times of both revisions and the median of their ratios."""
    workers = [Worker(before), Worker(ROOT)]
    times: dict[str, list[tuple[float, ...]]] = {name: [] for name in workers[1].names if name in workers[0].names}
    for _ in range(rounds):
        for name, pairs in times.items():
            pairs.append(tuple(worker.time(name) for worker in workers))
    for worker in workers:
        worker.end()
    return {
        "machine": machine(),
        "cases": {
            name: {
                "before": float(np.median(pairs, axis=0)[0]),
                "now": float(np.median(pairs, axis=0)[1]),
                "ratio": float(np.median([old / new for old, new in pairs])),
            }
            for name, pairs in times.items()
        },
    }


class Worker:
    """A process that solves cases of one checkout when told to."""

    def __init__(self, checkout: Path) -> None:
        environment = os.environ | {"PYTHONPATH": str(checkout / "src"), "OMP_NUM_THREADS": "1"}
        command = [sys.executable, "-c", WORKER, str(checkout)]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
        )
        self.names = self._line().split("|")

    def time(self, name: str) -> float:
        """Return the time of a solve [s]."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{name}\n")
        self._process.stdin.flush()
        return float(self._line())

    def end(self) -> None:
        """Let the process end."""
        self._process.communicate()

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()


def git(*words: str) -> str:
    """Return what git says."""
    return subprocess.run(["git", *words], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def page(results: dict[str, Any]) -> list[str]:
    """Return what was measured as lines of Markdown."""
    computer = results["machine"]
    lines = [
        f"Before: {results['revision']} of {results['date']}. {computer['processor']}, {computer['cores']} cores,",
        f"load average {computer['load']} at the start; one thread, medians.",
        "",
        "| case | before | now | before / now |",
        "|---|---|---|---|",
    ]
    for name, entry in results["cases"].items():
        lines.append(
            f"| {name} | {1e3 * entry['before']:.3g} ms | {1e3 * entry['now']:.3g} ms | {entry['ratio']:.2f} |"
        )
    return lines


if __name__ == "__main__":
    main()
