"""Cases that were solved together, with their results from the core."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import check_list
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.result.outcome import restore, solution_of, states_of_levels
from nonhertz.result.solution import Solution
from nonhertz.strip.problem import Problem, Target

Array = NDArray[np.float64]


def list_contacts(contacts: Contact | Iterable[Contact]) -> list[Contact]:
    """Return one contact or several as a list; anything else is refused."""
    if isinstance(contacts, Contact):
        return [contacts]
    remedy = "give one Contact, or a list of them"
    checked: list[Contact] = check_list("contacts", contacts, "be contacts", remedy)
    for number, contact in enumerate(checked):
        if not isinstance(contact, Contact):
            raise InputError(f"contacts[{number}]", contact, "be a Contact", remedy)
    return checked


@dataclass(frozen=True)
class Block:
    """Cases that were solved together, or cases that failed for the same reason.

    For a failed case, the states are those that the solver reached, if any.
    """

    problem: Problem
    numbers: list[int]
    targets: list[Target]
    results: list[core.Result]
    error: Exception | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        states = [(states_of_levels(result), result.accuracy) for result in self.results]
        return Block._again, (self.problem, self.numbers, self.targets, states, self.error)

    @classmethod
    def _again(
        cls, problem: Problem, numbers: list[int], targets: list[Target], states: list[Any], error: Exception | None
    ) -> Block:
        """Return a block that was sent or copied."""
        accepted = error is None
        results = [
            restore(problem.of(target), levels, accuracy, accepted=accepted)
            for target, (levels, accuracy) in zip(targets, states, strict=False)
        ]
        return cls(problem, numbers, targets, results, error)

    @cached_property
    def columns(self) -> Array:
        """Results of each case, in the order of `core.columns`."""
        columns: Array = core.columns(self.results, self.problem.contact.compliance)
        return columns

    def prepare(self) -> None:
        """Compute the results now, in the thread that solved the cases."""
        if self.error is None:
            _ = self.columns

    def renumbered(self, numbers: list[int]) -> Block:
        """Return the same cases under other numbers, without computing anything again."""
        again = Block(self.problem, numbers, self.targets, self.results, self.error)
        if "columns" in vars(self):
            vars(again)["columns"] = self.columns
        return again

    def solution(self, row: int) -> Solution:
        """Return the solution of one case."""
        if self.error is not None:
            # A copy, because every raise extends an error's traceback.
            raise copy.copy(self.error)
        return solution_of(self.problem.of(self.targets[row]), self.results[row])

    def strained(self) -> Iterator[int]:
        """Yield the numbers of cases that strain the model."""
        for row in range(len(self.numbers) if self.error is None else 0):
            solution = self.solution(row)
            if solution.judgement.strains(solution):
                yield self.numbers[row]
