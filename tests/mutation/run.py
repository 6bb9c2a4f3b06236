"""Do the tests notice? Small mistakes put into the sources one at a time, and what becomes of each.

    python tests/mutation/run.py --rooms bearing core/strips --count 30 --out out/mutants

Each mutant, which is one change of one file, is put into a copy of the sources. Of C++ the copy is built again: what
does not compile does not count. Then the tests of its room run, those named like its file first, until one fails or
takes too long. Which tests these are says ``rooms.toml``. The mutants and their order depend on the sources and the
seed alone.

In the folder given by ``--out`` are, afterwards, the copies, ``mutants.jsonl`` with a line for each mutant, and
``survivors.md``. A survivor that means the same as the original, or hardly anything else, is explained in
``explained.toml`` beside this file, under its key. The exit status is 1 where of a room a smaller share was caught or
is explained than ``shares.toml`` says, or less than nine in ten where it says nothing; nothing is begun where a test
fails on the sources as they are.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import threading
import time
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from mutants import Mutant, mutants, ranked

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Programs installed beside Python go first.
PATH = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
BUILT = {".so", ".pyd", ".pyc", ""}  # and folders
SOURCES = ROOT / "src"
ENOUGH, NOISE = 0.9, 0.02  # of those that ran, where no share is recorded; and below one that is
# s, added to three times what the tests of the room took: a mutant that needs more of the processor is taken to hang
ADDED, SLOWER = 20.0, 3.0
WAITS = 10.0  # times as long on the clock, where it waits rather than works
MOST = 600.0  # s, for the tests of a room
BUILD = "-GNinja", "-DNONHERTZ_IN_PLACE=ON", "-DCMAKE_CXX_FLAGS_RELEASE=-O1"  # the same digits, built faster
TESTS = tomllib.loads((HERE / "rooms.toml").read_text(encoding="utf-8"))


class Copy:
    """A copy of the sources and the tests, in which one mutant at a time is built and tested.

    Parameters
    ----------
    folder : Path
        Where; what a former run has left there is brought up to date.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for path in filter(Path.is_file, ROOT.glob("*")):
            self.put(path.name, path.read_bytes())
        for top in ("src", "tests", "docs", "examples"):
            known = {path.relative_to(ROOT).as_posix() for path in (ROOT / top).rglob("*") if path.suffix not in BUILT}
            for name in filter(lambda each: (ROOT / each).is_file(), known):
                self.put(name, (ROOT / name).read_bytes())
            for path in (folder / top).rglob("*.?p*"):
                if path.suffix not in BUILT and path.relative_to(folder).as_posix() not in known:
                    path.unlink()
        cmake, ninja = (shutil.which(each, path=PATH) or sys.exit(f"no {each}") for each in ("cmake", "ninja"))
        self.build = [ninja, "-j1", "-C", folder / "build"]
        options = [*BUILD, f"-DCMAKE_MAKE_PROGRAM={ninja}", f"-DPython_EXECUTABLE={sys.executable}"]
        subprocess.run([cmake, *options, "-S", folder, "-B", folder / "build"], check=True, stdout=subprocess.DEVNULL)

    def put(self, name: str, content: bytes) -> None:
        """Write a file where that changes it."""
        path = self.folder / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            # What is kept of a module is known by its second and its size, which a mutant may share.
            if path.suffix == ".py":
                Path(importlib.util.cache_from_source(path)).unlink(missing_ok=True)

    def builds(self) -> bool:
        """Build what has changed."""
        return subprocess.run(self.build, capture_output=True, check=False).returncode == 0

    def tested(self, tests: list[str], limit: float) -> tuple[int, str]:
        """Return the exit status of tests that may take so many seconds of processor, and the one that failed."""
        shutil.rmtree(self.folder / "cache", ignore_errors=True)
        environment = os.environ | {
            "PYTHONPATH": str(self.folder / "src"), "NONHERTZ_CACHE_DIR": str(self.folder / "cache"),
            "HYPOTHESIS_STORAGE_DIRECTORY": str(self.folder / "cache"), "OMP_NUM_THREADS": "1",
            "OPENBLAS_NUM_THREADS": "1",
        }  # fmt: skip
        options = ["-x", "-q", "--tb=no", "--no-header", "-rfE", "--hypothesis-seed=0", "-p", "no:xdist"]
        command = ["sh", "-c", f'ulimit -t {limit:.0f}; exec "$@"', "sh", sys.executable, "-m", "pytest", *options]
        try:
            done = subprocess.run(
                [*command, *(f"tests/{each}" for each in tests)], cwd=self.folder, env=environment, check=False,
                capture_output=True, encoding="utf-8", errors="replace", timeout=WAITS * limit,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return -9, "time-out"
        failed = [line.split()[1] for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return done.returncode, failed[0] if failed else f"exit status {done.returncode}"


class Campaign:
    """One run over the mutants of some rooms.

    Parameters
    ----------
    out : Path
        Folder for what is found.
    workers : int
        Mutants at a time.
    known : dict
        What became of mutants that are not tried again, by their keys.
    """

    def __init__(self, out: Path, workers: int, known: dict[str, dict[str, Any]]) -> None:
        self.out, self.workers, self.known = out, workers, known
        self.explained = explanations()
        with ThreadPoolExecutor(workers) as pool:
            self.copies = list(pool.map(Copy, [out / f"copy-{k}" for k in range(workers)]))

    def of(self, room: str, count: int, seed: int) -> list[dict[str, Any]]:
        """Return what becomes of so many mutants of a room, which those that do not compile are not among."""
        built, begun = [copy.builds() for copy in self.copies], time.monotonic()
        status, by = self.copies[0].tested(TESTS[room], MOST)
        if status or not all(built):
            sys.exit(f"{by} fails on the sources as they are: mend that first.")
        limit = ADDED + SLOWER * (time.monotonic() - begun)
        print(f"{room}: its tests took {time.monotonic() - begun:.0f} s", flush=True)
        order, lock, fates = iter(ranked(everything(room), seed)), threading.Lock(), []
        reserved = 0

        def work(copy: Copy) -> None:
            nonlocal reserved
            while True:
                with lock:
                    mutant = next(order, None) if reserved < count else None
                    reserved += 1
                if mutant is None:
                    return
                fate = self.known.get(mutant.key) or self.fate(copy, room, mutant, limit)
                with lock, (self.out / "mutants.jsonl").open("a", encoding="utf-8") as file:
                    file.write(json.dumps(fate, ensure_ascii=False) + "\n")
                    print(f"{fate['status']:9s} {fate['seconds']:6.1f} s  {mutant.key}", flush=True)
                    if fate["status"] == "no code":
                        reserved -= 1
                    else:
                        fates.append(fate)

        with ThreadPoolExecutor(self.workers) as pool:
            list(pool.map(work, self.copies))
        return sorted(fates, key=lambda fate: fate["key"])

    def fate(self, copy: Copy, room: str, mutant: Mutant, limit: float) -> dict[str, Any]:
        """Return what becomes of a mutant."""
        begun = time.monotonic()
        path = SOURCES.joinpath("" if room.startswith("core/") else "nonhertz", mutant.path)
        name, text = path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")
        if mutant.key in self.explained:
            status, by = "explained", self.explained[mutant.key]
        else:
            copy.put(name, mutant.applied(text).encode())
            status, by = "no code", ""
            if path.suffix == ".py" or copy.builds():
                failed, by = copy.tested(sorted(TESTS[room], key=lambda each: path.stem not in each), limit)
                status = "caught" if failed else "survived"
            copy.put(name, text.encode())  # and is built with the next one
        return {
            "key": mutant.key, "room": room, "line": text.count("\n", 0, mutant.start) + 1, "status": status, "by": by,
            "seconds": round(time.monotonic() - begun, 1),
        }  # fmt: skip


def explanations() -> dict[str, str]:
    """Return why survivors are no mistakes, by their keys."""
    table = tomllib.loads((HERE / "explained.toml").read_text(encoding="utf-8"))
    return {key: reason for reason_of in table.values() for key, reason in reason_of.items()}


def everything(room: str) -> list[Mutant]:
    """Return all mutants of a room."""
    above = SOURCES if room.startswith("core/") else SOURCES / "nonhertz"
    paths = sorted(path for path in (above / room).rglob("*.*") if path.suffix in (".py", ".cpp", ".hpp"))
    return [each for path in paths for each in mutants(path, path.relative_to(above).as_posix())]


def summary(found: list[dict[str, Any]]) -> tuple[str, bool]:
    """Return a page of what became of the mutants, and whether in every room enough were caught or are explained."""
    recorded = tomllib.loads((HERE / "shares.toml").read_text(encoding="utf-8"))
    page, enough = [], True
    for room in dict.fromkeys(each["room"] for each in found):
        count = Counter(each["status"] for each in found if each["room"] == room)
        ran, caught = count.total(), count["caught"] + count["explained"]
        before = recorded.get(room)
        least = before["caught"] / before["sampled"] - NOISE if before else ENOUGH
        lower = caught < least * ran
        enough &= not lower
        told = f"{room}: {caught} of {ran} caught or explained, {caught / max(ran, 1):.1%}"
        page.append(f"{told}, less than the {least:.1%} that it has to be" if lower else told)
    page += ["", *(f"- line {each['line']}: `{each['key']}`" for each in found if each["status"] == "survived")]
    return "\n".join(page) + "\n", enough


def main() -> int:
    """Run the mutants that are asked for."""
    parser = argparse.ArgumentParser(description="Put small mistakes into the sources and see whether tests notice.")
    parser.add_argument("--rooms", nargs="+", default=[*TESTS], choices=TESTS, help="all of them by default")
    parser.add_argument("--count", type=int, default=30, help="mutants in each room")
    parser.add_argument("--seed", type=int, default=1, help="of the choice")
    parser.add_argument("--again", action="store_true", help="pass over those that were caught the last time")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--out", type=Path, default=Path("out/mutants"), help="folder for what is found")
    parser.add_argument("--list", action="store_true", help="print the list and run nothing")
    asked = parser.parse_args()
    if asked.list:
        print(
            "\n".join(each.key for room in asked.rooms for each in ranked(everything(room), asked.seed)[: asked.count])
        )
        return 0
    written = asked.out / "mutants.jsonl"
    lines = written.read_text(encoding="utf-8").splitlines() if asked.again and written.exists() else []
    known = {fate["key"]: fate for fate in map(json.loads, lines) if fate["status"] in ("caught", "no code")}
    asked.out.mkdir(parents=True, exist_ok=True)
    written.write_text("".join(json.dumps(fate) + "\n" for fate in known.values()), encoding="utf-8")
    campaign = Campaign(asked.out.resolve(), asked.workers, known)
    page, enough = summary([fate for room in asked.rooms for fate in campaign.of(room, asked.count, asked.seed)])
    (asked.out / "survivors.md").write_text(page, encoding="utf-8")
    print(page, end="")
    return 0 if enough else 1


if __name__ == "__main__":
    sys.exit(main())
