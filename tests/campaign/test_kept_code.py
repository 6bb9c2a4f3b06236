"""Machine code on disk through whatever befalls it: the right answer, never an old one, and the same last digits.

Each situation is played by processes of their own: in most of them by a package of two small functions that stands
beside a copy of our compiler, so that the folders around both can be spoilt.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import nonhertz

pytestmark = pytest.mark.machine_code

INNER = """
from nonhertz.compiled import compiled
RATE = 2.0
@compiled
def inner(x):
    return RATE * x * x
"""
OUTER = """
from nonhertz.compiled import compiled
from press.inner import inner
@compiled
def outer(x):
    return inner(x) + 1.0
"""
RUN = """
from press.outer import outer
print(outer(2.0), "read" if sum(outer.stats.cache_hits.values()) else "compiled")
"""
COMPILED, READ = "9.0 compiled\n", "9.0 read\n"
WAY_OUT = r"The compiled solver cannot be kept, .*: nothing can be written in (.*)\. Set NUMBA_CACHE_DIR .*\n"


class Machine:
    """A machine on which our compiler, a package that uses it, and a user's home are put up anew."""

    def __init__(self, root: Path) -> None:
        self.site, self.home = root / "site", root / "home"
        self.home.mkdir()
        self.package = self.site / "nonhertz"
        shutil.copytree(Path(nonhertz.__file__).parent, self.package, ignore=shutil.ignore_patterns("__pycache__"))
        self.with_package = self.package / "__pycache__/machine-code"
        self.with_user = self.home / ".cache/nonhertz/machine-code"
        self.write("inner", INNER)
        self.write("outer", OUTER)
        self.environment = {
            name: value for name, value in os.environ.items() if not name.startswith(("NUMBA_", "XDG_", "PYTHON"))
        } | {"HOME": str(self.home), "PYTHONPATH": str(self.site), "PYTHONWARNINGS": "error"}

    def write(self, name: str, source: str) -> Path:
        """Write a file of the package that uses the compiler."""
        path = self.site / "press" / f"{name}.py"
        path.parent.mkdir(exist_ok=True)
        path.write_text(source)
        return path

    def start(self, before: str = "") -> subprocess.Popen[str]:
        """Start the program, with a line of Python ``before`` it."""
        return subprocess.Popen(
            [sys.executable, "-c", f"{before}\n{RUN}"],
            env=self.environment, cwd=self.home, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        )  # fmt: skip

    def run(self, before: str = "") -> str:
        """Return what the program prints; it ends well and has nothing else to say."""
        said, complaints = self.run_complaining(before)
        assert complaints == ""
        return said

    def run_complaining(self, before: str = "") -> tuple[str, str]:
        """Return what the program prints, and what it prints beside that."""
        with self.start(before) as process:
            found = process.communicate(timeout=300.0)
            assert process.returncode == 0, found
        return found

    def kept(self, name: str = "outer") -> Path:
        """Return the file that holds a function."""
        (path,) = self.with_package.glob(f"press.{name}.*")
        return path


@pytest.fixture
def fresh(tmp_path):
    return Machine(tmp_path)


@pytest.fixture
def machine(fresh):
    """One on which the program has run."""
    assert fresh.run() == COMPILED
    return fresh


