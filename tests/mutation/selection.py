"""Tests in a process of their own, and the plugin of pytest in it: which run, for how long, and through which lines."""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import sitecustomize

PROCESSOR, OUTCOME = "seconds of processor", "outcome"
CHOSEN, WRITTEN, LINES, LONGEST = "MUTATION_TESTS", "MUTATION_RESULTS", "MUTATION_LINES", "MUTATION_LONGEST_TEST"
tracers: list[Any] = []
late: list[bool] = []


class TooLongError(BaseException):
    """A test takes too long; no `Exception`, since hypothesis would look for a shorter example of those."""


def run(folder: Path, sources: Path, names: dict[str, str], limit: float, arguments: list[str]) -> None:
    """Run tests in ``folder``, where hypothesis keeps its examples, for so many seconds of processor."""
    import resource  # which not every system has

    os.setsid()
    os.chdir(folder)
    with Path("output.txt").open("wb") as output:
        os.dup2(output.fileno(), 1)
        os.dup2(output.fileno(), 2)
    resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 1))
    os.environ |= names | {"PYTHONPATH": os.pathsep.join([str(sources.parent), str(Path(__file__).parent)])}
    sys.path.insert(0, str(sources.parent))
    sitecustomize.change()
    sys.exit(pytest.main(arguments, plugins=[sys.modules[__name__]]))


def pytest_sessionstart() -> None:
    """Begin to trace, where lines are asked for."""
    if LINES in os.environ:
        import coverage

        sources = str(Path(__file__).parents[2] / "src" / "*")
        tracers.append(coverage.Coverage(data_file=os.environ[LINES], include=[sources], config_file=False))
        tracers[0].start()


def pytest_sessionfinish() -> None:
    """Write down which test ran through which lines."""
    for tracer in tracers:
        tracer.stop()
        tracer.save()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests in the list, in its order."""
    if CHOSEN in os.environ:
        order = {name: k for k, name in enumerate(json.loads(Path(os.environ[CHOSEN]).read_text(encoding="utf-8")))}
        items[:] = sorted((each for each in items if each.nodeid in order), key=lambda each: order[each.nodeid])


def pytest_runtest_logreport(report: Any) -> None:
    """Write a line for every test that ran, and for what failed before it could."""
    if report.when == "call" or report.outcome != "passed":
        known = dict(report.user_properties)
        outcome = known.get(OUTCOME, report.outcome)
        line = json.dumps({"test": report.nodeid, "outcome": outcome, "seconds": known.get(PROCESSOR, 0.0)})
        with Path(os.environ[WRITTEN]).open("a", encoding="utf-8") as file:
            file.write(line + "\n")


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> Iterator[None]:
    """Limit and note what a test needs."""
    for tracer in tracers:
        tracer.switch_context(item.nodeid)
    return (yield from _limited(item))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """Limit and note the test."""
    return (yield from _limited(item))


def _limited(item: pytest.Item) -> Iterator[None]:
    """Raise in what takes more processor time than it may, and note the time, which other programs do not lengthen."""
    begun = time.process_time()
    late.clear()
    signal.signal(signal.SIGPROF, _end)
    signal.setitimer(signal.ITIMER_PROF, float(os.environ.get(LONGEST, "0")))
    try:
        return (yield)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        if late:  # whatever became of the error where it was raised, in a compiler for instance
            item.user_properties.append((OUTCOME, "too long"))
        before = dict(item.user_properties).get(PROCESSOR, 0.0)
        item.user_properties.append((PROCESSOR, before + time.process_time() - begun))


def _end(number: int, frame: object) -> None:
    late.append(True)
    raise TooLongError
