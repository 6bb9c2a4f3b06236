"""Thousands of cases in one call: loads, tilts and contacts, on all cores.

On a number of strips, or on given ones, all cases of a contact go through compiled loops together. On the automatic
grid every case learns a grid of its own, so they are solved one by one, side by side. Either way the result of a case
is that of `nonhertz.solve`, on equal strips to the tolerance of the equations and on the automatic grid to the bit.
"""

from __future__ import annotations

import contextlib
import copy
import math
import warnings
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import AccuracyWarning, InputError
from nonhertz.inputs.checks import listed, thread_count
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import MOST_TILT, Prescription, refuse_unpaired
from nonhertz.result.brief import plain_text, shortened
from nonhertz.result.data import dataframe, dataset
from nonhertz.result.end_pressure import singular_places
from nonhertz.result.maximum import largest_pressure
from nonhertz.result.numerals import digits
from nonhertz.result.outcome import outcome
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.solution import Solution, read_only
from nonhertz.result.validity import singularities, suspected, wider_than_round
from nonhertz.solver import Strips, levels_of, problem_of, refuse_no_element, wanted_strips
from nonhertz.strip.batch import States, settle_all
from nonhertz.strip.element import SEMI_ELLIPTIC, Element
from nonhertz.strip.levels import Levels, equal_grids, given_grids
from nonhertz.strip.state import Problem

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

Array = NDArray[np.float64]
Number = int | tuple[int, ...]

# A turn of a thread: on shared strips, and on a grid of its own for each. Fixed, so that results do not depend on the
# number of threads.
CASES_AT_ONCE, CASES_APART = 64, 4
_PRESCRIBED = ("approach", "load", "tilt", "moment")
_COLUMNS = (
    "approach", "tilt", "load", "moment", "max_pressure", "max_pressure_y", "max_half_width", "contact_length",
)  # fmt: skip


def solve_many(
    contacts: Contact | Iterable[Contact],
    *,
    approach: ArrayLike | None = None,
    load: ArrayLike | None = None,
    tilt: ArrayLike | None = None,
    moment: ArrayLike | None = None,
    element: Element = SEMI_ELLIPTIC,
    strips: Strips = None,
    threads: int | None = None,
) -> Solutions:
    """Press the bodies of many contacts together, or those of one contact in many ways.

    Parameters
    ----------
    contacts : Contact or iterable of Contact
        One contact for all cases, or one for each.
    approach, load, tilt, moment : array_like, optional
        As in `nonhertz.solve`, a number for all cases or an array; arrays and ``contacts`` are broadcast against each
        other, and the shape that comes of it is that of the results. Along the last axis neighbouring cases should be
        alike: a case may then start from the one before.
    element : Element
        As in `nonhertz.solve`.
    strips : int or array_like or "auto", optional
        As in `nonhertz.solve`, for all cases. A number of strips is several times as fast as the automatic grid, and
        runs on any number of cores without their waiting for each other.
    threads : int, optional
        How many threads to use; all cores if left out. The results do not depend on it.

    Returns
    -------
    Solutions

    Raises
    ------
    InputError
        If the input of any case cannot be used as it stands. What only solving shows, such as bodies that do not
        touch, does not stop the others: see `Solutions.failures`.

    Warns
    -----
    AccuracyWarning
        If some results strain the model's validity, or contacts end where the pressure has no limit, once for all of
        each; see `Solutions.warnings`.

    Notes
    -----
    Each case keeps its strips on all levels: some 3 kB on 41 strips, 15 kB on the automatic grid.

    A case that starts from its neighbour may be solved where it would fail alone, and its error estimate then compares
    with a coarser grid that alone would have failed too.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> contact = Contact(Roller(diameter=20, length=20, profile=crown(radius=4000)), Plate())
    >>> solutions = solve_many(contact, load=[10e3, 15e3, 20e3], tilt=0.2e-3, strips=41)
    >>> solutions.max_pressure.round(-1)
    array([1590., 1860., 2080.])
    >>> bool(solutions[2].max_pressure == solutions.max_pressure[2])
    True
    """
    prescribed = {"approach": approach, "load": load, "tilt": tilt, "moment": moment}
    given = {name: value for name, value in prescribed.items() if value is not None}
    refuse_unpaired(approach, load, tilt, moment)
    refuse_no_element(element)
    several = _several(contacts)
    shape, which, values = _spread(len(several) if not isinstance(contacts, Contact) else None, given)
    tasks = _tasks(several, shape, which, values, element, strips)
    with ThreadPoolExecutor(thread_count(threads)) as pool:
        blocks = [block for found in pool.map(_solved, _portions(tasks)) for block in found]
    solutions = Solutions(shape, tuple(blocks))
    for sentence in solutions._warned():
        warnings.warn(sentence, AccuracyWarning, stacklevel=2)
    return solutions