def blocked(folder: Path) -> None:
    """Let nothing be written in a folder, not even by root."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.touch()


def test_the_second_process_reads(machine):
    assert machine.run() == READ


def test_a_read_only_package(fresh):
    blocked(fresh.package / "__pycache__")
    assert fresh.run() == COMPILED
    assert fresh.run() == READ
    assert list(fresh.with_user.iterdir())


def test_a_read_only_package_and_home(fresh):
    blocked(fresh.package / "__pycache__")
    blocked(fresh.home / ".cache")
    for _ in range(2):
        said, complaints = fresh.run_complaining()
        assert said == COMPILED
        (places,) = re.fullmatch(WAY_OUT, complaints).groups()
        assert places == f"{fresh.with_package} (Not a directory), {fresh.with_user} (Not a directory)"


def test_no_home(fresh):
    blocked(fresh.package / "__pycache__")
    del fresh.environment["HOME"]
    nobody = "import pwd\ndef unknown(number): raise KeyError\npwd.getpwuid = unknown"
    said, complaints = fresh.run_complaining(nobody)
    assert said == COMPILED
    assert re.fullmatch(WAY_OUT, complaints)
    assert list(fresh.home.iterdir()) == []


def test_a_filled_folder_that_can_no_longer_be_written(machine):
    # As in a container whose image was built after a first solve. Root may write whatever the permissions say.
    written = machine.kept().stat().st_mtime_ns
    refuse = "import os\ndef refuse(*a, **k): raise PermissionError\nos.utime = os.replace = os.rename = refuse"
    assert machine.run(refuse) == READ
    assert machine.kept().stat().st_mtime_ns == written


@pytest.mark.parametrize(
    "damage",
    [
        lambda path: os.truncate(path, path.stat().st_size // 2),
        lambda path: os.truncate(path, 0),
        lambda path: path.write_bytes(np.random.default_rng(1).bytes(20_000)),
        lambda path: shutil.copy(next(path.parent.glob("press.inner.*")), path),
        lambda path: path.unlink(),
    ],
    ids=["cut", "empty", "random", "another's", "missing"],
)
def test_a_damaged_file(machine, damage):
    damage(machine.kept())
    assert machine.run() == COMPILED
    assert machine.run() == READ


def test_permission_lost(machine):
    path = machine.kept()
    path.unlink()
    path.mkdir(mode=0o000)
    blocked(machine.home / ".cache")
    said, complaints = machine.run_complaining()
    assert said == COMPILED
    assert re.fullmatch(WAY_OUT, complaints)


def test_a_full_disk(fresh):
    # Python leaves a cut file of its own bytecode where a disk is full, so all imports come before.
    loaded = "import resource, press.outer, nonhertz.compiled.dispatching"
    full = f"{loaded}; resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))"
    said, complaints = fresh.run_complaining(full)
    assert said == COMPILED
    assert "File too large" in re.fullmatch(WAY_OUT, complaints)[1]
    assert [*fresh.with_package.iterdir(), *fresh.with_user.iterdir()] == []
    assert fresh.run() == COMPILED
    assert fresh.run() == READ


def test_many_at_once(fresh):
    processes = [fresh.start() for _ in range(6)]
    for process in processes:
        said, complaints = process.communicate(timeout=300.0)
        assert (process.returncode, complaints) == (0, "")
        assert said in {COMPILED, READ}
    assert len(list(fresh.with_package.iterdir())) == 2
    assert fresh.run() == READ


# In the compiler, and between writing a file and moving it to its place.
MOMENTS = ["nonhertz.compiled.dispatching._OwnCopies._finalize_final_module", "pathlib.Path.replace"]


def ending(moment: str, number: signal.Signals) -> str:
    """Return code that sends the process a signal at a moment."""
    owner, _, name = moment.rpartition(".")
    module, _, kind = owner.rpartition(".")
    return (
        f"import os, {module}\ndef end(*a): os.kill(os.getpid(), {number:d}); print('went on')\n"
        f"{module}.{kind}.{name} = end"
    )


@pytest.mark.parametrize("moment", MOMENTS)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_a_process_that_is_ended_halfway(fresh, moment, number):
    with fresh.start(ending(moment, number)) as process:
        said, _ = process.communicate(timeout=300.0)
    assert (process.returncode, said) == (-number, "")
    left = list(fresh.with_package.iterdir()) if fresh.with_package.exists() else []
    killed_writing = number == signal.SIGKILL and moment == "pathlib.Path.replace"
    assert [path.name[:7] for path in left] == [".draft-"] * killed_writing
    assert fresh.run() == COMPILED
    assert fresh.run() == READ


def test_an_upgraded_compiler(machine):
    assert machine.run("import numba; numba.__version__ = '1000.0'") == COMPILED
    assert machine.run() == READ


def test_an_upgrade_of_how_we_compile(machine):
    with (machine.package / "compiled/decorator.py").open("a") as file:
        file.write("# Another version.\n")
    assert machine.run() == COMPILED


@pytest.mark.parametrize("with_setting", [False, True])
@pytest.mark.parametrize("year", [None, 1990, 2030])
def test_an_edited_source(fresh, with_setting, year):
    # What calls is in another file than what is called, and the edited one may be older than all that is kept.
    if with_setting:
        fresh.environment["NUMBA_CACHE_DIR"] = str(fresh.home / "elsewhere")
    assert fresh.run() == COMPILED
    path = fresh.write("inner", INNER.replace("2.0", "3.0"))
    if year is not None:
        os.utime(path, ((year - 1970) * 31_557_600.0,) * 2)
    assert fresh.run() == "13.0 compiled\n"
    # Both versions are kept, such as of two branches.
    fresh.write("inner", INNER)
    assert fresh.run() == READ
    assert fresh.with_package.exists() != with_setting


DIGITS = """
import hashlib, sys
import numpy as np
import nonhertz as nh

contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000)), nh.Plate())
sharp = nh.Contact(nh.Roller(diameter=20, length=20, side_faces="mirror"), nh.Ring(diameter=80))

def solve():
    found = [nh.solve(contact, load=20e3), nh.solve(sharp, load=3e4, tilt=1e-3), nh.solve(sharp, load=3e4, strips=50)]
    return [value for each in found for value in (each.approach, each.moment, each.line_load, each.half_width)]

def many():
    found = nh.solve_many(contact, load=np.linspace(1e3, 3e4, 9), tilt=np.linspace(0.0, 1e-3, 9), strips=41)
    return [found.approach, found.moment]

def below():
    solution = nh.solve(sharp, load=3e4)
    points = {"x": [0.0, 0.1, 0.2], "y": [0.0, 3.0, 9.9], "z": [0.05, 0.2, 0.3]}
    return [nh.subsurface.stress(solution, **points, body=body, displacement=True).displacement for body in "ab"]

def grid():
    solution = nh.patch.solve(contact, load=3e3, cells=(16, 32))
    return [solution.pressure, nh.subsurface.stress(solution, x=[0.0, 0.1], y=[0.0, 1.0], z=[0.05, 0.3]).stress]

for name in sys.argv[1:]:
    values = b"".join(np.ascontiguousarray(value).tobytes() for value in globals()[name]())
    print(name, hashlib.sha256(values).hexdigest())
"""


def digits(folder: Path, *names: str) -> dict[str, str]:
    """Return digests of results that a process finds one after the other."""
    ended = subprocess.run(
        [sys.executable, "-c", DIGITS, *names],
        env=os.environ | {"NUMBA_CACHE_DIR": str(folder)}, capture_output=True, text=True, check=True, timeout=1800.0,
    )  # fmt: skip
    return dict(line.split() for line in ended.stdout.splitlines())


def test_results_are_the_same_bytes_wherever_machine_code_comes_from(tmp_path):
    names = "solve", "many", "below", "grid"
    compiling = digits(tmp_path / "one", *names)
    files = {path: path.stat().st_ino for path in (tmp_path / "one/nonhertz").iterdir()}
    assert set(compiling) == set(names)
    # Another order of loading, each alone, and another order of compiling.
    assert digits(tmp_path / "one", *reversed(names)) == compiling
    assert {name: digits(tmp_path / "one", name)[name] for name in names} == compiling
    # Nothing was compiled by those that read.
    assert {path: path.stat().st_ino for path in (tmp_path / "one/nonhertz").iterdir()} == files
    assert digits(tmp_path / "two", *reversed(names)) == compiling


def test_after_warm_no_command_compiles_anything(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(kept)}
    case = str(Path(__file__).parents[2] / "examples" / "crowned-roller.toml")

    def run(*words: str) -> str:
        command = [sys.executable, "-m", "nonhertz", *words]
        return subprocess.run(command, env=environment, cwd=tmp_path, check=True, capture_output=True, text=True).stdout

    assert f"MB in {kept}" in run("warm")
    files = {path.name for path in kept.rglob("nonhertz.*")}
    assert len(files) > 50
    for words in (["solve", case], ["stress", case], ["life", case], ["compare", case, "--cells", "32", "64"]):
        run(*words)
        assert {path.name for path in kept.rglob("nonhertz.*")} == files, words
