"""Do the tests notice? Small mistakes put into the sources one at a time, and what becomes of each.

    python tests/mutation/run.py --workers 16 --seconds 540 --out out/mutants

Needs NumPy, SciPy, Numba, pytest, hypothesis and mpmath; tests that need more are left out. Each mutant is a copy of
the sources with one change. Mutants of compiled functions first meet the fast tests with compilation switched off,
which spares them half a minute in the compiler; what that does not catch is compiled and meets all tests of its group,
as does any other mutant. The mutants and their order depend on the sources and the seed alone.

Where the time is not enough, ``--first`` and ``--last`` run slices of the list, each into a folder of its own. In the
folder given by ``--out`` are, afterwards, ``mutants.jsonl`` with a line for each mutant, ``survivors.md`` and
the tests that were run. A survivor that means the same as the original, or hardly anything else, is explained in
``explained.toml`` beside this file, under its key. The exit status is 1 where less than nine in ten of those that ran
were caught or are explained.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mutants import Mutant, chosen, mutants
from selection import CHOSEN, LONGEST, WRITTEN

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCES = ROOT / "src" / "nonhertz"
ENOUGH = 0.9  # of those that ran
# Of a test and of all of a group together, with compilation switched off and with it.
LONGEST_TEST = {True: 1.0, False: 10.0}  # s
LONGEST_ROUND = {True: 25.0, False: 60.0}  # s
FINDING_OUT = 300.0  # s, for the tests of a group on the sources as they are
COMPILING = 240.0  # s, added to the time of the tests before a compiled mutant is taken to hang


@dataclass(frozen=True)
class Group:
    """Sources, how many of 200 mutants they get, and the tests that should notice."""

    sources: tuple[str, ...]
    share: int
    tests: tuple[str, ...]


GROUPS = {
    "strip": Group(
        ("strip/*.py",),
        80,
        (
            *(f"unit/test_{name}.py" for name in ("element", "influence", "linear", "newton", "settle", "start")),
            *(f"unit/test_{name}.py" for name in ("levels", "grid", "many", "edge", "solve_input", "acceptance")),
            "property/test_solution_properties.py",
            "convergence/test_error_estimate.py",
            "convergence/test_orders.py",
            "validation/test_reference_half_space.py",
            "validation/test_paper_regression.py",
        ),
    ),
    "bodies": Group(
        ("bodies/*.py", "bodies/*/*.py"),
        30,
        (
            *(f"unit/test_{name}.py" for name in ("side_faces_and_depth", "newton", "influence", "edge", "subsurface")),
            "property/test_solution_properties.py",
            "validation/test_finite_bodies.py",
            "validation/test_claims.py",
        ),
    ),
    "subsurface": Group(
        ("subsurface/*.py",),
        55,
        ("unit/test_subsurface*.py", "unit/test_lamination.py", "unit/test_life.py", "property/test_stress_*.py"),
    ),
    "life": Group(
        ("life/*.py",), 35, ("unit/test_life*.py", "validation/test_life_published.py", "validation/test_claims.py")
    ),
}


@dataclass
class Round:
    """Tests of one group that pass on the sources as they are, and how they are run."""

    tests: Path
    seconds: float
    interpreted: bool
    sources: Path

    @property
    def limit(self) -> float:
        """Seconds after which a mutant is taken to hang."""
        return 15.0 + 3.0 * self.seconds + (0.0 if self.interpreted else COMPILING)


class Campaign:
    """One run over a list of mutants.

    Parameters
    ----------
    out : Path
        Folder for what is found.
    workers : int
        Mutants at a time.
    seconds : float
        After which no further mutant is begun, and those under way are ended.
    """

    def __init__(self, out: Path, workers: int, seconds: float) -> None:
        self.out, self.workers = out, workers
        self.end = time.monotonic() + seconds
        self.scratch = Path(tempfile.mkdtemp(prefix="mutants-"))
        self.explained = explanations()
        self.rounds: dict[tuple[str, bool], Round] = {}

    def prepare(self, names: set[str]) -> None:
        """Find which tests pass on the sources as they are, and how long they take."""
        wanted = [(name, interpreted) for name in sorted(names) for interpreted in (True, False)]
        with ThreadPoolExecutor(self.workers) as pool:
            for key, found in zip(wanted, pool.map(lambda key: self._round(*key), wanted), strict=True):
                self.rounds[key] = found

    def _round(self, name: str, interpreted: bool) -> Round:
        label = f"{name}-{'interpreted' if interpreted else 'compiled'}"
        sources = self.scratch / label
        copied(sources)
        files = sorted({str(path) for pattern in GROUPS[name].tests for path in (ROOT / "tests").glob(pattern)})
        if interpreted:  # solves take seconds then: hundreds of them would use up the time and leave no fast test
            files = [file for file in files if Path(file).parent.name == "unit"]
        written = self.out / f"{label}.jsonl"
        written.unlink(missing_ok=True)
        names = {WRITTEN: str(written)} | ({LONGEST: str(LONGEST_TEST[True])} if interpreted else {})
        self._pytest(sources, interpreted, files, names, ["--continue-on-collection-errors"], FINDING_OUT)
        ended = lines(written)
        failed = {each["test"] for each in ended if each["outcome"] != "passed"}
        passed = {each["test"]: each["seconds"] for each in ended if each["test"] not in failed}
        passed = fastest(passed, interpreted)
        of_file = Counter()
        for test, seconds in passed.items():
            of_file[test.partition("::")[0]] += seconds
        # The quickest file first, and its fixtures made once.
        order = sorted(
            passed, key=lambda test: (of_file[test.partition("::")[0]], test.partition("::")[0], passed[test])
        )
        tests = self.out / f"{label}.json"
        tests.write_text(json.dumps(order, indent=1), encoding="utf-8")
        total = sum(passed.values())
        print(f"{label}: {len(passed)} tests in {total:.0f} s; {len(failed)} left out", flush=True)
        if not passed:
            raise SystemExit(f"No test of {label} passes on the sources as they are.")
        return Round(tests, total, interpreted, sources)

    def fate(self, group: str, mutant: Mutant) -> dict[str, Any]:
        """Return what became of a mutant."""
        begun = time.monotonic()
        found: dict[str, Any] = {"key": mutant.key, "group": group, "line": mutant.line, "compiled": mutant.compiled}
        status, by = "survived", ""
        for interpreted in (True, False) if mutant.compiled else (False,):
            if time.monotonic() >= self.end:
                status = "not run"
                break
            status, by = self._tried(self.rounds[group, interpreted], mutant)
            if status != "survived":
                break
        if status == "survived" and mutant.key in self.explained:
            status, by = "explained", self.explained[mutant.key]
        return found | {"status": status, "by": by, "seconds": round(time.monotonic() - begun, 1)}

    def _tried(self, of: Round, mutant: Mutant) -> tuple[str, str]:
        folder = Path(tempfile.mkdtemp(dir=self.scratch))
        try:
            copied(folder, of.sources if not mutant.compiled else None)
            changed = folder / "src" / "nonhertz" / mutant.path
            stamp = changed.stat()
            changed.write_text(mutant.applied(changed.read_text(encoding="utf-8")), encoding="utf-8")
            if not mutant.compiled:  # what is compiled stays as it was
                os.utime(changed, ns=(stamp.st_atime_ns, stamp.st_mtime_ns))
            tests = json.loads(of.tests.read_text(encoding="utf-8"))
            files = sorted({str(ROOT / test.partition("::")[0]) for test in tests})
            written = folder / "results.jsonl"
            names = {CHOSEN: str(of.tests), WRITTEN: str(written)}
            left = self.end - time.monotonic()
            code = self._pytest(folder, of.interpreted, files, names, ["--exitfirst"], min(of.limit, left))
            if code is None:
                return ("caught", f"time-out of {of.limit:.0f} s") if left > of.limit else ("not run", "out of time")
            if code == 0:
                return "survived", ""
            failed = [each["test"] for each in lines(written) if each["outcome"] == "failed"]
            return "caught", failed[0] if failed else "the import"
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _pytest(
        self, folder: Path, interpreted: bool, files: list[str], names: dict[str, str], options: list[str], limit: float
    ) -> int | None:
        """Return the exit status of the tests with the sources in ``folder``, None past the limit."""
        environment = os.environ | names | {
            "PYTHONPATH": os.pathsep.join([str(folder / "src"), str(HERE)]),
            "PYTHONDONTWRITEBYTECODE": "1",
            "NUMBA_DISABLE_JIT": "1" if interpreted else "0",
            # Each uses one core; the workers share the machine.
            **dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS"), "1"),
        }  # fmt: skip
        command = [
            sys.executable, "-m", "pytest", "-p", "selection", "-c", str(ROOT / "pyproject.toml"),
            "--rootdir", str(ROOT), "--hypothesis-seed=0", "-q", "--tb=no", "--no-header", *options, *files,
        ]  # fmt: skip
        if interpreted:
            # Compiled code divides by zero without a word, as the array library does not.
            command += ["-W", "ignore::RuntimeWarning"]
        # Hypothesis keeps its examples where it is started.
        with (folder / "output.txt").open("w") as output:
            process = subprocess.Popen(
                command, cwd=folder, env=environment, stdout=output, stderr=subprocess.STDOUT, start_new_session=True
            )
            try:
                return process.wait(limit)
            except subprocess.TimeoutExpired:
                return None
            finally:
                with_its_children_ended(process)

    def run(self, wanted: list[tuple[str, Mutant]]) -> list[dict[str, Any]]:
        """Return what became of all mutants, written down one by one."""
        found = []
        with ThreadPoolExecutor(self.workers) as pool, (self.out / "mutants.jsonl").open("w", encoding="utf-8") as file:
            under_way = [pool.submit(self.fate, *pair) for pair in wanted]
            for number, done in enumerate(as_completed(under_way), start=1):
                fate = done.result()
                file.write(json.dumps(fate, ensure_ascii=False) + "\n")
                file.flush()
                print(f"{number}/{len(wanted)} {fate['status']:9s} {fate['seconds']:6.1f} s  {fate['key']}", flush=True)
                found.append(fate)
        return sorted(found, key=lambda fate: (list(GROUPS).index(fate["group"]), fate["key"]))


def with_its_children_ended(process: subprocess.Popen[bytes]) -> None:
    """End a process and all that it has started."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def copied(folder: Path, sources: Path | None = None) -> None:
    """Copy the sources, with machine code that was made for them if they come from elsewhere than the repository."""
    ignored = ["*.pyc", "static", *([] if sources else ["__pycache__"])]
    origin = sources / "src" / "nonhertz" if sources else SOURCES
    shutil.copytree(origin, folder / "src" / "nonhertz", ignore=shutil.ignore_patterns(*ignored))


