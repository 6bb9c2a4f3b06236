"""Builds wheel and sdist, and checks that they hold all they need.

    python tests/distributions.py python3.11 python3.12 python3.13
    python tests/distributions.py python3.13 --tests

Wheels are built from the sdist, for every kind of processor: one for Python 3.11 and one for all later ones. On each
Python its wheel is installed into an environment of its own below ``out/distributions``, first with nothing but what
the solver needs, then with the extras, and used as a newcomer would use it. With ``--tests`` the unpacked sdist runs
its own tests there, too, those left out that take seconds each. What was built is in ``dist``.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import urllib.request
import zipfile
from collections.abc import Iterator
from pathlib import Path

from versions import ROOT, found, python_in, uv

DIST = ROOT / "dist"
PLACE = ROOT / "out" / "distributions"

# Nothing but the core's dependencies and theirs may be there, else this would not show what a user meets.
BARE = """
import importlib.metadata
import importlib.resources
import nonhertz as nh
from nonhertz.native import core
there = {each.name.lower() for each in importlib.metadata.distributions()}
assert there == {"nonhertz", "numpy", "scipy"}, there
assert importlib.import_module("nonhertz._core") and core
assert nh.__version__ == importlib.metadata.version("nonhertz")
assert importlib.resources.files("nonhertz").joinpath("py.typed").is_file()
contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=1000)), nh.Ring(diameter=80))
solution = nh.solve(contact, load=5e3)
assert abs(solution.load / 5e3 - 1) < 1e-9, solution.load
print(f"solved: maximum pressure {solution.max_pressure:.0f} MPa")
"""
MISSING = (
    "The package {0}, needed for {1}, is not installed: pip install {0}, or pip install '.[{2}]' in the folder of "
    "nonhertz\n"
)
NO_CLI = MISSING.format("cyclopts", "the command line", "cli")
NO_WEB = MISSING.format("uvicorn", "the page", "web")
SERVED = ("", "static/main.js", "static/vendor/d3.min.js", "static/vendor/plot.umd.min.js")


class Environment:
    """A virtual environment with the wheel, and an empty folder to work in.

    Parameters
    ----------
    interpreter : str
        Whose Python.
    wheel : Path
        What is installed, without extras.
    """

    def __init__(self, interpreter: str, wheel: Path) -> None:
        self.folder = PLACE / Path(interpreter).name
        self.work = self.folder / "work"
        shutil.rmtree(self.folder, ignore_errors=True)
        uv("venv", "--python", interpreter, self.folder)
        self._wheel, self.python = wheel, python_in(self.folder)
        self.work.mkdir()
        self.install()

    def install(self, *extras: str, groups: Path | None = None) -> None:
        """Install the wheel with extras, and what the tests need if their project is given."""
        named = [f"nonhertz[{','.join(extras)}] @ {self._wheel.as_uri()}" if extras else str(self._wheel)]
        named += ["--group", f"{groups}:test"] if groups else []
        uv("pip", "install", "--python", self.folder, *named)

    def run(self, *words: str | Path, code: int = 0, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
        """Run Python; it must end with a code."""
        done = subprocess.run(
            [self.python, *words],
            cwd=cwd or self.work, env=clean(), capture_output=True, encoding="utf-8", check=False,
        )  # fmt: skip
        assert done.returncode == code, f"{' '.join(map(str, words))}\n{done.stdout}{done.stderr}"
        return done


def clean() -> dict[str, str]:
    """Return the variables of this process without those that would let Python find these sources."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | {"PYTHONUTF8": "1"}


def built(interpreters: list[str]) -> tuple[dict[str, Path], Path]:
    """Build both distributions, wheels from the sdist, and return that of each interpreter, and the sdist."""
    shutil.rmtree(DIST, ignore_errors=True)
    options = ("--out-dir", DIST, "--build-constraints", ROOT / "constraints.txt")
    uv("build", "--sdist", *options)
    (sdist,) = DIST.glob("*.tar.gz")
    every = ("--config-setting", "cmake.define.NONHERTZ_EVERY_PROCESSOR=ON")
    wheels = {}
    for interpreter in interpreters:
        asked = [interpreter, "-c", "import sys; print('abi3' if sys.version_info >= (3, 12) else 'cp311')"]
        tag = subprocess.run(asked, capture_output=True, encoding="utf-8", check=True).stdout.strip()
        if not list(DIST.glob(f"*-{tag}-*.whl")):
            uv("build", "--wheel", "--python", interpreter, *options, *every, sdist)
        (wheels[interpreter],) = DIST.glob(f"*-{tag}-*.whl")
    return wheels, sdist


