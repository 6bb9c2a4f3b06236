"""Machine code on disk through whatever befalls it: the right answer or a sentence, never an old answer."""

import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import nonhertz

pytestmark = pytest.mark.slow

INNER = "from nonhertz.compiled import compiled\nRATE = 2.0\n@compiled\ndef inner(x):\n    return RATE * x * x\n"
OUTER = "from nonhertz.inner import compiled, inner\n@compiled\ndef outer(x):\n    return inner(x) + 1.0\n"
RUN = """
import os, pathlib, nonhertz.compiled.cache as cache
from nonhertz.outer import outer, inner
written, write = [], cache.write
cache.write = lambda *given: written.append(write(*given))
{}
print(outer(2.0), "compiled" if written else "read")
"""
COMPILED, READ = "9.0 compiled\n", "9.0 read\n"
SENTENCE = r"The compiled solver cannot be kept, .*: nothing can be written in .*\. Set NUMBA_CACHE_DIR .*\n"


class Machine:
    """A user's home, and two functions beside a copy of our use of Numba, run by processes of their own."""

    def __init__(self, root):
        self.package, self.home = root / "site/nonhertz", root / "home"
        shutil.copytree(Path(nonhertz.__file__).parent / "compiled", self.package / "compiled")
        self.home.mkdir()
        for name, source in {"__init__": "", "inner": INNER, "outer": OUTER}.items():
            (self.package / f"{name}.py").write_text(source)
        self.kept = self.package / "__pycache__/machine-code"
        named = {name: os.environ[name] for name in ("PATH", "SYSTEMROOT") if name in os.environ}
        self.environment = named | {"HOME": str(self.home), "PYTHONPATH": str(root / "site"), "PYTHONWARNINGS": "error"}

    def start(self, before=""):
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        command = [sys.executable, "-c", RUN.format(before)]
        return subprocess.Popen(command, env=self.environment, cwd=self.home, **pipes)

    def run(self, before="", sentence=""):
        """Return what is printed; beside that nothing is said but the sentence."""
        said, beside = self.start(before).communicate(timeout=300.0)
        assert re.fullmatch(sentence, beside), beside
        return said


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


def test_folders_that_cannot_be_written_one_after_the_other(machine):
    refuse = "def refuse(*a, **k): raise PermissionError\nos.replace = os.rename = os.mkdir = refuse"
    assert [machine.run(), machine.run(), machine.run(refuse)] == [COMPILED, READ, READ]
    shutil.rmtree(machine.kept.parent)
    machine.kept.parent.touch()  # not even root can write there
    assert [machine.run(), machine.run()] == [COMPILED, READ]  # with the user
    shutil.rmtree(machine.home / ".cache")
    (machine.home / ".cache").touch()
    assert [machine.run(sentence=SENTENCE), machine.run(sentence=SENTENCE)] == [COMPILED, COMPILED]
    del machine.environment["HOME"]
    nobody = "import pwd\ndef unknown(number): raise KeyError\npwd.getpwuid = unknown"
    assert machine.run(nobody, SENTENCE) == COMPILED
    assert [path.name for path in machine.home.iterdir()] == [".cache"]


def test_a_damaged_file_is_replaced(machine):
    machine.run("inner(2.0)")
    outer, inner = sorted(machine.kept.iterdir(), key=lambda path: "inner.inner" in path.name)
    data = outer.read_bytes()
    for damaged in (data[:-1], inner.read_bytes(), None):
        outer.unlink()
        outer.mkdir(mode=0o000) if damaged is None else outer.write_bytes(damaged)
        assert [machine.run(), machine.run()] == [COMPILED, READ]  # the last from the user's folder


def test_a_full_disk_and_many_at_once(machine):
    full = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))"
    assert machine.run(full, SENTENCE.replace("in .*", "in .*File too large.*")) == COMPILED
    started = [machine.start() for _ in range(4)]
    assert {each.communicate(timeout=300.0)[0] for each in started} <= {COMPILED, READ}
    assert [len(list(machine.kept.iterdir())), machine.run()] == [1, READ]


@pytest.mark.parametrize(
    ("moment", "number"), [("cache.dumps", signal.SIGINT), ("pathlib.Path.replace", signal.SIGKILL)]
)
def test_a_process_that_is_ended_halfway(machine, moment, number):
    with machine.start(f"def end(*given): os.kill(os.getpid(), {number:d}); print('on')\n{moment} = end") as process:
        assert process.communicate(timeout=300.0)[0] == ""
    assert process.returncode == -number
    assert [machine.run(), machine.run()] == [COMPILED, READ]


def test_an_upgrade_other_settings_and_edited_sources(machine):
    upgrade, settings = "cache.numba.__version__ = '0'", "os.environ['NUMBA_OPT'] = '1'"
    for change in ("", upgrade, settings, "cache.OPTIONS['fastmath'] = True"):
        assert machine.run(change) == COMPILED
    path, edited = machine.package / "inner.py", INNER.replace("2.0", "3.0")
    # A process that has imported the old source goes on with that, and keeps it as what it is.
    assert machine.run(f"pathlib.Path({str(path)!r}).write_text({edited!r})") == READ
    for year in (1990, 2030):  # older than what is kept, or from the future
        os.utime(path, ((year - 1970) * 31_557_600.0,) * 2)
        assert machine.run() == ("13.0 compiled\n" if year == 1990 else "13.0 read\n")
    path.write_text(INNER)
    assert machine.run() == READ
    machine.environment["NUMBA_CACHE_DIR"] = str(machine.home / "elsewhere")
    assert [machine.run(), machine.run()] == [COMPILED, READ]
