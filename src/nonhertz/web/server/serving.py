"""The server of the page: a socket on this machine, uvicorn, a browser."""

from __future__ import annotations

import asyncio
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable
from typing import Any, Final, NoReturn

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol, RequestResponseCycle

from nonhertz.errors import InputError
from nonhertz.web.limits import HEAD_SECONDS, HEADER_BYTES
from nonhertz.web.server.app import application
from nonhertz.web.server.guard import Guard

HOST: Final = "127.0.0.1"
CONNECTIONS: Final = 256
"""Simultaneous connections; a browser opens up to six."""


def open_socket(port: int) -> socket.socket:
    """Return a socket that listens on this machine only.

    Parameters
    ----------
    port : int
        The port; 0 for any free one.

    Raises
    ------
    InputError
        If the port number is invalid, or another program uses the port.
    """
    if not 0 <= port <= 65535:
        raise InputError("port", port, "lie between 0 and 65535", "choose another, or 0 for a free one")
    # asyncio sets TCP_NODELAY only if the protocol is given explicitly; otherwise small writes wait 40 ms for more.
    made = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if sys.platform == "win32":  # there SO_REUSEADDR would let two servers listen on one port
        made.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
    else:
        made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        made.bind((HOST, port))
        made.listen(128)
    except OSError as error:
        made.close()
        reason = (error.strerror or str(error)).lower()
        raise InputError("port", port, f"be free ({reason})", "choose another, or 0 for a free one") from None
    return made


def serve(
    document: dict[str, Any], port: int, *, browser: bool, announce: Callable[[str], None], text: str = ""
) -> NoReturn:
    """Serve the page until it is interrupted.

    Parameters
    ----------
    document : dict
        The initial case or bearing.
    port : int
        The port; 0 for any free one.
    browser : bool
        Whether to open the page in a browser.
    announce : callable
        Called with the address.
    text : str
        The text of the bearing file; empty for a single contact.

    Raises
    ------
    InputError
        If the port is not available.
    KeyboardInterrupt
        When it is interrupted.
    """
    with open_socket(port) as bound:
        number = bound.getsockname()[1]
        server = server_of(application(document, number, text=text))
        address = f"http://{HOST}:{number}/"
        announce(address)
        if browser:
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()
        server.run([bound])
        # uvicorn re-raises the signal, but a background process of a shell ignores it.
        raise KeyboardInterrupt


class PromptProtocol(H11Protocol):
    """HTTP with a time limit for the headers of the next request on a connection.

    uvicorn waits forever once their first byte has arrived; enough such connections would lock everyone else out.
    """

    _deadline: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Start waiting for the first request."""
        super().connection_made(transport)
        self._wait()

    def on_response_complete(self) -> None:
        """Start waiting for the next request."""
        super().on_response_complete()
        self._wait()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop waiting."""
        super().connection_lost(exc)
        if self._deadline is not None:
            self._deadline.cancel()

    def _wait(self) -> None:
        if self._deadline is not None:
            self._deadline.cancel()
        self._deadline = self.loop.call_later(HEAD_SECONDS, self._end, self.cycle)

    def _end(self, last: RequestResponseCycle | None) -> None:
        if self.cycle is last:
            self.transport.close()


def server_of(app: Guard) -> uvicorn.Server:
    """Return the HTTP server of the page."""
    settings = uvicorn.Config(
        app,
        http=PromptProtocol,
        ws="none",
        lifespan="on",
        log_config=None,
        # Bad requests get an answer and need not be reported on the terminal.
        log_level="error" if os.environ.get("NONHERTZ_DEBUG", "0") not in {"", "0"} else "critical",
        access_log=False,
        server_header=False,
        date_header=False,
        proxy_headers=False,
        limit_concurrency=CONNECTIONS,
        timeout_keep_alive=int(HEAD_SECONDS),
        timeout_graceful_shutdown=2,
        h11_max_incomplete_event_size=HEADER_BYTES,
    )
    return uvicorn.Server(settings)
