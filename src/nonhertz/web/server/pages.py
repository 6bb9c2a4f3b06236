"""The routes of a page: its HTML, its form, and the answers to what is asked of a document."""

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
from nonhertz.files.held import parsed
from nonhertz.web.form.form import form
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
from nonhertz.web.server.intake import as_attachment, content, document_in, in_script, json_object
from nonhertz.web.server.questions import Kind, Question
from nonhertz.web.server.workers import TooSlowError, Workers
from nonhertz.web.view.replies import Refusal, as_bytes, broken, misfit, reply

_LISTENING: Final = 0.1  # s between looks whether the browser still waits


class Page:
    """One of the two pages, with its processes.

    Parameters
    ----------
    kind : Kind
        Which.
    document, text
        What it starts with, and the file that this was read from, for its comments.
    workers : int
        Number of processes that answer at once.
    templates : jinja2.Environment
        Those of the pages.
    """

    def __init__(
        self, kind: Kind, document: dict[str, Any], text: str, workers: int, templates: jinja2.Environment
    ) -> None:
        self.kind, self.document, self.text, self.templates = kind, document, text, templates
        self.quick = Workers(workers, kind.quick)
        # Where strips are waited for at every rest of a slider, the process is ready for them; else it is started late.
        ready = kind.patient is kind.quick
        self.patient = Workers(min(workers, 1) if ready else 1, kind.patient, waiting=ANSWER_SECONDS, eager=ready)

    def start(self, tasks: TaskGroup, *, at_once: bool) -> None:
        """Start the processes, at once or when the page is opened."""
        self.quick.start(tasks, at_once=at_once)
        self.patient.start(tasks, at_once=at_once and self.patient.eager)

    def end(self) -> None:
        """Kill all processes."""
        self.quick.end()
        self.patient.end()

    async def page(self, request: Request) -> Response:
        """Answer with the page."""
        self.quick.wake()
        if self.patient.eager:
            self.patient.wake()
        limits = {"upload_bytes": UPLOAD_BYTES, "document_bytes": DOCUMENT_BYTES, "strips": STRIPS}
        start = {"document": self.document, "text": self.text, "version": __version__, "limits": limits}
        whole = self.templates.get_template(f"{self.kind.name}.html").render(
            start=Markup(in_script(start)),
            version=__version__,
            title=str(self.document.get("title", "")),
            form=Markup(self._form_of(self.document)),
            templates=self.kind.templates,
        )
        return HTMLResponse(whole)

    async def form(self, request: Request) -> Response:
        """Answer with the form of a document."""
        document = document_in(await _asked(request))
        try:
            refuse(too_long(document))
        except CaseError as error:
            return reply(misfit(error), 422)
        return HTMLResponse(await anyio.to_thread.run_sync(self._form_of, document))

    def _form_of(self, document: dict[str, Any]) -> str:
        return self.templates.get_template("form.html").render(form=form(document, self.kind.name))

    async def answer(self, request: Request) -> Response:
        """Answer a question about a document."""
        made = await self._made(request, self.kind.questions[_last(request)], await _asked(request))
        return Response(status_code=204) if made is None else Response(made, media_type="application/json")

    async def download(self, request: Request) -> Response:
        """Answer with a file made from a document."""
        name, asked = _last(request), await _asked(request)
        file = self.kind.files[name]
        made = await self._made(request, file.made, asked)
        if made is None:
            return Response(status_code=204)
        if isinstance(made, Refusal):
            return Response(made, 422, media_type="application/json")
        return Response(made, headers=as_attachment(name, document_in(asked), file.suffix), media_type=file.kind)

    async def _made(self, request: Request, question: Question, asked: dict[str, Any]) -> bytes | None:
        """Return what a job makes, a sentence where that takes too long, None if nobody waits for it any more."""
        wishes = question.wishes(asked)
        whom = "quick" if wishes == question.at_once else question.whom
        run, seconds = {
            "quick": (self.quick.run, ANSWER_SECONDS),
            "patient": (self.patient.run, ANSWER_SECONDS),
            "apart": (self.quick.run_apart, REPORT_SECONDS),
        }[whom]
        work = partial(run, question.job, document_in(asked), *wishes, seconds=seconds)
        return await while_awaited(request, work, question.command, 0.0 if whom == "patient" else GRACE_SECONDS)

    async def template(self, request: Request) -> Response:
        """Answer with the document of a template, and its text."""
        name = request.path_params["name"]
        if name not in self.kind.templates:
            raise HTTPException(404)
        text = self.kind.template(name)
        return reply({"ok": True, "document": parsed(text, name), "text": text})

    async def status(self, request: Request) -> Response:
        """Answer whether the processes are ready, and whether one of them compiles the solver."""
        compiling = self.quick.compiling or self.patient.compiling
        return reply({"ready": self.quick.ready.is_set(), "compiling": compiling})

    def routes(self) -> list[Route]:
        """Return the routes of the page, but for its own address."""
        at = self.kind.at
        return [
            Route(f"{at}status", self.status),
            Route(f"{at}form", self.form, methods=["POST"]),
            Route(f"{at}template/{{name}}", self.template),
            *(Route(f"{at}{name}", self.answer, methods=["POST"]) for name in self.kind.questions),
            *(Route(f"{at}download/{name}", self.download, methods=["POST"]) for name in self.kind.files),
        ]


async def while_awaited(
    request: Request, work: Callable[[], Awaitable[bytes]], command: str, grace: float = GRACE_SECONDS
) -> bytes | None:
    """Return what a job makes for as long as the browser waits for it, None if it has gone: the job is ended then.

    Parameters
    ----------
    request : Request
        Whose sender waits.
    work : callable
        Does the job.
    command : str
        The one to use where it takes too long, which a sentence says.
    grace : float
        For how long a job that nobody waits for may go on [s]: to start another process costs more than most answers.
    """
    until = time.monotonic() + grace
    outcome: list[bytes | Exception] = []
    async with anyio.create_task_group() as tasks:

        async def attempt() -> None:
            try:
                outcome.append(await work())
            except TooSlowError:
                sentence = f"This takes longer than the page waits: use 'nonhertz {command}'."
                outcome.append(Refusal(as_bytes(broken([("", sentence)]) | {"slow": True})))
            except Exception as error:  # noqa: BLE001  (raised below, not as one of a group)
                outcome.append(error)
            tasks.cancel_scope.cancel()

        tasks.start_soon(attempt)
        while not await request.is_disconnected() or time.monotonic() < until:
            await anyio.sleep(_LISTENING)
        tasks.cancel_scope.cancel()
    for found in outcome:
        if isinstance(found, Exception):
            raise found
        return found
    return None


async def _asked(request: Request) -> dict[str, Any]:
    return json_object(await content(request, "application/json", DOCUMENT_BYTES))


def _last(request: Request) -> str:
    return request.url.path.rpartition("/")[2]
