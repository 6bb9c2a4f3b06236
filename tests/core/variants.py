"""The core built in other ways than the one that is installed, each in a folder of its own below ``out/core``."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BASELINE = {"IS_V3": "OFF"}
O2 = {"CMAKE_CXX_FLAGS_RELEASE": "-O2 -DNDEBUG"}
# With names in what they report, and with assertions of the standard library.
SANITIZED = {"CMAKE_BUILD_TYPE": "RelWithDebInfo", "CMAKE_CXX_FLAGS_RELWITHDEBINFO": ""}
_OPTIONS = "-O1 -g1 -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS"
MEMORY = (
    BASELINE
    | SANITIZED
    | {"CMAKE_CXX_FLAGS": f"{_OPTIONS} -fsanitize=address,undefined -fno-sanitize-recover=undefined"}
)
THREADS = SANITIZED | {"CMAKE_CXX_FLAGS": f"{_OPTIONS} -fsanitize=thread"}


def tool(name: str) -> str | None:
    """Return the path of a program that is installed beside Python or found elsewhere."""
    beside = Path(sys.executable).with_name(name)
    return str(beside) if beside.is_file() else shutil.which(name)


def can_build() -> bool:
    """Return whether there is what the core is built with."""
    return bool(tool("cmake") and importlib.util.find_spec("nanobind") and (ROOT / "CMakeLists.txt").is_file())


def built(name: str, *definitions: dict[str, str]) -> Path:
    """Build the core as definitions of CMake say, and return its module; what has not changed is not built again."""
    folder = ROOT / "out" / "core" / name
    cmake, ninja = tool("cmake"), tool("ninja")
    assert cmake is not None, "no cmake: make installs one"
    words = [cmake, "-S", ROOT, "-B", folder, f"-DPython_EXECUTABLE={sys.executable}"]
    words += ["-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={ninja}"] if ninja else []
    words += [f"-D{key}={value}" for each in definitions for key, value in each.items()]
    for command in (words, [cmake, "--build", folder]):
        done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    (module,) = (path for path in folder.glob("_core*") if path.suffix in {".so", ".pyd"})
    return module


def environment(module: Path | None) -> dict[str, str]:
    """Return the variables of a process that is to run a core, by default the one that is installed."""
    paths = [str(ROOT / "tests" / folder) for folder in (".", "common", "campaign")]
    if inherited := os.environ.get("PYTHONPATH"):
        paths.append(inherited)
    chosen = {"NONHERTZ_TEST_CORE": str(module)} if module else {}
    return os.environ | {"PYTHONPATH": os.pathsep.join(paths)} | chosen


@cache
def numbers_of(module: Path | None, times: int) -> list[str]:
    """Return the numbers of random cases by a core, to the last digit, a case a line; see digits.py."""
    words = [sys.executable, Path(__file__).with_name("digits.py"), str(times)]
    done = subprocess.run(words, env=environment(module), capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()
