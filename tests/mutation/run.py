"""Do the tests notice? Small mistakes put into the sources one at a time, and what becomes of each.

    python tests/mutation/run.py --rooms bearing measured --count 60 --out out/mutants

First the tests run once, and it is written down which of them runs which line; files of tests that have not changed
since are spared that the next time. Then each mutant, which is one change of one module, meets tests that run its line,
one of each test function first, then others of their files, a few seconds in all; what survives these meets half a
minute more of them, and what no test runs survives at once. A line of a compiled function is not seen, nor one that
runs at the import: it counts as run where Python's code uses what it belongs to. The mutants and their order depend on
the sources and the seed alone.

In the folder given by ``--out`` are, afterwards, ``mutants.jsonl`` with a line for each mutant, ``survivors.md`` and
which tests run which lines. A survivor that means the same as the original, or hardly anything else, is explained in
``explained.toml`` beside this file, under its key. The exit status is 1 where of a room a smaller share was caught or
is explained than ``shares.toml`` says, or less than nine in ten where it says nothing; nothing is begun where a test
fails on the sources as they are.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import functools
import hashlib
import json
import multiprocessing
import os
import shutil
import signal
import sys
import tempfile
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import Any

import selection
from mutants import Mutant, assigned, chosen, is_compiled, mutants
from sitecustomize import FILE, MODULE, TEXT

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCES = ROOT / "src" / "nonhertz"
MACHINE_CODE = SOURCES / "__pycache__" / "machine-code"
ENOUGH, NOISE = 0.9, 0.02  # of those that ran, where no share is recorded; and below one that is
ROUNDS = 12.0, 30.0  # s, of all tests that a mutant meets, and that a survivor meets after them; one may take longer
FINDING_OUT = 60.0, 900.0  # s, for a test and a file of them on the sources as they are
SLOWED = 6.0  # by other programs: waited for so many times as long as the processor is needed
# s, added for what is compiled anew, and for tables that are made anew, before a mutant is taken to hang
COMPILING_TIME = {"subsurface": 40.0, "bodies": 40.0}
MOST_COMPILING, TABLES = 160.0, {"bodies": 100.0, "strip": 40.0}
LOADED = ("numpy", "scipy.linalg", "scipy.optimize", "scipy.special", "numba", "pint", "matplotlib.figure")

ROOMS = "strip bodies subsurface life solver result patch maps measured bearing study files".split()  # noqa: SIM905
# Where tests are; those of page, report and figures are left out.
TESTS = "unit", "property", "convergence", "validation", "app", "golden"
ELSEWHERE = ("web", "report", "plot", "docs", "gallery", "examples", "verify", "serve", "streams", "machine_code")


class Survey:
    """Which tests run a line; ``found`` holds what was found out about each file of tests, without a suffix."""

    def __init__(self, found: list[Path]) -> None:
        import coverage

        self._data, self.seconds = [], {}
        for each in found:
            lines_run = coverage.CoverageData(str(each.with_suffix(".lines")))
            lines_run.read()
            self._data.append(lines_run)
            self.seconds |= json.loads(each.with_suffix(".json").read_text(encoding="utf-8"))["seconds"]
        self._users: dict[str, set[tuple[str, int, str]]] = defaultdict(set)
        for file in sorted(SOURCES.rglob("*.py")):
            for name, line, user in users(ast.parse(file.read_text(encoding="utf-8"))):
                self._users[name].add((file.relative_to(SOURCES).as_posix(), line, user))
        self._using: dict[str, set[str]] = defaultdict(set)  # by themselves
        functions = {test.partition("[")[0] for test in self.seconds}
        for file in {function.partition("::")[0] for function in functions}:
            for node in ast.parse((ROOT / file).read_text(encoding="utf-8")).body:
                function = f"{file}::{getattr(node, 'name', '')}"
                those = {function} if function in functions else {each for each in functions if each.startswith(file)}
                for name, _, _ in users(node):
                    self._using[name] |= those

    @functools.cache  # noqa: B019
    def tests(self, path: str) -> dict[int, set[str]]:
        """Return which tests run each line of a file."""
        found = defaultdict(set)
        for each in self._data:
            for line, names in each.contexts_by_lineno(str(SOURCES / path)).items():
                found[line] |= self.seconds.keys() & set(names)
        return found

    def of(self, mutant: Mutant) -> list[list[str]]:
        """Return the tests that a mutant meets, and those that it meets if it survives them, file by file."""
        places, tests = {(mutant.path, line) for line in range(mutant.statement, mutant.last + 1)}, set()
        if mutant.names:
            places, names = set(), [*mutant.names]
            for name in names:
                for path, line, user in self._users[name]:
                    places |= set() if user else {(path, line)}
                    names += [user] if user and user not in names else []
            using = set().union(*(self._using[name] for name in names))
            tests |= {test for test in self.seconds if test.partition("[")[0] in using}
        tests |= {test for path, line in places for test in self.tests(path)[line]}
        files = {test.partition("::")[0] for test in tests}
        # After them others of their files, which may share what was made on that line.
        beside = {test for test in self.seconds if test.partition("::")[0] in files} - tests
        of_function = Counter()
        ranked = []
        for test in sorted(tests | beside, key=lambda each: (each in beside, self.seconds[each], each)):
            function = test.partition("-" if "/golden/" in test else "[")[0]  # a command's tests differ as functions do
            ranked.append((of_function[function] + (test in beside), self.seconds[test], test))
            of_function[function] += 1
        left, rounds = [test for *_, test in sorted(ranked)], []
        for longest in ROUNDS if left else ():
            total, of_file = 0.0, defaultdict(list)
            for test in left:
                if not of_file or total + self.seconds[test] <= longest:
                    of_file[test.partition("::")[0]].append(test)
                    total += self.seconds[test]
            # The quickest file first, and its fixtures made once.
            quickest = sorted(of_file.values(), key=lambda those: sum(self.seconds[test] for test in those))
            rounds.append([test for those in quickest for test in those])
            # Of functions that it has met once, the quickest cases are the most.
            left = sorted((t for t in left if t not in rounds[-1]), key=lambda t: (t in beside, self.seconds[t]))
        return rounds


def stem_of(file: Path, folder: Path) -> Path:
    """Return where findings about a file of tests lie, without a suffix."""
    return folder / f"{file.parent.name}-{file.stem}"


def users(tree: ast.AST, user: str = "", compiled: bool = False) -> Iterator[tuple[str, int, str]]:
    """Yield names that are used, their lines, and what uses them, if that has to be used in turn to be run."""
    for node in ast.iter_child_nodes(tree):
        within, machine = user, compiled
        if isinstance(node, ast.FunctionDef) and not compiled:
            machine = is_compiled(node)
            within = node.name if machine else ""
        elif isinstance(node, ast.ClassDef):
            within = node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign) and isinstance(tree, ast.Module):
            within = next(iter(assigned(node)), "")
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
            yield node.id, node.lineno, user
        elif isinstance(node, ast.Attribute):
            yield node.attr, node.lineno, user
        yield from users(node, within, machine)


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
        self.seconds: dict[str, float] = {}
        # Each uses one core, the workers share the machine. Numba is set as by the package, since it is loaded before.
        os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
        os.environ["NUMBA_SLP_VECTORIZE"] = "1"
        self.processes = multiprocessing.get_context("forkserver")
        self.processes.set_forkserver_preload(["pytest", *LOADED])

    def survey(self, named: tuple[str, ...]) -> Survey:
        """Find which tests pass on the sources as they are, how long they take, and through which lines they go."""
        folder = self.out / "survey"
        folder.mkdir(exist_ok=True)
        files = [
            file
            for kind in TESTS
            for file in sorted((ROOT / "tests" / kind).glob("test_*.py"))
            if not file.stem.removeprefix("test_").startswith(ELSEWHERE) and file.stem[5:].startswith(named)
        ]
        sources = hashlib.sha256(b"".join(file.read_bytes() for file in sorted(SOURCES.rglob("*.py")))).hexdigest()
        with ThreadPoolExecutor(self.workers) as pool:
            try:
                for done in as_completed([pool.submit(self._surveyed, file, sources) for file in files]):
                    print(done.result(), end="", flush=True)
            finally:
                pool.shutdown(cancel_futures=True)
        # Of files of tests that are no longer there, or are not asked for, it may hold findings as well.
        survey = Survey([stem_of(file, folder) for file in files])
        self.seconds = survey.seconds
        return survey

    def _surveyed(self, file: Path, sources: str) -> str:
        stem = stem_of(file, self.out / "survey")
        state = sources + hashlib.sha256(file.read_bytes()).hexdigest()
        known, data, written = (stem.with_suffix(each) for each in (".json", ".lines", ".jsonl"))
        if known.exists() and json.loads(known.read_text(encoding="utf-8"))["state"] == state:
            return ""
        # Without the tables that are kept on disk, or the lines that make them would not run.
        for each in (known, data, written, *MACHINE_CODE.glob("*-???")):
            each.unlink(missing_ok=True)
        begun = time.monotonic()
        names = {selection.WRITTEN: str(written), selection.LINES: str(data), selection.LONGEST: str(FINDING_OUT[0])}
        code = self._pytest(names, FINDING_OUT[1], ["-m", "not campaign", str(file)])
        ended = lines(written)
        failed = [each["test"] for each in ended if each["outcome"] == "failed"]
        if failed or code in (2, 3, 4):  # it cannot be imported, pytest itself fails, or it is not there
            sys.exit(f"{failed[0] if failed else file} fails on the sources as they are: mend that first.")
        left_out = {each["test"] for each in ended if each["outcome"] != "passed"}
        seconds = {each["test"]: each["seconds"] for each in ended if each["test"] not in left_out}
        known.write_text(json.dumps({"state": state, "seconds": seconds}), encoding="utf-8")
        told = f"{len(seconds)} tests in {sum(seconds.values()):.0f} s; {len(left_out)} left out"
        return f"{stem.name}: {told} ({time.monotonic() - begun:.0f} s)\n"

    def fate(self, room: str, mutant: Mutant, rounds: list[list[str]]) -> dict[str, Any]:
        """Return what became of a mutant."""
        begun = time.monotonic()
        if mutant.key in self.explained:
            status, by = "explained", self.explained[mutant.key]
        elif not rounds:
            status, by = "survived", "no test runs this line"
        elif begun >= self.end:
            status, by = "not run", ""
        else:
            status, by = self._tried(room, mutant, rounds)
        return {
            "key": mutant.key, "room": room, "line": mutant.line, "compiled": mutant.compiled, "status": status,
            "by": by, "seconds": round(time.monotonic() - begun, 1),
        }  # fmt: skip

    def _tried(self, room: str, mutant: Mutant, rounds: list[list[str]]) -> tuple[str, str]:
        with tempfile.TemporaryDirectory(dir=self.scratch, ignore_cleanup_errors=True) as name:
            folder = Path(name)
            original, written = SOURCES / mutant.path, folder / "results.jsonl"
            (folder / "changed.py").write_text(mutant.applied(original.read_text(encoding="utf-8")), encoding="utf-8")
            module = ".".join(("nonhertz", *Path(mutant.path).with_suffix("").parts)).removesuffix(".__init__")
            names = {
                MODULE: module, FILE: str(original), TEXT: str(folder / "changed.py"),
                selection.WRITTEN: str(written), selection.CHOSEN: str(folder / "tests.json"),
            }  # fmt: skip
            # What is compiled of it, or tabulated by it, must not take the place of other machine code and tables.
            names["NUMBA_CACHE_DIR"] = str(folder / "cache")
            with contextlib.suppress(FileNotFoundError):
                shutil.copytree(MACHINE_CODE, folder / "cache" / "nonhertz", copy_function=os.link)
            for tests in filter(None, rounds):
                (folder / "tests.json").write_text(json.dumps(tests), encoding="utf-8")
                limit = 20.0 + 4.0 * sum(self.seconds[test] for test in tests) + TABLES.get(room, 0.0)
                limit += COMPILING_TIME.get(room, MOST_COMPILING) if mutant.compiled else 0.0
                files = dict.fromkeys(str(ROOT / test.partition("::")[0]) for test in tests)
                status = self._pytest(names, limit, ["--exitfirst", *files])
                if status in (None, 3, 4, 5):
                    return "not run", f"{SLOWED * limit:.0f} s did not do" if status is None else "tests not found"
                if status in (-signal.SIGXCPU, -signal.SIGKILL):
                    return "caught", f"time-out of {limit:.0f} s"
                if status:
                    failed = [each["test"] for each in lines(written) if each["outcome"] == "failed"]
                    return "caught", failed[0] if failed else "the import"
            return "survived", f"{sum(map(len, rounds))} tests"

    def _pytest(self, names: dict[str, str], limit: float, arguments: list[str]) -> int | None:
        """Return the exit status of the tests, None where other programs left too little of the processor."""
        options = ["-c", str(ROOT / "pyproject.toml"), "--rootdir", str(ROOT), "-o", "addopts=", "--hypothesis-seed=0"]
        options += ["-p", "no:cacheprovider", "-p", "no:xdist", "-q", "--tb=no", "--no-header", *arguments]
        folder = Path(tempfile.mkdtemp(dir=self.scratch))
        process = self.processes.Process(target=selection.run, args=(folder, SOURCES, names, limit, options))
        process.start()
        try:
            process.join(SLOWED * limit)
            return process.exitcode
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid or 0, signal.SIGKILL)  # and all that it has started
            process.join()
            shutil.rmtree(folder, ignore_errors=True)

    def run(
        self, wanted: list[tuple[str, Mutant]], before: list[dict[str, Any]], survey: Survey
    ) -> list[dict[str, Any]]:
        """Return what became of all mutants, written down one by one."""
        found = list(before)
        with ThreadPoolExecutor(self.workers) as pool, (self.out / "mutants.jsonl").open("w", encoding="utf-8") as file:
            file.writelines(json.dumps(each, ensure_ascii=False) + "\n" for each in before)
            quickest_first = sorted(wanted, key=lambda pair: pair[1].compiled)
            under_way = [pool.submit(self.fate, room, each, survey.of(each)) for room, each in quickest_first]
            for number, done in enumerate(as_completed(under_way), start=1):
                fate = done.result()
                file.write(json.dumps(fate, ensure_ascii=False) + "\n")
                file.flush()
                print(f"{number}/{len(wanted)} {fate['status']:9s} {fate['seconds']:6.1f} s  {fate['key']}", flush=True)
                found.append(fate)
        return sorted(found, key=lambda fate: (ROOMS.index(fate["room"]), fate["key"]))


def lines(path: Path) -> list[dict[str, Any]]:
    """Return what was written down, line by line."""
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []


def explanations() -> dict[str, str]:
    """Return why survivors are no mistakes, by their keys."""
    table = tomllib.loads((HERE / "explained.toml").read_text(encoding="utf-8"))
    return {key: reason for reason_of in table.values() for key, reason in reason_of.items()}


def everything(room: str) -> list[Mutant]:
    """Return all mutants of a room."""
    paths = sorted((SOURCES / room).rglob("*.py"))
    return [each for path in paths for each in mutants(path, path.relative_to(SOURCES).as_posix())]


def summary(found: list[dict[str, Any]]) -> tuple[str, bool]:
    """Return a page of what became of the mutants, and whether in every room enough were caught or are explained."""
    recorded = tomllib.loads((HERE / "shares.toml").read_text(encoding="utf-8"))
    page, enough = [], True
    for room in dict.fromkeys(each["room"] for each in found):
        count = Counter(each["status"] for each in found if each["room"] == room)
        ran, caught = count.total() - count["not run"], count["caught"] + count["explained"]
        before = recorded.get(room)
        least = before["caught"] / before["sampled"] - NOISE if before else ENOUGH
        lower = caught < least * ran
        enough &= not lower
        told = f"{room}: {caught} of {ran} caught or explained, {caught / max(ran, 1):.1%}"
        page.append(f"{told}, less than the {least:.1%} that it has to be" if lower else told)
    page += [""] + [
        f"- {each['status']}, line {each['line']}, {each['by']}: `{each['key']}`"
        for each in found
        if each["status"] in ("survived", "not run")
    ]
    return "\n".join(page) + "\n", enough


def main() -> int:
    """Run the mutants that are asked for."""
    parser = argparse.ArgumentParser(description="Put small mistakes into the sources and see whether tests notice.")
    parser.add_argument("--rooms", nargs="+", default=ROOMS, choices=ROOMS, help="all of them by default")
    parser.add_argument("--count", type=int, default=60, help="mutants in each room")
    parser.add_argument("--seed", type=int, default=1, help="of the choice")
    parser.add_argument("--again", action="store_true", help="run those alone that survived the last time")
    parser.add_argument("--tests", nargs="+", default=[""], help="how names of files of tests begin; all by default")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--seconds", type=float, default=36_000.0, help="after which no more is begun")
    parser.add_argument("--out", type=Path, default=Path("out/mutants"), help="folder for what is found")
    parser.add_argument("--list", action="store_true", help="print the list and run nothing")
    asked = parser.parse_args()
    wanted = [(room, each) for room in asked.rooms for each in chosen(everything(room), asked.count, asked.seed)]
    if asked.list:
        print("\n".join(mutant.key for _, mutant in wanted))
        return 0
    asked.out.mkdir(parents=True, exist_ok=True)
    before = lines(asked.out / "mutants.jsonl") if asked.again else []
    before = [each for each in before if each["status"] in ("caught", "explained")]
    done = {each["key"] for each in before}
    campaign = Campaign(asked.out.resolve(), asked.workers, asked.seconds)
    try:
        survey = campaign.survey(tuple(asked.tests))
        page, enough = summary(campaign.run([pair for pair in wanted if pair[1].key not in done], before, survey))
    finally:
        shutil.rmtree(campaign.scratch, ignore_errors=True)
    (asked.out / "survivors.md").write_text(page, encoding="utf-8")
    print(page, end="")
    return 0 if enough else 1


if __name__ == "__main__":
    sys.exit(main())
