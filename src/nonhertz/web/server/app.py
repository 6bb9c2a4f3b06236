"""The pages as one application: their routes, their files, and the answers to errors."""

from __future__ import annotations

import contextlib
import mimetypes
from collections.abc import AsyncIterator
from itertools import chain
from typing import Any, Final

import anyio
import jinja2
from markupsafe import Markup
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from nonhertz.amounts import US
from nonhertz.files.toml import file_kind, parse
from nonhertz.web.limits import DOCUMENT_BYTES, UPLOAD_BYTES
from nonhertz.web.server.guard import PAGES, Guard
from nonhertz.web.server.intake import in_script
from nonhertz.web.server.pages import Page
from nonhertz.web.server.questions import BEARING, CONTACT
from nonhertz.web.server.workers import EndedError, FailedError
from nonhertz.web.view.jobs import document_in
from nonhertz.web.view.replies import broken, refusal, reply
from nonhertz.web.view.uploads import answer_to_file

#: In place of HTTP's own phrases.
_SENTENCES: Final = {
    "Not Found": "There is nothing at this address.",
    "Method Not Allowed": "This address does not accept this method.",
}
# Some systems declare scripts as plain text, which no browser runs.
mimetypes.add_type("text/javascript", ".js")


def application(document: dict[str, Any], port: int, workers: int = 2, text: str = "") -> Guard:
    """Return the pages as an ASGI application.

    Parameters
    ----------
    document : dict
        The initial case or bearing.
    port : int
        The port on which it is served; requests for another address are refused.
    workers : int
        Number of processes of each page for quick answers.
    text : str
        The text of the file of ``document``, for its comments.
    """
    loader = jinja2.PackageLoader("nonhertz.web")
    templates = jinja2.Environment(loader=loader, autoescape=True, undefined=jinja2.StrictUndefined)
    templates.globals["us"] = Markup(in_script(dict(US.table)))
    first = BEARING if file_kind(document) == "bearing" else CONTACT
    pages = {}
    for kind in (CONTACT, BEARING):
        # The other page starts with what 'nonhertz new' writes.
        begun = text if kind is first else kind.template()
        pages[kind.name] = Page(kind, document if kind is first else parse(begun, kind.name), begun, workers, templates)
    contacts = pages["case"]

    async def opened(request: Request) -> Response:
        return await contacts.read(request, "application/toml", DOCUMENT_BYTES, "check", document_in)

    async def uploaded(request: Request) -> Response:
        options = dict(request.query_params)
        name = options.pop("name", "")[:200] or "the file"
        kind = "application/octet-stream"
        return await contacts.read(request, kind, UPLOAD_BYTES, "profile", answer_to_file, name, options)

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        async with anyio.create_task_group() as tasks:
            for page in pages.values():
                page.start(tasks, at_once=page.kind is first)
            try:
                yield
            finally:
                tasks.cancel_scope.cancel()
                for page in pages.values():
                    page.end()

    app = Starlette(
        routes=[
            *map(Route, PAGES, (page.page for page in (pages[first.name], *pages.values()))),
            Mount("/static", StaticFiles(packages=[("nonhertz.web", "static")])),
            Route("/open", opened, methods=["POST"]),
            Route("/upload", uploaded, methods=["POST"]),
            *chain.from_iterable(page.routes() for page in pages.values()),
        ],
        lifespan=lifespan,
        exception_handlers={
            HTTPException: _answer_refusal,
            EndedError: _answer_ended,
            FailedError: _answer_failure,
            Exception: _answer_failure,
        },
    )
    # Wraps everything, including the handler of our own errors.
    return Guard(app, port)


async def _answer_refusal(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    sentence = _SENTENCES.get(error.detail, error.detail)
    if "text/html" in request.headers.get("accept", ""):  # a typed address
        return PlainTextResponse(sentence, error.status_code)
    return refusal(error.status_code, sentence)


async def _answer_ended(request: Request, error: Exception) -> Response:
    # A new process is being started: the case is not at fault, and the page asks again.
    return refusal(503, "The process that was solving this case was killed by the system: try again.")


async def _answer_failure(request: Request, error: Exception) -> Response:
    what = str(error).replace("\n", " ").rstrip(".")[:300]
    sentence = f"This is an error in nonhertz ({what}): please report it together with your case file."
    return reply(broken([("", sentence)]) | {"internal": True}, 500)
