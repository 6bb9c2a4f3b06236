"""The workers' jobs: a document in, an answer or a file out, ready to send."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final, Literal, TypeVar

from nonhertz.amounts import current_units
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import CaseError, InputError
from nonhertz.files.bearing_document import PARTS, with_file_path
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.catalogue import guess_of_catalogue, guessed_document, text_of_guess
from nonhertz.files.commented import update_toml
from nonhertz.files.document import CaseBase
from nonhertz.files.resultfile import Result
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.files.toml import parse
from nonhertz.model.body import BodyName
from nonhertz.show.solving import try_solve
from nonhertz.web.limits import is_number, refuse, too_long, too_slow, unfit
from nonhertz.web.view.answers import answer, drawable
from nonhertz.web.view.bearings import bearing_answer, roller_answer, why_not_drawn
from nonhertz.web.view.replies import broken, job, misfit
from nonhertz.web.view.stresses import strength_answer, stress_answer

Method = Literal["strips", "slices"]
Document = TypeVar("Document", bound=CaseBase)

#: The bearings that this process solved last, the one on the page and pinned ones, so that choosing a roller or opening
#: a contact does not solve strips again.
_LATEST: Final[dict[str, tuple[BearingCase, BearingSolution]]] = {}
_KEPT: Final = 3
#: Inputs of a bearing by the symbols of catalogues; inputs that depend on several symbols are computed.
_STATED: Final = {"clearance": "bearing.clearance", "F": "inner.diameter", "E": "outer.diameter"}
_LONGEST_NUMBER: Final = 100  # characters
_BOUNDARY: Final = ("bearing.bore", "bearing.outside_diameter", "bearing.width", "bearing.contact_angle")


def sound(document: dict[str, Any], kind: type[Document]) -> Document:
    """Return the case or the bearing in a document; no file that it names is read.

    Raises
    ------
    CaseError
        If it is not a valid file, or exceeds the limits of the page.
    """
    refuse(unfit(document))
    # The file's own checks come first, so that errors are worded as on the command line.
    case = kind.of(document, Path(f"{kind.kind}.toml"), files=False)
    refuse(too_slow(document))
    return case


@job
def solve(document: dict[str, Any], stress: bool, body: BodyName) -> dict[str, Any]:
    """Answer with the contents of the page for a case, with the stress below the surface of a body if requested."""
    try:
        case = sound(document, Case)
        solution, complaint = try_solve(case)
    except CaseError as error:
        return misfit(error) | {"profiles": {} if unfit(document) else drawable(document.get("body"))}
    contents = answer(case, solution, complaint)
    return contents | (stress_answer(solution, body) if stress and not complaint and solution.contact_y else {})


@job
def strength(document: dict[str, Any], body: BodyName) -> dict[str, Any]:
    """Answer with whether a body of a case withstands the stress."""
    solution, complaint = try_solve(sound(document, Case))
    contents = {"checks": []} if complaint or not solution.contact_y else strength_answer(solution, body)
    return {"ok": True} | contents


@job
def load(document: dict[str, Any], method: Method | None, roller: int | None = None) -> dict[str, Any]:
    """Answer with the contents of the page for a bearing and a roller; ``method`` replaces that of the file."""
    case = sound(document, BearingCase)
    return {"file_method": case.solver.method} | bearing_answer(*_load(case, method), roller)


@job
def lines(document: dict[str, Any], method: Method | None, roller: int | None) -> dict[str, Any]:
    """Answer with loads and pressures along one roller of a bearing."""
    return {"ok": True} | roller_answer(*_load(sound(document, BearingCase), method), roller)


@job
def contact(document: dict[str, Any], roller: int, ring: str) -> dict[str, Any]:
    """Answer with the case of one contact of a bearing: of a roller, by its number from 0, with a ring."""
    case, solution = _load(sound(document, BearingCase))
    return {"ok": True, "document": as_json_has_it(case.contact_case(solution, roller, ring).document)}


def _load(case: BearingCase, method: Method | None = None) -> tuple[BearingCase, BearingSolution]:
    """Return the case with which a bearing is assessed, and its solution; the latest ones are kept.

    Raises
    ------
    CaseError, ConvergenceError
    """
    key = json.dumps([case.document, method or case.solver.method])
    if key not in _LATEST:
        try:
            solution = case.solve(method)
            if solution.method == "strips":
                solution.max_pressure  # noqa: B018  (solves the contacts, each of which may be refused)
        except InputError as error:
            raise with_file_path(error, case.document) from None
        if solution.method == "slices" and case.life.edge_stress == "pressure":
            # Slices have no pressures: unless the file says otherwise, life is by the edge stresses of the standard.
            case = replace(case, life=replace(case.life, edge_stress=None))
        while len(_LATEST) >= _KEPT:
            del _LATEST[next(iter(_LATEST))]
        _LATEST[key] = case, solution
    return _LATEST[key]


@job
def document_in(content: bytes) -> dict[str, Any]:
    """Answer with the document in the bytes of a file and its text."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return broken([("", "The file must be text in UTF-8: save it with that encoding.")])
    document = as_json_has_it(parse(text, "The file"))
    refuse(too_long(document))
    return {"ok": True, "document": document, "text": text}


