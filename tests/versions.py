"""The tests with the lowest versions of all that pyproject.toml asks for, and with the newest, on several Pythons.

    python tests/versions.py python3.11 python3.12 python3.13

Each pair of interpreter and versions gets an environment of its own below ``out/versions``, with the package installed
in it as a user would have it, and a list of what was installed, ``versions.txt``. Where a package has no wheel of its
lowest version for an interpreter, the lowest that has one is taken.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RESOLUTIONS = {"lowest": "lowest-direct", "newest": "highest"}


def found(interpreter: str) -> bool:
    """Return whether an interpreter is there and starts; a version manager may have no more than its name."""
    if shutil.which(interpreter) is None:
        return False
    return subprocess.run([interpreter, "--version"], capture_output=True, check=False).returncode == 0


def uv(*arguments: str | Path) -> None:
    """Run uv."""
    subprocess.run([sys.executable, "-m", "uv", *arguments, "--quiet"], cwd=ROOT, check=True)


def python_in(environment: Path) -> Path:
    """Return the interpreter of a virtual environment."""
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def build_tools(resolution: str) -> list[str]:
    """Return constraints on what the package is built with."""
    required = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["build-system"]["requires"]
    return [each.replace(">=", "==") for each in required] if resolution == "lowest" else required


def environment(interpreter: str, resolution: str) -> Path:
    """Make an environment and return its folder."""
    folder = ROOT / "out" / "versions" / f"{Path(interpreter).name}-{resolution}"
    shutil.rmtree(folder, ignore_errors=True)
    uv("venv", "--python", interpreter, folder)
    python, versions = python_in(folder), folder / "versions.txt"
    uv(
        "pip", "compile", "--python", python, "--resolution", RESOLUTIONS[resolution], "--no-build", "--no-header",
        "--no-annotate", "--no-emit-index-url", "--no-emit-find-links", "--extra", "web", "--group", "test",
        "--output-file", versions, "pyproject.toml",
    )  # fmt: skip
    uv("pip", "install", "--python", python, "--no-deps", "--requirement", versions)
    # Built as a wheel, and anew: of a folder uv may remember what it built before.
    wheels = folder / "wheel"
    constraints = folder / "build.txt"
    constraints.write_text("\n".join(build_tools(resolution)), encoding="utf-8")
    uv("build", "--wheel", "--python", python, "--build-constraints", constraints, "--out-dir", wheels, ROOT)
    uv("pip", "install", "--python", python, "--no-deps", *wheels.glob("*.whl"))
    return folder


def passed(folder: Path) -> bool:
    """Return whether the tests pass in an environment, the examples in the docstrings among them."""
    tests = [python_in(folder), "-m", "pytest", "-q", "tests"]
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    clean.setdefault("PYTEST_ADDOPTS", "-n auto")
    return subprocess.run(tests, cwd=ROOT, env=clean, check=False).returncode == 0


def main() -> int:
    """Test with every interpreter that is there."""
    parser = argparse.ArgumentParser(description="Run the tests with the lowest and the newest versions.")
    parser.add_argument("interpreters", nargs="+", help="such as python3.11")
    parser.add_argument("--only", choices=tuple(RESOLUTIONS), help="the lowest or the newest versions alone")
    asked = parser.parse_args()
    ended = {}
    for interpreter in filter(found, asked.interpreters):
        for resolution in [asked.only] if asked.only else RESOLUTIONS:
            folder = environment(interpreter, resolution)
            print(f"{interpreter}, {resolution} versions", flush=True)
            ended[f"{interpreter}, {resolution} versions"] = passed(folder)
    for name, fine in ended.items():
        print(f"{name}: {'passed' if fine else 'FAILED'}")
    missing = [each for each in asked.interpreters if not found(each)]
    if missing:
        print(f"Not tested, since not found: {', '.join(missing)}. Install them, or name others in PYTHONS.")
    return 0 if all(ended.values()) and not missing else 1


if __name__ == "__main__":
    sys.exit(main())
