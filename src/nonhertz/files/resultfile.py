"""Result files: from ``result.json``, of a contact or a bearing, back to the case and its solution."""

from __future__ import annotations

import errno
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import starmap, zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from nonhertz.errors import CaseError, InputError
from nonhertz.files import contact_results
from nonhertz.files.bounds import FORMAT
from nonhertz.files.casefile import Case
from nonhertz.files.folder import write_files
from nonhertz.files.toml import file_kind
from nonhertz.findings import Finding
from nonhertz.inputs.assumed import restore_assumptions
from nonhertz.inputs.files import read_bytes
from nonhertz.result.brief import HasHtml
from nonhertz.result.edges import EdgeKind, EdgePressure, SingularEnd
from nonhertz.result.outcome import Judgement
from nonhertz.result.solution import Solution
from nonhertz.result.status import ErrorEstimate, Status
from nonhertz.strip.element import ELEMENTS

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.bearing.solution import BearingSolution
    from nonhertz.files.bearingfile import BearingCase

AnyCase = TypeVar("AnyCase", "Case", "BearingCase")

LARGEST_RESULT = 200_000_000  # bytes
_WAY_OUT = "give a result.json that Result.save, the command line or the page wrote"


@dataclass(frozen=True, eq=False, repr=False)
class Result(HasHtml):
    """The contents of a result file.

    Attributes
    ----------
    case : Case or BearingCase
        The solved case; ``case.solve()`` solves it again.
    solution : Solution or BearingSolution
        The solution, to the digits with which it was written.
    rated : tuple or None
        The life of a bearing and "", or None and the reason why it has none; None if it is to be rated when written.

    Examples
    --------
    >>> import json
    >>> import tempfile
    >>> from nonhertz.files.casefile import read_case
    >>> from nonhertz.files.starting import starting_case
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_case(path)
    >>> text = Result(case, case.solve()).to_json()
    >>> json.loads(text)["status"]
    'converged'
    """

    case: Case | BearingCase
    solution: Solution | BearingSolution
    rated: tuple[BearingLife | None, str] | None = None

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.case.title!r}, {self.solution!r})"

    def to_json(self) -> str:
        """Return the text of a result file, the same as ``solve --json`` and ``bearing --json`` print.

        It includes the case, since a solution alone does not know which of its numbers were prescribed.

        Raises
        ------
        InputError
            If the case cannot be written to a file; see ``Case.write``.
        """
        return self.texts()["result.json"].rstrip("\n")

    def save(self, folder: str | Path) -> tuple[Path, ...]:
        """Write result, tables and figures into a directory, as ``nonhertz solve`` and ``nonhertz bearing`` do.

        Parameters
        ----------
        folder : str or Path
            Created if it does not exist; files of these names are replaced, all of them or none.

        Returns
        -------
        tuple of Path
            The files.

        Raises
        ------
        InputError
            If the case or the folder cannot be written.
        """
        import nonhertz  # figures are made beside files, not below them

        def draw(drafts: Path) -> None:
            films = None if isinstance(self.solution, Solution) else self.case.films(self.solution)  # type: ignore[union-attr]
            nonhertz.plot.save_all(nonhertz.plot.figures(self.solution, self.case.title, films=films), drafts)

        texts = self.texts()
        try:
            return write_files(folder, texts, draw)
        except InputError as error:
            raise error.about("folder", str(folder)) from None

    def texts(self) -> dict[str, str]:
        """Return the texts of result.json and tables, by file name; raises as `to_json`."""
        if isinstance(self.case, Case) and isinstance(self.solution, Solution):
            return contact_results.files(self.solution, self.case)
        # Imported here, like bearings below, since contacts do not need them.
        from nonhertz.bearing.solution import BearingSolution
        from nonhertz.files import bearing_results
        from nonhertz.files.bearingfile import BearingCase

        match self.case, self.solution:
            case BearingCase() as bearing, BearingSolution() as loaded:
                return bearing_results.files(loaded, bearing, *(self.rated or bearing.rated(loaded)))
        remedy = "give the result of the case's solve method"
        raise InputError("solution", type(self.solution).__name__, "be that of the case", remedy)


def read_result(path: str | Path) -> Result:
    """Return the case and the solution in a result file.

    Parameters
    ----------
    path : str or Path
        A ``result.json``, or the output of ``nonhertz solve --json`` or ``nonhertz bearing --json``.

    Returns
    -------
    Result
        Case and solution as stored; nothing is solved again.

    Raises
    ------
    InputError
        If the file cannot be read, is not a result file, or comes from a later release.

    Examples
    --------
    >>> import tempfile
    >>> from nonhertz.files.casefile import read_case
    >>> from nonhertz.files.starting import starting_case
    >>> from nonhertz.files.folder import write_files
    >>> from nonhertz.files.contact_results import files
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_case(path)
    ...     solution = case.solve()
    ...     _ = write_files(folder, files(solution, case))
    ...     found = read_result(Path(folder, "result.json"))
    >>> found.case == case, found.solution.approach == solution.approach
    (True, True)
    """
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a result file", "give a string or a Path")
    path = Path(path)
    contents = _object(path)
    if contents.get("format") != FORMAT:
        shown = contents.get("format")
        condition = f"hold a result of format {FORMAT}" + (f", not {shown!r}" if shown is not None else "")
        raise InputError("path", str(path), condition, f"{_WAY_OUT}, with this release")
    try:
        if file_kind(contents["case"]) == "bearing":
            from nonhertz.files.bearingfile import BearingCase

            bearing = _with_assumptions(BearingCase.of(contents["case"], path, files=False), contents)
            if contents.get("tolerances"):
                bearing.at_limits[str(contents["method"])] = _at_limits(contents["tolerances"])
            return Result(bearing, _bearing_solution(contents, bearing))
        case = _with_assumptions(Case.of(contents["case"], path, files=False), contents)
        return Result(case, _solution(contents, case))
    except CaseError as error:
        raise InputError("path", str(path), f"hold a case ({error.mistakes[0]})", _WAY_OUT) from None
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        reason = f"{type(error).__name__}: {error}"[:80]
        raise InputError("path", str(path), f"hold a complete solution ({reason})", _WAY_OUT) from None


