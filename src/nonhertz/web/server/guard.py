"""Checks of requests, the units of their answers, and the headers of every answer.

The server listens on this machine only, but any page in the browser can reach it. So a request must name this server as
its host, which defeats DNS rebinding, and must not come from a page of another site.
"""

from __future__ import annotations

from typing import Final

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from nonhertz.amounts import SI, SYSTEMS, display_units
from nonhertz.web.limits import HEADER_BYTES
from nonhertz.web.view.replies import refusal

NAMES: Final = ("127.0.0.1", "localhost")
PAGES: Final = ("/", "/contact", "/bearing")
_OWN_SITES: Final = ("same-origin", "none")
_POLICY: Final = "; ".join(
    [
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "connect-src 'self'",
        "form-action 'none'",
        "base-uri 'none'",
        "frame-ancestors 'none'",
    ]
)
HEADERS: Final = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
}
UNITS: Final = "nonhertz-units"
"""Header of a request with the code of the units of its answer; SI if it is missing."""


class Guard:
    """Rejects requests that are not allowed, and adds the headers to every answer.

    Parameters
    ----------
    app : ASGI application
        Answers the accepted requests.
    port : int
        The port that the server listens on.
    """

    def __init__(self, app: ASGIApp, port: int) -> None:
        self.app = app
        self.hosts = {f"{name}:{port}" for name in NAMES} | (set(NAMES) if port == 80 else set())
        self.origins = {f"http://{host}" for host in self.hosts}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008})
            return
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        units = Headers(scope=scope).get(UNITS, SI.code)
        reason = self.reason(scope)
        app = self.app if reason is None else refusal(403, reason)
        if sum(len(name) + len(value) for name, value in scope["headers"]) > HEADER_BYTES:
            app = refusal(431, "The headers of the request are too long.")
        elif units not in SYSTEMS:
            app = refusal(400, f"The units must be {' or '.join(map(repr, SYSTEMS))}.")
        with display_units(units if units in SYSTEMS else SI.code):  # each request has a context of its own
            await app(scope, receive, _with_headers(send))

    def reason(self, scope: Scope) -> str | None:
        """Return why a request is refused; None if it is accepted."""
        headers = Headers(scope=scope)
        if headers.getlist("host") != [headers.get("host")] or headers["host"].lower() not in self.hosts:
            return "The page answers only at its own address: use the one that 'nonhertz serve' printed."
        origins = headers.getlist("origin")
        if any(origin.lower() not in self.origins for origin in origins):
            return "The page answers no requests from other pages."
        # Following a link to a page is as harmless as typing its address.
        navigates = (headers.get("sec-fetch-mode"), headers.get("sec-fetch-dest")) == ("navigate", "document")
        opens = scope["method"] == "GET" and scope["path"] in PAGES and navigates
        if not opens and any(site not in _OWN_SITES for site in headers.getlist("sec-fetch-site")):
            return "The page answers no requests from other pages."
        return None


def _with_headers(send: Send) -> Send:
    async def send_with_headers(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            # Browsers keep files of the page until they change.
            for name, value in (HEADERS | {"Cache-Control": "no-cache" if "etag" in headers else "no-store"}).items():
                headers.setdefault(name, value)
        await send(message)

    return send_with_headers
