"""Solving rows of a study: from values of parameters to numbers, or to the reason why there are none.

Rows of a contact that differ only in load, approach, tilt or moment share the contact, and are solved in one call of
`nonhertz.solve_many`.
"""

from __future__ import annotations

import contextlib
import math
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz.bearing.quantities import SolvedBearing
from nonhertz.errors import InputError, NonhertzError, without_accuracy_warnings
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case, with_file_path
from nonhertz.files.planfile import LOAD, Template
from nonhertz.model.prescription import Prescription
from nonhertz.native import core
from nonhertz.result.quantities import QUANTITIES, Quantity
from nonhertz.solver.many import solve_without_warnings
from nonhertz.solver.one import bound_contact, problem_of
from nonhertz.study.quantities import SolvedContact, choose_quantities, number_of
from nonhertz.verdict import Verdict, judge_contact

Values = Mapping[str, Any]

_NOTHING = ("load", "moment", "max_pressure", "max_half_width", "contact_length", "penetration", "error", "warnings")
TOUCHING = 400  # positions along the bodies that are searched for their first touch, in addition to crests
_PRESSED = tuple(f"load.{name}" for name in ("load", "approach", "tilt", "moment"))


@dataclass(frozen=True)
class Row:
    """One row: numbers in the order of the quantities, or the reason why there are none."""

    numbers: tuple[float, ...]
    failure: str | None = None


