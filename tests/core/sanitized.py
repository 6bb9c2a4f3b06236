"""Runs tests on builds of the core that look for mistakes in memory, undefined behaviour, and races of threads.

    python tests/core/sanitized.py          # all unit tests that reach the core; --short: a few

GCC's sanitizers on Linux; they are loaded before Python, which knows nothing of them.
"""

from __future__ import annotations

import argparse
import os
import platform
import subprocess
import sys
from pathlib import Path

from variants import MEMORY, ROOT, THREADS, built, environment

HERE = Path(__file__).parent
UNIT = ROOT / "tests" / "unit"
SHORT = ("test_newton.py", "test_linear.py", "test_levels.py", "test_judgement.py", "test_many.py")
# Python's own memory is not freed at its end, and is handed out by Python.
OPTIONS = {
    "ASAN_OPTIONS": "detect_leaks=0",
    "UBSAN_OPTIONS": "print_stacktrace=1",
    "TSAN_OPTIONS": f"exitcode=66:suppressions={HERE / 'threads.supp'}",
    "PYTHONMALLOC": "malloc",
}


def ran(name: str, definitions: dict[str, str], libraries: tuple[str, ...], *words: str | Path) -> bool:
    """Run Python with a core, and return whether nothing was found."""
    module = built(name, definitions)
    found = [
        subprocess.run(["g++", f"-print-file-name={each}"], capture_output=True, encoding="utf-8", check=True).stdout
        for each in libraries
    ]
    variables = environment(module) | OPTIONS | {"LD_PRELOAD": " ".join(path.strip() for path in found)}
    # Without random addresses, of which older sanitizers do not know the newest.
    done = subprocess.run(["setarch", platform.machine(), "-R", sys.executable, *words], env=variables, check=False)
    print(f"{name}: {'nothing found' if done.returncode == 0 else 'FAILED'}", flush=True)
    return done.returncode == 0


def main() -> int:
    """Run what is asked for."""
    parser = argparse.ArgumentParser(description="Run tests on sanitized builds of the core.")
    parser.add_argument("--short", action="store_true", help="a few tests only")
    short = parser.parse_args().short
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    reaching = [path for path in sorted(UNIT.glob("test_*.py")) if "native import" in path.read_text(encoding="utf-8")]
    tests = [UNIT / name for name in SHORT] if short else reaching
    words = ("-m", "pytest", "-q", "-x", "-p", "other_core", "-m", "not slow and not campaign", *tests)
    fine = ran("memory", MEMORY, ("libasan.so", "libubsan.so", "libstdc++.so"), *words)
    return 0 if ran("threads", THREADS, ("libtsan.so", "libstdc++.so"), HERE / "threads.py") and fine else 1


if __name__ == "__main__":
    sys.exit(main())