def _object(path: Path) -> dict[str, Any]:
    try:
        contents = json.loads(read_bytes(path, LARGEST_RESULT))
    except (OSError, ValueError, RecursionError) as error:
        too_large = getattr(error, "errno", None) == errno.EFBIG
        reason = getattr(error, "strerror", None) or ("larger than any result" if too_large else "not JSON")
        raise InputError("path", str(path), f"be a result file ({reason.lower()})", _WAY_OUT) from None
    if not isinstance(contents, dict):
        raise InputError("path", str(path), "hold one JSON object", _WAY_OUT)
    return contents


def _solution(content: dict[str, Any], case: Case) -> Solution:
    (low, high), ends = content["edge_pressure"], content["singular_ends"]
    # Files of the first format have no kinds.
    kinds = [str(finding["kind"]) for finding in content.get("findings", ())]
    numbers: dict[str, Any] = {name: float(content[name]) for name in ("approach", "tilt", "load", "moment")}
    arrays = {name: _array(content[name]) for name in ("edges", "line_load", "element_half_width", "gap")}
    return Solution(
        contact=case.contact,
        element=ELEMENTS[content["element"]],
        status=Status[_member(content["status"])],
        stiffness=np.array(content["stiffness"], dtype=float).reshape(2, 2),
        iterations=int(content["iterations"]),
        judgement=Judgement.of(
            contact_y=tuple((float(first), float(last)) for first, last in content["contact_y"]),
            edge_pressure=(_edge(low), _edge(high)),
            singular_ends=tuple(SingularEnd(end["y"], EdgeKind[_member(end["kind"])]) for end in ends),
            peaks_at_corner=bool(content["peaks_at_corner"]),
            error_estimate=ErrorEstimate(**{name: _number(value) for name, value in content["error_estimate"].items()}),
            findings=tuple(starmap(Finding.from_text, zip_longest(map(str, content["warnings"]), kinds, fillvalue=""))),
        ),
        **numbers | arrays,
    )


def _bearing_solution(content: dict[str, Any], case: BearingCase) -> BearingSolution:
    from nonhertz.bearing.solution import BearingSolution

    bearing = case.mounted
    count = sum(row.bearing.rollers for row in bearing.rows)
    shapes: dict[str, tuple[int, ...]] = {
        "angle": (count,), **dict.fromkeys(("load", "moment", "approach", "tilt", "contact_angle"), (count, 2)),
        "each_rib_load": (count, -1), "roller_load": (count, 3), "displacement": (5,), "force": (5,),
        "stiffness": (5, 5), "edge_rollers": (-1,), "edge_stiffness": (3,),
    }  # fmt: skip
    # Null becomes NaN: the stiffness at the edge of the load zone if there is no roller.
    arrays: dict[str, Any] = {name: np.array(content[name], float).reshape(shape) for name, shape in shapes.items()}
    arrays["edge_rollers"] = arrays["edge_rollers"].astype(np.int64)
    numbers = {"residual": float(content["residual"]), "iterations": int(content["iterations"])}
    return BearingSolution(
        bearing=bearing,
        method=str(content["method"]),
        turning=case.life.turning,
        speed=case.prescribed.speed,
        **arrays | numbers,
    )


def _at_limits(tolerances: dict[str, Any]) -> list[Mapping[str, float]]:
    from nonhertz.bearing.toleranced import AT_LIMITS

    return [{name: _nan(tolerances[name][end]) for name in AT_LIMITS} for end in ("least", "greatest")]


def _edge(end: dict[str, Any]) -> EdgePressure:
    numbers = {name: value for name, value in end.items() if name not in {"kind", "converges"}}
    numbers["convention"] = Finding.from_text(str(end["convention"]))
    return EdgePressure(kind=EdgeKind[_member(end["kind"])], **numbers)


def _member(label: str) -> str:
    return label.upper().replace("-", "_")


def _number(value: float | None) -> float:
    """Return a number, infinite for null: JSON has no infinity."""
    return math.inf if value is None else float(value)


def _nan(value: float | None) -> float:
    return math.nan if value is None else float(value)


def _array(values: list[float | None]) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([_number(value) for value in values])


def _with_assumptions(case: AnyCase, contents: Mapping[str, Any]) -> AnyCase:
    """Return the case with the assumptions in the file of a result, if it lists any."""
    stored = contents.get("assumed")
    object.__setattr__(case, "stored_assumptions", None if stored is None else restore_assumptions(stored))
    return case
