"""The two pages, of a contact and of a bearing: what can be asked of their documents, and who works it out.

A bearing is solved by slices while a slider is dragged, and by strips when it rests.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

from nonhertz.bearing.section import RINGS
from nonhertz.files.bearingfile import BEARING_TEMPLATES, starting_bearing
from nonhertz.files.casefile import TEMPLATES, starting_case
from nonhertz.model.body import BODIES, BodyName
from nonhertz.web.form.fields import is_number
from nonhertz.web.limits import CURVE_POINTS
from nonhertz.web.server.intake import RefusedError
from nonhertz.web.server.workers import Job
from nonhertz.web.view import jobs
from nonhertz.web.view.curves import curve

Asked = dict[str, Any]
Whom = Literal["quick", "patient", "apart"]


@dataclass(frozen=True)
class Question:
    """What can be asked of a document.

    Attributes
    ----------
    job : callable
        Works out the answer from the document and the wishes.
    wishes : callable
        What else a request must say, as arguments of the job; raises `RefusedError`.
    whom : {"quick", "patient", "apart"}
        The processes that answer at once, the one that may take long, or one started for it.
    command : str
        That to use where it takes longer than the page waits.
    at_once : tuple or None
        Wishes that are quick to answer all the same.
    """

    job: Job
    wishes: Callable[[Asked], tuple[Any, ...]] = lambda asked: ()
    whom: Whom = "quick"
    command: str = "solve"
    at_once: tuple[Any, ...] | None = None


@dataclass(frozen=True)
class File:
    """A file made from a document.

    Attributes
    ----------
    made : Question
        Who makes it.
    kind : str
        Its content type.
    suffix : str
        Of its name, after the title.
    """

    made: Question
    kind: str
    suffix: str = ""


@dataclass(frozen=True)
class Kind:
    """A page: of which files it is, what it can be asked, and how its processes begin.

    Attributes
    ----------
    name : {"case", "bearing"}
        What its document is.
    at : str
        Where its routes are.
    templates : mapping of str to str
        What to begin with, in words by their names.
    template : callable
        Returns the text of one of them, or of the one to start with.
    questions, files : mapping
        What can be asked, and the files that can be made, by name.
    quick, patient : callable
        What the processes begin with.
    """

    name: Literal["case", "bearing"]
    at: str
    templates: Mapping[str, str]
    template: Callable[..., str]
    questions: dict[str, Question]
    files: dict[str, File]
    quick: Job
    patient: Job


def _body(asked: Asked) -> tuple[BodyName]:
    body = asked.get("body", "a")
    if not isinstance(body, str) or body not in BODIES:
        raise RefusedError(400, "body must be 'a' or 'b'.")
    return (body,)


def _stress_in_body(asked: Asked) -> tuple[bool, BodyName]:
    stress = asked.get("stress", False)
    if not isinstance(stress, bool):
        raise RefusedError(400, "stress must be true or false.")
    return stress, *_body(asked)


def _path_and_values(asked: Asked) -> tuple[str, list[float]]:
    path, values = asked.get("path"), asked.get("values")
    if not isinstance(path, str) or not isinstance(values, list) or not 1 <= len(values) <= CURVE_POINTS:
        raise RefusedError(400, f"path must be text, and values a list of 1 to {CURVE_POINTS} numbers.")
    if not all(type(each) in {int, float} and is_number(each) for each in values):
        raise RefusedError(400, "values must be finite numbers.")
    return path, values


def _method(asked: Asked) -> tuple[str | None]:
    method = asked.get("method")
    if not (method is None or method == "slices" or method == "strips"):  # noqa: PLR1714  (a list is in no set)
        raise RefusedError(400, "method must be 'slices' or 'strips', or be left out.")
    return (method,)


def _roller_and_ring(asked: Asked) -> tuple[int, str]:
    roller, ring = asked.get("roller"), asked.get("ring")
    if type(roller) is not int or not isinstance(ring, str) or ring not in RINGS:
        raise RefusedError(400, "roller must be a whole number, and ring 'inner' or 'outer'.")
    return roller, ring


def _text(asked: Asked) -> tuple[str]:
    """Return the text of the file that the document was read from; empty if there is none."""
    text = asked.get("text", "")
    if not isinstance(text, str):
        raise RefusedError(400, "The text must be that of a file.")
    return (text,)


def _made(job: Job, *wishes: str, whom: Whom = "apart", command: str = "report") -> Question:
    return Question(job, lambda asked: wishes, whom, command)


CONTACT: Final = Kind(
    "case",
    "/",
    TEMPLATES,
    starting_case,
    {
        "solve": Question(jobs.solve, _stress_in_body),
        "strength": Question(jobs.strength, _body, "patient", "stress"),
        "curve": Question(curve, _path_and_values, command="sweep"),
    },
    {
        "case.toml": File(Question(jobs.file, _text), "application/toml"),
        "table.csv": File(_made(jobs.written, "case", "table.csv", whom="quick", command="solve"), "text/csv"),
        "result.json": File(
            _made(jobs.written, "case", "result.json", whom="quick", command="solve"), "application/json"
        ),
        "report.html": File(_made(jobs.report, "case"), "text/html"),
    },
    jobs.warm_up,
    jobs.step_back,
)
BEARING: Final = Kind(
    "bearing",
    "/bearing/",
    BEARING_TEMPLATES,
    starting_bearing,
    {
        "solve": Question(jobs.load, _method, "patient", "bearing", at_once=("slices",)),
        # By the process that has solved it by strips already.
        "contact": Question(jobs.contact, _roller_and_ring, "patient", "bearing"),
    },
    {
        "bearing.toml": File(Question(jobs.file, _text), "application/toml"),
        "report.html": File(_made(jobs.report, "bearing"), "text/html"),
        **{
            name: File(_made(jobs.written, "bearing", name, command="bearing"), kind, f"-{name.partition('.')[0]}")
            for name, kind in (
                ("result.json", "application/json"),
                *((name, "text/csv") for name in ("rollers.csv", "lines.csv")),
            )
        },
        **{
            f"{name}.{ending}": File(_made(jobs.drawn, name, ending, command="bearing"), kind, f"-{name}")
            for name in ("loads", "pressure", "roller", "displacement")
            for ending, kind in (("svg", "image/svg+xml"), ("png", "image/png"))
        },
    },
    jobs.warm_up_bearing,
    jobs.warm_up_bearing,
)
