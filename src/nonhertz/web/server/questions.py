"""The two pages, of a contact and of a bearing: questions about their documents, and the processes that answer.

A bearing is solved by slices while a slider is dragged, and by strips when it rests.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Final, Literal, NamedTuple

from starlette.exceptions import HTTPException

from nonhertz.bearing.section import RINGS
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.starting import BEARING_TEMPLATES, TEMPLATES, starting_bearing, starting_case
from nonhertz.model.body import BODIES
from nonhertz.web.limits import CURVE_POINTS, is_number
from nonhertz.web.server.workers import Job
from nonhertz.web.view import jobs
from nonhertz.web.view.curves import curve


class Wish(NamedTuple):
    """An entry of a request: a check of its value, the sentence on a wrong value, and its default."""

    fits: Callable[[Any], bool]
    sentence: str
    usual: Any = None


def _are_numbers(values: Any) -> bool:
    some = isinstance(values, list) and 1 <= len(values) <= CURVE_POINTS
    return some and all(type(value) in {int, float} and is_number(value) for value in values)


#: The entries of requests, by their keys.
WISHES: Final[Mapping[str, Wish]] = {
    "document": Wish(
        lambda value: isinstance(value, dict), "The request must have a document, structured like a case file."
    ),
    # The text of the file of the document, if it was read from one.
    "text": Wish(lambda value: isinstance(value, str), "The text must be that of a file.", ""),
    "stress": Wish(lambda value: isinstance(value, bool), "stress must be true or false.", False),
    "body": Wish(lambda value: value in BODIES, "body must be 'a' or 'b'.", "a"),
    "path": Wish(lambda value: isinstance(value, str), "path must be text."),
    "values": Wish(_are_numbers, f"values must be a list of 1 to {CURVE_POINTS} finite numbers."),
    "method": Wish(
        lambda value: value in (None, "slices", "strips"), "method must be 'slices' or 'strips', or be left out."
    ),
    "roller": Wish(lambda value: value is None or type(value) is int, "roller must be a whole number, or be left out."),
    "ring": Wish(lambda value: value in RINGS, "ring must be 'inner' or 'outer'."),
}


@dataclass(frozen=True)
class Question:
    """A question about a document.

    Attributes
    ----------
    job : callable
        Computes the answer from the document and the wishes.
    wishes : tuple of str
        Further entries of a request, by the keys of `WISHES`.
    whom : {"quick", "patient", "apart"}
        The processes for quick answers, the one for slow answers, or one started for the question.
    command : str
        The command to use if the answer takes longer than the page waits.
    at_once : str
        A value of the first wish for which the answer is quick; empty if there is none.
    """

    job: Job
    wishes: tuple[str, ...] = ()
    whom: Literal["quick", "patient", "apart"] = "quick"
    command: str = "solve"
    at_once: str = ""

    def read(self, request: dict[str, Any]) -> tuple[Any, ...]:
        """Return the document and the wishes of a request.

        Raises
        ------
        HTTPException
            If one of them is missing or wrong.
        """
        wishes = {name: request.get(name, WISHES[name].usual) for name in ("document", *self.wishes)}
        for name, value in wishes.items():
            if not WISHES[name].fits(value):
                raise HTTPException(400, WISHES[name].sentence)
        return tuple(wishes.values())


@dataclass(frozen=True)
class Kind:
    """A page: the kind of its documents, the questions that it answers, and how its processes start.

    Attributes
    ----------
    name : {"case", "bearing"}
        The kind of its document.
    at : str
        The common beginning of its routes.
    templates : mapping of str to str
        Templates to start from: their descriptions by name.
    template : callable
        Returns the text of a template, or of the initial one.
    questions : mapping of str to Question
        Questions by route; files to save are below ``download/``.
    quick, patient : callable
        Warm-up of the processes for quick and for slow answers.
    """

    name: Literal["case", "bearing"]
    at: str
    templates: Mapping[str, str]
    template: Callable[..., str]
    questions: Mapping[str, Question]
    quick: Job
    patient: Job


CONTACT: Final = Kind(
    "case",
    "/",
    TEMPLATES,
    starting_case,
    {
        "solve": Question(jobs.solve, ("stress", "body")),
        "strength": Question(jobs.strength, ("body",), "patient", "stress"),
        "curve": Question(curve, ("path", "values"), command="sweep"),
        "download/case.toml": Question(jobs.file, ("text",)),
        "download/report.html": Question(partial(jobs.report, kind=Case), (), "apart", "report"),
        **{
            f"download/{name}": Question(partial(jobs.written, kind=Case, name=name))
            for name in ("table.csv", "result.json")
        },
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
        "solve": Question(jobs.load, ("method", "roller"), "patient", "bearing", at_once="slices"),
        # By the process that has already solved the bearing by strips.
        "roller": Question(jobs.lines, ("method", "roller"), "patient", "bearing"),
        "contact": Question(jobs.contact, ("roller", "ring"), "patient", "bearing"),
        "catalogue": Question(jobs.catalogue, command="new"),
        "download/bearing.toml": Question(jobs.file, ("text",)),
        "download/report.html": Question(partial(jobs.report, kind=BearingCase), (), "apart", "report"),
        **{
            f"download/{name}": Question(partial(jobs.written, kind=BearingCase, name=name), (), "apart", "bearing")
            for name in ("result.json", "rollers.csv", "lines.csv")
        },
        **{
            f"download/{name}.{ending}": Question(partial(jobs.drawn, name=name, kind=ending), (), "apart", "bearing")
            for name in ("loads", "pressure", "perspective", "roller", "film", "film-along", "displacement")
            for ending in ("svg", "png")
        },
    },
    jobs.warm_up_bearing,
    jobs.warm_up_bearing,
)
