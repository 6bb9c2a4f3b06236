"""Runs tests on builds of the core that look for mistakes in memory, undefined behaviour, and races of threads.

    python tests/core/sanitized.py          # all unit tests that reach the core; --short: a few

GCC's sanitizers on Linux; they are loaded before Python, which knows nothing of them. The build for memory, for any
processor and less optimised, must also give random cases the numbers of the installed one, to the last digit.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from subprocess import CompletedProcess

from variants import MEMORY, ROOT, THREADS, built, environment, numbers_of

HERE = Path(__file__).parent
UNIT = ROOT / "tests" / "unit"
BUILDS = {
    "memory": (MEMORY, ("libasan.so", "libubsan.so", "libstdc++.so")),
    "threads": (THREADS, ("libtsan.so", "libstdc++.so")),
}
SHORT = ("test_newton.py", "test_linear.py", "test_levels.py", "test_judgement.py", "test_many.py")
# Python's own memory is not freed at its end, and is handed out by Python.
OPTIONS = {
    "ASAN_OPTIONS": "detect_leaks=0",
    "UBSAN_OPTIONS": "print_stacktrace=1",
    "TSAN_OPTIONS": f"exitcode=66:suppressions={HERE / 'threads.supp'}",
    "PYTHONMALLOC": "malloc",
}


def run(name: str, words: Iterable[str | Path], stdout: int | None = None) -> CompletedProcess[str]:
    """Run Python with a core that is built with a sanitizer."""
    definitions, libraries = BUILDS[name]
    module = built(name, definitions)
    paths = [
        subprocess.run(["g++", f"-print-file-name={each}"], capture_output=True, encoding="utf-8", check=True).stdout
        for each in libraries
    ]
    variables = environment(module) | OPTIONS | {"LD_PRELOAD": " ".join(path.strip() for path in paths)}
    # Without random addresses, of which older sanitizers do not know the newest.
    command = ["setarch", platform.machine(), "-R", sys.executable, *words]
    return subprocess.run(command, env=variables, stdout=stdout, encoding="utf-8", check=False)


def report(name: str, fine: bool) -> bool:
    """Print whether nothing was found, and return it."""
    print(f"{name}: {'nothing found' if fine else 'FAILED'}", flush=True)
    return fine


def main() -> int:
    """Run what is asked for."""
    parser = argparse.ArgumentParser(description="Run tests on sanitized builds of the core.")
    parser.add_argument("--short", action="store_true", help="a few tests only")
    short = parser.parse_args().short
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    reaching = [path for path in sorted(UNIT.glob("test_*.py")) if "native import" in path.read_text(encoding="utf-8")]
    tests = [UNIT / name for name in SHORT] if short else reaching
    words = ("-m", "pytest", "-q", "-x", "-p", "other_core", "-m", "not slow and not campaign", *tests)
    fine = report("memory", run("memory", words).returncode == 0)
    digits, installed = run("memory", (HERE / "digits.py", "1"), subprocess.PIPE), numbers_of(None, 1)
    assert len(installed) >= 50
    fine &= report("digits", digits.returncode == 0 and digits.stdout.splitlines() == installed)
    fine &= report("threads", run("threads", (HERE / "threads.py",)).returncode == 0)
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
