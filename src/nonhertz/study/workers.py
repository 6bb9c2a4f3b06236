"""Who solves the portions of a study: this process, processes on this machine, or a Dask cluster.

`Workers.portions` takes a function and what it is to be called with, and yields what it returns as it is found. A
process that ends in the middle of a portion, for want of memory, say, costs no more than that portion's time: those
that were under way are tried again one at a time, and only one that ends its process every time is given up.
"""

from __future__ import annotations

import contextlib
import itertools
import multiprocessing
import os
import re
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from typing import Any, TypeVar

from nonhertz.amounts import current_units, display_units
from nonhertz.errors import InputError, NonhertzError

Item = TypeVar("Item")
Answer = TypeVar("Answer")

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
        super().__init__("The process that solved it ended every time, perhaps because it ran out of memory.")


class Workers:
    """An executor of processes on this machine, or of a Dask scheduler, which waits for more work until it is closed.

    Parameters
    ----------
    scheduler : str, optional
        Address of a Dask scheduler, such as ``"tcp://10.0.0.1:8786"``, whose workers solve, however many there are at
        the time.

    Raises
    ------
    InputError
        If nothing answers there.
    ImportError
        If dask.distributed is not installed.
    """

    def __init__(self, scheduler: str | None = None) -> None:
        self._open = contextlib.ExitStack()
        self._executor: Executor | None = None
        self._client = None if scheduler is None else _connect(scheduler)

    def close(self) -> None:
        """Let processes end, or leave the scheduler; its workers stay."""
        self._executor = None
        self._open.close()
        if self._client is not None:
            self._client.close()

    def portions(
        self, solve: Callable[[Item], Answer], items: Iterable[Item], processes: int
    ) -> Iterator[tuple[Item, Answer | LostError]]:
        """Yield what is given with what is found of it, in the order in which it is found; one process is this one."""
        if self._client is None and processes == 1:
            yield from ((item, solve(item)) for item in items)
            return
        solve, source, unfinished = partial(_run_in_units, current_units().code, solve), iter(items), True
        while unfinished:
            lost: list[Item] = []
            for item, future in self._flow(self._start(processes), solve, source, processes):
                error = future.exception()
                if isinstance(error, BrokenProcessPool):
                    lost.append(item)
                else:
                    # The name that dask.distributed, which may not be installed, has for the same.
                    yield item, LostError() if type(error).__name__ == "KilledWorker" else future.result()
            if lost:
                self.close()
            for item in lost:
                yield item, _run_alone(solve, item)
            unfinished = bool(lost)

    def _start(self, processes: int) -> Executor:
        """Return what runs processes, which is started once."""
        if self._executor is None:
            made = _pool(processes) if self._client is None else self._client.get_executor(pure=False)
            self._executor = self._open.enter_context(made)
        return self._executor

    def _flow(
        self, executor: Executor, solve: Callable[[Item], Answer], source: Iterator[Item], processes: int
    ) -> Iterator[tuple[Item, Future[Answer]]]:
        """Yield what is given with its future as they finish, no more than a few for each process under way at a time.

        Once processes have ended, nothing more is taken from the source.
        """
        pending: dict[Future[Answer], Item] = {}
        broken = False
        try:
            while True:
                count = processes if self._client is None else max(1, sum(map(int, self._client.ncores().values())))
                for item in itertools.islice(source, 0 if broken else max(0, AHEAD * count - len(pending))):
                    pending[_submit(executor, solve, item)] = item
                if not pending:
                    return
                done, _ = wait(pending, return_when=FIRST_COMPLETED)
                for future in done:
                    broken = broken or isinstance(future.exception(), BrokenProcessPool)
                    yield pending.pop(future), future
        finally:
            for future in pending:
                future.cancel()


def _run_in_units(units: str, solve: Callable[[Item], Answer], item: Item) -> Answer:
    """Return what is found of something, its sentences in units of the process that asked."""
    with display_units(units):
        return solve(item)


def _connect(address: str) -> Any:
    """Return a client of a Dask scheduler."""
    from distributed import Client

    remedy = "give that of a running Dask scheduler, such as tcp://10.0.0.1:8786"
    # The client has assertions, not sentences, for what is no address at all.
    if not isinstance(address, str) or not _ADDRESS.fullmatch(address):
        raise InputError("scheduler", address, "be the address of a scheduler, with a port", remedy)
    try:
        return Client(address, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
        raise InputError("scheduler", address, f"be the address of a scheduler ({reason})", remedy) from None


@contextlib.contextmanager
def _hide_script() -> Iterator[None]:
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


def _submit(executor: Executor, solve: Callable[[Item], Answer], item: Item) -> Future[Answer]:
    try:
        with _hide_script(), _ignore_interrupts():
            return executor.submit(solve, item)
    except BrokenProcessPool as error:
        refused: Future[Answer] = Future()
        refused.set_exception(error)
        return refused


@contextlib.contextmanager
def _ignore_interrupts() -> Iterator[None]:
    """Let processes that are started ignore Ctrl-C from the beginning: it would end them while they import."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.SIG_DFL)


def _run_alone(solve: Callable[[Item], Answer], item: Item) -> Answer | LostError:
    """Return what a process of its own finds."""
    for _ in range(ATTEMPTS):
        with _pool(1) as pool, contextlib.suppress(BrokenProcessPool):
            return _submit(pool, solve, item).result()
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
    """End when the parent ends, and leave Ctrl-C to it: processes of a killed one would wait for work for ever."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