class Solutions:
    """The results of many cases: arrays of what is most asked for, and the whole `Solution` of any.

    Where a case failed, numbers are not a number, and ``solutions[number]`` raises what `failures` holds.

    Parameters
    ----------
    shape : tuple of int
        Shape of the result arrays, below "(...)".
    blocks : tuple
        What was solved together.

    Attributes
    ----------
    approach, tilt, load, moment : ndarray, shape (...)
        As in `Solution` [mm, rad, N, N mm].
    max_pressure, max_pressure_y : ndarray, shape (...)
        The largest pressure more than a half-width from ends where it has no limit [MPa], and where it is [mm].
    max_half_width, contact_length : ndarray, shape (...)
        As in `Solution` [mm].
    singular : ndarray of bool, shape (...)
        Which contacts have such ends.
    stiffness : ndarray, shape (..., 2, 2)
        As in `Solution`.
    converged : ndarray of bool, shape (...)
        Which cases have a solution.
    """

    def __init__(self, shape: tuple[int, ...], blocks: tuple[_Block, ...]) -> None:
        self.shape = shape
        self._blocks = blocks
        self._place: dict[int, tuple[_Block, int]] = {
            number: (block, row) for block in blocks for row, number in enumerate(block.numbers)
        }
        columns = {name: np.full(len(self._place), np.nan) for name in _COLUMNS}
        stiffness = np.full((len(self._place), 2, 2), np.nan)
        singular = np.zeros(len(self._place), dtype=bool)
        for block in blocks:
            if block.error is None:
                for name, column in zip(_COLUMNS, block.columns(), strict=True):
                    columns[name][block.numbers] = column
                stiffness[block.numbers] = block.finest.stiffness / block.contact.compliance
                singular[block.numbers] = block.has_singular_ends
        for name, column in columns.items():
            setattr(self, name, read_only(column).reshape(shape))
        self.stiffness = read_only(stiffness).reshape(*shape, 2, 2)
        self.singular = read_only(singular).reshape(shape)

    approach: Array
    tilt: Array
    load: Array
    moment: Array
    max_pressure: Array
    max_pressure_y: Array
    max_half_width: Array
    contact_length: Array

    def __repr__(self) -> str:
        solved = int(np.count_nonzero(self.converged))
        said = [f"{solved} of {len(self)} cases converged, shape {' x '.join(map(str, self.shape))}"]
        for name in _COLUMNS[:5] if solved else ():
            quantity, values = QUANTITIES[name], getattr(self, name)[self.converged]
            low, high = (digits(quantity.factor * float(end)) for end in (values.min(), values.max()))
            said.append(f"{quantity.label} {low} to {high} {quantity.shown_unit}")
        if self.failures:
            number, error = next(iter(self.failures.items()))
            said.append(f"failed: case {number}: {shortened(str(error))}")
        return plain_text("Solutions", said)

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Which cases have a solution."""
        return np.isfinite(self.approach)

    def column(self, name: str) -> Array:
        """Return any quantity of `nonhertz.result.quantities.QUANTITIES` of all cases, nan where one has no solution.

        Parameters
        ----------
        name : str
            Such as ``"approach"`` or ``"load_by_approach"``, in the units of Python.

        Raises
        ------
        InputError
            If there is no such quantity.
        """
        if not isinstance(name, str) or name not in QUANTITIES:
            raise InputError("name", name, f"be one of {', '.join(QUANTITIES)}", "choose one of them")
        get, at_once = QUANTITIES[name].get, None
        with contextlib.suppress(AttributeError):  # which a quantity has that is made of whole solutions
            at_once = np.asarray(get(self))
        if at_once is not None and at_once.shape == self.shape:
            return at_once
        cases = zip(range(len(self)), self.converged.ravel().tolist(), strict=True)
        found = [get(self._solution(number)) if converged else math.nan for number, converged in cases]
        return np.array(found).reshape(self.shape)

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each case, a column for each quantity, units in ``attrs["units"]``.

        Beside the quantities there are ``singular`` and ``converged``. Of several axes the index has a level each.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        return dataframe(self)

    def to_xarray(self) -> xr.Dataset:
        """Return an xarray Dataset: a variable for each quantity, with units, a dimension for each axis.

        Raises
        ------
        ImportError
            If xarray is not installed.
        """
        return dataset(self)

    def __len__(self) -> int:
        return len(self._place)

    def __iter__(self) -> Iterator[Solution]:
        return (self._solution(number) for number in range(len(self)))

    def __getitem__(self, number: int | tuple[int, ...]) -> Solution:
        try:
            at = np.arange(len(self)).reshape(self.shape)[number]
        except ValueError:
            raise IndexError(f"{number!r} is no number of a case") from None
        if at.shape != ():
            raise IndexError(f"one number for each of the {len(self.shape)} axes is wanted")
        return self._solution(int(at))

    def _solution(self, number: int) -> Solution:
        block, row = self._place[number]
        return block.solution(row)

    @cached_property
    def failures(self) -> dict[Number, Exception]:
        """Why cases have no solution, by their number, or numbers where there are several axes.

        Each is the error that `nonhertz.solve` raises for the case alone: an InputError, a ConvergenceError, or what a
        profile or diameter of your own raised.
        """
        found = {number: block.error for block in self._blocks if block.error is not None for number in block.numbers}
        return {_label(number, self.shape): error for number, error in sorted(found.items())}

    @cached_property
    def warnings(self) -> dict[Number, tuple[str, ...]]:
        """The warnings of each case that has any: what strains the model, and ends without a limit of the pressure."""
        found = sorted({*np.flatnonzero(self.singular).tolist(), *self._strained})
        return {_label(number, self.shape): self._solution(number).warnings for number in found}

    @cached_property
    def _strained(self) -> dict[int, str]:
        """What strains the model first, of each case that something does."""
        return dict(sorted(pair for block in self._blocks for pair in block.strained()))

    def _warned(self) -> Iterator[str]:
        """Yield a sentence on the cases that strain the model, and one on those with singular ends."""
        for number, sentence in list(self._strained.items())[:1]:
            cases = f"{len(self._strained)} of {len(self)} cases strain the model"
            yield f"{cases}; number {_label(number, self.shape)}, the first: {sentence}"
        for number in np.flatnonzero(self.singular)[:1].tolist():
            cases = f"{np.count_nonzero(self.singular)} of {len(self)} contacts end where the pressure has no limit"
            sentence = singularities(self._solution(number))[0]
            yield f"{cases}; number {_label(number, self.shape)}, the first: {sentence}"


def _label(number: int, shape: tuple[int, ...]) -> Number:
    """Return the number of a case on each axis, or the number alone where there is one."""
    return number if len(shape) == 1 else tuple(int(index) for index in np.unravel_index(number, shape))


@dataclass(frozen=True)
class _Block:
    """Cases that were solved together, or one that has no solution."""

    contact: Contact
    problem: Problem
    numbers: list[int]
    targets: Array
    states: tuple[States, ...]  # finest first
    error: Exception | None = None

    @property
    def finest(self) -> States:
        return self.states[0]

    def columns(self) -> tuple[Array, ...]:
        """Return the results named in `_COLUMNS`, by the formulas of `Solution`."""
        states, compliance = self.finest, self.contact.compliance
        y, width = 0.5 * (states.edges[1:] + states.edges[:-1]), np.diff(states.edges)
        line_load = states.r * states.m / compliance
        return (
            states.rigid[:, 0], states.rigid[:, 1], line_load @ width, line_load @ (width * y),
            *self.largest, self.problem.element.hertz_ratio * np.sqrt(states.m.max(axis=1)), self._contact_lengths(),
        )  # fmt: skip

    def _contact_lengths(self) -> Array:
        intervals = (self.finest.one(row).contact for row in range(len(self.numbers)))
        return np.array([math.fsum(high - low for low, high in each) for each in intervals])

    @cached_property
    def largest(self) -> tuple[Array, Array]:
        """Largest pressures [MPa] and where they are [mm], shape (cases,)."""
        states = self.finest
        y = 0.5 * (states.edges[1:] + states.edges[:-1])
        half_width = self.problem.element.hertz_ratio * np.sqrt(states.m)
        line_load, pressure = states.r * states.m / self.contact.compliance, np.zeros_like(states.m)
        touching = half_width > 0.0
        pressure[touching] = 2.0 * line_load[touching] / (np.pi * half_width[touching])
        return largest_pressure(y, pressure, half_width, self.singular)

    @cached_property
    def singular(self) -> Array:
        """Where contacts end without a limit of the pressure [mm], shape (cases, k), nan for no such end."""
        return singular_places(self.contact, self.problem, self.finest)

    @property
    def has_singular_ends(self) -> NDArray[np.bool_]:
        """Which contacts end so."""
        ends: NDArray[np.bool_] = np.any(np.isfinite(self.singular), axis=1)
        return ends

    def solution(self, row: int) -> Solution:
        """Return the solution of one case."""
        if self.error is not None:
            # A copy, since every raise adds to an error's traceback.
            raise copy.copy(self.error)
        problem = replace(self.problem, target=self.targets[row])
        states = [states.one(row) for states in self.states]
        levels = Levels((states[0], *(state for state in states[1:] if state.converged)))
        return outcome(self.contact, problem, levels)

    def strained(self) -> Iterator[tuple[int, str]]:
        """Yield numbers of cases that strain the model, and the first sentence on each."""
        if self.error is not None:
            return
        asked = self.contact, self.problem, self.states, self.singular, self.largest[1]
        for row in np.flatnonzero(suspected(*asked)):
            solution = self.solution(int(row))
            of_ends = singularities(solution)
            sentences = [each for each in solution.warnings if each not in of_ends]
            if sentences:
                yield self.numbers[row], sentences[0]


@dataclass(frozen=True)
class _Task:
    """Cases of one contact for one thread."""

    contact: Contact
    problem: Problem
    numbers: list[int]
    targets: Array
    strips: Strips

    def solved(self) -> list[_Block]:
        """Return the cases solved, those together that were solved together."""
        grids = self._grids()
        if grids is None:
            return [self._alone(row) for row in range(len(self.numbers))]
        try:
            states = tuple(settle_all(self.problem, grids, self.targets))
        # What the bodies refuse or raise, each case is told in its turn.
        except Exception:  # noqa: BLE001
            return [self._alone(row) for row in range(len(self.numbers))]
        done = np.flatnonzero(states[0].converged & ~self._too_wide(states[0]))
        blocks = [self._alone(row) for row in range(len(self.numbers)) if row not in done]
        if done.size:
            numbers, kept = [self.numbers[row] for row in done], tuple(level.only(done) for level in states)
            blocks.append(_Block(self.contact, self.problem, numbers, self.targets[done], kept))
        return blocks

    def _grids(self) -> list[Array] | None:
        """Return the grids that the cases share, or None where each has its own."""
        count, edges = wanted_strips(self.contact, self.strips)
        low, high = self.contact.interval
        if count is not None and np.isfinite(high - low):
            return equal_grids(self.problem, self.contact.interval, count)
        return given_grids(edges) if edges is not None else None

    def _too_wide(self, states: States) -> NDArray[np.bool_]:
        """Return which contacts are wider than their bodies are thick or round, which each is told in its turn."""
        y = 0.5 * (states.edges[1:] + states.edges[:-1])
        half_width = self.problem.element.hertz_ratio * np.sqrt(states.m)
        beyond = wider_than_round(self.contact, y, half_width) | (self.problem.influence.shallowest(y) < half_width)
        wide: NDArray[np.bool_] = np.any(beyond, axis=1)
        return wide

    def _alone(self, row: int) -> _Block:
        """Return one case, solved as `nonhertz.solve` does."""
        problem = replace(self.problem, target=self.targets[row], _sampled={})
        at = [self.numbers[row]], self.targets[row : row + 1]
        try:
            levels = levels_of(self.contact, problem, self.strips)
            outcome(self.contact, problem, levels)
        # Whatever a case raises, be it a profile of the user's own, it must not take the others with it.
        except Exception as error:  # noqa: BLE001
            return _Block(self.contact, self.problem, *at, (), error.with_traceback(None))
        return _Block(self.contact, self.problem, *at, tuple(States.of(state) for state in levels.states))


def _several(contacts: Contact | Iterable[Contact]) -> list[Contact]:
    if isinstance(contacts, Contact):
        return [contacts]
    remedy = "give one Contact, or a list of them"
    several: list[Contact] = listed("contacts", contacts, "be contacts", remedy)
    for number, contact in enumerate(several):
        if not isinstance(contact, Contact):
            raise InputError(f"contacts[{number}]", contact, "be a Contact", remedy)
    return several


def _spread(
    contacts: int | None, given: dict[str, ArrayLike]
) -> tuple[tuple[int, ...], NDArray[np.intp], dict[str, Array]]:
    """Return the shape of the results, and for each case which contact it is of and what is prescribed."""
    columns = [np.zeros((), dtype=int) if contacts is None else np.arange(contacts)]
    for name, value in given.items():
        try:
            column = np.asarray(value)
        except (TypeError, ValueError):
            column = np.asarray(None)
        if column.dtype.kind not in "iuf" or np.ma.isMaskedArray(value):
            if column.size:
                raise InputError(name, value, "be a number or an array of numbers", "give plain numbers")
            column = column.astype(float)
        columns.append(column)
    try:
        spread = np.broadcast_arrays(*columns)
    except ValueError:
        shapes = ", ".join(
            f"{name}: {column.shape}" for name, column in zip(("contacts", *given), columns, strict=True)
        )
        raise InputError("shapes", shapes, "fit together", "give numbers, or arrays that broadcast") from None
    if spread[0].size == 0:
        empty = next(name for name, column in zip(("contacts", *given), columns, strict=True) if column.size == 0)
        raise InputError(empty, [], "hold at least one case", "leave the call out where there is none")
    which, *values = (column.ravel() for column in spread)
    return (
        spread[0].shape or (1,),
        which,
        {name: value.astype(float) for name, value in zip(given, values, strict=True)},
    )


def _tasks(
    contacts: list[Contact],
    shape: tuple[int, ...],
    which: NDArray[np.intp],
    given: dict[str, Array],
    element: Element,
    strips: Strips,
) -> list[_Task]:
    """Return the cases in portions of one contact each; input that cannot be used is refused here."""
    by_contact: dict[int, list[int]] = {}
    for number, index in enumerate(which.tolist()):
        by_contact.setdefault(id(contacts[index]), []).append(number)

    def case(number: int) -> Prescription:
        return Prescription.checked(*(float(given[name][number]) if name in given else None for name in _PRESCRIBED))

    def refused(error: InputError, number: int) -> InputError:
        return error.within(f"case {_label(number, shape)}") if which.size > 1 else error

    number = 0
    try:
        for number in _suspects(given):
            case(number)
    except InputError as error:
        raise refused(error, number) from None
    tasks = []
    for numbers in by_contact.values():
        contact = contacts[which[numbers[0]]]
        wanted_strips(contact, strips)
        try:
            number = numbers[0]
            problem = problem_of(contact, case(number), element)
            # A moment may lie beyond the ends of the bodies in each case, a load out of range in the outermost.
            loads = given["load"][numbers] if "load" in given else np.zeros(1)
            outermost = [numbers[int(loads.argmin())], numbers[int(loads.argmax())]]
            for number in numbers if "moment" in given else outermost:
                case(number).refuse_outside(contact)
        except InputError as error:
            raise refused(error, number) from None
        targets = np.zeros((len(numbers), 2))
        for column, force, motion in ((0, "load", "approach"), (1, "moment", "tilt")):
            if force in given:
                targets[:, column] = contact.compliance * given[force][numbers]
            elif motion in given:
                targets[:, column] = given[motion][numbers]
        at_once = CASES_APART if _automatic(strips) else CASES_AT_ONCE
        for first in range(0, len(numbers), at_once):
            portion = slice(first, first + at_once)
            tasks.append(_Task(contact, problem, numbers[portion], targets[portion], strips))
    return tasks


def _suspects(given: dict[str, Array]) -> list[int]:
    """Return the cases with a number that cannot be used."""
    suspects = np.any([~np.isfinite(values) for values in given.values()], axis=0)
    if "load" in given:
        suspects |= given["load"] <= 0.0
    if "tilt" in given:
        suspects |= np.abs(given["tilt"]) > MOST_TILT
    return np.flatnonzero(suspects).tolist()


def _automatic(strips: Strips) -> bool:
    return strips is None or isinstance(strips, str)


def _portions(tasks: list[_Task]) -> Iterator[list[_Task]]:
    """Yield tasks together until they make up a portion worth a turn of a thread."""
    portion: list[_Task] = []
    for task in tasks:
        portion.append(task)
        if sum(len(each.numbers) for each in portion) >= (CASES_APART if _automatic(task.strips) else CASES_AT_ONCE):
            yield portion
            portion = []
    yield portion


def _solved(tasks: list[_Task]) -> list[_Block]:
    return [block for task in tasks for block in task.solved()]
