"""Do the tests notice? Small mistakes put into the sources one at a time, and what becomes of each.

    python tests/mutation/run.py --rooms bearing measured --count 60 --out out/mutants

Needs NumPy, SciPy, Numba, pytest, hypothesis and mpmath; tests that need more are left out. Each mutant is one change
of one module. Mutants of compiled functions first meet the fast tests with compilation switched off, which spares them
half a minute in the compiler; what that does not catch is compiled, from a copy of the sources, and meets all tests of
its room, as does any other mutant. The mutants and their order depend on the sources and the seed alone.

In the folder given by ``--out`` are, afterwards, ``mutants.jsonl`` with a line for each mutant, ``survivors.md`` and
the tests that were run. A survivor that means the same as the original, or hardly anything else, is explained in
``explained.toml`` beside this file, under its key. The exit status is 1 where of a room a smaller share was caught or
is explained than ``shares.toml`` says, or less than nine in ten where it says nothing.
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
from sitecustomize import FILE, MODULE, TEXT

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCES = ROOT / "src" / "nonhertz"
ENOUGH, NOISE = 0.9, 0.02  # of those that ran, where no share is recorded; and below one that is
# Of a test and of all of a group together, with compilation switched off and with it.
LONGEST_TEST = {True: 1.0, False: 10.0}  # s
LONGEST_ROUND = {True: 25.0, False: 60.0}  # s
SLOWED = 4.0  # by other programs: waited for so many times as long as the processor is needed
FINDING_OUT = 300.0  # s, for the tests of a group on the sources as they are
COMPILING = 240.0  # s, added to the time of the tests before a compiled mutant is taken to hang


@dataclass(frozen=True)
class Group:
    """Sources of a room, and the tests that should notice."""

    sources: tuple[str, ...]
    tests: tuple[str, ...]


def of(folder: str, names: str) -> tuple[str, ...]:
    """Return files of tests."""
    return tuple(f"{folder}/test_{name}.py" for name in names.split())


GROUPS = {
    "strip": Group(
        ("strip/*.py",),
        (
            *of("unit", "element influence linear newton settle start levels grid many edge solve_input acceptance"),
            *of("property", "solution_properties"),
            *of("convergence", "error_estimate orders"),
            *of("validation", "reference_half_space paper_regression"),
        ),
    ),
    "bodies": Group(
        ("bodies/*.py", "bodies/*/*.py"),
        (
            *of("unit", "side_faces_and_depth newton influence edge subsurface"),
            *of("property", "solution_properties"),
            *of("validation", "finite_bodies"),
        ),
    ),
    "subsurface": Group(
        ("subsurface/*.py",),
        (*of("unit", "subsurface* lamination life"), *of("property", "stress_*")),
    ),
    "life": Group(("life/*.py",), (*of("unit", "life*"), *of("validation", "life_published claims"))),
    "solver": Group(
        ("solver/*.py",),
        (*of("unit", "many portions solutions_file solve_input data levels"), *of("golden", "golden")),
    ),
    "result": Group(
        ("result/*.py",),
        (
            *of("unit", "acceptance brief corner data edge free_end gradient many penetration reading solve_input"),
            *of("unit", "nomenclature quarter_space"),
            *of("app", "nodes_command"),
            *of("property", "solution_properties"),
            *of("convergence", "error_estimate"),
            *of("golden", "golden"),
        ),
    ),
    "patch": Group(
        ("patch/*.py",),
        (*of("unit", "patch_*"), *of("property", "patch_properties"), *of("convergence", "patch_orders")),
    ),
    "maps": Group(("maps/*.py",), (*of("unit", "maps"), *of("app", "map_command"), *of("golden", "golden"))),
    "measured": Group(
        ("measured/*.py",),
        (*of("unit", "measured_*"), *of("property", "measured_properties"), *of("app", "profile_command")),
    ),
    "bearing": Group(
        ("bearing/*.py",), (*of("unit", "bearing_*"), *of("validation", "bearing"), *of("golden", "golden"))
    ),
    "study": Group(
        ("study/*.py",),
        (
            *of("unit", "sweep tolerance design planfile"),
            *of("app", "sweep_command tolerance_command design_command"),
            *of("golden", "golden"),
        ),
    ),
    "io": Group(
        ("io/*.py", "io/*/*.py"),
        (
            *of(
                "unit", "casefile bearingfile planfile traces units written bounds drafts paths spreads profile_tables"
            ),
            *of("unit", "material measured_table title_block"),
            *of("app", "bearing_command compare_command life_command nodes_command profile_command stress_command"),
            *of("app", "bad_input schemas several_cases set_option workbooks"),
            *of("property", "units_read"),
            *of("golden", "golden"),
        ),
    ),
}


@dataclass
class Round:
    """Tests of one group that pass on the sources as they are, and how they are run."""

    tests: Path
    seconds: float
    interpreted: bool

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
        After which no further mutant is begun.
    """

    def __init__(self, out: Path, workers: int, seconds: float) -> None:
        self.out, self.workers = out, workers
        self.end = time.monotonic() + seconds
        self.scratch = Path(tempfile.mkdtemp(prefix="mutants-"))
        self.explained = explanations()
        self.rounds: dict[tuple[str, bool], Round] = {}

    def prepare(self, mutants: list[tuple[str, Mutant]]) -> None:
        """Find which tests of their rooms pass on the sources as they are, and how long they take."""
        wanted = sorted(
            {(room, False) for room, _ in mutants} | {(room, True) for room, each in mutants if each.compiled}
        )
        with ThreadPoolExecutor(self.workers) as pool:
            for key, found in zip(wanted, pool.map(lambda key: self._round(*key), wanted), strict=True):
                self.rounds[key] = found

    def _round(self, name: str, interpreted: bool) -> Round:
        label = f"{name}-{'interpreted' if interpreted else 'compiled'}"
        folder = self.scratch / label
        folder.mkdir()
        files = sorted({str(path) for pattern in GROUPS[name].tests for path in (ROOT / "tests").glob(pattern)})
        if interpreted:  # solves take seconds then: hundreds of them would use up the time and leave no fast test
            files = [file for file in files if Path(file).parent.name == "unit"]
        written = self.out / f"{label}.jsonl"
        written.unlink(missing_ok=True)
        names = {WRITTEN: str(written)} | ({LONGEST: str(LONGEST_TEST[True])} if interpreted else {})
        self._pytest(folder, interpreted, files, names, ["--continue-on-collection-errors"], FINDING_OUT)
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
        return Round(tests, total, interpreted)

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
            original, written = SOURCES / mutant.path, folder / "results.jsonl"
            text = mutant.applied(original.read_text(encoding="utf-8"))
            names = {CHOSEN: str(of.tests), WRITTEN: str(written)}
            if mutant.compiled and not of.interpreted:
                whole = folder / "src" / "nonhertz"
                shutil.copytree(SOURCES, whole, ignore=shutil.ignore_patterns("__pycache__", "static"))
                (whole / mutant.path).write_text(text, encoding="utf-8")
            else:
                (folder / "changed.py").write_text(text, encoding="utf-8")
                name = ".".join(("nonhertz", *Path(mutant.path).with_suffix("").parts)).removesuffix(".__init__")
                names |= {MODULE: name, FILE: str(original), TEXT: str(folder / "changed.py")}
            tests = json.loads(of.tests.read_text(encoding="utf-8"))
            files = sorted({str(ROOT / test.partition("::")[0]) for test in tests})
            code = self._pytest(folder, of.interpreted, files, names, ["--exitfirst"], of.limit)
            if code is None:
                return "caught", f"time-out of {of.limit:.0f} s"
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
            "PYTHONPATH": os.pathsep.join([str(folder / "src"), str(SOURCES.parent), str(HERE)]),
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
                if sys.platform == "linux":  # of processor time: on a busy machine no mutant counts as one that hangs
                    import resource

                    resource.prlimit(process.pid, resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 1))
                code = process.wait(SLOWED * limit)
                return None if code in (-signal.SIGXCPU, -signal.SIGKILL) else code
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


