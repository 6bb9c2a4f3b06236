"""The race: strips, the plane grid and other programs on the same contacts. Writes docs/benchmarks/race.{json,md,svg}.

    python benchmarks/race.py [--threads N] [--quick] [--page]

Everything in one run on the same number of threads; every program is stopped at the same distance from the solution
of its own equations. Takes some fifteen minutes; leave the machine alone meanwhile. The paper quotes it: run
paper/figures.py afterwards.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Collection
from pathlib import Path
from typing import Any

import accuracy_reached
import entrants
import one_run
import race_figures
import race_page
import races
from machine import machine

from nonhertz.plot import save

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "docs" / "benchmarks"
ACCURACIES = ("1e-3", "5e-4", "2.5e-4", "1e-4", "1e-5")
ON_AUTOMATIC = tuple(entrants.AUTOMATIC + entrants.TO + each for each in ACCURACIES)
DEFAULT = entrants.AUTOMATIC + entrants.TO + "1e-4"
LEARNT = tuple(entrants.LEARNT + entrants.TO + each for each in ACCURACIES)
STRIPS = {
    "strips: semi-elliptic": (*ON_AUTOMATIC, 11, 21, 41, 81, 161, 321),
    "strips: parabolic": (DEFAULT, 41),
    "batch: semi-elliptic": (*LEARNT, *ON_AUTOMATIC, 21, 41, 81, 161),
}
# Cells four and sixteen times as many along as across: contacts are long, and a narrow peak at an end wants the latter.
CELLS = [(8, 32), (16, 64), (24, 96), (32, 128), (16, 256), (24, 384), (64, 256), (32, 512), (128, 512), (64, 1024)]
SQUARE_CELLS = [(count, count) for count in (32, 64, 96, 128, 192, 256, 384, 512, 768, 1024)]
FULL_SIZE, FULL_RACE = (512, 1024), "crowned"
QUICK_CELLS, QUICK_SQUARE, QUICK_STRIPS, QUICK_FULL = [(16, 64)], [(64, 64)], (DEFAULT, 21), (16, 64)
PLAYOFF_CELLS = {"ContactMechanics": (64, 256), "ASPHER": (256, 256)}
JUDGES = ("ContactMechanics: with restart", "tamaas", "patch")
LONGEST = 1.0  # s, for the repeats of a run
MARGIN = 1.4  # iterations grow with the grid
THREADS = ("OMP", "OPENBLAS", "MKL", "VECLIB_MAXIMUM", "NUMEXPR")


def main() -> None:
    """Race and write."""
    asked = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    asked.add_argument("--threads", type=int, default=1)
    asked.add_argument("--quick", action="store_true", help="coarse grids only, to see that everything runs")
    asked.add_argument("--page", action="store_true", help="write the page again from what race.json holds")
    options = asked.parse_args()
    if options.page:
        write_page(FOLDER, json.loads((FOLDER / "race.json").read_text(encoding="utf-8")))
        return
    results = raced(options.threads, options.quick)
    folder = ROOT / "out" / "race" if options.quick else FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "race.json").write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    for name, figure in race_figures.figures(results).items():
        save(figure, folder / name)
    write_page(folder, results)
    print(f"wrote {folder.relative_to(ROOT)} in {results['seconds']:.0f} s")


def write_page(folder: Path, results: dict[str, Any]) -> None:
    """Write the page on results that were measured now or before."""
    (folder / "race.md").write_text("\n".join(race_page.page(results)), encoding="utf-8")


def raced(threads: int, quick: bool) -> dict[str, Any]:
    """Return all that was measured."""
    start, absent = time.perf_counter(), entrants.missing()
    results: dict[str, Any] = {
        "machine": machine() | {"threads": threads, "peers": entrants.versions()},
        "missing": absent,
        "algebraic": {"approach": one_run.APPROACH_TARGET, "pressure": one_run.PRESSURE_TARGET},
        "batch": {"cases": entrants.BATCH, "range": entrants.LOAD_RANGE},
        "races": {},
    }
    track = Track(threads, quick, absent)
    entered = races.all_races()
    entered = {FULL_RACE: entered[FULL_RACE]} if quick else entered
    track.play_off(entered)
    results["play-off"] = {"entries": track.playoffs, "winners": track.winners}
    for name, race in entered.items():
        results["races"][name] = {
            "entries": track.run(name),
            "title": race.title,
            "load": race.load,
            "tilt": race.tilt,
            "region": race.region,
            "answer": race.answer,
            "uncertainty": race.uncertainty,
            "source": race.source,
        }
    results["full size"] = {"race": FULL_RACE, "entries": track.full_size(FULL_RACE)}
    results["failures"] = track.failures
    results["headlines"] = accuracy_reached.headlines(results)
    results["seconds"] = time.perf_counter() - start
    return results


class Track:
    """Where runs are made: the programs that are there, how many threads they get, and what has been tuned so far."""

    def __init__(self, threads: int, quick: bool, absent: dict[str, str]) -> None:
        self.threads, self.quick = threads, quick
        self.plane = [name for name in entrants.PLANE if name not in absent]
        self.lines = {name: grids for name, grids in STRIPS.items() if name.partition(":")[0] not in absent}
        # Whose converged solution the others are held against: a peer's, so that ours is checked by it.
        self.judges = [name for name in JUDGES if name.partition(":")[0] in self.plane]
        self.tolerance: dict[str, float] = {}
        self.failures: list[str] = []
        self.playoffs: list[dict[str, Any]] = []
        self.winners: dict[str, str] = {}
        self.scratch = tempfile.TemporaryDirectory()

    def play_off(self, names: Collection[str]) -> None:
        """Choose among the solvers of a program the one that takes least for all contacts together."""
        for program in (each for each in entrants.SOLVERS if each in self.plane):
            cells = self.ladder(program)[-1] if self.quick else PLAYOFF_CELLS[program]
            taken: dict[str, list[float]] = {}
            for name in names:
                self.tolerance = {}
                self.converge(name, [cells])
                for solver in entrants.SOLVERS[program][: 1 if self.quick else None]:
                    if entry := self.run_of(f"{program}: {solver}", name, cells):
                        self.playoffs.append({"race": name} | entry)
                        taken.setdefault(entry["entrant"], []).append(entry["fastest"])
            finished = {entrant: sum(times) for entrant, times in taken.items() if len(times) == len(names)}
            self.winners[program] = min(finished, key=finished.__getitem__)

    def run(self, name: str) -> list[dict[str, Any]]:
        """Return the entries of a race."""
        self.tolerance = {}
        entries: list[dict[str, Any] | None] = []
        for program, grids in self.lines.items():
            chosen = [grid for grid in grids if not self.quick or grid in QUICK_STRIPS]
            entries += [self.run_of(program, name, grid) for grid in chosen]
        for program in self.plane:
            for grid in self.ladder(program):
                entries.append(self.unless_dear(self.winners.get(program, program), name, grid, entries))
        return [entry for entry in entries if entry]

    def ladder(self, program: str) -> list[entrants.Cells]:
        """Return the grids of a program, from coarse to fine."""
        if program == "ASPHER":
            return QUICK_SQUARE if self.quick else SQUARE_CELLS
        return QUICK_CELLS if self.quick else CELLS

    def unless_dear(
        self, entrant: str, name: str, cells: entrants.Cells, entries: list[dict[str, Any] | None]
    ) -> dict[str, Any] | None:
        """Return an entry, or nothing where the program's last ones say that it would take too long."""
        size = cells[0] * cells[1]
        before = [entry for entry in entries if entry and entry["entrant"] == entrant]
        expected = max((MARGIN * e["time"] * size / (e["grid"][0] * e["grid"][1]) for e in before[-2:]), default=0.0)
        if expected > entrants.DEAREST:
            return None
        self.converge(name, [cells])
        return self.run_of(entrant, name, cells)

    def full_size(self, name: str) -> list[dict[str, Any]]:
        """Return one large grid with every program that can have it: with cells that are not square."""
        cells = QUICK_FULL if self.quick else FULL_SIZE
        self.tolerance = {}
        # The last judge is ours where it is there, to save a minute; peers that disagreed with it would fail.
        self.converge(name, [cells], judge=-1)
        programs = [self.winners.get(each, each) for each in self.plane if each != "ASPHER"]
        return [entry for each in programs if (entry := self.run_of(each, name, cells, start=1e-4))]

    def run_of(self, entrant: str, name: str, grid: Any, start: float = one_run.LOOSEST) -> dict[str, Any] | None:
        """Return one entry, or nothing where the program fails."""
        plane = isinstance(grid, tuple)
        asked = {
            "entrant": entrant,
            "race": name,
            "grid": grid,
            "threads": self.threads,
            "limit": self.limit(name, grid) if plane else None,
            # Two notches looser than a coarser grid needed: what it needs itself is found from there.
            "tolerance": self.tolerance.get(entrant, start),
            "longest": 0.1 if self.quick else LONGEST,
        }
        entry = self.in_a_process(asked)
        if entry and plane:
            self.tolerance[entrant] = min(one_run.LOOSEST, entry["tolerance"] * one_run.NOTCH**2)
        return entry

    def converge(self, name: str, grids: list[entrants.Cells], judge: int = 0) -> None:
        """Solve the equations on these grids far beyond what is asked, once for all programs."""
        grids = [grid for grid in grids if not Path(self.limit(name, grid)).exists()]
        if self.judges and grids:
            asked = {"entrant": self.judges[judge], "race": name, "grids": grids, "threads": self.threads}
            self.in_a_process(asked | {"write": [self.limit(name, grid) for grid in grids]})

    def limit(self, name: str, grid: entrants.Cells) -> str:
        """Return where the converged solution on a grid is kept."""
        return str(Path(self.scratch.name) / f"{name} {grid[0]} {grid[1]}.npy")

    def in_a_process(self, asked: dict[str, Any]) -> dict[str, Any] | None:
        """Return what a run wrote; of one that failed its last words are kept."""
        environment = os.environ | {f"{name}_NUM_THREADS": str(self.threads) for name in THREADS}
        spoken = {"input": json.dumps(asked), "capture_output": True, "text": True}
        ended = subprocess.run([sys.executable, one_run.__file__], env=environment, check=False, **spoken)
        label = f"{asked['entrant']}, {asked['race']}, {asked.get('grid', 'all grids')}"
        if ended.returncode:
            last = ended.stderr.strip().splitlines()[-1:] or [f"ended with {ended.returncode}"]
            self.failures.append(f"{label}: {last[0]}")
            print(self.failures[-1], flush=True)
            return None
        found = json.loads(ended.stdout.splitlines()[-1])
        if found:
            print(f"{label}: {1e3 * found['time']:.3g} ms, approach {found['error']['approach']:.1e}", flush=True)
        return found


if __name__ == "__main__":
    main()
