"""Solutions on disk: only the state of every strip, which cannot be recomputed from the contacts.

All states are concatenated, field by field: an archive of a million small arrays would take minutes to open. Cases
stay in the blocks in which they were solved, so that all derived results are the same to the last bit.
"""

from __future__ import annotations

import ast
import json
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import ConvergenceError, InputError, NonhertzError, shown
from nonhertz.inputs.archives import Archive, Entries, digest, text
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.result.outcome import LevelState, outcome, restore, states_of_levels
from nonhertz.solver.blocks import Block, list_contacts
from nonhertz.solver.one import pose_problem
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC
from nonhertz.strip.problem import Problem, Target

Array = NDArray[np.float64]

ARCHIVE = Archive(
    kind="nonhertz solutions",
    version=2,  # 1 held blocks of cases on common grids
    contents="solutions",
    undamaged="undamaged solutions",
    most=16_000_000_000,
    remedy="give a file that Solutions.save wrote",
    again="solve the cases again with this nonhertz",
)
_ELEMENTS = {element.name: element for element in (SEMI_ELLIPTIC, PARABOLIC)}
_COUNTED = {"status", "steps"}
# Relative to the largest value: on another processor the last digit of a logarithm may differ for the same contact.
SAME = 1e-12
_AS_GIVEN = "give them as they were given to solve_many"


def save(
    path: str | os.PathLike[str], shape: tuple[int, ...], blocks: tuple[Block, ...], axes: Mapping[str, NDArray[Any]]
) -> None:
    """Write blocks of cases."""
    problem = blocks[0].problem
    if _ELEMENTS.get(problem.model.element.name) != problem.model.element:
        remedy = "pickle them, or solve with nonhertz.SEMI_ELLIPTIC or nonhertz.PARABOLIC"
        raise InputError("element", problem.model.element.name, "be one of nonhertz for solutions to be saved", remedy)
    sources: dict[int, Block] = {}  # a block of each contact, one with strips if there is any
    for block in blocks:
        if not sources.setdefault(id(block.problem.contact), block).results:
            sources[id(block.problem.contact)] = block
    order = {contact: number for number, contact in enumerate(sources)}
    cases = [case for block in blocks for case in _list_cases(block, order[id(block.problem.contact)])]
    rows, numbers, targets, levels, accuracies = zip(*cases, strict=True)
    fields = {
        "shape": np.array(shape),
        "axes": np.asarray(json.dumps({name: values.tolist() for name, values in axes.items()})),
        "element": np.asarray(problem.model.element.name),
        "prescribed": np.array(problem.by_force),
        # None becomes NaN.
        "accuracy": np.array([problem.accuracy, problem.accuracy_given, problem.pressure_accuracy], dtype=float),
        "blocks": np.array(rows),
        "accuracies": np.array(accuracies),
        "numbers": np.concatenate(numbers).astype(np.int64),
        "targets": np.array([*chain.from_iterable(targets)]).reshape(-1, 2),
        "errors": np.asarray(json.dumps([_describe_error(block.error) for block in blocks if block.error is not None])),
        **_level_fields(list(chain.from_iterable(levels))),
        **_contact_fields(list(sources.values())),
    }
    ARCHIVE.save(path, fields | {"digest": np.asarray(digest(fields))})


def read(
    path: str | os.PathLike[str], contacts: Contact | Iterable[Contact]
) -> tuple[tuple[int, ...], tuple[Block, ...], dict[str, NDArray[Any]]]:
    """Return the shape of the results, the blocks, and the axes, which files before 0.1.0 lack."""
    sources = list_contacts(contacts)
    entries = ARCHIVE.load(path)
    stated = text(entries, "digest")
    fields = {name: value for name, value in entries.items() if name not in {"kind", "version", "digest"}}
    if stated != digest(fields):
        raise ARCHIVE.damaged_error(path)
    shape = tuple(fields["shape"].tolist())
    if isinstance(contacts, Contact):
        sources = sources * shape[-1]
    if len(sources) not in {1, shape[-1]}:
        condition = f"be 1 or {shape[-1]}, as many as the cases have along the last axis"
        raise InputError("number of contacts", len(sources), condition, _AS_GIVEN)
    which = np.broadcast_to(np.arange(len(sources)), shape).ravel()
    axes = {name: np.array(values) for name, values in json.loads(text(fields, "axes") or "{}").items()}
    return shape, tuple(_blocks(fields, sources, which)), axes


class _SavedCase(NamedTuple):
    """A case with a state on each level, or cases without states that have the same error."""

    row: tuple[int, int, int, bool]  # number of the contact, of cases, of levels; whether they failed
    numbers: list[int]
    targets: list[Target]
    levels: list[LevelState]
    accuracy: float  # of the grids; zero where a coarser one has no solution


def _list_cases(block: Block, contact: int) -> Iterator[_SavedCase]:
    """Yield the cases of a block."""
    failed = block.error is not None
    if not block.results:
        yield _SavedCase((contact, len(block.numbers), 0, failed), block.numbers, block.targets, [], 0.0)
        return
    for number, target, result in zip(block.numbers, block.targets, block.results, strict=True):
        levels = states_of_levels(result)
        yield _SavedCase((contact, 1, len(levels), failed), [number], [target], levels, result.accuracy)


