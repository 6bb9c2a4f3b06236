"""HTTP routes of the page."""

from __future__ import annotations

import contextlib
from collections.abc import AsyncIterator
from importlib import resources
from typing import Any, Final

import anyio
import jinja2
from anyio.abc import TaskGroup
from markupsafe import Markup
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from nonhertz.amounts import US
from nonhertz.files.bearingfile import starting_bearing
from nonhertz.files.casefile import TEMPLATES, starting_case
from nonhertz.files.held import meant_as, parsed
from nonhertz.model.body import BODIES, BodyName
from nonhertz.web.form.fields import is_number
from nonhertz.web.limits import (
    CURVE_POINTS,
    DOCUMENT_BYTES,
    LIVE_SECONDS,
    PATIENT_SECONDS,
    STRENGTH_SECONDS,
    UPLOAD_BYTES,
    UPLOAD_SECONDS,
)
from nonhertz.web.server.awaiting import while_awaited
from nonhertz.web.server.bearings import BearingPage
from nonhertz.web.server.documents import as_attachment, document_in, in_script, text_in
from nonhertz.web.server.forms import form_answer, page_text
from nonhertz.web.server.guard import Guard
from nonhertz.web.server.intake import RefusedError, content, json_object
from nonhertz.web.server.units import InUnits
from nonhertz.web.server.workers import EndedError, FailedError, TooSlowError, Workers
from nonhertz.web.view import jobs
from nonhertz.web.view.curves import curve
from nonhertz.web.view.replies import broken, refusal, reply

_TYPES: Final = {".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml", ".html": "text/html"}
_DOWNLOADS: Final = {
    "case.toml": "application/toml",
    "table.csv": "text/csv",
    "result.json": "application/json",
    "report.html": "text/html",
}
_LONG_FILE: Final = "This file takes longer than the page waits: prepare it with 'nonhertz profile'."
_LONG_SEARCH: Final = "The search for the largest stresses takes longer than the page waits: use 'nonhertz stress'."
_SENTENCES: Final = {
    404: "There is nothing at this address.",
    405: "This address does not accept this method.",
}