def plan(rooms: list[str], count: int, seed: int) -> list[tuple[str, Mutant]]:
    """Return so many mutants of each room in their order, each with its room."""
    found = []
    for name in rooms:
        paths = sorted(path for pattern in GROUPS[name].sources for path in SOURCES.glob(pattern))
        everything = [each for path in paths for each in mutants(path, path.relative_to(SOURCES).as_posix())]
        found += [(name, each) for each in chosen(everything, count, seed)]
    return found


def summary(found: list[dict[str, Any]]) -> tuple[str, bool]:
    """Return a page of what became of the mutants, and whether in every room enough were caught or are explained."""
    recorded = tomllib.loads((HERE / "shares.toml").read_text(encoding="utf-8"))
    page, enough = [], True
    for room in dict.fromkeys(each["group"] for each in found):
        count = Counter(each["status"] for each in found if each["group"] == room)
        ran, caught = count.total() - count["not run"], count["caught"] + count["explained"]
        before = recorded.get(room)
        least = before["caught"] / before["sampled"] - NOISE if before else ENOUGH
        lower = caught < least * ran
        enough &= not lower
        told = f"{room}: {caught} of {ran} caught or explained, {caught / max(ran, 1):.1%}"
        page.append(f"{told}, less than the {least:.1%} that it has to be" if lower else told)
    page += [""] + [
        f"- {each['status']}, line {each['line']}: `{each['key']}`"
        for each in found
        if each["status"] in ("survived", "not run")
    ]
    return "\n".join(page) + "\n", enough


def main() -> int:
    """Run the mutants that are asked for."""
    parser = argparse.ArgumentParser(description="Put small mistakes into the sources and see whether tests notice.")
    parser.add_argument("--rooms", nargs="+", default=list(GROUPS), choices=GROUPS, help="all of them by default")
    parser.add_argument("--count", type=int, default=60, help="mutants in each room")
    parser.add_argument("--seed", type=int, default=1, help="of the choice")
    parser.add_argument("--only", default="", help="run those alone whose key contains this")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--seconds", type=float, default=36_000.0, help="after which no more is begun")
    parser.add_argument("--out", type=Path, default=Path("out/mutants"), help="folder for what is found")
    parser.add_argument("--list", action="store_true", help="print the list and run nothing")
    asked = parser.parse_args()
    wanted = [pair for pair in plan(asked.rooms, asked.count, asked.seed) if asked.only in pair[1].key]
    if asked.list:
        print("\n".join(mutant.key for _, mutant in wanted))
        return 0
    asked.out.mkdir(parents=True, exist_ok=True)
    campaign = Campaign(asked.out.resolve(), asked.workers, asked.seconds)
    try:
        campaign.prepare(wanted)
        page, enough = summary(campaign.run(wanted))
    finally:
        shutil.rmtree(campaign.scratch, ignore_errors=True)
    (asked.out / "survivors.md").write_text(page, encoding="utf-8")
    print(page, end="")
    return 0 if enough else 1


if __name__ == "__main__":
    sys.exit(main())
