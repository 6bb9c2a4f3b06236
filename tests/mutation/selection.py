"""A plugin of pytest: runs the chosen tests alone, the fastest first, and writes down how each ended."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

PROCESSOR = "seconds of processor"
CHOSEN, WRITTEN, LONGEST = "MUTATION_TESTS", "MUTATION_RESULTS", "MUTATION_LONGEST_TEST"


class TooLongError(BaseException):
    """A test takes too long; no `Exception`, since hypothesis would look for a shorter example of those."""


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep the tests in the list, in its order."""
    if CHOSEN in os.environ:
        order = {name: k for k, name in enumerate(json.loads(Path(os.environ[CHOSEN]).read_text(encoding="utf-8")))}
        items[:] = sorted((each for each in items if each.nodeid in order), key=lambda each: order[each.nodeid])


def pytest_runtest_logreport(report: Any) -> None:
    """Write a line for every test that ran, and for what failed before it could."""
    if WRITTEN in os.environ and (report.when == "call" or report.outcome != "passed"):
        seconds = dict(report.user_properties).get(PROCESSOR, 0.0)
        line = json.dumps({"test": report.nodeid, "outcome": report.outcome, "seconds": seconds})
        with Path(os.environ[WRITTEN]).open("a", encoding="utf-8") as file:
            file.write(line + "\n")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup() -> Iterator[None]:
    """End what a test needs where it takes too long."""
    return (yield from _limited())


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """End a test that takes too long, and note its processor time, which other programs do not lengthen."""
    begun = time.process_time()
    try:
        return (yield from _limited())
    finally:
        item.user_properties.append((PROCESSOR, time.process_time() - begun))


def _limited() -> Iterator[None]:
    """Raise in what takes more processor time than it may."""
    seconds = float(os.environ.get(LONGEST, "0"))
    signal.signal(signal.SIGPROF, _end)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        return (yield)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


def _end(number: int, frame: object) -> None:
    raise TooLongError
