"""Cases solved in portions on several threads: announced as they finish, and kept if the run is stopped.

A portion holds the same cases whatever the number of threads, and portions are collected in one order, so that neither
results nor announcements depend on it.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Collection
from concurrent.futures import Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from functools import cached_property
from threading import Event

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError, Interrupted, NonhertzError
from nonhertz.findings import Finding
from nonhertz.result.outcome import outcome
from nonhertz.result.solution import read_only
from nonhertz.result.validity import too_wide
from nonhertz.solver.one import Strips, states_of
from nonhertz.solver.solutions import Block, Solutions
from nonhertz.strip.acceptance import met_by
from nonhertz.strip.levels import Solved
from nonhertz.strip.problem import Problem
from nonhertz.strip.records import Flags, States

Array = NDArray[np.float64]

# How long a stopped run waits for portions that have begun. Most take a few hundredths of a second; one of thousands of
# strips may take minutes, and is abandoned.
PATIENCE = 1.0  # s
NOT_SOLVED = "The case was not solved: the run was stopped before it was its turn."


@dataclass(frozen=True, eq=False, repr=False)
class Portion:
    """Cases that `nonhertz.solve_many` has finished, as it passes them to ``announce``.

    Attributes
    ----------
    numbers : ndarray of int, shape (cases,)
        Numbers of the cases, ascending, counted along all axes of the results: positions in the flattened arrays.
    done, total : int
        How many cases are finished, these included, and how many there are.
    solutions : Solutions
        The results of these cases, in the order of ``numbers``; put together when first asked for.
    """

    numbers: NDArray[np.intp]
    done: int
    total: int
    _blocks: tuple[Block, ...]

    def __repr__(self) -> str:
        return f"{self.done} of {self.total} cases finished"

    @classmethod
    def of(cls, blocks: list[Block], done: int, total: int) -> Portion:
        """Return the cases of some blocks."""
        numbers = np.sort(np.concatenate([block.numbers for block in blocks])).astype(np.intp)
        return cls(read_only(numbers), done, total, tuple(blocks))

    @cached_property
    def solutions(self) -> Solutions:
        """The results of these cases."""
        places = (np.searchsorted(self.numbers, block.numbers).tolist() for block in self._blocks)
        own = (block.renumbered(at) for block, at in zip(self._blocks, places, strict=True))
        return Solutions(self.numbers.shape, tuple(own))


@dataclass(frozen=True)
class Task:
    """Cases of one contact for one thread."""

    problem: Problem
    numbers: list[int]
    targets: Array
    strips: Strips

    def solved(self, stopped: Event) -> list[Block]:
        """Solve the cases; return those solved together in one block or a few, the others in a block each.

        Once the run is stopped, cases that are left to be solved alone are not begun.
        """
        together: list[Block] = []
        # The length on which unbounded bodies touch depends on the case.
        if np.all(np.isfinite(self.problem.contact.interval)) or not isinstance(self.strips, int | str | None):
            # Whatever the bodies refuse or raise is attributed to each case by solving it alone.
            with contextlib.suppress(Exception):
                together = [self._block(each) for each in states_of(self.problem, self.strips, self.targets)]
        done = {number for block in together for number in block.numbers}
        left = (row for row, number in enumerate(self.numbers) if number not in done)
        alone = [self._alone(row) for row in left if not stopped.is_set()]
        return [*alone, *(block for block in together if block.numbers)]

    def _block(self, solved: Solved) -> Block:
        """Return those of some cases that have a solution."""
        targets, finest = self.targets[solved.cases], solved.states[0]
        wide = np.any(too_wide(self.problem, solved.grids, finest), axis=1)
        done = solved.only(finest.converged & ~wide & met_by(self.problem, solved.grids, finest, targets))
        block = self._of(done)
        finite: Flags = np.all(np.isfinite(block.columns), axis=0) if block.numbers else np.ones(0, dtype=np.bool_)
        return block if finite.all() else self._of(done.only(finite))

    def _of(self, done: Solved) -> Block:
        numbers = [self.numbers[row] for row in done.cases]
        return Block(self.problem, numbers, self.targets[done.cases], tuple(done.states))

    def _alone(self, row: int) -> Block:
        """Return one case, solved as `nonhertz.solve` does."""
        problem = self.problem.of(self.targets[row])
        at = [self.numbers[row]], self.targets[row : row + 1]
        states: tuple[States, ...] = ()
        try:
            (solved,) = states_of(problem, self.strips, self.targets[row : row + 1])
            states = tuple(solved.states)
            outcome(problem, solved)
        # Whatever a case raises, even from a user-written profile, must not stop the others.
        except Exception as error:  # noqa: BLE001
            reached = states if isinstance(error, ConvergenceError) else ()
            return Block(self.problem, *at, reached, error.with_traceback(None))
        return Block(self.problem, *at, states)

    def without(self, numbers: Collection[int], error: Exception) -> list[Block]:
        """Return the cases that are not among ``numbers`` in a block with an error, or no block if there are none."""
        rows = [row for row, number in enumerate(self.numbers) if number not in numbers]
        left = [self.numbers[row] for row in rows]
        return [Block(self.problem, left, self.targets[rows], (), error)] if rows else []


@dataclass(frozen=True)
class Work:
    """Tasks that one thread solves one after the other; when they all are, their cases are announced."""

    tasks: tuple[Task, ...]

    def __len__(self) -> int:
        return sum(len(task.numbers) for task in self.tasks)

    def solved(self, stopped: Event) -> list[Block]:
        """Solve the tasks, until the run is stopped."""
        found: list[Block] = []
        for task in self.tasks:
            if stopped.is_set():
                break
            found += task.solved(stopped)
        for block in found:
            block.prepare()
        return found


class Run:
    """Portions solved on several threads.

    Parameters
    ----------
    shape : tuple of int
        Shape of the results.
    works : tuple of Work
        The portions.
    threads : int
        Number of threads.
    """

    def __init__(self, shape: tuple[int, ...], works: tuple[Work, ...], threads: int) -> None:
        self._shape, self._works, self._threads = shape, works, threads
        self._futures: list[Future[list[Block]]] = []

    def _finished(self, announce: Callable[[Portion], object] | None) -> Solutions:
        """Solve all portions, announce each, and return the solutions of all."""
        stopped, total, done = Event(), sum(len(work) for work in self._works), 0
        pool = ThreadPoolExecutor(self._threads)
        try:
            for work in self._works:
                self._futures.append(pool.submit(work.solved, stopped))
            for future, work in zip(self._futures, self._works, strict=True):
                blocks = future.result()
                done += len(work)
                if announce is not None:
                    announce(Portion.of(blocks, done, total))
        finally:
            stopped.set()
            pool.shutdown(wait=False, cancel_futures=True)
            with contextlib.suppress(KeyboardInterrupt):  # a second Ctrl-C: wait no longer
                # Of cancelled ones, `wait` would never hear that they are done.
                wait([future for future in self._futures if not future.cancelled()], PATIENCE)
        return self._so_far()

    def outcome(self, announce: Callable[[Portion], object] | None) -> tuple[Solutions, tuple[Finding, ...]]:
        """Return the solutions of all portions, and what is to be warned of.

        Raises
        ------
        Interrupted
            On Ctrl-C.
        """
        try:
            solutions = self._finished(announce)
            return solutions, tuple(solutions.findings())
        except KeyboardInterrupt:
            raise self._interrupted() from None

    def _interrupted(self) -> Interrupted:
        """Return the error that says how far the run came, with what was solved."""
        solutions = self._so_far()
        solved = len(solutions) - sum(error.args == (NOT_SOLVED,) for error in solutions.failures.values())
        return Interrupted(f"Stopped after {solved} of {len(solutions)} cases.", solutions)

    def _so_far(self) -> Solutions:
        blocks: list[Block] = []
        for number, work in enumerate(self._works):
            found = _result(self._futures[number]) if number < len(self._futures) else []
            begun = {case for block in found for case in block.numbers}
            blocks += found
            blocks += (left for task in work.tasks for left in task.without(begun, NonhertzError(NOT_SOLVED)))
        return Solutions(self._shape, tuple(blocks))


def _result(future: Future[list[Block]]) -> list[Block]:
    """Return what a portion has found; nothing if it was not begun, not finished, or failed."""
    ended = future.done() and not future.cancelled() and future.exception() is None
    return future.result() if ended else []
