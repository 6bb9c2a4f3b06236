"""The page's server under changed requests: never an error of its own, never late, no memory lost."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import httpx
import pytest
from case_texts import is_sentence
from extent import extent
from page_requests import PATHS, Requests

from nonhertz.web.limits import ANSWER_SECONDS
from nonhertz.web.server.guard import UNITS as HEADER

CHANGED = extent(10_000, 1_000)
SLOWEST = ANSWER_SECONDS + 1.0
"""s, for any answer: a case is given up at its time limit."""
MEMORY = 500.0
"""MB, of any process."""

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
        yield port, process.pid
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=20)
        assert process.returncode == 130
        assert errors == "Interrupted.\n"


def largest_of(pid: int) -> float:
    """Return the memory [MB] of the largest of a process and its children, shared pages included."""
    children = [path.read_text().split() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    largest = 0
    for each in [pid, *(int(child) for of_thread in children for child in of_thread)]:
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            text = Path(f"/proc/{each}/status").read_text()
            largest = max([largest, *(int(kB) for kB in re.findall(r"^VmHWM:\s+(\d+) kB", text, re.MULTILINE))])
    return largest / 1024


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


pytestmark = [
    pytest.mark.campaign,
    pytest.mark.skipif(not Path("/proc/self/smaps_rollup").exists(), reason="memory is read from /proc"),
    pytest.mark.skipif(os.name != "posix", reason="an interrupt is a signal"),
]