def lines(path: Path) -> list[dict[str, Any]]:
    """Return what the plugin wrote down."""
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []


def fastest(seconds: dict[str, float], interpreted: bool) -> dict[str, float]:
    """Return the tests that are quick enough, as many as fit into a round."""
    kept, total = {}, 0.0
    for test in sorted(seconds, key=lambda each: seconds[each]):
        total += seconds[test]
        if seconds[test] > LONGEST_TEST[interpreted] or total > LONGEST_ROUND[interpreted]:
            break
        kept[test] = seconds[test]
    return kept


def explanations() -> dict[str, str]:
    """Return why survivors are no mistakes, by their keys."""
    table = tomllib.loads((HERE / "explained.toml").read_text(encoding="utf-8"))
    return {key: reason for reason_of in table.values() for key, reason in reason_of.items()}


def plan(count: int, seed: int) -> list[tuple[str, Mutant]]:
    """Return the mutants of a run in their order, each with its group."""
    found = []
    for name, group in GROUPS.items():
        paths = sorted(path for pattern in group.sources for path in SOURCES.glob(pattern))
        everything = [each for path in paths for each in mutants(path, path.relative_to(SOURCES).as_posix())]
        found += [(name, each) for each in chosen(everything, round(count * group.share / 200), seed)]
    return found


