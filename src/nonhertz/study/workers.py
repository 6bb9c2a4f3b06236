"""Executors for the portions of a study: this process, processes on this machine, or a Dask cluster.

`Workers.portions` takes a function and its arguments, and yields results as they become available. If a process ends
within a portion, for example for lack of memory, only the time of that portion is lost: portions that were being solved
are tried again one at a time, and only one that ends its process every time is given up.
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

AHEAD = 3  # portions submitted per process: few, to limit memory
ATTEMPTS = 2  # of a portion by itself that was being solved when a process ended
CONNECTING = "20s"
_ADDRESS = re.compile(r"(?:[a-z]+://)?[^\s/]+:\d+/?")
_MOST = 61 if sys.platform == "win32" else sys.maxsize  # processes: Windows waits for no more at once
# One thread for the linear algebra of a portion, since the processes share the cores.
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
        If nothing answers at the address.
    ImportError
        If dask.distributed is not installed.
    """

    def __init__(self, scheduler: str | None = None) -> None:
        self._open = contextlib.ExitStack()
        self._executor: Executor | None = None
        self._client = None if scheduler is None else _connect(scheduler)

    def close(self) -> None:
        """End the processes, or disconnect from the scheduler; its workers stay."""
        self._executor = None
        self._open.close()
        if self._client is not None:
            self._client.close()

    def portions(
        self, solve: Callable[[Item], Answer], items: Iterable[Item], processes: int
    ) -> Iterator[tuple[Item, Answer | LostError]]:
        """Yield items with their results, in the order of completion; one process means this one."""
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
        """Return the executor of processes, which is started once."""
        if self._executor is None:
            made = _pool(processes) if self._client is None else self._client.get_executor(pure=False)
            self._executor = self._open.enter_context(made)
        return self._executor

    def _flow(
        self, executor: Executor, solve: Callable[[Item], Answer], source: Iterator[Item], processes: int
    ) -> Iterator[tuple[Item, Future[Answer]]]:
        """Yield items with their futures as they finish, with only a few submitted for each process at a time.

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
    """Return the result for an item, with sentences in the units of the calling process."""
    with display_units(units):
        return solve(item)


def _connect(address: str) -> Any:
    """Return a client of a Dask scheduler."""
    from distributed import Client

    remedy = "give that of a running Dask scheduler, such as tcp://10.0.0.1:8786"
    # The client has assertions, not sentences, for malformed addresses.
    if not isinstance(address, str) or not _ADDRESS.fullmatch(address):
        raise InputError("scheduler", address, "be the address of a scheduler, with a port", remedy)
    try:
        return Client(address, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
        raise InputError("scheduler", address, f"be the address of a scheduler ({reason})", remedy) from None


@contextlib.contextmanager
def _hide_script() -> Iterator[None]:
    """Hide the running script from new processes: they would run it as well, unless it is guarded against that.

    The functions that they call are in this package.
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
    """Let new processes ignore Ctrl-C from the beginning: it would end them while they import."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.SIG_DFL)


def _run_alone(solve: Callable[[Item], Answer], item: Item) -> Answer | LostError:
    """Return the result from a process of its own."""
    for _ in range(ATTEMPTS):
        with _pool(1) as pool, contextlib.suppress(BrokenProcessPool):
            return _submit(pool, solve, item).result()
    return LostError()


@contextlib.contextmanager
def _pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """Yield processes that end with this one, however it ends."""
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
    """End when the parent ends, and leave Ctrl-C to it: otherwise processes of a killed parent would wait forever."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
