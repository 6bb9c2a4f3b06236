"""Processes that compute, and are killed when they take too long.

No limit on the input can guarantee how long an answer takes, and Python itself cannot be interrupted from another
thread. So all computing is done in worker processes: one that exceeds its deadline is killed and replaced, and
the server answers in time whatever the request.
"""

from __future__ import annotations

import asyncio
import contextlib
import multiprocessing
import pickle
import signal
import time
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from typing import Any, Final

import anyio
import anyio.to_thread
from anyio.abc import TaskGroup
from starlette.exceptions import HTTPException

from nonhertz.amounts import current_units, display_units
from nonhertz.web.limits import WAITING_REQUESTS, WAITING_SECONDS

WARM_UP_SECONDS: Final = 60.0
"""Long enough to load everything on a busy machine."""

_STEP = 0.05  # s between checks of the deadline
_PAUSE = 1.0  # s before trying again to start a process
_BUSY = "The page is busy with other cases: it will ask again."

Job = Callable[..., Any]


class TooSlowError(Exception):
    """A job was not done in time; its process has been killed."""


class FailedError(Exception):
    """A job raised an unexpected error; its process lives on."""


class EndedError(FailedError):
    """A process died, for example for lack of memory."""


class Worker:
    """One process, doing one job after another.

    Parameters
    ----------
    warm_up : callable or None
        Called first; a module-level function, so that it can be pickled.
    """

    def __init__(self, warm_up: Job | None = None) -> None:
        # Spawned and not forked: this process has threads.
        context = multiprocessing.get_context("spawn")
        self._connection, its_own = context.Pipe()
        self._process = context.Process(target=_work, args=(its_own, warm_up), daemon=True)
        self._process.start()
        its_own.close()

    def wait(self, seconds: float) -> Any:
        """Return the next message of the process.

        Raises
        ------
        TooSlowError
            If it takes longer than ``seconds``.
        FailedError, EndedError
            If the job raises, or the process ends.
        """
        end = time.monotonic() + seconds
        try:
            while not self._connection.poll(min(_STEP, max(end - time.monotonic(), 0.0))):
                if time.monotonic() >= end:
                    raise TooSlowError
            fine, value = pickle.loads(self._connection.recv_bytes())
        except (EOFError, OSError):
            raise EndedError("its process ended") from None
        if not fine:
            raise FailedError(value)
        return value

    def do(self, job: Job, arguments: tuple[Any, ...], seconds: float) -> Any:
        """Return the result of a job, in the display units chosen here; raises as `wait`."""
        try:
            self._connection.send_bytes(pickle.dumps((job, arguments, current_units().code)))
        except OSError:
            raise EndedError("its process ended") from None
        return self.wait(seconds)

    @property
    def alive(self) -> bool:
        """Whether the process is still running."""
        return self._process.is_alive()

    def end(self) -> None:
        """Kill the process, whatever it is doing."""
        self._process.kill()
        self._connection.close()
        self._process.join()
        self._process.close()


