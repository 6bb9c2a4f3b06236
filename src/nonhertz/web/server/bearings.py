"""HTTP routes of the bearing page.

A bearing is solved by slices while a slider is dragged, and by strips when it rests. Strips take seconds: they have a
process of their own, which is killed and replaced when the browser no longer waits for its answer.
"""

from __future__ import annotations

from typing import Any, Final

import jinja2
from anyio.abc import TaskGroup
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from nonhertz.bearing.frames import RINGS
from nonhertz.files.bearingfile import BEARING_TEMPLATES, starting_bearing
from nonhertz.files.held import parsed
from nonhertz.web.limits import DOCUMENT_BYTES, LIVE_SECONDS, PATIENT_SECONDS, STRIPS_SECONDS
from nonhertz.web.server.awaiting import while_awaited
from nonhertz.web.server.documents import as_attachment, document_in, text_in
from nonhertz.web.server.forms import form_answer, page_text
from nonhertz.web.server.intake import RefusedError, content, json_object
from nonhertz.web.server.workers import Workers
from nonhertz.web.view import bearing_jobs, jobs
from nonhertz.web.view.replies import reply

OWN: Final = {"bearing.toml": "application/toml", "report.html": "text/html"}
TABLES: Final = {"result.json": "application/json", "rollers.csv": "text/csv", "lines.csv": "text/csv"}
FIGURES: Final = ("loads", "pressure", "roller", "displacement")
KINDS: Final = {"svg": "image/svg+xml", "png": "image/png"}
_TOO_LONG = "By strips this bearing takes longer than the page waits: use 'nonhertz bearing' on the command line."


class BearingPage:
    """The routes of bearings.

    Parameters
    ----------
    document : dict
        The bearing to start with.
    text : str
        The file that it was read from.
    workers : int
        Number of processes that solve by slices.
    templates : jinja2.Environment
        Those of the page.
    """

    def __init__(self, document: dict[str, Any], text: str, workers: int, templates: jinja2.Environment) -> None:
        self.document, self.text = document, text
        self.workers = Workers(workers, bearing_jobs.warm_up)
        self.patient = Workers(min(workers, 1), bearing_jobs.warm_up, waiting=STRIPS_SECONDS)
        self.templates = templates

    def start(self, tasks: TaskGroup, *, at_once: bool) -> None:
        """Start the processes, at once or when the page is opened."""
        self.workers.start(tasks, at_once=at_once)
        self.patient.start(tasks, at_once=at_once)

    def end(self) -> None:
        """Kill all processes."""
        self.workers.end()
        self.patient.end()

    async def page(self, request: Request) -> Response:
        """Answer with the page."""
        self.workers.wake()
        self.patient.wake()
        text = page_text(self.templates, "bearing", self.document, self.text, BEARING_TEMPLATES)
        return HTMLResponse(text)

    async def form(self, request: Request) -> Response:
        """Answer with the form of a document."""
        return await form_answer(request, self.templates, "bearing")

    async def solve(self, request: Request) -> Response:
        """Answer with a loaded bearing, or with what is wrong with it."""
        asked = json_object(await content(request, "application/json", DOCUMENT_BYTES))
        method = asked.get("method")
        if not (method is None or method == "slices" or method == "strips"):  # noqa: PLR1714  (a list is in no set)
            raise RefusedError(400, "method must be 'slices' or 'strips', or be left out.")
        document = document_in(asked)
        if await request.is_disconnected():
            return Response(status_code=204)
        if method == "slices":
            text = await self.workers.run(bearing_jobs.solve, document, method, seconds=LIVE_SECONDS)
            return Response(text, media_type="application/json")
        return await while_awaited(
            request, self.patient, bearing_jobs.solve, document, method, seconds=STRIPS_SECONDS, too_slow=_TOO_LONG
        )

    async def contact(self, request: Request) -> Response:
        """Answer with the case of one contact of a bearing."""
        asked = json_object(await content(request, "application/json", DOCUMENT_BYTES))
        document, roller, ring = document_in(asked), asked.get("roller"), asked.get("ring")
        if type(roller) is not int or not isinstance(ring, str) or ring not in RINGS:
            raise RefusedError(400, "roller must be a whole number, and ring 'inner' or 'outer'.")
        # In the process that has solved it by strips already.
        return await while_awaited(
            request,
            self.patient,
            bearing_jobs.contact,
            *(document, roller, ring),
            seconds=STRIPS_SECONDS,
            too_slow=_TOO_LONG,
        )

    async def template(self, request: Request) -> Response:
        """Answer with the document of a template, and its text."""
        name = request.path_params["name"]
        if name not in BEARING_TEMPLATES:
            raise HTTPException(404)
        text = starting_bearing(name)
        return reply({"ok": True, "document": parsed(text, name), "text": text})

    async def download(self, request: Request) -> Response:
        """Answer with a file made from a document."""
        name = request.path_params["name"]
        stem, _, ending = name.partition(".")
        drawn = stem in FIGURES and ending in KINDS
        if name not in OWN and name not in TABLES and not drawn:
            raise HTTPException(404)
        asked = json_object(await content(request, "application/json", DOCUMENT_BYTES))
        document, text = document_in(asked), text_in(asked)
        made: bytes | dict[str, Any]
        if name == "bearing.toml":
            kind, suffix = OWN[name], ""
            made = await self.workers.run(jobs.file, document, text, seconds=LIVE_SECONDS)
        elif name == "report.html":
            kind, suffix = OWN[name], ""
            made = await self.workers.run_apart(bearing_jobs.report, document, seconds=PATIENT_SECONDS)
        elif drawn:
            kind, suffix = KINDS[ending], f"-{stem}"
            made = await self.workers.run_apart(bearing_jobs.drawn, document, stem, ending, seconds=PATIENT_SECONDS)
        else:
            kind, suffix = TABLES[name], f"-{stem}"
            made = await self.workers.run_apart(bearing_jobs.table, document, name, seconds=PATIENT_SECONDS)
        if isinstance(made, dict):
            return reply(made, 422)
        return Response(made, headers=as_attachment(name, document, suffix), media_type=kind)

    async def status(self, request: Request) -> Response:
        """Answer whether the solver is ready or still being compiled."""
        return reply({"ready": self.workers.ready.is_set()})

    def routes(self) -> list[Route]:
        """Return the routes of bearings."""
        return [
            Route("/bearing", self.page),
            Route("/bearing/status", self.status),
            Route("/bearing/form", self.form, methods=["POST"]),
            Route("/bearing/solve", self.solve, methods=["POST"]),
            Route("/bearing/contact", self.contact, methods=["POST"]),
            Route("/bearing/template/{name}", self.template),
            Route("/bearing/download/{name}", self.download, methods=["POST"]),
        ]
