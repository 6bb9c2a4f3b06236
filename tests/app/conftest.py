"""What tests of several commands share."""

from pathlib import Path

import pytest

from nonhertz.cli import main


@pytest.fixture
def leaves_nothing_behind(capsys, monkeypatch):
    """Assert that a command that fails while it writes prints nothing and leaves no directory behind."""

    def fail(*_: object) -> None:
        raise RuntimeError("the pen broke")

    def check(module: object, function: str, arguments: list[str]) -> None:
        monkeypatch.setattr(module, function, fail)
        assert main([*arguments, "--out", "new/folder"]) == 3
        assert capsys.readouterr().out == ""
        assert not Path("new").exists()

    return check
