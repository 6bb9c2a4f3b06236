"""The processes that compute for the page: ended when they take too long, replaced when they end."""

import contextlib
import os
import signal
import time
from functools import partial

import anyio
import pytest
from starlette.exceptions import HTTPException

from nonhertz.web.server import workers
from nonhertz.web.server.workers import EndedError, FailedError, TooSlowError, Workers

DEADLINE = 0.1
PATIENT = 60.0


def doubled(value):
    return 2 * value


def own_number():
    return os.getpid()


def never_done():
    while True:
        time.sleep(0.01)


def dying():
    os._exit(1)


def raising():
    raise ZeroDivisionError("by zero")


def dying_the_first_time(path):
    if not path.exists():
        path.touch()
        os._exit(1)


def with_workers(count, use, warm_up=None, **options):
    """Run ``use(workers)`` with so many processes."""

    async def run():
        workers = Workers(count, warm_up, **options)
        async with anyio.create_task_group() as tasks:
            workers.start(tasks)
            try:
                return await use(workers)
            finally:
                tasks.cancel_scope.cancel()
                workers.end()

    return anyio.run(run)


posix = pytest.mark.skipif(os.name != "posix", reason="signal 0 asks whether a process lives on Unix alone")


@pytest.mark.slow
@posix
@pytest.mark.parametrize(("job", "error"), [(never_done, TooSlowError), (dying, EndedError)])
def test_a_process_that_takes_too_long_or_ends_is_replaced(job, error):
    async def use(workers):
        first = await workers.run(own_number, seconds=PATIENT)
        with pytest.raises(error):
            await workers.run(job, seconds=DEADLINE if job is never_done else PATIENT)
        while True:
            with contextlib.suppress(HTTPException):  # until there is another
                return first, await workers.run(own_number, seconds=PATIENT)

    first, second = with_workers(1, use)
    assert first != second
    with pytest.raises(ProcessLookupError):
        os.kill(first, 0)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "waitid"), reason="waits for a process without taking note of its end")
def test_a_process_that_was_ended_while_it_had_nothing_to_do_is_replaced():
    async def use(workers):
        first = await workers.run(own_number, seconds=PATIENT)
        os.kill(first, signal.SIGKILL)
        os.waitid(os.P_PID, first, os.WEXITED | os.WNOWAIT)
        while True:
            with contextlib.suppress(HTTPException):  # until there is another
                return first, await workers.run(own_number, seconds=PATIENT)

    first, second = with_workers(1, use)
    assert first != second


@pytest.mark.slow
def test_a_process_that_does_not_start_is_started_again(tmp_path, monkeypatch):
    monkeypatch.setattr(workers, "_PAUSE", 0.0)

    async def use(crew):
        while not crew.ready.is_set():
            await anyio.sleep(0.01)
        return await crew.run(doubled, 21, seconds=PATIENT)

    assert with_workers(1, use, partial(dying_the_first_time, tmp_path / "was here")) == 42


def test_a_job_that_fails_is_told_and_its_process_goes_on():
    async def use(workers):
        first = await workers.run(own_number, seconds=PATIENT)
        with pytest.raises(FailedError, match="ZeroDivisionError: by zero"):
            await workers.run(raising, seconds=PATIENT)
        return first, await workers.run(own_number, seconds=PATIENT)

    first, second = with_workers(1, use)
    assert first == second


@pytest.mark.slow
def test_a_long_job_has_a_process_of_its_own_and_the_next_waits_for_its_end():
    async def use(workers):
        outcomes = []

        async def ask():
            outcomes.append(await workers.run_apart(own_number, seconds=PATIENT))

        async with anyio.create_task_group() as tasks:
            tasks.start_soon(ask)
            tasks.start_soon(ask)
        return [await workers.run(own_number, seconds=PATIENT), os.getpid(), *outcomes]

    assert len(set(with_workers(1, use))) == 4


@posix
def test_all_processes_end_with_the_server():
    async def use(workers):
        return await workers.run(own_number, seconds=PATIENT)

    number = with_workers(1, use)
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)
