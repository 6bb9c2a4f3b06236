"""The page's own server, on a socket, in a thread of the test."""

import http.client
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import httpx

from nonhertz.web.server.app import application
from nonhertz.web.server.serving import HOST, open_socket, server_of


@contextmanager
def running(document: dict[str, Any], workers: int = 1, text: str = "") -> Iterator[int]:
    """Serve a page and yield its port."""
    with open_socket(0) as bound:
        port = bound.getsockname()[1]
        server = server_of(application(document, port, workers, text))
        thread = threading.Thread(target=server.run, args=([bound],))
        thread.start()
        try:
            while not server.started:
                assert thread.is_alive()
                time.sleep(0.01)
            yield port
        finally:
            server.should_exit = True
            thread.join()


def post(client: httpx.Client, path: str, **request: Any) -> httpx.Response:
    """Send a request until the page is not busy, as its script does."""
    for _ in range(600):
        response = client.post(path, **request)
        if response.status_code != 503:
            return response
        time.sleep(0.1)
    raise AssertionError(f"{path} is still answered by {response.text}")


def raw(port: int, method: str, path: str, headers: dict[str, str], body: bytes | None = None) -> tuple[int, bytes]:
    """Send a request exactly as it is given and return status and body."""
    connection = http.client.HTTPConnection(HOST, port, timeout=30)
    try:
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        for name, value in headers.items():
            connection.putheader(name, value)
        if body is not None:
            connection.putheader("content-length", str(len(body)))
        connection.endheaders(body)
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()
