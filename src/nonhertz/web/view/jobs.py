"""The workers' jobs: a document in, an answer out, ready to send."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz.amounts import chosen
from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case, starting_case
from nonhertz.files.commented import as_toml_like
from nonhertz.files.held import parsed
from nonhertz.files.mistakes import Mistake, case_error
from nonhertz.files.results import as_json, as_table
from nonhertz.model.body import BodyName
from nonhertz.result.solution import Solution
from nonhertz.show.analysis import attempted
from nonhertz.web.form.fields import is_number
from nonhertz.web.limits import oversizes, slow, unfit
from nonhertz.web.view.answers import answer, drawable
from nonhertz.web.view.replies import as_bytes, broken, excess, misfit
from nonhertz.web.view.stresses import strength_answer, stress_answer
from nonhertz.web.view.uploads import answer_to_file

PATH = Path("case.toml")


def solve(document: dict[str, Any], stress: bool, body: BodyName) -> bytes:
    """Return the answer to a case as JSON: what the page shows of it, or its mistakes with their places.

    Parameters
    ----------
    document : dict
        The case.
    stress : bool
        Whether to include the stress below the surface.
    body : {"a", "b"}
        In which body.
    """
    begun = time.perf_counter()
    with calmly():
        try:
            case, solution, complaint = worked_out(document)
        except CaseError as error:
            return as_bytes(misfit(error) | {"profiles": _profiles(document)})
        found = answer(case, solution, complaint)
        if stress and not complaint and solution.contact_y:
            found |= stress_answer(solution, body)
    found["ms"] = round(1e3 * (time.perf_counter() - begun), 1)
    return as_bytes(found)


def strength(document: dict[str, Any], body: BodyName) -> bytes:
    """Return whether a body of a case bears it as JSON, or what is wrong with the case.

    Parameters
    ----------
    document : dict
        The case.
    body : {"a", "b"}
        Which body.
    """
    with calmly():
        try:
            _, solution, complaint = worked_out(document)
        except CaseError as error:
            return as_bytes(misfit(error))
        found = {"checks": []} if complaint or not solution.contact_y else strength_answer(solution, body)
    return as_bytes({"ok": True} | found)


def worked_out(document: dict[str, Any]) -> tuple[Case, Solution, str]:
    """Return the case in a document, its solution, and why the solver stopped short, if it did.

    Raises
    ------
    CaseError
        With every mistake at its place, if the document is not a valid case.
    """
    case = sound(document)
    return case, *attempted(case)


def document_in(content: bytes) -> bytes:
    """Return the answer to the bytes of a case file as JSON: its document, or what is wrong with the file."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return as_bytes(broken([("", "The file must be text in UTF-8: save it with that encoding.")]))
    try:
        document = parsed(text, "The file")
    except CaseError as error:
        return as_bytes(misfit(error))
    document = as_json_has_it(document)
    too_large = oversizes(document)
    return as_bytes(excess(too_large) if too_large else {"ok": True, "document": document, "text": text})


def as_json_has_it(value: Any) -> Any:
    """Return a value with what TOML has but JSON lacks as text: dates, non-finite numbers and huge integers."""
    if isinstance(value, dict):
        return {name: as_json_has_it(entry) for name, entry in value.items()}
    if isinstance(value, list):
        return [as_json_has_it(entry) for entry in value]
    if isinstance(value, int | float):
        return value if is_number(value) else str(value) if isinstance(value, float) else "inf"
    return value if isinstance(value, str) else str(value)


def file(document: dict[str, Any], text: str) -> bytes | dict[str, Any]:
    """Return a document as the text of a file, or what is wrong with it; it need not be solvable.

    Parameters
    ----------
    document : dict
        A case, or a bearing.
    text : str
        Of the file that it was read from, with its comments; it may be empty.
    """
    try:
        _refuse(unfit(document))
    except CaseError as error:
        return misfit(error)
    return as_toml_like(document, text).encode()


def table(document: dict[str, Any]) -> bytes | dict[str, Any]:
    """Return the numbers along the contact as CSV, or what is wrong with a document."""
    return _made(document, lambda case, solution: as_table(solution))


def result(document: dict[str, Any]) -> bytes | dict[str, Any]:
    """Return all numbers of a solution as JSON, or what is wrong with a document."""
    return _made(document, lambda case, solution: as_json(solution, case) + "\n")


def _made(document: dict[str, Any], make: Callable[[Case, Solution], str]) -> bytes | dict[str, Any]:
    with calmly():
        try:
            case, solution, _ = worked_out(document)
        except CaseError as error:
            return misfit(error)
        return make(case, solution).encode()


def report(document: dict[str, Any]) -> bytes | dict[str, Any]:
    """Return the report on a document, or what is wrong with it."""
    from nonhertz.report import compose

    with calmly():
        try:
            return compose([sound(document)], units=chosen().code).encode()
        except CaseError as error:
            return misfit(error)


def upload(content: bytes, name: str, options: dict[str, str]) -> bytes:
    """Return the answer to a measured file; see `nonhertz.web.view.uploads.answer_to_file`."""
    with calmly():
        return answer_to_file(content, name, options)


def sound(document: dict[str, Any]) -> Case:
    """Return the case in a document.

    Raises
    ------
    CaseError
        If it is not a valid case, or exceeds the limits of the page.
    """
    _refuse(unfit(document))
    # The case file's own checks come first, so that what they reject is worded as on the command line.
    case = Case.of(document, PATH, files=False)
    _refuse(slow(document))
    return case


def _refuse(mistakes: list[Mistake]) -> None:
    if mistakes:
        raise case_error(mistakes)


def _profiles(document: dict[str, Any]) -> dict[str, Any]:
    return {} if unfit(document) else drawable(document.get("body"))


def warm_up() -> None:
    """Solve the starting case with stresses, so that everything is loaded and compiled."""
    # With a unit, so that the units library, which takes a second, is loaded too.
    solve(parsed(starting_case(), PATH.name) | {"load": {"load": "20 kN"}}, True, "a")


def step_back() -> None:
    """Leave the processor to whoever answers a drag; what is needed is loaded with the first case."""
    if hasattr(os, "nice"):  # Windows has none
        os.nice(10)


@contextmanager
def calmly() -> Iterator[None]:
    """Keep warnings, such as those about overflow, off the terminal: the answer shows their effect."""
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        yield
