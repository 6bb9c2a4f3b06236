"""The routes of a page: its HTML, the data of its form, and the answers to questions about a document."""

from __future__ import annotations

import time
from collections.abc import Awaitable, Callable
from functools import partial
from typing import Any, Final

import anyio
import jinja2
from anyio.abc import TaskGroup
from markupsafe import Markup
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from nonhertz import __version__
from nonhertz.errors import CaseError
from nonhertz.files.toml import parse
from nonhertz.web.form.catalogue import catalogue_form
from nonhertz.web.form.ranges import ENDS, form_state
from nonhertz.web.form.schema import form_schema
from nonhertz.web.form.units import units_of_fields
from nonhertz.web.limits import (
    ANSWER_SECONDS,
    DOCUMENT_BYTES,
    GRACE_SECONDS,
    REPORT_SECONDS,
    STRIPS,
    UPLOAD_BYTES,
    refuse,
    too_long,
)
from nonhertz.web.server.intake import as_attachment, content, in_script, json_object
from nonhertz.web.server.questions import Kind, Question
from nonhertz.web.server.workers import Job, TooSlowError, Workers
from nonhertz.web.view.replies import Refusal, as_bytes, broken, misfit, reply

_LISTENING: Final = 0.1  # s between checks that the browser still waits
#: Content types of files to save, by the endings of their names.
_TYPES: Final = {
    **{ending: f"text/{ending}" for ending in ("csv", "html")},
    **{ending: f"application/{ending}" for ending in ("toml", "json")},
    **{"svg": "image/svg+xml", "png": "image/png"},
}


