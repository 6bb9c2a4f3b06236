"""`nonhertz warm`; that nothing is compiled after it is among the tests of machine code."""

import pytest

from nonhertz.cli import main, warm
from nonhertz.compiled import notices


@pytest.mark.slow
def test_it_runs_every_part_and_names_the_folder(capsys):
    assert main(["warm"]) == 0
    *parts, kept = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in parts] == list(warm.PARTS)
    assert kept.startswith("machine code: ")
    assert "machine-code" in kept


def test_the_exit_code_says_that_nothing_can_be_kept(caplog, monkeypatch):
    monkeypatch.setattr(warm, "PARTS", {"strips": lambda: notices.warn_unkept("/nowhere (read-only)")})
    monkeypatch.setattr(notices, "_said", set())
    assert main(["warm"]) == 1
    assert "nothing can be written in /nowhere (read-only)" in caplog.text
