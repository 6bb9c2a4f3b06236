"""The results of many cases: arrays of the most used quantities, and the full solution of any case."""

from __future__ import annotations

import contextlib
import copy
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.inputs.short_repr import shorten
from nonhertz.model.contact import Contact
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.data import dataframe, dataset, name_axes
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.read_only import freeze
from nonhertz.result.solution import Solution
from nonhertz.solver import files
from nonhertz.solver.blocks import Block

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

Array = NDArray[np.float64]
Number = int | tuple[int, ...]

_COLUMNS = (
    "approach", "tilt", "load", "moment", "max_pressure", "max_pressure_y", "max_half_width", "contact_length",
    "penetration",
)  # fmt: skip
# Columns of `core.columns` after these.
STIFFNESS, SINGULAR, _WIDTH = slice(9, 13), 13, 14


class Solutions(HasHtml):
    """The results of many cases: arrays of the most used quantities, and the full `Solution` of any case.

    The numbers of a failed case are nan, and ``solutions[number]`` raises its error from `failures`.

    Parameters
    ----------
    shape : tuple of int
        Shape of the result arrays, "(...)" below.
    blocks : tuple
        Groups of cases that were solved together.
    axes : mapping of str to ndarray, optional
        The axes, see below; numbered if left out.

    Attributes
    ----------
    approach, tilt, load, moment : ndarray, shape (...)
        As in `Solution` [mm, rad, N, N mm].
    max_pressure, max_pressure_y : ndarray, shape (...)
        The maximum pressure [MPa] more than a half-width away from ends where it is singular, and its position [mm].
    max_half_width : ndarray, shape (...)
        The largest half-width, likewise [mm].
    contact_length, penetration : ndarray, shape (...)
        As in `Solution` [mm].
    singular : ndarray of bool, shape (...)
        Whether the pressure is singular at an end of the contact.
    stiffness : ndarray, shape (..., 2, 2)
        As in `Solution`.
    converged : ndarray of bool, shape (...)
        Whether the case has a solution.
    axes : mapping of str to ndarray
        Coordinates of each axis: the values of the input that varies along this axis only, by its name, such as
        ``load``, or ``contact``, a number. Other axes are numbered: ``case``, or ``case_0``.
    """

    def __init__(
        self, shape: tuple[int, ...], blocks: tuple[Block, ...], axes: Mapping[str, NDArray[Any]] | None = None
    ) -> None:
        self.shape = shape
        self.axes = axes or name_axes({}, shape)
        self._blocks = blocks
        self._place: dict[int, tuple[Block, int]] = {
            number: (block, row) for block in blocks for row, number in enumerate(block.numbers)
        }
        columns, solved = (
            np.full((len(self._place), _WIDTH), np.nan),
            [block for block in blocks if block.error is None],
        )
        columns[:, SINGULAR] = 0.0
        for block in solved:
            columns[block.numbers] = block.columns
        for name, column in zip(_COLUMNS, columns.T, strict=False):
            setattr(self, name, freeze(column.reshape(shape).copy()))
        self.stiffness = freeze(columns[:, STIFFNESS].reshape(*shape, 2, 2))
        self.singular = freeze(columns[:, SINGULAR].astype(bool).reshape(shape))

    approach: Array
    tilt: Array
    load: Array
    moment: Array
    max_pressure: Array
    max_pressure_y: Array
    max_half_width: Array
    contact_length: Array
    penetration: Array

    def __repr__(self) -> str:
        solved = int(np.count_nonzero(self.converged))
        lines = [f"{solved} of {len(self)} cases converged, shape {' x '.join(map(str, self.shape))}"]
        for name in _COLUMNS[:5] if solved else ():
            quantity, values = QUANTITIES[name], self.column(name)[self.converged]
            ends = dict.fromkeys((values.min(), values.max()))
            lines.append(f"{quantity.label} {quantity.amount(*ends, between=' to ')}")
        if self.failures:
            number, error = next(iter(self.failures.items()))
            lines.append(f"failed: case {number}: {shorten(str(error))}")
        return plain_text("Solutions", lines)

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Which cases have a solution."""
        return np.isfinite(self.approach)

    def column(self, name: str) -> Array:
        """Return any of `nonhertz.result.quantities.QUANTITIES` for all cases, nan where a case has no solution.

        Values that are only rounding error, such as the moment of a symmetric contact, are zero.

        Parameters
        ----------
        name : str
            Name of the quantity, such as ``"approach"`` or ``"load_by_approach"``; values are in mm, N, MPa and rad.

        Raises
        ------
        InputError
            If there is no such quantity.
        """
        if not isinstance(name, str) or name not in QUANTITIES:
            raise InputError("name", name, f"be one of {', '.join(QUANTITIES)}", "choose one of them")
        get, at_once = QUANTITIES[name].clean, None
        with contextlib.suppress(AttributeError):  # raised by a quantity that needs whole solutions
            at_once = np.asarray(get(self))
        if at_once is not None and at_once.shape == self.shape:
            return at_once
        cases = zip(range(len(self)), self.converged.ravel().tolist(), strict=True)
        numbers = [get(self._solution(number)) if converged else math.nan for number, converged in cases]
        return np.array(numbers).reshape(self.shape)

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each case, a column for each quantity, units in ``attrs["units"]``.

        The columns ``singular`` and ``converged`` follow the quantities. The index has a level for each of ``axes``;
        a quantity that is an axis is not a column.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        return dataframe(self)

    def to_xarray(self) -> xr.Dataset:
        """Return an xarray Dataset: a variable for each quantity, with units, a dimension for each of ``axes``.

        Raises
        ------
        ImportError
            If xarray is not installed.
        """
        return dataset(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the solutions into an NPZ file, from which `read` returns them to the last bit.

        The contacts are not in it, as profiles and diameters may be functions.

        Parameters
        ----------
        path : str or os.PathLike
            The file, usually named ``.npz``; an existing one is overwritten.

        Raises
        ------
        InputError
            If the cases were solved with an element of your own.
        OSError
            If the file cannot be written.
        """
        files.save(path, self.shape, self._blocks, self.axes)

    @classmethod
    def read(cls, path: str | os.PathLike[str], contacts: Contact | Iterable[Contact]) -> Solutions:
        """Return the solutions in a file that `save` wrote.

        Errors in `failures` are restored with their type if a class of that name is known, which for errors of a user's
        profile means that its module has been imported; otherwise as a NonhertzError with type and message.

        Parameters
        ----------
        path : str or os.PathLike
            The file.
        contacts : Contact or iterable of Contact
            The contacts, as they were given to `nonhertz.solve_many`.

        Raises
        ------
        InputError
            If the file cannot be read, was not written by `save`, is of another version or damaged, or if the contacts
            are not those that the cases were solved with.
        """
        return cls(*files.read(path, contacts))

    def __len__(self) -> int:
        return len(self._place)

    def __iter__(self) -> Iterator[Solution]:
        return (self._solution(number) for number in range(len(self)))

    def __getitem__(self, number: int | tuple[int, ...]) -> Solution:
        try:
            at = np.arange(len(self)).reshape(self.shape)[number]
        except ValueError:
            raise IndexError(f"{number!r} is not a case number") from None
        if at.shape != ():
            raise IndexError(f"give one number for each of the {len(self.shape)} axes")
        return self._solution(int(at))

    def _solution(self, number: int) -> Solution:
        block, row = self._place[number]
        return block.solution(row)

    def line_load(self, number: int) -> tuple[Array, Array]:
        """Return the edges of the strips [mm] and their line loads [N/mm] of a case, counted along all axes.

        Raises
        ------
        InputError, ConvergenceError
            If the case has no solution, as `nonhertz.solve` raises it.
        IndexError
            If there is no such case.
        """
        if isinstance(number, bool) or not isinstance(number, int | np.integer):
            raise IndexError(f"{number!r} is not a case number")
        block, row = self._place[range(len(self))[number]]
        if block.error is not None:
            raise copy.copy(block.error)
        result = block.results[row]
        return result.edges, result.line_load(block.problem.contact.compliance)

    @cached_property
    def failures(self) -> dict[Number, Exception]:
        """Errors of failed cases, by case number, or by a tuple of numbers if there are several axes.

        Each is the error that `nonhertz.solve` raises for the case alone: an InputError, a ConvergenceError, or
        whatever a user's profile or diameter raised. Cases that an interrupted run did not reach have a NonhertzError
        that says so.
        """
        errors = {number: block.error for block in self._blocks if block.error is not None for number in block.numbers}
        return {case_label(number, self.shape): error for number, error in sorted(errors.items())}

    @cached_property
    def warnings(self) -> dict[Number, tuple[str, ...]]:
        """The warnings of each case that has any: strains of the model, and ends with singular pressure."""
        numbers = sorted({*np.flatnonzero(self.singular).tolist(), *self._strained})
        return {case_label(number, self.shape): self._solution(number).warnings for number in numbers}

    @cached_property
    def _strained(self) -> list[int]:
        """The numbers of the cases that strain the model, ascending."""
        return sorted(number for block in self._blocks for number in block.strained())

    def findings(self) -> Iterator[Finding]:
        """Yield a finding on the cases that strain the model, and one on those with singular ends."""
        for number in self._strained[:1]:
            strain = self._solution(number).findings[0]
            yield self._of_many("strained", "cases strain the model", len(self._strained), number, strain)
        for number in np.flatnonzero(self.singular)[:1].tolist():
            solution = self._solution(number)
            singularity = solution.judgement.singularities(solution)[0]
            what = "contacts have an end with singular pressure"
            yield self._of_many("sharp-ends", what, int(np.count_nonzero(self.singular)), number, singularity)

    def _of_many(self, kind: str, what: str, cases: int, number: int, first: Finding) -> Finding:
        words = f"{{cases}} of {{total}} {what}; number {{number}}, the first: {{first}}"
        return finding(kind, words, cases=cases, total=len(self), number=case_label(number, self.shape), first=first)


def case_label(number: int, shape: tuple[int, ...]) -> Number:
    """Return a case's number on each axis, or the number itself if there is only one axis."""
    return number if len(shape) == 1 else tuple(int(index) for index in np.unravel_index(number, shape))
