"""The page's server under random edits and hostile requests: never an error of its own, never late, no memory lost."""

from __future__ import annotations

import contextlib
import copy
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
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest
from case_texts import is_sentence
from extent import extent
from page_requests import PATHS, Requests

from nonhertz.files.casefile import starting_case
from nonhertz.web.form.fields import FormField
from nonhertz.web.form.form import form
from nonhertz.web.limits import ANSWER_SECONDS
from nonhertz.web.server.units import HEADER

EDITS, HOSTILE, CHANGED = extent(2_000, 300), 200, extent(10_000, 1_000)
SLOWEST = ANSWER_SECONDS + 1.0
"""s, for any answer: a case is given up at its time limit."""
MEMORY = 500.0
"""MB, of any process."""
GROWTH, SHARE = 20.0, 0.05
"""MB, or share, that memory may grow by over the second half."""
STARTING = tomllib.loads(starting_case())

NONSENSE = [
    "",
    "x",
    "20 kg",
    "-",
    "1e",
    "nan",
    "inf",
    "0x10",
    "9**9**9 mm",
    "1 mm mm",
    "\u0000",
    "ü",
    "'",
    "20,5",
    "1e999 mm",
]
NONSENSE += [True, [], [[]], {}, {"a": 1}, [1, "2 mm"], {"kind": "crown"}, "a" * 5000, [0.0] * 2000, -0.0, 0]
MAGNITUDES = [1e-300, 1e-30, 1e-9, 1e-3, 1e3, 1e9, 1e30, 1e300]
READ_IN: list[dict[str, str]] = [{}, {HEADER: "us"}, {HEADER: "imperial"}]
UNITS = {"mm": ["um", "cm", "in"], "N": ["kN", "lbf"], "MPa": ["GPa", "psi"], "rad": ["mrad", "deg"], "N mm": ["N m"]}


@pytest.fixture(scope="module")
def server() -> Iterator[tuple[int, int]]:
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


