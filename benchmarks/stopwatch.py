"""How long a newcomer waits: clones the repository into an empty folder and times the steps of "Start in ten minutes".

    python benchmarks/stopwatch.py [OUT]

writes first-picture.md and first-picture.json into OUT, docs/benchmarks if left out. Nothing of an earlier set-up is
used but what pip keeps of downloads: how long those take depends on the line anyway.
"""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = Path("first-picture.md")
STEPS = {
    "make demo": ["make", "demo"],
    "nonhertz new roller.toml": [".venv/bin/nonhertz", "new", "roller.toml"],
    "nonhertz check roller.toml": [".venv/bin/nonhertz", "check", "roller.toml"],
    "nonhertz solve roller.toml --out out/roller": [
        ".venv/bin/nonhertz",
        "solve",
        "roller.toml",
        "--out",
        "out/roller",
    ],
    "nonhertz report roller.toml": [".venv/bin/nonhertz", "report", "roller.toml"],
}
RESULTS = {"make demo": "out/demo/pressure.svg", "nonhertz report roller.toml": "roller-report.html"}
SERVE = [".venv/bin/nonhertz", "serve", "roller.toml", "--port", "0", "--no-browser"]


def main(out: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder, "nonhertz")
        seconds = {"git clone": timed(["git", "clone", "--quiet", str(ROOT), str(clone)], Path(folder))}
        for name, command in STEPS.items():
            seconds[name] = timed(command, clone)
            assert (clone / RESULTS.get(name, "")).exists(), name
        seconds["nonhertz serve roller.toml, until it answers"] = served(clone)
    (out / PAGE.with_suffix(".json")).write_text(json.dumps(seconds, indent=2) + "\n", encoding="utf-8")
    (out / PAGE).write_text(page(seconds), encoding="utf-8")
    print(page(seconds))


def timed(command: list[str], folder: Path) -> float:
    start = time.perf_counter()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def served(clone: Path) -> float:
    """Return the time until the page and its first solution are there."""
    start = time.perf_counter()
    with subprocess.Popen(SERVE, cwd=clone, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout is not None
        try:
            address = next(found[0] for line in server.stdout if (found := re.search(r"http://\S+?:\d+", line)))
            document = starting_document(address)
            body = json.dumps({"document": document, "stress": True}).encode()
            request = urllib.request.Request(address + "/solve", body, {"Content-Type": "application/json"})
            with urllib.request.urlopen(request) as answer:
                assert json.load(answer)["ok"]
            return time.perf_counter() - start
        finally:
            server.terminate()


def starting_document(address: str) -> object:
    with urllib.request.urlopen(address) as answer:
        text = answer.read().decode()
    start = re.search(r'<script[^>]*id="start"[^>]*>(.*?)</script>', text, re.DOTALL)
    assert start is not None
    return json.loads(start[1])["document"]


def page(seconds: dict[str, float]) -> str:
    rows = "\n".join(f"| `{name}` | {shown(taken)} |" for name, taken in seconds.items())
    first = seconds["git clone"] + seconds["make demo"]
    machine = f"{os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"
    return f"""# How long a newcomer waits

The steps of [start in ten minutes](../start.md) in an empty folder, on {machine}.
`make demo` downloads all packages and compiles the core: two to four minutes on a busy machine or a slow line.

| step | takes |
|---|--:|
{rows}

From the clone to the first useful picture: {shown(first)}. Made by `python benchmarks/stopwatch.py`.
"""


def shown(seconds: float) -> str:
    if seconds < 10.0:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "benchmarks")
