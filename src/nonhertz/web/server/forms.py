"""What both pages are made of: their HTML around the form of a document, and that form alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import anyio
import jinja2
from markupsafe import Markup
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from nonhertz import __version__
from nonhertz.web.form.form import form
from nonhertz.web.limits import DOCUMENT_BYTES, STRIPS, UPLOAD_BYTES, oversizes
from nonhertz.web.server.documents import document_in, in_script
from nonhertz.web.server.intake import content, json_object
from nonhertz.web.view.replies import excess, reply

File = Literal["case", "bearing"]


def page_text(
    templates: jinja2.Environment, file: File, document: dict[str, Any], text: str, begin_with: Mapping[str, str]
) -> str:
    """Return the HTML of a page.

    Parameters
    ----------
    templates : jinja2.Environment
        Those of the pages.
    file : {"case", "bearing"}
        Which of the two.
    document, text
        What it starts with, and the file that this was read from.
    begin_with : mapping of str to str
        Templates to begin with, in words by their names.
    """
    limits = {"upload_bytes": UPLOAD_BYTES, "document_bytes": DOCUMENT_BYTES, "strips": STRIPS}
    start = {"document": document, "text": text, "version": __version__, "limits": limits}
    return templates.get_template(f"{file}.html").render(
        start=Markup(in_script(start)),
        version=__version__,
        title=str(document.get("title", "")),
        form=Markup(_form_text(templates, file, document)),
        templates=begin_with,
    )


async def form_answer(request: Request, templates: jinja2.Environment, file: File) -> Response:
    """Answer with the form of the document of a request."""
    document = document_in(json_object(await content(request, "application/json", DOCUMENT_BYTES)))
    too_large = oversizes(document)
    if too_large:
        return reply(excess(too_large), 422)
    return HTMLResponse(await anyio.to_thread.run_sync(_form_text, templates, file, document))


def _form_text(templates: jinja2.Environment, file: File, document: dict[str, Any]) -> str:
    return templates.get_template("form.html").render(form=form(document, file))