class Walk:
    """A walk over the fields of a form, one random change after the other; most mistakes are taken back."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.document: dict[str, Any] = copy.deepcopy(STARTING)
        self.sound = copy.deepcopy(STARTING)

    def back(self) -> None:
        """Take back what was mistaken, as a person would, though not at once every time."""
        if self.random.random() < 0.6:
            self.document = copy.deepcopy(self.sound)

    def step(self) -> dict[str, Any]:
        """Return the document with one more change."""
        picked = self.random
        if picked.random() < 0.08:
            self.document = copy.deepcopy(STARTING)
        before = copy.deepcopy(self.document)
        try:
            picked.choices([self.number, self.nonsense, self.structure, self.several], [6, 2, 3, 1])[0]()
        except (KeyError, IndexError, TypeError):
            self.document = before  # on a way that is none any more
        if len(json.dumps(self.document)) > 200_000:
            self.document = copy.deepcopy(STARTING)
        return self.document

    def fields(self) -> list[FormField]:
        return [field for field in form(self.document).fields if field.path]

    def number(self) -> None:
        """Move a slider, to a magnitude that no slider has now and then, or write a unit."""
        field = self.random.choice([field for field in self.fields() if field.slider])
        moves = field.slider.range
        share = self.random.random()
        value = moves.low + share * (moves.high - moves.low)
        if moves.scale == "log":
            value = moves.low * (moves.high / moves.low) ** share
        if self.random.random() < 0.15:
            value *= self.random.choice([-1.0, 1.0]) * self.random.choice(MAGNITUDES)
        units = UNITS.get(field.unit, [])
        self.set(field.path, f"{value!r} {self.random.choice(units)}" if units and share < 0.2 else value)

    def nonsense(self) -> None:
        self.set(self.random.choice(self.fields()).path, copy.deepcopy(self.random.choice(NONSENSE)))

    def several(self) -> None:
        for _ in range(5):
            self.number()

    def structure(self) -> None:
        """Take a choice, add a profile or a row, or take something away."""
        groups = [form(self.document)]
        for group in groups:
            groups += [member for member in (*group.members, *group.folded) if not isinstance(member, FormField)]
        choices = [(group.path, option) for group in groups for option in group.additions]
        options = [option for field in form(self.document).fields for option in field.options if option.edits]
        match self.random.randrange(4):
            case 0 if choices:
                path, option = self.random.choice(choices)
                self.set(path, [*(self.get(path) or []), copy.deepcopy(option.edits[0][1])])
            case 1 if options:
                for path, value in self.random.choice(options).edits:
                    self.set(path, copy.deepcopy(value))
            case 2:
                self.set(self.random.choice(self.fields()).path, None)
            case _:
                self.set(self.random.choice([group.path for group in groups if group.path]), None)

    def get(self, path: str) -> Any:
        table = self.document
        for part in parts_of(path):
            table = table[part] if isinstance(part, int) else table.get(part)
            if table is None:
                return None
        return table

    def set(self, path: str, value: Any) -> None:
        *way, last = parts_of(path)
        table: Any = self.document
        for part in way:
            table = table.setdefault(part, {}) if isinstance(part, str) else table[part]
        if value is None:
            if isinstance(table, list) or last in table:
                del table[last]
        else:
            table[last] = value


def parts_of(path: str) -> list[str | int]:
    return [int(position) - 1 if position else key for key, position in re.findall(r"([\w-]+)|\[(\d+)\]", path)]


def test_random_edits(server, capsys):
    port, pid = server
    walk, outcomes, times, memory = Walk(2026), Counter[str](), [], []
    with httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=2.0 * SLOWEST) as client:
        meet_new_shapes(client)
        for number in range(EDITS):
            document = walk.step()
            path = "/form" if number % 10 == 0 else "/solve"
            asked = {"document": document} | (
                {"stress": number % 3 != 0, "body": "ab"[number % 2]} if path == "/solve" else {}
            )
            begun = time.perf_counter()
            response = client.post(path, json=asked, headers=READ_IN[number // 6 % 2])
            times.append(time.perf_counter() - begun)
            outcome = outcome_of(path, response)
            assert response.status_code in {200, 422, 503}, (number, response.text, document)
            assert "internal" not in outcome, (number, outcome, document)
            assert times[-1] < SLOWEST, (number, times[-1], document)
            outcomes[outcome] += 1
            if outcome == "solved":
                walk.sound = copy.deepcopy(document)
            elif path == "/solve":
                walk.back()
            if (number + 1) % (EDITS // 20) == 0:
                memory.append(memory_of(pid))
    # The most of either half: memory falls where a process that took too long is ended, and rises as the next begins.
    first, second = max(memory[: len(memory) // 2]), max(memory[len(memory) // 2 :])
    with capsys.disabled():
        print(f"\n{EDITS} edits: {dict(outcomes)}")
        print(f"median {1e3 * sorted(times)[EDITS // 2]:.0f} ms, longest {1e3 * max(times):.0f} ms")
        print(f"memory {memory[0]:.0f} MB, {first:.0f} MB at most in the first half, {second:.0f} MB in the second")
    assert outcomes["solved"] > EDITS // 10
    assert outcomes["mistaken"] > EDITS // 10
    assert second - first < max(GROWTH, SHARE * first)


def meet_new_shapes(client: httpx.Client) -> None:
    """Let every process solve a roller of a shape of its own, for which it takes memory that it keeps from then on."""
    for round_ in range(3):
        documents = [copy.deepcopy(STARTING) for _ in range(2)]
        for number, document in enumerate(documents):
            document["body"]["a"]["length"] = 19.0 + 0.1 * (2 * round_ + number)
        with ThreadPoolExecutor(len(documents)) as beside:
            asked = [beside.submit(client.post, "/solve", json={"document": each}) for each in documents]
        assert all(each.result().json()["ok"] for each in asked)


def outcome_of(path: str, response: httpx.Response) -> str:
    if path == "/form":
        return "form" if response.status_code == 200 else "form refused"
    body = response.json()
    if body.get("internal") or response.status_code == 500:
        return f"internal: {response.text}"
    if response.status_code == 503:
        return "busy"
    if not body["ok"]:
        assert all(mistake["sentence"].endswith(".") for mistake in body["mistakes"])
        return "too slow" if "takes longer" in body["mistakes"][0]["sentence"] else "mistaken"
    return "unconverged" if body["complaint"] else "solved"


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
    assert memory_of(pid) - before < 2 * GROWTH


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
            if (number + 1) % (EDITS // 20) == 0:
                memory = max(memory, largest_of(pid))
    with capsys.disabled():
        print(f"\n{CHANGED} changed requests: {dict(sorted(outcomes.items()))}")
        print(f"longest {1e3 * max(times):.0f} ms, largest process {memory:.0f} MB")
    for path in PATHS:
        assert outcomes[f"{path} 200"] > 0
    assert memory < MEMORY


def sentences_in(path: str, answer: httpx.Response) -> list[str]:
    """Return what an answer says is wrong; its body must be what the path answers with."""
    if answer.status_code == 200 and (path == "/form" or path.startswith("/download/")):
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
