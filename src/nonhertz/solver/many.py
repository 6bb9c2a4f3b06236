"""Thousands of cases in one call: loads, tilts and contacts, on all cores.

Each case is solved as by `nonhertz.solve`, some dozens in a row by each thread. On a given number of strips, or given
edges, a case may start from the one before; its result then agrees with `nonhertz.solve` to the tolerance of the
equations. On the automatic grid it agrees to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nonhertz.errors import InputError
from nonhertz.findings import warn
from nonhertz.inputs.checks import check_callback, thread_count
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import MOST_TILT, Prescription, refuse_unpaired
from nonhertz.native import core
from nonhertz.result.data import name_axes
from nonhertz.solver.blocks import list_contacts
from nonhertz.solver.one import Goal, Strips, element_of, problem_of, requested_strips, strips_of
from nonhertz.solver.portions import Chunk, Run, Task, Work
from nonhertz.solver.solutions import Solutions, case_label
from nonhertz.strip.element import SEMI_ELLIPTIC, Element

Array = NDArray[np.float64]

# Cases per unit of work for a thread: on shared strips, and with a separate grid for each. Fixed, so that results do
# not depend on the number of threads.
CASES_AT_ONCE, CASES_APART = 64, 32
# A motion, and the force that may replace it, for each column of targets.
_PRESCRIBED = ("approach", "load", "tilt", "moment")


def solve_many(
    contacts: Contact | Iterable[Contact],
    *,
    approach: ArrayLike | None = None,
    load: ArrayLike | None = None,
    tilt: ArrayLike | None = None,
    moment: ArrayLike | None = None,
    element: Element | str = SEMI_ELLIPTIC,
    strips: Strips = None,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
    threads: int | None = None,
    callback: Callable[[Chunk], object] | None = None,
) -> Solutions:
    """Press the bodies of many contacts together, or those of one contact in many ways.

    Parameters
    ----------
    contacts : Contact or iterable of Contact
        One contact for all cases, or one for each.
    approach, load, tilt, moment : array_like, optional
        As in `nonhertz.solve`, a number or text with a unit for all cases, or an array of them; arrays and ``contacts``
        are broadcast against each other, and the resulting shape is that of the results. Neighbouring cases along the
        last axis should be similar: a case may then start from the previous one.
    element : Element or str
        As in `nonhertz.solve`.
    strips : int or array_like or "auto", optional
        As in `nonhertz.solve`, for all cases. A number of strips is several times as fast as the automatic grid, and
        scales to any number of cores.
    accuracy, accuracy_of : optional
        As in `nonhertz.solve`, for all cases.
    threads : int, optional
        Number of threads; all cores if left out. The results do not depend on it.
    callback : callable, optional
        Called in the caller's thread with a `Chunk` of a few dozen cases whenever the next one is finished, in an
        order that does not depend on ``threads``: for progress, ``callback=print`` is enough. Whatever it raises stops
        the run.

    Returns
    -------
    Solutions

    Raises
    ------
    InputError
        If the input of any case is invalid. Failures that only solving reveals, such as bodies that do not touch, do
        not stop the other cases: see `Solutions.failures`.
    Interrupted
        On Ctrl-C, within a step of the case that is being solved. Its ``solutions`` holds what was solved until then;
        the other cases are among the failures.

    Warns
    -----
    AccuracyWarning
        If some results strain the model's validity, or the pressure is singular at the ends of some contacts: one
        warning for each of the two, whatever the number of cases; see `Solutions.warnings`.

    Notes
    -----
    Each case stores its strips on all levels: some 3 kB on 41 strips, 15 kB on the automatic grid.

    A case that starts from its neighbour may succeed where it would fail on its own. If it fails, it is also tried on
    its own.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> contact = Contact(Roller(diameter=20, length=20, profile=crown(radius=4000)), Plate())
    >>> solutions = solve_many(contact, load=[10e3, 15e3, 20e3], tilt=0.2e-3, strips=41)
    >>> solutions.max_pressure.round(-1)
    array([1590., 1860., 2090.])
    >>> bool(solutions[2].max_pressure == solutions.max_pressure[2])
    True
    """
    check_callback(callback)
    prescribed = {"approach": approach, "load": load, "tilt": tilt, "moment": moment}
    axes, tasks = _lay_out(contacts, prescribed, _Options(element_of(element), strips, accuracy, accuracy_of))
    shape = tuple(values.size for values in axes.values())
    solutions, findings = Run(shape, tuple(_group_tasks(tasks)), thread_count(threads), axes).outcome(callback)
    warn(findings)
    return solutions


def solve_without_warnings(
    contact: Contact,
    prescribed: Mapping[str, ArrayLike],
    *,
    element: Element | str,
    strips: Strips,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
) -> Solutions:
    """Return the same as `solve_many`, in the caller's thread and without warnings.

    Starting a thread takes as long as a simple case.

    Raises
    ------
    InputError
        As for `solve_many`.
    """
    axes, tasks = _lay_out(contact, prescribed, _Options(element_of(element), strips, accuracy, accuracy_of))
    stop, shape = core.Stop(), tuple(values.size for values in axes.values())
    return Solutions(shape, tuple(block for work in _group_tasks(tasks) for block in work.solved(stop)))


@dataclass(frozen=True)
class _Options:
    """Options shared by all cases."""

    element: Element
    strips: Strips
    accuracy: float | None
    accuracy_of: Goal | None


def _lay_out(
    contacts: Contact | Iterable[Contact], prescribed: Mapping[str, ArrayLike | None], options: _Options
) -> tuple[dict[str, NDArray[Any]], list[Task]]:
    """Return the axes of the results and the cases; invalid input is refused."""
    prescriptions = {name: value for name, value in prescribed.items() if value is not None}
    refuse_unpaired(**{name: prescribed.get(name) for name in _PRESCRIBED})
    contact_list = list_contacts(contacts)
    shape, which, values = _broadcast(len(contact_list) if not isinstance(contacts, Contact) else None, prescriptions)
    axes = name_axes({name: value.reshape(shape) for name, value in (values | {"contact": which}).items()}, shape)
    return axes, _make_tasks(contact_list, shape, which, values, options)


def _broadcast(
    contacts: int | None, prescriptions: dict[str, ArrayLike]
) -> tuple[tuple[int, ...], NDArray[np.intp], dict[str, Array]]:
    """Return the shape of the results, and for each case the index of its contact and its prescribed values."""
    columns = {"contacts": np.zeros((), dtype=int) if contacts is None else np.arange(contacts)}
    columns |= {name: _parse_column(name, value) for name, value in prescriptions.items()}
    try:
        which, *values = np.broadcast_arrays(*columns.values())
    except ValueError:
        shapes = ", ".join(f"{name}: {column.shape}" for name, column in columns.items())
        raise InputError("shapes", shapes, "broadcast together", "give numbers, or arrays of matching shapes") from None
    empty = next((name for name, column in columns.items() if not column.size), None)
    if empty is not None:
        raise InputError(empty, [], "hold at least one case", "skip the call if there is none")
    prescribed = zip(prescriptions, values, strict=True)
    return which.shape or (1,), which.ravel(), {name: value.ravel().astype(float) for name, value in prescribed}


def _parse_column(name: str, value: ArrayLike) -> NDArray[Any]:
    """Return a prescribed quantity as an array of numbers; text is converted from its unit."""
    try:
        column = np.asarray(value)
        if column.dtype.kind in "UO":
            validate, texts = Prescription.descriptions[name].validate, np.asarray(value, dtype=object)
            numbers = [validate(name, text) if isinstance(text, str) else text for text in texts.flat]
            column = np.array(numbers).reshape(texts.shape)
    except InputError:
        raise
    except (TypeError, ValueError):
        column = np.asarray(None)
    if column.dtype.kind in "iuf" and not np.ma.isMaskedArray(value):
        return column
    if column.size:
        raise InputError(name, value, "be a number or an array of numbers", "give plain numbers, or text with a unit")
    return column.astype(float)


@contextmanager
def _name_case(number: int, shape: tuple[int, ...]) -> Iterator[None]:
    """Name the case in which an input is invalid, if there are several."""
    try:
        yield
    except InputError as error:
        raise (error.within(f"case {case_label(number, shape)}") if math.prod(shape) > 1 else error) from None


def _make_tasks(
    contacts: list[Contact],
    shape: tuple[int, ...],
    which: NDArray[np.intp],
    prescribed: dict[str, Array],
    options: _Options,
) -> list[Task]:
    """Return the cases in portions of one contact each; invalid input is refused here."""
    by_contact: dict[int, list[int]] = {}
    for number, index in enumerate(which.tolist()):
        by_contact.setdefault(id(contacts[index]), []).append(number)

    def case(number: int) -> Prescription:
        return Prescription(**{name: float(values[number]) for name, values in prescribed.items()})

    for number in _suspects(prescribed):
        with _name_case(number, shape):
            case(number)
    tasks = []
    for numbers in by_contact.values():
        contact = contacts[which[numbers[0]]]
        requested_strips(contact, options.strips)
        with _name_case(numbers[0], shape):
            aim = options.accuracy, options.accuracy_of
            problem = problem_of(contact, case(numbers[0]), options.element, options.strips, *aim)
        # A moment may act outside the bodies in any case; a load out of range is found among the extreme cases.
        loads = prescribed.get("load", np.zeros(which.size))[numbers]
        outermost = [numbers[int(loads.argmin())], numbers[int(loads.argmax())]]
        for number in numbers if "moment" in prescribed else outermost:
            with _name_case(number, shape):
                case(number).refuse_outside(contact)
        targets = np.zeros((len(numbers), 2))
        for name, values in prescribed.items():
            column, is_force = divmod(_PRESCRIBED.index(name), 2)
            targets[:, column] = (contact.compliance if is_force else 1.0) * values[numbers]
        strips = strips_of(problem, options.strips)
        at_once = _portion_size(strips)
        for first in range(0, len(numbers), at_once):
            portion = slice(first, first + at_once)
            tasks.append(Task(problem, numbers[portion], list(map(tuple, targets[portion].tolist())), strips))
    return tasks


def _suspects(prescribed: dict[str, Array]) -> list[int]:
    """Return the cases with an invalid number."""
    suspects = np.any([~np.isfinite(values) for values in prescribed.values()], axis=0)
    if "load" in prescribed:
        suspects |= prescribed["load"] <= 0.0
    if "tilt" in prescribed:
        suspects |= np.abs(prescribed["tilt"]) > MOST_TILT
    return np.flatnonzero(suspects).tolist()


def _portion_size(strips: core.Accuracy | int | Array) -> int:
    return CASES_APART if isinstance(strips, core.Accuracy) else CASES_AT_ONCE


def _group_tasks(tasks: list[Task]) -> Iterator[Work]:
    """Yield tasks grouped into portions large enough for one unit of work of a thread."""
    portion: list[Task] = []
    for task in tasks:
        portion.append(task)
        if sum(len(queued.numbers) for queued in portion) >= _portion_size(task.strips):
            yield Work(tuple(portion))
            portion = []
    if portion:
        yield Work(tuple(portion))
