"""Answers in the units that whoever reads the page has chosen."""

from __future__ import annotations

from typing import Final

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Receive, Scope, Send

from nonhertz.amounts import SI, SYSTEMS, read_in
from nonhertz.web.view.replies import refusal

HEADER: Final = "nonhertz-units"
"""Of a request: the code of the units, SI where it is missing."""


class InUnits:
    """Answers every request in its units: each of them has a context of its own.

    Parameters
    ----------
    app : ASGI application
        Answers them.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        code = Headers(scope=scope).get(HEADER, SI.code)
        if code not in SYSTEMS:
            known = " or ".join(map(repr, SYSTEMS))
            await refusal(400, f"The units must be {known}.")(scope, receive, send)
            return
        with read_in(code):
            await self.app(scope, receive, send)