class Page:
    """What the routes share: the workers, the templates, and the case that the page starts with.

    Parameters
    ----------
    document : dict
        The case or the bearing to start with.
    workers : int
        Number of processes that solve.
    text : str
        The file that it was read from, for its comments.
    """

    def __init__(self, document: dict[str, Any], workers: int, text: str = "") -> None:
        self.begins_with_bearing = meant_as(document) == "bearing"
        # The other page starts with what 'nonhertz new' writes.
        other = starting_case() if self.begins_with_bearing else starting_bearing()
        given, usual = (document, text), (parsed(other, "the start"), other)
        (self.document, self.text), bearing = (usual, given) if self.begins_with_bearing else (given, usual)
        self.workers = Workers(workers, jobs.warm_up)
        # A drag that ends a search is not slowed by starting another process.
        self.searching = Workers(1, jobs.step_back, waiting=STRENGTH_SECONDS, eager=False)
        loader = jinja2.PackageLoader("nonhertz.web")
        self.templates = jinja2.Environment(loader=loader, autoescape=True, undefined=jinja2.StrictUndefined)
        self.templates.globals["us"] = Markup(in_script(dict(US.table)))
        self.files = _static_files()
        self.bearings = BearingPage(*bearing, workers, self.templates)

    def start(self, tasks: TaskGroup) -> None:
        """Start the processes: now those of what the page begins with, others when their page is opened."""
        self.workers.start(tasks, at_once=not self.begins_with_bearing)
        self.searching.start(tasks, at_once=False)
        self.bearings.start(tasks, at_once=self.begins_with_bearing)

    def end(self) -> None:
        """Kill all processes."""
        self.workers.end()
        self.searching.end()
        self.bearings.end()

    async def page(self, request: Request) -> Response:
        """Answer with the page."""
        self.workers.wake()
        return HTMLResponse(page_text(self.templates, "case", self.document, self.text, TEMPLATES))

    async def form(self, request: Request) -> Response:
        """Answer with the form of a document."""
        return await form_answer(request, self.templates, "case")

    async def solve(self, request: Request) -> Response:
        """Answer with the solution of a document, or with what is wrong with it."""
        asked = await self._asked(request)
        document, stress, body = document_in(asked), asked.get("stress", False), _body_in(asked)
        if not isinstance(stress, bool):
            raise RefusedError(400, "stress must be true or false.")
        if await request.is_disconnected():
            return Response(status_code=204)
        text = await self.workers.run(jobs.solve, document, stress, body, seconds=LIVE_SECONDS)
        return Response(text, media_type="application/json")

    async def strength(self, request: Request) -> Response:
        """Answer with whether a body of a document bears it; the search takes seconds."""
        asked = await self._asked(request)
        document, body = document_in(asked), _body_in(asked)
        return await while_awaited(
            request, self.searching, jobs.strength, document, body, seconds=STRENGTH_SECONDS, too_slow=_LONG_SEARCH
        )

    async def curve(self, request: Request) -> Response:
        """Answer with points of a curve over one value of a document."""
        asked = await self._asked(request)
        document, path, values = document_in(asked), asked.get("path"), asked.get("values")
        if not isinstance(path, str) or not isinstance(values, list) or not 1 <= len(values) <= CURVE_POINTS:
            raise RefusedError(400, f"path must be text, and values a list of 1 to {CURVE_POINTS} numbers.")
        if not all(type(each) in {int, float} and is_number(each) for each in values):
            raise RefusedError(400, "values must be finite numbers.")
        if await request.is_disconnected():
            return Response(status_code=204)
        text = await self.workers.run(curve, document, path, values, seconds=LIVE_SECONDS)
        return Response(text, media_type="application/json")

    async def template(self, request: Request) -> Response:
        """Answer with the document of a template, and its text."""
        name = request.path_params["name"]
        if name not in TEMPLATES:
            raise HTTPException(404)
        text = starting_case(name)
        return reply({"ok": True, "document": parsed(text, name), "text": text})

    async def open(self, request: Request) -> Response:
        """Answer with the document parsed from the text of a case file."""
        content_of_file = await content(request, "application/toml", DOCUMENT_BYTES)
        text = await self.workers.run(jobs.document_in, content_of_file, seconds=LIVE_SECONDS)
        return Response(text, media_type="application/json")

    async def download(self, request: Request) -> Response:
        """Answer with a file made from a document."""
        name = request.path_params["name"]
        if name not in _DOWNLOADS:
            raise HTTPException(404)
        asked = await self._asked(request)
        document, text = document_in(asked), text_in(asked)
        if name == "report.html":
            made = await self.workers.run_apart(jobs.report, document, seconds=PATIENT_SECONDS)
        elif name == "case.toml":
            made = await self.workers.run(jobs.file, document, text, seconds=LIVE_SECONDS)
        else:
            made = await self.workers.run(
                jobs.table if name == "table.csv" else jobs.result, document, seconds=LIVE_SECONDS
            )
        if isinstance(made, dict):
            return reply(made, 422)
        return Response(made, headers=as_attachment(name, document), media_type=_DOWNLOADS[name])

    async def upload(self, request: Request) -> Response:
        """Answer with the profile prepared from a measured file."""
        file = await content(request, "application/octet-stream", UPLOAD_BYTES)
        options = dict(request.query_params)
        name = options.pop("name", "")[:200] or "the file"
        try:
            text = await self.workers.run(jobs.upload, file, name, options, seconds=UPLOAD_SECONDS)
        except TooSlowError:
            return reply(broken([("upload", _LONG_FILE)]))
        return Response(text, media_type="application/json")

    async def status(self, request: Request) -> Response:
        """Answer whether the solver is ready or still being compiled."""
        return reply({"ready": self.workers.ready.is_set()})

    async def static(self, request: Request) -> Response:
        """Answer with one of the page's own files."""
        found = self.files.get(request.path_params["name"])
        if found is None:
            raise HTTPException(404)
        content, media_type = found
        return Response(content, media_type=media_type, headers={"Cache-Control": "no-cache"})

    async def _asked(self, request: Request) -> dict[str, Any]:
        return json_object(await content(request, "application/json", DOCUMENT_BYTES))

    def routes(self) -> list[Route]:
        """Return all routes."""
        return [
            Route("/", self.bearings.page if self.begins_with_bearing else self.page),
            Route("/contact", self.page),
            Route("/status", self.status),
            Route("/static/{name:path}", self.static),
            Route("/form", self.form, methods=["POST"]),
            Route("/solve", self.solve, methods=["POST"]),
            Route("/strength", self.strength, methods=["POST"]),
            Route("/curve", self.curve, methods=["POST"]),
            Route("/template/{name}", self.template),
            Route("/open", self.open, methods=["POST"]),
            Route("/upload", self.upload, methods=["POST"]),
            Route("/download/{name}", self.download, methods=["POST"]),
            *self.bearings.routes(),
        ]


