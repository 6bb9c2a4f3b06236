"""Cases solved in portions on several threads: reported as they finish, and kept if the run is stopped.

A portion holds the same cases whatever the number of threads, and portions are collected in a fixed order, so that
neither results nor callbacks depend on it.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Collection, Mapping
from concurrent.futures import Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError, Interrupted, NonhertzError
from nonhertz.findings import Finding
from nonhertz.native import core
from nonhertz.result.outcome import has_series, outcome
from nonhertz.result.read_only import freeze
from nonhertz.solver.blocks import Block
from nonhertz.solver.refusals import refusal
from nonhertz.solver.solutions import Solutions
from nonhertz.strip.problem import Problem, Target

Array = NDArray[np.float64]

# How long a stopped run waits for portions that have begun: they end within a Newton step, except for users' profiles,
# which may be slow.
PATIENCE = 1.0  # s
NOT_SOLVED = "The case was not solved: the run was stopped before it began."


@dataclass(frozen=True, eq=False, repr=False)
class Chunk:
    """Cases that `nonhertz.solve_many` has finished, as it passes them to ``callback``.

    Attributes
    ----------
    numbers : ndarray of int, shape (cases,)
        Numbers of the cases, ascending, counted along all axes of the results: positions in the flattened arrays.
    done, total : int
        Number of finished cases, including these, and number of all cases.
    solutions : Solutions
        The results of these cases, in the order of ``numbers``; assembled on first access.
    """

    numbers: NDArray[np.intp]
    done: int
    total: int
    _blocks: tuple[Block, ...]

    def __repr__(self) -> str:
        return f"{self.done} of {self.total} cases finished"

    @classmethod
    def of(cls, blocks: list[Block], done: int, total: int) -> Chunk:
        """Return the cases of some blocks."""
        numbers = np.sort(np.concatenate([block.numbers for block in blocks])).astype(np.intp)
        return cls(freeze(numbers), done, total, tuple(blocks))

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
    targets: list[Target]
    strips: core.Accuracy | int | Array

    def solved(self, stop: core.Stop) -> list[Block]:
        """Solve the cases; return those with a solution in one block, the others in a block each.

        Once the run is stopped, the remaining cases are not begun.
        """
        problem = self.problem
        try:
            ended = core.solve_in_turn(problem.model.in_core, problem.by_force, self.targets, self.strips, stop)
        # An exception of one case, even from a user's profile, must not stop the others.
        except Exception as error:  # noqa: BLE001
            return self.without((), error.with_traceback(None))
        failed: list[Block] = []
        solved: dict[int, core.Result] = {}
        for row, ending in enumerate(ended):
            reason = self._failure(row, ending)
            result = ending if isinstance(ending, core.Result) else None
            if reason is not None:
                reached = [result] if result is not None and isinstance(reason, ConvergenceError) else []
                failed.append(self._block([row], reached, reason))
            elif result is not None:
                solved[row] = result
        return [*failed, *([self._block(list(solved), list(solved.values()))] if solved else [])]

    def _failure(self, row: int, ended: core.Result | Exception) -> Exception | None:
        """Return why a case has no solution, if it has none."""
        if isinstance(ended, core.Result) and ended.holds and not has_series(self.problem):
            return None
        problem = self.problem.of(self.targets[row])
        if isinstance(ended, core.Refused):
            return refusal(problem, ended)
        if isinstance(ended, Exception):
            return ended.with_traceback(None)
        try:
            outcome(problem, ended)
        except NonhertzError as error:
            return error.with_traceback(None)
        return None

    def _block(self, rows: list[int], results: list[core.Result], error: Exception | None = None) -> Block:
        return Block(
            self.problem, [self.numbers[row] for row in rows], [self.targets[row] for row in rows], results, error
        )

    def without(self, numbers: Collection[int], error: Exception) -> list[Block]:
        """Return the cases that are not among ``numbers`` in a block with an error, or no block if there are none."""
        rows = [row for row, number in enumerate(self.numbers) if number not in numbers]
        return [self._block(rows, [], error)] if rows else []


@dataclass(frozen=True)
class Work:
    """Tasks that one thread solves one after the other; their cases are reported when all are solved."""

    tasks: tuple[Task, ...]

    def __len__(self) -> int:
        return sum(len(task.numbers) for task in self.tasks)

    def solved(self, stop: core.Stop) -> list[Block]:
        """Solve the tasks, until the run is stopped."""
        blocks: list[Block] = []
        for task in self.tasks:
            if stop.is_set:
                break
            blocks += task.solved(stop)
        for block in blocks:
            block.prepare()
        return blocks


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
    axes : mapping of str to ndarray
        The axes of the results, as in `Solutions`.
    """

    def __init__(
        self, shape: tuple[int, ...], works: tuple[Work, ...], threads: int, axes: Mapping[str, NDArray[Any]]
    ) -> None:
        self._shape, self._works, self._threads, self._axes = shape, works, threads, axes
        self._futures: list[Future[list[Block]]] = []

    def _finish(self, callback: Callable[[Chunk], object] | None) -> Solutions:
        """Solve all portions, report each, and return the solutions of all."""
        stop, total, done = core.Stop(), sum(len(work) for work in self._works), 0
        pool = ThreadPoolExecutor(self._threads)
        try:
            for work in self._works:
                self._futures.append(pool.submit(work.solved, stop))
            for future, work in zip(self._futures, self._works, strict=True):
                blocks = future.result()
                done += len(work)
                if callback is not None:
                    callback(Chunk.of(blocks, done, total))
        finally:
            stop.set()
            pool.shutdown(wait=False, cancel_futures=True)
            with contextlib.suppress(KeyboardInterrupt):  # a second Ctrl-C: wait no longer
                # `wait` would never be notified of cancelled ones.
                wait([future for future in self._futures if not future.cancelled()], PATIENCE)
        return self._so_far()

    def outcome(self, callback: Callable[[Chunk], object] | None) -> tuple[Solutions, tuple[Finding, ...]]:
        """Return the solutions of all portions, and the findings to warn about.

        Raises
        ------
        Interrupted
            On Ctrl-C.
        """
        try:
            solutions = self._finish(callback)
            return solutions, tuple(solutions.findings())
        except KeyboardInterrupt:
            raise self._interrupted_error() from None

    def _interrupted_error(self) -> Interrupted:
        """Return the error that says how far the run came, with what was solved."""
        solutions = self._so_far()
        solved = len(solutions) - sum(error.args == (NOT_SOLVED,) for error in solutions.failures.values())
        return Interrupted(f"Stopped after {solved} of {len(solutions)} cases.", solutions)

    def _so_far(self) -> Solutions:
        blocks: list[Block] = []
        for number, work in enumerate(self._works):
            done = _result(self._futures[number]) if number < len(self._futures) else []
            begun = {case for block in done for case in block.numbers}
            blocks += done
            blocks += (unsolved for task in work.tasks for unsolved in task.without(begun, NonhertzError(NOT_SOLVED)))
        return Solutions(self._shape, tuple(blocks), self._axes)


def _result(future: Future[list[Block]]) -> list[Block]:
    """Return the results of a portion; empty if it was not begun, not finished, or failed."""
    ended = future.done() and not future.cancelled() and future.exception() is None
    return future.result() if ended else []
