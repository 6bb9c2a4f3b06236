"""The page's server under changed and hostile requests: never an error of its own, never late, no memory lost."""

import contextlib
import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import time
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import httpx
import pytest
from case_texts import is_sentence
from extent import extent
from page_requests import PATHS, Requests

from nonhertz.files.casefile import starting_case
from nonhertz.web.limits import ANSWER_SECONDS
from nonhertz.web.server.units import HEADER

HOSTILE, CHANGED = 200, extent(10_000, 1_000)
SLOWEST = ANSWER_SECONDS + 1.0
"""s, for any answer: a case is given up at its time limit."""
MEMORY = 500.0
"""MB, of any process."""
GROWTH = 40.0
"""MB that memory may grow by under hostile requests."""
STARTING = tomllib.loads(starting_case())

READ_IN: list[dict[str, str]] = [{}, {HEADER: "us"}, {HEADER: "imperial"}]


@pytest.fixture(scope="module")
def server():
    """Run the command and yield the port and the number of its process."""
    command = [sys.executable, "-m", "nonhertz", "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        port = int(re.search(r"127\.0\.0\.1:(\d+)", process.stdout.readline())[1])
        with httpx.Client(base_url=f"http://127.0.0.1:{port}") as client:
            while not client.get("/status").json()["ready"]:
                time.sleep(0.1)
            client.get("/bearing")  # whose processes start when it is opened
            while not client.get("/bearing/status").json()["ready"]:
                time.sleep(0.1)
        before = 0.0
        while (now := memory_of(process.pid)) > before + 1.0:  # until the others of its workers are ready too
            before = now
            time.sleep(5.0)
        yield port, process.pid
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=20)
        assert process.returncode == 130
        assert errors == "Interrupted.\n"


