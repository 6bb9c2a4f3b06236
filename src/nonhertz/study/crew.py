"""Who solves the portions of a study: this process, processes on this machine, or a Dask cluster.

Each takes a function and what it is to be called with, and gives back results in the order in which they are found. A
process that ends in the middle of a portion, for want of memory, say, costs no more than that portion's time: those
that were under way are tried again one at a time, and only one that ends its process every time is given up.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import re
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Protocol, TypeVar

from nonhertz.errors import InputError, NonhertzError

Given = TypeVar("Given")
Found = TypeVar("Found")

AHEAD = 3  # portions handed out per process: so few that memory stays flat
ATTEMPTS = 2  # alone, of a portion that was under way when a process ended
CONNECTING = "20s"
_ADDRESS = re.compile(r"(?:[a-z]+://)?[^\s/]+:\d+/?")
_MOST = 61 if sys.platform == "win32" else sys.maxsize  # processes: Windows waits for no more at once
# Linear algebra of one portion on one thread: the processes share the cores.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


class LostError(NonhertzError):
    """A portion whose process ended every time that it was tried."""

    def __init__(self) -> None:
        super().__init__("The process that solved it ended every time it was tried, perhaps for want of memory.")


class Crew(Protocol):
    """Who solves portions."""

    def run(self, solve: Callable[[Given], Found], each: Iterable[Given]) -> Iterator[tuple[Given, Found | LostError]]:
        """Yield what is given with what is found of it, in the order in which it is found."""

    def close(self) -> None:
        """Let processes end."""


class Here:
    """The process that calls."""

    def run(self, solve: Callable[[Given], Found], each: Iterable[Given]) -> Iterator[tuple[Given, Found | LostError]]:
        """Yield what is given with what is found of it."""
        for given in each:
            yield given, solve(given)

    def close(self) -> None:
        """Do nothing."""


class Processes:
    """Processes on this machine, which wait for more work until they are closed.

    Parameters
    ----------
    workers : int
        How many.
    """

    def __init__(self, workers: int) -> None:
        self._workers = workers
        self._open = contextlib.ExitStack()
        self._pool: ProcessPoolExecutor | None = None

    def close(self) -> None:
        """Let processes end."""
        self._pool = None
        self._open.close()

    def run(self, solve: Callable[[Given], Found], each: Iterable[Given]) -> Iterator[tuple[Given, Found | LostError]]:
        """Yield what is given with what is found of it, in the order in which it is found."""
        source, left = iter(each), True
        while left:
            lost: list[Given] = []
            if self._pool is None:
                self._pool = self._open.enter_context(_pool(self._workers))
            for given, future in _flow(self._pool, solve, source, lambda: AHEAD * self._workers):
                if isinstance(future.exception(), BrokenProcessPool):
                    lost.append(given)
                else:
                    yield given, future.result()
            if lost:
                self.close()
            for given in lost:
                yield given, _alone(solve, given)
            left = bool(lost)


class Cluster:
    """The workers of a Dask scheduler, however many there are at the time.

    Parameters
    ----------
    address : str
        Of the scheduler, such as ``"tcp://10.0.0.1:8786"``.

    Raises
    ------
    InputError
        If nothing answers there.
    ImportError
        If dask.distributed is not installed.
    """

    def __init__(self, address: str) -> None:
        from distributed import Client

        remedy = "give that of a running Dask scheduler, such as tcp://10.0.0.1:8786"
        # The client has assertions, not sentences, for what is no address at all.
        if not isinstance(address, str) or not _ADDRESS.fullmatch(address):
            raise InputError("--scheduler", address, "be the address of a scheduler, with a port", remedy)
        try:
            self._client: Any = Client(address, timeout=CONNECTING, set_as_default=False)
        except (OSError, ValueError, TypeError) as error:
            reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
            raise InputError("--scheduler", address, f"be the address of a scheduler ({reason})", remedy) from None

    def run(self, solve: Callable[[Given], Found], each: Iterable[Given]) -> Iterator[tuple[Given, Found | LostError]]:
        """Yield what is given with what is found of it, in the order in which it is found."""
        from distributed import KilledWorker

        with self._client.get_executor(pure=False) as executor:
            for given, future in _flow(executor, solve, iter(each), self._ahead):
                error = future.exception()
                yield given, LostError() if isinstance(error, KilledWorker) else future.result()

    def close(self) -> None:
        """Leave the scheduler; its workers stay."""
        self._client.close()

    def _ahead(self) -> int:
        return AHEAD * max(1, sum(map(int, self._client.ncores().values())))


def _flow(
    executor: Executor, solve: Callable[[Given], Found], source: Iterator[Given], ahead: Callable[[], int]
) -> Iterator[tuple[Given, Future[Found]]]:
    """Yield what is given with its future as they finish, no more than ``ahead()`` under way at a time.

    Once processes have ended, nothing more is taken from the source.
    """
    pending: dict[Future[Found], Given] = {}
    broken = False
    try:
        while True:
            while not broken and len(pending) < ahead():
                try:
                    given = next(source)
                except StopIteration:
                    break
                pending[_submitted(executor, solve, given)] = given
            if not pending:
                return
            done, _ = wait(pending, return_when=FIRST_COMPLETED)
            for future in done:
                broken = broken or isinstance(future.exception(), BrokenProcessPool)
                yield pending.pop(future), future
    finally:
        for future in pending:
            future.cancel()


@contextlib.contextmanager
def _without_the_script() -> Iterator[None]:
    """Hide the script that runs from processes that start: they would run it, too, unless it is guarded against that.

    What they are to call is in this package.
    """
    main = sys.modules["__main__"]
    hidden: dict[str, Any] = {name: vars(main)[name] for name in ("__file__", "__spec__") if name in vars(main)}
    try:
        vars(main).pop("__file__", None)
        main.__spec__ = None
        yield
    finally:
        vars(main).update(hidden)


def _submitted(executor: Executor, solve: Callable[[Given], Found], given: Given) -> Future[Found]:
    try:
        with _without_the_script():
            return executor.submit(solve, given)
    except BrokenProcessPool as error:
        refused: Future[Found] = Future()
        refused.set_exception(error)
        return refused


def _alone(solve: Callable[[Given], Found], given: Given) -> Found | LostError:
    """Return what a process of its own finds."""
    for _ in range(ATTEMPTS):
        with _pool(1) as pool, contextlib.suppress(BrokenProcessPool):
            return _submitted(pool, solve, given).result()
    return LostError()


@contextlib.contextmanager
def _pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """Give processes that end with this one, however it ends."""
    before = {name: os.environ.get(name) for name in _THREADS}
    os.environ.update({name: "1" for name in _THREADS if before[name] is None})
    # Forked processes would inherit the threads' locks.
    pool = ProcessPoolExecutor(
        min(workers, _MOST), mp_context=multiprocessing.get_context("spawn"), initializer=_end_with_the_parent
    )
    try:
        yield pool
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for name in (name for name, value in before.items() if value is None):
            os.environ.pop(name, None)


def _end_with_the_parent() -> None:
    """Leave Ctrl-C to the parent, and end when it ends: processes of a killed one would wait for work for ever."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