def tracked(*below: str) -> set[str]:
    """Return the names of the files that belong to the project."""
    listed = subprocess.run(["git", "ls-files", *below], cwd=ROOT, capture_output=True, encoding="utf-8", check=True)
    return set(listed.stdout.splitlines())


def check_contents(wheel: Path, sdist: Path) -> None:
    """Check that the sdist is the checkout, and a wheel the package, its core and the licences, no more and no less."""
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    texts = {name.partition("/licenses/")[2] for name in names if "/licenses/" in name}
    assert {"LICENSE", "NOTICE.md"} < texts, texts
    if not (ROOT / ".git").exists():
        print("This is no checkout: that nothing is missing was not checked.")
        return
    package = {name.removeprefix("src/") for name in tracked("src/nonhertz")}
    core = {name for name in names if re.fullmatch(r"nonhertz/_core(_v3)?\..*(so|pyd)", name)}
    assert len(core) == (2 if platform.machine().lower() in {"x86_64", "amd64"} else 1), core
    assert {name for name in names if ".dist-info/" not in name} - core == package, (names - core) ^ package
    assert {name for name in tracked("src") if name.endswith(".LICENSE")} < texts, texts
    with tarfile.open(sdist) as archive:
        held = {name.partition("/")[2] for name in archive.getnames()}
    assert held == tracked() | {"PKG-INFO"}, held ^ tracked()


def check_metadata(*files: Path) -> None:
    """Have the metadata judged as an index would, if the program for it is installed."""
    if importlib.util.find_spec("twine") is None:
        print("twine is not installed: the metadata were not checked.")
        return
    subprocess.run([sys.executable, "-m", "twine", "--no-color", "check", "--strict", *files], check=True)


def check_installed(environment: Environment) -> None:
    """Use what is installed as a newcomer would, first without extras."""
    command = ("-m", "nonhertz")
    print(environment.run("-W", "error", "-c", BARE).stdout.strip())
    assert environment.run(*command, "solve", "case.toml", code=2).stderr == NO_CLI
    environment.install("cli")
    environment.run(*command, "new", "case.toml")
    environment.run(*command, "solve", "case.toml", "--out", "results")
    assert (environment.work / "results" / "result.json").is_file()
    assert environment.run(*command, "serve", code=2).stderr == NO_WEB
    environment.install("web")
    for path, content in served(environment):
        assert content, path


def served(environment: Environment) -> Iterator[tuple[str, bytes]]:
    """Start the page, and give what it answers."""
    words = [environment.python, "-u", "-m", "nonhertz", "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(words, cwd=environment.work, env=clean(), stdout=subprocess.PIPE, text=True) as server:
        try:
            assert server.stdout is not None
            address = next(word for line in server.stdout for word in line.split() if word.startswith("http"))
            for path in SERVED:
                with urllib.request.urlopen(f"{address}{path}", timeout=60) as answer:
                    yield path, answer.read()
        finally:
            server.kill()


def run_tests(environment: Environment, sdist: Path) -> None:
    """Run the tests of an unpacked sdist on what is installed."""
    shutil.unpack_archive(sdist, environment.folder)
    sources = environment.folder / sdist.name.removesuffix(".tar.gz")
    environment.install("web", groups=sources / "pyproject.toml")
    words = ["-m", "pytest", "-q", "-m", "not slow and not campaign and not browser"]
    variables = {"PYTEST_ADDOPTS": "-n auto"} | clean()
    # The package that is installed, not the sources beside the tests.
    command = [environment.python, *words, "--pyargs", "nonhertz", "tests"]
    done = subprocess.run(command, cwd=sources, env=variables, check=False)
    assert done.returncode == 0, "The tests of the sdist have failed."


def main() -> int:
    """Build, and check with every interpreter that is there."""
    parser = argparse.ArgumentParser(description="Build wheel and sdist and check what they hold.")
    parser.add_argument("interpreters", nargs="+", help="such as python3.11")
    parser.add_argument("--tests", action="store_true", help="run the tests of the sdist, too")
    asked = parser.parse_args()
    wheels, sdist = built([each for each in asked.interpreters if found(each)])
    for wheel in set(wheels.values()):
        check_contents(wheel, sdist)
    check_metadata(*set(wheels.values()), sdist)
    for interpreter, wheel in wheels.items():
        print(f"{interpreter}:", flush=True)
        environment = Environment(interpreter, wheel)
        check_installed(environment)
        if asked.tests:
            run_tests(environment, sdist)
    missing = [each for each in asked.interpreters if not found(each)]
    if missing:
        print(f"Not checked, since not found: {', '.join(missing)}. Install them, or name others in PYTHONS.")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
