"""A folder to work in, and commands run there: what they print, and how they end."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from nonhertz.cli import main


@dataclass(frozen=True)
class Printed:
    """What a command prints on both streams."""

    out: str
    err: str

    @property
    def json(self) -> Any:
        """The one JSON value that the output is, of the numbers that JSON has."""
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} is not JSON"))


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    """Return the folder in which the test runs, empty."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def run(capsys) -> Callable[..., Printed]:
    """Return what runs a command, given as its words, and returns a `Printed`; it must end with the code."""

    def run(*words: str, code: int = 0) -> Printed:
        capsys.readouterr()
        ended = main(list(words))
        printed = Printed(*capsys.readouterr())
        assert ended == code, printed.err
        return printed

    return run