def _blocks(fields: Entries, sources: list[Contact], which: NDArray[np.intp]) -> Iterator[Block]:
    problems, errors = _Problems(fields), iter(json.loads(str(fields["errors"])))
    levels, known, first = _levels(fields), _errors_by_name(), 0
    solved: list[Block] = []
    for (contact, cases, grids, failed), accuracy in zip(fields["blocks"].tolist(), fields["accuracies"], strict=True):
        part = slice(first, first + cases)
        first += cases
        numbers = fields["numbers"][part].tolist()
        targets = [(one, two) for one, two in fields["targets"][part].tolist()]
        # All are compared; the same contact may have been given several times as equal objects.
        problem, *_ = (problems.of(contact, sources, int(at)) for at in dict.fromkeys(which[numbers].tolist()))
        states = [next(levels) for _ in range(grids)]
        results = [restore(problem.of(targets[0]), states, accuracy, accepted=not failed)] if states else []
        block = Block(problem, numbers, targets, results)
        if failed:
            yield _failed_block(block, next(errors), known)
        elif solved and solved[-1].problem is problem:
            solved.append(block)
        else:
            yield from _merge_blocks(solved)
            solved = [block]
    yield from _merge_blocks(solved)


def _merge_blocks(blocks: list[Block]) -> Iterator[Block]:
    """Yield cases of one contact in one block."""
    if blocks:
        yield Block(
            blocks[0].problem, [number for block in blocks for number in block.numbers],
            [target for block in blocks for target in block.targets],
            [result for block in blocks for result in block.results],
        )  # fmt: skip


def _level_fields(levels: list[LevelState]) -> dict[str, NDArray[Any]]:
    fields: dict[str, NDArray[Any]] = {"counts": np.array([level.r.size for level in levels], dtype=np.int64)}
    for name in LevelState._fields:
        values = [np.ravel(getattr(level, name)) for level in levels]
        fields[name] = np.concatenate([*values, np.zeros(0)]).astype(np.int64 if name in _COUNTED else np.float64)
    return fields


def _levels(fields: Entries) -> Iterator[LevelState]:
    """Yield the states of all levels."""
    ends = dict.fromkeys(LevelState._fields, 0)

    def following(name: str, count: int) -> Any:
        ends[name] += count
        return fields[name][ends[name] - count : ends[name]]

    for n in fields["counts"].tolist():
        yield LevelState(
            following("edges", n + 1), following("r", n), following("m", n), following("gap", n),
            following("rigid", 2).tolist(), following("stiffness", 4).reshape(2, 2).tolist(),
            following("status", 1).item(), following("steps", 1).item(), following("residual", 1).item(),
        )  # fmt: skip


# Contacts


class _Fingerprint(NamedTuple):
    """Data by which a contact is recognised.

    Attributes
    ----------
    places : ndarray, shape (n,)
        Positions at which its surfaces are compared [mm].
    surfaces : ndarray, shape (5, n)
        Relief and curvature of both bodies, and the smaller of their depths.
    numbers : ndarray, shape (k,)
        Materials and intervals of both bodies, influence of strips, and bends.
    """

    places: Array
    surfaces: Array
    numbers: Array

    @classmethod
    def of(cls, problem: Problem, places: Array) -> _Fingerprint:
        """Return the fingerprint of a contact."""
        contact = problem.contact
        of_bodies = [values for body in (contact.a, contact.b) for values in _surface(body, places)]
        influence, bends = problem.model.influence, contact.bends
        numbers = [
            *(number for body in (contact.a, contact.b) for number in (
                body.material.modulus, body.material.poisson, *body.interval,
            )),
            len(influence.terms), *np.sum(np.abs(influence.terms), axis=0).tolist(), len(influence.references),
            len(influence.ends), len(influence.faces), len(bends), float(np.sum(np.abs(bends))),
        ]  # fmt: skip
        depths = [reference.below(places) for reference in influence.references]
        surfaces = np.array([*of_bodies, np.min([np.full(places.shape, np.inf), *depths], axis=0)])
        return cls(places, surfaces, np.array(numbers, dtype=float))

    def like(self, other: _Fingerprint) -> bool:
        """Return whether the other is of the same contact."""
        rows = zip((*self.surfaces, self.numbers), (*other.surfaces, other.numbers), strict=True)
        return all(
            np.allclose(
                a, b, rtol=SAME, atol=SAME * float(np.max(np.abs(a[np.isfinite(a)]), initial=0.0)), equal_nan=True
            )
            for a, b in rows
        )


def _contact_fields(sources: list[Block]) -> dict[str, NDArray[Any]]:
    places, surfaces, numbers = zip(
        *(_Fingerprint.of(source.problem, _places(source)) for source in sources), strict=True
    )
    return {
        "problems": np.array([source.problem.target for source in sources]),
        "contact_sizes": np.array([at.size for at in places]),
        "contact_places": np.concatenate(places),
        "contact_surfaces": np.concatenate(surfaces, axis=1),
        "contact_numbers": np.array(numbers),
    }


