"""Standard streams that are closed, full or read by nobody, and an environment that is meant for others."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import nonhertz as nh

CASE = Path(__file__).parents[2] / "examples" / "crowned-roller.toml"
ENVIRONMENT = os.environ | {"PYTHONPATH": str(Path(nh.__file__).parents[1])}
CLOSED = "The output could not be written: standard output is closed.\n"

pytestmark = pytest.mark.skipif(os.name != "posix", reason="streams are closed as a Unix shell does")


def ran(words: str, streams: str = "", **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a command from a shell, with its streams redirected."""
    line = f'exec "$@" {streams}'
    return subprocess.run(
        ["/bin/sh", "-c", line, "sh", sys.executable, "-m", "nonhertz", *words.split()],
        capture_output=True,
        text=True,
        check=False,
        env=ENVIRONMENT | environment,
    )


def test_a_closed_output_is_told_and_nothing_is_done(tmp_path):
    done = ran(f"solve {CASE} --out {tmp_path / 'out'}", ">&-")
    assert (done.returncode, done.stderr) == (3, CLOSED)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_a_closed_error_stream_ends_no_solve():
    done = ran(f"solve {CASE}", "2>&-")
    assert done.returncode == 0
    assert done.stdout.startswith("Roller 20 x 20 on a plate\n")


def test_with_all_streams_closed_the_code_alone_tells():
    assert ran("new", "<&- >&- 2>&-").returncode == 3


def test_what_is_opened_does_not_end_up_in_the_place_of_a_closed_stream(tmp_path):
    program = (
        "import sys, nonhertz.cli\nnonhertz.cli.main(['--version'])\nsys.exit(min(open(sys.argv[1], 'w').fileno(), 3))"
    )
    line = 'exec "$@" <&- >&- 2>&-'
    words = [sys.executable, "-c", program, str(tmp_path / "file")]
    assert subprocess.run(["/bin/sh", "-c", line, "sh", *words], check=False, env=ENVIRONMENT).returncode == 3


@pytest.mark.parametrize("words", ["--help", f"solve {CASE}"])
@pytest.mark.slow
def test_a_command_that_nobody_reads_ends_as_others_do(words):
    read, write = os.pipe()
    os.close(read)
    try:
        command = [sys.executable, "-m", "nonhertz", *words.split()]
        done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, text=True, check=False, env=ENVIRONMENT)
    finally:
        os.close(write)
    assert (done.returncode, done.stderr) == (141, "")


@pytest.mark.slow
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is always full")
def test_a_full_disk_below_the_output_is_one_sentence():
    done = ran("new", ">/dev/full")
    assert (done.returncode, done.stderr) == (3, "The output could not be written: No space left on device.\n")


def test_no_screen_is_asked_for_figures():
    program = (
        "import nonhertz.cli; nonhertz.cli.main(['--version']); import matplotlib; print(matplotlib.get_backend())"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=False,
        env=ENVIRONMENT | {"MPLBACKEND": "junk"},
    )
    assert done.stderr == ""
    assert done.stdout.splitlines()[-1] == "agg"
