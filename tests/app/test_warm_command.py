"""`nonhertz warm`: it compiles everything, and says where that is kept."""

from pathlib import Path

import pytest

from nonhertz.cli import main, warm
from nonhertz.compiled import cache, files


@pytest.mark.slow
def test_after_every_part_no_command_compiles_anything(capsys, monkeypatch):
    assert main(["warm"]) == 0
    *parts, kept = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in parts] == list(warm.PARTS)
    assert kept.startswith("machine code: ")
    assert "machine-code" in kept
    written, case = [], str(Path(__file__).parents[2] / "examples" / "crowned-roller.toml")
    monkeypatch.setattr(cache, "write", lambda name, key, content: written.append(name))
    for words in (["solve", case], ["stress", case], ["life", case], ["compare", case, "--cells", "32", "64"]):
        main(words)
    assert written == []


def test_the_exit_code_says_that_nothing_can_be_kept(tmp_path, caplog, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    monkeypatch.setattr(warm, "PARTS", {})
    files.log_once.cache_clear()
    assert main(["warm"]) == 1
    assert f"nothing can be written in {tmp_path / 'file' / 'nonhertz'} (Not a directory)" in caplog.text