class Page:
    """One of the two pages, with its processes.

    Parameters
    ----------
    kind : Kind
        Single contacts or bearings.
    document, text
        The initial document, and the text of its file, for its comments.
    workers : int
        Number of processes for quick answers.
    templates : jinja2.Environment
        The templates of the pages.
    """

    def __init__(
        self, kind: Kind, document: dict[str, Any], text: str, workers: int, templates: jinja2.Environment
    ) -> None:
        self.kind, self.document, self.text, self.templates = kind, document, text, templates
        self.quick = Workers(workers, kind.quick)
        # If strips are solved at every rest of a slider, their process must be ready; otherwise it is started when
        # needed.
        ready = kind.patient is kind.quick
        self.patient = Workers(min(workers, 1) if ready else 1, kind.patient, eager=ready)
        self.processes = (self.quick, self.patient)

    def start(self, tasks: TaskGroup, *, at_once: bool) -> None:
        """Start the processes, at once or when the page is opened."""
        for process in self.processes:
            process.start(tasks, at_once=at_once and process.eager)

    def end(self) -> None:
        """Kill all processes."""
        for process in self.processes:
            process.end()

    async def page(self, request: Request) -> Response:
        """Answer with the page."""
        for process in self.processes:
            if process.eager:
                process.wake()
        limits = {"upload_bytes": UPLOAD_BYTES, "document_bytes": DOCUMENT_BYTES, "strips": STRIPS}
        start = {"document": self.document, "text": self.text, "version": __version__, "limits": limits}
        form = {"schema": form_schema(self.kind.name), "units": units_of_fields(), "lists": ENDS}
        form |= {"state": form_state(self.document, self.kind.name), "catalogue": catalogue_form()}
        whole = self.templates.get_template(f"{self.kind.name}.html").render(
            start=Markup(in_script(start | {"form": form})),
            version=__version__,
            title=str(self.document.get("title", "")),
            templates=self.kind.templates,
        )
        return HTMLResponse(whole)

    async def form(self, request: Request) -> Response:
        """Answer with the parts of a form that depend on the geometry of its document."""
        (document,) = Question(form_state).read(await _question_of(request))
        try:
            refuse(too_long(document))
        except CaseError as error:
            return reply(misfit(error), 422)
        return reply(await anyio.to_thread.run_sync(form_state, document, self.kind.name))

    def answering(self, route: str, question: Question) -> Callable[[Request], Awaitable[Response]]:
        """Return the handler of a question about a document; it answers with a file if the route ends in its name."""

        async def answer(request: Request) -> Response:
            document, *wishes = question.read(await _question_of(request))
            whom = "quick" if question.at_once and wishes[0] == question.at_once else question.whom
            run, seconds = {
                "quick": (self.quick.run, ANSWER_SECONDS),
                "patient": (self.patient.run, ANSWER_SECONDS),
                "apart": (self.quick.run_apart, REPORT_SECONDS),
            }[whom]
            work = partial(run, question.job, document, *wishes, seconds=seconds)
            made = await while_awaited(request, work, question.command, 0.0 if whom == "patient" else GRACE_SECONDS)
            name = route.removeprefix("download/")
            if name == route or made is None:
                return _response(made)
            if isinstance(made, Refusal):
                return Response(made, 422, media_type="application/json")
            return Response(made, headers=as_attachment(name, document), media_type=_TYPES[name.partition(".")[2]])

        return answer

    async def read(self, request: Request, kind: str, most: int, command: str, job: Job, *wishes: Any) -> Response:
        """Answer with the result of a job on an uploaded file of content type ``kind`` and at most ``most`` bytes."""
        work = partial(self.quick.run, job, await content(request, kind, most), *wishes, seconds=ANSWER_SECONDS)
        return _response(await while_awaited(request, work, command))

    async def template(self, request: Request) -> Response:
        """Answer with the document of a template, and its text."""
        name = request.path_params["name"]
        if name not in self.kind.templates:
            raise HTTPException(404)
        text = self.kind.template(name)
        return reply({"ok": True, "document": parse(text, name), "text": text})

    async def status(self, request: Request) -> Response:
        """Answer whether the processes are ready."""
        return reply({"ready": self.quick.ready.is_set()})

    def routes(self) -> list[Route]:
        """Return the routes of the page, except its own address."""
        at = self.kind.at
        return [
            Route(f"{at}status", self.status),
            Route(f"{at}form", self.form, methods=["POST"]),
            Route(f"{at}template/{{name}}", self.template),
            *(
                Route(f"{at}{route}", self.answering(route, question), methods=["POST"])
                for route, question in self.kind.questions.items()
            ),
        ]


async def while_awaited(
    request: Request, work: Callable[[], Awaitable[bytes]], command: str, grace: float = GRACE_SECONDS
) -> bytes | None:
    """Return the result of a job while the browser waits for it; if it has gone, end the job and return None.

    Parameters
    ----------
    request : Request
        The request to answer.
    work : callable
        Runs the job.
    command : str
        The command named in the error if the job takes too long.
    grace : float
        Time that a job which nobody waits for may go on [s]: starting another process costs more than most answers.
    """
    made: bytes | None = None
    failure: Exception | None = None

    async def watch() -> None:
        until = time.monotonic() + grace
        while not await request.is_disconnected() or time.monotonic() < until:
            await anyio.sleep(_LISTENING)
        tasks.cancel_scope.cancel()

    async with anyio.create_task_group() as tasks:
        tasks.start_soon(watch)
        try:
            made = await work()
        except TooSlowError:
            sentence = f"This takes longer than the page waits: use 'nonhertz {command}'."
            made = Refusal(as_bytes(broken([("", sentence)]) | {"slow": True}))
        except Exception as error:  # noqa: BLE001  (raised below, not as one of a group)
            failure = error
        tasks.cancel_scope.cancel()
    if failure is not None:
        raise failure
    return made


async def _question_of(request: Request) -> dict[str, Any]:
    return json_object(await content(request, "application/json", DOCUMENT_BYTES))


def _response(made: bytes | None) -> Response:
    return Response(status_code=204) if made is None else Response(made, media_type="application/json")