@dataclass(frozen=True)
class Work:
    """The data shared by all rows of a study, in a form that can be sent to other processes and machines."""

    template: Template  # the case
    files: Mapping[str, bytes]  # contents of the files that the case names, for machines that do not have them
    names: tuple[str, ...]  # of the numbers asked for

    def __getstate__(self) -> dict[str, Any]:
        """Return the state for other processes: names of quantities, whose functions cannot be sent."""
        return {name: value for name, value in vars(self).items() if name != "quantities"}

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """The requested quantities."""
        return choose_quantities(self.names, bearing=self.template.is_bearing)

    def rows(self, paths: Sequence[str], values: Sequence[Sequence[Any]]) -> list[Row]:
        """Return solved rows.

        Parameters
        ----------
        paths : sequence of str
            The paths that are varied.
        values : sequence of sequences
            Their values in each row.
        """
        named = [dict(zip(paths, row, strict=True)) for row in values]
        # Strains of the model are in a column of their own.
        with without_accuracy_warnings(), self._template_and_files() as template:
            if template.is_bearing:
                return [self._solve_alone(template, row) for row in named]
            return self._solve_contacts(template, named)

    def _solve_contacts(self, template: Template, values: Sequence[Values]) -> list[Row]:
        """Return rows of contacts, those with equal bodies solved together."""
        groups: dict[tuple[Any, ...], list[int]] = {}
        for number, row in enumerate(values):
            bodies = tuple(value for path, value in row.items() if path not in _PRESSED)
            groups.setdefault(bodies, []).append(number)
        solved: dict[int, Row] = {}
        for numbers in groups.values():
            unloaded = [number for number in numbers if template.is_unloaded(values[number])]
            solved.update((number, self._touching_row(template, values[number])) for number in unloaded)
            if pressed := sorted(set(numbers).difference(unloaded)):
                rows = self._solve_contact(template, [values[number] for number in pressed])
                solved.update(zip(pressed, rows, strict=True))
        return [solved[number] for number in range(len(values))]

    def _solve_contact(self, template: Template, values: Sequence[Values]) -> list[Row]:
        """Return rows of one contact under several loads."""
        try:
            case = template.case(values[0])
            assert isinstance(case, Case)
            prescriptions = [_prescription_of(case, row) for row in values]
            return self._solve_together(case, prescriptions)
        except NonhertzError:
            pass  # solved one by one, so that each refused row has its own reason
        return [self._solve_alone(template, row) for row in values]

    def _solve_together(self, case: Case, pressing: Sequence[Prescription]) -> list[Row]:
        columns = {name: np.array([getattr(way, name) for way in pressing]) for name in pressing[0].keywords}
        solutions = solve_without_warnings(case.contact, columns, **case.solver.keywords)
        at_once = {
            number.name: solutions.column(number.name) for number in self.quantities if number.name in QUANTITIES
        }
        converged = solutions.converged.tolist()
        rows = []
        for number, prescribed in enumerate(pressing):
            if not converged[number]:
                rows.append(self._failed_row(solutions.failures[number]))
                continue
            # Making whole solutions takes as long as solving: only if a quantity needs one.
            solved = (
                SolvedContact(replace(case, prescribed=prescribed), solutions[number])
                if len(at_once) < len(self.quantities)
                else None
            )
            rows.append(
                Row(
                    tuple(
                        float(at_once[quantity.name][number]) if solved is None or quantity.name in at_once
                        else number_of(quantity, solved)
                        for quantity in self.quantities
                    )
                )
            )  # fmt: skip
        return rows

    def verdict(self, values: Values) -> Verdict | None:
        """Return the verdict on a row, which is solved once more; None if it fails."""
        with without_accuracy_warnings(), self._template_and_files() as template:
            try:
                solved = _solve(template, values)
            except NonhertzError:
                return None
            if isinstance(solved, SolvedContact):
                return judge_contact(solved.solution)
            judged: Verdict | None = solved.case.verdict(solved.solution, solved.life_or_none)
            return judged

    def _solve_alone(self, template: Template, values: Values) -> Row:
        try:
            solved = _solve(template, values)
        except NonhertzError as error:
            return self._failed_row(error)
        return Row(tuple(number_of(quantity, solved) for quantity in self.quantities))

    def _touching_row(self, template: Template, values: Values) -> Row:
        """Return the row of bodies that just touch: the limit of vanishing load."""
        try:
            case = template.case({path: value for path, value in values.items() if path != LOAD})
            assert isinstance(case, Case)
            if case.prescribed.moment:
                condition = "be zero without a load"
                raise InputError("moment", case.prescribed.moment, condition, "leave it out, or give a load")
            tilt = case.prescribed.tilt or 0.0
            contact = case.contact
            problem = problem_of(contact, Prescription(load=1.0, tilt=tilt), case.solver.element)
            edges = np.linspace(*bound_contact(problem), TOUCHING + 1)
            touched = -core.penetration(problem.model.in_core, edges, (0.0, tilt))
        except NonhertzError as error:
            return self._failed_row(error)
        known = dict.fromkeys(_NOTHING, 0.0) | {"approach": touched, "tilt": tilt}
        return Row(tuple(known.get(quantity.name, math.nan) for quantity in self.quantities))

    def _failed_row(self, error: Exception) -> Row:
        sentence = str(with_file_path(error)) if isinstance(error, InputError) else str(error)
        return Row((math.nan,) * len(self.quantities), " ".join(sentence.split()))

    @contextlib.contextmanager
    def _template_and_files(self) -> Iterator[Template]:
        """Yield the template, with copies of its files on machines that do not have them."""
        if all((self.template.path.parent / name).exists() for name in self.files):
            yield self.template
            return
        with tempfile.TemporaryDirectory() as folder:
            for name, content in self.files.items():
                # A file outside the case's folder is not copied; its absence is reported in an error.
                if not Path(name).is_absolute() and ".." not in Path(name).parts:
                    Path(folder, name).parent.mkdir(parents=True, exist_ok=True)
                    Path(folder, name).write_bytes(content)
            yield replace(self.template, path=Path(folder, self.template.path.name))


def _solve(template: Template, values: Values) -> SolvedBearing | SolvedContact:
    """Return a row solved by itself; raises the errors of reading and solving."""
    case = template.case(values)
    if isinstance(case, BearingCase):
        return SolvedBearing(case, case.solve())
    return SolvedContact(case, case.solve())


def _prescription_of(case: Case, values: Values) -> Prescription:
    """Return load or approach, and tilt or moment, of a row.

    Raises
    ------
    InputError
        If one of them is out of range.
    """
    pressing = {path.partition(".")[2]: value for path, value in values.items() if path in _PRESSED}
    return Prescription(**case.prescribed.keywords | pressing)