@job
def catalogue(data: dict[str, Any]) -> dict[str, Any]:
    """Answer with a bearing estimated from the data in a catalogue: document, text, and the estimated values."""
    if not all(isinstance(value, str) and len(value) <= _LONGEST_NUMBER for value in data.values()):
        return broken([("", "Each entry of catalogue data must be short text, such as '44 kN'.")])
    guess = guess_of_catalogue(data)
    document = guessed_document(guess)
    stated = {*_BOUNDARY, *(path for symbol, path in _STATED.items() if symbol in data)}
    if {"F", "E"} <= data.keys():
        stated.add("roller.diameter")
    parts = {name: document[name] for name in ("bearing", *PARTS)}
    values = {path: value for path, value in _numbers(parts) if path not in stated}
    estimates = {"values": values, "sentences": guess.sentences[1:]}
    return {"ok": True, "document": document, "text": text_of_guess(guess), "estimates": estimates}


def _numbers(table: Mapping[str, Any], place: str = "") -> Iterator[tuple[str, Any]]:
    """Yield numbers, and lists of numbers, with their paths."""
    for name, value in table.items():
        if isinstance(value, Mapping):
            yield from _numbers(value, f"{place}{name}.")
        elif isinstance(value, int | float) or (isinstance(value, list) and isinstance(value[0], float)):
            yield f"{place}{name}", value


def as_json_has_it(value: Any) -> Any:
    """Return a value in which text replaces what JSON lacks: dates, non-finite numbers and huge integers."""
    if isinstance(value, dict):
        return {name: as_json_has_it(entry) for name, entry in value.items()}
    if isinstance(value, list):
        return [as_json_has_it(entry) for entry in value]
    if isinstance(value, int | float):
        return value if is_number(value) else str(value) if isinstance(value, float) else "inf"
    return value if isinstance(value, str) else str(value)


@job
def file(document: dict[str, Any], text: str) -> bytes:
    """Return a case or a bearing, which need not be solvable, as a file, with the comments of its original if any."""
    refuse(unfit(document))
    return update_toml(document, text).encode()


@job
def written(document: dict[str, Any], kind: type[Case | BearingCase], name: str) -> bytes:
    """Return one of the files that commands write."""
    case = sound(document, kind)
    result = Result(*_load(case)) if isinstance(case, BearingCase) else Result(case, try_solve(case)[0])
    return result.texts()[name].encode()


@job
def drawn(document: dict[str, Any], name: str, kind: Literal["svg", "png"]) -> bytes | dict[str, Any]:
    """Return a figure of a bearing as a file."""
    from nonhertz.plot.finished import bearing_figures
    from nonhertz.plot.sheets import image

    case, solution = _load(sound(document, BearingCase))
    figures = bearing_figures(solution, case.title, films=case.films(solution))
    if name not in figures:
        return broken([("", why_not_drawn(name, solution))])
    return image(figures[name], kind)


@job
def report(document: dict[str, Any], kind: type[Case | BearingCase]) -> bytes:
    """Return the report on a case, or on a bearing, which must have a solution."""
    from nonhertz.report import compose

    case = sound(document, kind)
    solved = _load(case)[0] if isinstance(case, BearingCase) else case
    return compose([solved], title_block=case.title_block.dated(), units=current_units().code).encode()


def warm_up() -> None:
    """Solve the starting case with stresses, so that everything is loaded."""
    # With a unit, so that the units library, which takes a second, is loaded too.
    solve(parse(starting_case(), "case.toml") | {"load": {"load": "20 kN"}}, True, "a")


def warm_up_bearing() -> None:
    """Solve the starting bearing by slices, so that everything is loaded."""
    load(parse(starting_bearing(), "bearing.toml"), "slices")


def step_back() -> None:
    """Give way to the processes that answer a drag; modules are loaded with the first case."""
    if hasattr(os, "nice"):  # Windows has none
        os.nice(10)
