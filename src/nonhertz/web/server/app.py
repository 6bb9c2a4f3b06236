"""The pages as one application: their routes, files, and what is answered where something goes wrong."""

from __future__ import annotations

import contextlib
from collections.abc import AsyncIterator
from functools import partial
from importlib import resources
from typing import Any, Final

import anyio
import jinja2
from anyio.abc import TaskGroup
from markupsafe import Markup
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from nonhertz.amounts import US
from nonhertz.files.held import meant_as, parsed
from nonhertz.web.limits import ANSWER_SECONDS, DOCUMENT_BYTES, UPLOAD_BYTES
from nonhertz.web.server.guard import Guard
from nonhertz.web.server.intake import RefusedError, content, in_script
from nonhertz.web.server.pages import Page, while_awaited
from nonhertz.web.server.questions import BEARING, CONTACT
from nonhertz.web.server.units import InUnits
from nonhertz.web.server.workers import EndedError, FailedError
from nonhertz.web.view.jobs import document_in
from nonhertz.web.view.replies import broken, refusal, reply
from nonhertz.web.view.uploads import answer_to_file

_TYPES: Final = {".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml", ".html": "text/html"}
_SENTENCES: Final = {
    404: "There is nothing at this address.",
    405: "This address does not accept this method.",
}


class Site:
    """Both pages, and what they share.

    Parameters
    ----------
    document : dict
        The case or the bearing to start with.
    workers : int
        Number of processes of each page that answer at once.
    text : str
        The file that it was read from, for its comments.
    """

    def __init__(self, document: dict[str, Any], workers: int, text: str = "") -> None:
        loader = jinja2.PackageLoader("nonhertz.web")
        templates = jinja2.Environment(loader=loader, autoescape=True, undefined=jinja2.StrictUndefined)
        templates.globals["us"] = Markup(in_script(dict(US.table)))
        self.first = BEARING if meant_as(document) == "bearing" else CONTACT
        self.pages = {}
        for kind in (CONTACT, BEARING):
            # The other page starts with what 'nonhertz new' writes.
            begun = text if kind is self.first else kind.template()
            given = document if kind is self.first else parsed(begun, kind.name)
            self.pages[kind.name] = Page(kind, given, begun, workers, templates)
        self.files = _static_files()

    def start(self, tasks: TaskGroup) -> None:
        """Start the processes: now those of what is begun with, others when their page is opened."""
        for page in self.pages.values():
            page.start(tasks, at_once=page.kind is self.first)

    def end(self) -> None:
        """Kill all processes."""
        for page in self.pages.values():
            page.end()

    async def open(self, request: Request) -> Response:
        """Answer with the document in a file."""
        return await self._read(request, "application/toml", DOCUMENT_BYTES, "check", document_in)

    async def upload(self, request: Request) -> Response:
        """Answer with the profile prepared from a measured file."""
        options = dict(request.query_params)
        name = options.pop("name", "")[:200] or "the file"
        return await self._read(
            request, "application/octet-stream", UPLOAD_BYTES, "profile", answer_to_file, name, options
        )

    async def _read(self, request: Request, kind: str, most: int, command: str, job: Any, *wishes: Any) -> Response:
        file = await content(request, kind, most)
        work = partial(self.pages["case"].quick.run, job, file, *wishes, seconds=ANSWER_SECONDS)
        return Response(await while_awaited(request, work, command), media_type="application/json")

    async def static(self, request: Request) -> Response:
        """Answer with one of the pages' own files."""
        found = self.files.get(request.path_params["name"])
        if found is None:
            raise HTTPException(404)
        content, media_type = found
        return Response(content, media_type=media_type, headers={"Cache-Control": "no-cache"})

    def routes(self) -> list[Route]:
        """Return all routes."""
        return [
            Route("/", self.pages[self.first.name].page),
            Route("/contact", self.pages["case"].page),
            Route("/bearing", self.pages["bearing"].page),
            Route("/static/{name:path}", self.static),
            Route("/open", self.open, methods=["POST"]),
            Route("/upload", self.upload, methods=["POST"]),
            *(route for page in self.pages.values() for route in page.routes()),
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
    site = Site(document, workers, text)

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        async with anyio.create_task_group() as tasks:
            site.start(tasks)
            try:
                yield
            finally:
                tasks.cancel_scope.cancel()
                site.end()

    app = Starlette(
        routes=site.routes(),
        lifespan=lifespan,
        exception_handlers={
            RefusedError: _refused,
            HTTPException: _unrouted,
            EndedError: _ended,
            FailedError: _failed,
            Exception: _failed,
        },
    )
    app.router.redirect_slashes = False
    # Wraps everything, including the handler of our own errors.
    return Guard(InUnits(app), port)


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


async def _ended(request: Request, error: Exception) -> Response:
    # Another process is being started: the case is not at fault, and the page asks again.
    return refusal(503, "The process that was solving this case was killed by the system: try again.")


async def _failed(request: Request, error: Exception) -> Response:
    what = str(error).replace("\n", " ").rstrip(".")[:300]
    sentence = f"This is an error in nonhertz ({what}): please report it together with your case file."
    return reply(broken([("", sentence)]) | {"internal": True}, 500)