def _surface(body: Body, places: Array) -> Iterator[Array]:
    for function in (body.relief_at, body.curvature_at):
        try:
            yield np.asarray(function(places), dtype=float)
        # A user's profile may raise anything; if it did so in all cases, it may do so here.
        except Exception:  # noqa: BLE001
            yield np.full(places.shape, np.nan)


def _places(block: Block) -> Array:
    """Return the positions at which the contact of a block is compared: the strips of its first case, if any."""
    if block.results:
        edges = block.results[0].edges
        return 0.5 * (edges[1:] + edges[:-1])
    low, high = block.problem.contact.interval
    low = low if math.isfinite(low) else min(high - 2.0, -1.0)
    return np.linspace(low, high if math.isfinite(high) else max(low + 2.0, 1.0), 42)


class _Problems:
    """The problems of the given contacts, each compared once with the one it was solved for."""

    def __init__(self, fields: Entries) -> None:
        self._fields = fields
        self._ends = np.cumsum(fields["contact_sizes"])
        self._known: dict[tuple[int, int], Problem] = {}

    def of(self, stored: int, sources: list[Contact], at: int) -> Problem:
        """Return the problem of a given contact, which must match a stored one."""
        contact, fields = sources[at], self._fields
        if (stored, id(contact)) not in self._known:
            accuracy, accuracy_given, of_pressure = fields["accuracy"].tolist()
            (by_load, by_moment), (first, second) = fields["prescribed"], fields["problems"][stored]
            problem = pose_problem(
                contact, _ELEMENTS[str(fields["element"])], (bool(by_load), bool(by_moment)),
                (float(first), float(second)), None if math.isnan(accuracy) else accuracy,
                accuracy_given=bool(accuracy_given),
            )  # fmt: skip
            problem = replace(problem, pressure_accuracy=None if math.isnan(of_pressure) else of_pressure)
            part = slice(self._ends[stored] - fields["contact_sizes"][stored], self._ends[stored])
            places = fields["contact_places"][part]
            expected = _Fingerprint(places, fields["contact_surfaces"][:, part], fields["contact_numbers"][stored])
            if not _Fingerprint.of(problem, places).like(expected):
                condition = "be the contact that the cases were solved with"
                raise InputError(
                    f"contacts[{at}]" if len(set(map(id, sources))) > 1 else "contacts", contact, condition, _AS_GIVEN
                )
            self._known[stored, id(contact)] = problem
        return self._known[stored, id(contact)]


# Errors


class _SavedValue:
    """Stands for a value of which only the text shown in messages was saved."""

    def __init__(self, as_shown: str) -> None:
        self._as_shown = as_shown

    def __repr__(self) -> str:
        return self._as_shown


def _describe_error(error: Exception) -> dict[str, Any]:
    """Return an error as plain values; arguments as Python literals where these can be read back."""
    arguments = [] if isinstance(error, ConvergenceError) else [_write_argument(value) for value in error.args]
    return {"type": _name(type(error)), "arguments": arguments, "message": str(error)}


def _write_argument(value: object) -> str:
    plain = value.item() if isinstance(value, np.generic) else value
    return repr(plain) if _parse_literal(repr(plain)) is not None else shown(plain)


def _parse_literal(written: str) -> Any:
    """Return the value of a Python literal, or None if it cannot be read."""
    try:
        value = ast.literal_eval(written)
    except (ValueError, SyntaxError, MemoryError, RecursionError, TypeError):
        return None
    return value if repr(value) == written else None


def _failed_block(block: Block, described: dict[str, Any], known: dict[str, type[Exception]]) -> Block:
    """Return a block of cases without a solution, with their error."""
    error: Exception | None = None
    if block.results:  # not converged: the error holds the state reached
        try:
            outcome(block.problem.of(block.targets[0]), block.results[0])
        except ConvergenceError as again:
            error = again.with_traceback(None)
    elif described["type"] in known:
        error = _restore_error(known[described["type"]], described["arguments"])
    if error is None or str(error) != described["message"]:
        error = NonhertzError(f"{described['type'].rpartition('.')[2]}: {described['message']}")
    return Block(block.problem, block.numbers, block.targets, block.results, error)


def _restore_error(kind: type[Exception], arguments: list[str]) -> Exception | None:
    literals = [_parse_literal(node) for node in arguments]
    values = [
        _SavedValue(written) if value is None and written != "None" else value
        for value, written in zip(literals, arguments, strict=True)
    ]
    try:
        return kind(*values)
    # Whatever a class does with its arguments: the message is kept.
    except Exception:  # noqa: BLE001
        return None


def _errors_by_name() -> dict[str, type[Exception]]:
    """Return all imported error classes; none is imported because a file names it."""
    kinds, stack = {Exception}, [Exception]
    while stack:
        for kind in stack.pop().__subclasses__():
            if kind not in kinds:
                kinds.add(kind)
                stack.append(kind)
    return {_name(kind): kind for kind in kinds}


def _name(kind: type[Exception]) -> str:
    return f"{kind.__module__}.{kind.__qualname__}"