def summary(found: list[dict[str, Any]]) -> tuple[str, float]:
    """Return a page of what became of the mutants, and the share caught or explained of those that ran."""
    count = Counter(each["status"] for each in found)
    ran = len(found) - count["not run"]
    share = (count["caught"] + count["explained"]) / max(ran, 1)
    told = ", ".join(f"{number} {status}" for status, number in sorted(count.items()))
    page = [f"{len(found)} mutants: {told}. Caught or explained of those that ran: {share:.1%}.", ""]
    page += [
        f"- {each['status']}, line {each['line']}: `{each['key']}`"
        for each in found
        if each["status"] in ("survived", "not run")
    ]
    return "\n".join(page) + "\n", share


def main() -> int:
    """Run the mutants that are asked for."""
    parser = argparse.ArgumentParser(description="Put small mistakes into the sources and see whether tests notice.")
    parser.add_argument("--count", type=int, default=200, help="mutants in the list")
    parser.add_argument("--seed", type=int, default=1, help="of the choice")
    parser.add_argument("--first", type=int, default=1, help="number of the first mutant to run")
    parser.add_argument("--last", type=int, default=None, help="number of the last")
    parser.add_argument("--only", default="", help="run those alone whose key contains this")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--seconds", type=float, default=36_000.0, help="after which no more is begun")
    parser.add_argument("--out", type=Path, default=Path("out/mutants"), help="folder for what is found")
    parser.add_argument("--list", action="store_true", help="print the list and run nothing")
    asked = parser.parse_args()
    wanted = plan(asked.count, asked.seed)[asked.first - 1 : asked.last]
    wanted = [pair for pair in wanted if asked.only in pair[1].key]
    if asked.list:
        print("\n".join(mutant.key for _, mutant in wanted))
        return 0
    asked.out.mkdir(parents=True, exist_ok=True)
    campaign = Campaign(asked.out.resolve(), asked.workers, asked.seconds)
    try:
        campaign.prepare({name for name, _ in wanted})
        page, share = summary(campaign.run(wanted))
    finally:
        shutil.rmtree(campaign.scratch, ignore_errors=True)
    (asked.out / "survivors.md").write_text(page, encoding="utf-8")
    print(page, end="")
    return 0 if share >= ENOUGH else 1


if __name__ == "__main__":
    sys.exit(main())