class Workers:
    """Several processes for short jobs, and one at a time for a long one.

    Parameters
    ----------
    count : int
        Number of processes for short jobs.
    warm_up : callable or None
        Called in each before it is used.
    eager : bool
        Whether a process that was killed is replaced at once, or only for the next job.
    """

    def __init__(self, count: int = 2, warm_up: Job | None = None, *, eager: bool = True) -> None:
        self.ready = anyio.Event()
        self._missing, self._warm_up, self.eager = count, warm_up, eager
        self._idle: asyncio.Queue[Worker] = asyncio.Queue()
        self._limiter = anyio.CapacityLimiter(2 * count + 1)
        self._apart = anyio.Lock()
        self._living: set[Worker] = set()
        self._waiting = 0
        self._tasks: TaskGroup | None = None

    def start(self, tasks: TaskGroup, *, at_once: bool = True) -> None:
        """Start the processes: at once, or when `wake` is called or a job arrives."""
        self._tasks = tasks
        if at_once:
            self.wake()

    def wake(self) -> None:
        """Start missing processes one after the other, so that the first is ready soon."""
        if self._tasks is not None and self._missing:
            self._tasks.start_soon(self._add, self._missing)
            self._missing = 0

    def end(self) -> None:
        """Kill all processes."""
        for worker in tuple(self._living):
            self._end(worker)

    async def run(self, job: Job, *arguments: Any, seconds: float) -> Any:
        """Return the result of a short job.

        Raises
        ------
        HTTPException
            If there are too many jobs already.
        TooSlowError, FailedError, EndedError
            As by `Worker.wait`.
        """
        worker = await self._free()
        try:
            value = await self._in_thread(worker.do, job, arguments, seconds)
        except BaseException as error:
            if isinstance(error, FailedError) and not isinstance(error, EndedError):
                self._idle.put_nowait(worker)
            else:  # a late answer would be taken for that of the next job
                self._replace(worker)
            raise
        self._idle.put_nowait(worker)
        return value

    async def run_apart(self, job: Job, *arguments: Any, seconds: float) -> Any:
        """Return the result of a long job, run in a process of its own, one at a time; raises as `run`."""
        with self._wait_in_queue():
            await self._apart.acquire()
        worker: Worker | None = None
        try:
            worker = await self._in_thread(Worker)
            self._living.add(worker)
            return await self._in_thread(worker.do, job, arguments, seconds)
        finally:
            if worker is not None:
                self._end(worker)
            self._apart.release()

    async def _free(self) -> Worker:
        """Return an idle process."""
        self.wake()
        with self._wait_in_queue():
            while True:
                worker = await self._idle.get()
                if worker.alive:
                    return worker
                self._replace(worker)  # killed from outside while idle
                self.wake()

    @contextlib.contextmanager
    def _wait_in_queue(self) -> Iterator[None]:
        """Let a job wait for a process, unless too many are waiting.

        A refusal would not be quicker for the user, and browsers write each one into their consoles.
        """
        if self._waiting >= WAITING_REQUESTS:
            raise HTTPException(503, _BUSY)
        self._waiting += 1
        try:
            with anyio.fail_after(WAITING_SECONDS):
                yield
        except TimeoutError:
            raise HTTPException(503, _BUSY) from None
        finally:
            self._waiting -= 1

    def _replace(self, worker: Worker) -> None:
        self._end(worker)
        self._missing += 1
        if self.eager:
            self.wake()

    async def _add(self, count: int) -> None:
        """Start ``count`` processes, each when the one before is ready; one that fails to start is tried again."""
        while count:
            worker: Worker | None = None
            try:
                worker = await self._in_thread(Worker, self._warm_up)
                self._living.add(worker)
                if self._warm_up is not None:
                    await self._in_thread(worker.wait, WARM_UP_SECONDS)
            except (OSError, TooSlowError, FailedError):  # out of memory, at the limit of processes, or dead by now
                if worker is not None:
                    self._end(worker)
                await anyio.sleep(_PAUSE)
                continue
            self._idle.put_nowait(worker)
            self.ready.set()
            count -= 1

    async def _in_thread(self, function: Callable[..., Any], *arguments: Any) -> Any:
        return await anyio.to_thread.run_sync(function, *arguments, abandon_on_cancel=True, limiter=self._limiter)

    def _end(self, worker: Worker) -> None:
        if worker in self._living:
            self._living.discard(worker)
            worker.end()


def _work(connection: Connection, warm_up: Job | None) -> None:
    """Run the jobs that arrive on a connection until its other end is closed."""
    # An interrupt at the terminal reaches the whole process group, but only the server should end this process.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if warm_up is not None:
        _answer(connection, warm_up, ())
    while True:
        try:
            job, arguments, units = pickle.loads(connection.recv_bytes())
        except (EOFError, OSError):
            return
        with display_units(units):
            _answer(connection, job, arguments)


def _answer(connection: Connection, job: Job, arguments: tuple[Any, ...]) -> None:
    try:
        sent = True, job(*arguments)
    except Exception as error:  # noqa: BLE001  (top level: the server reports it in a sentence)
        sent = False, f"{type(error).__name__}: {error}"
    with contextlib.suppress(OSError):
        connection.send_bytes(pickle.dumps(sent))
