"""``nonhertz sweep``: what people type, and what survives a crash."""

import json
import os
import random
import re
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import jsonschema
import pytest
from crowned_roller import CASE

from nonhertz.cli.sweep import report_rows
from nonhertz.files.schemas import schema_of
from nonhertz.study.sweeps import Progress, _seconds_per_row


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "roller.toml").write_text(CASE, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
def test_a_case_is_swept_from_the_command_line(folder, run):
    out = run("sweep", "roller.toml", "--over", "load.load=5kN:20kN:4", "load.tilt=0,0.5mrad").out
    title, verdict, rows, *_ = out.splitlines()
    assert (title, rows) == ("A roller on a plate", "8 rows")
    assert verdict.startswith("Pressure unbounded in row 7. The pressure grows without limit towards the sharp ends ")
    assert re.search(r"load\.load  5 to 20 kN +4 values", out)
    assert "maximum pressure" in out
    names = {path.name for path in (folder / "roller-sweep").iterdir()}
    assert names == {"rows.sqlite3", "rows.csv", "rows.parquet", "sweep.svg", "sweep.png", "sweep.csv"}


def test_a_plan_is_checked_and_swept(folder, run):
    text = 'case = "roller.toml"\nquantities = ["approach"]\n[samples]\ncount = 5\n'
    text += '[over]\n"load.load" = "normal(20 kN, 1 kN)"\n'
    (folder / "plan.toml").write_text(text, encoding="utf-8")
    assert run("check", "plan.toml").out == "plan.toml is fine: 'plan', a sweep of 5 rows over load.load.\n"
    found = run("sweep", "plan.toml", "--json", "--out", "found").json
    jsonschema.validate(found, schema_of("sweep"))
    assert (found["rows"], found["failed"], found["over"]) == (5, 0, ["load.load"])
    assert found["extremes"]["approach"][0] < found["extremes"]["approach"][1]
    assert (folder / "found" / "sweep.svg").exists()


def test_how_long_the_rows_take_is_said_first_and_where_they_continue(capsys):
    announce = report_rows(None)
    announce(Progress(done=0, total=10_000, resumed=0, seconds=236.0))
    announce(Progress(done=5495, total=10_000, resumed=5495, seconds=9.0))
    announce(Progress(done=0, total=12, resumed=0, seconds=None))
    announce(Progress(done=6000, total=10_000, resumed=5495))
    announce(Progress(done=12, total=12, resumed=12))
    first, second, third = capsys.readouterr().err.splitlines()
    assert (first, second) == ("10000 rows, about 4 minutes", "continuing from 5495 of 10000 rows")
    assert third == "all 12 rows had been solved before"


def test_the_time_of_rows_is_that_of_one_times_their_number(monkeypatch):
    """A clock that only solving moves: 20 ms a row, the first of them 3 s."""
    now, solved = [0.0], []

    def solve(portion):
        now[0] += 0.02 * len(portion[2]) + (0.0 if solved else 3.0)
        solved.append(len(portion[2]))

    monkeypatch.setattr("nonhertz.study.sweeps.time.perf_counter", lambda: now[0])
    rows = list(range(100))
    assert _seconds_per_row(solve, (0, rows, [(float(row),) for row in rows])) == pytest.approx(0.02)
    assert solved == [1, 1, 2, 4, 8, 16]


def test_json_is_ascii_and_comes_through_a_pipe_of_any_encoding(folder, run):
    text = (folder / "roller.toml").read_text(encoding="utf-8")
    (folder / "roller.toml").write_text(text.replace("A roller on a plate", "Ø 15 μm"), encoding="utf-8")
    printed = run("sweep", "roller.toml", "--over", "load.load=5kN,6kN", "--json", "--out", "found").out
    assert printed.isascii()
    assert json.loads(printed)["title"] == "Ø 15 μm"


def test_mistakes_of_a_plan_are_listed(folder, run):
    (folder / "plan.toml").write_text(
        'case = "roller.toml"\n[over]\n"load.laod" = []\nload.tilt = []\n', encoding="utf-8"
    )
    said = run("check", "plan.toml", code=2).out.splitlines()
    assert [line[:2] for line in said] == ["1.", "2."]
    assert said[0] == "1. Unknown key over.load.laod. Did you mean over.load.load?"


def command(*words: str) -> list[str]:
    over = ["--over", "load.load=1kN:30kN:40", "load.tilt=-1mrad:1mrad:41", "--quantities", "approach", "max_pressure"]
    return [sys.executable, "-m", "nonhertz", "sweep", "roller.toml", *over, *words]


def rows_in(file: Path) -> int | None:
    """Return how many rows are there, 0 before there are any; None if a change has to be taken back first."""
    if not file.exists():
        return 0
    rows = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    try:
        return int(rows.execute("select count(*) from rows").fetchone()[0])
    except sqlite3.OperationalError as error:  # the table is not yet there, or the next run has to tidy up
        return 0 if "no such table" in str(error) else None
    finally:
        rows.close()


def changed(file: Path) -> int:
    """Return when a file was written to last; 0 before it is there."""
    return file.stat().st_mtime_ns if file.exists() else 0


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Give the rows of a sweep that nothing disturbs."""
    folder = tmp_path_factory.mktemp("whole")
    (folder / "roller.toml").write_text(CASE, encoding="utf-8")
    subprocess.run(command("--out", "whole"), check=True, stdout=subprocess.DEVNULL, timeout=300, cwd=folder)
    return (folder / "whole" / "rows.csv").read_bytes()


@pytest.mark.slow
def test_killed_at_random_moments_no_row_is_lost_or_doubled(folder, whole):
    store, seed, there = folder / "killed" / "rows.sqlite3", random.Random(5), [0]
    for kill in range(6):
        running = subprocess.Popen(command("--out", "killed", "--workers", "1"), stdout=subprocess.DEVNULL)
        # Some while it starts, the others at any moment after some more portions; while it runs, the rows are locked.
        written, awaited = {changed(store)}, 0 if kill % 5 == 4 else seed.randrange(2, 6)
        while running.poll() is None and len(written) <= awaited:
            time.sleep(0.002)
            written.add(changed(store))
        time.sleep(seed.uniform(0.0, 0.03))
        running.kill()
        running.wait()
        if (rows := rows_in(store)) is not None:
            there.append(rows)
    assert there == sorted(there)
    assert len({count for count in there if 0 < count < 1640}) > 2
    subprocess.run(command("--out", "killed"), check=True, stdout=subprocess.DEVNULL, timeout=300)
    assert (folder / "killed" / "rows.csv").read_bytes() == whole


@pytest.fixture
def cluster():
    """Give the address of a scheduler and two workers, in processes of their own."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "env": os.environ | {"OMP_NUM_THREADS": "1"}}
    words = ["distributed.cli.dask_scheduler", "--port", "0", "--host", "127.0.0.1", "--no-dashboard"]
    scheduler = subprocess.Popen([sys.executable, "-m", *words], **quiet)
    assert scheduler.stderr is not None
    for line in scheduler.stderr:
        if b"Scheduler at:" in line:
            address = line.split(b"Scheduler at:")[1].strip().decode()
            break
    workers = [worker(address), worker(address)]
    yield address, workers
    for each in (*workers, scheduler):
        each.kill()
        each.wait()
    scheduler.stderr.close()


def worker(address: str) -> subprocess.Popen[bytes]:
    """Return a running worker of one thread."""
    words = ["--nthreads", "1", "--no-nanny", "--no-dashboard"]
    command = [sys.executable, "-m", "distributed.cli.dask_worker", address, *words]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


@pytest.mark.slow
def test_on_a_cluster_a_worker_may_be_killed_and_another_added(folder, cluster, whole):
    address, workers = cluster
    running = subprocess.Popen(command("--out", "spread", "--scheduler", address), stdout=subprocess.DEVNULL)
    until = time.monotonic() + 120.0
    while not rows_in(folder / "spread" / "rows.sqlite3") and not (folder / "spread" / "rows.csv").exists():
        # The file is locked while it is written: a few seconds are enough for the first rows.
        if time.monotonic() > until - 116.0:
            break
        time.sleep(0.1)
    workers[0].kill()
    workers.append(worker(address))
    assert running.wait(timeout=300) == 0
    assert (folder / "spread" / "rows.csv").read_bytes() == whole


@pytest.mark.slow
def test_an_address_where_nothing_answers_is_refused(folder, run, monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr("nonhertz.study.workers.CONNECTING", "1s")
    words = ["sweep", "roller.toml", "--over", "load.load=1kN,2kN", "--scheduler", "tcp://127.0.0.1:9"]
    assert "--scheduler = 'tcp://127.0.0.1:9' must be the address of a scheduler" in run(*words, code=2).err


@pytest.mark.parametrize("address", ["", "here", "10.0.0.1", "tcp://", "tcp://here:port", "tcp://a b:1"])
def test_what_is_no_address_is_refused_before_anything_is_asked(folder, run, address):
    pytest.importorskip("distributed")
    assert (
        f"--scheduler = '{address}' must be the address of a scheduler, with a port"
        in run("sweep", "roller.toml", "--over", "load.load=1kN,2kN", "--scheduler", address, code=2).err
    )


def test_why_rows_failed_is_said_in_the_units_that_are_read(folder, run):
    words = ["sweep", "roller.toml", "--over", "load.moment=0Nm,300Nm", "--quantities", "approach"]
    kept = "must keep moment / load between -10 and 10 mm"
    for units, sentence in (("us", "must keep moment / load between -0.3937 and 0.3937 in"), ("si", kept)):
        assert sentence in run(*words, "--units", units).out
        assert kept in (folder / "roller-sweep" / "rows.csv").read_text(encoding="utf-8")
