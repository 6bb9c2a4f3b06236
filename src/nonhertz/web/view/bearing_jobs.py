"""The workers' jobs for bearings: a document in, an answer out, ready to send."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, Final, Literal

from nonhertz.amounts import chosen
from nonhertz.bearing.solution import BearingSolution
from nonhertz.errors import CaseError, ConvergenceError, InputError
from nonhertz.files.bearing_results import files
from nonhertz.files.bearingfile import BearingCase, placed, starting_bearing
from nonhertz.files.held import parsed
from nonhertz.files.mistakes import case_error
from nonhertz.web.limits import slow_bearing, unfit
from nonhertz.web.view.bearings import bearing_answer, nothing_drawn
from nonhertz.web.view.jobs import as_json_has_it, calmly
from nonhertz.web.view.replies import as_bytes, broken, misfit

Method = Literal["strips", "slices"]

PATH: Final = Path("bearing.toml")
#: The bearing that this process solved last: whoever opens one of its contacts need not wait for strips again.
_LATEST: Final[dict[str, tuple[BearingCase, BearingSolution]]] = {}


def solve(document: dict[str, Any], method: Method | None) -> bytes:
    """Return the answer to a bearing as JSON: what the page shows of it, or its mistakes with their places.

    Parameters
    ----------
    document : dict
        The bearing.
    method : {"strips", "slices"} or None
        In place of that of the file.
    """
    begun = time.perf_counter()
    with calmly():
        try:
            case = sound(document)
            found = {"file_method": case.solver.get("method", "strips")} | bearing_answer(*_solved(case, method))
        except CaseError as error:
            return as_bytes(misfit(error))
        except ConvergenceError as error:
            return as_bytes(broken([("load", str(error))]))
    found["ms"] = round(1e3 * (time.perf_counter() - begun), 1)
    return as_bytes(found)


def contact(document: dict[str, Any], roller: int, ring: str) -> bytes:
    """Return the case of one contact of a bearing as JSON, or what is wrong with the bearing or the choice.

    Parameters
    ----------
    document : dict
        The bearing, solved by the method that it says.
    roller : int
        Its number, from 0.
    ring : str
        ``"inner"`` or ``"outer"``.
    """
    with calmly():
        try:
            case, solution = _solved(sound(document), None)
            found = case.contact_case(solution, roller, ring).document
        except CaseError as error:
            return as_bytes(misfit(error))
        except (ConvergenceError, InputError) as error:
            return as_bytes(broken([("", str(error))]))
    return as_bytes({"ok": True, "document": as_json_has_it(found)})


def sound(document: dict[str, Any]) -> BearingCase:
    """Return the bearing in a document; no file that it names is read.

    Raises
    ------
    CaseError
        If it is not a valid bearing file, or exceeds the limits of the page.
    """
    _refuse(unfit(document))
    case = BearingCase.of(document, PATH, files=False)
    _refuse(slow_bearing(document))
    return case


def _solved(case: BearingCase, method: Method | None) -> tuple[BearingCase, BearingSolution]:
    """Return a bearing, loaded, and the case to assess it with; the latest is kept.

    Raises
    ------
    CaseError, ConvergenceError
    """
    key = json.dumps([case.document, method or case.solver.get("method", "strips")])
    if key not in _LATEST:
        found = _newly_solved(case, method)
        _LATEST.clear()
        _LATEST[key] = found
    return _LATEST[key]


def _newly_solved(case: BearingCase, method: Method | None) -> tuple[BearingCase, BearingSolution]:
    try:
        solution = case.solve(method)
        if solution.method == "strips":
            solution.max_pressure  # noqa: B018  (solves the contacts, each of which may be refused)
    except InputError as error:
        raise placed(error) from None
    if solution.method == "slices" and case.life.get("edge_stress") == "pressure":
        # They have no pressures: without the word, life is that of the standard's edges.
        case = replace(case, life={name: each for name, each in case.life.items() if name != "edge_stress"})
    return case, solution


def _refuse(mistakes: list[Any]) -> None:
    if mistakes:
        raise case_error(mistakes)


def report(document: dict[str, Any]) -> bytes | dict[str, Any]:
    """Return the report on a bearing, or what is wrong with it."""
    from nonhertz.report import compose

    return _made(document, lambda case, _: compose([case], units=chosen().code).encode())


def table(document: dict[str, Any], name: str) -> bytes | dict[str, Any]:
    """Return one of the files that `nonhertz bearing` writes, or what is wrong with a document."""

    def make(case: BearingCase, solution: BearingSolution) -> bytes:
        life, reason = case.rated(solution)
        return files(solution, case, life, reason, solution.findings)[name].encode()

    return _made(document, make)


def drawn(document: dict[str, Any], name: str, kind: Literal["svg", "png"]) -> bytes | dict[str, Any]:
    """Return a figure of a bearing as a file, or what is wrong with a document."""
    from nonhertz.plot.bearing.sheets import bearing_figures
    from nonhertz.plot.sheets import image
    from nonhertz.plot.units import rewrite_units

    def make(case: BearingCase, solution: BearingSolution) -> bytes | dict[str, Any]:
        figures = bearing_figures(solution, case.title)
        if name not in figures:
            return broken([("", nothing_drawn(name, solution))])
        rewrite_units(figures[name])
        return image(figures[name], kind)

    return _made(document, make)


def _made(
    document: dict[str, Any], make: Callable[[BearingCase, BearingSolution], bytes | dict[str, Any]]
) -> bytes | dict[str, Any]:
    with calmly():
        try:
            return make(*_solved(sound(document), None))
        except CaseError as error:
            return misfit(error)
        except ConvergenceError as error:
            return broken([("load", str(error))])


def warm_up() -> None:
    """Solve the starting bearing by slices, so that everything is loaded."""
    solve(parsed(starting_bearing(), PATH.name), "slices")