def application(document: dict[str, Any], port: int, workers: int = 2, text: str = "") -> Guard:
    """Return the page as an ASGI application.

    Parameters
    ----------
    document : dict
        The case or the bearing that it starts with.
    port : int
        The port it is served on; requests for another address are refused.
    workers : int
        Number of processes that solve.
    text : str
        The file that this was read from, for its comments.
    """
    page = Page(document, workers, text)

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        async with anyio.create_task_group() as tasks:
            page.start(tasks)
            try:
                yield
            finally:
                tasks.cancel_scope.cancel()
                page.end()

    app = Starlette(
        routes=page.routes(),
        lifespan=lifespan,
        exception_handlers={
            RefusedError: _refused,
            HTTPException: _unrouted,
            TooSlowError: _too_slow,
            EndedError: _ended,
            FailedError: _failed,
            Exception: _failed,
        },
    )
    app.router.redirect_slashes = False
    # Wraps everything, including the handler of our own errors.
    return Guard(InUnits(app), port)


def _body_in(asked: dict[str, Any]) -> BodyName:
    """Return which body a request is about."""
    body = asked.get("body", "a")
    if not isinstance(body, str) or body not in BODIES:
        raise RefusedError(400, "body must be 'a' or 'b'.")
    return body


def _static_files() -> dict[str, tuple[bytes, str]]:
    """Return the page's static files by name; no other file is ever sent."""
    found: dict[str, tuple[bytes, str]] = {}

    def gather(folder: Any, within: str) -> None:
        for entry in folder.iterdir():
            if entry.is_dir():
                gather(entry, f"{within}{entry.name}/")
                continue
            ending = entry.name[entry.name.rfind(".") :]
            if ending in _TYPES:
                found[within + entry.name] = entry.read_bytes(), _TYPES[ending]

    folder = resources.files("nonhertz.web").joinpath("static")
    if folder.is_dir():
        gather(folder, "")
    return found


async def _refused(request: Request, error: Exception) -> Response:
    assert isinstance(error, RefusedError)
    return refusal(error.status, error.sentence)


async def _unrouted(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    return refusal(error.status_code, _SENTENCES.get(error.status_code, "The request cannot be answered."))


async def _too_slow(request: Request, error: Exception) -> Response:
    return reply(broken([("", "This case takes longer than the page waits: solve it with the command line.")]))


async def _ended(request: Request, error: Exception) -> Response:
    # Another process is being started: the case is not at fault, and the page asks again.
    return refusal(503, "The process that was solving this case was killed by the system: try again.")


async def _failed(request: Request, error: Exception) -> Response:
    what = str(error).replace("\n", " ").rstrip(".")[:300]
    sentence = f"This is an error in nonhertz ({what}): please report it together with your case file."
    return reply(broken([("", sentence)]) | {"internal": True}, 500)
