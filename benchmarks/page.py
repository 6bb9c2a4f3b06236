"""Measure how long the page waits: the median round trip of a request to solve, over HTTP, and what it is made of.

    python benchmarks/page.py

The server is the one of ``nonhertz serve``, in a process of its own, warm. Every request differs from the one before,
as a slider's do, and the next is sent when the answer is there. Leave the machine alone meanwhile.
"""

from __future__ import annotations

import copy
import json
import re
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import httpx
import numpy as np

from nonhertz.io.casefile import starting_case

REQUESTS = 200
WISHES = {"with stress": {"stress": True, "body": "a"}, "without stress": {"stress": False, "body": "a"}}


def main() -> None:
    """Measure and print."""
    print(json.dumps(measured(), indent=1))


def measured() -> dict[str, dict[str, float]]:
    """Return medians and 95th percentiles [s] of the round trip, and the median of what the worker takes of it."""
    with serving() as client:
        results = {name: round_trips(client, wish) for name, wish in WISHES.items()}
        results["form"] = forms(client)
    return results


def round_trips(client: httpx.Client, wish: dict[str, Any]) -> dict[str, float]:
    """Return how long answers to a case take whose load changes from request to request."""
    document = tomllib.loads(starting_case())
    times, inside = [], []
    for number in range(REQUESTS + 1):
        document = copy.deepcopy(document)
        document["load"]["load"] = 15000.0 + 50.0 * number
        begun = time.perf_counter()
        found = client.post("/solve", json={"document": document} | wish).raise_for_status().json()
        times.append(time.perf_counter() - begun)
        inside.append(1e-3 * found["ms"])
        assert found["ok"]
    # The first one opens the connection.
    return summary(times[1:]) | {"in the worker": float(np.median(inside[1:]))}


def forms(client: httpx.Client) -> dict[str, float]:
    """Return how long a form takes to be made anew."""
    document = tomllib.loads(starting_case())
    times = []
    for _ in range(REQUESTS):
        begun = time.perf_counter()
        client.post("/form", json={"document": document}).raise_for_status()
        times.append(time.perf_counter() - begun)
    return summary(times)


def summary(times: list[float]) -> dict[str, float]:
    """Return the median and the 95th percentile."""
    return {"median": float(np.median(times)), "95 % below": float(np.percentile(times, 95.0))}


@contextmanager
def serving() -> Iterator[httpx.Client]:
    """Run the command and yield what talks to it once both of its workers are warm."""
    command = [sys.executable, "-m", "nonhertz", "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            address = re.search(r"http://\S+/", process.stdout.readline())
            assert address is not None
            with httpx.Client(base_url=address[0], timeout=300.0) as client:
                while not client.get("/status").raise_for_status().json()["ready"]:
                    time.sleep(0.1)
                time.sleep(5.0)  # the second worker warms up after the first
                yield client
        finally:
            process.send_signal(signal.SIGINT)


if __name__ == "__main__":
    main()
