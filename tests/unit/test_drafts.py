"""Folders of drafts are removed when done with, by the next run if need be, and never while a process uses them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.io import drafts
from nonhertz.io.drafts import PREFIX, drafts_in
from nonhertz.io.folder import write_files

pytestmark = pytest.mark.skipif(os.name != "posix", reason="folders are locked as Unix does")


def left_by_a_killed_process(directory: Path) -> Path:
    program = (
        "import sys, time\n"
        "from pathlib import Path\n"
        "from nonhertz.io.drafts import drafts_in\n"
        "with drafts_in(Path(sys.argv[1])) as folder:\n"
        "    (folder / 'half.txt').write_text('half')\n"
        "    print(folder, flush=True)\n"
        "    time.sleep(1000)\n"
    )
    environment = os.environ | {"PYTHONPATH": str(Path(nh.__file__).parents[1])}
    command = [sys.executable, "-c", program, str(directory)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        assert process.stdout is not None
        folder = Path(process.stdout.readline().strip())
        process.send_signal(signal.SIGKILL)
    assert (folder / "half.txt").read_text() == "half"
    return folder


ONE = {"one.txt": "whole"}


@pytest.mark.parametrize("name", ["result.json", "surface.VTU", "new/rows.parquet"])
def test_a_new_directory_is_not_called_as_files_are(name, tmp_path):
    with pytest.raises(
        nh.InputError, match=r"--out = .* must be a directory, and looks like a file: write '.*', in which"
    ):
        write_files(tmp_path / name, ONE)
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "old.json").mkdir()
    assert len(write_files(tmp_path / "old.json", ONE)) == len(write_files(tmp_path / "v1.2", ONE)) == 1


def test_what_a_killed_process_left_is_swept_by_the_next_run(tmp_path: Path) -> None:
    left_by_a_killed_process(tmp_path)
    write_files(tmp_path, ONE)
    assert [path.name for path in tmp_path.iterdir()] == ["one.txt"]


def test_what_another_run_is_writing_stays(tmp_path: Path) -> None:
    with drafts_in(tmp_path) as living:
        (living / "two.txt").write_text("half")
        write_files(tmp_path, ONE)
        assert (living / "two.txt").read_text() == "half"
    assert [path.name for path in tmp_path.iterdir()] == ["one.txt"]


def test_what_is_not_ours_stays(tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere"
    kept = [".nonhertz-settings", f"{PREFIX}by-me", f"{PREFIX}longer_than_8"]
    for name in kept:
        (tmp_path / name).mkdir()
    elsewhere.mkdir()
    (tmp_path / f"{PREFIX}linked_8").symlink_to(elsewhere)
    (tmp_path / f"{PREFIX}a_file_8").write_text("mine")
    write_files(tmp_path, ONE)
    names = {path.name for path in tmp_path.iterdir()}
    assert names == {"elsewhere", "one.txt", f"{PREFIX}linked_8", f"{PREFIX}a_file_8", *kept}


def test_nothing_is_swept_where_nothing_can_be_locked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    abandoned = left_by_a_killed_process(tmp_path)
    monkeypatch.setattr(drafts, "_lock", lambda descriptor: None)
    write_files(tmp_path, ONE)
    assert {path.name for path in tmp_path.iterdir()} == {"one.txt", abandoned.name}


def test_a_folder_that_is_swept_before_it_is_locked_is_made_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    locked = drafts._lock
    swept: list[int] = []

    def late(descriptor: int) -> bool | None:
        if not swept:
            swept.append(descriptor)
            (first,) = tmp_path.iterdir()
            first.rmdir()
        return locked(descriptor)

    monkeypatch.setattr(drafts, "_lock", late)
    write_files(tmp_path, ONE)
    assert [path.name for path in tmp_path.iterdir()] == ["one.txt"]