def memory_of(pid: int) -> float:
    """Return the memory [MB] of a process and its children that is theirs alone."""
    children = [path.read_text().split() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    pids = [pid, *(int(child) for of_thread in children for child in of_thread)]
    total = 0
    for each in pids:
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            text = Path(f"/proc/{each}/smaps_rollup").read_text()
            total += sum(int(kB) for kB in re.findall(r"^Private_\w+: +(\d+) kB", text, re.MULTILINE))
    return total / 1024


def largest_of(pid: int) -> float:
    """Return the memory [MB] of the largest of a process and its children, shared pages included."""
    children = [path.read_text().split() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    largest = 0
    for each in [pid, *(int(child) for of_thread in children for child in of_thread)]:
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            text = Path(f"/proc/{each}/status").read_text()
            largest = max([largest, *(int(kB) for kB in re.findall(r"^VmHWM:\s+(\d+) kB", text, re.MULTILINE))])
    return largest / 1024


def hostile(picked: random.Random, port: int) -> bytes:
    """Return the bytes of a request that means no good, or is none."""
    own = f"127.0.0.1:{port}"
    document = json.dumps({"document": STARTING})
    method = picked.choice(["GET", "POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "X" * 100])
    path = picked.choice(
        ["/", "/solve", "/form", "/open", "/upload?name=" + "a" * 3000, "/static/..%2f..%2fetc/passwd"]
    )
    path = picked.choice(
        [path, "/download/report.html/..", "//", "/%00", "/\xff", "*", "http://evil/", "/" + "a" * 9000]
    )
    path = picked.choice(
        [
            path,
            path,
            path,
            "/bearing",
            "/bearing/solve",
            "/bearing/form",
            "/bearing/download/bearing.toml",
            "/bearing/x",
        ]
    )
    host = picked.choice([own, own, own, "evil.example", f"{own}@evil", "", f"{own}\r\nHost: evil"])
    body = picked.choice(
        [
            document,
            document[: picked.randrange(len(document))],
            "[" * 50_000,
            '{"document":' * 20_000,
            '{"document": {"a": ' + "1" * 100_000 + "}}",
            '{"document": {"body": {"a": {"profile": [' + '{"kind":"crown","radius":4e3},' * 8000 + "1]}}}}",
            '{"document": {"load": {"load": "' + "9" * 100_000 + ' N"}}}',
            '{"document": {' + ",".join(f'"k{n}": {n}' for n in range(15_000)) + "}}",
            '{"document": {"title": "' + "\\u0000" * 30_000 + '"}}',
            json.dumps({"document": {"life": {"models": ["w" * 10] * 2000}}}),
            "\x00" * 1000,
            "x" * 400_000,
            '{"document": {' + ",".join(f'"k{n}": {n}' for n in [*range(15_000), 14_999]) + "}}",
            ".".join("a" * 60_000) + " = 1",
            "1 2\n" * 400_000,
        ]
    )
    body = body.encode("utf-8", "replace")
    kind = picked.choice(["application/json"] * 4 + ["text/plain", "application/toml", "application/octet-stream", "é"])
    length = picked.choice([len(body)] * 5 + [0, 3, 10**9, -1, "x"])
    headers = [f"Host: {host}", f"Content-Type: {kind}", f"Content-Length: {length}", "Connection: close"]
    headers += picked.choice(
        [[], [], ["Transfer-Encoding: chunked"], ["Origin: http://evil"], ["Expect: 100-continue"]]
    )
    headers += picked.choice([[], [], [f"{HEADER}: us"], [f"{HEADER}: \xff"], [f"{HEADER}: us"] * 2])
    headers += picked.choice([[], [], ["X: " + "y" * 50_000], ["\x00: 1"], ["Sec-Fetch-Site: cross-site"], ["a b"]])
    head = f"{method} {path} HTTP/1.1\r\n" + "\r\n".join(headers) + "\r\n\r\n"
    return head.encode("latin-1", "replace") + body


def test_hostile_requests(server, capsys):
    port, pid = server
    picked, statuses, times = random.Random(7), Counter[str](), []
    before = memory_of(pid)
    for number in range(HOSTILE):
        sent = hostile(picked, port)
        begun = time.perf_counter()
        answer = answer_to(sent, port)
        times.append(time.perf_counter() - begun)
        status = answer[9:12].decode("latin-1") if answer.startswith(b"HTTP/1.1 ") else "closed"
        statuses[status] += 1
        assert not status.startswith("5") or status in {"503", "501"}, (number, answer[:500], sent[:300])
        assert b"Traceback" not in answer
        assert b"root:" not in answer
    lines = open_connections(port, 40)
    with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=2.0 * SLOWEST) as client:
        assert client.post("/solve", json={"document": STARTING}).json()["ok"], "and then it goes on"
    for line in lines:
        line.close()
    with capsys.disabled():
        print(f"\n{HOSTILE} hostile requests: {dict(sorted(statuses.items()))}, longest {1e3 * max(times):.0f} ms")
    assert max(times) < SLOWEST
    assert memory_of(pid) - before < GROWTH


def test_changed_requests(server, capsys):
    port, pid = server
    requests, outcomes, times, memory = Requests(), Counter[str](), [], 0.0
    with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=2.0 * SLOWEST) as client:
        for number in range(CHANGED):
            sent = requests.request(number)
            begun = time.perf_counter()
            answer = client.post(
                sent.path, content=sent.content, headers={"content-type": sent.kind, **READ_IN[number % 3]}
            )
            times.append(time.perf_counter() - begun)
            path = sent.path.partition("?")[0]
            outcomes[f"{path} {answer.status_code}"] += 1
            assert answer.status_code in {200, 400, 413, 415, 422, 503}, (number, answer.text[:500])
            assert all(is_sentence(each) for each in sentences_in(path, answer)), (number, answer.text[:500])
            assert times[-1] < SLOWEST, (number, times[-1])
            if (number + 1) % (CHANGED // 20) == 0:
                memory = max(memory, largest_of(pid))
    with capsys.disabled():
        print(f"\n{CHANGED} changed requests: {dict(sorted(outcomes.items()))}")
        print(f"longest {1e3 * max(times):.0f} ms, largest process {memory:.0f} MB")
    for path in PATHS:
        assert outcomes[f"{path} 200"] > 0
    assert memory < MEMORY


def sentences_in(path: str, answer: httpx.Response) -> list[str]:
    """Return what an answer says is wrong; its body must be what the path answers with."""
    if answer.status_code == 200 and (path.endswith("/form") or "/download/" in path):
        return []
    body = answer.json()
    if body["ok"]:
        return []
    assert not body.get("internal"), answer.text
    assert body["mistakes"]
    return [mistake["sentence"] for mistake in body["mistakes"]]


def test_a_report_is_made_while_cases_are_solved(server):
    port, _ = server
    with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=120.0) as client, ThreadPoolExecutor(1) as beside:
        report = beside.submit(client.post, "/download/report.html", json={"document": STARTING})
        while not report.done():
            begun = time.perf_counter()
            answer = client.post("/solve", json={"document": STARTING, "stress": True})
            assert time.perf_counter() - begun < SLOWEST
            assert answer.json()["ok"]
    assert report.result().status_code == 200
    assert report.result().text.startswith("<!DOCTYPE html>")


def answer_to(sent: bytes, port: int) -> bytes:
    """Return what comes back; a request that never ends is ended after a second, by us."""
    with socket.create_connection(("127.0.0.1", port), timeout=1.0) as line:
        got = bytearray()
        try:
            line.sendall(sent)
            line.shutdown(socket.SHUT_WR)
            while chunk := line.recv(65536):
                got += chunk
        except OSError:
            pass
        return bytes(got)


def open_connections(port: int, count: int) -> list[socket.socket]:
    """Return connections on which a request has begun that goes on for ever."""
    lines = [socket.create_connection(("127.0.0.1", port)) for _ in range(count)]
    for line in lines:
        line.sendall(f"POST /solve HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Length: 100000\r\n".encode())
    return lines


pytestmark = [
    pytest.mark.campaign,
    pytest.mark.skipif(not Path("/proc/self/smaps_rollup").exists(), reason="memory is read from /proc"),
    pytest.mark.skipif(os.name != "posix", reason="an interrupt is a signal"),
]
